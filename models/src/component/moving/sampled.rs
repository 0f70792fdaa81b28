//! A component that is sampled: what its samples hold stays as it is from one to the next, between which another carrier
//! carries it on.

use std::any::Any;

use crate::component::moving::clock::Clock;
use crate::component::moving::{Carrier, Ramp, sources};
use crate::component::running::Running;
use crate::component::stages::{Source, Use};
use crate::component::standing::Standing;
use crate::kernel::number::short;
use crate::kernel::variable::Fault;
use crate::parts::solver::{Count, MOST_STEPS};

/// How it is carried on, where it is sampled.
#[derive(Clone)]
struct SampledCarrier {
    between: Box<dyn Carrier>,
    clock: Clock,
    /// What a sample holds, and what that is before the first one.
    latches: Vec<(Source, f64)>,
}

/// What carries a component on, also where it is sampled: between two samples so.
#[must_use]
pub fn with_samples(own: impl Carrier, model: &Standing) -> Box<dyn Carrier> {
    let own = Box::new(own);
    match model.part().cycle() {
        Some(_) => Box::new(SampledCarrier::new(own, model)),
        None => own,
    }
}

impl SampledCarrier {
    /// By what carries a component on between two samples, none having been yet.
    fn new(between: Box<dyn Carrier>, model: &Standing) -> SampledCarrier {
        let part = model.part();
        let latch = |source: &&Source| part.groups()[usize::from(source.group)].1 == Use::Latch;
        let latches = model.memory().iter().filter(latch);
        SampledCarrier {
            between,
            clock: Clock::STOPPED,
            latches: latches.map(|source| (*source, part.take(*source))).collect(),
        }
    }

    /// No sample has been.
    fn begin(&mut self, model: &mut Standing) {
        for (source, start) in &self.latches {
            model.part_mut().put(*source, *start);
        }
        self.clock = Clock::STOPPED;
    }

    /// A sample at the present time where it is due; returns whether it was.
    fn sample(&mut self, model: &mut Standing) -> Result<bool, Fault> {
        let (cycle, time) = (cycle(model), model.time());
        let due = self.clock.is_due(cycle, time);
        if due {
            model.part_mut().latch().map_err(|fault| *fault)?;
            self.between.latched(model);
            self.clock = self.clock.sampled(cycle, time);
        }
        Ok(due)
    }

    /// From sample to sample; what fails leaves it anywhere.
    fn follow_samples(&mut self, model: &mut Standing, [from, to]: [f64; 2], ramps: &[Ramp]) -> Result<(), Fault> {
        let cycle = cycle(model);
        if (to - from) / cycle > f64::from(MOST_STEPS) {
            return Err(Fault::outside(format!(
                "the step of {} s has more than the {MOST_STEPS} samples that are allowed: take smaller communication steps",
                short(to - from)
            )));
        }
        let mut time = from;
        while time < to {
            model.set_time(time);
            // An event that was asked for at this time has done both already.
            if self.sample(model)? {
                self.between.event(model)?;
            }
            let end = self.clock.next_before(cycle, to).unwrap_or(to);
            let ramps: Vec<Ramp> = ramps.iter().map(|ramp| ramp.after(time - from)).collect();
            self.between.advance(model, [time, end], &ramps)?;
            for ramp in ramps {
                model.part_mut().put(ramp.source, ramp.after(end - time).value);
            }
            time = end;
        }
        Ok(())
    }
}

/// The cycle of its samples, in s.
fn cycle(model: &Standing) -> f64 {
    model.part().cycle().unwrap_or(f64::INFINITY)
}

/// All that changes with the time: states, and what is remembered.
fn changing(model: &Standing) -> Vec<(Source, f64)> {
    let all = sources(model)
        .map(|(source, _)| source)
        .chain(model.memory().iter().copied());
    all.map(|source| (source, model.part().take(source))).collect()
}

impl Carrier for SampledCarrier {
    fn advance(&mut self, model: &mut Standing, times: [f64; 2], ramps: &[Ramp]) -> Result<(), Fault> {
        let (clock, before, own) = (self.clock, changing(model), self.between.numbers());
        self.follow_samples(model, times, ramps).inspect_err(|_| {
            for (source, value) in &before {
                model.part_mut().put(*source, *value);
            }
            model.set_time(times[0]);
            self.clock = clock;
            self.between.take(&own);
        })
    }

    fn longest(&self, model: &Standing) -> f64 {
        self.between.longest(model)
    }

    fn place(&mut self, model: &mut Standing, value: f64) -> Result<(), Fault> {
        self.begin(model);
        self.between.place(model, value)
    }

    fn start(&mut self, model: &mut Standing) -> Result<(), Fault> {
        self.begin(model);
        self.between.start(model)?;
        self.sample(model)?;
        self.between.event(model).map(|_| ())
    }

    fn update(&mut self, model: &mut Standing) -> Result<(), Fault> {
        self.between.update(model)
    }

    fn event(&mut self, model: &mut Standing) -> Result<bool, Fault> {
        self.sample(model)?;
        self.between.event(model)
    }

    fn next_event(&self, model: &Standing) -> Option<f64> {
        let own = self.clock.next(cycle(model));
        own.into_iter().chain(self.between.next_event(model)).reduce(f64::min)
    }

    fn warning(&self) -> Option<&'static str> {
        self.between.warning()
    }

    fn changed(&mut self, model: &mut Standing, which: Option<usize>) {
        self.between.changed(model, which);
    }

    fn resume(&mut self, model: &mut Standing) {
        self.between.resume(model);
    }

    fn step_size(&self, model: &Standing) -> f64 {
        self.between.step_size(model)
    }

    fn count(&self) -> Count {
        self.between.count()
    }

    fn inertia(&self, model: &mut Standing) -> Result<f64, Fault> {
        self.between.inertia(model)
    }

    fn numbers(&self) -> Vec<f64> {
        let mut numbers = self.between.numbers();
        numbers.push(self.clock.number());
        numbers
    }

    fn take(&mut self, numbers: &[f64]) -> Option<()> {
        let (clock, own) = numbers.split_last()?;
        self.clock = Clock::of(*clock)?;
        self.between.take(own)
    }

    fn follow(&mut self, other: &dyn Carrier) {
        let other: &dyn Any = other;
        let other: &SampledCarrier = other.downcast_ref().expect("the same component");
        self.clock = other.clock;
        self.between.follow(&*other.between);
    }

    fn duplicate(&self) -> Box<dyn Carrier> {
        Box::new(self.clone())
    }
}
