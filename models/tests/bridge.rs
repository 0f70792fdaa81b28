//! The trolley of a container bridge: statics by hand in all three kinds, the sway's frequency in limits and against energy, skew
//! against the height of the spreader, starts, and the pendulum's motion against the elliptic integral.

#[path = "common/named.rs"]
mod named;

use std::f64::consts::{PI, TAU};

use lemnis_models::kernel::calc::Calc;
use lemnis_models::scene::Scene;
use lemnis_models::sway::starts::Start;

use named::{get, index, model, near, set};

const READY: &str = include_str!("../scenes/container_bridge.toml");
const G: f64 = 9.81;

fn cos(angle: f64) -> f64 {
    Calc::sin_cos(angle).1
}

/// The ready scene as another kind, its place and speed as inputs.
fn still(kind: &str) -> String {
    let (head, rest) = READY.split_once("x_t     =").expect("its start");
    let (_, rest) = rest.split_once("[trolley.tow]").expect("its rope");
    let (tow, rest) = rest.split_once("[trolley.sheaves]").expect("its sheaves");
    let (sheaves, rest) = rest.split_once("[trolley.ropes]").expect("its ropes");
    let tow = match kind {
        "rope" => format!("[trolley.tow]{tow}"),
        _ => "[trolley.driven]\nn_dr = \"2\"\nmu_a = \"0.14\"\n".to_owned(),
    };
    let sheaves = match kind {
        "machinery" => String::new(),
        _ => format!("[trolley.sheaves]{sheaves}"),
    };
    let limits: Vec<&str> = rest
        .lines()
        .filter(|line| kind == "rope" || !(line.starts_with("f_tow_max") || line.starts_with("nu_tow_min")))
        .collect();
    format!("{head}\n{tow}\n{sheaves}\n[trolley.ropes]{}", limits.join("\n"))
        .replace("kind     = \"rope\" ", &format!("kind     = \"{kind}\" "))
        .replace("fidelity = \"swing\"", "fidelity = \"static\"")
}

/// The ready scene in motion without commands.
fn free(phi: &str) -> String {
    let (head, rest) = READY.split_once("# Shaped against").expect("its commands");
    let (_, rest) = rest.split_once("[trolley.tow]").expect("its rope");
    format!("{head}\nphi_R = \"{phi}\"\n[trolley.tow]{rest}")
}

/// Parallel ropes: the frequency of one rope, to the last digits, wherever the centre of gravity is and however the load turns.
#[test]
fn parallel_ropes_sway_as_one() {
    let mut still = model(&still("rope"));
    set(&mut still, "a_u", 2.4);
    for (depth, radius) in [(0.0, 0.1), (2.0, 1.1), (9.0, 5.0)] {
        set(&mut still, "e_q", depth);
        set(&mut still, "i_q", radius);
        for length in [3.0, 18.0, 45.0] {
            set(&mut still, "l_R", length);
            let square = get(&mut still, "omega_e").powi(2);
            near(square * length / G, 1.0, 4e-16);
            near(get(&mut still, "k_omega"), 1.0, 4e-16);
            near(get(&mut still, "lambda_e"), 1.0, 4e-16);
            near(get(&mut still, "nu_x"), 1.0, 0.0);
        }
    }
}

/// Height and travel of the centre of gravity of a four-bar whose spreader is turned by an angle, by bisection of the loop.
fn posed(l: f64, a_o: f64, a_u: f64, e_q: f64, turn: f64) -> [f64; 2] {
    let (sin, cos) = Calc::sin_cos(turn);
    // u p = y a_u sin, with p the half difference of the joints; the ropes' length gives y.
    let p = a_o - a_u * cos;
    let error = |y: f64| {
        let u = y * a_u * sin / p;
        u * u + p * p + y * y + (a_u * sin).powi(2) - l * l
    };
    let (mut low, mut high) = (-l, -0.5 * l);
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if error(middle) > 0.0 {
            low = middle
        } else {
            high = middle
        }
    }
    let u = low * a_u * sin / p;
    [low - e_q * cos, u + e_q * sin]
}

/// The frequency by energy: second differences of the height over the square of the travel and the turn, any trapezoid.
#[test]
fn the_frequency_by_energy() {
    let mut still = model(&still("rope"));
    for (l, a_o, a_u, e_q, i_q) in [
        (18.0, 2.4, 1.1, 2.0, 1.1),
        (18.0, 1.1, 2.4, 2.0, 1.1),
        (9.0, 3.0, 1.0, 0.0, 2.0),
        (30.0, 2.0, 1.9, 4.0, 1.5),
    ] {
        for (name, value) in [("l_R", l), ("a_o", a_o), ("a_u", a_u), ("e_q", e_q), ("i_q", i_q)] {
            set(&mut still, name, value);
        }
        let step = 1e-3;
        let [back, rest, on] = [-step, 0.0, step].map(|turn| posed(l, a_o, a_u, e_q, turn));
        let rise = (back[0] - 2.0 * rest[0] + on[0]) / (step * step);
        let travel = (on[1] - back[1]) / (2.0 * step);
        let square = G * rise / (travel * travel + i_q * i_q);
        let found = get(&mut still, "omega_e").powi(2);
        // Differences leave a part of the order of the step's square, and rounding over it.
        near(
            found / square,
            1.0,
            2e-4 * (1.0 + (a_u / (a_o - a_u)).abs()) * step / 1e-3,
        );
        let near_l = 1e-5;
        let lengths = [l - near_l, l + near_l].map(|length| {
            set(&mut still, "l_R", length);
            get(&mut still, "l_e")
        });
        set(&mut still, "l_R", l);
        near(
            get(&mut still, "lambda_e"),
            (lengths[1] - lengths[0]) / (2.0 * near_l),
            1e-8,
        );
    }
}

/// Small skew by the height of the spreader: a turn about the vertical draws each joint away from its own.
#[test]
fn skew_by_height() {
    let mut still = model(&still("rope"));
    set(&mut still, "a_t", 0.6);
    // The two ropes of a side together keep their length, over an equaliser.
    let height = |turn: f64| {
        let (sin, cos) = Calc::sin_cos(turn);
        let apart = [1.0, -1.0].map(|side| {
            let lower = [1.1 * cos - side * 3.0 * sin, 1.1 * sin + side * 3.0 * cos];
            (2.4 - lower[0]).powi(2) + (side * 3.0 - lower[1]).powi(2)
        });
        let (mut low, mut high) = (10.0, 18.0);
        for _ in 0..200 {
            let middle = f64::midpoint(low, high);
            let both: f64 = apart.iter().map(|square| (middle * middle + square).sqrt()).sum();
            if both < 36.0 { low = middle } else { high = middle }
        }
        low
    };
    let step = 1e-2;
    let stiffness = (2.0 * height(0.0) - height(step) - height(-step)) / (step * step);
    let omega = get(&mut still, "omega_z");
    near(omega * omega * 3.4 * 3.4 / (G * stiffness), 1.0, 1e-4);
    near(get(&mut still, "psi_z") * G * stiffness / (0.6 * 0.5), 1.0, 1e-4);
}

/// By hand, at 3 m/s and 0.6 m/s² to the sea, 10 m before the rail: 14 t of trolley, 54 t on the ropes.
#[test]
fn statics_by_hand() {
    for kind in ["rope", "semi_rope", "machinery"] {
        let mut still = model(&still(kind));
        for (name, value) in [
            ("x_t", 10.0),
            ("v_t", 3.0),
            ("a_t", 0.6),
            ("v_h", -1.5),
            ("gamma_b", 0.01),
        ] {
            set(&mut still, name, value);
        }
        let (borne, weight) = (68e3 * G, 54e3 * G);
        let passed = if kind == "machinery" {
            0.0
        } else {
            weight * (1.0 - 0.98_f64 * 0.98)
        };
        let against = 0.008 * borne * cos(0.01) + 250.0 * 45.0 + passed;
        let asked = against + borne * Calc::sin(0.01) + 68e3 * 0.6;
        near(get(&mut still, "F_r"), asked, 1e-12 * borne);
        near(get(&mut still, "P_t"), asked * 3.0 / 0.9, 1e-11 * borne);
        near(get(&mut still, "P_h"), -1.5 * weight * 0.9, 1e-11 * borne);
        near(get(&mut still, "R_1"), borne * 40.0 / 30.0, 1e-11 * borne);
        near(get(&mut still, "R_2"), -borne / 3.0, 1e-11 * borne);
        near(get(&mut still, "R_1") + get(&mut still, "R_2"), borne, 1e-11 * borne);
        near(get(&mut still, "N_r"), borne / 4.0, 1e-11 * borne);
        if kind == "rope" {
            let pulled = 60e3 + asked / 2.0;
            near(get(&mut still, "T_1"), pulled, 1e-12 * borne);
            near(get(&mut still, "T_2"), 60e3, 0.0);
            near(get(&mut still, "f_1"), 21.0 * 42.0 * 42.0 / (8.0 * pulled), 1e-14);
            near(get(&mut still, "f_2"), 21.0 * 56.0 * 56.0 / (8.0 * 60e3), 1e-14);
            near(get(&mut still, "delta_1"), pulled * 42.0 / 28e6, 1e-14);
            near(get(&mut still, "nu"), 420e3 / pulled, 1e-13);
            // Back to the land: the other side pulls.
            set(&mut still, "v_t", -3.0);
            set(&mut still, "a_t", -0.6);
            let back = -against + borne * Calc::sin(0.01) - 68e3 * 0.6;
            near(get(&mut still, "F_r"), back, 1e-12 * borne);
            near(get(&mut still, "T_1"), 60e3, 0.0);
            near(get(&mut still, "T_2"), 60e3 - back / 2.0, 1e-12 * borne);
        } else {
            let grip = 0.14 * 2.0 / 4.0 * borne * cos(0.01);
            near(get(&mut still, "F_ad"), grip, 1e-12 * borne);
            near(get(&mut still, "k_ad"), grip / asked, 1e-14);
            near(get(&mut still, "a_ad"), (grip - against) / 68e3, 1e-13);
        }
    }
}

/// A stop by hand: 68 t at 3 m/s, wind from behind, level and down a slope; the work of the brakes is the energy and what drives on.
#[test]
fn brakes_by_hand() {
    for kind in ["rope", "semi_rope", "machinery"] {
        let mut still = model(&still(kind));
        for slope in [0.0, 0.01, -0.01] {
            set(&mut still, "gamma_b", slope);
            let passed = match kind {
                "machinery" => 0.0,
                _ => 54e3 * G * (1.0 - 0.98_f64 * 0.98),
            };
            let drives = 250.0 * 45.0 + 68e3 * G * Calc::sin(slope).abs() - 0.008 * 68e3 * G * cos(slope) - passed;
            let asked = drives + 68e3 * 0.6;
            near(get(&mut still, "F_bn"), asked, 1e-9);
            near(get(&mut still, "nu_br"), 90e3 / asked, 1e-13);
            let way = get(&mut still, "s_br");
            near((90e3 - drives) * way, 0.5 * 68e3 * 9.0, 1e-6);
            near(get(&mut still, "t_br") * 3.0, 2.0 * way, 1e-13);
            near(get(&mut still, "a_br") * way, 4.5, 1e-13);
            if kind != "rope" {
                near(
                    get(&mut still, "k_br"),
                    0.14 * 0.5 * 68e3 * G * cos(slope) / 90e3,
                    1e-13,
                );
            }
        }
        set(&mut still, "F_br", 100.0);
        set(&mut still, "p_w", 2000.0);
        let at = index(&still, "s_br");
        let fault = still.get(at).expect_err("it goes on");
        assert!(
            fault.message.starts_with("F_br = 0.1 kN does not stop"),
            "{}",
            fault.message
        );
    }
}

/// The least height of the eccentric centre of gravity, searched along the loop as it stands: its list is that of the first order but
/// for a part of the order of the square. Parallel ropes keep the spreader level and bear by moments alone.
#[test]
fn the_list_by_the_least_height() {
    let mut still = model(&still("rope"));
    for e_x in [0.03, -0.03, 0.3] {
        set(&mut still, "e_x", e_x);
        let height = |turn: f64| {
            let [high, _] = posed(18.0, 2.4, 1.1, 2.0, turn);
            high + e_x * Calc::sin(turn)
        };
        let (mut low, mut high) = (-0.3, 0.3);
        for _ in 0..200 {
            let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if height(a) < height(b) { high = b } else { low = a }
        }
        let found = get(&mut still, "beta_l");
        near(
            found / -f64::midpoint(low, high),
            1.0,
            20.0 * found * found + 2e-6 / found.abs(),
        );
        // Both sides together bear the weight, to the same order.
        let [sea, land] = ["S_r1", "S_r2"].map(|name| get(&mut still, name));
        let cosine = get(&mut still, "h_r") / 18.0;
        near(
            2.0 * (sea + land) * cosine / (54e3 * G),
            1.0,
            2.0 * (found * e_x).abs() * 2.4 / (1.1 * 17.9),
        );
        assert!((sea > land) == (e_x > 0.0));
    }
    set(&mut still, "a_u", 2.4);
    near(get(&mut still, "beta_l"), 0.0, 0.0);
    near(
        get(&mut still, "S_r1"),
        54e3 * G * (2.4 + 0.3) / (4.0 * 2.4),
        1e-9 * 54e3,
    );
}

/// A parabola is what hangs: the exact catenary of the same weight, span and horizontal tension sags as much to a thousandth.
#[test]
fn the_parabola_against_the_catenary() {
    let mut still = model(&still("rope"));
    set(&mut still, "x_t", 0.0);
    let tension = get(&mut still, "T_2");
    // The hyperbolic cosine by its series.
    let half = (21.0 * 46.0 / (2.0 * tension)).powi(2);
    let catenary = tension / 21.0 * half * (0.5 + half / 24.0 + half * half / 720.0);
    near(get(&mut still, "f_2") / catenary, 1.0, 1e-3);
}

/// A way that is too short for its speed, and one that is just long enough.
#[test]
fn times_of_the_way() {
    let mut still = model(&still("rope"));
    near(get(&mut still, "t_tr"), 20.0, 1e-14);
    near(get(&mut still, "t_cyc"), 110.0, 1e-13);
    for way in [15.0, 3.75] {
        set(&mut still, "s_c", way);
        near(get(&mut still, "t_tr"), 2.0 * (way / 0.6_f64).sqrt(), 1e-14);
    }
}

/// Speed that every start comes to, and that none leaves sway where it has the period of the load, long, short or to the limit.
#[test]
fn starts_come_to_their_speed_and_leave_nothing() {
    for (v_c, a_c, period) in [(3.0, 0.6, 6.85), (1.0, 0.6, 6.85), (4.0, 0.2, 9.0), (1.37, 0.6, 6.85)] {
        let told = [v_c, a_c];
        let omega = TAU / period;
        for start in Start::ALL {
            let course = start.course(told, period);
            let [rate, lasts] = start.timed(told, period);
            near(course.end(), lasts, 1e-12);
            let speed: f64 = course
                .rows
                .windows(2)
                .map(|pair| pair[0][1] * (pair[1][0] - pair[0][0]))
                .sum();
            near(speed, v_c, 1e-12);
            near(start.left(told, omega, period), 0.0, 1e-14 * lasts / period * 10.0);
            // Greatest sway: the linear oscillator step by step, by its exact solution.
            let (mut sway, mut velocity, mut most) = (0.0_f64, 0.0_f64, 0.0_f64);
            for pair in course.rows.windows(2) {
                let ([from, now], pieces) = (pair[0], 2000);
                let (sin, cos) = Calc::sin_cos(omega * (pair[1][0] - from) / f64::from(pieces));
                for _ in 0..pieces {
                    let away = sway + now / G;
                    (sway, velocity) = (away * cos + velocity * sin - now / G, velocity * cos - away * sin);
                    most = most.max(sway.abs());
                }
            }
            near(sway.abs().max(velocity.abs()), 0.0, 1e-9);
            near(most * G / rate, start.greatest(told, omega, period), 1e-5);
        }
    }
}

/// Around its own period three pulses leave what the square of the error says, two pulses what the error says.
#[test]
fn three_pulses_are_flat_at_their_period() {
    let (told, period) = ([3.0, 0.6], 6.85);
    let left = |start: Start, part: f64| start.left(told, part * TAU / period, period);
    for error in [1e-2, 1e-3, 1e-4] {
        for sign in [-1.0, 1.0] {
            let lean = 0.5 * PI * error;
            let plain = 2.0 * Calc::sin(PI * (1.0 + sign * error) * 5.0 / period).abs();
            near(
                left(Start::TwoPulses, 1.0 + sign * error) / (plain * lean),
                1.0,
                lean * lean,
            );
            near(
                left(Start::Robust, 1.0 + sign * error) / (plain * lean * lean),
                1.0,
                lean * lean,
            );
        }
    }
}

/// Feedback damps small sway as the linear oscillator does, by its exact solution, and gives back the speed that it took.
#[test]
fn feedback_damps_small_sway() {
    for zeta in [0.1, 0.3, 0.7] {
        let text = free("0.01 deg").replace("[trolley.tow]", &format!("zeta_f = \"{zeta}\"\n[trolley.tow]"));
        let mut fed = model(&text);
        let omega = get(&mut fed, "omega_e");
        let damping = zeta * get(&mut fed, "nu_x");
        let slower = omega * (1.0_f64 - damping * damping).sqrt();
        near(get(&mut fed, "T_f"), TAU / slower, 1e-13);
        near(get(&mut fed, "delta_f"), damping * omega, 1e-15);
        let begun = 0.01_f64.to_radians();
        fed.start().expect("it begins");
        // The exponential function by the squares of its series.
        let falls = |x: f64| {
            let small = x / 1024.0;
            (1.0 + small * (1.0 + small / 2.0 * (1.0 + small / 3.0 * (1.0 + small / 4.0)))).powi(1024)
        };
        for i in 0..20 {
            let at = |i: u32| 0.5 * f64::from(i);
            fed.advance(at(i), at(i + 1)).expect("it goes on");
            let (sin, cos) = Calc::sin_cos(slower * at(i + 1));
            let wanted = begun * falls(-damping * omega * at(i + 1)) * (cos + damping * omega / slower * sin);
            near(get(&mut fed, "phi_R"), wanted, 1e-6 * begun);
            // Its speed is what it follows the load by.
            let gain = 2.0 * zeta * (G * get(&mut fed, "l_e")).sqrt();
            near(
                get(&mut fed, "v_t"),
                gain * (get(&mut fed, "phi_R") - begun),
                1e-7 * begun,
            );
        }
    }
}

/// The period of a great sway by the arithmetic-geometric mean, and the energy of the pendulum.
#[test]
fn great_sway_takes_the_elliptic_integral() {
    let mut free = model(&free("40 deg"));
    let length = get(&mut free, "l_e");
    let (mut a, mut b) = (1.0_f64, cos(20.0 * PI / 180.0));
    for _ in 0..8 {
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
    }
    let period = TAU * (length / G).sqrt() / a;
    let energy = |free: &mut lemnis_models::component::model::Model| {
        0.5 * length * get(free, "omega_R").powi(2) - G * cos(get(free, "phi_R"))
    };
    free.start().expect("it begins");
    let begun = energy(&mut free);
    let steps = 40;
    for i in 0..steps {
        let at = |i: u32| period * f64::from(i) / f64::from(steps);
        free.advance(at(i), at(i + 1)).expect("it goes on");
        near(energy(&mut free), begun, 1e-7);
    }
    near(get(&mut free, "phi_R"), 40.0 * PI / 180.0, 1e-7);
    near(get(&mut free, "omega_R"), 0.0, 1e-6);
    // Force along the ropes at rest at that angle.
    near(get(&mut free, "S_R"), 54e3 * G * cos(40.0 * PI / 180.0), 1.0);
}

/// On parallel ropes, which no part of the acceleration is lost on: the drive's force, less what is against it, over the time is the
/// momentum of trolley and load.
#[test]
fn the_drive_gives_the_momentum() {
    let text = free("0 deg").replace("a_u = \"1.1 m\"", "a_u = \"2.4 m\"");
    let mut moving = model(&text);
    set(&mut moving, "a_t", 0.5);
    moving.start().expect("it begins");
    let steps = 4000;
    let (mut given, mut before) = (0.0, f64::NAN);
    for i in 0..=steps {
        let at = |i: u32| 5.0 * f64::from(i) / f64::from(steps);
        if i > 0 {
            moving.advance(at(i - 1), at(i)).expect("it goes on");
        }
        let against: f64 = ["F_mu", "F_w", "F_s"].map(|name| get(&mut moving, name)).iter().sum();
        let now = get(&mut moving, "F_dr") - against;
        if i > 0 {
            given += f64::midpoint(before, now) * 5.0 / f64::from(steps);
        }
        before = now;
    }
    let [speed, sway, rate] = ["v_t", "phi_R", "omega_R"].map(|name| get(&mut moving, name));
    near(speed, 2.5, 1e-12);
    let momentum = 68e3 * speed + 54e3 * 18.0 * rate * cos(sway);
    near(given / momentum, 1.0, 1e-6);
}

/// What the ready scene's shaped commands leave, and where the trolley is then.
#[test]
fn the_ready_scene_leaves_little_sway() {
    let mut moving = model(&READY.replace("zeta_f  = \"0.2\"\n", ""));
    moving.start().expect("it begins");
    moving.advance(0.0, 26.0).expect("it goes on");
    near(get(&mut moving, "x_t"), 33.0, 1e-9);
    near(get(&mut moving, "v_t"), 0.0, 1e-9);
    let rate = get(&mut moving, "omega_R") / get(&mut moving, "omega_e");
    let left = (get(&mut moving, "phi_R").powi(2) + rate.powi(2)).sqrt();
    assert!(left < 0.05_f64.to_radians(), "{left}");
    moving.advance(26.0, 33.0).expect("it goes on");
    near(get(&mut moving, "l_R"), 23.0, 1e-9);
}

/// A trolley beyond the sheaves of its tow rope, and ropes that do not reach, are told.
#[test]
fn what_cannot_be_is_told() {
    let mut still = model(&still("rope"));
    set(&mut still, "x_t", 52.0);
    let at = index(&still, "T_1");
    let fault = still.get(at).expect_err("beyond");
    assert!(
        fault.message.starts_with("x_t = 52 m is not between"),
        "{}",
        fault.message
    );
    set(&mut still, "x_t", 0.0);
    set(&mut still, "l_R", 1.29);
    let at = index(&still, "omega_e");
    let fault = still.get(at).expect_err("too short");
    assert!(
        fault.message.starts_with("l_R = 1.29 m does not reach"),
        "{}",
        fault.message
    );
}

/// The book's own checks are passed in every kind, and each tells what it has.
#[test]
fn the_book_of_every_kind() {
    for kind in ["rope", "semi_rope", "machinery"] {
        let read = Scene::parse(&still(kind)).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
        assert_eq!(read.levels(), ["static"]);
        let sheet = read.sheet();
        assert_eq!(sheet.identities.len(), 2);
        for check in &sheet.identities {
            assert!(check.passed(), "{} by {}", check.id, check.value);
        }
        let told = |id: &str| sheet.sections().any(|section| section.id == id);
        assert_eq!(
            [told("bridge_tow"), told("bridge_wheels")],
            [kind == "rope", kind != "rope"]
        );
    }
    let read = Scene::parse(READY).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    assert_eq!(read.levels(), ["static", "swing"]);
}
