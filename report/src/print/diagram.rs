//! The work-precision diagram: in a book, and by itself.

use lemnis_trade::trade::{Row, Trade, relative};

use crate::language::Language;
use crate::print::picture::Picture;
use crate::print::plot::{Series, work_precision};

/// Cost of every setting (s of computing for each simulated s) over its error, by the axes' names in Typst's mathematics.
#[must_use]
pub fn diagram(language: &Language, names: [&str; 2], trade: &Trade, cost: impl Fn(&Row) -> f64) -> Picture {
    let levels = trade.references.iter().map(|reference| {
        let rows = trade.rows.iter();
        let rows = rows.filter(|row| row.setting.level == reference.level && !row.follows);
        let points = rows.map(|row| ([relative(row, &trade.asked), 1e6 * cost(row)], row.front));
        Series {
            label: reference.level.to_owned(),
            points: points.filter(|(p, _)| p[0].is_finite()).collect(),
        }
    });
    let levels: Vec<Series> = levels.filter(|level| !level.points.is_empty()).collect();
    let asks = trade.asked.iter().any(|asked| asked.allowed.is_some());
    work_precision(language, names, &levels, asks.then_some(1.0))
}
