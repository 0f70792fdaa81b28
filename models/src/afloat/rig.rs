//! The crane on a hull as a scene gives it: a head of a given reach, or a luffing mechanism.

use crate::afloat::crane::TurningMass;
use crate::afloat::driving::LuffingCommand;
use crate::afloat::symbols as s;
use crate::afloat::weights::CranePlace;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::luffing::kinds::CARRIED;
use crate::luffing::rig::GivenCrane;

pub static PEDESTAL: &[Key] = keys! { s: X_S, Y_S [usually(0.0)], H_S [or_input, optional], H_1 [optional] };

pub static TURNING: &[Key] = keys! { s: G_U [or_mass], X_U, Y_U [usually(0.0)], Z_U };

/// What a crane without a luffing mechanism has no use for, besides the table of what moves.
const LUFFING: [&str; 3] = ["theta_1", "omega_c1", "turning"];

/// Where head and crane are, and what of it slews.
pub struct CraneRig {
    pub place: CranePlace<f64>,
    pub height: One<f64>,
    pub turning: Vec<TurningMass<f64>>,
    pub rig: GivenCrane,
    /// What is commanded of luffing.
    pub command: LuffingCommand<f64>,
}

/// Refuses what is given twice, or not at all.
fn suits(v: &Values, pedestal: &Values, found: &mut Vec<Diagnostic>) {
    let luffs = v.has(CARRIED.name);
    let (high, low) = (s::H_S.id, s::H_1.id);
    let mut refuse = |at: &Values, key: &str, what: String, label: &str, help: &str| {
        found.push(at.refuse(key, what, label, help));
    };
    let (own, other) = if luffs { (low, high) } else { (high, low) };
    if !pedestal.stands(own) {
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
    if let Some(dynamics) = v.table("dynamics").filter(|table| luffs && !table.stands(s::T_1.id)) {
        refuse(
            dynamics,
            s::T_1.id,
            "luffing by a command, and `T_1` is missing in [hull.dynamics]".to_owned(),
            "how fast does it follow?",
            "add T_1 = \"2 s\", the time constant with which luffing follows its command",
        );
    }
    if let Some(dynamics) = v.table("dynamics").filter(|table| !luffs && table.has(s::T_1.id)) {
        let (key, help) = (s::T_1.id, "add [luffing] with its bars, or remove it");
        refuse(dynamics, key, format!("`{key}`, and nothing luffs"), "not used", help);
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
        let rig = GivenCrane::read(v, ("hull", &LUFFING), gravity, moves, found);
        let rig = rig.filter(|_| found.len() == before)?;
        let one = |of: &Values, symbol: &'static Symbol| of.of(symbol).map(|value| One(symbol, value));
        Some(CraneRig {
            place: CranePlace::read(pedestal)?,
            height: one(pedestal, if rig.luffer.is_some() { &s::H_1 } else { &s::H_S })?,
            turning: v
                .tables("turning")
                .iter()
                .map(TurningMass::read)
                .collect::<Option<_>>()?,
            rig,
            command: LuffingCommand {
                omega_c1: v.number(s::OMEGA_C1.id).unwrap_or(0.0),
            },
        })
    }
}
