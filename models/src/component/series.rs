//! Values of a run over time, as a book draws and tables them.

use std::collections::BTreeMap;

use crate::component::sheet::{Curve, Stand};
use crate::kernel::symbol::Symbol;

/// Points of a drawn curve, besides its extremes.
const CURVE: usize = 300;
/// Curves of one figure, each with all these points.
const FEW: usize = 8;

/// Values of variables, by their indices, at the end of every sample; the first variable is the coordinate.
pub struct Series {
    /// Time from one to the next, in s.
    pub sample: f64,
    values: BTreeMap<usize, Vec<f64>>,
}

impl Series {
    /// With the values at the start.
    #[must_use]
    pub fn new(sample: f64, first: &BTreeMap<usize, f64>) -> Series {
        Series {
            sample,
            values: first.iter().map(|(&index, &value)| (index, vec![value])).collect(),
        }
    }

    /// The values of one more sample.
    pub fn keep(&mut self, values: BTreeMap<usize, f64>) {
        for (index, value) in values {
            self.values.entry(index).or_default().push(value);
        }
    }

    /// In s.
    ///
    /// # Panics
    /// Where nobody looked at the coordinate.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.sample * (self.values[&0].len() - 1) as f64
    }

    /// Places of the least and of the greatest value.
    fn ends(series: &[f64]) -> [usize; 2] {
        [-1.0, 1.0].map(|sign: f64| {
            let places = 0..series.len();
            let best = places.reduce(|a, b| if sign * series[b] > sign * series[a] { b } else { a });
            best.expect("a run has its start")
        })
    }

    /// Least and greatest value of a variable, each with its time and where the coordinate is then.
    ///
    /// # Panics
    /// For a variable that nobody looked at.
    #[must_use]
    pub fn stands(&self, index: usize) -> [Stand; 2] {
        let series = &self.values[&index];
        Series::ends(series).map(|i| Stand {
            value: series[i],
            time: i as f64 * self.sample,
            at: self.values[&0][i],
        })
    }

    /// A variable over time, drawn as one of so many, without most of the points that no eye could tell; nothing where it
    /// stays as it was.
    ///
    /// # Panics
    /// For a variable that nobody looked at.
    #[must_use]
    pub fn piece(&self, index: usize, of: usize) -> Option<Vec<[f64; 2]>> {
        let series = &self.values[&index];
        if series.iter().all(|value| *value == series[0]) {
            return None;
        }
        let ([least, most], last) = (Series::ends(series), series.len() - 1);
        let stride = (last * of.max(FEW) / (CURVE * FEW)).max(1);
        let shown = (0..=last).filter(|&i| i % stride == 0 || [last, least, most].contains(&i));
        Some(shown.map(|i| [i as f64 * self.sample, series[i]]).collect())
    }

    /// The curve of a variable over time.
    #[must_use]
    pub fn curve(&self, id: &'static str, axes: [&'static Symbol; 2], index: usize) -> Option<Curve> {
        let [x, y] = axes;
        Some(Curve {
            id,
            x,
            y,
            pieces: vec![self.piece(index, 1)?],
            numbers: Vec::new(),
        })
    }
}
