//! Friction moment of the three bearings of a column.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::supports::column::bearings::ColumnForces;
use crate::supports::column::pressure::Bearings;
use crate::supports::column::symbols as s;
use crate::supports::drive::given::GivenDrive;
use crate::supports::drive::symbols::M_FS;
use crate::supports::upper::load::SupportLoad;

quantities! {
    /// Coefficients of upper bearing, foot bearing and pivot.
    ColumnFriction { mu_u: MU_U, mu_f: MU_F, mu_p: MU_P }
}

/// R_p = (D_p² + D_p d_i + d_i²) / (3 (D_p + d_i)) of a pivot that is pressed evenly: 2/3 (R³ − r³)/(R² − r²), in m.
/// [Ports001, 6.3.2]
pub fn pivot_radius<C: Calc>(bearings: &Bearings<C>, _: &ColumnFriction<C>) -> C {
    let (outer, inner) = (bearings.d_p, bearings.d_i);
    let squares = outer.square() + outer * inner + inner.square();
    (squares / (C::constant(3.0) * (outer + inner))).def(&s::R_P)
}

/// Friction moments of a case, in N·m.
#[derive(Clone, Copy, Debug)]
pub struct ColumnTurning<C> {
    parts: [C; 3],
    sum: C,
}
results! { each ColumnTurning as t => {
    M_FB: t.sum;
    M_FU: t.parts[0];
    M_FF: t.parts[1];
    M_FP: t.parts[2];
} }

impl<C: Calc> ColumnTurning<C> {
    /// M_fb = μ_u H_u D_u/2 + μ_f H_f D_f/2 + μ_p V R_p. [Ports001, 6.3.2]
    pub fn new(
        bearings: &Bearings<C>,
        friction: &ColumnFriction<C>,
        pivot: &C,
        load: &SupportLoad<C>,
        forces: &ColumnForces<C>,
    ) -> ColumnTurning<C> {
        let two = C::constant(2.0);
        let parts = [
            (friction.mu_u * forces.upper * (bearings.d_u / two)).def(&s::M_FU),
            (friction.mu_f * forces.foot * (bearings.d_f / two)).def(&s::M_FF),
            (friction.mu_p * load.vertical * *pivot).def(&s::M_FP),
        ];
        ColumnTurning {
            parts,
            sum: (parts[0] + parts[1] + parts[2]).def(&s::M_FB),
        }
    }
}

/// What the drive overcomes of them, in N·m.
pub fn rubbing<C: Calc>(_: &GivenDrive<C>, turning: &ColumnTurning<C>) -> C {
    turning.sum.def(&M_FS)
}
