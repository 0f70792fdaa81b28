//! Keys of the table `[luffing.synthesis]`.

use crate::balance::symbols as s;
use crate::kernel::keys::keys;
use crate::kernel::schema::{COUNTLESS, Key, Kind, SOURCE};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;

/// Keys of `[luffing.synthesis]`.
pub static KEYS: &[Key] = &[
    Key::choice(
        "method",
        &["optimum", "three", "four"],
        "Global optimum; three positions of equal energy; four positions, the first two infinitely close (Burmester).",
    ),
    Key::choice(
        "objective",
        &["dM_max", "E", "N_max", "dM_95"],
        "What the optimum minimises: the greatest residual, the integral of its amount, the greatest rod force, or the \
               residual that 95 % of all builds stay below.",
    ),
    Key::choice(
        "branch",
        &["left", "right"],
        "Side of the line from the lever's pivot to the joint on the boom on which the rod meets the lever; both where it is left out.",
    ),
    Key::new(
        "seed",
        Kind::Count([0, COUNTLESS]),
        "Seed of the search: the same seed gives the same lever.",
    )
    .optional(),
    Key::part(
        "bounds",
        BOUNDS,
        "Smallest and greatest value of each dimension; a single value fixes it.",
    ),
    Key::part("constraints", CONSTRAINTS, "What every solution keeps."),
    Key::part("tolerances", TOLERANCES, "Tolerances of manufacturing."),
    Key::part(
        "positions",
        POSITIONS,
        "What the methods of three and of four positions start from.",
    ),
    Key::new(
        "candidates",
        Kind::Tables(CANDIDATE, 100),
        "Levers that the book compares.",
    )
    .optional(),
    Key::choice(
        "found",
        &["complete", "broken off"],
        "Written by `lemnis synth`: [luffing.balance] is its result, and whether the search came to its end.",
    ),
    SOURCE,
];

const fn bounds(symbol: &'static Symbol, sign: Sign) -> Key {
    Key::new(symbol.id, Kind::Quantities(symbol, sign, [1, 2]), symbol.text).optional()
}

/// Keys of its table `bounds`.
pub static BOUNDS: &[Key] = &[
    bounds(&s::D_1, Sign::Positive),
    bounds(&s::DELTA_1, Sign::Any),
    bounds(&s::R_K, Sign::Positive),
    bounds(&s::ALPHA_K, Sign::Any),
    bounds(&s::L_1, Sign::Positive),
    bounds(&s::R_L, Sign::Positive),
    bounds(&s::CHI_5, Sign::Any),
    bounds(&s::M_5, Sign::NotNegative),
    SOURCE,
];

static CONSTRAINTS: &[Key] = keys! { s:
    GAMMA_MIN >= 0 [optional], N_MAX > 0 [optional], DM_MAX > 0 [optional], M_PLUS >= 0 [optional];
    Key::choice("ends", &["stable", "any"], "Stable: at both ends the residual turns the boom inwards. [Balance004, eq. 6-7]"),
    Key::choice("counterweight", &["rearward", "any"], "Rearward: the counterweight stays behind the lever's pivot.")
};

static TOLERANCES: &[Key] = &[
    Key::named("length", &s::T_L, Sign::NotNegative, s::T_L.text).optional(),
    Key::named("angle", &s::T_A, Sign::NotNegative, s::T_A.text).optional(),
    Key::named("weight", &s::T_W, Sign::NotNegative, s::T_W.text).optional(),
    SOURCE,
];

static POSITIONS: &[Key] = keys! { s:
    PSI_1, M_5 > 0, R_K > 0 [optional], ALPHA_K [optional], R_L > 0 [optional];
    Key::new(
        "phi",
        Kind::Quantities(&s::PHI, Sign::Any, [3, 3]),
        "Three boom angles; of four positions the first counts twice.",
    )
};

static CANDIDATE: &[Key] = keys! { s:
    D_1 > 0, DELTA_1, R_K > 0, ALPHA_K, L_1 > 0, R_L > 0, CHI_5, M_5 >= 0;
    Key::new(
        "role",
        Kind::Choice(&["existing", "published", "start", "rod_force", "counterweight"]),
        "A lever to compare with, one that the search starts from, or a point of the front against the rod force or \
               against the counterweight.",
    ),
    Key::choice("branch", &["left", "right"], "Side on which the rod meets the lever; left as in Balance004 where it is left out.")
};
