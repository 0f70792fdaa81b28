//! What makes a scene of a grab unloader legal: drums and quantities of its scheme, and in each phase a weight that keeps the
//! ropes of the trolley tight.

use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::unloader::reeving::{SCHEMES, Scheme};
use lemnis_models::unloader::symbols as s;
use toml::Table;

use crate::bodies::{list, row};
use crate::luffing::working_range;
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("F_r", &s::F_R);

fn phases(n: &mut Node, count: usize, most: f64) {
    let speed = n.draw.natural(&s::V_T);
    let rate = n.draw.g;
    list(n, "phases", count, &mut |draw, _| {
        let lasts = draw.scale[2] * draw.between(0.5, 5.0);
        let [hoist, close, travel] = [0; 3].map(|_| speed * draw.pick(&[-1.0, 0.0, 1.0]) * draw.between(0.1, 1.0));
        let close = if travel == 0.0 { close } else { close.abs() };
        let [part, share] = [0, 1].map(|_| draw.between(0.0, 1.0));
        let rate = rate * draw.between(-most, most);
        row(
            draw,
            &[
                (&s::T_P, lasts),
                (&s::V_HP, hoist),
                (&s::V_CP, close),
                (&s::V_TP, travel),
                (&s::A_TP, rate),
                (&s::K_QP, part),
                (&s::LAMBDA_P, share),
            ],
        )
    });
}

fn drums(n: &mut Node, count: usize) {
    let (size, strength) = (n.draw.scale[0], n.draw.natural(&s::W));
    list(n, "drums", count, &mut |draw, _| {
        let (diameter, breaks) = (size * draw.between(0.05, 0.5), strength * draw.between(1.0, 10.0));
        let ropes = f64::from(draw.rng.u32(1..9));
        row(draw, &[(&s::D_D, diameter), (&s::Z_R, ropes), (&s::F_B, breaks)])
    });
}

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::W));
    for name in ["G_g", "Q_n", "G_t"] {
        let own = weight * n.draw.between(0.2, 1.0);
        n.set(name, own);
    }
    // Wheels, sheaves and wind take less than a third of the lightest grab, and the acceleration less than another.
    for (name, low, high) in [
        ("mu_t", 0.0, 0.02),
        ("eta_r", 0.99, 1.0),
        ("lambda_c", 0.0, 1.0),
        ("k_q", 0.0, 1.0),
    ] {
        if n.has(name) {
            let value = n.draw.between(low, high);
            n.set(name, value);
        }
    }
    let sheaves = 1 + i64::from(n.draw.rng.u32(0..4));
    n.put("sheaves", sheaves);
    if n.has("p_w") {
        let pressure = 0.02 * weight / (size * size) * n.draw.rng.f64();
        n.set("p_w", pressure);
    }
    if n.has("A_w") {
        let area = size * size * n.draw.rng.f64();
        n.set("A_w", area);
    }
    if !n.has("eta_r") {
        let eta = n.draw.between(0.99, 1.0);
        n.set("eta_r", eta);
    }
    let place = n.draw.rng.usize(0..SCHEMES.len());
    n.put("scheme", SCHEMES[place]);
    let scheme = Scheme::ALL[place];
    n.remove(&["k", "k_b", "T_0", "G_a", "F_ba", "z_a"]);
    let natural = [("k", 4.0), ("k_b", 1.5), ("T_0", weight), ("G_a", weight)];
    for (name, about) in natural {
        let of_it = match name {
            "T_0" => scheme != Scheme::Planetary,
            "G_a" => scheme == Scheme::AuxiliaryTrolley,
            _ => scheme == Scheme::Planetary,
        };
        if of_it {
            let value = about * n.draw.between(0.2, 2.0);
            n.set(name, value);
        }
    }
    if scheme == Scheme::AuxiliaryTrolley && n.draw.rng.bool() {
        let breaks = weight * n.draw.between(1.0, 10.0);
        n.set("F_ba", breaks);
        if n.draw.rng.bool() {
            let ropes = f64::from(n.draw.rng.u32(1..9));
            n.set("z_a", ropes);
        }
    }
    drums(&mut n, scheme.drums());
    let count = n.draw.rng.usize(4..9);
    phases(&mut n, count, 0.03);
    let speed = n.draw.natural(&s::V_T);
    working_range(&mut n, [-speed, speed]);
    sway(&mut n);
    table
}

/// A way with room for its starts, and no key of a motion where the trolley's speed is set.
fn sway(n: &mut Node) {
    let (size, g) = (n.draw.scale[0], n.draw.g);
    if n.text("fidelity") != Some("swing") {
        // One value of it may be told over time, which only a motion has.
        n.remove(&["way", "dynamics", "x_t", "phi_R", "zeta_f", "a_t", "v_h"]);
        return;
    }
    let length = size * n.draw.between(0.3, 2.0);
    let period = (length / g).sqrt();
    let (rate, lasts, room) = (
        g * n.draw.between(0.01, 0.1),
        n.draw.between(0.5, 8.0),
        n.draw.between(4.0, 9.0),
    );
    n.keep("way", true);
    let mut way = n.child("way").expect("kept");
    for (name, value) in [
        ("l_R", length),
        ("a_m", rate),
        ("v_m", rate * lasts * period),
        ("s_m", rate * lasts * period * period * (lasts + room)),
    ] {
        way.set(name, value);
    }
    let hoist = 0.02 * length / period;
    for (name, most) in [("a_t", 0.05 * g), ("v_h", hoist), ("x_t", size), ("phi_R", 0.3)] {
        if n.has(name) {
            let value = most * n.draw.between(-1.0, 1.0);
            n.set(name, value);
        }
    }
    if n.has("zeta_f") {
        let value = n.draw.between(0.0, 0.9);
        n.set("zeta_f", value);
    }
    let step = period * n.draw.between(0.005, 0.05);
    if let Some(mut dynamics) = n.child("dynamics") {
        dynamics.set("step", step);
    }
}

/// Next to what cannot be: two drums, half a rope, ropes that get slack, three phases, teeth of nearly none.
pub fn edge(n: &mut Node) {
    match n.draw.rng.u8(0..5) {
        0 => drums(n, 2),
        1 => {
            let name = n.draw.pick(&["G_t", "Q_n"]);
            let weight = n.draw.natural(&s::W) * n.draw.pick(&[1e-6, 1e3]);
            n.set(name, weight);
        }
        2 => phases(n, 4, 3.0),
        3 => phases(n, 3, 0.01),
        _ => {
            let value = n.draw.pick(&[1e-9, 1e-3, 1e6]);
            n.set("k", value);
        }
    }
}
