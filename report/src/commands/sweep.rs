//! `lemnis sweep`: the designs that a scene's table `[study]` asks for, and what they say together.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;
use lemnis::machine::json as number;
use lemnis_models::kernel::number::{Number, SIGNIFICANT, column, rough};
use lemnis_models::scene::Scene;
use lemnis_models::study::Study;
use lemnis_study::rows::Plan;
use lemnis_study::run::{jobs, run};
use lemnis_study::summary::{Gathered, Spread};
use serde_json::{Value, json};

use crate::commands::asked::columns;
use crate::commands::watched::watched;
use crate::failure::Failure;
use crate::output::say;
use crate::scene_file;
use crate::study_file::Growing;

#[derive(Args)]
pub struct Sweep {
    /// Scene file with a table [study], - for the standard input
    scene: PathBuf,
    /// Write a line for each design, in SI units: its values, its results, what it fails, or why it is refused
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Go on where a run with the same scene and file was broken off
    #[arg(long, requires = "csv")]
    resume: bool,
    /// Print what the designs say together as JSON, in SI units
    #[arg(long)]
    json: bool,
}

impl Sweep {
    pub fn run(&self) -> Result<(), Failure> {
        let scene = scene_file::read(Some(&self.scene))?;
        let Some(study) = &scene.study else {
            return Err(Failure::Scene(format!(
                "error: {} asks for no study: add [study] with `vary` and `outputs`",
                scene_file::name(Some(&self.scene))
            )));
        };
        let plan = Plan::new(&scene, study);
        let mut gathered = Gathered::new(&plan);
        let file = self.csv.as_ref();
        let file = file.map(|path| Growing::new(&plan, path, self.resume, &mut |row| gathered.take(row)));
        let mut file = file.transpose()?;
        let rows = gathered.rows()..plan.designs.count();
        watched(["computing", "what is done"], jobs(&rows), |threads, watch| {
            run(&plan, rows, threads, watch, |row| {
                gathered.take(&row);
                file.as_mut().map_or(Ok(()), |file| file.row(&row))
            })
        })?;
        if self.json {
            let whole = told(&scene, &plan, &gathered);
            say(serde_json::to_string_pretty(&whole).expect("plain data"))?;
        } else {
            say(table(&scene, &plan, &gathered).trim_end())?;
        }
        let whole = gathered.rows() == plan.designs.count();
        if !whole {
            eprintln!(
                "broken off after {} of {} designs",
                gathered.rows(),
                plan.designs.count()
            );
        }
        match file {
            Some(file) => file.close(whole),
            None => Ok(()),
        }
    }
}

/// A part of all, in percent.
fn percent(count: usize, of: usize) -> String {
    format!("{} %", rough(100.0 * count as f64 / of.max(1) as f64))
}

/// How many designs of which kind.
fn designs(study: &Study, rows: usize) -> String {
    match study.drawn {
        None => format!("{rows} designs, every combination of the values"),
        Some(drawn) => {
            let even = match drawn.is_power_of_two() {
                true => String::new(),
                false => format!(
                    " (a power of two such as {} fills the ranges more evenly)",
                    drawn.next_power_of_two()
                ),
            };
            format!("{rows} designs, seed {}{even}", study.seed)
        }
    }
}

/// For reading, in the units of the trade.
fn table(scene: &Scene, plan: &Plan<'_>, gathered: &Gathered) -> String {
    let (study, rows) = (plan.study, gathered.rows());
    let mut text = format!("{}\n\n  {}\n\n", scene.title(), designs(study, rows));
    let varied = study.varied.iter();
    let mut lines: Vec<Vec<String>> = varied
        .map(|one| vec![one.key.clone(), one.symbol.written(one.value), one.text.clone()])
        .collect();
    lines.insert(0, ["varies", "in the scene", ""].map(str::to_owned).to_vec());
    columns(&mut text, &lines);
    text.push('\n');
    let mut lines = vec![
        ["", "least", "P5", "P50", "P95", "greatest"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for (place, output) in study.outputs.iter().enumerate() {
        let symbol = output.of.0;
        let mut line = vec![format!("{} [{}]", output.name, symbol.display.name)];
        line.extend(
            match gathered.spread(place) {
                Some(spread) => numbers(&spread).map(|value| symbol.shown(value)).to_vec(),
                None => vec![f64::NAN; 5],
            }
            .chunks(5)
            .flat_map(|all| {
                column(all, SIGNIFICANT)
                    .into_iter()
                    .map(|number: Number| number.to_string())
            }),
        );
        lines.push(line);
    }
    columns(&mut text, &lines);
    text.push('\n');
    if !plan.requirements.is_empty() {
        let each = plan.requirements.iter().zip(&gathered.fails);
        let each = each.filter(|(_, count)| **count > 0);
        let each: Vec<String> = each
            .map(|((id, symbol), count)| format!("{id} ({}) {}", symbol.id, percent(*count, rows)))
            .collect();
        let each = if each.is_empty() {
            String::new()
        } else {
            format!(": {}", each.join(", "))
        };
        let _ = writeln!(
            text,
            "  requirements failed by {} of all designs{each}",
            percent(gathered.failed, rows)
        );
    }
    if let Some((count, first)) = gathered.reason() {
        let _ = writeln!(
            text,
            "  refused: {} of all designs; {count} of {} like this: {first}",
            percent(gathered.refused(), rows),
            gathered.refused()
        );
    }
    text
}

fn numbers(spread: &Spread) -> [f64; 5] {
    [spread.least, spread.p5, spread.p50, spread.p95, spread.greatest]
}

/// Everything, in SI.
fn told(scene: &Scene, plan: &Plan<'_>, gathered: &Gathered) -> Value {
    let effects = gathered.effects(plan);
    let varied = plan.study.varied.iter().zip(&effects).map(|(one, effects)| {
        let outputs = plan.study.outputs.iter().zip(effects);
        let effect = outputs.map(|(output, effect)| {
            let effect = json!({ "exact": effect.exact.map(number), "sampled": effect.sampled.map(number) });
            (output.name.clone(), effect)
        });
        json!({
            "key": one.key, "unit": one.symbol.unit.name, "value": number(one.value), "law": one.text,
            "effects": effect.collect::<serde_json::Map<_, _>>(),
        })
    });
    let outputs = plan.study.outputs.iter().enumerate().map(|(place, output)| {
        let values = gathered.spread(place).map(|spread| numbers(&spread).map(number));
        let [least, p5, p50, p95, greatest] = values.unwrap_or_default();
        json!({
            "name": output.name, "unit": output.of.0.unit.name, "least": least, "p5": p5, "p50": p50, "p95": p95,
            "greatest": greatest,
        })
    });
    let requirements = plan.requirements.iter().zip(&gathered.fails);
    let requirements =
        requirements.map(|((id, symbol), fails)| json!({ "id": id, "result": symbol.id, "fails": fails }));
    let reason = gathered.reason();
    let reason = reason.map(|(count, first)| json!({ "count": count, "first": first }));
    json!({
        "name": scene.name(), "designs": gathered.rows(), "asked": plan.designs.count(),
        "seed": plan.study.drawn.map(|_| plan.study.seed), "varied": varied.collect::<Vec<_>>(),
        "outputs": outputs.collect::<Vec<_>>(), "requirements": requirements.collect::<Vec<_>>(),
        "failed": gathered.failed, "refused": gathered.refused(), "most_frequent_reason": reason,
    })
}
