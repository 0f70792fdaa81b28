//! What makes a scene of a container bridge's trolley legal: the parts of its kind, ropes that reach the spreader, a tow rope
//! beyond the working range, and no key of a motion where its place is set.

use lemnis_models::bridge::scene::KINDS;
use lemnis_models::bridge::symbols as s;
use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use toml::Table;

use crate::luffing::working_range;
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("F_r", &s::F_R);

/// Four ropes that reach from the trolley to the spreader; returns their length.
fn ropes(n: &mut Node) -> f64 {
    let length = n.draw.scale[0] * n.draw.between(0.3, 2.0);
    let mut ropes = n.child("ropes").expect("required");
    let length = ropes.set("l_R", length);
    for name in ["a_o", "a_u", "b_o", "b_u", "i_q", "i_z", "e_q", "d_q", "e_x"] {
        let part = ropes.draw.between(0.02, 0.15);
        if ropes.has(name) {
            ropes.set(name, part * length);
        }
    }
    if ropes.draw.coin(0.2) {
        let same = ropes.get("a_o");
        ropes.set("a_u", same);
    }
    if let Some(mut slings) = n.child("slings") {
        for (name, low, high) in [
            ("l_s", 0.05, 1.0),
            ("e_s", 0.0, 0.1),
            ("e_1", 0.0, 0.1),
            ("i_1", 0.02, 0.15),
        ] {
            let part = slings.draw.between(low, high);
            if slings.has(name) {
                slings.set(name, part * length);
            }
        }
    }
    length
}

/// Weights, wheels and losses.
fn trolley(n: &mut Node) {
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::W));
    for name in ["G_t", "G_s", "Q"] {
        let own = weight * n.draw.between(0.1, 1.0);
        n.set(name, own);
    }
    for (name, low, high) in [("mu_t", 0.0, 0.02), ("gamma_b", -0.02, 0.02), ("eta_d", 0.7, 1.0)] {
        if n.has(name) {
            let value = n.draw.between(low, high);
            n.set(name, value);
        }
    }
    for (name, natural) in [("p_w", 0.02 * weight / (size * size)), ("A_w", size * size)] {
        if n.has(name) {
            let value = natural * n.draw.rng.f64();
            n.set(name, value);
        }
    }
    let wheels = 4.0 * f64::from(n.draw.rng.u32(1..4));
    n.keep("n_w", true);
    n.set("n_w", wheels);
    if let Some(mut driven) = n.child("driven") {
        let count = f64::from(driven.draw.rng.u32(1..5));
        driven.set("n_dr", count);
    }
    if let Some(mut brakes) = n.child("brakes") {
        let force = weight * brakes.draw.between(0.3, 2.0);
        brakes.set("F_br", force);
    }
    if let Some(mut sheaves) = n.child("sheaves") {
        let count = 1 + i64::from(sheaves.draw.rng.u32(0..4));
        sheaves.put("count", count);
        sheaves.keep("eta_r", true);
        let eta = sheaves.draw.between(0.95, 1.0);
        sheaves.set("eta_r", eta);
    }
}

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let kind = n.draw.pick(&KINDS);
    n.put("kind", kind);
    for (part, wanted) in [
        ("tow", kind == "rope"),
        ("driven", kind != "rope"),
        ("sheaves", kind != "machinery"),
    ] {
        n.keep(part, wanted);
    }
    trolley(&mut n);
    let length = ropes(&mut n);
    let size = n.draw.scale[0];
    working_range(&mut n, [-size, 2.0 * size]);
    let [from, to, lasts] = {
        let mut motion = n.child("motion").expect("required");
        // The schema has no finer one.
        if motion.get("step") < 1e-4 {
            motion.set("step", 1e-4);
        }
        let [from, to] = ["from", "to"].map(|name| motion.get(name));
        [from, to, (to - from) / motion.get("speed")]
    };
    let [pull, span] = [n.draw.natural(&s::W), size].map(|natural| natural * n.draw.between(0.2, 2.0));
    if let Some(mut tow) = n.child("tow") {
        let few = f64::from(tow.draw.rng.u32(1..5));
        let own = [
            ("T_0", pull),
            ("F_b", 5.0 * pull),
            ("EA", 100.0 * pull),
            ("q_r", 0.01 * pull / size),
        ];
        for (name, value) in own.into_iter().chain([("x_1", to + span), ("x_2", from - span)]) {
            tow.set(name, value);
        }
        if tow.has("z_r") {
            tow.set("z_r", few);
        }
    }
    let g = n.draw.g;
    for (name, most) in [("a_t", 0.05 * g), ("v_h", 0.2 * length / lasts)] {
        if n.has(name) {
            let value = most * n.draw.between(-1.0, 1.0);
            n.set(name, value);
        }
    }
    if n.text("fidelity") == Some("swing") {
        // The spreader of two bodies stands on edge where sin phi_R = a_u/a_o.
        let ropes = n.child("ropes").map(|ropes| ropes.get("a_u") / ropes.get("a_o"));
        let most = match n.has("slings") {
            true => 0.3_f64.min(0.5 * ropes.unwrap_or(1.0)),
            false => 0.3,
        };
        for (name, value) in [("x_t", from), ("phi_R", most * n.draw.between(-1.0, 1.0))] {
            if n.has(name) {
                n.set(name, value);
            }
        }
        if n.has("zeta_f") {
            let value = n.draw.between(0.0, 0.9);
            n.set("zeta_f", value);
        }
        let step = (length / g).sqrt() * n.draw.between(0.005, 0.05);
        if let Some(mut dynamics) = n.child("dynamics") {
            dynamics.set("step", step);
        }
    } else {
        // One value of it may be told over time, which only a motion has.
        n.remove(&["x_t", "phi_R", "zeta_f", "dynamics", "a_t", "v_h"]);
    }
    table
}

/// Next to what cannot be: ropes that just reach, a sheave at the end of the working range, more driven wheels than wheels,
/// a part of another kind.
pub fn edge(n: &mut Node) {
    let factor = n.draw.pick(&[0.999, 1.0, 1.001]);
    match n.draw.rng.u8(0..4) {
        0 => {
            let mut ropes = n.child("ropes").expect("required");
            let apart = (ropes.get("a_o") - ropes.get("a_u")).abs();
            ropes.set("l_R", (apart * factor).max(1e-3));
        }
        1 => {
            let to = n.child("motion").expect("required").get("to");
            if let Some(mut tow) = n.child("tow") {
                tow.set("x_1", to * factor);
            }
        }
        2 => {
            if let Some(mut driven) = n.child("driven") {
                driven.set("n_dr", 64.0);
            }
        }
        _ => {
            let kind = n.draw.pick(&KINDS);
            n.put("kind", kind);
        }
    }
}
