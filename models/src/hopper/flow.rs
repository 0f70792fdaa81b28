//! How the contents change while grab and feeder work: a full hopper spills, an empty one feeds what comes in.

use crate::component::stages::results;
use crate::hopper::balance::{FeederCommand, GrabCycle, HopperFeeder, HopperSize};
use crate::hopper::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::parts::joint::above_zero;

quantities! {
    /// Where all that came has gone besides the contents.
    PassedMass { m_in: M_IN, m_out: M_OUT, m_s: M_S }
}

quantities! {
    /// What happened before: whether the hopper has become full or empty.
    BrimMemory { mode: MODE }
}

/// What follows at contents (kg), of a capacity, to which grab and feeder would add a flow (kg/s): full (1), empty (−1) or
/// neither (0).
#[must_use]
pub fn decided(contents: f64, capacity: f64, gain: f64) -> f64 {
    match contents {
        _ if contents >= capacity && gain >= 0.0 => 1.0,
        _ if contents <= 0.0 && gain <= 0.0 => -1.0,
        _ => 0.0,
    }
}

/// Flows (kg/s): what the feeder would take, takes, what is spilled, the rate of the contents.
#[derive(Clone, Copy, Debug)]
pub struct HopperFlow<C> {
    pub wanted: C,
    out: C,
    spilled: C,
    rate: C,
    into: C,
    mode: f64,
}
results! { HopperFlow as f => {
    Q_C: f.wanted;
    Q_OUT: f.out;
    Q_S: f.spilled;
    D_M_H: f.rate;
    D_M_IN: f.into;
    D_M_OUT: f.out;
    D_M_S: f.spilled;
    FULL: C::constant(f64::from(u8::from(f.mode > 0.0))).over(f.rate);
    EMPTY: C::constant(f64::from(u8::from(f.mode < 0.0))).over(f.rate);
} }

impl<C: Calc> HopperFlow<C> {
    /// ṁ = q_in − q_out with q_out = y q_f; full, ṁ = 0 and q_s = q_in − q_out; empty, ṁ = 0 and q_out = q_in.
    /// [Ports001, 7.2.5]
    pub fn new(
        feeder: &HopperFeeder<C>,
        command: &FeederCommand<C>,
        memory: &BrimMemory<C>,
        into: &One<C>,
    ) -> HopperFlow<C> {
        let (mode, into) = (memory.mode.value(), **into);
        let wanted = (command.y_f * feeder.q_f).def(&s::Q_C);
        let none = C::constant(0.0).over(into).over(wanted);
        let out = if mode < 0.0 { into } else { wanted }.def(&s::Q_OUT);
        let (rate, spilled) = match mode {
            0.0 => ((into - out).def(&s::D_M_H), none),
            mode if mode > 0.0 => (none, (into - out).def(&s::Q_S)),
            _ => (none, none),
        };
        HopperFlow {
            wanted,
            out,
            spilled,
            rate,
            into,
            mode,
        }
    }
}

/// What falls below zero where the hopper gets full or empty, and where it is so no more.
#[derive(Clone, Copy, Debug)]
pub struct HopperEvents<C>([C; 2]);
results! { HopperEvents as e => { Z_FULL: e.0[0]; Z_EMPTY: e.0[1]; } }

impl<C: Calc> HopperEvents<C> {
    /// Room and contents over the capacity; at an end what a cycle would add, or take, over the capacity.
    pub fn new(
        hopper: &HopperSize<C>,
        grab: &GrabCycle<C>,
        memory: &BrimMemory<C>,
        flow: &HopperFlow<C>,
        contents: &One<C>,
    ) -> HopperEvents<C> {
        let gain = (flow.into - flow.wanted) * grab.t_c;
        let [full, empty] = match memory.mode.value() {
            0.0 => [hopper.m_max - **contents, **contents],
            mode if mode > 0.0 => [gain, hopper.m_max],
            _ => [hopper.m_max, -gain],
        };
        HopperEvents([full, empty].map(|mass| above_zero(mass / hopper.m_max)))
    }
}
