//! Every level as a running model: no allocation, the work it does, states that go on with the same bits.

use lemnis_models::model::Role;

#[path = "common/levels.rs"]
mod levels;

#[path = "common/counting.rs"]
mod counting;

/// Steps, inputs, all results, their derivatives, saving and restoring allocate nothing.
#[test]
fn no_level_allocates_while_it_runs() {
    for level in levels::LEVELS {
        let mut model = levels::model(level);
        let inputs: Vec<usize> = (0..model.variables().len())
            .filter(|&i| model.variables()[i].role == Role::Input)
            .collect();
        let (mut states, mut indicators) = (vec![0.0; model.states()], vec![0.0; model.indicators()]);
        // Results of the whole working range are found once, when first asked for.
        for index in 0..model.variables().len() {
            let _ = model.get(index);
        }
        let before = counting::count();
        let saved = model.state();
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
            let mut tangent = model.tangent(|quantity| f64::from(quantity.0.id == "theta_1"));
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

/// Written as numbers and read back, every level goes on with the same bits; damaged numbers are refused.
#[test]
fn numbers_of_a_state_go_on_with_the_same_bits() {
    for level in levels::LEVELS.into_iter().skip(1) {
        let mut model = levels::model(level);
        model.advance(0.0, 0.777).expect("moves");
        let numbers = model.numbers(&model.state());
        let run = |model: &mut lemnis_models::model::Model| {
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
