//! The steering of a machine as scenes describe it and books tell it.

use crate::component::description::{Described, Description, Vocabulary};
use crate::component::mechanism::{Entry, Solver};
use crate::component::moved::Moved;
use crate::component::moving::MovingComponent;
use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters};
use crate::component::sheet::{Check, Drawing, Input, Sheet};
use crate::component::standing::Standing;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::schema::Values;
use crate::kernel::variable::Fault;
use crate::parts::hydraulics::symbols as h;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;
use crate::steering::changes::changes;
use crate::steering::checks::{identities, requirements};
use crate::steering::drawing::{Stance, lengths, swept, triangle};
use crate::steering::keys::KEYS;
use crate::steering::load::told;
use crate::steering::mode::Mode;
use crate::steering::moving;
use crate::steering::moving::sampled::in_motion;
use crate::steering::moving::told::motion;
use crate::steering::parts::{Parts, demanded};
use crate::steering::published::printed;
use crate::steering::scene::{Steering, SteeringScene};
use crate::steering::stages::{Given, SteeredGroups};
use crate::steering::symbols as s;
use crate::steering::views::{slip_table, view};

const OUTLINE: Outline = Outline {
    inputs: chapters! {
        groups, outline, range, load, tyre, ring, cylinder, accuracy, transition, hydraulics, dynamics, oil, plc,
        motion
    },
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
        ("flow", &[Stage("strokes"), Stage("flows"), Stage("total")]),
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
    limits: &[Limit::not_negative("range", &s::MARGIN_MIN)],
    uses: &[
        ("swept_lane", &[&s::E_F, &s::E_R, &s::E_LEFT, &s::E_RIGHT]),
        ("group_range", &[&s::THETA_MIN, &s::THETA_MAX]),
        ("limit", &[&s::SLIP_LIMIT, &s::V_C_MAX]),
        ("relief", &[&moving::symbols::P_R, &moving::symbols::K_R]),
    ],
    forces: &[&s::F_G, &s::T_G, &s::V_C, &s::Q_SUM],
    worst: &[("greatest_force", &s::F_G_WORK)],
};

/// As scenes describe it.
pub const ENTRY: Entry = Description::<SteeringScene>::entry("groups", KEYS);

impl Described for SteeringScene {
    type Component = SteeredGroups;
    const ID: &'static str = "steering";
    const TABLE: &'static str = "steering";
    const OUTLINE: &'static Outline = &OUTLINE;
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "steering_symbol",
        own: &[s::ALL, gravity::ALL, moving::symbols::ALL],
        shared: &[h::ALL],
    };

    fn read(v: &Values, _: f64, found: &mut Vec<Diagnostic>) -> Option<(SteeringScene, Motion)> {
        SteeringScene::new(v, found)
    }

    fn given(this: &Steering) -> Given<f64> {
        this.given.clone()
    }

    /// Whether it can be steered all over its working range is found while it is read.
    fn check(_: &mut Steering, _: &Values, _: &mut Vec<Diagnostic>) {}

    fn levels(&self) -> Vec<&'static str> {
        let moving = self.moving.iter().map(|_| "hydraulic");
        std::iter::once("kinematic").chain(moving).collect()
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
        self.moving.as_ref().map(|moving| Solver {
            step: ("dynamics", &moving::symbols::STEP),
            tolerance: ("oil", &moving::symbols::TOL),
            longest: moving.step.min(moving.t_c),
            explicit: false,
            cost: [0.22e-6, 1.0e-6],
        })
    }

    fn moving(this: &Steering) -> Option<Result<MovingComponent, Fault>> {
        in_motion(this)
    }

    fn chapters(&self) -> Vec<&'static str> {
        let sizing = self.given.bearing.is_some() || self.given.cylinder.is_some();
        let moving = self.moving.as_ref().map(|_| "motion");
        ["views"]
            .into_iter()
            .chain(sizing.then_some("sizing"))
            .chain(moving)
            .collect()
    }

    /// Loads of the groups stand with the loads, and what is forbidden to each group with the ranges: once where it is
    /// the same for all.
    fn arrange(&self, inputs: &mut Vec<Input>) {
        let mounts = &self.given.mounts;
        let common = mounts.windows(2).all(|pair| pair[0].forbidden == pair[1].forbidden);
        let told = if common { 1 } else { mounts.len() };
        let forbidden = (1..).zip(&mounts[..told]).flat_map(|(number, mount)| {
            let ends = mount
                .forbidden
                .iter()
                .flatten()
                .zip([&s::FORBIDDEN_FROM, &s::FORBIDDEN_TO].into_iter().cycle());
            ends.map(move |(value, symbol)| Input {
                symbol,
                number: (!common).then_some(number),
                value: *value,
                chapter: "range",
                given: None,
                on: None,
                usual: false,
            })
        });
        let loads: Vec<Input> = inputs.extract_if(.., |input| input.symbol == &s::G).collect();
        let loads = loads.into_iter().map(|load| Input {
            chapter: "load",
            ..load
        });
        let before = inputs.partition_point(|input| ["groups", "outline", "range"].contains(&input.chapter));
        inputs.splice(before..before, forbidden.chain(loads));
    }

    fn assumptions(this: &Steering) -> Vec<&'static str> {
        let level = match this.moving {
            Some(_) => "level_turning",
            None => "level_kinematic",
        };
        let resistance = this.given.tyre.map(|_| "resistance");
        std::iter::once(level).chain(resistance).collect()
    }

    fn uncovered(this: &Steering) -> Vec<&'static str> {
        let oil = this.moving.is_none().then_some("oil_dynamics");
        let others = [
            "slope",
            "side_forces",
            "travel_drive",
            "strength",
            "fatigue",
            "load_cases",
        ];
        oil.into_iter().chain(others).collect()
    }

    fn drawing(this: &Steering, at: f64) -> Drawing {
        let mut given = this.given.clone();
        given.theta_b.1 = at;
        let stance = Stance::new(given).expect("checked when the scene was read");
        swept(&this.built().machine, &stance)
    }

    fn drawn_at(this: &Steering) -> f64 {
        this.given.theta_b.1
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

    fn in_motion(this: &Steering) -> Option<Moved> {
        motion(this, this.moving.as_ref()?)
    }

    fn identities(this: &Steering, _model: &mut Standing) -> Vec<Check> {
        identities(this, &this.built())
    }

    /// Its modes and their changes, and how its parts are chosen.
    fn more(this: &Steering, model: &mut Standing, sheet: &mut Sheet) {
        let built = this.built();
        sheet.views = Mode::ALL
            .into_iter()
            .filter_map(|mode| view(this, &built, mode))
            .collect();
        sheet.changes = changes(this, &built);
        let parts = Parts::new(this, &built, sheet.changes.as_ref());
        let demands = parts.demands.iter();
        sheet.demands = demands
            .map(|(mode, demand)| (mode.id(), demanded(&s::Q_MODE, demand)))
            .collect();
        let most = parts.greatest();
        sheet.most_demanded = most.map(|(mode, demand)| (mode.id(), demanded(&s::Q_MAX, demand)));
        sheet.summary = parts.summary(this, &built);
        let (asked, unjudged) = requirements(this, &parts, model, &sheet.governing);
        sheet.requirements.extend(asked);
        sheet.unjudged.extend(unjudged);
        sheet.sizing = parts.sections;
        let given = |symbol| {
            sheet
                .inputs
                .iter()
                .find(|input| input.symbol == symbol)
                .map(|input| input.value)
        };
        if let [Some(weight), Some(x), Some(y)] = [&s::W, &s::X_G, &s::Y_G].map(given) {
            sheet.constants.push(told(&built.machine, weight, Point::new(x, y)));
        }
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
