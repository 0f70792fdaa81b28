//! The trolley in motion with its load as a pendulum: it follows its command, the load sways behind it.

use crate::bridge::given::{BridgeTrolley, TrolleyCommand};
use crate::bridge::suspension::{FourRopes, RopesLength, Suspended};
use crate::bridge::symbols as s;
use crate::bridge::trolley::TravelForces;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::parts::travel::{at_motor, sense};

quantities! {
    /// The load: its sway (rad) with the rate of that (rad/s), and the length of its ropes (m).
    SwayingLoad { phi: PHI_R, omega: OMEGA_R, l: L_R }
}

/// Length of the ropes, in m: given, or a state.
pub fn length<C: Calc>(ropes: &Option<RopesLength<C>>, swaying: &Option<SwayingLoad<C>>) -> C {
    let given = ropes.map(|ropes| ropes.l).or(swaying.map(|load| load.l));
    given.unwrap_or(C::constant(0.0))
}

/// Rates of the states, place of the load (m), force of the ropes and its part along the beam (N).
#[derive(Clone, Copy, Debug)]
pub struct Swung<C> {
    reeling: C,
    rates: [C; 5],
    place: [C; 3],
    force: C,
    pull_along: C,
}
results! { Swung as w => {
    D_L_E: w.reeling;
    D_X_T: w.rates[0];
    D_V_T: w.rates[1];
    D_PHI_R: w.rates[2];
    D_OMEGA_R: w.rates[3];
    D_L_R: w.rates[4];
    X_Q: w.place[0];
    Y_Q: w.place[1];
    X_L: w.place[2];
    S_R: w.force;
    F_PHI: w.pull_along;
} }

impl<C: Calc> Swung<C> {
    /// l φ̈ + 2 l̇ φ̇ + g sin φ = −ν_x a cos φ with the simple pendulum's length l_e; S = W(g cos φ + l φ̇² − a sin φ)/g. (Lagrange)
    #[expect(clippy::too_many_arguments, reason = "all that moves it")]
    pub fn new(
        load: &SwayingLoad<C>,
        command: &TrolleyCommand<C>,
        gravity: &One<C>,
        place: &One<C>,
        speed: &One<C>,
        weight: &C,
        ropes: &FourRopes<C>,
        hanging: &Suspended<C>,
    ) -> Swung<C> {
        let (sin, cos) = load.phi.sin_cos();
        let length = hanging.length;
        let reeling = (-hanging.slope * command.v_h).def(&s::D_L_E);
        let coriolis = (reeling * load.omega).scaled(2.0);
        let asked = coriolis + **gravity * sin + hanging.felt * command.a * cos;
        let force = *weight * (**gravity * cos + length * load.omega.square() - command.a * sin) / **gravity;
        let force = force.def(&s::S_R);
        let forward = (length * sin).def(&s::X_Q);
        Swung {
            reeling,
            rates: [
                **speed,
                command.a,
                load.omega,
                (-asked / length).def(&s::D_OMEGA_R),
                -command.v_h,
            ],
            place: [
                forward,
                (length * (C::constant(1.0) - cos) - hanging.height - ropes.e_q).def(&s::Y_Q),
                (**place + forward).def(&s::X_L),
            ],
            force,
            pull_along: (force * sin).def(&s::F_PHI),
        }
    }
}

/// The travel drive in motion: its force (N) and its motor's power (W).
#[derive(Clone, Copy, Debug)]
pub struct DriveInMotion<C>([C; 2]);
results! { DriveInMotion as d => { F_DR: d.0[0]; P_DR: d.0[1]; } }

impl<C: Calc> DriveInMotion<C> {
    /// F_dr = ±(F_μ + F_w + F_s) + F_γ + G_t a/g − F_φ; P = F v/η where it drives, F v η where it brakes. [Newton and Euler]
    pub fn new(
        unit: &BridgeTrolley<C>,
        gravity: &One<C>,
        command: &TrolleyCommand<C>,
        speed: &One<C>,
        forces: &TravelForces<C>,
        swung: &Swung<C>,
    ) -> DriveInMotion<C> {
        let inertia = unit.g_t / **gravity * command.a - swung.pull_along;
        let sense = sense(speed.value(), command.a.value());
        let force = forces.with(inertia, sense).over(**speed).def(&s::F_DR);
        DriveInMotion([force, at_motor(force * **speed, unit.eta_d).def(&s::P_DR)])
    }
}
