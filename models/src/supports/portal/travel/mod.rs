//! How a crane travels on the rails of its portal: what resists it, its motors, brakes and driven wheels, and what holds it
//! against the wind out of service. [Ports001, 7.2, of which the contents name the drive and the forms are derived]
//!
//! ```text
//!      wind ->   ______________
//!      F_wt     |  V, V/g a_t  |   -> v_t, up the slope gamma_t
//!               |______________|
//!                 O O      O O     wheels D_t on bearings d_j: F_f against, F_ta of those that are driven
//! ```
//!
//! Steady travel and start go up the slope and into the wind; a stop has both from behind, and flanges do not count.
//!
//! | id | function | source |
//! |---|---|---|
//! | `travel.resistance` | [`resistance::rolling`], [`resistance::TravelWind::new`], [`resistance::PortalResistance::new`] | equilibrium of a wheel |
//! | `travel.motor` | [`motor::TravelMotor::new`] | Newton and Euler |
//! | `travel.stop` | [`stop::PortalStop::new`] | Newton and Euler |
//! | `travel.grip` | [`grip::WheelForces::new`], [`grip::WheelGrip::new`] | Coulomb |
//! | `travel.storm` | [`storm::StormForces::new`], [`storm::StormEdge::new`] | equilibrium |

pub mod given;
pub mod grip;
pub mod motor;
pub mod resistance;
pub mod scene;
pub mod stop;
pub mod storm;
