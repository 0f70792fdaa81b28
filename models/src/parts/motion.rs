//! The working range of a mechanism's coordinate, and the run through it that is
//! the default experiment.

use std::f64::consts::TAU;

use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::measure;
use crate::kernel::number::short;
use crate::kernel::schema::{Key, SOURCE, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::kernel::unit::RAD;

/// More rows in a table than anyone reads, and than a step of `1e-9 deg` would make.
const MOST_ROWS: f64 = 10_000.0;

/// A position at which formulas are worked out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// By a name that the mechanism knows.
    Named(&'static str),
    /// A value of the coordinate, in SI.
    At(f64),
}

/// Working range of the coordinate, in SI.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    pub from: f64,
    pub to: f64,
    pub step: f64,
    pub speed: f64,
    /// Whether the part of the range is the only input for the coordinate.
    pub by_part: bool,
    /// After which all is as before: a turn of an angle, infinite of what does not turn.
    pub period: f64,
}

impl Motion {
    /// Keys of its table: the ends of the working range, the coordinate that tables step, and its rate, with what that is.
    #[must_use]
    pub const fn keys(
        ends: [&'static Symbol; 2],
        coordinate: &'static Symbol,
        (rate, what): (&'static Symbol, &'static str),
    ) -> [Key; 6] {
        [
            Key::quantity(ends[0], Sign::Any),
            Key::quantity(ends[1], Sign::Any),
            Key::named("step", coordinate, Sign::Positive, "Step of tables."),
            Key::named("speed", rate, Sign::Positive, what),
            Key::choice(
                "input",
                &["s"],
                "\"s\", the part of the working range from 0 to 1, as the only input for the coordinate: all inputs of the FMU \
                 may be zero then.",
            ),
            SOURCE,
        ]
    }

    /// Reads a checked table with `from`, `to`, `step` and `speed`; mistakes go to `found`.
    pub fn read(m: &Values, found: &mut Vec<Diagnostic>) -> Option<Motion> {
        let (coordinate, _) = m.own().into_iter().next()?;
        let motion = Motion {
            from: m.number("from")?,
            to: m.number("to")?,
            step: m.number("step")?,
            speed: m.number("speed")?,
            by_part: m.text("input").is_some(),
            period: if coordinate.unit == &RAD { TAU } else { f64::INFINITY },
        };
        let shown = |value| coordinate.written(value);
        let (from, to) = (shown(motion.from), shown(motion.to));
        if motion.from >= motion.to {
            let message = format!("the working range ends at {to} and starts at {from}");
            found.push(m.refuse("to", message, "not above `from`", "`from` must be smaller than `to`"));
            return None;
        }
        if (motion.to - motion.from) / motion.step > MOST_ROWS {
            let message = format!("the step {} is too small", shown(motion.step));
            let least = shown((motion.to - motion.from) / MOST_ROWS);
            found.push(m.refuse(
                "step",
                message,
                "too many rows",
                format!("a table may have {MOST_ROWS} rows: step at least {least}"),
            ));
            return None;
        }
        Some(motion)
    }

    /// A position as a scene writes it: one of `named`, or a value of the coordinate within the range, which
    /// the help calls `what`.
    ///
    /// # Errors
    /// Neither; with a message and help.
    pub fn place(
        &self,
        text: &str,
        coordinate: &'static Symbol,
        what: &str,
        named: &[&'static str],
    ) -> Result<Place, (String, String)> {
        if let Some(name) = named.iter().find(|name| **name == text) {
            return Ok(Place::Named(name));
        }
        let help = format!(
            "{what} such as \"{}\", or one of {}",
            coordinate.written(f64::midpoint(self.from, self.to)),
            named.join(", ")
        );
        let angle = measure::quantity(text, coordinate, Sign::Any)
            .map_err(|_| (format!("\"{text}\" is no position of this scene"), help.clone()))?;
        // A rounding of units is not a position outside.
        let within = angle.clamp(self.from, self.to);
        if (angle - within).abs() > 1e-12 {
            let (from, to) = (coordinate.written(self.from), coordinate.written(self.to));
            return Err((format!("{text} lies outside the working range {from} to {to}"), help));
        }
        Ok(Place::At(within))
    }

    /// The coordinate (rad) at a part of the range: exact at both ends.
    #[inline]
    #[must_use]
    pub fn at(&self, part: f64) -> f64 {
        self.from * (1.0 - part) + self.to * part
    }

    /// The part of the range at which a value of the coordinate (rad) lies.
    #[inline]
    #[must_use]
    pub fn part(&self, at: f64) -> f64 {
        (at - self.from) / (self.to - self.from)
    }

    /// The values of tables: every step from the start, and the end.
    #[must_use]
    pub fn angles(&self) -> Vec<f64> {
        let steps = ((self.to - self.from) / self.step).round().max(1.0);
        (0..=steps as u32)
            .map(|i| {
                if f64::from(i) == steps {
                    self.to
                } else {
                    self.from + f64::from(i) * self.step
                }
            })
            .collect()
    }

    /// The coordinate (rad) that runs through the working range by itself.
    #[inline]
    pub fn swept<C: Calc>(&self, omega: C, time: C) -> C {
        let theta = C::constant(self.from) + omega * time;
        // Not `clamp`: beyond an end the angle does not change any more.
        if theta.value() < self.from {
            C::constant(self.from)
        } else if theta.value() > self.to {
            C::constant(self.to)
        } else {
            theta
        }
    }

    /// Duration of one run through the working range, in s.
    #[must_use]
    pub fn stop_time(&self) -> f64 {
        nanosecond((self.to - self.from) / self.speed)
    }

    /// Time for one step of tables, in s.
    #[must_use]
    pub fn step_size(&self) -> f64 {
        nanosecond(self.step / self.speed)
    }
}

/// An angle (rad) for messages.
pub(crate) fn degrees(angle: f64) -> String {
    format!("{} deg", short(angle.to_degrees()))
}

/// A time without the rounding of angles: 60 s, not 59.999999999999993 s.
fn nanosecond(time: f64) -> f64 {
    let rounded = (time * 1e9).round() / 1e9;
    if rounded > 0.0 { rounded } else { time }
}

/// Refuses a step in a table that sees no more than a longer one: the shortest that may be given, and the one that is taken
/// where there is none (s).
#[must_use]
pub fn short_step(table: &Values, symbol: &Symbol, [least, taken]: [f64; 2]) -> Option<Diagnostic> {
    let step = table.number(symbol.id).filter(|step| *step < least)?;
    let what = format!(
        "step = {}, where {} sees all that the motion does",
        symbol.written(step),
        symbol.written(taken)
    );
    let help = format!(
        "give at least {}, below which only rounding adds up, or leave it out: {} is taken then",
        symbol.written(least),
        symbol.written(taken)
    );
    Some(table.refuse(symbol.id, what, "too short", help))
}
