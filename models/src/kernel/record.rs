//! The recorder: running an equation with [`Rec`] writes down the formula,
//! its values and its dimensions instead of only computing it. The book's
//! formulas come from here and from nowhere else.

use std::cell::RefCell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_dual::Dual64;

use crate::kernel::calc::{Among, Calc, Takes};
use crate::kernel::powers::Powers;
use crate::kernel::symbol::Symbol;

/// An operation of a recorded formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Op {
    Add,
    Sub,
    Mul,
    Div,
    Neg,
    Abs,
    Square,
    Sqrt,
    /// To a power that is a fraction.
    Power([u8; 2]),
    Sin,
    Cos,
    Asin,
    Acos,
    /// Angle of a vector: the second operand is y.
    Direction,
    /// How the first operand changes with the second.
    Derivative,
    Among(Among),
}

/// A formula as a tree; a name stands for the formula that defined it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node {
    Constant(f64),
    Name(&'static Symbol),
    Unary(Op, Rec),
    Binary(Op, Rec, Rec),
}

/// A named result: `symbol` = `formula`.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub symbol: &'static Symbol,
    /// From 1, where it is one of several that are all told of.
    pub number: Option<u16>,
    pub formula: Rec,
    /// In SI.
    pub value: f64,
    /// The result under its name, for later formulas.
    pub name: Rec,
}

#[derive(Clone, Copy)]
struct Entry {
    node: Node,
    value: f64,
    dimension: Powers,
}

/// What a run of equations left behind.
#[derive(Clone, Default)]
pub struct Trace {
    entries: Vec<Entry>,
    pub steps: Vec<Step>,
    /// Every dimensional inconsistency met, in words.
    pub faults: Vec<String>,
    /// What a value follows from that its own node does not show, in the order of the values.
    behind: Vec<(Rec, Rec)>,
    /// The body whose equations are written down, where they are not those of all; whether another one's run.
    only: Option<usize>,
    silent: bool,
}

thread_local! {
    // `Rec` must be `Copy` and `'static` to be a scalar of nalgebra, so it is an
    // index and the arena lies beside it. Only the recorder uses it: no value of
    // a running simulation does.
    static TRACE: RefCell<Trace> = RefCell::default();
}

/// Runs `equations` under the recorder. Nested recordings are not possible.
pub fn record<T>(equations: impl FnOnce() -> T) -> (Trace, T) {
    TRACE.take();
    let result = equations();
    (TRACE.take(), result)
}

/// Of several bodies the running recording writes down the equations of one, numbered from 0; without one of all.
pub fn only(body: Option<usize>) {
    TRACE.with_borrow_mut(|trace| trace.only = body);
}

/// How many steps the running recording has so far.
#[must_use]
pub fn steps() -> usize {
    TRACE.with_borrow(|trace| trace.steps.len())
}

impl Trace {
    #[must_use]
    pub fn node(&self, rec: Rec) -> Node {
        self.entries[rec.0 as usize].node
    }

    /// Value in SI.
    #[must_use]
    pub fn value(&self, rec: Rec) -> f64 {
        self.entries[rec.0 as usize].value
    }

    /// The given quantities that each formula contains, named steps followed to their own formulas.
    #[must_use]
    pub fn givens(&self) -> Givens {
        // What an entry is made of stands before it.
        let (mut steps, mut behind) = (self.steps.iter().peekable(), self.behind.iter().peekable());
        let (mut parts, mut leaves) = (Vec::with_capacity(2 * self.entries.len()), Vec::new());
        for (index, entry) in self.entries.iter().enumerate() {
            let before = parts.len();
            while let Some((_, other)) = behind.next_if(|(known, _)| known.0 as usize == index) {
                parts.push((index, *other));
            }
            match entry.node {
                Node::Constant(_) => {}
                Node::Name(_) => match steps.next_if(|step| step.name.0 as usize == index) {
                    Some(step) => parts.push((index, step.formula)),
                    None if parts.len() == before => leaves.push(index),
                    None => {}
                },
                Node::Unary(_, a) => parts.push((index, a)),
                Node::Binary(_, a, b) => parts.extend([(index, a), (index, b)]),
            }
        }
        let words = leaves.len().div_ceil(64);
        let mut sets = vec![0; words * self.entries.len()];
        for (place, index) in leaves.iter().enumerate() {
            sets[index * words + place / 64] |= 1 << (place % 64);
        }
        for (whole, part) in parts {
            let (before, own) = sets.split_at_mut(whole * words);
            let part = &before[part.0 as usize * words..][..words];
            for (own, part) in own.iter_mut().zip(part) {
                *own |= part;
            }
        }
        Givens { leaves, words, sets }
    }

    /// The same with these steps alone: names of others stand for values found before.
    #[must_use]
    pub fn part(&self, steps: std::ops::Range<usize>) -> Trace {
        Trace {
            steps: self.steps[steps].to_vec(),
            ..self.clone()
        }
    }

    /// Adds the quantities that an expression names, each once.
    pub fn names(&self, rec: Rec, found: &mut Vec<&'static Symbol>) {
        match self.node(rec) {
            Node::Constant(_) => {}
            Node::Name(symbol) if found.contains(&symbol) => {}
            Node::Name(symbol) => found.push(symbol),
            Node::Unary(_, inner) => self.names(inner, found),
            Node::Binary(_, left, right) => [left, right].into_iter().for_each(|side| self.names(side, found)),
        }
    }

    fn is(&self, rec: Rec, number: f64) -> bool {
        self.node(rec) == Node::Constant(number)
    }

    fn push(&mut self, node: Node, value: f64, dimension: Powers) -> Rec {
        self.entries.push(Entry { node, value, dimension });
        Rec(u32::try_from(self.entries.len() - 1).expect("a book has far fewer than 2^32 terms"))
    }

    /// A name for a value.
    fn name(&mut self, rec: Rec, symbol: &'static Symbol) -> Rec {
        let Entry { value, dimension, .. } = self.entries[rec.0 as usize];
        let own = Powers::of(symbol.unit.dimension);
        if dimension != own {
            self.fault(format!("{} is in {own}, its formula in {dimension}", symbol.id));
        }
        self.push(Node::Name(symbol), value, own)
    }

    fn fault(&mut self, text: String) {
        let after = self.steps.last().map_or("the start", |step| step.symbol.id);
        self.faults.push(format!("{text} (after {after})"));
    }
}

/// The given quantities that each formula of a trace contains.
pub struct Givens {
    /// Where they stand in the trace.
    leaves: Vec<usize>,
    /// A set for each entry: a bit for each of the leaves, in so many words.
    words: usize,
    sets: Vec<u64>,
}

impl Givens {
    /// The given quantities, in the order in which they were given.
    pub fn all(&self) -> impl Iterator<Item = Rec> + '_ {
        let rec = |&leaf| Rec(u32::try_from(leaf).expect("a place in the trace"));
        self.leaves.iter().map(rec)
    }

    /// Those that a formula contains, by their places among [`all`](Givens::all).
    pub fn of(&self, rec: Rec) -> impl Iterator<Item = usize> + '_ {
        let set = &self.sets[rec.0 as usize * self.words..][..self.words];
        (0..self.leaves.len()).filter(|leaf| set[leaf / 64] >> (leaf % 64) & 1 == 1)
    }
}

/// The recording scalar: an index into the running [`Trace`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rec(u32);

impl Rec {
    /// A given quantity, in SI.
    #[must_use]
    pub fn given(symbol: &'static Symbol, value: f64) -> Rec {
        let dimension = Powers::of(symbol.unit.dimension);
        TRACE.with_borrow_mut(|trace| trace.push(Node::Name(symbol), value, dimension))
    }

    /// How this changes with an angle, where that was found by dual numbers.
    #[must_use]
    pub fn derivative(self, by: Rec, value: f64) -> Rec {
        self.binary(Op::Derivative, by, value)
    }

    /// The same formula with the bits of the running model, which has them from dual numbers: another rounding.
    #[must_use]
    pub fn rounded_as(self, value: f64) -> Rec {
        TRACE.with_borrow_mut(|trace| {
            let Entry { node, dimension, .. } = trace.entries[self.0 as usize];
            let same = trace.push(node, value, dimension);
            // A name has nothing else that it follows from.
            trace.behind.push((same, self));
            same
        })
    }

    fn unary(self, op: Op, value: f64) -> Rec {
        TRACE.with_borrow_mut(|trace| {
            if trace.is(self, 0.0) && matches!(op, Op::Neg | Op::Abs | Op::Square | Op::Sqrt) {
                return self;
            }
            let given = trace.entries[self.0 as usize].dimension;
            let dimension = match op {
                Op::Neg | Op::Abs | Op::Among(_) => given,
                Op::Square => given.times(given),
                Op::Sqrt => Powers(given.0.root().unwrap_or_else(|| {
                    trace.fault(format!("square root of {given}"));
                    given.0
                })),
                Op::Power(exponent) => given.raised(exponent).unwrap_or_else(|| {
                    trace.fault(format!("{given} to the power of {exponent:?}"));
                    given
                }),
                _ => {
                    if given != Powers::ONE {
                        trace.fault(format!("{op:?} of {given}"));
                    }
                    Powers::ONE
                }
            };
            trace.push(Node::Unary(op, self), value, dimension)
        })
    }

    /// A plain nought, which has every dimension, is not written down, nor is a factor of one: what a case
    /// distinction leaves out leaves no trace in the formula.
    fn binary(self, op: Op, other: Rec, value: f64) -> Rec {
        TRACE.with_borrow_mut(|trace| {
            match op {
                Op::Add if trace.is(self, 0.0) => return other,
                Op::Add | Op::Sub if trace.is(other, 0.0) => return self,
                Op::Sub if trace.is(self, 0.0) => {
                    let dimension = trace.entries[other.0 as usize].dimension;
                    return trace.push(Node::Unary(Op::Neg, other), value, dimension);
                }
                Op::Mul | Op::Div if trace.is(self, 0.0) => return self,
                Op::Mul if trace.is(other, 0.0) || trace.is(self, 1.0) => return other,
                Op::Mul | Op::Div if trace.is(other, 1.0) => return self,
                _ => {}
            }
            let (left, right) = (
                trace.entries[self.0 as usize].dimension,
                trace.entries[other.0 as usize].dimension,
            );
            let dimension = match op {
                Op::Mul => left.times(right),
                Op::Div | Op::Derivative => left.over(right),
                _ => {
                    if left != right {
                        trace.fault(format!("{op:?} of {left} and {right}"));
                    }
                    if op == Op::Direction { Powers::ONE } else { left }
                }
            };
            trace.push(Node::Binary(op, self, other), value, dimension)
        })
    }
}

macro_rules! operators {
    ($($trait:ident $function:ident $assign_trait:ident $assign:ident $symbol:tt;)*) => {$(
        impl $trait for Rec {
            type Output = Rec;
            fn $function(self, other: Rec) -> Rec {
                self.binary(Op::$trait, other, self.value() $symbol other.value())
            }
        }
        impl $assign_trait for Rec {
            fn $assign(&mut self, other: Rec) {
                *self = *self $symbol other;
            }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign +;
    Sub sub SubAssign sub_assign -;
    Mul mul MulAssign mul_assign *;
    Div div DivAssign div_assign /;
}

impl Neg for Rec {
    type Output = Rec;
    fn neg(self) -> Rec {
        self.unary(Op::Neg, -self.value())
    }
}

impl Takes<Rec> for Rec {
    fn of(parameter: Rec) -> Rec {
        parameter
    }
}

/// What no formula is written of: the values alone.
impl Takes<Rec> for f64 {
    fn of(parameter: Rec) -> f64 {
        parameter.value()
    }
}

impl Takes<Rec> for Dual64 {
    fn of(parameter: Rec) -> Dual64 {
        Dual64::constant(parameter.value())
    }
}

/// Runs equations, written down or not.
fn held<T>(silent: bool, equations: impl FnOnce() -> T) -> T {
    let hold = |silent| TRACE.with_borrow_mut(|trace| std::mem::replace(&mut trace.silent, silent));
    let before = hold(silent);
    let found = equations();
    hold(before);
    found
}

impl Calc for Rec {
    fn constant(value: f64) -> Rec {
        TRACE.with_borrow_mut(|trace| trace.push(Node::Constant(value), value, Powers::ONE))
    }
    fn known(symbol: &'static Symbol, value: f64) -> Rec {
        Rec::given(symbol, value)
    }
    fn value(self) -> f64 {
        TRACE.with_borrow(|trace| trace.value(self))
    }
    fn square(self) -> Rec {
        self.unary(Op::Square, self.value().square())
    }
    fn abs(self) -> Rec {
        self.unary(Op::Abs, self.value().abs())
    }
    fn sqrt(self) -> Rec {
        self.unary(Op::Sqrt, self.value().sqrt())
    }
    fn sin(self) -> Rec {
        self.unary(Op::Sin, Calc::sin(self.value()))
    }
    fn sin_cos(self) -> (Rec, Rec) {
        let (sin, cos) = Calc::sin_cos(self.value());
        (self.unary(Op::Sin, sin), self.unary(Op::Cos, cos))
    }
    fn asin(self) -> Rec {
        self.unary(Op::Asin, Calc::asin(self.value()))
    }
    fn acos(self) -> Rec {
        self.unary(Op::Acos, Calc::acos(self.value()))
    }
    fn power(self, exponent: [u8; 2]) -> Rec {
        self.unary(Op::Power(exponent), self.value().power(exponent))
    }
    fn direction(x: Rec, y: Rec) -> Rec {
        x.binary(Op::Direction, y, f64::direction(x.value(), y.value()))
    }
    fn minus_exact(self, other: Rec, tail: f64) -> Rec {
        self.binary(Op::Sub, other, self.value().minus_exact(other.value(), tail))
    }
    fn def(self, symbol: &'static Symbol) -> Rec {
        TRACE.with_borrow_mut(|trace| {
            if trace.is(self, 0.0) || trace.silent {
                return self;
            }
            let name = trace.name(self, symbol);
            trace.steps.push(Step {
                symbol,
                number: None,
                formula: self,
                value: trace.value(name),
                name,
            });
            name
        })
    }
    fn def_of(self, symbol: &'static Symbol, number: u16) -> Rec {
        let name = self.def(symbol);
        TRACE.with_borrow_mut(|trace| {
            let own = trace.steps.last_mut().filter(|step| step.name == name);
            own.into_iter().for_each(|step| step.number = Some(number));
        });
        if name == self { self } else { name.numbered(number) }
    }
    fn tabled(self, symbol: &'static Symbol) -> Rec {
        TRACE.with_borrow_mut(|trace| {
            if trace.is(self, 0.0) {
                return self;
            }
            let name = trace.name(self, symbol);
            trace.behind.push((name, self));
            name
        })
    }
    fn among(self, which: Among, one: Rec) -> Rec {
        let found = one.unary(Op::Among(which), self.value());
        TRACE.with_borrow_mut(|trace| trace.behind.push((found, self)));
        found
    }
    fn over(self, other: Rec) -> Rec {
        TRACE.with_borrow_mut(|trace| {
            let Entry { node, value, dimension } = trace.entries[self.0 as usize];
            let same = trace.push(node, value, dimension);
            trace.behind.extend([(same, self), (same, other)]);
            same
        })
    }
    fn body<T>(number: usize, equations: impl FnOnce() -> T) -> T {
        let other = TRACE.with_borrow(|trace| trace.only.is_some_and(|only| only != number));
        held(other, equations)
    }
    fn aside<T>(equations: impl FnOnce() -> T) -> T {
        held(true, equations)
    }
}
