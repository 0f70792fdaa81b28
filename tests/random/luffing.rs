//! What makes a luffing scene legal: a linkage built at a random pose, and a working range over which it, its drive and
//! its balance go on from there without a dead point.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::schema::Key;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::luffing::double_link::resisting::PARTS;
use lemnis_models::luffing::double_link::symbols as s;
use lemnis_models::parts::air::AROUND;
use lemnis_models::parts::plane::{Point, cross, length, turned};
use lemnis_models::parts::side_wind::{A_WS, R_WS};
use lemnis_models::parts::slope::{G_U, R_U};
use toml::Table;

use crate::cases::cases;
use crate::control::{Axis, HOIST, LUFFING, SLEWING, controlled, cycle};
use crate::hung;
use crate::led::{begun, led};
use crate::scene::{Draw, Node};

/// A result that every level has.
pub const RESULT: (&str, &Symbol) = ("A.x", &s::A_X);

/// Smallest sine of the angles that vanish in dead points.
const CLEAR: f64 = 0.05;
/// Between the angles at which a range is looked at, in rad.
const STEP: f64 = PI / 360.0;

fn polar(length: f64, angle: f64) -> Point<f64> {
    let (sin, cos) = Calc::sin_cos(angle);
    Point::new(length * cos, length * sin)
}

/// Sine of the angle from one vector to another.
fn sine(a: Point<f64>, b: Point<f64>) -> f64 {
    cross(a, b) / (length(a) * length(b))
}

/// Where two bars from `near` and `far` meet, on the left of the line from `near` to `far` or on its right.
fn meet([near, far]: [Point<f64>; 2], [a, b]: [f64; 2], left: bool) -> Option<Point<f64>> {
    let line = far - near;
    let d = length(line);
    let cos = (d * d + a * a - b * b) / (2.0 * d * a);
    let sin = (1.0 - cos * cos).sqrt() * if left { 1.0 } else { -1.0 };
    let part = a / d;
    sin.is_finite().then(|| near + turned(line, cos * part, sin * part))
}

/// The four bars of a scene.
#[derive(Clone, Copy)]
struct Linkage {
    boom_drives: bool,
    left: bool,
    /// Boom, rear arm of the jib and rocker, in m.
    bars: [f64; 3],
    /// Foot of the rocker from that of the boom, in m.
    o3: Point<f64>,
}

/// Head of the boom and of the rocker at one angle of the driven bar, in m.
struct Pose {
    theta: f64,
    b: Point<f64>,
    c: Point<f64>,
}

impl Linkage {
    fn of(n: &Node) -> Linkage {
        Linkage {
            boom_drives: n.text("driven") == Some("boom"),
            left: n.text("branch") == Some("left"),
            bars: ["X_1", "X_2", "X_3"].map(|name| n.get(name)),
            o3: Point::new(-n.get("X_5"), n.get("X_6")),
        }
    }

    fn at(&self, theta: f64) -> Option<Pose> {
        let ([x_1, x_2, x_3], o1) = (self.bars, Point::new(0.0, 0.0));
        if self.boom_drives {
            let b = polar(x_1, theta);
            let c = meet([self.o3, b], [x_3, x_2], self.left)?;
            Some(Pose { theta, b, c })
        } else {
            let c = self.o3 + polar(x_3, theta);
            let b = meet([o1, c], [x_1, x_2], self.left)?;
            Some(Pose { theta, b, c })
        }
    }

    /// The driven bar and the other one.
    fn driven(&self, pose: &Pose) -> [Point<f64>; 2] {
        let bars = [pose.b, pose.c - self.o3];
        if self.boom_drives { bars } else { [bars[1], bars[0]] }
    }

    /// Angle of the boom, in rad.
    fn boom(&self, pose: &Pose) -> f64 {
        if self.boom_drives {
            pose.theta
        } else {
            f64::direction(pose.b.x, pose.b.y)
        }
    }
}

/// What must keep its sign, and stay clear of zero, over the range.
type Margin = Box<dyn Fn(&Pose) -> f64>;

/// The angles (rad) around a pose at which every margin is as there, up to a turn to each side.
fn reach(linkage: &Linkage, from: f64, margins: &[Margin]) -> Option<[f64; 2]> {
    let signs: Vec<f64> = {
        let pose = linkage.at(from)?;
        margins.iter().map(|margin| margin(&pose).signum()).collect()
    };
    let fine = |theta: f64| {
        let clear = |pose: Pose| {
            margins
                .iter()
                .zip(&signs)
                .all(|(margin, sign)| sign * margin(&pose) > CLEAR)
        };
        linkage.at(theta).is_some_and(clear)
    };
    let end = |way: f64| {
        let steps = (0..720).map(|i| from + way * STEP * f64::from(i));
        steps.take_while(|&theta| fine(theta)).last()
    };
    Some([end(-1.0)?, end(1.0)?])
}

/// A level of a single boom, whether it moves there, whether oil moves it, if any may, and whether its load swings.
pub fn boom_level(draw: &mut Draw, oils: bool) -> (&'static str, [bool; 3]) {
    let level = match oils {
        true => draw.pick(&["static", "table", "rigid", "swing", "hydraulic", "auto"]),
        false => draw.pick(&["static", "table", "rigid", "swing", "auto"]),
    };
    match level {
        "auto" => {
            let moves = draw.coin(0.5);
            let oil = oils && moves && draw.coin(0.5);
            (level, [moves, oil, moves && draw.coin(0.5)])
        }
        "hydraulic" => (level, [true, true, draw.coin(0.5)]),
        _ => (level, [matches!(level, "rigid" | "swing"), false, level == "swing"]),
    }
}

/// Bore of a drive (m) and pressure of its oil (Pa); a machine that its oil carries weighs what its cylinder bears.
pub fn bored(draw: &mut Draw, oil: bool) -> [f64; 2] {
    let length = if oil {
        draw.scale[0].clamp(0.1, 1e3)
    } else {
        draw.scale[0]
    };
    let bore = length * draw.between(0.01, 0.03);
    let pressure = draw.between(1e6, 1e7);
    if oil {
        draw.size(length, 0.2 * pressure * FRAC_PI_4 * bore * bore / draw.g);
    }
    [bore, pressure]
}

/// The tables that a mechanism has at a level, or may have, where it moves, oil moves it, and its load swings.
pub fn moving_parts(n: &mut Node, level: &str, [moves, oil, rope]: [bool; 3]) {
    n.put("fidelity", level);
    n.keep("dynamics", moves);
    n.keep("control", false);
    n.keep("hydraulics", oil);
    if oil {
        n.keep("drive", true);
    }
    let turns = n.draw.coin(0.5);
    n.keep("slewing", moves && turns);
    let hoists = n.draw.coin(0.5);
    n.keep("hoisting", rope && hoists);
    let blows = n.draw.coin(0.5);
    n.keep("air", rope && blows);
    let bears = n.draw.coin(0.5);
    n.keep("ground", rope && hoists && bears);
    if moves {
        n.keep("weights", true);
    }
    if let Some(mut limits) = n.child("limits").filter(|_| !rope) {
        limits.remove(&["phi_max"]);
    }
}

/// Those of a double link.
fn parts(n: &mut Node, level: &str, [moves, oil, rope]: [bool; 3]) {
    moving_parts(n, level, [moves, oil, rope]);
    let tabulated = n.draw.coin(0.5);
    n.keep("table", matches!(level, "table" | "auto") && tabulated);
}

pub fn legal(draw: &mut Draw, keys: &'static [Key]) -> Table {
    let level = draw.pick(&[
        "static",
        "static",
        "table",
        "rigid",
        "swing",
        "swing",
        "hydraulic",
        "auto",
    ]);
    let moves = match level {
        "static" | "table" => false,
        "auto" => draw.coin(0.5),
        _ => true,
    };
    let oil = moves && (level == "hydraulic" || level == "auto" && draw.coin(0.5));
    let rope = moves && (level == "swing" || level != "rigid" && draw.coin(0.5));
    let [bore, pressure] = bored(draw, oil);
    let mut table = draw.table(keys);
    let mut n = Node::new(draw, keys, &mut table);
    parts(&mut n, level, [moves, oil, rope]);
    if n.has("weights") {
        n.keep("Q", true);
    } else {
        n.remove(&["balance", "synthesis"]);
    }
    if let Some(mut drive) = n.child("drive") {
        kind_of_drive(&mut drive, bore, [moves, oil]);
    }
    let (linkage, range) = built(&mut n);
    working_range(&mut n, range);
    rope_over_sheaves(&mut n, &linkage);
    if let Some(mut balance) = n.child("balance") {
        balance.keep(
            "s_5",
            balance.text("kind") == Some("lever") && (moves || balance.has("s_5")),
        );
    }
    if n.child("balance")
        .is_some_and(|balance| balance.text("kind") == Some("straight_rail"))
    {
        n.remove(&["slewing"]);
    }
    if moves {
        let turns = if n.text("driven") == Some("boom") { "J_1" } else { "J_3" };
        dynamics(&mut n, turns, rope, level == "hydraulic");
        begun(&mut n);
    }
    if oil {
        let range = n.child("motion").map(|m| ["from", "to"].map(|name| m.get(name)));
        let range = range.unwrap_or_default();
        hydraulics(&mut n, &linkage, range, |theta| linkage.at(theta), [bore, pressure]);
    }
    limits(&mut n, rope);
    published(&mut n);
    synthesis(&mut n);
    cases(&mut n, &PARTS);
    table
}

/// Sheaves at the boom's head, and at the rocker's where the jib's head is far from that.
fn rope_over_sheaves(n: &mut Node, linkage: &Linkage) {
    let ([x_1, x_2, x_3], x_4) = (linkage.bars, n.get("X_4"));
    let apart = (x_4 - x_2).abs();
    let bars = [
        ("boom", x_1, 0.5 * x_4),
        ("jib", 0.0, 0.5 * x_4),
        ("rocker", x_3, 0.5 * apart),
    ];
    led(n, &bars, x_1 + x_2 + x_3 + x_4 + length(linkage.o3));
}

/// A linkage that something else carries, with its working range.
fn carried(n: &mut Node) {
    let (_, range) = built(n);
    working_range(n, range);
}

/// A luffing mechanism on something of a weight (N), of which its bars weigh little; it begins where its range does.
pub fn aboard(n: &mut Node, weight: f64) {
    let (size, g) = (n.draw.scale[0], n.draw.g);
    let mut bars = n.child("luffing").expect("it luffs");
    bars.keep("balance", false);
    bars.keep("weights", true);
    bars.keep("dynamics", true);
    carried(&mut bars);
    let mut bodies = bars.child("weights").expect("kept");
    for (heavy, far) in [("G_1", "s_1"), ("G_2", "s_2"), ("G_3", "s_3")] {
        let part = bodies.draw.between(1e-4, 1e-3);
        bodies.set(heavy, part * weight);
        let part = bodies.draw.between(0.0, 0.5);
        bodies.set(far, part * size);
    }
    let mut inertias = bars.child("dynamics").expect("kept");
    for name in ["J_1", "J_2", "J_3"] {
        let part = inertias.draw.between(0.0, 1e-4);
        inertias.set(name, (part * weight / g * size * size).min(1e17));
    }
    n.remove(&["theta_1"]);
}

/// Load (N) and reach (m) of a crane on something of a weight (N), or the luffing mechanism that gives the reach; whether it luffs.
pub fn load(n: &mut Node, weight: f64, far: f64) -> bool {
    let luffs = n.has("luffing");
    let (load, reach) = (n.draw.between(0.0, 0.1), n.draw.between(0.0, 0.5));
    // Bars may reach far.
    n.set("Q", weight * if luffs { 0.02 * load } else { load });
    n.keep("R", !luffs);
    if luffs {
        aboard(n, weight);
    } else {
        n.set("R", far * reach);
        n.remove(&["theta_1", "h_1"]);
    }
    luffs
}

/// The linkage with what hangs on it, and the angles (rad) over which it works.
fn built(n: &mut Node) -> (Linkage, [f64; 2]) {
    for tries in 0.. {
        let linkage = pose(n);
        let start = n.draw.between(-PI, TAU);
        if length(linkage.o3) < 0.01 * n.draw.scale[0] {
            continue;
        }
        let mut margins: Vec<Margin> = vec![Box::new(move |p| sine(p.c - p.b, linkage.driven(p)[1]))];
        let kind = n.child("drive").and_then(|drive| drive.text("kind").map(str::to_owned));
        match kind.as_deref() {
            None | Some("sector") => {}
            Some("crank") => {
                let Some(pose) = linkage.at(start) else { continue };
                margins.extend(crank(n, &linkage, &pose));
            }
            Some(_) => margins.push(drive(n, &linkage)),
        }
        if n.has("balance") {
            // The boom must not turn back.
            if !linkage.boom_drives {
                margins.push(Box::new(move |p| sine(p.c - p.b, p.c - linkage.o3)));
            }
            let Some(pose) = linkage.at(start) else { continue };
            margins.extend(balance(n, linkage, &pose, tries > 50));
        }
        if let Some(range) = reach(&linkage, start, &margins).filter(|[from, to]| to - from > 0.05) {
            return (linkage, range);
        }
    }
    unreachable!("one of many fits")
}

/// A drive of any kind as thick as this (m), with what its kind has but anchors; of a mechanism that moves, or by oil.
fn kind_of_drive(drive: &mut Node, bore: f64, [moves, oil]: [bool; 2]) {
    let cylinder = oil || drive.draw.coin(0.5);
    let kind = match cylinder {
        true => "cylinder",
        false if moves => drive.draw.pick(&["rack", "rope"]),
        false if drive.draw.coin(0.2) => "rack",
        false => drive.draw.pick(&["screw", "sector", "crank", "rope"]),
    };
    drive.put("kind", kind);
    drive.remove(&[
        "D_c", "d_r", "r_z", "eta_d", "d_2", "p_h", "mu_d", "beta_d", "r_s", "delta_s", "r_cr", "l_cr", "branch",
        "m_r", "r_tr",
    ]);
    if cylinder {
        let thick = drive.draw.between(0.0, 0.8) * f64::from(drive.draw.coin(0.9));
        let bore = drive.set("D_c", bore);
        drive.set("d_r", bore * thick);
    }
    let (screw, sector) = (kind == "screw", kind == "sector");
    if sector {
        drive.remove(&["E_x", "E_y", "s_d", "chi_d"]);
        let radius = drive.draw.scale[0] * drive.draw.between(0.01, 1.0);
        drive.set("r_s", radius);
        let direction = drive.draw.angle();
        drive.set("delta_s", direction);
    }
    if kind == "rope" {
        let falls = drive.draw.between(1.0, 8.0).round();
        drive.set("m_r", falls);
        let drum = (bore * drive.draw.between(0.5, 3.0)).max(LEAST_LENGTH);
        drive.set("r_tr", drum);
    }
    if ["crank", "rope"].contains(&kind) {
        let efficiency = drive.draw.between(0.5, 1.0);
        drive.set("eta_d", efficiency);
    }
    if screw || sector || kind == "rack" && !moves && drive.draw.coin(0.5) {
        shaft(drive, bore, screw);
    }
}

/// A screw, or a pinion, for a drive as thick as this (m).
fn shaft(drive: &mut Node, thick: f64, screw: bool) {
    if !screw {
        let radius = thick * drive.draw.between(0.5, 3.0);
        drive.set("r_z", radius.max(LEAST_LENGTH));
        let efficiency = drive.draw.between(0.5, 1.0);
        drive.set("eta_d", efficiency);
        return;
    }
    let diameter = drive.set("d_2", thick);
    let lead = (diameter * drive.draw.between(0.05, 1.5)).max(LEAST_LENGTH);
    drive.set("p_h", lead);
    let friction = drive.draw.between(0.0, 0.5);
    drive.set("mu_d", friction);
    let flank = drive.draw.between(0.0, 0.5);
    drive.set("beta_d", flank);
}

/// Least length that a scene may give, in m.
pub const LEAST_LENGTH: f64 = 1e-4;

/// A frame and bars of any size.
fn pose(n: &mut Node) -> Linkage {
    let size = n.draw.scale[0];
    let side = |n: &mut Node| size * n.draw.between(0.2, 2.0);
    for name in ["X_1", "X_2", "X_3", "X_4"] {
        let value = side(n);
        n.set(name, value);
    }
    for name in ["X_5", "X_6", "X_8"] {
        let value = size * n.draw.between(-1.0, 1.0) * f64::from(n.draw.coin(0.85));
        n.set(name, value);
    }
    let [rear, front] = [n.get("X_2"), n.get("X_4")];
    n.remove(&["X_7", "beta_0", "AC"]);
    let way = n.draw.between(-0.95, 0.95);
    match n.draw.rng.u8(0..3) {
        0 => n.set("X_7", way * rear.min(front)),
        1 => n.set("beta_0", PI * (1.0 + way)),
        _ => n.set("AC", rear.max(front) + way * rear.min(front)),
    };
    Linkage::of(n)
}

/// A crank with its rod that works at a pose, and what it needs to go on: neither crank and rod, nor rod and arm in one line.
fn crank(n: &mut Node, linkage: &Linkage, pose: &Pose) -> [Margin; 2] {
    let (size, linkage) = (n.draw.scale[0], *linkage);
    let mut d = n.child("drive").expect("there");
    let (centre, [arm, turn]) = anchors(&mut d, size);
    let [joint, ..] = driving(&linkage, pose, centre, arm, turn);
    let pin = Point::new(size, size).map(|size| size * d.draw.between(-1.0, 1.0));
    let left = cross(joint - centre, pin - centre) > 0.0;
    d.put("branch", if left { "left" } else { "right" });
    let bars = [d.set("r_cr", length(pin - centre)), d.set("l_cr", length(pin - joint))];
    let lines = move |pose: &Pose| {
        let [joint, _, arm] = driving(&linkage, pose, centre, arm, turn);
        meet([centre, joint], bars, left).map(|pin| [pin - centre, joint - pin, arm])
    };
    [
        Box::new(move |pose| lines(pose).map_or(f64::NAN, |[crank, rod, _]| sine(crank, rod))),
        Box::new(move |pose| lines(pose).map_or(f64::NAN, |[_, rod, arm]| sine(arm, rod))),
    ]
}

fn drive(n: &mut Node, linkage: &Linkage) -> Margin {
    let (size, linkage) = (n.draw.scale[0], *linkage);
    let mut d = n.child("drive").expect("there");
    let (anchor, [arm, turn]) = anchors(&mut d, size);
    Box::new(move |pose| {
        let [_, line, arm] = driving(&linkage, pose, anchor, arm, turn);
        sine(arm, line)
    })
}

/// A drive of a bar about the origin that works all over these angles of it, in rad, and limits of what there is.
pub fn drive_about_origin(n: &mut Node, [from, to]: [f64; 2], [moves, oil]: [bool; 2], [bore, pressure]: [f64; 2]) {
    if let Some(mut drive) = n.child("drive") {
        kind_of_drive(&mut drive, bore, [moves, oil]);
    }
    let kind = n.child("drive").and_then(|drive| drive.text("kind").map(str::to_owned));
    let linkage = Linkage {
        boom_drives: true,
        left: true,
        bars: [1.0; 3],
        o3: Point::zeros(),
    };
    let at = |theta: f64| Pose {
        theta,
        b: polar(1.0, theta),
        c: polar(1.0, theta),
    };
    let middle = at(f64::midpoint(from, to));
    while let Some(kind) = kind.as_deref().filter(|kind| *kind != "sector") {
        let margins: Vec<Margin> = match kind {
            "crank" => crank(n, &linkage, &middle).into(),
            _ => vec![drive(n, &linkage)],
        };
        let works = |margin: &Margin| {
            let sign = margin(&middle).signum();
            (0..=100).all(|i| sign * margin(&at(from + (to - from) * f64::from(i) / 100.0)) > CLEAR)
        };
        if margins.iter().all(works) {
            break;
        }
    }
    if oil {
        hydraulics(n, &linkage, [from, to], |theta| Some(at(theta)), [bore, pressure]);
    }
    limits(n, false);
}

/// Anchor on the frame, and distance and direction of the one on the driven bar.
fn anchors(d: &mut Node, size: f64) -> (Point<f64>, [f64; 2]) {
    let anchor = Point::new(size, size).map(|size| size * d.draw.between(-1.0, 1.0));
    let anchor = Point::new(d.set("E_x", anchor.x), d.set("E_y", anchor.y));
    let arm = size * d.draw.between(0.1, 1.0);
    let arm = d.set("s_d", arm);
    let turn = d.draw.angle();
    (anchor, [arm, d.set("chi_d", turn)])
}

/// Anchor on the driven bar, the line to it from the one on the frame, and from the bar's foot, in m.
fn driving(linkage: &Linkage, pose: &Pose, anchor: Point<f64>, arm: f64, turn: f64) -> [Point<f64>; 3] {
    let foot = if linkage.boom_drives {
        Point::new(0.0, 0.0)
    } else {
        linkage.o3
    };
    let arm = polar(arm, pose.theta + turn);
    [foot + arm, foot + arm - anchor, arm]
}

/// Keeps what a balance needs and takes away what others need.
fn balance_keys(b: &mut Node, needed: &[&str]) {
    for name in [
        "branch", "G_c", "r_c", "chi_c", "d_1", "delta_1", "r_1", "alpha_K", "l_1", "R_1", "chi_5", "M_5", "H_x",
        "H_y", "lambda", "L_r", "y_0", "phi_0",
    ] {
        b.keep(name, needed.contains(&name));
    }
}

/// A balance of any kind that works at a pose, and what it needs to go on.
#[expect(clippy::too_many_lines, reason = "one kind after the other")]
fn balance(n: &mut Node, linkage: Linkage, pose: &Pose, simple: bool) -> Vec<Margin> {
    let (size, phi) = (n.draw.scale[0], linkage.boom(pose));
    let weights = n.child("weights").map_or([0.0; 9], |w| {
        ["G_1", "s_1", "chi_1", "G_2", "s_2", "chi_2", "G_3", "s_3", "chi_3"].map(|name| w.get(name))
    });
    let mut b = n.child("balance").expect("there");
    let kind = match simple {
        true => "tail",
        // A curved rail comes through less often than the others.
        false => b.draw.pick(&[
            "tail",
            "parallelogram",
            "lever",
            "straight_rail",
            "curved_rail",
            "curved_rail",
            "curved_rail",
        ]),
    };
    b.put("kind", kind);
    let needed: &[&str] = match kind {
        "tail" => &["G_c", "r_c", "chi_c"],
        "parallelogram" => &["G_c", "r_c", "chi_c", "r_1", "alpha_K", "d_1", "delta_1"],
        "lever" => &[
            "branch", "d_1", "delta_1", "r_1", "alpha_K", "l_1", "R_1", "chi_5", "M_5",
        ],
        "straight_rail" => &["G_c", "r_1", "alpha_K", "H_x", "H_y", "lambda"],
        _ => &["G_c", "r_1", "alpha_K", "L_r", "y_0", "phi_0"],
    };
    balance_keys(&mut b, needed);
    let (r_1, alpha) = (b.get("r_1"), b.get("alpha_K"));
    let joint = move |pose: &Pose| polar(r_1, linkage.boom(pose) + alpha);
    let k = polar(r_1, phi + alpha);
    match kind {
        "tail" => Vec::new(),
        "parallelogram" => {
            let rod = polar(1.0, b.get("delta_1"));
            vec![Box::new(move |p| sine(joint(p), rod))]
        }
        "lever" => {
            let pivot = polar(b.get("d_1"), b.get("delta_1"));
            let place = Point::new(0.5, 0.5).map(|part| size * part * b.draw.between(-1.0, 1.0));
            let left = cross(k - pivot, place - pivot) > 0.0;
            b.put("branch", if left { "left" } else { "right" });
            let bars = [length(place - pivot), length(place - k)];
            let bars = [b.set("R_1", bars[0]), b.set("l_1", bars[1])];
            vec![Box::new(move |p| {
                let joint = joint(p);
                meet([pivot, joint], bars, left).map_or(f64::NAN, |end| sine(end - joint, end - pivot))
            })]
        }
        "straight_rail" => {
            let slope = b.draw.between(0.0, PI / 2.0);
            b.set("lambda", slope);
            let pulley = Point::new(b.get("H_x"), b.get("H_y"));
            vec![Box::new(move |p| length(pulley - joint(p)) / r_1)]
        }
        _ => {
            let weigh = weights[0] + weights[3] + weights[6];
            let weight = weigh * b.draw.between(0.5, 3.0);
            let weight = b.set("G_c", weight);
            let rope = size * b.draw.between(0.5, 3.0);
            let rope = b.set("L_r", rope);
            let height = k.y - rope * b.draw.between(-0.8, 0.8);
            let height = b.set("y_0", height);
            b.set("phi_0", phi);
            let energy = move |pose: &Pose| {
                let [g_1, s_1, chi_1, g_2, s_2, chi_2, g_3, s_3, chi_3] = weights;
                let on = |bar: Point<f64>, s: f64, chi: f64| polar(s, f64::direction(bar.x, bar.y) + chi);
                let jib = pose.b + on(pose.c - pose.b, s_2, chi_2);
                let rocker = linkage.o3 + on(pose.c - linkage.o3, s_3, chi_3);
                g_1 * on(pose.b, s_1, chi_1).y + g_2 * jib.y + g_3 * rocker.y
            };
            let start = energy(pose);
            let line = move |p: &Pose| {
                let up = joint(p).y - (height - (energy(p) - start) / weight);
                Point::new((rope * rope - up * up).sqrt(), up)
            };
            let pulls = move |p: &Pose| {
                // The boom's weights and the rope turn it to opposite sides.
                let ends = [-1e-4, 1e-4].map(|step| linkage.at(p.theta + step));
                let [Some(before), Some(after)] = ends else {
                    return f64::NAN;
                };
                let turned = (linkage.boom(&after) - linkage.boom(&before) + PI).rem_euclid(TAU) - PI;
                let moment = (energy(&before) - energy(&after)) / turned;
                moment * cross(joint(p), line(p)) / (weigh * size * size)
            };
            vec![
                Box::new(move |p| line(p).x / rope),
                Box::new(move |p| sine(joint(p), line(p))),
                Box::new(move |p| if pulls(p) > 1e-6 { 1.0 } else { f64::NAN }),
            ]
        }
    }
}

/// A balance at the tail of a single boom, where there is one, and limits of what there is without it.
pub fn tail_balance(n: &mut Node) {
    if let Some(mut balance) = n.child("balance") {
        balance.put("kind", "tail");
        balance_keys(&mut balance, &["G_c", "r_c", "chi_c"]);
        balance.remove(&["s_5"]);
    }
    let balanced = n.has("balance");
    if let Some(mut limits) = n.child("limits") {
        limits.remove(&["gamma_min", "N_max"]);
        if !balanced {
            limits.remove(&["dM_max"]);
        }
    }
}

/// A part of the angles (rad) over which the linkage works, or several turns.
pub fn working_range(n: &mut Node, [from, to]: [f64; 2]) {
    let (size, time) = (to - from, n.draw.scale[2]);
    let (part, rest) = (n.draw.between(0.02, 1.0), n.draw.rng.f64());
    let whole = size >= 2.0 * (TAU - STEP);
    let part = if whole && n.draw.coin(0.3) { part * 3.0 } else { part };
    let from = from + rest * (1.0 - part).max(0.0) * size;
    let rows = if n.draw.coin(0.95) {
        n.draw.rng.u32(1..30)
    } else {
        n.draw.rng.u32(30..2000)
    };
    let lasts = time * n.draw.decades(0, 2);
    let stands = matches!(n.text("fidelity"), None | Some("static" | "table"));
    let mut motion = n.child("motion").expect("required");
    if !stands {
        motion.remove(&["input"]);
    }
    let from = motion.set("from", from);
    let to = motion.set("to", from + part * size);
    motion.set("step", (to - from) / f64::from(rows));
    motion.set("speed", (to - from) / lasts);
}

/// A hoist with its rope, with the falls of a tackle where these stand elsewhere, under a load (N), for a run of a duration (s).
fn hoisting(h: &mut Node, load: f64, lasts: f64, falls: Option<f64>) {
    let drum = ["J_h", "r_h", "m_h", "M_Fh", "M_Mh", "M_Bh"];
    let motor = h.draw.coin(0.5) && h.knows(drum[0]);
    reeled(h, true, lasts);
    if motor {
        h.remove(&["v_h", "a_h"]);
        let radius = h.draw.scale[0] * h.draw.between(0.005, 0.05);
        let radius = h.set("r_h", radius.max(1e-4));
        let own = f64::from(h.draw.rng.u32(1..8));
        let falls = falls.unwrap_or_else(|| h.set("m_h", own));
        // As heavy as the load, as the rope feels it, or a tenth.
        let weight = load.max(1e-3 * h.draw.scale[1] * h.draw.g);
        let inertia = weight / h.draw.g * (radius / falls).powi(2) * h.draw.between(0.1, 1.0);
        h.set("J_h", inertia.max(1e-9));
        let hold = weight * radius / falls;
        for (name, part) in [("M_Mh", 1.0), ("M_Fh", 0.1), ("M_Bh", 0.5)] {
            if h.has(name) {
                let part = part * h.draw.between(0.5, 1.2) * f64::from(h.draw.coin(0.8));
                h.set(name, hold * part);
            }
        }
    } else {
        h.remove(&drum);
    }
    let gives = load > 0.0 && h.draw.coin(0.5);
    h.keep("c_R", gives);
    let damped = h.draw.coin(0.5);
    h.keep("d_R", gives && damped);
    if gives {
        let stretch = h.get("l_R") * h.draw.between(0.02, 0.2);
        let stiffness = h.set("c_R", load / stretch);
        if h.has("d_R") {
            let damping = 2.0 * (stiffness * load / h.draw.g).sqrt() * h.draw.between(0.0, 0.3);
            h.set("d_R", damping);
        }
    }
}

/// What is said of a rope, and how fast it is reeled, for a run of a duration (s).
fn reeled(d: &mut Node, rope: bool, lasts: f64) {
    let [length, _, time] = d.draw.scale;
    d.keep("l_R", rope);
    let reel = d.draw.coin(0.5);
    d.keep("v_h", rope && reel);
    let ramp = d.draw.coin(0.5);
    d.keep("a_h", rope && ramp);
    let aside = d.draw.coin(0.7);
    d.keep("phi_R", rope && aside);
    if !rope {
        return;
    }
    let long = length * d.draw.between(0.3, 3.0);
    let long = d.set("l_R", long);
    if reel {
        let speed = long / lasts * d.draw.between(-0.5, 0.3);
        let speed = d.set("v_h", speed);
        if ramp {
            let gain = (speed.abs() / time * d.draw.between(0.1, 2.0)).clamp(1e-3, 1e3);
            d.set("a_h", gain);
        }
    } else if ramp {
        let gain = (long / time.powi(2) * d.draw.between(0.01, 0.5)).clamp(1e-3, 1e3);
        d.set("a_h", gain);
    }
}

/// Air around a load, which takes no more of its speed than swinging does.
pub fn air(n: &mut Node, long: f64, slews: bool) {
    let load = n.get("Q");
    let mut air = n.child("air").expect("there");
    let (mass, swings) = (air.draw.scale[1].max(load / air.draw.g), (air.draw.g / long).sqrt());
    air.set("Q_air", mass * air.draw.g);
    let damping = mass * swings * air.draw.between(0.0, 1.0);
    air.set("d_Q", damping);
    let (density, drag) = (air.draw.between(0.5, 2.0), air.draw.between(0.1, 2.0));
    air.set("rho_air", density);
    air.set("c_wQ", drag);
    let area = mass * swings / (0.5 * density * drag * 70.0) * air.draw.between(0.0, 1.0);
    air.set("A_Q", area);
    if air.has("v_air") {
        let speed = air.draw.between(-30.0, 30.0);
        air.set("v_air", speed);
    }
    air.keep("chi_air", slews && air.has("chi_air"));
}

/// Ground below any place that the head may be at, at times above where the load hangs.
fn ground(n: &mut Node) {
    let bars = ["X_1", "X_2", "X_3", "X_4", "X_5", "X_6", "l", "f_A", "a", "c"];
    let there = bars.into_iter().filter(|name| n.has(name)).collect::<Vec<_>>();
    let head: f64 = there.into_iter().map(|name| n.get(name).abs()).sum();
    let long = n.child("hoisting").expect("there").get("l_R");
    let mut ground = n.child("ground").expect("there");
    let below = long * ground.draw.between(0.1, 1.5);
    ground.set("y_G", -head - below);
}

/// What moves a mechanism; `turns` names the inertia of a body that does.
pub fn dynamics(n: &mut Node, turns: &str, rope: bool, oil: bool) {
    let [length, mass, time] = n.draw.scale;
    let inertia = mass * length * length;
    let lasts = n
        .child("motion")
        .map_or(0.0, |m| (m.get("to") - m.get("from")) / m.get("speed"));
    let roped = hung::by_rope(n.table);
    let mut d = n.child("dynamics").expect("there");
    // Something that turns has inertia, whatever else has none.
    let own = inertia * d.draw.between(0.3, 3.0);
    d.set(turns, own);
    // Once is enough.
    d.remove(&["g"]);
    d.keep("step", true);
    let step = time * d.draw.between(0.004, 0.02);
    d.set("step", step);
    if d.has("t_s") {
        let ramp = lasts * d.draw.decades(-2, 1);
        d.set("t_s", ramp);
    }
    for (name, size) in [
        ("c_v", own / time),
        ("M_F", own / time.powi(2)),
        ("M_A", own / time.powi(2)),
    ] {
        if d.has(name) {
            let value = size * d.draw.between(0.0, 0.5) * f64::from(d.draw.coin(0.8));
            d.set(name, value);
        }
    }
    if oil {
        d.remove(&["M_A", "M_S"]);
    } else if roped {
        // Which way a rope pulls, a motor does not know.
        d.remove(&["M_A"]);
    }
    if n.has("hoisting") {
        let load = n.get("Q");
        let mut dynamics = n.child("dynamics").expect("there");
        dynamics.remove(&["l_R", "phi_R", "v_h", "a_h"]);
        let falls = ["rope", "hoist_rope"]
            .into_iter()
            .find_map(|name| n.child(name).map(|led| led.get("m_h")));
        let mut hoist = n.child("hoisting").expect("there");
        if falls.is_some() {
            hoist.remove(&["m_h"]);
        }
        hoisting(&mut hoist, load, lasts, falls);
    } else {
        reeled(&mut n.child("dynamics").expect("there"), rope, lasts);
    }
    if let Some(mut turning) = n.child("slewing") {
        let inertia = inertia * turning.draw.between(0.3, 30.0);
        turning.set("J_sl", inertia);
        let viscous = inertia / time * turning.draw.between(0.1, 1.0);
        let viscous = turning.set("c_sl", viscous);
        turning.keep("chi_R", rope);
        let speed = turning.draw.between(-0.5, 0.5) / time;
        for (name, value) in [("omega_sl", speed), ("M_sl", viscous * speed)] {
            if turning.has(name) {
                turning.set(name, value);
            }
        }
        let start = turning.get("psi_sl");
        for (name, sign) in [("psi_min", -1.0), ("psi_max", 1.0)] {
            if turning.has(name) {
                let stop = start + sign * turning.draw.between(0.01, 3.0);
                turning.set(name, stop);
            }
        }
        if let Some(mut slope) = turning.child("slope") {
            leaning(&mut slope, inertia);
        }
    }
    controls(n, own, !oil && !roped, lasts);
    if !n.has("hydraulics") {
        unsampled(n);
    }
    let gives = n.child("hoisting").is_some_and(|hoist| hoist.has("c_R"));
    n.keep("ground", gives && n.has("ground"));
    if n.has("ground") {
        ground(n);
    }
    windy(n, rope);
}

/// Air around a load on a rope, if any, and wind on what slews, where it has an area.
fn windy(n: &mut Node, rope: bool) {
    let side = n.child("slewing").is_some_and(|turning| turning.has("A_ws"));
    if side {
        n.keep("air", true);
    }
    if n.has("air") {
        let table = if n.has("hoisting") { "hoisting" } else { "dynamics" };
        let long = if rope {
            n.child(table).expect("there").get("l_R")
        } else {
            1.0
        };
        let slews = n.has("slewing");
        air(n, long, slews);
    }
    if side && !rope {
        n.child("air").expect("kept").remove(&AROUND);
    }
    if n.has("slewing") {
        aside(n, side);
    }
}

/// Where there is an area of what slews, one that its wind turns by a radian in a natural time or later.
fn aside(n: &mut Node, side: bool) {
    let wind = n.child("air").map(|air| pressure(&air));
    let mut turning = n.child("slewing").expect("there");
    turning.keep("r_ws", side);
    if let Some(pressure) = wind.filter(|_| side) {
        let inertia = turning.get("J_sl");
        area(&mut turning, pressure, inertia);
    }
}

/// Pressure of the wind of a table of the air, in Pa.
pub fn pressure(air: &Node) -> f64 {
    0.5 * air.get("rho_air").max(1.225) * air.get("v_air").powi(2)
}

/// An area that a pressure (Pa) turns by a radian in a natural time or later, with an inertia (kg·m²).
pub fn area(n: &mut Node, pressure: f64, inertia: f64) {
    let place = n.draw.natural(&R_WS) * n.draw.between(-1.0, 1.0);
    let most = inertia / n.draw.scale[2].powi(2) / (pressure * place.abs()).max(1e-300);
    let own = most.min(n.draw.natural(&A_WS)) * n.draw.between(0.0, 1.0);
    n.set("r_ws", place);
    n.set("A_ws", own);
}

/// A slope on which a weight turns what slews, with an inertia (kg·m²), by a radian in a natural time or later.
fn leaning(n: &mut Node, inertia: f64) {
    let steep = n.draw.between(0.0, 0.2);
    n.set("gamma_s", steep);
    let place = n.draw.natural(&R_U) * n.draw.between(-1.0, 1.0);
    let most = inertia / n.draw.scale[2].powi(2) / place.abs().max(1e-300);
    let weight = most.min(n.draw.natural(&G_U)) * n.draw.between(0.0, 1.0);
    n.set("r_u", place);
    n.set("G_u", weight);
}

/// Controllers of luffing with an inertia (kg·m²) where it may have one, of slewing, and of a hoist's motor, for a run of a duration (s).
fn controls(n: &mut Node, inertia: f64, luffing: bool, lasts: f64) {
    let (length, time, cycle) = (n.draw.scale[0], n.draw.scale[2], cycle(n));
    let some = n.draw.coin(0.3);
    n.keep("control", some && luffing);
    let range = n
        .child("motion")
        .map_or([0.0; 2], |m| ["from", "to"].map(|name| m.get(name)));
    if let Some(mut control) = n.child("control") {
        let speed = (range[1] - range[0]) / lasts * control.draw.between(-1.0, 1.0);
        controlled(&mut control, &LUFFING, inertia, speed, range, cycle);
        n.child("dynamics").expect("there").remove(&[LUFFING.moment]);
    }
    if let Some(mut turning) = n.child("slewing") {
        let (inertia, start) = (turning.get("J_sl"), turning.get("psi_sl"));
        if let Some(mut control) = turning.child("control") {
            let speed = control.draw.between(-0.5, 0.5) / time;
            controlled(
                &mut control,
                &SLEWING,
                inertia,
                speed,
                [start - 1.0, start + 1.0],
                cycle,
            );
            turning.remove(&[SLEWING.moment]);
        }
    }
    if let Some(mut hoist) = n.child("hoisting") {
        let motor = hoist.has("J_h");
        let some = hoist.draw.coin(0.3);
        hoist.keep("control", motor && some);
        let inertia = hoist.get("J_h") * hoist.get("m_h").max(1.0) / hoist.get("r_h").max(LEAST_LENGTH);
        let rope = hoist.get("l_R");
        if let Some(mut control) = hoist.child("control") {
            let speed = length.min(rope) / lasts.max(time) * control.draw.between(-0.3, 0.3);
            controlled(&mut control, &HOIST, inertia, speed, [0.9 * rope, 1.1 * rope], cycle);
            hoist.remove(&[HOIST.moment]);
        }
    }
}

/// Each controller of luffing, slewing and hoist.
fn each_control(n: &mut Node, act: &mut dyn FnMut(&mut Node, &Axis)) {
    if let Some(mut control) = n.child("control") {
        act(&mut control, &LUFFING);
    }
    for (table, axis) in [("slewing", &SLEWING), ("hoisting", &HOIST)] {
        if let Some(mut drive) = n.child(table)
            && let Some(mut control) = drive.child("control")
        {
            act(&mut control, axis);
        }
    }
}

/// Controllers may do without samples, all of them, and then not as quickly.
fn unsampled(n: &mut Node) {
    if n.draw.coin(0.5) {
        each_control(n, &mut |control, axis| {
            let [k_p, k_i, cycle, ..] = axis.settings;
            for (name, less) in [(k_p, 20.0), (k_i, 400.0)] {
                let gain = control.get(name) / less;
                control.set(name, gain);
            }
            control.remove(&[cycle]);
        });
    }
}

/// Its cylinder is as long as the line of the drive over these angles of the driving link, in rad.
fn hydraulics(
    n: &mut Node,
    linkage: &Linkage,
    [from, to]: [f64; 2],
    pose: impl Fn(f64) -> Option<Pose>,
    [bore, pressure]: [f64; 2],
) {
    let time = n.draw.scale[2];
    let d = n.child("drive").expect("there");
    let [x, y, arm, turn] = ["E_x", "E_y", "s_d", "chi_d"].map(|name| d.get(name));
    let at = |i: i32| {
        let pose = pose(from + (to - from) * f64::from(i) / 100.0)?;
        Some(length(driving(linkage, &pose, Point::new(x, y), arm, turn)[1]))
    };
    let lengths = || (0..=100).filter_map(at);
    let (shortest, longest) = (lengths().fold(f64::INFINITY, f64::min), lengths().fold(0.0, f64::max));
    let area = FRAC_PI_4 * bore * bore;
    let mut o = n.child("hydraulics").expect("there");
    let (slack, supply) = (o.draw.between(0.8, 0.99), pressure * o.draw.between(1.5, 4.0));
    let [l_min, l_max] = [shortest * slack, longest / slack];
    let flow = area * (l_max - l_min) / time * o.draw.between(0.05, 1.0);
    let oil = area * arm;
    let mut part = |low: f64, high: f64| o.draw.between(low, high);
    let values = [
        ("l_min", l_min),
        ("l_max", l_max),
        ("V_0", oil * part(0.001, 0.1)),
        ("V_1", oil * part(0.0003, 0.01)),
        ("Q_N", flow),
        ("dp_N", supply * part(0.05, 0.3)),
        ("dp_L", supply * part(0.002, 0.03)),
        ("beta_E", supply * part(20.0, 300.0)),
        ("p_R", supply * part(1.05, 1.5)),
        ("k_R", flow / supply * part(1.0, 20.0)),
        ("omega_v", part(10.0, 200.0) / time),
        ("zeta_v", part(0.3, 1.5)),
        ("p_P", supply),
    ];
    for (name, value) in values {
        o.set(name, value);
    }
    let leak = flow / supply * o.draw.decades(-6, -3) * f64::from(o.draw.coin(0.7));
    o.set("k_L", leak);
    if o.has("u_v") {
        let opening = o.draw.between(-1.0, 1.0);
        o.set("u_v", opening);
    }
    oil_parts(&mut o, [supply, flow]);
    if o.has("tol") {
        let tolerance = o.draw.decades(-7, -3);
        o.set("tol", tolerance);
    }
}

/// Each whole or absent, at a pressure of the pump and a flow of the valve.
fn oil_parts(o: &mut Node, [supply, flow]: [f64; 2]) {
    let mut part = |low: f64, high: f64| o.draw.between(low, high);
    let draws = [("p_ac", part(0.0, 9e4)), ("k_ac", (flow / part(1e3, 1e5)).min(0.5))];
    let holds = [
        ("p_lh", supply * part(0.1, 1.2)),
        ("i_lh", part(0.0, 10.0)),
        ("dp_lh", supply * part(0.05, 1.0)),
        ("x_T", part(0.0, 0.2)),
    ];
    let torn = [("y_b1", part(0.0, 1.0)), ("y_b2", part(0.0, 1.0))];
    let limits = [
        ("Q_Pmax", flow * part(0.1, 3.0)),
        ("P_Pmax", supply * flow * part(0.05, 2.0)),
    ];
    let there = [0; 3].map(|_| o.draw.coin(0.5));
    let tears = there[1] && o.draw.coin(0.5);
    let tank = [("p_tank", o.draw.decades(3, 6))];
    let pressed = o.draw.coin(0.3);
    for (parts, there) in [
        (&draws[..], there[0]),
        (&holds, there[1]),
        (&torn, tears),
        (&limits, there[2]),
        (&tank, pressed),
    ] {
        for (name, value) in parts {
            if there {
                o.set(name, *value);
            } else {
                o.remove(&[name]);
            }
        }
    }
}

/// Only limits of what there is.
fn limits(n: &mut Node, rope: bool) {
    let kind = n
        .child("balance")
        .and_then(|balance| balance.text("kind").map(str::to_owned));
    let level = n.text("fidelity").map(str::to_owned);
    let screw = n.child("drive").is_some_and(|drive| drive.has("d_2"));
    let winds = n.has("Q") && n.child("drive").is_some_and(|drive| drive.has("m_r"));
    let torque = winds || n.has("Q") && (screw || n.child("drive").is_some_and(|drive| drive.has("r_z")));
    let Some(mut limits) = n.child("limits") else { return };
    if !torque {
        limits.remove(&["T_d_out_max", "T_d_in_max"]);
    }
    if !screw {
        limits.remove(&["lock_d"]);
    }
    if !winds {
        limits.remove(&["S_l_max"]);
    }
    let none: &[&str] = match kind.as_deref() {
        None => &["dM_max", "gamma_min", "N_max"],
        Some("tail") => &["gamma_min", "N_max"],
        Some("straight_rail" | "curved_rail") => &["gamma_min"],
        _ => &[],
    };
    limits.remove(none);
    if !rope || level.is_none() {
        limits.remove(&["phi_max"]);
    }
}

fn published(n: &mut Node) {
    let [from, to] = n
        .child("motion")
        .map_or([0.0; 2], |m| ["from", "to"].map(|name| m.get(name)));
    let angle = if n.text("driven") == Some("boom") {
        "theta_1"
    } else {
        "theta_3"
    };
    let Some(mut published) = n.child("published") else {
        return;
    };
    let mut text = format!("{angle} R A.y\n");
    for _ in 0..published.draw.rng.u32(0..4) {
        let theta = published.draw.between(from, to).to_degrees();
        text += &format!("{theta:.3} {:.2} -0.00\n", published.draw.between(-9.0, 9.0));
    }
    published.put("values", text);
}

/// Of a lever, and quickly read: the search itself has tests of its own.
fn synthesis(n: &mut Node) {
    if n.child("balance")
        .is_none_or(|balance| balance.text("kind") != Some("lever"))
    {
        n.remove(&["synthesis"]);
    }
    let Some(mut task) = n.child("synthesis") else { return };
    task.remove(&["positions", "candidates", "bounds", "found", "objective"]);
    task.put("method", "optimum");
    if let Some(mut keeps) = task.child("constraints") {
        let least = keeps.draw.between(0.0, 1.0);
        keeps.set("gamma_min", least);
        keeps.remove(&["M_plus"]);
    }
    if let Some(mut tolerances) = task.child("tolerances") {
        let part = tolerances.draw.between(0.0, 0.5);
        tolerances.set("weight", part);
    }
}

/// Ends at dead points, change points within the range, drives that point at the foot, full turns, nothing that weighs.
#[expect(clippy::too_many_lines, reason = "one edge after the other")]
pub fn edge(n: &mut Node) {
    let linkage = Linkage::of(n);
    let size = n.draw.scale[0];
    match n.draw.rng.u8(0..9) {
        // Up to a dead point, or a little beside it.
        0 | 1 => {
            let ends = n
                .child("motion")
                .map_or([0.0; 2], |m| ["from", "to"].map(|name| m.get(name)));
            let (way, [mut inside, mut outside]) = if n.draw.coin(0.5) {
                ("from", [ends[0], ends[0] - PI])
            } else {
                ("to", [ends[1], ends[1] + PI])
            };
            while (outside - inside).abs() > 1e-15 * size.max(1.0) {
                let middle = f64::midpoint(inside, outside);
                if middle == inside || middle == outside {
                    break;
                }
                if linkage.at(middle).is_some() {
                    inside = middle
                } else {
                    outside = middle
                }
            }
            let beside = n.draw.pick(&[0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3]) * n.draw.pick(&[1.0, -1.0]);
            let text = format!("{:?} rad", inside + beside);
            let mut motion = n.child("motion").expect("required");
            motion.put(way, text);
        }
        // Change points: a parallelogram, a kite, a rhombus.
        2 | 3 => {
            let (a, f) = (n.set("X_1", size), size * n.draw.between(0.2, 2.0));
            let f = n.set("X_5", f);
            n.set("X_6", 0.0);
            let (coupler, follower) = n.draw.pick(&[(f, a), (a, f), (a, a)]);
            n.set("X_2", coupler);
            n.set("X_3", follower);
            n.remove(&["X_7", "AC"]);
            n.set("beta_0", PI);
            let (from, turn) = (
                n.draw.pick(&[0.0, -PI, -0.1, 0.5]),
                n.draw.pick(&[PI, TAU, 2.0, 3.0 * TAU]),
            );
            let mut motion = n.child("motion").expect("required");
            motion.set("from", from);
            motion.set("to", from + turn);
            motion.set("step", turn / 12.0);
        }
        // A drive that points at the foot somewhere, or everywhere.
        4 => {
            n.keep("drive", true);
            let nowhere = n.draw.coin(0.3);
            let mut d = n.child("drive").expect("kept");
            if nowhere {
                d.set("E_x", 0.0);
                d.set("E_y", 0.0);
            } else {
                let turn = d.draw.angle();
                d.set("chi_d", turn);
            }
        }
        // A crank, for several turns.
        5 => {
            for (name, part) in [("X_1", 0.2), ("X_2", 0.9), ("X_3", 0.8), ("X_5", 0.7), ("X_6", 0.0)] {
                n.set(name, part * size);
            }
            let turns = n.draw.between(0.5, 5.0);
            let mut motion = n.child("motion").expect("required");
            let from = motion.get("from");
            let to = motion.set("to", from + turns * TAU);
            motion.set("step", (to - from) / 20.0);
        }
        // Feet in one place.
        6 => {
            n.set("X_5", 0.0);
            n.set("X_6", 0.0);
        }
        // Nothing that weighs, or turns.
        7 => {
            n.set("Q", 0.0);
            for (table, names) in [("weights", ["G_1", "G_2", "G_3"]), ("dynamics", ["J_1", "J_2", "J_3"])] {
                let some = n.draw.coin(0.7);
                if let Some(mut inner) = n.child(table).filter(|_| some) {
                    for name in names {
                        inner.set(name, 0.0);
                    }
                }
            }
        }
        // A jib folded or stretched.
        _ => {
            let [rear, front] = [n.get("X_2"), n.get("X_4")];
            n.remove(&["X_7", "beta_0", "AC"]);
            let axis = n.draw.pick(&[rear + front, (rear - front).abs()]);
            n.set("AC", axis);
        }
    }
}
