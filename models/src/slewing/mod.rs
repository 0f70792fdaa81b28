//! A crane that slews under its load, whatever holds the load: its reach is given.
//!
//! ```text
//!           axis
//!            |        R
//!   r_u      |----------------o head
//!  G_u o-----|                |
//!            |  J_sl          Q
//!   ~~~~~~~~~+~~~~~~~~~  slope gamma_s, downhill at psi_sl = 0
//! ```
//!
//! A coupling that slips, where there is one, parts the drive with its brake from all this.
//!
//! Angles and moments are positive counter-clockwise, seen from above. The load keeps its place under the head, or
//! swings on its rope.
//!
//! | id | function | source |
//! |---|---|---|
//! | `slewing.load` | [`turning::SlewedLoad::new`] | geometry |
//! | `slewing.inertia` | [`turning::total`] | Ports001, 6.5 |
//! | `slewing.slope` | [`turning::tilt`] | Ports001, 6.4, by virtual work |
//! | `slewing.wind` | [`air::WindOnSlewed::new`], [`air::outer`] | Ports001, 6.4 |
//! | `slewing.steady` | [`turning::Steady::new`] | Ports001, 6.4 |
//! | `slewing.circle` | [`turning::Circling::new`] | mechanics |
//! | `slewing.control` | [`control::Regulated::new`], [`control::acting`] | sampled PI control |
//! | `slewing.regulation` | [`control::Regulation::new`], [`control::Winding::new`], [`control::ControlEvents::new`] | continuous PI control |
//! | `slewing.friction` | [`motion::resisting`] | Ports001, 6.5 |
//! | `slewing.motion` | [`motion::Turned::new`] | Ports001, 6.5 |
//! | `slewing.coupling` | [`coupling::passed_on`], [`coupling::passing`], [`coupling::DriveRates::new`] | Ports001, 6.5.4 |
//! | `slewing.air` | [`air::stream`], [`air::FeltAir::new`] | drag |
//! | `slewing.swing` | [`swinging::Swinging::new`] | Lagrange, first kind |
//! | `slewing.blows` | [`blows::SwungInstant::stop`], [`blows::SwungInstant::catch`] | momentum |
//! | `slewing.events` | [`motion::SlewingEvents::new`], [`swinging::slackening`], [`coupled_sides::CouplingEvents::new`] | events |

pub mod air;
mod air_scene;
pub mod beside;
pub mod blows;
mod bounds;
pub mod control;
pub mod coupled_sides;
pub mod coupling;
pub mod motion;
mod outline;
pub mod scene;
pub mod stages;
pub mod swinging;
pub mod symbols;
pub mod turning;
