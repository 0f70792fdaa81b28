//! What a slewing drive turns: inertia of the upper works, and the load that swings out.

use std::f64::consts::TAU;

use crate::component::stages::{absent, results};
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::One;
use crate::luffing::luffed::LuffedInertia;
use crate::supports::drive::gear::TurningDrive;
use crate::supports::drive::given::{TurnedArea, TurningCase};
use crate::supports::drive::symbols as s;
use crate::supports::upper::weights::{UpperArea, UpperWeight};

/// Upper works about the slewing axis: inertia (kg·m²); wind areas with their distances (m³).
#[derive(Clone, Copy, Debug)]
pub struct TurnedWorks<C> {
    pub inertia: C,
    pub areas: Option<C>,
}
results! { TurnedWorks as t => { J_0: t.inertia; S_R: t.areas.ok_or_else(absent)?; } }

impl<C: Calc> TurnedWorks<C> {
    /// J_0 = J_e + Σ G_u r_u²/g, with a luffing mechanism its J_lm besides; S_r = Σ A_wi r_wi. [Ports001, 6.5.1]
    pub fn new(
        drive: &TurningDrive<C>,
        gravity: &One<C>,
        bodies: &[UpperWeight<C>],
        areas: &[UpperArea<C>],
        places: &[TurnedArea<C>],
        luffed: Option<&LuffedInertia<C>>,
    ) -> TurnedWorks<C> {
        let points = sum(bodies.iter().map(|body| body.g_u / **gravity * body.r_u.square()));
        let wide = || sum(areas.iter().zip(places).map(|(area, at)| area.a_w * at.r_w)).def(&s::S_R);
        let own = drive.j_e + points;
        TurnedWorks {
            inertia: luffed.map_or(own, |luffed| own + luffed.0).def(&s::J_0),
            areas: (!areas.is_empty()).then(wide),
        }
    }
}

/// Steady slewing of a case: angular velocity (rad/s), distance of the load from the axis (m) and its outswing (rad) on a rope.
#[derive(Clone, Copy, Debug)]
pub struct Outswing<C> {
    pub omega: C,
    pub reach: C,
    angle: Option<C>,
}
results! { each Outswing as o => {
    OMEGA_C: o.omega;
    THETA_Q: o.angle.ok_or_else(absent)?;
    R_O: o.angle.map(|_| o.reach).ok_or_else(absent)?;
} }

impl<C: Calc> Outswing<C> {
    /// g tan θ = Ω² (R + l sin θ): found for plain numbers, and one step of Newton's for all else. [Ports001, 6.5.1]
    pub fn new(reach: &C, gravity: &One<C>, rope: &Option<One<C>>, case: &TurningCase<C>) -> Outswing<C> {
        let omega = (C::constant(TAU) * case.n_s).def(&s::OMEGA_C);
        let Some(rope) = rope else {
            return Outswing {
                omega,
                reach: *reach,
                angle: None,
            };
        };
        let out = reach.abs();
        let found = outswung(omega.value(), out.value(), rope.value(), gravity.value());
        let start = C::constant(found).def(&s::THETA_0);
        let (sin, cos) = start.sin_cos();
        let square = omega.square();
        let rest = **gravity * sin / cos - square * (out + **rope * sin);
        let slope = **gravity / cos.square() - square * **rope * cos;
        let angle = (start - rest / slope).def(&s::THETA_Q);
        let reach = (out + **rope * angle.sin()).def(&s::R_O);
        Outswing {
            omega,
            reach,
            angle: Some(angle),
        }
    }
}

/// The greatest outswing (rad) with which a load hangs in steady slewing (rad/s) from a reach (m) on a rope (m).
fn outswung(omega: f64, reach: f64, rope: f64, gravity: f64) -> f64 {
    const STEPS: u32 = 100;
    let square = omega * omega;
    // From above the residual falls in one way: it bends upward all over the quarter.
    let mut angle = f64::direction(gravity, square * (reach + rope));
    for _ in 0..STEPS {
        let (sin, cos) = Calc::sin_cos(angle);
        let rest = gravity * sin / cos - square * (reach + rope * sin);
        let next = angle - rest / (gravity / (cos * cos) - square * rope * cos);
        if next >= angle || !next.is_finite() {
            break;
        }
        angle = next.max(0.0);
    }
    angle
}
