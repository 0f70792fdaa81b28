//! How numbers are printed, by one rule: as many digits as make the number
//! exact where nine are enough, six significant digits otherwise. Very small
//! and very large ones are written with a power of ten. In a column of a table
//! all numbers have the same decimals.

const SIGNIFICANT: usize = 6;

/// A number in Typst's mathematics; infinity is its sign.
#[must_use]
pub fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if value.is_infinite() {
        return if value > 0.0 { "infinity" } else { "-infinity" }.to_owned();
    }
    let text = (0..9)
        .map(|decimals| format!("{value:.decimals$e}"))
        .find(|text| exact(text, value))
        .unwrap_or_else(|| format!("{value:.*e}", SIGNIFICANT - 1));
    let (mantissa, exponent) = text.split_once('e').expect("scientific notation has an exponent");
    let exponent: i32 = exponent.parse().expect("an integer");
    if !(-3..7).contains(&exponent) {
        return format!("{mantissa} times 10^({exponent})");
    }
    let decimals = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
    let decimals = usize::try_from(i32::try_from(decimals).expect("nine at most") - exponent).unwrap_or(0);
    format!("{value:.decimals$}")
}

/// Decimals of a column: six significant digits for its largest number, but
/// not more than four decimals, and no more than make all its numbers exact.
#[must_use]
pub fn decimals(column: &[f64]) -> usize {
    let largest = column
        .iter()
        .filter(|value| value.is_finite())
        .map(|value| value.abs())
        .fold(0.0, f64::max);
    let most = SIGNIFICANT.saturating_sub(format!("{largest:.0}").len()).min(4);
    let exact = |decimals: &usize| column.iter().all(|&value| exact(&format!("{value:.decimals$}"), value));
    (0..most).find(exact).unwrap_or(most)
}

/// Whether digits give the value back, but for the rounding of a conversion of units.
fn exact(digits: &str, value: f64) -> bool {
    let back: f64 = digits.parse().expect("digits just written");
    back == value || (back - value).abs() <= 4.0 * f64::EPSILON * value.abs()
}

/// A number with given decimals, as text; zero has no sign.
#[must_use]
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = if value.is_infinite() {
        format!("{}∞", if value < 0.0 { "-" } else { "" })
    } else {
        format!("{value:.decimals$}")
    };
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|byte| matches!(byte, b'0' | b'.')) => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}

/// A small change, as text with three significant digits; zero where it is
/// nothing but rounding.
#[must_use]
pub fn significant(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    if value.abs() < 5e-8 {
        return "0".to_owned();
    }
    let text = format!("{value:.2e}");
    let (_, exponent) = text.split_once('e').expect("scientific notation has an exponent");
    let exponent: i32 = exponent.parse().expect("an integer");
    fixed(value, usize::try_from(2 - exponent).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_numbers_are_short_and_others_have_six_digits() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (160.0, "160"),
            (19.3, "19.3"),
            (1.354_123_4, "1.3541234"),
            (60.0_f64.to_radians() / (std::f64::consts::PI / 180.0), "60"),
            (std::f64::consts::PI, "3.14159"),
            (-17.300_000_04, "-17.3000"),
            (999_999.712_345_6, "1000000"),
            (6.123e-17, "6.123 times 10^(-17)"),
            (2.0 / 3.0 * 1e-4, "6.66667 times 10^(-5)"),
            (0.001_234_567_89, "0.00123456789"),
            (-1e7, "-1 times 10^(7)"),
            (f64::NEG_INFINITY, "-infinity"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn a_small_change_has_three_digits() {
        for (value, text) in [
            (0.0012345, "0.00123"),
            (-12.345, "−12.3"),
            (98765.4, "98765"),
            (9.996, "10.0"),
            (1e-12, "0"),
            (f64::NAN, "–"),
        ] {
            assert_eq!(significant(value), text);
        }
    }

    #[test]
    fn a_column_has_one_number_of_decimals_and_no_negative_zero() {
        assert_eq!(decimals(&[254.346_5, -3.0]), 3);
        assert_eq!(decimals(&[1.0 / 3.0, f64::INFINITY]), 4);
        assert_eq!(decimals(&[60.0, 60.5]), 1);
        assert_eq!(fixed(-0.000_04, 4), "0.0000");
        assert_eq!(fixed(-4.2338, 3), "−4.234");
        assert_eq!(fixed(f64::NEG_INFINITY, 3), "−∞");
    }
}
