//! What a sheet does not tell.

use crate::component::sheet::{Sheet, Table};
use crate::kernel::record::Trace;
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

    /// Tells these results alone, where others are of what only stands in for parts that the machine does not have.
    pub fn tell_results(&mut self, told: &dyn Fn(&Symbol) -> bool) {
        self.governing.retain(|found| told(found.symbol));
        self.summary.retain(|found| told(found.symbol));
        self.forces.retain(|ends| told(ends[0].symbol));
        self.unjudged.retain(|symbol| told(symbol));
        self.range.retain(|symbol, _| told(symbol));
        self.curves.retain(|curve| told(curve.x) && told(curve.y));
        let results = &mut self.sensitivity.results;
        for row in &mut self.sensitivity.rows {
            let mut of_result = results.iter();
            row.by
                .retain(|_| told(of_result.next().expect("one for each result").0));
        }
        results.retain(|(symbol, _)| told(symbol));
    }

    /// Of all formulas those that give or lead to one of these, and of the given quantities those that are of use then.
    pub fn tell_formulas(&mut self, told: &dyn Fn(&Symbol) -> bool) {
        let mut needed: Vec<&'static Symbol> = Vec::new();
        let positions = self.positions.iter_mut().map(|position| &mut position.sections);
        for sections in positions.chain([&mut self.constants]) {
            for section in sections.iter_mut().rev() {
                retain(&mut section.trace, told, &mut needed);
            }
            sections.retain(|section| !section.trace.steps.is_empty());
        }
        self.inputs
            .retain(|input| told(input.symbol) || needed.contains(&input.symbol));
        let given = |symbol| self.inputs.iter().any(|input| input.symbol == symbol);
        self.sensitivity.rows.retain(|row| given(row.symbol));
    }
}

/// Keeps the steps that are told or needed, from the last one to the first, and adds what each of them needs.
fn retain(trace: &mut Trace, told: &dyn Fn(&Symbol) -> bool, needed: &mut Vec<&'static Symbol>) {
    let mut steps = std::mem::take(&mut trace.steps);
    steps.reverse();
    steps.retain(|step| {
        let kept = told(step.symbol) || needed.contains(&step.symbol);
        if kept {
            trace.names(step.formula, needed);
        }
        kept
    });
    steps.reverse();
    trace.steps = steps;
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
