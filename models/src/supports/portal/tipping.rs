//! Safety against tipping about each edge of the portal.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::plane::Point;
use crate::parts::safety::safety;
use crate::supports::portal::corners::{CORNERS, all, signed};
use crate::supports::portal::load::Base;
use crate::supports::portal::symbols as s;
use crate::supports::portal::weights::StillMoment;

/// What holds and what tips the crane about an edge, in N·m.
#[derive(Clone, Copy, Debug)]
pub struct Edge<C> {
    pub holds: C,
    tips: C,
    safety: C,
    /// Distance of the edge from that across, in m.
    pub width: C,
}
results! { each Edge as e => { M_ST: e.holds; M_OV: e.tips; K: e.safety; } }

/// K = M_s / M_o, where M_s = V_0 a/2 − M_py − M_u cos ψ and M_o = Q (R cos ψ − a/2) + M_wy about the edge in front, and so
/// about the others. [Ports001, 7.1.4]
pub fn edges<C: Calc>(
    base: &Base<C>,
    still: &StillMoment<C>,
    upper: &C,
    load: &One<C>,
    reach: &C,
    heading: &Point<C>,
    room: &mut Vec<Edge<C>>,
) {
    all::<C, Edge<C>>(room, |at, corner| {
        // From a corner in front to one behind it goes along a rail.
        let rail = corner.front != CORNERS[(at + 1) % CORNERS.len()].front;
        let (width, own, wind, heading, out) = if rail {
            (base.b, still.portal.x, still.wind().x, heading.y, corner.left)
        } else {
            (base.a, still.portal.y, still.wind().y, heading.x, corner.front)
        };
        let half = width / C::constant(2.0);
        let holds = signed(signed(still.weight * half, own, !out), *upper * heading, !out).def(&s::M_ST);
        let arm = signed(C::constant(0.0), *reach * heading, out) - half;
        let tips = signed(**load * arm, wind, out).def(&s::M_OV);
        Edge {
            holds,
            tips,
            safety: safety(holds, tips, &s::K),
            width,
        }
    });
}
