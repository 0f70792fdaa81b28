//! A floating crane as scenes describe it and books tell it.

use crate::afloat::drawing::drawn;
use crate::afloat::gust::GustGiven;
use crate::afloat::hull::FloodedSpace;
use crate::afloat::judging::{HullCases, chapter};
use crate::afloat::levers::{Heeled, ToldHeel};
use crate::afloat::loss::LossRule;
use crate::afloat::openings::Opening;
use crate::afloat::outline::{LEVERS, OPENINGS, OUTLINE};
use crate::afloat::planning::{self, ReadCases, only_in};
use crate::afloat::rig::{CraneRig, PEDESTAL, TURNING};
use crate::afloat::shape;
use crate::afloat::stages::{FloatingCrane, Given, MadeInputs};
use crate::afloat::start::{self, DYNAMICS, MOVING, MovingHull};
use crate::afloat::symbols as s;
use crate::afloat::told::{OPENED, TOLD, levers, points};
use crate::afloat::weights::{HullMass, HullTow, HullWind, TankGiven, Weighed, WindageArea};
use crate::component::description::{Described, Description, Vocabulary};
use crate::component::mechanism::{Entry, Solver};
use crate::component::moving::MovingComponent;
use crate::component::moving::smooth::SmoothPieces;
use crate::component::outline::{Limit, Outline};
use crate::component::places::all_told;
use crate::component::sheet::{Check, Curve, Drawing, Input, Sheet};
use crate::component::stages::Stages;
use crate::component::standing::Standing;
use crate::component::telling::{explained, sample};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, SOURCE, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::text::Text;
use crate::kernel::unit::M_DEG;
use crate::kernel::variable::Fault;
use crate::luffing::aboard;
use crate::luffing::kinds::CARRIED;
use crate::parts::hanging;
use crate::parts::motion::Motion;

/// Most masses, tanks, areas, sections and points of each.
const MANY: usize = 64;
const MOST_SECTIONS: usize = 200;
const MOST_POINTS: usize = 100;
const MOST_CASES: usize = 16;

/// Keys of `[hull]`.
pub const KEYS: &[Key] = keys! { s:
    RHO_W > 0 [usually(1025.0)], L > 0 [optional], B > 0 [optional], D > 0 [optional], R [or_input, optional], Q >= 0 [or_mass, or_input, over_time],
    PHI_F > 0 [optional], L_R > 0 [optional], OMEGA_CSL [over_time, optional], PSI_SL [optional], OMEGA_C1 [over_time, optional],
    THETA_1 [optional];
    Key::choice(
        "fidelity",
        &["static", "swing"],
        "How deep the hull is modelled: \"static\" (everything stands still), \"swing\" (it heaves, heels and pitches under a \
         crane that slews by command and a load that swings on its rope).",
    ),
    Key::part("dynamics", DYNAMICS, "What heaves, heels and pitches, and how that is solved."),
    Key::new("sections", Kind::Tables(SECTION, MOST_SECTIONS), "Sections of the hull from stern to bow, instead of a box.").optional(),
    Key::new("masses", Kind::Tables(MASS, MANY), "The hull and all that stands on it, without liquids in tanks and the load."),
    Key::new("tanks", Kind::Tables(TANK, MANY), "Rectangular tanks that are not full.").optional(),
    Key::table("pedestal", PEDESTAL, "Where the crane stands, and how high its load is hung."),
    Key::new("turning", Kind::Tables(TURNING, MANY), "Masses that slew with a crane that luffs, besides its luffing mechanism.").optional(),
    Key::new("openings", Kind::Tables(OPENING, MANY), "Openings through which water comes in: areas of levers end where the first of them comes to the water.").optional(),
    CARRIED,
    Key::part("wind", WIND, "Wind on the hull and the crane."),
    Key::part("tow", TOW, "A rope that tows the hull."),
    Key::new("flooded", Kind::Tables(FLOODED, MANY), "Rectangular compartments within the hull that are open to the water.").optional(),
    Key::new("heels", Kind::Quantities(&s::PHI_H, Sign::Positive, [1, MANY]), "Heels at which righting levers are told.").optional(),
    Key::new(planning::OWN, Kind::Line, "Name of the load case that [hull] itself describes, where there are further ones.").optional(),
    Key::new(planning::CASES, Kind::Tables(CASE, MOST_CASES), "Further load cases: what changes in each, and what it must keep; what a case does not say is as in [hull].").optional(),
    Key::kinds("loss", LOSS, "What a loss of load is judged by."),
    Key::part("gust", GUST, "A sudden wind on the same areas."),
    Key::table("motion", MOTION, "Working range of slewing."),
    Key::part("limits", LIMITS, "What results may come to at most, or at least.")
};

static SECTION: &[Key] = &[
    Key::quantity(&s::X_H, Sign::Any),
    Key::new(
        "points",
        Kind::Texts(MOST_POINTS),
        "Half breadth and height of its points, from keel to deck: \"9 m, 0 m\".",
    ),
    SOURCE,
];
static MASS: &[Key] = keys! { s: G_M [or_mass], X_M, Y_M [usually(0.0)], Z_M };
static TANK: &[Key] = keys! { s:
    RHO_T > 0 [usually(1000.0)], L_T > 0, B_T > 0, D_T > 0, H_T > 0, X_T, Y_T [usually(0.0)], Z_T [usually(0.0)]
};
static AREA: &[Key] = keys! { s: A_W >= 0, Z_W };
static OPENING: &[Key] = keys! { s: X_O, Y_O, Z_O; only_in(MOST_CASES) };
static WIND: &[Key] = keys! { s: P_W >= 0 [or_input], CHI_W, Z_L;
    Key::new("areas", Kind::Tables(AREA, MANY), "Areas on which it acts, with their heights.")
};
static TOW: &[Key] = keys! { s: F_P >= 0, CHI_P, Z_P, Z_LP };
static FLOODED: &[Key] =
    keys! { s: MU_F > 0, L_F > 0, B_F > 0, D_F > 0, X_F, Y_F [usually(0.0)], Z_F [usually(0.0)]; only_in(MOST_CASES) };
static GUST: &[Key] = keys! { s: P_G >= 0, PHI_A >= 0 [usually(0.0)] };
static CASE: &[Key] = keys! { s:
    Q_K >= 0 [or_mass, optional], R_K [optional], THETA_1K [optional], PSI_K [optional], P_WK >= 0 [optional], CHI_WK [optional],
    P_GK >= 0 [optional], F_PK >= 0 [optional];
    Key::new("name", Kind::Line, "Its name."),
    LIMITS[0], LIMITS[1], LIMITS[2], LIMITS[3], LIMITS[4], LIMITS[5], LIMITS[6], LIMITS[7], LIMITS[8], LIMITS[9]
};
static LOSS: &[(&str, &[Key])] = &[
    (
        "cfr_173_025",
        keys! { s: K_A > 0 [usually(1.0)], C_A >= 0 [usually(2.13 * M_DEG.factor)];
        Key::kind(&["cfr_173_025"], "46 CFR 173.025: A_II > A_I + c_A.") },
    ),
    (
        "ratio",
        keys! { s: K_A > 0 [usually(1.4)], C_A >= 0 [usually(0.0)];
        Key::kind(&["ratio"], "Class rules: A_II >= k_A A_I.") },
    ),
];
const MOTION: &[Key] = &Motion::keys(
    [&s::FROM, &s::TO],
    &s::PSI_SL,
    (&s::OMEGA_SL, "Angular velocity of slewing."),
);
const LIMITS: &[Key] = &Limit::keys::<11>(OUTLINE.limits);

/// What the rates cost, in s.
const COST: [f64; 2] = [1.5e-6, 0.0];

/// Degrees up to which the curve of levers is drawn, and the steps of the area that is checked.
const DRAWN: i32 = 60;
const STRIPS: u32 = 200;

/// A floating crane as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct AfloatScene {
    given: Given<f64>,
    /// Whether the loss of load is judged by a ratio of areas.
    ratio: bool,
    /// Names of the load cases, its own first.
    cases: Vec<Text>,
    /// Longest step of the solver, in s, where it moves.
    step: Option<f64>,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<AfloatScene>::entry("hull", KEYS);

/// What is read of each table of a list.
fn each<T>(v: &Values, name: &str, read: impl Fn(&Values) -> Option<T>) -> Option<Vec<T>> {
    v.tables(name).iter().map(read).collect()
}

/// Refuses tanks that hold more than they can, and a rule without the heel up to which areas count.
fn suits(v: &Values, found: &mut Vec<Diagnostic>) {
    for table in v.tables("tanks") {
        if let (Some(high), Some(deep)) = (table.number(s::H_T.id), table.number(s::D_T.id))
            && high >= deep
        {
            let what = format!("a tank filled to h_t = {}", s::H_T.written(high));
            let help = format!(
                "it is d_t = {} deep; one that is full has no free surface: it is a mass",
                s::D_T.written(deep)
            );
            found.push(table.refuse(s::H_T.id, what, "not below its top", help));
        }
    }
    shape::within(v, found);
    for (name, what) in [
        ("loss", "a loss of load without phi_f"),
        ("gust", "a sudden wind without phi_f"),
    ] {
        if v.has(name) && !v.has(s::PHI_F.id) {
            let help = "give phi_f = \"25 deg\" beside it, the heel of flooding or another limit of the criterion";
            found.push(v.refuse(name, what, "up to which heel?", help));
        }
    }
    if v.has("gust") && !v.has("wind") {
        let help = "give [hull.wind] with its areas, if only with p_w = \"0 Pa\"";
        found.push(v.refuse("gust", "a sudden wind on no areas", "no areas", help));
    }
}

impl Described for AfloatScene {
    type Component = FloatingCrane;
    const ID: &'static str = "afloat";
    const TABLE: &'static str = "hull";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = listed!(s: M_SL, M_1);
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "afloat_symbol",
        own: &[s::ALL],
        shared: &[aboard::ALL, gravity::ALL, hanging::ALL],
    };

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(AfloatScene, Motion)> {
        let before = found.len();
        let range = Motion::read(v.table("motion")?, found)?;
        suits(v, found);
        start::suits(v, found);
        let rig = CraneRig::read(v, gravity, found);
        let (built, offsets, wind) = (shape::built(v, found), shape::sections(v, found), v.table("wind"));
        let rig = rig.filter(|_| found.len() == before)?;
        let cases = ReadCases::read(v, rig.rig.held.map(|held| held.1), found);
        let one = |symbol: &'static Symbol| v.of(symbol).map(|value| One(symbol, value));
        let open = |of: &Values, symbol: &'static Symbol| {
            (of.is_input(symbol.id) || of.course(symbol.id).is_some()).then_some(symbol)
        };
        let inputs = [
            open(v, &s::R),
            open(v, &s::Q),
            v.table("pedestal").and_then(|table| open(table, &s::H_S)),
            wind.and_then(|wind| open(wind, &s::P_W)),
        ];
        let mut given = Given {
            psi: One(&s::PSI_SL, range.from),
            omega: One(&s::OMEGA_SL, range.speed),
            reach: rig.rig.reach,
            load: one(&s::Q)?,
            place: rig.place,
            height: rig.height,
            turning: rig.turning,
            density: one(&s::RHO_W)?,
            built,
            masses: each(v, "masses", HullMass::read)?,
            tanks: each(v, "tanks", TankGiven::read)?,
            wind: v.part("wind", HullWind::read)?,
            areas: wind.map_or(Some(Vec::new()), |wind| each(wind, "areas", WindageArea::read))?,
            tow: v.part("tow", HullTow::read)?,
            flooded: each(v, "flooded", FloodedSpace::read)?,
            heels: v
                .numbers("heels")
                .iter()
                .map(|(phi_h, _)| ToldHeel { phi_h: *phi_h })
                .collect(),
            openings: each(v, "openings", Opening::read)?,
            limit: v.has(s::PHI_F.id).then(|| one(&s::PHI_F)).flatten(),
            rule: v.part("loss", LossRule::read)?,
            gust: v.part("gust", GustGiven::read)?,
            gravity: One(&s::G, gravity),
            loads: cases.loads,
            hangs: cases.hangs,
            winds: cases.winds,
            gusts: cases.gusts,
            pulls: cases.pulls,
            buoyed: None,
            servo: None,
            luffing_servo: None,
            command: None,
            luffing_command: None,
            held: rig.rig.held,
            moved: None,
            roped: None,
            luffing: None,
            offsets,
            luffer: rig.rig.luffer,
            planned: cases.planned,
            inputs: MadeInputs(inputs.into_iter().flatten().collect()),
        };
        let ratio = v.table("loss").is_some_and(|loss| loss.text("kind") == Some("ratio"));
        let moves = MovingHull::read(v, range.from, rig.command);
        let step = moves.and_then(|moves| moves.begin(v, &mut given, found));
        (found.len() == before).then_some((
            AfloatScene {
                given,
                ratio,
                cases: cases.names,
                step,
            },
            range,
        ))
    }

    fn given(this: &Description<AfloatScene>) -> Given<f64> {
        this.given.clone()
    }

    fn levels(&self) -> Vec<&'static str> {
        std::iter::once("static").chain(self.step.map(|_| "swing")).collect()
    }

    fn chapters(&self) -> Vec<&'static str> {
        self.given.loads.first().map(|_| "cases").into_iter().collect()
    }

    fn set_level(&mut self, level: &str) {
        if level == "static" {
            let given = &mut self.given;
            (given.buoyed, given.servo, given.command) = (None, None, None);
            (given.moved, given.roped, self.step) = (None, None, None);
            (given.luffing_servo, given.luffing_command) = (None, None);
            let luffing = given.luffing.take();
            given.held = luffing.map(|luffing| One(&s::THETA_1, luffing.theta_1)).or(given.held);
        }
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        match level {
            "static" => vec![("hull", &MOVING), ("dynamics", &[])],
            _ => Vec::new(),
        }
    }

    fn moving(this: &Description<AfloatScene>) -> Option<Result<MovingComponent, Fault>> {
        let step = this.step?;
        let mut start = vec![this.given.psi.1, this.given.omega.1];
        this.given.moved?.map(&mut |_, value| start.push(value));
        this.given.roped?.map(&mut |_, value| start.push(value));
        this.given
            .luffing
            .map(|luffing| luffing.map(&mut |_, value| start.push(value)));
        Some(MovingComponent::new(this.standing(), |model| {
            Ok(Box::new(SmoothPieces::new(model, &start, step)?))
        }))
    }

    fn step_by(&mut self, step: f64) {
        self.step = self.step.map(|_| step);
    }

    fn solver(&self) -> Option<Solver> {
        self.step.map(|step| Solver::explicit(&s::STEP, step, COST))
    }

    /// Where it begins, at rest.
    fn arrange(&self, inputs: &mut Vec<Input>) {
        let mut stands = |symbol, value| {
            inputs.push(Input {
                symbol,
                value,
                number: None,
                chapter: "afloat_start",
                given: None,
                on: None,
                usual: true,
            });
            value
        };
        if let Some(motion) = &self.given.moved {
            motion.map(&mut stands);
        }
        if let Some(load) = &self.given.roped {
            load.map(&mut stands);
        }
        if let Some(luffing) = &self.given.luffing {
            luffing.map(&mut stands);
        }
    }

    fn hangs_on(this: &Description<AfloatScene>) -> Option<[f64; 2]> {
        this.given.roped.map(|load| [-load.r_z, this.given.gravity.1])
    }

    fn hang(&mut self, length: f64) {
        self.given.roped = Some(start::hanging(length));
    }

    /// The area under the righting lever against the rise of the centre of gravity over that of buoyancy.
    fn identities(this: &Description<AfloatScene>, model: &mut Standing) -> Vec<Check> {
        let end = 0.5;
        let step = end / f64::from(STRIPS);
        let Some([lever, ..]) = levers(&this.given, this.motion.from, (0..=STRIPS).map(|i| f64::from(i) * step)) else {
            return Vec::new();
        };
        // By Simpson's rule.
        let weight = |i: usize| match i {
            0 => 1.0,
            i if i == STRIPS as usize => 1.0,
            i => 2.0 + 2.0 * (i % 2) as f64,
        };
        let area: f64 = lever.iter().enumerate().map(|(i, [_, y])| weight(i) * y).sum::<f64>() * step / 3.0;
        let mut known = FloatingCrane::new(this.given.clone());
        known.psi().1 = this.motion.from;
        let rise = known.loaded().ok().map(|loaded| Weighed {
            across: 0.0,
            ..loaded.all
        });
        let rise = rise.zip(known.floating().ok()).and_then(|(all, floating)| {
            let mut heeled = Heeled::new(floating, &all, None);
            Some(heeled.raised(end).ok()?[0] - heeled.raised(0.0).ok()?[0])
        });
        let weights = sample(model, &[&s::W, &s::NABLA], std::iter::once(this.motion.from)).remove(0);
        let water = this.given.density.1 * this.given.gravity.1 * weights[1];
        let energy =
            rise.map(|rise| Check::at_most("afloat_energy", &s::AGREEMENT, (area - rise).abs() / rise.abs(), 1e-6));
        let floats = Check::at_most(
            "afloat_water",
            &s::AGREEMENT,
            (water - weights[0]).abs() / weights[0],
            1e-12,
        );
        energy.into_iter().chain([floats]).collect()
    }

    fn assumptions(this: &Description<AfloatScene>) -> Vec<&'static str> {
        let rule = this
            .given
            .rule
            .map(|_| if this.ratio { "afloat_ratio" } else { "afloat_cfr" });
        let own = match this.step {
            None => ["afloat_level_static", "afloat_hung", "afloat_liquids"],
            Some(_) => ["afloat_level_swing", "afloat_heading", "afloat_water_added"],
        };
        let slews = match (&this.given.luffer, this.step) {
            (Some(_), Some(_)) => Some("afloat_crane_moves"),
            (Some(_), None) => Some("afloat_crane_stands"),
            (None, Some(_)) => Some("afloat_weightless"),
            (None, None) => None,
        };
        let wind = this.given.wind.map(|_| "afloat_wind");
        let tow = this.given.tow.map(|_| "afloat_tow");
        let flooded = (!this.given.flooded.is_empty()).then_some("afloat_flooded");
        let more = slews.into_iter().chain(wind).chain(tow).chain(flooded);
        own.into_iter().chain(more).chain(rule).collect()
    }

    fn uncovered(this: &Description<AfloatScene>) -> Vec<&'static str> {
        let wind = this.given.wind.is_none().then_some("wind");
        let flooded = this.given.flooded.is_empty().then_some("afloat_flooded");
        wind.into_iter()
            .chain(flooded)
            .chain(["afloat_motion", "strength"])
            .chain(this.given.loads.is_empty().then_some("load_cases"))
            .collect()
    }

    /// Levers over the heel where it is greatest, and those that the scene asks for in a table.
    fn more(this: &Description<AfloatScene>, model: &mut Standing, sheet: &mut Sheet) {
        let offsets = this.given.offsets.as_ref();
        sheet
            .lists
            .extend(offsets.map(|offsets| ("afloat_sections", points(offsets))));
        let cases = HullCases {
            given: &this.given,
            names: &this.cases,
            ratio: this.ratio,
            motion: &this.motion,
        };
        sheet.cases = chapter::<AfloatScene>(&cases, model, sheet);
        let Some(at) = sheet.positions.first().map(|position| position.value) else {
            return;
        };
        if let Some(mut curves) = levers(&this.given, at, (0..=DRAWN).map(|i| f64::from(i).to_radians())) {
            // The wall-sided form grows without end.
            let most = curves[0].iter().map(|point| point[1]).fold(0.0, f64::max);
            curves[1].retain(|point| point[1] <= 1.3 * most);
            sheet.curves.push(Curve {
                id: "afloat_levers",
                x: &s::PHI,
                y: &s::GZ,
                pieces: curves.to_vec(),
                numbers: vec![1, 2, 3],
            });
        }
        let (openings, levers) = (all_told(model, at, OPENED), all_told(model, at, TOLD));
        let Some(position) = sheet.positions.first_mut() else {
            return;
        };
        if let Some(section) = position.sections.iter_mut().find(|section| section.id == OPENINGS) {
            section.table = openings;
        }
        if let Some(table) = levers {
            let last = Some(table.rows.len());
            let mut told = explained::<AfloatScene>(model, (at, last), &[], LEVERS);
            if let Some(section) = told.first_mut() {
                section.table = Some(table);
            }
            position.sections.extend(told);
        }
    }

    /// Where the load hangs aside, at any rate of a range that begins at the bow or at the stern.
    fn drawn_at(this: &Description<AfloatScene>) -> f64 {
        this.motion.at(0.25)
    }

    fn drawing(this: &Description<AfloatScene>, at: f64) -> Drawing {
        drawn(&this.given, at)
    }
}
