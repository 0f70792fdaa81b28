//! Level `table`: the certified error holds, dimensions are fixed, and what cannot be tabulated is exact.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;
use lemnis_models::scene::Scene;

/// The luffing scenes, with their files' names.
fn scenes() -> Vec<(String, Scene)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("there") {
        let path = entry.expect("readable").path();
        let text = std::fs::read_to_string(&path).expect("text");
        let scene = Scene::parse(&text).unwrap_or_else(|found| panic!("{}: {found:?}", path.display()));
        if scene.mechanism.levels().contains(&"table") {
            found.push((path.file_name().expect("a file").to_string_lossy().into_owned(), scene));
        }
    }
    found.sort_by(|a, b| a.0.cmp(&b.0));
    assert!(found.len() >= 7);
    found
}

fn tabulated(scene: &Scene, tolerance: f64) -> Model {
    let mut scene = scene.at("table");
    scene.mechanism.interpolate(tolerance);
    scene.model().expect("built")
}

/// A million points of every scene, in angle, velocity and load: no result is farther from the closed form than the
/// table certifies, and the certificate keeps to the tolerance asked for.
#[test]
fn the_certified_error_holds() {
    const POINTS: usize = 1_000_000;
    for (name, scene) in scenes() {
        let (mut closed, mut table) = (scene.at("static").model().expect("built"), tabulated(&scene, 1e-6));
        let Model::Standing(inner) = &table else {
            unreachable!("a luffing mechanism")
        };
        let positions = closed.positions();
        let (from, to) = (positions[0], positions[positions.len() - 1]);
        let has_load = closed.variables()[2].symbol.id == "Q";
        let outputs: Vec<usize> = (0..closed.variables().len())
            .filter(|&i| closed.variables()[i].role == Role::Output)
            .collect();
        let table_of = inner.table().expect("tabulated");
        let (bytes, has) = (table_of.bytes(), outputs.iter().filter(|&&i| table_of.has(i)).count());
        println!("{name}: {has} of {} results in {bytes} bytes", outputs.len());
        // A table has what is affine in velocity and load; friction is not.
        let middle = f64::midpoint(from, to);
        let may = outputs.iter().filter(|&&i| is_affine(&mut closed, i, middle, has_load));
        assert!(has * 10 >= may.count() * 7);
        // What is the same everywhere has no error.
        let kept: Vec<usize> = outputs.iter().copied().filter(|&i| inner.bound(i) > 0.0).collect();
        assert!(kept.len() * 2 >= has);
        let mut random = fastrand::Rng::with_seed(7);
        let (mut worst, mut tightest) = (0.0_f64, "");
        // Every point looks at two results.
        for point in 0..POINTS {
            let theta = from + (to - from) * random.f64();
            let omega = 0.2 * (random.f64() - 0.5);
            for model in [&mut closed, &mut table] {
                model.set(0, theta).expect("allowed");
                model.set(1, omega).expect("allowed");
            }
            if has_load {
                let q = 4e5 * random.f64();
                closed.set(2, q).expect("allowed");
                table.set(2, q).expect("allowed");
            }
            for i in [point % kept.len(), (point / 7) % kept.len()].map(|i| kept[i]) {
                let value = closed.get(i).expect("closes");
                let off = (value - table.get(i).expect("inside")).abs();
                let Model::Standing(inner) = &table else {
                    unreachable!("a luffing mechanism")
                };
                let part = off / inner.bound(i);
                // What the pieces give exactly, as the angles of a parallelogram, has rounding alone for a bound, and uses it.
                if part > worst && inner.bound(i) > 1e-14 * value.abs() {
                    (worst, tightest) = (part, closed.variables()[i].symbol.id);
                }
                assert!(part <= 1.0, "{name}: {} at {theta}: {off:e}", closed.variables()[i]);
            }
        }
        println!("  worst {worst:.3} of the certified error, in {tightest}");
        // The margin is used in half: it is neither vain nor eaten up.
        assert!(worst > 0.3 && worst < 0.6);
    }
}

/// Whether a result is so at a place, as far as four values tell.
fn is_affine(model: &mut Model, i: usize, place: f64, has_load: bool) -> bool {
    let mut at = |omega: f64, q: f64| {
        model.set(0, place).expect("allowed");
        model.set(1, omega).expect("allowed");
        if has_load {
            model.set(2, q).expect("allowed");
        }
        model.get(i).expect("closes")
    };
    let [none, turning, loaded] = [at(0.0, 0.0), at(0.1, 0.0), at(0.0, 1e5)];
    let both = at(-0.1, 2e5);
    let expected = none - (turning - none) + 2.0 * (loaded - none);
    let size = [none, turning, loaded, both]
        .iter()
        .fold(0.0_f64, |most, x| most.max(x.abs()));
    (both - expected).abs() <= 1e-9 * size
}

/// Tenfold accuracy costs less than twice the pieces: the error falls with the fourth power of their length.
#[test]
fn pieces_grow_with_the_fourth_root() {
    let (_, scene) = scenes()
        .into_iter()
        .find(|(name, _)| name == "lemniscate.toml")
        .expect("there");
    let bytes = |tolerance| match tabulated(&scene, tolerance) {
        Model::Standing(model) => model.table().expect("tabulated").bytes(),
        _ => unreachable!("a luffing mechanism"),
    };
    let (coarse, fine) = (bytes(1e-5) as f64, bytes(1e-9) as f64);
    println!("{coarse} {fine}");
    // Ten to the fourth, over a power of two that the number of pieces is rounded up to.
    assert!((5.0..20.0).contains(&(fine / coarse)));
}

#[test]
fn dimensions_are_fixed() {
    let (_, scene) = scenes()
        .into_iter()
        .find(|(name, _)| name == "lemniscate.toml")
        .expect("there");
    let mut model = tabulated(&scene, 1e-6);
    let boom = model
        .variables()
        .iter()
        .position(|v| v.symbol.id == "X_1")
        .expect("exists");
    let fault = model.set(boom, 20.0).expect_err("fixed");
    assert!(fault.message.contains("X_1 is fixed in the table"), "{}", fault.message);
    assert_eq!(model.get(boom), Ok(19.3));
    // Beyond the table there is nothing.
    model.set(0, 130_f64.to_radians()).expect("an angle");
    let fault = model.update().expect_err("outside");
    assert!(
        fault.outside
            && fault
                .message
                .contains("theta_1 = 130 deg lies outside the table from 60 to 120 deg")
    );
    // Saved and restored.
    model.set(0, 1.3).expect("an angle");
    let (saved, reach) = (
        model.numbers(&model.state()),
        model.variables().iter().position(|v| v.symbol.id == "R"),
    );
    let before = model.get(reach.expect("exists"));
    let state = model.state_of(&saved).expect("its own");
    model.set(0, 1.5).expect("an angle");
    model.set_state(&state);
    assert_eq!(model.get(reach.expect("exists")), before);
}
