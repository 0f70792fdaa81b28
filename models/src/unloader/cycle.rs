//! The phases of a cycle, and what they ask of ropes and motors.

use crate::component::stages::results;
use crate::kernel::calc::{Among, Calc};
use crate::kernel::group::{One, quantities};
use crate::kernel::symbol::Symbol;
use crate::parts::travel::{along, at_motor, sense};
use crate::unloader::motors::{at_ropes, turning};
use crate::unloader::reeving::{Reeving, Scheme};
use crate::unloader::ropes::{RopeDrum, SlackRope, driven, tensions};
use crate::unloader::symbols as s;
use crate::unloader::trolley::{AuxiliaryRope, AuxiliaryTrolley, GrabTrolley, auxiliary, parts};

quantities! {
    /// A phase: duration (s), speeds (m/s) and acceleration (m/s²), contents, part of the closing ropes.
    GrabPhase { t: T_P, v_h: V_HP, v_c: V_CP, v_t: V_TP, a_t: A_TP, k_q: K_QP, lambda: LAMBDA_P }
}

/// A phase: weight (N), force that the trolley asks for and at its drive, tensions of its ropes, pulls of hoisting and closing
/// drums (N), least safety of a rope, powers of the motors (W), and for how long they turn (s).
#[derive(Clone, Copy, Debug)]
pub struct PhaseForces<C> {
    pub weight: C,
    resists: C,
    drive: C,
    sides: [C; 2],
    pulls: [C; 2],
    safety: C,
    pub powers: [C; 3],
    pub lasts: [C; 3],
}
results! { each PhaseForces as p => {
    W_P: p.weight;
    F_RP: p.resists;
    F_DP: p.drive;
    T_1P: p.sides[0];
    T_2P: p.sides[1];
    S_HP: p.pulls[0];
    S_CP: p.pulls[1];
    NU_P: p.safety;
    P_HP: p.powers[0];
    P_CP: p.powers[1];
    P_TP: p.powers[2];
    T_HP: p.lasts[0];
    T_CP: p.lasts[1];
    T_TP: p.lasts[2];
} }

impl<C: Calc> PhaseForces<C> {
    /// As at any time, with what the phase has. [Ports001, 5.9.1]
    #[expect(clippy::too_many_arguments, reason = "all that pulls and resists in a phase")]
    pub fn new(
        reeving: &Reeving,
        unit: &GrabTrolley<C>,
        gravity: &One<C>,
        slack: &Option<SlackRope<C>>,
        aux: &Option<AuxiliaryTrolley<C>>,
        own_rope: &Option<AuxiliaryRope<C>>,
        drums: &[RopeDrum<C>],
        phase: &GrabPhase<C>,
    ) -> PhaseForces<C> {
        let weight = (unit.g_g + phase.k_q * unit.q_n).def(&s::W_P);
        let way = sense(phase.v_t.value(), phase.a_t.value());
        let resists = along(parts(unit, reeving.sheaves, **gravity, weight, phase.a_t), way).def(&s::F_RP);
        let (force, [sea, land]) = tensions(slack, weight, resists, |force| force);
        let sides = [sea.def(&s::T_1P), land.def(&s::T_2P)];
        let half = aux
            .as_ref()
            .map(|aux| auxiliary(aux, unit.mu, **gravity, phase.a_t, way));
        let drive = driven(reeving.scheme, resists, force, half).def(&s::F_DP);
        // The drum, and the pull, of the side that pulls more.
        let land = usize::from(sides[1].value() > sides[0].value());
        let most = sides[0].greater(sides[1]);
        let (of, places) = match reeving.scheme {
            Scheme::Planetary => (most, [land, 2 + land, 0]),
            _ => (weight, [0, 1, 2]),
        };
        let pulls = [
            ((C::constant(1.0) - phase.lambda) * of).def(&s::S_HP),
            (phase.lambda * of).def(&s::S_CP),
        ];
        let own = Some((2, most)).filter(|_| reeving.scheme != Scheme::Planetary);
        let pairs = [(places[0], pulls[0]), (places[1], pulls[1])].into_iter().chain(own);
        let of_drums = pairs.map(|(at, pull)| {
            let named = |value: C| value.among(Among::Of(at as u16 + 1), value);
            (named(drums[at].f_b) * named(drums[at].z_r), pull)
        });
        let of_half = own_rope
            .zip(half)
            .map(|(rope, force)| (rope.f_b * rope.z, weight.scaled(2.0) - force));
        let ropes = of_drums.chain(of_half).filter(|(_, pull)| pull.value() > 0.0);
        let safety = ropes.map(|(breaks, pull)| breaks / pull);
        let speeds = [phase.v_h, phase.v_c, phase.v_t];
        let found = at_ropes(reeving.scheme, speeds, [weight, phase.lambda, drive]);
        let names = [&s::P_HP, &s::P_CP, &s::P_TP];
        PhaseForces {
            weight,
            resists,
            drive,
            sides,
            pulls,
            safety: match safety.reduce(C::smaller) {
                Some(least) => least.def(&s::NU_P),
                None => C::known(&s::NU_P, f64::INFINITY).over(weight),
            },
            powers: std::array::from_fn(|i| at_motor(found[i], unit.eta_d).def(names[i])),
            lasts: lasting(phase.t, turning(reeving.scheme, speeds)),
        }
    }

    /// What is wrong where a rope of the trolley would have to push; with the number of the phase, from 1.
    pub fn slack(&self, number: usize) -> Option<String> {
        let low = self.sides[0].value().min(self.sides[1].value());
        (low < 0.0).then(|| {
            format!(
                "phase {number}: a rope of the trolley is slack, with a tension of {}: the trolley asks for {}, and the ropes \
                 of grab and contents give {} at most",
                s::T_2P.written(low),
                s::F_RP.written(self.resists.value().abs()),
                s::W_P.written(self.weight.value()),
            )
        })
    }
}

/// Names of the times for which the motors turn.
pub const LASTS: [&Symbol; 3] = [&s::T_HP, &s::T_CP, &s::T_TP];

/// For how long each motor turns, with the duration of a phase and the motors' speeds.
fn lasting<C: Calc>(time: C, speeds: [C; 3]) -> [C; 3] {
    std::array::from_fn(|i| {
        let own = if speeds[i].value() == 0.0 {
            C::constant(0.0)
        } else {
            time
        };
        own.over(speeds[i]).def(LASTS[i])
    })
}
