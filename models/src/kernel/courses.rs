//! Reads a quantity over time: `{ over = [["0 s", "0 kN.m"], ["2 s", "10 kN.m"]], between = "linear" }`.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::kernel::course::{Between, Course};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::measure::quantity;
use crate::kernel::schema::Key;
use crate::kernel::sign::Sign;
use crate::kernel::variable::TIME;

/// Names of what a quantity over time is made of.
pub(super) const OVER: &str = "over";
pub(super) const BETWEEN: &str = "between";
pub(super) const SHAPED: &str = "shaped";
pub(super) const PULSES: &str = "pulses";

/// Rows of one quantity at least and at most.
const ROWS: [usize; 2] = [2, 1000];

/// Most swings against which one is shaped at once.
pub(super) const SWINGS: usize = 2;

/// Pulses of one that is shaped: the fewest where it does not say how many.
pub(super) const PULSES_ALLOWED: [u64; 2] = [2, 3];

/// How a quantity is given over time.
pub(super) fn help(key: &Key) -> String {
    let (name, unit) = (key.name, key.number().map_or("", |(symbol, _)| symbol.display.name));
    let between = key.between.join("\" or \"");
    format!("{name} = {{ over = [[\"0 s\", \"0 {unit}\"], [\"2 s\", \"... {unit}\"]], between = \"{between}\" }}")
}

/// What stands behind a key that says it over time; its `source` is not looked at. Mistakes go to the list.
pub(super) fn read(
    table: &DeTable<'_>,
    span: &Range<usize>,
    path: &str,
    key: &'static Key,
    found: &mut Vec<Diagnostic>,
) -> Option<Course> {
    let before = found.len();
    let (mut rows, mut between, mut shaped, mut pulses) = (Vec::new(), None, Vec::new(), None);
    for (name, value) in table {
        match (name.get_ref().as_ref(), value.get_ref()) {
            (OVER, DeValue::Array(items)) => {
                let read = items.iter().map(|item| row(item, path, key, found));
                rows = read.collect::<Option<Vec<_>>>().unwrap_or_default();
                if rows.len() == items.len() && !(ROWS[0]..=ROWS[1]).contains(&rows.len()) {
                    let message = format!("`{path}` has {} over time", count(rows.len()));
                    let label = if rows.len() < ROWS[0] { "too few" } else { "too many" };
                    let help = format!("give {} to {} rows, each a time and a value", ROWS[0], ROWS[1]);
                    found.push(Diagnostic::new(value.span(), message, label).help(help));
                }
            }
            (BETWEEN, DeValue::String(text)) => {
                match Between::named(text).filter(|_| key.between.contains(&text.as_ref())) {
                    Some(named) => between = Some(named),
                    None => {
                        let message = format!("`{path}` cannot go on \"{text}\" from one time to the next");
                        let known = key.between.join("\" or \"");
                        let help = format!("set between = \"{known}\"");
                        found.push(Diagnostic::new(value.span(), message, "not this").help(help));
                    }
                }
            }
            (SHAPED, DeValue::String(text)) => shaped.extend(period(text, value.span(), path, found)),
            (SHAPED, DeValue::Array(items)) => shaped = periods(items, value.span(), path, found),
            (PULSES, _) => pulses = counted(value, path, found).map(|count| (count, name.span())),
            ("source", _) => {}
            _ => {
                let message = format!(
                    "`{path}` over time has `over`, `between`, `shaped`, `pulses` and `source`, and nothing else"
                );
                found.push(Diagnostic::new(name.span(), message, "not this").help(help(key)));
            }
        }
    }
    let said = |name: &str| table.keys().any(|known| known.get_ref() == name);
    if !said(BETWEEN) {
        let message = format!("`{path}` over time has no `between`");
        found.push(Diagnostic::new(span.clone(), message, "needed here").help(help(key)));
    }
    let falls = rows.windows(2).find(|pair| pair[1].0 <= pair[0].0);
    if let Some([(first, ..), (next, _, place)]) = falls {
        let [first, next] = [first, next].map(|time| TIME.written(*time));
        let message = format!("`{path}`: the time {next} stands behind {first}");
        found.push(Diagnostic::new(place.clone(), message, "not later").help("let the times of its rows rise"));
    }
    shapeable(key, path, !shaped.is_empty(), pulses.as_ref(), rows.first(), found);
    let rows = rows.into_iter().map(|(time, value, _)| [time, value]).collect();
    let course = between.filter(|_| found.len() == before).map(|between| Course {
        rows,
        between,
        shaped: None,
    })?;
    Some(match shaped.as_slice() {
        [] => course,
        periods => course.shaped(periods, pulses.map_or(PULSES_ALLOWED[0], |(count, _)| count)),
    })
}

/// Period of a swing, in s, that stands there.
fn period(text: &str, span: Range<usize>, path: &str, found: &mut Vec<Diagnostic>) -> Option<f64> {
    let read = quantity(text, &TIME, Sign::Positive);
    let refused = |(message, label, help)| {
        let message = format!("`{path}.{SHAPED}`: {message}");
        found.push(Diagnostic::new(span, message, label).help(help));
    };
    read.map_err(refused).ok()
}

/// Those of several swings.
fn periods(items: &[Spanned<DeValue<'_>>], span: Range<usize>, path: &str, found: &mut Vec<Diagnostic>) -> Vec<f64> {
    let texts = items.iter().map(|item| Some((item.get_ref().as_str()?, item.span())));
    let texts = texts.collect::<Option<Vec<_>>>();
    let Some(texts) = texts.filter(|texts| (1..=SWINGS).contains(&texts.len())) else {
        let message = format!("`{path}.{SHAPED}` is no period, nor {SWINGS} of them");
        let help =
            format!("set {SHAPED} = \"... s\", or {SHAPED} = [\"... s\", \"... s\"], against {SWINGS} swings at once");
        found.push(Diagnostic::new(span, message, "not so many").help(help));
        return Vec::new();
    };
    texts
        .into_iter()
        .filter_map(|(text, span)| period(text, span, path, found))
        .collect()
}

/// How many pulses a shaped one comes in.
fn counted(value: &Spanned<DeValue<'_>>, path: &str, found: &mut Vec<Diagnostic>) -> Option<u64> {
    let [two, three] = PULSES_ALLOWED;
    let count = value
        .get_ref()
        .as_integer()
        .and_then(|number| number.as_str().parse().ok());
    let count = count.filter(|count| (two..=three).contains(count));
    if count.is_none() {
        let message = format!("`{path}.{PULSES}` is neither {two} nor {three}");
        let help = format!("set {PULSES} = {two}, or {PULSES} = {three}, which leave less on other periods");
        found.push(Diagnostic::new(value.span(), message, "not so many").help(help));
    }
    count
}

/// Refuses a first row (time, value and place) that cannot be shaped, and pulses (with their place) of what is not.
fn shapeable(
    key: &'static Key,
    path: &str,
    shaped: bool,
    pulses: Option<&(u64, Range<usize>)>,
    first: Option<&(f64, f64, Range<usize>)>,
    found: &mut Vec<Diagnostic>,
) {
    match (shaped, pulses, first.zip(key.number())) {
        // A place is where it was before; what changes it begins with a jump, of which a part must come later.
        (true, _, Some(((_, value, place), (symbol, _)))) if *value != 0.0 && symbol.unit.dimension.s != 0 => {
            let message = format!("`{path}` is shaped, and begins with {}", symbol.written(*value));
            let help = "begin with a row of zero, and let the first value come at a later time";
            found.push(Diagnostic::new(place.clone(), message, "not halved: what comes before it is as it").help(help));
        }
        (false, Some((count, place)), _) => {
            let message = format!("`{path}` comes in {count} pulses, and is not shaped");
            let help = format!("add {SHAPED} = \"...\", the period of the swing, or remove {PULSES}");
            found.push(Diagnostic::new(place.clone(), message, "against what?").help(help));
        }
        _ => {}
    }
}

fn count(rows: usize) -> String {
    match rows {
        1 => "1 row".to_owned(),
        rows => format!("{rows} rows"),
    }
}

/// Time (s), value and place of a row.
fn row(
    item: &Spanned<DeValue<'_>>,
    path: &str,
    key: &'static Key,
    found: &mut Vec<Diagnostic>,
) -> Option<(f64, f64, Range<usize>)> {
    let pair = item.get_ref().as_array().and_then(|pair| match &pair[..] {
        [time, value] => Some((time, time.get_ref().as_str()?, value, value.get_ref().as_str()?)),
        _ => None,
    });
    let Some((at, time, place, value)) = pair else {
        let message = format!("`{path}`: a row over time is no time and value, both with units as texts");
        found.push(Diagnostic::new(item.span(), message, "cannot be read").help(help(key)));
        return None;
    };
    let (symbol, sign) = key.number()?;
    let mut read = |text: &str, place: Range<usize>, symbol, sign| match quantity(text, symbol, sign) {
        Ok(number) => Some(number),
        Err((message, label, help)) => {
            found.push(Diagnostic::new(place, format!("`{path}`: {message}"), label).help(help));
            None
        }
    };
    let time = read(time, at.span(), &TIME, Sign::NotNegative);
    let value = read(value, place.span(), symbol, sign);
    Some((time?, value?, at.span()))
}
