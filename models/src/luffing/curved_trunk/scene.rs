//! The boom with a curved trunk as scenes describe it and books tell it.

use std::sync::Arc;

use crate::balance::scene::{BALANCE, PublishedBalance};
use crate::balance::symbols as b;
use crate::component::description::{Described, Description, Vocabulary};
use crate::component::draw::polar;
use crate::component::mechanism::Entry;
use crate::component::moved::Moved;
use crate::component::outline::{Limit, Outline};
use crate::component::running::Running;
use crate::component::sheet::{Check, Drawing, Sheet, Summary};
use crate::component::standing::Standing;
use crate::component::telling::fine;
use crate::drive;
use crate::drive::scene::{DRIVE, Driving};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, SOURCE, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::at_rest::at_rest;
use crate::luffing::boom_scene::{INTERPOLATION, OILED_FIDELITY, balance_work, begun, motion, vanishing};
use crate::luffing::counterweight::chapter;
use crate::luffing::curved_trunk::drawing::drawing;
use crate::luffing::curved_trunk::leading::TRUNK;
use crate::luffing::curved_trunk::moving::TrunkInertias;
use crate::luffing::curved_trunk::outline::OUTLINE;
use crate::luffing::curved_trunk::pins::slack;
use crate::luffing::curved_trunk::resisting;
use crate::luffing::curved_trunk::stages::{CurvedTrunkBoom, Given};
use crate::luffing::curved_trunk::statics::TrunkWeights;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::tail::{TailArc, Trunk, TrunkChoice};
use crate::luffing::led::scene::{LedRopeScene, ROPE};
use crate::luffing::led::symbols as w;
use crate::luffing::moving;
use crate::luffing::moving::control::luffing::CONTROL;
use crate::luffing::moving::hoisting::HOISTING_KEYS;
use crate::luffing::moving::levels::{self, boom_levels};
use crate::luffing::moving::oil_scene::HYDRAULICS;
use crate::luffing::moving::outline::FOLLOWED;
use crate::luffing::moving::scene::{Inert, Moving, SLEWING, brisk, dynamics, outlasts, turns};
use crate::luffing::moving::told::motion::moved;
use crate::luffing::resistances::scene::{CASES, Cases, left};
use crate::luffing::resistances::{self, checks, told};
use crate::luffing::strength;
use crate::luffing::with_balance::{WithBalance, searched};
use crate::parts::air::AIR_OR_WIND;
use crate::parts::ground::GROUND;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};
use crate::parts::shaping;
use crate::parts::smooth_curve::{NoCurve, SmoothCurve};
use crate::parts::teeth;
use crate::parts::{air, ground, hanging, hydraulics, side_wind, slope, turntable, turntable_control};
use crate::parts::{motor, starts};

/// Keys of `[luffing]` with `kind = "curved_trunk"`.
pub const KEYS: &[Key] = &[
    Key::kind(
        &["curved_trunk"],
        "A boom with a trunk on its head, on whose curved tail a flexible tie lies.",
    ),
    Key::quantity(&s::B, Sign::Positive),
    Key::quantity(&s::A, Sign::Positive),
    Key::quantity(&s::L_T, Sign::Positive),
    Key::quantity(&s::O3_X, Sign::Any),
    Key::quantity(&s::O3_Y, Sign::Any),
    Key::quantity(&s::X_8, Sign::Any),
    Key::weight(&s::Q).optional(),
    ROPE,
    OILED_FIDELITY,
    Key {
        required: true,
        ..Key::kinds(
            "tail",
            &[("arc", ARC), ("points", POINTS)],
            "The trunk's tail, on whose upper side the tie lies, in the trunk's frame: from B along the line to A and square to it.",
        )
    },
    Key::table("motion", MOTION, "Working range of the boom."),
    Key::part("weights", WEIGHTS, "Own weights of boom and trunk, and where they act."),
    DRIVE,
    BALANCE,
    Key::part(
        "dynamics",
        DYNAMICS,
        "Inertias, friction, drive and rope of boom and trunk in motion.",
    ),
    CONTROL,
    AIR_OR_WIND,
    GROUND,
    Key::part("hoisting", HOISTING_KEYS, "Rope and hoist of a load that swings."),
    SLEWING,
    HYDRAULICS,
    INTERPOLATION,
    CASES,
    Key::part("limits", LIMITS, "Limits that the book checks."),
    SOURCE,
];

const MOTION: &[Key] = &motion(&s::FROM, &s::TO, &s::OMEGA);

const CLAMPED: Key = Key::choice(
    "clamped",
    &["front", "rear"],
    "End of the tail at which the tie is clamped: \"front\", from which the tail is listed, or \"rear\".",
);

const ARC: &[Key] = keys! { s:
    Z_X, Z_Y, RHO > 0, ZETA_F, ZETA_R, B_T > 0 [optional];
    Key::kind(&["arc"], "An arc."), CLAMPED
};

const POINTS: &[Key] = keys! { s:
    B_T > 0 [optional];
    Key::kind(&["points"], "A smooth curve through points."), CLAMPED,
    Key::new("points", Kind::Tables(POINT, 40), "Points of the tail from its front end to its rear end, over its upper side.")
};

const POINT: &[Key] = keys! { s: X_T, Y_T };

const WEIGHTS: &[Key] = keys! { s:
    G_B [or_mass], R_B >= 0, CHI_B [usually(0.0)], G_T [or_mass], R_T >= 0, CHI_T [usually(0.0)]
};

static DYNAMICS: &[Key] = &dynamics::<19>(&[
    Key::quantity(&s::J_B, Sign::NotNegative),
    Key::quantity(&s::J_T, Sign::NotNegative),
]);

const INERTIAS: &[&Symbol] = listed!(s: J_B, J_T);

const LIMITS: &[Key] = &Limit::keys::<30>(OUTLINE.limits);

/// A boom with a curved trunk as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct CurvedTrunk {
    /// At the start of the working range.
    pub(super) given: Given<f64>,
    pub(super) driving: Driving,
    led: LedRopeScene,
    /// At a level that moves by itself.
    pub(super) moving: Option<Moving>,
    /// Published results of the balance.
    published_balance: Option<PublishedBalance>,
    cases: Cases,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<CurvedTrunk>::entry("curved_trunk", KEYS);

impl Described for CurvedTrunk {
    type Component = CurvedTrunkBoom;
    const ID: &'static str = "curved_trunk";
    const TABLE: &'static str = "luffing";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = FOLLOWED;
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "curved_trunk_symbol",
        own: &[s::ALL],
        shared: &[
            w::ALL,
            b::ALL,
            drive::symbols::ALL,
            gravity::ALL,
            moving::symbols::ALL,
            moving::control::luffing::ALL,
            shaping::ALL,
            moving::control::hoist::ALL,
            resistances::symbols::ALL,
            motor::ALL,
            starts::ALL,
            teeth::ALL,
            strength::symbols::ALL,
            air::ALL,
            ground::ALL,
            hanging::ALL,
            turntable::ALL,
            turntable_control::ALL,
            side_wind::ALL,
            slope::ALL,
            hydraulics::symbols::ALL,
        ],
    };

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(CurvedTrunk, Motion)> {
        let moving = moves(v, gravity, found);
        let begun = begun(v, "G_b, r_b, G_t and r_t", found);
        let driving = drive::scene::read(v, found);
        let tail = v.table("tail")?;
        let arc = TailArc::read(tail);
        let curve = if arc.is_none() { Some(curve(tail, found)?) } else { None };
        let ((range, balance), driving) = begun.zip(driving)?;
        drive::scene::meets(v, &driving, None, [range.from, range.to], found);
        let moves = moving.as_ref().map(|_| &drive::scene::TURNED[..]);
        drive::scene::fits(v, driving.gear.as_ref(), (moves, v.has("Q")), found);
        if let Some(moving) = &moving {
            brisk(v, moving, &range, found);
            outlasts(v, moving, &range, [listed!(s: B, A, X_8), listed!(s: G_B, G_T)], found);
        }
        let cases = Cases::read(v, &resisting::PARTS, balance.as_ref(), gravity, found);
        let led = LedRopeScene::read(v, resisting::PARTS.bodies, moving.as_ref(), found);
        let given = at_rest! { (cases, driving) without [hoist_falls, oil, oil_parts];
            phi: One(&b::PHI, range.from),
            omega: One(&s::OMEGA, range.speed),
            load: v.of(&s::Q).map(|q| One(&s::Q, q)),
            rope: led.falls,
            sheaves: led.sheaves.clone(),
            leading: led.leading,
            trunk: Trunk::read(v)?,
            arc,
            width: tail.of(&s::B_T).map(|width| One(&s::B_T, width)),
            weights: v.part("weights", TrunkWeights::read)?,
            balance,
            choice: TrunkChoice {
                range,
                from_rear: tail.text("clamped") == Some("rear"),
                curve,
                crank: driving.branch(),
            },
            inertias: match &moving {
                Some(_) => Some(TrunkInertias::read(v.table("dynamics")?)?),
                None => None,
            },
        };
        let read = CurvedTrunk {
            given,
            driving,
            led,
            moving,
            published_balance: v.table("balance").and_then(PublishedBalance::read),
            cases,
        };
        Some((read, range))
    }

    fn given(this: &Description<CurvedTrunk>) -> Given<f64> {
        Given {
            inertias: None,
            ..this.given.clone()
        }
    }

    /// Besides what all booms are checked for: a tie that would have to push.
    fn check(this: &mut Description<CurvedTrunk>, v: &Values, found: &mut Vec<Diagnostic>) {
        let mut model = this.standing();
        told::check::<CurvedTrunkBoom>(&model, &this.cases, v, found);
        let before = found.len();
        this.led.check(&model, TRUNK, v, found);
        if found.len() > before {
            return;
        }
        if this.moving.is_some() {
            drive::hauling::check(&mut model, v, found);
        }
        let results = 0..model.variables().len();
        let tie = results
            .clone()
            .find(|&index| model.variables()[index].symbol == &s::N_T);
        let fault = fine(&this.motion).find_map(|at| {
            let reached = model.set(0, at);
            let fault = reached.and_then(|()| results.clone().try_for_each(|index| model.get(index).map(drop)));
            let pull = tie.and_then(|index| model.get(index).ok());
            fault.err().map(|fault| fault.message).or_else(|| slack(at, pull?))
        });
        if let Some(message) = fault {
            let label = "not possible all over the working range";
            let help = "move what it names, or keep the working range away from there";
            found.push(v.refuse("motion", message, label, help));
        }
    }

    boom_levels!(CurvedTrunk with inertias);

    fn chapters(&self) -> Vec<&'static str> {
        let moving = self.moving.map(|_| "motion");
        moving
            .into_iter()
            .chain(self.given.balance.map(|_| "balance"))
            .chain(self.cases.are_there().then_some("cases"))
            .collect()
    }

    fn searched(_: &Description<CurvedTrunk>, model: &Standing) -> Vec<Summary> {
        searched::<CurvedTrunkBoom>(model)
    }

    /// Virtual work against equilibrium and the instantaneous centre, and the loop of boom, trunk and tie.
    fn identities(this: &Description<CurvedTrunk>, model: &mut Standing) -> Vec<Check> {
        let given = &this.given;
        let trunk = &given.trunk;
        let mut checks = balance_work::<CurvedTrunkBoom>(model, &s::AGREEMENT);
        let loop_of = [&s::T_X, &s::T_Y, &s::F];
        checks.push(vanishing(model, ("trunk_loop", &s::AGREEMENT), &loop_of, |row| {
            let free = Point::new(trunk.o3_x - row[0], trunk.o3_y - row[1]);
            [plane::length(free), -row[2]]
        }));
        if given.load.is_none() {
            return checks;
        }
        let by_pole = [&s::M_Q, &s::M_Q_P];
        checks.push(vanishing(model, ("trunk_pole", &s::AGREEMENT), &by_pole, |row| {
            [row[0], -row[1]]
        }));
        checks.push(power(given, model));
        let mut symbols = vec![&s::M_D, &s::M_Q];
        symbols.extend(given.weights.map(|_| &s::M_G));
        symbols.extend(given.balance.map(|_| &b::M_UR));
        checks.push(vanishing(model, ("equilibrium", &s::AGREEMENT), &symbols, |row| {
            let other = |place: usize| row.get(place).copied().unwrap_or(0.0);
            [row[0], -row[1], -other(2), other(3)]
        }));
        checks.extend(drive::checks::by_slider(&this.driving, model, &s::AGREEMENT));
        checks.extend(checks::identities::<CurvedTrunkBoom>(model, &this.cases, &s::M_D));
        checks
    }

    fn assumptions(this: &Description<CurvedTrunk>) -> Vec<&'static str> {
        let forces = this.given.load.map(|_| "trunk_forces");
        let Some(moving) = &this.moving else {
            let level = this.table.map_or("trunk_level_static", |_| "trunk_level_table");
            let rope = this.led.falls.map_or("trunk_rope", |_| "led_rope");
            return [level, rope].into_iter().chain(forces).collect();
        };
        let led = this.led.assumed(moving);
        let (load, rope) = led.map_or(("trunk_load", vec!["trunk_rope"]), |rope| ("rope_load", rope));
        let balance = this.given.balance.map(|_| "counterweight");
        [levels::assumed(moving), "trunk_masses", "trunk_taut"]
            .into_iter()
            .chain(balance)
            .chain(moving.taken(load))
            .chain(rope)
            .chain(levels::solved(moving))
            .collect()
    }

    fn uncovered(this: &Description<CurvedTrunk>) -> Vec<&'static str> {
        left(levels::uncovered("pin_friction", this.moving.as_ref()), &this.cases)
    }

    /// The boom at the ends (faint) and in the middle of the working range, with trunk, tail, tie and the path of the head.
    fn drawing(this: &Description<CurvedTrunk>, told: f64) -> Drawing {
        drawing(&this.given, &this.led, &this.driving, &this.motion, told)
    }

    fn in_motion(this: &Description<CurvedTrunk>) -> Option<Moved> {
        moved(this)
    }

    fn more(this: &Description<CurvedTrunk>, model: &mut Standing, sheet: &mut Sheet) {
        sheet.cases = told::chapter(this, model, &this.cases);
        sheet.balance = chapter::<CurvedTrunkBoom>(model, CurvedTrunkBoom::SYMBOLS, this.published_balance.as_ref());
    }
}

/// Virtual work of load and weights against the power of each link about its instantaneous centre: the trunk's is where the
/// lines of boom and free tie meet. [Ports001, 5.9]
fn power(given: &Given<f64>, model: &mut Standing) -> Check {
    let (trunk, q) = (&given.trunk, given.load.map_or(0.0, |load| load.1));
    let o3 = Point::new(trunk.o3_x, trunk.o3_y);
    let mut symbols = vec![&b::PHI, &s::T_X, &s::T_Y, &s::A_X, &s::ALPHA, &s::M_Q];
    symbols.extend(given.weights.map(|_| &s::M_G));
    let led = symbols.len();
    symbols.extend(
        given
            .rope
            .iter()
            .flat_map(|_| [&w::M_R1, &w::M_R2, &w::F_R2X, &w::F_R2Y]),
    );
    vanishing(model, ("power", &s::AGREEMENT), &symbols, |row| {
        let (boom, tie) = (polar(trunk.b, row[0]), Point::new(row[1], row[2]) - o3);
        // From O1 along the boom, in parts of it.
        let part = plane::cross(o3, tie) / plane::cross(boom, tie);
        // What a point x and what the centre does for its rise.
        let rises = |x: f64| {
            if part.is_finite() {
                [x, -part * boom.x].map(|length| length / (1.0 - part))
            } else {
                [0.0, boom.x]
            }
        };
        let (mut of_boom, mut of_trunk) = (0.0, rises(row[3]).map(|rise| q * rise));
        if let Some(w) = &given.weights {
            of_boom = w.g_b * polar(w.r_b, row[0] + w.chi_b).x;
            let own = rises(boom.x + polar(w.r_t, row[4] + w.chi_t).x);
            of_trunk = [0, 1].map(|i| of_trunk[i] + w.g_t * own[i]);
        }
        let work = row[5] + if led > 6 { row[6] } else { 0.0 };
        let mut rope = [0.0; 2];
        if let [on_boom, on_trunk, x, y] = row[led..] {
            let force = Point::new(x, y);
            let of_trunk = if part.is_finite() {
                (on_trunk + plane::cross(boom * (1.0 - part), force)) / (1.0 - part)
            } else {
                plane::dot(force, Point::new(-boom.y, boom.x))
            };
            rope = [on_boom, of_trunk];
        }
        [work, rope[0] - of_boom, rope[1] - of_trunk[0], -of_trunk[1]]
    })
}

/// What the scene gives of its motion; mistakes go to `found`.
fn moves(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<Moving> {
    let bodies = Inert {
        loaded: v.has("Q"),
        inertias: INERTIAS,
        bar: [&s::B, &s::J_B],
        reach: &s::B,
        help: "add [luffing.dynamics] with J_b and J_t (kg.m2)",
        bodies: "boom and trunk",
        weighs: |weights| turns(weights, &s::G_B, &s::R_B) || turns(weights, &s::G_T, &s::R_T),
        leads: Some(ROPE.name),
    };
    Moving::new(v, gravity, &bodies, found)
}

/// The tail through the points of its table; mistakes go to `found`.
fn curve(tail: &Values, found: &mut Vec<Diagnostic>) -> Option<Arc<SmoothCurve>> {
    let tables = tail.tables("points");
    let points: Vec<Point<f64>> = tables
        .iter()
        .map(|point| Some(Point::new(point.of(&s::X_T)?, point.of(&s::Y_T)?)))
        .collect::<Option<_>>()?;
    let fault = match SmoothCurve::new(&points) {
        Ok(curve) => return Some(Arc::new(curve)),
        Err(fault) => fault,
    };
    let (place, what, help) = match fault {
        _ if points.len() < 3 => (
            tail.place("points"),
            format!("a tail of {} points", points.len()),
            "give three points or more, or an arc",
        ),
        NoCurve::Concave(first) => (
            tables[first - 1].span.clone(),
            format!(
                "between its points {first} and {} the tail is straight or concave",
                first + 1
            ),
            "the tie lies on a convex side: from the front end to the rear end the tail turns counter-clockwise, from point \
             to point by less than half a turn",
        ),
        NoCurve::Uneven => (
            tail.place("points"),
            "no smooth curve goes through the points of the tail".to_owned(),
            "give points at about even distances, none twice",
        ),
    };
    found.push(Diagnostic::new(place, what, "not a tail that a tie lies on").help(help));
    None
}
