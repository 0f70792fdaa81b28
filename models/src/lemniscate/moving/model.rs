//! The mechanism in motion as a running model: commands and parameters in,
//! states and results out. What follows from angle and angular velocity alone
//! comes from the algebraic model of the same scene.

use std::collections::BTreeSet;

use crate::calc::Calc;
use crate::hydraulics::cylinder::Cylinder;
use crate::hydraulics::valve::Valve;
use crate::lemniscate::dynamics::{Bodies, Body, Coordinate, Dynamics, Pendulum};
use crate::lemniscate::geometry::{Driven, Geometry};
use crate::lemniscate::hydraulic::Hydraulic;
use crate::lemniscate::model::{Model as Algebraic, State as AlgebraicState};
use crate::lemniscate::motion::{self, Commands, Friction, Motion};
use crate::lemniscate::moving::level::{Inputs, Level, MOST_INDICATORS, MOST_STATES, Present};
use crate::lemniscate::moving::scene::{Constants, KEYS, Moving, OIL_KEYS, Oil, Rope};
use crate::lemniscate::moving::symbols as m;
use crate::lemniscate::scene::Luffing;
use crate::lemniscate::symbols as s;
use crate::model::{Fault, Name, Role, TIME, Terminal, Type, Variable};
use crate::plane::Point;
use crate::schema::{Kind, Sign, short};
use crate::solver::{Halt, MOST_STEPS};
use crate::symbol::Symbol;
use crate::unit;

/// Least pressure of the chambers at the start, in Pa.
const LEAST_PRESSURE: f64 = 20e5;

/// Natural frequency, in rad/s, of the mechanism alone against an end stop of the hydraulic level;
/// the stop is damped critically.
const STOP: f64 = 100.0;

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
    /// Numbers of continuous states and of event indicators.
    states: usize,
    indicators: usize,
    /// Follows from the parameters; `None` after one has changed.
    level: Option<Level>,
    state: State,
}

/// All that changes in a model while it runs.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// In s.
    time: f64,
    present: Present,
    inputs: Inputs,
    constants: Constants<f64>,
    oil: Option<Oil<f64>>,
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
    Valve,
    Supply,
    Constant,
    FrictionMoment,
    RopeForce,
    CylinderForce,
    /// Index of a variable of the algebraic model.
    Algebraic(usize),
}

impl Model {
    /// # Errors
    /// The cylinder cannot hold the crane at the start. A scene that was read has a mechanism.
    pub fn new(luffing: &Luffing, moving: &Moving) -> Result<Model, Fault> {
        let algebraic = Algebraic::new(luffing)?;
        let Moving {
            rope,
            oil,
            inputs,
            constants,
        } = *moving;
        let mut start = motion::State::resting(luffing.motion.from, rope.map_or(0.0, |rope| rope.length));
        start.y[2] = rope.map_or(0.0, |rope| rope.swing);
        let (states, indicators) = match (oil, rope) {
            (None, None) => (2, motion::INDICATORS - 1),
            (None, Some(_)) => (motion::STATES, motion::INDICATORS),
            (Some(_), None) => (8, MOST_INDICATORS),
            (Some(_), Some(_)) => (10, MOST_INDICATORS),
        };
        let mut model = Model {
            driven: luffing.parameters.driven,
            stops: [luffing.motion.from, luffing.motion.to],
            rope,
            variables: Vec::new(),
            slots: Vec::new(),
            signs: Vec::new(),
            states,
            indicators,
            level: None,
            state: State {
                time: 0.0,
                present: Present::Free(start),
                inputs,
                constants,
                oil,
                algebraic: *algebraic.state(),
            },
            algebraic,
        };
        if oil.is_some() {
            model.state.present = model.held_by_oil(start.y[0], start.y[2])?;
        }
        for (variable, slot) in model.list() {
            model.variables.push(variable);
            model.slots.push(slot);
            model.signs.push(allowed(variable.symbol));
        }
        model.update()?;
        Ok(model)
    }

    /// A cylinder's start: the valve closed, the oil carrying the crane.
    fn held_by_oil(&self, theta: f64, swing: f64) -> Result<Present, Fault> {
        let present = match self.assemble()? {
            Level::Fixed(system) => system.resting(theta, LEAST_PRESSURE).map(Present::of_oil_8),
            Level::Hanging(system) => system.resting(theta, LEAST_PRESSURE).map(|mut y| {
                y[2] = swing;
                Present::of_oil_10(y)
            }),
            Level::Free(_) => None,
        };
        present.ok_or_else(|| {
            Fault::outside("the cylinder has no lever arm at the start of the working range: it cannot hold the crane")
        })
    }

    /// Variables of a scene: the coordinate first, then other states, inputs, constants and results of
    /// motion, then those of the algebraic model, then rates and event indicators.
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
        let hydraulic = self.state.oil.is_some();
        let reeled = self.rope.is_some() && !hydraulic;
        let coordinate = if boom {
            [&s::THETA_1, &s::OMEGA_1]
        } else {
            [&s::THETA_3, &s::OMEGA_3]
        };
        let states = self.of_level(
            coordinate,
            [&m::PHI, &m::OMEGA_PHI],
            [&m::L_R, &m::S_Q, &m::V_Q],
            [&m::P_1, &m::P_2, &m::P_A, &m::P_B, &m::X_V, &m::V_V],
        );
        for (i, symbol) in states.into_iter().enumerate() {
            list.push((of(symbol, Role::State), Slot::State(i)));
        }
        let inputs: &[(&'static Symbol, Slot)] = match (hydraulic, reeled) {
            (true, _) => &[(&m::U_V, Slot::Valve), (&m::P_P, Slot::Supply)],
            (_, false) => &[(&m::M_A, Slot::Moment), (&m::M_S, Slot::Brake)],
            (_, true) => &[(&m::M_A, Slot::Moment), (&m::M_S, Slot::Brake), (&m::V_H, Slot::Hoist)],
        };
        list.extend(inputs.iter().map(|&(symbol, slot)| (of(symbol, Role::Input), slot)));
        let mut constant = |symbol, _| list.push((of(symbol, Role::Parameter), Slot::Constant));
        self.state.constants.map(&mut constant);
        self.state.oil.map(|oil| oil.map(&mut constant));
        let results: &[(&'static Symbol, Slot)] = match (hydraulic, reeled) {
            (true, _) => &[(&m::F_C, Slot::CylinderForce)],
            (_, false) => &[(&m::M_R, Slot::FrictionMoment)],
            (_, true) => &[(&m::M_R, Slot::FrictionMoment), (&m::S_R, Slot::RopeForce)],
        };
        list.extend(results.iter().map(|&(symbol, slot)| (of(symbol, Role::Output), slot)));
        for (index, variable) in self.algebraic.variables().iter().enumerate() {
            if !coordinate.contains(&variable.symbol) {
                list.push((*variable, Slot::Algebraic(index)));
            }
        }
        let rates = self.of_level(
            if boom {
                [&m::D_THETA_1, &m::D_OMEGA_1]
            } else {
                [&m::D_THETA_3, &m::D_OMEGA_3]
            },
            [&m::D_PHI, &m::D_OMEGA_PHI],
            [&m::D_L_R, &m::D_S_Q, &m::D_V_Q],
            [&m::D_P_1, &m::D_P_2, &m::D_P_A, &m::D_P_B, &m::D_X_V, &m::D_V_V],
        );
        for (i, symbol) in rates.into_iter().enumerate() {
            list.push((of(symbol, Role::Rate), Slot::Rate(i)));
        }
        let indicators = if hydraulic {
            [&m::Z_SPOOL, &m::Z_RELIEF_1, &m::Z_RELIEF_2, &m::Z_LOW, &m::Z_HIGH]
        } else {
            [&m::Z_REST, &m::Z_LOOSE, &m::Z_LOW, &m::Z_HIGH, &m::Z_ROPE]
        };
        for (i, symbol) in indicators.into_iter().take(self.indicators).enumerate() {
            list.push((of(symbol, Role::Indicator), Slot::Indicator(i)));
        }
        list
    }

    /// What stands for each state of this level, out of those of all levels.
    fn of_level(
        &self,
        coordinate: [&'static Symbol; 2],
        swing: [&'static Symbol; 2],
        reel: [&'static Symbol; 3],
        oil: [&'static Symbol; 6],
    ) -> Vec<&'static Symbol> {
        let mut symbols = coordinate.to_vec();
        if self.rope.is_some() {
            symbols.extend(swing);
        }
        match self.state.oil {
            Some(_) => symbols.extend(oil),
            None if self.rope.is_some() => symbols.extend(reel),
            None => {}
        }
        symbols
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
        self.states
    }

    /// Number of event indicators.
    #[must_use]
    pub fn indicators(&self) -> usize {
        self.indicators
    }

    /// The equations of motion with the present parameters and inputs.
    fn level(&mut self) -> Result<&Level, Fault> {
        if self.level.is_none() {
            self.level = Some(self.assemble()?);
        }
        Ok(self.level.as_ref().expect("assembled above"))
    }

    fn assemble(&self) -> Result<Level, Fault> {
        let Constants {
            j_1,
            j_2,
            j_3,
            c_v,
            m_f,
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
            let (sin, cos) = Calc::sin_cos(angle);
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
        let dynamics = Dynamics::new(&geometry, bodies);
        let Some(oil) = self.state.oil else {
            return Ok(Level::Free(Motion {
                dynamics,
                friction: Friction {
                    viscous: c_v,
                    coulomb: m_f,
                },
                stops: self.stops,
            }));
        };
        let (anchors, bore) = parameters
            .anchors
            .zip(parameters.cylinder)
            .expect("checked when the scene was read");
        let dynamics = dynamics.with_drive(&anchors);
        let cylinder = Cylinder {
            areas: Cylinder::areas(bore.d_c, bore.d_r),
            lengths: [oil.l_min, oil.l_max],
            dead_volume: oil.v_0,
            port_volume: oil.v_1,
            line: Valve::rated(oil.q_n, oil.dp_l),
            leakage: oil.k_l,
            bulk_modulus: oil.beta_e,
            relief: [oil.p_r, oil.k_r],
            valve: Valve {
                conductance: Valve::rated(oil.q_n, oil.dp_n),
                overlap: 0.0,
                frequency: oil.omega_v,
                damping: oil.zeta_v,
            },
        };
        if self.rope.is_some() {
            Ok(Level::Hanging(self.hydraulic(dynamics, cylinder)))
        } else {
            Ok(Level::Fixed(self.hydraulic(dynamics, cylinder)))
        }
    }

    fn hydraulic<const N: usize>(&self, dynamics: Dynamics, cylinder: Cylinder) -> Hydraulic<N> {
        let inertia = f64::reduced(&dynamics, self.stops[0]).map_or(0.0, |r| r.inertia);
        Hydraulic {
            dynamics,
            cylinder,
            viscous: self.state.constants.c_v,
            coulomb: self.state.constants.m_f,
            stops: self.stops,
            buffer: [inertia * STOP * STOP, 2.0 * inertia * STOP],
            command: self.state.inputs.valve,
            supply: self.state.inputs.supply,
        }
    }

    /// Brings the algebraic model to the present angle and angular velocity.
    fn follow(&mut self) -> Result<(), Fault> {
        let y = self.state.present.states();
        self.algebraic.set(0, y[0])?;
        self.algebraic.set(1, y[1])
    }

    /// A parameter has changed.
    fn changed(&mut self) {
        self.level = None;
        self.state.present.interrupt();
    }

    /// # Errors
    /// Where the value depends on a configuration that does not exist.
    pub fn get(&mut self, index: usize) -> Result<f64, Fault> {
        let (slot, inputs) = (self.slot(index)?, self.state.inputs);
        match slot {
            Slot::State(i) => Ok(self.state.present.states()[i]),
            Slot::Rate(i) => {
                let mut rates = [0.0; MOST_STATES];
                self.rates(&mut rates)?;
                Ok(rates[i])
            }
            Slot::Indicator(i) => {
                let mut indicators = [0.0; MOST_INDICATORS];
                self.event_indicators(&mut indicators)?;
                Ok(indicators[i])
            }
            Slot::Moment => Ok(inputs.motion.moment),
            Slot::Brake => Ok(inputs.motion.brake),
            Slot::Hoist => Ok(inputs.motion.hoist),
            Slot::Valve => Ok(inputs.valve),
            Slot::Supply => Ok(inputs.supply),
            Slot::Constant => {
                let (wanted, mut found) = (self.variables[index].symbol, f64::NAN);
                let mut look = |symbol, value| {
                    if symbol == wanted {
                        found = value;
                    }
                };
                self.state.constants.map(&mut look);
                self.state.oil.map(|oil| oil.map(&mut look));
                Ok(found)
            }
            Slot::FrictionMoment | Slot::RopeForce | Slot::CylinderForce => {
                let present = self.state.present;
                let found = match (self.level()?, present, slot) {
                    (Level::Free(motion), Present::Free(state), Slot::RopeForce) => {
                        motion.rope_force(&state, &inputs.motion)
                    }
                    (Level::Free(motion), Present::Free(state), _) => motion.friction_moment(&state, &inputs.motion),
                    (Level::Fixed(system), Present::Fixed(run), _) => {
                        Some(system.cylinder.force(&Hydraulic::<8>::oil(&run.states())))
                    }
                    (Level::Hanging(system), Present::Hanging(run), _) => {
                        Some(system.cylinder.force(&Hydraulic::<10>::oil(&run.states())))
                    }
                    _ => None,
                };
                found.ok_or_else(|| self.open())
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
            Slot::Rate(_) | Slot::Indicator(_) | Slot::FrictionMoment | Slot::RopeForce | Slot::CylinderForce => {
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
        let inputs = &mut self.state.inputs;
        match self.slots[index] {
            Slot::State(i) => {
                let mut y = self.state.present.states();
                y[i] = value;
                // A taut rope is as long as the load is far.
                if matches!(&self.state.present, Present::Free(state) if i == 4 && state.taut) {
                    y[5] = value;
                }
                self.state.present.set_states(&y[..self.states]);
                self.follow()?;
            }
            Slot::Moment => inputs.motion.moment = value,
            Slot::Brake => inputs.motion.brake = value,
            Slot::Hoist => inputs.motion.hoist = value,
            Slot::Valve if inputs.valve != value => {
                inputs.valve = value;
                self.commanded();
            }
            Slot::Supply if inputs.supply != value => {
                inputs.supply = value;
                self.commanded();
            }
            Slot::Constant => {
                let wanted = self.variables[index].symbol;
                let mut change = |symbol, old| if symbol == wanted { value } else { old };
                self.state.constants = self.state.constants.map(&mut change);
                self.state.oil = self.state.oil.map(|oil| oil.map(&mut change));
                self.changed();
            }
            Slot::Algebraic(inner) if self.algebraic.get(inner) != Ok(value) => {
                self.algebraic.set(inner, value)?;
                self.changed();
            }
            // An importer that repeats itself does not interrupt the solver.
            _ => {}
        }
        Ok(())
    }

    /// The cylinder's inputs have changed.
    fn commanded(&mut self) {
        self.state.present.interrupt();
        if let Some(level) = &mut self.level {
            level.set_inputs(&self.state.inputs);
        }
    }

    /// The time alone: states move by [`advance`](Model::advance), or are set from outside.
    pub fn set_time(&mut self, time: f64) {
        self.state.time = time;
    }

    /// Brings everything to the present parameters, states and inputs, and decides what follows.
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
        let (before, inputs) = (self.state.present, self.state.inputs);
        let mut present = before;
        let decided = self.level()?.event(&mut present, &inputs);
        decided.map_err(|_| self.open())?;
        self.state.present = present;
        self.follow()?;
        Ok(present.states() != before.states())
    }

    /// Solves from one time to another, both in s; a step that fails changes nothing.
    ///
    /// # Errors
    /// The linkage does not close on the way, or the step needs more inner steps than are allowed.
    pub fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        let (before, inputs, step) = (self.state.present, self.state.inputs, self.state.constants.step);
        let relative = self.state.oil.map_or(0.0, |oil| oil.tol);
        let mut present = before;
        let solved = self.level()?.advance(&mut present, &inputs, to - from, step, relative);
        solved.map_err(|halt| self.refusal(halt, to - from))?;
        self.state.present = present;
        let reached = self.follow().and_then(|()| self.algebraic.update());
        match reached {
            Ok(()) => self.state.time = to,
            Err(_) => {
                self.state.present = before;
                self.follow()?;
            }
        }
        reached
    }

    fn refusal(&self, halt: Halt, size: f64) -> Fault {
        let (symbol, at) = (self.variables[0].symbol, self.state.present.states()[0]);
        let angle = format!("{} = {} {}", symbol.id, short(symbol.shown(at)), symbol.display.name);
        let step = self.state.constants.step;
        Fault::outside(match halt {
            Halt::Outside => format!(
                "the motion from {angle} ends within {size} s where the linkage does not close, or beyond all \
                 reasonable numbers: keep the working range away from dead points, or command less"
            ),
            Halt::TooSmall | Halt::TooMany => format!(
                "the step of {size} s from {angle} needs more than the {MOST_STEPS} inner steps that are allowed, \
                 at step = {step} s: take smaller communication steps, a longer step or a coarser tolerance"
            ),
        })
    }

    /// The continuous states.
    pub fn get_states(&self, states: &mut [f64]) {
        states.copy_from_slice(&self.state.present.states()[..self.states]);
    }

    /// # Errors
    /// A state is not finite; none changes.
    pub fn set_states(&mut self, states: &[f64]) -> Result<(), Fault> {
        for (variable, value) in self.variables.iter().zip(states) {
            if !value.is_finite() {
                return Err(Fault::outside(format!("{variable} = {value} is not finite")));
            }
        }
        self.state.present.set_states(states);
        self.follow()
    }

    /// Orders of magnitude of the continuous states.
    pub fn nominals(&self, nominals: &mut [f64]) {
        for (nominal, variable) in nominals.iter_mut().zip(&self.variables) {
            *nominal = match variable.symbol {
                symbol if symbol.unit.dimension == unit::PA.dimension => 1e5,
                symbol if symbol == &m::V_V => 1e2,
                _ => 1.0,
            };
        }
    }

    /// Rates of the continuous states.
    ///
    /// # Errors
    /// The linkage does not close.
    pub fn rates(&mut self, rates: &mut [f64]) -> Result<(), Fault> {
        let (present, inputs) = (self.state.present, self.state.inputs);
        let found = self.level()?.rates(&present, &inputs, rates);
        found.ok_or_else(|| self.open())
    }

    /// # Errors
    /// The linkage does not close.
    pub fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        let (present, inputs) = (self.state.present, self.state.inputs);
        let found = self.level()?.indicators(&present, &inputs);
        let found = found.ok_or_else(|| self.open())?;
        for (indicator, found) in indicators.iter_mut().zip(found) {
            *indicator = found;
        }
        Ok(())
    }

    fn open(&self) -> Fault {
        let (symbol, at) = (self.variables[0].symbol, self.state.present.states()[0]);
        Fault::outside(format!(
            "the linkage does not close at {} = {} {}",
            symbol.id,
            short(symbol.shown(at)),
            symbol.display.name
        ))
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
        self.level = None;
    }

    /// A state as numbers.
    #[must_use]
    pub fn numbers(&self, state: &State) -> Vec<f64> {
        let Inputs { motion, valve, supply } = state.inputs;
        let Commands { moment, brake, hoist } = motion;
        let mut numbers = vec![state.time, moment, brake, hoist, valve, supply];
        state.present.numbers(&mut numbers);
        state.constants.map(&mut |_, value| numbers.push(value));
        state.oil.map(|oil| oil.map(&mut |_, value| numbers.push(value)));
        numbers.extend(self.algebraic.numbers(&state.algebraic));
        numbers
    }

    /// # Errors
    /// Numbers that are not those of a state of this model.
    pub fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        let wrong = || Fault::new("a saved state does not belong to this model");
        let (&[time, moment, brake, hoist, valve, supply], rest) =
            numbers.split_first_chunk::<6>().ok_or_else(wrong)?;
        let (present, rest) = self.state.present.of(rest).ok_or_else(wrong)?;
        let mut complete = numbers[..6].iter().all(|x| x.is_finite());
        let mut values = rest.iter();
        let mut next = |_, _| {
            let value = values.next().copied().unwrap_or(f64::NAN);
            complete &= value.is_finite();
            value
        };
        let constants = self.state.constants.map(&mut next);
        let oil = self.state.oil.map(|oil| oil.map(&mut next));
        if !complete {
            return Err(wrong());
        }
        Ok(State {
            time,
            present,
            inputs: Inputs {
                motion: Commands { moment, brake, hoist },
                valve,
                supply,
            },
            constants,
            oil,
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
        let name = |variable: &Variable| -> Name { (variable.symbol.id, variable.number) };
        let all: BTreeSet<Name> = self.variables.iter().filter(known).map(name).collect();
        let algebraic = self.algebraic.dependencies();
        let of = |slot: &Slot| match *slot {
            Slot::State(i) => BTreeSet::from([name(&self.variables[i])]),
            // The rate of the angle is another state.
            Slot::Rate(0) => BTreeSet::from([name(&self.variables[1])]),
            Slot::Rate(_) | Slot::Indicator(_) | Slot::FrictionMoment | Slot::RopeForce | Slot::CylinderForce => {
                all.clone()
            }
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
    KEYS.iter().chain(OIL_KEYS).find_map(of).unwrap_or(Sign::Any)
}
