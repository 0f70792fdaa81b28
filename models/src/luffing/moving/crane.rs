//! A crane that moves: joints with friction that truly sticks, brakes and end stops, and the load on a rope that is
//! reeled in and out, and may go slack.
//!
//! Between events the motion is smooth and solved by the explicit Runge-Kutta method of fourth order. What ends a
//! smooth piece is an [indicator](MovingCrane::indicators) below zero; what follows is decided by
//! [`MovingCrane::event`]. Blows (an end stop, a rope that becomes taut) are plastic: no bouncing, no energy gained.
//! How the load hangs is told by [`Hangs`] and [`Struck`]: in the mechanism's plane in
//! [`motion`](crate::luffing::moving::motion), in space in [`slewing`](crate::luffing::moving::space).

use crate::kernel::calc::Calc;
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::reduced::Reduced;
use crate::luffing::moving::symbols as s;
use crate::parts::ground::Raised;
use crate::parts::hoist::{Drum, Elastic, Hoist, HoistCommand, RopeAction};
use crate::parts::joint::{Arrival, Bar, Joint, JointDrive, LOOSE, above_zero};
use crate::parts::solver::{Halt, finite};

/// What drives J joints and the hoist; constant over a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Commands<const J: usize, P = f64> {
    /// Of luffing, then of slewing; a positive moment raises the driven bar.
    pub drives: [JointDrive<P>; J],
    pub hoist: HoistCommand<P>,
    /// Torque of the brakes that act on the shaft of luffing's motor, in N·m.
    pub shaft: P,
}

impl<const J: usize> Commands<J> {
    /// A time (s) later, where they change at these rates.
    #[must_use]
    pub(super) fn changed(&self, slopes: &Commands<J>, time: f64) -> Commands<J> {
        let drive = |now: &JointDrive, slope: &JointDrive| JointDrive {
            moment: now.moment + slope.moment * time,
            brake: now.brake + slope.brake * time,
        };
        Commands {
            drives: std::array::from_fn(|i| drive(&self.drives[i], &slopes.drives[i])),
            hoist: HoistCommand {
                speed: self.hoist.speed + slopes.hoist.speed * time,
                drive: drive(&self.hoist.drive, &slopes.hoist.drive),
            },
            shaft: self.shaft,
        }
    }
}

/// A motion at one instant: angle and rate of each joint, the load, the rope; the last of its N states is the rate at
/// which the rope is paid out; rad, m, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CraneState<const N: usize, const J: usize> {
    pub y: [f64; N],
    pub joints: [Bar; J],
    pub drum: Drum,
    /// The load hangs on the rope, or flies free.
    pub taut: bool,
    /// It stands on the ground.
    pub grounded: bool,
    /// Where the rope that drives luffing is slack: the angle (rad) at which it is taut again.
    pub slack: Option<f64>,
    /// Where the rope of its drive is slack: what the drum does that it is on, which pays out forward.
    pub unwound: Option<Bar>,
    /// Energy that blows have taken so far, in J; what they gave counts negative.
    pub blown: f64,
}

impl<const N: usize, const J: usize> CraneState<N, J> {
    /// At rest, until it is decided what follows.
    #[must_use]
    pub fn held(y: [f64; N]) -> CraneState<N, J> {
        CraneState {
            y,
            joints: [Bar::Held; J],
            drum: Drum::at(0.0),
            taut: true,
            grounded: false,
            slack: None,
            unwound: None,
            blown: 0.0,
        }
    }

    /// With all else that there is to know of it.
    pub(crate) fn at<'a>(&'a self, r: &'a Reduced<f64>, commands: &'a Commands<J>) -> Snapshot<'a, N, J, f64> {
        Snapshot {
            state: self,
            r,
            y: &self.y,
            commands,
        }
    }
}

/// A mechanism that moves by J joints, luffing first, with N states: its own, and those of a drum.
#[derive(Clone)]
pub struct MovingCrane<const N: usize, const J: usize, P = f64> {
    pub dynamics: Dynamics<P>,
    pub joints: [Joint<P>; J],
}

/// Length of a rope, in m, of which nothing is left.
pub(crate) const REELED_IN: f64 = 1e-4;
/// Rounding of a place, over its size, that an event leaves as it is.
pub(crate) const FEW: f64 = 16.0 * f64::EPSILON;
/// Changes at one instant.
pub(crate) const MOST_CHANGES: u32 = 16;
/// States of a drum behind those of the crane: slack, and speed.
pub const DRUM: usize = 2;
/// Event indicators of a drive's rope: it becomes slack or taut, the drum of a slack one comes to rest or (two) breaks loose.
pub(super) const HAULING_ENDS: usize = 3;
/// Most event indicators: four for each of two joints, that of the rope, two of the hoist, that of the ground, and those of a
/// drive's rope.
pub const MOST_INDICATORS: usize = 12 + HAULING_ENDS;

/// A crane over any scalar: how it moves between events, what the mechanism is at its angle, states and commands.
#[derive(Clone, Copy, Debug)]
pub struct Snapshot<'a, const N: usize, const J: usize, C> {
    pub state: &'a CraneState<N, J>,
    pub r: &'a Reduced<C>,
    pub y: &'a [C; N],
    pub commands: &'a Commands<J, C>,
}

/// How the load hangs and moves, between events.
pub trait Hangs<const N: usize, const J: usize, P: Calc> {
    /// How many states there are of a crane whose drive has no rope that goes slack: the last one is the rate at which the load's
    /// rope is paid out.
    const OWN: usize;

    /// Which of the states is the rope's length.
    const LENGTH: usize;

    /// How joints and load accelerate.
    type Accelerations<C: Calc>;

    /// Distance of the load from the head (m), and how fast it goes away from it (m/s).
    fn reach<C: Calc>(y: &[C; N]) -> [C; 2];

    fn accelerations<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> Self::Accelerations<C>;

    /// Rates of all states but that of the hoist.
    fn rates_by<C: Coordinate<P>>(&self, a: &Self::Accelerations<C>, at: &Snapshot<N, J, C>) -> [C; N];

    /// Force of a taut rope, in N.
    fn tension_by<C: Coordinate<P>>(&self, a: &Self::Accelerations<C>, at: &Snapshot<N, J, C>) -> C;

    /// Its sign, that of an empty hook too.
    fn slackening_by<C: Coordinate<P>>(&self, a: &Self::Accelerations<C>, at: &Snapshot<N, J, C>) -> C;

    /// The load above ground at a height (m).
    fn raised<C: Coordinate<P>>(&self, ground: P, at: &Snapshot<N, J, C>) -> Raised<C>;

    /// Force of the air over the mass of the load (m/s²), and the power over mass that it takes (W/kg), where there is any.
    fn felt<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> Option<[C; 2]>;

    /// Moment that friction, brake and stops must give to hold joint `i` at rest, in N·m.
    fn needs<C: Coordinate<P>>(&self, i: usize, at: &Snapshot<N, J, C>) -> C;
}

/// What changes at once.
pub trait Struck<const N: usize, const J: usize>: Hangs<N, J, f64> {
    /// Whether what moves has another rate than before.
    fn jumped(before: &CraneState<N, J>, after: &CraneState<N, J>) -> bool;

    /// The rate of a rope that keeps its length has jumped from `before` by `jump` (m/s): it lets go, or gives the load a
    /// blow.
    ///
    /// # Errors
    /// The linkage does not close.
    fn wound(&self, state: &mut CraneState<N, J>, before: f64, jump: f64) -> Result<(), Halt>;

    /// The rope of the drive is caught: luffing, which is free, gives way to an impulse `way` round, by one over its inertia with
    /// what hangs on it (kg·m²), of which `give` makes the change of its rate (rad/s).
    fn hauled(&self, state: &mut CraneState<N, J>, r: &Reduced<f64>, give: impl FnOnce(f64) -> f64, way: f64);

    /// Joint `i` stops at once; the load goes on.
    fn stopped(&self, i: usize, state: &mut CraneState<N, J>, r: &Reduced<f64>);

    /// A rope that keeps its length lets go where it would push, and catches the load with a plastic blow along itself.
    fn switched(&self, state: &mut CraneState<N, J>, r: &Reduced<f64>, commands: &Commands<J>);

    /// The load is put at rest on ground at a height (m), straight below or above where it is.
    fn put_down(&self, state: &mut CraneState<N, J>, r: &Reduced<f64>, ground: f64);

    /// Potential energy of the load over its mass (J/kg), and the square of its speed against the ground (m²/s²).
    fn height_and_speed(&self, state: &CraneState<N, J>, r: &Reduced<f64>) -> [f64; 2];
}

impl<const N: usize, const J: usize, P: Calc> MovingCrane<N, J, P>
where
    Self: Hangs<N, J, P>,
{
    pub(crate) fn hoist(&self) -> Option<&Hoist<P>> {
        self.dynamics.pendulum().map(|load| &load.hoist)
    }

    /// Whether the rope keeps the load at its end: it is taut, and keeps its length under any force.
    pub(crate) fn is_kept(&self, state: &CraneState<N, J>) -> bool {
        state.taut && self.hoist().is_some_and(|hoist| hoist.rope.is_none())
    }

    /// How the rope acts on the load.
    pub(crate) fn line<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> RopeAction<C> {
        match self.hoist().filter(|_| at.state.taut) {
            None => RopeAction::Slack,
            Some(hoist) => match &hoist.rope {
                None => RopeAction::Taut {
                    rate: at.y[Self::OWN - 1],
                    gain: at.state.drum.ramp(hoist),
                    drum: at.state.drum.turning(hoist, &at.commands.hoist),
                },
                Some(rope) => RopeAction::Force(Self::stretched(rope, at.r, at.y)[1].def(&s::S_R)),
            },
        }
    }

    /// Force of a stretched rope by stiffness alone, and with damping, in N.
    fn stretched<C: Coordinate<P>>(rope: &Elastic<P>, r: &Reduced<C>, y: &[C; N]) -> [C; 2] {
        let [distance, speed] = Self::reach(y);
        let stretch = (distance - y[Self::LENGTH]).def(&s::DELTA_R);
        let rate = speed - r.paid(y[Self::OWN - 1], y[1]);
        let [spring, damping] = rope.forces(stretch, rate.def(&s::D_DELTA_R));
        [spring, spring + damping.def(&s::S_RD)]
    }

    /// Rates of all states between events; `None` where the linkage does not close or nothing is left of the rope.
    #[must_use]
    #[inline]
    pub fn rates<C: Coordinate<P>>(
        &self,
        state: &CraneState<N, J>,
        commands: &Commands<J, C>,
        y: &[C; N],
    ) -> Option<[C; N]> {
        if self.is_reeled_in(y) {
            return None;
        }
        let r = &self.reduced(state, y[0])?;
        Some(self.rates_at(&Snapshot { state, r, y, commands }))
    }

    /// Its slewing angle (rad), where it slews.
    pub(crate) fn slewed<C: Copy>(y: &[C; N]) -> Option<C> {
        (J > 1).then(|| y[2])
    }

    /// Whether nothing is left of the rope.
    pub(crate) fn is_reeled_in<C: Calc>(&self, y: &[C; N]) -> bool {
        self.hoist().is_some() && y[Self::LENGTH].value() <= REELED_IN
    }

    /// The same where it is known what the mechanism is at this angle.
    #[inline]
    pub(crate) fn rates_at<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> [C; N] {
        let a = self.accelerations(at);
        let mut out = self.rates_by(&a, at);
        if let Some(hoist) = self.hoist() {
            let rope = || match at.state.taut {
                true => self.tension_by(&a, at),
                false => C::constant(0.0),
            };
            if let Some(gain) = at.state.drum.gain(hoist, &at.commands.hoist, rope) {
                out[Self::OWN - 1] = gain.def(&s::D_V_R);
            }
        }
        if let Some(drum) = self.unwinding(at) {
            out[Self::OWN..].copy_from_slice(&drum);
        }
        out
    }

    /// Moment that friction, brake and stops must give to hold a joint at rest, in N·m, with the least and
    /// greatest that they can.
    fn held<C: Coordinate<P>>(&self, i: usize, at: &Snapshot<N, J, C>) -> [C; 3] {
        let hold = self.needs(i, at);
        let [rising, falling] = self.drives(i, at.state, at.commands, at.r.geared());
        let holds = |drive| self.joints[i].over().holds(at.y[2 * i], drive);
        [hold, holds(&rising)[0], holds(&falling)[1]]
    }

    /// Force of the rope on the load towards the head, in N; zero where it is slack or there is none.
    pub(crate) fn tension<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> C {
        if self.hoist().is_none() || !at.state.taut {
            return C::constant(0.0);
        }
        self.tension_by(&self.accelerations(at), at)
    }

    /// The same where only the states are known; `None` where the linkage does not close.
    #[must_use]
    pub fn rope_force<C: Coordinate<P>>(
        &self,
        state: &CraneState<N, J>,
        commands: &Commands<J, C>,
        y: &[C; N],
    ) -> Option<C> {
        let r = &self.reduced(state, y[0])?;
        Some(self.tension(&Snapshot { state, r, y, commands }))
    }

    /// Moment of friction, brake and end stop on luffing (0) or slewing (1), in N·m, in the direction of the angle.
    #[must_use]
    pub fn friction_moment<C: Coordinate<P>>(
        &self,
        i: usize,
        state: &CraneState<N, J>,
        commands: &Commands<J, C>,
        y: &[C; N],
    ) -> Option<C> {
        let r = &self.reduced(state, y[0])?;
        Some(self.friction_at(i, &Snapshot { state, r, y, commands }))
    }

    /// The same where it is known what the mechanism is at this angle.
    pub(crate) fn friction_at<C: Coordinate<P>>(&self, i: usize, at: &Snapshot<N, J, C>) -> C {
        let drive = self.drive(i, at);
        let resistance = match at.state.joints[i] {
            Bar::Held => self.needs(i, at),
            bar => {
                let resistance = self.joints[i].over().resistance(bar, at.y[2 * i + 1], &drive);
                resistance.def([&s::M_R, &s::M_R_SL][i])
            }
        };
        let more = self.kept_back(&drive, &at.commands.drives[i]);
        more.map_or(resistance, |more| resistance + more)
    }

    /// Numbers whose fall below zero ends a smooth piece: each joint comes to rest or (two) breaks loose, meets its lower or
    /// its upper stop; the rope becomes slack or taut; the hoist runs as commanded, or comes to rest or (two) breaks loose;
    /// the load touches the ground or is lifted; the drive's rope becomes slack or taut, its drum rests or (two) breaks loose.
    /// After an event all are above zero.
    #[must_use]
    pub fn indicators<C: Coordinate<P>>(
        &self,
        state: &CraneState<N, J>,
        commands: &Commands<J, C>,
        y: &[C; N],
    ) -> Option<[C; MOST_INDICATORS]> {
        let r = &self.reduced(state, y[0])?;
        Some(self.indicators_at(&Snapshot { state, r, y, commands }))
    }

    /// The same where it is known what the mechanism is at this angle.
    pub(crate) fn indicators_at<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> [C; MOST_INDICATORS] {
        let Snapshot { state, y, commands, .. } = *at;
        let mut out = [C::constant(1.0); MOST_INDICATORS];
        for i in 0..J {
            let held = || self.held(i, at);
            let mut joint = self.joints[i].over();
            if let (0, Some(caught)) = (i, state.slack) {
                joint.stops[0] = joint.stops[0].max(caught);
            }
            let of_joint = joint.indicators(state.joints[i], [y[2 * i], y[2 * i + 1]], held);
            out[4 * i..4 * i + 4].copy_from_slice(&of_joint);
        }
        if let Some(hoist) = self.hoist() {
            out[4 * J] = self.slackening(hoist, at);
            let reaching = (state.drum).reaching(hoist, &commands.hoist, y[Self::OWN - 1], || self.tension(at));
            out[4 * J + 1..4 * J + 3].copy_from_slice(&reaching);
        }
        if let Some(ground) = self.dynamics.ground() {
            out[4 * J + 3] = self.grounding(ground, at);
        }
        if let Some(ends) = Self::HAULED.then(|| self.hauling_ends(at)).flatten() {
            out[4 * J + 4..4 * J + 4 + HAULING_ENDS].copy_from_slice(&ends);
        }
        out.map(above_zero)
    }

    /// Falls below zero where the rope becomes slack or taut.
    fn slackening<C: Coordinate<P>>(&self, hoist: &Hoist<P>, at: &Snapshot<N, J, C>) -> C {
        match &hoist.rope {
            Some(rope) => Elastic::<P>::slackening(at.state.taut, Self::stretched(rope, at.r, at.y)),
            None if at.state.taut => self.slackening_by(&self.accelerations(at), at),
            None => at.y[Self::LENGTH] * C::constant(LOOSE) - Self::reach(at.y)[0],
        }
    }

    /// Force of the air on the load, in N, and the power that it takes, in W.
    pub(crate) fn in_air<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> [C; 2] {
        let mass = self.dynamics.pendulum().map(|load| C::of(load.mass));
        let felt = mass.zip(self.felt(at));
        felt.map_or([C::constant(0.0); 2], |(mass, felt)| felt.map(|of| mass * of))
    }

    /// Moment of brake and friction on the drum of a motor, in N·m; positive reels in.
    pub(crate) fn drum_friction<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> C {
        let friction = |hoist: &Hoist<P>| (at.state.drum).friction(hoist, &at.commands.hoist, self.tension(at));
        self.hoist().map_or(C::constant(0.0), friction)
    }
}

impl<const N: usize, const J: usize> MovingCrane<N, J>
where
    Self: Struck<N, J>,
{
    /// Decides what follows at an instant, as often as one event causes another. Returns whether anything changed.
    ///
    /// # Errors
    /// The linkage does not close, or a number overflows.
    pub fn event(&self, state: &mut CraneState<N, J>, commands: &Commands<J>) -> Result<bool, Halt> {
        let first = *state;
        for i in 0..J {
            if state.y[2 * i + 1] == 0.0 && state.joints[i] != Bar::Loose {
                // At rest it is decided again which way it goes, as the commands may have changed.
                state.joints[i] = Bar::Held;
            }
        }
        self.wind(state, commands)?;
        Self::turn_drum(state);
        for _ in 0..MOST_CHANGES {
            let before = *state;
            let mut r = self.reduced(state, state.y[0]).ok_or(Halt::Outside)?;
            for i in 0..J {
                self.stop_joint(i, state, &r);
            }
            if Self::HAULED {
                self.haul(state, commands)?;
                r = self.reduced(state, state.y[0]).ok_or(Halt::Outside)?;
            }
            if self.dynamics.is_pulled() {
                state.tighten(&commands.drives[0]);
            }
            match self.hoist().map(|hoist| &hoist.rope) {
                None => {}
                Some(Some(rope)) => state.taut = Elastic::<f64>::pulls(state.taut, Self::stretched(rope, &r, &state.y)),
                Some(None) => self.switched(state, &r, commands),
            }
            self.land(state, &r, commands);
            for i in 0..J {
                if state.joints[i] == Bar::Held {
                    state.joints[i] = Bar::loosened(self.held(i, &state.at(&r, commands)));
                }
            }
            self.loosen_drum(state, &r, commands);
            if let Some(hoist) = self.hoist() {
                let rope = || self.tension(&state.at(&r, commands));
                let mut drum = state.drum;
                drum.loosen(hoist, &commands.hoist, rope);
                state.drum = drum;
            }
            if *state == before {
                break;
            }
        }
        // A rope without length has no direction.
        if !finite(&state.y) {
            return Err(Halt::Outside);
        }
        let caught = first.unwound.is_some() && state.unwound.is_none();
        if Self::jumped(&first, state) || caught || first.grounded != state.grounded {
            state.blown += self.lost(&first, state);
        }
        Ok(*state != first)
    }

    /// The hoist follows its command. Where it does so at once the load goes on as it did.
    fn wind(&self, state: &mut CraneState<N, J>, commands: &Commands<J>) -> Result<(), Halt> {
        let Some(hoist) = self.hoist() else {
            return Ok(());
        };
        let before = state.y[Self::OWN - 1];
        let (drum, rate, jump) = state.drum.decided(hoist, before, &commands.hoist);
        (state.drum, state.y[Self::OWN - 1]) = (drum, rate);
        if self.is_kept(state) && jump != 0.0 {
            self.wound(state, before, jump)?;
        }
        Ok(())
    }

    /// A joint that has reached a stop, or turned round, is at rest.
    fn stop_joint(&self, i: usize, state: &mut CraneState<N, J>, r: &Reduced<f64>) {
        let (joint, at) = (&self.joints[i], [state.y[2 * i], state.y[2 * i + 1]]);
        match joint.arrival(state.joints[i], at) {
            Arrival::None => {}
            Arrival::SetOff(bar) => state.joints[i] = bar,
            Arrival::Rest { at_stop } => {
                state.joints[i] = Bar::Held;
                if at_stop {
                    // A drum that pays out runs on.
                    let shaft = r
                        .geared()
                        .filter(|shaft| Self::HAULED && i == 0 && shaft.ratio * at[1] > 0.0);
                    if let Some(shaft) = shaft {
                        Self::let_go(state, shaft);
                    }
                    let [low, high] = joint.stops;
                    state.y[2 * i] = at[0].clamp(low, high);
                    self.stopped(i, state, r);
                }
                state.y[2 * i + 1] = 0.0;
            }
        }
    }
}
