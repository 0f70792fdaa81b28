//! A crane that slews on a portal with four corners on rails: what each corner bears, and what tips it. [Ports001, 7.2]
//!
//! ```text
//!   seen from above:
//!        3 o----------------------o 2    rail
//!          |           /psi       |
//!          |          O - - - - - | - -> x, along the rails
//!          |                      |  b
//!        4 o----------------------o 1    rail
//!                      a
//! ```
//!
//! The slewing axis stands in the middle of the corners; x along the rails, y to the left, psi counter-clockwise. A moment
//! has the sign of the coordinate at which its weights stand: `M_x = Σ G y` loads the left rail, `M_y = Σ G x` the corners
//! in front. Edges have the number of the corner at which they begin, counter-clockwise: 1 in front, 2 the left rail, 3
//! behind, 4 the right rail.
//!
//! | id | function | source |
//! |---|---|---|
//! | `portal.weights` | [`weights::StillMoment::new`], [`weights::upper_moment`] | equilibrium |
//! | `portal.load` | [`load::SlewingLoad::new`], [`load::PortalMoments::new`] | equilibrium |
//! | `portal.four` | [`corners::four_legs`] | Ports001, 7.2: rigid portal |
//! | `portal.lifted` | [`corners::LiftedLeg::new`], [`corners::rigid`] | statics of three legs |
//! | `portal.hinged` | [`corners::hinged`] | Ports001, 7.2: hinged portal |
//! | `portal.wheels` | [`wheels::CornerLoad::new`] | division |
//! | `portal.circle` | [`circle::Circle::new`], [`circle::hinged_peak`] | amplitude of a harmonic; exact derivative |
//! | `portal.tipping` | [`tipping::edges`] | Ports001, 7.1.4 |
//!
//! How it [travels](crate::supports::portal::travel), and what holds it in a storm, is told where the scene has it.

pub mod checks;
pub mod circle;
pub mod corners;
pub mod load;
mod outline;
pub mod scene;
pub mod stages;
pub mod symbols;
pub mod tipping;
pub mod travel;
pub mod weights;
pub mod wheels;
