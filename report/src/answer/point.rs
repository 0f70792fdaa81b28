//! Points of drawings and curves, as a page reads them.

/// In metres, forward and upward.
pub type Point = [f64; 2];

/// To a tenth of a millimetre, zero without a sign.
pub fn rounded(point: Point) -> Point {
    point.map(|x| (x * 1e4).round() / 1e4 + 0.0)
}

/// To nine digits at least, which no screen can show: its text is half as long.
pub fn to_nine_digits(x: f64) -> f64 {
    const DIGITS: i32 = 8;
    // The power of two, and so nearly that of ten.
    let power = (((x.to_bits() >> 52 & 0x7ff) as i32 - 1023) * 30103).div_euclid(100_000);
    let scale = 10f64.powi((DIGITS - power).abs());
    let [up, down] = if power <= DIGITS { [scale, 1.0] } else { [1.0, scale] };
    let short = (x * up / down).round() / up * down;
    if short.is_finite() { short } else { x }
}

#[cfg(test)]
mod tests {
    use super::to_nine_digits;

    /// Of any size; zero and what is no number stay what they are.
    #[test]
    fn nine_digits() {
        let mut state = 1_u64;
        for exponent in -300..300 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let digits = 1.0 + 9.0 * (state >> 11) as f64 / (1_u64 << 53) as f64;
            for sign in [1.0, -1.0] {
                let x: f64 = sign * digits * format!("1e{exponent}").parse::<f64>().unwrap();
                assert!(
                    (to_nine_digits(x) - x).abs() <= 5e-9 * x.abs(),
                    "{x:e} becomes {:e}",
                    to_nine_digits(x)
                );
            }
        }
        assert_eq!(to_nine_digits(1.0 / 3.0).to_string(), "0.333333333");
        assert_eq!([0.0, 1.0, -2.5e6].map(to_nine_digits), [0.0, 1.0, -2.5e6]);
        assert!(to_nine_digits(f64::NAN).is_nan() && to_nine_digits(f64::INFINITY).is_infinite());
        assert_eq!(to_nine_digits(5e-324), 5e-324);
    }
}
