//! A slewing ring as scenes describe it and books tell it.

use crate::component::aside::Aside;
use crate::component::description::{Described, Description, Vocabulary};
use crate::component::draw::{Draw, along, polar};
use crate::component::mechanism::{Entry, Solver};
use crate::component::moving::MovingComponent;
use crate::component::outline::{Limit, Outline};
use crate::component::places::stand;
use crate::component::sheet::{Check, Curve, Drawing, Sheet};
use crate::component::stages::Stages;
use crate::component::standing::Standing;
use crate::component::telling::numbered;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::luffing::kinds::CARRIED;
use crate::luffing::luffed::Luffer;
use crate::parts::load_curve::{LoadCurve, corner};
use crate::parts::motion::Motion;
use crate::parts::plane::Point;
use crate::parts::polyline::rising;
use crate::slewing::beside::beside;
use crate::slewing::scene::SOLVED;
use crate::supports::drive;
use crate::supports::drive::able::able;
use crate::supports::drive::checks::{StandingThere, about_the_axis, through_the_gear};
use crate::supports::drive::moving::{self, SLEWING, moved};
use crate::supports::drive::scene::{DRIVE, TurningScene};
use crate::supports::drive::told::told;
use crate::supports::plan::{LeftOpen, each};
use crate::supports::ring::bolts::RingBolts;
use crate::supports::ring::capacity::Equivalent;
use crate::supports::ring::checks::{agreements, bolt_pulls};
use crate::supports::ring::contact::RollingContact;
use crate::supports::ring::elements::Raceway;
use crate::supports::ring::friction::{ElementFriction, FORMS, MakerForm, MakerFriction};
use crate::supports::ring::law::{LAWS, ROWS, RollingElements};
use crate::supports::ring::life::DynamicCapacity;
use crate::supports::ring::outline::OUTLINE;
use crate::supports::ring::stages::{Given, SlewingRing};
use crate::supports::ring::symbols as s;
use crate::supports::upper;
use crate::supports::upper::keys::{self, AREAS, LOAD_CASES, MOTION, SLOPE, UPPER};
use crate::supports::upper::load::SupportCase;
use crate::supports::upper::weights::{UpperArea, UpperSlope, UpperWeight};

/// Most points of the load curve.
const MANY: usize = 64;

/// Keys of `[supports]`.
pub const KEYS: &[Key] = keys! { s:
    D > 0, Z > 0, ALPHA > 0, R [or_input, optional], Q >= 0 [or_mass, or_input], THETA_1 [optional], H_1 [optional];
    Key::kind(&["ring"], "A crane that slews on a ring of balls or rollers."),
    Key::new("law", Kind::Choice(&LAWS), "How a rolling element yields: \"linear\" as a spring, \"line\" with the power 10/9 of its approach as rollers, \"point\" with the power 3/2 as balls."),
    Key::new("rows", Kind::Choice(&ROWS), "Whether rolling elements bear pressure alone, or a hold-down row bears by the same law where the ring would be lifted."),
    UPPER, LOAD_CASES, AREAS, SLOPE, CARRIED,
    Key::part("contact", CONTACT, "Contact of rolling elements and raceway, and its hardness."),
    Key::part("capacity", CAPACITY, "The maker's load curve of the ring, and the equivalent loads that it asks for."),
    Key::part("friction", FRICTION, "Friction by the forces on all rolling elements, with the textbook's coefficient."),
    Key::part("maker_friction", MAKER, "Friction by a maker's form, with that maker's coefficient."),
    Key::part("bolts", BOLTS, "Bolts of the ring, on one circle, with their preload."),
    Key::part("life", LIFE, "Life of the raceway, of balls (law = \"point\") or rollers (law = \"line\")."),
    DRIVE, MOTION, SLEWING, SOLVED,
    Key::part("limits", LIMITS, "What results may come to at most, or at least.")
};

static CONTACT: &[Key] = keys! { s: E > 0 [usually(206e9)], NU >= 0 [usually(0.3)], RHO > 0, B_R > 0 [optional], HB > 0,
K_HB > 0 [usually(2.7e6)] };
static POINT: &[Key] = keys! { s: F_CURVE >= 0, M_CURVE >= 0 };
static CAPACITY: &[Key] = keys! { s: K_V > 0 [usually(1.0)], K_R >= 0 [usually(5.046)], K_M > 0 [usually(1.0)],
    F_ST > 0 [usually(1.25)];
    Key::new("curve", Kind::Tables(POINT, MANY), "Points of the load curve: the first without force, then with rising force.")
};
static FRICTION: &[Key] = keys! { s: MU_N >= 0 };
static BOLTS: &[Key] =
    keys! { s: N_B > 0, D_B > 0, F_P > 0, F_Y > 0, PHI_B >= 0 [usually(0.2)], MU_B >= 0 [usually(0.15)] };
static LIFE: &[Key] = keys! { s: C_D > 0, K_H >= 0 [usually(0.75)] };
static MAKER: &[Key] = keys! { s: MU_M >= 0;
    Key::new("form", Kind::Choice(&FORMS), "The maker's form: Rothe Erde's of ball or of roller rings, or another maker's of ball rings, in which the horizontal force counts 2.2 times.")
};
const LIMITS: &[Key] = &Limit::keys::<21>(OUTLINE.limits);

/// A slewing ring as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct RingScene {
    given: Given<f64>,
    turning: TurningScene,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<RingScene>::entry("ring", KEYS);

/// The rolling elements; mistakes go to `found`.
fn rolling(v: &Values, found: &mut Vec<Diagnostic>) -> Option<RollingElements> {
    let count = v.of(&s::Z)?;
    if let Some(refused) = v.broken(&s::Z) {
        found.push(refused);
        return None;
    }
    let law = LAWS.iter().position(|law| v.text("law") == Some(law))?;
    Some(RollingElements::new(
        count as usize,
        law,
        v.text("rows") == Some(ROWS[1]),
    ))
}

/// Refuses part of a bolt, and the life of what is neither ball nor roller.
fn bolted(v: &Values, found: &mut Vec<Diagnostic>) {
    found.extend(v.table("bolts").and_then(|bolts| bolts.broken(&s::N_B)));
    if let Some(life) = v.table("life").filter(|_| v.text("law") == Some(LAWS[0])) {
        let what = "life of rolling elements that yield linearly";
        let help = "give law = \"point\" for balls or law = \"line\" for rollers: their lives go with other powers";
        found.push(life.refuse(s::C_D.id, what, "neither balls nor rollers", help));
    }
}

/// The points of the load curve; mistakes go to `found`.
fn curve(capacity: &Values, found: &mut Vec<Diagnostic>) -> Option<LoadCurve> {
    let tables = capacity.tables("curve");
    let told = tables.first().and_then(|first| {
        let [force, moment] = [first.of(&s::F_CURVE)?, first.of(&s::M_CURVE)?];
        (force != 0.0)
            .then(|| {
                let what = format!("the load curve begins at F_curve = {}", s::F_CURVE.written(force));
                let help = "begin with the moment that the ring bears without force: F_curve = \"0 kN\"";
                first.refuse(s::F_CURVE.id, what, "not on a load curve", help)
            })
            .or((moment == 0.0).then(|| {
                let what = format!("the load curve begins at M_curve = {}", s::M_CURVE.written(moment));
                let help = "give the moment that the ring bears without force: above zero";
                first.refuse(s::M_CURVE.id, what, "not on a load curve", help)
            }))
    });
    found.extend(told);
    rising(tables, [&s::F_CURVE, &s::M_CURVE], ["a load curve", "force"], found).map(LoadCurve)
}

/// What resists slewing, another way.
fn turned(this: &RingScene, model: &mut Standing) -> Option<Check> {
    let given = &this.given;
    let there = StandingThere {
        bodies: &given.bodies,
        areas: &given.areas,
        slope: given.slope,
        cases: &given.cases,
        load: *given.load,
        reach: given.reach.map(|reach| *reach),
    };
    about_the_axis(model, &this.turning, &there)
}

/// The greatest of all over the reach, at a slewing angle (rad).
fn over_reach(given: &Given<f64>, at: f64) -> Option<Curve> {
    let mut known = SlewingRing::new(given.clone());
    known.psi().1 = at;
    let of = |theta: f64| {
        known.held().as_mut()?.1 = theta;
        Some([known.luffed().ok()?.reach, known.worst().ok()?.moment])
    };
    Some(given.luffer.as_ref()?.over_reach("upper_reach", &s::M_ALL, of))
}

impl Described for RingScene {
    type Component = SlewingRing;
    const ID: &'static str = "slewing_ring";
    const TABLE: &'static str = "supports";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = moving::FOLLOWED;
    const TOGETHER: &'static [[&'static Symbol; 2]] = moving::TOGETHER;
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "upper_symbol",
        own: &[s::ALL, upper::symbols::ALL, drive::symbols::ALL],
        shared: &drive::SHARED,
    };

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(RingScene, Motion)> {
        let one = |symbol: &'static Symbol| v.of(symbol).map(|value| One(symbol, value));
        let range = Motion::read(v.table("motion")?, found)?;
        let form = v.table("maker_friction").and_then(|table| table.text("form"));
        let turning = TurningScene::read(v, &["friction", "maker_friction"], gravity, found)?;
        bolted(v, found);
        let rig = keys::rig(v, gravity, found)?;
        let given = Given {
            psi: One(&s::PSI, range.from),
            omega: One(&s::OMEGA, range.speed),
            reach: rig.reach,
            load: one(&s::Q)?,
            raceway: Raceway::read(v)?,
            bodies: each(v, "upper", UpperWeight::read)?,
            areas: each(v, "areas", UpperArea::read)?,
            slope: v.part("slope", UpperSlope::read)?,
            hook: keys::hook(v),
            cases: each(v, "load_cases", SupportCase::read)?,
            foot: one(&s::H_1),
            held: rig.held,
            luffer: rig.luffer,
            contact: v.part("contact", RollingContact::read)?,
            length: v
                .table("contact")
                .and_then(|table| table.of(&s::B_R))
                .map(|length| One(&s::B_R, length)),
            equivalent: v.part("capacity", Equivalent::read)?,
            bolts: v.part("bolts", RingBolts::read)?,
            dynamic: v.part("life", DynamicCapacity::read)?,
            friction: v.part("friction", ElementFriction::read)?,
            maker: v.part("maker_friction", MakerFriction::read)?,
            rolling: rolling(v, found)?,
            curve: v.part("capacity", |table| curve(table, found))?.unwrap_or_default(),
            form: MakerForm(FORMS.iter().position(|known| form == Some(known)).unwrap_or(0)),
            gravity: turning.gravity,
            drive: turning.drive,
            rope: turning.rope,
            starting: turning.start.clone(),
            works: turning.works.clone(),
            places: turning.places.clone(),
            holds: turning.holds.clone(),
            brake: turning.brake,
            limit: turning.limit,
            pinion: turning.pinion,
            stages: turning.stages.clone(),
            mesh: turning.mesh,
            turns: turning.choice,
            moved: turning.moved,
            open: LeftOpen::read(v, &[&s::R, &s::Q]),
        };
        Some((RingScene { given, turning }, range))
    }

    fn given(this: &Description<RingScene>) -> Given<f64> {
        this.given.clone()
    }

    fn check(this: &mut Description<RingScene>, v: &Values, found: &mut Vec<Diagnostic>) {
        able(this, &this.turning, v, found);
        this.turning.slewing = moved(this, beside, v, found, this.turning.gravity);
    }

    fn levels(&self) -> Vec<&'static str> {
        self.turning.levels()
    }

    fn set_level(&mut self, level: &str) {
        self.turning.set_level(level);
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        self.turning.unused(level)
    }

    fn moving(this: &Description<RingScene>) -> Option<Result<MovingComponent, Fault>> {
        this.turning.moving()
    }

    fn step_by(&mut self, step: f64) {
        self.turning.step_by(step);
    }

    fn solver(&self) -> Option<Solver> {
        self.turning.solver()
    }

    fn aside(this: &Description<RingScene>) -> Option<Aside> {
        this.given.luffer.as_ref().map(Luffer::aside)
    }

    fn identities(this: &Description<RingScene>, model: &mut Standing) -> Vec<Check> {
        let mut checks = agreements(model, &this.given.rolling, this.given.raceway.d);
        let bolts = this.given.bolts.as_ref();
        checks.extend(bolts.map(|given| bolt_pulls(model, [given.n, given.d])));
        checks.extend(turned(this, model));
        checks.extend(through_the_gear(model, &this.turning));
        checks
    }

    fn assumptions(this: &Description<RingScene>) -> Vec<&'static str> {
        let law = if this.given.rolling.is_linear() {
            "ring_springs"
        } else {
            "ring_power"
        };
        let rows = if this.given.rolling.held_down {
            "ring_hold_down"
        } else {
            "ring_pressure"
        };
        let bolts = this.given.bolts.map(|_| "ring_bolts");
        let life = this.given.dynamic.map(|_| "ring_life");
        let level = keys::level(&this.given.luffer);
        let own = [level, law, rows, "ring_rigid"];
        own.into_iter()
            .chain(bolts)
            .chain(life)
            .chain(this.turning.assumptions())
            .collect()
    }

    fn uncovered(this: &Description<RingScene>) -> Vec<&'static str> {
        let wind = this.given.areas.is_empty().then_some("wind");
        let bolts = this.given.bolts.is_none().then_some("ring_bolts");
        let life = this.given.dynamic.is_none().then_some("ring_life");
        wind.into_iter()
            .chain(bolts)
            .chain(life)
            .chain(["upper_inertia", "ring_rest", "dynamic_coefficients"])
            .chain(this.turning.uncovered())
            .collect()
    }

    /// The moment over the reach; the load curve, with the reference loads of the cases where the curve is used most.
    fn more(this: &Description<RingScene>, model: &mut Standing, sheet: &mut Sheet) {
        told::<RingScene>(&this.turning, model, sheet);
        let governing = sheet.positions.first().map(|position| position.value);
        sheet
            .curves
            .extend(governing.and_then(|at| over_reach(&this.given, at)));
        let most = sheet.governing.iter().find(|found| found.symbol == &s::U_ST_MAX);
        let Some(((_, at), aside)) = most.and_then(|found| Some((found.at?, found.aside))) else {
            return;
        };
        stand(model, aside);
        let [forces, moments] = [&s::F_REF, &s::M_REF].map(|symbol| numbered(model, symbol, at));
        let mut points = this.given.curve.0.clone();
        if let Some(&[force, moment]) = points.last()
            && moment > 0.0
        {
            points.push([force, 0.0]);
        }
        // Backward, and to the middle of the first line, so that its number stands there.
        let middle = [0, 1].map(|i| f64::midpoint(points[0][i], points[1][i]));
        points.reverse();
        points.push(middle);
        let loads = forces
            .into_iter()
            .zip(moments)
            .map(|(force, moment)| corner([force, moment]));
        let pieces: Vec<_> = std::iter::once(points).chain(loads).collect();
        sheet.curves.push(Curve {
            id: "ring_capacity",
            x: &s::F_CURVE,
            y: &s::M_CURVE,
            numbers: (0..pieces.len()).collect(),
            pieces,
        });
    }

    /// The boom lies across no dimension.
    fn drawn_at(this: &Description<RingScene>) -> f64 {
        this.motion.at(0.125)
    }

    /// From above: the raceway, and the boom with its load.
    fn drawing(this: &Description<RingScene>, at: f64) -> Drawing {
        let radius = this.given.raceway.d / 2.0;
        let mut draw = Draw::default();
        draw.path((0..=72).map(|i| polar(radius, f64::from(i).to_radians() * 5.0)));
        let head = polar(2.5 * radius, at);
        draw.bar(&[Point::zeros(), head], false);
        draw.line(Point::new(-1.5 * radius, 0.0), Point::new(2.0 * radius, 0.0));
        draw.angle(Point::zeros(), 0.6 * radius, at, &s::PSI);
        draw.joint(Point::zeros(), "O", true, false);
        draw.joint(head, s::Q.print, false, false);
        draw.distance(Point::new(0.0, -radius), Point::new(0.0, radius), 1.3 * radius, &s::D);
        draw.handle(Point::new(0.0, radius), &[(&s::D, along(Point::zeros(), [0.0, 2.0]))]);
        draw.done(radius)
    }
}
