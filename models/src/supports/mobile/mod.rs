//! A mobile crane on outriggers or tyres: what tips it, what it may lift, how its supports share the load.
//! [Ports001, 7.1; ISO 4305]
//!
//! ```text
//!                      o head           seen from above:   4 o--------o 1
//!                   /  |                                     |        |
//!      G_p       /     | R - ...                             |   O----|---- psi
//!             /        Q                                     |        |
//!  G_u  o  o foot                                          3 o--------o 2
//!   --- O-+------                       x forward, y to the left, psi counter-clockwise
//!     G_c |
//!   ^-----------^ supports
//! ```
//!
//! The crane tips about a side of the polygon around its supports. Slope and wind lie in the boom's direction: moments
//! and reaches on them are those of level ground with other arms.
//!
//! | id | function | source |
//! |---|---|---|
//! | `mobile.boom` | [`boom::HeadPose::new`], [`boom::BoomWeight::new`] | geometry; ISO 4305 |
//! | `mobile.weights` | [`weights::DeadWeight::new`], [`weights::Leaning::new`], [`weights::Payload::new`] | equilibrium |
//! | `mobile.tipping` | [`tipping::Sides::new`], [`tipping::Tipping::new`], [`tipping::behind`] | Ports001, 7.1.4, for any polygon |
//! | `mobile.ground` | [`ground::GroundForce::new`] | equilibrium |
//! | `mobile.bearing` | [`bearing::bearing_springs`], [`bearing::SupportForce::new`], [`bearing::Bearable::new`] | equal springs |
//! | `mobile.rated` | [`rating::Rated::new`], [`limiter::Utilised::new`], [`strength::Strengths::at`] | ISO 4305; Ports001, 7.1.4 |
//! | `mobile.chart` | [`charting::chart`], [`chart::LoadChart::at`] | the same, over the working range |

pub mod bearing;
pub mod boom;
pub mod chart;
pub mod charting;
pub mod ground;
pub mod limiter;
mod outline;
pub mod rating;
pub mod scene;
pub mod stages;
pub mod strength;
pub mod symbols;
pub mod tipping;
pub mod weights;
