//! A grab unloader as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::sway::pendulum::{Damped, Feedback, SwayingLoad, Swung};
use crate::unloader::cycle::{GrabPhase, PhaseForces};
use crate::unloader::duty::GrabDuty;
use crate::unloader::motors::{DynamicFactor, LiftedLoad, MotorPowers};
use crate::unloader::planetary::{Differential, PlanetarySet, circulating, differentials};
use crate::unloader::reeving::Reeving;
use crate::unloader::ropes::{DrumRun, RopeDrum, SlackRope, TrolleyRopes, drums_turn};
use crate::unloader::sway::{GrabPlace, GrabTravel, GrabWay, SwayOnWay, answer, damped, swung, travels};
use crate::unloader::symbols as s;
use crate::unloader::trolley::{
    AuxiliaryRope, AuxiliaryRun, AuxiliaryTrolley, GrabCommand, GrabTrolley, TrolleyForces, hanging,
};

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
        Parameter own_rope: Option<AuxiliaryRope<C>>,
        Parameter set: Option<PlanetarySet<C>>,
        Parameter drums: Vec<RopeDrum<C>>,
        Parameter dynamic: DynamicFactor<C>,
        Parameter phases: Vec<GrabPhase<C>>,
        Parameter way: Option<GrabWay<C>>,
        Parameter feedback: Option<Feedback<C>>,
        State place: Option<GrabPlace<C>>,
        State swaying: Option<SwayingLoad<C>>,
        Fixed reeving: Reeving,
    } find {
        worked[each phases]: Vec<PhaseForces<C>> =
            PhaseForces::new(reeving, unit, gravity, slack, aux, own_rope, drums, phases[each]);
        duty: GrabDuty<C> = GrabDuty::new(unit, gravity, phases, worked);
        on_way: SwayOnWay<C> = SwayOnWay::new(way[!], swaying[!], gravity);
        damped: Damped<C> = damped(feedback[!], on_way);
        weight: C = hanging(unit, command) => W;
        answer: C = answer(feedback[!], swaying[!], command, rate, gravity) => A_L;
        travels: GrabTravel<C> = travels(place[!], travel, answer);
        swung: Swung<C> = swung(swaying[!], place[!], command, gravity, weight, answer);
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
    const STATES: [&'static [&'static Symbol]; 2] =
        [listed!(s: V_T), listed!(s: D_V_T, D_X_T, D_PHI_R, D_OMEGA_R, D_L_R)];

    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_SLACK);

    /// Where the trolley moves by itself its ropes follow from it, and nothing from them.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.swaying.is_none() || symbol != &s::Z_SLACK
    }

    const PORTS: &'static [Port] = ports! { s:
        trolley "Trolley on the bridge.": v V_T, f F_T;
        grab "Grab on its ropes.": v V_H, f W;
        drum "A drum with its ropes.": n N_D, tau M_D;
    };

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.ropes().map(|_| ())
    }
}
