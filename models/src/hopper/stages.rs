//! The hopper as a component: what it is given, in which stages its equations follow from each other, how it moves.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::hopper::balance::{
    FeederCommand, GrabCycle, HopperContents, HopperFeeder, HopperSize, HopperTimes, NeededCapacity, SteadyFlow,
};
use crate::hopper::flow::{BrimMemory, HopperEvents, HopperFlow, PassedMass, decided};
use crate::hopper::symbols as s;
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};

stages! {
    /// The hopper of a crane.
    HopperCrane over C from {
        Coordinate contents: One<C>,
        Rate into: One<C>,
        Parameter hopper: HopperSize<C>,
        Parameter grab: GrabCycle<C>,
        Parameter feeder: HopperFeeder<C>,
        Parameter gravity: One<C>,
        Input command: Option<FeederCommand<C>>,
        State passed: Option<PassedMass<C>>,
        Memory memory: BrimMemory<C>,
    } find {
        steady: SteadyFlow<C> = SteadyFlow::new(grab, feeder);
        capacity: NeededCapacity<C> = NeededCapacity::new(hopper, grab, feeder);
        held: HopperContents<C> = HopperContents::new(hopper, grab, gravity, command, contents);
        times: HopperTimes<C> = HopperTimes::new(hopper, feeder, steady, contents);
        flow: HopperFlow<C> = HopperFlow::new(feeder, command[!], memory, into), decided;
        events: HopperEvents<C> = HopperEvents::new(hopper, grab, memory, flow, contents), decided;
    }
}

impl Component for HopperCrane {
    const STATES: [&'static [&'static Symbol]; 2] = [listed!(s: M_H), listed!(s: D_M_H, D_M_IN, D_M_OUT, D_M_S)];

    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_FULL, Z_EMPTY);

    const PORTS: &'static [Port] = ports! { s:
        mouth "Mouth of the hopper, into which the grab empties itself.": q Q_IN;
        feeder "Feeder under the hopper.": q Q_OUT;
    };

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.held().map(|_| ())
    }

    /// What an event leaves beyond the brim is spilled, what it leaves below nothing was not taken.
    fn decide(known: &mut Known<f64>) -> Found<bool> {
        let Some(mut passed) = known.given.passed else {
            return Ok(false);
        };
        let gain = *known.given.into - known.flow()?.wanted;
        let (contents, most) = (*known.given.contents, known.given.hopper.m_max);
        let mode = decided(contents, most, gain);
        if mode != known.given.memory.mode {
            known.memory().mode = mode;
        }
        let within = contents.clamp(0.0, most);
        if within == contents {
            return Ok(false);
        }
        if contents > most {
            passed.m_s += contents - most;
        } else {
            passed.m_out += contents;
        }
        known.contents().1 = within;
        *known.passed() = Some(passed);
        Ok(true)
    }
}
