//! Pulls with the losses of both tackles.
//!
//! A rope that is taken in costs more than it carries, one that runs out carries less than hangs on it. The luffing rope
//! is taken in while the boom is raised. Where h_S is positive the stretch between head and sheave loses length then, and
//! with the hoist drum at rest that runs out through the hook block; where h_S is negative it is taken in from there.
//! While the boom is lowered all of it is the other way round. What runs out through the hook block comes out of all parts
//! between head and sheave, which then carry less than m_k S_h; what they take in costs them more.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::rope::position::{Falls, Rig, Stretch};
use crate::luffing::rope::statics::RopePulls;
use crate::luffing::rope::symbols as s;

/// Pulls in N while the boom is raised, and while it is lowered.
#[derive(Clone, Copy, Debug)]
pub struct Losses<C> {
    up: Pulls<C>,
    down: Pulls<C>,
}
results! { Losses as l => {
    S_H_UP: l.up.hoist;
    F_K_UP: l.up.parts;
    T_UP: l.up.tackle;
    S_L_UP: l.up.rope;
    S_H_DOWN: l.down.hoist;
    F_K_DOWN: l.down.parts;
    T_DOWN: l.down.tackle;
    S_L_DOWN: l.down.rope;
} }

#[derive(Clone, Copy, Debug)]
struct Pulls<C> {
    hoist: C,
    parts: C,
    tackle: C,
    rope: C,
}

/// Pull at the end of a rope whose tackle carries `load` (N) on so many falls: taken in or running out.
fn reeved<C: Calc>(load: C, falls: C, eta: C, taken_in: bool, symbol: &'static Symbol) -> C {
    let pull = if taken_in {
        load / (falls * eta)
    } else {
        load * eta / falls
    };
    pull.def(symbol)
}

/// Pull of all parts between head and sheave, in N, the last of which runs with `s_h` (N): taken in or running out.
fn led<C: Calc>(stretch: &Stretch<C>, s_h: C, taken_in: bool, symbol: &'static Symbol) -> C {
    stretch.parts.map_or(s_h, |parts| {
        let all = stretch.all(s_h);
        let pull = if taken_in { all / parts.eta_k } else { all * parts.eta_k };
        pull.def(symbol)
    })
}

impl<C: Calc> Losses<C> {
    /// [Ports001, 5.1]
    pub fn new(rig: &Rig<C>, q: &C, carried: &RopePulls<C>, falls: &Falls<C>, stretch: &Stretch<C>) -> Losses<C> {
        let of = |raised: bool, [s_h, f_k, t, s_l]: [&'static Symbol; 4]| {
            let taken_in = (stretch.line.arm.value() < 0.0) == raised;
            let hoist = reeved(*q, rig.m_h, rig.eta_h, taken_in, s_h);
            let parts = led(stretch, hoist, taken_in, f_k);
            let tackle = (carried.left(stretch, parts) / falls.line.arm).def(t);
            Pulls {
                hoist,
                parts,
                tackle,
                rope: reeved(tackle, rig.m_l, rig.eta_l, raised, s_l),
            }
        };
        Losses {
            up: of(true, [&s::S_H_UP, &s::F_K_UP, &s::T_UP, &s::S_L_UP]),
            down: of(false, [&s::S_H_DOWN, &s::F_K_DOWN, &s::T_DOWN, &s::S_L_DOWN]),
        }
    }
}
