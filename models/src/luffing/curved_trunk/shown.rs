//! What is the boom's own in what its book tells of it in motion.

use crate::balance::symbols as b;
use crate::component::description::Description;
use crate::component::moving::MovingComponent;
use crate::drive::mount::Bore;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::curved_trunk::scene::CurvedTrunk;
use crate::luffing::curved_trunk::stages::{CurvedTrunkBoom, Given};
use crate::luffing::moving::carried;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::told::shown::{Apart, OwnPart, Shown, ShownBar};

/// Quantities of the boom and of its drive.
mod s {
    pub use crate::drive::symbols::F_D;
    pub use crate::luffing::curved_trunk::symbols::*;
    pub use crate::luffing::led::symbols::{F_R1X, F_R1Y, F_R2X, F_R2Y, M_R1, M_R2, S_H};
}

impl Shown for CurvedTrunk {
    const BARS: &'static [ShownBar] = &[ShownBar {
        angle: ("motion_boom_angle", &b::PHI),
        speed: ("motion_boom_speed", &s::OMEGA),
        acceleration: &s::D_OMEGA,
    }];

    const REACH: &'static Symbol = &s::R;

    const SECTIONS: &'static [OwnPart] = &[
        (
            "motion_bodies",
            "trunk_bodies",
            listed! { s:
                J_TQ, H_O, I_2, DA_X, DA_Y, B_E, T_E, DPSI_T, DI_2, S_BX, S_BY, DS_BX, DS_BY, S_MX, S_MY, DS_MX, DS_MY, DDS_MX,
                DDS_MY, MASS_B, I_RB, DI_RB, MASS_T, I_RT, DI_RT
            },
        ),
        ("motion_equations", "motion_equations", &[&s::D_OMEGA]),
        (
            "motion_forces",
            "trunk_dynamic",
            listed! { s:
                S_H, F_R1X, F_R1Y, M_R1, F_R2X, F_R2Y, M_R2, F_ITX, F_ITY, M_TB, N_T, Q_T, F_BX, F_BY, M_BO, M_D, P_D, F_D, F_O1X, F_O1Y
            },
        ),
    ];

    const ASSEMBLED: &'static [&'static Symbol] = &[&s::J_TQ];

    const FORCES: &'static [&'static Symbol] = &[&m::M_R, &s::N_T, &s::Q_T, &s::F_BX, &s::F_BY, &s::F_O1X, &s::F_O1Y];

    const AGREEMENT: &'static Symbol = &s::AGREEMENT;

    const APART: Option<Apart> = Some(apart);

    fn moves(this: &Description<CurvedTrunk>) -> Option<(Given<f64>, &Moving)> {
        Some((this.given.clone(), this.moving.as_ref()?))
    }

    fn bore(this: &Description<CurvedTrunk>) -> Option<Bore<f64>> {
        this.driving.cylinder
    }
}

fn apart(model: &mut MovingComponent) -> Option<[f64; 2]> {
    Some(
        carried::known::<CurvedTrunkBoom>(model.parts().0)
            .forces()
            .ok()?
            .apart(),
    )
}
