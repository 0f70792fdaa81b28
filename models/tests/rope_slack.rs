//! The rope of a drive goes slack in motion and is caught, on every luffing system that has one: by hand from momentum and energy,
//! beside the same crane without a drive, and beside a rack on the same shaft.

#[path = "common/driven_systems.rs"]
mod driven_systems;
#[path = "common/resumed.rs"]
mod resumed;

use std::f64::consts::TAU;

use driven_systems::{MOTOR, SHAFT, System, close, get, hung, index, model, put, systems, turning};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;

/// Torque (N·m) and delay (s) of a brake on the shaft.
const BRAKE: [f64; 2] = [2000.0, 0.0];

/// The crane slews, and its slewing axis is free.
const SLEWING: &str = "\n[luffing.slewing]\nJ_sl = \"3000 t.m2\"\nomega_sl = \"4 deg/s\"\n";

fn middle(system: &System) -> f64 {
    system.range.iter().sum::<f64>().to_radians() / 2.0
}

/// What the tackle gains for one radian (m), and the mass of drum and shaft as it feels them (kg).
fn tackle(system: &System, at: f64) -> [f64; 2] {
    let arm = SHAFT[1] / TAU;
    [turning(system, at)[0] * arm, SHAFT[0] / (arm * arm)]
}

fn braked(system: &System, level: &str) -> String {
    let text = hung(system, level, MOTOR);
    let [torque, delay] = BRAKE;
    let brake = format!("[cases.brake]\nT_b = \"{torque} N.m\"\ntau_b = \"{delay} s\"\n");
    let text = text.replacen("[cases.motor]", &format!("{brake}[cases.motor]"), 1);
    text.replacen("name = \"I\"", "name = \"I\"\nK_b = \"1\"", 1)
}

/// The same scene without drive and motor.
fn bare(system: &System, level: &str) -> String {
    let text = hung(system, level, "");
    let [from, to] = ["[luffing.drive]", "[luffing.dynamics]"].map(|table| text.find(table).expect("there"));
    format!("{}{}", &text[..from], &text[to..])
}

/// On a rack in place of the rope.
fn racked(system: &System, level: &str) -> String {
    let text = hung(system, level, MOTOR);
    let from = text.find("[luffing.drive]").expect("there");
    let to = from + text[from..].find("[luffing.dynamics]").expect("there");
    let rack = format!(
        "[luffing.drive]\nkind = \"rack\"\n{}r_z = \"150 mm\"\neta_d = \"0.9\"\n\n",
        system.anchors()
    );
    format!("{}{rack}{}", &text[..from], &text[to..])
}

/// Put at an angle, a rate, a slack (m) and a speed of the drum (m/s), with a moment of the drive (N·m).
fn placed(system: &System, text: &str, [at, rate, slack, speed, moment]: [f64; 5]) -> Model {
    let mut model = model(text);
    model.set(0, at).expect("an angle");
    let states = [
        ("M_A", moment),
        (system.rate, rate),
        ("delta_l", slack),
        ("v_tl", speed),
    ];
    put(&mut model, &states);
    model.update().expect("exists");
    model
}

/// One over the inertia that a moment on the link feels while it moves, with what hangs on it (1/(kg·m²)): by two moments.
fn ease(system: &System, text: &str, at: f64, rate: f64) -> f64 {
    let mut model = model(text);
    let name = format!("der({})", system.rate);
    model.set(0, at).expect("an angle");
    put(&mut model, &[(system.rate, rate)]);
    let accelerations = [0.0, 1e6].map(|moment| {
        put(&mut model, &[("M_A", moment)]);
        model.update().expect("exists");
        get(&mut model, [&name])[0]
    });
    (accelerations[1] - accelerations[0]) / 1e6
}

#[test]
fn only_what_can_go_slack_has_a_drum_of_its_own() {
    let own = [
        "delta_l",
        "v_tl",
        "P_Ml",
        "P_bl",
        "z.tackle",
        "z.tackle_rest",
        "z.tackle_loose",
    ];
    for system in &systems() {
        let names = |text: &str| -> Vec<String> {
            let model = model(text);
            model
                .variables()
                .iter()
                .map(|variable| variable.name().to_string())
                .collect()
        };
        for level in ["rigid", "swing"] {
            for text in [hung(system, level, ""), racked(system, level)] {
                assert!(names(&text).iter().all(|name| !own.contains(&name.as_str())), "{level}");
            }
            let found = names(&hung(system, level, MOTOR));
            for name in own {
                assert!(found.iter().any(|known| known == name), "{level}: no {name}");
            }
            assert!(!found.iter().any(|name| name == "z.pull"));
        }
        let model = model(&hung(system, "swing", MOTOR));
        let states = model.variables().iter().filter(|variable| variable.role == Role::State);
        assert_eq!(states.count(), model.states());
    }
}

/// A link that falls on a rope which the drum pays out more slowly: one speed after the blow, by momentum along the tackle, and the loss
/// by hand. With the load on its rope the link is as heavy as a moment feels it.
#[test]
fn the_catch_is_a_plastic_blow() {
    for system in &systems() {
        for level in ["rigid", "swing"] {
            for (part, fall, pays) in [(0.3, 0.05, 0.4), (0.5, 0.05, -0.8), (0.7, 0.01, -20.0)] {
                let [from, to] = system.range.map(f64::to_radians);
                let at = from + part * (to - from);
                let [travel, mass] = tackle(system, at);
                // The link lengthens the tackle as it falls.
                let rate = fall * travel.signum();
                let e = ease(system, &bare(system, level), at, rate);
                let speed = pays * fall * travel.abs();
                let mut model = placed(system, &hung(system, level, MOTOR), [at, rate, 1e-3, speed, 0.0]);
                assert_eq!(get(&mut model, ["W_blow"])[0], 0.0);
                put(&mut model, &[("delta_l", 0.0)]);
                model.update().expect("exists");
                let [after, slack, drum, lost] = get(&mut model, [system.rate, "delta_l", "v_tl", "W_blow"]);
                let closing = travel * rate - speed;
                let blow = closing / (travel * travel * e + 1.0 / mass);
                let expected = rate - travel * e * blow;
                assert!((slack, drum) == (0.0, 0.0), "{slack} {drum}");
                assert!(
                    (after - expected).abs() <= 1e-7 * rate.abs(),
                    "{level}: {after} {expected}"
                );
                let energy = 0.5 * closing * blow;
                assert!(close(lost, energy, 1e-7), "{level}: {lost} {energy}");
                // By the energies themselves: of the link with what hangs on it, and of the drum.
                let common = travel * travel * mass;
                let before = 0.5 * (rate * rate / e + mass * speed * speed);
                let one = 0.5 * (1.0 / e + common) * expected * expected;
                assert!(close(energy, before - one, 1e-9));
            }
        }
    }
}

/// While it is slack the link moves as one without a drive, whatever motor and brakes do.
#[test]
fn a_slack_rope_lets_the_link_move_as_without_a_drive() {
    for system in &systems() {
        for level in ["rigid", "swing"] {
            let at = middle(system);
            let [travel, mass] = tackle(system, at);
            let rate = -0.05 * travel.signum();
            let paid = 0.1 * mass * travel;
            let mut slack = placed(system, &hung(system, level, MOTOR), [at, rate, 0.5, 0.2, paid]);
            let mut free = model(&bare(system, level));
            free.set(0, at).expect("an angle");
            put(&mut free, &[(system.rate, rate)]);
            free.update().expect("exists");
            for step in 0..10 {
                let times = [f64::from(step) * 0.05, f64::from(step + 1) * 0.05];
                for model in [&mut slack, &mut free] {
                    model.advance(times[0], times[1]).expect("moves");
                }
                let [rope] = get(&mut slack, ["delta_l"]);
                assert!(rope > 0.0);
                let coordinate = slack.variables()[0].name().to_string();
                for name in [coordinate.as_str(), system.rate, "A.x", "M_R"] {
                    let [here, there] = [&mut slack, &mut free].map(|model| get(model, [name])[0]);
                    assert!(
                        (here - there).abs() <= 1e-13 * there.abs().max(1e-6),
                        "{level} {name}: {here} {there}"
                    );
                }
                assert_eq!(get(&mut slack, ["M_D", "S_lm"]).map(f64::abs), [0.0; 2]);
            }
            assert!(get(&mut slack, [system.rate])[0] != rate);
        }
    }
}

/// The drum alone: a motor that pays out, brakes that stop it, work and energy of what it does.
#[test]
fn the_drum_turns_by_motor_and_brakes_alone() {
    for system in &systems() {
        let at = middle(system);
        let [travel, mass] = tackle(system, at);
        // At rest at its lower end, where the stop bears the link.
        let text = braked(system, "rigid");
        let end = system.range.map(f64::to_radians)[usize::from(travel > 0.0)];
        let [travel_end, _] = tackle(system, end);
        let moment = 2.0 * mass * travel_end;
        let mut model = placed(system, &text, [end, 0.0, 0.3, 0.0, moment]);
        model.start().expect("begins");
        model.advance(0.0, 0.5).expect("moves");
        let [angle, rate, slack, speed] = get(&mut model, [model_coordinate(system), system.rate, "delta_l", "v_tl"]);
        assert_eq!((angle, rate), (end, 0.0));
        assert!(
            close(speed, 2.0 * 0.5, 1e-12) && close(slack, 0.3 + 0.5 * 2.0 * 0.25, 1e-12),
            "{speed} {slack}"
        );
        let [given, taken] = get(&mut model, ["P_Ml", "P_bl"]);
        assert!(close(given, mass * 2.0 * speed, 1e-12) && taken == 0.0);
        // A brake on the shaft: its torque over the arm of its travel.
        put(&mut model, &[("M_A", 0.0), ("u_br", 1.0)]);
        model.update().expect("exists");
        let slows = BRAKE[0] / (SHAFT[1] / TAU) / mass;
        model.advance(0.5, 0.5 + 0.5 / slows).expect("moves");
        let [slack_then, speed_then, taken] = get(&mut model, ["delta_l", "v_tl", "P_bl"]);
        assert!(close(speed_then, 0.5 * speed, 1e-10), "{speed_then}");
        assert!(close(taken, mass * slows * speed_then, 1e-10));
        assert!(close(slack_then, slack + 0.375 * speed * speed / slows, 1e-10));
        model.advance(1.0, 1.0 + 2.0 / slows).expect("moves");
        let [held] = get(&mut model, ["v_tl"]);
        assert_eq!(held, 0.0);
        // Lifted, a motor that reels in takes the slack up, and the blow lifts the link off its stop.
        put(&mut model, &[("u_br", 0.0), ("M_A", -moment)]);
        model.update().expect("exists");
        let [slack] = get(&mut model, ["delta_l"]);
        // At twice a metre per second squared.
        let until = slack.sqrt();
        model.advance(2.0, 2.0 + until + 1e-6).expect("moves");
        let [caught, drum, lost, lifted] = get(&mut model, ["delta_l", "v_tl", "W_blow", system.rate]);
        assert_eq!([caught, drum], [0.0; 2]);
        let e = ease(system, &bare(system, "rigid"), end, -0.01 * travel_end.signum());
        let closing = 2.0 * until;
        let blow = closing / (travel_end * travel_end * e + 1.0 / mass);
        assert!(close(lost, 0.5 * closing * blow, 1e-9), "{lost}");
        assert!(close(lifted, -travel_end * e * blow, 1e-4), "{lifted}");
    }
}

fn model_coordinate(system: &System) -> &'static str {
    if system.rate == "omega_1" { "theta_1" } else { "phi" }
}

/// A drum that pays out runs on where the link meets its stop, and what the link had is lost.
#[test]
fn a_drum_runs_on_beyond_the_link_s_stop() {
    for system in &systems() {
        let at = middle(system);
        let [travel, _] = tackle(system, at);
        let lower = usize::from(travel > 0.0);
        let end = system.range.map(f64::to_radians)[lower];
        let mut model = model(&hung(system, "rigid", MOTOR));
        // A tenth of a degree from the end, lowered.
        let near = end - 0.1_f64.to_radians() * travel.signum();
        model.set(0, near).expect("an angle");
        put(&mut model, &[(system.rate, 0.2 * travel.signum())]);
        let [needed] = {
            let mut still = driven_systems::model(&hung(system, "static", ""));
            still.set(0, near).expect("an angle");
            get(&mut still, ["M_D"])
        };
        put(&mut model, &[("M_A", needed)]);
        model.update().expect("its rope pulls");
        model.advance(0.0, 0.1).expect("moves");
        let [angle, rate, slack, speed, lost] = get(
            &mut model,
            [model_coordinate(system), system.rate, "delta_l", "v_tl", "W_blow"],
        );
        assert_eq!((angle, rate), (end, 0.0));
        assert!(slack > 0.0 && speed > 0.0, "{slack} {speed}");
        let omega = 0.2;
        let e = ease(system, &bare(system, "rigid"), end, omega * travel.signum());
        assert!(close(lost, 0.5 * omega * omega / e, 2e-2), "{lost}");
    }
}

/// Brakes lifted and laid on so that the rope always pulls: the same bits as by a rack.
#[test]
fn a_rope_that_pulls_is_a_rack() {
    for system in &systems() {
        for level in ["rigid", "swing"] {
            let mut both = [hung(system, level, MOTOR), racked(system, level)].map(|text| model(&text));
            let at = middle(system);
            let [needed] = {
                let mut still = model(&hung(system, "static", ""));
                still.set(0, at).expect("an angle");
                get(&mut still, ["M_D"])
            };
            for model in &mut both {
                model.set(0, at).expect("an angle");
                put(model, &[(system.rate, 0.0), ("M_A", 1.1 * needed)]);
                model.update().expect("its rope pulls");
            }
            for step in 0..8 {
                for model in &mut both {
                    let moment = if step < 4 { 1.1 * needed } else { 0.9 * needed };
                    put(
                        model,
                        &[
                            ("M_A", moment),
                            ("M_S", if step == 7 { 0.3 * needed.abs() } else { 0.0 }),
                        ],
                    );
                    model
                        .advance(f64::from(step) * 0.1, f64::from(step + 1) * 0.1)
                        .expect("moves");
                }
                let [rope, rack] = &mut both;
                let names: Vec<String> = rack
                    .variables()
                    .iter()
                    .map(|variable| variable.name().to_string())
                    .collect();
                let mut same = 0;
                for name in names {
                    let there = rope.variables().iter().position(|variable| variable.name() == name);
                    let Some(there) =
                        there.filter(|_| !["T_d.out", "T_d.in", "T_d", "n_d", "m_z"].contains(&name.as_str()))
                    else {
                        continue;
                    };
                    let of_rack = rack.get(index(rack, &name)).map(f64::to_bits);
                    let of_rope = rope.get(there).map(f64::to_bits);
                    if rope.variables()[there].role == Role::Parameter {
                        continue;
                    }
                    assert_eq!(of_rope, of_rack, "{level} {name}");
                    same += 1;
                }
                assert!(same > 30, "{same}");
                let [pull, slack] = get(rope, ["S_lm", "delta_l"]);
                assert!(pull > 0.0 && slack == 0.0);
            }
        }
    }
}

/// A state on the way of a slack rope goes on with the same bits elsewhere.
#[test]
fn a_state_is_restored_while_slack() {
    for system in &systems() {
        let at = middle(system);
        let [travel, mass] = tackle(system, at);
        for level in ["rigid", "swing"] {
            let text = hung(system, level, MOTOR);
            // It is lowered faster than it falls.
            let moment = 6.0 * mass * travel.signum() * travel.abs() / 1e3;
            let text = text.replacen(
                "step = \"2 ms\"",
                &format!("step = \"2 ms\"\nM_A = \"{moment} kN.m\""),
                1,
            );
            let mut goes = resumed::goes_on(&text, 0.1, 3);
            let [slack, speed] = get(&mut goes, ["delta_l", "v_tl"]);
            assert!(slack > 0.0 && speed > 0.0, "{slack} {speed}");
        }
    }
}

/// Every derivative that the FMU gives while the rope is slack, against differences of the values that it gives.
#[test]
fn derivatives_while_slack_are_those_of_the_values() {
    for system in &systems() {
        let at = middle(system);
        let [travel, mass] = tackle(system, at);
        let rate = -0.05 * travel.signum();
        for speed in [0.2, -0.1] {
            let mut model = placed(
                system,
                &braked(system, "swing"),
                [at, rate, 0.5, speed, 0.7 * mass * travel],
            );
            put(&mut model, &[("u_br", 1.0), ("M_S", 1e5), ("phi_R", 0.03)]);
            model.start().expect("exists");
            model.update().expect("exists");
            let omega = format!("der({})", system.rate);
            let results = [
                omega.as_str(),
                "der(v_tl)",
                "der(delta_l)",
                "P_Ml",
                "P_bl",
                "z.tackle",
                "z.tackle_rest",
                "S_R",
            ];
            let mut compared = 0;
            for name in [
                "E_x",
                "s_d",
                "J_M",
                "l_M",
                "M_A",
                "M_S",
                system.rate,
                "delta_l",
                "v_tl",
                "phi_R",
                "Q",
            ] {
                let known = index(&model, name);
                let (x, variable) = (model.get(known).expect("exists"), model.variables()[known]);
                for result in results {
                    let found = index(&model, result);
                    let h = 1e-4 * x.abs().max(1e-2);
                    let at = |value: f64| {
                        let mut moved = model.clone();
                        moved.set(known, value).expect("allowed");
                        moved.update().expect("exists");
                        moved.get(found).expect("exists")
                    };
                    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|part| at(x + part * h));
                    let by_values = (a - d + 8.0 * (c - b)) / (12.0 * h);
                    let mut tangent =
                        model.tangent(&|(symbol, number)| f64::from((symbol, number) == variable.quantity()));
                    let by_rule = model.derivative(&mut tangent, found).expect("exists");
                    let size = by_rule.abs() + b.abs() / x.abs().max(1e-2);
                    assert!(
                        (by_rule - by_values).abs() <= 1e-7 * size,
                        "{name} {result}: {by_rule} {by_values}"
                    );
                    compared += usize::from(by_rule != 0.0);
                }
            }
            assert!(compared >= 25, "{compared}");
        }
    }
}

/// On a crane that slews, the blow keeps the momentum along the tackle and about the slewing axis, and takes energy.
#[test]
fn a_crane_that_slews_is_caught_as_one_that_does_not() {
    let system = systems()[0];
    for level in ["rigid", "swing"] {
        let at = middle(&system);
        let [travel, mass] = tackle(&system, at);
        let rate = 0.05 * travel.signum();
        let slews = |text: String| format!("{text}{SLEWING}");
        let e = ease(&system, &slews(bare(&system, level)), at, rate);
        let speed = -0.03 * travel.abs();
        let mut model = placed(
            &system,
            &slews(hung(&system, level, MOTOR)),
            [at, rate, 1e-3, speed, 0.0],
        );
        assert_eq!(get(&mut model, ["W_blow"])[0], 0.0);
        put(&mut model, &[("delta_l", 0.0)]);
        model.update().expect("exists");
        let [after, lost, slack] = get(&mut model, [system.rate, "W_blow", "delta_l"]);
        let closing = travel * rate - speed;
        let blow = closing / (travel * travel * e + 1.0 / mass);
        assert_eq!(slack, 0.0);
        assert!(
            (after - (rate - travel * e * blow)).abs() <= 1e-7 * rate.abs(),
            "{level}: {after}"
        );
        assert!(close(lost, 0.5 * closing * blow, 1e-7), "{level}: {lost}");
    }
}

/// At rest a motor that would pay out against its brake leaves the rope no pull where friction in the pins holds the link; beyond its
/// brake the drum pays out, and the link stays.
#[test]
fn a_link_that_its_friction_holds_stays_beside_the_drum() {
    for system in &systems() {
        let at = middle(system);
        let [travel, mass] = tackle(system, at);
        let [needed] = {
            let mut still = model(&hung(system, "static", ""));
            still.set(0, at).expect("an angle");
            get(&mut still, ["M_D"])
        };
        let friction = format!("step = \"2 ms\"\nM_F = \"{} kN.m\"", 2.0 * needed.abs() / 1e3);
        let text = hung(system, "rigid", MOTOR).replacen("step = \"2 ms\"", &friction, 1);
        let mut model = model(&text);
        model.set(0, at).expect("an angle");
        put(
            &mut model,
            &[(system.rate, 0.0), ("M_S", needed.abs()), ("M_A", -0.8 * needed)],
        );
        model.advance(0.0, 0.1).expect("rests");
        let seen = ["S_lm", "M_D", "delta_l", "v_tl", system.rate];
        assert_eq!(get(&mut model, seen).map(f64::abs), [0.0; 5]);
        // Of friction, brake and motor the link feels its weights alone.
        let [rests] = get(&mut model, ["M_R"]);
        assert!(close(rests, needed + 0.8 * needed, 1e-12));
        put(&mut model, &[("M_A", -1.5 * needed)]);
        model.advance(0.1, 0.2).expect("moves");
        let [pull, slack, speed, rate] = get(&mut model, ["S_lm", "delta_l", "v_tl", system.rate]);
        let pays = 0.5 * needed.abs() / (travel.abs() * mass);
        assert_eq!([pull.abs(), rate], [0.0; 2]);
        assert!(
            close(speed, 0.1 * pays, 1e-9) && close(slack, 0.005 * pays, 1e-9),
            "{speed} {slack}"
        );
    }
}
