//! Synthesis of the lever counterweight: the construction of [Ports001], the
//! four positions of [Balance004], and optima that beat both.

#[path = "../../tests/common/portal.rs"]
mod portal;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use lemnis_models::balance::Balance;
use lemnis_models::balance::analysis::Analysis;
use lemnis_models::balance::boom::{Boom, Plain};
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::balance::task::{Bounds, Constraints, Criterion, Tolerances};
use lemnis_models::kernel::shared::Watch;
use lemnis_models::luffing::double_link::{self, scene::Luffing};
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::scene::Scene;
use lemnis_synthesis::candidate::Positions;
use lemnis_synthesis::comparison::Comparison;
use lemnis_synthesis::four::Nodes;
use lemnis_synthesis::optimum::{Effort, Found, Limit, Problem, RUNS, front, improve, search};
use lemnis_synthesis::run::{self, run};
use lemnis_synthesis::three;
use lemnis_synthesis::tolerance::{Builds, Spread};
use portal::{boom, lever, oracle, published, rad, range};

/// To the end, and nobody looks.
const ALONE: Watch<'static> = {
    static STOP: AtomicBool = AtomicBool::new(false);
    Watch {
        stop: &STOP,
        run: &|| {},
    }
};

/// The crane of 004 with pivot as built: what the numbers to reach belong to.
fn problem(m_5: f64, n_max: Option<f64>) -> Problem {
    let d = published("balance_existing");
    Problem {
        boom: Arc::new(boom()),
        positions: Positions::new(&boom(), range(), 101).expect("closes"),
        branch: Branch::Left,
        criterion: Criterion::Residual,
        constraints: Constraints {
            gamma_min: rad(34.6),
            m_plus: Some(0.0),
            n_max,
            dm_max: None,
            rearward: true,
        },
        bounds: Bounds {
            d_1: [d.d_1, d.d_1],
            delta_1: [d.delta_1, d.delta_1],
            r_1: [0.3, 12.0],
            alpha_1: [rad(-60.0), rad(60.0)],
            l_1: [1.0, 20.0],
            lever: [0.3, 6.0],
            chi_5: [rad(-180.0), rad(180.0)],
            m_5: [100e3, m_5],
        },
        robust: None,
    }
}

fn effort(seed: u64) -> Effort {
    Effort {
        seed,
        runs: RUNS,
        threads: 2,
    }
}

/// From five cold starts: below the limit, within 0.5 %, each constraint kept by
/// the analysis too, which shares no closure with the search.
fn reach(problem: &Problem, limit: f64) -> Found {
    let mut found: Vec<Found> = Vec::new();
    for seed in 1..=5 {
        let best = search(problem, effort(seed), ALONE).expect("there is one");
        println!(
            "seed {seed}: |dM|max {:.4} kN.m, rod {:.1} kN, {:?}",
            best.value / 1e3,
            best.criteria.n_max / 1e3,
            best.dimensions
        );
        assert!(best.complete && best.value <= limit, "seed {seed}: {}", best.value);
        assert!(problem.violated(&best.criteria).is_empty());
        found.push(best);
    }
    let values = found.iter().map(|best| best.value);
    let (low, high) = (values.clone().fold(f64::INFINITY, f64::min), values.fold(0.0, f64::max));
    assert!(high <= 1.005 * low, "{low} {high}");
    let best = *found.iter().min_by(|a, b| a.value.total_cmp(&b.value)).expect("five");
    let whole = Analysis::new(&boom(), &Balance::Lever(lever(best.dimensions)), range()).expect("one branch");
    println!("between the positions too: {:.4} kN.m", whole.dm_max.value / 1e3);
    assert!(whole.dm_max.value <= limit);
    assert!(whole.gamma_min.expect("a lever").value >= rad(34.6) - 1e-4);
    assert!(whole.ends[0] >= -1e-3 && whole.ends[1] <= 1e-3, "{:?}", whole.ends);
    best
}

#[test]
fn optimum_with_the_published_counterweight() {
    reach(&problem(984.8e3, None), 7.6e3);
}

#[test]
fn optimum_with_a_heavier_counterweight() {
    reach(&problem(1300e3, None), 3.7e3);
}

#[test]
fn optimum_with_a_limited_rod_force() {
    let best = reach(&problem(984.8e3, Some(1200e3)), 71e3);
    assert!(best.criteria.n_max <= 1200e3);
}

/// Twenty seeds agree to a billionth, at what is left of the conditions of an optimum by rounding; the analysis, which
/// shares no closure with the search, and finds peaks in another way, gives the same residual.
#[test]
fn twenty_seeds() {
    let mut narrow = problem(1300e3, None);
    narrow.constraints.gamma_min = rad(45.0);
    let of_paper = problem(984.8e3, None);
    for (problem, known) in [(&narrow, 5.18955e3), (&of_paper, 7.5415e3)] {
        let mut first = None;
        for seed in 1..=20 {
            let best = search(problem, effort(seed), ALONE).expect("there is one");
            let residual = best.residual.expect("finished");
            println!("seed {seed}: {:.9} N.m, residual {residual:e}", best.value);
            assert!(problem.violated(&best.criteria).is_empty());
            assert!(residual < 1e-9, "seed {seed}: {residual:e}");
            let value = *first.get_or_insert(best.value);
            assert!(
                (best.value / value - 1.0).abs() < 1e-9,
                "seed {seed}: {} {value}",
                best.value
            );
            assert!(best.value <= known * (1.0 + 2e-6), "seed {seed}: {}", best.value);
            let whole = Analysis::new(&boom(), &Balance::Lever(lever(best.dimensions)), range()).expect("one branch");
            assert!(
                (whole.dm_max.value / best.value - 1.0).abs() < 1e-9,
                "{}",
                whole.dm_max.value
            );
        }
    }
}

/// One seed gives one result, whoever does the work.
#[test]
fn threads_change_nothing() {
    let problem = problem(984.8e3, Some(1200e3));
    let with = |threads| {
        search(
            &problem,
            Effort {
                seed: 7,
                runs: 6,
                threads,
            },
            ALONE,
        )
    };
    let (one, three) = (with(1), with(3));
    assert_eq!(format!("{one:?}"), format!("{three:?}"));
}

/// Breaking off keeps the best so far and says that it is not the end.
#[test]
fn breaking_off_keeps_the_best_so_far() {
    let mut problem = problem(984.8e3, None);
    problem.constraints.m_plus = None;
    let (stop, done) = (AtomicBool::new(false), AtomicUsize::new(0));
    let run = || {
        if done.fetch_add(1, Ordering::Relaxed) >= 2 {
            stop.store(true, Ordering::Relaxed);
        }
    };
    let found = search(&problem, effort(1), Watch { stop: &stop, run: &run });
    let found = found.expect("three runs find something");
    assert!(!found.complete && found.value.is_finite());
}

/// The fast evaluation and the analysis, which close the linkage differently.
#[test]
fn candidate_and_analysis_agree() {
    let problem = problem(984.8e3, None);
    for name in ["balance_existing", "balance_synthesised"] {
        let d = published(name);
        let fast = problem.positions.evaluate(&d, Branch::Left).expect("closes");
        let whole = Analysis::new(&boom(), &Balance::Lever(lever(d)), range()).expect("closes");
        for (end, other) in fast.ends.into_iter().zip(whole.ends) {
            assert!((end - other).abs() <= 1e-9 * problem.positions.scale);
        }
        let n_max = whole.n_max.expect("a rod").value;
        // Peaks between the positions, and the trapezoidal rule.
        assert!(fast.dm_max <= whole.dm_max.value * (1.0 + 1e-12) && fast.dm_max >= 0.999 * whole.dm_max.value);
        assert!(fast.n_max <= n_max * (1.0 + 1e-12) && fast.n_max >= 0.999 * n_max);
        assert!(
            (fast.e_abs - whole.e_abs).abs() <= 0.01 * whole.e_abs,
            "{} {}",
            fast.e_abs,
            whole.e_abs
        );
    }
}

/// Four positions: the ordinates of eq. (4), and the paper's lever from them.
#[test]
fn the_papers_lever_from_its_nodes() {
    let boom = boom();
    let phi = [62.7, 45.8, 79.2].map(rad);
    let nodes = Nodes::new(&boom, phi, rad(198.6), 984.8e3).expect("a heavy counterweight");
    for (psi, given) in nodes.psi.into_iter().zip([198.6, 154.897, 224.625]) {
        assert!((psi.to_degrees() - given).abs() <= 5e-4, "{}", psi.to_degrees());
    }
    assert!((nodes.slope - 2.08287).abs() <= 5e-6, "{}", nodes.slope);
    let d = published("balance_synthesised");
    let levers = nodes.levers(d.d_1, d.delta_1, 0.364).expect("levers");
    let left: Vec<&Lever<f64>> = levers.iter().filter(|lever| lever.branch == Branch::Left).collect();
    assert_eq!(left.len(), 1);
    let d = left[0].dimensions;
    let found = [d.r_1, d.l_1, d.alpha_1.to_degrees(), d.chi_5.to_degrees()];
    println!("{found:?}");
    for ((value, given), half) in found
        .into_iter()
        .zip([1.603, 9.057, 18.94, 156.82])
        .zip([5e-4, 5e-4, 5e-3, 5e-3])
    {
        assert!((value - given).abs() <= half, "{value} {given}");
    }
    let whole = Analysis::new(&boom, &Balance::Lever(*left[0]), range()).expect("one branch");
    println!("|dM|max {}", whole.dm_max.value);
    assert!(
        (whole.dm_max.value / 1e3 - 70.8).abs() <= 0.05,
        "{}",
        whole.dm_max.value
    );
    // The nodes are met: no residual, and the lever stands as asked.
    for (phi, psi) in phi.into_iter().zip(nodes.psi) {
        let turn = left[0].at(phi).expect("closes").lever.expect("turns");
        assert!(
            ((turn.psi - psi) / std::f64::consts::TAU).fract().abs() <= 1e-9,
            "{} {psi}",
            turn.psi
        );
    }
    // The printed ordinates contradict the printed nodes.
    for (psi, printed) in nodes.psi[1..].iter().zip([148.805, 226.39]) {
        assert!((psi.to_degrees() - printed).abs() > 1.0);
    }
    assert!((nodes.slope - oracle()["printed"]["dpsi_dphi_node1"].as_f64().expect("a number")).abs() > 0.1);
}

/// Three positions of equal energy: the energy is met at all three, and the
/// residual passes zero inside each interval, not at the positions.
#[test]
fn three_positions_of_equal_energy() {
    let boom = boom();
    let d = published("balance_synthesised");
    let given = three::Given {
        phi: [46.0, 62.0, 80.0].map(rad),
        d_1: d.d_1,
        delta_1: d.delta_1,
        r_1: 2.5,
        alpha_1: rad(17.0),
        psi_1: rad(155.0),
        m_5: 1000e3,
    };
    let lever = three::lever(&boom, &given).expect("a lever");
    let balance = Balance::Lever(lever);
    let energy = |phi: f64| {
        let load = boom.at(phi).expect("closes");
        load.u_0 + balance.at(phi, &load).expect("closes").u_5
    };
    let whole = given.phi.map(energy);
    for other in &whole[1..] {
        assert!((other - whole[0]).abs() <= 1e-9 * 1e6, "{whole:?}");
    }
    let found = Analysis::new(&boom, &balance, [given.phi[0], given.phi[2]]).expect("one branch");
    println!("{:?} |dM|max {}", lever.dimensions, found.dm_max.value);
    for interval in given.phi.windows(2) {
        let inside = found
            .equilibria
            .iter()
            .filter(|e| interval[0] < e.phi && e.phi < interval[1]);
        assert!(inside.count() >= 1, "{:?}", found.equilibria);
    }
    assert!(
        found.ends[0].abs() > 1e3,
        "no zero at the positions themselves: {:?}",
        found.ends
    );

    // Too light, no numbers, not rising, in front, and in one line.
    let light = three::Given { m_5: 200e3, ..given };
    assert_eq!(three::lever(&boom, &light).expect_err("too light").quantity.id, "M_5");
    let nan = three::Given { r_1: f64::NAN, ..given };
    assert_eq!(three::lever(&boom, &nan).expect_err("no number").quantity.id, "r_1");
    let falling = three::Given {
        phi: [46.0, 80.0, 62.0].map(rad),
        ..given
    };
    assert_eq!(three::lever(&boom, &falling).expect_err("falls").quantity.id, "phi");
    let front = three::Given { psi_1: 0.3, ..given };
    assert_eq!(three::lever(&boom, &front).expect_err("in front").quantity.id, "psi");
}

/// A joint that the lever sees move in a line has no finite rod: a weightless
/// boom leaves the lever where it is, and two equal angles are as bad.
#[test]
fn collinear_positions_have_no_rod() {
    let weightless = Plain {
        g_b: 1.0,
        r_b: 1e-9,
        chi_b: 0.0,
    };
    let boom = weightless.check().expect("sound");
    let given = three::Given {
        // Almost the same angle three times: the arc is a line.
        phi: [60.0, 60.001, 60.002].map(rad),
        d_1: 10.0,
        delta_1: 1.8,
        r_1: 3.0,
        alpha_1: 0.3,
        psi_1: 2.8,
        m_5: 1e6,
    };
    let fault = three::lever(&boom, &given).expect_err("in one line");
    assert!(fault.to_string().contains("infinitely long"), "{fault}");
}

/// What manufacturing leaves, and a lever that suffers less from it.
#[test]
fn tolerances_and_the_robust_mode() {
    let mut problem = problem(984.8e3, None);
    let tolerances = Tolerances {
        length: 1e-3,
        angle: rad(0.05),
        weight: 0.01,
    };
    let many = Builds::new(&problem.positions, tolerances, 4000, 11).expect("sound");
    let spread = |d: &Dimensions<f64>| Spread::new(&many, &problem.positions, d, Branch::Left).expect("closes");
    let none = Builds::new(
        &problem.positions,
        Tolerances {
            length: 0.0,
            angle: 0.0,
            weight: 0.0,
        },
        20,
        1,
    );
    let best = search(
        &problem,
        Effort {
            seed: 1,
            runs: 48,
            threads: 2,
        },
        ALONE,
    )
    .expect("there is one");
    let paper = spread(&published("balance_synthesised"));
    let nominal = spread(&best.dimensions);
    println!("published {paper:?}\noptimum {nominal:?}");
    let exact = Spread::new(
        &none.expect("sound"),
        &problem.positions,
        &best.dimensions,
        Branch::Left,
    )
    .expect("closes");
    // Summing the weights' parts rounds the last digits.
    assert!((exact.dm_95 - best.value).abs() <= 1e-9 * problem.positions.scale);
    assert!(nominal.nominal < nominal.median && nominal.median < nominal.dm_95);
    // The claim on paper: a residual of 7.5 kN·m is not what will be built.
    assert!(nominal.median > 2.0 * nominal.nominal);
    assert!(nominal.dm_95 < paper.dm_95);
    problem.robust = Some(Builds::new(&problem.positions, tolerances, 100, 12).expect("sound"));
    let robust = improve(&problem, best.dimensions, 1, ALONE).expect("starts from a sound one");
    let after = spread(&robust.dimensions);
    println!("robust {after:?} {:?}", robust.dimensions);
    assert!(after.dm_95 <= nominal.dm_95, "{after:?}");
    // A hundred builds foretell what thousands keep.
    assert!(
        (robust.value / after.dm_95 - 1.0).abs() <= 0.15,
        "{} {after:?}",
        robust.value
    );
    assert!(
        Builds::new(
            &problem.positions,
            Tolerances {
                length: -1.0,
                ..tolerances
            },
            100,
            1
        )
        .is_err()
    );
}

/// Searches that cannot succeed say why.
#[test]
fn impossible_searches() {
    let few = Effort {
        seed: 1,
        runs: 4,
        threads: 2,
    };
    let mut light = problem(984.8e3, None);
    light.bounds.m_5 = [100e3, 200e3];
    light.constraints.dm_max = Some(10e3);
    let fault = search(&light, few, ALONE).expect_err("too light a counterweight");
    println!("{fault}");
    assert!(fault.to_string().contains("M_5"), "{fault}");

    let mut apart = problem(984.8e3, None);
    apart.bounds.r_1 = [0.3, 1.0];
    apart.bounds.lever = [0.3, 1.0];
    apart.bounds.l_1 = [0.5, 1.0];
    let fault = search(&apart, few, ALONE).expect_err("closes nowhere");
    println!("{fault}");
    assert_eq!(fault.quantity.id, "l_1");

    let mut crossed = problem(984.8e3, None);
    crossed.bounds.r_1 = [3.0, 1.0];
    assert_eq!(search(&crossed, few, ALONE).expect_err("crossed").quantity.id, "r_1");

    let mut against = problem(984.8e3, None);
    against.constraints.m_plus = Some(20e3);
    against.constraints.dm_max = Some(10e3);
    assert_eq!(
        search(&against, few, ALONE).expect_err("contradiction").quantity.id,
        "M_plus"
    );

    let outside = Dimensions {
        r_1: 20.0,
        ..published("balance_existing")
    };
    let fault = improve(&problem(984.8e3, None), outside, 1, ALONE).expect_err("a start outside");
    assert_eq!((fault.quantity.id, fault.value), ("r_1", 20.0));

    // Nothing free is no search, but an answer.
    let mut fixed = problem(984.8e3, None);
    fixed.bounds = published("balance_synthesised").map(&mut |_, value| [value, value]);
    let found = search(&fixed, few, ALONE).expect("the published lever keeps all");
    assert!((found.value / 1e3 - 68.9).abs() <= 0.05, "{}", found.value);
    // One free dimension is one.
    fixed.bounds.m_5 = [900e3, 1000e3];
    let freed = search(&fixed, few, ALONE).expect("the published lever keeps all");
    assert!(freed.value < found.value, "{} {}", freed.value, found.value);

    let mut nan = problem(984.8e3, None);
    nan.constraints.gamma_min = f64::NAN;
    assert_eq!(
        search(&nan, few, ALONE).expect_err("no number").quantity.id,
        "gamma_min"
    );
}

/// The other way round: the least rod force that keeps the published residual
/// is what the limited rod force leaves; and no lever leaves less energy than the
/// one found for it, neither the published nor the one of the least residual.
#[test]
fn other_criteria() {
    let mut force = problem(984.8e3, None);
    force.criterion = Criterion::RodForce;
    force.constraints.dm_max = Some(70.6e3);
    let best = search(&force, effort(1), ALONE).expect("there is one");
    println!("rod {:.2} kN", best.value / 1e3);
    assert!((best.value / 1200e3 - 1.0).abs() <= 0.005, "{}", best.value);
    let mut energy = problem(984.8e3, None);
    energy.criterion = Criterion::Energy;
    let best = search(&energy, effort(1), ALONE).expect("there is one");
    let flat = search(&problem(984.8e3, None), effort(1), ALONE).expect("there is one");
    let flat = flat.criteria.e_abs;
    println!(
        "integral of |dM| {:.3} kJ, of the least residual {:.3} kJ",
        best.value / 1e3,
        flat / 1e3
    );
    assert!(best.value <= flat && best.value < 8.1e3, "{} {flat}", best.value);
}

/// Each newton of rod force that is allowed leaves less of the moment; what no lever keeps is said.
#[test]
fn the_front_against_the_rod_force() {
    let mut problem = problem(984.8e3, None);
    problem.constraints.dm_max = Some(200e3);
    // 12 m times 100 kN are 1200 kN.m, of about 2000 that have to be balanced.
    let few = Effort {
        seed: 1,
        runs: 16,
        threads: 2,
    };
    let limits = [100e3, 1200e3, 1800e3, 2600e3, 3700e3];
    let front = front(&problem, Limit::RodForce, &limits, few, ALONE).expect("rising");
    assert!(front[0].as_ref().is_err_and(|fault| !fault.to_string().is_empty()));
    let values: Vec<f64> = front[1..]
        .iter()
        .map(|found| found.as_ref().expect("there is one").value)
        .collect();
    println!("{values:.0?}");
    assert!(values.windows(2).all(|pair| pair[1] < pair[0]), "{values:?}");
    assert!(values[0] <= 71e3 && values[3] <= 7.6e3, "{values:?}");
}

/// Freeing the pivot's distance halves the residual again.
#[test]
fn a_longer_frame_is_better_still() {
    let mut free = problem(984.8e3, None);
    free.bounds.d_1 = [8.0, 14.0];
    let best = search(&free, effort(1), ALONE).expect("there is one");
    println!("{:.4} kN.m {:?}", best.value / 1e3, best.dimensions);
    assert!(best.value <= 3.8e3, "{}", best.value);
}

/// The other branch, which the paper does not try: with the joint on a tail of
/// the boom behind its foot, within the same 12 m and 20 m, one lever beats all
/// three numbers asked for at once, with a seventh of the published rod force.
#[test]
fn the_other_branch_is_better() {
    let mut tail = problem(984.8e3, Some(1200e3));
    tail.branch = Branch::Right;
    tail.bounds.alpha_1 = [rad(60.0), rad(200.0)];
    let best = search(&tail, effort(1), ALONE).expect("there is one");
    println!("{:.4} kN.m {:?} {:?}", best.value / 1e3, best.dimensions, best.criteria);
    let lever = Lever::new(best.dimensions, None, Branch::Right).expect("a lever");
    let whole = Analysis::new(&boom(), &Balance::Lever(lever), range()).expect("one branch");
    assert!(whole.dm_max.value <= 3.3e3, "{}", whole.dm_max.value);
    assert!(whole.n_max.expect("a rod").value <= 3265e3 / 7.0);
    assert!(whole.gamma_min.expect("a lever").value >= rad(34.6) - 1e-4);
    assert!(best.dimensions.m_5 <= 900e3 && best.criteria.cos_psi <= 0.0);
}

/// What comes of a scene's text, by the way of the command, with everything about its levers.
fn of_scene(text: &str) -> Comparison {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
    let luffing = scene.mechanism.of::<Luffing>().expect("a luffing mechanism");
    let (boom, range) = double_link::balancing::boom(&luffing.parameters, &luffing.motion).expect("weights");
    let task = luffing.synthesis.as_ref().expect("asked for");
    let steps = AtomicUsize::new(0);
    let count = || {
        steps.fetch_add(1, Ordering::Relaxed);
    };
    let watch = Watch { run: &count, ..ALONE };
    let boom: Arc<dyn Boom<f64> + Send + Sync> = Arc::new(boom);
    let found = run(&boom, range, task, 2, watch).expect("there is one");
    assert_eq!(
        steps.into_inner(),
        run::steps(task),
        "the progress bar ends where it says"
    );
    assert!(found.complete);
    // As the command writes it, with the least that is needed.
    let start = text.find("[luffing.balance]").expect("a balance");
    let end = start + text[start..].find("\n[luffing.drive]").expect("a drive");
    let mut balance = String::from("[luffing.balance]\nkind = \"lever\"\n");
    let side = if found.branch == Branch::Left { "left" } else { "right" };
    balance += &format!("branch = \"{side}\"\n");
    found.dimensions.map(&mut |symbol, value| {
        let unit = symbol.display.name;
        balance += &format!("{} = \"{:.6} {unit}\"\n", symbol.id, symbol.shown(value));
    });
    let whole = format!("{}{balance}{}", &text[..start], &text[end..]);
    let scene = Scene::parse(&whole).unwrap_or_else(|found| panic!("{found:?}"));
    Comparison::new(&scene).expect("a synthesis")
}

const EXISTING: &str = include_str!("../../scenes/portal_004_existing.toml");
const OPTIMUM: &str = include_str!("../../scenes/portal_004_synthesis.toml");

/// An empty table takes the pivot and the weight that are there, and finds the lever on the boom's tail.
#[test]
fn an_empty_table_is_enough() {
    let comparison = of_scene(&format!("{EXISTING}\n[luffing.synthesis]\n"));
    let found = comparison.levers.last().expect("the scene's own");
    let worth = found.worth.as_ref().expect("closes");
    println!("{:?} {}", found.dimensions, worth.analysis.dm_max.value);
    assert_eq!(found.branch, Branch::Right);
    assert!(worth.analysis.dm_max.value <= 3.2e3 && found.dimensions.m_5 <= 869e3);
    // What the search asked for is kept between its positions too.
    assert!(comparison.limits.iter().all(|limit| !limit.missed()));
}

/// The robust mode leaves less in 95 % of all builds, and says so after thousands of them.
#[test]
fn the_robust_mode_of_a_scene() {
    let robust = of_scene(&OPTIMUM.replace("objective = \"dM_max\"", "objective = \"dM_95\""));
    let plain = of_scene(OPTIMUM);
    let last = |comparison: &Comparison| {
        let worth = comparison
            .levers
            .last()
            .and_then(|lever| lever.worth.as_ref())
            .expect("closes");
        (worth.analysis.dm_max.value, worth.spread.expect("builds close").dm_95)
    };
    println!("{:?} {:?}", last(&robust), last(&plain));
    assert!(last(&robust).1 < last(&plain).1 && last(&robust).0 > last(&plain).0);
}
