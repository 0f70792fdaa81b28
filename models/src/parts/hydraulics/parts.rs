//! Parts of a cylinder's oil that a scene may leave out, as one group.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::by_map;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::parts::hydraulics::anti_cavitation::AntiCavitation;
use crate::parts::hydraulics::load_holding::LoadHolding;
use crate::parts::hydraulics::pump::PumpLimits;
use crate::parts::hydraulics::symbols as s;
use crate::parts::hydraulics::tank::Tank;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OilParts<C = f64> {
    pub anti_cavitation: Option<AntiCavitation<C>>,
    pub load_holding: Option<LoadHolding<C>>,
    pub pump: Option<PumpLimits<C>>,
    pub tank: Option<Tank<C>>,
}

impl<C: Copy> OilParts<C> {
    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> OilParts<D> {
        OilParts {
            anti_cavitation: self.anti_cavitation.map(|part| part.map(f)),
            load_holding: self.load_holding.map(|part| part.map(f)),
            pump: self.pump.map(|part| part.map(f)),
            tank: self.tank.map(|part| part.map(f)),
        }
    }
}

by_map!(OilParts: 9);

impl OilParts {
    const NONE: OilParts = OilParts {
        anti_cavitation: None,
        load_holding: None,
        pump: None,
        tank: None,
    };

    /// Those of a table; `None` of none.
    ///
    /// # Errors
    /// A part of which something is missing, and a torn line without a valve that holds.
    pub fn read(table: &Values) -> Result<Option<OilParts>, Diagnostic> {
        let parts = OilParts {
            anti_cavitation: whole(table, AntiCavitation::<f64>::SYMBOLS)?
                .then(|| AntiCavitation::read(table))
                .flatten(),
            load_holding: whole(table, LoadHolding::<f64>::SYMBOLS)?
                .then(|| LoadHolding::read(table))
                .flatten(),
            pump: whole(table, PumpLimits::<f64>::SYMBOLS)?
                .then(|| PumpLimits::read(table))
                .flatten(),
            tank: Tank::read(table),
        };
        let torn = [&s::Y_B1, &s::Y_B2].into_iter().find(|symbol| table.has(symbol.id));
        if let Some(torn) = torn.filter(|_| parts.load_holding.is_none()) {
            let what = format!("{} without a load-holding valve", torn.id);
            return Err(table.refuse(
                torn.id,
                what,
                "nothing would hold",
                "add p_lh, i_lh, dp_lh and x_T, or remove it",
            ));
        }
        Ok((parts != OilParts::NONE).then_some(parts))
    }
}

/// Whether a table has all that a part needs, or nothing of it.
fn whole(table: &Values, symbols: &[&'static Symbol]) -> Result<bool, Diagnostic> {
    let given = symbols.iter().find(|symbol| table.stands(symbol.id));
    let missing = symbols.iter().find(|symbol| !table.stands(symbol.id));
    let Some((given, missing)) = given.zip(missing) else {
        return Ok(given.is_some());
    };
    let ids: Vec<&str> = symbols.iter().map(|symbol| symbol.id).collect();
    let what = format!("{} without {}", given.id, missing.id);
    let help = format!("give {}, or none of them", ids.join(", "));
    Err(table.refuse(given.id, what, "the part is not known", help))
}
