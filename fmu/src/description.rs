//! modelDescription.xml of FMI 2.0 and FMI 3.0, from the model's list of variables.

use crate::instance::{CATEGORIES, token};
use lemnis_models::model::{Fault, Model, Role, Variable};
use lemnis_models::scene::Scene;
use lemnis_models::unit::{self, Unit};
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};
use std::io;

/// A version of FMI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standard {
    Fmi2,
    Fmi3,
}

/// Relative tolerance of the default experiment. The model is algebraic: it does not depend on it.
const TOLERANCE: &str = "1e-6";

type Xml = Writer<Vec<u8>>;
type Attributes<'a> = Vec<(&'a str, String)>;

/// The text of modelDescription.xml.
///
/// # Errors
/// The model cannot be built, or a start value does not exist.
pub fn model_description(scene: &Scene, standard: Standard) -> Result<Vec<u8>, Fault> {
    let mut model = Model::new(scene)?;
    let mut starts = Vec::new();
    for (index, variable) in model.variables().to_vec().into_iter().enumerate() {
        starts.push(match variable.role {
            Role::Input | Role::Parameter => Some(model.get(index)?),
            Role::Output | Role::Calculated => None,
        });
    }
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    write(&mut xml, scene, &model, &starts, standard).map_err(|error| Fault(error.to_string()))?;
    Ok(xml.into_inner())
}

fn write(xml: &mut Xml, scene: &Scene, model: &Model, starts: &[Option<f64>], standard: Standard) -> io::Result<()> {
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let (version, token_name) = match standard {
        Standard::Fmi2 => ("2.0", "guid"),
        Standard::Fmi3 => ("3.0", "instantiationToken"),
    };
    let mut root = attributes([
        ("fmiVersion", version),
        ("modelName", scene.name()),
        (token_name, &token(scene)),
        ("description", scene.title()),
        ("version", env!("CARGO_PKG_VERSION")),
        ("generationTool", concat!("Lemnis ", env!("CARGO_PKG_VERSION"))),
        ("variableNamingConvention", "structured"),
    ]);
    if standard == Standard::Fmi2 {
        root.push(("numberOfEventIndicators", "0".to_owned()));
    }
    element(xml, "fmiModelDescription", &root, |xml| {
        interfaces(xml, scene, standard)?;
        element(xml, "UnitDefinitions", &[], |xml| units(xml, model.variables()))?;
        element(xml, "LogCategories", &[], |xml| {
            CATEGORIES.iter().try_for_each(|(name, description)| {
                let name = name.to_string_lossy();
                empty(
                    xml,
                    "Category",
                    &attributes([("name", &*name), ("description", description)]),
                )
            })
        })?;
        let experiment = [
            ("startTime", number(0.0)),
            ("stopTime", number(model.stop_time())),
            ("tolerance", TOLERANCE.to_owned()),
            ("stepSize", number(model.step_size())),
        ];
        empty(xml, "DefaultExperiment", &experiment)?;
        element(xml, "ModelVariables", &[], |xml| {
            time(xml, standard)?;
            model
                .variables()
                .iter()
                .zip(starts)
                .enumerate()
                .try_for_each(|(index, (variable, start))| write_variable(xml, index + 1, variable, *start, standard))
        })?;
        element(xml, "ModelStructure", &[], |xml| {
            structure(xml, model.variables(), standard)
        })
    })
}

fn interfaces(xml: &mut Xml, scene: &Scene, standard: Standard) -> io::Result<()> {
    let (get_and_set, serialize) = match standard {
        Standard::Fmi2 => ("canGetAndSetFMUstate", "canSerializeFMUstate"),
        Standard::Fmi3 => ("canGetAndSetFMUState", "canSerializeFMUState"),
    };
    let common = attributes([
        ("modelIdentifier", scene.name()),
        (get_and_set, "true"),
        (serialize, "true"),
    ]);
    empty(xml, "ModelExchange", &common)?;
    let mut co_simulation = common;
    co_simulation.push(("canHandleVariableCommunicationStepSize", "true".to_owned()));
    if standard == Standard::Fmi3 {
        co_simulation.push(("hasEventMode", "true".to_owned()));
    }
    empty(xml, "CoSimulation", &co_simulation)
}

/// Every unit of the variables and of time, with the display units that are used with it.
fn units(xml: &mut Xml, variables: &[Variable]) -> io::Result<()> {
    let used: Vec<(&Unit, &Unit)> = std::iter::once((&unit::S, &unit::S))
        .chain(
            variables
                .iter()
                .filter(|variable| !variable.boolean)
                .map(|v| (v.symbol.unit, v.symbol.display)),
        )
        .collect();
    unit::ALL
        .iter()
        .filter(|&unit| used.iter().any(|(used, _)| used == unit))
        .try_for_each(|unit| {
            element(xml, "Unit", &attributes([("name", unit.name)]), |xml| {
                let exponents = [
                    ("kg", unit.dimension.kg),
                    ("m", unit.dimension.m),
                    ("s", unit.dimension.s),
                    ("rad", unit.rad),
                ];
                let base: Attributes = exponents
                    .iter()
                    .filter(|(_, exponent)| *exponent != 0)
                    .map(|(name, e)| (*name, e.to_string()))
                    .collect();
                empty(xml, "BaseUnit", &base)?;
                unit::ALL
                    .iter()
                    .filter(|&display| display != unit && used.contains(&(unit, display)))
                    .try_for_each(|display| {
                        let factor = number(display.factor.recip());
                        empty(
                            xml,
                            "DisplayUnit",
                            &[("name", display.name.to_owned()), ("factor", factor)],
                        )
                    })
            })
        })
}

/// Time, the independent variable: value reference 0.
fn time(xml: &mut Xml, standard: Standard) -> io::Result<()> {
    let general = attributes([
        ("name", "time"),
        ("valueReference", "0"),
        ("description", "Simulation time"),
        ("causality", "independent"),
        ("variability", "continuous"),
    ]);
    typed(xml, general, "Real", attributes([("unit", unit::S.name)]), standard)
}

fn write_variable(
    xml: &mut Xml,
    reference: usize,
    variable: &Variable,
    start: Option<f64>,
    standard: Standard,
) -> io::Result<()> {
    let symbol = variable.symbol;
    let (causality, initial, fixed) = match variable.role {
        Role::Input => ("input", None, false),
        Role::Parameter => ("parameter", Some("exact"), true),
        Role::Output => ("output", None, false),
        Role::Calculated => ("calculatedParameter", Some("calculated"), true),
    };
    let variability = match (fixed, variable.boolean) {
        (true, _) => "fixed",
        (false, true) => "discrete",
        (false, false) => "continuous",
    };
    let reference = reference.to_string();
    let mut general = attributes([
        ("name", symbol.id),
        ("valueReference", &reference),
        ("description", symbol.text),
        ("causality", causality),
        ("variability", variability),
    ]);
    general.extend(initial.map(|initial| ("initial", initial.to_owned())));
    let mut own = Vec::new();
    if !variable.boolean {
        own.push(("unit", symbol.unit.name.to_owned()));
        if symbol.display != symbol.unit {
            own.push(("displayUnit", symbol.display.name.to_owned()));
        }
    }
    own.extend(start.map(|start| {
        (
            "start",
            if variable.boolean {
                (start != 0.0).to_string()
            } else {
                number(start)
            },
        )
    }));
    typed(
        xml,
        general,
        if variable.boolean { "Boolean" } else { "Real" },
        own,
        standard,
    )
}

/// A variable: one element in FMI 3, a type inside a `ScalarVariable` in FMI 2.
fn typed<'a>(
    xml: &mut Xml,
    mut general: Attributes<'a>,
    kind: &str,
    own: Attributes<'a>,
    standard: Standard,
) -> io::Result<()> {
    match standard {
        Standard::Fmi2 => element(xml, "ScalarVariable", &general, |xml| empty(xml, kind, &own)),
        Standard::Fmi3 => {
            general.extend(own);
            empty(xml, if kind == "Real" { "Float64" } else { kind }, &general)
        }
    }
}

/// Outputs, and the unknowns of initialization: outputs and calculated parameters.
fn structure(xml: &mut Xml, variables: &[Variable], standard: Standard) -> io::Result<()> {
    let unknowns = |xml: &mut Xml, name: &str, roles: &[Role]| {
        variables
            .iter()
            .enumerate()
            .filter(|(_, variable)| roles.contains(&variable.role))
            .try_for_each(|(index, _)| {
                // FMI 2 counts variables from 1, and time is the first.
                match standard {
                    Standard::Fmi2 => empty(xml, "Unknown", &[("index", (index + 2).to_string())]),
                    Standard::Fmi3 => empty(xml, name, &[("valueReference", (index + 1).to_string())]),
                }
            })
    };
    for (list, name, roles) in [
        ("Outputs", "Output", &[Role::Output][..]),
        (
            "InitialUnknowns",
            "InitialUnknown",
            &[Role::Output, Role::Calculated][..],
        ),
    ] {
        match standard {
            Standard::Fmi2 => element(xml, list, &[], |xml| unknowns(xml, name, roles))?,
            Standard::Fmi3 => unknowns(xml, name, roles)?,
        }
    }
    Ok(())
}

fn attributes<'a, const N: usize>(pairs: [(&'a str, &str); N]) -> Attributes<'a> {
    pairs
        .into_iter()
        .map(|(name, value)| (name, value.to_owned()))
        .collect()
}

/// The shortest decimal that reads back as the same number.
fn number(value: f64) -> String {
    format!("{value:?}")
}

fn element(
    xml: &mut Xml,
    name: &str,
    attributes: &[(&str, String)],
    content: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    let attributes = attributes.iter().map(|(name, value)| (*name, value.as_str()));
    xml.create_element(name)
        .with_attributes(attributes)
        .write_inner_content(content)
        .map(drop)
}

fn empty(xml: &mut Xml, name: &str, attributes: &[(&str, String)]) -> io::Result<()> {
    let attributes = attributes.iter().map(|(name, value)| (*name, value.as_str()));
    xml.create_element(name)
        .with_attributes(attributes)
        .write_empty()
        .map(drop)
}
