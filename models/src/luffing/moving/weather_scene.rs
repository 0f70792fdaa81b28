//! What a scene says of wind and slope in motion.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::given::Meets;
use crate::luffing::moving::symbols as s;
use crate::luffing::resistances::symbols as r;

/// What of wind and slope a mechanism meets in motion: what its cases have, a slope where its plane does not turn.
pub(super) fn meets(v: &Values, slews: bool) -> Meets {
    let Some(cases) = v.table("cases") else {
        return Meets::NOTHING;
    };
    let any = |tables: &[Values], symbol: &Symbol| tables.iter().any(|table| table.number(symbol.id) > Some(0.0));
    let pressure = any(cases.tables("body"), &r::A_W);
    let blows = cases.tables("case").iter().any(|case| case.has(r::V_W.id));
    Meets {
        pressure,
        speed: pressure && (blows || cases.has(r::C_AIR.id)),
        slope: !slews,
    }
}

/// Wind or slope that a mechanism is told of and does not meet.
pub(super) fn not_met(dynamics: &Values, meets: Meets, slews: bool) -> Option<Diagnostic> {
    let told = [
        (&s::P_WM, meets.pressure, "add A_w and c_w to a [[cases.body]]"),
        (
            &s::V_WM,
            meets.speed,
            "add A_w and c_w to a [[cases.body]], and c_air to [cases]",
        ),
        (&s::SIGMA_M, meets.slope, "add [cases]"),
    ];
    let (symbol, _, help) = told
        .into_iter()
        .find(|(symbol, met, _)| !met && dynamics.has(symbol.id))?;
    let turns = slews && symbol == &s::SIGMA_M;
    let (what, help) = match turns {
        true => ("whose plane turns", "remove it, or [luffing.slewing]"),
        false => ("whose cases have none of it", help),
    };
    let what = format!("{} of a mechanism in motion {what}", symbol.id);
    Some(dynamics.refuse(symbol.id, what, "does not act", help))
}
