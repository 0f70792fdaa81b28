//! Expressions of the recorder, term by term, in the grammar of [`crate::print::formula`].

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

use lemnis_models::kernel::calc::Among;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::record::{Node, Op, Rec, Trace};

use crate::language::Language;
use crate::print::factors::{Product, tidier};
use crate::print::number::Numbers;
use crate::print::text;
use crate::print::width;

/// How tightly an expression holds together, loosest first.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub(super) enum Level {
    /// A sum, or anything that begins with a minus sign.
    Sum,
    Product,
    Atom,
}

/// A printed expression.
pub(super) struct Term {
    /// Stands with a minus sign, which is not in the text.
    pub minus: bool,
    pub text: String,
    pub level: Level,
    /// Estimated width, in digits of the book's font.
    pub width: f64,
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
    pub fn whole(self) -> Term {
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
    pub fn within(self, level: Level) -> Term {
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
pub(super) const LINE: f64 = 84.0;
pub(super) const SOURCE: f64 = 18.0;

#[derive(Clone, Copy)]
pub(super) enum Form {
    Symbols,
    Numbers,
}

/// What is printed, and how.
#[derive(Clone, Copy)]
pub(super) struct Print<'a> {
    pub trace: &'a Trace,
    pub form: Form,
    pub numbers: &'a Numbers,
    /// Typeset forms of the symbols that can be linked to where they are defined.
    pub defined: &'a BTreeSet<&'static str>,
}

/// The right operand of a sum or a difference, and the sign before it.
pub(super) fn signed(op: Op, right: Term) -> (&'static str, Term) {
    let minus = (op == Op::Sub) != right.minus;
    let alone = op == Op::Sub || right.minus || right.text.starts_with('-');
    let right = if alone { right.within(Level::Product) } else { right };
    (if minus { " - " } else { " + " }, Term { minus: false, ..right })
}

/// `nested` inside a fraction, where another fraction is written with a slash.
pub(super) fn term(print: Print, nested: bool, rec: Rec) -> Term {
    match print.trace.node(rec) {
        Node::Constant(value) => constant(print.numbers.language, value),
        Node::Name(symbol) => match print.form {
            Form::Symbols if print.defined.contains(symbol.print) => {
                let link = format!("go({}, {})", text::string(symbol.print), symbol.print);
                Term::atom(link, width::name(symbol.print))
            }
            Form::Symbols => Term::atom(symbol.print.to_owned(), width::name(symbol.print)),
            Form::Numbers => numeric(print.numbers.in_formula(symbol, print.trace.value(rec))),
        },
        Node::Unary(Op::Square, _) | Node::Binary(Op::Mul | Op::Div, ..)
            if let Some(tidy) = tidier(print.trace, rec) =>
        {
            product(print, nested, &tidy)
        }
        Node::Unary(Op::Among(Among::Of(number)), inner) => match (print.form, print.trace.node(inner)) {
            (Form::Symbols, Node::Name(symbol)) => Term::atom(symbol.numbered(number), width::name(symbol.print)),
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
    // What is left may be a lone sum.
    let term = if product.minus {
        term.within(Level::Product)
    } else {
        term
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
pub(super) fn numeric(text: String) -> Term {
    let level = match &text {
        text if text.starts_with('-') => Level::Sum,
        text if text.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | ',' | '"')) => Level::Atom,
        _ => Level::Product,
    };
    Term {
        minus: false,
        level,
        width: width::number(&text),
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
        Op::Power([above, 1]) => power(inner, above.into()),
        Op::Power([above, below]) => {
            let inner = inner.whole().within(Level::Atom);
            Term::product(false, format!("{}^({above}\\/{below})", inner.text), inner.width + 2.0)
        }
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
