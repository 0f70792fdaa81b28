//! Luffing systems, and what their drives must overcome.

use std::hint::black_box;

use lemnis_models::scene::Scene;

use crate::{nanoseconds, row};

pub fn rows() {
    curved_trunk();
    resistances();
}

/// The ready scene of the curved trunk, its tail as an arc, as the FMU asks for it.
fn curved_trunk() {
    let scene =
        Scene::parse(include_str!("../../models/scenes/curved_trunk.toml")).expect("a ready-made scene is valid");
    let mut model = scene.model().expect("a mechanism");
    let kinematics = [
        "B.x", "B.y", "A.x", "A.y", "T.x", "T.y", "R", "w", "f", "h_t", "i_2", "V_AX", "V_AY",
    ];
    let forces = [
        "mu", "M_Q", "M_Q.P", "M_G", "M_D", "N_t", "F_B.x", "F_B.y", "F_O1.x", "F_O1.y", "q_t", "p_t",
    ];
    let mut index = |id: &str| {
        let found = model.variables().iter().position(|v| v.symbol.id == id).expect("there");
        model.get(found).map(|_| found).expect("closes")
    };
    let (kinematics, forces) = (kinematics.map(&mut index), forces.map(&mut index));
    let mut time = |indices: &[usize]| {
        nanoseconds(|angle| {
            // Within the working range, 42 to 80 deg.
            model.set(0, 0.74 + 0.65 * (angle - 1.05)).expect("an angle");
            for &index in indices {
                black_box(model.get(index).expect("closes"));
            }
        })
    };
    row("model: curved trunk, kinematics", time(&kinematics), "ns", 150.0);
    let all: Vec<usize> = kinematics.into_iter().chain(forces).collect();
    row(
        "model: the same, transmission, moments, tie, pins, drive",
        time(&all),
        "ns",
        400.0,
    );
}

/// The crane of 004 with its drive: every moment of every load case at one position, from the mechanism on.
fn resistances() {
    let scene =
        Scene::parse(include_str!("../../models/scenes/portal_004_drive.toml")).expect("a ready-made scene is valid");
    let mut model = scene.model().expect("a mechanism");
    let of_case = |i: &usize| {
        let symbol = model.variables()[*i].symbol;
        symbol.id.starts_with("M_r_") && !symbol.id.ends_with("max")
    };
    let indices: Vec<usize> = (0..model.variables().len()).filter(of_case).collect();
    let cases = model.variables().iter().filter(|v| v.symbol.id == "M_r_sum").count();
    let time = nanoseconds(|angle| {
        // Within the working range, 44 to 82 deg.
        model.set(0, 0.77 + 0.66 * (angle - 1.05)).expect("an angle");
        for &index in &indices {
            black_box(model.get(index).expect("closes"));
        }
    });
    let what = format!("model: all resistances at a position, {cases} load cases");
    row(&what, time, "ns", 1000.0);
}
