//! A floating crane as a component: what it is given, and in which stages its equations follow from each other.

use crate::afloat::carrying::CraneAfloat;
use crate::afloat::crane::{CraneWeights, HungPoint, LuffingMotion, TurningMass, luffed};
use crate::afloat::driving::{DriveMoments, LuffingCommand, LuffingServo, luffing};
use crate::afloat::gust::{Gust, GustGiven};
use crate::afloat::head::HeadPlace;
use crate::afloat::holding::HeldAtRest;
use crate::afloat::hull::{BoxHull, Floating, FloodedSpace, Offsets};
use crate::afloat::levers::{RightingLever, ToldHeel, levers};
use crate::afloat::loaded::Loaded;
use crate::afloat::loss::{LoadLost, LossRule, residual};
use crate::afloat::openings::{AreaEnds, FloodedOpening, Opening, flooding};
use crate::afloat::posture::Posture;
use crate::afloat::riding::{BuoyedMass, HullMotion, RidingHull, WaterForces, WettedHull, clearing};
use crate::afloat::small::SmallAngles;
use crate::afloat::swaying::{RopedLoad, SlewingCommand, SlewingServo, Swaying, SwayingRates};
use crate::afloat::symbols as s;
use crate::afloat::upright::Upright;
use crate::afloat::weights::{CranePlace, DeadLoad, HullMass, HullTow, HullWind, TankGiven, WindageArea};
use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::{One, group};
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::luffed::{Luffed, LuffedRates, Luffer};

/// Given quantities that the scene makes inputs of.
#[derive(Clone, Debug)]
pub struct MadeInputs(pub Vec<&'static Symbol>);
group!(MadeInputs);

stages! {
    /// A crane on a hull.
    FloatingCrane over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter reach: Option<One<C>>,
        Parameter load: One<C>,
        Parameter place: CranePlace<C>,
        Parameter height: One<C>,
        Parameter turning: Vec<TurningMass<C>>,
        Parameter density: One<C>,
        Parameter built: Option<BoxHull<C>>,
        Parameter masses: Vec<HullMass<C>>,
        Parameter tanks: Vec<TankGiven<C>>,
        Parameter wind: Option<HullWind<C>>,
        Parameter areas: Vec<WindageArea<C>>,
        Parameter tow: Option<HullTow<C>>,
        Parameter flooded: Vec<FloodedSpace<C>>,
        Parameter heels: Vec<ToldHeel<C>>,
        Parameter openings: Vec<Opening<C>>,
        Parameter limit: Option<One<C>>,
        Parameter rule: Option<LossRule<C>>,
        Parameter gust: Option<GustGiven<C>>,
        Parameter gravity: One<C>,
        Parameter buoyed: Option<BuoyedMass<C>>,
        Parameter servo: Option<SlewingServo<C>>,
        Parameter luffing_servo: Option<LuffingServo<C>>,
        Input command: Option<SlewingCommand<C>>,
        Input luffing_command: Option<LuffingCommand<C>>,
        Input held: Option<One<C>>,
        State moved: Option<HullMotion<C>>,
        State roped: Option<RopedLoad<C>>,
        State luffing: Option<LuffingMotion<C>>,
        Fixed offsets: Option<Offsets>,
        Fixed luffer: Option<Luffer>,
        Fixed inputs: MadeInputs,
    } find {
        floating: Floating<C> = Floating::new(built, offsets, tanks, flooded, density, gravity) => _;
        dead: DeadLoad<C> = DeadLoad::new(masses, tanks, gravity, wind, areas, tow);
        luffed: Luffed<C> = luffed(luffer[!], held, luffing);
        luffed_rates: LuffedRates<C> = LuffedRates::new(luffed);
        hung: HungPoint<C> = HungPoint::new(reach, height, luffed[?]);
        crane: CraneWeights<C> = CraneWeights::new(psi, place, height, luffed, turning);
        loaded: Loaded<C> = Loaded::new(psi, dead, place, hung, load, crane[?]);
        upright: Upright<C> = Upright::new(floating, density, gravity, tanks, flooded, loaded);
        small: SmallAngles<C> = SmallAngles::new(loaded, upright);
        posture: Posture<C> = Posture::new(built, floating, psi, load, loaded, upright);
        holding: HeldAtRest<C> = HeldAtRest::new(psi, load, luffed, luffed_rates, crane, posture);
        levers[heels]: Vec<RightingLever<C>> = levers(floating, loaded, upright, heels);
        flooding[openings]: Vec<FloodedOpening<C>> = flooding(floating, loaded, posture, openings);
        ends: AreaEnds<C> = AreaEnds::new(limit[!], flooding) => _;
        residual: C = residual(floating, loaded, posture, ends) => A_RES;
        lost: LoadLost<C> = LoadLost::new(floating, loaded, posture, ends, rule[!]);
        struck: Gust<C> = Gust::new(floating, loaded, posture, ends, gust[!], wind[!], areas);
        riding: RidingHull<C> = RidingHull::new(moved[!], dead);
        wetted: WettedHull<C> = WettedHull::new(floating, riding);
        clear: C = clearing(floating, riding) => F_M;
        head: HeadPlace<C> = HeadPlace::new(riding, loaded, hung, psi);
        forces: WaterForces<C> = WaterForces::new(moved[!], buoyed[!], riding, dead, wetted, density, gravity);
        carrying: CraneAfloat<C> = CraneAfloat::new(
            psi, omega, place, height, luffed, luffing[!], turning, moved[!], riding, gravity) => _;
        luffs: C = luffing(luffing_servo[!], luffing_command[!], luffing[!]) => _;
        swaying: Swaying<C> = Swaying::new(
            moved[!], buoyed[!], roped[!], servo[!], command[!], riding, head, forces, dead, load, gravity, omega, luffs[?],
            carrying[?]);
        drives: DriveMoments<C> = DriveMoments::new(carrying, swaying, luffs);
        rates: SwayingRates<C> = SwayingRates::new(omega, moved[!], swaying, luffing, luffs[?]);
    }
}

impl Component for FloatingCrane {
    const STATES: [&'static [&'static Symbol]; 2] = [
        listed!(s: PSI_SL, OMEGA_SL),
        listed!(s:
            D_PSI_SL, D_OMEGA_SL, D_H_G, D_PHI_X, D_THETA_Y, D_V_G, D_OMEGA_X, D_OMEGA_Y, D_R_X, D_R_Y, D_R_Z, D_W_X, D_W_Y,
            D_W_Z, D_THETA_1, D_OMEGA_1
        ),
    ];

    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI_SL, w OMEGA_SL;
        head "Boom head, where the load hangs.": r R, z H_S, f Q;
        hull "Hull on the water.": heel PHI, trim THETA, draft T;
    };

    /// What wind, tow, tanks, flooded compartments, masses that slew and a luffing mechanism would give is no result without them.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let there = |of: &[&'static Symbol]| of.contains(&symbol);
        (given.wind.is_some() || !there(listed!(s: M_W)))
            && (given.tow.is_some() || !there(listed!(s: M_P)))
            && (!given.tanks.is_empty() || !there(listed!(s: GG, GG_L)))
            && (!given.flooded.is_empty() || !there(listed!(s: Y_B)))
            && (!given.turning.is_empty() || !there(listed!(s: M_ETA)))
            && (given.luffer.is_some() || !there(listed!(s: H_S)))
            && (given.luffing.is_some() || !there(listed!(s: D_THETA_1, D_OMEGA_1)))
    }

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.inputs.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        match known.given.moved {
            Some(_) => known.swaying().map(|_| ()),
            None => known.posture().map(|_| ()),
        }
    }
}
