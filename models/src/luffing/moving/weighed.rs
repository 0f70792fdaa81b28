//! The counterweight of a balance while it moves: its place with two derivatives by the mechanism's coordinate.

use num_dual::{Dual2, Dual64, DualNum};

use crate::balance::action::RodLine;
use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::{Calc, Over, Takes};
use crate::kernel::group::Group;
use crate::kernel::record::Rec;
use crate::luffing::balancing::Balancing;
use crate::luffing::moving::balance_in_motion::{PosedCounterweight, named};
use crate::luffing::moving::bodies::{changes, parts};
use crate::luffing::moving::symbols as m;
use crate::parts::plane::{self, Point};

/// A mass (kg) with its place and two derivatives of that, in m.
pub type Weight<C> = (C, [Point<C>; 3]);

/// What a balance stands on.
pub trait Balanceable: Copy + Send + Sync {
    /// Its quantities over a scalar, and what the scene has chosen.
    type Of<C: Calc>: Copy + Send + Sync;
    type Choice: Clone + Send + Sync;

    fn map<C: Calc, D: Calc>(of: &Self::Of<C>, f: &mut dyn FnMut(C) -> D) -> Self::Of<D>;

    /// # Errors
    /// Quantities with which there is no such balance.
    fn balancing<C: Calc>(of: &Self::Of<C>, form: &Form<C>, choice: &Self::Choice) -> Result<Balancing<C>, OutOfRange>;

    /// Turning of the boom that the balance sees for one radian of the coordinate, 1 or -1.
    const SENSE: f64;

    /// Angle (rad) of that boom, at the coordinate (rad).
    fn angle<C: Calc>(phi: C) -> C;

    /// Potential energy of what is balanced (J), at the coordinate (rad), with three derivatives.
    fn energy<C: Calc>(of: &Self::Of<C>, choice: &Self::Choice, phi: C) -> C;
}

/// The balance over numbers with two derivatives.
#[derive(Clone, Copy)]
struct Moved<T, B> {
    balancing: Balancing<Dual2<T>>,
    boom: B,
    /// In kg.
    mass: T,
}

impl<T: Calc + DualNum, B> Moved<T, B> {
    fn new<K: Balanceable<Of<Dual2<T>> = B>>(
        boom: &K::Of<T>,
        form: &Form<T>,
        choice: &K::Choice,
        gravity: T,
    ) -> Result<Moved<T, B>, OutOfRange> {
        let balancing = K::balancing(boom, form, choice)?;
        let weight = balancing.balance.weight();
        Ok(Moved {
            balancing: balancing.map(Dual2::from_re),
            boom: K::map(boom, &mut Dual2::from_re),
            mass: weight.map_or(T::constant(0.0), |weight| weight / gravity),
        })
    }

    fn weighed<K: Balanceable<Of<Dual2<T>> = B>>(&self, choice: &K::Choice, phi: T) -> Option<Weight<T>> {
        let phi = Dual2::new(phi, T::constant(1.0), T::constant(0.0));
        let place = self
            .balancing
            .place(K::angle(phi), || K::energy(&self.boom, choice, phi))?;
        Some((self.mass, parts(place)))
    }

    fn posed<K: Balanceable<Of<Dual2<T>> = B>>(&self, choice: &K::Choice, phi: T) -> Option<PosedCounterweight<T>> {
        let weight = self.weighed::<K>(choice, phi)?;
        let balance = self.balancing.balance.map(|x: Dual2<T>| x.re);
        Some(posed::<T, K>(weight, phi, |boom, [at, travel]| {
            balance.line(boom, at, travel)
        }))
    }
}

/// Forward of the mechanism's origin, at the coordinate (rad); with what carries a force where the boom that the balance sees is at
/// an angle, and the counterweight at a place from which it moves for one radian of that boom.
fn posed<T: Calc, K: Balanceable>(
    (mass, [at, travel, bend]): Weight<T>,
    phi: T,
    line: impl FnOnce(T, [Point<T>; 2]) -> Option<RodLine<T>>,
) -> PosedCounterweight<T> {
    let boom = T::constant(K::SENSE);
    PosedCounterweight {
        mass,
        reach: at.x,
        travel: [travel, bend],
        boom,
        line: line(K::angle(phi), [at, travel / boom]),
    }
}

/// A balance in motion, of quantities known as `P`.
#[derive(Clone)]
pub struct MovedBalance<K: Balanceable, P: Calc> {
    boom: K::Of<P>,
    form: Form<P>,
    choice: K::Choice,
    gravity: P,
    /// For two and for three derivatives.
    twice: Moved<f64, K::Of<Dual2<f64>>>,
    thrice: Moved<Dual64, K::Of<Dual2<Dual64>>>,
}

impl<K: Balanceable, P: Calc> MovedBalance<K, P>
where
    Dual64: Over<P>,
{
    /// Under gravity in m/s².
    ///
    /// # Errors
    /// Quantities with which there is no such balance.
    pub fn new(
        boom: &K::Of<P>,
        form: Form<P>,
        choice: &K::Choice,
        gravity: P,
    ) -> Result<MovedBalance<K, P>, OutOfRange> {
        let value = &mut |x: P| x.value();
        let v_boom = K::map(boom, value);
        let d_boom = K::map(boom, &mut |x| Dual64::of(x));
        let v_form = Group::map(&form, &mut |_, x: P| x.value());
        let d_form = Group::map(&form, &mut |_, x: P| Dual64::of(x));
        Ok(MovedBalance {
            twice: Moved::new::<K>(&v_boom, &v_form, choice, gravity.value())?,
            thrice: Moved::new::<K>(&d_boom, &d_form, choice, Dual64::of(gravity))?,
            boom: *boom,
            form,
            choice: choice.clone(),
            gravity,
        })
    }

    /// With one more derivative; `None` where the balance cannot be.
    pub fn with_slope(&self, phi: Dual64) -> Option<Weight<Dual64>> {
        self.thrice.weighed::<K>(&self.choice, phi)
    }
}

/// A scalar over which the counterweight is found, with quantities known as `P`.
pub trait Weighing<P: Calc = f64>: Over<P> {
    /// At the coordinate (rad); `None` where the balance cannot be.
    fn weighed<K: Balanceable>(of: &MovedBalance<K, P>, phi: Self) -> Option<Weight<Self>>;

    /// As [`weighed`](Weighing::weighed), with how it carries a force.
    fn posed<K: Balanceable>(of: &MovedBalance<K, P>, phi: Self) -> Option<PosedCounterweight<Self>>;
}

impl Weighing for f64 {
    fn weighed<K: Balanceable>(of: &MovedBalance<K, f64>, phi: f64) -> Option<Weight<f64>> {
        of.twice.weighed::<K>(&of.choice, phi)
    }

    fn posed<K: Balanceable>(of: &MovedBalance<K, f64>, phi: f64) -> Option<PosedCounterweight<f64>> {
        of.twice.posed::<K>(&of.choice, phi)
    }
}

impl Weighing<Dual64> for Dual64 {
    fn weighed<K: Balanceable>(of: &MovedBalance<K, Dual64>, phi: Dual64) -> Option<Weight<Dual64>> {
        of.thrice.weighed::<K>(&of.choice, phi)
    }

    fn posed<K: Balanceable>(of: &MovedBalance<K, Dual64>, phi: Dual64) -> Option<PosedCounterweight<Dual64>> {
        of.thrice.posed::<K>(&of.choice, phi)
    }
}

/// For the book: the place is a formula, and what derivatives give has names.
impl Weighing<Rec> for Rec {
    fn weighed<K: Balanceable>(of: &MovedBalance<K, Rec>, phi: Rec) -> Option<Weight<Rec>> {
        let (mass, [_, travel, bend]) = of.twice.weighed::<K>(&of.choice, phi.value())?;
        let balancing = K::balancing(&of.boom, &of.form, &of.choice).ok()?;
        let place = balancing.place(K::angle(phi), || K::energy(&of.boom, &of.choice, phi))?;
        let place = plane::def(place, [&b::C_5X, &b::C_5Y]);
        let [travel, bend] = changes(place, phi, [travel, bend], m::OF_COUNTERWEIGHT);
        let mass = (balancing.balance.weight()? / of.gravity).rounded_as(mass);
        Some((mass.def(&m::MASS_5), [place, travel, bend]))
    }

    fn posed<K: Balanceable>(of: &MovedBalance<K, Rec>, phi: Rec) -> Option<PosedCounterweight<Rec>> {
        let (weight, values) = (Rec::weighed(of, phi)?, of.twice.posed::<K>(&of.choice, phi.value())?);
        let balancing = K::balancing(&of.boom, &of.form, &of.choice).ok()?;
        Some(posed::<Rec, K>(weight, phi, |boom, [at, travel]| {
            let line = balancing.balance.line(boom, at, travel).zip(values.line);
            line.map(|(line, values)| named(&line, &values))
        }))
    }
}
