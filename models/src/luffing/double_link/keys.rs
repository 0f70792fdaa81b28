//! Keys of a double link in a scene.

use crate::balance::asked::KEYS as SYNTHESIS;
use crate::balance::scene::BALANCE;
use crate::component::description::TABLE;
use crate::component::outline::{Limit, joined};
use crate::drive::scene::DRIVE;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, SOURCE};
use crate::kernel::sign::Sign;
use crate::luffing::double_link::moving;
use crate::luffing::double_link::outline::OUTLINE;
use crate::luffing::double_link::symbols as s;
use crate::luffing::led::scene::ROPE;
use crate::luffing::moving::control::luffing::CONTROL;
use crate::luffing::moving::hoisting::HOISTING_KEYS;
use crate::luffing::moving::oil_scene::HYDRAULICS;
use crate::luffing::moving::scene::SLEWING;
use crate::luffing::resistances::scene::CASES;
use crate::parts::air::AIR_OR_WIND;
use crate::parts::ground::GROUND;
use crate::parts::motion::Motion;

/// Those of its bars.
pub const LINKS: [Key; 13] = [
    Key::kind(
        &["double_link"],
        "A double link of boom, jib and rocker; the usual kind.",
    ),
    Key::new(
        "driven",
        Kind::Choice(&["boom", "rocker"]),
        "Which bar the drive turns; its angle is the coordinate.",
    ),
    Key::new(
        "branch",
        Kind::Choice(&["left", "right"]),
        "Side of the line from the foot of the other bar to the driving link's head on which the jib's other pin lies.",
    ),
    Key::quantity(&s::X_1, Sign::Positive),
    Key::quantity(&s::X_2, Sign::Positive),
    Key::quantity(&s::X_3, Sign::Positive),
    Key::quantity(&s::X_4, Sign::Positive),
    Key::quantity(&s::X_5, Sign::Any),
    Key::quantity(&s::X_6, Sign::Any),
    Key::quantity(&s::X_8, Sign::Any),
    Key::quantity(&s::X_7, Sign::Any).optional(),
    Key::quantity(&s::BETA_0, Sign::Positive).optional(),
    Key::quantity(&s::AC, Sign::Positive).optional(),
];

/// Keys of `[luffing]`.
pub const KEYS: &[Key] = &joined::<_, 13, 20, 33>(LINKS, [
    Key::weight(&s::Q).optional(),
    ROPE,
    Key::new("fidelity", Kind::Choice(moving::scene::FIDELITIES), "How deep it is modelled: \"static\" (the angle is an input), \"table\" (the same, interpolated over the working range, its dimensions fixed), \"rigid\" (it moves under a moment), \"swing\" (and the load swings on its rope), \"hydraulic\" (a cylinder with oil and valve moves it), \"auto\" (the cheapest that keeps to `accuracy`).").optional(),
    Key::table("motion", MOTION, "Working range of the driving link."),
    Key::part("weights", WEIGHTS, "Own weights and their centres of gravity."),
    BALANCE,
    DRIVE,
    Key::part("synthesis", SYNTHESIS, "What `lemnis synth` finds."),
    Key::part("dynamics", moving::scene::KEYS, "Inertias, friction, drive and rope of a mechanism in motion."),
    CONTROL,
    HOISTING,
    AIR_OR_WIND,
    GROUND,
    HYDRAULICS,
    Key::part("table", TABLE, "Interpolation of the level \"table\"."),
    SLEWING,
    CASES,
    Key::part("limits", LIMITS, "Limits that the book checks."),
    Key::part("published", PUBLISHED, "Published values to stand beside the computed ones."),
    SOURCE,
]);

/// A part of a crane that may also stand beside `[luffing]`, at the top of the scene.
pub const HOISTING: Key = Key::part("hoisting", HOISTING_KEYS, "Rope and hoist of a load that swings.");

const MOTION: &[Key] = &Motion::keys(
    [&s::FROM, &s::TO],
    &s::THETA_1,
    (&s::OMEGA_1, "Angular velocity of the driving link."),
);

pub static WEIGHTS: &[Key] = keys! { s:
    G_1 [or_mass], S_1 >= 0, CHI_1, G_2 [or_mass], S_2 >= 0, CHI_2, G_3 [or_mass], S_3 >= 0, CHI_3
};

const LIMITS: &[Key] = &Limit::keys::<26>(OUTLINE.limits);

static PUBLISHED: &[Key] = &[
    Key::new("source", Kind::Text, "Where the values are printed."),
    Key::new(
        "values",
        Kind::Lines,
        "A line of names, then lines of values in display units; the first column is the angle of the driving link.",
    ),
];
