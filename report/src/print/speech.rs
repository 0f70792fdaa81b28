//! Equations in words, for a screen reader. Every equation of the book's Typst
//! source gets the words of the book's language, made from the equation itself:
//! `$M_Q = Q Y'_A$` becomes `#say("M Q equals Q times Y prime A")[$M_Q = Q Y'_A$];`.

use typst_syntax::{SyntaxKind, SyntaxNode, parse};

use crate::language::Words;
use crate::print::quantity::in_one;
use crate::print::text::string;

/// The source with words at every equation, and quantities there as texts.
///
/// # Errors
/// A letter or an operation that the language has no words for.
pub(crate) fn accessible(source: &str, words: &Words) -> Result<String, String> {
    let mut text = String::with_capacity(2 * source.len());
    rewrite(&parse(source), false, words, &mut text)?;
    Ok(text)
}

fn rewrite(node: &SyntaxNode, in_markup: bool, words: &Words, text: &mut String) -> Result<(), String> {
    if node.kind() == SyntaxKind::Equation {
        let spoken: Vec<String> = node
            .children()
            .map(|child| sequence(child, words))
            .collect::<Result<_, _>>()?;
        let spoken = string(spoken.concat().trim());
        let equation = in_one(node);
        let (hash, end) = if in_markup { ("#", ";") } else { ("", "") };
        *text += &format!("{hash}say({spoken})[{equation}]{end}");
        return Ok(());
    }
    if node.children().len() == 0 {
        text.push_str(&node.full_text());
    }
    node.children()
        .try_for_each(|child| rewrite(child, node.kind() == SyntaxKind::Markup, words, text))
}

/// What stands side by side, with "times" between two factors.
fn sequence(node: &SyntaxNode, words: &Words) -> Result<String, String> {
    let mut spoken: Vec<String> = Vec::new();
    let mut after_factor = false;
    for child in node.children() {
        let source = child.full_text();
        if let Some(operator) = operator(child.kind(), &source) {
            if !operator.is_empty() {
                spoken.push(words.get("speech", operator)?.to_owned());
            }
            // Thin space sets off a unit or a factor, and is nothing by itself.
            after_factor &= source == "thin" || operator.is_empty() && source != "more";
            continue;
        }
        match child.kind() {
            // A unit, or what a language writes in quotes.
            SyntaxKind::Str => {
                let text = source.trim_matches('"');
                let number = text.starts_with(|c: char| c.is_ascii_digit());
                if number && after_factor {
                    spoken.push(words.get("speech", "times")?.to_owned());
                }
                spoken.push(text.to_owned());
                after_factor = true;
                continue;
            }
            SyntaxKind::MathText if matches!(source.as_str(), "°" | "," | ";" | "|" | "(" | ")" | "[" | "]") => {
                spoken.push(source.to_string());
                after_factor = source == "°";
                continue;
            }
            _ => {}
        }
        if after_factor {
            spoken.push(words.get("speech", "times")?.to_owned());
        }
        spoken.push(term(child, words)?);
        after_factor = !matches!(source.as_str(), "dif" | "Delta" | "sin" | "cos");
    }
    Ok(spoken.join(" "))
}

/// The word of an operator; empty for what is not spoken.
fn operator(kind: SyntaxKind, source: &str) -> Option<&'static str> {
    let silent = [
        SyntaxKind::Space,
        SyntaxKind::MathAlignPoint,
        SyntaxKind::Linebreak,
        SyntaxKind::Dollar,
        SyntaxKind::Hash,
        // Around an index or an exponent; others belong to a node of their own.
        SyntaxKind::LeftParen,
        SyntaxKind::RightParen,
    ];
    Some(match source {
        "=" => "equals",
        "+" => "plus",
        "-" | "−" => "minus",
        "plus.minus" => "plus_minus",
        "max" => "maximum",
        "min" => "minimum",
        "dot" | "times" => "times",
        "slash" | "\\/" | "/" => "over",
        "<=" => "at_most",
        ">=" => "at_least",
        "thin" | "more" | "quad" => "",
        _ if silent.contains(&kind) => "",
        _ => return None,
    })
}

fn term(node: &SyntaxNode, words: &Words) -> Result<String, String> {
    let source = node.full_text();
    match node.kind() {
        SyntaxKind::MathIdent => Ok(words.get("letter", &source)?.to_owned()),
        SyntaxKind::MathAttach => attached(node, words),
        SyntaxKind::MathCall => {
            let function = node.children().next().map(SyntaxNode::full_text).unwrap_or_default();
            // A link says what it links from.
            if function == "go" {
                return parts(node).get(1).map_or(Ok(String::new()), |part| match part.kind() {
                    SyntaxKind::Math => sequence(part, words),
                    _ => term(part, words),
                });
            }
            if function == "overline" {
                let name = node
                    .children()
                    .nth(1)
                    .map_or(Ok(String::new()), |name| index(name, words))?;
                return Ok(fill(words.get("speech", "overline")?, &[name]));
            }
            let simple = |i: usize| {
                parts(node)
                    .get(i)
                    .is_some_and(|part| part.is_empty() || is_simple(part))
            };
            let id = match function.as_str() {
                "frac" if !simple(0) || !simple(1) => "fraction",
                function => function,
            };
            Ok(fill(words.get("speech", id)?, &arguments(node, words)?))
        }
        SyntaxKind::MathDelimited => bracketed(&inside(node, words)?, words),
        SyntaxKind::Math | SyntaxKind::MathFrac => sequence(node, words),
        _ => Ok(source.to_string()),
    }
}

/// A name with index, prime or power.
fn attached(node: &SyntaxNode, words: &Words) -> Result<String, String> {
    let mut spoken = String::new();
    let mut mark = SyntaxKind::End;
    for child in node.children() {
        match (child.kind(), mark) {
            (SyntaxKind::Hat | SyntaxKind::Underscore, _) => {
                mark = child.kind();
                continue;
            }
            (SyntaxKind::MathPrimes, _) => {
                for _ in child.full_text().chars() {
                    spoken = format!("{spoken} {}", words.get("speech", "prime")?);
                }
            }
            (_, SyntaxKind::Hat) if child.full_text() == "2" => {
                spoken = fill(words.get("speech", "squared")?, &[spoken])
            }
            (_, SyntaxKind::Hat) => spoken = fill(words.get("speech", "power")?, &[spoken, term(child, words)?]),
            (_, SyntaxKind::Underscore) => spoken = format!("{spoken} {}", index(child, words)?),
            _ => spoken += &term(child, words)?,
        }
    }
    Ok(spoken)
}

/// Letters and digits one after the other, without a product between them.
fn index(node: &SyntaxNode, words: &Words) -> Result<String, String> {
    if node.children().len() == 0 {
        return match node.kind() {
            SyntaxKind::MathIdent if node.full_text().len() > 1 => match words.get("letter", &node.full_text()) {
                Ok(letter) => Ok(letter.to_owned()),
                Err(_) => Ok(node.full_text().to_string()),
            },
            SyntaxKind::MathText if node.full_text() == "," => Ok(String::new()),
            SyntaxKind::MathText | SyntaxKind::MathIdent => Ok(node.full_text().to_string()),
            SyntaxKind::Str => Ok(node.full_text().trim_matches('"').to_owned()),
            _ => Ok(String::new()),
        };
    }
    let spoken: Vec<String> = node
        .children()
        .map(|child| index(child, words))
        .collect::<Result<_, _>>()?;
    let spoken: Vec<&str> = spoken
        .iter()
        .map(|word| word.trim())
        .filter(|word| !word.is_empty())
        .collect();
    Ok(spoken.join(" "))
}

/// The arguments of a call, each without what separates it from the next.
fn parts(call: &SyntaxNode) -> Vec<&SyntaxNode> {
    let arguments = call.children().find(|child| child.kind() == SyntaxKind::MathArgs);
    let separators = [
        SyntaxKind::LeftParen,
        SyntaxKind::RightParen,
        SyntaxKind::Comma,
        SyntaxKind::Space,
    ];
    arguments.map_or(Vec::new(), |arguments| {
        arguments
            .children()
            .filter(|child| !separators.contains(&child.kind()))
            .collect()
    })
}

/// Whether nothing can be misunderstood without parentheses.
fn is_simple(part: &SyntaxNode) -> bool {
    let is_operand = |child: &&SyntaxNode| {
        // A number and its unit are one, and a line's end is nothing.
        let source = child.full_text();
        let silent = child.kind() == SyntaxKind::Str || operator(child.kind(), &source) == Some("");
        !silent && source != "°"
    };
    part.kind() != SyntaxKind::Math || part.children().filter(is_operand).count() <= 1
}

fn arguments(call: &SyntaxNode, words: &Words) -> Result<Vec<String>, String> {
    let function = call.children().next().map(SyntaxNode::full_text).unwrap_or_default();
    let spoken = |part: &&SyntaxNode| {
        let spoken = match part.kind() {
            SyntaxKind::Math => sequence(part, words)?,
            _ => term(part, words)?,
        };
        // A fraction says itself where its parts end.
        if is_simple(part) || function == "frac" {
            Ok(spoken)
        } else {
            bracketed(&spoken, words)
        }
    };
    parts(call).iter().map(spoken).collect()
}

fn bracketed(spoken: &str, words: &Words) -> Result<String, String> {
    Ok(fill(words.get("speech", "parentheses")?, &[spoken.to_owned()]))
}

/// What stands between two delimiters.
fn inside(node: &SyntaxNode, words: &Words) -> Result<String, String> {
    let inner = node.children().find(|child| child.kind() == SyntaxKind::Math);
    inner.map_or(Ok(String::new()), |inner| sequence(inner, words))
}

/// Puts the parts in for `{a}` and `{b}`.
fn fill(pattern: &str, parts: &[String]) -> String {
    let places = ["{a}", "{b}"];
    parts
        .iter()
        .zip(places)
        .fold(pattern.to_owned(), |text, (part, place)| text.replace(place, part))
}

#[cfg(test)]
mod tests {
    use typst_syntax::parse_math;

    use super::*;
    use crate::language::LANGUAGES;

    #[test]
    fn equations_are_spoken_as_one_reads_them() {
        let words = Words::new(&LANGUAGES[0], [], None).expect("TOML");
        for (equation, spoken) in [
            ("M_Q &= Q Y'_A", "M Q equals Q times Y prime A"),
            (r#"160 thin"kN" dot 0.5 thin"m""#, "160 kN times 0.5 m"),
            (r#""19,3" thin"m" dot "0,5""#, "19,3 m times 0,5"),
            (
                r#"60"°" + (-2 thin"m")^2"#,
                "60 ° plus open parenthesis minus 2 m close parenthesis squared",
            ),
            (
                "frac(X_4 sin(beta_0), X_2)",
                "fraction X 4 times sine of beta 0 over X 2 end of fraction",
            ),
            ("frac(X_1, X_2)", "X 1 over X 2"),
            (
                "sqrt(x_B^2 + L_(2 x)^2)",
                "square root of open parenthesis x B squared plus L 2 x squared close parenthesis",
            ),
            (r#"30"°" >= 20"°" quad "passed""#, "30 ° at least 20 ° passed"),
            ("arctan2(y_B, x_B)", "arc tangent of y B over x B"),
            (
                r"arctan2(y_B, \ &more x_B + x_C)",
                "arc tangent of y B over open parenthesis x B plus x C close parenthesis",
            ),
            ("a/b", "a over b"),
            ("2 pi overline(O_1 P)", "2 times pi times distance O 1 P"),
            ("1.5 times 10^(-5)", "1.5 times 10 to the power of minus 5"),
            ("M_(Q,max) <= infinity", "M Q max at most infinity"),
            (r#"dot(omega)_"sl" = x''_1"#, "omega dot sl equals x prime prime 1"),
            (r"Q thin dif Y_A \/ dif theta_1", "Q times d Y A over d theta 1"),
            ("u_max = max u_i", "u max equals maximum of u i"),
            (r#"x = 2 plus.minus 1 "m""#, "x equals 2 plus or minus 1 m"),
        ] {
            let source = accessible(&format!("${equation}$"), &words).expect("words");
            let printed = in_one(&parse_math(equation));
            assert_eq!(source, format!("#say({})[${printed}$];", string(spoken)));
        }
    }

    #[test]
    fn the_rest_of_the_source_stays_as_it_is() {
        let words = Words::new(&LANGUAGES[0], [], None).expect("TOML");
        let source = "= A $a$.\n#f(x: $b$, [c $d$]) // $e$\n`$f$`";
        let expected = "= A #say(\"a\")[$a$];.\n#f(x: say(\"b\")[$b$], [c #say(\"d\")[$d$];]) // $e$\n`$f$`";
        assert_eq!(accessible(source, &words).as_deref(), Ok(expected));
        assert_eq!(
            accessible("$aleph$", &words),
            Err("no words for letter.aleph".to_owned())
        );
    }
}
