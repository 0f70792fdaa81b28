//! Travel of a crane on a portal: against a 40-digit oracle of wheels, shafts, energies and levers, against what must be the same
//! of other scenes, and its limits.

#[path = "common/named.rs"]
mod named;
#[path = "common/supports.rs"]
mod supports;

use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

use lemnis_models::scene::Scene;

use named::{get, index, model, near, set};
use supports::{compared, tables};

const READY: &str = include_str!("../scenes/portal_travel.toml");
const ORACLE: &str = include_str!("../../tests/oracles/portal_travel.csv");
/// Units in a row of the oracle.
const TRAVEL: [(&str, &str); 17] = [
    ("v_t", "m/s"),
    ("a_t", "m/s2"),
    ("gamma_t", "rad"),
    ("D_t", "m"),
    ("d_j", "m"),
    ("f_r", "m"),
    ("mu_j", ""),
    ("beta_t", ""),
    ("mu_a", ""),
    ("F_br", "N"),
    ("k_w", ""),
    ("z_m", ""),
    ("i_t", ""),
    ("eta_t", ""),
    ("P_N", "W"),
    ("lambda_M", ""),
    ("J_M", "kg.m2"),
];
const STORM: [(&str, &str); 3] = [("p_s", "Pa"), ("z_c", ""), ("F_c", "N")];

/// Keys of a table with a row's numbers.
fn keys(text: &mut String, known: &[(&str, &str)], row: &str) {
    for ((key, unit), number) in known.iter().zip(row.split(' ')) {
        let _ = writeln!(text, "{key} = \"{number} {unit}\"");
    }
}

fn scene_of(row: &[&str]) -> String {
    let mut text = format!(
        "name = \"Test\"\ntitle = \"Test\"\n[supports]\nkind = \"portal\"\nframe = \"rigid\"\na = \"{} m\"\nb = \"{} m\"\n\
         Q = {{ input = \"{} N\" }}\nR = {{ input = \"{} m\" }}\n",
        row[0], row[1], row[7], row[8]
    );
    tables(&mut text, "corners", &[("n_w", ""), ("n_dr", "")], row[10]);
    tables(&mut text, "portal", &[("G_p", "N"), ("x_p", "m"), ("y_p", "m")], row[2]);
    tables(&mut text, "upper", &[("G_u", "N"), ("r_u", "m")], row[3]);
    let _ = writeln!(
        text,
        "[supports.wind]\np_w = \"{} Pa\"\nchi_w = \"{} rad\"",
        row[4], row[5]
    );
    tables(&mut text, "wind.areas", &[("A_w", "m2"), ("h_w", "m")], row[6]);
    text.push_str("[supports.travel]\n");
    keys(&mut text, &TRAVEL, row[11]);
    text.push_str("[supports.travel.storm]\n");
    keys(&mut text, &STORM, row[12]);
    text.push_str("[supports.motion]\nfrom = \"-180 deg\"\nto = \"180 deg\"\nstep = \"15 deg\"\nspeed = \"9 deg/s\"\n");
    text
}

#[test]
fn the_oracle() {
    let mut lines = ORACLE.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().expect("names").split_off(14);
    let (mut rows, mut none) = (0, 0);
    for row in lines {
        let mut model = model(&scene_of(&row));
        set(&mut model, "psi", row[9].parse().expect("an angle"));
        for (name, wanted) in names.iter().zip(&row[14..]) {
            let found = get(&mut model, name);
            match wanted.parse::<f64>() {
                Ok(wanted) => near(found, wanted, 1e-11 * wanted.abs()),
                Err(_) => {
                    assert_eq!(found, f64::INFINITY, "{name}");
                    none += 1;
                }
            }
        }
        rows += 1;
    }
    assert!(rows == 24 && none > 20, "{rows} {none}");
}

/// Exact derivatives against differences; by the number of driven wheels nothing changes to the side of less where it is none.
#[test]
fn derivatives() {
    let mut model = model(READY);
    let mut count = 0;
    for (psi, load) in [(40.0, 157e3), (133.0, 90e3)] {
        set(&mut model, "psi", f64::to_radians(psi));
        set(&mut model, "Q", load);
        // Across the rails the part of the wind along them has a bend.
        set(&mut model, "chi_w", 2.6);
        count += compared(&mut model, &["omega", "s", "n_w"], &["lifts", "leg"]);
    }
    assert!(count > 4000, "{count}");
}

/// A stop takes what is there: force times way is the energy of crane and shafts; a start that takes as long as a stop gives as
/// much. Without motors' inertia brakes and rails have the same force; with the wind across the rails there is none along them.
#[test]
fn energy_and_limits() {
    let mut model = model(READY);
    let [v, mass, rotating] = [
        get(&mut model, "v_t"),
        get(&mut model, "V") / 9.81,
        get(&mut model, "m_J"),
    ];
    let work = (get(&mut model, "F_br") - get(&mut model, "F_do")) * get(&mut model, "s_br");
    let energy = (mass + rotating) * v * v / 2.0;
    near(work, energy, 1e-12 * energy);
    near(get(&mut model, "t_br") * v, 2.0 * get(&mut model, "s_br"), 1e-13);
    // What a start takes from the motors above steady travel, apart from losses: (m/η + m_J) a v.
    let more = get(&mut model, "z_m") * (get(&mut model, "P_a") - get(&mut model, "P_t"));
    let wanted = (mass / get(&mut model, "eta_t") + rotating) * get(&mut model, "a_t") * v;
    near(more, wanted, 1e-12 * wanted);
    set(&mut model, "chi_w", FRAC_PI_2);
    near(get(&mut model, "F_wt"), 0.0, 1e-9);
    // What the smallest shafts that can be take is their mass at the wheels by a deceleration below 1 m/s².
    set(&mut model, "J_M", 1e-12);
    let [rails, shafts] = [get(&mut model, "F_tb"), get(&mut model, "m_J")];
    near(rails, get(&mut model, "F_br"), shafts);
}

/// Of every corner at each slewing angle a full turn finds the least; the wheel that bears least slips first.
#[test]
fn the_least_of_the_circle() {
    let sheet = Scene::parse(READY).expect("it stands").sheet();
    let least = |id: &str| {
        let found = sheet.governing.iter().find(|found| found.symbol.id == id);
        found.expect("governing").value
    };
    let mut model = model(READY);
    let (mut grip, mut storm) = (f64::INFINITY, f64::INFINITY);
    for step in 0..7200 {
        set(&mut model, "psi", f64::to_radians(f64::from(step) * 0.05));
        for i in 1..=4 {
            grip = grip.min(get(&mut model, &format!("k_st[{i}]")));
            storm = storm.min(get(&mut model, &format!("K_s[{i}]")));
        }
    }
    for (found, wanted) in [(least("k_st_min"), grip), (least("K_s_min"), storm)] {
        // Between two of these places it is less, and on one of them the same but for its last digits.
        let apart = (wanted - found) / wanted;
        assert!((-1e-15..=1e-6).contains(&apart), "{found} {wanted}");
    }
    // In closed form: the adhesion of the least wheel load on the circle over the force of a wheel in a start.
    let wheel = get(&mut model, "N_4_cir") / get(&mut model, "n_w[1]");
    let closed = get(&mut model, "mu_a") * wheel / get(&mut model, "F_1a");
    near(least("k_st_min"), closed, 1e-12 * closed);
}

/// Brakes that do not stop it are told.
#[test]
fn weak_brakes() {
    let mut model = model(READY);
    set(&mut model, "F_br", 10e3);
    let at = index(&model, "s_br");
    let fault = model.get(at).expect_err("it does not stop");
    let wanted = "F_br = 10 kN does not stop the crane, which wind and slope drive on with ";
    assert!(fault.outside && fault.message.starts_with(wanted), "{}", fault.message);
}
