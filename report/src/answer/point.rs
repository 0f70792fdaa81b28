//! Points of drawings, as a page reads them.

/// In metres, forward and upward.
pub type Point = [f64; 2];

/// To a tenth of a millimetre, zero without a sign.
pub fn rounded(point: Point) -> Point {
    point.map(|x| (x * 1e4).round() / 1e4 + 0.0)
}
