//! The load on its four ropes: small sway of the symmetric four-bar about rest, and skew about the vertical.
//!
//! The spreader's middle travels by u, the ropes turn it by φ = −κ u with κ = c/(h a_u). Its middle rises by
//! u²(1 + a_o a_u κ²)/(2 h), its centre of gravity by e_Q φ²/2 more, and travels by (1 − e_Q κ) u. With potential and kinetic
//! energy `m g u² E/(2 h)` and `m u̇² D/2` the frequency is exact: ω² = g E/(h D). Ropes that are parallel, κ = 0, leave g/h
//! wherever the centre of gravity is. Across the beam the ropes may lean too; the two of a side hang over an equaliser.

use std::f64::consts::TAU;

use crate::bridge::given::TrolleyCommand;
use crate::bridge::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;

quantities! {
    /// Four ropes: half distances on trolley and spreader along and across the beam, centre of gravity below the spreader's
    /// joints and out of the middle, across and along the beam, radii of gyration; all in m.
    FourRopes { a_o: A_O, a_u: A_U, b_o: B_O, b_u: B_U, e_q: E_Q, i_q: I_Q, i_z: I_Z, d_q: D_Q, e_x: E_X }
}

quantities! {
    /// Length of the ropes.
    RopesLength { l: L_R }
}

/// The load as a pendulum: height of the joints (m), parts of mass and stiffness, length of the simple pendulum (m) and its
/// change, what it feels of the trolley, frequencies (rad/s) and periods (s).
#[derive(Clone, Copy, Debug)]
pub struct Suspended<C> {
    insets: [C; 2],
    pub height: C,
    pub turn: C,
    mass: C,
    kept: C,
    pub back: C,
    pub length: C,
    pub slope: C,
    pub felt: C,
    pub frequency: C,
    simple: C,
    ratio: C,
    pub period: C,
    pub simple_period: C,
}
results! { Suspended as h => {
    C_R: h.insets[0];
    C_X: h.insets[1];
    H_R: h.height;
    KAPPA_R: h.turn;
    D_R: h.mass;
    D_K: h.kept;
    E_R: h.back;
    L_E: h.length;
    LAMBDA_E: h.slope;
    NU_X: h.felt;
    OMEGA_E: h.frequency;
    OMEGA_G: h.simple;
    K_OMEGA: h.ratio;
    T_S: h.period;
    T_G: h.simple_period;
} }

impl<C: Calc> Suspended<C> {
    /// l_e = h D/E with D = (1 − e_Q κ)² + i_Q² κ², E = 1 + (a_o a_u + e_Q h) κ²; ω_e = √(g/l_e), ω_g = √(g/l_R). (Lagrange)
    ///
    /// # Errors
    /// Ropes that are too short.
    pub fn new(ropes: &FourRopes<C>, gravity: &One<C>, length: &C) -> Result<Suspended<C>, Fault> {
        let (one, tau) = (C::constant(1.0), C::constant(TAU));
        let insets = [
            (ropes.a_o - ropes.a_u).def(&s::C_R),
            (ropes.b_o - ropes.b_u).def(&s::C_X),
        ];
        let aside = insets[0].square() + insets[1].square();
        if length.square().value() <= aside.value() {
            return Err(Fault::outside(format!(
                "l_R = {} does not reach from the trolley's joints to the spreader's, which are out of line by {}",
                s::L_R.written(length.value()),
                s::C_R.written(aside.value().sqrt())
            ))
            .about(&s::L_R));
        }
        let height = (length.square() - aside).sqrt().def(&s::H_R);
        let turn = (insets[0] / (height * ropes.a_u)).def(&s::KAPPA_R);
        let square = turn.square();
        let travel = (one - ropes.e_q * turn).square();
        let mass = (travel + ropes.i_q.square() * square).def(&s::D_R);
        let back = (one + (ropes.a_o * ropes.a_u + ropes.e_q * height) * square).def(&s::E_R);
        let simple_length = (height * mass / back).def(&s::L_E);
        let kept = (one - (ropes.e_q.square() + ropes.i_q.square()) * square).def(&s::D_K);
        let rest = simple_length * square * (ropes.e_q + (ropes.a_o * ropes.a_u).scaled(2.0) / height);
        let slope = (*length / height * (kept + rest) / back).def(&s::LAMBDA_E);
        let frequency = (**gravity / simple_length).sqrt().def(&s::OMEGA_E);
        let simple = (**gravity / *length).sqrt().def(&s::OMEGA_G);
        Ok(Suspended {
            insets,
            height,
            turn,
            mass,
            kept,
            back,
            length: simple_length,
            slope,
            felt: (travel / mass).def(&s::NU_X),
            frequency,
            simple,
            ratio: (frequency / simple).def(&s::K_OMEGA),
            period: (tau / frequency).def(&s::T_S),
            simple_period: (tau / simple).def(&s::T_G),
        })
    }
}

/// Skew: product of the ropes' arms (m²), frequency (rad/s), period (s), angle in a start (rad).
#[derive(Clone, Copy, Debug)]
pub struct Skew<C> {
    arms: C,
    frequency: C,
    period: C,
    angle: C,
}
results! { Skew as k => { A_Z: k.arms; OMEGA_Z: k.frequency; T_Z: k.period; PSI_Z: k.angle; } }

impl<C: Calc> Skew<C> {
    /// A_z = a_o a_u + b_o b_u − (a_o b_u − b_o a_u)²/l_R²: a turn by ψ lifts the spreader by A_z ψ²/(2 h), the two ropes of a
    /// side together as long as before; ω_z² = g A_z/(h i_z²), ψ_z = a d_Q h/(g A_z). [Lagrange; equilibrium]
    pub fn new(
        ropes: &FourRopes<C>,
        gravity: &One<C>,
        command: &TrolleyCommand<C>,
        length: &C,
        hanging: &Suspended<C>,
    ) -> Skew<C> {
        let FourRopes { a_o, a_u, b_o, b_u, .. } = *ropes;
        let uneven = (a_o * b_u - b_o * a_u).square() / length.square();
        let arms = (a_o * a_u + b_o * b_u - uneven).def(&s::A_Z);
        let frequency = (**gravity * arms / (hanging.height * ropes.i_z.square()))
            .sqrt()
            .def(&s::OMEGA_Z);
        Skew {
            arms,
            frequency,
            period: (C::constant(TAU) / frequency).def(&s::T_Z),
            angle: (command.a * ropes.d_q * hanging.height / (**gravity * arms)).def(&s::PSI_Z),
        }
    }
}
