//! The steering as a mechanism of a scene.

use crate::component::mechanism::{Entry, Mechanism, Solver};
use crate::component::model::Model;
use crate::kernel::variable::Fault;
use crate::parts::motion::{Motion, Place};
use crate::steering::keys::KEYS;
use crate::steering::model::standing;
use crate::steering::moving;
use crate::steering::scene::Steering;
use crate::steering::symbols as s;

/// As scenes describe it.
pub const ENTRY: Entry = Entry {
    table: "steering",
    kind: "groups",
    keys: KEYS,
    read: |values, _, found| Some(Box::new(Steering::new(values, found)?)),
};

impl Mechanism for Steering {
    fn id(&self) -> &'static str {
        "steering"
    }

    fn model(&self) -> Result<Model, Fault> {
        match &self.moving {
            None => standing(self).map(Model::Standing),
            Some(moving) => {
                moving::model::SteeringMotion::new(self, moving).map(|model| Model::Moving(Box::new(model)))
            }
        }
    }

    fn motion(&self) -> &Motion {
        &self.motion
    }

    fn levels(&self) -> Vec<&'static str> {
        let moving = self.moving.iter().map(|_| "hydraulic");
        std::iter::once("kinematic").chain(moving).collect()
    }

    fn is_auto(&self) -> bool {
        self.auto
    }

    fn set_level(&mut self, level: &str) {
        if level != "hydraulic" {
            self.moving = None;
        }
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        match level {
            "kinematic" => vec![("dynamics", &[]), ("oil", &[]), ("plc", &[])],
            _ => Vec::new(),
        }
    }

    fn solver(&self) -> Option<Solver> {
        self.moving.as_ref().map(|_| Solver {
            step: &moving::symbols::STEP,
            tolerance: &moving::symbols::TOL,
            table: "oil",
            explicit: None,
        })
    }

    fn place(&self, text: &str) -> Result<Place, (String, String)> {
        let named = ["governing", "from", "middle", "to"];
        self.motion.place(text, &s::THETA_B, "a commanded angle", &named)
    }

    fn has_chapter(&self, chapter: &str) -> bool {
        match chapter {
            "motion" | "balance" | "published" | "synthesis" | "sensitivity" => false,
            "sizing" => self.given.bearing.is_some() || self.given.cylinder.is_some(),
            _ => true,
        }
    }

    fn duplicate(&self) -> Box<dyn Mechanism> {
        Box::new(self.clone())
    }
}
