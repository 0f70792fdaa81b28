//! Everything a book says about the steering of a machine.

use crate::calc::Calc;
use crate::model::{Role, Type};
use crate::plane::{self, Point};
use crate::record::{Rec, record};
use crate::scene::{Place, Scene};
use crate::sheet::{
    Changes, Check, Comparison, Curve, Drawing, Input, Section, Sensitivity, Shape, Sheet, Summary, Table, View, Worked,
};
use crate::steering::changes::changes;
use crate::steering::cylinder::{EXAMPLE_STROKES, choose_stroke};
use crate::steering::load::resistance;
use crate::steering::machine::{Limits, Machine};
use crate::steering::mode::{Centre, Command, Mode};
use crate::steering::model::Model;
use crate::steering::moving::scene::Moving;
use crate::steering::outputs::{Built, By, Evaluation, Inputs, Output};
use crate::steering::published::Layout;
use crate::steering::reach::{Reach, nearest, reach, stand};
use crate::steering::ring::{Duty, friction};
use crate::steering::scene::Steering;
use crate::steering::searched::{Search, Searched};
use crate::steering::sizing::{BORES, Demand, Rod, bore, buckling, flow, force, greatest_demand, next, pump, relief};
use crate::steering::swept::moved;
use crate::steering::symbols as s;
use crate::steering::wheels::{one, rate, residual};
use crate::symbol::Symbol;

/// Points of a drawn curve.
const CURVE: u32 = 240;

/// The sheet of a scene with this steering.
#[must_use]
pub fn sheet(scene: &Scene, steering: &Steering) -> Sheet {
    let built = steering.parameters.build().expect("checked when the scene was read");
    let model = Model::new(steering).expect("a scene that was read has a machine");
    let demands = demands(steering, &built);
    let demand = demands
        .iter()
        .map(|(_, demand)| demand)
        .max_by(|a, b| a.flow.total_cmp(&b.flow));
    let changes = changes(steering, &built);
    let pumped = pumped(demand, changes.as_ref());
    let (governing, worst) = governing(steering, demand);
    let middle = f64::midpoint(steering.motion.from, steering.motion.to);
    let place = |place: &Place| match *place {
        Place::At(theta) => ("chosen", theta),
        Place::Named("from") => ("from", steering.motion.from),
        Place::Named("to") => ("to", steering.motion.to),
        Place::Named("governing") => worst.map_or(("middle", middle), |(theta, _)| ("greatest_force", theta)),
        Place::Named(_) => ("middle", middle),
    };
    let places = match scene.book.positions.as_slice() {
        [] => vec![place(&Place::Named("governing"))],
        places => places.iter().map(place).collect(),
    };
    let group = worst.map_or(0, |(_, group)| group);
    Sheet {
        inputs: inputs(scene, steering),
        constants: constants(steering, &built),
        views: Mode::ALL
            .into_iter()
            .filter_map(|mode| view(steering, &built, mode))
            .collect(),
        sizing: sizing(steering, &built, pumped),
        positions: places
            .into_iter()
            .map(|(id, theta)| worked(steering, &built, id, theta, group))
            .collect(),
        range: table(steering),
        curves: curves(steering, &built),
        drawing: swept(&built, &standing(steering, &built, steering.inputs.clone())),
        checks: checks(steering, &built, pumped),
        warnings: Vec::new(),
        published: Vec::<Comparison>::new(),
        balance: None,
        motion: None,
        assumptions: assumptions(steering),
        published_source: None,
        summary: summary(steering, &built, pumped),
        sensitivity: Sensitivity {
            results: Vec::new(),
            rows: Vec::new(),
        },
        governing,
        outputs: model
            .variables()
            .iter()
            .filter(|variable| variable.role == Role::Output && variable.kind == Type::Real)
            .map(|variable| variable.symbol)
            .collect(),
        remarks: remarks(steering, &built),
        demands: demands
            .iter()
            .map(|(mode, demand)| {
                let summary = Summary {
                    symbol: &s::Q_MODE,
                    value: demand.flow,
                    at: Some((&s::THETA_B, demand.at)),
                };
                (mode.id(), summary)
            })
            .collect(),
        changes,
    }
}

/// The evaluation of a scene at other inputs.
pub(super) fn evaluation(steering: &Steering, inputs: Inputs<f64>) -> Evaluation<f64> {
    Evaluation::new(steering.parameters.clone(), inputs)
}

fn at(steering: &Steering, theta_b: f64) -> Inputs<f64> {
    Inputs {
        theta_b,
        ..steering.inputs.clone()
    }
}

fn inputs(scene: &Scene, steering: &Steering) -> Vec<Input> {
    let mut inputs = Vec::new();
    let mut add = |chapter: &'static str, key: String, symbol: &'static Symbol, number: Option<u16>, value: f64| {
        inputs.push(Input {
            symbol,
            number,
            value,
            chapter,
            given: scene.given(&key).cloned(),
        });
    };
    let Steering { parameters, motion, .. } = steering;
    let (mut groups, mut others) = (Vec::new(), Vec::new());
    parameters.map(&mut |(symbol, number), value| match number {
        Some(number) => groups.push((symbol, number, value)),
        None => others.push((symbol, value)),
    });
    groups.sort_by_key(|(_, number, _)| *number);
    for (symbol, number, value) in groups {
        let key = format!("steering.groups[{number}].{}", symbol.id);
        add("groups", key, symbol, Some(number), value);
    }
    if let Some([front, rear, left, right]) = parameters.outline {
        let sides = [
            (&s::E_F, "front", front),
            (&s::E_R, "rear", rear),
            (&s::E_LEFT, "left", left),
        ];
        for (symbol, name, value) in sides.into_iter().chain([(&s::E_RIGHT, "right", right)]) {
            add("outline", format!("steering.outline.{name}"), symbol, None, value);
        }
    }
    for (symbol, name) in [(&s::THETA_MIN, "min"), (&s::THETA_MAX, "max")] {
        if let Some(given) = scene.given(&format!("steering.range.{name}")) {
            let end = usize::from(name == "max");
            if let Some(range) = parameters.groups.iter().find_map(|group| group.range) {
                add("range", given.key.clone(), symbol, None, range[end]);
            }
        }
    }
    for (number, group) in (1..).zip(&parameters.groups) {
        for [from, to] in &group.forbidden {
            add("range", String::new(), &s::BARRED_FROM, Some(number), *from);
            add("range", String::new(), &s::BARRED_TO, Some(number), *to);
        }
    }
    match steering.weight {
        Some((weight, centre)) => {
            add("load", "steering.load.W".to_owned(), &s::W, None, weight);
            add("load", "steering.load.x_G".to_owned(), &s::X_G, None, centre.x);
            add("load", "steering.load.y_G".to_owned(), &s::Y_G, None, centre.y);
        }
        None => {
            for (number, load) in (1..).zip(&steering.inputs.loads) {
                add(
                    "load",
                    format!("steering.groups[{number}].G"),
                    &s::G,
                    Some(number),
                    *load,
                );
            }
        }
    }
    for (symbol, value) in others {
        let table = ["tyre", "ring", "cylinder", "accuracy", "transition"].into_iter();
        let key = table.map(|table| format!("steering.{table}.{}", symbol.id));
        let key = key
            .into_iter()
            .find(|key| scene.given(key).is_some())
            .unwrap_or_default();
        let chapter = match key.split('.').nth(1) {
            Some("tyre") => "tyre",
            Some("ring") => "ring",
            Some("accuracy") => "accuracy",
            Some("transition") => "transition",
            _ => "cylinder",
        };
        add(chapter, key, symbol, None, value);
        if let Some(limit) = steering.slip_limit.filter(|_| symbol == &s::B_V) {
            add(
                chapter,
                "steering.accuracy.slip_limit".to_owned(),
                &s::SLIP_LIMIT,
                None,
                limit,
            );
        }
    }
    if let Some(hydraulics) = steering.hydraulics {
        hydraulics.map(&mut |symbol, value| {
            add(
                "hydraulics",
                format!("steering.hydraulics.{}", symbol.id),
                symbol,
                None,
                value,
            );
        });
    }
    if let Some(Moving { body, oil, plc }) = steering.moving {
        // What the solver takes by default is no input of the book.
        let mut table = |chapter: &'static str, symbol: &'static Symbol, value: f64| {
            let key = format!("steering.{chapter}.{}", symbol.id);
            if scene.given(&key).is_some() {
                add(chapter, key, symbol, None, value);
            }
        };
        body.map(&mut |symbol, value| table("dynamics", symbol, value));
        oil.map(&mut |symbol, value| table("oil", symbol, value));
        plc.map(&mut |symbol, value| table("plc", symbol, value));
    }
    let motion = [
        ("from", &s::FROM, motion.from),
        ("to", &s::TO, motion.to),
        ("speed", &s::OMEGA_S, motion.speed),
        ("v_t", &s::V_T, steering.inputs.v_t),
    ];
    for (name, symbol, value) in motion {
        add("motion", format!("steering.motion.{name}"), symbol, None, value);
    }
    inputs
}

fn section(id: &'static str, equations: impl FnOnce()) -> Section {
    let (trace, ()) = record(equations);
    Section {
        id,
        trace,
        drawing: None,
        table: None,
    }
}

fn given(symbol: &'static Symbol, value: f64) -> Rec {
    Rec::given(symbol, value)
}

fn constants(steering: &Steering, built: &Built<f64>) -> Vec<Section> {
    let machine = &built.machine;
    let mut list = vec![section("middle", || {
        let two = Rec::constant(2.0);
        let _ = ((given(&s::X_F, machine.front) + given(&s::X_R, machine.rear)) / two).def(&s::X_M);
        let _ = ((given(&s::Y_L, machine.left) + given(&s::Y_R, machine.right)) / two).def(&s::Y_M);
    })];
    if let Some(cylinder) = &steering.parameters.cylinder {
        list.push(Section {
            drawing: Some(triangle(built)),
            ..section("linkage", || {
                let _ = cylinder.map(&mut Rec::given).linkage(false);
            })
        });
    }
    list
}

/// The linkage that the book's formulas speak of: a direct one, if there is one.
fn linkage(built: &Built<f64>) -> Option<usize> {
    let direct = built.linkages.iter().position(|linkage| !linkage.mirrored);
    direct.or((!built.linkages.is_empty()).then_some(0))
}

/// The triangle of the cylinder straight ahead, and faint at both ends of the range. [Zhang2016, Fig. 5 and 6]
fn triangle(built: &Built<f64>) -> Drawing {
    let Some(index) = linkage(built) else {
        return Drawing::default();
    };
    let (linkage, limits) = (&built.linkages[index], &built.limits[index]);
    let point = |p: Point<f64>| [p.x, p.y];
    let (o, b) = ([0.0, 0.0], point(linkage.b));
    let mut shapes = Vec::new();
    for (theta, faint) in [(limits.min, true), (limits.max, true), (0.0, false)] {
        let (sin, cos) = Calc::sin_cos(theta);
        let c = point(plane::turned(linkage.c, cos, sin));
        for points in [vec![o, c], vec![b, c]] {
            shapes.push(Shape::Body {
                points,
                closed: false,
                faint,
            });
        }
        shapes.push(Shape::Pin {
            at: c,
            fixed: false,
            faint,
        });
        if !faint {
            shapes.push(Shape::Label { at: c, text: "c" });
        }
    }
    for (at, text) in [(o, "o"), (b, "b")] {
        shapes.push(Shape::Pin {
            at,
            fixed: true,
            faint: false,
        });
        shapes.push(Shape::Label { at, text });
    }
    let size = plane::length(linkage.c);
    shapes.push(Shape::Arrow {
        from: o,
        to: [1.3 * size, 0.0],
    });
    shapes.push(Shape::Angle {
        at: o,
        radius: 0.6 * size,
        from: 0.0,
        to: f64::direction(linkage.c.x, linkage.c.y),
        text: s::ALPHA.print,
    });
    Drawing { shapes }
}

/// How the machine stands at some inputs.
struct Standing {
    centre: Centre<f64>,
    /// Headings (rad) and rolling speeds (m/s).
    wheels: Vec<[f64; 2]>,
    reachable: bool,
}

fn standing(steering: &Steering, built: &Built<f64>, inputs: Inputs<f64>) -> Standing {
    let command = inputs.command();
    let centre = inputs
        .mode
        .centre(&built.machine, command)
        .expect("checked by the caller");
    let mut evaluation = evaluation(steering, inputs);
    let mut get = |output| evaluation.output(output).expect("the command has a centre");
    Standing {
        centre,
        wheels: (0..built.machine.groups.len())
            .map(|i| [get(Output::Theta(i)), get(Output::V(i))])
            .collect(),
        reachable: get(Output::Reachable) != 0.0,
    }
}

/// The machine from above: outline, wheels turned, axle lines to the turning centre.
fn plan(built: &Built<f64>, standing: &Standing) -> Drawing {
    let machine = &built.machine;
    let point = |p: Point<f64>| [p.x, p.y];
    let size = (machine.front - machine.rear).max(machine.left - machine.right);
    let (half, wide) = (0.05 * size, 0.02 * size);
    let mut shapes = vec![Shape::Body {
        points: machine.corners.iter().map(|p| point(*p)).collect(),
        closed: false,
        faint: true,
    }];
    if let Some(Shape::Body { points, .. }) = shapes.first_mut() {
        points.push(points[0]);
    }
    // A centre that is too far away for the paper is not drawn: the axle lines point to it.
    let centre = standing
        .centre
        .point()
        .filter(|at| plane::length(at - machine.middle) <= 1.6 * size);
    for (p, [theta, _]) in machine.groups.iter().zip(&standing.wheels) {
        let (sin, cos) = Calc::sin_cos(*theta);
        let across = Point::new(-sin, cos);
        let to = match centre {
            Some(at) => at,
            None => {
                let towards = standing.centre.point().map_or(across, |at| at - p);
                let sign = if plane::dot(across, towards) < 0.0 { -1.0 } else { 1.0 };
                p + across * (sign * 0.2 * size)
            }
        };
        shapes.push(Shape::Axis {
            from: point(*p),
            to: point(to),
        });
    }
    for (number, (p, [theta, v])) in (1..).zip(machine.groups.iter().zip(&standing.wheels)) {
        let (sin, cos) = Calc::sin_cos(*theta);
        for aside in [-1.0, 1.0] {
            let corner = |ahead: f64, out: f64| {
                point(p + plane::turned(Point::new(ahead * half, aside * wide + out * 0.7 * wide), cos, sin))
            };
            shapes.push(Shape::Body {
                points: vec![
                    corner(1.0, 1.0),
                    corner(-1.0, 1.0),
                    corner(-1.0, -1.0),
                    corner(1.0, -1.0),
                ],
                closed: true,
                faint: false,
            });
        }
        if *v != 0.0 {
            let along = Point::new(cos, sin) * v.signum();
            shapes.push(Shape::Arrow {
                from: point(p + along * half),
                to: point(p + along * (2.4 * half)),
            });
        }
        let aside = if p.y >= machine.middle.y { 1.0 } else { -1.0 };
        shapes.push(Shape::Number {
            at: [p.x - 1.6 * half, p.y + aside * 2.7 * half],
            number,
        });
    }
    if let Some(at) = centre {
        shapes.push(Shape::Pin {
            at: point(at),
            fixed: false,
            faint: false,
        });
        shapes.push(Shape::Label {
            at: point(at),
            text: "O",
        });
    }
    Drawing { shapes }
}

/// The machine from above with the paths that its corners sweep while it travels its own length.
fn swept(built: &Built<f64>, standing: &Standing) -> Drawing {
    let machine = &built.machine;
    let mut drawing = plan(built, standing);
    let fastest = machine
        .groups
        .iter()
        .map(|p| plane::length(standing.centre.rolling(*p)));
    let (fastest, whole) = (fastest.fold(0.0, f64::max), machine.front - machine.rear);
    for corner in &machine.corners {
        let at = |i: u32| moved(&standing.centre, fastest, *corner, whole * f64::from(i) / 24.0);
        let points = (0..=24).map(|i| [at(i).x, at(i).y]).collect();
        drawing.shapes.push(Shape::Path { points });
    }
    drawing
}

/// What a mode is shown with: the scene's own command in its own mode, elsewhere
/// one that all groups can follow, as far as there is one.
pub(super) fn example(steering: &Steering, built: &Built<f64>, mode: Mode) -> Option<Inputs<f64>> {
    let (machine, limits) = (&built.machine, &built.limits);
    let motion = &steering.motion;
    let greatest = if motion.to.abs() >= motion.from.abs() {
        motion.to
    } else {
        motion.from
    };
    let of = |theta_b: f64| Inputs {
        mode,
        by: if mode == steering.inputs.mode {
            steering.inputs.by
        } else {
            By::Angle
        },
        theta_b,
        ..steering.inputs.clone()
    };
    let follows = |inputs: &Inputs<f64>| matches!(reach(machine, limits, mode, inputs.command()), Ok(Reach::Reachable));
    let exists = |inputs: &Inputs<f64>| mode.centre(machine, inputs.command()).is_ok();
    let whole = of(0.7 * greatest);
    if !matches!(whole.command(), Command::Angle(_)) {
        return Some(whole).filter(exists);
    }
    // Half of that, and so on, until all groups can follow; the other way round if none do.
    let tries = [1.0, -1.0].map(|sign| (0..6).map(move |n| of(sign * 0.7 * greatest / f64::from(1 << n))));
    tries.into_iter().flatten().find(follows).or(Some(whole)).filter(exists)
}

fn view(steering: &Steering, built: &Built<f64>, mode: Mode) -> Option<View> {
    let inputs = example(steering, built, mode)?;
    let command = match inputs.command() {
        Command::Angle(theta) => Some((&s::THETA_B, theta)),
        Command::Radius(radius) => Some((&s::R_T, radius)),
        _ => None,
    };
    let (machine, limits) = (&built.machine, &built.limits);
    let nearest = nearest(machine, limits, mode, inputs.command());
    let standing = standing(steering, built, inputs);
    let nearest = nearest.filter(|_| !standing.reachable);
    let mut columns = vec![&s::NUMBER, &s::THETA, &s::V];
    let mut angles = vec![0.0; limits.len()];
    if let Some(centre) = nearest.and_then(|(mode, command)| mode.centre(machine, command).ok()) {
        columns.push(&s::THETA_N);
        stand(machine, limits, &centre, &mut angles);
    }
    let row = |(number, ([theta, v], angle)): (u32, (&[f64; 2], &f64))| {
        let cells = [f64::from(number), *theta, *v, *angle];
        cells[..columns.len()].to_vec()
    };
    let rows = (1..).zip(standing.wheels.iter().zip(&angles)).map(row).collect();
    let told = |(mode, command): (Mode, Command<f64>)| {
        let command = match command {
            Command::Angle(theta) => vec![(&s::THETA_BN, theta)],
            Command::Radius(radius) => vec![(&s::R_TN, radius)],
            Command::Centre(at) => vec![(&s::O_NX, at.x), (&s::O_NY, at.y)],
            Command::None | Command::Corner(_) => Vec::new(),
        };
        (mode.id(), command)
    };
    Some(View {
        id: mode.id(),
        command,
        reachable: standing.reachable,
        nearest: nearest.map(told),
        table: Table { columns, rows },
        drawing: plan(built, &standing),
    })
}

/// The formulas at one commanded angle for one group, each part as its own section.
fn worked(steering: &Steering, built: &Built<f64>, id: &'static str, theta: f64, group: usize) -> Worked {
    let mut sections = Vec::new();
    let mut seen = 0;
    for (stage, id) in STAGES.iter().enumerate() {
        let (mut trace, ()) = record(|| chain(steering, built, theta, group, stage));
        let new = trace.steps.split_off(seen.min(trace.steps.len()));
        seen += new.len();
        trace.steps = new;
        if !trace.steps.is_empty() {
            sections.push(Section {
                id,
                trace,
                drawing: None,
                table: (*id == "slip").then(|| slip_table(steering, theta)),
            });
        }
    }
    Worked {
        id,
        coordinate: &s::THETA_B,
        value: theta,
        of: Some(group + 1),
        sections,
    }
}

const STAGES: [&str; 7] = ["centre", "heading", "rates", "cylinder", "forces", "flow", "slip"];

/// Runs the equations under the recorder up to a stage.
fn chain(steering: &Steering, built: &Built<f64>, theta: f64, group: usize, stage: usize) {
    let inputs = at(steering, theta);
    let (machine, mode) = (&built.machine, inputs.mode);
    let base = machine.line(mode).map_or(machine.base, |(_, base)| base);
    let named = Machine {
        groups: vec![
            Point::new(
                given(&s::X_B, machine.groups[base].x),
                given(&s::Y_B, machine.groups[base].y),
            ),
            Point::new(
                given(&s::X_I, machine.groups[group].x),
                given(&s::Y_I, machine.groups[group].y),
            ),
        ],
        corners: machine
            .corners
            .iter()
            .map(|p| Point::new(given(&s::O_X, p.x), given(&s::O_Y, p.y)))
            .collect(),
        base: 0,
        rear_base: 0,
        front: given(&s::X_F, machine.front),
        rear: given(&s::X_R, machine.rear),
        left: given(&s::Y_L, machine.left),
        right: given(&s::Y_R, machine.right),
        middle: Point::new(given(&s::X_M, machine.middle.x), given(&s::Y_M, machine.middle.y)),
    };
    let theta_b = given(&s::THETA_B, theta);
    let command = match inputs.command() {
        Command::None => Command::None,
        Command::Angle(_) => Command::Angle(theta_b),
        Command::Radius(radius) => Command::Radius(given(&s::R_T, radius)),
        Command::Centre(at) => Command::Centre(Point::new(given(&s::O_CX, at.x), given(&s::O_CY, at.y))),
        Command::Corner(corner) => Command::Corner(corner),
    };
    let centre = mode.centre(&named, command).expect("checked when the scene was read");
    let _ = centre.point();
    if stage == 0 {
        return;
    }
    let p = named.groups[1];
    let real = mode
        .centre(machine, inputs.command())
        .expect("checked when the scene was read");
    let fastest = machine
        .groups
        .iter()
        .map(|p| plane::length(real.rolling(*p)))
        .fold(0.0, f64::max);
    let along = centre.rolling(p);
    // A direction alone has no length to be named.
    let (along, length, fastest) = match real {
        Centre::Far(_) => (along, plane::length(along), Rec::constant(fastest)),
        _ => {
            let along = plane::def(along, [&s::U_X, &s::U_Y]);
            (along, plane::length(along).def(&s::U), given(&s::U_MAX, fastest))
        }
    };
    let scale = given(&s::V_T, inputs.v_t) / fastest;
    let wheel = one(along, length, scale, Rec::constant(0.0));
    if let Some(w) = centre.turning() {
        let _ = (w * scale).def(&s::OMEGA);
    }
    if stage == 1 {
        return;
    }
    let omega = match (command, mode.slope(&named, theta_b)) {
        (Command::Angle(_), Some(slope)) if !matches!(real, Centre::Far(_)) => {
            let change = plane::def(slope.rolling(p), [&s::UD_X, &s::UD_Y]);
            let rate = plane::cross(along, change) / plane::dot(along, along);
            (rate * given(&s::OMEGA_S, inputs.omega_s)).def(&s::OMEGA_I)
        }
        (Command::Angle(_), Some(slope)) => {
            (rate(&centre, &slope, p) * given(&s::OMEGA_S, inputs.omega_s)).def(&s::OMEGA_I)
        }
        _ => return,
    };
    if stage == 2 {
        return;
    }
    let Some(cylinder) = &steering.parameters.cylinder else {
        return;
    };
    let linkage = crate::steering::cylinder::Linkage {
        c: Point::new(
            given(&s::C_X, built.linkages[group].c.x),
            given(&s::C_Y, built.linkages[group].c.y),
        ),
        b: Point::new(
            given(&s::B_X, built.linkages[group].b.x),
            given(&s::B_Y, built.linkages[group].b.y),
        ),
        l_0: given(&s::L_0, built.linkages[group].l_0),
        mirrored: built.linkages[group].mirrored,
    };
    let _ = cylinder;
    let pose = linkage.at(wheel.turn);
    if stage == 3 {
        return;
    }
    if let (Some(tyre), Some(load)) = (&steering.parameters.tyre, inputs.loads.get(group)) {
        let _ = forces(steering, tyre.map(&mut Rec::given), given(&s::G, *load), pose.od);
    }
    if stage == 4 {
        return;
    }
    if let Some(piston) = &steering.parameters.piston {
        let speed = (omega * pose.od).def(&s::V_C);
        let _ = flow(&piston.map(&mut Rec::given), speed);
    }
    if stage == 5 {
        return;
    }
    if let Some(accuracy) = &steering.parameters.accuracy {
        let error = accuracy.map(&mut Rec::given).angle_error(pose.od);
        // Were the machine to keep its motion; what it gives way follows from all groups together.
        let _ = (wheel.v.abs() * error.sin() / given(&s::V_T, inputs.v_t).abs()).def(&s::SLIP_ALONE);
    }
}

/// Greatest slip of each group at a commanded angle.
fn slips(steering: &Steering, theta: f64) -> Vec<f64> {
    let (mut evaluation, n) = (
        evaluation(steering, at(steering, theta)),
        steering.parameters.groups.len(),
    );
    let mut search = Search::new(n);
    let of = |i| {
        search
            .get(&mut evaluation, Searched::Slip(i))
            .expect("the working range was checked")
    };
    (0..n).map(of).collect()
}

/// Error and slip of all groups.
fn slip_table(steering: &Steering, theta: f64) -> Table {
    let row = |(i, slip): (usize, f64)| {
        let of = |output: Output| value(steering, theta, output);
        vec![(1 + i) as f64, of(Output::Od(i)), of(Output::Delta(i)), slip]
    };
    Table {
        columns: vec![&s::NUMBER, &s::OD, &s::DELTA, &s::SLIP],
        rows: slips(steering, theta).into_iter().enumerate().map(row).collect(),
    }
}

/// The greatest of all groups.
fn slip(steering: &Steering, theta: f64) -> f64 {
    slips(steering, theta).into_iter().fold(0.0, f64::max)
}

/// Moments and forces of a group at a lever arm, standing and travelling.
fn forces(steering: &Steering, tyre: crate::steering::load::Tyre<Rec>, load: Rec, od: Rec) -> Rec {
    let found = resistance(&tyre, load);
    let drag = steering
        .parameters
        .bearing
        .map(|bearing| friction(&bearing.map(&mut Rec::given), load));
    let with = |moment: Rec, symbol| match drag {
        Some(drag) => (moment + drag).def(symbol),
        None => moment.def(symbol),
    };
    let f_g = force(with(found.standing, &s::T_G), od);
    let _ = (with(found.travelling, &s::T_GX) / od.abs()).def(&s::F_GX);
    f_g
}

/// The greatest simultaneous oil flow of each mode that an angle commands.
fn demands(steering: &Steering, built: &Built<f64>) -> Vec<(Mode, Demand)> {
    let Some(piston) = steering.parameters.piston else {
        return Vec::new();
    };
    let modes = [Mode::Crab, Mode::FrontAxle, Mode::RearAxle, Mode::AllWheel];
    let found = modes.into_iter().filter_map(|mode| {
        let omega_s = steering.motion.speed;
        let demand = greatest_demand(&built.machine, &built.limits, &built.linkages, &piston, mode, omega_s);
        Some((mode, demand.ok().filter(|demand| demand.flow > 0.0)?))
    });
    found.collect()
}

/// What the pump must deliver: the greatest flow of steering or, where that is more, of a change of mode.
fn pumped(demand: Option<&Demand>, changes: Option<&Changes>) -> Option<(&'static Symbol, f64)> {
    let changing = changes.into_iter().flat_map(|changes| &changes.rows);
    let changing = changing.filter_map(|change| Some((&s::Q_X_MAX, change.flow?)));
    let steering = demand.map(|demand| (&s::Q_MAX, demand.flow));
    let all: Vec<(&'static Symbol, f64)> = steering.into_iter().chain(changing).collect();
    all.into_iter().reduce(|a, b| if b.1 > a.1 { b } else { a })
}

/// Ends and smallest lever arm of all cylinders over their groups' ranges.
fn extremes(built: &Built<f64>) -> Option<[f64; 3]> {
    let each = built.linkages.iter().zip(&built.limits);
    let each = each.map(|(linkage, limits)| linkage.over(limits).expect("checked when the scene was read"));
    each.map(|e| [e.longest, e.shortest, e.od_min])
        .reduce(|[a, b, c], [d, e, f]| [a.max(d), b.min(e), c.min(f)])
}

/// Greatest load of a group, in N.
fn heaviest(steering: &Steering) -> Option<f64> {
    steering.inputs.loads.iter().copied().reduce(f64::max)
}

fn sizing(steering: &Steering, built: &Built<f64>, pumped: Option<(&'static Symbol, f64)>) -> Vec<Section> {
    let mut list = Vec::new();
    let parameters = &steering.parameters;
    let (load, tyre) = (heaviest(steering), parameters.tyre);
    if let Some((load, bearing)) = load.zip(parameters.bearing) {
        list.push(section("ring", || {
            let _ = Duty::new(&bearing.map(&mut Rec::given), given(&s::G_MAX, load));
        }));
    }
    let Some(([longest, shortest, od_min], cylinder)) = extremes(built).zip(parameters.cylinder) else {
        return list;
    };
    list.push(section("stroke", || {
        let cylinder = cylinder.map(&mut Rec::given);
        let _ = cylinder.stroke_margins(given(&s::R_LONG, longest), given(&s::R_SHORT, shortest));
    }));
    let Some((load, tyre)) = load.zip(tyre) else {
        return list;
    };
    let mut f_max = 0.0;
    list.push(section("force", || {
        let load = given(&s::G_MAX, load);
        let standing = resistance(&tyre.map(&mut Rec::given), load).standing;
        let moment = match parameters.bearing {
            Some(bearing) => standing + friction(&bearing.map(&mut Rec::given), load),
            None => standing,
        };
        let f_g = (moment.def(&s::T_G_MAX) / given(&s::OD_MIN, od_min)).def(&s::F_G_MAX);
        f_max = f_g.value();
    }));
    let Some((h, piston)) = steering.hydraulics.zip(parameters.piston) else {
        return list;
    };
    list.push(section("bore", || {
        let _ = bore(given(&s::F_G_MAX, f_max), given(&s::P, h.p), given(&s::D, piston.d));
    }));
    if let Some((symbol, flow)) = pumped {
        list.push(section("pump", || {
            let _ = pump(given(symbol, flow), given(&s::N, h.n), given(&s::ETA, h.eta));
            let _ = relief(given(&s::P, h.p), given(&s::K_R, h.k_r));
        }));
    }
    list.push(section("buckling", || {
        let _ = buckling(&Rod {
            e: given(&s::E, h.e),
            d: given(&s::D, piston.d),
            l_k: given(&s::R_LONG, longest),
            nu: given(&s::NU, h.nu),
        });
    }));
    list
}

/// What the choice of the parts comes to.
fn summary(steering: &Steering, built: &Built<f64>, pumped: Option<(&'static Symbol, f64)>) -> Vec<Summary> {
    let sections = sizing(steering, built, pumped);
    let least = defined(&sections, &s::D_G_MIN);
    let bore = least.and_then(|least| next(&BORES, least).ok());
    let found = [&s::D_G_MIN, &s::V_P, &s::P_R, &s::F_K].map(|symbol| (symbol, defined(&sections, symbol)));
    let stroke = steering.parameters.cylinder.and_then(|cylinder| {
        let needed = built
            .limits
            .iter()
            .zip(&steering.parameters.groups)
            .map(|(limits, group)| {
                // A mirrored cylinder turns the other way.
                let limits = match group.mirrored {
                    true => Limits::new(-limits.max, -limits.min, Vec::new()).ok()?,
                    false => limits.clone(),
                };
                choose_stroke(&cylinder, &limits, &EXAMPLE_STROKES).ok()
            });
        needed.reduce(|a, b| Some(a?.max(b?)))?
    });
    let found = found.into_iter().chain([(&s::D_G_NEXT, bore), (&s::L_X_NEXT, stroke)]);
    let alone = |(symbol, value): (&'static Symbol, Option<f64>)| {
        Some(Summary {
            symbol,
            value: value?,
            at: None,
        })
    };
    found.filter_map(alone).collect()
}

/// The value that a step of a section defines.
fn defined(sections: &[Section], symbol: &'static Symbol) -> Option<f64> {
    let steps = sections.iter().flat_map(|section| &section.trace.steps);
    steps
        .filter(|step| step.symbol == symbol)
        .map(|step| step.value)
        .next_back()
}

fn checks(steering: &Steering, built: &Built<f64>, pumped: Option<(&'static Symbol, f64)>) -> Vec<Check> {
    let mut checks = Vec::new();
    let mut add = |id, symbol, value, limit, at_most| {
        checks.push(Check {
            id,
            symbol,
            value,
            limit,
            at_most,
        });
    };
    let machine = &built.machine;
    let mut stances: Vec<Inputs<f64>> = fine(steering).map(|theta| at(steering, theta)).collect();
    stances.extend(Mode::ALL.into_iter().filter_map(|mode| example(steering, built, mode)));
    let mut farthest = 0.0_f64;
    for inputs in stances {
        let found = standing(steering, built, inputs);
        for (p, [theta, _]) in machine.groups.iter().zip(&found.wheels) {
            farthest = farthest.max(residual(&found.centre, *p, *theta).abs());
        }
    }
    let margins = fine(steering).map(|theta| value(steering, theta, Output::Margin));
    add(
        "range",
        &s::MARGIN_MIN,
        margins.fold(f64::INFINITY, f64::min),
        0.0,
        false,
    );
    add("axle_lines", &s::E_O, farthest, 1e-12, true);
    if let Some((layout, difference)) = printed(built) {
        let _ = layout;
        add("published_angles", &s::AGREEMENT, difference, 1e-12, true);
    }
    let sections = sizing(steering, built, pumped);
    let of = |symbol| defined(&sections, symbol);
    if let Some(linkage) = linkage(built).map(|index| &built.linkages[index]) {
        let limits = &built.limits[0];
        let slope = (0..=CURVE).map(|i| {
            let theta = limits.min + (limits.max - limits.min) * f64::from(i) / f64::from(CURVE);
            let h = 1e-4;
            let l = |n: f64| linkage.at_angle(theta + n * h).l;
            // A central difference of order six.
            let slope = (45.0 * (l(1.0) - l(-1.0)) - 9.0 * (l(2.0) - l(-2.0)) + (l(3.0) - l(-3.0))) / (60.0 * h);
            (slope - linkage.at_angle(theta).od).abs() / plane::length(linkage.c)
        });
        add("lever_arm", &s::AGREEMENT, slope.fold(0.0, f64::max), 1e-9, true);
    }
    for (id, symbol) in [("stroke_out", &s::M_OUT), ("stroke_in", &s::M_IN)] {
        if let Some(margin) = of(symbol) {
            add(id, symbol, margin, 0.0, false);
        }
    }
    if let Some((least, piston)) = of(&s::D_G_MIN).zip(steering.parameters.piston) {
        add("bore", &s::D_G, piston.d_g, least, false);
    }
    if let Some((force, bears)) = of(&s::F_G_MAX).zip(of(&s::F_K)) {
        add("buckling", &s::F_G_MAX, force, bears, true);
    }
    if let Some(pace) = steering.parameters.pace {
        let groups = 0..machine.groups.len();
        let fastest = |theta| {
            let speeds = groups.clone().map(|i| value(steering, theta, Output::Vc(i)).abs());
            speeds.fold(0.0, f64::max)
        };
        add(
            "cylinder_speed",
            &s::V_C_WORK,
            greatest(steering, &fastest).1,
            pace.speed,
            true,
        );
    }
    if let Some(limit) = steering.slip_limit {
        let (_, most) = greatest(steering, &|theta| slip(steering, theta));
        add("slip", &s::SLIP_WORK, most, limit, true);
    }
    if let Some([ring, bolts]) = ring(steering) {
        add("ring", &s::RING_USE, ring, 1.0, true);
        add("bolts", &s::BOLT_USE, bolts, 1.0, true);
    }
    checks
}

/// How far the ring of the scene's catalogue with the scene's raceway is used, and
/// its bolts; the first that bears the load where none has this raceway.
fn ring(steering: &Steering) -> Option<[f64; 2]> {
    let (catalogue, bearing) = (steering.catalogue.as_ref()?, steering.parameters.bearing?);
    let duty = Duty::new(&bearing, heaviest(steering)?).ok()?;
    let chosen = catalogue.rings.iter().find(|ring| ring.d_l == bearing.d_l);
    let chosen = chosen
        .or_else(|| catalogue.choose(&duty).ok())
        .or(catalogue.rings.last())?;
    Some(chosen.use_of(&duty).unwrap_or([f64::INFINITY; 2]))
}

/// The paper's layout, if the machine has it, and the greatest difference between
/// its mended equations and the general geometry, in rad.
fn printed(built: &Built<f64>) -> Option<(Layout<f64>, f64)> {
    let groups = &built.machine.groups;
    let [one, two, ..] = groups.as_slice() else { return None };
    let layout = Layout {
        s_t: 2.0 * one.y,
        l_1: two.x,
        l_2: one.x,
    };
    if groups.as_slice() != layout.groups() {
        return None;
    }
    let mut worst = 0.0_f64;
    for radius in [1.0, 3.0, 10.0, 30.0, 100.0] {
        let command = Command::Radius(radius + layout.s_t / 2.0);
        let centre = Mode::AllWheel.centre(&built.machine, command).ok()?;
        let general = [0, 1, 4, 5].map(|i| {
            let along = centre.rolling(groups[i]);
            f64::direction(along.x, along.y)
        });
        for (a, b) in layout.angles(radius).into_iter().zip(general) {
            worst = worst.max((a - b).abs());
        }
    }
    Some((layout, worst))
}

/// Level and assumptions of the model of this machine.
pub(crate) fn assumptions(steering: &Steering) -> Vec<&'static str> {
    let level = if steering.moving.is_some() {
        "level_turning"
    } else {
        "level_kinematic"
    };
    let resistance = steering.parameters.tyre.map(|_| "resistance");
    std::iter::once(level).chain(resistance).collect()
}

fn remarks(steering: &Steering, built: &Built<f64>) -> Vec<&'static str> {
    let mut list = vec!["zhang2016_modes"];
    if steering.moving.is_some() {
        list.insert(0, "steering_moving");
    }
    if printed(built).is_some() {
        list.extend(["zhang2016_cot", "zhang2016_pairs", "zhang2016_dimensions"]);
    }
    if !built.linkages.is_empty() {
        list.extend(["zhang2016_units", "zhang2016_moment", "zhang2016_factors", "iso3320"]);
    }
    list
}

fn fine(steering: &Steering) -> impl Iterator<Item = f64> {
    let (from, to) = (steering.motion.from, steering.motion.to);
    (0..=CURVE).map(move |i| match i {
        CURVE => to,
        _ => from + (to - from) * f64::from(i) / f64::from(CURVE),
    })
}

/// A result at a commanded angle.
fn value(steering: &Steering, theta: f64, output: Output) -> f64 {
    let mut evaluation = evaluation(steering, at(steering, theta));
    evaluation.output(output).expect("the working range was checked")
}

/// Where a result is greatest over the working range: on a fine grid, then by
/// golden section between the neighbours.
fn greatest(steering: &Steering, of: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let grid: Vec<f64> = fine(steering).collect();
    let values: Vec<f64> = grid.iter().map(|&theta| of(theta)).collect();
    let at = (0..grid.len())
        .max_by(|&a, &b| values[a].total_cmp(&values[b]))
        .expect("a range has points");
    let (mut low, mut high) = (grid[at.saturating_sub(1)], grid[(at + 1).min(grid.len() - 1)]);
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    for _ in 0..60 {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if of(a) > of(b) {
            high = b;
        } else {
            low = a;
        }
    }
    let inside = f64::midpoint(low, high);
    // Straight ahead curves have corners: there the search stops one rounding beside it.
    let inside = if inside.abs() < 1e-9 { 0.0 } else { inside };
    let best = if of(inside) > values[at] { inside } else { grid[at] };
    (best, of(best))
}

/// Results with the commanded angle where each is greatest or least; and where, and
/// on which group, the force of a cylinder is greatest.
fn governing(steering: &Steering, demand: Option<&Demand>) -> (Vec<Summary>, Option<(f64, usize)>) {
    let mut list = Vec::new();
    let mut add = |symbol, (at, value): (f64, f64)| {
        list.push(Summary {
            symbol,
            value,
            at: Some((&s::THETA_B, at)),
        });
    };
    let least = |output: Output| {
        let (at, value) = greatest(steering, &|theta| -value(steering, theta, output));
        (at, -value)
    };
    add(&s::R_O_MIN, least(Output::RO));
    add(&s::MARGIN_MIN, least(Output::Margin));
    add(
        &s::B_S_MAX,
        greatest(steering, &|theta| value(steering, theta, Output::Width)),
    );
    let mut worst = None;
    if steering.parameters.cylinder.is_some() && !steering.inputs.loads.is_empty() {
        let groups = (0..steering.parameters.groups.len()).map(|i| {
            let (at, force) = greatest(steering, &|theta| value(steering, theta, Output::Fg(i)));
            (i, at, force)
        });
        if let Some((i, at, force)) = groups.reduce(|a, b| if b.2 > a.2 { b } else { a }) {
            add(&s::F_G_WORK, (at, force));
            worst = Some((at, i));
        }
    }
    if steering.parameters.accuracy.is_some() {
        add(&s::SLIP_WORK, greatest(steering, &|theta| slip(steering, theta)));
    }
    if let Some(demand) = demand {
        add(&s::Q_MAX, (demand.at, demand.flow));
    }
    (list, worst)
}

fn table(steering: &Steering) -> Table {
    let mut columns: Vec<(&'static Symbol, Option<Output>)> = vec![
        (&s::THETA_B, None),
        (&s::O_X, Some(Output::Ox)),
        (&s::O_Y, Some(Output::Oy)),
        (&s::R_O, Some(Output::RO)),
        (&s::OMEGA, Some(Output::Omega)),
        (&s::B_S, Some(Output::Width)),
        (&s::MARGIN, Some(Output::Margin)),
    ];
    if steering.parameters.piston.is_some() {
        columns.push((&s::Q_SUM, Some(Output::QSum)));
    }
    let row = |theta: f64| {
        let cell = |(_, output): &(_, Option<Output>)| output.map_or(theta, |output| value(steering, theta, output));
        columns.iter().map(cell).collect()
    };
    Table {
        rows: steering.motion.angles().into_iter().map(row).collect(),
        columns: columns.iter().map(|(symbol, _)| *symbol).collect(),
    }
}

fn curves(steering: &Steering, built: &Built<f64>) -> Vec<Curve> {
    let mut list = Vec::new();
    if let Some(index) = linkage(built) {
        let (linkage, limits) = (&built.linkages[index], &built.limits[index]);
        let over = |f: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            let at = |i: u32| limits.min + (limits.max - limits.min) * f64::from(i) / f64::from(CURVE);
            (0..=CURVE).map(at).map(|theta| [theta, f(theta)]).collect()
        };
        let curve = |id, y, points| Curve {
            id,
            x: &s::THETA,
            y,
            pieces: vec![points],
            numbers: Vec::new(),
        };
        list.push(curve(
            "zhang2016_fig_7_length",
            &s::L_C,
            over(&|theta| linkage.at_angle(theta).l),
        ));
        list.push(curve(
            "zhang2016_fig_7_arm",
            &s::OD,
            over(&|theta| linkage.at_angle(theta).od),
        ));
    }
    let groups = steering.parameters.groups.len();
    let of_groups = |id, y, output: fn(usize) -> Output| Curve {
        id,
        x: &s::THETA_B,
        y,
        pieces: (0..groups)
            .map(|i| {
                fine(steering)
                    .map(|theta| [theta, value(steering, theta, output(i))])
                    .collect()
            })
            .collect(),
        numbers: (1..=groups).collect(),
    };
    list.push(of_groups("steering_angles", &s::THETA, Output::Theta));
    list.push(of_groups("steering_speeds", &s::V, Output::V));
    if steering.parameters.cylinder.is_some() && !steering.inputs.loads.is_empty() {
        list.push(of_groups("steering_forces", &s::F_G, Output::Fg));
    }
    if steering.parameters.accuracy.is_some() {
        list.push(Curve {
            id: "steering_slip",
            x: &s::THETA_B,
            y: &s::SLIP_MAX,
            pieces: vec![fine(steering).map(|theta| [theta, slip(steering, theta)]).collect()],
            numbers: Vec::new(),
        });
    }
    if steering.parameters.piston.is_some() {
        list.push(Curve {
            id: "steering_flow",
            x: &s::THETA_B,
            y: &s::Q_SUM,
            pieces: vec![
                fine(steering)
                    .map(|theta| [theta, value(steering, theta, Output::QSum)])
                    .collect(),
            ],
            numbers: Vec::new(),
        });
    }
    list
}
