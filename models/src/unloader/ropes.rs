//! Ropes of the trolley and of the grab by the four schemes, and the drums that wind them.

use std::f64::consts::PI;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::unloader::reeving::{Reeving, Scheme};
use crate::unloader::symbols as s;
use crate::unloader::trolley::{AuxiliaryRun, GrabCommand, TrolleyForces};

quantities! {
    /// The slack rope of a trolley that has ropes of its own.
    SlackRope { t_0: T_0 }
}

quantities! {
    /// A drum: diameter (m), number of its ropes, breaking force of one (N).
    RopeDrum { d_d: D_D, z_r: Z_R, f_b: F_B }
}

/// Force of the ropes on the trolley, and tensions of sea and land side, in N: T_1 + T_2 = W where the grab's ropes pull the
/// trolley; else the hoisting and closing ropes pull it to the land with W, and a slack rope has T_0. [Ports001, 5.8]
pub fn tensions<C: Calc>(slack: &Option<SlackRope<C>>, weight: C, resists: C, force: impl Fn(C) -> C) -> (C, [C; 2]) {
    let half = |value: C| value / C::constant(2.0);
    match slack {
        None => {
            let force = force(resists);
            (force, [half(weight) + half(force), half(weight) - half(force)])
        }
        Some(slack) => {
            let force = force(resists + weight);
            let none = slack.t_0.over(force);
            if force.value() < 0.0 {
                (force, [none, slack.t_0 - force])
            } else {
                (force, [slack.t_0 + force, none])
            }
        }
    }
}

/// Force at the trolley's drive for its speed, in N: of the simple scheme with the ropes' pull, which its drums give back; of
/// an auxiliary trolley with half of what that asks for. [virtual work]
pub fn driven<C: Calc>(scheme: Scheme, resists: C, force: C, auxiliary: Option<C>) -> C {
    match (scheme, auxiliary) {
        (Scheme::Simple, _) => force,
        (_, Some(auxiliary)) => resists + auxiliary / C::constant(2.0),
        _ => resists,
    }
}

/// The ropes of the trolley: their force on it, tensions of both sides, the smaller one, and the force at its drive, in N.
#[derive(Clone, Copy, Debug)]
pub struct TrolleyRopes<C> {
    force: C,
    pub sides: [C; 2],
    pub low: C,
    pub drive: C,
    part: C,
}
results! { TrolleyRopes as t => {
    F_T: t.force;
    T_1: t.sides[0];
    T_2: t.sides[1];
    T_LOW: t.low;
    F_D: t.drive;
    SLACK: C::constant(f64::from(u8::from(t.low.value() < 0.0))).over(t.low);
    Z_SLACK: t.part;
} }

impl<C: Calc> TrolleyRopes<C> {
    /// T_1 − T_2 = F_t. [Ports001, 5.8]
    pub fn new(
        reeving: &Reeving,
        slack: &Option<SlackRope<C>>,
        weight: &C,
        resisting: &TrolleyForces<C>,
        auxiliary: Option<&AuxiliaryRun<C>>,
    ) -> TrolleyRopes<C> {
        let resists = resisting.total;
        let (force, [sea, land]) = tensions(slack, *weight, resists, |force| force.def(&s::F_T));
        let sides = [sea.def(&s::T_1), land.def(&s::T_2)];
        let low = sides[0].smaller(sides[1]).def(&s::T_LOW);
        TrolleyRopes {
            force,
            sides,
            low,
            drive: driven(reeving.scheme, resists, force, auxiliary.map(|aux| aux.force)).def(&s::F_D),
            part: low / *weight,
        }
    }
}

/// Speeds with which the drums wind, in m/s: v_h ± v_t and v_h + v_c ± v_t; v_h − v_t, v_h + v_c − v_t and v_t; without v_t
/// where the length of the ropes is kept. [Ports001, 5.8]
pub fn wound<C: Calc>(scheme: Scheme, [hoist, close, travel]: [C; 3], drum: usize) -> C {
    let closing = drum == if scheme == Scheme::Planetary { 2 } else { 1 } || drum == 3;
    let grab = if closing { hoist + close } else { hoist };
    match (scheme, drum) {
        (Scheme::Planetary, 0 | 2) => grab + travel,
        (Scheme::Planetary, _) => grab - travel,
        (_, 2..) => travel,
        (Scheme::Simple, _) => grab - travel,
        _ => grab,
    }
}

/// A drum: speed of its rope (m/s) and its own (1/s), greatest pull and force of its ropes (N), torque (N·m), power (W).
#[derive(Clone, Copy, Debug)]
pub struct DrumRun<C> {
    pub rope: C,
    pub turns: C,
    pull: C,
    force: C,
    pub torque: C,
    power: C,
}
results! { each DrumRun as d => {
    V_R: d.rope;
    N_D: d.turns;
    S_R: d.pull;
    F_I: d.force;
    M_D: d.torque;
    P_D: d.power;
} }

/// n = v/(π d), M = F d/2, P = F v; hoisting ropes bear (1 − λ) W, closing ropes λ W, of the planetary scheme so of T_1 and
/// T_2. [Ports001, 5.8]
pub fn drums_turn<C: Calc>(
    reeving: &Reeving,
    drums: &[RopeDrum<C>],
    command: &GrabCommand<C>,
    travel: &One<C>,
    weight: &C,
    ropes: &TrolleyRopes<C>,
    room: &mut Vec<DrumRun<C>>,
) {
    let speeds = [command.v_h, command.v_c, **travel];
    let share = |of: C, closing: bool| match closing {
        true => command.lambda * of,
        false => (C::constant(1.0) - command.lambda) * of,
    };
    let run = |at: usize| {
        let rope = wound(reeving.scheme, speeds, at).def(&s::V_R);
        let (pull, force) = match (reeving.scheme, at) {
            (Scheme::Planetary, _) => (share(ropes.sides[at % 2], at > 1), None),
            (_, 2..) => (ropes.sides[0].greater(ropes.sides[1]), Some(ropes.drive)),
            _ => (share(*weight, at == 1), None),
        };
        let pull = pull.def(&s::S_R);
        let force = force.unwrap_or(pull).def(&s::F_I);
        let drum = &drums[at];
        DrumRun {
            rope,
            turns: (rope / (C::constant(PI) * drum.d_d)).def(&s::N_D),
            pull,
            force,
            torque: (force * drum.d_d / C::constant(2.0)).def(&s::M_D),
            power: (force * rope).def(&s::P_D),
        }
    };
    room.clear();
    room.extend((0..drums.len()).map(|at| C::body(at, || run(at))));
}
