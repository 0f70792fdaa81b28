//! The double-link mechanism at its singular positions, against 50-digit
//! references: `tests/oracles/lemniscate_extremes.py` made them.

mod common;

use lemnis_models::luffing::double_link::parameters::Driven;
use lemnis_models::luffing::double_link::pole::Pole;
use lemnis_models::luffing::double_link::position::Position;
use lemnis_models::luffing::double_link::statics::LoadMoment;
use lemnis_models::luffing::double_link::velocity::Velocity;

const ORACLE: &str = include_str!("../../tests/oracles/lemniscate_extremes.csv");

/// Value of a C99 hexadecimal literal.
fn hex(text: &str) -> f64 {
    let (sign, digits) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let (mantissa, exponent) = digits.trim_start_matches("0x").split_once('p').expect("0x1.8p+0");
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let bits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).expect("hexadecimal");
    let exponent: i32 = exponent.parse().expect("a power of two");
    sign * bits as f64 * 2_f64.powi(exponent - 4 * i32::try_from(fraction.len()).expect("short"))
}

fn ulp(x: f64) -> f64 {
    f64::from_bits(x.abs().to_bits() + 1) - x.abs()
}

/// At theta_1 = theta_3, within 1e-12 rad of it, and from 1e-1 to 1e-15 rad
/// before each dead point, which are the ends of assembly: at most 4 ulp in the
/// angle; in Y_A, M_Q and V_A at most 1e-14 of the range that the reference
/// covers from 0.1 rad inside one end of assembly to 0.1 rad inside the other,
/// or of the value itself where it is greater: M_Q and V_A grow beyond all
/// bounds towards a dead point.
#[test]
fn singular_positions_agree_with_50_digits() {
    let mut worst = [0.0_f64; 4];
    let mut cases = 0;
    let reference = |case: &str| -> [f64; 4] {
        let line = ORACLE
            .lines()
            .find(|line| line.starts_with(&format!("{case},")))
            .expect("in the oracle");
        let cells: Vec<&str> = line.split(',').collect();
        [2, 4, 6, 8].map(|i| hex(cells[i]))
    };
    let ranges = ["boom", "rocker"].map(|drive| {
        let (low, high) = (
            reference(&format!("{drive}_low_1e-1")),
            reference(&format!("{drive}_high_1e-1")),
        );
        [0, 1, 2, 3].map(|i| (high[i] - low[i]).abs())
    });
    for line in ORACLE.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let driven = if cells[0].starts_with("rocker") {
            Driven::Rocker
        } else {
            Driven::Boom
        };
        let range = &ranges[usize::from(driven == Driven::Rocker)];
        let g = common::geometry(driven);
        let p = Position::new(&g, hex(cells[1])).unwrap_or_else(|| panic!("{} closes", cells[0]));
        let v = Velocity::new(&p);
        let values = [p.follower_angle(), p.a.y, LoadMoment::new(&v, None, &160e3).m_q, v.da.x];
        for (i, value) in values.into_iter().enumerate() {
            let (high, low) = (hex(cells[2 + 2 * i]), hex(cells[3 + 2 * i]));
            let error = ((value - high) - low).abs();
            let (measure, limit) = match i {
                0 => (error / ulp(high), 4.0),
                _ => (error / range[i].max(high.abs()), 1e-14),
            };
            assert!(
                measure <= limit,
                "{} quantity {i}: {value} against {high}, {measure:e}",
                cells[0]
            );
            worst[i] = worst[i].max(measure);
        }
        cases += 1;
    }
    assert_eq!(cases, 69);
    println!(
        "{cases} positions; angle {:.2} ulp, Y_A {:.1e}, M_Q {:.1e}, V_AX {:.1e}",
        worst[0], worst[1], worst[2], worst[3]
    );
}

/// Nothing is NaN anywhere, up to and over the ends of assembly, in the last bits too.
#[test]
fn no_nan_around_the_ends() {
    for driven in [Driven::Boom, Driven::Rocker] {
        let g = common::geometry(driven);
        for arc in g.linkage.arcs() {
            for end in [arc.from, arc.to] {
                for bits in -2000_i64..2000 {
                    let theta = f64::from_bits(end.to_bits().wrapping_add_signed(bits));
                    let Some(p) = Position::new(&g, theta) else { continue };
                    let numbers = [
                        p.a.x,
                        p.a.y,
                        p.b.x,
                        p.b.y,
                        p.c.x,
                        p.c.y,
                        p.r,
                        p.k,
                        p.l(),
                        p.y(),
                        p.mu(),
                        p.alpha(),
                    ];
                    assert!(numbers.iter().all(|x| x.is_finite()), "{theta}: {numbers:?}");
                }
            }
        }
    }
}

/// The instantaneous centre at theta_1 = theta_3 (89.22583°) is flagged, not NaN,
/// and the moment through it has the value of virtual work.
#[test]
fn the_pole_goes_to_infinity_and_the_moment_stays() {
    let g = common::geometry(Driven::Boom);
    let parallel = hex("0x1.8eaa334fdb5bbp+0");
    assert!((parallel.to_degrees() - 89.22583).abs() < 5e-6);
    let mut infinite = 0;
    for bits in -50_i64..=50 {
        let p = Position::new(&g, f64::from_bits(parallel.to_bits().wrapping_add_signed(bits))).expect("closes");
        let v = Velocity::new(&p);
        let pole = Pole::new(&g, &p, &v);
        infinite += i32::from(matches!(pole, Pole::AtInfinity(_)));
        let (by_pole, by_work) = (pole.moment(&g, &p, &v, 160e3), LoadMoment::new(&v, None, &160e3).m_q);
        assert!((by_pole - by_work).abs() <= 1e-12 * 254e3, "{by_pole} {by_work}");
    }
    assert!(infinite > 0);
}
