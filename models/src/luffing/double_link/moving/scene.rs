//! What a scene says about the double link in motion.

use std::ops::{Deref, DerefMut};

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::{Key, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::double_link::moving::built::Inertias;
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::symbols as l;
use crate::luffing::led::scene::ROPE;
use crate::luffing::moving::scene::{self, Inert, dynamics, turns};

/// How deep the mechanism is modelled.
pub const FIDELITIES: &[&str] = &["static", "table", "rigid", "swing", "hydraulic", "auto"];

/// Keys of `[luffing.dynamics]`.
pub static KEYS: &[Key] = &dynamics::<20>(&[
    Key::quantity(&s::J_1, Sign::NotNegative),
    Key::quantity(&s::J_2, Sign::NotNegative),
    Key::quantity(&s::J_3, Sign::NotNegative),
]);

const INERTIAS: &[&Symbol] = listed!(s: J_1, J_2, J_3);

/// The mechanism in motion as the scene describes it; SI.
#[derive(Clone, Copy, Debug)]
pub struct MovingLink {
    pub inertias: Inertias<f64>,
    moving: scene::Moving,
}

impl Deref for MovingLink {
    type Target = scene::Moving;
    fn deref(&self) -> &scene::Moving {
        &self.moving
    }
}

impl DerefMut for MovingLink {
    fn deref_mut(&mut self) -> &mut scene::Moving {
        &mut self.moving
    }
}

impl MovingLink {
    /// As [`scene::Moving::new`].
    pub fn new(v: &Values, gravity: f64, loaded: bool, found: &mut Vec<Diagnostic>) -> Option<MovingLink> {
        let bodies = Inert {
            loaded,
            inertias: INERTIAS,
            bar: match v.text("driven") {
                Some("boom") => [&l::X_1, &s::J_1],
                _ => [&l::X_3, &s::J_3],
            },
            reach: &l::X_1,
            help: "add [luffing.dynamics] with J_1, J_2 and J_3 (kg.m2)",
            bodies: "boom, jib and rocker",
            weighs: |weights| {
                let jib = weights.number(l::G_2.id).is_some_and(|weight| weight > 0.0);
                jib || turns(weights, &l::G_1, &l::S_1) || turns(weights, &l::G_3, &l::S_3)
            },
            leads: Some(ROPE.name),
        };
        let moving = scene::Moving::new(v, gravity, &bodies, found)?;
        let inertias = Inertias::read(v.table("dynamics")?)?;
        Some(MovingLink { inertias, moving })
    }
}
