//! Four positions, the first two infinitely close (Burmester). [Balance004, eq. 4]
//!
//! Given are the nodes and the lever's pivot. The joint L on the lever, at its
//! distance `R_1` and an angle to be found, is seen from the boom in three
//! positions and moves in the first: the joint K on the boom has the same
//! distance from all three and lies across that motion. Three linear equations
//! for the two coordinates of K: their determinant must vanish, which gives the
//! angle. With `R_1` running, K and L run along Burmester's curves.

use std::f64::consts::{PI, TAU};

use crate::three::{near_zero, ordinate};
use lemnis_models::balance::boom::Boom;
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::balance::symbols as s;
use lemnis_models::kernel::allowed::{FINITE, OutOfRange, POSITIVE, check};
use lemnis_models::kernel::calc::Calc;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::parts::plane::{self, Point};

/// Nodes of approximation: at the first also the derivative is met.
#[derive(Clone, Copy, Debug)]
pub struct Nodes {
    /// Boom angles, in rad; the first counts twice.
    pub phi: [f64; 3],
    /// Angles of the counterweight's arm, in rad.
    pub psi: [f64; 3],
    /// dψ/dφ at the first node.
    pub slope: f64,
    /// Weight of the counterweight times its arm, in N·m.
    pub m_5: f64,
}

/// Angles of the rod arm tried in a turn before a root is refined.
const GRID: usize = 1440;

impl Nodes {
    /// Ordinates and slope that balance the boom exactly. [Balance004, eq. 4]
    ///
    /// # Errors
    /// Nodes that coincide, a boom that does not close there, a counterweight too light.
    pub fn new(boom: &(dyn Boom<f64> + Sync), phi: [f64; 3], psi_1: f64, m_5: f64) -> Result<Nodes, OutOfRange> {
        check(&s::M_5, m_5, POSITIVE)?;
        check(&s::PSI, psi_1, FINITE)?;
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let apart = (phi[i] - phi[j]).abs();
            if apart.is_nan() || apart <= 1e-6 {
                return Err(OutOfRange::new(
                    &s::PHI,
                    phi[j],
                    FINITE,
                    "two nodes coincide or are no numbers",
                ));
            }
        }
        let first = boom.at(phi[0])?;
        let at = |phi: f64| ordinate(m_5, psi_1, first.u_0, boom.at(phi)?.u_0);
        // Checks that the counterweight is behind the pivot at the first node too.
        ordinate(m_5, psi_1, first.u_0, first.u_0)?;
        Ok(Nodes {
            phi,
            psi: [psi_1, at(phi[1])?, at(phi[2])?],
            slope: first.m_0 / (m_5 * Calc::sin_cos(psi_1).1),
            m_5,
        })
    }

    /// Every lever with the rod arm `lever` (m) and the pivot at `d_1` (m),
    /// `delta_1` (rad) that passes all nodes in one branch.
    ///
    /// # Errors
    /// A length that is not positive; no lever with this rod arm.
    pub fn levers(&self, d_1: f64, delta_1: f64, lever: f64) -> Result<Vec<Lever<f64>>, OutOfRange> {
        check(&s::D_1, d_1, POSITIVE)?;
        check(&s::DELTA_1, delta_1, FINITE)?;
        check(&s::R_L, lever, POSITIVE)?;
        let (sin, cos) = Calc::sin_cos(delta_1);
        let pivot = Point::new(d_1 * cos, d_1 * sin);
        let step = TAU / GRID as f64;
        let mut found = Vec::new();
        let determinant = |chi: f64| self.equations(pivot, lever, chi).1;
        let mut before = determinant(-PI);
        for i in 1..=GRID {
            let [mut low, mut high] = [-PI + (i - 1) as f64 * step, -PI + i as f64 * step];
            let after = determinant(high);
            if (before > 0.0) != (after > 0.0) {
                for _ in 0..60 {
                    let middle = f64::midpoint(low, high);
                    if (determinant(middle) > 0.0) == (before > 0.0) {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                found.extend(self.lever(pivot, [d_1, delta_1, lever], f64::midpoint(low, high)));
            }
            before = after;
        }
        if found.is_empty() {
            let what = "no lever with this rod arm passes the nodes in one branch";
            return Err(OutOfRange::new(&s::R_L, lever, POSITIVE, what));
        }
        Ok(found)
    }

    /// The joint on the boom, in the boom's frame, by the two best of three
    /// linear equations, and the determinant of all three.
    fn equations(&self, pivot: Point<f64>, lever: f64, chi_5: f64) -> (Point<f64>, f64) {
        let seen = |i: usize| {
            let (sin, cos) = Calc::sin_cos(self.psi[i] - chi_5);
            let arm = Point::new(lever * cos, lever * sin);
            let (sin, cos) = Calc::sin_cos(-self.phi[i]);
            (plane::turned(pivot + arm, cos, sin), plane::turned(arm, cos, sin))
        };
        let (first, arm) = seen(0);
        // Motion seen from the boom: the lever turns at `slope`, the boom at 1.
        let motion = Point::new(-(self.slope * arm.y - first.y), self.slope * arm.x - first.x);
        let row = |i: usize| {
            let chord = seen(i).0 - first;
            (chord, 0.5 * plane::dot(chord, chord))
        };
        // From the first position of L: normal · (K − L) = right.
        let rows = [(motion, 0.0), row(1), row(2)];
        let minor = |i: usize, j: usize| plane::cross(rows[i].0, rows[j].0);
        let determinant = rows[0].1 * minor(1, 2) - rows[1].1 * minor(0, 2) + rows[2].1 * minor(0, 1);
        let pairs = [(0, 1), (0, 2), (1, 2)];
        let (i, j) = pairs
            .into_iter()
            .max_by(|a, b| minor(a.0, a.1).abs().total_cmp(&minor(b.0, b.1).abs()))
            .expect("three pairs");
        let ((a, p), (b, q)) = (rows[i], rows[j]);
        let offset = Point::new(p * b.y - q * a.y, a.x * q - b.x * p) / minor(i, j);
        (first + offset, determinant)
    }

    fn lever(&self, pivot: Point<f64>, [d_1, delta_1, arm]: [f64; 3], chi_5: f64) -> Option<Lever<f64>> {
        let (k, _) = self.equations(pivot, arm, chi_5);
        let r_1 = plane::length(k);
        let alpha_1 = f64::direction(k.x, k.y);
        let mut lengths = [0.0; 3];
        let mut sides = [false; 3];
        for i in 0..3 {
            let (sin, cos) = Calc::sin_cos(self.phi[i]);
            let diagonal = plane::turned(k, cos, sin) - pivot;
            let (sin, cos) = Calc::sin_cos(self.psi[i] - chi_5);
            let rod_arm = Point::new(arm * cos, arm * sin);
            lengths[i] = plane::length(rod_arm - diagonal);
            sides[i] = plane::cross(diagonal, rod_arm) > 0.0;
        }
        let l_1 = lengths[0];
        let one_rod = lengths.iter().all(|length| (length - l_1).abs() <= 1e-9 * l_1);
        if !(one_rod && sides == [sides[0]; 3]) {
            return None;
        }
        let dimensions = Dimensions {
            d_1,
            delta_1,
            r_1,
            alpha_1: near_zero(alpha_1),
            l_1,
            lever: arm,
            chi_5: near_zero(chi_5),
            m_5: self.m_5,
        };
        let branch = if sides[0] { Branch::Left } else { Branch::Right };
        Lever::new(dimensions, None, branch).ok()
    }
}
