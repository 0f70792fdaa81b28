//! What a scene says of the motor and the brakes that work its cases.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::text::Text;
use crate::luffing::resistances::given::{CaseBrake, CaseHold, CaseMotor, SecondBrake};
use crate::luffing::resistances::symbols as s;
use crate::parts::starts::scene::read;
use crate::parts::starts::way::StartWay;

/// Beside the cases.
pub const MOTOR: Key = Key::part("motor", MOTOR_KEYS, "The motor that works the drive.");
pub const BRAKE: Key = Key::part("brake", BRAKE_KEYS, "The brake on the motor's shaft.");
pub const SECOND: Key = Key::part("second_brake", SECOND_KEYS, "Another brake there, which acts after it.");

const MOTOR_KEYS: &[Key] = keys! { s:
    P_N > 0, N_N > 0, LAMBDA_M > 0, K_A > 0, J_M > 0, L_M > 0, ETA_M > 0;
    Key::new("heating", Kind::Name, "The case for whose motion in and out the heating of the motor is asked.")
};

const BRAKE_KEYS: &[Key] = keys! { s: T_B > 0, TAU_B >= 0 };

const SECOND_KEYS: &[Key] = keys! { s: T_B2 > 0, TAU_B2 >= 0 };

/// Motor and brakes of a scene.
#[derive(Default)]
pub struct Train {
    pub motor: Option<CaseMotor<f64>>,
    pub start: Option<StartWay<f64>>,
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

    fn take_start(&mut self, table: &Values, start: &Values, found: &mut Vec<Diagnostic>) {
        if let Some(motor) = &self.motor {
            self.start = read(start, motor.n_n, found);
        } else if table.table("motor").is_none() {
            let help = "add [cases.motor]: it is this that starts";
            found.push(table.refuse("start", "a start without a motor", "of no motor", help));
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
