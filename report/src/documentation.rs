//! The first page of an FMU's documentation: what it is, how to use it, and every variable.

use lemnis_fmu::instance::strings;
use lemnis_fmu::layout::{self, Place};
use lemnis_models::model::{Enumeration, Model, Role, Type, Variable};
use lemnis_models::scene::Scene;
use minijinja::value::Serde;
use minijinja::{Environment, UndefinedBehavior, context};
use serde::Serialize;

use crate::book::Error;

const TEMPLATE: &str = include_str!("../../templates/index.html");

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

/// The page as HTML. `book` is the name of the book's file beside it.
///
/// # Errors
/// The scene's model cannot be built, or the template is wrong.
pub fn page(scene: &Scene, book: Option<&str>) -> Result<String, Error> {
    let model = Model::new(scene).map_err(|fault| Error(fault.message))?;
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
        text: variable.symbol.description(),
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
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    // The name's ending turns on escaping for HTML.
    let made = environment.add_template("index.html", TEMPLATE).and_then(|()| {
        environment.get_template("index.html")?.render(context! {
            title => scene.title(), name => scene.name(), version, hash, book, stop => model.stop_time(),
            coordinate => variables[0].name(),
            variables => Serde(rows), terminals => Serde(terminals),
        })
    });
    made.map_err(|error| Error(format!("templates/index.html: {error:#}")))
}
