//! The planetary scheme: each drum on the carrier of a differential, sun by the hoisting or closing motor, ring by the travel
//! motor, the other way round on the land side.

use std::f64::consts::{PI, TAU};

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::unloader::ropes::{DrumRun, RopeDrum, TrolleyRopes};
use crate::unloader::symbols as s;
use crate::unloader::trolley::GrabCommand;

quantities! {
    /// A differential: teeth of its ring over those of its sun; torque of its brakes over that which they hold.
    PlanetarySet { k: K, k_b: K_B }
}

/// Of a drum's differential: speeds (1/s), torques (N·m) and powers (W) of sun and ring; speeds of the drum with one of both
/// held, and torques of the brakes.
#[derive(Clone, Copy, Debug)]
pub struct Differential<C> {
    turns: [C; 2],
    torques: [C; 2],
    powers: [C; 2],
    alone: [C; 2],
    brakes: [C; 2],
}
results! { each Differential as d => {
    N_S: d.turns[0];
    N_R: d.turns[1];
    T_S: d.torques[0];
    T_R: d.torques[1];
    P_S: d.powers[0];
    P_R: d.powers[1];
    N_DS: d.alone[0];
    N_DR: d.alone[1];
    T_BS: d.brakes[0];
    T_BR: d.brakes[1];
} }

impl<C: Calc> Differential<C> {
    /// n_s = (1 + k) v/(π d) of the grab's rope, n_r = (1 + k)/k v_t/(π d), on the land side −v_t; T_s = M/(1 + k), T_r = k T_s.
    /// [Ports001, 5.8.1]
    fn new(set: &PlanetarySet<C>, drum: &RopeDrum<C>, [grab, travel]: [C; 2], run: &DrumRun<C>) -> Differential<C> {
        let whole = C::constant(1.0) + set.k;
        let round = C::constant(PI) * drum.d_d;
        let sun = (whole * grab / round).def(&s::N_S);
        let ring = (whole * travel / (set.k * round)).def(&s::N_R);
        let torques = [
            (run.torque / whole).def(&s::T_S),
            (set.k * run.torque / whole).def(&s::T_R),
        ];
        let power = |torque: C, turns: C| C::constant(TAU) * turns * torque;
        Differential {
            turns: [sun, ring],
            torques,
            powers: [
                power(torques[0], sun).def(&s::P_S),
                power(torques[1], ring).def(&s::P_R),
            ],
            alone: [(sun / whole).def(&s::N_DS), (set.k * ring / whole).def(&s::N_DR)],
            brakes: [
                (set.k_b * torques[0].abs()).def(&s::T_BS),
                (set.k_b * torques[1].abs()).def(&s::T_BR),
            ],
        }
    }
}

/// The differentials of all drums. [Ports001, 5.8.1]
pub fn differentials<C: Calc>(
    set: &PlanetarySet<C>,
    drums: &[RopeDrum<C>],
    command: &GrabCommand<C>,
    travel: &One<C>,
    runs: &[DrumRun<C>],
    room: &mut Vec<Differential<C>>,
) {
    let speeds = |at: usize| {
        let grab = if at > 1 { command.v_h + command.v_c } else { command.v_h };
        [grab, if at.is_multiple_of(2) { **travel } else { -**travel }]
    };
    room.clear();
    room.extend((0..drums.len()).map(|at| C::body(at, || Differential::new(set, &drums[at], speeds(at), &runs[at]))));
}

/// Power that goes round, in W: what the ring gears of one side give and those of the other one take, by the smaller tension
/// of both sides. [Ports001, 5.8.1]
pub fn circulating<C: Calc>(_: &PlanetarySet<C>, travel: &One<C>, ropes: &TrolleyRopes<C>) -> C {
    (ropes.low.greater(C::constant(0.0)) * travel.abs()).def(&s::P_CIRC)
}
