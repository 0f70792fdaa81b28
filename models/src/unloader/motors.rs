//! Powers of the three motors, and the lifted load with its dynamic factor.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::parts::travel::at_motor;
use crate::unloader::reeving::{Reeving, Scheme};
use crate::unloader::ropes::TrolleyRopes;
use crate::unloader::symbols as s;
use crate::unloader::trolley::{GrabCommand, GrabTrolley};

quantities! {
    /// How the dynamic factor rises with the hoisting speed.
    DynamicFactor { phi_min: PHI_2_MIN, beta: BETA_2 }
}

/// Speeds at the ropes of the motors of hoisting, closing and travelling, with those of grab and trolley; m/s.
pub fn turning<C: Calc>(scheme: Scheme, [hoist, close, travel]: [C; 3]) -> [C; 3] {
    let grab = match scheme {
        // Their drums go with the trolley.
        Scheme::Simple => hoist - travel,
        _ => hoist,
    };
    [grab, grab + close, travel]
}

/// Powers at the ropes of hoisting, closing and travelling, in W: with speeds of hoisting, closing and travelling (m/s), the
/// weight (N) with the part of it on the closing ropes, and the force of the trolley's drive (N). [Ports001, 5.9]
pub fn at_ropes<C: Calc>(scheme: Scheme, speeds: [C; 3], [weight, share, drive]: [C; 3]) -> [C; 3] {
    let [grab, close, travel] = turning(scheme, speeds);
    [
        (C::constant(1.0) - share) * weight * grab,
        share * weight * close,
        drive * travel,
    ]
}

/// Powers of the motors, in W.
#[derive(Clone, Copy, Debug)]
pub struct MotorPowers<C>([C; 3]);
results! { MotorPowers as p => { P_H: p.0[0]; P_C: p.0[1]; P_T: p.0[2]; } }

impl<C: Calc> MotorPowers<C> {
    /// P = F v/η where it drives, F v η where it brakes. [Ports001, 5.9]
    pub fn new(
        reeving: &Reeving,
        unit: &GrabTrolley<C>,
        command: &GrabCommand<C>,
        travel: &One<C>,
        weight: &C,
        ropes: &TrolleyRopes<C>,
    ) -> MotorPowers<C> {
        let speeds = [command.v_h, command.v_c, **travel];
        let found = at_ropes(reeving.scheme, speeds, [*weight, command.lambda, ropes.drive]);
        let names = [&s::P_H, &s::P_C, &s::P_T];
        MotorPowers(std::array::from_fn(|i| at_motor(found[i], unit.eta_d).def(names[i])))
    }
}

/// The dynamic factor of the lifted load, and its weight with that, in N.
#[derive(Clone, Copy, Debug)]
pub struct LiftedLoad<C> {
    factor: C,
    weight: C,
}
results! { LiftedLoad as l => { PHI_2: l.factor; W_2: l.weight; } }

impl<C: Calc> LiftedLoad<C> {
    /// φ_2 = φ_2,min + β_2 |v_h|, W_2 = φ_2 W. [Ports001, 5.9.3]
    pub fn new(dynamic: &DynamicFactor<C>, command: &GrabCommand<C>, weight: &C) -> LiftedLoad<C> {
        let factor = (dynamic.phi_min + dynamic.beta * command.v_h.abs()).def(&s::PHI_2);
        LiftedLoad {
            factor,
            weight: (factor * *weight).def(&s::W_2),
        }
    }
}
