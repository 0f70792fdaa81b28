//! A balance on the boom, whose angle is the coordinate, with the weights of boom and trunk.

use crate::balance::analysis::Analysis;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::component::stages::Found;
use crate::drive::line::Drive;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::Calc;
use crate::kernel::group::Group;
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::curved_trunk::contact::{Contact, direction};
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::statics::{TrunkLoad, TrunkWeight, TrunkWeights};
use crate::luffing::curved_trunk::tail::{TrunkChoice, TrunkTail};
use crate::luffing::curved_trunk::velocity::TrunkTravel;
use crate::luffing::moving::weighed::Balanceable;
use crate::parts::plane::{self, Point};

/// A balance on the boom under the trunk.
#[derive(Clone, Copy)]
pub struct UnderTrunk;

impl Balanceable for UnderTrunk {
    type Of<C: Calc> = (TrunkTail<C>, TrunkWeights<C>);
    type Choice = TrunkChoice;

    fn map<C: Calc, D: Calc>((tail, weights): &Self::Of<C>, f: &mut dyn FnMut(C) -> D) -> Self::Of<D> {
        (tail.map(&mut *f), Group::map(weights, &mut |_, x| f(x)))
    }

    fn balancing<C: Calc>(
        (tail, weights): &Self::Of<C>,
        form: &Form<C>,
        choice: &TrunkChoice,
    ) -> Result<Balancing<C>, OutOfRange> {
        balancing(tail, choice, weights, form)
    }

    const SENSE: f64 = 1.0;

    fn angle<C: Calc>(phi: C) -> C {
        phi
    }

    fn energy<C: Calc>((tail, weights): &Self::Of<C>, choice: &TrunkChoice, phi: C) -> C {
        let along = direction(tail, choice, phi);
        along.map_or(C::constant(f64::NAN), |along| energy(tail, weights, phi, along))
    }
}

/// Potential energy of boom and trunk (J) at the boom's angle (rad), the trunk along a unit vector.
pub fn energy<C: Calc>(tail: &TrunkTail<C>, w: &TrunkWeights<C>, phi: C, along: Point<C>) -> C {
    let (of_boom, (sin, cos)) = ((phi + w.chi_b).sin(), w.chi_t.sin_cos());
    let of_trunk = tail.trunk.b * phi.sin() + plane::turned(along, w.r_t * cos, w.r_t * sin).y;
    w.g_b * w.r_b * of_boom + w.g_t * of_trunk
}

/// Own weights at any angle of the boom, in rad.
///
/// # Errors
/// As [`Contact::new`].
pub fn weighed<C: Calc>(
    tail: &TrunkTail<C>,
    choice: &TrunkChoice,
    weights: &TrunkWeights<C>,
    phi: C,
) -> Result<TrunkWeight<C>, OutOfRange> {
    let contact = Contact::new(tail, choice, &phi)?;
    let position = TrunkPosition::new(tail, &contact);
    Ok(TrunkWeight::new(weights, &phi, &position, &TrunkTravel::new(&position)))
}

/// # Errors
/// Quantities with which there is no such balance.
pub fn balancing<C: Calc>(
    tail: &TrunkTail<C>,
    choice: &TrunkChoice,
    weights: &TrunkWeights<C>,
    form: &Form<C>,
) -> Result<Balancing<C>, OutOfRange> {
    let middle = f64::midpoint(choice.range.from, choice.range.to);
    let u_0 = |phi| Ok(weighed(tail, choice, weights, phi)?.load.u_0);
    Balancing::new(form, middle, u_0)
}

/// # Errors
/// A boom angle at which the balance cannot be.
pub fn residual<C: Calc>(balancing: &Balancing<C>, own: &TrunkWeight<C>, phi: &C) -> Result<Residual<C>, OutOfRange> {
    balancing.at(*phi, || own.load)
}

/// And what they would ask of the drive without the balance.
pub fn balanced<C: Calc>(
    residual: &Residual<C>,
    hanging: &TrunkLoad<C>,
    own: &TrunkWeight<C>,
    drive: Option<&Drive<C>>,
) -> Balanced<C> {
    let force = |moment| drive.map(|drive| drive.force(moment, &b::F_D_0));
    Balanced::new(residual, hanging.m_q, [hanging.m_q, own.m_g], force)
}

/// Over the working range, on plain numbers.
///
/// # Errors
/// Where the balance cannot be over the whole range.
pub fn analysed<C: Calc>(
    tail: &TrunkTail<C>,
    choice: &TrunkChoice,
    weights: &TrunkWeights<C>,
    form: &Form<C>,
) -> Found<Analysis> {
    let plain = &mut |_, value: C| value.value();
    let (tail, weights) = (tail.map(C::value), Group::map(weights, plain));
    let balancing = balancing(&tail, choice, &weights, &Group::map(form, plain))?;
    let at = |phi: f64| residual(&balancing, &weighed(&tail, choice, &weights, phi)?, &phi);
    Ok(Analysis::over([choice.range.from, choice.range.to], &at)?)
}

/// # Errors
/// As [`analysed`].
pub fn criteria<C: Calc>(
    balancing: &Balancing<C>,
    tail: &TrunkTail<C>,
    choice: &TrunkChoice,
    weights: &TrunkWeights<C>,
    found: &Analysis,
) -> Result<Criteria<C>, OutOfRange> {
    Criteria::new(found, &choice.range, &|phi| {
        residual(balancing, &weighed(tail, choice, weights, phi)?, &phi)
    })
}
