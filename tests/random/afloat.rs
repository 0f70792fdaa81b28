//! What makes a scene of a floating crane legal: a flat hull, weights near its middle, a load and a wind under which no deck
//! comes to the water and no roll goes beyond where areas count.

use std::f64::consts::PI;

use lemnis_models::afloat::symbols as s;
use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use toml::{Table, Value};

use crate::bodies::{list, row};
use crate::luffing::{aboard, working_range};
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("T", &s::T);

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    let (size, g) = (n.draw.scale[0], n.draw.g);
    let density = n.draw.natural(&s::RHO_W).clamp(1e-6, 1e6);
    n.keep("rho_w", true);
    let density = n.set("rho_w", density);
    let [long, broad] = [(2.0, 4.0), (1.0, 1.5)].map(|(low, high)| size * n.draw.between(low, high));
    let deep = 0.5 * size;
    // Displacement of a draft of a fifth of the size.
    let weight = density * g * long * broad * 0.2 * size;
    shape(&mut n, [long, broad, deep]);
    weights(&mut n, weight, density);
    let luffs = n.has("luffing");
    // Bars may reach far.
    let load = n.draw.between(0.0, if luffs { 0.002 } else { 0.01 });
    n.set("Q", weight * load);
    let high = size * n.draw.between(0.0, 1.0);
    let mut crane = n.child("pedestal").expect("required");
    crane.set("x_s", 0.0);
    crane.keep("y_s", false);
    crane.keep("h_s", !luffs);
    crane.keep("h_1", luffs);
    crane.set(if luffs { "h_1" } else { "h_s" }, high);
    n.keep("R", !luffs);
    if luffs {
        luffer(&mut n, weight);
    } else {
        let reach = n.draw.between(0.0, 0.5);
        n.set("R", size * reach);
        n.remove(&["turning", "theta_1", "omega_c1"]);
    }
    if let Some(mut wind) = n.child("wind") {
        let pressure = wind.draw.between(0.0, 0.002) * weight / (size * size);
        wind.set("p_w", pressure);
        wind.set("z_l", 0.0);
        list(&mut wind, "areas", 1, &mut |draw, _| {
            let (area, height) = (size * size * draw.between(0.0, 1.0), size * draw.between(0.0, 1.0));
            row(draw, &[(&s::A_W, area), (&s::Z_W, height)])
        });
    }
    damage(&mut n, weight, [long, broad, deep]);
    if n.has("openings") {
        list(&mut n, "openings", 2, &mut |draw, i| {
            let along = 0.5 * size * draw.between(-1.0, 1.0);
            let aside = if i == 0 { 0.3 * size } else { -0.3 * size };
            row(draw, &[(&s::X_O, along), (&s::Y_O, aside), (&s::Z_O, 1.2 * deep)])
        });
    }
    if !n.has("wind") {
        n.remove(&["gust"]);
    }
    if let Some(mut gust) = n.child("gust") {
        let pressure = gust.draw.between(0.0, 0.002) * weight / (size * size);
        gust.set("p_g", pressure);
        let roll = gust.draw.between(0.0, 0.05);
        gust.keep("phi_a", true);
        gust.set("phi_a", roll);
    }
    cases(&mut n, weight);
    motion(&mut n, weight * load, [weight / g, long, broad]);
    let end = n.draw.between(0.3, 0.5);
    n.keep("phi_f", true);
    n.set("phi_f", end);
    if n.has("heels") {
        let heels: Vec<Value> = [0.05, 0.2, 0.6]
            .map(|heel| n.draw.written(&s::PHI_H, heel).0.into())
            .to_vec();
        n.put("heels", heels);
    }
    working_range(&mut n, [-PI, PI]);
    table
}

/// A pull that is a small part of the weight (N), and a compartment that is one of a hull of a length, a breadth and a depth.
fn damage(n: &mut Node, weight: f64, [long, broad, deep]: [f64; 3]) {
    if let Some(mut tow) = n.child("tow") {
        let pull = weight * tow.draw.between(0.0, 0.001);
        tow.set("F_p", pull);
        let [high, low] = [1.0, 0.2].map(|high| deep * tow.draw.between(0.0, high));
        tow.set("z_p", high);
        tow.set("z_lp", low);
    }
    if n.has("flooded") {
        list(n, "flooded", 1, &mut |draw, _| {
            let [along, aside] = [(0.4, long), (0.3, broad)].map(|(far, whole)| whole * draw.between(-far, far));
            let share = draw.between(0.1, 1.0);
            let whole = [
                (&s::L_F, 0.1 * long),
                (&s::B_F, 0.2 * broad),
                (&s::D_F, 0.5 * deep),
                (&s::X_F, along),
            ];
            let all = [&whole[..], &[(&s::Y_F, aside), (&s::Z_F, 0.0), (&s::MU_F, share)]].concat();
            row(draw, &all)
        });
    }
}

/// A further load case on a hull of a weight (N) that stands still, with a part of what the hull itself may have; mostly at one
/// slewing angle, as a case costs as much as the hull itself.
fn cases(n: &mut Node, weight: f64) {
    n.remove(&["load_case"]);
    if !n.has("load_cases") || n.text("fidelity") == Some("swing") {
        n.remove(&["load_cases"]);
        return;
    }
    n.put("load_case", "At work");
    let (size, luffs) = (n.draw.scale[0], n.has("luffing"));
    let [blown, struck, towed] = ["wind", "gust", "tow"].map(|name| n.has(name));
    list(n, "load_cases", 1, &mut |draw, i| {
        let load = weight * draw.between(0.0, if luffs { 0.002 } else { 0.01 });
        let pressure = draw.between(0.0, 0.002) * weight / (size * size);
        let mut all = vec![(&s::Q_K, load), (&s::PHI_MAX, 1.0)];
        all.extend((!luffs).then(|| (&s::R_K, size * draw.between(0.0, 0.5))));
        all.extend(draw.coin(0.7).then(|| (&s::PSI_K, draw.between(-PI, PI))));
        all.extend(blown.then_some((&s::P_WK, pressure)));
        all.extend(struck.then_some((&s::P_GK, pressure)));
        all.extend(towed.then(|| (&s::F_PK, weight * draw.between(0.0, 0.001))));
        let mut case = row(draw, &all);
        if let Value::Table(case) = &mut case {
            case.insert("name".to_owned(), format!("Case {i}").into());
        }
        case
    });
}

/// A luffing mechanism whose weights are a small part of another one (N), and a mass that slews with it.
fn luffer(n: &mut Node, weight: f64) {
    let size = n.draw.scale[0];
    aboard(n, weight);
    if n.has("turning") {
        list(n, "turning", 1, &mut |draw, _| {
            let (own, [x, y, z]) = (
                weight * draw.between(0.0, 0.01),
                [0.3, 0.1, 0.5].map(|far| size * draw.between(-far, far)),
            );
            row(draw, &[(&s::G_U, own), (&s::X_U, x), (&s::Y_U, y), (&s::Z_U, z)])
        });
    }
}

/// Of a hull of a mass (kg), a length and a breadth (m) that moves; a load (N) that is no command where it stands still.
fn motion(n: &mut Node, load: f64, [mass, long, broad]: [f64; 3]) {
    if n.text("fidelity") != Some("swing") {
        n.remove(&["l_R", "omega_csl", "omega_c1", "psi_sl", "dynamics"]);
        let load = n.draw.written(&s::Q, load).0;
        n.put("Q", Table::from_iter([("input".to_owned(), Value::from(load))]));
        return;
    }
    let (size, natural) = (n.draw.scale[0], (n.draw.scale[0] / n.draw.g).sqrt());
    n.keep("l_R", true);
    let rope = size * n.draw.between(0.1, 0.5);
    n.set("l_R", rope);
    if n.has("omega_csl") {
        let speed = n.draw.between(-0.1, 0.1) / natural;
        n.set("omega_csl", speed);
    }
    if n.has("omega_c1") {
        // Nothing is told of where it ends.
        n.set("omega_c1", 0.0);
    }
    let luffs = n.has("luffing");
    n.keep("dynamics", true);
    let mut dynamics = n.child("dynamics").expect("kept");
    dynamics.keep("T_1", luffs);
    dynamics.keep("step", false);
    let lag = natural * dynamics.draw.between(0.3, 2.0);
    // As much as the schema takes.
    let about = |across: f64| (0.1 * mass * across * across).clamp(1e-8, 1e17);
    for (name, value) in [
        ("m_a", mass),
        ("J_x", about(broad)),
        ("J_y", about(long)),
        ("T_sl", lag),
    ] {
        dynamics.keep(name, true);
        dynamics.set(name, value);
    }
    if luffs {
        dynamics.set("T_1", lag);
    }
    for (name, value) in [("d_z", mass), ("d_x", about(broad)), ("d_y", about(long))] {
        if dynamics.has(name) {
            let part = dynamics.draw.between(0.0, 0.2);
            dynamics.set(name, part * value / natural);
        }
    }
}

/// A box, or the sections of one, of a length, a breadth and a depth.
fn shape(n: &mut Node, [long, broad, deep]: [f64; 3]) {
    n.remove(&["sections"]);
    if n.draw.coin(0.3) {
        n.remove(&["L", "B", "D"]);
        let count = n.draw.rng.usize(2..6);
        list(n, "sections", count, &mut |draw, i| {
            let x = long * (i as f64 / (count - 1) as f64 - 0.5);
            let mut point = |y: f64, z: f64| {
                let [y, z] = [(&s::Y_H, y), (&s::Z_H, z)].map(|(symbol, value)| draw.written(symbol, value).0);
                Value::from(format!("{y}, {z}"))
            };
            let points = vec![
                point(0.0, 0.0),
                point(0.5 * broad, 0.0),
                point(0.5 * broad, 0.5 * deep),
                point(0.5 * broad, deep),
            ];
            let x = draw.written(&s::X_H, x).0;
            Value::Table(Table::from_iter([
                ("x_h".to_owned(), x.into()),
                ("points".to_owned(), points.into()),
            ]))
        });
    } else {
        for (name, value) in [("L", long), ("B", broad), ("D", deep)] {
            n.keep(name, true);
            n.set(name, value);
        }
    }
}

/// Masses of nearly a weight, and at most one tank with a liquid of a density.
fn weights(n: &mut Node, weight: f64, density: f64) {
    let size = n.draw.scale[0];
    let bodies = n.draw.rng.usize(1..4);
    list(n, "masses", bodies, &mut |draw, _| {
        let own = weight / bodies as f64 * draw.between(0.8, 1.0);
        let [x, y] = [0, 1].map(|_| size * draw.between(-0.01, 0.01));
        let high = size * draw.between(0.0, 0.2);
        row(draw, &[(&s::G_M, own), (&s::X_M, x), (&s::Y_M, y), (&s::Z_M, high)])
    });
    let tanks = n.draw.rng.usize(0..2);
    list(n, "tanks", tanks, &mut |draw, _| {
        let of = |part: f64| part * size;
        let filled = draw.between(0.02, 0.18);
        row(
            draw,
            &[
                (&s::RHO_T, density),
                (&s::L_T, of(0.2)),
                (&s::B_T, of(0.2)),
                (&s::D_T, of(0.2)),
                (&s::H_T, of(filled)),
                (&s::X_T, 0.0),
            ],
        )
    });
}

/// Next to what cannot be: a load that capsizes, a hull that sinks, weights too high, a tank filled to its top, no areas.
pub fn edge(n: &mut Node) {
    let size = n.draw.scale[0];
    match n.draw.rng.u8(0..4) {
        0 => {
            let load = n.draw.natural(&s::Q) * n.draw.pick(&[1.0, 100.0, 1e5]);
            n.set("Q", load);
        }
        1 => {
            let light = n.draw.natural(&s::RHO_W) * n.draw.pick(&[0.1, 1e-3]);
            n.set("rho_w", light.clamp(1e-9, 1e6));
        }
        2 => {
            let weight = n.draw.natural(&s::W_0);
            list(n, "masses", 1, &mut |draw, _| {
                row(draw, &[(&s::G_M, weight), (&s::X_M, 0.0), (&s::Z_M, 2.0 * size)])
            });
        }
        _ => n.remove(&["phi_f"]),
    }
}
