//! The mechanisms that there are: a line for each as scenes describe it, and one as books tell it.

use std::any::Any;
use std::collections::BTreeSet;

use crate::balance::task::Search;
use crate::component::dependencies::{dependencies as traced, recorded};
use crate::component::mechanism::{Entry, Mechanism};
use crate::component::model::Model;
use crate::component::outline::Told;
use crate::component::part::{Component, Runner};
use crate::component::standing::Standing;
use crate::kernel::schema::Key;
use crate::kernel::variable::Name;
use crate::luffing;
use crate::luffing::double_link;
use crate::luffing::double_link::scene::Luffing;
use crate::luffing::double_link::stages::DoubleLink;
use crate::luffing::rope::scene::Rope;
use crate::luffing::rope::stages::RopeBoom;
use crate::steering;
use crate::steering::scene::Steering;
use crate::steering::stages::SteeredGroups;

pub static MECHANISMS: &[Entry] = &[
    double_link::mechanism::ENTRY,
    luffing::rope::scene::ENTRY,
    steering::mechanism::ENTRY,
];

/// Tables of a scene that describe a mechanism.
pub const LUFFING: Key = Key::kinds(
    "luffing",
    &[
        (double_link::mechanism::ENTRY.kind, double_link::mechanism::ENTRY.keys),
        (luffing::rope::scene::ENTRY.kind, luffing::rope::scene::ENTRY.keys),
    ],
    "A luffing mechanism.",
);
pub const STEERING: Key = Key::table(
    "steering",
    steering::mechanism::ENTRY.keys,
    "The steering of a machine on wheels.",
)
.optional();

/// Their names.
pub fn tables() -> impl Iterator<Item = &'static str> {
    [LUFFING.name, STEERING.name].into_iter()
}

/// What books need of a mechanism.
struct Teller {
    told: for<'a> fn(&'a dyn Mechanism) -> Option<&'a dyn Told>,
    standing: fn(&Standing) -> Option<Vec<BTreeSet<Name>>>,
}

const fn teller<M: Mechanism + Told, K: Component>() -> Teller {
    Teller {
        told: |mechanism| mechanism.of::<M>().map(|mechanism| mechanism as &dyn Told),
        standing: |model| {
            let part: &dyn Any = model.part();
            part.is::<Runner<K, f64>>().then(|| traced(model, recorded::<K>))
        },
    }
}

static TELLERS: &[Teller] = &[
    teller::<Luffing, DoubleLink>(),
    teller::<Rope, RopeBoom>(),
    teller::<Steering, SteeredGroups>(),
];

/// As its book tells it.
///
/// # Panics
/// For a mechanism without a line here.
#[must_use]
pub fn told(mechanism: &dyn Mechanism) -> &dyn Told {
    let mut all = TELLERS.iter().filter_map(|teller| (teller.told)(mechanism));
    all.next().expect("every mechanism has its line")
}

/// The synthesis that a scene asks for.
#[must_use]
pub fn search(mechanism: &dyn Mechanism) -> Option<Search<'_>> {
    mechanism.of::<Luffing>()?.search()
}

/// What each variable's expression contains: inputs, parameters and [`TIME`](crate::kernel::variable::TIME).
///
/// # Panics
/// For a mechanism without a line here.
#[must_use]
pub fn dependencies(model: &Model) -> Vec<BTreeSet<Name>> {
    match model {
        Model::Standing(model) => {
            let mut all = TELLERS.iter().filter_map(|teller| (teller.standing)(model));
            all.next().expect("every mechanism has its line")
        }
        Model::Moving(moving) => {
            let moving = &**moving as &dyn Any;
            if let Some(model) = moving.downcast_ref::<double_link::moving::model::LuffingMotion>() {
                return model.dependencies();
            }
            let steering = moving.downcast_ref::<steering::moving::model::SteeringMotion>();
            steering.expect("what moves has its line").dependencies()
        }
    }
}
