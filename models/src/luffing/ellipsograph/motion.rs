//! The boom in motion as stages: its level, its own rates.

use std::sync::Arc;

use num_dual::Dual64;

use crate::balance::scene::Form;
use crate::component::scalar::{EachScalar, Scalar};
use crate::component::stages::results;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::One;
use crate::kernel::record::Rec;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::luffing::ellipsograph::link_balance::Weighing;
use crate::luffing::ellipsograph::moving::{GuidedInertias, HeavyGuide};
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice};
use crate::luffing::ellipsograph::statics::GuidedWeights;
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::moving::built::{HoistParts, LevelParts};
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::given::{Constants, Fitted};
use crate::luffing::moving::hoisting::{HoistMotor, HoistRamp, RopeGive};
use crate::luffing::moving::level::Level;
use crate::luffing::moving::stages::{CraneMoves, rates_after};
use crate::luffing::moving::symbols as m;

/// What the boom in motion is made of.
struct GuideParts<C: Calc> {
    bars: Bars<C>,
    load: C,
    weights: GuidedWeights<C>,
    balance: Option<Form<C>>,
    inertias: GuidedInertias<C>,
    hoist: HoistParts<C>,
    rest: LevelParts<C>,
    choice: GuidedChoice,
}

impl<P: Weighing<P> + Coordinate<P> + Send + Sync + 'static> GuideParts<P>
where
    Dual64: Over<P>,
{
    fn level(self) -> Result<Level<P>, Fault> {
        let gravity = self.rest.constants.g;
        let load = (self.load / gravity).def(&m::MASS_Q);
        let pendulum = self.hoist.pendulum(load, self.rest.fitted.rope);
        let guide = HeavyGuide::new(
            &self.bars,
            &self.weights,
            &self.inertias,
            &self.balance,
            &self.choice,
            pendulum.is_none().then_some(load),
            gravity,
        )
        .map_err(|fault| Fault::outside(fault.to_string()))?;
        Ok(self.rest.level(Dynamics::new(Arc::new(guide), pendulum, gravity)))
    }
}

/// Each scalar has derivatives by the boom's angle in its own way.
struct GuideInMotion;

/// The equations of a level over a scalar.
pub struct GuideLevel<P: Calc>(fn(GuideParts<P>) -> Result<Level<P>, Fault>);

impl EachScalar for GuideInMotion {
    type For<C: Calc> = GuideLevel<C>;
    fn plain() -> GuideLevel<f64> {
        GuideLevel(GuideParts::level)
    }
    fn dual() -> GuideLevel<Dual64> {
        GuideLevel(GuideParts::level)
    }
    fn recorded() -> GuideLevel<Rec> {
        GuideLevel(GuideParts::level)
    }
}

/// The equations of the level, nothing being asked of it.
#[expect(clippy::too_many_arguments, reason = "all that it is made of")]
pub fn built<C: Scalar>(
    bars: &Bars<C>,
    load: &One<C>,
    weights: &GuidedWeights<C>,
    balance: &Option<Form<C>>,
    inertias: &GuidedInertias<C>,
    constants: &Constants<C>,
    ramp: &Option<HoistRamp<C>>,
    motor: &Option<HoistMotor<C>>,
    give: &Option<RopeGive<C>>,
    choice: &GuidedChoice,
    fitted: &Fitted,
    room: &mut Vec<Level<C>>,
) -> Result<(), Fault> {
    let parts = GuideParts {
        bars: *bars,
        load: load.1,
        weights: *weights,
        balance: *balance,
        inertias: *inertias,
        hoist: HoistParts {
            ramp: *ramp,
            motor: *motor,
            give: *give,
        },
        rest: LevelParts {
            range: choice.range,
            axis: -bars.x_8,
            constants: *constants,
            turning: None,
            cylinder: None,
            fitted: *fitted,
        },
        choice: *choice,
    };
    room.clear();
    room.push((C::own::<GuideInMotion>().0)(parts)?);
    Ok(())
}

/// Rates of angle and angular velocity of the boom.
#[derive(Clone, Copy, Debug)]
pub struct GuideRates<C>([C; 2]);
results! { GuideRates as r => { D_PHI: r.0[0]; D_OMEGA: r.0[1]; } }

/// With those of all other states.
pub static RATES: [&Symbol; 22] = rates_after::<2, 22>(*listed!(s: D_PHI, D_OMEGA));

impl<C: Calc> GuideRates<C> {
    pub fn new(moves: &CraneMoves<C>) -> GuideRates<C> {
        GuideRates(moves.bar())
    }
}
