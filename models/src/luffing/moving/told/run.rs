//! A run of the running model through a manoeuvre, sampled.

use crate::component::description::Description;
use crate::component::moving::MovingComponent;
use crate::component::running::{Running, State};
use crate::component::series::Series;
use crate::component::sheet::{Summary, Warning};
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::hydraulic::FIXED;
use crate::luffing::moving::level::CraneAt;
use crate::luffing::moving::powers::Powers;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::told::energy::{Energy, net, rounding, sum, turnover};
use crate::luffing::moving::told::events::Watch;
use crate::luffing::moving::told::manoeuvres::Pilot;
use crate::luffing::moving::told::present::{kinetic, powers, present};
use crate::luffing::moving::told::shown::Shown;
use crate::luffing::moving::told::stop::Stop;
use crate::parts::hydraulics::oil::VACUUM;
use crate::parts::joint::Bar;

/// Samples of a run, at least and at most.
const SAMPLES: [f64; 2] = [2000.0, 20_000.0];

/// How often a sample is halved where oil moves too fast for it, and what may be left over, as a part of the energy
/// that was turned over before and in it.
const HALVINGS: u32 = 6;
const LEFT: f64 = 1e-6;

/// Right-hand sides that a run may cost: for each of its samples, and for each of the longest steps of its solver. A
/// load that a hoist draws to the head turns about it ever faster.
const RATES: [f64; 2] = [200.0, 20.0];

/// How many samples there are for each look at the energy of motion, which is but a size.
const KINETIC: u32 = 16;

/// Events that are listed.
pub(super) const EVENTS: usize = 20;

/// Events that are warned of.
const WARNED: [&str; 6] = [
    "luffing_low",
    "luffing_high",
    "slewing_low",
    "slewing_high",
    "rope_slack",
    "run_ends",
];

/// What a run may cost: halvings from now on, without which what is left over goes to the energy's rest, which is
/// checked; and right-hand sides since the model is there, without which the run ends.
struct Budget {
    halvings: u32,
    rates: f64,
    /// Where a halved sample is begun again from, in turn.
    starts: Vec<State>,
}

/// Moves the model on and returns the works on the way, with powers and energy (J) at its end.
fn advance<T: Shown>(
    model: &mut MovingComponent,
    [from, to]: [f64; 2],
    before: &(Powers, f64),
    turned_over: f64,
    halvings: u32,
    budget: &mut Budget,
) -> Option<(Powers, (Powers, f64))> {
    if f64::from(model.count().rates) > budget.rates {
        return None;
    }
    let time = to - from;
    let middle = f64::midpoint(from, to);
    if halvings == 0 {
        model.advance(from, to).ok()?;
        let after = powers::<T::Component>(model).ok()?;
        return Some((sum(&[(&before.0, 0.5 * time), (&after.0, 0.5 * time)]), after));
    }
    let start = match budget.starts.pop() {
        Some(mut start) => {
            model.state_into(&mut start);
            start
        }
        None => model.state(),
    };
    model.advance(from, middle).ok()?;
    let half = powers::<T::Component>(model).ok()?;
    model.advance(middle, to).ok()?;
    let after = powers::<T::Component>(model).ok()?;
    let weights = [(&before.0, time / 6.0), (&half.0, time / 1.5), (&after.0, time / 6.0)];
    let (work, gain) = (sum(&weights), after.1 - before.1);
    let left = (net(&work) - gain).abs();
    let found = left <= LEFT * (turned_over + turnover(&work)) + rounding(before.1, after.1);
    if !found && budget.halvings > 0 {
        model.set_state(&start);
    }
    budget.starts.push(start);
    if found || budget.halvings == 0 {
        return Some((work, after));
    }
    budget.halvings -= 1;
    let (first, half) = advance::<T>(model, [from, middle], before, turned_over, halvings - 1, budget)?;
    let (second, after) = advance::<T>(model, [middle, to], &half, turned_over, halvings - 1, budget)?;
    Some((sum(&[(&first, 1.0), (&second, 1.0)]), after))
}

/// A run of the model, sampled.
pub(super) struct Run {
    /// Of each variable that is looked at.
    pub series: Series,
    pub events: Vec<(f64, &'static str)>,
    pub energy: Energy,
    /// When what leads is greatest while luffing moves, how great (zero where it never moves), and the model then.
    pub instant: f64,
    pub most: f64,
    pub state: State,
    /// Each with its time, in s.
    pub greatest_pressure: [f64; 2],
    pub least_pressure: [f64; 2],
    pub greatest_swing: [f64; 2],
    /// Of the moment on the driving link by the moving bodies' equilibrium from that of drive, friction and stop, at most,
    /// and the greatest of those moments (N·m).
    pub apart: [f64; 2],
    /// How brakes stop it, once they are called.
    pub stop: Option<Stop>,
}

impl Run {
    /// Looks at variables, by their indices, and at one that leads.
    pub(super) fn new<T: Shown>(
        luffing: &Description<T>,
        moving: &Moving,
        model: &mut MovingComponent,
        (lead, seen): (usize, impl Iterator<Item = usize>),
        pilot: &mut Pilot<'_, T>,
    ) -> Option<Run> {
        let (duration, step) = (pilot.duration(), moving.constants.step);
        let wanted = (duration / step).ceil();
        // Whole parts, or multiples, of the solver's longest step.
        let sample = match wanted {
            few if few < SAMPLES[0] => step / (SAMPLES[0] / wanted).ceil(),
            many => step * (many / SAMPLES[1]).ceil(),
        };
        let samples = (duration / sample).ceil() as u32;
        // With nothing told the crane was about to sag: braked it is at rest, and what holds it can be told.
        for _ in 0..2 {
            pilot.tell(model, [0.0, sample]).ok()?;
            model.update().ok()?;
        }
        let mut series = Series::new(sample, seen.chain([lead]));
        series.look(model).ok()?;
        let mut power = powers::<T::Component>(model).ok()?;
        let mut budget = Budget {
            halvings: samples,
            rates: RATES[0] * f64::from(samples) + RATES[1] * wanted,
            starts: Vec::new(),
        };
        let (at, least) = present::<T::Component>(model);
        let mut run = Run {
            series,
            events: Vec::new(),
            energy: Energy {
                start: power.1,
                end: power.1,
                ..Energy::default()
            },
            instant: 0.0,
            most: 0.0,
            state: model.state(),
            greatest_pressure: [pressure(moving, &at), 0.0],
            least_pressure: [least, 0.0],
            greatest_swing: [swing(moving, &at), 0.0],
            apart: [0.0; 2],
            stop: None,
        };
        let mut watch = Watch::new(&luffing.motion, moving, &at, sample);
        // The crane was at rest before.
        let mut rest = watch.clone();
        rest.joints = watch.joints.map(|joint| joint.map(|_| Bar::Held));
        run.events.extend(watch.since(&rest).into_iter().map(|id| (0.0, id)));
        for i in 0..samples {
            let (from, to) = (f64::from(i) * sample, f64::from(i + 1) * sample);
            if i > 0 {
                // Nothing is told that the model refuses: what it refuses next ends the run.
                let _ = pilot.tell(model, [from, to]);
                if pilot.calls(from) && run.stop.is_none() {
                    run.stop = Stop::called::<T::Component>(model, from);
                }
                power = powers::<T::Component>(model).ok()?;
            }
            let turned_over = turnover(&run.energy.work);
            let step = advance::<T>(model, [from, to], &power, turned_over, HALVINGS, &mut budget);
            let Some((work, now)) = step.filter(|_| run.series.look(model).is_ok()) else {
                run.events.push((from, "run_ends"));
                break;
            };
            let (at, least) = present::<T::Component>(model);
            if let Some(stop) = &mut run.stop {
                stop.look::<T::Component>(model, to);
            }
            let next = Watch::new(&luffing.motion, moving, &at, sample);
            let events = next.since(&watch);
            run.energy.add(&work, now.1);
            run.energy.blows = at.past.blown;
            if i % KINETIC == 0 {
                run.energy.kinetic = run.energy.kinetic.max(kinetic::<T::Component>(model).ok()?);
                if let Some(apart) = T::APART.and_then(|apart| apart(model)) {
                    run.apart = [0, 1].map(|k| run.apart[k].max(apart[k]));
                }
            }
            run.events.extend(events.into_iter().map(|id| (to, id)));
            (watch, power) = (next, now);
            // Where luffing is held it has no equation, and at a stop it tells little.
            let moves = watch.joints[0] != Some(Bar::Held) && !(moving.oil.is_some() && watch.stops[0] != [false; 2]);
            let leads = run.series.last(lead).abs();
            if moves && leads > run.most {
                (run.most, run.instant, run.state) = (leads, to, model.state());
            }
            run.keep(moving, (&at, least), to);
        }
        Some(run)
    }

    /// What is great or small at a time (s).
    fn keep(&mut self, moving: &Moving, (at, least): (&CraneAt, f64), time: f64) {
        greater(&mut self.greatest_pressure, pressure(moving, at), time);
        greater(&mut self.greatest_swing, swing(moving, at), time);
        if least < self.least_pressure[0] {
            self.least_pressure = [least, time];
        }
    }

    /// The first events, and the last one, which may be the end of the run.
    pub(super) fn listed(&self) -> Vec<(f64, &'static str)> {
        let mut listed = self.events.clone();
        if listed.len() > EVENTS {
            listed.drain(EVENTS - 1..listed.len() - 1);
        }
        listed
    }

    /// What happened that must not be overlooked: when first, and how often.
    pub(super) fn warnings(&self, manoeuvre: &'static str) -> Vec<Warning> {
        let warning = |id, summary, count| Warning {
            id,
            manoeuvre: Some(manoeuvre),
            summary,
            count,
        };
        let happened = WARNED.into_iter().filter_map(|id| {
            let mut times = self.events.iter().filter(|(_, event)| *event == id);
            let (at, _) = times.next()?;
            Some(warning(id, Summary::new(&m::T, *at), 1 + times.count()))
        });
        let cavitates = self.least_pressure[0] < VACUUM;
        let oil = cavitates.then(|| warning("cavitation", timed(&m::P_MIN, self.least_pressure), 1));
        happened.chain(oil).collect()
    }

    /// How far apart two ways to one moment are, and how much energy is left over, relative.
    pub(super) fn apart(&self) -> [f64; 2] {
        let [apart, greatest] = self.apart;
        let Powers {
            drive,
            slewing,
            hoist,
            pump,
            friction,
            throttles,
            wind,
            ..
        } = self.energy.work;
        let amounts = [
            drive,
            slewing,
            hoist,
            pump,
            friction,
            throttles,
            wind,
            self.energy.end - self.energy.start,
            self.energy.kinetic,
        ];
        let scale = amounts.into_iter().map(f64::abs).fold(f64::MIN_POSITIVE, f64::max);
        let rest = (self.energy.rest.abs() - self.energy.rounding).max(0.0);
        [if greatest > 0.0 { apart / greatest } else { 0.0 }, rest / scale]
    }
}

pub(super) fn timed(symbol: &'static Symbol, [value, at]: [f64; 2]) -> Summary {
    Summary {
        at: Some((&m::T, at)),
        ..Summary::new(symbol, value)
    }
}

/// Keeps what is greater, with its time (s).
fn greater(kept: &mut [f64; 2], value: f64, time: f64) {
    if value > kept[0] {
        *kept = [value, time];
    }
}

/// Greatest pressure of the oil, in Pa; zero without oil.
fn pressure(moving: &Moving, at: &CraneAt) -> f64 {
    let pressures = moving.oil.map(|_| &at.y[2..FIXED - 2]);
    pressures.into_iter().flatten().copied().fold(0.0, f64::max)
}

/// Angle of the rope from the vertical, in rad; zero without a rope.
fn swing(moving: &Moving, at: &CraneAt) -> f64 {
    if moving.rope.is_none() {
        return 0.0;
    }
    // The crane's own states but for its first two.
    let own = &at.y[if moving.oil.is_some() { FIXED } else { 2 }..];
    match moving.slewing {
        None => own[0].abs(),
        Some(_) => f64::direction(-own[3], (own[2] * own[2] + own[4] * own[4]).sqrt()),
    }
}
