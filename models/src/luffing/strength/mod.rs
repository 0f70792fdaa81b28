//! Whether what drives a luffing mechanism is strong enough in the cases that a scene names. [Ports001, 5.8, of which the
//! contents name what is asked; the forms are those of textbooks]
//!
//! Each case has the force of the drive and the forces in the pins. What is allowed stands in the scene: safeties beside
//! the sizes, stresses, pressures and ratios among the limits.
//!
//! | id | function | source |
//! |---|---|---|
//! | `strength.strut` | [`strut::Slender::new`], [`strut::buckled`] | Euler, Johnson |
//! | `strength.teeth` | [`teeth::Mesh::new`], [`teeth::Toothed::new`] | Ports001, 5.8: Lewis, Hertz |
//! | `strength.nut` | [`nut::Core::new`], [`nut::Threaded::new`] | Ports001, 5.8 |
//! | `strength.pressure` | [`pull::pressed`] | Ports001, 5.8 |
//! | `strength.rope` | [`pull::RopeRatios::new`], [`pull::Tensed::new`] | Ports001, 5.8 |
//! | `strength.pins` | [`pins::Sheared::new`] | Ports001, 5.8 |

pub mod fragments;
pub mod given;
pub mod nut;
pub mod outline;
pub mod pins;
pub mod pull;
pub mod scene;
pub mod strut;
pub mod symbols;
pub mod teeth;
