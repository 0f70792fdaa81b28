//! The book's manoeuvres: their commands, what the model makes of them, and what follows in closed form.

use lemnis_models::component::model::Model;
use lemnis_models::component::sheet::{InMotion, Manoeuvre};
use lemnis_models::scene::Scene;

#[path = "common/levels.rs"]
mod levels;

const READY: [&str; 2] = [
    include_str!("../scenes/portal_004_motion.toml"),
    include_str!("../scenes/portal_crane.toml"),
];

/// Single booms, whose angle is phi.
const SINGLE: [&str; 3] = [
    include_str!("../scenes/rope_motion.toml"),
    include_str!("../scenes/ellipsograph_motion.toml"),
    include_str!("../scenes/curved_trunk_motion.toml"),
];

fn parsed(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"))
}

fn motion(scene: &Scene) -> InMotion {
    scene.sheet().motion.expect("a chapter of motion")
}

fn named<'a>(motion: &'a InMotion, id: &str) -> &'a Manoeuvre {
    let mut all = motion.manoeuvres.iter();
    all.find(|manoeuvre| manoeuvre.id == id).expect("this scene has it")
}

/// Least and greatest value of a result in a manoeuvre.
fn ends(motion: &InMotion, symbol: &str, id: &str) -> [f64; 2] {
    let row = motion
        .envelope
        .iter()
        .find(|row| row.symbol.id == symbol)
        .expect("a row");
    let place = motion.manoeuvres.iter().position(|manoeuvre| manoeuvre.id == id);
    row.moving[place.expect("this scene has it")].map(|end| end.value)
}

fn index(model: &Model, id: &str) -> usize {
    let found = model.variables().iter().position(|variable| variable.symbol.id == id);
    found.unwrap_or_else(|| panic!("{id} is a variable"))
}

fn value(model: &mut Model, id: &str) -> f64 {
    let index = index(model, id);
    model.get(index).expect("closes")
}

fn moving() -> impl Iterator<Item = (String, Scene)> {
    let ready = (READY.into_iter().chain(SINGLE))
        .map(|text| (text.lines().next().unwrap_or_default().to_owned(), parsed(text)));
    let levels = levels::all().filter(|level| *level != "static");
    ready.chain(levels.map(|level| (level.to_owned(), levels::scene(level))))
}

/// Every part that moves has its manoeuvres; luffing goes from one end of its range to the other and meets neither, and
/// what a brake holds is at rest at the end.
#[test]
fn manoeuvres_end_at_rest_within_the_range() {
    for (name, scene) in moving() {
        let (motion, range) = (motion(&scene), *scene.mechanism.motion());
        let mut model = scene.model().expect("built");
        let told =
            model.variables().iter().any(|variable| variable.symbol.id == "v_h") && value(&mut model, "v_h") != 0.0;
        let has = |id: &str| model.variables().iter().any(|variable| variable.symbol.id == id);
        let mut expected = vec!["luff_in", "luff_out"];
        expected.extend(has("M_sl").then_some("slew_and_stop"));
        expected.extend((told || has("M_Mh")).then_some("hoist_and_stop"));
        expected.push("emergency_stop");
        let found: Vec<&str> = motion.manoeuvres.iter().map(|manoeuvre| manoeuvre.id).collect();
        assert_eq!(found, expected, "{name}");
        let far = if has("theta_1") || has("phi") {
            range.to - range.from
        } else {
            0.0
        };
        let mut reached = Vec::new();
        for manoeuvre in &motion.manoeuvres {
            let stops = ["luffing_low", "luffing_high", "slewing_low", "slewing_high", "run_ends"];
            assert!(
                !manoeuvre.events.iter().any(|(_, id)| stops.contains(id)),
                "{name}, {}",
                manoeuvre.id
            );
            for curve in &manoeuvre.curves {
                let points = &curve.pieces[0];
                let [first, last] = [points[0][1], points[points.len() - 1][1]];
                match curve.y.id {
                    "theta_1" | "phi" => {
                        assert!(
                            points.iter().all(|[_, at]| (range.from..=range.to).contains(at)),
                            "{name}"
                        );
                        reached.push((manoeuvre.id, first, last));
                    }
                    "omega_1" | "omega" if has("M_A") => assert_eq!(last, 0.0, "{name}, {}", manoeuvre.id),
                    "omega_sl" | "v_R" => assert_eq!(last, 0.0, "{name}, {}", manoeuvre.id),
                    _ => {}
                }
            }
        }
        // Oil gives way, and a crane that it carries swings on it.
        let near = if has("M_A") { 1e-4 } else { 2e-2 } * far;
        for (id, sign) in [("luff_in", 1.0), ("luff_out", -1.0)] {
            let (_, first, last) = reached.iter().find(|(known, _, _)| *known == id).expect("drawn");
            assert!(
                (sign * (last - first) - 0.96 * far).abs() < near,
                "{name}, {id}: {first} {last}"
            );
        }
    }
}

/// At the start a crane at rest is held by the moment that its weights and its load ask for at rest, as the table of
/// forces at rest has it; in no manoeuvre does the drive give more than the scene's moment, and brake and drive no more
/// than both.
#[test]
fn a_drive_holds_what_rests_and_gives_no_more_than_it_has() {
    for text in READY {
        let scene = parsed(text);
        let motion = motion(&scene);
        let mut still = scene.at("static").model().expect("built");
        let slew = named(&motion, "slew_and_stop");
        still.set(0, slew.start).expect("in the range");
        still.update().expect("closes");
        let holding = value(&mut still, "M_D");
        let (_, told) = slew
            .commands
            .iter()
            .find(|(symbol, _)| symbol.id == "M_A")
            .expect("told");
        assert!((told[0][1] / holding - 1.0).abs() < 1e-9, "{} {holding}", told[0][1]);
        let most = value(&mut scene.model().expect("built"), "M_A");
        for manoeuvre in &motion.manoeuvres {
            for (symbol, told) in &manoeuvre.commands {
                let amounts = told.iter().map(|[_, value]| value.abs());
                assert!(!["M_A", "M_S"].contains(&symbol.id) || amounts.fold(0.0, f64::max) <= most);
            }
        }
    }
}

/// Hoisting, the rope carries at most Q (1 + a/g) and at least Q (1 - a/g).
fn pulls_by_its_acceleration(text: &str) {
    let scene = parsed(text);
    let motion = motion(&scene);
    let mut model = scene.model().expect("built");
    let [weight, gain, g] = ["Q", "a_h", "g"].map(|id| value(&mut model, id));
    let [least, most] = ends(&motion, "S_R", "hoist_and_stop");
    assert!((most / (weight * (1.0 + gain / g)) - 1.0).abs() < 1e-9, "{most}");
    assert!((least / (weight * (1.0 - gain / g)) - 1.0).abs() < 1e-9, "{least}");
}

/// A rope that keeps its length pulls the load up with Q (1 + a/g), and lets it come to rest with Q (1 - a/g), as the
/// crane is held meanwhile.
#[test]
fn a_hoist_pulls_by_its_acceleration() {
    let text = READY[1]
        .replace("c_R = \"2500 kN/m\"", "")
        .replace("d_R = \"30 kN.s/m\"", "");
    let text: String = text
        .lines()
        .filter(|line| !line.starts_with("c_R") && !line.starts_with("d_R"))
        .collect::<Vec<_>>()
        .join("\n");
    pulls_by_its_acceleration(&text);
}

/// The same of single booms, whose brake holds them. The hoist's line to the sheave of a luffing rope stays as it is.
#[test]
fn a_hoist_of_a_single_boom_pulls_by_its_acceleration() {
    for text in SINGLE {
        pulls_by_its_acceleration(text);
    }
}

/// Of a boom on its rope motor and brake give what the tackle pulls, which is never less than nothing; the account of
/// energy closes beside it.
#[test]
fn a_luffing_tackle_pulls_in_every_manoeuvre() {
    let sheet = parsed(SINGLE[0]).sheet();
    let motion = sheet.motion.expect("a chapter of motion");
    for id in ["luff_in", "luff_out", "hoist_and_stop", "emergency_stop"] {
        let [least, most] = ends(&motion, "T_dyn", id);
        assert!(0.0 <= least && least < most, "{id}: {least} {most}");
    }
    let account = sheet.identities.iter().find(|check| check.id == "motion_energy");
    assert!(account.expect("checked").value < 1e-5);
}

/// A crane whose compensated hoist rope pulls the boom up beyond 40 deg, against its upper stop, from where its tackle
/// cannot push it down: it is told no moment that a rope cannot give, and none that the stop would bear.
#[test]
fn a_luffing_tackle_is_told_no_push() {
    let scene = "name = \"Test\"\ntitle = \"Test\"\n[luffing]\nkind = \"rope_compensation\"\nfidelity = \"rigid\"\n\
        Q = \"60 kg\"\nX_8 = \"0 m\"\nl = \"0.128 m\"\n[luffing.dynamics]\nJ_b = \"0 kg.m2\"\nstep = \"2 ms\"\n\
        [luffing.hoist_rope]\nB_x = \"-50 mm\"\nB_y = \"8 mm\"\nh_Q = \"0.1 m\"\nm_h = \"2\"\nm_k = \"8\"\n\
        [luffing.motion]\nfrom = \"-8 deg\"\nto = \"59 deg\"\nstep = \"2 deg\"\nspeed = \"21 deg/s\"\n\
        [luffing.tackle]\nE_x = \"-50 mm\"\nE_y = \"95 mm\"\nm_l = \"9\"\ns_K = \"0.143 m\"\n\
        [luffing.weights]\nG_b = \"58 kg\"\nr_b = \"30 mm\"\n";
    let motion = motion(&parsed(scene));
    for manoeuvre in &motion.manoeuvres {
        let told = manoeuvre.commands.iter().find(|(symbol, _)| symbol.id == "M_A");
        let told = &told.expect("an input").1;
        assert!(
            told.iter().all(|[_, moment]| (0.0..1e3).contains(moment)),
            "{}",
            manoeuvre.id
        );
        let mut points = manoeuvre.curves.iter().flat_map(|curve| curve.pieces.iter().flatten());
        assert!(points.all(|point| point[1].is_finite()), "{}", manoeuvre.id);
    }
    let out = named(&motion, "luff_out");
    assert!(
        out.events.iter().any(|(_, id)| *id == "luffing_high"),
        "{:?}",
        out.events
    );
}

/// From the brake's fall to rest the energy of motion goes into brake, friction and weights: over a way so short that
/// inertia and weights' moment hardly change.
#[test]
fn a_brake_takes_the_energy_of_motion() {
    for level in ["rigid", "rigid with balance"] {
        let scene = levels::scene(level);
        let motion = motion(&scene);
        let stop = named(&motion, "emergency_stop");
        let (_, brake) = stop
            .commands
            .iter()
            .find(|(symbol, _)| symbol.id == "M_S")
            .expect("told");
        let &[time, brake] = brake.iter().find(|[_, moment]| *moment > 0.0).expect("it falls on");
        let curve = |id: &str| &stop.curves.iter().find(|curve| curve.y.id == id).expect("drawn").pieces[0];
        let after = |id: &str| {
            curve(id)
                .iter()
                .find(|[t, _]| *t >= time - 1e-9)
                .expect("drawn then")
                .to_owned()
        };
        let ([at, angle], [_, rate]) = (after("theta_1"), after("omega_1"));
        let rest = curve("theta_1").last().expect("drawn")[1];
        let mut model = scene.model().expect("built");
        model.set(0, f64::midpoint(angle, rest)).expect("in the range");
        let inertia = model.inertia().expect("closes");
        let [viscous, dry] = ["c_v", "M_F"].map(|id| value(&mut model, id));
        let mut still = scene.at("static").model().expect("built");
        still.set(0, f64::midpoint(angle, rest)).expect("in the range");
        still.update().expect("closes");
        let holding = value(&mut still, "M_D");
        // Under an even moment the rate is on average two thirds of the first one over the way.
        let moment = brake + dry + holding * rate.signum() + viscous * rate.abs() * 2.0 / 3.0;
        let (way, expected) = (rest - angle, 0.5 * inertia * rate * rate / moment * rate.signum());
        println!("{level}: at {at} s, {rate} rad/s: {way} {expected}");
        assert!((way / expected - 1.0).abs() < 0.02, "{level}: {way} {expected}");
    }
}

/// The model of the FMU moves so under the same commands, set from outside between its steps.
#[test]
fn commands_over_time_give_the_same_motion_in_the_model_of_the_fmu() {
    // A boom that load and weight draw down is unstable under given moments: what rounding leaves grows with e to the power
    // of t √(k / I), in half a minute a million times.
    let ready = READY.map(|text| (text, f64::INFINITY, 500));
    for (text, until, least) in ready.into_iter().chain(SINGLE.map(|text| (text, 15.0, 100))) {
        let scene = parsed(text);
        for manoeuvre in &motion(&scene).manoeuvres {
            let mut model = scene.model().expect("built");
            for id in ["M_A", "M_S", "M_sl", "M_Bsl", "v_h"] {
                let there = model.variables().iter().position(|variable| variable.symbol.id == id);
                if let Some(index) = there {
                    model.set(index, 0.0).expect("an input");
                }
            }
            model.set(0, manoeuvre.start).expect("in the range");
            let [duration, sample] = manoeuvre.run;
            let samples = (duration.min(until) / sample).round() as u32;
            let mut places: Vec<_> = manoeuvre
                .commands
                .iter()
                .map(|(symbol, told)| (index(&model, symbol.id), told.iter().peekable()))
                .collect();
            let curves: Vec<_> = manoeuvre
                .curves
                .iter()
                .map(|curve| (index(&model, curve.y.id), &curve.pieces[0]))
                .collect();
            let mut compared = 0;
            for i in 0..=samples {
                let time = f64::from(i) * sample;
                for (index, points) in &curves {
                    if let Some([_, seen]) = points.iter().find(|[t, _]| *t == time).filter(|_| i > 0) {
                        let found = model.get(*index).expect("closes");
                        let scale = points.iter().map(|[_, value]| value.abs()).fold(0.0, f64::max);
                        assert!(
                            (found - seen).abs() <= 1e-6 * scale,
                            "{}: {} at {time}: {found} {seen}",
                            manoeuvre.id,
                            model.variables()[*index].symbol.id
                        );
                        compared += 1;
                    }
                }
                for (input, told) in &mut places {
                    while let Some([_, value]) = told.next_if(|[from, _]| *from <= time) {
                        model.set(*input, *value).expect("an input");
                    }
                }
                model.advance(time, f64::from(i + 1) * sample).expect("as in the book");
            }
            assert!(compared > least, "{compared}");
        }
    }
}

/// A manoeuvre ends where the model refuses to go on, and tells so: before a hoist has reeled in all of its rope.
#[test]
fn a_manoeuvre_without_enough_rope_ends_early() {
    let text = READY[1]
        .replace("l_R = \"18 m\"", "l_R = \"1 m\"")
        .replace("v_h = \"-0.1 m/s\"", "v_h = \"-0.5 m/s\"");
    let motion = motion(&parsed(&text));
    let hoist = named(&motion, "hoist_and_stop");
    let (time, last) = hoist.events.last().expect("the run ends early");
    let [duration, sample] = hoist.run;
    assert_eq!(*last, "run_ends");
    assert!((time - duration).abs() < sample, "{time} {duration}");
    // 0.5 m/s is reached after 1.25 s and 0.3125 m; 0.6875 m more take 1.375 s.
    assert!((2.5..2.625).contains(time), "{time}");
}

fn amount(manoeuvre: &Manoeuvre, id: &str) -> f64 {
    let energy = &manoeuvre.energy;
    let all = [&energy.given, &energy.stored, &energy.taken];
    let found = all.into_iter().flatten().find(|(symbol, _)| symbol.id == id);
    found.expect("in the account").1
}

/// Without a_h the load has the hoist's speed at once, by a plastic blow, and flies on from it when the hoist stops. In
/// the first blow the hoist gives m v² and half of that is lost; in the second one, when the rope catches the load after
/// 2 v/g, the other half is. What is left is the lift: Q v t.
#[test]
fn a_hoist_that_jumps_gives_blows_and_lifts() {
    let text = READY[1].replace("a_h = \"0.4 m/s2\"\n", "");
    let kept: String = text
        .lines()
        .filter(|line| !line.starts_with("c_R") && !line.starts_with("d_R"))
        .map(|line| format!("{line}\n"))
        .collect();
    let sheet = parsed(&kept).sheet();
    let motion = sheet.motion.expect("a chapter of motion");
    let hoist = named(&motion, "hoist_and_stop");
    let time = motion.ramp.expect("its drives have one").1;
    let lifted = 100e3 * 0.1 * time;
    assert!(
        (amount(hoist, "W_h") / lifted - 1.0).abs() < 1e-6,
        "{}",
        amount(hoist, "W_h")
    );
    assert!((amount(hoist, "Delta_E") / lifted - 1.0).abs() < 1e-6);
    assert!(amount(hoist, "W_blow").abs() < 1e-6 * lifted);
    let when = |id: &str| {
        hoist
            .events
            .iter()
            .find(|(_, event)| *event == id)
            .expect("it happens")
            .0
    };
    let [_, sample] = hoist.run;
    let flight = when("rope_taut") - when("rope_slack");
    assert!((flight - 2.0 * 0.1 / 9.80665).abs() <= sample, "{flight}");
    assert!((when("rope_slack") - time).abs() <= sample);
    let account = sheet.identities.iter().find(|check| check.id == "motion_energy");
    assert!(account.expect("checked").value < 1e-5);
}

/// A boom of 119 kN whose rail balances it all over: 26 MN·m cancel to none, which is judged by what has cancelled.
#[test]
fn a_boom_in_balance_all_over_has_forces_that_agree() {
    let scene = parsed(
        r#"
        name = "Balanced"
        title = "Balanced"

        [balance]
        kind = "curved_rail"
        G_c = "300 kN"
        L_r = "200 m"
        alpha_K = "100 deg"
        phi_0 = "0 deg"
        r_1 = "800 m"
        y_0 = "800 m"

        [luffing]
        fidelity = "swing"
        driven = "boom"
        branch = "left"
        X_1 = "134.884 m"
        X_2 = "100 m"
        X_3 = "152.617 m"
        X_4 = "1 km"
        X_5 = "1 m"
        X_6 = "0 m"
        X_8 = "0 m"
        beta_0 = "1 deg"
        Q = "0 kN"

        [luffing.motion]
        from = "-30 deg"
        to = "-20 deg"
        step = "1 rad"
        speed = "1 deg/s"

        [luffing.weights]
        G_1 = "119.149 kN"
        s_1 = "681.332 m"
        chi_1 = "101.158 deg"
        G_2 = "0 kN"
        s_2 = "74.7004 m"
        chi_2 = "120.711 deg"
        G_3 = "21.2 kN"
        s_3 = "0 m"
        chi_3 = "0 deg"

        [luffing.dynamics]
        J_1 = "0 kg.m2"
        J_2 = "0 kg.m2"
        J_3 = "0 kg.m2"
        l_R = "1 m"
        v_h = "1 m/s"
        "#,
    );
    let identities = scene.sheet().identities;
    let forces = identities.iter().find(|check| check.id == "motion_forces");
    let forces = forces.expect("judged");
    assert!(forces.value < 1e-9, "{}", forces.value);
}

/// What a rope that gives way takes is d_R times the square of its rate: as of a load on a spring and a damper whose
/// other end is drawn up by the hoist's ramp, stays at its speed and is let come to rest, calculated here by itself.
#[test]
fn the_damping_of_a_rope_takes_what_that_of_a_spring_does() {
    let scene = parsed(READY[1]);
    let motion = motion(&scene);
    let hoist = named(&motion, "hoist_and_stop");
    let integral = motion.integrals.iter().find(|integral| integral.symbol.id == "W_R");
    let factors = integral.expect("printed").of.iter().map(|power| &power.factors);
    let ids: Vec<Vec<&str>> = factors
        .map(|all| all.iter().map(|symbol| symbol.id).collect())
        .collect();
    assert!(ids.contains(&vec!["S_Rd", "ddelta_R"]), "{ids:?}");
    let formulas = motion.sections.iter().flat_map(|section| &section.trace.steps);
    let formulas: Vec<&str> = formulas.map(|step| step.symbol.id).collect();
    assert!(
        ids.concat()
            .iter()
            .filter(|id| id.contains("delta") || id.contains("Rd"))
            .all(|id| formulas.contains(id))
    );
    let (mass, stiffness, damping) = (100e3 / 9.80665, 2500e3, 30e3);
    let (speed, gain) = (0.1, 0.4);
    let end = motion.ramp.expect("its drives have one").1 + speed / gain;
    let drawn = |t: f64| match t {
        t if t < speed / gain => gain,
        t if t >= end && t < end + speed / gain => -gain,
        _ => 0.0,
    };
    let (mut stretch, mut rate, mut taken) = (0.0, 0.0, 0.0);
    let step = 1e-5;
    for i in 0..(hoist.run[0] / step) as u32 {
        // Midpoints: the error is 1e-8 of what is found.
        let at = (f64::from(i) + 0.5) * step;
        let change = |x: f64, v: f64| drawn(at) - (stiffness * x + damping * v) / mass;
        let middle = rate + 0.5 * step * change(stretch, rate);
        let there = stretch + 0.5 * step * rate;
        taken += damping * middle * middle * step;
        rate += step * change(there, middle);
        stretch += step * middle;
    }
    let found = amount(hoist, "W_R");
    assert!((found / taken - 1.0).abs() < 2e-3, "{found} {taken}");
}
