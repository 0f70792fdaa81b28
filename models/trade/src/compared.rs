//! Results that are compared, and how far off they are.

use lemnis_models::kernel::variable::Variable;

/// Part of a result's range to which the two codes must agree.
pub const AGREEMENT: f64 = 1e-6;

/// An error over the whole motion, in the result's unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Size {
    pub max: f64,
    /// Root of the mean square.
    pub rms: f64,
}

/// A result that is compared.
#[derive(Clone, Debug)]
pub struct Asked {
    pub variable: Variable,
    pub name: String,
    /// How far it may be off, where the scene says so.
    pub allowed: Option<f64>,
    /// From its least to its greatest value on the deepest level.
    pub range: f64,
}

impl Asked {
    /// How far it counts as off where it is by so much: what the references themselves may be off is added.
    pub(crate) fn counted(&self, off: f64) -> f64 {
        off + AGREEMENT * self.range
    }
}

/// Whether every result that is off by so much is as accurate as it must be; `None` where nothing is asked.
pub(crate) fn all_keep(asked: &[Asked], off: impl Iterator<Item = f64>) -> Option<bool> {
    let keeps = |(asked, off): (&Asked, f64)| Some(asked.counted(off) <= asked.allowed?);
    asked.iter().zip(off).filter_map(keeps).reduce(|all, kept| all && kept)
}

pub(crate) fn distance(a: &[f64], b: &[f64]) -> Size {
    let (mut max, mut sum) = (0.0_f64, 0.0);
    for (a, b) in a.iter().zip(b) {
        let off = if a == b { 0.0 } else { (a - b).abs() };
        max = if off.is_nan() { f64::INFINITY } else { max.max(off) };
        sum += off * off;
    }
    Size {
        max,
        rms: (sum / a.len().min(b.len()).max(1) as f64).sqrt(),
    }
}
