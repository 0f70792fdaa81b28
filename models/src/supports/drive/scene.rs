//! What a scene says of its slewing drive, beside the support that it turns.

use std::sync::Arc;

use crate::component::beside::MovedBeside;
use crate::component::mechanism::Solver;
use crate::component::moving::MovingComponent;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::parts::air::{AIR_OR_WIND, AROUND, SWINGING};
use crate::parts::motor::{CaseBrake, CaseHold};
use crate::parts::starts::scene::{START, read};
use crate::parts::starts::way::StartWay;
use crate::parts::starts::{N_0, N_IDLE};
use crate::parts::turntable::WIND_ON_SLEWED;
use crate::supports::drive::given::{GearStage, GivenDrive, Moves, RingPinion, TurnedArea, TurningCase, TurningChoice};
use crate::supports::drive::moving::{DYNAMICS, SLEWING, moves};
use crate::supports::drive::symbols as s;

/// Beside the support.
pub const DRIVE: Key = Key::part(
    "slewing_drive",
    KEYS,
    "The slewing drive: motors, gears, brakes, pinions.",
);

/// The level at which nothing moves.
const STANDING: &str = "static";

/// Most stages of the gear.
const MANY: usize = 8;

/// Where the toothed ring has its teeth.
const SIDES: [&str; 2] = ["outside", "inside"];

const KEYS: &[Key] = keys! { s:
    Z_D > 0 [usually(1.0)], I_SL > 0 [optional], ETA_SL > 0 [optional], J_E >= 0 [usually(0.0)], P_N > 0, N_N > 0, LAMBDA_M > 0, K_A > 0, J_M > 0,
    L_R > 0 [optional];
    Key::new("heating", Kind::Count([1, 64]), "The load case for whose slewing to either side the heating of the motors is asked."),
    Key::new("stages", Kind::Tables(STAGE, MANY), "Stages of each gear from the motor to the pinion's shaft, in the place of i_sl and eta_sl, which then follow with pinion and ring.").optional(),
    START,
    Key::part("brake", BRAKE, "The brake on each motor's shaft."),
    Key::part("coupling", COUPLING, "The coupling behind each motor, which slips."),
    Key::part("pinion", PINION, "The pinion of each drive, and the toothed ring.")
};

static STAGE: &[Key] = keys! { s: I_G > 0, ETA_G > 0 };
const BRAKE: &[Key] = keys! { s: T_B > 0, TAU_B >= 0 };
const COUPLING: &[Key] = keys! { s: K_LIM > 0 [usually(1.1)] };
const PINION: &[Key] = keys! { s: R_Z > 0, R_G > 0, ETA_R > 0 [optional], K_F > 0, Y_F > 0, B_Z > 0, M_T > 0, ALPHA_T > 0, E_T > 0, NU_T >= 0;
    Key::new("teeth", Kind::Choice(&SIDES), "Whether the ring has its teeth outside or inside.")
};

/// A slewing drive as the scene describes it; nothing where it has none.
#[derive(Clone, Debug, Default)]
pub struct TurningScene {
    pub drive: Option<GivenDrive<f64>>,
    pub gravity: Option<One<f64>>,
    pub rope: Option<One<f64>>,
    pub start: Option<StartWay<f64>>,
    /// Of each load case, and of each wind area.
    pub works: Vec<TurningCase<f64>>,
    pub places: Vec<TurnedArea<f64>>,
    pub holds: Vec<CaseHold<f64>>,
    pub brake: Option<CaseBrake<f64>>,
    pub limit: Option<One<f64>>,
    pub pinion: Option<RingPinion<f64>>,
    /// Of the gear, and the efficiency of pinion and ring behind them.
    pub stages: Vec<GearStage<f64>>,
    pub mesh: Option<One<f64>>,
    pub choice: TurningChoice,
    pub moved: Option<Moves>,
    /// Slewing in motion, as soon as all is known that it follows from.
    pub slewing: Option<Arc<dyn MovedBeside>>,
}

impl TurningScene {
    /// Of a support whose friction is in one of these tables, under gravity (m/s²); mistakes go to `found`.
    pub fn read(v: &Values, friction: &[&str], gravity: f64, found: &mut Vec<Diagnostic>) -> Option<TurningScene> {
        let (before, table) = (found.len(), v.table("slewing_drive"));
        let brake = table.and_then(|table| table.table("brake"));
        let cases = v.tables("load_cases");
        let drive = "[supports.slewing_drive]";
        each(cases, &s::N_S, table.is_some(), (drive, "0 1/min"), found);
        each(cases, &s::ALPHA_Q, table.is_some(), (drive, "0 deg"), found);
        each(
            cases,
            &s::K_B,
            brake.is_some(),
            ("[supports.slewing_drive.brake]", "1.25"),
            found,
        );
        each(v.tables("areas"), &s::R_W, table.is_some(), (drive, "0 m"), found);
        let moved = moves(v, found);
        let Some(table) = table else {
            return (found.len() == before).then(TurningScene::default);
        };
        if !friction.iter().any(|name| v.has(name)) {
            let help = format!("add [supports.{}]", friction[0]);
            found.push(v.refuse(
                "drive",
                "a drive without friction of what it turns",
                "friction is needed",
                help,
            ));
        }
        let heating = table.count("heating")? as usize - 1;
        suits(table, cases, heating, found);
        geared(table, found);
        let one = |symbol: &'static Symbol| table.of(symbol).map(|value| One(symbol, value));
        let pinion = table.table("pinion");
        let read = TurningScene {
            drive: GivenDrive::read(table),
            gravity: Some(One(&s::G, gravity)),
            rope: one(&s::L_R),
            start: start(table, cases, found),
            works: cases.iter().filter_map(TurningCase::read).collect(),
            places: v.tables("areas").iter().filter_map(TurnedArea::read).collect(),
            holds: cases.iter().filter_map(CaseHold::read).collect(),
            brake: brake.and_then(CaseBrake::read),
            limit: one(&s::K_LIM),
            pinion: pinion.and_then(RingPinion::read),
            stages: table.tables("stages").iter().filter_map(GearStage::read).collect(),
            mesh: pinion
                .and_then(|pinion| pinion.of(&s::ETA_R))
                .map(|eta| One(&s::ETA_R, eta)),
            choice: TurningChoice {
                heating,
                inside: pinion.and_then(|pinion| pinion.text("teeth")) == Some(SIDES[1]),
            },
            moved,
            slewing: None,
        };
        (found.len() == before).then_some(read)
    }
}

impl TurningScene {
    /// Ids of what its model takes for granted.
    pub fn assumptions(&self) -> impl Iterator<Item = &'static str> {
        let sways = self.works.iter().any(|case| case.alpha > 0.0);
        let load = if sways { "turning_sway" } else { "turning_load" };
        let moving = self.slewing.iter().flat_map(|slewing| {
            let own = slewing.assumptions();
            let still = !own.contains(&WIND_ON_SLEWED);
            let calm = still.then_some("turning_calm");
            std::iter::once("turning_moving").chain(calm).chain(own)
        });
        self.drive
            .iter()
            .flat_map(move |_| ["turning_places", load])
            .chain(moving)
    }

    /// Ids of what it does not calculate.
    pub fn uncovered(&self) -> Option<&'static str> {
        self.drive.map(|_| {
            if self.start.is_some() {
                "turning_duty"
            } else {
                "turning_starter"
            }
        })
    }
}

impl TurningScene {
    /// Levels of a support with this drive.
    pub fn levels(&self) -> Vec<&'static str> {
        self.slewing
            .as_ref()
            .map_or_else(|| vec![STANDING], |slewing| slewing.levels())
    }

    /// Leaves out what a level does not have.
    pub fn set_level(&mut self, level: &str) {
        let moved = self.slewing.take().filter(|_| level != STANDING);
        self.slewing = moved.map(|slewing| slewing.at(level));
    }

    /// Sets the longest inner step (s) of what slews.
    pub fn step_by(&mut self, step: f64) {
        self.slewing = self.slewing.take().map(|slewing| slewing.stepping(step));
    }

    /// What a level has no use for.
    pub fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        match level {
            "swing" => Vec::new(),
            "rigid" if self.places.is_empty() => vec![(SLEWING.name, &SWINGING), (SLEWING.name, &[AIR_OR_WIND.name])],
            "rigid" => vec![(SLEWING.name, &SWINGING), ("slewing.air", &AROUND)],
            _ => vec![(DYNAMICS, &[]), (SLEWING.name, &[])],
        }
    }

    /// What runs, where slewing moves.
    pub fn moving(&self) -> Option<Result<MovingComponent, Fault>> {
        self.slewing.as_ref()?.run()
    }

    /// How that is solved.
    pub fn solver(&self) -> Option<Solver> {
        self.slewing.as_ref()?.solved()
    }
}

/// Refuses a quantity of each of these tables that is missing where it is needed, or there where it has no use: a table
/// needs it, of which an example of it is given.
fn each(
    tables: &[Values],
    symbol: &'static Symbol,
    needed: bool,
    (by, example): (&str, &str),
    found: &mut Vec<Diagnostic>,
) {
    for table in tables {
        let id = symbol.id;
        match (needed, table.stands(id)) {
            (true, false) => {
                let label = format!("{by} needs {id}");
                let help = format!("add {id} = \"{example}\", or what it is");
                found.push(table.refuse(id, format!("`{id}` is missing here"), label, help));
            }
            (false, true) => {
                let help = format!("add {by}, or remove it");
                found.push(table.refuse(id, format!("`{id}` without {by}"), "not used", help));
            }
            _ => {}
        }
    }
}

/// How its motors start, by the speeds of these load cases.
fn start(table: &Values, cases: &[Values], found: &mut Vec<Diagnostic>) -> Option<StartWay<f64>> {
    let (own, rated) = table.table("start").zip(table.of(&s::N_N))?;
    let way = read(own, rated, found)?;
    let ratio = table.of(&s::I_SL).or(staged(table)).unwrap_or(0.0);
    let turns = |(number, case): (usize, &Values)| case.of(&s::N_S).map(|n| (number, n * ratio));
    let turning: Vec<(usize, f64)> = (1..).zip(cases).filter_map(turns).collect();
    let (wrong, key, limit) = match &way {
        StartWay::SlipStart(slip) => {
            let fastest = turning.iter().max_by(|one, other| one.1.total_cmp(&other.1));
            let limit = format!("which is not below n_0 = {}", N_0.written(slip.n_0));
            (fastest.filter(|(_, turns)| *turns >= slip.n_0), N_0.id, limit)
        }
        StartWay::InverterStart(_) => return Some(way),
        StartWay::EngineStart(engine) => {
            let mut moving = turning.iter().filter(|(_, turns)| *turns > 0.0);
            let [idle, most] = [engine.speeds.idle, engine.speeds.most].map(|n| s::N_MOT.written(n));
            let limit = format!("and an engine runs from n_idle = {idle} to n_gov = {most}");
            (moving.find(|(_, turns)| !engine.runs(*turns)), N_IDLE.id, limit)
        }
    };
    if let Some((number, turns)) = wrong {
        let what = format!(
            "in load case {number} a motor would have to turn at {}, {limit}",
            s::N_MOT.written(*turns)
        );
        let (label, help) = match way {
            StartWay::EngineStart(_) => (
                "not so",
                "give another ratio i_sl or other stages, or another speed of the case",
            ),
            _ => ("too slow", "give a motor that turns faster, or a smaller ratio i_sl"),
        };
        found.push(own.refuse(key, what, label, help));
    }
    Some(way)
}

/// Turns of a motor for one of the crane, by stages, pinion and ring.
fn staged(table: &Values) -> Option<f64> {
    let pinion = table.table("pinion")?;
    let stages = table.tables("stages").iter().filter_map(|stage| stage.of(&s::I_G));
    Some(stages.product::<f64>() * pinion.of(&s::R_G)? / pinion.of(&s::R_Z)?)
}

/// Refuses a gear that is given twice or not at all, and stages without a pinion or its efficiency.
fn geared(table: &Values, found: &mut Vec<Diagnostic>) {
    let (by, stages) = ("[[supports.slewing_drive.stages]]", !table.tables("stages").is_empty());
    for (symbol, example) in [(&s::I_SL, "640"), (&s::ETA_SL, "85 %")] {
        let id = symbol.id;
        let (what, label, help) = match (stages, table.stands(id)) {
            (false, false) => (
                format!("`{id}` is missing in [supports.slewing_drive]"),
                "a gear without it".to_owned(),
                format!("add {id} = \"{example}\", or {by} and the pinion's eta_r"),
            ),
            (true, true) => (
                format!("`{id}` beside {by}, of which it follows"),
                "given twice".to_owned(),
                format!("remove it, or {by}"),
            ),
            _ => continue,
        };
        found.push(table.refuse(id, what, label, help));
    }
    match table.table("pinion") {
        None if stages => {
            let help = "add [supports.slewing_drive.pinion]: the last ratio is r_g / r_z";
            found.push(table.refuse("stages", "gear stages without a pinion", "a pinion is needed", help));
        }
        None => {}
        Some(pinion) => each(std::slice::from_ref(pinion), &s::ETA_R, stages, (by, "95 %"), found),
    }
}

/// Refuses part of a drive, motors that nothing heats, a coupling without a brake, and a ring within its pinion.
fn suits(table: &Values, cases: &[Values], heating: usize, found: &mut Vec<Diagnostic>) {
    found.extend(table.broken(&s::Z_D));
    match cases.get(heating).map(|case| case.number(s::N_S.id)) {
        None => {
            let what = format!("heating in load case {}, and there are {}", heating + 1, cases.len());
            found.push(table.refuse("heating", what, "there is none", "name the number of a load case"));
        }
        Some(Some(0.0)) => {
            let what = format!("in load case {} nothing slews: it heats no motor", heating + 1);
            let help = "name a load case with a speed n_s";
            found.push(table.refuse("heating", what, "at rest", help));
        }
        Some(_) => {}
    }
    if table.has("coupling") && !table.has("brake") {
        let help = "add [supports.slewing_drive.brake]: the coupling must transmit what it gives";
        found.push(table.refuse("coupling", "a coupling without a brake", "a brake is needed", help));
    }
    let Some(pinion) = table.table("pinion") else { return };
    let radii = pinion.of(&s::R_Z).zip(pinion.of(&s::R_G));
    if let Some((own, ring)) = radii.filter(|(own, ring)| ring <= own && pinion.text("teeth") == Some(SIDES[1])) {
        let [own, ring] = [s::R_Z.written(own), s::R_G.written(ring)];
        let what = format!("a ring of r_g = {ring} with teeth inside, and a pinion of r_z = {own}");
        found.push(pinion.refuse(s::R_G.id, what, "the pinion has no room", "give r_g above r_z"));
    }
}
