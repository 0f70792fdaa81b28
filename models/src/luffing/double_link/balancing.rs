//! The balance of this mechanism, while any of its bars is driven.

use crate::balance::analysis::Analysis;
use crate::balance::boom::Boom;
use crate::balance::residual::Residual;
use crate::balance::symbols as s;
use crate::drive::line::Drive;
use crate::kernel::allowed::{FINITE, OutOfRange};
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::parameters::{Driven, Parameters, Weights};
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::statics::{Centres, LoadMoment, Own};
use crate::luffing::double_link::symbols as l;
use crate::luffing::double_link::system::{BoomSystem, height, load};
use crate::luffing::double_link::velocity::Velocity;
use crate::parts::four_bar::Branch;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};

/// The balance; `None` where the parameters have none.
///
/// # Errors
/// Quantities with which there is no such balance; a boom system without weights.
pub fn new<C: Calc>(p: &Parameters<C>, motion: &Motion) -> Result<Option<Balancing<C>>, OutOfRange> {
    let Some(form) = &p.balance else {
        return Ok(None);
    };
    let middle = middle(&p.values(), motion);
    let phi = middle.map_or(0.0, |p| f64::direction(p.x_1.x, p.x_1.y));
    let u_0 = |phi| Ok(BoomSystem::new(&by_boom(p, motion))?.at(phi)?.u_0);
    Balancing::new(form, phi, u_0).map(Some).map_err(in_scene)
}

/// What it does at a position with `theta` (rad) of the driving link.
///
/// # Errors
/// As [`Balancing::at`].
pub fn at<C: Calc>(
    balancing: &Balancing<C>,
    g: &Geometry<C>,
    p: &Position<C>,
    v: &Velocity<C>,
    w: &Weights<C>,
    own: &Own<C>,
    theta: &C,
) -> Result<Residual<C>, OutOfRange> {
    let phi = boom_angle(p, *theta);
    balancing.at(phi, || load(g, w, p, v, own)).map_err(in_scene)
}

/// The counterweight at a position, as [`Balancing::place`].
#[inline]
pub fn place<C: Calc>(
    balancing: &Balancing<C>,
    g: &Geometry<C>,
    w: &Weights<C>,
    p: &Position<C>,
    theta: C,
) -> Option<Point<C>> {
    balancing.place(boom_angle(p, theta), || {
        height(g, w, p, &Centres::new(p, &g.lengths, w))
    })
}

/// Load, weights and balance together, and what they would ask of the drive without the balance.
pub fn balanced<C: Calc>(
    residual: &Residual<C>,
    p: &Position<C>,
    v: &Velocity<C>,
    load: &LoadMoment<C>,
    own: &Own<C>,
    drive: Option<&Drive<C>>,
) -> Balanced<C> {
    let about_foot = match p.driven {
        Driven::Boom => load.m_q,
        Driven::Rocker => load.m_q / v.i_follower,
    };
    let force = |moment| drive.map(|drive| drive.force(moment, &s::F_D_0));
    Balanced::new(residual, about_foot, [load.m_q, own.m_g], force)
}

/// Angle of the boom (rad) where the driving link is at `theta` (rad).
pub fn boom_angle<C: Calc>(p: &Position<C>, theta: C) -> C {
    match p.driven {
        Driven::Boom => theta,
        Driven::Rocker => p.follower_angle(),
    }
}

/// The residual over any scalar at an angle (rad) of the driving link.
///
/// # Errors
/// As [`at`]; an angle at which the linkage does not close.
pub fn residual<C: Calc>(
    balancing: &Balancing<C>,
    g: &Geometry<C>,
    w: &Weights<C>,
    theta: C,
) -> Result<Residual<C>, OutOfRange> {
    let Some(p) = Position::new(g, theta) else {
        let what = "the linkage does not close at this angle";
        return Err(OutOfRange::new(&l::THETA_1, theta.value(), FINITE, what));
    };
    let v = Velocity::new(&p);
    let own = Own::new(&p, &v, &g.lengths, w);
    at(balancing, g, &p, &v, w, &own, &theta)
}

/// Results of the balance over the working range; `None` where there is no balance.
///
/// # Errors
/// Where boom or balance cannot be over the whole range, with where they can.
pub fn analysis(p: &Parameters<f64>, motion: &Motion) -> Result<Option<Analysis>, OutOfRange> {
    let (Some(balancing), Some(w)) = (new(p, motion)?, &p.weights) else {
        return Ok(None);
    };
    let Ok(g) = Geometry::new(p) else { return Ok(None) };
    let at = |theta: f64| residual(&balancing, &g, w, theta);
    Analysis::over([motion.from, motion.to], &at)
        .map(Some)
        .map_err(in_scene)
}

/// The same mechanism with its boom as the driving link, assembled as in the middle of the range.
fn by_boom<C: Calc>(p: &Parameters<C>, motion: &Motion) -> Parameters<C> {
    let branch = match p.driven {
        Driven::Boom => p.branch,
        Driven::Rocker => match middle(&p.values(), motion) {
            // C on the left of the line from O3 to B.
            Some(p) if plane::cross(p.x_3 - p.x_2, p.x_3) > 0.0 => Branch::Left,
            _ => Branch::Right,
        },
    };
    Parameters {
        driven: Driven::Boom,
        branch,
        ..*p
    }
}

/// The boom system as its boom moves it, and its boom angles (rad) over the working range.
///
/// # Errors
/// A mechanism without weights.
pub fn boom(p: &Parameters<f64>, motion: &Motion) -> Result<(BoomSystem<f64>, [f64; 2]), OutOfRange> {
    let boom = BoomSystem::new(&by_boom(p, motion))?;
    let ends = [motion.from, motion.to].map(|theta| match p.driven {
        Driven::Boom => Some(theta),
        Driven::Rocker => Position::new(&Geometry::new(p).ok()?, theta).map(|p| p.follower_angle()),
    });
    let [Some(a), Some(b)] = ends else {
        let what = "the linkage does not close over the whole working range";
        return Err(OutOfRange::new(&l::THETA_1, motion.from, FINITE, what));
    };
    Ok((boom, [a.min(b), a.max(b)]))
}

fn middle(p: &Parameters<f64>, motion: &Motion) -> Option<Position<f64>> {
    let g = Geometry::new(p).ok()?;
    Position::new(&g, f64::midpoint(motion.from, motion.to))
}

/// A fault in the names of this mechanism: its boom angle is `theta_1`.
fn in_scene(fault: OutOfRange) -> OutOfRange {
    let quantity: &'static Symbol = if fault.quantity == &s::PHI {
        &l::THETA_1
    } else {
        fault.quantity
    };
    OutOfRange { quantity, ..fault }
}
