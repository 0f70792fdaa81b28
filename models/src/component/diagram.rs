//! Tables, curves and charts, as plain data.

use crate::kernel::symbol::Symbol;

#[derive(Default)]
pub struct Table {
    pub columns: Vec<&'static Symbol>,
    pub rows: Vec<Vec<f64>>,
}

pub struct Curve {
    /// Id of the caption, worded in the templates; `li2022_fig_3` and the like.
    pub id: &'static str,
    pub x: &'static Symbol,
    pub y: &'static Symbol,
    /// Where a value is infinite the curve is broken: pieces of points.
    pub pieces: Vec<Vec<[f64; 2]>>,
    /// Numbers of the pieces, where each is that of another body; else empty.
    pub numbers: Vec<usize>,
}

/// Results over two quantities.
pub struct Chart {
    /// Id of its words.
    pub id: &'static str,
    /// A row for each pair of the two, the first and the second column, which are in order.
    pub points: Table,
    /// What the chart shows, of the columns.
    pub shown: &'static Symbol,
    /// What decides each row: id of its words and of its mark.
    pub marks: Vec<&'static str>,
    /// What is shown, over the second quantity, a piece for each of the first that has one; none where no cell has.
    pub curve: Option<Curve>,
}
