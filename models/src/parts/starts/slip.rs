//! Starts of the motor along its own curve of torque over slip.
//!
//! ```text
//! J dω/dt = T(s) − T_0,  T(s) = 2 T_b / (s/s_b + s_b/s),  ω = ω_0 (1 − s)
//! t = J ω_0 / T_b · ∫ ds / (T(s)/T_b − T_0/T_b)  from the slip at the case's speed to 1
//! ```
//!
//! Of an inertia alone, T_0 = 0, the integral is ((1 − s²)/(2 s_b) + s_b ln(1/s))/2. What the case asks for is that of the place
//! where the start begins, as with a mean torque.

use std::f64::consts::TAU;

use crate::kernel::calc::Calc;
use crate::parts::starts::{self as s, RatedPoint, SlipStart, Starting};

/// Gauss's rule of ten points: nodes and weights on one side of the middle.
pub(super) const RULE: [[f64; 2]; 5] = [
    [0.148_874_338_981_631_2, 0.295_524_224_714_752_9],
    [0.433_395_394_129_247_2, 0.269_266_719_309_996_4],
    [0.679_409_568_299_024_4, 0.219_086_362_515_982],
    [0.865_063_366_688_984_5, 0.149_451_349_150_580_6],
    [0.973_906_528_517_171_7, 0.066_671_344_308_688_14],
];

impl<C: Calc> SlipStart<C> {
    /// s_b = s_N (λ + √(λ² − 1)): the curve passes the rated point. (Kloss)
    pub fn breakdown(&self, rated: &RatedPoint<C>) -> C {
        let rated = C::constant(1.0) - rated.n / self.n_0;
        rated * (self.lambda + (self.lambda.square() - C::constant(1.0)).sqrt())
    }

    /// T(s)/T_b = 2 / (s/s_b + s_b/s). (Kloss)
    pub fn share(slip: C, at: C) -> C {
        C::constant(2.0) / (slip / at + at / slip)
    }

    /// The greatest torque (N·m) from rest to a speed of the motor (1/s).
    pub fn most(&self, rated: &RatedPoint<C>, n: C) -> C {
        let (at, slip, one) = (self.breakdown(rated), self.slip(n), C::constant(1.0));
        let breakdown = self.lambda * rated.torque;
        if slip.value() > at.value() {
            breakdown * SlipStart::share(slip, at)
        } else if at.value() > 1.0 {
            breakdown * SlipStart::share(one, at)
        } else {
            breakdown
        }
    }

    /// Slip at a speed of the motor (1/s).
    pub fn slip(&self, n: C) -> C {
        C::constant(1.0) - n.abs() / self.n_0
    }
}

/// Pieces of the curve as it is drawn.
const DRAWN: u32 = 120;

impl SlipStart<f64> {
    /// Speeds (1/s) and torques (N·m) of the motor, from rest to its synchronous speed.
    #[must_use]
    pub fn over_speed(&self, rated: &RatedPoint<f64>) -> Vec<[f64; 2]> {
        let (at, breakdown) = (self.breakdown(rated), self.lambda * rated.torque);
        let point = |i: u32| {
            let slip = f64::from(i) / f64::from(DRAWN);
            [self.n_0 * (1.0 - slip), breakdown * SlipStart::share(slip, at)]
        };
        (0..=DRAWN).rev().map(point).collect()
    }
}

/// ∫ ds / (T(s)/T_b − w) from a slip to 1. The integrand is infinite beyond both ends, where motor and resistance are equal:
/// each piece is half as far from there as the one before.
fn spared<C: Calc>(from: C, at: C, w: C) -> C {
    let (one, half) = (C::constant(1.0), C::constant(0.5));
    let root = one + (one - w.square()).sqrt();
    let (low, middle) = (at * w / root, half * (from + one));
    let of = |slip: C| one / (SlipStart::share(slip, at) - w);
    let mut sum = C::constant(0.0);
    let mut piece = |a: C, b: C| {
        let (center, wide) = (half * (a + b), half * (b - a));
        for [node, weight] in RULE {
            let away = wide * C::constant(node);
            sum += wide * C::constant(weight) * (of(center - away) + of(center + away));
        }
    };
    let mut end = middle;
    while (end - low).value() > 2.0 * (from - low).value() {
        let next = low + half * (end - low);
        piece(next, end);
        end = next;
    }
    piece(from, end);
    let mut start = middle;
    if w.value() > 0.0 {
        let high = at * root / w;
        while (high - start).value() > 2.0 * (high - one).value() {
            let next = high - half * (high - start);
            piece(start, next);
            start = next;
        }
    }
    piece(start, one);
    sum
}

/// A start along the slip curve.
#[derive(Clone, Copy, Debug)]
pub struct Slipped<C> {
    pub at: C,
    pub breakdown: C,
    pub slip: C,
    pub least: C,
    pub spared: C,
    pub time: C,
    pub quickens: C,
}

impl<C: Calc> Slipped<C> {
    /// t = J ω_0 / T_b · I. [Ports001, 5.6; by integration]
    pub fn new(rated: &RatedPoint<C>, start: &SlipStart<C>, run: &Starting<C>) -> Slipped<C> {
        let (none, one) = (C::constant(0.0), C::constant(1.0));
        let at = start.breakdown(rated).def(&s::S_K);
        let breakdown = (start.lambda * rated.torque).def(&s::T_BD);
        let slip = start.slip(run.n).def(&s::S_F);
        let least = if slip.value() > 0.0 {
            (breakdown * SlipStart::share(slip, at).smaller(SlipStart::share(one, at))).def(&s::T_LEAST)
        } else {
            none.over(slip)
        };
        let starts = (least - run.against).value() > 0.0 && slip.value() > 0.0;
        let (spared, time) = if !run.moves {
            (none.over(least), none.over(least))
        } else if starts {
            let spared = spared(slip, at, run.against / breakdown).tabled(&s::I_S);
            let turning = C::constant(TAU) * start.n_0;
            (spared, (run.inertia * turning / breakdown * spared).def(&s::T_SLIP))
        } else {
            let never = |symbol| C::known(symbol, f64::INFINITY).over(least - run.against);
            (never(&s::I_S), never(&s::T_SLIP))
        };
        let quickens = if run.moves {
            (run.head / time).def(&s::A_SLIP)
        } else {
            none.over(least)
        };
        Slipped {
            at,
            breakdown,
            slip,
            least,
            spared,
            time,
            quickens,
        }
    }
}
