//! A hull under a crane with weight: the inertia that this adds to heave, heel and pitch, and what its motion does to them. (Lagrange)

use nalgebra::Vector3;

use crate::afloat::carrying::{CraneAfloat, MovedPoint};
use crate::afloat::symbols as s;
use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::parts::hanging::dot;

/// The hull under a crane: forces (N, N·m) on heave, heel and pitch, what moves with them (kg, kg·m²), accelerations of slewing and
/// luffing (rad/s²), travels of the head along the rope, and the mass of the load (kg).
#[derive(Clone, Copy, Debug)]
pub struct DrivenHull<C> {
    pub forces: [C; 3],
    pub masses: [C; 3],
    pub drives: [C; 2],
    pub arms: [C; 3],
    pub load: C,
}

impl<C: Calc> DrivenHull<C> {
    /// How heave, heel and pitch accelerate without a crane and its rope: F_i/m_i.
    pub fn alone(&self) -> [C; 3] {
        let names = listed!(s: B_Z, B_PHI, B_THETA);
        [0, 1, 2].map(|i| (self.forces[i] / self.masses[i]).def(names[i]))
    }

    /// And by the rope's force over the mass of the load: m_Q a_i/m_i.
    pub fn pulled(&self) -> [C; 3] {
        let names = listed!(s: KAPPA_Z, KAPPA_PHI, KAPPA_THETA);
        [0, 1, 2].map(|i| (self.load * self.arms[i] / self.masses[i]).def(names[i]))
    }
}

/// What hull and head do without the rope, and what it does to the hull.
struct Yielding;

impl Finding<9> for Yielding {
    type From<C: Calc> = (CraneAfloat<C>, DrivenHull<C>);
    const NAMES: [&'static Symbol; 9] =
        *listed!(s: C_X, C_Y, C_Z, B_Z, B_PHI, B_THETA, KAPPA_Z, KAPPA_PHI, KAPPA_THETA);

    fn map<C: Calc, D: Calc>((crane, on): &Self::From<C>, f: &mut dyn FnMut(C) -> D) -> Self::From<D> {
        let driven = DrivenHull {
            forces: on.forces.map(&mut *f),
            masses: on.masses.map(&mut *f),
            drives: on.drives.map(&mut *f),
            arms: on.arms.map(&mut *f),
            load: f(on.load),
        };
        (crane.map(f), driven)
    }

    fn find<C: Calc>((crane, on): &Self::From<C>) -> Result<[C; 9], Fault> {
        let zero = C::constant(0.0);
        let mut inertia = [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { on.masses[i] } else { zero }));
        let mut forces = on.forces;
        let weight = Vector3::new(zero, zero, crane.gravity);
        let driven =
            |moved: &MovedPoint<C>| moved.bend + moved.travel[3] * on.drives[0] + moved.travel[4] * on.drives[1];
        for mass in &crane.masses {
            let moved = crane.moved(mass);
            let own = driven(&moved) + weight;
            for i in 0..3 {
                forces[i] -= mass.mass * dot(moved.travel[i], own);
                for (sum, travel) in inertia[i].iter_mut().zip(&moved.travel) {
                    *sum += mass.mass * dot(moved.travel[i], *travel);
                }
            }
        }
        let free = solved(&inertia, forces);
        let pulled = solved(&inertia, on.arms).map(|by| on.load * by);
        let head = driven(&crane.moved(&crane.head));
        Ok([
            head.x, head.y, head.z, free[0], free[1], free[2], pulled[0], pulled[1], pulled[2],
        ])
    }
}

/// A x = b of a symmetric matrix, by its factors L D Lᵀ.
#[inline(never)]
fn solved<C: Calc>(a: &[[C; 3]; 3], b: [C; 3]) -> [C; 3] {
    let (p, q) = (a[1][0] / a[0][0], a[2][0] / a[0][0]);
    let second = a[1][1] - p * a[1][0];
    let r = (a[2][1] - q * a[1][0]) / second;
    let third = a[2][2] - q * a[2][0] - r * r * second;
    let y = b[1] - p * b[0];
    let z = (b[2] - q * b[0] - r * y) / third;
    let y = y / second - r * z;
    [b[0] / a[0][0] - p * y - q * z, y, z]
}

/// Acceleration of the head (m/s²), and of heave, heel and pitch without the rope, and by it.
pub type Yields<C> = (Vector3<C>, [C; 3], [C; 3]);

/// Acceleration of the head (m/s²) where heave, heel and pitch keep their speeds, how these accelerate without the rope, and by its
/// force over the mass of the load.
///
/// # Errors
/// As [`found`]; there is none.
pub fn yielding<C: Scalar>(crane: &CraneAfloat<C>, on: DrivenHull<C>) -> Result<Yields<C>, Fault> {
    let [x, y, z, a, b, c, d, e, f] = found::<Yielding, C, 9>(&(crane.clone(), on))?;
    Ok((Vector3::new(x, y, z), [a, b, c], [d, e, f]))
}
