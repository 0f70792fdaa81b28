//! modelDescription.xml of FMI 2.0 and FMI 3.0, and terminalsAndIcons.xml of both, from the model's list of variables.

use crate::instance::{CATEGORIES, strings, token};
use crate::layout::{self, Place};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::unit::{self, Unit};
use lemnis_models::kernel::variable::{Enumeration, Fault, Name, Role, TIME, Type};
use lemnis_models::registry;
use lemnis_models::scene::Scene;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};
use std::collections::{BTreeMap, BTreeSet};
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
    let entries = entries(scene, standard)?;
    document(|xml| write(xml, scene, &entries, standard))
}

/// The text of terminalsAndIcons.xml: what belongs together at a joint, a drive or a wheel group. FMI 2 takes that of FMI 3
/// as it is, since 2.0.4.
///
/// # Errors
/// The model cannot be built.
pub fn terminals_and_icons(scene: &Scene) -> Result<Vec<u8>, Fault> {
    let model = scene.model()?;
    document(|xml| {
        element(
            xml,
            "fmiTerminalsAndIcons",
            &attributes([("fmiVersion", "3.0")]),
            |xml| {
                element(xml, "GraphicalRepresentation", &[], |xml| {
                    let corners = [("x1", "-100"), ("y1", "-100"), ("x2", "100"), ("y2", "100")];
                    let mut system = attributes(corners);
                    system.push(("suggestedScalingFactorTo_mm", "0.1".to_owned()));
                    empty(xml, "CoordinateSystem", &system)?;
                    empty(xml, "Icon", &attributes(corners))
                })?;
                element(xml, "Terminals", &[], |xml| {
                    model.terminals().iter().try_for_each(|terminal| {
                        let general = attributes([
                            ("name", terminal.name.as_str()),
                            ("matchingRule", "plug"),
                            ("description", terminal.text),
                        ]);
                        element(xml, "Terminal", &general, |xml| {
                            terminal.members.iter().try_for_each(|(variable, member)| {
                                let member = attributes([
                                    ("variableName", variable),
                                    ("memberName", member),
                                    ("variableKind", "signal"),
                                ]);
                                empty(xml, "TerminalMemberVariable", &member)
                            })
                        })
                    })
                })
            },
        )
    })
}

/// A variable as the description has it.
struct Entry {
    name: String,
    text: String,
    reference: u32,
    kind: Kind,
    role: Option<Role>,
    is_discrete: bool,
    start: Option<String>,
    bounds: [f64; 2],
    nominal: Option<f64>,
    /// Number of components of a vector.
    size: Option<usize>,
    /// Value references of time, inputs, states and parameters that the value depends on.
    dependencies: BTreeSet<u32>,
    /// Value reference of the state whose rate this is.
    state: Option<u32>,
}

impl Entry {
    /// What has neither role nor bounds, and follows from nothing.
    fn new(name: &str, text: impl Into<String>, reference: u32, kind: Kind) -> Entry {
        Entry {
            name: name.to_owned(),
            text: text.into(),
            reference,
            kind,
            role: None,
            is_discrete: false,
            start: None,
            bounds: [f64::NEG_INFINITY, f64::INFINITY],
            nominal: None,
            size: None,
            dependencies: BTreeSet::new(),
            state: None,
        }
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Real(&'static Unit, &'static Unit),
    Boolean,
    Enumeration(&'static Enumeration),
    String,
}

/// Time, the model's variables, the FMU's own constants and, in FMI 3, the vectors.
fn entries(scene: &Scene, standard: Standard) -> Result<Vec<Entry>, Fault> {
    let mut model = scene.model()?;
    let variables = model.variables().to_vec();
    let reference = |place| layout::reference(variables.len(), place);
    let references: BTreeMap<Name, u32> = variables
        .iter()
        .enumerate()
        .map(|(index, v)| ((v.symbol.id, v.number), reference(Place::Variable(index))))
        .chain([((TIME.id, None), reference(Place::Time))])
        .collect();
    let dependencies: Vec<BTreeSet<u32>> = registry::dependencies(&model)
        .into_iter()
        .map(|names| names.into_iter().map(|name| references[&name]).collect())
        .collect();
    let mut nominals = nominals(&mut model);
    let mut of_states = vec![1.0; model.states()];
    model.nominals(&mut of_states);
    let is_state = |index: &usize| variables[*index].role == Role::State;
    for (index, nominal) in (0..variables.len()).filter(is_state).zip(of_states) {
        nominals[index] = Some(nominal);
    }
    let time = Kind::Real(TIME.unit, TIME.display);
    let mut entries = vec![Entry::new(TIME.id, TIME.text, reference(Place::Time), time)];
    let mut states = (0..variables.len())
        .filter(|&index| variables[index].role == Role::State)
        .map(|index| reference(Place::Variable(index)));
    for (index, variable) in variables.iter().enumerate() {
        let start = match variable.role {
            Role::Input | Role::Parameter | Role::Tunable | Role::State => Some(match variable.kind {
                Type::Enumeration(_) => format!("{}", model.get(index)?),
                _ => number(model.get(index)?),
            }),
            Role::Output | Role::Calculated | Role::Rate | Role::Indicator => None,
        };
        let kind = match variable.kind {
            Type::Real => Kind::Real(variable.symbol.unit, variable.symbol.display),
            Type::Boolean => Kind::Boolean,
            Type::Enumeration(of) => Kind::Enumeration(of),
        };
        let (text, place) = (variable.description(), reference(Place::Variable(index)));
        entries.push(Entry {
            role: Some(variable.role),
            is_discrete: variable.is_discrete(),
            start,
            bounds: variable.bounds,
            nominal: nominals[index].filter(|_| variable.kind == Type::Real),
            dependencies: dependencies[index].clone(),
            state: (variable.role == Role::Rate).then(|| states.next()).flatten(),
            ..Entry::new(&variable.name(), text, place, kind)
        });
    }
    for (index, ((name, text), start)) in layout::STRINGS.iter().zip(strings(scene)).enumerate() {
        entries.push(Entry {
            start: Some(start),
            ..Entry::new(name, *text, reference(Place::String(index)), Kind::String)
        });
    }
    if standard == Standard::Fmi3 {
        for (index, vector) in layout::vectors(&variables).into_iter().enumerate() {
            let of = vector.components.clone();
            let first = &variables[of.start];
            let text = match first.number {
                Some(_) => first.description(),
                None => format!("The vector [{first}, {}].", variables[of.start + 1]),
            };
            let kind = Kind::Real(first.symbol.unit, first.symbol.display);
            entries.push(Entry {
                role: Some(Role::Output),
                nominal: nominals[of.clone()].iter().copied().flatten().reduce(f64::max),
                size: Some(of.len()),
                dependencies: dependencies[of].iter().flatten().copied().collect(),
                ..Entry::new(vector.name, text, reference(Place::Vector(index)), kind)
            });
        }
    }
    Ok(entries)
}

/// The power of ten below the greatest amount of each variable over the default experiment.
fn nominals(model: &mut Model) -> Vec<Option<f64>> {
    const POINTS: u32 = 12;
    let stop = model.stop_time();
    let mut greatest = vec![0.0; model.variables().len()];
    for i in 0..=POINTS {
        model.set_time(stop * f64::from(i) / f64::from(POINTS));
        for (index, greatest) in greatest.iter_mut().enumerate() {
            let value = model.get(index).map_or(0.0, f64::abs);
            *greatest = f64::max(*greatest, if value.is_finite() { value } else { 0.0 });
        }
    }
    model.set_time(0.0);
    let power = |value: f64| (value > 0.0).then(|| format!("1e{:.0}", value.log10().floor()));
    let read = |text: String| text.parse().expect("a power of ten");
    greatest.into_iter().map(|value| power(value).map(read)).collect()
}

fn document(content: impl FnOnce(&mut Xml) -> io::Result<()>) -> Result<Vec<u8>, Fault> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))
        .and_then(|()| content(&mut xml))
        .map_err(|error| Fault::new(error.to_string()))?;
    Ok(xml.into_inner())
}

fn write(xml: &mut Xml, scene: &Scene, entries: &[Entry], standard: Standard) -> io::Result<()> {
    let model = scene.model().map_err(|fault| io::Error::other(fault.message))?;
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
        ("license", "MIT OR Apache-2.0"),
        ("generationTool", concat!("Lemnis ", env!("CARGO_PKG_VERSION"))),
        ("variableNamingConvention", "structured"),
    ]);
    if standard == Standard::Fmi2 {
        root.push(("numberOfEventIndicators", model.indicators().to_string()));
    }
    element(xml, "fmiModelDescription", &root, |xml| {
        interfaces(xml, scene, entries, model.has_derivatives(), standard)?;
        element(xml, "UnitDefinitions", &[], |xml| units(xml, entries))?;
        element(xml, "TypeDefinitions", &[], |xml| types(xml, entries, standard))?;
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
            entries.iter().try_for_each(|entry| variable(xml, entry, standard))
        })?;
        element(xml, "ModelStructure", &[], |xml| structure(xml, entries, standard))
    })
}

fn interfaces(
    xml: &mut Xml,
    scene: &Scene,
    entries: &[Entry],
    derivatives: bool,
    standard: Standard,
) -> io::Result<()> {
    // A result of a few names has no indicator that tells its change: the end of a step does.
    let named = |entry: &Entry| matches!(entry.kind, Kind::Enumeration(_)) && entry.role == Some(Role::Output);
    let ends = entries.iter().any(named);
    let yes = || "true".to_owned();
    let (get_and_set, serialize, directional) = match standard {
        Standard::Fmi2 => (
            "canGetAndSetFMUstate",
            "canSerializeFMUstate",
            "providesDirectionalDerivative",
        ),
        Standard::Fmi3 => (
            "canGetAndSetFMUState",
            "canSerializeFMUState",
            "providesDirectionalDerivatives",
        ),
    };
    let mut common = vec![
        ("modelIdentifier", scene.name().to_owned()),
        (get_and_set, yes()),
        (serialize, yes()),
        (directional, derivatives.to_string()),
    ];
    let mut model_exchange = Vec::new();
    let mut co_simulation = vec![("canHandleVariableCommunicationStepSize", yes())];
    match standard {
        Standard::Fmi2 => model_exchange.push(("completedIntegratorStepNotNeeded", (!ends).to_string())),
        Standard::Fmi3 => {
            if ends {
                model_exchange.push(("needsCompletedIntegratorStep", yes()));
            }
            common.push(("providesAdjointDerivatives", derivatives.to_string()));
            co_simulation.push(("hasEventMode", yes()));
        }
    }
    model_exchange.splice(0..0, common.iter().cloned());
    co_simulation.splice(0..0, common);
    empty(xml, "ModelExchange", &model_exchange)?;
    empty(xml, "CoSimulation", &co_simulation)
}

/// The units in use with their display units, in the order of the table of units.
fn used(entries: &[Entry]) -> impl Iterator<Item = (&'static Unit, &'static Unit)> {
    let uses = move |unit, display| entries.iter().any(|entry| entry.kind == Kind::Real(unit, display));
    unit::ALL.iter().flat_map(move |&unit| {
        let displays = unit::ALL.iter().filter(move |&display| uses(unit, display));
        displays.map(move |&display| (unit, display))
    })
}

/// Every unit of the variables, with the display units that are used with it.
fn units(xml: &mut Xml, entries: &[Entry]) -> io::Result<()> {
    let used: Vec<(&Unit, &Unit)> = used(entries).collect();
    used.chunk_by(|a, b| a.0 == b.0).try_for_each(|displays| {
        let unit = displays[0].0;
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
            let displays = displays.iter().filter(|(unit, display)| unit != display);
            displays.clone().try_for_each(|(_, display)| {
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

/// One type for each quantity in each display unit: `Angle_deg`; and the enumerations.
fn types(xml: &mut Xml, entries: &[Entry], standard: Standard) -> io::Result<()> {
    let mut enumerations: Vec<&Enumeration> = Vec::new();
    for entry in entries {
        if let Kind::Enumeration(of) = entry.kind
            && !enumerations.contains(&of)
        {
            enumerations.push(of);
        }
    }
    enumerations.into_iter().try_for_each(|of| {
        let general = attributes([("name", of.name)]);
        let items = |xml: &mut Xml| {
            (1..).zip(of.items).try_for_each(|(value, (name, text))| {
                let value: u32 = value;
                let item = attributes([("name", name), ("value", &value.to_string()), ("description", text)]);
                empty(xml, "Item", &item)
            })
        };
        match standard {
            Standard::Fmi2 => element(xml, "SimpleType", &general, |xml| {
                element(xml, "Enumeration", &[], items)
            }),
            Standard::Fmi3 => element(xml, "EnumerationType", &general, items),
        }
    })?;
    used(entries).try_for_each(|(unit, display)| {
        let mut own = attributes([("quantity", unit.quantity()), ("unit", unit.name)]);
        if display != unit {
            own.push(("displayUnit", display.name.to_owned()));
        }
        let mut general = vec![("name", type_name(unit, display))];
        match standard {
            Standard::Fmi2 => element(xml, "SimpleType", &general, |xml| empty(xml, "Real", &own)),
            Standard::Fmi3 => {
                general.extend(own);
                empty(xml, "Float64Type", &general)
            }
        }
    })
}

fn type_name(unit: &Unit, display: &Unit) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = match display.name {
        "%" => "percent".to_owned(),
        "1" => return unit.quantity().to_owned(),
        name => name.chars().map(plain).collect(),
    };
    format!("{}_{name}", unit.quantity())
}

/// A variable: one element in FMI 3, a type inside a `ScalarVariable` in FMI 2.
fn variable(xml: &mut Xml, entry: &Entry, standard: Standard) -> io::Result<()> {
    let (causality, initial, fixed) = match (entry.role, entry.kind) {
        (Some(Role::Input), _) => ("input", None, None),
        (Some(Role::Parameter), _) => ("parameter", Some("exact"), Some("fixed")),
        (Some(Role::Tunable), _) => ("parameter", Some("exact"), Some("tunable")),
        (Some(Role::Output), _) => ("output", Some("calculated"), None),
        (Some(Role::State), _) => ("output", Some("exact"), None),
        (Some(Role::Rate | Role::Indicator), _) => ("local", Some("calculated"), None),
        (Some(Role::Calculated), _) => ("calculatedParameter", Some("calculated"), Some("fixed")),
        (None, Kind::String) => ("local", Some("exact"), Some("constant")),
        (None, _) => ("independent", None, None),
    };
    let variability = fixed.unwrap_or(if entry.is_discrete { "discrete" } else { "continuous" });
    let mut general = vec![
        ("name", entry.name.to_owned()),
        ("valueReference", entry.reference.to_string()),
        ("description", entry.text.clone()),
        ("causality", causality.to_owned()),
        ("variability", variability.to_owned()),
    ];
    general.extend(initial.map(|initial| ("initial", initial.to_owned())));
    let mut own = Vec::new();
    if let Kind::Real(unit, display) = entry.kind {
        own.push(("declaredType", type_name(unit, display)));
        for (name, bound) in ["min", "max"].into_iter().zip(entry.bounds) {
            own.extend(bound.is_finite().then(|| (name, number(bound))));
        }
        own.extend(entry.nominal.map(|nominal| ("nominal", number(nominal))));
    }
    if let Kind::Enumeration(of) = entry.kind {
        own.push(("declaredType", of.name.to_owned()));
    }
    // FMI 2 counts variables from 1.
    let shift = u32::from(standard == Standard::Fmi2);
    own.extend(entry.state.map(|state| ("derivative", (state + shift).to_string())));
    let start = |own: &mut Attributes| own.extend(entry.start.clone().map(|start| ("start", start)));
    let name = match (entry.kind, standard) {
        (Kind::Real(..), Standard::Fmi2) => "Real",
        (Kind::Real(..), Standard::Fmi3) => "Float64",
        (Kind::Boolean, _) => "Boolean",
        (Kind::Enumeration(_), _) => "Enumeration",
        (Kind::String, _) => "String",
    };
    match standard {
        Standard::Fmi2 => {
            start(&mut own);
            element(xml, "ScalarVariable", &general, |xml| empty(xml, name, &own))
        }
        Standard::Fmi3 => {
            general.extend(own);
            if entry.kind != Kind::String {
                start(&mut general);
            }
            match (entry.size, &entry.start) {
                (Some(size), _) => element(xml, name, &general, |xml| {
                    empty(xml, "Dimension", &[("start", size.to_string())])
                }),
                (None, Some(value)) if entry.kind == Kind::String => element(xml, name, &general, |xml| {
                    empty(xml, "Start", &[("value", value.clone())])
                }),
                _ => empty(xml, name, &general),
            }
        }
    }
}

/// Outputs, and the unknowns of initialization: outputs and calculated parameters.
/// During the simulation inputs and time are known, at initialization the parameters too.
fn structure(xml: &mut Xml, entries: &[Entry], standard: Standard) -> io::Result<()> {
    let during: BTreeSet<u32> = entries
        .iter()
        .filter(|entry| matches!(entry.role, Some(Role::Input | Role::State)) || entry.name == TIME.id)
        .map(|entry| entry.reference)
        .collect();
    let unknowns = |xml: &mut Xml, name: &str, roles: &[Role], initial: bool| {
        entries
            .iter()
            .filter(|entry| entry.role.is_some_and(|role| roles.contains(&role)))
            .try_for_each(|entry| {
                let known = entry
                    .dependencies
                    .iter()
                    .filter(|known| initial || during.contains(known));
                // FMI 2 counts variables from 1, and they stand in the order of their references.
                let (attribute, shift) = match standard {
                    Standard::Fmi2 => ("index", 1),
                    Standard::Fmi3 => ("valueReference", 0),
                };
                let known: Vec<String> = known.map(|known| (known + shift).to_string()).collect();
                let unknown = [
                    (attribute, (entry.reference + shift).to_string()),
                    ("dependencies", known.join(" ")),
                ];
                empty(xml, name, &unknown)
            })
    };
    let outputs: &[Role] = &[Role::State, Role::Output];
    let initially: &[Role] = &[Role::Output, Role::Calculated, Role::Rate];
    // FMI 2 only says how many event indicators there are.
    for (list, name, roles, initial) in [
        ("Outputs", "Output", outputs, false),
        ("Derivatives", "ContinuousStateDerivative", &[Role::Rate], false),
        ("InitialUnknowns", "InitialUnknown", initially, true),
        ("", "EventIndicator", &[Role::Indicator], false),
    ] {
        let exists = entries
            .iter()
            .any(|entry| entry.role.is_some_and(|role| roles.contains(&role)));
        match standard {
            _ if !exists => {}
            Standard::Fmi2 if list.is_empty() => {}
            Standard::Fmi2 => element(xml, list, &[], |xml| unknowns(xml, "Unknown", roles, initial))?,
            Standard::Fmi3 => unknowns(xml, name, roles, initial)?,
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
    // Zero has no sign.
    format!("{:?}", value + 0.0)
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
