//! The counterweight of a balance on the link while it moves: its place with two derivatives by the boom's angle.

use num_dual::{Dual2, Dual64, DualNum};

use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::{Calc, Over, Takes};
use crate::kernel::group::Group;
use crate::kernel::record::Rec;
use crate::luffing::balancing::Balancing;
use crate::luffing::ellipsograph::balancing::balancing;
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice};
use crate::luffing::ellipsograph::statics::{GuidedWeights, WeightMoment};
use crate::luffing::moving::bodies::{changes, parts};
use crate::luffing::moving::symbols as m;
use crate::parts::plane::{self, Point};

/// A mass (kg) with its place and two derivatives of that, in m.
type Weight<C> = (C, [Point<C>; 3]);

/// The balance over numbers with two derivatives.
#[derive(Clone, Copy)]
struct LinkWeight<T> {
    balancing: Balancing<Dual2<T>>,
    bars: Bars<Dual2<T>>,
    weights: GuidedWeights<Dual2<T>>,
    /// In kg.
    mass: T,
}

impl<T: Calc + DualNum> LinkWeight<T> {
    fn new(
        bars: &Bars<T>,
        weights: &GuidedWeights<T>,
        form: &Form<T>,
        choice: &GuidedChoice,
        gravity: T,
    ) -> Result<LinkWeight<T>, OutOfRange> {
        let balancing = balancing(bars, weights, form, choice)?;
        let weight = balancing.balance.weight();
        Ok(LinkWeight {
            balancing: balancing.map(Dual2::from_re),
            bars: Group::map(bars, &mut |_, x| Dual2::from_re(x)),
            weights: Group::map(weights, &mut |_, x| Dual2::from_re(x)),
            mass: weight.map_or(T::constant(0.0), |weight| weight / gravity),
        })
    }

    fn weighed(&self, phi: T) -> Option<Weight<T>> {
        let phi = Dual2::new(phi, T::constant(1.0), T::constant(0.0));
        let u_0 = || WeightMoment::new(&self.bars, &self.weights, &phi).load.u_0;
        Some((self.mass, parts(self.balancing.place(-phi, u_0)?)))
    }
}

/// A balance on the link, of quantities known as `P`.
#[derive(Clone)]
pub struct LinkBalance<P> {
    bars: Bars<P>,
    weights: GuidedWeights<P>,
    form: Form<P>,
    choice: GuidedChoice,
    gravity: P,
    /// For two and for three derivatives.
    twice: LinkWeight<f64>,
    thrice: LinkWeight<Dual64>,
}

impl<P: Calc> LinkBalance<P>
where
    Dual64: Over<P>,
{
    /// Under gravity in m/s².
    ///
    /// # Errors
    /// Quantities with which there is no such balance.
    pub fn new(
        bars: &Bars<P>,
        weights: &GuidedWeights<P>,
        form: Form<P>,
        choice: &GuidedChoice,
        gravity: P,
    ) -> Result<LinkBalance<P>, OutOfRange> {
        let value = &mut |_, x: P| x.value();
        let (v_bars, v_weights) = (Group::map(bars, value), Group::map(weights, value));
        let dual = &mut |_, x: P| Dual64::of(x);
        let (d_bars, d_weights) = (Group::map(bars, dual), Group::map(weights, dual));
        let v_form = Group::map(&form, value);
        Ok(LinkBalance {
            twice: LinkWeight::new(&v_bars, &v_weights, &v_form, choice, gravity.value())?,
            thrice: LinkWeight::new(
                &d_bars,
                &d_weights,
                &Group::map(&form, dual),
                choice,
                Dual64::of(gravity),
            )?,
            bars: *bars,
            weights: *weights,
            form,
            choice: *choice,
            gravity,
        })
    }

    /// With one more derivative; `None` where the balance cannot be.
    pub fn with_slope(&self, phi: Dual64) -> Option<Weight<Dual64>> {
        self.thrice.weighed(phi)
    }
}

/// A scalar over which the counterweight is found, with quantities known as `P`.
pub trait Weighing<P = f64>: Over<P> {
    /// At an angle of the boom (rad); `None` where the balance cannot be.
    fn weighed(of: &LinkBalance<P>, phi: Self) -> Option<Weight<Self>>;
}

impl Weighing for f64 {
    fn weighed(of: &LinkBalance<f64>, phi: f64) -> Option<Weight<f64>> {
        of.twice.weighed(phi)
    }
}

impl Weighing<Dual64> for Dual64 {
    fn weighed(of: &LinkBalance<Dual64>, phi: Dual64) -> Option<Weight<Dual64>> {
        of.thrice.weighed(phi)
    }
}

/// For the book: the place is a formula, and what derivatives give has names.
impl Weighing<Rec> for Rec {
    fn weighed(of: &LinkBalance<Rec>, phi: Rec) -> Option<Weight<Rec>> {
        let (mass, [_, travel, bend]) = of.twice.weighed(phi.value())?;
        let balancing = balancing(&of.bars, &of.weights, &of.form, &of.choice).ok()?;
        let u_0 = || WeightMoment::new(&of.bars, &of.weights, &phi).load.u_0;
        let place = plane::def(balancing.place(-phi, u_0)?, [&b::C_5X, &b::C_5Y]);
        let [travel, bend] = changes(place, phi, [travel, bend], m::OF_COUNTERWEIGHT);
        let mass = (balancing.balance.weight()? / of.gravity).rounded_as(mass);
        Some((mass.def(&m::MASS_5), [place, travel, bend]))
    }
}
