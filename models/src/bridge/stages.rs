//! The trolley of a container bridge as a component: what it is given, in which stages its equations follow from each other,
//! how it moves.

use crate::bridge::bodies::motion::{SlungRates, SlungTurning};
use crate::bridge::bodies::posture::{SlungLoad, SlungPosture};
use crate::bridge::bodies::pulls::{SlungAcceleration, SlungPulls};
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
        State hung: Option<SlungLoad<C>>,
        Fixed count: SheaveCount,
    } find {
        length: C = length(reeved, swaying, hung) => _;
        hanging: Suspended<C> = Suspended::new(ropes, gravity, length);
        slung: Slung<C> = Slung::new(slings[!], unit, command, ropes, gravity, hanging);
        skew: Skew<C> = Skew::new(ropes, gravity, command, length, hanging);
        cycle: CycleTime<C> = CycleTime::new(profile);
        profiles: Profiles<C> = Profiles::new(profile, gravity, hanging);
        weight: C = carried(unit, command) => W;
        listing: Listing<C> = Listing::new(ropes, length, hanging, weight);
        rails: RailLoads<C> = RailLoads::new(unit, place, weight);
        damped: Damped<C> = damped(feedback[!], swaying[!], hanging);
        posture: SlungPosture<C> = SlungPosture::new(hung[!], slings[!], ropes, hanging);
        turning: SlungTurning<C> = SlungTurning::new(hung[!], slings[!], command, slung, posture);
        answer: C = answer(feedback[!], swaying, hung, turning[?], command, gravity, hanging) => A_L;
        travelling: Travelling<C> = travelling(feedback[!], speed, answer);
        swung: Swung<C> = swung(swaying[!], command, gravity, place, weight, ropes, hanging, answer);
        rates: SlungRates<C> = SlungRates::new(hung[!], slings[!], command, gravity, slung, posture, turning, answer);
        borne: SlungAcceleration<C> = SlungAcceleration::new(hung[!], slings[!], command, gravity, slung, posture, turning, rates, answer);
        pulls: SlungPulls<C> = SlungPulls::new(hung[!], slings[!], unit, command, gravity, place, ropes, posture, turning, borne);
        passed: C = sheaves(over[!], count, weight) => F_S;
        forces: TravelForces<C> = TravelForces::new(unit, gravity, command, speed, weight, passed[?]);
        led: DriveInMotion<C> = DriveInMotion::new(unit, gravity, speed, forces, swung[?], pulls[?], answer);
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
        listed!(s: D_X_T, D_V_T, D_PHI_R, D_OMEGA_R, D_PSI_S, D_W_PHI, D_W_PSI, D_L_R),
    ];

    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_SLINGS, Z_SEA, Z_LAND);

    const PORTS: &'static [Port] = ports! { s:
        trolley "Trolley on the beam.": s X_T, v V_T, f F_R;
        load "Load on its ropes.": v V_H, f W;
    };

    /// Nothing follows but the end of a motion in which something would have to push.
    fn decide(known: &mut Known<f64>) -> Found<bool> {
        if let Some(load) = known.given.hung {
            known.pulls()?.hold(&load)?;
        }
        Ok(false)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        if known.given.hung.is_some() {
            known.posture()?;
        }
        known.hanging().map(|_| ())
    }
}
