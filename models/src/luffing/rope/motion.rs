//! The boom in motion as stages: its level, its own rates.

use std::sync::Arc;

use num_dual::Dual64;

use crate::balance::boom::Plain;
use crate::balance::scene::Form;
use crate::component::scalar::{EachScalar, Scalar};
use crate::component::stages::results;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::One;
use crate::kernel::record::Rec;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::luffing::moving::bodies::Body;
use crate::luffing::moving::built::{HoistParts, LevelParts};
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::given::{Constants, Fitted};
use crate::luffing::moving::hoisting::{HoistRamp, RopeGive};
use crate::luffing::moving::level::Level;
use crate::luffing::moving::reduced::Renewed;
use crate::luffing::moving::stages::{CraneMoves, rates_after};
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::weighed::{MovedBalance, Weighing};
use crate::luffing::rope::moving::{BoomInertia, HeavyBoom};
use crate::luffing::rope::position::{BoomChoice, Compensation, Rig};
use crate::luffing::rope::symbols as s;
use crate::parts::plane::Point;

/// What the boom in motion is made of.
#[derive(Clone)]
pub struct BoomParts<C: Calc> {
    rig: Rig<C>,
    compensation: Option<Compensation<C>>,
    load: C,
    weights: Plain<C>,
    balance: Option<Form<C>>,
    inertia: BoomInertia<C>,
    hoist: HoistParts<C>,
    rest: LevelParts<C>,
    choice: BoomChoice,
}

impl<P: Weighing<P> + Coordinate<P> + Send + Sync + 'static> BoomParts<P>
where
    Dual64: Over<P>,
{
    fn boom(&self) -> Result<HeavyBoom<P>, Fault> {
        let gravity = self.rest.constants.g;
        let along = Point::new(P::constant(1.0), P::constant(0.0));
        let (sin, cos) = self.weights.chi_b.sin_cos();
        let centre = Point::new(self.weights.r_b * cos, self.weights.r_b * sin);
        let hangs = || Body::slender(self.load / gravity, P::constant(0.0), along * P::constant(0.0), along);
        let balance = (self.balance).map(|form| MovedBalance::new(&self.weights, form, &self.choice, gravity));
        Ok(HeavyBoom {
            rig: self.rig,
            parts: self.compensation,
            boom: Body::slender(self.weights.g_b / gravity, self.inertia.j_b, centre, along),
            load: self.rest.fitted.rope.is_none().then(hangs),
            balance: balance.transpose().map_err(|fault| Fault::outside(fault.to_string()))?,
            gravity,
        })
    }

    fn level(&self, boom: &Arc<HeavyBoom<P>>) -> Level<P> {
        let load = (self.load / self.rest.constants.g).def(&m::MASS_Q);
        let pendulum = self.hoist.pendulum(load, self.rest.fitted.rope);
        let dynamics = Dynamics::new(boom.clone(), pendulum, self.rest.constants.g);
        self.rest.clone().level(dynamics)
    }
}

/// Each scalar has derivatives by the boom's angle in its own way.
struct BoomInMotion;

/// What the equations of motion have of the boom, over a scalar.
pub struct BoomEquations<P: Calc> {
    boom: fn(&BoomParts<P>) -> Result<HeavyBoom<P>, Fault>,
    level: fn(&BoomParts<P>, &Arc<HeavyBoom<P>>) -> Level<P>,
}

impl<P: Weighing<P> + Coordinate<P> + Send + Sync + 'static> BoomEquations<P>
where
    Dual64: Over<P>,
{
    fn new() -> BoomEquations<P> {
        BoomEquations {
            boom: BoomParts::boom,
            level: BoomParts::level,
        }
    }
}

impl EachScalar for BoomInMotion {
    type For<C: Calc> = BoomEquations<C>;
    fn plain() -> BoomEquations<f64> {
        BoomEquations::new()
    }
    fn dual() -> BoomEquations<Dual64> {
        BoomEquations::new()
    }
    fn recorded() -> BoomEquations<Rec> {
        BoomEquations::new()
    }
}

/// All that the boom in motion is made of.
#[expect(clippy::too_many_arguments, reason = "all that it is made of")]
pub fn parts<C: Calc>(
    rig: &Rig<C>,
    compensation: &Option<Compensation<C>>,
    load: &One<C>,
    weights: &Plain<C>,
    balance: &Option<Form<C>>,
    inertia: &BoomInertia<C>,
    constants: &Constants<C>,
    ramp: &Option<HoistRamp<C>>,
    give: &Option<RopeGive<C>>,
    choice: &BoomChoice,
    fitted: &Fitted,
    room: &mut Vec<BoomParts<C>>,
) {
    room.clear();
    room.push(BoomParts {
        rig: *rig,
        compensation: *compensation,
        load: load.1,
        weights: *weights,
        balance: *balance,
        inertia: *inertia,
        hoist: HoistParts {
            ramp: *ramp,
            motor: None,
            give: *give,
        },
        rest: LevelParts {
            range: choice.range,
            axis: -rig.x_8,
            constants: *constants,
            turning: None,
            cylinder: None,
            fitted: *fitted,
        },
        choice: *choice,
    });
}

/// The boom with what it weighs.
///
/// # Errors
/// Quantities with which there is no such balance.
pub fn boom<C: Scalar>(parts: &[BoomParts<C>], room: &mut Vec<Renewed<HeavyBoom<C>>>) -> Result<(), Fault> {
    Renewed::renew(room, (C::own::<BoomInMotion>().boom)(&parts[0])?);
    Ok(())
}

/// The equations of the level, nothing being asked of it.
pub fn built<C: Scalar>(parts: &[BoomParts<C>], boom: &[Renewed<HeavyBoom<C>>], room: &mut Vec<Level<C>>) {
    room.clear();
    room.push((C::own::<BoomInMotion>().level)(&parts[0], boom[0].now()));
}

/// Rates of angle and angular velocity of the boom.
#[derive(Clone, Copy, Debug)]
pub struct BoomRates<C>([C; 2]);
results! { BoomRates as r => { D_PHI: r.0[0]; D_OMEGA: r.0[1]; } }

/// With those of all other states.
pub static RATES: [&Symbol; 22] = rates_after::<2, 22>(*listed!(s: D_PHI, D_OMEGA));

impl<C: Calc> BoomRates<C> {
    pub fn new(moves: &CraneMoves<C>) -> BoomRates<C> {
        BoomRates(moves.bar())
    }
}
