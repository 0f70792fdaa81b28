//! What a scene says of the air around what slews by itself: of the wind on the structure, of the air around a load that swings.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::parts::air::{AIR, AROUND, AirAround, WindAround, around};
use crate::slewing::air::SlewedArea;
use crate::slewing::stages::Given;
use crate::slewing::symbols as s;

/// The air as a scene describes it; SI.
#[derive(Clone, Copy, Debug, Default)]
pub struct SlewedAir {
    pub area: Option<SlewedArea<f64>>,
    /// Of the air, where no load that swings has it.
    pub density: Option<One<f64>>,
    pub around: Option<AirAround<f64>>,
    pub blowing: Option<WindAround<f64>>,
}

/// An area without its place or without wind, and a place of no area.
fn half(v: &Values) -> Option<Diagnostic> {
    let [area, place] = [&s::A_WS, &s::R_WS].map(|symbol| v.stands(symbol.id));
    let (has, lacks, example) = match [area, place] {
        [true, false] => (&s::A_WS, &s::R_WS, "6 m"),
        [false, true] => (&s::R_WS, &s::A_WS, "90 m2"),
        [true, true] if v.table(AIR.name).is_none() => {
            let what = format!("{} of what slews, without wind", s::A_WS.id);
            let help =
                "add v_air = \"10 m/s\" and chi_air in [slewing.air], where it is an input; or remove A_ws and r_ws";
            return Some(v.refuse(s::A_WS.id, what, "no wind acts on it", help));
        }
        _ => return None,
    };
    let help = format!("add {} = \"{example}\"  ({})", lacks.id, lacks.text);
    let what = format!("{} of what slews, without {}", has.id, lacks.id);
    Some(v.refuse(has.id, what, "not whole", help))
}

/// What of the air nothing that slews has a use for, and what its load needs.
fn idle(v: &Values, [moves, swings]: [bool; 2]) -> Option<Diagnostic> {
    let (table, area) = (v.table(AIR.name)?, v.stands(s::A_WS.id));
    if !area && !swings {
        let what = format!("`{}` without a swinging load", AIR.name);
        let help = "remove it: the load keeps its place under the head; or set fidelity = \"swing\"; or add A_ws and r_ws, on \
                    which the wind acts, or areas of the support that carries what slews";
        return Some(v.refuse(AIR.name, what, "not used", help));
    }
    let told = |symbol: &&&Symbol| table.course(symbol.id).is_some();
    if let (false, Some(symbol)) = (moves, [&s::V_AIR, &s::CHI_AIR].iter().find(told)) {
        let what = format!("`{}` over time of slewing that is set in its place", symbol.id);
        let help = "give one value; or set fidelity = \"rigid\" or \"swing\"";
        return Some(table.refuse(symbol.id, what, "not used", help));
    }
    if let (true, false, Some(key)) = (area, swings, AROUND.iter().find(|key| table.has(key))) {
        let what = format!("`{key}` without a swinging load");
        let help = "remove it: the load keeps its place under the head; or set fidelity = \"swing\"";
        return Some(table.refuse(key, what, "not used", help));
    }
    let load = AROUND.iter().any(|key| table.stands(key));
    (swings && !table.stands(AROUND[0]) && (load || !area)).then(|| {
        let what = format!("`{}` is missing in [slewing.air]", AROUND[0]);
        let help = "add Q_air = \"100 kN\", the load of this area and damping; or A_ws and r_ws in [slewing], on which the wind acts";
        table.refuse(AROUND[0], what, "needed here", help)
    })
}

/// What is wrong with the air of what moves or does not, and whose load swings or does not.
pub fn refused(v: &Values, moves_and_swings: [bool; 2]) -> impl Iterator<Item = Diagnostic> {
    [half(v), idle(v, moves_and_swings)].into_iter().flatten()
}

impl SlewedAir {
    /// Of a checked table `[slewing]`, where a load swings on a rope (m) under gravity (m/s²), or none does; mistakes go to
    /// `found`.
    pub fn read(v: &Values, swings: Option<[f64; 2]>, found: &mut Vec<Diagnostic>) -> SlewedAir {
        let area = v
            .of(&s::A_WS)
            .zip(v.of(&s::R_WS))
            .map(|(a_ws, r_ws)| SlewedArea { a_ws, r_ws });
        let Some(table) = v.table(AIR.name) else {
            return SlewedAir::default();
        };
        let loaded = swings.filter(|_| table.stands(AROUND[0]));
        let load = loaded.and_then(|[rope, gravity]| around(table, [(gravity / rope).sqrt(), gravity], true, found));
        let rho = table.of(&s::RHO_AIR).filter(|_| area.is_some() && load.is_none());
        let [v_air, chi_air] = [&s::V_AIR, &s::CHI_AIR].map(|symbol| table.number(symbol.id).unwrap_or(0.0));
        SlewedAir {
            area,
            density: rho.map(|rho| One(&s::RHO_AIR, rho)),
            around: load,
            blowing: Some(WindAround { v_air, chi_air }),
        }
    }

    /// The same crane whose load does not swing.
    pub fn without_load(given: &mut Given<f64>) {
        let load = given.around.take();
        match given.area {
            Some(_) => given.density = given.density.or(load.map(|load| One(&s::RHO_AIR, load.rho_air))),
            None => given.blowing = None,
        }
    }
}
