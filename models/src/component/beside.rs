//! A mechanism in motion beside another one: what runs, and what the other one's book tells of it.

use std::fmt;
use std::sync::Arc;

use crate::component::description::{Described, Description};
use crate::component::judged::judged;
use crate::component::mechanism::Solver;
use crate::component::moving::MovingComponent;
use crate::component::peaks::Peaks;
use crate::component::places::worst;
use crate::component::sheet::{Section, Worked};
use crate::component::stages::Stages;
use crate::component::telling::{constants, outputs, worked};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;

/// A mechanism in motion as another one has it.
pub trait MovedBeside: fmt::Debug + Send + Sync {
    /// What runs, without what the scene tells over time.
    fn run(&self) -> Option<Result<MovingComponent, Fault>>;

    /// How that is solved.
    fn solved(&self) -> Option<Solver>;

    /// Levels at which it moves, and others that it may stand for, from cheap to deep.
    fn levels(&self) -> Vec<&'static str>;

    /// The same at one of these.
    fn at(&self, level: &str) -> Arc<dyn MovedBeside>;

    /// The same with another longest inner step (s).
    fn stepping(&self, step: f64) -> Arc<dyn MovedBeside>;

    /// Ids of its level and of what its model takes for granted.
    fn assumptions(&self) -> Vec<&'static str>;

    /// All its formulas at its worst position, with what they take from the other one and from the scene, under a name for the
    /// position.
    fn told(&self, id: &'static str) -> Worked;

    /// Its results.
    fn outputs(&self) -> Vec<&'static Symbol>;
}

impl<T: Described> MovedBeside for Description<T> {
    fn run(&self) -> Option<Result<MovingComponent, Fault>> {
        T::moving(self)
    }

    fn solved(&self) -> Option<Solver> {
        self.own.solver()
    }

    fn levels(&self) -> Vec<&'static str> {
        self.own.levels()
    }

    fn at(&self, level: &str) -> Arc<dyn MovedBeside> {
        let mut other = self.clone();
        other.own.set_level(level);
        Arc::new(other)
    }

    fn stepping(&self, step: f64) -> Arc<dyn MovedBeside> {
        let mut other = self.clone();
        other.own.step_by(step);
        Arc::new(other)
    }

    fn assumptions(&self) -> Vec<&'static str> {
        T::assumptions(self)
    }

    fn told(&self, id: &'static str) -> Worked {
        let mut model = self.standing();
        let mut peaks = Peaks::over(&model, T::aside(self));
        let sought = |symbol| T::OUTLINE.worst.iter().any(|(_, worst)| *worst == symbol);
        let governing = judged(self, &mut model, &mut peaks, &sought).governing;
        let there = worst(T::OUTLINE, model.motion(), &governing);
        let mut sections = constants::<T>(&model, None);
        let worked = worked::<T>(&model, there, None);
        sections.extend(worked.sections);
        Worked {
            id,
            taken: taken(self, worked.coordinate, &sections),
            sections,
            ..worked
        }
    }

    fn outputs(&self) -> Vec<&'static Symbol> {
        outputs(&self.standing())
    }
}

/// What formulas name that is given, besides the coordinate.
fn taken<T: Described>(
    told: &Description<T>,
    coordinate: &'static Symbol,
    sections: &[Section],
) -> Vec<(&'static Symbol, f64)> {
    let mut named = Vec::new();
    for trace in sections.iter().map(|section| &section.trace) {
        let steps = trace.steps.iter();
        steps.for_each(|step| trace.names(step.formula, &mut named));
    }
    let mut taken = Vec::new();
    T::Component::each(&T::given(told), &mut |_, (symbol, _), value| {
        if symbol != coordinate && named.contains(&symbol) {
            taken.push((symbol, value));
        }
    });
    taken
}
