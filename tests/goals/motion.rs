//! Numbers to reach in motion: what each costs, and how far off it is. Every error is one against a reference of
//! `tests/oracles`, a closed form or the energy; times are the best of several rounds on this machine.

use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use lemnis_models::luffing::moving::dynamics::Dynamics;
use lemnis_models::luffing::moving::hydraulic::Modes;
use lemnis_models::luffing::moving::pendulum::Phase;

use lemnis_models::parts::solver::rodas::{Run, Tolerance};
use lemnis_models::scene::Scene;

#[path = "../../models/tests/common/crane.rs"]
mod crane;
#[path = "../../models/tests/common/four_bars.rs"]
mod four_bars;

/// What a number has to be.
#[derive(Clone, Copy)]
enum Goal {
    AtMost(f64),
    AtLeast(f64),
}

/// An error and what it may be, in a unit.
struct Off(f64, f64, &'static str);

fn row(what: &str, number: f64, unit: &str, goal: Goal, off: Option<Off>) {
    let (sign, limit, reached) = match goal {
        Goal::AtMost(limit) => ("<=", limit, number <= limit),
        Goal::AtLeast(limit) => (">=", limit, number >= limit),
    };
    let (error, exact) = match off {
        Some(Off(error, allowed, unit)) => (format!("error {error:.1e} of {allowed:.0e} {unit}"), error <= allowed),
        None => (String::new(), true),
    };
    let verdict = if reached && exact { "reached" } else { "MISSED" };
    println!(
        "{what:<56} {:>8} {unit:<3} goal {sign} {:<6} {error:<28} {verdict}",
        shown(number),
        shown(limit)
    );
}

fn shown(number: f64) -> String {
    if number != 0.0 && number.abs() < 1e-2 {
        format!("{number:.1e}")
    } else {
        format!(
            "{number:.*}",
            usize::from(number.abs() < 100.0 && number.fract() != 0.0)
        )
    }
}

/// The best of many rounds, in s.
fn best(rounds: u32, mut call: impl FnMut()) -> f64 {
    let times = (0..rounds).map(|_| {
        let clock = Instant::now();
        call();
        clock.elapsed().as_secs_f64()
    });
    times.fold(f64::INFINITY, f64::min)
}

pub fn rows() {
    pendulum();
    cylinder();
    steering();
    for (windows, reference) in [2, 40].into_iter().zip(four_bars::REFERENCE) {
        let (angle, passages) = four_bars::Row::new(windows).run(20_000);
        let what = format!("IFToMM A02, N = {windows}, 20 s, {passages} singular positions: error");
        row(&what, (angle - reference).abs(), "rad", Goal::AtMost(1e-6), None);
    }
    let (_, drift) = crane::rock(1_000_000);
    let what = "level rigid, a million steps: change of energy";
    row(what, drift.abs(), "", Goal::AtMost(1e-9), None);
}

/// Luffing for 5 s under 1.8 MN·m with the load on its rope, beside MuJoCo and Exudyn.
fn pendulum() {
    const REFERENCE: [f64; 2] = [1.959_365_828_718_83, 0.510_282_010_345_209_9];
    const ALLOWED: f64 = 1e-6;
    fn run(crane: &Dynamics, h: f64) -> Phase {
        let mut m = Phase {
            theta: 65_f64.to_radians(),
            omega: 0.0,
            swing: 0.1,
            swing_rate: 0.0,
        };
        for _ in 0..(5.0 / h).round() as u32 {
            m = crane.step(&m, black_box(1.8e6), h).expect("closes on the way");
        }
        m
    }
    let crane = crane::dynamics(Some(crane::PENDULUM));
    let mut ours: Option<(f64, f64)> = None;
    for h in [0.1, 0.05, 0.025, 0.02, 0.01] {
        let end = run(&crane, h);
        let off = [end.theta - REFERENCE[0], end.swing.abs() - REFERENCE[1]];
        let error = off[0].abs().max(off[1].abs());
        let seconds = best(300, || {
            black_box(run(&crane, h));
        }) / 5.0;
        println!(
            "Lemnis swing, RK4, h = {h} s: error {error:.1e} rad, {:.2} us for each simulated second",
            1e6 * seconds
        );
        if error <= ALLOWED && ours.is_none_or(|(least, _)| seconds < least) {
            ours = Some((seconds, error));
        }
    }
    let (ours, error) = ours.expect("the finest step is exact");
    println!(
        "Lemnis at an error of {ALLOWED:e} rad: {error:.1e} rad, {:.2} us for each simulated second",
        1e6 * ours
    );
    let peers = match peers() {
        Ok(peers) => peers,
        Err(why) => {
            println!("MuJoCo and Exudyn were not measured: {}", why.trim());
            return;
        }
    };
    for peer in &peers {
        println!(
            "{}: error {:.1e} rad, {:.0} us for each simulated second, {:.0} times ours",
            peer.what,
            peer.error,
            1e6 * peer.seconds,
            peer.seconds / ours
        );
    }
    for name in ["MuJoCo", "Exudyn"] {
        let of = |peer: &&Peer| peer.what.starts_with(name) && peer.error <= ALLOWED;
        let fastest = peers.iter().filter(of).min_by(|a, b| a.seconds.total_cmp(&b.seconds));
        match fastest {
            Some(peer) => row(
                &format!("luffing with a pendulum: time of {name} over ours"),
                peer.seconds / ours,
                "",
                Goal::AtLeast(300.0),
                Some(Off(peer.error.max(error), ALLOWED, "rad")),
            ),
            None => println!("{name} reaches no error of {ALLOWED:e} rad with any of its settings"),
        }
    }
}

/// One run of another code.
struct Peer {
    what: String,
    error: f64,
    seconds: f64,
}

/// Every setting of MuJoCo and Exudyn, or what is missing.
fn peers() -> Result<Vec<Peer>, String> {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers.py");
    let python = if cfg!(windows) { "python" } else { "python3" };
    let done = Command::new(python).arg(&script).output().map_err(|error| {
        format!("{python}: {error}; install Python 3.10 or later with venv, tests/peers.py gets both from PyPI")
    })?;
    if !done.status.success() {
        return Err(String::from_utf8_lossy(&done.stderr).into_owned());
    }
    let row = |line: &str| {
        let mut parts = line.split(';');
        Some(Peer {
            what: parts.next()?.to_owned(),
            error: parts.next()?.parse().ok()?,
            seconds: parts.next()?.parse().ok()?,
        })
    };
    Ok(String::from_utf8_lossy(&done.stdout).lines().filter_map(row).collect())
}

/// The stiff luffing cylinder for 2.5 s in communication steps of 1 ms.
fn cylinder() {
    const COMMANDS: [(u32, f64); 3] = [(0, 0.5), (1200, -0.4), (1800, 0.0)];
    /// First step after a change of the command, in s.
    const FIRST: f64 = 1e-3;
    let oracle: Vec<Vec<f64>> = numbers(include_str!("../oracles/hydraulic_cylinder.csv"));
    let simulate = |relative: f64, seen: &mut dyn FnMut(u32, &[f64; 8])| {
        let mut system = crane::hydraulic(None);
        let y = system.resting(65_f64.to_radians(), 20e5).expect("closes");
        let scale = [1e-3, 1e-3, 1e6, 1e6, 1e6, 1e6, 0.1, 30.0];
        let tolerance = Tolerance {
            relative,
            absolute: scale.map(|x| relative * x),
        };
        let mut run = Run::new(y, FIRST);
        for step in 0..2500 {
            if let Some(&(_, command)) = COMMANDS.iter().find(|(at, _)| *at == step) {
                system.command = command;
                run.interrupt(FIRST);
            }
            run.advance(&system.between(Modes::AT_REST), &tolerance, 1e-3, 1.0)
                .expect("stays within the range");
            seen(step + 1, &run.states());
        }
    };
    for (relative, most, allowed) in [(2e-6, 1200.0, 1e-3), (2.5e-4, 100.0, 0.1)] {
        let (mut worst, mut at) = (0.0_f64, 0);
        simulate(relative, &mut |step, y| {
            if let Some(row) = oracle.get(at).filter(|row| (row[0] * 1e3).round() == f64::from(step)) {
                worst = worst.max((y[4] - row[2]).abs()).max((y[5] - row[3]).abs());
                at += 1;
            }
        });
        assert_eq!(at, oracle.len(), "every row was compared");
        let seconds = best(200, || simulate(relative, &mut |_, y| assert!(y[4].is_finite())));
        row(
            "stiff cylinder at 1 ms, for each simulated second",
            1e6 * seconds / 2.5,
            "us",
            Goal::AtMost(most),
            Some(Off(worst / 1e5, allowed, "bar")),
        );
    }
}

/// The boat hoist's eight cylinders with oil, valves and control loop through the running model, 15 s in
/// communication steps of 10 ms.
fn steering() {
    let text = include_str!("../../models/scenes/boat_hoist_003_hydraulic.toml");
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
    let mut model = scene.model().expect("a machine");
    let angles: Vec<usize> = (0..model.variables().len())
        .filter(|&i| model.variables()[i].symbol.id == "theta")
        .collect();
    let oracle = numbers(include_str!("../oracles/steering_hydraulics.csv"));
    let saved = model.state();
    let mut worst = 0.0_f64;
    let seconds = best(5, || {
        model.set_state(&saved);
        for step in 1..=1500 {
            let t = f64::from(step) / 100.0;
            model.advance(t - 0.01, t).expect("moves");
            if step % 20 == 0 {
                let row = &oracle[step as usize / 20 - 1];
                for (&index, wanted) in angles.iter().zip(&row[1..]) {
                    worst = worst.max((model.get(index).expect("a state") - wanted).abs());
                }
            }
        }
    });
    row(
        "8 steering cylinders with control loop, over real time",
        15.0 / seconds,
        "",
        Goal::AtLeast(50.0),
        Some(Off(worst.to_degrees(), 0.1, "deg")),
    );
}

/// The numbers of a table below its head.
fn numbers(table: &str) -> Vec<Vec<f64>> {
    let cells = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    table.lines().skip(1).map(cells).collect()
}
