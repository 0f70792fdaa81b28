//! Tables of bodies in random scenes.

use lemnis_models::kernel::symbol::Symbol;
use toml::Value;

use crate::scene::{Draw, Node};

/// A table of a list.
pub fn row(draw: &mut Draw, quantities: &[(&'static Symbol, f64)]) -> Value {
    let each = quantities
        .iter()
        .map(|(symbol, value)| (symbol.id.to_owned(), draw.written(symbol, *value).0.into()));
    Value::Table(each.collect())
}

/// So many tables of a list.
pub fn list(n: &mut Node, name: &str, count: usize, of: &mut dyn FnMut(&mut Draw, usize) -> Value) {
    let rows: Vec<Value> = (0..count).map(|i| of(n.draw, i)).collect();
    n.put(name, rows);
}
