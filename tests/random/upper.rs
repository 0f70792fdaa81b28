//! What slews on a support in random scenes: bodies, load, slope, wind areas, cases.

use std::f64::consts::PI;

use lemnis_models::parts::air::AROUND;
use lemnis_models::parts::turntable::MOST_SPIN;
use lemnis_models::supports::drive::symbols as d;
use lemnis_models::supports::upper::symbols as s;
use toml::Value;

use crate::bodies::{list, row};
use crate::cases::start;
use crate::luffing::{LEAST_LENGTH, air, load};
use crate::scene::Node;

/// Pressure of the strongest wind that is drawn on what moves, in Pa.
const STRONGEST: f64 = 0.5 * 2.0 * 30.0 * 30.0;

/// So much weight at so great a size, the bodies and the load as many times that size from the axis as `far` says.
pub fn slewing(n: &mut Node, [size, weight, far]: [f64; 3]) {
    let bodies = n.draw.rng.usize(1..4);
    list(n, "upper", bodies, &mut |draw, _| {
        let (own, place) = (weight * draw.between(0.5, 1.0), far * size * draw.between(-0.1, 0.1));
        let high = size * draw.between(0.0, 0.5);
        row(draw, &[(&s::G_U, own), (&s::R_U, place), (&s::H_U, high)])
    });
    let luffs = load(n, weight, far * size);
    if luffs {
        let foot = size * n.draw.between(0.0, 0.5);
        n.keep("h_1", true);
        n.set("h_1", foot);
    }
    if let Some(mut slope) = n.child("slope") {
        let (gamma, high) = (slope.draw.between(0.0, 0.05), size * slope.draw.between(0.0, 1.0));
        slope.set("gamma", gamma);
        slope.keep("h_Q", !luffs);
        if !luffs {
            slope.set("h_Q", high);
        }
    }
    let (areas, cases) = (n.draw.rng.usize(0..3), n.draw.rng.usize(1..4));
    let [drives, brakes] = turning(n, [size, weight, far]);
    list(n, "areas", areas, &mut |draw, _| {
        let (area, height) = (size * size * draw.between(0.0, 1.0), size * draw.between(0.0, 1.0));
        let place = (&d::R_W, size * draw.between(-0.5, 0.5));
        let own = [(&s::A_W, area), (&s::H_W, height), place];
        row(draw, if drives { &own } else { &own[..2] })
    });
    let sways = n.draw.coin(0.5);
    let time = n.draw.scale[2];
    list(n, "load_cases", cases, &mut |draw, at| {
        let (factor, to) = (draw.between(0.0, 1.5), draw.angle());
        let pressure = draw.between(0.0, 0.02) * weight / (size * size);
        let mut own = vec![(&s::K_Q, factor), (&s::P_W, pressure), (&s::CHI_W, to)];
        if drives {
            // The first one slews.
            let least = if at == 0 { 0.001 } else { 0.0 };
            let sway = if sways { draw.between(0.0, 0.3) } else { 0.0 };
            own.extend([(&d::N_S, draw.between(least, 0.05) / time), (&d::ALPHA_Q, sway)]);
        }
        if brakes {
            own.push((&d::K_B, draw.between(1.0, 2.0)));
        }
        row(draw, &own)
    });
}

/// What slews may move behind a coupling, as fast as its head stays on its crane; with next to no friction, of which a
/// coupling of any drive carries more, and on level ground.
pub fn moving(n: &mut Node) {
    // A gear by stages may leave its motors next to no inertia.
    let coupled = n
        .child("slewing_drive")
        .is_some_and(|drive| drive.has("coupling") && !drive.has("stages"));
    let moves = coupled && n.has("R") && n.draw.coin(0.8);
    n.remove(&["dynamics"]);
    n.keep("slewing", moves);
    if moves {
        n.remove(&["slope"]);
        for table in ["friction", "maker_friction"] {
            let Some(mut friction) = n.child(table) else { continue };
            for name in ["mu_n", "mu_m", "mu_u", "mu_f", "mu_p"] {
                let little = friction.draw.between(0.0, 1e-7);
                if friction.has(name) {
                    friction.set(name, little);
                }
            }
        }
    }
    let start = n.draw.between(-PI, PI);
    let swings = moves && n.draw.coin(0.5);
    let rope = n.draw.natural(&d::L_R) * n.draw.between(0.2, 2.0);
    let held = swings && swung(n, rope);
    let count = n.table.get("areas").and_then(Value::as_array).map_or(0, Vec::len);
    let areas = count > 0;
    let Some(mut own) = n.child("slewing") else { return };
    own.put("fidelity", if swings { "swing" } else { "rigid" });
    let blows = own.has("air") && (swings || areas);
    own.keep("l_R", swings && !held);
    own.keep("air", blows);
    if swings && !held {
        own.set("l_R", rope);
    }
    if blows {
        air(&mut own, rope, true);
        if !swings || (areas && own.draw.coin(0.3)) {
            own.child("air").expect("kept").remove(&AROUND);
        }
    }
    for name in ["phi_R", "chi_R"] {
        let angle = own.draw.between(-1.5, 1.5);
        let leans = swings && own.has(name);
        own.keep(name, leans);
        if leans {
            own.set(name, angle);
        }
    }
    own.remove(&["c_sl", "M_sl", "omega_sl"]);
    for (name, angle) in [("psi_sl", start), ("psi_min", start - 0.5), ("psi_max", start + 1.0)] {
        own.keep(name, true);
        own.set(name, angle);
    }
    if blows && areas {
        exposed(n, count);
    }
    let most = 0.99 * (MOST_SPIN * n.draw.g / n.get("R")).sqrt();
    let mut motion = n.child("motion").expect("required");
    motion.remove(&["input"]);
    if motion.get("speed") > most {
        motion.set("speed", most);
    }
}

/// So many areas that the strongest wind pushes by a small part of the weight, as the pressure of a case does, and an inertia of
/// what slews beside that.
fn exposed(n: &mut Node, count: usize) {
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::V));
    let most = (size * size).min(0.02 * weight / STRONGEST);
    list(n, "areas", count, &mut |draw, _| {
        let (area, height) = (most * draw.between(0.0, 1.0), size * draw.between(0.0, 1.0));
        let place = size * draw.between(-0.5, 0.5);
        row(draw, &[(&s::A_W, area), (&s::H_W, height), (&d::R_W, place)])
    });
    let least = 1e-4 * weight * size * size / n.draw.g;
    let mut drive = n.child("slewing_drive").expect("it moves");
    if drive.has("J_e") {
        let own = drive.get("J_e").max(least);
        drive.set("J_e", own);
    }
}

/// Upper works of an inertia beside that of a load that swings on a rope (m); whether the drive gives the rope.
fn swung(n: &mut Node, rope: f64) -> bool {
    let load = n.get("Q") / n.draw.g * n.get("R") * n.get("R");
    let own = load * n.draw.between(0.01, 1.0);
    let mut drive = n.child("slewing_drive").expect("it moves");
    drive.keep("J_e", true);
    drive.set("J_e", own);
    let held = drive.has("l_R");
    if held {
        drive.set("l_R", rope);
    }
    held
}

/// What makes a drive legal, of a crane of a size (m) and a weight (N) that reaches that many times its size; whether there is
/// one, and its brake.
fn turning(n: &mut Node, [size, weight, far]: [f64; 3]) -> [bool; 2] {
    let rubs = n.has("friction") || n.has("maker_friction");
    let drives = rubs && (n.has("slewing_drive") || n.draw.coin(0.5));
    n.keep("slewing_drive", drives);
    let time = n.draw.scale[2];
    let Some(mut drive) = n.child("slewing_drive") else {
        return [false; 2];
    };
    let count = f64::from(drive.draw.rng.u32(1..5));
    let ratio = drive.draw.between(100.0, 2000.0);
    let power = weight * size / time * drive.draw.between(0.001, 0.1);
    let turns = ratio * 0.05 / time;
    for (name, value) in [("z_d", count), ("i_sl", ratio), ("P_N", power), ("n_N", turns)] {
        drive.set(name, value);
    }
    drive.put("heating", 1);
    let shaft = power * time * time * time / (ratio * ratio) * drive.draw.between(0.01, 1.0);
    // A drive behind a coupling has a millionth of the inertia of what slews at least.
    let least = 1e-6 * weight * time * time * size * far * far / (ratio * ratio);
    drive.set("J_M", shaft.max(1e-8).max(least));
    start(&mut drive);
    let torque = power / turns;
    let brakes = drive.has("brake") || drive.draw.coin(0.5);
    drive.keep("brake", brakes);
    let braked = drive.child("brake").map(|mut brake| {
        let own = torque * brake.draw.between(0.1, 2.0);
        brake.set("T_b", own);
    });
    let couples = braked.is_some() && (drive.has("coupling") || drive.draw.coin(0.5));
    drive.keep("coupling", couples);
    if let Some(mut pinion) = drive.child("pinion") {
        let own = size * pinion.draw.between(0.005, 0.05);
        let ring = size * pinion.draw.between(0.1, 0.5);
        pinion.set("r_z", own.max(LEAST_LENGTH));
        pinion.set("r_g", ring);
    }
    gear(&mut drive, ratio);
    [true, braked.is_some()]
}

/// Stages that come to a ratio with pinion and ring, or the ratio as a whole.
fn gear(drive: &mut Node, ratio: f64) {
    let mesh = drive
        .child("pinion")
        .map(|pinion| pinion.get("r_g") / pinion.get("r_z"));
    let staged = mesh.filter(|_| drive.draw.coin(0.5));
    drive.remove(&["stages"]);
    for name in ["i_sl", "eta_sl"] {
        drive.keep(name, staged.is_none());
    }
    if let Some(mut pinion) = drive.child("pinion") {
        pinion.keep("eta_r", staged.is_some());
    }
    let Some(mesh) = staged else { return };
    let (count, mut left) = (drive.draw.rng.usize(1..5), ratio / mesh);
    list(drive, "stages", count, &mut |draw, at| {
        let (stage, efficiency) = (draw.between(1.5, 6.0), draw.between(0.5, 1.0));
        let own = if at + 1 == count { left } else { stage };
        left /= own;
        row(draw, &[(&d::I_G, own), (&d::ETA_G, efficiency)])
    });
}

/// Upper works that weigh nothing, or next to nothing.
pub fn weightless(n: &mut Node) {
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::V));
    let own = weight * n.draw.pick(&[0.0, 1e-9]);
    list(n, "upper", 1, &mut |draw, _| {
        row(draw, &[(&s::G_U, own), (&s::R_U, size)])
    });
}
