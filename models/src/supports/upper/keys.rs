//! What a scene says of what slews, and what of it there is.

use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::motion::Motion;
use crate::supports::drive::symbols as d;
use crate::supports::upper::symbols as s;

/// Most bodies, wind areas, and cases.
const MANY: usize = 64;

/// What a slewing drive asks of each load case, and of each wind area.
const OF_DRIVE: [Key; 3] = [
    Key::quantity(&d::N_S, Sign::NotNegative).optional(),
    Key::quantity(&d::ALPHA_Q, Sign::NotNegative).optional(),
    Key::quantity(&d::K_B, Sign::Positive).optional(),
];
const R_W: Key = Key::quantity(&d::R_W, Sign::Any).optional();

static BODY: &[Key] = keys! { s: G_U [or_mass], R_U, H_U [usually(0.0)] };
static CASE: &[Key] = keys! { s: K_Q >= 0 [usually(1.0)], P_W >= 0 [usually(0.0)], CHI_W [usually(0.0)];
OF_DRIVE[0], OF_DRIVE[1], OF_DRIVE[2] };
static AREA: &[Key] = keys! { s: A_W >= 0, H_W; R_W };
static STEEP: &[Key] = keys! { s: GAMMA >= 0, H_Q };
const RANGE: &[Key] = &Motion::keys([&s::FROM, &s::TO], &s::PSI, (&s::OMEGA, "Angular velocity of slewing."));

pub const UPPER: Key = Key::new(
    "upper",
    Kind::Tables(BODY, MANY),
    "Bodies of the upper works, with boom and counterweight.",
);
pub const LOAD_CASES: Key = Key::new(
    "load_cases",
    Kind::Tables(CASE, MANY),
    "Load cases: how the load counts, and the wind.",
);
pub const AREAS: Key = Key::new(
    "areas",
    Kind::Tables(AREA, MANY),
    "Areas of what slews on which the wind acts, with their heights.",
)
.optional();
pub const SLOPE: Key = Key::part("slope", STEEP, "Slope on which the crane stands.");
pub const MOTION: Key = Key::table(
    "motion",
    RANGE,
    "Working range of slewing, over which the loads are looked through.",
);

/// Whether there is a result of what slews: without slope and wind there is nothing of them.
pub fn has(symbol: &Symbol, [inclined, blown]: [bool; 2]) -> bool {
    let of = |there: &[&Symbol]| there.contains(&symbol);
    (inclined || !of(listed!(s: S_U, M_GAMMA))) && (blown || !of(listed!(s: A_SUM, S_W, BETA_W, F_W, M_W)))
}
