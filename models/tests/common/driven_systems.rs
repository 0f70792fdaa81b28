//! Luffing systems without a drive, and what drives each of them.

#![allow(dead_code, reason = "each test asks what it needs")]

use lemnis_models::component::model::Model;
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
