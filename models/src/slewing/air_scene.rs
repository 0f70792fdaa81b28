//! What a scene says of the air around what slews by itself: of the wind on the structure, of the air around a load that swings.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::parts::air::{AIR, AROUND, AirAround, WindAround, around};
use crate::parts::side_wind::{SlewedArea, half, loadless};
use crate::slewing::stages::Given;
use crate::slewing::symbols as s;

/// The air as a scene describes it; SI.
#[derive(Clone, Copy, Debug, Default)]
pub struct SlewedAir {
    pub area: Option<SlewedArea<f64>>,
    pub around: Option<AirAround<f64>>,
    pub blowing: Option<WindAround<f64>>,
}

/// What of the air nothing that slews has a use for.
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
    None
}

/// What is wrong with the air of what moves or does not, and whose load swings or does not.
pub fn refused(v: &Values, moves_and_swings: [bool; 2]) -> impl Iterator<Item = Diagnostic> {
    let own = (v, "slewing");
    [
        half(v, own),
        idle(v, moves_and_swings),
        loadless(own, v.stands(s::A_WS.id), moves_and_swings[1]),
    ]
    .into_iter()
    .flatten()
}

impl SlewedAir {
    /// Of a checked table `[slewing]`, where a load swings on a rope (m) under gravity (m/s²), or none does; mistakes go to
    /// `found`.
    pub fn read(v: &Values, swings: Option<[f64; 2]>, found: &mut Vec<Diagnostic>) -> SlewedAir {
        let Some(table) = v.table(AIR.name) else {
            return SlewedAir::default();
        };
        let loaded = swings.filter(|_| table.stands(AROUND[0]));
        let load = loaded.and_then(|[rope, gravity]| around(table, [(gravity / rope).sqrt(), gravity], true, found));
        let [v_air, chi_air] = [&s::V_AIR, &s::CHI_AIR].map(|symbol| table.number(symbol.id).unwrap_or(0.0));
        SlewedAir {
            area: SlewedArea::read(v, Some(table), load.is_some()),
            around: load,
            blowing: Some(WindAround { v_air, chi_air }),
        }
    }

    /// The same crane whose load does not swing.
    pub fn without_load(given: &mut Given<f64>) {
        let load = given.around.take();
        match given.area {
            Some(area) => given.area = Some(area.in_air(load.as_ref())),
            None => given.blowing = None,
        }
    }
}
