//! The mechanisms that there are: a line for each as scenes describe it, and one as books tell it.

use std::any::Any;
use std::collections::BTreeSet;

use crate::afloat;
use crate::afloat::scene::AfloatScene;
use crate::balance;
use crate::balance::task::Search;
use crate::bridge;
use crate::bridge::scene::BridgeScene;
use crate::component::dependencies::{dependencies as traced, recorded};
use crate::component::description::{Described, Vocabulary};
use crate::component::judged::{Judged, Sought, judged as found};
use crate::component::mechanism::{Entry, Mechanism};
use crate::component::model::Model;
use crate::component::moving::MovingComponent;
use crate::component::part::Runner;
use crate::component::peaks::Peaks;
use crate::component::sheet::{Drawing, Sheet};
use crate::component::standing::Standing;
use crate::component::telling;
use crate::drive;
use crate::hopper;
use crate::hopper::scene::HopperScene;
use crate::kernel::origin::Origins;
use crate::kernel::schema::Key;
use crate::kernel::variable::{Name, TIME};
use crate::luffing;
use crate::luffing::curved_trunk::scene::CurvedTrunk;
use crate::luffing::double_link;
use crate::luffing::double_link::scene::LuffingScene;
use crate::luffing::ellipsograph::scene::Ellipsograph;
use crate::luffing::rope::scene::Rope;
use crate::parts::motion::Place;
use crate::slewing;
use crate::slewing::scene::SlewingScene;
use crate::steering;
use crate::steering::scene::SteeringScene;
use crate::supports::column;
use crate::supports::column::scene::ColumnScene;
use crate::supports::mobile;
use crate::supports::mobile::scene::MobileScene;
use crate::supports::portal;
use crate::supports::portal::scene::PortalScene;
use crate::supports::ring;
use crate::supports::ring::scene::RingScene;
use crate::unloader;
use crate::unloader::scene::UnloaderScene;

pub static MECHANISMS: &[Entry] = &[
    double_link::sheet::ENTRY,
    luffing::rope::scene::ENTRY,
    luffing::rope::scene::COMPENSATED,
    luffing::ellipsograph::scene::ENTRY,
    luffing::curved_trunk::scene::ENTRY,
    steering::sheet::ENTRY,
    slewing::scene::ENTRY,
    mobile::scene::ENTRY,
    portal::scene::ENTRY,
    ring::scene::ENTRY,
    column::scene::ENTRY,
    hopper::scene::ENTRY,
    unloader::scene::ENTRY,
    bridge::scene::ENTRY,
    afloat::scene::ENTRY,
];

/// Tables of a scene that describe a mechanism.
pub const LUFFING: Key = Key::kinds(
    "luffing",
    &[
        (double_link::sheet::ENTRY.kind, double_link::sheet::ENTRY.keys),
        (luffing::rope::scene::ENTRY.kind, luffing::rope::scene::ENTRY.keys),
        (
            luffing::rope::scene::COMPENSATED.kind,
            luffing::rope::scene::COMPENSATED.keys,
        ),
        (
            luffing::ellipsograph::scene::ENTRY.kind,
            luffing::ellipsograph::scene::ENTRY.keys,
        ),
        (
            luffing::curved_trunk::scene::ENTRY.kind,
            luffing::curved_trunk::scene::ENTRY.keys,
        ),
    ],
    "A luffing mechanism.",
);
pub const STEERING: Key = Key::part(
    "steering",
    steering::sheet::ENTRY.keys,
    "The steering of a machine on wheels.",
);
pub const SUPPORTS: Key = Key::kinds(
    "supports",
    &[
        (mobile::scene::ENTRY.kind, mobile::scene::ENTRY.keys),
        (portal::scene::ENTRY.kind, portal::scene::ENTRY.keys),
        (ring::scene::ENTRY.kind, ring::scene::ENTRY.keys),
        (column::scene::ENTRY.kind, column::scene::ENTRY.keys),
    ],
    "What a crane stands or slews on, and what it may lift there.",
);

pub const HOPPER: Key = Key::part(
    "hopper",
    hopper::scene::KEYS,
    "The hopper of a crane, between its grab and a feeder.",
);

pub const GRAB_UNLOADER: Key = Key::part(
    "grab_unloader",
    unloader::scene::KEYS,
    "A grab unloader with a rope trolley: ropes, drums, motors, cycle.",
);

pub const TROLLEY: Key = Key::part(
    "trolley",
    bridge::scene::KEYS,
    "The trolley of a container bridge: travel, tow rope or driven wheels, four ropes, starts without sway.",
);

pub const HULL: Key = Key::part("hull", afloat::scene::KEYS, "The hull on which a crane floats.");

/// Parts of a crane that may stand beside its mechanism, at the top of the scene, as well as within it.
pub const PARTS: [Key; 5] = [
    balance::scene::BALANCE,
    drive::scene::DRIVE,
    double_link::keys::HOISTING,
    Key::part("slewing", slewing::scene::KEYS, "Slewing of a crane, or by itself."),
    luffing::resistances::scene::CASES,
];

/// Mechanisms that carry another one, which is a part of theirs where both stand in a scene.
const CARRIERS: [[&str; 2]; 2] = [[HULL.name, LUFFING.name], [SUPPORTS.name, LUFFING.name]];

/// What may stand beside a mechanism, as a part of its table.
pub fn beside(mechanism: &str) -> impl Iterator<Item = &'static str> {
    let carried = CARRIERS.into_iter().filter(move |[carrier, _]| *carrier == mechanism);
    let parts = PARTS
        .iter()
        .map(|part| part.name)
        .filter(move |part| *part != mechanism);
    parts.chain(carried.map(|[_, carried]| carried))
}

/// The scene's tables that a mechanism may stand in; what may be a part of another one comes last.
pub fn tables() -> impl Iterator<Item = &'static str> {
    let whole = [LUFFING, STEERING, SUPPORTS, HOPPER, GRAB_UNLOADER, TROLLEY, HULL];
    whole.into_iter().chain([PARTS[3]]).map(|key| key.name)
}

/// Those of these tables that describe the mechanism of a scene: a part of a crane does where it stands alone.
pub fn mechanisms(given: impl Fn(&'static str) -> bool) -> Vec<&'static str> {
    let is_part = |name: &&str| PARTS.iter().any(|part| part.name == *name);
    let (parts, whole): (Vec<_>, Vec<_>) = tables().filter(|name| given(name)).partition(is_part);
    if whole.is_empty() {
        return parts;
    }
    let carried = |name: &str| CARRIERS.iter().any(|[by, of]| *of == name && whole.contains(by));
    whole.iter().filter(|name| !carried(name)).copied().collect()
}

/// What books need of a mechanism.
struct Teller {
    id: &'static str,
    vocabulary: &'static Vocabulary,
    sheet: fn(&dyn Mechanism, &Origins, &[Place], bool) -> Option<Sheet>,
    judged: fn(&dyn Mechanism, &mut Standing, &Sought<'_>) -> Option<Judged>,
    assumptions: fn(&dyn Mechanism) -> Option<Vec<&'static str>>,
    drawing: fn(&dyn Mechanism, f64) -> Option<Drawing>,
    dependencies: fn(&Standing) -> Option<Vec<BTreeSet<Name>>>,
    followed: fn(&MovingComponent) -> Option<Vec<BTreeSet<Name>>>,
}

const fn teller<T: Described>() -> Teller {
    Teller {
        id: T::ID,
        vocabulary: T::VOCABULARY,
        sheet: |mechanism, origins, asked, runs| Some(telling::sheet::<T>(mechanism.of()?, origins, asked, runs)),
        judged: |mechanism, model, wanted| {
            let told = mechanism.of()?;
            let mut peaks = Peaks::over(model, T::aside(told));
            Some(found::<T>(told, model, &mut peaks, wanted))
        },
        assumptions: |mechanism| Some(T::assumptions(mechanism.of()?)),
        drawing: |mechanism, at| Some(T::drawing(mechanism.of()?, at)),
        dependencies: |model| is_of::<T>(model).then(|| traced(model, recorded::<T::Component>)),
        followed: |moving| is_of::<T>(moving.standing()).then(|| T::follows(moving)),
    }
}

/// Whether a model is that of a mechanism.
fn is_of<T: Described>(model: &Standing) -> bool {
    let part: &dyn Any = model.part();
    part.is::<Runner<T::Component, f64>>()
}

static TELLERS: &[Teller] = &[
    teller::<LuffingScene>(),
    teller::<Rope>(),
    teller::<Ellipsograph>(),
    teller::<CurvedTrunk>(),
    teller::<SteeringScene>(),
    teller::<SlewingScene>(),
    teller::<MobileScene>(),
    teller::<PortalScene>(),
    teller::<RingScene>(),
    teller::<ColumnScene>(),
    teller::<HopperScene>(),
    teller::<UnloaderScene>(),
    teller::<BridgeScene>(),
    teller::<AfloatScene>(),
];

/// The symbols of every mechanism, by its id.
pub fn vocabularies() -> impl Iterator<Item = (&'static str, &'static Vocabulary)> {
    TELLERS.iter().map(|teller| (teller.id, teller.vocabulary))
}

/// Symbols that several mechanisms share, with words of their own.
pub static LENT: [&Vocabulary; 2] = [&luffing::aboard::VOCABULARY, &slewing::symbols::SLIPPING];

/// What the teller of a mechanism says.
fn told<R>(mut of: impl FnMut(&Teller) -> Option<R>) -> R {
    TELLERS.iter().find_map(&mut of).expect("every mechanism has its line")
}

/// All that its book says, with the positions that the scene asks for.
///
/// # Panics
/// For a mechanism without a line here.
#[must_use]
pub fn sheet(mechanism: &dyn Mechanism, origins: &Origins, asked: &[Place], runs: bool) -> Sheet {
    told(|teller| (teller.sheet)(mechanism, origins, asked, runs))
}

/// Results of the whole range that are wanted, and those of which the scene asks something, as its book has them; `model` is
/// that of the mechanism [`standing`](Mechanism::standing).
///
/// # Panics
/// As [`sheet`].
#[must_use]
pub fn judged(mechanism: &dyn Mechanism, model: &mut Standing, wanted: &Sought<'_>) -> Judged {
    told(|teller| (teller.judged)(mechanism, model, wanted))
}

/// Ids of the sentences that say at which level it is modelled, and what its model takes for granted.
///
/// # Panics
/// As [`sheet`].
#[must_use]
pub fn assumptions(mechanism: &dyn Mechanism) -> Vec<&'static str> {
    told(|teller| (teller.assumptions)(mechanism))
}

/// What it looks like with its coordinate at a value of the working range.
///
/// # Panics
/// As [`sheet`].
#[must_use]
pub fn drawing(mechanism: &dyn Mechanism, at: f64) -> Drawing {
    told(|teller| (teller.drawing)(mechanism, at))
}

/// How a scene asks for a synthesis.
pub const ASK_FOR_SEARCH: &str = double_link::scene::ASK;

/// The synthesis that a scene asks for.
#[must_use]
pub fn search(mechanism: &dyn Mechanism) -> Option<Search<'_>> {
    double_link::scene::search(mechanism.of()?)
}

/// What each variable's expression contains: inputs, parameters and [`TIME`].
///
/// # Panics
/// For a mechanism without a line here.
#[must_use]
pub fn dependencies(model: &Model) -> Vec<BTreeSet<Name>> {
    match model {
        Model::Standing(model) => told(|teller| (teller.dependencies)(model)),
        Model::Moving(moving) => {
            let moving: &MovingComponent = (&**moving as &dyn Any)
                .downcast_ref()
                .expect("what moves is a component");
            let free = moving.freed();
            let mut found = told(|teller| (teller.followed)(&free));
            // A command over time follows from that, and so does what follows from it.
            for (index, name) in moving.told() {
                found[index].insert(name);
                for names in found.iter_mut().filter(|names| names.contains(&name)) {
                    names.remove(&name);
                    names.insert((TIME.id, None));
                }
            }
            found
        }
    }
}
