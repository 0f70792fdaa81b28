//! Results of a scene as a table and as CSV.

use std::fmt::Write as _;

use lemnis_models::component::sheet::{Chart, Sheet};
use lemnis_models::kernel::diagnostic::Diagnostic;
use lemnis_models::kernel::number::{Number, SIGNIFICANT, column, short};
use lemnis_models::kernel::variable::{Fault, Role, Variable};
use lemnis_models::scene::Scene;

use crate::machine;

/// Every result of a scene: the values that hold for the whole range, and one
/// row of all variables for each position of the working range.
pub struct Results {
    pub scene: Scene,
    pub sheet: Sheet,
    /// What differs from position to position, the coordinate first.
    pub columns: Vec<Variable>,
    /// In SI.
    pub rows: Vec<Vec<f64>>,
}

/// What its book says of a scene.
///
/// # Errors
/// As [`Results::new`].
pub fn sheet(scene: &Scene) -> Result<Sheet, Fault> {
    let model = scene.model()?;
    let varying = model.varying();
    model.rows(&varying).try_for_each(|row| row.map(drop))?;
    Ok(scene.sheet())
}

impl Results {
    /// # Errors
    /// The scene's model cannot be built, or a position of its range does not exist.
    pub fn new(scene: &Scene) -> Result<Results, Fault> {
        Results::told(scene, Scene::sheet)
    }

    /// The same without runs in time.
    ///
    /// # Errors
    /// As [`new`](Results::new).
    pub fn at_rest(scene: &Scene) -> Result<Results, Fault> {
        Results::told(scene, Scene::sheet_at_rest)
    }

    fn told(scene: &Scene, sheet: fn(&Scene) -> Sheet) -> Result<Results, Fault> {
        let model = scene.model()?;
        let varying = model.varying();
        let columns = varying.iter().map(|&index| model.variables()[index]).collect();
        Ok(Results {
            rows: model.rows(&varying).collect::<Result<_, Fault>>()?,
            scene: scene.clone(),
            sheet: sheet(scene),
            columns,
        })
    }

    /// The limits of the scene that are not kept, one line each.
    #[must_use]
    pub fn broken_limits(&self) -> Vec<String> {
        let failed = self.sheet.checks().filter(|check| !check.passed());
        failed
            .map(|check| {
                let symbol = check.symbol;
                let relation = if check.at_most { "at most" } else { "at least" };
                let (value, limit) = (symbol.written(check.value), symbol.written(check.limit));
                let found = format!("{}: {} = {value}, {relation} {limit} is allowed", check.id, symbol.id);
                match check.value.is_finite() {
                    true => found,
                    false => format!("{found} ({})", symbol.text.trim_end_matches('.')),
                }
            })
            .collect()
    }

    /// In a line: which requirements are met, of what nothing is asked, and whether the identities hold.
    fn verdict(&self) -> String {
        let Sheet {
            requirements,
            unjudged,
            identities,
            ..
        } = &self.sheet;
        let failed = self.broken_limits();
        if !failed.is_empty() {
            return format!("checks failed: {}", failed.join("; "));
        }
        let met = match requirements.len() {
            0 => "no requirements given".to_owned(),
            count => format!("{count} of {count} requirements met"),
        };
        let unjudged: Vec<&str> = unjudged.iter().map(|symbol| symbol.id).collect();
        let unjudged = match unjudged.as_slice() {
            [] => String::new(),
            ids => format!("; not judged: {}", ids.join(", ")),
        };
        format!("{met}{unjudged}; identities that hold: {}", identities.len())
    }

    /// A few lines: what the crane does.
    #[must_use]
    pub fn summary(&self) -> String {
        let mut text = String::new();
        let mut rows: Vec<[String; 3]> = Vec::new();
        for result in self.sheet.results() {
            let symbol = result.symbol;
            let both = result.at.into_iter().chain(result.aside);
            let told = both.map(|(coordinate, at)| format!("{} = {}", coordinate.id, coordinate.written(at)));
            let at = told.reduce(|one, other| format!("{one}, {other}"));
            let at = at.map_or_else(String::new, |at| format!(" at {at}"));
            let value = symbol.written(result.value) + &at;
            rows.push([symbol.id.to_owned(), value, symbol.text.to_owned()]);
        }
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let (names, values) = (width(0), width(1));
        for [name, value, meaning] in &rows {
            let _ = writeln!(text, "  {name:<names$}  {value:<values$}  {meaning}");
        }
        let _ = writeln!(text, "  {}", self.verdict());
        text
    }

    /// Everything, for reading: summary and a row per position.
    #[must_use]
    pub fn table(&self) -> String {
        let mut text = format!("{}\n\n{}", self.scene.title(), self.summary());
        if let Some(rows) = self.rows_of() {
            let _ = writeln!(text, "\n{rows}");
        }
        // Each column with its head.
        let cells = |(i, variable): (usize, &Variable)| -> Vec<String> {
            let values: Vec<f64> = self.rows.iter().map(|row| variable.symbol.shown(row[i])).collect();
            let head = format!("{variable} [{}]", variable.symbol.display.name);
            std::iter::once(head)
                .chain(column(&values, SIGNIFICANT).iter().map(Number::to_string))
                .collect()
        };
        let cells: Vec<Vec<String>> = self.columns.iter().enumerate().map(cells).collect();
        let width = |i: usize| cells[i].iter().map(String::len).max().unwrap_or(0).max(11);
        // As many columns side by side as a line of 120 holds, the coordinate first.
        let mut start = 1;
        while start < cells.len() {
            let mut columns = vec![0];
            let mut used = width(0);
            while start < cells.len() && (columns.len() == 1 || used + width(start) + 2 <= 120) {
                used += width(start) + 2;
                columns.push(start);
                start += 1;
            }
            let line = |row: usize| {
                let cells = columns.iter().map(|&i| format!("{:>1$}", cells[i][row], width(i)));
                cells.collect::<Vec<_>>().join("  ")
            };
            text.push('\n');
            for line in (0..=self.rows.len()).map(line) {
                let _ = writeln!(text, "{line}");
            }
        }
        text
    }

    /// In which state each row of the table has a mechanism that moves by itself.
    fn rows_of(&self) -> Option<String> {
        let [coordinate, rate, ..] = self.columns.as_slice() else {
            return None;
        };
        match (self.scene.mechanism.solver(), coordinate.role) {
            (Some(_), Role::State) if rate.role != Role::State => Some(format!(
                "Each row: {coordinate} on its way, all other states and inputs as at the start."
            )),
            (Some(_), Role::State) => Some(format!(
                "Each row: {coordinate} passed at {rate} = {}, all other states as at the start.",
                rate.symbol.written(self.scene.mechanism.motion().speed)
            )),
            (Some(_), _) => Some(format!("Each row: everything stands where {coordinate} commands it.")),
            (None, _) => None,
        }
    }

    /// One line of names with units, then one line per position.
    #[must_use]
    pub fn csv(&self) -> String {
        let heads = self
            .columns
            .iter()
            .map(|column| format!("{column} [{}]", column.symbol.display.name));
        let rows = self.rows.iter().map(|row| {
            row.iter()
                .zip(&self.columns)
                .map(|(value, column)| machine::csv(column.symbol.shown(*value)))
                .collect::<Vec<_>>()
        });
        machine::records(std::iter::once(heads.collect()).chain(rows))
    }

    /// Each chart as CSV: names with units, then one line for each cell with what decides it.
    #[must_use]
    pub fn charts(&self) -> Vec<String> {
        let chart = |chart: &Chart| {
            let columns = &chart.points.columns;
            let heads = columns
                .iter()
                .map(|symbol| format!("{} [{}]", symbol.id, symbol.display.name));
            let rows = chart.points.rows.iter().zip(&chart.marks).map(|(row, mark)| {
                let cells = columns
                    .iter()
                    .zip(row)
                    .map(|(symbol, value)| machine::csv(symbol.shown(*value)));
                cells.chain([(*mark).to_owned()]).collect::<Vec<_>>()
            });
            machine::records(std::iter::once(heads.chain(["decides".to_owned()]).collect()).chain(rows))
        };
        self.sheet.charts.iter().map(chart).collect()
    }
}

/// The most inner steps of a default experiment, explicit or implicit: more take minutes.
const MOST_STEPS: [f64; 2] = [1e7, 1e6];

/// How long a scene's default experiment lasts, in s.
///
/// # Errors
///
/// Where it takes more than 1e7 explicit or 1e6 implicit inner steps, at the speed that the scene gives; likewise the way
/// through the working range, by which manoeuvres go whatever the scene tells its inputs over time.
pub fn lasting(scene: &Scene) -> Result<f64, Box<Diagnostic>> {
    let speed = scene.given.of(&format!("{}.motion.speed", scene.table));
    let place = || speed.map_or(0..0, |given| given.place.clone());
    let model = scene
        .model()
        .map_err(|fault| Diagnostic::new(place(), fault.message, ""))?;
    let lasts = model.stop_time();
    let range = scene.mechanism.motion();
    let ways = [
        ("default experiment", lasts),
        (
            "way through the working range",
            (range.to - range.from) / range.speed.abs(),
        ),
    ];
    let (what, longest) = if ways[1].1 > lasts { ways[1] } else { ways[0] };
    let [explicit, implicit] = MOST_STEPS;
    let (steps, most) = match scene.mechanism.solver() {
        Some(solver) if model.states() > 0 => (
            longest / solver.longest.min(model.step_size()),
            if solver.explicit { explicit } else { implicit },
        ),
        _ => (0.0, explicit),
    };
    if steps <= most {
        return Ok(lasts);
    }
    let message = format!(
        "the {what} lasts {} s, which takes {} inner steps",
        short(longest),
        short(steps.round())
    );
    let help = format!("at most {} are run: raise the speed", short(most));
    Err(Box::new(Diagnostic::new(place(), message, "too slow").help(help)))
}
