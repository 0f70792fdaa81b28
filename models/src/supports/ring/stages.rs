//! A slewing ring as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::component::whole::Whole;
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::load_curve::LoadCurve;
use crate::parts::motor::{CaseBrake, CaseHold};
use crate::supports::drive;
use crate::supports::drive::brake::{Coupled, TurningHold, TurningStop};
use crate::supports::drive::given::{RingPinion, TurnedArea, TurningCase, TurningChoice, TurningDrive};
use crate::supports::drive::inertia::{Outswing, TurnedWorks};
use crate::supports::drive::motor::{TurningHeat, TurningMotor};
use crate::supports::drive::pinion::{PinionForce, meshed};
use crate::supports::drive::resistance::TurningMoments;
use crate::supports::plan::LeftOpen;
use crate::supports::ring::capacity::{Equivalent, StaticLoad, static_loads};
use crate::supports::ring::contact::{ContactStress, Hardness, RollingContact};
use crate::supports::ring::elements::{AllCases, MomentAlone, Raceway, RollingForces, spreads};
use crate::supports::ring::friction::{ElementFriction, MakerForm, MakerFriction, by_elements, by_maker, rubbing};
use crate::supports::ring::law::RollingElements;
use crate::supports::ring::symbols as s;
use crate::supports::upper;
use crate::supports::upper::load::{SupportCase, SupportLoad, WorstLoad};
use crate::supports::upper::weights::{UpperArea, UpperSlope, UpperWeight, UpperWorks};

stages! {
    /// A slewing ring under a crane.
    SlewingRing over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter reach: One<C>,
        Parameter load: One<C>,
        Parameter raceway: Raceway<C>,
        Parameter bodies: Vec<UpperWeight<C>>,
        Parameter areas: Vec<UpperArea<C>>,
        Parameter slope: Option<UpperSlope<C>>,
        Parameter cases: Vec<SupportCase<C>>,
        Parameter contact: Option<RollingContact<C>>,
        Parameter length: Option<One<C>>,
        Parameter equivalent: Option<Equivalent<C>>,
        Parameter friction: Option<ElementFriction<C>>,
        Parameter maker: Option<MakerFriction<C>>,
        Fixed rolling: RollingElements,
        Fixed curve: LoadCurve,
        Fixed form: MakerForm,
        Parameter gravity: Option<One<C>>,
        Parameter drive: Option<TurningDrive<C>>,
        Parameter rope: Option<One<C>>,
        Parameter works: Vec<TurningCase<C>>,
        Parameter places: Vec<TurnedArea<C>>,
        Parameter holds: Vec<CaseHold<C>>,
        Parameter brake: Option<CaseBrake<C>>,
        Parameter limit: Option<One<C>>,
        Parameter pinion: Option<RingPinion<C>>,
        Fixed turns: TurningChoice,
        Fixed open: LeftOpen,
    } find {
        alone: MomentAlone<C> = MomentAlone::new(rolling);
        upper: UpperWorks<C> = UpperWorks::new(bodies, slope, areas);
        loads[each cases]: Vec<SupportLoad<C>> = SupportLoad::new(psi, reach, load, slope, upper, cases[each]);
        spreads[cases]: Vec<RollingForces<C>> = spreads(psi, raceway, rolling, loads);
        worst: WorstLoad<C> = WorstLoad::new(loads);
        all: AllCases<C> = AllCases::new(spreads);
        hardness: Hardness<C> = Hardness::new(contact[!]);
        stresses[each cases]: Vec<ContactStress<C>> =
            ContactStress::new(contact[!], length, hardness, spreads[each]);
        statics[cases]: Vec<StaticLoad<C>> = static_loads(curve, equivalent[!], loads);
        turning[each cases]: Vec<C> = by_elements(raceway, friction[!], spreads[each]) => M_FN;
        makers[each cases]: Vec<C> = by_maker(raceway, form, maker[!], loads[each]) => M_FM;
        works_turned: TurnedWorks<C> = TurnedWorks::new(drive[!], gravity[!], bodies, areas, places);
        swung[each works]: Vec<Outswing<C>> = Outswing::new(reach, gravity[!], rope, works[each]);
        rubbing[works]: Vec<C> = rubbing(drive[!], turning[?], makers[?]) => M_FS;
        turned[each works]: Vec<TurningMoments<C>> = TurningMoments::new(
            psi, reach, gravity[!], slope, upper, works_turned, cases[each], loads[each], works[each], swung[each],
            rubbing[each]);
        motors[each works]: Vec<TurningMotor<C>> = TurningMotor::new(drive[!], works[each], turned[each], swung[each]);
        heat: TurningHeat<C> = TurningHeat::new(drive[!], turns, swung, motors);
        holding[each holds]: Vec<TurningHold<C>> = TurningHold::new(drive[!], brake[!], holds[each], turned[each]);
        stopping[each works]: Vec<TurningStop<C>> =
            TurningStop::new(drive[!], brake[!], turned[each], swung[each], motors[each]);
        coupled[each works]: Vec<Coupled<C>> =
            Coupled::new(drive[!], brake[!], limit[!], motors[each], stopping[each]);
        meshed: C = meshed(pinion[!], turns) => RHO_C;
        pinions[each works]: Vec<PinionForce<C>> =
            PinionForce::new(drive[!], pinion[!], meshed, turned[each], motors[each]);
    }
}

impl Component for SlewingRing {
    const WHOLE: &'static [Whole] = &drive::outline::WHOLE;

    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_LIFT);

    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI, w OMEGA;
        head "Boom head, where the load hangs.": r R, f Q;
        ring "The ring in a load case.": fz V, fr H, tau M;
    };

    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let standing = [given.slope.is_some(), !given.areas.is_empty()];
        let turning = [given.drive.is_some(), given.rope.is_some()];
        upper::keys::has(symbol, standing) && drive::has(symbol, standing, turning)
    }

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.spreads().map(|_| ())
    }
}
