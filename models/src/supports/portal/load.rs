//! Weight and moments under which the portal stands.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::parts::plane::Point;
use crate::supports::portal::symbols as s;
use crate::supports::portal::weights::StillMoment;

quantities! {
    /// Base and gauge of the portal.
    Base { a: A, b: B }
}

/// What slews, with its load: weight of all (N), and moment about the slewing axis (N·m).
#[derive(Clone, Copy, Debug)]
pub struct SlewingLoad<C> {
    pub force: C,
    pub moment: C,
}
results! { SlewingLoad as l => { V: l.force; M: l.moment; } }

impl<C: Calc> SlewingLoad<C> {
    /// V = V_0 + Q, M = M_u + Q R. [Ports001, 7.2]
    pub fn new(still: &StillMoment<C>, upper: &C, load: &One<C>, reach: &C) -> SlewingLoad<C> {
        SlewingLoad {
            force: (still.weight + **load).def(&s::V),
            moment: (*upper + **load * *reach).def(&s::M),
        }
    }
}

/// Moments on the portal about the axes along and across the rails, in N·m.
#[derive(Clone, Copy, Debug)]
pub struct PortalMoments<C> {
    pub x: C,
    pub y: C,
}
results! { PortalMoments as l => { M_X: l.x; M_Y: l.y; } }

impl<C: Calc> PortalMoments<C> {
    /// M_x = M_0x + M sin ψ, M_y = M_0y + M cos ψ. [Ports001, 7.2]
    pub fn new(still: &StillMoment<C>, slewing: &SlewingLoad<C>, heading: &Point<C>) -> PortalMoments<C> {
        PortalMoments {
            x: (still.moment.x + slewing.moment * heading.y).def(&s::M_X),
            y: (still.moment.y + slewing.moment * heading.x).def(&s::M_Y),
        }
    }
}
