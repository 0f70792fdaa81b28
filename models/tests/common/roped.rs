//! A boom on a luffing rope, its quantities worked out by hand.

#![allow(dead_code, reason = "each test asks what it needs")]

use lemnis_models::balance::boom::Plain;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::dynamics::Dynamics;
use lemnis_models::luffing::rope::moving::{BoomInertia, Roped, RopedParts};
use lemnis_models::luffing::rope::position::{BoomChoice, Compensation, Rig};
use lemnis_models::parts::hoist::{Elastic, Hoist, Winch};
use lemnis_models::parts::plane::{Point, length};
use lemnis_models::scene::Scene;

use super::single_boom::{self, G};

const SINGLE: &str = include_str!("../../scenes/rope_luffing.toml");
pub const RIG: Rig<f64> = Rig {
    l: 33.0,
    f_a: 0.4,
    x_8: 2.0,
    e_x: -4.5,
    e_y: 13.0,
    s_k: 30.0,
    chi_k: 0.03,
    m_l: 8.0,
    eta_l: 1.0,
    b_x: -2.0,
    b_y: 12.0,
    m_h: 2.0,
    eta_h: 1.0,
    h_q: 12.0,
};
pub const BOOM: f64 = 9e3;
pub const CENTRE: Point<f64> = Point::new(15.0, 0.3);
pub const OWN: f64 = 9e5;
pub const LOAD: f64 = 10e3;
pub const ROPE: f64 = 12.0;

/// One rope to the sheave, or a compensation of three parts.
pub const PARTS: [Option<Compensation<f64>>; 2] = [None, Some(Compensation { m_k: 3.0, eta_k: 1.0 })];

/// The load on its rope, or straight below the head.
pub fn crane(parts: Option<Compensation<f64>>, hoist: Option<Hoist>) -> Dynamics {
    let scene = Scene::parse(SINGLE).expect("sound");
    let range = *scene.mechanism.motion();
    let weights = Plain {
        g_b: BOOM * G,
        r_b: length(CENTRE),
        chi_b: f64::direction(CENTRE.x, CENTRE.y),
    };
    let inertia = BoomInertia { j_b: OWN };
    let own = RopedParts::new(&RIG, &parts, &weights, &inertia, &BoomChoice { range });
    single_boom::crane::<Roped>(&own, [LOAD, ROPE], hoist)
}

/// The boom alone: its inertia about the foot and the moment of its weight.
pub fn boom(phi: f64) -> [f64; 2] {
    let (sin, cos) = Calc::sin_cos(phi);
    let square = CENTRE.x * CENTRE.x + CENTRE.y * CENTRE.y;
    [OWN + BOOM * square, BOOM * G * (CENTRE.x * cos - CENTRE.y * sin)]
}

/// Head by polar coordinates, with two derivatives; and what the sheave takes: n |A B| by the law of cosines.
pub fn head(phi: f64, parts: Option<Compensation<f64>>) -> ([[f64; 2]; 3], [f64; 3]) {
    let (radius, ahead) = (length(Point::new(RIG.l, RIG.f_a)), f64::direction(RIG.l, RIG.f_a));
    let (sin, cos) = Calc::sin_cos(phi + ahead);
    let places = [
        [radius * cos, radius * sin],
        [-radius * sin, radius * cos],
        [-radius * cos, -radius * sin],
    ];
    let (far, sheave) = (length(Point::new(RIG.b_x, RIG.b_y)), f64::direction(RIG.b_x, RIG.b_y));
    let (sin, cos) = Calc::sin_cos(phi + ahead - sheave);
    let between = (radius * radius + far * far - 2.0 * radius * far * cos).sqrt();
    let first = radius * far * sin / between;
    let second = (radius * far * cos - first * first) / between;
    let part = parts.map_or(1.0, |parts| parts.m_k) / RIG.m_h;
    (places, [between, first, second].map(|x| part * x))
}

/// Every hoist whose speed is commanded, and a load below the head.
pub fn hoists() -> [Option<Hoist>; 4] {
    let give = Elastic {
        stiffness: 4e6,
        damping: 0.0,
    };
    let ramp = Hoist {
        winch: Winch::Ramp(0.3),
        rope: None,
    };
    let elastic = Hoist {
        rope: Some(give),
        ..Hoist::AT_ONCE
    };
    [None, Some(Hoist::AT_ONCE), Some(ramp), Some(elastic)]
}
