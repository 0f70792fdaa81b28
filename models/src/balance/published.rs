//! [Ports001, table 5.2.1], computed again from its own lengths.

use crate::component::sheet::{PublishedCell, PublishedRow};

/// As printed: boom angle in degrees; l_c, R_1, R_2, r_c in m; moments of boom,
/// counterweight and both about the lever's pivot in t·m.
pub static TABLE_5_2_1: [[&str; 8]; 8] = [
    ["50.5", "9", "7.025", "1.075", "2.85", "16.53", "22.8", "-6.27"],
    ["52.5", "8.6", "7.11", "1.57", "3.09", "22.8", "24.72", "-1.92"],
    ["55", "8.11", "7.14", "1.875", "3.18", "25.56", "25.42", "0.14"],
    ["60", "7.08", "7.135", "2.26", "3.15", "26.94", "25.2", "1.74"],
    ["65", "5.985", "6.93", "2.35", "2.88", "24.38", "23.06", "1.32"],
    ["70", "4.84", "6.7", "2.25", "2.41", "19.5", "19.3", "0.20"],
    ["75", "3.665", "6.51", "2.00", "1.78", "13.5", "14.25", "-0.75"],
    ["80.5", "2.335", "6.32", "1.54", "0.80", "6.81", "6.4", "0.41"],
];

/// Weights of boom and counterweight, in t.
const WEIGHTS: [f64; 2] = [12.0, 8.0];

/// Every row with its moments from its own lengths. A cell is a misprint where
/// they do not give it to the printed digit; a difference of two sound cells that
/// were rounded is none.
#[must_use]
pub fn table_5_2_1() -> Vec<PublishedRow> {
    let number = |text: &str| -> f64 { text.parse().expect("a number") };
    let row = |row: &[&'static str; 8]| {
        let [l_c, r_1, r_2, r_c] = [1, 2, 3, 4].map(|i| number(row[i]));
        let (boom, counterweight) = (WEIGHTS[0] * l_c * r_2 / r_1, WEIGHTS[1] * r_c);
        let mut sound = true;
        let cells = [boom, counterweight, boom - counterweight].into_iter().enumerate();
        let cells = cells.map(|(column, computed)| {
            let printed = row[5 + column];
            let decimals = printed.split('.').nth(1).map_or(0, str::len);
            let half = (0..decimals).fold(0.5, |half, _| half / 10.0);
            let carried = column == 2 && sound && (number(row[5]) - number(row[6]) - number(printed)).abs() < 1e-9;
            let misprint = (computed - number(printed)).abs() > half + 1e-9 && !carried;
            sound &= !misprint;
            PublishedCell {
                printed,
                computed,
                misprint,
            }
        });
        PublishedRow {
            moments: cells.collect(),
            given: row[..5].to_vec(),
        }
    };
    TABLE_5_2_1.iter().map(row).collect()
}
