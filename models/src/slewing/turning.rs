//! What turns about the slewing axis, and what turns it.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::kernel::variable::Fault;
use crate::parts::joint::{Bar, Friction, Joint, JointDrive, above_zero};
use crate::parts::slewing::Turning;
use crate::slewing::symbols as s;

quantities! {
    /// The ground, and what stands on it besides the load.
    Slope { gamma_s: GAMMA_S, g_u: G_U, r_u: R_U }
}

quantities! {
    /// The load, its reach, and what it weighs by.
    Hung { q: Q, r: R, g: G }
}

quantities! {
    /// Drive and brake.
    Driven { m_sl: M_SL, m_b_sl: M_B_SL }
}

quantities! {
    /// What happened before: which way it turns, and the energy that blows have taken.
    Past { way: WAY, blown: W_BLOW }
}

impl<C: Calc> Past<C> {
    /// At rest (0), turning to the left (1) or to the right (−1).
    pub fn bar(&self) -> Bar {
        match self.way.value() {
            0.0 => Bar::Held,
            way if way > 0.0 => Bar::Forward,
            _ => Bar::Backward,
        }
    }
}

/// Least and greatest slewing angle, in rad; infinite where there is no stop.
#[derive(Clone, Copy, Debug)]
pub struct Stops(pub [f64; 2]);
group!(Stops);

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
pub fn tilt<C: Calc>(slope: &Slope<C>, hung: &Hung<C>, psi: &C) -> C {
    let (steep, _) = slope.gamma_s.sin_cos();
    let (aside, _) = psi.sin_cos();
    (-((slope.g_u * slope.r_u + hung.q * hung.r) * steep * aside)).def(&s::M_GAMMA)
}

/// What the drive gives at constant speed, in N·m and W.
#[derive(Clone, Copy, Debug)]
pub struct Steady<C> {
    moment: C,
    power: C,
}
results! { Steady as d => { M_ST: d.moment; P_ST: d.power; } }

impl<C: Calc> Steady<C> {
    /// M_st = c ω + M_F − M_γ, to the left. [Ports001, 6.4]
    pub fn new(turning: &Turning<C>, tilt: Option<&C>, omega: &C) -> Steady<C> {
        let friction = turning.c_sl * *omega + turning.m_f_sl;
        let moment = tilt.map_or(friction, |tilt| friction - *tilt).def(&s::M_ST);
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

/// The joint with its friction and stops.
pub fn joint<C: Calc>(turning: &Turning<C>, stops: &Stops) -> Joint<C> {
    Joint {
        friction: Friction {
            viscous: turning.c_sl,
            coulomb: turning.m_f_sl,
        },
        stops: stops.0,
    }
}

/// What the drive and the slope give together, in N·m.
fn driving<C: Calc>(driven: &Driven<C>, tilt: Option<&C>) -> C {
    tilt.map_or(driven.m_sl, |tilt| driven.m_sl + *tilt)
}

fn drive<C: Calc>(driven: &Driven<C>) -> JointDrive<C> {
    JointDrive {
        moment: driven.m_sl,
        brake: driven.m_b_sl,
    }
}

/// Moment that friction, brake and stops must give at rest, with the least and the greatest that they can, in N·m.
pub fn held<C: Calc>(joint: &Joint<C>, driven: &Driven<C>, tilt: Option<&C>, psi: &C) -> [C; 3] {
    let [least, most] = joint.holds(*psi, &drive(driven));
    [-driving(driven, tilt), least, most]
}

/// M_R: −c ω − (M_F + M_B) while it turns to the left, what it needs at rest, in N·m. [Ports001, 6.5]
pub fn resisting<C: Calc>(
    turning: &Turning<C>,
    driven: &Driven<C>,
    past: &Past<C>,
    stops: &Stops,
    tilt: Option<&C>,
    omega: &C,
) -> C {
    let moment = match past.bar() {
        Bar::Held => -driving(driven, tilt),
        bar => joint(turning, stops).resistance(bar, *omega, &drive(driven)),
    };
    moment.def(&s::M_R_SL)
}

/// Rates of angle and speed, and what they ask of the load.
#[derive(Clone, Copy, Debug)]
pub struct Turned<C> {
    rate: C,
    acceleration: C,
    along: C,
}
results! { Turned as t => { D_PSI_SL: t.rate; D_OMEGA_SL: t.acceleration; F_T: t.along; } }

impl<C: Calc> Turned<C> {
    /// ω̇ = (M_sl + M_γ + M_R) / J, F_t = m_Q R ω̇. [Ports001, 6.5]
    #[expect(clippy::too_many_arguments, reason = "all that turns it")]
    pub fn new(
        driven: &Driven<C>,
        past: &Past<C>,
        tilt: Option<&C>,
        resisting: &C,
        total: &C,
        carried: &SlewedLoad<C>,
        hung: &Hung<C>,
        omega: &C,
    ) -> Turned<C> {
        let acceleration = match past.bar() {
            Bar::Held => C::constant(0.0),
            _ => ((driving(driven, tilt) + *resisting) / *total).def(&s::D_OMEGA_SL),
        };
        Turned {
            rate: *omega,
            acceleration,
            along: (carried.mass * hung.r * acceleration).def(&s::F_T),
        }
    }
}

/// Energy that blows at the stops have taken, in J: all that moved.
pub fn struck<C: Calc>(_: &Driven<C>, past: &Past<C>) -> C {
    past.blown
}

/// What falls below zero where a smooth piece of the motion ends.
#[derive(Clone, Copy, Debug)]
pub struct Ends<C>([C; 4]);
results! { Ends as e => { Z_SL_REST: e.0[0]; Z_SL_LOOSE: e.0[1]; Z_SL_LOW: e.0[2]; Z_SL_HIGH: e.0[3]; } }

impl<C: Calc> Ends<C> {
    pub fn new(
        turning: &Turning<C>,
        driven: &Driven<C>,
        past: &Past<C>,
        stops: &Stops,
        tilt: Option<&C>,
        psi: &C,
        omega: &C,
    ) -> Ends<C> {
        let joint = joint(turning, stops);
        let needs = || held(&joint, driven, tilt, psi);
        Ends(joint.indicators(past.bar(), [*psi, *omega], needs).map(above_zero))
    }
}
