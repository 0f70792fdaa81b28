//! A smooth curve through points whose length is a polynomial: a spline of quintic pieces with a Pythagorean hodograph.
//!
//! In the complex plane the curve's derivative is the square of a quadratic spline `z`, so that its speed is |z|², its
//! direction z²/|z|², and its length a polynomial too. `z` is smooth, and with it the curvature. (Farouki's C² splines of this kind.)

use nalgebra::Complex;

use crate::parts::plane::{Point, length};

type Number = Complex<f64>;

/// Newton's method ends within five steps from chords that turn by less than a right angle.
const STEPS: usize = 50;

/// One piece over u from 0 to 1, in powers of u.
#[derive(Clone, Copy, Debug)]
struct Piece {
    z: [Number; 3],
    start: Number,
    /// Of the point beyond the start, and of the length, without their first factor u.
    place: [Number; 5],
    before: f64,
    long: [f64; 5],
    /// Im(z̄ z′): a quadratic, positive where the curve turns counter-clockwise.
    turning: [f64; 3],
}

/// A curve that turns counter-clockwise everywhere.
#[derive(Clone, Debug)]
pub struct SmoothCurve {
    pieces: Vec<Piece>,
    length: f64,
}

/// Why there is no such curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoCurve {
    /// It turns clockwise, or not at all, between this point, counted from 1, and the next one.
    Concave(usize),
    /// Points too uneven, or two in one place.
    Uneven,
}

/// The curve at one place.
#[derive(Clone, Copy, Debug)]
pub struct CurvePoint {
    /// In m.
    pub at: Point<f64>,
    /// Unit vector.
    pub along: Point<f64>,
    /// From the first point, in m.
    pub length: f64,
    /// Of curvature, in m, and its change for one radian of turn.
    pub radius: f64,
    pub radius_rate: f64,
    /// Change of the direction, in rad, for one piece.
    pub turn: f64,
}

impl SmoothCurve {
    /// Through at least three points.
    ///
    /// # Errors
    /// Points through which there is no such curve.
    pub fn new(points: &[Point<f64>]) -> Result<SmoothCurve, NoCurve> {
        let chords: Vec<Point<f64>> = points.windows(2).map(|ends| ends[1] - ends[0]).collect();
        let spans: Vec<f64> = chords.iter().map(|chord| length(*chord)).collect();
        if spans.len() < 2 || !spans.iter().all(|span| *span > 0.0) {
            return Err(NoCurve::Uneven);
        }
        let z = roots(&chords, &spans).ok_or(NoCurve::Uneven)?;
        let mut pieces: Vec<Piece> = Vec::with_capacity(spans.len());
        let mut before = 0.0;
        for (k, point) in points[..spans.len()].iter().enumerate() {
            let [b_0, b_1, b_2] = controls(&z, &spans, k).map(|b| b * spans[k].sqrt());
            let piece = Piece::new([b_0, (b_1 - b_0) * 2.0, b_0 - b_1 * 2.0 + b_2], *point, before);
            if piece.least_turning() <= 0.0 {
                return Err(NoCurve::Concave(k + 1));
            }
            before += piece.long.iter().sum::<f64>();
            pieces.push(piece);
        }
        Ok(SmoothCurve { pieces, length: before })
    }

    /// Pieces: places run from 0 to their number.
    #[must_use]
    pub fn count(&self) -> f64 {
        self.pieces.len() as f64
    }

    /// From end to end, in m.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    #[must_use]
    pub fn at(&self, place: f64) -> CurvePoint {
        let number = (place.max(0.0) as usize).min(self.pieces.len() - 1);
        self.pieces[number].at(place - number as f64)
    }
}

impl Piece {
    fn new(z: [Number; 3], start: Point<f64>, before: f64) -> Piece {
        let [a, b, c] = z;
        let cross = |a: Number, b: Number| (a.conj() * b).im;
        let dot = |a: Number, b: Number| (a.conj() * b).re;
        Piece {
            z,
            start: Complex::new(start.x, start.y),
            place: [a * a, a * b, (b * b + a * c * 2.0) / 3.0, b * c / 2.0, c * c / 5.0],
            before,
            long: [
                dot(a, a),
                dot(a, b),
                (dot(b, b) + 2.0 * dot(a, c)) / 3.0,
                dot(b, c) / 2.0,
                dot(c, c) / 5.0,
            ],
            turning: [cross(a, b), 2.0 * cross(a, c), cross(b, c)],
        }
    }

    fn least_turning(&self) -> f64 {
        let [a, b, c] = self.turning;
        let ends = a.min(a + b + c);
        let lowest = -b / (2.0 * c);
        if c > 0.0 && lowest > 0.0 && lowest < 1.0 {
            ends.min(a + lowest * b / 2.0)
        } else {
            ends
        }
    }

    fn at(&self, u: f64) -> CurvePoint {
        let [a, b, c] = self.z;
        let (z, slope) = (a + (b + c * u) * u, b + c * (2.0 * u));
        let [t_0, t_1, t_2] = self.turning;
        let (turning, bend) = (t_0 + (t_1 + t_2 * u) * u, t_1 + 2.0 * t_2 * u);
        let (speed, change) = (z.norm_sqr(), 2.0 * (z.conj() * slope).re);
        let place = self.place.iter().rev().fold(Complex::ZERO, |sum, c| sum * u + c) * u + self.start;
        let along = z * z / speed;
        let turn = 2.0 * turning / speed;
        let radius = speed / turn;
        CurvePoint {
            at: Point::new(place.re, place.im),
            along: Point::new(along.re, along.im),
            length: self.long.iter().rev().fold(0.0, |sum, c| sum * u + c) * u + self.before,
            radius,
            radius_rate: radius * (2.0 * change / speed - bend / turning) / turn,
            turn,
        }
    }
}

/// Control numbers of `z` over one span: in its middle its own, at its ends what is smooth; over the first and the last
/// span `z` is linear.
fn controls(z: &[Number], spans: &[f64], k: usize) -> [Number; 3] {
    let knot = |k: usize| (z[k] * spans[k + 1] + z[k + 1] * spans[k]) / (spans[k] + spans[k + 1]);
    let last = z.len() - 1;
    let (low, high) = (k.min(last - 1), k.max(1));
    match k {
        0 => [z[0] * 2.0 - knot(low), z[0], knot(low)],
        _ if k == last => [knot(high - 1), z[k], z[k] * 2.0 - knot(high - 1)],
        _ => [knot(k - 1), z[k], knot(k)],
    }
}

/// The control numbers with which every piece covers its chord, over its span; `None` where Newton's method finds none.
fn roots(chords: &[Point<f64>], spans: &[f64]) -> Option<Vec<Number>> {
    let count = spans.len();
    let mut z: Vec<Number> = Vec::with_capacity(count);
    for (chord, span) in chords.iter().zip(spans) {
        let (x, y) = (chord.x / span, chord.y / span);
        let part = |square: f64| (square.max(0.0) / 2.0).sqrt();
        let root = Complex::new(part(1.0 + x), part(1.0 - x).copysign(y));
        let turned = z.last().is_some_and(|before: &Number| (before.conj() * root).re < 0.0);
        z.push(if turned { -root } else { root });
    }
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        // Rows of the tridiagonal system: below, own, above, right side.
        let mut rows: Vec<[Number; 4]> = Vec::with_capacity(count);
        for (k, chord) in chords.iter().enumerate() {
            let [a, b, c] = controls(&z, spans, k);
            let square = (a * a + c * c + (a + c) * b) / 5.0 + (b * b * 2.0 + a * c) / 15.0;
            let left = square * spans[k] - Complex::new(chord.x, chord.y);
            let by = [
                (a * 2.0 + b) / 5.0 + c / 15.0,
                (a + c) / 5.0 + b * (4.0 / 15.0),
                (c * 2.0 + b) / 5.0 + a / 15.0,
            ];
            let share = |k: usize| spans[k] / (spans[k] + spans[k + 1]);
            let mut row = [Complex::ZERO, by[1], Complex::ZERO, -left / spans[k]];
            let (first, end) = (k == 0, k + 1 == count);
            // The knot before and the one behind, and the end that is linear through the other one.
            let (before, behind) = match (first, end) {
                (true, _) => (Complex::ZERO, by[2] - by[0]),
                (_, true) => (by[0] - by[2], Complex::ZERO),
                _ => (by[0], by[2]),
            };
            if first {
                row[1] += by[0] * 2.0;
            } else {
                row[0] = before * (1.0 - share(k - 1));
                row[1] += before * share(k - 1);
            }
            if end {
                row[1] += by[2] * 2.0;
            } else {
                row[1] += behind * (1.0 - share(k));
                row[2] = behind * share(k);
            }
            rows.push(row);
        }
        for k in 1..count {
            let factor = rows[k][0] / rows[k - 1][1];
            let above = rows[k - 1];
            rows[k][1] -= factor * above[2];
            rows[k][3] -= factor * above[3];
        }
        let (mut step, mut most) = (Complex::ZERO, 0.0_f64);
        for k in (0..count).rev() {
            step = (rows[k][3] - rows[k][2] * step) / rows[k][1];
            z[k] += step;
            most = most.max(step.norm_sqr());
        }
        if !most.is_finite() {
            return None;
        }
        // Squares: rounding is all that is left.
        if most < 1e-26 && most >= last || most < 1e-31 {
            return Some(z);
        }
        last = most;
    }
    None
}
