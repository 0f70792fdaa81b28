//! What makes a scene of a boom on a luffing rope legal, with or without rope compensation: a tackle above the boom, whose line does not meet the foot, and
//! a sheave behind the boom.

use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::luffing::rope::resisting::PARTS;
use lemnis_models::luffing::rope::symbols as s;
use toml::Table;

use crate::cases::cases;
use crate::luffing::{boom_level, dynamics, moving_parts, tail_balance, working_range};
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("A.x", &s::A_X);

/// Angles that the boom may reach, in rad.
const BOOM: [f64; 2] = [-0.2, 1.4];

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let (level, parts @ [moves, _, swings]) = boom_level(draw, false);
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let size = n.draw.scale[0];
    let l = size * n.draw.between(0.2, 2.0);
    let l = n.set("l", l);
    if n.has("f_A") {
        let offset = l * n.draw.between(-0.1, 0.1);
        n.set("f_A", offset);
    }
    moving_parts(&mut n, level, parts);
    if n.has("weights") {
        n.keep("Q", true);
    } else {
        n.remove(&["balance"]);
    }
    let tabulated = level == "table" && n.has("table");
    n.keep("table", tabulated);
    let mut tackle = n.child("tackle").expect("required");
    for (name, low, high) in [("s_K", 0.3, 1.2), ("E_x", -0.5, -0.05), ("E_y", 0.17, 0.8)] {
        let value = l * tackle.draw.between(low, high);
        tackle.set(name, value);
    }
    if tackle.has("chi_K") {
        let turn = tackle.draw.between(-0.1, 0.1);
        tackle.set("chi_K", turn);
    }
    falls(&mut tackle, ["m_l", "eta_l"]);
    let mut rope = n.child("hoist_rope").expect("required");
    for (name, low, high) in [("B_x", -0.5, -0.05), ("B_y", 0.05, 0.8), ("h_Q", 0.0, 1.0)] {
        let value = l * rope.draw.between(low, high);
        rope.set(name, value);
    }
    falls(&mut rope, ["m_h", "eta_h"]);
    if rope.has("m_k") {
        falls(&mut rope, ["m_k", "eta_k"]);
    }
    tail_balance(&mut n);
    working_range(&mut n, BOOM);
    if moves {
        dynamics(&mut n, "J_b", swings, false);
    }
    if swings {
        let hoisting = if n.has("hoisting") { "hoisting" } else { "dynamics" };
        let rope = n.child(hoisting).expect("there");
        let long = rope.text("l_R").expect("set").to_owned();
        n.child("hoist_rope").expect("required").put("h_Q", long);
    }
    cases(&mut n, &PARTS);
    table
}

/// Falls of a tackle, and its efficiency.
fn falls(n: &mut Node, [number, efficiency]: [&str; 2]) {
    let falls = f64::from(n.draw.rng.u8(1..12));
    n.set(number, falls);
    if n.has(efficiency) {
        let part = n.draw.between(0.5, 1.0);
        n.set(efficiency, part);
    }
}

/// Next to what cannot be: no tackle, a tackle or a rope through a point of the boom, no falls, no losses at all.
pub fn edge(n: &mut Node) {
    let l = n.get("l");
    let ends = n
        .child("motion")
        .map_or([0.0; 2], |m| ["from", "to"].map(|name| m.get(name)));
    let phi = n.draw.pick(&ends);
    let beside = n.draw.pick(&[0.0, 1e-12, -1e-12, 1e-6, -1e-3]);
    let (sin, cos) = Calc::sin_cos(phi + beside);
    let kind = n.draw.rng.u8(0..5);
    let table = if kind < 3 { "tackle" } else { "hoist_rope" };
    let Some(mut inner) = n.child(table) else { return };
    let (at, names) = match kind {
        // The tackle has no length, or its line goes through the foot.
        0 => (inner.get("s_K"), ["E_x", "E_y"]),
        1 => (-0.3 * l, ["E_x", "E_y"]),
        2 => {
            inner.set("m_l", 1e6);
            return;
        }
        // The sheave stands at the head, or in the boom's way.
        3 => (l, ["B_x", "B_y"]),
        _ => (0.5 * l, ["B_x", "B_y"]),
    };
    inner.set(names[0], at * cos);
    inner.set(names[1], at * sin);
}
