//! What is the double link's own in what its book tells of it in motion.

use crate::component::description::Described;
use crate::component::moving::MovingComponent;
use crate::drive::mount::Bore;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::double_link::moving::symbols as m;
use crate::luffing::double_link::outline::OUTLINE;
use crate::luffing::double_link::scene::{Luffing, LuffingScene};
use crate::luffing::double_link::stages::{DoubleLink, Given};
use crate::luffing::double_link::symbols as s;
use crate::luffing::led::symbols as w;
use crate::luffing::moving::carried;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::told::shown::{Apart, Drawn, OwnPart, Shown, ShownBar};

impl Shown for LuffingScene {
    const BARS: &'static [ShownBar] = &[
        ShownBar {
            angle: ("motion_boom_angle", &s::THETA_1),
            speed: ("motion_boom_speed", &s::OMEGA_1),
            acceleration: &m::D_OMEGA_1,
        },
        ShownBar {
            angle: ("motion_rocker_angle", &s::THETA_3),
            speed: ("motion_rocker_speed", &s::OMEGA_3),
            acceleration: &m::D_OMEGA_3,
        },
    ];

    const REACH: &'static Symbol = &s::R;

    const SECTIONS: &'static [OwnPart] = &[
        (
            "motion_bodies",
            "motion_bodies",
            listed! { m:
                J_2Q, MASS_1, DX_1, DY_1, DDX_1, DDY_1, DI_1, I_R1, DI_R1, MASS_2, DX_2, DY_2, DDX_2, DDY_2, DI_2,
                I_R2, DI_R2, MASS_3, DX_3, DY_3, DDX_3, DDY_3, DI_3, I_R3, DI_R3
            },
        ),
        (
            "motion_slewing",
            "motion_slewing",
            listed! { m: X_S1, X_S2, X_S3, X_S5, J_XI2, J_XIETA2, J_ETA2 },
        ),
        (
            "motion_equations",
            "motion_equations",
            listed! { m: D_OMEGA_1, D_OMEGA_3 },
        ),
        (
            "motion_forces",
            "motion_forces",
            &[
                &s::M_D,
                &w::S_H,
                &w::F_R1X,
                &w::F_R1Y,
                &w::M_R1,
                &w::F_R2X,
                &w::F_R2Y,
                &w::M_R2,
                &w::F_R3X,
                &w::F_R3Y,
                &w::M_R3,
                &m::F_1X,
                &m::F_1Y,
                &m::F_2X,
                &m::F_2Y,
                &m::F_3X,
                &m::F_3Y,
                &m::J_XY1,
                &m::J_XY2,
                &m::J_XY3,
                &m::M_I1,
                &m::M_I3,
                &m::M_IB,
                &m::M_IC,
                &s::F_BX,
                &s::F_BY,
                &s::F_CX,
                &s::F_CY,
                &s::F_D,
                &s::F_O1X,
                &s::F_O1Y,
                &s::F_O3X,
                &s::F_O3Y,
                &s::N_3,
            ],
        ),
    ];

    const ASSEMBLED: &'static [&'static Symbol] = &[&m::J_2Q, &m::J_XI2, &m::J_XIETA2, &m::J_ETA2];

    const STAGES: &'static [&'static str] = &["moves", "pull", "standing", "acted", "forces", "hauling"];

    const DRIVE: Drawn = ("motion_moment", &s::M_D);

    const BODY: Drawn = ("motion_rocker", &s::N_3);

    const FORCES: &'static [&'static Symbol] = OUTLINE.forces;

    const AGREEMENT: &'static Symbol = &s::AGREEMENT;

    const APART: Option<Apart> = Some(apart);

    fn moves(this: &Luffing) -> Option<(Given<f64>, &Moving)> {
        let moving = this.moving.as_ref()?;
        let given = Given {
            inertias: Some(moving.inertias),
            ..LuffingScene::given(this)
        };
        Some((given, moving))
    }

    fn bore(this: &Luffing) -> Option<Bore<f64>> {
        this.driving.cylinder
    }
}

fn apart(model: &mut MovingComponent) -> Option<[f64; 2]> {
    carried::known::<DoubleLink>(model.parts().0).forces().ok()?.0.apart()
}
