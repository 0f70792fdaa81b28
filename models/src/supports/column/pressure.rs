//! Mean pressures in the bearings of a column.

use std::f64::consts::PI;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::supports::column::bearings::ColumnForces;
use crate::supports::column::symbols as s;
use crate::supports::upper::load::SupportLoad;

quantities! {
    /// Diameters and lengths of upper and foot bearing, diameters of the pivot.
    Bearings { d_u: D_U, b_u: B_U, d_f: D_F, b_f: B_F, d_p: D_P, d_i: D_I }
}

/// Of a case, in Pa.
#[derive(Clone, Copy, Debug)]
pub struct BearingPressure<C>([C; 3]);
results! { each BearingPressure as p => { P_U: p.0[0]; P_F: p.0[1]; P_P: p.0[2]; } }

impl<C: Calc> BearingPressure<C> {
    /// p_u = H_u/(D_u b_u), p_f = H_f/(D_f b_f), p_p = 4V/(π (D_p² − d_i²)).
    pub fn new(bearings: &Bearings<C>, load: &SupportLoad<C>, forces: &ColumnForces<C>) -> BearingPressure<C> {
        let pivot = C::constant(PI) * (bearings.d_p.square() - bearings.d_i.square());
        BearingPressure([
            (forces.upper / (bearings.d_u * bearings.b_u)).def(&s::P_U),
            (forces.foot / (bearings.d_f * bearings.b_f)).def(&s::P_F),
            (C::constant(4.0) * load.vertical / pivot).def(&s::P_P),
        ])
    }
}
