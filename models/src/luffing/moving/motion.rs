//! Levels `rigid` and `swing`: a crane that luffs, and the load on a rope that swings in the mechanism's plane through
//! any angle.

use crate::kernel::calc::Calc;
use crate::luffing::moving::blown::directions;
use crate::luffing::moving::crane::{Commands, CraneState, DRUM, FEW, Hangs, MovingCrane, Snapshot, Struck};
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::pendulum::{Phase, Reel};
use crate::luffing::moving::reduced::Reduced;
use crate::luffing::moving::symbols as s;
use crate::parts::ground::Raised;
use crate::parts::hoist::RopeAction;
use crate::parts::joint::Bar;
use crate::parts::plane::{self, Point, dot};
use crate::parts::solver::Halt;

/// Number of states: angle and rate of the driven bar, of the rope, the rope's length, the distance
/// of the load from the head and its rate, the rate at which the rope is paid out; rad, m, s.
pub const STATES: usize = 8;
/// The same where the rope of its drive may go slack.
pub const HAULED: usize = STATES + DRUM;

/// A luffing mechanism that moves.
pub type MovingLinkage<P = f64> = MovingCrane<STATES, 1, P>;

/// One whose drive has a rope that may go slack.
pub type HauledLinkage<P = f64> = MovingCrane<HAULED, 1, P>;

/// Its motion at one instant.
pub type MotionState = CraneState<STATES, 1>;

impl MotionState {
    /// At rest at an angle (rad), the load hanging at the end of a rope of a length (m).
    #[must_use]
    pub fn resting(theta: f64, length: f64) -> MotionState {
        CraneState::held([theta, 0.0, 0.0, 0.0, length, length, 0.0, 0.0])
    }

    /// Puts a load that is farther than its rope is long to the rope's end.
    pub(crate) fn shorten(&mut self) {
        self.y[5] = self.y[5].min(self.y[4]);
    }
}

impl<const N: usize> CraneState<N, 1> {
    /// Puts the load of a taut rope, paid out at a rate (m/s), at its end, moving with it.
    pub(crate) fn straighten(&mut self, rate: f64) {
        (self.y[5], self.y[6]) = (self.y[4], rate);
    }

    /// How fast its rope is paid out, in m/s.
    fn paid(&self, r: &Reduced<f64>) -> f64 {
        r.paid(self.y[7], self.y[1])
    }
}

fn phase<C: Calc, const N: usize>(y: &[C; N]) -> Phase<C> {
    Phase {
        theta: y[0],
        omega: y[1],
        swing: y[2],
        swing_rate: y[3],
    }
}

/// Of bar and rope (rad/s²), and of the load away from the head (m/s²), between events.
#[derive(Clone, Copy, Debug)]
pub struct PlaneAccelerations<C> {
    bar: C,
    swing: C,
    out: C,
    /// Force of the rope over the load's mass, in m/s², where it does not follow from the others.
    pull: Option<C>,
}

impl<const N: usize, P: Calc> MovingCrane<N, 1, P> {
    /// The load on its rope as it is now.
    fn reel<C: Coordinate<P>>(&self, state: &CraneState<N, 1>, r: &Reduced<C>, y: &[C; N]) -> Reel<C> {
        if self.is_kept(state) {
            Reel {
                length: y[4],
                rate: r.paid(y[7], y[1]),
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

    /// Accelerations of a load that flies free, is pulled by a force that does not follow from the bar's alone, or stands on
    /// the ground, which takes all that acts on it.
    fn led<C: Coordinate<P>>(&self, moment: C, line: RopeAction<C>, at: &Snapshot<N, 1, C>) -> PlaneAccelerations<C> {
        let Snapshot { state, r, y, .. } = *at;
        let (m, reel, still) = (phase(y), self.reel(state, r, y), C::constant(0.0));
        let [_, d, dd] = r.head;
        let (out, along) = directions(m.swing);
        let mut weight = Point::new(still, still);
        if !state.grounded {
            weight.y = C::of(self.dynamics.gravity());
            if let Some(outer) = self.dynamics.outer_acceleration(r, &m, &reel) {
                weight -= outer;
            }
        }
        let held = state.joints[0] == Bar::Held;
        let alone = if held {
            still
        } else {
            let driven = moment - r.moment - C::constant(0.5) * r.slope * m.omega * m.omega;
            (driven.def(&s::M_NET) / r.inertia).def(&s::ALPHA_0)
        };
        let mass = self.dynamics.pendulum().map_or(still, |load| C::of(load.mass));
        let arm = r.arm(dot(d, out).def(&s::H_1R));
        let ease = if held { still } else { C::constant(1.0) / r.inertia };
        let pull = match line {
            RopeAction::Slack => None,
            RopeAction::Force(force) => Some((force / mass).def(&s::A_R)),
            RopeAction::Taut { drum, .. } => {
                let bend = dot(dd * (m.omega * m.omega) + weight, out);
                let mut need = reel.length * m.swing_rate.square() - bend - arm * alone;
                if let Some(bend) = r.bend(m.omega) {
                    need -= bend;
                }
                let mut give = C::constant(1.0) + mass * arm.square() * ease;
                if let Some([drum, pull]) = drum {
                    need += pull / drum;
                    give += mass / drum;
                }
                Some((need.def(&s::A_N) / give.def(&s::KAPPA_R)).def(&s::A_R))
            }
        };
        let bar = match pull {
            Some(pull) if !held => (alone + mass * pull * arm * ease).def(self.dynamics.names().acceleration),
            _ => alone,
        };
        // The load falls freely; seen from the head, which moves.
        let fall = plane::def(-weight - d * bar - dd * (m.omega * m.omega), [&s::A_QX, &s::A_QY]);
        let swing = (dot(fall, along).def(&s::A_QPHI) - C::constant(2.0) * reel.rate * m.swing_rate) / reel.length;
        let free = || dot(fall, out) + reel.length * m.swing_rate * m.swing_rate;
        PlaneAccelerations {
            bar,
            swing: swing.def(&s::D_OMEGA_R),
            out: match (line, pull) {
                (RopeAction::Taut { .. }, Some(pull)) if r.lead.is_some() => (free() - pull).def(&s::D_V_Q),
                (RopeAction::Taut { .. }, _) => still,
                _ if state.grounded => free().def(&s::D_V_Q),
                (_, Some(pull)) => (free() - pull).def(&s::D_V_Q),
                (_, None) => free(),
            },
            pull,
        }
    }

    /// Force of a taut rope, in N, on a mass (kg) in the place of the load's.
    fn pull<C: Coordinate<P>>(&self, mass: P, a: &PlaneAccelerations<C>, at: &Snapshot<N, 1, C>) -> C {
        let Snapshot { state, r, y, .. } = *at;
        if let Some(pull) = a.pull {
            return C::of(mass) * pull;
        }
        let [_, d, dd] = r.head;
        let (out, _) = directions(y[2]);
        let head = plane::def(d * a.bar + dd * (y[1] * y[1]), [&s::A_AX, &s::A_AY]);
        let mut head = head + Point::new(C::constant(0.0), C::of(self.dynamics.gravity()));
        let reel = self.reel(state, r, y);
        if let Some(outer) = self.dynamics.outer_acceleration(r, &phase(y), &reel) {
            head -= outer;
        }
        let mut inward = reel.less_gain(y[4] * y[3] * y[3]) - dot(head, out).def(&s::A_AR);
        if let Some((lead, bend)) = led(r, y[1], a.bar) {
            inward -= (lead + bend).def(&s::A_LR);
        }
        C::of(mass) * inward
    }
}

impl<const N: usize, P: Calc> Hangs<N, 1, P> for MovingCrane<N, 1, P> {
    const OWN: usize = STATES;

    const LENGTH: usize = 4;

    type Accelerations<C: Calc> = PlaneAccelerations<C>;

    fn reach<C: Calc>(y: &[C; N]) -> [C; 2] {
        [y[5], y[6]]
    }

    fn accelerations<C: Coordinate<P>>(&self, at: &Snapshot<N, 1, C>) -> PlaneAccelerations<C> {
        let Snapshot { state, r, y, .. } = *at;
        let (m, still) = (phase(y), C::constant(0.0));
        let (bar, drive) = (state.joints[0], &self.drive(0, at));
        let moment = self.joints[0].over().resisted(drive.moment, bar, m.omega, drive);
        let line = self.line(at);
        let kept = match line {
            RopeAction::Taut { drum, .. } => drum.is_none(),
            RopeAction::Slack | RopeAction::Force(_) => self.hoist().is_none(),
        };
        if !kept {
            return self.led(moment, line, at);
        }
        let reel = self.reel(state, r, y);
        let [bar, swing] = match bar {
            Bar::Held => [still, self.dynamics.hold(r, &m, reel)[1]],
            _ => self.dynamics.motion(r, &m, moment, reel),
        };
        let paid = led(r, m.omega, bar).map(|(lead, bend)| lead + bend + reel.gain.unwrap_or(still));
        PlaneAccelerations {
            bar,
            swing,
            out: paid.map_or(still, |paid| paid.def(&s::D_V_Q)),
            pull: None,
        }
    }

    #[inline]
    fn rates_by<C: Coordinate<P>>(&self, a: &PlaneAccelerations<C>, at: &Snapshot<N, 1, C>) -> [C; N] {
        let Snapshot { state, r, y, .. } = *at;
        let mut out = [C::constant(0.0); N];
        (out[0], out[1]) = (y[1], a.bar);
        if self.hoist().is_none() {
            return out;
        }
        let paid = r.paid(y[7], y[1]);
        let distance = if self.is_kept(state) { paid } else { y[6] };
        out[2..STATES - 1].copy_from_slice(&[y[3], a.swing, paid, distance, a.out]);
        out
    }

    fn tension_by<C: Coordinate<P>>(&self, a: &PlaneAccelerations<C>, at: &Snapshot<N, 1, C>) -> C {
        match self.dynamics.pendulum().copied() {
            Some(load) => self.pull(load.mass, a, at).def(&s::S_R),
            None => C::constant(0.0),
        }
    }

    fn slackening_by<C: Coordinate<P>>(&self, a: &PlaneAccelerations<C>, at: &Snapshot<N, 1, C>) -> C {
        match self.dynamics.pendulum().copied() {
            Some(load) => self.pull(load.cancelling(), a, at),
            None => C::constant(1.0),
        }
    }

    fn raised<C: Coordinate<P>>(&self, ground: P, at: &Snapshot<N, 1, C>) -> Raised<C> {
        let upright = -directions(at.y[2]).0.y;
        Raised::above(ground, at.r.head[0].y - at.y[5] * upright, upright)
    }

    fn felt<C: Coordinate<P>>(&self, at: &Snapshot<N, 1, C>) -> Option<[C; 2]> {
        let Snapshot { state, r, y, .. } = *at;
        let ([speed, against], drag) = self.dynamics.in_wind(r, &phase(y), &self.reel(state, r, y))?;
        Some(drag.felt(speed, against))
    }

    fn needs<C: Coordinate<P>>(&self, _: usize, at: &Snapshot<N, 1, C>) -> C {
        let Snapshot { state, r, y, .. } = *at;
        let hold = match self.line(at) {
            RopeAction::Slack => r.moment,
            RopeAction::Taut { drum: None, .. } => {
                let still = Phase {
                    omega: C::constant(0.0),
                    ..phase(y)
                };
                self.dynamics.hold(r, &still, self.reel(state, r, y))[0]
            }
            RopeAction::Taut { .. } | RopeAction::Force(_) => {
                let arm = r.arm(dot(r.head[1], directions(y[2]).0));
                r.moment - self.tension(at) * arm
            }
        };
        hold - self.drive(0, at).moment
    }
}

impl<const N: usize> Struck<N, 1> for MovingCrane<N, 1> {
    fn jumped(before: &CraneState<N, 1>, after: &CraneState<N, 1>) -> bool {
        let rates = |state: &CraneState<N, 1>| [state.y[1], state.y[3], state.y[6], state.y[7]];
        rates(before) != rates(after)
    }

    fn wound(&self, state: &mut CraneState<N, 1>, before: f64, _: f64) -> Result<(), Halt> {
        let r = self.reduced(state, state.y[0]).ok_or(Halt::Outside)?;
        (state.y[5], state.y[6], state.taut) = (state.y[4], r.paid(before, state.y[1]), false);
        Ok(())
    }

    fn stopped(&self, _: usize, state: &mut CraneState<N, 1>, r: &Reduced<f64>) {
        let omega = state.y[1];
        let (out, along) = directions(state.y[2]);
        // A rope along which the head comes to rest would have to push: it lets go. A drum that turns gives way, by
        // what the load then pulls.
        let gives = self.hoist().is_some_and(|hoist| state.drum.ease(hoist) > 0.0);
        if self.is_kept(state) && (gives || omega * r.arm(r.head[1].dot(&out)) < 0.0) {
            state.straighten(state.paid(r));
            state.taut = false;
        }
        let reel = self.reel(state, r, &state.y);
        if self.is_kept(state) || self.hoist().is_none() {
            state.y[3] -= omega * self.dynamics.blow(r, &phase(&state.y), reel);
        } else {
            state.y[3] += omega * r.head[1].dot(&along) / reel.length;
            state.y[6] += omega * r.head[1].dot(&out);
        }
    }

    fn switched(&self, state: &mut CraneState<N, 1>, r: &Reduced<f64>, commands: &Commands<1>) {
        let Some(pendulum) = self.dynamics.pendulum().copied() else {
            return;
        };
        if state.taut {
            state.straighten(state.paid(r));
            let at = state.at(r, commands);
            state.taut = self.slackening_by(&self.accelerations(&at), &at) >= 0.0;
        } else if state.y[5] >= state.y[4] && state.y[6] > state.paid(r) {
            let (out, along) = directions(state.y[2]);
            let arm = r.arm(r.head[1].dot(&out));
            let held = state.joints[0] == Bar::Held;
            let follow = if held { 0.0 } else { arm / r.inertia };
            let drum = state.drum.ease(&pendulum.hoist);
            let blow = (state.y[6] - state.paid(r)) / (1.0 / pendulum.mass + arm * follow + drum);
            state.y[1] += blow * follow;
            state.joints[0] = state.joints[0].struck(state.y[1]);
            state.y[3] -= blow * follow * r.head[1].dot(&along) / state.y[4];
            state.y[7] += blow * drum;
            if drum > 0.0 {
                state.drum.way = state.drum.way.struck(state.y[7]);
            }
            state.straighten(state.paid(r));
            state.taut = true;
        }
    }

    fn hauled(&self, state: &mut CraneState<N, 1>, r: &Reduced<f64>, give: impl FnOnce(f64) -> f64, way: f64) {
        let Some(pendulum) = self.dynamics.pendulum().copied() else {
            state.y[1] += give(1.0 / r.inertia);
            return;
        };
        let (out, along) = directions(state.y[2]);
        let arm = r.arm(r.head[1].dot(&out));
        let light = 1.0 / pendulum.mass + state.drum.ease(&pendulum.hoist);
        let (kept, led) = (self.is_kept(state), self.is_kept(state) && arm * way <= 0.0);
        let heavy = if led { arm * arm / light } else { 0.0 };
        if kept {
            state.straighten(state.paid(r));
        }
        let change = give(1.0 / (r.inertia + heavy));
        state.y[1] += change;
        state.y[3] -= change * r.head[1].dot(&along) / self.reel(state, r, &state.y).length;
        if led {
            state.y[7] -= change * arm / light * state.drum.ease(&pendulum.hoist);
            state.drum.way = state.drum.way.struck(state.y[7]);
            state.straighten(state.paid(r));
        } else {
            state.y[6] -= change * r.head[1].dot(&out);
            state.taut &= !kept;
        }
    }

    fn put_down(&self, state: &mut CraneState<N, 1>, r: &Reduced<f64>, ground: f64) {
        let (below, y) = (r.head[0].y - ground, &mut state.y);
        let (out, _) = directions(y[2]);
        if (y[5] * out.y + below).abs() > FEW * below.abs() {
            // Straight up or down, the angle on the same turn.
            let place = Point::new(y[5] * out.x, -below);
            y[2] += f64::direction(out.dot(&place), out.perp(&place));
            y[5] = plane::length(place);
        }
        let (out, along) = directions(y[2]);
        let head = r.head[1] * y[1];
        (y[3], y[6]) = (-head.dot(&along) / y[5], -head.dot(&out));
    }

    fn height_and_speed(&self, state: &CraneState<N, 1>, r: &Reduced<f64>) -> [f64; 2] {
        let (m, reel) = (phase(&state.y), self.reel(state, r, &state.y));
        let [a, d, _] = r.head;
        let (out, along) = directions(m.swing);
        let velocity = d * m.omega + along * (reel.length * m.swing_rate) + out * reel.rate;
        let potential = self.dynamics.potential(a + out * reel.length);
        [potential, velocity.norm_squared()]
    }
}

/// What luffing adds to the acceleration of the rope's length (m/s²), by the bar's acceleration and by its rate.
fn led<C: Calc>(r: &Reduced<C>, omega: C, bar: C) -> Option<(C, C)> {
    let ([lead, _], bend) = r.lead.zip(r.bend(omega))?;
    Some((lead * bar, bend))
}
