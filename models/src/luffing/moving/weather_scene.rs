//! What a scene says of wind and slope in motion, and of the wind on what slews.

use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::given::Meets;
use crate::luffing::moving::symbols as s;
use crate::luffing::resistances::symbols as r;
use crate::parts::air::{AIR, AROUND};
use crate::parts::side_wind::{SlewedArea, half};
use crate::parts::slope::{SLOPE, SlopingGround};

/// What of wind and slope a mechanism meets in motion: what its cases have, a slope where its plane does not turn. It is slewed at a
/// given speed where that is told, slewing is no motion of its own and no load swings.
pub(super) fn meets(v: &Values, dynamics: &Values, [slews, swings]: [bool; 2]) -> Meets {
    let slewing = !slews && !swings && dynamics.has(s::N_SM.id) && !v.table("balance").is_some_and(rails);
    let Some(cases) = v.table("cases") else {
        return Meets {
            slewing,
            ..Meets::NOTHING
        };
    };
    let any = |tables: &[Values], symbol: &Symbol| tables.iter().any(|table| table.number(symbol.id) > Some(0.0));
    let pressure = any(cases.tables("body"), &r::A_W);
    let blows = cases.tables("case").iter().any(|case| case.has(r::V_W.id));
    Meets {
        pressure,
        speed: pressure && (blows || cases.has(r::C_AIR.id)),
        slope: !slews,
        slewing,
    }
}

/// Whether the counterweight of a balance is on a rail, of which only the direction is known.
pub(super) fn rails(balance: &Values) -> bool {
    balance.text("kind") == Some("straight_rail")
}

/// Wind, slope or slewing that a mechanism is told of and does not meet.
pub(super) fn not_met(dynamics: &Values, meets: Meets, [slews, swings]: [bool; 2]) -> Option<Diagnostic> {
    const CASELESS: &str = "whose cases have none of it";
    let slope = match slews {
        true => [
            "whose plane turns",
            "give the slope under it in [slewing.slope] instead: gamma_s, with G_u and r_u of what stands on it",
        ],
        false => [CASELESS, "add [cases]"],
    };
    let slewing = if slews {
        [
            "that slews by itself",
            "remove it, or [slewing], which has a speed of its own",
        ]
    } else if swings {
        [
            "whose load swings in its plane alone",
            "a load that is slewed swings across it too: set fidelity = \"rigid\", or give [slewing] where the mechanism has it",
        ]
    } else {
        [
            "with a counterweight on a straight rail",
            "its distance from the slewing axis is not known: remove it, or take another balance",
        ]
    };
    let told = [
        (
            &s::P_WM,
            meets.pressure,
            [CASELESS, "add A_w and c_w to a [[cases.body]]"],
        ),
        (
            &s::V_WM,
            meets.speed,
            [CASELESS, "add A_w and c_w to a [[cases.body]], and c_air to [cases]"],
        ),
        (&s::SIGMA_M, meets.slope, slope),
        (&s::N_SM, meets.slewing, slewing),
    ];
    let mut told = told.into_iter();
    let (symbol, _, [what, help]) = told.find(|(symbol, met, _)| !met && dynamics.has(symbol.id))?;
    let what = format!("{} of a mechanism in motion {what}", symbol.id);
    Some(dynamics.refuse(symbol.id, what, "does not act", help))
}

/// What slews as the wind meets it from the side, where a load swings or none does; mistakes go to the list.
pub(super) fn aside(v: &Values, swings: bool, found: &mut Vec<Diagnostic>) -> Option<SlewedArea> {
    let (slewing, own, air) = (v.table("slewing")?, (v, "luffing"), v.table(AIR.name));
    found.extend(half(slewing, own));
    let loaded = swings && air?.stands(AROUND[0]);
    SlewedArea::read(slewing, air, loaded)
}

/// Greatest moment of the weight on the slope that the scene has besides those of the mechanism's bodies, in N·m.
pub(super) fn leaning(slewing: &Values) -> f64 {
    let ground = slewing.table(SLOPE.name).and_then(SlopingGround::read);
    ground.map_or(0.0, |it| it.g_u * it.r_u.abs() * Calc::sin_cos(it.gamma_s).0)
}

/// Greatest moment of the wind on what slews that the scene has, in N·m.
pub(super) fn blown(v: &Values, slewing: &Values) -> f64 {
    let Some(air) = v.table(AIR.name) else { return 0.0 };
    let of = |table: &Values, symbol: &Symbol| table.greatest(symbol.id).unwrap_or(0.0);
    let ([speed, density], place) = (
        [&s::V_AIR, &s::RHO_AIR].map(|symbol| of(air, symbol)),
        of(slewing, &s::R_WS),
    );
    0.5 * density * speed * speed * of(slewing, &s::A_WS) * place.abs()
}
