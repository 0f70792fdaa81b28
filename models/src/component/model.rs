//! The running model of a scene.

use std::ops::{Deref, DerefMut};

use crate::component::running::{Running, Tangent};
use crate::component::standing::Standing;
use crate::kernel::number::short;
use crate::kernel::variable::{Fault, Role, Variable};

/// The running model of a scene, stepped by the FMU and by tables. Whatever is not said here it does as [`Running`].
#[expect(
    clippy::large_enum_variant,
    reason = "what stands is stepped most, and a box would be one more way to go"
)]
pub enum Model {
    Standing(Standing),
    Moving(Box<dyn Running>),
}

impl Clone for Model {
    fn clone(&self) -> Model {
        match self {
            Model::Standing(model) => Model::Standing(model.clone()),
            Model::Moving(model) => Model::Moving(model.duplicate()),
        }
    }
}

impl Deref for Model {
    type Target = dyn Running;
    fn deref(&self) -> &dyn Running {
        match self {
            Model::Standing(model) => model,
            Model::Moving(model) => &**model,
        }
    }
}

impl DerefMut for Model {
    fn deref_mut(&mut self) -> &mut dyn Running {
        match self {
            Model::Standing(model) => model,
            Model::Moving(model) => &mut **model,
        }
    }
}

/// What is called in every step goes to what stands directly.
macro_rules! of_each {
    ($model:expr, $one:ident => $call:expr) => {
        match $model {
            Model::Standing($one) => $call,
            Model::Moving($one) => $call,
        }
    };
}

#[expect(clippy::missing_errors_doc, reason = "as those of the trait")]
impl Model {
    #[must_use]
    #[inline]
    pub fn variables(&self) -> &[Variable] {
        of_each!(self, model => model.variables())
    }

    #[inline]
    pub fn get(&mut self, index: usize) -> Result<f64, Fault> {
        of_each!(self, model => model.get(index))
    }

    #[inline]
    pub fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        of_each!(self, model => model.set(index, value))
    }

    #[inline]
    pub fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        of_each!(self, model => model.advance(from, to))
    }

    /// Rates of the continuous states, as many as there are.
    ///
    /// # Errors
    /// A configuration that does not exist, or states so great or small that a rate is no number.
    pub fn rates(&mut self, rates: &mut [f64]) -> Result<(), Fault> {
        self.deref_mut().rates(rates)?;
        self.finite(Role::Rate, rates)
    }

    /// Event indicators, as many as there are.
    ///
    /// # Errors
    /// As [`rates`](Model::rates).
    pub fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        self.deref_mut().event_indicators(indicators)?;
        self.finite(Role::Indicator, indicators)
    }

    /// Numbers of a role, in the order of the variables, as an importer may have them.
    fn finite(&self, role: Role, numbers: &[f64]) -> Result<(), Fault> {
        let Some(at) = numbers.iter().position(|number| !number.is_finite()) else {
            return Ok(());
        };
        let mut of_role = self.variables().iter().filter(|variable| variable.role == role);
        let name = of_role.nth(at).map(Variable::name).unwrap_or_default();
        Err(Fault::outside(format!(
            "{name} = {} is no finite number: the states that were set are too great or too small for this mechanism",
            short(numbers[at])
        )))
    }

    /// Which variables differ from position to position of the working range.
    #[must_use]
    pub fn varying(&self) -> Vec<usize> {
        let varies = |role: Role| matches!(role, Role::Input | Role::State | Role::Output);
        let all = self.variables().iter().enumerate();
        all.filter(|(_, variable)| varies(variable.role))
            .map(|(index, _)| index)
            .collect()
    }

    /// The values of some variables (by their indices) at one position of the working range after the other, in SI.
    ///
    /// # Errors
    /// Of each row: a position that does not exist.
    pub fn rows(mut self, varying: &[usize]) -> impl Iterator<Item = Result<Vec<f64>, Fault>> {
        self.positions().into_iter().map(move |value| {
            self.place(value)?;
            varying.iter().map(|&index| self.get(index)).collect()
        })
    }

    /// Derivative of an output or a rate along the direction of a tangent, in SI.
    ///
    /// # Errors
    /// Not a result, or a place where there is no derivative.
    pub fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        let derivative = self.deref().derivative(tangent, index)?;
        if derivative.is_finite() {
            return Ok(derivative);
        }
        let variable = self.variables()[index];
        Err(Fault::outside(format!(
            "{variable} has no derivative in this configuration"
        )))
    }
}
