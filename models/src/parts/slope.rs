//! A slope under what slews: gravity turns in its frame, and its weights turn it downhill.

use nalgebra::Vector3;

use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::keys::keys;
use crate::kernel::schema::Key;
use crate::kernel::symbol::symbols;
use crate::parts::slope as s;

symbols! {
    GAMMA_S: "gamma_s" "gamma_\"s\"" RAD / DEG [from_to(0.0, 0.5)], "Slope on which the crane stands; the slewing angle counts from its downhill direction.", "input";
    G_U: "G_u" "G_u" N / KN [not_negative], "Weight of all that slews but the bodies of a luffing mechanism beside it and the load.", "input";
    R_U: "r_u" "r_u" M / M, "Distance of the centre of gravity of that weight from the slewing axis; positive on the load's side.", "input";
    G_S: "g_s" "g_\"s\"" M_PER_S2 / M_PER_S2, "Acceleration of gravity down the slope.", "derived";
    M_GAMMA: "M_gamma" "M_gamma" N_M / KN_M, "Moment of the weights on the slope about the slewing axis; positive counter-clockwise, seen from above.", "virtual work";
}

quantities! {
    /// The ground, and what stands on it besides load and luffing mechanism.
    SlopingGround { gamma_s: GAMMA_S, g_u: G_U, r_u: R_U }
}

static KEYS: &[Key] = keys! { s: GAMMA_S >= 0, G_U [or_mass], R_U };

/// Its table, of what slews.
pub const SLOPE: Key = Key::part("slope", KEYS, "The ground that is not level, and what stands on it.");

impl<C: Calc> SlopingGround<C> {
    /// Gravity (m/s²) at a slewing angle (rad), in the frame that slews: g (sin γ cos ψ, −cos γ, −sin γ sin ψ). Downhill is
    /// forward at no angle, and to the right at a quarter turn.
    pub fn gravity(&self, g: C, psi: C) -> Vector3<C> {
        let ((steep, level), (aside, ahead)) = (self.gamma_s.sin_cos(), psi.sin_cos());
        let downhill = (g * steep).def(&G_S);
        Vector3::new(downhill * ahead, -(g * level), -(downhill * aside))
    }

    /// Moment about the slewing axis (N·m) of weights times their distance forward of it (N·m): −W sin γ sin ψ. [Ports001, 6.4]
    pub fn across(&self, weighed: C, psi: C) -> C {
        let (steep, _) = self.gamma_s.sin_cos();
        let (aside, _) = psi.sin_cos();
        -(weighed * steep * aside)
    }
}

/// Gravity (m/s²) in the frame of what slews, at its angle (rad), on a slope or on level ground.
pub fn gravity<C: Calc>(slope: Option<&SlopingGround<C>>, g: C, psi: C) -> Vector3<C> {
    let zero = C::constant(0.0);
    slope.map_or(Vector3::new(zero, -g, zero), |slope| slope.gravity(g, psi))
}
