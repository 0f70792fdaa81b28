//! A single boom in motion against what is worked out by hand: what its kinds are asked alike.

#![allow(dead_code, reason = "each kind asks what it has")]

use std::sync::Arc;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;
use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::dynamics::{Coordinate, Dynamics};
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::luffing::moving::single::{Heavy, SingleBoom};
use lemnis_models::parts::hoist::Hoist;
use lemnis_models::parts::solver::Gradient;
use lemnis_models::scene::Scene;

pub const G: f64 = 9.81;

/// Balances of every kind that stands in motion, each for a boom that rises from 25 to 72 deg, or for a link that is let down so.
const KINDS: [[&str; 2]; 5] = [
    ["kind = \"tail\"\nG_c = \"20 t\"\nr_c = \"5 m\"\nchi_c = \"3 deg\"\n"; 2],
    [
        "kind = \"parallelogram\"\nG_c = \"20 t\"\nr_c = \"4 m\"\nchi_c = \"-2 deg\"\nr_1 = \"3 m\"\nalpha_K = \"5 deg\"\n\
         d_1 = \"6 m\"\ndelta_1 = \"143 deg\"\n",
        "kind = \"parallelogram\"\nG_c = \"20 t\"\nr_c = \"4 m\"\nchi_c = \"2 deg\"\nr_1 = \"3 m\"\nalpha_K = \"-5 deg\"\n\
         d_1 = \"6 m\"\ndelta_1 = \"-143 deg\"\n",
    ],
    [
        "kind = \"lever\"\nbranch = \"left\"\nd_1 = \"10.358 m\"\ndelta_1 = \"105.11 deg\"\nr_1 = \"1.602 m\"\n\
         alpha_K = \"33.94 deg\"\nl_1 = \"9.058 m\"\nR_1 = \"0.364 m\"\nchi_5 = \"156.81 deg\"\nM_5 = \"984.8 kN.m\"\n\
         s_5 = \"3 m\"\n",
        "kind = \"lever\"\nbranch = \"right\"\nd_1 = \"10.358 m\"\ndelta_1 = \"-105.11 deg\"\nr_1 = \"1.602 m\"\n\
         alpha_K = \"-33.94 deg\"\nl_1 = \"9.058 m\"\nR_1 = \"0.364 m\"\nchi_5 = \"156.81 deg\"\nM_5 = \"984.8 kN.m\"\n\
         s_5 = \"3 m\"\n",
    ],
    [
        "kind = \"straight_rail\"\nG_c = \"15 t\"\nr_1 = \"8 m\"\nalpha_K = \"2 deg\"\nH_x = \"-2 m\"\nH_y = \"11 m\"\n\
         lambda = \"70 deg\"\n",
        "kind = \"straight_rail\"\nG_c = \"15 t\"\nr_1 = \"8 m\"\nalpha_K = \"-2 deg\"\nH_x = \"-2 m\"\nH_y = \"11 m\"\n\
         lambda = \"70 deg\"\n",
    ],
    [
        "kind = \"curved_rail\"\nG_c = \"15 t\"\nr_1 = \"9 m\"\nalpha_K = \"10 deg\"\nL_r = \"14 m\"\ny_0 = \"10 m\"\n\
         phi_0 = \"60 deg\"\n",
        // Its rope would have to push the link.
        "",
    ],
];

/// A ready scene with each balance, at its boom or at its link, without limits.
pub fn balanced(text: &str, link: bool) -> Vec<String> {
    let limits = text.find("[luffing.limits]").expect("there");
    let start = text.find("[luffing.balance]").unwrap_or(limits);
    let kinds = KINDS.iter().map(|kinds| kinds[usize::from(link)]);
    kinds
        .filter(|kind| !kind.is_empty())
        .map(|kind| format!("{}[luffing.balance]\n{kind}\n[luffing.limits]\n", &text[..start]))
        .collect()
}

/// A load of a mass (kg) on its rope of a length (m) under a hoist, or on none.
pub fn crane<B: SingleBoom>(own: &B::Own<f64>, [mass, length]: [f64; 2], hoist: Option<Hoist>) -> Dynamics {
    let fixed = hoist.is_none().then_some(mass);
    let heavy = Heavy::<B, f64>::new(own, &None, fixed, G).expect("no balance");
    let pendulum = hoist.map(|hoist| Pendulum { mass, length, hoist });
    Dynamics::new(Arc::new(heavy), pendulum, G)
}

/// One equation by hand: inertia, half of its change and the moment of the weights.
pub fn moves_by(crane: &Dynamics, [phi, omega, drive]: [f64; 3], [inertia, half_slope, moment]: [f64; 3]) {
    let expected = (drive - moment - half_slope * omega * omega) / inertia;
    let m = Phase {
        theta: phi,
        omega,
        swing: 0.0,
        swing_rate: 0.0,
    };
    let [found, _] = crane.accelerations(&m, drive).expect("exists");
    let size = (drive.abs() + moment.abs() + half_slope.abs() * omega * omega) / inertia;
    assert!((found - expected).abs() <= 1e-12 * size, "{phi}: {found} {expected}");
    let kinetic = crane.energy(&m).expect("exists") - crane.energy(&Phase { omega: 0.0, ..m }).expect("exists");
    let by_hand = 0.5 * inertia * omega * omega;
    let potential = crane.energy(&m).expect("exists").abs();
    assert!(
        (kinetic - by_hand).abs() <= 1e-12 * by_hand + 4.0 * f64::EPSILON * potential,
        "{phi}"
    );
}

/// Two equations by hand, M q″ = f, of boom and rope.
pub fn swings_by(crane: &Dynamics, at: &Phase, drive: f64, m: [[f64; 2]; 2], f: [f64; 2]) {
    let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let expected = [
        (f[0] * m[1][1] - m[0][1] * f[1]) / determinant,
        (m[0][0] * f[1] - m[1][0] * f[0]) / determinant,
    ];
    let found = crane.accelerations(at, drive).expect("exists");
    for (found, expected) in found.into_iter().zip(expected) {
        assert!(
            (found - expected).abs() <= 1e-11 * (1.0 + expected.abs()),
            "{}: {found} {expected}",
            at.theta
        );
    }
}

/// What is asked over dual numbers is the derivative of what is asked over plain ones: at angles (rad), with a height of
/// energy (J), a length (m), and by how many roundings the values themselves may differ.
pub fn slopes_are_derivatives(
    crane: &Dynamics,
    angles: impl Iterator<Item = f64>,
    [energy, length]: [f64; 2],
    roundings: f64,
) {
    for phi in angles {
        let [theta] = Gradient::<1>::states(&[phi]);
        let r = Gradient::reduced(crane, theta).expect("exists");
        let plain = f64::reduced(crane, phi).expect("exists");
        assert!(
            (r.inertia.re / plain.inertia - 1.0).abs() <= roundings * f64::EPSILON,
            "{phi}"
        );
        assert!((r.inertia.by[0] - plain.slope).abs() <= 1e-13 * plain.inertia, "{phi}");
        assert!((r.energy.by[0] - plain.moment).abs() <= 1e-13 * energy, "{phi}");
        if let (Some([lead, _]), Some([_, change])) = (r.lead, plain.lead) {
            assert!((lead.by[0] - change).abs() <= 1e-13 * length, "{phi}");
        }
    }
}

/// A ready scene's model at a level that moves, with the keys of `[luffing.dynamics]`.
pub fn model(text: &str, fidelity: &str, dynamics: &str) -> Model {
    let level = format!("[luffing]\nfidelity = \"{fidelity}\"\n");
    let limits = format!("[luffing.dynamics]\n{dynamics}\n[luffing.limits]");
    let text = text
        .replacen("[luffing]\n", &level, 1)
        .replacen("[luffing.limits]", &limits, 1);
    let scene = Scene::parse(&text).unwrap_or_else(|found| panic!("{found:?}"));
    scene.model().expect("exists")
}

pub fn index(model: &Model, name: &str) -> Option<usize> {
    model.variables().iter().position(|variable| variable.name() == name)
}

pub fn get(model: &mut Model, name: &str) -> f64 {
    let index = index(model, name).unwrap_or_else(|| panic!("no {name}"));
    model.get(index).expect("exists")
}

/// What a brake holds at rest, at whole degrees, is what the drive must give at rest, and all forces are those of the same scene
/// at level `static`: each in motion with that at rest, and how great such things are. Some a scene may not have.
pub fn holds_as_at_rest(
    model: &mut Model,
    text: &str,
    degrees: std::ops::RangeInclusive<i32>,
    pairs: &[([&str; 2], f64)],
) {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
    let mut rest = scene.model().expect("exists");
    let mut held = 0;
    for degree in degrees {
        for model in [&mut *model, &mut rest] {
            let at = index(model, "phi").expect("there");
            model.set(at, f64::from(degree).to_radians()).expect("an angle");
            model.update().expect("exists");
        }
        // A tackle that would have to push lets go.
        if index(&rest, "T").is_some() && get(&mut rest, "T") < 0.0 {
            continue;
        }
        held += 1;
        for &([held, still], size) in pairs {
            if index(&rest, still).is_none() {
                continue;
            }
            let (held, found) = (get(model, held), get(&mut rest, still));
            assert!(
                (held - found).abs() <= 1e-12 * size,
                "{still} at {degree}: {held} {found}"
            );
        }
        assert_eq!(get(model, "der(omega)"), 0.0);
    }
    assert!(held > 30, "{held}");
    if index(model, "S_R").is_some() {
        assert!((get(model, "S_R") / (10e3 * G) - 1.0).abs() < 1e-3);
    }
}

/// Every derivative that the FMU gives of what is asked, against differences of fourth order of the values that it gives,
/// with states and inputs set first: more than `least` of them are not zero.
pub fn derivatives_are_those_of_the_values(mut model: Model, states: &[(&str, f64)], asked: &[&str], least: usize) {
    let roles = [Role::Input, Role::Parameter, Role::Tunable, Role::State];
    for &(name, value) in states {
        if let Some(index) = index(&model, name) {
            model.set(index, value).expect("allowed");
        }
    }
    model.start().expect("exists");
    let names: Vec<(String, Role)> = model
        .variables()
        .iter()
        .map(|v| (v.name().to_string(), v.role))
        .collect();
    let asked: Vec<usize> = (0..names.len())
        .filter(|&i| asked.contains(&names[i].0.as_str()))
        .collect();
    assert!(asked.len() >= 4);
    let mut compared = 0;
    for known in (0..names.len()).filter(|&i| roles.contains(&names[i].1)) {
        let variable = model.variables()[known];
        let x = model.get(known).expect("exists");
        let h = 1e-4 * x.abs().max(1e-2);
        let at = |value: f64| -> Option<Vec<f64>> {
            let mut moved = model.clone();
            moved.set(known, value).ok()?;
            moved.update().ok()?;
            asked.iter().map(|&i| moved.get(i).ok()).collect()
        };
        let Some([a, b, c, d]) = [-2.0, -1.0, 1.0, 2.0]
            .map(|part| at(x + part * h))
            .into_iter()
            .collect::<Option<Vec<_>>>()
            .and_then(|rows| <[Vec<f64>; 4]>::try_from(rows).ok())
        else {
            continue;
        };
        let seed = |(symbol, number)| f64::from((symbol, number) == variable.quantity());
        let mut tangent = model.tangent(&seed);
        for (place, &index) in asked.iter().enumerate() {
            let Ok(found) = model.derivative(&mut tangent, index) else {
                continue;
            };
            let by_values = (a[place] - d[place] + 8.0 * (c[place] - b[place])) / (12.0 * h);
            let size = found.abs() + b[place].abs() / x.abs().max(1e-2);
            assert!(
                (found - by_values).abs() <= 1e-8 * size,
                "{} by {}: {found} {by_values}",
                names[index].0,
                names[known].0
            );
            compared += usize::from(found != 0.0);
        }
    }
    assert!(compared > least, "{compared}");
}
