//! Governing positions and sensitivities, against searches and differences that know nothing of derivatives.

use std::f64::consts::FRAC_PI_2;

use num_dual::{Dual64, DualNum};

use lemnis_models::component::description::Described;
use lemnis_models::component::extreme::{Extreme, greatest};
use lemnis_models::component::governing::governing;
use lemnis_models::component::outline::Outline;
use lemnis_models::component::running::Running;
use lemnis_models::component::sensitivity::sensitivity;
use lemnis_models::luffing::double_link::scene::{Luffing, LuffingScene};
use lemnis_models::luffing::double_link::symbols as s;

use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::variable::Variable;
use lemnis_models::parts::motion::Motion;
use lemnis_models::scene::{DEFAULT, Scene};

const OUTLINE: &Outline = LuffingScene::OUTLINE;

/// The luffing mechanism of a scene's text.
fn luffing(text: &str) -> Luffing {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
    scene.mechanism.of::<Luffing>().expect("a luffing mechanism").clone()
}

/// Value of a checked or governing result, searched anew.
fn result(luffing: &Luffing, symbol: &'static Symbol) -> f64 {
    let mut model = luffing.standing();
    if symbol == &s::EPSILON_Y {
        let index = model.variables().iter().position(|variable| variable.symbol == symbol);
        return model.get(index.expect("a variable")).expect("closes");
    }
    let found = governing(&model, OUTLINE, &|_| true)
        .into_iter()
        .find(|g| g.symbol == symbol);
    found.expect("a governing result").value
}

/// The scene with one quantity moved.
fn moved(luffing: &Luffing, symbol: &'static Symbol, by: f64) -> Luffing {
    let change = |known: &'static Symbol, value| if known == symbol { value + by } else { value };
    let mut moved = luffing.clone();
    moved.parameters = luffing.parameters.map(&mut change.clone());
    moved.driving.mount = luffing.driving.mount.map(|mount| mount.map(&mut change.clone()));
    moved.q = luffing.q.map(|q| change(&s::Q, q));
    moved
}

/// Every derivative against a central difference of order six, in which the
/// governing position is searched anew for each of the six values. Its error is
/// of the order of the relative step to the sixth power, 1e-24, and of the
/// rounding over the step, 1e-12 of the heights that are subtracted. (A step ten times greater moves the
/// greatest luffing moment from one end of the range to the other.)
#[test]
fn sensitivities_agree_with_differences() {
    let portal = include_str!("../scenes/portal_004.toml");
    let axis = DEFAULT.replace("X_7 = \"1.354 m\"", "AC = \"22.3 m\"");
    let (mut compared, mut worst) = (0, 0.0_f64);
    for text in [DEFAULT, portal, &axis] {
        let luffing = luffing(text);
        let (mut model, outline) = (luffing.standing(), OUTLINE);
        let found = governing(&model, outline, &|_| true);
        let table = sensitivity(&mut model, outline, outline.sensitivity, &found, &|_| true);
        for row in &table.rows {
            for (&(symbol, value), exact) in table.results.iter().zip(&row.by) {
                let step = 1e-4 * row.value.abs().max(0.1);
                let at = |n: f64| result(&moved(&luffing, row.symbol, n * step), symbol);
                let difference = |n: f64| at(n) - at(-n);
                let estimate = (45.0 * difference(1.0) - 9.0 * difference(2.0) + difference(3.0)) / (60.0 * step);
                let scale = exact.abs().max(value.abs() / row.value.abs().max(0.1));
                let error = (estimate - exact).abs() / scale;
                assert!(
                    error < 1e-9,
                    "d{}/d{}: {exact} against {estimate}",
                    symbol.id,
                    row.symbol.id
                );
                worst = worst.max(error);
                compared += 1;
            }
        }
    }
    assert!(compared > 200, "{compared}");
    println!("{compared} sensitivities, largest relative deviation {worst:.1e}");
}

/// No position of a grid a hundred times finer has a greater value, and beside
/// an extreme inside the range the values fall off on both sides.
#[test]
fn governing_positions_are_the_extremes() {
    let scene = Scene::parse(DEFAULT).expect("valid");
    let luffing = scene.mechanism.of::<Luffing>().expect("a luffing mechanism");
    let motion = luffing.motion;
    let mut model = scene.model().expect("a mechanism");
    let list = governing(&luffing.standing(), OUTLINE, &|_| true);
    assert_eq!(list.len(), 8);
    let mut inside = 0;
    for found in list {
        let (output, least) = match found.symbol.id {
            "R_max" => ("R", false),
            "R_min" => ("R", true),
            "mu_min" => ("mu", true),
            id => (id.strip_suffix("_max").expect("greatest"), false),
        };
        let index = model
            .variables()
            .iter()
            .position(|v| v.symbol.id == output)
            .expect(output);
        let mut size = |theta: f64| {
            model.set(0, theta).expect("an angle");
            let value = model.get(index).expect("closes");
            if least { -value } else { value.abs() }
        };
        let theta = found.at.expect("a position").1;
        let most = size(theta);
        let value = if least { -found.value } else { found.value.abs() };
        assert!((most - value).abs() <= 1e-14 * most.abs(), "{output}: {most} {value}");
        for i in 0..=9600 {
            let other = size(motion.from + (motion.to - motion.from) * f64::from(i) / 9600.0);
            assert!(other <= most + 1e-14 * most.abs(), "{output}: {other} above {most}");
        }
        if theta > motion.from && theta < motion.to {
            inside += 1;
            for side in [-1e-4, 1e-4] {
                assert!(size(theta + side) < most, "{output} beside {theta}");
            }
        }
    }
    assert!(inside >= 1, "{inside}");
}

/// A drive that passes the line through the foot of its bar can give no moment there.
#[test]
fn a_drive_through_the_foot_has_no_greatest_force() {
    let text = DEFAULT.replace("E_x   = \"3 m\"", "E_x   = \"0.1 m\"");
    let luffing = luffing(&text);
    let list = governing(&luffing.standing(), OUTLINE, &|_| true);
    let force = list.iter().find(|g| g.symbol == &s::F_D_MAX).expect("a drive");
    assert!(force.value.is_infinite());
    // The anchor on the boom, 5° below it, stands on the far side of O1 from E.
    let (_, theta) = force.at.expect("a position");
    let line = <f64 as lemnis_models::kernel::calc::Calc>::direction(-0.1, 1.5);
    let line = f64::to_degrees(line);
    assert!((theta.to_degrees() - 5.0 - line).abs() < 1e-9, "{}", theta.to_degrees());
}

/// The same drive, of which no force is asked: neither load nor weights.
#[test]
fn a_drive_through_the_foot_that_moves_nothing_needs_no_force() {
    let weights = DEFAULT.find("[luffing.weights]").expect("a table of the default scene");
    let drive = DEFAULT.find("[luffing.drive]").expect("a table of the default scene");
    let text = [&DEFAULT[..weights], &DEFAULT[drive..]].concat();
    let text = text.replace("E_x   = \"3 m\"", "E_x   = \"0 m\"");
    let text = text.replace("E_y   = \"-1.5 m\"", "E_y   = \"2 m\"");
    for (load, greatest) in [("0 kN", 0.0), ("160 kN", f64::INFINITY)] {
        let text = text.replace("Q = \"160 kN\"", &format!("Q = \"{load}\""));
        let mechanism = luffing(&text);
        assert_eq!(result(&mechanism, &s::F_D_MAX).abs(), greatest, "{load}");
        let mut model = Scene::parse(&text).expect("valid").model().expect("a mechanism");
        let index = model.variables().iter().position(|v| v.symbol == &s::F_D);
        for degrees in [94.0_f64, 95.0, 96.0] {
            model.set(0, degrees.to_radians()).expect("an angle");
            let force = model.get(index.expect("a drive")).expect("closes");
            assert_eq!(force == 0.0, greatest == 0.0, "{load} at {degrees} deg: {force}");
            assert_eq!(force.is_infinite(), greatest > 0.0 && degrees == 95.0);
        }
    }
}

/// No place of a fine grid has more, or less, than the curve that the book draws: its marked extremes are exact.
#[test]
fn a_drawn_curve_reaches_its_extremes() {
    let scenes = [
        DEFAULT,
        include_str!("../scenes/portal_004_new.toml"),
        include_str!("../scenes/ports_001.toml"),
        include_str!("../scenes/boat_hoist_003.toml"),
        include_str!("../scenes/rope_luffing.toml"),
        include_str!("../scenes/ellipsograph.toml"),
        include_str!("../scenes/curved_trunk.toml"),
    ];
    let mut looked = 0;
    for text in scenes {
        let scene = Scene::parse(text).expect("valid");
        let (sheet, motion) = (scene.sheet(), *scene.mechanism.motion());
        let mut model = scene.model().expect("a mechanism");
        let balance = sheet.balance.iter().flat_map(|balance| &balance.curves);
        for curve in sheet.curves.iter().chain(balance) {
            let index = model.variables().iter().position(|v| v.symbol == curve.y);
            let whole = curve.x == model.variables()[0].symbol && curve.pieces.len() == 1;
            let Some(index) = index.filter(|_| whole) else { continue };
            let drawn = curve.pieces[0].iter().map(|point| point[1]);
            let [least, most] = drawn.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], y| {
                [least.min(y), most.max(y)]
            });
            let rounding = 1e-13 * least.abs().max(most.abs());
            for i in 0..=10_000 {
                let theta = motion.from + (motion.to - motion.from) * f64::from(i) / 1e4;
                model.set(0, theta).expect("an angle");
                let value = model.get(index).expect("closes");
                let within = (least - rounding..=most + rounding).contains(&value);
                assert!(within, "{}: {} = {value}", scene.name(), curve.y.id);
            }
            looked += 1;
            // Where rod and lever stand at a right angle the angle is 90°, between all samples.
            if curve.id == "balance_gamma" {
                assert!((most - FRAC_PI_2).abs() < 1e-7, "{}: {most}", scene.name());
            }
        }
    }
    assert!(looked > 20, "{looked}");
}

/// The greatest value between 0 and `to` with its place, and how often the quantity was asked for.
fn counted(to: f64, f: &dyn Fn(Dual64) -> Dual64) -> (Extreme, u32) {
    let (motion, mut asked) = (
        Motion {
            from: 0.0,
            to,
            step: 0.1,
            speed: 1.0,
            by_part: false,
            period: std::f64::consts::TAU,
        },
        0,
    );
    let found = greatest(&motion, &mut |at| {
        asked += 1;
        Some(f(at))
    });
    (found.expect("it exists"), asked)
}

/// A grid of 97 places, and a dozen more for each peak; none for what is constant.
#[test]
fn a_peak_is_found_in_few_steps() {
    let (found, asked) = counted(3.0, &|at| at.sin());
    assert!((found.at - FRAC_PI_2).abs() <= 2.0 * f64::EPSILON, "{found:?}");
    assert!((found.value - 1.0).abs() <= f64::EPSILON, "{found:?}");
    assert!(asked <= 97 + 12, "{asked}");
    let (found, asked) = counted(3.0, &|at| -(at - 1.0 / 3.0).powi(4) + 2.0);
    assert!((found.value - 2.0).abs() <= f64::EPSILON, "{found:?}");
    assert!(asked <= 97 + 54, "{asked}");
    let (found, asked) = counted(3.0, &|at| at * 2.0);
    assert_eq!((found.at, found.value, asked), (3.0, 6.0, 97));
    let (found, asked) = counted(3.0, &|_| Dual64::from_re(0.7));
    assert_eq!((found.value, asked), (0.7, 97));
    // A corner has slopes to both sides, of which no secant tells.
    let (found, asked) = counted(3.0, &|at| if at.re < 1.0 / 3.0 { at } else { -at + 2.0 / 3.0 });
    assert!((found.at - 1.0 / 3.0).abs() <= f64::EPSILON, "{found:?}");
    assert!(asked <= 97 + 56, "{asked}");
}

/// Of a result that is numbered the derivative is that of the number which governs: of a corner, of a load case. Against central
/// differences of order six with the governing position searched anew, as above.
#[test]
fn sensitivities_are_those_of_the_number_that_governs() {
    let scenes = [
        include_str!("../scenes/portal_corner_loads.toml"),
        include_str!("../scenes/portal_004_corners.toml"),
        include_str!("../scenes/portal_004_ring.toml"),
        include_str!("../scenes/slewing_column.toml"),
    ];
    let (mut compared, mut worst) = (0, 0.0_f64);
    for text in scenes {
        let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
        let (mut model, outline) = (scene.mechanism.standing(), scene.mechanism.outline());
        let found = governing(&model, outline, &|_| true);
        let table = sensitivity(&mut model, outline, outline.sensitivity, &found, &|_| true);
        assert!(!table.results.is_empty() && table.rows.len() > 10, "{}", scene.name());
        for row in &table.rows {
            let same = |v: &Variable| v.symbol == row.symbol && v.number == row.number;
            let index = model.variables().iter().position(same).expect("a variable");
            let step = 1e-4 * row.value.abs().max(0.1);
            // A factor of zero has no lesser one.
            if model.set(index, row.value - 3.0 * step).is_err() {
                continue;
            }
            let mut at = |n: f64| {
                model.set(index, row.value + n * step).expect("allowed");
                let found = governing(&model, outline, &|_| true);
                table
                    .results
                    .iter()
                    .map(|(symbol, _)| found.iter().find(|g| g.symbol == *symbol).expect("there").value)
                    .collect::<Vec<_>>()
            };
            let ends = [1.0, -1.0, 2.0, -2.0, 3.0, -3.0].map(&mut at);
            at(0.0);
            for (i, (&(symbol, value), exact)) in table.results.iter().zip(&row.by).enumerate() {
                let [a, b, c] = [0, 2, 4].map(|k| ends[k][i] - ends[k + 1][i]);
                let estimate = (45.0 * a - 9.0 * b + c) / (60.0 * step);
                let scale = exact.abs().max(value.abs() / row.value.abs().max(0.1));
                let error = (estimate - exact).abs() / scale;
                assert!(
                    error < 1e-8,
                    "{}: d{}/d{}{:?}: {exact} against {estimate}",
                    scene.name(),
                    symbol.id,
                    row.symbol.id,
                    row.number
                );
                worst = worst.max(error);
                compared += 1;
            }
        }
    }
    assert!(compared > 150, "{compared}");
    println!("{compared} sensitivities, largest relative deviation {worst:.1e}");
}
