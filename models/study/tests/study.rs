//! Rows of studies: those of the scenes that they are, the same on any threads, in their order, none left out.

use std::convert::Infallible;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use lemnis_models::component::running::Running;
use lemnis_models::kernel::shared::Watch;
use lemnis_models::scene::Scene;
use lemnis_study::rows::{Plan, Row};
use lemnis_study::run::run;
use lemnis_study::summary::Gathered;

const PORTAL: &str = include_str!("../../scenes/portal_004_study.toml");
const ROPE: &str = include_str!("../../scenes/rope_luffing.toml");

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"))
}

/// The scene with another study.
fn studied(text: &str, study: &str) -> Scene {
    let (text, _) = text.split_once("\n[study]").unwrap_or((text, ""));
    scene(&format!("{text}\n[study]\n{study}"))
}

fn rows(plan: &Plan<'_>, threads: usize) -> Vec<Row> {
    let mut all = Vec::new();
    let watch = Watch {
        stop: &AtomicBool::new(false),
        run: &|| (),
    };
    let Ok(()) = run(plan, 0..plan.designs.count(), threads, watch, |row| {
        all.push(row);
        Ok::<(), Infallible>(())
    });
    all
}

fn plan(scene: &Scene) -> Plan<'_> {
    Plan::new(scene, scene.study.as_ref().expect("a study"))
}

/// Each number of a row is that of the sheet of the scene with these values, to the last bit; so is every requirement.
#[test]
fn a_row_is_what_the_sheet_of_its_scene_says() {
    let scene = scene(PORTAL);
    let plan = plan(&scene);
    for design in [0, 1, 17, 300, 511] {
        let text = plan.study.replaced(PORTAL, &plan.designs.values(design));
        let one = Scene::parse(&text).expect("a scene");
        let (sheet, mut model) = (one.sheet(), one.mechanism.standing());
        let found = plan.row(design).found.expect("a design that exists");
        for (output, value) in plan.study.outputs.iter().zip(&found.outputs) {
            let expected = match output.at {
                None => {
                    sheet
                        .results()
                        .find(|result| result.symbol == output.of.0)
                        .expect("there")
                        .value
                }
                Some(at) => {
                    model.set(0, at).expect("a position");
                    let index = model
                        .variables()
                        .iter()
                        .position(|variable| variable.quantity() == output.of);
                    model.get(index.expect("a result")).expect("exists")
                }
            };
            assert_eq!(value.to_bits(), expected.to_bits(), "design {design}: {}", output.name);
        }
        let fails: Vec<bool> = sheet.requirements.iter().map(|check| !check.passed()).collect();
        assert_eq!(found.fails, fails, "design {design}");
    }
}

/// As many threads as one likes, and the parts of a run that was broken off, give the same rows.
#[test]
fn rows_do_not_depend_on_threads_nor_on_breaks() {
    let scene = scene(&PORTAL.replace("n       = 512", "n       = 200"));
    let plan = plan(&scene);
    let one = rows(&plan, 1);
    assert_eq!(one.len(), 200);
    assert!((0..).zip(&one).all(|(design, row): (usize, &Row)| row.design == design));
    assert_eq!(one, rows(&plan, 3));
    let (stop, done) = (AtomicBool::new(false), AtomicUsize::new(0));
    let mut broken = Vec::new();
    let watch = Watch {
        stop: &stop,
        run: &|| {
            if done.fetch_add(1, Ordering::Relaxed) == 1 {
                stop.store(true, Ordering::Relaxed);
            }
        },
    };
    let Ok(()) = run(&plan, 0..200, 2, watch, |row| {
        broken.push(row);
        Ok::<(), Infallible>(())
    });
    assert!(!broken.is_empty() && broken.len() < 200, "{}", broken.len());
    assert_eq!(broken, one[..broken.len()]);
    stop.store(false, Ordering::Relaxed);
    let Ok(()) = run(&plan, broken.len()..200, 2, watch, |row| {
        broken.push(row);
        Ok::<(), Infallible>(())
    });
    assert_eq!(broken[..one.len().min(broken.len())], one[..broken.len()]);
}

/// The last quantity changes fastest, weights may be masses, and what stands at the top of a scene is a quantity too.
#[test]
fn every_combination_is_a_design() {
    let scene = studied(
        ROPE,
        "outputs = [\"R_max\"]\n[study.vary]\n\"luffing.Q\" = \"8 t or 10 t\"\n\"luffing.tackle.m_l\" = \"6, 7 or 8\"\n",
    );
    let plan = plan(&scene);
    let values: Vec<Vec<f64>> = (0..plan.designs.count())
        .map(|design| plan.designs.values(design))
        .collect();
    let tonnes = 1e3 * scene.gravity;
    let expected = [
        (8.0, 6.0),
        (8.0, 7.0),
        (8.0, 8.0),
        (10.0, 6.0),
        (10.0, 7.0),
        (10.0, 8.0),
    ];
    assert_eq!(values, expected.map(|(load, parts)| vec![load * tonnes, parts]));
}

/// A design that cannot be is a row with the words that the reader of scenes has for it.
#[test]
fn what_cannot_be_is_a_row_with_its_reason() {
    let scene = studied(
        &PORTAL[..PORTAL.find("[study]").expect("there")],
        &format!(
            "outputs = [\"dM_max\"]\nn = 64\nvary = {{ \"luffing.balance.l_1\" = \"± 40 %\" }}\n{}",
            &PORTAL[PORTAL.find("[luffing]").expect("there")..]
        ),
    );
    let plan = plan(&scene);
    let mut gathered = Gathered::new(&plan);
    let mut refused = 0;
    for row in rows(&plan, 2) {
        gathered.take(&row);
        let text = plan.study.replaced(scene.text(), &plan.designs.values(row.design));
        match (Scene::parse(&text), row.found) {
            (Ok(_), Ok(found)) => assert!(found.outputs[0].is_finite()),
            (Err(mistakes), Err(reason)) => {
                assert_eq!(reason, mistakes[0].message);
                refused += 1;
            }
            (read, found) => panic!("design {}: {:?} and {found:?}", row.design, read.is_ok()),
        }
    }
    assert!(0 < refused && refused < 64, "{refused}");
    assert_eq!((gathered.rows(), gathered.refused()), (64, refused));
    let (most, first) = gathered.reason().expect("some are refused");
    assert!(most <= refused && first.contains("the balance linkage"), "{first}");
}

/// Of what is nearly straight over the spread both derivatives agree: the greatest force in the rod, by each dimension.
#[test]
fn the_sampled_line_has_the_slope_of_the_exact_derivative() {
    let scene = studied(
        ROPE,
        "outputs = [\"T_max\", \"R at phi = 50 deg\"]\nn = 256\n[study.vary]\n\"luffing.Q\" = \"± 0.1 %\"\n\"luffing.l\" = \"normal, sd 1 mm\"\n\
         \"luffing.tackle.E_y\" = \"triangular 12.99 m to 13.02 m\"\n",
    );
    let plan = plan(&scene);
    let mut gathered = Gathered::new(&plan);
    rows(&plan, 2).iter().for_each(|row| gathered.take(row));
    for (varied, effects) in plan.study.varied.iter().zip(gathered.effects(&plan)) {
        for (output, effect) in plan.study.outputs.iter().zip(effects) {
            let (exact, sampled) = (effect.exact.expect("by itself"), effect.sampled.expect("many"));
            let spread = gathered.spread(usize::from(output.at.is_some())).expect("exist");
            let off = (exact - sampled).abs() / (spread.p95 - spread.p5);
            assert!(off < 0.01, "{} by {}: {exact} and {sampled}", output.name, varied.key);
        }
    }
}
