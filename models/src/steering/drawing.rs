//! The machine from above, and the triangle of a cylinder, to scale.

use crate::component::draw::Draw;
use crate::component::extreme::greatest_value;
use crate::component::sheet::{Curve, Drawing};
use crate::component::stages::{Found, Stages};
use crate::component::telling::between;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::cylinder::{Linkage, Pose};
use crate::steering::limits::Limits;
use crate::steering::machine::Machine;
use crate::steering::mode::Mode;
use crate::steering::nearest::Nearest;
use crate::steering::stages::{Given, SteeredGroups};
use crate::steering::swept::moved;
use crate::steering::symbols as s;

/// The triangle of the cylinder straight ahead, and faint at both ends of the range. [Zhang2016, Fig. 5 and 6]
pub fn triangle((linkage, limits): (&Linkage<f64>, &Limits)) -> Drawing {
    let (o, b) = (Point::zeros(), linkage.b);
    let mut draw = Draw::default();
    for (theta, faint) in [(limits.min, true), (limits.max, true), (0.0, false)] {
        let (sin, cos) = Calc::sin_cos(theta);
        let c = plane::turned(linkage.c, cos, sin);
        draw.bar(&[o, c], faint);
        draw.bar(&[b, c], faint);
        draw.joint(c, "c", false, faint);
    }
    draw.joint(o, "o", true, false);
    draw.joint(b, "b", true, false);
    let size = plane::length(linkage.c);
    draw.arrow(o, Point::new(1.3 * size, 0.0));
    draw.angle(o, 0.6 * size, f64::direction(linkage.c.x, linkage.c.y), &s::ALPHA);
    draw.done(size)
}

/// Length and lever arm of a cylinder over its group's range. [Zhang2016, Fig. 7]
pub fn lengths((linkage, limits): (&Linkage<f64>, &Limits)) -> [Curve; 2] {
    let range = Motion {
        from: limits.min,
        to: limits.max,
        step: limits.max - limits.min,
        speed: 1.0,
        by_part: false,
        period: std::f64::consts::TAU,
    };
    let curve = |id, y: &'static Symbol, of: fn(Pose<f64>) -> f64| {
        let extremes = [1.0, -1.0].map(|sign| greatest_value(&range, &mut |at| Some(sign * of(linkage.at_angle(at)))));
        let mut places: Vec<f64> = between(range.from, range.to)
            .chain(extremes.into_iter().flatten().map(|found| found.at))
            .collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let point = |theta| [theta, of(linkage.at_angle(theta))];
        Curve {
            id,
            x: &s::THETA,
            y,
            pieces: vec![places.into_iter().map(point).collect()],
            numbers: Vec::new(),
        }
    };
    [
        curve("zhang2016_fig_7_length", &s::R, |pose| pose.l),
        curve("zhang2016_fig_7_arm", &s::OD, |pose| pose.od),
    ]
}

/// How the machine stands in a mode.
pub struct Stance {
    pub mode: Mode,
    pub centre: Centre<f64>,
    /// Headings (rad) and rolling speeds (m/s).
    pub angles: Vec<f64>,
    pub speeds: Vec<f64>,
    pub reachable: bool,
    /// The nearest command that all groups can follow, and their headings then, in rad.
    pub nearest: Nearest,
    pub nearest_angles: Vec<f64>,
}

impl Stance {
    /// # Errors
    /// A command that its mode does not take.
    pub fn new(given: Given<f64>) -> Found<Stance> {
        let mode = given.mode;
        let mut known = SteeredGroups::new(given);
        Ok(Stance {
            mode,
            centre: *known.centre()?,
            angles: known.wheels()?.iter().map(|wheel| wheel.theta).collect(),
            speeds: known.speeds()?.clone(),
            reachable: known.margin()?.reachable,
            nearest: *known.nearest()?,
            nearest_angles: known.headings()?.clone(),
        })
    }
}

/// The machine from above: outline, wheels turned, axle lines to the turning centre.
pub fn plan(machine: &Machine<f64>, stance: &Stance) -> Drawing {
    from_above(machine, stance).done(0.0)
}

fn from_above(machine: &Machine<f64>, stance: &Stance) -> Draw {
    let size = machine.extent();
    let (half, wide) = (0.05 * size, 0.02 * size);
    let mut draw = Draw::default();
    let [first, ..] = machine.corners;
    draw.bar(&[&machine.corners[..], &[first]].concat(), true);
    // A centre that is too far away for the paper is not drawn: the axle lines point to it.
    let at = stance.centre.point();
    let centre = at.filter(|at| plane::length(at - machine.middle) <= 1.6 * size);
    for (p, theta) in machine.groups.iter().zip(&stance.angles) {
        let (sin, cos) = Calc::sin_cos(*theta);
        let across = Point::new(-sin, cos);
        let towards = at.map_or(across, |at| at - p);
        let sign = if plane::dot(across, towards) < 0.0 { -1.0 } else { 1.0 };
        draw.line(*p, centre.unwrap_or(p + across * (sign * 0.2 * size)));
    }
    let wheels = machine.groups.iter().zip(&stance.angles).zip(&stance.speeds);
    for (number, ((p, theta), v)) in (1..).zip(wheels) {
        let (sin, cos) = Calc::sin_cos(*theta);
        for aside in [-1.0, 1.0] {
            let corner = |[ahead, out]: [f64; 2]| {
                p + plane::turned(Point::new(ahead * half, aside * wide + out * 0.7 * wide), cos, sin)
            };
            let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
            draw.body(&corners.map(corner), false);
        }
        if *v != 0.0 {
            let along = Point::new(cos, sin) * v.signum();
            draw.arrow(p + along * half, p + along * (2.4 * half));
        }
        let aside = if p.y >= machine.middle.y { 1.0 } else { -1.0 };
        draw.number(Point::new(p.x - 1.6 * half, p.y + aside * 2.7 * half), number);
    }
    if let Some(at) = centre {
        draw.joint(at, "O", false, false);
    }
    draw
}

/// The machine from above with the paths that its corners sweep while it travels its own length.
pub fn swept(machine: &Machine<f64>, stance: &Stance) -> Drawing {
    let mut draw = from_above(machine, stance);
    let (fastest, whole) = (stance.centre.fastest(machine), machine.front - machine.rear);
    for corner in &machine.corners {
        draw.path((0..=24).map(|i| moved(&stance.centre, fastest, *corner, whole * f64::from(i) / 24.0)));
    }
    draw.done(0.0)
}
