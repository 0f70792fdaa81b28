//! The boom with a curved trunk on a flexible tie: hand calculations, closed forms, references of 50 digits, an arc against
//! points of it, a tail that shrinks to a hinge against the double link, virtual work against equilibrium at random, every
//! kind of balance.

#[path = "common/counting.rs"]
mod counting;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::variable::Role;
use lemnis_models::luffing::curved_trunk::contact::Contact;
use lemnis_models::luffing::curved_trunk::position::TrunkPosition;
use lemnis_models::luffing::curved_trunk::tail::{TailArc, Trunk, TrunkChoice, TrunkTail};
use lemnis_models::luffing::curved_trunk::velocity::TrunkTravel;
use lemnis_models::luffing::double_link::geometry::Geometry;
use lemnis_models::luffing::double_link::parameters::{Driven, Jib, Lengths, Parameters};
use lemnis_models::luffing::double_link::position::Position;
use lemnis_models::luffing::double_link::velocity::Velocity;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::parts::motion::Motion;
use lemnis_models::scene::{DEFAULT, Scene};
use proptest::prelude::*;

const READY: &str = include_str!("../scenes/curved_trunk.toml");

/// Over round numbers, with a tail that is an arc about the boom's head.
const ROUND: &str = "name = \"Trunk\"\ntitle = \"Trunk\"\n[luffing]\nkind = \"curved_trunk\"\nb = \"20 m\"\na = \"12 m\"\n\
    L_t = \"20 m\"\nO3_x = \"-6 m\"\nO3_y = \"12 m\"\nX_8 = \"2 m\"\nQ = \"100 kN\"\n[luffing.motion]\nfrom = \"50 deg\"\n\
    to = \"70 deg\"\nstep = \"1 deg\"\nspeed = \"1 deg/s\"\n[luffing.weights]\nG_b = \"60 kN\"\nr_b = \"8 m\"\n\
    G_t = \"40 kN\"\nr_t = \"2 m\"\n";
const TAIL: &str = "[luffing.tail]\nkind = \"arc\"\nZ_x = \"0 m\"\nZ_y = \"0 m\"\nrho = \"4 m\"\nzeta_f = \"120 deg\"\n\
    zeta_r = \"240 deg\"\nb_t = \"50 mm\"\n";

fn round() -> String {
    format!("{ROUND}{TAIL}")
}

fn model(text: &str) -> Model {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
    scene.model().expect("exists")
}

fn index(model: &Model, name: &str) -> usize {
    let index = model.variables().iter().position(|variable| variable.name() == name);
    index.unwrap_or_else(|| panic!("no {name}"))
}

fn at(model: &mut Model, degrees: f64, name: &str) -> f64 {
    model.set(0, degrees.to_radians()).expect("an angle");
    model.get(index(model, name)).expect("exists")
}

fn refused(text: &str) -> String {
    let found = Scene::parse(text).expect_err("refused");
    let [one] = found.as_slice() else { panic!("{found:?}") };
    assert!(one.help.is_some());
    one.message.clone()
}

/// At 60° and at 52°, about B: f² = d² − ρ², and α is the angle of d less that of the contact and of the free tie.
#[test]
fn by_hand() {
    // 60°: B = (10, 17.3205081), d = (−16, −5.3205081), d² = 256 + 28.3078062 = 284.3078062, f = √268.3078062 = 16.3801040,
    // w = 20 − f = 3.6198960, ζ = 120° + w/4 = 120° + 51.8511911° = 171.8511911°. Angle of d 198.3936045°, of v
    // ζ + atan(f/4) = 171.8511911° + 76.2770190° = 248.1282101°: α = −49.7346056°, cos α = 0.6463290, sin α = −0.7630588.
    // A = B + 12 (0.6463290, −0.7630588) = (17.7559483, 8.1638020). Tie: ζ + 90° + α = 212.1165855°, e = (−0.8469681,
    // −0.5316438). h_O = −10 · 0.5316438 + 17.3205081 · 0.8469681 = 9.3534794, i_2 = −h_O/4 = −2.3383698. y′_A = 10 − 2.3383698 ·
    // 7.7559483 = −8.1362756: M_Q = −813.62756 kN·m. M_B = 100 · 7.7559483 + 40 · 2 · 0.6463290 = 827.3011503 kN·m,
    // N_t = M_B/4 = 206.8252876 kN, q_t = N_t/4 = 51.7063219 kN/m, over 50 mm 1.0341264 MPa. M_G = 60 · 4 + 40 · (10 −
    // 2.3383698 · 1.2926580) = 519.0914961 kN·m, M_D = −813.6275592 + 519.0914961 = −294.5360631 kN·m.
    //
    // 52°: B = (12.3132295, 15.7602151), d = (−18.3132295, −3.7602151), d² = 335.3743751 + 14.1392174 = 349.5135923,
    // f = √333.5135923 = 18.2623545, w = 1.7376455, ζ = 144.8899382°; d 191.6031490°, atan(f/4) = 77.6456139°:
    // α = −30.9324031°. A = B + 12 (0.8577743, −0.5140264) = (22.6065216, 9.5918978). Tie 203.9575351°, e = (−0.9138467,
    // −0.4060595), h_O = 9.4025167, i_2 = −2.3506292, y′_A = 12.3132295 − 2.3506292 · 10.2932921 = −11.8824831. M_B =
    // 1029.3292080 + 68.6219472 = 1097.951155 kN·m, N_t = 274.4877888 kN.
    let expected = [
        (60.0, "w", 3.619_896_026),
        (60.0, "f", 16.380_103_97),
        (60.0, "alpha", -49.734_605_62_f64.to_radians()),
        (60.0, "A.x", 17.755_948_28),
        (60.0, "A.y", 8.163_801_997),
        (60.0, "R", 19.755_948_28),
        (60.0, "h_t", 4.0),
        (60.0, "i_2", -2.338_369_846),
        (60.0, "M_Q", -813_627.559_2),
        (60.0, "M_Q.P", -813_627.559_2),
        (60.0, "M_G", 519_091.496_1),
        (60.0, "M_D", -294_536.063_1),
        (60.0, "N_t", 206_825.287_6),
        (60.0, "q_t", 51_706.321_9),
        (60.0, "p_t", 1_034_126.438),
        (52.0, "w", 1.737_645_487),
        (52.0, "f", 18.262_354_51),
        (52.0, "alpha", -30.932_403_1_f64.to_radians()),
        (52.0, "A.x", 22.606_521_59),
        (52.0, "A.y", 9.591_897_784),
        (52.0, "i_2", -2.350_629_164),
        (52.0, "M_Q", -1_188_248.305),
        (52.0, "M_G", 626_741.938),
        (52.0, "N_t", 274_487.788_8),
    ];
    let mut model = model(&round());
    for (degrees, name, expected) in expected {
        let found = at(&mut model, degrees, name);
        assert!(
            (found - expected).abs() <= 2e-9 * expected.abs(),
            "{name} at {degrees}: {found} {expected}"
        );
    }
}

/// Trunk, tail and tie by their numbers: b, a, L_t, E, Z, ρ, ζ_f, ζ_r.
fn built(g: [f64; 10]) -> (Trunk<f64>, Option<TailArc<f64>>) {
    let [b, a, l_t, o3_x, o3_y, z_x, z_y, rho, zeta_f, zeta_r] = g;
    let trunk = Trunk {
        b,
        a,
        l_t,
        o3_x,
        o3_y,
        x_8: 0.0,
    };
    let arc = TailArc {
        z_x,
        z_y,
        rho,
        zeta_f,
        zeta_r,
    };
    (trunk, Some(arc))
}

fn choice() -> TrunkChoice {
    TrunkChoice {
        range: Motion {
            from: 0.0,
            to: 1.0,
            step: 0.1,
            speed: 1.0,
            by_part: false,
            period: std::f64::consts::TAU,
        },
        from_rear: false,
        curve: None,
        crank: Branch::Left,
    }
}

/// w, α, y_A and i_2 at an angle (rad) of the boom.
fn solved(g: [f64; 10], phi: f64) -> [f64; 4] {
    let ((trunk, arc), choice) = (built(g), choice());
    let tail = TrunkTail::new(&trunk, &arc, &choice).expect("a tail");
    let contact = Contact::new(&tail, &choice, &phi).expect("closes");
    let position = TrunkPosition::new(&tail, &contact);
    let along = position.along;
    [
        contact.w,
        libm::atan2(along.y, along.x),
        position.a.y,
        TrunkTravel::new(&position).i_2,
    ]
}

const BASE: [f64; 10] = [21.5, 14.2, 21.05, -6.0, 12.0, -1.15, 0.05, 5.0, 2.3, 4.05];

/// Against the bisection of the same closure with 60 digits (mpmath): in the middle, from 1e-3 to 1e-12 rad before the ends of
/// the tail, with a tail that is nearly a hinge and one that is nearly straight, and over six decades of length.
#[test]
#[expect(
    clippy::excessive_precision,
    reason = "the references have more digits than numbers here"
)]
fn the_closure_agrees_with_fifty_digits() {
    let hinge = |rho| [21.5, 14.2, 21.05, -6.0, 12.0, -5.0, 0.3, rho, 1.8, 4.5];
    let flat = [
        21.5,
        14.2,
        21.05,
        -6.0,
        12.0,
        -1.15,
        0.05 - 5e4,
        5.0e4 + 5.0,
        1.57,
        1.5702,
    ];
    let scaled = |scale: f64| {
        let mut g = BASE;
        g[..8].iter_mut().for_each(|length| *length *= scale);
        g
    };
    #[rustfmt::skip]
    let references: [([f64; 10], f64, [f64; 4]); 15] = [
        (BASE, 0.9, [2.4018120563203239532, -0.65434424266649138045, 8.1988538283479251533, -1.1925486814357521954]),
        (BASE, 1.2, [5.8654043941574857282, -0.98436392789436789442, 8.2113726409844718838, -0.98574870889629049172]),
        (BASE, 0.6920939900663968, [0.011501864274776702353, -0.395806613141786804, 8.2453950715857188966, -1.2921320941439747293]),
        (BASE, 1.4485928947701008, [8.7385773882035276088, -1.1891200711430290698, 8.1614722918825905773, -0.60709165367557254531]),
        (BASE, 0.6910949900663969, [0.000011501931655253723146, -0.39451554885456740348, 8.2457719478631130421, -1.2925811568495207907]),
        (BASE, 1.4495918947701008, [8.7499885785476317681, -1.1897254028285349924, 8.1608805749553003602, -0.60478215918620793817]),
        (BASE, 0.6910939910663969, [1.1501932196372760195e-8, -0.39451425756576752885, 8.2457723253928447378, -1.2925816058019209727]),
        (BASE, 1.4495928937701006, [8.7499999885785475367, -1.1897260070047561764, 8.1608799810977941316, -0.60477984538450861817]),
        (BASE, 0.6910939900673969, [1.1502476010962452421e-11, -0.39451425627447851239, 8.2457723257703751198, -1.2925816062508732598]),
        (BASE, 1.4495928947691008, [8.749999999988579757, -1.1897260076089313713, 8.1608799805039343545, -0.60477984307070210581]),
        (hinge(1e-6), 0.7390050533320341, [1.2000000000000000082e-6, -1.087754222215029031, 1.9060643157657841146, -1.6673806275572927003]),
        (hinge(0.001), 0.7390797554075543, [0.0012000000000000000536, -1.087638654686396741, 1.9080137180625745198, -1.666884802005131515]),
        (flat, 1.0233142544761333, [5.0004999999897616373, -3.0664547705142802021, 17.29156072808084191, 3.4525223835568480492]),
        (scaled(0.001), 1.1, [0.0047076280617339763951, -0.8813616188271664934, 0.0082041570010262553706, -1.0704370491465058155]),
        (scaled(1000.0), 1.1, [4707.6280617339753319, -0.8813616188271663203, 8204.1570010262546669, -1.0704370491465058042]),
    ];
    for (g, phi, expected) in references {
        let found = solved(g, phi);
        // The nearly straight tail turns by 2e-4 rad over its ten metres, and lies 5e4 m from its centre.
        let bound = if g[7] > 1e4 { 1e-9 } else { 1e-15 };
        let scales = [g[2], 3.0, g[0] + g[1], 3.0];
        for ((found, expected), scale) in found.into_iter().zip(expected).zip(scales) {
            let off = (found - expected).abs() / scale;
            assert!(off <= bound, "{g:?} {phi}: {found} {expected}, {off:e}");
        }
    }
}

/// An arc about B: f² = d² − ρ² in closed form, over the whole tail.
#[test]
fn an_arc_about_the_head_has_a_closed_form() {
    let mut model = model(&round());
    for step in 0..=2000 {
        let phi = (50.0 + 0.01 * f64::from(step)).to_radians();
        let (sin, cos) = Calc::sin_cos(phi);
        let (x, y) = (-6.0 - 20.0 * cos, 12.0 - 20.0 * sin);
        let free = (x * x + y * y - 16.0).sqrt();
        let zeta = 120_f64.to_radians() + (20.0 - free) / 4.0;
        let alpha = f64::direction(x, y) - zeta - f64::direction(4.0, free);
        model.set(0, phi).expect("an angle");
        let [found_free, found_alpha] = ["f", "alpha"].map(|name| model.get(index(&model, name)).expect("closes"));
        assert!((found_free - free).abs() <= 4e-14, "{found_free} {free}");
        assert!((found_alpha - alpha).abs() <= 4e-15, "{found_alpha} {alpha}");
    }
}

/// The ready scene's arc as so many points.
fn through_points(count: u32) -> String {
    let (start, end) = (
        READY.find("[luffing.tail]").expect("there"),
        READY.find("[luffing.motion]").expect("there"),
    );
    let mut tail = "[luffing.tail]\nkind = \"points\"\nb_t = \"60 mm\"\n".to_owned();
    for i in 0..count {
        let (sin, cos) = Calc::sin_cos((132.0 + 100.0 * f64::from(i) / f64::from(count - 1)).to_radians());
        tail += &format!(
            "[[luffing.tail.points]]\nx_t = \"{:?} m\"\ny_t = \"{:?} m\"\n",
            -1.15 + 5.0 * cos,
            0.05 + 5.0 * sin
        );
    }
    format!("{}{tail}{}", &READY[..start], &READY[end..])
}

/// A curve through points of the arc tends to it: its own error falls with the fourth power of their distance, that of its
/// radius with the second.
#[test]
fn points_of_an_arc_give_the_arc() {
    let mut arc = model(READY);
    let mut last = [f64::INFINITY; 3];
    for (count, bounds) in [
        (6, [3e-4, 3e-4, 2e-2]),
        (11, [1e-5, 2e-5, 3e-3]),
        (21, [5e-7, 1e-6, 6e-4]),
        (40, [3e-8, 3e-8, 1e-4]),
    ] {
        let mut points = model(&through_points(count));
        let mut off = [0.0_f64; 3];
        for step in 0..=76 {
            let degrees = 42.0 + 0.5 * f64::from(step);
            for (off, (name, scale)) in off.iter_mut().zip([("A.y", 1.0), ("M_D", 1e6), ("rho_t", 5.0)]) {
                let difference = at(&mut arc, degrees, name) - at(&mut points, degrees, name);
                *off = off.max(difference.abs() / scale);
            }
        }
        println!("{count} points: {off:?}");
        for ((off, bound), last) in off.iter().zip(bounds).zip(last) {
            assert!(*off <= bound && *off < last, "{count}: {off:e}");
        }
        last = off;
    }
}

/// A tail that shrinks to a hinge at Z: the tie is the rocker of a double link, its length the rocker's. The difference falls
/// as the radius.
#[test]
fn a_tail_that_is_a_hinge_gives_the_double_link() {
    let (z_x, z_y, l_t) = (-5.0, 0.3, 21.05);
    let rear = f64::sqrt(z_x * z_x + z_y * z_y);
    let scene = Scene::parse(DEFAULT).expect("valid");
    let base = scene
        .mechanism
        .of::<lemnis_models::luffing::double_link::scene::Luffing>();
    let base = base.expect("a double link").parameters;
    let lengths = Lengths {
        x_1: 21.5,
        x_2: rear,
        x_3: l_t,
        x_4: 14.2,
        x_5: 6.0,
        x_6: 12.0,
        ..base.lengths
    };
    let parameters = Parameters {
        driven: Driven::Boom,
        lengths,
        // From the rear arm to the front one.
        jib: Jib::Angle(f64::direction(z_x, z_y)),
        branch: Branch::Left,
        ..base
    };
    let geometry = Geometry::new(&parameters).expect("closes");
    for phi in [0.75, 0.85, 0.95, 1.05] {
        let position = Position::new(&geometry, phi).expect("closes");
        let velocity = Velocity::new(&position);
        let exact = [position.a.y, velocity.i_2];
        let off = [1e-2, 1e-4, 1e-6].map(|rho| {
            let [_, _, y_a, i_2] = solved([21.5, 14.2, l_t, -6.0, 12.0, z_x, z_y, rho, 1.8, 4.5], phi);
            [(y_a - exact[0]).abs(), (i_2 - exact[1]).abs()]
        });
        for (coarse, fine) in off.iter().zip(&off[1..]) {
            for (coarse, fine) in coarse.iter().zip(fine) {
                assert!((fine / coarse * 100.0 - 1.0).abs() < 0.05, "{phi}: {off:?}");
            }
        }
        assert!(off[2][0] < 1e-5 && off[2][1] < 1e-5, "{off:?}");
    }
}

/// Derivatives by every given number against central differences of the values, at an arc and at points.
#[test]
fn derivatives_are_exact() {
    for text in [READY.to_owned(), through_points(9)] {
        let mut model = model(&text);
        model.set(0, 1.0).expect("an angle");
        let given: Vec<usize> = (0..model.variables().len())
            .filter(|&i| matches!(model.variables()[i].role, Role::Input | Role::Parameter | Role::Tunable))
            .collect();
        let names = ["A.y", "alpha", "w", "i_2", "M_D", "N_t", "q_t", "p_t", "dM"];
        let outputs = names.map(|name| index(&model, name));
        for &by in &given {
            let value = model.get(by).expect("given");
            let step = 1e-6 * value.abs().max(1e-3);
            let known = model.variables()[by].quantity();
            let mut tangent = model.tangent(&|quantity| f64::from(quantity == known));
            let values = |model: &mut Model, value: f64| {
                model.set(by, value).expect("allowed");
                outputs.map(|output| model.get(output).expect("closes"))
            };
            let exact = outputs.map(|output| model.derivative(&mut tangent, output).expect("exists"));
            let (above, below) = (values(&mut model, value + step), values(&mut model, value - step));
            values(&mut model, value);
            for i in 0..outputs.len() {
                let difference = (above[i] - below[i]) / (2.0 * step);
                let scale = above[i].abs() / step;
                assert!(
                    (exact[i] - difference).abs() <= 2e-6 * difference.abs() + 1e-14 * scale,
                    "d{}/d{}: {} {difference}",
                    names[i],
                    model.variables()[by],
                    exact[i]
                );
            }
        }
    }
}

/// Balances of every kind on the boom: what is left is what the drive gives, and the exact ones leave nothing.
#[test]
fn balances_of_every_kind() {
    let tail = "kind = \"tail\"\nG_c = \"300 kN\"\nr_c = \"3 m\"\nchi_c = \"0 deg\"\n";
    let parallel = "kind = \"parallelogram\"\nG_c = \"205 kN\"\nr_c = \"4 m\"\nchi_c = \"0 deg\"\nr_1 = \"2 m\"\n\
                    alpha_K = \"90 deg\"\nd_1 = \"5 m\"\ndelta_1 = \"100 deg\"\n";
    let curved = "kind = \"curved_rail\"\nG_c = \"300 kN\"\nr_1 = \"9 m\"\nalpha_K = \"10 deg\"\nL_r = \"20 m\"\ny_0 = \"8 m\"\n\
                  phi_0 = \"60 deg\"\n";
    let straight = "kind = \"straight_rail\"\nG_c = \"90 kN\"\nr_1 = \"9 m\"\nalpha_K = \"0 deg\"\nH_x = \"-1 m\"\n\
                    H_y = \"14 m\"\nlambda = \"80 deg\"\n";
    let lever = "kind = \"lever\"\nbranch = \"left\"\nd_1 = \"9 m\"\ndelta_1 = \"105 deg\"\nr_1 = \"3 m\"\n\
                 alpha_K = \"20 deg\"\nl_1 = \"9 m\"\nR_1 = \"3 m\"\nchi_5 = \"150 deg\"\nM_5 = \"500 kN.m\"\n";
    for (kind, vanishes) in [
        (tail, false),
        (parallel, false),
        (curved, true),
        (straight, false),
        (lever, false),
    ] {
        let scene = format!("{}[luffing.balance]\n{kind}", round());
        let scene = Scene::parse(&scene).unwrap_or_else(|found| panic!("{kind}: {found:?}"));
        let mut model = scene.model().expect("exists");
        for degrees in [50.0, 56.5, 60.0, 70.0] {
            let mut get = |name| at(&mut model, degrees, name);
            let (m_q, m_g, m_d) = (get("M_Q"), get("M_G"), get("M_D"));
            let (m_0, m_ur, left) = (get("M_0"), get("M_ur"), get("dM"));
            let scale = m_q.abs().max(m_g.abs()).max(m_ur.abs());
            assert_eq!(m_0.to_bits(), (-m_g).to_bits());
            assert!((m_0 + m_ur - left).abs() <= 1e-13 * scale);
            assert!((m_q - left - m_d).abs() <= 1e-12 * scale, "{kind}");
            assert!((get("M_sum") + m_d).abs() <= 1e-12 * scale);
            assert!((get("M_D_0") - m_q - m_g).abs() <= 1e-13 * scale);
            if vanishes {
                assert!(left.abs() <= 1e-12 * scale, "{kind} {degrees}: {left}");
            }
        }
        let sheet = scene.sheet();
        assert_eq!(sheet.identities.len(), 5, "energy, loop, centre, power, equilibrium");
        for check in &sheet.identities {
            assert!(check.passed(), "{kind} {} {}", check.id, check.value);
        }
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let cases = [
        (
            "from = \"50 deg\"",
            "from = \"30 deg\"",
            "the tie lifts off the clamped end of the tail",
        ),
        (
            "zeta_r = \"240 deg\"",
            "zeta_r = \"180 deg\"",
            "the tie lies on the whole tail and bends round its other end",
        ),
        (
            "zeta_r = \"240 deg\"",
            "zeta_r = \"60 deg\"",
            "the tail has no upper side",
        ),
        ("L_t = \"20 m\"", "L_t = \"8 m\"", "the tie is no longer than the tail"),
        (
            "Z_x = \"0 m\"",
            "Z_x = \"5 m\"",
            "the tie's line passes through the boom's head B, a dead point",
        ),
    ];
    for (old, new, message) in cases {
        let found = refused(&round().replace(old, new));
        assert!(found.contains(message), "{new}: {found}");
    }
    // A trunk whose weight is behind, and no load.
    let slack = round()
        .replace("Q = \"100 kN\"", "Q = \"0 kN\"")
        .replace("r_t = \"2 m\"", "r_t = \"2 m\"\nchi_t = \"180 deg\"");
    let found = refused(&slack);
    assert!(
        found.contains("phi = 50 deg: the tie is slack, it would have to push with"),
        "{found}"
    );
    // Points that turn the other way, lie in one line, or are too few.
    let points = |list: &[[f64; 2]]| {
        let mut tail = "[luffing.tail]\nkind = \"points\"\n".to_owned();
        for [x, y] in list {
            tail += &format!("[[luffing.tail.points]]\nx_t = \"{x} m\"\ny_t = \"{y} m\"\n");
        }
        refused(&format!("{ROUND}{tail}"))
    };
    let found = points(&[[-1.0, 4.0], [-3.0, 3.5], [-4.0, 4.0], [-4.5, 2.0]]);
    assert!(
        found.contains("between its points") && found.contains("straight or concave"),
        "{found}"
    );
    assert!(points(&[[-4.0, 1.0], [-3.0, 3.0], [-1.0, 4.0]]).contains("straight or concave"));
    assert!(points(&[[-1.0, 4.0], [-2.0, 4.0], [-3.0, 4.0]]).contains("straight or concave"));
    assert!(points(&[[-1.0, 4.0], [-3.0, 3.0]]).contains("a tail of 2 points"));
    assert!(points(&[[-1.0, 4.0], [-1.0, 4.0], [-3.0, 3.0]]).contains("no smooth curve"));
    // The working range is none of the angle's.
    let mut model = model(&round());
    model.set(0, 0.1).expect("an angle");
    let fault = model
        .get(index(&model, "A.x"))
        .expect_err("nothing of the tie lies on the tail");
    assert!(
        fault.outside && fault.message.contains("the tie lifts off"),
        "{}",
        fault.message
    );
}

/// Clamped at the rear end the tie runs the other way: with the tail seen in the mirror, the same mechanism upside down.
#[test]
fn a_rear_clamp_is_the_mirror_of_a_front_one() {
    let ((trunk, arc), front) = (built(BASE), choice());
    let arc = arc.expect("an arc");
    let mirrored = TailArc {
        z_y: -arc.z_y,
        zeta_f: -arc.zeta_r,
        zeta_r: -arc.zeta_f,
        ..arc
    };
    let below = Trunk {
        o3_y: -trunk.o3_y,
        ..trunk
    };
    let rear = TrunkChoice {
        from_rear: true,
        ..front.clone()
    };
    let at = |trunk: &Trunk<f64>, arc, choice: &TrunkChoice, phi: f64| {
        let tail = TrunkTail::new(trunk, &Some(arc), choice).expect("a tail");
        let contact = Contact::new(&tail, choice, &phi).expect("closes");
        (contact.w, TrunkPosition::new(&tail, &contact).a)
    };
    for phi in [0.75, 1.0, 1.4] {
        let (w, a) = at(&trunk, arc, &front, phi);
        let (w_rear, a_rear) = at(&below, mirrored, &rear, -phi);
        assert!((w - w_rear).abs() <= 1e-14 * 20.0 && (a.x - a_rear.x).abs() + (a.y + a_rear.y).abs() <= 1e-13);
    }
}

#[test]
fn every_check_of_the_ready_scene_passes() {
    for text in [READY.to_owned(), through_points(9)] {
        let scene = Scene::parse(&text).unwrap_or_else(|found| panic!("{found:?}"));
        let sheet = scene.sheet();
        assert_eq!((sheet.requirements.len(), sheet.identities.len()), (6, 5));
        for check in sheet.checks() {
            assert!(check.passed(), "{} {}", check.id, check.value);
        }
    }
}

/// Nothing is allocated while it runs, neither on an arc nor on a curve through points.
#[test]
fn nothing_is_allocated() {
    for text in [READY.to_owned(), through_points(9)] {
        let mut model = model(&text);
        let outputs: Vec<usize> = (0..model.variables().len())
            .filter(|&i| model.variables()[i].role == Role::Output)
            .collect();
        let run = |model: &mut Model| {
            for step in 0..=10 {
                model.set(0, 0.75 + 0.06 * f64::from(step)).expect("an angle");
                for &output in &outputs {
                    model.get(output).expect("closes");
                }
            }
        };
        run(&mut model);
        let before = counting::count();
        run(&mut model);
        assert_eq!(counting::count(), before);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    /// At random geometries over all decades of length: the tie keeps its length and leaves the tail in its direction, the
    /// drive's moment by equilibrium is virtual work to 1e-12, and both are the rise of load and weights.
    #[test]
    fn tie_and_forces_agree(
        decade in -2..5_i32, b in 0.7..1.3_f64, a in 0.3..0.9_f64, e in [-0.5..0.0_f64, 0.2..0.7_f64], z in [-0.1..0.05_f64, -0.05..0.05_f64],
        rho in 0.15..0.3_f64, ends in [1.8..2.4_f64, 1.0..2.2_f64], part in 0.05..0.95_f64, w in [1.0..1e6_f64, 1.0..1e6_f64, 1.0..1e6_f64],
    ) {
        let scale = 10_f64.powi(decade);
        let (zeta_f, zeta_r) = (ends[0], ends[0] + ends[1]);
        // A tie with which the boom, at one radian, has the point of contact somewhere on the tail.
        let (sin, cos) = Calc::sin_cos(1.0_f64);
        let d = [e[0] - b * cos, e[1] - b * sin];
        let zeta = zeta_f + part * (zeta_r - zeta_f);
        let (sin, cos) = Calc::sin_cos(zeta);
        let p = [z[0] + rho * cos, z[1] + rho * sin];
        // |p + f u| = |d| with u = (−sin, cos).
        let along = -p[0] * sin + p[1] * cos;
        let root = along * along + d[0] * d[0] + d[1] * d[1] - p[0] * p[0] - p[1] * p[1];
        prop_assume!(root > 0.0);
        let free = root.sqrt() - along;
        prop_assume!(free > rho * (zeta_r - zeta) + 0.01);
        let l_t = free + rho * (zeta - zeta_f);
        let text = ROUND
            .replace("\"20 m\"\na", &format!("\"{:?} m\"\na", b * scale))
            .replace("\"12 m\"\nL", &format!("\"{:?} m\"\nL", a * scale))
            .replace("L_t = \"20 m\"", &format!("L_t = \"{:?} m\"", l_t * scale))
            .replace("\"-6 m\"", &format!("\"{:?} m\"", e[0] * scale))
            .replace("O3_y = \"12 m\"", &format!("O3_y = \"{:?} m\"", e[1] * scale))
            .replace("100 kN", &format!("{:e} N", w[0]))
            .replace("60 kN", &format!("{:e} N", w[1]))
            .replace("40 kN", &format!("{:e} N", w[2]))
            .replace("\"8 m\"", &format!("\"{:?} m\"", 0.4 * b * scale))
            .replace("\"2 m\"\n[", &format!("\"{:?} m\"\n[", 0.1 * scale))
            .replace("r_t = \"2 m\"", &format!("r_t = \"{:?} m\"", 0.1 * scale))
            .replace("50 deg", "57.29577 deg").replace("70 deg", "57.29579 deg").replace("\"1 deg\"", "\"0.00001 deg\"")
            + &format!(
                "[luffing.tail]\nZ_x = \"{:?} m\"\nZ_y = \"{:?} m\"\nrho = \"{:?} m\"\nzeta_f = \"{zeta_f:?} rad\"\nzeta_r = \"{zeta_r:?} rad\"\n",
                z[0] * scale, z[1] * scale, rho * scale
            );
        // Some trunks point backwards, and their ties are slack.
        let Ok(scene) = Scene::parse(&text) else { return Ok(()) };
        let mut model = scene.model().expect("exists");
        let turn = 1e-6_f64;
        let mut all = |phi: f64| {
            model.set(0, phi).expect("an angle");
            ["A.y", "A.x", "T.x", "T.y", "w", "f", "h_t", "M_Q", "M_G", "M_D", "M_Q.P", "B.x", "B.y", "alpha", "P.x", "i_2"]
                .map(|name| model.get(index(&model, name)).expect("closes"))
        };
        let [_, a_x, t_x, t_y, w_t, f, h_t, m_q, m_g, m_d, by_pole, b_x, b_y, alpha, p_x, i_2] = all(1.0);
        let size = scale * (b + a);
        prop_assert!((w_t - rho * (zeta - zeta_f) * scale).abs() <= 1e-12 * size, "{w_t}");
        let tie = [e[0] * scale - t_x, e[1] * scale - t_y];
        prop_assert!((Calc::sqrt(tie[0] * tie[0] + tie[1] * tie[1]) - f).abs() <= 1e-13 * size);
        prop_assert!((w_t + f - l_t * scale).abs() <= 1e-13 * size);
        // Square to the radius from the centre of the arc.
        let (sin, cos) = Calc::sin_cos(alpha);
        let centre = [b_x + scale * (cos * z[0] - sin * z[1]), b_y + scale * (sin * z[0] + cos * z[1])];
        let radius = [t_x - centre[0], t_y - centre[1]];
        let beside = radius[0] * tie[0] + radius[1] * tie[1];
        prop_assert!(beside.abs() <= 1e-12 * size * size, "{beside}");
        // Near a dead point all grows as the arm falls.
        let moments = (w[0] + w[1] + w[2]) * size * (1.0 + size / h_t.abs());
        prop_assert!((m_d - m_q - m_g).abs() <= 1e-12 * moments, "{m_d} {m_q} {m_g}");
        prop_assert!((by_pole - m_q).abs() <= 1e-12 * (moments + w[0] * (p_x * i_2).abs()), "{by_pole} {m_q} {a_x}");
        // The rise of load and weights, by their change over a small turn, both ways.
        let mut height = |phi: f64| {
            let [a_y, .., b_y, alpha, _, _] = all(phi);
            let (sin_b, _) = Calc::sin_cos(phi);
            w[0] * a_y + w[1] * 0.4 * b * scale * sin_b + w[2] * (b_y + 0.1 * scale * Calc::sin_cos(alpha).0)
        };
        let rise = (height(1.0 + turn) - height(1.0 - turn)) / (2.0 * turn);
        prop_assert!((rise - m_d).abs() <= 1e-8 * moments * (1.0 + (size / h_t).powi(2)), "{rise} {m_d}");
    }
}
