//! Brakes on the motor's shaft: what they must hold in a case, and how they stop its motion.

use std::f64::consts::TAU;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::resistances::given::{Case, CaseBrake, CaseHold, CaseMotor, SecondBrake};
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::motor::Motored;
use crate::luffing::resistances::sums::Sums;
use crate::luffing::resistances::symbols as s;
use crate::parts::braking::LastBrake;

/// What the brakes must hold in a case. Torques in N·m.
#[derive(Clone, Copy, Debug)]
pub struct Holding<C> {
    moment: C,
    holding: C,
    asked: C,
    asked_without_losses: C,
    used: C,
}
results! { each Holding as b => {
    M_R_HELD: b.moment;
    T_H: b.holding;
    T_K: b.asked;
    T_K1: b.asked_without_losses;
    U_B: b.used;
} }

impl<C: Calc> Holding<C> {
    /// All but inertia and friction is held; T_K = K |T_H| η. [Ports001, 5.7]
    pub fn new(
        motor: &CaseMotor<C>,
        brake: &CaseBrake<C>,
        second: &Option<SecondBrake<C>>,
        sums: &Sums<C>,
        hold: &CaseHold<C>,
        resisted: &Resisted<C>,
    ) -> Holding<C> {
        let (way, moment) = (sums.way[0], (resisted.sum - resisted.inertia).def(&s::M_R_HELD));
        let holding = if way.value().abs() > f64::EPSILON {
            (-moment / way * motor.arm()).def(&s::T_H)
        } else {
            C::known(&s::T_H, f64::INFINITY).over(moment)
        };
        let asked_without_losses = (hold.k_b * holding.abs()).def(&s::T_K1);
        let asked = (asked_without_losses * motor.eta).def(&s::T_K);
        let all = second.map_or(brake.torque, |second| brake.torque + second.torque);
        Holding {
            moment,
            holding,
            asked,
            asked_without_losses,
            used: (asked / all).def(&s::U_B),
        }
    }
}

/// How the brakes stop a case: from this position, in which all torques are those of the start.
#[derive(Clone, Copy, Debug)]
pub struct Stopped<C> {
    inertia: C,
    turned: C,
    speed: C,
    slows: C,
    time: C,
    way: C,
    head: C,
}
results! { each Stopped as b => {
    J_K: b.inertia;
    PSI_B: b.turned;
    OMEGA_B: b.speed;
    ALPHA_B: b.slows;
    T_STOP: b.time;
    S_STOP: b.way;
    A_STOP: b.head;
} }

impl<C: Calc> Stopped<C> {
    /// ω̇ = −(T_0 + Σ T_b) / J, each brake after its delay. [Ports001, 5.7]
    pub fn new(
        motor: &CaseMotor<C>,
        brake: &CaseBrake<C>,
        second: &Option<SecondBrake<C>>,
        sums: &Sums<C>,
        case: &Case<C>,
        motored: &Motored<C>,
    ) -> Stopped<C> {
        let (zero, half) = (C::constant(0.0), C::constant(0.5));
        if case.v.value() == 0.0 {
            return Stopped {
                inertia: zero,
                turned: zero,
                speed: zero,
                slows: zero,
                time: zero,
                way: zero,
                head: zero,
            };
        }
        let inertia = motor.inertia(sums, motor.eta).def(&s::J_K);
        let behind = second.map(|second| [second.torque, second.delay]);
        let brakes = std::iter::once([brake.torque, brake.delay]).chain(behind);
        let speed = (C::constant(TAU) * motored.n).abs();
        let LastBrake {
            time,
            turned,
            speed,
            torque,
        } = LastBrake::new(inertia, motored.against, speed, brakes);
        let (turned, speed) = (turned.def(&s::PSI_B), speed.def(&s::OMEGA_B));
        let slows = (torque / inertia).def(&s::ALPHA_B);
        let head = ((sums.head.x / sums.way[0]).abs() * motor.arm() * slows).def(&s::A_STOP);
        let never = |symbol| C::known(symbol, f64::INFINITY).over(slows);
        let stops = slows.value() > 0.0;
        let end = |last: C, symbol| if stops { last.def(symbol) } else { never(symbol) };
        Stopped {
            inertia,
            turned,
            speed,
            slows,
            time: end(time + speed / slows, &s::T_STOP),
            way: end((turned + half * speed.square() / slows) * motor.arm(), &s::S_STOP),
            head,
        }
    }
}
