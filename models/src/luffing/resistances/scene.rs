//! What a scene says of its cases.

use crate::balance::scene::Form;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;
use crate::luffing::resistances::friction::OF_BALANCE;
use crate::luffing::resistances::given::{
    Case, CaseBody, CaseBrake, CaseHold, CaseMotor, CasePin, CasesChoice, SecondBrake,
};
use crate::luffing::resistances::placed::BARS;
use crate::luffing::resistances::symbols as s;
use crate::luffing::resistances::train::{BRAKE, MOTOR, SECOND, Train, named};
use crate::luffing::strength::scene::{BUCKLING, NUT, PIN_SIZE, ROPE, Sizes, TEETH};
use crate::parts::starts::scene::START;
use crate::parts::starts::way::StartWay;

/// The table `[cases]`, also beside the mechanism.
pub const CASES: Key = Key::part(
    "cases",
    KEYS,
    "Cases, in each of which the drive must overcome all that acts.",
);

/// Part of the wind at work, case II, that heats the motor by a standard that gives it.
const HEATING_WIND: (&str, f64) = (NAMES[0], 0.6);

/// Standards, each with the pressure of the wind over the square of its speed, in kg/m³.
const STANDARDS: [(&str, f64); 3] = [("GB/T 3811", 0.625), ("FEM 1.001", 0.613), ("EN 13001", 0.625)];
const NAMES: [&str; 3] = [STANDARDS[0].0, STANDARDS[1].0, STANDARDS[2].0];

static KEYS: &[Key] = keys! { s:
    C_AIR > 0 [optional];
    Key::choice("standard", &NAMES, "The standard that gives what a case leaves out, as far as it is known here."),
    Key::new("case", Kind::Tables(CASE, 12), "The cases: I for heating and fatigue, II the greatest at work, III out of service, or others."),
    Key::new("body", Kind::Tables(BODY, 24), "The bodies' inertias, and the areas that the wind meets."),
    Key::new("pin", Kind::Tables(PIN, 16), "Pins that rub.").optional(),
    MOTOR, START, BRAKE, SECOND, BUCKLING, TEETH, NUT, ROPE, PIN_SIZE
};

static CASE: &[Key] = keys! { s:
    K_Q >= 0, ALPHA_S [optional], P_W [optional], V_W [optional], SIGMA [usually(0.0)], N_S [usually(0.0)], V_S, A_S [usually(0.0)], K_B > 0 [optional];
    Key::new("name", Kind::Line, "Its name.")
};

static BODY: &[Key] = keys! { s:
    J_S >= 0, A_W >= 0 [optional], C_W >= 0 [optional], S_W [usually(0.0)], CHI_W [usually(0.0)];
    Key::new("on", Kind::Name, "The body, or counterweight, whose centre is that of its area.")
};

static PIN: &[Key] = keys! { s: MU_P >= 0, R_P > 0 [optional]; Key::new("at", Kind::Name, "The pin, by its letter.") };

/// A coefficient that a standard gives and no text at hand confirms.
#[derive(Clone, Debug)]
pub struct Coefficient {
    pub symbol: &'static Symbol,
    /// Of which case, from 1.
    pub number: Option<u16>,
    pub value: f64,
    pub standard: &'static str,
}

/// The cases of a scene; empty where it has none.
#[derive(Clone, Debug, Default)]
pub struct Cases {
    pub names: Vec<Text>,
    pub cases: Vec<Case<f64>>,
    pub bodies: Vec<CaseBody<f64>>,
    pub pins: Vec<CasePin<f64>>,
    pub air: Option<One<f64>>,
    pub motor: Option<CaseMotor<f64>>,
    pub start: Option<StartWay<f64>>,
    pub brake: Option<CaseBrake<f64>>,
    pub second: Option<SecondBrake<f64>>,
    /// Of each case, where there are brakes.
    pub holds: Vec<CaseHold<f64>>,
    /// What is checked of the drive and of pins.
    pub sizes: Sizes,
    pub choice: Option<CasesChoice>,
    pub unconfirmed: Vec<Coefficient>,
}

/// Bodies and pins of a mechanism by their names, and which of the pins is a guide.
#[derive(Clone, Copy)]
pub struct CaseParts {
    pub bodies: &'static [&'static str],
    pub pins: &'static [&'static str],
    pub guide: Option<&'static str>,
}

impl Cases {
    /// Of a checked mechanism's table, under gravity (m/s²); mistakes go to `found`.
    pub fn read(
        v: &Values,
        parts: &CaseParts,
        balance: Option<&Form<f64>>,
        gravity: f64,
        found: &mut Vec<Diagnostic>,
    ) -> Cases {
        let rod = matches!(balance, Some(Form::Lever(..) | Form::Parallelogram(_)));
        let behind = OF_BALANCE.iter().filter(|_| rod);
        let pins: Vec<&str> = parts.pins.iter().chain(behind).copied().collect();
        let sizes = Sizes::read(v, v.table("cases"), (&pins, parts.guide), found);
        let Some(table) = v.table("cases") else {
            return Cases::default();
        };
        needs(v, balance, found);
        let standard = table.text("standard");
        let standard = STANDARDS.iter().find(|(name, _)| standard == Some(name));
        let mut read = Cases {
            choice: Some(CasesChoice {
                gravity,
                sizes: sizes.at.clone(),
                ..CasesChoice::default()
            }),
            sizes,
            ..Cases::default()
        };
        read.take_bodies(table, parts, balance, found);
        read.take_pins(table, (&pins, parts.guide), found);
        read.take_air(table, standard, found);
        for case in table.tables("case") {
            read.take_case((table, case), standard.map(|(name, _)| *name), found);
        }
        let train = Train::read(table, &read.names, found);
        read.choice().heating = train.heating;
        (read.motor, read.brake, read.second) = (train.motor, train.brake, train.second);
        (read.start, read.holds) = (train.start, train.holds);
        if table.tables("case").is_empty() {
            found.push(table.refuse("case", "no case", "nothing to overcome", "add [[cases.case]]"));
        }
        read
    }

    /// Whether there are any.
    #[must_use]
    pub fn are_there(&self) -> bool {
        self.choice.is_some()
    }

    fn choice(&mut self) -> &mut CasesChoice {
        self.choice.get_or_insert_default()
    }

    fn take_bodies(
        &mut self,
        table: &Values,
        parts: &CaseParts,
        balance: Option<&Form<f64>>,
        found: &mut Vec<Diagnostic>,
    ) {
        let behind = balance.map(|_| "counterweight");
        let known: Vec<&str> = parts.bodies.iter().copied().chain(behind).collect();
        for body in table.tables("body") {
            let Some(at) = named(body, "on", "body", &known, found) else {
                continue;
            };
            let number = |symbol: &Symbol| body.number(symbol.id);
            if number(&s::A_W).is_some() && number(&s::C_W).is_none() {
                let what = format!("an area of the {} without a drag coefficient", known[at]);
                found.push(body.refuse(s::A_W.id, what, "c_w is needed", "add c_w"));
            }
            self.choice()
                .bodies
                .push(if known[at] == "counterweight" { BARS } else { at });
            let given = CaseBody::of(|symbol| Some(number(symbol).unwrap_or(0.0)));
            self.bodies.extend(given);
        }
        let told = &self.choice().bodies;
        let missing = (0..parts.bodies.len()).find(|body| !told.contains(body));
        if let Some(missing) = missing.filter(|_| found.is_empty()) {
            let name = parts.bodies[missing];
            let what = format!("no inertia of the {name}");
            let help = format!("add [[cases.body]] with on = \"{name}\" and J_s");
            found.push(table.refuse("body", what, "a body is missing", help));
        }
    }

    fn take_pins(&mut self, table: &Values, (known, guide): (&[&str], Option<&str>), found: &mut Vec<Diagnostic>) {
        for pin in table.tables("pin") {
            let Some(at) = named(pin, "at", "pin", known, found) else {
                continue;
            };
            let is_guide = guide == Some(known[at]);
            if pin.stands(s::R_P.id) == is_guide {
                let (what, label, help) = if is_guide {
                    ("is a guide and has no radius", "not used", "remove it")
                } else {
                    ("without its radius", "r_p is needed", "add r_p = \"... mm\"")
                };
                let what = format!("pin {} {what}", known[at]);
                found.push(pin.refuse(s::R_P.id, what, label, help));
            }
            self.choice().pins.push(at);
            self.pins
                .extend(CasePin::of(|symbol| Some(pin.number(symbol.id).unwrap_or(0.0))));
        }
    }

    /// The pressure of the wind, where a case has a speed of it.
    fn take_air(&mut self, table: &Values, standard: Option<&(&'static str, f64)>, found: &mut Vec<Diagnostic>) {
        let blows = table.tables("case").iter().find(|case| case.has(s::V_W.id));
        let given = table.number(s::C_AIR.id);
        if let (None, Some((name, value)), Some(_)) = (given, standard, blows) {
            self.unconfirmed.push(Coefficient {
                symbol: &s::C_AIR,
                number: None,
                value: *value,
                standard: name,
            });
        }
        let known = given.or(standard.map(|(_, value)| *value));
        if let (None, Some(case)) = (known, blows) {
            let what = "a wind speed without the pressure that it has";
            let help = "add c_air = \"0.613 kg/m3\" or \"0.625 kg/m3\" to [cases], or standard";
            found.push(case.refuse(s::V_W.id, what, "c_air is needed", help));
        }
        self.air = Some(One(&s::C_AIR, known.unwrap_or(0.0)));
    }

    /// Leaves a coefficient of the case that is being read to a standard.
    fn leave(&mut self, symbol: &'static Symbol, value: f64, standard: &'static str) {
        self.unconfirmed.push(Coefficient {
            symbol,
            number: Some(self.cases.len() as u16 + 1),
            value,
            standard,
        });
    }

    fn take_case(
        &mut self,
        (table, case): (&Values, &Values),
        standard: Option<&'static str>,
        found: &mut Vec<Diagnostic>,
    ) {
        let name = case.words("name").cloned().unwrap_or_default();
        if self.names.iter().any(|known| known.english() == name.english()) {
            let what = format!("two cases \"{}\"", name.english());
            found.push(case.refuse("name", what, "there is one already", "give it a name of its own"));
        }
        let number = |symbol: &Symbol| case.number(symbol.id);
        let blown = self.bodies.iter().any(|body| body.area > 0.0);
        let still = number(&s::P_W).is_none() && number(&s::V_W).is_none();
        let wind = heating_wind(table, standard, name.english()).filter(|_| still && blown);
        if let Some((value, standard)) = wind.zip(standard) {
            self.leave(&s::P_W, value, standard);
        }
        if blown && still && wind.is_none() {
            let lacks = standard.map_or(String::new(), |standard| {
                format!(", which {standard} does not give here")
            });
            let what = format!("case \"{}\" has no wind{lacks}, and bodies have areas", name.english());
            found.push(case.refuse(
                "name",
                what,
                "p_w or v_w is needed",
                "add p_w = \"0 Pa\" where there is none",
            ));
        }
        let sways = number(&s::K_Q).is_some_and(|part| part > 0.0);
        let mut alpha = number(&s::ALPHA_S).or((!sways).then_some(0.0));
        if alpha.is_none() {
            alpha = sway(standard, name.english(), number(&s::N_S).unwrap_or(0.0));
            if let Some((value, standard)) = alpha.zip(standard) {
                self.leave(&s::ALPHA_S, value, standard);
            }
        }
        if alpha.is_none() {
            let what = match standard {
                Some(standard) => format!(
                    "the sway of the load in case \"{}\", which {standard} does not give here",
                    name.english()
                ),
                None => format!("the sway of the load in case \"{}\"", name.english()),
            };
            found.push(case.refuse("name", what, "alpha_s is needed", "add alpha_s = \"... deg\""));
        }
        let given = Case::of(|symbol| match symbol {
            symbol if symbol == &s::ALPHA_S => alpha,
            symbol if symbol == &s::P_W => number(symbol).or(wind).or(Some(0.0)),
            symbol => Some(number(symbol).unwrap_or(0.0)),
        });
        self.cases.extend(given);
        self.names.push(name);
    }
}

/// Sway of the load of a cargo or grab crane at work that a standard gives, in rad, while it slews (1/s).
fn sway(standard: Option<&str>, case: &str, slewing: f64) -> Option<f64> {
    const FAST: f64 = 2.0 / 60.0;
    let angle: f64 = if slewing.abs() >= FAST { 12.0 } else { 10.0 };
    (standard == Some(NAMES[0]) && case == "II").then(|| angle.to_radians())
}

/// Wind pressure (Pa) under which a standard asks for the motor's heating: a part of that at work, where case II has one.
fn heating_wind(table: &Values, standard: Option<&str>, case: &str) -> Option<f64> {
    let (name, part) = HEATING_WIND;
    let asked = standard == Some(name) && case == "I";
    let mut cases = table.tables("case").iter().filter(|_| asked);
    let work = cases.find(|case| case.words("name").is_some_and(|name| name.english() == "II"))?;
    work.number(s::P_W.id)
        .filter(|_| !work.has(s::V_W.id))
        .map(|pressure| part * pressure)
}

/// What cases need of a mechanism.
fn needs(v: &Values, balance: Option<&Form<f64>>, found: &mut Vec<Diagnostic>) {
    for (key, what, help) in [
        ("Q", "cases without a load", "add Q to [luffing]"),
        ("weights", "cases without own weights", "add [luffing.weights]"),
    ] {
        if !v.has(key) && found.is_empty() {
            found.push(v.refuse("cases", what, "these need forces to be modelled", help));
        }
    }
    let driven = v.has("drive") || v.has("tackle");
    if !driven && found.is_empty() {
        let help = "add [luffing.drive]";
        found.push(v.refuse(
            "cases",
            "cases without a drive",
            "their speeds are those of the drive",
            help,
        ));
    }
    if matches!(balance, Some(Form::Lever(_, None, _))) {
        let help = "add s_5 = \"... m\" to [luffing.balance]: the counterweight weighs M_5 / s_5";
        let what = "cases with a lever whose counterweight has no arm";
        found.push(v.refuse("balance", what, "its inertia is not known", help));
    }
}

/// Of what a book does not calculate the rest that its cases do not have either.
#[must_use]
pub fn left(uncovered: Vec<&'static str>, cases: &Cases) -> Vec<&'static str> {
    let sizes = &cases.sizes;
    let parts = sizes.teeth.is_some() || sizes.nut.is_some() || sizes.wire.is_some() || sizes.pins.is_some();
    let rest = |id: &'static str| match id {
        _ if !cases.are_there() => Some(id),
        "wind" | "wind_on_structure" | "sway" | "inertia" | "friction" | "pin_friction" | "load_cases" => None,
        "motor_brake" => Some(match (cases.motor.is_some(), cases.brake.is_some()) {
            (true, true) => "gear",
            (true, false) => "gear_brake",
            (false, true) => "motor_gear",
            (false, false) => id,
        }),
        "strength" if parts => Some("other_strength"),
        "buckling" if sizes.strut.is_some() => Some("other_buckling"),
        _ => Some(id),
    };
    uncovered.into_iter().filter_map(rest).collect()
}
