//! Starts without sway beside each other: in closed form and in runs of the model, on other lengths of the ropes; and the closed
//! forms against other ways to the same.

use num_dual::{Dual2, Dual2_64};

use crate::bridge::profiles::Start;
use crate::bridge::stages::Given;
use crate::bridge::suspension::Suspended;
use crate::bridge::swing::length;
use crate::bridge::symbols as s;
use crate::component::description::{Described, Description};
use crate::component::running::Running;
use crate::component::sheet::{Curve, Section, Table};
use crate::kernel::calc::Calc;
use crate::kernel::course::Course;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::closure::Closure;
use crate::parts::four_bar::{Branch, FourBar, Names};
use crate::parts::plane::{self, Point, cross, dot, squared};

/// Lengths of the ropes over that of the scene, of the tables; pieces of their curves, and instants of a run.
const LENGTHS: [f64; 9] = [0.8, 0.85, 0.9, 0.95, 1.0, 1.05, 1.1, 1.15, 1.2];
const FINE: u32 = 160;
const INSTANTS: u32 = 400;

const RUN_COLUMNS: [&[&Symbol]; 2] = [
    listed!(s: NUMBER, A_P, T_P, PHI_P, RHO_E, RHO_G),
    listed!(s: NUMBER, A_P, T_P, PHI_P, PHI_RUN, RHO_E, RHO_RUN, RHO_G, RHO_G_RUN),
];

/// The load on ropes of a length over that of the scene.
fn on(given: &Given<f64>, part: f64) -> Option<(f64, Suspended<f64>)> {
    let length = part * length(&given.reeved, &given.swaying);
    Some((length, Suspended::new(&given.ropes, &given.gravity, &length).ok()?))
}

/// Sway (rad) that a start leaves on these ropes where it is made for a period (s).
fn left(start: Start, given: &Given<f64>, hanging: &Suspended<f64>, period: f64) -> f64 {
    let [rate, _] = start.timed(&given.profile, period);
    hanging.felt * rate / *given.gravity * start.left(&given.profile, hanging.frequency, period)
}

/// A row for each start: in closed form, and where it moves in runs, with the period of the four ropes and that of the simple
/// pendulum.
pub(super) fn compared<T: Described>(told: &Description<T>, given: &Given<f64>) -> Option<Table> {
    let (_, hanging) = on(given, 1.0)?;
    let row = |(number, start): (u32, Start)| {
        let [rate, lasts] = start.timed(&given.profile, hanging.period);
        let greatest =
            hanging.felt * rate / *given.gravity * start.greatest(&given.profile, hanging.frequency, hanging.period);
        let periods = [hanging.period, hanging.simple_period];
        let [own, simple] = periods.map(|period| left(start, given, &hanging, period));
        let head = [f64::from(number), rate, lasts, greatest];
        if given.swaying.is_none() {
            return Some(head.into_iter().chain([own, simple]).collect());
        }
        let run = |period| run(told, start.course(&given.profile, period), hanging.period);
        let [[most, rest], [_, late]] = [run(periods[0])?, run(periods[1])?];
        Some(head.into_iter().chain([most, own, rest, simple, late]).collect())
    };
    Some(Table {
        columns: RUN_COLUMNS[usize::from(given.swaying.is_some())].to_vec(),
        rows: (1..).zip(Start::ALL).map(row).collect::<Option<_>>()?,
    })
}

/// Greatest sway (rad) of a load that hangs at rest at the start, while the trolley is told an acceleration over time, and after that in a
/// period (s); `None` of a run that does not come to its end.
fn run<T: Described>(told: &Description<T>, course: Course, period: f64) -> Option<[f64; 2]> {
    let mut other = told.clone();
    let end = course.end();
    other.courses = vec![(&s::A_T, course)];
    let mut model = other.moving()?.ok()?;
    let sway = model
        .variables()
        .iter()
        .position(|variable| variable.symbol == &s::PHI_R)?;
    model.start().ok()?;
    let mut span = |from: f64, lasts: f64| {
        (0..INSTANTS).try_fold(0.0_f64, |most, i| {
            let at = |i: u32| from + lasts * f64::from(i) / f64::from(INSTANTS);
            model.advance(at(i), at(i + 1)).ok()?;
            Some(most.max(model.get(sway).ok()?.abs()))
        })
    };
    Some([span(0.0, end)?, span(end, period)?])
}

/// What starts leave on other lengths of the ropes that are made for the scene's: with the period of the four ropes, and with
/// that of the simple pendulum.
pub(super) fn lengths(given: &Given<f64>) -> Vec<Section> {
    let Some((_, known)) = on(given, 1.0) else {
        return Vec::new();
    };
    let told = [
        ("bridge_lengths", known.period, &s::RHO_E),
        ("bridge_simple", known.simple_period, &s::RHO_G),
    ];
    let section = |(id, period, symbol): (&'static str, f64, &'static Symbol)| {
        let row = |part: f64| {
            let (length, hanging) = on(given, part)?;
            let own = Start::ALL.map(|start| left(start, given, &hanging, period));
            Some((length, hanging.period, own))
        };
        let fine: Vec<_> = (0..=FINE)
            .filter_map(|i| row(0.8 + 0.4 * f64::from(i) / f64::from(FINE)))
            .collect();
        let rows = LENGTHS.into_iter().filter_map(row);
        Section {
            id,
            curve: Some(Curve {
                id,
                x: &s::L_R,
                y: symbol,
                pieces: (0..3)
                    .map(|i| fine.iter().map(|(length, _, own)| [*length, own[i]]).collect())
                    .collect(),
                numbers: vec![1, 2, 3],
            }),
            table: Some(Table {
                columns: vec![&s::L_R, &s::T_S, &s::RHO_P1, &s::RHO_P2, &s::RHO_P3],
                rows: rows
                    .map(|(length, period, own)| [&[length, period][..], &own].concat())
                    .collect(),
            }),
            ..Section::default()
        }
    };
    told.map(section).into()
}

/// Steps of the acceleration one by one, as arrows, against the closed form of what starts leave for the simple pendulum's period,
/// over what hangs back steadily.
pub(super) fn steps_apart(given: &Given<f64>) -> Option<f64> {
    let (_, hanging) = on(given, 1.0)?;
    let apart = |start: Start| {
        let period = hanging.simple_period;
        let (course, [rate, _]) = (
            start.course(&given.profile, period),
            start.timed(&given.profile, period),
        );
        let (mut before, mut sum) = (0.0, Point::new(0.0, 0.0));
        for [time, now] in course.rows {
            let (sin, cos) = Calc::sin_cos(hanging.frequency * time);
            sum += Point::new(cos, sin) * ((now - before) / rate);
            before = now;
        }
        (sum.norm() - start.left(&given.profile, hanging.frequency, period)).abs()
    };
    Some(Start::ALL.map(apart).into_iter().fold(0.0, f64::max))
}

/// Nothing of the check's closure is printed.
const UNPRINTED: Names = Names {
    frame: &s::AGREEMENT,
    frame_angle: &s::AGREEMENT,
    stretched: [&s::AGREEMENT; 2],
    folded: [&s::AGREEMENT; 2],
    crank: [&s::AGREEMENT; 2],
    diagonal: [&s::AGREEMENT; 2],
    diagonal_length: &s::AGREEMENT,
    stretched_margin: &s::AGREEMENT,
    folded_margin: &s::AGREEMENT,
    area: &s::AGREEMENT,
    follower: [&s::AGREEMENT; 2],
    coupler: [&s::AGREEMENT; 2],
};

/// The square of the frequency in closed form against that of the four-bar's closure: potential and kinetic energy by its second
/// and first derivatives, relative.
pub(super) fn four_bar(given: &Given<f64>) -> Option<f64> {
    let (_, hanging) = on(given, 1.0)?;
    let ropes = &given.ropes;
    let length = plane::length(Point::new(ropes.a_o - ropes.a_u, hanging.height));
    let (spreader, frame) = (2.0 * ropes.a_u, Point::new(2.0 * ropes.a_o, 0.0));
    let linkage = FourBar::new([length, spreader, length], frame, Branch::Left, &UNPRINTED)?;
    let linkage = linkage.map(Dual2_64::from_re);
    let rest = Calc::direction(ropes.a_o - ropes.a_u, -hanging.height);
    let bars = Closure::new(&linkage, Dual2::new(rest, 1.0, 0.0), &UNPRINTED)?;
    let (half, deep) = (Dual2::from_re(0.5), Dual2::from_re(ropes.e_q / spreader));
    let along = bars.coupler;
    let centre = bars.crank + Point::new(along.x * half, along.y * half) + Point::new(along.y * deep, -along.x * deep);
    let (travel, now, rate) = (centre.map(|x| x.v1), along.map(|x| x.re), along.map(|x| x.v1));
    let turn = cross(now, rate) / squared(now);
    let inertia = dot(travel, travel) + ropes.i_q.square() * turn.square();
    let square = *given.gravity * centre.y.v2 / inertia;
    Some((square / hanging.frequency.square() - 1.0).abs())
}
