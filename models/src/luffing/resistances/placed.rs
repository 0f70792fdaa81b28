//! Where everything of a mechanism is that has weight, area or friction, with two derivatives by its luffing angle.

use std::marker::PhantomData;

use num_dual::{Dual2, Dual64, DualNum};

use crate::balance::action::RodLine;
use crate::balance::residual::Residual;
use crate::component::scalar::{EachScalar, Scalar};
use crate::component::stages::{Found, absent};
use crate::kernel::calc::Calc;
use crate::kernel::gravity::G;
use crate::kernel::record::Rec;
use crate::luffing::balancing::Balancing;
use crate::luffing::moving::bodies::Body;
use crate::luffing::resistances::given::{CaseBody, CasesChoice};
use crate::parts::plane::{Point, cross};

/// Most bars of a luffing mechanism, and the place of the counterweight behind them.
pub const BARS: usize = 3;

/// At one position; lengths in m, from the mechanism's origin.
#[derive(Clone, Copy, Debug)]
pub struct Placed<C> {
    /// First joint of each bar and the unit vector along it; a mechanism with fewer has its last one again.
    pub bars: [[Point<C>; 2]; BARS],
    /// Where the load hangs, and its height with the hoist's drum at rest, but for a constant.
    pub head: Point<C>,
    pub load: C,
    pub counterweight: Point<C>,
    /// Way of the drive, as its speed is counted.
    pub way: C,
}

impl<C: Calc> Placed<C> {
    /// With another one, each number with the one in its place.
    pub fn with<D: Calc>(&self, other: &Placed<C>, f: impl Fn(C, C) -> D) -> Placed<D> {
        let both = |one: &Point<C>, other: &Point<C>| one.zip_map(other, &f);
        Placed {
            bars: std::array::from_fn(|i| std::array::from_fn(|j| both(&self.bars[i][j], &other.bars[i][j]))),
            head: both(&self.head, &other.head),
            load: f(self.load, other.load),
            counterweight: both(&self.counterweight, &other.counterweight),
            way: f(self.way, other.way),
        }
    }

    fn map<D: Calc>(&self, f: &mut dyn FnMut(C) -> D) -> Placed<D> {
        Placed {
            bars: self.bars.map(|bar| bar.map(|point| point.map(&mut *f))),
            head: self.head.map(&mut *f),
            load: f(self.load),
            counterweight: self.counterweight.map(&mut *f),
            way: f(self.way),
        }
    }
}

/// A mechanism as its drive feels it.
pub trait Placing: 'static {
    /// What its places follow from, over a scalar.
    type Of<C: Calc>: Clone + Send + Sync;

    /// The bar that is the boom which a balance sees.
    const BALANCED: usize = 0;

    fn map<C: Calc, D: Calc>(of: &Self::Of<C>, f: fn(C) -> D) -> Self::Of<D>;

    /// At a luffing angle (rad); `None` where it does not close.
    fn placed<C: Calc>(of: &Self::Of<C>, at: C) -> Option<Placed<C>>;

    /// With inertias (kg·m²) under gravity (m/s²); nothing in the place of bars that it does not have.
    fn bodies<C: Calc>(of: &Self::Of<C>, inertias: [C; BARS], gravity: C) -> [Body<C>; BARS];

    fn balancing<C: Calc>(of: &Self::Of<C>) -> Option<&Balancing<C>>;

    /// Place of the slewing axis, in m.
    fn axis<C: Calc>(of: &Self::Of<C>) -> C;
}

/// What weighs, at no particular position.
#[derive(Clone, Copy, Debug)]
pub struct Weighty<C> {
    pub bodies: [Body<C>; BARS],
    /// In kg.
    pub counterweight: C,
    /// Place of the slewing axis, in m.
    pub axis: C,
    /// In m/s².
    pub gravity: C,
}

impl<C: Calc> Weighty<C> {
    pub fn new<K: Placing>(of: &K::Of<C>, given: &[CaseBody<C>], choice: &CasesChoice) -> Weighty<C> {
        let gravity = C::known(&G, choice.gravity);
        let mut inertias = [C::constant(0.0); BARS];
        for (body, &on) in given.iter().zip(&choice.bodies).filter(|(_, on)| **on < BARS) {
            inertias[on] += body.j;
        }
        let weight = K::balancing(of).and_then(|balancing| balancing.balance.weight());
        Weighty {
            bodies: K::bodies(of, inertias, gravity),
            counterweight: weight.map_or(C::constant(0.0), |weight| weight / gravity),
            axis: K::axis(of),
            gravity,
        }
    }
}

/// What moves and weighs, at one luffing angle.
#[derive(Clone, Copy, Debug)]
pub struct MovedBars<C> {
    /// Places, and their first and second derivatives.
    pub at: [Placed<C>; 3],
    pub of: Weighty<C>,
    /// Turn of the boom that a balance sees for one radian of the luffing angle, and how it carries a force on its
    /// counterweight; none where that is fixed to the boom.
    pub balanced: C,
    pub line: Option<RodLine<C>>,
}

impl<C: Scalar> MovedBars<C> {
    /// At a luffing angle, in rad.
    ///
    /// # Errors
    /// One at which mechanism or drive do not close.
    pub fn new<K: Placing>(
        of: &K::Of<C>,
        weighty: &Weighty<C>,
        residual: Option<&Residual<C>>,
        angle: C,
    ) -> Found<MovedBars<C>> {
        let at = places::<K, C>(of, angle).ok_or_else(absent)?;
        let mut moved = MovedBars {
            at,
            of: *weighty,
            balanced: C::constant(0.0),
            line: None,
        };
        moved.balanced = moved.turn(K::BALANCED)[0];
        let [place, travel, _] = moved.at.each_ref().map(|placed| placed.counterweight);
        if let Some((balancing, residual)) = K::balancing(of).zip(residual) {
            // Its linkage stands in the chapter of the balance.
            moved.line = C::body(usize::MAX, || {
                balancing.balance.line(residual.phi, place, travel / moved.balanced)
            });
        }
        Ok(moved)
    }
}

impl<C: Calc> MovedBars<C> {
    /// A point of a bar's frame (m): its place and its derivatives.
    pub fn point(&self, bar: usize, at: Point<C>) -> [Point<C>; 3] {
        self.at.each_ref().map(|placed| {
            let [joint, e] = placed.bars[bar];
            joint + Point::new(e.x * at.x - e.y * at.y, e.y * at.x + e.x * at.y)
        })
    }

    /// Of an area or a body: on a bar as [`point`](MovedBars::point), else the counterweight.
    pub fn on(&self, body: usize, at: Point<C>) -> [Point<C>; 3] {
        match body {
            BARS => self.at.each_ref().map(|placed| placed.counterweight),
            bar => self.point(bar, at),
        }
    }

    /// Turn of a bar for one radian of the luffing angle, and its change.
    pub fn turn(&self, bar: usize) -> [C; 2] {
        let [e, d, dd] = self.at.each_ref().map(|placed| placed.bars[bar][1]);
        [cross(e, d), cross(e, dd)]
    }
}

/// Places of a mechanism and their two derivatives by the luffing angle, at an angle (rad); `None` where it does not close.
pub fn places<K: Placing, C: Scalar>(of: &K::Of<C>, at: C) -> Option<[Placed<C>; 3]> {
    C::own::<Twice<K>>()(of, at)
}

/// Each scalar has derivatives by the luffing angle in its own way.
struct Twice<K>(PhantomData<K>);

/// Places with their derivatives, of what they follow from, at an angle (rad).
type Finds<K, C> = fn(&<K as Placing>::Of<C>, C) -> Option<[Placed<C>; 3]>;

impl<K: Placing> EachScalar for Twice<K> {
    type For<C: Calc> = Finds<K, C>;
    fn plain() -> Finds<K, f64> {
        by_duals::<K, f64>
    }
    fn dual() -> Finds<K, Dual64> {
        by_duals::<K, Dual64>
    }
    fn recorded() -> Finds<K, Rec> {
        by_names::<K>
    }
}

fn by_duals<K: Placing, T: Calc + DualNum>(of: &K::Of<T>, at: T) -> Option<[Placed<T>; 3]> {
    let of = K::map(of, Dual2::<T>::from_re);
    let found = K::placed(&of, Dual2::new(at, T::constant(1.0), T::constant(0.0)))?;
    Some([
        found.map(&mut |x| x.re),
        found.map(&mut |x| x.v1),
        found.map(&mut |x| x.v2),
    ])
}

/// What derivatives give has no formula of its own; it follows from what the places follow from.
fn by_names<K: Placing>(of: &K::Of<Rec>, at: Rec) -> Option<[Placed<Rec>; 3]> {
    let values = by_duals::<K, f64>(&K::map(of, |x: Rec| x.value()), at.value())?;
    let mut each = values.map(|placed| {
        let mut all = Vec::new();
        placed.map(&mut |x| {
            all.push(x);
            x
        });
        all.into_iter()
    });
    let mut next = |order: usize| each[order].next().expect("as many as there are");
    let place = Rec::body(usize::MAX, || K::placed(of, at))?;
    let place = place.map(&mut |x| x.rounded_as(next(0)));
    let travel = place.map(&mut |x| x.derivative(at, next(1)));
    let bend = travel.map(&mut |x| x.derivative(at, next(2)));
    Some([place, travel, bend])
}
