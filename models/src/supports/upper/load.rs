//! Vertical and horizontal force and moment on a slewing support in each load case, over the slewing angle.

use crate::component::stages::{absent, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::parts::plane::{self, Point};
use crate::supports::upper::symbols as s;
use crate::supports::upper::weights::{UpperSlope, UpperWorks};

quantities! {
    /// A load case: how the load counts, pressure and direction of the wind.
    SupportCase { k_q: K_Q, p_w: P_W, chi_w: CHI_W }
}

/// Loads of a case: forces in N, moments in N·m, vectors along the boom and to the left of it.
#[derive(Clone, Copy, Debug)]
pub struct SupportLoad<C> {
    pub load: C,
    weight: C,
    upright: C,
    leaning: Option<C>,
    wind: Option<[C; 3]>,
    /// Moment and horizontal force, along the boom and to the left of it.
    pub along: [Point<C>; 2],
    pub vertical: C,
    pub horizontal: C,
    pub moment: C,
}
results! { each SupportLoad as l => {
    V: l.vertical;
    H: l.horizontal;
    M: l.moment;
    Q_C: l.load;
    G_S: l.weight;
    M_V: l.upright;
    M_GAMMA: l.leaning.ok_or_else(absent)?;
    BETA_W: l.wind.ok_or_else(absent)?[0];
    F_W: l.wind.ok_or_else(absent)?[1];
    M_W: l.wind.ok_or_else(absent)?[2];
    M_L: l.along[0].x;
    M_T: l.along[0].y;
    H_L: l.along[1].x;
    H_T: l.along[1].y;
} }

/// Length of a vector: of one along an axis its amount, whose derivative exists.
pub fn amount<C: Calc>(of: Point<C>) -> C {
    match [of.x.value() == 0.0, of.y.value() == 0.0] {
        [_, true] => of.x.abs().over(of.y),
        [true, false] => of.y.abs().over(of.x),
        _ => plane::length(of),
    }
}

impl<C: Calc> SupportLoad<C> {
    /// V = G cos γ, M_l = M_v + M_γ cos ψ + M_w cos β, M_t = M_w sin β − M_γ sin ψ with M_v = (M_u + Q R) cos γ,
    /// M_γ = (S_u + Q h_Q) sin γ, M_w = p_w S_w and β = χ_w − ψ; H likewise of G sin γ and p_w A_w. [Ports001, 6.1]
    pub fn new(
        psi: &One<C>,
        reach: &C,
        load: &One<C>,
        slope: &Option<UpperSlope<C>>,
        upper: &UpperWorks<C>,
        case: &SupportCase<C>,
    ) -> SupportLoad<C> {
        let zero = Point::new(C::constant(0.0), C::constant(0.0));
        let load = (case.k_q * **load).def(&s::Q_C);
        let weight = (upper.weight + load).def(&s::G_S);
        let moment = upper.moment + load * *reach;
        let (mut vertical, mut upright, mut leaning, mut down) = (weight, moment, None, [zero; 2]);
        if let Some((slope, [high, hung])) = slope.as_ref().zip(upper.high) {
            let (sin, cos) = slope.gamma.sin_cos();
            (vertical, upright) = (weight * cos, moment * cos);
            let tilted = ((high + load * hung) * sin).def(&s::M_GAMMA);
            leaning = Some(tilted);
            let (across, ahead) = psi.sin_cos();
            let way = Point::new(ahead, -across);
            down = [way * tilted, way * (weight * sin)];
        }
        let upright = upright.def(&s::M_V);
        let blown = upper.areas.map(|[area, high]| {
            let beta = (case.chi_w - **psi).def(&s::BETA_W);
            let wind = [case.p_w * area, case.p_w * high];
            (beta, wind[0].def(&s::F_W), wind[1].def(&s::M_W))
        });
        let wind = blown.map_or([zero; 2], |(beta, force, moment)| {
            let (sin, cos) = beta.sin_cos();
            let way = Point::new(cos, sin);
            [way * moment, way * force]
        });
        let moments = Point::new(upright, C::constant(0.0)) + down[0] + wind[0];
        let moments = plane::def(moments, [&s::M_L, &s::M_T]);
        let forces = plane::def(down[1] + wind[1], [&s::H_L, &s::H_T]);
        SupportLoad {
            load,
            weight,
            upright,
            leaning,
            wind: blown.map(|(beta, force, moment)| [beta, force, moment]),
            along: [moments, forces],
            vertical: vertical.def(&s::V),
            horizontal: amount(forces).def(&s::H),
            moment: amount(moments).def(&s::M),
        }
    }
}

impl<C: Calc> SupportLoad<C> {
    /// Direction to which the wind blows, from that of the boom, in rad.
    pub fn to(&self) -> Option<C> {
        self.wind.map(|wind| wind[0])
    }
}

/// The greatest of all cases.
#[derive(Clone, Copy, Debug)]
pub struct WorstLoad<C> {
    pub moment: C,
    horizontal: C,
}
results! { WorstLoad as w => { M_ALL: w.moment; H_ALL: w.horizontal; } }

impl<C: Calc> WorstLoad<C> {
    /// max M, max H.
    pub fn new(loads: &[SupportLoad<C>]) -> WorstLoad<C> {
        WorstLoad {
            moment: most(loads.iter().map(|load| load.moment)).tabled(&s::M_ALL),
            horizontal: most(loads.iter().map(|load| load.horizontal)).tabled(&s::H_ALL),
        }
    }
}

/// The greatest of all cases, of which there is one at least.
pub fn most<C: Calc>(of: impl Iterator<Item = C>) -> C {
    of.reduce(C::greater).expect("one case at least")
}
