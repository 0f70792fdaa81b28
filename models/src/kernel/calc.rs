//! The scalar that every equation is written over. Which scalar it runs with
//! decides what comes out: `f64` the value, `Dual64` also its exact
//! derivative, [`Rec`](crate::kernel::record::Rec) the printed formula.
//!
//! This file is the one door to transcendental functions: they come from
//! `libm`, which gives the same bits on every platform, where `std` does not.

use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Scalar};
use num_dual::{Dual2, Dual64, DualNum};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::{Mul, Neg};

use crate::kernel::symbol::Symbol;

/// A number that mechanism equations can be evaluated with.
pub trait Calc:
    Scalar
    + Copy
    + Send
    + Sync
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
    + Neg<Output = Self>
    + Takes<Self>
{
    /// A plain number without dimension.
    fn constant(value: f64) -> Self;

    /// A plain number with a unit, in SI: in the book it has a name.
    #[must_use]
    fn known(_: &'static Symbol, value: f64) -> Self {
        Self::constant(value)
    }

    /// The value alone, for a decision that the book names in words.
    fn value(self) -> f64;

    fn abs(self) -> Self;
    fn sqrt(self) -> Self;
    fn sin(self) -> Self;
    /// Sine and cosine of an angle in rad.
    fn sin_cos(self) -> (Self, Self);
    fn asin(self) -> Self;
    fn acos(self) -> Self;

    /// Angle of the vector (x, y) from the x axis, counter-clockwise, in rad,
    /// in (−π/2, 3π/2]: continuous for every bar that does not hang straight down.
    fn direction(x: Self, y: Self) -> Self;

    /// `self` − `other`, with `other` known to twice the working precision as
    /// `other` + `tail`: exact where the two nearly cancel.
    fn minus_exact(self, other: Self, tail: f64) -> Self;

    /// To a power that is a fraction of whole numbers; this is not negative, and above zero where the power is below one.
    #[must_use]
    fn power(self, exponent: [u8; 2]) -> Self;

    #[must_use]
    fn square(self) -> Self {
        self * self
    }

    /// The product with a plain number.
    #[inline]
    #[must_use]
    fn scaled(self, factor: f64) -> Self {
        Self::constant(factor) * self
    }

    /// A function of this number: with many derivatives it runs on one, by the chain rule.
    #[inline]
    #[must_use]
    fn through(self, f: impl Function) -> Self {
        f.at(self)
    }

    /// Names a result: nothing for numbers, a line in the book for the recorder.
    #[must_use]
    fn def(self, _: &'static Symbol) -> Self {
        self
    }

    /// Names a sum whose terms stand in a table of the book: nothing for numbers, for the recorder a name without a line.
    #[must_use]
    fn tabled(self, _: &'static Symbol) -> Self {
        self
    }

    /// This number, which was found among the values of many bodies; the second one is what it was of each of them.
    #[must_use]
    fn among(self, _: Among, _: Self) -> Self {
        self
    }

    /// This number, where another one has decided that it is this one: it follows from both.
    #[must_use]
    fn over(self, _: Self) -> Self {
        self
    }

    /// The greater of two, the first of equals.
    #[inline]
    #[must_use]
    fn greater(self, other: Self) -> Self {
        if other.value() > self.value() {
            other.over(self)
        } else {
            self.over(other)
        }
    }

    /// The smaller of two, the first of equals.
    #[inline]
    #[must_use]
    fn smaller(self, other: Self) -> Self {
        if other.value() < self.value() {
            other.over(self)
        } else {
            self.over(other)
        }
    }

    /// This number under a name that stands for one of several, numbered from 1.
    #[inline]
    fn def_of(self, _: &'static Symbol, _: u16) -> Self {
        self
    }

    /// A given number that is one of several, numbered from 1.
    #[inline]
    fn numbered(self, number: u16) -> Self {
        self.among(Among::Of(number), self)
    }

    /// Runs the equations of one of several bodies, numbered from 0. The recorder writes down those of the body that it
    /// was asked for.
    #[inline]
    fn body<T>(_: usize, equations: impl FnOnce() -> T) -> T {
        equations()
    }

    /// Runs equations of which the recorder writes down none.
    #[inline]
    fn aside<T>(equations: impl FnOnce() -> T) -> T {
        equations()
    }
}

/// The sum of what each body adds; nothing of none.
pub fn sum<C: Calc>(mut each: impl Iterator<Item = C>) -> C {
    let Some(first) = each.next() else {
        return C::constant(0.0);
    };
    each.fold(first, |sum, one| sum + one).among(Among::Sum, first)
}

/// What is found among the values of many bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Among {
    Greatest,
    Least,
    Sum,
    /// That of the body with this number, from 1.
    Of(u16),
}

/// What a number known as `P` is in this scalar.
pub trait Takes<P>: Sized + Mul<Output = Self> {
    fn of(parameter: P) -> Self;

    /// The product with a parameter.
    #[inline]
    #[must_use]
    fn times(self, parameter: P) -> Self {
        Self::of(parameter) * self
    }
}

/// A scalar that equations run on while their parameters are known as `P`: plain numbers are constants,
/// dual numbers bring derivatives of their own.
pub trait Over<P>: Calc + Takes<P> {}

impl<P, C: Calc + Takes<P>> Over<P> for C {}

/// A function of one number, over any scalar.
pub trait Function {
    fn at<C: Calc>(&self, x: C) -> C;
}

impl<C: Calc> Takes<f64> for C {
    #[inline]
    fn of(parameter: f64) -> C {
        C::constant(parameter)
    }
    #[inline]
    fn times(self, parameter: f64) -> C {
        self.scaled(parameter)
    }
}

impl Takes<Dual64> for Dual64 {
    #[inline]
    fn of(parameter: Dual64) -> Dual64 {
        parameter
    }
}

/// A number to a power that is a fraction: by roots where these do, which take a tenth of the time.
fn raised(x: f64, exponent: [u8; 2]) -> f64 {
    match exponent {
        [1, 3] => libm::cbrt(x),
        [0, _] => 1.0,
        [1, 2] => x.sqrt(),
        [1, 9] => ninth_root(x),
        [above, below @ (2 | 9)] if above == below + 1 => x * raised(x, [1, below]),
        [above, below] => libm::pow(x, f64::from(above) / f64::from(below)),
    }
}

/// Of a number that is not negative. A ninth part of its bits is within 4 per cent; each step then takes four terms of the
/// binomial series of (1 + apart)^(1/9).
fn ninth_root(x: f64) -> f64 {
    // The bits of one less a ninth part of them, less what the line between powers of two is off by in the mean.
    const ONE: u64 = (1023 << 52) / 9 * 8 - (1 << 52) / 26;
    if !x.is_normal() {
        return libm::pow(x, 1.0 / 9.0);
    }
    let mut root = f64::from_bits(x.to_bits() / 9 + ONE);
    for _ in 0..2 {
        let cube = root * root * root;
        let ninth = cube * cube * cube;
        let apart = (x - ninth) / ninth;
        let [second, third, fourth] = [4.0 / 81.0, 68.0 / 2187.0, 442.0 / 19683.0];
        root += root * apart * (1.0 / 9.0 - apart * (second - apart * (third - apart * fourth)));
    }
    root
}

/// Moves an angle from (−π, π] to (−π/2, 3π/2].
#[inline]
fn upright(angle: f64) -> f64 {
    if angle <= -FRAC_PI_2 { angle + TAU } else { angle }
}

impl Calc for f64 {
    #[inline]
    fn constant(value: f64) -> f64 {
        value
    }
    #[inline]
    fn value(self) -> f64 {
        self
    }
    #[inline]
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    #[inline]
    fn sqrt(self) -> f64 {
        // IEEE 754 rounds a square root correctly: the same bits everywhere.
        f64::sqrt(self)
    }
    #[inline]
    fn sin(self) -> f64 {
        libm::sin(self)
    }
    #[inline]
    fn sin_cos(self) -> (f64, f64) {
        libm::sincos(self)
    }
    #[inline]
    fn asin(self) -> f64 {
        libm::asin(self)
    }
    #[inline]
    fn acos(self) -> f64 {
        libm::acos(self)
    }
    #[inline]
    fn power(self, exponent: [u8; 2]) -> f64 {
        raised(self, exponent)
    }
    #[inline]
    fn direction(x: f64, y: f64) -> f64 {
        upright(libm::atan2(y, x))
    }
    #[inline]
    fn minus_exact(self, other: f64, tail: f64) -> f64 {
        (self - other) - tail
    }
}

impl Calc for Dual64 {
    fn constant(value: f64) -> Dual64 {
        Dual64::from_re(value)
    }
    fn value(self) -> f64 {
        self.re
    }
    fn abs(self) -> Dual64 {
        if self.re < 0.0 { -self } else { self }
    }
    fn sqrt(self) -> Dual64 {
        let root = self.re.sqrt();
        Dual64::new(root, self.eps / (2.0 * root))
    }
    fn sin(self) -> Dual64 {
        self.sin_cos().0
    }
    fn sin_cos(self) -> (Dual64, Dual64) {
        let (sin, cos) = Calc::sin_cos(self.re);
        (Dual64::new(sin, self.eps * cos), Dual64::new(cos, -self.eps * sin))
    }
    fn asin(self) -> Dual64 {
        Dual64::new(Calc::asin(self.re), self.eps / (1.0 - self.re * self.re).sqrt())
    }
    fn acos(self) -> Dual64 {
        Dual64::new(Calc::acos(self.re), -self.eps / (1.0 - self.re * self.re).sqrt())
    }
    fn power(self, exponent: [u8; 2]) -> Dual64 {
        let (value, order) = (
            raised(self.re, exponent),
            f64::from(exponent[0]) / f64::from(exponent[1]),
        );
        // Of nothing, to a power above one.
        let slope = if self.re == 0.0 { 0.0 } else { order * value / self.re };
        Dual64::new(value, self.eps * slope)
    }
    fn direction(x: Dual64, y: Dual64) -> Dual64 {
        let turn = (x.re * y.eps - y.re * x.eps) / (x.re * x.re + y.re * y.re);
        Dual64::new(Calc::direction(x.re, y.re), turn)
    }
    fn minus_exact(self, other: Dual64, tail: f64) -> Dual64 {
        Dual64::new(self.re.minus_exact(other.re, tail), self.eps - other.eps)
    }
}

/// A function of one scalar by its value and two derivatives.
fn chain<T: Calc + DualNum>(x: Dual2<T>, [value, first, second]: [T; 3]) -> Dual2<T> {
    Dual2::new(value, first * x.v1, first * x.v2 + second * x.v1 * x.v1)
}

impl<T: Calc + DualNum> Takes<Dual2<T>> for Dual2<T> {
    fn of(parameter: Dual2<T>) -> Dual2<T> {
        parameter
    }
}

/// Second derivatives over any scalar: over `Dual64` they are derived once more.
impl<T: Calc + DualNum> Calc for Dual2<T> {
    fn constant(value: f64) -> Dual2<T> {
        Dual2::from_re(T::constant(value))
    }
    fn value(self) -> f64 {
        self.re.value()
    }
    fn abs(self) -> Dual2<T> {
        if self.value() < 0.0 { -self } else { self }
    }
    fn sqrt(self) -> Dual2<T> {
        let root = Calc::sqrt(self.re);
        let first = T::constant(0.5) / root;
        chain(self, [root, first, T::constant(-0.25) / (root * self.re)])
    }
    fn sin(self) -> Dual2<T> {
        Calc::sin_cos(self).0
    }
    fn sin_cos(self) -> (Dual2<T>, Dual2<T>) {
        let (sin, cos) = Calc::sin_cos(self.re);
        (chain(self, [sin, cos, -sin]), chain(self, [cos, -sin, -cos]))
    }
    fn asin(self) -> Dual2<T> {
        let one = T::constant(1.0);
        let slope = one / Calc::sqrt(one - self.re * self.re);
        chain(self, [Calc::asin(self.re), slope, self.re * slope * slope * slope])
    }
    fn acos(self) -> Dual2<T> {
        let one = T::constant(1.0);
        let slope = -(one / Calc::sqrt(one - self.re * self.re));
        chain(self, [Calc::acos(self.re), slope, self.re * slope * slope * slope])
    }
    fn power(self, exponent: [u8; 2]) -> Dual2<T> {
        let order = f64::from(exponent[0]) / f64::from(exponent[1]);
        let value = self.re.power(exponent);
        let first = value / self.re * T::constant(order);
        chain(self, [value, first, first / self.re * T::constant(order - 1.0)])
    }
    fn direction(x: Dual2<T>, y: Dual2<T>) -> Dual2<T> {
        let square = x.re * x.re + y.re * y.re;
        let turn = (x.re * y.v1 - y.re * x.v1) / square;
        let bend =
            (x.re * y.v2 - y.re * x.v2) / square - T::constant(2.0) * turn * (x.re * x.v1 + y.re * y.v1) / square;
        Dual2::new(T::direction(x.re, y.re), turn, bend)
    }
    fn minus_exact(self, other: Dual2<T>, tail: f64) -> Dual2<T> {
        Dual2::new(
            self.re.minus_exact(other.re, tail),
            self.v1 - other.v1,
            self.v2 - other.v2,
        )
    }
}
