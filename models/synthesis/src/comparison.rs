//! What the book says about a synthesis: the levers that the scene lists beside
//! its own, each worked out anew, so that nothing printed can be out of date.

use lemnis_models::balance::analysis::Analysis;
use lemnis_models::balance::boom::{Boom, joint};
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::balance::residual::Residual;
use lemnis_models::balance::task::{CandidateRole, Method, Search, Task};
use lemnis_models::balance::{Balance, symbols as s};
use lemnis_models::component::sheet::{Drawing, Shape};
use lemnis_models::kernel::allowed::OutOfRange;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::text::Text;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::parts::plane::Point;
use lemnis_models::scene::Scene;

use crate::candidate::Positions;
use crate::tolerance::{Builds, Spread};

/// All of it.
#[derive(Debug)]
pub struct Comparison {
    /// The scene's own lever last.
    pub levers: Vec<Compared>,
    /// Bounds of a search, beside what the last lever has.
    pub bounds: Vec<Bound>,
    /// Constraints, beside what the last lever keeps of them.
    pub limits: Vec<Bound>,
    /// Rod force or counterweight (SI) and the least residual (N·m) for it, rising.
    pub fronts: Vec<Front>,
    /// The positions of a construction, where the last lever comes from one.
    pub nodes: Option<Nodes>,
}

/// A lever and what it is worth.
#[derive(Debug)]
pub struct Compared {
    /// `found`, or the role of a candidate; `own` where nothing was searched for yet.
    pub role: &'static str,
    pub source: Option<Text>,
    pub branch: Branch,
    pub dimensions: Dimensions<f64>,
    /// `None` where it does not close over the whole range.
    pub worth: Option<Worth>,
}

#[derive(Debug)]
pub struct Worth {
    pub analysis: Analysis,
    /// `None` where too many builds do not close.
    pub spread: Option<Spread>,
    /// Boom angle (rad) and residual (N·m).
    pub residual: Vec<[f64; 2]>,
    pub drawing: Drawing,
    /// Greatest cosine of the counterweight arm's angle.
    cos_psi: f64,
}

/// A quantity between its bounds, in SI; infinite where there is none.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    pub symbol: &'static Symbol,
    pub value: Option<f64>,
    pub low: f64,
    pub high: f64,
    /// The value lies at the bound of a search: easing it leads to a better lever.
    pub binds: bool,
}

impl Bound {
    /// Whether the value lies outside, which only a construction leaves so.
    #[must_use]
    pub fn missed(&self) -> bool {
        let size = NEAR * self.low.abs().min(self.high.abs());
        self.value
            .is_some_and(|value| value < self.low - size || value > self.high + size)
    }
}

#[derive(Debug)]
pub struct Front {
    pub symbol: &'static Symbol,
    pub points: Vec<[f64; 2]>,
}

/// Positions of a construction.
#[derive(Debug)]
pub struct Nodes {
    /// Boom angle (rad), angle of the counterweight's arm (rad), residual (N·m).
    pub rows: Vec<[f64; 3]>,
    /// dψ/dφ at the first, of four positions.
    pub slope: Option<f64>,
    /// They are those of Balance004, whose printed ordinates contradict them.
    pub contradicted: bool,
}

/// Levers that the comparison begins with.
const ORDER: [CandidateRole; 3] = [CandidateRole::Existing, CandidateRole::Published, CandidateRole::Start];
/// Points of a drawn curve.
const CURVE: u32 = 240;
/// Builds of the tolerance's Monte Carlo.
pub const BUILDS: usize = 2000;
/// A value lies at its bound within this part of it; scenes are rounded less.
const NEAR: f64 = 1e-3;

impl Comparison {
    /// `None` for a scene without a synthesis.
    #[must_use]
    pub fn new(scene: &Scene) -> Option<Comparison> {
        let Search {
            task,
            boom,
            range,
            length,
            own,
        } = scene.search()?;
        let boom = &*boom;
        let positions = Positions::new(boom, range, 101).ok()?;
        let builds = Builds::new(&positions, task.tolerances, BUILDS, task.seed).ok()?;
        let compared = |role, source: Option<&Text>, dimensions, branch| Compared {
            role,
            source: source.cloned(),
            branch,
            dimensions,
            worth: worth(boom, range, &positions, &builds, length, dimensions, branch).ok(),
        };
        let is_front = |role| matches!(role, CandidateRole::RodForce | CandidateRole::Counterweight);
        let candidates = task.candidates.iter();
        let mut levers: Vec<Compared> = candidates
            .filter(|candidate| !is_front(candidate.role))
            .map(|c| compared(c.role.name(), c.source.as_ref(), c.dimensions, c.branch))
            .collect();
        levers.sort_by_key(|lever| ORDER.iter().position(|role| role.name() == lever.role));
        if let Some(own) = &own {
            let role = if task.found.is_some() { "found" } else { "own" };
            levers.push(compared(role, None, own.dimensions, own.branch));
        }
        let last = own.as_ref().and_then(|_| levers.last());
        Some(Comparison {
            bounds: if task.method == Method::Optimum {
                bounds(task, last)
            } else {
                Vec::new()
            },
            limits: limits(task, last),
            fronts: fronts(task, boom, range, last),
            nodes: own.as_ref().and_then(|own| nodes(task, boom, own)),
            levers,
        })
    }
}

impl Compared {
    /// What the table of criteria lists, in SI.
    #[must_use]
    pub fn criteria(&self) -> Vec<(&'static Symbol, Option<f64>)> {
        let of = |pick: &dyn Fn(&Worth) -> Option<f64>| self.worth.as_ref().and_then(pick);
        let mut rows = Vec::new();
        self.dimensions
            .map(&mut |symbol, value| rows.push((symbol, Some(value))));
        rows.extend([
            (&s::DM_MAX, of(&|w| Some(w.analysis.dm_max.value))),
            (&s::E, of(&|w| Some(w.analysis.e_abs))),
            (&s::GAMMA_MIN, of(&|w| w.analysis.gamma_min.map(|e| e.value))),
            (&s::N_MAX, of(&|w| w.analysis.n_max.map(|e| e.value))),
            (&s::DM_50, of(&|w| w.spread.map(|spread| spread.median))),
            (&s::DM_95, of(&|w| w.spread.map(|spread| spread.dm_95))),
        ]);
        rows
    }
}

fn worth(
    boom: &(dyn Boom<f64> + Sync),
    range: [f64; 2],
    positions: &Positions,
    builds: &Builds,
    length: f64,
    d: Dimensions<f64>,
    branch: Branch,
) -> Result<Worth, OutOfRange> {
    let lever = Lever::new(d, None, branch)?;
    let balance = Balance::Lever(lever);
    let analysis = Analysis::new(boom, &balance, range)?;
    let [from, to] = range;
    let residual = (0..=CURVE).map(|i| {
        let phi = if i == CURVE {
            to
        } else {
            from + (to - from) * f64::from(i) / f64::from(CURVE)
        };
        Ok([phi, Residual::new(boom, &balance, phi)?.dm])
    });
    let closes = |_| OutOfRange::new(&s::L_1, d.l_1, [0.0, f64::INFINITY], "does not close");
    Ok(Worth {
        residual: residual.collect::<Result<_, OutOfRange>>()?,
        spread: Spread::new(builds, positions, &d, branch).ok(),
        drawing: drawing(&lever, range, length)?,
        cos_psi: positions.evaluate(&d, branch).map_err(closes)?.cos_psi,
        analysis,
    })
}

fn bounds(task: &Task, last: Option<&Compared>) -> Vec<Bound> {
    let mut values = Vec::new();
    if let Some(last) = last {
        last.dimensions.map(&mut |_, value| values.push(value));
    }
    let mut values = values.into_iter();
    let mut found = Vec::new();
    task.bounds.map(&mut |symbol, [low, high]| {
        let value = values.next();
        let near = |value: f64| (value - low).min(high - value) <= NEAR * (high - low);
        found.push(Bound {
            symbol,
            value,
            low,
            high,
            binds: low < high && value.is_some_and(near),
        });
    });
    found
}

fn limits(task: &Task, last: Option<&Compared>) -> Vec<Bound> {
    let k = &task.constraints;
    let worth = last.and_then(|last| last.worth.as_ref());
    let whole = worth.map(|worth| &worth.analysis);
    let inf = f64::INFINITY;
    // Of the ends, what lies near in comparison with the residual counts.
    let scale = whole.map_or(1.0, |whole| whole.dm_max.value);
    let mut found = Vec::new();
    let mut add = |symbol, value: Option<f64>, [low, high]: [f64; 2], size: f64| {
        let near = |value: f64| (value - low).min(high - value) <= NEAR * size;
        let binds = task.method == Method::Optimum && value.is_some_and(near);
        found.push(Bound {
            symbol,
            value,
            low,
            high,
            binds,
        });
    };
    let gamma = whole.and_then(|whole| whole.gamma_min).map(|e| e.value);
    add(&s::GAMMA_MIN, gamma, [k.gamma_min, inf], k.gamma_min);
    if let Some(least) = k.m_plus {
        let ends = whole.map(|whole| whole.ends[0].min(-whole.ends[1]));
        add(&s::M_PLUS, ends, [least, inf], scale);
    }
    if let Some(most) = k.n_max {
        let force = whole.and_then(|whole| whole.n_max).map(|e| e.value);
        add(&s::N_MAX, force, [-inf, most], most);
    }
    if let Some(most) = k.dm_max {
        add(&s::DM_MAX, whole.map(|whole| whole.dm_max.value), [-inf, most], most);
    }
    if k.rearward {
        // From the horizontal in front, whichever way round.
        let angle = worth.map(|worth| Calc::acos(worth.cos_psi.clamp(-1.0, 1.0)));
        add(&s::PSI, angle, [std::f64::consts::FRAC_PI_2, inf], 1.0);
    }
    found
}

fn fronts(task: &Task, boom: &(dyn Boom<f64> + Sync), range: [f64; 2], last: Option<&Compared>) -> Vec<Front> {
    let sides = [
        (CandidateRole::RodForce, &s::N_MAX),
        (CandidateRole::Counterweight, &s::M_5),
    ];
    let mut fronts = Vec::new();
    for (role, symbol) in sides {
        let listed = task.candidates.iter().filter(|candidate| candidate.role == role);
        let listed = listed.map(|candidate| (candidate.dimensions, candidate.branch));
        let own = last.map(|last| (last.dimensions, last.branch));
        let mut points: Vec<[f64; 2]> = listed
            .chain(own)
            .filter_map(|(d, branch)| {
                let lever = Lever::new(d, None, branch).ok()?;
                let whole = Analysis::new(boom, &Balance::Lever(lever), range).ok()?;
                let at = if role == CandidateRole::RodForce {
                    whole.n_max?.value
                } else {
                    d.m_5
                };
                Some([at, whole.dm_max.value])
            })
            .collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        if points.len() > 2 {
            fronts.push(Front { symbol, points });
        }
    }
    fronts
}

fn nodes(task: &Task, boom: &(dyn Boom<f64> + Sync), own: &Lever<f64>) -> Option<Nodes> {
    let (p, four) = match task.method {
        Method::Optimum => return None,
        Method::Three { positions, .. } => (positions, false),
        Method::Four { positions, .. } => (positions, true),
    };
    let balance = Balance::Lever(*own);
    let row = |phi: f64| {
        let here = Residual::new(boom, &balance, phi).ok()?;
        Some([phi, here.action.lever?.psi, here.dm])
    };
    let rows: Vec<[f64; 3]> = p.phi.into_iter().filter_map(row).collect();
    let at = |phi: f64| own.at(phi).ok()?.lever.map(|turn| turn.i_5);
    let printed = [62.7, 45.8, 79.2].map(f64::to_radians);
    let same = p
        .phi
        .iter()
        .zip(printed)
        .all(|(phi, printed)| (phi - printed).abs() < 1e-9);
    Some(Nodes {
        slope: if four { at(p.phi[0]) } else { None },
        rows,
        contradicted: four && same,
    })
}

/// Length of the counterweight's arm as drawn, over the distance of the pivots:
/// only weight times arm is known.
const ARM: f64 = 0.3;

/// The lever at the ends (faint) and in the middle of the range.
fn drawing(lever: &Lever<f64>, [from, to]: [f64; 2], length: f64) -> Result<Drawing, OutOfRange> {
    let d = &lever.dimensions;
    let (sin, cos) = Calc::sin_cos(d.delta_1);
    let pivot = [d.d_1 * cos, d.d_1 * sin];
    let xy = |p: Point<f64>| [p.x, p.y];
    let polar = |[x, y]: [f64; 2], r: f64, angle: f64| {
        let (sin, cos) = Calc::sin_cos(angle);
        [x + r * cos, y + r * sin]
    };
    let mut shapes = Vec::new();
    for (phi, faint) in [(from, true), (to, true), (f64::midpoint(from, to), false)] {
        let psi = lever.at(phi)?.lever.expect("a lever turns").psi;
        let k = xy(joint(phi, d.r_1, d.alpha_1));
        let l = polar(pivot, d.lever, psi - d.chi_5);
        let c = polar(pivot, ARM * d.d_1, psi);
        let half = 0.06 * d.d_1;
        let head = polar([0.0; 2], length.min(1.2 * d.d_1), phi);
        let bar = |points: Vec<[f64; 2]>| Shape::Body {
            points,
            closed: false,
            faint,
        };
        shapes.extend([
            bar(vec![[0.0; 2], head]),
            bar(vec![[0.0; 2], k]),
            bar(vec![k, l]),
            bar(vec![l, pivot, c]),
        ]);
        let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
        shapes.push(Shape::Body {
            points: corners.map(|[x, y]| [c[0] + x, c[1] + y]).to_vec(),
            closed: true,
            faint,
        });
        shapes.extend([k, l].map(|at| Shape::Pin {
            at,
            fixed: false,
            faint,
        }));
        if !faint {
            shapes.extend([(k, "K"), (l, "L")].map(|(at, text)| Shape::Label { at, text }));
        }
    }
    for (at, text) in [([0.0; 2], "O"), (pivot, "M")] {
        shapes.push(Shape::Pin {
            at,
            fixed: true,
            faint: false,
        });
        shapes.push(Shape::Label { at, text });
    }
    Ok(Drawing { shapes })
}
