//! What makes a scene of slewing by itself legal: something that has inertia, stops around its start, and no key of a
//! motion where it does not move.

use std::f64::consts::PI;

use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::parts::air::AROUND;
use lemnis_models::parts::turntable::MOST_SPIN;
use lemnis_models::slewing::symbols as s;
use toml::Table;

use crate::control::{SLEWING, controlled, cycle};
use crate::luffing::{air, area, pressure, working_range};
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("M_st", &s::M_ST);

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    for name in ["R", "Q", "motion"] {
        n.keep(name, true);
    }
    let inertia = n.draw.natural(&s::J_TOT) * n.draw.between(0.2, 5.0);
    n.set("J_sl", inertia);
    let told = n.text("fidelity").unwrap_or("static").to_owned();
    let level = match told.as_str() {
        "auto" => n.draw.pick(&["static", "rigid", "swing"]),
        level => level,
    };
    if level == "swing" {
        n.keep("l_R", true);
        let rope = n.draw.natural(&s::L_R) * n.draw.between(0.2, 2.0);
        n.set("l_R", rope);
        let loaded = n.draw.coin(0.5);
        windy(&mut n, inertia, Some(rope).filter(|_| loaded));
        for name in ["phi_R", "chi_R"] {
            if n.has(name) {
                let angle = n.draw.between(-1.5, 1.5);
                n.set(name, angle);
            }
        }
    } else {
        n.remove(&["l_R", "phi_R", "chi_R"]);
        windy(&mut n, inertia, None);
    }
    let start = n.draw.between(-PI, PI);
    if matches!(level, "rigid" | "swing") {
        for (name, angle) in [("psi_sl", start), ("psi_min", start - 0.5), ("psi_max", start + 1.0)] {
            if n.has(name) {
                n.set(name, angle);
            }
        }
        if !n.has("psi_sl") {
            n.remove(&["psi_min", "psi_max"]);
        }
        // Viscous friction that stops it in a natural time or later, a drive that it holds at a radian in that time or less,
        // and a step that sees it.
        let friction = inertia / n.draw.scale[2] * n.draw.between(0.0, 1.0);
        let moment = friction / n.draw.scale[2] * n.draw.between(-1.0, 1.0);
        for (name, value) in [("c_sl", friction), ("M_sl", moment)] {
            if n.has(name) {
                n.set(name, value);
            }
        }
        if !n.has("c_sl") {
            n.remove(&["M_sl"]);
        }
        let drive = inertia * n.draw.between(0.001, 1.0);
        if let Some(mut coupling) = n.child("coupling") {
            coupling.set("J_d", drive);
        }
        let moved = if n.has("coupling") { drive } else { inertia };
        controls(&mut n, moved);
        let step = n.draw.scale[2] * n.draw.between(0.01, 0.05);
        if let Some(mut dynamics) = n.child("dynamics") {
            dynamics.set("step", step);
        }
    } else {
        n.remove(&[
            "M_sl", "M_Bsl", "psi_sl", "omega_sl", "psi_min", "psi_max", "dynamics", "control", "coupling",
        ]);
    }
    if let Some(mut slope) = n.child("slope") {
        let steep = slope.draw.between(0.0, 0.2);
        slope.set("gamma_s", steep);
    }
    couples(&mut n);
    working_range(&mut n, [-PI, PI]);
    // Speeds at which the head, and the weight that leans, stay on their crane.
    let leans = n.child("slope").map_or(0.0, |slope| slope.get("r_u").abs());
    let most = 0.99 * (MOST_SPIN * n.draw.g / n.get("R").max(leans)).sqrt();
    if n.get("omega_sl").abs() > most {
        let speed = most * n.draw.between(-1.0, 1.0);
        n.set("omega_sl", speed);
    }
    let mut motion = n.child("motion").expect("required");
    if motion.get("speed") > most {
        motion.set("speed", most);
    }
    table
}

/// Air around a load on a rope (m), if any; where there is an area, one that its wind turns by a radian in a natural time or later.
fn windy(n: &mut Node, inertia: f64, rope: Option<f64>) {
    let there = n.has("A_ws");
    n.keep("r_ws", there);
    n.keep("air", there || rope.is_some());
    if there || rope.is_some() {
        air(n, rope.unwrap_or(1.0), true);
    }
    if !there {
        return;
    }
    if rope.is_none() {
        n.child("air").expect("kept").remove(&AROUND);
    }
    let pressure = pressure(&n.child("air").expect("kept"));
    area(n, pressure, inertia);
}

/// A coupling that lets the drive slew, and holds the weights across the slope.
fn couples(n: &mut Node) {
    let slope = n.child("slope");
    let [leans, steep] = slope.map_or([0.0; 2], |slope| {
        [slope.get("G_u") * slope.get("r_u"), slope.get("gamma_s")]
    });
    let across = (leans + n.get("Q") * n.get("R")).abs() * steep;
    let dry = n.get("M_Fsl");
    let natural = n.draw.natural(&s::M_LIM);
    let Some(mut coupling) = n.child("coupling") else {
        return;
    };
    let limit = (dry + across + natural * coupling.draw.between(0.1, 1.0)) * coupling.draw.between(1.0, 3.0);
    coupling.set("M_lim", limit);
}

/// A controller of an inertia (kg·m²), in the place of the drive's moment.
fn controls(n: &mut Node, inertia: f64) {
    let most = (MOST_SPIN * n.draw.g / n.get("R").max(1e-9)).sqrt();
    let (time, cycle, start) = (n.draw.scale[2], cycle(n), n.get("psi_sl"));
    let Some(mut control) = n.child("control") else { return };
    let speed = 0.5 * most.min(1.0 / time) * control.draw.between(-1.0, 1.0);
    controlled(
        &mut control,
        &SLEWING,
        inertia,
        speed,
        [start - 1.0, start + 1.0],
        cycle,
    );
    // What is commanded may be followed without samples.
    if control.draw.coin(0.5) {
        control.remove(&["T_csl"]);
    }
    n.remove(&[SLEWING.moment]);
}

/// Next to what cannot be: nothing that slews, a reach of nothing, a start at a stop, a range of no width.
pub fn edge(n: &mut Node) {
    let values: &[(&str, f64)] = match n.draw.rng.u8(0..4) {
        0 => &[("J_sl", 0.0), ("R", 0.0)],
        1 => &[("Q", 0.0)],
        2 => &[("psi_sl", 0.3), ("psi_max", 0.3)],
        _ => &[("psi_min", 0.3), ("psi_max", 0.3)],
    };
    for (name, value) in values {
        n.set(name, *value);
    }
}
