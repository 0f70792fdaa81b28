//! What all luffing mechanisms have in common.

pub mod aboard;
pub mod at_rest;
pub mod balancing;
pub mod boom_scene;
pub mod counterweight;
pub mod criteria;
pub mod curved_trunk;
pub mod double_link;
pub mod ellipsograph;
pub mod kinds;
pub mod led;
pub mod luffed;
pub mod moving;
pub mod resistances;
pub mod rig;
pub mod rope;
pub mod strength;
pub mod with_balance;
