//! A balance on the link, which is the boom that it sees: at its angle, with the weights that it carries.

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
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice, GuidedPosition, axes};
use crate::luffing::ellipsograph::statics::{GuidedWeights, HeadLoad, WeightMoment};
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::moving::weighed::Balanceable;

/// A balance on the link, which turns the other way.
#[derive(Clone, Copy)]
pub struct OnLink;

impl Balanceable for OnLink {
    type Of<C: Calc> = (Bars<C>, GuidedWeights<C>);
    type Choice = GuidedChoice;

    fn map<C: Calc, D: Calc>((bars, weights): &Self::Of<C>, f: &mut dyn FnMut(C) -> D) -> Self::Of<D> {
        let bars = Group::map(bars, &mut |_, x| f(x));
        (bars, Group::map(weights, &mut |_, x| f(x)))
    }

    fn balancing<C: Calc>(
        (bars, weights): &Self::Of<C>,
        form: &Form<C>,
        choice: &GuidedChoice,
    ) -> Result<Balancing<C>, OutOfRange> {
        balancing(bars, weights, form, choice)
    }

    const SENSE: f64 = -1.0;

    fn angle<C: Calc>(phi: C) -> C {
        -phi
    }

    fn energy<C: Calc>((bars, weights): &Self::Of<C>, _: &GuidedChoice, phi: C) -> C {
        WeightMoment::new(bars, weights, &phi).load.u_0
    }
}

/// # Errors
/// Quantities with which there is no such balance.
pub fn balancing<C: Calc>(
    bars: &Bars<C>,
    weights: &GuidedWeights<C>,
    form: &Form<C>,
    choice: &GuidedChoice,
) -> Result<Balancing<C>, OutOfRange> {
    let middle = -f64::midpoint(choice.range.from, choice.range.to);
    let u_0 = |theta: C| Ok(WeightMoment::new(bars, weights, &-theta).load.u_0);
    Balancing::new(form, middle, u_0).map_err(in_scene)
}

/// # Errors
/// An angle of the link at which the balance cannot be.
pub fn residual<C: Calc>(
    balancing: &Balancing<C>,
    own: &WeightMoment<C>,
    position: &GuidedPosition<C>,
) -> Result<Residual<C>, OutOfRange> {
    balancing.at(position.theta_l, || own.load).map_err(in_scene)
}

/// At an angle of the boom, in rad.
fn at<C: Calc>(
    balancing: &Balancing<C>,
    bars: &Bars<C>,
    weights: &GuidedWeights<C>,
    phi: C,
) -> Result<Residual<C>, OutOfRange> {
    let own = WeightMoment::new(bars, weights, &phi);
    residual(balancing, &own, &GuidedPosition::new(bars, &axes(bars), &phi))
}

/// What raises the boom lowers the link.
pub fn balanced<C: Calc>(
    residual: &Residual<C>,
    hanging: &HeadLoad<C>,
    own: &WeightMoment<C>,
    drive: Option<&Drive<C>>,
) -> Balanced<C> {
    let force = |moment: C| drive.map(|drive| drive.force(-moment, &b::F_D_0));
    Balanced::new(residual, -hanging.m_q, [hanging.m_q, own.m_g], force)
}

/// Over the working range, on plain numbers.
///
/// # Errors
/// Where the balance cannot be over the whole range.
pub fn analysed<C: Calc>(
    bars: &Bars<C>,
    weights: &GuidedWeights<C>,
    form: &Form<C>,
    choice: &GuidedChoice,
) -> Found<Analysis> {
    let bars = Group::map(bars, &mut |_, value: C| value.value());
    let weights = Group::map(weights, &mut |_, value: C| value.value());
    let form = Group::map(form, &mut |_, value: C| value.value());
    let balancing = balancing(&bars, &weights, &form, choice)?;
    let at = |phi: f64| at(&balancing, &bars, &weights, phi);
    Ok(Analysis::over([choice.range.from, choice.range.to], &at).map_err(in_scene)?)
}

/// # Errors
/// As [`analysed`].
pub fn criteria<C: Calc>(
    balancing: &Balancing<C>,
    bars: &Bars<C>,
    weights: &GuidedWeights<C>,
    found: &Analysis,
    choice: &GuidedChoice,
) -> Result<Criteria<C>, OutOfRange> {
    Criteria::new(found, &choice.range, &|phi| at(balancing, bars, weights, phi))
}

/// A fault in the names of this mechanism: the angle of what the balance sees is that of the link.
fn in_scene(fault: OutOfRange) -> OutOfRange {
    let quantity = if fault.quantity == &b::PHI {
        &s::THETA_L
    } else {
        fault.quantity
    };
    OutOfRange { quantity, ..fault }
}
