//! Everything a book says about a luffing mechanism.

mod motion;

use crate::balance::symbols as b;
use crate::component::dependencies::{Recorder, recorded};
use crate::component::outline::Explained::{Row, Stage};
use crate::component::outline::{Greatest, Limit, Most, Outline, Published, Told};
use crate::component::sheet::{self, Check, Drawing, Input, Sheet, Summary};
use crate::component::standing::Standing;
use crate::component::telling::{fine, sample};
use crate::kernel::origin::Origins;
use crate::kernel::symbol::Symbol;
use crate::luffing::counterweight::BalancedBoom;
use crate::luffing::double_link::balancing::{self, agreement, analysis, residual};
use crate::luffing::double_link::drawing::drawing;
use crate::luffing::double_link::geometry::{Driven, Geometry};
use crate::luffing::double_link::model::standing;
use crate::luffing::double_link::moving::symbols as m;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::range::{Rise, rise_by_integration};
use crate::luffing::double_link::scene::Luffing;
use crate::luffing::double_link::stages::DoubleLink;
use crate::luffing::double_link::statics::{LoadMoment, Own, PinForces};
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::velocity::Velocity;

static OUTLINE: Outline = Outline {
    constants: &[
        ("geometry_constants", &[Stage("geometry")]),
        ("balance_constants", &[Stage("balancing")]),
    ],
    sections: &[
        ("position", &[Stage("position")]),
        (
            "angles",
            &[
                Row(&s::THETA_3),
                Row(&s::THETA_1),
                Row(&s::ALPHA_1),
                Row(&s::Y),
                Row(&s::L),
                Row(&s::MU),
            ],
        ),
        ("velocity", &[Stage("velocity"), Stage("head"), Row(&s::BETA)]),
        ("pole", &[Stage("pole")]),
        ("load_moment", &[Stage("load_moment"), Stage("by_pole")]),
        ("weight_moment", &[Stage("own")]),
        ("drive", &[Stage("drive"), Stage("stroke"), Stage("flow")]),
        ("balance", &[Stage("residual"), Stage("balanced")]),
        ("pin_forces", &[Stage("held"), Stage("push"), Stage("feet")]),
        ("published_forms", &[Stage("published")]),
    ],
    table: &[
        &s::THETA_3,
        &s::THETA_1,
        &s::R,
        &s::A_Y,
        &s::ALPHA,
        &s::ALPHA_1,
        &s::MU,
        &s::V_AX,
        &s::M_Q,
        &s::M_D,
        &s::F_D,
    ],
    curves: &[
        ("li2022_fig_3", Some(&s::P_X), &s::P_Y),
        ("li2022_fig_4", None, &s::THETA_3),
        ("li2022_fig_4", None, &s::THETA_1),
        ("li2022_fig_5", None, &s::ALPHA_1),
        ("li2022_fig_6", Some(&s::R), &s::A_Y),
        ("li2022_fig_7", None, &s::V_AX),
        ("li2022_fig_8", None, &s::M_Q),
    ],
    extremes: &[
        Greatest::new(&s::R_MAX, Most::Greatest, &s::R),
        Greatest::new(&s::R_MIN, Most::Least, &s::R),
        Greatest::new(&s::MU_MIN, Most::Least, &s::MU),
        Greatest::new(&s::V_AX_MAX, Most::Amount, &s::V_AX),
        Greatest::new(&s::M_Q_MAX, Most::Amount, &s::M_Q),
        Greatest::new(&s::M_D_MAX, Most::Amount, &s::M_D),
        Greatest::new(&s::N_3_MAX, Most::Amount, &s::N_3),
        Greatest::new(&s::F_D_MAX, Most::Amount, &s::F_D).with_pole(&s::H_D),
    ],
    summary: &[&s::DELTA_Y, &s::EPSILON_Y],
    sensitivity: &[
        &s::MU_MIN,
        &s::EPSILON_Y,
        &s::R_MAX,
        &s::M_Q_MAX,
        &s::F_D_MAX,
        &b::DM_MAX,
        &b::N_MAX,
    ],
    limits: &[
        Limit::at_least("transmission_angle", &s::MU_MIN),
        Limit::at_most("level_error", &s::EPSILON_Y),
        Limit::at_most("balance_residual", &b::DM_MAX),
        Limit::at_least("balance_transmission", &b::GAMMA_MIN),
        Limit::at_most("balance_rod", &b::N_MAX),
    ],
    worst: ("governing", &s::M_Q_MAX),
};

impl Told for Luffing {
    fn outline(&self) -> &'static Outline {
        &OUTLINE
    }

    fn standing(&self) -> Standing {
        let closed = Luffing {
            table: None,
            ..self.clone()
        };
        standing(&closed).expect("a scene that was read has a mechanism")
    }

    fn recorder(&self) -> Recorder {
        recorded::<DoubleLink>
    }

    fn limit(&self, symbol: &'static Symbol) -> Option<f64> {
        self.limits
            .iter()
            .find(|(known, _)| *known == symbol)
            .map(|(_, limit)| *limit)
    }

    fn searched(&self) -> Vec<Summary> {
        let at = self.parameters.driven.coordinate();
        let found = analysis(&self.parameters, &self.motion).expect("checked when the scene was read");
        found.map_or(Vec::new(), |found| found.extremes(at))
    }

    fn identities(&self, model: &mut Standing) -> Vec<Check> {
        let (p, motion) = (&self.parameters, &self.motion);
        let (Ok(g), Some(rise)) = (Geometry::new(p), Rise::new(p, motion)) else {
            return Vec::new();
        };
        let mut checks = Vec::new();
        let mut agree = |id, value, limit| {
            checks.push(Check {
                id,
                symbol: &s::AGREEMENT,
                value,
                limit,
                at_most: true,
            });
        };
        if p.balance.is_some() {
            let [work, power] = agreement(p, motion, fine(motion));
            agree("balance_work", work, 1e-12);
            agree("balance_power", power, 1e-12);
        }
        let Some(q) = self.q else { return checks };
        // Agreement of independent ways, relative to the largest moment.
        let (integral, difference) = (rise_by_integration(&g, motion), rise.whole);
        let scale = rise.steepest.abs();
        let energy = ((integral - difference) / (scale * (motion.to - motion.from))).abs();
        agree("energy_identity", energy, 1e-9);
        let both = sample(model, &[&s::M_Q, &s::M_Q_P], fine(motion));
        let most = both.iter().map(|row| (row[0] - row[1]).abs()).fold(0.0, f64::max);
        agree("moment_agreement", most / (q.max(f64::MIN_POSITIVE) * scale), 1e-12);
        if self.has_pins() {
            agree("equilibrium", equilibrium(self, &g), 1e-12);
        }
        checks
    }

    fn totals(&self) -> Vec<Summary> {
        let (p, motion) = (&self.parameters, &self.motion);
        let (Some(q), Ok(g), Some(rise)) = (self.q, Geometry::new(p), Rise::new(p, motion)) else {
            return Vec::new();
        };
        let alone = |symbol, value| Summary {
            symbol,
            value,
            at: None,
        };
        vec![
            alone(&s::W_Q, q * rise_by_integration(&g, motion)),
            alone(&s::W_Y, q * rise.whole),
        ]
    }

    fn published(&self) -> Option<&Published> {
        self.published.as_ref()
    }

    /// The instantaneous centre runs to infinity: what is drawn of it ends at five times the crane's size. With boom
    /// and rocker always parallel nothing is left.
    fn pieces(&self, id: &'static str, points: Vec<[f64; 2]>) -> Vec<Vec<[f64; 2]>> {
        if id != "li2022_fig_3" {
            return vec![points];
        }
        let size = 5.0 * (self.parameters.lengths.x_1 + self.parameters.lengths.x_4);
        let drawable = |point: &[f64; 2]| point.iter().all(|x| x.abs() <= size);
        let whole = |a: &[f64; 2], b: &[f64; 2]| drawable(a) && drawable(b) && (a[1] > 0.0) == (b[1] > 0.0);
        let pieces = points.chunk_by(whole).filter(|piece| piece.len() > 1);
        pieces.map(<[_]>::to_vec).collect()
    }

    fn assumptions(&self) -> Vec<&'static str> {
        let given = |known: bool, id: &'static str| known.then_some(id);
        let forces = given(self.q.is_some(), "forces");
        let Some(moving) = &self.moving else {
            let level = if self.table.is_some() {
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
            given(self.parameters.balance.is_some(), "counterweight"),
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

    fn drawing(&self) -> Drawing {
        let g = Geometry::new(&self.parameters).expect("checked when the scene was read");
        drawing(&g, self)
    }

    fn remarks(&self) -> Vec<&'static str> {
        remarks(self)
    }

    fn inputs(&self, origins: &Origins) -> Vec<Input> {
        inputs(origins, self)
    }

    fn more(&self, model: &mut Standing, sheet: &mut Sheet) {
        sheet.balance = balance(model, self);
        let moving = self.moving.as_ref().and_then(|moving| motion::motion(self, moving));
        if let Some((motion, checks, warned)) = moving {
            sheet.checks.extend(checks);
            sheet.warnings.extend(warned);
            sheet.motion = Some(motion);
        }
    }
}

fn inputs(origins: &Origins, luffing: &Luffing) -> Vec<Input> {
    let mut inputs = Vec::new();
    let mut add = |chapter: &'static str, table: &str, name: &str, symbol: &'static Symbol, value: f64| {
        inputs.push(Input {
            symbol,
            number: None,
            value,
            chapter,
            given: origins.of(&format!("luffing.{table}{name}")).cloned(),
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
        luffing.parameters.driven.rate(),
        motion.speed,
    );
    if let Some(moving) = &luffing.moving {
        // What the scene leaves to itself is no input of the book.
        let mut table = |chapter: &'static str, table: &'static str, symbol: &'static Symbol, value: f64| {
            if origins.of(&format!("luffing.{table}{}", symbol.id)).is_some() {
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
    for &(symbol, value) in &luffing.limits {
        add("limits", "limits.", symbol.id, symbol, value);
    }
    inputs
}

/// The drive's moment by equilibrium of the bodies against virtual work of load
/// and weights: largest difference over the range, relative to the largest moment.
fn equilibrium(luffing: &Luffing, g: &Geometry<f64>) -> f64 {
    let (lengths, weights) = (&g.lengths, &luffing.parameters.weights);
    let q = luffing.q.unwrap_or(0.0);
    let balancing = balancing::new(&luffing.parameters, &luffing.motion).ok().flatten();
    let (mut worst, mut scale) = (0.0_f64, f64::MIN_POSITIVE);
    for theta in fine(&luffing.motion) {
        let Some(p) = Position::new(g, theta) else { continue };
        let v = Velocity::new(&p);
        let own = weights.as_ref().map(|w| Own::new(&p, &v, lengths, w));
        let with = balancing.as_ref().zip(weights.as_ref()).zip(own.as_ref());
        let residual = with.and_then(|((balancing, w), own)| balancing::at(balancing, g, &p, &v, w, own, &theta).ok());
        let turn = if p.driven == Driven::Boom { 1.0 } else { v.i_follower };
        let carried = residual.as_ref().map_or(0.0, |residual| residual.action.m_b * turn);
        let work = LoadMoment::new(&v, &q).m_q + own.as_ref().map_or(0.0, |own| own.m_g) - carried;
        let m_d = PinForces::new(&p, &q, weights, own.as_ref(), residual.as_ref()).m_d;
        worst = worst.max((m_d - work).abs());
        // What is left of great moments may be nothing.
        scale = scale.max(work.abs()).max(carried.abs());
    }
    worst / scale
}

/// `None` where the scene has no balance.
fn balance(model: &mut Standing, luffing: &Luffing) -> Option<sheet::BalanceSheet> {
    let (p, motion) = (&luffing.parameters, &luffing.motion);
    let (g, weights) = (Geometry::new(p).ok()?, p.weights.as_ref()?);
    let balancing = balancing::new(p, motion).ok()??;
    let at = |theta: f64| {
        Some((
            Position::new(&g, theta)?.b,
            residual(&balancing, &g, weights, theta).ok()?,
        ))
    };
    let balanced = BalancedBoom {
        form: p.balance?,
        balancing,
        found: analysis(p, motion).ok()??,
        motion: *motion,
        published: luffing.published_balance.as_ref(),
        coordinate: p.driven.coordinate(),
        angle: &s::THETA_1,
        reach: &s::R,
        moment: &s::M_D,
        at: &at,
    };
    balanced.chapter(model)
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
