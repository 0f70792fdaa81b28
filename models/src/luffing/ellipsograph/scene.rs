//! The boom on guide and link as scenes describe it and books tell it.

use std::f64::consts::PI;

use crate::balance::scene::{BALANCE, PublishedBalance};
use crate::balance::symbols as b;
use crate::component::description::{Described, Description, Vocabulary};
use crate::component::draw::Draw;
use crate::component::mechanism::Entry;
use crate::component::outline::{Limit, Outline};
use crate::component::sheet::{Check, Drawing, Sheet, Summary};
use crate::component::standing::Standing;
use crate::component::telling::fine;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, SOURCE, Sign, Values};
use crate::luffing::boom_scene::{FIDELITY, INTERPOLATION, balance_work, begun, motion, uncovered, vanishing};
use crate::luffing::counterweight::chapter;
use crate::luffing::ellipsograph::outline::OUTLINE;
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice, GuidedPosition, axes};
use crate::luffing::ellipsograph::stages::{EllipsographBoom, Given};
use crate::luffing::ellipsograph::statics::GuidedWeights;
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::with_balance::searched;
use crate::parts::motion::{Motion, degrees};
use crate::parts::plane::Point;

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
    FIDELITY,
    Key::table("motion", MOTION, "Working range of the boom."),
    Key::part("weights", WEIGHTS, "Own weights of boom and link, and where they act."),
    BALANCE,
    INTERPOLATION,
    Key::part("limits", LIMITS, "Limits that the book checks."),
    SOURCE,
];

const MOTION: &[Key] = &motion(&s::FROM, &s::TO, &s::OMEGA);

const WEIGHTS: &[Key] = keys! { s:
    G_B [or_mass], R_B >= 0, CHI_B [usually(0.0)], G_L [or_mass, usually(0.0)], R_L [usually(0.0)]
};

const LIMITS: &[Key] = &Limit::keys::<8>(OUTLINE.limits);

/// A boom on guide and link as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct Ellipsograph {
    /// At the start of the working range.
    given: Given<f64>,
    /// Published results of the balance.
    published_balance: Option<PublishedBalance>,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<Ellipsograph>::entry("ellipsograph", KEYS);

impl Described for Ellipsograph {
    type Component = EllipsographBoom;
    const ID: &'static str = "ellipsograph";
    const TABLE: &'static str = "luffing";
    const OUTLINE: &'static Outline = &OUTLINE;
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "ellipsograph_symbol",
        own: &[s::ALL],
        shared: &[b::ALL, gravity::ALL],
    };

    fn read(v: &Values, _: f64, found: &mut Vec<Diagnostic>) -> Option<(Ellipsograph, Motion)> {
        let (range, balance) = begun(v, "G_b and r_b", found)?;
        let given = Given {
            phi: One(&b::PHI, range.from),
            omega: One(&s::OMEGA, range.speed),
            load: v.of(&s::Q).map(|q| One(&s::Q, q)),
            bars: Bars::read(v)?,
            weights: v.part("weights", GuidedWeights::read)?,
            balance,
            choice: GuidedChoice { range },
        };
        let published_balance = v.table("balance").and_then(PublishedBalance::read);
        let read = Ellipsograph {
            given,
            published_balance,
        };
        keeps_its_foot(&range, v, found).then_some((read, range))
    }

    fn given(this: &Description<Ellipsograph>) -> Given<f64> {
        this.given.clone()
    }

    fn chapters(&self) -> Vec<&'static str> {
        self.given.balance.iter().map(|_| "balance").collect()
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
        let mut symbols = vec![&s::M_D, &s::C_X, &s::C_Y, &s::F_CX, &s::F_CY];
        symbols.extend(given.balance.map(|_| &b::M_UR));
        let link = given.weights.map_or(0.0, |w| w.g_l * w.r_l) / given.bars.c;
        // About O1, of drive, boom, own weight and balance on the link.
        checks.push(vanishing(model, ("equilibrium", &s::AGREEMENT), &symbols, |row| {
            let balance = row.get(5).copied().unwrap_or(0.0);
            [row[0], row[1] * row[4], -row[2] * row[3], link * row[1], -balance]
        }));
        checks
    }

    fn assumptions(this: &Description<Ellipsograph>) -> Vec<&'static str> {
        let level = this
            .table
            .map_or("ellipsograph_level_static", |_| "ellipsograph_level_table");
        let forces = this.given.load.map(|_| "ellipsograph_forces");
        [level, "ellipsograph_rope"].into_iter().chain(forces).collect()
    }

    fn uncovered(_: &Description<Ellipsograph>) -> Vec<&'static str> {
        uncovered("ellipsograph_friction")
    }

    /// The boom at the ends (faint) and in the middle of the working range, with guide, link and the path of the head.
    fn drawing(this: &Description<Ellipsograph>) -> Drawing {
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
        let middle = f64::midpoint(range.from, range.to);
        for (phi, faint) in [(range.from, true), (range.to, true), (middle, false)] {
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
            draw.angle(b, 0.2 * size, phi, &b::PHI);
            draw.distance(o1, p.c, -0.05 * size, &s::C);
            draw.distance(p.c, p.a, -0.05 * size, &s::A);
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
        draw.axis(-bars.x_8, low, 0.15 * size);
        draw.done(size)
    }

    fn more(this: &Description<Ellipsograph>, model: &mut Standing, sheet: &mut Sheet) {
        sheet.balance = chapter::<EllipsographBoom>(model, this.published_balance.as_ref());
    }
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
