//! A working range on a grid: the greatest value of a quantity, and its zeros.

use crate::balance::residual::Residual;
use crate::balance::symbols as s;
use crate::component::extreme::Extreme;
use crate::kernel::allowed::{FINITE, OutOfRange};
use crate::parts::motion::degrees;

/// Points at which a quantity is looked at before extremes and zeros are refined.
const GRID: u32 = 380;

/// The range on a grid, and the function behind it.
pub(super) struct Sampled<'a> {
    range: [f64; 2],
    pub(super) samples: Vec<Residual<f64>>,
    at: &'a dyn Fn(f64) -> Result<Residual<f64>, OutOfRange>,
}

impl<'a> Sampled<'a> {
    pub(super) fn new(
        range: [f64; 2],
        at: &'a dyn Fn(f64) -> Result<Residual<f64>, OutOfRange>,
    ) -> Result<Sampled<'a>, OutOfRange> {
        let mut grid = Sampled {
            range,
            samples: Vec::new(),
            at,
        };
        for i in 0..=GRID as usize {
            let theta = grid.angle(i);
            let sample = (grid.at)(theta)?;
            let whole = [sample.dm, sample.action.u_5, sample.action.n_1.unwrap_or(0.0)];
            if let Some(&value) = whole.iter().find(|value| !value.is_finite()) {
                return Err(OutOfRange::new(
                    &s::DM,
                    value,
                    FINITE,
                    format!("no finite moment at {}", degrees(theta)),
                ));
            }
            grid.samples.push(sample);
        }
        Ok(grid)
    }

    pub(super) fn angle(&self, i: usize) -> f64 {
        let [from, to] = self.range;
        if i == GRID as usize {
            to
        } else {
            from + (to - from) * i as f64 / f64::from(GRID)
        }
    }

    /// The greatest value: every peak of the grid is refined, for the best
    /// balances have several of nearly the same height.
    pub(super) fn greatest(&self, pick: &dyn Fn(&Residual<f64>) -> Option<f64>) -> Result<Option<Extreme>, OutOfRange> {
        let Some(values) = self.samples.iter().map(pick).collect::<Option<Vec<f64>>>() else {
            return Ok(None);
        };
        let top = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let bottom = values.iter().copied().fold(f64::INFINITY, f64::min);
        let at = |i: usize| Extreme {
            value: values[i],
            at: self.angle(i),
        };
        let (mut best, last) = (at(0), values.len() - 1);
        for (i, &value) in values.iter().enumerate() {
            let (before, after) = (i.saturating_sub(1), (i + 1).min(last));
            if value > best.value {
                best = at(i);
            }
            // Between two samples a peak hides less than this part of the whole swing.
            let near = value >= top - 0.01 * (top - bottom);
            if !(near && value >= values[before] && value >= values[after]) {
                continue;
            }
            let mut ends = [self.angle(before), self.angle(after)];
            const GOLDEN: f64 = 0.618_033_988_749_894_9;
            for _ in 0..40 {
                let width = ends[1] - ends[0];
                let inner = [ends[1] - GOLDEN * width, ends[0] + GOLDEN * width];
                let mut found = [0.0; 2];
                for (found, &phi) in found.iter_mut().zip(&inner) {
                    *found = pick(&(self.at)(phi)?).unwrap_or(f64::NEG_INFINITY);
                    if *found > best.value {
                        best = Extreme { value: *found, at: phi };
                    }
                }
                if found[0] > found[1] {
                    ends[1] = inner[1]
                } else {
                    ends[0] = inner[0]
                }
            }
        }
        Ok(Some(best))
    }
}

/// The zero between two angles by bisection down to neighbouring numbers.
pub(super) fn zero(
    mut ends: [f64; 2],
    falling: bool,
    f: &dyn Fn(f64) -> Result<f64, OutOfRange>,
) -> Result<f64, OutOfRange> {
    loop {
        let middle = f64::midpoint(ends[0], ends[1]);
        if middle <= ends[0] || middle >= ends[1] {
            return Ok(middle);
        }
        let end = usize::from((f(middle)? > 0.0) != falling);
        ends[end] = middle;
    }
}
