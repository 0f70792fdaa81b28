//! What a scene says of how a motor starts.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::motor::N_N;
use crate::parts::polyline::rising;
use crate::parts::starts::engine::{EngineSpeeds, EngineStart, POINT};
use crate::parts::starts::way::StartWay;
use crate::parts::starts::{self as s, InverterStart, SlipStart};

/// Beside the motor.
pub const START: Key = Key::part("start", KEYS, "How the motor starts, besides by its mean torque.");

/// Most points of an engine's curve.
const MANY: usize = 64;

const KEYS: &[Key] = keys! { s:
    LAMBDA_BD > 0 [optional], N_0 > 0 [optional], T_R > 0 [optional], LAMBDA_INV > 0 [optional], N_IDLE > 0 [optional], N_GOV > 0 [optional];
    Key::new("kind", Kind::Choice(&KINDS), "\"slip\", along the motor's own curve of torque over slip, \"inverter\", which ramps its speed up, or \"engine\", a combustion engine by a clutch from idle and along its curve of torque over speed."),
    Key::new("curve", Kind::Tables(CURVE, MANY), "Points of an engine's curve of torque over speed, with rising speed from idle or below to the governed speed or above.").optional()
};

static CURVE: &[Key] = keys! { s: N_EN > 0, T_EN > 0 };

/// Ways to start, and the quantities that each of them has.
const KINDS: [&str; 3] = ["slip", "inverter", "engine"];
const OWN: [&[&Symbol]; 3] = [
    listed!(s: LAMBDA_BD, N_0),
    listed!(s: T_R, LAMBDA_INV),
    listed!(s: N_IDLE, N_GOV),
];

/// Of the table of a start, which has the quantities of its own way alone, and of a motor with a rated speed (1/s); mistakes go
/// to `found`.
pub fn read(start: &Values, n_n: f64, found: &mut Vec<Diagnostic>) -> Option<StartWay<f64>> {
    let kind = start.text("kind").unwrap_or_default();
    for (other, symbols) in KINDS.into_iter().zip(OWN) {
        for symbol in symbols
            .iter()
            .filter(|symbol| start.stands(symbol.id) != (kind == other))
        {
            found.push(if kind == other {
                let what = format!("a start of kind \"{kind}\" without {}", symbol.id);
                let help = format!("add {} = \"... {}\"  ({})", symbol.id, symbol.display.name, symbol.text);
                start.refuse("kind", what, format!("{} is needed", symbol.id), help)
            } else {
                let what = format!("{} belongs to a start of kind \"{other}\"", symbol.id);
                start.refuse(symbol.id, what, "not used", "remove it, or change kind")
            });
        }
    }
    let engine = engine(start, n_n, kind == KINDS[2], found);
    let slip = SlipStart::read(start).filter(|_| kind == KINDS[0]);
    if let Some(slip) = slip.filter(|slip| slip.n_0 <= n_n) {
        let [own, rated] = [s::N_0.written(slip.n_0), N_N.written(n_n)];
        let what = format!("n_0 = {own} is not above n_N = {rated}");
        let help = "give the synchronous speed: a motor at its rated power turns more slowly";
        found.push(start.refuse(s::N_0.id, what, "no slip", help));
    }
    let inverter = InverterStart::read(start).filter(|_| kind == KINDS[1]);
    slip.map(StartWay::SlipStart)
        .or(inverter.map(StartWay::InverterStart))
        .or(engine.map(StartWay::EngineStart))
}

/// An engine of a rated speed (1/s), where it `is` one.
fn engine(start: &Values, n_n: f64, is: bool, found: &mut Vec<Diagnostic>) -> Option<EngineStart<f64>> {
    let (before, tables) = (found.len(), start.tables("curve"));
    if is == tables.is_empty() {
        let what = if is {
            "a start of kind \"engine\" without its curve"
        } else {
            "curve belongs to a start of kind \"engine\""
        };
        let (label, help) = if is {
            ("curve is needed", "add tables curve with n_en and T_en, at least two")
        } else {
            ("not used", "remove it, or change kind")
        };
        found.push(start.refuse(if is { "kind" } else { "curve" }, what, label, help));
    }
    let speeds = EngineSpeeds::read(start).filter(|_| is)?;
    let curve = rising(tables, POINT, ["the torque curve", "speed"], found)?;
    let (first, last) = (curve.first()?[0], curve.last()?[0]);
    let told = [speeds.idle, n_n, speeds.most, first, last].map(|n| s::N_EN.written(n));
    let [idle, rated, most, first_told, last_told] = &told;
    if speeds.idle >= n_n || n_n > speeds.most {
        let what = format!("n_N = {rated} is not between n_idle = {idle} and n_gov = {most}");
        let help =
            "an engine gives its rated power above idle, and not beyond the speed to which its governor lets it run";
        found.push(start.refuse(s::N_GOV.id, what, "not so", help));
    }
    if first > speeds.idle || last < speeds.most {
        let what = format!(
            "the torque curve goes from {first_told} to {last_told}, and the engine runs from {idle} to {most}"
        );
        let help = "give points of the curve from n_idle or below to n_gov or above";
        found.push(start.refuse("curve", what, "too short", help));
    }
    (found.len() == before).then_some(EngineStart { speeds, curve })
}
