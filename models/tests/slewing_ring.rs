//! The slewing ring: against a 40-digit oracle that shares forces by sinking and tilt, a maker's sums, the coefficients of
//! a moment alone, closed forms, and what must be the same of a ring that is mirrored, turned or twice as heavy.

#[path = "common/named.rs"]
mod named;
#[path = "common/supports.rs"]
mod supports;

use std::f64::consts::{FRAC_PI_2, PI};

use lemnis_models::scene::Scene;
use lemnis_models::supports::ring::elements::MomentAlone;
use lemnis_models::supports::ring::law::{LAWS, RollingElements};

use named::{get, index, model, near, set};
use supports::{compared, slewing, tables};

const READY: &str = include_str!("../scenes/slewing_portal.toml");
const ORACLE: &str = include_str!("../../tests/oracles/slewing_ring.csv");

/// What a scene of a test says.
#[derive(Clone, Copy)]
struct Said<'a> {
    /// Diameter, number of rolling elements, contact angle (rad).
    raceway: [&'a str; 3],
    law: &'a str,
    rows: &'a str,
    upper: &'a str,
    areas: &'a str,
    /// Slope (rad) and height of the load's suspension.
    slope: Option<[&'a str; 2]>,
    cases: &'a str,
    load: [&'a str; 2],
    more: &'a str,
}

/// A ring with boom and counterweight, one case without wind.
const PLAIN: Said<'static> = Said {
    raceway: ["4", "90", "1.5"],
    law: "linear",
    rows: "hold_down",
    upper: "500000 -0.5 3;150000 8 12;250000 -5 4",
    areas: "",
    slope: None,
    cases: "1 0 0",
    load: ["100000", "20"],
    more: "",
};

fn scene(said: &Said<'_>) -> String {
    let ([d, z, alpha], [load, reach]) = (said.raceway, said.load);
    let mut text = format!(
        "name = \"Test\"\ntitle = \"Test\"\n[supports]\nkind = \"ring\"\nD = \"{d} m\"\nz = \"{z}\"\nalpha = \"{alpha} rad\"\n\
         law = \"{}\"\nrows = \"{}\"\nQ = {{ input = \"{load} N\" }}\nR = {{ input = \"{reach} m\" }}\n",
        said.law, said.rows
    );
    slewing(&mut text, said.upper, said.areas, said.cases, said.slope);
    text + said.more
        + "[supports.motion]\nfrom = \"-180 deg\"\nto = \"180 deg\"\nstep = \"15 deg\"\nspeed = \"9 deg/s\"\n"
}

fn scene_of(row: &[&str]) -> String {
    let length = if row[14].is_empty() {
        String::new()
    } else {
        format!("b_r = \"{} m\"\n", row[14])
    };
    let mut more = format!(
        "[supports.contact]\nrho = \"{} m\"\n{length}HB = \"560\"\n[supports.capacity]\nk_r = \"5.046\"\n",
        row[13]
    );
    tables(
        &mut more,
        "capacity.curve",
        &[("F_curve", "N"), ("M_curve", "N.m")],
        row[15],
    );
    more += "[supports.friction]\nmu_n = \"0.008\"\n[supports.maker_friction]\nform = \"ball\"\nmu_m = \"0.004\"\n";
    scene(&Said {
        raceway: [row[0], row[1], row[2]],
        law: row[3],
        rows: row[4],
        upper: row[5],
        areas: row[6],
        slope: (!row[7].is_empty()).then_some([row[7], row[8]]),
        cases: row[9],
        load: [row[10], row[11]],
        more: &more,
    })
}

#[test]
fn the_oracle() {
    let (mut rows, mut lifted, mut greatest) = (0, 0, 0.0_f64);
    for line in ORACLE.lines().skip(1) {
        let row: Vec<&str> = line.split(',').collect();
        let mut model = model(&scene_of(&row));
        set(&mut model, "psi", row[12].parse().expect("an angle"));
        let d: f64 = row[0].parse().expect("a diameter");
        let mut lifts = false;
        for (case, wanted) in (1..).zip(row[16].split(';')) {
            let wanted: Vec<f64> = wanted.split(' ').map(|x| x.parse().expect("a number")).collect();
            let whole = wanted[0] + 2.0 * wanted[2] / d;
            let names = ["V", "H", "M", "P_max", "P_min", "S_N", "sigma_H", "S_0", "M_fn", "M_fm"];
            let sizes = [
                whole,
                whole,
                whole * d,
                wanted[3],
                wanted[3],
                wanted[5],
                wanted[6],
                wanted[7],
                wanted[8],
                wanted[9],
            ];
            for ((name, wanted), size) in names.iter().zip(&wanted).zip(sizes) {
                let found = get(&mut model, &format!("{name}[{case}]"));
                greatest = greatest.max((found - wanted).abs() / size);
                near(found, *wanted, 1e-12 * size);
            }
            lifts |= wanted[10] == 1.0;
        }
        assert_eq!(get(&mut model, "lifts") == 1.0, lifts, "row {rows}");
        assert_eq!(get(&mut model, "z.lift") < 0.0, lifts, "row {rows}");
        (rows, lifted) = (rows + 1, lifted + usize::from(lifts));
        // The identities of the book hold.
        let sheet = Scene::parse(&scene_of(&row)).map(|scene| scene.sheet());
        let sheet = match sheet {
            Ok(sheet) => sheet,
            // Elsewhere in its range a ring without a hold-down row may tip.
            Err(_) => continue,
        };
        for check in &sheet.identities {
            assert!(
                check.value <= check.limit,
                "{} of row {rows}: {}",
                check.id,
                check.value
            );
        }
    }
    println!("greatest difference {greatest:e}");
    assert_eq!(rows, 36);
    assert!(lifted >= 10, "{lifted}");
}

/// A maker's portal crane (Rothe Erde): load 220 kN at 23 m, boom 75 kN at 11 m, upper works 450 kN at 0.75 m and
/// counterweight 900 kN at 3 m behind, wind 27 kN at 6.5 m in the boom's direction; reference loads of the test 1.25 times.
#[test]
fn the_sums_of_a_maker() {
    let more = "[supports.capacity]\nk_r = \"0\"\n[[supports.capacity.curve]]\nF_curve = \"0 kN\"\nM_curve = \"8000 kN.m\"\n\
                [[supports.capacity.curve]]\nF_curve = \"9000 kN\"\nM_curve = \"0 kN.m\"\n";
    let text = scene(&Said {
        upper: "75000 11 0;450000 -0.75 0;900000 -3 0",
        areas: "100 6.5",
        cases: "1 270 0;1.25 0 0;1 0 0",
        load: ["220000", "23"],
        more,
        ..PLAIN
    });
    let mut model = model(&text);
    set(&mut model, "psi", 0.0);
    for (case, force, moment) in [(1, 1645e3, 3023.0e3), (2, 1700e3, 4112.5e3), (3, 1645e3, 2847.5e3)] {
        assert_eq!(get(&mut model, &format!("V[{case}]")), force);
        assert_eq!(get(&mut model, &format!("M[{case}]")), moment);
    }
    assert_eq!(get(&mut model, "H[1]"), 27e3);
    assert_eq!(get(&mut model, "F_ref[2]"), 2125e3);
    assert_eq!(get(&mut model, "M_ref[2]"), 5140.625e3);
    // M = 8000 − 8/9 F: the equivalent loads of the test meet it at 8000 / (4112.5 + 1700 · 8/9).
    near(get(&mut model, "S_0[2]"), 8000.0 / (4112.5 + 1700.0 * 8.0 / 9.0), 1e-14);
}

/// P_max z D/M and Σ|P| D/M of a moment alone, as `crane_rules` has them to three decimals; with ever more rolling elements
/// they come to the integrals. Under a moment that grows without end those of the ring come to them.
#[test]
fn a_moment_alone() {
    for (law, [force, sum]) in [[4.0, 2.546], [4.085, 2.516], [4.370, 2.432]].into_iter().enumerate() {
        let rolling = RollingElements::new(720, law, true);
        let alone = MomentAlone::<f64>::new(&rolling);
        near(alone.force, force, 5e-4);
        near(alone.sum, sum, 5e-4);
        let many = MomentAlone::<f64>::new(&RollingElements::new(1000, law, true));
        near(many.force, alone.force, 1e-6);
        let [lambda, ..] = rolling.solved(1.0);
        near(lambda, 1.0, 1e-14);
        // 2 / J_s, of J_s at λ = 1, as the couple is all: P_max z D / M.
        let [arms] = rolling.means(
            |cosine: f64| 1.0 - lambda * (1.0 - cosine),
            |cosine, force| [(1.0 + cosine) * force],
        );
        near(2.0 / arms, alone.force, 1e-12);
        // The model says the same of its own ring, whatever its rows.
        for rows in ["pressure", "hold_down"] {
            let reach = ["100000", "12"];
            let mut model = model(&scene(&Said {
                law: LAWS[law],
                rows,
                raceway: ["8", "720", "1.5"],
                load: reach,
                ..PLAIN
            }));
            assert_eq!(get(&mut model, "c_P"), alone.force);
            assert_eq!(get(&mut model, "c_Sigma"), alone.sum);
        }
    }
    // Springs, exactly: 4, and 8/π in the limit.
    let linear = MomentAlone::<f64>::new(&RollingElements::new(1000, 0, true));
    near(linear.force, 4.0, 1e-14);
    near(linear.sum, 8.0 / PI, 2e-5);
}

/// The fall λ for any part κ of the couple, up to where the ring tips or beyond a moment alone, with every law, on one row and
/// on two: what all elements bear at that fall, by powers and one by one, has that part.
#[test]
fn every_part_of_the_couple_is_found() {
    for (law, order) in [1.0, 10.0 / 9.0, 1.5].into_iter().enumerate() {
        for (count, held_down) in [3, 4, 5, 12, 121, 1000]
            .into_iter()
            .flat_map(|z| [(z, false), (z, true)])
        {
            let rolling = RollingElements::new(count, law, held_down);
            let part = |lambda: f64| {
                let (mut turns, mut whole) = (0.0, 0.0);
                for cosine in &rolling.cosines {
                    let near = 1.0 - lambda * (1.0 - cosine);
                    let bears = if near > 0.0 || held_down {
                        libm::pow(near.abs(), order)
                    } else {
                        0.0
                    };
                    turns += bears.copysign(near) * cosine;
                    whole += bears.copysign(near) * (1.0 + cosine);
                }
                turns / whole
            };
            let most = if held_down {
                1.2
            } else {
                0.5 - 1e-6 * (1.0 - rolling.cosines[1])
            };
            for i in 0..=500 {
                let kappa = most * f64::from(i) / 500.0;
                let [place, met, slope] = rolling.solved(kappa);
                let lambda = place + (kappa - met) / slope;
                near(part(lambda), kappa, 2e-14);
            }
        }
    }
}

/// V/z + 4M/(z D) while springs bear all around; without a hold-down row the far side is free from there on, the greatest
/// grows faster and goes through without a jump.
#[test]
fn the_far_side_lifts() {
    let said = |rows| Said {
        rows,
        raceway: ["8", "90", "1.5"],
        ..PLAIN
    };
    let [mut held, mut loose] = ["hold_down", "pressure"].map(|rows| model(&scene(&said(rows))));
    // M = V D/4: 900 kN with 50 kN·m less than −0.3 MN·m; 100 kN at R.
    let (weight, own) = (1000e3, -250e3 + 1200e3 - 1250e3);
    let edge = (weight * 8.0 / 4.0 - own) / 100e3;
    for (part, lifts) in [(0.9, 0.0), (1.0 - 1e-9, 0.0), (1.0 + 1e-9, 1.0), (1.2, 1.0)] {
        for model in [&mut held, &mut loose] {
            set(model, "R", edge * part);
            assert_eq!(get(model, "lifts"), lifts, "{part}");
        }
        let moment = own + 100e3 * edge * part;
        let linear = (weight + 4.0 * moment / 8.0) / 90.0;
        near(get(&mut held, "P_max[1]"), linear, 1e-9);
        near(get(&mut held, "P_min[1]"), (weight - 4.0 * moment / 8.0) / 90.0, 1e-9);
        let found = get(&mut loose, "P_max[1]");
        if part == 1.2 {
            assert!(
                found > linear * 1.001 && get(&mut loose, "P_min[1]") == 0.0,
                "{found} {linear}"
            );
        } else {
            near(found, linear, 1e-6 * linear);
        }
    }
    // Beyond the raceway nothing holds it.
    set(&mut loose, "psi", 0.0);
    set(&mut loose, "R", 50.0);
    let at = index(&loose, "P_max[1]");
    let fault = loose.get(at).expect_err("it tips");
    let wanted = "psi = 0 deg: in case 1 the ring would tip over its edge, its force acts at M/V = 4.7 m from the axis and the \
                  raceway ends at D/2 = 4 m";
    assert!(fault.outside && fault.message.starts_with(wanted), "{}", fault.message);
    set(&mut held, "R", 50.0);
    assert!(get(&mut held, "P_max[1]") > 0.0);
}

/// Bolts of any number on their circle by hand, with a joint that keeps closed or opens; the life of balls and rollers falls with
/// its power where all is twice as heavy.
#[test]
fn bolts_and_life() {
    let more = |count: &str| {
        format!(
            "[supports.bolts]\nn_b = \"{count}\"\nD_b = \"4.2 m\"\nF_p = \"60 kN\"\nF_y = \"100 kN\"\nphi_b = \"0.25\"\nmu_b = \"0.1\"\n\
             [supports.life]\nC_d = \"9000 kN\"\nk_h = \"0.75\"\n"
        )
    };
    // V = 1000 kN, M = 100 · 43 − 300 = 4000 kN·m, 27 kN of wind across.
    fn said<'a>(more: &'a str, law: &'a str, upper: &'a str, load: &'a str, areas: &'a str) -> Said<'a> {
        Said {
            law,
            upper,
            areas,
            cases: "1 270 1.5707963267948966",
            load: [load, "43"],
            more,
            ..PLAIN
        }
    }
    let upper = "500000 -0.5 3;150000 8 12;250000 -5 4";
    for count in ["3", "4", "7", "96"] {
        let (n, text): (f64, _) = (count.parse().expect("a number"), more(count));
        let mut model = model(&scene(&said(&text, "line", upper, "100000", "100 0")));
        set(&mut model, "psi", 0.0);
        let pull = (4.0 * 4000e3 / 4.2 - 1000e3) / n;
        let found = [
            ("F_b[1]", pull),
            ("F_bm[1]", 60e3 + 0.25 * pull),
            ("S_b[1]", 100e3 / (60e3 + 0.25 * pull)),
            ("F_k[1]", 60e3 - 0.75 * pull),
            ("S_h[1]", 0.1 * (n * 60e3 + 1000e3) / 27e3),
            ("P_e[1]", 1000e3 + 2.0 * 4000e3 / 4.0 + 0.75 * 27e3),
        ];
        for (name, wanted) in found {
            near(get(&mut model, name), wanted, 1e-10 * wanted.abs());
        }
        assert_eq!(get(&mut model, "F_k[1]") < 0.0, n < 30.0);
        // Towards the load the same bolt is pressed; where nothing is pulled it has its preload alone.
        set(&mut model, "R", 3.0);
        assert!(get(&mut model, "F_b[1]") < 0.0);
        assert_eq!(get(&mut model, "F_bm[1]"), 60e3);
    }
    let text = more("96");
    let heavy = "1000000 -0.5 3;300000 8 12;500000 -5 4";
    for (law, power) in [("point", 3.0), ("line", 10.0 / 3.0)] {
        let lives = [(upper, "100000"), (heavy, "200000")].map(|(upper, load)| {
            let mut model = model(&scene(&said(&text, law, upper, load, "")));
            set(&mut model, "psi", 0.0);
            assert_eq!(get(&mut model, "S_h[1]"), f64::INFINITY);
            near(
                get(&mut model, "P_e[1]"),
                load.parse::<f64>().expect("a load") * 30.0,
                1e-6,
            );
            get(&mut model, "L_10[1]")
        });
        near(lives[0], libm::pow(3.0, power), 1e-12 * lives[0]);
        near(lives[0] / lives[1], libm::pow(2.0, power), 1e-12 * 11.0);
    }
}

/// Exact derivatives against differences, of every law and both rows, where the far side lifts and where it does not.
#[test]
fn derivatives() {
    let mut ready = model(READY);
    let (mut count, mut lifted) = (0, 0);
    for psi in [40.0, 133.0, 305.0] {
        set(&mut ready, "psi", f64::to_radians(psi));
        count += compared(&mut ready, &["omega", "s", "z_d", "n_s"], &["lifts"]);
    }
    for line in ORACLE.lines().skip(1).step_by(2) {
        let row: Vec<&str> = line.split(',').collect();
        let mut model = model(&scene_of(&row));
        set(&mut model, "psi", row[12].parse().expect("an angle"));
        lifted += usize::from(get(&mut model, "lifts") == 1.0);
        count += compared(&mut model, &["omega", "s"], &["lifts"]);
    }
    assert!(count > 20_000 && lifted > 3, "{count} {lifted}");
}

/// Mirrored, all but the sides are the same; with all directions turned by a quarter (there is no slope) too; twice as
/// heavy, all forces are twice.
#[test]
fn mirrored_turned_and_heavier() {
    let windy = Said {
        areas: "30 4;20 12",
        cases: "1 250 0.7;1.25 100 -1.9",
        law: "point",
        ..PLAIN
    };
    let upper = "1000000 -0.5 3;300000 8 12;500000 -5 4";
    let mut plain = model(&scene(&windy));
    let mut mirrored = model(&scene(&Said {
        cases: "1 250 -0.7;1.25 100 1.9",
        ..windy
    }));
    let turned = format!("1 250 {};1.25 100 {}", 0.7 + FRAC_PI_2, -1.9 + FRAC_PI_2);
    let mut turned = model(&scene(&Said {
        cases: &turned,
        ..windy
    }));
    let heavy = Said {
        upper,
        load: ["200000", "20"],
        cases: "1 500 0.7;1.25 200 -1.9",
        ..windy
    };
    let mut heavy = model(&scene(&heavy));
    let psi = 0.4;
    set(&mut plain, "psi", psi);
    set(&mut mirrored, "psi", -psi);
    set(&mut turned, "psi", psi + FRAC_PI_2);
    set(&mut heavy, "psi", psi);
    for name in ["V", "H", "M", "M_l", "M_t", "H_l", "H_t", "P_max", "P_min", "S_N"] {
        for case in 1..=2 {
            let name = format!("{name}[{case}]");
            let wanted = get(&mut plain, &name);
            let side = if name.contains("_t") { -1.0 } else { 1.0 };
            near(get(&mut mirrored, &name), side * wanted, 1e-8);
            near(get(&mut turned, &name), wanted, 1e-8);
            near(get(&mut heavy, &name), 2.0 * wanted, 1e-8);
        }
    }
}
