//! Level `hydraulic` with a load on a rope that is reeled and goes slack, in the plane and on a crane that
//! slews: against two independent codes (`tests/oracles/hydraulic_rope.py`), and by its energy.

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::dynamics::Coordinate;
use lemnis_models::luffing::moving::hydraulic::{Crane, FIRST, FIXED, Hydraulic, MOST, Modes, PresentCrane};
use lemnis_models::luffing::moving::motion;
use lemnis_models::luffing::moving::space;
use lemnis_models::parts::hoist::{Drum, Hoist, HoistCommand};
use lemnis_models::parts::hydraulics::cylinder::Oil;
use lemnis_models::parts::joint::Bar;
use lemnis_models::parts::solver::rodas::Tolerance;

#[path = "common/crane.rs"]
mod crane;

const ORACLE: &str = include_str!("../../tests/oracles/hydraulic_rope.csv");
const COMMANDS: [(u32, f64); 3] = [(0, 0.5), (60, -0.4), (90, 0.0)];
const ROPE: Pendulum = Pendulum {
    mass: 16e3,
    length: 6.0,
    hoist: Hoist::AT_ONCE,
};
const G: f64 = 9.81;

type System = Hydraulic<MOST>;

fn tolerance(system: &System, relative: f64) -> Tolerance<MOST> {
    let mut absolute = [f64::INFINITY; MOST];
    absolute[..system.states()].fill(1e-3 * relative);
    absolute[2..6].fill(1e6 * relative);
    absolute[6..8].copy_from_slice(&[0.1 * relative, 30.0 * relative]);
    Tolerance { relative, absolute }
}

/// The hoist runs as commanded, at a rate of paying out (m/s), which is state number `place`.
fn wind(present: &mut PresentCrane<MOST>, rate: f64, place: usize) {
    let mut y = present.run.states();
    y[place] = rate;
    present.run.restart(y, FIRST);
    present.modes.drum = Drum::at(rate);
}

/// In the plane, the load at an angle (rad) of the rope.
fn plane(swing: f64, hoist: f64) -> (System, PresentCrane<MOST>) {
    let mut system = crane::hydraulic(Some(ROPE));
    system.hoist = HoistCommand::speed(hoist);
    let mut y = system.resting(65_f64.to_radians(), 20e5).expect("closes");
    y[8] = swing;
    let mut present = PresentCrane::new(y);
    wind(&mut present, hoist, FIXED + 5);
    (system, present)
}

/// On a turntable, the load at angles (rad) of the rope, under a moment (N·m) on slewing.
fn space(load: [f64; 2], hoist: f64, moment: f64) -> (System, PresentCrane<MOST>) {
    let mut system = crane::hydraulic_slewing(Some(ROPE), 5e6);
    (system.hoist, system.slewing.moment) = (HoistCommand::speed(hoist), moment);
    let mut y = system.resting(65_f64.to_radians(), 20e5).expect("closes");
    let mut state = space::SlewingState::resting(y[0], ROPE.length);
    state.put_load(load);
    y[8..].copy_from_slice(&state.y[2..]);
    let mut present = PresentCrane::new(y);
    wind(&mut present, hoist, MOST - 1);
    (system, present)
}

fn run(system: &System, present: &mut PresentCrane<MOST>, relative: f64, duration: f64) {
    let tolerance = tolerance(system, relative);
    system
        .advance(present, &tolerance, duration, 1.0)
        .expect("stays within the range");
}

/// Angles of boom and slewing, pressures of the chambers, load from the head.
fn seen(system: &System, y: &[f64; MOST]) -> [f64; 7] {
    match system.crane {
        Crane::Plane(_) => {
            let (sin, cos) = Calc::sin_cos(y[8]);
            [y[0], 0.0, y[4], y[5], y[11] * sin, -y[11] * cos, 0.0]
        }
        Crane::Slewing(_) => [y[0], y[8], y[4], y[5], y[10], y[11], y[12]],
    }
}

/// Through free fall, blow and swing, at every tolerance: the errors fall with it.
#[test]
fn a_load_that_falls_and_is_caught_meets_its_reference() {
    let cases = [
        ("plane", plane(115_f64.to_radians(), -0.3)),
        ("slewing", space([0.4, -125_f64.to_radians()], 0.25, 8e5)),
    ];
    for (case, (system, start)) in cases {
        let rows: Vec<Vec<f64>> = (ORACLE.lines())
            .filter_map(|line| line.strip_prefix(case))
            .map(|line| line.split(',').skip(1).map(|x| x.parse().expect("a number")).collect())
            .collect();
        assert_eq!(rows.len(), 125);
        // Greatest errors of angles (rad), pressures (bar) and the load (m).
        for (relative, bounds) in [
            (1e-5, [1e-5, 1e-2, 1e-4]),
            (1e-7, [1e-8, 1e-4, 1e-6]),
            (1e-9, [1e-10, 1e-6, 1e-8]),
        ] {
            let (mut system, mut present) = (system.clone(), start);
            let (mut worst, mut slack) = ([0.0_f64; 3], 0);
            for (i, row) in (0..).zip(&rows) {
                if let Some(&(_, command)) = COMMANDS.iter().find(|(at, _)| *at == i) {
                    system.command = command;
                    present.run.interrupt(FIRST);
                }
                run(&system, &mut present, relative, 0.02);
                let found = seen(&system, &present.run.states());
                for (j, (found, expected)) in found.iter().zip(&row[1..]).enumerate() {
                    let (kind, unit) = [(0, 1.0), (1, 1e5), (2, 1.0)][[0, 0, 1, 1, 2, 2, 2][j]];
                    worst[kind] = worst[kind].max((found - expected).abs() / unit);
                }
                assert_eq!(present.modes.taut, row[8] == 1.0, "{case} at {} s", row[0]);
                slack += u32::from(!present.modes.taut);
            }
            let shown = worst.map(|x| format!("{x:.1e}"));
            println!("{case} {relative:e}: {shown:?}, {slack} slack, {:?}", present.run.count);
            assert!(slack > 20 && slack < 110, "slack and caught again");
            for (error, bound) in worst.iter().zip(bounds) {
                assert!(*error <= bound, "{case} {relative:e}: {worst:?}");
            }
        }
    }
}

/// Work of pump, hoist and slewing drive = what crane and oil store + what edges, lines, relief valves, gaps and
/// friction take + what the blow of the rope takes, which is at least nothing.
#[test]
fn work_is_stored_or_dissipated() {
    let cases = [
        ("plane", plane(0.5, -0.4)),
        ("plane, slack", plane(115_f64.to_radians(), -0.3)),
        ("slewing", space([0.4, 0.3], -0.4, 8e5)),
        ("slewing, slack", space([0.4, -125_f64.to_radians()], 0.25, 8e5)),
    ];
    for (case, (mut system, mut present)) in cases {
        system.command = 0.6;
        let friction = [2e4, if case.starts_with("slewing") { 3e5 } else { 0.0 }];
        if let Crane::Slewing(crane) = &mut system.crane {
            crane.joints[1].friction.viscous = friction[1];
        }
        system.event(&mut present).expect("closes");
        let (h, first) = (1e-3, energy(&system, &present));
        let (mut sums, mut lost, mut blows) = ([0.0; 2], 0.0, 0);
        for _ in 0..1500 {
            let (before, start) = (present.modes, present.run.states());
            let mut half = present;
            run(&system, &mut half, 1e-10, h / 2.0);
            run(&system, &mut present, 1e-10, h);
            let ends = [
                (before, start),
                (half.modes, half.run.states()),
                (present.modes, present.run.states()),
            ];
            let powers = ends.map(|(modes, y)| powers(&system, modes, &y, friction));
            if before == present.modes && half.modes == before {
                for (i, sum) in sums.iter_mut().enumerate() {
                    *sum += h / 6.0 * (powers[0][i] + 4.0 * powers[1][i] + powers[2][i]);
                }
                continue;
            }
            // Across an event the energy of this very step is left out: it is what a blow takes, but for a step's work.
            let before = PresentCrane {
                modes: before,
                ..PresentCrane::new(start)
            };
            let taken = energy(&system, &before) - energy(&system, &present);
            assert!(taken > -1e3, "{case}: a blow gave {taken} J");
            (lost, blows) = (lost + taken, blows + 1);
        }
        let gained = energy(&system, &present) - first;
        let missing = gained + sums[1] + lost - sums[0];
        println!(
            "{case}: work {:.1} J, stored {gained:.1} J, dissipated {:.1} J, in {blows} steps with events {lost:.1} J, \
             missing {missing:.1e} J",
            sums[0], sums[1]
        );
        assert_eq!(blows > 0, case.ends_with("slack"));
        assert!(missing.abs() < 1e-6 * (sums[0].abs() + sums[1]), "{case}: {missing}");
    }
}

/// Of the crane, in J.
fn energy(system: &System, present: &PresentCrane<MOST>) -> f64 {
    let y = present.run.states();
    match &system.crane {
        Crane::Plane(crane) => {
            let mut state = motion::MotionState::resting(y[0], 0.0);
            state.y[1] = y[1];
            state.y[2..].copy_from_slice(&y[FIXED..FIXED + 6]);
            (state.joints[0], state.taut) = (Bar::Loose, present.modes.taut);
            crane.energy(&state).expect("closes")
        }
        Crane::Slewing(crane) => {
            let mut state = space::SlewingState::resting(y[0], 0.0);
            state.y[1] = y[1];
            state.y[2..].copy_from_slice(&y[FIXED..]);
            state.taut = present.modes.taut;
            crane.energy(&state).expect("closes")
        }
    }
}

/// Power that goes in, and what is stored by compression or lost, in W.
fn powers(system: &System, modes: Modes, y: &[f64; MOST], [viscous, turning]: [f64; 2]) -> [f64; 2] {
    let oil: Oil<f64> = System::oil(y);
    let flows = system.cylinder.flows(&oil, system.supply);
    let rates = system.equations(modes, y).expect("closes");
    let r = f64::reduced(system.dynamics(), y[0]).expect("closes");
    let volumes = system.cylinder.volumes(r.drive[0]);
    let modulus = system.cylinder.bulk_modulus;
    let compression = system.cylinder.port_volume / modulus * (y[2] * rates[2] + y[3] * rates[3])
        + (volumes[0] * y[4] * rates[4] + volumes[1] * y[5] * rates[5]) / modulus;
    let edges = flows.valve[0] * (system.supply - y[2]) - flows.valve[1] * y[3];
    let lines = flows.line[0] * (y[2] - y[4]) + flows.line[1] * (y[3] - y[5]);
    let relief = flows.relief[0] * y[2] + flows.relief[1] * y[3];
    let leakage = flows.leakage * (y[4] - y[5]);
    let slews = matches!(system.crane, Crane::Slewing(_));
    let rate = if slews { y[9] } else { 0.0 };
    let pull = system.rope_force(modes, y).expect("closes");
    [
        // A rope that is paid out takes its load's force along.
        system.supply * flows.valve[0] - pull * system.hoist.speed + system.slewing.moment * rate,
        compression + edges + lines + relief + leakage + viscous * y[1] * y[1] + turning * rate * rate,
    ]
}

/// A slewing joint that sticks under its brake does so to the last bit while boom and load move; released it goes.
#[test]
fn slewing_truly_sticks_on_a_moving_boom() {
    let (mut system, mut present) = space([0.2, 0.3], 0.1, 1e5);
    system.slewing.brake = f64::INFINITY;
    system.command = 0.4;
    run(&system, &mut present, 1e-6, 1.0);
    let y = present.run.states();
    assert_eq!((y[8], y[9], present.modes.joints[1]), (0.0, 0.0, Bar::Held));
    assert!(y[1].abs() > 0.01, "the boom moves");
    let friction = system.slewing_friction(present.modes, &y).expect("closes");
    assert!(friction.abs() > 1e4, "the swinging load pulls at the brake: {friction}");
    system.slewing.brake = 0.0;
    present.run.interrupt(FIRST);
    run(&system, &mut present, 1e-6, 1.0);
    assert!(present.run.states()[8].abs() > 1e-3 && present.modes.joints[1] != Bar::Held);
    // A brake that is strong but not endless: it comes to rest, and stays there to the last bit.
    system.slewing.brake = 5e6;
    system.slewing.moment = 0.0;
    present.run.interrupt(FIRST);
    run(&system, &mut present, 1e-6, 3.0);
    let stopped = present.run.states()[8];
    assert_eq!(present.modes.joints[1], Bar::Held);
    run(&system, &mut present, 1e-6, 1.0);
    assert_eq!(present.run.states()[8], stopped);
}

/// With the slewing brake on and the load in the plane, the crane that slews is the one that does not.
#[test]
fn in_the_plane_it_is_the_crane_that_does_not_slew() {
    for swing in [0.4, 115_f64.to_radians()] {
        let (mut flat, mut a) = plane(swing, -0.3);
        let (mut wide, mut b) = space([swing, 0.0], -0.3, 0.0);
        wide.slewing.brake = f64::INFINITY;
        (flat.command, wide.command) = (0.5, 0.5);
        for _ in 0..100 {
            run(&flat, &mut a, 1e-9, 0.02);
            run(&wide, &mut b, 1e-9, 0.02);
            let [p, q] = [seen(&flat, &a.run.states()), seen(&wide, &b.run.states())];
            for (i, (p, q)) in p.iter().zip(q).enumerate() {
                let unit = if i == 2 || i == 3 { 1e7 } else { 1.0 };
                assert!((p - q).abs() < 1e-6 * unit, "{i}: {p} {q}");
            }
            assert_eq!(a.modes.taut, b.modes.taut);
        }
    }
}

/// Slow small swing of a rope that is reeled in: the adiabatic invariant makes it grow as l^(-3/4).
#[test]
fn a_shorter_rope_swings_wider() {
    let mut system = crane::hydraulic(Some(Pendulum {
        mass: 1.0,
        length: 40.0,
        hoist: Hoist::AT_ONCE,
    }));
    system.hoist = HoistCommand::speed(-0.02);
    let mut y: [f64; MOST] = system.resting(90_f64.to_radians(), 20e5).expect("closes");
    y[8] = 0.01;
    // Nothing leaks: the boom stays where it is.
    system.cylinder.leakage = 0.0;
    let mut present = PresentCrane::new(y);
    wind(&mut present, system.hoist.speed, FIXED + 5);
    run(&system, &mut present, 1e-7, 1500.0);
    let y = present.run.states();
    assert!((y[10] - 10.0).abs() < 1e-9 && y[10] == y[11], "{}", y[10]);
    let amplitude = (y[8] * y[8] + y[9] * y[9] * 10.0 / G).sqrt();
    let expected = 0.01 * 4_f64.sqrt() * 4_f64.sqrt().sqrt();
    assert!((amplitude / expected - 1.0).abs() < 5e-3, "{amplitude} {expected}");
}
