//! A mobile crane as scenes describe it and books tell it.

use crate::component::description::{Described, Description, Vocabulary};
use crate::component::mechanism::Entry;
use crate::component::outline::{Limit, Outline};
use crate::component::running::Running;
use crate::component::sheet::{Check, Drawing, Sheet};
use crate::component::standing::Standing;
use crate::component::telling::{fine, numbered, sample};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::measure;
use crate::kernel::schema::{Key, Kind, SOURCE, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::parts::hull::hull;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;
use crate::supports::mobile::bearing::{Pad, SupportCapacity};
use crate::supports::mobile::boom::{BoomPart, BoomShape, HeadPose};
use crate::supports::mobile::chart::LoadChart;
use crate::supports::mobile::charting::chart;
use crate::supports::mobile::outline::OUTLINE;
use crate::supports::mobile::rating::{Divided, Factored, Fraction, Permission, RatingBasis};
use crate::supports::mobile::stages::{Given, MobileCrane};
use crate::supports::mobile::strength::{FIRST_STRENGTH, STRENGTHS, Strength, Strengths};
use crate::supports::mobile::symbols as s;
use crate::supports::mobile::tipping::SupportPoint;
use crate::supports::mobile::weights::{CarrierBody, Hook, Inclined, UpperBody, WindOnLoad};
use crate::supports::plan::{LeftOpen, drawn, each, unbalanced};

/// Most bodies of each kind, supports and lengths; a chart may have so many reaches.
const MANY: usize = 64;
const MOST_REACHES: f64 = 1000.0;

/// Keys of `[supports]`.
pub const KEYS: &[Key] = keys! { s:
    L > 0 [or_input], PHI [or_input, optional], R [or_input, optional], Q >= 0 [or_mass, or_input],
    G_H >= 0 [or_mass, usually(0.0)], PHI_Q > 0 [usually(1.0)], A_P > 0 [optional];
    Key::kind(&["mobile"], "A mobile crane on outriggers or tyres."),
    Key::new("points", Kind::Tables(POINT, MANY), "Where the crane stands: outriggers or tyres, three at least."),
    Key::new("carrier", Kind::Tables(CARRIER, MANY), "Bodies of the carrier, with its outriggers.").optional(),
    Key::new("upper", Kind::Tables(UPPER, MANY), "Bodies of the upper works, with the counterweight.").optional(),
    Key::table("boom", BOOM, "The boom and its parts."),
    Key::part("slope", SLOPE, "The ground that is not level."),
    Key::part("wind", WIND, "Wind on the load."),
    Key::kinds("rating", RATINGS, "How much of the tipping load is permitted."),
    Key::new("strength", Kind::Tables(STRENGTH, MANY), "What strength permits, as tables.").optional(),
    Key::part("chart", CHART, "The load chart over reach and length of the boom."),
    Key::table("motion", MOTION, "Working range of slewing, over which the load chart holds."),
    Key::part("limits", LIMITS, "What results may come to at most.")
};

static POINT: &[Key] = keys! { s: X, Y, N_CAP > 0 [optional] };
static CARRIER: &[Key] = keys! { s: G_C [or_mass], X_C, Y_C [usually(0.0)], H_C [usually(0.0)] };
static UPPER: &[Key] = keys! { s: G_U [or_mass], R_U, H_U [usually(0.0)] };
static PARTS: &[Key] = keys! { s: G_P [or_mass], Q_P >= 0 [usually(0.0)], S_P, KAPPA_P >= 0 [usually(0.0)] };
static BOOM: &[Key] = keys! { s: X_F, H_F >= 0, D_A [usually(0.0)], L_0 > 0, PHI_MIN [usually(0.0)], PHI_MAX;
    Key::new("parts", Kind::Tables(PARTS, MANY), "Parts of the boom: sections of a telescopic one; heel, inserts and head of a lattice one.")
};
static SLOPE: &[Key] = keys! { s: GAMMA_S >= 0 };
static WIND: &[Key] = keys! { s: V_W >= 0, C_P > 0 [usually(0.613)], A_Q >= 0 [usually(1.2e-3)] };

/// Keys of each basis, with those that all have.
macro_rules! basis {
    ($kind:literal $what:literal: $($name:ident $($usual:literal)?),*) => {
        keys! { s: $($name > 0 $([usually($usual)])?,)* S_LIM >= 0 [usually(0.15)], K_W > 0 [usually(0.9)];
            Key::kind(&[$kind], $what) }
    };
}
static RATINGS: &[(&str, &[Key])] = &[
    ("factors", basis!("factors" "(P - k_F F_b) / k_P": K_P 1.25, K_F 0.1)),
    ("part", basis!("part" "nu P": NU 0.75)),
    ("safety", basis!("safety" "P / K_t": K_T 1.4)),
];
static STRENGTH: &[Key] = &[
    Key::new("of", Kind::Choice(&STRENGTHS), "Whose strength it is."),
    Key::quantity(&s::L, Sign::Positive).optional(),
    Key::weight(&s::Q_S).optional(),
    Key::new(
        "points",
        Kind::Texts(200),
        "Reach and load there, with growing reach: \"3 m, 50 t\".",
    )
    .optional(),
    SOURCE,
];
static CHART: &[Key] = keys! { s: R_FROM > 0, R_TO > 0, R_STEP > 0;
    Key::new("lengths", Kind::Quantities(&s::L, Sign::Positive, [1, MANY]), "Lengths of the boom.")
};
const MOTION: &[Key] = &Motion::keys([&s::FROM, &s::TO], &s::PSI, (&s::OMEGA, "Angular velocity of slewing."));
const LIMITS: &[Key] = &Limit::keys::<3>(OUTLINE.limits);

/// A mobile crane as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct MobileScene {
    given: Given<f64>,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<MobileScene>::entry("mobile", KEYS);

/// The tables of strengths; mistakes go to `found`.
fn strengths(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Strengths {
    let weight = Key::weight(&s::Q_S);
    let point = |text: &str| {
        let (reach, load) = text.split_once(',')?;
        let load = measure::number(load, &weight).ok()?;
        let reach = measure::quantity(reach, &s::R, Sign::Positive).ok()?;
        Some([reach, load.mass.map_or(load.value, |mass| mass * gravity)])
    };
    let mut all = Vec::new();
    for table in v.tables("strength") {
        let mut points: Vec<[f64; 2]> = Vec::new();
        for (text, span) in table.texts("points") {
            match point(text).filter(|new| points.last().is_none_or(|last| last[0] < new[0])) {
                Some(new) => points.push(new),
                None => found.push(
                    Diagnostic::new(span.clone(), format!("\"{text}\" is no point of a table"), "not this")
                        .help("write reach and load, with growing reach: \"3 m, 50 t\""),
                ),
            }
        }
        let constant = table.number(s::Q_S.id).map(|load| [f64::INFINITY, load]);
        if constant.is_some() == table.has("points") {
            let help = "give Q_s = \"50 t\" for all reaches, or points = [\"3 m, 50 t\", \"6 m, 20 t\"]";
            found.push(table.refuse(
                "points",
                "a strength needs either `points` or `Q_s`",
                "one of both",
                help,
            ));
        }
        let of = STRENGTHS
            .iter()
            .position(|known| table.text("of") == Some(known))
            .unwrap_or(0);
        points.extend(constant);
        all.push(Strength {
            of: FIRST_STRENGTH + of,
            length: table.number(s::L.id).unwrap_or(f64::INFINITY),
            points,
        });
    }
    Strengths(all)
}

fn basis(v: Option<&Values>) -> Option<RatingBasis<f64>> {
    let Some(v) = v else {
        return Some(RatingBasis::Factored(Factored { k_p: 1.25, k_f: 0.1 }));
    };
    match v.text("kind") {
        Some("part") => Fraction::read(v).map(RatingBasis::Fraction),
        Some("safety") => Divided::read(v).map(RatingBasis::Divided),
        _ => Factored::read(v).map(RatingBasis::Factored),
    }
}

/// Refuses what is given twice or not at all, and supports that hold nothing.
fn suits(v: &Values, points: &[SupportPoint<f64>], found: &mut Vec<Diagnostic>) {
    let [phi, reach] = [s::PHI.id, s::R.id].map(|id| v.has(id));
    if phi == reach {
        let (what, label) = match phi {
            true => ("phi and R say the same", "given twice"),
            false => ("neither phi nor R is given", "needed here"),
        };
        let help = "give the boom's angle phi = \"60 deg\" or its reach R = \"10 m\", as numbers or as inputs: \
                    R = { input = \"10 m\" }";
        found.push(v.refuse(s::R.id, what, label, help));
    }
    let places: Vec<Point<f64>> = points.iter().map(SupportPoint::point).collect();
    if hull(&places).is_none() {
        let help = "give three supports at least, which do not stand on one line";
        found.push(v.refuse("points", "the crane stands on no area", "no polygon", help));
    }
    let caps = v.tables("points").iter().filter(|point| point.has(s::N_CAP.id)).count();
    if caps != 0 && caps != points.len() {
        let help = "give N_cap of every support, or of none";
        found.push(v.refuse("points", "some supports have N_cap, and not all", "incomplete", help));
    }
}

/// Whether the boom can stand as it is given.
fn stands(v: &Values, given: &Given<f64>, found: &mut Vec<Diagnostic>) -> bool {
    let Err(fault) = HeadPose::new(&given.shape, &given.length, &given.angle, &given.reach) else {
        return true;
    };
    let short = given.length.1 < given.shape.l_0;
    let (key, help) = match (short, given.angle) {
        (true, _) => (s::L.id, "give l from l_0 on"),
        (false, Some(_)) => (s::PHI.id, "give phi from phi_min to phi_max"),
        (false, None) => (s::R.id, "give a reach that the boom has between phi_min and phi_max"),
    };
    found.push(v.refuse(key, fault.message, "not possible", help));
    false
}

/// Lengths and reaches of the load chart, in m; empty without one.
fn axes(v: &Values, shortest: f64, found: &mut Vec<Diagnostic>) -> Option<[Vec<f64>; 2]> {
    let Some(table) = v.table("chart") else {
        return Some([Vec::new(), Vec::new()]);
    };
    let mut lengths: Vec<f64> = Vec::new();
    for (length, span) in table.numbers("lengths") {
        let grows = lengths.last().is_none_or(|last| last < length);
        if !grows || *length < shortest {
            let what = format!("a boom with l = {}", s::L.written(*length));
            let help = format!("give growing lengths, from l_0 = {}", s::L.written(shortest));
            found.push(Diagnostic::new(span.clone(), what, "not possible here").help(help));
        }
        lengths.push(*length);
    }
    let [from, to, step] = [&s::R_FROM, &s::R_TO, &s::R_STEP].map(|symbol| table.of(symbol));
    let (from, to, step) = (from?, to?, step?);
    let count = ((to - from) / step + 1e-9).floor();
    if !(0.0..=MOST_REACHES).contains(&count) {
        let what = format!("a chart from R = {} to {}", s::R.written(from), s::R.written(to));
        let help = format!("give R_to above R_from, and at most {MOST_REACHES} steps");
        found.push(table.refuse(s::R_TO.id, what, "not possible", help));
        return None;
    }
    Some([
        lengths,
        (0..=count as u32).map(|i| from + f64::from(i) * step).collect(),
    ])
}

impl Described for MobileScene {
    type Component = MobileCrane;
    const ID: &'static str = "mobile";
    const TABLE: &'static str = "supports";
    const OUTLINE: &'static Outline = &OUTLINE;
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "mobile_symbol",
        own: &[s::ALL],
        shared: &[crate::kernel::gravity::ALL],
    };

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(MobileScene, Motion)> {
        let before = found.len();
        let points = each(v, "points", SupportPoint::read)?;
        suits(v, &points, found);
        let boom = v.table("boom")?;
        let one = |symbol: &'static Symbol| v.of(symbol).map(|value| One(symbol, value));
        let range = Motion::read(v.table("motion")?, found)?;
        let rating = v.table("rating");
        let permission = rating.map_or(Some(Permission { s_lim: 0.15, k_w: 0.9 }), Permission::read)?;
        let [lengths, reaches] = axes(v, boom.of(&s::L_0)?, found)?;
        let mut given = Given {
            psi: One(&s::PSI, range.from),
            omega: One(&s::OMEGA, range.speed),
            angle: v.has(s::PHI.id).then(|| one(&s::PHI)).flatten(),
            reach: v.has(s::R.id).then(|| one(&s::R)).flatten(),
            length: One(&s::L, v.number(s::L.id)?),
            load: one(&s::Q)?,
            hook: Hook::read(v)?,
            caps: v.tables("points").iter().filter_map(SupportCapacity::read).collect(),
            points,
            pad: Pad::read(v),
            carrier: each(v, "carrier", CarrierBody::read)?,
            upper: each(v, "upper", UpperBody::read)?,
            shape: BoomShape::read(boom)?,
            parts: each(boom, "parts", BoomPart::read)?,
            slope: v.part("slope", Inclined::read)?,
            wind: v.part("wind", |wind| {
                WindOnLoad::of(|symbol| {
                    if symbol == &s::G {
                        Some(gravity)
                    } else {
                        wind.of(symbol)
                    }
                })
            })?,
            basis: basis(rating)?,
            permission,
            strengths: strengths(v, gravity, found),
            chart: None,
            open: LeftOpen::read(v, &[&s::L, &s::PHI, &s::R, &s::Q]),
        };
        if found.len() > before || !stands(v, &given, found) {
            return None;
        }
        if v.has("chart") {
            match chart(&given, &lengths, &reaches, &range) {
                Ok(chart) => given.chart = Some(chart),
                Err(fault) => {
                    let help = "mend what the message names, or leave the chart out";
                    found.push(v.refuse("chart", fault.message, "no chart can be made", help));
                }
            }
        }
        Some((MobileScene { given }, range))
    }

    fn given(this: &Description<MobileScene>) -> Given<f64> {
        this.given.clone()
    }

    fn levels(&self) -> Vec<&'static str> {
        vec!["static"]
    }

    fn chapters(&self) -> Vec<&'static str> {
        self.given.chart.iter().map(|_| "charts").collect()
    }

    /// Forces of the supports against the weight and its place; the tipping load against where the ground's force lies
    /// under it.
    fn identities(this: &Description<MobileScene>, model: &mut Standing) -> Vec<Check> {
        let (mut shared, mut tipped) = (0.0_f64, 0.0_f64);
        let own = this.given.load.1;
        let points: Vec<Point<f64>> = this.given.points.iter().map(SupportPoint::point).collect();
        let size = points.iter().map(|p| p.norm()).fold(0.0, f64::max);
        let load = model
            .variables()
            .iter()
            .position(|variable| variable.symbol == &s::Q)
            .expect("always given");
        for at in fine(&this.motion) {
            let forces = numbered(model, &s::N, at);
            let row = sample(model, &[&s::V, &s::X_V, &s::Y_V, &s::P], std::iter::once(at)).remove(0);
            shared = shared.max(unbalanced(&forces, &points, row[0], Point::new(row[1], row[2])));
            let hung = row[3] - this.given.hook.g_h;
            if hung >= 0.0 && hung.is_finite() && model.set(load, hung).is_ok() {
                let margin = sample(model, &[&s::A], std::iter::once(at))[0][0];
                tipped = tipped.max(margin.abs() / size);
            }
            model.set(load, own).expect("as given");
        }
        vec![
            Check::at_most("mobile_forces", &s::AGREEMENT, shared, 1e-12),
            Check::at_most("mobile_tipping", &s::AGREEMENT, tipped, 1e-9),
        ]
    }

    /// A load within the supports tips nothing.
    fn pieces(&self, _: &'static str, points: Vec<[f64; 2]>) -> Vec<Vec<[f64; 2]>> {
        let ends = |point: &[f64; 2]| !point[1].is_finite();
        points
            .split(ends)
            .filter(|piece| piece.len() > 1)
            .map(<[_]>::to_vec)
            .collect()
    }

    fn assumptions(this: &Description<MobileScene>) -> Vec<&'static str> {
        let aside = (this.given.slope.is_some() || this.given.wind.is_some()).then_some("mobile_aside");
        ["mobile_level_static", "mobile_frame"]
            .into_iter()
            .chain(aside)
            .collect()
    }

    fn uncovered(this: &Description<MobileScene>) -> Vec<&'static str> {
        let wind = this.given.wind.is_none().then_some("wind");
        wind.into_iter()
            .chain(["mobile_deflection", "dynamic_coefficients", "strength", "load_cases"])
            .collect()
    }

    /// Strengths as they are given, and the load chart.
    fn more(this: &Description<MobileScene>, _: &mut Standing, sheet: &mut Sheet) {
        let back = sheet.governing.iter().find(|found| found.symbol == &s::S_BACK_MIN);
        let asked = back.map(|found| Check::of("mobile_backward", found, this.given.permission.s_lim, false));
        sheet.requirements.extend(asked);
        sheet.constants.extend(this.given.strengths.told());
        sheet.charts.extend(this.given.chart.as_ref().map(LoadChart::told));
    }

    /// From above: the supports with their polygon, and the boom.
    fn drawing(this: &Description<MobileScene>, at: f64) -> Drawing {
        let given = &this.given;
        let places: Vec<Point<f64>> = given.points.iter().map(SupportPoint::point).collect();
        let corners = hull(&places).expect("checked when the scene was read");
        let (draw, size, _) = drawn(&places, &corners, at, &s::PSI);
        draw.done(size)
    }
}
