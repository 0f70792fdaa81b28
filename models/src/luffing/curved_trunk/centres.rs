//! Centres of gravity of boom and trunk while these move. (derived)

use crate::kernel::calc::Calc;
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::velocity::{TrunkBend, TrunkTravel};
use crate::parts::plane::{self, Point};

/// Centres of gravity of boom, from its foot, and trunk, from B, in m; and what they move by for one radian of the boom's
/// angle, once and once more.
pub struct TrunkCentres<C> {
    pub boom: [Point<C>; 3],
    pub trunk: [Point<C>; 3],
}

impl<C: Calc> TrunkCentres<C> {
    /// Of their places in boom and trunk, in m.
    pub fn new(
        [boom, trunk]: [Point<C>; 2],
        (phi, position): (C, &TrunkPosition<C>),
        (travel, bend): (&TrunkTravel<C>, &TrunkBend<C>),
    ) -> TrunkCentres<C> {
        let (sin, cos) = phi.sin_cos();
        let s_b = plane::def(plane::turned(boom, cos, sin), [&s::S_BX, &s::S_BY]);
        let ds_b = plane::def(Point::new(-s_b.y, s_b.x), [&s::DS_BX, &s::DS_BY]);
        let s_m = plane::turned(position.along, trunk.x, trunk.y);
        let s_m = plane::def(s_m, [&s::S_MX, &s::S_MY]);
        let ds_m = plane::def(travel.of_point(position, s_m), [&s::DS_MX, &s::DS_MY]);
        let dds_m = bend.of_point(position, travel, s_m);
        TrunkCentres {
            boom: [s_b, ds_b, -s_b],
            trunk: [s_m, ds_m, plane::def(dds_m, [&s::DDS_MX, &s::DDS_MY])],
        }
    }
}
