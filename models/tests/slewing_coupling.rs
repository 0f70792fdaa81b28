//! A coupling that slips between the slewing drive and what slews: closed forms of two shafts under constant moments, what
//! holds at rest, the end stop through which no blow comes, a load that swings behind it.

#[path = "common/named.rs"]
mod named;
#[path = "common/resumed.rs"]
mod resumed;

use lemnis_models::registry::dependencies;

use named::{get, index, model, near, set};

const READY: &str = include_str!("../scenes/slewing_coupling.toml");

/// Inertia of what slews, with the load of 10 t at 20 m, and of the drive, in kg·m².
const J: f64 = 5e6 + 10e3 * 400.0;
const J_D: f64 = 6e5;
/// In N·m.
const LIMIT: f64 = 200e3;

fn scene(keys: &str) -> String {
    format!(
        "name = \"Test\"\ntitle = \"Test\"\n[slewing]\nfidelity = \"rigid\"\nR = \"20 m\"\nQ = \"10 t\"\nJ_sl = \"5e6 kg.m2\"\n\
         {keys}\n[slewing.coupling]\nJ_d = \"6e5 kg.m2\"\nM_lim = \"200 kN.m\"\n[slewing.motion]\nfrom = \"0 deg\"\n\
         to = \"90 deg\"\nstep = \"5 deg\"\nspeed = \"6 deg/s\"\n"
    )
}

/// The ready scene with its drive as an input.
fn open() -> String {
    let [from, to] = ["# Drive: on at once", "[slewing.coupling]"].map(|mark| READY.find(mark).expect("there"));
    format!("{}{}", &READY[..from], &READY[to..])
}

/// Without friction M_c = M J/(J + J_d): it sticks up to M_lim and slips beyond.
#[test]
fn it_slips_just_beyond_its_limit() {
    let most = LIMIT * (J + J_D) / J;
    for (moment, slips) in [(most * (1.0 - 1e-9), false), (most * (1.0 + 1e-9), true)] {
        for sign in [1.0, -1.0] {
            let mut model = model(&scene(""));
            set(&mut model, "M_sl", sign * moment);
            model.advance(0.0, 2.0).expect("runs");
            let apart = get(&mut model, "omega_d") - get(&mut model, "omega_sl");
            assert_eq!(apart != 0.0, slips, "{moment} {apart:e}");
            near(get(&mut model, "M_cd"), sign * LIMIT, 1e-8 * LIMIT);
            if !slips {
                near(get(&mut model, "omega_sl"), sign * 2.0 * moment / (J + J_D), 1e-15);
            }
        }
    }
}

/// Both sides have one acceleration each, and meet again: speeds, time and heat in closed form.
#[test]
fn start_slip_and_stick() {
    let mut model = model(&scene("M_Fsl = \"20 kN.m\""));
    set(&mut model, "M_sl", 300e3);
    model.advance(0.0, 1.5).expect("runs");
    let (outer, inner) = ((LIMIT - 20e3) / J, (300e3 - LIMIT) / J_D);
    near(get(&mut model, "omega_sl"), 1.5 * outer, 1e-13);
    near(get(&mut model, "omega_d"), 1.5 * inner, 1e-12);
    near(get(&mut model, "W_slip"), LIMIT * 0.5 * 2.25 * (inner - outer), 1e-6);
    near(get(&mut model, "P_slip"), LIMIT * 1.5 * (inner - outer), 1e-7);
    near(get(&mut model, "E_d"), 0.5 * J_D * (1.5 * inner).powi(2), 1e-6);
    set(&mut model, "M_sl", 100e3);
    let apart = 1.5 * (inner - outer);
    let closes = outer + (LIMIT - 100e3) / J_D;
    let meet = apart / closes;
    model.advance(1.5, 1.5 + meet + 1.0).expect("runs");
    let both = (100e3 - 20e3) / (J + J_D);
    let speed = outer * (1.5 + meet) + both;
    near(get(&mut model, "omega_sl"), speed, 1e-12);
    assert_eq!(
        get(&mut model, "omega_d").to_bits(),
        get(&mut model, "omega_sl").to_bits()
    );
    let heat = LIMIT * (0.5 * 2.25 * (inner - outer) + 0.5 * apart * meet);
    near(get(&mut model, "W_slip"), heat, 1e-9 * heat);
    near(get(&mut model, "M_cd"), 100e3 - J_D * both, 1e-7);
    assert_eq!(get(&mut model, "P_slip"), 0.0);
}

/// A brake stronger than the limit stops its own side first; what slews runs out behind the limit, and the heat is what moved.
#[test]
fn a_brake_that_is_too_hard() {
    let mut model = model(&scene("omega_sl = \"6 deg/s\""));
    set(&mut model, "M_Bsl", 500e3);
    let omega = 6_f64.to_radians();
    let (stops, rests) = (omega * J_D / (500e3 - LIMIT), omega * J / LIMIT);
    model.advance(0.0, stops * 0.999).expect("runs");
    assert!(get(&mut model, "omega_d") > 0.0);
    near(get(&mut model, "M_Rd"), -500e3, 0.0);
    model.advance(stops * 0.999, stops * 1.001).expect("runs");
    assert_eq!(get(&mut model, "omega_d"), 0.0);
    near(get(&mut model, "M_Rd"), -LIMIT, 1e-9);
    model.advance(stops * 1.001, rests * 1.001).expect("runs");
    assert_eq!(get(&mut model, "omega_sl"), 0.0);
    let heat = LIMIT * (0.5 * omega * rests - 0.5 * omega * stops);
    near(get(&mut model, "W_slip"), heat, 1e-9 * heat);
    near(get(&mut model, "M_cd"), 0.0, 0.0);
    // Let go, it stays; pushed by less than the limit, both go together.
    set(&mut model, "M_Bsl", 0.0);
    set(&mut model, "M_sl", -100e3);
    let now = rests * 1.001;
    model.advance(now, now + 1.0).expect("runs");
    near(get(&mut model, "omega_sl"), -100e3 / (J + J_D), 1e-14);
}

/// At rest the coupling carries what dry friction leaves, and no brake behind it holds more than its limit.
#[test]
fn what_holds_at_rest() {
    let weight = 10e3 * 9.81 * 20.0 * libm::sin(5_f64.to_radians());
    let slope = |friction: &str| {
        let keys = format!("M_Fsl = \"{friction}\"\npsi_sl = \"30 deg\"\n");
        let text = scene(&keys).replace("M_lim = \"200 kN.m\"", "M_lim = \"160 kN.m\"");
        format!("{text}[slewing.slope]\ngamma_s = \"5 deg\"\nG_u = \"0 kN\"\nr_u = \"0 m\"\n")
    };
    let mut model = model(&slope("30 kN.m"));
    set(&mut model, "M_Bsl", 400e3);
    model.advance(0.0, 5.0).expect("runs");
    assert_eq!(get(&mut model, "omega_sl"), 0.0);
    near(get(&mut model, "M_cd"), weight * 0.5 - 30e3, 1e-11 * 30e3);
    // The other way round the drive pushes, and the same friction helps it.
    set(&mut model, "M_Bsl", 0.0);
    set(&mut model, "M_sl", weight * 0.5 + 20e3);
    model.advance(5.0, 6.0).expect("runs");
    assert_eq!(get(&mut model, "omega_sl"), 0.0);
    near(get(&mut model, "M_cd"), weight * 0.5 + 20e3, 1e-9);
    set(&mut model, "M_sl", 0.0);
    model.advance(6.0, 6.5).expect("runs");
    assert!(get(&mut model, "omega_sl") < 0.0, "downhill");
    assert_eq!(
        get(&mut model, "omega_sl").to_bits(),
        get(&mut model, "omega_d").to_bits()
    );
}

/// The crane is stopped at once and its energy lost; the drive goes on, slips, and comes to rest: its energy becomes heat.
#[test]
fn no_blow_comes_through() {
    let mut model = model(&scene("omega_sl = \"6 deg/s\"\npsi_max = \"3 deg\""));
    let omega = 6_f64.to_radians();
    model.advance(0.0, 0.5 + 1e-6).expect("runs");
    near(get(&mut model, "W_blow"), 0.5 * J * omega * omega, 1e-6);
    assert_eq!(get(&mut model, "omega_sl"), 0.0);
    near(get(&mut model, "omega_d"), omega, 1e-6);
    model.advance(0.5 + 1e-6, 2.0).expect("runs");
    assert_eq!([get(&mut model, "omega_sl"), get(&mut model, "omega_d")], [0.0, 0.0]);
    near(get(&mut model, "W_slip"), 0.5 * J_D * omega * omega, 1e-6);
}

/// Without friction and in still air: work of the drive is motion, height and heat, also of a load that swings.
#[test]
fn energy_with_a_load_that_swings() {
    let text = scene("l_R = \"18 m\"").replace("rigid", "swing");
    let mut model = model(&text);
    let (mut work, mut before, mut slipped) = (0.0, 0.0, 0);
    let start = get(&mut model, "y_Q");
    for step in 0..12_000 {
        let time = f64::from(step) * 1e-3;
        if step % 1000 == 0 {
            let moment = [300e3, 100e3, -350e3, 50e3][(step / 1000) as usize % 4];
            set(&mut model, "M_sl", moment);
            before = get(&mut model, "omega_d");
        }
        model.advance(time, time + 1e-3).expect("runs");
        let now = get(&mut model, "omega_d");
        work += get(&mut model, "M_sl") * 0.5e-3 * (before + now);
        before = now;
        slipped += i32::from(get(&mut model, "P_slip") != 0.0);
    }
    let mut g = |name: &str| get(&mut model, name);
    let (omega, reach, mass) = (g("omega_sl"), g("R"), g("mass_Q"));
    let ([x, y, z], [vx, vy, vz]) = (
        [g("x_Q") + reach, g("y_Q"), g("z_Q")],
        [g("v_Qx"), g("v_Qy"), g("v_Qz")],
    );
    // Left is a quarter turn ahead of forward.
    let square = (vx - omega * z).powi(2) + vy.powi(2) + (vz + omega * x).powi(2);
    let height = mass * 9.81 * (y - start);
    let stored = 0.5 * (g("J_sl") * omega * omega + mass * square) + g("E_d") + height;
    let left = stored + g("W_slip") - work;
    assert!(slipped > 500 && slipped < 11_500, "{slipped}");
    let whole = stored + g("W_slip");
    assert!(left.abs() < 1e-6 * whole, "{left} {work} {whole}");
}

/// Every derivative of rates and results by states and inputs, against differences: stuck, slipping, the drive at rest.
#[test]
fn derivatives() {
    for (moment, brake) in [(200e3, 10e3), (500e3, 10e3), (0.0, 600e3), (-500e3, 10e3)] {
        let mut model = model(&open());
        set(&mut model, "M_sl", 250e3);
        model.advance(0.0, 4.0).expect("runs");
        set(&mut model, "M_sl", moment);
        set(&mut model, "M_Bsl", brake);
        model.advance(4.0, 4.3).expect("runs");
        let slips = get(&mut model, "P_slip") > 0.0;
        assert_eq!(slips, moment != 200e3);
        let variables = model.variables().to_vec();
        for name in ["omega_sl", "omega_d", "psi_sl", "M_sl", "M_Bsl", "R", "Q"] {
            let by = index(&model, name);
            let symbol = variables[by].quantity();
            let mut tangent = model.tangent(&|quantity| f64::from(quantity == symbol));
            let at = model.get(by).expect("known");
            let near = 1e-5 * at.abs().max(1e-3);
            let mut beside = [0, 1].map(|_| model.clone());
            for (model, sign) in beside.iter_mut().zip([-1.0, 1.0]) {
                model.set(by, at + sign * near).expect("allowed");
            }
            for of in [
                "der(omega_sl)",
                "der(omega_d)",
                "P_slip",
                "M_cd",
                "M_Rd",
                "E_d",
                "M_Rsl",
            ] {
                let index = index(&model, of);
                let exact = model.derivative(&mut tangent, index).expect("a derivative");
                let [low, high] = beside.each_mut().map(|model| model.get(index).expect("a result"));
                let rough = (high - low) / (2.0 * near);
                let allowed = 1e-8 * rough.abs() + 1e-13 * high.abs().max(low.abs()) / near + 1e-12;
                assert!((exact - rough).abs() <= allowed, "{of} by {name}: {exact} {rough}");
            }
        }
    }
}

/// What follows while it slips is told beforehand, though it sticks at the start.
#[test]
fn dependencies_count_both_modes() {
    let mut model = model(&open());
    set(&mut model, "M_sl", 250e3);
    model.advance(0.0, 4.0).expect("runs");
    let all = dependencies(&model);
    for (of, by) in [
        ("der(omega_sl)", "M_lim"),
        ("der(omega_d)", "M_Bsl"),
        ("der(psi_slip)", "omega_d"),
        ("M_cd", "M_sl"),
        ("M_Rd", "omega_d"),
    ] {
        assert!(all[index(&model, of)].contains(&(by, None)), "{of} by {by}");
    }
}

/// A state that was written out while it slips goes on in another model with the same bits.
#[test]
fn states_go_on() {
    let mut model = resumed::goes_on(READY, 0.7, 150);
    assert!(get(&mut model, "W_slip") > 1e4);
}
