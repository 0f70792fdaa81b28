//! Lengths, dead points, ends of assembly and states through the running model of a scene: what the equations alone
//! stand in `positions`, and what an importer of Model Exchange may set.

use lemnis_fmu::instance::{Instance, Interface, token};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::unit;
use lemnis_models::kernel::variable::{Role, Type};
use lemnis_models::luffing::moving::bodies::Body;
use lemnis_models::scene::{DEFAULT, Scene};

use super::positions::hex;
use super::running::{bits, get, index, levels, run, set, states};
use crate::crane;

const POSITIONS: &str = include_str!("../oracles/lemniscate_extremes.csv");
const DYNAMICS: &str = include_str!("../oracles/dynamics_extremes.csv");
const STEERING: &str = include_str!("../../models/scenes/boat_hoist_003_hydraulic.toml");

fn parsed(text: &str) -> Model {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}\n{text}"));
    scene.model().expect("built")
}

/// The scene with every length 4^k times as long, forces as they are and time 2^k times as long: numbers change by powers
/// of two alone.
fn scaled(text: &str, k: i32) -> String {
    let line = |line: &str| -> String {
        let quoted = line
            .split_once('"')
            .and_then(|(key, rest)| Some((key, rest.split_once('"')?)));
        let Some((key, (value, rest))) = quoted else {
            return line.to_owned();
        };
        let number = value.split_once(' ').and_then(|(number, name)| {
            let unit = unit::ALL.iter().find(|unit| unit.name == name)?;
            Some((number.parse::<f64>().ok()?, unit))
        });
        match number {
            Some((number, unit)) => format!("{key}\"{:?} {}\"{rest}", number * factor(unit.dimension, k), unit.name),
            None => line.to_owned(),
        }
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// Of a quantity of this dimension. With forces and the acceleration of gravity as they are, masses stay too.
fn factor(dimension: unit::Dimension, k: i32) -> f64 {
    2_f64.powi(k * (2 * i32::from(dimension.m) + i32::from(dimension.s)))
}

/// Cranes of two centimetres and of three hundred kilometres, near the ends of what a scene may say: every state, rate, result and parameter of every
/// explicit level is that of the crane as it is, to the last bit, at the start and after the same part of the motion.
#[test]
fn lengths_scale_to_the_last_bit() {
    for level in ["static", "rigid", "rigid with slewing", "swing", "swing with slewing"] {
        let text = levels::scene(level)
            .text()
            .split("[luffing.published]")
            .next()
            .expect("a part")
            .to_owned();
        let text = text.replacen("\nJ_1 ", "\nstep  = \"10 ms\"\nJ_1 ", 1);
        let mut reference = parsed(&text);
        // 19.3 m times 1e-3, and times 16384.
        let mut models = [-5, -3, 4, 7].map(|k| (k, parsed(&scaled(&text, k))));
        for (from, to) in [(0.0, 0.0), (0.0, 0.5), (0.5, 2.25)] {
            reference.advance(from, to).expect("moves");
            for (k, model) in &mut models {
                let time = 2_f64.powi(*k);
                model.advance(from * time, to * time).expect("moves");
                for i in 0..reference.variables().len() {
                    let variable = reference.variables()[i];
                    let (Ok(expected), Ok(found)) = (reference.get(i), model.get(i)) else {
                        panic!("{level}, 4^{k}: {variable}");
                    };
                    let expected = expected * factor(variable.symbol.unit.dimension, *k);
                    // An indicator is a rate, an angle or a moment in turn, and has no dimension.
                    assert!(
                        variable.role == Role::Indicator
                            || variable.kind != Type::Real
                            || expected.to_bits() == found.to_bits(),
                        "{level}, 4^{k}, at {to} s: {variable} = {found:e}, {expected:e}"
                    );
                }
            }
        }
    }
}

/// Dead points from 1e-1 to 1e-15 rad, theta_1 = theta_3 and 1e-15 rad beside it, driven at either bar, set as the input
/// of the running model: 4 ulp in the angle, 1e-14 of the range or of the value in height, moment and velocity, with the
/// instantaneous centre at infinity flagged where it is. Beyond the end there is no value, and the model goes on.
#[test]
fn dead_points_are_set_as_the_input() {
    let row = |line: &'static str| -> Vec<&'static str> { line.split(',').collect() };
    let lines: Vec<Vec<&str>> = POSITIONS.lines().skip(1).map(row).collect();
    for (drive, driven, follower, rate) in [
        ("boom", "theta_1", "theta_3", "omega_1"),
        ("rocker", "theta_3", "theta_1", "omega_3"),
    ] {
        let text = DEFAULT.split("[luffing.drive]").next().expect("a part");
        let mut model = parsed(&text.replacen("driven = \"boom\"", &format!("driven = \"{drive}\""), 1));
        set(&mut model, &[(rate, 1.0)]);
        let of = |case: &str| {
            lines
                .iter()
                .find(|cells| cells[0] == format!("{drive}_{case}"))
                .expect("there")
        };
        let ranges = [2, 4, 6, 8].map(|i| (hex(of("high_1e-1")[i]) - hex(of("low_1e-1")[i])).abs());
        let (mut cases, mut infinite) = (0, 0);
        for cells in lines.iter().filter(|cells| cells[0].starts_with(drive)) {
            set(&mut model, &[(driven, hex(cells[1]))]);
            model
                .update()
                .unwrap_or_else(|fault| panic!("{}: {}", cells[0], fault.message));
            for (i, id) in [follower, "A.y", "M_Q", "V_AX"].into_iter().enumerate() {
                let (value, high, low) = (get(&mut model, id), hex(cells[2 + 2 * i]), hex(cells[3 + 2 * i]));
                let error = ((value - high) - low).abs();
                let allowed = if i == 0 {
                    4.0 * (f64::from_bits(high.abs().to_bits() + 1) - high.abs())
                } else {
                    1e-14 * ranges[i].max(high.abs())
                };
                assert!(error <= allowed, "{}: {id} = {value:e} against {high:e}", cells[0]);
            }
            let far = get(&mut model, "P.at_infinity") == 1.0;
            assert_eq!(far, get(&mut model, "P.x").is_infinite(), "{}", cells[0]);
            assert!(get(&mut model, "M_Q.P").is_finite());
            infinite += i32::from(far);
            cases += 1;
        }
        assert!(
            cases >= 30 && (infinite > 0) == (drive == "boom"),
            "{drive}: {cases}, {infinite}"
        );
        // Assembly ends with the dead point.
        let end = hex(of("low_1e-15")[1]);
        set(&mut model, &[(driven, end)]);
        let before = get(&mut model, "A.y");
        set(&mut model, &[(driven, end - 1e-9)]);
        let fault = model.update().expect_err("does not close");
        assert!(fault.outside && fault.message.contains("close"), "{}", fault.message);
        let height = index(&model, "A.y");
        assert!(model.get(height).is_err());
        set(&mut model, &[(driven, end)]);
        assert_eq!(get(&mut model, "A.y").to_bits(), before.to_bits());
    }
}

/// At the same places the level rigid gives the acceleration of the 50-digit reference, to 1e-11: inertia, slope and
/// moment grow beyond all bounds towards a dead point, their quotient does not lose a digit; on cranes of a centimetre
/// and of ten thousand kilometres too.
#[test]
fn accelerations_at_dead_points() {
    let mut worst = 0.0_f64;
    for line in DYNAMICS.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| cells[i].parse::<f64>().expect("a number");
        let (theta, length, inertia, slope, moment) = (hex(cells[1]), number(2), number(4), number(5), number(6));
        let mut model = levels::model("rigid");
        let g = crane::scaled(length);
        let bodies = crane::bodies(&g, number(3), None);
        let jib = crane::bodies(&g, number(3), Some(crane::PENDULUM)).jib;
        let place = |body: &Body| (body.centre.norm(), f64::direction(body.centre.x, body.centre.y));
        let ([s_1, s_2, s_3], chi_2) = (
            [bodies.boom, jib, bodies.rocker].map(|body| place(&body).0),
            place(&jib).1,
        );
        let l = g.lengths;
        let weight = 9.81 * number(3);
        set(
            &mut model,
            &[
                ("X_1", l.x_1),
                ("X_2", l.x_2),
                ("X_3", l.x_3),
                ("X_4", l.x_4),
                ("X_5", l.x_5),
                ("X_6", l.x_6),
                ("X_7", 1.354 * length),
                ("G_1", 20e3 * weight),
                ("G_2", 6e3 * weight),
                ("G_3", 4e3 * weight),
                ("Q", 16e3 * weight),
                ("s_1", s_1),
                ("s_2", s_2),
                ("s_3", s_3),
                ("chi_2", chi_2),
                ("J_1", bodies.boom.inertia),
                ("J_2", jib.inertia),
                ("J_3", bodies.rocker.inertia),
                ("c_v", 0.0),
                ("M_F", 0.0),
                ("M_A", 1e6),
            ],
        );
        // Away from the nearer end stop, or it would hold the bar.
        let omega = if theta < 1.5 { 0.01 } else { -0.01 };
        set(&mut model, &[("theta_1", theta), ("omega_1", omega)]);
        model.event().expect("closes");
        let expected = (1e6 - moment - 0.5 * slope * omega * omega) / inertia;
        let found = get(&mut model, "der(omega_1)");
        // The summands cancel by as much as they are greater.
        let size = (1e6 + moment.abs() + 0.5 * (slope * omega * omega).abs()) / inertia;
        let error = (found - expected).abs() / size;
        assert!(error < 1e-11, "{}: {found:e} {expected:e}", cells[0]);
        worst = worst.max(error);
    }
    println!("worst {worst:.1e}");
}

/// Continuous states set from outside, at every level and of the steering: no numbers are refused without a change,
/// denormal ones are as zero, and of impossible ones rates and steps are finite or refused. Afterwards everything goes on
/// with the same bits.
#[test]
fn states_of_any_size() {
    let mut models: Vec<(&str, Model)> = (levels::LEVELS.into_iter().skip(1))
        .map(|level| (level, levels::model(level)))
        .collect();
    models.push(("steering", parsed(STEERING)));
    let (mut refused, mut taken) = (0, 0);
    for (level, model) in &mut models {
        run(model, &[0.1]).expect("moves");
        let (saved, good) = (model.state(), states(model));
        let mut rates = vec![0.0; good.len()];
        let mut z = vec![0.0; model.indicators()];
        model.advance(0.1, 0.2).expect("moves");
        let expected = bits(model);
        for i in 0..good.len() {
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                model.set_state(&saved);
                let mut y = good.clone();
                y[i] = value;
                let told = |message: &str| {
                    let said = ["is not finite", "is not allowed: it must be a finite number"];
                    said.iter().any(|said| message.ends_with(said))
                };
                let fault = model.set_states(&y).expect_err("no number");
                assert!(fault.outside && told(&fault.message), "{}", fault.message);
                assert_eq!(states(model), good, "{level}, state {i} = {value}");
            }
            for value in [5e-324, -5e-324, 1e-310, 1e15, -1e15, 1e300, f64::MAX, -f64::MAX] {
                model.set_state(&saved);
                let mut y = good.clone();
                y[i] = value;
                let done = model.set_states(&y).and_then(|()| {
                    model.rates(&mut rates)?;
                    model.event_indicators(&mut z)?;
                    assert!(
                        rates.iter().chain(&z).all(|x| x.is_finite()),
                        "{level}, state {i} = {value:e}: {rates:?} {z:?}"
                    );
                    model.event()?;
                    model.advance(0.1, 0.101)
                });
                match &done {
                    Ok(()) => taken += 1,
                    Err(fault) => {
                        assert!(fault.outside, "{level}, state {i} = {value:e}: {}", fault.message);
                        refused += 1;
                    }
                }
                assert!(
                    states(model).iter().all(|x| x.is_finite()),
                    "{level}, state {i} = {value:e}"
                );
                if value.abs() < 1e-300 {
                    let mut zero = good.clone();
                    zero[i] = 0.0;
                    let result = done.is_ok().then(|| states(model));
                    model.set_state(&saved);
                    let done = model
                        .set_states(&zero)
                        .and_then(|()| model.event())
                        .and_then(|_| model.advance(0.1, 0.101));
                    // A spool just beyond its middle feeds the other port: the solver's other Jacobian gives the
                    // same to its tolerance, tol = 1e-6.
                    let spool = model.variables()[i].symbol.id == "x_v";
                    let part = if spool { 1e-6 } else { 1e-12 };
                    if let (Some(tiny), Ok(())) = (result, done) {
                        for (a, b) in tiny.iter().zip(states(model)) {
                            assert!(
                                (a - b).abs() <= part * b.abs().max(1.0),
                                "{level}, state {i} = {value:e}: {a} {b}"
                            );
                        }
                    }
                }
            }
        }
        model.set_state(&saved);
        model.advance(0.1, 0.2).expect("moves");
        assert_eq!(bits(model), expected, "{level}");
    }
    println!("{taken} taken, {refused} refused");
    assert!(taken > 100 && refused > 50);
}

/// The same through an FMU's instance in Model Exchange: a refusal is an answer, and the instance goes on.
#[test]
fn an_instance_refuses_states_that_are_none() {
    for level in ["rigid", "swing with slewing", "hydraulic"] {
        let scene = levels::scene(level);
        let mut instance = Instance::new(&scene, &token(&scene), Interface::ModelExchange).expect("built");
        instance.set_up(0.0, None).expect("a time");
        instance.start().expect("starts");
        let n = instance.states();
        let (mut good, mut rates, mut again) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        instance.get_states(&mut good).expect("as many");
        instance.get_rates(&mut rates).expect("closes");
        for i in 0..n {
            for value in [f64::NAN, f64::INFINITY, f64::MAX] {
                let mut y = good.clone();
                y[i] = value;
                let mut broken = vec![0.0; n];
                let done = instance.set_states(&y).and_then(|()| instance.get_rates(&mut broken));
                match done {
                    Ok(()) => assert!(broken.iter().all(|x| x.is_finite()), "{level}, state {i} = {value}"),
                    Err(fault) => assert!(fault.outside, "{level}, state {i} = {value}: {}", fault.message),
                }
            }
        }
        instance.set_states(&good).expect("numbers");
        instance.get_rates(&mut again).expect("closes");
        assert_eq!(again, rates, "{level}");
    }
}
