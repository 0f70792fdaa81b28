//! A crane on a portal as scenes describe it and books tell it.

use crate::component::aside::Aside;
use crate::component::description::{Described, Description, Vocabulary};
use crate::component::draw::along;
use crate::component::mechanism::Entry;
use crate::component::outline::{Limit, Outline};
use crate::component::sheet::{Check, Curve, Drawing, Sheet};
use crate::component::stages::Stages;
use crate::component::standing::Standing;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::Symbol;
use crate::luffing::aboard;
use crate::luffing::kinds::CARRIED;
use crate::luffing::luffed::Luffer;
use crate::luffing::rig::{GivenCrane, LUFFED};
use crate::parts::motion::Motion;
use crate::parts::motor;
use crate::parts::plane::Point;
use crate::supports::plan::{LeftOpen, drawn, each};
use crate::supports::portal::checks::{agreements, places};
use crate::supports::portal::corners::CORNERS;
use crate::supports::portal::load::Base;
use crate::supports::portal::outline::OUTLINE;
use crate::supports::portal::stages::{Given, PortalCrane};
use crate::supports::portal::symbols as s;
use crate::supports::portal::travel::scene::{TRAVEL, TravelScene};
use crate::supports::portal::weights::{Blowing, PortalBody, PortalHopper, SlewingBody, WindArea};
use crate::supports::portal::wheels::{CornerWheels, FRAMES, Hinged, Sideways};

/// Most bodies of each kind, and wind areas.
const MANY: usize = 64;

/// Keys of `[supports]`.
pub const KEYS: &[Key] = keys! { s:
    A > 0, B > 0, R [or_input, optional], Q >= 0 [or_mass, or_input], THETA_1 [optional], K_L >= 0 [usually(0.1)];
    Key::kind(&["portal"], "A crane that slews on a portal with four corners on rails."),
    Key::new("frame", Kind::Choice(&FRAMES), "Whether the portal is rigid, or hinged so that its legs follow the rails."),
    Key::new("corners", Kind::Tables(CORNER, MANY), "The four corners, counter-clockwise: in front on the right rail, in front on the left one, behind on the left one, behind on the right one."),
    Key::new("portal", Kind::Tables(PORTAL, MANY), "Bodies of the portal, with its legs and travel gear.").optional(),
    Key::new("upper", Kind::Tables(UPPER, MANY), "Bodies of the upper works, with boom and counterweight.").optional(),
    Key::part("hopper", HOPPER, "A hopper on the portal, into which the grab empties: one more weight, over whose fill the crane is judged; with a luffing mechanism at the fill that is given."),
    Key::part("wind", WIND, "Wind on the crane."),
    CARRIED, TRAVEL,
    Key::table("motion", MOTION, "Working range of slewing, over which the corner loads are looked through."),
    Key::part("limits", LIMITS, "What results may come to at most, or at least.")
};

static CORNER: &[Key] = keys! { s: N_W > 0, N_DR >= 0 [optional] };
static PORTAL: &[Key] = keys! { s: G_P [or_mass], X_P [usually(0.0)], Y_P [usually(0.0)] };
static UPPER: &[Key] = keys! { s: G_U [or_mass], R_U };
static HOPPER: &[Key] = keys! { s: G_H0 [or_mass], X_H [usually(0.0)], Y_H [usually(0.0)], Q_H >= 0 [or_mass, or_input], Q_HF > 0 [or_mass] };
static AREA: &[Key] = keys! { s: A_W >= 0, H_W >= 0 };
static WIND: &[Key] = keys! { s: P_W >= 0, CHI_W;
    Key::new("areas", Kind::Tables(AREA, MANY), "Areas on which it acts, with their heights.")
};
const MOTION: &[Key] = &Motion::keys([&s::FROM, &s::TO], &s::PSI, (&s::OMEGA, "Angular velocity of slewing."));
const LIMITS: &[Key] = &Limit::keys::<9>(OUTLINE.limits);

/// A crane on a portal as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct PortalScene {
    given: Given<f64>,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<PortalScene>::entry("portal", KEYS);

/// The wheels of the four corners; mistakes go to `found`.
fn corners(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Vec<CornerWheels<f64>>> {
    let corners = each(v, "corners", CornerWheels::read)?;
    if corners.len() != CORNERS.len() {
        let what = format!("a portal with {} corners", corners.len());
        let help = "give four [[supports.corners]], counter-clockwise: in front on the right rail, in front on the left one, \
                    behind on the left one, behind on the right one";
        found.push(v.refuse("corners", what, "not four", help));
    }
    found.extend(v.tables("corners").iter().filter_map(|corner| corner.broken(&s::N_W)));
    Some(corners)
}

/// The hopper, if there is one; mistakes go to `found`.
fn hopper(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Option<PortalHopper<f64>>> {
    let read = v.part("hopper", PortalHopper::read)?;
    if let Some((hopper, table)) = read.zip(v.table("hopper")).filter(|(hopper, _)| hopper.q > hopper.full) {
        let [now, full] = [s::Q_H.written(hopper.q), s::Q_HF.written(hopper.full)];
        let what = format!("Q_h = {now} lies in a hopper that is full with Q_hf = {full}");
        found.push(table.refuse(
            s::Q_H.id,
            what,
            "more than it holds",
            "give Q_h up to Q_hf, or a greater Q_hf",
        ));
    }
    Some(read)
}

/// What the scene leaves open.
fn open(v: &Values) -> LeftOpen {
    let mut open = LeftOpen::read(v, &[&s::R, &s::Q]);
    open.0.extend(
        v.table("hopper")
            .into_iter()
            .flat_map(|hopper| LeftOpen::read(hopper, &[&s::Q_H]).0),
    );
    open
}

/// The greatest of all over the reach, at a slewing angle (rad).
fn over_reach(given: &Given<f64>, at: f64) -> Option<Curve> {
    let mut known = PortalCrane::new(given.clone());
    known.psi().1 = at;
    let of = |theta: f64| {
        known.held().as_mut()?.1 = theta;
        Some([known.luffed().ok()?.reach, *known.top().ok()?])
    };
    Some(given.luffer.as_ref()?.over_reach("portal_reach", &s::N_TOP, of))
}

impl Described for PortalScene {
    type Component = PortalCrane;
    const ID: &'static str = "portal";
    const TABLE: &'static str = "supports";
    const OUTLINE: &'static Outline = &OUTLINE;
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "portal_symbol",
        own: &[s::ALL],
        shared: &[aboard::ALL, motor::ALL, gravity::ALL],
    };

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(PortalScene, Motion)> {
        let one = |symbol: &'static Symbol| v.of(symbol).map(|value| One(symbol, value));
        let range = Motion::read(v.table("motion")?, found)?;
        let wind = v.table("wind");
        let travel = TravelScene::read(v, gravity, found)?;
        let rig = GivenCrane::read(v, ("supports", &[s::THETA_1.id]), gravity, false, found)?;
        let given = Given {
            psi: One(&s::PSI, range.from),
            omega: One(&s::OMEGA, range.speed),
            reach: rig.reach,
            load: one(&s::Q)?,
            base: Base::read(v)?,
            corners: corners(v, found)?,
            portal: each(v, "portal", PortalBody::read)?,
            upper: each(v, "upper", SlewingBody::read)?,
            wind: v.part("wind", Blowing::read)?,
            areas: wind.map_or(Some(Vec::new()), |wind| each(wind, "areas", WindArea::read))?,
            hopper: hopper(v, found)?,
            sideways: Sideways::read(v)?,
            gravity: travel.gravity,
            wheels: travel.wheels,
            travel: travel.travel,
            motors: travel.motors,
            driven: travel.driven,
            storm: travel.storm,
            held: rig.held,
            luffer: rig.luffer,
            kind: Hinged(v.text("frame") == Some(FRAMES[1])),
            open: open(v),
        };
        Some((PortalScene { given }, range))
    }

    fn given(this: &Description<PortalScene>) -> Given<f64> {
        this.given.clone()
    }

    fn levels(&self) -> Vec<&'static str> {
        vec!["static"]
    }

    fn aside(this: &Description<PortalScene>) -> Option<Aside> {
        let luffing = this.given.luffer.as_ref().map(Luffer::aside);
        luffing.or(this.given.hopper.map(|hopper| Aside {
            symbol: &s::Q_H,
            range: [0.0, hopper.full],
        }))
    }

    fn identities(this: &Description<PortalScene>, model: &mut Standing) -> Vec<Check> {
        let base = &this.given.base;
        agreements(model, [base.a, base.b], &this.motion)
    }

    fn assumptions(this: &Description<PortalScene>) -> Vec<&'static str> {
        let kind = if this.given.kind.0 {
            "portal_hinged"
        } else {
            "portal_rigid"
        };
        let travel = this.given.travel.map(|_| "portal_travel");
        let storm = this.given.storm.map(|_| "portal_storm");
        let level = this.given.luffer.as_ref().map_or("portal_level_static", |_| LUFFED);
        let own = [level, kind, "portal_ground"];
        own.into_iter().chain(travel).chain(storm).collect()
    }

    fn uncovered(this: &Description<PortalScene>) -> Vec<&'static str> {
        let wind = this.given.wind.is_none().then_some("wind");
        let travel = match (this.given.travel, this.given.storm) {
            (None, _) => "portal_travel",
            (_, None) => "portal_storm",
            _ => "portal_rest",
        };
        wind.into_iter()
            .chain([travel, "dynamic_coefficients", "strength", "load_cases"])
            .collect()
    }

    fn more(this: &Description<PortalScene>, _: &mut Standing, sheet: &mut Sheet) {
        let governing = sheet.positions.first().map(|position| position.value);
        sheet
            .curves
            .extend(governing.and_then(|at| over_reach(&this.given, at)));
    }

    /// The boom lies across no dimension.
    fn drawn_at(this: &Description<PortalScene>) -> f64 {
        this.motion.at(0.125)
    }

    /// From above: the portal on its corners, and the boom with its load.
    fn drawing(this: &Description<PortalScene>, at: f64) -> Drawing {
        let base = &this.given.base;
        let places: [Point<f64>; 4] = places([base.a, base.b]);
        let (mut draw, size, head) = drawn(&places, &[0, 1, 2, 3], at, &s::PSI);
        draw.joint(head, s::Q.print, false, false);
        draw.distance(places[3], places[0], -0.3 * size, &s::A);
        draw.distance(places[2], places[3], -0.3 * size, &s::B);
        let sides = [
            (&s::A, along(Point::zeros(), [2.0, 0.0])),
            (&s::B, along(Point::zeros(), [0.0, 2.0])),
        ];
        draw.handle(places[1], &sides);
        draw.done(size)
    }
}
