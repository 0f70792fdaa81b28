//! The notation page is generated from the symbol tables; a stale page fails.
//! `LEMNIS_WRITE=1 cargo test -p lemnis-models --test notation` writes it.

use std::fmt::Write as _;

use lemnis_models::afloat;
use lemnis_models::balance;
use lemnis_models::bridge;
use lemnis_models::drive;
use lemnis_models::hopper;
use lemnis_models::kernel::gravity;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::luffing;
use lemnis_models::luffing::double_link;
use lemnis_models::parts::{
    air, ground, hanging, hydraulics, motor, shaping, side_wind, slip, slope, starts, teeth, turntable,
    turntable_control,
};
use lemnis_models::registry;
use lemnis_models::slewing;
use lemnis_models::steering;
use lemnis_models::supports::{column, drive as drive_of_supports, mobile, portal, ring, upper};
use lemnis_models::sway::pendulum;
use lemnis_models::unloader;

/// Every mechanism with its table.
const TABLES: [(&str, &[&Symbol]); 43] = [
    ("The double-link luffing mechanism", double_link::symbols::ALL),
    (
        "The double-link luffing mechanism in motion",
        double_link::moving::symbols::ALL,
    ),
    ("Any luffing mechanism in motion", luffing::moving::symbols::ALL),
    ("What a luffing drive must overcome", luffing::resistances::symbols::ALL),
    ("A motor with its brake, in cases", motor::ALL),
    ("Starts of a motor", starts::ALL),
    ("Teeth", teeth::ALL),
    ("Strength of a luffing drive", luffing::strength::symbols::ALL),
    ("The boom on a luffing rope", luffing::rope::symbols::ALL),
    ("A hoist rope led over sheaves", luffing::led::symbols::ALL),
    ("The boom on guide and link", luffing::ellipsograph::symbols::ALL),
    ("The boom with a curved trunk", luffing::curved_trunk::symbols::ALL),
    ("The joint by which a crane slews", turntable::ALL),
    ("The controller of that joint", turntable_control::ALL),
    ("The controller of luffing", luffing::moving::control::luffing::ALL),
    (
        "The controller of a hoist's motor",
        luffing::moving::control::hoist::ALL,
    ),
    ("A command shaped against a swing", shaping::ALL),
    ("A load on its rope, from a head that joints move", hanging::ALL),
    ("Air around a load on its rope", air::ALL),
    ("Wind on all that slews", side_wind::ALL),
    ("A slope under all that slews", slope::ALL),
    ("Ground below a load on its rope", ground::ALL),
    ("Slewing by itself", slewing::symbols::ALL),
    ("A coupling that slips in the slewing drive", slip::ALL),
    (
        "A mobile crane on its supports, seen from above: x forward, y to the left, angles counter-clockwise",
        mobile::symbols::ALL,
    ),
    (
        "A crane on a portal, seen from above: x along the rails, y to the left, angles counter-clockwise",
        portal::symbols::ALL,
    ),
    (
        "What slews on a support: moments in the direction of the side that they load, angles counter-clockwise from above",
        upper::symbols::ALL,
    ),
    (
        "What a slewing drive turns, and its results",
        drive_of_supports::symbols::ALL,
    ),
    ("A slewing ring", ring::symbols::ALL),
    ("A column in three bearings", column::symbols::ALL),
    ("The hopper of a crane", hopper::symbols::ALL),
    (
        "A grab unloader: speeds and forces of the trolley to the sea side, of the grab upward",
        unloader::symbols::ALL,
    ),
    (
        "The trolley of a container bridge: places, speeds and forces to the sea side, hoisting upward",
        bridge::symbols::ALL,
    ),
    (
        "Spreader and load of a container bridge as two bodies in motion: to the sea side and upward",
        bridge::bodies::symbols::ALL,
    ),
    ("A load that sways under a trolley", pendulum::ALL),
    ("A crane on a hull that floats", afloat::symbols::ALL),
    ("A luffing mechanism that something carries", luffing::aboard::ALL),
    ("Gravity", gravity::ALL),
    ("The balance of the boom system", balance::symbols::ALL),
    ("Screw, pinion, crank or rope of a drive", drive::symbols::ALL),
    ("A cylinder with oil and valve", hydraulics::symbols::ALL),
    (
        "Steering, seen from above: x forward, y to the left, angles counter-clockwise from straight ahead",
        steering::symbols::ALL,
    ),
    ("The steered groups in motion", steering::moving::symbols::ALL),
];

fn page() -> String {
    let mut page = String::from(
        "# Notation\n\nGenerated from the symbol tables in `models/`. x forward (towards the load), y up, angles\n\
         counter-clockwise from the horizontal in (-90°, 270°]; SI inside, the display unit where people read.\n",
    );
    for (title, table) in TABLES {
        let _ = write!(
            page,
            "\n## {title}\n\n| name | SI | display | meaning and sign | source |\n|---|---|---|---|---|\n"
        );
        for symbol in table {
            let (unit, display) = (symbol.unit.name, symbol.display.name);
            let _ = writeln!(
                page,
                "| `{}` | {unit} | {display} | {} | {} |",
                symbol.id,
                symbol.description(),
                symbol.source
            );
        }
    }
    page
}

#[test]
fn the_notation_page_is_up_to_date() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/notation.md");
    if std::env::var_os("LEMNIS_WRITE").is_some() {
        std::fs::write(path, page()).expect("writable");
    }
    let written = std::fs::read_to_string(path)
        .expect("docs/notation.md")
        .replace("\r\n", "\n");
    assert!(
        written == page(),
        "docs/notation.md is stale: LEMNIS_WRITE=1 cargo test -p lemnis-models --test notation"
    );
}

#[test]
fn every_symbol_of_a_mechanism_is_on_the_page() {
    let listed = |symbol: &Symbol| TABLES.iter().any(|(_, table)| table.contains(&symbol));
    for (mechanism, vocabulary) in registry::vocabularies() {
        for symbol in vocabulary.own.iter().chain(vocabulary.shared).copied().flatten() {
            assert!(listed(symbol), "{mechanism}: {}", symbol.id);
        }
    }
}

#[test]
fn names_are_unique_and_complete() {
    for (_, table) in TABLES {
        for (i, symbol) in table.iter().enumerate() {
            assert!(
                table[..i].iter().all(|other| other.id != symbol.id),
                "{} twice",
                symbol.id
            );
            assert!(!symbol.text.is_empty() && symbol.text.ends_with('.'), "{}", symbol.id);
            assert!(!symbol.source.is_empty(), "{}", symbol.id);
            assert_eq!(symbol.unit.dimension, symbol.display.dimension, "{}", symbol.id);
            assert_eq!(symbol.unit.factor, 1.0, "{} is in SI", symbol.id);
        }
    }
}
