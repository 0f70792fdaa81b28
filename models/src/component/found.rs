//! What is found by numbers alone: each scalar goes its own way, plain numbers and dual numbers through the search, whose last
//! step has the derivatives; the book has the results without a formula, which follow from all that is given.

use std::marker::PhantomData;

use num_dual::Dual64;

use crate::component::scalar::{EachScalar, Scalar};
use crate::kernel::calc::Calc;
use crate::kernel::record::Rec;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;

/// A search for so many numbers.
pub trait Finding<const N: usize>: 'static {
    /// What it starts from.
    type From<C: Calc>;

    /// Names of what it finds.
    const NAMES: [&'static Symbol; N];

    /// The same over another scalar.
    fn map<C: Calc, D: Calc>(from: &Self::From<C>, f: &mut dyn FnMut(C) -> D) -> Self::From<D>;

    /// # Errors
    /// Where there is no such thing.
    fn find<C: Scalar>(from: &Self::From<C>) -> Result<[C; N], Fault>;
}

type Finder<F, C, const N: usize> = fn(&<F as Finding<N>>::From<C>) -> Result<[C; N], Fault>;

struct Each<F, const N: usize>(PhantomData<F>);

impl<F: Finding<N>, const N: usize> EachScalar for Each<F, N> {
    type For<C: Calc> = Finder<F, C, N>;
    fn plain() -> Finder<F, f64, N> {
        F::find::<f64>
    }
    fn dual() -> Finder<F, Dual64, N> {
        F::find::<Dual64>
    }
    fn recorded() -> Finder<F, Rec, N> {
        named::<F, N>
    }
}

fn named<F: Finding<N>, const N: usize>(from: &F::From<Rec>) -> Result<[Rec; N], Fault> {
    let mut all = Vec::new();
    let values = F::map(from, &mut |x: Rec| {
        all.push(x);
        x.value()
    });
    let values = F::find::<f64>(&values)?;
    Ok(std::array::from_fn(|i| {
        let own = Rec::known(F::NAMES[i], values[i]);
        all.iter().fold(own, |own, &other| own.over(other)).def(F::NAMES[i])
    }))
}

/// What the search finds, over the scalar.
///
/// # Errors
/// As the search's own.
pub fn found<F: Finding<N>, C: Scalar, const N: usize>(from: &F::From<C>) -> Result<[C; N], Fault> {
    C::own::<Each<F, N>>()(from)
}
