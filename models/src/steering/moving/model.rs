//! The groups in motion as a running model: commands, loads and parameters in,
//! states and results out. What the command wants, and what follows from loads
//! alone, comes from the algebraic model of the same scene.

use std::collections::BTreeSet;

use num_dual::Dual64;

use crate::calc::{Calc, Over};
use crate::hydraulics::cylinder::Cylinder;
use crate::hydraulics::oil::{VACUUM, warning};
use crate::hydraulics::symbols as h;
use crate::hydraulics::valve::Valve;
use crate::model::{Fault, Name, Quantity, Role, TIME, Terminal, Type, Variable};
use crate::number::short;
use crate::solver::{Count, Halt, MOST_STEPS};
use crate::steering::hydraulic::{Control, Group, INDICATORS, STATES};
use crate::steering::load::{Resistance, resistance};
use crate::steering::machine::within;
use crate::steering::model::{Model as Algebraic, State as AlgebraicState, Tangent as AlgebraicTangent};
use crate::steering::moving::level::{Clock, Level, Present};
use crate::steering::moving::scene::{Moving, bounds};
use crate::steering::moving::symbols as m;
use crate::steering::ring::friction;
use crate::steering::scene::Steering;
use crate::steering::sizing::{flow, force};
use crate::steering::symbols as s;
use crate::symbol::Symbol;
use crate::unit;

/// Pressure of the chamber on the bore's side at the start, in Pa.
const RESTING_PRESSURE: f64 = 20e5;

/// Natural frequency, in rad/s, of a group alone against its end stop, which is damped critically.
const STOP: f64 = 100.0;

/// The states of a group, in their order, with their rates.
const OF_GROUP: [(&Symbol, &Symbol); STATES] = [
    (&s::THETA, &m::D_THETA),
    (&m::OMEGA_G, &m::D_OMEGA_G),
    (&m::P_1, &m::D_P_1),
    (&m::P_2, &m::D_P_2),
    (&m::P_A, &m::D_P_A),
    (&m::P_B, &m::D_P_B),
    (&m::X_V, &m::D_X_V),
    (&m::V_V, &m::D_V_V),
];

const OF_EVENTS: [&Symbol; INDICATORS] = [
    &m::Z_OPEN_1,
    &m::Z_OPEN_2,
    &m::Z_RELIEF_1,
    &m::Z_RELIEF_2,
    &m::Z_MIN,
    &m::Z_MAX,
];

/// A scene's steering in motion.
#[derive(Clone, Debug)]
pub struct Model {
    algebraic: Algebraic,
    variables: Vec<Variable>,
    slots: Vec<Slot>,
    /// Where the algebraic model has what the groups need: of the first group the angle that the PLC is to
    /// reach, which is the set point on its way through a change of mode or that of the nearest command, angle and
    /// rolling speed as commanded; the margin to the ranges.
    wanted: usize,
    heading: usize,
    rolling: usize,
    margin: usize,
    /// Follows from parameters and inputs; `None` where there is no machine.
    level: Option<Level>,
    /// How the groups were before a step that may fail.
    before: Vec<Present>,
    state: State,
}

/// All that changes in a model while it runs.
#[derive(Clone, Debug)]
pub struct State {
    /// In s.
    time: f64,
    clock: Clock,
    groups: Vec<Present>,
    given: Moving,
    /// Of the algebraic model; while the model runs, it has a newer one.
    algebraic: AlgebraicState,
}

/// Directions in so many quantities need no allocation.
const FEW: usize = 12;

/// A direction of states, inputs and parameters: what changes along it, and how fast.
#[derive(Clone, Debug)]
pub struct Tangent {
    few: [(Quantity, f64); FEW],
    count: usize,
    more: Vec<(Quantity, f64)>,
    /// Made when a result of the command is first asked for.
    algebraic: Option<AlgebraicTangent>,
}

impl Tangent {
    fn rate(&self, quantity: Quantity) -> f64 {
        let mut all = self.few[..self.count].iter().chain(&self.more);
        all.find(|(known, _)| *known == quantity).map_or(0.0, |(_, rate)| *rate)
    }

    fn dual(&self, quantity: Quantity, value: f64) -> Dual64 {
        Dual64::new(value, self.rate(quantity))
    }

    /// What changes along the direction.
    fn changing(&self) -> impl Iterator<Item = Quantity> {
        let all = self.few[..self.count].iter().chain(&self.more);
        all.map(|(quantity, _)| *quantity)
    }
}

#[derive(Clone, Copy, Debug)]
enum Slot {
    /// State, rate and indicator of a group.
    State(usize, usize),
    Rate(usize, usize),
    Indicator(usize, usize),
    /// A quantity of [`Moving`].
    Given,
    Demand,
    /// Whether any group's oil is below vacuum, and how far above it the least pressure of all is.
    Cavitates,
    Vacuum,
    /// A result of a group.
    Of(OfGroup, usize),
    /// Index of a variable of the algebraic model.
    Algebraic(usize),
}

/// Results of a group at the angle where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum OfGroup {
    Wanted,
    Error,
    Command,
    Force,
    Reaction,
    Demand,
    Rolling,
    Length,
    Arm,
    Speed,
    Flow,
    ForceStanding,
    ForceTravelling,
}

const RESULTS: [(&Symbol, OfGroup); 6] = [
    (&m::THETA_W, OfGroup::Wanted),
    (&m::E_I, OfGroup::Error),
    (&m::U_V, OfGroup::Command),
    (&m::F_C, OfGroup::Force),
    (&m::M_R, OfGroup::Reaction),
    (&m::Q_V, OfGroup::Demand),
];

/// Results that the algebraic model has at the angle wanted, and this one at the angle where the group is.
const AT_ANGLE: [(&Symbol, OfGroup); 7] = [
    (&s::V, OfGroup::Rolling),
    (&s::L_C, OfGroup::Length),
    (&s::OD, OfGroup::Arm),
    (&s::V_C, OfGroup::Speed),
    (&s::Q_G, OfGroup::Flow),
    (&s::F_G, OfGroup::ForceStanding),
    (&s::F_GX, OfGroup::ForceTravelling),
];

/// The angle itself and its rate are states here; the pump's flow takes the place of what the cylinders take.
const REPLACED: [&Symbol; 3] = [&s::THETA, &s::OMEGA_I, &s::Q_SUM];

impl Model {
    /// # Errors
    /// Never for a scene that was read: it has a machine, and a command that its mode takes.
    pub fn new(steering: &Steering, moving: &Moving) -> Result<Model, Fault> {
        let algebraic = Algebraic::new(steering)?;
        let of = |symbol: &Symbol| {
            let mut all = algebraic.variables().iter();
            all.position(|variable| variable.symbol == symbol)
        };
        let groups = vec![Present::new([0.0; STATES]); algebraic.parameters().groups.len()];
        let mut model = Model {
            variables: Vec::new(),
            slots: Vec::new(),
            heading: of(&s::THETA).ok_or_else(absent)?,
            wanted: of(&s::THETA_S).or(of(&s::THETA_N)).ok_or_else(absent)?,
            rolling: of(&s::V).ok_or_else(absent)?,
            margin: of(&s::MARGIN).ok_or_else(absent)?,
            level: None,
            before: groups.clone(),
            state: State {
                time: 0.0,
                clock: Clock::STOPPED,
                groups,
                given: *moving,
                algebraic: algebraic.state().clone(),
            },
            algebraic,
        };
        for (variable, slot) in model.list() {
            model.variables.push(variable);
            model.slots.push(slot);
        }
        model.level = Some(model.assemble()?);
        model.stand()?;
        Ok(model)
    }

    /// Variables of a scene: inputs and parameters of the algebraic model, what is given besides, states,
    /// results, rates and event indicators; those of groups group by group in each quantity.
    fn list(&self) -> Vec<(Variable, Slot)> {
        let groups = self.state.groups.len();
        let mut list = Vec::new();
        let mut results = Vec::new();
        for (index, variable) in self.algebraic.variables().iter().enumerate() {
            let slot = match AT_ANGLE.iter().find(|(symbol, _)| *symbol == variable.symbol) {
                Some((_, of)) => Slot::Of(*of, usize::from(variable.number.unwrap_or(1)) - 1),
                None => Slot::Algebraic(index),
            };
            match variable.role {
                Role::Output if REPLACED.contains(&variable.symbol) => {}
                Role::Output => results.push((*variable, slot)),
                Role::Indicator => {}
                _ => list.push((*variable, slot)),
            }
        }
        let real = |symbol: &'static Symbol, number, role, bounds| Variable {
            symbol,
            number,
            role,
            kind: Type::Real,
            bounds,
        };
        const ANY: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
        self.state.given.map(&mut |symbol, value| {
            let role = if *symbol == m::P_P {
                Role::Input
            } else {
                Role::Parameter
            };
            let (least, most, _) = bounds(symbol);
            list.push((real(symbol, None, role, [least, most]), Slot::Given));
            value
        });
        let mut each = |symbol, role, of: &dyn Fn(usize) -> Slot| {
            list.extend(
                (0..groups)
                    .zip(1..)
                    .map(|(i, number)| (real(symbol, Some(number), role, ANY), of(i))),
            );
        };
        for (k, (symbol, _)) in OF_GROUP.into_iter().enumerate() {
            each(symbol, Role::State, &|i| Slot::State(k, i));
        }
        for (symbol, of) in RESULTS {
            each(symbol, Role::Output, &|i| Slot::Of(of, i));
        }
        for (k, (_, symbol)) in OF_GROUP.into_iter().enumerate() {
            each(symbol, Role::Rate, &|i| Slot::Rate(k, i));
        }
        for (k, symbol) in OF_EVENTS.into_iter().enumerate() {
            each(symbol, Role::Indicator, &|i| Slot::Indicator(k, i));
        }
        let margin = self.algebraic.variables()[self.margin];
        list.push((margin, Slot::Algebraic(self.margin)));
        list.push((real(&h::Z_VACUUM, None, Role::Indicator, ANY), Slot::Vacuum));
        let flag = Variable {
            kind: Type::Boolean,
            ..real(&h::CAVITATES, None, Role::Output, ANY)
        };
        list.push((flag, Slot::Cavitates));
        list.push((real(&m::Q_P, None, Role::Output, ANY), Slot::Demand));
        list.extend(results);
        list
    }

    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    #[must_use]
    pub fn terminals(&self) -> Vec<Terminal> {
        let mut terminals = self.algebraic.terminals();
        for (number, terminal) in (0..).zip(&mut terminals) {
            let exists = |name: &String| self.variables.iter().any(|variable| variable.name() == *name);
            terminal.members.retain(|(name, _)| exists(name));
            // The first one is the machine's; the rate of a group's angle is a state here.
            if number > 0 {
                terminal.members.push((format!("{}[{number}]", m::OMEGA_G.id), "w"));
            }
        }
        terminals
    }

    #[must_use]
    pub fn positions(&self) -> Vec<f64> {
        self.algebraic.positions()
    }

    #[must_use]
    pub fn stop_time(&self) -> f64 {
        self.algebraic.stop_time()
    }

    /// The PLC's cycle, in s.
    #[must_use]
    pub fn step_size(&self) -> f64 {
        self.state.given.plc.t_c
    }

    /// Work of the solver, of all groups together, since their states were last set.
    #[must_use]
    pub fn count(&self) -> Count {
        let groups = self.state.groups.iter();
        groups.fold(Count::default(), |sum, present| sum.and(present.run.count))
    }

    /// Number of continuous states.
    #[must_use]
    pub fn states(&self) -> usize {
        STATES * self.state.groups.len()
    }

    /// Number of event indicators: those of the groups, and the margins to the ranges and to vacuum.
    #[must_use]
    pub fn indicators(&self) -> usize {
        INDICATORS * self.state.groups.len() + 2
    }

    /// The equations of motion with the present parameters and inputs.
    fn assemble(&mut self) -> Result<Level, Fault> {
        let Moving { plc, .. } = self.state.given;
        let parameters = self.algebraic.parameters();
        let built = parameters.build();
        built.map_err(|refusal| Fault::outside(refusal.to_string()))?;
        let accuracy = parameters.accuracy.ok_or_else(absent)?;
        let mut groups = Vec::with_capacity(self.state.groups.len());
        for i in 0..self.state.groups.len() {
            groups.push(self.group(i, &mut |_, value| value)?);
        }
        let control = Control {
            period: plc.t_c,
            resolution: accuracy.step,
            gains: [plc.k_p, plc.k_i],
            limit: plc.u_max,
        };
        Ok(Level { groups, control })
    }

    /// The equations of one group over any scalar: `of` gives each input and parameter in it. The parameters have a machine.
    fn group<P: Calc>(&self, i: usize, of: &mut dyn FnMut(Quantity, f64) -> P) -> Result<Group<P>, Fault> {
        let parameters = self.algebraic.parameters();
        let steered = parameters.groups.get(i).ok_or_else(absent)?;
        let resistance = self.resistance(i, of);
        let mut alone = |symbol, value| of((symbol, None), value);
        let linkage = parameters.cylinder.ok_or_else(absent)?.map(&mut alone);
        let piston = parameters.piston.ok_or_else(absent)?.map(&mut alone);
        let body = self.state.given.body.map(&mut alone);
        let oil = self.state.given.oil.map(&mut alone);
        let cylinder = Cylinder {
            areas: Cylinder::areas(piston.d_g, piston.d),
            lengths: [linkage.l_x + linkage.l_a, P::constant(2.0) * linkage.l_x + linkage.l_a],
            dead_volume: oil.v_0,
            port_volume: oil.v_1,
            line: Valve::rated(oil.q_n, oil.dp_l),
            leakage: oil.k_l,
            bulk_modulus: oil.beta_e,
            relief: [oil.p_r, oil.k_r],
            valve: Valve {
                conductance: Valve::rated(oil.q_n, oil.dp_n),
                overlap: oil.x_0,
                frequency: oil.omega_v,
                damping: oil.zeta_v,
            },
        };
        Ok(Group {
            linkage: linkage.linkage(steered.mirrored),
            cylinder,
            inertia: body.j,
            resistance,
            stops: match steered.range {
                Some(range) => range.map(P::constant),
                None => linkage.ends(steered.mirrored),
            },
            buffer: [STOP * STOP, 2.0 * STOP].map(|factor| body.j * P::constant(factor)),
            supply: oil.p_p,
            command: P::constant(self.state.groups[i].held.command),
        })
    }

    /// What a group resists now: at standstill, or while travelling; nothing without loads.
    fn resistance<P: Calc>(&self, i: usize, of: &mut dyn FnMut(Quantity, f64) -> P) -> P {
        match self.drag(i, of) {
            None => P::constant(0.0),
            Some(drag) if self.algebraic.inputs().v_t == 0.0 => drag.standing,
            Some(drag) => drag.travelling,
        }
    }

    /// Resistance of a group to steering over any scalar, in N·m, with the slewing ring's friction, which stays while
    /// travelling; none without loads.
    fn drag<P: Calc>(&self, i: usize, of: &mut dyn FnMut(Quantity, f64) -> P) -> Option<Resistance<P>> {
        let (parameters, inputs) = (self.algebraic.parameters(), self.algebraic.inputs());
        let load = of((&s::G, Some(i as u16 + 1)), *inputs.loads.get(i)?);
        let mut alone = |symbol, value| of((symbol, None), value);
        let tyres = resistance(&parameters.tyre?.map(&mut alone), load);
        let ring = parameters
            .bearing
            .map(|bearing| friction(&bearing.map(&mut alone), load));
        let standing = tyres.standing + ring.unwrap_or(P::constant(0.0));
        Some(Resistance {
            standing,
            travelling: standing - tyres.standing + tyres.travelling,
        })
    }

    /// A parameter has changed.
    fn changed(&mut self) {
        // Where there is no machine, the next call that needs one says why.
        self.level = self.assemble().ok();
        for present in &mut self.state.groups {
            present.interrupt();
        }
    }

    /// A load, the travel speed or the pump's pressure may have changed.
    fn loaded(&mut self) {
        let supply = self.state.given.oil.p_p;
        for i in 0..self.state.groups.len() {
            let resistance = self.resistance(i, &mut |_, value| value);
            let Some(level) = &mut self.level else { return };
            let group = &mut level.groups[i];
            // An importer that repeats itself does not interrupt the solver.
            if group.resistance != resistance || group.supply != supply {
                (group.resistance, group.supply) = (resistance, supply);
                self.state.groups[i].interrupt();
            }
        }
    }

    fn level(&mut self) -> Result<&Level, Fault> {
        if self.level.is_none() {
            self.level = Some(self.assemble()?);
        }
        self.level.as_ref().ok_or_else(absent)
    }

    /// Angle that the command wants of a group, in rad, within its range.
    fn wanted(&mut self, group: usize) -> Result<f64, Fault> {
        let [least, most] = self.level()?.groups[group].stops;
        Ok(self.algebraic.get(self.wanted + group)?.clamp(least, most))
    }

    /// Puts every group at rest where the command wants it.
    fn stand(&mut self) -> Result<(), Fault> {
        for i in 0..self.state.groups.len() {
            let wanted = self.wanted(i)?;
            let y = self.level()?.groups[i].resting(wanted, RESTING_PRESSURE);
            self.state.groups[i] = Present::new(y);
        }
        self.state.clock = Clock::STOPPED;
        Ok(())
    }

    /// The groups at rest where a commanded angle (rad) wants them: a row of a table.
    ///
    /// # Errors
    /// As [`set`](Model::set) and [`update`](Model::update).
    pub fn place(&mut self, theta_b: f64) -> Result<(), Fault> {
        self.set(0, theta_b)?;
        self.stand()
    }

    /// # Errors
    /// Where the command is one that its mode does not take.
    pub fn get(&mut self, index: usize) -> Result<f64, Fault> {
        let slot = self.slot(index)?;
        match slot {
            Slot::State(k, i) => Ok(self.state.groups[i].run.states()[k]),
            Slot::Rate(k, i) => {
                let present = self.state.groups[i];
                Ok(self.level()?.rates(i, &present)[k])
            }
            Slot::Indicator(k, i) => {
                let y = self.state.groups[i].run.states();
                Ok(self.level()?.groups[i].indicators(&y)[k])
            }
            Slot::Given => {
                let (wanted, mut found) = (self.variables[index].symbol, f64::NAN);
                self.state.given.map(&mut |symbol, value| {
                    if symbol == wanted {
                        found = value;
                    }
                    value
                });
                Ok(found)
            }
            Slot::Demand => {
                let mut sum = 0.0;
                for i in 0..self.state.groups.len() {
                    sum += self.of_group(OfGroup::Demand, i)?;
                }
                Ok(sum)
            }
            Slot::Cavitates => {
                let (i, _) = self.lowest();
                let (group, y) = (self.level()?.groups[i], self.state.groups[i].run.states());
                let rates = group.equations(&y);
                Ok(f64::from(Group::oil(&y).cavitates(|| [2, 3, 4, 5].map(|k| rates[k]))))
            }
            Slot::Vacuum => Ok(self.lowest().1 - VACUUM),
            Slot::Of(of, i) => self.of_group(of, i),
            Slot::Algebraic(inner) => self.algebraic.get(inner),
        }
    }

    /// The group with the least pressure of its oil, and that pressure, in Pa.
    fn lowest(&self) -> (usize, f64) {
        let groups = self.state.groups.iter().enumerate();
        let all = groups.map(|(i, present)| (i, Group::oil(&present.run.states()).least().1));
        all.fold((0, f64::INFINITY), |a, b| if b.1 < a.1 { b } else { a })
    }

    /// What the importer should know of the motion so far, besides its results.
    #[must_use]
    pub fn warning(&self) -> Option<&'static str> {
        let groups = self.state.groups.iter();
        warning(groups.fold(self.lowest().1, |least, present| least.min(present.run.least)))
    }

    fn of_group(&mut self, of: OfGroup, i: usize) -> Result<f64, Fault> {
        let present = self.state.groups[i];
        let y = present.run.states();
        let group = self.level()?.groups[i];
        Ok(match of {
            OfGroup::Wanted => self.wanted(i)?,
            OfGroup::Error => self.wanted(i)? - y[0],
            OfGroup::Command => present.held.command,
            OfGroup::Rolling => {
                let [heading, rolling] = [self.heading, self.rolling].map(|first| self.algebraic.get(first + i));
                rolled(heading?, rolling?, y[0])
            }
            _ => self.of_states(of, i, &group, &y, &mut |_, value| value)?,
        })
    }

    /// A result of a group that follows from its states and loads, over any scalar.
    fn of_states<P: Calc + Over<P>>(
        &self,
        of: OfGroup,
        i: usize,
        group: &Group<P>,
        y: &[P; STATES],
        scalar: &mut dyn FnMut(Quantity, f64) -> P,
    ) -> Result<P, Fault> {
        let (theta, omega) = (y[0], y[1]);
        let pose = group.pose(theta);
        let drag = |found: Option<Resistance<P>>| found.ok_or_else(absent);
        Ok(match of {
            OfGroup::Force => group.cylinder.force(&Group::oil(y)),
            OfGroup::Reaction => group.reaction(theta, omega),
            OfGroup::Demand => group.demand(y),
            OfGroup::Length => pose.l,
            OfGroup::Arm => pose.od,
            OfGroup::Speed => pose.od * omega,
            OfGroup::Flow => {
                let piston = self.algebraic.parameters().piston.ok_or_else(absent)?;
                flow(
                    &piston.map(&mut |symbol, value| scalar((symbol, None), value)),
                    pose.od * omega,
                )
            }
            OfGroup::ForceStanding => force(drag(self.drag(i, scalar))?.standing, pose.od),
            OfGroup::ForceTravelling => force(drag(self.drag(i, scalar))?.travelling, pose.od),
            OfGroup::Wanted | OfGroup::Error | OfGroup::Command | OfGroup::Rolling => return Err(absent()),
        })
    }

    /// # Errors
    /// A value that is not finite or outside what the symbol allows, a result, an unknown index.
    pub fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        let (slot, variable) = (self.slot(index)?, &self.variables[index]);
        match slot {
            Slot::Algebraic(inner) => self.algebraic.check(inner, value),
            Slot::Given => {
                let (least, most, open) = bounds(variable.symbol);
                let checked = within(variable.symbol, value, least, most, open);
                checked.map(drop).map_err(|refusal| Fault::outside(refusal.to_string()))
            }
            Slot::State(..) if value.is_finite() => Ok(()),
            Slot::State(..) => Err(Fault::outside(format!("{variable} = {value} is not finite"))),
            _ => Err(Fault::new(format!("{variable} is a result and cannot be set"))),
        }
    }

    /// # Errors
    /// As [`check`](Model::check); a refused value changes nothing.
    pub fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        self.check(index, value)?;
        let variable = self.variables[index];
        match self.slots[index] {
            Slot::State(k, i) => {
                let mut y = self.state.groups[i].run.states();
                y[k] = value;
                self.state.groups[i].set_states(y);
                Ok(())
            }
            Slot::Given => {
                let mut same = false;
                self.state.given = self.state.given.map(&mut |symbol, old| {
                    if symbol == variable.symbol {
                        same = old == value;
                        value
                    } else {
                        old
                    }
                });
                match variable.role {
                    Role::Input => self.loaded(),
                    _ if !same => self.changed(),
                    _ => {}
                }
                Ok(())
            }
            Slot::Algebraic(inner) => {
                let before = self.algebraic.get(inner)?;
                self.algebraic.set(inner, value)?;
                match variable.role {
                    // A command waits for the next sample.
                    Role::Input if [&s::G, &s::V_T].contains(&variable.symbol) => self.loaded(),
                    Role::Parameter | Role::Tunable if before != value => self.changed(),
                    _ => {}
                }
                Ok(())
            }
            _ => unreachable!("refused above"),
        }
    }

    /// The time alone: states move by [`advance`](Model::advance), or are set from outside.
    pub fn set_time(&mut self, time: f64) {
        self.state.time = time;
        self.algebraic.set_time(time);
    }

    /// Ends initialization: from now on a mode that changes has a way to go.
    ///
    /// # Errors
    /// As [`update`](Model::update).
    pub fn start(&mut self) -> Result<(), Fault> {
        self.level()?;
        self.algebraic.start()
    }

    /// Brings everything to the present parameters and inputs.
    ///
    /// # Errors
    /// Parameters without a machine, or a command that its mode does not take.
    pub fn update(&mut self) -> Result<(), Fault> {
        self.level()?;
        self.algebraic.update()
    }

    /// The PLC's sample, where one is due; no state jumps.
    ///
    /// # Errors
    /// As [`update`](Model::update).
    pub fn event(&mut self) -> Result<bool, Fault> {
        let (time, control) = (self.state.time, self.level()?.control);
        if self.state.clock.is_due(&control, time) {
            self.sample(time)?;
        }
        Ok(false)
    }

    /// Time of the PLC's next sample, in s; none before the first one.
    #[must_use]
    pub fn next_event(&self) -> Option<f64> {
        let control = &self.level.as_ref()?.control;
        self.state.clock.next(control)
    }

    /// The PLC reads all encoders and sets all valves.
    fn sample(&mut self, time: f64) -> Result<(), Fault> {
        self.update()?;
        for i in 0..self.state.groups.len() {
            let wanted = self.wanted(i)?;
            let Some(Level { groups, control }) = &mut self.level else {
                return Err(absent());
            };
            self.state.groups[i].sample(&mut groups[i], control, wanted);
        }
        let control = self.level()?.control;
        self.state.clock = self.state.clock.sampled(&control, time);
        Ok(())
    }

    /// Solves from one time to another, both in s, with the PLC's samples on the way; one at the end
    /// belongs to the next step, which may come with other commands. A step that fails changes nothing.
    ///
    /// # Errors
    /// As [`update`](Model::update); a group's oil gets out of hand, or the step needs more inner steps than
    /// are allowed.
    pub fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        let (clock, time) = (self.state.clock, self.state.time);
        self.before.copy_from_slice(&self.state.groups);
        let solved = self.solve(from, to);
        if solved.is_err() {
            self.state.groups.copy_from_slice(&self.before);
            self.state.clock = clock;
            self.set_time(time);
            if let Some(level) = &mut self.level {
                for (group, present) in level.groups.iter_mut().zip(&self.state.groups) {
                    group.command = present.held.command;
                }
            }
        }
        solved
    }

    fn solve(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        let control = self.level()?.control;
        let Moving { body, oil, .. } = self.state.given;
        let samples = (to - from) / control.period * self.state.groups.len() as f64;
        if samples > f64::from(MOST_STEPS) {
            return Err(self.refusal(Halt::TooMany, 0, to - from));
        }
        let mut time = from;
        while time < to {
            if self.state.clock.is_due(&control, time) {
                self.set_time(time);
                self.sample(time)?;
            }
            let end = self.state.clock.next_before(&control, to).unwrap_or(to);
            for i in 0..self.state.groups.len() {
                let Some(level) = &self.level else { return Err(absent()) };
                let present = &mut self.state.groups[i];
                if let Err(halt) = present.advance(&level.groups[i], end - time, body.step, oil.tol) {
                    return Err(self.refusal(halt, i, to - from));
                }
            }
            time = end;
        }
        self.set_time(to);
        self.update()
    }

    fn refusal(&self, halt: Halt, group: usize, size: f64) -> Fault {
        let at = self.state.groups[group].run.states()[0];
        let angle = format!("theta[{}] = {}", group + 1, s::THETA.written(at));
        let size = short(size);
        Fault::outside(match halt {
            Halt::Outside => format!(
                "the motion from {angle} ends within {size} s beyond its cylinder or beyond all reasonable numbers: \
                 keep J above what the oil moves, and V_0 above what an end stop gives way"
            ),
            // Its solver is implicit, for which no step is too fast.
            Halt::TooSmall | Halt::TooMany | Halt::TooFast => format!(
                "the step of {size} s from {angle} needs more than the {MOST_STEPS} inner steps that are allowed, \
                 at T_c = {} s: take smaller communication steps, a longer cycle or a coarser tolerance",
                short(self.state.given.plc.t_c)
            ),
        })
    }

    /// The continuous states.
    pub fn get_states(&self, states: &mut [f64]) {
        let groups = self.state.groups.len();
        for (i, present) in self.state.groups.iter().enumerate() {
            for (k, y) in present.run.states().into_iter().enumerate() {
                states[k * groups + i] = y;
            }
        }
    }

    /// # Errors
    /// A state is not finite; none changes.
    pub fn set_states(&mut self, states: &[f64]) -> Result<(), Fault> {
        let groups = self.state.groups.len();
        if let Some(at) = states.iter().position(|value| !value.is_finite()) {
            let (symbol, _) = OF_GROUP[at / groups];
            let number = at % groups + 1;
            return Err(Fault::outside(format!(
                "{}[{number}] = {} is not finite",
                symbol.id,
                short(states[at])
            )));
        }
        for (i, present) in self.state.groups.iter_mut().enumerate() {
            present.set_states(std::array::from_fn(|k| states[k * groups + i]));
        }
        Ok(())
    }

    /// Orders of magnitude of the continuous states.
    pub fn nominals(&self, nominals: &mut [f64]) {
        for ((symbol, _), nominals) in OF_GROUP.iter().zip(nominals.chunks_exact_mut(self.state.groups.len())) {
            nominals.fill(match symbol {
                symbol if symbol.unit.dimension == unit::PA.dimension => 1e5,
                symbol if *symbol == &m::V_V => 1e2,
                _ => 1.0,
            });
        }
    }

    /// Rates of the continuous states.
    ///
    /// # Errors
    /// Parameters without a machine.
    pub fn rates(&mut self, rates: &mut [f64]) -> Result<(), Fault> {
        let groups = self.state.groups.len();
        for i in 0..groups {
            let present = self.state.groups[i];
            for (k, rate) in self.level()?.rates(i, &present).into_iter().enumerate() {
                rates[k * groups + i] = rate;
            }
        }
        Ok(())
    }

    /// # Errors
    /// As [`update`](Model::update).
    pub fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        let groups = self.state.groups.len();
        for i in 0..groups {
            let y = self.state.groups[i].run.states();
            for (k, indicator) in self.level()?.groups[i].indicators(&y).into_iter().enumerate() {
                indicators[k * groups + i] = indicator;
            }
        }
        indicators[INDICATORS * groups] = self.algebraic.get(self.margin)?;
        indicators[INDICATORS * groups + 1] = self.lowest().1 - VACUUM;
        Ok(())
    }

    #[must_use]
    pub fn state(&self) -> State {
        let State {
            time,
            clock,
            ref groups,
            given,
            ..
        } = self.state;
        State {
            time,
            clock,
            groups: groups.clone(),
            given,
            algebraic: self.algebraic.state().clone(),
        }
    }

    pub fn set_state(&mut self, state: &State) {
        self.state.clone_from(state);
        self.algebraic.set_state(&state.algebraic);
        self.level = self.assemble().ok();
    }

    /// A state as numbers.
    #[must_use]
    pub fn numbers(&self, state: &State) -> Vec<f64> {
        let mut numbers = vec![state.time, state.clock.number()];
        state.given.map(&mut |_, value| {
            numbers.push(value);
            value
        });
        for present in &state.groups {
            numbers.extend(present.numbers());
        }
        numbers.extend(self.algebraic.numbers(&state.algebraic));
        numbers
    }

    /// # Errors
    /// Numbers that are not those of a state of this model.
    pub fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        let wrong = || Fault::new("a saved state does not belong to this model");
        let (&[time, clock], rest) = numbers.split_first_chunk::<2>().ok_or_else(wrong)?;
        let clock = Clock::of(clock).ok_or_else(wrong)?;
        let mut values = rest.iter();
        let mut complete = time.is_finite();
        let given = self.state.given.map(&mut |_, _| {
            let value = values.next().copied().unwrap_or(f64::NAN);
            complete &= value.is_finite();
            value
        });
        if !complete {
            return Err(wrong());
        }
        let mut rest = values.as_slice();
        let mut groups = Vec::with_capacity(self.state.groups.len());
        for present in &self.state.groups {
            let (found, left) = present.of(rest).ok_or_else(wrong)?;
            groups.push(found);
            rest = left;
        }
        Ok(State {
            time,
            clock,
            groups,
            given,
            algebraic: self.algebraic.state_of(rest)?,
        })
    }

    /// The model with derivatives along a direction: `seed` is the rate of change of each state, input and parameter, in SI,
    /// and of [`TIME`].
    #[must_use]
    pub fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent {
        let mut tangent = Tangent {
            few: [((&s::THETA, None), 0.0); FEW],
            count: 0,
            more: Vec::new(),
            algebraic: None,
        };
        let known = self.variables.iter().map(Variable::quantity);
        for quantity in known.chain([(&TIME, None)]) {
            let rate = seed(quantity);
            if rate == 0.0 {
                continue;
            }
            match tangent.few.get_mut(tangent.count) {
                Some(slot) => (*slot, tangent.count) = ((quantity, rate), tangent.count + 1),
                None => tangent.more.push((quantity, rate)),
            }
        }
        tangent
    }

    /// Derivative of a state, a rate, an event indicator or an output along the direction of a tangent, in SI. The command
    /// of a valve is held from sample to sample: nothing changes it. Not finite where there is no derivative.
    ///
    /// # Errors
    /// None of these, what is searched for, or a configuration that does not exist.
    pub fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        let variable = &self.variables[index];
        let of_states = |tangent: &Tangent, i: usize| -> Result<(Group<Dual64>, [Dual64; STATES]), Fault> {
            let y = self.state.groups[i].run.states();
            let number = Some(i as u16 + 1);
            let y = std::array::from_fn(|k| tangent.dual((OF_GROUP[k].0, number), y[k]));
            Ok((self.group(i, &mut |quantity, value| tangent.dual(quantity, value))?, y))
        };
        let of_group = |tangent: &Tangent, of: OfGroup, i: usize| {
            let (group, y) = of_states(tangent, i)?;
            self.of_states(of, i, &group, &y, &mut |quantity, value| tangent.dual(quantity, value))
        };
        let found = match self.slot(index)? {
            Slot::State(..) => tangent.dual(variable.quantity(), 0.0),
            Slot::Rate(k, i) => {
                let (group, y) = of_states(tangent, i)?;
                group.equations(&y)[k]
            }
            Slot::Indicator(k, i) => {
                let (group, y) = of_states(tangent, i)?;
                group.indicators(&y)[k]
            }
            Slot::Demand => {
                let mut sum = Dual64::from_re(0.0);
                for i in 0..self.state.groups.len() {
                    sum += of_group(tangent, OfGroup::Demand, i)?;
                }
                sum
            }
            Slot::Vacuum => {
                let (_, y) = of_states(tangent, self.lowest().0)?;
                Group::oil(&y).least().1 - Dual64::from_re(VACUUM)
            }
            Slot::Cavitates | Slot::Of(OfGroup::Command, _) => Dual64::from_re(0.0),
            Slot::Of(OfGroup::Wanted, i) => self.searched(tangent, variable, self.wanted + i)?,
            Slot::Of(OfGroup::Error, i) => {
                let wanted = self.searched(tangent, variable, self.wanted + i)?;
                wanted - tangent.dual((&s::THETA, Some(i as u16 + 1)), 0.0)
            }
            Slot::Of(OfGroup::Rolling, i) => {
                let heading = self.of_command(tangent, self.heading + i)?;
                let rolling = self.of_command(tangent, self.rolling + i)?;
                let theta = self.state.groups[i].run.states()[0];
                rolled(heading, rolling, tangent.dual((&s::THETA, Some(i as u16 + 1)), theta))
            }
            Slot::Of(of, i) => of_group(tangent, of, i)?,
            Slot::Algebraic(inner) if self.algebraic.is_searched(inner) => self.searched(tangent, variable, inner)?,
            Slot::Algebraic(inner) => self.of_command(tangent, inner)?,
            Slot::Given => return Err(Fault::new(format!("{variable} is no result: it has no derivative"))),
        };
        Ok(found.eps)
    }

    /// The derivative of a variable that follows from a result of the algebraic model which is searched for: zero
    /// where nothing changes that this follows from.
    fn searched(&self, tangent: &Tangent, variable: &Variable, inner: usize) -> Result<Dual64, Fault> {
        let Some(known) = tangent
            .changing()
            .find(|known| self.algebraic.depends_on(inner, *known))
        else {
            return Ok(Dual64::from_re(0.0));
        };
        let by = self.variables.iter().find(|variable| variable.quantity() == known);
        let by = by.map_or(TIME.id.to_owned(), Variable::name);
        Err(Fault::new(format!(
            "{variable} is searched for: it has no derivative by {by}"
        )))
    }

    /// A result of the algebraic model with its derivative.
    fn of_command(&self, tangent: &mut Tangent, inner: usize) -> Result<Dual64, Fault> {
        let mut algebraic = match tangent.algebraic.take() {
            Some(algebraic) => algebraic,
            None => self.algebraic.tangent(&|quantity| tangent.rate(quantity)),
        };
        let found = self.algebraic.with_derivative(&mut algebraic, inner);
        tangent.algebraic = Some(algebraic);
        found
    }

    /// What each variable depends on: of a group its own states and what acts on it, and for what the
    /// command wants what it does in the algebraic model. The PLC's command is held between samples.
    #[must_use]
    pub fn dependencies(&self) -> Vec<BTreeSet<Name>> {
        let name = |symbol: &Symbol, i: usize| -> Name { (symbol.id, Some(i as u16 + 1)) };
        let algebraic = self.algebraic.dependencies();
        let constants: BTreeSet<Name> = self
            .variables
            .iter()
            .filter(|variable| matches!(variable.role, Role::Parameter | Role::Tunable) && variable.number.is_none())
            .map(|variable| (variable.symbol.id, None))
            .collect();
        let loaded = !self.algebraic.inputs().loads.is_empty();
        let acting = |i: usize| {
            let mut all = constants.clone();
            all.extend([(m::P_P.id, None), (s::V_T.id, None)]);
            all.extend(loaded.then(|| name(&s::G, i)));
            all.extend(OF_GROUP.iter().map(|(symbol, _)| name(symbol, i)));
            all
        };
        let of = |slot: &Slot| match *slot {
            Slot::State(k, i) => BTreeSet::from([name(OF_GROUP[k].0, i)]),
            // The rate of the angle is another state.
            Slot::Rate(0, i) => BTreeSet::from([name(&m::OMEGA_G, i)]),
            Slot::Rate(_, i) | Slot::Indicator(_, i) => acting(i),
            Slot::Given => BTreeSet::new(),
            // Any of them may be the least.
            Slot::Cavitates | Slot::Vacuum => {
                let pressures = [&m::P_1, &m::P_2, &m::P_A, &m::P_B];
                let of = |i: usize| pressures.map(|symbol| name(symbol, i));
                (0..self.state.groups.len()).flat_map(of).collect()
            }
            Slot::Demand => (0..self.state.groups.len()).flat_map(acting).collect(),
            Slot::Of(OfGroup::Command, _) => BTreeSet::new(),
            Slot::Of(OfGroup::Wanted, i) => &algebraic[self.wanted + i] | &constants,
            Slot::Of(OfGroup::Error, i) => &(&algebraic[self.wanted + i] | &constants) | &acting(i),
            Slot::Of(OfGroup::Rolling, i) => &algebraic[self.rolling + i] | &acting(i),
            Slot::Of(_, i) => acting(i),
            Slot::Algebraic(inner) => algebraic[inner].clone(),
        };
        self.slots.iter().map(of).collect()
    }

    fn slot(&self, index: usize) -> Result<Slot, Fault> {
        let found = self.slots.get(index).copied();
        found.ok_or_else(|| Fault::no_variable(index, self.slots.len()))
    }
}

/// The ground passes under the wheels of a group as commanded; they roll along where they point.
fn rolled<P: Calc>(heading: P, rolling: P, theta: P) -> P {
    rolling * (heading - theta).sin_cos().1
}

/// For what the scene of a steering in motion always has.
fn absent() -> Fault {
    Fault::new("this scene does not model the result")
}
