//! The motors of a portal's travel.

use std::f64::consts::PI;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::travel::at_motor;
use crate::supports::portal::symbols as s;
use crate::supports::portal::travel::given::{PortalMotors, PortalTravel, PortalWheels};
use crate::supports::portal::travel::resistance::PortalResistance;

/// Of each motor: speed (1/s), power in steady travel (W) over the rated one, power at the end of a start (W) over the greatest;
/// mass at the wheels of all shafts (kg).
#[derive(Clone, Copy, Debug)]
pub struct TravelMotor<C> {
    speed: C,
    steady: C,
    used: C,
    pub mass: C,
    start: C,
    most: C,
}
results! { TravelMotor as m => {
    N_T: m.speed;
    P_T: m.steady;
    U_T: m.used;
    M_J: m.mass;
    P_A: m.start;
    U_A: m.most;
} }

impl<C: Calc> TravelMotor<C> {
    /// n_t = i v_t/(π D_t), P_t = F_t v_t/(z η), m_J = z J_M (2 i/D_t)², P_a = (F_ta v_t/η + m_J a_t v_t)/z. (Newton and Euler)
    pub fn new(
        wheels: &PortalWheels<C>,
        travel: &PortalTravel<C>,
        motors: &PortalMotors<C>,
        forces: &PortalResistance<C>,
    ) -> TravelMotor<C> {
        let rolled = C::constant(PI) * wheels.d_t;
        let steady = (at_motor(forces.steady * travel.v_t, motors.eta_t) / motors.z_m).def(&s::P_T);
        let quick = motors.i_t.scaled(2.0) / wheels.d_t;
        let mass = (motors.z_m * motors.j * quick.square()).def(&s::M_J);
        let crane = at_motor(forces.start * travel.v_t, motors.eta_t);
        let start = ((crane + mass * travel.a_t * travel.v_t) / motors.z_m).def(&s::P_A);
        TravelMotor {
            speed: (motors.i_t * travel.v_t / rolled).def(&s::N_T),
            steady,
            used: (steady / motors.p_n).def(&s::U_T),
            mass,
            start,
            most: (start / (motors.lambda * motors.p_n)).def(&s::U_A),
        }
    }
}
