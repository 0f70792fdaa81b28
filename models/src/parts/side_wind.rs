//! The wind on the structure of what slews, from the side: its moment about the slewing axis, as drives are designed.

use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::by_map;
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, symbols};
use crate::parts::air::{AIR, AROUND, AirAround, RHO_AIR};

symbols! {
    A_WS: "A_ws" "A_\"ws\"" M2 / M2 [not_negative], "Wind area of all that slews, seen from the side, with its shape coefficient; without the load.", "input";
    R_WS: "r_ws" "r_\"ws\"" M / M, "Distance of the centre of the wind area from the slewing axis; positive on the load's side.", "input";
    P_WS: "p_ws" "p_\"ws\"" PA / PA, "Pressure of the wind on all that slews, with the sign of its speed.", "[Ports001, 5.5.4]";
    M_WS: "M_ws" "M_\"ws\"" N_M / KN_M, "Moment of the wind on all that slews about the slewing axis, without the load; positive counter-clockwise, seen from above.", "[Ports001, 6.4]";
}

/// The structure of what slews as the wind meets it from the side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlewedArea<C = f64> {
    /// In m², with the distance of its centre from the axis, in m.
    pub a_ws: C,
    pub r_ws: C,
    /// Density of the air, in kg/m³, where no load that swings has it.
    pub rho_air: Option<C>,
}

impl<C: Copy> SlewedArea<C> {
    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> SlewedArea<D> {
        SlewedArea {
            a_ws: f(&A_WS, self.a_ws),
            r_ws: f(&R_WS, self.r_ws),
            rho_air: self.rho_air.map(|rho| f(&RHO_AIR, rho)),
        }
    }
}

by_map!(SlewedArea: 3);

impl SlewedArea {
    /// What the table of what slews has, with the density of its air, unless that is around a load.
    #[must_use]
    pub fn read(slewing: &Values, air: Option<&Values>, loaded: bool) -> Option<SlewedArea> {
        Some(SlewedArea {
            a_ws: slewing.of(&A_WS)?,
            r_ws: slewing.of(&R_WS)?,
            rho_air: air.filter(|_| !loaded).and_then(|air| air.of(&RHO_AIR)),
        })
    }
}

impl<C: Calc> SlewedArea<C> {
    /// With the density of the air around a load, where that has it.
    #[must_use]
    pub fn in_air(self, around: Option<&AirAround<C>>) -> SlewedArea<C> {
        let rho_air = self.rho_air.or(around.map(|around| around.rho_air));
        SlewedArea { rho_air, ..self }
    }

    /// Pressure of the wind on the structure, in Pa and with the sign of its speed, and its moment about the slewing axis, in N·m:
    /// p = ½ ρ v |v|, M_ws = p A_ws r_ws sin(χ − ψ), the law by which a drive is designed, for the wind over the ground, of a
    /// speed (m/s) and a direction (rad), at a slewing angle (rad); `None` of air without density. [Ports001, 6.4]
    pub fn pushed(&self, [speed, to]: [C; 2], psi: C) -> Option<[C; 2]> {
        let pressure = (C::constant(0.5) * self.rho_air? * speed * speed.abs()).def(&P_WS);
        let aside = (to - psi).sin();
        Some([pressure, (pressure * self.a_ws * self.r_ws * aside).def(&M_WS)])
    }
}

/// Refuses, of a table of what slews and the one of a name that has its air, an area without its place or without wind, and a place
/// of no area.
#[must_use]
pub fn half(slewing: &Values, (v, name): (&Values, &str)) -> Option<Diagnostic> {
    let [area, place] = [&A_WS, &R_WS].map(|symbol| slewing.stands(symbol.id));
    let (has, lacks, example) = match [area, place] {
        [true, false] => (&A_WS, &R_WS, "6 m"),
        [false, true] => (&R_WS, &A_WS, "90 m2"),
        [true, true] if v.table(AIR.name).is_none() => {
            let what = format!("{} of what slews, without wind", A_WS.id);
            let help = format!(
                "add v_air = \"10 m/s\" and chi_air in [{name}.air], where it is an input; or remove A_ws and r_ws"
            );
            return Some(slewing.refuse(A_WS.id, what, "no wind acts on it", help));
        }
        _ => return None,
    };
    let help = format!("add {} = \"{example}\"  ({})", lacks.id, lacks.text);
    let what = format!("{} of what slews, without {}", has.id, lacks.id);
    Some(slewing.refuse(has.id, what, "not whole", help))
}

/// Refuses, of the air of a table of a name, what is for a load where none swings; where one does, that nothing says which load, or
/// that there is none in it and no area either.
#[must_use]
pub fn loadless((v, name): (&Values, &str), area: bool, swings: bool) -> Option<Diagnostic> {
    let table = v.table(AIR.name)?;
    if let (true, false, Some(key)) = (area, swings, AROUND.iter().find(|key| table.has(key))) {
        let what = format!("`{key}` without a swinging load");
        let help = "remove it: the load keeps its place under the head; or set fidelity = \"swing\"";
        return Some(table.refuse(key, what, "not used", help));
    }
    let load = AROUND.iter().any(|key| table.stands(key));
    (swings && !table.stands(AROUND[0]) && (load || !area)).then(|| {
        let what = format!("`{}` is missing in [{name}.air]", AROUND[0]);
        let help = "add Q_air = \"100 kN\", the load of this area and damping; or A_ws and r_ws in [slewing], on which the wind acts";
        table.refuse(AROUND[0], what, "needed here", help)
    })
}
