//! Speed of the steering cylinders, and the oil that they take.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::steering::cylinder::Pose;
use crate::steering::symbols as s;
use crate::steering::travel::Rate;

quantities! {
    /// Bore and rod of a steering cylinder, in m.
    Piston { d_g: D_G, d: D }
}

/// Speed of a group's cylinder, in m/s, lengthening positive.
#[derive(Clone, Copy, Debug)]
pub struct CylinderSpeed<C>(pub C);
results! { each CylinderSpeed as v => { V_C: v.0; } }

impl<C: Calc> CylinderSpeed<C> {
    pub fn new(rate: &Rate<C>, pose: &Pose<C>) -> CylinderSpeed<C> {
        CylinderSpeed((rate.0 * pose.od).def(&s::V_C))
    }
}

/// Oil flow to a cylinder, in m³/s, at its speed (m/s): on the bore where it
/// lengthens, on the annulus (negative) where it shortens.
pub fn flow<C: Calc>(piston: &Piston<C>, speed: C) -> C {
    let quarter = C::constant(std::f64::consts::FRAC_PI_4);
    let area = if speed.value() < 0.0 {
        quarter * (piston.d_g.square() - piston.d.square())
    } else {
        quarter * piston.d_g.square()
    };
    (area.def(&s::A_G) * speed).def(&s::Q_G)
}

/// Oil flow to a group's cylinder, in m³/s; negative where it shortens.
#[derive(Clone, Copy, Debug)]
pub struct CylinderFlow<C>(pub C);
results! { each CylinderFlow as q => { Q_G: q.0; } }

impl<C: Calc> CylinderFlow<C> {
    pub fn new(piston: &Piston<C>, stroke: &CylinderSpeed<C>) -> CylinderFlow<C> {
        CylinderFlow(flow(piston, stroke.0))
    }
}

/// Oil flow of all cylinders together, by amount.
#[derive(Clone, Copy, Debug)]
pub struct Total<C>(pub C);
results! { Total as q => { Q_SUM: q.0; } }

impl<C: Calc> Total<C> {
    pub fn new(flows: &[CylinderFlow<C>]) -> Total<C> {
        Total(flows.iter().fold(C::constant(0.0), |sum, flow| sum + flow.0.abs()))
    }
}
