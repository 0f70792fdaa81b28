//! A component that runs, whatever it is made of.

use std::any::Any;

use num_dual::Dual64;

use crate::component::scalar::Scalar;
use crate::component::stages::{Found, Slot, Source, Stage, Stages, Use};
use crate::component::whole::Whole;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Quantity, Variable};

/// What a component adds to its stages.
pub trait Component: Stages {
    /// Results whose change of sign is an event.
    const INDICATORS: &'static [&'static Symbol] = &[];

    /// Results of the whole working range.
    const WHOLE: &'static [Whole] = &[];

    /// Where other components meet it.
    const PORTS: &'static [Port] = &[];

    /// Coordinate and rate that are states where the component moves by itself, and the rates of all states.
    const STATES: [&'static [&'static Symbol]; 2] = [&[]; 2];

    /// Whether a result of a stage that exists is one of this scene.
    #[must_use]
    fn has(_: &Self::Given<f64>, _: &'static Symbol) -> bool {
        true
    }

    /// Whether a given quantity is one of this scene.
    #[must_use]
    fn gives(_: &Self::Given<f64>, _: &'static Symbol) -> bool {
        true
    }

    /// Says of a variable what its symbol does not, and returns which part of the list it stands in: parts follow by
    /// their numbers.
    fn list(_: &Self::Given<f64>, _: &mut Variable) -> u8 {
        0
    }

    /// Results that stand before all others, in this order.
    #[must_use]
    fn first(_: &Self::Given<f64>) -> &'static [&'static Symbol] {
        &[]
    }

    /// Whether a parameter is an input in this scene.
    #[must_use]
    fn is_input(_: &Self::Given<f64>, _: &'static Symbol) -> bool {
        false
    }

    /// Decides what follows at an event of its motion; whether a state jumped.
    ///
    /// # Errors
    /// A configuration that does not exist.
    fn decide(_: &mut Self::Known<f64>) -> Found<bool> {
        Ok(false)
    }

    /// The time from one of its samples to the next, in s, where it is sampled.
    #[must_use]
    fn cycle(_: &Self::Given<f64>) -> Option<f64> {
        None
    }

    /// A sample: what it remembers follows from states and inputs.
    ///
    /// # Errors
    /// A configuration that does not exist.
    fn latch(_: &mut Self::Known<f64>) -> Found<()> {
        Ok(())
    }

    /// Brings the component to the present sources: what must be possible at any time.
    ///
    /// # Errors
    /// A configuration that does not exist.
    fn update(known: &mut Self::Known<f64>) -> Found<()>;

    /// Least and greatest value of the coordinate around the working range, in SI.
    #[must_use]
    fn reach(_: &mut Self::Known<f64>) -> Option<[f64; 2]> {
        None
    }

    /// Whether the least change of a source alone makes another component of it: by such a source is no derivative.
    fn undoes(_: &Self::Given<f64>, _: &'static Symbol) -> bool {
        false
    }

    /// Keeps what the past leaves, before a discrete input changes.
    fn leave(_: &mut Self::Known<f64>) {}

    /// Ends initialization.
    fn start(_: &mut Self::Known<f64>) {}
}

/// Variables that belong together where components meet.
#[derive(Debug)]
pub struct Port {
    pub name: &'static str,
    pub text: &'static str,
    /// Each with its name at the port.
    pub members: &'static [(&'static Symbol, &'static str)],
    /// Members that only an input can be.
    pub driven: &'static [&'static str],
}

/// Ports, each with what it is, the members that only an input can be, and its variables by their names there:
/// `ports! { s: shaft "Foot of the bar." [phi w]: phi THETA, w OMEGA, tau M_D; }`.
macro_rules! ports {
    ($table:ident: $($name:ident $text:literal $([$($driven:ident)*])?: $($member:ident $symbol:ident),*;)*) => {
        &[$($crate::component::part::Port {
            name: stringify!($name),
            text: $text,
            members: &[$((&$table::$symbol, stringify!($member))),*],
            driven: &[$($(stringify!($driven)),*)?],
        }),*]
    };
}
pub(crate) use ports;

/// A component over one scalar.
pub trait Face<C>: Any + Send {
    fn take(&self, source: Source) -> C;
    /// Changes a source and forgets what follows from it.
    fn put(&mut self, source: Source, value: C);
    /// A result, computed where it is not known.
    ///
    /// # Errors
    /// Those of the stages.
    fn result(&mut self, slot: &Slot, into: &mut C) -> Found<()>;
    /// A stage, by its place.
    ///
    /// # Errors
    /// As [`result`](Face::result).
    fn make(&mut self, stage: u8) -> Found<()>;
}

/// A component that runs, without the recorder, which the FMU's library does not carry.
pub trait Part: Face<f64> {
    fn groups(&self) -> &'static [(&'static str, Use)];
    fn stages(&self) -> &'static [Stage];
    /// Whether a stage exists in the scene, by its place.
    fn exists(&self, stage: u8) -> bool;
    /// Every source that the scene has.
    fn sources(&self) -> Vec<(Source, Quantity)>;
    /// Every result that the scene has.
    fn results(&self) -> Vec<(Slot, Quantity)>;
    /// As [`Component::list`].
    fn list(&self, variable: &mut Variable) -> u8;
    /// Of [`Component::INDICATORS`].
    fn indicators(&self) -> &'static [&'static Symbol];
    /// Of [`Component::STATES`].
    fn states(&self) -> [&'static [&'static Symbol]; 2];
    /// As [`Component::is_input`].
    fn is_input(&self, symbol: &'static Symbol) -> bool;
    /// As [`Component::decide`].
    ///
    /// # Errors
    /// A configuration that does not exist.
    fn decide(&mut self) -> Found<bool>;
    /// As [`Component::cycle`].
    fn cycle(&self) -> Option<f64>;
    /// As [`Component::latch`].
    ///
    /// # Errors
    /// As there.
    fn latch(&mut self) -> Found<()>;
    /// Of [`Component::WHOLE`].
    fn whole(&self) -> &'static [Whole];
    /// Of [`Component::PORTS`].
    fn ports(&self) -> &'static [Port];
    /// The same on dual numbers, each source with the derivative that `seed` gives it, and the groups that change, a bit
    /// for each. What does not change is taken over from the plain numbers where `lifted`.
    fn dual(&self, lifted: bool, seed: &mut dyn FnMut(Source, Quantity) -> f64) -> (Box<dyn Face<Dual64>>, u64);
    /// As [`dual`](Part::dual), lifted, into one that exists, with all `sources`.
    fn dual_into(
        &self,
        dual: &mut dyn Face<Dual64>,
        sources: &[(Source, Quantity)],
        seed: &mut dyn FnMut(Source, Quantity) -> f64,
    ) -> u64;
    /// As [`Component::update`].
    ///
    /// # Errors
    /// A configuration that does not exist.
    fn update(&mut self) -> Found<()>;
    /// As [`Component::reach`].
    fn reach(&mut self) -> Option<[f64; 2]>;
    /// As [`Component::undoes`].
    fn undoes(&self, symbol: &'static Symbol) -> bool;
    /// As [`Component::leave`].
    fn leave(&mut self);
    /// As [`Component::start`].
    fn start(&mut self);
    fn duplicate(&self) -> Box<dyn Part>;
    /// Becomes what another one of the same component is.
    fn follow(&mut self, other: &dyn Part);
}

impl Clone for Box<dyn Part> {
    fn clone(&self) -> Box<dyn Part> {
        self.duplicate()
    }
}

/// A component on one scalar with all that is known of it.
pub struct Runner<T: Stages, C: Scalar>(pub T::Known<C>);

impl<T: Component, C: Scalar> Runner<T, C> {
    #[must_use]
    pub fn new(given: T::Given<C>) -> Runner<T, C> {
        Runner(T::new(given))
    }

    #[must_use]
    pub fn given(&self) -> &T::Given<C> {
        T::given(&self.0)
    }
}

impl<T: Stages, C: Scalar> Face<C> for Runner<T, C> {
    #[inline]
    fn take(&self, source: Source) -> C {
        T::take(&self.0, source)
    }
    #[inline]
    fn put(&mut self, source: Source, value: C) {
        T::put(&mut self.0, source, value);
    }
    #[inline]
    fn result(&mut self, slot: &Slot, into: &mut C) -> Found<()> {
        T::result(&mut self.0, slot, into)
    }
    fn make(&mut self, stage: u8) -> Found<()> {
        T::make(&mut self.0, stage)
    }
}

impl<T: Component> Runner<T, f64> {
    fn dual(&self, lifted: bool, seed: &mut dyn FnMut(Source, Quantity) -> f64) -> (Runner<T, Dual64>, u64) {
        let mut moved = 0;
        let given = T::map(self.given(), &mut |source, quantity, value| {
            let rate = seed(source, quantity);
            moved |= u64::from(rate != 0.0) << source.group;
            Dual64::new(value, rate)
        });
        let mut dual = Runner::<T, Dual64>::new(given);
        // Places that were found with plain numbers hold in every direction.
        T::lift(&self.0, &mut dual.0, if lifted { moved } else { !0 });
        (dual, moved)
    }
}

impl<T: Component> Part for Runner<T, f64> {
    fn groups(&self) -> &'static [(&'static str, Use)] {
        T::GROUPS
    }

    fn stages(&self) -> &'static [Stage] {
        T::STAGES
    }

    fn exists(&self, stage: u8) -> bool {
        T::count(&self.0, stage).is_some()
    }

    fn sources(&self) -> Vec<(Source, Quantity)> {
        let mut all = Vec::new();
        let given = self.given();
        T::each(given, &mut |source, quantity, _| {
            if T::gives(given, quantity.0) {
                all.push((source, quantity));
            }
        });
        together(&all)
    }

    fn list(&self, variable: &mut Variable) -> u8 {
        T::list(self.given(), variable)
    }

    fn results(&self) -> Vec<(Slot, Quantity)> {
        let given = self.given();
        let is_state = |source: Source| T::GROUPS[usize::from(source.group)].1 == Use::State;
        let states = self.sources().into_iter().filter(|(source, _)| is_state(*source));
        let found = (0..).zip(T::STAGES);
        let found = found.filter_map(|(stage, what)| Some((stage, what, T::count(&self.0, stage)?)));
        results(
            &found.collect::<Vec<_>>(),
            &states.map(|(_, quantity)| quantity).collect::<Vec<_>>(),
            T::first(given),
            &|symbol| T::has(given, symbol),
        )
    }

    fn indicators(&self) -> &'static [&'static Symbol] {
        T::INDICATORS
    }

    fn states(&self) -> [&'static [&'static Symbol]; 2] {
        T::STATES
    }

    fn is_input(&self, symbol: &'static Symbol) -> bool {
        T::is_input(self.given(), symbol)
    }

    fn decide(&mut self) -> Found<bool> {
        T::decide(&mut self.0)
    }

    fn cycle(&self) -> Option<f64> {
        T::cycle(self.given())
    }

    fn latch(&mut self) -> Found<()> {
        T::latch(&mut self.0)
    }

    fn whole(&self) -> &'static [Whole] {
        T::WHOLE
    }

    fn ports(&self) -> &'static [Port] {
        T::PORTS
    }

    fn dual(&self, lifted: bool, seed: &mut dyn FnMut(Source, Quantity) -> f64) -> (Box<dyn Face<Dual64>>, u64) {
        let (dual, moved) = self.dual(lifted, seed);
        (Box::new(dual), moved)
    }

    fn dual_into(
        &self,
        dual: &mut dyn Face<Dual64>,
        sources: &[(Source, Quantity)],
        seed: &mut dyn FnMut(Source, Quantity) -> f64,
    ) -> u64 {
        let dual: &mut dyn Any = dual;
        let dual: &mut Runner<T, Dual64> = dual.downcast_mut().expect("the same component");
        let mut moved = 0;
        for &(source, quantity) in sources {
            let rate = seed(source, quantity);
            moved |= u64::from(rate != 0.0) << source.group;
            T::put(&mut dual.0, source, Dual64::new(self.take(source), rate));
        }
        T::lift(&self.0, &mut dual.0, moved);
        moved
    }

    fn update(&mut self) -> Found<()> {
        T::update(&mut self.0)
    }

    fn reach(&mut self) -> Option<[f64; 2]> {
        T::reach(&mut self.0)
    }

    fn undoes(&self, symbol: &'static Symbol) -> bool {
        T::undoes(self.given(), symbol)
    }

    fn leave(&mut self) {
        T::leave(&mut self.0);
    }

    fn start(&mut self) {
        T::start(&mut self.0);
    }

    fn duplicate(&self) -> Box<dyn Part> {
        let mut other = Runner::<T, f64>::new(self.given().clone());
        T::follow(&mut other.0, &self.0);
        Box::new(other)
    }

    fn follow(&mut self, other: &dyn Part) {
        let other: &dyn Any = other;
        let other: &Runner<T, f64> = other.downcast_ref().expect("the same component");
        T::follow(&mut self.0, &other.0);
    }
}

/// Of stages with their counts all results that there are, those listed first before the others. What a later stage finds again
/// takes the place of what was found first; a state is no result.
fn results(
    stages: &[(u8, &'static Stage, Option<u16>)],
    states: &[Quantity],
    first: &[&'static Symbol],
    has: &dyn Fn(&'static Symbol) -> bool,
) -> Vec<(Slot, Quantity)> {
    let mut all: Vec<(Slot, Quantity)> = Vec::new();
    for &(stage, what, count) in stages {
        for (row, &symbol) in (0..).zip(what.rows).filter(|(_, symbol)| has(symbol)) {
            for of in 0..count.unwrap_or(1) {
                let slot = Slot {
                    stage,
                    row,
                    of,
                    sources: what.sources,
                };
                let quantity = (symbol, count.map(|_| of + 1));
                match all.iter_mut().find(|(_, known)| *known == quantity) {
                    Some((first, _)) => *first = slot,
                    None if states.contains(&quantity) => {}
                    None => all.push((slot, quantity)),
                }
            }
        }
    }
    let place = |symbol| first.iter().position(|known| *known == symbol);
    all.sort_by_key(|(_, (symbol, _))| place(*symbol).unwrap_or(first.len()));
    all
}

/// Variables with their places in the order in which a component lists them.
pub(crate) fn listed<T>(part: &dyn Part, variables: Vec<Variable>, places: Vec<T>) -> (Vec<Variable>, Vec<T>) {
    let all = variables.into_iter().zip(places);
    let mut all: Vec<_> = all
        .map(|(mut variable, place)| (part.list(&mut variable), variable, place))
        .collect();
    all.sort_by_key(|(list, ..)| *list);
    all.into_iter().map(|(_, variable, place)| (variable, place)).unzip()
}

/// In the order in which they are listed: quantities of a numbered group stand together, as vectors do.
fn together(all: &[(Source, Quantity)]) -> Vec<(Source, Quantity)> {
    let alike = |(one, (symbol, _)): &(Source, Quantity), (other, (same, _)): &(Source, Quantity)| {
        one.group == other.group && symbol == same
    };
    let firsts = (0..all.len()).filter(|&at| !all[..at].iter().any(|before| alike(before, &all[at])));
    firsts
        .flat_map(|at| all[at..].iter().filter(move |entry| alike(&all[at], entry)).copied())
        .collect()
}
