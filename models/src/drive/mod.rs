//! What turns a drive: screw and nut or a pinion in a rack where it pushes along a line, a pinion in a toothed sector, a
//! crank with its rod. It serves any mechanism that tells the drive's force and speed.
//!
//! | id | function | source |
//! |---|---|---|
//! | `drive.screw` | [`screw::Thread::new`], [`screw::Screw::arms`] | Ports001, 5.3 |
//! | `drive.sector` | [`sector::Sector::along`] | Ports001, 5.3 |
//! | `drive.crank` | [`crank::CrankRod::at`] | Ports001, 5.3 |
//! | `drive.shaft` | [`shaft::Shaft::new`] | Ports001, 5.3 |

pub mod crank;
pub mod gear;
pub mod screw;
pub mod sector;
pub mod shaft;
pub mod symbols;
