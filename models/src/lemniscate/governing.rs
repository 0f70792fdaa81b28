//! Governing positions: where in the working range each result is greatest,
//! and how these results change with every given quantity.
//!
//! A given quantity that changes moves the governing position too. At an
//! extreme inside the range the derivative by the position is zero, and at an
//! end of the range the position stays: in both cases the change of the result
//! is the derivative at the governing position held fast, exact from dual
//! numbers.

use num_dual::Dual64;

use crate::balance::analysis::{Analysis, Residual};
use crate::balance::symbols as b;
use crate::calc::Calc;
use crate::lemniscate::balancing::{Balancing, analysis, residual};
use crate::lemniscate::drive::Drive;
use crate::lemniscate::geometry::{Driven, Geometry, Parameters};
use crate::lemniscate::position::Position;
use crate::lemniscate::range::{Extreme, Range, greatest_amount};
use crate::lemniscate::scene::{Luffing, Motion};
use crate::lemniscate::statics::{Centres, PinForces, drive_moment, load_moment, weight_moment};
use crate::lemniscate::symbols as s;
use crate::lemniscate::velocity::Velocity;
use crate::sheet::{Sensitivity, Slope, Summary};
use crate::symbol::Symbol;

/// A crane over any scalar, with the load and the speed of its scene.
struct Crane<C> {
    parameters: Parameters<C>,
    geometry: Geometry<C>,
    balancing: Option<Balancing<C>>,
    q: Option<C>,
    /// Whether forces in the pins are modelled.
    pins: bool,
    speed: C,
}

/// What governs of the forces at one position: moment of the drive (N·m), axial force in the rocker (N).
struct Forces<C> {
    m_d: C,
    n_3: Option<C>,
}

/// A quantity of one position.
type Quantity = fn(&Crane<Dual64>, Dual64) -> Option<Dual64>;

impl<C: Calc> Crane<C> {
    /// `given` makes a scalar of each given quantity.
    fn new(luffing: &Luffing, mut given: impl FnMut(&'static Symbol, f64) -> C) -> Option<Crane<C>> {
        let parameters = luffing.parameters.map(&mut given);
        Some(Crane {
            geometry: Geometry::new(&parameters).ok()?,
            balancing: Balancing::new(&parameters, &luffing.motion).ok()?,
            q: luffing.q.map(|q| given(&s::Q, q)),
            pins: luffing.has_pins(),
            speed: given(rate(luffing.parameters.driven), luffing.motion.speed),
            parameters,
        })
    }

    fn position(&self, theta: C) -> Option<Position<C>> {
        Position::new(&self.geometry, theta)
    }

    fn speed(&self, theta: C) -> Option<C> {
        Some(Velocity::new(&self.position(theta)?).v_a(self.speed).x)
    }

    fn load_moment(&self, theta: C) -> Option<C> {
        Some(load_moment(&Velocity::new(&self.position(theta)?), self.q?))
    }

    fn forces(&self, theta: C) -> Option<Forces<C>> {
        let (p, q) = (self.position(theta)?, self.q?);
        let l = &self.parameters.lengths;
        let weights = self.parameters.weights.as_ref();
        let centres = weights.map(|w| Centres::new(&p, [l.x_1, l.x_2, l.x_3], w));
        let both = weights.zip(centres.as_ref());
        let residual = self.residual(theta);
        let action = residual.as_ref().map(|residual| &residual.action);
        let pins = self.pins.then(|| PinForces::new(&p, l.x_3, q, both, action, |_| None));
        let m_d = match &pins {
            Some(pins) => pins.m_d,
            None => {
                let v = Velocity::new(&p);
                let m_g = both.map_or(C::constant(0.0), |(w, r)| weight_moment(w, r, &p, &v));
                drive_moment(load_moment(&v, q), m_g)
            }
        };
        Some(Forces {
            m_d,
            n_3: pins.map(|pins| pins.n_3),
        })
    }

    /// What the balance leaves.
    fn residual(&self, theta: C) -> Option<Residual<C>> {
        let (balancing, weights) = (self.balancing.as_ref()?, self.parameters.weights.as_ref()?);
        residual(balancing, &self.geometry, weights, theta).ok()
    }

    fn drive(&self, theta: C) -> Option<Drive<C>> {
        let l = &self.parameters.lengths;
        let bar = match self.parameters.driven {
            Driven::Boom => l.x_1,
            Driven::Rocker => l.x_3,
        };
        let anchors = self.parameters.anchors.as_ref()?;
        Some(Drive::new(&self.position(theta)?, bar, l.o3(), anchors))
    }

    fn drive_force(&self, theta: C) -> Option<C> {
        Some(self.drive(theta)?.force(self.forces(theta)?.m_d, &s::F_D))
    }
}

/// Angular velocity of the driven bar.
#[must_use]
pub fn rate(driven: Driven) -> &'static Symbol {
    match driven {
        Driven::Boom => &s::OMEGA_1,
        Driven::Rocker => &s::OMEGA_3,
    }
}

/// Angle of the driven bar, the coordinate of the mechanism.
#[must_use]
pub fn coordinate(driven: Driven) -> &'static Symbol {
    match driven {
        Driven::Boom => &s::THETA_1,
        Driven::Rocker => &s::THETA_3,
    }
}

/// What governs beside the results of [`Range`]: greatest by amount.
static AMOUNTS: [(&Symbol, Quantity); 5] = [
    (&s::V_AX_MAX, |crane, theta| crane.speed(theta)),
    (&s::M_Q_MAX, |crane, theta| crane.load_moment(theta)),
    (&s::M_D_MAX, |crane, theta| Some(crane.forces(theta)?.m_d)),
    (&s::N_3_MAX, |crane, theta| crane.forces(theta)?.n_3),
    (&s::F_D_MAX, |crane, theta| crane.drive_force(theta)),
];

/// What governs of the balance: [`analysis`] finds where.
static OF_BALANCE: [(&Symbol, Quantity); 4] = [
    (&b::DM_MAX, |crane, theta| Some(crane.residual(theta)?.dm.abs())),
    (&b::DM_5_MAX, |crane, theta| Some(crane.residual(theta)?.dm_5?.abs())),
    (&b::N_MAX, |crane, theta| Some(crane.residual(theta)?.action.n_1?.abs())),
    (&b::GAMMA_MIN, |crane, theta| {
        Some(crane.residual(theta)?.action.lever?.gamma)
    }),
];

/// The extremes of the balance with their symbols: only what its kind has.
fn of_balance(found: &Analysis) -> [(&'static Symbol, Option<Extreme>); 4] {
    [
        (&b::DM_MAX, Some(found.dm_max)),
        (&b::DM_5_MAX, found.dm_5_max),
        (&b::N_MAX, found.n_max),
        (&b::GAMMA_MIN, found.gamma_min),
    ]
}

fn quantity(symbol: &'static Symbol) -> Option<Quantity> {
    AMOUNTS
        .iter()
        .chain(&OF_BALANCE)
        .find(|(known, _)| *known == symbol)
        .map(|(_, quantity)| *quantity)
}

/// The governing results of a scene with their positions: only of what it models.
#[must_use]
pub fn governing(luffing: &Luffing, range: &Range, balance: Option<&Analysis>) -> Vec<Summary> {
    let coordinate = coordinate(luffing.parameters.driven);
    let entry = |symbol, extreme: Extreme| Summary {
        symbol,
        value: extreme.value,
        at: Some((coordinate, extreme.at)),
    };
    let mut list = vec![
        entry(&s::R_MAX, range.r_max),
        entry(&s::R_MIN, range.r_min),
        entry(&s::MU_MIN, range.mu_min),
    ];
    let Some(crane) = Crane::new(luffing, |_, value| Dual64::from_re(value)) else {
        return list;
    };
    for (symbol, quantity) in AMOUNTS {
        let extreme = match symbol {
            symbol if symbol == &s::F_D_MAX => dead_drive(&crane, &luffing.motion),
            _ => None,
        };
        let extreme = extreme.or_else(|| greatest_amount(&luffing.motion, |theta| quantity(&crane, theta)));
        list.extend(extreme.map(|extreme| entry(symbol, extreme)));
    }
    let found = balance.into_iter().flat_map(of_balance);
    list.extend(found.filter_map(|(symbol, extreme)| Some(entry(symbol, extreme?))));
    list
}

/// Names of the results that [`governing`] finds in a scene.
pub fn governed(luffing: &Luffing) -> impl Iterator<Item = &'static str> {
    let (load, drive) = (luffing.q.is_some(), luffing.parameters.anchors.is_some());
    let modelled = [true, true, true, true, load, load, luffing.has_pins(), load && drive];
    let symbols = [&s::R_MAX, &s::R_MIN, &s::MU_MIN].into_iter();
    let symbols = symbols.chain(AMOUNTS.iter().map(|(symbol, _)| *symbol));
    let balance = analysis(&luffing.parameters, &luffing.motion).ok().flatten();
    let balance = balance.into_iter().flat_map(|found| of_balance(&found));
    let balance = balance.filter(|(_, extreme)| extreme.is_some());
    symbols
        .zip(modelled)
        .filter(|(_, modelled)| *modelled)
        .map(|(symbol, _)| symbol.id)
        .chain(balance.map(|(symbol, _)| symbol.id))
}

/// Where the lever arm of the drive changes its sign no force of it gives a
/// moment: the force grows beyond all bounds there, between the points of any grid,
/// if one is asked for.
fn dead_drive(crane: &Crane<Dual64>, motion: &Motion) -> Option<Extreme> {
    let arm = |theta: f64| Some(crane.drive(Dual64::from_re(theta))?.h_d.re);
    let points = 96;
    let angle = |i: u32| motion.from + (motion.to - motion.from) * (f64::from(i) / f64::from(points));
    let crossed = (0..points).find(|&i| {
        arm(angle(i))
            .zip(arm(angle(i + 1)))
            .is_some_and(|(a, b)| (a > 0.0) != (b > 0.0))
    })?;
    let (mut low, mut high) = (angle(crossed), angle(crossed + 1));
    let before = arm(low)? > 0.0;
    for _ in 0..64 {
        let middle = f64::midpoint(low, high);
        if (arm(middle)? > 0.0) == before {
            low = middle;
        } else {
            high = middle;
        }
    }
    let asked = crane.drive_force(Dual64::from_re(low))?.re != 0.0;
    asked.then_some(Extreme {
        value: f64::INFINITY,
        at: low,
    })
}

/// How the checked results and the greatest forces change with each given
/// quantity: derivatives in SI, exact.
#[must_use]
pub fn sensitivity(luffing: &Luffing, range: &Range, governing: &[Summary]) -> Sensitivity {
    let forces = governing.iter().filter(|g| {
        g.value.is_finite() && g.value != 0.0 && [&s::M_Q_MAX, &s::F_D_MAX, &b::DM_MAX, &b::N_MAX].contains(&g.symbol)
    });
    let mut results = vec![(&s::MU_MIN, range.mu_min.value), (&s::EPSILON_Y, range.epsilon_y())];
    results.push((&s::R_MAX, range.r_max.value));
    results.extend(forces.map(|g| (g.symbol, g.value)));
    let at = |symbol: &'static Symbol| governing.iter().find(|g| g.symbol == symbol).and_then(|g| g.at);
    let slope = |crane: &Crane<Dual64>, symbol: &'static Symbol| -> Option<f64> {
        let p = |extreme: Extreme| crane.position(Dual64::from_re(extreme.at));
        let value = match symbol {
            symbol if symbol == &s::MU_MIN => p(range.mu_min)?.mu(),
            symbol if symbol == &s::R_MAX => p(range.r_max)?.r,
            symbol if symbol == &s::EPSILON_Y => {
                (p(range.y_max)?.a.y - p(range.y_min)?.a.y) / (p(range.r_max)?.r - p(range.r_min)?.r)
            }
            symbol => quantity(symbol)?(crane, Dual64::from_re(at(symbol)?.1))?,
        };
        Some(value.eps)
    };
    let mut given = Vec::new();
    luffing.parameters.map(&mut |symbol, value| given.push((symbol, value)));
    given.extend(luffing.q.map(|q| (&s::Q, q)));
    let rows = given.into_iter().filter_map(|(symbol, value)| {
        let seeded = |known, value| Dual64::new(value, if known == symbol { 1.0 } else { 0.0 });
        let crane = Crane::new(luffing, seeded)?;
        let by = results
            .iter()
            .map(|(result, _)| slope(&crane, result))
            .collect::<Option<_>>()?;
        Some(Slope { symbol, value, by })
    });
    Sensitivity {
        rows: rows.collect(),
        results,
    }
}
