//! The trolley of a container bridge, what hangs on it, and commands that leave no sway.
//!
//! ```text
//!   sea side   <---- v_t, x_t > 0                   land side
//!      o----- T_1 ---- [ trolley G_t ] ---- T_2 -----o
//!   ========+=============/ \=====================+=====  beam on its rails, x_t = 0 and -s_b
//!           |            /   \   ropes l_R        |
//!           |           /_____\  spreader G_s     |
//!                       |  Q  |  phi_R > 0 to the sea side
//! ```
//!
//! Places, speeds and forces are positive to the sea side, `v_h` upward. The load hangs on four ropes: seen from the side a
//! symmetric four-bar, a trapezoid where they are as far apart above as below.
//!
//! | `kind` | travels by | hoisting ropes |
//! |---|---|---|
//! | `rope` | a tow rope from the land | pass over the trolley |
//! | `semi_rope` | driven wheels | pass over the trolley |
//! | `machinery` | driven wheels | end on the trolley's own drums |
//!
//! | id | function | source |
//! |---|---|---|
//! | `bridge.trolley` | [`trolley::carried`], [`trolley::TravelForces::new`], [`trolley::RailLoads::new`], [`trolley::BridgePowers::new`] | Ports001, 7.4; equilibrium |
//! | `bridge.wheels` | [`trolley::Grip::new`] | Coulomb |
//! | `bridge.tow` | [`tow::TowRun::new`] | parabola; Hooke |
//! | `bridge.suspension` | [`suspension::Suspended::new`], [`suspension::Skew::new`] | Lagrange |
//! | `bridge.slings` | [`slung::Slung::new`] | Lagrange |
//! | `bridge.brakes` | [`brakes::TrolleyBraking::new`], [`brakes::holds`] | Newton and Euler; Coulomb |
//! | `bridge.list` | [`listing::Listing::new`] | equilibrium |
//! | `bridge.profiles` | [`profiles::CycleTime::new`], [`profiles::Profiles::new`] | linear oscillator |
//! | `bridge.bodies` | [`bodies::posture::SlungPosture::new`], [`bodies::motion::SlungTurning::new`], [`bodies::motion::SlungRates::new`], [`bodies::pulls::SlungAcceleration::new`], [`bodies::pulls::SlungPulls::new`] | Lagrange; Newton and Euler |
//! | `bridge.motion` | [`swing::swung`], [`swing::DriveInMotion::new`] | Lagrange |

pub mod bodies;
pub mod brakes;
mod compared;
pub mod given;
pub mod listing;
mod outline;
pub mod profiles;
pub mod scene;
pub mod slung;
pub mod stages;
pub mod suspension;
pub mod swing;
pub mod symbols;
pub mod tow;
pub mod trolley;
