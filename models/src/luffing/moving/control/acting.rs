//! A crane under the moments that its controllers give.

use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::control::continuous::{REGULATED, ordered, place};
use crate::luffing::moving::control::{ByAxis, HELD, places};
use crate::luffing::moving::given::{CraneStates, Fitted, Inputs, MOST_STATES, V_R, order};
use crate::luffing::moving::hydraulic::Modes;
use crate::luffing::moving::level::CraneAt;
use crate::luffing::resistances::given::{CaseBrake, SecondBrake};
use crate::parts::control::continuous::{Regime, Regulating};
use crate::parts::control::{Latched, SpeedControl};

/// Inputs with the moments that controllers hold.
pub fn acting<C: Calc>(given: &Inputs<C>, held: &Option<ByAxis<Latched<C>>>) -> Inputs<C> {
    let mut inputs = *given;
    if let Some(ByAxis(held)) = held {
        for (i, held) in held.iter().enumerate() {
            if let Some(held) = held {
                inputs.drive(i).moment = held.moment;
            }
        }
    }
    inputs
}

/// The crane as it is, under what its controllers give.
#[expect(clippy::too_many_arguments, reason = "all that it is")]
pub fn at<C: Calc>(
    theta: &One<C>,
    omega: &One<C>,
    states: &CraneStates<C>,
    wound: &Option<One<C>>,
    past: &Modes,
    inputs: &Inputs<C>,
    brake: &Option<CaseBrake<C>>,
    second: &Option<SecondBrake<C>>,
    fitted: &Fitted,
    control: &Option<ByAxis<SpeedControl<C>>>,
    regulating: &Option<ByAxis<Regulating<C>>>,
    regime: &Option<ByAxis<Regime<C>>>,
) -> CraneAt<C> {
    let crane = states;
    let mut y = [C::constant(0.0); MOST_STATES];
    (y[0], y[1]) = (theta.1, omega.1);
    let mut states = states.0;
    if let Some(rate) = wound {
        states[V_R] = rate.1;
    }
    for (y, place) in y[2..].iter_mut().zip(order(fitted)) {
        *y = states[*place];
    }
    let mut inputs = *inputs;
    if let (Some(control), Some(states), Some(past)) = (control, regulating, regime) {
        let found = ordered(
            control,
            (states, past),
            places(theta, omega, crane).map(|[_, speed]| speed),
        );
        for (i, ordered) in found.iter().enumerate() {
            if let Some(ordered) = ordered {
                inputs.drive(i).moment = ordered.moment;
            }
        }
    }
    if fitted.braked {
        inputs.shaft = past.braking.torque(brake, second);
    }
    CraneAt { past: *past, inputs, y }
}

/// Which axis a result of controllers belongs to.
#[must_use]
pub fn axis(symbol: &'static Symbol) -> Option<usize> {
    let held = HELD.iter().position(|known| *known == symbol).map(|row| row / 3);
    held.or_else(|| Some(place(REGULATED.iter().position(|known| *known == symbol)?)[0]))
}
