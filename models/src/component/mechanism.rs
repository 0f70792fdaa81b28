//! What a mechanism of a scene gives to all that is made of it.

use std::any::Any;
use std::fmt;

use crate::component::model::Model;
use crate::component::outline::{Outline, Published};
use crate::component::standing::Standing;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::parts::motion::{Motion, Place};

/// A mechanism as a scene describes it, checked.
pub trait Mechanism: Any + Send + Sync {
    /// By which words and symbols know it.
    fn id(&self) -> &'static str;

    /// The running model.
    ///
    /// # Errors
    /// Never for a scene that was read by [`Scene::parse`](crate::scene::Scene::parse), which checks that the mechanism
    /// exists.
    fn model(&self) -> Result<Model, Fault>;

    /// Its equations in closed form, at the start of its working range, standing.
    fn standing(&self) -> Standing;

    /// What its book tells, and in which order.
    fn outline(&self) -> &'static Outline;

    /// Published values, as printed.
    fn published(&self) -> Option<&Published>;

    /// The working range of its coordinate.
    fn motion(&self) -> &Motion;

    /// Levels that the scene's tables allow, from cheap to deep.
    fn levels(&self) -> Vec<&'static str>;

    /// The level at which it is modelled; where that is left open, the deepest.
    fn level(&self) -> &'static str {
        self.levels().last().copied().unwrap_or_default()
    }

    /// Whether the level is left to the accuracy that the scene asks for.
    fn is_auto(&self) -> bool;

    /// Leaves out what a level does not have.
    fn set_level(&mut self, level: &str);

    /// Sets the tolerance of the level `table`, where there is one.
    fn interpolate(&mut self, _tolerance: f64) {}

    /// Sets the longest inner step (s) of a motion, where that is no variable of its model.
    fn step_by(&mut self, _step: f64) {}

    /// What a level has no use for: tables of the scene, each with some keys, or as a whole where none is named.
    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])>;

    /// Where it moves by itself.
    fn solver(&self) -> Option<Solver>;

    /// A position as a scene writes it, for the book; on failure a message and help.
    ///
    /// # Errors
    /// What is no position of this mechanism.
    fn place(&self, text: &str) -> Result<Place, (String, String)>;

    /// Whether a chapter of the book has something to say.
    fn has_chapter(&self, chapter: &str) -> bool;

    fn duplicate(&self) -> Box<dyn Mechanism>;
}

/// How a motion is solved.
#[derive(Clone, Copy, Debug)]
pub struct Solver {
    /// Longest step and tolerance, each behind the mechanism's table in which it stands.
    pub step: (&'static str, &'static Symbol),
    pub tolerance: (&'static str, &'static Symbol),
    /// Length of the longest inner step, in s.
    pub longest: f64,
    /// Whether that may be too long: explicit steps are all as long.
    pub explicit: bool,
    /// What the rates of the states, and what these with their Jacobian and its factors cost, in s, measured once: a choice
    /// by cost is the same on every machine, and only ratios matter.
    pub cost: [f64; 2],
}

impl Solver {
    /// Of explicit steps whose length (s) stands under `dynamics`, with what rates cost.
    #[must_use]
    pub fn explicit(step: &'static Symbol, longest: f64, cost: [f64; 2]) -> Solver {
        let place = ("dynamics", step);
        Solver {
            step: place,
            tolerance: place,
            longest,
            explicit: true,
            cost,
        }
    }
}

impl Clone for Box<dyn Mechanism> {
    fn clone(&self) -> Self {
        self.duplicate()
    }
}

impl fmt::Debug for dyn Mechanism {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}

impl dyn Mechanism {
    /// As what it is.
    #[must_use]
    pub fn of<T: Mechanism>(&self) -> Option<&T> {
        (self as &dyn Any).downcast_ref()
    }
}

/// Reads a checked table under the acceleration of gravity (m/s²); mistakes go to the list.
pub type Read = fn(&Values, f64, &mut Vec<Diagnostic>) -> Option<Box<dyn Mechanism>>;

/// A kind of mechanism.
#[derive(Debug)]
pub struct Entry {
    /// The scene's table that describes it.
    pub table: &'static str,
    /// Value of the table's key `kind`; the first kind of a table is that without one.
    pub kind: &'static str,
    pub keys: &'static [Key],
    pub read: Read,
}
