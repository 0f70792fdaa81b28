//! What a scene says about the load's rope and its hoist.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::quantities;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::control::hoist;
use crate::luffing::moving::symbols as s;
use crate::parts::air::{AIR, AROUND, AirAround, around};
use crate::parts::ground::{GROUND, GroundBelow, below};
use crate::parts::side_wind::{A_WS, loadless};

/// Keys of `[luffing.hoisting]`.
pub static HOISTING_KEYS: &[Key] = keys! { s:
    L_R > 0, PHI_R [optional], C_R > 0 [optional], D_R >= 0 [optional], V_H [in_steps, optional], A_H > 0 [optional],
    J_H > 0 [optional], R_H > 0 [optional], M_H > 0 [optional], M_F_H >= 0 [optional], M_M_H [over_time, optional],
    M_B_H >= 0 [over_time, optional]; hoist::CONTROL
};

quantities! {
    /// A hoist that comes up to its command with an acceleration.
    HoistRamp { a_h: A_H }
}

quantities! {
    /// A drum under the moment of a motor.
    HoistMotor { j_h: J_H, r_h: R_H, m_f_h: M_F_H }
}

quantities! {
    /// Falls of the tackle between a hoist's motor and the load, where the mechanism does not lead the rope itself.
    HoistFalls { m_h: M_H }
}

quantities! {
    /// How a rope gives way.
    RopeGive { c_r: C_R, d_r: D_R }
}

/// How the hoist moves the rope.
#[derive(Clone, Copy, Debug)]
pub enum HoistKind {
    /// It follows its command at once.
    AtOnce,
    Ramp(HoistRamp<f64>),
    Motor(HoistMotor<f64>, Option<HoistFalls<f64>>),
}

/// The load's rope at the start.
#[derive(Clone, Copy, Debug)]
pub struct LoadRope {
    /// In m.
    pub length: f64,
    /// From the vertical, in rad.
    pub swing: f64,
    pub hoist: HoistKind,
    /// `None` where it keeps its length under any force.
    pub give: Option<RopeGive<f64>>,
    /// `None` where nothing resists the load.
    pub air: Option<AirAround<f64>>,
    /// `None` where there is nothing below the load.
    pub ground: Option<GroundBelow<f64>>,
}

impl LoadRope {
    /// Whether a motor turns the hoist's drum.
    #[must_use]
    pub fn has_motor(&self) -> bool {
        matches!(self.hoist, HoistKind::Motor(..))
    }
}

/// Ids of what the model takes for granted of load, rope and hoist; `fixed` where there is no rope.
pub(super) fn load_taken(rope: Option<&LoadRope>, fixed: &'static str) -> impl Iterator<Item = &'static str> {
    let elastic = rope.is_some_and(|rope| rope.give.is_some());
    let load = match rope {
        Some(_) if elastic => "elastic_rope",
        Some(_) => "rope",
        None => fixed,
    };
    let slack = rope.filter(|_| !elastic).map(|_| "slack");
    let hoist = rope.map(|rope| match rope.hoist {
        HoistKind::AtOnce => "hoist",
        HoistKind::Ramp(_) => "hoist_ramp",
        HoistKind::Motor(..) => "hoist_motor",
    });
    let air = rope.and_then(|rope| rope.air).map(|_| "air");
    let ground = rope.and_then(|rope| rope.ground).map(|_| "ground");
    [Some(load), slack, hoist, air, ground].into_iter().flatten()
}

/// The table that has the rope and its hoist: `[luffing.hoisting]`, or `[luffing.dynamics]`.
pub fn hoisting<'a>(v: &'a Values, dynamics: &'a Values, fidelity: &str) -> Result<&'a Values, Diagnostic> {
    let Some(table) = v.table("hoisting") else {
        return Ok(dynamics);
    };
    if fidelity == "rigid" {
        let what = "a hoist where the load is fixed to the head";
        return Err(v.refuse(
            "hoisting",
            what,
            "not used",
            "set fidelity = \"swing\", or remove this table",
        ));
    }
    let twice = OF_ROPE.into_iter().find(|symbol| dynamics.number(symbol.id).is_some());
    match twice {
        None => Ok(table),
        Some(symbol) => Err(dynamics.refuse(
            symbol.id,
            format!("{} beside a table of the hoist", symbol.id),
            "given elsewhere",
            "rope and hoist stand in [hoisting] alone: move it there",
        )),
    }
}

/// What `[luffing.dynamics]` may say of the rope.
const OF_ROPE: [&Symbol; 4] = [&s::L_R, &s::PHI_R, &s::V_H, &s::A_H];

/// The rope that the load hangs on, where the level has one; `table` says so. `falls` is the table in which the falls of its
/// tackle stand, where that is not this one.
pub fn load_rope(table: &Values, fidelity: &str, falls: Option<&str>) -> Result<Option<LoadRope>, Diagnostic> {
    let n = |symbol: &Symbol| table.number(symbol.id);
    match (fidelity, n(&s::L_R)) {
        ("swing" | "hydraulic" | "auto", Some(length)) => Ok(Some(LoadRope {
            length,
            swing: n(&s::PHI_R).unwrap_or(0.0),
            hoist: winch(table, falls)?,
            give: give(table)?,
            air: None,
            ground: None,
        })),
        ("swing", None) => {
            let what = "a swinging load without a rope";
            let refused = Diagnostic::new(table.span.clone(), what, "l_R is needed here");
            Err(refused.help("add l_R = \"... m\", the length of the rope at the start"))
        }
        _ => match OF_ROPE.into_iter().find(|symbol| n(symbol).is_some()) {
            Some(symbol) => Err(table.refuse(
                symbol.id,
                format!("{} without a swinging load", symbol.id),
                "not used",
                "remove it, or set fidelity = \"swing\"",
            )),
            None => Ok(None),
        },
    }
}

/// Air around a load on its rope, and ground below it, where the scene has them.
pub fn surround(v: &Values, rope: &mut Option<LoadRope>, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<()> {
    let side = v.table("slewing").is_some_and(|table| table.stands(A_WS.id));
    found.extend(loadless((v, "luffing"), side, rope.is_some()));
    let Some(rope) = rope else {
        let unused = [
            (AIR.name, "air around a load that does not swing", !side),
            (GROUND.name, "ground below a load that does not swing", true),
        ];
        let help = "set fidelity = \"swing\", or remove this table";
        let unused = unused
            .into_iter()
            .filter(|(name, _, idle)| *idle && v.table(name).is_some());
        found.extend(unused.map(|(name, what, _)| v.refuse(name, what, "not used", help)));
        return Some(());
    };
    if let Some(table) = v.table(AIR.name).filter(|table| !side || table.stands(AROUND[0])) {
        let swings = (gravity / rope.length).sqrt();
        let slews = v.table("slewing").is_some();
        rope.air = Some(around(table, [swings, gravity], slews, found)?);
    }
    if let Some(table) = v.table(GROUND.name) {
        rope.ground = Some(below(table, rope.give.is_some(), found)?);
    }
    Some(())
}

/// A limit of the load's swing where no load swings.
pub fn no_swing(v: &Values, may_swing: bool) -> Option<Diagnostic> {
    let id = s::PHI_MAX.id;
    let limits = v.table("limits").filter(|limits| limits.has(id) && !may_swing)?;
    let what = format!("a limit {id} without a swinging load");
    Some(limits.refuse(id, what, "nothing to check", "remove the limit"))
}

/// How the hoist moves the rope.
fn winch(table: &Values, falls: Option<&str>) -> Result<HoistKind, Diagnostic> {
    let n = |symbol: &Symbol| table.number(symbol.id);
    let of_motor = [&s::J_H, &s::R_H, &s::M_H, &s::M_F_H, &s::M_M_H, &s::M_B_H];
    let Some(motor) = of_motor.into_iter().find(|symbol| n(symbol).is_some()) else {
        return Ok(n(&s::A_H).map_or(HoistKind::AtOnce, |a_h| HoistKind::Ramp(HoistRamp { a_h })));
    };
    if let Some(speed) = [&s::V_H, &s::A_H].into_iter().find(|symbol| n(symbol).is_some()) {
        return Err(table.refuse(
            speed.id,
            format!("{} beside {}: two drives on one drum", speed.id, motor.id),
            "the motor decides its speed",
            "remove it, or what belongs to the motor: J_h, r_h, m_h, M_Fh, M_Mh, M_Bh",
        ));
    }
    if let (Some(falls), Some(m_h)) = (falls, n(&s::M_H)) {
        let what = format!("m_h = {} beside m_h of [luffing.{falls}]", s::M_H.written(m_h));
        let help = format!("the falls of the hoist's tackle stand in [luffing.{falls}] alone: remove it here");
        return Err(table.refuse(s::M_H.id, what, "given twice", help));
    }
    match (n(&s::J_H), n(&s::R_H)) {
        (Some(j_h), Some(r_h)) => {
            let m_f_h = n(&s::M_F_H).unwrap_or(0.0);
            let own = falls.is_none().then(|| HoistFalls {
                m_h: n(&s::M_H).unwrap_or(1.0),
            });
            Ok(HoistKind::Motor(HoistMotor { j_h, r_h, m_f_h }, own))
        }
        (j_h, _) => {
            let missing = if j_h.is_none() { &s::J_H } else { &s::R_H };
            let what = format!("{} without {}", motor.id, missing.id);
            let help = "a drum with a motor needs its inertia J_h (kg.m2) and its radius r_h (mm)";
            Err(table.refuse(motor.id, what, "the drum is not known", help))
        }
    }
}

/// How the rope gives way, where the scene says that it does.
fn give(table: &Values) -> Result<Option<RopeGive<f64>>, Diagnostic> {
    let n = |symbol: &Symbol| table.number(symbol.id);
    match (n(&s::C_R), n(&s::D_R)) {
        (None, None) => Ok(None),
        (None, Some(_)) => {
            let what = "d_R of a rope that keeps its length";
            Err(table.refuse(s::D_R.id, what, "not used", "add c_R = \"... kN/m\", or remove it"))
        }
        (Some(c_r), d_r) => Ok(Some(RopeGive {
            c_r,
            d_r: d_r.unwrap_or(0.0),
        })),
    }
}
