//! What a luffing drive must overcome, in cases that a scene names: own weights, load, sway, wind, centrifugal forces,
//! inertia, slope, friction. [Ports001, 5.5, of which the contents name the moments and the forms are derived]
//!
//! A mechanism says where its bars, its head, its counterweight and its drive are over any scalar ([`placed::Placing`]);
//! their two derivatives by the luffing angle, and all moments, follow from that alone, by virtual work. What its pins carry
//! in a case it finds by equilibrium of its bodies.
//!
//! Moments are for one radian of the luffing angle, positive where they raise the boom; the drive gives the opposite of
//! their sum. Sway, wind and slewing push forward where positive, the slope where the front is lower. The hanging load has
//! no inertia and no centrifugal force here: its sway has both.
//!
//! | id | function | source |
//! |---|---|---|
//! | `resistances.sums` | [`sums::Sums::new`] | Lagrange, by derivatives |
//! | `resistances.moments` | [`moments::Resisted::new`] | Ports001, 5.5.1-5.5.6 |
//! | `resistances.loads` | [`loads::Loads::new`] | Newton and Euler |
//! | `resistances.friction` | [`friction::Rubbed::new`] | by virtual work, pins by equilibrium |
//! | `resistances.motor` | [`motor::Motored::new`] | Ports001, 5.6 |
//! | `resistances.starts` | [`starts::started`] | Ports001, 5.6 |
//! | `resistances.brakes` | [`brakes::Holding::new`], [`brakes::Stopped::new`] | Ports001, 5.7 |

mod able;
pub mod brakes;
pub mod checks;
pub mod fragments;
pub mod friction;
pub mod given;
pub mod loads;
pub mod moments;
pub mod motor;
pub mod outline;
pub mod placed;
pub mod scene;
pub mod starts;
pub mod sums;
pub mod symbols;
pub mod told;
pub mod train;
