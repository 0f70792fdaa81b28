//! What turns a drive that pushes along a line, as it is given.

use crate::drive::screw::Screw;
use crate::drive::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::{Group, quantities};
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Quantity;

quantities! {
    /// Pitch radius (m) of a pinion in a rack, and the efficiency of both.
    Pinion { r_z: R_Z, eta_d: ETA_D }
}

/// Screw or pinion as it is given.
#[derive(Clone, Copy, Debug)]
pub enum Gear<C> {
    Screw(Screw<C>),
    Pinion(Pinion<C>),
}

impl<C: Copy> Gear<C> {
    /// Whether a drive of this kind has a result.
    #[must_use]
    pub fn has(&self, result: &'static Symbol) -> bool {
        matches!(self, Gear::Screw(_)) || !listed!(s: LAMBDA_D, RHO_D, LOCK_D).contains(&result)
    }

    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> Gear<D> {
        match self {
            Gear::Screw(it) => Gear::Screw(it.map(f)),
            Gear::Pinion(it) => Gear::Pinion(it.map(f)),
        }
    }
}

impl<C: Calc> Group<C> for Gear<C> {
    type Over<D: Calc> = Gear<D>;
    const SIZE: usize = Screw::<f64>::SYMBOLS.len();
    fn map<D: Calc>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> Gear<D> {
        self.map(&mut |symbol, value| f((symbol, None), value))
    }
    fn take(&self, place: usize) -> C {
        match self {
            Gear::Screw(it) => it.take(place),
            Gear::Pinion(it) => it.take(place),
        }
    }
    fn put(&mut self, place: usize, value: C) {
        match self {
            Gear::Screw(it) => it.put(place, value),
            Gear::Pinion(it) => it.put(place, value),
        }
    }
}

impl Gear<f64> {
    /// Of the checked table of a drive of a kind, none where it does not say how it is turned. Mistakes go to `found`.
    pub fn read(v: &Values, kind: &str, found: &mut Vec<Diagnostic>) -> Option<Gear<f64>> {
        match kind {
            "screw" => {
                let screw = Screw::read(v)?;
                if let Some(told) = screw.stuck() {
                    found.push(v.refuse(
                        "mu_d",
                        told,
                        "too much friction",
                        "give a smaller lead or less friction",
                    ));
                }
                Some(Gear::Screw(screw))
            }
            "rack" => Pinion::read(v).map(Gear::Pinion),
            _ => None,
        }
    }
}
