//! The trolley of a container bridge as a component: what it is given, in which stages its equations follow from each other,
//! how it moves.

use crate::bridge::brakes::{TrolleyBrakes, TrolleyBraking, holds};
use crate::bridge::given::{BridgeTrolley, DrivenWheels, PassedSheaves, SheaveCount, TrolleyCommand};
use crate::bridge::listing::Listing;
use crate::bridge::profiles::{CycleTime, Profiles, TravelProfile};
use crate::bridge::slung::{LoadSlings, Slung};
use crate::bridge::suspension::{FourRopes, RopesLength, Skew, Suspended};
use crate::bridge::swing::{DriveInMotion, Travelling, answer, damped, length, swung, travelling};
use crate::bridge::symbols as s;
use crate::bridge::tow::{TowRope, TowRun};
use crate::bridge::trolley::{BridgePowers, Grip, RailLoads, TravelForces, carried, sheaves};
use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::sway::pendulum::{Damped, Feedback, SwayingLoad, Swung};

stages! {
    /// The trolley of a container bridge.
    ContainerBridge over C from {
        Coordinate place: One<C>,
        Rate speed: One<C>,
        Input command: TrolleyCommand<C>,
        Parameter unit: BridgeTrolley<C>,
        Parameter gravity: One<C>,
        Parameter over: Option<PassedSheaves<C>>,
        Parameter driven: Option<DrivenWheels<C>>,
        Parameter tow: Option<TowRope<C>>,
        Parameter brakes: Option<TrolleyBrakes<C>>,
        Parameter ropes: FourRopes<C>,
        Parameter reeved: Option<RopesLength<C>>,
        Parameter slings: Option<LoadSlings<C>>,
        Parameter profile: TravelProfile<C>,
        Parameter feedback: Option<Feedback<C>>,
        State swaying: Option<SwayingLoad<C>>,
        Fixed count: SheaveCount,
    } find {
        length: C = length(reeved, swaying) => _;
        hanging: Suspended<C> = Suspended::new(ropes, gravity, length);
        slung: Slung<C> = Slung::new(slings[!], unit, command, ropes, gravity, hanging);
        skew: Skew<C> = Skew::new(ropes, gravity, command, length, hanging);
        cycle: CycleTime<C> = CycleTime::new(profile);
        profiles: Profiles<C> = Profiles::new(profile, gravity, hanging);
        weight: C = carried(unit, command) => W;
        listing: Listing<C> = Listing::new(ropes, length, hanging, weight);
        rails: RailLoads<C> = RailLoads::new(unit, place, weight);
        damped: Damped<C> = damped(feedback[!], hanging);
        answer: C = answer(feedback[!], swaying[!], command, gravity, hanging) => A_L;
        travelling: Travelling<C> = travelling(swaying[!], speed, answer);
        swung: Swung<C> = swung(swaying[!], command, gravity, place, weight, ropes, hanging, answer);
        passed: C = sheaves(over[!], count, weight) => F_S;
        forces: TravelForces<C> = TravelForces::new(unit, gravity, command, speed, weight, passed[?]);
        led: DriveInMotion<C> = DriveInMotion::new(unit, gravity, speed, forces, swung, answer);
        powers: BridgePowers<C> = BridgePowers::new(unit, command, speed, weight, forces);
        grip: Grip<C> = Grip::new(driven[!], unit, gravity, weight, forces);
        braking: TrolleyBraking<C> = TrolleyBraking::new(brakes[!], profile, unit, gravity, weight, forces);
        sliding: C = holds(brakes[!], grip) => K_BR;
        towed: TowRun<C> = TowRun::new(tow[!], place, forces);
    }
}

impl Component for ContainerBridge {
    const STATES: [&'static [&'static Symbol]; 2] = [
        listed!(s: X_T, V_T),
        listed!(s: D_X_T, D_V_T, D_PHI_R, D_OMEGA_R, D_L_R),
    ];

    const PORTS: &'static [Port] = ports! { s:
        trolley "Trolley on the beam.": s X_T, v V_T, f F_R;
        load "Load on its ropes.": v V_H, f W;
    };

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.hanging().map(|_| ())
    }
}
