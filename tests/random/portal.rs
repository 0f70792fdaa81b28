//! What makes a scene of a crane on a portal legal: four corners, between which it stands at every slewing angle, whether a
//! leg is lifted or not.

use std::f64::consts::PI;

use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::supports::portal::symbols as s;
use toml::{Table, Value};

use crate::bodies::{list, row};
use crate::luffing::{load, working_range};
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("N_top", &s::N_TOP);

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::V_0));
    for name in ["a", "b"] {
        let width = size * n.draw.between(0.75, 2.0);
        n.set(name, width);
    }
    // The portal weighs half of the unit at least: all else moves the crane's force by a third of the size at most.
    let bodies = n.draw.rng.usize(1..4);
    list(&mut n, "portal", bodies, &mut |draw, _| {
        let [x, y] = [0, 1].map(|_| size * draw.between(-0.05, 0.05));
        let own = weight * draw.between(0.5, 1.0);
        row(draw, &[(&s::G_P, own), (&s::X_P, x), (&s::Y_P, y)])
    });
    let bodies = n.draw.rng.usize(0..4);
    list(&mut n, "upper", bodies, &mut |draw, _| {
        let (own, place) = (weight * draw.between(0.0, 0.5), size * draw.between(-0.1, 0.1));
        row(draw, &[(&s::G_U, own), (&s::R_U, place)])
    });
    load(&mut n, weight, size);
    if n.has("k_l") {
        let part = n.draw.between(0.0, 0.3);
        n.set("k_l", part);
    }
    if let Some(mut wind) = n.child("wind") {
        let (pressure, areas) = (wind.draw.between(0.0, 0.015), wind.draw.rng.usize(1..4));
        wind.set("p_w", pressure * weight / (size * size));
        list(&mut wind, "areas", areas, &mut |draw, _| {
            let (area, height) = (size * size * draw.between(0.0, 1.0), size * draw.between(0.0, 1.0));
            row(draw, &[(&s::A_W, area), (&s::H_W, height)])
        });
    }
    if let Some(mut hopper) = n.child("hopper") {
        let full = weight * hopper.draw.between(0.01, 0.3);
        let part = hopper.draw.between(0.0, 1.0);
        let [x, y] = [0, 1].map(|_| size * hopper.draw.between(-0.05, 0.05));
        let own = weight * hopper.draw.between(0.0, 0.2);
        for (name, value) in [
            ("G_h0", own),
            ("x_h", x),
            ("y_h", y),
            ("Q_h", part * full),
            ("Q_hf", full),
        ] {
            hopper.set(name, value);
        }
    }
    travel(&mut n);
    working_range(&mut n, [-PI, PI]);
    table
}

/// Travel with one driven wheel of each corner and brakes that stop the crane; without it no wheel is driven, and without wind
/// areas there is no storm.
fn travel(n: &mut Node) {
    let (weight, blown) = (n.draw.natural(&s::V_0), n.has("wind"));
    let travels = n.has("travel");
    list(n, "corners", 4, &mut |draw, _| {
        let wheels = draw.rng.u32(1..17).to_string();
        let mut corner = Table::from_iter([(s::N_W.id.to_owned(), wheels.into())]);
        if travels {
            corner.insert(s::N_DR.id.to_owned(), "1".into());
        }
        Value::Table(corner)
    });
    let Some(mut travel) = n.child("travel") else { return };
    let size = travel.draw.scale[0];
    travel.set("D_t", 0.05 * size);
    travel.set("d_j", 0.01 * size);
    for (name, least, most) in [
        ("f_r", 1e-5 * size, 1e-4 * size),
        ("gamma_t", 1e-4, 0.02),
        ("mu_j", 0.001, 0.05),
    ] {
        if travel.has(name) {
            let value = travel.draw.between(least, most);
            travel.set(name, value);
        }
    }
    // More than the wind and the slope ever push.
    travel.set("F_br", 10.0 * weight);
    travel.set("z_m", 4.0);
    if !blown {
        travel.remove(&["storm"]);
    }
    if let Some(mut storm) = travel.child("storm") {
        storm.set("z_c", 4.0);
    }
}

/// So many corners with their wheels.
fn corners(n: &mut Node, count: usize) {
    list(n, "corners", count, &mut |draw, _| {
        let wheels = draw.rng.u32(1..17).to_string();
        Value::Table(Table::from_iter([(s::N_W.id.to_owned(), wheels.into())]))
    });
}

/// Next to what cannot be: a load that tips, three corners, half a wheel, corners on one spot, a crane that weighs nothing.
pub fn edge(n: &mut Node) {
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::V_0));
    match n.draw.rng.u8(0..5) {
        0 => {
            let load = weight * n.draw.pick(&[1.0, 10.0, 1000.0]);
            n.set("Q", load);
        }
        1 => corners(n, 3),
        2 => list(n, "corners", 4, &mut |draw, _| row(draw, &[(&s::N_W, 2.5)])),
        3 => {
            let width = size * n.draw.pick(&[1e-9, 1e-3, 0.1]);
            n.set("a", width);
        }
        _ => {
            let own = weight * n.draw.pick(&[0.0, 1e-9]);
            list(n, "portal", 1, &mut |draw, _| row(draw, &[(&s::G_P, own)]));
            n.remove(&["upper"]);
        }
    }
}
