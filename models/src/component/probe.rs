//! A component on dual numbers: a result and its derivative at any value of the coordinate.

use num_dual::Dual64;

use crate::component::part::Face;
use crate::component::running::Running;
use crate::component::stages::{Slot, Source};
use crate::component::standing::{Standing, VariablePlace};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Quantity;

/// A component on dual numbers, at any value of its coordinate.
pub(super) struct Probe {
    pub(super) face: Box<dyn Face<Dual64>>,
    coordinate: Source,
}

impl Probe {
    pub(super) fn new(model: &Standing, seed: &mut dyn FnMut(Source, Quantity) -> f64) -> Probe {
        Probe {
            face: model.part().dual(false, seed).0,
            coordinate: model.coordinate(),
        }
    }

    /// Moves another source.
    pub(super) fn stand(&mut self, source: Source, value: Dual64) {
        let here = self.face.take(source);
        if [here.re.to_bits(), here.eps.to_bits()] != [value.re.to_bits(), value.eps.to_bits()] {
            self.face.put(source, value);
        }
    }

    /// Likewise, if there is another one.
    pub(super) fn stood(&mut self, aside: Option<(Source, Dual64)>) {
        if let Some((source, value)) = aside {
            self.stand(source, value);
        }
    }

    /// Moves it; what is known of the place where it stands stays known.
    fn place(&mut self, place: Dual64) {
        self.stand(self.coordinate, place);
    }

    pub(super) fn at(&mut self, slot: &Slot, place: Dual64) -> Option<Dual64> {
        let mut value = Dual64::from_re(0.0);
        self.place(place);
        self.face.result(slot, &mut value).ok().map(|()| value)
    }
}

/// Where a result of the scene stands: one slot, or as many as it is numbered to.
pub fn slots(model: &Standing, symbol: &'static Symbol) -> impl Iterator<Item = Slot> {
    let all = model.variables().iter().zip(model.places());
    all.filter_map(move |(variable, place)| match place {
        VariablePlace::Result(slot) if variable.symbol == symbol => Some(*slot),
        _ => None,
    })
}

/// The first of these.
#[must_use]
pub fn slot(model: &Standing, symbol: &'static Symbol) -> Option<Slot> {
    slots(model, symbol).next()
}
