//! Formulas of the recorder in Typst's mathematics, twice: in symbols, and
//! with the numbers that stand for them.
//!
//! The numeric form keeps to a small grammar, so that it can be read back and
//! recalculated: numbers with their unit as `19.3 thin "m"` or `60 "°"`, `pi`,
//! `+`, `-`, `dot`, `frac(a, b)`, `a^2`, `sqrt(a)`, `abs(a)`, `sin(a)`,
//! `cos(a)`, `arcsin(a)`, `arccos(a)`, `arctan2(y, x)` and parentheses. A long
//! sum is broken with `\ &quad` before a sign.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use lemnis_models::record::{Node, Op, Rec, Step, Trace};
use lemnis_models::symbol::Symbol;

use crate::number::number;

/// How tightly an expression holds together, loosest first.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Level {
    /// A sum, or anything that begins with a minus sign.
    Sum,
    Product,
    Atom,
}

/// A printed expression.
struct Term {
    text: String,
    level: Level,
    /// Estimated width, in digits.
    width: f64,
}

/// Widest line, in digits of the book's font: what is left of a line beside
/// the symbol on the left and the source on the right.
const LINE: f64 = 56.0;

#[derive(Clone, Copy)]
enum Form {
    Symbols,
    Numbers,
}

/// A step's formula in symbols.
#[must_use]
pub fn symbols(trace: &Trace, step: &Step) -> String {
    broken(trace, Form::Symbols, step.formula)
}

/// A step's formula with the numbers put in.
#[must_use]
pub fn numbers(trace: &Trace, step: &Step) -> String {
    broken(trace, Form::Numbers, step.formula)
}

/// A value (in SI) in the symbol's display unit.
#[must_use]
pub fn quantity(symbol: &Symbol, value: f64) -> String {
    number(symbol.shown(value)) + &unit(symbol)
}

fn unit(symbol: &Symbol) -> String {
    match symbol.display.print {
        "" => String::new(),
        unit if unit.starts_with('°') => format!(" \"{unit}\""),
        unit => format!(" thin \"{unit}\""),
    }
}

/// The expression, broken before `+` and `-` of its outermost sum where it is too long.
fn broken(trace: &Trace, form: Form, rec: Rec) -> String {
    let whole = term(trace, form, rec);
    if whole.width <= LINE {
        return whole.text;
    }
    let mut summands = Vec::new();
    split(trace, form, rec, &mut summands);
    let (mut text, mut used) = (String::new(), 0.0);
    for (sign, summand) in summands {
        if used > 0.0 && used + summand.width > LINE {
            text += " \\ &quad";
            used = 2.0;
        }
        text += sign;
        text += &summand.text;
        used += summand.width + 2.0;
    }
    text
}

/// The summands of a sum with the sign before each.
fn split(trace: &Trace, form: Form, rec: Rec, summands: &mut Vec<(&'static str, Term)>) {
    match trace.node(rec) {
        Node::Binary(op @ (Op::Add | Op::Sub), left, right) => {
            split(trace, form, left, summands);
            let right = summand(op, term(trace, form, right));
            summands.push((if op == Op::Add { " + " } else { " - " }, right));
        }
        _ => summands.push(("", term(trace, form, rec))),
    }
}

/// The right operand of a sum or a difference.
fn summand(op: Op, right: Term) -> Term {
    if right.text.starts_with('-') || op == Op::Sub {
        within(right, Level::Product)
    } else {
        right
    }
}

/// In parentheses unless it holds together at least this tightly.
fn within(term: Term, level: Level) -> Term {
    if term.level >= level {
        return term;
    }
    Term { text: format!("({})", term.text), level: Level::Atom, width: term.width + 1.5 }
}

fn term(trace: &Trace, form: Form, rec: Rec) -> Term {
    match trace.node(rec) {
        Node::Constant(value) => constant(value),
        Node::Name(symbol) => match form {
            Form::Symbols => Term { text: symbol.print.to_owned(), level: Level::Atom, width: name_width(symbol.print) },
            Form::Numbers => numeric(quantity(symbol, trace.value(rec))),
        },
        Node::Unary(op, inner) => unary(op, term(trace, form, inner)),
        Node::Binary(op, left, right) => binary(form, op, term(trace, form, left), term(trace, form, right)),
    }
}

fn constant(value: f64) -> Term {
    let named = [(PI, "pi"), (TAU, "2 pi"), (FRAC_PI_4, "frac(pi, 4)")];
    match named.into_iter().find(|&(named, _)| named == value) {
        Some((_, text)) => Term { text: text.to_owned(), level: Level::Product, width: 2.0 },
        None => numeric(number(value)),
    }
}

/// A number, with or without unit.
fn numeric(text: String) -> Term {
    let level = match &text {
        text if text.starts_with('-') => Level::Sum,
        text if text.contains(' ') => Level::Product,
        _ => Level::Atom,
    };
    let visible = text.replace(" thin ", "").replace(['"', '^', '('], "").replace(" times ", "--");
    Term { level, width: visible.chars().count() as f64 * 0.95, text }
}

fn unary(op: Op, inner: Term) -> Term {
    let function = |name: &str| Term {
        text: format!("{name}({})", inner.text),
        level: Level::Atom,
        width: inner.width + name.len() as f64 * 0.9 + 1.5,
    };
    match op {
        Op::Sqrt => Term { width: inner.width + 2.0, ..function("sqrt") },
        Op::Abs => Term { width: inner.width + 1.5, ..function("abs") },
        Op::Sin => function("sin"),
        Op::Cos => function("cos"),
        Op::Asin => function("arcsin"),
        Op::Acos => function("arccos"),
        Op::Square => {
            let base = within(inner, Level::Atom);
            Term { text: base.text + "^2", level: Level::Product, width: base.width + 0.7 }
        }
        Op::Neg => {
            let inner = summand(Op::Sub, inner);
            Term { text: format!("-{}", inner.text), level: Level::Sum, width: inner.width + 1.0 }
        }
        Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Direction => unreachable!("{op:?} has two operands"),
    }
}

fn binary(form: Form, op: Op, left: Term, right: Term) -> Term {
    let (level, joint) = match op {
        Op::Add => (Level::Sum, " + "),
        Op::Sub => (Level::Sum, " - "),
        Op::Mul => {
            let digit = right.text.starts_with(|c: char| c.is_ascii_digit());
            (Level::Product, if matches!(form, Form::Numbers) || digit { " dot " } else { " " })
        }
        Op::Div => {
            let width = left.width.max(right.width) + 1.0;
            return Term { text: format!("frac({}, {})", left.text, right.text), level: Level::Product, width };
        }
        // The angle of the vector (x, y) is written with y first, as in arctan y/x.
        _ => {
            let width = left.width + right.width + 9.0;
            return Term { text: format!("arctan2({}, {})", right.text, left.text), level: Level::Atom, width };
        }
    };
    let (left, right) = match op {
        Op::Mul => (within(left, Level::Product), within(right, Level::Product)),
        _ => (left, summand(op, right)),
    };
    let width = left.width + right.width + if level == Level::Sum || joint == " dot " { 2.0 } else { 0.3 };
    Term { text: left.text + joint + &right.text, level, width }
}

/// Letters and digits of a name, those below the line at two thirds.
fn name_width(print: &str) -> f64 {
    let (name, index) = print.split_once('_').unwrap_or((print, ""));
    let index = index.trim_matches(['(', ')']);
    let greek = |word: &str| if word.len() > 2 && word.chars().all(char::is_alphabetic) { 1.3 } else { word.len() as f64 };
    let words = |text: &str| text.split([' ', ',']).map(greek).sum::<f64>();
    if name.starts_with("overline") { 2.5 } else { words(name) * 1.2 + words(index) * 0.75 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lemnis_models::calc::Calc;
    use lemnis_models::lemniscate::symbols as s;
    use lemnis_models::record::record;

    /// Both forms of a formula of lengths 3 m, −2 m and 0.5 m, and an angle of 30°.
    fn printed(formula: impl FnOnce([Rec; 4]) -> Rec) -> (String, String) {
        let (mut trace, formula) = record(|| {
            let [a, b, c] = [(&s::X_1, 3.0), (&s::X_2, -2.0), (&s::X_3, 0.5)].map(|(name, value)| Rec::given(name, value));
            formula([a, b, c, Rec::given(&s::BETA_0, 30.0_f64.to_radians())])
        });
        let step = Step { symbol: &s::L, formula, value: trace.value(formula) };
        trace.steps.push(step);
        (symbols(&trace, &step), numbers(&trace, &step))
    }

    #[test]
    fn parentheses_are_where_precedence_needs_them_and_nowhere_else() {
        type Formula = fn([Rec; 4]) -> Rec;
        let cases: [(Formula, &str, &str); 12] = [
            (|[a, b, c, _]| a + b * c, "X_1 + X_2 X_3", r#"3 thin "m" + (-2 thin "m") dot 0.5 thin "m""#),
            (|[a, b, c, _]| (a + b) * c, "(X_1 + X_2) X_3", r#"(3 thin "m" + (-2 thin "m")) dot 0.5 thin "m""#),
            (|[a, b, c, _]| a - (b - c), "X_1 - (X_2 - X_3)", r#"3 thin "m" - (-2 thin "m" - 0.5 thin "m")"#),
            (|[a, b, c, _]| a + (c + b), "X_1 + X_3 + X_2", r#"3 thin "m" + 0.5 thin "m" + (-2 thin "m")"#),
            (|[a, b, c, _]| a + (b + c), "X_1 + X_2 + X_3", r#"3 thin "m" + (-2 thin "m" + 0.5 thin "m")"#),
            (|[a, b, _, _]| -(a + b), "-(X_1 + X_2)", r#"-(3 thin "m" + (-2 thin "m"))"#),
            (|[a, b, _, _]| a * -b, "X_1 (-X_2)", r#"3 thin "m" dot (-(-2 thin "m"))"#),
            (|[a, b, c, _]| (a - c) / (b * c), "frac(X_1 - X_3, X_2 X_3)", r#"frac(3 thin "m" - 0.5 thin "m", (-2 thin "m") dot 0.5 thin "m")"#),
            (|[_, b, _, _]| b.square(), "X_2^2", r#"(-2 thin "m")^2"#),
            (|[a, _, c, _]| (a / c).square(), "(frac(X_1, X_3))^2", r#"(frac(3 thin "m", 0.5 thin "m"))^2"#),
            (|[a, _, _, t]| a * t.sin(), "X_1 sin(beta_0)", r#"3 thin "m" dot sin(30 "°")"#),
            (|[a, b, _, _]| Rec::direction(a, b), "arctan2(X_2, X_1)", r#"arctan2(-2 thin "m", 3 thin "m")"#),
        ];
        for (formula, in_symbols, in_numbers) in cases {
            assert_eq!(printed(formula), (in_symbols.to_owned(), in_numbers.to_owned()));
        }
    }

    #[test]
    fn circle_constants_have_names() {
        let text = |value| printed(|[a, ..]| a * Rec::constant(value)).0;
        assert_eq!(text(PI), "X_1 pi");
        assert_eq!(text(FRAC_PI_4), "X_1 frac(pi, 4)");
        assert_eq!(text(2.0), "X_1 dot 2");
    }

    #[test]
    fn a_long_sum_is_broken_before_a_sign() {
        let sum = printed(|[a, b, ..]| (0..12).fold(a, |sum, _| sum + a * b)).1;
        let lines: Vec<&str> = sum.split(" \\ &quad").collect();
        assert!(lines.len() > 2 && lines[1..].iter().all(|line| line.starts_with(" + ")), "{sum}");
    }
}
