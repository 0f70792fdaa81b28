//! A plain boom on a luffing rope. [Ports001, 5.1, 5.2.3]
//!
//! ```text
//!    E o ~ ~ ~ T, m_l falls ~ ~ o K    o A
//!      |                      /   \  / |
//!  B o |  ~ ~ S_h ~ ~ ~ ~ ~ / ~ ~ ~    | m_h falls
//!      |                  /  l         Q
//!      o O1 ── phi ───── x             axis at x = −X_8
//! ```
//!
//! Angles counter-clockwise from the horizontal, x towards the load, y up. Moments of loads are positive where they lower
//! the boom, the tackle's moment `M_D` where it raises it. The hoist drum rests while the boom luffs. A rope compensation has
//! `m_k` parts of the hoist rope between A and B, all counted; without it there is one.
//!
//! | id | function | source |
//! |---|---|---|
//! | `rope.position` | [`position::BoomPosition::new`] | geometry |
//! | `rope.tackle` | [`position::Falls::new`] | Ports001, 5.1 |
//! | `rope.load_path` | [`position::Path::new`] | Ports001, 5.2.3, 5.2.3.1 |
//! | `rope.velocity` | [`velocity::RopeTravel::new`] | Ports001, 5.2.3, 5.2.3.1 |
//! | `rope.load_moment` | [`statics::Hanging::new`] | Ports001, 5.2.3, by virtual work, and 5.9.2.4, by powers |
//! | `rope.pull` | [`statics::Pull::new`] | Ports001, 5.1, by equilibrium |
//! | `rope.losses` | [`losses::Losses::new`] | Ports001, 5.1 |
//! | `rope.motion` | [`moving::Roped`] | Lagrange, in closed form |
//! | `rope.forces_in_motion` | [`forces_in_motion::RopeForces::new`] | Newton and Euler |
//! | `rope.range` | [`crate::component::whole`] | Ports001, 5.2.3 |
//! | `rope.fall_back` | [`crate::component::whole`] | Ports001, 5.1 |

mod balancing;
pub mod forces_in_motion;
pub mod losses;
pub mod moving;
mod outline;
pub mod position;
pub mod resisting;
pub mod scene;
mod shown;
pub mod stages;
pub mod statics;
pub mod symbols;
pub mod velocity;
