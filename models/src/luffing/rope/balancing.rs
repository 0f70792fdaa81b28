//! A balance on this boom, whose angle is the coordinate.

use crate::balance::analysis::Analysis;
use crate::balance::boom::Plain;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::component::stages::Found;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::Calc;
use crate::kernel::group::Group;
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::moving::weighed::Balanceable;
use crate::luffing::rope::position::BoomChoice;
use crate::luffing::rope::statics::{Hanging, OwnMoment};

/// A balance on the boom itself.
#[derive(Clone, Copy)]
pub struct OnBoom;

impl Balanceable for OnBoom {
    type Of<C: Calc> = Plain<C>;
    type Choice = BoomChoice;

    fn map<C: Calc, D: Calc>(weights: &Plain<C>, f: &mut dyn FnMut(C) -> D) -> Plain<D> {
        Group::map(weights, &mut |_, x| f(x))
    }

    fn balancing<C: Calc>(weights: &Plain<C>, form: &Form<C>, choice: &BoomChoice) -> Result<Balancing<C>, OutOfRange> {
        balancing(weights, form, choice)
    }

    const SENSE: f64 = 1.0;

    fn angle<C: Calc>(phi: C) -> C {
        phi
    }

    fn energy<C: Calc>(weights: &Plain<C>, _: &BoomChoice, phi: C) -> C {
        weights.load(phi).u_0
    }
}

/// # Errors
/// Quantities with which there is no such balance.
pub fn balancing<C: Calc>(weights: &Plain<C>, form: &Form<C>, choice: &BoomChoice) -> Result<Balancing<C>, OutOfRange> {
    let middle = f64::midpoint(choice.range.from, choice.range.to);
    Balancing::new(form, middle, |phi| Ok(weights.load(phi).u_0))
}

/// # Errors
/// A boom angle at which the balance cannot be.
pub fn residual<C: Calc>(balancing: &Balancing<C>, own: &OwnMoment<C>, phi: &C) -> Result<Residual<C>, OutOfRange> {
    balancing.at(*phi, || own.load)
}

pub fn balanced<C: Calc>(residual: &Residual<C>, hanging: &Hanging<C>, own: &OwnMoment<C>) -> Balanced<C> {
    Balanced::new(residual, hanging.m_q, [hanging.m_q, own.m_g], |_| None)
}

/// Over the working range, on plain numbers.
///
/// # Errors
/// Where the balance cannot be over the whole range.
pub fn analysed<C: Calc>(weights: &Plain<C>, form: &Form<C>, choice: &BoomChoice) -> Found<Analysis> {
    let weights = Group::map(weights, &mut |_, value| value.value());
    let balancing = balancing(&weights, &Group::map(form, &mut |_, value| value.value()), choice)?;
    let at = |phi: f64| balancing.at(phi, || weights.load(phi));
    Ok(Analysis::over([choice.range.from, choice.range.to], &at)?)
}

/// # Errors
/// As [`analysed`].
pub fn criteria<C: Calc>(
    balancing: &Balancing<C>,
    weights: &Plain<C>,
    found: &Analysis,
    choice: &BoomChoice,
) -> Result<Criteria<C>, OutOfRange> {
    Criteria::new(found, &choice.range, &|phi| balancing.at(phi, || weights.load(phi)))
}
