//! Which event indicators fell below zero in a run, and when: found again on a copy of the model, so that the run itself is
//! the same whether anybody asks or not.

use lemnis_models::component::model::Model;
use lemnis_models::component::running::{Running, State};
use lemnis_models::kernel::variable::{Fault, Role};

/// What was located on the way.
pub struct Event {
    /// In s.
    pub time: f64,
    /// The indicator, as a variable by its index.
    pub indicator: usize,
}

/// Part of a step that lies between its beginning and where it is looked for events: what is decided at the beginning, at a
/// change of inputs say, was not on the way.
const BEGINNING: f64 = 1e-9;
/// Part of a step over which it is seen how fast an indicator falls.
const FALL: f64 = 1e-6;
/// Halvings of a step, to the last bits of the time.
const HALVINGS: u32 = 52;

/// Looks for events in steps that a model of the same scene has made.
pub struct Finder {
    model: Model,
    indicators: Vec<usize>,
}

/// A step that was made.
struct Step<'a> {
    before: &'a State,
    from: f64,
}

impl Finder {
    pub fn new(model: &Model) -> Finder {
        let all = model.variables().iter().enumerate();
        let indicators = all.filter(|(_, variable)| variable.role == Role::Indicator);
        Finder {
            indicators: indicators.map(|(index, _)| index).collect(),
            model: model.clone(),
        }
    }

    /// How many were located by a time (s) of a step; the model stands there then.
    fn count(&mut self, step: &Step<'_>, time: f64) -> Result<u32, Fault> {
        self.model.set_state(step.before);
        let before = self.model.count().events;
        self.model.advance(step.from, time)?;
        Ok(self.model.count().events - before)
    }

    /// All indicators at a time (s) of a step.
    fn at(&mut self, step: &Step<'_>, time: f64) -> Result<Vec<f64>, Fault> {
        self.count(step, time)?;
        let mut values = vec![0.0; self.indicators.len()];
        // Infinite ones do not fall.
        let running: &mut dyn Running = &mut *self.model;
        running.event_indicators(&mut values)?;
        Ok(values)
    }

    /// The indicator that vanishes first after a time (s), by how it fell in the last `span` (s) before.
    fn falling(&mut self, step: &Step<'_>, time: f64, span: f64) -> Result<Option<usize>, Fault> {
        let (earlier, now) = (self.at(step, time - span)?, self.at(step, time)?);
        let left = |(earlier, now): (f64, f64)| (earlier > now && now >= 0.0).then(|| now / (earlier - now));
        let each = self.indicators.iter().zip(earlier.into_iter().zip(now));
        let each = each.filter_map(|(index, pair)| Some((*index, left(pair)?)));
        Ok(each
            .min_by(|(_, one), (_, other)| one.total_cmp(other))
            .map(|(index, _)| index))
    }

    /// The events of a step between two times (s) that began in a state and met `count` of them or less, in their order.
    ///
    /// # Errors
    /// A part of the step that cannot be made again.
    pub fn find(&mut self, before: &State, [from, to]: [f64; 2], count: u32) -> Result<Vec<Event>, Fault> {
        let (mut found, step) = (Vec::new(), Step { before, from });
        let beginning = (to - from) * BEGINNING;
        let mut earlier = from + beginning;
        let mut known = self.count(&step, earlier)?;
        while known < count {
            let (mut short_of, mut beyond) = (earlier, to);
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(short_of, beyond);
                if middle <= short_of || middle >= beyond {
                    break;
                }
                if self.count(&step, middle)? > known {
                    beyond = middle;
                } else {
                    short_of = middle;
                }
            }
            let span = ((to - from) * FALL).min((short_of - from) / 2.0);
            if let Some(indicator) = self.falling(&step, short_of, span)? {
                found.push(Event {
                    time: beyond,
                    indicator,
                });
            }
            let by_then = self.count(&step, beyond)?;
            if by_then <= known {
                break;
            }
            (earlier, known) = (beyond, by_then);
        }
        Ok(found)
    }
}
