//! The crane on what carries it, as a scene gives it: a head of a given reach, or a luffing mechanism.

use crate::component::sheet::Curve;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::luffing::aboard::{self as s, Aboard};
use crate::luffing::kinds::{CARRIED, carried};
use crate::luffing::luffed::Luffer;

/// Id of the sentence that says how a crane stands whose luffing mechanism gives reach and weights.
pub const LUFFED: &str = "carried_level";

/// The reach (m), or the luffing mechanism with its angle at the start (rad).
#[derive(Clone, Debug)]
pub struct GivenCrane {
    pub reach: Option<One<f64>>,
    pub luffer: Option<Luffer>,
    pub held: Option<One<f64>>,
}

/// Refuses a reach that is given twice, or not at all, and what is `idle` where nothing luffs.
fn suits(v: &Values, table: &str, idle: &[&str], found: &mut Vec<Diagnostic>) {
    let luffs = v.has(CARRIED.name);
    match (luffs, v.stands(s::R.id)) {
        (true, true) => {
            let what = "`R` beside [luffing], whose bars give it";
            found.push(v.refuse(s::R.id, what, "given twice", "remove it, or [luffing]"));
        }
        // Of one that cannot be read it has been told.
        (false, false) if found.is_empty() => {
            let what = "a crane without a reach and without [luffing]";
            let help = format!("give R = \"25 m\" in [{table}], or [luffing] with its bars");
            found.push(v.refuse(s::R.id, what, format!("R is missing in [{table}]"), help));
        }
        _ => {}
    }
    if let Some(key) = idle.iter().find(|key| !luffs && v.has(key)) {
        let help = "add [luffing] with its bars, or remove it";
        found.push(v.refuse(key, format!("`{key}`, and nothing luffs"), "not used", help));
    }
}

/// The luffing angle at the start, in rad: as given, or where its working range begins.
fn start(v: &Values, luffer: &dyn Aboard, found: &mut Vec<Diagnostic>) -> One<f64> {
    let range = luffer.range();
    let at = v.number(s::THETA_1.id).unwrap_or(range.from);
    if at < range.from || at > range.to {
        let [from, to, given] = [range.from, range.to, at].map(|at| s::THETA_1.written(at));
        let help = format!("begin within [luffing.motion], from {from} to {to}");
        let what = format!("theta_1 = {given} at the start");
        found.push(v.refuse(s::THETA_1.id, what, "beyond the working range of luffing", help));
    }
    One(&s::THETA_1, at)
}

impl GivenCrane {
    /// Of a table of the scene under gravity (m/s²), which has these keys besides for a luffing mechanism alone; its bodies with
    /// inertias where they `move`. Mistakes go to `found`.
    pub fn read(
        v: &Values,
        (table, idle): (&str, &[&str]),
        gravity: f64,
        moves: bool,
        found: &mut Vec<Diagnostic>,
    ) -> Option<GivenCrane> {
        let before = found.len();
        suits(v, table, idle, found);
        let bars = v.table(CARRIED.name).filter(|_| found.len() == before);
        let luffer = bars.and_then(|bars| carried(bars, gravity, moves, found)).map(Luffer);
        if found.len() > before {
            return None;
        }
        Some(GivenCrane {
            reach: v.of(&s::R).map(|value| One(&s::R, value)),
            held: luffer.as_ref().map(|luffer| start(v, &*luffer.0, found)),
            luffer,
        })
    }
}

impl Luffer {
    /// What `of` gives over its reach, by the luffing angle (rad) through its working range.
    pub fn over_reach(&self, id: &'static str, y: &'static Symbol, of: impl FnMut(f64) -> Option<[f64; 2]>) -> Curve {
        const STEPS: u32 = 60;
        let angles = (0..=STEPS).map(|i| self.0.range().at(f64::from(i) / f64::from(STEPS)));
        Curve {
            id,
            x: &s::R,
            y,
            pieces: vec![angles.filter_map(of).collect()],
            numbers: Vec::new(),
        }
    }
}
