//! What a scene says about a boom on a luffing rope.

use crate::balance::boom::Plain;
use crate::balance::scene::{Form, KEYS as BALANCE, PublishedBalance};
use crate::balance::symbols as b;
use crate::component::mechanism::{Entry, Mechanism, Solver};
use crate::component::model::Model;
use crate::component::part::Runner;
use crate::component::running::Running;
use crate::component::standing::Standing;
use crate::component::table::TOLERANCE;
use crate::component::telling::{fine, places};
use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::schema::{Key, Kind, Sign, Values};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::luffing::rope::position::{BoomChoice, Rig};
use crate::luffing::rope::stages::{Given, RopeBoom};
use crate::luffing::rope::symbols as s;
use crate::luffing::scene::{SOURCE, TABLE, interpolation};
use crate::parts::motion::{Motion, Place, degrees};
use crate::parts::plane::{self, Point};

/// Keys of `[luffing]` with `kind = "rope"`.
pub const KEYS: &[Key] = &[
    Key::kind(&["rope"], "A plain boom on a luffing rope."),
    Key::quantity(&s::L, Sign::Positive),
    Key::quantity(&s::F_A, Sign::Any).optional(),
    Key::quantity(&s::X_8, Sign::Any),
    Key::weight(&s::Q).optional(),
    Key {
        name: "fidelity",
        kind: Kind::Choice(&["static", "table"]),
        required: false,
        text: "How deep it is modelled: \"static\" (the angle is an input), \"table\" (the same, interpolated over the working range).",
    },
    Key::table("motion", MOTION, "Working range of the boom."),
    Key::table("tackle", TACKLE, "Luffing tackle between boom and frame."),
    Key::table(
        "hoist_rope",
        HOIST_ROPE,
        "Hoist rope from the boom's head over a sheave of the frame.",
    ),
    Key::table("weights", WEIGHTS, "Own weight of the boom and its centre of gravity.").optional(),
    Key::table("balance", BALANCE, "A balance of the boom.").optional(),
    Key::table("table", TABLE, "Interpolation, with fidelity \"table\".").optional(),
    Key::table(
        "limits",
        LIMITS,
        "What results may come to at most or must come to at least.",
    )
    .optional(),
    SOURCE,
];

const MOTION: &[Key] = &[
    Key::named("from", &b::PHI, Sign::Any, "Angle of the boom at the start."),
    Key::named("to", &b::PHI, Sign::Any, "Angle of the boom at the end."),
    Key::named("step", &b::PHI, Sign::Positive, "Step of tables."),
    Key::named("speed", &s::OMEGA, Sign::Positive, "Angular velocity of the boom."),
    SOURCE,
];

const TACKLE: &[Key] = &[
    Key::quantity(&s::E_X, Sign::Any),
    Key::quantity(&s::E_Y, Sign::Any),
    Key::quantity(&s::S_K, Sign::Positive),
    Key::quantity(&s::CHI_K, Sign::Any).optional(),
    Key::quantity(&s::FALLS_L, Sign::Positive),
    Key::quantity(&s::ETA_L, Sign::Positive).optional(),
    SOURCE,
];

const HOIST_ROPE: &[Key] = &[
    Key::quantity(&s::B_X, Sign::Any),
    Key::quantity(&s::B_Y, Sign::Any),
    Key::quantity(&s::FALLS_H, Sign::Positive),
    Key::quantity(&s::ETA_H, Sign::Positive).optional(),
    Key::quantity(&s::H_Q, Sign::NotNegative),
    SOURCE,
];

const WEIGHTS: &[Key] = &[
    Key::weight(&b::G_B),
    Key::quantity(&b::R_B, Sign::NotNegative),
    Key::quantity(&b::CHI_B, Sign::Any).optional(),
    SOURCE,
];

const LIMITS: &[Key] = &[
    Key::quantity(&s::EPSILON_Y, Sign::Positive).optional(),
    Key::quantity(&s::T_MAX, Sign::Positive).optional(),
    Key::quantity(&s::S_L_MAX, Sign::Positive).optional(),
    Key::quantity(&b::DM_MAX, Sign::Positive).optional(),
    Key::quantity(&b::GAMMA_MIN, Sign::NotNegative).optional(),
    Key::quantity(&b::N_MAX, Sign::Positive).optional(),
    SOURCE,
];

/// Tables with dimensions of their own; those of the boom stand above them.
pub const TABLES: [(&str, &[Key]); 4] = [
    ("tackle", TACKLE),
    ("hoist_rope", HOIST_ROPE),
    ("weights", WEIGHTS),
    ("balance", BALANCE),
];

/// A boom on a luffing rope as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct Rope {
    /// At the start of the working range.
    pub given: Given<f64>,
    /// Tolerance of the level `table`.
    pub table: Option<f64>,
    pub limits: Vec<(&'static Symbol, f64)>,
    /// Published results of the balance.
    pub published_balance: Option<PublishedBalance>,
}

/// As scenes describe it.
pub const ENTRY: Entry = Entry {
    table: "luffing",
    kind: "rope",
    keys: KEYS,
    read: |values, _, found| Some(Box::new(Rope::new(values, found)?)),
};

impl Rope {
    /// Builds the mechanism of a checked table; mistakes go to `found`.
    pub fn new(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Rope> {
        let before = found.len();
        let tables = [Some(v), v.table("tackle"), v.table("hoist_rope"), v.table("weights")];
        let n = |symbol: &Symbol| {
            let given = tables.iter().flatten().find_map(|table| table.number(symbol.id));
            // What is left out is straight, and without losses.
            let usual = [&s::F_A, &s::CHI_K, &b::CHI_B].map(|symbol| (symbol, 0.0));
            let mut usual = usual.into_iter().chain([(&s::ETA_L, 1.0), (&s::ETA_H, 1.0)]);
            given.or_else(|| usual.find_map(|(known, value)| (known == symbol).then_some(value)))
        };
        let range = Motion::read(v.table("motion")?, found);
        let balance = match v.table("balance") {
            Some(table) => Some(Form::read(table, found)?),
            None => None,
        };
        let (load, rig) = (v.number(s::Q.id), Rig::of(n)?);
        let weights = v.table("weights").and_then(|_| Plain::of(n));
        let mut needs = |key: &str, what: &str, help: &str| {
            found.push(Diagnostic::new(v.place(key), what, "not possible").help(help));
        };
        if weights.is_some() && load.is_none() {
            needs(
                "weights",
                "own weight without a load",
                "add Q = \"0 kN\" or more to [luffing]",
            );
        }
        if balance.is_some() && weights.is_none() {
            needs(
                "balance",
                "a balance without own weight",
                "add [luffing.weights] with G_b and r_b",
            );
        }
        let table = interpolation(v, found);
        let range = range?;
        let limits = v
            .table("limits")
            .map_or(Vec::new(), |table| table.quantities_of(LIMITS));
        let rope = Rope {
            given: Given {
                phi: One(&b::PHI, range.from),
                omega: One(&s::OMEGA, range.speed),
                load: load.map(|q| One(&s::Q, q)),
                rig,
                weights,
                balance,
                choice: BoomChoice { range },
            },
            table,
            limits,
            published_balance: v.table("balance").and_then(PublishedBalance::read),
        };
        if found.len() == before {
            rope.check(v, found);
        }
        (found.len() == before).then_some(rope)
    }

    /// Whether it can be all over its working range.
    fn check(&self, v: &Values, found: &mut Vec<Diagnostic>) {
        let Given { rig, choice, .. } = &self.given;
        let (from, to) = (choice.range.from, choice.range.to);
        let turn = std::f64::consts::TAU;
        let sheave = f64::direction(rig.b_x, rig.b_y);
        let met = sheave + ((from - sheave) / turn).ceil() * turn;
        if met <= to && plane::length(Point::new(rig.b_x, rig.b_y)) <= rig.l {
            let what = format!(
                "the boom meets the sheave B of the hoist rope at phi = {}",
                degrees(met)
            );
            let help = "set B_x and B_y behind the boom, or keep the working range away from it";
            let place = v.table("hoist_rope").map_or(0..0, |table| table.place(s::B_X.id));
            found.push(Diagnostic::new(place, what, "in the boom's way").help(help));
            return;
        }
        let fault = self.standing().and_then(|mut model| {
            let results = 0..model.variables().len();
            for at in fine(&choice.range) {
                model.set(0, at)?;
                results.clone().try_for_each(|index| model.get(index).map(drop))?;
            }
            Ok(())
        });
        if let Err(fault) = fault {
            found.push(
                Diagnostic::new(
                    v.place("motion"),
                    fault.message,
                    "not possible all over the working range",
                )
                .help("move what it names, or keep the working range away from there"),
            );
        }
    }

    /// In closed form.
    ///
    /// # Errors
    /// Never for a scene that was read.
    pub fn standing(&self) -> Result<Standing, Fault> {
        self.at_level(None)
    }

    fn at_level(&self, table: Option<f64>) -> Result<Standing, Fault> {
        let part = Runner::<RopeBoom, f64>::new(self.given.clone());
        Standing::new(Box::new(part), self.given.choice.range, table)
    }
}

impl Mechanism for Rope {
    fn id(&self) -> &'static str {
        "rope"
    }

    fn model(&self) -> Result<Model, Fault> {
        self.at_level(self.table).map(Model::Standing)
    }

    fn motion(&self) -> &Motion {
        &self.given.choice.range
    }

    fn levels(&self) -> Vec<&'static str> {
        vec!["table", "static"]
    }

    fn level(&self) -> &'static str {
        self.table.map_or("static", |_| "table")
    }

    fn is_auto(&self) -> bool {
        false
    }

    fn set_level(&mut self, level: &str) {
        self.table = (level == "table").then_some(TOLERANCE);
    }

    fn interpolate(&mut self, tolerance: f64) {
        self.table = Some(tolerance);
    }

    fn unused(&self, _: &str) -> Vec<(&'static str, &'static [&'static str])> {
        Vec::new()
    }

    fn solver(&self) -> Option<Solver> {
        None
    }

    fn place(&self, text: &str) -> Result<Place, (String, String)> {
        let named = self.standing().map_or(Vec::new(), |model| places(self, &model));
        self.motion()
            .place(text, &b::PHI, "an angle of the working range", &named)
    }

    fn has_chapter(&self, chapter: &str) -> bool {
        match chapter {
            "balance" => self.given.balance.is_some(),
            "motion" | "published" | "synthesis" | "remarks" | "views" | "sizing" => false,
            _ => true,
        }
    }

    fn duplicate(&self) -> Box<dyn Mechanism> {
        Box::new(self.clone())
    }
}
