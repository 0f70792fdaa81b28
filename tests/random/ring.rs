//! What makes a scene of a slewing ring legal: weights that stand within the raceway, or a row that holds the ring down.

use std::f64::consts::PI;

use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::supports::ring::symbols as s;
use toml::Table;

use crate::bodies::{list, row};
use crate::luffing::working_range;
use crate::scene::{Draw, Node};
use crate::upper::{moving, slewing, weightless};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("P_all", &s::P_ALL);

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::V));
    let (diameter, angle) = (size * n.draw.between(0.8, 2.0), n.draw.between(0.3, 1.57));
    let count = f64::from(n.draw.rng.u32(3..401));
    n.set("D", diameter);
    n.set("z", count);
    n.set("alpha", angle);
    // A ring that is held down may bear far more than its own weight holds.
    let far = if n.text("rows") == Some("hold_down") {
        n.draw.pick(&[1.0_f64, 30.0, 1000.0]).min(1e6 / size)
    } else {
        1.0
    };
    slewing(&mut n, [size, weight, far]);
    if let Some(mut capacity) = n.child("capacity") {
        curve(&mut capacity, weight, size);
    }
    if let Some(mut bolts) = n.child("bolts") {
        let count = f64::from(bolts.draw.rng.u32(3..201));
        bolts.set("n_b", count);
    }
    if n.text("law") == Some("linear") {
        n.remove(&["life"]);
    }
    working_range(&mut n, [-PI, PI]);
    moving(&mut n);
    table
}

/// Points with rising force, the first without one.
fn curve(capacity: &mut Node, weight: f64, size: f64) {
    let count = capacity.draw.rng.usize(2..6);
    list(capacity, "curve", count, &mut |draw, i| {
        let force = weight * (i as f64 + if i == 0 { 0.0 } else { draw.between(0.0, 0.5) });
        let moment = weight * size * draw.between(0.1, 5.0);
        row(draw, &[(&s::F_CURVE, force), (&s::M_CURVE, moment)])
    });
}

/// Next to what cannot be: a load beyond the raceway, half a rolling element, two of them, a load curve that begins with a
/// force, no weight.
pub fn edge(n: &mut Node) {
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::V));
    match n.draw.rng.u8(0..5) {
        0 => {
            let load = weight * n.draw.pick(&[1.0, 10.0, 1000.0]);
            n.set("Q", load);
            n.set("R", size);
        }
        1 => {
            let count = n.draw.pick(&[2.0, 2.5, 7.5, 1001.0]);
            n.set("z", count);
        }
        2 => {
            if let Some(mut capacity) = n.child("capacity") {
                list(&mut capacity, "curve", 2, &mut |draw, _| {
                    row(draw, &[(&s::F_CURVE, weight), (&s::M_CURVE, weight * size)])
                });
            }
        }
        3 => {
            let width = size * n.draw.pick(&[1e-9, 1e-3, 0.1]);
            n.set("D", width);
        }
        _ => weightless(n),
    }
}
