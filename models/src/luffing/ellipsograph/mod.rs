//! A single boom whose foot slides on a vertical guide while a link carries it. [Ports001, 5.9.2.3]
//!
//! ```text
//!  axis  | O1 ─ ─ ─ ─ ─ ─ ─ ─ ─ ─ ─ ─ o A     A moves on the line through O1 where a = c
//!        ‖o\                       /  |
//!        ‖   \  link, c         / a   Q
//!        ‖     \             /
//!        ‖       \        /
//!        ‖         \   /
//!        ‖          o C
//!        ‖       /
//!        ‖    / c
//!      B ‖o) phi                              P = 2 C, beside B on its level
//! ```
//!
//! Angles counter-clockwise from the horizontal, x towards the load, y up, from O1, which stands on the guide's line. The
//! link turns as fast as the boom, the other way: O1, B and A are corners of a right angle's triangle where a = c, and the
//! head's path is an ellipse where it is not. Moments of loads are positive where they lower the boom, the drive's where it
//! raises it: it turns the link about O1, and the same is where it lowers the link. A balance stands at the link, which is
//! the boom that it sees.
//!
//! | id | function | source |
//! |---|---|---|
//! | `ellipsograph.position` | [`position::axes`], [`position::GuidedPosition::new`] | Ports001, 5.9.2.3 |
//! | `ellipsograph.pole` | [`position::pole`] | Ports001, 5.9 |
//! | `ellipsograph.velocity` | [`velocity::GuidedTravel::new`] | Ports001, 5.9.2.3 |
//! | `ellipsograph.load_moment` | [`statics::HeadLoad::new`] | Ports001, 5.9, by virtual work and by the instant centre |
//! | `ellipsograph.weight_moment` | [`statics::WeightMoment::new`] | by virtual work |
//! | `ellipsograph.pins` | [`pins::GuidedPins::new`] | by equilibrium of boom and link |
//! | `ellipsograph.drive` | [`driving::bar`], [`crate::drive::line::Drive::new`] | derived |
//! | `ellipsograph.motion` | [`moving::Guided`] | Lagrange, in closed form |
//! | `ellipsograph.forces_in_motion` | [`forces_in_motion::GuidedForces::new`] | Newton and Euler |
//! | `ellipsograph.range` | [`crate::component::whole`] | Ports001, 5.9.2.3 |

mod balancing;
pub mod driving;
pub mod forces_in_motion;
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
pub mod velocity;
