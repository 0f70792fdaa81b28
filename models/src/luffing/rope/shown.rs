//! What is the boom's own in what its book tells of it in motion.

use crate::balance::symbols as b;
use crate::component::description::Description;
use crate::component::moving::MovingComponent;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::moving::carried;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::told::shown::{Apart, Drawn, OwnPart, Shown, ShownBar};
use crate::luffing::rope::scene::Rope;
use crate::luffing::rope::stages::{Given, RopeBoom};
use crate::luffing::rope::symbols as s;

impl Shown for Rope {
    const BARS: &'static [ShownBar] = &[ShownBar {
        angle: ("motion_boom_angle", &b::PHI),
        speed: ("motion_boom_speed", &s::OMEGA),
        acceleration: &s::D_OMEGA,
    }];

    const REACH: &'static Symbol = &s::R;

    const SECTIONS: &'static [OwnPart] = &[
        (
            "motion_bodies",
            "rope_bodies",
            listed! { s:
                MASS_B, S_BX, S_BY, A_X, A_Y, DA_X, DA_Y, L_S, H_S, DH_S, I_RB, DI_RB
            },
        ),
        ("motion_equations", "motion_equations", &[&s::D_OMEGA]),
        (
            "motion_forces",
            "rope_dynamic",
            listed! { s:
                K_LX, K_LY, L_TX, L_TY, L_T, H_T, T_DYN, M_BO, L_SX, L_SY, S_H, F_K, F_O1X, F_O1Y, N_B
            },
        ),
    ];

    const STAGES: &'static [&'static str] = &["moves", "led", "standing", "tackle", "acting", "countered", "forces"];

    const DRIVE: Drawn = ("rope_dynamic", &s::T_DYN);

    const FORCES: &'static [&'static Symbol] = &[&s::T_DYN, &m::M_R, &s::S_H, &s::F_O1X, &s::F_O1Y, &s::N_B];

    const AGREEMENT: &'static Symbol = &s::AGREEMENT;

    const APART: Option<Apart> = Some(apart);

    fn moves(this: &Description<Rope>) -> Option<(Given<f64>, &Moving)> {
        Some((this.given.clone(), this.moving.as_ref()?))
    }
}

fn apart(model: &mut MovingComponent) -> Option<[f64; 2]> {
    Some(carried::known::<RopeBoom>(model.parts().0).forces().ok()?.apart())
}
