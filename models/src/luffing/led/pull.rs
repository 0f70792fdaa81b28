//! What a led hoist rope does to the bars that lead it. [Ports001, 5.9.2.4]

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::led::path::{LedBars, Reeved, Stretch};
use crate::luffing::led::symbols as s;
use crate::luffing::resistances::placed::BARS;
use crate::parts::plane::{self, Point, cross};

/// Force on a bar by one newton in the rope, and its moment about the bar's first joint (m), counter-clockwise.
#[derive(Clone, Copy, Debug)]
pub struct Hauled<C> {
    pub force: Point<C>,
    pub moment: C,
}

impl<C: Calc> Hauled<C> {
    /// Under a pull, in N: the force in N, its moment in N·m.
    pub fn under(&self, pull: C) -> Hauled<C> {
        Hauled {
            force: self.force * pull,
            moment: self.moment * pull,
        }
    }
}

/// The rope's pull, and what it does to each bar.
#[derive(Clone, Copy, Debug)]
pub struct LedPull<C> {
    /// In N, and falls of the tackle.
    s_h: C,
    m_h: C,
    each: [Hauled<C>; BARS],
    pub on: [Hauled<C>; BARS],
}
results! { LedPull as p => {
    S_H: p.s_h;
    F_R1X: p.on[0].force.x;
    F_R1Y: p.on[0].force.y;
    M_R1: p.on[0].moment;
    F_R2X: p.on[1].force.x;
    F_R2Y: p.on[1].force.y;
    M_R2: p.on[1].moment;
    F_R3X: p.on[2].force.x;
    F_R3Y: p.on[2].force.y;
    M_R3: p.on[2].moment;
} }

/// Of each bar.
const NAMES: [[&Symbol; 3]; BARS] = [
    [&s::F_R1X, &s::F_R1Y, &s::M_R1],
    [&s::F_R2X, &s::F_R2Y, &s::M_R2],
    [&s::F_R3X, &s::F_R3Y, &s::M_R3],
];

impl<C: Calc> LedPull<C> {
    /// S_h = Q / m_h, the same in the whole rope: without losses a sheave is pulled both ways by it, and the head towards
    /// the first one.
    pub fn new(reeved: &Reeved<C>, q: &C, bars: &LedBars<C>, stretched: &[Stretch<C>]) -> LedPull<C> {
        let zero = C::constant(0.0);
        let mut each = [Hauled {
            force: Point::new(zero, zero),
            moment: zero,
        }; BARS];
        let mut pulled = |on: usize, at: Point<C>, force: Point<C>| {
            if let Some(bar) = each.get_mut(on) {
                bar.force += force;
                bar.moment += cross(at - bars.at[on][0], force);
            }
        };
        // What pulls two points of one bar together does nothing to it.
        for Stretch { ends, on, along, .. } in stretched.iter().filter(|stretch| stretch.on[0] != stretch.on[1]) {
            pulled(on[0], ends[0], *along);
            pulled(on[1], ends[1], -*along);
        }
        let s_h = (*q / reeved.falls.m_h).def(&s::S_H);
        let mut on = each.map(|bar| bar.under(s_h));
        for (bar, [x, y, moment]) in on.iter_mut().zip(NAMES) {
            bar.force = plane::def(bar.force, [x, y]);
            bar.moment = bar.moment.def(moment);
        }
        LedPull {
            s_h,
            m_h: reeved.falls.m_h,
            each,
            on,
        }
    }

    /// On a bar, with another load (N).
    pub fn by(&self, bar: usize, load: C) -> Hauled<C> {
        self.each[bar].under(load / self.m_h)
    }
}
