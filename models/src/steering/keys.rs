//! What a scene may say about the steering of a machine.

use crate::kernel::schema::{Key, Kind, Sign};
use crate::kernel::symbol::{Enumeration, Symbol};
use crate::steering::machine::GROUPS;
use crate::steering::moving::scene::{FIDELITIES, TABLES};
use crate::steering::symbols as s;

/// What a scene calls the nine modes, what commands them, and the corners of the outline.
static MODES: [&str; 9] = names(&s::MODES);
static COMMANDS: [&str; 3] = names(&s::COMMANDS);
static CORNERS: [&str; 4] = names(&s::CORNERS);

const fn names<const N: usize>(of: &'static Enumeration) -> [&'static str; N] {
    let mut names = [""; N];
    let mut i = 0;
    while i < N {
        names[i] = of.items[i].0;
        i += 1;
    }
    names
}

/// Keys of `[steering]`.
pub static KEYS: &[Key] = &[
    Key::new("mode", Kind::Choice(&MODES), "Travel mode."),
    Key::new("command", Kind::Choice(&COMMANDS), "What commands front_axle, rear_axle and all_wheel; without it the angle of the base group, which is the first one.").optional(),
    Key::new("corner", Kind::Choice(&CORNERS), "About which corner of the outline the mode corner turns.").optional(),
    Key::quantity(&s::R_T, Sign::Any).optional(),
    Key::quantity(&s::O_CX, Sign::Any).optional(),
    Key::quantity(&s::O_CY, Sign::Any).optional(),
    Key::new("groups", Kind::Tables(GROUP, GROUPS[1]), "The steered groups; the first one is the base group, whose angle commands."),
    Key::table(
        "outline",
        OUTLINE,
        "Outline of the machine; without it as far as the groups reach.",
    )
    .optional(),
    Key::table(
        "load",
        LOAD,
        "Weight and centre of gravity, where the groups do not give their loads.",
    )
    .optional(),
    Key::table(
        "range",
        RANGE,
        "How far the groups turn; without it as far as their cylinders turn them.",
    )
    .optional(),
    Key::table(
        "motion",
        MOTION,
        "Working range of the commanded angle, and travel speed.",
    ),
    Key::table("tyre", TYRE, "Tyres and ground.").optional(),
    Key::table("ring", RING, "Slewing ring of a group.").optional(),
    Key::table("cylinder", CYLINDER, "Steering cylinder of a group.").optional(),
    Key::table(
        "accuracy",
        ACCURACY,
        "How exactly the groups' angles are kept: from it follows the slip of the tyres.",
    )
    .optional(),
    Key::table(
        "transition",
        TRANSITION,
        "How fast the groups turn when the mode changes: from it follow set points.",
    )
    .optional(),
    Key::table(
        "hydraulics",
        HYDRAULICS,
        "Oil supply, and what the book checks the cylinder by.",
    )
    .optional(),
    Key::new("fidelity", Kind::Choice(FIDELITIES), "How deep the steering is modelled: groups that stand as commanded (kinematic), or that are turned by their cylinders under the PLC (hydraulic), or as deep as the scene's accuracy needs (auto); without it kinematic.").optional(),
    Key::table(TABLES[0].0, TABLES[0].1, TABLES[0].2).optional(),
    Key::table(TABLES[1].0, TABLES[1].1, TABLES[1].2).optional(),
    Key::table(TABLES[2].0, TABLES[2].1, TABLES[2].2).optional(),
    SOURCE,
];

/// Where the quantities of a table come from that do not say it themselves.
const SOURCE: Key = Key::text(
    "source",
    "Where the quantities of this table come from: a drawing, a publication, an assumption.",
);

static GROUP: &[Key] = &[
    Key::quantity(&s::X_I, Sign::Any),
    Key::quantity(&s::Y_I, Sign::Any),
    Key::weight(&s::G).optional(),
    angle("min", &s::THETA_MIN).optional(),
    angle("max", &s::THETA_MAX).optional(),
    FORBIDDEN,
    Key::new(
        "cylinder",
        Kind::Choice(&["direct", "mirrored"]),
        "Whether the cylinder lengthens (direct) or shortens when the group turns counter-clockwise.",
    )
    .optional(),
    SOURCE,
];

static OUTLINE: &[Key] = &[
    angle("front", &s::E_F),
    angle("rear", &s::E_R),
    angle("left", &s::E_LEFT),
    angle("right", &s::E_RIGHT),
    SOURCE,
];

static LOAD: &[Key] = &[
    Key::weight(&s::W),
    Key::quantity(&s::X_G, Sign::Any),
    Key::quantity(&s::Y_G, Sign::Any),
    SOURCE,
];

static RANGE: &[Key] = &[
    angle("min", &s::THETA_MIN),
    angle("max", &s::THETA_MAX),
    FORBIDDEN,
    SOURCE,
];

/// Where a group must not turn.
const FORBIDDEN: Key = Key::new("forbidden", Kind::Texts(20), "Ranges through which a group must not turn, each by its two ends: \"20 deg, 25 deg\"; a group's own ones take the place of those of all.").optional();

static MOTION: &[Key] = &[
    Key::named("from", &s::THETA_B, Sign::Any, "Commanded angle at the start."),
    Key::named("to", &s::THETA_B, Sign::Any, "Commanded angle at the end."),
    Key::named("step", &s::THETA_B, Sign::Positive, "Step of tables."),
    Key::named(
        "speed",
        &s::OMEGA_S,
        Sign::Positive,
        "Steering speed: rate of the commanded angle.",
    ),
    Key::quantity(&s::V_T, Sign::Any),
    SOURCE,
];

static TYRE: &[Key] = &[
    Key::quantity(&s::F_T, Sign::NotNegative),
    Key::quantity(&s::P_T, Sign::Positive),
    Key::quantity(&s::K_V, Sign::Positive),
    SOURCE,
];

static RING: &[Key] = &[
    Key::quantity(&s::L_MAX, Sign::NotNegative),
    Key::quantity(&s::F_S, Sign::Positive),
    Key::quantity(&s::K_TEST, Sign::Positive),
    Key::quantity(&s::MU_R, Sign::NotNegative),
    Key::quantity(&s::D_L, Sign::Positive),
    Key::new(
        "catalogue",
        Kind::Tables(CATALOGUE, 100),
        "Rings with their load curves, from the smallest to the greatest.",
    )
    .optional(),
    SOURCE,
];

static CATALOGUE: &[Key] = &[
    Key::new("name", Kind::Text, "Name of the ring."),
    Key::quantity(&s::D_L, Sign::Positive),
    Key::new(
        "ring",
        Kind::Texts(100),
        "Load curve of the ring, points of force and moment with rising force: \"400 kN, 280 kN.m\".",
    ),
    Key::new("bolts", Kind::Texts(100), "Load curve of its bolts, likewise."),
];

static CYLINDER: &[Key] = &[
    Key::quantity(&s::R_C, Sign::Positive),
    Key::quantity(&s::ALPHA, Sign::Any),
    Key::quantity(&s::L_X, Sign::Positive),
    Key::quantity(&s::L_A, Sign::NotNegative),
    Key::quantity(&s::D_G, Sign::Positive),
    Key::quantity(&s::D, Sign::Positive),
    SOURCE,
];

static ACCURACY: &[Key] = &[
    Key::quantity(&s::Q_E, Sign::NotNegative),
    Key::quantity(&s::B_V, Sign::NotNegative),
    Key::quantity(&s::SLIP_LIMIT, Sign::Positive).optional(),
    SOURCE,
];

static TRANSITION: &[Key] = &[
    Key::quantity(&s::V_CX, Sign::Positive),
    Key::new(
        "from",
        Kind::Choice(&MODES),
        "Mode from which the change starts that the book draws; without it that of the scene.",
    )
    .optional(),
    Key::new(
        "to",
        Kind::Choice(&MODES),
        "Mode in which it ends; without it the one whose change from there takes longest.",
    )
    .optional(),
    SOURCE,
];

static HYDRAULICS: &[Key] = &[
    Key::quantity(&s::P, Sign::Positive),
    Key::quantity(&s::N, Sign::Positive),
    Key::quantity(&s::ETA, Sign::Positive),
    Key::quantity(&s::K_R, Sign::Positive),
    Key::quantity(&s::E, Sign::Positive),
    Key::quantity(&s::NU, Sign::Positive),
    SOURCE,
];

/// A quantity under a name of its own.
const fn angle(name: &'static str, symbol: &'static Symbol) -> Key {
    Key::named(name, symbol, Sign::Any, symbol.text)
}
