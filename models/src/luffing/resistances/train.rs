//! What a scene says of the motor and the brakes that work its cases.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;
use crate::luffing::resistances::given::{CaseBrake, CaseHold, CaseMotor, InverterStart, SecondBrake, SlipStart};
use crate::luffing::resistances::symbols as s;

/// Beside the cases.
pub const MOTOR: Key = Key::part("motor", MOTOR_KEYS, "The motor that works the drive.");
pub const START: Key = Key::part("start", START_KEYS, "How the motor starts, besides by its mean torque.");
pub const BRAKE: Key = Key::part("brake", BRAKE_KEYS, "The brake on the motor's shaft.");
pub const SECOND: Key = Key::part("second_brake", SECOND_KEYS, "Another brake there, which acts after it.");

const MOTOR_KEYS: &[Key] = keys! { s:
    P_N > 0, N_N > 0, LAMBDA_M > 0, K_A > 0, J_M > 0, L_M > 0, ETA_M > 0;
    Key::new("heating", Kind::Name, "The case for whose motion in and out the heating of the motor is asked.")
};

const START_KEYS: &[Key] = keys! { s:
    LAMBDA_BD > 0 [optional], N_0 > 0 [optional], T_R > 0 [optional], LAMBDA_INV > 0 [optional];
    Key::new("kind", Kind::Choice(&["slip", "inverter"]), "\"slip\", along the motor's own curve of torque over slip, or \"inverter\", which ramps its speed up.")
};

const BRAKE_KEYS: &[Key] = keys! { s: T_B > 0, TAU_B >= 0 };

const SECOND_KEYS: &[Key] = keys! { s: T_B2 > 0, TAU_B2 >= 0 };

/// Motor and brakes of a scene.
#[derive(Default)]
pub struct Train {
    pub motor: Option<CaseMotor<f64>>,
    pub slip: Option<SlipStart<f64>>,
    pub inverter: Option<InverterStart<f64>>,
    pub brake: Option<CaseBrake<f64>>,
    pub second: Option<SecondBrake<f64>>,
    pub holds: Vec<CaseHold<f64>>,
    /// The case of the motor's heating, from 0.
    pub heating: Option<usize>,
}

impl Train {
    /// Of the table of cases with these names; mistakes go to `found`.
    pub fn read(table: &Values, names: &[Text], found: &mut Vec<Diagnostic>) -> Train {
        let mut train = Train::default();
        train.take(table, names, found);
        train
    }

    fn take(&mut self, table: &Values, names: &[Text], found: &mut Vec<Diagnostic>) {
        let motor = table.table("motor");
        if let Some(motor) = motor {
            self.motor = CaseMotor::of(|symbol| motor.number(symbol.id));
            self.take_heating(table, motor, names, found);
        }
        if let Some(start) = table.table("start") {
            self.take_start(table, start, found);
        }
        let of = |name| table.table(name);
        self.brake = of("brake").and_then(|v| CaseBrake::of(|symbol| v.number(symbol.id)));
        self.second = of("second_brake").and_then(|v| SecondBrake::of(|symbol| v.number(symbol.id)));
        if motor.is_none() && self.brake.is_some() {
            let help = "add [cases.motor]: the brakes are on its shaft";
            found.push(table.refuse("brake", "brakes without a motor", "on no shaft", help));
        }
        if let Some((second, v)) = self.second.zip(of("second_brake")) {
            match self.brake {
                None => {
                    let what = "a second brake without a first";
                    found.push(v.refuse(s::T_B2.id, what, "the only one", "call it [cases.brake]"));
                }
                Some(first) if second.delay < first.delay => {
                    let what = "the second brake acts before the first";
                    let help = "give the brake that acts first in [cases.brake]";
                    found.push(v.refuse(s::TAU_B2.id, what, "too early", help));
                }
                Some(_) => {}
            }
        }
        for case in table.tables("case") {
            match (case.number(s::K_B.id), self.brake.is_none()) {
                (None, false) => {
                    let lacks = table.text("standard").map_or(String::new(), |standard| {
                        format!(", which {standard} does not give here")
                    });
                    let what = format!("brakes, and a case without the safety with which they hold it{lacks}");
                    found.push(case.refuse(
                        "name",
                        what,
                        "K_b is needed",
                        "add K_b = \"1.25\", or what your rules ask for",
                    ));
                }
                (Some(_), true) => {
                    let what = "a safety of brakes where there are none";
                    found.push(case.refuse(s::K_B.id, what, "not used", "add [cases.brake], or remove it"));
                }
                (k_b, _) => self.holds.extend(k_b.map(|k_b| CaseHold { k_b })),
            }
        }
    }

    /// One of two ways, each with quantities of its own.
    fn take_start(&mut self, table: &Values, start: &Values, found: &mut Vec<Diagnostic>) {
        let Some(motor) = &self.motor else {
            if table.table("motor").is_none() {
                let help = "add [cases.motor]: it is this that starts";
                found.push(table.refuse("start", "a start without a motor", "of no motor", help));
            }
            return;
        };
        let slips = start.text("kind") == Some("slip");
        let (kind, other) = if slips {
            ("slip", "inverter")
        } else {
            ("inverter", "slip")
        };
        let mut own = [[&s::LAMBDA_BD, &s::N_0], [&s::T_R, &s::LAMBDA_INV]];
        if !slips {
            own.reverse();
        }
        for symbol in own[0].into_iter().filter(|symbol| !start.has(symbol.id)) {
            let (what, help) = (
                format!("a start of kind \"{kind}\" without {}", symbol.id),
                format!("add {} = \"... {}\"  ({})", symbol.id, symbol.display.name, symbol.text),
            );
            found.push(start.refuse("kind", what, format!("{} is needed", symbol.id), help));
        }
        for symbol in own[1].into_iter().filter(|symbol| start.has(symbol.id)) {
            let what = format!("{} belongs to a start of kind \"{other}\"", symbol.id);
            found.push(start.refuse(symbol.id, what, "not used", "remove it, or change kind"));
        }
        let number = |symbol: &'static Symbol| start.number(symbol.id);
        if slips {
            self.slip = SlipStart::of(number);
        } else {
            self.inverter = InverterStart::of(number);
        }
        if let Some(slip) = self.slip.filter(|slip| slip.n_0 <= motor.n_n) {
            let what = format!(
                "n_0 = {} is not above n_N = {}",
                s::N_0.written(slip.n_0),
                s::N_N.written(motor.n_n)
            );
            let help = "give the synchronous speed: a motor at its rated power turns more slowly";
            found.push(start.refuse(s::N_0.id, what, "no slip", help));
        }
    }

    fn take_heating(&mut self, table: &Values, motor: &Values, names: &[Text], found: &mut Vec<Diagnostic>) {
        let names: Vec<&str> = names.iter().map(|name| name.english()).collect();
        let Some(case) = named(motor, "heating", "case", &names, found) else {
            return;
        };
        if table.tables("case")[case].number(s::V_S.id) == Some(0.0) {
            let what = format!("in case \"{}\" nothing moves: it heats no motor", names[case]);
            found.push(motor.refuse("heating", what, "at rest", "name a case with a speed v_s"));
        }
        self.heating = Some(case);
    }
}

/// The place of a name among those that a mechanism knows; a mistake goes to `found`.
pub fn named(table: &Values, key: &str, what: &str, known: &[&str], found: &mut Vec<Diagnostic>) -> Option<usize> {
    let name = table.text(key)?;
    let place = known.iter().position(|known| *known == name);
    if place.is_none() {
        let message = format!("no {what} \"{name}\"");
        let help = format!("what there is: {}", known.join(", "));
        found.push(table.refuse(key, message, "there is none", help));
    }
    place
}
