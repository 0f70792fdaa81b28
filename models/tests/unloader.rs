//! A grab unloader: the textbook's planetary speeds, torques and powers that cancel, equilibrium of the trolley and virtual work
//! in all four schemes, drums against the geometry of their ropes, phases against the same states at any time.

#[path = "common/named.rs"]
mod named;

use std::f64::consts::{PI, TAU};

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::scene::Scene;
use lemnis_models::sway::starts::Start;
use lemnis_models::unloader::foreseen::Foreseen;
use lemnis_models::unloader::reeving::{SCHEMES, Scheme};

use named::{get, index, model, near, set};

const READY: &str = include_str!("../scenes/grab_unloader.toml");

const SWAY: &str = include_str!("../scenes/grab_sway.toml");
const G: f64 = 9.81;

/// The ready scene with another scheme, of which the slack rope has 20 kN and the auxiliary trolley 5 t.
fn scene(scheme: Scheme) -> String {
    let name = SCHEMES[Scheme::ALL.iter().position(|known| *known == scheme).expect("known")];
    if scheme == Scheme::Planetary {
        return READY.to_owned();
    }
    let (head, rest) = READY.split_once("k       = ").expect("teeth");
    let (_, rest) = rest.split_once("\n\n").expect("drums");
    let (drums, rest) = rest
        .split_once("[[grab_unloader.drums]]       # closing, land side")
        .expect("four");
    let (_, phases) = rest.split_once("\n\n").expect("phases");
    let own = if scheme == Scheme::AuxiliaryTrolley {
        "G_a = \"5 t\"\n"
    } else {
        ""
    };
    format!("{head}T_0 = \"20 kN\"\n{own}\n{drums}\n{phases}").replace("\"planetary\" ", &format!("\"{name}\" "))
}

/// Told speeds of trolley, hoisting and closing (m/s), acceleration (m/s²), contents and part of the closing ropes.
const TOLD: [[f64; 6]; 5] = [
    [0.0, 2.0, 0.0, 0.0, 1.0, 0.5],
    [0.0, 0.0, 1.2, 0.0, 0.6, 1.0],
    [3.0, 0.0, 0.0, 0.5, 1.0, 0.3],
    [-3.5, 1.5, 0.0, 0.4, 1.0, 0.5],
    [2.5, -2.0, -0.4, -0.6, 0.0, 0.2],
];

fn tell(model: &mut Model, told: [f64; 6]) {
    for (name, value) in ["v_t", "v_h", "v_c", "a_t", "k_q", "lambda_c"].into_iter().zip(told) {
        set(model, name, value);
    }
}

fn all(model: &mut Model, name: &str, count: usize) -> Vec<f64> {
    (1..=count).map(|i| get(model, &format!("{name}[{i}]"))).collect()
}

/// k = 4, sun 1200, ring 300: carrier 480 r/min. [the differential's textbook example]
#[test]
fn a_sun_of_1200_and_a_ring_of_300_turn_the_carrier_by_480() {
    let mut model = model(READY);
    let round = PI * 1.4;
    set(&mut model, "v_h", 20.0 / 5.0 * round);
    set(&mut model, "v_t", 5.0 * 4.0 / 5.0 * round);
    near(get(&mut model, "n_s[1]") * 60.0, 1200.0, 1e-10);
    near(get(&mut model, "n_r[1]") * 60.0, 300.0, 1e-10);
    near(get(&mut model, "n_d[1]") * 60.0, 480.0, 1e-10);
    // The ring of the land side turns the other way round.
    near(get(&mut model, "n_r[2]") * 60.0, -300.0, 1e-10);
    near(get(&mut model, "n_d[2]") * 60.0, 0.0, 1e-10);
    // One of both held.
    near(get(&mut model, "n_ds[1]") * 60.0, 240.0, 1e-10);
    near(get(&mut model, "n_dr[1]") * 60.0, 240.0, 1e-10);
}

/// T_s : T_r : T_c = 1 : k : −(1 + k), Σ T n = 0, and what the rings of one side give the others take, but for the travel.
#[test]
fn torques_times_speeds_cancel() {
    let mut model = model(READY);
    for told in TOLD {
        tell(&mut model, told);
        let [n, m, n_s, n_r, t_s, t_r, p_s, p_r] =
            ["n_d", "M_d", "n_s", "n_r", "T_s", "T_r", "P_s", "P_r"].map(|name| all(&mut model, name, 4));
        let size = m.iter().fold(1.0_f64, |most, torque| most.max(torque.abs()));
        for i in 0..4 {
            near(t_s[i] + t_r[i], m[i], 1e-12 * size);
            near(t_r[i], 4.0 * t_s[i], 1e-12 * size);
            near(n_s[i] * t_s[i] + n_r[i] * t_r[i] - n[i] * m[i], 0.0, 1e-12 * size);
        }
        let travel = get(&mut model, "F_r") * told[0];
        near(p_r.iter().sum(), travel, 1e-10 * size);
        let lifts = get(&mut model, "W") * (told[1] + told[5] * told[2]);
        near(p_s.iter().sum(), lifts, 1e-10 * size);
        // Of each pair what one ring gives and the other one takes.
        let round: f64 = [0, 2].iter().map(|&i| p_r[i].abs().min(p_r[i + 1].abs())).sum();
        near(get(&mut model, "P_circ"), round, 1e-10 * size);
    }
}

/// By hand: horizontally the ropes hold what the trolley asks for, vertically grab and contents.
#[test]
fn the_trolley_is_in_equilibrium() {
    for scheme in Scheme::ALL {
        let mut model = model(&scene(scheme));
        for told in TOLD {
            tell(&mut model, told);
            let [v, _, _, a, k_q, _] = told;
            let weight = (12e3 + 16e3 * k_q) * 9.81;
            let rest = 0.008 * (weight + 12e3 * 9.81) + 250.0 * 40.0 + weight * (1.0 - 0.98_f64 * 0.98);
            let sense = if v == 0.0 { 0.0 } else { v.signum() };
            let asked = sense * rest + (weight / 9.81 + 12e3) * a;
            near(get(&mut model, "F_r"), asked, 1e-10 * weight);
            let [sea, land] = ["T_1", "T_2"].map(|name| get(&mut model, name));
            if scheme == Scheme::Planetary {
                near(sea + land, weight, 1e-12 * weight);
                near(sea - land, asked, 1e-10 * weight);
            } else {
                near(sea - land - weight, asked, 1e-10 * weight);
                near(sea.min(land), 20e3, 1e-9);
            }
        }
    }
}

/// What all drums need is what lifts the grab, closes it and moves the trolleys, however the ropes are led.
#[test]
fn virtual_work() {
    for scheme in Scheme::ALL {
        let mut model = model(&scene(scheme));
        for told in TOLD {
            tell(&mut model, told);
            let mut wanted = get(&mut model, "W") * (told[1] + told[5] * told[2]) + get(&mut model, "F_r") * told[0];
            if scheme == Scheme::AuxiliaryTrolley {
                wanted += get(&mut model, "F_ra") * told[0] / 2.0;
            }
            let drums = all(&mut model, "P_d", scheme.drums());
            near(drums.iter().sum(), wanted, 1e-9 * 300e3);
            let motors: f64 = ["P_h", "P_c", "P_t"].map(|name| get(&mut model, name)).iter().sum();
            // Losses between motors and ropes: never less than what the ropes take.
            assert!(motors >= wanted - 1e-6, "{motors} of {wanted}");
        }
    }
}

/// Lengths of ropes from the places of trolley and grab: x to the sea, depth h below the bridge; an auxiliary trolley at y
/// around which the rope turns on the land side.
#[test]
fn drums_wind_what_the_geometry_leaves() {
    type Length = fn(f64, f64) -> f64;
    let cases: [(Scheme, &[Length]); 3] = [
        (Scheme::Planetary, &[|x, h| 60.0 - x + h, |x, h| 10.0 + x + h]),
        (Scheme::Simple, &[|x, h| 10.0 + x + h]),
        (Scheme::AuxiliaryTrolley, &[|x, h| (60.0 - x / 2.0) + (x - x / 2.0) + h]),
    ];
    let (dt, v_t, v_h) = (0.25, 3.0, 1.5);
    for (scheme, lengths) in cases {
        let mut model = model(&scene(scheme));
        set(&mut model, "v_t", v_t);
        set(&mut model, "v_h", v_h);
        for (drum, length) in (1..).zip(lengths) {
            let wound = length(20.0, 15.0) - length(20.0 + v_t * dt, 15.0 - v_h * dt);
            near(get(&mut model, &format!("v_r[{drum}]")) * dt, wound, 1e-13);
            near(get(&mut model, &format!("n_d[{drum}]")) * PI * 1.4 * dt, wound, 1e-13);
        }
    }
}

/// Half the speed keeps the rope's length; the grab's height does not change while the trolley goes there and back.
#[test]
fn the_auxiliary_trolley_keeps_the_length() {
    let mut model = model(&scene(Scheme::AuxiliaryTrolley));
    set(&mut model, "v_h", 0.0);
    let mut wound = 0.0;
    for i in 0..100 {
        set(&mut model, "v_t", 4.0 * (1.0 - f64::from(i) / 49.5));
        assert_eq!(get(&mut model, "d_l"), 0.0);
        near(get(&mut model, "v_aux"), get(&mut model, "v_t") / 2.0, 0.0);
        wound += get(&mut model, "n_d[1]") * 0.1;
    }
    assert_eq!(wound, 0.0);
}

/// The way to the land is the way to the sea in a mirror.
#[test]
fn a_mirror() {
    let mut model = model(READY);
    tell(&mut model, TOLD[2]);
    let sea = ["T_1", "T_2", "n_d[1]", "S_r[1]", "P_d[4]"].map(|name| get(&mut model, name));
    let mut other = TOLD[2];
    (other[0], other[3]) = (-other[0], -other[3]);
    tell(&mut model, other);
    let land = ["T_2", "T_1", "n_d[2]", "S_r[2]", "P_d[3]"].map(|name| get(&mut model, name));
    for (one, other) in sea.into_iter().zip(land) {
        near(one, other, 1e-12 * one.abs());
    }
}

/// What a phase has is what the same is told at any time; its cycle by hand.
#[test]
fn phases_are_states() {
    for scheme in Scheme::ALL {
        let mut model = model(&scene(scheme));
        for phase in 1..=8 {
            let names = ["v_tp", "v_hp", "v_cp", "a_tp", "k_qp", "lambda_p"];
            let told = names.map(|name| get(&mut model, &format!("{name}[{phase}]")));
            tell(&mut model, told);
            let pairs = [
                ("W_p", "W"),
                ("T_1p", "T_1"),
                ("T_2p", "T_2"),
                ("P_hp", "P_h"),
                ("P_cp", "P_c"),
                ("P_tp", "P_t"),
            ];
            for (one, other) in pairs {
                let wanted = get(&mut model, other);
                near(
                    get(&mut model, &format!("{one}[{phase}]")),
                    wanted,
                    1e-12 * wanted.abs().max(1.0),
                );
            }
            let pulls = all(&mut model, "S_r", scheme.drums());
            let safety = pulls
                .iter()
                .filter(|pull| **pull > 0.0)
                .map(|pull| 850e3 / pull)
                .fold(f64::INFINITY, f64::min);
            near(get(&mut model, &format!("nu_p[{phase}]")), safety, 1e-12 * safety);
        }
    }
}

#[test]
fn the_cycle_by_hand() {
    let mut model = model(READY);
    near(get(&mut model, "t_cyc"), 50.0, 0.0);
    near(get(&mut model, "q_cyc"), 16e3 / 50.0, 1e-12);
    near(get(&mut model, "W_max"), 28e3 * 9.81, 1e-9);
    // 28 t for 32 s, 12 t for 18 s.
    near(
        get(&mut model, "k_p"),
        (32.0 + 18.0 * (3.0_f64 / 7.0).powi(3)) / 50.0,
        1e-14,
    );
    // Hoisting: 40 % of 28 t at 2.5 m/s for 8 s, half at 1.5 m/s for 6 s; 80 % of 12 t down at 1.5 m/s for 12 s, 2.5 m/s for 6 s.
    let up = [(0.4 * 28.0 * 2.5, 8.0), (0.5 * 28.0 * 1.5, 6.0)].map(|(p, t)| (p / 0.93_f64).powi(2) * t);
    let down = [(0.8 * 12.0 * 1.5, 12.0), (0.8 * 12.0 * 2.5, 6.0)].map(|(p, t)| (p * 0.93_f64).powi(2) * t);
    let mean = (up.iter().sum::<f64>() + down.iter().sum::<f64>()) / 50.0;
    near(get(&mut model, "P_h_rms"), 9810.0 * mean.sqrt(), 1e-7);
    set(&mut model, "v_h", -2.5);
    near(get(&mut model, "phi_2"), 1.1 + 0.34 * 2.5, 1e-15);
}

/// An acceleration that the grab's weight cannot give to the trolley: the rope behind it is slack.
#[test]
fn a_slack_rope_is_told() {
    let mut model = model(READY);
    set(&mut model, "k_q", 0.0);
    set(&mut model, "a_t", 6.0);
    assert_eq!(get(&mut model, "slack"), 1.0);
    assert!(get(&mut model, "T_2") < 0.0 && get(&mut model, "z.slack") < 0.0);
    set(&mut model, "a_t", 0.6);
    assert_eq!(get(&mut model, "slack"), 0.0);
    // In a phase: what follows from the cycle does not exist.
    set(&mut model, "a_tp[4]", 6.0);
    let at = index(&model, "k_p");
    let fault = model.get(at).expect_err("slack");
    assert!(fault.message.starts_with("phase 4: "), "{}", fault.message);
}

/// The book's checks are passed in every scheme, and the schemes with ropes of their own have no differentials.
#[test]
fn the_ready_scene_in_all_schemes() {
    for scheme in Scheme::ALL {
        let read = Scene::parse(&scene(scheme)).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
        assert_eq!(read.levels(), ["static"]);
        let sheet = read.sheet();
        let own = scheme == Scheme::Planetary;
        assert_eq!(sheet.identities.len(), if own { 3 } else { 1 });
        for check in &sheet.identities {
            assert!(check.passed(), "{} by {}", check.id, check.value);
        }
        let told = sheet.sections().any(|section| section.id == "unloader_planetary");
        assert_eq!(told, own);
    }
}

fn foreseen(told: [f64; 2], hoisting: Option<[f64; 2]>) -> Foreseen {
    let over = |[speed, time]: [f64; 2]| {
        let rows = vec![[0.0, speed], [time, 0.0]];
        lemnis_models::kernel::course::Course {
            rows,
            between: lemnis_models::kernel::course::Between::Steps,
            shaped: None,
        }
    };
    Foreseen {
        length: 20.0,
        hoisting: hoisting.map(over),
        gravity: G,
        told,
        way: 40.0,
    }
}

/// On ropes of one length the programme by the angle is that by sixths of the period, the nearer the smaller the sway is.
#[test]
fn the_predicted_angle_gives_sixths_of_the_period() {
    let period = TAU * (20.0_f64 / G).sqrt();
    for (told, within) in [([0.4, 0.06], 2e-5), ([0.04, 0.006], 2e-7)] {
        let mut known = foreseen(told, None);
        known.way = 12.0 * told[0] / told[1] * told[0];
        let found = known.by_angle().expect("it has room");
        let wanted = Start::Sixths.course(told, period);
        for (found, wanted) in found.rows.iter().zip(&wanted.rows) {
            near(found[0] / period, wanted[0] / period, 10.0 * within);
            near(found[1] / told[1], wanted[1] / told[1], within);
        }
    }
}

/// Whatever is hoisted meanwhile, the predicted programme ends its way at rest with no sway; that by the period does not.
#[test]
fn the_predicted_angle_leaves_no_sway_while_hoisting() {
    for hoisting in [None, Some([1.2, 8.0]), Some([-0.8, 9.0])] {
        let known = foreseen([3.5, 0.6], hoisting);
        let text = |course: &lemnis_models::kernel::course::Course| {
            let row = |[time, rate]: &[f64; 2]| format!("[\"{time:?} s\", \"{:?} m/s2\"]", -rate);
            let rows: Vec<String> = course.rows.iter().map(row).collect();
            let (head, rest) = SWAY.split_once("a_t     =").expect("commands");
            let (_, rest) = rest.split_once("v_c     =").expect("closing");
            let hoist = hoisting.map_or_else(String::new, |[speed, time]| {
                format!("v_h = {{ between = \"steps\", over = [[\"0 s\", \"{speed:?} m/s\"], [\"{time:?} s\", \"0 m/s\"]] }}\n")
            });
            format!(
                "{head}a_t = {{ between = \"steps\", over = [{}] }}\n{hoist}v_c     ={rest}",
                rows.join(", ")
            )
            .replace("zeta_f  = \"0.3\"               # feedback of the sway\n", "")
            .replace("l_R = \"24 m\"", "l_R = \"20 m\"")
        };
        let left = |course: &lemnis_models::kernel::course::Course| {
            let mut moving = model(&text(course));
            moving.start().expect("it begins");
            moving.advance(0.0, course.end()).expect("it goes on");
            near(get(&mut moving, "v_t"), 0.0, 1e-9);
            near(get(&mut moving, "x_t"), 25.0 - 40.0, 1e-7);
            let length = get(&mut moving, "l_R");
            let rate = get(&mut moving, "omega_R") * (length / G).sqrt();
            (get(&mut moving, "phi_R").powi(2) + rate.powi(2)).sqrt()
        };
        let [angle, period] = [known.by_angle().expect("it has room"), known.by_period()].map(|course| left(&course));
        assert!(angle < 1e-7, "{angle}");
        assert!(hoisting.is_none() || period > 0.01, "{period}");
    }
}

/// A pendulum that is drawn in keeps the moment of its momentum but for what gravity gives: energy by the work of its rope.
#[test]
fn hoisting_gives_the_grab_its_energy() {
    let (head, rest) = SWAY.split_once("a_t     =").expect("commands");
    let (_, rest) = rest.split_once("v_c     =").expect("closing");
    let text = format!("{head}phi_R = \"20 deg\"\nv_h = \"1.5 m/s\"\nv_c     ={rest}");
    let mut moving = model(&text.replace("zeta_f  = \"0.3\" ", "zeta_f  = \"0\" "));
    moving.start().expect("it begins");
    let energy = |moving: &mut Model| {
        let [l, phi, omega] = ["l_R", "phi_R", "omega_R"].map(|name| get(moving, name));
        28e3 * (0.5 * (l * l * omega * omega + 2.25) - G * l * Calc::sin_cos(phi).1)
    };
    let begun = energy(&mut moving);
    let (mut work, steps) = (0.0, 4000);
    let mut before = get(&mut moving, "S_R");
    for i in 0..steps {
        let at = |i: u32| 8.0 * f64::from(i) / f64::from(steps);
        moving.advance(at(i), at(i + 1)).expect("it goes on");
        let now = get(&mut moving, "S_R");
        work += f64::midpoint(before, now) * 1.5 * 8.0 / f64::from(steps);
        before = now;
    }
    near((energy(&mut moving) - begun) / work, 1.0, 1e-6);
    near(get(&mut moving, "l_R"), 12.0, 1e-9);
}

/// Closed forms of the way, and that the ready scene ends it nearly at rest.
#[test]
fn the_way_in_closed_form() {
    let mut moving = model(SWAY);
    let omega = (G / 24.0_f64).sqrt();
    near(get(&mut moving, "T_g"), TAU / omega, 1e-13);
    near(get(&mut moving, "phi_st"), 0.7 / G, 1e-15);
    let left = 2.0 * 0.7 / G * Calc::sin(omega * 4.0 / 0.7 / 2.0).abs();
    near(get(&mut moving, "rho_pl"), left, 1e-14);
    near(get(&mut moving, "t_pl"), 45.0 / 4.0 + 4.0 / 0.7, 1e-13);
    near(
        get(&mut moving, "t_pr"),
        45.0 / 4.0 + 4.0 / 0.7 + TAU / omega / 3.0,
        1e-12,
    );
    moving.start().expect("it begins");
    // Whatever is hoisted: faster than told by the gain times the sway.
    for (from, to, told) in [
        (0.0, 4.0, -2.8),
        (4.0, 8.5, -4.0),
        (8.5, 13.0, -4.0 + 0.7 * 1.75),
        (13.0, 30.0, 0.0),
    ] {
        moving.advance(from, to).expect("it goes on");
        let gain = 0.6 * (G * get(&mut moving, "l_R")).sqrt();
        near(get(&mut moving, "v_t"), told + gain * get(&mut moving, "phi_R"), 3e-5);
    }
    near(get(&mut moving, "phi_R"), 0.0, 0.5_f64.to_radians());
}
