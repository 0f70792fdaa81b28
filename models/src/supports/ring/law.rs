//! How a ring's rolling elements share a vertical force and a moment, by the law by which they yield.
//!
//! A rigid ring comes nearer to element j by `1 − λ (1 − c_j)` of the greatest approach, `c_j` being the cosine of its
//! angle from the moment's direction, in which the first element lies; its force goes with a power n of that. Where the
//! approach is below zero a hold-down row bears by the same law, or nothing does.

use std::f64::consts::TAU;

use crate::kernel::calc::{Among, Calc};
use crate::kernel::group::group;
use crate::supports::ring::symbols as s;

/// The laws by which a rolling element yields, as scenes name them.
pub const LAWS: [&str; 3] = ["linear", "line", "point"];
/// Their exponents: springs, line contact, and point contact by Hertz.
const EXPONENTS: [[u8; 2]; 3] = [[1, 1], [10, 9], [3, 2]];
/// Exponents of the life over capacity and force: springs have none, rollers, balls.
const LIVES: [[u8; 2]; 3] = [[1, 1], [10, 3], [3, 1]];
/// Whether rolling elements bear pressure alone, or a second row holds the ring down, as scenes name it.
pub const ROWS: [&str; 2] = ["pressure", "hold_down"];

/// On two rows, a fall λ beyond that of a moment alone, which is 1.
const HELD: f64 = 1.5;
/// How many falls are known: in equal steps as long as all elements bear, then at most so many at which one parts.
const STEPS: usize = 32;
const PARTINGS: usize = 32;
/// How far off κ may be before the last step: some of its roundings, as its bends leave no room for more.
const NEAR: f64 = 4e-15;

/// The rolling elements of a ring.
#[derive(Clone, Debug)]
pub struct RollingElements {
    exponent: [u8; 2],
    pub life: [u8; 2],
    pub held_down: bool,
    pub cosines: Vec<f64>,
    /// Falls λ of the approach from zero up, each with κ and its derivative there: `solved` begins between two of them.
    known: Vec<[f64; 3]>,
}
group!(RollingElements);

impl RollingElements {
    /// So many rolling elements, by the place of the law and of the rows in their lists.
    #[must_use]
    pub fn new(count: usize, law: usize, held_down: bool) -> RollingElements {
        // Those of both halves alike, so that a moment alone leaves no force.
        let cosine = |j: usize| Calc::sin_cos(TAU * j.min(count - j) as f64 / count as f64).1;
        let mut elements = RollingElements {
            exponent: EXPONENTS[law],
            life: LIVES[law],
            held_down,
            cosines: (0..count).map(cosine).collect(),
            known: Vec::new(),
        };
        elements.known = elements.falls().map(|lambda| elements.place(lambda)).collect();
        elements
    }

    /// Falls λ to be known, from zero to the last that can be: on two rows beyond a moment alone; on one, up to where the
    /// elements beside the first part. κ bends where elements part.
    fn falls(&self) -> impl Iterator<Item = f64> {
        let farthest = self.cosines.len() / 2;
        let (end, partings) = if self.held_down {
            (HELD, 0)
        } else {
            (self.parted(farthest), PARTINGS.min(farthest - 1))
        };
        let step = move |i: usize| end * i as f64 / STEPS as f64;
        let parting = move |i: usize| self.parted(farthest - (farthest - 1) * i / partings);
        (0..=STEPS).map(step).chain((1..=partings).map(parting))
    }

    /// The fall at which ring and element j part.
    fn parted(&self, j: usize) -> f64 {
        1.0 / (1.0 - self.cosines[j])
    }

    /// Whether the elements are springs.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        self.exponent == EXPONENTS[0]
    }

    /// Cosine of the element that lies farthest from the moment's direction.
    #[must_use]
    pub fn far(&self) -> f64 {
        self.cosines[self.cosines.len() / 2]
    }

    /// Force over the greatest, by the approach over the greatest: its sign is that of the approach.
    pub fn force<C: Calc>(&self, approach: C) -> C {
        match (self.exponent, approach.value() < 0.0) {
            ([1, 1], _) => approach,
            (exponent, false) => approach.power(exponent),
            (exponent, true) => -(-approach).power(exponent),
        }
    }

    /// (1/z) Σ of some things of c_j and of the force (1 − λ (1 − c_j))ⁿ, or another approach, over the elements that bear.
    pub fn means<C: Calc, const N: usize>(&self, approach: impl Fn(C) -> C, of: impl Fn(C, C) -> [C; N]) -> [C; N] {
        self.means_on(self.held_down, approach, of)
    }

    /// The same on two rows, where all bear, or on one, whatever the ring has.
    pub fn means_on<C: Calc, const N: usize>(
        &self,
        two_rows: bool,
        approach: impl Fn(C) -> C,
        of: impl Fn(C, C) -> [C; N],
    ) -> [C; N] {
        let each = |cosine: C| of(cosine, self.force(approach(cosine)));
        let first = each(C::constant(self.cosines[0]));
        let sums = self.pairs().skip(1).fold(first, |mut sums, (cosine, times)| {
            let cosine = C::constant(cosine);
            let near = approach(cosine);
            if two_rows || near.value() > 0.0 {
                let those = of(cosine, self.force(near));
                for (sum, value) in sums.iter_mut().zip(those) {
                    *sum += value.scaled(times);
                }
            }
            sums
        });
        let one = each(C::known(&s::C_J, self.cosines[0]));
        let count = C::known(&s::Z, self.cosines.len() as f64);
        std::array::from_fn(|i| sums[i].among(Among::Sum, one[i]) / count)
    }

    /// Cosines of both halves, which are alike, each with how many elements have it.
    fn pairs(&self) -> impl Iterator<Item = (f64, f64)> {
        let count = self.cosines.len();
        let times = move |j: usize| if j == 0 || 2 * j == count { 1.0 } else { 2.0 };
        (0..=count / 2).map(move |j| (self.cosines[j], times(j)))
    }

    /// A fall λ of the approach, κ = Σ P c / Σ P (1 + c) there, and its derivative.
    fn place(&self, lambda: f64) -> [f64; 3] {
        let [above, below] = self.exponent;
        let order = f64::from(above) / f64::from(below);
        let [mut turns, mut whole] = [[0.0; 2]; 2];
        for (cosine, times) in self.pairs() {
            let approach = 1.0 - lambda * (1.0 - cosine);
            if approach < 0.0 && !self.held_down {
                continue;
            }
            let stiffness = approach.abs().power([above - below, below]);
            let (force, slope) = (stiffness * approach, order * stiffness * (cosine - 1.0));
            for (sum, arm) in [(&mut turns, times * cosine), (&mut whole, times * (1.0 + cosine))] {
                *sum = [sum[0] + force * arm, sum[1] + slope * arm];
            }
        }
        let kappa = turns[0] / whole[0];
        [lambda, kappa, (turns[1] - kappa * whole[1]) / whole[0]]
    }

    /// Where the forces have the part κ of the couple, between two that are known: the cubic that meets λ and its slopes
    /// there.
    fn between([low, high]: [[f64; 3]; 2], kappa: f64) -> f64 {
        let width = high[1] - low[1];
        let t = (kappa - low[1]) / width;
        let [rise, first, last] = [high[0] - low[0], width / low[2], width / high[2]];
        low[0] + t * (first + t * (3.0 * rise - 2.0 * first - last + t * (first + last - 2.0 * rise)))
    }

    /// Where the forces have the part κ of the couple: λ, and κ with its derivative there. Newton's method between ends
    /// that close in; κ grows with λ.
    #[must_use]
    pub fn solved(&self, kappa: f64) -> [f64; 3] {
        let above = self.known.partition_point(|known| known[1] < kappa);
        let above = above.clamp(1, self.known.len() - 1);
        let ends = [self.known[above - 1], self.known[above]];
        let [mut low, mut high] = ends.map(|end| end[0]);
        let mut found = self.place(RollingElements::between(ends, kappa).max(low).min(high));
        for _ in 0..200 {
            let [lambda, met, slope] = found;
            let apart = kappa - met;
            // The last step, over any scalar, leaves the square of this.
            if apart.abs() <= NEAR {
                break;
            }
            if apart > 0.0 {
                low = lambda
            } else {
                high = lambda
            }
            let next = lambda + apart / slope;
            let next = if (low..=high).contains(&next) {
                next
            } else {
                f64::midpoint(low, high)
            };
            found = self.place(next);
        }
        found
    }
}
