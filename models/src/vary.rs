//! Quantities of a scene that may have other values, as its tables `vary` name them: what a search and a study read alike.

use std::ops::Range;

use crate::component::stages::{Source, Use};
use crate::component::standing::Standing;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::measure;
use crate::kernel::origin::{Known, Origin, Origins};
use crate::kernel::schema::Key;
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Role, Variable};

/// A key with the text behind it and its place.
pub(crate) type Named<'a> = (&'a String, &'a String, &'a Range<usize>);

/// A quantity that the scene gives, with where it does; those that are `free` are told where it is none.
///
/// # Errors
/// What it is not.
pub(crate) fn given<'a>(
    all: &'a Origins,
    (key, _, place): Named<'_>,
    free: impl Fn(&Known) -> bool,
) -> Result<(&'a Known, &'a Origin), Box<Diagnostic>> {
    let refuse = |message: String, label: &str, help: String| {
        Err(Box::new(Diagnostic::new(place.clone(), message, label).help(help)))
    };
    let Some(known) = all.known(key) else {
        let free = all.all().filter(|known| free(known));
        let free: Vec<&str> = free
            .filter_map(|known| Some(known.given.as_ref()?.key.as_str()))
            .collect();
        let message = format!("`{key}` is no quantity of this scene");
        return refuse(message, "not known", format!("quantities here: {}", free.join(", ")));
    };
    let Some(origin) = &known.given else {
        let message = format!("`{key}` is not given in this scene");
        let value = known.symbol.written(known.value);
        return refuse(
            message,
            "left at what is usual",
            format!("give it a value to start from: {value}"),
        );
    };
    if origin.over_time {
        let message = format!("`{key}` is told over time in this scene");
        let help = "name a quantity that is one number, or give it one value";
        return refuse(message, "not one number", help.to_owned());
    }
    Ok((known, origin))
}

/// Refuses a value that the quantity of a key cannot have, behind which `text` stands.
///
/// # Errors
/// What is allowed.
pub(crate) fn allowed(
    (key, text, place): Named<'_>,
    symbol: &'static Symbol,
    values: &[f64],
) -> Result<(), Box<Diagnostic>> {
    let refused = |value: &f64| Variable::new((symbol, None), Role::Parameter).check(*value).err();
    match values.iter().find_map(refused) {
        Some(fault) => {
            let message = format!("`vary.\"{key}\"`: {text} is not allowed");
            let diagnostic = Diagnostic::new(place.clone(), message, "out of range");
            Err(Box::new(diagnostic.help(fault.message)))
        }
        None => Ok(()),
    }
}

/// What is wrong with the text behind a key.
pub(crate) fn wrong((key, _, place): Named<'_>, (message, label, help): measure::Problem) -> Box<Diagnostic> {
    Box::new(Diagnostic::new(place.clone(), format!("`vary.\"{key}\"`: {message}"), label).help(help))
}

pub(crate) type Number = Result<f64, measure::Problem>;

/// A quantity, or the weight of a mass.
pub(crate) fn number(text: &str, symbol: &'static Symbol, weighs: Option<f64>) -> Number {
    let Some(g) = weighs else {
        return measure::quantity(text, symbol, Sign::Any);
    };
    let number = measure::number(text, &Key::weight(symbol))?;
    Ok(number.mass.map_or(number.value, |mass| mass * g))
}

/// Values such as `"2, 3 or 4"`; none where these are bounds.
pub(crate) fn choices(text: &str, symbol: &'static Symbol, weighs: Option<f64>) -> Result<Vec<f64>, measure::Problem> {
    if text.contains(',') || text.contains(" or ") {
        return list(text, symbol, weighs);
    }
    Ok(Vec::new())
}

/// Values one after the other, `"2, 3 or 4"`.
pub(crate) fn list(text: &str, symbol: &'static Symbol, weighs: Option<f64>) -> Result<Vec<f64>, measure::Problem> {
    let each = text.split(',').flat_map(|some| some.split(" or "));
    each.map(|one| number(one, symbol, weighs)).collect()
}

/// Bounds such as `"1 m to 2 m"`.
pub(crate) fn bounds(text: &str, symbol: &Symbol, read: impl Fn(&str) -> Number) -> Result<[f64; 2], measure::Problem> {
    let Some((low, high)) = text.split_once(" to ") else {
        let unit = symbol.display.name;
        return Err((
            format!("\"{text}\" are no bounds"),
            "cannot be read".to_owned(),
            format!("write the least and the greatest value: \"1 {unit} to 2 {unit}\""),
        ));
    };
    let ends = [read(low)?, read(high)?];
    if ends[0] >= ends[1] {
        return Err((
            format!("the bounds {text} are upside down"),
            "not above the first".to_owned(),
            "give the smallest value first, then the greatest".to_owned(),
        ));
    }
    Ok(ends)
}

/// The number of the equations that a quantity of the scene is.
pub(crate) fn source(model: &Standing, known: &Known) -> Result<Source, &'static str> {
    let groups = model.part().groups();
    let number = known
        .key
        .split_once('[')
        .and_then(|(_, rest)| rest.split_once(']')?.0.parse::<u16>().ok());
    let own = |(source, (symbol, of)): &(Source, (&'static Symbol, Option<u16>))| {
        *symbol == known.symbol && of.is_none_or(|of| Some(of) == number) && model.part().take(*source) == known.value
    };
    let all: Vec<Source> = model
        .part()
        .sources()
        .iter()
        .filter(|one| own(one))
        .map(|(source, _)| *source)
        .collect();
    match all.as_slice() {
        [source] => match groups[usize::from(source.group)].1 {
            Use::Parameter | Use::Load => Ok(*source),
            _ => Err("it runs through the working range, or is an input"),
        },
        [] => Err("no equation has it as it stands"),
        _ => Err("several quantities have its symbol and its value"),
    }
}
