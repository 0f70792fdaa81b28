//! Extremes of the model that the FMU runs: steps, tolerances, masses, oil, ropes, inputs, at every level.

use std::f64::consts::TAU;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::variable::Fault;
use lemnis_models::scene::Scene;

use super::steering;

#[path = "../../models/tests/common/levels.rs"]
pub mod levels;

pub fn index(model: &Model, id: &str) -> usize {
    let found = model.variables().iter().position(|variable| variable.symbol.id == id);
    found.unwrap_or_else(|| panic!("{id}"))
}

pub fn set(model: &mut Model, numbers: &[(&str, f64)]) {
    for &(id, value) in numbers {
        let at = index(model, id);
        model
            .set(at, value)
            .unwrap_or_else(|fault| panic!("{id}: {}", fault.message));
    }
}

pub fn get(model: &mut Model, id: &str) -> f64 {
    let at = index(model, id);
    model.get(at).unwrap_or_else(|fault| panic!("{id}: {}", fault.message))
}

pub fn run(model: &mut Model, sizes: &[f64]) -> Result<(), Fault> {
    let mut time = 0.0;
    for size in sizes {
        model.advance(time, time + size)?;
        time += size;
    }
    Ok(())
}

pub fn states(model: &Model) -> Vec<f64> {
    let mut states = vec![0.0; model.states()];
    model.get_states(&mut states);
    states
}

pub fn bits(model: &Model) -> Vec<u64> {
    states(model).into_iter().map(f64::to_bits).collect()
}

/// A load that swings a hundredth of a radian on a held crane: phi = 0.01 cos(omega t).
fn swinging(length: f64, step: f64) -> Model {
    let mut model = levels::model("swing");
    set(
        &mut model,
        &[
            ("l_R", length),
            ("phi_R", 0.01),
            ("M_S", 1e12),
            ("M_A", 0.0),
            ("step", step),
        ],
    );
    model.update().expect("closes");
    model
}

/// Explicit steps are taken up to |λ| h = 1 and refused beyond, with nothing changed; what is taken is within a
/// twentieth of the known solution over a whole period, and what is refused goes on with a shorter step.
#[test]
fn explicit_steps_are_refused_where_they_would_mean_nothing() {
    for length in [0.01, 1.0, 1000.0] {
        let omega = (9.81_f64 / length).sqrt();
        for (part, taken) in [
            (0.1, true),
            (0.5, true),
            (0.98, true),
            (1.02, false),
            (2.0, false),
            (2.8, false),
        ] {
            let mut model = swinging(length, part / omega);
            let (before, period) = (bits(&model), TAU / omega);
            // A whole number of inner steps of very nearly this length.
            let duration = (period * omega / part).round().max(1.0) * part / omega;
            match model.advance(0.0, duration) {
                Ok(()) => {
                    assert!(taken, "{length} m, {part}");
                    let exact = 0.01 * Calc::sin_cos(omega * duration).1;
                    let error = (get(&mut model, "phi_R") - exact).abs() / 0.01;
                    println!("{length} m: |lambda| h = {part}: error {error:.1e} of the amplitude");
                    assert!(error < 0.05, "{length} m, {part}: {error}");
                }
                Err(fault) => {
                    assert!(
                        !taken && fault.outside && fault.message.contains("too long"),
                        "{}",
                        fault.message
                    );
                    assert_eq!(
                        bits(&model),
                        before,
                        "{length} m, {part}: a refused step changes nothing"
                    );
                    set(&mut model, &[("step", 0.1 / omega)]);
                    model.advance(0.0, period).expect("swings");
                }
            }
        }
    }
}

/// The same with friction that is stiff: a decay of c_v over the inertia.
#[test]
fn stiff_friction_is_refused_where_it_would_mean_nothing() {
    let end = |step: f64| {
        let mut model = stiff(step);
        run(&mut model, &[0.256]).map(|()| get(&mut model, "theta_1"))
    };
    let exact = end(1e-4).expect("solves");
    let outcomes: Vec<Option<f64>> = (0..9)
        .map(|k| end(1e-3 * f64::from(1 << k)).ok().map(|theta| (theta - exact).abs()))
        .collect();
    println!("{outcomes:?}");
    let taken = outcomes.iter().take_while(|outcome| outcome.is_some()).count();
    assert!((2..8).contains(&taken), "{outcomes:?}");
    assert!(outcomes[taken..].iter().all(Option::is_none), "{outcomes:?}");
    // It would move by 2.6 mrad as it comes to rest.
    assert!(outcomes.iter().flatten().all(|error| *error < 5e-5), "{outcomes:?}");
}

/// A level with its solver: what is fast in it, and what is known of its motion.
pub struct Row {
    pub name: &'static str,
    /// In 1/s, of the fastest change.
    pub fastest: f64,
    /// Error over what changes, after a motion with a longest step (s) of the solver; `None` where it is refused.
    pub error: fn(f64) -> Option<f64>,
}

/// Every level beside the static one, each with its solver.
pub fn rows() -> [Row; 7] {
    let slope = |model: &Model, rate: &str, state: &str| {
        let known = model.variables()[index(model, state)].quantity();
        let mut tangent = model.tangent(&|other| f64::from(other == known));
        -model.derivative(&mut tangent, index(model, rate)).expect("smooth")
    };
    [
        Row {
            name: "rigid: RK4, stiff friction",
            fastest: slope(&stiff(1e-3), "der(omega_1)", "omega_1"),
            error: |step| {
                let end = |step: f64| {
                    let mut model = stiff(step);
                    run(&mut model, &[0.2]).ok().map(|()| get(&mut model, "theta_1"))
                };
                Some((end(step)? - end(1e-4)?).abs() / 2.6e-3)
            },
        },
        Row {
            name: "swing: RK4, a rope of 1 m",
            fastest: 9.81_f64.sqrt(),
            error: |step| {
                let mut model = swinging(1.0, step);
                let period = TAU / 9.81_f64.sqrt();
                run(&mut model, &[period]).ok()?;
                Some((get(&mut model, "phi_R") - 0.01).abs() / 0.01)
            },
        },
        Row {
            name: "rigid, slewing: RK4, stiff friction",
            fastest: slope(&stiff_slewing(1e-3), "der(omega_sl)", "omega_sl"),
            error: |step| {
                let end = |step: f64| {
                    let mut model = stiff_slewing(step);
                    run(&mut model, &[0.2]).ok().map(|()| get(&mut model, "psi_sl"))
                };
                let fine = end(1e-4)?;
                Some((end(step)? - fine).abs() / fine)
            },
        },
        Row {
            name: "swing, slewing: RK4, a rope of 1 m",
            fastest: 9.81_f64.sqrt(),
            error: |step| {
                let mut model = held_by_brakes(step);
                let (sin, cos) = Calc::sin_cos(0.01_f64);
                set(&mut model, &[("l_R", 1.0)]);
                put_load(&mut model, [0.0, -cos, sin]);
                let period = TAU / 9.81_f64.sqrt();
                run(&mut model, &[period]).ok()?;
                Some((get(&mut model, "chi_R") - 0.01).abs() / 0.01)
            },
        },
        Row {
            name: "hydraulic: Rodas, ports of 0.2 l",
            fastest: slope(&levels::model("hydraulic"), "der(p_1)", "p_1"),
            error: |step| oil("hydraulic", step),
        },
        Row {
            name: "hydraulic, swing: Rodas",
            fastest: slope(&levels::model("hydraulic with swing"), "der(p_1)", "p_1"),
            error: |step| oil("hydraulic with swing", step),
        },
        Row {
            name: "steering, hydraulic: Rodas, ports of 0.3 l",
            fastest: {
                let model = steering::model();
                let at = |name| steering::index(&model, name);
                let known = model.variables()[at("p_1[1]")].quantity();
                let mut tangent = model.tangent(&|other| f64::from(other == known));
                -model.derivative(&mut tangent, at("der(p_1[1])")).expect("smooth")
            },
            error: steering::strayed,
        },
    ]
}

/// Of the pressure in the bore's chamber over 100 bar, against a run with a tolerance of 1e-9.
fn oil(level: &str, step: f64) -> Option<f64> {
    let end = |step: f64, tolerance: f64| {
        let mut model = levels::model(level);
        set(&mut model, &[("step", step), ("tol", tolerance)]);
        run(&mut model, &[0.5]).ok().map(|()| get(&mut model, "p_A"))
    };
    Some((end(step, 1e-5)? - end(1.0, 1e-9)?).abs() / 1e7)
}

/// Friction that stops the crane within milliseconds.
fn stiff(step: f64) -> Model {
    let mut model = levels::model("rigid");
    set(&mut model, &[("c_v", 1e9), ("omega_1", 0.2), ("step", step)]);
    model.update().expect("closes");
    model
}

/// The same of slewing.
fn stiff_slewing(step: f64) -> Model {
    let mut model = levels::model("rigid with slewing");
    set(
        &mut model,
        &[
            ("M_S", 1e12),
            ("M_A", 0.0),
            ("M_sl", 0.0),
            ("M_Fsl", 0.0),
            ("c_sl", 1e9),
            ("omega_sl", 0.2),
            ("step", step),
        ],
    );
    model.update().expect("closes");
    model
}

/// Masses from 1e-6 to 1e9 kg: without friction and drive, the fall is the same to 1e-9 rad, with the load fixed to the
/// head or on its rope, and of a crane that slews.
#[test]
fn masses_cancel() {
    for level in ["rigid", "swing", "rigid with slewing", "swing with slewing"] {
        let fall = |scale: f64| {
            let mut model = levels::model(level);
            set(
                &mut model,
                &[("M_A", 0.0), ("M_F", 0.0), ("c_v", 0.0), ("theta_1", 1.3)],
            );
            let mut all = vec!["G_1", "G_2", "G_3", "Q", "J_1", "J_2", "J_3"];
            if level.contains("slewing") {
                set(
                    &mut model,
                    &[("M_sl", 0.0), ("M_Fsl", 0.0), ("c_sl", 0.0), ("omega_sl", 0.1)],
                );
                all.push("J_sl");
            }
            for id in all {
                let value = get(&mut model, id) * scale;
                set(&mut model, &[(id, value)]);
            }
            model.update().expect("closes");
            run(&mut model, &[1.0]).expect("falls");
            states(&model)
        };
        let reference = fall(1.0);
        assert!((reference[0] - 1.3).abs() > 1e-3, "{level} moves: {reference:?}");
        // Bodies from 4 t to 20 t become 2 mg to 10 mg, and 2e8 kg to 1e9 kg.
        for scale in [5e-10, 1e-6, 1e3, 5e4] {
            for (a, b) in fall(scale).iter().zip(&reference) {
                assert!((a - b).abs() < 1e-9, "{level}, {scale:e}: {a} {b}");
            }
        }
    }
}

/// No load, no inertia of one body, no friction: solved with finite numbers; no mass at all is refused.
#[test]
fn nothing_that_weighs() {
    for zero in [
        &["Q"][..],
        &["J_1"],
        &["J_2"],
        &["J_3"],
        &["G_3", "J_3"],
        &["c_v", "M_F"],
        &["J_sl", "c_sl", "M_Fsl"],
    ] {
        for level in levels::LEVELS.into_iter().skip(1) {
            let mut model = levels::model(level);
            let exists = |model: &Model, id: &str| model.variables().iter().any(|v| v.symbol.id == id);
            for id in zero.iter().filter(|id| exists(&levels::model(level), id)) {
                set(&mut model, &[(id, 0.0)]);
            }
            let solved = model.update().and_then(|()| run(&mut model, &[1e-3, 0.5]));
            // A pendulum without mass has no equation of motion.
            let massless = zero == ["Q"] && level.contains("swing") && !level.contains("slewing");
            assert!(solved.is_ok() || massless, "{level} without {zero:?}: {solved:?}");
            assert!(states(&model).iter().all(|x| x.is_finite()), "{level} without {zero:?}");
        }
    }
    let mut model = levels::model("rigid");
    for id in ["G_1", "G_2", "G_3", "Q", "J_1", "J_2", "J_3"] {
        set(&mut model, &[(id, 0.0)]);
    }
    let refused = model.update().and_then(|()| run(&mut model, &[0.1]));
    assert!(refused.is_err_and(|fault| fault.outside));
}

/// A brake of any finite moment holds to the last bit, at any step.
#[test]
fn friction_without_end_holds() {
    let mut model = levels::model("rigid");
    set(&mut model, &[("M_S", 1e300), ("M_F", 1e300)]);
    model.update().expect("closes");
    let before = bits(&model);
    run(&mut model, &[1e-9, 1e-3, 1.0, 1e3]).expect("rests");
    assert_eq!(bits(&model), before);
}

/// Bulk modulus from 1e5 to 1e12 Pa and ports from 1e-9 m³: the crane rests on its oil with the valve closed.
#[test]
fn oil_of_any_stiffness_rests() {
    for modulus in [1e5, 1e7, 1e9, 1e12] {
        for (port, level) in [
            (1e-9, "hydraulic"),
            (1e-6, "hydraulic"),
            (1e-3, "hydraulic"),
            (1e-9, "hydraulic with swing"),
        ] {
            let mut model = levels::model(level);
            set(
                &mut model,
                &[("u_v", 0.0), ("k_L", 0.0), ("beta_E", modulus), ("V_1", port)],
            );
            let start = get(&mut model, "theta_1");
            // On oil as soft as a gas the rest is unstable in truth: rounding grows.
            let duration = if modulus < 1e6 { 1.0 } else { 50.0 };
            run(&mut model, &[1e-9, duration]).unwrap_or_else(|f| panic!("{modulus:e} {port:e}: {}", f.message));
            let moved = (get(&mut model, "theta_1") - start).abs();
            assert!(moved < 1e-8, "{modulus:e} {port:e}: {moved:e}");
        }
    }
}

/// Moved by its valve, the crane on ever stiffer oil comes ever nearer to one on oil that does not give way: it swings about
/// that with the amplitude omega/omega_n, which bounds every difference. The natural frequency is that of the exact
/// Jacobian. Eigenvalues beyond -1e9 1/s, in bounded work.
#[test]
fn ever_stiffer_oil_moves_as_stiff_oil() {
    let end = |modulus: f64, port: f64| {
        let mut model = levels::model("hydraulic");
        set(
            &mut model,
            &[("u_v", 0.2), ("beta_E", modulus), ("V_1", port), ("tol", 1e-8)],
        );
        run(&mut model, &[0.8]).unwrap_or_else(|f| panic!("{modulus:e}: {}", f.message));
        let work = model.count();
        assert!(work.steps + work.rejected < 100_000, "{modulus:e}: {work:?}");
        let by = |state: &str, rate: &str| {
            let known = model.variables()[index(&model, state)].quantity();
            let mut tangent = model.tangent(&|other| f64::from(other == known));
            model.derivative(&mut tangent, index(&model, rate)).expect("smooth")
        };
        let column = |id: &str| -by(id, "der(omega_1)") * by("omega_1", &format!("der({id})"));
        let natural = (column("p_A") + column("p_B")).sqrt();
        let fastest = -by("p_1", "der(p_1)");
        let [theta, omega] = ["theta_1", "omega_1"].map(|id| get(&mut model, id));
        (theta, omega.abs() / natural, fastest)
    };
    let ends = [1e9, 1e10, 1e11, 1e12].map(|modulus| end(modulus, 1e-6));
    for pair in ends.windows(2) {
        let (difference, amplitude) = ((pair[1].0 - pair[0].0).abs(), pair[0].1);
        println!("difference {difference:.1e}, amplitude {amplitude:.1e}");
        assert!(difference < amplitude, "{ends:?}");
    }
    let (theta, amplitude, fastest) = end(1.4e9, 1e-9);
    assert!(
        fastest > 1e9 && (theta - ends[3].0).abs() < amplitude,
        "{fastest:e} {theta}"
    );
}

/// Communication steps from 1e-9 to 1e3 s, irregular and again after a restore: the same bits.
#[test]
fn steps_of_any_size_again_after_a_restore() {
    for level in levels::LEVELS {
        let mut model = levels::model(level);
        if level.contains("swing") && !level.contains("hydraulic") {
            set(&mut model, &[("M_S", 1e12)]);
        }
        run(&mut model, &[0.013, 1e-9, 0.2]).expect("moves");
        let saved = model.state();
        let sizes = [1e-9, 0.37, 1e-6, 1e-3, 2e-9, 0.05, 1e3];
        run(&mut model, &sizes).unwrap_or_else(|f| panic!("{level}: {}", f.message));
        let first = bits(&model);
        model.set_state(&saved);
        run(&mut model, &sizes).expect("moves");
        assert_eq!(bits(&model), first, "{level}");
    }
}

/// A million inner steps in one call are taken, one step more is refused at once and changes nothing.
#[test]
fn a_million_steps_and_no_more() {
    let mut model = swinging(10.0, 1e-4);
    model.advance(0.0, 99.99).expect("a million steps");
    let omega = (9.81_f64 / 10.0).sqrt() * (1.0 - 0.01 * 0.01 / 16.0);
    let exact = 0.01 * Calc::sin_cos(omega * 99.99).1;
    assert!(
        (get(&mut model, "phi_R") - exact).abs() < 1e-6,
        "{} {exact}",
        get(&mut model, "phi_R")
    );
    let before = bits(&model);
    let fault = model.advance(99.99, 300.0).expect_err("too many");
    assert!(
        fault.outside && fault.message.contains("1000000 inner steps"),
        "{}",
        fault.message
    );
    assert_eq!(bits(&model), before);
}

/// Inputs that are no numbers are refused, denormal ones are as zero, huge ones end at a stop or are refused;
/// after all of them the model goes on.
#[test]
fn inputs_of_any_size_during_a_run() {
    for (level, input) in [
        ("rigid", "M_A"),
        ("swing", "M_A"),
        ("swing", "v_h"),
        ("rigid with slewing", "M_sl"),
        ("swing with slewing", "M_A"),
        ("swing with slewing", "M_sl"),
        ("swing with slewing", "M_Bsl"),
        ("swing with slewing", "v_h"),
        ("hydraulic with swing", "u_v"),
        ("hydraulic", "u_v"),
        ("hydraulic", "p_P"),
    ] {
        let mut model = levels::model(level);
        run(&mut model, &[0.1]).expect("moves");
        let at = index(&model, input);
        for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(
                model.set(at, broken).is_err_and(|fault| fault.outside),
                "{level} {input} = {broken}"
            );
        }
        let saved = model.state();
        let mut end = |value: f64| {
            model.set_state(&saved);
            model.set(at, value).expect("a number");
            let done = run(&mut model, &[0.2]);
            assert!(
                states(&model).iter().all(|x| x.is_finite()),
                "{level} {input} = {value:e}"
            );
            done.map(|()| states(&model))
        };
        let zero = end(0.0).expect("moves");
        for tiny in [5e-324, 1e-310] {
            for (a, b) in end(tiny).expect("moves").iter().zip(&zero) {
                assert!((a - b).abs() <= 1e-300, "{level} {input} = {tiny:e}: {a} {b}");
            }
        }
        for huge in [1e15, 1e300, f64::MAX] {
            let _ = end(huge);
        }
        assert_eq!(end(0.0), Ok(zero), "{level} {input}: it goes on");
    }
}

/// Tolerances that no double can hold are refused at once, and the model goes on with another.
#[test]
fn tolerances_below_rounding_are_refused() {
    for tolerance in [5e-324, 1e-310, 1e-200] {
        let mut model = levels::model("hydraulic");
        set(&mut model, &[("tol", tolerance)]);
        let before = bits(&model);
        let fault = model.advance(0.0, 0.1).expect_err("below rounding");
        assert!(
            fault.outside && fault.message.contains("tolerance"),
            "{}",
            fault.message
        );
        assert_eq!(bits(&model), before);
        set(&mut model, &[("tol", 1e-6)]);
        model.advance(0.0, 0.1).expect("solves");
    }
}

/// A tolerance up to a tenth is taken, and what comes out is as good as it says; a coarser one would be bounded and mean
/// little, and is refused when it is set, as in a scene.
#[test]
fn tolerances_are_up_to_a_tenth() {
    for level in ["hydraulic", "hydraulic with swing"] {
        let end = |tolerance: f64| {
            let mut model = levels::model(level);
            set(&mut model, &[("tol", tolerance)]);
            run(&mut model, &[0.5]).expect("solves");
            [get(&mut model, "theta_1"), get(&mut model, "p_A")]
        };
        let exact = end(1e-9);
        for tolerance in [1e-4, 1e-3, 1e-2, 0.1] {
            let found = end(tolerance);
            let error = [0, 1].map(|i| (found[i] / exact[i] - 1.0).abs());
            println!("{level}, {tolerance}: {error:?}");
            assert!(
                error.iter().all(|error| *error <= tolerance),
                "{level}, {tolerance}: {error:?}"
            );
        }
        let mut model = levels::model(level);
        let at = index(&model, "tol");
        for coarse in [0.100_001, 1.0, 1e300, f64::MAX] {
            let fault = model.set(at, coarse).expect_err("too coarse");
            assert!(
                fault.outside && fault.message.contains("at most 0.1"),
                "{}",
                fault.message
            );
            assert_eq!(model.get(at), Ok(1e-6));
        }
        let text = levels::scene(level)
            .text()
            .replacen("tol   = \"1e-6\"", "tol   = \"0.5\"", 1);
        let found = Scene::parse(&text).expect_err("too coarse");
        assert!(found[0].message.contains("at most 0.1"), "{found:?}");
    }
}

/// Let go at 179 degrees the rope is slack, and the load is caught below; on ropes of 0.01 m and of 1 km.
#[test]
fn let_go_at_179_degrees() {
    for length in [0.01, 10.0, 1000.0] {
        let mut model = swinging(length, 1e-3 * f64::sqrt(length));
        set(&mut model, &[("phi_R", 179_f64.to_radians())]);
        model.update().expect("closes");
        // Two rope lengths down, as a stone falls.
        let fall = (4.0 * length * Calc::sin_cos(1_f64.to_radians()).1 / 9.81).sqrt();
        model.advance(0.0, 0.9 * fall).expect("falls");
        assert_eq!(get(&mut model, "S_R"), 0.0, "{length} m");
        model.advance(0.9 * fall, 1.001 * fall).expect("is caught");
        assert!(get(&mut model, "S_R") > 0.0, "{length} m");
        let turned = get(&mut model, "phi_R").rem_euclid(TAU);
        assert!((turned - 1_f64.to_radians()).abs() < 1e-3, "{length} m: {turned}");
    }
}

/// The same from a crane that slews, its load a point in space: forward, sideways and between.
#[test]
fn let_go_at_179_degrees_from_a_crane_that_slews() {
    for towards in [0.0_f64, 1.0, std::f64::consts::FRAC_PI_2] {
        let mut model = held_by_brakes(1e-3);
        let ((sin, cos), (left, forward)) = (Calc::sin_cos(179_f64.to_radians()), Calc::sin_cos(towards));
        put_load(&mut model, [sin * forward, -cos, sin * left].map(|x| 10.0 * x));
        let fall = (4.0 * 10.0 * Calc::sin_cos(1_f64.to_radians()).1 / 9.81).sqrt();
        model.advance(0.0, 0.9 * fall).expect("falls");
        assert_eq!(get(&mut model, "S_R"), 0.0, "{towards}");
        model.advance(0.9 * fall, 1.001 * fall).expect("is caught");
        assert!(get(&mut model, "S_R") > 0.0, "{towards}");
        let turned = ["phi_R", "chi_R"].map(|id| get(&mut model, id));
        let angle = (turned[0].powi(2) + turned[1].powi(2)).sqrt();
        assert!((angle - 1_f64.to_radians()).abs() < 1e-3, "{towards}: {turned:?}");
    }
}

/// A crane that slews, all brakes on, its load on a rope of 10 m.
fn held_by_brakes(step: f64) -> Model {
    let mut model = levels::model("swing with slewing");
    set(
        &mut model,
        &[
            ("M_S", 1e12),
            ("M_Bsl", 1e12),
            ("M_A", 0.0),
            ("M_sl", 0.0),
            ("step", step),
        ],
    );
    model
}

/// Puts the load at rest at a place (m) seen from the head.
fn put_load(model: &mut Model, place: [f64; 3]) {
    let mut y = states(model);
    y[4..7].copy_from_slice(&place);
    y[7..10].fill(0.0);
    model.set_states(&y).and_then(|()| model.update()).expect("closes");
}
