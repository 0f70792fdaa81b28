//! The crane on a hull as a scene gives it: a head of a given reach, or a luffing mechanism.

use crate::afloat::crane::TurningMass;
use crate::afloat::driving::LuffingCommand;
use crate::afloat::luffed::Luffer;
use crate::afloat::symbols as s;
use crate::afloat::weights::CranePlace;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::luffing::kinds::{CARRIED, carried};

pub static PEDESTAL: &[Key] = keys! { s: X_S, Y_S [usually(0.0)], H_S [or_input, optional], H_1 [optional] };

pub static TURNING: &[Key] = keys! { s: G_U [or_mass], X_U, Y_U [usually(0.0)], Z_U };

/// What a crane without a luffing mechanism has no use for, besides the table of what moves.
const LUFFING: [&str; 3] = ["theta_1", "omega_c1", "turning"];

/// Where head and crane are, and what of it slews.
pub struct CraneRig {
    pub reach: Option<One<f64>>,
    pub place: CranePlace<f64>,
    pub height: One<f64>,
    pub turning: Vec<TurningMass<f64>>,
    pub luffer: Option<Luffer>,
    /// LuffingMotion angle at the start, and what is commanded of it.
    pub held: Option<One<f64>>,
    pub command: LuffingCommand<f64>,
}

/// Refuses what is given twice, or not at all.
fn suits(v: &Values, pedestal: &Values, found: &mut Vec<Diagnostic>) {
    let luffs = v.has(CARRIED.name);
    let (reach, high, low) = (s::R.id, s::H_S.id, s::H_1.id);
    let mut refuse = |at: &Values, key: &str, what: String, label: &str, help: &str| {
        found.push(at.refuse(key, what, label, help));
    };
    match (luffs, v.has(reach)) {
        (true, true) => {
            let what = "`R` beside [luffing], whose bars give it".to_owned();
            refuse(v, reach, what, "given twice", "remove it, or [luffing]");
        }
        (false, false) => {
            let help =
                "give R = \"25 m\" with h_s in [hull.pedestal]; or [luffing] with its bars, and h_1 in [hull.pedestal]";
            refuse(
                v,
                reach,
                "a crane without a reach and without [luffing]".to_owned(),
                "R is missing in [hull]",
                help,
            );
        }
        _ => {}
    }
    let (own, other) = if luffs { (low, high) } else { (high, low) };
    if !pedestal.has(own) {
        let help = match luffs {
            true => "add h_1 = \"12 m\", the height of the luffing mechanism's foot above the keel",
            false => "add h_s = \"38 m\", the height of the load's point of suspension above the keel",
        };
        refuse(
            pedestal,
            own,
            format!("`{own}` is missing in [hull.pedestal]"),
            "how high?",
            help,
        );
    }
    if pedestal.has(other) {
        let (what, help) = match luffs {
            true => ("`h_s` beside [luffing], whose bars give it", "remove it, or [luffing]"),
            false => ("`h_1`, and nothing luffs", "remove it, or add [luffing]"),
        };
        refuse(pedestal, other, what.to_owned(), "not used", help);
    }
    if let Some(dynamics) = v.table("dynamics").filter(|table| luffs && !table.has(s::T_1.id)) {
        refuse(
            dynamics,
            s::T_1.id,
            "luffing by a command, and `T_1` is missing in [hull.dynamics]".to_owned(),
            "how fast does it follow?",
            "add T_1 = \"2 s\", the time constant with which luffing follows its command",
        );
    }
    let idle = LUFFING.into_iter().find(|key| !luffs && v.has(key)).map(|key| (v, key));
    let dynamics = v.table("dynamics").filter(|table| !luffs && table.has(s::T_1.id));
    if let Some((at, key)) = idle.or(dynamics.map(|table| (table, s::T_1.id))) {
        refuse(
            at,
            key,
            format!("`{key}`, and nothing luffs"),
            "not used",
            "add [luffing] with its bars, or remove it",
        );
    }
}

impl CraneRig {
    /// Of a hull that stands or moves under gravity (m/s²); mistakes go to `found`.
    pub fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<CraneRig> {
        let (before, pedestal) = (found.len(), v.table("pedestal")?);
        // Of a luffing mechanism that cannot stand here it has been told.
        if before > 0 && !v.has(CARRIED.name) && pedestal.has(s::H_1.id) {
            return None;
        }
        suits(v, pedestal, found);
        let moves = v.text("fidelity") == Some("swing");
        let table = v.table(CARRIED.name).filter(|_| found.len() == before);
        let luffer = table
            .and_then(|table| carried(table, gravity, moves, found))
            .map(Luffer);
        if found.len() > before {
            return None;
        }
        let one = |of: &Values, symbol: &'static Symbol| of.of(symbol).map(|value| One(symbol, value));
        let held = luffer.as_ref().map(|luffer| {
            let range = luffer.0.range();
            let at = v.number(s::THETA_1.id).unwrap_or(range.from);
            if at < range.from || at > range.to {
                let what = format!("theta_1 = {} at the start", s::THETA_1.written(at));
                let [from, to] = [range.from, range.to].map(|at| s::THETA_1.written(at));
                let help = format!("begin within [luffing.motion], from {from} to {to}");
                found.push(v.refuse(s::THETA_1.id, what, "beyond the working range of luffing", help));
            }
            One(&s::THETA_1, at)
        });
        Some(CraneRig {
            reach: one(v, &s::R),
            place: CranePlace::read(pedestal)?,
            height: one(pedestal, if luffer.is_some() { &s::H_1 } else { &s::H_S })?,
            turning: v
                .tables("turning")
                .iter()
                .map(TurningMass::read)
                .collect::<Option<_>>()?,
            luffer,
            held,
            command: LuffingCommand {
                omega_c1: v.number(s::OMEGA_C1.id).unwrap_or(0.0),
            },
        })
    }
}
