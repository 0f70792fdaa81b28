//! Independent ways to what the corners bear.

use std::f64::consts::TAU;

use crate::component::governing::most;
use crate::component::outline::{Greatest, Most};
use crate::component::sheet::Check;
use crate::component::standing::Standing;
use crate::component::telling::{fine, numbered, sample};
use crate::kernel::symbol::Symbol;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;
use crate::parts::springs::{PlacedWeight, SpringNames, Springs, bearing};
use crate::supports::plan::unbalanced;
use crate::supports::portal::circle::hinged_peak;
use crate::supports::portal::corners::CORNERS;
use crate::supports::portal::symbols as s;

/// Of a body on four springs nothing is told.
static NAMES: SpringNames = SpringNames {
    count: &s::N_W,
    mean: [&s::A, &s::B],
    sums: [&s::A_W; 3],
    eccentric: [&s::A, &s::B],
    apart: [&s::A, &s::B],
    tilt: None,
};

/// The corners of base and gauge (m).
#[must_use]
pub fn places([a, b]: [f64; 2]) -> [Point<f64>; 4] {
    let half = |width: f64, positive: bool| if positive { width / 2.0 } else { -width / 2.0 };
    CORNERS.map(|corner| Point::new(half(a, corner.front), half(b, corner.left)))
}

/// PortalCorner loads against weight and moments, of the rigid portal against a rigid body on equal springs, and the greatest of
/// the full circle in closed form, where the working range is one, against those that are looked for.
pub fn agreements(model: &mut Standing, base: [f64; 2], motion: &Motion) -> Vec<Check> {
    let places = places(base);
    let (mut balance, mut springs) = ([0.0_f64; 2], 0.0_f64);
    for at in fine(motion) {
        let row = sample(model, &[&s::V, &s::M_X, &s::M_Y], std::iter::once(at)).remove(0);
        let (force, place) = (row[0], Point::new(row[2], row[1]) / row[0]);
        let [rigid, hinged] = [&s::N_R, &s::N_H].map(|symbol| numbered(model, symbol, at));
        balance[0] = balance[0].max(unbalanced(&rigid, &places, force, place));
        balance[1] = balance[1].max(unbalanced(&hinged, &places, force, place));
        if let Some(bears) = bearing(&places, &NAMES, PlacedWeight::at(force, place)) {
            let those = (0..places.len()).filter(|leg| bears >> leg & 1 == 1);
            let body = Springs::new(those.map(|leg| places[leg]), &NAMES);
            for (leg, found) in rigid.iter().enumerate() {
                let other = if bears >> leg & 1 == 1 {
                    body.carry(force, place, places[leg])
                } else {
                    0.0
                };
                springs = springs.max((found - other).abs() / force);
            }
        }
    }
    let mut checks = vec![
        Check::at_most("portal_rigid", &s::AGREEMENT, balance[0], 1e-12),
        Check::at_most("portal_hinged", &s::AGREEMENT, balance[1], 1e-12),
        Check::at_most("portal_springs", &s::AGREEMENT, springs, 1e-12),
    ];
    if motion.to - motion.from >= TAU * (1.0 - 1e-15) {
        let columns = [&s::V, &s::N_CIR, &s::N_4_CIR, &s::M_0X, &s::M_0Y, &s::M];
        let row = sample(model, &columns, std::iter::once(motion.from)).remove(0);
        let peak = hinged_peak(base, row[0], Point::new(row[3], row[4]), row[5]);
        let found = |of: &'static Symbol, end: Most| {
            most(model, &Greatest::new(of, end, of)).map_or(f64::NAN, |found| found.value)
        };
        let apart = |value: f64, other: f64| (value - other).abs() / row[0];
        let rigid = apart(row[1], found(&s::N_R, Most::Greatest)).max(apart(row[2], found(&s::N_4, Most::Least)));
        let hinged = apart(peak, found(&s::N_H, Most::Greatest));
        checks.push(Check::at_most("portal_circle", &s::AGREEMENT, rigid, 1e-12));
        checks.push(Check::at_most("portal_peak", &s::AGREEMENT, hinged, 1e-12));
    }
    checks
}
