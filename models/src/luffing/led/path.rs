//! How the load rises by a led hoist rope. [Ports001, 5.9.2.4]

use crate::component::stages::{Found, results};
use crate::kernel::calc::Calc;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::led::stretch::{LedBars, LedStretch};

/// Quantities of the led rope and its load.
mod s {
    pub use crate::luffing::led::symbols::*;
    pub use crate::luffing::moving::symbols::DY_Q;
}

/// Where the load hangs at the start of the working range.
#[derive(Clone, Copy, Debug)]
pub struct LedStart<C> {
    /// Height of the load less that of the head, in m, were there no rope between head and frame.
    c_q: C,
    /// Rope from the head to the frame, in m.
    length: C,
}
results! { LedStart as l => { L_LEDA: l.length; C_Q: l.c_q; } }

impl<C: Calc> LedStart<C> {
    /// h_Q below the head: c_Q = −h_Q − L_r / m_h. [Ports001, 5.9.2.4]
    ///
    /// # Errors
    /// As [`LedStretch::new`].
    pub fn new(reeved: &Reeved<C>, bars: &LedBars<C>) -> Found<LedStart<C>> {
        let falls = &reeved.falls;
        let length = C::aside(|| reeved.sum(bars, |stretch| stretch.length))?
            .tabled(&s::L_LEDA)
            .def(&s::L_LEDA);
        Ok(LedStart {
            c_q: (-falls.h_q - length / falls.m_h).def(&s::C_Q),
            length,
        })
    }
}

/// The whole rope with its drum at rest, and the load on it: what the led rope gains the falls below the head lose.
#[derive(Clone, Copy, Debug)]
pub struct LedRope<C> {
    length: C,
    /// Height of the load, in m.
    y_q: C,
    /// Rise of the load for one radian of the luffing angle, in m.
    pub rise: C,
}
results! { LedRope as p => { L_LED: p.length; Y_Q: p.y_q; } }

impl<C: Calc> LedRope<C> {
    /// y_Q = y_A + L_r / m_h + c_Q, y′_Q = y′_A + L′_r / m_h. [Ports001, 5.9.2.4]
    pub fn new(reeved: &Reeved<C>, start: &LedStart<C>, bars: &LedBars<C>, stretched: &[LedStretch<C>]) -> LedRope<C> {
        let falls = &reeved.falls;
        let all = |of: fn(&LedStretch<C>) -> C| stretched.iter().map(of).fold(C::constant(0.0), |sum, one| sum + one);
        let length = all(|stretch| stretch.length).def(&s::L_LED);
        let change = all(|stretch| stretch.change).def(&s::DL_LED);
        LedRope {
            length,
            y_q: (bars.head.y + length / falls.m_h + start.c_q).def(&s::Y_Q),
            rise: (bars.travel.y + change / falls.m_h).def(&s::DY_Q),
        }
    }

    /// Velocity of the load, upward, in m/s, at an angular velocity (rad/s).
    pub fn v_q(&self, omega: &C) -> C {
        (self.rise * *omega).def(&s::V_Q)
    }
}
