//! What the levels have in common for the running model: states, rates, events,
//! steps. Each variant is a system of equations with all of its solver's state
//! beside it.

use nalgebra::Vector3;

use crate::kernel::calc::Calc;
use crate::luffing::double_link::crane::{Commands, CraneState, Hangs, MovingCrane, Snapshot, Struck};
use crate::luffing::double_link::dynamics::{Coordinate, Dynamics};
use crate::luffing::double_link::forces_in_motion::{ForcesInMotion, rope_on_head};
use crate::luffing::double_link::hydraulic::{self, FIXED, Hydraulic, Modes};
use crate::luffing::double_link::inertia_forces::Instant;
use crate::luffing::double_link::motion::{self, MovingLinkage, directions};
use crate::luffing::double_link::moving::given::Inputs;
use crate::luffing::double_link::pose::Posing;
use crate::luffing::double_link::shares::Shares;
use crate::luffing::double_link::slewing::{self, Slewing};
use crate::parts::hanging::to_load;
use crate::parts::hoist::Drum;
use crate::parts::hydraulics::cylinder::Oil;
use crate::parts::hydraulics::oil::VACUUM;
use crate::parts::joint::{Bar, JointDrive};
use crate::parts::solver::rodas::{Run, Tolerance};
use crate::parts::solver::{Count, Halt};

/// Most continuous states of any level.
pub const MOST_STATES: usize = hydraulic::MOST;
/// Most event indicators of any level.
pub const MOST_INDICATORS: usize = 13;
/// Event indicators of the oil.
pub const OIL_INDICATORS: usize = 6;

/// The equations of a level.
#[derive(Clone, Debug)]
pub enum Level<P = f64> {
    Free(MovingLinkage<P>),
    Slewing(Slewing<P>),
    /// A cylinder, and nothing else that moves.
    Fixed(Hydraulic<FIXED, P>),
    /// A cylinder, the load on its rope, a crane that slews, or both.
    Hanging(Hydraulic<{ hydraulic::MOST }, P>),
}

/// Where a level is: its states, and its solver's.
#[expect(
    clippy::large_enum_variant,
    reason = "a state is copied, and nothing is allocated while a model runs"
)]
#[derive(Clone, Copy, Debug)]
pub enum Present {
    Free(motion::MotionState),
    Slewing(slewing::SlewingState),
    Fixed(hydraulic::PresentCrane<FIXED>),
    Hanging(hydraulic::PresentCrane<{ hydraulic::MOST }>),
}

/// A result that only motion has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionResult {
    /// Of friction, brake and end stop on the driven bar.
    Friction,
    /// The same on slewing.
    SlewingFriction,
    Rope,
    /// Of brake and friction on the drum of a motor.
    Drum,
    /// Energy that blows have taken.
    Blows,
    /// Angles of the rope of a crane that slews, in the mechanism's plane and from it.
    Swing,
    Side,
    /// Of the load from the head of a crane that slews.
    Distance,
    Cylinder,
}

/// Level and state come from one model, which keeps them together.
const OTHER: &str = "the state of another level";

fn tell<const N: usize, P: Copy>(system: &mut Hydraulic<N, P>, inputs: &Inputs<P>) {
    (system.command, system.supply) = (inputs.valve, inputs.supply);
    (system.hoist, system.slewing) = (inputs.hoist, inputs.drives[1]);
}

/// Angles and rates, pressures, spool and its speed, load and rope; no more than there are. A spool that is
/// known better than its edges need would cost a quarter of all steps.
fn tolerance<const N: usize>(relative: f64, states: usize) -> Tolerance<N> {
    let mut absolute = [f64::INFINITY; N];
    absolute[..states].fill(relative * 1e-3);
    absolute[2..6].fill(relative * 1e6);
    absolute[6..FIXED].copy_from_slice(&[relative * 0.1, relative * 30.0]);
    Tolerance { relative, absolute }
}

/// Spool, relief valves, stops of luffing and vacuum, then slewing and the rope as far as there are any.
fn oil_indicators<const N: usize, P: Coordinate<P>>(
    system: &Hydraulic<N, P>,
    modes: Modes,
    y: &[P; N],
    indicators: &mut [P; MOST_INDICATORS],
) -> Option<()> {
    let (opening, [low, high]) = (system.cylinder.relief[0], system.stops().map(P::constant));
    let margin = Hydraulic::<N, P>::oil(y).least().1 - P::constant(VACUUM);
    put(
        indicators,
        &[y[6], opening - y[2], opening - y[3], y[0] - low, high - y[0], margin],
    );
    let more = system.indicators(modes, y)?;
    let first = if system.dynamics().turntable().is_some() { 0 } else { 4 };
    put(&mut indicators[OIL_INDICATORS..], &more[first..]);
    Some(())
}

fn oil_reaction<const N: usize, P: Coordinate<P>>(
    system: &Hydraulic<N, P>,
    modes: Modes,
    y: &[P; N],
    reaction: MotionResult,
) -> Option<P> {
    match reaction {
        MotionResult::Cylinder => Some(system.cylinder.force(&Hydraulic::<N, P>::oil(y))),
        MotionResult::Friction => Some(system.reaction(y[0], y[1])),
        MotionResult::SlewingFriction => system.slewing_friction(modes, y),
        MotionResult::Rope => system.rope_force(modes, y),
        MotionResult::Drum => system.drum_friction(modes, y),
        MotionResult::Blows => Some(P::constant(modes.blown)),
        MotionResult::Swing | MotionResult::Side | MotionResult::Distance => Some(seen(&hydraulic::part(y), reaction)),
    }
}

/// Of a crane without oil.
fn reaction_of<const N: usize, const J: usize, P: Calc, C: Coordinate<P>>(
    crane: &MovingCrane<N, J, P>,
    state: &CraneState<N, J>,
    commands: &Commands<J, C>,
    y: &[C; N],
    reaction: MotionResult,
) -> Option<C>
where
    MovingCrane<N, J, P>: Hangs<N, J, P>,
{
    match reaction {
        MotionResult::Rope => crane.rope_force(state, commands, y),
        MotionResult::Drum => {
            let r = &C::reduced(&crane.dynamics, y[0])?;
            Some(crane.drum_friction(&Snapshot { state, r, y, commands }))
        }
        MotionResult::Blows => Some(C::constant(state.blown)),
        MotionResult::SlewingFriction => crane.friction_moment(1, state, commands, y),
        _ => crane.friction_moment(0, state, commands, y),
    }
}

/// Where the load of a crane that slews is seen from its head.
fn seen<C: Calc>(y: &[C; slewing::STATES], reaction: MotionResult) -> C {
    match reaction {
        MotionResult::Swing => slewing::angles(y)[0],
        MotionResult::Side => slewing::angles(y)[1],
        _ => slewing::distance(y),
    }
}

/// Whether a state of the oil or of the mechanism is none of theirs any more.
fn possible<const N: usize>(system: &Hydraulic<N>, present: &hydraulic::PresentCrane<N>) -> bool {
    let y = present.run.states();
    y[2..6].iter().all(|p| p.abs() < 1e12) && y[0].abs() < 1e3 && system.equations(present.modes, &y).is_some()
}

impl<P: Calc> Level<P> {
    #[must_use]
    pub fn dynamics(&self) -> &Dynamics<P> {
        match self {
            Level::Free(motion) => &motion.dynamics,
            Level::Slewing(crane) => &crane.dynamics,
            Level::Fixed(system) => system.dynamics(),
            Level::Hanging(system) => system.dynamics(),
        }
    }
}

impl<P: Coordinate<P>> Level<P> {
    pub fn set_inputs(&mut self, inputs: &Inputs<P>) {
        match self {
            Level::Free(_) | Level::Slewing(_) => {}
            Level::Fixed(system) => tell(system, inputs),
            Level::Hanging(system) => tell(system, inputs),
        }
    }

    /// Rates of the states `y`; `None` where the linkage does not close.
    pub fn rates(
        &self,
        present: &Present,
        inputs: &Inputs<P>,
        y: &[P; MOST_STATES],
        rates: &mut [P; MOST_STATES],
    ) -> Option<()> {
        match (self, present) {
            (Level::Free(motion), Present::Free(state)) => {
                put(rates, &motion.rates(state, &inputs.of(), first(y))?);
            }
            (Level::Slewing(crane), Present::Slewing(state)) => {
                put(rates, &crane.rates(state, &inputs.of(), first(y))?);
            }
            (Level::Fixed(system), Present::Fixed(at)) => put(rates, &system.equations(at.modes, first(y))?),
            (Level::Hanging(system), Present::Hanging(at)) => put(rates, &system.equations(at.modes, first(y))?),
            _ => unreachable!("{OTHER}"),
        }
        Some(())
    }

    /// Numbers whose change of sign is an event, in states `y`; `None` where the linkage does not close.
    pub fn indicators(
        &self,
        present: &Present,
        inputs: &Inputs<P>,
        y: &[P; MOST_STATES],
        indicators: &mut [P; MOST_INDICATORS],
    ) -> Option<()> {
        match (self, present) {
            (Level::Free(motion), Present::Free(state)) => {
                put(indicators, &motion.indicators(state, &inputs.of(), first(y))?);
            }
            (Level::Slewing(crane), Present::Slewing(state)) => {
                put(indicators, &crane.indicators(state, &inputs.of(), first(y))?);
            }
            (Level::Fixed(system), Present::Fixed(at)) => oil_indicators(system, at.modes, first(y), indicators)?,
            (Level::Hanging(system), Present::Hanging(at)) => oil_indicators(system, at.modes, first(y), indicators)?,
            _ => unreachable!("{OTHER}"),
        }
        Some(())
    }

    /// A result that only this level has; `None` where the linkage does not close.
    pub fn reaction(
        &self,
        present: &Present,
        inputs: &Inputs<P>,
        y: &[P; MOST_STATES],
        reaction: MotionResult,
    ) -> Option<P> {
        match (self, present, reaction) {
            (Level::Slewing(_), _, MotionResult::Swing | MotionResult::Side | MotionResult::Distance) => {
                Some(seen(first(y), reaction))
            }
            (Level::Free(crane), Present::Free(state), _) => {
                reaction_of(crane, state, &inputs.of(), first(y), reaction)
            }
            (Level::Slewing(crane), Present::Slewing(state), _) => {
                reaction_of(crane, state, &inputs.of(), first(y), reaction)
            }
            (Level::Fixed(system), Present::Fixed(at), _) => oil_reaction(system, at.modes, first(y), reaction),
            (Level::Hanging(system), Present::Hanging(at), _) => oil_reaction(system, at.modes, first(y), reaction),
            _ => unreachable!("{OTHER}"),
        }
    }
}

impl<P: Posing<P>> Level<P> {
    /// Forces of the motion in states `y`; `None` where linkage or balance do not close.
    pub fn forces(&self, present: &Present, inputs: &Inputs<P>, y: &[P; MOST_STATES]) -> Option<ForcesInMotion<P>> {
        let dynamics = self.dynamics();
        let mut rates = *y;
        self.rates(present, inputs, y, &mut rates)?;
        let pose = P::pose(dynamics, y[0])?;
        // Where slewing and load begin, behind the angle, its rate and the oil.
        let own = match present {
            Present::Fixed(_) | Present::Hanging(_) => &y[FIXED..],
            Present::Free(_) | Present::Slewing(_) => &y[2..],
        };
        let slews = dynamics.turntable().is_some();
        let pull = match dynamics.bodies().pendulum {
            Some(_) => {
                let pull = self.reaction(present, inputs, y, MotionResult::Rope)?;
                let direction = if slews {
                    to_load(Vector3::new(own[2], own[3], own[4])).1.xy()
                } else {
                    directions(own[0]).0
                };
                Some(rope_on_head(pull, direction))
            }
            None => None,
        };
        let together = self.reaction(present, inputs, y, MotionResult::Friction)?;
        let JointDrive { moment, brake } = inputs.drives[0];
        let shares = |bar, friction| Shares::new(bar, together, y[1], friction, [moment, brake]);
        let by_oil = || pose.drive.map_or(P::constant(0.0), |(_, [_, arm])| arm);
        let shares = match (self, present) {
            (Level::Free(motion), Present::Free(state)) => shares(state.joints[0], &motion.joints[0].friction),
            (Level::Slewing(crane), Present::Slewing(state)) => shares(state.joints[0], &crane.joints[0].friction),
            (Level::Fixed(system), _) => system.shares(first(y), by_oil()),
            (Level::Hanging(system), _) => system.shares(first(y), by_oil()),
            _ => unreachable!("{OTHER}"),
        };
        let at = Instant {
            omega: y[1],
            alpha: rates[1],
            turning: slews.then(|| own[1]),
            pull,
            shares,
        };
        Some(ForcesInMotion::new(&pose, &at, P::of(dynamics.bodies().gravity)))
    }
}

impl Level {
    /// Decides what follows at an instant. The events of oil are kinks, where nothing is to be decided, and what
    /// the implicit solver has solved ahead ends before the next event.
    ///
    /// # Errors
    /// The linkage does not close.
    pub fn event(&self, present: &mut Present, inputs: &Inputs) -> Result<(), Halt> {
        match (self, present) {
            (Level::Free(crane), Present::Free(state)) => crane.event(state, &inputs.of()).map(|_| ()),
            (Level::Slewing(crane), Present::Slewing(state)) => crane.event(state, &inputs.of()).map(|_| ()),
            (Level::Fixed(system), Present::Fixed(present)) => oil_event(system, present),
            (Level::Hanging(system), Present::Hanging(present)) => oil_event(system, present),
            _ => unreachable!("{OTHER}"),
        }
    }

    /// Which of the states are rates of the bodies, the last one that of the rope: behind the angle and the oil come the
    /// states of slewing and of the load in space, or of the load in the plane.
    fn rates_of(&self, present: &Present) -> &'static [usize] {
        let oil = matches!(present, Present::Fixed(_) | Present::Hanging(_));
        match (oil, self.dynamics().turntable().is_some()) {
            (false, false) => &[1, 3, 6, 7],
            (false, true) => &[1, 3, 7, 8, 9, 11],
            (true, false) => &[1, 9, 12, 13],
            (true, true) => &[1, 9, 13, 14, 15, 17],
        }
    }

    /// The bodies where they are, at rest.
    pub(crate) fn still(&self, present: &Present) -> Present {
        let (mut still, mut states) = (*present, present.states());
        for &rate in self.rates_of(present) {
            states[rate] = 0.0;
        }
        still.set_states(&states);
        still
    }

    /// Moves on by a duration, in s; `step` is the longest explicit step (s), `relative` the
    /// tolerance of the implicit solver. Returns the work done.
    ///
    /// # Errors
    /// See [`Halt`].
    pub fn advance(
        &self,
        present: &mut Present,
        inputs: &Inputs,
        duration: f64,
        step: f64,
        relative: f64,
    ) -> Result<Count, Halt> {
        match (self, present) {
            (Level::Free(crane), Present::Free(state)) => crane.advance(state, &inputs.of(), duration, step),
            (Level::Slewing(crane), Present::Slewing(state)) => crane.advance(state, &inputs.of(), duration, step),
            (Level::Fixed(system), Present::Fixed(present)) => oil_advance(system, present, duration, step, relative),
            (Level::Hanging(system), Present::Hanging(present)) => {
                oil_advance(system, present, duration, step, relative)
            }
            _ => unreachable!("{OTHER}"),
        }
    }
}

/// Powers at one instant, in W; losses are positive.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Powers {
    /// Of the drives of luffing and slewing, of the hoist, and of the pump.
    pub drive: f64,
    pub slewing: f64,
    pub hoist: f64,
    pub pump: f64,
    /// What friction, brakes and end stops take.
    pub friction: f64,
    /// What edges, lines, relief valves and leakage take.
    pub throttles: f64,
    /// What compresses the oil.
    pub compression: f64,
}

impl Level {
    /// Powers, and the energy of all bodies (J); `None` where the linkage does not close.
    pub(crate) fn powers(&self, present: &Present, inputs: &Inputs) -> Option<(Powers, f64)> {
        match (self, present) {
            (Level::Free(crane), Present::Free(state)) => powers_of(crane, state, &inputs.of()),
            (Level::Slewing(crane), Present::Slewing(state)) => powers_of(crane, state, &inputs.of()),
            (Level::Fixed(system), Present::Fixed(at)) => oil_powers(system, at),
            (Level::Hanging(system), Present::Hanging(at)) => oil_powers(system, at),
            _ => unreachable!("{OTHER}"),
        }
    }
}

fn powers_of<const N: usize, const J: usize>(
    crane: &MovingCrane<N, J>,
    state: &CraneState<N, J>,
    commands: &Commands<J>,
) -> Option<(Powers, f64)>
where
    MovingCrane<N, J>: Struck<N, J>,
{
    let (y, hoist) = (&state.y, crane.hoist_powers(state, commands)?);
    let (mut drives, mut friction) = ([0.0; 2], 0.0);
    for (i, drive) in commands.drives.iter().enumerate() {
        let rate = y[2 * i + 1];
        drives[i] = drive.moment * rate;
        friction += -crane.friction_moment(i, state, commands, y)? * rate;
    }
    let powers = Powers {
        drive: drives[0],
        slewing: drives[1],
        hoist: hoist.given,
        friction: friction + hoist.lost,
        ..Powers::default()
    };
    Some((powers, crane.energy(state)?))
}

fn oil_powers<const N: usize>(system: &Hydraulic<N>, at: &hydraulic::PresentCrane<N>) -> Option<(Powers, f64)> {
    let (y, modes) = (at.run.states(), at.modes);
    let [_, arm] = f64::reduced(system.dynamics(), y[0])?.drive;
    let oil = Hydraulic::<N>::oil(&y);
    let [pump, throttles, compression] = system.cylinder.powers(&oil, arm * y[1], system.supply);
    // A crane that slews does so by the state behind its angle.
    let turning = match system.dynamics().turntable() {
        Some(_) => y[FIXED + 1],
        None => 0.0,
    };
    let hoist = system.hoist_powers(modes, &y)?;
    let powers = Powers {
        slewing: system.slewing.moment * turning,
        hoist: hoist.given,
        pump,
        throttles,
        compression,
        friction: -system.reaction(y[0], y[1]) * y[1] - system.slewing_friction(modes, &y)? * turning + hoist.lost,
        ..Powers::default()
    };
    Some((powers, system.energy(modes, &y)?))
}

fn oil_event<const N: usize>(system: &Hydraulic<N>, present: &mut hydraulic::PresentCrane<N>) -> Result<(), Halt> {
    if present.run.is_fresh() {
        return system.event(present);
    }
    let closes = f64::reduced(system.dynamics(), present.run.states()[0]);
    closes.map(|_| ()).ok_or(Halt::Outside)
}

fn oil_advance<const N: usize>(
    system: &Hydraulic<N>,
    present: &mut hydraulic::PresentCrane<N>,
    duration: f64,
    longest: f64,
    relative: f64,
) -> Result<Count, Halt> {
    let before = present.run.count;
    system.advance(present, &tolerance(relative, system.states()), duration, longest)?;
    let work = present.run.count.since(before);
    possible(system, present).then_some(work).ok_or(Halt::Outside)
}

/// Which way a bar moves, as a number, and back; one that is loose always is.
fn way(bar: Bar) -> f64 {
    match bar {
        Bar::Held | Bar::Loose => 0.0,
        Bar::Forward => 1.0,
        Bar::Backward => -1.0,
    }
}

fn bar_of(way: f64) -> Option<Bar> {
    [Bar::Held, Bar::Forward, Bar::Backward]
        .into_iter()
        .find(|bar| self::way(*bar) == way)
}

fn numbers_of<const N: usize, const J: usize>(state: &CraneState<N, J>, numbers: &mut Vec<f64>) {
    numbers.extend(state.y);
    numbers.extend(state.joints.map(way));
    numbers.extend([f64::from(state.taut), way(state.drum.way), state.drum.command]);
    numbers.push(state.blown);
}

fn state_of<const N: usize, const J: usize>(numbers: &[f64]) -> Option<CraneState<N, J>> {
    let (y, modes) = numbers.split_first_chunk::<N>()?;
    let (ways, modes) = modes.split_first_chunk::<J>()?;
    let &[taut, drum, command, blown] = modes else {
        return None;
    };
    let mut joints = [Bar::Held; J];
    for (bar, way) in joints.iter_mut().zip(ways) {
        *bar = bar_of(*way)?;
    }
    Some(CraneState {
        y: *y,
        joints,
        drum: drum_of(drum, command)?,
        taut: taut != 0.0,
        blown,
    })
}

fn drum_of(way: f64, command: f64) -> Option<Drum> {
    let way = bar_of(way)?;
    Some(Drum { way, command })
}

/// Every way of a joint.
const WAYS: [Bar; 3] = [Bar::Held, Bar::Forward, Bar::Backward];
/// Every way in which a load hangs.
const HANGS: [(bool, Drum); 3] = [
    (true, drum(Bar::Held)),
    (true, drum(Bar::Forward)),
    (false, drum(Bar::Held)),
];

const fn drum(way: Bar) -> Drum {
    Drum { way, command: 0.0 }
}

/// The states of this level.
fn first<const N: usize, P>(y: &[P; MOST_STATES]) -> &[P; N] {
    y.first_chunk().expect("no level has more states")
}

fn put<P: Copy>(to: &mut [P], from: &[P]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *from;
    }
}

impl Present {
    /// The states, the rest being zero.
    #[must_use]
    pub fn states(&self) -> [f64; MOST_STATES] {
        let mut y = [0.0; MOST_STATES];
        match self {
            Present::Free(state) => put(&mut y, &state.y),
            Present::Slewing(state) => put(&mut y, &state.y),
            Present::Fixed(present) => put(&mut y, &present.run.states()),
            Present::Hanging(present) => put(&mut y, &present.run.states()),
        }
        y
    }

    /// Takes over states from outside; what a solver knew ahead is dropped.
    pub fn set_states(&mut self, values: &[f64]) {
        match self {
            Present::Free(state) => put(&mut state.y, values),
            Present::Slewing(state) => put(&mut state.y, values),
            Present::Fixed(present) => present.set_states(values),
            Present::Hanging(present) => present.set_states(values),
        }
    }

    /// The oil, if there is any.
    #[must_use]
    pub fn oil(&self) -> Option<Oil<f64>> {
        match self {
            Present::Free(_) | Present::Slewing(_) => None,
            Present::Fixed(present) => Some(Hydraulic::<FIXED>::oil(&present.run.states())),
            Present::Hanging(present) => Some(Hydraulic::<{ hydraulic::MOST }>::oil(&present.run.states())),
        }
    }

    /// Least pressure of the oil so far, in Pa; infinite without oil.
    #[must_use]
    pub fn least_pressure(&self) -> f64 {
        let so_far = match self {
            Present::Free(_) | Present::Slewing(_) => f64::INFINITY,
            Present::Fixed(present) => present.run.least,
            Present::Hanging(present) => present.run.least,
        };
        self.oil().map_or(so_far, |oil| so_far.min(oil.least().1))
    }

    /// Which state is the rate at which the rope is paid out; of a crane without one it is zero.
    #[must_use]
    pub fn winding(&self, slews: bool) -> usize {
        let oil = matches!(self, Present::Fixed(_) | Present::Hanging(_));
        let own = if slews { slewing::STATES } else { motion::STATES };
        if oil { FIXED + own - 3 } else { own - 1 }
    }

    /// The rate at which the rope is paid out, in m/s.
    #[must_use]
    pub fn paid_out(&self, slews: bool) -> f64 {
        match self {
            Present::Fixed(_) => 0.0,
            _ => self.states()[self.winding(slews)],
        }
    }

    /// The drum of the hoist.
    #[must_use]
    pub fn drum(&self) -> Drum {
        match self {
            Present::Free(state) => state.drum,
            Present::Slewing(state) => state.drum,
            Present::Fixed(present) => present.modes.drum,
            Present::Hanging(present) => present.modes.drum,
        }
    }

    /// Energy that blows have taken so far, in J.
    #[must_use]
    pub fn blown(&self) -> f64 {
        match self {
            Present::Free(state) => state.blown,
            Present::Slewing(state) => state.blown,
            Present::Hanging(present) => present.modes.blown,
            Present::Fixed(_) => 0.0,
        }
    }

    /// The load hangs by the stretch (m) of a rope that carries it at rest.
    pub fn stretch(&mut self, stretch: f64, slews: bool) {
        let mut y = self.states();
        let first = match self {
            Present::Free(_) | Present::Slewing(_) => 2,
            Present::Fixed(_) => return,
            Present::Hanging(_) => FIXED,
        };
        if slews {
            let (place, length) = (first + 2..first + 5, y[first + 8]);
            // As much of its weight as lies along the rope.
            let along = -y[first + 3] / length;
            for y in &mut y[place] {
                *y *= 1.0 + stretch * along / length;
            }
        } else {
            y[first + 3] += stretch * directions(y[first]).1.x;
        }
        self.set_states(&y);
    }

    /// Which way a drum with a motor goes is decided again.
    pub fn free_drum(&mut self) {
        let drum = Drum::at(0.0);
        match self {
            Present::Free(state) => state.drum = drum,
            Present::Slewing(state) => state.drum = drum,
            Present::Hanging(present) => present.modes.drum = drum,
            Present::Fixed(_) => {}
        }
    }

    /// The load moves as fast along its rope as that is paid out.
    pub fn follow(&mut self, slews: bool) {
        let (mut y, rate) = (self.states(), self.paid_out(slews));
        let first = match self {
            Present::Free(_) | Present::Slewing(_) => 2,
            Present::Fixed(_) => return,
            Present::Hanging(_) => FIXED,
        };
        if slews {
            let place = Vector3::new(y[first + 2], y[first + 3], y[first + 4]);
            let along = to_load(place).1 * rate;
            y[first + 5..first + 8].copy_from_slice(along.as_slice());
        } else {
            y[first + 4] = rate;
        }
        self.set_states(&y);
    }

    /// The hoist runs as commanded, at a rate of paying out (m/s).
    pub fn wind(&mut self, rate: f64, slews: bool) {
        let place = self.winding(slews);
        match self {
            Present::Free(state) => state.wind(rate),
            Present::Slewing(state) => state.wind(rate),
            Present::Hanging(present) => present.wind(rate, place),
            Present::Fixed(_) => {}
        }
    }

    /// The load hangs on the rope, if there is one.
    #[must_use]
    pub fn is_taut(&self) -> bool {
        match self {
            Present::Free(state) => state.taut,
            Present::Slewing(state) => state.taut,
            Present::Fixed(present) => present.modes.taut,
            Present::Hanging(present) => present.modes.taut,
        }
    }

    /// States of this level in every one of its ways of moving, with no number that is special: over a
    /// range of the angle and beyond its ends (rad), relief valves that open at `opening` (Pa) open and closed.
    #[must_use]
    pub fn lively(&self, [from, to]: [f64; 2], opening: f64, slews: bool) -> Vec<Present> {
        let mut found = Vec::new();
        for part in [-1e-3, 0.217, 0.613, 0.871, 1.001] {
            let theta = from + part * (to - from);
            for sign in [1.0, -1.0] {
                let swinging = [theta, 0.113 * sign, 0.231, -0.119 * sign];
                let aside = [0.31, -0.83, 0.27, 0.17, 0.071, -0.053];
                let oil = |p: f64| [1.07 * p, 0.93 * p, 0.71 * p, 0.41 * p, 0.31 * sign, 1.7];
                match self {
                    Present::Free(state) => {
                        let mut y = state.y;
                        put(&mut y, &swinging);
                        (y[5], y[6]) = (0.93 * y[4], 0.57);
                        for bar in WAYS {
                            for (taut, drum) in HANGS {
                                let mut now = *state;
                                (now.y, now.joints, now.drum, now.taut) = (y, [bar], drum, taut);
                                found.push(Present::Free(now));
                            }
                        }
                    }
                    Present::Slewing(state) => {
                        let mut y = state.y;
                        put(&mut y, &[theta, 0.231, 0.113 * sign, -0.119 * sign]);
                        put(&mut y[4..], &aside.map(|x| x * state.y[10]));
                        for luffing in WAYS {
                            for turning in WAYS {
                                for (taut, drum) in HANGS {
                                    let mut now = *state;
                                    (now.y, now.joints, now.drum, now.taut) = (y, [luffing, turning], drum, taut);
                                    found.push(Present::Slewing(now));
                                }
                            }
                        }
                    }
                    Present::Fixed(present) => {
                        let mut y = present.run.states();
                        put(&mut y, &swinging[..2]);
                        for p in [0.3, 2.0] {
                            put(&mut y[2..], &oil(p * opening));
                            found.push(Present::Fixed(hydraulic::PresentCrane::new(y)));
                        }
                    }
                    Present::Hanging(present) => {
                        let mut y = present.run.states();
                        put(&mut y, &swinging[..2]);
                        if slews {
                            put(&mut y[8..], &[0.113 * sign, -0.119 * sign]);
                            let length = y[16];
                            put(&mut y[10..], &aside.map(|x| x * length));
                        } else {
                            let length = y[10];
                            put(&mut y[8..], &[swinging[2], swinging[3], length, 0.93 * length, 0.57]);
                        }
                        for p in [0.3, 2.0] {
                            put(&mut y[2..], &oil(p * opening));
                            for slewing in WAYS {
                                for (taut, drum) in HANGS {
                                    let mut now = hydraulic::PresentCrane::new(y);
                                    (now.modes.slewing, now.modes.drum, now.modes.taut) = (slewing, drum, taut);
                                    found.push(Present::Hanging(now));
                                }
                            }
                        }
                    }
                }
            }
        }
        found
    }

    /// To be called when an input or a parameter changes.
    pub fn interrupt(&mut self) {
        match self {
            Present::Free(_) | Present::Slewing(_) => {}
            Present::Fixed(present) => present.interrupt(),
            Present::Hanging(present) => present.interrupt(),
        }
    }

    /// All of it as numbers.
    pub fn numbers(&self, numbers: &mut Vec<f64>) {
        match self {
            Present::Free(state) => numbers_of(state, numbers),
            Present::Slewing(state) => numbers_of(state, numbers),
            Present::Fixed(present) => numbers.extend(present.run.numbers()),
            Present::Hanging(present) => {
                numbers.extend(present.run.numbers());
                let Modes {
                    slewing,
                    drum,
                    taut,
                    blown,
                } = present.modes;
                numbers.extend([way(slewing), f64::from(taut), way(drum.way), drum.command, blown]);
            }
        }
    }

    /// What [`numbers`](Present::numbers) gave, of this level, and the numbers that follow it.
    #[must_use]
    pub fn of<'a>(&self, numbers: &'a [f64]) -> Option<(Present, &'a [f64])> {
        let count = {
            let mut own = Vec::new();
            self.numbers(&mut own);
            own.len()
        };
        let (own, rest) = numbers.split_at_checked(count)?;
        if own.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let found = match self {
            Present::Free(_) => Present::Free(state_of(own)?),
            Present::Slewing(_) => Present::Slewing(state_of(own)?),
            Present::Fixed(_) => Present::Fixed(hydraulic::PresentCrane {
                run: Run::of(own)?,
                modes: Modes::AT_REST,
            }),
            Present::Hanging(_) => {
                let (run, &[slewing, taut, drum, command, blown]) = own.split_last_chunk()?;
                Present::Hanging(hydraulic::PresentCrane {
                    run: Run::of(run)?,
                    modes: Modes {
                        slewing: bar_of(slewing)?,
                        drum: drum_of(drum, command)?,
                        taut: taut != 0.0,
                        blown,
                    },
                })
            }
        };
        Some((found, rest))
    }
}
