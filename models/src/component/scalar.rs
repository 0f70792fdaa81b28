//! The scalars that components run on.

use num_dual::Dual64;

use crate::kernel::calc::Calc;
use crate::kernel::record::Rec;

/// Plain numbers, dual numbers for derivatives, the recorder.
pub trait Scalar: Calc {
    /// What was made for this one.
    fn own<T: EachScalar>() -> T::For<Self>;
}

/// What each scalar has in a way of its own.
pub trait EachScalar {
    type For<C: Calc>;
    fn plain() -> Self::For<f64>;
    fn dual() -> Self::For<Dual64>;
    fn recorded() -> Self::For<Rec>;
}

impl Scalar for f64 {
    fn own<T: EachScalar>() -> T::For<f64> {
        T::plain()
    }
}

impl Scalar for Dual64 {
    fn own<T: EachScalar>() -> T::For<Dual64> {
        T::dual()
    }
}

impl Scalar for Rec {
    fn own<T: EachScalar>() -> T::For<Rec> {
        T::recorded()
    }
}
