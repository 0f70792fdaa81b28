//! How near a linkage can come to the lengths of [Ports001, table 5.2.1], which
//! does not say from which linkage they were read off.

use cmaes::{CMAESOptions, DVector};
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::kernel::calc::Calc;
use lemnis_models::parts::four_bar::Branch;

/// Columns of the table: the boom angle, and the three lengths that a linkage has.
const ANGLE: usize = 0;
const R_1: usize = 2;
const R_2: usize = 3;
const R_C: usize = 4;

fn table() -> Vec<Vec<f64>> {
    let text = include_str!("../../../tests/oracles/balance_lever_table_5_2_1.csv");
    let row = |line: &str| {
        line.split(',')
            .map(|cell| cell.parse().expect("a number"))
            .collect::<Vec<f64>>()
    };
    text.lines().skip(1).map(row).collect()
}

/// The linkage of the least mean square: d_1, delta_1, r_1, alpha_K, l_1, R_1,
/// chi_5 and the counterweight's arm, in m and rad.
const START: [f64; 8] = [9.0618, 2.01278, 7.153, 0.08231, 6.121, 2.356, 2.60752, 3.203];

fn dimensions(x: &[f64]) -> Dimensions<f64> {
    Dimensions {
        d_1: x[0],
        delta_1: x[1],
        r_1: x[2],
        alpha_1: x[3],
        l_1: x[4],
        lever: x[5],
        chi_5: x[6],
        m_5: 1.0,
    }
}

/// Greatest deviation of a linkage from the table, in m, with the cells (angle
/// and column) of `without` left out.
fn worst(x: &[f64], without: &[(f64, usize)]) -> f64 {
    let Ok(lever) = Lever::new(dimensions(x), None, Branch::Left) else {
        return 1e3;
    };
    let mut worst = 0.0_f64;
    for line in table() {
        let phi = line[ANGLE].to_radians();
        let (Ok([r_1, r_2]), Ok(action)) = (lever.arms(phi), lever.at(phi)) else {
            return 1e2;
        };
        let psi = action.lever.expect("a lever turns").psi;
        let r_c = -x[7] * Calc::sin_cos(psi).1;
        for (value, column) in [(r_1, R_1), (r_2, R_2), (r_c, R_C)] {
            if !without.contains(&(line[ANGLE], column)) {
                worst = worst.max((value - line[column]).abs());
            }
        }
    }
    worst
}

/// The least worst deviation near the linkage of the least mean square, in mm.
fn least_worst(without: &[(f64, usize)]) -> f64 {
    let mut x = START.to_vec();
    for (seed, sigma) in (1..).zip([0.01, 0.003, 0.001, 0.01, 0.003, 0.001]) {
        let cost = |x: &DVector<f64>| worst(x.as_slice(), without);
        let run = CMAESOptions::new(x.clone(), sigma)
            .seed(seed)
            .max_function_evals(20_000)
            .tol_fun(1e-10)
            .build(cost);
        let best = run
            .expect("sound options")
            .run()
            .overall_best
            .expect("one was tried")
            .point;
        if worst(best.as_slice(), without) < worst(&x, without) {
            x = best.as_slice().to_vec();
        }
    }
    1e3 * worst(&x, without)
}

/// No linkage is known that comes nearer than 26.9 mm in the worst cell: of 180
/// random starts in both branches none did, and many ended exactly there. One
/// cell, R_1 at 60°, contradicts its own column; without it 21.2 mm are left, and
/// without R_2 at 52.5° too, which nothing in the table contradicts, 18.5 mm.
#[test]
fn the_least_worst_cell() {
    let contradicted = (60.0, R_1);
    let all = least_worst(&[]);
    let without_one = least_worst(&[contradicted]);
    let without_two = least_worst(&[contradicted, (52.5, R_2)]);
    println!("{all:.2} {without_one:.2} {without_two:.2} mm");
    assert!((all - 26.86).abs() <= 0.1, "{all}");
    assert!(without_one < 21.5, "{without_one}");
    assert!(without_two < 20.0, "{without_two}");
}

/// The arm of a linkage near the table bends less and less away from its dead
/// point; the column R_1 bends more at 60° than at 55°, and hardly at 65°. A
/// value 40 mm smaller at 60° puts it right.
#[test]
fn a_cell_contradicts_its_column() {
    // Second divided differences of a column in mm, doubled, but for the last two:
    // there the bend changes its sign.
    let bends = |column: &[[f64; 2]]| -> Vec<f64> {
        let slope = |a: &[f64; 2], b: &[f64; 2]| 1e3 * (b[1] - a[1]) / (b[0] - a[0]);
        let bend = |t: &[[f64; 2]]| 2.0 * (slope(&t[1], &t[2]) - slope(&t[0], &t[1])) / (t[2][0] - t[0][0]);
        column.windows(3).take(4).map(bend).collect()
    };
    let falls = |bends: &[f64]| bends.windows(2).all(|pair| pair[0] < pair[1]);
    let column = |change: f64| -> Vec<[f64; 2]> {
        let cell = |row: Vec<f64>| [row[ANGLE], row[R_1] + if row[ANGLE] == 60.0 { change } else { 0.0 }];
        table().into_iter().map(cell).collect()
    };
    let (printed, mended) = (bends(&column(0.0)), bends(&column(-0.040)));
    println!("{printed:.1?} {mended:.1?}");
    assert!(!falls(&printed) && falls(&mended), "{printed:?} {mended:?}");
    // The least mean square, and the least worst cell, whose pivot lies at another angle.
    let other = [8.83870, 1.20217, 7.16780, -0.70664, 5.83150, 2.35213, -2.89366, 3.19958];
    for x in [START, other] {
        let lever = Lever::new(dimensions(&x), None, Branch::Left).expect("a lever");
        let arm = |row: Vec<f64>| lever.arms(row[ANGLE].to_radians()).map(|arms| [row[ANGLE], arms[0]]);
        let arms: Vec<[f64; 2]> = table().into_iter().filter_map(|row| arm(row).ok()).collect();
        assert!(arms.len() == 8 && falls(&bends(&arms)), "{:?}", bends(&arms));
    }
}
