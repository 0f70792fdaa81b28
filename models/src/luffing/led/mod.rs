//! A hoist rope that is led from the head over sheaves on bars of the mechanism to the frame: the load rises and falls by it
//! while the mechanism luffs. [Ports001, 5.9.2.4]
//!
//! | id | function | source |
//! |---|---|---|
//! | `led.stretch` | [`stretch::LedStretch::new`], [`reeved::Reeved::stretches`] | derived |
//! | `led.rope` | [`path::LedStart::new`], [`path::LedRope::new`] | Ports001, 5.9.2.4 |
//! | `led.moves` | [`reeved::Reeved::moves`] | derived |
//! | `led.pull` | [`pull::LedPull::new`] | Ports001, 5.9.2.4, by equilibrium |

pub mod drawing;
pub mod fragments;
pub mod moving;
pub mod outline;
pub mod path;
pub mod pull;
pub mod reeved;
pub mod scene;
pub mod stretch;
pub mod symbols;
