//! What makes a scene of a column legal: a pivot that is not all bore, and sizes where there is friction.

use std::f64::consts::PI;

use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::supports::column::symbols as s;
use toml::Table;

use crate::luffing::working_range;
use crate::scene::{Draw, Node};
use crate::upper::{moving, slewing, weightless};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("H_u_all", &s::H_U_ALL);

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::V));
    let height = size * n.draw.between(0.05, 2.0);
    n.set("h_uf", height);
    let sized = n.child("bearings").map(|mut bearings| {
        let outer = size * bearings.draw.between(0.01, 0.1);
        let inner = outer * bearings.draw.between(0.0, 0.9);
        bearings.set("D_p", outer);
        bearings.set("d_i", inner);
    });
    if sized.is_none() {
        n.remove(&["friction"]);
    }
    slewing(&mut n, [size, weight, 1.0]);
    working_range(&mut n, [-PI, PI]);
    moving(&mut n);
    table
}

/// Next to what cannot be: a pivot that is all bore, bearings next to each other, no weight, friction alone.
pub fn edge(n: &mut Node) {
    let size = n.draw.scale[0];
    match n.draw.rng.u8(0..4) {
        0 => {
            if let Some(mut bearings) = n.child("bearings") {
                bearings.set("D_p", size);
                bearings.set("d_i", size);
            }
        }
        1 => {
            let height = size * n.draw.pick(&[1e-9, 1e-3]);
            n.set("h_uf", height);
        }
        2 => n.remove(&["bearings"]),
        _ => weightless(n),
    }
}
