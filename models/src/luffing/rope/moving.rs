//! The boom in motion: what boom and load are to the equations of motion, in closed form, and the pull of the tackle.

use num_dual::Dual64;

use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::luffing::moving::bodies::{Body, MovedBody, Moves};
use crate::luffing::moving::reduced::{Asked, CoordinateNames, Reduced, Reduces};
use crate::luffing::moving::symbols::{self as m, OfSums};
use crate::luffing::moving::weighed::{MovedBalance, Weighing};
use crate::luffing::rope::balancing::OnBoom;
use crate::luffing::rope::position::{Compensation, Falls, Rig};
use crate::luffing::rope::symbols as s;
use crate::parts::plane::{self, Point};

quantities! {
    /// Inertia of the boom.
    BoomInertia { j_b: J_B }
}

/// Names of what is summed for boom and load.
static OF_BODY: [OfSums; 2] = [
    OfSums {
        mass: &s::MASS_B,
        inertia: &s::I_RB,
        slope: &s::DI_RB,
    },
    OfSums {
        mass: &m::MASS_Q,
        inertia: &s::I_RQ,
        slope: &s::DI_RQ,
    },
];

/// The boom with what it weighs and carries.
#[derive(Clone)]
pub struct HeavyBoom<P: Calc> {
    pub rig: Rig<P>,
    pub parts: Option<Compensation<P>>,
    /// From its foot.
    pub boom: Body<P>,
    /// A load that hangs straight below the head at any time.
    pub load: Option<Body<P>>,
    pub balance: Option<MovedBalance<OnBoom, P>>,
    /// In m/s².
    pub gravity: P,
}

impl<P: Calc> HeavyBoom<P> {
    /// Of the hoist rope in all its parts between head and sheave, over the falls of its tackle: length, lever arm and how
    /// that changes with the boom's angle, in m; `None` where they meet.
    /// |A − B|′ = −h_S, h_S′ = (h_S² − A · B) / |A − B|.
    fn led<C: Over<P>>(&self, head: Point<C>) -> Option<[C; 3]> {
        let b = Point::new(C::of(self.rig.b_x), C::of(self.rig.b_y));
        let length = plane::length(b - head).def(&s::L_S);
        if length.value() == 0.0 {
            return None;
        }
        let falls = C::of(self.rig.m_h);
        let part = self.parts.map_or(C::constant(1.0), |parts| C::of(parts.m_k)) / falls;
        let arm = (plane::cross(head, b) / length).def(&s::H_S);
        let change = ((arm.square() - plane::dot(head, b)) / length).def(&s::DH_S);
        Some([
            part * length,
            (part * arm).def(&s::DL_R),
            (part * change).def(&s::DDL_R),
        ])
    }

    /// At an angle of the boom (rad), the counterweight by its mass (kg) and place (m); `None` where the head is at the
    /// sheave. What turns about the foot has x″ = −x, y″ = −y.
    fn at<C: Over<P>>(&self, phi: C, counterweight: Option<(C, [Point<C>; 3])>) -> Option<Reduced<C>> {
        let (sin, cos) = phi.sin_cos();
        let (zero, one) = (C::constant(0.0), C::constant(1.0));
        let place = |x: P, y: P| Point::new(C::of(x) * cos - C::of(y) * sin, C::of(x) * sin + C::of(y) * cos);
        let turned = |p: Point<C>| Point::new(-p.y, p.x);
        let centre = plane::def(place(self.boom.centre.x, self.boom.centre.y), [&s::S_BX, &s::S_BY]);
        let head = plane::def(place(self.rig.l, self.rig.f_a), [&s::A_X, &s::A_Y]);
        let travel = plane::def(turned(head), [&s::DA_X, &s::DA_Y]);
        let [length, arm, change] = self.led(head)?;
        let boom = MovedBody {
            centre: [centre, turned(centre), -centre],
            turn: [one, zero],
        };
        let Some(load) = &self.load else {
            let bend = plane::def(-head, [&m::DDA_X, &m::DDA_Y]);
            let moves = Moves {
                bodies: [boom],
                counterweight,
                head: [head, travel, bend],
                drive: [zero; 2],
                turn: [zero; 2],
                lead: Some([arm, change]),
            };
            return Some(Reduced::of([&self.boom], [&OF_BODY[0]], self.gravity, moves));
        };
        let hanging = MovedBody {
            centre: [
                Point::new(head.x, head.y + length),
                Point::new(travel.x, (travel.y - arm).def(&s::DY_Q)),
                Point::new(-head.x, (-head.y - change).def(&s::DDY_Q)),
            ],
            turn: [zero; 2],
        };
        let moves = Moves {
            bodies: [boom, hanging],
            counterweight,
            head: [head, travel, -head],
            drive: [zero; 2],
            turn: [zero; 2],
            lead: None,
        };
        let names = OF_BODY.each_ref();
        Some(Reduced::of([&self.boom, load], names, self.gravity, moves))
    }
}

impl<P: Weighing<P> + Send + Sync> Reduces<P> for HeavyBoom<P>
where
    Dual64: Over<P>,
{
    fn reduced(&self, phi: P, _: &Asked<P>) -> Option<Reduced<P>> {
        let weight = self.balance.as_ref().map(|balance| P::weighed(balance, phi));
        self.at(phi, weight.map_or(Some(None), |found| found.map(Some))?)
    }

    fn with_slope(&self, phi: Dual64, _: &Asked<P>) -> Option<Reduced<Dual64>> {
        let weight = self.balance.as_ref().map(|balance| balance.with_slope(phi));
        self.at(phi, weight.map_or(Some(None), |found| found.map(Some))?)
    }

    fn names(&self) -> CoordinateNames {
        CoordinateNames {
            acceleration: &s::D_OMEGA,
            stops: [&s::FROM, &s::TO],
        }
    }

    fn is_pulled(&self) -> bool {
        true
    }
}

/// Pull of the luffing tackle in motion, in N, that gives the boom a moment (N·m).
pub fn pull<C: Calc>(moment: &C, falls: &Falls<C>) -> C {
    (*moment / falls.line.arm).def(&s::T_DYN)
}
