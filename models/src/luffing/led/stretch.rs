//! A hoist rope between two sheaves, or from the head to the first one. (derived)

use crate::component::stages::{Found, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::variable::Fault;
use crate::luffing::led::symbols as s;
use crate::luffing::resistances::placed::BARS;
use crate::parts::plane::{self, Point, dot, turned};

quantities! {
    /// A sheave in the frame of its bar, in m.
    Sheave { x: X_R, y: Y_R }
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
    pub fn sheave(&self, on: usize, sheave: &Sheave<C>, number: u16) -> [Point<C>; 2] {
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
pub struct LedStretch<C> {
    /// Its ends, the one towards the head first, and what each of these is on.
    pub ends: [Point<C>; 2],
    pub on: [usize; 2],
    /// Unit vector from the first to the second.
    pub along: Point<C>,
    pub length: C,
    /// Change of its length for one radian of the luffing angle, in m.
    pub change: C,
}
results! { each LedStretch as p => { S_RX: p.ends[1].x; S_RY: p.ends[1].y; L_RS: p.length; } }

impl<C: Calc> LedStretch<C> {
    /// l_r = |S_i − S_(i−1)|, l′_r = (S′_i − S′_(i−1)) · (S_i − S_(i−1)) / l_r, nothing of two on one bar. (derived)
    ///
    /// # Errors
    /// A sheave where the rope comes from.
    pub fn new([from, to]: [[Point<C>; 2]; 2], on: [usize; 2], number: u16) -> Found<LedStretch<C>> {
        let line = to[0] - from[0];
        let length = plane::length(line).def_of(&s::L_RS, number);
        let reach = |point: Point<C>| point.x.value().abs() + point.y.value().abs();
        if length.value() <= 4.0 * f64::EPSILON * (reach(from[0]) + reach(to[0])) {
            return Err(Box::new(Fault::outside(format!(
                "l_rs[{number}] = 0 m: the sheave {number} of the hoist rope is where the rope comes from, there is no line to pull along"
            ))));
        }
        let along = line / length;
        let along = Point::new(along.x.def_of(&s::E_RX, number), along.y.def_of(&s::E_RY, number));
        let change = match on[0] == on[1] {
            true => C::constant(0.0),
            false => dot(to[1] - from[1], along).def_of(&s::DL_RS, number),
        };
        Ok(LedStretch {
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
}
