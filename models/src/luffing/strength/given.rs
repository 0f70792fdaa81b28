//! What is given of the sizes that are checked.

use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::luffing::strength::symbols as s;

quantities! {
    /// The drive's bar against buckling: Young's modulus and yield point (Pa), safety, end factor, length that is not free (m).
    Strut { e: E_K, sigma_y: SIGMA_Y, s: S_K, mu: MU_K, l_0: L_0 }
}

quantities! {
    /// Cross-section (m²) and smallest radius of gyration (m) of a bar that is not round.
    Profile { area: A_K, radius: I_MIN }
}

quantities! {
    /// Teeth of a pinion with its rack or sector: load factor, form factor, width and module (m), pressure angle (rad),
    /// Young's modulus (Pa) and Poisson's ratio.
    Teeth { k: K_F, y: Y_F, b: B_F, m: M_T, alpha: ALPHA_T, e: E_T, nu: NU_T }
}

quantities! {
    /// Core of a screw, overlap and pitch of its threads, and length of its nut, in m.
    Nut { d_3: D_3, h_1: H_1, p_1: P_1, l_n: L_N }
}

quantities! {
    /// A rope: minimum breaking force (N), safety factor, and diameters of rope, drum and smallest sheave (m).
    Wire { f_min: F_MIN, z_p: Z_P, d_w: D_W, d_tr: D_TR, d_sh: D_SH }
}

quantities! {
    /// Diameter of a pin, and width over which it is pressed, in m.
    PinSize { d: D_P, b: B_P }
}

/// What follows from the amount of a force, which is infinite where that is and nothing where there is none.
pub(super) fn under<C: Calc>(force: C, f: impl FnOnce(C) -> C) -> C {
    let amount = force.abs();
    match amount.value() {
        0.0 => C::constant(0.0).over(force),
        value if value.is_finite() => f(amount),
        _ => amount,
    }
}
