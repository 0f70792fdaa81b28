//! How governing results change with every given quantity.
//!
//! A given quantity that changes moves the governing position too. At an extreme inside the range the derivative by
//! the position is zero, and at an end of the range the position stays: in both cases the change of the result is the
//! derivative at the governing position held fast, exact from dual numbers.

use num_dual::Dual64;

use crate::component::outline::Outline;
use crate::component::probe::{Probe, slots};
use crate::component::running::Running;
use crate::component::sheet::{Sensitivity, Slope, Summary};
use crate::component::spread::{Spot, Spread, integrated};
use crate::component::stages::{Slot, Source, Use};
use crate::component::standing::{Standing, VariablePlace};
use crate::kernel::shared::each;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Quantity;

/// Where a result is held.
enum Held {
    /// At a place, and at one of the second coordinate.
    At(Slot, Dual64, Option<(Source, Dual64)>),
    Whole(Spread, Spot),
}

impl Held {
    fn integral(&self) -> Option<(&Spread, &Spot)> {
        match self {
            Held::Whole(spread, spot) if spread.is_integral() => Some((spread, spot)),
            _ => None,
        }
    }
}

/// An extreme with where it was found; of a numbered result it is held at the number that has it there.
fn held(model: &Standing, here: &mut Probe, of: &'static Symbol, summary: &Summary) -> Option<(f64, Held)> {
    let at = Dual64::from_re(summary.at.map_or(model.motion().from, |(_, at)| at));
    let aside = summary.aside.and_then(|(symbol, at)| {
        let source = model
            .part()
            .sources()
            .into_iter()
            .find(|(_, (known, _))| *known == symbol)?
            .0;
        Some((source, Dual64::from_re(at)))
    });
    here.stood(aside);
    let apart = slots(model, of).map(|slot| {
        let value = here.at(&slot, at).map_or(f64::NAN, |value| value.re);
        ((value - summary.value).abs(), slot)
    });
    let (_, slot) = apart.min_by(|(one, _), (other, _)| one.total_cmp(other))?;
    Some((summary.value, Held::At(slot, at, aside)))
}

/// How results change with each given quantity that is wanted: derivatives in SI, exact. Those that the scene has of the symbols asked
/// for, as results of the range or among the governing ones.
#[must_use]
pub fn sensitivity(
    model: &mut Standing,
    outline: &'static Outline,
    asked: &[&'static Symbol],
    governing: &[Summary],
    by: &dyn Fn(&Symbol) -> bool,
) -> Sensitivity {
    let mut results = Vec::new();
    let mut found: Vec<Held> = Vec::new();
    let mut here = Probe::new(model, &mut |_, _| 0.0);
    for &symbol in asked {
        let extreme = outline.extremes.iter().find(|extreme| extreme.symbol == symbol);
        let summary = governing.iter().find(|summary| summary.symbol == symbol);
        let held = extreme
            .zip(summary)
            .and_then(|(extreme, summary)| held(model, &mut here, extreme.of, summary));
        let index = model.variables().iter().position(|variable| variable.symbol == symbol);
        let place = index.map(|index| (index, model.places()[index]));
        let (value, of) = match (place, held) {
            (Some((index, VariablePlace::Whole(whole))), _) => {
                let (spread, spot) = (model.wholes()[whole], model.spot(whole).ok());
                (model.get(index).ok(), spot.map(|spot| Held::Whole(spread, spot)))
            }
            // A result of the whole range is the same everywhere.
            (Some((index, VariablePlace::Result(slot))), _) => {
                let from = Dual64::from_re(model.motion().from);
                (model.get(index).ok(), Some(Held::At(slot, from, None)))
            }
            (_, Some((value, of))) => (Some(value), Some(of)),
            _ => continue,
        };
        if let Some((value, of)) = value.zip(of).filter(|(value, _)| value.is_finite() && *value != 0.0) {
            results.push((symbol, value));
            found.push(of);
        }
    }
    let groups = model.part().groups();
    let used = |source: Source| groups[usize::from(source.group)].1;
    let mut given = model.part().sources();
    let smooth = |(_, (symbol, _)): &(Source, Quantity)| !model.part().undoes(symbol);
    given.retain(|given| matches!(used(given.0), Use::Parameter | Use::Load) && by(given.1.0) && smooth(given));
    // What is built, then what hangs on it.
    given.sort_by_key(|(source, _)| used(*source) == Use::Load);
    if results.is_empty() {
        return Sensitivity::default();
    }
    let probes = given.into_iter().map(|(source, of)| {
        let probe = Probe::new(model, &mut |other, _| f64::from(other == source));
        (of, model.part().take(source), probe)
    });
    let row = |((symbol, number), value, mut probe): (Quantity, f64, Probe)| {
        let integrals = found.iter().filter_map(Held::integral).collect::<Vec<_>>();
        let mut integrals = integrated(&integrals, &mut *probe.face).ok()?.into_iter();
        let mut slope = |of: &Held| match of {
            Held::At(slot, at, aside) => {
                probe.stood(*aside);
                probe.at(slot, *at)
            }
            Held::Whole(..) if of.integral().is_some() => integrals.next(),
            Held::Whole(spread, spot) => spread.value(&mut *probe.face, spot).ok(),
        };
        let by = found.iter().map(|of| Some(slope(of)?.eps));
        Some(Slope {
            symbol,
            number,
            value,
            by: by.collect::<Option<_>>()?,
        })
    };
    Sensitivity {
        rows: each(probes, row).into_iter().flatten().collect(),
        results,
    }
}
