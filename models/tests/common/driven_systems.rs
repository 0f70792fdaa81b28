//! Luffing systems without a drive, and what drives each of them.

#![allow(dead_code, reason = "each test asks what it needs")]

use std::f64::consts::TAU;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::scene::Scene;

const DOUBLE_LINK: &str = include_str!("../../scenes/portal_004_new.toml");
const ELLIPSOGRAPH: &str = include_str!("../../scenes/ellipsograph.toml");
const CURVED_TRUNK: &str = include_str!("../../scenes/curved_trunk.toml");

/// A scene without a drive, how its driving link turns while its coordinate does, the coordinate's rate, and its working range
/// (deg); anchors of a drive that works over it: E, s_d (m); crank and rod (m).
#[derive(Clone, Copy)]
pub struct System {
    pub scene: &'static str,
    pub sense: f64,
    pub rate: &'static str,
    pub range: [f64; 2],
    pub e: [f64; 2],
    pub s_d: f64,
    pub bars: [f64; 2],
}

pub const SYSTEMS: [System; 3] = [
    System {
        scene: DOUBLE_LINK,
        sense: 1.0,
        rate: "omega_1",
        range: [44.0, 82.0],
        e: [-3.7, 8.2],
        s_d: 6.0,
        bars: [2.1, 7.0],
    },
    System {
        scene: ELLIPSOGRAPH,
        sense: -1.0,
        rate: "omega",
        range: [25.0, 72.0],
        e: [-2.0, -6.0],
        s_d: 5.0,
        bars: [2.3, 5.7],
    },
    System {
        scene: CURVED_TRUNK,
        sense: 1.0,
        rate: "omega",
        range: [42.0, 80.0],
        e: [-3.7, 8.2],
        s_d: 5.5,
        bars: [2.1, 7.2],
    },
];

pub const KINDS: [&str; 6] = ["cylinder", "rack", "screw", "sector", "crank", "rope"];

impl System {
    pub fn bare(&self) -> String {
        let at = self.scene.find("[luffing.drive]");
        match at {
            None => self.scene.to_owned(),
            Some(at) => self.scene[..at].to_owned(),
        }
    }

    /// The scene with a drive and its own keys.
    pub fn with(&self, kind: &str, own: &str) -> String {
        let drive = format!("[luffing.drive]\nkind = \"{kind}\"\n{own}\n");
        let bare = self.bare();
        let at = bare.find("[luffing.balance]").expect("there");
        format!("{}{drive}\n{}", &bare[..at], &bare[at..])
    }

    pub fn anchors(&self) -> String {
        let [x, y] = self.e;
        format!(
            "E_x = \"{x} m\"\nE_y = \"{y} m\"\ns_d = \"{} m\"\nchi_d = \"0 deg\"\n",
            self.s_d
        )
    }

    pub fn driven(&self, kind: &str) -> String {
        let [r_cr, l_cr] = self.bars;
        let own = match kind {
            "cylinder" => self.anchors() + "D_c = \"320 mm\"\nd_r = \"220 mm\"",
            "rack" => self.anchors() + "r_z = \"150 mm\"\neta_d = \"0.9\"",
            "screw" => self.anchors() + "d_2 = \"112 mm\"\np_h = \"14 mm\"\nmu_d = \"0.12\"\nbeta_d = \"15 deg\"",
            "rope" => self.anchors() + "m_r = \"6\"\nr_tr = \"350 mm\"\neta_d = \"0.9\"",
            "sector" => "r_s = \"4 m\"\ndelta_s = \"100 deg\"\nr_z = \"150 mm\"\neta_d = \"0.95\"".to_owned(),
            _ => {
                self.anchors()
                    + &format!("r_cr = \"{r_cr} m\"\nl_cr = \"{l_cr} m\"\nbranch = \"left\"\neta_d = \"0.95\"")
            }
        };
        self.with(kind, &own)
    }
}

pub fn model(text: &str) -> Model {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}\n{text}"));
    scene.model().expect("exists")
}

pub fn index(model: &Model, name: &str) -> usize {
    let found = model.variables().iter().position(|variable| variable.name() == name);
    found.unwrap_or_else(|| panic!("no {name}"))
}

pub fn close(found: f64, expected: f64, part: f64) -> bool {
    (found - expected).abs() <= part * expected.abs()
}

/// Of the motor's shaft: inertia (kg·m²), and travel of the tackle in one turn (m).
pub const SHAFT: [f64; 2] = [0.7, 0.012];
pub const MOTOR: &str = "[cases]\n[[cases.case]]\nname = \"I\"\nk_Q = \"1\"\nalpha_s = \"0 deg\"\nv_s = \"-50 mm/s\"\n[cases.motor]\nP_N = \"450 kW\"\n\
     n_N = \"970 1/min\"\nlambda_M = \"2.5\"\nk_a = \"1.7\"\nJ_M = \"0.7 kg.m2\"\nl_M = \"12 mm\"\neta_M = \"0.85\"\n\
     heating = \"I\"\n";

/// Bodies of a mechanism.
pub fn bodies(system: &System) -> &'static [&'static str] {
    match system.rate {
        "omega_1" => &["boom", "jib", "rocker"],
        _ if system.sense < 0.0 => &["boom", "link"],
        _ => &["boom", "trunk"],
    }
}

/// With anchors from which a rope pulls all over the working range, without a balance: the weights let the boom of the
/// ellipsograph down where its angle grows.
pub fn systems() -> [System; 3] {
    SYSTEMS.map(|system| match system.sense < 0.0 {
        true => System {
            e: [8.0, 2.0],
            ..system
        },
        false => system,
    })
}

pub fn inertias(system: &System) -> &'static str {
    match system.rate {
        "omega_1" => "J_1 = \"951600 kg.m2\"\nJ_2 = \"201200 kg.m2\"\nJ_3 = \"114500 kg.m2\"",
        _ if system.sense < 0.0 => "J_b = \"900000 kg.m2\"\nJ_l = \"90000 kg.m2\"",
        _ => "J_b = \"500000 kg.m2\"\nJ_t = \"180000 kg.m2\"",
    }
}

/// Without a balance on a rope: at a level, on a motor's shaft or on none.
pub fn hung(system: &System, level: &str, motor: &str) -> String {
    let text = system.driven("rope");
    let balance = text.find("[luffing.balance]").expect("there");
    let rope = if level == "swing" { "l_R = \"15 m\"\n" } else { "" };
    let dynamics = match level {
        "static" => String::new(),
        _ => format!("[luffing.dynamics]\n{}\nstep = \"2 ms\"\n{rope}", inertias(system)),
    };
    let body = |name: &&str| format!("[[cases.body]]\non = \"{name}\"\nJ_s = \"0 kg.m2\"\n");
    let bodies: String = bodies(system).iter().filter(|_| !motor.is_empty()).map(body).collect();
    let text = format!("{}{dynamics}\n{motor}{bodies}", &text[..balance]);
    text.replacen("[luffing]\n", &format!("[luffing]\nfidelity = \"{level}\"\n"), 1)
}

pub fn get<const N: usize>(model: &mut Model, names: [&str; N]) -> [f64; N] {
    names.map(|name| {
        let index = index(model, name);
        model.get(index).unwrap_or_else(|fault| panic!("{name}: {fault:?}"))
    })
}

pub fn put(model: &mut Model, values: &[(&str, f64)]) {
    for (name, value) in values {
        let index = index(model, name);
        model.set(index, *value).expect("allowed");
    }
}

/// The shaft's turn for one radian of the coordinate, and its change: L² is linear in the link's direction.
pub fn turning(system: &System, at: f64) -> [f64; 2] {
    let (sin, cos) = Calc::sin_cos(system.sense * at);
    let ([x, y], s) = (system.e, system.s_d);
    let long = (s * s + x * x + y * y - 2.0 * s * (x * cos + y * sin)).sqrt();
    let half = system.sense * s * (x * sin - y * cos);
    let first = half / long;
    let second = (s * (x * cos + y * sin) - first * first) / long;
    [first, second].map(|travel| travel * TAU / SHAFT[1])
}
