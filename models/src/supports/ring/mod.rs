//! A crane that slews on a ring of balls or rollers: forces and moment on it in each load case over the slewing angle, the
//! forces on its rolling elements, contact stress, static safety and friction. [Ports001, 6.1 to 6.3]
//!
//! ```text
//!   from the side:                          from above:
//!         o------------------ Q                     _____
//!   ______|________ boom                          /   |   \   c_j = cos of element j
//!  |G_u   |                                      |    O----o----> M  (element 1)
//!  |______|___ h_u, h_w, h_Q                      \   |   /
//!    o==D==o   ring, V square to it, H in it        -----
//! ```
//!
//! A moment has the direction of the side that it loads: `M_l = Σ G r` in front, `M_t` on the left. On a slope the slewing
//! angle counts from the downhill direction, and V, H and M are square to the ring and in its plane. The first rolling
//! element lies in the direction of the moment, which is the worst place for it.
//!
//! | id | function | source |
//! |---|---|---|
//! | `ring.weights` | [`weights::UpperWorks::new`] | equilibrium |
//! | `ring.load` | [`load::RingLoad::new`] | Ports001, 6.1: equilibrium |
//! | `ring.law` | [`law::RollingElements::solved`] | statics of a rigid ring on elements that yield by a power |
//! | `ring.elements` | [`elements::spreads`], [`elements::MomentAlone::new`] | Ports001, 6.3.1.1; implicit function |
//! | `ring.contact` | [`contact::ContactStress::new`] | Ports001, 6.3.1.2; Hertz |
//! | `ring.capacity` | [`capacity::static_loads`] | Rothe Erde |
//! | `ring.friction` | [`friction::by_elements`], [`friction::by_maker`] | Ports001, 6.3.1.3; Rothe Erde |

pub mod capacity;
pub mod checks;
pub mod contact;
pub mod elements;
pub mod friction;
pub mod law;
pub mod load;
mod outline;
pub mod scene;
pub mod stages;
pub mod symbols;
pub mod weights;
