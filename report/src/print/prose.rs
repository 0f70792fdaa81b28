//! A person's own text: plain, with symbols set as mathematics.

use crate::print::text::{breakable, escape};

/// Greek letters as scenes write them.
const GREEK: [&str; 17] = [
    "alpha", "beta", "gamma", "delta", "Delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu",
    "sigma", "tau", "phi", "psi",
];

/// Text as Typst prints it, never code. A word such as `X_4` or `mu_min` is set as a symbol: as `print` knows it, or
/// else as a letter with its index.
pub(crate) fn prose(text: &str, print: impl Fn(&str) -> Option<&'static str>) -> String {
    let mut set = String::with_capacity(2 * text.len());
    let mut plain = 0;
    let mut start = 0;
    let inside = |c: char| c.is_ascii_alphanumeric() || c == '_';
    while let Some(at) = text[start..].find(inside).map(|at| start + at) {
        let end = text[at..].find(|c| !inside(c)).map_or(text.len(), |length| at + length);
        let apart = |c: Option<char>| c.is_none_or(|c| !(c.is_alphanumeric() && c < '\u{2e80}'));
        let alone = apart(text[..at].chars().next_back()) && apart(text[end..].chars().next());
        if let Some(symbol) = symbol(&text[at..end], &print).filter(|_| alone) {
            set.push_str(&escape(&breakable(&text[plain..at])));
            set.push_str(&format!("${symbol}$"));
            plain = end;
        }
        start = end;
    }
    set.push_str(&escape(&breakable(&text[plain..])));
    set
}

fn symbol(word: &str, print: impl Fn(&str) -> Option<&'static str>) -> Option<String> {
    let (letter, index) = word.split_once('_')?;
    if let Some(known) = print(word) {
        return Some(known.to_owned());
    }
    let is_index = index.len() <= 12 && index.split('_').all(|part| !part.is_empty());
    let is_letter = letter.len() == 1 && !letter.starts_with(|c: char| c.is_ascii_digit()) || GREEK.contains(&letter);
    let number = index.chars().all(|c| c.is_ascii_digit());
    (is_letter && is_index).then(|| match index.len() {
        1 => format!("{letter}_{index}"),
        _ if number => format!("{letter}_({index})"),
        _ => format!("{letter}_\"{}\"", index.replace('_', ",")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_are_set_and_all_else_is_plain() {
        let print = |id: &str| (id == "M_ur").then_some("M_\"ur\"^0");
        for (text, set) in [
            ("X_4, beta_0 and X_5", "$X_4$\\u{2c} $beta_0$ and $X_5$"),
            ("M_ur is known", "$M_\"ur\"^0$ is known"),
            ("由X_12求得", "由$X_(12)$求得"),
            ("d_o_min", "$d_\"o,min\"$"),
            (
                "portal_004 and __ and a_ and 3_x",
                "portal\\u{5f}004 and \\u{5f}\\u{5f} and a\\u{5f} and 3\\u{5f}x",
            ),
            ("жX_4", "жX\\u{5f}4"),
            (
                "#X_4$ *<l>@ \\",
                "\\u{23}$X_4$\\u{24} \\u{2a}\\u{3c}l\\u{3e}\\u{40} \\u{5c}",
            ),
        ] {
            assert_eq!(prose(text, print), set, "{text}");
        }
    }
}
