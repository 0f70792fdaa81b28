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
use crate::luffing::ellipsograph::moving::{GuidedInertias, HeavyGuide};
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice};
use crate::luffing::ellipsograph::statics::GuidedWeights;
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::moving::bodies::Pendulum;
use crate::luffing::moving::built::{HoistParts, LevelParts};
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::given::{Constants, Fitted};
use crate::luffing::moving::hoisting::{HoistMotor, HoistRamp, RopeGive};
use crate::luffing::moving::level::Level;
use crate::luffing::moving::reduced::Renewed;
use crate::luffing::moving::stages::{CraneMoves, rates_after};
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::weighed::Weighing;

/// What the boom in motion is made of.
#[derive(Clone)]
pub struct GuideParts<C: Calc> {
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
    fn pendulum(&self) -> Option<Pendulum<P>> {
        let rope = self.rest.fitted.rope?;
        let load = (self.load / self.rest.constants.g).def(&m::MASS_Q);
        self.hoist.pendulum(load, Some(rope))
    }

    fn guide(&self) -> Result<HeavyGuide<P>, Fault> {
        let gravity = self.rest.constants.g;
        let fixed = self.rest.fitted.rope.is_none().then(|| self.load / gravity);
        HeavyGuide::new(
            &self.bars,
            &self.weights,
            &self.inertias,
            &self.balance,
            &self.choice,
            fixed.map(|load| load.def(&m::MASS_Q)),
            gravity,
        )
        .map_err(|fault| Fault::outside(fault.to_string()))
    }

    fn level(&self, guide: &Arc<HeavyGuide<P>>) -> Level<P> {
        let dynamics = Dynamics::new(guide.clone(), self.pendulum(), self.rest.constants.g);
        self.rest.clone().level(dynamics)
    }
}

/// Each scalar has derivatives by the boom's angle in its own way.
struct GuideInMotion;

/// What the equations of motion have of boom and link, over a scalar.
pub struct GuideEquations<P: Calc> {
    guide: fn(&GuideParts<P>) -> Result<HeavyGuide<P>, Fault>,
    level: fn(&GuideParts<P>, &Arc<HeavyGuide<P>>) -> Level<P>,
}

impl<P: Weighing<P> + Coordinate<P> + Send + Sync + 'static> GuideEquations<P>
where
    Dual64: Over<P>,
{
    fn new() -> GuideEquations<P> {
        GuideEquations {
            guide: GuideParts::guide,
            level: GuideParts::level,
        }
    }
}

impl EachScalar for GuideInMotion {
    type For<C: Calc> = GuideEquations<C>;
    fn plain() -> GuideEquations<f64> {
        GuideEquations::new()
    }
    fn dual() -> GuideEquations<Dual64> {
        GuideEquations::new()
    }
    fn recorded() -> GuideEquations<Rec> {
        GuideEquations::new()
    }
}

/// All that the boom in motion is made of.
#[expect(clippy::too_many_arguments, reason = "all that it is made of")]
pub fn parts<C: Calc>(
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
    room: &mut Vec<GuideParts<C>>,
) {
    room.clear();
    room.push(GuideParts {
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
    });
}

/// Boom and link with what they weigh.
///
/// # Errors
/// Quantities with which there is no such balance.
pub fn guide<C: Scalar>(parts: &[GuideParts<C>], room: &mut Vec<Renewed<HeavyGuide<C>>>) -> Result<(), Fault> {
    Renewed::renew(room, (C::own::<GuideInMotion>().guide)(&parts[0])?);
    Ok(())
}

/// The equations of the level, nothing being asked of it.
pub fn built<C: Scalar>(parts: &[GuideParts<C>], guide: &[Renewed<HeavyGuide<C>>], room: &mut Vec<Level<C>>) {
    room.clear();
    room.push((C::own::<GuideInMotion>().level)(&parts[0], guide[0].now()));
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
