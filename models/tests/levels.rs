//! Every level as a running model: no allocation, the work it does, states that go on with the same bits.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::{Fault, Quantity, Role};
use lemnis_models::scene::Scene;

#[path = "common/levels.rs"]
mod levels;

#[path = "common/counting.rs"]
mod counting;

/// Steps, inputs, all results, their derivatives, saving and restoring allocate nothing.
#[test]
fn no_level_allocates_while_it_runs() {
    for level in levels::all() {
        let mut model = levels::model(level);
        let inputs: Vec<usize> = (0..model.variables().len())
            .filter(|&i| model.variables()[i].role == Role::Input)
            .collect();
        let (mut states, mut indicators) = (vec![0.0; model.states()], vec![0.0; model.indicators()]);
        // Results of the whole working range are found once, when first asked for.
        for index in 0..model.variables().len() {
            let _ = model.get(index);
        }
        // What an importer keeps is made once, too, and so is what a derivative first needs.
        let (mut saved, mut tangent) = (model.state(), model.tangent(&|_| 0.0));
        let by_angle = |quantity: Quantity| f64::from(quantity.0.id == "theta_1");
        model.tangent_into(&by_angle, &mut tangent);
        for index in 0..model.variables().len() {
            if matches!(model.variables()[index].role, Role::Rate | Role::Output) {
                let _ = model.derivative(&mut tangent, index);
            }
        }
        let before = counting::count();
        model.state_into(&mut saved);
        for step in 0..1000 {
            let t = f64::from(step) * 1e-3;
            for &input in &inputs {
                let value = model.get(input).expect("an input has a value");
                model.set(input, value * (1.0 - 1e-6)).expect("allowed");
            }
            model.advance(t, t + 1e-3).expect("moves");
            model.get_states(&mut states);
            model.event_indicators(&mut indicators).expect("closes");
            model.rates(&mut states).expect("closes");
            model.tangent_into(&by_angle, &mut tangent);
            for index in 0..model.variables().len() {
                let _ = model.get(index);
                if matches!(model.variables()[index].role, Role::Rate | Role::Output) {
                    let _ = model.derivative(&mut tangent, index);
                }
            }
        }
        model.set_state(&saved);
        assert_eq!(counting::count() - before, 0, "{level}");
    }
}

/// What is not modelled does not exist: states and variables grow with the level only.
#[test]
fn only_what_the_scene_requires() {
    let size = |level: &str| {
        let model = levels::model(level);
        let size = [model.states(), model.indicators(), model.variables().len()];
        println!("{level}: states, indicators, variables {size:?}");
        size
    };
    let states = |level: &str| size(level)[0];
    assert_eq!(levels::LEVELS.map(states), [0, 2, 2, 4, 7, 11, 11, 8, 10, 13, 17]);
    assert_eq!(size("static")[1], 0);
    // Each with the level that it is once a part is left out.
    for (whole, part) in [
        ("hydraulic with swing, slewing", "hydraulic with swing"),
        ("hydraulic with swing, slewing", "hydraulic with slewing"),
        ("hydraulic with swing, slewing", "swing with slewing"),
        ("hydraulic with swing", "hydraulic"),
        ("swing with slewing, balance", "swing with slewing"),
        ("swing with slewing", "swing"),
        ("swing with slewing", "rigid with slewing"),
        ("swing", "rigid"),
        ("rigid with slewing", "rigid"),
        ("rigid with balance", "rigid"),
        ("rigid", "static"),
    ] {
        let (whole, part) = (size(whole), size(part));
        assert!(
            whole[2] > part[2] && whole[0] >= part[0] && whole[1] >= part[1],
            "{whole:?} {part:?}"
        );
    }
}

/// Left alone, the boom meets the stiff stop at the end of its range, and its rope lets go at the very instant of
/// contact: an event that no step reaches to the last bit of an angle. Whatever the step, the motion goes on the same.
#[test]
fn a_rope_that_lets_go_at_a_stop_is_found_at_every_step() {
    let at_22_seconds = |steps: u32| {
        let mut model = levels::model("hydraulic with swing");
        for step in 0..steps {
            let t = |step: u32| 22.0 * f64::from(step) / f64::from(steps);
            model.advance(t(step), t(step + 1)).expect("moves");
        }
        let mut states = vec![0.0; model.states()];
        model.get_states(&mut states);
        states
    };
    let expected = at_22_seconds(2200);
    let sizes = [1.0, 0.1, 1e7, 1e7, 1e7, 1e7, 1.0, 300.0, 1.0, 0.1, 10.0, 10.0, 1.0];
    for steps in [22, 1100, 4400, 11_000, 44_000] {
        for (i, found) in at_22_seconds(steps).into_iter().enumerate() {
            let off = (found - expected[i]).abs() / sizes[i];
            assert!(off < 1e-5, "{steps} steps, state {i}: {found} and {}", expected[i]);
        }
    }
}

/// Written as numbers and read back, every level goes on with the same bits; damaged numbers are refused.
#[test]
fn numbers_of_a_state_go_on_with_the_same_bits() {
    for level in levels::all().skip(1) {
        let mut model = levels::model(level);
        model.advance(0.0, 0.777).expect("moves");
        let numbers = model.numbers(&model.state());
        let run = |model: &mut Model| {
            let mut states = vec![0.0; model.states()];
            for step in 0..100 {
                let t = 0.777 + 0.013 * f64::from(step);
                model.advance(t, t + 0.013).expect("moves");
            }
            model.get_states(&mut states);
            states.into_iter().map(f64::to_bits).collect::<Vec<_>>()
        };
        let expected = run(&mut model);
        let mut other = levels::model(level);
        let state = other.state_of(&numbers).expect("of this model");
        other.set_state(&state);
        assert_eq!(run(&mut other), expected, "{level}");
        assert!(other.state_of(&numbers[1..]).is_err(), "{level}");
        let mut broken = numbers.clone();
        broken[7] = f64::NAN;
        assert!(other.state_of(&broken).is_err(), "{level}");
    }
}

/// An event leaves every indicator above zero, whatever it was: one that began at zero, or below it by a rounding,
/// would hide the next crossing from an importer that compares signs and meets it within one of its steps, as the
/// load that a blow on an end stop lets go and the rope catches 4.6 ms later. Inputs change at random; the load goes
/// slack and is caught, luffing and slewing stick, turn round and meet their stops.
#[test]
fn an_event_leaves_every_indicator_above_zero() {
    let levels = ["rigid", "rigid with slewing", "swing", "swing with slewing"];
    let hoists = levels::HOISTS.into_iter().filter(|level| level.starts_with("swing"));
    for level in levels.into_iter().chain(hoists) {
        let mut model = levels::model(level);
        let index = |model: &Model, id: &str| model.variables().iter().position(|v| v.symbol.id == id);
        let choices: [(&str, [f64; 4]); 7] = [
            ("M_A", [-4e6, 1.8e6, 3e6, 8e6]),
            ("M_S", [0.0, 0.0, 1e4, 1e7]),
            ("M_sl", [-3e6, 0.0, 4e5, 3e6]),
            ("M_Bsl", [0.0, 0.0, 1e4, 1e7]),
            ("v_h", [-1.0, 0.0, 1.0, 4.0]),
            ("M_Mh", [-2e4, 0.0, 9.9e3, 2e4]),
            ("M_Bh", [0.0, 0.0, 1e3, 1e5]),
        ];
        let mut random = 1_u64;
        let (mut slack, mut stopped) = (0, 0);
        let (mut y, mut z) = (vec![0.0; model.states()], vec![0.0; model.indicators()]);
        let mut above_zero = |model: &mut Model| -> Result<bool, Fault> {
            model.event_indicators(&mut z)?;
            Ok(z.iter().all(|z| *z > 0.0))
        };
        let start = model.state();
        for step in 0..3000 {
            if step % 1000 == 0 {
                model.set_state(&start);
            }
            for (id, values) in choices.into_iter().filter(|_| step % 16 == 0) {
                random = random
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                if let Some(at) = index(&model, id) {
                    model.set(at, values[(random >> 62) as usize]).expect("allowed");
                }
            }
            // Now, with other inputs; thrown against either stop; and after a while.
            let mut thrown = model.clone();
            thrown.get_states(&mut y);
            let now = model.event().and_then(|_| above_zero(&mut model));
            assert_eq!(now, Ok(true), "{level}, step {step}");
            let [low, high] = [60_f64, 120.0].map(f64::to_radians);
            (y[0], y[1]) = if step % 2 == 0 { (low, -0.05) } else { (high, 0.05) };
            let blow = thrown
                .set_states(&y)
                .and_then(|()| thrown.event())
                .and_then(|_| above_zero(&mut thrown));
            assert_eq!(blow, Ok(true), "{level}, step {step}: {y:?}");
            let time = 0.03 * f64::from(step);
            // Beyond the rope's end there is nothing to reel in.
            if model.advance(time, time + 0.03).and_then(|()| model.event()).is_err() {
                model.set_state(&start);
            }
            assert_eq!(above_zero(&mut model), Ok(true), "{level} at {time} s");
            let theta = model.get(0).expect("a state");
            stopped += i32::from([low, high].contains(&theta));
            for model in [&mut model, &mut thrown] {
                slack += i32::from(index(model, "S_R").is_some_and(|at| model.get(at) == Ok(0.0)));
            }
        }
        println!("{level}: {stopped} at a stop, {slack} slack");
        assert!(stopped > 50 && (slack > 50 || level.starts_with("rigid")), "{level}");
    }
}

/// An input that is set again to what it is does not interrupt the implicit solver: the same bits and no
/// more work than without.
#[test]
fn a_repeated_input_costs_nothing() {
    let run = |repeat: bool| {
        let mut model = levels::model("hydraulic");
        let index = |name: &str| {
            model
                .variables()
                .iter()
                .position(|v| v.symbol.id == name)
                .expect("exists")
        };
        let command = index("u_v");
        for step in 0..500 {
            if repeat {
                let value = model.get(command).expect("an input");
                model.set(command, value).expect("allowed");
            }
            let t = f64::from(step) * 1e-3;
            model.advance(t, t + 1e-3).expect("moves");
        }
        let mut states = [0.0; 8];
        model.get_states(&mut states);
        states.map(f64::to_bits)
    };
    assert_eq!(run(false), run(true));
}

/// Moment of cylinder, friction and end stop together are what moves the bar, as a moment does at the level rigid: so at
/// every instant of a way into the stop, and so does their work become energy of motion and height.
#[test]
fn friction_and_stop_of_a_cylinder_are_told() {
    let index = |model: &Model, id: &str| {
        let found = model.variables().iter().position(|v| v.symbol.id == id);
        found.unwrap_or_else(|| panic!("{id}"))
    };
    for level in [
        "hydraulic",
        "hydraulic with slewing",
        "hydraulic with swing",
        "hydraulic with swing, slewing",
    ] {
        let mut model = levels::model(level);
        let friction = index(&model, "M_R");
        assert_eq!(model.variables()[friction].role, Role::Output, "{level}");
        assert!(model.get(friction).is_ok_and(f64::is_finite), "{level}");
    }
    let text = levels::text("rigid")
        .replace("M_F   = \"20 kN.m\"", "")
        .replace("c_v   = \"200 kN.m.s\"", "");
    let mut rigid = Scene::parse(&text).expect("a scene").model().expect("built");
    let mut model = levels::model("hydraulic");
    let theta = index(&model, "theta_1");
    let command = index(&model, "u_v");
    model.set(theta, 117_f64.to_radians()).expect("a state");
    model.set(command, 1.0).expect("an input");
    let get = |model: &mut Model, id: &str| {
        let at = index(model, id);
        model.get(at).expect("closes")
    };
    // What the bar's acceleration is under a moment, without friction.
    let mut accelerated = |theta: f64, omega: f64, moment: f64| {
        for (id, value) in [("theta_1", theta), ("omega_1", omega), ("M_A", moment)] {
            let at = index(&rigid, id);
            rigid.set(at, value).expect("allowed");
        }
        rigid.event().expect("closes");
        let rate = index(&rigid, "der(omega_1)");
        rigid.get(rate).expect("closes")
    };
    // Moments on the bar, energy of motion, angle; the bar's acceleration beside that at the level rigid.
    let mut seen = |model: &mut Model| {
        let [theta, omega, force, arm] = ["theta_1", "omega_1", "F_c", "h_d"].map(|id| get(model, id));
        let [friction, load, weights, found] = ["M_R", "M_Q", "M_G", "der(omega_1)"].map(|id| get(model, id));
        let moment = force * arm + friction;
        // At a stop the level rigid holds its bar; a hair beside it the bar is free.
        let beside = theta.min(119.999_f64.to_radians());
        if beside == theta && omega != 0.0 {
            let expected = accelerated(theta, omega, moment);
            assert!(
                (found - expected).abs() < 1e-9 * (1.0 + found.abs()),
                "{found} {expected}"
            );
        }
        let inertia = 1e9 / (accelerated(beside, omega, 1e9) - accelerated(beside, omega, 0.0));
        (
            (moment - load - weights) * omega,
            0.5 * inertia * omega * omega,
            theta,
            -friction,
        )
    };
    let (mut before, mut time, mut work, mut stopped) = (seen(&mut model), 0.0, 0.0, 0.0_f64);
    let (high, started) = (120_f64.to_radians(), before.1);
    for _ in 0..30_000 {
        let saved = model.state();
        model.advance(time, time + 5e-5).expect("moves");
        // The stop pushes at once: the step in which it is met is cut finely.
        let met = (before.2 < high) != (seen(&mut model).2 < high);
        let parts = if met { 2000 } else { 1 };
        model.set_state(&saved);
        for _ in 0..parts {
            let step = 5e-5 / f64::from(parts);
            model.advance(time, time + step).expect("moves");
            let now = seen(&mut model);
            (work, time) = (work + 0.5 * step * (before.0 + now.0), time + step);
            (before, stopped) = (now, stopped.max(now.3));
        }
    }
    let gained = before.1 - started;
    println!("work {work:.1} J, gained {gained:.1} J, the stop gives up to {stopped:.3e} N.m");
    assert!(stopped > 1e6, "the stop caught it");
    assert!((work - gained).abs() < 3.0, "{work} {gained}");
}
