//! A scene's steering as a running model.

use std::any::Any;

use crate::component::part::Runner;
use crate::component::standing::Standing;
use crate::kernel::variable::Fault;
use crate::steering::scene::Steering;
use crate::steering::stages::{Given, SteeredGroups};

/// What a running model of it has now.
///
/// # Panics
/// For the model of another component.
#[must_use]
pub fn present(model: &Standing) -> &Given<f64> {
    let part: &dyn Any = model.part();
    let part: &Runner<SteeredGroups, f64> = part.downcast_ref().expect("a steering");
    part.given()
}

/// # Errors
/// Never for a scene that was read by [`Scene::parse`](crate::scene::Scene::parse), which checks that the machine exists.
pub fn standing(steering: &Steering) -> Result<Standing, Fault> {
    let part = Runner::<SteeredGroups, f64>::new(steering.given.clone());
    Standing::new(Box::new(part), steering.motion, None)
}
