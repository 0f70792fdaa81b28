//! What makes the cases of a luffing scene legal: what they weigh and drive is there, bodies and pins are those of the
//! mechanism.

use std::f64::consts::TAU;

use lemnis_models::luffing::resistances::scene::CaseParts;
use lemnis_models::parts::starts::{N_EN, T_EN};
use toml::Table;

use crate::bodies::{list, row};
use crate::scene::Node;

/// Greatest angle of a swaying rope and greatest slope, in rad.
const SWAY: f64 = 0.5;
const SLOPE: f64 = 0.2;

/// Limits of what is checked in cases, with the table that has it, and whether this needs them.
const LIMITS: [(&str, &str, bool); 11] = [
    ("buckling", "lambda_k_max", false),
    ("teeth", "sigma_F_max", true),
    ("teeth", "sigma_H_max", true),
    ("nut", "p_n_max", true),
    ("nut", "sigma_v_max", true),
    ("rope", "h_tr", true),
    ("rope", "h_sh", true),
    ("rope", "S_w_min", false),
    ("pin_size", "p_b_max", true),
    ("pin_size", "tau_p_max", true),
    ("cylinder", "p_C_max", false),
];

/// Cases of a mechanism that is legal without them, or none, with limits of what is checked in them.
pub fn cases(n: &mut Node, parts: &CaseParts) {
    let drive = n.child("drive").map(|drive| {
        let kind = drive.text("kind").unwrap_or("").to_owned();
        (kind, drive.has("r_z"), drive.get("d_2"), drive.get("d_r"))
    });
    let area = all(n, parts);
    weather(n, area);
    let mut there = Vec::new();
    if let Some(mut c) = n.child("cases") {
        sizes(&mut c, parts, drive.as_ref());
        let tables = LIMITS.iter().map(|(table, ..)| *table);
        there.extend(tables.filter(|table| c.has(table)));
        there.extend(drive.filter(|(kind, ..)| kind == "cylinder").map(|_| "cylinder"));
    }
    let on_shaft = n.child("cases").is_some_and(|c| c.has("motor") && c.has("brake"));
    let braked = on_shaft && n.has("drive") && !n.has("hydraulics");
    if let Some(mut dynamics) = n.child("dynamics").filter(|_| !braked) {
        dynamics.remove(&["u_br"]);
    }
    if !n.has("limits") && LIMITS.iter().any(|(table, _, needed)| *needed && there.contains(table)) {
        n.put("limits", Table::new());
    }
    let Some(mut limits) = n.child("limits") else { return };
    for (table, name, needed) in LIMITS {
        if !there.contains(&table) {
            limits.remove(&[name]);
        } else if needed && limits.knows(name) {
            limits.keep(name, true);
        }
    }
}

/// Wind and slope in motion, where cases have them, given slewing where nothing slews or swings, and areas times drag coefficients (m²) in any wind.
fn weather(n: &mut Node, area: Option<f64>) {
    let [length, mass, time] = n.draw.scale;
    let turns = n.has("slewing");
    let far = n.get("X_8").abs();
    let rails = n
        .child("balance")
        .is_some_and(|b| b.text("kind") == Some("straight_rail"));
    let hoisted = n.child("hoisting").is_some_and(|h| h.has("l_R"));
    let air = n.child("cases").map_or(0.0, |c| c.get("c_air"));
    let Some(mut d) = n.child("dynamics") else { return };
    if turns || area.is_none() {
        d.remove(&["sigma_m"]);
    }
    if turns || rails || hoisted || d.has("l_R") {
        d.remove(&["n_sm"]);
    } else if d.has("n_sm") {
        // Centrifugal forces are a small part of the weights, which keep a tie taut.
        let most = (1e-3 * d.draw.g / (far + 3.0 * length)).sqrt().min(0.1 / time);
        let speed = d.draw.between(-most, most) / TAU;
        d.set("n_sm", speed.clamp(-0.5, 0.5));
    }
    let area = area.unwrap_or(0.0);
    if area == 0.0 {
        d.remove(&["p_wm", "v_wm"]);
    }
    // A small part of what sets the bodies going in the scene's own time.
    let pressure = mass * length / (time * time * area) * d.draw.between(0.0, 0.01);
    let sign = if d.draw.coin(0.5) { 1.0 } else { -1.0 };
    let slope = d.draw.between(-0.05, 0.05);
    let speed = (pressure / air).sqrt().min(60.0);
    for (name, value) in [("p_wm", sign * pressure), ("v_wm", -sign * speed), ("sigma_m", slope)] {
        if d.has(name) {
            d.set(name, value);
        }
    }
}

/// Sizes of what this drive has, and of pins.
fn sizes(c: &mut Node, parts: &CaseParts, drive: Option<&(String, bool, f64, f64)>) {
    let kind = drive.map_or("", |(kind, ..)| kind);
    let (pinion, pitch, rod) = drive.map_or((false, 0.0, 0.0), |(_, pinion, pitch, rod)| (*pinion, *pitch, *rod));
    let nut = kind == "screw";
    if !nut {
        c.remove(&["nut"]);
    }
    if !(kind == "sector" || kind == "rack" && pinion) {
        c.remove(&["teeth"]);
    }
    if drive.is_some() {
        c.remove(&["rope"]);
    }
    if let Some(mut nut) = c.child("nut") {
        let part = nut.draw.between(0.3, 0.95);
        nut.set("d_3", part * pitch);
    }
    let profile = ["rack", "crank"].contains(&kind);
    let round = nut && c.has("nut") || kind == "cylinder" && rod > 0.0;
    if !profile && !round {
        c.remove(&["buckling"]);
    }
    if let Some(mut buckling) = c.child("buckling") {
        buckling.remove(&["l_0"]);
        buckling.keep("A_k", profile);
        buckling.keep("i_min", profile);
    }
    c.remove(&["pin_size"]);
    for name in parts.pins.iter().filter(|name| parts.guide != Some(**name)) {
        if c.draw.coin(0.4) {
            c.more("pin_size", |pin| pin.put("at", *name));
        }
    }
}

/// A start of one kind, with what belongs to it, of a motor that is faster than any case; whether it is along the slip curve.
pub fn start(c: &mut Node) -> bool {
    let Some(mut start) = c.child("start") else {
        return false;
    };
    let kind = start.draw.pick(&["slip", "inverter", "engine"]);
    start.put("kind", kind);
    start.remove(&["curve"]);
    for (name, of, least, most) in [
        ("lambda_bd", "slip", 1.5, 9.0),
        ("n_0", "slip", 9e5, 1e6),
        ("t_r", "inverter", 0.1, 9.0),
        ("lambda_inv", "inverter", 1.0, 9.0),
        ("n_idle", "engine", 2e-6, 3e-6),
        ("n_gov", "engine", 8e5, 9e5),
    ] {
        start.keep(name, kind == of);
        if kind == of {
            let value = start.draw.between(least, most);
            start.set(name, value);
        }
    }
    if kind == "engine" {
        list(&mut start, "curve", 2, &mut |draw, at| {
            let torque = draw.between(1e17, 9e17);
            row(draw, &[(&N_EN, [1.5e-6, 9.5e5][at]), (&T_EN, torque)])
        });
    }
    kind == "slip"
}

/// The same of a luffing drive.
fn luffing_start(c: &mut Node) {
    let slips = start(c);
    let is = |kind| c.child("start").is_some_and(|start| start.text("kind") == Some(kind));
    let [engine, inverter] = ["engine", "inverter"].map(is);
    if let Some(mut motor) = c.child("motor").filter(|_| inverter) {
        // Its limit is no more than some rated torques, where the mean torque of a start is 1e5 of them.
        let turns = motor.draw.between(5e-4, 1e-3);
        motor.set("n_N", turns);
    }
    if let Some(mut motor) = c.child("motor").filter(|_| engine) {
        let travel = motor.draw.between(0.1, 0.2);
        motor.set("l_M", travel);
    }
    if let Some(mut motor) = c.child("motor").filter(|_| slips) {
        for (name, least, most) in [("l_M", 6e-3, 9e-3), ("P_N", 8e14, 9e14), ("n_N", 5e-4, 1e-3)] {
            let value = motor.draw.between(least, most);
            motor.set(name, value);
        }
    }
}

/// Cases with the areas of their bodies times drag coefficients (m²), or none.
fn all(n: &mut Node, parts: &CaseParts) -> Option<f64> {
    let behind = n.child("balance").map(|balance| {
        let kind = balance.text("kind").unwrap_or("").to_owned();
        (kind, balance.has("s_5"))
    });
    let armless = matches!(&behind, Some((kind, false)) if kind == "lever");
    if armless || !n.has("Q") || !n.has("weights") || !n.has("drive") && !n.has("tackle") {
        n.remove(&["cases"]);
    }
    let mut c = n.child("cases")?;
    c.remove(&["case", "body", "pin"]);
    let mut area = 0.0;
    let counterweight = behind.as_ref().map(|_| "counterweight");
    for name in parts.bodies.iter().copied().chain(counterweight) {
        c.more("body", |body| {
            body.put("on", name);
            if body.has("A_w") {
                body.keep("c_w", true);
                area += body.get("A_w") * body.get("c_w");
            }
        });
    }
    let rod = matches!(&behind, Some((kind, _)) if matches!(kind.as_str(), "lever" | "parallelogram"));
    let behind = ["K", "L", "M"].into_iter().filter(|_| rod);
    for name in parts.pins.iter().copied().chain(behind) {
        if c.draw.coin(0.5) {
            c.more("pin", |pin| {
                pin.put("at", name);
                pin.keep("r_p", parts.guide != Some(name));
            });
        }
    }
    c.keep("c_air", true);
    // A motor and brakes that are strong enough for a drive that nearly points at the foot of its bar.
    if !c.has("motor") {
        c.remove(&["brake", "start"]);
    }
    let brakes = c.has("brake");
    if !brakes {
        c.remove(&["second_brake"]);
    }
    if let Some(mut motor) = c.child("motor") {
        motor.put("heating", "I");
        for (name, least, most) in [
            ("P_N", 1e14, 9e14),
            ("n_N", 5.0, 50.0),
            ("k_a", 1e5, 9e5),
            ("eta_M", 0.5, 1.0),
            ("J_M", 1e-3, 1e3),
        ] {
            let value = motor.draw.between(least, most);
            motor.set(name, value);
        }
        let travel = motor.draw.between(1e-4, 1e-3);
        motor.set("l_M", travel);
    }
    luffing_start(&mut c);
    let first = c.child("brake").map(|mut brake| {
        brake.set("T_b", 9e17);
        brake.get("tau_b")
    });
    if let Some((mut second, first)) = c.child("second_brake").zip(first)
        && second.get("tau_b2") < first
    {
        second.set("tau_b2", 2.0 * first);
    }
    for number in 1..=c.draw.rng.u8(1..4) {
        c.more("case", |case| {
            case.put("name", "I".repeat(number.into()));
            case.keep("p_w", true);
            case.keep("K_b", brakes);
            if number == 1 && case.get("v_s") == 0.0 {
                case.set("v_s", 0.1);
            }
            for (name, most) in [("alpha_s", SWAY), ("sigma", SLOPE)] {
                let angle = case.draw.between(-most, most);
                case.set(name, angle);
            }
        });
    }
    Some(area)
}
