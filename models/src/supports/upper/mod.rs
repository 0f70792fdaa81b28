//! What slews on a support, whichever it is: weights and wind areas, load cases, and the forces and the moment that they
//! bring there over the slewing angle. [Ports001, 6.1]
//!
//! A moment has the direction of the side that it loads: `M_l = Σ G r` in front, `M_t` on the left. On a slope the slewing
//! angle counts from the downhill direction; V lies along the slewing axis, H and M are square to it. Heights and moments
//! count from the slewing support.
//!
//! | id | function | source |
//! |---|---|---|
//! | `upper.weights` | [`weights::UpperWorks::new`] | equilibrium |
//! | `upper.load` | [`load::SupportLoad::new`] | Ports001, 6.1: equilibrium |

pub mod fragments;
pub mod keys;
pub mod load;
pub mod symbols;
pub mod weights;
