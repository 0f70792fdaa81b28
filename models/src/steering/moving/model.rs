//! The groups in motion as a running model: commands, loads and parameters in,
//! states and results out. What the command wants, and what follows from loads
//! alone, comes from the algebraic model of the same scene.

use std::collections::BTreeSet;

use num_dual::Dual64;

use crate::component::dependencies::{dependencies, recorded};
use crate::component::running::{Running, State, Tangent};
use crate::component::standing::Standing;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::number::short;
use crate::kernel::record::Rec;
use crate::kernel::symbol::Symbol;
use crate::kernel::unit;
use crate::kernel::variable::{Fault, Name, Quantity, Role, TIME, Terminal, Type, Variable};
use crate::parts::hydraulics::cylinder::Cylinder;
use crate::parts::hydraulics::oil::{VACUUM, warning};
use crate::parts::hydraulics::symbols as h;
use crate::parts::hydraulics::valve::Valve;
use crate::parts::solver::{Count, Halt, MOST_IMPLICIT};
use crate::steering::built::Built;
use crate::steering::flow::flow;
use crate::steering::hydraulic::{Control, INDICATORS, STATES, WorkingGroup};
use crate::steering::load::{Resistance, force, resistance};
use crate::steering::moving::level::{Clock, Groups, PresentGroup};
use crate::steering::moving::scene::{MovingGroups, Plc};
use crate::steering::moving::symbols as m;
use crate::steering::refusal::within;
use crate::steering::ring::friction;
use crate::steering::scene::Steering;
use crate::steering::stages::SteeredGroups;
use crate::steering::symbols as s;

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
#[derive(Clone)]
pub struct SteeringMotion {
    algebraic: Standing,
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
    level: Option<Groups>,
    /// How the groups were before a step that may fail.
    before: Vec<PresentGroup>,
    now: Now,
}

/// All that changes in the model while it runs, but for the algebraic one's.
#[derive(Clone, Debug)]
struct Now {
    /// In s.
    time: f64,
    clock: Clock,
    groups: Vec<PresentGroup>,
    given: MovingGroups,
}

impl Now {
    /// Takes over another one's, in its own place.
    fn follow(&mut self, other: &Now) {
        (self.time, self.clock, self.given) = (other.time, other.clock, other.given);
        self.groups.clone_from(&other.groups);
    }
}

/// A state of the model.
struct Saved {
    now: Now,
    algebraic: State,
}

/// Directions in so many quantities need no allocation.
const FEW: usize = 12;

/// A direction of states, inputs and parameters: what changes along it, and how fast.
struct Direction {
    few: [(Quantity, f64); FEW],
    count: usize,
    more: Vec<(Quantity, f64)>,
    /// Made when a result of the command is first asked for; whether it is along this direction.
    algebraic: Option<Tangent>,
    along: bool,
}

impl Direction {
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
    /// A quantity of [`MovingGroups`].
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
    (&m::E, OfGroup::Error),
    (&m::U_V, OfGroup::Command),
    (&m::F_C, OfGroup::Force),
    (&m::M_R, OfGroup::Reaction),
    (&m::Q_V, OfGroup::Demand),
];

/// Results that the algebraic model has at the angle wanted, and this one at the angle where the group is.
const AT_ANGLE: [(&Symbol, OfGroup); 7] = [
    (&s::V, OfGroup::Rolling),
    (&s::R, OfGroup::Length),
    (&s::OD, OfGroup::Arm),
    (&s::V_C, OfGroup::Speed),
    (&s::Q_G, OfGroup::Flow),
    (&s::F_G, OfGroup::ForceStanding),
    (&s::F_GX, OfGroup::ForceTravelling),
];

/// The angle itself and its rate are states here; the pump's flow takes the place of what the cylinders take.
const REPLACED: [&Symbol; 3] = [&s::THETA, &s::THETA_DOT, &s::Q_SUM];

impl SteeringMotion {
    /// # Errors
    /// Never for a scene that was read: it has a machine, and a command that its mode takes.
    pub fn new(steering: &Steering, moving: &MovingGroups) -> Result<SteeringMotion, Fault> {
        let algebraic = steering.standing();
        let of = |symbol: &Symbol| {
            let mut all = algebraic.variables().iter();
            all.position(|variable| variable.symbol == symbol)
        };
        let groups = vec![PresentGroup::new([0.0; STATES]); algebraic.of::<SteeredGroups>().given().axes.len()];
        let mut model = SteeringMotion {
            variables: Vec::new(),
            slots: Vec::new(),
            heading: of(&s::THETA).ok_or_else(absent)?,
            wanted: of(&s::THETA_S).or(of(&s::THETA_N)).ok_or_else(absent)?,
            rolling: of(&s::V).ok_or_else(absent)?,
            margin: of(&s::MARGIN).ok_or_else(absent)?,
            level: None,
            before: groups.clone(),
            now: Now {
                time: 0.0,
                clock: Clock::STOPPED,
                groups,
                given: *moving,
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
        let groups = self.now.groups.len();
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
        self.now.given.map(&mut |symbol, value| {
            let role = if *symbol == m::P_P {
                Role::Input
            } else {
                Role::Parameter
            };
            list.push((Variable::new((symbol, None), role), Slot::Given));
            value
        });
        let mut each = |symbol, role, of: &dyn Fn(usize) -> Slot| {
            list.extend(
                (0..groups)
                    .zip(1..)
                    .map(|(i, number)| (Variable::new((symbol, Some(number)), role), of(i))),
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
        list.push((Variable::new((&h::Z_VACUUM, None), Role::Indicator), Slot::Vacuum));
        let flag = Variable {
            kind: Type::Boolean,
            ..Variable::new((&h::CAVITATES, None), Role::Output)
        };
        list.push((flag, Slot::Cavitates));
        list.push((Variable::new((&m::Q_P, None), Role::Output), Slot::Demand));
        list.extend(results);
        list
    }

    /// The equations of motion with the present parameters and inputs.
    fn assemble(&mut self) -> Result<Groups, Fault> {
        let MovingGroups { plc, .. } = self.now.given;
        let given = self.algebraic.of::<SteeredGroups>().given();
        Built::new(given).map_err(|refusal| Fault::outside(refusal.to_string()))?;
        let accuracy = given.accuracy.ok_or_else(absent)?;
        let mut groups = Vec::with_capacity(self.now.groups.len());
        for i in 0..self.now.groups.len() {
            groups.push(self.group(i, &mut |_, value| value)?);
        }
        let control = control(&plc, accuracy.step);
        Ok(Groups { groups, control })
    }

    /// The equations of one group over any scalar: `of` gives each input and parameter in it. The parameters have a machine.
    fn group<P: Calc>(&self, i: usize, of: &mut dyn FnMut(Quantity, f64) -> P) -> Result<WorkingGroup<P>, Fault> {
        let given = self.algebraic.of::<SteeredGroups>().given();
        let mount = given.mounts.get(i).ok_or_else(absent)?;
        let resistance = self.resistance(i, of);
        let mut alone = |symbol, value| of((symbol, None), value);
        let linkage = given.cylinder.ok_or_else(absent)?.map(&mut alone);
        let piston = given.piston.ok_or_else(absent)?.map(&mut alone);
        let body = self.now.given.body.map(&mut alone);
        let oil = self.now.given.oil.map(&mut alone);
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
        Ok(WorkingGroup {
            linkage: linkage.linkage(mount.mirrored),
            cylinder,
            inertia: body.j,
            resistance,
            stops: match mount.range {
                Some(range) => range.map(P::constant),
                None => linkage.ends(mount.mirrored),
            },
            buffer: [STOP * STOP, 2.0 * STOP].map(|factor| body.j * P::constant(factor)),
            supply: oil.p_p,
            command: P::constant(self.now.groups[i].held.command),
        })
    }

    /// What a group resists now: at standstill, or while travelling; nothing without loads.
    fn resistance<P: Calc>(&self, i: usize, of: &mut dyn FnMut(Quantity, f64) -> P) -> P {
        match self.drag(i, of) {
            None => P::constant(0.0),
            Some(drag) if *self.algebraic.of::<SteeredGroups>().given().v_t == 0.0 => drag.standing,
            Some(drag) => drag.travelling,
        }
    }

    /// Resistance of a group to steering over any scalar, in N·m, with the slewing ring's friction, which stays while
    /// travelling; none without loads.
    fn drag<P: Calc>(&self, i: usize, of: &mut dyn FnMut(Quantity, f64) -> P) -> Option<Resistance<P>> {
        let given = self.algebraic.of::<SteeredGroups>().given();
        let load = of((&s::G, Some(i as u16 + 1)), given.loads.get(i)?.g);
        let mut alone = |symbol, value| of((symbol, None), value);
        let tyres = resistance(&given.tyre?.map(&mut alone), load);
        let ring = given.bearing.map(|bearing| friction(&bearing.map(&mut alone), load));
        let standing = tyres.standing + ring.unwrap_or(P::constant(0.0));
        let standing = standing.def(&s::T_G);
        Some(Resistance {
            standing,
            travelling: (standing - tyres.standing + tyres.travelling).def(&s::T_GX),
        })
    }

    /// Whether a group is between its end stops.
    pub(crate) fn moves_freely(&mut self, i: usize) -> Result<bool, Fault> {
        let theta = self.now.groups[i].run.states()[0];
        let [low, high] = self.level()?.groups[i].stops;
        Ok(theta >= low && theta <= high)
    }

    /// Runs the equations of one group as they are now under the recorder, and those of a sample of the PLC. Returns what
    /// they begin from besides what is given.
    pub(crate) fn recorded(&mut self, i: usize) -> Result<Vec<(&'static Symbol, f64)>, Fault> {
        let (present, wanted) = (self.now.groups[i], self.wanted(i)?);
        let (states, Groups { groups, control: plc }) = (present.run.states(), self.level()?);
        let (mirrored, steps, step) = (groups[i].linkage.mirrored, plc.steps(states[0]), plc.resolution);
        let mut group = self.group(i, &mut |(symbol, _), value| Rec::given(symbol, value))?;
        let mut begun: Vec<(&'static Symbol, f64)> = OF_GROUP.iter().map(|(symbol, _)| *symbol).zip(states).collect();
        begun.extend([(&m::U_V, present.held.command), (&m::THETA_W, wanted)]);
        begun.extend([(&m::I_E, present.held.integral), (&m::N_E, steps)]);
        // Without loads nothing resists.
        let drag = self.drag(i, &mut |_, value| value);
        begun.extend(drag.is_none().then_some((&s::T_G, 0.0)));
        let all: Vec<Rec> = begun.iter().map(|&(symbol, value)| Rec::given(symbol, value)).collect();
        let y: [Rec; STATES] = std::array::from_fn(|k| all[k]);
        let [command, wanted, held, steps] = std::array::from_fn(|k| all[STATES + k]);
        group.command = command;
        group.resistance = all.get(STATES + 4).copied().unwrap_or(group.resistance);
        group.equations(&y);
        let plc = control(
            &self.now.given.plc.map(&mut Rec::given),
            Rec::given(&s::RESOLUTION, step),
        );
        plc.asked(held, wanted, [y[0], steps], mirrored);
        Ok(begun)
    }

    /// A parameter has changed.
    fn changed(&mut self) {
        // Where there is no machine, the next call that needs one says why.
        self.level = self.assemble().ok();
        for present in &mut self.now.groups {
            present.interrupt();
        }
    }

    /// A load, the travel speed or the pump's pressure may have changed.
    fn loaded(&mut self) {
        let supply = self.now.given.oil.p_p;
        for i in 0..self.now.groups.len() {
            let resistance = self.resistance(i, &mut |_, value| value);
            let Some(level) = &mut self.level else { return };
            let group = &mut level.groups[i];
            // An importer that repeats itself does not interrupt the solver.
            if group.resistance != resistance || group.supply != supply {
                (group.resistance, group.supply) = (resistance, supply);
                self.now.groups[i].interrupt();
            }
        }
    }

    fn level(&mut self) -> Result<&Groups, Fault> {
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
        for i in 0..self.now.groups.len() {
            let wanted = self.wanted(i)?;
            let y = self.level()?.groups[i].resting(wanted, RESTING_PRESSURE);
            self.now.groups[i] = PresentGroup::new(y);
        }
        self.now.clock = Clock::STOPPED;
        Ok(())
    }

    /// The group with the least pressure of its oil, and that pressure, in Pa.
    fn lowest(&self) -> (usize, f64) {
        let groups = self.now.groups.iter().enumerate();
        let all = groups.map(|(i, present)| (i, WorkingGroup::oil(&present.run.states()).least().1));
        all.fold((0, f64::INFINITY), |a, b| if b.1 < a.1 { b } else { a })
    }

    fn of_group(&mut self, of: OfGroup, i: usize) -> Result<f64, Fault> {
        let present = self.now.groups[i];
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
        group: &WorkingGroup<P>,
        y: &[P; STATES],
        scalar: &mut dyn FnMut(Quantity, f64) -> P,
    ) -> Result<P, Fault> {
        let (theta, omega) = (y[0], y[1]);
        let pose = group.pose(theta);
        let drag = |found: Option<Resistance<P>>| found.ok_or_else(absent);
        Ok(match of {
            OfGroup::Force => group.cylinder.force(&WorkingGroup::oil(y)),
            OfGroup::Reaction => group.reaction(theta, omega),
            OfGroup::Demand => group.demand(y),
            OfGroup::Length => pose.l,
            OfGroup::Arm => pose.od,
            OfGroup::Speed => pose.od * omega,
            OfGroup::Flow => {
                let piston = self.algebraic.of::<SteeredGroups>().given().piston.ok_or_else(absent)?;
                flow(
                    &piston.map(&mut |symbol, value| scalar((symbol, None), value)),
                    &(pose.od * omega),
                )
            }
            OfGroup::ForceStanding => force(drag(self.drag(i, scalar))?.standing, pose.od),
            OfGroup::ForceTravelling => force(drag(self.drag(i, scalar))?.travelling, pose.od),
            OfGroup::Wanted | OfGroup::Error | OfGroup::Command | OfGroup::Rolling => return Err(absent()),
        })
    }

    /// The PLC reads all encoders and sets all valves.
    fn sample(&mut self, time: f64) -> Result<(), Fault> {
        self.update()?;
        for i in 0..self.now.groups.len() {
            let wanted = self.wanted(i)?;
            let Some(Groups { groups, control }) = &mut self.level else {
                return Err(absent());
            };
            self.now.groups[i].sample(&mut groups[i], control, wanted);
        }
        let control = self.level()?.control;
        self.now.clock = self.now.clock.sampled(&control, time);
        Ok(())
    }

    fn solve(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        let control = self.level()?.control;
        let MovingGroups { body, oil, .. } = self.now.given;
        let samples = (to - from) / control.period * self.now.groups.len() as f64;
        if samples > f64::from(MOST_IMPLICIT) {
            return Err(self.refusal(Halt::TooMany, 0, to - from));
        }
        let mut time = from;
        while time < to {
            if self.now.clock.is_due(&control, time) {
                self.set_time(time);
                self.sample(time)?;
            }
            let end = self.now.clock.next_before(&control, to).unwrap_or(to);
            for i in 0..self.now.groups.len() {
                let Some(level) = &self.level else { return Err(absent()) };
                let present = &mut self.now.groups[i];
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
        let at = self.now.groups[group].run.states()[0];
        let angle = format!("theta[{}] = {}", group + 1, s::THETA.written(at));
        let size = short(size);
        Fault::outside(match halt {
            Halt::Outside => format!(
                "the motion from {angle} ends within {size} s beyond its cylinder or beyond all reasonable numbers: \
                 keep J above what the oil moves, and V_0 above what an end stop gives way"
            ),
            // Its solver is implicit, for which no step is too fast.
            Halt::TooSmall | Halt::TooMany | Halt::TooFast => format!(
                "the step of {size} s from {angle} needs more than the {MOST_IMPLICIT} inner steps that are allowed, \
                 at T_c = {} s: take smaller communication steps, a longer cycle or a coarser tolerance",
                short(self.now.given.plc.t_c)
            ),
        })
    }

    /// The derivative of a variable that follows from a result of the algebraic model which is searched for: zero
    /// where nothing changes that this follows from.
    fn searched(&self, tangent: &Direction, variable: &Variable, inner: usize) -> Result<Dual64, Fault> {
        let Some(known) = tangent.changing().find(|known| self.algebraic.follows(inner, *known)) else {
            return Ok(Dual64::from_re(0.0));
        };
        let by = self.variables.iter().find(|variable| variable.quantity() == known);
        let by = by.map_or(TIME.id.to_owned(), Variable::name);
        Err(Fault::new(format!(
            "{variable} is searched for: it has no derivative by {by}"
        )))
    }

    /// A result of the algebraic model with its derivative.
    fn of_command(&self, tangent: &mut Direction, inner: usize) -> Result<Dual64, Fault> {
        let mut algebraic = match tangent.algebraic.take() {
            Some(algebraic) if tangent.along => algebraic,
            Some(mut algebraic) => {
                self.algebraic
                    .tangent_into(&|quantity| tangent.rate(quantity), &mut algebraic);
                algebraic
            }
            None => self.algebraic.tangent(&|quantity| tangent.rate(quantity)),
        };
        tangent.along = true;
        let found = self.algebraic.with_derivative(&mut algebraic, inner);
        tangent.algebraic = Some(algebraic);
        found
    }

    /// What each variable depends on: of a group its own states and what acts on it, and for what the
    /// command wants what it does in the algebraic model. The PLC's command is held between samples.
    #[must_use]
    pub fn dependencies(&self) -> Vec<BTreeSet<Name>> {
        let name = |symbol: &Symbol, i: usize| -> Name { (symbol.id, Some(i as u16 + 1)) };
        let algebraic = dependencies(&self.algebraic, recorded::<SteeredGroups>);
        let constants: BTreeSet<Name> = self
            .variables
            .iter()
            .filter(|variable| matches!(variable.role, Role::Parameter | Role::Tunable) && variable.number.is_none())
            .map(|variable| (variable.symbol.id, None))
            .collect();
        let loaded = !self.algebraic.of::<SteeredGroups>().given().loads.is_empty();
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
                (0..self.now.groups.len()).flat_map(of).collect()
            }
            Slot::Demand => (0..self.now.groups.len()).flat_map(acting).collect(),
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

impl Running for SteeringMotion {
    fn variables(&self) -> &[Variable] {
        &self.variables
    }

    fn terminals(&self) -> Vec<Terminal> {
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

    fn positions(&self) -> Vec<f64> {
        self.algebraic.positions()
    }

    fn stop_time(&self) -> f64 {
        self.algebraic.stop_time()
    }

    fn step_size(&self) -> f64 {
        self.now.given.plc.t_c
    }

    fn get(&mut self, index: usize) -> Result<f64, Fault> {
        let slot = self.slot(index)?;
        match slot {
            Slot::State(k, i) => Ok(self.now.groups[i].run.states()[k]),
            Slot::Rate(k, i) => {
                let present = self.now.groups[i];
                Ok(self.level()?.rates(i, &present)[k])
            }
            Slot::Indicator(k, i) => {
                let y = self.now.groups[i].run.states();
                Ok(self.level()?.groups[i].indicators(&y)[k])
            }
            Slot::Given => {
                let (wanted, mut found) = (self.variables[index].symbol, f64::NAN);
                self.now.given.map(&mut |symbol, value| {
                    if symbol == wanted {
                        found = value;
                    }
                    value
                });
                Ok(found)
            }
            Slot::Demand => {
                let mut sum = 0.0;
                for i in 0..self.now.groups.len() {
                    sum += self.of_group(OfGroup::Demand, i)?;
                }
                Ok(sum)
            }
            Slot::Cavitates => {
                let (i, _) = self.lowest();
                let (group, y) = (self.level()?.groups[i], self.now.groups[i].run.states());
                let rates = group.equations(&y);
                Ok(f64::from(
                    WorkingGroup::oil(&y).cavitates(|| [2, 3, 4, 5].map(|k| rates[k])),
                ))
            }
            Slot::Vacuum => Ok(self.lowest().1 - VACUUM),
            Slot::Of(of, i) => self.of_group(of, i),
            Slot::Algebraic(inner) => self.algebraic.get(inner),
        }
    }

    fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        let (slot, variable) = (self.slot(index)?, &self.variables[index]);
        match slot {
            Slot::Algebraic(inner) => self.algebraic.check(inner, value),
            Slot::Given => {
                let checked = within(variable.symbol, value);
                checked.map(drop).map_err(|refusal| Fault::outside(refusal.to_string()))
            }
            Slot::State(..) if value.is_finite() => Ok(()),
            Slot::State(..) => Err(Fault::outside(format!("{variable} = {value} is not finite"))),
            _ => Err(Fault::new(format!("{variable} is a result and cannot be set"))),
        }
    }

    fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        self.check(index, value)?;
        let variable = self.variables[index];
        match self.slots[index] {
            Slot::State(k, i) => {
                let mut y = self.now.groups[i].run.states();
                y[k] = value;
                self.now.groups[i].set_states(y);
                Ok(())
            }
            Slot::Given => {
                let mut same = false;
                self.now.given = self.now.given.map(&mut |symbol, old| {
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

    fn set_time(&mut self, time: f64) {
        self.now.time = time;
        self.algebraic.set_time(time);
    }

    fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        let (clock, time) = (self.now.clock, self.now.time);
        self.before.copy_from_slice(&self.now.groups);
        let solved = self.solve(from, to);
        if solved.is_err() {
            self.now.groups.copy_from_slice(&self.before);
            self.now.clock = clock;
            self.set_time(time);
            if let Some(level) = &mut self.level {
                for (group, present) in level.groups.iter_mut().zip(&self.now.groups) {
                    group.command = present.held.command;
                }
            }
        }
        solved
    }

    fn place(&mut self, theta_b: f64) -> Result<(), Fault> {
        self.set(0, theta_b)?;
        self.stand()
    }

    fn start(&mut self) -> Result<(), Fault> {
        self.level()?;
        self.algebraic.start()
    }

    fn update(&mut self) -> Result<(), Fault> {
        self.level()?;
        self.algebraic.update()
    }

    fn event(&mut self) -> Result<bool, Fault> {
        let (time, control) = (self.now.time, self.level()?.control);
        if self.now.clock.is_due(&control, time) {
            self.sample(time)?;
        }
        Ok(false)
    }

    fn next_event(&self) -> Option<f64> {
        let control = &self.level.as_ref()?.control;
        self.now.clock.next(control)
    }

    fn warning(&self) -> Option<&'static str> {
        let groups = self.now.groups.iter();
        warning(groups.fold(self.lowest().1, |least, present| least.min(present.run.least)))
    }

    fn states(&self) -> usize {
        STATES * self.now.groups.len()
    }

    fn count(&self) -> Count {
        let groups = self.now.groups.iter();
        groups.fold(Count::default(), |sum, present| sum.and(present.run.count))
    }

    fn get_states(&self, states: &mut [f64]) {
        let groups = self.now.groups.len();
        for (i, present) in self.now.groups.iter().enumerate() {
            for (k, y) in present.run.states().into_iter().enumerate() {
                states[k * groups + i] = y;
            }
        }
    }

    fn set_states(&mut self, states: &[f64]) -> Result<(), Fault> {
        let groups = self.now.groups.len();
        if let Some(at) = states.iter().position(|value| !value.is_finite()) {
            let (symbol, _) = OF_GROUP[at / groups];
            let number = at % groups + 1;
            return Err(Fault::outside(format!(
                "{}[{number}] = {} is not finite",
                symbol.id,
                short(states[at])
            )));
        }
        for (i, present) in self.now.groups.iter_mut().enumerate() {
            present.set_states(std::array::from_fn(|k| states[k * groups + i]));
        }
        Ok(())
    }

    fn nominals(&self, nominals: &mut [f64]) {
        for ((symbol, _), nominals) in OF_GROUP.iter().zip(nominals.chunks_exact_mut(self.now.groups.len())) {
            nominals.fill(match symbol {
                symbol if symbol.unit.dimension == unit::PA.dimension => 1e5,
                symbol if *symbol == &m::V_V => 1e2,
                _ => 1.0,
            });
        }
    }

    fn rates(&mut self, rates: &mut [f64]) -> Result<(), Fault> {
        let groups = self.now.groups.len();
        for i in 0..groups {
            let present = self.now.groups[i];
            for (k, rate) in self.level()?.rates(i, &present).into_iter().enumerate() {
                rates[k * groups + i] = rate;
            }
        }
        Ok(())
    }

    fn indicators(&self) -> usize {
        INDICATORS * self.now.groups.len() + 2
    }

    fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        let groups = self.now.groups.len();
        for i in 0..groups {
            let y = self.now.groups[i].run.states();
            for (k, indicator) in self.level()?.groups[i].indicators(&y).into_iter().enumerate() {
                indicators[k * groups + i] = indicator;
            }
        }
        indicators[INDICATORS * groups] = self.algebraic.get(self.margin)?;
        indicators[INDICATORS * groups + 1] = self.lowest().1 - VACUUM;
        Ok(())
    }

    fn state(&self) -> State {
        State::new(Saved {
            now: self.now.clone(),
            algebraic: self.algebraic.state(),
        })
    }

    fn state_into(&self, state: &mut State) {
        let Saved { now, algebraic } = state.own_mut();
        now.follow(&self.now);
        self.algebraic.state_into(algebraic);
    }

    fn set_state(&mut self, state: &State) {
        let Saved { now, algebraic } = state.own();
        self.now.follow(now);
        self.algebraic.set_state(algebraic);
        self.level = self.assemble().ok();
    }

    fn numbers(&self, state: &State) -> Vec<f64> {
        let Saved { now, algebraic } = state.own();
        let mut numbers = vec![now.time, now.clock.number()];
        now.given.map(&mut |_, value| {
            numbers.push(value);
            value
        });
        for present in &now.groups {
            numbers.extend(present.numbers());
        }
        numbers.extend(self.algebraic.numbers(algebraic));
        numbers
    }

    fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        let wrong = || Fault::new("a saved state does not belong to this model");
        let (&[time, clock], rest) = numbers.split_first_chunk::<2>().ok_or_else(wrong)?;
        let clock = Clock::of(clock).ok_or_else(wrong)?;
        let mut values = rest.iter();
        let mut complete = time.is_finite();
        let given = self.now.given.map(&mut |_, _| {
            let value = values.next().copied().unwrap_or(f64::NAN);
            complete &= value.is_finite();
            value
        });
        if !complete {
            return Err(wrong());
        }
        let mut rest = values.as_slice();
        let mut groups = Vec::with_capacity(self.now.groups.len());
        for present in &self.now.groups {
            let (found, left) = present.of(rest).ok_or_else(wrong)?;
            groups.push(found);
            rest = left;
        }
        Ok(State::new(Saved {
            now: Now {
                time,
                clock,
                groups,
                given,
            },
            algebraic: self.algebraic.state_of(rest)?,
        }))
    }

    fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent {
        let mut tangent = Tangent::new(Direction {
            few: [((&s::THETA, None), 0.0); FEW],
            count: 0,
            more: Vec::new(),
            algebraic: None,
            along: false,
        });
        self.tangent_into(seed, &mut tangent);
        tangent
    }

    fn tangent_into(&self, seed: &dyn Fn(Quantity) -> f64, tangent: &mut Tangent) {
        let direction: &mut Direction = tangent.own_mut();
        (direction.count, direction.along) = (0, false);
        direction.more.clear();
        let known = self.variables.iter().map(Variable::quantity);
        for quantity in known.chain([(&TIME, None)]) {
            let rate = seed(quantity);
            if rate == 0.0 {
                continue;
            }
            match direction.few.get_mut(direction.count) {
                Some(slot) => (*slot, direction.count) = ((quantity, rate), direction.count + 1),
                None => direction.more.push((quantity, rate)),
            }
        }
    }

    fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        let tangent: &mut Direction = tangent.own_mut();
        let variable = &self.variables[index];
        let of_states = |tangent: &Direction, i: usize| -> Result<(WorkingGroup<Dual64>, [Dual64; STATES]), Fault> {
            let y = self.now.groups[i].run.states();
            let number = Some(i as u16 + 1);
            let y = std::array::from_fn(|k| tangent.dual((OF_GROUP[k].0, number), y[k]));
            Ok((self.group(i, &mut |quantity, value| tangent.dual(quantity, value))?, y))
        };
        let of_group = |tangent: &Direction, of: OfGroup, i: usize| {
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
                for i in 0..self.now.groups.len() {
                    sum += of_group(tangent, OfGroup::Demand, i)?;
                }
                sum
            }
            Slot::Vacuum => {
                let (_, y) = of_states(tangent, self.lowest().0)?;
                WorkingGroup::oil(&y).least().1 - Dual64::from_re(VACUUM)
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
                let theta = self.now.groups[i].run.states()[0];
                rolled(heading, rolling, tangent.dual((&s::THETA, Some(i as u16 + 1)), theta))
            }
            Slot::Of(of, i) => of_group(tangent, of, i)?,
            Slot::Algebraic(inner) if self.algebraic.is_searched(inner) => self.searched(tangent, variable, inner)?,
            Slot::Algebraic(inner) => self.of_command(tangent, inner)?,
            Slot::Given => return Err(Fault::new(format!("{variable} is no result: it has no derivative"))),
        };
        Ok(found.eps)
    }

    fn duplicate(&self) -> Box<dyn Running> {
        Box::new(self.clone())
    }
}

fn control<P: Calc>(plc: &Plc<P>, resolution: P) -> Control<P> {
    Control {
        period: plc.t_c,
        resolution,
        gains: [plc.k_p, plc.k_i],
        limit: plc.u_max,
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
