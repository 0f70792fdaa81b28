//! A tackle whose rope a drum on the frame winds. It pulls, and cannot push.

use crate::drive::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::symbol::Symbol;

quantities! {
    /// Falls between the anchors, radius (m) of the drum to the middle of its rope, and the efficiency of both.
    Tackle { m_r: M_R, r_tr: R_TR, eta_d: ETA_D }
}

impl<C: Calc> Tackle<C> {
    /// Lever arm of the drum for the force between the anchors, in m: r_tr / m_r. [Ports001, 5.1]
    pub fn arm(&self) -> C {
        self.r_tr / self.m_r
    }

    /// Pull of the rope at its drum, in N and by three names, under a force of the drive (push positive): S_l = −F_d / m_r
    /// without friction; while the tackle lengthens the drum gets η S_l, while it shortens it gives S_l / η. [Ports001, 5.1]
    pub fn pulls(&self, f_d: C, [pull, lengthening, shortening]: [&'static Symbol; 3]) -> [C; 3] {
        if !f_d.value().is_finite() {
            return [-f_d; 3];
        }
        let free = (-f_d / self.m_r).def(pull);
        let (less, more) = (free * self.eta_d, free / self.eta_d);
        let (out, back) = if free.value() < 0.0 { (more, less) } else { (less, more) };
        [free, out.def(lengthening), back.def(shortening)]
    }
}
