//! What a scene says about the mechanism in motion.

use crate::balance::symbols as b;
use crate::kernel::course::Course;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::control::reading::Controllers;
use crate::luffing::moving::given::{Constants, CylinderOil, Inputs, Meets};
use crate::luffing::moving::hoisting::{HoistKind, LoadRope, hoisting, load_rope, load_taken, no_swing, surround};
use crate::luffing::moving::oil_scene::{oil_drive, straight_beside_oil};
use crate::luffing::moving::step::step;
use crate::luffing::moving::symbols as s;
use crate::luffing::moving::weather::Weather;
use crate::luffing::moving::weather_scene::{aside, meets, not_met, rails};
use crate::luffing::resistances::train::{BRAKE, MOTOR};
use crate::parts::air::AIR;
use crate::parts::control::reading::TABLE;
use crate::parts::ground::GROUND;
use crate::parts::hanging::too_short;
use crate::parts::hoist::HoistCommand;
use crate::parts::hydraulics::parts::OilParts;
use crate::parts::joint::JointDrive;
use crate::parts::motion::Motion;
use crate::parts::side_wind::SlewedArea;
use crate::parts::slope::{SLOPE, SlopingGround};
use crate::parts::turntable::{SlewingJoint, too_fast, without_inertia};
use crate::parts::turntable_control;

/// Keys of `[luffing.dynamics]` beside the inertias of a mechanism's bodies.
const DYNAMICS: &[Key] = keys! { s:
    C_V >= 0 [optional], M_F >= 0 [optional], G > 0 [optional], STEP > 0 [optional],
    M_A [over_time, optional], M_S >= 0 [over_time, optional], T_S > 0 [optional], V_H [in_steps, optional], A_H > 0 [optional], L_R > 0 [optional], PHI_R [optional], U_BR [in_steps, optional],
    P_WM [over_time, optional], V_WM [over_time, optional], SIGMA_M [over_time, optional], N_SM [over_time, optional]
};

/// Keys of `[luffing.dynamics]`, those of the bodies first.
#[must_use]
pub const fn dynamics<const N: usize>(bodies: &[Key]) -> [Key; N] {
    assert!(N == bodies.len() + DYNAMICS.len(), "as many as there are");
    let mut keys = [DYNAMICS[0]; N];
    let mut i = 0;
    while i < N {
        keys[i] = if i < bodies.len() {
            bodies[i]
        } else {
            DYNAMICS[i - bodies.len()]
        };
        i += 1;
    }
    keys
}

/// What slews with a mechanism, a part of a crane that may also stand beside `[luffing]`, at the top of the scene.
pub const SLEWING: Key = Key::part(
    "slewing",
    SLEWING_KEYS,
    "Inertia, friction and drive of a crane in motion that slews.",
);

static SLEWING_KEYS: &[Key] = keys! { s:
    J_SL >= 0, C_SL >= 0 [optional], M_F_SL >= 0 [optional], M_SL [over_time, optional], M_B_SL >= 0 [over_time, optional],
    A_WS >= 0 [optional], R_WS [optional], PSI_SL [optional], OMEGA_SL [optional], PSI_MIN [optional], PSI_MAX [optional], CHI_R [optional]; turntable_control::CONTROL, SLOPE
};

/// A crane that slews, at the start.
#[derive(Clone, Copy, Debug)]
pub struct SlewingStart {
    pub joint: SlewingJoint,
    /// Angle of the rope from the mechanism's plane, in rad.
    pub side: f64,
    pub slope: Option<SlopingGround<f64>>,
}

/// What a mechanism's bodies are called where a scene leaves something out, and whether they have what motion needs.
#[derive(Clone, Copy, Debug)]
pub struct Inert {
    /// The load is given.
    pub loaded: bool,
    /// Inertias that the scene must give, and how to give them.
    pub inertias: &'static [&'static Symbol],
    /// Length and inertia of the body that is driven, and the length that a rope is measured by.
    pub bar: [&'static Symbol; 2],
    pub reach: &'static Symbol,
    pub help: &'static str,
    /// The bodies by name.
    pub bodies: &'static str,
    /// Whether a body has inertia by its weight.
    pub weighs: fn(&Values) -> bool,
    /// Table of a hoist rope that the mechanism leads, with the falls of its tackle.
    pub leads: Option<&'static str>,
}

/// A mechanism in motion as the scene describes it; SI.
#[derive(Clone, Copy, Debug)]
pub struct Moving {
    pub constants: Constants<f64>,
    /// Of the inputs, until an importer sets others.
    pub inputs: Inputs,
    /// The same; of what the scene tells over time the greatest.
    pub strongest: Inputs,
    /// With level `swing`, and with level `hydraulic` where the scene gives a rope.
    pub rope: Option<LoadRope>,
    /// With level `hydraulic`.
    pub oil: Option<CylinderOil<f64>>,
    /// `None` where its oil has none of them.
    pub oil_parts: Option<OilParts>,
    /// Where the crane slews.
    pub slewing: Option<SlewingStart>,
    /// Of drives that follow a speed, or go to a place.
    pub controllers: Option<Controllers>,
    /// Whether the shaft of a motor turns with it.
    pub geared: bool,
    /// Whether brakes are on that.
    pub braked: bool,
    /// Whether the rope of a drive holds it.
    pub roped: bool,
    /// What of wind and slope it meets, and whether it is slewed at a given speed.
    pub meets: Meets,
    /// Where the wind acts on what slews.
    pub area: Option<SlewedArea>,
    /// In which drives come up to their speed in the book's manoeuvres, in s.
    pub ramp: f64,
}

impl Moving {
    /// Whether a hoist may do work in the scene's own motion.
    #[must_use]
    pub fn hoists(&self) -> bool {
        self.has_motor() || self.strongest.hoist.speed != 0.0
    }

    /// Whether the rope of its drive goes slack where it would have to push: with the inertia of the drum that it is on.
    #[must_use]
    pub fn is_hauled(&self) -> bool {
        self.geared && self.roped
    }

    /// Length of the load's rope at the start (m), and gravity (m/s²), where it has one.
    #[must_use]
    pub fn swings(&self) -> Option<[f64; 2]> {
        self.rope.map(|rope| [rope.length, self.constants.g])
    }

    /// Ids of what the model takes for granted of load, rope, hoist and controllers; `fixed` where there is no rope.
    pub fn taken(&self, fixed: &'static str) -> impl Iterator<Item = &'static str> {
        let controls = self.controllers.iter().flat_map(Controllers::taken);
        let shaft = [
            self.geared.then_some("motor_shaft"),
            self.braked.then_some("shaft_brakes"),
            self.roped
                .then_some(if self.geared { "drive_slack" } else { "drive_taut" }),
            self.meets.pressure.then_some("wind_in_motion"),
            self.meets.slope.then_some("slope_in_motion"),
            self.meets.slewing.then_some("slewed_as_given"),
            self.area.map(|_| "wind_aside_in_motion"),
            self.slewing.and_then(|it| it.slope).map(|_| "slope_under_slewing"),
        ];
        load_taken(self.rope.as_ref(), fixed)
            .chain(shaft.into_iter().flatten())
            .chain(controls)
            .chain(self.slewing.map(|_| "slewing"))
    }

    /// With its load fixed to the head.
    pub fn leave_rope(&mut self) {
        let air = self.rope.take().and_then(|rope| rope.air);
        self.area = self.area.map(|area| area.in_air(air.as_ref()));
        self.controllers = self.controllers.and_then(|all| all.without(2));
    }

    /// Whether a motor turns the hoist's drum.
    #[must_use]
    pub fn has_motor(&self) -> bool {
        self.rope.as_ref().is_some_and(LoadRope::has_motor)
    }

    /// Whether its hoist follows its command at once.
    #[must_use]
    pub fn winds_at_once(&self) -> bool {
        self.rope.is_some_and(|rope| matches!(rope.hoist, HoistKind::AtOnce))
    }

    /// The checked table `[luffing]`; `None` at the static level, and where there are mistakes, which go to `found`.
    pub fn new(v: &Values, gravity: f64, bodies: &Inert, found: &mut Vec<Diagnostic>) -> Option<Moving> {
        let before = found.len();
        let moving = Moving::read(v, gravity, bodies, found);
        // Of what cannot be read nobody knows whether its load swings.
        let may_swing = moving.map_or(found.len() > before, |moving| moving.rope.is_some());
        found.extend(no_swing(v, may_swing));
        moving
    }

    fn read(v: &Values, gravity: f64, bodies: &Inert, found: &mut Vec<Diagnostic>) -> Option<Moving> {
        let fidelity = v.text("fidelity").unwrap_or("static");
        let mut told = |refused: Diagnostic| found.push(refused);
        let table = table(v, fidelity, bodies).map_err(&mut told).ok()??;
        let hoisting = hoisting(v, table, fidelity).map_err(&mut told).ok()?;
        let falls = bodies.leads.filter(|falls| v.table(falls).is_some());
        let mut rope = load_rope(hoisting, fidelity, falls).map_err(told).ok()?;
        let area = aside(v, rope.is_some(), found);
        surround(v, &mut rope, gravity, found)?;
        let reach = (bodies.reach, v.of(bodies.reach).unwrap_or(0.0));
        found.extend(rope.and_then(|rope| too_short(hoisting, rope.length, reach)));
        let oil = oil_drive(v, fidelity, found)?;
        let oil_parts = match v.table("hydraulics") {
            Some(table) => OilParts::read(table).map_err(|refused| found.push(refused)).ok()?,
            None => None,
        };
        if oil.is_some() {
            found.extend(straight_beside_oil(v));
        }
        let n = |symbol: &Symbol| table.number(symbol.id);
        let slewing = match v.table("slewing") {
            Some(table) => Some(slewing(v, table, rope.is_some(), found)?),
            None => None,
        };
        let hoist = rope.filter(LoadRope::has_motor).map(|_| [hoisting; 2]);
        let drives = [Some([v, table]), v.table("slewing").map(|table| [table; 2]), hoist];
        let controllers = Controllers::read(drives, oil.is_some());
        let controllers = controllers.map_err(|refused| found.push(refused)).ok()?;
        found.extend(no_motor(hoisting, hoist.is_some()));
        let on_shaft = |part: &Key| v.table("cases").is_some_and(|cases| cases.has(part.name));
        let geared = v.has("drive") && oil.is_none() && on_shaft(&MOTOR);
        let braked = geared && on_shaft(&BRAKE);
        found.extend(no_brake(table, braked));
        let meets = meets(v, table, [slewing.is_some(), rope.is_some()]);
        found.extend(not_met(table, meets, [slewing.is_some(), rope.is_some()]));
        let mut strongest = inputs(v, [table, hoisting], Values::greatest);
        if let Some(controllers) = &controllers {
            controllers.limit(&mut strongest);
        }
        let step = step(v, [table, hoisting], (bodies.bar, &strongest), gravity, found);
        Some(Moving {
            slewing,
            oil,
            oil_parts,
            ramp: n(&s::T_S).unwrap_or(4.0),
            constants: Constants {
                c_v: n(&s::C_V).unwrap_or(0.0),
                m_f: n(&s::M_F).unwrap_or(0.0),
                g: gravity,
                step,
            },
            inputs: inputs(v, [table, hoisting], Values::number),
            strongest,
            controllers,
            rope,
            geared,
            braked,
            roped: v.table("drive").is_some_and(|drive| drive.text("kind") == Some("rope")),
            meets,
            area,
        })
    }
}

/// What is commanded of a mechanism, by its tables of dynamics and hoist.
fn inputs(v: &Values, [dynamics, hoisting]: [&Values; 2], of: fn(&Values, &str) -> Option<f64>) -> Inputs {
    let number = |table: Option<&Values>, symbol: &Symbol| table.and_then(|table| of(table, symbol.id)).unwrap_or(0.0);
    let drive = |table: Option<&Values>, [moment, brake]: [&Symbol; 2]| JointDrive {
        moment: number(table, moment),
        brake: number(table, brake),
    };
    let oil = v.table("hydraulics");
    Inputs {
        drives: [
            drive(Some(dynamics), [&s::M_A, &s::M_S]),
            drive(v.table("slewing"), [&s::M_SL, &s::M_B_SL]),
        ],
        hoist: HoistCommand {
            speed: number(Some(hoisting), &s::V_H),
            drive: drive(Some(hoisting), [&s::M_M_H, &s::M_B_H]),
        },
        valve: number(oil, &s::U_V),
        supply: number(oil, &s::P_P),
        torn: [&s::Y_B1, &s::Y_B2].map(|symbol| number(oil, symbol)),
        braking: number(Some(dynamics), &s::U_BR),
        weather: Weather {
            wind: [&s::P_WM, &s::V_WM].map(|symbol| number(Some(dynamics), symbol)),
            slope: number(Some(dynamics), &s::SIGMA_M),
            slewing: number(Some(dynamics), &s::N_SM),
        },
        shaft: 0.0,
        wind: [&s::V_AIR, &s::CHI_AIR].map(|symbol| number(v.table(AIR.name), symbol)),
    }
}

/// Most that `t_s` may be, over the time that the working range takes at its speed.
const MOST_RAMP: f64 = 100.0;

/// Refuses a time of starting and stopping in which no drive would ever come near its speed.
pub fn brisk(v: &Values, moving: &Moving, motion: &Motion, found: &mut Vec<Diagnostic>) {
    let Some(table) = v.table("dynamics").filter(|table| table.has(s::T_S.id)) else {
        return;
    };
    let most = MOST_RAMP * (motion.to - motion.from) / motion.speed.abs();
    if moving.ramp > most {
        let what = format!(
            "t_s = {} is more than {MOST_RAMP} times what the working range takes at its speed",
            s::T_S.written(moving.ramp)
        );
        let help = format!(
            "the drive would not come up to a tenth of it; give t_s up to {}",
            s::T_S.written(most)
        );
        found.push(table.refuse(s::T_S.id, what, "too long", help));
    }
}

/// Refuses a slewing moment that no crane would outlast, while the range is luffed: with the load and some weights at the end of
/// some lengths.
pub fn outlasts(
    v: &Values,
    moving: &Moving,
    motion: &Motion,
    [lengths, weights]: [&[&'static Symbol]; 2],
    found: &mut Vec<Diagnostic>,
) {
    let Some((table, slewing)) = v.table("slewing").zip(moving.slewing) else {
        return;
    };
    let sum = |table: Option<&Values>, of: &[&'static Symbol]| {
        let each = of.iter().filter_map(|symbol| table?.of(symbol));
        each.map(f64::abs).sum::<f64>()
    };
    let weight = v.number("Q").unwrap_or(0.0) + sum(v.table("weights"), weights);
    let (reach, mass) = (sum(Some(v), lengths), weight / moving.constants.g);
    if moving.controllers.is_some_and(|it| it.control.0[1].is_some()) {
        let speeds = turntable_control::fastest(table);
        return found.extend(too_fast(&speeds, (reach, "at the head"), moving.constants.g));
    }
    let told = table.course(s::M_SL.id).map(Course::end);
    let lasts = told.unwrap_or((motion.to - motion.from) / motion.speed.abs());
    let moment = moving.strongest.drives[1].moment;
    (slewing.joint).outlasts(table, moment, [reach, mass], lasts, moving.constants.g, found);
}

/// The table `[luffing.dynamics]` of what moves by itself.
fn table<'a>(v: &'a Values, fidelity: &str, bodies: &Inert) -> Result<Option<&'a Values>, Diagnostic> {
    let still = "add fidelity = \"rigid\" or \"swing\" to [luffing], or remove this table";
    let table = match (fidelity, v.table("dynamics")) {
        ("static" | "table" | "auto", None) => {
            let parts = [
                ("slewing", "slewing"),
                ("hoisting", "rope and hoist"),
                ("hydraulics", "oil"),
                (TABLE, "a controller"),
                (GROUND.name, "ground"),
            ];
            return match parts.into_iter().find(|(part, _)| v.has(part)) {
                Some((part, name)) => {
                    let what = format!("{name} of a mechanism that does not move by itself");
                    Err(v.refuse(part, what, "not used", still))
                }
                None => Ok(None),
            };
        }
        ("static" | "table", Some(_)) => {
            let what = "inertias and drive of a mechanism that does not move by itself";
            return Err(v.refuse("dynamics", what, "not used", still));
        }
        (_, None) => {
            return Err(v.refuse(
                "fidelity",
                format!("fidelity = \"{fidelity}\" without inertias"),
                "needs [luffing.dynamics]",
                bodies.help,
            ));
        }
        (_, Some(table)) => table,
    };
    if v.table("weights").is_none() || !bodies.loaded {
        return Err(v.refuse(
            "fidelity",
            format!("fidelity = \"{fidelity}\" without weights and load"),
            "what moves must weigh something",
            "add Q to [luffing] and a table [luffing.weights]; their masses are weights over g",
        ));
    }
    let balance = v.table("balance");
    if !inert(v, table, bodies) {
        return Err(v.refuse(
            "dynamics",
            format!("neither {}, nor balance, nor the load have any inertia", bodies.bodies),
            "nothing to be accelerated",
            format!(
                "give Q, a weight in [luffing.weights] away from its bar's foot, or one of {} greater than zero",
                ids(bodies.inertias)
            ),
        ));
    }
    if balance.is_some_and(|it| it.text("kind") == Some("lever") && !it.has(b::S_5.id)) {
        return Err(v.refuse(
            "balance",
            format!("fidelity = \"{fidelity}\" with a lever whose counterweight has no arm"),
            "its inertia is not known",
            "add s_5 = \"... m\": the counterweight weighs M_5 / s_5",
        ));
    }
    Ok(Some(table))
}

/// A controller of a hoist without a motor.
fn no_motor(hoisting: &Values, motor: bool) -> Option<Diagnostic> {
    let what = "a controller of a hoist that has no motor";
    let help = "command its speed by v_h, or give J_h and r_h of its drum";
    let refused = hoisting
        .table(TABLE)
        .map(|_| hoisting.refuse(TABLE, what, "nothing to control", help));
    refused.filter(|_| !motor)
}

/// A command of brakes on a shaft that has none.
fn no_brake(dynamics: &Values, braked: bool) -> Option<Diagnostic> {
    let what = "a command of brakes on the shaft of a motor that has none";
    let help = "add [cases.motor] and [cases.brake] to a crane with a drive, or remove it";
    let refused = dynamics
        .has(s::U_BR.id)
        .then(|| dynamics.refuse(s::U_BR.id, what, "no brake", help));
    refused.filter(|_| !braked)
}

/// Names of symbols in a sentence.
fn ids(symbols: &[&Symbol]) -> String {
    let ids: Vec<&str> = symbols.iter().map(|symbol| symbol.id).collect();
    match ids.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => ids.concat(),
    }
}

fn positive(table: &Values, symbol: &Symbol) -> bool {
    table.number(symbol.id).is_some_and(|value| value > 0.0)
}

/// Whether a table has a weight, away from its bar's foot: there it has no inertia.
#[must_use]
pub fn turns(table: &Values, weight: &Symbol, at: &Symbol) -> bool {
    positive(table, weight) && table.number(at.id) != Some(0.0)
}

/// Whether anything that the linkage moves has inertia.
fn inert(v: &Values, dynamics: &Values, bodies: &Inert) -> bool {
    // A rope over a pulley at the boom's foot leads its counterweight nowhere.
    let led = |balance: &Values| [&b::H_X, &b::H_Y].iter().any(|at| balance.number(at.id) != Some(0.0));
    let balances = |balance: &Values| positive(balance, &b::M_5) || turns(balance, &b::G_C, &b::R_C) && led(balance);
    v.number("Q").is_some_and(|q| q > 0.0)
        || bodies.inertias.iter().any(|bar| positive(dynamics, bar))
        || v.table("weights").is_some_and(bodies.weighs)
        || v.table("balance").is_some_and(balances)
}

/// What slews; whether the load swings on a rope.
fn slewing(v: &Values, table: &Values, swings: bool, found: &mut Vec<Diagnostic>) -> Option<SlewingStart> {
    let n = |symbol: &Symbol| table.number(symbol.id);
    let mut mistake = |place, what: String, label: &str, help: &str| {
        found.push(Diagnostic::new(place, what, label).help(help));
    };
    if let Some(balance) = v.table("balance").filter(|balance| rails(balance)) {
        mistake(
            balance.span.clone(),
            "slewing with a counterweight on a straight rail".to_owned(),
            "its distance from the slewing axis is not known",
            "remove [luffing.slewing], or take another balance",
        );
        return None;
    }
    if !swings && n(&s::CHI_R).is_some() {
        mistake(
            table.place(s::CHI_R.id),
            "chi_R without a swinging load".to_owned(),
            "not used",
            "remove it, or set fidelity = \"swing\"",
        );
        return None;
    }
    // Of a table within that of the mechanism it has been told.
    if found.is_empty() {
        found.extend(without_inertia(table));
    }
    let joint = SlewingJoint::read(table, found)?;
    Some(SlewingStart {
        joint,
        side: table.number(s::CHI_R.id).unwrap_or(0.0),
        slope: table.part(SLOPE.name, SlopingGround::read)?,
    })
}
