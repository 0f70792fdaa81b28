//! How the hull lies on the water while it moves, and what the water does to it.
//!
//! Heave, heel and pitch are its coordinates: the centre of gravity of all but the load goes up and down and not aside, and the
//! hull keeps its heading. With heel `φ` about the hull's own long axis and its pitch `θ`, up is `(−sin θ, −sin φ cos θ,
//! cos φ cos θ)` in the hull.

use crate::afloat::hull::Floating;
use crate::afloat::symbols as s;
use crate::afloat::weights::DeadLoad;
use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;

quantities! {
    /// Height of the centre of gravity, heel and pitch, with their rates.
    HullMotion { h_g: H_G, phi_x: PHI_X, theta_y: THETA_Y, v_g: V_G, omega_x: OMEGA_X, omega_y: OMEGA_Y }
}

quantities! {
    /// What heaves, rolls and pitches with the hull, and what dampens that.
    BuoyedMass { m_a: M_A, j_x: J_X, j_y: J_Y, d_z: D_Z, d_x: D_X, d_y: D_Y }
}

/// Centre of gravity without load (m), draft (m) and slopes of the water; sines and cosines of heel and pitch.
#[derive(Clone, Copy, Debug)]
pub struct RidingHull<C> {
    pub centre: [C; 3],
    /// Draft, slopes along and across.
    pub plane: [C; 3],
    pub roll: (C, C),
    pub pitch: (C, C),
}
results! { RidingHull as h => {
    X_G: h.centre[0];
    Y_G: h.centre[1];
    Z_G0: h.centre[2];
    T_X: h.plane[1];
    T_Y: h.plane[2];
    T_M: h.plane[0];
} }

impl<C: Calc> RidingHull<C> {
    /// x_G = Σ G x / W_0; t_x = tan θ / cos φ, t_y = tan φ; T_m = z_G − t_x x_G − t_y y_G − h_G / (cos φ cos θ).
    pub fn new(motion: &HullMotion<C>, dead: &DeadLoad<C>) -> RidingHull<C> {
        let (weight, [along, across]) = (dead.all.weight, dead.own);
        let centre = [
            (along / weight).def(&s::X_G),
            (across / weight).def(&s::Y_G),
            (dead.all.up / weight).def(&s::Z_G0),
        ];
        let (roll, pitch) = (motion.phi_x.sin_cos(), motion.theta_y.sin_cos());
        let along = (pitch.0 / (pitch.1 * roll.1)).def(&s::T_X);
        let across = (roll.0 / roll.1).def(&s::T_Y);
        let sunk = motion.h_g / (roll.1 * pitch.1);
        let draft = centre[2] - along * centre[0] - across * centre[1] - sunk;
        RidingHull {
            centre,
            plane: [draft.def(&s::T_M), along, across],
            roll,
            pitch,
        }
    }
}

/// The hull cut by the water, the tanks by their liquids.
struct Wetting;

impl Finding<4> for Wetting {
    type From<C: Calc> = (Floating<C>, [C; 3]);
    const NAMES: [&'static Symbol; 4] = *listed!(s: NABLA_M, K_X, K_Y, K_Z);

    fn map<C: Calc, D: Calc>((on, plane): &(Floating<C>, [C; 3]), f: &mut dyn FnMut(C) -> D) -> (Floating<D>, [D; 3]) {
        (on.map(f), plane.map(f))
    }

    fn find<C: Calc>((on, plane): &(Floating<C>, [C; 3])) -> Result<[C; 4], Fault> {
        let cut = on.cut(*plane);
        let mut moment = cut.moment.map(|moment| on.water * moment);
        for tank in &on.tanks {
            let (moved, _) = tank.leaning([plane[1], plane[2]]);
            for (sum, moved) in moment.iter_mut().zip(moved) {
                *sum -= tank.weight * moved;
            }
        }
        let [x, y, z] = moment;
        Ok([cut.volume, x, y, z])
    }
}

/// How high the deck's edge is above the water.
struct Clearing;

impl Finding<1> for Clearing {
    type From<C: Calc> = (Floating<C>, [C; 3]);
    const NAMES: [&'static Symbol; 1] = *listed!(s: F_M);

    fn map<C: Calc, D: Calc>(from: &(Floating<C>, [C; 3]), f: &mut dyn FnMut(C) -> D) -> (Floating<D>, [D; 3]) {
        Wetting::map(from, f)
    }

    fn find<C: Calc>((on, [t, a, b]): &(Floating<C>, [C; 3])) -> Result<[C; 1], Fault> {
        let one = C::constant(1.0);
        let across = |y: C| if b.value() > 0.0 { y * *b } else { -(y * *b) };
        let over = on.deck().into_iter().map(|[x, y, z]| z - *t - x * *a - across(y));
        let least = over.reduce(C::smaller).unwrap_or(one);
        Ok([least / (one + a.square() + b.square()).sqrt()])
    }
}

/// Least freeboard of the deck's edge, in m.
///
/// # Errors
/// As [`found`]; a cut always is.
pub fn clearing<C: Scalar>(on: &Floating<C>, riding: &RidingHull<C>) -> Result<C, Fault> {
    Ok(found::<Clearing, C, 1>(&(on.clone(), riding.plane))?[0])
}

/// Volume under water (m³), and moments of the displaced water with liquids that have moved (N·m).
#[derive(Clone, Copy, Debug)]
pub struct WettedHull<C>([C; 4]);
results! { WettedHull as w => { NABLA_M: w.0[0]; K_X: w.0[1]; K_Y: w.0[2]; K_Z: w.0[3]; } }

impl<C: Scalar> WettedHull<C> {
    /// # Errors
    /// As [`found`]; a cut always is.
    pub fn new(on: &Floating<C>, riding: &RidingHull<C>) -> Result<WettedHull<C>, Fault> {
        found::<Wetting, C, 4>(&(on.clone(), riding.plane)).map(WettedHull)
    }
}

/// Force (N) and moments (N·m) on heave, heel and pitch, without the rope's.
#[derive(Clone, Copy, Debug)]
pub struct WaterForces<C> {
    pub all: [C; 3],
    unbalanced: [C; 3],
}
results! { WaterForces as w => {
    F_Z: w.all[0];
    M_X: w.all[1];
    M_Y: w.all[2];
    P_X: w.unbalanced[0];
    P_Y: w.unbalanced[1];
    P_Z: w.unbalanced[2];
} }

impl<C: Calc> WaterForces<C> {
    /// F = ρ g ∇ − W_0 − d_z v; P = K − M_0 − (ρ g ∇ − W_0) r_G; M_x = −cos θ (cos φ P_y + sin φ P_z) − d_x ω_x,
    /// M_y = −cos θ P_x + sin θ (sin φ P_y − cos φ P_z) − d_y ω_y.
    pub fn new(
        motion: &HullMotion<C>,
        buoyed: &BuoyedMass<C>,
        riding: &RidingHull<C>,
        dead: &DeadLoad<C>,
        wetted: &WettedHull<C>,
        density: &One<C>,
        gravity: &One<C>,
    ) -> WaterForces<C> {
        let [volume, moments @ ..] = wetted.0;
        let lift = **density * **gravity * volume - dead.all.weight;
        let force = (lift - buoyed.d_z * motion.v_g).def(&s::F_Z);
        let (own, names) = (
            [dead.all.along, dead.all.across, dead.all.up],
            listed!(s: P_X, P_Y, P_Z),
        );
        let unbalanced = [0, 1, 2].map(|i| (moments[i] - own[i] - lift * riding.centre[i]).def(names[i]));
        let ([x, y, z], (sin, cos), (steep, level)) = (unbalanced, riding.roll, riding.pitch);
        let rolling = -(level * (cos * y + sin * z)) - buoyed.d_x * motion.omega_x;
        let pitching = steep * (sin * y - cos * z) - level * x - buoyed.d_y * motion.omega_y;
        WaterForces {
            all: [force, rolling.def(&s::M_X), pitching.def(&s::M_Y)],
            unbalanced,
        }
    }
}
