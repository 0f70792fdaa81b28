//! Everything a book says about a luffing mechanism.

mod balance;
mod motion;

use crate::balance::analysis::Analysis;
use crate::balance::symbols as b;
use crate::calc::Calc;
use crate::lemniscate::balancing::{Balanced, Balancing, agreement, analysis};
use crate::lemniscate::drive::{Drive, oil_flow};
use crate::lemniscate::geometry::{Driven, Geometry, Jib, Parameters};
use crate::lemniscate::governing::{coordinate, governing, rate, sensitivity};
use crate::lemniscate::model::Model;
use crate::lemniscate::moving::symbols as m;
use crate::lemniscate::position::Position;
use crate::lemniscate::published::Published;
use crate::lemniscate::range::{Range, rise_by_integration};
use crate::lemniscate::scene::{Luffing, Motion};
use crate::lemniscate::statics::{Centres, PinForces, drive_moment, load_moment, weight_moment};
use crate::lemniscate::symbols as s;
use crate::lemniscate::velocity::{Pole, Velocity};
use crate::model::Role;
use crate::plane::{self, Point};
use crate::record::{Rec, record};
use crate::scene::{Place, Scene};
use crate::sheet::{
    Check, Comparison, Curve, Drawing, Input, Section, Sensitivity, Shape, Sheet, Summary, Table, Worked,
};
use crate::symbol::Symbol;

/// Points of a drawn curve.
const CURVE: u32 = 240;

/// The sheet of a scene with this mechanism.
#[must_use]
pub fn sheet(scene: &Scene, luffing: &Luffing) -> Sheet {
    let mut model = Model::new(luffing).expect("a scene that was read has a mechanism");
    let geometry = Geometry::new(&luffing.parameters).expect("checked when the scene was read");
    let range = Range::new(&luffing.parameters, &luffing.motion).expect("checked when the scene was read");
    let coordinate = coordinate(luffing.parameters.driven);
    let motion = luffing.motion;
    let middle = f64::midpoint(motion.from, motion.to);
    let balance = analysis(&luffing.parameters, &motion).expect("checked when the scene was read");
    let governing = governing(luffing, &range, balance.as_ref());
    let positions = positions(scene, &luffing.motion, &governing);
    let mut checks = checks(&mut model, luffing, &geometry, &range, balance.as_ref());
    let moving = luffing.moving.as_ref();
    let mut warnings = Vec::new();
    let motion_in_time = moving
        .and_then(|moving| motion::motion(luffing, moving))
        .map(|(motion, found, warned)| {
            checks.extend(found);
            warnings.extend(warned);
            motion
        });
    Sheet {
        motion: motion_in_time,
        assumptions: assumptions(luffing),
        inputs: inputs(scene, luffing),
        constants: constants(luffing),
        views: Vec::new(),
        demands: Vec::new(),
        changes: None,
        sizing: Vec::new(),
        positions: positions
            .into_iter()
            .map(|(id, theta)| worked(luffing, id, coordinate, theta))
            .collect(),
        range: table(&mut model, coordinate, &motion),
        curves: curves(&mut model, luffing, coordinate),
        drawing: drawing(&geometry, luffing, middle),
        checks,
        warnings,
        published: published(luffing),
        published_source: luffing.published.as_ref().map(|p| p.source.clone()),
        summary: summary(luffing, &geometry, &range),
        sensitivity: if geometry.linkage.keeps_branch() {
            // With the least change of a length it would not pass its change points any more.
            Sensitivity::default()
        } else {
            sensitivity(luffing, &range, &governing)
        },
        governing,
        outputs: outputs(&model),
        remarks: remarks(luffing),
        balance: balance::balance(&mut model, luffing, &geometry, balance.as_ref(), coordinate),
    }
}

/// Level and assumptions of the model of this mechanism.
pub(crate) fn assumptions(luffing: &Luffing) -> Vec<&'static str> {
    let given = |known: bool, id: &'static str| known.then_some(id);
    let forces = given(luffing.q.is_some(), "forces");
    let Some(moving) = &luffing.moving else {
        let level = if luffing.table.is_some() {
            "level_table"
        } else {
            "level_static"
        };
        return [Some(level), forces].into_iter().flatten().collect();
    };
    let (oil, rope, slews) = (moving.oil.is_some(), moving.rope.is_some(), moving.slewing.is_some());
    [
        Some(match (oil, rope) {
            (true, _) => "level_hydraulic",
            (false, true) => "level_swing",
            (false, false) => "level_rigid",
        }),
        Some("bodies"),
        given(luffing.parameters.balance.is_some(), "counterweight"),
        Some(if rope { "rope" } else { "fixed_load" }),
        given(rope, "slack"),
        given(rope, "hoist"),
        given(slews, "slewing"),
        given(oil, "oil"),
        Some(if oil { "creep" } else { "sticking" }),
        Some(if oil { "buffer" } else { "stops" }),
        forces,
        Some(if oil { "solver_rodas" } else { "solver_runge_kutta" }),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Positions at which the formulas are worked out, with their names: what the
/// scene asks for, otherwise where the luffing moment of the load is greatest.
fn positions(scene: &Scene, motion: &Motion, governing: &[Summary]) -> Vec<(&'static str, f64)> {
    let middle = ("middle", f64::midpoint(motion.from, motion.to));
    let greatest = |id: &str| governing.iter().find(|g| g.symbol.id == id).and_then(|g| g.at);
    let worst = greatest(s::M_Q_MAX.id).map_or(middle, |(_, theta)| ("governing", theta));
    let position = |place: &Place| match *place {
        Place::At(theta) => ("chosen", theta),
        Place::Named("governing") => worst,
        Place::Named("middle") => middle,
        Place::Named("from") => ("from", motion.from),
        Place::Named("to") => ("to", motion.to),
        Place::Named(id) => (id, greatest(id).expect("checked when the scene was read").1),
    };
    match scene.book.positions.as_slice() {
        [] => vec![worst],
        places => places.iter().map(position).collect(),
    }
}

fn outputs(model: &Model) -> Vec<&'static Symbol> {
    let variables = model.variables().iter();
    variables
        .filter(|variable| variable.role == Role::Output)
        .map(|variable| variable.symbol)
        .collect()
}

fn inputs(scene: &Scene, luffing: &Luffing) -> Vec<Input> {
    let mut inputs = Vec::new();
    let mut add = |chapter: &'static str, table: &str, name: &str, symbol: &'static Symbol, value: f64| {
        inputs.push(Input {
            symbol,
            number: None,
            value,
            chapter,
            given: scene.given(&format!("luffing.{table}{name}")).cloned(),
        });
    };
    let mut place = ("geometry", "");
    luffing.parameters.map(&mut |symbol, value| {
        if symbol == &s::G_1 {
            place = ("weights", "weights.");
        } else if symbol == &s::E_X {
            place = ("drive", "drive.");
        } else if b::ALL.contains(&symbol) {
            place = ("balance", "balance.");
        }
        add(place.0, place.1, symbol.id, symbol, value);
    });
    if let Some(q) = luffing.q {
        add("load", "", s::Q.id, &s::Q, q);
    }
    let motion = &luffing.motion;
    add("motion", "motion.", "from", &s::FROM, motion.from);
    add("motion", "motion.", "to", &s::TO, motion.to);
    add(
        "motion",
        "motion.",
        "speed",
        rate(luffing.parameters.driven),
        motion.speed,
    );
    if let Some(moving) = &luffing.moving {
        // What the scene leaves to itself is no input of the book.
        let mut table = |chapter: &'static str, table: &'static str, symbol: &'static Symbol, value: f64| {
            if scene.given(&format!("luffing.{table}{}", symbol.id)).is_some() {
                add(chapter, table, symbol.id, symbol, value);
            }
        };
        let inputs = &moving.inputs;
        moving
            .constants
            .map(&mut |symbol, value| table("moving", "dynamics.", symbol, value));
        let commands = [
            (&m::M_A, inputs.motion.moment),
            (&m::M_S, inputs.motion.brake),
            (&m::V_H, inputs.motion.hoist),
        ];
        let rope = moving.rope.map(|rope| [(&m::L_R, rope.length), (&m::PHI, rope.swing)]);
        for (symbol, value) in commands.into_iter().chain(rope.into_iter().flatten()) {
            table("moving", "dynamics.", symbol, value);
        }
        if let Some(turn) = &moving.slewing {
            turn.constants
                .map(&mut |symbol, value| table("slewing", "slewing.", symbol, value));
            let others = [
                (&m::M_SL, inputs.slewing.moment),
                (&m::M_B_SL, inputs.slewing.brake),
                (&m::PSI_SL, turn.start[0]),
                (&m::OMEGA_SL, turn.start[1]),
                (&m::PSI_MIN, turn.stops[0]),
                (&m::PSI_MAX, turn.stops[1]),
                (&m::CHI_R, turn.side),
            ];
            for (symbol, value) in others {
                table("slewing", "slewing.", symbol, value);
            }
        }
        if let Some(oil) = &moving.oil {
            oil.map(&mut |symbol, value| table("oil", "hydraulics.", symbol, value));
            for (symbol, value) in [(&m::P_P, inputs.supply), (&m::U_V, inputs.valve)] {
                table("oil", "hydraulics.", symbol, value);
            }
        }
    }
    let limits = [
        (&s::MU_MIN, luffing.limits.mu_min),
        (&s::EPSILON_Y, luffing.limits.epsilon_y),
        (&b::DM_MAX, luffing.limits.dm_max),
        (&b::GAMMA_MIN, luffing.limits.gamma_min),
        (&b::N_MAX, luffing.limits.n_max),
        (&m::PHI_MAX, luffing.limits.phi_max),
    ];
    for (symbol, limit) in limits {
        if let Some(value) = limit {
            add("limits", "limits.", symbol.id, symbol, value);
        }
    }
    inputs
}

/// Parameters as names for the recorder.
fn given(parameters: &Parameters<f64>) -> Parameters<Rec> {
    parameters.map(&mut Rec::given)
}

fn constants(luffing: &Luffing) -> Vec<Section> {
    let parameters = || given(&luffing.parameters);
    let (trace, _) = record(|| Geometry::new(&parameters()));
    let before = trace.steps.len();
    let mut sections = vec![Section {
        id: "geometry_constants",
        trace,
        drawing: None,
        table: None,
    }];
    let (mut trace, _) = record(|| {
        let parameters = parameters();
        let _ = Geometry::new(&parameters);
        Balancing::new(&parameters, &luffing.motion)
    });
    trace.steps.drain(..before);
    if !trace.steps.is_empty() {
        sections.push(Section {
            id: "balance_constants",
            trace,
            drawing: None,
            table: None,
        });
    }
    sections
}

/// The formulas at one position, each group as its own section.
///
/// Every section is recorded from the start and shows only what its own
/// function added, so that its names stand for values computed before.
fn worked(luffing: &Luffing, id: &'static str, coordinate: &'static Symbol, theta: f64) -> Worked {
    let mut sections = Vec::new();
    let mut seen = 0;
    // `stage` counts how far the chain of functions is run.
    for (stage, id) in STAGES.iter().enumerate() {
        let (mut trace, there) = record(|| chain(luffing, theta, stage));
        let new = trace.steps.split_off(seen.min(trace.steps.len()));
        seen += new.len();
        trace.steps = new;
        if there && !trace.steps.is_empty() {
            sections.push(Section {
                id,
                trace,
                drawing: None,
                table: None,
            });
        }
    }
    Worked {
        id,
        coordinate,
        value: theta,
        of: None,
        sections,
    }
}

const STAGES: [&str; 12] = [
    "given",
    "position",
    "angles",
    "velocity",
    "pole",
    "load_moment",
    "weight_moment",
    "drive",
    "balance",
    "drive_moment",
    "pin_forces",
    "published_forms",
];

/// Runs the equations under the recorder up to a stage; false where the scene
/// does not model the stage.
fn chain(luffing: &Luffing, theta: f64, stage: usize) -> bool {
    let parameters = given(&luffing.parameters);
    let Ok(g) = Geometry::new(&parameters) else {
        return false;
    };
    let Ok(balancing) = Balancing::new(&parameters, &luffing.motion) else {
        return false;
    };
    let theta = Rec::given(coordinate(luffing.parameters.driven), theta);
    let omega = Rec::given(rate(luffing.parameters.driven), luffing.motion.speed);
    if stage == 0 {
        return false;
    }
    let Some(p) = Position::new(&g, theta) else {
        return false;
    };
    if stage == 1 {
        return true;
    }
    let _ = p.follower_angle();
    let _ = p.alpha_1(p.alpha());
    let _ = match luffing.parameters.driven {
        Driven::Boom => p.y(),
        Driven::Rocker => p.l(),
    };
    let _ = p.mu();
    if stage == 2 {
        return true;
    }
    let v = Velocity::new(&p);
    let _ = v.v_a(omega);
    let _ = v.beta();
    if stage == 3 {
        return true;
    }
    let pole = Pole::new(&g, &p, v.i_2);
    if stage == 4 {
        return true;
    }
    let Some(q) = luffing.q else {
        return stage == 7 && drive_chain(luffing, &g, &p, omega).is_some();
    };
    let q = Rec::given(&s::Q, q);
    let m_q = load_moment(&v, q);
    let _ = pole.moment(&g, &p, &v, q);
    if stage == 5 {
        return true;
    }
    let lengths = g.lengths;
    let weights = parameters.weights.as_ref();
    let centres = weights.map(|w| Centres::new(&p, [lengths.x_1, lengths.x_2, lengths.x_3], w));
    let both = weights.zip(centres.as_ref());
    let m_g = both.map(|(w, r)| weight_moment(w, r, &p, &v));
    if stage == 6 {
        return true;
    }
    let drive = drive_chain(luffing, &g, &p, omega);
    if stage == 7 {
        return true;
    }
    let mut action = None;
    if let (Some(balancing), Some(both), Some(m_g)) = (balancing, both, m_g) {
        let Ok(residual) = balancing.at(&g, both, (&p, &v), theta, m_g) else {
            return false;
        };
        let balanced = Balanced::new(residual, &v, p.driven, m_q, m_g);
        let _ = drive.as_ref().map(|drive| balanced.driven_by(drive));
        action = Some(residual.action);
    }
    if stage == 8 {
        return true;
    }
    if !luffing.has_pins() {
        let m_d = drive_moment(m_q, m_g.unwrap_or(Rec::constant(0.0)));
        let _ = drive.map(|drive| drive.force(m_d, &s::F_D));
        return stage == 9;
    }
    if stage == 9 {
        return false;
    }
    let _ = PinForces::new(&p, lengths.x_3, q, both, action.as_ref(), |m_d| {
        drive.and_then(|drive| drive.reaction(m_d).force)
    });
    if stage == 10 {
        return true;
    }
    match (parameters.jib, luffing.parameters.driven) {
        (Jib::Sag(x_7), Driven::Boom) => {
            let _ = Published::new(&g, x_7, theta);
            true
        }
        _ => false,
    }
}

fn drive_chain(luffing: &Luffing, g: &Geometry<Rec>, p: &Position<Rec>, omega: Rec) -> Option<Drive<Rec>> {
    let parameters = given(&luffing.parameters);
    let bar = match g.driven {
        Driven::Boom => g.lengths.x_1,
        Driven::Rocker => g.lengths.x_3,
    };
    let drive = Drive::new(p, bar, g.lengths.o3(), parameters.anchors.as_ref()?);
    let speed = drive.speed(omega);
    let _ = parameters.cylinder.map(|cylinder| oil_flow(&cylinder, speed));
    Some(drive)
}

/// Reads variables of the model at angles of the driven bar.
fn sample(model: &mut Model, symbols: &[&'static Symbol], angles: impl Iterator<Item = f64>) -> Vec<Vec<f64>> {
    let place = |symbol: &'static Symbol| model.variables().iter().position(|variable| variable.symbol == symbol);
    let indices: Vec<usize> = symbols
        .iter()
        .map(|&symbol| place(symbol).expect("a variable of this scene"))
        .collect();
    angles
        .map(|theta| {
            model.set(0, theta).expect("an angle is finite");
            indices
                .iter()
                .map(|&index| model.get(index).expect("the range was checked"))
                .collect()
        })
        .collect()
}

fn fine(motion: &Motion) -> impl Iterator<Item = f64> {
    let (from, to) = (motion.from, motion.to);
    (0..=CURVE).map(move |i| {
        if i == CURVE {
            to
        } else {
            from + (to - from) * f64::from(i) / f64::from(CURVE)
        }
    })
}

fn table(model: &mut Model, coordinate: &'static Symbol, motion: &Motion) -> Table {
    let follower = if coordinate == &s::THETA_1 {
        &s::THETA_3
    } else {
        &s::THETA_1
    };
    let mut columns = vec![
        coordinate,
        follower,
        &s::R,
        &s::A_Y,
        &s::ALPHA,
        &s::ALPHA_1,
        &s::MU,
        &s::V_AX,
    ];
    let exists = |symbol: &&Symbol| model.variables().iter().any(|variable| variable.symbol == *symbol);
    columns.extend([&s::M_Q, &s::M_D, &s::F_D].into_iter().filter(|symbol| exists(symbol)));
    let rows = sample(model, &columns, motion.angles().into_iter());
    Table { columns, rows }
}

fn curves(model: &mut Model, luffing: &Luffing, coordinate: &'static Symbol) -> Vec<Curve> {
    let follower = if coordinate == &s::THETA_1 {
        &s::THETA_3
    } else {
        &s::THETA_1
    };
    let mut list = vec![
        ("li2022_fig_3", &s::P_X, &s::P_Y),
        ("li2022_fig_4", coordinate, follower),
        ("li2022_fig_5", coordinate, &s::ALPHA_1),
        ("li2022_fig_6", &s::R, &s::A_Y),
        ("li2022_fig_7", coordinate, &s::V_AX),
    ];
    if luffing.q.is_some() {
        list.push(("li2022_fig_8", coordinate, &s::M_Q));
    }
    let mut curve = |(id, x, y): (&'static str, &'static Symbol, &'static Symbol)| {
        let points = sample(model, &[x, y], fine(&luffing.motion));
        // The instantaneous centre runs to infinity: what is drawn ends at
        // five times the crane's size.
        let size = 5.0 * (luffing.parameters.lengths.x_1 + luffing.parameters.lengths.x_4);
        let drawable = |point: &Vec<f64>| id != "li2022_fig_3" || (point[0].abs() <= size && point[1].abs() <= size);
        let pieces = points
            .chunk_by(|a, b| drawable(a) && drawable(b) && (id != "li2022_fig_3" || (a[1] > 0.0) == (b[1] > 0.0)))
            .filter(|piece| piece.len() > 1)
            .map(|piece| piece.iter().map(|point| [point[0], point[1]]).collect())
            .collect();
        Curve {
            id,
            x,
            y,
            pieces,
            numbers: Vec::new(),
        }
    };
    // With boom and rocker always parallel, nothing is left of the path of the centre.
    list.into_iter()
        .map(&mut curve)
        .filter(|curve| !curve.pieces.is_empty())
        .collect()
}

fn checks(
    model: &mut Model,
    luffing: &Luffing,
    g: &Geometry<f64>,
    range: &Range,
    balance: Option<&Analysis>,
) -> Vec<Check> {
    let mut checks = Vec::new();
    if let Some(limit) = luffing.limits.mu_min {
        checks.push(Check {
            id: "transmission_angle",
            symbol: &s::MU_MIN,
            value: range.mu_min.value,
            limit,
            at_most: false,
        });
    }
    if let Some(limit) = luffing.limits.epsilon_y {
        checks.push(Check {
            id: "level_error",
            symbol: &s::EPSILON_Y,
            value: range.epsilon_y(),
            limit,
            at_most: true,
        });
    }
    if let Some(found) = balance {
        let limits = &luffing.limits;
        let list = [
            ("balance_residual", &b::DM_MAX, Some(found.dm_max), limits.dm_max, true),
            (
                "balance_transmission",
                &b::GAMMA_MIN,
                found.gamma_min,
                limits.gamma_min,
                false,
            ),
            ("balance_rod", &b::N_MAX, found.n_max, limits.n_max, true),
        ];
        for (id, symbol, extreme, limit, at_most) in list {
            checks.extend(extreme.zip(limit).map(|(extreme, limit)| Check {
                id,
                symbol,
                value: extreme.value,
                limit,
                at_most,
            }));
        }
        let [work, power] = agreement(&luffing.parameters, &luffing.motion, fine(&luffing.motion));
        for (id, value) in [("balance_work", work), ("balance_power", power)] {
            checks.push(Check {
                id,
                symbol: &s::AGREEMENT,
                value,
                limit: 1e-12,
                at_most: true,
            });
        }
    }
    if luffing.q.is_some() {
        // Agreement of independent ways, relative to the largest moment.
        let (integral, difference) = (rise_by_integration(g, &luffing.motion), range.rise);
        let scale = range.dy_max.value.abs();
        checks.push(Check {
            id: "energy_identity",
            symbol: &s::AGREEMENT,
            value: ((integral - difference) / (scale * (luffing.motion.to - luffing.motion.from))).abs(),
            limit: 1e-9,
            at_most: true,
        });
        let most = |symbol: &'static Symbol| {
            sample(model, &[&s::M_Q, symbol], fine(&luffing.motion))
                .iter()
                .map(|row| (row[0] - row[1]).abs())
                .fold(0.0, f64::max)
        };
        let mut most = most;
        checks.push(Check {
            id: "moment_agreement",
            symbol: &s::AGREEMENT,
            value: most(&s::M_Q_P) / (luffing.q.unwrap_or(1.0).max(f64::MIN_POSITIVE) * scale),
            limit: 1e-12,
            at_most: true,
        });
    }
    if luffing.has_pins() {
        checks.push(Check {
            id: "equilibrium",
            symbol: &s::AGREEMENT,
            value: equilibrium(luffing, g),
            limit: 1e-12,
            at_most: true,
        });
    }
    checks
}

/// The drive's moment by equilibrium of the bodies against virtual work of load
/// and weights: largest difference over the range, relative to the largest moment.
fn equilibrium(luffing: &Luffing, g: &Geometry<f64>) -> f64 {
    let lengths = g.lengths;
    let q = luffing.q.unwrap_or(0.0);
    let balancing = Balancing::new(&luffing.parameters, &luffing.motion).ok().flatten();
    let (mut worst, mut scale) = (0.0_f64, f64::MIN_POSITIVE);
    for theta in fine(&luffing.motion) {
        let Some(p) = Position::new(g, theta) else { continue };
        let v = Velocity::new(&p);
        let weights = luffing.parameters.weights.as_ref();
        let centres = weights.map(|w| Centres::new(&p, [lengths.x_1, lengths.x_2, lengths.x_3], w));
        let both = weights.zip(centres.as_ref());
        let m_g = both.map_or(0.0, |(w, r)| weight_moment(w, r, &p, &v));
        let residual = balancing.zip(both);
        let residual = residual.and_then(|(balancing, both)| balancing.at(g, both, (&p, &v), theta, m_g).ok());
        let action = residual.as_ref().map(|residual| &residual.action);
        let turn = if p.driven == Driven::Boom { 1.0 } else { v.i_follower };
        let work = load_moment(&v, q) + m_g - action.map_or(0.0, |action| action.m_b * turn);
        let m_d = PinForces::new(&p, lengths.x_3, q, both, action, |_| None).m_d;
        worst = worst.max((m_d - work).abs());
        // What is left of great moments may be nothing.
        let carried = action.map_or(0.0, |action| (action.m_b * turn).abs());
        scale = scale.max(work.abs()).max(carried);
    }
    worst / scale
}

fn published(luffing: &Luffing) -> Vec<Comparison> {
    let compared = luffing
        .published
        .iter()
        .flat_map(|published| published.compared(luffing));
    compared
        .flat_map(|row| row.expect("checked when the scene was read"))
        .collect()
}

fn summary(luffing: &Luffing, g: &Geometry<f64>, range: &Range) -> Vec<Summary> {
    let alone = |symbol, value| Summary {
        symbol,
        value,
        at: None,
    };
    let mut list = vec![
        alone(&s::DELTA_Y, range.delta_y()),
        alone(&s::EPSILON_Y, range.epsilon_y()),
    ];
    if let Some(q) = luffing.q {
        list.push(alone(&s::W_Q, q * rise_by_integration(g, &luffing.motion)));
        list.push(alone(&s::W_Y, q * range.rise));
    }
    list
}

/// Ids of the remarks on the publications of this mechanism.
pub(crate) fn remarks(luffing: &Luffing) -> Vec<&'static str> {
    let from = |source: Option<&String>, key: &str| source.is_some_and(|source| source.starts_with(key));
    let mechanism = luffing.published.as_ref().map(|published| &published.source);
    let balance = luffing.published_balance.as_ref().map(|published| &published.source);
    let mut list = Vec::new();
    if from(mechanism, "[Li2022") {
        list.extend([
            "li2022_sag",
            "li2022_sign",
            "li2022_quadrants",
            "li2022_level_error",
            "li2022_drive_comparison",
        ]);
    }
    if from(balance, "[Balance004") {
        list.extend([
            "balance004_rounding",
            "balance004_nodes",
            "balance004_double_node",
            "balance004_rod",
            "balance004_chi_2",
        ]);
    }
    if from(balance, "[Ports001") {
        list.extend(["ports001_pivot", "ports001_positions", "ports001_linkage"]);
    }
    list
}

fn drawing(g: &Geometry<f64>, luffing: &Luffing, middle: f64) -> Drawing {
    let motion = &luffing.motion;
    let point = |p: Point<f64>| [p.x, p.y];
    let mut shapes = Vec::new();
    let path = fine(motion)
        .filter_map(|theta| Position::new(g, theta))
        .map(|p| point(p.a))
        .collect();
    shapes.push(Shape::Path { points: path });
    let distance = |from, to, offset, symbol: &'static Symbol| Shape::Distance {
        from,
        to,
        offset,
        text: symbol.print,
    };
    let o1 = [0.0, 0.0];
    let o3 = point(g.lengths.o3());
    for (theta, faint) in [(motion.from, true), (motion.to, true), (middle, false)] {
        let Some(p) = Position::new(g, theta) else { continue };
        let (a, b, c) = (point(p.a), point(p.b), point(p.c));
        shapes.push(Shape::Body {
            points: vec![o1, b],
            closed: false,
            faint,
        });
        shapes.push(Shape::Body {
            points: vec![o3, c],
            closed: false,
            faint,
        });
        shapes.push(Shape::Body {
            points: vec![c, b, a],
            closed: true,
            faint,
        });
        for at in [b, c, a] {
            shapes.push(Shape::Pin {
                at,
                fixed: false,
                faint,
            });
        }
        if let (Some(anchors), false) = (&luffing.parameters.anchors, faint) {
            let (bar, length, foot) = match g.driven {
                Driven::Boom => (p.x_1, g.lengths.x_1, Point::zeros()),
                Driven::Rocker => (p.x_3, g.lengths.x_3, g.lengths.o3()),
            };
            let (sin, cos) = Calc::sin_cos(anchors.chi_d);
            let along = bar * (anchors.s_d * cos / length);
            let arm = plane::turned(bar, anchors.s_d * cos / length, anchors.s_d * sin / length);
            let (e, d) = ([anchors.e_x, anchors.e_y], point(foot + arm));
            // The lug that carries the anchor beside the bar.
            shapes.push(Shape::Body {
                points: vec![d, point(foot + along)],
                closed: false,
                faint,
            });
            shapes.push(Shape::Body {
                points: vec![e, d],
                closed: false,
                faint,
            });
            shapes.push(Shape::Pin {
                at: e,
                fixed: true,
                faint,
            });
            shapes.push(Shape::Pin {
                at: d,
                fixed: false,
                faint,
            });
            shapes.push(Shape::Label { at: e, text: "E" });
        }
        if !faint {
            shapes.extend([
                Shape::Label { at: a, text: "A" },
                Shape::Label { at: b, text: "B" },
                Shape::Label { at: c, text: "C" },
                Shape::Angle {
                    at: o1,
                    radius: 4.0,
                    from: 0.0,
                    to: Calc::direction(p.x_1.x, p.x_1.y),
                    text: s::THETA_1.print,
                },
                Shape::Angle {
                    at: o3,
                    radius: 3.0,
                    from: 0.0,
                    to: Calc::direction(p.x_3.x, p.x_3.y),
                    text: s::THETA_3.print,
                },
                distance([-g.lengths.x_8, 0.0], [a[0], 0.0], -5.9, &s::R),
                distance(o1, b, -2.0, &s::X_1),
                distance(c, b, 1.3, &s::X_2),
                distance(o3, c, -2.0, &s::X_3),
                distance(b, a, -1.3, &s::X_4),
            ]);
            if luffing.q.is_some() {
                shapes.push(Shape::Load {
                    at: a,
                    text: s::Q.print,
                });
            }
        }
    }
    shapes.extend([
        Shape::Pin {
            at: o1,
            fixed: true,
            faint: false,
        },
        Shape::Pin {
            at: o3,
            fixed: true,
            faint: false,
        },
        Shape::Label { at: o1, text: "O_1" },
        Shape::Label { at: o3, text: "O_3" },
        Shape::CentreLine {
            x: -g.lengths.x_8,
            from: -5.0,
            to: 8.0,
        },
        distance([o3[0], 0.0], o1, -2.3, &s::X_5),
        distance([o3[0], 0.0], o3, 2.6, &s::X_6),
        distance([-g.lengths.x_8, 0.0], o1, -4.1, &s::X_8),
    ]);
    // A distance that cannot be told from nothing is not drawn.
    let size = g.lengths.x_1 + g.lengths.x_4;
    shapes.retain(|shape| match shape {
        Shape::Distance { from, to, .. } => (to[0] - from[0]).abs() + (to[1] - from[1]).abs() > 0.02 * size,
        _ => true,
    });
    Drawing { shapes }
}
