//! What slings and ropes pull with, and where the load is.

use crate::bridge::bodies::motion::{SlungRates, SlungTurning};
use crate::bridge::bodies::posture::{SlungLoad, SlungPosture, hung, scaled};
use crate::bridge::bodies::symbols as s;
use crate::bridge::given::{BridgeTrolley, TrolleyCommand};
use crate::bridge::slung::{LoadSlings, Slung};
use crate::bridge::suspension::FourRopes;
use crate::component::stages::{Found, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::parts::plane::{Point, cross, def, dot};

/// Accelerations of spreader and joint that pulls must give at steady angular velocities, against the weight too (m/s²), what of them
/// goes with the sway (J/kg) and of the load's along the slings (m/s²), angular accelerations while the hoist keeps its speed (rad/s²),
/// acceleration of the spreader (m/s²).
#[derive(Clone, Copy, Debug)]
pub struct SlungAcceleration<C> {
    steady: [Point<C>; 2],
    parts: [C; 2],
    alpha: [C; 2],
    spreader: Point<C>,
}
results! { SlungAcceleration as a => {
    B_1X: a.steady[0].x;
    B_1Y: a.steady[0].y;
    B_SX: a.steady[1].x;
    B_SY: a.steady[1].y;
    Y_B: a.parts[0];
    B_N: a.parts[1];
    ALPHA_PHI: a.alpha[0];
    ALPHA_PSI: a.alpha[1];
    A_1X: a.spreader.x;
    A_1Y: a.spreader.y;
} }

impl<C: Calc> SlungAcceleration<C> {
    /// b = ġ φ̇ − ṗ v_h + (a, g), ṗ = p' φ̇ − (1 − p²) v_h n_φ/r; D α_φ = −μ y − σ b_n, y = g_1·b_1 + i_1² β' β'' φ̇²,
    /// b_n = n·b_s − l_s ψ̇²; l_s α_ψ = −t·b_s − τ α_φ; a_1 = b_1 + g_1 α_φ. (Lagrange)
    #[expect(clippy::too_many_arguments, reason = "all that moves them")]
    pub fn new(
        load: &SlungLoad<C>,
        slings: &LoadSlings<C>,
        command: &TrolleyCommand<C>,
        gravity: &One<C>,
        slung: &Slung<C>,
        posture: &SlungPosture<C>,
        turning: &SlungTurning<C>,
        rates: &SlungRates<C>,
        answer: &C,
    ) -> SlungAcceleration<C> {
        let ([along, across], [middle, _], hoist) = (hung(load.psi), hung(load.phi), command.v_h);
        let ([omega, spin], [tau, sigma]) = (turning.omega, turning.joint);
        let reached = C::constant(1.0) - (load.l / posture.reach[0]).square();
        let reeling = scaled(posture.bent, omega) - scaled(middle, reached / posture.reach[0] * hoist);
        let outer = Point::new(*answer, **gravity) - scaled(reeling, hoist);
        let steady = |at: usize, names| def(scaled(rates.travel[at], omega) + outer, names);
        let [own, joint] = [steady(0, [&s::B_1X, &s::B_1Y]), steady(1, [&s::B_SX, &s::B_SY])];
        let spun = slings.i_1.square() * posture.turn[1] * posture.turn[2] * omega.square();
        let upper = (dot(posture.travel[0], own) + spun).def(&s::Y_B);
        let pulled = (dot(along, joint) - slings.l_s * spin.square()).def(&s::B_N);
        let sway = (-(slung.ratio * upper + sigma * pulled) / turning.inertia).def(&s::ALPHA_PHI);
        SlungAcceleration {
            steady: [own, joint],
            parts: [upper, pulled],
            alpha: [
                sway,
                (-(dot(across, joint) + tau * sway) / slings.l_s).def(&s::ALPHA_PSI),
            ],
            spreader: def(own + scaled(posture.travel[0], sway), [&s::A_1X, &s::A_1Y]),
        }
    }
}

/// Place of the load (m), pulls of slings and ropes, the ropes' part along the beam (N), moment on the spreader over its mass
/// (J/kg), of the ropes alone (N m), how much more the sea side's pull (N), pulls of a rope of either side (N).
#[derive(Clone, Copy, Debug)]
pub struct SlungPulls<C> {
    place: [C; 3],
    slings: C,
    ropes: C,
    pub pull_along: C,
    moment: [C; 2],
    uneven: C,
    sides: [C; 2],
}
results! { SlungPulls as p => {
    X_Q: p.place[0];
    Y_Q: p.place[1];
    X_L: p.place[2];
    N_S: p.slings;
    S_R: p.ropes;
    F_PHI: p.pull_along;
    Y_M: p.moment[0];
    M_P: p.moment[1];
    S_D: p.uneven;
    S_S1: p.sides[0];
    S_S2: p.sides[1];
    Z_SLINGS: p.slings;
    Z_SEA: p.sides[0];
    Z_LAND: p.sides[1];
} }

impl<C: Calc> SlungPulls<C> {
    /// N = −Q(b_n + σ α_φ)/g; S = N cos(ψ − φ) − G_s a_1·n_φ/g, F = N sin ψ − G_s a_1x/g;
    /// M = G_s y/g − e_s N sin(ψ − β); S_Δ = (M/a_u + a_o sin β S/r)/cos(φ − β), of a rope l(S ± S_Δ)/(4 r);
    /// y = i_1² β̈ + e_1 n_β × a_1.
    /// (Newton and Euler)
    #[expect(clippy::too_many_arguments, reason = "all that pulls")]
    pub fn new(
        load: &SlungLoad<C>,
        slings: &LoadSlings<C>,
        unit: &BridgeTrolley<C>,
        command: &TrolleyCommand<C>,
        gravity: &One<C>,
        trolley: &One<C>,
        ropes: &FourRopes<C>,
        posture: &SlungPosture<C>,
        turning: &SlungTurning<C>,
        moved: &SlungAcceleration<C>,
    ) -> SlungPulls<C> {
        let ([along, _], [middle, _]) = (hung(load.psi), hung(load.phi));
        let ([turn, first, second], reach) = (posture.turn, posture.reach[0]);
        let (below, [alpha, _]) = (hung(turn)[0], moved.alpha);
        let forward = (reach * middle.x + slings.e_s * below.x + slings.l_s * along.x).def(&s::X_Q);
        let upward = (reach * middle.y + slings.e_s * below.y + slings.l_s * along.y).def(&s::Y_Q);
        let own = -(moved.parts[1] + turning.joint[1] * alpha);
        let pull = (command.q / **gravity * own).def(&s::N_S);
        let (mass, spreader) = (unit.g_s / **gravity, moved.spreader);
        let all = (pull * dot(along, middle) - mass * dot(spreader, middle)).def(&s::S_R);
        let turned = first * alpha + second * turning.omega[0].square();
        let spun = (slings.i_1.square() * turned + slings.e_1 * cross(below, spreader)).def(&s::Y_M);
        let moment = (mass * spun - slings.e_s * pull * cross(below, along)).def(&s::M_P);
        let level = (load.phi - turn).sin_cos().1;
        let uneven = ((moment / ropes.a_u + ropes.a_o * below.x * all / reach) / level).def(&s::S_D);
        let part = load.l / reach.scaled(4.0);
        SlungPulls {
            place: [forward, upward, (**trolley + forward).def(&s::X_L)],
            slings: pull,
            ropes: all,
            pull_along: (pull * along.x - mass * spreader.x).def(&s::F_PHI),
            moment: [spun, moment],
            uneven,
            sides: [
                (part * (all + uneven)).def(&s::S_S1),
                (part * (all - uneven)).def(&s::S_S2),
            ],
        }
    }
}

impl SlungPulls<f64> {
    /// Whether all pull.
    ///
    /// # Errors
    /// Slings or ropes that would have to push.
    pub fn hold(&self, load: &SlungLoad<f64>) -> Found<()> {
        let [sea, land] = self.sides;
        let all: [(&Symbol, &str, f64); 3] = [
            (&s::N_S, "the slings are slack, they", self.slings),
            (&s::S_S1, "the sea side's ropes are slack, each", sea),
            (&s::S_S2, "the land side's ropes are slack, each", land),
        ];
        let Some((symbol, what, pull)) = all.into_iter().find(|(.., pull)| *pull < 0.0) else {
            return Ok(());
        };
        let [phi, psi, push] =
            [(&s::PHI_R, load.phi), (&s::PSI_S, load.psi), (symbol, -pull)].map(|(s, value)| s.written(value));
        Err(Box::new(Fault::outside(format!(
            "phi_R = {phi}, psi_s = {psi}: {what} would have to push with {push}; this motion ends there: start and \
             stop more gently, or begin with less sway"
        ))))
    }
}
