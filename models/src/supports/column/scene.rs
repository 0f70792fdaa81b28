//! A column as scenes describe it and books tell it.

use crate::component::aside::Aside;
use crate::component::description::{Described, Description, Vocabulary};
use crate::component::draw::{Draw, along, polar};
use crate::component::mechanism::{Entry, Solver};
use crate::component::moving::MovingComponent;
use crate::component::outline::{Limit, Outline};
use crate::component::sheet::{Check, Curve, Drawing, Sheet};
use crate::component::stages::Stages;
use crate::component::standing::Standing;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::luffing::kinds::CARRIED;
use crate::luffing::luffed::Luffer;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;
use crate::slewing::beside::beside;
use crate::slewing::scene::SOLVED;
use crate::supports::column::checks::about_the_foot;
use crate::supports::column::counterweight::EvenedAt;
use crate::supports::column::friction::ColumnFriction;
use crate::supports::column::outline::OUTLINE;
use crate::supports::column::pressure::Bearings;
use crate::supports::column::stages::{Given, SlewingColumn};
use crate::supports::column::symbols as s;
use crate::supports::drive;
use crate::supports::drive::able::able;
use crate::supports::drive::checks::{StandingThere, about_the_axis, through_the_gear};
use crate::supports::drive::moving::{self, SLEWING, moved};
use crate::supports::drive::scene::{DRIVE, TurningScene};
use crate::supports::drive::told::told;
use crate::supports::plan::{LeftOpen, each};
use crate::supports::upper;
use crate::supports::upper::keys::{self, AREAS, LOAD_CASES, MOTION, SLOPE, UPPER};
use crate::supports::upper::load::SupportCase;
use crate::supports::upper::weights::{UpperArea, UpperSlope, UpperWeight};

/// Keys of `[supports]`.
pub const KEYS: &[Key] = keys! { s:
    H_UF > 0, R [or_input, optional], Q >= 0 [or_mass, or_input], THETA_1 [optional], H_1 [optional];
    Key::kind(&["column"], "A crane that slews on a column in an upper bearing, a foot bearing and a pivot."),
    UPPER, LOAD_CASES, AREAS, SLOPE, CARRIED,
    Key::part("bearings", BEARINGS, "Sizes of the three bearings, for their pressures and friction."),
    Key::part("friction", FRICTION, "Friction of the three bearings."),
    Key::part("counterweight", COUNTERWEIGHT, "Where a counterweight would make the moment without load minus that with it."),
    DRIVE, MOTION, SLEWING, SOLVED,
    Key::part("limits", LIMITS, "What results may come to at most.")
};

static BEARINGS: &[Key] = keys! { s: D_U > 0, B_U > 0, D_F > 0, B_F > 0, D_P > 0, D_I >= 0 [usually(0.0)] };
static FRICTION: &[Key] = keys! { s: MU_U >= 0, MU_F >= 0, MU_P >= 0 };
static COUNTERWEIGHT: &[Key] = keys! { s: R_D > 0 };
const LIMITS: &[Key] = &Limit::keys::<18>(OUTLINE.limits);

/// A column as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct ColumnScene {
    given: Given<f64>,
    turning: TurningScene,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<ColumnScene>::entry("column", KEYS);

/// Refuses a pivot that is a hole, and friction of bearings without sizes.
fn suits(v: &Values, found: &mut Vec<Diagnostic>) {
    let bearings = v.table("bearings");
    if let Some(table) = bearings
        && let Some((outer, inner)) = table.of(&s::D_P).zip(table.of(&s::D_I))
        && inner >= outer
    {
        let [outer, inner] = [s::D_P.written(outer), s::D_I.written(inner)];
        let what = format!("a pivot of D_p = {outer} with d_i = {inner} within");
        found.push(table.refuse(s::D_I.id, what, "nothing is left of it", "give d_i below D_p"));
    }
    if let (Some(friction), None) = (v.table("friction"), bearings) {
        let what = "friction of bearings without sizes";
        let help = "add [supports.bearings] with D_u, b_u, D_f, b_f and D_p";
        found.push(Diagnostic::new(friction.span.clone(), what, "needs [supports.bearings]").help(help));
    }
}

/// What resists slewing, another way.
fn turned(this: &ColumnScene, model: &mut Standing) -> Option<Check> {
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
    let mut known = SlewingColumn::new(given.clone());
    known.psi().1 = at;
    let of = |theta: f64| {
        known.held().as_mut()?.1 = theta;
        Some([known.luffed().ok()?.reach, known.worst().ok()?.moment])
    };
    Some(given.luffer.as_ref()?.over_reach("upper_reach", &s::M_ALL, of))
}

impl Described for ColumnScene {
    type Component = SlewingColumn;
    const ID: &'static str = "slewing_column";
    const TABLE: &'static str = "supports";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = moving::FOLLOWED;
    const TOGETHER: &'static [[&'static Symbol; 2]] = moving::TOGETHER;
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "upper_symbol",
        own: &[s::ALL, upper::symbols::ALL, drive::symbols::ALL],
        shared: &drive::SHARED,
    };

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(ColumnScene, Motion)> {
        let one = |symbol: &'static Symbol| v.of(symbol).map(|value| One(symbol, value));
        suits(v, found);
        let range = Motion::read(v.table("motion")?, found)?;
        let turning = TurningScene::read(v, &["friction"], gravity, found)?;
        let rig = keys::rig(v, gravity, found)?;
        let given = Given {
            psi: One(&s::PSI, range.from),
            omega: One(&s::OMEGA, range.speed),
            reach: rig.reach,
            load: one(&s::Q)?,
            height: one(&s::H_UF)?,
            bodies: each(v, "upper", UpperWeight::read)?,
            areas: each(v, "areas", UpperArea::read)?,
            slope: v.part("slope", UpperSlope::read)?,
            hook: keys::hook(v),
            cases: each(v, "load_cases", SupportCase::read)?,
            foot: one(&s::H_1),
            held: rig.held,
            luffer: rig.luffer,
            bearings: v.part("bearings", Bearings::read)?,
            friction: v.part("friction", ColumnFriction::read)?,
            balancing: v.part("counterweight", EvenedAt::read)?,
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
        Some((ColumnScene { given, turning }, range))
    }

    fn given(this: &Description<ColumnScene>) -> Given<f64> {
        this.given.clone()
    }

    fn check(this: &mut Description<ColumnScene>, v: &Values, found: &mut Vec<Diagnostic>) {
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

    fn moving(this: &Description<ColumnScene>) -> Option<Result<MovingComponent, Fault>> {
        this.turning.moving()
    }

    fn step_by(&mut self, step: f64) {
        self.turning.step_by(step);
    }

    fn solver(&self) -> Option<Solver> {
        self.turning.solver()
    }

    fn aside(this: &Description<ColumnScene>) -> Option<Aside> {
        this.given.luffer.as_ref().map(Luffer::aside)
    }

    fn identities(this: &Description<ColumnScene>, model: &mut Standing) -> Vec<Check> {
        let mut checks = about_the_foot(model, *this.given.height);
        checks.extend(turned(this, model));
        checks.extend(through_the_gear(model, &this.turning));
        checks
    }

    fn assumptions(this: &Description<ColumnScene>) -> Vec<&'static str> {
        let pivot = this.given.friction.map(|_| "column_even");
        let rest = [keys::level(&this.given.luffer), "column_rigid"];
        let own = rest.into_iter().chain(pivot);
        own.chain(this.turning.assumptions()).collect()
    }

    fn uncovered(this: &Description<ColumnScene>) -> Vec<&'static str> {
        let wind = this.given.areas.is_empty().then_some("wind");
        wind.into_iter()
            .chain(["upper_inertia", "column_strength", "dynamic_coefficients"])
            .chain(this.turning.uncovered())
            .collect()
    }

    fn more(this: &Description<ColumnScene>, model: &mut Standing, sheet: &mut Sheet) {
        told::<ColumnScene>(&this.turning, model, sheet);
        let governing = sheet.positions.first().map(|position| position.value);
        sheet
            .curves
            .extend(governing.and_then(|at| over_reach(&this.given, at)));
    }

    /// The boom lies across no dimension.
    fn drawn_at(this: &Description<ColumnScene>) -> f64 {
        this.motion.at(0.125)
    }

    /// From the side: the column between its bearings, the boom above as it is seen at a slewing angle.
    fn drawing(this: &Description<ColumnScene>, at: f64) -> Drawing {
        let height = *this.given.height;
        let mut draw = Draw::default();
        let foot = Point::new(0.0, -height);
        draw.bar(&[foot, Point::zeros()], true);
        let head = Point::new(polar(1.5 * height, at).x, 0.8 * height);
        draw.bar(&[Point::zeros(), head], false);
        draw.joint(Point::zeros(), s::H_U.print, true, false);
        draw.joint(foot, s::H_F.print, true, false);
        draw.joint(head, s::Q.print, false, false);
        draw.distance(foot, Point::zeros(), 0.3 * height, &s::H_UF);
        draw.handle(foot, &[(&s::H_UF, along(Point::zeros(), [0.0, -1.0]))]);
        draw.done(height)
    }
}
