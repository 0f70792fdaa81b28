//! What a led hoist rope does to the bars that lead it. [Ports001, 5.9.2.4]

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::led::stretch::{LedBars, LedStretch};
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
    /// On each bar.
    pub fn nothing() -> [Hauled<C>; BARS] {
        let zero = C::constant(0.0);
        [Hauled {
            force: Point::new(zero, zero),
            moment: zero,
        }; BARS]
    }

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

/// Adds what one newton in a stretch does to the bars at its ends, which it pulls together; two points of one bar feel nothing.
pub fn haul<C: Calc>(each: &mut [Hauled<C>; BARS], bars: &LedBars<C>, stretch: &LedStretch<C>) {
    let LedStretch { ends, on, along, .. } = stretch;
    if on[0] == on[1] {
        return;
    }
    for (place, force) in [(0, *along), (1, -*along)] {
        if let Some(bar) = each.get_mut(on[place]) {
            bar.force += force;
            bar.moment += cross(ends[place] - bars.at[on[place]][0], force);
        }
    }
}

/// Under the names of its results.
pub fn named<C: Calc>(on: [Hauled<C>; BARS]) -> [Hauled<C>; BARS] {
    std::array::from_fn(|bar| {
        let [x, y, moment] = NAMES[bar];
        Hauled {
            force: plane::def(on[bar].force, [x, y]),
            moment: on[bar].moment.def(moment),
        }
    })
}

/// What a led rope does to boom, jib and rocker, or to as many bars as there are.
pub const RESULTS: [&Symbol; 10] = [
    &s::S_H,
    &s::F_R1X,
    &s::F_R1Y,
    &s::M_R1,
    &s::F_R2X,
    &s::F_R2Y,
    &s::M_R2,
    &s::F_R3X,
    &s::F_R3Y,
    &s::M_R3,
];

/// These of a pull (N), in their order.
pub fn results<C: Calc>(s_h: C, on: &[Hauled<C>; BARS]) -> [C; RESULTS.len()] {
    let [one, two, three] = on.each_ref().map(|bar| [bar.force.x, bar.force.y, bar.moment]);
    [
        s_h, one[0], one[1], one[2], two[0], two[1], two[2], three[0], three[1], three[2],
    ]
}

impl<C: Calc> LedPull<C> {
    /// S_h = Q / m_h, the same in the whole rope: without losses a sheave is pulled both ways by it, and the head towards
    /// the first one.
    pub fn new(reeved: &Reeved<C>, q: &C, bars: &LedBars<C>, stretched: &[LedStretch<C>]) -> LedPull<C> {
        let mut each = Hauled::nothing();
        stretched.iter().for_each(|stretch| haul(&mut each, bars, stretch));
        let s_h = (*q / reeved.falls.m_h).def(&s::S_H);
        let on = named(each.map(|bar| bar.under(s_h)));
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
