//! A scene's mechanism as a running model.

use std::any::Any;

use crate::component::part::Runner;
use crate::component::standing::Standing;
use crate::kernel::group::One;
use crate::kernel::variable::Fault;
use crate::luffing::double_link::geometry::{Choice, Jib};
use crate::luffing::double_link::scene::Luffing;
use crate::luffing::double_link::stages::{DoubleLink, Given};
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

/// What a running model of it has now.
///
/// # Panics
/// For the model of another component.
#[must_use]
pub fn present(model: &Standing) -> &Given<f64> {
    let part: &dyn Any = model.part();
    let part: &Runner<DoubleLink, f64> = part.downcast_ref().expect("a double link");
    part.given()
}

/// # Errors
/// Never for a scene that was read by [`Scene::parse`](crate::scene::Scene::parse), which checks that the mechanism
/// exists over its range.
pub fn standing(luffing: &Luffing) -> Result<Standing, Fault> {
    let part = Runner::<DoubleLink, f64>::new(given(luffing));
    Standing::new(Box::new(part), luffing.motion, luffing.table)
}
