//! The machine from above, and the triangle of a cylinder, to scale.

use crate::component::sheet::{Curve, Drawing, Shape};
use crate::component::stages::{Found, Stages};
use crate::component::telling::between;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::cylinder::{Linkage, Pose};
use crate::steering::limits::Limits;
use crate::steering::machine::Machine;
use crate::steering::stages::{Given, SteeredGroups};
use crate::steering::swept::moved;
use crate::steering::symbols as s;

/// The triangle of the cylinder straight ahead, and faint at both ends of the range. [Zhang2016, Fig. 5 and 6]
pub fn triangle((linkage, limits): (&Linkage<f64>, &Limits)) -> Drawing {
    let point = |p: Point<f64>| [p.x, p.y];
    let (o, b) = ([0.0, 0.0], point(linkage.b));
    let mut shapes = Vec::new();
    for (theta, faint) in [(limits.min, true), (limits.max, true), (0.0, false)] {
        let (sin, cos) = Calc::sin_cos(theta);
        let c = point(plane::turned(linkage.c, cos, sin));
        for points in [vec![o, c], vec![b, c]] {
            shapes.push(Shape::Body {
                points,
                closed: false,
                faint,
            });
        }
        shapes.push(Shape::Pin {
            at: c,
            fixed: false,
            faint,
        });
        if !faint {
            shapes.push(Shape::Label { at: c, text: "c" });
        }
    }
    for (at, text) in [(o, "o"), (b, "b")] {
        shapes.push(Shape::Pin {
            at,
            fixed: true,
            faint: false,
        });
        shapes.push(Shape::Label { at, text });
    }
    let size = plane::length(linkage.c);
    shapes.push(Shape::Arrow {
        from: o,
        to: [1.3 * size, 0.0],
    });
    shapes.push(Shape::Angle {
        at: o,
        radius: 0.6 * size,
        from: 0.0,
        to: f64::direction(linkage.c.x, linkage.c.y),
        text: s::ALPHA.print,
    });
    Drawing { shapes }
}

/// Length and lever arm of a cylinder over its group's range. [Zhang2016, Fig. 7]
pub fn lengths((linkage, limits): (&Linkage<f64>, &Limits)) -> [Curve; 2] {
    let curve = |id, y: &'static Symbol, of: fn(Pose<f64>) -> f64| Curve {
        id,
        x: &s::THETA,
        y,
        pieces: vec![
            between(limits.min, limits.max)
                .map(|theta| [theta, of(linkage.at_angle(theta))])
                .collect(),
        ],
        numbers: Vec::new(),
    };
    [
        curve("zhang2016_fig_7_length", &s::L_C, |pose| pose.l),
        curve("zhang2016_fig_7_arm", &s::OD, |pose| pose.od),
    ]
}

/// How the machine stands.
pub struct Stance {
    pub centre: Centre<f64>,
    /// Headings (rad) and rolling speeds (m/s).
    pub wheels: Vec<[f64; 2]>,
    pub reachable: bool,
}

impl Stance {
    /// # Errors
    /// A command that its mode does not take.
    pub fn new(given: Given<f64>) -> Found<Stance> {
        let mut known = SteeredGroups::new(given);
        let reachable = known.margin()?.reachable;
        let speeds: Vec<f64> = known.speeds()?.clone();
        let wheels = known.wheels()?.iter().zip(speeds);
        Ok(Stance {
            wheels: wheels.map(|(wheel, speed)| [wheel.theta, speed]).collect(),
            centre: *known.centre()?,
            reachable,
        })
    }
}

/// The machine from above: outline, wheels turned, axle lines to the turning centre.
pub fn plan(machine: &Machine<f64>, stance: &Stance) -> Drawing {
    let point = |p: Point<f64>| [p.x, p.y];
    let size = (machine.front - machine.rear).max(machine.left - machine.right);
    let (half, wide) = (0.05 * size, 0.02 * size);
    let mut shapes = vec![Shape::Body {
        points: machine.corners.iter().map(|p| point(*p)).collect(),
        closed: false,
        faint: true,
    }];
    if let Some(Shape::Body { points, .. }) = shapes.first_mut() {
        points.push(points[0]);
    }
    // A centre that is too far away for the paper is not drawn: the axle lines point to it.
    let centre = stance
        .centre
        .point()
        .filter(|at| plane::length(at - machine.middle) <= 1.6 * size);
    for (p, [theta, _]) in machine.groups.iter().zip(&stance.wheels) {
        let (sin, cos) = Calc::sin_cos(*theta);
        let across = Point::new(-sin, cos);
        let to = match centre {
            Some(at) => at,
            None => {
                let towards = stance.centre.point().map_or(across, |at| at - p);
                let sign = if plane::dot(across, towards) < 0.0 { -1.0 } else { 1.0 };
                p + across * (sign * 0.2 * size)
            }
        };
        shapes.push(Shape::Axis {
            from: point(*p),
            to: point(to),
        });
    }
    for (number, (p, [theta, v])) in (1..).zip(machine.groups.iter().zip(&stance.wheels)) {
        let (sin, cos) = Calc::sin_cos(*theta);
        for aside in [-1.0, 1.0] {
            let corner = |ahead: f64, out: f64| {
                point(p + plane::turned(Point::new(ahead * half, aside * wide + out * 0.7 * wide), cos, sin))
            };
            shapes.push(Shape::Body {
                points: vec![
                    corner(1.0, 1.0),
                    corner(-1.0, 1.0),
                    corner(-1.0, -1.0),
                    corner(1.0, -1.0),
                ],
                closed: true,
                faint: false,
            });
        }
        if *v != 0.0 {
            let along = Point::new(cos, sin) * v.signum();
            shapes.push(Shape::Arrow {
                from: point(p + along * half),
                to: point(p + along * (2.4 * half)),
            });
        }
        let aside = if p.y >= machine.middle.y { 1.0 } else { -1.0 };
        shapes.push(Shape::Number {
            at: [p.x - 1.6 * half, p.y + aside * 2.7 * half],
            number,
        });
    }
    if let Some(at) = centre {
        shapes.push(Shape::Pin {
            at: point(at),
            fixed: false,
            faint: false,
        });
        shapes.push(Shape::Label {
            at: point(at),
            text: "O",
        });
    }
    Drawing { shapes }
}

/// The machine from above with the paths that its corners sweep while it travels its own length.
pub fn swept(machine: &Machine<f64>, stance: &Stance) -> Drawing {
    let mut drawing = plan(machine, stance);
    let fastest = machine.groups.iter().map(|p| plane::length(stance.centre.rolling(*p)));
    let (fastest, whole) = (fastest.fold(0.0, f64::max), machine.front - machine.rear);
    for corner in &machine.corners {
        let at = |i: u32| moved(&stance.centre, fastest, *corner, whole * f64::from(i) / 24.0);
        let points = (0..=24).map(|i| [at(i).x, at(i).y]).collect();
        drawing.shapes.push(Shape::Path { points });
    }
    drawing
}
