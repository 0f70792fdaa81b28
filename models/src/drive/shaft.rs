//! Torque and speed of what turns the drive.
//!
//! Friction is against the motion: a force that the drive pushes against costs more torque while it lengthens, and gives
//! back less while it shortens; a force that pulls is the other way round. Between the two torques the shaft stands still.

use std::f64::consts::TAU;

use crate::component::stages::results;
use crate::drive::gear::{Direct, Gear, Pinion};
use crate::drive::screw::Thread;
use crate::drive::symbols as s;
use crate::drive::tackle::Tackle;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;

/// How a force along the drive's line becomes a torque.
#[derive(Clone, Copy, Debug)]
pub struct Gearing<C> {
    /// Travel of the drive in one turn, in m.
    turn: C,
    /// Torque, in N·m, for one newton: without friction, one that the motion works against, one that drives it.
    arms: [C; 3],
    /// Of a screw.
    thread: Option<Thread<C>>,
    /// Of a drum.
    tackle: Option<Tackle<C>>,
}
results! { Gearing as g => {
    LAMBDA_D: g.thread.map_or(C::constant(0.0), |thread| thread.lambda);
    RHO_D: g.thread.map_or(C::constant(0.0), |thread| thread.rho);
    LOCK_D: g.thread.map_or(C::constant(0.0), |thread| thread.lock);
} }

impl<C: Calc> Gearing<C> {
    /// T = F p_h / (2 π) without friction, T = F r for a pinion. [Ports001, 5.3]
    pub fn new(gear: &Gear<C>) -> Gearing<C> {
        let tau = C::constant(TAU);
        match gear {
            Gear::Screw(screw) => {
                let thread = Thread::new(screw);
                let [against, with] = screw.arms(&thread);
                Gearing {
                    turn: screw.p_h,
                    arms: [screw.p_h / tau, against, with],
                    thread: Some(thread),
                    tackle: None,
                }
            }
            Gear::Pinion(Pinion { r_z, eta_d }) => Gearing::with_arm(*r_z, *eta_d),
            // One metre long: its arm follows from the position.
            Gear::Direct(Direct { eta_d }) => Gearing::with_arm(C::constant(1.0), *eta_d),
            Gear::Tackle(tackle) => Gearing {
                tackle: Some(*tackle),
                ..Gearing::with_arm(tackle.arm(), tackle.eta_d)
            },
        }
    }

    fn with_arm(arm: C, eta: C) -> Gearing<C> {
        Gearing {
            turn: C::constant(TAU) * arm,
            arms: [arm, arm / eta, arm * eta],
            thread: None,
            tackle: None,
        }
    }

    /// Torque, in N·m, for one newton that the motion works against.
    pub fn against(&self) -> C {
        self.arms[1]
    }

    /// With lever arms as many times as long.
    #[must_use]
    pub fn times(&self, longer: C) -> Gearing<C> {
        Gearing {
            turn: self.turn * longer,
            arms: self.arms.map(|arm| arm * longer),
            ..*self
        }
    }
}

/// The drive's shaft under the force of one position.
#[derive(Clone, Copy, Debug)]
pub struct Shaft<C> {
    n: C,
    /// Without friction, while the drive lengthens and while it shortens, in N·m.
    torques: [C; 3],
    /// The same of the pull of a rope at its drum, in N.
    pulls: Option<[C; 3]>,
}
results! { Shaft as t => {
    S_L: pull(t, 0);
    S_L_OUT: pull(t, 1);
    S_L_IN: pull(t, 2);
    N_D: t.n;
    T_D: t.torques[0];
    T_D_OUT: t.torques[1];
    T_D_IN: t.torques[2];
} }

/// A pull of its rope, of a shaft that has one.
fn pull<C: Calc>(shaft: &Shaft<C>, which: usize) -> C {
    shaft.pulls.map_or(C::constant(0.0), |pulls| pulls[which])
}

impl<C: Calc> Shaft<C> {
    /// Under a force `f_d` (N, push positive) at a speed `v_d` (m/s, lengthening positive): T_d ω_d = F_d v_d without
    /// friction; with it each sense of motion has its own torque. [Ports001, 5.3]
    pub fn new(gearing: &Gearing<C>, f_d: C, v_d: C) -> Shaft<C> {
        let [free, against, with] = gearing.arms;
        let torque = |arm: C, symbol: &'static Symbol| {
            if f_d.value().is_finite() {
                (f_d * arm).def(symbol)
            } else {
                f_d
            }
        };
        let (out, back) = if f_d.value() < 0.0 {
            (with, against)
        } else {
            (against, with)
        };
        // At rest a crank is so in its dead points too.
        let n = match (gearing.turn.value(), v_d.value()) {
            (0.0, 0.0) => v_d,
            _ => v_d / gearing.turn,
        };
        Shaft {
            n: n.def(&s::N_D),
            torques: [
                torque(free, &s::T_D),
                torque(out, &s::T_D_OUT),
                torque(back, &s::T_D_IN),
            ],
            pulls: gearing
                .tackle
                .map(|tackle| tackle.pulls(f_d, [&s::S_L, &s::S_L_OUT, &s::S_L_IN])),
        }
    }
}
