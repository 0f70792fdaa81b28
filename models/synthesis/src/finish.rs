//! The end of a search: from a good start to the last bits, by the exact derivatives of every peak.
//!
//! What is least is a combination of greatest values over the working range, under limits of others: sequential quadratic
//! programming, in which the greatest values are unknowns of their own that no peak may exceed. The peaks and limits that
//! hold are those with multipliers; a step of Newton's method on these alone follows. [Nocedal and Wright, Numerical
//! Optimization, 2006, 18.1-18.5]

use nalgebra::{DMatrix, DVector};

use crate::peaks::{Peaked, Peaks, Shape};
use crate::quadratic::{least, not_negative};

/// What is least, or stays below zero: `sign` times a result less `limit`, over `unit`.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// Place among the results.
    pub of: usize,
    pub sign: f64,
    pub limit: f64,
    pub unit: f64,
}

impl Function {
    #[must_use]
    pub fn of(&self, value: f64) -> f64 {
        (self.sign * value - self.limit) / self.unit
    }
}

/// The first function is least, the others at most zero, between the bounds.
pub struct Program<'a> {
    pub equations: &'a mut dyn Peaked,
    pub functions: &'a [Function],
    pub bounds: &'a [[f64; 2]],
    /// Of a limit that is not kept, over its amount: more than any multiplier.
    pub penalty: f64,
}

/// Where a search ends.
#[derive(Clone, Debug)]
pub struct Finished {
    /// As parts of the bounds, from 0 to 1.
    pub parts: Vec<f64>,
    /// Every function.
    pub functions: Vec<f64>,
    /// Norm of what is left of the derivatives beside their multipliers: of the objective over its amount, by parts of the
    /// bounds.
    pub residual: f64,
}

/// Weights of a limit that is not kept, over its amount: more than any multiplier, and for where it is missed all the same.
pub const LIGHT: f64 = 100.0;
pub const HEAVY: f64 = 1e6;

/// How often rounded values are brought back to where they keep their limits.
const SETTLING: usize = 4;
/// By how much more than missed.
const MORE: f64 = 1e-10;
const STEPS: usize = 120;
/// Least curvature in any direction, with which a quadratic program is solved.
const FLAT: f64 = 0.1;
/// How often multipliers and second derivatives are found from each other before a step.
const ROUNDS: usize = 2;
/// Steps of the differences of exact derivatives.
const DIFFERENCE: f64 = 1e-5;
/// What is left at an optimum by rounding.
const DONE: f64 = 1e-13;
/// How near to its limit a function holds it.
const HOLDS: f64 = 1e-9;

/// A result at a place, linear in what is unknown: quantities, then greatest values.
struct Linear {
    values: Vec<f64>,
    slopes: Vec<DVector<f64>>,
    /// Of peaks less their greatest value.
    over: Vec<(f64, DVector<f64>)>,
}

/// Peaks at some parts of the bounds.
#[derive(Clone)]
struct Here {
    parts: Vec<f64>,
    peaks: Peaks,
}

impl Linear {
    /// Limits, then peaks.
    fn rows(&self) -> impl Iterator<Item = f64> {
        self.values[1..]
            .iter()
            .copied()
            .chain(self.over.iter().map(|(value, _)| *value))
    }
}

impl Program<'_> {
    /// What parts of the bounds are.
    #[must_use]
    pub fn values(&self, parts: &[f64]) -> Vec<f64> {
        let all = parts.iter().zip(self.bounds);
        all.map(|(part, [low, high])| low + (high - low) * part).collect()
    }

    /// Which parts of the bounds values are.
    #[must_use]
    pub fn parts(&self, values: &[f64]) -> Vec<f64> {
        let all = values.iter().zip(self.bounds);
        all.map(|(value, [low, high])| (value - low) / (high - low)).collect()
    }

    fn here(&mut self, parts: Vec<f64>) -> Option<Here> {
        let values = self.values(&parts);
        let peaks = self.equations.peaks(&values)?;
        Some(Here { parts, peaks })
    }

    fn shape(&self, function: &Function) -> Shape {
        self.equations.shape(function.of)
    }

    /// Which parts of which functions are unknowns: where the function grows with its peaks.
    fn unknowns(&self) -> Vec<(usize, usize)> {
        let mut all = Vec::new();
        for (i, function) in self.functions.iter().enumerate() {
            let shape = self.shape(function);
            let count = match shape {
                Shape::Ratio => 4,
                Shape::Swing => 2,
                _ => 1,
            };
            let own = |part: &usize| shape.grows(*part) == Some(function.sign > 0.0);
            all.extend((0..count).filter(own).map(|part| (i, part)));
        }
        all
    }

    /// The greatest values.
    fn greatest(&self, peaks: &Peaks) -> Vec<Vec<(usize, f64)>> {
        let of = |function: &Function| {
            let each = peaks[function.of].iter().map(|peaks| {
                let all = peaks.iter().map(|peak| peak.value).enumerate();
                all.reduce(|a, b| if b.1 > a.1 { b } else { a })
                    .expect("every part has a peak")
            });
            each.collect()
        };
        self.functions.iter().map(of).collect()
    }

    fn functions(&self, peaks: &Peaks) -> Vec<f64> {
        let greatest = self.greatest(peaks);
        let value = |(function, parts): (&Function, &Vec<(usize, f64)>)| {
            let parts: Vec<f64> = parts.iter().map(|(_, value)| *value).collect();
            function.of(self.shape(function).of(&parts).0)
        };
        self.functions.iter().zip(&greatest).map(value).collect()
    }

    /// Functions and peaks at some unknowns; `held` are the peaks that count where there is no unknown.
    fn linear(&self, peaks: &Peaks, unknown: &[f64], held: &[Vec<(usize, f64)>], units: &[f64]) -> Linear {
        let (count, all) = (self.bounds.len(), self.unknowns());
        let width: Vec<f64> = self.bounds.iter().map(|[low, high]| high - low).collect();
        let size = count + all.len();
        let mut linear = Linear {
            values: Vec::new(),
            slopes: Vec::new(),
            over: Vec::new(),
        };
        for (i, function) in self.functions.iter().enumerate() {
            let of = &peaks[function.of];
            let place = |part: usize| all.iter().position(|one| *one == (i, part));
            let values = (0..of.len()).map(|part| match place(part) {
                Some(at) => unknown[at] * units[at],
                None => of[part][held[i][part].0].value,
            });
            let (value, by) = self.shape(function).of(&values.collect::<Vec<f64>>());
            let mut slope = DVector::zeros(size);
            for (part, by) in by.iter().enumerate() {
                let by = by * function.sign / function.unit;
                match place(part) {
                    Some(at) => {
                        slope[count + at] += by * units[at];
                        for peak in &of[part] {
                            let mut over = DVector::zeros(size);
                            (0..count).for_each(|j| over[j] = peak.slope[j] * width[j] / units[at]);
                            over[count + at] = -1.0;
                            linear.over.push((peak.value / units[at] - unknown[at], over));
                        }
                    }
                    None => {
                        let peak = &of[part][held[i][part].0];
                        (0..count).for_each(|j| slope[j] += by * peak.slope[j] * width[j]);
                    }
                }
            }
            linear.values.push(function.of(value));
            linear.slopes.push(slope);
        }
        linear
    }

    /// Derivatives of the objective with its multipliers: of the limits, then of the peaks.
    fn gradient(linear: &Linear, multipliers: &[f64]) -> DVector<f64> {
        let rows = linear.slopes[1..]
            .iter()
            .chain(linear.over.iter().map(|(_, slope)| slope));
        let mut sum = linear.slopes[0].clone();
        rows.zip(multipliers)
            .for_each(|(row, weight)| sum.axpy(*weight, row, 1.0));
        sum
    }

    /// Second derivatives, by differences of the exact first ones.
    fn curvature(&mut self, here: &Here, unknown: &[f64], units: &[f64], multipliers: &[f64]) -> Option<DMatrix<f64>> {
        let (count, size) = (self.bounds.len(), self.bounds.len() + unknown.len());
        let held = self.greatest(&here.peaks);
        let mut matrix = DMatrix::zeros(size, size);
        for j in 0..count {
            let mut at = |step: f64| {
                let mut parts = here.parts.clone();
                parts[j] += step;
                let values = self.values(&parts);
                let peaks = self.equations.moved(&values, &here.peaks)?;
                Some(Program::gradient(
                    &self.linear(&peaks, unknown, &held, units),
                    multipliers,
                ))
            };
            let low = if here.parts[j] < DIFFERENCE { 0.0 } else { -DIFFERENCE };
            let high = if here.parts[j] > 1.0 - DIFFERENCE {
                0.0
            } else {
                DIFFERENCE
            };
            let column = (at(high)? - at(low)?) / (high - low);
            matrix.set_column(j, &column);
        }
        for k in 0..unknown.len() {
            let at = |step: f64| {
                let mut other = unknown.to_vec();
                other[k] += step;
                Program::gradient(&self.linear(&here.peaks, &other, &held, units), multipliers)
            };
            let column = (at(DIFFERENCE) - at(-DIFFERENCE)) / (2.0 * DIFFERENCE);
            matrix.set_column(count + k, &column);
        }
        Some((&matrix + matrix.transpose()) * 0.5)
    }

    /// The worst limit counts: what a step must lower.
    fn merit(&self, functions: &[f64]) -> f64 {
        functions[0] + self.penalty * functions[1..].iter().map(|value| value.max(0.0)).sum::<f64>()
    }

    /// What the derivatives leave beside multipliers of what holds: zero at an optimum.
    fn residual(&self, here: &Here, units: &[f64]) -> f64 {
        let held = self.greatest(&here.peaks);
        let unknown = self.start(&held, units);
        let linear = self.linear(&here.peaks, &unknown, &held, units);
        let size = linear.slopes[0].len();
        let mut rows: Vec<DVector<f64>> = Vec::new();
        let limits = linear.values[1..].iter().zip(&linear.slopes[1..]);
        rows.extend(
            limits
                .filter(|(value, _)| **value > -HOLDS)
                .map(|(_, slope)| slope.clone()),
        );
        rows.extend(
            linear
                .over
                .iter()
                .filter(|(value, _)| *value > -HOLDS)
                .map(|(_, slope)| slope.clone()),
        );
        for (j, part) in here.parts.iter().enumerate() {
            for (near, sign) in [(*part, -1.0), (1.0 - part, 1.0)] {
                if near < HOLDS {
                    let mut row = DVector::zeros(size);
                    row[j] = sign;
                    rows.push(row);
                }
            }
        }
        let short = linear.values[1..].iter().fold(0.0_f64, |sum, value| sum.max(*value));
        if rows.is_empty() {
            return linear.slopes[0].norm() + short;
        }
        let rows = DMatrix::from_columns(&rows);
        let wanted = -&linear.slopes[0];
        (&rows * not_negative(&rows, &wanted) - wanted).norm() + short
    }

    /// The unknown greatest values at a place.
    fn start(&self, held: &[Vec<(usize, f64)>], units: &[f64]) -> Vec<f64> {
        let all = self.unknowns();
        all.iter()
            .zip(units)
            .map(|(&(i, part), unit)| held[i][part].1 / unit)
            .collect()
    }

    /// The quadratic program at a place, in which no step is longer than `reach`.
    fn quadratic(&mut self, here: &Here, units: &[f64], reach: f64) -> Option<Quadratic> {
        let held = self.greatest(&here.peaks);
        let unknown = self.start(&held, units);
        let linear = self.linear(&here.peaks, &unknown, &held, units);
        let size = self.bounds.len() + unknown.len();
        // One more unknown is how far the limits are missed.
        let with = |slope: &DVector<f64>, last: f64| {
            let mut row = slope.clone().resize_vertically(size + 1, 0.0);
            row[size] = last;
            row
        };
        let mut rows: Vec<DVector<f64>> = linear.slopes[1..].iter().map(|slope| with(slope, -1.0)).collect();
        rows.extend(linear.over.iter().map(|(_, slope)| with(slope, 0.0)));
        let curved = rows.len();
        let mut right: Vec<f64> = linear.rows().map(|value| -value).collect();
        rows.push(with(&DVector::zeros(size), -1.0));
        right.push(0.0);
        for (j, part) in here.parts.iter().enumerate() {
            for (room, sign) in [(*part, -1.0), (1.0 - part, 1.0)] {
                let mut row = DVector::zeros(size + 1);
                row[j] = sign;
                rows.push(row);
                right.push(room.min(reach));
            }
        }
        let rows = DMatrix::from_fn(rows.len(), size + 1, |i, j| rows[i][j]);
        // So that the least without rows is about as far from here as a step may go.
        let mut convex = DMatrix::identity(size + 1, size + 1);
        convex[(size, size)] = self.penalty * self.penalty;
        let mut found = Quadratic {
            slope: with(&linear.slopes[0], self.penalty),
            right: DVector::from_vec(right),
            convex,
            curvature: DMatrix::zeros(size, size),
            rows,
            holds: Vec::new(),
            held,
            unknown,
        };
        // Multipliers and curvature follow from each other.
        for _ in 0..ROUNDS {
            let solved = least(&found.convex, &found.slope, &found.rows, &found.right)?;
            let weights: Vec<f64> = solved.multipliers.iter().copied().take(curved).collect();
            found.curvature = self.curvature(here, &found.unknown, units, &weights)?;
            let eigen = found.curvature.clone().symmetric_eigen();
            let sizes = DMatrix::from_diagonal(&eigen.eigenvalues.map(|value| value.abs().max(FLAT)));
            let convex = &eigen.eigenvectors * sizes * eigen.eigenvectors.transpose();
            found.convex.view_mut((0, 0), (size, size)).copy_from(&convex);
        }
        let solved = least(&found.convex, &found.slope, &found.rows, &found.right)?;
        let holds = |i: &usize| *i != curved && solved.multipliers[*i] > 1e-9;
        found.holds = (0..found.right.len()).filter(holds).collect();
        Some(found)
    }

    /// Right sides with which a step takes account of how limits and peaks bend on the way of another one.
    fn bent(&mut self, here: &Here, units: &[f64], quadratic: &Quadratic, step: &DVector<f64>) -> Option<DVector<f64>> {
        let count = self.bounds.len();
        let parts: Vec<f64> = here
            .parts
            .iter()
            .zip(step.iter())
            .map(|(part, step)| part + step)
            .collect();
        let peaks = self.equations.moved(&self.values(&parts), &here.peaks)?;
        let linear = self.linear(&peaks, &quadratic.unknown, &quadratic.held, units);
        let mut right = quadratic.right.clone();
        for (i, value) in linear.rows().enumerate() {
            let along: f64 = (0..count).map(|j| quadratic.rows[(i, j)] * step[j]).sum();
            right[i] = along - value;
        }
        Some(right)
    }

    /// Every function at some parts of the bounds.
    fn at(&mut self, parts: &[f64]) -> Option<Vec<f64>> {
        let here = self.here(parts.to_vec())?;
        Some(self.functions(&here.peaks))
    }

    /// An optimum's values, rounded; where a limit is missed by more than `kept` after that, as much more is asked for.
    pub fn settled(&mut self, optimum: Vec<f64>, kept: f64, rounded: &dyn Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
        let (mut functions, mut parts) = (self.functions.to_vec(), optimum);
        for _ in 0..SETTLING {
            let inside = self.parts(&rounded(&self.values(&parts)));
            let Some(reached) = self.at(&inside) else { break };
            let mut missed = false;
            for (own, over) in functions.iter_mut().zip(reached).skip(1) {
                if over > kept {
                    missed = true;
                    own.limit -= (over + MORE) * own.unit;
                }
            }
            let mut program = Program {
                equations: &mut *self.equations,
                functions: &functions,
                ..*self
            };
            let Some(again) = program.finish(parts.clone()).filter(|_| missed) else {
                break;
            };
            parts = again.parts;
        }
        rounded(&self.values(&parts))
    }

    /// Where a step leads, if that is better than the functions and the residual before.
    fn tried(
        &mut self,
        here: &Here,
        units: &[f64],
        step: &DVector<f64>,
        (functions, residual): (&[f64], f64),
    ) -> Option<(Here, Vec<f64>, f64, f64)> {
        let parts = here.parts.iter().zip(step.iter());
        let parts = parts.map(|(part, step)| snapped((part + step).clamp(0.0, 1.0)));
        let other = self.here(parts.collect())?;
        let (values, left) = (self.functions(&other.peaks), self.residual(&other, units));
        let gained = self.merit(functions) - self.merit(&values);
        let level = 1e-13 * (1.0 + functions[0].abs());
        let length = step
            .iter()
            .take(self.bounds.len())
            .fold(0.0_f64, |most, step| most.max(step.abs()));
        (gained > level || (gained > -1e-9 && left < 0.5 * residual)).then_some((other, values, left, length))
    }

    /// From parts of the bounds to the nearest optimum; `None` where something does not exist at the start.
    pub fn finish(&mut self, parts: Vec<f64>) -> Option<Finished> {
        let mut here = self.here(parts)?;
        let held = self.greatest(&here.peaks);
        let units = self
            .unknowns()
            .into_iter()
            .map(|(i, part)| match held[i][part].1.abs() {
                0.0 => 1.0,
                size => size,
            });
        let units: Vec<f64> = units.collect();
        let mut functions = self.functions(&here.peaks);
        let mut residual = self.residual(&here, &units);
        let mut reach = 0.05;
        // With everything chosen there is nowhere to go.
        let steps = if self.bounds.is_empty() { 0 } else { STEPS };
        for _ in 0..steps {
            let mut better = None;
            if let Some(quadratic) = self.quadratic(&here, &units, reach) {
                for solve in [Quadratic::newton, Quadratic::plain] {
                    let straight =
                        solve(&quadratic, &quadratic.right).filter(|step| within(step, self.bounds.len(), reach));
                    let Some(straight) = straight else { continue };
                    better = self.tried(&here, &units, &straight, (&functions, residual));
                    if better.is_none() {
                        let bent = self.bent(&here, &units, &quadratic, &straight);
                        let bent = bent.and_then(|right| solve(&quadratic, &right));
                        let bent = bent.filter(|step| within(step, self.bounds.len(), reach));
                        better = bent.and_then(|step| self.tried(&here, &units, &step, (&functions, residual)));
                    }
                    if better.is_some() {
                        break;
                    }
                }
            }
            match better {
                Some((other, values, left, length)) => {
                    (here, functions, residual) = (other, values, left);
                    reach = if length > 0.5 * reach {
                        (2.0 * reach).min(0.3)
                    } else {
                        reach
                    };
                }
                None => reach *= 0.2,
            }
            if reach < 1e-14 || residual < DONE {
                break;
            }
        }
        Some(Finished {
            parts: here.parts,
            functions,
            residual,
        })
    }
}

/// A part of the bounds, at an end where it is nearer than a rounding.
fn snapped(part: f64) -> f64 {
    match part {
        low if low < 1e-14 => 0.0,
        high if high > 1.0 - 1e-14 => 1.0,
        part => part,
    }
}

/// Whether no part changes by more than twice `reach`.
fn within(step: &DVector<f64>, count: usize, reach: f64) -> bool {
    step.iter().take(count).all(|step| step.abs() <= 2.0 * reach)
}

/// What is least near a place: a quadratic function under rows that are linear.
struct Quadratic {
    slope: DVector<f64>,
    /// With curvature in every direction.
    convex: DMatrix<f64>,
    /// As it is.
    curvature: DMatrix<f64>,
    /// Those of limits and peaks first; then how far limits are missed, and how far a step may go.
    rows: DMatrix<f64>,
    right: DVector<f64>,
    /// Rows with multipliers.
    holds: Vec<usize>,
    held: Vec<Vec<(usize, f64)>>,
    unknown: Vec<f64>,
}

impl Quadratic {
    fn plain(&self, right: &DVector<f64>) -> Option<DVector<f64>> {
        Some(least(&self.convex, &self.slope, &self.rows, right)?.step)
    }

    /// The step to the stationary point where the rows with multipliers hold exactly.
    fn newton(&self, right: &DVector<f64>) -> Option<DVector<f64>> {
        let (size, count) = (self.curvature.nrows(), self.holds.len());
        let mut system = DMatrix::zeros(size + count, size + count);
        system.view_mut((0, 0), (size, size)).copy_from(&self.curvature);
        let mut sides = DVector::zeros(size + count);
        sides.rows_mut(0, size).copy_from(&-self.slope.rows(0, size));
        for (i, &row) in self.holds.iter().enumerate() {
            for j in 0..size {
                system[(size + i, j)] = self.rows[(row, j)];
                system[(j, size + i)] = self.rows[(row, j)];
            }
            sides[size + i] = right[row];
        }
        let solved = system.full_piv_lu().solve(&sides)?;
        solved.iter().all(|value| value.is_finite()).then_some(solved)
    }
}
