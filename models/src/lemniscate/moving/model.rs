//! The mechanism in motion as a running model: commands and parameters in,
//! states and results out. What follows from angle and angular velocity alone
//! comes from the algebraic model of the same scene.

use std::collections::BTreeSet;

use crate::lemniscate::dynamics::{Bodies, Body, Dynamics, Pendulum};
use crate::lemniscate::geometry::{Driven, Geometry};
use crate::lemniscate::model::{Model as Algebraic, State as AlgebraicState};
use crate::lemniscate::motion::{self, Bar, Commands, Friction, INDICATORS, Motion, STATES};
use crate::lemniscate::moving::scene::{Constants, KEYS, Moving, Rope};
use crate::lemniscate::moving::symbols as m;
use crate::lemniscate::scene::Luffing;
use crate::lemniscate::symbols as s;
use crate::model::{Fault, Name, Role, TIME, Terminal, Type, Variable};
use crate::plane::Point;
use crate::schema::{Kind, Sign, short};
use crate::solver::Halt;
use crate::symbol::Symbol;

/// A scene's mechanism in motion.
#[derive(Clone, Debug)]
pub struct Model {
    algebraic: Algebraic,
    driven: Driven,
    stops: [f64; 2],
    rope: Option<Rope>,
    variables: Vec<Variable>,
    slots: Vec<Slot>,
    signs: Vec<Sign>,
    /// Follows from the parameters; `None` after one has changed.
    motion: Option<Motion>,
    state: State,
}

/// All that changes in a model while it runs.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// In s.
    time: f64,
    motion: motion::State,
    commands: Commands,
    constants: Constants<f64>,
    algebraic: AlgebraicState,
}

#[derive(Clone, Copy, Debug)]
enum Slot {
    State(usize),
    Rate(usize),
    Indicator(usize),
    Moment,
    Brake,
    Hoist,
    Constant,
    FrictionMoment,
    RopeForce,
    /// Index of a variable of the algebraic model.
    Algebraic(usize),
}

impl Model {
    /// # Errors
    /// Never for a scene that was read, which checks that the mechanism exists over its range.
    pub fn new(luffing: &Luffing, moving: &Moving) -> Result<Model, Fault> {
        let algebraic = Algebraic::new(luffing)?;
        let length = moving.rope.map_or(0.0, |rope| rope.length);
        let mut start = motion::State::resting(luffing.motion.from, length);
        start.y[2] = moving.rope.map_or(0.0, |rope| rope.swing);
        let mut model = Model {
            driven: luffing.parameters.driven,
            stops: [luffing.motion.from, luffing.motion.to],
            rope: moving.rope,
            variables: Vec::new(),
            slots: Vec::new(),
            signs: Vec::new(),
            motion: None,
            state: State {
                time: 0.0,
                motion: start,
                commands: moving.commands,
                constants: moving.constants,
                algebraic: *algebraic.state(),
            },
            algebraic,
        };
        for (variable, slot) in model.list() {
            model.variables.push(variable);
            model.slots.push(slot);
            model.signs.push(allowed(variable.symbol));
        }
        model.update()?;
        Ok(model)
    }

    /// Variables of a scene: the coordinate first, then commands, constants and results of motion,
    /// then those of the algebraic model, then rates and event indicators.
    fn list(&self) -> Vec<(Variable, Slot)> {
        let mut list = Vec::new();
        let of = |symbol: &'static Symbol, role| Variable {
            symbol,
            number: None,
            role,
            kind: Type::Real,
            bounds: match allowed(symbol) {
                Sign::Any => [f64::NEG_INFINITY, f64::INFINITY],
                _ => [0.0, f64::INFINITY],
            },
        };
        let boom = self.driven == Driven::Boom;
        let coordinate = if boom {
            [&s::THETA_1, &s::OMEGA_1]
        } else {
            [&s::THETA_3, &s::OMEGA_3]
        };
        let rope = [&m::PHI, &m::OMEGA_PHI, &m::L_R, &m::S_Q, &m::V_Q];
        let states: Vec<&'static Symbol> = coordinate.into_iter().chain(rope).take(self.states()).collect();
        for (i, symbol) in states.iter().enumerate() {
            list.push((of(symbol, Role::State), Slot::State(i)));
        }
        list.push((of(&m::M_A, Role::Input), Slot::Moment));
        list.push((of(&m::M_B, Role::Input), Slot::Brake));
        if self.rope.is_some() {
            list.push((of(&m::V_H, Role::Input), Slot::Hoist));
        }
        self.state.constants.map(&mut |symbol, _| {
            list.push((of(symbol, Role::Parameter), Slot::Constant));
        });
        list.push((of(&m::M_R, Role::Output), Slot::FrictionMoment));
        if self.rope.is_some() {
            list.push((of(&m::S_R, Role::Output), Slot::RopeForce));
        }
        for (index, variable) in self.algebraic.variables().iter().enumerate() {
            if !coordinate.contains(&variable.symbol) {
                list.push((*variable, Slot::Algebraic(index)));
            }
        }
        let first = if boom {
            [&m::D_THETA_1, &m::D_OMEGA_1]
        } else {
            [&m::D_THETA_3, &m::D_OMEGA_3]
        };
        let rope = [&m::D_PHI, &m::D_OMEGA_PHI, &m::D_L_R, &m::D_S_Q, &m::D_V_Q];
        for (i, symbol) in first.into_iter().chain(rope).take(self.states()).enumerate() {
            list.push((of(symbol, Role::Rate), Slot::Rate(i)));
        }
        let indicators = [&m::Z_REST, &m::Z_LOOSE, &m::Z_LOW, &m::Z_HIGH, &m::Z_ROPE];
        for (i, symbol) in indicators.into_iter().take(self.indicators()).enumerate() {
            list.push((of(symbol, Role::Indicator), Slot::Indicator(i)));
        }
        list
    }

    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    #[must_use]
    pub fn terminals(&self) -> Vec<Terminal> {
        self.algebraic.terminals()
    }

    #[must_use]
    pub fn positions(&self) -> Vec<f64> {
        self.algebraic.positions()
    }

    #[must_use]
    pub fn stop_time(&self) -> f64 {
        self.algebraic.stop_time()
    }

    #[must_use]
    pub fn step_size(&self) -> f64 {
        self.algebraic.step_size()
    }

    /// Number of continuous states.
    #[must_use]
    pub fn states(&self) -> usize {
        if self.rope.is_some() { STATES } else { 2 }
    }

    /// Number of event indicators.
    #[must_use]
    pub fn indicators(&self) -> usize {
        if self.rope.is_some() {
            INDICATORS
        } else {
            INDICATORS - 1
        }
    }

    /// The equations of motion with the present parameters.
    fn motion(&mut self) -> Result<&Motion, Fault> {
        if self.motion.is_none() {
            self.motion = Some(self.assemble()?);
        }
        Ok(self.motion.as_ref().expect("assembled above"))
    }

    fn assemble(&mut self) -> Result<Motion, Fault> {
        let Constants {
            j_1,
            j_2,
            j_3,
            c_v,
            m_c,
            g,
            ..
        } = self.state.constants;
        let parameters = *self.algebraic.parameters();
        let geometry = Geometry::new(&parameters).map_err(|misfit| {
            let words = parameters.describe(misfit);
            Fault::outside(format!("{}; {}", words.what, words.help))
        })?;
        let weights = parameters.weights.expect("checked when the scene was read");
        let body = |weight: f64, inertia: f64, distance: f64, angle: f64| {
            let (sin, cos) = crate::calc::Calc::sin_cos(angle);
            Body {
                mass: weight / g,
                inertia,
                centre: Point::new(distance * cos, distance * sin),
            }
        };
        let load = self.algebraic.load() / g;
        let jib = body(weights.g_2, j_2, weights.s_2, weights.chi_2);
        let head = Point::new(geometry.kappa.x, -geometry.kappa.y) * geometry.lengths.x_2;
        let pendulum = self.rope.map(|rope| Pendulum {
            mass: load,
            length: rope.length,
        });
        let bodies = Bodies {
            boom: body(weights.g_1, j_1, weights.s_1, weights.chi_1),
            jib: if pendulum.is_some() {
                jib
            } else {
                jib.with_mass(load, head)
            },
            rocker: body(weights.g_3, j_3, weights.s_3, weights.chi_3),
            pendulum,
            gravity: g,
        };
        Ok(Motion {
            dynamics: Dynamics::new(&geometry, bodies),
            friction: Friction {
                viscous: c_v,
                coulomb: m_c,
            },
            stops: self.stops,
        })
    }

    /// Brings the algebraic model to the present angle and angular velocity.
    fn follow(&mut self) -> Result<(), Fault> {
        self.algebraic.set(0, self.state.motion.y[0])?;
        self.algebraic.set(1, self.state.motion.y[1])
    }

    /// # Errors
    /// Where the value depends on a configuration that does not exist.
    pub fn get(&mut self, index: usize) -> Result<f64, Fault> {
        let slot = self.slot(index)?;
        let (state, commands) = (self.state.motion, self.state.commands);
        match slot {
            Slot::State(i) => Ok(state.y[i]),
            Slot::Rate(i) => {
                let mut rates = [0.0; STATES];
                self.rates(&mut rates)?;
                Ok(rates[i])
            }
            Slot::Indicator(i) => {
                let mut indicators = [0.0; INDICATORS];
                self.event_indicators(&mut indicators)?;
                Ok(indicators[i])
            }
            Slot::Moment => Ok(commands.moment),
            Slot::Brake => Ok(commands.brake),
            Slot::Hoist => Ok(commands.hoist),
            Slot::Constant => {
                let (wanted, mut found) = (self.variables[index].symbol, f64::NAN);
                self.state.constants.map(&mut |symbol, value| {
                    if symbol == wanted {
                        found = value;
                    }
                });
                Ok(found)
            }
            Slot::FrictionMoment => {
                let moment = self.motion()?.friction_moment(&state, &commands);
                moment.ok_or_else(|| open(&self.variables[0], state.y[0]))
            }
            Slot::RopeForce => {
                let force = self.motion()?.rope_force(&state, &commands);
                force.ok_or_else(|| open(&self.variables[0], state.y[0]))
            }
            Slot::Algebraic(inner) => self.algebraic.get(inner),
        }
    }

    /// # Errors
    /// A value that is not finite or outside what the symbol allows, a result, an unknown index.
    pub fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        let (slot, symbol, sign) = (self.slot(index)?, self.variables[index].symbol, self.signs[index]);
        match slot {
            Slot::Algebraic(inner) => self.algebraic.check(inner, value),
            Slot::Rate(_) | Slot::Indicator(_) | Slot::FrictionMoment | Slot::RopeForce => {
                Err(Fault::new(format!("{} is a result and cannot be set", symbol.id)))
            }
            _ if sign.allows(value) => Ok(()),
            _ => Err(Fault::outside(format!(
                "{} = {} {} is not allowed: it must be {}",
                symbol.id,
                symbol.shown(value),
                symbol.display.name,
                sign.words()
            ))),
        }
    }

    /// # Errors
    /// As [`check`](Model::check); a refused value changes nothing.
    pub fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        self.check(index, value)?;
        match self.slots[index] {
            Slot::State(i) => {
                let state = &mut self.state.motion;
                state.y[i] = value;
                // A taut rope is as long as the load is far.
                if i == 4 && state.taut {
                    state.y[5] = value;
                }
                self.follow()?;
            }
            Slot::Moment => self.state.commands.moment = value,
            Slot::Brake => self.state.commands.brake = value,
            Slot::Hoist => self.state.commands.hoist = value,
            Slot::Constant => {
                let wanted = self.variables[index].symbol;
                self.state.constants = self
                    .state
                    .constants
                    .map(&mut |symbol, old| if symbol == wanted { value } else { old });
                self.motion = None;
            }
            Slot::Algebraic(inner) => {
                self.algebraic.set(inner, value)?;
                self.motion = None;
            }
            _ => {}
        }
        Ok(())
    }

    /// The time alone: states move by [`advance`](Model::advance), or are set from outside.
    pub fn set_time(&mut self, time: f64) {
        self.state.time = time;
    }

    /// Brings everything to the present parameters, states and commands, and decides what follows.
    ///
    /// # Errors
    /// Parameters with which there is no mechanism, or states in which it does not close.
    pub fn update(&mut self) -> Result<(), Fault> {
        self.event()?;
        self.algebraic.update()
    }

    /// Decides what follows at an instant; returns whether a state changed.
    ///
    /// # Errors
    /// As [`update`](Model::update).
    pub fn event(&mut self) -> Result<bool, Fault> {
        let (before, commands) = (self.state.motion, self.state.commands);
        let mut state = before;
        self.motion()?
            .event(&mut state, &commands)
            .map_err(|_| open(&self.variables[0], before.y[0]))?;
        self.state.motion = state;
        self.follow()?;
        Ok(state.y != before.y)
    }

    /// Solves from one time to another, both in s; a step that fails changes nothing.
    ///
    /// # Errors
    /// The linkage does not close on the way, or the step needs more inner steps than are allowed.
    pub fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        let (before, commands, step) = (self.state.motion, self.state.commands, self.state.constants.step);
        let mut state = before;
        self.motion()?
            .advance(&mut state, &commands, to - from, step)
            .map_err(|halt| self.refusal(halt, to - from))?;
        self.state.motion = state;
        self.state.time = to;
        self.follow()?;
        self.algebraic.update().inspect_err(|_| {
            self.state.motion = before;
            self.state.time = from;
        })
    }

    fn refusal(&self, halt: Halt, size: f64) -> Fault {
        let coordinate = &self.variables[0];
        let (symbol, at) = (coordinate.symbol, self.state.motion.y[0]);
        let angle = format!("{} = {} {}", symbol.id, short(symbol.shown(at)), symbol.display.name);
        let step = self.state.constants.step;
        Fault::outside(match halt {
            Halt::Outside => format!(
                "the motion from {angle} ends within {size} s where the linkage does not close, or beyond all numbers: \
                 keep the working range away from dead points, or take a smaller moment M_A = {} N.m",
                short(self.state.commands.moment)
            ),
            Halt::TooSmall | Halt::TooMany => format!(
                "the step of {size} s from {angle} needs more than the {} inner steps allowed at step = {step} s: \
                 take smaller communication steps, or a longer step",
                crate::solver::MOST_STEPS
            ),
        })
    }

    /// The continuous states.
    pub fn get_states(&self, states: &mut [f64]) {
        states.copy_from_slice(&self.state.motion.y[..self.states()]);
    }

    /// # Errors
    /// A state is not finite; none changes.
    pub fn set_states(&mut self, states: &[f64]) -> Result<(), Fault> {
        for (variable, value) in self.variables.iter().zip(states) {
            if !value.is_finite() {
                return Err(Fault::outside(format!("{variable} = {value} is not finite")));
            }
        }
        let count = self.states();
        self.state.motion.y[..count].copy_from_slice(states);
        self.follow()
    }

    /// Rates of the continuous states.
    ///
    /// # Errors
    /// The linkage does not close.
    pub fn rates(&mut self, rates: &mut [f64]) -> Result<(), Fault> {
        let (state, commands) = (self.state.motion, self.state.commands);
        let found = self.motion()?.rates(&state, &commands, &state.y);
        let found = found.ok_or_else(|| open(&self.variables[0], state.y[0]))?;
        for (rate, found) in rates.iter_mut().zip(found) {
            *rate = found;
        }
        Ok(())
    }

    /// # Errors
    /// The linkage does not close.
    pub fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        let (state, commands) = (self.state.motion, self.state.commands);
        let found = self.motion()?.indicators(&state, &commands, &state.y);
        let found = found.ok_or_else(|| open(&self.variables[0], state.y[0]))?;
        for (indicator, found) in indicators.iter_mut().zip(found) {
            *indicator = found;
        }
        Ok(())
    }

    #[must_use]
    pub fn state(&self) -> State {
        State {
            algebraic: *self.algebraic.state(),
            ..self.state
        }
    }

    pub fn set_state(&mut self, state: &State) {
        self.state = *state;
        self.algebraic.set_state(&state.algebraic);
        self.motion = None;
    }

    /// A state as numbers.
    #[must_use]
    pub fn numbers(&self, state: &State) -> Vec<f64> {
        let bar = match state.motion.bar {
            Bar::Held => 0.0,
            Bar::Forward => 1.0,
            Bar::Backward => -1.0,
        };
        let Commands { moment, brake, hoist } = state.commands;
        let mut numbers = vec![state.time, bar, f64::from(state.motion.taut), moment, brake, hoist];
        numbers.extend(state.motion.y);
        state.constants.map(&mut |_, value| numbers.push(value));
        numbers.extend(self.algebraic.numbers(&state.algebraic));
        numbers
    }

    /// # Errors
    /// Numbers that are not those of a state of this model.
    pub fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        let wrong = || Fault::new("a saved state does not belong to this model");
        let (&[time, bar, taut, moment, brake, hoist], rest) = numbers.split_first_chunk::<6>().ok_or_else(wrong)?;
        let (&y, rest) = rest.split_first_chunk::<STATES>().ok_or_else(wrong)?;
        let mut values = rest.iter();
        let constants = self.state.constants.map(&mut |_, _| values.next().copied());
        let mut complete = true;
        let constants = constants.map(&mut |_, value| {
            complete &= value.is_some_and(f64::is_finite);
            value.unwrap_or(f64::NAN)
        });
        let bar = match bar {
            0.0 => Bar::Held,
            1.0 => Bar::Forward,
            -1.0 => Bar::Backward,
            _ => return Err(wrong()),
        };
        let finite = y.iter().chain([&time, &moment, &brake, &hoist]).all(|x| x.is_finite());
        if !(complete && finite) {
            return Err(wrong());
        }
        Ok(State {
            time,
            motion: motion::State {
                y,
                bar,
                taut: taut != 0.0,
            },
            commands: Commands { moment, brake, hoist },
            constants,
            algebraic: self.algebraic.state_of(values.as_slice())?,
        })
    }

    /// What each variable depends on. Results of the position depend on angle and angular velocity in
    /// the place of the time; rates, indicators and reactions on everything that moves or weighs.
    #[must_use]
    pub fn dependencies(&self) -> Vec<BTreeSet<Name>> {
        let known = |variable: &&Variable| {
            matches!(
                variable.role,
                Role::Input | Role::Parameter | Role::Tunable | Role::State
            )
        };
        let all: BTreeSet<Name> = self
            .variables
            .iter()
            .filter(known)
            .map(|v| (v.symbol.id, v.number))
            .collect();
        let name = |index: usize| -> Name { (self.variables[index].symbol.id, None) };
        let algebraic = self.algebraic.dependencies();
        let of = |slot: &Slot| match *slot {
            Slot::State(i) => BTreeSet::from([name(i)]),
            // Rates of positions are other states; the rope's are the hoist's.
            Slot::Rate(0) => BTreeSet::from([name(1)]),
            Slot::Rate(2) => BTreeSet::from([name(3)]),
            Slot::Rate(4) => BTreeSet::from([(m::V_H.id, None)]),
            Slot::Rate(5) => BTreeSet::from([(m::V_H.id, None), (m::V_Q.id, None)]),
            Slot::Rate(_) | Slot::Indicator(_) | Slot::FrictionMoment | Slot::RopeForce => all.clone(),
            Slot::Algebraic(inner) => {
                let found = algebraic[inner].iter().copied();
                found.filter(|name| *name != (TIME.id, None)).collect()
            }
            _ => BTreeSet::new(),
        };
        self.slots.iter().map(of).collect()
    }

    fn slot(&self, index: usize) -> Result<Slot, Fault> {
        self.slots.get(index).copied().ok_or_else(|| {
            Fault::new(format!(
                "there is no variable {index}; this model has {}",
                self.slots.len()
            ))
        })
    }
}

/// Which numbers a quantity of motion may have.
fn allowed(symbol: &'static Symbol) -> Sign {
    let of = |key: &crate::schema::Key| match key.kind {
        Kind::Quantity(known, sign) if known == symbol => Some(sign),
        _ => None,
    };
    KEYS.iter().find_map(of).unwrap_or(Sign::Any)
}

fn open(coordinate: &Variable, at: f64) -> Fault {
    let symbol = coordinate.symbol;
    Fault::outside(format!(
        "the linkage does not close at {coordinate} = {} {}",
        short(symbol.shown(at)),
        symbol.display.name
    ))
}
