//! The eight moments that a drive finds unbalanced, as the publication has them: by the ratios of angular velocities, half of
//! the rocker, which is a tie there, at the jib's tail. Beside them stand those of the bodies as they are.
//!
//! The contents of the publication name the eight and tell that half the tie's weight counts; the text of their pages was not
//! at hand. That half of its wind counts likewise is taken from that, and the forms are derived.
//!
//! Moments are for one radian of the luffing angle, positive where they raise the boom.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::double_link::parameters::Weights;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::statics::Own;
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::velocity::Velocity;
use crate::luffing::resistances::given::{Case, CaseBody, CasesChoice};
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::placed::MovedBars;
use crate::luffing::resistances::sums::{BodySums, swept};
use crate::parts::plane::{Point, turned};

/// Places of the bars among the bodies.
const BOOM: usize = 0;
const TRUNK: usize = 1;
const TIE: usize = 2;

/// Angular velocities of boom, jib and rocker for one radian of the luffing angle.
fn ratios<C: Calc>(p: &Position<C>, v: &Velocity<C>) -> [C; 3] {
    let (boom, rocker) = v.of_feet(p);
    [boom, v.i_2, rocker]
}

/// What is the same in all cases.
#[derive(Clone, Copy, Debug)]
pub struct Unbalanced<C> {
    tie: C,
    trunk: C,
    boom: C,
    exact: [C; 3],
    /// Travel of the head, in m.
    travel: Point<C>,
    i: [C; 3],
    /// Jib's head on the boom, and its tail from the rocker's foot, in m.
    head: Point<C>,
    tail: Point<C>,
    /// Areas of a bar (m²), and these times the heights of their centres above its first joint (m³); and of each times the
    /// travel of their centres.
    boom_height: C,
    trunk_areas: [C; 2],
    tie_area: C,
    swept: [C; 3],
}
results! { Unbalanced as u => {
    M_U_TIE: u.tie;
    M_U_TRUNK: u.trunk;
    M_U_BOOM: u.boom;
    M_X_TIE: u.exact[TIE];
    M_X_TRUNK: u.exact[TRUNK];
    M_X_BOOM: u.exact[BOOM];
    E_Q: u.travel.y;
    W_UL: u.tie_area;
    W_UX: u.trunk_areas[0];
    S_UX: u.trunk_areas[1];
    S_UB: u.boom_height;
} }

impl<C: Calc> Unbalanced<C> {
    pub fn new(
        p: &Position<C>,
        v: &Velocity<C>,
        w: &Weights<C>,
        own: &Own<C>,
        moved: &MovedBars<C>,
        given: &[CaseBody<C>],
        choice: &CasesChoice,
    ) -> Unbalanced<C> {
        let i = ratios(p, v);
        let [[_, boom_height], [area, height], [tie_area, _]] =
            [BOOM, TRUNK, TIE].map(|body| areas(given, choice, moved, body));
        let weight = |body: usize| {
            let sums = BodySums::new(moved, body);
            -(sums.mass * moved.of.gravity * sums.travel.y)
        };
        Unbalanced {
            tie: half_tie(w.g_3, i[TIE], p.x_3),
            trunk: trunk(w.g_2, i, p.x_1, own.centres.jib),
            boom: boom(w.g_1, i[BOOM], own.centres.boom),
            exact: [BOOM, TRUNK, TIE].map(weight),
            travel: v.da,
            i,
            head: p.x_1,
            tail: p.x_3,
            boom_height: boom_height.tabled(&s::S_UB),
            trunk_areas: [area.tabled(&s::W_UX), height.tabled(&s::S_UX)],
            tie_area: tie_area.tabled(&s::W_UL),
            swept: [BOOM, TRUNK, TIE].map(|body| swept(moved, given, choice, body)),
        }
    }
}

/// M = −G/2 i x of the jib's tail from the rocker's foot. [Ports001, 5.10.3.3]
fn half_tie<C: Calc>(weight: C, i: C, tail: Point<C>) -> C {
    (-(weight / C::constant(2.0) * i * tail.x)).def(&s::M_U_TIE)
}

/// M = −G (i_1 x_B + i_2 x_S) of the jib, whose centre is seen from the boom's head. [Ports001, 5.10.3.4]
fn trunk<C: Calc>(weight: C, i: [C; 3], head: Point<C>, centre: Point<C>) -> C {
    (-(weight * (i[BOOM] * head.x + i[TRUNK] * centre.x))).def(&s::M_U_TRUNK)
}

/// M = −G i_1 x_S. [Ports001, 5.10.3.8]
fn boom<C: Calc>(weight: C, i: C, centre: Point<C>) -> C {
    (-(weight * i * centre.x)).def(&s::M_U_BOOM)
}

/// What a case adds.
#[derive(Clone, Copy, Debug)]
pub struct UnbalancedCase<C> {
    load: C,
    rope: C,
    tie_wind: C,
    trunk_wind: C,
    boom_wind: C,
    exact: [C; 3],
}
results! { each UnbalancedCase as u => {
    M_U_LOAD: u.load;
    M_U_ROPE: u.rope;
    M_U_TIE_WIND: u.tie_wind;
    M_U_TRUNK_WIND: u.trunk_wind;
    M_U_BOOM_WIND: u.boom_wind;
    M_X_TIE_WIND: u.exact[TIE];
    M_X_TRUNK_WIND: u.exact[TRUNK];
    M_X_BOOM_WIND: u.exact[BOOM];
} }

impl<C: Calc> UnbalancedCase<C> {
    /// With the whole load (N).
    pub fn new(of: &Unbalanced<C>, load: &One<C>, case: &Case<C>, resisted: &Resisted<C>) -> UnbalancedCase<C> {
        let (q, pressure) = (case.k_q * load.1, resisted.pressure);
        UnbalancedCase {
            load: path(q, of.travel),
            rope: swayed(q, case.alpha, of.travel),
            tie_wind: half_tie_wind(pressure * of.tie_area, of.i[TIE], of.tail),
            trunk_wind: trunk_wind(pressure, of.trunk_areas, of.i, of.head),
            boom_wind: boom_wind(pressure, of.boom_height, of.i[BOOM]),
            exact: of.swept.map(|swept| pressure * swept),
        }
    }
}

/// Areas of a bar times drag coefficients, and these times the heights of their centres above its first joint.
fn areas<C: Calc>(given: &[CaseBody<C>], choice: &CasesChoice, moved: &MovedBars<C>, bar: usize) -> [C; 2] {
    let own = given.iter().zip(&choice.bodies).filter(|(_, on)| **on == bar);
    let along = moved.at[0].bars[bar][1];
    own.fold([C::constant(0.0); 2], |[sum, moment], (it, _)| {
        let (area, middle) = (it.area * it.drag, it.middle());
        [sum + area, moment + area * turned(along, middle.x, middle.y).y]
    })
}

/// M = −Q y'. [Ports001, 5.10.3.1]
fn path<C: Calc>(q: C, travel: Point<C>) -> C {
    (-(q * travel.y)).def(&s::M_U_LOAD)
}

/// M = T x', T = Q tan α. [Ports001, 5.10.3.2]
fn swayed<C: Calc>(q: C, alpha: C, travel: Point<C>) -> C {
    let (sin, cos) = alpha.sin_cos();
    (q * sin / cos * travel.x).def(&s::M_U_ROPE)
}

/// M = −W/2 i y of the jib's tail from the rocker's foot. [Ports001, 5.10.3.5]
fn half_tie_wind<C: Calc>(wind: C, i: C, tail: Point<C>) -> C {
    (-(wind / C::constant(2.0) * i * tail.y)).def(&s::M_U_TIE_WIND)
}

/// M = −p (W i_1 y_B + i_2 S), S from the boom's head. [Ports001, 5.10.3.6]
fn trunk_wind<C: Calc>(pressure: C, [area, moment]: [C; 2], i: [C; 3], head: Point<C>) -> C {
    (-(pressure * (area * i[BOOM] * head.y + i[TRUNK] * moment))).def(&s::M_U_TRUNK_WIND)
}

/// M = −p i_1 S, S from the boom's foot. [Ports001, 5.10.3.7]
fn boom_wind<C: Calc>(pressure: C, moment: C, i: C) -> C {
    (-(pressure * i * moment)).def(&s::M_U_BOOM_WIND)
}
