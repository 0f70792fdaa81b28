//! Whether motor and brakes are strong enough for their cases, all over the working range.

use crate::component::probe::slots;
use crate::component::running::Running;
use crate::component::standing::Standing;
use crate::component::telling::fine;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::luffing::resistances::scene::Cases;
use crate::luffing::resistances::symbols as s;
use crate::parts::starts::way::StartWay;

const STRONGER: &str = "give a stronger motor, or a smaller travel l_M of the drive for one turn";
const FASTER: &str = "give a motor that turns faster, or a greater travel l_M of the drive for one turn";
const OTHER: &str = "give another travel l_M of the drive for one turn, or another speed of the case";
const BRAKES: &str = "give stronger brakes, or a smaller travel l_M of the drive for one turn";

/// A result of a case (from 0) at a place.
struct Found {
    value: f64,
    case: usize,
    place: f64,
}

/// What is looked for in all cases, all over the range.
struct Looking<'a> {
    model: &'a Standing,
    cases: &'a Cases,
}

impl Looking<'_> {
    /// The greatest by amount, with its case and its place.
    fn most(&self, symbol: &'static Symbol) -> Option<Found> {
        let (mut part, coordinate) = (self.model.part().duplicate(), self.model.coordinate());
        let each: Vec<_> = slots(self.model, symbol).collect();
        let mut most: Option<Found> = None;
        for place in fine(self.model.motion()) {
            // What is known of the place where it stands stays known.
            if part.take(coordinate) != place {
                part.put(coordinate, place);
            }
            for (case, slot) in each.iter().enumerate() {
                let mut value = 0.0;
                let known = part.result(slot, &mut value).is_ok();
                if known
                    && most
                        .as_ref()
                        .is_none_or(|most| value.abs().total_cmp(&most.value.abs()).is_ge())
                {
                    most = Some(Found { value, case, place });
                }
            }
        }
        most
    }

    /// Another result of the same case at the same place.
    fn there(&self, symbol: &'static Symbol, found: &Found) -> Option<f64> {
        let mut part = self.model.part().duplicate();
        part.put(self.model.coordinate(), found.place);
        let slot = slots(self.model, symbol)
            .nth(found.case)
            .or(slots(self.model, symbol).next())?;
        let mut value = 0.0;
        part.result(&slot, &mut value).ok().map(|()| value)
    }

    fn said(&self, found: &Found) -> String {
        let coordinate = self.model.variables()[0].symbol;
        format!(
            "in case \"{}\" at {} = {}",
            self.cases.names[found.case].english(),
            coordinate.id,
            coordinate.written(found.place)
        )
    }

    /// Where a start takes for ever: where most resists, if it does there.
    fn never(&self, time: &'static Symbol) -> Option<Found> {
        let found = self.most(time).filter(|found| found.value.is_infinite())?;
        let most = self.most(&s::T_0)?;
        let there = self.there(time, &most).is_some_and(f64::is_infinite);
        Some(if there { most } else { found })
    }

    /// A start that takes for ever, with its key: what the motor gives, and what resists; what is wrong with it, and help.
    fn starts(&self) -> Option<(&'static str, String, [&'static str; 2])> {
        const WEAK: [&str; 2] = ["too weak", STRONGER];
        let motor = self.cases.motor.as_ref()?;
        let mean = motor.k_a * motor.rated();
        if let Some(found) = self.most(&s::T_0).filter(|found| found.value >= mean) {
            return Some(("motor", self.resists(&found, "it gives", mean), WEAK));
        }
        if let Some(found) = self.never(&s::T_SLIP) {
            let [slip, least] = [&s::S_F, &s::T_LEAST].map(|symbol| self.there(symbol, &found).unwrap_or(0.0));
            if slip <= 0.0 {
                let full = match &self.cases.start {
                    Some(StartWay::SlipStart(slip)) => slip.n_0,
                    _ => 0.0,
                };
                let limit = format!("which is not below n_0 = {}", s::N_0.written(full));
                return Some(("start", self.turns(&found, &limit), ["too slow", FASTER]));
            }
            let stalled = self.there(&s::T_BD, &found).zip(self.there(&s::S_K, &found));
            let ends = stalled.map(|(breakdown, at)| breakdown * 2.0 / (at + 1.0 / at));
            let weakest = if ends.is_some_and(|start| start <= least) {
                1.0
            } else {
                slip
            };
            let gives = format!("at slip {} it gives", s::S_F.written(weakest));
            return Some(("start", self.resists(&found, &gives, least), WEAK));
        }
        if let Some(found) = self.never(&s::T_INV) {
            let limit = self.there(&s::T_U, &found).unwrap_or(0.0);
            return Some(("start", self.resists(&found, "the inverter lets it give", limit), WEAK));
        }
        self.runs(WEAK)
    }

    /// The same of an engine, which runs at some speeds alone; what is said of one that is too weak.
    fn runs(&self, weak: [&'static str; 2]) -> Option<(&'static str, String, [&'static str; 2])> {
        let Some(StartWay::EngineStart(engine)) = &self.cases.start else {
            return None;
        };
        let found = self.never(&s::T_ENG)?;
        if !engine.runs(self.there(&s::N_MOT, &found).unwrap_or(0.0).abs()) {
            let [idle, most] = [engine.speeds.idle, engine.speeds.most].map(|n| s::N_MOT.written(n));
            let limit = format!("and it runs from n_idle = {idle} to n_gov = {most}");
            return Some(("start", self.turns(&found, &limit), ["not so", OTHER]));
        }
        let gives = format!(
            "an engine of {} at most gives on its way",
            s::T_0.written(engine.most(engine.speeds.most))
        );
        let least = self.there(&s::T_E_LEAST, &found).unwrap_or(0.0);
        Some(("start", self.resists(&found, &gives, least), weak))
    }

    fn turns(&self, found: &Found, limit: &str) -> String {
        let turns = self.there(&s::N_MOT, found).unwrap_or(0.0).abs();
        format!(
            "{} the motor would have to turn at {}, {limit}",
            self.said(found),
            s::N_MOT.written(turns)
        )
    }

    fn resists(&self, found: &Found, gives: &str, torque: f64) -> String {
        format!(
            "the motor cannot start {}: {gives} {} where {} resist",
            self.said(found),
            s::T_0.written(torque),
            s::T_0.written(self.there(&s::T_0, found).unwrap_or(0.0))
        )
    }

    /// Brakes that cannot hold, or do not stop.
    fn brakes(&self) -> Option<String> {
        let (motor, brake) = (self.cases.motor.as_ref()?, self.cases.brake?);
        let brakes = brake.torque + self.cases.second.map_or(0.0, |brake| brake.torque);
        let pulls = |found: &Found| found.value.abs() * motor.eta;
        if let Some(found) = self.most(&s::T_H).filter(|found| pulls(found) >= brakes) {
            return Some(format!(
                "the brakes cannot hold {}: they have {} where {} pull",
                self.said(&found),
                s::T_H.written(brakes),
                s::T_H.written(pulls(&found))
            ));
        }
        let found = self.most(&s::T_STOP).filter(|found| found.value.is_infinite())?;
        Some(format!("the brakes do not stop the drive {}", self.said(&found)))
    }
}

/// Refuses a motor that cannot start, and brakes that cannot hold or stop, somewhere in the working range.
pub(super) fn able(model: &Standing, cases: &Cases, v: &Values, found: &mut Vec<Diagnostic>) {
    let (looking, table) = (Looking { model, cases }, v.table("cases").unwrap_or(v));
    if let Some((key, what, [label, help])) = looking.starts() {
        found.push(table.refuse(key, what, label, help));
    }
    if let Some(what) = looking.brakes() {
        found.push(table.refuse("brake", what, "too weak", BRAKES));
    }
}
