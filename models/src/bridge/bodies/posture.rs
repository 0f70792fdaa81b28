//! The spreader on its four ropes at any sway, and how spreader and slings' joint move with that and with the ropes.

use crate::bridge::bodies::symbols as s;
use crate::bridge::slung::LoadSlings;
use crate::bridge::suspension::{FourRopes, Suspended};
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::number::short;
use crate::kernel::variable::Fault;
use crate::parts::plane::{Point, def};

quantities! {
    /// Spreader and load: sway of the spreader's middle from that of the trolley, angle of the slings (rad), their rates without what
    /// hoisting gives (rad/s), length of the ropes (m).
    SlungLoad { phi: PHI_R, psi: PSI_S, w_phi: W_PHI, w_psi: W_PSI, l: L_R }
}

/// Turn of the spreader (rad) with its first and second change over the sway, the same of the distance of its middle from the
/// trolley's (m); travel of spreader and slings' joint over the sway (m), and its change; travel over the ropes' length, and its
/// change over the sway.
#[derive(Clone, Copy, Debug)]
pub struct SlungPosture<C> {
    pub turn: [C; 3],
    pub reach: [C; 3],
    pub travel: [Point<C>; 2],
    pub bend: [Point<C>; 2],
    pub reel: Point<C>,
    pub bent: Point<C>,
}
results! { SlungPosture as p => {
    BETA_S: p.turn[0];
    BETA_S1: p.turn[1];
    BETA_S2: p.turn[2];
    R_M: p.reach[0];
    R_M1: p.reach[1];
    R_M2: p.reach[2];
    G_1X: p.travel[0].x;
    G_1Y: p.travel[0].y;
    G_SX: p.travel[1].x;
    G_SY: p.travel[1].y;
    K_1X: p.bend[0].x;
    K_1Y: p.bend[0].y;
    K_SX: p.bend[1].x;
    K_SY: p.bend[1].y;
    P_HX: p.reel.x;
    P_HY: p.reel.y;
    P_H1X: p.bent.x;
    P_H1Y: p.bent.y;
} }

/// Where something hangs that is turned by an angle (rad) from the vertical, and where it goes as that grows.
pub fn hung<C: Calc>(angle: C) -> [Point<C>; 2] {
    let (sin, cos) = angle.sin_cos();
    [Point::new(sin, -cos), Point::new(cos, sin)]
}

pub fn scaled<C: Calc>(v: Point<C>, by: C) -> Point<C> {
    v.map(|x| x * by)
}

impl<C: Calc> SlungPosture<C> {
    /// sin(φ − β) = (a_o/a_u) sin φ, r² = h² − 2 a_o a_u (1 − cos β): both sides' ropes keep their length, so the spreader's joints lie
    /// across the line of the middles as the trolley's do. g = ∂(r n_φ + e n_β)/∂φ, p = (l/r) n_φ. (kinematics)
    ///
    /// # Errors
    /// A sway that the ropes do not allow, or ropes that are too short for it.
    pub fn new(
        load: &SlungLoad<C>,
        slings: &LoadSlings<C>,
        ropes: &FourRopes<C>,
        hanging: &Suspended<C>,
    ) -> Result<SlungPosture<C>, Fault> {
        let FourRopes { a_o, a_u, .. } = *ropes;
        let (one, two) = (C::constant(1.0), C::constant(2.0));
        let [along, across] = hung(load.phi);
        let most = a_u.value() / a_o.value();
        if across.x.value() <= 0.0 || along.x.value().abs() >= most {
            let most = s::PHI_R.written(Calc::asin(most.min(1.0)));
            let what = format!(
                "phi_R = {} is more than the four ropes allow, {most}: there the spreader stands on edge",
                s::PHI_R.written(load.phi.value())
            );
            return Err(Fault::outside(what).about(&s::PHI_R));
        }
        let turn = (load.phi - (a_o / a_u * along.x).asin()).def(&s::BETA_S);
        let [below, aside] = hung(turn);
        let (sin, cos) = (load.phi - turn).sin_cos();
        let first = (one + a_o * along.y / (a_u * cos)).def(&s::BETA_S1);
        let second = (sin / cos * first * (two - first)).def(&s::BETA_S2);
        let product = a_o * a_u;
        let square = hanging.height.square() - two * product * (one + below.y);
        if square.value() <= 0.0 {
            let what = format!(
                "l_R = {} is too short for phi_R = {}: r_m^2 = {} m2",
                s::L_R.written(load.l.value()),
                s::PHI_R.written(load.phi.value()),
                short(square.value())
            );
            return Err(Fault::outside(what).about(&s::L_R));
        }
        let reach = square.sqrt().def(&s::R_M);
        let slope = (-product * below.x * first / reach).def(&s::R_M1);
        let curved = product * (aside.x * first.square() + below.x * second) + slope.square();
        let curve = (-curved / reach).def(&s::R_M2);
        let travel = |deep: C, names| {
            def(
                scaled(along, slope) + scaled(across, reach) + scaled(aside, deep * first),
                names,
            )
        };
        let bend = |deep: C, names| {
            let middle = scaled(along, curve - reach) + scaled(across, two * slope);
            def(
                middle + scaled(aside, deep * second) - scaled(below, deep * first.square()),
                names,
            )
        };
        let reeled = load.l / reach;
        Ok(SlungPosture {
            turn: [turn, first, second],
            reach: [reach, slope, curve],
            travel: [
                travel(slings.e_1, [&s::G_1X, &s::G_1Y]),
                travel(slings.e_s, [&s::G_SX, &s::G_SY]),
            ],
            bend: [
                bend(slings.e_1, [&s::K_1X, &s::K_1Y]),
                bend(slings.e_s, [&s::K_SX, &s::K_SY]),
            ],
            reel: def(scaled(along, reeled), [&s::P_HX, &s::P_HY]),
            bent: def(
                scaled(across, reeled) - scaled(along, reeled * slope / reach),
                [&s::P_H1X, &s::P_H1Y],
            ),
        })
    }
}
