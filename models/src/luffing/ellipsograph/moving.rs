//! Boom and link in motion: what they are to the equations of motion, in closed form.

use num_dual::Dual64;

use crate::balance::scene::Form;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::luffing::ellipsograph::balancing::OnLink;
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice};
use crate::luffing::ellipsograph::statics::GuidedWeights;
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::moving::bodies::{Body, MovedBody, Moves};
use crate::luffing::moving::reduced::{Asked, CoordinateNames, Reduced, Reduces};
use crate::luffing::moving::symbols::{self as m, OfSums};
use crate::luffing::moving::weighed::{MovedBalance, Weighing};
use crate::parts::plane::{self, Point};

quantities! {
    /// Inertias of boom and link.
    GuidedInertias { j_b: J_B, j_l: J_L }
}

/// Names of what is summed for boom and link.
static OF_BODY: [OfSums; 2] = [
    OfSums {
        mass: &s::MASS_B,
        inertia: &s::I_RB,
        slope: &s::DI_RB,
    },
    OfSums {
        mass: &s::MASS_L,
        inertia: &s::I_RL,
        slope: &s::DI_RL,
    },
];

/// Boom and link with what they weigh.
#[derive(Clone)]
pub struct HeavyGuide<P: Calc> {
    bars: Bars<P>,
    /// Of boom, from its foot, and link, from its pivot.
    bodies: [Body<P>; 2],
    gravity: P,
    balance: Option<MovedBalance<OnLink, P>>,
}

impl<P: Calc> HeavyGuide<P>
where
    Dual64: Over<P>,
{
    /// With the mass (kg) of a load that is fixed to the head, where it hangs on no rope, under gravity (m/s²).
    ///
    /// # Errors
    /// Quantities with which there is no such balance.
    pub fn new(
        bars: &Bars<P>,
        weights: &GuidedWeights<P>,
        inertias: &GuidedInertias<P>,
        form: &Option<Form<P>>,
        choice: &GuidedChoice,
        fixed: Option<P>,
        gravity: P,
    ) -> Result<HeavyGuide<P>, OutOfRange> {
        let line = Point::new(P::constant(1.0), P::constant(0.0));
        let (sin, cos) = weights.chi_b.sin_cos();
        let centre = Point::new(weights.r_b * cos, weights.r_b * sin);
        let mut boom = Body::slender(weights.g_b / gravity, inertias.j_b, centre, line);
        if let Some(load) = fixed {
            boom = boom.with_mass(load, line * (bars.c + bars.a));
            boom.inertia = boom.inertia.def(&s::J_BQ);
        }
        let link = Body::slender(weights.g_l / gravity, inertias.j_l, line * weights.r_l, line);
        let balance = form.map(|form| MovedBalance::new(&(*bars, *weights), form, choice, gravity));
        Ok(HeavyGuide {
            bars: *bars,
            bodies: [boom, link],
            gravity,
            balance: balance.transpose()?,
        })
    }

    /// At an angle of the boom (rad), the counterweight by its mass (kg) and place (m). Foot and head are c + a and 2c from
    /// the level and the upright through O1, so that of every point x″ = −x and y″ = −y.
    fn at<C: Over<P>>(&self, phi: C, counterweight: Option<(C, [Point<C>; 3])>) -> Reduced<C> {
        let (sin, cos) = phi.sin_cos();
        let zero = C::constant(0.0);
        let foot = C::constant(2.0) * C::of(self.bars.c);
        let [boom, link] = self.bodies.map(|body| body.centre.map(C::of));
        let s = plane::def(
            Point::new(boom.x * cos - boom.y * sin, boom.x * sin + boom.y * cos - foot * sin),
            [&s::S_MX, &s::S_MY],
        );
        let ds = plane::def(
            Point::new(-(boom.x * sin) - boom.y * cos, boom.x * cos - boom.y * sin - foot * cos),
            [&s::DS_MX, &s::DS_MY],
        );
        let l = Point::new(link.x * cos, -(link.x * sin));
        let dl = plane::def(Point::new(-(link.x * sin), -(link.x * cos)), [&s::DS_LX, &s::DS_LY]);
        let axes = [
            C::of(self.bars.c) + C::of(self.bars.a),
            C::of(self.bars.a) - C::of(self.bars.c),
        ];
        let head = Point::new(axes[0] * cos, axes[1] * sin);
        let travel = plane::def(Point::new(-(axes[0] * sin), axes[1] * cos), [&s::DA_X, &s::DA_Y]);
        let bend = plane::def(-head, [&m::DDA_X, &m::DDA_Y]);
        let turn = [C::constant(1.0), zero];
        let moves = Moves {
            bodies: [
                MovedBody {
                    centre: [s, ds, -s],
                    turn,
                },
                MovedBody {
                    centre: [l, dl, -l],
                    turn,
                },
            ],
            counterweight,
            head: [head, travel, bend],
            drive: [zero; 2],
            turn: [zero; 2],
            lead: None,
        };
        let names = OF_BODY.each_ref();
        Reduced::of(self.bodies.each_ref(), names, self.gravity, moves)
    }
}

impl<P: Weighing<P> + Send + Sync> Reduces<P> for HeavyGuide<P>
where
    Dual64: Over<P>,
{
    fn reduced(&self, phi: P, _: &Asked<P>) -> Option<Reduced<P>> {
        let weight = self.balance.as_ref().map(|balance| P::weighed(balance, phi));
        Some(self.at(phi, weight.map_or(Some(None), |found| found.map(Some))?))
    }

    fn with_slope(&self, phi: Dual64, _: &Asked<P>) -> Option<Reduced<Dual64>> {
        let weight = self.balance.as_ref().map(|balance| balance.with_slope(phi));
        Some(self.at(phi, weight.map_or(Some(None), |found| found.map(Some))?))
    }

    fn names(&self) -> CoordinateNames {
        CoordinateNames {
            acceleration: &s::D_OMEGA,
            stops: [&s::FROM, &s::TO],
        }
    }
}
