//! `lemnis synth`: a lever counterweight for a scene, or quantities of its own, as a scene.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::balance::task::{CandidateRole, Task};
use lemnis_models::kernel::allowed::OutOfRange;
use lemnis_models::kernel::diagnostic::Diagnostic;
use lemnis_models::kernel::number::{Digits, Number, short};
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::reading::LONGEST_NAME;
use lemnis_models::registry::ASK_FOR_SEARCH;
use lemnis_models::request::Goal;
use lemnis_models::scene::Scene;
use lemnis_synthesis::comparison::{Compared, Comparison};
use lemnis_synthesis::run::{Outcome, decimals, run, steps};
use toml_edit::{ArrayOfTables, InlineTable, Item, Table, value};

use crate::commands::asked;
use crate::commands::watched::{SEARCHING, watched};
use crate::failure::Failure;
use crate::output::{Output, say, write};
use crate::scene_file;

#[derive(Args)]
pub struct Synth {
    /// Scene file with a table [synthesis] or [luffing.synthesis], - for the standard input
    scene: PathBuf,
    /// Folder for the result
    #[arg(short, long, default_value = "out")]
    output: PathBuf,
    /// Seed of the search [default: the scene's, otherwise 1]
    #[arg(long, value_parser = clap::value_parser!(u64).range(..=i64::MAX as u64))]
    seed: Option<u64>,
}

impl Synth {
    pub fn run(&self) -> Result<(), Failure> {
        let scene = scene_file::read(Some(&self.scene))?;
        if let Some(asked) = &scene.request {
            let seed = self.seed.unwrap_or(asked.seed);
            let searched = asked::found(&scene, asked, seed, &scene_file::name(Some(&self.scene)))?;
            let fitted = matches!(asked.goal, Goal::Published);
            let found = scene_file::changed(&searched.scene, "the scene with what was found", |document| {
                document["name"] = value(suffixed(scene.name()));
                let task = &mut document["synthesis"];
                task["seed"] = number(seed);
                // A search from where one has ended is compared with what was before that.
                if asked.varied.iter().any(|varied| varied.before.is_none()) {
                    let values = asked
                        .varied
                        .iter()
                        .map(|varied| (&varied.key, varied.written(varied.value)));
                    task["before"] = value(values.collect::<InlineTable>());
                }
                match &searched.front {
                    Some(front) => task["front"] = Item::Table(texts(&front.along)),
                    None => drop(task.as_table_like_mut().and_then(|task| task.remove("front"))),
                }
                // What was published was so of other dimensions.
                if let Some(mechanism) = document[scene.table].as_table_like_mut().filter(|_| !fitted) {
                    mechanism.remove("published");
                }
            })?;
            return self.write(&found, searched.front.map(|front| front.file));
        }
        let Some(search) = scene.search() else {
            return Err(Failure::Scene(format!(
                "{} asks for no synthesis: {ASK_FOR_SEARCH}; or [synthesis] for other quantities",
                scene_file::name(Some(&self.scene))
            )));
        };
        let mut task = search.task.clone();
        task.seed = self.seed.unwrap_or(task.seed);
        let outcome = watched(SEARCHING, steps(&task), |threads, watch| {
            run(&search.boom, search.range, &task, threads, watch)
        });
        let outcome = outcome.map_err(|fault| self.explain(&scene, &task, &fault))?;
        let result = improved(&scene, search.own.as_ref(), &task, &outcome)?;
        let comparison = Comparison::new(&result).expect("the result has a synthesis");
        say(table(&comparison).trim_end())?;
        if let Some(residual) = outcome.residual {
            say(asked::residual(residual))?;
        }
        if !outcome.complete {
            say(asked::BROKEN_OFF)?;
        }
        self.write(&result, None)
    }

    /// The scene, and with it a file of the same name with another end.
    fn write(&self, result: &Scene, beside: Option<(&str, String)>) -> Result<(), Failure> {
        let mut outputs = vec![Output {
            name: format!("{}.toml", result.name()),
            bytes: result.text().into(),
        }];
        outputs.extend(beside.map(|(end, text)| Output {
            name: format!("{}_{end}", result.name()),
            bytes: text.into_bytes(),
        }));
        write(&self.output, &outputs)?;
        let path = self.output.join(format!("{}.toml", result.name()));
        say(format_args!("  build it with `lemnis build {}`", path.display()))
    }

    /// The fault where the scene gives what it blames.
    fn explain(&self, scene: &Scene, task: &Task, fault: &OutOfRange) -> Failure {
        let label = format!("{} is not possible", fault.quantity.id);
        let diagnostic = Diagnostic::new(task.place(fault.quantity), fault.what.clone(), label).help(fault.range());
        scene_file::failure(&scene_file::name(Some(&self.scene)), scene.text(), &[diagnostic])
    }
}

/// The user's scene with the lever found, and with what the book compares.
fn improved(scene: &Scene, own: Option<&Lever<f64>>, task: &Task, outcome: &Outcome) -> Result<Scene, Failure> {
    scene_file::changed(scene, "the scene with the lever found", |document| {
        document["name"] = value(suffixed(scene.name()));
        let mechanism = &mut document[scene.table];
        let mut balance = taken(&mut mechanism["balance"]);
        if own.is_none() {
            balance.clear();
        }
        // What was published was so of another lever.
        balance.remove("published");
        set(&mut balance, "kind", "lever".into());
        fill(&mut balance, &outcome.dimensions, outcome.branch);
        let source = format!("lemnis synth {}, seed {}", env!("CARGO_PKG_VERSION"), task.seed);
        set(&mut balance, "source", source);
        mechanism["balance"] = Item::Table(balance);

        let mut synthesis = taken(&mut mechanism["synthesis"]);
        let found = if outcome.complete { "complete" } else { "broken off" };
        set(&mut synthesis, "found", found.into());
        synthesis["seed"] = number(task.seed);
        let listed = synthesis.remove("candidates");
        let listed = listed.and_then(|listed| listed.into_array_of_tables().ok());
        let mut candidates: ArrayOfTables = listed.unwrap_or_default();
        let fronts = [CandidateRole::RodForce, CandidateRole::Counterweight].map(CandidateRole::name);
        candidates.retain(|table| !table["role"].as_str().is_some_and(|role| fronts.contains(&role)));
        if let Some(own) = own.filter(|_| task.found.is_none()) {
            candidates.push(lever(CandidateRole::Existing, &own.dimensions, own.branch));
        }
        for (role, dimensions) in &outcome.fronts {
            candidates.push(lever(*role, dimensions, outcome.branch));
        }
        synthesis["candidates"] = Item::ArrayOfTables(candidates);
        mechanism["synthesis"] = Item::Table(synthesis);
    })
}

/// Keys with their texts.
fn texts(all: &[(String, String)]) -> Table {
    let mut table = Table::new();
    for (key, text) in all {
        table[key] = value(text);
    }
    table
}

const SUFFIX: &str = "_synth";

/// The name of what comes of a scene.
fn suffixed(name: &str) -> String {
    let name = name.strip_suffix(SUFFIX).unwrap_or(name);
    let name = &name[..name.len().min(LONGEST_NAME - SUFFIX.len())];
    format!("{name}{SUFFIX}")
}

fn number(seed: u64) -> Item {
    value(i64::try_from(seed).expect("TOML has no greater integers"))
}

fn lever(role: CandidateRole, d: &Dimensions<f64>, branch: Branch) -> Table {
    let mut table = Table::new();
    set(&mut table, "role", role.name().into());
    fill(&mut table, d, branch);
    table
}

fn fill(table: &mut Table, d: &Dimensions<f64>, branch: Branch) {
    set(
        table,
        "branch",
        if branch == Branch::Left { "left" } else { "right" }.into(),
    );
    d.map(&mut |symbol, number| {
        let shown = Number::new(symbol.shown(number), Digits::Decimals(decimals(symbol))).to_string();
        let shown = match shown.contains('.') {
            true => shown.trim_end_matches('0').trim_end_matches('.'),
            false => &shown,
        };
        set(table, symbol.id, format!("{shown} {}", symbol.display.name));
    });
}

/// A table out of its place, for a while; an empty one where there is none.
fn taken(place: &mut Item) -> Table {
    std::mem::take(place).into_table().unwrap_or_default()
}

/// Changes a text of a table; its comment stays.
fn set(table: &mut Table, key: &str, text: String) {
    let mut new = toml_edit::Value::from(text);
    if let Some(old) = table.get(key).and_then(Item::as_value) {
        *new.decor_mut() = old.decor().clone();
    }
    table[key] = Item::Value(new);
}

/// The levers side by side, in display units, and what binds the last.
fn table(comparison: &Comparison) -> String {
    let mut text = String::new();
    let mut rows = vec![vec![String::new()]];
    rows[0].extend(comparison.levers.iter().map(|lever| lever.role.to_owned()));
    let columns: Vec<_> = comparison.levers.iter().map(Compared::criteria).collect();
    for (i, (symbol, _)) in columns.first().into_iter().flatten().enumerate() {
        let mut row = vec![format!("{} [{}]", symbol.id, symbol.display.name)];
        row.extend(columns.iter().map(|column| match column[i].1 {
            Some(value) => short(symbol.shown(value)).to_string(),
            None => "does not close".to_owned(),
        }));
        rows.push(row);
    }
    asked::columns(&mut text, &rows);
    let binding = comparison
        .bounds
        .iter()
        .chain(&comparison.limits)
        .filter(|bound| bound.binds);
    let binding: Vec<&str> = binding.map(|bound| bound.symbol.id).collect();
    if !binding.is_empty() {
        let _ = writeln!(text, "  at its limit: {}", binding.join(", "));
    }
    text
}
