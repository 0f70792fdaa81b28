//! Quantities of a scene whose results are nearest to those of a published table: weighted least squares with exact
//! derivatives, by the method of Levenberg and Marquardt. [Nocedal and Wright, Numerical Optimization, 2006, 10.3]

use lemnis_models::component::mechanism::Mechanism;
use lemnis_models::component::probe::slot;
use lemnis_models::component::stages::Slot;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::request::Request;
use nalgebra::{DMatrix, DVector};

use crate::equations::Equations;
use crate::optimum::SPREAD;

/// What came of a fit.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// Of each quantity that varies, in SI, with its standard error; infinite where the values do not tell it.
    pub values: Vec<f64>,
    pub errors: Vec<f64>,
    /// Root of the mean square of what is left, each over the rounding of its last printed digit (as that of a number
    /// equally likely anywhere within it): 1 where rounding explains it all.
    pub left: f64,
    /// Printed values.
    pub count: usize,
    /// Of each column that is left: mean square's root and greatest amount, in SI.
    pub columns: Vec<(&'static Symbol, f64, f64)>,
    /// Of each combination of the quantities that the values do not tell, how much each quantity has of it.
    pub alike: Vec<Vec<f64>>,
    /// Norm of the derivatives of half the square sum over its columns' norms and its own.
    pub residual: f64,
}

/// Starts: the scene's own values, and others within the bounds.
const STARTS: u64 = 6;
const STEPS: usize = 200;
/// Square sums that differ by less than this part, which rounding of the values adds, are as good as each other.
const LEVEL: f64 = 1e-8;
/// Singular values below this part of the greatest: quantities that cannot be told apart.
const ALIKE: f64 = 1e-7;

struct Printed {
    column: &'static Symbol,
    slot: Slot,
    at: f64,
    value: f64,
    /// Standard deviation of its rounding.
    rounding: f64,
}

/// Residuals, each over its rounding, with their derivatives by parts of the bounds.
struct Local {
    left: DVector<f64>,
    by: DMatrix<f64>,
}

impl Local {
    fn square(&self) -> f64 {
        self.left.norm_squared()
    }

    /// Cosine of the residuals with the directions in which they change.
    fn residual(&self) -> f64 {
        let slope = self.by.tr_mul(&self.left);
        let norm = self.left.norm();
        let cosine = |(slope, column): (&f64, f64)| {
            if column * norm == 0.0 {
                0.0
            } else {
                slope / (column * norm)
            }
        };
        let columns = self.by.column_iter().map(|column| column.norm());
        slope
            .iter()
            .zip(columns)
            .map(cosine)
            .map(|cosine| cosine * cosine)
            .sum::<f64>()
            .sqrt()
    }
}

/// Printed values of a scene that it also computes.
fn printed(mechanism: &dyn Mechanism) -> Vec<Printed> {
    let model = mechanism.standing();
    let Some(published) = mechanism.published() else {
        return Vec::new();
    };
    let mut all = Vec::new();
    for row in &published.rows {
        let Ok(at) = row[0].parse::<f64>() else { continue };
        for (&column, text) in published.columns.iter().zip(row).skip(1) {
            let (Some(slot), Ok(shown)) = (slot(&model, column), text.parse::<f64>()) else {
                continue;
            };
            let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            let digit = (0..decimals).fold(1.0, |digit, _| digit / 10.0);
            all.push(Printed {
                column,
                slot,
                at: at * published.columns[0].display.factor,
                value: shown * column.display.factor,
                rounding: digit * column.display.factor / 12.0_f64.sqrt(),
            });
        }
    }
    all
}

/// The quantities nearest to the published table; `None` where the table has nothing to tell them by.
#[must_use]
pub fn fit(mechanism: &dyn Mechanism, asked: &Request, seed: u64) -> Option<Fitted> {
    let printed = printed(mechanism);
    let bounds: Vec<[f64; 2]> = asked.varied.iter().map(|varied| varied.bounds).collect();
    let mut equations = Equations::new(mechanism, asked, &[]);
    let mut local = |parts: &[f64]| local(&mut equations, &bounds, &printed, parts);
    let own = asked
        .varied
        .iter()
        .map(|varied| (varied.value - varied.bounds[0]) / (varied.bounds[1] - varied.bounds[0]));
    let mut starts: Vec<Vec<f64>> = vec![own.collect()];
    for start in 1..STARTS {
        let mut random = fastrand::Rng::with_seed(seed.wrapping_mul(SPREAD).wrapping_add(start));
        starts.push(bounds.iter().map(|_| random.f64()).collect());
    }
    let found = starts.into_iter().filter_map(|start| descend(&mut local, start));
    // What the values do not tell stays as the scene has it.
    let better = |a: &Local, b: &Local| b.square() < (1.0 - 1e-9) * a.square();
    let (parts, best) = found.reduce(|a, b| if better(&a.1, &b.1) { b } else { a })?;
    Some(told(&printed, &bounds, &parts, &best))
}

fn local(equations: &mut Equations, bounds: &[[f64; 2]], printed: &[Printed], parts: &[f64]) -> Option<Local> {
    let values: Vec<f64> = parts
        .iter()
        .zip(bounds)
        .map(|(part, [low, high])| low + (high - low) * part)
        .collect();
    let (mut left, mut by) = (
        DVector::zeros(printed.len()),
        DMatrix::zeros(printed.len(), bounds.len()),
    );
    equations.set(&values);
    for (i, one) in printed.iter().enumerate() {
        let (value, slopes) = equations.slopes((one.slot, 1.0), one.at)?;
        left[i] = (value - one.value) / one.rounding;
        for (j, (slope, [low, high])) in slopes.iter().zip(bounds).enumerate() {
            by[(i, j)] = slope * (high - low) / one.rounding;
        }
    }
    let sound = left.iter().chain(by.iter()).all(|value| value.is_finite());
    sound.then_some(Local { left, by })
}

/// From a start to where no step is shorter any more.
fn descend(local: &mut impl FnMut(&[f64]) -> Option<Local>, start: Vec<f64>) -> Option<(Vec<f64>, Local)> {
    let (mut parts, mut here) = (start.clone(), local(&start)?);
    let mut damping = 1e-3;
    for _ in 0..STEPS {
        let columns = here
            .by
            .column_iter()
            .map(|column| column.norm_squared().max(f64::MIN_POSITIVE));
        let scale: Vec<f64> = columns.collect();
        // The damped problem as one of least squares: no squares of condition numbers.
        let (rows, count) = here.by.shape();
        let mut system = here.by.clone().resize_vertically(rows + count, 0.0);
        (0..count).for_each(|j| system[(rows + j, j)] = (damping * scale[j]).sqrt());
        let right = (-&here.left).resize_vertically(rows + count, 0.0);
        let step = system.svd(true, true).solve(&right, 1e-300).ok()?;
        let next: Vec<f64> = parts
            .iter()
            .zip(step.iter())
            .map(|(part, step)| (part + step).clamp(0.0, 1.0))
            .collect();
        let closer = |next: &Local| {
            let gained = here.square() - next.square();
            gained > 0.0 || gained > -LEVEL * here.square() && next.residual() < 0.5 * here.residual()
        };
        match local(&next).filter(closer) {
            Some(better) => {
                (parts, here) = (next, better);
                damping = (damping * 0.1).max(1e-20);
            }
            None => damping = (damping * 10.0).max(1e-12),
        }
        if damping > 1e12 {
            break;
        }
    }
    Some((parts, here))
}

/// Errors, and what cannot be told apart.
fn told(printed: &[Printed], bounds: &[[f64; 2]], parts: &[f64], best: &Local) -> Fitted {
    let (count, size) = (printed.len(), bounds.len());
    let norms: Vec<f64> = best.by.column_iter().map(|column| column.norm()).collect();
    let scaled = DMatrix::from_fn(count, size, |i, j| {
        if norms[j] > 0.0 {
            best.by[(i, j)] / norms[j]
        } else {
            0.0
        }
    });
    let whole = scaled.svd(false, true);
    let (sizes, vectors) = (whole.singular_values, whole.v_t.expect("asked for"));
    let greatest = sizes.max();
    let free = count.saturating_sub(size).max(1);
    let spread = (best.square() / free as f64).sqrt();
    let (mut errors, mut alike) = (vec![0.0; size], Vec::new());
    for (value, vector) in sizes.iter().zip(vectors.row_iter()) {
        let unknown = *value <= ALIKE * greatest;
        for j in 0..size {
            errors[j] += match unknown {
                true if vector[j].abs() > 1e-6 => f64::INFINITY,
                true => 0.0,
                false => (vector[j] / value).powi(2),
            };
        }
        if unknown {
            alike.push(vector.iter().copied().collect());
        }
    }
    for (j, error) in errors.iter_mut().enumerate() {
        let [low, high] = bounds[j];
        *error = match norms[j] {
            0.0 => f64::INFINITY,
            norm => error.sqrt() * spread * (high - low) / norm,
        };
    }
    let mut columns: Vec<&'static Symbol> = Vec::new();
    printed.iter().for_each(|one| {
        if !columns.contains(&one.column) {
            columns.push(one.column)
        }
    });
    let column = |symbol: &'static Symbol| {
        let own = printed
            .iter()
            .zip(best.left.iter())
            .filter(|(one, _)| one.column == symbol);
        let own: Vec<f64> = own.map(|(one, left)| left * one.rounding).collect();
        let square = own.iter().map(|left| left * left).sum::<f64>() / own.len() as f64;
        (
            symbol,
            square.sqrt(),
            own.iter().fold(0.0, |most: f64, left| most.max(left.abs())),
        )
    };
    Fitted {
        values: parts
            .iter()
            .zip(bounds)
            .map(|(part, [low, high])| low + (high - low) * part)
            .collect(),
        errors,
        left: (best.square() / count as f64).sqrt(),
        count,
        columns: columns.into_iter().map(column).collect(),
        alike,
        residual: best.residual(),
    }
}
