//! What the book says about the balance beyond its formulas.

use crate::balance::analysis::{Analysis, Residual};
use crate::balance::published::table_5_2_1;
use crate::balance::scene::Form;
use crate::balance::{Balance, symbols as b};
use crate::calc::Calc;
use crate::lemniscate::balancing::{Balancing, residual};
use crate::lemniscate::geometry::Geometry;
use crate::lemniscate::model::Model;
use crate::lemniscate::position::Position;
use crate::lemniscate::range::Extreme;
use crate::lemniscate::scene::Luffing;
use crate::lemniscate::sheet::{fine, sample};
use crate::lemniscate::symbols as s;
use crate::plane::Point;
use crate::sheet::{self, Criterion, Curve, Drawing, Equilibrium, Shape, Summary, Table};
use crate::symbol::Symbol;

/// `None` where the scene has no balance.
pub(super) fn balance(
    model: &mut Model,
    luffing: &Luffing,
    geometry: &Geometry<f64>,
    found: Option<&Analysis>,
    coordinate: &'static Symbol,
) -> Option<sheet::Balance> {
    let (form, found) = (luffing.parameters.balance?, found?);
    let published = luffing.published_balance.as_ref();
    let reach = |theta: f64, model: &mut Model| sample(model, &[&s::R], std::iter::once(theta))[0][0];
    let equilibria = found.equilibria.iter().map(|e| Equilibrium {
        coordinate,
        at: e.at,
        reach: (&s::R, reach(e.at, model)),
        stable: e.stable,
    });
    Some(sheet::Balance {
        kind: form.kind(),
        equilibria: equilibria.collect(),
        drawing: drawing(luffing, geometry)?,
        criteria: criteria(found, coordinate)
            .chain(std::iter::once(weight(&form)))
            .map(|summary| Criterion {
                published: published.and_then(|table| {
                    let value = table.values.iter().find(|(symbol, _)| *symbol == summary.symbol);
                    value.map(|(_, value)| *value)
                }),
                summary,
            })
            .collect(),
        published_source: published.map(|table| table.source.clone()),
        curves: curves(model, luffing, coordinate, found),
        range: table(model, luffing, coordinate),
        table: match published {
            Some(published) if published.source.starts_with("[Ports001") => table_5_2_1(),
            _ => Vec::new(),
        },
    })
}

fn criteria(found: &Analysis, coordinate: &'static Symbol) -> impl Iterator<Item = Summary> {
    let at = |symbol, extreme: Option<Extreme>| {
        extreme.map(|extreme| Summary {
            symbol,
            value: extreme.value,
            at: Some((coordinate, extreme.at)),
        })
    };
    let alone = |symbol, value: Option<f64>| {
        value.map(|value| Summary {
            symbol,
            value,
            at: None,
        })
    };
    let list = [
        at(&b::DM_MAX, Some(found.dm_max)),
        at(&b::DM_5_MAX, found.dm_5_max),
        alone(&b::E_ABS, Some(found.e_abs)),
        alone(&b::E_PLUS, Some(found.e_plus)),
        at(&b::GAMMA_MIN, found.gamma_min),
        at(&b::N_MAX, found.n_max),
        alone(&b::TRAVEL, found.y_5.map(|[low, high]| high.value - low.value)),
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
    Summary {
        symbol,
        value,
        at: None,
    }
}

fn exists(model: &Model, symbol: &'static Symbol) -> bool {
    model.variables().iter().any(|variable| variable.symbol == symbol)
}

fn curves(model: &mut Model, luffing: &Luffing, coordinate: &'static Symbol, found: &Analysis) -> Vec<Curve> {
    let mut list = vec![
        ("balance_M_0", coordinate, &b::M_0),
        ("balance_M_ur", coordinate, &b::M_B),
        ("balance_dM", coordinate, &b::DM),
        ("balance_dM_reach", &s::R, &b::DM),
        ("balance_N_1", coordinate, &b::N_1),
        ("balance_gamma", coordinate, &b::GAMMA),
    ];
    // What an exact balance leaves is rounding, which no curve shows.
    let moments = sample(model, &[&b::M_0], fine(&luffing.motion));
    let greatest = moments.iter().map(|row| row[0].abs()).fold(0.0, f64::max);
    let exact = found.dm_max.value <= 1e-9 * greatest;
    list.retain(|(_, _, y)| exists(model, y) && !(exact && *y == &b::DM));
    let curve = |(id, x, y): (&'static str, &'static Symbol, &'static Symbol)| {
        let points = sample(model, &[x, y], fine(&luffing.motion));
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

fn table(model: &mut Model, luffing: &Luffing, coordinate: &'static Symbol) -> Table {
    let mut columns = vec![
        coordinate,
        &s::R,
        &b::M_0,
        &b::M_B,
        &b::DM,
        &b::DM_5,
        &b::PSI,
        &b::GAMMA,
        &b::N_1,
        &b::M_D_0,
        &s::M_D,
    ];
    columns.retain(|symbol| exists(model, symbol));
    let rows = sample(model, &columns, luffing.motion.angles().into_iter());
    Table { columns, rows }
}

/// The boom with its balance at the ends (faint) and in the middle of the range.
fn drawing(luffing: &Luffing, g: &Geometry<f64>) -> Option<Drawing> {
    let motion = &luffing.motion;
    let balancing = Balancing::new(&luffing.parameters, motion).ok()??;
    let weights = luffing.parameters.weights.as_ref()?;
    let at = |theta: f64| residual(&balancing, g, weights, theta).ok();
    let o = Point::new(0.0, 0.0);
    let mut draw = Draw::default();
    if let Balance::CurvedRail(rail) = &balancing.balance {
        let place = |theta: f64| at(theta).and_then(|r| rail.rail(r.phi, r.boom.u_0).ok());
        draw.path(fine(motion).filter_map(place).collect());
    }
    let shown = size(&luffing.parameters.balance?);
    let middle = f64::midpoint(motion.from, motion.to);
    let rope = [motion.from, motion.to]
        .map(|theta| at(theta).map_or(0.0, |r| pulley(&balancing.balance, &r)))
        .into_iter()
        .fold(0.0, f64::max);
    for (theta, faint) in [(motion.from, true), (motion.to, true), (middle, false)] {
        let (p, r) = (Position::new(g, theta)?, at(theta)?);
        // The boom's head would make the linkage small.
        let along = p.b / p.b.norm();
        draw.bar(&[o, along * shown.min(p.b.norm())], faint);
        match &balancing.balance {
            Balance::Tail(tail) => {
                let c = polar(tail.r_c, r.phi + tail.chi_c + std::f64::consts::PI);
                draw.bar(&[o, c], faint);
                draw.weight(c, faint);
            }
            Balance::Parallelogram(it) => {
                let (k, m) = (polar(it.r_1, r.phi + it.alpha_1), polar(it.d_1, it.delta_1));
                let c = m + polar(it.r_c, r.phi + it.chi_c + std::f64::consts::PI);
                draw.lug(p.b, k, faint);
                draw.bar(&[k, k + m], faint);
                draw.body(&[m, k + m, c], faint);
                draw.lever(m, k, k + m, c, faint);
            }
            Balance::Lever(lever) => {
                let (d, turn) = (&lever.dimensions, r.action.lever?);
                let (k, m) = (polar(d.r_1, r.phi + d.alpha_1), polar(d.d_1, d.delta_1));
                let l = m + polar(d.lever, turn.psi - d.chi_5);
                let c = m + polar(lever.s_5.unwrap_or(3.0), turn.psi);
                draw.lug(p.b, k, faint);
                draw.bar(&[k, l], faint);
                draw.body(&[l, m, c], faint);
                draw.lever(m, k, l, c, faint);
            }
            Balance::StraightRail(it) => {
                let (k, h) = (polar(it.r_1, r.phi + it.alpha_1), Point::new(it.h_x, it.h_y));
                // As much rope as leaves the weight a metre from the pulley at the most.
                let down = polar(1.0, it.lambda + std::f64::consts::PI);
                let c = h + down * (1.0 + rope - pulley(&balancing.balance, &r));
                draw.lug(p.b, k, faint);
                draw.bar(&[k, h, c], faint);
                draw.weight(c, faint);
                draw.pin(k, "K", false, faint);
                draw.pin(h, "H", true, faint);
            }
            Balance::CurvedRail(rail) => {
                let (k, c) = (
                    polar(rail.dimensions.r_1, r.phi + rail.dimensions.alpha_1),
                    rail.rail(r.phi, r.boom.u_0).ok()?,
                );
                draw.lug(p.b, k, faint);
                draw.bar(&[k, c], faint);
                draw.weight(c, faint);
                draw.pin(k, "K", false, faint);
            }
        }
        if !faint {
            draw.shapes.push(Shape::Angle {
                at: [0.0, 0.0],
                radius: 3.0,
                from: 0.0,
                to: Calc::direction(p.x_1.x, p.x_1.y),
                text: s::THETA_1.print,
            });
            if let (Balance::Lever(lever), Some(turn)) = (&balancing.balance, r.action.lever) {
                let d = &lever.dimensions;
                draw.shapes.push(Shape::Angle {
                    at: array(polar(d.d_1, d.delta_1)),
                    radius: 1.5,
                    from: 0.0,
                    to: turn.psi,
                    text: b::PSI.print,
                });
            }
        }
    }
    draw.pin(o, "O_1", true, false);
    Some(Drawing { shapes: draw.shapes })
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

fn polar(length: f64, angle: f64) -> Point<f64> {
    let (sin, cos) = Calc::sin_cos(angle);
    Point::new(length * cos, length * sin)
}

fn array(point: Point<f64>) -> [f64; 2] {
    [point.x, point.y]
}

#[derive(Default)]
struct Draw {
    shapes: Vec<Shape>,
}

impl Draw {
    fn bar(&mut self, points: &[Point<f64>], faint: bool) {
        self.shapes.push(Shape::Body {
            points: points.iter().copied().map(array).collect(),
            closed: false,
            faint,
        });
    }

    fn body(&mut self, points: &[Point<f64>], faint: bool) {
        self.shapes.push(Shape::Body {
            points: points.iter().copied().map(array).collect(),
            closed: true,
            faint,
        });
    }

    fn path(&mut self, points: Vec<Point<f64>>) {
        self.shapes.push(Shape::Path {
            points: points.into_iter().map(array).collect(),
        });
    }

    /// From the boom O–B to a joint beside it.
    fn lug(&mut self, b: Point<f64>, k: Point<f64>, faint: bool) {
        let foot = b * (k.dot(&b) / b.norm_squared());
        self.bar(&[k, foot], faint);
    }

    /// A square around the counterweight, in m.
    fn weight(&mut self, at: Point<f64>, faint: bool) {
        const HALF: f64 = 0.6;
        let corner = |x: f64, y: f64| at + Point::new(x * HALF, y * HALF);
        let corners = [
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ];
        self.body(&corners, faint);
        if !faint {
            self.shapes.push(Shape::Label {
                at: array(corner(-1.0, -1.0)),
                text: "C_5",
            });
        }
    }

    fn pin(&mut self, at: Point<f64>, text: &'static str, fixed: bool, faint: bool) {
        let at = array(at);
        self.shapes.push(Shape::Pin { at, fixed, faint });
        if !faint {
            self.shapes.push(Shape::Label { at, text });
        }
    }

    /// Joints and counterweight of a lever.
    fn lever(&mut self, m: Point<f64>, k: Point<f64>, l: Point<f64>, c: Point<f64>, faint: bool) {
        self.weight(c, faint);
        self.pin(k, "K", false, faint);
        self.pin(l, "L", false, faint);
        self.pin(m, "M", true, faint);
    }
}
