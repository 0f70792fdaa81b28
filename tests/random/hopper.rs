//! What makes a scene of a hopper legal: contents that it holds, a grab that empties itself within its cycle, and no key of a
//! flow where its contents are set.

use lemnis_models::hopper::symbols as s;
use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use toml::Table;

use crate::luffing::working_range;
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("G_h", &s::G_H);

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let [_, mass, time] = n.draw.scale;
    let most = mass * n.draw.between(0.5, 5.0);
    let most = n.set("m_max", most);
    // The grab's cycle is the natural time or so, and brings up to half of what the hopper holds.
    let load = most * n.draw.between(0.02, 0.5);
    let load = n.set("m_g", load);
    let cycle = time * n.draw.between(0.5, 2.0);
    let cycle = n.set("t_c", cycle);
    for (name, most) in [("t_d", 0.99), ("t_p", 20.0)] {
        if n.has(name) {
            let part = n.draw.between(0.0, most);
            n.set(name, part * cycle);
        }
    }
    let flow = load / cycle * n.draw.between(0.3, 3.0);
    n.set("q_f", flow);
    if n.text("fidelity") == Some("flow") {
        for (name, value) in [("m_h", 0.999 * most), ("q_in", 10.0 * flow), ("y_f", 1.0)] {
            if n.has(name) {
                let part = n.draw.pick(&[0.0, 0.2, 0.7, 1.0]);
                n.set(name, part * value);
            }
        }
        let step = cycle * n.draw.between(0.005, 0.1);
        if let Some(mut dynamics) = n.child("dynamics") {
            dynamics.set("step", step);
        }
    } else {
        n.remove(&["m_h", "q_in", "y_f", "dynamics"]);
    }
    working_range(&mut n, [0.0, 0.999 * most]);
    // What is measured in more than turns may be passed several times: a hopper is not.
    let mut motion = n.child("motion").expect("required");
    if motion.get("to") > most {
        motion.set("from", 0.0);
        let to = motion.set("to", 0.999 * most);
        motion.set("step", to / 20.0);
    }
    table
}

/// Next to what cannot be: more than it holds, a grab as long as its cycle, a hopper or a load of nearly nothing.
pub fn edge(n: &mut Node) {
    let (most, cycle) = (n.get("m_max"), n.get("t_c"));
    let (name, value) = match n.draw.rng.u8(0..4) {
        0 => ("m_h", most * n.draw.pick(&[1.0, 1.001])),
        1 => ("t_d", cycle * n.draw.pick(&[1.0, 1.001])),
        2 => ("m_g", most * n.draw.pick(&[1e-6, 1.0, 1e3])),
        _ => ("q_f", most / cycle * n.draw.pick(&[1e-6, 1e3])),
    };
    n.set(name, value);
}
