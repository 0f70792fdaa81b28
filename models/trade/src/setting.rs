//! A level with its solver and step, and what counted work costs.

use std::fmt;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::variable::Fault;
use lemnis_models::parts::solver::Count;
use lemnis_models::scene::Scene;

/// How a level is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Nothing is solved: results follow from the inputs.
    Closed,
    /// Runge and Kutta's explicit method of fourth order, with this longest step in s.
    Explicit(f64),
    /// Rodas, linearly implicit, with this relative tolerance.
    Implicit(f64),
    /// Nothing is solved: results are interpolated, to this part of their range.
    Interpolated(f64),
}

/// One way to run a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    pub level: &'static str,
    pub method: Method,
}

/// Longest steps of the explicit solver, in s, and tolerances of the implicit one.
const STEPS: [f64; 6] = [0.1, 0.05, 0.02, 0.01, 0.005, 0.002];
const TOLERANCES: [f64; 6] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];
/// Tolerances of the interpolation.
const INTERPOLATIONS: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// Of the references: an order of magnitude below what is compared with them.
const FINE_STEP: f64 = 0.0005;
const FINE_TOLERANCE: f64 = 1e-9;
const FINE_INTERPOLATION: f64 = 1e-11;

/// What a position with some results costs by a table, and in closed form, in s, as the [cost of a solver's
/// work](lemnis_models::component::mechanism::Solver::cost).
const POSITION: [f64; 2] = [0.03e-6, 0.08e-6];

impl Setting {
    /// All that apply at a level, from cheap to fine, with communication steps of `sample` s: at least one, and no inner
    /// step is longer than those.
    #[must_use]
    pub fn all(scene: &Scene, level: &'static str, sample: f64) -> Vec<Setting> {
        let of = |method| Setting { level, method };
        match Setting::fine(scene, level).method {
            Method::Closed => vec![of(Method::Closed)],
            Method::Explicit(_) => {
                let longest = sample.min(STEPS[0]);
                let finer = STEPS.into_iter().filter(|step| *step < longest);
                let steps = std::iter::once(longest).chain(finer);
                steps.map(|step| of(Method::Explicit(step))).collect()
            }
            Method::Implicit(_) => TOLERANCES.map(|tol| of(Method::Implicit(tol))).to_vec(),
            Method::Interpolated(_) => INTERPOLATIONS.map(|tol| of(Method::Interpolated(tol))).to_vec(),
        }
    }

    /// As fine as the level's solution needs to be when others are compared with it.
    #[must_use]
    pub fn fine(scene: &Scene, level: &'static str) -> Setting {
        let method = match scene.at(level).mechanism.solver() {
            Some(solver) if solver.explicit => Method::Explicit(FINE_STEP),
            Some(_) => Method::Implicit(FINE_TOLERANCE),
            None if level == "table" => Method::Interpolated(FINE_INTERPOLATION),
            None => Method::Closed,
        };
        Setting { level, method }
    }

    /// The running model of a scene with this setting.
    ///
    /// # Errors
    /// As [`Scene::model`].
    pub fn model(&self, scene: &Scene, sample: f64) -> Result<Model, Fault> {
        let mut scene = scene.at(self.level);
        if let Method::Interpolated(tolerance) = self.method {
            scene.mechanism.interpolate(tolerance);
        }
        if let Method::Explicit(step) = self.method {
            scene.mechanism.step_by(step);
        }
        let mut model = scene.model()?;
        let set = |model: &mut Model, id: &str, value| match index(model, id) {
            Some(index) => model.set(index, value),
            None => Ok(()),
        };
        match self.method {
            Method::Closed | Method::Interpolated(_) => {}
            Method::Explicit(step) => set(&mut model, "step", step)?,
            Method::Implicit(tolerance) => {
                set(&mut model, "step", sample)?;
                set(&mut model, "tol", tolerance)?;
            }
        }
        model.update()?;
        Ok(model)
    }

    /// What work costs, in s of the machine that the prices were measured on.
    #[must_use]
    pub fn price(&self, scene: &Scene, work: &Count, positions: u32) -> f64 {
        let solver = scene.at(self.level).mechanism.solver();
        let [rates, jacobian] = solver.map_or([0.0; 2], |solver| solver.cost);
        let position = POSITION[usize::from(!matches!(self.method, Method::Interpolated(_)))];
        f64::from(positions) * position + f64::from(work.rates) * rates + f64::from(work.jacobians) * jacobian
    }

    /// The key of the scene that says so, with its value.
    #[must_use]
    pub fn key(&self) -> Option<(&'static str, String)> {
        match self.method {
            Method::Closed => None,
            Method::Explicit(step) => Some(("step", format!("{} ms", short(step * 1e3)))),
            Method::Implicit(tolerance) | Method::Interpolated(tolerance) => Some(("tol", format!("{tolerance:e}"))),
        }
    }

    /// `RK4`, `Rodas`, or a closed form.
    #[must_use]
    pub fn solver(&self) -> &'static str {
        match self.method {
            Method::Closed => "closed form",
            Method::Explicit(_) => "RK4",
            Method::Implicit(_) => "Rodas",
            Method::Interpolated(_) => "cubic pieces",
        }
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.level, self.solver())?;
        self.key()
            .iter()
            .try_for_each(|(key, value)| write!(f, ", {key} = {value}"))
    }
}

/// A variable of a model by its name.
#[must_use]
pub fn index(model: &Model, name: &str) -> Option<usize> {
    model.variables().iter().position(|variable| variable.name() == name)
}
