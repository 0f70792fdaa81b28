//! Widths of Typst's mathematics, estimated in digits of the book's font: to measure them would take a pass over the
//! document. A bit too large rather than too small (`report/tests/figures.rs` measures them).

/// Letters and digits of a name, those below the line at two thirds.
pub(super) fn name(print: &str) -> f64 {
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

/// A number with or without unit.
pub(super) fn number(text: &str) -> f64 {
    let visible = text
        .replace(" thin", "")
        .replace(['"', '^', '(', ')'], "")
        .replace(" times ", "--");
    visible.chars().count() as f64
}
