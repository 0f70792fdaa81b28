//! What makes a scene of a mobile crane legal: supports all around it, weights and a load that stand between them on any
//! slope and in any wind that it has, a boom between its ends.

use std::f64::consts::{PI, TAU};

use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::supports::mobile::symbols as s;
use toml::{Table, Value};

use crate::bodies::{list, row};
use crate::luffing::working_range;
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("a", &s::A);

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::V_0));
    // Unevenly around the slewing axis, none of them far inside.
    let count = n.draw.rng.usize(4..9);
    let caps = n.draw.coin(0.4).then(|| weight * n.draw.between(0.5, 3.0));
    list(&mut n, "points", count, &mut |draw, i| {
        let angle = TAU * (i as f64 + draw.between(-0.1, 0.1)) / count as f64;
        let (sin, cos) = lemnis_models::kernel::calc::Calc::sin_cos(angle);
        let radius = size * draw.between(0.9, 1.1);
        let place = [(&s::X, radius * cos), (&s::Y, radius * sin)];
        let cap = caps.map(|cap| (&s::N_CAP, cap));
        row(draw, &place.into_iter().chain(cap).collect::<Vec<_>>())
    });
    let bodies = n.draw.rng.usize(1..4);
    list(&mut n, "carrier", bodies, &mut |draw, _| {
        let [x, y] = [0, 1].map(|_| size * draw.between(-0.1, 0.1));
        let own = weight * draw.between(0.5, 1.0);
        let high = size * draw.between(0.0, 0.5);
        row(draw, &[(&s::G_C, own), (&s::X_C, x), (&s::Y_C, y), (&s::H_C, high)])
    });
    let bodies = n.draw.rng.usize(0..3);
    list(&mut n, "upper", bodies, &mut |draw, _| {
        let (own, place) = (weight * draw.between(0.0, 0.3), size * draw.between(-0.3, 0.1));
        let high = size * draw.between(0.0, 0.5);
        row(draw, &[(&s::G_U, own), (&s::R_U, place), (&s::H_U, high)])
    });
    let shortest = size * n.draw.between(0.5, 3.0);
    let parts = n.draw.rng.usize(1..5);
    let mut boom = n.child("boom").expect("required");
    let shortest = boom.set("l_0", shortest);
    let values = [("x_F", -0.3, 0.3), ("h_F", 0.0, 0.5)];
    for (name, low, high) in values {
        let value = size * boom.draw.between(low, high);
        boom.set(name, value);
    }
    boom.keep("d_A", false);
    boom.set("phi_min", 0.0);
    boom.set("phi_max", 1.5);
    list(&mut boom, "parts", parts, &mut |draw, _| {
        let (own, place) = (weight * draw.between(0.0, 0.015), shortest * draw.between(0.0, 1.0));
        let gains = 0.003 * weight / size * draw.between(0.0, 1.0);
        let part = draw.between(0.0, 1.0);
        row(
            draw,
            &[(&s::G_P, own), (&s::S_P, place), (&s::Q_P, gains), (&s::KAPPA_P, part)],
        )
    });
    let longer = n.draw.between(1.001, 1.5);
    n.set("l", shortest * longer);
    let foot = n.child("boom").expect("required").get("x_F");
    let angle = n.draw.between(0.1, 1.4);
    if n.draw.coin(0.5) {
        n.remove(&["R"]);
        n.set("phi", angle);
    } else {
        n.remove(&["phi"]);
        let reach = foot + shortest * longer * lemnis_models::kernel::calc::Calc::sin_cos(angle).1;
        n.set("R", reach);
    }
    loaded(&mut n, size, weight);
    rating(&mut n, size, weight, shortest);
    working_range(&mut n, [-PI, PI]);
    table
}

/// The load, and what makes it lean.
fn loaded(n: &mut Node, size: f64, weight: f64) {
    for name in ["Q", "G_h"] {
        let load = weight * n.draw.between(0.0, 0.01);
        n.set(name, load);
    }
    if n.has("phi_Q") {
        let impact = n.draw.between(1.0, 2.0);
        n.set("phi_Q", impact);
    }
    if let Some(mut slope) = n.child("slope") {
        let steep = slope.draw.between(0.0, 0.03);
        slope.set("gamma_s", steep);
    }
    if let Some(mut wind) = n.child("wind") {
        // A hundredth of the load's weight.
        let speed = wind.set("v_w", 0.1 * (size * wind.draw.g).sqrt());
        let area = 0.01 * wind.draw.g / (speed * speed);
        wind.keep("c_p", true);
        wind.set("c_p", 1.0);
        wind.set("a_Q", area.clamp(1e-9, 1e3));
    }
}

/// How the load is rated, by what strength, and over which reaches.
fn rating(n: &mut Node, size: f64, weight: f64, shortest: f64) {
    if let Some(mut rating) = n.child("rating") {
        for (name, low, high) in [
            ("s_lim", 0.0, 0.3),
            ("k_w", 0.5, 1.0),
            ("k_F", 0.0, 0.3),
            ("k_P", 1.0, 2.0),
        ] {
            if rating.has(name) {
                let value = rating.draw.between(low, high);
                rating.set(name, value);
            }
        }
    }
    let tables = n.draw.rng.usize(0..4);
    list(n, "strength", tables, &mut |draw, _| {
        let of = draw.pick(&["boom", "rope", "tackle", "cylinder"]);
        let mut table = Table::new();
        let longest = shortest * draw.between(1.0, 2.0);
        table.insert("l".to_owned(), draw.written(&s::L, longest).0.into());
        table.insert("of".to_owned(), of.into());
        let load = weight * draw.between(0.01, 0.5);
        let point = |draw: &mut Draw, reach: f64| {
            let reach = draw.written(&s::R, reach).0;
            format!("{reach}, {}", draw.written(&s::Q_S, load).0)
        };
        if draw.coin(0.5) {
            let points = vec![
                point(draw, 0.5 * size),
                point(draw, 2.0 * size),
                point(draw, 6.0 * size),
            ];
            table.insert("points".to_owned(), points.into());
        } else {
            table.insert("Q_s".to_owned(), draw.written(&s::Q_S, load).0.into());
        }
        Value::Table(table)
    });
    if let Some(mut chart) = n.child("chart") {
        let from = chart.set("R_from", 0.5 * size);
        let to = chart.draw.between(1.0, 4.0);
        chart.set("R_to", from + to * size);
        chart.set("R_step", 0.3 * size);
        let mut longer = shortest;
        let lengths: Vec<Value> = (0..chart.draw.rng.usize(1..6))
            .map(|_| {
                longer *= chart.draw.between(1.01, 1.4);
                chart.draw.written(&s::L, longer).0.into()
            })
            .collect();
        chart.put("lengths", lengths);
    }
}

/// Next to what cannot be: supports on one line, a load that tips, a boom that does not reach, supports that bear nothing.
pub fn edge(n: &mut Node) {
    let size = n.draw.scale[0];
    match n.draw.rng.u8(0..5) {
        0 => {
            let aside = n.draw.pick(&[0.0, 1e-12, 1e-9, 1e-3]) * size;
            list(n, "points", 4, &mut |draw, i| {
                let x = (i as f64 - 1.5) * size;
                row(draw, &[(&s::X, x), (&s::Y, if i == 1 { aside } else { 0.0 })])
            });
        }
        1 => {
            let load = n.draw.natural(&s::Q) * n.draw.pick(&[1.0, 10.0, 1000.0]);
            n.set("Q", load);
        }
        2 => {
            n.remove(&["phi"]);
            let reach = n.get("l") * n.draw.pick(&[1.0, 1.5, 0.0]);
            n.set("R", reach);
        }
        3 => {
            let length = n.child("boom").map_or(size, |boom| boom.get("l_0"));
            n.set("l", length * (1.0 - 1e-9));
        }
        _ => {
            let shape = n.draw.pick(&[0.0, 1e-6]);
            let weight = n.draw.natural(&s::V_0) * shape;
            list(n, "carrier", 1, &mut |draw, _| {
                row(draw, &[(&s::G_C, weight), (&s::X_C, 0.0)])
            });
        }
    }
}
