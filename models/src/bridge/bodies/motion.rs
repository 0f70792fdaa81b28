//! How spreader and load turn: angular velocities and the rates of what does not jump with the hoist's speed.
//!
//! Lagrange's equations over the load's mass, with μ = G_s/Q: the mass matrix is [μ(g_1² + i_1² β'²) + g_s², l_s τ; l_s τ, l_s²], where τ
//! and σ are g_s across and along the slings. Its second row is solved for the slings, which leaves D = μ(g_1² + i_1² β'²) + σ².

use crate::bridge::bodies::posture::{SlungLoad, SlungPosture, hung, scaled};
use crate::bridge::bodies::symbols as s;
use crate::bridge::given::TrolleyCommand;
use crate::bridge::slung::{LoadSlings, Slung};
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::plane::{Point, def, dot, squared};

/// Travel of the slings' joint across and along the slings over the sway (m), inertia of the sway (m²), what a jump of the hoist's speed
/// gives both angular velocities (1/m), and these (rad/s).
#[derive(Clone, Copy, Debug)]
pub struct SlungTurning<C> {
    pub joint: [C; 2],
    pub inertia: C,
    pub jump: [C; 2],
    pub omega: [C; 2],
}
results! { SlungTurning as t => {
    TAU_J: t.joint[0];
    SIGMA_J: t.joint[1];
    D_J: t.inertia;
    ETA_1: t.jump[0];
    ETA_2: t.jump[1];
    OMEGA_R: t.omega[0];
    OMEGA_PSI: t.omega[1];
} }

impl<C: Calc> SlungTurning<C> {
    /// η_1 = (μ g_1·p + σ p·n)/D, η_2 = (p·t − τ η_1)/l_s: the hoist's jump changes no momentum along φ and ψ; φ̇ = w_φ + η_1 v_h,
    /// ψ̇ = w_ψ + η_2 v_h. (Lagrange, impulse)
    pub fn new(
        load: &SlungLoad<C>,
        slings: &LoadSlings<C>,
        command: &TrolleyCommand<C>,
        slung: &Slung<C>,
        posture: &SlungPosture<C>,
    ) -> SlungTurning<C> {
        let ([along, across], [own, joint], reel) = (hung(load.psi), posture.travel, posture.reel);
        let turned = (slings.i_1 * posture.turn[1]).square();
        let (tau, sigma) = (dot(joint, across).def(&s::TAU_J), dot(joint, along).def(&s::SIGMA_J));
        let inertia = (slung.ratio * (squared(own) + turned) + sigma.square()).def(&s::D_J);
        let first = ((slung.ratio * dot(own, reel) + sigma * dot(reel, along)) / inertia).def(&s::ETA_1);
        let second = ((dot(reel, across) - tau * first) / slings.l_s).def(&s::ETA_2);
        SlungTurning {
            joint: [tau, sigma],
            inertia,
            jump: [first, second],
            omega: [
                (load.w_phi + first * command.v_h).def(&s::OMEGA_R),
                (load.w_psi + second * command.v_h).def(&s::OMEGA_PSI),
            ],
        }
    }
}

/// Rates of the travels over the sway (m/s), speeds that the hoist's jump would give (m/s), what these turn with the slings, what
/// accelerates the load across and along them (m/s²), what the sway asks for of the spreader and is given by hoisting (J/kg), rates of
/// all states but the trolley's.
#[derive(Clone, Copy, Debug)]
pub struct SlungRates<C> {
    pub travel: [Point<C>; 2],
    jump: [Point<C>; 2],
    parts: [C; 5],
    rates: [C; 5],
}
results! { SlungRates as r => {
    D_G_1X: r.travel[0].x;
    D_G_1Y: r.travel[0].y;
    D_G_SX: r.travel[1].x;
    D_G_SY: r.travel[1].y;
    U_1X: r.jump[0].x;
    U_1Y: r.jump[0].y;
    U_2X: r.jump[1].x;
    U_2Y: r.jump[1].y;
    Z_U: r.parts[0];
    A_T2: r.parts[1];
    A_N2: r.parts[2];
    Y_W: r.parts[3];
    Y_U: r.parts[4];
    D_PHI_R: r.rates[0];
    D_PSI_S: r.rates[1];
    D_W_PHI: r.rates[2];
    D_W_PSI: r.rates[3];
    D_L_R: r.rates[4];
} }

impl<C: Calc> SlungRates<C> {
    /// Rates of what hoisting leaves of the angular velocities (rad/s²).
    pub fn turning(&self) -> [C; 2] {
        let [_, _, sway, slings, _] = self.rates;
        [sway, slings]
    }

    /// With a field f = (a, g): D ẇ_φ = y_u − μ y − σ a_n, l_s ẇ_ψ = a_q − τ ẇ_φ; z = ψ̇ n·u_2, a_q = −t·(ġ_s w_φ + f) − z,
    /// a_n = n·(ġ_s w_φ + f) − l_s ψ̇ w_ψ, y = g_1·(ġ_1 w_φ + f) − ġ_1·u_1 + i_1² β' β'' φ̇ (2 w_φ − φ̇), y_u = ġ_s·u_2 + τ z. (Lagrange)
    #[expect(clippy::too_many_arguments, reason = "all that moves them")]
    pub fn new(
        load: &SlungLoad<C>,
        slings: &LoadSlings<C>,
        command: &TrolleyCommand<C>,
        gravity: &One<C>,
        slung: &Slung<C>,
        posture: &SlungPosture<C>,
        turning: &SlungTurning<C>,
        answer: &C,
    ) -> SlungRates<C> {
        let ([along, across], hoist) = (hung(load.psi), command.v_h);
        let ([omega, spin], [tau, sigma], [first, second]) = (turning.omega, turning.joint, turning.jump);
        let rate = |at: usize, names| def(scaled(posture.bend[at], omega) - scaled(posture.bent, hoist), names);
        let [own, joint] = [rate(0, [&s::D_G_1X, &s::D_G_1Y]), rate(1, [&s::D_G_SX, &s::D_G_SY])];
        let turned = |at: usize| scaled(posture.travel[at], first) - posture.reel;
        let jump = [
            def(scaled(turned(0), hoist), [&s::U_1X, &s::U_1Y]),
            def(
                scaled(turned(1) + scaled(across, second * slings.l_s), hoist),
                [&s::U_2X, &s::U_2Y],
            ),
        ];
        let field = Point::new(*answer, **gravity);
        let pushed = |rate: Point<C>| scaled(rate, load.w_phi) + field;
        let swung = (spin * dot(along, jump[1])).def(&s::Z_U);
        let to_load = (-dot(across, pushed(joint)) - swung).def(&s::A_T2);
        let pulled = (dot(along, pushed(joint)) - slings.l_s * spin * load.w_psi).def(&s::A_N2);
        let spun = slings.i_1.square() * posture.turn[1] * posture.turn[2] * omega * (load.w_phi.scaled(2.0) - omega);
        let upper = (dot(posture.travel[0], pushed(own)) - dot(own, jump[0]) + spun).def(&s::Y_W);
        let hoisted = (dot(joint, jump[1]) + tau * swung).def(&s::Y_U);
        let sway = ((hoisted - slung.ratio * upper - sigma * pulled) / turning.inertia).def(&s::D_W_PHI);
        SlungRates {
            travel: [own, joint],
            jump,
            parts: [swung, to_load, pulled, upper, hoisted],
            rates: [
                omega,
                spin,
                sway,
                ((to_load - tau * sway) / slings.l_s).def(&s::D_W_PSI),
                -hoist,
            ],
        }
    }
}
