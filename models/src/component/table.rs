//! Level `table`: results over the working range as cubic pieces, for a mechanism whose dimensions stay as they are.
//!
//! Every result is affine in the rate of the coordinate and in the load, `f(theta) + omega·g(theta) + Q·h(theta)`; each of
//! the three is a piecewise cubic with the values and derivatives (dual numbers) of the closed form at its ends. The
//! number of pieces is doubled until the error keeps to the tolerance: the greatest distance from the closed form at
//! five places of every piece, times [`MARGIN`]. Between them the error of a cubic Hermite piece is a bell with its top
//! in the middle, which is one of the places: the margin is for how its fourth derivative varies along a piece.
//!
//! A result without a finite smooth form over the range, such as the place of the instantaneous centre, stays in its
//! closed form, and so do results of the whole range.

use num_dual::Dual64;

use crate::component::part::{Face, Part};
use crate::component::stages::{Slot, Source};
use crate::kernel::symbol::symbols;
use crate::parts::motion::Motion;

symbols! {
    TOL: "tol" "epsilon" ONE / ONE [tolerance], "How far each result may be off the closed form, as a part of its range.", "input";
}

/// Where a piece is compared with the closed form.
const PLACES: [f64; 5] = [0.1, 0.3, 0.5, 0.7, 0.9];
/// Safety of the error over what was measured.
pub const MARGIN: f64 = 2.0;
/// Pieces at first and at most.
const LEAST_PIECES: usize = 8;
const MOST_PIECES: usize = 1024;
/// Part of a result that rounding may make it differ by from an affine one.
const ROUNDING: f64 = 1e-9;

/// Tolerance where the scene gives none, as part of each result's range.
pub const TOLERANCE: f64 = 1e-6;

/// What a component's tables run over: the coordinate, its rate, and the load where it has one.
#[derive(Clone, Copy, Debug)]
pub struct Axes {
    pub coordinate: Source,
    pub rate: Source,
    pub load: Option<Source>,
}

impl Axes {
    /// Where they are now.
    #[inline]
    fn of(&self, part: &dyn Part) -> [f64; 3] {
        let load = self.load.map_or(0.0, |load| part.take(load));
        [part.take(self.coordinate), part.take(self.rate), load]
    }

    /// Puts them elsewhere.
    fn put<C: Copy>(&self, face: &mut (impl Face<C> + ?Sized), [coordinate, rate, load]: [C; 3]) {
        face.put(self.coordinate, coordinate);
        face.put(self.rate, rate);
        if let Some(source) = self.load {
            face.put(source, load);
        }
    }
}

/// Results over the working range.
#[derive(Clone, Debug)]
pub struct Interpolation {
    axes: Axes,
    from: f64,
    to: f64,
    /// Of each variable of the model, where it has one.
    columns: Vec<Option<Column>>,
}

/// One result.
#[derive(Clone, Debug)]
struct Column {
    /// Pieces over the range, in 1/rad.
    scale: f64,
    /// What stands alone, what is multiplied by the rate, and what by the load; empty for nothing.
    parts: [Vec<[f64; 4]>; 3],
    /// Certified errors of the parts.
    bounds: [f64; 3],
}

impl Column {
    #[inline]
    fn value(&self, theta: f64, omega: f64, q: f64) -> f64 {
        let x = theta * self.scale;
        let [alone, by_omega, by_q] = &self.parts;
        let piece = |pieces: &[[f64; 4]]| {
            let i = (x as usize).min(pieces.len() - 1);
            let s = x - i as f64;
            let [a, b, c, d] = pieces[i];
            a + s * (b + s * (c + s * d))
        };
        let mut sum = piece(alone);
        if !by_omega.is_empty() {
            sum += omega * piece(by_omega);
        }
        if !by_q.is_empty() {
            sum += q * piece(by_q);
        }
        sum
    }
}

impl Interpolation {
    /// Tabulates those of `slots` that can be, each to a tolerance that is a part of its range.
    #[must_use]
    pub fn new(part: &dyn Part, axes: Axes, motion: &Motion, slots: &[Option<Slot>], tolerance: f64) -> Interpolation {
        // What the parts are told apart by; a scene without load, or with none, has 1 N in its place.
        let load = axes.load.map_or(0.0, |load| part.take(load));
        let load = if axes.load.is_some() && load == 0.0 { 1.0 } else { load };
        let mut pending: Vec<(usize, Slot)> = (0..).zip(slots).filter_map(|(i, slot)| Some((i, (*slot)?))).collect();
        let mut columns = vec![None; slots.len()];
        let mut pieces = LEAST_PIECES;
        let mut closed = Closed {
            axes,
            real: part.duplicate(),
            dual: part.dual(false, &mut |_, _| 0.0).0,
        };
        while pieces <= MOST_PIECES && !pending.is_empty() {
            let grid = Grid {
                unit: [motion.speed, load],
                from: motion.from,
                pieces,
                h: (motion.to - motion.from) / pieces as f64,
            };
            let sampled = grid.sample(&mut closed, &pending);
            let mut left = Vec::new();
            for (one, sampled) in pending.into_iter().zip(sampled) {
                let Some(sampled) = sampled else { continue };
                match grid.column(&sampled, tolerance) {
                    Some(column) => columns[one.0] = Some(column),
                    None => left.push(one),
                }
            }
            pending = left;
            pieces *= 2;
        }
        Interpolation {
            axes,
            from: motion.from,
            to: motion.to,
            columns,
        }
    }

    /// Least and greatest value of the coordinate, in SI.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    /// Number of bytes of all pieces.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let parts = self.columns.iter().flatten().flat_map(|column| &column.parts);
        parts.map(|part| 32 * part.len()).sum()
    }

    /// Whether a variable is tabulated.
    #[must_use]
    #[inline]
    pub fn has(&self, index: usize) -> bool {
        self.columns[index].is_some()
    }

    /// A result where a part is, within the range.
    #[must_use]
    #[inline]
    pub fn value(&self, index: usize, part: &dyn Part) -> Option<f64> {
        let [coordinate, rate, load] = self.axes.of(part);
        let column = self.columns[index].as_ref()?;
        Some(column.value(coordinate - self.from, rate, load))
    }

    /// What a result may be off by there, in its SI unit.
    #[must_use]
    pub fn bound(&self, index: usize, part: &dyn Part) -> Option<f64> {
        let [_, rate, load] = self.axes.of(part);
        let [alone, by_rate, by_load] = self.columns[index].as_ref()?.bounds;
        Some(alone + rate.abs() * by_rate + load.abs() * by_load)
    }
}

/// The closed form at the ends of pieces, and at the places in between, of one result.
#[derive(Default)]
struct Sampled {
    /// Values and derivatives (by the piece) with neither, with velocity, with load: at the pieces' ends.
    ends: Vec<[[f64; 3]; 2]>,
    /// Values of the same in between, and with both, backwards and twice.
    between: Vec<[f64; 4]>,
}

/// What of a table is the same for all results.
struct Grid {
    /// Velocity and load by which the parts are told apart.
    unit: [f64; 2],
    from: f64,
    pieces: usize,
    /// Length of a piece, in rad.
    h: f64,
}

impl Grid {
    /// Evaluates results at all places; `None` for one that does not exist everywhere.
    fn sample(&self, closed: &mut Closed, outputs: &[(usize, Slot)]) -> Vec<Option<Sampled>> {
        let mut found: Vec<Option<Sampled>> = outputs.iter().map(|_| Some(Sampled::default())).collect();
        let [omega, q] = self.unit;
        for i in 0..=self.pieces {
            let theta = self.from + i as f64 * self.h;
            let mut all = vec![[[0.0; 3]; 2]; outputs.len()];
            for (k, [omega, q]) in [[0.0, 0.0], [omega, 0.0], [0.0, q]].into_iter().enumerate() {
                let places = [Dual64::new(theta, 1.0), omega.into(), q.into()];
                closed.axes.put(&mut *closed.dual, places);
                for (((_, slot), all), found) in outputs.iter().zip(&mut all).zip(&mut found) {
                    let mut x = Dual64::from_re(0.0);
                    match closed.dual.result(slot, &mut x) {
                        Ok(()) if x.re.is_finite() && x.eps.is_finite() => {
                            (all[0][k], all[1][k]) = (x.re, x.eps * self.h);
                        }
                        _ => *found = None,
                    }
                }
            }
            for (found, all) in found.iter_mut().zip(all) {
                found.iter_mut().for_each(|found| found.ends.push(all));
            }
        }
        for i in 0..self.pieces {
            for s in PLACES {
                let mut all = vec![[0.0; 4]; outputs.len()];
                let inputs = [[0.0, 0.0], [omega, 0.0], [0.0, q], [-omega, 2.0 * q]];
                for (k, [omega, q]) in inputs.into_iter().enumerate() {
                    let theta = self.from + (i as f64 + s) * self.h;
                    closed.axes.put(&mut *closed.real, [theta, omega, q]);
                    for (((_, slot), all), found) in outputs.iter().zip(&mut all).zip(&mut found) {
                        if closed.real.result(slot, &mut all[k]).is_err() {
                            *found = None;
                        }
                    }
                }
                for (found, all) in found.iter_mut().zip(all) {
                    found.iter_mut().for_each(|found| found.between.push(all));
                }
            }
        }
        found
    }

    /// Of a part: by what it is multiplied with, without what stands alone.
    fn part(&self, part: usize, all: [f64; 3]) -> f64 {
        match part {
            0 => all[0],
            _ if self.unit[part - 1] == 0.0 => 0.0,
            _ => (all[part] - all[0]) / self.unit[part - 1],
        }
    }

    /// A result's pieces; `None` where they are not good enough.
    fn column(&self, sampled: &Sampled, tolerance: f64) -> Option<Column> {
        let parts: [Vec<[f64; 4]>; 3] = [0, 1, 2].map(|part| {
            let of = |end: &[[f64; 3]; 2]| end.map(|all| self.part(part, all));
            let cubics = sampled.ends.windows(2).map(|pair| {
                let ([p, dp], [q, dq]) = (of(&pair[0]), of(&pair[1]));
                [p, dp, 3.0 * (q - p) - 2.0 * dp - dq, 2.0 * (p - q) + dp + dq]
            });
            let cubics: Vec<[f64; 4]> = cubics.collect();
            let nothing = part > 0 && cubics.iter().flatten().all(|x| *x == 0.0);
            if nothing { Vec::new() } else { cubics }
        });
        let mut bounds = [0.0_f64; 3];
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for (i, &[neither, with_omega, with_q, both]) in sampled.between.iter().enumerate() {
            let (piece, s) = (i / PLACES.len(), PLACES[i % PLACES.len()]);
            for (part, pieces) in parts.iter().enumerate() {
                let [a, b, c, d] = pieces.get(piece).copied().unwrap_or_default();
                let off = a + s * (b + s * (c + s * d)) - self.part(part, [neither, with_omega, with_q]);
                bounds[part] = bounds[part].max(MARGIN * off.abs());
            }
            let full = with_omega + with_q - neither;
            (least, most) = (least.min(full), most.max(full));
            // Whether it is affine at all.
            let affine = neither - (with_omega - neither) + 2.0 * (with_q - neither);
            let size = [neither, with_omega, with_q, both]
                .iter()
                .fold(0.0_f64, |size, x| size.max(x.abs()));
            let off = (both - affine).abs();
            if off.is_nan() || off > ROUNDING * size {
                return None;
            }
        }
        let range = if most > least {
            most - least
        } else {
            most.abs().max(f64::MIN_POSITIVE)
        };
        let bound = bounds[0] + bounds[1] * self.unit[0] + bounds[2] * self.unit[1];
        (bound <= tolerance * range).then_some(Column {
            scale: 1.0 / self.h,
            parts,
            bounds,
        })
    }
}

/// The closed form.
struct Closed {
    axes: Axes,
    real: Box<dyn Part>,
    dual: Box<dyn Face<Dual64>>,
}
