//! What a scene says of what slews, and what of it there is.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::kinds::CARRIED;
use crate::luffing::luffed::Luffer;
use crate::luffing::rig::{GivenCrane, LUFFED};
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
static STEEP: &[Key] = keys! { s: GAMMA >= 0, H_Q [optional] };
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

/// The reach or the luffing mechanism of a crane on a slewing support under gravity (m/s²): with a slope its heights count. Mistakes
/// go to `found`.
pub fn rig(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<GivenCrane> {
    let rig = GivenCrane::read(v, ("supports", &[s::THETA_1.id, s::H_1.id]), gravity, false, found);
    let Some(slope) = v.table("slope") else { return rig };
    let (hook, foot) = (s::H_Q.id, s::H_1.id);
    let refused = match (v.has(CARRIED.name), slope.stands(hook), v.stands(foot)) {
        // Of one that cannot be read it has been told.
        (false, false, _) if found.is_empty() => {
            let help = "add h_Q = \"22 m\", the height above the slewing support from which the load hangs";
            slope.refuse(hook, "`h_Q` is missing in [supports.slope]", "how high?", help)
        }
        (true, true, _) => {
            let what = "`h_Q` beside [luffing], whose bars give it";
            slope.refuse(hook, what, "given twice", "remove it, or [luffing]")
        }
        (true, _, false) => {
            let help = "add h_1 = \"6 m\", the height of the luffing mechanism's foot above the slewing support";
            v.refuse(foot, "`h_1` is missing in [supports]", "on a slope heights count", help)
        }
        _ => return rig,
    };
    found.push(refused);
    None
}

/// The height from which the load hangs on a slope, where no luffing mechanism gives it.
pub fn hook(v: &Values) -> Option<One<f64>> {
    let height = v.table("slope").and_then(|slope| slope.of(&s::H_Q));
    height.map(|height| One(&s::H_Q, height))
}

/// Id of the sentence that says at which level it is modelled.
pub fn level(luffer: &Option<Luffer>) -> &'static str {
    match luffer {
        Some(_) => LUFFED,
        None => "upper_level_static",
    }
}

/// Whether there is a result of what slews: without slope and wind there is nothing of them; where nothing luffs the
/// height of the load is given.
pub fn has(symbol: &Symbol, [inclined, blown, luffs]: [bool; 3]) -> bool {
    let of = |there: &[&Symbol]| there.contains(&symbol);
    (inclined || !of(listed!(s: S_U, M_GAMMA)))
        && ((inclined && luffs) || !of(&[&s::H_Q]))
        && (blown || !of(listed!(s: A_SUM, S_W, BETA_W, F_W, M_W)))
}
