//! Spreader and load as two bodies: the load hangs below the spreader on slings, as on a heavy-lift beam. Small sway.
//!
//! The spreader's middle travels by u and is turned by −κ u; the load travels by s from where its slings hang. Over the load's
//! mass, with μ = G_s/Q, τ = 1 − e_s κ, the energies are `a u̇²/2 + b u̇ ṡ + ṡ²/2` and `p u²/2 + q s²/2`: two frequencies, of which
//! the lower one is taken from their product, so that nothing cancels. With parallel ropes it is the double pendulum.

use std::f64::consts::TAU;

use crate::bridge::given::{BridgeTrolley, TrolleyCommand};
use crate::bridge::suspension::{FourRopes, Suspended};
use crate::bridge::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;

quantities! {
    /// Slings below the spreader: their length to the load's centre of gravity, their joints and the spreader's own centre of gravity
    /// below its rope joints, its radius of gyration; all in m.
    LoadSlings { l_s: L_S, e_s: E_S, e_1: E_1, i_1: I_1 }
}

/// Two bodies below the trolley: what sways of the spreader alone and what brings it and the slings' joints back, over the same on
/// parallel ropes; masses and stiffnesses over the load's mass; frequencies (rad/s), periods (s), travel of the load by its slings
/// over that of the spreader, and travel of the load under a steady acceleration of g (m).
#[derive(Clone, Copy, Debug)]
pub struct Slung<C> {
    pub ratio: C,
    light: C,
    rise: [C; 2],
    masses: [C; 2],
    back: [C; 2],
    root: C,
    pub frequency: [C; 2],
    pub period: [C; 2],
    shape: [C; 2],
    pub steady: [C; 2],
}
results! { Slung as d => {
    MU_S: d.ratio;
    D_S1: d.light;
    E_S1: d.rise[0];
    E_S2: d.rise[1];
    A_S: d.masses[0];
    B_S: d.masses[1];
    P_S: d.back[0];
    Q_S: d.back[1];
    W_S: d.root;
    OMEGA_S1: d.frequency[0];
    OMEGA_S2: d.frequency[1];
    T_S1: d.period[0];
    T_S2: d.period[1];
    SIGMA_S1: d.shape[0];
    SIGMA_S2: d.shape[1];
    GAMMA_S1: d.steady[0];
    GAMMA_S2: d.steady[1];
} }

impl<C: Calc> Slung<C> {
    /// D_1 = (1 − e_1 κ)² + i_1² κ², E = 1 + (a_o a_u + e h) κ²; a = μ D_1 + τ², b = τ, p = g (μ E_1 + E_s)/h, q = g/l_s;
    /// w = p + a q + √((p − a q)² + 4 b² p q), ω_1² = 2 p q/w, ω_2² = w/(2 μ D_1); σ = b ω²/(q − ω²);
    /// γ = g (τ + σ)(μ (1 − e_1 κ) + τ + σ)/((a + 2 b σ + σ²) ω²). (Lagrange)
    ///
    /// # Errors
    /// No load.
    pub fn new(
        slings: &LoadSlings<C>,
        unit: &BridgeTrolley<C>,
        command: &TrolleyCommand<C>,
        ropes: &FourRopes<C>,
        gravity: &One<C>,
        hanging: &Suspended<C>,
    ) -> Result<Slung<C>, Fault> {
        if command.q.value() <= 0.0 {
            let what = "Q = 0: nothing hangs on the slings; give a load, or no [trolley.slings]";
            return Err(Fault::outside(what).about(&s::Q));
        }
        let (one, turn) = (C::constant(1.0), hanging.turn);
        let ratio = (unit.g_s / command.q).def(&s::MU_S);
        let own = one - slings.e_1 * turn;
        let travel = one - slings.e_s * turn;
        let light = (own.square() + (slings.i_1 * turn).square()).def(&s::D_S1);
        let rises = |below: C| one + (ropes.a_o * ropes.a_u + below * hanging.height) * turn.square();
        let rise = [rises(slings.e_1).def(&s::E_S1), rises(slings.e_s).def(&s::E_S2)];
        let both = travel.def(&s::B_S);
        let mass = (ratio * light + both.square()).def(&s::A_S);
        let upper = (**gravity * (ratio * rise[0] + rise[1]) / hanging.height).def(&s::P_S);
        let lower = (**gravity / slings.l_s).def(&s::Q_S);
        let (sum, product) = (upper + mass * lower, upper * lower);
        let apart = ((upper - mass * lower).square() + (both.square() * product).scaled(4.0)).sqrt();
        let root = (sum + apart).def(&s::W_S);
        let frequency = [
            (product.scaled(2.0) / root).sqrt().def(&s::OMEGA_S1),
            (root / (ratio * light).scaled(2.0)).sqrt().def(&s::OMEGA_S2),
        ];
        let names = [
            [&s::T_S1, &s::SIGMA_S1, &s::GAMMA_S1],
            [&s::T_S2, &s::SIGMA_S2, &s::GAMMA_S2],
        ];
        let each = [0, 1].map(|i| {
            let ([t, sigma, gamma], square) = (names[i], frequency[i].square());
            let shape = (both * square / (lower - square)).def(sigma);
            let whole = mass + (both * shape).scaled(2.0) + shape.square();
            let moved = both + shape;
            [
                (C::constant(TAU) / frequency[i]).def(t),
                shape,
                (**gravity * moved * (ratio * own + moved) / (whole * square)).def(gamma),
            ]
        });
        Ok(Slung {
            ratio,
            light,
            rise,
            masses: [mass, both],
            back: [upper, lower],
            root,
            frequency,
            period: each.map(|one| one[0]),
            shape: each.map(|one| one[1]),
            steady: each.map(|one| one[2]),
        })
    }
}
