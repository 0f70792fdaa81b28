//! A drive on any link that turns about a foot on the frame: a cylinder, a rack or a screw along a line, a pinion in a toothed
//! sector, a crank with its rod, a tackle; and what turns it. The mechanism tells where the link is, how fast it turns and which moment
//! it needs, and takes the drive's force on it.
//!
//! | id | function | source |
//! |---|---|---|
//! | `drive.line` | [`line::Drive::new`], [`line::Reaction::new`] | derived |
//! | `drive.screw` | [`screw::Thread::new`], [`screw::Screw::arms`] | Ports001, 5.3 |
//! | `drive.sector` | [`sector::Sector::along`] | Ports001, 5.3 |
//! | `drive.crank` | [`crank::CrankRod::at`] | Ports001, 5.3 |
//! | `drive.tackle` | [`tackle::Tackle::arm`], [`tackle::Tackle::pulls`] | Ports001, 5.1 |
//! | `drive.hauling` | [`hauling::hauling`] | Ports001, 5.1 |
//! | `drive.shaft` | [`shaft::Shaft::new`] | Ports001, 5.3 |

pub mod checks;
pub mod crank;
pub mod drawing;
pub mod fragments;
pub mod gear;
pub mod hauling;
pub mod line;
pub mod mount;
pub mod outline;
pub mod scene;
pub mod screw;
pub mod sector;
pub mod shaft;
pub mod symbols;
pub mod tackle;
pub mod way;
