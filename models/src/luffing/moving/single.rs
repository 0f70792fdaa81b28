//! A single boom in motion, from what a mechanism says of it: its bodies with what they weigh, its level, its own rates.

use std::marker::PhantomData;
use std::sync::Arc;

use num_dual::Dual64;

use crate::balance::scene::Form;
use crate::component::scalar::{EachScalar, Scalar};
use crate::component::stages::{Found, Rows};
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::One;
use crate::kernel::record::Rec;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::luffing::moving::built::{HoistParts, LevelParts};
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::given::{Constants, Fitted};
use crate::luffing::moving::level::Level;
use crate::luffing::moving::reduced::{Asked, CoordinateNames, Reduced, Reduces, Renewed};
use crate::luffing::moving::stages::CraneMoves;
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::weighed::{Balanceable, MovedBalance, Weighing, Weight};
use crate::parts::air::AirAround;
use crate::parts::motion::Motion;

/// A mechanism with one boom and one coordinate, the boom's angle: what is its own in motion.
pub trait SingleBoom: Copy + Send + Sync + 'static {
    /// What it is made of over a scalar, besides load, balance, hoist and joints.
    type Own<C: Calc>: Copy + Send + Sync;
    /// What its balance stands on.
    type Stands: Balanceable;
    /// What of it moves and weighs.
    type Bodies<P: Calc>: Clone + Send + Sync;

    const NAMES: CoordinateNames;

    /// Rates of angle and angular velocity.
    const RATES: &'static [&'static Symbol];

    /// Whether a rope luffs it, as in [`Reduces::is_pulled`].
    const PULLED: bool = false;

    /// Working range, and where the slewing axis is (m).
    fn range<C: Calc>(own: &Self::Own<C>) -> (Motion, C);

    fn stands<C: Calc>(
        own: &Self::Own<C>,
    ) -> (
        <Self::Stands as Balanceable>::Of<C>,
        <Self::Stands as Balanceable>::Choice,
    );

    /// With the mass (kg) of a load on no rope that swings, under gravity (m/s²).
    fn bodies<P: Calc>(own: &Self::Own<P>, fixed: Option<P>, gravity: P) -> Self::Bodies<P>;

    /// At the boom's angle (rad), the counterweight by its mass (kg) and place (m); `None` where there is no such place.
    fn at<P: Calc, C: Over<P>>(
        bodies: &Self::Bodies<P>,
        gravity: P,
        phi: C,
        counterweight: Option<Weight<C>>,
    ) -> Option<Reduced<C>>;
}

/// Its bodies with what they weigh, and its balance.
#[derive(Clone)]
pub struct Heavy<B: SingleBoom, P: Calc> {
    bodies: B::Bodies<P>,
    gravity: P,
    balance: Option<MovedBalance<B::Stands, P>>,
}

impl<B: SingleBoom, P: Calc> Heavy<B, P>
where
    Dual64: Over<P>,
{
    /// With the mass (kg) of a load on no rope that swings, under gravity (m/s²).
    ///
    /// # Errors
    /// Quantities with which there is no such balance.
    pub fn new(
        own: &B::Own<P>,
        form: &Option<Form<P>>,
        fixed: Option<P>,
        gravity: P,
    ) -> Result<Heavy<B, P>, OutOfRange> {
        let (stands, choice) = B::stands(own);
        let balance = form.map(|form| MovedBalance::new(&stands, form, &choice, gravity));
        Ok(Heavy {
            bodies: B::bodies(own, fixed, gravity),
            gravity,
            balance: balance.transpose()?,
        })
    }
}

impl<B: SingleBoom, P: Weighing<P>> Reduces<P> for Heavy<B, P>
where
    Dual64: Over<P>,
{
    fn reduced(&self, phi: P, _: &Asked<P>) -> Option<Reduced<P>> {
        let weight = self.balance.as_ref().map(|balance| P::weighed(balance, phi));
        let weight = weight.map_or(Some(None), |found| found.map(Some))?;
        B::at(&self.bodies, self.gravity, phi, weight)
    }

    fn with_slope(&self, phi: Dual64, _: &Asked<P>) -> Option<Reduced<Dual64>> {
        let weight = self.balance.as_ref().map(|balance| balance.with_slope(phi));
        let weight = weight.map_or(Some(None), |found| found.map(Some))?;
        B::at(&self.bodies, self.gravity, phi, weight)
    }

    fn names(&self) -> CoordinateNames {
        B::NAMES
    }

    fn is_pulled(&self) -> bool {
        B::PULLED
    }
}

/// All that it is made of.
#[derive(Clone)]
pub struct SingleParts<B: SingleBoom, C: Calc> {
    own: B::Own<C>,
    load: C,
    balance: Option<Form<C>>,
    hoist: HoistParts<C>,
    rest: LevelParts<C>,
}

impl<B: SingleBoom, P: Weighing<P> + Coordinate<P>> SingleParts<B, P>
where
    Dual64: Over<P>,
{
    fn heavy(&self) -> Result<Heavy<B, P>, Fault> {
        let gravity = self.rest.constants.g;
        let fixed = self.rest.fitted.rope.is_none().then(|| self.load / gravity);
        Heavy::new(&self.own, &self.balance, fixed, gravity).map_err(|fault| Fault::outside(fault.to_string()))
    }

    fn level(&self, heavy: &Arc<Heavy<B, P>>) -> Level<P> {
        let gravity = self.rest.constants.g;
        let pendulum = self.rest.fitted.rope.and_then(|rope| {
            let load = (self.load / gravity).def(&m::MASS_Q);
            self.hoist.pendulum(load, Some(rope))
        });
        let dynamics = Dynamics::new(heavy.clone(), pendulum, gravity);
        self.rest.clone().level(dynamics)
    }
}

/// Each scalar has derivatives by the boom's angle in its own way.
struct SingleInMotion<B>(PhantomData<B>);

type Making<B, P> = fn(&SingleParts<B, P>) -> Result<Heavy<B, P>, Fault>;
type Levelling<B, P> = fn(&SingleParts<B, P>, &Arc<Heavy<B, P>>) -> Level<P>;

/// What the equations of motion have of it, over a scalar.
pub struct SingleEquations<B: SingleBoom, P: Calc> {
    heavy: Making<B, P>,
    level: Levelling<B, P>,
}

impl<B: SingleBoom, P: Weighing<P> + Coordinate<P>> SingleEquations<B, P>
where
    Dual64: Over<P>,
{
    fn new() -> SingleEquations<B, P> {
        SingleEquations {
            heavy: SingleParts::heavy,
            level: SingleParts::level,
        }
    }
}

impl<B: SingleBoom> EachScalar for SingleInMotion<B> {
    type For<C: Calc> = SingleEquations<B, C>;
    fn plain() -> SingleEquations<B, f64> {
        SingleEquations::new()
    }
    fn dual() -> SingleEquations<B, Dual64> {
        SingleEquations::new()
    }
    fn recorded() -> SingleEquations<B, Rec> {
        SingleEquations::new()
    }
}

/// All that it is made of, into the room for it.
#[expect(clippy::too_many_arguments, reason = "all that it is made of")]
pub fn parts<B: SingleBoom, C: Calc>(
    own: &B::Own<C>,
    load: &One<C>,
    balance: &Option<Form<C>>,
    hoist: &HoistParts<C>,
    around: &Option<AirAround<C>>,
    constants: &Constants<C>,
    fitted: &Fitted,
    room: &mut Vec<SingleParts<B, C>>,
) {
    let (range, axis) = B::range(own);
    room.clear();
    room.push(SingleParts {
        own: *own,
        load: load.1,
        balance: *balance,
        hoist: *hoist,
        rest: LevelParts {
            range,
            axis,
            constants: *constants,
            turning: None,
            cylinder: None,
            around: *around,
            fitted: *fitted,
        },
    });
}

/// The boom with what it weighs.
///
/// # Errors
/// Quantities with which there is no such balance.
pub fn heavy<B: SingleBoom, C: Scalar>(
    parts: &[SingleParts<B, C>],
    room: &mut Vec<Renewed<Heavy<B, C>>>,
) -> Result<(), Fault> {
    Renewed::renew(room, (C::own::<SingleInMotion<B>>().heavy)(&parts[0])?);
    Ok(())
}

/// The equations of the level, nothing being asked of it.
pub fn built<B: SingleBoom, C: Scalar>(
    parts: &[SingleParts<B, C>],
    heavy: &[Renewed<Heavy<B, C>>],
    room: &mut Vec<Level<C>>,
) {
    room.clear();
    room.push((C::own::<SingleInMotion<B>>().level)(&parts[0], heavy[0].now()));
}

/// Rates of angle and angular velocity of the boom.
#[derive(Clone, Copy, Debug)]
pub struct BoomRates<B, C>([C; 2], PhantomData<B>);

impl<B: SingleBoom, C: Calc> Rows<C> for BoomRates<B, C> {
    const ROWS: &'static [&'static Symbol] = B::RATES;
    fn row(&self, row: u8, _: u16) -> Found<C> {
        Ok(self.0[usize::from(row)])
    }
}

impl<B: SingleBoom, C: Calc> BoomRates<B, C> {
    pub fn new(moves: &CraneMoves<C>) -> BoomRates<B, C> {
        BoomRates(moves.bar(), PhantomData)
    }
}
