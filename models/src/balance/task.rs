//! What a scene asks of the synthesis of a lever counterweight: the table
//! `[luffing.synthesis]`. The search itself is the crate `lemnis_synthesis`.

use std::f64::consts::FRAC_PI_2;
use std::ops::Range;
use std::sync::Arc;

use crate::balance::asked::BOUNDS;
use crate::balance::boom::Boom;
use crate::balance::lever::{Dimensions, Lever};
use crate::balance::symbols as s;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;
use crate::parts::four_bar::Branch;

/// How a lever is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    Optimum,
    /// Three positions of equal energy, with the joint on the boom. [Ports001, 2.2.1]
    Three {
        positions: Positions,
        /// In m and rad.
        r_1: f64,
        alpha_1: f64,
    },
    /// Four positions, with the rod arm of the lever, in m. [Balance004, eq. 4]
    Four {
        positions: Positions,
        lever: f64,
    },
}

/// What both constructions start from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Positions {
    /// Boom angles, in rad.
    pub phi: [f64; 3],
    /// Counterweight's arm at the first of them, in rad.
    pub psi_1: f64,
    /// Weight of the counterweight times its arm, in N·m.
    pub m_5: f64,
}

/// What is minimised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// Greatest amount of the residual.
    Residual,
    /// Integral of the residual's amount.
    Energy,
    /// Greatest force in the rod.
    RodForce,
}

/// What a solution must keep.
#[derive(Clone, Copy, Debug)]
pub struct Constraints {
    /// Smallest transmission angle, in rad.
    pub gamma_min: f64,
    /// Stable ends: at least this moment turns the boom inwards, in N·m. [Balance004, eq. 6-7]
    pub m_plus: Option<f64>,
    /// Greatest force in the rod, in N.
    pub n_max: Option<f64>,
    /// Greatest amount of the residual, in N·m, when something else is minimised.
    pub dm_max: Option<f64>,
    /// The counterweight stays behind the lever's pivot.
    pub rearward: bool,
}

/// Smallest and greatest value of each dimension; equal where it is fixed.
pub type Bounds = Dimensions<[f64; 2]>;

/// Tolerances, each to both sides.
#[derive(Clone, Copy, Debug)]
pub struct Tolerances {
    /// Of every length, in m.
    pub length: f64,
    /// Of every angle, in rad.
    pub angle: f64,
    /// Of every weight, relative.
    pub weight: f64,
}

/// What a candidate is to the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CandidateRole {
    Existing,
    Published,
    Start,
    /// Points of the fronts.
    RodForce,
    Counterweight,
}

impl CandidateRole {
    /// As scenes write it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            CandidateRole::Existing => "existing",
            CandidateRole::Published => "published",
            CandidateRole::Start => "start",
            CandidateRole::RodForce => "rod_force",
            CandidateRole::Counterweight => "counterweight",
        }
    }
}

/// A lever that the scene lists.
#[derive(Clone, Debug)]
pub struct Candidate {
    pub role: CandidateRole,
    pub dimensions: Dimensions<f64>,
    pub branch: Branch,
    pub source: Option<Text>,
}

/// A synthesis as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct Task {
    pub method: Method,
    pub criterion: Criterion,
    /// The residual that 95 % of all builds stay below instead of the criterion.
    pub robust: bool,
    /// `None` for whichever is better.
    pub branch: Option<Branch>,
    pub seed: u64,
    pub bounds: Bounds,
    pub constraints: Constraints,
    pub tolerances: Tolerances,
    pub candidates: Vec<Candidate>,
    /// `[luffing.balance]` is the result of a search, which came to its end or not.
    pub found: Option<bool>,
    /// Where the scene gives what a fault may blame, by the symbol's id.
    places: Vec<(&'static str, Range<usize>)>,
    /// Place of its table.
    pub span: Range<usize>,
}

/// Default bounds over the distance of the pivots.
const R_1: [f64; 2] = [0.03, 1.2];
const L_1: [f64; 2] = [0.1, 2.0];
const LEVER: [f64; 2] = [0.03, 0.6];

/// A synthesis that a scene asks for, and what it is to balance.
pub struct Search<'a> {
    pub task: &'a Task,
    pub boom: Arc<dyn Boom<f64> + Send + Sync>,
    /// Angles of the boom over the working range, in rad.
    pub range: [f64; 2],
    /// Length of the boom, in m.
    pub length: f64,
    /// The scene's own lever counterweight.
    pub own: Option<Lever<f64>>,
}

impl Task {
    /// The task of a checked table; mistakes go to `found`. `boom` over the
    /// boom angles `range` (rad) is to be balanced, `own` is the scene's lever.
    pub fn new(
        v: &Values,
        boom: &(dyn Boom<f64> + Sync),
        range: [f64; 2],
        own: Option<&Lever<f64>>,
        found: &mut Vec<Diagnostic>,
    ) -> Option<Task> {
        let before = found.len();
        let method = method(v, found);
        let bounds = dimension_bounds(v, boom, range, own, found);
        let constraints = constraints(v, found);
        let tolerances = tolerances(v, found);
        let criterion = match v.text("objective") {
            Some("E") => Criterion::Energy,
            Some("N_max") => Criterion::RodForce,
            _ => Criterion::Residual,
        };
        if criterion == Criterion::RodForce && constraints.dm_max.is_none() {
            found.push(v.refuse(
                "objective",
                "the least rod force without a limit of the residual: no counterweight at all",
                "nothing to search for",
                "add dM_max = \"... kN.m\" to [luffing.synthesis.constraints]",
            ));
        }
        let task = Task {
            method: method?,
            criterion,
            robust: v.text("objective") == Some("dM_95"),
            branch: Branch::read(v),
            seed: v.count("seed").unwrap_or(1),
            bounds: bounds?,
            constraints,
            tolerances,
            candidates: v.tables("candidates").iter().filter_map(candidate).collect(),
            found: v.text("found").map(|text| text == "complete"),
            places: places(v),
            span: v.span.clone(),
        };
        let starts = v.tables("candidates").iter().zip(&task.candidates);
        for (i, (table, start)) in starts.filter(|(_, c)| c.role == CandidateRole::Start).enumerate() {
            if i > 0 {
                let message = "the search can start from one lever only";
                found.push(table.refuse("role", message, "a second start", "remove one of them"));
            }
            task.outside(&start.dimensions, |symbol, value, [low, high]| {
                found.push(table.refuse(
                    symbol.id,
                    format!(
                        "the start lies outside the bounds: {} = {}",
                        symbol.id,
                        symbol.written(value)
                    ),
                    "outside",
                    format!(
                        "it may be {} to {}: move the start or widen [luffing.synthesis.bounds]",
                        symbol.written(low),
                        symbol.written(high)
                    ),
                ));
            });
        }
        (found.len() == before).then_some(task)
    }

    /// Place in the scene of what a fault blames; of the whole table where it is not given.
    #[must_use]
    pub fn place(&self, symbol: &Symbol) -> Range<usize> {
        let place = self.places.iter().find(|(id, _)| *id == symbol.id);
        place.map_or_else(|| self.span.clone(), |(_, place)| place.clone())
    }

    fn outside(&self, d: &Dimensions<f64>, mut tell: impl FnMut(&'static Symbol, f64, [f64; 2])) {
        let mut values = Vec::new();
        d.map(&mut |_, value| values.push(value));
        let mut values = values.into_iter();
        self.bounds.map(&mut |symbol, [low, high]| {
            let value = values.next().expect("as many bounds as dimensions");
            if !(low..=high).contains(&value) {
                tell(symbol, value, [low, high]);
            }
        });
    }
}

fn method(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Method> {
    let name = v.text("method").unwrap_or("optimum");
    if name == "optimum" {
        return Some(Method::Optimum);
    }
    let Some(p) = v.table("positions") else {
        found.push(v.refuse(
            "method",
            format!("the method \"{name}\" needs positions"),
            "from which positions?",
            "add [luffing.synthesis.positions] with phi, psi_1, M_5 and the joint",
        ));
        return None;
    };
    let phi: Vec<f64> = p.numbers("phi").iter().map(|(phi, _)| *phi).collect();
    let positions = Positions {
        phi: phi.try_into().ok()?,
        psi_1: p.number("psi_1")?,
        m_5: p.number("M_5")?,
    };
    let [wanted, other]: [&[&str]; 2] = if name == "three" {
        [&["r_1", "alpha_K"], &["R_1"]]
    } else {
        [&["R_1"], &["r_1", "alpha_K"]]
    };
    let before = found.len();
    for key in wanted.iter().filter(|key| p.number(key).is_none()) {
        let message = format!("`{key}` is missing in [luffing.synthesis.positions]");
        let help = format!("the method \"{name}\" needs it");
        found.push(Diagnostic::new(p.span.clone(), message, "needed here").help(help));
    }
    for key in other.iter().filter(|key| p.number(key).is_some()) {
        let message = format!("`{key}` follows from the method \"{name}\" and cannot be given");
        found.push(p.refuse(key, message, "not free", "remove it"));
    }
    if found.len() > before {
        return None;
    }
    Some(if name == "three" {
        Method::Three {
            positions,
            r_1: p.number("r_1")?,
            alpha_1: p.number("alpha_K")?,
        }
    } else {
        Method::Four {
            positions,
            lever: p.number("R_1")?,
        }
    })
}

fn dimension_bounds(
    v: &Values,
    boom: &(dyn Boom<f64> + Sync),
    range: [f64; 2],
    own: Option<&Lever<f64>>,
    found: &mut Vec<Diagnostic>,
) -> Option<Bounds> {
    let table = v.table("bounds");
    let given = |symbol: &Symbol| -> Option<[f64; 2]> {
        match table?.numbers(symbol.id) {
            [(fixed, _)] => Some([*fixed; 2]),
            [(low, _), (high, _)] => Some([*low, *high]),
            _ => None,
        }
    };
    let before = found.len();
    for key in BOUNDS.iter().filter(|key| key.name != "source") {
        let Some(table) = table else { break };
        if let [(low, _), (high, place)] = table.numbers(key.name)
            && low > high
        {
            let message = format!("the bounds of `{}` are upside down", key.name);
            found.push(
                Diagnostic::new(place.clone(), message, "smaller than the first")
                    .help("give the smallest value first, then the greatest"),
            );
        }
    }
    let own = own.map(|own| own.dimensions);
    let pivot = |symbol: &'static Symbol, value: Option<f64>| given(symbol).or(value.map(|value| [value; 2]));
    let (d_1, delta_1) = (
        pivot(&s::D_1, own.map(|d| d.d_1)),
        pivot(&s::DELTA_1, own.map(|d| d.delta_1)),
    );
    let (Some(d_1), Some(delta_1)) = (d_1, delta_1) else {
        found.push(
            Diagnostic::new(
                v.span.clone(),
                "the pivot of the lever is not given",
                "d_1 and delta_1 are needed",
            )
            .help("add d_1 = \"... m\" and delta_1 = \"... deg\" to [luffing.synthesis.bounds]"),
        );
        return None;
    };
    if found.len() > before {
        return None;
    }
    // Not heavier than today's, otherwise no more than what has to be balanced.
    let m_5 = own.map_or_else(
        || {
            let [from, to] = range;
            let angles = (0..=10).map(|i| from + (to - from) * f64::from(i) / 10.0);
            let moments = angles.filter_map(|phi| boom.at(phi).ok());
            moments.map(|load| load.m_0.abs()).fold(0.0, f64::max)
        },
        |d| d.m_5,
    );
    if v.text("method").is_some_and(|method| method != "optimum") {
        for (symbol, [low, high]) in [(&s::D_1, d_1), (&s::DELTA_1, delta_1)] {
            if let Some(table) = table.filter(|_| low < high) {
                let message = format!("the method \"{}\" needs one `{}`", v.text("method")?, symbol.id);
                found.push(table.refuse(
                    symbol.id,
                    message,
                    "two values",
                    "give a single value; only the optimum searches for the pivot",
                ));
            }
        }
    }
    let over = |[low, high]: [f64; 2]| [low * d_1[1], high * d_1[1]];
    let angle = |symbol, limit: f64| given(symbol).unwrap_or([-limit, limit]);
    Some(Bounds {
        d_1,
        delta_1,
        r_1: given(&s::R_K).unwrap_or(over(R_1)),
        alpha_1: angle(&s::ALPHA_K, 2.0 * FRAC_PI_2),
        l_1: given(&s::L_1).unwrap_or(over(L_1)),
        lever: given(&s::R_L).unwrap_or(over(LEVER)),
        chi_5: angle(&s::CHI_5, 2.0 * FRAC_PI_2),
        m_5: given(&s::M_5).unwrap_or([0.1 * m_5, m_5]),
    })
}

fn constraints(v: &Values, found: &mut Vec<Diagnostic>) -> Constraints {
    let table = v.table("constraints");
    let number = |symbol: &Symbol| table.and_then(|table| table.number(symbol.id));
    let any = |key| table.and_then(|table| table.text(key)) == Some("any");
    let constraints = Constraints {
        gamma_min: number(&s::GAMMA_MIN).unwrap_or(std::f64::consts::FRAC_PI_6),
        m_plus: (!any("ends")).then(|| number(&s::M_PLUS).unwrap_or(0.0)),
        n_max: number(&s::N_MAX),
        dm_max: number(&s::DM_MAX),
        rearward: !any("counterweight"),
    };
    let Some(table) = table else { return constraints };
    if constraints.gamma_min >= FRAC_PI_2 {
        let message = format!("gamma_min = {}", s::GAMMA_MIN.written(constraints.gamma_min));
        found.push(table.refuse(
            "gamma_min",
            message,
            "no linkage keeps it",
            "a transmission angle lies between 0 and 90 deg; 30 deg is usual",
        ));
    }
    if any("ends") && number(&s::M_PLUS).is_some() {
        found.push(table.refuse(
            "M_plus",
            "a moment at ends that may be unstable",
            "contradicts `ends`",
            "remove M_plus, or ends = \"any\"",
        ));
    }
    if let (Some(least), Some(most)) = (constraints.m_plus, constraints.dm_max)
        && least > most
    {
        found.push(table.refuse(
            "M_plus",
            format!(
                "the ends shall have at least {} and no position more than {}",
                s::M_PLUS.written(least),
                s::DM_MAX.written(most)
            ),
            "more than dM_max allows",
            "lower M_plus or raise dM_max",
        ));
    }
    constraints
}

fn tolerances(v: &Values, found: &mut Vec<Diagnostic>) -> Tolerances {
    let table = v.table("tolerances");
    let number = |key: &str| table.and_then(|table| table.number(key));
    let tolerances = Tolerances {
        length: number("length").unwrap_or(1e-3),
        angle: number("angle").unwrap_or(0.05_f64.to_radians()),
        weight: number("weight").unwrap_or(0.01),
    };
    if let Some(table) = table.filter(|_| tolerances.weight > 0.5) {
        let message = format!("weights that may be off by {}", s::T_W.written(tolerances.weight));
        found.push(table.refuse("weight", message, "too much", "at most 50 %"));
    }
    tolerances
}

fn candidate(v: &Values) -> Option<Candidate> {
    Some(Candidate {
        role: match v.text("role")? {
            "existing" => CandidateRole::Existing,
            "published" => CandidateRole::Published,
            "start" => CandidateRole::Start,
            "rod_force" => CandidateRole::RodForce,
            _ => CandidateRole::Counterweight,
        },
        dimensions: Dimensions::of(|symbol| v.number(symbol.id))?,
        branch: Branch::read(v).unwrap_or(Branch::Left),
        source: v.words("source").cloned(),
    })
}

fn places(v: &Values) -> Vec<(&'static str, Range<usize>)> {
    let mut places = Vec::new();
    let mut add = |table: &str, keys: &[(&'static str, &str)]| {
        let Some(table) = v.table(table) else { return };
        for (id, key) in keys {
            let place = table.place(key);
            if place != table.span {
                places.push((*id, place));
            }
        }
    };
    if v.text("method").is_some_and(|method| method != "optimum") {
        let keys = ["phi", "M_5", "r_1", "alpha_K", "R_1"].map(|key| (key, key));
        add("positions", &keys);
        add("positions", &[("psi", "psi_1"), ("psi_1", "psi_1")]);
    }
    add(
        "constraints",
        &[
            ("gamma_min", "gamma_min"),
            ("N_max", "N_max"),
            ("dM_max", "dM_max"),
            ("M_plus", "M_plus"),
            ("M_plus", "ends"),
            ("psi", "counterweight"),
        ],
    );
    let keys: Vec<(&'static str, &str)> = BOUNDS.iter().map(|key| (key.name, key.name)).collect();
    add("bounds", &keys);
    places
}
