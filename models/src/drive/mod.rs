//! What turns a drive that pushes along a line: screw and nut, or a pinion in a rack. It serves any mechanism that tells
//! the drive's force and speed.
//!
//! | id | function | source |
//! |---|---|---|
//! | `drive.screw` | [`screw::Thread::new`], [`screw::Screw::arms`] | Ports001, 5.3 |
//! | `drive.shaft` | [`shaft::Shaft::new`] | Ports001, 5.3 |

pub mod gear;
pub mod screw;
pub mod shaft;
pub mod symbols;
