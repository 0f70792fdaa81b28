//! The double link as a mechanism of a scene.

use crate::component::mechanism::{Entry, Mechanism, Solver};
use crate::component::model::Model;
use crate::component::outline::Told;
use crate::component::table::TOLERANCE;
use crate::component::telling;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::variable::Fault;
use crate::luffing::double_link::keys::KEYS;
use crate::luffing::double_link::model::standing;
use crate::luffing::double_link::moving;
use crate::luffing::double_link::scene::Luffing;
use crate::luffing::double_link::sheet::remarks;
use crate::parts::motion::{Motion, Place};

/// As scenes describe it.
pub const ENTRY: Entry = Entry {
    table: "luffing",
    kind: "double_link",
    keys: KEYS,
    read: |values, gravity, found| {
        let luffing = Luffing::new(values, gravity, found)?;
        compare(&luffing, values, found).then(|| Box::new(luffing) as Box<dyn Mechanism>)
    },
};

/// Whether the mechanism exists at each published row; mistakes go to `found`.
fn compare(luffing: &Luffing, v: &Values, found: &mut Vec<Diagnostic>) -> bool {
    let before = found.len();
    if let Some((published, table)) = luffing.published.as_ref().zip(v.table("published")) {
        // The first line has the names.
        let places = table.texts("values").iter().skip(1);
        let compared = telling::compared(published, &mut luffing.standing());
        for (row, (_, place)) in compared.into_iter().zip(places) {
            if let Err(fault) = row {
                let message = format!("a published row of which there is none: {}", fault.message);
                found.push(
                    Diagnostic::new(place.clone(), message, "not possible").help("correct the row, or remove it"),
                );
            }
        }
    }
    found.len() == before
}

impl Mechanism for Luffing {
    fn id(&self) -> &'static str {
        "luffing"
    }

    fn model(&self) -> Result<Model, Fault> {
        match &self.moving {
            None => standing(self).map(Model::Standing),
            Some(moving) => moving::model::LuffingMotion::new(self, moving).map(|model| Model::Moving(Box::new(model))),
        }
    }

    fn motion(&self) -> &Motion {
        &self.motion
    }

    fn levels(&self) -> Vec<&'static str> {
        let mut levels = vec!["table", "static"];
        if let Some(moving) = &self.moving {
            levels.push("rigid");
            levels.extend(moving.rope.map(|_| "swing"));
            levels.extend(moving.oil.map(|_| "hydraulic"));
        }
        levels
    }

    fn level(&self) -> &'static str {
        match self.moving {
            None if self.table.is_some() => "table",
            _ => self.levels().last().copied().unwrap_or("static"),
        }
    }

    fn is_auto(&self) -> bool {
        self.auto
    }

    fn set_level(&mut self, level: &str) {
        self.auto = false;
        match level {
            "rigid" => {
                if let Some(moving) = &mut self.moving {
                    (moving.rope, moving.oil) = (None, None);
                }
            }
            "swing" => {
                if let Some(moving) = &mut self.moving {
                    moving.oil = None;
                }
            }
            "hydraulic" => {}
            _ => self.moving = None,
        }
        if level == "table" {
            self.table = Some(TOLERANCE);
        }
    }

    fn interpolate(&mut self, tolerance: f64) {
        self.table = Some(tolerance);
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        let mut unused: Vec<(&'static str, &'static [&'static str])> = match level {
            "static" | "table" => vec![("dynamics", &[]), ("slewing", &[]), ("hydraulics", &[])],
            "rigid" | "swing" => vec![("hydraulics", &[])],
            _ => Vec::new(),
        };
        let rope = self.moving.as_ref().is_some_and(|moving| moving.rope.is_some());
        if !(rope && matches!(level, "swing" | "hydraulic")) {
            unused.extend([
                ("slewing", &["chi_R"][..]),
                ("dynamics", &["l_R", "phi_R", "v_h"][..]),
                ("limits", &["phi_max"][..]),
            ]);
        }
        unused
    }

    fn solver(&self) -> Option<Solver> {
        self.moving.as_ref().map(|moving| Solver {
            step: &moving::symbols::STEP,
            tolerance: &moving::symbols::TOL,
            table: "hydraulics",
            explicit: moving.oil.is_none().then_some(moving.constants.step),
        })
    }

    fn place(&self, text: &str) -> Result<Place, (String, String)> {
        let named = standing(self).map_or(Vec::new(), |model| telling::places(self, &model));
        let theta = self.parameters.driven.coordinate();
        self.motion.place(text, theta, "an angle of the working range", &named)
    }

    fn has_chapter(&self, chapter: &str) -> bool {
        match chapter {
            "motion" => self.moving.is_some(),
            "balance" => self.parameters.balance.is_some(),
            "published" => self.published.is_some(),
            "synthesis" => self.synthesis.is_some(),
            "remarks" => !remarks(self).is_empty(),
            "views" | "sizing" => false,
            _ => true,
        }
    }

    fn duplicate(&self) -> Box<dyn Mechanism> {
        Box::new(self.clone())
    }
}
