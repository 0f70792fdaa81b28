//! What a mechanism with one coordinate is to the equations of motion: its bodies, reduced to that coordinate.
//! [virtual work; Lagrange]

use std::sync::Arc;

use num_dual::Dual64;

use crate::kernel::calc::{Calc, Over};
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::bodies::{Asked, Body, Moves, WeighedBodies};
use crate::luffing::moving::symbols::{self as s, OfSums};
use crate::luffing::moving::weather::Outside;
use crate::parts::plane::{Point, dot, squared};

/// What the equations of motion need at one angle, all by derivatives of the positions.
#[derive(Clone, Copy, Debug)]
pub struct Reduced<C> {
    /// Inertia of all bodies and the counterweight at the driven bar (kg·m²), and its change by the angle.
    pub inertia: C,
    pub slope: C,
    /// Moment of their weights, less those of wind, slope and centrifugal forces where there are any, in N·m; positive lowers the
    /// driven bar.
    pub moment: C,
    /// Height of their centres of gravity times their weights, on a slope the true one, in J.
    pub energy: C,
    /// Head A: place, first and second derivative by the angle, in m.
    pub head: [Point<C>; 3],
    /// Length of the drive (m) and its lever arm (m), which is its derivative by the angle; zero without one.
    pub drive: [C; 2],
    /// Inertia about the slewing axis (kg·m²), and its change by the angle; zero where the crane does not slew.
    pub turn: [C; 2],
    /// Rope that one radian of the angle adds between head and load (m), and its change by the angle, where the mechanism
    /// leads the load's rope away from the head.
    pub lead: Option<[C; 2]>,
    /// All weights, where a crane that slews stands on a slope.
    pub weighed: Option<WeighedBodies<C>>,
    /// Of the motor, whose inertia is a part of the above unless it is loose.
    pub shaft: Option<MotorShaft<C>>,
    /// Moments of wind, slope and centrifugal forces for one radian of the angle (N·m), positive where they raise the driven bar,
    /// where it meets any.
    pub outside: Option<[C; 3]>,
}

/// The shaft of a motor at one angle of the driving link: its turn for one radian of that, its inertia there (kg·m²), and how
/// that changes with the angle; its own inertia (kg·m²), and the drive's travel for one radian of its turn (m); the inertia of
/// the bodies alone (kg·m²), and its change; whether it turns by itself, as the rope between is slack.
#[derive(Clone, Copy, Debug)]
pub struct MotorShaft<C> {
    pub ratio: C,
    pub inertia: C,
    pub slope: C,
    pub own: C,
    pub arm: C,
    pub bodies: [C; 2],
    pub loose: bool,
}

impl<C: Calc> MotorShaft<C> {
    /// ψ′ = s′ / r, I_M = J_M ψ′², I_M′ = 2 J_M ψ′ ψ″, of the drive's travel for one radian and its change (m), on an arm r (m).
    /// (Lagrange)
    pub fn new([travel, bend]: [C; 2], inertia: C, arm: C) -> MotorShaft<C> {
        let ratio = (travel / arm).def(&s::DPSI_M);
        let change = (bend / arm).def(&s::DDPSI_M);
        MotorShaft {
            ratio,
            inertia: (inertia * ratio.square()).def(&s::I_M),
            slope: (C::constant(2.0) * inertia * ratio * change).def(&s::DI_M),
            own: inertia,
            arm,
            bodies: [C::constant(0.0); 2],
            loose: false,
        }
    }

    /// Over another scalar.
    pub fn map<D>(self, f: impl Fn(C) -> D) -> MotorShaft<D> {
        MotorShaft {
            ratio: f(self.ratio),
            inertia: f(self.inertia),
            slope: f(self.slope),
            own: f(self.own),
            arm: f(self.arm),
            bodies: self.bodies.map(f),
            loose: self.loose,
        }
    }

    /// Moment at the driving link of brakes on it (N·m), |ψ′| T. [virtual work]
    pub fn braked(&self, torque: C) -> C {
        match torque.value() {
            0.0 => torque,
            _ => (self.ratio.abs() * torque).def(&s::M_BM),
        }
    }

    /// Moment of its inertia on the driving link (N·m), which turns at a rate (rad/s) with an acceleration (rad/s²), and the
    /// greatest of what that is made of.
    pub fn lags(&self, omega: C, alpha: C) -> (C, f64) {
        let parts = [self.inertia * alpha, C::constant(0.5) * self.slope * omega.square()];
        let [quickens, bends] = parts;
        let most = parts.map(|part| part.value().abs()).into_iter().fold(0.0, f64::max);
        ((-(quickens + bends)).def(&s::M_IM), most)
    }
}

impl<C: Calc> Reduced<C> {
    /// How fast the load's rope is paid out at the head (m/s): by the hoist at a rate (m/s), and by the mechanism at its
    /// angular velocity (rad/s).
    pub fn paid(&self, rate: C, omega: C) -> C {
        self.lead.map_or(rate, |[lead, _]| rate + lead * omega)
    }

    /// Arm of the rope's pull about the driven bar (m), of which `travel` (m) is the head's along the rope.
    pub fn arm(&self, travel: C) -> C {
        self.lead.map_or(travel, |[lead, _]| travel + lead)
    }

    /// What luffing at an angular velocity (rad/s) adds to the acceleration of the rope's length (m/s²), but for that of the
    /// bar.
    pub fn bend(&self, omega: C) -> Option<C> {
        self.lead.map(|[_, change]| change * omega.square())
    }
}

impl<C: Calc> Reduced<C> {
    /// With the shaft of a motor.
    #[must_use]
    pub fn with(self, shaft: MotorShaft<C>) -> Reduced<C> {
        Reduced {
            inertia: (self.inertia + shaft.inertia).def(&s::I_ALL),
            slope: (self.slope + shaft.slope).def(&s::DI_ALL),
            shaft: Some(MotorShaft {
                bodies: [self.inertia, self.slope],
                ..shaft
            }),
            ..self
        }
    }

    /// As it is while the rope to its motor is slack: the bodies alone, beside the shaft.
    #[must_use]
    pub fn freed(self) -> Reduced<C> {
        let Some(shaft) = self.shaft else { return self };
        let [inertia, slope] = shaft.bodies;
        Reduced {
            inertia,
            slope,
            shaft: Some(MotorShaft { loose: true, ..shaft }),
            ..self
        }
    }

    /// The shaft that turns with it.
    pub fn geared(&self) -> Option<&MotorShaft<C>> {
        self.shaft.as_ref().filter(|shaft| !shaft.loose)
    }

    /// With wind and slope, and slewed at an angular velocity (rad/s), as far as it is: M_Ω = Ω² J_sl′ / 2. (Lagrange)
    #[must_use]
    pub fn outside(self, met: Option<Outside<C>>, slewing: Option<C>) -> Reduced<C> {
        let mut found = [C::constant(0.0); 3];
        let (mut moment, mut energy) = (self.moment, self.energy);
        if let Some(met) = met {
            (found[0], found[1]) = (met.wind, met.slope);
            moment = (moment - met.wind - met.slope).def(&s::M_WO);
            energy += met.energy;
        }
        if let Some(omega) = slewing {
            found[2] = (C::constant(0.5) * omega.square() * self.turn[1]).def(&s::M_OMEGA);
            moment = (moment - found[2]).def(&s::M_WC);
        }
        Reduced {
            moment,
            energy,
            outside: Some(found),
            ..self
        }
    }

    /// The sum over N bodies, under gravity in m/s².
    #[inline]
    pub(crate) fn of<P: Calc, const N: usize>(
        bodies: [&Body<P>; N],
        names: [&OfSums; N],
        gravity: P,
        moves: Moves<C, N>,
    ) -> Self
    where
        C: Over<P>,
    {
        let zero = C::constant(0.0);
        let (mut inertia, mut slope, mut moment, mut energy) = (zero, zero, zero, zero);
        for ((body, moved), names) in bodies.into_iter().zip(&moves.bodies).zip(names) {
            let own = body.mass.def(names.mass);
            let (mass, spin) = (C::of(own), C::of(body.inertia));
            let weight = C::of(own * gravity);
            let ([r, v, a], [turn, turn_change]) = (moved.centre, moved.turn);
            inertia += (mass * squared(v) + spin * turn).def(names.inertia);
            slope += (C::constant(2.0) * (mass * dot(v, a) + spin * turn_change)).def(names.slope);
            moment += weight * v.y;
            energy += weight * r.y;
        }
        // What a slope makes of weights it makes of the head, below which a load hangs plumb.
        let (mut rise, mut height) = (zero, zero);
        if let Some((mass, [r, v, a])) = moves.load {
            let mass = mass.def(&s::MASS_Q);
            let weight = mass * C::of(gravity);
            inertia += (mass * squared(v)).def(&s::I_RQ);
            slope += (C::constant(2.0) * (mass * dot(v, a))).def(&s::DI_RQ);
            moment += weight * v.y;
            energy += weight * r.y;
            let [head, travel, _] = moves.head;
            (rise, height) = (weight * (travel.y - v.y), weight * (head.y - r.y));
        }
        if let Some((mass, [r, v, a])) = moves.counterweight {
            let weight = mass * C::of(gravity);
            inertia += (mass * squared(v)).def(&s::I_R5);
            slope += (C::constant(2.0) * mass * dot(v, a)).def(&s::DI_R5);
            moment += weight * v.y;
            energy += weight * r.y;
        }
        let (inertia, slope, moment) = (inertia.def(&s::I_R), slope.def(&s::DI_R), moment.def(&s::M_W));
        Reduced {
            inertia,
            slope,
            moment,
            energy,
            head: moves.head,
            drive: moves.drive,
            turn: moves.turn,
            lead: moves.lead,
            weighed: moves.weighed.map(|[forward, ahead]| WeighedBodies {
                forward,
                travel: Point::new(ahead, if moves.load.is_some() { moment + rise } else { moment }),
                energy: energy + height,
            }),
            shaft: None,
            outside: None,
        }
    }
}

/// What the quantities of a mechanism's coordinate are called.
#[derive(Clone, Copy, Debug)]
pub struct CoordinateNames {
    pub acceleration: &'static Symbol,
    /// Ends of its working range.
    pub stops: [&'static Symbol; 2],
}

/// A mechanism with one coordinate, known as `P`, as the equations of motion see it.
pub trait Reduces<P>: Send + Sync {
    /// `None` where it does not close at this value of its coordinate.
    fn reduced(&self, at: P, asked: &Asked<P>) -> Option<Reduced<P>>;

    /// The same of plain quantities, with one more derivative by the coordinate.
    fn with_slope(&self, at: Dual64, asked: &Asked<P>) -> Option<Reduced<Dual64>>;

    fn names(&self) -> CoordinateNames;

    /// Whether what drives it is a rope, which pulls it up and never pushes.
    fn is_pulled(&self) -> bool {
        false
    }
}

/// A mechanism that its equations of motion share, with rooms for those that come after it. What is shared is never written
/// to: the next one is put where nobody holds the one before, and a copy has rooms of its own. Equations and one saved state
/// hold two of them, so that with three nothing is allocated when a quantity changes; each further saved state adds one, once.
#[derive(Debug)]
pub struct Renewed<T>(Vec<Arc<T>>);

impl<T: Clone> Renewed<T> {
    pub fn new(first: T) -> Renewed<T> {
        let spares = [first.clone(), first.clone()].map(Arc::new);
        Renewed([Arc::new(first)].into_iter().chain(spares).collect())
    }

    /// The one that stands now.
    pub fn now(&self) -> &Arc<T> {
        &self.0[0]
    }

    pub fn put(&mut self, fresh: T) {
        match self.0.iter_mut().position(|room| Arc::get_mut(room).is_some()) {
            Some(free) => {
                self.0.swap(0, free);
                *Arc::get_mut(&mut self.0[0]).expect("nobody holds it") = fresh;
            }
            None => self.0.insert(0, Arc::new(fresh)),
        }
    }

    /// As the function of a stage: into the room that it has.
    pub fn renew(room: &mut Vec<Renewed<T>>, fresh: T) {
        match room.first_mut() {
            Some(held) => held.put(fresh),
            None => room.push(Renewed::new(fresh)),
        }
    }
}

impl<T: Clone> Clone for Renewed<T> {
    fn clone(&self) -> Self {
        Renewed::new(T::clone(self.now()))
    }

    fn clone_from(&mut self, other: &Self) {
        self.put(T::clone(other.now()));
    }
}
