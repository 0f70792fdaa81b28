//! What makes a scene of a boom with a curved trunk legal: a tie with which the boom, somewhere in its range, has the point of
//! contact on the tail, and angles up to its ends.

use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::luffing::curved_trunk::resisting::PARTS;
use lemnis_models::luffing::curved_trunk::symbols as s;
use toml::{Table, Value};

use crate::cases::cases;
use crate::led::{begun, led};
use crate::luffing::{boom_level, bored, drive_about_origin, dynamics, moving_parts, tail_balance, working_range};
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("A.x", &s::A_X);

/// What the wind turns.
const AREA: [&str; 2] = ["A_ws", "r_ws"];

/// Angle of the boom with the tie in the middle of the tail, in rad.
const MIDDLE: f64 = 1.05;

/// How much tie is free at a contact in direction `zeta` (rad), in parts of the boom, with B as far from O3 as in the middle.
fn free([z_x, z_y, rho]: [f64; 3], zeta: f64, square: f64) -> f64 {
    let (sin, cos) = Calc::sin_cos(zeta);
    let (x, y) = (z_x + rho * cos, z_y + rho * sin);
    let along = y * cos - x * sin;
    (along * along + square - x * x - y * y).sqrt() - along
}

/// Direction of the trunk (rad) with the boom at `phi`, of a tie in parts of the boom.
fn direction(arc: [f64; 3], ends: [f64; 2], tie: f64, e: [f64; 2], phi: f64) -> f64 {
    let (sin, cos) = Calc::sin_cos(phi);
    let away = [e[0] - cos, e[1] - sin];
    let square = away[0].powi(2) + away[1].powi(2);
    let longer = |zeta| free(arc, zeta, square) + arc[2] * (zeta - ends[0]) > tie;
    let [mut from, mut to] = ends;
    let at_start = longer(from);
    for _ in 0..40 {
        let middle = f64::midpoint(from, to);
        *(if longer(middle) == at_start { &mut from } else { &mut to }) = middle;
    }
    let (sin, cos) = Calc::sin_cos(from);
    let free = free(arc, from, square);
    let (x, y) = (arc[0] + arc[2] * cos - free * sin, arc[1] + arc[2] * sin + free * cos);
    f64::direction(away[0], away[1]) - f64::direction(x, y)
}

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let (level, [moves, oil, rope]) = boom_level(draw, true);
    let thick = bored(draw, oil);
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    moving_parts(&mut n, level, [moves, oil, rope]);
    let size = n.draw.scale[0];
    let b = size * n.draw.between(0.2, 2.0);
    let b = n.set("b", b);
    let a = b * n.draw.between(0.3, 0.8);
    let a = n.set("a", a);
    let e = [n.draw.between(-0.4, -0.1), n.draw.between(0.4, 0.6)];
    let arc = [
        n.draw.between(-0.08, 0.0),
        n.draw.between(-0.04, 0.04),
        n.draw.between(0.15, 0.25),
    ];
    let ends = [n.draw.between(2.1, 2.4), n.draw.between(3.8, 4.2)];
    let (sin, cos) = Calc::sin_cos(MIDDLE);
    let square = (e[0] - cos).powi(2) + (e[1] - sin).powi(2);
    let zeta = f64::midpoint(ends[0], ends[1]);
    let tie = free(arc, zeta, square) + arc[2] * (zeta - ends[0]);
    for (name, part) in [("O3_x", e[0]), ("O3_y", e[1]), ("L_t", tie)] {
        n.set(name, part * b);
    }
    tail(&mut n, arc.map(|part| part * b), ends);
    if n.has("weights") {
        n.keep("Q", true);
        let mut weights = n.child("weights").expect("there");
        // In front of B, so that the tie stays taut.
        let arm = b * weights.draw.between(0.01, 0.1);
        weights.set("r_t", arm);
        weights.remove(&["chi_t"]);
        if moves && weights.get("G_t") == 0.0 {
            let [_, mass, _] = weights.draw.scale;
            let own = mass * weights.draw.g * weights.draw.between(0.01, 0.1);
            weights.set("G_t", own);
        }
    } else {
        n.remove(&["balance"]);
    }
    let tabulated = level == "table" && n.has("table");
    n.keep("table", tabulated);
    tail_balance(&mut n);
    // Where the trunk points to the front, what it carries keeps the tie taut.
    let front = |phi: &f64| {
        let (_, cos) = Calc::sin_cos(direction(arc, ends, tie, e, *phi));
        cos > 0.1
    };
    let angles = (0..=30).map(|i| MIDDLE - 0.15 + 0.01 * f64::from(i));
    let taut: Vec<f64> = angles.filter(front).collect();
    let range = [taut[0], taut[taut.len() - 1]];
    working_range(&mut n, range);
    led(&mut n, &[("boom", b, 0.5 * a), ("trunk", 0.0, 0.5 * a)], 4.0 * b);
    if let Some(mut rope) = n.child("rope") {
        // It pulls so little that the tie stays taut.
        let falls = rope.draw.between(4.0, 12.0);
        rope.set("m_h", falls);
    }
    drive_about_origin(&mut n, range, [moves, oil], thick);
    if let Some(mut oil) = n.child("hydraulics") {
        // Oil that holds it: a boom that falls or starts at once may slacken the tie.
        oil.set("u_v", 0.0);
        oil.remove(&["p_lh", "i_lh", "dp_lh", "x_T", "y_b1", "y_b2"]);
    }
    if let Some(mut turning) = n.child("slewing") {
        turning.remove(&["control", "slope"]);
        turning.remove(&AREA);
    }
    if moves {
        dynamics(&mut n, "J_b", rope, level == "hydraulic");
        begun(&mut n);
        held(&mut n, [a, b], level != "hydraulic");
        slowly(&mut n);
    }
    cases(&mut n, &PARTS);
    sheltered(&mut n);
    table
}

/// In wind that leaves the tie of a light trunk taut.
fn sheltered(n: &mut Node) {
    let [length, mass, _] = n.draw.scale;
    let heaviest = mass * n.draw.g * 3.0 * length;
    let own = n
        .child("weights")
        .map_or(heaviest, |weights| weights.get("G_t") * weights.get("r_t"));
    let part = (own / heaviest).min(1.0);
    let Some(mut dynamics) = n.child("dynamics") else {
        return;
    };
    for (name, part) in [("p_wm", part), ("v_wm", part.sqrt())] {
        if dynamics.has(name) {
            let value = dynamics.get(name);
            dynamics.set(name, part * value);
        }
    }
}

/// The brake holds boom and trunk where the motion begins, and the rope pulls the trunk down: a boom that falls freely, or a load
/// far out, may slacken the tie.
fn held(n: &mut Node, [a, b]: [f64; 2], brakes: bool) {
    let mut most = n.get("Q") * (a + b);
    if let Some(weights) = n.child("weights") {
        most += weights.get("G_b") * weights.get("r_b") + weights.get("G_t") * (b + weights.get("r_t"));
    }
    if let Some(balance) = n.child("balance") {
        most += balance.get("G_c") * balance.get("r_c");
    }
    let mut dynamics = n.child("dynamics").expect("there");
    let motor = dynamics.get("M_A").abs();
    if brakes {
        dynamics.keep("M_S", true);
        // More than ten times as much, were the weights masses.
        dynamics.set("M_S", 4.0 * (motor + 10.0 * most));
    }
    for name in ["dynamics", "hoisting"] {
        if let Some(mut table) = n.child(name).filter(|table| table.has("phi_R")) {
            let out = table.draw.between(-0.3, 0.05);
            table.set("phi_R", out);
        }
    }
}

/// So slowly that what it takes outward leaves the tie taut, from a load that hangs in the boom's plane.
fn slowly(n: &mut Node) {
    let Some(mut turning) = n.child("slewing") else { return };
    turning.remove(&["chi_R"]);
    for name in ["omega_sl", "M_sl"] {
        if turning.has(name) {
            let value = turning.get(name);
            turning.set(name, 0.02 * value);
        }
    }
}

/// As an arc, or as points of one.
fn tail(n: &mut Node, [z_x, z_y, rho]: [f64; 3], ends: [f64; 2]) {
    let points = n.draw.coin(0.5);
    let mut tail = n.child("tail").expect("required");
    tail.remove(&["clamped"]);
    let names = [
        ("Z_x", z_x),
        ("Z_y", z_y),
        ("rho", rho),
        ("zeta_f", ends[0]),
        ("zeta_r", ends[1]),
    ];
    if !points {
        for (name, value) in names {
            tail.set(name, value);
        }
        return;
    }
    tail.remove(&names.map(|(name, _)| name));
    tail.put("kind", "points");
    let count = tail.draw.rng.u32(8..30);
    let list = (0..=count).map(|i| {
        let (sin, cos) = Calc::sin_cos(ends[0] + (ends[1] - ends[0]) * f64::from(i) / f64::from(count));
        let point = [("x_t", z_x + rho * cos), ("y_t", z_y + rho * sin)];
        let text = point.map(|(name, value)| (name.to_owned(), Value::from(format!("{value:?} m"))));
        Value::from(Table::from_iter(text))
    });
    tail.put("points", list.collect::<Vec<_>>());
}

/// Next to what cannot be: a boom up to where the tie lifts off or the tail ends, a tail that is a hinge, a tie through B, a
/// trunk that slackens it, a drive that points at the boom's foot everywhere.
pub fn edge(n: &mut Node) {
    let b = n.get("b");
    let beside = n.draw.pick(&[0.0, 1e-12, -1e-12, 1e-6, -1e-3]);
    match n.draw.rng.u8(0..6) {
        0 => {
            if let Some(mut motion) = n.child("motion") {
                let far = motion.draw.between(0.15, 0.5);
                motion.set("from", MIDDLE - far);
                motion.set("to", MIDDLE + far);
            }
        }
        1 => {
            if let Some(mut tail) = n.child("tail").filter(|tail| tail.has("rho")) {
                let tiny = b * tail.draw.pick(&[1e-4, 1e-9]);
                tail.set("rho", tiny);
            }
        }
        2 => {
            if let Some(mut tail) = n.child("tail").filter(|tail| tail.has("rho")) {
                let radius = tail.get("rho");
                tail.set("Z_x", radius * (1.0 + beside));
            }
        }
        3 => {
            if let Some(mut drive) = n.child("drive").filter(|drive| drive.has("E_x")) {
                drive.set("E_x", 0.0);
                drive.set("E_y", beside);
            }
        }
        4 => {
            if let Some(mut weights) = n.child("weights") {
                weights.set("chi_t", std::f64::consts::PI);
                weights.set("r_t", b);
            }
        }
        _ => {
            let tie = n.get("L_t");
            n.set("L_t", tie * (1.0 + beside));
        }
    }
}
