//! How the hull lies on the water, and where it comes to rest.
//!
//! The water stands at `z = T + x tan θ + y tan φ` over the keel: slopes instead of angles, so that volumes are those of a
//! sheared body. At rest the line from the centre of gravity to that of buoyancy is square to it.

use crate::afloat::hull::Floating;
use crate::afloat::weights::Weighed;
use crate::kernel::calc::Calc;

/// How it lies at a plane of the water.
pub struct Lie<C> {
    /// Volume that is missing (m³), waterplane area (m²) and its moments (m³).
    short: C,
    area: C,
    first: [C; 2],
    /// From the centre of gravity to that of buoyancy, at the volume that floats, in m.
    pub arm: [C; 3],
    /// How these grow with the slopes, along and across: xx, xy, yy, in m.
    pub radius: [C; 3],
}

impl<C: Calc> Lie<C> {
    /// At a plane of the water, as heavy as it is.
    #[inline(never)]
    pub fn new(on: &Floating<C>, all: &Weighed<C>, [t, a, b]: [C; 3]) -> Lie<C> {
        let volume = all.weight / on.water;
        let cut = on.cut([t, a, b]);
        let short = volume - cut.volume;
        let [x, y] = cut.first.map(|first| first / cut.area);
        let at = [x, y, t + a * x + b * y];
        let mut gravity = [all.along, all.across, all.up];
        let mut radius = cut.central().map(|second| second / volume);
        for tank in &on.tanks {
            let (moved, seconds) = tank.leaning([a, b]);
            for (sum, moved) in gravity.iter_mut().zip(moved) {
                *sum += tank.weight * moved;
            }
            for (radius, second) in radius.iter_mut().zip(seconds) {
                *radius -= tank.weight * second / all.weight;
            }
        }
        let buoyancy = [0, 1, 2].map(|i| (cut.moment[i] + short * at[i]) / volume);
        Lie {
            short,
            area: cut.area,
            first: cut.first,
            arm: [0, 1, 2].map(|i| buoyancy[i] - gravity[i] / all.weight),
            radius,
        }
    }

    /// By how much the draft changes with the slopes, at the volume that floats.
    fn draft(&self, a: C, b: C) -> C {
        (self.short - self.first[0] * a - self.first[1] * b) / self.area
    }

    /// A step of Newton's method to the equilibrium: r_x + a r_z = 0, r_y + b r_z = 0.
    pub fn to_rest(&self, [t, a, b]: [C; 3]) -> [C; 3] {
        let ([x, y, z], [xx, xy, yy]) = (self.arm, self.radius);
        let (rise, roll) = (a * xx + b * xy, a * xy + b * yy);
        let (one, two) = (x + a * z, y + b * z);
        let (p, q) = (xx + z + a * rise, xy + a * roll);
        let (u, v) = (xy + b * rise, yy + z + b * roll);
        let whole = p * v - q * u;
        let (along, across) = ((q * two - v * one) / whole, (u * one - p * two) / whole);
        [t + self.draft(along, across), a + along, b + across]
    }

    /// A step of Newton's method to the trim of least energy at a heel that is held: r_x (1 + b²) − a b r_y + a r_z = 0.
    pub fn to_trim(&self, [t, a, b]: [C; 3]) -> [C; 3] {
        let ([x, y, z], [xx, xy, _]) = (self.arm, self.radius);
        let whole = C::constant(1.0) + b * b;
        let apart = x * whole - a * b * y + a * z;
        let slope = whole * xx - a * b * xy + a * (a * xx + b * xy) - b * y + z;
        let along = -(apart / slope);
        [t + self.draft(along, C::constant(0.0)), a + along, b]
    }

    /// Rise of the centre of gravity over that of buoyancy (m): (a r_x + b r_y − r_z)/√(1 + a² + b²); and how it grows with
    /// the heel, which is the righting lever.
    pub fn energy(&self, [_, a, b]: [C; 3]) -> [C; 2] {
        let [x, y, z] = self.arm;
        let one = C::constant(1.0);
        let squared = one + a * a + b * b;
        let along = z - a * x - b * y;
        let lever = (one + b * b) * (y + b * along / squared) / squared.sqrt();
        [-(along / squared.sqrt()), lever]
    }
}

/// Nothing, with its derivatives, where a number is not greater than what rounding leaves of that.
pub fn quiet<C: Calc>(x: C, rounding: f64) -> C {
    if x.value().abs() < rounding {
        x - C::constant(x.value())
    } else {
        x
    }
}

/// Of a slope, and of a draft as part of it: one more step leaves the square of this.
const NEAR: f64 = 1e-8;
/// A slope below this is what rounding leaves of none.
const ROUNDING: f64 = 1e-14;

/// The longest step of a slope, and how many are gone at most.
const LONGEST: f64 = 0.3;
const STEPS: usize = 80;

/// Where it comes to rest, free or with a slope across that is held: draft (m) and slopes, looked for from those where it
/// lies nearby, or without trim and heel. Found by plain numbers; a last step over any scalar has the derivatives, by the
/// theorem of the implicit function.
#[inline(never)]
pub fn rest<C: Calc>(on: &Floating<C>, all: &Weighed<C>, held: Option<C>, near: Option<[f64; 3]>) -> Option<[C; 3]> {
    let (plain, weighed) = (on.map(&mut |x| x.value()), all.map(&mut |x| x.value()));
    let volume = weighed.weight / plain.water;
    let mut at = near.unwrap_or_default();
    at[2] = held.map_or(at[2], |heel| heel.value());
    at[0] = plain.level([at[1], at[2]], volume, near.map(|near| near[0]));
    let step = |lie: &Lie<f64>, at| match held {
        Some(_) => lie.to_trim(at),
        None => lie.to_rest(at),
    };
    let mut rests = false;
    for _ in 0..STEPS {
        let next = step(&Lie::new(&plain, &weighed, at), at);
        let turns = (next[1] - at[1]).abs().max((next[2] - at[2]).abs());
        if !turns.is_finite() {
            return None;
        }
        if turns > LONGEST || !next[0].is_finite() {
            // Too far for the draft to follow: it is found anew.
            let part = (LONGEST / turns).min(1.0);
            at = [0.0, at[1] + part * (next[1] - at[1]), at[2] + part * (next[2] - at[2])];
            at[0] = plain.level([at[1], at[2]], volume, None);
            continue;
        }
        rests = turns + ((next[0] - at[0]) / (1.0 + next[0].abs())).abs() < NEAR;
        at = next;
        if rests {
            break;
        }
    }
    let [t, a, b] = at.map(C::constant);
    let from = [t, a, held.unwrap_or(b)];
    let lie = Lie::new(on, all, from);
    let [t, a, b] = match held {
        Some(_) => lie.to_trim(from),
        None => lie.to_rest(from),
    };
    rests.then_some([t, quiet(a, ROUNDING), quiet(b, ROUNDING)])
}
