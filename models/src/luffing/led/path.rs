//! Where a hoist rope runs that is led from the head over sheaves to the frame, and how the load rises by it. [Ports001, 5.9.2.4]
//!
//! ```text
//!       S_1 o────────────o A        L_r = |A S_1| + |S_1 S_2| + …
//!          /  (on a bar) ‖ m_h falls
//!     S_2 o (on the      Q
//!             frame)
//! ```
//!
//! Sheaves are points: the arcs on which the rope lies on them are left out.

use crate::component::stages::{Found, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::kernel::variable::Fault;
use crate::luffing::resistances::placed::BARS;
use crate::parts::plane::{self, Point, dot, turned};

/// Quantities of the led rope and of the tackle that carries the load.
mod s {
    pub use crate::luffing::led::symbols::*;
    pub use crate::luffing::moving::symbols::{DY_Q, M_H};
}

/// Most sheaves of a led rope.
pub const MOST: usize = 6;

quantities! {
    /// Falls of the hoist tackle, and how far below the head the load begins (m).
    LedFalls { m_h: M_H, h_q: H_Q }
}

quantities! {
    /// A sheave in the frame of its bar, in m.
    Sheave { x: X_R, y: Y_R }
}

/// What each sheave is on: a bar by its number, or the frame behind them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Leading(pub [usize; MOST]);
group!(Leading);

/// A rope as it is reeved.
#[derive(Clone, Copy, Debug)]
pub struct Reeved<C> {
    pub falls: LedFalls<C>,
    sheaves: [Sheave<C>; MOST],
    count: usize,
    leading: Leading,
}

impl<C: Calc> Reeved<C> {
    pub fn new(falls: &LedFalls<C>, sheaves: &[Sheave<C>], leading: &Leading) -> Reeved<C> {
        let zero = C::constant(0.0);
        let none = Sheave { x: zero, y: zero };
        Reeved {
            falls: *falls,
            sheaves: std::array::from_fn(|place| sheaves.get(place).copied().unwrap_or(none)),
            count: sheaves.len(),
            leading: *leading,
        }
    }

    /// Over another scalar.
    #[must_use]
    pub fn map<D>(&self, f: impl Fn(C) -> D) -> Reeved<D> {
        Reeved {
            falls: self.falls.map(&mut |_, x| f(x)),
            sheaves: self.sheaves.each_ref().map(|sheave| sheave.map(&mut |_, x| f(x))),
            count: self.count,
            leading: self.leading,
        }
    }

    /// Its sheaves by their numbers, from 1, and what each is on.
    pub(super) fn each(&self) -> impl Iterator<Item = (u16, &Sheave<C>, usize)> {
        let each = (1..).zip(&self.sheaves).zip(self.leading.0);
        each.map(|((number, sheave), on)| (number, sheave, on)).take(self.count)
    }

    /// Whether each sheave is on the frame.
    pub fn fixed(&self) -> impl Iterator<Item = bool> {
        self.each().map(|(_, _, on)| on >= BARS)
    }

    /// What the rope runs over, in the order in which it runs from the head.
    ///
    /// # Errors
    /// A sheave where the rope comes from.
    pub(super) fn run(&self, bars: &LedBars<C>, mut each: impl FnMut(Stretch<C>)) -> Found<()> {
        let (mut from, mut carried) = ([bars.head, bars.travel], bars.carries);
        for (number, sheave, on) in self.each() {
            let to = bars.sheave(on, sheave, number);
            each(Stretch::new([from, to], [carried, on], number)?);
            (from, carried) = (to, on);
        }
        Ok(())
    }

    /// Its length from the head to the frame, in m, over the falls of its tackle.
    ///
    /// # Errors
    /// As [`Stretch::all`].
    pub fn raised(&self, bars: &LedBars<C>) -> Found<C> {
        Ok(self.sum(bars, |stretch| stretch.length)? / self.falls.m_h)
    }

    /// How that changes for one radian of the luffing angle, in m.
    ///
    /// # Errors
    /// As [`Stretch::all`].
    pub fn rises(&self, bars: &LedBars<C>) -> Found<C> {
        Ok(self.sum(bars, |stretch| stretch.change)? / self.falls.m_h)
    }

    fn sum(&self, bars: &LedBars<C>, of: fn(&Stretch<C>) -> C) -> Found<C> {
        let mut sum = C::constant(0.0);
        self.run(bars, |stretch| sum += of(&stretch))?;
        Ok(sum)
    }
}

/// The bars that lead a rope at one position, and the head that it comes from: lengths in m, moves for one radian of the
/// luffing angle.
#[derive(Clone, Copy, Debug)]
pub struct LedBars<C> {
    /// First joint of each, and the unit vector along it.
    pub at: [[Point<C>; 2]; BARS],
    /// Travel of that joint, and turn.
    pub moves: [(Point<C>, C); BARS],
    pub head: Point<C>,
    pub travel: Point<C>,
    /// The bar that carries it.
    pub carries: usize,
}

impl<C: Calc> LedBars<C> {
    /// At rest, with the head that a bar carries.
    pub fn still(at: [[Point<C>; 2]; BARS], (carries, head): (usize, Point<C>)) -> LedBars<C> {
        let zero = C::constant(0.0);
        let still = Point::new(zero, zero);
        LedBars {
            at,
            moves: [(still, zero); BARS],
            head,
            travel: still,
            carries,
        }
    }

    /// Place and travel of a sheave.
    fn sheave(&self, on: usize, sheave: &Sheave<C>, number: u16) -> [Point<C>; 2] {
        let own = Point::new(sheave.x.numbered(number), sheave.y.numbered(number));
        let zero = C::constant(0.0);
        let (place, travel) = match self.at.get(on) {
            None => (own, Point::new(zero, zero)),
            Some([joint, along]) => {
                let (arm, (travel, turn)) = (turned(*along, own.x, own.y), self.moves[on]);
                (joint + arm, travel + Point::new(-(turn * arm.y), turn * arm.x))
            }
        };
        [
            Point::new(place.x.def_of(&s::S_RX, number), place.y.def_of(&s::S_RY, number)),
            travel,
        ]
    }
}

/// The rope before a sheave, from the sheave before or the head.
#[derive(Clone, Copy, Debug)]
pub struct Stretch<C> {
    /// Its ends, the one towards the head first, and what each of these is on.
    pub ends: [Point<C>; 2],
    pub on: [usize; 2],
    /// Unit vector from the first to the second.
    pub along: Point<C>,
    length: C,
    /// Change of its length for one radian of the luffing angle, in m.
    change: C,
}
results! { each Stretch as p => { S_RX: p.ends[1].x; S_RY: p.ends[1].y; L_RI: p.length; } }

impl<C: Calc> Stretch<C> {
    /// l_r = |S_i − S_(i−1)|, l′_r = (S′_i − S′_(i−1)) · (S_i − S_(i−1)) / l_r, nothing of two on one bar. (derived)
    ///
    /// # Errors
    /// A sheave where the rope comes from.
    fn new([from, to]: [[Point<C>; 2]; 2], on: [usize; 2], number: u16) -> Found<Stretch<C>> {
        let line = to[0] - from[0];
        let length = plane::length(line).def_of(&s::L_RI, number);
        let reach = |point: Point<C>| point.x.value().abs() + point.y.value().abs();
        if length.value() <= 4.0 * f64::EPSILON * (reach(from[0]) + reach(to[0])) {
            return Err(Box::new(Fault::outside(format!(
                "l_r[{number}] = 0 m: the sheave {number} of the hoist rope is where the rope comes from, there is no line to pull along"
            ))));
        }
        let along = line / length;
        let along = Point::new(along.x.def_of(&s::E_RX, number), along.y.def_of(&s::E_RY, number));
        let change = match on[0] == on[1] {
            true => C::constant(0.0),
            false => dot(to[1] - from[1], along).def_of(&s::DL_RI, number),
        };
        Ok(Stretch {
            ends: [from[0], to[0]],
            on,
            along,
            length,
            change,
        })
    }

    /// Its sheave, in m.
    pub fn place(&self) -> Point<C> {
        self.ends[1]
    }

    /// All of them, in the order in which the rope runs from the head.
    ///
    /// # Errors
    /// A sheave where the rope comes from.
    pub fn all(reeved: &Reeved<C>, bars: &LedBars<C>, room: &mut Vec<Stretch<C>>) -> Found<()> {
        room.clear();
        reeved.run(bars, |stretch| room.push(stretch))
    }
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
    /// As [`Stretch::all`].
    pub fn new(reeved: &Reeved<C>, bars: &LedBars<C>) -> Found<LedStart<C>> {
        let falls = &reeved.falls;
        let length = C::body(usize::MAX, || reeved.sum(bars, |stretch| stretch.length))?.tabled(&s::L_LEDA);
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
    pub fn new(reeved: &Reeved<C>, start: &LedStart<C>, bars: &LedBars<C>, stretched: &[Stretch<C>]) -> LedRope<C> {
        let falls = &reeved.falls;
        let all = |of: fn(&Stretch<C>) -> C| stretched.iter().map(of).fold(C::constant(0.0), |sum, one| sum + one);
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
