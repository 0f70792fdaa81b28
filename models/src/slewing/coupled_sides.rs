//! What follows at an event for a coupling that slips, and for the drive's side of it.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::joint::{Arrival, Bar, JointDrive, above_zero};
use crate::slewing::coupling::{DriveSide, SlipCoupling, SlipPast, dry};
use crate::slewing::motion::{SlewingDrive, bar, drive, way};
use crate::slewing::symbols as s;

/// Moment that the brake must give to hold the drive's side while the coupling slips, or (second) that the coupling must give
/// between two sides of one speed, each with the least and the greatest that it can, in N·m.
pub fn needs<C: Calc>(motor: &SlewingDrive<C>, coupling: &SlipCoupling<C>, passing: C) -> [[C; 3]; 2] {
    let none = C::constant(0.0);
    [
        (passing - motor.m_sl, dry(none).holds(none, &drive(motor))),
        (
            -passing,
            dry(coupling.m_lim).holds(
                none,
                &JointDrive {
                    moment: none,
                    brake: none,
                },
            ),
        ),
    ]
    .map(|(hold, [least, most])| [hold, least, most])
}

/// What falls below zero where the drive's side comes to rest or breaks loose, and (two more) the coupling.
#[derive(Clone, Copy, Debug)]
pub struct CouplingEvents<C>([C; 4]);
results! { CouplingEvents as e => { Z_D_REST: e.0[0]; Z_D_LOOSE: e.0[1]; Z_C_REST: e.0[2]; Z_C_LOOSE: e.0[3]; } }

impl<C: Calc> CouplingEvents<C> {
    pub fn new(
        motor: &SlewingDrive<C>,
        coupling: &SlipCoupling<C>,
        slipping: &SlipPast<C>,
        side: &DriveSide<C>,
        passing: &C,
        omega: &One<C>,
    ) -> CouplingEvents<C> {
        let (none, [slip, bar]) = (C::constant(0.0), slipping.bars());
        // While the coupling sticks, the drive's side is a part of all that slews.
        let bar = if slip == Bar::Held { Bar::Loose } else { bar };
        let [own, between] = needs(motor, coupling, *passing);
        let [rest, loose, ..] = dry(none).indicators(bar, [none, side.omega_d], || own);
        let [sticks, slips, ..] = dry(coupling.m_lim).indicators(slip, [none, side.omega_d - **omega], || between);
        CouplingEvents([rest, loose, sticks, slips].map(above_zero))
    }
}

/// Both sides at one instant, as an event changes them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoupledSides {
    /// Held where the coupling sticks, forward where the drive runs ahead.
    pub slip: Bar,
    /// The drive's side where it slips.
    pub bar: Bar,
    /// In rad/s.
    pub omega: f64,
}

impl CoupledSides {
    pub(super) fn of(side: &DriveSide<f64>, past: &SlipPast<f64>) -> CoupledSides {
        let [slip, bar] = past.bars();
        CoupledSides {
            slip,
            bar,
            omega: side.omega_d,
        }
    }

    pub(super) fn past(&self) -> SlipPast<f64> {
        SlipPast {
            slip: way(self.slip),
            way_d: way(self.bar),
        }
    }

    /// Both sides at one speed (rad/s): it is decided again whether it sticks; where it sticks, the drive turns with what slews.
    pub(super) fn begin(&mut self, omega: f64) {
        if self.slip == Bar::Held {
            self.omega = omega;
        } else if self.omega == omega {
            self.slip = Bar::Held;
        }
        if self.omega == 0.0 {
            self.bar = Bar::Held;
        }
    }

    /// What follows from the speeds of both sides (rad/s) alone.
    pub(super) fn arrive(&mut self, omega: f64) {
        let free = dry(0.0);
        match free.arrival(self.slip, [0.0, self.omega - omega]) {
            Arrival::None => {}
            Arrival::SetOff(slip) => self.loosen(slip),
            Arrival::Rest { .. } => (self.slip, self.omega) = (Bar::Held, omega),
        }
        if self.slip == Bar::Held {
            return;
        }
        match free.arrival(self.bar, [0.0, self.omega]) {
            Arrival::None => {}
            Arrival::SetOff(bar) => self.bar = bar,
            Arrival::Rest { .. } => (self.bar, self.omega) = (Bar::Held, 0.0),
        }
    }

    /// From now on it slips.
    fn loosen(&mut self, slip: Bar) {
        self.slip = slip;
        self.bar = match self.omega {
            0.0 => Bar::Held,
            omega => bar(omega),
        };
    }

    /// Where they are at one speed, or the drive's side at rest: whether it breaks loose, of what each needs.
    pub(super) fn loosened(&mut self, [own, between]: [[f64; 3]; 2]) {
        if self.slip != Bar::Held {
            if self.bar == Bar::Held {
                self.bar = Bar::loosened(own);
            }
            return;
        }
        let slip = Bar::loosened(between);
        if slip != Bar::Held {
            self.loosen(slip);
        }
    }
}
