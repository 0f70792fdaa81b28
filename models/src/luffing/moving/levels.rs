//! What the descriptions of all mechanisms that may move have in common: their levels.

use crate::component::mechanism::Solver;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::symbols as s;
use crate::parts::air::AROUND;
use crate::parts::hydraulics::parts::OilParts;

/// What the rates of single booms cost, in s, without a load that swings and with it.
pub const BOOM: [f64; 2] = [0.1e-6, 0.15e-6];
/// With oil, and with these their Jacobian and its factors.
const OIL: [f64; 2] = [0.22e-6, 1.0e-6];

/// The levels to which a scene may be simplified, the quickest first.
#[must_use]
pub fn levels(moving: Option<&Moving>) -> Vec<&'static str> {
    let mut levels = vec!["table", "static"];
    if let Some(moving) = moving {
        levels.push("rigid");
        levels.extend(moving.rope.map(|_| "swing"));
        levels.extend(moving.oil.map(|_| "hydraulic"));
    }
    levels
}

/// Leaves out what a level has not; whether it still moves.
pub fn set_level(moving: Option<&mut Moving>, level: &str) -> bool {
    let Some(moving) = moving else { return false };
    match level {
        "rigid" => {
            moving.leave_rope();
            moving.oil = None;
        }
        "swing" => moving.oil = None,
        "hydraulic" => moving.controllers = moving.controllers.and_then(|all| all.without(0)),
        _ => return false,
    }
    true
}

/// How deep it is modelled, in words.
#[must_use]
pub fn assumed(moving: &Moving) -> &'static str {
    match (moving.oil, moving.rope) {
        (Some(_), _) => "level_hydraulic",
        (None, Some(_)) => "level_swing",
        (None, None) => "level_rigid",
    }
}

/// What is taken for granted of its oil, its friction and stops, its forces and its solver, in words.
pub fn solved(moving: &Moving) -> impl Iterator<Item = &'static str> + use<> {
    let (oil, parts) = (moving.oil.is_some(), moving.oil_parts);
    let given = |known: bool, id: &'static str| known.then_some(id);
    let has = |part: fn(&OilParts) -> bool, id| given(parts.as_ref().is_some_and(part), id);
    let all = [
        given(oil, "oil"),
        has(|parts| parts.anti_cavitation.is_some(), "anti_cavitation"),
        has(|parts| parts.load_holding.is_some(), "load_holding"),
        has(|parts| parts.pump.is_some(), "pump_limits"),
        has(|parts| parts.tank.is_some(), "tank"),
        Some(if oil { "creep" } else { "sticking" }),
        Some(if oil { "buffer" } else { "stops" }),
        Some("forces_in_motion"),
        Some(if oil { "solver_rodas" } else { "solver_runge_kutta" }),
    ];
    all.into_iter().flatten()
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

/// Its solver, by what its rates cost (s) without a load that swings and with it.
#[must_use]
pub fn solver(moving: Option<&Moving>, [rigid, swing]: [f64; 2]) -> Option<Solver> {
    moving.map(|moving| Solver {
        step: ("dynamics", &s::STEP),
        tolerance: ("hydraulics", &s::TOL),
        longest: moving.constants.step,
        explicit: moving.oil.is_none(),
        cost: match (&moving.oil, &moving.rope) {
            (Some(_), _) => OIL,
            (None, Some(_)) => [swing, 0.0],
            (None, None) => [rigid, 0.0],
        },
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
            if !$crate::luffing::moving::levels::set_level(self.moving.as_mut(), level) {
                (self.moving, self.given.$inertias) = (None, None);
            }
        }

        fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
            $crate::luffing::moving::levels::unused(level, self.moving.as_ref())
        }

        fn solver(&self) -> Option<$crate::component::mechanism::Solver> {
            $crate::luffing::moving::levels::solver(self.moving.as_ref(), $crate::luffing::moving::levels::BOOM)
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
