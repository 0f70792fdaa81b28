//! What floats, with what slews and the load.

use crate::afloat::crane::{CraneWeights, HungPoint};
use crate::afloat::symbols as s;
use crate::afloat::weights::{CranePlace, DeadLoad, Weighed};
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;

/// With the load at its point of suspension (m): weight (N), moments (N·m), and how high its centre of gravity is (m).
#[derive(Clone, Copy, Debug)]
pub struct Loaded<C> {
    pub all: Weighed<C>,
    /// Without the load.
    pub bare: Weighed<C>,
    pub x: C,
    pub y: C,
    pub height: C,
}
results! { Loaded as l => { X_Q: l.x; Y_Q: l.y; W: l.all.weight; M_L: l.all.along; M_T: l.all.across; Z_G: l.height; } }

impl<C: Calc> Loaded<C> {
    /// x_Q = x_s + R cos ψ, y_Q = y_s + R sin ψ, W = W_0 + W_c + Q, M_L = M_L0 + M_Lc + Q x_Q, M_T = M_T0 + M_Tc + Q y_Q,
    /// z_G = (M_V0 + M_Vc + Q h_s) / W, with W_c of what slews where that weighs. [IS Code 2008, B 2.9]
    pub fn new(
        psi: &One<C>,
        dead: &DeadLoad<C>,
        place: &CranePlace<C>,
        hung: &HungPoint<C>,
        load: &One<C>,
        crane: Option<&CraneWeights<C>>,
    ) -> Loaded<C> {
        let (sin, cos) = psi.sin_cos();
        let (x, y) = (
            (place.x_s + hung.reach * cos).def(&s::X_Q),
            (place.y_s + hung.reach * sin).def(&s::Y_Q),
        );
        let bare = crane.map_or(dead.all, |crane| dead.all.and(&crane.all));
        let weight = (bare.weight + **load).def(&s::W);
        let along = (bare.along + **load * x).def(&s::M_L);
        let across = (bare.across + **load * y).def(&s::M_T);
        let up = bare.up + **load * hung.height;
        Loaded {
            all: Weighed {
                weight,
                along,
                across,
                up,
            },
            bare,
            x,
            y,
            height: (up / weight).def(&s::Z_G),
        }
    }
}
