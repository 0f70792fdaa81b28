//! A boom with a trunk on its head, whose curved tail a flexible tie holds. [Ports001, 5.2.3.3, 5.2.4.3]
//!
//! ```text
//!              _____  clamp
//!          T .´      `.
//!     f    /    tail    ` B ────── a ────── o A
//!        /            /                     |
//!  O3 o             / b                     Q
//!                 /
//!               o O1 ── phi ── x            axis at x = −X_8
//! ```
//!
//! Angles counter-clockwise from the horizontal, x towards the load, y up, from O1. The tail is described in the trunk's own
//! frame, from B along the line to A and square to it, from its front end to its rear end over its upper side, along which it
//! turns counter-clockwise. The tie lies on it from the clamp at one of its ends to T, which it leaves in the tail's own
//! direction: at any moment the trunk moves as on a rigid tie from T to O3. Moments of loads are positive where they lower the
//! boom, the drive's where it raises it.
//!
//! The unrolled end of the tie is v = c + f u in the trunk's frame, and it is as far from B as O3 is: d² = v². That is one
//! equation for the point of contact, dv²/dζ = −2 f h_t: it has one solution between two dead points, in which the tie's line
//! passes through B.
//!
//! | id | function | source |
//! |---|---|---|
//! | `curved_trunk.tail` | [`tail::TrunkTail::new`] | Ports001, 5.2.4.3 |
//! | `curved_trunk.closure` | [`contact::Contact::new`] | Ports001, 5.2.4.3, by the length of the tie |
//! | `curved_trunk.position` | [`position::TrunkPosition::new`] | geometry |
//! | `curved_trunk.velocity` | [`velocity::TrunkTravel::new`] | Ports001, 5.2.3.3, by the loop |
//! | `curved_trunk.pole` | [`velocity::pole`] | Ports001, 5.2.3.3 |
//! | `curved_trunk.load_moment` | [`statics::TrunkLoad::new`] | Ports001, 5.9, by virtual work and by the instantaneous centre |
//! | `curved_trunk.weight_moment` | [`statics::TrunkWeight::new`] | by virtual work |
//! | `curved_trunk.led_rope` | [`leading::leads`], [`crate::luffing::led`] | Ports001, 5.9.2.4 |
//! | `curved_trunk.pins` | [`pins::TrunkPins::new`], [`pins::TrunkBearing::new`] | by equilibrium of trunk and boom |
//! | `curved_trunk.drive` | [`driving::bar`], [`crate::drive::line::Drive::new`] | derived |
//! | `curved_trunk.motion` | [`moving::Trunked`], [`velocity::TrunkBend::new`] | Lagrange, in closed form over the point of contact |
//! | `curved_trunk.forces_in_motion` | [`forces_in_motion::TrunkForces::new`] | Newton and Euler |
//! | `curved_trunk.range` | [`crate::component::whole`] | Ports001, 5.2.4.3 |

mod balancing;
pub mod centres;
pub mod contact;
mod drawing;
pub mod driving;
pub mod forces_in_motion;
pub mod leading;
pub mod moving;
mod outline;
pub mod pins;
pub mod position;
pub mod resisting;
pub mod scene;
mod shown;
pub mod stages;
pub mod statics;
pub mod symbols;
pub mod tail;
pub mod velocity;
