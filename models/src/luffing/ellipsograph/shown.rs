//! What is the boom's own in what its book tells of it in motion.

use crate::balance::symbols as b;
use crate::component::description::Description;
use crate::component::moving::MovingComponent;
use crate::drive::mount::Bore;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::ellipsograph::scene::Ellipsograph;
use crate::luffing::ellipsograph::stages::{EllipsographBoom, Given};
use crate::luffing::moving::carried;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::told::shown::{Apart, OwnPart, Shown, ShownBar};

/// Quantities of the boom and of its drive.
mod s {
    pub use crate::drive::symbols::F_D;
    pub use crate::luffing::ellipsograph::symbols::*;
}

impl Shown for Ellipsograph {
    const BARS: &'static [ShownBar] = &[ShownBar {
        angle: ("motion_boom_angle", &b::PHI),
        speed: ("motion_boom_speed", &s::OMEGA),
        acceleration: &s::D_OMEGA,
    }];

    const REACH: &'static Symbol = &s::R;

    const SECTIONS: &'static [OwnPart] = &[
        (
            "motion_bodies",
            "ellipsograph_bodies",
            listed! { s:
                J_BQ, S_MX, S_MY, DS_MX, DS_MY, DS_LX, DS_LY, DA_X, DA_Y, MASS_B, I_RB, DI_RB, MASS_L, I_RL, DI_RL
            },
        ),
        ("motion_equations", "motion_equations", &[&s::D_OMEGA]),
        (
            "motion_forces",
            "ellipsograph_forces",
            listed! { s:
                M_BC, F_BX, F_CX, F_CY, F_ILX, F_ILY, M_LO, M_D, P_D, F_D, N_L, F_O1X, F_O1Y
            },
        ),
    ];

    const ASSEMBLED: &'static [&'static Symbol] = &[&s::J_BQ];

    const FORCES: &'static [&'static Symbol] = &[&m::M_R, &s::F_BX, &s::N_L, &s::F_O1X, &s::F_O1Y];

    const AGREEMENT: &'static Symbol = &s::AGREEMENT;

    const APART: Option<Apart> = Some(apart);

    fn moves(this: &Description<Ellipsograph>) -> Option<(Given<f64>, &Moving)> {
        Some((this.given.clone(), this.moving.as_ref()?))
    }

    fn bore(this: &Description<Ellipsograph>) -> Option<Bore<f64>> {
        this.driving.cylinder
    }
}

fn apart(model: &mut MovingComponent) -> Option<[f64; 2]> {
    Some(
        carried::known::<EllipsographBoom>(model.parts().0)
            .forces()
            .ok()?
            .apart(),
    )
}
