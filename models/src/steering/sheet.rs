//! Everything a book says about the steering of a machine.

use crate::component::dependencies::{Recorder, recorded};
use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, Published, Told};
use crate::component::sheet::{Check, Drawing, Input, Sheet};
use crate::component::standing::Standing;
use crate::kernel::origin::Origins;
use crate::kernel::symbol::Symbol;
use crate::steering::changes::changes;
use crate::steering::checks::checks;
use crate::steering::drawing::{Stance, lengths, swept, triangle};
use crate::steering::inputs::inputs;
use crate::steering::mode::Mode;
use crate::steering::model::standing;
use crate::steering::parts::{Parts, demanded};
use crate::steering::published::printed;
use crate::steering::scene::Steering;
use crate::steering::stages::SteeredGroups;
use crate::steering::symbols as s;
use crate::steering::views::{slip_table, view};

static OUTLINE: Outline = Outline {
    constants: &[("middle", &[Stage("machine")]), ("linkage", &[Stage("linkages")])],
    sections: &[
        ("centre", &[Stage("pole")]),
        (
            "heading",
            &[Stage("rollings"), Stage("wheels"), Stage("speeds"), Stage("turn")],
        ),
        ("rates", &[Stage("rates")]),
        ("cylinder", &[Stage("poses")]),
        ("forces", &[Stage("drags"), Stage("forces"), Stage("travelling")]),
        ("flow", &[Stage("strokes"), Stage("flows")]),
        ("slip", &[Stage("errors"), Stage("alone")]),
    ],
    table: &[&s::O_X, &s::O_Y, &s::R_O, &s::OMEGA, &s::B_S, &s::MARGIN, &s::Q_SUM],
    curves: &[
        ("steering_angles", None, &s::THETA),
        ("steering_speeds", None, &s::V),
        ("steering_forces", None, &s::F_G),
        ("steering_slip", None, &s::SLIP_MAX),
        ("steering_flow", None, &s::Q_SUM),
    ],
    extremes: &[
        Greatest::new(&s::R_O_MIN, Most::Least, &s::R_O),
        Greatest::new(&s::MARGIN_MIN, Most::Least, &s::MARGIN),
        Greatest::new(&s::B_S_MAX, Most::Greatest, &s::B_S),
        Greatest::new(&s::F_G_WORK, Most::Greatest, &s::F_G),
        Greatest::new(&s::SLIP_WORK, Most::Greatest, &s::SLIP_MAX),
    ],
    summary: &[],
    sensitivity: &[],
    limits: &[Limit::at_least("range", &s::MARGIN_MIN)],
    worst: ("greatest_force", &s::F_G_WORK),
};

impl Told for Steering {
    fn outline(&self) -> &'static Outline {
        &OUTLINE
    }

    fn standing(&self) -> Standing {
        standing(self).expect("a scene that was read has a machine")
    }

    fn recorder(&self) -> Recorder {
        recorded::<SteeredGroups>
    }

    /// No group may stand beyond its range.
    fn limit(&self, symbol: &'static Symbol) -> Option<f64> {
        (symbol == &s::MARGIN_MIN).then_some(0.0)
    }

    fn identities(&self, _: &mut Standing) -> Vec<Check> {
        Vec::new()
    }

    fn published(&self) -> Option<&Published> {
        None
    }

    fn assumptions(&self) -> Vec<&'static str> {
        let level = match self.moving {
            Some(_) => "level_turning",
            None => "level_kinematic",
        };
        let resistance = self.given.tyre.map(|_| "resistance");
        std::iter::once(level).chain(resistance).collect()
    }

    fn drawing(&self) -> Drawing {
        let stance = Stance::new(self.given.clone()).expect("checked when the scene was read");
        swept(&self.built().machine, &stance)
    }

    fn remarks(&self) -> Vec<&'static str> {
        let mut list = vec!["zhang2016_modes"];
        if self.moving.is_some() {
            list.insert(0, "steering_moving");
        }
        if printed(&self.built().machine).is_some() {
            list.extend(["zhang2016_cot", "zhang2016_pairs", "zhang2016_dimensions"]);
        }
        if self.given.cylinder.is_some() {
            list.extend(["zhang2016_units", "zhang2016_moment", "zhang2016_factors", "iso3320"]);
        }
        list
    }

    fn inputs(&self, origins: &Origins) -> Vec<Input> {
        inputs(origins, self)
    }

    /// Its modes and their changes, and how its parts are chosen.
    fn more(&self, model: &mut Standing, sheet: &mut Sheet) {
        let built = self.built();
        sheet.views = Mode::ALL
            .into_iter()
            .filter_map(|mode| view(self, &built, mode))
            .collect();
        sheet.changes = changes(self, &built);
        let parts = Parts::new(self, &built, sheet.changes.as_ref());
        let demands = parts.demands.iter();
        sheet.demands = demands
            .map(|(mode, demand)| (mode.id(), demanded(&s::Q_MODE, demand)))
            .collect();
        sheet
            .governing
            .extend(parts.greatest().map(|demand| demanded(&s::Q_MAX, demand)));
        sheet.summary = parts.summary(self, &built);
        sheet
            .checks
            .extend(checks(self, &built, &parts, model, &sheet.governing));
        sheet.sizing = parts.sections;
        if let Some(linkage) = built.direct() {
            let section = sheet.constants.iter_mut().find(|section| section.id == "linkage");
            section
                .into_iter()
                .for_each(|section| section.drawing = Some(triangle(linkage)));
            sheet.curves.splice(0..0, lengths(linkage));
        }
        for worked in &mut sheet.positions {
            let section = worked.sections.iter_mut().find(|section| section.id == "slip");
            section
                .into_iter()
                .for_each(|section| section.table = Some(slip_table(model, worked.value)));
        }
    }
}
