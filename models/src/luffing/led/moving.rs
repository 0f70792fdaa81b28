//! What luffing does to a led hoist rope in motion, by what its sheaves do. [Ports001, 5.9.2.4]

use crate::kernel::calc::{Calc, Over};
use crate::luffing::led::pull::{Hauled, haul};
use crate::luffing::led::reeved::Reeved;
use crate::luffing::led::stretch::{LedBars, Sheave};
use crate::luffing::led::symbols as s;
use crate::luffing::moving::symbols as m;
use crate::luffing::resistances::placed::BARS;
use crate::parts::plane::{self, Point, dot, squared};

/// How the led rope takes part in the motion, in m: what it raises the load by but for a constant; the rope that one radian of the
/// luffing angle adds between head and load, and how that changes.
#[derive(Clone, Copy, Debug)]
pub struct LedMoves<C> {
    pub raised: C,
    pub lead: [C; 2],
}

impl<P: Calc> Reeved<P> {
    /// From the head, which a bar carries, over points of the bars, each with two derivatives by the luffing angle (m); `None` where a
    /// stretch has no length. l″_r = (|v|² − l′_r²) / l_r + a · e, of what its ends move by against each other. (derived)
    pub fn moves<C: Over<P>>(
        &self,
        (carries, head): (usize, [Point<C>; 3]),
        point: impl Fn(usize, Point<P>) -> [Point<C>; 3],
    ) -> Option<LedMoves<C>> {
        let zero = C::constant(0.0);
        let mut sums = [zero; 3];
        let mut from = (carries, head);
        for (_, Sheave { x, y }, on) in self.each() {
            let still = Point::new(zero, zero);
            let own = Point::new(*x, *y);
            let to = if on < BARS {
                point(on, own)
            } else {
                [own.map(C::of), still, still]
            };
            let [line, v, a] = [0, 1, 2].map(|i| to[i] - from.1[i]);
            let length = plane::length(line);
            if length.value() == 0.0 {
                return None;
            }
            sums[0] += length;
            // Two points of one bar keep their distance.
            if on != from.0 {
                let along = line / length;
                let change = dot(v, along);
                sums[1] += change;
                sums[2] += (squared(v) - change.square()) / length + dot(a, along);
            }
            from = (on, to);
        }
        let falls = C::of(self.falls.m_h);
        let [length, change, further] = sums;
        Some(LedMoves {
            raised: length / falls,
            lead: [
                (-(change.tabled(&s::DL_LED) / falls)).def(&m::DL_R),
                (-(further.tabled(&s::DDL_LED) / falls)).def(&m::DDL_R),
            ],
        })
    }
}

impl<C: Calc> Reeved<C> {
    /// What one newton in the rope does to each bar; `None` where a stretch has no length.
    pub fn hauled(&self, bars: &LedBars<C>) -> Option<[Hauled<C>; BARS]> {
        let mut each = Hauled::nothing();
        self.run(bars, |stretch| haul(&mut each, bars, &stretch)).ok()?;
        Some(each)
    }
}
