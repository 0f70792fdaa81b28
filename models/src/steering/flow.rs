//! Speed of the steering cylinders, and the oil that they take.

use crate::kernel::calc::{Among, Calc};
use crate::kernel::group::quantities;
use crate::parts::hydraulics::cylinder;
use crate::steering::cylinder::Pose;
use crate::steering::symbols as s;

quantities! {
    /// Bore and rod of a steering cylinder, in m.
    Piston { d_g: D_G, d: D }
}

/// Speed of a group's cylinder, in m/s, lengthening positive.
pub fn speed<C: Calc>(rate: &C, pose: &Pose<C>) -> C {
    (*rate * pose.od).def(&s::V_C)
}

/// Oil flow to a cylinder, in m³/s, at its speed (m/s); negative where it shortens.
pub fn flow<C: Calc>(piston: &Piston<C>, speed: &C) -> C {
    cylinder::flow([piston.d_g, piston.d], *speed, [&s::A_G, &s::Q_G])
}

/// Oil flow of all cylinders together, by amount.
pub fn total<C: Calc>(flows: &[C]) -> C {
    let sum = flows.iter().fold(C::constant(0.0), |sum, flow| sum + flow.abs());
    let one = C::known(&s::Q_G, flows[0].value()).abs();
    sum.among(Among::Sum, one).def(&s::Q_SUM)
}
