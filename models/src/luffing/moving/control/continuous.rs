//! Controllers of a crane that are not sampled: [`crate::parts::control::continuous`] as the source of its drives' moments.

use crate::component::outline::joined;
use crate::component::stages::{Found, Rows, absent};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::control::{AXES, ByAxis, hoist, luffing, places};
use crate::luffing::moving::given::{CraneStates, Fitted, rates};
use crate::luffing::moving::stages::CraneMoves;
use crate::luffing::moving::symbols as m;
use crate::parts::control::SpeedControl;
use crate::parts::control::continuous::{Ordered, Regime, Regulating, Sensed};
use crate::parts::turntable_control as turning;

/// What controllers hold, and what happened to them before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laws {
    pub states: ByAxis<Regulating>,
    pub past: ByAxis<Regime>,
}

impl Laws {
    /// Where nothing has happened yet, at speeds of luffing, slewing and hoist.
    #[must_use]
    pub fn steady(control: &ByAxis<SpeedControl>, speeds: [f64; AXES.len()]) -> Laws {
        let all: [_; AXES.len()] = std::array::from_fn(|i| Some(Regulating::steady(control.0[i].as_ref()?, speeds[i])));
        Laws {
            states: ByAxis(all.map(|axis| axis.map(|(state, _)| state))),
            past: ByAxis(all.map(|axis| axis.map(|(_, past)| past))),
        }
    }

    /// Integrals that give moments (N·m), where they are still as they were before.
    pub fn hold(&mut self, control: &ByAxis<SpeedControl>, moments: [Option<f64>; AXES.len()], before: &Laws) {
        for (i, moment) in moments.into_iter().enumerate() {
            let ((Some(state), Some(control)), Some(moment)) = ((&mut self.states.0[i], &control.0[i]), moment) else {
                continue;
            };
            if before.states.0[i].is_some_and(|before| before.integral == state.integral) {
                state.integral = control.integrated(moment);
            }
        }
    }
}

impl ByAxis<Regulating> {
    /// Set points and integrals.
    pub fn values(&self) -> impl Iterator<Item = (&'static Symbol, f64)> {
        let ByAxis(states) = *self;
        states.into_iter().flatten().flat_map(|state| {
            let [set, integral] = state.axis.states;
            [(set, state.set), (integral, state.integral)]
        })
    }
}

/// What each of them gives now, how its states move, and what falls below zero where a smooth piece of its law ends.
#[derive(Clone, Copy, Debug)]
pub struct RegulatedDrives<C>([Option<[C; 8]>; AXES.len()]);

/// Error, moment asked for and moment of each.
pub const REGULATION: [&Symbol; 9] = [
    &luffing::E_R_A,
    &luffing::M_A_A,
    &m::M_A,
    &turning::E_R_SL,
    &turning::M_A_SL,
    &m::M_SL,
    &hoist::E_R_H,
    &hoist::M_AH,
    &m::M_M_H,
];

/// Rates of set point and integral of each.
pub const WINDING: [&Symbol; 6] = [
    &luffing::D_OMEGA_R_A,
    &luffing::D_EPSILON_A,
    &turning::D_OMEGA_R_SL,
    &turning::D_EPSILON_SL,
    &hoist::D_V_R_H,
    &hoist::D_EPSILON_H,
];

/// Event indicators of each.
pub const CONTROL_EVENTS: [&Symbol; 9] = [
    &luffing::Z_A_RAMP,
    &luffing::Z_A_LIMIT,
    &luffing::Z_A_WIND,
    &turning::Z_SL_RAMP,
    &turning::Z_SL_LIMIT,
    &turning::Z_SL_WIND,
    &hoist::Z_H_RAMP,
    &hoist::Z_H_LIMIT,
    &hoist::Z_H_WIND,
];

/// All of that.
pub const REGULATED: [&Symbol; 24] = joined(REGULATION, joined::<_, 6, 9, 15>(WINDING, CONTROL_EVENTS));

/// The axis of a row of [`REGULATED`], and which of its results that is.
#[must_use]
pub fn place(row: usize) -> [usize; 2] {
    match row {
        0..9 => [row / 3, row % 3],
        9..15 => [(row - 9) / 2, 3 + (row - 9) % 2],
        _ => [(row - 15) / 3, 5 + (row - 15) % 3],
    }
}

impl<C: Calc> Rows<C> for RegulatedDrives<C> {
    const ROWS: &'static [&'static Symbol] = &REGULATED;
    fn row(&self, row: u8, _: u16) -> Found<C> {
        let [axis, of] = place(usize::from(row));
        self.0[axis].as_ref().map(|all| all[of]).ok_or_else(absent)
    }
}

/// At the driven bar's angle (rad) and angular velocity (rad/s) and other states, where the crane moves so.
#[expect(clippy::too_many_arguments, reason = "all that they see")]
pub fn regulated<C: Calc>(
    control: &ByAxis<SpeedControl<C>>,
    commanded: &ByAxis<One<C>>,
    regulating: &ByAxis<Regulating<C>>,
    regime: &ByAxis<Regime<C>>,
    theta: &One<C>,
    omega: &One<C>,
    states: &CraneStates<C>,
    moves: &CraneMoves<C>,
    fitted: &Fitted,
) -> RegulatedDrives<C> {
    let places = places(theta, omega, states);
    let accelerations = rates(fitted).map(|rate| rate.map_or(C::constant(0.0), |rate| moves.of(rate)));
    let seen = seen(commanded, places, accelerations);
    let found = ordered(control, (regulating, regime), places.map(|[_, speed]| speed));
    let winding = winding(control, regime, &found, &seen);
    let until = until(control, (regulating, regime), &found, &seen);
    RegulatedDrives(std::array::from_fn(|i| {
        let (ordered, [set, integral], [ramp, limit, wind]) = (found[i]?, winding[i]?, until[i]?);
        let Ordered { error, asked, moment } = ordered;
        Some([error, asked, moment, set, integral, ramp, limit, wind])
    }))
}

/// What they give at speeds of luffing, slewing and hoist.
pub fn ordered<C: Calc>(
    control: &ByAxis<SpeedControl<C>>,
    (states, past): (&ByAxis<Regulating<C>>, &ByAxis<Regime<C>>),
    speeds: [C; AXES.len()],
) -> [Option<Ordered<C>>; AXES.len()] {
    std::array::from_fn(|i| {
        let control = control.0[i].as_ref()?;
        let ordered = control.order(states.0[i].as_ref()?, past.0[i].as_ref()?, speeds[i]);
        Some(Ordered {
            moment: ordered.moment.def(control.axis.drive),
            ..ordered
        })
    })
}

/// What they see: commands, places with speeds, and accelerations of luffing, slewing and hoist.
pub fn seen<C: Calc>(
    commanded: &ByAxis<One<C>>,
    places: [[C; 2]; AXES.len()],
    accelerations: [C; AXES.len()],
) -> [Option<Sensed<C>>; AXES.len()] {
    std::array::from_fn(|i| {
        let [place, speed] = places[i];
        Some(Sensed {
            commanded: commanded.0[i].as_ref()?.1,
            place,
            speed,
            acceleration: accelerations[i],
        })
    })
}

/// Rates of set points and integrals.
pub fn winding<C: Calc>(
    control: &ByAxis<SpeedControl<C>>,
    past: &ByAxis<Regime<C>>,
    ordered: &[Option<Ordered<C>>; AXES.len()],
    seen: &[Option<Sensed<C>>; AXES.len()],
) -> [Option<[C; 2]>; AXES.len()] {
    std::array::from_fn(|i| {
        let control = control.0[i].as_ref()?;
        Some(control.winding(past.0[i].as_ref()?, ordered[i].as_ref()?, seen[i].as_ref()?))
    })
}

/// What falls below zero where a smooth piece of their laws ends.
pub fn until<C: Calc>(
    control: &ByAxis<SpeedControl<C>>,
    (states, past): (&ByAxis<Regulating<C>>, &ByAxis<Regime<C>>),
    ordered: &[Option<Ordered<C>>; AXES.len()],
    seen: &[Option<Sensed<C>>; AXES.len()],
) -> [Option<[C; 3]>; AXES.len()] {
    std::array::from_fn(|i| {
        let (control, seen) = (control.0[i].as_ref()?, seen[i].as_ref()?);
        let (state, past) = (states.0[i].as_ref()?, past.0[i].as_ref()?);
        Some(control.regulates_until(state, past, ordered[i].as_ref()?, seen))
    })
}
