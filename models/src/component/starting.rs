//! What a motor gives on the way of a start over its speed, with what resists in each case.

use crate::component::sheet::Curve;
use crate::component::standing::Standing;
use crate::component::telling::numbered;
use crate::parts::motor::{N_MOT, T_0};
use crate::parts::starts::way::StartWay;
use crate::parts::starts::{N_WAY, RatedPoint, T_WAY};

/// The curve of the motor (0), and for each case that moves the torque against steady motion at a place, up to its speed; `None` where
/// the motor has no curve of its own.
pub fn start_curve(
    way: Option<&StartWay<f64>>,
    rated: &RatedPoint<f64>,
    model: &mut Standing,
    at: f64,
) -> Option<Curve> {
    let gives = way?.over_speed(rated);
    if gives.is_empty() {
        return None;
    }
    let [turns, resists] = [&N_MOT, &T_0].map(|symbol| numbered(model, symbol, at));
    let cases = (1..)
        .zip(turns.into_iter().zip(resists))
        .filter(|(_, (n, _))| *n != 0.0);
    let cases = cases.map(|(number, (n, torque))| (number, vec![[0.0, torque], [n.abs(), torque]]));
    let (numbers, pieces) = std::iter::once((0, gives)).chain(cases).unzip();
    Some(Curve {
        id: "start_torque",
        x: &N_WAY,
        y: &T_WAY,
        pieces,
        numbers,
    })
}
