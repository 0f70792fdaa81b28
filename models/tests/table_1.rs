//! The published table, value by value, from the default scene.

use lemnis_models::component::model::Model;
use lemnis_models::luffing::double_link::scene::Luffing;
use lemnis_models::scene::{DEFAULT, Scene};

/// All 366 computed values of [Li2022, Table 1] to the printed digit: within
/// 0.6 of the last printed unit.
#[test]
fn every_value_of_table_1() {
    let scene = Scene::parse(DEFAULT).expect("the default scene is valid");
    let published = scene
        .mechanism
        .of::<Luffing>()
        .expect("a luffing mechanism")
        .published
        .as_ref()
        .expect("with the table");
    let mut model = scene.model().expect("and a mechanism");
    let index = |model: &Model, id: &str| {
        model
            .variables()
            .iter()
            .position(|variable| variable.symbol.id == id)
            .unwrap_or_else(|| panic!("{id}"))
    };
    let (mut compared, mut worst) = (0, 0.0_f64);
    for row in &published.rows {
        for (symbol, printed) in published.columns.iter().zip(row) {
            let index = index(&model, symbol.id);
            let number: f64 = printed.parse().expect("a number");
            if symbol.id == "theta_1" {
                model.set(index, number.to_radians()).expect("an angle");
                continue;
            }
            let decimals = printed.split_once('.').map_or(0, |(_, digits)| digits.len());
            let unit = 10_f64.powi(-i32::try_from(decimals).expect("few"));
            let deviation = (symbol.shown(model.get(index).expect("closes")) - number).abs() / unit;
            assert!(deviation <= 0.6, "{} at {}: {deviation} units", symbol.id, row[0]);
            worst = worst.max(deviation);
            compared += 1;
        }
    }
    assert_eq!(compared, 366);
    println!("366 values, largest deviation {worst:.3} of the last printed unit");
}

/// The scene's copy of the table is the oracle's.
#[test]
fn the_scene_holds_the_oracle() {
    let oracle = include_str!("../../tests/oracles/lemniscate_table1.csv");
    let scene = Scene::parse(DEFAULT).expect("valid");
    let rows = scene
        .mechanism
        .of::<Luffing>()
        .expect("a luffing mechanism")
        .published
        .as_ref()
        .expect("with the table")
        .rows
        .clone();
    let oracle: Vec<Vec<String>> = oracle
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect();
    assert_eq!(rows, oracle);
}
