//! Levels `rigid` and `swing` of a crane that slews: luffing and slewing as two
//! joints, and the load on a rope that swings in all directions.
//!
//! The equations are in [`hanging`](crate::luffing::moving::hanging), and so is the frame.

use nalgebra::Vector3;

use crate::kernel::calc::Calc;
use crate::luffing::moving::crane::{Commands, CraneState, DRUM, FEW, Hangs, MovingCrane, Snapshot, Struck};
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::reduced::Reduced;
use crate::luffing::moving::symbols as s;
use crate::parts::ground::Raised;
use crate::parts::hanging::{Accelerations, HangingLoad, HeadRope, dot, squared, to_load, turned};
use crate::parts::hoist::RopeAction;
use crate::parts::joint::Bar;
use crate::parts::solver::Halt;

/// Number of states: angle and rate of the driven bar, of slewing, the load from the head and its rate in
/// the frame that slews, the rope's length, the rate at which it is paid out; rad, m, s.
pub const STATES: usize = 12;
/// The same where the rope of its drive may go slack.
pub const HAULED: usize = STATES + DRUM;
/// States without a load on a rope.
pub const RIGID: usize = 4;

/// A crane that luffs and slews, its dynamics on a turntable.
pub type Slewing<P = f64> = MovingCrane<STATES, 2, P>;

/// One whose drive has a rope that may go slack.
pub type HauledSlewing<P = f64> = MovingCrane<HAULED, 2, P>;

/// Its motion at one instant.
pub type SlewingState = CraneState<STATES, 2>;

impl SlewingState {
    /// At rest at an angle of the driven bar (rad), the load hanging on a rope of a length (m).
    #[must_use]
    pub fn resting(theta: f64, length: f64) -> SlewingState {
        let mut y = [0.0; STATES];
        y[0] = theta;
        y[10] = length;
        let mut state = SlewingState::held(y);
        state.put_load([0.0; 2]);
        state
    }

    /// Puts the load at rest at the end of its rope, at angles (rad) from the vertical in the plane of the
    /// mechanism, forward positive, and from that plane, left positive.
    pub fn put_load(&mut self, [swing, side]: [f64; 2]) {
        self.put(HangingLoad::resting(self.y[10], [swing, side]));
    }

    /// Puts a load that is farther than its rope is long to the rope's end.
    pub(crate) fn shorten(&mut self) {
        let (place, rope) = (load_of(&self.y).place, self.y[10]);
        let distance = place.norm();
        if distance > rope {
            self.y[4..7].copy_from_slice((place * (rope / distance)).as_slice());
        }
    }
}

impl<const N: usize> CraneState<N, 2> {
    fn put(&mut self, load: HangingLoad<f64>) {
        self.y[4..7].copy_from_slice(load.place.as_slice());
        self.y[7..10].copy_from_slice(load.rate.as_slice());
    }

    /// Puts the load of a taut rope, paid out at a rate (m/s), at its end, moving with it, where roundings have moved it by more
    /// than a few bits.
    pub(crate) fn straighten(&mut self, rate: f64) {
        self.put(load_of(&self.y).straightened(self.y[10], rate));
    }

    /// How fast its rope is paid out, in m/s.
    fn paid(&self, r: &Reduced<f64>) -> f64 {
        r.paid(self.y[11], self.y[1])
    }

    /// Its rope at a head that moves so with each joint (m).
    fn rope(&self, r: &Reduced<f64>, head: &[Vector3<f64>; 2]) -> HeadRope<f64, 2> {
        HeadRope::new(load_of(&self.y).place, head).led(r.lead.map(|[lead, _]| lead))
    }
}

/// Angles of the rope in rad: in the plane of the mechanism from the vertical, in (−π, π], forward positive;
/// and from that plane, in [−π/2, π/2], left positive.
#[must_use]
pub fn angles<C: Calc, const N: usize>(y: &[C; N]) -> [C; 2] {
    load_of(y).angles()
}

/// Distance of the load from the head, in m.
#[must_use]
pub fn distance<C: Calc, const N: usize>(y: &[C; N]) -> C {
    squared(load_of(y).place).sqrt()
}

/// How a rope acts on the load where luffing at an angular velocity (rad/s) adds to it.
fn led<C: Calc>(line: RopeAction<C>, r: &Reduced<C>, omega: C) -> RopeAction<C> {
    match (line, r.bend(omega)) {
        (RopeAction::Taut { rate, gain, drum }, Some(bend)) => RopeAction::Taut {
            rate: r.paid(rate, omega),
            gain: Some(gain.map_or(bend, |gain| gain + bend)),
            drum,
        },
        (line, _) => line,
    }
}

fn load_of<C: Calc, const N: usize>(y: &[C; N]) -> HangingLoad<C> {
    HangingLoad::of(&std::array::from_fn(|i| y[i + 4]))
}

impl<const N: usize, P: Calc> Hangs<N, 2, P> for MovingCrane<N, 2, P> {
    const OWN: usize = STATES;

    const LENGTH: usize = 10;

    type Accelerations<C: Calc> = Accelerations<C, 2>;

    fn reach<C: Calc>(y: &[C; N]) -> [C; 2] {
        let load = load_of(y);
        let (distance, direction) = to_load(load.place);
        [distance, dot(direction, load.rate).def(&s::V_Q)]
    }

    fn accelerations<C: Coordinate<P>>(&self, at: &Snapshot<N, 2, C>) -> Accelerations<C, 2> {
        let Snapshot { state, r, y, .. } = *at;
        let moment = |i: usize| {
            let drive = self.drive(i, at);
            let resistance = self.joints[i].over().resistance(state.joints[i], y[2 * i + 1], &drive);
            drive.moment + resistance.def([&s::M_R, &s::M_R_SL][i])
        };
        let free = state.joints.map(|joint| joint != Bar::Held);
        let line = led(self.line(at), r, y[1]);
        let aside = self.dynamics.pushed_aside(y[2]);
        let mut moments = [moment(0), aside.map_or_else(|| moment(1), |aside| moment(1) + aside)];
        if let Some([lifts, turns]) = self.dynamics.leaned(r, y[2]) {
            moments = [moments[0] + lifts, moments[1] + turns];
        }
        let air = self.dynamics.stream(y[2]);
        let around = self.dynamics.surroundings(state.grounded, air.as_ref(), y[2]);
        self.dynamics
            .slewed(r, [y[1], y[3]], load_of(y), moments, line, free, around)
    }

    fn rates_by<C: Coordinate<P>>(&self, a: &Accelerations<C, 2>, at: &Snapshot<N, 2, C>) -> [C; N] {
        let y = at.y;
        let mut out = [C::constant(0.0); N];
        out[..RIGID].copy_from_slice(&[y[1], a.joints[0], y[3], a.joints[1]]);
        if self.hoist().is_some() {
            out[4..7].copy_from_slice(a.rate.as_slice());
            out[7..10].copy_from_slice(a.load.as_slice());
            out[10] = at.r.paid(y[11], y[1]);
        }
        out
    }

    fn tension_by<C: Coordinate<P>>(&self, a: &Accelerations<C, 2>, _: &Snapshot<N, 2, C>) -> C {
        a.rope
    }

    fn slackening_by<C: Coordinate<P>>(&self, a: &Accelerations<C, 2>, _: &Snapshot<N, 2, C>) -> C {
        a.slackening
    }

    fn raised<C: Coordinate<P>>(&self, ground: P, at: &Snapshot<N, 2, C>) -> Raised<C> {
        let (place, head) = (load_of(at.y).place, at.r.head[0].y);
        Raised::above(ground, head + place.y, -to_load(place).1.y)
    }

    fn felt<C: Coordinate<P>>(&self, at: &Snapshot<N, 2, C>) -> Option<[C; 2]> {
        let Snapshot { state, r, y, .. } = *at;
        let stream = self.dynamics.stream(y[2])?;
        Some(stream.felt(self.velocity(state, r, y).1))
    }

    fn needs<C: Coordinate<P>>(&self, i: usize, at: &Snapshot<N, 2, C>) -> C {
        let Snapshot { state, r, y, commands } = *at;
        let [_, slope] = r.turn;
        let (omega, turning) = (y[1], y[3]);
        // What drives the joint besides the rope, as in the equations of motion at rest of this joint.
        let mut force = match i {
            0 => self.drive(0, at).moment - r.moment + C::constant(0.5) * slope * turning.square(),
            _ => commands.drives[1].moment - slope * omega * turning,
        };
        if let Some(aside) = self.dynamics.pushed_aside(y[2]).filter(|_| i > 0) {
            force += aside;
        }
        if let Some(leaned) = self.dynamics.leaned(r, y[2]) {
            force += leaned[i];
        }
        if state.taut && self.hoist().is_some() {
            let a = self.accelerations(at);
            force += a.rope * a.arms[i];
        }
        -force
    }
}

impl<const N: usize, P: Calc> MovingCrane<N, 2, P> {
    /// The load's place from the slewing axis (m) and its velocity (m/s) against the ground, in the frame that slews.
    fn velocity<C: Coordinate<P>>(
        &self,
        state: &CraneState<N, 2>,
        r: &Reduced<C>,
        y: &[C; N],
    ) -> (Vector3<C>, Vector3<C>) {
        let head = self.dynamics.head(r);
        let mut load = load_of(y);
        if self.is_kept(state) {
            load = load.on_rope(&HeadRope::new(load.place, &head), r.paid(y[11], y[1]));
        }
        let place = load.place + Vector3::new(head[1].z, r.head[0].y, C::constant(0.0));
        let of_luffing = head[0].map(|part| part * y[1]);
        (place, load.rate + of_luffing + turned(place).map(|part| part * y[3]))
    }
}

impl<const N: usize> Struck<N, 2> for MovingCrane<N, 2> {
    fn jumped(before: &CraneState<N, 2>, after: &CraneState<N, 2>) -> bool {
        let rates = |state: &CraneState<N, 2>| (state.y[1], state.y[3], state.y[11], state.taut);
        rates(before) != rates(after)
    }

    fn wound(&self, state: &mut CraneState<N, 2>, _: f64, jump: f64) -> Result<(), Halt> {
        state.taut = jump < 0.0;
        if let (true, Some(load)) = (state.taut, &self.dynamics.pendulum().copied()) {
            let r = self.reduced(state, state.y[0]).ok_or(Halt::Outside)?;
            self.catch(state, &r, load.mass, -jump);
        }
        Ok(())
    }

    /// A taut rope that the head would run away from pulls load and other joint along; one that it would push lets go.
    fn stopped(&self, i: usize, state: &mut CraneState<N, 2>, r: &Reduced<f64>) {
        let Some(pendulum) = self.dynamics.pendulum().copied() else {
            return;
        };
        let head = self.dynamics.head(r);
        let mut lost = [0.0; 2];
        lost[i] = -state.y[2 * i + 1];
        if !self.is_kept(state) {
            self.shift(state, &head, lost, Vector3::zeros());
            return;
        }
        let rope = state.rope(r, &head);
        let ease = self.ease(state, r);
        let give = self.giving(state, &rope, ease, pendulum.mass);
        let pull = -(rope.arms[i] * lost[i]) / give;
        state.taut = pull >= 0.0;
        self.jerk(state, &head, &rope, ease, pull.max(0.0), pendulum.mass, lost);
    }

    fn switched(&self, state: &mut CraneState<N, 2>, r: &Reduced<f64>, commands: &Commands<2>) {
        let Some(pendulum) = self.dynamics.pendulum().copied() else {
            return;
        };
        if !state.taut {
            let (load, head) = (load_of(&state.y), self.dynamics.head(r));
            let rope = state.rope(r, &head);
            let excess = rope.direction.dot(&load.rate) - state.paid(r);
            if rope.length < state.y[10] || excess <= 0.0 {
                return;
            }
            self.catch(state, r, pendulum.mass, excess);
        }
        state.straighten(state.paid(r));
        state.taut = self.accelerations(&state.at(r, commands)).slackening >= 0.0;
    }

    fn hauled(&self, state: &mut CraneState<N, 2>, r: &Reduced<f64>, give: impl FnOnce(f64) -> f64, way: f64) {
        let ease = self.ease(state, r);
        let Some(pendulum) = self.dynamics.pendulum().copied() else {
            state.y[1] += give(ease[0]);
            return;
        };
        let head = self.dynamics.head(r);
        let rope = state.rope(r, &head);
        let (kept, led) = (self.is_kept(state), self.is_kept(state) && rope.arms[0] * way <= 0.0);
        // What the load's own speed changes by, for a change of luffing that is all its own.
        let mut share = 0.0;
        if led {
            share = -rope.arms[0] / self.giving(state, &rope, ease, pendulum.mass);
        }
        let heavy = pendulum.mass * share * rope.arms[0] * ease[0];
        let change = give(ease[0] * (1.0 + heavy)) / (1.0 + heavy);
        state.y[1] += change;
        self.jerk(state, &head, &rope, ease, share * change, pendulum.mass, [change, 0.0]);
        state.taut &= led || !kept;
    }

    fn put_down(&self, state: &mut CraneState<N, 2>, r: &Reduced<f64>, ground: f64) {
        let (head, mut load) = (self.dynamics.head(r), load_of(&state.y));
        let below = r.head[0].y - ground;
        if (load.place.y + below).abs() > FEW * below.abs() {
            load.place.y = -below;
        }
        let place = load.place + Vector3::new(head[1].z, 0.0, 0.0);
        load.rate = -head[0] * state.y[1] - turned(place) * state.y[3];
        state.put(load);
    }

    fn height_and_speed(&self, state: &CraneState<N, 2>, r: &Reduced<f64>) -> [f64; 2] {
        let (place, velocity) = self.velocity(state, r, &state.y);
        let potential = -self.dynamics.gravity_at(state.y[2]).dot(&place);
        [potential, velocity.norm_squared()]
    }
}

impl<const N: usize> MovingCrane<N, 2> {
    /// The rope's end goes away from the load at a speed (m/s): a plastic blow.
    fn catch(&self, state: &mut CraneState<N, 2>, r: &Reduced<f64>, mass: f64, excess: f64) {
        let head = self.dynamics.head(r);
        let (rope, ease) = (state.rope(r, &head), self.ease(state, r));
        let give = self.giving(state, &rope, ease, mass);
        self.jerk(state, &head, &rope, ease, excess / give, mass, [0.0; 2]);
        state.taut = true;
    }

    /// How much easier a load of a mass (kg) gives way along the rope than by itself, as joints and drum do too.
    fn giving(&self, state: &CraneState<N, 2>, rope: &HeadRope<f64, 2>, ease: [f64; 2], mass: f64) -> f64 {
        let drum = self.hoist().map_or(0.0, |hoist| state.drum.ease(hoist));
        rope.giving(ease, mass, drum)
    }

    /// One over the inertia of each joint that moves.
    fn ease(&self, state: &CraneState<N, 2>, r: &Reduced<f64>) -> [f64; 2] {
        let inertias = [r.inertia, r.turn[0]];
        [0, 1].map(|i| match state.joints[i] {
            Bar::Held => 0.0,
            _ => 1.0 / inertias[i],
        })
    }

    /// A blow of the rope that changes the load's own speed by `pull` (m/s) towards the head, with what the
    /// joints' rates change by besides.
    #[expect(clippy::too_many_arguments, reason = "what a blow is made of")]
    fn jerk(
        &self,
        state: &mut CraneState<N, 2>,
        head: &[Vector3<f64>; 2],
        rope: &HeadRope<f64, 2>,
        ease: [f64; 2],
        pull: f64,
        mass: f64,
        mut change: [f64; 2],
    ) {
        for i in 0..2 {
            let more = mass * pull * rope.arms[i] * ease[i];
            change[i] += more;
            state.y[2 * i + 1] += more;
            state.joints[i] = state.joints[i].struck(state.y[2 * i + 1]);
        }
        let drum = self.hoist().map_or(0.0, |hoist| state.drum.ease(hoist));
        if drum > 0.0 {
            state.y[11] += mass * pull * drum;
            state.drum.way = state.drum.way.struck(state.y[11]);
        }
        self.shift(state, head, change, -rope.direction * pull);
    }

    /// The load's rate as the head's changes under it, and its own by `own` (m/s).
    fn shift(&self, state: &mut CraneState<N, 2>, head: &[Vector3<f64>; 2], change: [f64; 2], own: Vector3<f64>) {
        state.put(load_of(&state.y).shifted(head, change, own));
    }

    /// Angular momentum about the slewing axis, in kg·m²/s; `None` where the linkage does not close.
    #[must_use]
    pub fn angular_momentum(&self, state: &CraneState<N, 2>) -> Option<f64> {
        let r = self.reduced(state, state.y[0])?;
        let own = r.turn[0] * state.y[3];
        let Some(pendulum) = self.dynamics.pendulum().copied() else {
            return Some(own);
        };
        let (place, velocity) = self.velocity(state, &r, &state.y);
        Some(own + pendulum.mass * (place.x * velocity.z - place.z * velocity.x))
    }
}
