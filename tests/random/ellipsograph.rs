//! What makes a scene of a boom on guide and link legal: a working range between two positions in which it lies level.

use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::luffing::ellipsograph::resisting::PARTS;
use lemnis_models::luffing::ellipsograph::symbols as s;
use toml::Table;

use crate::cases::cases;
use crate::luffing::{
    LEAST_LENGTH, boom_level, bored, drive_about_origin, dynamics, moving_parts, tail_balance, working_range,
};
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("A.x", &s::A_X);

/// No length of a scene is longer, in m.
const LONGEST: f64 = 1e6;

/// Angles that the boom may reach, in rad.
const BOOM: [f64; 2] = [0.05, 3.09];

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let (level, [moves, oil, rope]) = boom_level(draw, true);
    let thick = bored(draw, oil);
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let size = n.draw.scale[0];
    let c = size * n.draw.between(0.2, 2.0);
    let c = n.set("c", c);
    // Level, or on an ellipse that is nearly a line, a circle or anything else.
    let part = n.draw.decades(-2, 1);
    let a = c * n.draw.pick(&[1.0, 1.0 + 1e-6, part]);
    n.set("a", a.clamp(LEAST_LENGTH, LONGEST));
    moving_parts(&mut n, level, [moves, oil, rope]);
    if n.has("weights") {
        n.keep("Q", true);
    } else {
        n.remove(&["balance"]);
    }
    let tabulated = level == "table" && n.has("table");
    n.keep("table", tabulated);
    tail_balance(&mut n);
    working_range(&mut n, BOOM);
    // The link turns the other way.
    let [from, to] = n
        .child("motion")
        .map_or(BOOM, |motion| [motion.get("from"), motion.get("to")]);
    drive_about_origin(&mut n, [-to, -from], [moves, oil], thick);
    if moves {
        dynamics(&mut n, "J_b", rope, level == "hydraulic");
    }
    cases(&mut n, &PARTS);
    table
}

/// Next to what cannot be: a boom that lies level at an end of its working range, a link or a head of next to no length, a drive
/// that points at the link's pivot everywhere.
pub fn edge(n: &mut Node) {
    let beside = n.draw.pick(&[0.0, 1e-12, -1e-12, 1e-6, -1e-3]);
    match n.draw.rng.u8(0..5) {
        0 => {
            let tiny = n.get("a") * 1e-9;
            n.set("c", tiny);
        }
        1 => {
            let tiny = n.get("c") * 1e-9;
            n.set("a", tiny);
        }
        2 => {
            if let Some(mut drive) = n.child("drive").filter(|drive| drive.has("E_x")) {
                drive.set("E_x", 0.0);
                drive.set("E_y", beside);
            }
        }
        3 => {
            if let Some(mut motion) = n.child("motion") {
                motion.set("from", beside);
            }
        }
        _ => {
            if let Some(mut motion) = n.child("motion") {
                motion.set("to", std::f64::consts::PI + beside);
            }
        }
    }
}
