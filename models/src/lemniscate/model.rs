//! The mechanism as a running model: inputs and parameters in, outputs out,
//! only what is asked for computed.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use num_dual::Dual64;

use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::calc::Calc;
use crate::lemniscate::geometry::{Driven, Geometry, Parameters};
use crate::lemniscate::outputs::{Evaluation, Inputs, Output};
use crate::lemniscate::scene::{KEYS, Luffing, Motion};
use crate::lemniscate::symbols as s;
use crate::lemniscate::table::Table;
use crate::model::{Fault, Name, Quantity, Role, TIME, Terminal, Type, Variable};
use crate::number::short;
use crate::record::{Rec, record};
use crate::schema::{Key, Kind, Sign};
use crate::symbol::Symbol;

/// A scene's mechanism with its inputs, stepped by the FMU and by tables.
#[derive(Clone, Debug)]
pub struct Model {
    variables: Vec<Variable>,
    slots: Vec<Slot>,
    /// Which numbers may be set, in the order of the variables.
    signs: Vec<Sign>,
    /// At the level `table`, with the column of each variable that has one.
    table: Option<(Arc<Table>, Vec<Option<usize>>)>,
    motion: Motion,
    state: State,
}

/// All that changes in a model while it runs.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// In s.
    time: f64,
    /// Whether the angle of the driven bar has been set. Until then the model
    /// runs through its working range by itself.
    given: bool,
    evaluation: Evaluation<f64>,
}

/// A model's outputs with their derivatives in one direction.
#[derive(Clone, Copy, Debug)]
pub struct Tangent {
    evaluation: Evaluation<Dual64>,
    /// A length that changes alone, of a linkage that would lose its change points with it.
    undoes: Option<&'static Symbol>,
}

impl Tangent {
    /// # Errors
    /// A change of lengths by which the linkage does not stay on its branch.
    pub(crate) fn check(&self) -> Result<(), Fault> {
        let refuse = |symbol: &Symbol| {
            Err(Fault::outside(format!(
                "there is no derivative by {}: with the least change of it the linkage loses its change points, and the \
                 branch on which it passes them",
                symbol.id
            )))
        };
        self.undoes.map_or(Ok(()), refuse)
    }
}

#[derive(Clone, Copy, Debug)]
enum Slot {
    Theta,
    Omega,
    Load,
    Parameter,
    Output(Output),
}

impl Model {
    /// # Errors
    /// Never for a scene that was read by [`Scene::parse`](crate::scene::Scene::parse),
    /// which checks that the mechanism exists over its range.
    pub fn new(luffing: &Luffing) -> Result<Model, Fault> {
        let inputs = Inputs {
            theta: luffing.motion.from,
            omega: luffing.motion.speed,
            q: luffing.q.unwrap_or(0.0),
        };
        let mut model = Model {
            variables: Vec::new(),
            slots: Vec::new(),
            signs: Vec::new(),
            table: None,
            motion: luffing.motion,
            state: State {
                time: 0.0,
                given: false,
                evaluation: Evaluation::new(luffing.parameters, luffing.motion, inputs),
            },
        };
        for (symbol, role, slot) in list(luffing) {
            let sign = allowed(KEYS, symbol).unwrap_or(Sign::Any);
            model.variables.push(Variable {
                symbol,
                number: None,
                role,
                kind: if symbol == &s::P_FAR { Type::Boolean } else { Type::Real },
                bounds: bounds(luffing, symbol, slot, sign),
            });
            model.slots.push(slot);
            model.signs.push(sign);
        }
        if let Some(tolerance) = luffing.table {
            model.tabulate(luffing.q, tolerance);
        }
        model.update()?;
        Ok(model)
    }

    /// Puts a table in the place of the closed form: dimensions and weights cannot be set any more.
    fn tabulate(&mut self, load: Option<f64>, tolerance: f64) {
        let outputs = self
            .variables
            .iter()
            .zip(&self.slots)
            .filter_map(|(variable, slot)| match slot {
                Slot::Output(output) if variable.role == Role::Output && variable.kind == Type::Real => Some(*output),
                _ => None,
            });
        let table = Table::new(
            self.state.evaluation.parameters(),
            &self.motion,
            load,
            outputs,
            tolerance,
        );
        let column = |slot: &Slot| match slot {
            Slot::Output(output) => table.find(*output),
            _ => None,
        };
        let columns = self.slots.iter().map(column).collect();
        self.table = Some((Arc::new(table), columns));
        for (variable, slot) in self.variables.iter_mut().zip(&self.slots) {
            if matches!(slot, Slot::Parameter) {
                variable.role = Role::Calculated;
            }
        }
    }

    /// What a result may be off its closed form by, in SI, with the present inputs; zero where it is the closed form.
    #[must_use]
    pub fn bound(&self, index: usize) -> f64 {
        let column = self
            .table
            .as_ref()
            .and_then(|(table, columns)| Some((table, (*columns.get(index)?)?)));
        column.map_or(0.0, |(table, column)| {
            table.bound(column, self.state.evaluation.inputs())
        })
    }

    /// The table, at its level.
    #[must_use]
    pub fn table(&self) -> Option<&Table> {
        self.table.as_ref().map(|(table, _)| &**table)
    }

    /// Whether the angle lies in the table.
    #[inline]
    fn tabulated(&self, table: &Table) -> Result<(), Fault> {
        let theta = self.state.evaluation.inputs().theta;
        let [from, to] = table.range();
        // A rounding of degrees is not an angle outside.
        if (from - 1e-12..=to + 1e-12).contains(&theta) {
            return Ok(());
        }
        let symbol = self.variables[0].symbol;
        let shown = |angle: f64| short(symbol.shown(angle));
        Err(Fault::outside(format!(
            "{} = {} {unit} lies outside the table from {} to {} {unit}: widen the working range, or set fidelity = \"static\"",
            symbol.id,
            shown(theta),
            shown(from),
            shown(to),
            unit = symbol.display.name
        )))
    }

    /// What exists in this scene; an index into it names a variable.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// What belongs together where another mechanism is connected: only what exists in this scene.
    #[must_use]
    pub fn terminals(&self) -> Vec<Terminal> {
        let exists = |symbol: &Symbol, member: &str| {
            let mut found = self.variables.iter().filter(|variable| variable.symbol == symbol);
            // The shaft is turned by an input; the other bar's angle is a result.
            found.any(|variable| variable.role == Role::Input || !matches!(member, "phi" | "w"))
        };
        let terminal = |name: &str, text, members: &[(&'static Symbol, &'static str)]| Terminal {
            name: name.to_owned(),
            text,
            members: members
                .iter()
                .copied()
                .filter(|(symbol, member)| exists(symbol, member))
                .map(|(symbol, member)| (symbol.id.to_owned(), member))
                .collect(),
        };
        let mut terminals = vec![
            terminal(
                "head",
                "Head A of the jib, where the load hangs.",
                &[
                    (&s::A_X, "x"),
                    (&s::A_Y, "y"),
                    (&s::V_AX, "v_x"),
                    (&s::V_AY, "v_y"),
                    (&s::Q, "f"),
                ],
            ),
            terminal(
                "shaft",
                "Foot of the driven bar, where a moment drives it.",
                &[
                    (&s::THETA_1, "phi"),
                    (&s::OMEGA_1, "w"),
                    (&s::THETA_3, "phi"),
                    (&s::OMEGA_3, "w"),
                    (&s::M_D, "tau"),
                ],
            ),
            terminal(
                "drive",
                "Cylinder or rack between frame and driven bar.",
                &[(&s::L_D, "s"), (&s::V_D, "v"), (&s::F_D, "f"), (&s::Q_D, "q")],
            ),
        ];
        terminals.retain(|terminal| !terminal.members.is_empty());
        terminals
    }

    /// Duration of one run through the working range, in s.
    #[must_use]
    pub fn stop_time(&self) -> f64 {
        self.motion.stop_time()
    }

    /// Values of the first variable in tables, in SI.
    #[must_use]
    pub fn positions(&self) -> Vec<f64> {
        self.motion.angles()
    }

    /// Time for one step of the scene's tables, in s.
    #[must_use]
    pub fn step_size(&self) -> f64 {
        self.motion.step_size()
    }

    /// Value of a variable in SI; truth values are 0 and 1.
    ///
    /// # Errors
    /// Where the value depends on a configuration that does not exist.
    pub fn get(&mut self, index: usize) -> Result<f64, Fault> {
        match self.slot(index)? {
            Slot::Theta => Ok(self.state.evaluation.inputs().theta),
            Slot::Omega => Ok(self.state.evaluation.inputs().omega),
            Slot::Load => Ok(self.state.evaluation.inputs().q),
            Slot::Parameter => Ok(self.parameter(self.variables[index].symbol)),
            Slot::Output(output) => {
                if let Some((table, columns)) = &self.table
                    && let Some(column) = columns[index]
                {
                    self.tabulated(table)?;
                    return Ok(table.value(column, self.state.evaluation.inputs()));
                }
                self.state.evaluation.output(output)
            }
        }
    }

    /// Whether an input or a parameter may take a value, in SI.
    ///
    /// # Errors
    /// A value that is not finite or outside what the symbol allows, an output, an unknown index.
    pub fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        let (slot, symbol, sign) = (self.slot(index)?, self.variables[index].symbol, self.signs[index]);
        if let Slot::Output(_) = slot {
            return Err(Fault::new(format!("{} is a result and cannot be set", symbol.id)));
        }
        if self.table.is_some() && matches!(slot, Slot::Parameter) {
            return Err(Fault::new(format!(
                "{} is fixed in the table and cannot be set: set fidelity = \"static\" to change it",
                symbol.id
            )));
        }
        if !sign.allows(value) {
            return Err(Fault::outside(format!(
                "{} = {} is not allowed: it must be {}",
                symbol.id,
                symbol.written(value),
                sign.words()
            )));
        }
        Ok(())
    }

    /// Sets an input or a parameter, in SI.
    ///
    /// # Errors
    /// As [`check`](Model::check); a refused value changes nothing.
    pub fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        self.check(index, value)?;
        let evaluation = &mut self.state.evaluation;
        match self.slots[index] {
            Slot::Theta => {
                evaluation.set_theta(value);
                self.state.given = true;
            }
            Slot::Omega => {
                evaluation.set_omega(value);
                self.sweep();
            }
            Slot::Load => evaluation.set_q(value),
            _ => {
                let symbol = self.variables[index].symbol;
                let mut change = |known: &'static Symbol, old| if known == symbol { value } else { old };
                evaluation.set_parameters(evaluation.parameters().map(&mut change));
            }
        }
        Ok(())
    }

    /// Moves to a time in s. While the angle of the driven bar has not been
    /// set, it follows from the time: through the working range at the input's
    /// angular velocity, then at rest.
    pub fn set_time(&mut self, time: f64) {
        if time != self.state.time {
            self.state.time = time;
            self.sweep();
        }
    }

    /// Assembles the mechanism at the current inputs.
    ///
    /// # Errors
    /// Parameters with which there is no mechanism, or an angle at which it does
    /// not close, with the values and the allowed range.
    pub fn update(&mut self) -> Result<(), Fault> {
        if let Some((table, _)) = &self.table {
            return self.tabulated(table);
        }
        self.state.evaluation.update()
    }

    /// The parameters as they are now.
    #[must_use]
    pub fn parameters(&self) -> &Parameters<f64> {
        self.state.evaluation.parameters()
    }

    /// Weight of the load as it is now, in N.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.state.evaluation.inputs().q
    }

    /// All that changes in the model.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Takes back what [`state`](Model::state) gave, of this model or of one of the same scene.
    pub fn set_state(&mut self, state: &State) {
        self.state = *state;
    }

    /// A state as numbers: time, whether the angle was set, then all inputs and, but for a table's, all
    /// parameters in the order of the variables.
    pub fn numbers(&self, state: &State) -> Vec<f64> {
        let Inputs { theta, omega, q } = *state.evaluation.inputs();
        let mut numbers = vec![state.time, f64::from(state.given), theta, omega];
        if self.slots.iter().any(|slot| matches!(slot, Slot::Load)) {
            numbers.push(q);
        }
        if self.table.is_none() {
            state.evaluation.parameters().map(&mut |_, value| numbers.push(value));
        }
        numbers
    }

    /// The state that [`numbers`](Model::numbers) belong to.
    ///
    /// # Errors
    /// Numbers that are not those of a state of this model.
    pub fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        let fixed = |slot: &Slot| match slot {
            Slot::Output(_) => true,
            Slot::Parameter => self.table.is_some(),
            _ => false,
        };
        let settable = (0..self.slots.len()).filter(|&index| !fixed(&self.slots[index]));
        let [time, given, values @ ..] = numbers else {
            return Err(Fault::new("a saved state is empty"));
        };
        if values.len() != settable.clone().count() || !time.is_finite() {
            return Err(Fault::new("a saved state does not belong to this model"));
        }
        let mut model = self.clone();
        for (index, &value) in settable.zip(values) {
            model.set(index, value)?;
        }
        model.state.time = *time;
        model.state.given = *given != 0.0;
        Ok(model.state)
    }

    /// The model with derivatives along a direction: `seed` is the rate of change
    /// of each input and parameter, in SI, and of [`TIME`].
    #[must_use]
    pub fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent {
        let seed = |symbol| seed((symbol, None));
        let evaluation = &self.state.evaluation;
        let (mut same_geometry, mut undoes) = (true, None);
        let keeps_branch = evaluation.keeps_branch();
        let parameters = evaluation.parameters().map(&mut |symbol, value| {
            let rate = seed(symbol);
            same_geometry &= rate == 0.0;
            if rate != 0.0 && keeps_branch && [&s::X_1, &s::X_2, &s::X_3, &s::X_5, &s::X_6].contains(&symbol) {
                undoes = Some(symbol);
            }
            Dual64::new(value, rate)
        });
        let inputs = self.inputs_over(|symbol, value| Dual64::new(value, seed(symbol)));
        Tangent {
            evaluation: evaluation.over(parameters, inputs, same_geometry),
            undoes,
        }
    }

    /// Derivative of an output along the direction of a tangent, in SI; not finite where there is none.
    ///
    /// # Errors
    /// Not an output, or a configuration that does not exist.
    pub fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        let Slot::Output(output) = self.slot(index)? else {
            return Err(Fault::new(format!(
                "{} is no result: it has no derivative",
                self.variables[index].symbol.id
            )));
        };
        tangent.check()?;
        Ok(tangent.evaluation.output(output)?.eps)
    }

    /// What each variable's expression contains: inputs, parameters and [`TIME`],
    /// as the recorder finds them all over the working range, in both directions
    /// of motion and with the angle set or following from the time.
    #[must_use]
    pub fn dependencies(&self) -> Vec<BTreeSet<Name>> {
        let mut found = vec![BTreeSet::new(); self.slots.len()];
        let Motion { from, to, speed, .. } = self.motion;
        let middle = f64::midpoint(from, to);
        let mut model = self.clone();
        for given in [false, true] {
            for (theta, omega) in [(from, speed), (middle, speed), (middle, -speed), (to, speed)] {
                let q = model.state.evaluation.inputs().q;
                model.state.given = given;
                model.state.time = (theta - from) / speed;
                let inputs = Inputs { theta, omega, q };
                model.state.evaluation = Evaluation::new(*self.state.evaluation.parameters(), self.motion, inputs);
                let (trace, outputs) = record(|| {
                    let parameters = model.state.evaluation.parameters().map(&mut Rec::given);
                    let inputs = model.inputs_over(Rec::given);
                    let mut evaluation = Evaluation::new(parameters, self.motion, inputs);
                    self.slots
                        .iter()
                        .map(|slot| match slot {
                            // A truth value is no formula: this one is decided by the place of P.
                            Slot::Output(Output::PAtInfinity) => evaluation.output(Output::PX).ok(),
                            Slot::Output(output) => evaluation.output(*output).ok(),
                            _ => None,
                        })
                        .collect::<Vec<_>>()
                });
                for (found, output) in found.iter_mut().zip(outputs) {
                    found.extend(
                        output
                            .into_iter()
                            .flat_map(|output| trace.givens(output))
                            .map(|g| (g.id, None)),
                    );
                }
            }
        }
        found
    }

    /// The inputs over another scalar; an angle that was not set follows from the time.
    fn inputs_over<C: Calc>(&self, f: impl Fn(&'static Symbol, f64) -> C) -> Inputs<C> {
        let Inputs { theta, omega, q } = *self.state.evaluation.inputs();
        let of = |wanted: fn(&Slot) -> bool, value| match self.slots.iter().position(wanted) {
            Some(index) => f(self.variables[index].symbol, value),
            None => C::constant(value),
        };
        let omega = of(|slot| matches!(slot, Slot::Omega), omega);
        let theta = if self.state.given {
            of(|slot| matches!(slot, Slot::Theta), theta)
        } else {
            self.motion.swept(omega, f(&TIME, self.state.time))
        };
        let q = of(|slot| matches!(slot, Slot::Load), q);
        Inputs { theta, omega, q }
    }

    #[inline]
    fn slot(&self, index: usize) -> Result<Slot, Fault> {
        let found = self.slots.get(index).copied();
        found.ok_or_else(|| Fault::no_variable(index, self.slots.len()))
    }

    /// Follows the time, unless the angle has been set.
    #[inline]
    fn sweep(&mut self) {
        if !self.state.given {
            let evaluation = &mut self.state.evaluation;
            evaluation.set_theta(self.motion.swept(evaluation.inputs().omega, self.state.time));
        }
    }

    fn parameter(&self, symbol: &'static Symbol) -> f64 {
        let mut found = f64::NAN;
        self.state.evaluation.parameters().map(&mut |known, value| {
            if known == symbol {
                found = value;
            }
        });
        found
    }
}

/// Smallest and greatest value of a variable, in SI.
fn bounds(luffing: &Luffing, symbol: &'static Symbol, slot: Slot, sign: Sign) -> [f64; 2] {
    let any = [f64::NEG_INFINITY, f64::INFINITY];
    let not_negative = [0.0, f64::INFINITY];
    match slot {
        // Where the linkage closes, if that has ends.
        Slot::Theta => {
            let motion = &luffing.motion;
            let arc = Geometry::new(&luffing.parameters).ok().and_then(|g| {
                let arcs = g.linkage.arcs().into_iter().filter(|_| !g.linkage.turns_fully());
                arcs.into_iter()
                    .find(|arc| arc.from <= motion.from && motion.to <= arc.to)
            });
            arc.map_or(any, |arc| [arc.from, arc.to])
        }
        Slot::Parameter if symbol == &s::BETA_0 => [0.0, TAU],
        Slot::Output(Output::Mu | Output::MuMin | Output::Gamma | Output::GammaMin) => [0.0, FRAC_PI_2],
        Slot::Output(Output::L | Output::Y | Output::LD | Output::DeltaY | Output::EpsilonY) => not_negative,
        Slot::Output(Output::DMMax | Output::DM5Max | Output::NMax | Output::EAbs | Output::EPlus | Output::Travel) => {
            not_negative
        }
        _ if sign != Sign::Any => not_negative,
        _ => any,
    }
}

/// Which numbers the scene's keys allow for a quantity.
fn allowed(keys: &'static [Key], symbol: &'static Symbol) -> Option<Sign> {
    keys.iter().find_map(|key| match (key.number(), &key.kind) {
        (Some((known, sign)), _) if known == symbol && key.name == symbol.id => Some(sign),
        (_, Kind::Table(keys)) => allowed(keys, symbol),
        _ => None,
    })
}

/// Variables of a scene: only what it models.
fn list(luffing: &Luffing) -> Vec<(&'static Symbol, Role, Slot)> {
    let mut list: Vec<(&'static Symbol, Role, Slot)> = Vec::new();
    let boom = luffing.parameters.driven == Driven::Boom;
    let (theta, omega, follower, ratio) = if boom {
        (&s::THETA_1, &s::OMEGA_1, &s::THETA_3, &s::I_3)
    } else {
        (&s::THETA_3, &s::OMEGA_3, &s::THETA_1, &s::I_1)
    };
    list.push((theta, Role::Input, Slot::Theta));
    list.push((omega, Role::Input, Slot::Omega));
    if luffing.q.is_some() {
        list.push((&s::Q, Role::Input, Slot::Load));
    }
    // Steel stays as long as it is; ballast and attachments may change.
    let weights = [
        &s::G_1,
        &s::S_1,
        &s::CHI_1,
        &s::G_2,
        &s::S_2,
        &s::CHI_2,
        &s::G_3,
        &s::S_3,
        &s::CHI_3,
        &b::G_C,
        &b::M_5,
    ];
    luffing.parameters.map(&mut |symbol, _| {
        let role = if weights.contains(&symbol) {
            Role::Tunable
        } else {
            Role::Parameter
        };
        list.push((symbol, role, Slot::Parameter));
    });

    let mut output = |symbol, output| list.push((symbol, Role::Output, Slot::Output(output)));
    output(follower, Output::FollowerAngle);
    output(&s::ALPHA, Output::Alpha);
    output(&s::ALPHA_1, Output::Alpha1);
    output(&s::R, Output::R);
    output(&s::A_X, Output::AX);
    output(&s::A_Y, Output::AY);
    output(&s::B_X, Output::BX);
    output(&s::B_Y, Output::BY);
    output(&s::C_X, Output::CX);
    output(&s::C_Y, Output::CY);
    output(&s::L, Output::L);
    output(&s::Y, Output::Y);
    output(&s::MU, Output::Mu);
    output(&s::I_2, Output::I2);
    output(ratio, Output::IFollower);
    output(&s::V_AX, Output::VAX);
    output(&s::V_AY, Output::VAY);
    output(&s::BETA, Output::Beta);
    output(&s::O1P, Output::O1P);
    output(&s::P_X, Output::PX);
    output(&s::P_Y, Output::PY);
    output(&s::P_FAR, Output::PAtInfinity);
    if luffing.parameters.anchors.is_some() {
        output(&s::L_D, Output::LD);
        output(&s::H_D, Output::HD);
        output(&s::V_D, Output::VD);
        if luffing.parameters.cylinder.is_some() {
            output(&s::Q_D, Output::QD);
        }
    }
    if luffing.q.is_some() {
        output(&s::M_Q, Output::MQ);
        output(&s::M_Q_P, Output::MQP);
        if luffing.parameters.weights.is_some() {
            output(&s::M_G, Output::MG);
        }
        output(&s::M_D, Output::MD);
        if luffing.has_pins() {
            output(&s::F_BX, Output::FBX);
            output(&s::F_BY, Output::FBY);
            output(&s::F_CX, Output::FCX);
            output(&s::F_CY, Output::FCY);
            output(&s::F_O1X, Output::FO1X);
            output(&s::F_O1Y, Output::FO1Y);
            output(&s::F_O3X, Output::FO3X);
            output(&s::F_O3Y, Output::FO3Y);
            output(&s::N_3, Output::N3);
        }
        if luffing.parameters.anchors.is_some() {
            output(&s::F_D, Output::FD);
        }
    }
    let balance = luffing.parameters.balance.as_ref();
    for (symbol, output) in balance
        .map(|form| balanced(form, &luffing.parameters))
        .unwrap_or_default()
    {
        let role = match output {
            Output::DMMax
            | Output::DM5Max
            | Output::EAbs
            | Output::EPlus
            | Output::GammaMin
            | Output::NMax
            | Output::Travel => Role::Calculated,
            _ => Role::Output,
        };
        list.push((symbol, role, Slot::Output(output)));
    }
    for (symbol, output) in [
        (&s::DELTA_Y, Output::DeltaY),
        (&s::EPSILON_Y, Output::EpsilonY),
        (&s::R_MAX, Output::RMax),
        (&s::R_MIN, Output::RMin),
        (&s::MU_MIN, Output::MuMin),
    ] {
        list.push((symbol, Role::Calculated, Slot::Output(output)));
    }
    list
}

/// Results of a balance: only what its kind has.
fn balanced(form: &Form<f64>, p: &Parameters<f64>) -> Vec<(&'static Symbol, Output)> {
    let list = [
        (&b::M_0, Output::M0),
        (&b::M_B, Output::MUr),
        (&b::DM, Output::DM),
        (&b::DM_5, Output::DM5),
        (&b::M_SUM, Output::MSum),
        (&b::M_D_0, Output::MD0),
        (&b::F_D_0, Output::FD0),
        (&b::PSI, Output::Psi),
        (&b::I_5, Output::I5),
        (&b::GAMMA, Output::Gamma),
        (&b::N_1, Output::N1),
        (&b::C_Y, Output::Y5),
        (&b::F_KX, Output::FKX),
        (&b::F_KY, Output::FKY),
        (&b::F_PX, Output::FMX),
        (&b::F_PY, Output::FMY),
        (&b::DM_MAX, Output::DMMax),
        (&b::DM_5_MAX, Output::DM5Max),
        (&b::E_ABS, Output::EAbs),
        (&b::E_PLUS, Output::EPlus),
        (&b::GAMMA_MIN, Output::GammaMin),
        (&b::N_MAX, Output::NMax),
        (&b::TRAVEL, Output::Travel),
    ];
    let exists = |symbol| form.has(symbol) && (symbol != &b::F_D_0 || p.anchors.is_some());
    list.into_iter().filter(|(symbol, _)| exists(symbol)).collect()
}
