//! Single booms that a cylinder with oil luffs: against the same booms at rest, under a moment, and by their energies.

#[path = "common/named.rs"]
mod named;
#[path = "common/single_boom.rs"]
mod single_boom;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;
use lemnis_models::scene::Scene;

use named::{get, index, model, near, set};
use single_boom::derivatives_are_those_of_the_values;

const OIL: &str = include_str!("../../tests/levels/hydraulics.toml");

/// A ready scene in motion, its cylinder, an angle within its range (deg), and forces that stand in no other.
struct Boom {
    scene: &'static str,
    drive: &'static str,
    motor: [&'static str; 2],
    angles: [f64; 2],
    pins: &'static [&'static str],
}

/// The cylinder turns the link of the first against the boom's angle, and the boom of the second.
const BOOMS: [Boom; 2] = [
    Boom {
        scene: include_str!("../scenes/ellipsograph_motion.toml"),
        drive: "E_x = \"5 m\"\nE_y = \"3 m\"\ns_d = \"5 m\"\nchi_d = \"0 deg\"",
        motor: ["M_A = \"250 kN.m\"", "M_S = \"300 kN.m\""],
        angles: [28.0, 68.0],
        pins: &["F_B.x", "F_C.x", "F_C.y", "N_l", "F_O1.x", "F_O1.y"],
    },
    Boom {
        scene: include_str!("../scenes/curved_trunk_motion.toml"),
        drive: "E_x = \"3 m\"\nE_y = \"-1.5 m\"\ns_d = \"6 m\"\nchi_d = \"-5 deg\"",
        motor: ["M_A = \"250 kN.m\"", "M_S = \"400 kN.m\""],
        angles: [45.0, 77.0],
        pins: &["F_B.x", "F_B.y", "N_t", "q_t", "F_O1.x", "F_O1.y"],
    },
];

impl Boom {
    /// At a level, moved by its cylinder or under a moment, without dry friction and without a balance, so that the cylinder has
    /// something to carry; with its load on a rope or fixed to its head.
    fn scene(&self, level: &str, rope: bool) -> String {
        let mut scene = without(&without(self.scene, "[luffing.balance]"), "[luffing.limits]");
        if !rope {
            scene = without(&scene, "[luffing.hoisting]");
        }
        if level == "static" {
            scene = without(&scene, "[luffing.dynamics]");
        }
        let moved = level == "rigid" || level == "swing";
        for name in self.motor.into_iter().filter(|_| level == "hydraulic") {
            scene = replaced(&scene, name, "");
        }
        if moved {
            scene = replaced(&scene, self.motor[1], "M_S = \"0 kN.m\"");
        }
        if level != "static" {
            scene = replaced(&scene, "M_F = \"5 kN.m\"", "M_F = \"0 kN.m\"");
        }
        let scene = replaced(&scene, "fidelity = \"swing\"", &format!("fidelity = \"{level}\""));
        let oil = OIL.replace("u_v   = \"0.4\"", "u_v = \"0\"");
        let oil = if level == "hydraulic" { oil.as_str() } else { "" };
        format!(
            "{scene}\n[luffing.drive]\nkind = \"cylinder\"\n{}\nD_c = \"250 mm\"\nd_r = \"150 mm\"\n{oil}",
            self.drive
        )
    }

    fn model(&self, level: &str, rope: bool) -> Model {
        model(&self.scene(level, rope))
    }
}

fn replaced(scene: &str, before: &str, after: &str) -> String {
    assert!(scene.contains(before), "{before}");
    scene.replace(before, after)
}

/// A scene without one of its tables, where it has it.
fn without(scene: &str, table: &str) -> String {
    let Some((before, behind)) = scene.split_once(table) else {
        return scene.to_owned();
    };
    format!("{before}{}", behind.find("\n[").map_or("", |end| &behind[end..]))
}

/// At the start of its range the oil holds the boom: its cylinder pushes as it does at rest, and nothing moves.
#[test]
fn it_begins_at_rest() {
    for boom in &BOOMS {
        for rope in [false, true] {
            let mut still = boom.model("static", false);
            let mut oil = boom.model("hydraulic", rope);
            if rope {
                set(&mut oil, "v_h", 0.0);
            }
            oil.start().expect("it stands");
            let phi = get(&mut oil, "phi");
            still.set(0, phi).expect("an angle of the range");
            let [found, wanted] = [get(&mut oil, "F_c"), get(&mut still, "F_d")];
            assert!(wanted.abs() > 1e4, "{wanted}");
            near(found, wanted, 1e-9 * wanted.abs());
            near(get(&mut oil, "F_d"), wanted, 1e-9 * wanted.abs());
            near(get(&mut oil, "der(omega)"), 0.0, 1e-9);
            for pin in boom.pins {
                let [found, wanted] = [get(&mut oil, pin), get(&mut still, pin)];
                assert!(wanted != 0.0, "{pin}");
                near(found, wanted, 1e-9 * 1e6);
            }
        }
    }
}

/// Wherever it is, and however it moves, it is the boom under the moment of its cylinder: accelerations, rope, all forces.
#[test]
fn it_moves_as_under_a_moment() {
    for boom in &BOOMS {
        for (rope, level) in [(false, "rigid"), (true, "swing")] {
            let (mut oil, mut moved) = (boom.model("hydraulic", rope), boom.model(level, rope));
            let mut compared = 0;
            for part in 0..5 {
                let [from, to] = boom.angles;
                let phi = (from + (to - from) * f64::from(part) / 4.0).to_radians();
                let omega = [0.03, -0.02, 0.05, 0.01, -0.04][part as usize];
                for model in [&mut oil, &mut moved] {
                    let states = [("phi_R", 0.1), ("omega_R", -0.03), ("l_R", 9.0)];
                    let own = [("phi", phi), ("omega", omega)];
                    for (name, value) in own.into_iter().chain(states.into_iter().filter(|_| rope)) {
                        set(model, name, value);
                    }
                }
                let pressures = [
                    ("p_1", 110e5),
                    ("p_2", 30e5),
                    ("p_A", 95e5),
                    ("p_B", 45e5),
                    ("x_v", 0.2),
                ];
                for (name, value) in pressures {
                    set(&mut oil, name, value);
                }
                oil.update().expect("it moves there");
                let arm = get(&mut oil, "v_d") / omega;
                let moment = get(&mut oil, "F_c") * arm;
                near(get(&mut oil, "M_D"), moment, 1e-12 * moment.abs());
                set(&mut moved, "M_A", moment);
                moved.update().expect("it moves there");
                for variable in moved.variables().to_vec() {
                    if !matches!(variable.role, Role::Output | Role::Rate) {
                        continue;
                    }
                    let name = variable.name();
                    let Some(at) = oil.variables().iter().position(|other| other.name() == name) else {
                        continue;
                    };
                    let own = index(&moved, &name);
                    let [Ok(found), Ok(wanted)] = [oil.get(at), moved.get(own)] else {
                        continue;
                    };
                    // What the motor gives is no more in the scene, and events are those of another bar.
                    if ["M_r", "M_rs", "M_rc", "W_blow"].contains(&name.as_str()) {
                        continue;
                    }
                    near(found, wanted, 1e-12 * wanted.abs().max(size(&name)));
                    compared += 1;
                }
            }
            assert!(compared > 150, "{compared}");
        }
    }
}

/// What a result of nought is measured by: forces and moments by what they are made of.
fn size(name: &str) -> f64 {
    match name.as_bytes()[0] {
        b'F' | b'N' | b'M' | b'S' | b'P' | b'q' | b'p' => 1e7,
        _ => 1.0,
    }
}

/// What the pump gives is what the oil keeps, throttles take, the bars gain and friction takes: in the book's runs.
#[test]
fn energies_close() {
    for boom in &BOOMS {
        for rope in [false, true] {
            let scene = boom.scene("hydraulic", rope);
            let scene = Scene::parse(&scene).unwrap_or_else(|found| panic!("{found:?}"));
            let sheet = scene.sheet();
            for check in &sheet.identities {
                assert!(
                    check.at_most && check.value <= check.limit,
                    "{} {:e}",
                    check.id,
                    check.value
                );
            }
            let of = |id| {
                sheet
                    .identities
                    .iter()
                    .find(|check| check.id == id)
                    .expect("it is checked")
                    .value
            };
            assert!(
                of("motion_forces") < 1e-12 && of("motion_energy") < 1e-5,
                "{:e}",
                of("motion_energy")
            );
        }
    }
}

/// What the FMU says of derivatives, by states, inputs and parameters, against differences of its values.
#[test]
fn derivatives_are_those_of_its_values() {
    for boom in &BOOMS {
        for rope in [false, true] {
            let [from, to] = boom.angles.map(f64::to_radians);
            let states = [
                ("phi", 0.5 * (from + to)),
                ("omega", 0.03),
                ("p_1", 110e5),
                ("p_2", 30e5),
                ("p_A", 95e5),
                ("p_B", 45e5),
                ("x_v", 0.2),
                ("v_v", 3.0),
                ("phi_R", 0.1),
                ("omega_R", -0.03),
                ("l_R", 9.0),
            ];
            let asked = [
                "der(omega)",
                "der(p_1)",
                "der(p_2)",
                "der(p_A)",
                "der(p_B)",
                "der(omega_R)",
                "F_c",
                "S_R",
            ];
            let asked = [&asked[..], &boom.pins[..1], &boom.pins[4..]].concat();
            derivatives_are_those_of_the_values(boom.model("hydraulic", rope), &states, &asked, 60);
        }
    }
}
