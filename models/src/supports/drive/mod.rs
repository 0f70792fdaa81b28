//! The drive by which a crane slews on its support: what resists it in each load case over the slewing angle, its motors with
//! start and heating, brakes, couplings that slip, and pinions on the toothed ring. [Ports001, 6.4 and 6.5, of which the
//! contents name the moments and the forms are derived]
//!
//! ```text
//!   motor --||-- coupling -- gear stages i_g : 1 -- pinion r_z
//!   T_b brake                                       |  toothed ring r_g about the slewing axis; in all i_sl : 1
//! ```
//!
//! A steady moment is that of the way round in which slope and wind resist. A start has them against it; the longest stop has
//! them from behind, the hardest against it.
//!
//! | id | function | source |
//! |---|---|---|
//! | `drive.gear` | [`gear::TurningDrive::new`] | Ports001, 6.5.4 |
//! | `drive.shafts` | [`shafts::DrivingShaft::new`], [`shafts::shafts`] | Ports001, 6.5.4 |
//! | `drive.inertia` | [`inertia::TurnedWorks::new`], [`inertia::Outswing::new`] | Ports001, 6.5.1; implicit function |
//! | `drive.resistance` | [`resistance::TurningMoments::new`] | Ports001, 6.5.1 |
//! | `drive.motor` | [`motor::TurningMotor::new`], [`motor::TurningHeat::new`] | Ports001, 6.5.2 |
//! | `drive.starts` | [`starts::started`], [`starts::HardestPush::new`] | Ports001, 6.5.2 |
//! | `drive.brake` | [`brake::TurningHold::new`], [`brake::TurningStop::new`], [`brake::Coupled::new`] | Ports001, 6.5.4 |
//! | `drive.moving` | [`moving::side`], [`moving::slips`], [`moving::dry`] | Ports001, 6.5.1 and 6.5.4 |
//! | `drive.pinion` | [`pinion::meshed`], [`pinion::PinionForce::new`] | Ports001, 6.5.4; Hertz, Lewis |

pub mod able;
pub mod brake;
pub mod checks;
pub mod fragments;
pub mod gear;
pub mod given;
pub mod inertia;
pub mod motor;
pub mod moving;
pub mod outline;
pub mod pinion;
pub mod resistance;
pub mod scene;
pub mod shafts;
pub mod starts;
pub mod symbols;
pub mod told;

use crate::kernel::gravity;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::aboard;
use crate::parts::{self, air, hanging, slip, teeth, turntable};
use crate::supports::drive::symbols as s;

/// Symbols that it shares with other drives.
pub const SHARED: [&[&Symbol]; 10] = [
    aboard::ALL,
    parts::motor::ALL,
    parts::starts::ALL,
    teeth::ALL,
    crate::drive::symbols::ALL,
    hanging::ALL,
    air::ALL,
    gravity::ALL,
    turntable::ALL,
    slip::ALL,
];

/// Whether there is a result of the drive: without a slope (0) and wind areas (1) there is nothing of them, without a drive
/// (0), a rope (1), a start by the motor's own torque (2) and gear stages (3) nothing of these.
pub fn has(symbol: &Symbol, [inclined, blown, _]: [bool; 3], [drives, hangs, starts, staged]: [bool; 4]) -> bool {
    let of = |there: &[&Symbol]| there.contains(&symbol);
    (drives || !of(listed!(s: P_SL_RMS, U_SL_RMS)))
        && (inclined || symbol != &s::M_GZ)
        && (blown || !of(listed!(s: M_WZ, S_R)))
        && (hangs || !of(listed!(s: THETA_Q, R_O)))
        && (starts || !of(listed!(s: T_P, ALPHA_P)))
        && (staged || !of(listed!(s: I_SL, ETA_SL, N_G0, T_G0, P_G0, T_GP0)))
}
