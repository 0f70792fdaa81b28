//! What a scene says of how a motor starts.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::parts::motor::N_N;
use crate::parts::starts::{self as s, InverterStart, SlipStart};

/// Beside the motor.
pub const START: Key = Key::part("start", KEYS, "How the motor starts, besides by its mean torque.");

const KEYS: &[Key] = keys! { s:
    LAMBDA_BD > 0 [optional], N_0 > 0 [optional], T_R > 0 [optional], LAMBDA_INV > 0 [optional];
    Key::new("kind", Kind::Choice(&["slip", "inverter"]), "\"slip\", along the motor's own curve of torque over slip, or \"inverter\", which ramps its speed up.")
};

/// One of two ways, or neither.
#[derive(Clone, Copy, Debug, Default)]
pub struct MotorStart {
    pub slip: Option<SlipStart<f64>>,
    pub inverter: Option<InverterStart<f64>>,
}

impl MotorStart {
    /// Of the table of a start, which has the quantities of its own way alone, and of a motor with a rated speed (1/s); mistakes go
    /// to `found`.
    pub fn read(start: &Values, n_n: f64, found: &mut Vec<Diagnostic>) -> MotorStart {
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
        let read = MotorStart {
            slip: SlipStart::read(start).filter(|_| slips),
            inverter: InverterStart::read(start).filter(|_| !slips),
        };
        if let Some(slip) = read.slip.filter(|slip| slip.n_0 <= n_n) {
            let [own, rated] = [s::N_0.written(slip.n_0), N_N.written(n_n)];
            let what = format!("n_0 = {own} is not above n_N = {rated}");
            let help = "give the synchronous speed: a motor at its rated power turns more slowly";
            found.push(start.refuse(s::N_0.id, what, "no slip", help));
        }
        read
    }
}
