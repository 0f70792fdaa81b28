//! Pins whose sizes are given, under their forces in a case.

use std::f64::consts::PI;

use crate::component::stages::results;
use crate::kernel::calc::{Among, Calc};
use crate::kernel::symbol::Symbol;
use crate::luffing::resistances::friction::Pins;
use crate::luffing::resistances::given::CasesChoice;
use crate::luffing::resistances::symbols::F_PK;
use crate::luffing::strength::given::PinSize;
use crate::luffing::strength::symbols as s;

/// Greatest of all of them, in Pa.
#[derive(Clone, Copy, Debug)]
pub struct Sheared<C> {
    pressure: C,
    shear: C,
}
results! { each Sheared as p => { P_B: p.pressure; TAU_P: p.shear; } }

impl<C: Calc> PinSize<C> {
    /// p = F / (d b), in Pa, under a force (N). [Ports001, 5.8]
    pub fn pressure(&self, force: C) -> C {
        force / (self.d * self.b)
    }

    /// τ = 2 F / (π d²), in Pa: two sections share the force (N) evenly. [Ports001, 5.8]
    pub fn shear(&self, force: C) -> C {
        C::constant(2.0) * force / (C::constant(PI) * self.d.square())
    }
}

impl<C: Calc> Sheared<C> {
    pub fn new(sizes: &[PinSize<C>], choice: &CasesChoice, pins: &Pins<C>) -> Sheared<C> {
        let most = |of: fn(&PinSize<C>, C) -> C, symbol: &'static Symbol| {
            let each = sizes.iter().zip(&choice.sizes);
            let all = each.map(|(size, at)| of(size, pins.at(*at).force()));
            let found = all.reduce(C::greater).unwrap_or(C::constant(0.0));
            // As it is of each of them.
            let [force, d, b] = [&F_PK, &s::D_P, &s::B_P].map(|symbol| C::known(symbol, 1.0));
            found.among(Among::Greatest, of(&PinSize { d, b }, force)).def(symbol)
        };
        Sheared {
            pressure: most(PinSize::pressure, &s::P_B),
            shear: most(PinSize::shear, &s::TAU_P),
        }
    }
}
