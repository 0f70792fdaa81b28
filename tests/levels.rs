//! Only what the scene requires: the same crane with its parts switched off one by one, and what it is asked for:
//! `cargo bench --workspace --bench levels`. Work is counted in instructions of one step of 1 ms, by valgrind where
//! it is installed; `tests/test_parts.py` checks that everything that can be counted falls. Nothing here fails.

use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

use lemnis_fmu::description::{Standard, model_description};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;
use lemnis_models::scene::{DEFAULT, Scene};

#[path = "../models/tests/common/levels.rs"]
mod levels;

/// Cranes, each with fewer parts than the one before it; and the same with a cylinder.
const PARTS: [&[&str]; 2] = [
    &[
        "swing with slewing, balance",
        "swing with slewing",
        "swing",
        "rigid",
        "static",
        "static without drive",
        "kinematic",
    ],
    &["hydraulic with swing", "hydraulic", "static"],
];

/// Cranes with what they are asked for, each less than the one before it; the last two have no forces to ask for.
const ASKED: [&[(&str, &str)]; 3] = [
    &[
        ("swing with slewing, balance", "everything"),
        ("swing with slewing, balance", "forces"),
        ("swing with slewing, balance", "reach"),
        ("swing with slewing, balance", "nothing"),
    ],
    &[
        ("static", "everything"),
        ("static", "forces"),
        ("static", "reach"),
        ("static", "nothing"),
    ],
    &[("kinematic", "reach"), ("kinematic", "nothing")],
];

/// A communication step, in s.
const STEP: f64 = 1e-3;

fn scene(level: &str) -> Scene {
    // Of the default scene's tables, in their order.
    let until = |name: &str| &DEFAULT[..DEFAULT.find(name).expect("a table of the default scene")];
    let text = match level {
        "static without drive" => until("[luffing.drive]").to_owned(),
        "kinematic" => until("[luffing.weights]").replace("Q = \"160 kN\"", ""),
        _ => return levels::scene(level),
    };
    Scene::parse(&text).unwrap_or_else(|mistakes| panic!("{level}: {mistakes:?}"))
}

/// Variables that are read after every step.
fn asked(model: &Model, what: &str) -> Vec<usize> {
    let wanted = |i: &usize| {
        let variable = &model.variables()[*i];
        match what {
            "everything" => variable.role == Role::Output,
            "forces" => matches!(variable.symbol.id, "R" | "M_Q" | "M_D" | "F_d"),
            "reach" => variable.symbol.id == "R",
            _ => false,
        }
    };
    (0..model.variables().len()).filter(wanted).collect()
}

/// Steps of a model that luffs; what is asked for is read after each.
fn run(model: &mut Model, wanted: &[usize], steps: u32) {
    for step in 0..steps {
        let t = f64::from(step) * STEP;
        model.advance(t, t + STEP).expect("moves");
        for &index in wanted {
            black_box(model.get(index).expect("exists"));
        }
    }
}

/// Time of a step, in ns: the best of many runs of a second.
fn time(level: &str, what: &str) -> f64 {
    let mut model = scene(level).model().expect("built");
    let (wanted, saved) = (asked(&model, what), model.state());
    let mut best = f64::INFINITY;
    for _ in 0..100 {
        model.set_state(&saved);
        let clock = Instant::now();
        run(&mut model, &wanted, 1000);
        best = best.min(clock.elapsed().as_secs_f64());
    }
    1e9 * best / 1000.0
}

/// Instructions of a step, in the mean of half a second; `None` without valgrind.
fn work(level: &str, what: &str) -> Option<u64> {
    let count = |steps: u32| -> Option<u64> {
        let program = std::env::current_exe().expect("this one");
        let done = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(program)
            .args(["count", level, what, &steps.to_string()])
            .output()
            .ok()
            .filter(|done| done.status.success())?;
        let told = String::from_utf8_lossy(&done.stderr).into_owned();
        told.lines()
            .find_map(|line| line.split("Collected :").nth(1)?.trim().parse().ok())
    };
    // What comes before the first step is in both.
    Some((count(1000)? - count(500)?) / 500)
}

fn row(level: &str, what: &str) {
    let scene = scene(level);
    let xml = model_description(&scene, Standard::Fmi3).expect("described").len();
    let model = scene.model().expect("built");
    let saved = 8 * model.numbers(&model.state()).len();
    let work = work(level, what).map_or("-".to_owned(), |work| work.to_string());
    println!(
        "{level:28} {what:10} {:>6} {:>9} {saved:>11} {xml:>12} {work:>12} {:>7.0}",
        model.states(),
        model.variables().len(),
        time(level, what)
    );
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [command, level, what, steps] = arguments.as_slice()
        && command == "count"
    {
        let mut model = scene(level).model().expect("built");
        let wanted = asked(&model, what);
        run(&mut model, &wanted, steps.parse().expect("a number of steps"));
        return;
    }
    println!(
        "{:28} {:10} {:>6} {:>9} {:>11} {:>12} {:>12} {:>7}",
        "crane", "asked for", "states", "variables", "saved/bytes", "XML/bytes", "instructions", "time/ns"
    );
    for chain in PARTS {
        for level in chain {
            row(level, "everything");
        }
        println!();
    }
    for asked in ASKED {
        for (level, what) in asked {
            row(level, what);
        }
        println!();
    }
}
