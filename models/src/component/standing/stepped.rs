//! What stands still, as whatever runs is stepped.

use crate::component::part::Port;
use crate::component::running::{Running, State, Tangent};
use crate::component::spread::Spread;
use crate::component::standing::{Direction, Now, Standing, VariablePlace};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Fault, PART_OF_RANGE, Quantity, Role, Terminal, Type, Variable};

/// How a saved state tells that the part of the range was set last.
const BY_PART: f64 = 2.0;

impl Standing {
    /// With the part of the range as an input beside the coordinate, or in its place.
    #[must_use]
    pub fn with_part_of_range(mut self) -> Standing {
        self.variables.push(Variable {
            bounds: [0.0, 1.0],
            ..Variable::new((&PART_OF_RANGE, None), Role::Input)
        });
        self.places.push(VariablePlace::Part);
        if self.motion.by_part {
            let coordinate = self.coordinate_index();
            self.variables[coordinate].role = Role::Output;
        }
        self
    }

    /// With the states of its motion, and their rates, in the place of inputs and results.
    #[must_use]
    pub fn with_states(mut self) -> Standing {
        let [states, rates] = self.now.part.states();
        for (variable, place) in self.variables.iter_mut().zip(&self.places) {
            if states.contains(&variable.symbol) && matches!(place, VariablePlace::Source(_)) {
                variable.role = Role::State;
            } else if rates.contains(&variable.symbol) {
                variable.role = Role::Rate;
            }
        }
        // Then it does not run by itself through its working range.
        self.now.given = self.has_moving_coordinate();
        self
    }

    /// An input follows commands over time: it is a result.
    pub(crate) fn follow_commands(&mut self, index: usize) {
        self.variables[index].role = Role::Output;
    }

    /// It is an input again.
    pub(crate) fn free(&mut self, index: usize) {
        self.variables[index].role = Role::Input;
    }

    /// Whether the coordinate is a state.
    #[must_use]
    pub fn has_moving_coordinate(&self) -> bool {
        self.variables[self.coordinate_index()].role == Role::State
    }

    /// Whether the part of the range is an input.
    #[must_use]
    pub fn has_part_of_range(&self) -> bool {
        matches!(self.places.last(), Some(VariablePlace::Part))
    }

    /// Finds an integral over the range, and with it those of the results beside its own, which come with that at each place.
    fn find_integral(&mut self, place: usize) -> Result<(), Fault> {
        let spots = &self.now.spots;
        let all = self.wholes.iter().enumerate();
        let beside = all.filter(|(i, other)| spots[*i].is_none() && other.is_beside(&self.wholes[place]));
        let (open, spreads): (Vec<usize>, Vec<&Spread>) = beside.unzip();
        let found = Spread::find_integrals(&spreads, &*self.now.part, &self.motion).map_err(|fault| *fault)?;
        for (place, spot) in open.into_iter().zip(found) {
            self.now.spots[place] = Some(spot);
        }
        Ok(())
    }
}

impl Running for Standing {
    #[inline]
    fn variables(&self) -> &[Variable] {
        &self.variables
    }

    fn terminals(&self) -> Vec<Terminal> {
        let terminal = |port: &Port, number: Option<u16>| {
            let find = |(symbol, member): &(&'static Symbol, &'static str)| {
                let of = |v: &&Variable| v.symbol == *symbol && (v.number == number || v.number.is_none());
                // A shaft is turned by an input, or moves by itself; another bar's angle is a result.
                let turned =
                    |v: &&Variable| matches!(v.role, Role::Input | Role::State) || !port.driven.contains(member);
                let found = self.variables.iter().filter(of).find(turned)?;
                Some((found.name(), *member))
            };
            Terminal {
                name: number.map_or_else(|| port.name.to_owned(), |number| format!("{}_{number}", port.name)),
                text: port.text,
                members: port.members.iter().filter_map(find).collect(),
            }
        };
        let mut list = Vec::new();
        for port in self.now.part.ports() {
            let numbers = self
                .variables
                .iter()
                .filter(|v| port.members.iter().any(|(symbol, _)| *symbol == v.symbol));
            let most = numbers.filter_map(|v| v.number).max();
            match most {
                None => list.push(terminal(port, None)),
                Some(most) => list.extend((1..=most).map(|number| terminal(port, Some(number)))),
            }
        }
        list.retain(|terminal| !terminal.members.is_empty());
        list
    }

    fn positions(&self) -> Vec<f64> {
        self.motion.angles()
    }

    fn stop_time(&self) -> f64 {
        self.motion.stop_time()
    }

    fn step_size(&self) -> f64 {
        self.motion.step_size()
    }

    #[inline]
    fn get(&mut self, index: usize) -> Result<f64, Fault> {
        let Some(&place) = self.places.get(index) else {
            return Err(Fault::no_variable(index, self.places.len()));
        };
        let mut value = 0.0;
        match place {
            VariablePlace::Source(source) => value = self.now.part.take(source),
            VariablePlace::Part => {
                let at = || self.motion.part(self.now.part.take(self.axes.coordinate));
                value = self.now.at_part.unwrap_or_else(at);
            }
            VariablePlace::Result(slot) => {
                if self.table.is_some()
                    && let Some(value) = self.interpolated(index)?
                {
                    return Ok(value);
                }
                self.now.part.result(&slot, &mut value).map_err(|fault| *fault)?;
            }
            VariablePlace::Whole(place) => {
                if self.wholes[place].is_integral() && self.now.spots[place].is_none() {
                    self.find_integral(place)?;
                }
                let spot = self.spot(place)?;
                self.now.spots[place] = Some(spot);
                return Ok(spot.value);
            }
        }
        Ok(value)
    }

    fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        let (place, variable) = (self.find(index)?, &self.variables[index]);
        match (place, variable.role) {
            (VariablePlace::Result(_) | VariablePlace::Whole(_), _) => {
                Err(Fault::new(format!("{variable} is a result and cannot be set")))
            }
            (VariablePlace::Source(_), Role::Output) => Err(Fault::new(format!(
                "{variable} follows from {} and cannot be set: leave out input = \"{}\" in the scene",
                PART_OF_RANGE.id, PART_OF_RANGE.id
            ))),
            (_, Role::Calculated) => Err(Fault::new(format!(
                "{variable} is fixed in the table and cannot be set: set fidelity = \"static\" to change it"
            ))),
            (VariablePlace::Part, _) => {
                variable.check(value)?;
                self.variables[self.coordinate_index()].check(self.motion.at(value))
            }
            _ => variable.check(value),
        }
    }

    fn place(&mut self, value: f64) -> Result<(), Fault> {
        self.variables[self.coordinate_index()].check(value)?;
        self.now.part.put(self.axes.coordinate, value);
        (self.now.given, self.now.at_part) = (true, None);
        Ok(())
    }

    fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        self.check(index, value)?;
        let VariablePlace::Source(source) = self.places[index] else {
            if matches!(self.places[index], VariablePlace::Part) {
                self.now.part.put(self.axes.coordinate, self.motion.at(value));
                (self.now.given, self.now.at_part) = (true, Some(value));
            }
            return Ok(());
        };
        let state = &mut self.now;
        // An importer that repeats itself changes nothing.
        if state.part.take(source).to_bits() != value.to_bits() {
            if self.variables[index].kind != Type::Real {
                state.part.leave();
            }
            if self.follow >> source.group & 1 == 1 {
                state.forget(source, &self.wholes);
            }
            state.part.put(source, value);
        }
        if source == self.axes.coordinate {
            (state.given, state.at_part) = (true, None);
        }
        if source == self.axes.rate {
            self.sweep();
        }
        Ok(())
    }

    #[inline]
    fn set_time(&mut self, time: f64) {
        if time != self.now.time {
            self.now.time = time;
            if let Some(clock) = self.clock {
                self.now.part.put(clock, time);
            }
            self.sweep();
        }
    }

    fn start(&mut self) -> Result<(), Fault> {
        self.now.part.start();
        self.update()
    }

    fn update(&mut self) -> Result<(), Fault> {
        match &self.table {
            Some(table) => self.tabulated(table),
            None => self.now.part.update().map_err(|fault| *fault),
        }
    }

    fn indicators(&self) -> usize {
        self.indicators.len()
    }

    fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        for (i, indicator) in indicators.iter_mut().enumerate() {
            *indicator = self.get(self.indicators[i])?;
        }
        Ok(())
    }

    fn state(&self) -> State {
        State::new(self.now.clone())
    }

    fn state_into(&self, state: &mut State) {
        state.own_mut::<Now>().follow(&self.now);
    }

    fn set_state(&mut self, state: &State) {
        self.now.follow(state.own());
    }

    fn numbers(&self, state: &State) -> Vec<f64> {
        let now: &Now = state.own();
        let way = now.at_part.map_or(f64::from(now.given), |_| BY_PART);
        let head = [now.time, way, now.at_part.unwrap_or(0.0)];
        let head = &head[..2 + usize::from(self.has_part_of_range())];
        head.iter()
            .copied()
            .chain(self.saved().map(|source| now.part.take(source)))
            .collect()
    }

    fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        let wrong = || Fault::new("a saved state does not belong to this model");
        let [time, given, values @ ..] = numbers else {
            return Err(wrong());
        };
        let (at_part, values) = match (self.has_part_of_range(), values) {
            (true, [part, values @ ..]) => ((*given == BY_PART).then_some(*part), values),
            (true, []) => return Err(wrong()),
            (false, _) => (None, values),
        };
        if values.len() != self.saved().count() || !time.is_finite() {
            return Err(wrong());
        }
        let (remembered, values) = values.split_at(self.memory.len());
        if remembered.iter().any(|value| value.is_nan()) {
            return Err(wrong());
        }
        let mut model = self.clone();
        let settable = (0..self.places.len()).filter(|&index| {
            matches!(self.places[index], VariablePlace::Source(_)) && self.variables[index].role != Role::Calculated
        });
        for (index, &value) in settable.zip(values) {
            self.variables[index].check(value)?;
        }
        if let Some(part) = at_part {
            PART_OF_RANGE.range.allows(part).then_some(()).ok_or_else(wrong)?;
        }
        for (source, &value) in self.saved().zip(remembered.iter().chain(values)) {
            model.now.part.put(source, value);
            model.now.forget(source, &self.wholes);
        }
        if let Some(clock) = self.clock {
            model.now.part.put(clock, *time);
        }
        (model.now.time, model.now.given, model.now.at_part) = (*time, *given != 0.0, at_part);
        Ok(State::new(model.now))
    }

    fn has_derivatives(&self) -> bool {
        let part = &self.now.part;
        let mut stages = (0..).zip(part.stages());
        !stages.any(|(place, stage)| stage.searched && part.exists(place))
    }

    fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent {
        let mut seeds = self.seeds(seed);
        let part = &self.now.part;
        let (face, moved) = part.dual(true, &mut |source, quantity| seeds.of(source, quantity));
        let undoes = seeds.undoes;
        Tangent::new(Direction { face, moved, undoes })
    }

    fn tangent_into(&self, seed: &dyn Fn(Quantity) -> f64, tangent: &mut Tangent) {
        let mut seeds = self.seeds(seed);
        let Direction { face, moved, undoes } = tangent.own_mut();
        let part = &self.now.part;
        *moved = part.dual_into(&mut **face, &self.sources, &mut |source, quantity| {
            seeds.of(source, quantity)
        });
        *undoes = seeds.undoes;
    }

    fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        Ok(self.with_derivative(tangent, index)?.eps)
    }

    fn duplicate(&self) -> Box<dyn Running> {
        Box::new(self.clone())
    }
}
