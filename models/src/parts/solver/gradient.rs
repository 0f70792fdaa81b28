//! A number with its derivatives by N quantities at once.
//!
//! `num-dual`'s vector keeps its derivatives in an `Option`, asked at every
//! operation: an 8 × 8 Jacobian took three times as long.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_dual::Dual64;

use crate::kernel::calc::{Calc, Function, Takes};

/// Most derivatives that operations are written out for; of more, each is a call: the equations of a crane that
/// slews on its oil would take a quarter of a megabyte otherwise.
const WRITTEN_OUT: usize = 8;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient<const N: usize> {
    pub re: f64,
    pub by: [f64; N],
}

impl<const N: usize> Gradient<N> {
    /// States of a system, each with derivative one by itself.
    #[must_use]
    pub fn states(y: &[f64; N]) -> [Gradient<N>; N] {
        std::array::from_fn(|i| Gradient {
            re: y[i],
            by: std::array::from_fn(|j| f64::from(u8::from(i == j))),
        })
    }

    /// A function of this number, by its value and derivative.
    #[inline]
    #[must_use]
    pub fn chain(self, f: Dual64) -> Gradient<N> {
        let by = if N > WRITTEN_OUT {
            multiple_called(&self.by, f.eps)
        } else {
            multiple(&self.by, f.eps)
        };
        Gradient { re: f.re, by }
    }

    #[inline]
    fn combine(self, other: Gradient<N>, re: f64, own: f64, others: f64) -> Gradient<N> {
        let by = if N > WRITTEN_OUT {
            sum_called(&self.by, own, &other.by, others)
        } else {
            sum(&self.by, own, &other.by, others)
        };
        Gradient { re, by }
    }
}

#[inline]
fn multiple<const N: usize>(by: &[f64; N], factor: f64) -> [f64; N] {
    by.map(|x| factor * x)
}

#[inline]
fn sum<const N: usize>(a: &[f64; N], own: f64, b: &[f64; N], others: f64) -> [f64; N] {
    std::array::from_fn(|i| own * a[i] + others * b[i])
}

#[inline(never)]
fn multiple_called<const N: usize>(by: &[f64; N], factor: f64) -> [f64; N] {
    multiple(by, factor)
}

#[inline(never)]
fn sum_called<const N: usize>(a: &[f64; N], own: f64, b: &[f64; N], others: f64) -> [f64; N] {
    sum(a, own, b, others)
}

impl<const N: usize> Add for Gradient<N> {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        self.combine(o, self.re + o.re, 1.0, 1.0)
    }
}

impl<const N: usize> Sub for Gradient<N> {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        self.combine(o, self.re - o.re, 1.0, -1.0)
    }
}

impl<const N: usize> Mul for Gradient<N> {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        self.combine(o, self.re * o.re, o.re, self.re)
    }
}

impl<const N: usize> Div for Gradient<N> {
    type Output = Self;
    #[inline]
    fn div(self, o: Self) -> Self {
        let quotient = self.re / o.re;
        self.combine(o, quotient, 1.0 / o.re, -quotient / o.re)
    }
}

impl<const N: usize> Neg for Gradient<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(Dual64::new(-self.re, -1.0))
    }
}

macro_rules! assign {
    ($($trait:ident $name:ident $operator:tt),*) => {$(
        impl<const N: usize> $trait for Gradient<N> {
            #[inline]
            fn $name(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl<const N: usize> Takes<Gradient<N>> for Gradient<N> {
    #[inline]
    fn of(parameter: Gradient<N>) -> Gradient<N> {
        parameter
    }
}

impl<const N: usize> Calc for Gradient<N> {
    #[inline]
    fn constant(re: f64) -> Self {
        Gradient { re, by: [0.0; N] }
    }
    #[inline]
    fn value(self) -> f64 {
        self.re
    }
    #[inline]
    fn scaled(self, factor: f64) -> Self {
        self.chain(Dual64::new(factor * self.re, factor))
    }
    #[inline]
    fn through(self, f: impl Function) -> Self {
        // The value as plain numbers have it, to the last bit.
        self.chain(Dual64::new(f.at(self.re), f.at(Dual64::new(self.re, 1.0)).eps))
    }
    #[inline]
    fn abs(self) -> Self {
        if self.re < 0.0 { -self } else { self }
    }
    #[inline]
    fn sqrt(self) -> Self {
        self.chain(Calc::sqrt(Dual64::new(self.re, 1.0)))
    }
    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Calc::sin_cos(self.re);
        (self.chain(Dual64::new(sin, cos)), self.chain(Dual64::new(cos, -sin)))
    }
    fn asin(self) -> Self {
        self.chain(Calc::asin(Dual64::new(self.re, 1.0)))
    }
    fn acos(self) -> Self {
        self.chain(Calc::acos(Dual64::new(self.re, 1.0)))
    }
    fn power(self, exponent: [u8; 2]) -> Self {
        self.chain(Dual64::new(self.re, 1.0).power(exponent))
    }
    fn direction(x: Self, y: Self) -> Self {
        let square = x.re * x.re + y.re * y.re;
        x.combine(y, f64::direction(x.re, y.re), -y.re / square, x.re / square)
    }
    fn minus_exact(self, other: Self, tail: f64) -> Self {
        self.combine(other, self.re.minus_exact(other.re, tail), 1.0, -1.0)
    }
}
