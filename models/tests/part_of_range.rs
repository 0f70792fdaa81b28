//! The part of the working range as an input beside the coordinate, or in its place.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::{PART_OF_RANGE, Role};
use lemnis_models::registry::dependencies;
use lemnis_models::scene::{DEFAULT, Scene};

/// Ready scenes of every mechanism that stands, at the ends of whose ranges it is known what the coordinate is.
const SCENES: [(&str, &str); 5] = [
    ("theta_1", DEFAULT),
    ("phi", include_str!("../scenes/rope_luffing.toml")),
    ("theta_b", include_str!("../scenes/boat_hoist_003.toml")),
    ("phi", include_str!("../scenes/ellipsograph.toml")),
    ("phi", include_str!("../scenes/curved_trunk.toml")),
];

fn model(text: &str) -> Model {
    let scene = Scene::parse(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    scene.model().expect("built")
}

/// The scene whose angle is no input.
fn by_part(text: &str) -> String {
    let at = text.find(".motion]").expect("a working range");
    let end = at + text[at..].find('\n').expect("a line");
    format!("{}\ninput = \"s\"{}", &text[..end], &text[end..])
}

fn index(model: &Model, name: &str) -> usize {
    let found = model.variables().iter().position(|v| v.name() == name);
    found.unwrap_or_else(|| panic!("{name}"))
}

fn outputs(model: &mut Model) -> Vec<Option<u64>> {
    let all = 0..model.variables().len();
    let of = |i: &usize| model.variables()[*i].role == Role::Output;
    let outputs: Vec<usize> = all.filter(of).collect();
    outputs
        .into_iter()
        .map(|i| model.get(i).ok().map(f64::to_bits))
        .collect()
}

#[test]
fn it_is_the_coordinate_from_end_to_end() {
    for (name, text) in SCENES {
        let [mut model, mut other] = [model(text), model(text)];
        let (angle, part) = (index(&model, name), index(&model, "s"));
        let ends = [model.positions()[0], *model.positions().last().expect("an end")];
        for (s, expected) in [(0.0, ends[0]), (1.0, ends[1]), (0.25, 0.75 * ends[0] + 0.25 * ends[1])] {
            model.set(part, s).expect("a part");
            model.update().expect("closes");
            other.set(angle, expected).expect("an angle");
            other.update().expect("closes");
            assert_eq!(model.get(angle), Ok(expected));
            assert_eq!(model.get(part), Ok(s));
            assert_eq!(outputs(&mut model), outputs(&mut other), "{name} at {s}");
            // Nothing runs by itself any more.
            model.set_time(3.0);
            assert_eq!(model.get(angle), Ok(expected));
        }
        // The one set last counts.
        model.set(angle, f64::midpoint(ends[0], ends[1])).expect("an angle");
        assert!((model.get(part).expect("a part") - 0.5).abs() < 1e-15);
        model.set(part, 0.0).expect("a part");
        assert_eq!(model.get(angle), Ok(ends[0]));
    }
}

/// As long as neither was set the coordinate runs by itself, and the part tells where it is.
#[test]
fn zero_holds_the_start() {
    let mut model = model(DEFAULT);
    let (angle, part) = (index(&model, "theta_1"), index(&model, "s"));
    model.set_time(15.0);
    assert!((model.get(part).expect("a part") - 0.25).abs() < 1e-12);
    model.set(part, 0.0).expect("a part");
    model.set_time(30.0);
    assert_eq!(model.get(angle), Ok(60_f64.to_radians()));
}

#[test]
fn derivatives_and_dependencies_go_through_it() {
    for (name, text) in SCENES {
        for alone in [false, true] {
            let text = if alone { by_part(text) } else { text.to_owned() };
            let mut model = model(&text);
            let part = index(&model, "s");
            model.set(part, 0.3).expect("a part");
            model.update().expect("closes");
            let width = model.positions().last().expect("an end") - model.positions()[0];
            let [by_part, by_angle] = [
                (&PART_OF_RANGE, None),
                model.variables()[index(&model, name)].quantity(),
            ]
            .map(|known| model.tangent(&move |other| f64::from(other == known)));
            let (mut by_part, mut by_angle) = (by_part, by_angle);
            let known = dependencies(&model);
            // The same results by the angle, where that was set last.
            let mut other = self::model(text.split("input = \"s\"").collect::<String>().as_str());
            let angle = index(&other, name);
            other
                .set(angle, model.get(index(&model, name)).expect("an angle"))
                .expect("an angle");
            let mut expected = other.tangent(&|quantity| f64::from(quantity == other.variables()[angle].quantity()));
            let mut compared = 0;
            for (i, variable) in model.variables().to_vec().iter().enumerate() {
                if variable.role != Role::Output {
                    continue;
                }
                let names = &known[i];
                let alike = names.contains(&("s", None))
                    == (names.contains(&(name, None)) || alone && names.contains(&("time", None)));
                assert!(alike, "{variable}: {names:?}");
                assert!(!(alone && names.contains(&(name, None))), "{variable}");
                if variable.name() == name {
                    assert_eq!(model.derivative(&mut by_part, i), Ok(width));
                    continue;
                }
                let Ok(expected) = other.derivative(&mut expected, index(&other, &variable.name())) else {
                    continue;
                };
                let found = model.derivative(&mut by_part, i).expect("smooth here");
                let size = model.get(i).expect("a result").abs().max(found.abs()).max(1.0);
                assert!(
                    (found - expected * width).abs() <= 1e-12 * size,
                    "{variable}: {found}, by the angle {}",
                    expected * width
                );
                // Whichever was set last: a change of the other one counts, too.
                let found = model.derivative(&mut by_angle, i).expect("smooth here");
                assert!(
                    (found - expected).abs() <= 1e-12 * size,
                    "{variable}: {found} {expected}"
                );
                compared += 1;
            }
            assert!(compared > 10, "{name}: {compared}");
        }
    }
}

#[test]
fn a_saved_state_goes_on() {
    for text in [DEFAULT.to_owned(), by_part(DEFAULT)] {
        let mut model = model(&text);
        let part = index(&model, "s");
        for s in [0.1, 0.7] {
            model.set(part, s).expect("a part");
            let numbers = model.numbers(&model.state());
            let state = model.state_of(&numbers).expect("its own");
            let mut other = self::model(&text);
            other.set_state(&state);
            assert_eq!(other.get(part), Ok(s));
            assert_eq!(outputs(&mut model), outputs(&mut other));
            other.set_time(9.0);
            assert_eq!(outputs(&mut model), outputs(&mut other));
        }
    }
}

/// Without the angle as an input every input may be zero; the angle is a result.
#[test]
fn alone_it_leaves_the_angle_out() {
    for (name, text) in SCENES {
        let mut model = model(&by_part(text));
        let angle = index(&model, name);
        assert_eq!(model.variables()[angle].role, Role::Output);
        let fault = model.set(angle, 1.0).expect_err("a result");
        let words = format!("{name} follows from s and cannot be set: leave out input = \"s\" in the scene");
        assert_eq!(fault.message, words);
        let inputs: Vec<usize> = (0..model.variables().len())
            .filter(|i| {
                model.variables()[*i].role == Role::Input
                    && model.variables()[*i].kind == lemnis_models::kernel::variable::Type::Real
            })
            .collect();
        for input in inputs {
            model.set(input, 0.0).expect("zero is legal");
        }
        model.update().expect("closes");
        assert_eq!(model.get(angle), Ok(model.positions()[0]));
        // Tables go through the range all the same.
        let to = *model.positions().last().expect("an end");
        model.place(to).expect("an angle");
        assert_eq!(model.get(angle), Ok(to));
    }
}

/// Beyond its ends as far as the angle itself, and no number that is none.
#[test]
fn it_leads_to_no_angle_that_may_not_be_set() {
    let (name, text) = SCENES[2];
    let mut model = model(text);
    let (angle, part) = (index(&model, name), index(&model, "s"));
    let before = model.get(angle);
    let refused = model.set(angle, 100.0).expect_err("beyond half a turn").message;
    for beyond in [1e3, -1e3, 1e308, f64::NAN, f64::INFINITY] {
        let fault = model.set(part, beyond).expect_err("beyond half a turn");
        let (what, allowed) = (&fault.message, refused.rsplit(':').next().expect("what is allowed"));
        assert!(
            fault.outside && (what.ends_with(allowed) || what.starts_with("s = ")),
            "{what}"
        );
        assert_eq!(model.get(angle), before);
    }
    model.set(part, 1.01).expect("just beyond the end");
}

#[test]
fn a_mechanism_that_moves_by_itself_has_none() {
    let moving = include_str!("../scenes/portal_004_motion.toml");
    assert!(model(moving).variables().iter().all(|v| v.symbol != &PART_OF_RANGE));
    let found = Scene::parse(&by_part(moving)).expect_err("not used");
    let [mistake] = &found[..] else { panic!("{found:?}") };
    assert_eq!(mistake.message, "an input for what moves by itself");
    assert_eq!(&by_part(moving)[mistake.span.clone()], "\"s\"");
}
