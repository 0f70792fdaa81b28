//! Starts without sway beside each other: in closed form and in runs of the model, on other lengths of the ropes; and the closed
//! forms against other ways to the same.

use num_dual::{Dual2, Dual2_64};

use crate::bridge::slung::Slung;
use crate::bridge::stages::Given;
use crate::bridge::suspension::Suspended;
use crate::bridge::swing::length;
use crate::bridge::symbols as s;
use crate::component::description::{Described, Description};
use crate::component::ride::{most, ride};
use crate::component::sheet::{Curve, Section, Table};
use crate::kernel::calc::Calc;
use crate::kernel::course::{Between, Course};
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::closure::Closure;
use crate::parts::four_bar::{Branch, FourBar, Names};
use crate::parts::plane::{self, Point, cross, dot, squared};
use crate::sway::pendulum::Feedback;
use crate::sway::starts::{Start, against_both, left_by_both};

/// Lengths of the ropes over that of the scene, of the tables; of ropes that are longer than thought; pieces of the curves, and
/// steps of a period of the linear oscillator.
const LENGTHS: [f64; 9] = [0.8, 0.85, 0.9, 0.95, 1.0, 1.05, 1.1, 1.15, 1.2];
const LONGER: f64 = 1.1;
const FINE: u32 = 160;
const STEPS: f64 = 2000.0;

/// Number of the start against both frequencies of a load on slings: behind those of the others and of that under feedback.
const AGAINST_BOTH: f64 = 6.0;

const RUN_COLUMNS: [&[&Symbol]; 2] = [
    listed!(s: NUMBER, A_P, T_P, PHI_P, RHO_E, RHO_LL, RHO_G),
    listed!(s: NUMBER, A_P, T_P, PHI_P, PHI_RUN, RHO_E, RHO_RUN, RHO_LL, RHO_G, RHO_G_RUN),
];

const SLUNG_COLUMNS: [&[&Symbol]; 2] = [
    listed!(s: NUMBER, X_11, X_12, X_21, X_22),
    listed!(s: NUMBER, X_11, X_12, X_1R, X_21, X_22, X_2R),
];

/// The load on ropes of a length over that of the scene.
fn on(given: &Given<f64>, part: f64) -> Option<(f64, Suspended<f64>)> {
    let length = part * length(&given.reeved, &given.swaying, &given.hung);
    Some((length, Suspended::new(&given.ropes, &given.gravity, &length).ok()?))
}

/// Speed (m/s) and acceleration (m/s²) of the scene's start.
fn told(given: &Given<f64>) -> [f64; 2] {
    [given.profile.v_c, given.profile.a_c]
}

/// Sway (rad) that a start leaves on these ropes where it is made for a period (s).
fn left(start: Start, given: &Given<f64>, hanging: &Suspended<f64>, period: f64) -> f64 {
    let [rate, _] = start.timed(told(given), period);
    hanging.felt * rate / *given.gravity * start.left(told(given), hanging.frequency, period)
}

/// A row for each start: in closed form, and where it moves in runs, with the period of the four ropes and that of the simple
/// pendulum; and for the plain start under feedback, where the scene has that.
pub(super) fn compared<T: Described>([plain, fed]: [&Description<T>; 2], given: &Given<f64>) -> Option<Table> {
    let (_, hanging) = on(given, 1.0)?;
    let (_, longer) = on(given, LONGER)?;
    let row = |(number, start): (u32, Start)| {
        let [rate, lasts] = start.timed(told(given), hanging.period);
        let greatest =
            hanging.felt * rate / *given.gravity * start.greatest(told(given), hanging.frequency, hanging.period);
        let periods = [hanging.period, hanging.simple_period];
        let [own, simple] = periods.map(|period| left(start, given, &hanging, period));
        let late = left(start, given, &longer, hanging.period);
        let head = [f64::from(number), rate, lasts, greatest];
        if given.swaying.is_none() {
            return Some(head.into_iter().chain([own, late, simple]).collect());
        }
        let run = |period| {
            run(
                plain,
                &s::PHI_R,
                start.course(told(given), period),
                None,
                hanging.period,
            )
        };
        let [[most, rest], [_, other]] = [run(periods[0])?, run(periods[1])?];
        Some(head.into_iter().chain([most, own, rest, late, simple, other]).collect())
    };
    let rows = (1..).zip(Start::ALL).map(row).collect::<Option<Vec<_>>>()?;
    let feedback = given.swaying.and(given.feedback).filter(|feedback| feedback.zeta > 0.0);
    let last = feedback.and_then(|feedback| fed_back(fed, given, rows.len() + 1, feedback, [&hanging, &longer]));
    Some(Table {
        columns: RUN_COLUMNS[usize::from(given.swaying.is_some())].to_vec(),
        rows: rows.into_iter().chain(last).collect(),
    })
}

/// The plain start under feedback, as long as three pulses; on ropes of the scene, and on longer ones.
fn fed_back<T: Described>(
    what: &Description<T>,
    given: &Given<f64>,
    number: usize,
    feedback: Feedback<f64>,
    ropes: [&Suspended<f64>; 2],
) -> Option<Vec<f64>> {
    let [v_c, a_c] = told(given);
    let [_, lasts] = Start::Robust.timed([v_c, a_c], ropes[0].period);
    let course = Course {
        rows: vec![[0.0, a_c], [v_c / a_c, 0.0]],
        between: Between::Steps,
        shaped: None,
    };
    let [most, rest] = run(what, &s::PHI_R, course, Some(lasts), ropes[0].period)?;
    let [[greatest, own], [_, late]] = ropes.map(|hanging| {
        let steady = hanging.felt * a_c / *given.gravity;
        small(hanging.felt * feedback.zeta, hanging, [v_c / a_c, lasts]).map(|part| steady * part)
    });
    Some(vec![
        number as f64,
        a_c,
        lasts,
        greatest,
        most,
        own,
        rest,
        late,
        own,
        rest,
    ])
}

/// Greatest sway of the linear oscillator under feedback, over that which hangs back steadily: while its trolley is accelerated
/// for a time and until another one (s), and in a period after that; by its equation of motion.
fn small(zeta: f64, hanging: &Suspended<f64>, [pulse, lasts]: [f64; 2]) -> [f64; 2] {
    let omega = hanging.frequency;
    let rate = |push: f64, [sway, rate]: [f64; 2]| [rate, -omega * (2.0 * zeta * rate + omega * (sway + push))];
    let plus = |a: [f64; 2], b: [f64; 2], h: f64| [a[0] + h * b[0], a[1] + h * b[1]];
    let mut state = [0.0; 2];
    let mut span = |time: f64, push: f64| {
        let count = (time / hanging.period * STEPS).ceil().max(1.0);
        let h = time / count;
        (0..count as u32).fold(0.0_f64, |most, _| {
            let k = rate(push, state);
            let l = rate(push, plus(state, k, 0.5 * h));
            let m = rate(push, plus(state, l, 0.5 * h));
            let n = rate(push, plus(state, m, h));
            let sum: [f64; 2] = std::array::from_fn(|i| k[i] + 2.0 * (l[i] + m[i]) + n[i]);
            state = plus(state, sum, h / 6.0);
            most.max(state[0].abs())
        })
    };
    let [on, off] = [span(pulse, 1.0), span(lasts - pulse, 0.0)];
    [on.max(off), span(hanging.period, 0.0)]
}

/// Greatest amount of what a load that hangs at rest at the start does, while the trolley is told an acceleration over time, to its
/// end or to a later time (s), and after that in a period (s); `None` of a run that does not come to its end.
fn run<T: Described>(
    what: &Description<T>,
    followed: &'static Symbol,
    course: Course,
    until: Option<f64>,
    period: f64,
) -> Option<[f64; 2]> {
    let end = until.unwrap_or_else(|| course.end());
    let spans = ride(what, vec![(&s::A_T, course)], &[followed], &[end, end + period])?;
    spans.iter().map(|span| most(span)).collect::<Vec<_>>().try_into().ok()
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
                pieces: (0..Start::ALL.len())
                    .map(|i| fine.iter().map(|(length, _, own)| [*length, own[i]]).collect())
                    .collect(),
                numbers: vec![1, 2, 3, 4],
            }),
            table: Some(Table {
                columns: vec![&s::L_R, &s::T_S, &s::RHO_P1, &s::RHO_P2, &s::RHO_P3, &s::RHO_P4],
                rows: rows
                    .map(|(length, period, own)| [&[length, period][..], &own].concat())
                    .collect(),
            }),
            ..Section::default()
        }
    };
    told.map(section).into()
}

/// What starts leave of the travel of a load on slings, at both frequencies: of those made for the period of the one and of the
/// other, and of one made against both; where they move, in runs of the model too.
pub(super) fn slung_starts<T: Described>(plain: &Description<T>, given: &Given<f64>) -> Option<Table> {
    let (_, hanging) = on(given, 1.0)?;
    let it = given;
    let slung = Slung::new(
        it.slings.as_ref()?,
        &it.unit,
        &it.command,
        &it.ropes,
        &it.gravity,
        &hanging,
    )
    .ok()?;
    let run = |course| {
        let [_, rest] = run(plain, &s::X_Q, course, None, slung.period[0])?;
        Some(rest)
    };
    let row = |(number, start): (u32, Start)| {
        let left = |period: f64| {
            let [rate, _] = start.timed(told(given), period);
            let of = |at: usize| {
                slung.steady[at].abs() * rate / *it.gravity * start.left(told(given), slung.frequency[at], period)
            };
            [of(0), of(1)]
        };
        let [own, other] = slung.period.map(left);
        if given.hung.is_none() {
            return Some([&[f64::from(number)][..], &own, &other].concat());
        }
        let [both, last] = slung.period.map(|period| run(start.course(told(given), period)));
        Some([&[f64::from(number)][..], &own, &[both?], &other, &[last?]].concat())
    };
    let rows = (1..).zip(Start::ALL).map(row).chain(std::iter::once_with(|| {
        let told = told(given);
        let [one, other] = [0, 1].map(|at| {
            let steady = slung.steady[at].abs() * told[1] / *given.gravity;
            steady * left_by_both(told, slung.frequency[at], slung.period)
        });
        let ran = given.hung.map(|_| run(against_both(told, slung.period)));
        let ran = ran.map_or(Some(None), |ran| ran.map(Some))?;
        let half: Vec<f64> = [one, other].into_iter().chain(ran).collect();
        Some([&[AGAINST_BOTH][..], &half, &half].concat())
    }));
    Some(Table {
        columns: SLUNG_COLUMNS[usize::from(given.hung.is_some())].to_vec(),
        rows: rows.collect::<Option<_>>()?,
    })
}

/// Steps of the acceleration one by one, as arrows, against the closed form of what starts leave for the simple pendulum's period,
/// over what hangs back steadily.
pub(super) fn steps_apart(given: &Given<f64>) -> Option<f64> {
    let (_, hanging) = on(given, 1.0)?;
    let apart = |start: Start| {
        let period = hanging.simple_period;
        let (course, [rate, _]) = (start.course(told(given), period), start.timed(told(given), period));
        let (mut before, mut sum) = (0.0, Point::new(0.0, 0.0));
        for [time, now] in course.rows {
            let (sin, cos) = Calc::sin_cos(hanging.frequency * time);
            sum += Point::new(cos, sin) * ((now - before) / rate);
            before = now;
        }
        (sum.norm() - start.left(told(given), hanging.frequency, period)).abs()
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
