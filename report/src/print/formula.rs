//! Formulas of the recorder in Typst's mathematics, twice: in symbols, and
//! with the numbers that stand for them.
//!
//! The numeric form keeps to a small grammar, so that it can be read back and
//! recalculated: numbers with their unit as `19.3 thin"m"`, `60"°"` or
//! `1.2 times 10^(-5)`, with a decimal comma as `"19,3" thin"m"`, `pi`, `+`, `-`, `dot`, `slash`, `frac(a, b)`, `a^2`, `a^3`,
//! `a^(10\/9)`, `sqrt(a)`, `abs(a)`, `sin(a)`, `cos(a)`, `arcsin(a)`, `arccos(a)`,
//! `arctan2(y, x)`, and parentheses. A long sum is broken with `\ &more` before a sign, a long `arctan2` after its comma.

use std::collections::BTreeSet;

use lemnis_models::kernel::calc::Among;
use lemnis_models::kernel::record::{Node, Op, Rec, Step, Trace};
use serde::Serialize;

use crate::print::number::Numbers;
use crate::print::term::{Form, LINE, Print, SOURCE, Term, numeric, signed, term};
use crate::print::width;

/// Widths are estimated at least this much too large (4 to 15 %, measured over all scenes).
const WIDE: f64 = 1.04;

/// How a step is set.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Layout {
    /// Formula, numbers and result in one line.
    Line,
    /// A line for each, and more for a long sum.
    Lines,
}

/// A step in Typst's mathematics.
#[derive(Debug)]
pub struct Printed {
    /// `None` where a search has found the number: it stands for itself.
    pub formula: Option<String>,
    /// The formula with the numbers put in; `None` where that repeats the result.
    pub numbers: Option<String>,
    pub result: String,
    pub layout: Layout,
    /// Of the type, in percent: below 100 where lines would not fit otherwise.
    pub size: u32,
}

/// Width of a requirement that stands after the result.
const JUDGED: f64 = 30.0;

/// A step of a recorded calculation, with its numbers put in where `in_full`; so many requirements follow its result.
#[must_use]
pub fn step(
    numbers: &Numbers,
    defined: &BTreeSet<&'static str>,
    trace: &Trace,
    step: &Step,
    in_full: bool,
    judged: usize,
) -> Printed {
    let name = width::name(step.symbol.print) + 3.0;
    let result = numeric(numbers.in_formula(step.symbol, step.value));
    let forms = [Form::Symbols, Form::Numbers].map(|form| Print {
        trace,
        form,
        numbers,
        defined,
    });
    let [symbols, numbers] = forms.map(|print| term(print, false, step.formula).whole());
    // What was found by numbers stands for itself.
    let found = match trace.node(step.formula) {
        Node::Constant(_) => true,
        Node::Name(symbol) => symbol == step.symbol,
        _ => false,
    };
    let repeats = found || !in_full || numbers.text == result.text || !is_arithmetic(trace, step.formula);
    let after = JUDGED * judged as f64;
    let line = name + symbols.width + result.width + after + 3.0 + if repeats { 0.0 } else { numbers.width + 3.0 };
    if line <= LINE - SOURCE {
        let numbers = (!repeats).then_some(numbers.text);
        return Printed {
            formula: (!found).then_some(symbols.text),
            numbers,
            result: result.text,
            layout: Layout::Line,
            size: 100,
        };
    }
    let (formula, formula_width) = broken(forms[0], step.formula, LINE - SOURCE - name);
    let (numbers, numbers_width) = broken(forms[1], step.formula, LINE - name);
    let widest = (formula_width + SOURCE).max(if repeats { 0.0 } else { numbers_width });
    let widest = name + widest.max(result.width + after);
    Printed {
        formula: Some(formula),
        numbers: (!repeats).then_some(numbers),
        result: result.text,
        layout: Layout::Lines,
        size: (100.0 * WIDE * LINE / widest).min(100.0) as u32,
    }
}

/// Whether numbers in the places of all names say what the expression says: neither of how one changes with another nor
/// of many bodies.
fn is_arithmetic(trace: &Trace, rec: Rec) -> bool {
    match trace.node(rec) {
        Node::Constant(_) | Node::Name(_) => true,
        Node::Unary(Op::Among(which), _) => matches!(which, Among::Of(_)),
        Node::Binary(Op::Derivative, ..) => false,
        Node::Unary(_, inner) => is_arithmetic(trace, inner),
        Node::Binary(_, left, right) => is_arithmetic(trace, left) && is_arithmetic(trace, right),
    }
}

/// The expression, broken before `+` and `-` of its outermost sum where it is
/// too long, with the width of its longest line.
fn broken(print: Print, rec: Rec, room: f64) -> (String, f64) {
    let mut summands = Vec::new();
    split(print, None, rec, &mut summands);
    let (mut text, mut used, mut widest) = (String::new(), 0.0, 0.0_f64);
    for (sign, summand) in summands {
        if used > 0.0 && used + summand.width + 2.0 > room {
            text += " \\ &more";
            used = 2.0;
        }
        text += sign;
        text += &summand.text;
        used += summand.width + 2.0;
        widest = widest.max(used);
    }
    (text, widest)
}

/// The summands of a sum with the sign before each; a sum that is added is its summands.
fn split(print: Print, before: Option<Op>, rec: Rec, summands: &mut Vec<(&'static str, Term)>) {
    match (print.trace.node(rec), before) {
        (Node::Binary(op @ (Op::Add | Op::Sub), left, right), None | Some(Op::Add)) => {
            split(print, before, left, summands);
            split(print, Some(op), right, summands);
        }
        (_, Some(op)) => summands.push(signed(op, term(print, false, rec))),
        (_, None) => summands.push(("", term(print, false, rec).whole())),
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_4, PI};

    use super::*;
    use crate::language::LANGUAGES;
    use lemnis_models::kernel::calc::Calc;
    use lemnis_models::kernel::record::record;
    use lemnis_models::luffing::double_link::symbols as s;

    /// Both forms of a formula of lengths 3 m, −2 m and 0.5 m, and an angle of 30°.
    fn printed(formula: impl FnOnce([Rec; 4]) -> Rec) -> (String, String) {
        let (trace, formula) = record(|| {
            let [a, b, c] =
                [(&s::X_1, 3.0), (&s::X_2, -2.0), (&s::X_3, 0.5)].map(|(name, value)| Rec::given(name, value));
            formula([a, b, c, Rec::given(&s::BETA_0, 30.0_f64.to_radians())])
        });
        let printed = step(
            &Numbers::new(&LANGUAGES[0], 4),
            &BTreeSet::new(),
            &trace,
            &Step {
                number: None,
                symbol: &s::L,
                formula,
                value: trace.value(formula),
                name: formula,
            },
            true,
            0,
        );
        (
            printed.formula.unwrap_or_default(),
            printed.numbers.unwrap_or(printed.result),
        )
    }

    #[test]
    fn parentheses_are_where_precedence_needs_them_and_nowhere_else() {
        type Formula = fn([Rec; 4]) -> Rec;
        let cases: [(Formula, &str, &str); 14] = [
            (
                |[a, b, c, _]| a + b * c,
                "X_1 + X_2 X_3",
                r#"3 thin"m" + (-2 thin"m") dot 0.5 thin"m""#,
            ),
            (
                |[a, b, c, _]| (a + b) * c,
                "(X_1 + X_2) X_3",
                r#"(3 thin"m" + (-2 thin"m")) dot 0.5 thin"m""#,
            ),
            (
                |[a, b, c, _]| a - (b - c),
                "X_1 - (X_2 - X_3)",
                r#"3 thin"m" - (-2 thin"m" - 0.5 thin"m")"#,
            ),
            (
                |[a, b, c, _]| a + (c + b),
                "X_1 + X_3 + X_2",
                r#"3 thin"m" + 0.5 thin"m" + (-2 thin"m")"#,
            ),
            (
                |[a, b, c, _]| a + (b + c),
                "X_1 + X_2 + X_3",
                r#"3 thin"m" + (-2 thin"m" + 0.5 thin"m")"#,
            ),
            (
                |[a, b, _, _]| -(a + b),
                "-(X_1 + X_2)",
                r#"-(3 thin"m" + (-2 thin"m"))"#,
            ),
            (
                |[a, b, c, _]| a - (-b) * c,
                "X_1 + X_2 X_3",
                r#"3 thin"m" + (-2 thin"m") dot 0.5 thin"m""#,
            ),
            (|[a, b, _, _]| a * -b, "-X_1 X_2", r#"-3 thin"m" dot (-2 thin"m")"#),
            (
                |[a, b, c, _]| a / (b / c),
                "frac(X_1, X_2 slash X_3)",
                r#"frac(3 thin"m", (-2 thin"m") slash (0.5 thin"m"))"#,
            ),
            (
                |[a, b, c, _]| (a - c) / (b * c),
                "frac(X_1 - X_3, X_2 X_3)",
                r#"frac(3 thin"m" - 0.5 thin"m", (-2 thin"m") dot 0.5 thin"m")"#,
            ),
            (|[_, b, _, _]| (-b).square(), "X_2^2", r#"(-2 thin"m")^2"#),
            (
                |[a, _, c, _]| (a / c).square(),
                "(frac(X_1, X_3))^2",
                r#"(frac(3 thin"m", 0.5 thin"m"))^2"#,
            ),
            (
                |[a, _, _, t]| a * t.sin(),
                "X_1 sin(beta_0)",
                r#"3 thin"m" dot sin(30"°")"#,
            ),
            (
                |[a, b, _, _]| Rec::direction(a, b),
                "arctan2(X_2, X_1)",
                r#"arctan2(-2 thin"m", 3 thin"m")"#,
            ),
        ];
        for (formula, in_symbols, in_numbers) in cases {
            assert_eq!(printed(formula), (in_symbols.to_owned(), in_numbers.to_owned()));
        }
    }

    #[test]
    fn equal_factors_are_powers() {
        type Formula = fn([Rec; 4]) -> Rec;
        let cases: [(Formula, &str, &str); 10] = [
            (|[a, b, ..]| a * b * a, "X_1^2 X_2", r#"(3 thin"m")^2 dot (-2 thin"m")"#),
            (
                |[a, _, c, _]| a * a.square() / c,
                "frac(X_1^3, X_3)",
                r#"frac((3 thin"m")^3, 0.5 thin"m")"#,
            ),
            (
                |[a, b, ..]| a * (Rec::constant(1.0) / b),
                "frac(X_1, X_2)",
                r#"frac(3 thin"m", -2 thin"m")"#,
            ),
            (
                |[a, b, ..]| -a * b * a,
                "-X_1^2 X_2",
                r#"-(3 thin"m")^2 dot (-2 thin"m")"#,
            ),
            (
                |[a, b, c, _]| (a - b) * c * (a - b),
                "(X_1 - X_2)^2 X_3",
                r#"(3 thin"m" - (-2 thin"m"))^2 dot 0.5 thin"m""#,
            ),
            (
                |[a, ..]| Rec::constant(PI) * a * Rec::constant(PI).square(),
                "pi^3 X_1",
                r#"pi^3 dot 3 thin"m""#,
            ),
            (
                |[a, b, c, _]| a * b / (a * c),
                "frac(X_2, X_3)",
                r#"frac(-2 thin"m", 0.5 thin"m")"#,
            ),
            (
                |[a, b, c, _]| (a * c + b) / Rec::constant(-1.0),
                "-(X_1 X_3 + X_2)",
                r#"-(3 thin"m" dot 0.5 thin"m" + (-2 thin"m"))"#,
            ),
            (
                |[a, b, ..]| Rec::constant(1.0) * -(a - b),
                "-(X_1 - X_2)",
                r#"-(3 thin"m" - (-2 thin"m"))"#,
            ),
            // Nothing is equal: as it is calculated.
            (
                |[a, b, c, _]| a / c * b,
                "frac(X_1, X_3) X_2",
                r#"frac(3 thin"m", 0.5 thin"m") dot (-2 thin"m")"#,
            ),
        ];
        for (formula, in_symbols, in_numbers) in cases {
            assert_eq!(printed(formula), (in_symbols.to_owned(), in_numbers.to_owned()));
        }
    }

    #[test]
    fn zero_has_no_sign() {
        let numbers = |formula: fn([Rec; 4]) -> Rec| printed(formula).1;
        assert_eq!(numbers(|[a, ..]| -(a - a)), r#"-(3 thin"m" - 3 thin"m")"#);
        let zero = |formula: fn(Rec, Rec) -> Rec| printed(move |[a, ..]| formula(Rec::given(&s::X_7, -0.0), a)).1;
        assert_eq!(zero(|zero, _| -zero), r#"0 thin"m""#);
        assert_eq!(zero(|zero, a| -(zero * a)), r#"0 thin"m" dot 3 thin"m""#);
        assert_eq!(printed(|[_, _, c, _]| -c).1, r#"-0.5 thin"m""#);
    }

    #[test]
    fn circle_constants_have_names() {
        let text = |value| printed(|[a, ..]| a * Rec::constant(value)).0;
        assert_eq!(text(PI), "X_1 pi");
        assert_eq!(text(FRAC_PI_4), "X_1 frac(pi, 4)");
        assert_eq!(text(2.0), "X_1 dot 2");
    }

    #[test]
    fn a_long_angle_is_broken_after_its_comma() {
        let long = |a: Rec, b: Rec| (0..3).fold(a, |sum, _| sum + a * b);
        let (symbols, numbers) = printed(|[a, b, c, _]| Rec::direction(long(a, b), long(b, c)));
        assert!(
            !symbols.contains("more") && numbers.matches(", \\ &more ").count() == 1,
            "{symbols} {numbers}"
        );
    }

    #[test]
    fn a_long_sum_is_broken_before_a_sign() {
        let sum = printed(|[a, b, ..]| (0..12).fold(a, |sum, _| sum + a * b)).1;
        let lines: Vec<&str> = sum.split(" \\ &more").collect();
        assert!(
            lines.len() > 1 && lines[1..].iter().all(|line| line.starts_with(" + ")),
            "{sum}"
        );
    }
}
