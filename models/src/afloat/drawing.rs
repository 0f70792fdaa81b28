//! A floating crane as books draw it, seen from the bow.

use crate::afloat::cases::acting;
use crate::afloat::stages::{FloatingCrane, Given};
use crate::afloat::symbols as s;
use crate::component::draw::Draw;
use crate::component::sheet::Drawing;
use crate::component::stages::Stages;
use crate::kernel::calc::Calc;
use crate::parts::plane::Point;

/// The midship section with the water as it stands at a slewing angle (rad), and the bars of a crane that luffs.
pub fn drawn(given: &Given<f64>, at: f64) -> Drawing {
    let mut draw = Draw::default();
    let outline: Vec<Point<f64>> = match (&given.built, &given.offsets) {
        (Some(hull), _) => {
            let half = hull.b / 2.0;
            [[half, 0.0], [half, hull.d], [-half, hull.d], [-half, 0.0]]
                .map(|[y, z]| Point::new(y, z))
                .to_vec()
        }
        (_, Some(offsets)) => {
            let sections: Vec<_> = offsets.mesh.points.chunks(2 * offsets.half).collect();
            sections[sections.len() / 2]
                .iter()
                .map(|point| Point::new(point[1], point[2]))
                .collect()
        }
        _ => Vec::new(),
    };
    let mut size = outline.iter().map(|point| point.norm()).fold(1e-3, f64::max);
    draw.body(&outline, false);
    for space in acting(&given.flooded, &given.planned.flooded) {
        let half = space.b_f / 2.0;
        let [low, high] = [space.z_f, space.z_f + space.d_f];
        let corners = [(-half, low), (half, low), (half, high), (-half, high)];
        draw.body(&corners.map(|(y, z)| Point::new(space.y_f + y, z)), true);
    }
    let mut known = FloatingCrane::new(given.clone());
    known.psi().1 = at;
    if let Ok(posture) = known.posture() {
        let (draft, slope) = posture.midship();
        let water = |y: f64| Point::new(y, draft + y * slope);
        draw.bar(&[water(-1.4 * size), water(1.4 * size)], true);
        draw.angle(water(0.0), 1.25 * size, Calc::direction(1.0, slope), &s::PHI);
    }
    for bar in bars(given, at) {
        size = bar.iter().map(|point| point.norm()).fold(size, f64::max);
        draw.bar(&bar, false);
    }
    draw.axis(0.0, -0.15 * size, 0.6 * size);
    draw.joint(Point::new(0.0, 0.0), "O", false, false);
    draw.done(size)
}

/// Bars of the luffing mechanism as the slewing angle (rad) shows them.
fn bars(given: &Given<f64>, at: f64) -> Vec<Vec<Point<f64>>> {
    let Some(luffer) = &given.luffer else { return Vec::new() };
    let moved = given.luffing.map(|luffing| luffing.theta_1);
    let theta = moved.or(given.held.map(|held| held.1)).unwrap_or_default();
    let (aside, _) = Calc::sin_cos(at);
    let seen = |point: &Point<f64>| {
        Point::new(
            given.place.y_s + (luffer.0.offset() + point.x) * aside,
            given.height.1 + point.y,
        )
    };
    luffer
        .0
        .bars(theta)
        .iter()
        .map(|bar| bar.iter().map(seen).collect())
        .collect()
}
