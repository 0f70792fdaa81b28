//! Everything a book says about a boom on a luffing rope.

use crate::balance::boom::Plain;
use crate::balance::symbols as b;
use crate::component::dependencies::{Recorder, recorded};
use crate::component::draw::Draw;
use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, Published, Told};
use crate::component::running::Running;
use crate::component::sheet::{Check, Drawing, Input, Sheet, Summary};
use crate::component::standing::Standing;
use crate::component::telling::{fine, sample};
use crate::kernel::calc::Calc;
use crate::kernel::group::{Group, One};
use crate::kernel::origin::Origins;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Quantity;
use crate::luffing::balancing::{Balancing, agreement};
use crate::luffing::counterweight::BalancedBoom;
use crate::luffing::rope::balancing::{analysed, balancing};
use crate::luffing::rope::position::{BoomPosition, Rig};
use crate::luffing::rope::scene::{Rope, TABLES};
use crate::luffing::rope::stages::RopeBoom;
use crate::luffing::rope::symbols as s;
use crate::parts::plane::{self, Point};

static OUTLINE: Outline = Outline {
    constants: &[
        ("rope_constants", &[Stage("level")]),
        ("balance_constants", &[Stage("balancing")]),
    ],
    sections: &[
        ("rope_position", &[Stage("position")]),
        ("rope_tackle", &[Stage("falls")]),
        ("rope_path", &[Stage("stretch"), Stage("path")]),
        ("rope_velocity", &[Stage("travel"), Stage("speeds")]),
        ("rope_load", &[Stage("hanging")]),
        ("rope_weight", &[Stage("own")]),
        ("balance", &[Stage("residual"), Stage("balanced")]),
        ("rope_pull", &[Stage("carried"), Stage("pull"), Stage("power")]),
        ("rope_losses", &[Stage("losses")]),
    ],
    table: &[
        &s::R,
        &s::A_Y,
        &s::Y_Q,
        &s::L_T,
        &s::L_L,
        &s::L_H,
        &s::V_Q,
        &s::M_Q,
        &s::M_D,
        &s::T,
        &s::N_B,
    ],
    curves: &[
        ("rope_path", Some(&s::R), &s::Y_Q),
        ("rope_moment", None, &s::M_D),
        ("rope_pull", None, &s::T),
        ("rope_drum", None, &s::S_L_UP),
    ],
    extremes: &[
        Greatest::new(&s::R_MAX, Most::Greatest, &s::R),
        Greatest::new(&s::R_MIN, Most::Least, &s::R),
        Greatest::new(&s::M_Q_MAX, Most::Amount, &s::M_Q),
        Greatest::new(&s::T_MAX, Most::Greatest, &s::T),
        Greatest::new(&s::S_L_MAX, Most::Greatest, &s::S_L_UP),
        Greatest::new(&s::N_B_MAX, Most::Amount, &s::N_B),
        Greatest::new(&s::P_L_MAX, Most::Amount, &s::P_L),
    ],
    summary: &[&s::DELTA_Y, &s::EPSILON_Y, &s::STROKE, &s::L_LD, &s::PHI_T, &s::PHI_T0],
    sensitivity: &[&s::EPSILON_Y, &s::R_MAX, &s::T_MAX, &s::N_B_MAX, &b::DM_MAX],
    limits: &[
        Limit::at_most("level_error", &s::EPSILON_Y),
        Limit::at_most("rope_pull", &s::T_MAX),
        Limit::at_most("rope_drum", &s::S_L_MAX),
        Limit::at_most("balance_residual", &b::DM_MAX),
        Limit::at_least("balance_transmission", &b::GAMMA_MIN),
        Limit::at_most("balance_rod", &b::N_MAX),
    ],
    worst: ("greatest_pull", &s::T_MAX),
};

impl Told for Rope {
    fn outline(&self) -> &'static Outline {
        &OUTLINE
    }

    fn standing(&self) -> Standing {
        self.standing().expect("checked when the scene was read")
    }

    fn recorder(&self) -> Recorder {
        recorded::<RopeBoom>
    }

    fn limit(&self, symbol: &'static Symbol) -> Option<f64> {
        let limit = self.limits.iter().find(|(known, _)| *known == symbol);
        limit.map(|(_, limit)| *limit)
    }

    fn searched(&self) -> Vec<Summary> {
        let found = self.given.weights.as_ref().zip(self.given.balance.as_ref());
        let found = found.and_then(|(weights, form)| analysed(weights, form, &self.given.choice).ok());
        found.map_or(Vec::new(), |found| found.extremes(&b::PHI))
    }

    /// Virtual work against equilibrium, and the angles beyond which the boom falls back against the working range.
    fn identities(&self, model: &mut Standing) -> Vec<Check> {
        let mut checks = Vec::new();
        let mut check = |id, symbol, value, limit, at_most| {
            checks.push(Check {
                id,
                symbol,
                value,
                limit,
                at_most,
            });
        };
        let range = &self.given.choice.range;
        if let Some((weights, balancing)) = self.balancing() {
            let dual = balancing.map(num_dual::Dual64::from_re);
            let weights = Group::map(&weights, &mut |_, value: f64| num_dual::Dual64::from_re(value));
            let at = |phi| dual.at(phi, || weights.load(phi));
            let [work, _] = agreement(fine(range), at, |phi| {
                Ok(self.given.weights.map_or(0.0, |w| w.load(phi).m_0))
            });
            check("balance_work", &s::AGREEMENT, work, 1e-12, true);
        }
        if self.given.load.is_none() {
            return checks;
        }
        let mut symbols = vec![&s::M_Q, &s::M_D];
        symbols.extend(self.given.weights.map(|_| &s::M_G));
        symbols.extend(self.given.balance.map(|_| &b::M_B));
        let (mut worst, mut scale) = (0.0_f64, f64::MIN_POSITIVE);
        for row in sample(model, &symbols, fine(range)) {
            let own = row.get(2).copied().unwrap_or(0.0) - row.get(3).copied().unwrap_or(0.0);
            worst = worst.max((row[0] + own - row[1]).abs());
            scale = row.iter().fold(scale, |scale, value| scale.max(value.abs()));
        }
        check("equilibrium", &s::AGREEMENT, worst / scale, 1e-12, true);
        for (id, symbol) in [("fall_back", &s::PHI_T), ("fall_back_empty", &s::PHI_T0)] {
            let index = model.variables().iter().position(|variable| variable.symbol == symbol);
            if let Some(Ok(value)) = index.map(|index| model.get(index)) {
                check(id, symbol, value, range.to, false);
            }
        }
        checks
    }

    fn published(&self) -> Option<&Published> {
        None
    }

    fn assumptions(&self) -> Vec<&'static str> {
        let level = self.table.map_or("rope_level_static", |_| "rope_level_table");
        let forces = self.given.load.map(|_| "rope_forces");
        [level].into_iter().chain(forces).collect()
    }

    /// The boom at the ends (faint) and in the middle of the working range, with its ropes and the path of the load.
    fn drawing(&self) -> Drawing {
        let (rig, range) = (&self.given.rig, &self.given.choice.range);
        let middle = f64::midpoint(range.from, range.to);
        let mut draw = Draw::default();
        let (o1, e, b) = (
            Point::zeros(),
            Point::new(rig.e_x, rig.e_y),
            Point::new(rig.b_x, rig.b_y),
        );
        draw.path(fine(range).map(|phi| BoomPosition::new(rig, &phi).a));
        for (phi, faint) in [(range.from, true), (range.to, true), (middle, false)] {
            let p = BoomPosition::new(rig, &phi);
            let k = self.anchor(&p);
            draw.bar(&[o1, p.a], faint);
            draw.bar(&[k, e], faint);
            draw.bar(&[p.a, b], faint);
            draw.pin(p.a, false, faint);
            draw.pin(k, false, faint);
            if faint {
                continue;
            }
            draw.label(p.a, "A");
            draw.label(k, "K");
            draw.angle(o1, 0.2 * rig.l, phi, &b::PHI);
            draw.distance(Point::new(-rig.x_8, 0.0), Point::new(p.a.x, 0.0), -0.1 * rig.l, &s::R);
            draw.distance(o1, p.a, -0.06 * rig.l, &s::L);
            if self.given.load.is_some() {
                draw.load(p.a, &s::Q);
            }
        }
        for (at, text) in [(o1, "O_1"), (e, "E"), (b, "B")] {
            draw.joint(at, text, true, false);
        }
        draw.axis(-rig.x_8, -0.15 * rig.l, 0.6 * rig.l);
        draw.done(rig.l)
    }

    fn remarks(&self) -> Vec<&'static str> {
        Vec::new()
    }

    fn inputs(&self, origins: &Origins) -> Vec<Input> {
        let mut inputs = Vec::new();
        let mut add = |chapter, table: &str, name: &str, symbol, value| {
            let given = origins.of(&format!("luffing.{table}{name}")).cloned();
            inputs.push(Input {
                symbol,
                number: None,
                value,
                chapter,
                given,
            });
        };
        let given = &self.given;
        let mut of_table = |symbol: &'static Symbol, value: f64| match TABLES
            .iter()
            .find(|(_, keys)| keys.iter().any(|key| key.name == symbol.id))
        {
            Some((table, _)) => add(*table, &format!("{table}."), symbol.id, symbol, value),
            None => add("geometry", "", symbol.id, symbol, value),
        };
        let mut listed = |(symbol, _): Quantity, value: f64| of_table(symbol, value);
        Group::map::<f64>(&given.rig, &mut |of, value| {
            listed(of, value);
            value
        });
        Group::map::<f64>(&given.weights, &mut |of, value| {
            listed(of, value);
            value
        });
        Group::map::<f64>(&given.balance, &mut |of, value| {
            listed(of, value);
            value
        });
        if let Some(One(symbol, q)) = given.load {
            add("load", "", symbol.id, symbol, q);
        }
        let range = &given.choice.range;
        for (name, symbol, value) in [
            ("from", &s::FROM, range.from),
            ("to", &s::TO, range.to),
            ("speed", &s::OMEGA, range.speed),
        ] {
            add("motion", "motion.", name, symbol, value);
        }
        for &(symbol, value) in &self.limits {
            add("limits", "limits.", symbol.id, symbol, value);
        }
        inputs
    }

    fn more(&self, model: &mut Standing, sheet: &mut Sheet) {
        let Some((weights, balancing)) = self.balancing() else {
            return;
        };
        let Some(form) = self.given.balance else { return };
        let Ok(found) = analysed(&weights, &form, &self.given.choice) else {
            return;
        };
        let at = |phi: f64| {
            let left = balancing.at(phi, || weights.load(phi)).ok()?;
            Some((BoomPosition::new(&self.given.rig, &phi).a, left))
        };
        let balanced = BalancedBoom {
            form,
            balancing,
            found,
            motion: self.given.choice.range,
            published: self.published_balance.as_ref(),
            coordinate: &b::PHI,
            angle: &b::PHI,
            reach: &s::R,
            moment: &s::M_D,
            at: &at,
        };
        sheet.balance = balanced.chapter(model);
    }
}

impl Rope {
    /// Where the luffing tackle holds the boom, in m from O1.
    fn anchor(&self, p: &BoomPosition<f64>) -> Point<f64> {
        let Rig { s_k, chi_k, .. } = self.given.rig;
        let (sin, cos) = Calc::sin_cos(chi_k);
        plane::turned(p.along, s_k * cos, s_k * sin)
    }

    /// The boom's weight and its balance, where there is one.
    fn balancing(&self) -> Option<(Plain<f64>, Balancing<f64>)> {
        let (weights, form) = self.given.weights.zip(self.given.balance)?;
        Some((weights, balancing(&weights, &form, &self.given.choice).ok()?))
    }
}
