//! A slope under a crane that luffs and slews: what its weights come to on both joints, and gravity in the frame that slews.

use nalgebra::Vector3;

use crate::kernel::calc::Calc;
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::reduced::Reduced;
use crate::luffing::moving::symbols as s;
use crate::luffing::moving::weather::Pushed;
use crate::parts::plane::Point;
use crate::parts::slope::{SlopingGround, gravity};

/// A moment of wind or slope: on the bodies in their plane, at the driving link; of a slope under a crane that slews, at the
/// driving link and about the slewing axis. And that of centrifugal forces of a crane that is slewed, at the driving link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outer {
    Wind,
    Slope,
    Lifting,
    Turning,
    Centrifugal,
}

impl<P: Calc> Dynamics<P> {
    fn ground_below<C: Coordinate<P>>(&self) -> Option<SlopingGround<C>> {
        self.slope().map(|slope| slope.map(&mut |_, of| C::of(of)))
    }

    /// Gravity at a slewing angle (rad), in the frame that slews, in m/s².
    pub(crate) fn gravity_at<C: Coordinate<P>>(&self, psi: C) -> Vector3<C> {
        gravity(self.ground_below().as_ref(), C::of(self.gravity()), psi)
    }

    /// Gravity upright to the ground, in m/s².
    pub(crate) fn upright<C: Coordinate<P>>(&self) -> C {
        let gravity = C::of(self.gravity());
        match (self.slope(), self.weather()) {
            (Some(slope), _) => gravity * C::of(slope.gamma_s).sin_cos().1,
            (None, Some(outdoors)) => gravity - C::of(outdoors.lean.y),
            (None, None) => gravity,
        }
    }

    /// Moments of the slope on luffing and on slewing (N·m) at a slewing angle (rad), where there is one:
    /// M_γl = W_Gx sin γ cos ψ + W_Gy (1 − cos γ), as gravity leans forward and lacks upright, and
    /// M_γ = −(G_u r_u + W_sx) sin γ sin ψ. [virtual work; Ports001, 6.4]
    pub(crate) fn leaned<C: Coordinate<P>>(&self, r: &Reduced<C>, psi: C) -> Option<[C; 2]> {
        let (slope, weighed) = self.ground_below::<C>().zip(r.weighed)?;
        let ((steep, level), (_, ahead)) = (slope.gamma_s.sin_cos(), psi.sin_cos());
        let travel = weighed.travel;
        let lifts = travel.x * steep * ahead + travel.y * (C::constant(1.0) - level);
        let turns = slope.across(slope.g_u * slope.r_u + weighed.forward, psi);
        Some([lifts.def(&s::M_GAMMA_L), turns.def(&s::M_GAMMA)])
    }

    /// Such a moment (N·m) at a coordinate and, of a crane that slews, at an angle of that (rad), nothing where it does not act;
    /// `None` where the mechanism does not close.
    pub(crate) fn outer(&self, at: P, psi: Option<P>, which: Outer) -> Option<P>
    where
        P: Coordinate<P>,
    {
        let r = P::reduced(self, at)?;
        let leaned = || psi.and_then(|psi| self.leaned(&r, psi));
        let found = match which {
            Outer::Wind => r.outside.map(|[wind, ..]| wind),
            Outer::Slope => r.outside.map(|[_, slope, _]| slope),
            Outer::Centrifugal => r.outside.map(|[.., moment]| moment),
            Outer::Lifting => leaned().map(|[lifts, _]| lifts),
            Outer::Turning => leaned().map(|[_, turns]| turns),
        };
        Some(found.unwrap_or(P::constant(0.0)))
    }

    /// What acts on the bodies one by one at a coordinate and, of a crane that slews, at an angle of that (rad): wind and slope;
    /// `None` where the mechanism does not close.
    pub(crate) fn pushed(&self, at: P, psi: Option<P>) -> Option<Option<Pushed<P>>>
    where
        P: Coordinate<P>,
    {
        let mut found = match self.weather() {
            Some(outdoors) => Some(outdoors.pushed(at)?),
            None => None,
        };
        if let Some(psi) = psi.filter(|_| self.slope().is_some()) {
            let now = self.gravity_at(psi);
            found = Some(Pushed {
                lean: Point::new(now.x.def(&s::A_GAMMA_X), self.gravity() + now.y),
                gravity: (-now.y).def(&s::G_GAMMA),
                wind: found.and_then(|pushed| pushed.wind),
            });
        }
        Some(found)
    }
}

impl Dynamics {
    /// Potential energy of the bodies that a slope makes of what they have on level ground (J), at a slewing angle (rad).
    pub(crate) fn leaned_energy(&self, r: &Reduced<f64>, psi: f64) -> f64 {
        let Some((slope, weighed)) = self.slope().zip(r.weighed) else {
            return 0.0;
        };
        let ((steep, level), (_, ahead)) = (Calc::sin_cos(slope.gamma_s), Calc::sin_cos(psi));
        -(slope.g_u * slope.r_u + weighed.forward) * steep * ahead - weighed.energy * (1.0 - level)
    }
}
