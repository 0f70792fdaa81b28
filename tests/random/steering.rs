//! What makes a scene of a steered machine legal: ranges and cylinders that let every group stand as commanded.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::parts::plane::{Point, length};
use lemnis_models::steering::symbols as s;
use toml::{Table, Value};

use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("theta[1]", &s::THETA);

/// A key with the least and the greatest value that makes sense.
type Limits = (&'static str, f64, f64);

/// Quantities (SI) of no machine's size, with the least and the greatest that make sense.
const RANGES: &[(&str, &[Limits])] = &[
    ("tyre", &[("f_t", 0.0, 2.0), ("p_t", 1e5, 9e6), ("k_v", 1.0, 10.0)]),
    (
        "ring",
        &[
            ("L_max", 0.0, 5.0),
            ("F_s", 1.0, 5.0),
            ("k_test", 1.0, 3.0),
            ("mu_r", 0.0, 0.1),
            ("D_L", 0.1, 5.0),
        ],
    ),
    (
        "accuracy",
        &[
            ("resolution", 0.0, 0.02),
            ("dead_band", 0.0, 0.01),
            ("slip_limit", 0.001, 0.1),
        ],
    ),
    ("transition", &[("v_c_max", 0.001, 1.0)]),
    (
        "hydraulics",
        &[
            ("p", 1e6, 5e7),
            ("n", 5.0, 50.0),
            ("eta_v", 0.5, 1.0),
            ("k_r", 1.0, 1.5),
            ("E", 1e11, 3e11),
            ("nu", 1.0, 6.0),
        ],
    ),
];

/// How the machine is commanded.
struct Command {
    mode: &'static str,
    by: &'static str,
    /// Corner of the outline, radius and centre, in m.
    corner: Point<f64>,
    radius: f64,
    centre: Point<f64>,
}

/// A legal machine.
pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let size = draw.decades(-1, 2) * draw.between(0.5, 3.0);
    let mass = draw.decades(1, 7);
    // A machine that does not swing has no time of its own.
    draw.scale = [size, mass, 1.0];
    let moves = draw.coin(0.35);
    let level = if draw.coin(0.2) {
        "auto"
    } else if moves {
        "hydraulic"
    } else {
        "kinematic"
    };
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    n.put("fidelity", level);
    for name in ["dynamics", "oil", "plc"] {
        n.keep(name, moves);
    }
    for name in ["cylinder", "accuracy"] {
        let kept = moves || n.has(name);
        n.keep(name, kept);
    }
    if !n.has("cylinder") {
        n.remove(&["hydraulics", "accuracy", "transition"]);
    }
    let at = groups(&mut n, moves);
    loads(&mut n, &at);
    for (name, ranges) in RANGES {
        let Some(mut inner) = n.child(name) else { continue };
        for (key, low, high) in *ranges {
            if inner.has(key) {
                let value = inner.draw.between(*low, *high);
                inner.set(key, value);
            }
        }
    }
    let outline = outline(&mut n, &at);
    let stroke = cylinder(&mut n);
    catalogue(&mut n);
    // Most commands ask more than most cylinders give.
    for tries in 0.. {
        let command = command(&mut n, &at, outline, tries > 30);
        let range = swept(&mut n, if tries > 10 { 0.2 } else { 1.0 });
        let needs = needs(&command, &at, range);
        if needs.is_some_and(|needs| ranges(&mut n, needs, stroke)) {
            break;
        }
    }
    if let Some(mut transition) = n.child("transition") {
        transition.remove(&["from", "to"]);
    }
    if moves {
        oil(&mut n);
    }
    table
}

/// Axes of the groups in m, the base group foremost, and their tables.
fn groups(n: &mut Node, moves: bool) -> Vec<Point<f64>> {
    let size = n.draw.scale[0];
    let most = if moves { 12 } else { 64 };
    let part = n.draw.rng.f64();
    let count = 4 + (f64::from(most - 4) * part.powi(4)).round() as usize;
    let scattered = n.draw.coin(0.3);
    let rows = count.div_ceil(2);
    let mut places: Vec<[f64; 2]> = Vec::new();
    while places.len() < count {
        let i = places.len();
        let row = (i / 2) as f64 / (rows - 1) as f64;
        let place = if scattered {
            [0.0; 2].map(|_| size * n.draw.between(-1.0, 1.0))
        } else {
            [
                size * (1.0 - 2.0 * row),
                size * if i.is_multiple_of(2) { 0.4 } else { -0.4 },
            ]
        };
        // Two groups stand apart.
        let near = |other: &[f64; 2]| (0..2).all(|k| (place[k] - other[k]).abs() < 2e-3);
        if !(scattered && places.iter().any(near)) {
            places.push(place);
        }
    }
    places.sort_by(|a, b| b[0].total_cmp(&a[0]));
    let given = n.draw.coin(0.3);
    let mut list = Vec::new();
    let mut at = Vec::new();
    for [x, y] in places {
        let mut group = Table::new();
        let [x, y] = [("x", x), ("y", y)].map(|(name, value)| {
            let (text, value) = n.draw.written(&s::X, value);
            group.insert(name.to_owned(), text.into());
            value
        });
        if n.has("cylinder") && y < 0.0 {
            group.insert("cylinder".to_owned(), "mirrored".into());
        }
        if given {
            let load = n.draw.natural(&s::G) * n.draw.between(0.0, 2.0);
            let text = n.draw.written(&s::G, load).0;
            group.insert("G".to_owned(), text.into());
        }
        list.push(Value::Table(group));
        at.push(Point::new(x, y));
    }
    n.put("groups", list);
    if given {
        n.remove(&["load"]);
    }
    at
}

/// Corners of the outline, in m.
fn outline(n: &mut Node, at: &[Point<f64>]) -> [Point<f64>; 4] {
    let extreme = |axis: usize, sign: f64| sign * at.iter().map(|p| sign * p[axis]).fold(f64::NEG_INFINITY, f64::max);
    let mut sides = [extreme(0, 1.0), extreme(0, -1.0), extreme(1, 1.0), extreme(1, -1.0)];
    let more = n.draw.scale[0] * n.draw.between(0.0, 0.5);
    if let Some(mut outline) = n.child("outline") {
        for ((side, name), sign) in sides
            .iter_mut()
            .zip(["front", "rear", "left", "right"])
            .zip([1.0, -1.0, 1.0, -1.0])
        {
            *side = outline.set(name, *side + sign * more);
        }
    }
    let [front, rear, left, right] = sides;
    [(front, left), (rear, left), (rear, right), (front, right)].map(|(x, y)| Point::new(x, y))
}

/// The angles (rad) to which every cylinder, mirrored or not, turns its group.
fn cylinder(n: &mut Node) -> Option<f64> {
    let mut c = n.child("cylinder")?;
    loop {
        let arm = c.draw.decades(-2, 0);
        let (stroke, more) = (arm * c.draw.between(0.5, 1.7), arm * c.draw.between(0.0, 3.0));
        let [arm, stroke, more] =
            [("R_c", arm), ("l_x", stroke), ("l_A", more)].map(|(name, value)| c.set(name, value));
        let middle = more + 1.5 * stroke;
        let foot = (arm * arm + middle * middle).sqrt();
        // From the law of cosines; straight ahead the angle at the axis is that of the right triangle.
        let straight = Calc::acos(arm / foot);
        let angle = |long: f64| Calc::acos((arm * arm + foot * foot - long * long) / (2.0 * arm * foot));
        let (back, out) = (angle(middle - 0.5 * stroke), angle(middle + 0.5 * stroke));
        let turn = (straight - back).min(out - straight);
        // A stop beyond a dead point is none.
        if turn > 0.1 && back > 0.05 && out < PI - 0.05 {
            let bore = arm * c.draw.between(0.1, 0.5);
            let bore = c.set("D_g", bore);
            let rod = bore * c.draw.between(0.2, 0.9);
            c.set("d", rod);
            let alpha = c.draw.angle();
            c.set("alpha", alpha);
            return Some(turn);
        }
    }
}

fn loads(n: &mut Node, at: &[Point<f64>]) {
    let given = n.table["groups"]
        .as_array()
        .is_some_and(|groups| groups[0].get("G").is_some());
    let mean = at.iter().sum::<Point<f64>>() / at.len() as f64;
    if let Some(mut load) = n.child("load") {
        load.set("x_G", mean.x);
        load.set("y_G", mean.y);
    }
    if given || n.has("load") {
        n.keep("tyre", true);
    } else {
        n.remove(&["tyre", "ring", "hydraulics"]);
    }
}

fn catalogue(n: &mut Node) {
    let Some(mut ring) = n.child("ring") else { return };
    let rings = (1..ring.draw.rng.u32(1..4)).map(|i| {
        let (force, moment) = (ring.draw.decades(2, 7), ring.draw.decades(2, 7));
        let curve = |draw: &mut Draw| -> Vec<String> {
            let points = 2 + draw.rng.u32(0..3);
            let point = |k: u32| {
                let part = f64::from(k) / f64::from(points - 1);
                format!("{} N, {} N.m", (part * force).round(), ((1.0 - part) * moment).round())
            };
            (0..points).map(point).collect()
        };
        let mut table = Table::new();
        table.insert("name".to_owned(), format!("R{i}").into());
        table.insert("D_L".to_owned(), format!("{i} m").into());
        table.insert("ring".to_owned(), curve(ring.draw).into());
        table.insert("bolts".to_owned(), curve(ring.draw).into());
        Value::Table(table)
    });
    let rings: Vec<Value> = rings.collect();
    ring.put("catalogue", rings);
}

/// Any command, or straight ahead.
fn command(n: &mut Node, at: &[Point<f64>], corners: [Point<f64>; 4], straight: bool) -> Command {
    const MODES: [&str; 9] = [
        "straight",
        "crab",
        "crosswise",
        "front_axle",
        "rear_axle",
        "all_wheel",
        "pivot",
        "corner",
        "free",
    ];
    let size = n.draw.scale[0];
    let mode = if straight { "straight" } else { n.draw.pick(&MODES) };
    let by = n.draw.pick(&["angle", "radius", "centre"]);
    let corner = n.draw.rng.usize(0..4);
    n.put("mode", mode);
    n.put("command", by);
    n.put(
        "corner",
        ["front_left", "rear_left", "rear_right", "front_right"][corner],
    );
    let far = n.draw.decades(0, 3) * n.draw.pick(&[size, -size]);
    let radius = n.set("R_t", far);
    let line = line(mode, at).map_or_else(|| size * n.draw.between(-2.0, 2.0), |(line, _)| line);
    let aside = n.draw.decades(0, 3) * n.draw.pick(&[size, -size]);
    // The line of centres to the last bit.
    let x = format!("{line:?} m");
    n.put("x_c", x);
    let y = n.set("y_c", aside);
    Command {
        mode,
        by,
        corner: corners[corner],
        radius,
        centre: Point::new(line, y),
    }
}

/// x of the line of turning centres, and the group whose angle commands.
fn line(mode: &str, at: &[Point<f64>]) -> Option<(f64, Point<f64>)> {
    let (front, rear) = (at[0].x, at[at.len() - 1].x);
    match mode {
        "front_axle" => Some((rear, at[0])),
        "rear_axle" => {
            let aside = |p: &&Point<f64>| (p.y - at[0].y).abs();
            let last = at.iter().filter(|p| p.x - rear <= 1e-9 * (front - rear));
            Some((front, *last.min_by(|a, b| aside(a).total_cmp(&aside(b)))?))
        }
        "all_wheel" => Some((f64::midpoint(front, rear), at[0])),
        _ => None,
    }
}

/// Range of the commanded angle, in rad.
fn swept(n: &mut Node, part: f64) -> [f64; 2] {
    let time = n.draw.between(0.3, 3.0);
    let most = FRAC_PI_2 * part;
    let (low, high) = (n.draw.between(-most, most), n.draw.between(-most, most));
    let rows = f64::from(n.draw.rng.u32(1..20));
    let speed = n.draw.scale[0] * n.draw.between(-1.0, 1.0) * f64::from(n.draw.coin(0.9));
    let stands = n.text("fidelity") == Some("kinematic");
    let mut motion = n.child("motion").expect("required");
    if !stands {
        motion.remove(&["input"]);
    }
    let from = motion.set("from", low.min(high) - 0.01 * part);
    let to = motion.set("to", low.max(high) + 0.01 * part);
    motion.set("step", (to - from) / rows);
    motion.set("speed", (to - from) / time);
    motion.set("v_t", speed);
    [from, to]
}

/// Least and greatest heading of all groups over a range of the command (rad), within a right angle of straight ahead;
/// `None` where the mode does not take the command.
fn needs(command: &Command, at: &[Point<f64>], [from, to]: [f64; 2]) -> Option<[f64; 2]> {
    let middle = {
        let y = |sign: f64| sign * at.iter().map(|p| sign * p.y).fold(f64::NEG_INFINITY, f64::max);
        Point::new(
            f64::midpoint(at[0].x, at[at.len() - 1].x),
            f64::midpoint(y(1.0), y(-1.0)),
        )
    };
    let (mut least, mut most) = (0.0_f64, 0.0_f64);
    for i in 0..=200 {
        let theta = from + (to - from) * f64::from(i) / 200.0;
        let (sin, cos) = Calc::sin_cos(theta);
        // The turning centre, or the direction of all groups.
        let about = match (command.mode, command.by) {
            ("straight", _) => Err(Point::new(1.0, 0.0)),
            ("crosswise", _) => Err(Point::new(0.0, 1.0)),
            ("crab", _) => Err(Point::new(cos, sin)),
            ("pivot", _) => Ok(middle),
            ("corner", _) => Ok(command.corner),
            ("free", _) => Ok(command.centre),
            (mode, "angle") => {
                let (line, base) = line(mode, at)?;
                if (base.x - line).abs() < 1e-6 * length(at[0]) {
                    return None;
                }
                let along = (base.x - line) / sin;
                if along.is_finite() {
                    Ok(Point::new(line, base.y + along * cos))
                } else {
                    Err(Point::new(1.0, 0.0))
                }
            }
            (mode, "radius") => Ok(Point::new(line(mode, at)?.0, middle.y + command.radius)),
            _ => Ok(command.centre),
        };
        for p in at {
            let rolling = match about {
                Err(direction) => direction,
                Ok(centre) => Point::new(centre.y - p.y, p.x - centre.x),
            };
            let ahead = if rolling.x < 0.0 { -rolling } else { rolling };
            let heading = if length(ahead) == 0.0 {
                0.0
            } else {
                f64::direction(ahead.x, ahead.y)
            };
            (least, most) = (least.min(heading), most.max(heading));
        }
    }
    Some([least, most])
}

/// Ranges that cover what is needed (rad), of all groups or of each, or none; false where the cylinders do not reach.
fn ranges(n: &mut Node, [least, most]: [f64; 2], stroke: Option<f64>) -> bool {
    let reach = stroke.unwrap_or(PI) - 0.02;
    if least < -reach || most > reach {
        return false;
    }
    let given = n.has("range");
    let ends = [(least, -0.3), (most, 0.3)].map(|(end, more)| (end + more * n.draw.rng.f64()).clamp(-reach, reach));
    let Some(mut range) = n.child("range").filter(|_| given) else {
        return true;
    };
    let min = range.set("min", ends[0] - 0.01);
    let max = range.set("max", ends[1] + 0.01);
    let gap = (max - most) / 4.0;
    let barred = range.draw.coin(0.3) && gap > 0.01 && min < max;
    let text = format!(
        "{:.4} deg, {:.4} deg",
        (most + gap).to_degrees(),
        (most + 2.0 * gap).to_degrees()
    );
    range.put("forbidden", if barred { vec![text] } else { Vec::new() });
    true
}

/// Oil that moves groups of this cylinder in a second or so, and a loop that does not wind up.
fn oil(n: &mut Node) {
    let [arm, bore, stroke] = n
        .child("cylinder")
        .map_or([1.0; 3], |c| ["R_c", "D_g", "l_x"].map(|name| c.get(name)));
    let area = FRAC_PI_4 * bore * bore;
    let supply = n.draw.between(5e6, 3e7);
    let modulus = supply * n.draw.between(30.0, 100.0);
    let flow = area * arm * n.draw.between(0.1, 1.0);
    let stiffness = 4.0 * modulus * area / stroke * arm * arm;
    let frequency = n.draw.between(20.0, 100.0);
    if let Some(mut dynamics) = n.child("dynamics") {
        dynamics.set("J", stiffness / (frequency * frequency));
        dynamics.remove(&["step"]);
    }
    if let Some(mut plc) = n.child("plc") {
        let cycle = plc.draw.between(0.005, 0.1);
        let cycle = plc.set("T_c", cycle);
        let gain = plc.draw.between(0.05, 0.5) / cycle;
        plc.set("k_P", gain);
        if plc.has("k_I") {
            let gain = gain * plc.draw.rng.f64();
            plc.set("k_I", gain);
        }
        if plc.has("u_v_max") {
            let most = plc.draw.between(0.3, 1.0);
            plc.set("u_v_max", most);
        }
    }
    let mut o = n.child("oil").expect("there");
    let mut part = |low: f64, high: f64| o.draw.between(low, high);
    let values = [
        ("V_0", area * stroke * part(0.001, 0.1)),
        ("V_1", area * stroke * part(0.0005, 0.02)),
        ("Q_N", flow),
        ("dp_N", supply * part(0.05, 0.3)),
        ("dp_L", supply * part(0.002, 0.03)),
        ("beta_E", modulus),
        ("p_R", supply * part(1.05, 1.5)),
        ("k_R", flow / supply * part(1.0, 20.0)),
        ("k_L", flow / supply * part(0.0, 1e-3)),
        ("omega_v", part(50.0, 300.0)),
        ("zeta_v", part(0.3, 1.5)),
        ("p_P", supply),
    ];
    for (name, value) in values {
        o.set(name, value);
    }
    if o.has("x_0") {
        let overlap = o.draw.between(0.0, 0.2);
        o.set("x_0", overlap);
    }
    if o.has("tol") {
        let tolerance = o.draw.decades(-7, -3);
        o.set("tol", tolerance);
    }
}

/// Groups in one place, on one line or on the turning centre; as many as there may be, or one more; a centre far away or
/// among the groups; ranges to the last bit.
pub fn edge(n: &mut Node) {
    let size = n.draw.scale[0];
    let choice = n.draw.rng.u8(0..7);
    let mut groups = n.table["groups"].as_array().cloned().unwrap_or_default();
    let put = |group: &mut Value, name: &str, value: f64| {
        group
            .as_table_mut()
            .expect("a group")
            .insert(name.to_owned(), format!("{value:?} m").into());
    };
    match choice {
        0 => groups[1] = groups[0].clone(),
        1 => groups.iter_mut().for_each(|group| put(group, "y", 0.0)),
        2 => {
            let count = n.draw.pick(&[3, 63, 64, 65]);
            while groups.len() > count {
                groups.pop();
            }
            for i in groups.len()..count {
                let mut group = groups[0].clone();
                put(&mut group, "x", -size * (1.1 + 0.1 * i as f64));
                groups.push(group);
            }
        }
        3 => {
            n.put("mode", "free");
            for (name, key) in [("x_c", "x"), ("y_c", "y")] {
                let value = groups[0][key].clone();
                n.put(name, value);
            }
        }
        4 => {
            n.put("command", "radius");
            let mode = n.draw.pick(&["front_axle", "rear_axle", "all_wheel"]);
            n.put("mode", mode);
            let radius = n.draw.pick(&[0.0, 1e-12, 1e5, 1e9, 1e12]) * size;
            n.set("R_t", radius);
        }
        5 => {
            n.put("mode", "crab");
            let end = n.draw.pick(&[FRAC_PI_2, PI, 1.0]);
            let mut motion = n.child("motion").expect("required");
            motion.set("from", -end);
            motion.set("to", end);
            motion.set("step", end / 4.0);
        }
        _ => {
            let mode = n.draw.pick(&["crosswise", "pivot", "corner", "free"]);
            n.put("mode", mode);
        }
    }
    n.put("groups", groups);
}
