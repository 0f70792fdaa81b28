//! How results spread over the designs of a study, and what moves them.

use lemnis_models::kernel::symbol::Symbol;

use crate::language::Language;
use crate::print::picture::{Picture, Point};
use crate::print::plot::{BAR, CHART, Field, LEFT, axis_name, name_axes};

/// Columns of a histogram.
const COLUMNS: usize = 24;

/// Room to the right of its field, in mm, for half of a number below its end: those of a narrow spread have many digits.
const BESIDE: f64 = 5.0;

/// Shares of values (SI, in order) between as many equal steps as there are columns, with lines at some of them. None where
/// all are the same.
#[must_use]
pub fn histogram(language: &Language, symbol: &Symbol, sorted: &[f64], marks: &[f64]) -> Option<Picture> {
    let finite: Vec<f64> = sorted.iter().copied().filter(|value| value.is_finite()).collect();
    let [least, greatest] = [*finite.first()?, *finite.last()?].map(|value| symbol.shown(value));
    if greatest <= least {
        return None;
    }
    let width = (greatest - least) / COLUMNS as f64;
    let mut counts = [0_usize; COLUMNS];
    for value in &finite {
        let column = ((symbol.shown(*value) - least) / width) as usize;
        counts[column.min(COLUMNS - 1)] += 1;
    }
    let share = |count: usize| 100.0 * count as f64 / sorted.len() as f64;
    let most = counts.iter().copied().max().map_or(0.0, share);
    let mut field = Field::around([[least, 0.0], [greatest, most]].into_iter(), false);
    field.right = CHART[0] - BESIDE;
    let mut picture = field.picture(language);
    for (column, &count) in counts.iter().enumerate() {
        let [from, to] = [column, column + 1].map(|edge| least + edge as f64 * width);
        let corners = [[from, 0.0], [from, share(count)], [to, share(count)], [to, 0.0]];
        picture.shape("less", &corners.map(|corner| field.place(corner)), true);
    }
    for mark in marks.iter().filter(|mark| mark.is_finite()) {
        let ends = [0.0, most].map(|height| field.place([symbol.shown(*mark), height]));
        picture.line("path", &ends);
    }
    name_axes(&mut picture, [&axis_name(symbol), "%"]);
    Some(picture)
}

/// Most quantities of a tornado.
const MOST: usize = 10;

/// What moves a result: of each quantity its name and two effects of one size, the first in a dark bar, the second in a light
/// one below; to the right where the result grows, the greatest first. None where nothing has an effect.
#[must_use]
pub fn tornado(mut rows: Vec<(String, [Option<f64>; 2])>) -> Option<Picture> {
    let size = |effects: &[Option<f64>; 2]| {
        effects
            .iter()
            .flatten()
            .fold(0.0_f64, |most, effect| most.max(effect.abs()))
    };
    rows.sort_by(|a, b| size(&b.1).total_cmp(&size(&a.1)));
    rows.truncate(MOST);
    let longest = rows.first().map(|row| size(&row.1)).filter(|longest| *longest > 0.0)?;
    let mut picture = Picture::new([CHART[0], BAR * rows.len() as f64 + 2.0], 0);
    let middle = f64::midpoint(LEFT, CHART[0]);
    let room = CHART[0] - middle - 1.0;
    for (i, (name, effects)) in rows.iter().enumerate() {
        let top = 1.0 + BAR * i as f64;
        let half = (BAR - 1.2) / 2.0;
        for (effect, style, top) in [(effects[0], "more", top), (effects[1], "less", top + half)] {
            let Some(effect) = effect else { continue };
            let end = middle + room * effect / longest;
            let corners: [Point; 4] = [[middle, top], [end, top], [end, top + half], [middle, top + half]];
            picture.shape(style, &corners, true);
        }
        picture.text([LEFT - 1.5, top + half], "right", name.clone());
    }
    picture.line("thin", &[[middle, 0.0], [middle, picture.height]]);
    Some(picture)
}
