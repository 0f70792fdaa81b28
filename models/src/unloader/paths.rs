//! Ways from ship to hopper: what they ask of a scene; beside each other in runs of the model, plain, under feedback, programmed.

use std::f64::consts::TAU;

use crate::component::description::{Described, Description};
use crate::component::ride::{INSTANTS, most, ride};
use crate::component::sheet::{Curve, Section, Table};
use crate::kernel::course::Course;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::motion::short_step;
use crate::sway::scene::unmoved;
use crate::unloader::foreseen::Foreseen;
use crate::unloader::stages::Given;
use crate::unloader::sway::GrabWay;
use crate::unloader::symbols as s;

/// Keys that say something of the motion alone.
pub(super) const MOVING: [&str; 5] = ["x_t", "phi_R", "zeta_f", "way", "dynamics"];

/// Longest step of the solver over the period of the sway, and the shortest that may be given over that.
pub(super) const LONGEST: f64 = 0.01;
const SHORTEST: f64 = 1e-2;

/// Refuses what a motion lacks, a way that is too short for its speed, and what has no use where nothing moves.
pub(super) fn moves(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) {
    if v.text("fidelity") != Some("swing") {
        let told = [&s::A_T, &s::V_H].map(|symbol| symbol.id).into_iter();
        let over_time = told.filter(|key| *key == s::A_T.id || v.course(key).is_some());
        unmoved(v, MOVING.into_iter().chain(over_time), "speed", found);
        return;
    }
    let Some(table) = v.table("way") else {
        let what = "[grab_unloader.way] is missing of fidelity = \"swing\"";
        found.push(v.refuse("fidelity", what, "needs way", "add it: l_R, v_m, a_m, s_m"));
        return;
    };
    if let Some((way, load)) = GrabWay::read(table).zip(table.of(&s::L_R)) {
        let period = TAU * (load / gravity).sqrt();
        let least = way.v * (way.v / way.a + period / 3.0);
        if way.s < least {
            let what = format!("s_m = {} for v_m = {}", s::S_M.written(way.s), s::V_M.written(way.v));
            let help = format!(
                "give at least {}, on which starts without sway have room, or a lower v_m",
                s::S_M.written(least)
            );
            found.push(table.refuse(s::S_M.id, what, "too short", help));
        }
        let longest = LONGEST * period;
        let dynamics = v.table("dynamics");
        found.extend(dynamics.and_then(|table| short_step(table, &s::STEP, [SHORTEST * longest, longest])));
    }
}

/// A way: its number, what the trolley is told, and the scene under which it goes, on its ropes and on longer ones.
struct Way<'a, T> {
    number: u32,
    course: Course,
    by: &'a [Description<T>; 2],
    /// How long it goes on after what it is told, in s.
    after: f64,
}

/// Of a way its row, its path and its sway over time.
type Gone = (Vec<f64>, [Vec<[f64; 2]>; 2]);

/// What is known before of the way to the land side.
pub(super) fn foreseen(given: &Given<f64>, hoisting: Option<Course>) -> Option<Foreseen> {
    let (way, load) = (given.way?, given.swaying?);
    Some(Foreseen {
        length: load.l,
        hoisting,
        gravity: *given.gravity,
        told: [way.v, way.a],
        way: way.s,
    })
}

/// A row and a path for each way, and the programme by the angle: of a scene without feedback and one with its own, each on its
/// ropes and on longer ones.
pub(super) fn ways<T: Described>(
    [plain, fed]: [&[Description<T>; 2]; 2],
    given: &Given<f64>,
    feeds: bool,
) -> Option<Vec<Section>> {
    let hoisting = plain[0].courses.iter().find(|(symbol, _)| *symbol == &s::V_H);
    let known = foreseen(given, hoisting.map(|(_, course)| course.clone()))?;
    let period = TAU * (known.length / known.gravity).sqrt();
    let of = |number, course, by, after| Way {
        number,
        course,
        by,
        after,
    };
    let by_angle = known.by_angle();
    let all = [
        Some(of(1, known.plain(), plain, 0.0)),
        feeds.then(|| of(2, known.plain(), fed, period)),
        Some(of(3, known.by_period(), plain, 0.0)),
        by_angle.clone().map(|course| of(4, course, plain, 0.0)),
    ];
    let gone = all.iter().flatten().map(|way| way.gone(period));
    let gone: Vec<Gone> = gone.collect::<Option<_>>()?;
    let curve = |id, x, y, which: usize| Curve {
        id,
        x,
        y,
        pieces: gone.iter().map(|(_, curves)| curves[which].clone()).collect(),
        numbers: gone.iter().map(|(row, _)| row[0] as usize).collect(),
    };
    let programme = by_angle.map(|course| Table {
        columns: listed!(s: T_PG, A_PG).to_vec(),
        rows: course.rows.iter().map(|[time, rate]| vec![*time, -rate]).collect(),
    });
    Some(vec![
        Section {
            id: "unloader_ways",
            curve: Some(curve("unloader_path", &s::X_L, &s::Y_Q, 0)),
            table: Some(Table {
                columns: listed!(s: NUMBER, T_WAY, PHI_WAY, RHO_WAY, RHO_LL).to_vec(),
                rows: gone.iter().map(|(row, _)| row.clone()).collect(),
            }),
            ..Section::default()
        },
        Section {
            id: "unloader_programme",
            curve: Some(curve("unloader_sway", &s::T_PG, &s::PHI_R, 1)),
            table: programme,
            ..Section::default()
        },
    ])
}

impl<T: Described> Way<'_, T> {
    /// Its row, its path and its sway over time; the sway that is left is the greatest in a period (s) after it.
    fn gone(&self, period: f64) -> Option<Gone> {
        const FOLLOWED: &[&Symbol] = listed!(s: PHI_R, X_L, Y_Q);
        let end = self.course.end() + self.after;
        let run = |told: &Description<T>| {
            let back = self.course.rows.iter().map(|[time, rate]| [*time, -rate]).collect();
            let course = Course {
                rows: back,
                ..self.course.clone()
            };
            let others = told.courses.iter().filter(|(symbol, _)| *symbol != &s::A_T);
            let courses = others.cloned().chain([(&s::A_T, course)]).collect();
            ride(told, courses, FOLLOWED, &[end, end + period])
        };
        let [own, longer] = [run(&self.by[0])?, run(&self.by[1])?];
        let time = |i: usize| end * (i + 1) as f64 / f64::from(INSTANTS);
        let sways = own[0].iter().enumerate().map(|(i, row)| [time(i), row[0]]);
        Some((
            vec![
                f64::from(self.number),
                end,
                most(&own[0]),
                most(&own[1]),
                most(&longer[1]),
            ],
            [own[0].iter().map(|row| [row[1], row[2]]).collect(), sways.collect()],
        ))
    }
}
