//! Typst's markup and mathematics as text of a web page or a terminal: pieces with letters below and above the line.

use codex::{Def, ModifierSet, SYM};
use serde::Serialize;
use typst_syntax::{SyntaxKind, SyntaxNode, parse, parse_math};

/// Where a piece of text stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Style {
    Plain,
    /// A letter that stands for a quantity.
    Italic,
    Sub,
    Sup,
}

/// Pieces of text, none beside one of the same style.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Script(Vec<(String, Style)>);

impl Script {
    /// Of a sentence of the words, in which names such as `#quantity` stand for these.
    #[must_use]
    pub fn of_markup(text: &str, named: &[(&str, Script)]) -> Script {
        let mut script = Script::default();
        script.markup(&parse(text), named);
        script
    }

    /// Of Typst's mathematics.
    #[must_use]
    pub fn of_math(text: &str) -> Script {
        let mut script = Script::default();
        script.math(&parse_math(text), Style::Plain);
        script
    }

    /// Without styles.
    #[must_use]
    pub fn plain(&self) -> String {
        self.0.iter().map(|(text, _)| text.as_str()).collect()
    }

    /// Goes on with another one.
    pub fn append(&mut self, other: &Script) {
        other.0.iter().for_each(|(text, style)| self.push(text, *style));
    }

    fn push(&mut self, text: &str, style: Style) {
        match self.0.last_mut() {
            Some((last, known)) if *known == style => last.push_str(text),
            _ if text.is_empty() => {}
            _ => self.0.push((text.to_owned(), style)),
        }
    }

    fn markup(&mut self, node: &SyntaxNode, named: &[(&str, Script)]) {
        let text = node.full_text();
        match node.kind() {
            SyntaxKind::Equation => node.children().for_each(|child| self.math(child, Style::Plain)),
            SyntaxKind::Space | SyntaxKind::Parbreak => self.push(" ", Style::Plain),
            SyntaxKind::Escape => {
                let code = text.strip_prefix("\\u{").and_then(|code| code.strip_suffix('}'));
                let char = code.and_then(|code| char::from_u32(u32::from_str_radix(code, 16).ok()?));
                self.push(&char.map_or_else(|| text[1..].to_owned(), String::from), Style::Plain);
            }
            SyntaxKind::Shorthand if text == "~" => self.push("\u{a0}", Style::Plain),
            SyntaxKind::Shorthand if text == "--" => self.push("–", Style::Plain),
            _ if node.children().len() > 0 => node.children().for_each(|child| self.markup(child, named)),
            SyntaxKind::Star | SyntaxKind::Underscore | SyntaxKind::Hash => {}
            SyntaxKind::Ident => match named.iter().find(|(name, _)| *name == text) {
                Some((_, own)) => self.append(own),
                None => self.push(&text, Style::Plain),
            },
            _ => self.push(&text, Style::Plain),
        }
    }

    /// `level` is that of an index or an exponent, plain on the line.
    fn math(&mut self, node: &SyntaxNode, level: Style) {
        let text = node.full_text();
        let word = |word: &str| match level {
            Style::Plain if word.chars().count() == 1 && word.chars().all(char::is_alphabetic) => Style::Italic,
            level => level,
        };
        match node.kind() {
            // Relations have room around them.
            SyntaxKind::MathText | SyntaxKind::MathShorthand
                if ["=", "<=", ">=", "<", ">"].contains(&text.as_str()) =>
            {
                let sign = text.as_str().replace("<=", "≤").replace(">=", "≥");
                self.push(&format!(" {sign} "), level);
            }
            SyntaxKind::Dollar | SyntaxKind::Space | SyntaxKind::Linebreak | SyntaxKind::MathAlignPoint => {}
            SyntaxKind::Str => self.push(text.trim_matches('"'), level),
            SyntaxKind::MathPrimes => self.push(&"′".repeat(text.len()), level),
            SyntaxKind::MathIdent | SyntaxKind::MathFieldAccess => {
                let name = symbol(&text);
                self.push(&name, word(&name));
            }
            SyntaxKind::MathAttach => {
                let mut part = level;
                for child in node.children() {
                    match child.kind() {
                        SyntaxKind::Underscore => part = Style::Sub,
                        SyntaxKind::Hat => part = Style::Sup,
                        _ if part != level => self.index(child, part),
                        _ => self.math(child, part),
                    }
                }
            }
            SyntaxKind::FuncCall | SyntaxKind::MathCall => self.call(node, level),
            _ if node.children().len() > 0 => node.children().for_each(|child| self.math(child, level)),
            _ => self.push(&text.as_str().replace('-', "−"), word(&text)),
        }
    }

    /// An index or an exponent, without the parentheses that only hold it together.
    fn index(&mut self, node: &SyntaxNode, level: Style) {
        let inner = node.children().len().saturating_sub(2);
        match node.full_text().starts_with('(') {
            true => node
                .children()
                .skip(1)
                .take(inner)
                .for_each(|child| self.math(child, level)),
            false => self.math(node, level),
        }
    }

    fn call(&mut self, node: &SyntaxNode, level: Style) {
        let name = node.children().next().map(SyntaxNode::full_text).unwrap_or_default();
        let mut argument = Script::default();
        let arguments = node.children().filter(|child| child.kind() == SyntaxKind::MathArgs);
        for child in arguments.flat_map(SyntaxNode::children) {
            if !matches!(child.kind(), SyntaxKind::LeftParen | SyntaxKind::RightParen) {
                argument.math(child, level);
            }
        }
        let (before, after) = match name.as_str() {
            "dot" => ("", "\u{307}"),
            "dot.double" => ("", "\u{308}"),
            "overline" => ("", "\u{305}"),
            "abs" => ("|", "|"),
            "sqrt" => ("√(", ")"),
            "upright" => ("", ""),
            _ => {
                self.push(&name, level);
                ("(", ")")
            }
        };
        // A mark belongs to the letter before it.
        let style = argument.0.last().map_or(level, |(_, style)| *style);
        self.push(before, level);
        self.append(&argument);
        self.push(after, if before.is_empty() { style } else { level });
    }
}

/// Plain text.
impl From<&str> for Script {
    fn from(text: &str) -> Script {
        Script(vec![(text.to_owned(), Style::Plain)])
    }
}

/// The characters that a name stands for in Typst's mathematics; the name itself where it is none.
fn symbol(name: &str) -> String {
    let spaces = [("thin", "\u{2009}"), ("med", " "), ("quad", " "), ("dif", "d")];
    if let Some((_, space)) = spaces.iter().find(|(known, _)| *known == name) {
        return (*space).to_owned();
    }
    let (first, variant) = name.split_once('.').unwrap_or((name, ""));
    let Some(Def::Symbol(known)) = SYM.get(first).map(|found| found.def) else {
        return name.to_owned();
    };
    known
        .get(ModifierSet::from_raw_dotted(variant))
        .map_or_else(|| name.to_owned(), |(text, _)| text.to_owned())
}

#[cfg(test)]
mod tests {
    use lemnis_models::registry::vocabularies;

    use super::*;

    fn marked(script: &Script) -> String {
        let mark = |(text, style): &(String, Style)| match style {
            Style::Plain => text.clone(),
            Style::Italic => format!("/{text}/"),
            Style::Sub => format!("_{text}_"),
            Style::Sup => format!("^{text}^"),
        };
        script.0.iter().map(mark).collect()
    }

    #[test]
    fn mathematics_has_letters_below_and_above() {
        for (source, text) in [
            ("theta_1", "/θ/_1_"),
            ("F_(O 1 x)", "/F/_O1x_"),
            ("M_\"ur\"^0", "/M/_ur_^0^"),
            ("dot(omega)_(0 \"sl\")", "/ω\u{307}/_0sl_"),
            ("abs(Delta M)_max", "|/ΔM/|_max_"),
            ("Y'_A", "/Y/′_A_"),
            ("E_(+)", "/E/_+_"),
            ("T_(d, arrow.l)", "/T/_d,←_"),
            ("Q thin Delta Y", "/Q/\u{2009}/ΔY/"),
            ("-29", "−29"),
        ] {
            assert_eq!(marked(&Script::of_math(source)), text, "{source}");
        }
    }

    #[test]
    fn sentences_have_their_mathematics_and_escapes() {
        let sentence = "The distance of $T$ and $O_3$ \\; eq\\u{2e}~11, 10--20 *bold* #quantity";
        let text = "The distance of /T/ and /O/_3_ ; eq.\u{a0}11, 10–20 bold /R/ = 3";
        let quantity = Script::of_math("R = 3");
        assert_eq!(marked(&Script::of_markup(sentence, &[("quantity", quantity)])), text);
    }

    /// No symbol of any mechanism shows Typst's syntax.
    #[test]
    fn every_symbol_is_text() {
        for (_, vocabulary) in vocabularies() {
            for symbol in vocabulary.own.iter().chain(vocabulary.shared).copied().flatten() {
                let text = Script::of_math(symbol.print).plain();
                assert!(
                    !text.is_empty() && !text.contains(['"', '_', '^', '\\', '{']),
                    "{}: {text}",
                    symbol.print
                );
                for command in ["thin", "dot", "abs", "overline", "arrow", "Delta", "theta", "omega"] {
                    assert!(!text.contains(command), "{}: {text}", symbol.print);
                }
            }
        }
    }
}
