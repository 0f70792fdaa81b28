//! What scenes say of all luffing mechanisms alike.

use crate::component::table::TOLERANCE;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::{self, Key, Kind, Sign, Values};
use crate::luffing::double_link::moving::symbols::TOL;

/// Which luffing mechanism it is.
pub const KIND: Key = Key {
    name: schema::KIND,
    kind: Kind::Choice(&["double_link", "rope"]),
    required: false,
    text: "Which luffing mechanism: \"double_link\" (boom, jib and rocker), or \"rope\" (a plain boom on a luffing rope).",
};

/// Where the quantities of a table come from that do not say it themselves.
pub const SOURCE: Key = Key::text(
    "source",
    "Where the quantities of this table come from: a drawing, a publication, an assumption.",
);

/// Keys of the level `table`.
pub static TABLE: &[Key] = &[Key::named(
    "tol",
    &TOL,
    Sign::Tolerance,
    "How far each result may be off the closed form, as a part of its range.",
)];

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
    Some(given.and_then(|table| table.number("tol")).unwrap_or(TOLERANCE))
}
