//! Books beside their goals: `cargo bench --workspace --bench goals -- books`, after a build of the program. What Typst alone
//! takes for the same source is measured in the same rounds, by its Python binding in the environment of the tests.

use std::io::BufRead;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use lemnis_models::book::LEVELS;
use lemnis_models::scene::DEFAULT;

use crate::{program, row, timed};

/// Rounds of which the best counts.
const ROUNDS: usize = 9;
/// A book over Typst's own compile of its source.
const OVER_TYPST: f64 = 1.05;

/// The first compile of a process, in s: fonts are read, nothing is remembered; by the standard that books keep to.
const TYPST: &str = "import sys, time, typst
begun = time.perf_counter()
typst.compile(sys.argv[1], format='pdf', pdf_standards='ua-1', ignore_system_fonts=True)
print(time.perf_counter() - begun)";

pub fn rows() {
    let program = program();
    LEVELS.iter().for_each(|level| cold(&program, level));
    many(&program);
    for (what, from, to) in [
        ("a limit", "mu_min    = \"30 deg\"", "mu_min    = \"31 deg\""),
        ("the load", "Q = \"160 kN\"", "Q = \"161 kN\""),
        ("a length", "X_1 = \"19.3 m\"", "X_1 = \"19.31 m\""),
    ] {
        watch(&program, what, from, to);
    }
}

/// Python with the packages of the tests; `python3 tests/run.py` sets it up.
fn python() -> PathBuf {
    let environment = Path::new(env!("CARGO_MANIFEST_DIR")).join("../.venv");
    environment.join(if cfg!(windows) {
        "Scripts/python.exe"
    } else {
        "bin/python"
    })
}

/// One book in a process of its own, and Typst alone with its source in turn.
fn cold(program: &Path, level: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    let make = |format: &str| -> Duration {
        timed(
            Command::new(program)
                .args(["book", "--level", level, "--format", format, "--output"])
                .arg(folder.path()),
        )
    };
    make("typ");
    let source = folder.path().join("LemniscateCrane.typ");
    let alone = || -> Option<f64> {
        let done = Command::new(python()).args(["-c", TYPST]).arg(&source).output().ok()?;
        String::from_utf8_lossy(&done.stdout).trim().parse().ok()
    };
    let (mut own, mut typst) = (f64::INFINITY, Some(f64::INFINITY));
    for _ in 0..ROUNDS {
        own = own.min(make("pdf").as_secs_f64());
        typst = typst.zip(alone()).map(|(best, now)| best.min(now));
    }
    row(&format!("lemnis book, {level}, cold"), own * 1e3, "ms", 1000.0);
    match typst {
        Some(typst) => {
            println!(
                "{:<62} {:>9.1} ms",
                format!("Typst alone, {level}, the same source"),
                typst * 1e3
            );
            let (what, over) = (format!("lemnis book, {level}, over Typst alone"), own / typst);
            let verdict = if over <= OVER_TYPST { "reached" } else { "MISSED" };
            println!("{what:<62} {over:>9.3}     goal {OVER_TYPST:>7}     {verdict}");
        }
        None => println!("Typst alone: not measured, python3 tests/run.py sets up its Python binding"),
    }
}

/// A hundred books of a hundred cranes, each with another boom, in one call.
fn many(program: &Path) {
    let folder = tempfile::tempdir().expect("a folder");
    let scenes = (0..100).map(|i| {
        let text = DEFAULT.replace("LemniscateCrane", &format!("Crane{i}"));
        let path = folder.path().join(format!("{i}.toml"));
        std::fs::write(
            &path,
            text.replace("\"19.3 m\"", &format!("\"{} m\"", 19.3 + 0.001 * f64::from(i))),
        )
        .expect("writable");
        path
    });
    let scenes: Vec<_> = scenes.collect();
    for level in LEVELS {
        let start = Instant::now();
        let mut child = Command::new(program)
            .args(["book", "--level", level, "--output"])
            .arg(folder.path())
            .args(&scenes)
            .stdout(std::process::Stdio::null())
            .spawn()
            .expect("built");
        let mut memory = 0.0_f64;
        while child.try_wait().expect("ours").is_none() {
            memory = memory.max(shared_memory(child.id()));
            std::thread::sleep(Duration::from_millis(50));
        }
        let each = start.elapsed().as_secs_f64() * 10.0;
        row(&format!("lemnis book, {level}, 100 scenes, each"), each, "ms", 100.0);
        row(
            &format!("lemnis book, {level}, 100 scenes, memory"),
            memory,
            "MB",
            300.0,
        );
    }
}

/// Greatest memory that a process has had, in MB; zero where the system does not say.
fn peak_memory(process: u32) -> f64 {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.unwrap_or(0.0) / 1024.0
}

/// Memory of a process and of those that it started, in MB, what they share counted once; zero where the system does
/// not say.
fn shared_memory(process: u32) -> f64 {
    let read = |file: String| std::fs::read_to_string(format!("/proc/{process}/{file}")).unwrap_or_default();
    let roll = read("smaps_rollup".to_owned());
    let line = roll.lines().find_map(|line| line.strip_prefix("Pss:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    let children = read(format!("task/{process}/children"));
    let children = children.split_whitespace().filter_map(|child| child.parse().ok());
    kilobytes.unwrap_or(0.0) / 1024.0 + children.map(shared_memory).sum::<f64>()
}

/// From the saving of a changed number to the new book on disk.
fn watch(program: &Path, what: &str, from: &str, to: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, DEFAULT).expect("writable");
    let mut child = Command::new(program)
        .arg("book")
        .arg(&path)
        .arg("--watch")
        .arg("--output")
        .arg(folder.path().join("out"))
        .stdout(std::process::Stdio::piped())
        .spawn()
        .expect("built");
    let mut lines = std::io::BufReader::new(child.stdout.take().expect("piped")).lines();
    let mut wait = || while !lines.next().expect("goes on").expect("text").contains("waiting") {};
    wait();
    let mut best = f64::INFINITY;
    for round in 0..6 {
        // The watcher is listening again a moment after it says so.
        std::thread::sleep(Duration::from_millis(50));
        let text = if round % 2 == 0 {
            DEFAULT.replace(from, to)
        } else {
            DEFAULT.to_owned()
        };
        let start = Instant::now();
        std::fs::write(&path, text).expect("writable");
        wait();
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    row(&format!("lemnis book --watch, {what} changed"), best, "ms", 150.0);
    row("lemnis book --watch, memory", peak_memory(child.id()), "MB", 300.0);
    child.kill().expect("ours");
    child.wait().expect("ours");
}
