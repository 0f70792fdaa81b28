//! What a scene asks of a study: the table `[study]`, which of its quantities vary, how, and what is looked at. The designs
//! are made and computed by the crate `lemnis_study`.

use std::ops::Range;

use crate::component::mechanism::Mechanism;
use crate::component::running::Running;
use crate::component::standing::Standing;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::measure::{self, Problem};
use crate::kernel::origin::Origins;
use crate::kernel::schema::{COUNTLESS, Key, Kind, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Quantity, Role, Type};
use crate::registry::judged;
use crate::vary::{self, Named, bounds, choices, number};

/// Keys of `[study]`.
pub static STUDY: &[Key] = &[
    Key::new(
        "vary",
        Kind::Named,
        "Quantities of the scene that vary, each by values (\"2, 3 or 4\"), in a range (\"1 m to 2 m\"), about the scene's \
         value within a tolerance (\"± 1 mm\", \"± 2 %\"), or as \"normal ± 1 mm\" (three standard deviations), \
         \"normal, sd 1 mm\" or \"triangular 1 m to 2 m\".",
    ),
    Key::new(
        "outputs",
        Kind::Texts(MOST_OUTPUTS),
        "Results that are looked at: of the whole range, such as \"R_max\", or at a position, such as \"R at theta_1 = 60 deg\".",
    ),
    Key::new(
        "n",
        Kind::Count([1, MOST]),
        "How many designs are drawn, best a power of two; without it every combination of the values.",
    )
    .optional(),
    Key::new(
        "seed",
        Kind::Count([0, COUNTLESS]),
        "Seed of the designs: the same seed gives the same ones.",
    )
    .optional(),
];

/// Most designs of a study: of each some numbers are kept.
pub const MOST: u64 = 10_000_000;

/// Most quantities that vary.
pub const MOST_VARIED: usize = 64;

const MOST_OUTPUTS: usize = 100;

/// A study that a scene asks for; SI.
#[derive(Clone, Debug)]
pub struct Study {
    /// In the order of the scene.
    pub varied: Vec<Varying>,
    pub outputs: Vec<Output>,
    /// How many designs are drawn; all combinations where that is left open.
    pub drawn: Option<u64>,
    pub seed: u64,
}

/// A quantity that varies.
#[derive(Clone, Debug)]
pub struct Varying {
    /// As the scene has it.
    pub key: String,
    pub symbol: &'static Symbol,
    pub law: Law,
    /// What the scene has now.
    pub value: f64,
    /// As the scene says how it varies.
    pub text: String,
    given: Range<usize>,
    input: bool,
    place: Range<usize>,
}

/// How a quantity varies.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// Each of these as often.
    Values(Vec<f64>),
    /// Evenly between two ends.
    Even([f64; 2]),
    Normal {
        mean: f64,
        deviation: f64,
    },
    /// Its least, its likeliest and its greatest value.
    Triangular([f64; 3]),
}

/// A result that is looked at.
#[derive(Clone, Debug)]
pub struct Output {
    /// As the scene names it.
    pub name: String,
    pub of: Quantity,
    /// The coordinate at which; `None` for a result of the whole range.
    pub at: Option<f64>,
}

impl Study {
    /// Of a checked table; mistakes go to `found`.
    pub fn read(
        v: &Values,
        mechanism: &dyn Mechanism,
        given: &Origins,
        gravity: f64,
        found: &mut Vec<Diagnostic>,
    ) -> Option<Study> {
        let before = found.len();
        let mut varied: Vec<Varying> = Vec::new();
        for (key, text, place) in v.named("vary") {
            match vary(given, gravity, (key, text, place)) {
                Ok(one) if varied.iter().any(|other| other.given == one.given) => {
                    let message = format!("`{key}` varies twice");
                    found.push(Diagnostic::new(place.clone(), message, "named before").help("remove one of them"));
                }
                Ok(one) => varied.push(one),
                Err(refused) => found.push(*refused),
            }
        }
        // In the order of the scene.
        varied.sort_by_key(|one| one.place.start);
        let mut outputs: Vec<Output> = Vec::new();
        if found.len() == before {
            let mut model = mechanism.standing();
            for (text, place) in v.texts("outputs") {
                match output(mechanism, &mut model, text) {
                    Ok(one) if outputs.iter().any(|other| other.name == one.name) => {
                        let message = format!("the output {} stands twice", one.name);
                        found.push(Diagnostic::new(place.clone(), message, "named before").help("remove one of them"));
                    }
                    Ok(one) => outputs.push(one),
                    Err((message, label, help)) => {
                        found.push(Diagnostic::new(place.clone(), message, label).help(help));
                    }
                }
            }
        }
        let study = Study {
            varied,
            outputs,
            drawn: v.count("n"),
            seed: v.count("seed").unwrap_or(1),
        };
        if found.len() == before {
            found.extend(study.refused(v));
        }
        (found.len() == before).then_some(study)
    }

    /// What of a study cannot be run.
    fn refused(&self, v: &Values) -> Option<Diagnostic> {
        if self.varied.is_empty() {
            let help = "name a quantity of the scene and how it varies: { \"luffing.X_1\" = \"± 1 mm\" }";
            return Some(v.refuse("vary", "nothing varies", "one design", help));
        }
        if self.outputs.is_empty() {
            let help = "name results of the scene: [\"R_max\"]";
            return Some(v.refuse("outputs", "no result is looked at", "nothing to tell", help));
        }
        if self.varied.len() > MOST_VARIED {
            let message = format!("{} quantities vary", self.varied.len());
            let help = format!("at most {MOST_VARIED} may: leave out those that matter least");
            return Some(v.refuse("vary", message, "too many", help));
        }
        if self.drawn.is_some() {
            return None;
        }
        if let Some(one) = self.varied.iter().find(|one| !matches!(one.law, Law::Values(_))) {
            let message = format!("`{}` = \"{}\" has no end of values", one.key, one.text);
            let help = "say how many designs are drawn, n = 1024, or give each quantity values: \"1 m, 2 m or 3 m\"";
            return Some(Diagnostic::new(one.place.clone(), message, "how many?").help(help));
        }
        let most = usize::try_from(MOST).unwrap_or(usize::MAX);
        let product = self.varied.iter().try_fold(1_usize, |product, one| match &one.law {
            Law::Values(values) => product.checked_mul(values.len()).filter(|product| *product <= most),
            _ => None,
        });
        product.is_none().then(|| {
            let help = "leave some out, or draw as many as are wanted: n = 1024";
            v.refuse(
                "vary",
                format!("more than {MOST} combinations of values"),
                "too many",
                help,
            )
        })
    }

    /// The scene's text with other values (SI), to the bit.
    #[must_use]
    pub fn replaced(&self, text: &str, values: &[f64]) -> String {
        let mut places: Vec<(&Varying, f64)> = self.varied.iter().zip(values.iter().copied()).collect();
        places.sort_by_key(|(one, _)| std::cmp::Reverse(one.given.start));
        let mut changed = text.to_owned();
        for (one, value) in places {
            let value = one.symbol.in_si(value);
            let written = match one.input {
                true => format!("{{ input = \"{value}\" }}"),
                false => format!("\"{value}\""),
            };
            changed.replace_range(one.given.clone(), &written);
        }
        changed
    }
}

/// A quantity that varies, and how.
fn vary(all: &Origins, gravity: f64, named: Named<'_>) -> Result<Varying, Box<Diagnostic>> {
    let (_, text, place) = named;
    let (known, origin) = vary::given(all, named, |known| known.given.is_some())?;
    let weighs = origin.mass.map(|_| gravity);
    let law = law(text, known.symbol, known.value, weighs).map_err(|problem| vary::wrong(named, problem))?;
    match &law {
        Law::Values(values) => vary::allowed(named, known.symbol, values)?,
        Law::Even(ends) => vary::allowed(named, known.symbol, ends)?,
        Law::Triangular(corners) => vary::allowed(named, known.symbol, corners)?,
        // What cannot be is a design that is refused.
        Law::Normal { .. } => {}
    }
    Ok(Varying {
        key: origin.key.clone(),
        symbol: known.symbol,
        law,
        value: known.value,
        text: text.clone(),
        given: origin.place.clone(),
        input: origin.input,
        place: place.clone(),
    })
}

/// What stands behind the sign of a tolerance.
fn tolerance(text: &str) -> Option<&str> {
    text.strip_prefix('±').or_else(|| text.strip_prefix("+-"))
}

/// How a quantity with a value varies.
fn law(text: &str, symbol: &'static Symbol, value: f64, weighs: Option<f64>) -> Result<Law, Problem> {
    let text = text.trim();
    let read = |text: &str| number(text, symbol, weighs);
    // A part of the value, or what it may be off.
    let width = |text: &str| {
        let width = match text.trim().strip_suffix('%') {
            Some(percent) => match percent.trim().parse::<f64>() {
                Ok(percent) => (0.01 * percent * value).abs() * percent.signum(),
                Err(_) => return Err(unread(text, symbol)),
            },
            None => read(text)?,
        };
        match width > 0.0 && width.is_finite() {
            true => Ok(width),
            false => Err((
                format!("{} is no width", text.trim()),
                "out of range".to_owned(),
                match value == 0.0 && text.contains('%') {
                    true => format!("a part of {} is nothing: write it with a unit", symbol.written(value)),
                    false => "it must be positive".to_owned(),
                },
            )),
        }
    };
    if let Some(rest) = text.strip_prefix("normal") {
        let rest = rest.trim_start();
        let deviation = match (tolerance(rest), rest.strip_prefix(", sd ")) {
            (Some(rest), _) => width(rest)? / 3.0,
            (_, Some(rest)) => width(rest)?,
            _ => return Err(unread(text, symbol)),
        };
        return Ok(Law::Normal { mean: value, deviation });
    }
    if let Some(rest) = text.strip_prefix("triangular ") {
        let [low, high] = bounds(rest, symbol, read)?;
        if !(low..=high).contains(&value) {
            let label = "the scene's value is the likeliest";
            return Err((
                format!("{} lies outside {rest}", symbol.written(value)),
                label.to_owned(),
                "widen the range, or change the scene's value".to_owned(),
            ));
        }
        return Ok(Law::Triangular([low, value, high]));
    }
    if let Some(rest) = tolerance(text) {
        let width = width(rest)?;
        return Ok(Law::Even([value - width, value + width]));
    }
    if text.contains(" to ") {
        return bounds(text, symbol, read).map(Law::Even);
    }
    match choices(text, symbol, weighs)? {
        values if values.is_empty() => Err(unread(text, symbol)),
        values => Ok(Law::Values(values)),
    }
}

fn unread(text: &str, symbol: &Symbol) -> Problem {
    let unit = match symbol.display.name {
        "1" => String::new(),
        name => format!(" {name}"),
    };
    (
        format!("\"{text}\" does not say how it varies"),
        "cannot be read".to_owned(),
        format!(
            "write values \"1{unit}, 2{unit} or 3{unit}\", a range \"1{unit} to 2{unit}\", a tolerance \"± 1{unit}\" or \"± 1 %\", \
             \"normal ± 1{unit}\", \"normal, sd 1{unit}\" or \"triangular 1{unit} to 2{unit}\""
        ),
    )
}

/// A result that is looked at, of the whole range or at a position.
fn output(mechanism: &dyn Mechanism, model: &mut Standing, text: &str) -> Result<Output, Problem> {
    let text = text.trim();
    let Some((name, place)) = text.split_once(" at ") else {
        let all = judged(mechanism, model, &|_| true);
        let of = all.results().find(|result| result.symbol.id == text);
        let Some(result) = of else {
            let known: Vec<&str> = all.results().map(|result| result.symbol.id).collect();
            let own = |v: &&str| *v == text;
            let names: Vec<String> = model.variables().iter().map(|variable| variable.name()).collect();
            let at = names
                .iter()
                .map(String::as_str)
                .find(own)
                .map_or(String::new(), |name| {
                    format!(
                        "; {name} has a value at each position: \"{name} at {} = ...\"",
                        names[0]
                    )
                });
            return Err((
                format!("`{text}` is no result of the whole range of this scene"),
                "not known".to_owned(),
                format!("results here: {}{at}", known.join(", ")),
            ));
        };
        return Ok(Output {
            name: text.to_owned(),
            of: (result.symbol, None),
            at: None,
        });
    };
    let coordinate = model.variables()[0];
    let value = place
        .strip_prefix(coordinate.symbol.id)
        .and_then(|rest| rest.trim_start().strip_prefix('='));
    let Some(value) = value else {
        let middle = f64::midpoint(model.motion().from, model.motion().to);
        return Err((
            format!("\"{place}\" is no position"),
            "cannot be read".to_owned(),
            format!(
                "write \"{name} at {} = {}\"",
                coordinate.symbol.id,
                coordinate.symbol.written(middle)
            ),
        ));
    };
    let at = measure::quantity(value, coordinate.symbol, Sign::Any)?;
    let result = |variable: &&crate::kernel::variable::Variable| {
        matches!(variable.role, Role::Output | Role::Calculated) && variable.kind == Type::Real
    };
    let results = || model.variables().iter().filter(result);
    let Some(variable) = results().find(|variable| variable.name() == name) else {
        let known: Vec<String> = results().map(|variable| variable.name()).collect();
        return Err((
            format!("`{name}` is no result of this scene"),
            "not known".to_owned(),
            format!("results here: {}", known.join(", ")),
        ));
    };
    let of = variable.quantity();
    let index = model.variables().iter().position(|variable| variable.quantity() == of);
    let computed = model.set(0, at).and_then(|()| model.get(index.expect("just found")));
    match computed {
        Ok(_) => Ok(Output {
            name: text.to_owned(),
            of,
            at: Some(at),
        }),
        Err(fault) => Err((
            format!("\"{text}\" does not exist: {}", fault.message),
            "no such position".to_owned(),
            "choose another position".to_owned(),
        )),
    }
}
