//! RODAS, linearly implicit of fourth order with six stages, L-stable, with an
//! embedded error and a continuous extension of third order. Hairer and Wanner,
//! Solving Ordinary Differential Equations II, 2nd edition 1996, section IV.7.
//!
//! One Jacobian and one factorisation for each step. The solver may run ahead of
//! the time asked for, by as much as its tolerance allows, and reads the
//! communication points in between off the continuous extension: a
//! communication step costs an interpolation. When an input changes, the rest
//! of the step is thrown away.

use crate::parts::solver::{Count, Halt, MOST_IMPLICIT, MOST_KINKS, System, finite};

const GAMMA: f64 = 0.25;

#[rustfmt::skip]
const A: [[f64; 5]; 5] = [
    [1.544, 0.0, 0.0, 0.0, 0.0],
    [0.946_678_528_081_582_6, 0.255_701_169_898_328_4, 0.0, 0.0, 0.0],
    [3.314_825_187_068_521, 2.896_124_015_972_201, 0.998_641_913_997_781_7, 0.0, 0.0],
    [1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895, 0.0],
    [1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895, 1.0],
];

#[rustfmt::skip]
const C: [[f64; 5]; 5] = [
    [-5.6688, 0.0, 0.0, 0.0, 0.0],
    [-2.430_093_356_833_875, -0.206_359_915_709_191_5, 0.0, 0.0, 0.0],
    [-0.107_352_905_815_137_5, -9.594_562_251_023_355, -20.470_286_148_096_16, 0.0, 0.0],
    [7.496_443_313_967_647, -10.246_804_314_643_52, -33.999_903_528_199_05, 11.708_908_932_061_6, 0.0],
    [8.083_246_795_921_522, -7.981_132_988_064_893, -31.521_594_328_743_71, 16.319_305_431_231_36, -6.058_818_238_834_054],
];

/// The continuous extension.
#[rustfmt::skip]
const D: [[f64; 5]; 2] = [
    [10.126_235_083_445_86, -7.487_995_877_610_167, -34.800_918_615_557_47, -7.992_771_707_568_823, 1.025_137_723_295_662],
    [-0.676_280_339_280_125_3, 6.087_714_651_680_015, 16.430_843_208_924_78, 24.767_225_114_183_86, -6.594_389_125_716_872],
];

/// A step with all that is known about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolverStep<const N: usize> {
    /// Length, in s.
    pub h: f64,
    pub from: [f64; N],
    pub to: [f64; N],
    /// Estimate of the error, of third order.
    pub error: [f64; N],
    bend: [[f64; N]; 2],
}

impl<const N: usize> SolverStep<N> {
    /// A step of no length.
    #[must_use]
    pub fn resting(y: [f64; N]) -> SolverStep<N> {
        SolverStep {
            h: 0.0,
            from: y,
            to: y,
            error: [0.0; N],
            bend: [[0.0; N]; 2],
        }
    }

    /// One step of `h` s from `y`.
    #[must_use]
    #[inline]
    pub fn new(system: &impl System<N>, y: &[f64; N], h: f64) -> Option<SolverStep<N>> {
        let (rate, jacobian) = system.jacobian(y)?;
        SolverStep::with(system, y, h, &rate, &jacobian)
    }

    /// With rates and Jacobian at `y`, which serve a step that is tried again.
    fn with(
        system: &impl System<N>,
        y: &[f64; N],
        h: f64,
        rate: &[f64; N],
        jacobian: &[[f64; N]; N],
    ) -> Option<SolverStep<N>> {
        let mut columns = [[0.0; N]; N];
        for (j, column) in columns.iter_mut().enumerate() {
            *column = std::array::from_fn(|i| -jacobian[i][j]);
            column[j] += 1.0 / (h * GAMMA);
        }
        let factors = Factors::new(columns)?;
        let mut k = [[0.0; N]; 6];
        k[0] = factors.solve(*rate);
        let mut to = *y;
        for stage in 1..6 {
            // The last stage adds to the one before.
            if stage < 5 {
                to = *y;
                for (a, k) in A[stage - 1].iter().zip(&k[..stage]) {
                    add(&mut to, *a, k);
                }
            } else {
                add(&mut to, 1.0, &k[4]);
            }
            let mut right = system.rates(&to)?;
            for (c, k) in C[stage - 1].iter().zip(&k[..stage]) {
                add(&mut right, c / h, k);
            }
            k[stage] = factors.solve(right);
        }
        add(&mut to, 1.0, &k[5]);
        let bend = D.map(|d| {
            let mut bend = [0.0; N];
            for (d, k) in d.iter().zip(&k) {
                add(&mut bend, *d, k);
            }
            bend
        });
        finite(&to).then_some(SolverStep {
            h,
            from: *y,
            to,
            error: k[5],
            bend,
        })
    }

    /// The part of the step up to just beyond the first kink that it passes, by the continuous extension:
    /// between a quarter and three quarters of `near` beyond.
    fn kink(&self, system: &impl System<N>, near: f64) -> Option<f64> {
        let (from, to) = (system.kinks(&self.from), system.kinks(&self.to));
        let mut first = 1.0;
        for i in 0..MOST_KINKS {
            let side = from[i].signum();
            if from[i].abs() <= near || -side * to[i] <= near {
                continue;
            }
            let (mut before, mut beyond) = (0.0, first);
            for _ in 0..MOST_HALVINGS {
                let middle = f64::midpoint(before, beyond);
                let deep = -side * system.kinks(&self.at(middle))[i] / near;
                if deep < 0.25 {
                    before = middle;
                } else {
                    beyond = middle;
                    if deep <= 0.75 {
                        break;
                    }
                }
            }
            first = beyond;
        }
        (first < 1.0 && first > LEAST_PART).then_some(first)
    }

    /// The part of the step up to just beyond where the smooth piece ends, by the continuous extension.
    fn end(&self, system: &impl System<N>) -> f64 {
        let (mut before, mut beyond) = (0.0, 1.0);
        for _ in 0..MOST_HALVINGS {
            let middle = f64::midpoint(before, beyond);
            if system.ended(&self.at(middle)) {
                beyond = middle;
            } else {
                before = middle;
            }
        }
        beyond
    }

    /// The states a part of the step after its start, from 0 to 1.
    #[must_use]
    pub fn at(&self, part: f64) -> [f64; N] {
        let rest = 1.0 - part;
        std::array::from_fn(|i| {
            self.from[i] * rest + part * (self.to[i] + rest * (self.bend[0][i] + part * self.bend[1][i]))
        })
    }
}

#[inline]
fn add<const N: usize>(to: &mut [f64; N], factor: f64, k: &[f64; N]) {
    for i in 0..N {
        to[i] += factor * k[i];
    }
}

/// LU factors with row exchanges, by columns: all inner loops run along one.
struct Factors<const N: usize> {
    columns: [[f64; N]; N],
    /// Where each row of the right side comes from.
    row: [usize; N],
}

impl<const N: usize> Factors<N> {
    #[inline]
    fn new(mut columns: [[f64; N]; N]) -> Option<Factors<N>> {
        let mut row = std::array::from_fn(|i| i);
        for k in 0..N {
            let mut pivot = k;
            for i in k + 1..N {
                if columns[k][i].abs() > columns[k][pivot].abs() {
                    pivot = i;
                }
            }
            if pivot != k {
                row.swap(k, pivot);
                for column in &mut columns {
                    column.swap(k, pivot);
                }
            }
            let diagonal = columns[k][k];
            // Neither zero, nor NaN or infinity.
            if !(diagonal.abs() > 0.0 && diagonal.is_finite()) {
                return None;
            }
            let inverse = 1.0 / diagonal;
            for below in &mut columns[k][k + 1..] {
                *below *= inverse;
            }
            columns[k][k] = inverse;
            let (done, rest) = columns.split_at_mut(k + 1);
            let lower = &done[k];
            for column in rest {
                let upper = column[k];
                // Most of a mechanism's states do not act on each other.
                if upper == 0.0 {
                    continue;
                }
                for i in k + 1..N {
                    column[i] -= lower[i] * upper;
                }
            }
        }
        Some(Factors { columns, row })
    }

    #[inline]
    fn solve(&self, right: [f64; N]) -> [f64; N] {
        let mut x: [f64; N] = std::array::from_fn(|i| right[self.row[i]]);
        for k in 0..N {
            for i in k + 1..N {
                x[i] -= self.columns[k][i] * x[k];
            }
        }
        for k in (0..N).rev() {
            x[k] *= self.columns[k][k];
            for i in 0..k {
                x[i] -= self.columns[k][i] * x[k];
            }
        }
        x
    }
}

/// What the estimated error of a step may be, in each state's own unit; infinite for places of no state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance<const N: usize> {
    pub relative: f64,
    pub absolute: [f64; N],
}

impl<const N: usize> Tolerance<N> {
    /// Error of a step over what is allowed, in the mean of all states that have a tolerance.
    fn measure(&self, step: &SolverStep<N>) -> f64 {
        let states = self.absolute.iter().filter(|x| x.is_finite()).count();
        let part = |i: usize| {
            let size = step.from[i].abs().max(step.to[i].abs());
            step.error[i] / (self.absolute[i] + self.relative * size)
        };
        ((0..N).map(|i| part(i) * part(i)).sum::<f64>() / states as f64).sqrt()
    }
}

/// How often a step may be cut at a kink, and the least part of it that is worth it.
const MOST_CUTS: u32 = 3;
const MOST_HALVINGS: u32 = 50;
/// Steps of one call that may lead to where the system does not exist: a motion that creeps along that edge ends there.
const MOST_LOST: u32 = 1000;
const LEAST_PART: f64 = 1e-2;

/// How often a step may be solved again to end at an event, and how near to its end the event must be.
const MOST_ENDS: u32 = 10;
const LAST_PART: f64 = 1.0 - 1e-9;

/// Smallest part of the time asked for that a step may be.
const RESOLUTION: f64 = 1e-13;

/// A system on its way: all of the solver's state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run<const N: usize> {
    step: SolverStep<N>,
    /// How much of the step, in s, lies behind the present time.
    behind: f64,
    /// Length of the next step, in s.
    next: f64,
    /// At the step's end something is to be decided.
    ended: bool,
    /// Least [of the system](System::least) at the ends of the steps that lie behind.
    pub least: f64,
    pub count: Count,
}

impl<const N: usize> Run<N> {
    /// At rest in these states; `first` is the length (s) of the first step to try.
    #[must_use]
    pub fn new(y: [f64; N], first: f64) -> Run<N> {
        Run {
            step: SolverStep::resting(y),
            behind: 0.0,
            next: first,
            ended: false,
            least: f64::INFINITY,
            count: Count::default(),
        }
    }

    /// The present states.
    #[must_use]
    pub fn states(&self) -> [f64; N] {
        if self.step.h == 0.0 || self.behind >= self.step.h {
            self.step.to
        } else {
            self.step.at(self.behind / self.step.h)
        }
    }

    /// To be called when the system changes, an input say: what was solved ahead is dropped.
    pub fn interrupt(&mut self, first: f64) {
        self.restart(self.states(), first);
    }

    /// The same from other states, where something was decided.
    pub fn restart(&mut self, y: [f64; N], first: f64) {
        *self = Run {
            least: self.least,
            count: self.count,
            ..Run::new(y, first)
        };
    }

    /// Nothing is solved ahead: all that may change at once has been decided, or must be.
    #[must_use]
    pub fn is_fresh(&self) -> bool {
        self.step.h == 0.0
    }

    /// The present time is where a smooth piece ends.
    #[must_use]
    pub fn at_event(&self) -> bool {
        self.ended && self.behind >= self.step.h
    }

    /// Moves on by a duration (s), in steps of at most `longest` (s).
    ///
    /// # Errors
    /// See [`Halt`]: the present states are those of the last step that succeeded.
    pub fn advance(
        &mut self,
        system: &impl System<N>,
        tolerance: &Tolerance<N>,
        duration: f64,
        longest: f64,
    ) -> Result<(), Halt> {
        self.piece(system, tolerance, duration, longest).map(|_| ())
    }

    /// The same, at most up to the end of the smooth piece. Returns what is left of the duration.
    ///
    /// # Errors
    /// As [`advance`](Run::advance).
    pub fn piece(
        &mut self,
        system: &impl System<N>,
        tolerance: &Tolerance<N>,
        duration: f64,
        longest: f64,
    ) -> Result<f64, Halt> {
        let mut left = duration;
        let (mut tried, mut lost) = (0_u32, 0_u32);
        while left > self.step.h - self.behind {
            left -= self.step.h - self.behind;
            self.behind = self.step.h;
            self.least = self.least.min(system.least(&self.step.to));
            if self.ended {
                return Ok(left);
            }
            let y = self.step.to;
            let (rate, jacobian) = system.jacobian(&y).ok_or(Halt::Outside)?;
            self.count.jacobians += 1;
            // A step that was refused is not followed by a longer one at once.
            let mut growth = 5.0;
            let (mut cuts, mut ends, mut exists) = (0, 0, true);
            // A length at whose end the event lies behind, and how often a shorter one did not reach it.
            let (mut over, mut misses) = (0.0, 0);
            loop {
                tried += 1;
                if tried > MOST_IMPLICIT {
                    return Err(Halt::TooMany);
                }
                let h = self.next.min(longest);
                if h < RESOLUTION * duration {
                    return Err(if exists { Halt::TooSmall } else { Halt::Outside });
                }
                self.count.rates += 6;
                let Some(mut step) = SolverStep::with(system, &y, h, &rate, &jacobian) else {
                    self.count.rejected += 1;
                    lost += 1;
                    if lost > MOST_LOST {
                        return Err(Halt::Outside);
                    }
                    self.next = h / 4.0;
                    exists = false;
                    continue;
                };
                exists = true;
                if cuts < MOST_CUTS
                    && let Some(part) = step.kink(system, tolerance.relative)
                {
                    cuts += 1;
                    self.count.kinks += 1;
                    self.next = h * part;
                    continue;
                }
                let measure = tolerance.measure(&step);
                // The error grows as the fourth power of the step; `fourth` is its root.
                let fourth = measure.sqrt().sqrt();
                let factor = (0.9 / fourth).clamp(0.2, growth);
                if measure <= 1.0 {
                    let ended = system.ended(&step.to);
                    let least = 4.0 * RESOLUTION * duration;
                    if ended && misses == 0 && ends < MOST_ENDS && h > least {
                        let part = step.end(system);
                        if part < LAST_PART {
                            ends += 1;
                            over = h;
                            self.count.kinks += 1;
                            self.next = (h * part).max(least);
                            continue;
                        }
                    }
                    // By rounding, or where the rates jump, the event lies further on: a little, then ever more.
                    if !ended && over > h {
                        misses += 1;
                        self.next = (h + over * (1.0 - LAST_PART) * 10.0_f64.powi(misses)).min(over);
                        continue;
                    }
                    system.settle(&mut step.to);
                    self.ended = ended;
                    self.next = h * factor;
                    self.step = step;
                    self.behind = 0.0;
                    self.count.steps += 1;
                    break;
                }
                self.next = h * if measure.is_nan() { 0.2 } else { factor };
                self.count.rejected += 1;
                growth = 1.0;
            }
        }
        self.behind += left;
        Ok(0.0)
    }

    /// The run as numbers, for a state that is written out; what it has met and counted is not part of it.
    pub fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        let SolverStep { h, from, to, bend, .. } = &self.step;
        let scalars = [*h, self.behind, self.next, f64::from(self.ended)];
        let arrays = [from, to, &bend[0], &bend[1]];
        scalars.into_iter().chain(arrays.into_iter().flatten().copied())
    }

    /// What [`numbers`](Run::numbers) gave; `None` where the length is another.
    #[must_use]
    pub fn of(numbers: &[f64]) -> Option<Run<N>> {
        let (&[h, behind, next, ended], rest) = numbers.split_first_chunk::<4>()?;
        let (arrays, over) = rest.as_chunks::<N>();
        let &[from, to, bend_1, bend_2] = arrays else {
            return None;
        };
        over.is_empty().then_some(Run {
            step: SolverStep {
                h,
                from,
                to,
                error: [0.0; N],
                bend: [bend_1, bend_2],
            },
            behind,
            next,
            ended: ended != 0.0,
            least: f64::INFINITY,
            count: Count::default(),
        })
    }
}
