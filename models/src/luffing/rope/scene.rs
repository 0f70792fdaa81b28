//! The boom on a luffing rope as scenes describe it and books tell it.

use crate::balance::boom::Plain;
use crate::balance::scene::{BALANCE, PublishedBalance};
use crate::balance::symbols as b;
use crate::component::description::{Described, Description, Vocabulary, possible};
use crate::component::draw::{Draw, along, direction, distance};
use crate::component::mechanism::Entry;
use crate::component::moved::Moved;
use crate::component::outline::{Limit, Outline};
use crate::component::sheet::{Check, Drawing, Sheet, Summary};
use crate::component::standing::Standing;
use crate::component::telling::fine;
use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, SOURCE, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::at_rest::at_rest;
use crate::luffing::boom_scene::{INTERPOLATION, MOVING_FIDELITY, balance_work, begun, motion, vanishing};
use crate::luffing::counterweight::chapter;
use crate::luffing::led::scene::elsewhere;
use crate::luffing::moving;
use crate::luffing::moving::control::luffing::CONTROL;
use crate::luffing::moving::hoisting::HOISTING_KEYS;
use crate::luffing::moving::levels::{self, boom_levels};
use crate::luffing::moving::scene::{Inert, Moving, SLEWING, brisk, dynamics, outlasts, turns};
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::told::motion::moved;
use crate::luffing::resistances::scene::{CASES, Cases, left};
use crate::luffing::resistances::{self, checks, told};
use crate::luffing::rope::moving::BoomInertia;
use crate::luffing::rope::outline::OUTLINE;
use crate::luffing::rope::position::{BoomChoice, BoomPosition, Compensation, Rig};
use crate::luffing::rope::resisting;
use crate::luffing::rope::stages::{Given, RopeBoom};
use crate::luffing::strength;
use crate::luffing::with_balance::{WithBalance, searched};
use crate::parts::air::AIR_OR_WIND;
use crate::parts::ground::GROUND;
use crate::parts::motion::{Motion, degrees};
use crate::parts::plane::{self, Point};
use crate::parts::shaping;
use crate::parts::teeth;
use crate::parts::{air, ground, hanging, hydraulics, side_wind, slope, turntable, turntable_control};
use crate::parts::{motor, starts};

/// Quantities of boom and ropes, and of the tackle that carries the load.
mod s {
    pub use crate::luffing::moving::symbols::M_H;
    pub use crate::luffing::rope::symbols::*;
}

/// Keys of `[luffing]` with one of the two kinds.
const fn keys(kind: Key, hoist_rope: &'static [Key]) -> [Key; 21] {
    [
        kind,
        Key::quantity(&s::L, Sign::Positive),
        Key::quantity(&s::F_A, Sign::Any).usually(0.0),
        Key::quantity(&s::X_8, Sign::Any),
        Key::weight(&s::Q).optional(),
        MOVING_FIDELITY,
        Key::table("motion", MOTION, "Working range of the boom."),
        Key::table("tackle", TACKLE, "Luffing tackle between boom and frame."),
        Key::table(
            "hoist_rope",
            hoist_rope,
            "Hoist rope from the boom's head over a sheave of the frame.",
        ),
        Key::part("weights", WEIGHTS, "Own weight of the boom and its centre of gravity."),
        BALANCE,
        Key::part(
            "dynamics",
            DYNAMICS,
            "Inertia, friction, drive and rope of a boom in motion.",
        ),
        CONTROL,
        AIR_OR_WIND,
        GROUND,
        Key::part("hoisting", HOISTING_KEYS, "Rope and hoist of a load that swings."),
        SLEWING,
        INTERPOLATION,
        CASES,
        Key::part(
            "limits",
            LIMITS,
            "What results may come to at most or must come to at least.",
        ),
        SOURCE,
    ]
}

/// With `kind = "rope"`.
pub const KEYS: &[Key] = &keys(Key::kind(&["rope"], "A plain boom on a luffing rope."), HOIST_ROPE);

/// With `kind = "rope_compensation"`.
pub const COMPENSATED_KEYS: &[Key] = &keys(
    Key::kind(
        &["rope_compensation"],
        "A plain boom on a luffing rope, its hoist rope in several parts between head and frame.",
    ),
    COMPENSATED_ROPE,
);

const MOTION: &[Key] = &motion(&s::FROM, &s::TO, &s::OMEGA);

const TACKLE: &[Key] = keys! { s:
    E_X, E_Y, S_K > 0, CHI_K [usually(0.0)], M_L > 0, ETA_L > 0 [usually(1.0)]
};

const HOIST_ROPE: &[Key] = keys! { s: B_X, B_Y, M_H > 0, ETA_H > 0 [usually(1.0)], H_Q >= 0 };

const COMPENSATED_ROPE: &[Key] = keys! { s:
    B_X, B_Y, M_K >= 0, ETA_K > 0 [usually(1.0)], M_H > 0, ETA_H > 0 [usually(1.0)], H_Q >= 0
};

const WEIGHTS: &[Key] = keys! { b: G_B [or_mass], R_B >= 0, CHI_B [usually(0.0)] };

static DYNAMICS: &[Key] = &dynamics::<18>(&[Key::quantity(&s::J_B, Sign::NotNegative)]);

const INERTIAS: &[&Symbol] = listed!(s: J_B);

const LIMITS: &[Key] = &Limit::keys::<22>(OUTLINE.limits);

/// A boom on a luffing rope as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct Rope {
    /// At the start of the working range.
    pub(super) given: Given<f64>,
    /// At a level that moves by itself.
    pub(super) moving: Option<Moving>,
    /// Published results of the balance.
    published_balance: Option<PublishedBalance>,
    cases: Cases,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<Rope>::entry("rope", KEYS);
/// The same with the hoist rope in several parts.
pub const COMPENSATED: Entry = Description::<Rope>::entry("rope_compensation", COMPENSATED_KEYS);

impl Described for Rope {
    type Component = RopeBoom;
    const ID: &'static str = "rope";
    const TABLE: &'static str = "luffing";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = listed!(m: S_R, H_G, N_G, M_A, M_SL, M_WS, M_GAMMA);
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "rope_symbol",
        own: &[s::ALL],
        shared: &[
            b::ALL,
            gravity::ALL,
            moving::symbols::ALL,
            moving::control::luffing::ALL,
            shaping::ALL,
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

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(Rope, Motion)> {
        let moving = moves(v, gravity, found);
        let (range, balance) = begun(v, "G_b and r_b", found)?;
        if let Some(moving) = &moving {
            brisk(v, moving, &range, found);
            outlasts(v, moving, &range, [listed!(s: L, X_8), &[&b::G_B]], found);
        }
        let cases = Cases::read(v, &resisting::PARTS, balance.as_ref(), gravity, found);
        let given = at_rest! { (cases) without [slack];
            phi: One(&b::PHI, range.from),
            omega: One(&s::OMEGA, range.speed),
            load: v.of(&s::Q).map(|q| One(&s::Q, q)),
            rig: Rig::read(v)?,
            compensation: Compensation::read(v),
            weights: v.part("weights", Plain::read)?,
            balance,
            wire: cases.sizes.wire,
            choice: BoomChoice { range },
            inertia: match &moving {
                Some(_) => Some(BoomInertia::read(v.table("dynamics")?)?),
                None => None,
            },
        };
        let published_balance = v.table("balance").and_then(PublishedBalance::read);
        let rope = Rope {
            given,
            moving,
            published_balance,
            cases,
        };
        rope.keeps_clear(v, found).then_some((rope, range))
    }

    fn given(this: &Description<Rope>) -> Given<f64> {
        Given {
            inertia: None,
            ..this.given.clone()
        }
    }

    fn check(this: &mut Description<Rope>, v: &Values, found: &mut Vec<Diagnostic>) {
        possible(this, v, found);
        told::check::<RopeBoom>(&this.standing(), &this.cases, v, found);
    }

    boom_levels!(Rope with inertia);

    fn chapters(&self) -> Vec<&'static str> {
        let moving = self.moving.map(|_| "motion");
        moving
            .into_iter()
            .chain(self.given.balance.map(|_| "balance"))
            .chain(self.cases.are_there().then_some("cases"))
            .collect()
    }

    fn searched(_: &Description<Rope>, model: &Standing) -> Vec<Summary> {
        searched::<RopeBoom>(model)
    }

    /// Virtual work against equilibrium.
    fn identities(this: &Description<Rope>, model: &mut Standing) -> Vec<Check> {
        let mut checks = balance_work::<RopeBoom>(model, &s::AGREEMENT);
        if this.given.load.is_none() {
            return checks;
        }
        let mut symbols = vec![&s::M_Q, &s::M_D];
        symbols.extend(this.given.weights.map(|_| &s::M_G));
        symbols.extend(this.given.balance.map(|_| &b::M_UR));
        checks.push(vanishing(model, ("equilibrium", &s::AGREEMENT), &symbols, |row| {
            let other = |place: usize| row.get(place).copied().unwrap_or(0.0);
            [row[0], other(2), -other(3), -row[1]]
        }));
        checks.extend(checks::identities::<RopeBoom>(model, &this.cases, &s::M_D));
        checks
    }

    fn assumptions(this: &Description<Rope>) -> Vec<&'static str> {
        let foot = (this.given.rig.x_8 == 0.0).then_some("reach_from_foot");
        let Some(moving) = &this.moving else {
            let level = this.table.map_or("rope_level_static", |_| "rope_level_table");
            let forces = this.given.load.map(|_| "rope_forces");
            return [level].into_iter().chain(forces).chain(foot).collect();
        };
        let level = moving.rope.map_or("level_rigid", |_| "level_swing");
        let led = moving.rope.map(|_| "rope_led");
        let balance = this.given.balance.map(|_| "counterweight");
        [level, "rope_masses"]
            .into_iter()
            .chain(balance)
            .chain(moving.taken("rope_load"))
            .chain(led)
            .chain(["rope_winch", "sticking", "stops", "rope_at_rest", "solver_runge_kutta"])
            .chain(foot)
            .collect()
    }

    fn uncovered(this: &Description<Rope>) -> Vec<&'static str> {
        left(levels::uncovered("pin_friction", this.moving.as_ref()), &this.cases)
    }

    /// The boom at the ends of the working range (faint) and where it is told of, with its ropes and the path of the load.
    fn drawing(this: &Description<Rope>, told: f64) -> Drawing {
        let (rig, range) = (&this.given.rig, &this.motion);
        let mut draw = Draw::default();
        let (o1, e, b) = (
            Point::zeros(),
            Point::new(rig.e_x, rig.e_y),
            Point::new(rig.b_x, rig.b_y),
        );
        draw.path(fine(range).map(|phi| BoomPosition::new(rig, &phi).a));
        for (phi, faint) in [(range.from, true), (range.to, true), (told, false)] {
            let p = BoomPosition::new(rig, &phi);
            let [foot, k] = anchor(rig, &p);
            draw.bar(&[o1, p.a], faint);
            draw.bar(&[foot, k, e], faint);
            draw.bar(&[p.a, b], faint);
            draw.pin(p.a, false, faint);
            draw.pin(k, false, faint);
            if faint {
                continue;
            }
            draw.label(p.a, "A");
            draw.label(k, "K");
            draw.angle(o1, 0.2 * rig.l, phi, &b::PHI);
            draw.distance(Point::new(-rig.x_8, 0.0), Point::new(p.a.x, 0.0), -0.1 * rig.l, &s::R);
            draw.distance(o1, p.a, -0.06 * rig.l, &s::L);
            let (sin, cos) = Calc::sin_cos(phi);
            let line = [(&s::L, along(o1, [cos, sin])), (&s::F_A, along(o1, [-sin, cos]))];
            draw.handle(p.a, &line);
            draw.handle(k, &[(&s::S_K, distance(o1)), (&s::CHI_K, direction(o1, phi))]);
            draw.force(o1, [&s::F_O1X, &s::F_O1Y]);
            draw.pull(k, e, &s::T);
            if this.given.load.is_some() {
                draw.load(p.a, &s::Q);
            }
        }
        for (at, text) in [(o1, "O_1"), (e, "E"), (b, "B")] {
            draw.joint(at, text, true, false);
        }
        draw.placed(e, [&s::E_X, &s::E_Y]);
        draw.placed(b, [&s::B_X, &s::B_Y]);
        draw.axis(-rig.x_8, -0.15 * rig.l, 0.6 * rig.l);
        draw.handle(Point::new(-rig.x_8, 0.0), &[(&s::X_8, along(o1, [-1.0, 0.0]))]);
        draw.done(rig.l)
    }

    fn in_motion(this: &Description<Rope>) -> Option<Moved> {
        moved(this)
    }

    fn more(this: &Description<Rope>, model: &mut Standing, sheet: &mut Sheet) {
        sheet.cases = told::chapter(this, model, &this.cases);
        sheet.balance = chapter::<RopeBoom>(model, RopeBoom::SYMBOLS, this.published_balance.as_ref());
    }
}

impl Rope {
    /// Whether boom and head keep away from the sheave of the hoist rope in the working range.
    fn keeps_clear(&self, v: &Values, found: &mut Vec<Diagnostic>) -> bool {
        let Given { rig, choice, .. } = &self.given;
        let b = Point::new(rig.b_x, rig.b_y);
        let sheave = f64::direction(b.x, b.y);
        // The first angle in the range, or after it, at which what leads the boom by so much points at the sheave.
        let met = |ahead: f64| {
            let (turn, angle) = (std::f64::consts::TAU, sheave - ahead);
            angle + ((choice.range.from - angle) / turn).ceil() * turn
        };
        let (from, to) = (choice.range.from, choice.range.to);
        let at = |phi: f64| BoomPosition::new(rig, &phi).a;
        let head = at(0.0);
        let facing = met(f64::direction(head.x, head.y));
        let near = [from, to].into_iter().chain((facing <= to).then_some(facing));
        let gaps = near.map(|phi| (plane::length(at(phi) - b), phi));
        let (gap, phi) = gaps.min_by(|one, other| one.0.total_cmp(&other.0)).expect("two ends");
        let least = NEAREST_SHEAVE * rig.l;
        let what = if met(0.0) <= to && plane::length(b) <= rig.l {
            let phi = degrees(met(0.0));
            format!("the boom meets the sheave B of the hoist rope at phi = {phi}")
        } else if gap < least {
            format!(
                "the head A comes within {} of the sheave B of the hoist rope at phi = {}, {} are needed",
                s::L_S.written(gap),
                degrees(phi),
                s::L_S.written(least)
            )
        } else {
            return true;
        };
        let help = "set B_x and B_y behind the boom, or keep the working range away from it";
        let place = v.table("hoist_rope").map_or(0..0, |table| table.place(s::B_X.id));
        found.push(Diagnostic::new(place, what, "in the boom's way").help(help));
        false
    }
}

/// How near the head may come to the sheave, as a part of the boom: nearer, no sheave has room, and the rope between them turns
/// with every breath of the boom.
const NEAREST_SHEAVE: f64 = 1e-3;

/// What the scene gives of its motion; mistakes go to `found`.
fn moves(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<Moving> {
    let bodies = Inert {
        loaded: v.has("Q"),
        inertias: INERTIAS,
        bar: [&s::L, &s::J_B],
        reach: &s::L,
        help: "add [luffing.dynamics] with J_b (kg.m2)",
        bodies: "boom",
        weighs: |weights| turns(weights, &b::G_B, &b::R_B),
        leads: Some("hoist_rope"),
    };
    let moving = Moving::new(v, gravity, &bodies, found)?;
    let rope = v.table("hoist_rope");
    found.extend(elsewhere(rope, s::H_Q.id, &moving));
    Some(moving)
}

/// Where the luffing tackle holds the boom: the foot of its lug between O1 and A, and K, in m from O1.
fn anchor(rig: &Rig<f64>, p: &BoomPosition<f64>) -> [Point<f64>; 2] {
    let (sin, cos) = Calc::sin_cos(rig.chi_k);
    let k = plane::turned(p.along, rig.s_k * cos, rig.s_k * sin);
    [p.a * (p.a.dot(&k) / p.a.norm_squared()), k]
}
