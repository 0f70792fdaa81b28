//! Where a hoist rope runs that is led from the head over sheaves to the frame. [Ports001, 5.9.2.4]
//!
//! ```text
//!       S_1 o────────────o A        L_r = |A S_1| + |S_1 S_2| + …
//!          /  (on a bar) ‖ m_h falls
//!     S_2 o (on the      Q
//!             frame)
//! ```
//!
//! Sheaves are points: the arcs on which the rope lies on them are left out.

use crate::component::stages::Found;
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::luffing::led::stretch::{LedBars, LedStretch, Sheave};
use crate::luffing::resistances::placed::BARS;

/// Quantities of the led rope and of the tackle that carries the load.
mod s {
    pub use crate::luffing::led::symbols::*;
    pub use crate::luffing::moving::symbols::M_H;
}

/// Most sheaves of a led rope.
pub const MOST: usize = 6;

quantities! {
    /// Falls of the hoist tackle, and how far below the head the load begins (m).
    LedFalls { m_h: M_H, h_q: H_Q }
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

    /// Hands on each stretch, in the order in which the rope runs from the head.
    ///
    /// # Errors
    /// As [`LedStretch::new`].
    pub(super) fn run(&self, bars: &LedBars<C>, mut each: impl FnMut(LedStretch<C>)) -> Found<()> {
        let (mut from, mut carried) = ([bars.head, bars.travel], bars.carries);
        for (number, sheave, on) in self.each() {
            let to = bars.sheave(on, sheave, number);
            each(LedStretch::new([from, to], [carried, on], number)?);
            (from, carried) = (to, on);
        }
        Ok(())
    }

    /// All of them, put where the last ones lay.
    ///
    /// # Errors
    /// As [`LedStretch::new`].
    pub fn stretches(&self, bars: &LedBars<C>, room: &mut Vec<LedStretch<C>>) -> Found<()> {
        room.clear();
        self.run(bars, |stretch| room.push(stretch))
    }

    /// Its length from the head to the frame, in m, over the falls of its tackle.
    ///
    /// # Errors
    /// As [`LedStretch::new`].
    pub fn raised(&self, bars: &LedBars<C>) -> Found<C> {
        Ok(self.sum(bars, |stretch| stretch.length)? / self.falls.m_h)
    }

    /// How that changes for one radian of the luffing angle, in m.
    ///
    /// # Errors
    /// As [`LedStretch::new`].
    pub fn rises(&self, bars: &LedBars<C>) -> Found<C> {
        Ok(self.sum(bars, |stretch| stretch.change)? / self.falls.m_h)
    }

    pub(super) fn sum(&self, bars: &LedBars<C>, of: fn(&LedStretch<C>) -> C) -> Found<C> {
        let mut sum = C::constant(0.0);
        self.run(bars, |stretch| sum += of(&stretch))?;
        Ok(sum)
    }
}
