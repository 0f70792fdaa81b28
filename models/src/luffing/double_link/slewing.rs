//! Levels `rigid` and `swing` of a crane that slews: luffing and slewing as two
//! joints, each with friction that truly sticks, a brake and end stops, and the
//! load on a rope that swings in all directions, is reeled, and may go slack.
//!
//! The equations are in [`hanging`](crate::luffing::double_link::hanging), and so is the frame.

use nalgebra::Vector3;

use crate::kernel::calc::Calc;
use crate::luffing::double_link::dynamics::{Coordinate, Dynamics, Reduced};
use crate::luffing::double_link::hanging::{Accelerations, HangingLoad, Rope, dot, squared, to_load, turned};
use crate::luffing::double_link::motion::{Friction, MOST_CHANGES, REELED_IN, lost};
use crate::luffing::double_link::moving::symbols as s;
use crate::parts::hoist::{Drum, Elastic, Hoist, HoistCommand, HoistPowers, RopeAction};
use crate::parts::joint::{Bar, JointDrive, LOOSE, above_zero, capped};
use crate::parts::solver::pieces::{self, Pieces};
use crate::parts::solver::{Count, Halt, finite};

/// Number of states: angle and rate of the driven bar, of slewing, the load from the head and its rate in
/// the frame that slews, the rope's length, the rate at which it is paid out; rad, m, s.
pub const STATES: usize = 12;
/// States without a load on a rope.
pub const RIGID: usize = 4;
/// Number of event indicators.
pub const INDICATORS: usize = 11;

/// What drives the motion; constant over a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlewingCommands<P = f64> {
    /// Of luffing and slewing.
    pub drives: [JointDrive<P>; 2],
    pub hoist: HoistCommand<P>,
}

/// Luffing or slewing, at no particular angle.
#[derive(Clone, Copy, Debug)]
pub struct Joint<P = f64> {
    pub friction: Friction<P>,
    /// Least and greatest angle, in rad; infinite where there is no stop.
    pub stops: [f64; 2],
}

/// A motion at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlewingState {
    pub y: [f64; STATES],
    pub joints: [Bar; 2],
    pub drum: Drum,
    /// The load hangs on the rope, or flies free.
    pub taut: bool,
    /// Energy that blows have taken so far, in J; what they gave counts negative.
    pub blown: f64,
}

impl SlewingState {
    /// At rest at an angle of the driven bar (rad), the load hanging on a rope of a length (m).
    #[must_use]
    pub fn resting(theta: f64, length: f64) -> SlewingState {
        let mut y = [0.0; STATES];
        y[0] = theta;
        y[10] = length;
        let mut state = SlewingState {
            y,
            joints: [Bar::Held; 2],
            drum: Drum::at(0.0),
            taut: true,
            blown: 0.0,
        };
        state.put_load([0.0; 2]);
        state
    }

    /// The hoist runs as commanded, at a rate of paying out (m/s).
    pub fn wind(&mut self, rate: f64) {
        (self.y[11], self.drum) = (rate, Drum::at(rate));
    }

    /// Puts the load at rest at the end of its rope, at angles (rad) from the vertical in the plane of the
    /// mechanism, forward positive, and from that plane, left positive.
    pub fn put_load(&mut self, [swing, side]: [f64; 2]) {
        let ((sin, cos), (aside, within)) = (Calc::sin_cos(swing), Calc::sin_cos(side));
        let direction = Vector3::new(within * sin, -within * cos, aside);
        let place = direction * self.y[10];
        self.y[4..7].copy_from_slice(place.as_slice());
        self.y[7..10].fill(0.0);
    }

    /// Puts the load of a taut rope at its end, moving with it, where roundings have moved it by more than a few bits.
    pub(crate) fn straighten(&mut self) {
        let load = load_of(&self.y);
        let length = load.place.norm();
        let direction = load.place / length;
        let hoist = self.y[11];
        let excess = direction.dot(&load.rate) - hoist;
        let few = 16.0 * f64::EPSILON;
        if (length - self.y[10]).abs() > few * length {
            let place = direction * self.y[10];
            self.y[4..7].copy_from_slice(place.as_slice());
        }
        if excess.abs() > few * (load.rate.norm() + hoist.abs()) {
            self.y[7..10].copy_from_slice((load.rate - direction * excess).as_slice());
        }
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

/// Angles of the rope in rad: in the plane of the mechanism from the vertical, in (−π, π], forward positive;
/// and from that plane, in [−π/2, π/2], left positive.
#[must_use]
pub fn angles<C: Calc>(y: &[C; STATES]) -> [C; 2] {
    let place = load_of(y).place;
    let quarter = C::constant(std::f64::consts::FRAC_PI_2);
    let within = (place.x.square() + place.y.square()).sqrt();
    [
        C::direction(-place.x, -place.y) - quarter,
        C::direction(within, place.z),
    ]
}

/// Distance of the load from the head, in m.
#[must_use]
pub fn distance<C: Calc>(y: &[C; STATES]) -> C {
    squared(load_of(y).place).sqrt()
}

/// Distance of the load from the head (m), and how fast it goes away from it (m/s).
fn going<C: Calc>(y: &[C; STATES]) -> [C; 2] {
    let load = load_of(y);
    let (distance, direction) = to_load(load.place);
    [distance, dot(direction, load.rate).def(&s::V_Q)]
}

/// A crane that luffs and slews.
#[derive(Clone, Copy, Debug)]
pub struct Slewing<P = f64> {
    /// On a turntable.
    pub dynamics: Dynamics<P>,
    pub joints: [Joint<P>; 2],
}

fn load_of<C: Calc>(y: &[C; STATES]) -> HangingLoad<C> {
    HangingLoad {
        place: Vector3::new(y[4], y[5], y[6]),
        rate: Vector3::new(y[7], y[8], y[9]),
    }
}

impl<P: Calc> Slewing<P> {
    fn hoist(&self) -> Option<&Hoist<P>> {
        self.dynamics.bodies().pendulum.as_ref().map(|load| &load.hoist)
    }

    /// Whether the rope keeps the load at its end: it is taut, and keeps its length under any force.
    pub(crate) fn is_kept(&self, state: &SlewingState) -> bool {
        state.taut && self.hoist().is_some_and(|hoist| hoist.rope.is_none())
    }

    /// How the rope acts on the load.
    fn line<C: Coordinate<P>>(
        &self,
        state: &SlewingState,
        y: &[C; STATES],
        commands: &SlewingCommands<C>,
    ) -> RopeAction<C> {
        match self.hoist().filter(|_| state.taut) {
            None => RopeAction::Slack,
            Some(hoist) => match &hoist.rope {
                None => RopeAction::Taut {
                    rate: y[11],
                    gain: state.drum.ramp(hoist),
                    drum: state.drum.turning(hoist, &commands.hoist),
                },
                Some(rope) => RopeAction::Force(Self::stretched(rope, y)[1].def(&s::S_R)),
            },
        }
    }

    /// Forces of a stretched rope, in N.
    fn stretched<C: Coordinate<P>>(rope: &Elastic<P>, y: &[C; STATES]) -> [C; 2] {
        let [distance, speed] = going(y);
        rope.forces((distance - y[10]).def(&s::DELTA_R), speed - y[11])
    }

    /// Greatest moment of dry friction and brake of a joint, in N·m.
    fn dry<C: Coordinate<P>>(&self, i: usize, commands: &SlewingCommands<C>) -> C {
        C::of(self.joints[i].friction.coulomb) + commands.drives[i].brake
    }

    /// Moment of friction and brake on a joint that moves, in N·m.
    fn resistance<C: Coordinate<P>>(
        &self,
        i: usize,
        state: &SlewingState,
        y: &[C; STATES],
        commands: &SlewingCommands<C>,
    ) -> C {
        let viscous = -C::of(self.joints[i].friction.viscous) * y[2 * i + 1];
        let resistance = match state.joints[i] {
            Bar::Held | Bar::Loose => C::constant(0.0),
            Bar::Forward => viscous - self.dry(i, commands),
            Bar::Backward => viscous + self.dry(i, commands),
        };
        resistance.def([&s::M_R, &s::M_R_SL][i])
    }

    pub(crate) fn accelerations<C: Coordinate<P>>(
        &self,
        state: &SlewingState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &SlewingCommands<C>,
    ) -> Accelerations<C> {
        let moments = [0, 1].map(|i| commands.drives[i].moment + self.resistance(i, state, y, commands));
        let free = state.joints.map(|joint| joint != Bar::Held);
        let line = self.line(state, y, commands);
        self.dynamics.slewed(r, [y[1], y[3]], load_of(y), moments, line, free)
    }

    /// Rates of all states between events; `None` where the linkage does not close or nothing is left of the rope.
    #[must_use]
    pub fn rates<C: Coordinate<P>>(
        &self,
        state: &SlewingState,
        commands: &SlewingCommands<C>,
        y: &[C; STATES],
    ) -> Option<[C; STATES]> {
        if self.is_reeled_in(y[10]) {
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
    pub(crate) fn rates_at<C: Coordinate<P>>(
        &self,
        state: &SlewingState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &SlewingCommands<C>,
    ) -> [C; STATES] {
        let a = self.accelerations(state, r, y, commands);
        let mut out = [C::constant(0.0); STATES];
        out[..RIGID].copy_from_slice(&[y[1], a.joints[0], y[3], a.joints[1]]);
        if let Some(hoist) = self.hoist() {
            let mut load = load_of(y);
            if self.is_kept(state) {
                load = load.on_rope(&Rope::new(load.place, &self.dynamics.head(r)), y[11]);
            }
            out[4..7].copy_from_slice(load.rate.as_slice());
            out[7..10].copy_from_slice(a.load.as_slice());
            out[10] = y[11];
            if let Some(gain) = state.drum.gain(hoist, &commands.hoist, || a.rope) {
                out[11] = gain.def(&s::D_V_R);
            }
        }
        out
    }

    /// Moment that friction, brake and stops must give to hold a joint at rest, in N·m, with the least and
    /// greatest that they can.
    fn held<C: Coordinate<P>>(
        &self,
        i: usize,
        state: &SlewingState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &SlewingCommands<C>,
    ) -> [C; 3] {
        let [_, slope] = r.turn;
        let (omega, turning) = (y[1], y[3]);
        // What drives the joint besides the rope, as in the equations of motion at rest of this joint.
        let mut force = match i {
            0 => commands.drives[0].moment - r.moment + C::constant(0.5) * slope * turning.square(),
            _ => commands.drives[1].moment - slope * omega * turning,
        };
        if state.taut && self.dynamics.bodies().pendulum.is_some() {
            let rope = Rope::new(load_of(y).place, &self.dynamics.head(r));
            force += self.accelerations(state, r, y, commands).rope * rope.arms[i];
        }
        let (dry, without_end) = (self.dry(i, commands) * C::constant(LOOSE), C::constant(f64::INFINITY));
        let ([low, high], at) = (self.joints[i].stops, y[2 * i].value());
        [
            -force,
            if at >= high { -without_end } else { -dry },
            if at <= low { without_end } else { dry },
        ]
    }

    /// Force of the rope, in N; zero where it is slack or there is none.
    #[must_use]
    pub fn rope_force<C: Coordinate<P>>(
        &self,
        state: &SlewingState,
        commands: &SlewingCommands<C>,
        y: &[C; STATES],
    ) -> Option<C> {
        let r = C::reduced(&self.dynamics, y[0])?;
        Some(self.accelerations(state, &r, y, commands).rope)
    }

    /// Moment of friction, brake and end stop on luffing (0) or slewing (1), in N·m, in the direction of the angle.
    #[must_use]
    pub fn friction_moment<C: Coordinate<P>>(
        &self,
        i: usize,
        state: &SlewingState,
        commands: &SlewingCommands<C>,
        y: &[C; STATES],
    ) -> Option<C> {
        let r = C::reduced(&self.dynamics, y[0])?;
        Some(self.friction_at(i, state, &r, y, commands))
    }

    /// The same where it is known what the mechanism is at this angle.
    pub(crate) fn friction_at<C: Coordinate<P>>(
        &self,
        i: usize,
        state: &SlewingState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &SlewingCommands<C>,
    ) -> C {
        match state.joints[i] {
            Bar::Held => self.held(i, state, r, y, commands)[0],
            _ => self.resistance(i, state, y, commands),
        }
    }

    /// Moment of brake and friction on the drum of a motor, in N·m; positive reels in.
    pub(crate) fn drum_friction<C: Coordinate<P>>(
        &self,
        state: &SlewingState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &SlewingCommands<C>,
    ) -> C {
        let rope = || self.accelerations(state, r, y, commands).rope;
        let friction = |hoist: &Hoist<P>| state.drum.friction(hoist, &commands.hoist, rope());
        self.hoist().map_or(C::constant(0.0), friction)
    }

    /// Numbers whose fall below zero ends a smooth piece: luffing comes to rest or (two) breaks loose, meets
    /// its lower or upper stop; the same for slewing; the rope becomes slack or taut; the hoist runs as commanded, or comes
    /// to rest or (two) breaks loose. After an event all are above zero.
    #[must_use]
    pub fn indicators<C: Coordinate<P>>(
        &self,
        state: &SlewingState,
        commands: &SlewingCommands<C>,
        y: &[C; STATES],
    ) -> Option<[C; INDICATORS]> {
        let r = C::reduced(&self.dynamics, y[0])?;
        Some(self.indicators_at(state, &r, y, commands))
    }

    /// The same where it is known what the mechanism is at this angle.
    pub(crate) fn indicators_at<C: Coordinate<P>>(
        &self,
        state: &SlewingState,
        r: &Reduced<C>,
        y: &[C; STATES],
        commands: &SlewingCommands<C>,
    ) -> [C; INDICATORS] {
        let mut out = [C::constant(1.0); INDICATORS];
        for i in 0..2 {
            let (at, rate, first) = (y[2 * i], y[2 * i + 1], 4 * i);
            out[first] = match state.joints[i] {
                Bar::Held => {
                    let [hold, least, most] = self.held(i, state, r, y, commands);
                    // Where a stop gives any moment there is nothing to break.
                    out[first + 1] = capped(hold - least);
                    out[first] = capped(most - hold);
                    continue;
                }
                Bar::Forward => rate,
                Bar::Backward => -rate,
                Bar::Loose => continue,
            };
            let [low, high] = self.joints[i].stops;
            for (place, end, room) in [(2, low, at - C::constant(low)), (3, high, C::constant(high) - at)] {
                if end.is_finite() {
                    out[first + place] = room;
                }
            }
        }
        if let Some(hoist) = self.hoist() {
            out[8] = match &hoist.rope {
                Some(rope) => Elastic::<P>::slackening(state.taut, Self::stretched(rope, y)),
                None if state.taut => self.accelerations(state, r, y, commands).slackening,
                None => y[10] * C::constant(LOOSE) - distance(y),
            };
            let rope = || self.accelerations(state, r, y, commands).rope;
            [out[9], out[10]] = state.drum.reaching(hoist, &commands.hoist, y[11], rope);
        }
        out.map(above_zero)
    }
}

impl Slewing {
    /// Decides what follows at an instant, as often as one event causes another. Returns whether anything changed.
    ///
    /// # Errors
    /// The linkage does not close, or a number overflows.
    pub fn event(&self, state: &mut SlewingState, commands: &SlewingCommands) -> Result<bool, Halt> {
        let first = *state;
        for i in 0..2 {
            if state.y[2 * i + 1] == 0.0 && state.joints[i] != Bar::Loose {
                // At rest it is decided again which way it goes, as the commands may have changed.
                state.joints[i] = Bar::Held;
            }
        }
        self.wind(state, commands)?;
        for _ in 0..MOST_CHANGES {
            let before = *state;
            let r = f64::reduced(&self.dynamics, state.y[0]).ok_or(Halt::Outside)?;
            for i in 0..2 {
                self.stop_joint(i, state, &r);
            }
            self.switch_rope(state, &r, commands);
            for i in 0..2 {
                if state.joints[i] == Bar::Held {
                    state.joints[i] = Bar::loosened(self.held(i, state, &r, &state.y, commands));
                }
            }
            if let Some(hoist) = self.hoist() {
                let rope = || self.accelerations(state, &r, &state.y, commands).rope;
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
        let jumps = |state: &SlewingState| (state.y[1], state.y[3], state.y[11], state.taut);
        if jumps(state) != jumps(&first) {
            state.blown += lost(self.energy(&first).zip(self.energy(state)));
        }
        Ok(*state != first)
    }

    /// The hoist follows its command. Where it does so at once the load goes on as it did: the rope lets go, or gives
    /// it a blow.
    fn wind(&self, state: &mut SlewingState, commands: &SlewingCommands) -> Result<(), Halt> {
        let Some(load) = &self.dynamics.bodies().pendulum else {
            return Ok(());
        };
        let (drum, rate, jump) = state.drum.decided(&load.hoist, state.y[11], &commands.hoist);
        (state.drum, state.y[11]) = (drum, rate);
        if self.is_kept(state) && jump != 0.0 {
            state.taut = jump < 0.0;
            if state.taut {
                let r = f64::reduced(&self.dynamics, state.y[0]).ok_or(Halt::Outside)?;
                self.catch(state, &r, load.mass, -jump);
            }
        }
        Ok(())
    }

    /// The rope's end goes away from the load at a speed (m/s): a plastic blow.
    fn catch(&self, state: &mut SlewingState, r: &Reduced<f64>, mass: f64, excess: f64) {
        let head = self.dynamics.head(r);
        let (rope, ease) = (Rope::new(load_of(&state.y).place, &head), self.ease(state, r));
        let give = self.giving(state, &rope, ease, mass);
        self.jerk(state, &head, &rope, ease, excess / give, mass, [0.0; 2]);
        state.taut = true;
    }

    /// A joint that has reached a stop, or turned round, is at rest.
    fn stop_joint(&self, i: usize, state: &mut SlewingState, r: &Reduced<f64>) {
        let (at, rate) = (state.y[2 * i], state.y[2 * i + 1]);
        let [low, high] = self.joints[i].stops;
        let at_stop = (at >= high && rate > 0.0) || (at <= low && rate < 0.0);
        let turned = match state.joints[i] {
            Bar::Held => rate != 0.0,
            // A joint that breaks loose is at rest: whether the rope lets go is decided as it moves.
            Bar::Forward => rate < 0.0,
            Bar::Backward => rate > 0.0,
            Bar::Loose => return,
        };
        if state.joints[i] == Bar::Held && turned && !at_stop {
            // Set in motion from outside.
            state.joints[i] = if rate > 0.0 { Bar::Forward } else { Bar::Backward };
        } else if at_stop || turned {
            state.joints[i] = Bar::Held;
            if at_stop {
                state.y[2 * i] = at.clamp(low, high);
                self.blow(state, r, i);
            }
            state.y[2 * i + 1] = 0.0;
        }
    }

    /// The joint stops at once; the load goes on. A taut rope that the head would run away from pulls load
    /// and other joint along; one that it would push lets go.
    fn blow(&self, state: &mut SlewingState, r: &Reduced<f64>, i: usize) {
        let Some(pendulum) = self.dynamics.bodies().pendulum else {
            return;
        };
        let head = self.dynamics.head(r);
        let mut lost = [0.0; 2];
        lost[i] = -state.y[2 * i + 1];
        if !self.is_kept(state) {
            self.shift(state, &head, lost, Vector3::zeros());
            return;
        }
        let rope = Rope::new(load_of(&state.y).place, &head);
        let ease = self.ease(state, r);
        let give = self.giving(state, &rope, ease, pendulum.mass);
        let pull = -(rope.arms[i] * lost[i]) / give;
        state.taut = pull >= 0.0;
        self.jerk(state, &head, &rope, ease, pull.max(0.0), pendulum.mass, lost);
    }

    /// How much easier a load of a mass (kg) gives way along the rope than by itself, as joints and drum do too.
    fn giving(&self, state: &SlewingState, rope: &Rope<f64>, ease: [f64; 2], mass: f64) -> f64 {
        let drum = self.hoist().map_or(0.0, |hoist| state.drum.ease(hoist));
        1.0 + mass * (rope.arms[0].powi(2) * ease[0] + rope.arms[1].powi(2) * ease[1] + drum)
    }

    /// One over the inertia of each joint that moves.
    fn ease(&self, state: &SlewingState, r: &Reduced<f64>) -> [f64; 2] {
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
        state: &mut SlewingState,
        head: &[Vector3<f64>; 2],
        rope: &Rope<f64>,
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
    fn shift(&self, state: &mut SlewingState, head: &[Vector3<f64>; 2], change: [f64; 2], own: Vector3<f64>) {
        let place = load_of(&state.y).place + Vector3::new(head[1].z, 0.0, 0.0);
        let rate = own - head[0] * change[0] - turned(place) * change[1];
        for (y, rate) in state.y[7..10].iter_mut().zip(&rate) {
            *y += rate;
        }
    }

    /// The rope lets go where it would push, and catches the load with a plastic blow along itself.
    fn switch_rope(&self, state: &mut SlewingState, r: &Reduced<f64>, commands: &SlewingCommands) {
        let Some(pendulum) = self.dynamics.bodies().pendulum else {
            return;
        };
        if let Some(rope) = &pendulum.hoist.rope {
            state.taut = Elastic::<f64>::pulls(state.taut, Self::stretched(rope, &state.y));
            return;
        }
        if !state.taut {
            let (load, head) = (load_of(&state.y), self.dynamics.head(r));
            let rope = Rope::new(load.place, &head);
            let excess = rope.direction.dot(&load.rate) - state.y[11];
            if rope.length < state.y[10] || excess <= 0.0 {
                return;
            }
            self.catch(state, r, pendulum.mass, excess);
        }
        state.straighten();
        state.taut = self.accelerations(state, r, &state.y, commands).slackening >= 0.0;
    }

    /// Moves on by a duration (s) in equal steps of at most `longest` (s), events located on the way. Returns
    /// the work done.
    ///
    /// # Errors
    /// See [`Halt`]; the state is that of the last step that succeeded.
    pub fn advance(
        &self,
        state: &mut SlewingState,
        commands: &SlewingCommands,
        duration: f64,
        longest: f64,
    ) -> Result<Count, Halt> {
        if !(commands.drives.iter().all(JointDrive::is_sound) && commands.hoist.is_sound()) {
            return Err(Halt::Outside);
        }
        let commanded = Commanded { crane: self, commands };
        pieces::advance(&commanded, state, duration, longest)
    }

    /// Kinetic and potential energy, in J; `None` where the linkage does not close.
    #[must_use]
    pub fn energy(&self, state: &SlewingState) -> Option<f64> {
        let r = f64::reduced(&self.dynamics, state.y[0])?;
        let (omega, turning) = (state.y[1], state.y[3]);
        let bars = 0.5 * (r.inertia * omega * omega + r.turn[0] * turning * turning) + r.energy;
        let Some(pendulum) = self.dynamics.bodies().pendulum else {
            return Some(bars);
        };
        let (place, velocity) = self.velocity(state, &r);
        let load = pendulum.mass * (0.5 * velocity.norm_squared() + self.dynamics.bodies().gravity * place.y);
        let stretch = distance(&state.y) - state.y[10];
        Some(bars + load + pendulum.hoist.energy(state.y[11], stretch))
    }

    /// What the hoist gives and takes; `None` where the linkage does not close.
    pub(crate) fn hoist_powers(&self, state: &SlewingState, commands: &SlewingCommands) -> Option<HoistPowers> {
        let Some(hoist) = self.hoist() else {
            return Some(HoistPowers::default());
        };
        let rope = self.rope_force(state, commands, &state.y)?;
        let (y, [distance, speed]) = (&state.y, going(&state.y));
        let stretch = [distance - y[10], speed - y[11]];
        Some(hoist.powers(state.drum, &commands.hoist, y[11], stretch, rope))
    }

    /// Angular momentum about the slewing axis, in kg·m²/s; `None` where the linkage does not close.
    #[must_use]
    pub fn angular_momentum(&self, state: &SlewingState) -> Option<f64> {
        let r = f64::reduced(&self.dynamics, state.y[0])?;
        let own = r.turn[0] * state.y[3];
        let Some(pendulum) = self.dynamics.bodies().pendulum else {
            return Some(own);
        };
        let (place, velocity) = self.velocity(state, &r);
        Some(own + pendulum.mass * (place.x * velocity.z - place.z * velocity.x))
    }

    /// The load's place from the slewing axis (m) and its velocity (m/s) against the ground, in the frame that slews.
    fn velocity(&self, state: &SlewingState, r: &Reduced<f64>) -> (Vector3<f64>, Vector3<f64>) {
        let head = self.dynamics.head(r);
        let mut load = load_of(&state.y);
        if self.is_kept(state) {
            load = load.on_rope(&Rope::new(load.place, &head), state.y[11]);
        }
        let place = load.place + Vector3::new(head[1].z, r.head[0].y, 0.0);
        (place, load.rate + head[0] * state.y[1] + turned(place) * state.y[3])
    }
}

/// A crane under commands, for the solver.
struct Commanded<'a> {
    crane: &'a Slewing,
    commands: &'a SlewingCommands,
}

impl Pieces<STATES, SlewingState> for Commanded<'_> {
    fn states(state: &mut SlewingState) -> &mut [f64; STATES] {
        &mut state.y
    }

    fn rates(&self, state: &SlewingState, y: &[f64; STATES]) -> Option<[f64; STATES]> {
        self.crane.rates(state, self.commands, y)
    }

    fn crossed(&self, state: &SlewingState, y: &[f64; STATES]) -> bool {
        pieces::crossed(self.crane.indicators(state, self.commands, y))
    }

    fn event(&self, state: &mut SlewingState) -> Result<(), Halt> {
        self.crane.event(state, self.commands).map(|_| ())
    }
}
