//! Level `hydraulic`: the stiff luffing cylinder, against two independent codes that agree within
//! 2e-7 bar (`tests/oracles/hydraulic_cylinder.py`), by its energy, and by its cost.

use std::time::Instant;

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::hydraulic::{Hydraulic, Modes, Piece};
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::parts::hydraulics::throttle::root;
use lemnis_models::parts::solver::rodas::{Run, SolverStep, Tolerance};
use lemnis_models::parts::solver::{Count, Halt, System, runge_kutta};

#[path = "common/crane.rs"]
mod crane;

const ORACLE: &str = include_str!("../../tests/oracles/hydraulic_cylinder.csv");

/// The command of the valve, as in the reference: from a step's number on.
const COMMANDS: [(u32, f64); 3] = [(0, 0.5), (1200, -0.4), (1800, 0.0)];

/// Friction at the driven bar, in N·m·s/rad.
const VISCOUS: f64 = 2e4;

/// First step after a change of the command, in s.
const FIRST: f64 = 1e-3;

fn tolerance(relative: f64) -> Tolerance<8> {
    let scale = [1e-3, 1e-3, 1e6, 1e6, 1e6, 1e6, 0.1, 30.0];
    Tolerance {
        relative,
        absolute: scale.map(|x| relative * x),
    }
}

fn start() -> (Hydraulic<8>, [f64; 8]) {
    let system = crane::hydraulic(None);
    let y = system.resting(65_f64.to_radians(), 20e5).expect("closes");
    (system, y)
}

/// For the solver; with nothing that sticks or goes slack all of the way is one piece.
fn way<const N: usize>(system: &Hydraulic<N>) -> Piece<'_, N> {
    system.between(Modes::AT_REST)
}

/// The cylinder, whose solver knows of no kink.
struct Smooth<'a>(Piece<'a, 8>);

impl System<8> for Smooth<'_> {
    fn rates(&self, y: &[f64; 8]) -> Option<[f64; 8]> {
        self.0.rates(y)
    }
    fn jacobian(&self, y: &[f64; 8]) -> Option<([f64; 8], [[f64; 8]; 8])> {
        self.0.jacobian(y)
    }
}

/// 2.5 s in communication steps of 1 ms; the states at every one go to `seen`.
fn simulate(tolerance: &Tolerance<8>, seen: impl FnMut(u32, &[f64; 8])) -> Run<8> {
    simulate_by(&located, tolerance, seen)
}

/// How a run gets over a communication step.
type Advance = dyn Fn(&mut Run<8>, &Hydraulic<8>, &Tolerance<8>) -> Result<(), Halt>;

fn located(run: &mut Run<8>, system: &Hydraulic<8>, tolerance: &Tolerance<8>) -> Result<(), Halt> {
    run.advance(&way(system), tolerance, 1e-3, 1.0)
}

fn not_located(run: &mut Run<8>, system: &Hydraulic<8>, tolerance: &Tolerance<8>) -> Result<(), Halt> {
    run.advance(&Smooth(way(system)), tolerance, 1e-3, 1.0)
}

fn simulate_by(advance: &Advance, tolerance: &Tolerance<8>, mut seen: impl FnMut(u32, &[f64; 8])) -> Run<8> {
    let (mut system, y) = start();
    let mut run = Run::new(y, FIRST);
    for step in 0..2500 {
        if let Some(&(_, command)) = COMMANDS.iter().find(|(at, _)| *at == step) {
            system.command = command;
            run.interrupt(FIRST);
        }
        advance(&mut run, &system, tolerance).expect("stays within the range");
        seen(step + 1, &run.states());
    }
    run
}

/// Greatest error of a chamber's pressure (bar), and the solver's work.
fn error(advance: &Advance, tolerance: &Tolerance<8>) -> (f64, Count) {
    let rows: Vec<Vec<f64>> = ORACLE
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    let (mut worst, mut at) = (0.0_f64, 0);
    let run = simulate_by(advance, tolerance, |step, y| {
        let row = &rows[at.min(rows.len() - 1)];
        if (row[0] * 1e3).round() == f64::from(step) {
            worst = worst.max((y[4] - row[2]).abs()).max((y[5] - row[3]).abs());
            at += 1;
        }
    });
    assert_eq!(at, rows.len(), "every row was compared");
    (worst / 1e5, run.count)
}

/// Time (s, the best of several rounds), steps and greatest error (bar).
fn measure(relative: f64) -> (f64, u32, f64) {
    let tolerance = tolerance(relative);
    let (worst, count) = error(&located, &tolerance);
    let mut best = f64::INFINITY;
    for _ in 0..200 {
        let clock = Instant::now();
        let mut sum = 0.0;
        simulate(&tolerance, |_, y| sum += y[4]);
        assert!(sum.is_finite());
        best = best.min(clock.elapsed().as_secs_f64());
    }
    (best / 2.5, count.steps, worst)
}

#[test]
fn the_stiff_cylinder_meets_its_reference() {
    println!("tolerance  steps  error/bar  time per simulated second/us");
    let cases = [
        (2.5e-4, 130, 0.1),
        (1e-4, 160, 0.1),
        (1e-5, 280, 5e-3),
        (2e-6, 400, 1e-3),
        (1e-6, 470, 1e-3),
        (1e-8, 2000, 1e-5),
    ];
    for (relative, most_steps, bound) in cases {
        let (time, steps, error) = measure(relative);
        println!("{relative:9.1e} {steps:6} {error:10.1e} {:10.1}", time * 1e6);
        assert!(error <= bound, "{relative:e}: {error:e} bar");
        assert!(steps <= most_steps, "{relative:e}: {steps} steps");
    }
}

/// Steps that end at the spool's middle and where relief valves open divide the error by one and a half, in the
/// mean of many tolerances, for three steps more in a hundred; and they are few.
#[test]
fn kinks_are_located() {
    let (mut gain, mut work) = (0.0, [0; 2]);
    let tolerances = [6e-4, 4.5e-4, 3e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6, 1e-6, 5e-7];
    println!("tolerance  error/bar located, not  tried steps, not");
    for relative in tolerances {
        let tolerance = tolerance(relative);
        let ((located, count), (not, smooth)) = (error(&located, &tolerance), error(&not_located, &tolerance));
        let tried = [
            count.steps + count.rejected + count.kinks,
            smooth.steps + smooth.rejected,
        ];
        println!(
            "{relative:9.1e} {located:9.1e} {not:9.1e} {:5} {:5}; {} at kinks",
            tried[0], tried[1], count.kinks
        );
        assert!((5..=20).contains(&count.kinks) && smooth.kinks == 0, "{count:?}");
        gain += (not / located).log2() / tolerances.len() as f64;
        work = [work[0] + tried[0], work[1] + tried[1]];
    }
    println!("error divided by {:.2}, work {work:?}", gain.exp2());
    assert!(gain.exp2() > 1.4 && 100 * work[0] < 105 * work[1]);
}

/// At rest, with the oil between port and chamber laminar, an eigenvalue lies beyond -1e6 1/s.
#[test]
fn it_is_stiff_and_explicit_steps_fail() {
    let (system, y) = start();
    let (_, jacobian) = way(&system).jacobian(&y).expect("closes");
    let trace: f64 = (0..8).map(|i| jacobian[i][i]).sum();
    assert!(trace < -2e6, "{trace}");
    // Far beyond 2.8/|lambda|, the explicit method gives numbers that mean nothing, or none.
    let mut system = system;
    system.command = 0.5;
    let mut explicit = Some(y);
    for _ in 0..100 {
        explicit = explicit.and_then(|y| runge_kutta::step(&y, 1e-3, |y| way(&system).rates(y)));
    }
    let mut run = Run::new(y, FIRST);
    run.advance(&way(&system), &tolerance(1e-8), 0.1, 1.0).expect("solves");
    let far = explicit.is_none_or(|y| (y[4] - run.states()[4]).abs() > 1e5);
    assert!(far, "{explicit:?}");
}

/// Exact derivatives against differences of the rates, at a lively state.
#[test]
fn the_jacobian_is_that_of_the_rates() {
    let (mut system, y) = start();
    system.command = 0.5;
    let mut run = Run::new(y, FIRST);
    run.advance(&way(&system), &tolerance(1e-6), 0.02, 1.0).expect("solves");
    let y = run.states();
    let (rates, jacobian) = way(&system).jacobian(&y).expect("closes");
    for (dual, plain) in rates.iter().zip(way(&system).rates(&y).expect("closes")) {
        assert!((dual - plain).abs() <= 1e-14 * plain.abs(), "{dual} {plain}");
    }
    let scale = [1e-1, 1e-1, 1e6, 1e6, 1e6, 1e6, 1e-1, 1e1];
    for j in 0..8 {
        let h = 1e-5 * scale[j];
        let shifted = |sign: f64| {
            let mut y = y;
            y[j] += sign * h;
            way(&system).rates(&y).expect("closes")
        };
        let (up, down) = (shifted(1.0), shifted(-1.0));
        for i in 0..8 {
            let difference = (up[i] - down[i]) / (2.0 * h);
            // Rounding of the rates over the step, and the step's square.
            let allowed = 1e-6 * difference.abs() + 1e-13 * rates[i].abs().max(up[i].abs()) / h + 1e-9;
            assert!(
                (jacobian[i][j] - difference).abs() <= allowed.max(1e-6 * jacobian[i][j].abs()),
                "{i} {j}: {} {difference}",
                jacobian[i][j]
            );
        }
    }
}

/// Work of the pump = what the mechanism stores + what the oil stores by compression + what is lost
/// in edges, lines, relief valves, gaps and friction; every share an integral of its own.
#[test]
fn work_of_the_pump_is_stored_or_dissipated() {
    let (mut system, y) = start();
    system.command = 0.6;
    // Low enough that the relief valves open as well.
    system.cylinder.relief[0] = 60e5;
    let powers = |y: &[f64; 8]| {
        let oil = Hydraulic::<8>::oil(y);
        let flows = system.cylinder.flows(&oil, system.supply);
        let rates = way(&system).rates(y).expect("closes");
        let r = <f64 as lemnis_models::luffing::moving::dynamics::Coordinate>::reduced(system.dynamics(), y[0])
            .expect("closes");
        let volumes = system.cylinder.volumes(r.drive[0]);
        let compression = system.cylinder.port_volume / system.cylinder.bulk_modulus
            * (y[2] * rates[2] + y[3] * rates[3])
            + (volumes[0] * y[4] * rates[4] + volumes[1] * y[5] * rates[5]) / system.cylinder.bulk_modulus;
        let edges = flows.valve[0] * (system.supply - y[2]) - flows.valve[1] * y[3];
        let lines = flows.line[0] * (y[2] - y[4]) + flows.line[1] * (y[3] - y[5]);
        let relief = flows.relief[0] * y[2] + flows.relief[1] * y[3];
        let leakage = flows.leakage * (y[4] - y[5]);
        let friction = VISCOUS * y[1] * y[1];
        [
            system.supply * flows.valve[0],
            compression,
            edges,
            lines,
            relief,
            leakage,
            friction,
        ]
    };
    let energy = |y: &[f64; 8]| {
        system
            .dynamics()
            .energy(&Phase {
                theta: y[0],
                omega: y[1],
                swing: 0.0,
                swing_rate: 0.0,
            })
            .expect("closes")
    };
    // Simpson's rule over steps of the fourth order.
    let (h, mut y, first, mut sums) = (2e-5, y, energy(&y), [0.0; 7]);
    for _ in 0..20_000 {
        let step = SolverStep::new(&way(&system), &y, h).expect("solves");
        let ends = [powers(&step.from), powers(&step.at(0.5)), powers(&step.to)];
        for (i, sum) in sums.iter_mut().enumerate() {
            *sum += h / 6.0 * (ends[0][i] + 4.0 * ends[1][i] + ends[2][i]);
        }
        y = step.to;
    }
    let [work, shares @ ..] = sums;
    let balance = energy(&y) - first + shares.iter().sum::<f64>() - work;
    println!(
        "work {work:.1} J, mechanism {:.1} J, shares {shares:.1?} J, missing {balance:.1e} J",
        energy(&y) - first
    );
    assert!(shares[3] > 0.0, "a relief valve opened");
    assert!(
        shares.iter().skip(1).all(|share| *share >= 0.0),
        "nothing gives energy: {shares:?}"
    );
    assert!(balance.abs() < 1e-6 * work, "{balance}");
}

/// Fourth order in the states, third in between, on a problem with a known solution.
#[test]
fn the_orders_are_those_of_the_method() {
    /// y₁′ = −y₂, y₂′ = y₁, stiffly followed: y₃′ = −1000 (y₃ − y₁ y₂).
    struct Known;
    impl Known {
        fn equations<C: Calc>([a, b, c]: &[C; 3]) -> [C; 3] {
            [-*b, *a, C::constant(-1000.0) * (*c - *a * *b) + *a * *a - *b * *b]
        }
    }
    impl System<3> for Known {
        fn rates(&self, y: &[f64; 3]) -> Option<[f64; 3]> {
            Some(Known::equations(y))
        }
        fn jacobian(&self, y: &[f64; 3]) -> Option<([f64; 3], [[f64; 3]; 3])> {
            let out = Known::equations(&lemnis_models::parts::solver::Gradient::states(y));
            Some((out.map(|x| x.re), out.map(|x| x.by)))
        }
    }
    let error = |steps: u32| {
        let (h, mut y, mut inner) = (1.0 / f64::from(steps), [1.0, 0.0, 0.0], 0.0_f64);
        for i in 0..steps {
            let step = SolverStep::new(&Known, &y, h).expect("solves");
            let (sin, cos) = Calc::sin_cos((f64::from(i) + 0.3) * h);
            let between = step.at(0.3);
            inner = inner.max((between[0] - cos).abs()).max((between[1] - sin).abs());
            y = step.to;
        }
        let (sin, cos) = Calc::sin_cos(1.0_f64);
        ((y[0] - cos).abs().max((y[1] - sin).abs()), inner)
    };
    let (coarse, fine) = (error(10), error(20));
    let orders = [(coarse.0 / fine.0).log2(), (coarse.1 / fine.1).log2()];
    println!("orders {orders:?}");
    assert!(orders[0] > 3.7 && orders[1] > 3.5, "{orders:?}");
}

/// What was saved and read back goes on with the same bits, between communication points of the solver too.
#[test]
fn a_run_continues_with_the_same_bits() {
    let (mut system, y) = start();
    system.command = 0.5;
    let mut run = Run::new(y, FIRST);
    run.advance(&way(&system), &tolerance(1e-6), 0.0137, 1.0)
        .expect("solves");
    let numbers: Vec<f64> = run.numbers().collect();
    let mut again = Run::of(&numbers).expect("as many numbers");
    assert!(Run::<8>::of(&numbers[1..]).is_none());
    for _ in 0..100 {
        run.advance(&way(&system), &tolerance(1e-6), 0.7e-3, 1.0)
            .expect("solves");
        again
            .advance(&way(&system), &tolerance(1e-6), 0.7e-3, 1.0)
            .expect("solves");
    }
    assert_eq!(run.states().map(f64::to_bits), again.states().map(f64::to_bits));
}

/// Friction in the laminar range of an edge is smooth, and beyond it the root.
#[test]
fn an_edge_passes_the_root_of_the_difference() {
    assert_eq!(root(0.0_f64), 0.0);
    for p in [1e6, 35e5, 3e7] {
        assert!((root(p) / Calc::sqrt(p) - 1.0).abs() < 2e-4);
        assert_eq!(root(-p), -root(p));
    }
}
