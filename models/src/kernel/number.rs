//! How numbers are printed for people: the one place behind messages, tables,
//! drawings and books. It never fails; what is no number is said in words.

use std::fmt;

/// How many digits a number is printed with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// As many as make it exact where the first number of them is enough, otherwise the second number of significant ones.
    Short(usize, usize),
    /// Significant ones.
    Significant(usize),
    /// So many after the decimal point.
    Decimals(usize),
    /// As many as tell it from every other number, seventeen at most.
    All,
}

/// A number in decimal digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Number {
    Finite {
        negative: bool,
        /// With a decimal point where it needs one; zero has no sign.
        digits: String,
        /// Of ten; zero where the digits alone are the number.
        power: i32,
    },
    Infinite {
        negative: bool,
    },
    Undefined,
}

/// Significant digits of a number that is not short by itself.
pub const SIGNIFICANT: usize = 6;

/// Most digits of a number that is printed exactly.
pub const EXACT: usize = 9;

/// What is below this part of a number, or of the scale of what it measures, is rounding.
pub const NOISE: f64 = 1e-12;

/// Most digits altogether: more than these a number in double precision does not have.
const MOST: usize = 15;

/// Powers of ten that are written out.
const PLAIN: std::ops::Range<i32> = -3..7;

impl Number {
    #[must_use]
    pub fn new(value: f64, digits: Digits) -> Number {
        if value.is_nan() {
            return Number::Undefined;
        }
        let (negative, amount) = (value < 0.0, value.abs());
        if amount.is_infinite() {
            return Number::Infinite { negative };
        }
        let whole = usize::try_from(exponent(amount)).unwrap_or(0) + 1;
        let (digits, power) = match digits {
            Digits::Short(..) | Digits::Significant(_) if amount == 0.0 => ("0".to_owned(), 0),
            Digits::Decimals(decimals) if whole <= MOST => (format!("{amount:.*}", decimals.min(MOST - whole)), 0),
            Digits::Decimals(_) => placed(&brief(amount, EXACT, SIGNIFICANT), amount),
            Digits::Short(exact, significant) => placed(&brief(amount, exact, significant), amount),
            Digits::Significant(count) => placed(&format!("{amount:.*e}", count.clamp(1, MOST) - 1), amount),
            Digits::All => placed(&format!("{amount:e}"), amount),
        };
        let negative = negative && digits.bytes().any(|digit| matches!(digit, b'1'..=b'9'));
        Number::Finite {
            negative,
            digits,
            power,
        }
    }

    /// The number that the digits say.
    #[must_use]
    pub fn value(&self) -> f64 {
        match self {
            Number::Finite { .. } => self.to_string().parse().unwrap_or(f64::NAN),
            Number::Infinite { negative: false } => f64::INFINITY,
            Number::Infinite { negative: true } => f64::NEG_INFINITY,
            Number::Undefined => f64::NAN,
        }
    }

    /// Half of its last digit, by which it may be off where it has [`SIGNIFICANT`] digits or more; with fewer it is exact,
    /// as [`short`] writes numbers.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        let Number::Finite { digits, power, .. } = self else {
            return 0.0;
        };
        let significant = digits.trim_start_matches(['0', '.']).bytes().filter(u8::is_ascii_digit);
        if significant.count() < SIGNIFICANT {
            return 0.0;
        }
        let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let decimals = i32::try_from(decimals).unwrap_or(0);
        format!("0.5e{}", power - decimals).parse().unwrap_or(0.0)
    }
}

/// In scientific notation: exact where so many digits are enough for that, otherwise with so many significant ones.
fn brief(amount: f64, exact_digits: usize, significant: usize) -> String {
    let text = |decimals: usize| format!("{amount:.decimals$e}");
    let exact = |text: &String| is_exact(text, amount);
    // What all of the digits do not say, fewer do not.
    let finest = exact_digits.min(MOST).checked_sub(1);
    let found = finest
        .filter(|&finest| exact(&text(finest)))
        .and_then(|finest| (0..=finest).map(text).find(exact));
    found.unwrap_or_else(|| format!("{amount:.*e}", significant.clamp(1, MOST) - 1))
}

/// Digits and power of ten of a number in scientific notation.
fn placed(text: &str, amount: f64) -> (String, i32) {
    let (mantissa, power) = parts(text);
    if !PLAIN.contains(&power) {
        return (mantissa.to_owned(), power);
    }
    let decimals = mantissa.len().saturating_sub(2);
    let decimals = i32::try_from(decimals).unwrap_or(0) - power;
    (format!("{amount:.*}", usize::try_from(decimals).unwrap_or(0)), 0)
}

/// Mantissa and exponent of scientific notation.
fn parts(text: &str) -> (&str, i32) {
    let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
    (mantissa, power.parse().unwrap_or(0))
}

/// Exponent of the greatest power of ten that is not above the amount of a value, by its digits, so that it is the same
/// everywhere; zero where there is none.
#[must_use]
pub fn exponent(value: f64) -> i32 {
    parts(&format!("{:.9e}", value.abs())).1
}

/// Whether digits give the value back, but for rounding.
fn is_exact(digits: &str, value: f64) -> bool {
    digits
        .parse()
        .is_ok_and(|back: f64| back == value || (back - value).abs() <= NOISE * value.abs())
}

impl fmt::Display for Number {
    /// For messages and the terminal: `-1.5e-7`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match self {
            Number::Finite {
                negative,
                digits,
                power,
            } => {
                let sign = if *negative { "-" } else { "" };
                match power {
                    0 => format!("{sign}{digits}"),
                    power => format!("{sign}{digits}e{power}"),
                }
            }
            Number::Infinite { negative: false } => "infinite".to_owned(),
            Number::Infinite { negative: true } => "-infinite".to_owned(),
            Number::Undefined => "undefined".to_owned(),
        };
        f.pad(&text)
    }
}

/// A number for messages and the terminal.
#[must_use]
pub fn short(value: f64) -> Number {
    Number::new(value, Digits::Short(EXACT, SIGNIFICANT))
}

/// A number with all its digits.
#[must_use]
pub fn exact(value: f64) -> Number {
    Number::new(value, Digits::All)
}

/// A number that tells how great something is, as an error or a cost: three significant digits, or two with a power of
/// ten.
#[must_use]
pub fn rough(value: f64) -> Number {
    let plain = value == 0.0 || PLAIN.contains(&exponent(value));
    Number::new(value, Digits::Significant(if plain { 3 } else { 2 }))
}

/// The numbers of a column, all with the same decimals: so many significant digits for the largest, but not more than
/// four decimals (two less than the digits, where that is more) unless all of them are below one, and no more than make all
/// of them exact.
#[must_use]
pub fn column(values: &[f64], digits: usize) -> Vec<Number> {
    let digits = i32::try_from(digits.clamp(1, MOST)).unwrap_or(1);
    let finite = values.iter().copied().filter(|value| value.is_finite());
    let largest = finite.clone().map(f64::abs).fold(0.0, f64::max);
    let digits = match exponent(largest) {
        power if PLAIN.contains(&power) || largest == 0.0 => {
            let least = 4.max(digits - 2);
            let least = if power < 0 { least - 1 - power } else { least };
            let most = (digits - 1 - power).clamp(0, least) as usize;
            let enough = |decimals: &usize| {
                finite
                    .clone()
                    .all(|value| is_exact(&format!("{value:.decimals$}"), value))
            };
            Digits::Decimals((0..most).find(enough).unwrap_or(most))
        }
        _ => Digits::Significant(digits as usize),
    };
    values.iter().map(|&value| Number::new(value, digits)).collect()
}
