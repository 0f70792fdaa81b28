//! What the descriptions of all single booms that may move have in common: their levels.

use crate::component::mechanism::Solver;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::symbols as s;
use crate::parts::air::AROUND;

/// What the rates cost, in s, without a load that swings and with it.
const COST: [[f64; 2]; 2] = [[0.1e-6, 0.0], [0.15e-6, 0.0]];

/// The levels to which a scene may be simplified, the quickest first.
#[must_use]
pub fn levels(moving: Option<&Moving>) -> Vec<&'static str> {
    let mut levels = vec!["table", "static"];
    if let Some(moving) = moving {
        levels.push("rigid");
        levels.extend(moving.rope.map(|_| "swing"));
    }
    levels
}

/// Leaves out what a level has not; whether it still moves.
pub fn set_level(moving: &mut Option<Moving>, level: &str) -> bool {
    match (level, &mut *moving) {
        ("swing", _) => {}
        ("rigid", Some(moving)) => moving.leave_rope(),
        _ => *moving = None,
    }
    moving.is_some()
}

/// Tables that a level does not use, with their keys where it uses others.
#[must_use]
pub fn unused(level: &str, moving: Option<&Moving>) -> Vec<(&'static str, &'static [&'static str])> {
    let mut unused: Vec<(&'static str, &'static [&'static str])> = match level {
        "static" | "table" => vec![
            ("dynamics", &[]),
            ("hoisting", &[]),
            ("air", &[]),
            ("ground", &[]),
            ("slewing", &[]),
            ("control", &[]),
            ("hydraulics", &[]),
        ],
        "rigid" | "swing" => vec![("hydraulics", &[])],
        _ => vec![("dynamics", &["M_A", "M_S"]), ("control", &[])],
    };
    let rope = moving.is_some_and(|moving| moving.rope.is_some());
    let side = moving.is_some_and(|moving| moving.area.is_some());
    if !(rope && matches!(level, "swing" | "hydraulic")) {
        unused.extend([
            ("slewing", &["chi_R"][..]),
            ("hoisting", &[]),
            ("air", if side { &AROUND } else { &[] }),
            ("ground", &[]),
            ("dynamics", &["l_R", "phi_R", "v_h", "a_h"][..]),
            ("limits", &["phi_max"][..]),
        ]);
    }
    unused
}

#[must_use]
pub fn solver(moving: Option<&Moving>) -> Option<Solver> {
    moving.map(|moving| {
        let cost = COST[usize::from(moving.rope.is_some())];
        Solver::explicit(&s::STEP, moving.constants.step, cost)
    })
}

/// What no book of such a mechanism calculates, without what its motion does; `friction` is that of its pins.
#[must_use]
pub fn uncovered(friction: &'static str, moving: Option<&Moving>) -> Vec<&'static str> {
    let rope = moving.and_then(|moving| moving.rope);
    let wind = match rope.and_then(|rope| rope.air) {
        Some(_) => "wind_on_structure",
        None => "wind",
    };
    let sway = rope.is_none().then_some("sway");
    let moves = moving.is_none().then_some(["inertia", friction]);
    std::iter::once(wind)
        .chain(sway)
        .chain(moves.into_iter().flatten())
        .chain([
            "dynamic_coefficients",
            "motor_brake",
            "strength",
            "buckling",
            "stability",
            "load_cases",
        ])
        .collect()
}

/// Levels of the description of a boom whose scene has its motion in `moving`, and the inertias that only the motion asks for
/// in a field of what it is given: what stands in its `Described`.
macro_rules! boom_levels {
    ($scene:ident with $inertias:ident) => {
        fn hangs_on(this: &Description<Self>) -> Option<[f64; 2]> {
            this.moving.as_ref()?.swings()
        }

        fn hang(&mut self, length: f64) {
            if let Some(rope) = self.moving.as_mut().and_then(|moving| moving.rope.as_mut()) {
                rope.length = length;
            }
        }

        fn levels(&self) -> Vec<&'static str> {
            $crate::luffing::moving::levels::levels(self.moving.as_ref())
        }

        fn set_level(&mut self, level: &str) {
            if !$crate::luffing::moving::levels::set_level(&mut self.moving, level) {
                self.given.$inertias = None;
            }
        }

        fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
            $crate::luffing::moving::levels::unused(level, self.moving.as_ref())
        }

        fn solver(&self) -> Option<$crate::component::mechanism::Solver> {
            $crate::luffing::moving::levels::solver(self.moving.as_ref())
        }

        fn moving(
            this: &Description<$scene>,
        ) -> Option<Result<$crate::component::moving::MovingComponent, $crate::kernel::variable::Fault>> {
            $crate::luffing::moving::told::shown::running(this)
        }

        fn follows(
            model: &$crate::component::moving::MovingComponent,
        ) -> Vec<std::collections::BTreeSet<$crate::kernel::variable::Name>> {
            $crate::luffing::moving::follows::follows::<<Self as Described>::Component>(model)
        }
    };
}
pub(crate) use boom_levels;
