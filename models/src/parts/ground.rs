//! Ground on which a load is put down and from which it is picked up: it bears, N ≥ 0, and never holds down.
//!
//! What stands on it stays where it is, as friction holds it; the blow of touching it is plastic and the load's alone, as
//! the force of a rope that gives way is finite.

use nalgebra::Vector3;

use crate::kernel::calc::{Calc, Over};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::quantities;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::symbols;
use crate::parts::air::Stream;
use crate::parts::ground as s;

symbols! {
    // Given.
    Y_G: "y_G" "y_G" M / M, "Ground: height of the load's point that hangs on the rope where the load stands on it, counted as that of the head.", "input";

    // The load above and on it.
    H_G: "h_G" "h_G" M / M, "Height of the load above the ground; zero where it stands on it.", "derived";
    N_G: "N_G" "N_G" N / KN [not_negative], "Force of the ground on the load that stands on it.", "equilibrium";
    Z_GROUND: "z.ground" "z_16" ONE / ONE, "Falls below zero where the load touches the ground, or is lifted from it.", "event";
}

quantities! {
    /// Of the ground below a load.
    GroundBelow { y_g: Y_G }
}

/// The table of a scene that has the ground below a load on a rope that gives way.
pub const GROUND: Key = Key::part(
    "ground",
    GROUND_KEYS,
    "Ground on which the load is put down and from which it is picked up.",
);

static GROUND_KEYS: &[Key] = keys! { s: Y_G };

/// How far below the ground a load must be to touch it, in m: rounding alone must not put down what was just lifted.
const GRAZE: f64 = 1e-11;

/// The ground that a table has below a load on a rope of which it is known whether it gives way.
pub fn below(table: &Values, gives: bool, found: &mut Vec<Diagnostic>) -> Option<GroundBelow<f64>> {
    if !gives {
        let what = "ground below a load on a rope that keeps its length";
        let label = "the rope's force would jump as the load is lifted";
        let help = "add c_R = \"... kN/m\", the rope's stiffness from head to load, or remove this table";
        found.push(Diagnostic::new(table.span.clone(), what, label).help(help));
        return None;
    }
    Some(GroundBelow { y_g: table.of(&Y_G)? })
}

/// What acts on a load besides its rope.
#[derive(Clone, Copy, Debug)]
pub enum Surroundings<'a, C> {
    /// Gravity (m/s²), and air where there is any.
    Free {
        gravity: Vector3<C>,
        air: Option<&'a Stream<C>>,
    },
    /// The ground, which takes all that acts on it.
    Ground,
}

/// How a load hangs above the ground (m), and which part of the rope's force lifts it.
#[derive(Clone, Copy, Debug)]
pub struct Raised<C> {
    pub height: C,
    pub upright: C,
}

impl<C: Calc> Raised<C> {
    /// Above a ground at a height (m), of a load at a height (m).
    pub fn above<P: Calc>(ground: P, height: C, upright: C) -> Raised<C>
    where
        C: Over<P>,
    {
        Raised {
            height: (height - C::of(ground)).def(&H_G),
            upright,
        }
    }

    /// Force of the ground, N = m g − S_R cos φ_R, on a load of a weight (N) that a rope pulls with a force (N); below zero
    /// it is lifted.
    pub fn bears(&self, weight: C, rope: C) -> C {
        (weight - rope * self.upright).def(&N_G)
    }

    /// Falls below zero where it touches the ground.
    pub fn touching(&self) -> C {
        self.height + C::constant(GRAZE)
    }
}
