//! Whether a model keeps to the time: its communication steps by the clock, one by one, over the scene's motion again and
//! again.

use std::time::Instant;

use lemnis_models::kernel::variable::{Fault, Variable};
use lemnis_models::scene::Scene;

use crate::experiment::Experiment;

/// Steps that are taken of each level.
pub const STEPS: usize = 1_000_000;

/// Communication step where nothing else is asked for, in s.
pub const STEP: f64 = 1e-3;

/// A level's communication steps; times in s by the clock.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    pub level: &'static str,
    pub median: f64,
    /// That to which 999 of 1000 steps keep.
    pub nearly_all: f64,
    pub worst: f64,
    /// Evaluations of the right-hand side in the step that took longest, and in that which has most.
    pub rates: u32,
    pub most_rates: u32,
}

/// All levels of a scene, the deepest last.
#[derive(Clone, Debug)]
pub struct Paces {
    /// Communication step, in s.
    pub sample: f64,
    /// Steps of each level.
    pub steps: usize,
    pub levels: Vec<Pace>,
}

impl Paces {
    /// Runs each level of a scene through its motion in communication steps of `sample` s until `steps` were taken, and calls
    /// `done` after each.
    ///
    /// # Errors
    /// What a model refuses, and a motion that takes too long.
    pub fn new(scene: &Scene, sample: f64, steps: usize, done: &dyn Fn()) -> Result<Paces, Fault> {
        let levels = scene.levels();
        let deepest = levels.last().copied().unwrap_or("static");
        let mut experiment = Experiment::new(&scene.at(deepest), sample)?;
        let moved: Vec<String> = scene.at(deepest).model()?.variables()[..2]
            .iter()
            .map(Variable::name)
            .collect();
        let mut paces = Vec::new();
        for level in levels.iter().rev().copied() {
            // A command may lead beyond the working range, which a table does not have.
            if level == "table" && experiment.own_command().is_some() {
                continue;
            }
            let scene = scene.at(level);
            let seen = experiment.run(&scene, &mut scene.model()?, &moved, &mut |model, from, to| {
                model.advance(from, to)
            })?;
            if level == deepest {
                let [angles, rates] = seen.series.as_slice() else {
                    unreachable!("two names were given");
                };
                experiment.follow(angles, rates);
            }
            paces.push(pace(&scene, level, &experiment, &seen.commands, steps)?);
            done();
        }
        paces.reverse();
        Ok(Paces {
            sample,
            steps,
            levels: paces,
        })
    }

    /// The deepest level of which every step took less time than it stands for.
    #[must_use]
    pub fn largest(&self) -> Option<&Pace> {
        self.levels.iter().rfind(|pace| pace.worst < self.sample)
    }
}

fn pace(
    scene: &Scene,
    level: &'static str,
    experiment: &Experiment,
    commands: &[[(usize, f64); 2]],
    steps: usize,
) -> Result<Pace, Fault> {
    let mut model = scene.model()?;
    experiment.begin(&mut model)?;
    let start = model.state();
    let mut taken: Vec<(f64, u32)> = Vec::with_capacity(steps);
    while taken.len() < steps {
        model.set_state(&start);
        for (i, command) in commands.iter().take(steps - taken.len()).enumerate() {
            let from = i as f64 * experiment.sample;
            let before = model.count();
            let clock = Instant::now();
            experiment.step(&mut model, *command, from)?;
            let seconds = clock.elapsed().as_secs_f64();
            taken.push((seconds, model.count().since(before).rates));
        }
    }
    let most_rates = taken.iter().map(|(_, rates)| *rates).max().unwrap_or(0);
    taken.sort_by(|a, b| a.0.total_cmp(&b.0));
    let at = |part: f64| taken[((taken.len() - 1) as f64 * part).ceil() as usize];
    let (worst, rates) = at(1.0);
    Ok(Pace {
        level,
        median: at(0.5).0,
        nearly_all: at(0.999).0,
        worst,
        rates,
        most_rates,
    })
}
