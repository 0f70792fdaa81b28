//! Anti-cavitation valves, load-holding valves and limits of the pump: closed forms at rest, the balance of powers, exact
//! derivatives. `tests/test_oil_parts.py` has them in motion beside an independent code.

use lemnis_models::component::model::Model;
use lemnis_models::parts::hydraulics::anti_cavitation::AntiCavitation;
use lemnis_models::parts::hydraulics::cylinder::{Cylinder, Oil};
use lemnis_models::parts::hydraulics::load_holding::LoadHolding;
use lemnis_models::parts::hydraulics::parts::OilParts;
use lemnis_models::parts::hydraulics::pump::PumpLimits;
use lemnis_models::parts::hydraulics::tank::Tank;
use lemnis_models::parts::hydraulics::throttle::{difference, root};
use lemnis_models::scene::Scene;

#[path = "common/crane.rs"]
mod crane;
#[path = "common/levels.rs"]
mod levels;

const SUPPLY: f64 = 250e5;
const DRAWS: AntiCavitation<f64> = AntiCavitation { p_ac: 2e4, k_ac: 2e-7 };
const HOLDS: LoadHolding<f64> = LoadHolding {
    p_lh: 180e5,
    i_lh: 4.0,
    dp_lh: 30e5,
    x_t: 0.05,
};
const LIMITS: PumpLimits<f64> = PumpLimits {
    q_pmax: 5e-3,
    p_pmax: 60e3,
};

const PARTS: OilParts = OilParts {
    anti_cavitation: Some(DRAWS),
    load_holding: Some(HOLDS),
    pump: Some(LIMITS),
    tank: None,
};
const TANK: Tank<f64> = Tank { p_tank: 3e5 };

fn with_parts(torn: [f64; 2]) -> Cylinder {
    Cylinder {
        parts: Some(PARTS),
        torn,
        ..crane::cylinder()
    }
}

fn oil(ports: [f64; 2], chambers: [f64; 2], spool: f64) -> Oil<f64> {
    Oil {
        ports,
        chambers,
        spool,
        spool_speed: 0.0,
    }
}

/// A piston that is drawn out with its valve shut: the tank gives all that the bore grows by, at p = −p_ac − A v/k_ac.
#[test]
fn a_chamber_that_grows_is_fed_from_the_tank() {
    let cylinder = Cylinder {
        leakage: 0.0,
        ..with_parts([0.0; 2])
    };
    for speed in [1e-3, 0.02, 0.15] {
        let pressure = -DRAWS.p_ac - cylinder.areas[0] * speed / DRAWS.k_ac;
        let state = oil([pressure, 50e5], [pressure, 50e5], 0.0);
        let drawn = cylinder.flows(&state, SUPPLY).drawn.expect("there");
        assert!((drawn[0] / (cylinder.areas[0] * speed) - 1.0).abs() < 1e-12 && drawn[1] == 0.0);
        let rate = cylinder.rates(&state, 6.0, speed, 0.0, SUPPLY).chambers[0];
        let without = Cylinder {
            parts: Some(OilParts {
                anti_cavitation: None,
                ..PARTS
            }),
            ..cylinder
        };
        let falls = without.rates(&state, 6.0, speed, 0.0, SUPPLY).chambers[0];
        assert!(rate.abs() < 1e-10 * falls.abs(), "{rate} {falls}");
        // Shut at its cracking pressure.
        let at = oil([0.0; 2], [-DRAWS.p_ac, 0.0], 0.0);
        assert_eq!(cylinder.flows(&at, SUPPLY).drawn, Some([0.0; 2]));
    }
}

/// With its line torn off and no pilot the chamber loses nothing but the piston's leakage, up to the setting; it opens at
/// the pilot pressure (p_lh − p)/i_lh, and passes what the line does, times what is open. Inward it is free.
#[test]
fn the_load_is_held_until_the_pilot_opens() {
    let cylinder = with_parts([1.0, 0.0]);
    for load in [20e5, 100e5, 179e5] {
        let flows = |pilot: f64| cylinder.flows(&oil([0.0, pilot], [load, 0.0], 0.0), SUPPLY);
        assert_eq!(flows(0.0).line[0], 0.0);
        let state = oil([0.0, 0.0], [load, 0.0], 0.0);
        let volume = cylinder.volumes(6.0)[0];
        let leaks = -cylinder.bulk_modulus * cylinder.leakage * load / volume;
        let falls = cylinder.rates(&state, 6.0, 0.0, 0.0, SUPPLY).chambers[0];
        assert!((falls / leaks - 1.0).abs() < 1e-14, "{falls} {leaks}");
        let opens = (HOLDS.p_lh - load) / HOLDS.i_lh;
        assert_eq!(flows(opens - 1.0).line[0], 0.0);
        for part in [1e-3, 0.5, 0.999, 1.0, 3.0] {
            let pilot = opens + part * HOLDS.dp_lh / HOLDS.i_lh;
            let wanted = -part.min(1.0) * cylinder.line * load.sqrt();
            // The laminar range of the line takes (Δp_l/Δp)²/4 of it.
            assert!((flows(pilot).line[0] / wanted - 1.0).abs() < 1e-3_f64.min(0.3 * (2e4 / load).powi(2) + 1e-8));
        }
    }
    // Above its setting it is a relief valve of its own.
    let above = cylinder.flows(&oil([0.0; 2], [HOLDS.p_lh + HOLDS.dp_lh, 0.0], 0.0), SUPPLY);
    assert_eq!(above.openings, Some([1.0, 0.0]));
    let inward = cylinder.flows(&oil([90e5, 0.0], [60e5, 0.0], 0.0), SUPPLY).line[0];
    assert_eq!(inward, root(30e5) * cylinder.line);
}

fn on_tank(cylinder: Cylinder) -> Cylinder {
    let parts = cylinder.parts.map(|parts| OilParts {
        tank: Some(TANK),
        ..parts
    });
    Cylinder { parts, ..cylinder }
}

/// Valve, pump and anti-cavitation valves feel pressures above that of the tank: with all of them as much higher they pass the
/// same. What is open to the atmosphere does not: torn lines, relief valves, the springs of the load-holding valves.
#[test]
fn the_tank_may_be_under_pressure() {
    let (open, under) = (with_parts([0.3, 0.7]), on_tank(with_parts([0.3, 0.7])));
    let state = |more: f64| oil([120e5 + more, 10e5 + more], [100e5 + more, -1e5 + more], 0.04);
    let (wanted, found) = (
        open.flows(&state(0.0), SUPPLY),
        under.flows(&state(TANK.p_tank), SUPPLY),
    );
    let pairs = [(wanted.valve, found.valve), (wanted.line, found.line)].into_iter();
    let pairs = pairs
        .chain(wanted.drawn.zip(found.drawn))
        .chain(wanted.relieved.zip(found.relieved));
    for ([a, b], [c, d]) in pairs {
        assert!(
            (a - c).abs() <= 1e-12 * a.abs() && (b - d).abs() <= 1e-12 * b.abs(),
            "{a} {c}, {b} {d}"
        );
    }
    assert!((wanted.supply - found.supply).abs() < 1e-9 * SUPPLY && wanted.drawn.is_some_and(|drawn| drawn[1] > 0.0));
    let torn = found.torn.expect("there");
    assert_eq!(torn[0], root(120e5 + TANK.p_tank) * under.line * 0.3);
    let high = oil([open.relief[0] + 1e5; 2], [50e5; 2], 0.0);
    assert_eq!(under.flows(&high, SUPPLY).relief, open.flows(&high, SUPPLY).relief);
    assert_eq!(under.flows(&high, SUPPLY).openings, open.flows(&high, SUPPLY).openings);
    // A chamber that grows is fed at the tank's pressure less what opens the valve, and what its flow takes.
    let speed = 0.15;
    let pressure = TANK.p_tank - DRAWS.p_ac - under.areas[0] * speed / DRAWS.k_ac;
    let drawn = under
        .flows(&oil([pressure, 50e5], [pressure, 50e5], 0.0), SUPPLY)
        .drawn
        .expect("there");
    assert!((drawn[0] / (under.areas[0] * speed) - 1.0).abs() < 1e-12 && drawn[1] == 0.0);
}

/// The real root of q³ + a q = b for a above zero, by Cardano.
fn cubic(a: f64, b: f64) -> f64 {
    let inner = (b * b / 4.0 + a * a * a / 27.0).sqrt();
    libm::cbrt(b / 2.0 + inner) - libm::cbrt(inner - b / 2.0)
}

/// Flow and pressure of the pump: its own pressure up to its limits, then its greatest flow, then its greatest power; with
/// a turbulent edge of conductance c the last is the cubic q³/c² + p q = P_max.
#[test]
fn neither_flow_nor_power_of_the_pump_is_exceeded() {
    let (limited, free) = (
        with_parts([0.0; 2]),
        Cylinder {
            parts: Some(OilParts { pump: None, ..PARTS }),
            ..with_parts([0.0; 2])
        },
    );
    let mut seen = [0; 3];
    for spool in [-1.0, -0.4, -0.02, 0.02, 0.3, 1.0] {
        let mut before: Option<[f64; 2]> = None;
        for step in 0..=2500 {
            let port = 1e4 * f64::from(step) - 5e4;
            let state = oil([port; 2], [port; 2], spool);
            let (found, asked) = (limited.flows(&state, SUPPLY), free.flows(&state, SUPPLY));
            let (flow, pressure) = (found.pump, found.supply);
            let edge = spool.abs() * limited.valve.conductance;
            assert!(flow <= LIMITS.q_pmax && pressure * flow <= LIMITS.p_pmax * (1.0 + 1e-12));
            // The edge passes it with the pressure that is left.
            let passed = edge * root(pressure - port);
            assert!(
                (passed - flow).abs() <= 1e-9 * flow.abs(),
                "{spool} {port}: {passed} {flow}"
            );
            let regime = if flow == asked.pump {
                assert_eq!(pressure, SUPPLY);
                0
            } else if flow == LIMITS.q_pmax {
                1
            } else {
                assert!((pressure * flow / LIMITS.p_pmax - 1.0).abs() < 1e-12);
                let wanted = cubic(port * edge * edge, LIMITS.p_pmax * edge * edge);
                assert!(
                    port < 1e5 || (flow / wanted - 1.0).abs() < 1e-4,
                    "{port}: {flow} {wanted}"
                );
                2
            };
            seen[regime] += 1;
            assert_eq!(
                found.valve[usize::from(spool > 0.0)],
                asked.valve[usize::from(spool > 0.0)]
            );
            // Where one limit follows on another nothing jumps; near the pump's pressure the edge itself is steep.
            if let Some([flow_before, pressure_before]) = before {
                let near = [
                    (flow - flow_before).abs() / flow_before,
                    (pressure - pressure_before).abs() / SUPPLY,
                ];
                assert!(
                    port > 245e5 || near.iter().all(|part| *part < 0.05),
                    "{spool} {port}: {near:?}"
                );
            }
            before = Some([flow, pressure]);
        }
    }
    assert!(seen.iter().all(|count| *count > 1000), "{seen:?}");
    for drop in [1.0, 1e3, 2e4, 1e6, 2e7] {
        assert!(
            (difference(root(drop) * root(drop)) / drop - 1.0).abs() < 1e-12,
            "{drop}"
        );
    }
}

/// What the pump gives is the rod's, stored in the oil, or lost at edges, lines, valves and tears.
#[test]
fn powers_are_balanced() {
    let open = with_parts([0.3, 0.7]);
    let states = [
        oil([120e5, 30e5], [100e5, 20e5], 0.8),
        oil([20e5, 160e5], [150e5, 170e5], -0.9),
        oil([-5e4, 60e5], [-9e4, 55e5], -0.2),
        oil([0.0, 200e5], [150e5, -6e4], 0.01),
    ];
    for (state, cylinder) in states
        .into_iter()
        .flat_map(|state| [(state, open), (state, on_tank(open))])
    {
        for speed in [-0.1, 0.04] {
            let [pump, throttles, compression] = cylinder.powers(&state, speed, SUPPLY);
            let rod = cylinder.force(&state) * speed;
            let size = [pump, throttles, compression, rod].iter().map(|x| x.abs()).sum::<f64>();
            assert!((pump - throttles - compression - rod).abs() < 1e-12 * size);
            // Of an open tank: one under pressure gives some of its own.
            assert!(throttles >= 0.0 || cylinder != open);
        }
    }
}

const KEYS: &str = "p_ac = \"0.2 bar\"\nk_ac = \"2e-7 m3/(s.Pa)\"\np_lh = \"180 bar\"\ni_lh = \"4\"\ndp_lh = \"30 bar\"\nx_T = \"0.1\"\n\
                     y_b1 = \"0.4\"\ny_b2 = \"0.1\"\nQ_Pmax = \"300 L/min\"\nP_Pmax = \"60 kW\"\n";
const TANK_KEY: &str = "p_tank = \"3 bar\"\n";

fn model(level: &str) -> Model {
    let text = levels::text(level).replace(
        "[luffing.hydraulics]\n",
        &format!("[luffing.hydraulics]\n{KEYS}{TANK_KEY}"),
    );
    let scene = Scene::parse(&text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    scene.model().expect("built")
}

/// Derivatives of rates, flows and indicators by states, inputs and parameters of the parts, against central differences,
/// where each part is at work: their error is that of the step, squared, and of rounding over it.
#[test]
fn derivatives_are_exact() {
    let mut model = model("hydraulic with slewing");
    let index = |model: &Model, id: &str| {
        let found = model.variables().iter().position(|variable| variable.symbol.id == id);
        found.unwrap_or_else(|| panic!("{id}"))
    };
    let unknowns = [
        "der(p_1)",
        "der(p_2)",
        "der(p_A)",
        "der(p_B)",
        "Q_acA",
        "Q_acB",
        "y_lhA",
        "y_lhB",
        "Q_b1",
        "Q_b2",
        "p_s",
        "z.suction_A",
        "z.suction_B",
        "z.hold_A",
        "z.hold_B",
        "z.open_A",
        "z.open_B",
        "z.underlap",
        "z.flow",
        "z.power",
    ];
    let knowns = [
        "p_1", "p_2", "p_A", "p_B", "x_v", "p_P", "y_b1", "y_b2", "p_ac", "k_ac", "p_lh", "i_lh", "dp_lh", "Q_Pmax",
        "P_Pmax", "p_tank", "Q_N", "dp_N", "dp_L",
    ];
    // Valve of the bore partly open and annulus drawing, the pump at its flow; the other way round, at its power; at neither.
    let cases = [
        [60e5, 10e5, 150e5, -5e4, 0.8],
        [15e5, 170e5, -6e4, 130e5, -0.7],
        [30e5, 120e5, 100e5, 100e5, 0.05],
    ];
    let (mut compared, mut moved) = (0, 0);
    for case in cases {
        for (id, value) in ["p_1", "p_2", "p_A", "p_B", "x_v"].into_iter().zip(case) {
            let at = index(&model, id);
            model.set(at, value).expect("a state");
        }
        for known in knowns {
            let at = index(&model, known);
            let value = model.get(at).expect("there");
            let step = 1e-5 * value.abs();
            let quantity = model.variables()[at].quantity();
            for unknown in unknowns {
                let result = index(&model, unknown);
                let mut tangent = model.tangent(&|other| f64::from(other == quantity));
                let found = model.derivative(&mut tangent, result).expect("a result");
                let mut beside = [-1.0, 1.0].map(|side| {
                    model.set(at, value + side * step).expect("allowed");
                    model.get(result).expect("a result")
                });
                model.set(at, value).expect("allowed");
                let size = beside[1].abs() + beside[0].abs();
                beside[1] -= beside[0];
                let difference = beside[1] / (2.0 * step);
                let allowed = 1e-7 * difference.abs() + 1e-12 * size / step;
                assert!(
                    (found - difference).abs() <= allowed,
                    "d {unknown} / d {known}: {found:e} {difference:e}"
                );
                compared += 1;
                moved += u32::from(difference != 0.0);
            }
        }
    }
    println!("{compared} derivatives, {moved} of them not zero");
    assert!(moved > 200);
}

/// What is needed for a part is told, and what does not go together refused.
#[test]
fn parts_are_whole_or_absent() {
    let names = |level: &str| -> Vec<&str> { levels::model(level).variables().iter().map(|v| v.symbol.id).collect() };
    let without = names("hydraulic");
    for id in [
        "p_ac",
        "Q_acA",
        "z.suction_A",
        "p_lh",
        "y_b1",
        "y_lhA",
        "z.hold_A",
        "Q_Pmax",
        "p_s",
        "z.flow",
        "p_tank",
    ] {
        assert!(!without.contains(&id), "{id}");
    }
    assert_eq!(
        model("hydraulic").indicators(),
        levels::model("hydraulic").indicators() + 9
    );
    for line in KEYS.lines() {
        let lone = line.split(' ').next().expect("a key");
        let text =
            levels::text("hydraulic").replace("[luffing.hydraulics]\n", &format!("[luffing.hydraulics]\n{line}\n"));
        let mistakes = Scene::parse(&text).expect_err("only one of them");
        assert!(
            format!("{mistakes:?}").contains(&format!("{lone} without")),
            "{mistakes:?}"
        );
    }
}
