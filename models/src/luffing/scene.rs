//! What scenes say of all luffing mechanisms alike.

use crate::component::table::{TOL, TOLERANCE};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::{Key, Sign, Values};

/// Where the quantities of a table come from that do not say it themselves.
pub const SOURCE: Key = Key::text(
    "source",
    "Where the quantities of this table come from: a drawing, a publication, an assumption.",
);

/// Keys of the level `table`.
pub static TABLE: &[Key] = &[Key::quantity(&TOL, Sign::Tolerance)];

/// Tolerance of the level `table`; `None` at other levels. Mistakes go to `found`.
pub fn interpolation(v: &Values, found: &mut Vec<Diagnostic>) -> Option<f64> {
    let given = v.table("table");
    if v.text("fidelity") != Some("table") {
        if let Some(table) = given.filter(|_| v.text("fidelity") != Some("auto")) {
            found.push(
                Diagnostic::new(table.span.clone(), "an interpolation at another level", "not used")
                    .help("set fidelity = \"table\", or remove this table"),
            );
        }
        return None;
    }
    Some(given.and_then(|table| table.number(TOL.id)).unwrap_or(TOLERANCE))
}
