//! Small quadratic programs: ½ dᵀB d + gᵀd least where A d ≤ b, with B positive definite, as the least distance to a
//! cone's polyhedron, which a least-squares problem with unknowns that are not negative solves in finitely many steps.
//! [Lawson and Hanson, Solving Least Squares Problems, 1974, ch. 23]

use nalgebra::{DMatrix, DVector};

/// A solution with the multiplier of every row.
pub struct Solved {
    pub step: DVector<f64>,
    pub multipliers: DVector<f64>,
}

/// `None` where no step keeps all rows, or B is not positive definite.
#[must_use]
pub fn least(b: &DMatrix<f64>, g: &DVector<f64>, rows: &DMatrix<f64>, limits: &DVector<f64>) -> Option<Solved> {
    let root = b.clone().cholesky()?.l();
    let reach = root.solve_lower_triangular(g)?;
    // A L⁻ᵀ, row by row.
    let cone = root.solve_lower_triangular(&rows.transpose())?.transpose();
    let short = limits + &cone * &reach;
    let (count, size) = cone.shape();
    let mut system = DMatrix::zeros(size + 1, count);
    system.rows_mut(0, size).copy_from(&-cone.transpose());
    system.row_mut(size).copy_from(&-short.transpose());
    let mut wanted = DVector::zeros(size + 1);
    wanted[size] = 1.0;
    let weights = not_negative(&system, &wanted);
    let rest = &system * &weights - wanted;
    if rest[size] > -1e-14 {
        return None;
    }
    let nearest = rest.rows(0, size) / -rest[size];
    let step = root.tr_solve_lower_triangular(&(nearest - reach))?;
    Some(Solved {
        step,
        multipliers: weights / -rest[size],
    })
}

/// The unknowns, none negative, with the least |E u − f|. [Lawson and Hanson, ch. 23, NNLS]
#[must_use]
pub fn not_negative(e: &DMatrix<f64>, f: &DVector<f64>) -> DVector<f64> {
    let count = e.ncols();
    let mut u = DVector::zeros(count);
    let mut free: Vec<usize> = Vec::new();
    let norms: Vec<f64> = e.column_iter().map(|column| column.norm()).collect();
    for _ in 0..3 * count + 10 {
        let gradient = e.transpose() * (f - e * &u);
        let rises = |i: &usize| gradient[*i] > 1e-13 * norms[*i].max(f64::MIN_POSITIVE) * f.norm();
        let bound = (0..count).filter(|i| !free.contains(i)).filter(rises);
        let steepness = |i: usize| gradient[i] / norms[i];
        let Some(next) = bound.max_by(|&a, &b| steepness(a).total_cmp(&steepness(b))) else {
            break;
        };
        free.push(next);
        while let Some(inner) = least_squares(e, f, &free) {
            let blocked = free.iter().zip(inner.iter()).filter(|(_, value)| **value <= 0.0);
            let part = blocked
                .map(|(&i, &value)| u[i] / (u[i] - value))
                .fold(f64::INFINITY, f64::min);
            if part.is_infinite() {
                free.iter().zip(inner.iter()).for_each(|(&i, &value)| u[i] = value);
                break;
            }
            let part = if part.is_nan() { 0.0 } else { part };
            for (&i, &value) in free.iter().zip(inner.iter()) {
                u[i] += part * (value - u[i]);
                if value <= 0.0 && u[i] <= 1e-300 + 1e-15 * value.abs() {
                    u[i] = 0.0;
                }
            }
            let before = free.len();
            free.retain(|&i| u[i] > 0.0);
            if free.len() == before || free.is_empty() {
                break;
            }
        }
    }
    u
}

/// The unconstrained unknowns of some columns.
fn least_squares(e: &DMatrix<f64>, f: &DVector<f64>, columns: &[usize]) -> Option<DVector<f64>> {
    if columns.is_empty() {
        return None;
    }
    e.select_columns(columns).svd(true, true).solve(f, 1e-14).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The nearest point to (2, 1) in the triangle below x + y = 1: (1, 0), where two rows hold.
    #[test]
    fn a_corner() {
        let b = DMatrix::identity(2, 2);
        let g = DVector::from_vec(vec![-2.0, -1.0]);
        let rows = DMatrix::from_row_slice(3, 2, &[1.0, 1.0, -1.0, 0.0, 0.0, -1.0]);
        let limits = DVector::from_vec(vec![1.0, 0.0, 0.0]);
        let found = least(&b, &g, &rows, &limits).expect("a corner");
        assert!((found.step - DVector::from_vec(vec![1.0, 0.0])).norm() < 1e-14);
        // g + B d = −Aᵀλ: (−1, −1) is the first row alone.
        assert!((found.multipliers - DVector::from_vec(vec![1.0, 0.0, 0.0])).norm() < 1e-14);
    }

    #[test]
    fn no_point() {
        let rows = DMatrix::from_row_slice(2, 1, &[1.0, -1.0]);
        let limits = DVector::from_vec(vec![-1.0, -1.0]);
        assert!(least(&DMatrix::identity(1, 1), &DVector::zeros(1), &rows, &limits).is_none());
    }
}
