//! Straight lines through points with rising x.

use crate::kernel::calc::{Among, Calc};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;

/// A point by its number, under the names of its x and its y.
pub fn named<C: Calc>(names: [&'static Symbol; 2], number: u16, point: [f64; 2]) -> [C; 2] {
    [0, 1].map(|i| {
        let value = C::known(names[i], point[i]);
        value.among(Among::Of(number), value)
    })
}

/// y at an x on the straight line between two points, which have numbers after `before` others; `None` beyond them.
#[must_use]
pub fn straight<C: Calc>(points: &[[f64; 2]], x: C, before: u16, names: [&'static Symbol; 2]) -> Option<C> {
    (before + 1..).zip(points.windows(2)).find_map(|(number, pair)| {
        let within = x.value() >= pair[0][0] && x.value() <= pair[1][0] && pair[1][0] > pair[0][0];
        within.then(|| {
            let [[x_1, y_1], [x_2, y_2]] = [0, 1].map(|i| named::<C>(names, number + i, pair[usize::from(i)]));
            y_1 + (y_2 - y_1) * (x - x_1) / (x_2 - x_1)
        })
    })
}

/// The points of a list of tables, at least two with rising x; mistakes go to `found`, in which the curve and what x is have
/// these names.
pub fn rising(
    tables: &[Values],
    [x, y]: [&'static Symbol; 2],
    [curve, along]: [&str; 2],
    found: &mut Vec<Diagnostic>,
) -> Option<Vec<[f64; 2]>> {
    let mut points: Vec<[f64; 2]> = Vec::new();
    for table in tables {
        let point = [table.of(x)?, table.of(y)?];
        if let Some(last) = points.last().filter(|last| point[0] <= last[0]) {
            let what = format!("{} = {} after {}", x.id, x.written(point[0]), x.written(last[0]));
            let help = format!("give the points with rising {along}");
            found.push(table.refuse(x.id, what, format!("not on {curve}"), help));
        }
        points.push(point);
    }
    if let [one] = tables {
        let what = format!("{curve} with one point");
        found.push(one.refuse(x.id, what, format!("not on {curve}"), "give two points at least"));
    }
    Some(points)
}
