//! A single boom in motion, from what a mechanism says of it: its bodies with what they weigh, its level, its own rates.

use std::marker::PhantomData;
use std::sync::Arc;

use num_dual::Dual64;

use crate::balance::scene::Form;
use crate::component::scalar::{EachScalar, Scalar};
use crate::component::stages::{Found, Rows, absent, results};
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::One;
use crate::kernel::record::Rec;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::luffing::moving::balance_in_motion::{BalanceInMotion, PosedCounterweight};
use crate::luffing::moving::bodies::{Asked, deviation};
use crate::luffing::moving::built::{HoistParts, LevelParts, Outfit};
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::exposed::Exposed;
use crate::luffing::moving::geared::Geared;
use crate::luffing::moving::given::{Constants, Fitted, SlewedParts};
use crate::luffing::moving::inertia_forces::{PosedBody, hanging};
use crate::luffing::moving::level::{CraneAt, Level};
use crate::luffing::moving::reduced::{CoordinateNames, Reduced, Reduces, Renewed};
use crate::luffing::moving::shares::Instant;
use crate::luffing::moving::stages::{CraneMoves, open, present};
use crate::luffing::moving::symbols as s;
use crate::luffing::moving::weighed::{Balanceable, MovedBalance, Weighing, Weight};
use crate::luffing::resistances::placed::Placing;
use crate::parts::air::AirAround;
use crate::parts::ground::GroundBelow;
use crate::parts::hydraulics::cylinder::Cylinder;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};

/// A mechanism with one boom and one coordinate, the boom's angle: what is its own in motion.
pub trait SingleBoom: Copy + Send + Sync + 'static {
    /// What it is made of over a scalar, besides load, balance, hoist and joints.
    type Own<C: Calc>: Clone + Send + Sync;
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

    /// A load that hangs straight down at any time: its mass (kg), where it is (m), what it moves by for one radian of the boom's
    /// angle, and how that changes (m); `None` where a body has it, or where a rope does on which it swings.
    fn load<P: Over<P>>(_: &Self::Bodies<P>, _: P) -> Option<(P, [Point<P>; 3])> {
        None
    }

    /// Of a drive along a line: its length (m) and its lever arm for one radian of the boom's angle (m); `None` without one.
    fn line<P: Calc, C: Over<P>>(_: &Self::Bodies<P>, _: C) -> Option<[C; 2]> {
        None
    }

    /// Under gravity (m/s²), as the equations of motion ask, at the boom's angle (rad), the counterweight by its mass (kg) and place
    /// (m); `None` where there is no such place.
    fn at<P: Calc, C: Over<P>>(
        bodies: &Self::Bodies<P>,
        around: (P, &Asked<P>),
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

impl<B: SingleBoom, P: Calc> Heavy<B, P> {
    /// What of it moves and weighs, and gravity (m/s²).
    pub fn bodies(&self) -> (&B::Bodies<P>, P) {
        (&self.bodies, self.gravity)
    }
}

impl<B: SingleBoom, P: Weighing<P>> Reduces<P> for Heavy<B, P>
where
    Dual64: Over<P>,
{
    fn reduced(&self, phi: P, asked: &Asked<P>) -> Option<Reduced<P>> {
        let weight = self.balance.as_ref().map(|balance| P::weighed(balance, phi));
        let weight = weight.map_or(Some(None), |found| found.map(Some))?;
        B::at(&self.bodies, (self.gravity, asked), phi, weight)
    }

    fn with_slope(&self, phi: Dual64, asked: &Asked<P>) -> Option<Reduced<Dual64>> {
        let weight = self.balance.as_ref().map(|balance| balance.with_slope(phi));
        let weight = weight.map_or(Some(None), |found| found.map(Some))?;
        B::at(&self.bodies, (self.gravity, asked), phi, weight)
    }

    fn names(&self) -> CoordinateNames {
        B::NAMES
    }

    fn is_pulled(&self) -> bool {
        B::PULLED
    }
}

/// What acts on a boom in motion besides what it weighs.
#[derive(Clone, Copy, Debug)]
pub struct Acting<C> {
    pub at: Instant<C>,
    pub balance: Option<BalanceInMotion<C>>,
    /// Place of the axis about which it turns, where it does, in m.
    axis: Option<C>,
}
results! { Acting as a => {
    F_AX: a.at.pull.ok_or_else(absent)?.x;
    F_AY: a.at.pull.ok_or_else(absent)?.y;
    M_RC: a.at.shares.dry;
    M_RV: a.at.shares.viscous;
    M_RS: a.at.shares.stop;
} }

impl<P: Coordinate<P>> Acting<P> {
    /// Of a crane at an instant; `None` where its balance cannot be.
    fn of<B: SingleBoom>(level: &Level<P>, heavy: &Heavy<B, P>, at: &CraneAt<P>) -> Option<Acting<P>>
    where
        P: Weighing<P>,
    {
        let (zero, phi) = (P::constant(0.0), at.y[0]);
        let axis = level.dynamics().turns().map(|table| table.axis);
        let reach = |x: P| axis.map_or(zero, |axis| x - axis);
        let by_cylinder = level.dynamics().is_by_cylinder();
        let line = by_cylinder.then(|| B::line(&heavy.bodies, phi)).flatten();
        let instant = level.instant(at, line.map_or(zero, |[_, arm]| arm))?;
        let balance = heavy.balance.as_ref().map(|balance| P::posed(balance, phi));
        let balance = balance.map_or(Some(None), |found| found.map(Some))?;
        let instant = match B::load(&heavy.bodies, phi).filter(|_| instant.pull.is_none()) {
            Some((mass, places)) => hanging(instant, (mass, places), reach(places[0].x), heavy.gravity),
            None => instant,
        };
        Some(Acting {
            balance: balance.map(|it| {
                let reach = reach(it.reach);
                BalanceInMotion::new(&PosedCounterweight { reach, ..it }, &instant, heavy.gravity)
            }),
            at: instant,
            axis,
        })
    }
}

impl<C: Calc> Acting<C> {
    /// A body as it turns about the axis, where it does: with its centre forward of the mechanism's origin (m), and how it lies in
    /// the frame of a bar along a unit vector.
    pub fn turning(&self, body: PosedBody<C>, forward: C, (spread, along): ([C; 3], Point<C>)) -> PosedBody<C> {
        let Some(axis) = self.axis else { return body };
        PosedBody {
            reach: forward - axis,
            deviation: deviation(spread, along),
            ..body
        }
    }

    /// How far the moment on the boom that equilibrium asks for (N·m) is from that of drive, friction and end stop, and the
    /// greatest of what they are made of: of forces (N) on arms (m) what they have at most.
    #[must_use]
    pub fn apart<const N: usize>(&self, asked: C, levers: [[Point<C>; 2]; N]) -> [f64; 2] {
        let (acting, greatest) = self.at.shares.acting();
        let most = levers.map(|lever| lever.map(|of| plane::length(of.map(C::value))));
        let sizes = most.into_iter().map(|[arm, force]| arm * force);
        let sizes = sizes.chain([greatest, asked.value().abs()]);
        let lift = self.balance.map_or(0.0, |balance| balance.lift);
        [(asked - acting).value().abs(), sizes.fold(lift, f64::max)]
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

    fn level(&self, heavy: &Arc<Heavy<B, P>>, fitted: Outfit<P>) -> Level<P> {
        let gravity = self.rest.constants.g;
        let pendulum = self.rest.fitted.rope.and_then(|rope| {
            let load = (self.load / gravity).def(&s::MASS_Q);
            self.hoist.pendulum(load, Some(rope))
        });
        let dynamics = Dynamics::new(heavy.clone(), pendulum, gravity);
        self.rest.clone().level(dynamics, fitted)
    }
}

/// Each scalar has derivatives by the boom's angle in its own way.
struct SingleInMotion<B>(PhantomData<B>);

type Making<B, P> = fn(&SingleParts<B, P>) -> Result<Heavy<B, P>, Fault>;
type ActingOf<B, P> = fn(&Level<P>, &Heavy<B, P>, &CraneAt<P>) -> Option<Acting<P>>;
type Levelling<B, P> = fn(&SingleParts<B, P>, &Arc<Heavy<B, P>>, Outfit<P>) -> Level<P>;

/// What the equations of motion have of it, over a scalar.
pub struct SingleEquations<B: SingleBoom, P: Calc> {
    heavy: Making<B, P>,
    level: Levelling<B, P>,
    acting: ActingOf<B, P>,
}

impl<B: SingleBoom, P: Weighing<P> + Coordinate<P>> SingleEquations<B, P>
where
    Dual64: Over<P>,
{
    fn new() -> SingleEquations<B, P> {
        SingleEquations {
            heavy: SingleParts::heavy,
            level: SingleParts::level,
            acting: Acting::of,
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
    ground: &Option<GroundBelow<C>>,
    slewed: &Option<SlewedParts<C>>,
    constants: &Constants<C>,
    fitted: &Fitted,
    room: &mut Vec<SingleParts<B, C>>,
) {
    let (range, axis) = B::range(own);
    room.clear();
    room.push(SingleParts {
        own: own.clone(),
        load: load.1,
        balance: *balance,
        hoist: *hoist,
        rest: LevelParts {
            range,
            axis,
            constants: *constants,
            slewed: *slewed,
            around: *around,
            ground: *ground,
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

/// The equations of the level, nothing being asked of it, in wind and on a slope where it meets them.
pub fn built<B: SingleBoom, K: Placing, C: Scalar>(
    parts: &[SingleParts<B, C>],
    heavy: &[Renewed<Heavy<B, C>>],
    exposed: &[Renewed<Exposed<K, C>>],
    room: &mut Vec<Level<C>>,
) {
    driven(parts, heavy, &[], None, exposed, room);
}

/// The same with a motor that turns with it, or a cylinder that moves it, where there is one.
pub fn driven<B: SingleBoom, K: Placing, C: Scalar>(
    parts: &[SingleParts<B, C>],
    heavy: &[Renewed<Heavy<B, C>>],
    geared: &[Renewed<Geared<C>>],
    cylinder: Option<&Cylinder<C>>,
    exposed: &[Renewed<Exposed<K, C>>],
    room: &mut Vec<Level<C>>,
) {
    let fittings = Outfit::new(geared, cylinder, exposed);
    room.clear();
    room.push((C::own::<SingleInMotion<B>>().level)(
        &parts[0],
        heavy[0].now(),
        fittings,
    ));
}

/// What acts on it, under present inputs.
///
/// # Errors
/// An angle at which its balance cannot be.
pub fn acting<B: SingleBoom, C: Scalar>(
    heavy: &[Renewed<Heavy<B, C>>],
    built: &[Level<C>],
    told: &[Level<C>],
    at: &CraneAt<C>,
    phi: &One<C>,
) -> Result<Acting<C>, Fault> {
    let found = (C::own::<SingleInMotion<B>>().acting)(present(built, told), heavy[0].now(), at);
    found.ok_or_else(|| open(phi))
}

/// What its balance does to it.
///
/// # Errors
/// None where there is one.
pub fn countered<C: Calc>(acting: &Acting<C>, _: &Form<C>) -> Found<BalanceInMotion<C>> {
    acting.balance.ok_or_else(absent)
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
