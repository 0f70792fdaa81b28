//! A crane on a portal as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::luffed::{Luffed, Luffer, reach};
use crate::parts::plane::Point;
use crate::supports::plan::{LeftOpen, heading};
use crate::supports::portal::circle::Circle;
use crate::supports::portal::corners::{LiftedLeg, Lowest, four_legs, hinged, rigid};
use crate::supports::portal::load::{Base, PortalMoments, SlewingLoad};
use crate::supports::portal::symbols as s;
use crate::supports::portal::tipping::{Edge, edges};
use crate::supports::portal::travel::given::{CornerDrive, PortalMotors, PortalStorm, PortalTravel, PortalWheels};
use crate::supports::portal::travel::grip::{WheelForces, WheelGrip};
use crate::supports::portal::travel::motor::TravelMotor;
use crate::supports::portal::travel::resistance::{PortalResistance, TravelWind, rolling};
use crate::supports::portal::travel::stop::PortalStop;
use crate::supports::portal::travel::storm::{StormEdge, StormForces};
use crate::supports::portal::weights::{
    Blowing, HopperWeight, PortalBody, PortalHopper, SlewingBody, StillMoment, WindArea, upper_moment,
};
use crate::supports::portal::wheels::{CornerLoad, CornerWheels, Hinged, Sideways, top};

stages! {
    /// A crane on a portal.
    PortalCrane over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter reach: Option<One<C>>,
        Parameter load: One<C>,
        Parameter base: Base<C>,
        Parameter corners: Vec<CornerWheels<C>>,
        Parameter portal: Vec<PortalBody<C>>,
        Parameter upper: Vec<SlewingBody<C>>,
        Parameter wind: Option<Blowing<C>>,
        Parameter areas: Vec<WindArea<C>>,
        Parameter hopper: Option<PortalHopper<C>>,
        Parameter sideways: Sideways<C>,
        Parameter gravity: Option<One<C>>,
        Parameter wheels: Option<PortalWheels<C>>,
        Parameter travel: Option<PortalTravel<C>>,
        Parameter motors: Option<PortalMotors<C>>,
        Parameter driven: Vec<CornerDrive<C>>,
        Parameter storm: Option<PortalStorm<C>>,
        Input held: Option<One<C>>,
        Fixed luffer: Option<Luffer>,
        Fixed kind: Hinged,
        Fixed open: LeftOpen,
    } find {
        luffed: Luffed<C> = Luffed::held(luffer[!], held);
        out: C = reach(reach, luffed[?]) => _;
        filled: HopperWeight<C> = HopperWeight::new(hopper[!]);
        still: StillMoment<C> = StillMoment::new(portal, upper, wind, areas, luffed[?], filled[?]);
        own: C = upper_moment(upper, luffed[?]) => M_U;
        slewing: SlewingLoad<C> = SlewingLoad::new(still, own, load, out);
        circle: Circle<C> = Circle::new(base, still, slewing);
        heading: Point<C> = heading(psi) => _;
        moments: PortalMoments<C> = PortalMoments::new(still, slewing, heading);
        four[corners]: Vec<C> = four_legs(base, slewing, moments) => N_4;
        lowest: Lowest<C> = Lowest::new(slewing, four);
        bearing: LiftedLeg<C> = LiftedLeg::new(base, psi, load, slewing, moments, four, lowest);
        rigid[corners]: Vec<C> = rigid(base, slewing, moments, four, bearing) => N_R;
        hinged[corners]: Vec<C> = hinged(base, slewing, moments, bearing) => N_H;
        loads[each corners]: Vec<CornerLoad<C>> =
            CornerLoad::new(kind, sideways, corners[each], rigid[each], hinged[each]);
        top: C = top(loads) => N_TOP;
        edges[corners]: Vec<Edge<C>> = edges(base, still, own, load, out, heading);
        rolling: C = rolling(wheels[!]) => W;
        blown: TravelWind<C> = TravelWind::new(travel[!], wind[!], areas);
        resisting: PortalResistance<C> =
            PortalResistance::new(gravity[!], wheels[!], travel[!], slewing, rolling, blown[?]);
        driving: TravelMotor<C> = TravelMotor::new(wheels[!], travel[!], motors[!], resisting);
        stopping: PortalStop<C> = PortalStop::new(gravity[!], travel[!], slewing, resisting, driving);
        pushing: WheelForces<C> = WheelForces::new(driven, resisting, stopping);
        grips[each driven]: Vec<WheelGrip<C>> = WheelGrip::new(travel[!], driven[each], pushing, loads[each]);
        storming: StormForces<C> = StormForces::new(travel[!], storm[!], areas, still, rolling, blown);
        tied[each corners]: Vec<StormEdge<C>> = StormEdge::new(travel[!], storming, edges[each]);
    }
}

impl Component for PortalCrane {
    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_LIFT);

    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI, w OMEGA;
        head "Boom head, where the load hangs.": r R, f Q;
        corner "A corner of the portal on its rail.": f N;
    };

    /// What is given is no result, and without wind there are no moments of it.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let blown: &[&Symbol] = listed!(s: M_W, M_WX, M_WY);
        given.wind.is_some() || !blown.contains(&symbol)
    }

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.moments().map(|_| ())
    }
}
