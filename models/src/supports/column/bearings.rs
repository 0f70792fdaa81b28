//! Forces on the bearings of a column.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::plane::{self, Point};
use crate::supports::column::symbols as s;
use crate::supports::upper::load::{SupportLoad, amount, most};

/// Of a case, in N.
#[derive(Clone, Copy, Debug)]
pub struct ColumnForces<C> {
    parts: Point<C>,
    pub upper: C,
    pub foot: C,
}
results! { each ColumnForces as f => { H_UL: f.parts.x; H_UT: f.parts.y; H_U: f.upper; H_F: f.foot; } }

impl<C: Calc> ColumnForces<C> {
    /// H_f = M/h_uf, against the moment's direction; H_ul = H_l + M_l/h_uf, H_ut = H_t + M_t/h_uf. [Ports001, 6.3.2]
    pub fn new(height: &One<C>, load: &SupportLoad<C>) -> ColumnForces<C> {
        let [moments, forces] = load.along;
        let parts = Point::new(forces.x + moments.x / **height, forces.y + moments.y / **height);
        let parts = plane::def(parts, [&s::H_UL, &s::H_UT]);
        ColumnForces {
            parts,
            upper: amount(parts).def(&s::H_U),
            foot: (load.moment / **height).def(&s::H_F),
        }
    }
}

/// The greatest of all cases.
#[derive(Clone, Copy, Debug)]
pub struct WorstBearings<C>([C; 2]);
results! { WorstBearings as w => { H_U_ALL: w.0[0]; H_F_ALL: w.0[1]; } }

impl<C: Calc> WorstBearings<C> {
    /// max H_u, max H_f.
    pub fn new(forces: &[ColumnForces<C>]) -> WorstBearings<C> {
        WorstBearings([
            most(forces.iter().map(|force| force.upper)).tabled(&s::H_U_ALL),
            most(forces.iter().map(|force| force.foot)).tabled(&s::H_F_ALL),
        ])
    }
}
