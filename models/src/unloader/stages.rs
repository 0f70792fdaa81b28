//! A grab unloader as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::unloader::cycle::{GrabDuty, GrabPhase, PhaseForces};
use crate::unloader::motors::{DynamicFactor, LiftedLoad, MotorPowers};
use crate::unloader::planetary::{Differential, PlanetarySet, circulating, differentials};
use crate::unloader::reeving::Reeving;
use crate::unloader::ropes::{DrumRun, RopeDrum, SlackRope, TrolleyRopes, drums_turn};
use crate::unloader::symbols as s;
use crate::unloader::trolley::{AuxiliaryRun, AuxiliaryTrolley, GrabCommand, GrabTrolley, TrolleyForces, hanging};

stages! {
    /// A grab unloader.
    GrabUnloader over C from {
        Coordinate travel: One<C>,
        Rate rate: One<C>,
        Input command: GrabCommand<C>,
        Parameter unit: GrabTrolley<C>,
        Parameter gravity: One<C>,
        Parameter slack: Option<SlackRope<C>>,
        Parameter aux: Option<AuxiliaryTrolley<C>>,
        Parameter set: Option<PlanetarySet<C>>,
        Parameter drums: Vec<RopeDrum<C>>,
        Parameter dynamic: DynamicFactor<C>,
        Parameter phases: Vec<GrabPhase<C>>,
        Fixed reeving: Reeving,
    } find {
        worked[each phases]: Vec<PhaseForces<C>> =
            PhaseForces::new(reeving, unit, gravity, slack, aux, drums, phases[each]);
        duty: GrabDuty<C> = GrabDuty::new(unit, gravity, phases, worked);
        weight: C = hanging(unit, command) => W;
        resisting: TrolleyForces<C> = TrolleyForces::new(reeving, unit, gravity, travel, rate, weight);
        auxiliary: AuxiliaryRun<C> = AuxiliaryRun::new(aux[!], unit, gravity, travel, rate, weight);
        ropes: TrolleyRopes<C> = TrolleyRopes::new(reeving, slack, weight, resisting, auxiliary[?]);
        turning[drums]: Vec<DrumRun<C>> = drums_turn(reeving, drums, command, travel, weight, ropes);
        differentials[drums]: Vec<Differential<C>> = differentials(set[!], drums, command, travel, turning);
        circulating: C = circulating(set[!], travel, ropes) => P_CIRC;
        motors: MotorPowers<C> = MotorPowers::new(reeving, unit, command, travel, weight, ropes);
        lifted: LiftedLoad<C> = LiftedLoad::new(dynamic, command, weight);
    }
}

impl Component for GrabUnloader {
    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_SLACK);

    const PORTS: &'static [Port] = ports! { s:
        trolley "Trolley on the bridge.": v V_T, f F_T;
        grab "Grab on its ropes.": v V_H, f W;
        drum "A drum with its ropes.": n N_D, tau M_D;
    };

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.ropes().map(|_| ())
    }
}
