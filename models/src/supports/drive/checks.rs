//! An independent way to what resists slewing.

use crate::component::sheet::Check;
use crate::component::standing::Standing;
use crate::component::telling::{fine, numbered, sample};
use crate::kernel::calc::Calc;
use crate::luffing::aboard as l;
use crate::supports::drive::scene::TurningScene;
use crate::supports::drive::symbols as s;
use crate::supports::upper::load::SupportCase;
use crate::supports::upper::symbols as u;
use crate::supports::upper::weights::{UpperArea, UpperSlope, UpperWeight};

/// What stands on the support, as the scene gives it.
pub struct StandingThere<'a> {
    pub bodies: &'a [UpperWeight<f64>],
    pub areas: &'a [UpperArea<f64>],
    pub slope: Option<UpperSlope<f64>>,
    pub cases: &'a [SupportCase<f64>],
    /// The load (N), and the reach (m) where no luffing mechanism gives it.
    pub load: f64,
    pub reach: Option<f64>,
}

/// The power of all pinions' shafts, less what is lost at the ring, against moment and speed of the crane in the case of heating:
/// their difference over that power.
pub fn through_the_gear(model: &mut Standing, turning: &TurningScene) -> Option<Check> {
    let (count, heating, z) = (turning.drive?.turned.z, turning.choice.heating, turning.mesh?.1);
    let mut apart = 0.0_f64;
    for at in fine(model.motion()).collect::<Vec<_>>() {
        let [powers, moments, speeds] = [&s::P_G, &s::M_ST, &s::OMEGA_C].map(|symbol| numbered(model, symbol, at));
        let (given, taken) = (count * powers.last()? * z, moments[heating] * speeds[heating]);
        apart = apart.max((given - taken).abs() / taken.abs().max(f64::MIN_POSITIVE));
    }
    Some(Check::at_most("turning_gear", &u::AGREEMENT, apart, 1e-12))
}

/// The moment of slope and wind against forces at their places in directions that do not slew: their difference over the sum
/// of all amounts.
pub fn about_the_axis(model: &mut Standing, turning: &TurningScene, there: &StandingThere) -> Option<Check> {
    turning.drive?;
    let down = there.slope.map_or(0.0, |slope| Calc::sin(slope.gamma));
    let mut apart = 0.0_f64;
    // A luffing mechanism is one more body.
    let (reach, luffed) = match there.reach {
        Some(reach) => (reach, None),
        None => {
            let columns = [&u::R, &l::W_1, &l::M_R1];
            let row = sample(model, &columns, std::iter::once(model.motion().from)).remove(0);
            (row[0], (row[1] > 0.0).then(|| (row[1], row[2] / row[1])))
        }
    };
    for at in fine(model.motion()).collect::<Vec<_>>() {
        let found = numbered(model, &s::M_Z, at);
        let (across, ahead) = Calc::sin_cos(at);
        for (case, found) in there.cases.iter().zip(found) {
            let load = (case.k_q * there.load, reach);
            let bodies = there.bodies.iter().map(|body| (body.g_u, body.r_u));
            let weights = bodies.chain(luffed).chain([load]);
            let weighed = weights.map(|(weight, r)| [-weight * down * (r * across), 0.0]);
            let (aside, along) = Calc::sin_cos(case.chi_w);
            let areas = there.areas.iter().zip(&turning.places);
            let blown = areas.map(|(area, place)| {
                let force = case.p_w * area.a_w;
                [
                    place.r_w * ahead * (force * aside),
                    -place.r_w * across * (force * along),
                ]
            });
            let (mut sum, mut size) = (0.0, f64::MIN_POSITIVE);
            for [one, other] in weighed.chain(blown) {
                (sum, size) = (sum + one + other, size + one.abs() + other.abs());
            }
            apart = apart.max((found - sum).abs() / size);
        }
    }
    Some(Check::at_most("turning_axis", &u::AGREEMENT, apart, 1e-12))
}
