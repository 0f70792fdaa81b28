//! A number with a unit, as a scene writes it.

use crate::kernel::number::short;
use crate::kernel::schema::{GivenNumber, Key, Kind};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::kernel::unit::{self, Unit};

/// Message, label and help.
pub type Problem = (String, String, String);

/// Reads what stands behind a key that has a [`Key::number`].
pub fn number(text: &str, key: &Key) -> Result<GivenNumber, Problem> {
    let given = |value, mass| GivenNumber {
        value,
        mass,
        input: false,
        course: None,
        source: None,
    };
    match key.kind {
        Kind::Weight(symbol, sign) => {
            let (number, unit) = measured(text, symbol, &[symbol.unit, &unit::KG])?;
            if unit.dimension != unit::KG.dimension {
                return allowed(number * unit.factor, text, symbol, symbol.unit, sign)
                    .map(|weight| given(weight, None));
            }
            let mass = allowed(number * unit.factor, text, symbol, &unit::KG, sign)?;
            // What it weighs is known when the whole scene has been read.
            Ok(given(f64::NAN, Some(mass)))
        }
        Kind::Quantity(symbol, sign) => quantity(text, symbol, sign).map(|value| given(value, None)),
        _ => unreachable!("a key of quantities"),
    }
}

/// Reads `"19.3 m"` for `symbol`, in SI.
pub fn quantity(text: &str, symbol: &'static Symbol, sign: Sign) -> Result<f64, Problem> {
    let (number, unit) = measured(text, symbol, &[symbol.unit])?;
    allowed(number * unit.factor, text, symbol, symbol.unit, sign)
}

/// A value in SI that a scene may give of `symbol`, here measured in units like `unit`.
fn allowed(value: f64, text: &str, symbol: &'static Symbol, unit: &Unit, sign: Sign) -> Result<f64, Problem> {
    let text = text.trim();
    let help = format!("{}: {}", symbol.id, symbol.text);
    if !sign.allows(value) {
        let message = format!("{text} is not allowed, it must be {}", sign.words());
        return Err((message, "out of range".to_owned(), help));
    }
    let limits = sign.limits(symbol, unit);
    let [least, most] = limits;
    if !(least..=most).contains(&value) {
        // "1e-7 km" is rounded to less than 0.1 mm.
        let near = |limit: &f64| (value - limit).abs() <= 4.0 * f64::EPSILON * limit.abs();
        if let Some(limit) = limits.into_iter().find(near) {
            return Ok(limit);
        }
        let shown = if unit == symbol.unit { symbol.display } else { unit };
        let written = |value: f64| match shown.name {
            "1" => short(value).to_string(),
            name => format!("{} {name}", short(value / shown.factor)),
        };
        let message = format!(
            "{text} is not allowed, it must be from {} to {}",
            written(least),
            written(most)
        );
        let slip = value.abs() > unit.limits()[1] || value != 0.0 && value.abs() < unit.limits()[0];
        let label = if slip { "a slip of the unit?" } else { "out of range" };
        return Err((message, label.to_owned(), help));
    }
    Ok(value)
}

/// Reads a number with a unit like one of `units`.
fn measured(text: &str, symbol: &'static Symbol, units: &[&'static Unit]) -> Result<(f64, &'static Unit), Problem> {
    let text = text.trim();
    let display = symbol.display.name;
    let end = text
        .find(|c: char| !(c.is_ascii_digit() || "+-.,eE_".contains(c)))
        .unwrap_or(text.len());
    // "5 em": an exponent without digits belongs to the unit.
    let end = text[..end].trim_end_matches(['e', 'E']).len();
    let (number, unit_text) = (&text[..end], text[end..].trim());
    let Ok(number) = number.parse::<f64>() else {
        let help = if number.contains(',') {
            "use a decimal point".to_owned()
        } else {
            format!("write a number and a unit: \"1.5 {display}\"")
        };
        return Err((
            format!("\"{text}\" does not begin with a number"),
            "cannot be read".to_owned(),
            help,
        ));
    };
    let unit = if unit_text.is_empty() {
        Some(&unit::ONE)
    } else {
        unit::find(unit_text)
    };
    let Some(unit) = unit else {
        return Err((
            format!("the unit \"{unit_text}\" is not known"),
            "unknown unit".to_owned(),
            format!("units for it: {}", like(units)),
        ));
    };
    if !units.iter().any(|wanted| unit.is_like(wanted)) {
        let (given, label) = if unit_text.is_empty() {
            ("no unit is given".to_owned(), "a bare number")
        } else {
            (format!("the unit {} does not fit", unit.name), "wrong unit")
        };
        return Err((
            format!("{given}, it is measured in {display}"),
            label.to_owned(),
            format!("units for it: {}", like(units)),
        ));
    }
    Ok((number, unit))
}

/// The names of all units that measure the same as one of these.
fn named(units: &[&'static Unit]) -> Vec<&'static str> {
    let fits = |unit: &&Unit| units.iter().any(|wanted| unit.is_like(wanted));
    unit::ALL.iter().copied().filter(fits).map(|unit| unit.name).collect()
}

fn like(units: &[&'static Unit]) -> String {
    named(units).join(", ")
}

/// The names of the units in which what stands behind a key may be given, that of the trade first; none of what is no
/// quantity.
#[must_use]
pub fn units(key: &Key) -> Vec<&'static str> {
    let (symbol, mut names) = match key.kind {
        Kind::Quantity(symbol, _) | Kind::Quantities(symbol, ..) => (symbol, named(&[symbol.unit])),
        Kind::Weight(symbol, _) => (symbol, named(&[symbol.unit, &unit::KG])),
        _ => return Vec::new(),
    };
    names.sort_by_key(|name| *name != symbol.display.name);
    names
}
