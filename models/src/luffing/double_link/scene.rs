//! What a scene says about a luffing mechanism.

use crate::balance::analysis::Analysis;
use crate::balance::lever::Lever;
use crate::balance::scene::{Form, PublishedBalance};
use crate::balance::task::{Search, Task};
use crate::component::description::Description;
use crate::component::outline::Published;
use crate::drive::scene::{self as drive, Driving};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::double_link::balancing::{analysis, boom};
use crate::luffing::double_link::driving::foot;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::misfit::Misfit;
use crate::luffing::double_link::moving;
use crate::luffing::double_link::parameters::{Driven, Jib, Lengths, Parameters, Weights};
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::resisting;
use crate::luffing::double_link::stages::closes;
use crate::luffing::double_link::symbols as s;
use crate::luffing::led::scene::LedRopeScene;
use crate::luffing::moving::scene::{brisk, outlasts};
use crate::luffing::resistances::scene::Cases;
use crate::luffing::with_balance::complete;
use crate::parts::arcs::Arc;
use crate::parts::four_bar::Branch;
use crate::parts::motion::{Motion, degrees};

use std::f64::consts::TAU;
use std::ops::Range;

/// A luffing mechanism as the scene describes it, with its working range.
pub type Luffing = Description<LuffingScene>;

/// What the scene says of it; SI.
#[derive(Clone, Debug)]
pub struct LuffingScene {
    /// Without the drive.
    pub parameters: Parameters<f64>,
    pub driving: Driving,
    /// Weight of the load; `None` models no forces.
    pub q: Option<f64>,
    /// First angle of the range, in rad, at which all bars lie in one line: no finite forces in the pins carry a load there.
    pub change_point: Option<f64>,
    /// With `fidelity` beyond `static`; with `auto` as deep as the scene's tables allow.
    pub moving: Option<moving::scene::MovingLink>,
    pub published: Option<Published>,
    /// What is asked of the synthesis of its balance.
    pub synthesis: Option<Task>,
    /// Published results of the balance.
    pub published_balance: Option<PublishedBalance>,
    /// What is left of its moment over the working range, where it has a balance.
    pub analysed: Option<Analysis>,
    pub cases: Cases,
    pub led: LedRopeScene,
}

impl LuffingScene {
    /// Whether forces in the pins are modelled.
    #[must_use]
    pub fn has_pins(&self) -> bool {
        self.q.is_some() && self.change_point.is_none()
    }

    /// Whether it is a plain boom: jib and rocker stand for none, since neither they nor a load weigh anything.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        let idle = self
            .parameters
            .weights
            .as_ref()
            .is_some_and(|w| w.g_1 > 0.0 && w.g_2 == 0.0 && w.g_3 == 0.0);
        self.q == Some(0.0) && idle && self.parameters.driven == Driven::Boom
    }
}

/// How a scene asks for a synthesis.
pub const ASK: &str = "add a table [luffing.synthesis], an empty one will do where [luffing.balance] is a lever";

/// The synthesis that the scene asks for.
#[must_use]
pub fn search(luffing: &Luffing) -> Option<Search<'_>> {
    let task = luffing.synthesis.as_ref()?;
    let (boom, range) = boom(&luffing.parameters, &luffing.motion).ok()?;
    Some(Search {
        task,
        boom: std::sync::Arc::new(boom),
        range,
        length: luffing.parameters.lengths.x_1,
        own: own_lever(&luffing.parameters),
    })
}

impl LuffingScene {
    /// Builds the mechanism of a checked table under the acceleration of gravity (m/s²); mistakes go to `found`.
    pub fn new(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(LuffingScene, Motion)> {
        let parameters = parameters(v, found)?;
        let Parameters {
            lengths,
            weights,
            balance,
            driven,
            ..
        } = parameters;
        complete(v, balance.as_ref(), "the weights of boom, jib and rocker", found);
        let driving = drive::read(v, found)?;
        let q = v.number(s::Q.id);
        // A load that cannot be read is not one that is missing.
        let loaded = q.is_some() || !found.is_empty();
        let motion = motion(v, &parameters, found);
        if let Some(motion) = &motion {
            let range = [motion.from, motion.to];
            drive::meets(v, &driving, foot(&lengths, driven), range, found);
        }
        let moving = moving::scene::MovingLink::new(v, gravity, loaded, found);
        let balance_table = v.table("balance").filter(|_| weights.is_some()).zip(motion);
        let analysed = balance_table.and_then(|(table, motion)| balanced(v, table, &parameters, &motion, found));
        if let Some((moving, motion)) = moving.as_ref().zip(motion.as_ref()) {
            brisk(v, moving, motion, found);
            let most = [listed!(s: X_1, X_4, X_8), listed!(s: G_1, G_2, G_3)];
            outlasts(v, moving, motion, most.map(|list| &list[..]), found);
        }
        let led = LedRopeScene::read(v, resisting::PARTS.bodies, moving.as_deref(), found);
        let moves = moving.as_ref().map(|_| &drive::TURNED_LINE[..]);
        drive::fits(v, driving.gear.as_ref(), (moves, loaded), found);
        let theta = parameters.driven.coordinate();
        let published = v.table("published").and_then(|table| published(table, theta, found));
        let motion = motion?;
        let change_point = change_point(v, &parameters, &motion, moving.is_some(), found);
        let synthesis = v
            .table("synthesis")
            .and_then(|table| synthesis(table, &parameters, &motion, found));
        let luffing = LuffingScene {
            parameters,
            driving,
            q,
            change_point,
            moving,
            published,
            synthesis,
            published_balance: v.table("balance").and_then(PublishedBalance::read),
            analysed,
            cases: Cases::read(v, &resisting::PARTS, balance.as_ref(), gravity, found),
            led,
        };
        Some((luffing, motion))
    }
}

/// Dimensions, weights and balance, without the drive; mistakes go to `found`.
pub(super) fn parameters(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Parameters<f64>> {
    let driven = if v.text("driven")? == "boom" {
        Driven::Boom
    } else {
        Driven::Rocker
    };
    let branch = Branch::read(v)?;
    let lengths = Lengths::read(v)?;
    let jib = jib(v, found)?;
    let weights = v.part("weights", Weights::read)?;
    let balance = v.part("balance", |table| Form::read(table, found))?;
    Some(Parameters {
        lengths,
        jib,
        weights,
        anchors: None,
        cylinder: None,
        balance,
        driven,
        branch,
    })
}

/// The jib's triangle, which is given in one of three ways.
fn jib(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Jib<f64>> {
    let n = |symbol: &Symbol| v.number(symbol.id);
    match (n(&s::X_7), n(&s::BETA_0), n(&s::AC)) {
        (Some(x), None, None) => Some(Jib::Sag(x)),
        (None, Some(x), None) => Some(Jib::Angle(x)),
        (None, None, Some(x)) => Some(Jib::Axis(x)),
        (x_7, beta_0, _) => {
            let none = x_7.is_none() && beta_0.is_none() && n(&s::AC).is_none();
            let extra = if x_7.is_some() && beta_0.is_some() {
                "beta_0"
            } else {
                "AC"
            };
            found.push(v.refuse(
                extra,
                if none {
                    "nothing determines the jib's triangle"
                } else {
                    "the jib's triangle is determined twice"
                },
                if none {
                    "X_7, beta_0 or AC is needed here"
                } else {
                    "remove this or the other"
                },
                "give exactly one of X_7 (sag), beta_0 (angle at B) and AC (tail to head)",
            ));
            None
        }
    }
}

/// What is asked of the synthesis; mistakes go to `found`.
fn synthesis(v: &Values, p: &Parameters<f64>, motion: &Motion, found: &mut Vec<Diagnostic>) -> Option<Task> {
    match boom(p, motion) {
        Ok((boom, range)) => Task::new(v, &boom, range, own_lever(p).as_ref(), found),
        Err(fault) => {
            let help = "drive it by its boom and add [luffing.weights], or remove this table";
            found.push(Diagnostic::new(v.span.clone(), fault.what, "nothing to search for").help(help));
            None
        }
    }
}

fn own_lever(p: &Parameters<f64>) -> Option<Lever<f64>> {
    match p.balance {
        Some(Form::Lever(dimensions, s_5, branch)) => Lever::new(dimensions, s_5, branch).ok(),
        _ => None,
    }
}

/// What is left of its moment over the whole working range, where the balance exists all over that.
pub(super) fn balanced(
    v: &Values,
    table: &Values,
    p: &Parameters<f64>,
    motion: &Motion,
    found: &mut Vec<Diagnostic>,
) -> Option<Analysis> {
    let fault = match analysis(p, motion) {
        Ok(analysed) => return analysed,
        Err(fault) => fault,
    };
    let place = if fault.quantity == &s::THETA_1 {
        v.place("motion")
    } else {
        table.place(fault.quantity.id)
    };
    let label = format!("{} is not possible", fault.quantity.id);
    found.push(Diagnostic::new(place, fault.what.clone(), label).help(fault.range()));
    None
}

/// Checks that the mechanism exists and closes over the whole working range.
pub(super) fn motion(v: &Values, parameters: &Parameters<f64>, found: &mut Vec<Diagnostic>) -> Option<Motion> {
    let m = v.table("motion")?;
    let motion = Motion::read(m, found)?;
    let geometry = match Geometry::new(parameters) {
        Ok(geometry) => geometry,
        Err(misfit) => {
            let words = parameters.describe(misfit);
            let label = match misfit {
                Misfit::Jib => "does not close",
                Misfit::Frame => "no frame",
                Misfit::Linkage => "cannot reach",
            };
            found.push(v.refuse(words.key, words.what, label, words.help));
            return None;
        }
    };
    let arcs = geometry.linkage.arcs();
    if geometry.linkage.turns_fully() || arcs.iter().any(|arc| arc.covers(motion.from, motion.to)) {
        // An end that is a dead point but for rounding.
        let ends = [("from", motion.from), ("to", motion.to)];
        let Some((key, at)) = ends.into_iter().find(|(_, at)| Position::new(&geometry, *at).is_none()) else {
            return Some(motion);
        };
        let what = format!("the linkage does not close at {}, its dead point", degrees(at));
        let help = format!("keep the range away from it: it closes for {}", closes(&geometry));
        found.push(m.refuse(key, what, "at a dead point", help));
        return None;
    }
    found.push(
        Diagnostic::new(
            m.span.clone(),
            format!(
                "the linkage does not close over the whole range {} to {}",
                degrees(motion.from),
                degrees(motion.to)
            ),
            missing(&arcs, &motion),
        )
        .help(format!("it closes for {} of the driving link", closes(&geometry))),
    );
    None
}

/// First change point within the working range, in rad; what is not defined there goes to `found`.
fn change_point(
    v: &Values,
    parameters: &Parameters<f64>,
    motion: &Motion,
    moves: bool,
    found: &mut Vec<Diagnostic>,
) -> Option<f64> {
    let geometry = Geometry::new(parameters).ok()?;
    let at = geometry.change_point(motion)?;
    let angle = format!("{} = {}", parameters.driven.coordinate().id, degrees(at));
    let points = geometry.linkage.change_points();
    let mut points: Vec<f64> = points.map(|at| at.rem_euclid(TAU)).collect();
    points.sort_unstable_by(f64::total_cmp);
    let points: Vec<String> = points.into_iter().map(degrees).collect();
    let away = format!("keep the working range away from {}", points.join(" and "));
    let mut refuse = |key, what, label, help| found.push(v.refuse(key, what, label, help));
    if !geometry.linkage.keeps_branch() {
        refuse(
            "motion",
            format!("all bars lie in one line at {angle} of the working range, but for rounding"),
            "which way they go on is undefined",
            format!(
                "{away}, or change a length: either the linkage passes clearly, or opposite bars are exactly equal"
            ),
        );
        return None;
    }
    for key in ["balance", "synthesis"].into_iter().filter(|key| v.has(key)) {
        refuse(
            key,
            format!("a balance, and a change point at {angle} of the working range"),
            "no finite force in its rod holds there",
            format!("leave out [luffing.{key}], or {away}"),
        );
    }
    if !moves && v.has("Q") {
        refuse(
            "Q",
            format!("a load, and a change point at {angle} of the working range"),
            "no finite forces in the pins carry it there",
            format!(
                "leave out Q and [luffing.weights], which kinematics does not need, or {away}; fidelity = \"rigid\" passes \
                 with the moment of its drive"
            ),
        );
    }
    Some(at)
}

/// Which part of the range is left out.
fn missing(arcs: &[Arc], motion: &Motion) -> String {
    const PARTS: u32 = 1000;
    let part = (motion.to - motion.from) / f64::from(PARTS);
    let open: Vec<f64> = (0..=PARTS)
        .map(|i| motion.from + part * f64::from(i))
        .filter(|&angle| !arcs.iter().any(|arc| arc.covers(angle, angle)))
        .collect();
    let (Some(&first), Some(&last)) = (open.first(), open.last()) else {
        return "the parts in which it closes do not join".to_owned();
    };
    // The grid stops short of where an arc begins or ends.
    let ends = || arcs.iter().flat_map(|arc| [arc.from, arc.to]);
    let edge = |angle: f64| {
        let near = |end: f64| end + TAU * ((angle - end) / TAU).round();
        ends()
            .map(near)
            .find(|end| (end - angle).abs() <= part)
            .unwrap_or(angle)
    };
    format!(
        "does not close from {} to {}",
        degrees(edge(first)),
        degrees(edge(last))
    )
}

/// Reads a published table over the coordinate; mistakes go to `found`.
fn published(v: &Values, coordinate: &'static Symbol, found: &mut Vec<Diagnostic>) -> Option<Published> {
    let before = found.len();
    let source = v.words("source")?;
    let wrong = |place: &Range<usize>, message: String, label: &str, help: &str| {
        Diagnostic::new(place.clone(), message, label).help(help)
    };
    let Some(((names, place), lines)) = v.texts("values").split_first() else {
        let help = "begin with a line of names: the angle of the driving link, then results";
        wrong(
            &v.place("values"),
            "published values without a line".to_owned(),
            "empty",
            help,
        );
        return None;
    };
    let mut columns = Vec::new();
    for name in names.split_whitespace() {
        match s::ALL.iter().copied().find(|symbol| symbol.id == name) {
            Some(symbol) => columns.push(symbol),
            None => {
                let message = format!("published values of `{name}`, which is not a result");
                found.push(wrong(place, message, "not known", "use the names of `lemnis check`"));
            }
        }
    }
    if found.len() == before && columns.first() != Some(&coordinate) {
        let message = format!("published values begin with {names}");
        let help = format!("the first column is {}, the angle of the driving link", coordinate.id);
        found.push(wrong(place, message, "not the angle", &help));
    }
    let mut rows = Vec::new();
    for (line, place) in lines {
        let row: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        if row.len() != names.split_whitespace().count()
            || row.iter().any(|cell| !cell.parse().is_ok_and(f64::is_finite))
        {
            let message = format!("published values: cannot read the line \"{line}\"");
            found.push(wrong(place, message, "not this", "give one number for each name"));
        }
        rows.push(row);
    }
    (found.len() == before).then(|| Published {
        source: source.clone(),
        columns,
        rows,
    })
}
