//! The steering as a running model: a set-point generator. Commands, travel speed,
//! loads and parameters in, angles, speeds, cylinders and forces out.

use std::collections::BTreeSet;

use num_dual::Dual64;

use crate::model::{Enumeration, Fault, Name, Quantity, Role, TIME, Terminal, Type, Variable};
use crate::motion::Motion;
use crate::number::short;
use crate::steering::mode::Mode;
use crate::steering::outputs::{By, Evaluation, Inputs, Output, Parameters};
use crate::steering::scene::{CORNERS, Steering};
use crate::steering::searched::{Search, Searched};
use crate::steering::set_points::{Change, OfChange, SetPoints};
use crate::steering::symbols as s;
use crate::symbol::Symbol;

static MODES: Enumeration = Enumeration {
    name: "Mode",
    items: &[
        ("straight", "All groups straight ahead."),
        ("crab", "All groups at the commanded angle."),
        ("crosswise", "All groups at a right angle; positive travel goes left."),
        ("front_axle", "Turning centre on the rearmost axle line."),
        ("rear_axle", "Turning centre on the foremost axle line."),
        ("all_wheel", "Turning centre midway between foremost and rearmost axle."),
        ("pivot", "About the machine's middle; positive travel turns left."),
        ("corner", "About a corner of the outline."),
        ("free", "About the commanded centre."),
    ],
};

static COMMANDS: Enumeration = Enumeration {
    name: "Command",
    items: &[
        ("angle", "Angle of the base group: theta_b."),
        ("radius", "From the machine's middle line to the turning centre: R_t."),
        ("centre", "The turning centre: x_c, y_c."),
    ],
};

static CORNER: Enumeration = Enumeration {
    name: "Corner",
    items: &[
        (CORNERS[0], "Front left."),
        (CORNERS[1], "Rear left."),
        (CORNERS[2], "Rear right."),
        (CORNERS[3], "Front right."),
    ],
};

/// A scene's machine with its inputs, stepped by the FMU and by tables.
#[derive(Clone, Debug)]
pub struct Model {
    variables: Vec<Variable>,
    slots: Vec<Slot>,
    indicators: Vec<usize>,
    motion: Motion,
    state: State,
    search: Search,
    set_points: SetPoints,
}

/// All that changes in a model while it runs.
#[derive(Clone, Debug)]
pub struct State {
    /// In s.
    time: f64,
    /// Whether a command has been set. Until then the commanded angle runs
    /// through its working range by itself.
    given: bool,
    change: Change,
    evaluation: Evaluation<f64>,
}

/// A model's outputs with their derivatives in one direction.
#[derive(Clone, Debug)]
pub struct Tangent(Evaluation<Dual64>);

#[derive(Clone, Copy, Debug)]
enum Slot {
    ThetaB,
    OmegaS,
    Speed,
    Radius,
    Centre(usize),
    Mode,
    Command,
    Corner,
    Load(usize),
    Parameter,
    Output(Output),
    Searched(Searched),
    OfChange(OfChange),
}

impl Slot {
    /// Whether the variable follows from the others.
    fn follows(self) -> bool {
        matches!(self, Slot::Output(_) | Slot::Searched(_) | Slot::OfChange(_))
    }

    /// Whether it follows from an input, a parameter or [`TIME`].
    fn depends_on(self, (known, number): Quantity) -> bool {
        let any = |lists: &[&[&'static Symbol]]| lists.iter().any(|list| list.contains(&known));
        let load = |group: usize| known == &s::G && number == Some(group as u16 + 1);
        match self {
            Slot::Output(output) => match output {
                Output::Theta(_) | Output::OmegaI(_) => any(&[STANCE]),
                Output::V(_) | Output::Omega | Output::VMx | Output::VMy => any(&[STANCE, SPEED]),
                Output::Ox | Output::Oy | Output::AtInfinity | Output::RO => any(&[STANCE]),
                Output::RIn | Output::ROut | Output::Width => any(&[STANCE]),
                // The range may be that of the cylinder.
                Output::R(_) | Output::Od(_) | Output::Vc(_) | Output::Margin | Output::Reachable => {
                    any(&[STANCE, LINKAGE])
                }
                Output::Delta(_) => any(&[STANCE, LINKAGE, ENCODER]),
                Output::Qg(_) | Output::QSum => any(&[STANCE, LINKAGE, PISTON]),
                Output::Tr(i) => load(i) || any(&[TYRES]),
                Output::Trx(i) => load(i) || any(&[TYRES, TRAVELLING]),
                Output::Tg(i) => load(i) || any(&[TYRES, RING]),
                Output::Fg(i) => load(i) || any(&[TYRES, RING, STANCE, LINKAGE]),
                Output::Fgx(i) => load(i) || any(&[TYRES, TRAVELLING, RING, STANCE, LINKAGE]),
            },
            Slot::Searched(Searched::Slip(_) | Searched::SlipMax) => any(&[STANCE, LINKAGE, ENCODER]),
            Slot::Searched(_) => any(&[STANCE, LINKAGE]),
            Slot::OfChange(OfChange::Speed(_)) => any(&[STANCE, LINKAGE, PACE, SPEED]),
            Slot::OfChange(_) => any(&[STANCE, LINKAGE, PACE]),
            _ => false,
        }
    }
}

/// What results follow from, by what they have in common.
const STANCE: &[&Symbol] = &[
    &s::THETA_B,
    &s::OMEGA_S,
    &s::R_T,
    &s::O_CX,
    &s::O_CY,
    &s::MODE,
    &s::COMMAND,
    &s::CORNER,
    &TIME,
    &s::X_I,
    &s::Y_I,
];
const SPEED: &[&Symbol] = &[&s::V_T];
const LINKAGE: &[&Symbol] = &[&s::R_C, &s::ALPHA, &s::L_X, &s::L_A];
const PISTON: &[&Symbol] = &[&s::D_G, &s::D];
const ENCODER: &[&Symbol] = &[&s::Q_E, &s::B_V];
const PACE: &[&Symbol] = &[&s::V_CX];
const TYRES: &[&Symbol] = &[&s::F_T, &s::P_T];
const TRAVELLING: &[&Symbol] = &[&s::K_V];
const RING: &[&Symbol] = &[&s::L_MAX, &s::MU_R, &s::D_L];

impl Model {
    /// # Errors
    /// Never for a scene that was read by [`Scene::parse`](crate::scene::Scene::parse),
    /// which checks that the machine exists.
    pub fn new(steering: &Steering) -> Result<Model, Fault> {
        let groups = steering.parameters.groups.len();
        let mut model = Model {
            variables: Vec::new(),
            slots: Vec::new(),
            indicators: Vec::new(),
            motion: steering.motion,
            state: State {
                time: 0.0,
                given: false,
                change: Change::new(groups),
                evaluation: Evaluation::new(steering.parameters.clone(), steering.inputs.clone()),
            },
            search: Search::new(groups),
            set_points: SetPoints::new(groups),
        };
        for (symbol, number, role, slot) in list(steering) {
            model.variables.push(Variable {
                symbol,
                number,
                role,
                kind: match slot {
                    Slot::Mode => Type::Enumeration(&MODES),
                    Slot::Command => Type::Enumeration(&COMMANDS),
                    Slot::Corner => Type::Enumeration(&CORNER),
                    Slot::Output(Output::AtInfinity | Output::Reachable) | Slot::OfChange(OfChange::Stand) => {
                        Type::Boolean
                    }
                    _ => Type::Real,
                },
                bounds: bounds(symbol),
            });
            if role == Role::Indicator {
                model.indicators.push(model.slots.len());
            }
            model.slots.push(slot);
        }
        model.update()?;
        Ok(model)
    }

    /// What exists in this scene; an index into it names a variable.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// Number of event indicators: the margin of the ranges, where there are any.
    #[must_use]
    pub fn indicators(&self) -> usize {
        self.indicators.len()
    }

    /// Event indicators, as many as there are: where the margin is zero, the reachable flag changes.
    ///
    /// # Errors
    /// A configuration that does not exist.
    pub fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        for (i, indicator) in indicators.iter_mut().enumerate() {
            *indicator = self.get(self.indicators[i])?;
        }
        Ok(())
    }

    /// What belongs together where something is connected: the machine's motion, and each group with its cylinder.
    #[must_use]
    pub fn terminals(&self) -> Vec<Terminal> {
        let terminal = |name, text, number, members: &[(&'static Symbol, &'static str)]| {
            let of = |symbol: &Symbol| {
                let mut all = self.variables.iter();
                all.find(|variable| variable.symbol == symbol && variable.number == number)
            };
            let members = members.iter();
            Terminal {
                name,
                text,
                members: members
                    .filter_map(|(symbol, member)| Some((of(symbol)?.name(), *member)))
                    .collect(),
            }
        };
        let machine = [(&s::V_MX, "v_x"), (&s::V_MY, "v_y"), (&s::OMEGA, "w")];
        let group = [
            (&s::THETA, "phi"),
            (&s::THETA_S, "phi_set"),
            (&s::OMEGA_I, "w"),
            (&s::V, "v_roll"),
            (&s::V_S, "v_roll_set"),
            (&s::G, "f_z"),
            (&s::L_C, "s"),
            (&s::V_C, "v"),
            (&s::F_G, "f"),
            (&s::Q_G, "q"),
        ];
        let text = "A steered group, and the cylinder that turns it.";
        let numbers = (1..).zip(&self.state.evaluation.parameters().groups);
        let groups = numbers.map(|(number, _)| terminal(format!("group_{number}"), text, Some(number), &group));
        let whole = terminal("machine".to_owned(), "Motion of the machine's middle.", None, &machine);
        std::iter::once(whole).chain(groups).collect()
    }

    /// Values of the commanded angle in tables, in rad.
    #[must_use]
    pub fn positions(&self) -> Vec<f64> {
        self.motion.angles()
    }

    /// Duration of one run through the working range, in s.
    #[must_use]
    pub fn stop_time(&self) -> f64 {
        self.motion.stop_time()
    }

    /// Time for one step of the scene's tables, in s.
    #[must_use]
    pub fn step_size(&self) -> f64 {
        self.motion.step_size()
    }

    /// Value of a variable in SI; truth values are 0 and 1, enumerations count from 1.
    ///
    /// # Errors
    /// Where the command is one that its mode does not take.
    pub fn get(&mut self, index: usize) -> Result<f64, Fault> {
        let slot = self.slot(index)?;
        let State {
            time,
            change,
            evaluation,
            ..
        } = &mut self.state;
        match slot {
            Slot::Output(output) => evaluation.output(output),
            Slot::Searched(what) => self.search.get(evaluation, what),
            Slot::OfChange(what) => self.set_points.get((evaluation, &mut self.search, change), *time, what),
            _ => Ok(self.given(&self.state, index)),
        }
    }

    /// Value of an input or a parameter in a state.
    fn given(&self, state: &State, index: usize) -> f64 {
        let inputs = state.evaluation.inputs();
        let count = |number: usize| (1 + number) as f64;
        match self.slots[index] {
            Slot::ThetaB => inputs.theta_b,
            Slot::OmegaS => inputs.omega_s,
            Slot::Speed => inputs.v_t,
            Slot::Radius => inputs.r_t,
            Slot::Centre(axis) => inputs.centre[axis],
            Slot::Mode => count(Mode::ALL.iter().position(|mode| *mode == inputs.mode).unwrap_or(0)),
            Slot::Command => count(BY.iter().position(|by| *by == inputs.by).unwrap_or(0)),
            Slot::Corner => count(inputs.corner),
            Slot::Load(group) => inputs.loads[group],
            Slot::Parameter => {
                let mut found = f64::NAN;
                let quantity = self.variables[index].quantity();
                state.evaluation.parameters().map(&mut |known, value| {
                    if known == quantity {
                        found = value;
                    }
                });
                found
            }
            Slot::Output(_) | Slot::Searched(_) | Slot::OfChange(_) => f64::NAN,
        }
    }

    /// Whether an input or a parameter may take a value, in SI.
    ///
    /// # Errors
    /// A value that is not finite or outside what the symbol allows, an output, an unknown index.
    pub fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        let (slot, variable) = (self.slot(index)?, &self.variables[index]);
        if slot.follows() {
            return Err(Fault::new(format!("{variable} is a result and cannot be set")));
        }
        if let Type::Enumeration(of) = variable.kind {
            let known = value >= 1.0 && value <= of.items.len() as f64 && value.fract() == 0.0;
            let items = || {
                (1..)
                    .zip(of.items)
                    .map(|(number, (item, _))| format!("{number} {item}"))
            };
            return known.then_some(()).ok_or_else(|| {
                let items = items().collect::<Vec<_>>().join(", ");
                Fault::outside(format!(
                    "{variable} = {} is unknown: it must be one of {items}",
                    short(value)
                ))
            });
        }
        let [least, most] = variable.bounds;
        if value.is_finite() && value >= least && value <= most {
            return Ok(());
        }
        let shown = |value: f64| variable.symbol.written(value);
        let range = match (least.is_finite(), most.is_finite()) {
            (true, true) => format!(" from {} to {}", shown(least), shown(most)),
            (true, false) => format!(" not below {}", shown(least)),
            _ => String::new(),
        };
        Err(Fault::outside(format!(
            "{variable} = {} is not allowed: it must be a finite number{range}",
            shown(value)
        )))
    }

    /// Sets an input or a parameter, in SI.
    ///
    /// # Errors
    /// As [`check`](Model::check); a refused value changes nothing.
    pub fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        self.check(index, value)?;
        let slot = self.slots[index];
        if matches!(slot, Slot::Mode | Slot::Command | Slot::Corner) && self.given(&self.state, index) != value {
            self.leave();
        }
        self.forget();
        let evaluation = &mut self.state.evaluation;
        match slot {
            Slot::OmegaS => {
                evaluation.set_omega_s(value);
                self.sweep();
                return Ok(());
            }
            Slot::Load(group) => {
                evaluation.set_load(group, value);
                return Ok(());
            }
            Slot::Parameter => {
                let quantity = self.variables[index].quantity();
                let parameters = evaluation.parameters();
                let changed = parameters.map(&mut |known, old| if known == quantity { value } else { old });
                evaluation.set_parameters(changed);
                return Ok(());
            }
            Slot::ThetaB => self.state.given = true,
            _ => {}
        }
        self.state.evaluation.command(|inputs| match slot {
            Slot::ThetaB => inputs.theta_b = value,
            Slot::Speed => inputs.v_t = value,
            Slot::Radius => inputs.r_t = value,
            Slot::Centre(axis) => inputs.centre[axis] = value,
            Slot::Mode => inputs.mode = Mode::ALL[value as usize - 1],
            Slot::Command => inputs.by = BY[value as usize - 1],
            _ => inputs.corner = value as usize - 1,
        });
        Ok(())
    }

    /// Moves to a time in s. While the commanded angle has not been set, it follows
    /// from the time: through the working range at the steering speed, then at rest.
    pub fn set_time(&mut self, time: f64) {
        if time != self.state.time {
            self.state.time = time;
            self.set_points.pass();
            self.sweep();
        }
    }

    /// The present inputs and parameters.
    pub(crate) fn inputs(&self) -> &Inputs<f64> {
        self.state.evaluation.inputs()
    }

    pub(crate) fn parameters(&self) -> &Parameters<f64> {
        self.state.evaluation.parameters()
    }

    /// Ends initialization: from now on a mode that changes has a way to go.
    ///
    /// # Errors
    /// As [`update`](Model::update).
    pub fn start(&mut self) -> Result<(), Fault> {
        self.state.change.running = true;
        self.update()
    }

    /// Puts the groups where the current inputs want them.
    ///
    /// # Errors
    /// Parameters without a machine, or a command that its mode does not take.
    pub fn update(&mut self) -> Result<(), Fault> {
        self.state.evaluation.update()
    }

    /// All that changes in the model.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Takes back what [`state`](Model::state) gave, of this model or of one of the same scene.
    pub fn set_state(&mut self, state: &State) {
        self.state.clone_from(state);
        self.forget();
    }

    /// What was found for the inputs holds no longer.
    #[inline]
    fn forget(&mut self) {
        self.search.forget();
        self.set_points.forget();
    }

    /// Keeps the set points of this moment, where the scene has any.
    fn leave(&mut self) {
        let State {
            time,
            change,
            evaluation,
            ..
        } = &mut self.state;
        if evaluation.parameters().pace.is_some() {
            self.set_points.leave((evaluation, &mut self.search), change, *time);
        }
    }

    fn settable(&self) -> impl Iterator<Item = usize> + Clone {
        (0..self.slots.len()).filter(|&index| !self.slots[index].follows())
    }

    /// A state as numbers: time, whether the angle was set, the last change of mode, then
    /// all inputs and parameters in the order of the variables.
    pub fn numbers(&self, state: &State) -> Vec<f64> {
        let values = self.settable().map(|index| self.given(state, index));
        let head = [state.time, f64::from(state.given)].into_iter();
        head.chain(state.change.numbers()).chain(values).collect()
    }

    /// The state that [`numbers`](Model::numbers) belong to.
    ///
    /// # Errors
    /// Numbers that are not those of a state of this model.
    pub fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        let [time, given, values @ ..] = numbers else {
            return Err(Fault::new("a saved state is empty"));
        };
        let mut model = self.clone();
        let change = &mut model.state.change;
        if values.len() != change.count() + self.settable().count() || !time.is_finite() {
            return Err(Fault::new("a saved state does not belong to this model"));
        }
        let (numbers, values) = values.split_at(change.count());
        change.running = false;
        for (index, &value) in self.settable().zip(values) {
            model.set(index, value)?;
        }
        model.state.change.read(numbers);
        model.state.time = *time;
        model.state.given = *given != 0.0;
        Ok(model.state)
    }

    /// The model with derivatives along a direction: `seed` is the rate of change
    /// of each input and parameter, in SI, and of [`TIME`].
    #[must_use]
    pub fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent {
        let evaluation = &self.state.evaluation;
        let mut dual = |quantity, value| Dual64::new(value, seed(quantity));
        let parameters = evaluation.parameters().map(&mut dual);
        let mut inputs = evaluation.inputs().map(&mut dual);
        if !self.state.given {
            let time = Dual64::new(self.state.time, seed((&TIME, None)));
            inputs.theta_b = self.motion.swept(inputs.omega_s, time);
        }
        Tangent(Evaluation::new(parameters, inputs))
    }

    /// Derivative of an output along the direction of a tangent, in SI; not finite where there is none.
    ///
    /// # Errors
    /// Not an output, or a configuration that does not exist.
    pub fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        Ok(self.with_derivative(tangent, index)?.eps)
    }

    /// An output with its derivative, in SI.
    ///
    /// # Errors
    /// Not an output, or a configuration that does not exist.
    pub(crate) fn with_derivative(&self, tangent: &mut Tangent, index: usize) -> Result<Dual64, Fault> {
        let variable = || &self.variables[index];
        let output = match self.slot(index)? {
            Slot::Output(output) => output,
            Slot::Searched(_) | Slot::OfChange(_) => {
                return Err(Fault::new(format!(
                    "{} is searched for: it has no derivative",
                    variable()
                )));
            }
            _ => return Err(Fault::new(format!("{} is no result: it has no derivative", variable()))),
        };
        tangent.0.output(output)
    }

    /// What each variable follows from: inputs, parameters and [`TIME`].
    #[must_use]
    pub fn dependencies(&self) -> Vec<BTreeSet<Name>> {
        let settable = self.settable().map(|index| self.variables[index].quantity());
        let known: Vec<Quantity> = settable.chain([(&TIME, None)]).collect();
        let of = |slot: &Slot| {
            let all = known.iter().filter(|known| slot.depends_on(**known));
            all.map(|(symbol, number)| (symbol.id, *number)).collect()
        };
        self.slots.iter().map(of).collect()
    }

    /// Whether a variable is searched for, and so has no derivative by what it follows from.
    pub(crate) fn is_searched(&self, index: usize) -> bool {
        matches!(self.slots[index], Slot::Searched(_) | Slot::OfChange(_))
    }

    /// Whether a variable follows from an input, a parameter or [`TIME`].
    pub(crate) fn depends_on(&self, index: usize, known: Quantity) -> bool {
        self.slots[index].depends_on(known)
    }

    #[inline]
    fn slot(&self, index: usize) -> Result<Slot, Fault> {
        let found = self.slots.get(index).copied();
        found.ok_or_else(|| Fault::no_variable(index, self.slots.len()))
    }

    /// Follows the time, unless the commanded angle has been set.
    #[inline]
    fn sweep(&mut self) {
        if !self.state.given {
            let theta_b = self
                .motion
                .swept(self.state.evaluation.inputs().omega_s, self.state.time);
            self.state.evaluation.command(|inputs| inputs.theta_b = theta_b);
            self.forget();
        }
    }
}

const BY: [By; 3] = [By::Angle, By::Radius, By::Centre];

/// Smallest and greatest value of a quantity, in SI.
fn bounds(symbol: &'static Symbol) -> [f64; 2] {
    const ANY: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
    const NOT_NEGATIVE: [f64; 2] = [0.0, f64::INFINITY];
    // The same that the parameters' own checks allow.
    let known: [(&Symbol, [f64; 2]); 21] = [
        (&s::THETA_B, [-std::f64::consts::PI, std::f64::consts::PI]),
        (&s::X_I, [-1e4, 1e4]),
        (&s::Y_I, [-1e4, 1e4]),
        (&s::G, NOT_NEGATIVE),
        (&s::F_T, [0.0, 2.0]),
        (&s::P_T, [0.0, 1e7]),
        (&s::K_V, [1.0, 10.0]),
        (&s::L_MAX, [0.0, 100.0]),
        (&s::F_S, [1.0, 10.0]),
        (&s::K_TEST, [1.0, 10.0]),
        (&s::MU_R, [0.0, 1.0]),
        (&s::D_L, [0.0, 100.0]),
        (&s::R_C, [0.0, 10.0]),
        (&s::L_X, [0.0, 10.0]),
        (&s::L_A, [0.0, 10.0]),
        (&s::ALPHA, [-std::f64::consts::TAU, std::f64::consts::TAU]),
        (&s::Q_E, [0.0, 0.2]),
        (&s::B_V, [0.0, 1.0]),
        (&s::V_CX, [f64::MIN_POSITIVE, 10.0]),
        (&s::R_IN, NOT_NEGATIVE),
        (&s::R_OUT, NOT_NEGATIVE),
    ];
    let found = known.into_iter().find(|(known, _)| *known == symbol);
    found.map_or(ANY, |(_, bounds)| bounds)
}

/// Variables of a scene: only what it models.
fn list(steering: &Steering) -> Vec<(&'static Symbol, Option<u16>, Role, Slot)> {
    let mut list: Vec<(&'static Symbol, Option<u16>, Role, Slot)> = Vec::new();
    for (symbol, slot) in [
        (&s::THETA_B, Slot::ThetaB),
        (&s::OMEGA_S, Slot::OmegaS),
        (&s::V_T, Slot::Speed),
        (&s::MODE, Slot::Mode),
        (&s::COMMAND, Slot::Command),
        (&s::CORNER, Slot::Corner),
        (&s::R_T, Slot::Radius),
        (&s::O_CX, Slot::Centre(0)),
        (&s::O_CY, Slot::Centre(1)),
    ] {
        list.push((symbol, None, Role::Input, slot));
    }
    let Steering { parameters, inputs, .. } = steering;
    let loads = inputs.loads.len();
    list.extend(
        (0..loads)
            .zip(1..)
            .map(|(group, number)| (&s::G, Some(number), Role::Input, Slot::Load(group))),
    );
    parameters.map(&mut |(symbol, number), _| {
        // Steel stays as it is; tyres and ground change.
        let tunable = [&s::F_T, &s::P_T, &s::K_V].contains(&symbol);
        let role = if tunable { Role::Tunable } else { Role::Parameter };
        // What the checks of the ring need, and no result.
        if ![&s::F_S, &s::K_TEST].contains(&symbol) {
            list.push((symbol, number, role, Slot::Parameter));
        }
    });
    let groups = parameters.groups.len();
    let mut output = |symbol: &'static Symbol, output| list.push((symbol, None, Role::Output, Slot::Output(output)));
    output(&s::O_X, Output::Ox);
    output(&s::O_Y, Output::Oy);
    output(&s::O_FAR, Output::AtInfinity);
    output(&s::R_O, Output::RO);
    output(&s::OMEGA, Output::Omega);
    output(&s::V_MX, Output::VMx);
    output(&s::V_MY, Output::VMy);
    output(&s::R_IN, Output::RIn);
    output(&s::R_OUT, Output::ROut);
    output(&s::B_S, Output::Width);
    output(&s::REACHABLE, Output::Reachable);
    for (symbol, what) in [
        (&s::THETA_BN, Searched::ThetaB),
        (&s::R_TN, Searched::Radius),
        (&s::O_NX, Searched::CentreX),
        (&s::O_NY, Searched::CentreY),
    ] {
        list.push((symbol, None, Role::Output, Slot::Searched(what)));
    }
    let mut output = |symbol: &'static Symbol, output| list.push((symbol, None, Role::Output, Slot::Output(output)));
    if parameters.piston.is_some() {
        output(&s::Q_SUM, Output::QSum);
    }
    if parameters.accuracy.is_some() {
        list.push((&s::SLIP_MAX, None, Role::Output, Slot::Searched(Searched::SlipMax)));
    }
    if parameters.pace.is_some() {
        for (symbol, what) in [
            (&s::T_X, OfChange::Duration),
            (&s::T_LEFT, OfChange::Left),
            (&s::STAND, OfChange::Stand),
        ] {
            list.push((symbol, None, Role::Output, Slot::OfChange(what)));
        }
    }
    let mut slots = |symbol: &'static Symbol, of: fn(usize) -> Slot| {
        let each = (0..groups).zip(1..);
        list.extend(each.map(|(group, number)| (symbol, Some(number), Role::Output, of(group))));
    };
    slots(&s::THETA_N, |i| Slot::Searched(Searched::Theta(i)));
    if parameters.accuracy.is_some() {
        slots(&s::DELTA, |i| Slot::Output(Output::Delta(i)));
        slots(&s::SLIP, |i| Slot::Searched(Searched::Slip(i)));
    }
    if parameters.pace.is_some() {
        slots(&s::THETA_S, |i| Slot::OfChange(OfChange::SetPoint(i)));
        slots(&s::V_S, |i| Slot::OfChange(OfChange::Speed(i)));
    }
    let mut each = |symbol: &'static Symbol, of: fn(usize) -> Output| {
        list.extend(
            (0..groups)
                .zip(1..)
                .map(|(group, number)| (symbol, Some(number), Role::Output, Slot::Output(of(group)))),
        );
    };
    each(&s::THETA, Output::Theta);
    each(&s::V, Output::V);
    each(&s::OMEGA_I, Output::OmegaI);
    if parameters.cylinder.is_some() {
        each(&s::L_C, Output::R);
        each(&s::OD, Output::Od);
        each(&s::V_C, Output::Vc);
    }
    if parameters.piston.is_some() {
        each(&s::Q_G, Output::Qg);
    }
    if loads > 0 {
        each(&s::T_R, Output::Tr);
        each(&s::T_RX, Output::Trx);
        each(&s::T_G, Output::Tg);
        if parameters.cylinder.is_some() {
            each(&s::F_G, Output::Fg);
            each(&s::F_GX, Output::Fgx);
        }
    }
    list.push((&s::MARGIN, None, Role::Indicator, Slot::Output(Output::Margin)));
    list
}
