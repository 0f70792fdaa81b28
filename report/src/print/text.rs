//! Text that Typst prints and never runs.

use std::fmt::Write;

/// Text that Typst prints as it is, in markup and between quotes: everything that could be syntax becomes
/// `\u{hex}`. Between letters or digits a point, a comma, a colon or a stroke is none; nor is a point or a comma after
/// a letter. Every escape is a node of its own for Typst, so numbers are left whole.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(2 * text.len());
    let (mut before, mut rest) = (' ', text.chars());
    while let Some(c) = rest.next() {
        let after = rest.clone().next().unwrap_or(' ');
        let plain = match c {
            ' ' => true,
            '.' | ',' if before.is_alphabetic() => after != '.',
            '.' | ',' | ':' | '/' => before.is_alphanumeric() && after.is_alphanumeric(),
            _ if c.is_ascii() => c.is_alphanumeric(),
            _ => !(c.is_control() || c.is_whitespace()),
        };
        match plain {
            true => escaped.push(c),
            false => write!(escaped, "\\u{{{:x}}}", u32::from(c)).expect("strings can be written to"),
        }
        before = c;
    }
    escaped
}

/// Text whose words a line can always hold: one that is too long may be broken after every so many letters. Chinese is
/// broken anywhere already. A measure such as "10 t × 32 m" stays on one line.
pub(crate) fn breakable(text: &str) -> String {
    const LONGEST: usize = 22;
    const PIECE: usize = 4;
    let chinese = |c: char| c >= '\u{2e80}';
    let text = measures(text);
    let mut broken = String::with_capacity(text.len());
    for word in text.split_inclusive(|c: char| c.is_whitespace() || chinese(c)) {
        // No word has more letters than bytes.
        if word.len() <= LONGEST || word.chars().count() <= LONGEST {
            broken.push_str(word);
            continue;
        }
        for (i, c) in word.chars().enumerate() {
            if i > 0 && i % PIECE == 0 {
                broken.push('\u{200b}');
            }
            broken.push(c);
        }
    }
    broken
}

/// Text with no-break spaces in products of measures: numbers and units on both sides of a cross.
fn measures(text: &str) -> String {
    if !text.contains('×') {
        return text.to_owned();
    }
    let words: Vec<&str> = text.split(' ').collect();
    let mut joined = String::with_capacity(text.len());
    for (i, word) in words.iter().enumerate() {
        let is_cross = |at: Option<usize>| at.and_then(|at| words.get(at)) == Some(&"×");
        let around = [i.checked_sub(2), i.checked_sub(1), Some(i), Some(i + 1)];
        if i > 0 {
            joined.push(if around.into_iter().any(is_cross) {
                '\u{a0}'
            } else {
                ' '
            });
        }
        joined.push_str(word);
    }
    joined
}

/// A string literal of Typst, with no more escapes than it needs.
pub(crate) fn string(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use lemnis_typeset::{Embedded, Format, Typesetter};

    use super::*;

    #[test]
    fn hostile_text_is_only_text() {
        let hostile = "#read(\"/etc/passwd\") $x$ *b* @ref /* // \\ ] } \" ~ <l>\n= h\u{2028}`";
        let escaped = escape(hostile);
        let syntax = |c: char| c.is_ascii_punctuation() && !matches!(c, '\\' | '{' | '}' | '/');
        assert!(!escaped.contains(syntax) && !escaped.contains('\n'), "{escaped}");
        assert!(!escaped.contains("//") && !escaped.contains("/\\"), "{escaped}");
        for source in [
            format!("= {escaped}"),
            format!("#\"{escaped}\""),
            format!("#let t = [{escaped}]\n#t"),
        ] {
            let source = format!("#set document(title: \"T\")\n{source}");
            let made = Embedded.typeset(&source, &[], Format::Pdf, None).unwrap();
            assert!(made.warnings.is_empty());
        }
    }

    #[test]
    fn a_product_of_measures_stays_on_one_line() {
        let joined = "Кран\u{20}10\u{a0}t\u{a0}×\u{a0}32\u{a0}m: нов";
        assert_eq!(breakable("Кран 10 t × 32 m: нов"), joined);
        assert_eq!(breakable("a 600 t crane"), "a 600 t crane");
    }

    /// Numbers and units stay whole; what Typst would make a list, an ellipsis, a comment or a link of does not.
    #[test]
    fn points_and_strokes_within_words_are_no_syntax() {
        assert_eq!(escape("3.5 m/s, 0,25; Fig. 3"), "3.5 m/s, 0,25\\u{3b} Fig. 3");
        assert_eq!(escape("1. a..."), "1\\u{2e} a\\u{2e}\\u{2e}\\u{2e}");
        assert_eq!(escape("http://a /*"), "http\\u{3a}\\u{2f}\\u{2f}a \\u{2f}\\u{2a}");
    }
}
