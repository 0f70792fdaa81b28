//! Numbers as programs read them: with all their digits, zero without a sign.

use serde_json::{Number, Value};

/// For JSON, which has no infinite numbers: they are null.
#[must_use]
pub fn json(value: f64) -> Value {
    Number::from_f64(value + 0.0).map_or(Value::Null, Value::Number)
}

/// For CSV: as it was before its unit was converted to SI and back, 60 and not 59.99999999999999.
#[must_use]
pub fn csv(value: f64) -> String {
    let rounded = format!("{value:.14e}").parse().unwrap_or(value) + 0.0;
    format!("{rounded:?}").trim_end_matches(".0").to_owned()
}

/// Rows as CSV.
///
/// # Panics
/// Never: memory takes every record.
#[must_use]
pub fn records(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(row).expect("memory takes every record");
    }
    String::from_utf8(writer.into_inner().expect("memory takes every record")).expect("numbers and names are text")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_digits_and_zero_has_no_sign() {
        for (value, csv_text, json_text) in [
            (-0.0, "0", "0.0"),
            (59.999_999_999_999_99, "60", "59.99999999999999"),
            (-1.0 / 3.0, "-0.333333333333333", "-0.3333333333333333"),
            (1e300, "1e300", "1e+300"),
            (f64::NEG_INFINITY, "-inf", "null"),
            (f64::NAN, "NaN", "null"),
        ] {
            assert_eq!(csv(value), csv_text);
            assert_eq!(json(value).to_string(), json_text);
        }
    }
}
