//! The FMU's library beside that of the last commit before the redesign, through the C ABI, in interleaved rounds:
//! `cargo bench --workspace --bench before`. It needs git and the history; the library of before is built once, in
//! `target/before`. Figures are the best of the rounds; nothing here fails.

use std::collections::BTreeMap;
use std::ffi::c_void;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::ptr::null_mut;
use std::time::Instant;

use lemnis_fmu::package::find_library;
use lemnis_tests::unpacked::{DoStep, GetState, Real, SetReal, SetState, Unpacked};

/// The last commit with two models written by hand.
const BEFORE: &str = "2b7a986";
const ROUNDS: u32 = 60;
const CALLS: u32 = 20_000;

/// A ready scene: what it is about, its file, its coordinate with the middle of its range (rad), and outputs.
type Case = (&'static str, &'static str, (&'static str, f64), Vec<String>);

fn cases() -> Vec<Case> {
    let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
    let kinematic = names(&[
        "theta_3", "alpha", "alpha_1", "R", "A.x", "A.y", "B.x", "B.y", "mu", "V_AX", "V_AY", "i_2",
    ]);
    let forces = names(&[
        "theta_3", "alpha", "R", "A.y", "V_AX", "M_Q", "M_G", "M_D", "F_C.x", "F_C.y", "N_3", "F_d",
    ]);
    let groups = ["theta", "v", "R", "od", "f_g"];
    let groups = groups.iter().flat_map(|id| (1..=8).map(move |i| format!("{id}[{i}]")));
    vec![
        ("12 outputs, with forces", "lemniscate", ("theta_1", 1.55), forces),
        ("12 outputs, kinematic", "lemniscate", ("theta_1", 1.55), kinematic),
        (
            "eight groups, 40 outputs",
            "boat_hoist_003",
            ("theta_b", 0.0),
            groups.collect(),
        ),
    ]
}

/// A library at work on a scene, with the references that its own description gives.
struct Side {
    fmu: Unpacked,
    instance: *mut c_void,
    coordinate: u32,
    outputs: Vec<u32>,
    time: f64,
}

impl Side {
    fn new(library: &Path, root: &Path, (_, scene, (coordinate, _), outputs): &Case) -> Side {
        let text = std::fs::read_to_string(root.join(format!("models/scenes/{scene}.toml"))).expect("a scene");
        let description = root.join(format!("tests/bits/{scene}.fmi3.xml"));
        let description = std::fs::read_to_string(description).expect("pinned");
        let mut references = BTreeMap::new();
        for element in description.split('<') {
            let value = |name: &str| {
                let (_, rest) = element.split_once(&format!(" {name}=\""))?;
                Some(rest.split_once('"')?.0)
            };
            if let (Some(name), Some(reference)) = (value("name"), value("valueReference")) {
                references.insert(name.to_owned(), reference.parse::<u32>().expect("a number"));
            }
        }
        let reference = |name: &str| *references.get(name).unwrap_or_else(|| panic!("no {name} in {scene}"));
        let fmu = Unpacked::with(&text, library);
        let instance = fmu.start();
        Side {
            coordinate: reference(coordinate),
            outputs: outputs.iter().map(|name| reference(name)).collect(),
            time: 0.0,
            instance,
            fmu,
        }
    }

    /// Steps with another position each; nanoseconds of one.
    fn steps(&mut self, middle: f64) -> f64 {
        let mut values = vec![0.0; self.outputs.len()];
        let (mut event, mut terminate, mut early, mut last) = (0, 0, 0, self.time);
        // SAFETY: the types are those of the standard, the arrays have the lengths given.
        unsafe {
            let set = self.fmu.function::<SetReal>("fmi3SetFloat64");
            let get = self.fmu.function::<Real>("fmi3GetFloat64");
            let step = self.fmu.function::<DoStep>("fmi3DoStep");
            let start = Instant::now();
            for i in 0..CALLS {
                let at = black_box(middle + f64::from(i % 1000) * 1e-4);
                let mut status = set(self.instance, &raw const self.coordinate, 1, &raw const at, 1);
                status |= step(
                    self.instance,
                    last,
                    1e-6,
                    1,
                    &raw mut event,
                    &raw mut terminate,
                    &raw mut early,
                    &raw mut last,
                );
                let count = self.outputs.len();
                status |= get(self.instance, self.outputs.as_ptr(), count, values.as_mut_ptr(), count);
                assert_eq!(status, 0);
            }
            self.time = last;
            start.elapsed().as_nanos() as f64 / f64::from(CALLS)
        }
    }

    /// Saved states that are gone back to; nanoseconds of one.
    fn states(&self) -> f64 {
        let mut state = null_mut();
        // SAFETY: the types are those of the standard; the state is that of the instance, and freed once.
        unsafe {
            let get = self.fmu.function::<GetState>("fmi3GetFMUState");
            let set = self.fmu.function::<SetState>("fmi3SetFMUState");
            assert_eq!(get(self.instance, &raw mut state), 0);
            let start = Instant::now();
            for _ in 0..CALLS {
                assert_eq!(get(self.instance, &raw mut state) | set(self.instance, state), 0);
            }
            let time = start.elapsed().as_nanos() as f64 / f64::from(CALLS);
            let free = self.fmu.function::<GetState>("fmi3FreeFMUState");
            assert_eq!(free(self.instance, &raw mut state), 0);
            time
        }
    }
}

impl Drop for Side {
    fn drop(&mut self) {
        self.fmu.free(self.instance);
    }
}

fn main() {
    let now = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the root");
    let library = find_library().expect("built");
    let before = worktree(now);
    let old = before.join("target/release").join(library.file_name().expect("a file"));
    let size = |path: &Path| std::fs::metadata(path).expect("a file").len() as f64 / 1e6;
    println!("library: before {:.2} MB, now {:.2} MB", size(&old), size(&library));
    for case in &cases() {
        let mut sides = [Side::new(&old, &before, case), Side::new(&library, now, case)];
        let mut best = [[f64::INFINITY; 2]; 2];
        for _ in 0..ROUNDS {
            for (side, [step, state]) in sides.iter_mut().zip(&mut best) {
                *step = step.min(side.steps(case.2.1));
                *state = state.min(side.states());
            }
        }
        let [[step, state], [step_now, state_now]] = best;
        println!(
            "{:<26} step {step:>7.1} ns, now {step_now:>7.1} ns: {:.3} (goal 1.05)   saved and back {state:>6.1} ns, now \
             {state_now:>6.1} ns: {:.2} (goal 2)",
            case.0,
            step_now / step,
            state_now / state
        );
    }
}

/// The tree of before, with its library built.
fn worktree(root: &Path) -> PathBuf {
    let folder = root.join("target/before");
    let run = |command: &mut Command| assert!(command.status().expect("runs").success(), "{command:?}");
    if !folder.exists() {
        run(Command::new("git")
            .current_dir(root)
            .args(["worktree", "add", "--detach"])
            .arg(&folder)
            .arg(BEFORE));
    }
    run(Command::new(env!("CARGO"))
        .current_dir(&folder)
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .args(["build", "--release", "--package", "lemnis-fmu"]));
    folder
}
