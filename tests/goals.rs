//! Benchmarks beside their goals: `cargo bench --workspace --bench goals`, with `-- motion` those of mechanisms in
//! motion alone, with `-- luffing` those of luffing systems and of what their drives must overcome, with `-- supports` those of
//! what a crane stands on, with `-- books` those of books. Figures are the best of several rounds on this machine; nothing here
//! fails.

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use lemnis_fmu::package::{self, Library};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::shared::Watch;
use lemnis_models::kernel::variable::Role;
use lemnis_models::luffing::double_link::feet::Feet;
use lemnis_models::luffing::double_link::geometry::Geometry;
use lemnis_models::luffing::double_link::held::Held;
use lemnis_models::luffing::double_link::pin_forces::PinForces;
use lemnis_models::luffing::double_link::pole::Pole;
use lemnis_models::luffing::double_link::position::Position;
use lemnis_models::luffing::double_link::scene::Luffing;
use lemnis_models::luffing::double_link::statics::{LoadMoment, Own};
use lemnis_models::luffing::double_link::velocity::Velocity;
use lemnis_models::scene::{DEFAULT, Scene};
use lemnis_synthesis::candidate::Positions;
use lemnis_synthesis::run::run;
use lemnis_tests::unpacked::{DoStep, GetState, Real, SetReal, SetState, Unpacked};

#[path = "goals/books.rs"]
mod books;
#[path = "goals/luffing.rs"]
mod luffing;
#[path = "goals/motion.rs"]
mod motion;
#[path = "goals/supports.rs"]
mod supports;

/// Nanoseconds of one call: the best of twenty rounds of a hundred thousand.
fn nanoseconds(mut call: impl FnMut(f64)) -> f64 {
    const CALLS: u32 = 100_000;
    let mut best = f64::INFINITY;
    for _ in 0..20 {
        let start = Instant::now();
        for i in 0..CALLS {
            call(black_box(1.05 + f64::from(i % 1000) * 1e-3));
        }
        best = best.min(start.elapsed().as_nanos() as f64 / f64::from(CALLS));
    }
    best
}

fn row(what: &str, value: f64, unit: &str, goal: f64) {
    let verdict = if value <= goal { "reached" } else { "MISSED" };
    println!("{what:<62} {value:>9.1} {unit:<3} goal {goal:>7} {unit:<3} {verdict}");
}

fn main() {
    for (name, rows) in [
        ("books", books::rows as fn()),
        ("luffing", luffing::rows),
        ("motion", motion::rows),
        ("supports", supports::rows),
    ] {
        if std::env::args().any(|argument| argument == name) {
            rows();
            return;
        }
    }
    let scene = Scene::parse(DEFAULT).expect("the default scene is valid");
    models(&scene);
    luffing::rows();
    steering();
    supports::rows();
    motion::rows();
    abi(
        "C ABI: set theta_1, doStep, get 12 outputs, forces",
        DEFAULT,
        true,
        1000.0,
    );
    let kinematic = DEFAULT
        .split("[luffing.weights]")
        .next()
        .expect("text")
        .replace("Q = \"160 kN\"", "");
    abi(
        "C ABI: set theta_1, doStep, get 12 outputs, kinematic",
        &kinematic,
        false,
        400.0,
    );
    instances();
    synthesis();
    programs();
}

/// All eight groups of the boat hoist through the running model.
fn steering() {
    let text = include_str!("../models/scenes/boat_hoist_003.toml");
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
    let mut model = scene.model().expect("a machine");
    let wanted = ["theta", "v", "R", "od", "f_g"];
    let indices: Vec<usize> = (0..model.variables().len())
        .filter(|&i| model.variables()[i].number.is_some() && wanted.contains(&model.variables()[i].symbol.id))
        .collect();
    assert_eq!(indices.len(), 40);
    let time = nanoseconds(|theta| {
        model.set(0, theta - 1.5).expect("allowed");
        for &index in &indices {
            black_box(model.get(index).expect("a value"));
        }
    });
    row(
        "model: steering of 8 groups, angles, speeds, cylinders, forces",
        time,
        "ns",
        500.0,
    );
}

/// One candidate of a search, and a whole search with its fronts.
fn synthesis() {
    let text = include_str!("../models/scenes/portal_004_synthesis.toml");
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
    let search = scene.search().expect("asked for");
    let positions = Positions::new(&*search.boom, search.range, 101).expect("closes");
    let lever = search.own.expect("a lever");
    let times = (0..200).map(|_| {
        let start = Instant::now();
        for _ in 0..100 {
            black_box(positions.evaluate(black_box(&lever.dimensions), lever.branch)).expect("closes");
        }
        start.elapsed() / 100
    });
    let best = times.min().expect("many").as_secs_f64();
    row("synthesis: one candidate over 101 positions", best * 1e6, "us", 10.0);
    let stop = AtomicBool::new(false);
    let start = Instant::now();
    let watch = Watch {
        stop: &stop,
        run: &|| {},
    };
    black_box(run(&search.boom, search.range, search.task, 2, watch)).expect("there is one");
    let time = start.elapsed().as_secs_f64();
    row("synthesis: search and fronts, two threads", time, "s", 10.0);
}

#[expect(clippy::too_many_lines, reason = "one row of the table after the other")]
fn models(scene: &Scene) {
    let parameters = scene.mechanism.of::<Luffing>().expect("a luffing mechanism").parameters;
    let g = Geometry::new(&parameters).expect("exists");
    let kinematics = nanoseconds(|theta| {
        let p = Position::new(&g, theta).expect("closes");
        let v = Velocity::new(&p);
        let alpha = p.alpha();
        black_box((
            p.follower_angle(),
            alpha,
            p.alpha_1(alpha),
            p.r,
            p.a,
            p.b,
            p.c,
            v.i_2,
            v.i_follower,
            v.da,
        ));
    });
    row(
        "model: kinematics (angles, joints, reach, velocities)",
        kinematics,
        "ns",
        120.0,
    );
    let weights = parameters.weights.expect("the default scene has weights");
    let l = g.lengths;
    let forces = nanoseconds(|theta| {
        let p = Position::new(&g, theta).expect("closes");
        let v = Velocity::new(&p);
        let alpha = p.alpha();
        black_box((
            p.follower_angle(),
            alpha,
            p.alpha_1(alpha),
            p.r,
            p.a.y,
            p.mu(),
            v.da,
            v.beta(),
        ));
        let own = Own::new(&p, &v, &l, &weights);
        let pins = PinForces::new(&p, &160e3, &Some(weights), Some(&own), None, None);
        let held = Held {
            m_d: pins.m_d,
            pins: Ok(pins),
        };
        black_box(Feet::new(&p, &l, &Some(weights), None, &held, None, None)).ok();
        black_box((
            LoadMoment::new(&v, None, &160e3),
            Pole::new(&g, &p, &v).moment(&g, &p, &v, 160e3),
        ));
    });
    row(
        "model: the same, transmission, weights, pin forces, moments",
        forces,
        "ns",
        250.0,
    );

    let hand = HandWritten::new();
    let generic = nanoseconds(|theta| {
        let p = Position::new(&g, theta).expect("closes");
        black_box((p.a, Velocity::new(&p).da));
    });
    let by_hand = nanoseconds(|theta| {
        black_box(hand.run(theta));
    });
    for i in 0..1000 {
        let theta = 1.05 + f64::from(i) * 1e-3;
        let p = Position::new(&g, theta).expect("closes");
        let v = Velocity::new(&p);
        let values = [p.a.x, p.a.y, v.da.x, v.da.y];
        for (value, hand) in values.into_iter().zip(hand.run(theta).expect("closes")) {
            assert!(
                (value - hand).abs() <= 1e-13,
                "both forms compute the same: {value} {hand}"
            );
        }
    }
    let text = include_str!("../models/scenes/portal_004_new.toml");
    let scene = Scene::parse(text).expect("a ready-made scene is valid");
    let mut model = scene.model().expect("a mechanism");
    let index = |model: &Model, id: &str| model.variables().iter().position(|v| v.symbol.id == id).expect("there");
    let residual = ["M_D", "dM", "N_1", "gamma"].map(|id| index(&model, id));
    let balanced = nanoseconds(|angle| {
        // Within the working range, 44 to 82 deg.
        model.set(0, 0.77 + 0.65 * (angle - 1.05)).expect("an angle");
        black_box(residual.map(|index| model.get(index).expect("closes")));
    });
    row(
        "model: forces with a balance, as the FMU asks for them",
        balanced,
        "ns",
        1000.0,
    );
    println!("model: generic over Calc {generic:.1} ns, written by hand for f64 {by_hand:.1} ns");
    finite();
}

/// What an instance's test of every value costs, with it and without it in turn.
fn finite() {
    let scene = Scene::parse(DEFAULT).expect("the default scene is valid");
    let mut model = scene.model().expect("a mechanism");
    let outputs: Vec<usize> = (0..model.variables().len())
        .filter(|&i| model.variables()[i].role == Role::Output)
        .collect();
    let mut best = [f64::INFINITY; 2];
    for _ in 0..5 {
        for (tested, best) in [false, true].into_iter().zip(&mut best) {
            *best = best.min(nanoseconds(|angle| {
                model.set(0, angle).expect("an angle");
                for &index in &outputs {
                    let value = model.get(index).expect("closes");
                    assert!(!tested || value.is_finite());
                    black_box(value);
                }
            }));
        }
    }
    let [without, with] = best;
    println!("model: all {} outputs {without:.1} ns", outputs.len());
    row(
        "  of which testing that every one is finite",
        with - without,
        "ns",
        0.05 * without,
    );
}

/// The head of the crane and its travel, written out for `f64` alone, with the
/// same freedom of lengths.
struct HandWritten {
    x: [f64; 8],
    ends: [f64; 2],
    margin: f64,
    frame: f64,
    away: [f64; 2],
    kappa: [f64; 2],
}

impl HandWritten {
    fn new() -> HandWritten {
        let x = [0.0, 19.3, 6.5, 14.7, 16.0, 6.4, 5.3, 1.354];
        let beta_0 = Calc::acos(x[7] / x[2]) + Calc::acos(x[7] / x[4]);
        let (sin, cos) = Calc::sin_cos(beta_0);
        let frame = (x[5] * x[5] + x[6] * x[6]).sqrt();
        let frame_angle = f64::direction(-x[5], x[6]);
        let (sum, difference) = (x[2] + x[3], x[2] - x[3]);
        let y = ((sum - x[1] + frame) * (sum + x[1] - frame)).sqrt();
        let away = 2.0 * f64::direction(((x[1] + frame - sum) * (x[1] + frame + sum)).sqrt(), y);
        // Without the tails, which make a difference only at a dead point.
        HandWritten {
            x,
            ends: [frame_angle - away, frame_angle + away],
            margin: (x[1] - frame - difference) * (x[1] - frame + difference),
            frame,
            away: [-x[5] / frame, x[6] / frame],
            kappa: [x[4] * cos / x[2], x[4] * sin / x[2]],
        }
    }

    fn run(&self, theta: f64) -> Option<[f64; 4]> {
        let x = &self.x;
        let (sin, cos) = Calc::sin_cos(theta);
        let (b_x, b_y) = (x[1] * cos, x[1] * sin);
        let (l_x, l_y) = (b_x + x[5], b_y - x[6]);
        let l = (l_x * l_x + l_y * l_y).sqrt();
        let product = x[1] * self.frame;
        let past = |end: f64| Calc::sin((theta - end) / 2.0);
        let stretched = -(4.0 * product * past(self.ends[0]) * past(self.ends[1]));
        let (c_x, c_y) = (cos - self.away[0], sin - self.away[1]);
        let folded = self.margin + product * (c_x * c_x + c_y * c_y);
        if !(stretched >= 0.0 && folded >= 0.0) {
            return None;
        }
        let k = (stretched * folded).sqrt();
        let balance = (x[3] - x[2]) * (x[3] + x[2]);
        let double = 2.0 * (l * l);
        let (f, c) = (l * l + balance, balance - l * l);
        let (r_x, r_y) = ((f * l_x - k * l_y) / double, (f * l_y + k * l_x) / double);
        let (j_x, j_y) = ((c * l_x - k * l_y) / double, (c * l_y + k * l_x) / double);
        let a = [
            self.kappa[0] * j_x + self.kappa[1] * j_y,
            self.kappa[0] * j_y - self.kappa[1] * j_x,
        ];
        let i_2 = (b_x * r_y - b_y * r_x) / (k / 2.0);
        Some([b_x + a[0], b_y + a[1], -(b_y + i_2 * a[1]), b_x + i_2 * a[0]])
    }
}

/// A step through the shared library, as an importer makes it.
fn abi(what: &str, text: &str, forces: bool, goal: f64) {
    let fmu = Unpacked::new(text);
    let model = fmu.scene.model().expect("a mechanism");
    let reference = |id: &str| {
        let index = model.variables().iter().position(|variable| variable.symbol.id == id);
        u32::try_from(index.unwrap_or_else(|| panic!("{id}")) + 1).expect("few variables")
    };
    let kinematic = [
        "theta_3", "alpha", "alpha_1", "R", "A.x", "A.y", "B.x", "B.y", "mu", "V_AX", "V_AY", "i_2",
    ];
    let with_forces = [
        "theta_3", "alpha", "R", "A.y", "V_AX", "M_Q", "M_G", "M_D", "F_C.x", "F_C.y", "N_3", "F_d",
    ];
    let references = if forces { with_forces } else { kinematic }.map(reference);
    let theta = reference("theta_1");
    let instance = fmu.start();
    // SAFETY: the types are those of the standard, the arrays have the lengths given.
    unsafe {
        let set = fmu.function::<SetReal>("fmi3SetFloat64");
        let get = fmu.function::<Real>("fmi3GetFloat64");
        let do_step = fmu.function::<DoStep>("fmi3DoStep");
        let mut values = [0.0; 12];
        let (mut event, mut terminate, mut early, mut last) = (0, 0, 0, 0.0);
        let mut time = 0.0;
        let mut step = || {
            let status = do_step(
                instance,
                time,
                1e-6,
                1,
                &raw mut event,
                &raw mut terminate,
                &raw mut early,
                &raw mut last,
            );
            time = last;
            status
        };
        let best = nanoseconds(|angle| {
            let mut status = set(instance, &raw const theta, 1, &raw const angle, 1);
            status |= step();
            status |= get(instance, references.as_ptr(), 12, values.as_mut_ptr(), 12);
            assert_eq!(status, 0);
        });
        row(what, best, "ns", goal);
        if forces {
            let best = nanoseconds(|_| assert_eq!(step(), 0));
            row("C ABI: doStep where nothing changes: the layer alone", best, "ns", 80.0);
        }
    }
    fmu.free(instance);
}

/// What an instance costs besides its steps.
fn instances() {
    let fmu = Unpacked::new(DEFAULT);
    let times = (0..200).map(|_| {
        let start = Instant::now();
        let instance = fmu.start();
        let time = start.elapsed();
        fmu.free(instance);
        time
    });
    let best = times.min().expect("many").as_secs_f64();
    row("C ABI: instantiate and initialise", best * 1e6, "us", 200.0);

    let instance = fmu.start();
    // SAFETY: the types are those of the standard; the state is that of the instance, and freed once.
    unsafe {
        let get = fmu.function::<GetState>("fmi3GetFMUState");
        let set = fmu.function::<SetState>("fmi3SetFMUState");
        let mut state = std::ptr::null_mut();
        assert_eq!(get(instance, &raw mut state), 0);
        let best = nanoseconds(|_| assert_eq!(get(instance, &raw mut state), 0));
        row("C ABI: get the FMU state into one that exists", best, "ns", 1000.0);
        let best = nanoseconds(|_| assert_eq!(set(instance, state), 0));
        row("C ABI: set the FMU state", best, "ns", 1000.0);
        assert_eq!(
            fmu.function::<GetState>("fmi3FreeFMUState")(instance, &raw mut state),
            0
        );
    }
    fmu.free(instance);

    if let Some(before) = resident() {
        let many: Vec<_> = (0..1000).map(|_| fmu.start()).collect();
        let used = resident()
            .expect("readable once, readable twice")
            .saturating_sub(before);
        row("1,000 instances in one process", used as f64 / 1e6, "MB", 50.0);
        many.into_iter().for_each(|instance| fmu.free(instance));
    }
}

/// Memory of this process, in bytes, where the system tells as Linux does.
fn resident() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    Some(1024 * line.trim().strip_suffix(" kB")?.parse::<usize>().ok()?)
}

/// The program, which lies where the library does.
fn program() -> PathBuf {
    let library = package::find_library().expect("built");
    let folder = library.parent().and_then(Path::parent).expect("target/release");
    folder.join(format!("lemnis{}", std::env::consts::EXE_SUFFIX))
}

/// How long a command takes, which must succeed.
fn timed(command: &mut Command) -> Duration {
    let start = Instant::now();
    let done = command
        .output()
        .expect("build the program first: cargo build --release");
    assert!(done.status.success());
    start.elapsed()
}

/// The program itself, each command in a process of its own.
fn programs() {
    let library = Library::of_this_platform().expect("built");
    row("library in the FMU", library.bytes.len() as f64 / 1e6, "MB", 2.0);
    let program = program();
    let folder = tempfile::tempdir().expect("a folder");
    let run = |arguments: &[&str]| -> Duration {
        let times = (0..5).map(|_| {
            timed(
                Command::new(&program)
                    .args(arguments)
                    .arg("--output")
                    .arg(folder.path()),
            )
        });
        times.min().expect("five")
    };
    row(
        "lemnis fmu, both standards",
        run(&["fmu"]).as_secs_f64() * 1e3,
        "ms",
        30.0,
    );
    books::rows();
}
