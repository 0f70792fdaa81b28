//! A hopper on the portal of a crane: as one more body of the portal, and judged over what lies in it.

#[path = "common/named.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod named;

use lemnis_models::component::sheet::Summary;
use lemnis_models::scene::Scene;

use named::{get, model, near, set};

const READY: &str = include_str!("../scenes/portal_corner_loads.toml");
const FULL: f64 = 400e3;

/// The ready crane with one table more.
fn with(table: &str) -> String {
    READY.replacen("[supports.wind]", &format!("{table}\n[supports.wind]"), 1)
}

/// With a hopper at a place (m), in which so much lies (N).
fn hopper([x, y]: [f64; 2], lies: f64) -> String {
    with(&format!(
        "[supports.hopper]\nG_h0 = \"120 kN\"\nx_h = \"{x} m\"\ny_h = \"{y} m\"\nQ_h = {{ input = \"{lies} N\" }}\n\
         Q_hf = \"{FULL} N\"\n"
    ))
}

/// With one more body of the portal, of the weight of hopper and contents.
fn body([x, y]: [f64; 2], lies: f64) -> String {
    let weight = 120e3 + lies;
    with(&format!(
        "[[supports.portal]]\nG_p = \"{weight} N\"\nx_p = \"{x} m\"\ny_p = \"{y} m\"\n"
    ))
}

fn governing(text: &str) -> Vec<Summary> {
    let scene = Scene::parse(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    scene.sheet_at_rest().governing
}

fn one<'a>(of: &'a [Summary], name: &str) -> &'a Summary {
    let found = of.iter().find(|summary| summary.symbol.id == name);
    found.unwrap_or_else(|| panic!("{name}"))
}

#[test]
fn it_is_one_more_body() {
    let place = [3.5, -2.0];
    let mut crane = model(&hopper(place, 0.0));
    for lies in [0.0, 137e3, FULL] {
        let mut other = model(&body(place, lies));
        set(&mut crane, "Q_h", lies);
        near(get(&mut crane, "V_h"), 120e3 + lies, 1e-9);
        near(get(&mut crane, "u_h"), lies / FULL, 1e-15);
        for psi in [0.0, 1.1, 2.9, 4.6] {
            set(&mut crane, "psi", psi);
            set(&mut other, "psi", psi);
            let names: Vec<String> = other
                .variables()
                .iter()
                .map(|variable| variable.name().to_string())
                .collect();
            let results = names.iter().filter(|name| {
                let kinds = ["N", "F_w", "H", "K", "M_", "V"];
                kinds.iter().any(|kind| name.starts_with(kind)) && !name.contains("p[")
            });
            for name in results {
                let [found, wanted] = [&mut crane, &mut other].map(|model| get(model, name));
                assert!(
                    found == wanted || (found - wanted).abs() <= 1e-12 * wanted.abs().max(1e3),
                    "{name}: {found} is not {wanted}"
                );
            }
        }
    }
}

/// Corner loads on four legs are linear in what lies there: the most is at one of its ends, found from any of them.
#[test]
fn it_is_judged_over_its_fill() {
    for place in [[3.5, -2.0], [0.0, 0.0], [-4.0, 4.5]] {
        let found = governing(&hopper(place, 150e3));
        let ends = [0.0, FULL].map(|lies| governing(&body(place, lies)));
        for (name, sign) in [("N_r_max", 1.0), ("N_4_min", -1.0), ("F_w_max", 1.0), ("N_h_max", 1.0)] {
            let at = ends.each_ref().map(|end| sign * one(end, name).value);
            let most = at[0].max(at[1]);
            let own = one(&found, name);
            near(sign * own.value, most, 1e-10 * most.abs());
            let (symbol, lies) = own.aside.expect("judged over the fill");
            assert_eq!(symbol.id, "Q_h");
            near(lies, if at[1] > at[0] { FULL } else { 0.0 }, 1e-9 * FULL);
        }
    }
}

/// More than it holds is refused.
#[test]
fn it_holds_no_more() {
    let mistakes = Scene::parse(&hopper([0.0, 0.0], 1.5 * FULL)).expect_err("too full");
    let said = format!("{mistakes:?}");
    assert!(
        said.contains("Q_h = 600 kN lies in a hopper that is full with Q_hf = 400 kN"),
        "{said}"
    );
}
