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
/// Whether rolling elements bear pressure alone, or a second row holds the ring down, as scenes name it.
pub const ROWS: [&str; 2] = ["pressure", "hold_down"];

/// The rolling elements of a ring.
#[derive(Clone, Debug)]
pub struct RollingElements {
    exponent: [u8; 2],
    pub held_down: bool,
    pub cosines: Vec<f64>,
}
group!(RollingElements);

impl RollingElements {
    /// So many rolling elements, by the place of the law and of the rows in their lists.
    #[must_use]
    pub fn new(count: usize, law: usize, held_down: bool) -> RollingElements {
        // Those of both halves alike, so that a moment alone leaves no force.
        let cosine = |j: usize| Calc::sin_cos(TAU * j.min(count - j) as f64 / count as f64).1;
        RollingElements {
            exponent: EXPONENTS[law],
            held_down,
            cosines: (0..count).map(cosine).collect(),
        }
    }

    /// The same with a hold-down row.
    #[must_use]
    pub fn on_two_rows(&self) -> RollingElements {
        let mut both = self.clone();
        both.held_down = true;
        both
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
        let each = |cosine: C| of(cosine, self.force(approach(cosine)));
        let first = each(C::constant(self.cosines[0]));
        let sums = self.pairs().skip(1).fold(first, |mut sums, (cosine, times)| {
            let cosine = C::constant(cosine);
            let near = approach(cosine);
            if self.held_down || near.value() > 0.0 {
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

    /// κ = Σ P c / Σ P (1 + c) at a fall λ of the approach, and its derivative.
    fn couple(&self, lambda: f64) -> [f64; 2] {
        let order = f64::from(self.exponent[0]) / f64::from(self.exponent[1]);
        let [mut turns, mut whole] = [[0.0; 2]; 2];
        for (cosine, times) in self.pairs() {
            let approach = 1.0 - lambda * (1.0 - cosine);
            if approach < 0.0 && !self.held_down {
                continue;
            }
            let force = self.force(approach);
            let slope = match self.exponent {
                [1, 1] => cosine - 1.0,
                _ if approach == 0.0 => 0.0,
                _ => order * force / approach * (cosine - 1.0),
            };
            for (sum, arm) in [(&mut turns, times * cosine), (&mut whole, times * (1.0 + cosine))] {
                *sum = [sum[0] + force * arm, sum[1] + slope * arm];
            }
        }
        let kappa = turns[0] / whole[0];
        [kappa, (turns[1] - kappa * whole[1]) / whole[0]]
    }

    /// Where the forces have the part κ of the couple: λ, and κ with its derivative there. Newton's method between ends
    /// that close in; κ grows with λ.
    #[must_use]
    pub fn solved(&self, kappa: f64) -> [f64; 3] {
        let last = if self.held_down {
            1.5
        } else {
            1.0 / (1.0 - self.cosines[1])
        };
        let [mut low, mut high] = [0.0, last];
        let mut lambda = (2.0 * kappa / (1.0 + kappa)).min(last);
        let mut found = self.couple(lambda);
        for _ in 0..200 {
            let apart = kappa - found[0];
            if apart > 0.0 {
                low = lambda
            } else {
                high = lambda
            }
            let next = lambda + apart / found[1];
            let next = if next > low && next < high {
                next
            } else {
                f64::midpoint(low, high)
            };
            // The last step, over any scalar, leaves the square of this.
            if apart == 0.0 || (next - lambda).abs() <= 1e-13 * lambda.max(1.0) {
                break;
            }
            lambda = next;
            found = self.couple(lambda);
        }
        [lambda, found[0], found[1]]
    }
}
