//! A hoist rope led over sheaves, on the double link and on the boom with a curved trunk [Ports001, 5.9.2.4]: along the tie, by
//! hand, against the equilibrium of all bodies solved as it stands, against differences of the rope's length, in a load case, by
//! oil and with a motor on the hoist's drum.

#[path = "common/named.rs"]
mod named;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::parts::plane::{self, Point};
use lemnis_models::scene::Scene;
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

use named::{get, index, model, near, set};

const CRANE: &str = include_str!("../scenes/lemniscate.toml");
const TRUNK: &str = include_str!("../scenes/curved_trunk.toml");
const READY: &str = include_str!("../scenes/led_rope.toml");
const ROPED: &str = include_str!("../scenes/rope_slewing.toml");
const CASES: &str = include_str!("../scenes/portal_004_drive.toml");

/// A sheave's bar and its place there, in m.
type Sheave = (&'static str, [f64; 2]);

/// A scene with a rope of so many falls over sheaves.
fn led(scene: &str, falls: f64, sheaves: &[Sheave]) -> String {
    let each = sheaves
        .iter()
        .map(|(on, [x, y])| format!("[[luffing.rope.sheave]]\non = \"{on}\"\nx_r = \"{x:e} m\"\ny_r = \"{y:e} m\"\n"));
    let rope = format!("[luffing.rope]\nm_h = \"{falls:e}\"\nh_Q = \"6 m\"\n");
    // What is published of the crane is of the crane without it.
    let scene = scene.split("[luffing.published]").next().expect("a scene");
    format!("{scene}\n{rope}{}", each.collect::<String>())
}

/// A scene without one of its tables.
fn without(scene: &str, table: &str) -> String {
    let (before, behind) = scene.split_once(table).expect("it has the table");
    format!("{before}{}", behind.find("\n[").map_or("", |end| &behind[end..]))
}

/// A model, and its working range.
fn over(text: &str) -> (Model, [f64; 2]) {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
    let range = scene.mechanism.motion();
    (scene.model().expect("built"), [range.from, range.to])
}

fn stand(model: &mut Model, theta: f64) {
    model.set(0, theta).expect("an angle of the range");
}

fn point(model: &mut Model, name: &str) -> [f64; 2] {
    [".x", ".y"].map(|end| get(model, &format!("{name}{end}")))
}

fn less([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a - c, b - d]
}

fn length([x, y]: [f64; 2]) -> f64 {
    plane::length(Point::new(x, y))
}

/// A bar of a test: its foot, the point that its line goes to, the forces on it, each with where it acts.
struct Bar {
    foot: [f64; 2],
    to: [f64; 2],
    loads: Vec<([f64; 2], [f64; 2])>,
}

impl Bar {
    fn new(foot: [f64; 2], to: [f64; 2]) -> Bar {
        Bar {
            foot,
            to,
            loads: Vec::new(),
        }
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let line = less(self.to, self.foot);
        let [cos, sin] = line.map(|part| part / length(line));
        [self.foot[0] + x * cos - y * sin, self.foot[1] + x * sin + y * cos]
    }

    fn weight(&mut self, weight: f64, distance: f64, angle: f64) {
        let (sin, cos) = Calc::sin_cos(angle);
        let at = self.place([distance * cos, distance * sin]);
        self.loads.push((at, [0.0, -weight]));
    }

    /// Sum of its loads, and their moment about the origin.
    fn sum(&self) -> [f64; 3] {
        let each = self.loads.iter().map(|([x, y], [f, g])| [*f, *g, x * g - y * f]);
        each.fold([0.0; 3], |sum, one| [0, 1, 2].map(|i| sum[i] + one[i]))
    }
}

/// Both ends of each stretch pull their bars together; the length of all of them.
fn pulled(bars: &mut [Bar], names: &[&str], head: (usize, [f64; 2]), sheaves: &[Sheave], pull: f64) -> f64 {
    let mut all = 0.0;
    let mut from = (Some(head.0), head.1);
    for (on, local) in sheaves {
        let bar = names.iter().position(|name| name == on);
        let place = bar.map_or(*local, |bar| bars[bar].place(*local));
        let line = less(place, from.1);
        let force = line.map(|part| pull * part / length(line));
        for (bar, at, force) in [(from.0, from.1, force), (bar, place, force.map(|part| -part))] {
            if let Some(bar) = bar {
                bars[bar].loads.push((at, force));
            }
        }
        all += length(line);
        from = (bar, place);
    }
    all
}

/// Forces in O1, B, C and O3 and the drive's moment on the bar that it drives, of nine equations; those of B and C on the jib.
fn solved(bars: &[Bar; 3], joints: [[f64; 2]; 4], driven: usize) -> DVector<f64> {
    let mut equations = DMatrix::zeros(9, 9);
    let mut right = DVector::zeros(9);
    // O1 on the boom, B and C on the jib and back, O3 on the rocker.
    let acts = [
        [(0, 1.0), (0, 0.0)],
        [(1, 1.0), (0, -1.0)],
        [(1, 1.0), (2, -1.0)],
        [(2, 1.0), (2, 0.0)],
    ];
    for (joint, (ends, [x, y])) in acts.into_iter().zip(joints).enumerate() {
        for (bar, sign) in ends.into_iter().filter(|(_, sign)| *sign != 0.0) {
            equations[(3 * bar, 2 * joint)] = sign;
            equations[(3 * bar + 1, 2 * joint + 1)] = sign;
            equations[(3 * bar + 2, 2 * joint)] = -sign * y;
            equations[(3 * bar + 2, 2 * joint + 1)] = sign * x;
        }
    }
    equations[(3 * driven + 2, 8)] = 1.0;
    for (bar, at) in bars.iter().zip(0..) {
        for (i, part) in bar.sum().into_iter().enumerate() {
            right[3 * at + i] = -part;
        }
    }
    equations.lu().solve(&right).expect("no dead point")
}

const LINKS: [&str; 3] = ["boom", "jib", "rocker"];

/// Boom, jib and rocker of a model where it stands, with their weights, under a load; and its joints.
fn links(model: &mut Model) -> ([Bar; 3], [[f64; 2]; 4]) {
    let [a, b, c] = ["A", "B", "C"].map(|name| point(model, name));
    let (o1, o3) = ([0.0; 2], [-get(model, "X_5"), get(model, "X_6")]);
    let mut bars = [Bar::new(o1, b), Bar::new(b, c), Bar::new(o3, c)];
    for (bar, i) in bars.iter_mut().zip(1..) {
        let [weight, distance, angle] = ["G", "s", "chi"].map(|name| get(model, &format!("{name}_{i}")));
        bar.weight(weight, distance, angle);
    }
    bars[1].loads.push((a, [0.0, -get(model, "Q")]));
    (bars, [o1, b, c, o3])
}

/// A rope over the jib's tail to the rocker's foot runs along the tie: the load rises with the head, and the tie carries less by
/// the rope's pull; so it does where the sheave at its head is its own.
#[test]
fn along_the_tie() {
    for on in [("jib", [6.5, 0.0]), ("rocker", [14.7, 0.0])] {
        let mut model = model(&led(CRANE, 4.0, &[on, ("frame", [-6.4, 5.3])]));
        let mut plain = named::model(CRANE);
        for step in 0..=60 {
            let theta = f64::from(60 + step).to_radians();
            stand(&mut model, theta);
            stand(&mut plain, theta);
            let mut both = |name: &str| [get(&mut model, name), get(&mut plain, name)];
            let [height, _] = both("A.y");
            for (name, size) in [
                ("M_Q", 3e6),
                ("M_D", 3e6),
                ("F_B.x", 1e6),
                ("F_B.y", 1e6),
                ("F_O1.x", 1e6),
                ("F_O1.y", 1e6),
            ] {
                let [led, own] = both(name);
                near(led, own, 1e-12 * size);
            }
            if on.0 == "jib" {
                let [led, own] = both("N_3");
                near(led, own - 40e3, 1e-12 * 1e6);
            }
            // The frame carries less at the tie's foot, along the tie.
            let (sin, cos) = Calc::sin_cos(both("theta_3")[0]);
            for (name, part) in [("F_O3.x", cos), ("F_O3.y", sin)] {
                let [led, own] = both(name);
                near(led, own + 40e3 * part, 1e-12 * 1e6);
            }
            near(get(&mut model, "S_h"), 40e3, 1e-9);
            near(get(&mut model, "Y_Q"), height - 6.0, 1e-12 * 20.0);
            near(get(&mut model, "L_led"), get(&mut model, "L_led_a"), 1e-12 * 40.0);
        }
        let [error, own] =
            ["Delta_Y_Q", "Delta_Y"].map(|name| summary(&led(CRANE, 4.0, &[on, ("frame", [-6.4, 5.3])]), name));
        near(error, own, 1e-12);
    }
}

fn summary(text: &str, name: &str) -> f64 {
    let sheet = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}")).sheet();
    let found = sheet.summary.iter().find(|summary| summary.symbol.id == name);
    found.unwrap_or_else(|| panic!("no {name}")).value
}

/// At 90° of the boom a rope from A over the boom's head to a sheave on the frame: h_Q is measured at the start.
#[test]
fn by_hand() {
    // B = (0, 19.3), A = (15.721985, 22.269711) of Table 1's crane, |A B| = 16, the jib's front arm, at every angle. Sheave at
    // (-3, 19.3): |B S| = 3; L_r = 19. At 60° B = (9.65, 16.714290), from S 12.65 and -2.585710: 12.911561, L_r = 28.911561,
    // y_A = 21.928378. With m_h = 2: c_Q = -6 - 14.455780 = -20.455780, y_Q = 22.269711 + 9.5 - 20.455780 = 11.313931.
    // dL_r: the boom's head moves by (-19.3, 0) for one radian, along the rope from S, (1, 0): -19.3; y'_Q = y'_A - 9.65.
    let mut model = model(&led(CRANE, 2.0, &[("boom", [19.3, 0.0]), ("frame", [-3.0, 19.3])]));
    stand(&mut model, 90f64.to_radians());
    near(get(&mut model, "l_rs[1]"), 16.0, 1e-12);
    near(get(&mut model, "l_rs[2]"), 3.0, 1e-12);
    near(get(&mut model, "L_led"), 19.0, 1e-12);
    near(get(&mut model, "L_led_a"), 28.911_561, 1e-6);
    near(get(&mut model, "c_Q"), -20.455_780, 1e-6);
    near(get(&mut model, "Y_Q"), 11.313_931, 1e-6);
    // M_Q of Table 1 is 31.8100 kN·m, to its last digit.
    near(get(&mut model, "M_Q"), 31.81e3 - 160e3 * 9.65, 5.0);
    // 80 kN pull the boom's head backward by S and forward along the jib: F_r1 = 80 (15.721985/16 - 1, 2.969711/16).
    near(get(&mut model, "F_r1.x"), 80e3 * (15.721_985 / 16.0 - 1.0), 1.0);
    near(get(&mut model, "F_r1.y"), 80e3 * 2.969_711 / 16.0, 1.0);
    near(get(&mut model, "M_r1"), -80e3 * (15.721_985 / 16.0 - 1.0) * 19.3, 20.0);
    let omega = 1f64.to_radians();
    let rise = get(&mut model, "V_AY") - 9.65 * omega;
    near(get(&mut model, "V_Q"), rise, 1e-12);
}

fn sheaves() -> impl Strategy<Value = Vec<Sheave>> {
    let on = prop_oneof![Just("boom"), Just("jib"), Just("rocker"), Just("frame")];
    let carried = (on, -4.0..14.0, 1.0..4.0).prop_map(|(on, x, y)| (on, [x, y]));
    let last = (-9.0..-3.0, -4.0..9.0).prop_map(|(x, y)| ("frame", [x, y]));
    (prop::collection::vec(carried, 0..5), last).prop_map(|(mut all, last)| {
        all.push(last);
        all
    })
}

/// The crane driven by its rocker, which has the other assembly and a range of its own.
fn by_rocker() -> String {
    let mut scene = without(CRANE, "[luffing.drive]");
    for (before, after) in [
        ("driven = \"boom\"", "driven = \"rocker\""),
        ("branch = \"left\"", "branch = \"right\""),
        ("from  = \"60 deg\"", "from  = \"52 deg\""),
        ("to    = \"120 deg\"", "to    = \"128 deg\""),
    ] {
        assert!(scene.contains(before));
        scene = scene.replace(before, after);
    }
    let (scene, _) = scene.split_once("[luffing.published]").expect("published");
    Scene::parse(scene).unwrap_or_else(|found| panic!("{found:?}"));
    scene.to_owned()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Forces in all pins and the drive's moment by nine equations; the moment of the load by differences of the rope.
    #[test]
    fn bodies_in_equilibrium(sheaves in sheaves(), falls in 1.0..8.0, at in 0.0..1.0, rocker: bool) {
        let crane = if rocker { by_rocker() } else { CRANE.to_owned() };
        let scene = led(&crane, falls, &sheaves);
        let parsed = Scene::parse(&scene);
        // Sheaves that meet on the way are refused.
        prop_assume!(parsed.is_ok());
        let mut model = parsed.expect("looked at").model().expect("built");
        let [from, to]: [f64; 2] = if rocker { [52.0, 128.0] } else { [60.0, 120.0] };
        let theta = f64::to_radians(from + at * (to - from));
        stand(&mut model, theta);
        let (mut bars, joints) = links(&mut model);
        let head = point(&mut model, "A");
        let q = get(&mut model, "Q");
        let whole = pulled(&mut bars, &LINKS, (1, head), &sheaves, q / falls);
        near(get(&mut model, "L_led"), whole, 1e-12 * whole);
        let found = solved(&bars, joints, if rocker { 2 } else { 0 });
        let size = found.iter().fold(q, |most, force| most.max(force.abs()));
        near(get(&mut model, "M_D"), found[8], 1e-11 * size * 20.0);
        for (pin, at) in [("F_O1", 0), ("F_B", 2), ("F_C", 4), ("F_O3", 6)] {
            // The feet carry the drive's force too, which is no mere moment where the boom is driven.
            let drive = match (pin, rocker) {
                ("F_O1", false) => {
                    let (f_d, [e_x, e_y]) = (get(&mut model, "F_d"), ["E_x", "E_y"].map(|name| get(&mut model, name)));
                    let [s_d, chi_d] = ["s_d", "chi_d"].map(|name| get(&mut model, name));
                    let (sin, cos) = Calc::sin_cos(theta + chi_d);
                    let line = less([s_d * cos, s_d * sin], [e_x, e_y]);
                    line.map(|part| f_d * part / length(line))
                }
                _ => [0.0; 2],
            };
            let [x, y] = point(&mut model, pin);
            near(x + drive[0], found[at], 1e-11 * size * 20.0);
            near(y + drive[1], found[at + 1], 1e-11 * size * 20.0);
        }
        let [work, by_pole, weights] = ["M_Q", "M_Q.P", "M_G"].map(|name| get(&mut model, name));
        near(work + weights, found[8], 1e-11 * size * 20.0);
        near(by_pole, work, 1e-9 * size * 20.0);
        // Four places, of the fourth order.
        let step = 1e-3;
        let height = |model: &mut Model, at: f64| {
            stand(model, at);
            get(model, "Y_Q")
        };
        prop_assume!((from.to_radians() + 2.0 * step..to.to_radians() - 2.0 * step).contains(&theta));
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|by: f64| height(&mut model, theta + by * step));
        near(work, q * (a - 8.0 * b + 8.0 * c - d) / (12.0 * step), 1e-8 * size * 20.0);
    }

    /// Boom and trunk: the tie's force, the pins and the drive's moment by six equations.
    #[test]
    fn trunk_in_equilibrium(sheaves in sheaves(), falls in 2.0..8.0, at in 0.0..1.0) {
        let sheaves: Vec<Sheave> = sheaves.into_iter().filter(|(on, _)| *on != "rocker")
            .map(|(on, place)| (if on == "jib" { "trunk" } else { on }, place)).collect();
        let scene = led(&without(TRUNK, "[luffing.balance]"), falls, &sheaves);
        let parsed = Scene::parse(&scene);
        // A rope may let the tie go slack, which is refused.
        prop_assume!(parsed.is_ok());
        let parsed = parsed.expect("looked at");
        let mut model = parsed.model().expect("built");
        let range = *parsed.mechanism.motion();
        let phi = range.from + at * (range.to - range.from);
        stand(&mut model, phi);
        let [a, t] = ["A", "T"].map(|name| point(&mut model, name));
        let b = {
            let (length, (sin, cos)) = (get(&mut model, "b"), Calc::sin_cos(phi));
            [length * cos, length * sin]
        };
        let o3 = ["O3_x", "O3_y"].map(|name| get(&mut model, name));
        let mut bars = [Bar::new([0.0; 2], b), Bar::new(b, a)];
        for (bar, part) in bars.iter_mut().zip(["b", "t"]) {
            let [weight, distance, angle] = ["G", "r", "chi"].map(|name| get(&mut model, &format!("{name}_{part}")));
            bar.weight(weight, distance, angle);
        }
        let q = get(&mut model, "Q");
        bars[1].loads.push((a, [0.0, -q]));
        let whole = pulled(&mut bars, &["boom", "trunk"], (1, a), &sheaves, q / falls);
        near(get(&mut model, "L_led"), whole, 1e-12 * whole);
        let tie = less(o3, t).map(|part| part / length(less(o3, t)));
        // O1 on the boom, B on the trunk, the tie's force, the drive's moment.
        let mut equations = DMatrix::zeros(6, 6);
        let mut right = DVector::zeros(6);
        for (bar, sign) in [(0, -1.0), (1, 1.0)] {
            equations[(3 * bar, 2)] = sign;
            equations[(3 * bar + 1, 3)] = sign;
            equations[(3 * bar + 2, 2)] = -sign * b[1];
            equations[(3 * bar + 2, 3)] = sign * b[0];
        }
        equations[(0, 0)] = 1.0;
        equations[(1, 1)] = 1.0;
        equations[(3, 4)] = tie[0];
        equations[(4, 4)] = tie[1];
        equations[(5, 4)] = t[0] * tie[1] - t[1] * tie[0];
        equations[(2, 5)] = 1.0;
        for (bar, at) in bars.iter().zip(0..) {
            for (i, part) in bar.sum().into_iter().enumerate() {
                right[3 * at + i] = -part;
            }
        }
        let found = equations.lu().solve(&right).expect("a tie with an arm");
        let size = found.iter().fold(q, |most, force| most.max(force.abs()));
        near(get(&mut model, "M_D"), found[5], 1e-11 * size * 20.0);
        near(get(&mut model, "N_t"), found[4], 1e-11 * size);
        let [x, y] = point(&mut model, "F_B");
        near(x, found[2], 1e-11 * size);
        near(y, found[3], 1e-11 * size);
        let [work, by_pole, weights] = ["M_Q", "M_Q.P", "M_G"].map(|name| get(&mut model, name));
        near(work + weights, found[5], 1e-11 * size * 20.0);
        near(by_pole, work, 1e-9 * size * 20.0);
    }
}

/// In a case in which nothing but weight acts, and nothing moves, the pins carry what they carry at rest: with a pin of one
/// square metre its pressure is its force.
#[test]
fn pins_of_a_case() {
    let cases = without(CASES, "[luffing.limits]");
    let (before, behind) = cases.split_once("[[cases.case]]").expect("cases");
    let behind = &behind[behind.find("[[cases.body]]").expect("bodies")..];
    let behind = &behind[..behind.find("[[cases.pin]]").expect("pins")];
    for pin in ["O1", "B", "C", "O3"] {
        let case =
            "[[cases.case]]\nname = \"rest\"\nk_Q = \"1\"\nalpha_s = \"0 deg\"\np_w = \"0 Pa\"\nv_s = \"0 mm/s\"\n";
        let size = format!(
            "[luffing.limits]\np_b_max = \"1000 MPa\"\ntau_p_max = \"1000 MPa\"\n[[cases.pin_size]]\nat = \"{pin}\"\nd_p = \"1000 mm\"\nb_p = \"1000 mm\"\n"
        );
        let scene = format!("{before}{case}{behind}{size}");
        let sheaves = [
            ("jib", [5.0, 1.2]),
            ("boom", [22.0, 1.5]),
            ("rocker", [3.0, 1.0]),
            ("frame", [-3.0, 12.0]),
        ];
        let (mut model, range) = over(&led(&scene, 2.0, &sheaves));
        for part in 0..=10 {
            stand(&mut model, range[0] + (range[1] - range[0]) * f64::from(part) / 10.0);
            let force = length(point(&mut model, &format!("F_{pin}")));
            near(get(&mut model, "p_b[1]"), force, 1e-10 * force.max(1e6));
            let (load, rise) = (get(&mut model, "M_r_load[1]"), get(&mut model, "M_Q"));
            near(load, -rise, 1e-12 * 3e7);
        }
    }
}

/// A tackle of very many falls takes nothing up: the load rises with the head.
#[test]
fn very_many_falls() {
    for (scene, on) in [(CRANE, "jib"), (TRUNK, "trunk")] {
        let (mut model, range) = over(&led(scene, 1e6, &[(on, [2.0, 2.0]), ("frame", [-6.0, 4.0])]));
        for part in 0..=10 {
            stand(&mut model, range[0] + (range[1] - range[0]) * f64::from(part) / 10.0);
            near(get(&mut model, "Y_Q"), get(&mut model, "A.y") - 6.0, 1e-4);
        }
    }
}

/// Every check of the ready scene passes; its load stays three times as level as its head; its load may be anything.
#[test]
fn ready_scene() {
    let sheet = Scene::parse(READY).unwrap_or_else(|found| panic!("{found:?}")).sheet();
    assert!(!sheet.requirements.is_empty() && sheet.identities.len() >= 4);
    for check in sheet.checks() {
        assert!(check.passed(), "{} {}", check.id, check.value);
    }
    assert!(summary(READY, "Delta_Y_Q") * 2.8 < summary(READY, "Delta_Y"));
    let mut model = model(&led(CRANE, 2.0, &[("jib", [6.2, 0.9]), ("frame", [-6.6, 5.4])]));
    set(&mut model, "Q", 0.0);
    stand(&mut model, 1.5);
    assert_eq!(get(&mut model, "S_h"), 0.0);
    assert!(model.set(index(&model, "m_h"), 0.0).is_err());
}

/// At rest, its brake holding the crane, pins and rope carry in motion what they carry at a level that stands still.
#[test]
fn motion_at_rest() {
    let rigid = without(
        &READY.replace("fidelity = \"swing\"", "fidelity = \"rigid\""),
        "[luffing.hoisting]",
    );
    let still = without(&without(READY, "[luffing.dynamics]"), "[luffing.hoisting]");
    let mut still = model(&still.replace("fidelity = \"swing\"", "fidelity = \"static\""));
    for moving in [READY, &rigid] {
        let mut moving = model(moving);
        for theta in [60.0_f64, 75.0, 90.0, 104.0, 120.0] {
            let theta = theta.to_radians();
            stand(&mut still, theta);
            set(&mut moving, "theta_1", theta);
            moving.update().expect("it stands there");
            for name in [
                "S_h", "F_r2.x", "F_r2.y", "F_B.x", "F_B.y", "F_C.x", "F_C.y", "F_O3.x", "F_O3.y", "N_3",
            ] {
                let [found, wanted] = [&mut moving, &mut still].map(|model| get(model, name));
                assert!(wanted != 0.0, "{name}");
                near(found, wanted, 1e-12 * 2e6);
            }
            let [found, wanted] = [&mut moving, &mut still].map(|model| get(model, "M_r2"));
            near(found, wanted, 1e-12 * 2e7);
        }
    }
}

const OIL: &str = r#"[luffing.hydraulics]
l_min = "3.5 m"
l_max = "10 m"
V_0 = "2 L"
V_1 = "0.5 L"
Q_N = "400 L/min"
dp_N = "35 bar"
dp_L = "3 bar"
beta_E = "1400 MPa"
p_R = "330 bar"
k_R = "1e-9 m3/(s.Pa)"
k_L = "1e-13 m3/(s.Pa)"
omega_v = "100 rad/s"
zeta_v = "0.8"
p_P = "250 bar"
"#;

/// At a level that moves, without dry friction, and what else.
fn moved(level: &str, changes: &[(&str, &str)]) -> Model {
    let mut scene = READY.replace("fidelity = \"swing\"", &format!("fidelity = \"{level}\""));
    for (before, after) in changes.iter().chain(&[("M_F = \"10 kN.m\"", "M_F = \"0 kN.m\"")]) {
        assert!(scene.contains(before), "{before}");
        scene = scene.replace(before, after);
    }
    model(&scene)
}

/// A crane that oil luffs begins with the force that holds it at rest, and moves as one under the moment of its cylinder, with the rope
/// taken in and paid out as it luffs.
#[test]
fn by_oil() {
    let still = without(&without(READY, "[luffing.dynamics]"), "[luffing.hoisting]");
    let mut still = model(&still.replace("fidelity = \"swing\"", "fidelity = \"static\""));
    let oil = format!("{OIL}\n[luffing.limits]");
    let mut oil = moved("hydraulic", &[("M_S = \"3000 kN.m\"", ""), ("[luffing.limits]", &oil)]);
    oil.start().expect("it stands");
    stand(&mut still, 60_f64.to_radians());
    let [found, wanted] = [get(&mut oil, "F_c"), get(&mut still, "F_d")];
    near(found, wanted, 1e-9 * wanted.abs());
    near(get(&mut oil, "der(omega_1)"), 0.0, 1e-9);
    let mut swing = moved("swing", &[("M_S = \"3000 kN.m\"", "M_S = \"0 kN.m\"")]);
    for (i, theta) in [62.0_f64, 75.0, 90.0, 104.0, 118.0].into_iter().enumerate() {
        let theta = theta.to_radians();
        stand(&mut still, theta);
        let omega = 0.02 * (1.0 + i as f64);
        for model in [&mut oil, &mut swing] {
            for (name, value) in [
                ("theta_1", theta),
                ("omega_1", omega),
                ("phi_R", 0.1),
                ("omega_R", -0.03),
                ("l_R", 9.0),
            ] {
                set(model, name, value);
            }
            model.update().expect("it moves there");
        }
        let moment = get(&mut oil, "F_c") * get(&mut still, "h_d");
        set(&mut swing, "M_A", moment);
        swing.update().expect("it moves there");
        for name in ["der(omega_1)", "der(omega_R)", "S_R", "der(l_R)"] {
            let [found, wanted] = [get(&mut oil, name), get(&mut swing, name)];
            assert!(wanted.abs() > 1e-3, "{name} {wanted}");
            near(found, wanted, 1e-12 * wanted.abs().max(1.0));
        }
    }
}

/// The same of one that slews on a slope, whose load does not hang plumb at the start: its cylinder holds what the rope pulls by the
/// head and by its sheaves.
#[test]
fn by_oil_on_a_slope() {
    let still = without(&without(READY, "[luffing.dynamics]"), "[luffing.hoisting]");
    let mut still = model(&still.replace("fidelity = \"swing\"", "fidelity = \"static\""));
    let slewing = "[slewing]\nJ_sl = \"1500 t.m2\"\npsi_sl = \"25 deg\"\nM_Bsl = \"90 MN.m\"\n[slewing.slope]\ngamma_s = \"2 deg\"\n\
        G_u = \"900 kN\"\nr_u = \"-1.5 m\"\n";
    let [oil, beside] = [OIL, ""].map(|oil| format!("{oil}\n{slewing}\n[luffing.limits]"));
    let mut oil = moved("hydraulic", &[("M_S = \"3000 kN.m\"", ""), ("[luffing.limits]", &oil)]);
    let brake = ("M_S = \"3000 kN.m\"", "M_S = \"0 kN.m\"");
    let mut swing = moved("swing", &[brake, ("[luffing.limits]", &beside)]);
    oil.start().expect("it stands");
    near(get(&mut oil, "der(omega_1)"), 0.0, 1e-9);
    for model in [&mut oil, &mut swing] {
        set(model, "M_Bsl", 0.0);
    }
    for (i, theta) in [62.0_f64, 75.0, 90.0, 104.0, 118.0].into_iter().enumerate() {
        let (theta, omega) = (theta.to_radians(), 0.02 * (1.0 + i as f64));
        stand(&mut still, theta);
        for model in [&mut oil, &mut swing] {
            for (name, value) in [
                ("theta_1", theta),
                ("omega_1", omega),
                ("psi_sl", 0.6),
                ("omega_sl", -0.04),
                ("l_R", 9.0),
                ("x_Q", 1.0),
                ("y_Q", -8.9),
                ("z_Q", -0.8),
                ("v_Qx", 0.2),
                ("v_Qz", 0.1),
            ] {
                set(model, name, value);
            }
            model.update().expect("it moves there");
        }
        let moment = get(&mut oil, "F_c") * get(&mut still, "h_d");
        set(&mut swing, "M_A", moment);
        swing.update().expect("it moves there");
        for name in [
            "der(omega_1)",
            "der(omega_sl)",
            "der(v_Qx)",
            "der(v_Qz)",
            "S_R",
            "der(l_R)",
            "M_gammal",
        ] {
            let [found, wanted] = [get(&mut oil, name), get(&mut swing, name)];
            assert!(wanted.abs() > 1e-3, "{name} {wanted}");
            near(found, wanted, 1e-12 * wanted.abs().max(1.0));
        }
    }
}

/// A motor on the drum of a rope that luffing draws on: in the plane the crane moves as one that may slew, and is held.
#[test]
fn by_motor() {
    let drum = "J_h = \"900 kg.m2\"\nr_h = \"300 mm\"\nM_Mh = \"17.5 kN.m\"\nM_Fh = \"1 kN.m\"\n";
    let ready = READY.replace("a_h = \"0.5 m/s2\"", drum);
    let roped = ROPED.replace("v_h = \"-0.1 m/s\"      # lifts\na_h = \"0.25 m/s2\"\n", drum);
    let roped = without(&without(&roped, "[luffing.air]"), "[slewing]");
    // No brake holds the boom while it moves.
    let [ready, roped] = [(ready, "3000"), (roped, "6000")].map(|(scene, brake)| {
        let brake = format!("M_S = \"{brake} kN.m\"");
        assert!(scene.contains(&brake), "{brake}");
        scene.replace(&brake, "M_S = \"0 kN.m\"")
    });
    let turns = "[slewing]\nJ_sl = \"1500000 kg.m2\"\nM_Bsl = \"90000 kN.m\"\n";
    for (scene, [angle, rate], at) in [
        (ready, ["theta_1", "omega_1"], 75.0_f64),
        (roped, ["phi", "omega"], 40.0),
    ] {
        let mut plane = model(&scene);
        let mut space = model(&format!("{scene}\n{turns}"));
        for (i, omega) in [0.03, -0.02, 0.01].into_iter().enumerate() {
            let (angle_now, swing, swinging, long, paid) = ((at + 5.0 * i as f64).to_radians(), 0.2, -0.05, 8.0, -0.3);
            let both = [(angle, angle_now), (rate, omega), ("l_R", long), ("v_R", paid)];
            let (sin, cos) = Calc::sin_cos(swing);
            let across = [cos, sin].map(|part| part * long * swinging);
            let seen = [
                ("x_Q", long * sin),
                ("y_Q", -long * cos),
                ("v_Qx", across[0]),
                ("v_Qy", across[1]),
            ];
            for (name, value) in both.into_iter().chain([("phi_R", swing), ("omega_R", swinging)]) {
                set(&mut plane, name, value);
            }
            for (name, value) in both.into_iter().chain(seen) {
                set(&mut space, name, value);
            }
            for model in [&mut plane, &mut space] {
                model.update().expect("it moves there");
            }
            assert_eq!(get(&mut space, "der(omega_sl)"), 0.0);
            let named = format!("der({rate})");
            for name in [named.as_str(), "der(v_R)", "der(l_R)", "S_R", "M_Rh"] {
                let [found, wanted] = [get(&mut plane, name), get(&mut space, name)];
                assert!(wanted.abs() > 1e-3, "{name} {wanted}");
                near(found, wanted, 1e-12 * wanted.abs().max(1.0));
            }
        }
    }
}

/// A scene with its lengths named by where they are wrong.
#[test]
fn refusals() {
    let refused = |text: &str| {
        let found = Scene::parse(text).expect_err("refused");
        found
            .into_iter()
            .map(|mistake| mistake.message)
            .collect::<Vec<_>>()
            .join("; ")
    };
    let swinging = READY.replace("l_R = \"12 m\"", "l_R = \"11 m\"");
    assert_eq!(
        refused(&swinging),
        "h_Q = 12 m where l_R = 11 m: the load hangs at two places"
    );
    let meets = led(
        CRANE,
        2.0,
        &[("boom", [19.3, 0.0]), ("jib", [0.0, 1e-3]), ("frame", [-6.0, 5.0])],
    );
    assert!(
        refused(&meets).starts_with("sheave 2 of the hoist rope comes within"),
        "{}",
        refused(&meets)
    );
    let at_the_head = led(TRUNK, 2.0, &[("trunk", [14.2, 0.0]), ("frame", [-6.0, 5.0])]);
    assert!(
        refused(&at_the_head).starts_with("sheave 1 of the hoist rope comes within 0"),
        "{}",
        refused(&at_the_head)
    );
}

/// A parallelogram moves through its change point, where no finite forces in the pins carry a load: pull and forces of the rope are
/// told there too.
#[test]
fn through_a_change_point() {
    let mut scene = without(&without(READY, "[luffing.drive]"), "[luffing.limits]");
    for (before, after) in [
        ("X_1 = \"19.3 m\"", "X_1 = \"14.7 m\""),
        ("X_5 = \"6.4 m\"", "X_5 = \"6.5 m\""),
        ("X_6 = \"5.3 m\"", "X_6 = \"0 m\""),
        ("from  = \"60 deg\"", "from  = \"-20 deg\""),
        ("to    = \"120 deg\"", "to    = \"20 deg\""),
        ("M_S = \"3000 kN.m\"", "M_S = \"90000 kN.m\""),
    ] {
        assert!(scene.contains(before), "{before}");
        scene = scene.replace(before, after);
    }
    let mut crane = model(&scene);
    set(&mut crane, "theta_1", 0.0);
    crane.update().expect("it stands there");
    near(get(&mut crane, "S_h"), 80e3, 1e-8);
    // B = (14.7, 0), C = (8.2, 0): the sheave at (14.7 - 6.2, -0.9), and 15.1 m behind it and 6.3 m above it the last one.
    let line = [-6.6 - 8.5, 5.4 + 0.9];
    for (name, part) in [("F_r2.x", line[0]), ("F_r2.y", line[1])] {
        near(get(&mut crane, name), 80e3 * part / length(line), 1e-7);
    }
}
