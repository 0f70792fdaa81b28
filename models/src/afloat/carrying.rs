//! A crane with weight on a hull in motion: how its points move.
//!
//! Every bar of the luffing mechanism is two masses with its weight and inertia; all masses follow hull, slewing and luffing, so
//! that places, travels and accelerations are those of points, by the derivatives of the mechanism's positions.

use nalgebra::Vector3;

use crate::afloat::crane::{LuffingMotion, TurningMass};
use crate::afloat::riding::{HullMotion, RidingHull};
use crate::afloat::weights::CranePlace;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::luffed::Luffed;
use crate::luffing::moving::weighed::Weight;
use crate::parts::plane::Point;

/// A mass (kg) on the crane, with its place (m) toward the load, to the left of the boom's plane and above the foot of the slewing
/// axis, and two derivatives of the first and the last by the luffing angle.
#[derive(Clone, Copy, Debug)]
pub struct CraneMass<C> {
    pub mass: C,
    place: Vector3<C>,
    luffs: [Point<C>; 2],
}

impl<C: Calc> CraneMass<C> {
    fn map<D: Calc>(&self, f: &mut dyn FnMut(C) -> D) -> CraneMass<D> {
        CraneMass {
            mass: f(self.mass),
            place: Vector3::new(f(self.place.x), f(self.place.y), f(self.place.z)),
            luffs: self.luffs.map(|by| Point::new(f(by.x), f(by.y))),
        }
    }
}

/// How a point of the crane moves: its displacement for one unit of heave (m), heel, pitch, slewing and luffing (rad), and its
/// acceleration where none of them accelerates.
pub struct MovedPoint<C> {
    pub travel: [Vector3<C>; 5],
    pub bend: Vector3<C>,
}

/// The crane as it moves with the hull.
#[derive(Clone, Debug)]
pub struct CraneAfloat<C> {
    pub masses: Vec<CraneMass<C>>,
    pub head: CraneMass<C>,
    /// Foot of the slewing axis at the keel's height, from the hull's centre of gravity, in m.
    foot: Vector3<C>,
    /// Sine and cosine of slewing, heel and pitch.
    turns: [[C; 2]; 3],
    /// Rates of heel, pitch, slewing and luffing, in rad/s.
    rates: [C; 4],
    pub gravity: C,
}

impl<C: Calc> CraneAfloat<C> {
    #[expect(clippy::too_many_arguments, reason = "all that moves it")]
    pub fn new(
        psi: &One<C>,
        omega: &One<C>,
        place: &CranePlace<C>,
        foot: &One<C>,
        luffed: &Luffed<C>,
        luffing: &LuffingMotion<C>,
        turning: &[TurningMass<C>],
        motion: &HullMotion<C>,
        riding: &RidingHull<C>,
        gravity: &One<C>,
    ) -> CraneAfloat<C> {
        let zero = C::constant(0.0);
        let on_crane = |(weight, [at, travel, bend]): Weight<C>| CraneMass {
            mass: weight / gravity.1,
            place: Vector3::new(at.x + luffed.offset, zero, at.y + foot.1),
            luffs: [travel, bend],
        };
        let fixed = |mass: &TurningMass<C>| CraneMass {
            mass: mass.g_u / gravity.1,
            place: Vector3::new(mass.x_u, mass.y_u, mass.z_u),
            luffs: [Point::new(zero, zero); 2],
        };
        let moved = luffed.posed.weights.iter().map(|weight| on_crane(*weight));
        let [x, y, z] = riding.centre;
        let pair = |(sin, cos): (C, C)| [sin, cos];
        CraneAfloat {
            masses: moved.chain(turning.iter().map(fixed)).collect(),
            head: on_crane((zero, luffed.posed.head)),
            foot: Vector3::new(place.x_s - x, place.y_s - y, -z),
            turns: [pair(psi.sin_cos()), pair(riding.roll), pair(riding.pitch)],
            rates: [motion.omega_x, motion.omega_y, omega.1, luffing.omega_1],
            gravity: gravity.1,
        }
    }

    /// The same over another scalar.
    pub fn map<D: Calc>(&self, f: &mut dyn FnMut(C) -> D) -> CraneAfloat<D> {
        CraneAfloat {
            masses: self.masses.iter().map(|mass| mass.map(f)).collect(),
            head: self.head.map(f),
            foot: Vector3::new(f(self.foot.x), f(self.foot.y), f(self.foot.z)),
            turns: self.turns.map(|turn| turn.map(&mut *f)),
            rates: self.rates.map(&mut *f),
            gravity: f(self.gravity),
        }
    }

    /// r = D(θ, φ) (foot + S(ψ) p(θ_1)), with all its derivatives.
    #[inline(never)]
    pub fn moved(&self, point: &CraneMass<C>) -> MovedPoint<C> {
        let [[sin, cos], [low, high], [steep, level]] = self.turns;
        let [p, q, r, l] = self.rates;
        let (zero, two) = (C::constant(0.0), C::constant(2.0));
        let slewed = |x: C, y: C, z: C| Vector3::new(x * cos - y * sin, x * sin + y * cos, z);
        // In directions that do not turn: as it is, and for one radian of heel and of pitch.
        let turned = |v: Vector3<C>| {
            let (left, square) = (high * v.y + low * v.z, high * v.z - low * v.y);
            let at = Vector3::new(level * v.x + steep * square, left, level * square - steep * v.x);
            [
                at,
                Vector3::new(-(steep * left), square, -(level * left)),
                Vector3::new(at.z, zero, -at.x),
            ]
        };
        let at = slewed(point.place.x, point.place.y, point.place.z);
        let [out, bent] = point.luffs.map(|by| slewed(by.x, zero, by.y));
        let aside = |v: Vector3<C>| Vector3::new(-v.y, v.x, zero);
        let [whole, rolled, pitched] = turned(self.foot + at);
        let around = turned(aside(at));
        let luffed = turned(out);
        let own = turned(aside(aside(at)) * r.square() + aside(out) * (two * r * l) + bent * l.square())[0];
        let sped = |i: usize| around[i] * r + luffed[i] * l;
        let rolling = Vector3::new(-(steep * rolled.y), -whole.y, -(level * rolled.y));
        let both = Vector3::new(-(level * whole.y), zero, steep * whole.y);
        let bend = own
            + (sped(1) * p + sped(2) * q + both * (p * q)) * two
            + rolling * p.square()
            + Vector3::new(-whole.x, zero, -whole.z) * q.square();
        MovedPoint {
            travel: [
                Vector3::new(zero, zero, C::constant(1.0)),
                rolled,
                pitched,
                around[0],
                luffed[0],
            ],
            bend,
        }
    }
}
