//! Where the head of a crane on a hull is, and how heel, pitch and slewing move it.

use nalgebra::Vector3;

use crate::afloat::crane::HungPoint;
use crate::afloat::loaded::Loaded;
use crate::afloat::riding::RidingHull;
use crate::afloat::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;

/// The head from the hull's centre of gravity (m), and the reach along and across the hull (m).
#[derive(Clone, Copy, Debug)]
pub struct HeadPlace<C> {
    /// Horizontally forward and to the left, up.
    pub at: Vector3<C>,
    square: C,
    reach: [C; 2],
}
results! { HeadPlace as h => {
    XI: h.reach[0];
    ETA: h.reach[1];
    S_V: h.square;
    S_X: h.at.x;
    S_Y: h.at.y;
    S_Z: h.at.z;
} }

impl<C: Calc> HeadPlace<C> {
    /// s_y = cos φ (y_Q − y_G) + sin φ (h_s − z_G), s_v = cos φ (h_s − z_G) − sin φ (y_Q − y_G),
    /// s_x = cos θ (x_Q − x_G) + sin θ s_v, s_z = cos θ s_v − sin θ (x_Q − x_G); ξ = R cos ψ, η = R sin ψ.
    pub fn new(riding: &RidingHull<C>, loaded: &Loaded<C>, hung: &HungPoint<C>, psi: &One<C>) -> HeadPlace<C> {
        let ([x, y, z], (sin, cos), (steep, level)) = (riding.centre, riding.roll, riding.pitch);
        let (x, y, z) = (loaded.x - x, loaded.y - y, hung.height - z);
        let left = (cos * y + sin * z).def(&s::S_Y);
        let square = (cos * z - sin * y).def(&s::S_V);
        let at = Vector3::new(
            (level * x + steep * square).def(&s::S_X),
            left,
            (level * square - steep * x).def(&s::S_Z),
        );
        let (aside, ahead) = psi.sin_cos();
        let reach = [(hung.reach * ahead).def(&s::XI), (hung.reach * aside).def(&s::ETA)];
        HeadPlace { at, square, reach }
    }

    /// Its displacement for one radian of heel, of pitch, and of slewing.
    pub fn turned(&self, riding: &RidingHull<C>) -> [Vector3<C>; 3] {
        let ((sin, cos), (steep, level), [xi, eta]) = (riding.roll, riding.pitch, self.reach);
        let (at, zero) = (self.at, C::constant(0.0));
        [
            Vector3::new(-(steep * at.y), self.square, -(level * at.y)),
            Vector3::new(at.z, zero, -at.x),
            Vector3::new(
                -(level * eta) - steep * sin * xi,
                cos * xi,
                steep * eta - level * sin * xi,
            ),
        ]
    }

    /// Its acceleration (m/s²) while heel, pitch and slewing turn with their rates (rad/s), and slewing with an acceleration.
    pub fn carried(&self, riding: &RidingHull<C>, [p, q, r]: [C; 3], slewing: C) -> Vector3<C> {
        let ((sin, cos), (steep, level), [xi, eta]) = (riding.roll, riding.pitch, self.reach);
        let (at, zero, two) = (self.at, C::constant(0.0), C::constant(2.0));
        let [.., turned] = self.turned(riding);
        let rolled = Vector3::new(-(steep * self.square), -at.y, -(level * self.square)) * p.square();
        let pitched = Vector3::new(-at.x, zero, -at.z) * q.square();
        let slewed = Vector3::new(
            steep * sin * eta - level * xi,
            -(cos * eta),
            steep * xi + level * sin * eta,
        ) * r.square();
        let rolled_pitched = Vector3::new(-(level * at.y), zero, steep * at.y) * (two * p * q);
        let rolled_slewed = Vector3::new(-(steep * cos * xi), -(sin * xi), -(level * cos * xi)) * (two * p * r);
        let pitched_slewed = Vector3::new(turned.z, zero, -turned.x) * (two * q * r);
        let sum = rolled + pitched + slewed + rolled_pitched + rolled_slewed + pitched_slewed + turned * slewing;
        Vector3::new(sum.x.def(&s::C_X), sum.y.def(&s::C_Y), sum.z.def(&s::C_Z))
    }
}
