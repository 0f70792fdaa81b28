//! What turns about the slewing axis, and what it takes to turn it steadily.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::variable::Fault;
use crate::parts::slope::SlopingGround;
use crate::parts::turntable::Turning;
use crate::slewing::symbols as s;

quantities! {
    /// The load, its reach, and what it weighs by.
    Hung { q: Q, r: R, g: G }
}

/// The load as all that slews feels it.
#[derive(Clone, Copy, Debug)]
pub struct SlewedLoad<C> {
    pub mass: C,
    pub inertia: C,
}
results! { SlewedLoad as p => { MASS_Q: p.mass; J_Q: p.inertia; } }

impl<C: Calc> SlewedLoad<C> {
    /// m_Q = Q / g, J_Q = m_Q R².
    pub fn new(hung: &Hung<C>) -> SlewedLoad<C> {
        let mass = (hung.q / hung.g).def(&s::MASS_Q);
        SlewedLoad {
            mass,
            inertia: (mass * hung.r.square()).def(&s::J_Q),
        }
    }
}

/// J = J_sl + J_Q, in kg·m². [Ports001, 6.5]
///
/// # Errors
/// Nothing slews.
pub fn total<C: Calc>(turning: &Turning<C>, carried: &SlewedLoad<C>) -> Result<C, Fault> {
    let total = (turning.j_sl + carried.inertia).def(&s::J_TOT);
    let none = "J_tot = 0: nothing that slews has an inertia; make J_sl greater than zero, or Q and R";
    (total.value() > 0.0)
        .then_some(total)
        .ok_or_else(|| Fault::outside(none))
}

/// M_γ = −(G_u r_u + Q R) sin γ sin ψ, in N·m: what the weights' height loses for one radian. [Ports001, 6.4]
pub fn tilt<C: Calc>(slope: &SlopingGround<C>, hung: &Hung<C>, psi: &C) -> C {
    (slope.across(slope.g_u * slope.r_u + hung.q * hung.r, *psi)).def(&s::M_GAMMA)
}

/// What the drive gives at constant speed, in N·m and W.
#[derive(Clone, Copy, Debug)]
pub struct Steady<C> {
    moment: C,
    power: C,
}
results! { Steady as d => { M_ST: d.moment; P_ST: d.power; } }

impl<C: Calc> Steady<C> {
    /// M_st = c ω + M_F − M_γ − M_ws, to the left. [Ports001, 6.4]
    pub fn new(turning: &Turning<C>, outer: &Option<C>, omega: &C) -> Steady<C> {
        let friction = turning.c_sl * *omega + turning.m_f_sl;
        let moment = outer.map_or(friction, |outer| friction - outer).def(&s::M_ST);
        Steady {
            moment,
            power: (moment * *omega).def(&s::P_ST),
        }
    }
}

/// What turning at a rate means, in N and J.
#[derive(Clone, Copy, Debug)]
pub struct Circling<C> {
    inwards: C,
    energy: C,
}
results! { Circling as c => { F_N: c.inwards; E_SL: c.energy; } }

impl<C: Calc> Circling<C> {
    /// F_n = m_Q R ω², E = J ω² / 2.
    pub fn new(carried: &SlewedLoad<C>, hung: &Hung<C>, total: &C, omega: &C) -> Circling<C> {
        let square = omega.square();
        Circling {
            inwards: (carried.mass * hung.r * square).def(&s::F_N),
            energy: (C::constant(0.5) * *total * square).def(&s::E_SL),
        }
    }
}
