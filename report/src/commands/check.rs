//! `lemnis check`: all results of a scene, and whether its limits are kept.

use std::path::PathBuf;

use clap::Args;
use lemnis::answer::Answer;
use lemnis::results::Results;

use crate::decision::to_build;
use crate::failure::Failure;
use crate::output::say;

#[derive(Args)]
pub struct Check {
    /// Scene file, - for the standard input [default: the embedded scene]
    scene: Option<PathBuf>,
    /// Print the results as JSON, in SI units
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Print the results as CSV, in the units of the trade
    #[arg(long)]
    csv: bool,
    /// Print the load chart of the scene as CSV, a line for each cell
    #[arg(long, conflicts_with_all = ["json", "csv"])]
    chart: bool,
}

impl Check {
    pub fn run(&self) -> Result<(), Failure> {
        let decision = to_build(self.scene.as_deref())?;
        let scene = &decision.scene;
        let results = Results::new(scene).map_err(Failure::of_scene)?;
        if self.json {
            say(Answer::of(&results).json())?;
        } else if self.csv {
            say(results.csv().trim_end())?;
        } else if self.chart {
            let charts = results.charts();
            if charts.is_empty() {
                let what = "the scene has no load chart: add [supports.chart]";
                return Err(Failure::Scene(format!("error: {what}")));
            }
            charts.iter().try_for_each(|chart| say(chart.trim_end()))?;
        } else {
            say(results.table())?;
            let (name, level) = (scene.name(), scene.level());
            decision.notes.iter().try_for_each(say)?;
            say(format_args!(
                "would build {name}.fmu, {name}.fmi2.fmu and {name}.pdf at level \"{level}\""
            ))?;
        }
        match results.broken_limits().as_slice() {
            [] => Ok(()),
            broken => Err(Failure::Limit(format!("limits not kept: {}", broken.join("; ")))),
        }
    }
}
