//! Spreader and load as two bodies in motion: the spreader on its four ropes, any sway, the load on massless slings below it.
//!
//! ```text
//!      a_o   a_o
//!    o-----+-----o   trolley
//!     \    |φ   /    ropes, reeled; r from the trolley's middle to the spreader's
//!      o---+---o     spreader, turned by β: sin(φ - β) = (a_o/a_u) sin φ
//!          o e_s
//!           \ ψ      slings l_s
//!            Q
//! ```
//!
//! Spreader and load move by `v_1 = g_1 φ̇ + p l̇` and `v_2 = g_s φ̇ + l_s t ψ̇ + p l̇`. A hoist whose speed jumps pulls both at once:
//! momenta along φ and ψ stay as they are, and what does not jump is φ̇ + η_1 l̇ and ψ̇ + η_2 l̇, which therefore are the states.

pub mod motion;
pub mod posture;
pub mod pulls;
pub(super) mod small;
pub mod symbols;
