//! Products as a person writes them: equal factors as a power, and a division by what one over it is multiplied with.

use lemnis_models::kernel::record::{Node, Op, Rec, Trace};

/// A product: its sign, and its factors with their exponents, none of them zero.
pub(super) struct Product {
    pub minus: bool,
    pub factors: Vec<(Rec, i32)>,
}

/// How far the value of a product may be from that of the expression that it stands for: rounding.
const ROUNDING: f64 = 1e-12;

/// The factors of an expression, where some are equal, or where something is multiplied with one over another: only
/// then it is written in another way than it is calculated. Its value is proved to be that of the expression.
pub(super) fn tidier(trace: &Trace, rec: Rec) -> Option<Product> {
    let mut found = Found::default();
    found.collect(trace, rec, 1);
    let Found {
        minus,
        mut factors,
        tidier,
    } = found;
    factors.retain(|(_, exponent)| *exponent != 0);
    let size = |(base, exponent): &(Rec, i32)| trace.value(*base).powi(*exponent);
    let value = factors.iter().map(size).product::<f64>() * if minus { -1.0 } else { 1.0 };
    let expected = trace.value(rec);
    let same = (value - expected).abs() <= ROUNDING * expected.abs();
    (tidier && same).then_some(Product { minus, factors })
}

#[derive(Default)]
struct Found {
    minus: bool,
    factors: Vec<(Rec, i32)>,
    tidier: bool,
}

impl Found {
    /// The factors of an expression to the power of an exponent.
    fn collect(&mut self, trace: &Trace, rec: Rec, exponent: i32) {
        match trace.node(rec) {
            Node::Binary(Op::Mul, left, right) => {
                self.collect(trace, left, exponent);
                self.collect(trace, right, exponent);
            }
            Node::Binary(Op::Div, left, right) => {
                self.collect(trace, left, exponent);
                self.collect(trace, right, -exponent);
            }
            Node::Unary(Op::Square, inner) => self.collect(trace, inner, 2 * exponent),
            Node::Unary(Op::Neg, inner) => {
                self.minus ^= exponent % 2 != 0;
                self.collect(trace, inner, exponent);
            }
            Node::Constant(1.0) => self.tidier = true,
            Node::Constant(-1.0) => {
                self.minus ^= exponent % 2 != 0;
                self.tidier = true;
            }
            _ => match self.factors.iter_mut().find(|(base, _)| alike(trace, *base, rec)) {
                Some((_, sum)) => (*sum, self.tidier) = (*sum + exponent, true),
                None => self.factors.push((rec, exponent)),
            },
        }
    }
}

/// Whether two expressions are written alike.
fn alike(trace: &Trace, a: Rec, b: Rec) -> bool {
    match (trace.node(a), trace.node(b)) {
        (Node::Constant(a), Node::Constant(b)) => a == b,
        (Node::Name(a), Node::Name(b)) => a == b,
        (Node::Unary(op, a), Node::Unary(other, b)) => op == other && alike(trace, a, b),
        (Node::Binary(op, a, b), Node::Binary(other, c, d)) => op == other && alike(trace, a, c) && alike(trace, b, d),
        _ => false,
    }
}
