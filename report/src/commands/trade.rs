//! `lemnis trade`: what accuracy costs, and the cheapest that keeps to what a
//! scene asks.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;
use lemnis::language::Language;
use lemnis::machine::{self, json as number};
use lemnis::print::diagram;
use lemnis::template::Templates;
use lemnis_models::kernel::number::{rough, short};
use lemnis_models::scene::Scene;
use lemnis_trade::compared::{AGREEMENT, Asked, Size};
use lemnis_trade::realtime::{Paces, STEP};
use lemnis_trade::trade::{self, SAMPLE, Trade as Traded};
use lemnis_typeset::{Embedded, Format, Typesetter};
use serde_json::{Map, Value, json};

use crate::failure::Failure;
use crate::measuring::{digits, dispensable, keeping, measured, paced, percent, verdict};
use crate::output::{Output, say, write};
use crate::scene_file;

#[derive(Args)]
pub struct Trade {
    /// Scene file, - for the standard input [default: the embedded scene]
    scene: Option<PathBuf>,
    /// Folder for the results: NAME_trade.json, NAME_trade.csv and the diagram as NAME_trade.svg and .pdf
    #[arg(short, long, default_value = "out")]
    output: PathBuf,
    /// Communication step, in s [default: 0.1; with --realtime 0.001]
    #[arg(long, value_name = "SECONDS", value_parser = positive)]
    step: Option<f64>,
    /// Rounds by the clock, of which the median counts
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
    /// Print how long communication steps take, the worst beside the median over a million of each level; writes no files
    #[arg(long, conflicts_with_all = ["output", "rounds"])]
    realtime: bool,
}

fn positive(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    let possible = (1e-6..=10.0).contains(&number);
    possible
        .then_some(number)
        .ok_or_else(|| "must be from 1e-6 to 10 s".to_owned())
}

impl Trade {
    pub fn run(&self) -> Result<(), Failure> {
        let scene = scene_file::read(self.scene.as_deref())?;
        if self.realtime {
            let paces = paced(&scene, self.step.unwrap_or(STEP))
                .map_err(|fault| Failure::Scene(format!("error: {}", fault.message)))?;
            return say(format_args!("{}\n{}", scene.title(), steps(&paces).trim_end()));
        }
        let traded = measured(&scene, self.step.unwrap_or(SAMPLE), self.rounds.into())
            .map_err(|failure| Failure::Scene(format!("error: {failure}")))?;
        say(format_args!("{}\n{}", scene.title(), table(&scene, &traded).trim_end()))?;
        let name = |suffix: &str| format!("{}_trade.{suffix}", scene.name());
        let outputs = [
            ("json", json(&scene, &traded).into_bytes()),
            ("csv", csv(&traded).into_bytes()),
            ("svg", diagram(&scene, &traded, Format::Svg)?),
            ("pdf", diagram(&scene, &traded, Format::Pdf)?),
        ];
        let outputs = outputs.map(|(suffix, bytes)| Output {
            name: name(suffix),
            bytes,
        });
        write(&self.output, &outputs)
    }
}

/// For reading: from cheap to dear, a star at what is on the front.
fn table(scene: &Scene, traded: &Traded) -> String {
    let motion = match traded.command {
        Some(id) => format!("moved by the scene's {id}"),
        None => "a cycle through the working range".to_owned(),
    };
    let mut text = format!(
        "  {motion}, {} s, communication step {} ms\n",
        short(traded.duration),
        short(traded.sample * 1e3)
    );
    for reference in &traded.references {
        if let Some(apart) = &reference.apart {
            let _ = writeln!(
                text,
                "  reference of level {}: two codes agree to {} of the range, in {} ({} asked for)",
                reference.level,
                rough(apart.part),
                apart.result,
                short(AGREEMENT)
            );
        }
    }
    align(&cells(traded), 4, &mut text);
    text.push_str(
        "  errors are the greatest; numerical and modelling are parts of the range, the worst of all results\n",
    );
    let best = |level: &str| {
        let seconds = traded.rows.iter().filter(|row| row.setting.level == level);
        seconds.filter_map(|row| row.seconds).reduce(f64::min)
    };
    if let (Some(table), Some(closed)) = (best("table"), best("static")) {
        let times = closed / table;
        let _ = if times > 1.0 {
            writeln!(
                text,
                "  the table is {} times as fast as the closed form for what is asked",
                digits(times)
            )
        } else {
            writeln!(text, "  the table is no faster than the closed form for what is asked")
        };
    }
    if traded.rows.iter().any(|row| row.follows) {
        text.push_str(
            "  follows: cannot take the command and is led along the deepest level's motion, so it is no substitute\n",
        );
    }
    for (setting, fault) in &traded.refused {
        let _ = writeln!(text, "  refused at {setting}: {}", fault.message);
    }
    left_out(traded, &mut text);
    for line in [verdict(scene, traded)].into_iter().chain(dispensable(traded)) {
        let _ = writeln!(text, "  {line}");
    }
    text
}

/// What each part of the scene gives and costs.
fn left_out(traded: &trade::Trade, text: &mut String) {
    let whole = &traded.rows[traded.whole];
    let price = |seconds: Option<f64>, cost: f64| seconds.unwrap_or(cost);
    let all = price(whole.seconds, whole.cost);
    let mut rows = vec![["without", "us/s", "of all"].map(str::to_owned).to_vec()];
    rows[0].extend(heads(traded));
    for part in &traded.parts {
        let mut cells = vec![part.path.clone()];
        match &part.without {
            Ok(without) => {
                if without.setting != whole.setting {
                    cells[0] = format!("{}, at {}", cells[0], without.setting);
                }
                let own = price(without.seconds, without.cost);
                cells.extend([digits(own * 1e6), percent(own / all)]);
                let errors = traded.asked.iter().zip(&without.errors);
                cells.extend(errors.map(|(asked, error)| digits(asked.variable.symbol.shown(error.max))));
            }
            Err(_) => cells.resize(rows[0].len(), "-".to_owned()),
        }
        rows.push(cells);
    }
    if traded.parts.is_empty() {
        return;
    }
    let _ = writeln!(
        text,
        "  each part left out, at {}, where all of them take {} us/s; the greatest errors are those of the model",
        whole.setting,
        digits(all * 1e6)
    );
    align(&rows, 1, text);
    for part in &traded.parts {
        if let Err(fault) = &part.without {
            let _ = writeln!(text, "  without {} it does not run: {}", part.path, fault.message);
        }
    }
}

/// The results that are compared, with their units.
fn heads(traded: &trade::Trade) -> impl Iterator<Item = String> {
    let head = |asked: &Asked| format!("{} [{}]", asked.name, asked.variable.symbol.display.name);
    traded.asked.iter().map(head)
}

/// How long communication steps take, a line for each level.
fn steps(paces: &Paces) -> String {
    let mut text = format!(
        "  {} communication steps of {} ms of each level\n",
        paces.steps,
        short(paces.sample * 1e3)
    );
    let heads = [
        "level",
        "median us",
        "99.9 % us",
        "worst us",
        "rates in it",
        "most rates",
    ];
    let mut rows = vec![heads.map(str::to_owned).to_vec()];
    for pace in &paces.levels {
        let mut cells = vec![pace.level.to_owned()];
        cells.extend([pace.median, pace.nearly_all, pace.worst].map(|seconds| digits(seconds * 1e6)));
        cells.extend([pace.rates, pace.most_rates].map(|count| count.to_string()));
        rows.push(cells);
    }
    align(&rows, 1, &mut text);
    let _ = writeln!(text, "  {}", keeping(paces));
    text
}

/// The head and a line for each setting.
fn cells(traded: &trade::Trade) -> Vec<Vec<String>> {
    let per_second = |count: u32| short((f64::from(count) / traded.duration).round()).to_string();
    let mut rows = vec![
        ["", "level", "solver", "", "us/s", "rates/s", "steps/s", "bytes"]
            .map(str::to_owned)
            .to_vec(),
    ];
    rows[0].extend(heads(traded));
    rows[0].extend(["numerical", "modelling"].map(str::to_owned));
    for row in &traded.rows {
        let mark = match (row.front, row.follows) {
            (_, true) => "follows",
            (true, _) => "*",
            _ => "",
        };
        let setting = row
            .setting
            .key()
            .map_or_else(String::new, |(key, value)| format!("{key} = {value}"));
        let mut cells = vec![
            mark.to_owned(),
            row.setting.level.to_owned(),
            row.setting.solver().to_owned(),
            setting,
            digits(row.seconds.unwrap_or(row.cost) * 1e6),
            per_second(row.work.rates),
            per_second(row.work.steps),
            row.bytes.to_string(),
        ];
        for (asked, errors) in traded.asked.iter().zip(&row.errors) {
            let symbol = asked.variable.symbol;
            cells.push(errors.map_or_else(|| "-".to_owned(), |e| digits(symbol.shown(e.total.max))));
        }
        // The worst of all results, over their ranges.
        for of in [|e: &trade::Errors| e.numerical.max, |e: &trade::Errors| e.modelling.max] {
            let parts = traded.asked.iter().zip(&row.errors);
            let parts = parts.map(|(asked, errors)| match errors {
                None => f64::INFINITY,
                Some(errors) if of(errors) == 0.0 => 0.0,
                Some(errors) => of(errors) / asked.range,
            });
            cells.push(digits(parts.fold(0.0, f64::max)));
        }
        rows.push(cells);
    }
    rows
}

/// Writes rows with columns of one width: words, the first ones, to the left, numbers to the right.
fn align(rows: &[Vec<String>], words: usize, text: &mut String) {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
    for row in rows {
        let cells = row
            .iter()
            .zip(&widths)
            .enumerate()
            .map(|(i, (cell, &width))| match i < words {
                true => format!("{cell:<width$}"),
                false => format!("{cell:>width$}"),
            });
        let _ = writeln!(text, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end());
    }
}

/// The work-precision diagram by the clock.
fn diagram(scene: &Scene, traded: &Traded, format: Format) -> Result<Vec<u8>, Failure> {
    let wrong = |error: &dyn std::fmt::Display| Failure::Program(format!("the diagram cannot be drawn: {error}"));
    let language = Language::find("en").expect("known");
    let asks = traded.asked.iter().any(|asked| asked.allowed.is_some());
    let error = if asks {
        "\"error over what is allowed\""
    } else {
        "\"error over range\""
    };
    let names = [error, "\"computing, µs per s\""];
    let picture = diagram::diagram(language, names, traded, |row| row.seconds.unwrap_or(row.cost));
    let title = format!("{}: cost over error", scene.title());
    let source = Templates::embedded()
        .picture(&picture, &title, language)
        .map_err(|error| wrong(&error))?;
    let made = Embedded
        .typeset(&source, &[], format, None)
        .map_err(|error| wrong(&error))?;
    Ok(made.files.into_iter().next().unwrap_or_default())
}

/// Everything, in SI.
fn json(scene: &Scene, traded: &Traded) -> String {
    let asked = traded.asked.iter().map(|asked| {
        let entry = json!({
            "unit": asked.variable.symbol.unit.name, "range": number(asked.range), "allowed": asked.allowed.map(number),
        });
        (asked.name.clone(), entry)
    });
    let references = traded.references.iter().map(|reference| {
        let apart = reference.apart.as_ref().map(|apart| {
            json!({
                "result": apart.result, "time": number(apart.time), "values": apart.values.map(number),
                "part_of_range": number(apart.part),
            })
        });
        json!({ "level": reference.level, "farthest_apart": apart })
    });
    let size = |size: Size| json!({ "max": number(size.max), "rms": number(size.rms) });
    let rows = traded.rows.iter().map(|row| {
        let errors = traded.asked.iter().zip(&row.errors).map(|(asked, errors)| {
            let entry = errors.map(
                |e| json!({ "numerical": size(e.numerical), "modelling": size(e.modelling), "total": size(e.total) }),
            );
            (asked.name.clone(), entry.unwrap_or(Value::Null))
        });
        let key = row.setting.key().map(|(key, value)| json!({ key: value }));
        json!({
            "level": row.setting.level, "solver": row.setting.solver(), "setting": key,
            "seconds_per_second": row.seconds.map(number), "cost": number(row.cost),
            "rates": row.work.rates, "jacobians": row.work.jacobians, "steps": row.work.steps,
            "rejected": row.work.rejected, "bytes": row.bytes, "follows": row.follows, "front": row.front,
            "holds": row.holds, "errors": errors.collect::<Map<_, _>>(),
        })
    });
    let choice = traded.choice().map(|row| row.setting.to_string());
    let parts = traded.parts.iter().map(|part| match &part.without {
        Ok(without) => {
            let errors = traded.asked.iter().zip(&without.errors);
            let errors = errors.map(|(asked, error)| (asked.name.clone(), size(*error)));
            json!({
                "without": part.path, "setting": without.setting.to_string(),
                "seconds_per_second": without.seconds.map(number), "cost": number(without.cost), "holds": without.holds, "errors": errors.collect::<Map<_, _>>(),
            })
        }
        Err(fault) => json!({ "without": part.path, "fault": fault.message }),
    });
    let refused = traded
        .refused
        .iter()
        .map(|(setting, fault)| json!({ "setting": setting.to_string(), "fault": fault.message }));
    let whole = json!({
        "name": scene.name(), "motion": traded.command.unwrap_or("cycle"), "duration": number(traded.duration),
        "communication_step": number(traded.sample), "agreement_asked": number(AGREEMENT),
        "results": asked.collect::<Map<_, _>>(), "references": references.collect::<Vec<_>>(),
        "settings": rows.collect::<Vec<_>>(), "refused": refused.collect::<Vec<_>>(), "choice": choice,
        "parts": { "setting": traded.rows[traded.whole].setting.to_string(), "left_out": parts.collect::<Vec<_>>() },
        "verdict": verdict(scene, traded),
    });
    serde_json::to_string_pretty(&whole).expect("plain data")
}

/// One line for each setting and result, errors in display units.
fn csv(traded: &Traded) -> String {
    let heads = "level,solver,setting,us_per_s,cost_us_per_s,rates,jacobians,steps,rejected,bytes,front,result,unit,numerical_max,\
                 numerical_rms,modelling_max,modelling_rms,total_max,total_rms,total_part_of_range";
    let mut records = vec![heads.split(',').map(str::to_owned).collect::<Vec<String>>()];
    for row in &traded.rows {
        for (asked, errors) in traded.asked.iter().zip(&row.errors) {
            let symbol = asked.variable.symbol;
            let setting = row
                .setting
                .key()
                .map_or_else(String::new, |(key, value)| format!("{key} = {value}"));
            let mut record = vec![
                row.setting.level.to_owned(),
                row.setting.solver().to_owned(),
                setting,
                row.seconds
                    .map_or_else(String::new, |seconds| machine::csv(seconds * 1e6)),
                machine::csv(row.cost * 1e6),
            ];
            let work = [row.work.rates, row.work.jacobians, row.work.steps, row.work.rejected];
            record.extend(work.map(|count| count.to_string()));
            record.extend([
                row.bytes.to_string(),
                row.front.to_string(),
                asked.name.clone(),
                symbol.display.name.to_owned(),
            ]);
            match errors {
                None => record.extend(std::iter::repeat_n(String::new(), 7)),
                Some(e) => {
                    for size in [e.numerical, e.modelling, e.total] {
                        record.extend([size.max, size.rms].map(|error| machine::csv(symbol.shown(error))));
                    }
                    record.push(machine::csv(e.total.max / asked.range));
                }
            }
            records.push(record);
        }
    }
    machine::records(records)
}
