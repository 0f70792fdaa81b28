//! What a luffing drive must overcome: the same for every luffing system, with every balance and every drive. Beside the
//! oracle of two cranes (`tests/test_resistances.py`), friction is held against the forces in the pins at rest, inertia and
//! centrifugal forces against the motion of the same crane, and work against energy.

#[path = "common/balances.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod balances;
#[path = "common/driven.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod driven;
#[path = "common/named.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod named;

use driven::{BELOW, CURVED_TRUNK, DRIVE, ELLIPSOGRAPH, GUIDED, KINDS, LINK, MOTION, RACK, TRUNK, systems, without};
use lemnis_models::component::model::Model;
use lemnis_models::scene::Scene;
use named::{get, model, near, set};

fn parse(name: &str, text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|found| panic!("{name}: {found:?}"))
}

/// By derivatives and by equilibrium at rest, by virtual work and by Newton and Euler, by work and by energy.
#[test]
fn all_ways_to_the_moments_agree_for_every_system_balance_and_drive() {
    for (name, text) in systems() {
        let sheet = parse(&name, &text).sheet();
        let own: Vec<_> = sheet
            .identities
            .iter()
            .filter(|check| check.id.starts_with("resistance"))
            .collect();
        assert_eq!(own.len(), 3, "{name}");
        for check in own {
            assert!(check.passed(), "{name}: {} {:e}", check.id, check.value);
        }
        let cases = sheet.cases.expect("a chapter");
        assert!(
            !cases.worked[0].sections.is_empty() && cases.ranges.len().is_multiple_of(cases.names.len()),
            "{name}"
        );
    }
}

/// At a constant speed of the drive inertia gives what the bodies lose of their kinetic energy, and that follows from what
/// inertia does at rest.
#[test]
fn inertia_is_what_kinetic_energy_loses() {
    const STEP: f64 = 1e-5;
    let one = |text: &str, v: &str, a: &str| {
        let cases = text.find("[[cases.case]]").expect("there");
        let rest = text[cases..].find("[[cases.body]]").expect("there");
        let case =
            format!("[[cases.case]]\nname = \"one\"\nk_Q = \"0\"\np_w = \"0 Pa\"\nv_s = \"{v}\"\na_s = \"{a}\"\n\n");
        let text = format!("{}{case}{}", &text[..cases], &text[cases + rest..]);
        let shaft = ["cases.motor", "cases.start", "cases.brake", "cases.second_brake"];
        model(&shaft.iter().fold(text, |text, table| without(&text, table)))
    };
    for (name, text) in systems() {
        let (mut starts, mut runs) = (one(&text, "0 m/s", "1 m/s2"), one(&text, "0.1 m/s", "0 m/s2"));
        let mut energy = |runs: &mut Model, place: f64| {
            starts.set(0, place).expect("near");
            runs.set(0, place).expect("near");
            let inertia = -get(&mut starts, "M_r_inertia[1]") / get(&mut starts, "domega_r[1]");
            inertia * get(runs, "omega_r[1]").powi(2) / 2.0
        };
        for part in [0.1, 0.4, 0.9] {
            let place = at(&mut runs, part);
            let loses = energy(&mut runs, place - STEP) - energy(&mut runs, place + STEP);
            let whole = energy(&mut runs, place);
            let found = get(&mut runs, "M_r_inertia[1]");
            let apart = (found - loses / (2.0 * STEP)).abs();
            assert!(
                apart <= 1e-8 * (whole + found.abs()) + 1e-7 * whole,
                "{name}: {found} {loses} {whole}"
            );
        }
    }
}

fn at(model: &mut Model, part: f64) -> f64 {
    let motion = model.positions();
    let (from, to) = (motion[0], motion[motion.len() - 1]);
    let place = from + part * (to - from);
    model.set(0, place).expect("within the range");
    place
}

const PARTS: [f64; 4] = [0.0, 0.31, 0.62, 1.0];

/// One slow case with the load alone: what pins carry is what they carry at rest.
fn slow([bodies, pins]: [&[&str]; 2], guide: bool) -> String {
    let mut text =
        "\n[cases]\n[[cases.case]]\nname = \"slow\"\nk_Q = \"1\"\nalpha_s = \"0 deg\"\nv_s = \"1e-6 mm/s\"\n"
            .to_owned();
    for body in bodies {
        text += &format!("[[cases.body]]\non = \"{body}\"\nJ_s = \"0 kg.m2\"\n");
    }
    for pin in pins {
        let radius = if guide { "" } else { "r_p = \"100 mm\"\n" };
        text += &format!("[[cases.pin]]\nat = \"{pin}\"\nmu_p = \"0.1\"\n{radius}");
    }
    text
}

/// A force of the model at rest, by its components.
fn force(model: &mut Model, name: &str) -> f64 {
    let [x, y] = ["x", "y"].map(|part| get(model, &format!("{name}.{part}")));
    (x * x + y * y).sqrt()
}

/// How much an angle of the model turns for one radian of its coordinate, by central differences.
fn turn(model: &mut Model, place: f64, name: &str) -> f64 {
    const STEP: f64 = 1e-6;
    let mut angle = |at: f64| {
        model.set(0, at).expect("near");
        get(model, name)
    };
    let found = (angle(place + STEP) - angle(place - STEP)) / (2.0 * STEP);
    model.set(0, place).expect("there");
    found
}

/// Which way the case turns its luffing angle.
fn against(model: &mut Model) -> f64 {
    -get(model, "omega_r[1]").signum()
}

/// A pin of a system: its force at rest, and its turn as the difference of two angles' turns; one angle turns with the
/// coordinate itself where it has no name.
type Pinned = (&'static str, &'static str, [Option<&'static str>; 2]);

#[test]
fn friction_is_that_of_the_forces_in_the_pins_at_rest() {
    // Within what differences leave of a turn.
    const NEAR: f64 = 1e-7;
    let link: [Pinned; 4] = [
        ("O1", "F_O1", [Some(""), None]),
        ("B", "F_B", [Some("alpha"), Some("")]),
        ("C", "F_C", [Some("alpha"), Some("theta_3")]),
        ("O3", "F_O3", [Some("theta_3"), None]),
    ];
    let balanced = [("M", "F_M", [Some("psi"), None]), ("O1", "F_O1", [Some(""), None])];
    let guided: [Pinned; 2] = [
        ("O1", "F_O1", [Some("theta_l"), None]),
        ("C", "F_C", [Some(""), Some("theta_l")]),
    ];
    let trunk: [Pinned; 2] = [
        ("O1", "F_O1", [Some(""), None]),
        ("B", "F_B", [Some("alpha"), Some("")]),
    ];
    let new = balances::NEW.to_owned();
    let all = [
        (new.clone(), LINK, &link[..]),
        (new, LINK, &balanced[..]),
        (KINDS[1].to_owned(), LINK, &link[..]),
        (ELLIPSOGRAPH.to_owned() + BELOW, GUIDED, &guided[..]),
        (CURVED_TRUNK.to_owned() + RACK, TRUNK, &trunk[..]),
    ];
    for (text, [bodies, _], pins) in all {
        for (pin, carried, [one, other]) in pins {
            let mut model = model(&(text.clone() + &slow([bodies, &[pin]], false)));
            for part in PARTS {
                let place = at(&mut model, part);
                let mut turned = |name: &Option<&str>| match name {
                    None => 0.0,
                    Some("") => 1.0,
                    Some(name) => turn(&mut model, place, name),
                };
                let turns = (turned(one) - turned(other)).abs();
                let expected = against(&mut model) * 0.1 * 0.1 * force(&mut model, carried) * turns;
                let found = get(&mut model, "M_r_friction[1]");
                near(found, expected, NEAR * expected.abs().max(1.0) * (1.0 + turns));
            }
        }
    }
}

/// A rod pulls at both its ends; a guide rubs along the foot's way.
#[test]
fn friction_at_a_rod_and_in_a_guide_is_that_of_their_forces_at_rest() {
    let rod = |pin| model(&(balances::NEW.to_owned() + &slow([LINK[0], &[pin]], false)));
    let [mut at_boom, mut at_lever] = ["K", "L"].map(rod);
    let mut guide = model(&(ELLIPSOGRAPH.to_owned() + BELOW + &slow([GUIDED[0], &["B"]], true)));
    for part in PARTS {
        let place = at(&mut at_boom, part);
        at(&mut at_lever, part);
        let lever = turn(&mut at_boom, place, "psi");
        let pull = get(&mut at_boom, "N_1").abs();
        let [k, l] = [&mut at_boom, &mut at_lever].map(|model| get(model, "M_r_friction[1]").abs() / (0.01 * pull));
        // Of rod, boom and lever: the rod turns against one of them by what it does against the other, and their difference.
        let apart = [(k + l) - (lever - 1.0).abs(), (k - l).abs() - (lever - 1.0).abs()];
        assert!(apart.iter().any(|x| x.abs() < 1e-6), "{k} {l} {lever}");
        let place = at(&mut guide, part);
        let way = turn(&mut guide, place, "B.y").abs();
        let expected = against(&mut guide) * 0.1 * get(&mut guide, "F_B.x").abs() * way;
        near(
            get(&mut guide, "M_r_friction[1]"),
            expected,
            1e-6 * expected.abs().max(1.0),
        );
    }
}

/// The portal crane without a load, turned by a moment, slewing at a speed.
fn in_motion(moment: f64, slewing: f64) -> String {
    let text = MOTION
        .replace("fidelity = \"swing\"", "fidelity = \"rigid\"")
        .replace("Q = \"100 kN\"", "Q = \"0 kN\"");
    let text = [
        "c_v  = \"15000 kN.m.s\"",
        "M_F  = \"20 kN.m\"",
        "l_R  = \"15 m\"",
        "c_sl  = \"3000 kN.m.s\"",
        "M_Fsl = \"30 kN.m\"",
    ]
    .iter()
    .fold(text, |text, line| {
        assert!(text.contains(line), "{line}");
        text.replace(line, "")
    });
    text.replace("M_A  = \"500 kN.m\"", &format!("M_A = \"{moment} kN.m\""))
        .replace("M_sl  = \"300 kN.m\"", &format!("omega_sl = \"{slewing} rad/s\""))
}

/// The crane of the same bodies under a case of that motion.
fn under(slewing: f64, v: f64, a: f64) -> Model {
    let mut text = without(&without(MOTION, "luffing.dynamics"), "luffing.slewing").replace("fidelity = \"swing\"", "");
    let turns = slewing / std::f64::consts::TAU;
    text += &format!(
        "\n[cases]\n[[cases.case]]\nname = \"motion\"\nk_Q = \"0\"\nn_s = \"{turns:e} 1/s\"\nv_s = \"{v:e} m/s\"\na_s = \"{a:e} m/s2\"\n"
    );
    for (body, inertia) in [("boom", 951_600), ("jib", 201_200), ("rocker", 114_500)] {
        text += &format!("[[cases.body]]\non = \"{body}\"\nJ_s = \"{inertia} kg.m2\"\n");
    }
    model(&text)
}

/// The acceleration that a moment gives the moving crane is that in which inertia, centrifugal forces and own weights leave
/// the same moment to the drive: inverse dynamics of the level `rigid`.
#[test]
fn inertia_and_centrifugal_forces_are_those_of_the_moving_crane() {
    const MOMENT: f64 = 500.0;
    for (slewing, omega) in [(0.0, 0.02), (0.15, -0.013), (0.3, 0.0)] {
        let mut moving = model(&in_motion(MOMENT, slewing));
        for degrees in [47.0_f64, 60.0, 75.0] {
            let place = degrees.to_radians();
            set(&mut moving, "theta_1", place);
            set(&mut moving, "omega_1", omega);
            moving.event().expect("closes");
            let bend = get(&mut moving, "der(omega_1)");
            // The drive's speed and acceleration then: v = h ω, a = h ω̇ + h′ ω².
            let mut still = under(slewing, 0.0, 0.0);
            let arm = |model: &mut Model, at: f64| {
                model.set(0, at).expect("there");
                set(model, "omega_1", 1.0);
                get(model, "v_d")
            };
            let h = arm(&mut still, place);
            let change = (arm(&mut still, place + 1e-5) - arm(&mut still, place - 1e-5)) / 2e-5;
            let mut case = under(slewing, h * omega, h * bend + change * omega * omega);
            case.set(0, place).expect("there");
            near(get(&mut case, "omega_r[1]"), omega, 1e-15);
            let found = ["M_r_own", "M_r_inertia[1]", "M_r_centrifugal[1]"].map(|name| get(&mut case, name));
            let left: f64 = found.iter().sum::<f64>() + MOMENT * 1e3;
            // As near as differences bring the change of the lever arm.
            near(left, 0.0, 1e-8 * MOMENT * 1e3);
        }
    }
}

/// A crank of the scene's own, or a plain boom, refuses what it does not have.
#[test]
fn what_cannot_be_is_told() {
    let change = |old: &str, new: &str| {
        assert!(DRIVE.contains(old), "{old}");
        DRIVE.replacen(old, new, 1)
    };
    for (text, told) in [
        (change("on  = \"jib\"", "on  = \"trunk\""), "no body \"trunk\""),
        (change("at   = \"B\"", "at   = \"N\""), "no pin \"N\""),
        (change("r_p  = \"150 mm\"\n", ""), "pin O1 without its radius"),
        (change("p_w     = \"-75 Pa\"", ""), "has no wind"),
        (
            change("p_w     = \"-75 Pa\"", "v_w = \"12 m/s\""),
            "without the pressure",
        ),
        (
            change("alpha_s = \"3.5 deg\"", ""),
            "the sway of the load in case \"I\"",
        ),
        (change("name    = \"II\"", "name    = \"I\""), "two cases \"I\""),
        (change("c_w = \"1\"\n", ""), "without a drag coefficient"),
        (change("s_5     = \"3 m\"", ""), "counterweight has no arm"),
        (without(DRIVE, "luffing.drive"), "without a drive"),
        (change("Q = \"100 kN\"", ""), "without a load"),
        (
            change("E_x    = \"-4 m\"", "E_x    = \"4.1 m\"").replace("E_y    = \"10 m\"", "E_y = \"11.3 m\""),
            "points at the foot",
        ),
    ] {
        let found = Scene::parse(&text).err().unwrap_or_default();
        let all: Vec<&str> = found.iter().map(|mistake| mistake.message.as_str()).collect();
        assert!(all.iter().any(|message| message.contains(told)), "{told}: {all:?}");
    }
}

/// What a standard gives is told to be confirmed, and what it does not give is asked for.
#[test]
fn coefficients_of_a_standard_are_to_be_confirmed() {
    let by = |standard: &str| {
        let text = DRIVE.replacen("[cases] ", &format!("[cases]\nstandard = \"{standard}\"\n#"), 1);
        let text = text.replacen("p_w     = \"250 Pa\"", "v_w = \"20 m/s\"", 1);
        text.replacen("alpha_s = \"-12 deg\"\n", "", 1)
    };
    let cases = parse("GB", &by("GB/T 3811")).sheet().cases.expect("cases");
    let told: Vec<(&str, f64)> = cases
        .unconfirmed
        .iter()
        .map(|(symbol, _, value, _)| (symbol.id, *value))
        .collect();
    assert_eq!(told, [("c_air", 0.625), ("alpha_s", 10_f64.to_radians())]);
    let mistakes = Scene::parse(&by("EN 13001")).err().unwrap_or_default();
    assert!(
        mistakes
            .iter()
            .any(|found| found.message.contains("EN 13001 does not give")),
        "{mistakes:?}"
    );
    assert!(parse("own", DRIVE).sheet().cases.expect("cases").unconfirmed.is_empty());
}
