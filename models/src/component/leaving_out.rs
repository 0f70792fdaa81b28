//! What a sheet does not tell.

use crate::component::sheet::{Sheet, Table};
use crate::kernel::symbol::Symbol;

impl Sheet {
    /// Leaves out what weighs nothing anywhere, where loads or weights are zero: a book has no pages of zeros.
    pub fn drop_nothing(&mut self) {
        let something = |symbol: &Symbol, value: f64| value != 0.0 || symbol.unit.dimension.kg == 0;
        self.governing.retain(|found| something(found.symbol, found.value));
        self.summary.retain(|found| something(found.symbol, found.value));
        self.forces
            .retain(|ends| ends.iter().any(|end| something(end.symbol, end.value)));
        self.range
            .retain(|symbol, values| values.iter().any(|value| something(symbol, *value)));
        self.curves.retain(|curve| {
            let mut points = curve.pieces.iter().flatten();
            points.any(|point| something(curve.y, point[1]))
        });
    }

    /// Leaves out results of what only stands in for parts that the machine does not have.
    pub fn drop_results(&mut self, of: &[&Symbol]) {
        let told = |symbol: &Symbol| !of.contains(&symbol);
        self.governing.retain(|found| told(found.symbol));
        self.summary.retain(|found| told(found.symbol));
        self.unjudged.retain(|symbol| told(symbol));
        self.range.retain(|symbol, _| told(symbol));
        self.curves.retain(|curve| told(curve.y));
        let results = &mut self.sensitivity.results;
        for row in &mut self.sensitivity.rows {
            let mut of_result = results.iter();
            row.by
                .retain(|_| told(of_result.next().expect("one for each result").0));
        }
        results.retain(|(symbol, _)| told(symbol));
    }
}

impl Table {
    /// Keeps the columns of which this is true, told its values.
    fn retain(&mut self, keep: impl Fn(&Symbol, &[f64]) -> bool) {
        let Table { columns, rows } = self;
        let kept: Vec<bool> = (0..columns.len())
            .map(|i| keep(columns[i], &rows.iter().map(|row| row[i]).collect::<Vec<_>>()))
            .collect();
        let mut kept_column = kept.iter();
        columns.retain(|_| *kept_column.next().expect("one for each"));
        for row in rows {
            let mut kept_cell = kept.iter();
            row.retain(|_| *kept_cell.next().expect("one for each"));
        }
    }
}
