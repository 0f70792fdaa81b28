//! How many digits the numbers of a formula need, so that a reader who has nothing but them finds its result.
//!
//! Each number with six significant digits or more stands for itself and half of its last digit to both sides; one with
//! fewer is exact. The formula is evaluated over these intervals.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use lemnis_models::component::sheet::Sheet;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::record::{Node, Op, Rec, Step, Trace};
use lemnis_models::kernel::symbol::Symbol;

use crate::language::Language;
use crate::print::number::Numbers;

/// How far what follows from the printed numbers may be off, to each side, as a part of the result.
const OFF: f64 = 0.005;

/// A result that is less than this part of its greatest term is near zero because its terms cancel: it is compared with
/// that term.
const CANCELLED: f64 = 1e-9;

/// The numbers of a sheet's book, with so many significant digits in results.
#[must_use]
pub fn numbers(language: &'static Language, digits: usize, sheet: &Sheet) -> Numbers {
    let mut numbers = of_results(language, digits, sheet);
    for section in sheet.sections() {
        for step in &section.trace.steps {
            digits_needed(&mut numbers, &section.trace, step);
        }
    }
    numbers
}

/// The same where no formula is printed.
#[must_use]
pub fn of_results(language: &'static Language, digits: usize, sheet: &Sheet) -> Numbers {
    let mut numbers = Numbers::new(language, digits);
    sheet.values(&mut |symbol, value| numbers.reach(symbol, value));
    numbers
}

/// Gives the quantities of a formula more digits, one by one where that helps most, until what follows from them is known
/// to half a percent.
fn digits_needed(numbers: &mut Numbers, trace: &Trace, step: &Step) {
    let mut names = Vec::new();
    trace.names(step.formula, &mut names);
    let off = |numbers: &Numbers| {
        let Known { low, high, scale } = known(numbers, trace, step.formula);
        let reference = if step.value.abs() < CANCELLED * scale {
            scale
        } else {
            step.value.abs()
        };
        let half = (high - low) / 2.0;
        // Zero that follows from zeros is exact, and so is what is infinite.
        if half == 0.0 || !step.value.is_finite() {
            0.0
        } else {
            half / reference
        }
    };
    while off(numbers) > OFF {
        let mut best: Option<(f64, &'static Symbol)> = None;
        for &name in &names {
            if numbers.refine(name, 1) {
                let found = off(numbers);
                numbers.refine(name, -1);
                if best.is_none_or(|(least, _)| found < least) {
                    best = Some((found, name));
                }
            }
        }
        match best {
            Some((_, name)) => numbers.refine(name, 1),
            None => return,
        };
    }
}

/// What is known of an expression from its printed numbers: between what its value lies, in SI, and its greatest term.
#[derive(Clone, Copy)]
struct Known {
    low: f64,
    high: f64,
    scale: f64,
}

impl Known {
    /// The least and the greatest of several values; all numbers where one of them is none.
    fn around<const N: usize>(values: [f64; N], scale: f64) -> Known {
        if values.iter().any(|value| value.is_nan()) {
            return Known::nothing(scale);
        }
        Known {
            low: values.into_iter().fold(f64::INFINITY, f64::min),
            high: values.into_iter().fold(f64::NEG_INFINITY, f64::max),
            scale,
        }
    }

    fn nothing(scale: f64) -> Known {
        Known {
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
            scale,
        }
    }

    fn contains(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }

    fn ends(&self) -> [f64; 2] {
        [self.low, self.high]
    }

    /// Of a function that rises or falls all the way.
    fn through(self, scale: f64, of: impl Fn(f64) -> f64) -> Known {
        Known::around(self.ends().map(of), scale)
    }
}

fn known(numbers: &Numbers, trace: &Trace, rec: Rec) -> Known {
    let value = trace.value(rec);
    match trace.node(rec) {
        Node::Constant(value) => Known::around([value], value.abs()),
        Node::Name(symbol) => {
            let number = numbers.number_in_formula(symbol, value);
            let printed = number.value() * symbol.display.factor;
            let half = number.rounding() * symbol.display.factor;
            Known::around([printed - half, printed + half], printed.abs())
        }
        // No numbers are printed for what it is made of.
        Node::Unary(Op::Among(_), _) | Node::Binary(Op::Derivative, ..) => Known::around([value], value.abs()),
        Node::Unary(op, inner) => unary(op, known(numbers, trace, inner), value),
        Node::Binary(op, left, right) => {
            let [left, right] = [left, right].map(|side| known(numbers, trace, side));
            binary(op, left, right, value)
        }
    }
}

fn unary(op: Op, inner: Known, value: f64) -> Known {
    let Known { low, high, scale } = inner;
    let most = low.abs().max(high.abs());
    let least = if inner.contains(0.0) {
        0.0
    } else {
        low.abs().min(high.abs())
    };
    let inside = |x: f64| x.clamp(-1.0, 1.0);
    match op {
        Op::Abs => Known::around([least, most], scale),
        Op::Square => Known::around([least.square(), most.square()], scale.square()),
        Op::Sqrt => inner.through(scale.sqrt(), |x| x.max(0.0).sqrt()),
        Op::Power(exponent) => inner.through(scale.power(exponent), |x| x.max(0.0).power(exponent)),
        Op::Sin => turned(inner, FRAC_PI_2, scale.min(1.0).max(value.abs())),
        Op::Cos => turned(inner, 0.0, 1.0),
        Op::Asin => inner.through(scale.min(1.0), |x| Calc::asin(inside(x))),
        Op::Acos => inner.through(1.0, |x| Calc::acos(inside(x))),
        _ => inner.through(scale, |x| -x),
    }
}

/// The cosine of an angle less `zero`, over an interval.
fn turned(Known { low, high, .. }: Known, zero: f64, scale: f64) -> Known {
    if high - low >= TAU || (high - low).is_nan() {
        return Known::around([-1.0, 1.0], scale);
    }
    let [from, to] = [low - zero, high - zero];
    // Whether a place and all that are whole turns from it lie inside.
    let passes = |place: f64| ((to - place) / TAU).floor() >= ((from - place) / TAU).ceil();
    let ends = [from, to].map(|angle| Calc::sin_cos(angle).1);
    let greatest = if passes(0.0) { 1.0 } else { ends[0] };
    let least = if passes(PI) { -1.0 } else { ends[0] };
    Known::around([ends[0], ends[1], greatest, least], scale)
}

fn binary(op: Op, left: Known, right: Known, value: f64) -> Known {
    let all = |of: fn(f64, f64) -> f64, scale: f64| {
        let [a, b] = left.ends();
        let [c, d] = right.ends();
        Known::around([of(a, c), of(a, d), of(b, c), of(b, d)], scale)
    };
    match op {
        Op::Add => all(|a, b| a + b, left.scale.max(right.scale)),
        Op::Sub => all(|a, b| a - b, left.scale.max(right.scale)),
        Op::Mul => all(|a, b| a * b, left.scale * right.scale),
        Op::Div if right.contains(0.0) => Known::nothing(value.abs()),
        Op::Div => all(|a, b| a / b, left.scale / right.low.abs().min(right.high.abs())),
        // The angle of a vector.
        _ if left.contains(0.0) && right.contains(0.0) => Known::nothing(1.0),
        // Beside the angle itself: no corner is a turn away.
        _ => {
            let beside = |x: f64, y: f64| f64::direction(x, y) - value;
            let off = |x: f64, y: f64| beside(x, y) - TAU * (beside(x, y) / TAU).round();
            let [a, b] = left.ends();
            let [c, d] = right.ends();
            Known::around([off(a, c), off(a, d), off(b, c), off(b, d)], 1.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::LANGUAGES;
    use lemnis_models::kernel::record::record;
    use lemnis_models::luffing::double_link::symbols as s;

    /// Of X_1 = `a` and X_2 = `b`, how many digits a formula prints them with.
    fn printed(formula: fn(Rec, Rec) -> Rec, a: f64, b: f64) -> [String; 2] {
        let (trace, _) = record(|| formula(Rec::given(&s::X_1, a), Rec::given(&s::X_2, b)).def(&s::X_3));
        let mut numbers = Numbers::new(&LANGUAGES[0], 4);
        trace
            .steps
            .iter()
            .for_each(|step| digits_needed(&mut numbers, &trace, step));
        [(&s::X_1, a), (&s::X_2, b)].map(|(symbol, value)| numbers.number_in_formula(symbol, value).to_string())
    }

    const A: f64 = 19.302_468_135_79;

    #[test]
    fn six_digits_are_enough_for_a_sum() {
        assert_eq!(printed(|a, b| a + b, A, -6.512_345_678_9), ["19.3025", "-6.51235"]);
    }

    /// Of 2.1 mm beside 19 m half a percent is 10.5 µm: 19.3025 is known to 50 µm, 19.30247 to 5 µm, two of these to 10 µm.
    #[test]
    fn a_small_difference_gives_its_terms_more_digits() {
        let [a, b] = printed(|a, b| a - b, A, A - 0.0021);
        assert_eq!([a.len(), b.len()], [8, 8], "{a} {b}");
        // A given quantity that is short is exact.
        assert_eq!(printed(|a, b| a - b, A, 19.3), ["19.30247", "19.3"]);
    }

    #[test]
    fn a_difference_that_is_nothing_beside_its_terms_asks_for_no_more() {
        assert_eq!(printed(|a, b| a - b, A, A + 1e-9), ["19.3025", "19.3025"]);
    }

    /// The slope of a square root, of a cosine's inverse and of a fraction is great where they begin.
    #[test]
    fn a_steep_function_gives_what_it_is_of_more_digits() {
        let near = |a: Rec, b: Rec| a * (b / a).acos();
        assert_eq!(printed(near, A, 0.5 * A), ["19.3025", "9.65123"]);
        assert!(printed(near, A, 0.999_99 * A).iter().any(|number| number.len() > 7));
    }
}
