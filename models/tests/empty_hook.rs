//! An empty hook: a load of nothing, from the start or put down and picked up again during a run, at every level.
//! It is the limit of ever lighter loads, of which one of a millionth of a newton stands for all.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;
use lemnis_models::scene::Scene;

#[path = "common/levels.rs"]
mod levels;

/// Greatest state that counts as one, by the unit it is measured in: pressures in Pa, the spool's speed in 1/s.
fn size(id: &str) -> f64 {
    match id {
        "p_1" | "p_2" | "p_A" | "p_B" => 1e7,
        "v_v" => 300.0,
        _ => 1.0,
    }
}

fn loaded(level: &str, load: &str, replaced: &[(&str, &str)]) -> Model {
    let mut text = levels::text(level).replace("Q = \"160 kN\"", &format!("Q = \"{load}\""));
    for (old, new) in replaced {
        assert!(text.contains(old), "{level}: {old}");
        text = text.replace(old, new);
    }
    Scene::parse(&text).expect("a scene").model().expect("built")
}

fn index(model: &Model, id: &str) -> Option<usize> {
    model.variables().iter().position(|variable| variable.symbol.id == id)
}

/// Moves on by a duration in steps of 10 ms.
fn run(model: &mut Model, from: f64, duration: f64) {
    for step in 0..(duration / 0.01).round() as u32 {
        let t = |step: u32| from + 0.01 * f64::from(step);
        model.advance(t(step), t(step + 1)).expect("moves");
    }
}

/// Everything that can be asked for is a number; the rope of an empty hook pulls at nothing.
fn sound(model: &mut Model, case: &str) {
    for at in 0..model.variables().len() {
        let variable = model.variables()[at];
        let value = model
            .get(at)
            .unwrap_or_else(|fault| panic!("{case}: {variable}: {fault:?}"));
        let centre = ["O1P", "P.x", "P.y"].contains(&variable.symbol.id);
        assert!(value.is_finite() || centre, "{case}: {variable} = {value}");
        let nothing = ["S_R", "M_Q", "M_Q_P"].contains(&variable.symbol.id);
        assert!(value == 0.0 || !nothing, "{case}: {variable} = {value}");
    }
    let (mut rates, mut indicators) = (vec![0.0; model.states()], vec![0.0; model.indicators()]);
    model.rates(&mut rates).expect("finite");
    model.event_indicators(&mut indicators).expect("finite");
}

/// The states of both models, beside each other.
fn assert_alike(a: &Model, b: &Model, case: &str) {
    let (mut x, mut y) = (vec![0.0; a.states()], vec![0.0; b.states()]);
    a.get_states(&mut x);
    b.get_states(&mut y);
    for (variable, (x, y)) in a.variables().iter().zip(x.iter().zip(&y)) {
        let size = size(variable.symbol.id);
        assert!(
            (x - y).abs() <= 1e-9 * size,
            "{case}: {variable} = {x}, and {y} with a millionth of a newton"
        );
    }
}

/// Without slewing and with it, with a rope and without: what hangs on the hook is too light to be felt, and its
/// rope swings, lets go and catches as with any load.
#[test]
fn an_empty_hook_is_the_lightest_of_loads() {
    for level in levels::LEVELS.into_iter().chain(["table"]) {
        let slack = level.contains("swing");
        for replaced in [&[][..], &[("l_R = \"10 m\"", "l_R = \"10 m\"\nphi_R = \"125 deg\"")]] {
            if !(replaced.is_empty() || slack) {
                continue;
            }
            let case = format!("{level} {replaced:?}");
            let [mut empty, mut light] = ["0 kN", "1e-9 kN"].map(|load| loaded(level, load, replaced));
            let mut let_go = 0;
            for second in 0..5 {
                sound(&mut empty, &case);
                run(&mut empty, f64::from(second), 1.0);
                run(&mut light, f64::from(second), 1.0);
                assert_alike(&empty, &light, &case);
                let_go += u32::from(index(&light, "S_R").is_some_and(|rope| light.get(rope) == Ok(0.0)));
            }
            sound(&mut empty, &case);
            assert!(replaced.is_empty() || let_go > 0, "{case}: the rope was slack at times");
            // No event without end, which would show as work.
            assert!(
                empty.count().steps <= light.count().steps + light.count().steps / 10,
                "{case}: {:?} {:?}",
                empty.count(),
                light.count()
            );
        }
    }
}

/// Put down in the middle of a run and picked up again: beside a load of a millionth of a newton in its place.
#[test]
fn a_load_is_put_down_and_picked_up() {
    for level in levels::LEVELS {
        let [empty, light] = [0.0, 1e-6].map(|lightest| {
            let mut model = levels::model(level);
            let load = index(&model, "Q").expect("an input");
            let (mut weight, mut hangs) = (0.0, false);
            for tenth in 0..50 {
                if let Some((_, q)) = [(10, lightest), (30, 160e3), (40, 20e3)]
                    .iter()
                    .find(|(at, _)| *at == tenth)
                {
                    weight = *q;
                    model.set(load, weight).expect("allowed");
                    model.update().expect("closes");
                }
                if weight == 0.0 && tenth >= 10 {
                    sound(&mut model, level);
                }
                run(&mut model, 0.1 * f64::from(tenth), 0.1);
                let rope = index(&model, "S_R").map(|rope| model.get(rope).expect("closes"));
                hangs |= tenth >= 30 && rope.is_none_or(|pull| pull > 0.9 * weight);
            }
            assert!(hangs, "{level}: the rope carries the load again");
            model
        });
        assert_alike(&empty, &light, level);
    }
}

/// What a load would change is told by its derivatives before there is one: against differences to a small load.
#[test]
fn derivatives_by_the_load_of_an_empty_hook() {
    for level in levels::LEVELS.into_iter().filter(|level| *level != "static") {
        let mut model = loaded(level, "0 kN", &[]);
        run(&mut model, 0.0, 0.5);
        let (load, step) = (index(&model, "Q").expect("an input"), 10.0);
        let mut tangent = model.tangent(&|quantity| f64::from(quantity.0.id == "Q"));
        let with = |q: f64, at: usize| {
            let mut more = model.clone();
            more.set(load, q).expect("allowed");
            more.get(at).expect("closes")
        };
        for at in 0..model.variables().len() {
            let variable = model.variables()[at];
            if variable.role != Role::Rate && variable.symbol.id != "S_R" {
                continue;
            }
            let found = model.derivative(&mut tangent, at).expect("smooth");
            // From one side, as there is no load below none: of second order.
            let [none, some, more] = [0.0, step, 2.0 * step].map(|q| with(q, at));
            let difference = (4.0 * some - 3.0 * none - more) / (2.0 * step);
            let rounding = 1e-14 * none.abs() / step;
            assert!(
                (found - difference).abs() <= 1e-6 * difference.abs() + rounding + 1e-14,
                "{level}: {variable}: {found} {difference}"
            );
        }
    }
}

/// With nothing on it a rope that gives way is not stretched, from the start and during a run; the load that is put on it
/// then stretches it, to twice its hanging rest by its fall.
#[test]
fn an_elastic_rope_with_nothing_on_it() {
    for level in ["swing with slewing, elastic", "hydraulic with swing, elastic"] {
        let mut model = loaded(level, "0 kN", &[("d_R = \"40 kN.s/m\"", "")]);
        let at = |id: &str| index(&levels::model(level), id).expect("a variable");
        let [load, length, distance, rope] = ["Q", "l_R", "s_Q", "S_R"].map(at);
        sound(&mut model, level);
        run(&mut model, 0.0, 1.0);
        sound(&mut model, level);
        let apart = model.get(distance).expect("closes") - model.get(length).expect("a state");
        assert!(apart.abs() < 1e-12, "{level}: {apart}");
        let weight = 100e3;
        model.set(load, weight).expect("allowed");
        let mut most = 0.0_f64;
        for step in 0..100 {
            run(&mut model, 1.0 + 0.01 * f64::from(step), 0.01);
            most = most.max(model.get(rope).expect("closes"));
        }
        // The boom gives way a little.
        assert!((1.8..2.2).contains(&(most / weight)), "{level}: {most}");
        model.set(load, 0.0).expect("allowed");
        model.update().expect("closes");
        sound(&mut model, level);
        run(&mut model, 2.0, 1.0);
    }
}
