//! The boom on guide and link as scenes describe it and books tell it.

use std::f64::consts::PI;

use crate::balance::scene::{BALANCE, PublishedBalance};
use crate::balance::symbols as b;
use crate::component::description::{Described, Description, Vocabulary, possible};
use crate::component::draw::{Draw, along, distance, polar};
use crate::component::mechanism::Entry;
use crate::component::moved::Moved;
use crate::component::outline::{Limit, Outline};
use crate::component::sheet::{Check, Drawing, Sheet, Summary};
use crate::component::standing::Standing;
use crate::component::telling::fine;
use crate::drive;
use crate::drive::scene::{DRIVE, Driving};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, SOURCE, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::at_rest::at_rest;
use crate::luffing::boom_scene::{INTERPOLATION, OILED_FIDELITY, balance_work, begun, motion, vanishing};
use crate::luffing::counterweight::chapter;
use crate::luffing::ellipsograph::driving;
use crate::luffing::ellipsograph::moving::GuidedInertias;
use crate::luffing::ellipsograph::outline::OUTLINE;
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice, GuidedPosition, axes};
use crate::luffing::ellipsograph::resisting;
use crate::luffing::ellipsograph::stages::{EllipsographBoom, Given};
use crate::luffing::ellipsograph::statics::GuidedWeights;
use crate::luffing::ellipsograph::symbols as s;
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
use crate::parts::motion::{Motion, degrees};
use crate::parts::plane::Point;
use crate::parts::shaping;
use crate::parts::teeth;
use crate::parts::{air, ground, hanging, hydraulics, side_wind, slope, turntable, turntable_control};
use crate::parts::{motor, starts};

/// Keys of `[luffing]` with `kind = "ellipsograph"`.
pub const KEYS: &[Key] = &[
    Key::kind(
        &["ellipsograph"],
        "A single boom whose foot slides on a vertical guide, carried by a link.",
    ),
    Key::quantity(&s::C, Sign::Positive),
    Key::quantity(&s::A, Sign::Positive),
    Key::quantity(&s::X_8, Sign::Any),
    Key::weight(&s::Q).optional(),
    OILED_FIDELITY,
    Key::table("motion", MOTION, "Working range of the boom."),
    Key::part("weights", WEIGHTS, "Own weights of boom and link, and where they act."),
    DRIVE,
    BALANCE,
    Key::part(
        "dynamics",
        DYNAMICS,
        "Inertias, friction, drive and rope of a boom in motion.",
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

const WEIGHTS: &[Key] = keys! { s:
    G_B [or_mass], R_B >= 0, CHI_B [usually(0.0)], G_L [or_mass, usually(0.0)], R_L [usually(0.0)]
};

static DYNAMICS: &[Key] = &dynamics::<19>(&[
    Key::quantity(&s::J_B, Sign::NotNegative),
    Key::quantity(&s::J_L, Sign::NotNegative),
]);

const INERTIAS: &[&Symbol] = listed!(s: J_B, J_L);

const LIMITS: &[Key] = &Limit::keys::<27>(OUTLINE.limits);

/// A boom on guide and link as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct Ellipsograph {
    /// At the start of the working range.
    pub(super) given: Given<f64>,
    pub(super) driving: Driving,
    /// At a level that moves by itself.
    pub(super) moving: Option<Moving>,
    /// Published results of the balance.
    published_balance: Option<PublishedBalance>,
    cases: Cases,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<Ellipsograph>::entry("ellipsograph", KEYS);

impl Described for Ellipsograph {
    type Component = EllipsographBoom;
    const ID: &'static str = "ellipsograph";
    const TABLE: &'static str = "luffing";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = FOLLOWED;
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "ellipsograph_symbol",
        own: &[s::ALL],
        shared: &[
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

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(Ellipsograph, Motion)> {
        let moving = moves(v, gravity, found);
        let begun = begun(v, "G_b and r_b", found);
        let ((range, balance), driving) = begun.zip(drive::scene::read(v, found))?;
        drive::scene::meets(v, &driving, None, [-range.to, -range.from], found);
        let moves = moving.as_ref().map(|_| &drive::scene::TURNED[..]);
        drive::scene::fits(v, driving.gear.as_ref(), (moves, v.has("Q")), found);
        if let Some(moving) = &moving {
            brisk(v, moving, &range, found);
            outlasts(v, moving, &range, [listed!(s: C, A, X_8), listed!(s: G_B, G_L)], found);
        }
        let cases = Cases::read(v, &resisting::PARTS, balance.as_ref(), gravity, found);
        let given = at_rest! { (cases, driving) without [hoist_falls, oil, oil_parts];
            phi: One(&b::PHI, range.from),
            omega: One(&s::OMEGA, range.speed),
            load: v.of(&s::Q).map(|q| One(&s::Q, q)),
            bars: Bars::read(v)?,
            weights: v.part("weights", GuidedWeights::read)?,
            balance,
            choice: GuidedChoice {
                range,
                crank: driving.branch(),
            },
            inertias: match &moving {
                Some(_) => Some(GuidedInertias::read(v.table("dynamics")?)?),
                None => None,
            },
        };
        let published_balance = v.table("balance").and_then(PublishedBalance::read);
        let read = Ellipsograph {
            given,
            driving,
            moving,
            published_balance,
            cases,
        };
        keeps_its_foot(&range, v, found).then_some((read, range))
    }

    fn given(this: &Description<Ellipsograph>) -> Given<f64> {
        Given {
            inertias: None,
            ..this.given.clone()
        }
    }

    fn check(this: &mut Description<Ellipsograph>, v: &Values, found: &mut Vec<Diagnostic>) {
        possible(this, v, found);
        told::check::<EllipsographBoom>(&this.standing(), &this.cases, v, found);
        if this.moving.is_some() {
            drive::hauling::check(&mut this.standing(), v, found);
        }
    }

    boom_levels!(Ellipsograph with inertias);

    fn chapters(&self) -> Vec<&'static str> {
        let moving = self.moving.map(|_| "motion");
        moving
            .into_iter()
            .chain(self.given.balance.map(|_| "balance"))
            .chain(self.cases.are_there().then_some("cases"))
            .collect()
    }

    fn searched(_: &Description<Ellipsograph>, model: &Standing) -> Vec<Summary> {
        searched::<EllipsographBoom>(model)
    }

    /// Virtual work against equilibrium and the instantaneous centre.
    fn identities(this: &Description<Ellipsograph>, model: &mut Standing) -> Vec<Check> {
        let given = &this.given;
        let mut checks = balance_work::<EllipsographBoom>(model, &s::AGREEMENT);
        let Some(One(_, q)) = given.load else {
            return checks;
        };
        let by_pole = [&s::M_Q, &s::A_X, &s::P_X];
        checks.push(vanishing(
            model,
            ("ellipsograph_pole", &s::AGREEMENT),
            &by_pole,
            |row| [row[0], q * row[2], -q * row[1]],
        ));
        checks.push(power(given, model));
        let mut symbols = vec![&s::M_D, &s::C_X, &s::C_Y, &s::F_CX, &s::F_CY];
        symbols.extend(given.balance.map(|_| &b::M_UR));
        let link = given.weights.map_or(0.0, |w| w.g_l * w.r_l) / given.bars.c;
        // About O1, of drive, boom, own weight and balance on the link.
        checks.push(vanishing(model, ("equilibrium", &s::AGREEMENT), &symbols, |row| {
            let balance = row.get(5).copied().unwrap_or(0.0);
            [row[0], row[1] * row[4], -row[2] * row[3], link * row[1], -balance]
        }));
        checks.extend(drive::checks::by_slider(&this.driving, model, &s::AGREEMENT));
        checks.extend(checks::identities::<EllipsographBoom>(model, &this.cases, &s::M_D));
        checks
    }

    fn assumptions(this: &Description<Ellipsograph>) -> Vec<&'static str> {
        let forces = |id| this.given.load.map(|_| id);
        let Some(moving) = &this.moving else {
            let level = this
                .table
                .map_or("ellipsograph_level_static", |_| "ellipsograph_level_table");
            let rest = forces("ellipsograph_forces");
            return [level, "ellipsograph_rope"].into_iter().chain(rest).collect();
        };
        let balance = this.given.balance.map(|_| "counterweight");
        let load = moving.taken("ellipsograph_load");
        [levels::assumed(moving), "ellipsograph_masses"]
            .into_iter()
            .chain(balance)
            .chain(load)
            .chain(["ellipsograph_rope"])
            .chain(levels::solved(moving))
            .collect()
    }

    fn uncovered(this: &Description<Ellipsograph>) -> Vec<&'static str> {
        left(
            levels::uncovered("ellipsograph_friction", this.moving.as_ref()),
            &this.cases,
        )
    }

    /// The boom at the ends (faint) and in the middle of the working range, with guide, link and the path of the head.
    fn drawing(this: &Description<Ellipsograph>, told: f64) -> Drawing {
        let (bars, range) = (&this.given.bars, &this.motion);
        let (axes, o1) = (axes(bars), Point::zeros());
        let size = axes.x;
        let mut draw = Draw::default();
        draw.path(fine(range).map(|phi| GuidedPosition::new(bars, &axes, &phi).a));
        let feet = || fine(range).map(|phi| GuidedPosition::new(bars, &axes, &phi).b_y);
        let low = feet().fold(f64::INFINITY, f64::min) - 0.06 * size;
        let high = feet().fold(f64::NEG_INFINITY, f64::max) + 0.06 * size;
        for side in [-0.02 * size, 0.02 * size] {
            draw.bar(&[Point::new(side, low), Point::new(side, high)], true);
        }
        for (phi, faint) in [(range.from, true), (range.to, true), (told, false)] {
            let p = GuidedPosition::new(bars, &axes, &phi);
            let b = Point::new(0.0, p.b_y);
            draw.bar(&[o1, p.c], faint);
            draw.bar(&[b, p.a], faint);
            for (at, text) in [(p.a, "A"), (p.c, "C"), (b, "B")] {
                draw.joint(at, text, false, faint);
            }
            if faint {
                continue;
            }
            drive::drawing::drive(&mut draw, &driving::bar(&p, bars), &this.driving, range);
            draw.angle(b, 0.2 * size, phi, &b::PHI);
            draw.distance(o1, p.c, -0.05 * size, &s::C);
            draw.distance(p.c, p.a, -0.05 * size, &s::A);
            draw.handle(p.c, &[(&s::C, distance(o1))]);
            draw.handle(p.a, &[(&s::A, distance(p.c))]);
            draw.force(o1, [&s::F_O1X, &s::F_O1Y]);
            draw.force(p.c, [&s::F_CX, &s::F_CY]);
            draw.pull(b, b + Point::new(1.0, 0.0), &s::F_BX);
            draw.centre([[b + Point::new(1.0, 0.0), b], [o1, p.c]], size);
            draw.distance(
                Point::new(-bars.x_8, p.b_y),
                Point::new(p.a.x, p.b_y),
                -0.1 * size,
                &s::R,
            );
            if this.given.load.is_some() {
                draw.load(p.a, &s::Q);
            }
        }
        draw.joint(o1, "O_1", true, false);
        draw.handle(Point::new(-bars.x_8, 0.0), &[(&s::X_8, along(o1, [-1.0, 0.0]))]);
        draw.axis(-bars.x_8, low, 0.15 * size);
        draw.done(size)
    }

    fn in_motion(this: &Description<Ellipsograph>) -> Option<Moved> {
        moved(this)
    }

    fn more(this: &Description<Ellipsograph>, model: &mut Standing, sheet: &mut Sheet) {
        sheet.cases = told::chapter(this, model, &this.cases);
        sheet.balance = chapter::<EllipsographBoom>(model, EllipsographBoom::SYMBOLS, this.published_balance.as_ref());
    }
}

/// Virtual work of load and weights against the power of each link about its instantaneous centre: the boom's is where the
/// link's line meets the foot's level, the link's is O1, about which it turns the other way. [Ports001, 5.9]
fn power(given: &Given<f64>, model: &mut Standing) -> Check {
    let (c, q) = (given.bars.c, given.load.map_or(0.0, |load| load.1));
    let mut symbols = vec![&b::PHI, &s::A_X, &s::M_Q];
    symbols.extend(given.weights.map(|_| &s::M_G));
    vanishing(model, ("power", &s::AGREEMENT), &symbols, |row| {
        let joint = polar(c, -row[0]);
        let centre = 2.0 * joint.x;
        let (mut of_boom, mut of_centre, mut of_link) = (q * row[1], q * centre, 0.0);
        if let Some(w) = &given.weights {
            of_boom += w.g_b * polar(w.r_b, row[0] + w.chi_b).x;
            of_centre += w.g_b * centre;
            of_link = -(w.g_l * w.r_l * joint.x / c);
        }
        let work = row[2] + row.get(3).copied().unwrap_or(0.0);
        [work, -of_boom, of_centre, -of_link]
    })
}

/// What the scene gives of its motion; mistakes go to `found`.
fn moves(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<Moving> {
    let bodies = Inert {
        loaded: v.has("Q"),
        inertias: INERTIAS,
        bar: [&s::C, &s::J_B],
        reach: &s::C,
        help: "add [luffing.dynamics] with J_b and J_l (kg.m2)",
        bodies: "boom and link",
        weighs: |weights| {
            let boom = weights.number(s::G_B.id).is_some_and(|weight| weight > 0.0);
            boom || turns(weights, &s::G_L, &s::R_L)
        },
        leads: None,
    };
    Moving::new(v, gravity, &bodies, found)
}

/// Whether the working range passes no position in which the boom lies level: the foot would meet O1, and might stay.
fn keeps_its_foot(range: &Motion, v: &Values, found: &mut Vec<Diagnostic>) -> bool {
    let level = (range.from / PI).ceil() * PI;
    if level > range.to {
        return true;
    }
    let what = format!(
        "the boom lies level at phi = {}: its foot meets O1, where it could stay while the boom turns",
        degrees(level)
    );
    let help = "keep the working range within 0 deg and 180 deg, both left out";
    if let Some(motion) = v.table("motion") {
        found.push(motion.refuse("from", what, "a change point in the working range", help));
    }
    false
}
