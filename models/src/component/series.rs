//! Values of a run over time, as a book draws and tables them.

use std::collections::BTreeSet;

use crate::component::moving::MovingComponent;
use crate::component::running::Running;
use crate::component::sheet::{Curve, Seen, Stand};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Fault, Role};
use crate::parts::{hanging, turntable};

/// Points of a drawn curve, besides its extremes.
const CURVE: usize = 300;
/// Curves of one figure, each with all these points.
const FEW: usize = 8;
/// Frames in which a run is seen.
const FRAMES: usize = 150;

/// What moves the picture besides the coordinate: the load on its rope, and slewing.
const SEEN: [&Symbol; 4] = [&hanging::PHI_R, &turntable::CHI_R, &hanging::L_R, &turntable::PSI_SL];

/// Where the coordinate and what else moves the picture stand among the variables.
#[must_use]
pub fn seen(model: &MovingComponent) -> Vec<usize> {
    let known = |symbol: &&Symbol| {
        let mut all = model.variables().iter();
        all.position(|variable| {
            variable.symbol == *symbol && matches!(variable.role, Role::State | Role::Output | Role::Calculated)
        })
    };
    let mut places: Vec<usize> = std::iter::once(0).chain(SEEN.iter().filter_map(known)).collect();
    places.dedup();
    places
}

/// Values of variables at the end of every sample.
pub struct Series {
    /// Time from one to the next, in s.
    pub sample: f64,
    /// Indices of the variables, rising; the first one is the coordinate.
    seen: Vec<usize>,
    /// All their values of one sample after the other.
    rows: Vec<f64>,
}

impl Series {
    /// Of the coordinate, which is the first variable, and of those with these indices.
    #[must_use]
    pub fn new(sample: f64, seen: impl Iterator<Item = usize>) -> Series {
        let seen: BTreeSet<usize> = seen.chain([0]).collect();
        Series {
            sample,
            seen: seen.into_iter().collect(),
            rows: Vec::new(),
        }
    }

    /// The values of the start, or of one more sample.
    ///
    /// # Errors
    /// A variable that has no value; then nothing is kept.
    pub fn look(&mut self, model: &mut dyn Running) -> Result<(), Fault> {
        let known = self.rows.len();
        for &index in &self.seen {
            match model.get(index) {
                Ok(value) => self.rows.push(value),
                Err(fault) => {
                    self.rows.truncate(known);
                    return Err(fault);
                }
            }
        }
        Ok(())
    }

    fn values(&self, index: usize) -> impl Iterator<Item = f64> + Clone {
        let place = self.seen.binary_search(&index).expect("a variable that was looked at");
        self.rows.iter().skip(place).step_by(self.seen.len()).copied()
    }

    /// The last value of a variable.
    ///
    /// # Panics
    /// As [`stands`](Series::stands).
    #[must_use]
    pub fn last(&self, index: usize) -> f64 {
        let place = self.seen.binary_search(&index).expect("a variable that was looked at");
        self.rows[self.rows.len() - self.seen.len() + place]
    }

    /// At how many samples a variable turns round by more than an amount, with its greatest change from one sample to the
    /// next and when that ends, in s.
    ///
    /// # Panics
    /// As [`stands`](Series::stands).
    #[must_use]
    pub fn turns(&self, index: usize, felt: f64) -> (usize, [f64; 2]) {
        let series: Vec<f64> = self.values(index).collect();
        let changes: Vec<f64> = series.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let turned = |pair: &&[f64]| pair[0] * pair[1] < 0.0 && pair[1].abs() > felt;
        let greatest = (1..)
            .zip(&changes)
            .fold([0.0, 0.0], |[most, at], (i, change): (u32, &f64)| {
                match change.abs() > most {
                    true => [change.abs(), f64::from(i) * self.sample],
                    false => [most, at],
                }
            });
        (changes.windows(2).filter(turned).count(), greatest)
    }

    /// In s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.sample * (self.rows.len() / self.seen.len() - 1) as f64
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
        let series: Vec<f64> = self.values(index).collect();
        Series::ends(&series).map(|i| Stand {
            value: series[i],
            time: i as f64 * self.sample,
            at: self.rows[i * self.seen.len()],
        })
    }

    /// A variable over time, drawn as one of so many, without most of the points that no eye could tell; nothing where it
    /// stays as it was.
    ///
    /// # Panics
    /// For a variable that nobody looked at.
    #[must_use]
    pub fn piece(&self, index: usize, of: usize) -> Option<Vec<[f64; 2]>> {
        let series: Vec<f64> = self.values(index).collect();
        if series.iter().all(|value| *value == series[0]) {
            return None;
        }
        let ([least, most], last) = (Series::ends(&series), series.len() - 1);
        let stride = (last * of.max(FEW) / (CURVE * FEW)).max(1);
        let shown = (0..=last).filter(|&i| i % stride == 0 || [last, least, most].contains(&i));
        Some(shown.map(|i| [i as f64 * self.sample, series[i]]).collect())
    }

    /// The frames of what is [`seen`].
    ///
    /// # Panics
    /// For a variable that nobody looked at.
    #[must_use]
    pub fn frames(&self, model: &MovingComponent, seen: &[usize]) -> Seen {
        let stride = (self.rows.len() / self.seen.len()).div_ceil(FRAMES);
        let values = |&index: &usize| {
            let values = self.values(index).step_by(stride).collect();
            (model.variables()[index].symbol, values)
        };
        Seen {
            step: self.sample * stride as f64,
            values: seen.iter().map(values).collect(),
        }
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
