//! What must not change while the code is arranged anew: for every ready scene and every variation of it, each
//! variable's values and derivatives to the last bit, what it depends on, the saved state, where a motion is after a
//! hundred steps; and modelDescription.xml of the ready scenes as text.
//!
//! The files in `bits/` are written on purpose only: `LEMNIS_WRITE=1 cargo test --release --workspace --test bits`.
//! Lines stand by name, so that the order of variables shows in the XML alone.

#[path = "../models/tests/common/balances.rs"]
mod balances;
#[path = "../models/tests/common/levels.rs"]
mod levels;

use lemnis_fmu::description::{Standard, model_description};
use lemnis_models::kernel::variable::{Name, PART_OF_RANGE, Role, Variable};
use lemnis_models::registry::dependencies;
use lemnis_models::scene::{DEFAULT, Scene};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Where in the working range values are taken; derivatives at every third place.
const PLACES: [f64; 7] = [0.0, 0.1237, 0.31, 0.5, 0.6871, 0.873, 1.0];
/// Steps after which a motion is looked at.
const STEPS: u32 = 100;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The ready scenes by the names of their files.
fn ready() -> Vec<(String, Scene)> {
    let folder = std::fs::read_dir(root().join("../models/scenes")).expect("a folder");
    let mut paths: Vec<PathBuf> = folder.map(|entry| entry.expect("a file").path()).collect();
    paths.sort();
    let scene = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("readable");
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        (name, parse(&text))
    };
    paths.into_iter().map(scene).collect()
}

fn parse(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"))
}

/// The default scene otherwise driven, dimensioned and loaded; every kind of balance; every level; other levels and
/// inputs of ready scenes.
fn variations() -> Vec<(String, Scene)> {
    let rocker = DEFAULT
        .replace("driven = \"boom\"", "driven = \"rocker\"")
        .replace("from  = \"60 deg\"", "from = \"50 deg\"")
        .replace("to    = \"120 deg\"", "to = \"130 deg\"")
        .replace("branch = \"left\"", "branch = \"right\"");
    let rocker = &rocker[..rocker.find("[luffing.published]").expect("there")];
    let bare = &DEFAULT[..DEFAULT.find("[luffing.weights]").expect("there")];
    let mut all = vec![
        ("rocker".to_owned(), parse(rocker)),
        (
            "angle".to_owned(),
            parse(&DEFAULT.replace("X_7 = \"1.354 m\"", "beta_0 = \"163.122 deg\"")),
        ),
        (
            "axis".to_owned(),
            parse(&DEFAULT.replace("X_7 = \"1.354 m\"", "AC = \"22.3 m\"")),
        ),
        ("bare".to_owned(), parse(bare)),
        ("kinematic".to_owned(), parse(&bare.replace("Q = \"160 kN\"", ""))),
    ];
    let kinds = balances::every_kind();
    all.extend((1..).zip(&kinds).map(|(i, text)| (format!("balance_{i}"), parse(text))));
    let level = |name: &str| (name.replace(',', "").replace(' ', "_"), levels::scene(name));
    all.extend(levels::LEVELS.into_iter().skip(1).map(level));
    for (name, scene) in ready() {
        let of = |level: &&'static str| (format!("{name}_{level}"), scene.at(level));
        let levels = scene.levels();
        let own = |level: &&&str| scene.text().contains(&format!("fidelity = \"{level}\""));
        let others = levels
            .iter()
            .filter(|level| !own(level) && !matches!(**level, "static" | "kinematic"));
        all.extend(others.map(of));
    }
    all
}

/// A number in (0.5, 1.5) that belongs to a name.
fn weight(name: &str) -> f64 {
    let hash = name.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    0.5 + (hash >> 11) as f64 / (1_u64 << 53) as f64
}

fn word(value: Option<f64>) -> String {
    // Zeros of both signs are one number.
    value.map_or_else(|| "-".to_owned(), |value| format!("{:016x}", (value + 0.0).to_bits()))
}

fn name((id, number): Name) -> String {
    match number {
        None => id.to_owned(),
        Some(number) => format!("{id}[{number}]"),
    }
}

/// All that is pinned of a scene, a line for each variable.
fn pinned(scene: &Scene) -> String {
    let mut model = scene.model().expect("a ready scene runs");
    let variables: Vec<Variable> = model.variables().to_vec();
    let mut lines: Vec<Vec<String>> = variables
        .iter()
        .map(|v| vec![v.name(), format!("{:?}", v.role)])
        .collect();
    let positions = model.positions();
    let (from, to) = (positions[0], positions[positions.len() - 1]);
    for (i, place) in PLACES.into_iter().enumerate() {
        model.place(from + (to - from) * place).expect("within the range");
        model.update().expect("within the range");
        for (index, line) in lines.iter_mut().enumerate() {
            line.push(word(model.get(index).ok()));
        }
        if i % 3 != 0 || !model.has_derivatives() {
            continue;
        }
        // The part of the range is the coordinate by another name.
        let given =
            |variable: &Variable, roles: &[Role]| roles.contains(&variable.role) && variable.symbol != &PART_OF_RANGE;
        let changing: &[Role] = &[Role::Input, Role::State];
        let fixed: &[Role] = &[Role::Parameter, Role::Tunable];
        for roles in [changing, fixed] {
            let seeds: Vec<_> = (0..variables.len())
                .filter(|&index| given(&variables[index], roles))
                .map(|index| {
                    let size = model.get(index).expect("given").abs();
                    let rate = weight(&variables[index].name()) * if size > 0.0 { size } else { 1.0 };
                    (variables[index].quantity(), rate)
                })
                .collect();
            let seed = |quantity| {
                seeds
                    .iter()
                    .find(|(known, _)| *known == quantity)
                    .map_or(0.0, |(_, rate)| *rate)
            };
            let mut tangent = model.tangent(&seed);
            for (index, line) in lines.iter_mut().enumerate() {
                line.push(word(model.derivative(&mut tangent, index).ok()));
            }
        }
    }
    for (line, found) in lines.iter_mut().zip(dependencies(&model)) {
        let names: Vec<String> = found.into_iter().map(name).collect();
        line.push(names.join(" "));
    }
    lines.sort();
    let mut text = String::new();
    for line in lines {
        writeln!(text, "{}", line.join("\t")).expect("a string");
    }
    let mut model = scene.model().expect("a ready scene runs");
    model.start().expect("at the start");
    let mut saved: Vec<String> = model
        .numbers(&model.state())
        .into_iter()
        .map(|x| word(Some(x)))
        .collect();
    saved.sort();
    writeln!(text, "saved\t{}", saved.join(" ")).expect("a string");
    let step = model.step_size().min(model.stop_time() / f64::from(STEPS));
    for i in 0..STEPS {
        if let Err(fault) = model.advance(f64::from(i) * step, f64::from(i + 1) * step) {
            writeln!(text, "ends\t{}", fault.message).expect("a string");
            break;
        }
    }
    let mut states = vec![0.0; model.states()];
    model.get_states(&mut states);
    let states: Vec<String> = states.into_iter().map(|x| word(Some(x))).collect();
    writeln!(text, "after {STEPS} steps\t{}", states.join(" ")).expect("a string");
    text
}

/// Compares a text with its file, or writes it where that is asked for.
fn hold(file: &str, text: &str, broken: &mut Vec<String>) {
    let path = root().join("bits").join(file);
    if std::env::var_os("LEMNIS_WRITE").is_some() {
        std::fs::create_dir_all(root().join("bits")).expect("a folder");
        std::fs::write(&path, text).expect("writable");
        return;
    }
    let known = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    let (old, new) = (known.lines(), text.lines());
    let differs: Vec<String> = old
        .zip(new)
        .filter(|(old, new)| old != new)
        .map(|(old, new)| format!("  - {old}\n  + {new}"))
        .collect();
    if known != text {
        let shown = differs
            .iter()
            .take(3)
            .map(String::as_str)
            .collect::<Vec<_>>()
            .join("\n");
        broken.push(format!("{file}: {} lines differ\n{shown}", differs.len().max(1)));
    }
}

#[test]
fn every_bit_is_where_it_was() {
    let mut broken = Vec::new();
    for (name, scene) in ready().into_iter().chain(variations()) {
        hold(&format!("{name}.tsv"), &pinned(&scene), &mut broken);
    }
    for (name, scene) in ready() {
        for (standard, end) in [(Standard::Fmi2, "fmi2"), (Standard::Fmi3, "fmi3")] {
            let xml = model_description(&scene, standard).expect("described");
            hold(
                &format!("{name}.{end}.xml"),
                &String::from_utf8(xml).expect("UTF-8"),
                &mut broken,
            );
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}
