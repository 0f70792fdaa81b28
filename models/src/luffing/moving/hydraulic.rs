//! Level `hydraulic`: the driven bar moved by a cylinder with its oil, ports
//! and proportional valve. What else moves is as at the other levels: the load on
//! its rope, reeled and slack at times, and a crane that slews, with friction that
//! truly sticks. [`MovingCrane`](crate::luffing::moving::crane::MovingCrane) has their equations and decides their
//! events; to it the cylinder is a moment on a bar that is [`Bar::Loose`].

use crate::drive::symbols::V_D;
use crate::kernel::calc::{Calc, Over};
use crate::luffing::moving::brakes::Braking;
use crate::luffing::moving::crane::{Commands, CraneState, MOST_CHANGES, Snapshot};
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::motion::{self, MovingLinkage};
use crate::luffing::moving::pendulum::{Phase, Reel};
use crate::luffing::moving::reduced::Reduced;
use crate::luffing::moving::shares::Shares;
use crate::luffing::moving::space::{self, Slewing};
use crate::luffing::moving::symbols as s;
use crate::luffing::moving::weather::Weather;
use crate::parts::hoist::{Drum, HoistCommand, HoistPowers, Winch};
use crate::parts::hydraulics::cylinder::{Cylinder, FLOW_MARGIN, Oil, PART_MARGINS, POWER_MARGIN, UNDERLAP_MARGIN};
use crate::parts::joint::{Bar, Joint, JointDrive};
use crate::parts::solver::rodas::{Run, Tolerance};
use crate::parts::solver::{Gradient, Halt, MOST_IMPLICIT, MOST_KINKS, System};

/// Angular velocity, in rad/s, below which dry friction at the driven bar is in proportion to it.
pub const CREEP: f64 = 1e-4;

/// What counts as much at a kink: parts of the spool's stroke and of a relief valve's opening pressure, and a
/// way into an end stop in rad. Times the tolerance, a step ends as near to it.
const GAP: f64 = 0.1;
const CRACK: f64 = 0.03;
const TOUCH: f64 = 1e-3;

/// States of the oil, which follow on angle and rate of the driven bar.
const OIL: usize = 6;
/// States of a crane of which nothing else moves.
pub const FIXED: usize = 2 + OIL;
/// Most states: those of a crane that slews with its load on a rope.
pub const MOST: usize = space::STATES + OIL;

/// First step of the solver after something has changed at once, in s.
pub const FIRST: f64 = 1e-3;
/// Events in one call.
const MOST_EVENTS: u32 = 10_000;

/// What the cylinder moves, its luffing joint with friction and stops of the hydraulic level: below
/// [`CREEP`] the bar creeps, and a stop is a stiff buffer.
#[derive(Clone)]
pub enum Crane<P = f64> {
    Plane(MovingLinkage<P>),
    Slewing(Slewing<P>),
}

/// A luffing cylinder at work, as a system of at most N states: angle and rate of the driven bar, pressures of
/// ports and chambers, spool and its speed, then the other states of [`MovingLinkage`] or [`Slewing`] in their order, as
/// many as there are.
#[derive(Clone)]
pub struct Hydraulic<const N: usize, P = f64> {
    pub crane: Crane<P>,
    pub cylinder: Cylinder<P>,
    /// The end stops' stiffness (N·m/rad) and damping (N·m·s/rad) beyond them.
    pub buffer: [P; 2],
    /// Command of the valve in [−1, 1]; positive raises the driven bar.
    pub command: P,
    /// Pressure of the pump, in Pa.
    pub supply: P,
    pub hoist: HoistCommand<P>,
    pub slewing: JointDrive<P>,
}

/// How a crane moves between events.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modes {
    /// Luffing, which a cylinder leaves loose, and slewing.
    pub joints: [Bar; 2],
    pub drum: Drum,
    /// The load hangs on the rope, or flies free.
    pub taut: bool,
    /// It stands on the ground.
    pub grounded: bool,
    /// Where a rope that drives luffing is slack: the angle (rad) at which it is taut again.
    pub slack: Option<f64>,
    /// Where that of its drive is: what the drum does that it is on.
    pub unwound: Option<Bar>,
    /// Energy that blows have taken so far, in J; what they gave counts negative.
    pub blown: f64,
    /// Of the brakes on the shaft of luffing's motor.
    pub braking: Braking,
}

/// A crane on its way, with its solver's state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PresentCrane<const N: usize> {
    pub run: Run<N>,
    pub modes: Modes,
}

impl<const N: usize> PresentCrane<N> {
    /// At rest in these states, until it is decided what follows.
    #[must_use]
    pub fn new(y: [f64; N]) -> PresentCrane<N> {
        PresentCrane {
            run: Run::new(y, FIRST),
            modes: Modes::AT_REST,
        }
    }
}

impl Modes {
    /// Until it is decided what follows.
    pub const AT_REST: Modes = Modes {
        joints: [Bar::Held; 2],
        drum: Drum {
            way: Bar::Held,
            command: 0.0,
        },
        taut: true,
        grounded: false,
        slack: None,
        unwound: None,
        blown: 0.0,
        braking: Braking::LIFTED,
    };

    /// A crane of J joints in these states of its own.
    pub(crate) fn crane<C: Calc, const M: usize, const J: usize>(&self, y: &[C; M]) -> CraneState<M, J> {
        CraneState {
            y: y.map(C::value),
            joints: std::array::from_fn(|i| self.joints[i]),
            drum: self.drum,
            taut: self.taut,
            grounded: self.grounded,
            slack: self.slack,
            unwound: self.unwound,
            blown: self.blown,
        }
    }

    /// One that a cylinder luffs, out of all states.
    fn of<C: Calc, const N: usize, const M: usize, const J: usize>(self, y: &[C; N]) -> CraneState<M, J> {
        let joints = [Bar::Loose, self.joints[1]];
        Modes { joints, ..self }.crane(&part(y))
    }

    /// As an event leaves it.
    pub fn follow<const M: usize, const J: usize>(&mut self, state: &CraneState<M, J>) {
        (self.drum, self.taut, self.grounded) = (state.drum, state.taut, state.grounded);
        (self.slack, self.unwound, self.blown) = (state.slack, state.unwound, state.blown);
        self.joints[..J].copy_from_slice(&state.joints);
    }
}

/// The crane's own states out of all.
pub(crate) fn part<C: Calc, const N: usize, const M: usize>(y: &[C; N]) -> [C; M] {
    std::array::from_fn(|i| y[if i < 2 { i } else { i + OIL }])
}

/// And back into all.
pub(crate) fn put<C: Calc, const N: usize, const M: usize>(y: &mut [C; N], part: &[C; M]) {
    y[..2].copy_from_slice(&part[..2]);
    y[FIXED..OIL + M].copy_from_slice(&part[2..]);
}

/// The same of a crane that moves in the plane or in space.
macro_rules! either {
    ($crane:expr, $one:ident => $call:expr) => {
        match $crane {
            Crane::Plane($one) => $call,
            Crane::Slewing($one) => $call,
        }
    };
}

/// The same with all that is known of it, under the moment of its cylinder.
macro_rules! driven {
    ($system:ident, $modes:ident, $y:ident, $crane:ident, $at:ident => $call:expr) => {{
        let r = &Coordinate::reduced($system.dynamics(), $y[0])?;
        let moment = $system.moment(r, $y);
        either!(&$system.crane, $crane => {
            let (state, y, commands) = (&$modes.of($y), &part($y), &$system.asked(moment));
            let $at = &Snapshot { state, r, y, commands };
            $call
        })
    }};
}

impl<const N: usize, P: Calc> Hydraulic<N, P> {
    pub fn oil<C: Calc>(y: &[C; N]) -> Oil<C> {
        Oil {
            ports: [y[2], y[3]],
            chambers: [y[4], y[5]],
            spool: y[6],
            spool_speed: y[7],
        }
    }

    /// Of the cylinder's parts, as [`Cylinder::margins`].
    #[inline]
    pub fn part_margins<C: Over<P>>(&self, y: &[C; N]) -> [Option<C>; PART_MARGINS] {
        self.cylinder.margins(&Self::oil(y), self.supply)
    }

    pub fn dynamics(&self) -> &Dynamics<P> {
        either!(&self.crane, crane => &crane.dynamics)
    }

    /// That of the driven bar.
    fn joint(&self) -> &Joint<P> {
        either!(&self.crane, crane => &crane.joints[0])
    }

    /// Least and greatest angle of the driven bar, in rad.
    #[must_use]
    pub fn stops(&self) -> [f64; 2] {
        self.joint().stops
    }

    /// As [`Dynamics::put_around`].
    pub(crate) fn put_around(&mut self, wind: [P; 2], weather: Weather<P>) {
        either!(&mut self.crane, crane => crane.dynamics.put_around(wind, weather));
    }

    /// Whether there is a rope that keeps its length under any force.
    fn keeps(&self) -> bool {
        self.dynamics().pendulum().is_some_and(|load| load.hoist.rope.is_none())
    }

    /// How many states there are.
    #[must_use]
    pub fn states(&self) -> usize {
        let alone = match &self.crane {
            Crane::Plane(_) => FIXED,
            Crane::Slewing(_) => FIXED + space::RIGID - 2,
        };
        let all = match &self.crane {
            Crane::Plane(_) => FIXED + motion::STATES - 2,
            Crane::Slewing(_) => FIXED + space::STATES - 2,
        };
        // A hoist that follows its command at once has no rate of its own.
        let hangs = self.dynamics().pendulum();
        hangs.map_or(alone, |load| {
            all - usize::from(matches!(load.hoist.winch, Winch::AtOnce))
        })
    }

    /// Angles and rates, pressures, spool and its speed, load and rope; no more than there are. A spool that is known better
    /// than its edges need would cost a quarter of all steps.
    pub(super) fn tolerance(&self, relative: f64) -> Tolerance<N> {
        let mut absolute = [f64::INFINITY; N];
        absolute[..self.states()].fill(relative * 1e-3);
        absolute[2..6].fill(relative * 1e6);
        absolute[6..FIXED].copy_from_slice(&[relative * 0.1, relative * 30.0]);
        Tolerance { relative, absolute }
    }

    /// Moment on the driven bar of cylinder, friction and stops, in N·m.
    #[inline]
    fn moment<C: Coordinate<P>>(&self, r: &Reduced<C>, y: &[C; N]) -> C {
        let [_, arm] = r.drive;
        self.cylinder.force(&Self::oil(y)).def(&s::F_C) * arm + self.reaction(y[0], y[1])
    }

    /// Moment of friction and end stop on the driven bar, in N·m; positive turns it counter-clockwise.
    #[inline]
    pub fn reaction<C: Over<P>>(&self, theta: C, omega: C) -> C {
        let (viscous, dry, stop) = self.resistances(theta, omega);
        let moment = dry.map_or(viscous, |dry| viscous - dry);
        stop.map_or(moment, |stop| moment + stop).def(&s::M_R)
    }

    /// What viscous friction gives, what dry friction takes, and what an end stop gives (N·m).
    #[inline]
    fn resistances<C: Over<P>>(&self, theta: C, omega: C) -> (C, Option<C>, Option<C>) {
        let Joint { friction, stops } = *self.joint();
        let dry = (friction.coulomb.value() > 0.0).then(|| {
            let smooth = (omega.square() + C::known(&s::OMEGA_C, CREEP).square()).sqrt();
            omega.times(friction.coulomb) / smooth
        });
        let mut stop = None;
        let nearest = theta.value().clamp(stops[0], stops[1]);
        if theta.value() != nearest {
            let [low, high] = self.dynamics().names().stops;
            let end = if nearest == stops[0] { low } else { high };
            let depth = theta - C::known(end, nearest);
            let [stiffness, damping] = self.buffer;
            let push = -C::of(stiffness) * depth - C::of(damping) * omega;
            // A stop pushes, and never pulls.
            if push.value() * depth.value() < 0.0 {
                stop = Some(push);
            }
        }
        (-omega.times(friction.viscous), dry, stop)
    }

    /// What turns the driven bar, told apart, with the lever arm of the cylinder (m).
    pub fn shares<C: Over<P>>(&self, y: &[C; N], arm: C) -> Shares<C> {
        let push = self.cylinder.force(&Self::oil(y)).def(&s::F_C);
        let (viscous, dry, stop) = self.resistances(y[0], y[1]);
        let zero = C::constant(0.0);
        let shares = Shares {
            drive: push * arm,
            dry: dry.map_or(zero, |dry| -dry),
            viscous,
            stop: stop.unwrap_or(zero),
            push: Some(push),
            lag: 0.0,
        };
        shares.named()
    }

    /// What is asked of the crane whose luffing is driven by a moment (N·m).
    fn asked<C: Over<P>, const J: usize>(&self, moment: C) -> Commands<J, C> {
        let over = |drive: &JointDrive<P>| JointDrive {
            moment: C::of(drive.moment),
            brake: C::of(drive.brake),
        };
        let luffing = JointDrive {
            moment,
            brake: C::constant(0.0),
        };
        let drives = [luffing, over(&self.slewing)];
        Commands {
            drives: std::array::from_fn(|i| drives[i]),
            hoist: HoistCommand {
                speed: C::of(self.hoist.speed),
                drive: over(&self.hoist.drive),
            },
            shaft: C::constant(0.0),
        }
    }

    /// Equations over any scalar; `None` where the linkage does not close or nothing is left of the rope.
    #[inline]
    pub fn equations<C: Coordinate<P>>(&self, modes: Modes, y: &[C; N]) -> Option<[C; N]> {
        let oil = Self::oil(y);
        let (theta, omega) = (y[0], y[1]);
        let r = C::reduced(self.dynamics(), theta)?;
        let [length, arm] = r.drive;
        let rates = self
            .cylinder
            .rates(&oil, length, (arm * omega).def(&V_D), self.command, self.supply);
        let moment = self.moment(&r, y);
        let mut out = [C::constant(0.0); N];
        if N > FIXED {
            either!(&self.crane, crane => {
                let own = part(y);
                if crane.is_reeled_in(&own) {
                    return None;
                }
                put(&mut out, &crane.rates_at(&Snapshot { state: &modes.of(y), r: &r, y: &own, commands: &self.asked(moment) }));
            });
        } else {
            let still = C::constant(0.0);
            let m = Phase {
                theta,
                omega,
                swing: still,
                swing_rate: still,
            };
            out[0] = omega;
            out[1] = self.dynamics().motion(&r, &m, moment, Reel::still(still))[0];
        }
        out[2..FIXED].copy_from_slice(&[
            rates.ports[0].def(&s::D_P_1),
            rates.ports[1].def(&s::D_P_2),
            rates.chambers[0].def(&s::D_P_A),
            rates.chambers[1].def(&s::D_P_B),
            rates.spool,
            rates.spool_speed.def(&s::D_V_V),
        ]);
        Some(out)
    }

    /// Numbers whose fall below zero ends a smooth piece: slewing comes to rest or (two) breaks loose, meets its
    /// lower or upper stop; the rope becomes slack or taut; the hoist runs as commanded, or comes to rest or (two) breaks
    /// loose; the load touches the ground or is lifted.
    pub fn indicators<C: Coordinate<P>>(&self, modes: Modes, y: &[C; N]) -> Option<[C; 8]> {
        let none = C::constant(1.0);
        if N == FIXED {
            return Some([none; 8]);
        }
        let all = driven!(self, modes, y, crane, at => {
            let all = crane.indicators_at(at);
            // Those of luffing, which is loose, stand first.
            std::array::from_fn(|i| all[i + 4 * crane.joints.len() - 4])
        });
        Some(all)
    }

    /// Force of the rope, in N; zero where it is slack or there is none.
    pub fn rope_force<C: Coordinate<P>>(&self, modes: Modes, y: &[C; N]) -> Option<C> {
        if N == FIXED {
            return Some(C::constant(0.0));
        }
        Some(driven!(self, modes, y, crane, at => crane.tension(at)))
    }

    /// Force of the ground on the load, in N, and its height above it, in m.
    pub fn on_ground<C: Coordinate<P>>(&self, modes: Modes, y: &[C; N]) -> Option<[C; 2]> {
        if N == FIXED {
            return Some([C::constant(0.0); 2]);
        }
        Some(driven!(self, modes, y, crane, at => crane.on_ground(at)))
    }

    /// Force of the air on the load, in N, and the power that it takes, in W.
    pub fn in_air<C: Coordinate<P>>(&self, modes: Modes, y: &[C; N]) -> Option<[C; 2]> {
        if N == FIXED {
            return Some([C::constant(0.0); 2]);
        }
        Some(driven!(self, modes, y, crane, at => crane.in_air(at)))
    }

    /// Moment of brake and friction on the drum of a motor, in N·m; positive reels in.
    pub fn drum_friction<C: Coordinate<P>>(&self, modes: Modes, y: &[C; N]) -> Option<C> {
        if N == FIXED {
            return Some(C::constant(0.0));
        }
        Some(driven!(self, modes, y, crane, at => crane.drum_friction(at)))
    }

    /// Moment of friction, brake and end stop on slewing, in N·m, in the direction of the angle.
    pub fn slewing_friction<C: Coordinate<P>>(&self, modes: Modes, y: &[C; N]) -> Option<C> {
        if N == FIXED || matches!(self.crane, Crane::Plane(_)) {
            return Some(C::constant(0.0));
        }
        Some(driven!(self, modes, y, crane, at => crane.friction_at(1, at)))
    }
}

impl<const N: usize> Hydraulic<N> {
    /// Kinetic and potential energy of all bodies, in J; `None` where the linkage does not close.
    #[must_use]
    pub fn energy(&self, modes: Modes, y: &[f64; N]) -> Option<f64> {
        if N > FIXED {
            return either!(&self.crane, crane => crane.energy(&modes.of(y)));
        }
        self.dynamics().energy(&Phase {
            theta: y[0],
            omega: y[1],
            swing: 0.0,
            swing_rate: 0.0,
        })
    }

    /// What the hoist gives and takes; `None` where the linkage does not close.
    pub(crate) fn hoist_powers(&self, modes: Modes, y: &[f64; N]) -> Option<HoistPowers> {
        if N == FIXED {
            return Some(HoistPowers::default());
        }
        let r = f64::reduced(self.dynamics(), y[0])?;
        let moment = self.moment(&r, y);
        either!(&self.crane, crane => crane.hoist_powers(&modes.of(y), &self.asked(moment)))
    }

    /// The smooth piece between two events, for the solver.
    #[must_use]
    pub fn between(&self, modes: Modes) -> Piece<'_, N> {
        Piece { crane: self, modes }
    }

    /// Decides what follows at an instant.
    ///
    /// # Errors
    /// The linkage does not close.
    pub fn event(&self, present: &mut PresentCrane<N>) -> Result<(), Halt> {
        let mut y = present.run.states();
        for _ in 0..MOST_CHANGES {
            let r = f64::reduced(self.dynamics(), y[0]).ok_or(Halt::Outside)?;
            if N == FIXED {
                return Ok(());
            }
            let moment = self.moment(&r, &y);
            let modes = &mut present.modes;
            let changed = either!(&self.crane, crane => {
                let mut state = modes.of(&y);
                let changed = crane.event(&mut state, &self.asked(moment))?;
                // Located just beyond its end, a rope that keeps its length cannot be longer than it is.
                if self.keeps() {
                    state.shorten();
                }
                put(&mut y, &state.y);
                modes.follow(&state);
                changed
            });
            if !changed {
                break;
            }
        }
        present.run.restart(y, FIRST);
        Ok(())
    }

    /// Moves on by a duration (s) in steps of at most `longest` (s), events located on the way.
    ///
    /// # Errors
    /// See [`Halt`]; the state is that of the last step that succeeded.
    pub fn advance(
        &self,
        present: &mut PresentCrane<N>,
        tolerance: &Tolerance<N>,
        duration: f64,
        longest: f64,
    ) -> Result<(), Halt> {
        let drive = self.slewing;
        if !(self.hoist.is_sound() && drive.is_sound()) {
            return Err(Halt::Outside);
        }
        if present.run.is_fresh() {
            self.event(present)?;
        }
        let (mut left, before) = (duration, present.run.count);
        for _ in 0..MOST_EVENTS {
            left = (present.run).piece(&self.between(present.modes), tolerance, left, longest)?;
            if !present.run.at_event() {
                return Ok(());
            }
            present.run.count.events += 1;
            self.event(present)?;
            let work = present.run.count.since(before);
            if work.steps + work.rejected > MOST_IMPLICIT {
                break;
            }
        }
        Err(Halt::TooMany)
    }
}

/// A smooth piece of a crane's way.
#[derive(Clone, Copy)]
pub struct Piece<'a, const N: usize> {
    crane: &'a Hydraulic<N>,
    modes: Modes,
}

impl<const N: usize> Piece<'_, N> {
    /// Of the cylinder's parts: pressures as those of the relief valves, the pump's flow and power as much of their limits.
    #[inline]
    fn part_kinks(&self, y: &[f64; N]) -> [f64; PART_MARGINS] {
        let cylinder = &self.crane.cylinder;
        let [flow, power] = cylinder
            .parts
            .and_then(|parts| parts.pump)
            .map_or([1.0; 2], |pump| [pump.q_pmax, pump.p_pmax]);
        let scale = |i: usize| match i {
            UNDERLAP_MARGIN => GAP,
            FLOW_MARGIN => flow * CRACK,
            POWER_MARGIN => power * CRACK,
            _ => cylinder.relief[0] * CRACK,
        };
        let margins = self.crane.part_margins(y);
        std::array::from_fn(|i| margins[i].map_or(1.0, |margin| margin / scale(i)))
    }
}

impl<const N: usize> System<N> for Piece<'_, N> {
    #[inline]
    fn rates(&self, y: &[f64; N]) -> Option<[f64; N]> {
        self.crane.equations(self.modes, y)
    }

    #[inline]
    fn jacobian(&self, y: &[f64; N]) -> Option<([f64; N], [[f64; N]; N])> {
        let out = self.crane.equations(self.modes, &Gradient::states(y))?;
        Some((out.map(|x| x.re), out.map(|x| x.by)))
    }

    #[inline]
    fn kinks(&self, y: &[f64; N]) -> [f64; MOST_KINKS] {
        let opening = self.crane.cylinder.relief[0];
        let over = |port: f64| (port / opening - 1.0) / CRACK;
        let [low, high] = self.crane.joint().stops;
        let parts = self.part_kinks(y);
        [
            y[6] / GAP,
            over(y[2]),
            over(y[3]),
            (y[0] - low) / TOUCH,
            (high - y[0]) / TOUCH,
            parts[0],
            parts[1],
            parts[2],
            parts[3],
            parts[4],
            parts[5],
            parts[6],
            parts[7],
            parts[8],
        ]
    }

    #[inline]
    fn ended(&self, y: &[f64; N]) -> bool {
        let beyond = |z: &[f64; 8]| z.iter().any(|z| *z < 0.0);
        N > FIXED && self.crane.indicators(self.modes, y).is_some_and(|z| beyond(&z))
    }

    #[inline]
    fn least(&self, y: &[f64; N]) -> f64 {
        Hydraulic::<N>::oil(y).least().1
    }

    #[inline]
    fn settle(&self, y: &mut [f64; N]) {
        if N > FIXED && self.modes.taut && self.crane.keeps() {
            match &self.crane.crane {
                Crane::Plane(_) => {
                    let mut state: motion::MotionState = self.modes.of(y);
                    state.straighten(state.y[7]);
                    put(y, &state.y);
                }
                Crane::Slewing(_) => {
                    let mut state: space::SlewingState = self.modes.of(y);
                    state.straighten(state.y[11]);
                    put(y, &state.y);
                }
            }
        }
    }
}
