//! References that two codes agree on, errors of every setting, the front of
//! what is worth its price, and the choice.

use std::fmt;

use lemnis_models::kernel::number::{Digits, Number, exact, short};
use lemnis_models::kernel::variable::{Fault, Role, Type, Variable};
use lemnis_models::parts::solver::Count;
use lemnis_models::scene::Scene;

use crate::compared::{AGREEMENT, Asked, Size, all_keep, distance};
use crate::experiment::{Experiment, Seen};
use crate::library::Library;
use crate::parts::{Part, left_out, parts};
use crate::setting::{Setting, index};
use crate::timed::Timed;

/// Communication step where nothing else is asked for, in s.
pub const SAMPLE: f64 = 0.1;

/// How far one result of a setting is off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Against the solution of its own level.
    pub numerical: Size,
    /// Of its level's solution against the deepest level's.
    pub modelling: Size,
    /// Against the deepest level's solution.
    pub total: Size,
}

/// A level's solution by two codes.
#[derive(Clone, Debug)]
pub struct Reference {
    pub level: &'static str,
    /// Where the two codes are farthest apart, over what each result changes: result, both values, part of its range.
    pub apart: Option<Apart>,
    seen: Seen,
}

/// Two codes at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Apart {
    pub result: String,
    /// In s.
    pub time: f64,
    /// Ours and the library's, in SI.
    pub values: [f64; 2],
    pub part: f64,
}

/// A setting with its price and its errors.
#[derive(Clone, Debug)]
pub struct Row {
    pub setting: Setting,
    /// Seconds of the clock for each simulated second, the median of several rounds; `None` without a clock.
    pub seconds: Option<f64>,
    /// The same by counted work.
    pub cost: f64,
    /// Work of the whole motion.
    pub work: Count,
    /// Size of a saved state.
    pub bytes: usize,
    /// One for each result asked for; `None` where the level has none.
    pub errors: Vec<Option<Errors>>,
    /// The level cannot take the command that moves the scene and follows the deepest level's motion: its errors are
    /// shown, but it is no substitute.
    pub follows: bool,
    /// A tenth more accurate than every cheaper setting.
    pub front: bool,
    /// Whether every result asked for is as accurate as it must be; `None` where nothing is asked.
    pub holds: Option<bool>,
}

/// A result that is less accurate than it must be.
#[derive(Clone, Debug, PartialEq)]
pub struct Missed {
    pub result: usize,
    /// How far it is off at the most accurate setting; infinite where no level has it.
    pub off: f64,
}

/// Speed against accuracy of one scene.
#[derive(Clone, Debug)]
pub struct Trade {
    pub asked: Vec<Asked>,
    /// Communication step and duration of the motion, in s.
    pub sample: f64,
    pub duration: f64,
    /// The command of the scene's own that moves it; `None` for the luffing cycle.
    pub command: Option<&'static str>,
    pub references: Vec<Reference>,
    /// From cheap to dear.
    pub rows: Vec<Row>,
    /// Settings at which the solver refuses the motion, and why.
    pub refused: Vec<(Setting, Fault)>,
    /// Place of the row at whose setting the parts are left out.
    pub whole: usize,
    pub parts: Vec<Part>,
}

/// Why there is no trade.
#[derive(Clone, Debug)]
pub enum Failure {
    Refused(Fault),
    /// The two codes do not agree on a level.
    Apart(&'static str, Apart, &'static lemnis_models::kernel::symbol::Symbol),
}

impl From<Fault> for Failure {
    fn from(fault: Fault) -> Failure {
        Failure::Refused(fault)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Refused(fault) => f.write_str(&fault.message),
            Failure::Apart(level, apart, symbol) => {
                let Apart {
                    result,
                    time,
                    values: [ours, theirs],
                    part,
                } = apart;
                write!(
                    f,
                    "no reference at level {level}: {result} at {} s is {} {unit} by our solver and {} {unit} by the \
                     library's, {} of its range apart and {} is allowed; a motion without blows and resonance, or a \
                     smaller --step, may do",
                    short(*time),
                    exact(symbol.shown(*ours)),
                    exact(symbol.shown(*theirs)),
                    Number::new(*part, Digits::Significant(2)),
                    short(AGREEMENT),
                    unit = symbol.display.name
                )
            }
        }
    }
}

impl Trade {
    /// Runs all settings of a scene with communication steps of `sample` s, each `rounds` times by the clock (none: without
    /// a clock), and calls `done` at each one.
    ///
    /// # Errors
    /// See [`Failure`].
    pub fn new(scene: &Scene, sample: f64, rounds: usize, done: &dyn Fn()) -> Result<Trade, Failure> {
        let levels = scene.levels();
        let deepest = levels.last().copied().unwrap_or("static");
        let mut experiment = Experiment::new(&scene.at(deepest), sample)?;
        let mut asked = asked(scene, deepest)?;
        let left_out = left_out(scene, deepest, &asked);
        let mut names: Vec<String> = asked.iter().map(|asked| asked.name.clone()).collect();
        // What moves is followed by the levels where it is an input.
        let model = scene.at(deepest).model()?;
        names.extend(model.variables()[..2].iter().map(Variable::name));
        let mut references = Vec::new();
        for level in levels.iter().rev().copied() {
            // A command may lead beyond the working range, which a table does not have.
            if level == "table" && experiment.own_command().is_some() {
                continue;
            }
            let reference = reference(scene, &experiment, level, &names)?;
            if let Some(apart) = reference
                .apart
                .as_ref()
                .filter(|apart| apart.part.is_nan() || apart.part > AGREEMENT)
            {
                let variable = model.variables().iter().find(|v| v.name() == apart.result);
                let symbol = variable.unwrap_or(&model.variables()[0]).symbol;
                return Err(Failure::Apart(level, apart.clone(), symbol));
            }
            if references.is_empty() {
                let [.., angles, rates] = reference.seen.series.as_slice() else {
                    unreachable!("two names were added above");
                };
                experiment.follow(angles, rates);
            }
            references.push(reference);
            done();
        }
        let truth = references[0].seen.clone();
        for (asked, series) in asked.iter_mut().zip(&truth.series) {
            asked.range = covered(series);
        }
        let (mut rows, mut refused) = (Vec::new(), Vec::new());
        for reference in &references {
            let before = rows.len();
            for setting in Setting::all(scene, reference.level, sample) {
                match row(scene, &experiment, setting, &names, &asked, reference, &truth, rounds) {
                    Ok(row) => rows.push(row),
                    Err(fault) => refused.push((setting, fault)),
                }
                done();
            }
            if rows.len() == before {
                let last = refused.pop().expect("every level has a setting");
                return Err(Failure::Refused(last.1));
            }
        }
        rows.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        mark_front(&mut rows, &asked);
        references.reverse();
        let whole = whole(&rows, deepest, &asked);
        let parts = parts(left_out, &experiment, &rows[whole].setting, &asked, &truth, rounds);
        done();
        Ok(Trade {
            whole,
            parts,
            asked,
            sample,
            duration: experiment.duration(),
            command: experiment.own_command(),
            references,
            rows,
            refused,
        })
    }

    /// How often [`new`](Trade::new) calls back.
    #[must_use]
    pub fn steps(scene: &Scene, sample: f64) -> usize {
        let of = |level: &&'static str| 1 + Setting::all(scene, level, sample).len();
        1 + scene.levels().iter().map(of).sum::<usize>()
    }

    /// The cheapest setting, by counted work, at which every result is as accurate as the scene asks.
    #[must_use]
    pub fn choice(&self) -> Option<&Row> {
        self.rows.iter().find(|row| row.holds == Some(true))
    }

    /// What the most accurate setting misses: that with the least of its worst errors over what is allowed.
    #[must_use]
    pub fn missed(&self) -> Option<(&Row, Vec<Missed>)> {
        let worst = |row: &Row| {
            let part = |(asked, errors): (&Asked, &Option<Errors>)| {
                asked
                    .allowed
                    .map(|allowed| errors.map_or(f64::INFINITY, |e| e.total.max / allowed))
            };
            self.asked.iter().zip(&row.errors).filter_map(part).fold(0.0, f64::max)
        };
        let rows = self.rows.iter().filter(|row| !row.follows);
        let best = rows.min_by(|a, b| worst(a).total_cmp(&worst(b)))?;
        let missed = self.asked.iter().zip(&best.errors).enumerate();
        let missed = missed.filter_map(|(result, (asked, errors))| {
            let off = asked.counted(errors.map_or(f64::INFINITY, |e| e.total.max));
            asked
                .allowed
                .filter(|allowed| off > *allowed)
                .map(|_| Missed { result, off })
        });
        Some((best, missed.collect()))
    }
}

/// What is compared: what the scene's accuracy names, otherwise the coordinate and what the first connection of the
/// mechanism tells, and what moves by itself where a cheaper level computes it.
fn asked(scene: &Scene, deepest: &str) -> Result<Vec<Asked>, Fault> {
    let model = scene.at(deepest).model()?;
    let of = |variable: Variable, allowed| Asked {
        name: variable.name(),
        variable,
        allowed,
        range: 0.0,
    };
    if !scene.accuracy.is_empty() {
        let asked = scene.accuracy.iter();
        return Ok(asked.map(|(variable, allowed)| of(*variable, Some(*allowed))).collect());
    }
    let members: Vec<String> = model
        .terminals()
        .into_iter()
        .take(1)
        .flat_map(|terminal| terminal.members)
        .map(|(name, _)| name)
        .collect();
    let closed = scene.at("static").model()?;
    let given = |variable: &Variable| {
        let same = |v: &Variable| v.role == Role::Output && v.symbol == variable.symbol && v.number == variable.number;
        variable.role == Role::State && closed.variables().iter().any(same)
    };
    let variables = model.variables().iter().enumerate();
    let compared = variables.filter(|(i, variable)| {
        let result = variable.role == Role::Output && members.contains(&variable.name());
        variable.kind == Type::Real && (*i == 0 || result || given(variable))
    });
    Ok(compared.map(|(_, variable)| of(*variable, None)).collect())
}

/// A level's solution by both codes.
fn reference(
    scene: &Scene,
    experiment: &Experiment,
    level: &'static str,
    names: &[String],
) -> Result<Reference, Failure> {
    let setting = Setting::fine(scene, level);
    let mut model = setting.model(scene, experiment.sample)?;
    let solved = model.states() > 0;
    let seen = experiment.run(scene, &mut model, names, &mut |model, from, to| model.advance(from, to))?;
    let mut apart: Option<Apart> = None;
    if solved {
        let mut model = setting.model(scene, experiment.sample)?;
        let mut library = Library::new(&model, setting.method, experiment.duration());
        let second = experiment.run(scene, &mut model, names, &mut |model, from, to| {
            library.advance(model, setting.method, from, to)
        })?;
        for ((name, ours), theirs) in names.iter().zip(&seen.series).zip(&second.series) {
            let range = covered(ours).max(f64::MIN_POSITIVE);
            for (i, (a, b)) in ours.iter().zip(theirs).enumerate() {
                let part = (a - b).abs() / range;
                if apart.as_ref().is_none_or(|apart| part > apart.part || part.is_nan()) {
                    apart = Some(Apart {
                        result: name.clone(),
                        time: i as f64 * experiment.sample,
                        values: [*a, *b],
                        part: if a == b { 0.0 } else { part },
                    });
                }
            }
        }
    }
    Ok(Reference { level, apart, seen })
}

#[expect(
    clippy::too_many_arguments,
    reason = "one call; a struct would only repeat the names"
)]
fn row(
    scene: &Scene,
    experiment: &Experiment,
    setting: Setting,
    names: &[String],
    asked: &[Asked],
    reference: &Reference,
    truth: &Seen,
    rounds: usize,
) -> Result<Row, Fault> {
    let timed = Timed::new(scene, experiment, &setting, names, (asked.len(), rounds))?;
    let seen = &timed.seen;
    let errors: Vec<Option<Errors>> = (0..asked.len())
        .map(|i| {
            let (own, level, deepest) = (&seen.series[i], &reference.seen.series[i], &truth.series[i]);
            (!own.is_empty()).then(|| Errors {
                numerical: distance(own, level),
                modelling: distance(level, deepest),
                total: distance(own, deepest),
            })
        })
        .collect();
    let off = |errors: &Option<Errors>| errors.map_or(f64::INFINITY, |e| e.total.max);
    let holds = all_keep(asked, errors.iter().map(off));
    let follows = experiment.own_command();
    let follows = follows.is_some_and(|id| index(&timed.model, id).is_none());
    Ok(Row {
        setting,
        seconds: timed.seconds,
        cost: timed.cost,
        work: timed.work,
        bytes: timed.bytes,
        errors,
        follows,
        front: false,
        holds: holds.map(|holds| holds && !follows),
    })
}

/// The worst error of a setting over what is allowed, or over the result's range; infinite where one is not modelled.
#[must_use]
pub fn relative(row: &Row, asked: &[Asked]) -> f64 {
    let part = |(asked, errors): (&Asked, &Option<Errors>)| {
        let over = asked.allowed.unwrap_or(asked.range);
        match errors {
            None => f64::INFINITY,
            Some(errors) if errors.total.max == 0.0 => 0.0,
            Some(errors) => errors.total.max / over,
        }
    };
    asked.iter().zip(&row.errors).map(part).fold(0.0, f64::max)
}

/// Numerical error, as a part of a result's range, that does not hide what a part gives.
const SMALL: f64 = 1e-3;

/// Of the deepest level the cheapest row whose own solution is good enough to leave parts out of it, or its dearest.
fn whole(rows: &[Row], deepest: &str, asked: &[Asked]) -> usize {
    let good = |row: &Row| {
        let mut errors = asked.iter().zip(&row.errors);
        errors.all(|(asked, errors)| errors.is_some_and(|errors| errors.numerical.max <= SMALL * asked.range))
    };
    let own = |(_, row): &(usize, &Row)| row.setting.level == deepest;
    let mut of_level = rows.iter().enumerate().filter(own);
    let found = of_level.clone().find(|(_, row)| good(row)).or(of_level.next_back());
    found.expect("every level has a setting that runs").0
}

/// What a dearer setting must be more accurate by to be worth its price.
const WORTH: f64 = 0.9;

/// Rows come from cheap to dear.
fn mark_front(rows: &mut [Row], asked: &[Asked]) {
    let mut best = f64::INFINITY;
    for row in rows.iter_mut().filter(|row| !row.follows) {
        let off = relative(row, asked);
        row.front = off < WORTH * best;
        if row.front {
            best = off;
        }
    }
}

/// A part of what never changes that is still a change: rounding is less.
const STILL: f64 = 1e-9;

/// How much a series changes; of one that stands still that part of its amount.
fn covered(series: &[f64]) -> f64 {
    let least = series.iter().copied().fold(f64::INFINITY, f64::min);
    let most = series.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    (most - least).max(STILL * most.abs().max(least.abs()))
}
