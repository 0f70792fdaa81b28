//! The balance of the boom system against the publications, and against itself.

#[path = "common/portal.rs"]
mod portal;

use std::f64::consts::PI;

use lemnis_models::balance::analysis::Analysis;
use lemnis_models::balance::boom::{Boom, Plain};
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::balance::parallelogram::Parallelogram;
use lemnis_models::balance::published::table_5_2_1;
use lemnis_models::balance::residual::Residual;
use lemnis_models::balance::straight_rail::StraightRail;
use lemnis_models::balance::tail::Tail;
use lemnis_models::balance::{Balance, curved_rail, symbols};
use lemnis_models::component::stages::Rows;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::record::{Rec, record};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::luffing::criteria::Criteria;
use lemnis_models::luffing::double_link::parameters::{Driven, Lengths, Parameters, Weights};
use lemnis_models::luffing::double_link::system::BoomSystem;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::parts::motion::Motion;
use lemnis_models::parts::plane;
use num_dual::Dual64;
use portal::{boom, lever, oracle, published, rad, range};
use proptest::prelude::*;

fn plain() -> Plain<f64> {
    let plain = Plain {
        g_b: 120e3,
        r_b: 14.14,
        chi_b: 0.0,
    };
    plain.check().expect("a boom")
}

/// [Balance004]: transmission angles to the printed digit; residual and energy
/// integral are what rounding of the printed dimensions leaves of the printed
/// values, which lie inside the band that rounding alone opens.
#[test]
fn published_levers_of_004() {
    let boom = boom();
    // Half of the last printed digit of r_1, alpha_1, l_1, R_1, chi_5, M_5.
    let halves = [
        ("existing", [5e-3, 5e-7, 5e-3, 5e-3, 5e-5, 500.0]),
        ("synthesised", [5e-4, 5e-3, 5e-4, 5e-4, 5e-3, 50.0]),
    ];
    // What the dimensions as printed give, found independently before this code.
    let given = [[275.9, 89.8], [68.9, 8.2]];
    let bands = [[[254.0, 310.0], [82.0, 102.0]], [[51.0, 109.0], [7.6, 19.7]]];
    for (((name, half), [dm, energy]), stated) in halves.into_iter().zip(given).zip(bands) {
        let d = published(&format!("balance_{name}"));
        let balance = Balance::Lever(lever(d));
        let found = Analysis::new(&boom, &balance, range()).expect("closes");
        let printed = |key: &str| oracle()["printed"][name][key].as_f64().expect("a number");
        let gamma = found.gamma_min.expect("a lever").value.to_degrees();
        println!(
            "{name}: |dM|max {:.2} (printed {}), integral of |dM| {:.3} (printed {}), its positive part {:.3}, gamma {gamma:.2}, rod {:.0}",
            found.dm_max.value / 1e3,
            printed("dM_max_kNm"),
            found.e_abs / 1e3,
            printed("E_plus_kJ"),
            found.e_plus / 1e3,
            found.n_max.expect("a rod").value / 1e3
        );
        assert!((gamma - printed("gamma_min_deg")).abs() <= 0.06, "{name}: {gamma}");
        assert!((found.dm_max.value / 1e3 - dm).abs() <= 0.05, "{name}");
        assert!((found.e_abs / 1e3 - energy).abs() <= 0.05, "{name}");
        let mut bands = [[f64::INFINITY, 0.0]; 2];
        let mut random = fastrand::Rng::with_seed(4);
        let scene = portal::parameters();
        for _ in 0..1000 {
            let mut off = |half: f64| half * (2.0 * random.f64() - 1.0);
            // Half of the last printed digit of the boom's own data.
            let boom = scene.map(&mut |symbol, value| {
                value
                    + match symbol.id {
                        "X_1" | "X_2" | "X_3" | "s_2" => off(0.05),
                        "X_5" | "X_6" => off(5e-4),
                        "s_1" => off(5e-4),
                        "s_3" => off(5e-3),
                        "G_1" => off(500.0),
                        "G_2" => off(5.0),
                        "G_3" => off(50.0),
                        "chi_1" | "chi_3" => rad(off(0.5)),
                        "chi_2" => rad(off(5e-3)),
                        _ => 0.0,
                    }
            });
            let boom = BoomSystem::new(&boom).expect("exists");
            let other = Dimensions {
                d_1: d.d_1 + off(5e-4),
                delta_1: d.delta_1 + rad(off(5e-3)),
                r_1: d.r_1 + off(half[0]),
                alpha_1: d.alpha_1 + rad(off(half[1])),
                l_1: d.l_1 + off(half[2]),
                lever: d.lever + off(half[3]),
                chi_5: d.chi_5 + rad(off(half[4])),
                m_5: d.m_5 + off(half[5]),
            };
            let found = Analysis::new(&boom, &Balance::Lever(lever(other)), range()).expect("closes");
            for (band, value) in bands.iter_mut().zip([found.dm_max.value, found.e_abs]) {
                *band = [band[0].min(value / 1e3), band[1].max(value / 1e3)];
            }
        }
        println!("rounding bands {bands:.1?}");
        // As the book's remark states them, from other random roundings.
        for (found, stated) in bands.as_flattened().iter().zip(stated.as_flattened()) {
            assert!((found / stated - 1.0).abs() <= 0.07, "{name}: {found} {stated}");
        }
        for (band, key) in bands.iter().zip(["dM_max_kNm", "E_plus_kJ"]) {
            assert!((band[0]..=band[1]).contains(&printed(key)), "{name} {key}: {band:?}");
        }
    }
}

/// 756 kN in the existing lever's rod, 3265 kN in the new one: the paper leaves it out.
#[test]
fn rod_force_of_004() {
    for (name, force) in [("balance_existing", 756.0), ("balance_synthesised", 3265.0)] {
        let found = Analysis::new(&boom(), &Balance::Lever(lever(published(name))), range()).expect("closes");
        assert!((found.n_max.expect("a rod").value / 1e3 - force).abs() <= 0.5, "{name}");
    }
}

/// The double node is an unstable equilibrium, the stable ones are at 50.0 and 74.5 deg.
#[test]
fn equilibria_of_004() {
    let found = Analysis::new(
        &boom(),
        &Balance::Lever(lever(published("balance_synthesised"))),
        range(),
    );
    let found = found.expect("closes").equilibria;
    println!(
        "{:?}",
        found.iter().map(|e| (e.phi.to_degrees(), e.stable)).collect::<Vec<_>>()
    );
    let stable: Vec<f64> = found.iter().filter(|e| e.stable).map(|e| e.phi.to_degrees()).collect();
    assert_eq!(stable.len(), 2);
    assert!(
        (stable[0] - 50.0).abs() < 0.1 && (stable[1] - 74.5).abs() < 0.1,
        "{stable:?}"
    );
}

/// The boom closes for phi in about 36.1 to 84.5 deg: outside, an error says so.
#[test]
fn outside_the_range_of_assembly() {
    let boom = boom();
    for phi in [30.0, 36.0, 84.6, 120.0] {
        let fault = boom.at(rad(phi)).expect_err("does not close");
        assert_eq!(fault.quantity.id, "phi");
        let text = fault.to_string();
        assert!(text.contains("36.0") || text.contains("36.1"), "{text}");
        assert!(text.contains("84.4") || text.contains("84.5"), "{text}");
    }
    let balance = Balance::Lever(lever(published("balance_existing")));
    assert!(Analysis::new(&boom, &balance, [rad(30.0), rad(82.0)]).is_err());
    assert!(Analysis::new(&boom, &balance, [rad(82.0), rad(44.0)]).is_err());
    assert!(Analysis::new(&boom, &balance, [rad(44.0), f64::NAN]).is_err());
}

/// Lengths of table 5.2.1 give its moments; cells that they do not give to the
/// printed digit are the known misprints.
#[test]
fn table_5_2_1_from_its_lengths() {
    // Row and column: 0 boom, 1 counterweight, 2 what is left, where it is not
    // merely the difference of two rounded cells.
    let known = [
        (55.0, 1, 25.44),
        (55.0, 2, 0.12),
        (60.0, 0, 26.91),
        (60.0, 2, 1.71),
        (65.0, 0, 24.35),
        (65.0, 1, 23.04),
        (65.0, 2, 1.315),
        (75.0, 1, 14.24),
        (75.0, 2, -0.73),
        (80.5, 0, 6.83),
        (80.5, 2, 0.43),
    ];
    let mut misprints = Vec::new();
    for (row, line) in table_5_2_1().iter().zip(table()) {
        let printed = row
            .given
            .iter()
            .copied()
            .chain(row.moments.iter().map(|cell| cell.printed));
        assert!(
            printed.eq(line.iter().map(|cell| cell.0.as_str())),
            "not the oracle's row"
        );
        for (column, cell) in row.moments.iter().enumerate() {
            let printed = line[5 + column].1;
            // The printed digits drift by two or three at the most.
            assert!(
                (cell.computed - printed).abs() <= 0.035 + 0.05,
                "{}: {}",
                row.given[0],
                cell.computed
            );
            if cell.misprint {
                misprints.push((line[0].1, column, cell.computed));
            }
        }
    }
    assert_eq!(misprints.len(), known.len(), "{misprints:?}");
    for (found, known) in misprints.iter().zip(known) {
        assert_eq!((found.0, found.1), (known.0, known.1));
        assert!((found.2 - known.2).abs() <= 0.0051, "{found:?} {known:?}");
    }
}

/// Rows of the table, each cell as text and as number.
fn table() -> Vec<Vec<(String, f64)>> {
    let text = include_str!("../../tests/oracles/balance_lever_table_5_2_1.csv");
    let cell = |cell: &str| (cell.to_owned(), cell.parse().expect("a number"));
    text.lines()
        .skip(1)
        .map(|line| line.split(',').map(cell).collect())
        .collect()
}

/// The linkage behind table 5.2.1, which the book does not give: the one of the
/// least mean square. The lengths were read off a drawing: no linkage comes
/// nearer than 27 mm in the worst cell (the least worst deviation that 150
/// random starts found is 26.86 mm, from many of them).
fn linkage_5_2_1() -> Lever<f64> {
    let (x, y) = (-3.876_f64, 8.191_f64);
    let dimensions = Dimensions {
        d_1: plane::length(plane::Point::new(x, y)),
        delta_1: f64::direction(x, y),
        r_1: 7.153,
        alpha_1: rad(4.716),
        l_1: 6.121,
        lever: 2.356,
        chi_5: rad(149.4),
        m_5: 8.0 * 3.203,
    };
    Lever::new(dimensions, Some(3.203), Branch::Left).expect("a lever")
}

/// Within 20 mm in the mean square, and cell by cell but for four of 24: those
/// are R_2 at 52.5 and 55 deg, R_1 at 60 and 70 deg.
#[test]
fn a_linkage_behind_table_5_2_1() {
    let lever = linkage_5_2_1();
    let mut squares = 0.0;
    let mut beyond = Vec::new();
    for line in table() {
        let phi = rad(line[0].1);
        let [r_1, r_2] = lever.arms(phi).expect("closes");
        let turn = lever.at(phi).expect("closes").lever.expect("turns");
        let r_c = -3.203 * Calc::sin_cos(turn.psi).1;
        for (value, column) in [(r_1, 2), (r_2, 3), (r_c, 4)] {
            let off = value - line[column].1;
            squares += off * off;
            if off.abs() > 0.020 {
                beyond.push((line[0].1, column, off));
            }
        }
    }
    let rms = (squares / 24.0_f64).sqrt();
    println!("rms {:.1} mm, beyond 20 mm: {beyond:.4?}", rms * 1e3);
    assert!(rms <= 0.015, "{rms}");
    let cells: Vec<(f64, usize)> = beyond.iter().map(|cell| (cell.0, cell.1)).collect();
    assert_eq!(cells, [(52.5, 3), (55.0, 3), (60.0, 2), (70.0, 2)]);
    assert!(beyond.iter().all(|cell| cell.2.abs() <= 0.040), "{beyond:?}");
}

/// What is left about the foot is what is left about the pivot times R1 / R2.
#[test]
fn residuals_about_foot_and_pivot_are_two() {
    let lever = linkage_5_2_1();
    let boom = Plain {
        g_b: 12.0,
        r_b: 14.14,
        chi_b: 0.0,
    };
    let boom = boom.check().expect("a boom");
    for line in table() {
        let phi = rad(line[0].1);
        let left = Residual::new(&boom, &Balance::Lever(lever), phi).expect("closes");
        let [r_1, r_2] = lever.arms(phi).expect("closes");
        let dm_5 = left.dm_5.expect("a lever");
        assert!((left.dm - dm_5 * r_1 / r_2).abs() <= 1e-12 * left.boom.m_0.abs());
        // The table counts what lowers the boom as positive; up to 40 mm in the
        // arms leave up to 2 % of the boom's moment.
        assert!(
            (-dm_5 - line[7].1).abs() <= 0.02 * 27.0,
            "{}: {dm_5} {}",
            line[0].1,
            line[7].1
        );
    }
}

/// Tail weight and parallelogram leave nothing at any angle.
#[test]
fn tail_weight_and_parallelogram_are_exact() {
    let boom = plain();
    let tail = Tail {
        g_c: 120e3 * 14.14 / 4.0,
        r_c: 4.0,
        chi_c: 0.0,
    };
    let parallelogram = Parallelogram {
        g_c: tail.g_c,
        r_c: 4.0,
        chi_c: 0.0,
        r_1: 3.0,
        alpha_1: 0.1,
        d_1: 6.0,
        delta_1: 2.5,
    };
    let balances = [
        Balance::Tail(tail.new().expect("sound")),
        Balance::Parallelogram(parallelogram.new().expect("sound")),
    ];
    for balance in balances {
        let found = Analysis::new(&boom, &balance, [rad(5.0), rad(85.0)]).expect("exists");
        assert!(
            found.dm_max.value <= 1e-14 * 120e3 * 14.14 * 10.0,
            "{}",
            found.dm_max.value
        );
        assert!(found.equilibria.is_empty());
    }
}

/// Guide pulley straight above the foot, vertical rail: M = cos(phi) (G r − G_c b H / s).
#[test]
fn straight_rail_by_its_closed_form() {
    let (g_c, b, h) = (150e3, 8.0, 11.0);
    let rail = StraightRail {
        g_c,
        r_1: b,
        alpha_1: 0.0,
        h_x: 0.0,
        h_y: h,
        lambda: PI / 2.0,
    };
    let balance = Balance::StraightRail(rail.new().expect("sound"));
    for degrees in 1..90 {
        let phi = rad(f64::from(degrees));
        let left = Residual::new(&plain(), &balance, phi).expect("exists").dm;
        let (sin, cos) = Calc::sin_cos(phi);
        let s = (b * b + h * h - 2.0 * b * h * sin).sqrt();
        let closed = -cos * (120e3 * 14.14 - g_c * b * h / s);
        assert!((left - closed).abs() <= 1e-9 * 120e3, "{degrees}: {left} {closed}");
    }
}

/// The curved rail: the trolley's own equilibrium gives the boom's moment, the
/// potential energy stays, and the travel is along the rail.
#[test]
fn curved_rail_keeps_the_energy() {
    let booms: [&dyn Boom<f64>; 2] = [&boom(), &plain()];
    for boom in booms {
        let dimensions = curved_rail::RailDimensions {
            g_c: 300e3,
            r_1: 9.0,
            alpha_1: rad(10.0),
            l_r: 14.0,
            y_0: 10.0,
            phi_0: rad(60.0),
        };
        let rail = curved_rail::CurvedRail::new(dimensions, |phi| Ok(boom.at(phi)?.u_0)).expect("sound");
        let mut whole: Option<f64> = None;
        for i in 0..=380 {
            let phi = rad(44.0 + 0.1 * f64::from(i));
            let left = Residual::new(boom, &Balance::CurvedRail(rail), phi).expect("reaches");
            assert!(
                left.dm.abs() <= 1e-12 * left.boom.m_0.abs().max(1e6),
                "{} {}",
                phi.to_degrees(),
                left.dm
            );
            let energy = left.boom.u_0 + left.action.u_5;
            let first = *whole.get_or_insert(energy);
            assert!(
                (energy - first).abs() <= 1e-12 * first.abs().max(1.0),
                "{energy} {first}"
            );
            let load = boom.at(phi).expect("closes");
            let place = rail.rail(phi, load.u_0).expect("reaches");
            let (sin, cos) = Calc::sin_cos(phi + rad(10.0));
            let rope = plane::length(plane::Point::new(9.0 * cos, 9.0 * sin) - place);
            assert!((rope - 14.0).abs() < 1e-12 * 14.0);
        }
        let short = curved_rail::RailDimensions { l_r: 0.5, ..dimensions };
        let rail = curved_rail::CurvedRail::new(short, |phi| Ok(boom.at(phi)?.u_0)).expect("sound");
        let fault = Analysis::new(boom, &Balance::CurvedRail(rail), range()).expect_err("too short");
        assert_eq!(fault.quantity.id, "L_r");
    }
}

/// A parallelogram does not pass its dead point, a rope does not push.
#[test]
fn dead_points_and_slack_ropes() {
    let lever = Parallelogram {
        g_c: 4e5,
        r_c: 4.0,
        chi_c: 0.0,
        r_1: 3.0,
        alpha_1: 0.0,
        d_1: 6.0,
        delta_1: rad(60.0),
    };
    let balance = Balance::Parallelogram(lever.new().expect("sound"));
    let fault = Analysis::new(&plain(), &balance, range()).expect_err("the rod points at the foot at 60 deg");
    assert_eq!(fault.quantity.id, "phi");
    assert!(
        (fault.allowed[1] - rad(60.0)).abs() < 1e-9 || (fault.allowed[0] - rad(60.0)).abs() < 1e-9,
        "{fault}"
    );
    // A trolley so low that the rope passes in front of the boom foot pulls the boom down.
    let low = curved_rail::RailDimensions {
        g_c: 300e3,
        r_1: 9.0,
        alpha_1: 0.0,
        l_r: 34.0,
        y_0: -25.0,
        phi_0: rad(60.0),
    };
    let rail = curved_rail::CurvedRail::new(low, |phi| Ok(plain().at(phi)?.u_0)).expect("sound");
    let fault = Analysis::new(&plain(), &Balance::CurvedRail(rail), range()).expect_err("the rope pulls down");
    assert_eq!(fault.quantity.id, "N_1", "{fault}");
}

/// Zero weights have zero moments, and no equilibrium is made of rounding.
#[test]
fn zero_weights() {
    let weightless = Plain {
        g_b: 0.0,
        r_b: 10.0,
        chi_b: 0.0,
    };
    let tail = Tail {
        g_c: 0.0,
        r_c: 4.0,
        chi_c: 0.0,
    };
    let balance = Balance::Tail(tail.new().expect("sound"));
    let found = Analysis::new(&weightless.check().expect("sound"), &balance, range()).expect("exists");
    assert_eq!((found.dm_max.value, found.e_abs), (0.0, 0.0));
    assert!(found.equilibria.is_empty());
    let p = portal::parameters();
    let fault = BoomSystem::new(&Parameters { weights: None, ..p }).expect_err("no weights");
    assert!(fault.to_string().contains("no weights"), "{fault}");
    assert!(
        BoomSystem::new(&Parameters {
            driven: Driven::Rocker,
            ..p
        })
        .is_err()
    );
    let none = p
        .weights
        .map(|w| w.map(&mut |symbol, x| if symbol.id.starts_with('G') { 0.0 } else { x }));
    let boom = BoomSystem::new(&Parameters { weights: none, ..p }).expect("sound");
    assert_eq!(boom.at(rad(60.0)).expect("closes").m_0, 0.0);
}

/// Every value that no crane can have is refused by name.
#[test]
fn bad_dimensions_are_refused_by_name() {
    let good = published("balance_synthesised");
    type Spoil = fn(&mut Dimensions<f64>);
    let spoils: [(&str, Spoil); 9] = [
        ("d_1", |d| d.d_1 = 0.0),
        ("r_1", |d| d.r_1 = -1.0),
        ("l_1", |d| d.l_1 = f64::NAN),
        ("R_1", |d| d.lever = f64::INFINITY),
        ("alpha_K", |d| d.alpha_1 = f64::NAN),
        ("chi_5", |d| d.chi_5 = f64::INFINITY),
        ("delta_1", |d| d.delta_1 = f64::NAN),
        ("M_5", |d| d.m_5 = -1.0),
        ("l_1", |d| d.l_1 = 30.0),
    ];
    for (id, spoil) in spoils {
        let mut d = good;
        spoil(&mut d);
        let fault = Lever::new(d, None, Branch::Left).expect_err(id);
        assert_eq!(fault.quantity.id, id, "{fault}");
    }
    assert_eq!(
        Lever::new(good, Some(0.0), Branch::Left)
            .expect_err("no arm")
            .quantity
            .id,
        "s_5"
    );
    // A lever that closes at both ends of the range but has a dead point between is no balance.
    let dead = Dimensions { l_1: 8.86, ..good };
    let lever = Lever::new(dead, None, Branch::Left).expect("closes somewhere");
    let fault = Analysis::new(&boom(), &Balance::Lever(lever), range()).expect_err("not over the range");
    assert_eq!(fault.quantity.id, "phi", "{fault}");
}

fn system(x: [f64; 6], w: [f64; 9]) -> Option<BoomSystem<f64>> {
    let p = portal::parameters();
    let l = p.lengths;
    let lengths = Lengths {
        x_1: l.x_1 * x[0],
        x_2: l.x_2 * x[1],
        x_3: l.x_3 * x[2],
        x_4: l.x_4 * x[3],
        x_5: l.x_5 * x[4],
        x_6: l.x_6 * x[5],
        ..l
    };
    let weights = Weights {
        g_1: w[0] * 2e5,
        s_1: w[1] * 20.0,
        chi_1: w[2] - 0.5,
        g_2: w[3] * 1e5,
        s_2: w[4] * 8.0,
        chi_2: w[5] * 6.0,
        g_3: w[6] * 5e4,
        s_3: w[7] * 15.0,
        chi_3: w[8] - 0.5,
    };
    BoomSystem::new(&Parameters {
        lengths,
        weights: Some(weights),
        ..p
    })
    .ok()
}

/// Every formula of every balance has the dimension of its name.
#[test]
fn dimensions_are_consistent() {
    let p = portal::parameters();
    let d = published("balance_existing");
    let rail = curved_rail::RailDimensions {
        g_c: 300e3,
        r_1: 9.0,
        alpha_1: rad(10.0),
        l_r: 14.0,
        y_0: 10.0,
        phi_0: rad(60.0),
    };
    let (trace, values) = record(|| {
        let given = &mut Rec::given;
        let phi = Rec::given(&symbols::PHI, rad(60.0));
        let system = BoomSystem::new(&p.map(&mut Rec::given)).expect("exists");
        let plain = Plain {
            g_b: 12e4,
            r_b: 14.0,
            chi_b: 0.1,
        };
        let plain = plain.map(given).check().expect("sound");
        system.moment_by_power(phi).expect("closes");
        plain.moment_by_power(phi).expect("closes");
        let lever = Lever::new(d.map(given), Some(Rec::given(&symbols::S_5, 3.0)), Branch::Left);
        let tail = Tail {
            g_c: 4e5,
            r_c: 4.0,
            chi_c: 0.0,
        };
        let parallelogram = Parallelogram {
            g_c: 4e5,
            r_c: 4.0,
            chi_c: 0.0,
            r_1: 3.0,
            alpha_1: 0.1,
            d_1: 6.0,
            delta_1: 2.5,
        };
        let straight = StraightRail {
            g_c: 15e4,
            r_1: 8.0,
            alpha_1: 0.0,
            h_x: -2.0,
            h_y: 11.0,
            lambda: 1.2,
        };
        let balances = [
            Balance::Lever(lever.expect("closes")),
            Balance::Tail(tail.map(given).new().expect("sound")),
            Balance::Parallelogram(parallelogram.map(given).new().expect("sound")),
            Balance::StraightRail(straight.map(given).new().expect("sound")),
            Balance::CurvedRail(
                curved_rail::CurvedRail::new(rail.map(given), |phi| Ok(system.at(phi)?.u_0)).expect("sound"),
            ),
        ];
        balances.map(|balance| Residual::new(&system, &balance, phi).expect("closes").dm.value())
    });
    assert!(trace.faults.is_empty(), "{:#?}", trace.faults);
    // The recorder's values are the simulation's.
    let lever = Residual::new(&boom(), &Balance::Lever(lever(d)), rad(60.0)).expect("closes");
    assert_eq!(values[0], lever.dm);
}

/// The results of a stage that exist, under their symbols.
fn told<T: Rows<f64>>(stage: &T) -> Vec<(&'static Symbol, f64)> {
    let rows = (0..).zip(T::ROWS);
    rows.filter_map(|(row, symbol)| Some((*symbol, stage.row(row, 0).ok()?)))
        .collect()
}

/// What exists is listed under its symbol, each once.
#[test]
fn results_carry_their_symbols() {
    let balance = Balance::Lever(lever(published("balance_existing")));
    let at = |phi| Residual::new(&boom(), &balance, phi);
    let [from, to] = range();
    let motion = Motion {
        from,
        to,
        step: 0.1,
        speed: 0.01,
        by_part: false,
        period: std::f64::consts::TAU,
    };
    let found = Analysis::new(&boom(), &balance, [from, to]).expect("closes");
    let mut list = told(&at(rad(60.0)).expect("closes"));
    list.extend(told(&Criteria::new(&found, &motion, &at).expect("closes")));
    assert_eq!(list.len(), 13 + 7);
    for (i, (symbol, value)) in list.iter().enumerate() {
        assert!(value.is_finite(), "{}", symbol.id);
        assert!(
            list[..i].iter().all(|(other, _)| other != symbol),
            "{} twice",
            symbol.id
        );
    }
}

proptest! {
    /// At any angle, closing or not: finite results or an error, never a NaN.
    #[test]
    fn never_a_nan(
        d_1 in 0.1..15.0_f64, r_1 in 0.1..15.0_f64, l_1 in 0.1..15.0_f64, arm in 0.1..15.0_f64, phi in -10.0..10.0_f64,
    ) {
        let d = Dimensions { d_1, delta_1: 1.8, r_1, alpha_1: 0.3, l_1, lever: arm, chi_5: 2.5, m_5: 1e6 };
        match Lever::new(d, Some(3.0), Branch::Left) {
            Err(fault) => prop_assert_eq!(fault.quantity.id, "l_1"),
            Ok(lever) => {
                // Angles, and both ends of assembly.
                let [from, to] = lever.arc(phi);
                for phi in [phi, from, to] {
                    match lever.at(phi) {
                        Ok(action) => {
                            let turn = action.lever.expect("turns");
                            for value in [action.m_b, action.u_5, action.n_1.expect("a rod"), turn.psi, turn.i_5, turn.gamma] {
                                prop_assert!(value.is_finite());
                            }
                        }
                        Err(fault) => prop_assert_eq!(fault.quantity.id, "phi"),
                    }
                }
            }
        }
    }

    /// Virtual work, power about instant centres, and the slope of the
    /// potential energy are one moment.
    #[test]
    fn three_ways_to_the_moment_of_the_boom(
        x in prop::array::uniform6(0.8..1.2_f64),
        w in prop::array::uniform9(0.0..1.0_f64),
        part in 0.05..0.95_f64,
    ) {
        if let Some(boom) = system(x, w) {
            let BoomSystem { g, w: weights } = boom;
            let arc = g.linkage.arcs()[0];
            let phi = arc.from + part * (arc.to - arc.from);
            let m_0 = boom.at(phi).expect("inside the arc").m_0;
            let scale: f64 = boom.parts(phi).expect("closes").iter().map(|part| part.abs()).sum::<f64>().max(1e5);
            let power = boom.moment_by_power(phi).expect("inside the arc");
            prop_assert!((m_0 - power).abs() <= 1e-12 * scale, "{m_0} {power}");
            let dual = BoomSystem {
                g: g.map(Dual64::from_re),
                w: weights.map(&mut |_, value| Dual64::from_re(value)),
            };
            let slope = dual.at(Dual64::new(phi, 1.0)).expect("inside the arc").u_0.eps;
            prop_assert!((m_0 + slope).abs() <= 1e-11 * scale, "{m_0} {slope}");
            let parts: f64 = boom.parts(phi).expect("closes").iter().sum();
            prop_assert!((m_0 - parts).abs() <= 1e-13 * scale);
        }
    }

    /// For any lever: the moment is the fall of the counterweight's energy, and
    /// that of the rod's force; the pivot holds rod and counterweight; delta_1
    /// only rotates everything.
    #[test]
    fn any_lever(
        d_1 in 5.0..15.0_f64, delta_1 in 1.2..2.4_f64, r_1 in 0.5..10.0_f64, alpha_1 in -1.0..1.0_f64,
        l_1 in 1.0..15.0_f64, arm in 0.3..5.0_f64, chi_5 in -3.0..3.0_f64, left: bool, part in 0.1..0.9_f64, turn in -1.0..1.0_f64,
    ) {
        let branch = if left { Branch::Left } else { Branch::Right };
        let d = Dimensions { d_1, delta_1, r_1, alpha_1, l_1, lever: arm, chi_5, m_5: 1e6 };
        if let Ok(lever) = Lever::new(d, Some(4.0), branch) {
            let [from, to] = lever.arc(1.0).map(|end| end.clamp(-3.0, 5.0));
            let phi = from + part * (to - from);
            let action = lever.at(phi).expect("inside the arc");
            let lift = action.lever.expect("turns");
            let scale = 1e6 * (1.0 + lift.i_5.abs());
            let dual = Lever::new(d.map(&mut |_, value| Dual64::from_re(value)), Some(Dual64::from_re(4.0)), branch);
            let slope = dual.expect("the same").at(Dual64::new(phi, 1.0)).expect("the same");
            prop_assert!((action.m_b + slope.u_5.eps).abs() <= 1e-10 * scale);
            prop_assert!((lift.i_5 - slope.lever.expect("turns").psi.eps).abs() <= 1e-10 * (1.0 + lift.i_5.abs()));
            let (sin, cos) = Calc::sin_cos(phi + alpha_1);
            let k = plane::Point::new(r_1 * cos, r_1 * sin);
            prop_assert!((plane::cross(k, action.on_boom) - action.m_b).abs() <= 1e-11 * scale * (1.0 + r_1));
            let pivot = action.on_pivot.expect("an arm") - action.on_boom;
            prop_assert!(pivot.x.abs() <= 1e-6 && (pivot.y - 1e6 / 4.0).abs() <= 1e-6);
            let turned = Dimensions { delta_1: delta_1 + turn, alpha_1: alpha_1 + turn, chi_5: chi_5 - turn, ..d };
            let turned = Lever::new(turned, Some(4.0), branch).expect("the same lengths").at(phi).expect("closes too");
            prop_assert!((turned.m_b - action.m_b).abs() <= 1e-9 * scale, "{} {}", turned.m_b, action.m_b);
        }
    }

    /// Rail and parallelogram: the moment is the fall of the counterweight's energy.
    #[test]
    fn any_rail_and_parallelogram(
        r_1 in 1.0..10.0_f64, alpha_1 in -0.5..0.5_f64, x in -8.0..3.0_f64, y in 10.5..20.0_f64, lambda in 0.1..1.57_f64, phi in 0.1..1.5_f64,
    ) {
        let rail = StraightRail { g_c: 1e5, r_1, alpha_1, h_x: x, h_y: y, lambda };
        let action = rail.new().expect("sound").at(phi).expect("exists");
        let dual = rail.map(&mut |_, value| Dual64::from_re(value)).new().expect("sound");
        let slope = dual.at(Dual64::new(phi, 1.0)).expect("exists").u_5.eps;
        prop_assert!((action.m_b + slope).abs() <= 1e-12 * 1e5 * r_1);
        let lever = Parallelogram { g_c: 1e5, r_c: 3.0, chi_c: alpha_1, r_1, alpha_1, d_1: y, delta_1: 2.6 };
        let action = lever.new().expect("sound").at(phi).expect("no dead point");
        let dual = lever.map(&mut |_, value| Dual64::from_re(value)).new().expect("sound");
        let slope = dual.at(Dual64::new(phi, 1.0)).expect("exists").u_5.eps;
        prop_assert!((action.m_b + slope).abs() <= 1e-12 * 3e5);
    }
}
