//! A motion under commands over time. Between two breaks every command is constant or straight, and the motion is solved
//! on a grid that begins at the last one. What lies between two times of the grid is solved from the one before it, and
//! dropped: no communication step changes a bit of what follows. A command has its new value from a break on.

use crate::component::moving::MovingComponent;
use crate::component::moving::commands::{Commands, Followed, Ramp, Told};
use crate::component::running::Running;
use crate::component::stages::Source;
use crate::component::standing::VariablePlace;
use crate::kernel::course::Course;
use crate::kernel::number::short;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Fault, Name, Quantity, Role, TIME};
use crate::parts::solver::MOST_STEPS;

/// Times that are no further apart than this part of a step of the grid are one: importers add up steps.
const SAME: f64 = 1e-9;

/// Steps of the grid between two breaks, at least. What lies between two of its times is solved again in each
/// communication step, and an event there is located again: of a coarse grid that would be many times.
const FINE: f64 = 32.0;

impl MovingComponent {
    /// Under commands over time, as far as they are inputs of it.
    ///
    /// # Errors
    /// A motion that cannot begin under them.
    pub fn commanded(mut self, courses: &[(&'static Symbol, Course)]) -> Result<MovingComponent, Fault> {
        let mut told = Vec::new();
        for (symbol, course) in courses {
            let all = self.standing.variables().iter().zip(self.standing.places());
            let mut inputs = all.enumerate().filter_map(|(index, (variable, place))| match place {
                VariablePlace::Source(source) if variable.symbol == *symbol && variable.role == Role::Input => {
                    Some((*source, index))
                }
                _ => None,
            });
            told.extend(inputs.next().map(|(source, index)| Told {
                source,
                index,
                rate: self.rate_of(symbol),
                course: course.clone(),
            }));
        }
        if told.is_empty() {
            return Ok(self);
        }
        for Told { index, .. } in &told {
            self.standing.follow_commands(*index);
        }
        let mut breaks: Vec<f64> = told
            .iter()
            .flat_map(|told| told.course.rows.iter().map(|row| row[0]))
            .collect();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        self.commands = Some(Commands {
            told: told.into(),
            breaks: breaks.into(),
            now: Followed::START,
        });
        self.pass(0.0)?;
        Ok(self)
    }

    /// Where the rate of a command stands, of which something follows: by its name, as that of a state.
    fn rate_of(&self, command: &Symbol) -> Option<Source> {
        let rate = format!("der({})", command.id);
        let all = self.standing.part().sources();
        let own =
            |(source, (symbol, _)): &(Source, Quantity)| symbol.id == rate && self.standing.memory().contains(source);
        all.into_iter().find(own).map(|(source, _)| source)
    }

    /// The same with its commands as inputs.
    #[must_use]
    pub fn freed(&self) -> MovingComponent {
        let mut free = self.clone();
        if let Some(commands) = free.commands.take() {
            for Told { index, .. } in commands.told.iter() {
                free.standing.free(*index);
            }
        }
        free
    }

    /// Which variables are told over time, by their indices, each with its name.
    #[must_use]
    pub fn told(&self) -> Vec<(usize, Name)> {
        let told = self.commands.iter().flat_map(|commands| commands.told.iter());
        let named = told.map(|Told { index, .. }| {
            let (symbol, number) = self.standing.variables()[*index].quantity();
            (*index, (symbol.id, number))
        });
        named.collect()
    }

    /// Puts the commands of a time (s), which is no later than the next break.
    pub(super) fn command(&mut self, time: f64) {
        let Some(commands) = &self.commands else { return };
        for (ramp, rate) in commands.at(time) {
            let part = self.standing.part_mut();
            let all = [(Some(ramp.source), ramp.value), (rate, ramp.slope)];
            for (source, value) in all.into_iter().filter_map(|(source, value)| Some((source?, value))) {
                if part.take(source) != value {
                    part.put(source, value);
                }
            }
        }
    }

    /// The breaks up to a time (s) pass, and it is decided what follows; returns whether a state jumped.
    pub(super) fn pass(&mut self, time: f64) -> Result<bool, Fault> {
        let near = SAME * self.carrier.longest(&self.standing);
        if let Some(commands) = &mut self.commands {
            let passed = commands.breaks.partition_point(|at| *at <= time + near);
            if passed != commands.now.passed {
                commands.now.passed = passed;
                let first = commands.told[0].index;
                self.command(time);
                self.carrier.changed(&mut self.standing, Some(first));
            }
        }
        self.carrier.event(&mut self.standing)
    }

    /// What was shown is no more: it goes on from there.
    pub(super) fn interrupt(&mut self) {
        if let Some(commands) = &mut self.commands {
            commands.now.shown = f64::NEG_INFINITY;
        }
    }

    /// Moves on between two times of which no break lies between, both in s.
    fn piece(&mut self, [from, to]: [f64; 2]) -> Result<(), Fault> {
        self.command(from);
        let ramps = self.commands.iter().flat_map(|commands| commands.at(from));
        let ramps = ramps.map(|(ramp, _)| ramp);
        let ramps: Vec<Ramp> = ramps.filter(|ramp| ramp.slope != 0.0).collect();
        self.carrier.advance(&mut self.standing, [from, to], &ramps)?;
        self.command(to);
        Ok(())
    }

    /// As [`Running::advance`] under commands, followed so far; what fails leaves it anywhere.
    pub(super) fn follow(&mut self, mut now: Followed, [from, to]: [f64; 2]) -> Result<(), Fault> {
        let longest = self.carrier.longest(&self.standing);
        let near = SAME * longest;
        if (to - from) / longest > f64::from(MOST_STEPS) {
            return Err(Fault::outside(format!(
                "the step of {} s needs more than the {MOST_STEPS} inner steps that are allowed, at step = {} s: take \
                 smaller communication steps, or a longer step",
                short(to - from),
                short(longest)
            )));
        }
        if from != now.shown {
            (now.begun, now.steps, now.time) = (from, 0.0, from);
        } else if !now.kept.is_empty() {
            let kept = self.own_state_of(&now.kept)?;
            self.set_own_state(&kept);
        }
        now.kept.clear();
        let mut next_break = self.next_break();
        loop {
            let between = next_break.map_or(longest, |at| (at - now.begun) / FINE);
            let next = now.begun + (now.steps + 1.0) * between.min(longest);
            let end = next_break.filter(|at| *at <= next + near).unwrap_or(next);
            if end > to + near {
                break;
            }
            self.piece([now.time, end])?;
            (now.time, now.steps) = (end, now.steps + 1.0);
            if next_break == Some(end) {
                self.pass(end)?;
                (now.begun, now.steps) = (end, 0.0);
                next_break = self.next_break();
            }
        }
        if to > now.time + near {
            now.kept = self.own_numbers();
            self.piece([now.time, to])?;
        }
        now.shown = to;
        self.standing.set_time(to);
        if let Some(commands) = &mut self.commands {
            now.passed = commands.now.passed;
            commands.now = now;
        }
        Ok(())
    }

    /// How fast a quantity changes in a direction: one that is told over time with the time alone.
    pub(super) fn seed(&self, (symbol, number): Quantity, seed: &dyn Fn(Quantity) -> f64) -> f64 {
        let time = self.standing.time();
        let known = |told: &Told| self.standing.variables()[told.index].quantity() == (symbol, number);
        let own = self.commands.as_ref().and_then(|commands| {
            let place = commands.told.iter().position(known)?;
            commands.at(time).nth(place)
        });
        own.map_or_else(|| seed((symbol, number)), |(ramp, _)| ramp.slope * seed((&TIME, None)))
    }

    /// That a command which is told over time cannot be set.
    pub(super) fn not_told(&self, index: usize) -> Result<(), Fault> {
        let told = self.commands.as_ref().is_some_and(|commands| commands.is_told(index));
        let refused = || {
            let variable = &self.standing.variables()[index];
            Fault::new(format!(
                "{variable} is told over time by the scene and cannot be set: give it one value there to make it an input"
            ))
        };
        if told { Err(refused()) } else { Ok(()) }
    }
}
