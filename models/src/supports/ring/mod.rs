//! A crane that slews on a ring of balls or rollers: the forces on its rolling elements under the forces and the moment of
//! [what slews](crate::supports::upper), contact stress, static safety and friction. [Ports001, 6.3.1]
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
//! V is square to the ring and H lies in its plane. The first rolling element lies in the direction of the moment, which is
//! the worst place for it.
//!
//! | id | function | source |
//! |---|---|---|
//! | `ring.law` | [`law::RollingElements::solved`] | statics of a rigid ring on elements that yield by a power |
//! | `ring.elements` | [`elements::spreads`], [`elements::MomentAlone::new`] | Ports001, 6.3.1.1; implicit function |
//! | `ring.contact` | [`contact::ContactStress::new`] | Ports001, 6.3.1.2; Hertz |
//! | `ring.capacity` | [`capacity::static_loads`] | Rothe Erde |
//! | `ring.bolts` | [`bolts::BoltForces::new`] | equilibrium of a rigid ring on springs |
//! | `ring.life` | [`life::RacewayLife::new`] | Lundberg and Palmgren |
//! | `ring.friction` | [`friction::by_elements`], [`friction::by_maker`] | Ports001, 6.3.1.3; Rothe Erde |

pub mod bolts;
pub mod capacity;
pub mod checks;
pub mod contact;
pub mod elements;
pub mod friction;
pub mod law;
pub mod life;
mod outline;
pub mod scene;
pub mod stages;
pub mod symbols;
