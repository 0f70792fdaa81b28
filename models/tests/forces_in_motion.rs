//! Forces of the motion: at rest those of statics; equilibrium of every body with accelerations of its places, as they
//! change with the time; the moment on the driven bar by Newton and Euler against that of the drive, from which
//! Lagrange's equations made the accelerations; a load that is hoisted up against a heavier one at rest.

use std::collections::BTreeMap;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::variable::Role;
use lemnis_models::luffing::double_link::forces_in_motion::{ForcesInMotion, RESULTS};
use lemnis_models::luffing::double_link::geometry::Geometry;
use lemnis_models::luffing::double_link::linkage::{Bodies, HeavyLinkage};
use lemnis_models::luffing::double_link::pose::Posing;
use lemnis_models::luffing::double_link::position::Position;
use lemnis_models::luffing::double_link::scene::Luffing;
use lemnis_models::luffing::moving::bodies::{Body, Pendulum};
use lemnis_models::luffing::moving::given::{Inputs, MOST_STATES};
use lemnis_models::luffing::moving::hydraulic::{self, Modes, PresentCrane};
use lemnis_models::luffing::moving::level::{CraneAt, Level, MotionResult};
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::luffing::moving::shares::Instant;
use lemnis_models::luffing::moving::shares::Shares;
use lemnis_models::luffing::moving::space::SlewingState;
use lemnis_models::luffing::moving::weather::Weather;
use lemnis_models::parts::hoist::HoistCommand;
use lemnis_models::parts::joint::{Bar, Friction, Joint, JointDrive};
use lemnis_models::parts::plane::{Point, cross};
use lemnis_models::scene::{DEFAULT, Scene};
use num_dual::Dual2;
use proptest::prelude::*;

#[path = "common/balances.rs"]
mod balances;
#[path = "common/crane.rs"]
mod crane;
#[path = "common/levels.rs"]
mod levels;

const G: f64 = 9.81;
const NOTHING: JointDrive = JointDrive {
    moment: 0.0,
    brake: 0.0,
};

fn index(model: &Model, name: &str) -> Option<usize> {
    model.variables().iter().position(|v| v.name() == name)
}

fn model(text: &str) -> Model {
    let scene = Scene::parse(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    scene.model().expect("built")
}

/// Every balance with either bar driven, and the default crane; levers with the arm of their counterweight. All with a
/// drive, and held by a brake alone.
fn scenes() -> Vec<(String, String)> {
    let armed = |text: String| {
        if text.contains("kind = \"lever\"") && !text.contains("s_5") {
            text.replace("M_5 = \"984.8 kN.m\"", "M_5 = \"984.8 kN.m\"\ns_5 = \"3 m\"")
        } else {
            text
        }
    };
    let bare = DEFAULT[..DEFAULT.find("[luffing.published]").expect("there")].to_owned();
    let all = balances::every_kind().into_iter().map(armed).chain([bare]);
    all.map(|text| {
        let dynamics = "\n[luffing.dynamics]\nJ_1 = \"900000 kg.m2\"\nJ_2 = \"200000 kg.m2\"\nJ_3 = \"100000 kg.m2\"\n\
                        M_S = \"1e9 kN.m\"\n\n[luffing.drive]";
        let moving = text
            .replace("driven = ", "fidelity = \"rigid\"\ndriven = ")
            .replace("\n[luffing.drive]", dynamics);
        assert!(moving.contains("M_S = \"1e9") && moving.contains("fidelity"));
        (text, moving)
    })
    .collect()
}

/// At rest, without friction, to 1e-12 of the greatest force.
#[test]
fn at_rest_they_are_those_of_statics() {
    let mut compared = 0;
    for (still, moving) in scenes() {
        let swinging = moving
            .replace("fidelity = \"rigid\"", "fidelity = \"swing\"")
            .replace("M_S = ", "l_R = \"9 m\"\nM_S = ");
        let mut still = model(&still);
        for mut moving in [model(&moving), model(&swinging)] {
            let (from, to) = (moving.positions()[0], *moving.positions().last().expect("positions"));
            for i in 1..10 {
                let theta = from + (to - from) * 0.1 * f64::from(i);
                still.set(0, theta).expect("an angle");
                moving.set(0, theta).expect("an angle");
                still.update().expect("closes");
                moving.update().expect("closes");
                let pairs: Vec<(&str, f64, f64)> = RESULTS
                    .iter()
                    .filter_map(|symbol| {
                        let there = [index(&still, symbol.id)?, index(&moving, symbol.id)?];
                        let at_rest = still.get(there[0]).expect("a force");
                        Some((symbol.id, at_rest, moving.get(there[1]).expect("a force")))
                    })
                    .collect();
                assert!(pairs.len() >= 11, "{pairs:?}");
                for moments in [true, false] {
                    let alike = |id: &str| id.starts_with("M_") == moments;
                    let kind = pairs.iter().filter(|(id, ..)| alike(id));
                    let scale = kind
                        .clone()
                        .fold(0.0_f64, |most, (_, at_rest, _)| most.max(at_rest.abs()));
                    for (id, at_rest, force) in kind {
                        compared += 1;
                        let scale = if moments { scale.max(1e5) } else { scale };
                        assert!(
                            (force - at_rest).abs() <= 1e-12 * scale,
                            "{id} at {theta}: {force} {at_rest}"
                        );
                    }
                }
            }
        }
    }
    assert!(compared > 2000, "{compared}");
}

/// A load hoisted up with 2 m/s² from a boom that is held pulls at every pin as one of Q (1 + 2/g) at rest.
#[test]
fn a_hoisted_load_is_a_heavier_one() {
    let bare = &DEFAULT[..DEFAULT.find("[luffing.published]").expect("there")];
    let dynamics = "\n[luffing.dynamics]\nJ_1 = \"900000 kg.m2\"\nJ_2 = \"200000 kg.m2\"\nJ_3 = \"100000 kg.m2\"\n\
                    M_S = \"1e9 kN.m\"\nl_R = \"10 m\"\na_h = \"2 m/s2\"\nv_h = \"-1.5 m/s\"\n\n[luffing.drive]";
    let swinging = bare
        .replace("driven = ", "fidelity = \"swing\"\ndriven = ")
        .replace("\n[luffing.drive]", dynamics);
    let heavier = bare.replace("Q = \"160 kN\"", &format!("Q = \"{:?} kN\"", 160.0 * (1.0 + 2.0 / G)));
    let (mut moving, mut still) = (model(&swinging), model(&heavier));
    assert_ne!(bare, heavier);
    moving.update().expect("begins");
    still.set(0, moving.get(0).expect("an angle")).expect("an angle");
    still.update().expect("closes");
    let names = [
        "F_B.x", "F_B.y", "F_C.x", "F_O1.x", "F_O1.y", "F_O3.x", "F_O3.y", "N_3", "M_D", "F_d",
    ];
    for name in names {
        let [up, at_rest] = [&mut moving, &mut still].map(|model| {
            let index = index(model, name).expect("there");
            model.get(index).expect("a force")
        });
        assert!((up - at_rest).abs() < 1e-9 * at_rest.abs(), "{name}: {up} {at_rest}");
    }
}

fn inputs(moment: f64, brake: f64) -> Inputs {
    Inputs {
        drives: [JointDrive { moment, brake }, NOTHING],
        hoist: HoistCommand::speed(0.0),
        valve: 0.0,
        supply: 250e5,
        wind: [0.0; 2],
        torn: [0.0; 2],
        braking: 0.0,
        weather: Weather::calm(),
        shaft: 0.0,
    }
}

fn pendulum(mass: f64) -> Pendulum {
    Pendulum {
        mass,
        ..crane::PENDULUM
    }
}

/// A number with its first and second derivative by the time.
type Moving = Dual2<f64>;

/// Places of the centres of gravity of boom, jib (with what is fixed to it) and rocker, and of joints B, C and head A, as
/// the boom's angle changes.
fn places(theta: Moving, loaded: bool) -> [Point<Moving>; 6] {
    let g = crane::geometry().map(Moving::from_re);
    let p = Position::new(&g, theta).expect("closes");
    let part = |point: Point<Moving>, of: f64| point.map(|x| x * of);
    let jib = part(p.c + p.a, 0.5);
    let jib = if loaded {
        part(jib, 6.0 / 22.0) + part(p.a, 16.0 / 22.0)
    } else {
        jib
    };
    [part(p.b, 0.5), jib, g.lengths.o3() + part(p.x_3, 0.5), p.b, p.c, p.a]
}

proptest! {
    /// Newton and Euler for every body, with the second derivatives of its places by the time.
    #[test]
    fn every_body_is_in_equilibrium_with_its_inertia(
        theta in 1.1..2.0_f64,
        omega in -0.4..0.4_f64,
        swing in -1.2..1.2_f64,
        rate in -1.0..1.0_f64,
        moment in -5e6..5e6_f64,
        hangs: bool,
        turning in -0.5..0.5_f64,
        slews: bool,
        held: bool,
    ) {
        let omega = if held { 0.0 } else { omega };
        let load = hangs.then(|| pendulum(16e3));
        let mut start = MotionState::resting(theta, 10.0);
        start.y[1..4].copy_from_slice(&[omega, swing, rate]);
        let bar = match omega {
            0.0 => Bar::Held,
            _ if omega > 0.0 => Bar::Forward,
            _ => Bar::Backward,
        };
        start.joints[0] = bar;
        let mut seen = SlewingState::resting(theta, 10.0);
        seen.put_load([swing, 0.0]);
        (seen.y[1], seen.y[3]) = (omega, turning);
        seen.joints = [bar, Bar::Forward];
        let friction = Friction { viscous: 3e4, coulomb: 2e4 };
        let (mut past, mut y) = (Modes::AT_REST, [0.0; MOST_STATES]);
        let (level, turning) = if slews {
            let crane = crane::slewing(load, 5e6, [[3e4, 2e4], [0.0; 2]]);
            past.follow(&seen);
            y[..seen.y.len()].copy_from_slice(&seen.y);
            (Level::Slewing(crane), turning)
        } else {
            let dynamics = crane::dynamics(load);
            let motion = MovingLinkage { dynamics, joints: [Joint { friction, stops: [1.0, 2.1] }] };
            past.follow(&start);
            y[..start.y.len()].copy_from_slice(&start.y);
            (Level::Free(motion), 0.0)
        };
        let now = CraneAt { past, inputs: inputs(moment, if held { 1e8 } else { 1e4 }), y };
        let rates = level.rates(&now).expect("closes");
        let forces = ForcesInMotion::of(&level, &crane::linkage(load), &now).expect("closes");
        let [drive, by_newton] = moments(&forces);
        prop_assert!((drive - by_newton).abs() < 1e-12 * size(&forces), "{drive} {by_newton}");

        let all = places(Moving::new(theta, omega, rates[1]), !hangs);
        let at = all.map(|point| point.map(|x| x.re));
        let acceleration = |i: usize| all[i].map(|x| x.v2) - Point::new((at[i].x + 5.2) * turning * turning, 0.0);
        let pins = forces.pins.expect("not in line");
        let (b, c) = (pins.on_jib.b, pins.on_jib.c);
        let pull = level.reaction(&now, MotionResult::Pull);
        let down = if slews {
            Point::new(y[4], y[5]) / y[10]
        } else {
            let (sin, cos) = Calc::sin_cos(swing);
            Point::new(sin, -cos)
        };
        let pull = if hangs { down * pull.expect("closes") } else { Point::new(0.0, 0.0) };
        let weight = |mass: f64| Point::new(0.0, -mass * G);
        let o3 = crane::geometry().lengths.o3();
        // Mass, forces with their places, and the bar from one end to the other.
        let jib_mass = if hangs { 6e3 } else { 22e3 };
        let bodies = [
            (20e3, vec![(pins.o1, Point::new(0.0, 0.0)), (-b, at[3])], [None, Some(3)], drive),
            (jib_mass, vec![(b, at[3]), (c, at[4]), (pull, at[5])], [Some(4), Some(5)], 0.0),
            (4e3, vec![(pins.o3, o3), (-c, at[4])], [None, Some(4)], 0.0),
        ];
        for (i, (mass, acting, [first, last], moment)) in bodies.into_iter().enumerate() {
            let sum: Point<f64> = acting.iter().map(|(force, _)| *force).sum::<Point<f64>>() + weight(mass);
            let needed = acceleration(i) * mass;
            let scale = acting.iter().map(|(force, _)| force.norm()).fold(mass * G, f64::max);
            prop_assert!((sum - needed).norm() < 1e-12 * scale, "body {i}: {sum} {needed}");
            // About the centre of gravity.
            let foot = if i == 2 { o3 } else { Point::new(0.0, 0.0) };
            let end = |which: Option<usize>| which.map_or(foot.map(Moving::from_re), |which| all[which]);
            let bar = end(last) - end(first);
            let (bar, bend) = (bar.map(|x| x.re), bar.map(|x| x.v2));
            let length = bar.norm();
            // A uniform bar; the load at the jib's head.
            let bar_mass = [20e3, 6e3, 4e3][i];
            let more = mass - bar_mass;
            let inertia = bar_mass * length * length / 12.0 + bar_mass * more / mass * (length / 2.0).powi(2);
            let e = bar / length;
            let deviation = inertia * e.x * e.y;
            let about: f64 = acting.iter().map(|(force, place)| cross(place - at[i], *force)).sum();
            let spin = cross(bar, bend) / (length * length);
            let needed = inertia * spin + deviation * turning * turning - moment;
            prop_assert!((about - needed).abs() < 1e-12 * scale * length, "body {i}: {about} {needed}");
        }
    }

    /// With oil, on a turntable, the load slack or taut: drive, friction and stop against the moving bodies.
    #[test]
    fn the_driven_bar_feels_what_drives_it(
        theta in 0.9..2.2_f64,
        omega in -0.4..0.4_f64,
        place in prop::array::uniform3(-1.0..1.0_f64),
        velocity in prop::array::uniform3(-2.0..2.0_f64),
        turning in -0.4..0.4_f64,
        oil in prop::array::uniform4(1e5..2e7_f64),
        taut: bool,
    ) {
        let load = Some(pendulum(16e3));
        let mut seen = SlewingState::resting(theta, 10.0);
        seen.y[1] = omega;
        seen.y[3] = turning;
        let far = 10.0 / (place[0].powi(2) + (place[1] - 2.0).powi(2) + place[2].powi(2)).sqrt();
        let far = if taut { far } else { 0.9 * far };
        seen.y[4..7].copy_from_slice(&[far * place[0], far * (place[1] - 2.0), far * place[2]]);
        seen.y[7..10].copy_from_slice(&velocity);
        let mut y = [0.0; hydraulic::MOST];
        y[..2].copy_from_slice(&[theta, omega]);
        y[2..6].copy_from_slice(&oil);
        y[8..].copy_from_slice(&seen.y[2..]);
        let mut present = PresentCrane::new(y);
        present.modes.taut = taut;
        present.modes.joints[1] = Bar::Forward;
        let level = Level::Hanging(crane::hydraulic_slewing::<{ hydraulic::MOST }>(load, 5e6));
        let past = present.modes;
        let linkage = crane::linkage(load).with_drive(&crane::ANCHORS);
        let forces = ForcesInMotion::of(&level, &linkage, &CraneAt { past, inputs: inputs(0.0, 0.0), y }).expect("closes");
        let [drive, by_newton] = moments(&forces);
        prop_assert!((drive - by_newton).abs() < 1e-12 * size(&forces), "{drive} {by_newton}");
        // What pushes is the cylinder, along its line.
        let Level::Hanging(system) = &level else { unreachable!() };
        let push = system.cylinder.force(&hydraulic::Hydraulic::<{ hydraulic::MOST }>::oil(&y));
        prop_assert_eq!(forces.f_d, Some(push));
    }
}

/// What turns the driven bar, and what equilibrium of the moving bodies asks for.
fn moments(forces: &ForcesInMotion<f64>) -> [f64; 2] {
    let shares = &forces.at.shares;
    let pins = forces.pins.as_ref().expect("not in line");
    [
        shares.drive + shares.dry + shares.viscous + shares.stop,
        pins.on_jib.m_d,
    ]
}

/// Of what these moments are the difference: the boom's length times the force at B.
fn size(forces: &ForcesInMotion<f64>) -> f64 {
    let pins = forces.pins.as_ref().expect("not in line");
    19.3 * pins.on_jib.b.norm().max(1e5)
}

/// Whatever its counterweight is accelerated by, a balance gives the boom by its rod or rope the moment of the same power,
/// and frame, boom and counterweight keep each other in equilibrium.
#[test]
fn a_balance_in_motion_keeps_power_and_equilibrium() {
    let mut kinds = 0;
    for (text, _) in scenes() {
        let scene = Scene::parse(&text).expect("sound");
        let luffing = scene.mechanism.of::<Luffing>().expect("a luffing mechanism");
        let p = luffing.parameters;
        let Some(form) = &p.balance else { continue };
        let g = Geometry::new(&p).expect("exists");
        let nothing = Body::uniform(0.0, Point::new(0.0, 0.0), Point::new(1.0, 0.0));
        let bodies = Bodies {
            boom: nothing,
            jib: nothing,
            rocker: nothing,
            pendulum: None,
            load: None,
            gravity: G,
        };
        let linkage = HeavyLinkage::new(&g, bodies)
            .with_balance(&p, &luffing.motion)
            .expect("a balance");
        for theta in luffing.motion.angles().into_iter().step_by(3) {
            for (omega, alpha, turning) in [(0.0, 0.0, 0.0), (0.3, -0.7, 0.4), (-0.5, 1.1, 0.0), (0.1, 9.0, 0.9)] {
                let pose = f64::pose(&linkage, theta, None).expect("closes");
                let none = Shares {
                    drive: 0.0,
                    dry: 0.0,
                    viscous: 0.0,
                    stop: 0.0,
                    push: None,
                    lag: 0.0,
                };
                let at = Instant {
                    omega,
                    alpha,
                    turning: Some(turning),
                    pull: None,
                    tension: None,
                    pushed: None,
                    shares: none,
                };
                let balance = ForcesInMotion::new(&pose, &at, G).balance.expect("there");
                // The joint on the boom; a tail's counterweight is where it is itself.
                let boom = pose.position.x_1;
                let direction = f64::direction(boom.x, boom.y);
                let joint = |r: f64, angle: f64| {
                    let (sin, cos) = Calc::sin_cos(direction + angle);
                    Point::new(r * cos, r * sin)
                };
                let mut sizes = BTreeMap::new();
                form.map(&mut |symbol, value: f64| sizes.insert(symbol.id, value));
                let place = match balance.rod {
                    Some(_) => joint(sizes["r_1"], sizes["alpha_K"]),
                    None => joint(sizes["r_c"], sizes["chi_c"] + std::f64::consts::PI),
                };
                let moment = cross(place, balance.on_boom);
                let size = place.norm() * balance.on_boom.norm();
                let near = (moment - balance.moment).abs() < 1e-10 * size;
                assert!(near, "{} at {theta}: {moment} {}", form.kind(), balance.moment);
                kinds += 1;
            }
        }
    }
    assert!(kinds > 500, "{kinds}");
}

/// Brake and dry friction hold a bar in proportion; a stop gives what is left; friction in motion is what it is.
#[test]
fn what_holds_a_bar_is_told_apart() {
    let dynamics = crane::dynamics(None);
    let friction = Friction {
        viscous: 3e4,
        coulomb: 1e6,
    };
    let level = |stops| {
        Level::Free(MovingLinkage {
            dynamics: dynamics.clone(),
            joints: [Joint { friction, stops }],
        })
    };
    let shares = |level: &Level, state: &MotionState, inputs: &Inputs| {
        let (mut past, mut y) = (Modes::AT_REST, [0.0; MOST_STATES]);
        past.follow(state);
        y[..state.y.len()].copy_from_slice(&state.y);
        let inputs = *inputs;
        let forces = ForcesInMotion::of(level, &crane::linkage(None), &CraneAt { past, inputs, y }).expect("closes");
        let it = forces.at.shares;
        [it.drive, it.dry, it.viscous, it.stop]
    };
    let mut state = MotionState::resting(1.3, 10.0);
    let [needed, ..] = shares(&level([1.0, 2.0]), &state, &inputs(0.0, 1e12));
    // Three parts of four by a brake of three times the friction.
    let [brake, dry, viscous, stop] = shares(&level([1.0, 2.0]), &state, &inputs(0.0, 3e6));
    assert!(viscous == 0.0 && stop == 0.0 && (brake / dry - 3.0).abs() < 1e-12);
    assert!((brake + dry - needed).abs() < 1e-5 * needed.abs());
    // Lying on its lower stop, the motor pulling down: friction and brake as much as they can, the stop the rest.
    let [drive, dry, _, stop] = shares(&level([1.3, 2.0]), &state, &inputs(-1e7, 1e5));
    assert!(drive == -1e7 + 1e5 && dry == 1e6 && (drive + dry + stop - needed).abs() < 1e-5 * needed.abs());
    state.y[1] = -0.1;
    state.joints[0] = Bar::Backward;
    assert_eq!(
        shares(&level([1.0, 2.0]), &state, &inputs(5.0, 7.0)),
        [12.0, 1e6, 3e3, 0.0]
    );
}

/// What stays as at rest says so, what does not too; and nothing else does.
#[test]
fn descriptions_tell_rest_from_motion() {
    let (_, moving) = scenes().swap_remove(0);
    let moving = model(&moving);
    for variable in moving.variables() {
        let text = variable.description();
        let (of_motion, at_rest) = (text.contains("In motion:"), text.contains("As at rest:"));
        let statics = [
            "M_Q", "M_G", "M_ur", "dM", "M_sum", "M_D_0", "F_d_0", "M_D_max", "N_3_max", "U_5", "E", "N_max",
        ];
        let name = variable.name();
        if ["F_B.x", "F_O1.y", "N_3", "M_D", "F_d", "N_1", "F_K.x", "F_M.y"].contains(&&*name) {
            assert!(of_motion && !at_rest, "{name}: {text}");
        }
        if statics.contains(&&*name) {
            assert!(at_rest && !of_motion, "{name}: {text}");
        }
        let result = matches!(variable.role, Role::Output | Role::Calculated);
        assert!(result || !(of_motion || at_rest), "{name}: {text}");
    }
}

/// By states, inputs and parameters, against differences: at every level, moving, held, and with a slack rope.
#[test]
fn derivatives_are_those_of_differences() {
    let mut compared = 0;
    for level in levels::all() {
        let mut model = levels::model(level);
        let Some(omega) = index(&model, "der(omega_1)").and(index(&model, "omega_1")) else {
            continue;
        };
        for (rate, phi) in [(0.07, 0.2), (-0.05, -0.3), (0.0, 0.1)] {
            if rate == 0.0 && level.starts_with("hydraulic") {
                // Dry friction of a cylinder's bar is steep there.
                continue;
            }
            model.set(0, 1.37).expect("an angle");
            model.set(omega, rate).expect("a rate");
            if let Some(swing) = index(&model, "phi_R").filter(|at| model.variables()[*at].role == Role::State) {
                model.set(swing, phi).expect("an angle");
            }
            model.start().expect("closes");
            let variables = model.variables().to_vec();
            let forces: Vec<usize> = RESULTS.iter().filter_map(|symbol| index(&model, symbol.id)).collect();
            assert!(forces.len() >= 12, "{level}");
            let known = [
                "theta_1", "omega_1", "M_A", "Q", "X_2", "G_1", "J_2", "s_2", "E_x", "p_A", "omega_sl", "x_Q", "phi_R",
            ];
            for name in known {
                let at = index(&model, name).filter(|at| !matches!(variables[*at].role, Role::Output));
                let Some(at) = at else { continue };
                let value = model.get(at).expect("a value");
                let step = 1e-5 * value.abs().max(0.1);
                let state = model.state();
                let mut tangent = model.tangent(&|other| f64::from(other == variables[at].quantity()));
                let found: Vec<f64> = forces
                    .iter()
                    .map(|force| model.derivative(&mut tangent, *force).expect("smooth here"))
                    .collect();
                let ends = [step, -step].map(|step| {
                    if variables[at].role == Role::State {
                        // As an importer does it: which way a bar goes is not decided anew.
                        let mut states = vec![0.0; model.states()];
                        model.get_states(&mut states);
                        let which = variables[..at].iter().filter(|v| v.role == Role::State).count();
                        states[which] = value + step;
                        model.set_states(&states).expect("near");
                    } else {
                        model.set(at, value + step).expect("near");
                    }
                    let forces: Vec<f64> = forces.iter().map(|i| model.get(*i).expect("a force")).collect();
                    model.set_state(&state);
                    forces
                });
                for (i, force) in forces.iter().enumerate() {
                    let difference = (ends[0][i] - ends[1][i]) / (2.0 * step);
                    let size = ends[0][i].abs().max(1e5) / value.abs().max(0.1);
                    let near = (found[i] - difference).abs() < 1e-5 * size.max(difference.abs());
                    compared += usize::from(difference != 0.0);
                    assert!(
                        near,
                        "{level}: {} by {name}: {} {difference}",
                        variables[*force], found[i]
                    );
                }
            }
        }
    }
    assert!(compared > 1500, "{compared}");
}
