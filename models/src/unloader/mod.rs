//! A grab unloader with a rope trolley: its grab hangs on hoisting and closing ropes, whose drums stand on the bridge. [Ports001,
//! 7.5, of which the contents name the schemes and the forms are derived]
//!
//! ```text
//!  sea side                    v_t > 0                  land side
//!     o----------- T_1 <--- [ trolley G_t ] ---> T_2 ----------o
//!                              | |  | |
//!                              v_h > 0 upward
//!                          [ grab G_g + k_Q Q_n ]   closing ropes bear lambda W
//! ```
//!
//! Speeds of the trolley and forces on it are positive to the sea side. A drum turns positive where it winds its rope; `v_h` is
//! that at which the grab rises, `v_c` that at which the closing ropes go up faster than the hoisting ropes.
//!
//! | scheme | ropes | drums |
//! |---|---|---|
//! | `planetary` | a hoisting and a closing rope to each side; they pull the trolley too | sea side `v_h + v_t`, land side `v_h − v_t`, by differentials |
//! | `simple` | both from the land side over the trolley, which its own ropes pull | `v_h − v_t`; trolley's drum `v_t` |
//! | `auxiliary_trolley` | the same around an auxiliary trolley at `v_t/2`, so that their length stays | `v_h`; `v_t` |
//! | `middle_drum` | the same around the trolley's drum, which gives out what the trolley takes | `v_h`; `v_t` |
//!
//! | id | function | source |
//! |---|---|---|
//! | `unloader.trolley` | [`trolley::hanging`], [`trolley::TrolleyForces::new`], [`trolley::AuxiliaryRun::new`] | Ports001, 7.5 |
//! | `unloader.ropes` | [`ropes::TrolleyRopes::new`], [`ropes::wound`], [`ropes::drums_turn`] | Ports001, 5.8 |
//! | `unloader.planetary` | [`planetary::differentials`], [`planetary::circulating`] | Ports001, 5.8.1; Willis |
//! | `unloader.motors` | [`motors::MotorPowers::new`], [`motors::LiftedLoad::new`] | Ports001, 5.9 |
//! | `unloader.sway` | [`sway::SwayOnWay::new`], [`sway::answer`], [`sway::swung`] | Lagrange; linear oscillator |
//! | `unloader.programme` | [`foreseen::Foreseen::by_angle`] | Ports001, 5.10.2 |
//! | `unloader.cycle` | [`cycle::PhaseForces::new`], [`duty::GrabDuty::new`] | Ports001, 5.9.1 |

pub mod cycle;
pub mod duty;
pub mod foreseen;
pub mod motors;
mod outline;
mod paths;
pub mod planetary;
pub mod programme;
pub mod reeving;
pub mod ropes;
pub mod scene;
pub mod stages;
pub mod sway;
pub mod symbols;
mod tables;
pub mod trolley;
