//! Formulas of the recorder in Typst's mathematics, twice: in symbols, and
//! with the numbers that stand for them.
//!
//! The numeric form keeps to a small grammar, so that it can be read back and
//! recalculated: numbers with their unit as `19.3 thin"m"`, `60"°"` or
//! `1.2 times 10^(-5)`, with a decimal comma as `"19,3" thin"m"`, `pi`, `+`, `-`, `dot`, `slash`, `frac(a, b)`, `a^2`, `a^3`,
//! `sqrt(a)`, `abs(a)`, `sin(a)`, `cos(a)`, `arcsin(a)`, `arccos(a)`,
//! `arctan2(y, x)`, and parentheses. A long sum is broken with `\ &more` before a sign, a long `arctan2` after its comma.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

use lemnis_models::kernel::calc::Among;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::record::{Node, Op, Rec, Step, Trace};
use serde::Serialize;

use crate::language::Language;
use crate::print::factors::{Product, tidier};
use crate::print::number::Numbers;
use crate::print::text;

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
    /// Stands with a minus sign, which is not in the text.
    minus: bool,
    text: String,
    level: Level,
    /// Estimated width, in digits of the book's font.
    width: f64,
}

impl Term {
    fn atom(text: String, width: f64) -> Term {
        Term {
            minus: false,
            text,
            level: Level::Atom,
            width,
        }
    }

    fn product(minus: bool, text: String, width: f64) -> Term {
        Term {
            minus,
            text,
            level: Level::Product,
            width,
        }
    }

    /// With its sign in the text; zero has none.
    fn whole(self) -> Term {
        let after_zero = self.text.strip_prefix('0').map(|rest| rest.chars().next());
        let zero = after_zero.is_some_and(|next| next.is_none_or(|c| matches!(c, ' ' | '"')));
        if !self.minus || zero {
            return Term { minus: false, ..self };
        }
        Term {
            minus: false,
            text: format!("-{}", self.text),
            level: Level::Sum,
            width: self.width + 1.5,
        }
    }

    /// Without its sign, in parentheses unless it holds together at least this tightly.
    fn within(self, level: Level) -> Term {
        if self.level >= level {
            return self;
        }
        Term {
            text: format!("({})", self.text),
            level: Level::Atom,
            width: self.width + 1.5,
            ..self
        }
    }
}

/// Width of a line without a source beside it, and what the source takes.
const LINE: f64 = 84.0;
const SOURCE: f64 = 18.0;
/// Widths are estimated at least this much too large (4 to 15 %, measured over all scenes).
const WIDE: f64 = 1.04;

#[derive(Clone, Copy)]
enum Form {
    Symbols,
    Numbers,
}

/// What is printed, and how.
#[derive(Clone, Copy)]
struct Print<'a> {
    trace: &'a Trace,
    form: Form,
    numbers: &'a Numbers,
    /// Typeset forms of the symbols that can be linked to where they are defined.
    defined: &'a BTreeSet<&'static str>,
}

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
    pub formula: String,
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
    let name = name_width(step.symbol.print) + 3.0;
    let result = numeric(numbers.in_formula(step.symbol, step.value));
    let forms = [Form::Symbols, Form::Numbers].map(|form| Print {
        trace,
        form,
        numbers,
        defined,
    });
    let [symbols, numbers] = forms.map(|print| term(print, false, step.formula).whole());
    let repeats = !in_full || numbers.text == result.text || !is_arithmetic(trace, step.formula);
    let after = JUDGED * judged as f64;
    let line = name + symbols.width + result.width + after + 3.0 + if repeats { 0.0 } else { numbers.width + 3.0 };
    if line <= LINE - SOURCE {
        let numbers = (!repeats).then_some(numbers.text);
        return Printed {
            formula: symbols.text,
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
        formula,
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
    split(print, rec, &mut summands);
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

/// The summands of a sum with the sign before each.
fn split(print: Print, rec: Rec, summands: &mut Vec<(&'static str, Term)>) {
    match print.trace.node(rec) {
        Node::Binary(op @ (Op::Add | Op::Sub), left, right) => {
            split(print, left, summands);
            summands.push(signed(op, term(print, false, right)));
        }
        _ => summands.push(("", term(print, false, rec).whole())),
    }
}

/// The right operand of a sum or a difference, and the sign before it.
fn signed(op: Op, right: Term) -> (&'static str, Term) {
    let minus = (op == Op::Sub) != right.minus;
    let alone = op == Op::Sub || right.minus || right.text.starts_with('-');
    let right = if alone { right.within(Level::Product) } else { right };
    (if minus { " - " } else { " + " }, Term { minus: false, ..right })
}

/// `nested` inside a fraction, where another fraction is written with a slash.
fn term(print: Print, nested: bool, rec: Rec) -> Term {
    match print.trace.node(rec) {
        Node::Constant(value) => constant(print.numbers.language, value),
        Node::Name(symbol) => match print.form {
            Form::Symbols if print.defined.contains(symbol.print) => {
                let link = format!("go({}, {})", text::string(symbol.print), symbol.print);
                Term::atom(link, name_width(symbol.print))
            }
            Form::Symbols => Term::atom(symbol.print.to_owned(), name_width(symbol.print)),
            Form::Numbers => numeric(print.numbers.in_formula(symbol, print.trace.value(rec))),
        },
        Node::Unary(Op::Square, _) | Node::Binary(Op::Mul | Op::Div, ..)
            if let Some(tidy) = tidier(print.trace, rec) =>
        {
            product(print, nested, &tidy)
        }
        Node::Unary(Op::Among(Among::Of(number)), inner) => match (print.form, print.trace.node(inner)) {
            (Form::Symbols, Node::Name(symbol)) => Term::atom(symbol.numbered(number), name_width(symbol.print)),
            _ => term(print, nested, inner),
        },
        Node::Unary(op, inner) => unary(op, term(print, nested, inner)),
        Node::Binary(op, left, right) => {
            let nested_within = nested || op == Op::Div;
            let [left, right] = [left, right].map(|operand| term(print, nested_within, operand));
            binary(print.form, nested, op, left, right)
        }
    }
}

/// A product of powers, those with exponents below zero under a fraction bar.
fn product(print: Print, nested: bool, product: &Product) -> Term {
    let parted = product.factors.iter().any(|(_, exponent)| *exponent < 0);
    let side = |sign: i32| {
        let factors = product.factors.iter().filter(|(_, exponent)| exponent.signum() == sign);
        let powers = factors.map(|&(base, exponent)| power(term(print, nested || parted, base), exponent.abs()));
        powers.reduce(|left, right| binary(print.form, nested, Op::Mul, left, right))
    };
    let above = side(1).unwrap_or_else(|| constant(print.numbers.language, 1.0));
    let term = match side(-1) {
        Some(below) => binary(print.form, nested, Op::Div, above, below),
        None => above,
    };
    Term {
        minus: term.minus != product.minus,
        ..term
    }
}

fn power(base: Term, exponent: i32) -> Term {
    if exponent == 1 {
        return base;
    }
    let base = Term {
        minus: false,
        ..base.whole().within(Level::Atom)
    };
    Term::product(false, format!("{}^{exponent}", base.text), base.width + 0.7)
}

fn constant(language: &Language, value: f64) -> Term {
    let named = [(PI, "pi"), (TAU, "2 pi"), (FRAC_PI_4, "frac(pi, 4)")];
    match named.into_iter().find(|&(named, _)| named == value) {
        Some((_, text @ "pi")) => Term::atom(text.to_owned(), 2.0),
        Some((_, text)) => Term::product(false, text.to_owned(), 2.0),
        None => numeric(language.math(&short(value))),
    }
}

/// A number, with or without unit.
fn numeric(text: String) -> Term {
    let level = match &text {
        text if text.starts_with('-') => Level::Sum,
        text if text.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | ',' | '"')) => Level::Atom,
        _ => Level::Product,
    };
    let visible = text
        .replace(" thin", "")
        .replace(['"', '^', '(', ')'], "")
        .replace(" times ", "--");
    Term {
        minus: false,
        level,
        width: visible.chars().count() as f64,
        text,
    }
}

fn unary(op: Op, inner: Term) -> Term {
    let function = |name: &str, inner: Term| {
        Term::atom(
            format!("{name}({})", inner.text),
            inner.width + name.len() as f64 * 0.9 + 2.0,
        )
    };
    match op {
        Op::Sqrt => function("sqrt", inner.whole()),
        Op::Sin => function("sin", inner.whole()),
        Op::Cos => function("cos", inner.whole()),
        Op::Asin => function("arcsin", inner.whole()),
        Op::Acos => function("arccos", inner.whole()),
        Op::Abs => function("abs", inner),
        Op::Square => power(Term { minus: false, ..inner }, 2),
        Op::Neg => {
            let inner = inner.within(Level::Product);
            Term {
                minus: !inner.minus,
                ..inner
            }
        }
        Op::Among(which) => {
            let sign = match which {
                Among::Greatest => "max",
                Among::Least => "min",
                Among::Sum => "sum_i",
                Among::Of(_) => "",
            };
            let inner = inner.within(Level::Product);
            Term::product(inner.minus, format!("{sign} {}", inner.text), inner.width + 3.0)
        }
        Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Direction | Op::Derivative => {
            unreachable!("{op:?} has two operands")
        }
    }
}

fn binary(form: Form, nested: bool, op: Op, left: Term, right: Term) -> Term {
    match op {
        Op::Add | Op::Sub => {
            let (left, (sign, right)) = (left.whole(), signed(op, right));
            let width = left.width + right.width + 2.2;
            Term {
                minus: false,
                text: left.text + sign + &right.text,
                level: Level::Sum,
                width,
            }
        }
        Op::Mul => {
            let (left, right) = (left.within(Level::Product), right.within(Level::Product));
            let digit = right
                .text
                .trim_start_matches('"')
                .starts_with(|c: char| c.is_ascii_digit());
            let (joint, gap) = if matches!(form, Form::Numbers) || digit {
                (" dot ", 1.4)
            } else {
                (" ", 0.2)
            };
            Term::product(
                left.minus != right.minus,
                left.text + joint + &right.text,
                left.width + right.width + gap,
            )
        }
        Op::Div if nested => {
            let (left, right) = (left.within(Level::Product), right.within(Level::Atom));
            let width = left.width + right.width + 1.0;
            Term::product(left.minus != right.minus, left.text + " slash " + &right.text, width)
        }
        Op::Div => {
            let text = format!("frac({}, {})", left.text, right.text);
            Term::product(left.minus != right.minus, text, left.width.max(right.width) + 0.5)
        }
        Op::Derivative => {
            let (what, by) = (left.whole(), right.whole());
            let (above, beside) = match what.level {
                Level::Atom => (format!("dif {}", what.text), String::new()),
                _ => ("dif".to_owned(), format!(" ({})", what.text)),
            };
            let width = what.width.max(by.width) + 2.0;
            Term::product(false, format!("frac({above}, dif {}){beside}", by.text), width)
        }
        // The angle of the vector (x, y) is written with y first, as in arctan y/x; a long one is broken after its comma.
        _ => {
            let (x, y) = (left.whole(), right.whole());
            let width = x.width + y.width + 9.5;
            let (space, width) = if nested || width <= LINE - SOURCE {
                (" ", width)
            } else {
                (" \\ &more ", 9.5 + x.width.max(y.width))
            };
            Term::atom(format!("arctan2({},{space}{})", y.text, x.text), width)
        }
    }
}

/// Letters and digits of a name, those below the line at two thirds.
fn name_width(print: &str) -> f64 {
    let (name, index) = print.split_once('_').unwrap_or((print, ""));
    let index = index.trim_matches(['(', ')']);
    let greek = |word: &str| {
        if word.len() > 2 && word.chars().all(char::is_alphabetic) {
            1.3
        } else {
            word.len() as f64
        }
    };
    let words = |text: &str| text.split([' ', ',']).map(greek).sum::<f64>();
    if name.starts_with("overline") {
        2.5
    } else {
        words(name) * 1.2 + words(index) * 0.75
    }
}

#[cfg(test)]
mod tests {
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
                symbol: &s::L,
                formula,
                value: trace.value(formula),
                name: formula,
            },
            true,
            0,
        );
        (printed.formula, printed.numbers.unwrap_or(printed.result))
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
        let cases: [(Formula, &str, &str); 8] = [
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
