//! What a running model of a scene's mechanism is given.

use crate::kernel::group::One;
use crate::luffing::double_link::geometry::{Choice, Jib};
use crate::luffing::double_link::scene::Luffing;
use crate::luffing::double_link::stages::Given;
use crate::luffing::double_link::symbols as s;

/// What the scene gives.
#[must_use]
pub fn given(luffing: &Luffing) -> Given<f64> {
    let p = &luffing.parameters;
    Given {
        theta: One(p.driven.coordinate(), luffing.motion.from),
        omega: One(p.driven.rate(), luffing.motion.speed),
        load: luffing.q.map(|q| One(&s::Q, q)),
        lengths: p.lengths,
        jib: match p.jib {
            Jib::Sag(x) => One(&s::X_7, x),
            Jib::Angle(x) => One(&s::BETA_0, x),
            Jib::Axis(x) => One(&s::AC, x),
        },
        weights: p.weights,
        anchors: p.anchors,
        cylinder: p.cylinder,
        balance: p.balance,
        choice: Choice {
            driven: p.driven,
            branch: p.branch,
            range: luffing.motion,
            pins: luffing.has_pins(),
        },
    }
}
