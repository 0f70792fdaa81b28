//! Scalars, numbers as they are printed, units, the recorder of formulas, and the hull of points. They are tested from
//! outside, so that the models are not compiled a second time for it.

use std::f64::consts::FRAC_PI_2;

use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::number::{Digits, Number, SIGNIFICANT, column, short};
use lemnis_models::kernel::record::{Rec, record};
use lemnis_models::kernel::unit::{DEG_PER_S, KN, KN_M, M, M2, N, PA, find};
use lemnis_models::luffing::double_link::symbols::{THETA_1, X_1};
use lemnis_models::parts::air::A_Q;
use lemnis_models::parts::hull::hull;
use lemnis_models::parts::plane::Point;
use num_dual::{Dual2_64, Dual64};
use twofloat::TwoFloat;

#[test]
fn exact_numbers_are_short_and_others_have_six_digits() {
    for (value, text) in [
        (0.0, "0"),
        (-0.0, "0"),
        (160.0, "160"),
        (19.3, "19.3"),
        (1.354_123_4, "1.3541234"),
        (60.0_f64.to_radians() / (std::f64::consts::PI / 180.0), "60"),
        (std::f64::consts::PI, "3.14159"),
        (-17.300_000_04, "-17.3000"),
        (999_999.712_345_6, "1000000"),
        (6.123e-17, "6.123e-17"),
        (2.0 / 3.0 * 1e-4, "6.66667e-5"),
        (0.001_234_567_89, "0.00123456789"),
        (-1e7, "-1e7"),
        (5e-324, "5e-324"),
        (f64::MAX, "1.79769e308"),
        (f64::NEG_INFINITY, "-infinite"),
        (f64::NAN, "undefined"),
    ] {
        assert_eq!(short(value).to_string(), text);
    }
}

#[test]
fn digits_are_as_many_as_asked_for() {
    for (value, digits, text) in [
        (-0.000_04, Digits::Decimals(4), "0.0000"),
        (-4.2338, Digits::Decimals(3), "-4.234"),
        (1e300, Digits::Decimals(3), "1e300"),
        (1e14, Digits::Decimals(9), "100000000000000"),
        (0.001_234_5, Digits::Significant(3), "0.00123"),
        (47.319_512, Digits::Short(4, 4), "47.32"),
        (19.999_999, Digits::Short(4, 4), "20.00"),
        (20.000_000_000_000_01, Digits::Short(4, 4), "20"),
        (12_345.6, Digits::Short(4, 4), "12346"),
        (-2.127_708_31, Digits::Short(9, 8), "-2.12770831"),
        (-2.127_708_312, Digits::Short(9, 8), "-2.1277083"),
        (9.996, Digits::Significant(3), "10.0"),
        (-98_765.4, Digits::Significant(3), "-98765"),
        (1.0 / 3.0, Digits::All, "0.3333333333333333"),
        (-0.0, Digits::All, "0"),
        (f64::MIN_POSITIVE, Digits::All, "2.2250738585072014e-308"),
    ] {
        assert_eq!(Number::new(value, digits).to_string(), text);
    }
}

#[test]
fn a_number_with_six_digits_is_rounded_and_a_shorter_one_exact() {
    for (value, printed, half) in [
        (2.0 / 3.0, 0.666_667, 5e-7),
        (-2.0 / 3.0 * 1e-4, -6.66667e-5, 5e-11),
        (9_605_594.321_456, 9_605_594.0, 0.5),
        (15.000_000_012, 15.0, 5e-5),
        (19.3, 19.3, 0.0),
        (0.0, 0.0, 0.0),
    ] {
        let number = short(value);
        assert_eq!((number.value(), number.rounding()), (printed, half));
    }
}

#[test]
fn a_column_has_one_number_of_decimals() {
    let texts = |values: &[f64]| -> Vec<String> { column(values, SIGNIFICANT).iter().map(Number::to_string).collect() };
    assert_eq!(texts(&[254.346_5, -3.0, 1.18e-15]), ["254.346", "-3.000", "0.000"]);
    assert_eq!(texts(&[1.0 / 3.0, f64::INFINITY]), ["0.3333", "infinite"]);
    assert_eq!(texts(&[60.0, 60.5]), ["60.0", "60.5"]);
    assert_eq!(texts(&[0.0, -0.0]), ["0", "0"]);
    assert_eq!(texts(&[0.012_345_6, 0.0]), ["0.01235", "0.00000"]);
    assert_eq!(texts(&[1e-9, 2.5e-10]), ["1.00000e-9", "2.50000e-10"]);
    let four = |values: &[f64]| column(values, 4).iter().map(Number::to_string).collect::<Vec<_>>();
    assert_eq!(four(&[254.346_5, -3.0, 1.18e-15]), ["254.3", "-3.0", "0.0"]);
    assert_eq!(four(&[5.123_46, 0.012_345_6]), ["5.123", "0.012"]);
    assert_eq!(four(&[60.0, 62.5]), ["60.0", "62.5"]);
}

proptest::proptest! {
    /// Whatever the number: no sign of zero, few digits, no failure.
    #[test]
    fn every_number_can_be_read(bits: u64, count in 0_usize..400, others: Vec<u64>) {
        let value = f64::from_bits(bits);
        let mut all: Vec<Number> = [Digits::Short(count, count), Digits::Significant(count), Digits::Decimals(count), Digits::All]
            .map(|digits| Number::new(value, digits))
            .into();
        let others: Vec<f64> = others.into_iter().chain([bits]).map(f64::from_bits).collect();
        all.extend(column(&others, count));
        for number in all {
            let text = number.to_string();
            let mantissa = text.split('e').next().unwrap_or_default().trim_start_matches(['-', '0', '.']);
            let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
            proptest::prop_assert!(digits <= 17 && text.len() <= 25, "{text}");
            let zero = text.parse::<f64>().is_ok_and(|value| value == 0.0);
            proptest::prop_assert!(!(zero && text.starts_with('-')), "{text}");
        }
        if let Ok(back) = Number::new(value, Digits::All).to_string().parse::<f64>() {
            proptest::prop_assert_eq!(back, value);
        }
    }
}

#[test]
fn spellings_of_one_unit() {
    for text in ["kN.m", "kN m", "kN·m", "kN*m"] {
        assert_eq!(find(text), Some(&KN_M), "{text}");
    }
    assert_eq!(find("°/s"), Some(&DEG_PER_S));
    assert_eq!(find("furlong"), None);
}

#[test]
fn derived_units_follow_from_base_units() {
    assert_eq!(KN.dimension.times(M.dimension), KN_M.dimension);
    assert_eq!(N.dimension.over(M2.dimension), PA.dimension);
    assert_eq!(M2.dimension.root(), Some(M.dimension));
    assert_eq!(M.dimension.root(), None);
}

#[test]
fn a_sound_formula_leaves_a_step_and_no_fault() {
    let (trace, ()) = record(|| {
        let l = Rec::given(&X_1, 3.0);
        let _ = (l.square() * Rec::given(&THETA_1, 0.5).sin()).def(&A_Q);
    });
    assert!(trace.faults.is_empty(), "{:?}", trace.faults);
    assert_eq!(trace.steps.len(), 1);
    assert_eq!(trace.steps[0].value, 9.0 * Calc::sin(0.5_f64));
}

/// The planted mistakes: metre plus radian, sine of a length, roots of a
/// length, and an area that is called a length.
#[test]
fn planted_mistakes_are_caught() {
    type Mistake = fn(Rec, Rec) -> Rec;
    let mistakes: [(&str, Mistake); 5] = [
        ("Add of m and 1", |l, a| l + a),
        ("Sin of m", |l, _| l.sin()),
        ("X_1 is in m, its formula in the root of m", |l, _| l.sqrt().def(&X_1)),
        ("square root of the root of m", |l, _| l.sqrt().sqrt()),
        ("X_1 is in m, its formula in m^2", |l, _| (l * l).def(&X_1)),
    ];
    for (text, mistake) in mistakes {
        let (trace, _) = record(|| mistake(Rec::given(&X_1, 2.0), Rec::given(&THETA_1, 1.0)));
        assert_eq!(trace.faults.len(), 1, "{text}");
        assert!(trace.faults[0].starts_with(text), "{} / {text}", trace.faults[0]);
    }
}

/// What the ninth power, in twice the precision, is off by: a ninth of that is the root's own error. A factor of 2⁹ is one
/// of 2, exactly.
#[test]
fn ninth_roots_are_known_to_the_last_bit() {
    const NINTH: [u8; 2] = [1, 9];
    for exponent in -300..300 {
        for part in 0..50 {
            let x = (1.0 + 0.18 * f64::from(part)) * format!("1e{exponent}").parse::<f64>().unwrap();
            let root = TwoFloat::from(x.power(NINTH));
            let ninth = (0..8).fold(root, |power, _| power * root);
            let off = f64::from(ninth - x) / (9.0 * x);
            assert!(off.abs() <= f64::EPSILON, "of {x:e} by {off:e}");
            assert_eq!((512.0 * x).power(NINTH), 2.0 * x.power(NINTH), "of {x:e}");
        }
    }
    assert_eq!([0.0, 1.0, 512.0].map(|x| x.power(NINTH)), [0.0, 1.0, 2.0]);
    assert!((1e-310_f64.power(NINTH) / libm::pow(10.0, -310.0 / 9.0) - 1.0).abs() < 1e-14);
}

#[test]
fn directions_are_continuous_through_the_upright_and_the_rear() {
    let up = f64::direction(0.0, 1.0);
    let rear = f64::direction(-1.0, -1e-9);
    let front_low = f64::direction(1.0, -1e-9);
    assert_eq!(up, FRAC_PI_2);
    assert!((rear - std::f64::consts::PI).abs() < 1e-8);
    assert!(front_low < 0.0 && front_low > -1e-8);
    assert_eq!(f64::direction(0.0, -1.0), 1.5 * std::f64::consts::PI);
}

/// Every derivative rule against a central difference, whose error is of
/// the order of step² (1e-12) plus rounding over step (1e-10).
#[test]
fn dual_rules_agree_with_differences() {
    type Rule = fn(Dual64) -> Dual64;
    let rules: [(&str, Rule); 7] = [
        ("sqrt", |x| Calc::sqrt(x)),
        ("power", |x| x.power([10, 9])),
        ("sin", |x| Calc::sin(x)),
        ("cos", |x| Calc::sin_cos(x).1),
        ("asin", |x| Calc::asin(x)),
        ("acos", |x| Calc::acos(x)),
        ("direction", |x| Dual64::direction(x * x, x)),
    ];
    let step = 1e-6;
    for (name, rule) in rules {
        for at in [0.1, 0.5, 0.9] {
            let difference = (rule(Dual64::from_re(at + step)).re - rule(Dual64::from_re(at - step)).re) / (2.0 * step);
            let exact = rule(Dual64::new(at, 1.0)).eps;
            assert!(
                (exact - difference).abs() < 1e-9,
                "{name} at {at}: {exact} {difference}"
            );
        }
    }
}

/// Second derivatives against central differences of the first, which are exact.
#[test]
fn second_derivatives_agree_with_differences_of_the_first() {
    type Rules = (&'static str, fn(Dual64) -> Dual64, fn(Dual2_64) -> Dual2_64);
    let rules: [Rules; 7] = [
        ("sqrt", |x| Calc::sqrt(x), |x| Calc::sqrt(x)),
        ("power", |x| x.power([1, 3]), |x| x.power([1, 3])),
        ("sin", |x| Calc::sin(x), |x| Calc::sin(x)),
        ("cos", |x| Calc::sin_cos(x).1, |x| Calc::sin_cos(x).1),
        ("asin", |x| Calc::asin(x), |x| Calc::asin(x)),
        ("acos", |x| Calc::acos(x), |x| Calc::acos(x)),
        (
            "direction",
            |x| Dual64::direction(x * x, x),
            |x| Dual2_64::direction(x * x, x),
        ),
    ];
    let step = 1e-6;
    for (name, first, second) in rules {
        for at in [0.1, 0.5, 0.9] {
            let slope = |x: f64| first(Dual64::new(x, 1.0)).eps;
            let difference = (slope(at + step) - slope(at - step)) / (2.0 * step);
            let exact = second(Dual2_64::new(at, 1.0, 0.0));
            assert_eq!(
                (exact.re, exact.v1),
                (first(Dual64::new(at, 1.0)).re, slope(at)),
                "{name} at {at}"
            );
            assert!(
                (exact.v2 - difference).abs() < 1e-8 * (1.0 + difference.abs()),
                "{name} at {at}: {} {difference}",
                exact.v2
            );
        }
    }
}

#[test]
fn points_within_and_on_sides_are_no_corners() {
    let at = |x: f64, y: f64| Point::new(x, y);
    let points = [
        at(2.0, 1.0),
        at(-2.0, 1.0),
        at(0.0, 0.0),
        at(2.0, -1.0),
        at(0.0, 1.0),
        at(-2.0, -1.0),
    ];
    assert_eq!(hull(&points), Some(vec![5, 3, 0, 1]));
    assert_eq!(hull(&points[2..3]), None);
    assert_eq!(hull(&[at(0.0, 0.0), at(1.0, 1.0), at(2.0, 2.0 + 1e-13)]), None);
    assert_eq!(hull(&[at(0.0, 0.0); 4]), None);
}
