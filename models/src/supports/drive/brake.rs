//! A slewing brake on each motor's shaft: what it must hold in a load case, how it stops it, and what the coupling behind the
//! motor transmits.

use std::f64::consts::TAU;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::motor::{CaseBrake, CaseHold};
use crate::supports::drive::gear::TurningDrive;
use crate::supports::drive::inertia::Outswing;
use crate::supports::drive::motor::TurningMotor;
use crate::supports::drive::resistance::TurningMoments;
use crate::supports::drive::starts::HardestPush;
use crate::supports::drive::symbols as s;

/// What a brake must hold, in N·m at the axis and at its shaft.
#[derive(Clone, Copy, Debug)]
pub struct TurningHold<C> {
    pub moment: C,
    asked: C,
    used: C,
}
results! { each TurningHold as h => { M_HS: h.moment; T_HS: h.asked; U_BS: h.used; } }

impl<C: Calc> TurningHold<C> {
    /// All but friction is held: T_h = K_b (|M_z| + M_α) η/(i z). [Ports001, 6.5.4]
    pub fn new(
        drive: &TurningDrive<C>,
        brake: &CaseBrake<C>,
        hold: &CaseHold<C>,
        turned: &TurningMoments<C>,
    ) -> TurningHold<C> {
        let outer = turned.outer.abs();
        let moment = (outer + turned.sway).def(&s::M_HS);
        let asked = (hold.k_b * moment * drive.eta / (drive.i * drive.z)).def(&s::T_HS);
        TurningHold {
            moment,
            asked,
            used: (asked / brake.torque).def(&s::U_BS),
        }
    }
}

/// Two stops, the brake acting after its delay: the longest, with slope and wind from behind, and the hardest, into them; the
/// load sways forward in both. All torques are those of the start.
#[derive(Clone, Copy, Debug)]
pub struct TurningStop<C> {
    inertia: C,
    behind: C,
    free: C,
    turned: C,
    speed: C,
    slows: C,
    time: C,
    angle: C,
    ahead: C,
    hard: C,
    head: C,
}
results! { each TurningStop as t => {
    J_K: t.inertia;
    T_W: t.behind;
    ALPHA_F: t.free;
    PSI_B: t.turned;
    OMEGA_B: t.speed;
    ALPHA_W: t.slows;
    T_STOP: t.time;
    PSI_STOP: t.angle;
    T_AG: t.ahead;
    ALPHA_AG: t.hard;
    A_STOP: t.head;
} }

impl<C: Calc> TurningStop<C> {
    /// J_K = J_M + J η/(i² z); ω̇ = −(T + T_b)/J_K, T being that of M_f − M_α ∓ |M_z|. [Ports001, 6.5.4]
    pub fn new(
        drive: &TurningDrive<C>,
        brake: &CaseBrake<C>,
        turned: &TurningMoments<C>,
        swung: &Outswing<C>,
        motor: &TurningMotor<C>,
    ) -> TurningStop<C> {
        let (zero, half) = (C::constant(0.0), C::constant(0.5));
        let inertia = (drive.j + turned.inertia * drive.eta / (drive.i.square() * drive.z)).def(&s::J_K);
        let outer = turned.outer.abs();
        let behind = drive.torque(turned.inner(true) - outer).def(&s::T_W);
        let free = (behind / inertia).def(&s::ALPHA_F);
        // Until the brake acts, or until it stands still before.
        let start = C::constant(TAU) * motor.n;
        let stands = free.value() * brake.delay.value() >= start.value();
        let span = if stands { start / free } else { brake.delay };
        let moves = motor.n.value() > 0.0;
        let [speed, turns] = if moves {
            let turns = start * span - half * free * span.square();
            [(start - free * span).def(&s::OMEGA_B), turns.def(&s::PSI_B)]
        } else {
            [zero.over(motor.n); 2]
        };
        let slows = ((brake.torque + behind) / inertia).def(&s::ALPHA_W);
        let [time, angle] = if !moves {
            [zero.over(motor.n); 2]
        } else if stands {
            [span.def(&s::T_STOP), (turns / drive.i).def(&s::PSI_STOP)]
        } else if slows.value() <= 0.0 {
            [&s::T_STOP, &s::PSI_STOP].map(|symbol| C::known(symbol, f64::INFINITY).over(slows))
        } else {
            let all = turns + half * speed.square() / slows;
            [
                (span + speed / slows).def(&s::T_STOP),
                (all / drive.i).def(&s::PSI_STOP),
            ]
        };
        let ahead = drive.torque(turned.inner(true) + outer).def(&s::T_AG);
        let hard = ((brake.torque + ahead) / inertia).def(&s::ALPHA_AG);
        let head = if moves {
            (hard * swung.reach.abs() / drive.i).def(&s::A_STOP)
        } else {
            zero.over(motor.n)
        };
        TurningStop {
            inertia,
            behind,
            free,
            turned: turns,
            speed,
            slows,
            time,
            angle,
            ahead,
            hard,
            head,
        }
    }
}

/// The coupling between each motor, with its brake, and the gear, in N·m.
#[derive(Clone, Copy, Debug)]
pub struct Coupled<C> {
    torque: C,
    pub slips: C,
}
results! { each Coupled as c => { T_C: c.torque; T_LIM: c.slips; } }

impl<C: Calc> Coupled<C> {
    /// What is left of the motor's torque in a start, T_0 + (J_t − J_M) ω̇, or of the brake's in a stop, T_b − J_M ω̇;
    /// T_lim = k_lim T_c. [Ports001, 6.5.4]
    pub fn new(
        drive: &TurningDrive<C>,
        brake: &CaseBrake<C>,
        limit: &One<C>,
        motor: &TurningMotor<C>,
        pushed: &HardestPush<C>,
        stop: &TurningStop<C>,
    ) -> Coupled<C> {
        let starts = pushed.behind(drive, motor);
        let torque = starts.greater(brake.torque - drive.j * stop.slows).def(&s::T_C);
        Coupled {
            torque,
            slips: (**limit * torque).def(&s::T_LIM),
        }
    }
}
