//! Numbers in equations as texts. Typst's mathematics sets every digit for itself: a number of six digits is six marks
//! on the page, and six in the PDF's tags. A text is one.

use typst_syntax::{SyntaxKind, SyntaxNode};

/// Between a number and its unit, as wide as Typst's `thin`.
const THIN: char = '\u{2006}';

/// An equation's source with each number and its unit as one text: `19.3 thin"m"` as `"19.3 m"`.
pub(super) fn in_one(equation: &SyntaxNode) -> String {
    let mut text = String::new();
    write(equation, &mut text);
    text
}

fn write(node: &SyntaxNode, text: &mut String) {
    if node.children().len() == 0 {
        *text += &node.full_text();
        return;
    }
    let children: Vec<&SyntaxNode> = node.children().collect();
    let mut done = 0;
    while let Some(&child) = children.get(done) {
        match quantity(&children[..done], &children[done..]) {
            Some((quantity, nodes)) => {
                *text += &format!("\"{quantity}\"");
                done += nodes;
                // A text keeps the space around it, and only a solidus does not set off itself.
                done += usize::from(children.get(done + 1).is_some_and(|next| next.full_text() == "slash"));
            }
            None => {
                write(child, text);
                done += 1;
            }
        }
    }
}

/// The quantity that nodes begin with, and how many they are. A single digit is one mark by itself, and a number that
/// stands beside its factor would get the space that there is around a text.
fn quantity(before: &[&SyntaxNode], nodes: &[&SyntaxNode]) -> Option<(String, usize)> {
    let number = content(nodes.first()?).filter(|text| text.starts_with(|c: char| c.is_ascii_digit()))?;
    let visible = |(_, node): &(usize, &&SyntaxNode)| node.kind() != SyntaxKind::Space;
    let mut rest = nodes.iter().enumerate().skip(1).filter(visible);
    match rest.next() {
        Some((last, unit)) if unit.kind() == SyntaxKind::Str && unit.full_text().starts_with("\"°") => {
            Some((number + &content(unit)?, last + 1))
        }
        Some((_, thin)) if thin.full_text() == "thin" => {
            let (last, unit) = rest.next().filter(|(_, unit)| unit.kind() == SyntaxKind::Str)?;
            Some((format!("{number}{THIN}{}", content(unit)?), last + 1))
        }
        next => {
            let mut before = before.iter().rev().filter(|node| node.kind() != SyntaxKind::Space);
            let alone = is_apart(before.next()) && is_apart(next.map(|(_, node)| node));
            (alone && number.len() > 1).then_some((number, 1))
        }
    }
}

/// What a number or a text in quotes says.
fn content(node: &SyntaxNode) -> Option<String> {
    let is_text = matches!(node.kind(), SyntaxKind::MathText | SyntaxKind::Str);
    is_text.then(|| node.full_text().trim_matches('"').to_owned())
}

/// Whether what stands beside a number is no factor of it: nothing, an operator, or an end.
fn is_apart(node: Option<&&SyntaxNode>) -> bool {
    let ends = [SyntaxKind::Dollar, SyntaxKind::Linebreak, SyntaxKind::MathAlignPoint];
    let signs = ["=", "+", "-", "dot", "times", "<=", ">=", "plus.minus", "(", ",", ")"];
    node.is_none_or(|node| ends.contains(&node.kind()) || signs.contains(&node.full_text().as_str()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_and_its_unit_are_one_text() {
        for (equation, text) in [
            (r#"19.3 thin"m" dot cos(120"°")"#, r#""19.3 m" dot cos("120°")"#),
            (r#"frac(-2 thin"m", 16.5)"#, r#"frac(-"2 m", "16.5")"#),
            (
                r#"("0,5" thin"m")^2 slash (9 thin "m")"#,
                r#"("0,5 m")^2 slash ("9 m")"#,
            ),
            (
                r#"K &= -2.35551 \ &= 1.5 times 10^(-5) thin"m""#,
                r#"K &= -"2.35551" \ &= "1.5" times 10^(-5) thin"m""#,
            ),
            ("0.5 X_12 + 2 + 12 pi", "0.5 X_12 + 2 + 12 pi"),
            (r#"M_"ur" = 2 >= 30"%""#, r#"M_"ur" = 2 >= 30"%""#),
        ] {
            let source = typst_syntax::parse_math(equation);
            assert_eq!(in_one(&source).replace(THIN, " "), text);
        }
    }
}
