//! What a scene may say about the steering of a machine.

use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, SOURCE};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Enumeration, Symbol};
use crate::parts::motion::Motion;
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
    Key::quantity(&s::X_C, Sign::Any).optional(),
    Key::quantity(&s::Y_C, Sign::Any).optional(),
    Key::new("groups", Kind::Tables(GROUP, GROUPS[1]), "The steered groups; the first one is the base group, whose angle commands."),
    Key::part("outline", OUTLINE, "Outline of the machine; without it as far as the groups reach."),
    Key::part("load", LOAD, "Weight and centre of gravity, where the groups do not give their loads."),
    Key::part("range", RANGE, "How far the groups turn; without it as far as their cylinders turn them."),
    Key::table(
        "motion",
        MOTION,
        "Working range of the commanded angle, and travel speed.",
    ),
    Key::part("tyre", TYRE, "Tyres and ground."),
    Key::part("ring", RING, "Slewing ring of a group."),
    Key::part("cylinder", CYLINDER, "Steering cylinder of a group."),
    Key::part("accuracy", ACCURACY, "How exactly the groups' angles are kept: from it follows the slip of the tyres."),
    Key::part("transition", TRANSITION, "How fast the groups turn when the mode changes: from it follow set points."),
    Key::part("hydraulics", HYDRAULICS, "Oil supply, and what the book checks the cylinder by."),
    Key::choice("fidelity", FIDELITIES, "How deep the steering is modelled: groups that stand as commanded (kinematic), or that are turned by their cylinders under the PLC (hydraulic), or as deep as the scene's accuracy needs (auto); without it kinematic."),
    Key::part(TABLES[0].0, TABLES[0].1, TABLES[0].2),
    Key::part(TABLES[1].0, TABLES[1].1, TABLES[1].2),
    Key::part(TABLES[2].0, TABLES[2].1, TABLES[2].2),
    SOURCE,
];

static GROUP: &[Key] = &[
    Key::quantity(&s::X, Sign::Any),
    Key::quantity(&s::Y, Sign::Any),
    Key::weight(&s::G).optional(),
    angle("min", &s::THETA_MIN).optional(),
    angle("max", &s::THETA_MAX).optional(),
    FORBIDDEN,
    Key::choice(
        "cylinder",
        &["direct", "mirrored"],
        "Whether the cylinder lengthens (direct) or shortens when the group turns counter-clockwise.",
    ),
    SOURCE,
];

static OUTLINE: &[Key] = &[
    angle("front", &s::E_F),
    angle("rear", &s::E_R),
    angle("left", &s::E_LEFT),
    angle("right", &s::E_RIGHT),
    SOURCE,
];

static LOAD: &[Key] = keys! { s: W [or_mass], X_G, Y_G };

static RANGE: &[Key] = &[
    angle("min", &s::THETA_MIN),
    angle("max", &s::THETA_MAX),
    FORBIDDEN,
    SOURCE,
];

/// Where a group must not turn.
const FORBIDDEN: Key = Key::new("forbidden", Kind::Texts(8), "Ranges through which a group must not turn, each by its two ends: \"20 deg, 25 deg\"; a group's own ones take the place of those of all.").optional();

const MOTION: &[Key] = {
    let [from, to, step, speed, input, source] =
        Motion::keys([&s::FROM, &s::TO], &s::THETA_B, (&s::OMEGA_S, s::OMEGA_S.text));
    &[from, to, step, speed, Key::quantity(&s::V_T, Sign::Any), input, source]
};

static TYRE: &[Key] = keys! { s: F_T >= 0, P_T > 0, K_V > 0 };

static RING: &[Key] = keys! { s:
    L_MAX >= 0, F_S > 0, K_TEST > 0, MU_R >= 0, D_L > 0;
    Key::new(
        "catalogue",
        Kind::Tables(CATALOGUE, 100),
        "Rings with their load curves, from the smallest to the greatest.",
    )
    .optional()
};

static CATALOGUE: &[Key] = &[
    Key::new("name", Kind::Name, "Name of the ring."),
    Key::quantity(&s::D_L, Sign::Positive),
    Key::new(
        "ring",
        Kind::Texts(100),
        "Load curve of the ring, points of force and moment with rising force: \"400 kN, 280 kN.m\".",
    ),
    Key::new("bolts", Kind::Texts(100), "Load curve of its bolts, likewise."),
];

static CYLINDER: &[Key] = keys! { s: R_C > 0, ALPHA, L_X > 0, L_A >= 0, D_G > 0, D > 0 };

static ACCURACY: &[Key] = keys! { s: RESOLUTION >= 0, DEAD_BAND >= 0, SLIP_LIMIT > 0 [optional] };

static TRANSITION: &[Key] = &[
    Key::quantity(&s::V_C_MAX, Sign::Positive),
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

static HYDRAULICS: &[Key] = keys! { s: P > 0, N > 0, ETA_V > 0, K_R > 0, E > 0, NU > 0 };

/// A quantity under a name of its own.
const fn angle(name: &'static str, symbol: &'static Symbol) -> Key {
    Key::named(name, symbol, Sign::Any, symbol.text)
}
