//! How many times what is there is what is asked for.

use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;

/// What is there over what is asked for, in the same unit; infinite, as the symbol says, where nothing is asked for.
pub fn safety<C: Calc>(there: C, asked: C, symbol: &'static Symbol) -> C {
    if asked.value() > 0.0 {
        (there / asked).def(symbol)
    } else {
        C::known(symbol, f64::INFINITY).over(asked).over(there)
    }
}
