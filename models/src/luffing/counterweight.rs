//! What the book says about a balance beyond its formulas.

use crate::balance::analysis::Analysis;
use crate::balance::published::table_5_2_1;
use crate::balance::residual::Residual;
use crate::balance::scene::{Form, PublishedBalance};
use crate::balance::{Balance, symbols as b};
use crate::component::draw::{Draw, polar};
use crate::component::extreme::Extreme;
use crate::component::peaks::Peaks;
use crate::component::running::Running;
use crate::component::sheet::{BalanceSheet, Curve, Drawing, Measure, RestingPlace, Summary};
use crate::component::standing::Standing;
use crate::component::telling::{exists, fine, sample, table};
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::with_balance::WithBalance;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;

/// A boom with its balance.
struct BalancedBoom<'a> {
    form: Form<f64>,
    balance: Balance<f64>,
    found: Analysis,
    motion: Motion,
    coordinate: &'static Symbol,
    /// The boom's angle, its reach, and the moment that the drive must give.
    symbols: [&'static Symbol; 3],
    /// The boom's head, in m from its foot, and what is left of the moments, at a value of the coordinate.
    at: &'a dyn Fn(f64) -> Option<(Point<f64>, Residual<f64>)>,
}

/// The chapter of a balance, with the symbols of the boom's angle, its reach, and the moment that the drive must give;
/// `None` where the scene has none.
#[must_use]
pub fn chapter<T: WithBalance>(
    model: &mut Standing,
    symbols: [&'static Symbol; 3],
    published: Option<&PublishedBalance>,
) -> Option<BalanceSheet> {
    let (coordinate, given) = (model.coordinate(), model.of::<T>().given().clone());
    let form = T::form(&given)?;
    let at = |place: f64| {
        let mut known = T::new(given.clone());
        T::put(&mut known, coordinate, place);
        Some((T::head(&mut known).ok()?, T::residual(&mut known).ok()?))
    };
    let (balancing, found) = T::balance(&mut T::new(given.clone())).ok()?;
    let boom = BalancedBoom {
        form,
        balance: balancing.balance,
        found,
        motion: *model.motion(),
        coordinate: model.variables()[0].symbol,
        symbols,
        at: &at,
    };
    boom.chapter(model, published)
}

impl BalancedBoom<'_> {
    fn chapter(&self, model: &mut Standing, published: Option<&PublishedBalance>) -> Option<BalanceSheet> {
        let (coordinate, [_, reach, _]) = (self.coordinate, self.symbols);
        let equilibria = self.found.equilibria.iter().map(|e| RestingPlace {
            coordinate,
            at: e.at,
            reach: (reach, sample(model, &[reach], std::iter::once(e.at))[0][0]),
            stable: e.stable,
        });
        let printed = |summary: &Summary| {
            let found = published?.values.iter().find(|(symbol, _)| *symbol == summary.symbol);
            found.map(|(_, value)| *value)
        };
        Some(BalanceSheet {
            kind: self.form.kind(),
            parts: match self.form {
                Form::Tail(_) => &[],
                Form::Parallelogram(_) => &["rod", "pivot"],
                Form::Lever(..) => &["rod", "pivot", "angle"],
                Form::StraightRail(_) => &["rope", "pulley"],
                Form::CurvedRail(_) => &["rope", "rail"],
            },
            equilibria: equilibria.collect(),
            drawing: self.drawing()?,
            criteria: criteria(&self.found, coordinate)
                .chain(std::iter::once(weight(&self.form)))
                .map(|summary| Measure {
                    published: printed(&summary),
                    summary,
                })
                .collect(),
            published_source: published.map(|table| table.source.clone()),
            curves: self.curves(model),
            range: table(model, &self.columns()),
            table: match published {
                Some(published) if published.source.english().starts_with("[Ports001") => table_5_2_1(),
                _ => Vec::new(),
            },
        })
    }

    fn columns(&self) -> [&'static Symbol; 10] {
        let [_, reach, moment] = self.symbols;
        [
            reach,
            &b::M_0,
            &b::M_UR,
            &b::DM,
            &b::DM_5,
            &b::PSI,
            &b::GAMMA,
            &b::N_1,
            &b::M_D_0,
            moment,
        ]
    }

    fn curves(&self, model: &mut Standing) -> Vec<Curve> {
        let coordinate = self.coordinate;
        let mut list = vec![
            ("balance_M_0", coordinate, &b::M_0),
            ("balance_M_ur", coordinate, &b::M_UR),
            ("balance_dM", coordinate, &b::DM),
            ("balance_dM_reach", self.symbols[1], &b::DM),
            ("balance_N_1", coordinate, &b::N_1),
            ("balance_gamma", coordinate, &b::GAMMA),
        ];
        // What an exact balance leaves is rounding, which no curve shows.
        let moments = sample(model, &[&b::M_0], fine(&self.motion));
        let greatest = moments.iter().map(|row| row[0].abs()).fold(0.0, f64::max);
        let exact = self.found.dm_max.value <= 1e-9 * greatest;
        list.retain(|(_, _, y)| exists(model, y) && !(exact && *y == &b::DM));
        let mut peaks = Peaks::new(model);
        peaks.look(model, list.iter().map(|(_, _, y)| *y));
        let curve = |(id, x, y): (&'static str, &'static Symbol, &'static Symbol)| {
            let index = model.variables().iter().position(|variable| variable.symbol == y);
            let places = peaks.drawn(model, index.expect("it exists"));
            let points = sample(model, &[x, y], places.into_iter());
            Curve {
                id,
                x,
                y,
                pieces: vec![points.iter().map(|point| [point[0], point[1]]).collect()],
                numbers: Vec::new(),
            }
        };
        list.into_iter().map(curve).collect()
    }

    /// The boom with its balance at the ends (faint) and in the middle of the range.
    fn drawing(&self) -> Option<Drawing> {
        let (motion, balance) = (&self.motion, &self.balance);
        let at = |theta: f64| (self.at)(theta).map(|(_, residual)| residual);
        let o = Point::new(0.0, 0.0);
        let mut draw = Draw::default();
        if let Balance::CurvedRail(rail) = balance {
            let place = |theta: f64| at(theta).and_then(|r| rail.rail(r.phi, r.boom.u_0).ok());
            draw.path(fine(motion).filter_map(place));
        }
        let shown = size(&self.form);
        let middle = f64::midpoint(motion.from, motion.to);
        let rope = [motion.from, motion.to]
            .map(|theta| at(theta).map_or(0.0, |r| pulley(balance, &r)))
            .into_iter()
            .fold(0.0, f64::max);
        for (theta, faint) in [(motion.from, true), (motion.to, true), (middle, false)] {
            let (head, r) = (self.at)(theta)?;
            // The boom's head would make the linkage small.
            let along = head / head.norm();
            draw.bar(&[o, along * shown.min(head.norm())], faint);
            match balance {
                Balance::Tail(tail) => {
                    let c = polar(tail.r_c, r.phi + tail.chi_c + std::f64::consts::PI);
                    draw.bar(&[o, c], faint);
                    draw.weight(c, "C_5", faint);
                }
                Balance::Parallelogram(it) => {
                    let (k, m) = (polar(it.r_1, r.phi + it.alpha_1), polar(it.d_1, it.delta_1));
                    let c = m + polar(it.r_c, r.phi + it.chi_c + std::f64::consts::PI);
                    draw.lug(head, k, faint);
                    draw.bar(&[k, k + m], faint);
                    draw.body(&[m, k + m, c], faint);
                    joints(&mut draw, [m, k, k + m, c], faint);
                }
                Balance::Lever(lever) => {
                    let (d, turn) = (&lever.dimensions, r.action.lever?);
                    let (k, m) = (polar(d.r_1, r.phi + d.alpha_1), polar(d.d_1, d.delta_1));
                    let l = m + polar(d.lever, turn.psi - d.chi_5);
                    let c = m + polar(lever.s_5.unwrap_or(3.0), turn.psi);
                    draw.lug(head, k, faint);
                    draw.bar(&[k, l], faint);
                    draw.body(&[l, m, c], faint);
                    joints(&mut draw, [m, k, l, c], faint);
                }
                Balance::StraightRail(it) => {
                    let (k, h) = (polar(it.r_1, r.phi + it.alpha_1), Point::new(it.h_x, it.h_y));
                    // As much rope as leaves the weight a metre from the pulley at the most.
                    let down = polar(1.0, it.lambda + std::f64::consts::PI);
                    let c = h + down * (1.0 + rope - pulley(balance, &r));
                    draw.lug(head, k, faint);
                    draw.bar(&[k, h, c], faint);
                    draw.weight(c, "C_5", faint);
                    draw.joint(k, "K", false, faint);
                    draw.joint(h, "H", true, faint);
                }
                Balance::CurvedRail(rail) => {
                    let (k, c) = (
                        polar(rail.dimensions.r_1, r.phi + rail.dimensions.alpha_1),
                        rail.rail(r.phi, r.boom.u_0).ok()?,
                    );
                    draw.lug(head, k, faint);
                    draw.bar(&[k, c], faint);
                    draw.weight(c, "C_5", faint);
                    draw.joint(k, "K", false, faint);
                }
            }
            if !faint {
                draw.angle(o, 3.0, Calc::direction(head.x, head.y), self.symbols[0]);
                if let (Balance::Lever(lever), Some(turn)) = (balance, r.action.lever) {
                    let d = &lever.dimensions;
                    draw.angle(polar(d.d_1, d.delta_1), 1.5, turn.psi, &b::PSI);
                }
            }
        }
        draw.joint(o, "O_1", true, false);
        Some(draw.done(0.0))
    }
}

fn criteria(found: &Analysis, coordinate: &'static Symbol) -> impl Iterator<Item = Summary> + use<> {
    let at = |symbol, extreme: Option<Extreme>| extreme.map(|extreme| Summary::at(symbol, extreme, coordinate));
    let alone = |symbol, value: Option<f64>| value.map(|value| Summary::new(symbol, value));
    let list = [
        at(&b::DM_MAX, Some(found.dm_max)),
        at(&b::DM_5_MAX, found.dm_5_max),
        alone(&b::E, Some(found.e_abs)),
        alone(&b::E_PLUS, Some(found.e_plus)),
        at(&b::GAMMA_MIN, found.gamma_min),
        at(&b::N_MAX, found.n_max),
        alone(&b::DELTA_Y_5, found.y_5.map(|[low, high]| high.value - low.value)),
    ];
    list.into_iter().flatten()
}

/// What the balance costs: its weight, or its moment.
fn weight(form: &Form<f64>) -> Summary {
    let (symbol, value) = match form {
        Form::Lever(it, ..) => (&b::M_5, it.m_5),
        Form::Tail(it) => (&b::G_C, it.g_c),
        Form::Parallelogram(it) => (&b::G_C, it.g_c),
        Form::StraightRail(it) => (&b::G_C, it.g_c),
        Form::CurvedRail(it) => (&b::G_C, it.g_c),
    };
    Summary::new(symbol, value)
}

/// How far the balance reaches from the boom's foot, in m.
fn size(form: &Form<f64>) -> f64 {
    match form {
        Form::Tail(it) => it.r_c,
        Form::Parallelogram(it) => it.d_1 + it.r_1.max(it.r_c),
        Form::Lever(it, s_5, _) => (it.d_1 + it.lever.max(s_5.unwrap_or(3.0))).max(it.r_1),
        Form::StraightRail(it) => it.r_1.max(Point::new(it.h_x, it.h_y).norm()),
        Form::CurvedRail(it) => it.r_1.max(it.l_r),
    }
}

/// Rope between the boom and the guide pulley, in m.
fn pulley(balance: &Balance<f64>, r: &Residual<f64>) -> f64 {
    match balance {
        Balance::StraightRail(it) => (Point::new(it.h_x, it.h_y) - polar(it.r_1, r.phi + it.alpha_1)).norm(),
        _ => 0.0,
    }
}

/// Joints and counterweight of a lever: its pivot, both ends of the rod, the counterweight.
fn joints(draw: &mut Draw, [m, k, l, c]: [Point<f64>; 4], faint: bool) {
    draw.weight(c, "C_5", faint);
    draw.joint(k, "K", false, faint);
    draw.joint(l, "L", false, faint);
    draw.joint(m, "M", true, faint);
}
