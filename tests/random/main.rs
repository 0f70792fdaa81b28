//! Random scenes of every mechanism and level through all that the program makes of them: each gives a result, or is
//! refused with its line and with help; nothing panics, nothing is no number, nothing takes for ever.
//!
//! `LEMNIS_SCENES=100000 cargo test --release --workspace --test random_scenes -- --nocapture` takes more of them and
//! tells what was refused; `LEMNIS_SEED` begins another series, `LEMNIS_SCENE` takes one scene of it and prints it.

mod afloat;
mod bodies;
mod bridge;
mod cases;
mod column;
mod control;
mod curved_trunk;
mod ellipsograph;
mod fmu;
mod hopper;
mod hung;
mod led;
mod luffing;
mod mobile;
mod portal;
mod ring;
mod rope;
mod scene;
mod slewing;
mod steering;
mod unloader;
mod upper;

use std::any::Any;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use lemnis::answer::Answer;
use lemnis::answer::shown::Shown;
use lemnis::book::Edition;
use lemnis::documentation;
use lemnis::language::Language;
use lemnis::results::{Results, lasting};
use lemnis::template::Templates;
use lemnis_fmu::description::{Standard, model_description};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::schema::{KIND, Key, Kind};
use lemnis_models::kernel::text::LANGUAGES;
use lemnis_models::kernel::variable::{Role, Variable};
use lemnis_models::registry::{self, MECHANISMS};
use lemnis_models::scene::Scene;
use lemnis_tests::unpacked::Unpacked;
use lemnis_trade::trade::{SAMPLE, Trade};
use lemnis_typeset::{Embedded, Format};
use toml::{Table, Value};

use crate::fmu::{Instance, Story, tell};
use crate::scene::{Case, Draw};

/// Scenes, unless the environment says otherwise.
const SCENES: u64 = 2000;
/// Of these one is made into a book, and of these one is traded, where time (s) times states is less: a trade is many runs.
const BOOK: u64 = 20;
const TRADE: u64 = 8;
const QUICK: f64 = 20.0;
/// Longest time for one scene.
const LONGEST: Duration = Duration::from_secs(60);
/// Most work for each simulated second over the median of the level.
const MOST_WORK: f64 = 20.0;

/// Longest steps in a natural time that a legal scene asks for at most.
const STEPS: f64 = 250.0;

/// What became of a scene.
#[derive(Default)]
struct Outcome {
    level: String,
    /// Whether everything came out.
    whole: bool,
    /// What was refused, each with what refused it.
    refused: Vec<(&'static str, String)>,
    /// What must not be.
    wrong: Vec<String>,
    /// Evaluations of the right-hand side of each body for a natural time of the machine.
    work: Option<f64>,
}

thread_local! {
    static PANIC: RefCell<String> = const { RefCell::new(String::new()) };
}

fn examine(case: &Case, number: u64) -> Outcome {
    let mut outcome = Outcome::default();
    if catch_unwind(AssertUnwindSafe(|| all(case, number, &mut outcome))).is_err() {
        let told = PANIC.with_borrow_mut(std::mem::take);
        outcome.wrong.push(format!("panic: {told}"));
    }
    outcome
}

/// Whether the scene itself gives the longest step of its solver.
fn asks_for_step(case: &Case) -> bool {
    let mut tables = case.table.values();
    tables.any(|table| {
        table
            .get("dynamics")
            .is_some_and(|dynamics| dynamics.get("step").is_some())
    })
}

/// Right-hand sides that a scene asks for by what it tells over time: between two of its times the motion is solved on a grid of
/// its own, of so many steps at least, by four each.
fn over_time(table: &Table) -> f64 {
    const GRID: f64 = 4.0 * 32.0;
    let of = |value: &Value| match value {
        Value::Table(inner) => match inner.get("over") {
            Some(Value::Array(rows)) => GRID * (rows.len() as f64 - 1.0),
            _ => over_time(inner),
        },
        _ => 0.0,
    };
    table.values().map(of).sum()
}

fn all(case: &Case, number: u64, outcome: &mut Outcome) {
    let text = case.text();
    let scene = match Scene::parse(&text) {
        Ok(scene) => scene,
        Err(found) => {
            for diagnostic in found {
                let message = format!("{diagnostic}");
                // In a scene without a word there is nothing to point at.
                let marked = text.get(diagnostic.span.clone()).unwrap_or_default();
                if diagnostic.help.is_none() || marked.is_empty() && !text.is_empty() {
                    outcome.wrong.push(format!("no help or no line: {message}"));
                }
                read(&message, "message", &mut outcome.wrong);
                outcome.refused.push(("read", message));
            }
            return;
        }
    };
    outcome.level = level(&scene);
    if let Err(diagnostic) = lasting(&scene) {
        let message = format!("{diagnostic}");
        read(&message, "message", &mut outcome.wrong);
        outcome.refused.push(("check", message));
        return;
    }
    let results = match Results::new(&scene) {
        Ok(results) => results,
        Err(fault) => {
            outcome.wrong.push(format!("no line: {}", fault.message));
            outcome.refused.push(("check", fault.message));
            return;
        }
    };
    for (what, text) in [("table", results.table()), ("CSV", results.csv())] {
        read(&text, what, &mut outcome.wrong);
    }
    for summary in results.sheet.governing.iter().chain(&results.sheet.summary) {
        let (symbol, value) = (summary.symbol, summary.value);
        if value.is_nan() || value.is_infinite() && symbol.infinite.is_none() {
            outcome.wrong.push(format!("{} = {value} in the summary", symbol.id));
        }
    }
    // Two independent ways to one result. What is only nearly legal may stand at a dead point, where they lose digits;
    // the energy of a run is found from samples, and the book tells what they leave over: counted.
    for check in &results.sheet.identities {
        if check.symbol.id == "agreement" && !check.passed() {
            let told = format!("{} by {:e}", check.id, check.value);
            if case.legal && check.id != "motion_energy" {
                outcome.wrong.push(told);
            } else {
                outcome.refused.push(("agreement", told));
            }
        }
    }
    let model = scene.model().expect("its results are there");
    outcome.wrong.extend(twice(&model));
    let _ = (Answer::of(&results).json(), results.broken_limits());
    // What depends on what takes as long as all the rest, and is the same in both.
    let standard = [Standard::Fmi2, Standard::Fmi3][number as usize % 2];
    match model_description(&scene, standard).map(String::from_utf8) {
        Ok(Ok(description)) if ["=\"NaN\"", "inf\""].iter().any(|none| description.contains(none)) => {
            outcome.wrong.push("a description with no number".to_owned());
        }
        Ok(Ok(_)) => {}
        other => outcome.wrong.push(format!("no description: {other:?}")),
    }
    let page = documentation::page(&scene, None).unwrap_or_else(|error| panic!("{error}"));
    read(&page, "documentation", &mut outcome.wrong);
    let length = run(case, &scene, number, outcome);
    if number.is_multiple_of(BOOK) {
        let code = LANGUAGES[(number / BOOK) as usize % LANGUAGES.len()];
        Shown::new(&results, Language::find(code).expect("known")).unwrap_or_else(|fault| panic!("{}", fault.message));
        book(&scene, &results, number, outcome);
    }
    if number.is_multiple_of(TRADE)
        && length < QUICK
        && let Err(failure) = Trade::new(&scene, SAMPLE, 0, &|| ())
    {
        let message = failure.to_string();
        read(&message, "message", &mut outcome.wrong);
        outcome.refused.push(("trade", message));
    }
}

/// Variables that have the name of another one.
fn twice(model: &Model) -> Vec<String> {
    let mut known = BTreeSet::new();
    let names = model.variables().iter().map(Variable::name);
    names
        .filter(|name| !known.insert(name.clone()))
        .map(|name| format!("two variables are called {name}"))
        .collect()
}

fn level(scene: &Scene) -> String {
    let level = scene.levels().pop().unwrap_or_default();
    format!("{} {level}", scene.mechanism.id())
}

/// The default experiment, random inputs and none, in the model and in both FMUs: the same values, or none. Returns the
/// experiment's time, in s, times the states.
fn run(case: &Case, scene: &Scene, number: u64, outcome: &mut Outcome) -> f64 {
    let draw = || Draw::of(number, case.scale);
    let mut model = match scene.model() {
        Ok(model) => model,
        Err(fault) => {
            outcome.wrong.push(format!("no model: {}", fault.message));
            return f64::INFINITY;
        }
    };
    // What an importer is told that it may set, it finds set so.
    for (index, variable) in model.clone().variables().iter().enumerate() {
        let given = matches!(variable.role, Role::Input | Role::Parameter | Role::Tunable);
        let start = model.get(index).ok().filter(|_| given);
        outcome.wrong.extend(
            start
                .and_then(|start| variable.check(start).err())
                .map(|fault| fault.message),
        );
    }
    let before = model.clone();
    let own = tell(&mut model, &before, &mut draw());
    let bodies = before
        .variables()
        .iter()
        .filter_map(|variable| variable.number)
        .max()
        .unwrap_or(1);
    for message in own.refused.iter().flatten() {
        read(message, "message", &mut outcome.wrong);
    }
    outcome.whole = own.refused[0].is_empty();
    for (part, what) in [(0, "experiment"), (1, "inputs")] {
        outcome
            .refused
            .extend(own.refused[part].iter().take(3).map(|message| (what, message.clone())));
    }
    if own.taken > 0.0 {
        // Under the gravity that the scene has in the end; where a PLC samples, each cycle begins a motion of its own.
        // What begins costs something, however soon it is over.
        let cycle = before
            .variables()
            .iter()
            .position(|variable| variable.symbol.id == "T_c");
        let natural = match cycle.map(|at| model.get(at)) {
            Some(Ok(cycle)) => cycle,
            _ => (case.scale[0] / scene.gravity).sqrt(),
        };
        // A finer step than any that a legal scene asks for costs what was asked for.
        let asked = scene
            .mechanism
            .solver()
            .filter(|solver| solver.explicit && asks_for_step(case));
        let natural = asked.map_or(natural, |solver| natural.min(STEPS * solver.longest));
        let rates = f64::from(own.rates) - over_time(&case.table);
        outcome.work = Some(rates.max(0.0) / f64::from(bodies) * natural / own.taken.max(natural));
    }
    let fmu = Unpacked::new(scene.text());
    for second in [false, true] {
        let mut instance = match Instance::new(&fmu, second, before.variables()) {
            Ok(instance) => instance,
            Err(message) => {
                outcome.wrong.push(format!("no instance: {message}"));
                continue;
            }
        };
        let story = tell(&mut instance, &before, &mut draw());
        outcome.wrong.append(&mut instance.wrong);
        if let Some(told) = apart(&own, &story, &before) {
            outcome.wrong.push(format!(
                "FMI {} and the model differ: {told}",
                if second { 2 } else { 3 }
            ));
        }
    }
    before.stop_time() * before.states() as f64
}

/// Where two runs differ.
fn apart(one: &Story, other: &Story, model: &Model) -> Option<String> {
    let mut pairs = one.values.iter().zip(&other.values);
    let ((index, a), (_, b)) = pairs.find(|(a, b)| a != b)?;
    let shown = |bits: &Option<u64>| bits.map(f64::from_bits);
    Some(format!("{} {:?} {:?}", model.variables()[*index], shown(a), shown(b)))
}

fn book(scene: &Scene, results: &Results, number: u64, outcome: &mut Outcome) {
    let code = LANGUAGES[(number / BOOK) as usize % LANGUAGES.len()];
    let edition = Edition {
        language: Language::find(code).expect("known"),
        level: "summary",
        templates: &Templates::embedded(),
        typesetter: &Embedded,
    };
    match edition.source(scene, &results.sheet, Format::Pdf) {
        Ok(source) if source.main.contains("NaN") => outcome.wrong.push("NaN in the book".to_owned()),
        Ok(source) if signed_zero(&source.main) => outcome.wrong.push("-0 in the book".to_owned()),
        _ => {}
    }
    if let Err(error) = edition.typeset(scene, &results.sheet, Format::Pdf) {
        outcome.wrong.push(format!("no book: {error}"));
    }
}

/// Numbers as people read them: none that is no number, none with a sign of zero, none with more than 17 digits.
fn read(text: &str, what: &str, wrong: &mut Vec<String>) {
    let number = |c: char| c.is_ascii_alphanumeric() || "+-.".contains(c);
    for word in text.split(|c| !number(c)) {
        let mantissa = word.split(['e', 'E']).next().unwrap_or("");
        let digits = mantissa
            .trim_start_matches(['-', '+', '0', '.'])
            .chars()
            .filter(char::is_ascii_digit)
            .count();
        let zero = word.strip_prefix('-').is_some_and(|rest| {
            rest.starts_with(|c: char| c.is_ascii_digit()) && rest.chars().all(|c| matches!(c, '0' | '.'))
        });
        let plain = !word.is_empty() && word.chars().all(|c| c.is_ascii_digit() || "+-.eE".contains(c));
        if word == "NaN" || word == "undefined" && what != "message" || zero || plain && digits > 17 {
            let kind = if plain && digits > 17 { "a long number" } else { word };
            wrong.push(format!("{kind} in {what}"));
            return;
        }
    }
}

/// Whether a text has a zero with a sign, typeset or not.
fn signed_zero(text: &str) -> bool {
    let after = |(at, sign): (usize, &str)| text[at + sign.len()..].strip_prefix('0');
    let mut zeros = text.match_indices(['-', '\u{2212}']).filter_map(after);
    zeros.any(|rest| !rest.starts_with(|c: char| c.is_ascii_digit() || ".,".contains(c)))
}

/// A message without its numbers, and without the names that stand in `` ` ``.
fn kind(message: &str) -> String {
    let mut kind = String::new();
    for word in message.split_inclusive([' ', ',', ';', '(', ')', ':', '"', '[', ']']) {
        let digits = word.starts_with(|c: char| c.is_ascii_digit() || "-+".contains(c))
            && word.contains(|c: char| c.is_ascii_digit());
        kind += if digits || word.starts_with("inf") || word.starts_with("NaN") {
            "# "
        } else {
            word
        };
    }
    kind.chars().take(180).collect()
}

/// The scene with one key less, or with a simpler number, all that there are.
fn simpler(table: &Table) -> Vec<Table> {
    let mut found = Vec::new();
    for (name, value) in table {
        let mut without = table.clone();
        without.remove(name);
        found.push(without);
        let others: Vec<Value> = match value {
            Value::Table(inner) => simpler(inner).into_iter().map(Value::Table).collect(),
            Value::Array(list) => (0..list.len())
                .map(|i| Value::Array([&list[..i], &list[i + 1..]].concat()))
                .collect(),
            Value::String(text) => match text
                .split_once(' ')
                .and_then(|(n, unit)| Some((n.parse::<f64>().ok()?, unit)))
            {
                Some((number, unit)) => {
                    let short = format!("{number:.0e}").parse::<f64>().unwrap_or(number);
                    let numbers = [0.0, 1.0, short].into_iter().filter(|other| *other != number);
                    numbers
                        .map(|number| Value::String(format!("{number} {unit}")))
                        .collect()
                }
                None => Vec::new(),
            },
            _ => Vec::new(),
        };
        for other in others {
            let mut changed = table.clone();
            changed.insert(name.clone(), other);
            found.push(changed);
        }
    }
    found
}

/// The simplest scene found with the same thing wrong, in bounded time.
fn shrunk(case: &Case, number: u64, wrong: &str) -> Case {
    let started = Instant::now();
    let mut best = case.clone();
    let same = |case: &Case| {
        verdicts(case, &examine(case, number))
            .iter()
            .any(|other| kind(other) == wrong)
    };
    loop {
        let smaller = simpler(&best.table)
            .into_iter()
            .map(|table| Case { table, ..best.clone() });
        let mut tried = smaller.take_while(|_| started.elapsed() < Duration::from_secs(10));
        match tried.find(|case| case.text().len() < best.text().len() && same(case)) {
            Some(case) => best = case,
            None => return best,
        }
    }
}

/// What is wrong with a scene's outcome; a legal one must be taken.
fn verdicts(case: &Case, outcome: &Outcome) -> Vec<String> {
    let refused = outcome
        .refused
        .iter()
        .filter(|(by, _)| case.legal && matches!(*by, "read" | "check"));
    let refused = refused.map(|(_, message)| format!("a legal scene is refused: {message}"));
    outcome.wrong.iter().cloned().chain(refused).collect()
}

fn number(name: &str) -> Option<u64> {
    let text = std::env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name} is a whole number")))
}

fn told(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("")
}

/// Every level of a mechanism, and every kind of its parts, that keys offer; or, with a scene, that it has.
fn kinds(mechanism: &str, keys: &'static [Key], scene: Option<(&Table, &Table)>, found: &mut BTreeSet<String>) {
    for key in keys {
        // Parts stand within the mechanism or beside it.
        let part = registry::PARTS.iter().any(|part| part.name == key.name);
        let given = scene.map(|(table, top)| table.get(key.name).or_else(|| top.get(key.name).filter(|_| part)));
        match (&key.kind, given) {
            (_, Some(None)) => {}
            (Kind::Choice(choices), None) if key.name == "fidelity" => {
                found.extend(choices.iter().map(|choice| format!("{mechanism} {choice}")));
            }
            (Kind::Choice(choices), None) if key.name == KIND => {
                found.extend(choices.iter().map(|choice| format!("a kind of {mechanism}: {choice}")));
            }
            (Kind::Choice(_), Some(Some(Value::String(choice)))) if key.name == "fidelity" => {
                found.insert(format!("{mechanism} {choice}"));
            }
            (Kind::Choice(_), Some(Some(Value::String(choice)))) if key.name == KIND => {
                found.insert(format!("a kind of {mechanism}: {choice}"));
            }
            (Kind::Table(inner), None) => kinds(key.name, inner, None, found),
            (Kind::Table(inner), Some(Some(Value::Table(table)))) => {
                kinds(key.name, inner, scene.map(|(_, top)| (table, top)), found);
            }
            _ => {}
        }
    }
}

/// What of every mechanism, level and kind no legal scene has given results of.
fn missing<'a>(whole: impl Iterator<Item = &'a Case>) -> Vec<String> {
    let (mut all, mut seen) = (BTreeSet::new(), BTreeSet::new());
    for entry in MECHANISMS {
        all.insert(entry.kind.to_owned());
        kinds(entry.kind, entry.keys, None, &mut all);
    }
    for case in whole {
        for entry in MECHANISMS {
            let of_one = MECHANISMS.iter().filter(|other| other.table == entry.table).count() == 1;
            let made = case.table.get(entry.table).and_then(Value::as_table);
            let Some(made) = made.filter(|made| of_one || made.get(KIND).and_then(Value::as_str) == Some(entry.kind))
            else {
                continue;
            };
            // Slewing is a part of a crane where there is one.
            if entry.table == "slewing" && case.table.contains_key("luffing") {
                continue;
            }
            seen.insert(entry.kind.to_owned());
            kinds(entry.kind, entry.keys, Some((made, &case.table)), &mut seen);
        }
    }
    all.difference(&seen).cloned().collect()
}

#[test]
#[expect(clippy::too_many_lines, reason = "one case after the other")]
fn random_scenes() {
    let seed = number("LEMNIS_SEED").unwrap_or(1);
    let only = number("LEMNIS_SCENE");
    let (first, last) = only.map_or((0, number("LEMNIS_SCENES").unwrap_or(SCENES)), |one| (one, one + 1));
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(ToString::to_string).unwrap_or_default();
        PANIC.set(format!("{place}: {}", told(panic.payload())));
    }));
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let next = AtomicU64::new(first);
    let done = Mutex::new(Vec::new());
    let running = Mutex::new(BTreeMap::new());
    let started = Instant::now();
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads)
            .map(|_| {
                scope.spawn(|| {
                    loop {
                        let number = next.fetch_add(1, Ordering::Relaxed);
                        if number >= last {
                            return;
                        }
                        let begun = Instant::now();
                        running.lock().expect("no panic").insert(number, begun);
                        let case = Case::new(seed, number);
                        if only.is_some() {
                            println!("{}", case.text());
                        }
                        let outcome = examine(&case, number);
                        running.lock().expect("no panic").remove(&number);
                        done.lock()
                            .expect("no panic")
                            .push((number, case, outcome, begun.elapsed()));
                    }
                })
            })
            .collect();
        // What hangs does not come back: its number is all that is known.
        while workers.iter().any(|worker| !worker.is_finished()) {
            std::thread::sleep(Duration::from_millis(20));
            let late = running
                .lock()
                .expect("no panic")
                .iter()
                .find(|(_, begun)| begun.elapsed() > LONGEST)
                .map(|(n, _)| *n);
            if let Some(number) = late {
                eprintln!(
                    "LEMNIS_SEED={seed} LEMNIS_SCENE={number} hangs:\n{}",
                    Case::new(seed, number).text()
                );
                std::process::abort();
            }
        }
    });
    let took = started.elapsed();
    let mut done = done.into_inner().expect("no panic");
    done.sort_by_key(|(number, ..)| *number);

    let mut messages: BTreeMap<(&str, String), (u32, String)> = BTreeMap::new();
    for (_, _, outcome, _) in &done {
        for (by, message) in &outcome.refused {
            let entry = messages.entry((*by, kind(message))).or_insert((0, message.clone()));
            entry.0 += 1;
        }
    }
    let mut messages: Vec<_> = messages.into_iter().collect();
    messages.sort_by_key(|(_, (count, _))| std::cmp::Reverse(*count));
    for ((by, _), (count, example)) in &messages {
        println!("{count:>6} {by:<10} {}", example.chars().take(200).collect::<String>());
    }
    let legal = done.iter().filter(|(_, case, ..)| case.legal).count();
    let whole = done
        .iter()
        .filter(|(_, case, outcome, _)| case.legal && outcome.whole)
        .count();
    let other = done
        .iter()
        .filter(|(_, case, outcome, _)| !case.legal && outcome.whole)
        .count();
    println!(
        "seed {seed}: {} scenes in {:.1} s; {legal} legal, {whole} of them with all results; {} nearly legal, {other}; {} \
         kinds of refusal",
        done.len(),
        took.as_secs_f64(),
        done.len() - legal,
        messages.len()
    );

    let mut wrong: BTreeMap<String, Vec<(u64, &Case, String)>> = BTreeMap::new();
    let mut levels: BTreeMap<&str, Vec<(f64, u64, &Case)>> = BTreeMap::new();
    for (number, case, outcome, _) in &done {
        for verdict in verdicts(case, outcome) {
            wrong.entry(kind(&verdict)).or_default().push((*number, case, verdict));
        }
        if let Some(work) = outcome.work.filter(|work| *work > 0.0) {
            levels.entry(&outcome.level).or_default().push((work, *number, case));
        }
    }
    for (level, works) in &mut levels {
        works.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (median, most) = (works[works.len() / 2].0, works[works.len() - 1].0);
        println!(
            "{level}: {} runs, {median:.0} right-hand sides for a natural time, at most {most:.0}",
            works.len()
        );
        for (work, number, case) in works.iter().filter(|(work, ..)| *work > MOST_WORK * median) {
            let verdict = format!("{level}: {:.0} times the work of the median", work / median);
            wrong
                .entry(format!("{level}: too much work"))
                .or_default()
                .push((*number, *case, verdict));
        }
    }
    let mut slow: Vec<_> = done.iter().map(|(number, .., took)| (*took, *number)).collect();
    slow.sort();
    for (took, number) in slow.iter().rev().take(5) {
        println!("slow: {number} {:.1} s", took.as_secs_f64());
    }
    let mut wrong: Vec<_> = wrong.into_iter().collect();
    wrong.sort_by_key(|(_, all)| std::cmp::Reverse(all.len()));
    for (kind, all) in &wrong {
        let (number, case, verdict) = &all[0];
        let numbers: Vec<String> = all.iter().map(|(number, ..)| number.to_string()).collect();
        let legal = all.iter().filter(|(_, case, _)| case.legal).count();
        println!("\n{} times, {legal} legal: {verdict}", all.len());
        println!(
            "LEMNIS_SEED={seed} LEMNIS_SCENE={}",
            numbers[..numbers.len().min(8)].join(" ")
        );
        println!("{}", shrunk(case, *number, kind).text());
    }
    assert!(
        wrong.is_empty(),
        "{} kinds of mistakes in {} scenes",
        wrong.len(),
        done.len()
    );
    assert!(
        only.is_some() || 10 * whole >= 6 * legal,
        "{whole} of {legal} legal scenes give all results"
    );
    let results = done.iter().filter(|(_, case, outcome, _)| case.legal && outcome.whole);
    let missing = missing(results.map(|(_, case, ..)| case));
    println!("no legal scene gives results of: {}", missing.join(", "));
    assert!(
        (done.len() as u64) < SCENES || missing.is_empty(),
        "no legal scene gives results of {}",
        missing.join(", ")
    );
}
