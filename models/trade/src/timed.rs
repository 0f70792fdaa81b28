//! One setting of a scene, run through the motion: what was seen, counted and clocked.

use std::time::Instant;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Fault;
use lemnis_models::parts::solver::Count;
use lemnis_models::scene::Scene;

use crate::experiment::{Experiment, Seen};
use crate::setting::Setting;

/// A run.
pub struct Timed {
    pub model: Model,
    pub seen: Seen,
    /// Work of the whole motion.
    pub work: Count,
    /// Size of a saved state.
    pub bytes: usize,
    /// Seconds of the clock for each simulated second, the median of the rounds; `None` without a clock.
    pub seconds: Option<f64>,
    /// The same by counted work.
    pub cost: f64,
}

impl Timed {
    /// Looks at results by their names, and asks for the first so many of them by the clock, in so many rounds.
    ///
    /// # Errors
    /// As [`Experiment::run`].
    pub fn new(
        scene: &Scene,
        experiment: &Experiment,
        setting: &Setting,
        names: &[String],
        (asked, rounds): (usize, usize),
    ) -> Result<Timed, Fault> {
        let mut model = setting.model(scene, experiment.sample)?;
        let bytes = 8 * model.numbers(&model.state()).len();
        let seen = experiment.run(scene, &mut model, names, &mut |model, from, to| model.advance(from, to))?;
        let work = model.count();
        let mut clocked = Vec::new();
        for _ in 0..rounds {
            let mut model = setting.model(scene, experiment.sample)?;
            let clock = Instant::now();
            experiment.replay(&mut model, &names[..asked], &seen.commands)?;
            clocked.push(clock.elapsed().as_secs_f64());
        }
        clocked.sort_by(f64::total_cmp);
        let duration = experiment.duration();
        Ok(Timed {
            model,
            seen,
            work,
            bytes,
            seconds: clocked.get(rounds / 2).map(|seconds| seconds / duration),
            cost: setting.price(scene, &work, experiment.samples) / duration,
        })
    }
}
