//! A luffing mechanism as a component that may move by itself.

use crate::component::part::Component;
use crate::component::stages::Found;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::moving::control::ByAxis;
use crate::luffing::moving::control::continuous::Laws;
use crate::luffing::moving::given::{Constants, CraneStates, CylinderOil, Fitted, Inputs, Meets, Slack, SlewedParts};
use crate::luffing::moving::hoisting::{HoistFalls, HoistMotor, HoistRamp, RopeGive};
use crate::luffing::moving::hydraulic::Modes;
use crate::luffing::moving::level::{CraneAt, Level};
use crate::luffing::resistances::given::{CaseBrake, SecondBrake};
use crate::parts::air::AirAround;
use crate::parts::control::continuous::{Regime, Regulating};
use crate::parts::control::{Latched, SpeedControl};
use crate::parts::ground::GroundBelow;
use crate::parts::hydraulics::parts::OilParts;
use crate::parts::motion::Motion;

/// What a mechanism has in motion besides what it has at rest: none of it where it stands still.
#[derive(Clone, Copy, Debug)]
pub struct MotionSources<C: Calc = f64> {
    pub states: Option<CraneStates<C>>,
    pub inputs: Option<Inputs<C>>,
    pub constants: Option<Constants<C>>,
    pub ramp: Option<HoistRamp<C>>,
    pub motor: Option<HoistMotor<C>>,
    pub hoist_falls: Option<HoistFalls<C>>,
    pub give: Option<RopeGive<C>>,
    pub around: Option<AirAround<C>>,
    pub ground: Option<GroundBelow<C>>,
    pub slewed: Option<SlewedParts<C>>,
    pub oil: Option<CylinderOil<C>>,
    pub oil_parts: Option<OilParts<C>>,
    pub control: Option<ByAxis<SpeedControl<C>>>,
    pub commanded: Option<ByAxis<One<C>>>,
    pub latched: Option<ByAxis<Latched<C>>>,
    pub regulating: Option<ByAxis<Regulating<C>>>,
    pub regime: Option<ByAxis<Regime<C>>>,
    pub wound: Option<One<C>>,
    pub past: Option<Modes>,
    /// Of a rope that drives luffing.
    pub slack: Option<Slack>,
    pub fitted: Fitted,
}

impl MotionSources {
    pub const NONE: MotionSources = MotionSources {
        states: None,
        inputs: None,
        constants: None,
        ramp: None,
        motor: None,
        hoist_falls: None,
        give: None,
        around: None,
        ground: None,
        slewed: None,
        oil: None,
        oil_parts: None,
        control: None,
        commanded: None,
        latched: None,
        regulating: None,
        regime: None,
        wound: None,
        past: None,
        slack: None,
        fitted: Fitted {
            rope: None,
            slewing: None,
            oil: false,
            braked: false,
            hauled: false,
            meets: Meets::NOTHING,
        },
    };
}

/// What is given of a mechanism that luffs.
#[derive(Clone, Copy, Debug)]
pub struct LuffingGiven {
    /// Angle and angular velocity of the driven bar.
    pub theta: One<f64>,
    pub omega: One<f64>,
    pub load: Option<One<f64>>,
    pub range: Motion,
    pub brake: Option<CaseBrake<f64>>,
    pub second: Option<SecondBrake<f64>>,
    pub sources: MotionSources,
}

/// A luffing mechanism that may move by itself: the macro `luffs!` implements it.
pub trait Luffs: Component {
    /// Whether a rope luffs it, which gives no force below zero.
    const PULLED: bool;

    fn luffing(given: &Self::Given<f64>) -> LuffingGiven;

    /// With angle and angular velocity of the driven bar and other sources of its motion.
    fn with(given: &Self::Given<f64>, at: [f64; 2], sources: MotionSources) -> Self::Given<f64>;

    /// The crane as it is.
    ///
    /// # Errors
    /// None where all that it is made of is given.
    fn now(known: &mut Self::Known<f64>) -> Found<CraneAt>;

    /// The same with its equations under present inputs.
    ///
    /// # Errors
    /// Quantities with which there are none.
    fn in_motion(known: &mut Self::Known<f64>) -> Found<(&Level, CraneAt)>;

    /// Whether it holds together as its equations take for granted.
    ///
    /// # Errors
    /// What does not, where its motion ends.
    fn holds(_: &mut Self::Known<f64>) -> Found<()> {
        Ok(())
    }

    /// Puts angle and angular velocity of the driven bar, the other states, and what happened before.
    fn put_now(known: &mut Self::Known<f64>, at: [f64; 2], states: CraneStates<f64>, past: Modes);

    /// Puts what controllers hold.
    fn put_held(known: &mut Self::Known<f64>, held: ByAxis<Latched>);

    /// Puts where continuous controllers are.
    fn put_laws(known: &mut Self::Known<f64>, laws: Laws);

    /// Puts states and what happened before, the driven bar as it is.
    fn put_past(known: &mut Self::Known<f64>, states: CraneStates<f64>, past: Modes);
}

/// Implements [`Luffs`] beside the stages of a component, whose groups have the names of [`MotionSources`]: its coordinate
/// and rate are named, what it has besides those that every one has, what it keeps of a rope that drives it, and what looks
/// whether it holds together.
macro_rules! luffs {
    ($component:ident by $theta:ident, $omega:ident $(with $($more:ident),+)? $(on $slack:ident)? $(holds $holds:ident)?) => {
        impl $crate::luffing::moving::luffs::Luffs for $component {
            const PULLED: bool = {
                let on: &[&str] = &[$(stringify!($slack))?];
                !on.is_empty()
            };

            #[allow(clippy::needless_update, reason = "some have all that there is")]
            fn luffing(given: &Given<f64>) -> $crate::luffing::moving::luffs::LuffingGiven {
                $crate::luffing::moving::luffs::LuffingGiven {
                    theta: given.$theta,
                    omega: given.$omega,
                    load: given.load,
                    range: given.choice.range,
                    brake: given.brake,
                    second: given.second,
                    sources: $crate::luffing::moving::luffs::MotionSources {
                        states: given.states,
                        inputs: given.inputs,
                        constants: given.constants,
                        ramp: given.ramp,
                        motor: given.motor,
                        give: given.give,
                        around: given.around,
                        ground: given.ground,
                        slewed: given.slewed,
                        control: given.control,
                        commanded: given.commanded,
                        latched: given.latched,
                        regulating: given.regulating,
                        regime: given.regime,
                        wound: given.wound,
                        past: given.past,
                        fitted: given.fitted,
                        $($($more: given.$more,)+)?
                        $($slack: given.$slack,)?
                        ..$crate::luffing::moving::luffs::MotionSources::NONE
                    },
                }
            }

            fn with(
                given: &Given<f64>,
                [theta, omega]: [f64; 2],
                sources: $crate::luffing::moving::luffs::MotionSources,
            ) -> Given<f64> {
                let $crate::luffing::moving::luffs::MotionSources {
                    states,
                    inputs,
                    constants,
                    ramp,
                    motor,
                    give,
                    around,
                    ground,
                    slewed,
                    control,
                    commanded,
                    latched,
                    regulating,
                    regime,
                    wound,
                    past,
                    fitted,
                    $($($more,)+)?
                    $($slack,)?
                    ..
                } = sources;
                Given {
                    $theta: One(given.$theta.0, theta),
                    $omega: One(given.$omega.0, omega),
                    states,
                    inputs,
                    constants,
                    ramp,
                    motor,
                    give,
                    around,
                    ground,
                    slewed,
                    control,
                    commanded,
                    latched,
                    regulating,
                    regime,
                    wound,
                    past,
                    fitted,
                    $($($more,)+)?
                    $($slack,)?
                    ..given.clone()
                }
            }

            fn now(known: &mut Known<f64>) -> Found<CraneAt> {
                known.at().copied()
            }

            fn in_motion(known: &mut Known<f64>) -> Found<(&Level, CraneAt)> {
                known.told()?;
                let at = *known.at()?;
                let level = known.built.as_deref().zip(known.told.as_deref());
                let (built, told) = level.expect("just made");
                Ok(($crate::luffing::moving::stages::present(built, told), at))
            }

            $(fn holds(known: &mut Known<f64>) -> Found<()> {
                $holds(known)
            })?

            fn put_now(
                known: &mut Known<f64>,
                at: [f64; 2],
                states: $crate::luffing::moving::given::CraneStates<f64>,
                past: $crate::luffing::moving::hydraulic::Modes,
            ) {
                let wound = known.given.wound;
                (known.$theta().1, known.$omega().1) = (at[0], at[1]);
                $(*known.$slack() = Some($crate::luffing::moving::given::Slack(past.slack));)?
                (*known.past(), *known.states()) = (Some(past), Some(states));
                if let Some(rate) = wound {
                    *known.wound() = Some(One(rate.0, states.0[$crate::luffing::moving::given::V_R]));
                }
            }

            fn put_held(
                known: &mut Known<f64>,
                held: $crate::luffing::moving::control::ByAxis<$crate::parts::control::Latched>,
            ) {
                *known.latched() = Some(held);
            }

            fn put_laws(
                known: &mut Known<f64>,
                laws: $crate::luffing::moving::control::continuous::Laws,
            ) {
                (*known.regulating(), *known.regime()) = (Some(laws.states), Some(laws.past));
            }

            fn put_past(
                known: &mut Known<f64>,
                states: $crate::luffing::moving::given::CraneStates<f64>,
                past: $crate::luffing::moving::hydraulic::Modes,
            ) {
                $(*known.$slack() = Some($crate::luffing::moving::given::Slack(past.slack));)?
                (*known.past(), *known.states()) = (Some(past), Some(states));
            }
        }
    };
}
pub(crate) use luffs;
