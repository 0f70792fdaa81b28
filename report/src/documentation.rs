//! The first page of an FMU's documentation: what it is, how to use it, and every variable.

use lemnis_fmu::instance::strings;
use lemnis_fmu::layout::{self, Place};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::{Enumeration, PART_OF_RANGE, Role, TIME, Type, Variable};
use lemnis_models::scene::Scene;
use minijinja::value::Serde;
use minijinja::{Environment, HtmlEscape, UndefinedBehavior, context};
use serde::Serialize;

use crate::language::{Language, Words, symbol_tables};
use crate::template::Error;

const TEMPLATE: &str = include_str!("../../templates/index.html");

/// The default experiment.
#[derive(Serialize)]
struct Experiment {
    coordinate: String,
    /// Where the coordinate starts, and where the working range ends.
    from: String,
    to: String,
    /// In s.
    lasts: String,
    step: String,
    /// Inputs for the coordinate: until one is set it runs by itself. None where it is a state.
    set_by: Vec<String>,
    /// Whether something moves by equations of motion.
    solved: bool,
}

fn experiment(scene: &Scene, model: &Model) -> Experiment {
    let coordinate = model.variables()[0];
    let range = scene.mechanism.motion();
    let second = |time: f64| TIME.written(time);
    let inputs = model.variables().iter().filter(|variable| variable.role == Role::Input);
    let set_by = inputs.filter(|variable| [coordinate.symbol, &PART_OF_RANGE].contains(&variable.symbol));
    Experiment {
        coordinate: coordinate.name(),
        from: coordinate.symbol.written(range.from),
        to: coordinate.symbol.written(range.to),
        lasts: second(model.stop_time()),
        step: second(model.step_size()),
        set_by: set_by.map(Variable::name).collect(),
        solved: model.states() > 0,
    }
}

#[derive(Serialize)]
struct Row {
    name: String,
    /// Id of the words for its causality.
    role: &'static str,
    unit: String,
    display: &'static str,
    text: String,
    source: &'static str,
    reference: u32,
}

/// What an importer may set while the model runs.
#[derive(Serialize)]
struct Input {
    name: String,
    text: &'static str,
    /// As it is until it is set.
    start: String,
}

#[derive(Serialize)]
struct Terminal {
    name: String,
    text: &'static str,
    /// Names in the terminal and of the variables.
    members: Vec<[String; 2]>,
}

/// `1 straight, 2 crab`.
fn numbered(of: &Enumeration) -> String {
    let items = (1..)
        .zip(of.items)
        .map(|(number, (item, _))| format!("{number} {item}"));
    items.collect::<Vec<_>>().join(", ")
}

/// A sentence of the books as HTML: what stands there in Typst's mathematics is a variable of the FMU, by its name.
fn html(sentence: &str, mechanism: &str) -> String {
    let name = |print: &str| {
        let known = symbol_tables(mechanism).flatten().find(|symbol| symbol.print == print);
        known.map_or_else(|| print.to_owned(), |symbol| symbol.id.to_owned())
    };
    let part = |(i, part): (usize, &str)| match i % 2 {
        0 => HtmlEscape(part).to_string(),
        _ => format!("<code>{}</code>", HtmlEscape(&name(part))),
    };
    sentence.split('$').enumerate().map(part).collect()
}

/// The page as HTML. `book` is the name of the book's file beside it.
///
/// # Errors
/// The scene's model cannot be built, or the template is wrong.
pub fn page(scene: &Scene, book: Option<&str>) -> Result<String, Error> {
    let model = scene.model().map_err(|fault| Error(fault.message))?;
    let variables = model.variables();
    let row = |(index, variable): (usize, &Variable)| Row {
        name: variable.name(),
        role: match variable.role {
            Role::Input => "input",
            Role::Parameter => "parameter",
            Role::Tunable => "tunable parameter",
            Role::Output => "output",
            Role::Calculated => "calculated parameter",
            Role::State => "state",
            Role::Rate => "rate of a state",
            Role::Indicator => "event indicator",
        },
        unit: match variable.kind {
            Type::Real => variable.symbol.unit.name.to_owned(),
            Type::Boolean => "true or false".to_owned(),
            Type::Enumeration(of) => numbered(of),
        },
        display: variable.symbol.display.name,
        text: variable.description(),
        source: variable.symbol.source,
        reference: layout::reference(variables.len(), Place::Variable(index)),
    };
    let rows: Vec<Row> = variables.iter().enumerate().map(row).collect();
    let terminals = model.terminals().into_iter().map(|terminal| Terminal {
        name: terminal.name,
        text: terminal.text,
        members: terminal
            .members
            .iter()
            .map(|(variable, member)| [(*member).to_owned(), variable.clone()])
            .collect(),
    });
    let terminals: Vec<Terminal> = terminals.collect();
    let [version, hash] = strings(scene);
    let english = Words::new(Language::find("en").expect("known"), [], None).map_err(Error)?;
    let sentence = |id| {
        let words = english.get("assumption", id).map_err(Error)?;
        Ok(html(words, scene.mechanism.id()))
    };
    let assumptions = scene.assumptions().into_iter().map(sentence);
    let assumptions: Vec<String> = assumptions.collect::<Result<_, Error>>()?;
    let mut now = model.clone();
    let input = |(index, variable): (usize, &Variable)| {
        let value = now.get(index).map_err(|fault| Error(fault.message))?;
        Ok(Input {
            name: variable.name(),
            text: variable.symbol.text,
            start: match variable.kind {
                Type::Enumeration(of) => of.items.get(value as usize - 1).map_or("", |(item, _)| item).to_owned(),
                _ => variable.symbol.written(value),
            },
        })
    };
    let inputs = variables
        .iter()
        .enumerate()
        .filter(|(_, variable)| variable.role == Role::Input);
    let inputs: Vec<Input> = inputs.map(input).collect::<Result<_, Error>>()?;
    let experiment = experiment(scene, &model);
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    // The name's ending turns on escaping for HTML.
    let made = environment.add_template("index.html", TEMPLATE).and_then(|()| {
        environment.get_template("index.html")?.render(context! {
            title => scene.title(), name => scene.name(), version, hash, book, level => scene.level(), assumptions,
            experiment => Serde(experiment), inputs => Serde(inputs),
            variables => Serde(rows), terminals => Serde(terminals),
        })
    });
    made.map_err(|error| Error(format!("templates/index.html: {error:#}")))
}
