//! The mechanism in motion as stages: its bodies, its level, its own rates and forces.

use std::sync::Arc;

use num_dual::Dual64;

use crate::component::outline::joined;
use crate::component::scalar::{EachScalar, Scalar};
use crate::component::stages::{Found, Rows};
use crate::drive::hauling::Pushes;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::One;
use crate::kernel::record::Rec;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::luffing::double_link::forces_in_motion::{ForcesInMotion, RESULTS};
use crate::luffing::double_link::held::in_line;
use crate::luffing::double_link::linkage::HeavyLinkage;
use crate::luffing::double_link::moving::built::{CraneParts, Inertias};
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::parameters::{Choice, Parameters};
use crate::luffing::double_link::pose::Posing;
use crate::luffing::double_link::resisting::OfLink;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::moving::built::Outfit;
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::exposed::Exposed;
use crate::luffing::moving::geared::Geared;
use crate::luffing::moving::given::{Constants, Fitted, SlewedParts};
use crate::luffing::moving::hoisting::{HoistFalls, HoistMotor, HoistRamp, RopeGive};
use crate::luffing::moving::level::{CraneAt, Level};
use crate::luffing::moving::listed::rates_after;
use crate::luffing::moving::reduced::Renewed;
use crate::luffing::moving::stages::{CraneMoves, CraneRates, RATES as CRANE_RATES, open, present};
use crate::parts::air::AirAround;
use crate::parts::ground::GroundBelow;
use crate::parts::hydraulics::cylinder::Cylinder;

type Levelling<P> = fn(&CraneParts<P>, &Arc<HeavyLinkage<P>>, Outfit<P>) -> Level<P>;

type ForcesOf<P> = fn(&Level<P>, &HeavyLinkage<P>, &CraneAt<P>) -> Option<ForcesInMotion<P>>;

/// What the equations of motion have of this mechanism, over a scalar.
pub struct LinkEquations<P: Calc> {
    linkage: fn(&CraneParts<P>) -> Result<HeavyLinkage<P>, Fault>,
    level: Levelling<P>,
    forces: ForcesOf<P>,
}

impl<P: Posing<P> + Coordinate<P> + Send + Sync + 'static> LinkEquations<P>
where
    Dual64: Over<P>,
{
    fn new() -> LinkEquations<P> {
        LinkEquations {
            linkage: |parts| parts.linkage(),
            level: CraneParts::level,
            forces: ForcesInMotion::of,
        }
    }
}

/// Each scalar has derivatives by the driven angle in its own way.
struct LinkInMotion;

impl EachScalar for LinkInMotion {
    type For<C: Calc> = LinkEquations<C>;
    fn plain() -> LinkEquations<f64> {
        LinkEquations::new()
    }
    fn dual() -> LinkEquations<Dual64> {
        LinkEquations::new()
    }
    fn recorded() -> LinkEquations<Rec> {
        LinkEquations::new()
    }
}

/// All that the crane is made of.
#[expect(clippy::too_many_arguments, reason = "all that it is made of")]
pub fn parts<C: Scalar>(
    parameters: &Parameters<C>,
    reeved: Option<&Reeved<C>>,
    load: &One<C>,
    inertias: &Inertias<C>,
    constants: &Constants<C>,
    ramp: &Option<HoistRamp<C>>,
    motor: &Option<HoistMotor<C>>,
    hoist_falls: &Option<HoistFalls<C>>,
    give: &Option<RopeGive<C>>,
    around: &Option<AirAround<C>>,
    ground: &Option<GroundBelow<C>>,
    slewed: &Option<SlewedParts<C>>,
    fitted: &Fitted,
    choice: &Choice,
    room: &mut Vec<CraneParts<C>>,
) {
    room.clear();
    room.push(CraneParts {
        parameters: *parameters,
        range: choice.range,
        load: *load,
        inertias: *inertias,
        reeved: reeved.copied(),
        constants: *constants,
        ramp: *ramp,
        motor: *motor,
        hoist_falls: *hoist_falls,
        give: *give,
        around: *around,
        ground: *ground,
        slewed: *slewed,
        fitted: *fitted,
    });
}

/// The mechanism with its bodies.
pub fn linkage<C: Scalar>(parts: &[CraneParts<C>], room: &mut Vec<Renewed<HeavyLinkage<C>>>) -> Result<(), Fault> {
    Renewed::renew(room, (C::own::<LinkInMotion>().linkage)(&parts[0])?);
    Ok(())
}

/// The equations of the level, nothing being asked of it.
pub fn built<C: Scalar>(
    parts: &[CraneParts<C>],
    linkage: &[Renewed<HeavyLinkage<C>>],
    geared: &[Renewed<Geared<C>>],
    cylinder: Option<&Cylinder<C>>,
    exposed: &[Renewed<Exposed<OfLink, C>>],
    room: &mut Vec<Level<C>>,
) {
    let fittings = Outfit::new(geared, cylinder, exposed);
    room.clear();
    room.push((C::own::<LinkInMotion>().level)(&parts[0], linkage[0].now(), fittings));
}

/// Rates of angle and rate of the driven bar, boom or rocker, then those of all other states.
#[derive(Clone, Copy, Debug)]
pub struct LinkRates<C>([C; 2], CraneRates<C>);

const LINK_RATES: [&Symbol; 4] = *listed!(s: D_THETA_1, D_OMEGA_1, D_THETA_3, D_OMEGA_3);

/// With those of all other states, and of controllers.
pub const RATES: [&Symbol; 32] = rates_after(&LINK_RATES);

impl<C: Calc> Rows<C> for LinkRates<C> {
    const ROWS: &'static [&'static Symbol] = &joined::<_, 4, 22, 26>(LINK_RATES, CRANE_RATES);
    fn row(&self, row: u8, of: u16) -> Found<C> {
        match row.checked_sub(LINK_RATES.len() as u8) {
            None => Ok(self.0[usize::from(row % 2)]),
            Some(other) => self.1.row(other, of),
        }
    }
}

impl<C: Calc> LinkRates<C> {
    pub fn new(moves: &CraneMoves<C>, fitted: &Fitted) -> LinkRates<C> {
        LinkRates(moves.bar(), CraneRates::new(moves, fitted))
    }
}

/// Forces of the motion, with the angle of the driving link.
#[derive(Clone, Copy, Debug)]
pub struct CraneForces<C>(pub ForcesInMotion<C>, One<C>);

impl<C: Calc> Rows<C> for CraneForces<C> {
    const ROWS: &'static [&'static Symbol] = &RESULTS;
    fn row(&self, row: u8, _: u16) -> Found<C> {
        let found = self.0.results()[usize::from(row)];
        found.ok_or_else(|| Box::new(in_line(self.1.0, self.1.1.value())))
    }
}

impl<C: Copy> Pushes<C> for CraneForces<C> {
    fn f_d(&self) -> Option<C> {
        self.0.f_d
    }
}

pub fn forces<C: Scalar>(
    linkage: &[Renewed<HeavyLinkage<C>>],
    built: &[Level<C>],
    told: &[Level<C>],
    at: &CraneAt<C>,
    theta: &One<C>,
) -> Result<CraneForces<C>, Fault> {
    let found = (C::own::<LinkInMotion>().forces)(present(built, told), linkage[0].now(), at);
    Ok(CraneForces(found.ok_or_else(|| open(theta))?, *theta))
}
