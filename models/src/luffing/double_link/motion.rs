//! Levels `rigid` and `swing`: the driven bar as a state under a moment, with
//! friction that truly sticks, a brake and end stops; and the load on a rope
//! that swings through any angle, is reeled in and out, and may go slack.
//!
//! Between events the motion is smooth and solved by the explicit Runge-Kutta
//! method of fourth order. What ends a smooth piece is an [`indicator`](MovingLinkage::indicators)
//! below zero; what follows is decided by [`MovingLinkage::event`]. Blows (an end
//! stop, a rope that becomes taut) are plastic: no bouncing, no energy gained.

use crate::kernel::calc::Calc;
use crate::luffing::double_link::dynamics::{Coordinate, Dynamics, Phase, Reduced, Reel};
use crate::luffing::double_link::moving::symbols as s;
use crate::parts::hoist::{Drum, Elastic, Hoist, HoistCommand, HoistPowers, RopeAction};
use crate::parts::joint::{Bar, LOOSE, above_zero, capped};
use crate::parts::plane::{Point, dot};
use crate::parts::solver::pieces::{self, Pieces};
use crate::parts::solver::{Count, Halt, finite};

/// Friction at the driven bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction<P = f64> {
    /// In N·m·s/rad.
    pub viscous: P,
    /// In N·m: it holds the bar at rest up to this moment.
    pub coulomb: P,
}

/// What drives the motion; constant over a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Commands<P = f64> {
    /// Moment of the drive on the driven bar, in N·m; positive raises it.
    pub moment: P,
    /// Moment that the brake adds to the dry friction, in N·m; not negative.
    pub brake: P,
    pub hoist: HoistCommand<P>,
}

/// Number of states: angle and rate of the driven bar, of the rope, the rope's length, the distance
/// of the load from the head and its rate, the rate at which the rope is paid out; rad, m, s.
pub const STATES: usize = 8;
/// Number of event indicators.
pub const INDICATORS: usize = 7;

/// A motion at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionState {
    pub y: [f64; STATES],
    pub bar: Bar,
    pub drum: Drum,
    /// The load hangs on the rope, or flies free.
    pub taut: bool,
    /// Energy that blows have taken so far, in J; what they gave counts negative.
    pub blown: f64,
}

impl MotionState {
    /// At rest at an angle (rad), the load hanging at the end of a rope of a length (m).
    #[must_use]
    pub fn resting(theta: f64, length: f64) -> MotionState {
        MotionState {
            y: [theta, 0.0, 0.0, 0.0, length, length, 0.0, 0.0],
            bar: Bar::Held,
            drum: Drum::at(0.0),
            taut: true,
            blown: 0.0,
        }
    }

    /// The hoist runs as commanded, at a rate of paying out (m/s).
    pub fn wind(&mut self, rate: f64) {
        (self.y[7], self.drum) = (rate, Drum::at(rate));
    }

    #[must_use]
    pub fn phase(&self) -> Phase {
        phase(&self.y)
    }
}

fn phase<C: Calc>(y: &[C; STATES]) -> Phase<C> {
    Phase {
        theta: y[0],
        omega: y[1],
        swing: y[2],
        swing_rate: y[3],
    }
}

/// Of bar and rope (rad/s²), and of the load away from the head (m/s²), between events.
#[derive(Clone, Copy, Debug)]
struct PlaneAccelerations<C> {
    bar: C,
    swing: C,
    out: C,
    /// Force of the rope over the load's mass, in m/s², where it does not follow from the others.
    pull: Option<C>,
}

/// A luffing mechanism that moves.
#[derive(Clone, Copy, Debug)]
pub struct MovingLinkage<P = f64> {
    pub dynamics: Dynamics<P>,
    pub friction: Friction<P>,
    /// Least and greatest angle of the driven bar, in rad.
    pub stops: [f64; 2],
}

/// Length of a rope, in m, of which nothing is left.
pub(crate) const REELED_IN: f64 = 1e-4;
/// Part of an energy that rounding may be.
const ROUNDING: f64 = 1e-14;
/// Changes at one instant.
pub(crate) const MOST_CHANGES: u32 = 16;

impl<P: Calc> MovingLinkage<P> {
    fn hoist(&self) -> Option<&Hoist<P>> {
        self.dynamics.bodies().pendulum.as_ref().map(|load| &load.hoist)
    }

    /// Whether the rope keeps the load at its end: it is taut, and keeps its length under any force.
    pub(crate) fn is_kept(&self, state: &MotionState) -> bool {
        state.taut && self.hoist().is_some_and(|hoist| hoist.rope.is_none())
    }

    /// The load on its rope as it is now.
    fn reel<C: Coordinate<P>>(&self, state: &MotionState, y: &[C; STATES]) -> Reel<C> {
        if self.is_kept(state) {
            Reel {
                length: y[4],
                rate: y[7],
                gain: self.hoist().and_then(|hoist| state.drum.ramp(hoist)),
            }
        } else {
            Reel {
                length: y[5],
                rate: y[6],
                gain: None,
            }
        }
    }

    /// How the rope acts on the load.
    fn line<C: Coordinate<P>>(&self, state: &MotionState, y: &[C; STATES], commands: &Commands<C>) -> RopeAction<C> {
        match self.hoist().filter(|_| state.taut) {
            None => RopeAction::Slack,
            Some(hoist) => match &hoist.rope {
                None => RopeAction::Taut {
                    rate: y[7],
                    gain: state.drum.ramp(hoist),
                    drum: state.drum.turning(hoist, &commands.hoist),
                },
                Some(rope) => RopeAction::Force(Self::stretched(rope, y)[1].def(&s::S_R)),
            },
        }
    }

    /// Forces of a stretched rope, in N.
    fn stretched<C: Coordinate<P>>(rope: &Elastic<P>, y: &[C; STATES]) -> [C; 2] {
        rope.forces((y[5] - y[4]).def(&s::DELTA_R), y[6] - y[7])
    }

    /// Greatest moment of dry friction and brake, in N·m.
    fn dry<C: Coordinate<P>>(&self, commands: &Commands<C>) -> C {
        C::of(self.friction.coulomb) + commands.brake
    }

    fn accelerations<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &Commands<C>,
    ) -> PlaneAccelerations<C> {
        let (m, still) = (phase(y), C::constant(0.0));
        let viscous = || commands.moment - C::of(self.friction.viscous) * m.omega;
        let moment = match state.bar {
            Bar::Held | Bar::Loose => commands.moment,
            Bar::Forward => viscous() - self.dry(commands),
            Bar::Backward => viscous() + self.dry(commands),
        };
        let line = self.line(state, y, commands);
        let kept = match line {
            RopeAction::Taut { drum, .. } => drum.is_none(),
            RopeAction::Slack | RopeAction::Force(_) => self.hoist().is_none(),
        };
        if kept {
            let reel = self.reel(state, y);
            let [bar, swing] = match state.bar {
                Bar::Held => [still, self.dynamics.hold(r, &m, reel)[1]],
                _ => self.dynamics.motion(r, &m, moment, reel),
            };
            return PlaneAccelerations {
                bar,
                swing,
                out: still,
                pull: None,
            };
        }
        self.led(state, r, y, moment, line)
    }

    /// Accelerations of a load that flies free, or is pulled by a force that does not follow from the bar's alone.
    fn led<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
        moment: C,
        line: RopeAction<C>,
    ) -> PlaneAccelerations<C> {
        let (m, reel, still) = (phase(y), self.reel(state, y), C::constant(0.0));
        let [_, d, dd] = r.head;
        let (out, along) = directions(m.swing);
        let bodies = self.dynamics.bodies();
        let weight = Point::new(still, C::of(bodies.gravity));
        let held = state.bar == Bar::Held;
        let alone = if held {
            still
        } else {
            ((moment - r.moment - C::constant(0.5) * r.slope * m.omega * m.omega) / r.inertia).def(&s::ALPHA_0)
        };
        let mass = bodies.pendulum.map_or(still, |load| C::of(load.mass));
        let arm = dot(d, out).def(&s::H_1R);
        let ease = if held { still } else { C::constant(1.0) / r.inertia };
        let pull = match line {
            RopeAction::Slack => None,
            RopeAction::Force(force) => Some((force / mass).def(&s::A_R)),
            RopeAction::Taut { drum, .. } => {
                let bend = dot(dd * (m.omega * m.omega) + weight, out);
                let mut need = reel.length * m.swing_rate.square() - bend - arm * alone;
                let mut give = C::constant(1.0) + mass * arm.square() * ease;
                if let Some([drum, pull]) = drum {
                    need += pull / drum;
                    give += mass / drum;
                }
                Some((need.def(&s::A_N) / give.def(&s::KAPPA_R)).def(&s::A_R))
            }
        };
        let bar = match pull {
            Some(pull) if !held => (alone + mass * pull * arm * ease).def(self.dynamics.acceleration()),
            _ => alone,
        };
        // The load falls freely; seen from the head, which moves.
        let fall = -weight - d * bar - dd * (m.omega * m.omega);
        let swing = (dot(fall, along) - C::constant(2.0) * reel.rate * m.swing_rate) / reel.length;
        let free = || dot(fall, out) + reel.length * m.swing_rate * m.swing_rate;
        PlaneAccelerations {
            bar,
            swing: swing.def(&s::D_OMEGA_R),
            out: match (line, pull) {
                (RopeAction::Taut { .. }, _) => still,
                (_, Some(pull)) => (free() - pull).def(&s::D_V_Q),
                (_, None) => free(),
            },
            pull,
        }
    }

    /// Rates of all states between events; `None` where the linkage does not close or nothing is left of the rope.
    #[must_use]
    #[inline]
    pub fn rates<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        commands: &Commands<C>,
        y: &[C; STATES],
    ) -> Option<[C; STATES]> {
        if self.is_reeled_in(y[4]) {
            return None;
        }
        let r = C::reduced(&self.dynamics, y[0])?;
        Some(self.rates_at(state, &r, y, commands))
    }

    /// Whether nothing is left of a rope of a length (m).
    pub(crate) fn is_reeled_in<C: Calc>(&self, length: C) -> bool {
        self.dynamics.bodies().pendulum.is_some() && length.value() <= REELED_IN
    }

    /// The same where it is known what the mechanism is at this angle.
    #[inline]
    pub(crate) fn rates_at<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &Commands<C>,
    ) -> [C; STATES] {
        let none = C::constant(0.0);
        let a = self.accelerations(state, r, y, commands);
        let Some(hoist) = self.hoist() else {
            return [y[1], a.bar, none, none, none, none, none, none];
        };
        let kept = self.is_kept(state);
        let rope = || self.tension_by(&a, state, r, y);
        let gain = (state.drum.gain(hoist, &commands.hoist, rope)).map_or(none, |gain| gain.def(&s::D_V_R));
        let distance = if kept { y[7] } else { y[6] };
        [y[1], a.bar, y[3], a.swing, y[7], distance, a.out, gain]
    }

    /// Moment that friction, brake and stops must give to hold the bar at rest, in N·m, with the
    /// least and greatest that they can.
    fn held<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &Commands<C>,
    ) -> [C; 3] {
        let line = self.line(state, y, commands);
        let hold = match line {
            RopeAction::Slack => r.moment,
            RopeAction::Taut { drum: None, .. } => {
                let still = Phase {
                    omega: C::constant(0.0),
                    ..phase(y)
                };
                self.dynamics.hold(r, &still, self.reel(state, y))[0]
            }
            RopeAction::Taut { .. } | RopeAction::Force(_) => {
                let arm = dot(r.head[1], directions(y[2]).0);
                r.moment - self.tension(state, r, y, commands) * arm
            }
        };
        let dry = self.dry(commands) * C::constant(LOOSE);
        let (theta, without_end) = (y[0].value(), C::constant(f64::INFINITY));
        [
            hold - commands.moment,
            if theta >= self.stops[1] { -without_end } else { -dry },
            if theta <= self.stops[0] { without_end } else { dry },
        ]
    }

    /// Force of the rope on the load towards the head, in N; zero where it is slack or there is none.
    pub(crate) fn tension<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &Commands<C>,
    ) -> C {
        if self.hoist().is_none() || !state.taut {
            return C::constant(0.0);
        }
        self.tension_by(&self.accelerations(state, r, y, commands), state, r, y)
    }

    /// The same where it is known how all accelerate.
    fn tension_by<C: Coordinate<P>>(
        &self,
        a: &PlaneAccelerations<C>,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
    ) -> C {
        match self.dynamics.bodies().pendulum.filter(|_| state.taut) {
            Some(load) => self.pull(load.mass, a, state, r, y).def(&s::S_R),
            None => C::constant(0.0),
        }
    }

    /// Force of a taut rope, in N, on a mass (kg) in the place of the load's.
    fn pull<C: Coordinate<P>>(
        &self,
        mass: P,
        a: &PlaneAccelerations<C>,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
    ) -> C {
        if let Some(pull) = a.pull {
            return C::of(mass) * pull;
        }
        let [_, d, dd] = r.head;
        let (out, _) = directions(y[2]);
        let head = d * a.bar + dd * (y[1] * y[1]) + Point::new(C::constant(0.0), C::of(self.dynamics.bodies().gravity));
        C::of(mass) * (self.reel(state, y).less_gain(y[4] * y[3] * y[3]) - dot(head, out))
    }

    /// Force of the rope, in N; zero where it is slack or there is none.
    #[must_use]
    pub fn rope_force<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        commands: &Commands<C>,
        y: &[C; STATES],
    ) -> Option<C> {
        let r = C::reduced(&self.dynamics, y[0])?;
        Some(self.tension(state, &r, y, commands))
    }

    /// Moment of friction, brake and end stop on the driven bar, in N·m; positive raises it.
    #[must_use]
    pub fn friction_moment<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        commands: &Commands<C>,
        y: &[C; STATES],
    ) -> Option<C> {
        let r = C::reduced(&self.dynamics, y[0])?;
        let viscous = -C::of(self.friction.viscous) * y[1];
        Some(match state.bar {
            Bar::Held => self.held(state, &r, y, commands)[0],
            Bar::Forward => viscous - self.dry(commands),
            Bar::Backward => viscous + self.dry(commands),
            Bar::Loose => C::constant(0.0),
        })
    }

    /// Numbers whose fall below zero ends a smooth piece: the bar comes to rest or (two) breaks
    /// loose; it meets its lower or upper stop; the rope becomes slack or taut; the hoist runs as commanded, or comes to
    /// rest or (two) breaks loose. After an event all are above zero.
    #[must_use]
    pub fn indicators<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        commands: &Commands<C>,
        y: &[C; STATES],
    ) -> Option<[C; INDICATORS]> {
        let r = C::reduced(&self.dynamics, y[0])?;
        let (none, [low, high]) = (C::constant(1.0), self.stops.map(C::constant));
        let [rest, loose, low, high] = match state.bar {
            Bar::Held => {
                let [hold, least, most] = self.held(state, &r, y, commands);
                // Where a stop gives any moment there is nothing to break.
                [capped(most - hold), capped(hold - least), none, none]
            }
            Bar::Forward => [y[1], none, y[0] - low, high - y[0]],
            Bar::Backward => [-y[1], none, y[0] - low, high - y[0]],
            Bar::Loose => [none; 4],
        };
        let rope = self.slackening(state, &r, y, commands);
        let [hoist, drum] = self.reaching(state, &r, y, commands);
        Some([rest, loose, low, high, rope, hoist, drum].map(above_zero))
    }

    /// Falls below zero where the rope becomes slack or taut.
    pub(crate) fn slackening<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &Commands<C>,
    ) -> C {
        let Some(load) = self.dynamics.bodies().pendulum else {
            return C::constant(1.0);
        };
        match &load.hoist.rope {
            Some(rope) => Elastic::<P>::slackening(state.taut, Self::stretched(rope, y)),
            None if state.taut => {
                let a = self.accelerations(state, r, y, commands);
                self.pull(load.cancelling(), &a, state, r, y)
            }
            None => y[4] * C::constant(LOOSE) - y[5],
        }
    }

    /// Fall below zero where the hoist runs as commanded, or its drum comes to rest or (two) breaks loose.
    pub(crate) fn reaching<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &Commands<C>,
    ) -> [C; 2] {
        let rope = || self.tension(state, r, y, commands);
        let reaching = |hoist: &Hoist<P>| state.drum.reaching(hoist, &commands.hoist, y[7], rope);
        self.hoist().map_or([C::constant(1.0); 2], reaching)
    }

    /// Moment of brake and friction on the drum of a motor, in N·m; positive reels in.
    pub(crate) fn drum_friction<C: Coordinate<P>>(
        &self,
        state: &MotionState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &Commands<C>,
    ) -> C {
        let rope = self.tension(state, r, y, commands);
        let friction = |hoist: &Hoist<P>| state.drum.friction(hoist, &commands.hoist, rope);
        self.hoist().map_or(C::constant(0.0), friction)
    }
}

impl MovingLinkage {
    /// Decides what follows at an instant, as often as one event causes another. Returns whether
    /// anything changed.
    ///
    /// # Errors
    /// The linkage does not close, or a number overflows.
    pub fn event(&self, state: &mut MotionState, commands: &Commands) -> Result<bool, Halt> {
        let first = *state;
        if state.y[1] == 0.0 && state.bar != Bar::Loose {
            // At rest it is decided again which way it goes, as the commands may have changed.
            state.bar = Bar::Held;
        }
        self.wind(state, commands);
        for _ in 0..MOST_CHANGES {
            let before = *state;
            let r = f64::reduced(&self.dynamics, state.y[0]).ok_or(Halt::Outside)?;
            self.stop_bar(state, &r);
            self.switch_rope(state, &r, commands);
            if state.bar == Bar::Held {
                state.bar = Bar::loosened(self.held(state, &r, &state.y, commands));
            }
            if let Some(hoist) = self.hoist() {
                let rope = || self.tension(state, &r, &state.y, commands);
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
        let rates = |state: &MotionState| [state.y[1], state.y[3], state.y[6], state.y[7]];
        if rates(state) != rates(&first) {
            state.blown += lost(self.energy(&first).zip(self.energy(state)));
        }
        Ok(*state != first)
    }

    /// The hoist follows its command. Where it does so at once the load goes on as it did: the rope lets go, or gives
    /// it a blow.
    fn wind(&self, state: &mut MotionState, commands: &Commands) {
        let Some(hoist) = self.hoist() else {
            return;
        };
        let before = state.y[7];
        let (drum, rate, jump) = state.drum.decided(hoist, before, &commands.hoist);
        (state.drum, state.y[7]) = (drum, rate);
        if self.is_kept(state) && jump != 0.0 {
            (state.y[5], state.y[6], state.taut) = (state.y[4], before, false);
        }
    }

    /// A bar that has reached a stop, or turned round, is at rest.
    fn stop_bar(&self, state: &mut MotionState, r: &Reduced<f64>) {
        let [theta, omega, ..] = state.y;
        let [low, high] = self.stops;
        let at_stop = (theta >= high && omega > 0.0) || (theta <= low && omega < 0.0);
        let turned = match state.bar {
            Bar::Held => omega != 0.0,
            // A bar that breaks loose is at rest: whether the rope lets go is decided as it moves.
            Bar::Forward => omega < 0.0,
            Bar::Backward => omega > 0.0,
            Bar::Loose => return,
        };
        if at_stop {
            let (out, along) = directions(state.y[2]);
            // A rope along which the head comes to rest would have to push: it lets go. A drum that turns gives way, by
            // what the load then pulls.
            let gives = self.hoist().is_some_and(|hoist| state.drum.ease(hoist) > 0.0);
            if self.is_kept(state) && (gives || omega * r.head[1].dot(&out) < 0.0) {
                (state.y[5], state.y[6], state.taut) = (state.y[4], state.y[7], false);
            }
            let reel = self.reel(state, &state.y);
            if self.is_kept(state) || self.hoist().is_none() {
                state.y[3] -= omega * self.dynamics.blow(r, &state.phase(), reel);
            } else {
                state.y[3] += omega * r.head[1].dot(&along) / reel.length;
                state.y[6] += omega * r.head[1].dot(&out);
            }
            state.y[0] = theta.clamp(low, high);
        }
        if state.bar == Bar::Held && turned && !at_stop {
            // Set in motion from outside.
            state.bar = if omega > 0.0 { Bar::Forward } else { Bar::Backward };
        } else if at_stop || turned {
            state.y[1] = 0.0;
            state.bar = Bar::Held;
        }
    }

    /// The rope lets go where it would push, and catches the load with a plastic blow along itself.
    fn switch_rope(&self, state: &mut MotionState, r: &Reduced<f64>, commands: &Commands) {
        let Some(pendulum) = self.dynamics.bodies().pendulum else {
            return;
        };
        if let Some(rope) = &pendulum.hoist.rope {
            state.taut = Elastic::<f64>::pulls(state.taut, Self::stretched(rope, &state.y));
        } else if state.taut {
            state.y[5] = state.y[4];
            state.y[6] = state.y[7];
            state.taut = self.slackening(state, r, &state.y, commands) >= 0.0;
        } else if state.y[5] >= state.y[4] && state.y[6] > state.y[7] {
            let (out, along) = directions(state.y[2]);
            let arm = r.head[1].dot(&out);
            let follow = if state.bar == Bar::Held { 0.0 } else { arm / r.inertia };
            let drum = state.drum.ease(&pendulum.hoist);
            let blow = (state.y[6] - state.y[7]) / (1.0 / pendulum.mass + arm * follow + drum);
            state.y[1] += blow * follow;
            state.bar = state.bar.struck(state.y[1]);
            state.y[3] -= blow * follow * r.head[1].dot(&along) / state.y[4];
            state.y[7] += blow * drum;
            if drum > 0.0 {
                state.drum.way = state.drum.way.struck(state.y[7]);
            }
            state.y[5] = state.y[4];
            state.y[6] = state.y[7];
            state.taut = true;
        }
    }

    /// Moves on by a duration (s) in equal steps of at most `longest` (s), events located on the way
    /// to the last bits of the step. Returns the work done.
    ///
    /// # Errors
    /// See [`Halt`]; the state is that of the last step that succeeded.
    pub fn advance(
        &self,
        state: &mut MotionState,
        commands: &Commands,
        duration: f64,
        longest: f64,
    ) -> Result<Count, Halt> {
        let Commands { moment, brake, hoist } = *commands;
        if !(moment.is_finite() && hoist.is_sound() && brake >= 0.0) {
            return Err(Halt::Outside);
        }
        pieces::advance(&Commanded { motion: self, commands }, state, duration, longest)
    }

    /// Kinetic and potential energy, in J; `None` where the linkage does not close.
    #[must_use]
    pub fn energy(&self, state: &MotionState) -> Option<f64> {
        let r = f64::reduced(&self.dynamics, state.y[0])?;
        let m = state.phase();
        let bars = 0.5 * r.inertia * m.omega * m.omega + r.energy;
        let bodies = self.dynamics.bodies();
        let Some(pendulum) = bodies.pendulum else {
            return Some(bars);
        };
        let reel = self.reel(state, &state.y);
        let [a, d, _] = r.head;
        let (out, along) = directions(m.swing);
        let velocity = d * m.omega + along * (reel.length * m.swing_rate) + out * reel.rate;
        let height = a.y + out.y * reel.length;
        let load = pendulum.mass * (0.5 * velocity.norm_squared() + bodies.gravity * height);
        let hoist = pendulum.hoist.energy(state.y[7], state.y[5] - state.y[4]);
        Some(bars + load + hoist)
    }

    /// What the hoist gives and takes; `None` where the linkage does not close.
    pub(crate) fn hoist_powers(&self, state: &MotionState, commands: &Commands) -> Option<HoistPowers> {
        let Some(hoist) = self.hoist() else {
            return Some(HoistPowers::default());
        };
        let rope = self.rope_force(state, commands, &state.y)?;
        let y = &state.y;
        let stretch = [y[5] - y[4], y[6] - y[7]];
        Some(hoist.powers(state.drum, &commands.hoist, y[7], stretch, rope))
    }
}

/// A motion under commands, for the solver.
struct Commanded<'a> {
    motion: &'a MovingLinkage,
    commands: &'a Commands,
}

impl Pieces<STATES, MotionState> for Commanded<'_> {
    fn states(state: &mut MotionState) -> &mut [f64; STATES] {
        &mut state.y
    }

    #[inline]
    fn rates(&self, state: &MotionState, y: &[f64; STATES]) -> Option<[f64; STATES]> {
        self.motion.rates(state, self.commands, y)
    }

    #[inline]
    fn crossed(&self, state: &MotionState, y: &[f64; STATES]) -> bool {
        pieces::crossed(self.motion.indicators(state, self.commands, y))
    }

    fn event(&self, state: &mut MotionState) -> Result<(), Halt> {
        self.motion.event(state, self.commands).map(|_| ())
    }
}

/// What a blow takes (J), from the energy before and after it: nothing where that is rounding.
pub(crate) fn lost(energies: Option<(f64, f64)>) -> f64 {
    let blow = |(before, after): (f64, f64)| {
        let lost = before - after;
        if lost.abs() > ROUNDING * (before.abs() + after.abs()) {
            lost
        } else {
            0.0
        }
    };
    energies.map_or(0.0, blow)
}

/// From the head to the load, and where it swings to, at an angle of the rope.
pub(crate) fn directions<C: Calc>(swing: C) -> (Point<C>, Point<C>) {
    let (sin, cos) = swing.sin_cos();
    (Point::new(sin, -cos), Point::new(cos, sin))
}
