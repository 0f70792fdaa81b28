//! The rows of a study in a file: CSV in SI, in which every number keeps its bits. While the study runs the file has a
//! temporary name, of the scene that it belongs to, so that a run that was broken off can go on.

use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};

use lemnis_fmu::instance::strings;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_study::rows::{Found, Plan, Row};

use crate::failure::Failure;
use crate::output::say;

/// Between the ids of requirements that fail.
const SEPARATOR: &str = "; ";

/// Digits of a scene's hash in the temporary name.
const HASH: usize = 12;

/// A file that grows.
pub struct Growing<'a> {
    plan: &'a Plan<'a>,
    writer: csv::Writer<File>,
    part: PathBuf,
    path: PathBuf,
}

impl<'a> Growing<'a> {
    /// A new file, or with `resume` the one that was left, of which `take` is given the rows.
    pub fn new(
        plan: &'a Plan<'a>,
        path: &Path,
        resume: bool,
        take: &mut dyn FnMut(&Row),
    ) -> Result<Growing<'a>, Failure> {
        let [version, hash] = strings(plan.scene);
        let mut part = path.as_os_str().to_owned();
        part.push(format!(".{version}-{}.part", &hash[..HASH]));
        let part = PathBuf::from(part);
        let file = match resume {
            true => left(plan, &part, path, take)?,
            false => File::create(&part).map_err(|error| cannot(&part, &error))?,
        };
        let mut growing = Growing {
            plan,
            writer: csv::Writer::from_writer(file),
            part,
            path: path.to_owned(),
        };
        if !resume {
            growing.write(&heads(plan))?;
        }
        Ok(growing)
    }

    /// The next row.
    pub fn row(&mut self, row: &Row) -> Result<(), Failure> {
        let number = |value: &f64| format!("{value:?}");
        let mut cells = vec![row.design.to_string()];
        cells.extend(self.plan.designs.values(row.design).iter().map(number));
        match &row.found {
            Ok(found) => {
                cells.extend(found.outputs.iter().map(number));
                let ids = self.plan.requirements.iter().zip(&found.fails);
                let ids: Vec<&str> = ids.filter(|(_, fails)| **fails).map(|((id, _), _)| *id).collect();
                cells.extend([ids.join(SEPARATOR), String::new()]);
            }
            Err(reason) => {
                cells.extend(self.plan.study.outputs.iter().map(|_| String::new()));
                // A row is a line.
                cells.extend([String::new(), reason.replace('\n', " ")]);
            }
        }
        self.write(&cells)
    }

    fn write(&mut self, cells: &[String]) -> Result<(), Failure> {
        let written = self.writer.write_record(cells);
        written.map_err(|error| cannot(&self.part, &error))
    }

    /// Gives a whole file its name; one that is not whole waits under its temporary one.
    pub fn close(mut self, whole: bool) -> Result<(), Failure> {
        let written = self.writer.flush().and_then(|()| self.writer.get_ref().sync_all());
        let Growing { part, path, .. } = &self;
        written.map_err(|error| cannot(part, &error))?;
        if !whole {
            return say(format_args!(
                "  kept in {}: --resume goes on from there",
                part.display()
            ));
        }
        let renamed = std::fs::rename(part, path);
        renamed.map_err(|error| Failure::File(format!("cannot replace {}: {error}", path.display())))?;
        say(format_args!("  wrote {}", path.display()))
    }
}

fn cannot(what: &Path, error: &dyn std::fmt::Display) -> Failure {
    Failure::File(format!(
        "cannot write {}: {error}; choose another place with --csv",
        what.display()
    ))
}

fn head(name: &str, symbol: &Symbol) -> String {
    format!("{name} [{}]", symbol.unit.name)
}

fn heads(plan: &Plan<'_>) -> Vec<String> {
    let varied = plan.study.varied.iter().map(|varied| head(&varied.key, varied.symbol));
    let outputs = plan.study.outputs.iter().map(|output| head(&output.name, output.of.0));
    let first = std::iter::once("design".to_owned()).chain(varied).chain(outputs);
    first.chain(["fails", "refused"].map(str::to_owned)).collect()
}

/// The file that a run left, to be gone on with, without a line that was not written to its end.
fn left(plan: &Plan<'_>, part: &Path, path: &Path, take: &mut dyn FnMut(&Row)) -> Result<File, Failure> {
    let unreadable = |error: &dyn std::fmt::Display| Failure::File(format!("cannot read {}: {error}", part.display()));
    if !part.is_file() {
        let (file, part) = (path.display(), part.display());
        return Err(Failure::File(format!(
            "nothing to resume: there is no {part}, which a run of this scene with --csv {file} leaves when it is broken off"
        )));
    }
    let file = OpenOptions::new().read(true).append(true).open(part);
    let file = file.map_err(|error| unreadable(&error))?;
    let mut lines = BufReader::new(&file);
    let (mut whole, mut rows) = (0, 0);
    let mut line = Vec::new();
    loop {
        line.clear();
        let read = lines.read_until(b'\n', &mut line).map_err(|error| unreadable(&error))?;
        if !line.ends_with(b"\n") {
            break;
        }
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .from_reader(line.as_slice());
        let record = reader.records().next().and_then(Result::ok).unwrap_or_default();
        let cells: Vec<&str> = record.iter().collect();
        if whole > 0 {
            let Some(row) = row(plan, rows, &cells) else {
                return Err(unreadable(&format_args!("line {} is no row of this study", rows + 2)));
            };
            take(&row);
            rows += 1;
        }
        whole += read as u64;
    }
    if whole == 0 {
        return Err(unreadable(&"it has no row; start without --resume"));
    }
    file.set_len(whole).map_err(|error| cannot(part, &error))?;
    Ok(file)
}

/// The row with a number, from its cells.
fn row(plan: &Plan<'_>, design: usize, cells: &[&str]) -> Option<Row> {
    let (varied, outputs) = (plan.study.varied.len(), plan.study.outputs.len());
    if cells.len() != 1 + varied + outputs + 2 || design >= plan.designs.count() || cells[0] != design.to_string() {
        return None;
    }
    let (numbers, [fails, refused]) = cells[1 + varied..].split_last_chunk()?;
    let found = match *refused {
        "" => Ok(Found {
            outputs: numbers
                .iter()
                .map(|number| number.parse().ok())
                .collect::<Option<_>>()?,
            fails: {
                let ids: Vec<&str> = fails.split(SEPARATOR).collect();
                plan.requirements.iter().map(|(id, _)| ids.contains(id)).collect()
            },
        }),
        reason => Err(reason.to_owned()),
    };
    Some(Row { design, found })
}
