//! What makes a hoist rope legal that is led over sheaves: these lie near the joint of a bar, away from the head, and the last one
//! so far behind the crane that no other meets it.

use toml::{Table, Value};

use crate::scene::Node;

/// Of bars by their names, each with where a joint lies along it and how far around that sheaves may be (m), and of the size of the
/// whole (m).
pub fn led(n: &mut Node, bars: &[(&'static str, f64, f64)], size: f64) {
    // No farther than a scene may have it.
    if size > 1e5 {
        n.remove(&["rope"]);
    }
    let Some(mut rope) = n.child("rope") else { return };
    let (on, along, room) = rope.draw.pick(bars);
    let sheave = |on: &str, x: f64, y: f64| {
        let place =
            [("x_r", x), ("y_r", y)].map(|(name, value)| (name.to_owned(), Value::from(format!("{value:?} m"))));
        Value::from(Table::from_iter(
            place.into_iter().chain([("on".to_owned(), on.into())]),
        ))
    };
    let mut all = Vec::new();
    for number in 0..rope.draw.rng.usize(1..4) {
        // One beside the other.
        let (x, y) = (rope.draw.between(-0.2, 0.2), rope.draw.between(-0.1, 0.1));
        all.push(sheave(
            on,
            along + (0.2 * number as f64 - 0.3 + 0.2 * x) * room,
            y * room,
        ));
    }
    let (x, y) = (rope.draw.between(-9.0, -5.0), rope.draw.between(-1.0, 1.0));
    all.push(sheave("frame", x * size, y * size));
    rope.put("sheave", all);
}

/// It begins as far below the head as its rope is long, where it swings.
pub fn begun(n: &mut Node) {
    let table = if n.has("hoisting") { "hoisting" } else { "dynamics" };
    let long = n.child(table).and_then(|table| table.text("l_R").map(str::to_owned));
    if let Some((mut rope, long)) = n.child("rope").zip(long) {
        rope.put("h_Q", long);
    }
}
