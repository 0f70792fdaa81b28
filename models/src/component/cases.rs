//! What is asked of a machine in cases that a scene names, as plain data.

use crate::component::sheet::{Curve, Section, Summary, Table};
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;

/// The chapter of the cases.
pub struct CasesSheet {
    pub names: Vec<Text>,
    /// What is given of each case.
    pub given: Table,
    /// What a standard gives and no text confirms: symbol, number of the case from 1, value, standard.
    pub unconfirmed: Vec<(&'static Symbol, Option<u16>, f64, &'static str)>,
    /// In which case, from 0, and where most is asked: there the formulas are worked out.
    pub governing: (usize, &'static Symbol, f64),
    pub sections: Vec<Section>,
    /// What sums of the formulas are made of there: id of the title, names of the rows, and the terms.
    pub terms: Vec<(&'static str, Vec<&'static str>, Table)>,
    /// Greatest by amount of each result, with its place: of one that is the same in all cases once.
    pub greatest: Vec<Vec<Summary>>,
    /// Over the working range, for each case.
    pub ranges: Vec<Table>,
    pub curves: Vec<Curve>,
}
