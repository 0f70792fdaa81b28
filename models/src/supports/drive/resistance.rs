//! What resists slewing in a case, over the slewing angle: friction, wind, slope, sway and inertia.

use crate::component::stages::{absent, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::starts::RatedPoint;
use crate::supports::drive::gear::TurningDrive;
use crate::supports::drive::given::TurningCase;
use crate::supports::drive::inertia::{Outswing, TurnedWorks};
use crate::supports::drive::symbols as s;
use crate::supports::upper::load::{SupportCase, SupportLoad};
use crate::supports::upper::weights::{UpperSlope, UpperWorks};

/// About the slewing axis, in N·m and kg·m²; moments of slope and wind positive counter-clockwise, seen from above.
#[derive(Clone, Copy, Debug)]
pub struct TurningMoments<C> {
    carried: C,
    pub inertia: C,
    slope: Option<C>,
    wind: Option<C>,
    pub outer: C,
    pub sway: C,
    pub friction: C,
    pub steady: C,
}
results! { each TurningMoments as t => {
    J_QC: t.carried;
    J_C: t.inertia;
    M_GZ: t.slope.ok_or_else(absent)?;
    M_WZ: t.wind.ok_or_else(absent)?;
    M_Z: t.outer;
    M_AQ: t.sway;
    M_ST: t.steady;
} }

impl<C: Calc> TurningMoments<C> {
    /// M_γz = −(M_u + Q R) sin γ sin ψ, M_wz = p_w S_r sin β, M_α = Q R tan α or else J_Q = Q R²/g, and
    /// M_st = M_f + M_α + |M_γz + M_wz|. [Ports001, 6.5.1]
    #[expect(clippy::too_many_arguments, reason = "all that acts about one axis")]
    pub fn new(
        psi: &One<C>,
        reach: &C,
        gravity: &One<C>,
        slope: &Option<UpperSlope<C>>,
        upper: &UpperWorks<C>,
        turned: &TurnedWorks<C>,
        case: &SupportCase<C>,
        load: &SupportLoad<C>,
        work: &TurningCase<C>,
        swung: &Outswing<C>,
        friction: &C,
    ) -> TurningMoments<C> {
        let zero = C::constant(0.0);
        let own = slope.as_ref().map(|slope| {
            let (steep, aside) = (slope.gamma.sin(), psi.sin());
            (-((upper.moment + load.load * *reach) * steep * aside)).def(&s::M_GZ)
        });
        let wind = turned.areas.zip(load.to()).map(|(areas, to)| {
            let aside = to.sin();
            (case.p_w * areas * aside).def(&s::M_WZ)
        });
        let outer = match (own, wind) {
            (Some(own), Some(wind)) => own + wind,
            (own, wind) => own.or(wind).unwrap_or(zero),
        };
        let outer = outer.def(&s::M_Z);
        let (sin, cos) = work.alpha.sin_cos();
        let sway = (load.load * swung.reach.abs() * sin / cos).def(&s::M_AQ);
        let carried = if work.alpha.value() > 0.0 {
            zero.over(sway)
        } else {
            (load.load / **gravity * swung.reach.square()).def(&s::J_QC)
        };
        TurningMoments {
            carried,
            inertia: (turned.inertia + carried).def(&s::J_C),
            slope: own,
            wind,
            outer,
            sway,
            friction: *friction,
            steady: (*friction + sway + outer.abs()).def(&s::M_ST),
        }
    }
}

impl<C: Calc> TurningMoments<C> {
    /// What resists besides slope and wind, in a stop less the sway of the load.
    pub fn inner(&self, stops: bool) -> C {
        if stops {
            self.friction - self.sway
        } else {
            self.friction + self.sway
        }
    }
}

impl<C: Calc> TurningDrive<C> {
    /// Torque at each motor's shaft for a moment about the axis, which resists where it is positive: losses then cost, and
    /// help where it drives. [Ports001, 6.5.2]
    pub fn torque(&self, moment: C) -> C {
        let free = moment / (self.i * self.z);
        if moment.value() > 0.0 {
            free / self.eta
        } else {
            free * self.eta
        }
    }

    /// Rated torque, in N·m.
    pub fn rated(&self) -> C {
        RatedPoint::new(self.p_n, self.n_n).torque
    }
}
