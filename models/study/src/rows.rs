//! What comes of a design, or why there is nothing.

use lemnis_models::component::running::Running;
use lemnis_models::component::sheet::Check;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::registry::judged;
use lemnis_models::scene::Scene;
use lemnis_models::study::{Output, Study};

use crate::designs::Designs;

/// A study with its designs.
pub struct Plan<'a> {
    pub scene: &'a Scene,
    pub study: &'a Study,
    pub designs: Designs,
    /// What the scene asks of its results: the id of each check, and the result.
    pub requirements: Vec<(&'static str, &'static Symbol)>,
}

/// A design with what comes of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its number.
    pub design: usize,
    /// What comes of it, or why it is refused.
    pub found: Result<Found, String>,
}

/// What comes of a design.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// In the order of the study, in SI.
    pub outputs: Vec<f64>,
    /// Whether each requirement fails, in their order.
    pub fails: Vec<bool>,
}

impl<'a> Plan<'a> {
    #[must_use]
    pub fn new(scene: &'a Scene, study: &'a Study) -> Plan<'a> {
        let asked = judged(&*scene.mechanism, &mut scene.mechanism.standing(), &|_| false);
        Plan {
            scene,
            study,
            designs: Designs::new(study),
            requirements: asked
                .requirements
                .iter()
                .map(|check| (check.id, check.symbol))
                .collect(),
        }
    }

    /// What comes of the design with a number.
    ///
    /// # Panics
    /// Beyond the last design.
    #[must_use]
    pub fn row(&self, design: usize) -> Row {
        let text = self.study.replaced(self.scene.text(), &self.designs.values(design));
        let found = match Scene::design(&text) {
            Ok(scene) => self.found(&scene),
            Err(mistakes) => {
                let all: Vec<String> = mistakes.into_iter().map(|mistake| mistake.message).collect();
                Err(all.join("; "))
            }
        };
        Row { design, found }
    }

    fn found(&self, scene: &Scene) -> Result<Found, String> {
        let mut model = scene.mechanism.standing();
        let of_range = |symbol: &'static Symbol| {
            let mut outputs = self.study.outputs.iter();
            outputs.any(|output| output.at.is_none() && output.of.0 == symbol)
        };
        let judged = judged(&*scene.mechanism, &mut model, &of_range);
        let mut value = |output: &Output| match output.at {
            None => {
                let found = judged.results().find(|result| result.symbol == output.of.0);
                found.map(|result| result.value).ok_or_else(|| missing(&output.name))
            }
            Some(at) => {
                let index = model
                    .variables()
                    .iter()
                    .position(|variable| variable.quantity() == output.of);
                let index = index.ok_or_else(|| missing(&output.name))?;
                let value = model.set(0, at).and_then(|()| model.get(index));
                value.map_err(|fault| fault.message)
            }
        };
        let outputs = self.study.outputs.iter().map(&mut value).collect::<Result<_, _>>()?;
        let fails = |(id, symbol): &(&'static str, &'static Symbol)| {
            let own = |check: &&Check| check.id == *id && check.symbol == *symbol;
            let check = judged.requirements.iter().find(own);
            check.map(|check| !check.passed()).ok_or_else(|| missing(symbol.id))
        };
        let fails = self.requirements.iter().map(fails).collect::<Result<_, _>>()?;
        Ok(Found { outputs, fails })
    }
}

fn missing(name: &str) -> String {
    format!("there is no {name} all over the working range")
}
