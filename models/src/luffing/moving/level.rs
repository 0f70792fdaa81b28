//! What the levels have in common: rates, events, reactions, forces, steps. Each variant is a system of equations.

use nalgebra::Vector3;

use crate::kernel::calc::Calc;
use crate::luffing::moving::blown::directions;
use crate::luffing::moving::crane::{Commands, CraneState, Hangs, MovingCrane, Snapshot, Struck};
use crate::luffing::moving::driven::Slopes;
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::given::{Inputs, MOST_STATES};
use crate::luffing::moving::hydraulic::{FIRST, FIXED, Hydraulic, MOST, Modes, PresentCrane};
use crate::luffing::moving::leaning::Outer;
use crate::luffing::moving::motion::{HauledLinkage, MovingLinkage};
use crate::luffing::moving::powers::{Powers, oil_powers, powers_of};
use crate::luffing::moving::reduced::MotorShaft;
use crate::luffing::moving::shares::{Instant, rope_on_head};
use crate::luffing::moving::space::{HauledSlewing, Slewing};
use crate::parts::hanging::to_load;
use crate::parts::hydraulics::cylinder::{Flows, PART_MARGINS};
use crate::parts::hydraulics::oil::VACUUM;
use crate::parts::joint::Bar;
use crate::parts::solver::rodas::Run;
use crate::parts::solver::{Count, Halt};

/// Most event indicators of any level.
pub const MOST_INDICATORS: usize = 15 + PART_MARGINS;
/// Event indicators of the oil besides those of parts that it may have, which stand behind all others.
const OIL_INDICATORS: usize = 6;

/// The equations of a level.
#[derive(Clone)]
pub enum Level<P = f64> {
    Free(MovingLinkage<P>),
    Slewing(Slewing<P>),
    /// The same where the rope of the drive may go slack.
    Hauled(HauledLinkage<P>),
    HauledSlewing(HauledSlewing<P>),
    /// A cylinder, and nothing else that moves.
    Fixed(Hydraulic<FIXED, P>),
    /// A cylinder, the load on its rope, a crane that slews, or both.
    Hanging(Hydraulic<MOST, P>),
}

/// What the solver keeps of a level: of oil the step on which it is.
#[expect(
    clippy::large_enum_variant,
    reason = "it is copied, and nothing is allocated while a model runs"
)]
#[derive(Clone, Copy, Debug)]
pub enum Ahead {
    Nothing,
    Fixed(Run<FIXED>),
    Hanging(Run<MOST>),
}

/// A crane at an instant: its states and inputs, and what happened before.
#[derive(Clone, Copy, Debug)]
pub struct CraneAt<P = f64> {
    pub past: Modes,
    pub inputs: Inputs<P>,
    pub y: [P; MOST_STATES],
}

/// A result that only motion has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionResult {
    /// Of friction, brake and end stop on the driven bar.
    Friction,
    /// The same on slewing.
    SlewingFriction,
    Pull,
    /// Of brake and friction on the drum of a motor.
    Drum,
    /// Of motor and brake on the driven bar: what the line of its drive carries.
    Drive,
    Cylinder,
    /// Of the air on the load, and the power that it takes.
    Air,
    AirPower,
    /// Of the ground on the load, and the load's height above it.
    Ground,
    Height,
    /// Of wind and slope.
    Outer(Outer),
    /// Powers of the motor that drives it, and of the brakes on the drum of a slack rope.
    Motor,
    DrumBrake,
}

/// The same of cranes without oil, and of those with it.
macro_rules! either {
    ($level:expr, $crane:ident => $one:expr, $oil:ident => $other:expr) => {
        match $level {
            Level::Free($crane) => $one,
            Level::Slewing($crane) => $one,
            Level::Hauled($crane) => $one,
            Level::HauledSlewing($crane) => $one,
            Level::Fixed($oil) => $other,
            Level::Hanging($oil) => $other,
        }
    };
}

/// Spool, relief valves, stops of luffing and vacuum, then slewing and the rope as far as there are any.
fn oil_indicators<const N: usize, P: Coordinate<P>>(
    system: &Hydraulic<N, P>,
    modes: Modes,
    y: &[P; N],
) -> Option<[P; MOST_INDICATORS]> {
    let (opening, [low, high]) = (system.cylinder.relief[0], system.stops().map(P::constant));
    let margin = Hydraulic::<N, P>::oil(y).least().1 - P::constant(VACUUM);
    let mut out = [P::constant(0.0); MOST_INDICATORS];
    let own = [y[6], opening - y[2], opening - y[3], y[0] - low, high - y[0], margin];
    out[..OIL_INDICATORS].copy_from_slice(&own);
    let more = system.indicators(modes, y)?;
    let first = if system.dynamics().turntable().is_some() { 0 } else { 4 };
    put(&mut out[OIL_INDICATORS..], &more[first..]);
    let parts = system.part_margins(y).map(|margin| margin.unwrap_or(P::constant(0.0)));
    put(&mut out[MOST_INDICATORS - PART_MARGINS..], &parts);
    Some(out)
}

fn oil_reaction<const N: usize, P: Coordinate<P>>(
    system: &Hydraulic<N, P>,
    modes: Modes,
    y: &[P; N],
    reaction: MotionResult,
) -> Option<P> {
    match reaction {
        MotionResult::Cylinder => Some(system.cylinder.force(&Hydraulic::<N, P>::oil(y))),
        MotionResult::Drive => {
            let [_, arm] = P::reduced(system.dynamics(), y[0])?.drive;
            Some(system.shares(y, arm).drive)
        }
        MotionResult::Friction => Some(system.reaction(y[0], y[1])),
        MotionResult::SlewingFriction => system.slewing_friction(modes, y),
        MotionResult::Pull => system.rope_force(modes, y),
        MotionResult::Drum => system.drum_friction(modes, y),
        MotionResult::Air => Some(system.in_air(modes, y)?[0]),
        MotionResult::AirPower => Some(system.in_air(modes, y)?[1]),
        MotionResult::Ground => Some(system.on_ground(modes, y)?[0]),
        MotionResult::Height => Some(system.on_ground(modes, y)?[1]),
        MotionResult::Outer(which) => {
            let slews = system.dynamics().turntable().is_some();
            system.dynamics().outer(y[0], slews.then(|| y[FIXED]), which)
        }
        MotionResult::Motor | MotionResult::DrumBrake => Some(P::constant(0.0)),
    }
}

/// Of a crane without oil.
fn reaction_of<const N: usize, const J: usize, P: Coordinate<P>>(
    crane: &MovingCrane<N, J, P>,
    state: &CraneState<N, J>,
    commands: &Commands<J, P>,
    y: &[P; N],
    reaction: MotionResult,
) -> Option<P>
where
    MovingCrane<N, J, P>: Hangs<N, J, P>,
{
    match reaction {
        MotionResult::Pull => crane.rope_force(state, commands, y),
        MotionResult::Drum => {
            let r = &crane.reduced(state, y[0])?;
            Some(crane.drum_friction(&Snapshot { state, r, y, commands }))
        }
        MotionResult::Drive => {
            // Of a bar that moves all is known without its equations.
            let together = match state.joints[0] {
                Bar::Held => crane.friction_moment(0, state, commands, y)?,
                _ => P::constant(0.0),
            };
            let shaft = shaft(crane, state, y[0])?;
            Some(crane.shares(state, commands, y, (together, shaft.as_ref())).drive)
        }
        MotionResult::Air | MotionResult::AirPower => {
            let r = &crane.reduced(state, y[0])?;
            let [force, power] = crane.in_air(&Snapshot { state, r, y, commands });
            Some(if reaction == MotionResult::Air { force } else { power })
        }
        MotionResult::Ground | MotionResult::Height => {
            let r = &crane.reduced(state, y[0])?;
            let [force, height] = crane.on_ground(&Snapshot { state, r, y, commands });
            Some(if reaction == MotionResult::Ground {
                force
            } else {
                height
            })
        }
        MotionResult::Motor | MotionResult::DrumBrake if !MovingCrane::<N, J, P>::HAULED => Some(P::constant(0.0)),
        MotionResult::Motor | MotionResult::DrumBrake => {
            let r = &crane.reduced(state, y[0])?;
            let [given, braked] = crane.drum_powers(&Snapshot { state, r, y, commands });
            Some(if reaction == MotionResult::Motor { given } else { braked })
        }
        MotionResult::SlewingFriction => crane.friction_moment(1, state, commands, y),
        MotionResult::Outer(which) => crane.dynamics.outer(y[0], MovingCrane::<N, J, P>::slewed(y), which),
        MotionResult::Friction | MotionResult::Cylinder => crane.friction_moment(0, state, commands, y),
    }
}

/// The shaft of a motor that turns with it at an angle (rad), where it has one; `None` where the linkage does not close.
fn shaft<const N: usize, const J: usize, P: Coordinate<P>>(
    crane: &MovingCrane<N, J, P>,
    state: &CraneState<N, J>,
    theta: P,
) -> Option<Option<MotorShaft<P>>>
where
    MovingCrane<N, J, P>: Hangs<N, J, P>,
{
    match crane.dynamics.is_geared() {
        true => crane.reduced(state, theta).map(|r| r.geared().copied()),
        false => Some(None),
    }
}

/// The states of this level.
pub(super) fn first<const N: usize, P>(y: &[P; MOST_STATES]) -> &[P; N] {
    y.first_chunk().expect("no level has more states")
}

pub(super) fn put<P: Copy>(to: &mut [P], from: &[P]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *from;
    }
}

fn all<P: Calc>(own: &[P]) -> [P; MOST_STATES] {
    let mut all = [P::constant(0.0); MOST_STATES];
    put(&mut all, own);
    all
}

impl<P: Calc> Level<P> {
    #[must_use]
    pub fn dynamics(&self) -> &Dynamics<P> {
        either!(self, crane => &crane.dynamics, system => system.dynamics())
    }

    /// Flows of its cylinder, where it has one.
    pub fn oil_flows(&self, y: &[P; MOST_STATES]) -> Option<Flows<P>> {
        either!(self, _crane => None, system => Some(system.cylinder.flows(&Hydraulic::<MOST, P>::oil(y), system.supply)))
    }

    fn has_oil(&self) -> bool {
        matches!(self, Level::Fixed(_) | Level::Hanging(_))
    }

    /// Under inputs; `None` where they are no part of its equations.
    #[must_use]
    pub fn told(&self, inputs: &Inputs<P>) -> Option<Level<P>> {
        let around = self.dynamics().is_aired() || self.dynamics().is_outdoors();
        let mut told = (self.has_oil() || around).then(|| self.clone())?;
        either!(&mut told, crane => crane.dynamics.put_around(inputs.wind, inputs.weather), system => {
            system.put_around(inputs.wind, inputs.weather);
            (system.command, system.supply) = (inputs.valve, inputs.supply);
            system.cylinder.torn = inputs.torn;
            (system.hoist, system.slewing) = (inputs.hoist, inputs.drives[1]);
        });
        Some(told)
    }
}

impl<P: Coordinate<P>> Level<P> {
    /// Rates of the states; `None` where the linkage does not close.
    pub fn rates(&self, CraneAt { past, inputs, y }: &CraneAt<P>) -> Option<[P; MOST_STATES]> {
        Some(either!(
            self,
            crane => all(&crane.rates(&past.crane(first(y)), &inputs.of(), first(y))?),
            system => all(&system.equations(*past, first(y))?)
        ))
    }

    /// Numbers whose change of sign is an event; `None` where the linkage does not close.
    pub fn indicators(&self, CraneAt { past, inputs, y }: &CraneAt<P>) -> Option<[P; MOST_INDICATORS]> {
        either!(
            self,
            crane => {
                let mut out = [P::constant(0.0); MOST_INDICATORS];
                put(&mut out, &crane.indicators(&past.crane(first(y)), &inputs.of(), first(y))?);
                Some(out)
            },
            system => oil_indicators(system, *past, first(y))
        )
    }

    /// A result that only motion has; `None` where the linkage does not close.
    pub fn reaction(&self, CraneAt { past, inputs, y }: &CraneAt<P>, reaction: MotionResult) -> Option<P> {
        either!(
            self,
            crane => reaction_of(crane, &past.crane(first(y)), &inputs.of(), first(y), reaction),
            system => oil_reaction(system, *past, first(y), reaction)
        )
    }
}

impl<P: Coordinate<P>> Level<P> {
    /// How it moves and what acts on it; `arm` is that of its cylinder (m), where it has one. `None` where the linkage
    /// does not close.
    pub fn instant(&self, at: &CraneAt<P>, arm: P) -> Option<Instant<P>> {
        let (dynamics, y, inputs) = (self.dynamics(), &at.y, &at.inputs);
        let rates = self.rates(at)?;
        // Where slewing and load begin, behind the angle, its rate and the oil.
        let own = &y[if self.has_oil() { FIXED } else { 2 }..];
        let slews = dynamics.turntable().is_some();
        let (mut pull, mut tension) = (None, None);
        if dynamics.pendulum().is_some() {
            let along = self.reaction(at, MotionResult::Pull)?;
            let direction = if slews {
                to_load(Vector3::new(own[2], own[3], own[4])).1.xy()
            } else {
                directions(own[0]).0
            };
            (pull, tension) = (Some(rope_on_head(along, direction)), Some(along));
        }
        let together = self.reaction(at, MotionResult::Friction)?;
        let shares = either!(
            self,
            crane => {
                let state = &at.past.crane(first(y));
                let shaft = shaft(crane, state, y[0])?;
                let shares = crane.shares(state, &inputs.of(), first(y), (together, shaft.as_ref()));
                shares.less(shaft.map(|shaft| shaft.lags(y[1], rates[1])))
            },
            system => system.shares(first(y), arm)
        );
        Some(Instant {
            omega: y[1],
            alpha: rates[1],
            turning: slews.then(|| own[1]).or(dynamics.slewed_at()),
            pull,
            tension,
            pushed: dynamics.pushed(y[0], slews.then(|| own[0]))?,
            shares,
        })
    }
}

/// What follows from a run, where there is one.
macro_rules! running {
    ($ahead:expr, $run:ident => $of:expr, $none:expr) => {
        match $ahead {
            Ahead::Nothing => $none,
            Ahead::Fixed($run) => $of,
            Ahead::Hanging($run) => $of,
        }
    };
}

impl Ahead {
    /// What is solved ahead is dropped: it goes on from these states.
    pub fn restart(&mut self, y: &[f64; MOST_STATES]) {
        running!(self, run => run.restart(*first(y), FIRST), ());
    }

    /// The same where an input or a parameter changes.
    pub fn interrupt(&mut self) {
        running!(self, run => run.interrupt(FIRST), ());
    }

    /// Least pressure of the oil so far, in Pa; infinite without oil.
    #[must_use]
    pub fn least_pressure(&self) -> f64 {
        running!(self, run => least(run), f64::INFINITY)
    }

    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        running!(self, run => run.numbers().collect(), Vec::new())
    }

    /// Takes back as many; `None` where they are those of no run.
    pub fn take(&mut self, numbers: &[f64]) -> Option<()> {
        running!(self, run => *run = Run::of(numbers)?, ());
        numbers.iter().all(|x| x.is_finite()).then_some(())
    }
}

fn least<const N: usize>(run: &Run<N>) -> f64 {
    run.least.min(Hydraulic::<N>::oil(&run.states()).least().1)
}

/// How far to move on.
#[derive(Clone, Copy, Debug)]
pub struct Onward {
    /// For how long, and explicit steps at most; in s.
    pub duration: f64,
    pub longest: f64,
    /// Relative.
    pub tolerance: f64,
    /// Rates of change of the inputs meanwhile, where they change: of explicit steps alone.
    pub slopes: Option<Inputs>,
}

fn crane_run<const N: usize, const J: usize>(
    crane: &MovingCrane<N, J>,
    at: &mut CraneAt,
    on: Option<Onward>,
) -> Result<Count, Halt>
where
    MovingCrane<N, J>: Struck<N, J>,
{
    let (mut state, commands) = (at.past.crane(first(&at.y)), &at.inputs.of());
    let work = match on {
        None => crane.event(&mut state, commands).map(|_| Count::default())?,
        Some(on) => {
            let slopes = on.slopes.map(|slopes| Slopes::of(&slopes));
            crane.follow(&mut state, (commands, slopes.as_ref()), on.duration, on.longest)?
        }
    };
    at.past.follow(&state);
    put(&mut at.y, &state.y);
    Ok(work)
}

/// The events of oil are kinks, where nothing is to be decided, and what the implicit solver has solved ahead ends before
/// the next event.
fn oil_run<const N: usize>(
    system: &Hydraulic<N>,
    run: &mut Run<N>,
    at: &mut CraneAt,
    on: Option<Onward>,
) -> Result<Count, Halt> {
    let (before, modes) = (run.count, at.past);
    let mut present = PresentCrane { run: *run, modes };
    match on {
        Some(on) => {
            let tolerance = system.tolerance(on.tolerance);
            system.advance(&mut present, &tolerance, on.duration, on.longest)?;
        }
        None if present.run.is_fresh() => system.event(&mut present)?,
        None => {}
    }
    let y = present.run.states();
    let possible = match on {
        None => f64::reduced(system.dynamics(), y[0]).is_some(),
        // Of the oil or of the mechanism.
        Some(_) => {
            let within = Hydraulic::<N>::oil(&y).is_possible(system.cylinder.bulk_modulus);
            within && y[0].abs() < 1e3 && system.equations(present.modes, &y).is_some()
        }
    };
    (*run, at.past) = (present.run, present.modes);
    put(&mut at.y, &y);
    possible.then_some(run.count.since(before)).ok_or(Halt::Outside)
}

impl Level {
    /// Nothing is solved ahead of these states.
    #[must_use]
    pub fn ahead(&self, y: &[f64; MOST_STATES]) -> Ahead {
        match self {
            Level::Free(_) | Level::Slewing(_) | Level::Hauled(_) | Level::HauledSlewing(_) => Ahead::Nothing,
            Level::Fixed(_) => Ahead::Fixed(Run::new(*first(y), FIRST)),
            Level::Hanging(_) => Ahead::Hanging(Run::new(*y, FIRST)),
        }
    }

    /// Moves on, or decides what follows at an instant. Returns the work done.
    ///
    /// # Errors
    /// See [`Halt`].
    ///
    /// # Panics
    /// For what is kept of another level.
    pub fn run(&self, at: &mut CraneAt, ahead: &mut Ahead, on: Option<Onward>) -> Result<Count, Halt> {
        match (self, ahead) {
            (Level::Free(crane), _) => crane_run(crane, at, on),
            (Level::Slewing(crane), _) => crane_run(crane, at, on),
            (Level::Hauled(crane), _) => crane_run(crane, at, on),
            (Level::HauledSlewing(crane), _) => crane_run(crane, at, on),
            (Level::Fixed(system), Ahead::Fixed(run)) => oil_run(system, run, at, on),
            (Level::Hanging(system), Ahead::Hanging(run)) => oil_run(system, run, at, on),
            _ => unreachable!("of another level"),
        }
    }

    /// Powers, and the energy of all bodies (J); `None` where the linkage does not close.
    pub(crate) fn powers(&self, CraneAt { past, inputs, y }: &CraneAt) -> Option<(Powers, f64)> {
        either!(
            self,
            crane => powers_of(crane, &past.crane(first(y)), &inputs.of()),
            system => oil_powers(system, *past, first(y))
        )
    }
}
