//! How the supports share the load: a rigid frame on equal springs, some of which may lift.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;
use crate::parts::plane::Point;
use crate::parts::springs::{Bearing64, Growth, PlacedWeight, SpringNames, Springs, bearing, grow};
use crate::supports::mobile::ground::GroundForce;
use crate::supports::mobile::symbols as s;
use crate::supports::mobile::tipping::{SupportPoint, Tipping};
use crate::supports::mobile::weights::{DeadWeight, Leaning, Payload};

quantities! {
    /// What a support may give at most, in N.
    SupportCapacity { n_cap: N_CAP }
}

quantities! {
    /// The pad under each support.
    Pad { a_p: A_P }
}

static NAMES: SpringNames = SpringNames {
    count: &s::N_N,
    mean: [&s::X_M, &s::Y_M],
    sums: [&s::S_XX, &s::S_YY, &s::S_XY],
    eccentric: [&s::E_X, &s::E_Y],
    apart: [&s::D_X, &s::D_Y],
    tilt: Some([&s::T_X, &s::T_Y]),
};

fn places<C: Calc>(points: &[SupportPoint<C>]) -> ([Point<f64>; 64], usize) {
    let mut places = [Point::zeros(); 64];
    places
        .iter_mut()
        .zip(points)
        .for_each(|(place, p)| *place = p.point().map(Calc::value));
    (places, points.len())
}

fn those<C: Calc>(points: &[SupportPoint<C>], bearing: Bearing64) -> Springs<C> {
    let bears = move |(spring, _): &(usize, &SupportPoint<C>)| bearing >> spring & 1 == 1;
    Springs::new(points.iter().enumerate().filter(bears).map(|(_, p)| p.point()), &NAMES)
}

/// The supports that bear under the load, as springs.
///
/// # Errors
/// The crane tips.
pub fn bearing_springs<C: Calc>(
    psi: &One<C>,
    points: &[SupportPoint<C>],
    ground: &GroundForce<C>,
    tipping: &Tipping<C>,
    payload: &Payload<C>,
) -> Result<Springs<C>, Fault> {
    let (places, count) = places(points);
    let weight = PlacedWeight::at(ground.force.value(), ground.place.map(Calc::value));
    let found = bearing(&places[..count], &NAMES, weight).ok_or_else(|| {
        let (psi, load) = (s::PSI.written(psi.value()), s::Q.written(payload.hung.value()));
        Fault::outside(match tipping.load {
            Some(most) if most.value() <= payload.hung.value() => format!(
                "psi = {psi}: the crane tips, {load} hang there with the hook block and P = {} tips it; give less load or reach, or a \
                 wider base",
                s::P.written(most.value())
            ),
            _ => format!(
                "psi = {psi}: the crane tips away from its load of {load}, its weights leave the supports; give less counterweight or a \
                 wider base"
            ),
        })
    })?;
    Ok(those(points, found))
}

/// A support under load.
#[derive(Clone, Copy, Debug)]
pub struct SupportForce<C> {
    force: C,
}
results! { each SupportForce as f => { N: f.force; } }

impl<C: Calc> SupportForce<C> {
    /// N_i = V (1/n + …), zero of a support that is lifted.
    pub fn new(springs: &Springs<C>, ground: &GroundForce<C>, point: &SupportPoint<C>) -> SupportForce<C> {
        let force = springs.carry(ground.force, ground.place, point.point());
        SupportForce {
            force: force.greater(C::constant(0.0)).def(&s::N),
        }
    }
}

/// p = N / A, in Pa.
pub fn pressure<C: Calc>(force: &SupportForce<C>, pad: &Pad<C>) -> C {
    (force.force / pad.a_p).def(&s::P_G)
}

/// The load (N) at which the first support reaches what it may give; `None` where none does before the crane tips.
#[derive(Clone, Copy, Debug)]
pub struct Bearable<C>(pub Option<C>);
results! { Bearable as b => { Q_N: b.0.unwrap_or_else(|| C::known(&s::Q_N, f64::INFINITY)); } }

impl<C: Calc> Bearable<C> {
    /// Q_N = (N_cap − N_0) / n_Q of the support that is full first.
    ///
    /// # Errors
    /// The crane tips without load.
    pub fn new(
        points: &[SupportPoint<C>],
        caps: &[SupportCapacity<C>],
        heading: &Point<C>,
        dead: &DeadWeight<C>,
        leaning: &Leaning<C>,
    ) -> Result<Bearable<C>, Fault> {
        if caps.is_empty() {
            return Ok(Bearable(None));
        }
        let (places, count) = places(points);
        let places = &places[..count];
        let upright = leaning.upright;
        let base = (
            dead.weight * upright,
            GroundForce::place(heading, dead, leaning, C::constant(0.0)),
        );
        let step = (upright, *heading * leaning.reach);
        let plain = |(force, place): (C, Point<C>)| PlacedWeight::at(force.value(), place.map(Calc::value));
        let empty = bearing(places, &NAMES, plain(base)).ok_or_else(|| {
            let what =
                "the crane tips without load: its weights leave the supports; move its counterweight or its base";
            Fault::outside(what)
        })?;
        let cap = |spring: usize| caps[spring].n_cap.value();
        let growth = grow(places, &NAMES, empty, [plain(base), plain(step)], f64::INFINITY, &cap);
        let Growth::Full { spring, bearing, .. } = growth else {
            return Ok(Bearable(None));
        };
        let (springs, at) = (those(points, bearing), points[spring].point());
        let start = springs.carry(base.0, base.1, at).def(&s::N_0);
        let each = springs.carry(step.0, step.1, at).def(&s::N_Q);
        Ok(Bearable(Some(((caps[spring].n_cap - start) / each).def(&s::Q_N))))
    }
}
