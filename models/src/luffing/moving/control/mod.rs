//! Controllers of a crane's drives: [`crate::parts::control`] as the source of the moments of luffing, slewing and a hoist's
//! motor, which one PLC samples, or which are continuous.
//!
//! | file | what |
//! |---|---|
//! | `continuous`, `acting` | those that are not sampled; inputs with the moments that controllers give |
//! | `luffing`, `hoist` | quantities of the two that only a luffing crane has |
//! | `holding` | what they hold at the start |
//! | `reading` | controllers as scenes describe them |

use crate::component::stages::{Found, Rows, absent};
use crate::kernel::calc::Calc;
use crate::kernel::group::{Group, One};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Quantity;
use crate::luffing::moving::given::{CraneStates, L_R, OMEGA_SL, PSI_SL, V_R};
use crate::luffing::moving::symbols as m;
use crate::parts::control::{DriveAxis, Latched, SpeedControl};
use crate::parts::turntable_control as turning;

pub mod acting;
pub mod continuous;
pub mod hoist;
pub mod holding;
pub mod luffing;
pub mod reading;

/// Of luffing, slewing and hoist, as far as they have controllers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByAxis<G>(pub [Option<G>; 3]);

/// What they are called, in this order.
pub static AXES: [&DriveAxis; 3] = [&luffing::AXIS, &turning::AXIS, &hoist::AXIS];

impl<C: Calc, G: Group<C>> Group<C> for ByAxis<G> {
    type Over<D: Calc> = ByAxis<G::Over<D>>;
    const SIZE: usize = 3 * G::SIZE;
    fn map<D: Calc>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> ByAxis<G::Over<D>> {
        ByAxis(self.0.each_ref().map(|axis| axis.map(f)))
    }
    fn each(&self, f: &mut dyn FnMut(Quantity, C)) {
        self.0.iter().for_each(|axis| axis.each(f));
    }
    fn take(&self, place: usize) -> C {
        let (axis, place) = self.found::<C>(place);
        self.0[axis].take(place)
    }
    fn put(&mut self, place: usize, value: C) {
        let (axis, place) = self.found::<C>(place);
        self.0[axis].put(place, value);
    }
}

impl<G> ByAxis<G> {
    /// The axis that has a place, and where that is in it.
    fn found<C: Calc>(&self, mut place: usize) -> (usize, usize)
    where
        G: Group<C>,
    {
        for (i, axis) in self.0.iter().enumerate() {
            let mut size = 0;
            axis.each(&mut |_, _: C| size += 1);
            if place < size {
                return (i, place);
            }
            place -= size;
        }
        unreachable!("no such place")
    }
}

/// The cycle of the PLC that samples them, in s.
#[must_use]
pub fn cycle(control: &ByAxis<SpeedControl>) -> Option<f64> {
    control.0.iter().flatten().find_map(SpeedControl::cycle)
}

/// One sample of each, at the driven bar's angle (rad) and angular velocity (rad/s) and other states.
pub fn sampled<C: Calc>(
    control: &ByAxis<SpeedControl<C>>,
    commanded: &ByAxis<One<C>>,
    held: &ByAxis<Latched<C>>,
    theta: &One<C>,
    omega: &One<C>,
    states: &CraneStates<C>,
) -> SampledDrives<C> {
    let at = places(theta, omega, states);
    let next = std::array::from_fn(|i| Some(control.0[i]?.sample(&held.0[i]?, &commanded.0[i]?, at[i])));
    SampledDrives {
        held: held.0,
        next: ByAxis(next),
    }
}

/// Place and speed of each axis.
fn places<C: Calc>(theta: &One<C>, omega: &One<C>, CraneStates(states): &CraneStates<C>) -> [[C; 2]; AXES.len()] {
    [
        [theta.1, omega.1],
        [states[PSI_SL], states[OMEGA_SL]],
        [states[L_R], states[V_R]],
    ]
}

/// What they hold, and what they will after the next sample.
#[derive(Clone, Copy, Debug)]
pub struct SampledDrives<C> {
    held: [Option<Latched<C>>; AXES.len()],
    pub next: ByAxis<Latched<C>>,
}

/// Moment, set point and integral part of each.
pub const HELD: [&Symbol; 9] = [
    &m::M_A,
    &luffing::OMEGA_S_A,
    &luffing::M_I_A,
    &m::M_SL,
    &turning::OMEGA_S_SL,
    &turning::M_I_SL,
    &m::M_M_H,
    &hoist::V_SH,
    &hoist::M_IH,
];

impl<C: Calc> Rows<C> for SampledDrives<C> {
    const ROWS: &'static [&'static Symbol] = &HELD;
    fn row(&self, row: u8, _: u16) -> Found<C> {
        let held = self.held[usize::from(row / 3)].as_ref().ok_or_else(absent)?;
        Ok([held.moment, held.set, held.integral][usize::from(row % 3)])
    }
}

impl ByAxis<Latched> {
    /// Set points and integral parts.
    pub fn before(&self) -> impl Iterator<Item = (&'static Symbol, f64)> {
        let ByAxis(held) = *self;
        held.into_iter().flatten().flat_map(|held| {
            let [set, integral, _] = held.axis.held;
            [(set, held.set), (integral, held.integral)]
        })
    }
}

/// What controllers are set to that one sample need not meet.
pub const SETTINGS: &[&Symbol] = &[
    &luffing::K_I_A,
    &luffing::T_C_A,
    &luffing::A_A,
    &luffing::M_MAX_A,
    &luffing::K_THETA_A,
    &luffing::OMEGA_MAX_A,
    &turning::K_I_SL,
    &turning::T_C_SL,
    &turning::A_SL,
    &turning::M_MAX_SL,
    &turning::K_PSI_SL,
    &turning::OMEGA_MAX_SL,
    &hoist::K_IH,
    &hoist::T_CH,
    &hoist::A_CH,
    &hoist::M_MAXH,
    &hoist::K_LH,
    &hoist::V_MAXH,
];
