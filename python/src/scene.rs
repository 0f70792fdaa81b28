//! A checked scene, its names and its models.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use lemnis_models::alone::alone;
use lemnis_models::component::model::Model;
use lemnis_models::component::running::State;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::variable::{Fault, Quantity, Role, Type, Variable};
use lemnis_models::scene;
use numpy::{PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::asked::{Asked, Given};
use crate::edit::{self, Change};
use crate::errors::{ModelError, refused};
use crate::events::Event;
use crate::told::Told;
use crate::{asked, motion, work};

/// A scene that was checked.
#[pyclass(frozen, module = "lemnis._lemnis")]
pub struct Scene {
    scene: Arc<scene::Scene>,
    models: Mutex<Models>,
    variables: Arc<[Variable]>,
    places: HashMap<String, usize>,
    keys: Mutex<HashMap<String, Result<Quantity, String>>>,
    told: OnceLock<Arc<Told>>,
}

/// Running models of one scene.
struct Models {
    pristine: Model,
    initial: State,
    idle: Vec<Model>,
}

type Column<'py> = Bound<'py, PyArray1<f64>>;
/// Rows that failed, and why.
type Faults = Vec<(usize, String)>;

/// Message, label, help, and where that is in the text: the first character and the one behind the last.
type Found = (String, String, Option<String>, usize, usize);

/// Characters of a text before a byte.
fn characters(text: &str, byte: usize) -> usize {
    text.get(..byte)
        .map_or_else(|| text.chars().count(), |before| before.chars().count())
}

/// The scene that a text is, or everything that is wrong with it.
///
/// # Errors
/// A model that cannot be built of a sound scene, which is a mistake of the program.
#[pyfunction]
pub fn parse(py: Python<'_>, text: &str) -> PyResult<(Option<Scene>, Vec<Found>)> {
    match work::here(py, || scene::Scene::parse(text))? {
        Ok(scene) => Ok((Some(Scene::new(scene).map_err(refused)?), Vec::new())),
        Err(found) => {
            let each = found.into_iter().map(|one| {
                let Range { start, end } = one.span;
                let [start, end] = [start, end].map(|byte| characters(text, byte));
                (one.message, one.label, one.help, start, end)
            });
            Ok((None, each.collect()))
        }
    }
}

/// The JSON Schema of scenes, as text.
#[pyfunction]
pub fn schema() -> String {
    format!("{:#}", scene::json_schema())
}

fn role(role: Role) -> &'static str {
    match role {
        Role::Input => "input",
        Role::Parameter => "parameter",
        Role::Tunable => "tunable",
        Role::Output => "output",
        Role::Calculated => "calculated",
        Role::State => "state",
        Role::Rate => "rate",
        Role::Indicator => "indicator",
    }
}

/// Times (s) of events, each with the indicator that fell below zero.
type Met = Vec<(f64, String)>;
/// Key, id, value in SI, SI unit, display unit and its factor, whether the scene gives it, meaning.
type Known<'a> = (&'a str, &'a str, f64, &'a str, &'a str, f64, bool, &'a str);
/// Name, role, SI unit, display unit and its factor, typeset symbol, meaning, source, what its numbers mean.
type Described<'a> = (
    String,
    &'a str,
    &'a str,
    (&'a str, f64),
    &'a str,
    String,
    &'a str,
    Vec<&'a str>,
);

impl Scene {
    fn new(scene: scene::Scene) -> Result<Scene, Fault> {
        let pristine = scene.model()?;
        let variables: Arc<[Variable]> = pristine.variables().into();
        let places = (0..).zip(&*variables).map(|(index, variable)| (variable.name(), index));
        Ok(Scene {
            places: places.collect(),
            variables,
            models: Mutex::new(Models {
                initial: pristine.state(),
                pristine,
                idle: Vec::new(),
            }),
            scene: Arc::new(scene),
            keys: Mutex::default(),
            told: OnceLock::new(),
        })
    }

    /// As it was read.
    pub(crate) fn checked(&self) -> &scene::Scene {
        &self.scene
    }

    /// The same, for other threads.
    pub(crate) fn shared(&self) -> &Arc<scene::Scene> {
        &self.scene
    }

    /// A model as it is at first.
    fn model(&self) -> Model {
        let mut models = self.models.lock().unwrap_or_else(PoisonError::into_inner);
        match models.idle.pop() {
            Some(mut model) => {
                model.set_state(&models.initial);
                model
            }
            None => models.pristine.clone(),
        }
    }

    /// Keeps a model for the next one who needs it.
    fn keep(&self, model: Model) {
        let mut models = self.models.lock().unwrap_or_else(PoisonError::into_inner);
        models.idle.push(model);
    }

    /// Which quantity a name is: of a variable, or a key of the scene.
    fn quantity(&self, name: &str) -> Result<Quantity, String> {
        if let Some(&index) = self.places.get(name) {
            return Ok(self.variables[index].quantity());
        }
        let known = |keys: &HashMap<String, Result<Quantity, String>>| keys.get(name).cloned();
        let lock = || self.keys.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = known(&lock()) {
            return known;
        }
        let found = match self.scene.given.known(name) {
            Some(_) => alone(&self.scene, name),
            None => Err(self.unknown(name)),
        };
        lock().insert(name.to_owned(), found.clone());
        found
    }

    fn unknown(&self, name: &str) -> String {
        let keys = self.scene.given.all().map(|known| known.key.as_str());
        let all = self.places.keys().map(String::as_str).chain(keys);
        let near = all.map(|known| (strsim::damerau_levenshtein(known, name), known)).min();
        let near = near.filter(|(distance, known)| *distance <= 2.max(known.len() / 3));
        let help = near.map_or_else(
            || "`Scene.variables` and `Scene.quantities` list what there is".to_owned(),
            |(_, known)| format!("did you mean `{known}`?"),
        );
        format!("`{name}` is neither a variable nor a quantity of this scene; {help}")
    }

    /// The variable of a name that may be set.
    fn input(&self, name: &str) -> PyResult<usize> {
        if let Some(&index) = self.places.get(name) {
            return Ok(index);
        }
        let quantity = self.quantity(name).map_err(ModelError::new_err)?;
        let index = self
            .variables
            .iter()
            .position(|variable| variable.quantity() == quantity);
        let Some(index) = index else {
            let message = format!(
                "`{name}` is no variable of the model at level \"{}\"",
                self.scene.level()
            );
            return Err(ModelError::new_err(message));
        };
        Ok(index)
    }

    fn output(&self, name: &str) -> PyResult<usize> {
        let found = self.places.get(name).copied();
        found.ok_or_else(|| ModelError::new_err(self.unknown(name)))
    }

    fn outputs(&self, names: &[String]) -> PyResult<Vec<usize>> {
        names.iter().map(|name| self.output(name)).collect()
    }

    fn asked(
        &self,
        names: &[String],
        columns: &[PyReadonlyArray1<'_, f64>],
        count: usize,
        outputs: Vec<usize>,
    ) -> PyResult<Asked> {
        let given = names.iter().zip(columns).map(|(name, column)| {
            let values = column.as_array().to_vec();
            Ok(Given {
                index: self.input(name)?,
                values,
            })
        });
        let given = given.collect::<PyResult<Vec<Given>>>()?;
        Asked::new(&self.variables, given, count, outputs).map_err(ModelError::new_err)
    }

    /// Models for so many threads.
    fn for_threads(&self, threads: usize) -> Vec<Model> {
        (0..threads).map(|_| self.model()).collect()
    }
}

#[pymethods]
impl Scene {
    #[getter]
    fn text(&self) -> &str {
        self.scene.text()
    }

    #[getter]
    fn name(&self) -> &str {
        self.scene.name()
    }

    #[getter]
    fn title(&self) -> &str {
        self.scene.title()
    }

    #[getter]
    fn level(&self) -> &'static str {
        self.scene.level()
    }

    #[getter]
    fn levels(&self) -> Vec<&'static str> {
        self.scene.levels()
    }

    #[getter]
    fn is_auto(&self) -> bool {
        self.scene.is_auto()
    }

    /// Duration and communication step of the default experiment, in s.
    #[getter]
    fn experiment(&self) -> (f64, f64) {
        let model = self.model();
        (model.stop_time(), model.step_size())
    }

    /// Number of continuous states.
    #[getter]
    fn states(&self) -> usize {
        self.model().states()
    }

    /// Its quantities, in the order of the keys.
    fn quantities(&self) -> Vec<Known<'_>> {
        let all = self.scene.given.all();
        let one = |known: &lemnis_models::kernel::origin::Known| {
            let Symbol {
                id,
                unit,
                display,
                text,
                ..
            } = *known.symbol;
            (
                id,
                known.value,
                unit.name,
                display.name,
                display.factor,
                known.given.is_some(),
                text,
            )
        };
        all.map(|known| {
            let (id, value, unit, display, factor, given, text) = one(known);
            (known.key.as_str(), id, value, unit, display, factor, given, text)
        })
        .collect()
    }

    /// The variables of its model, in their order.
    fn variables(&self) -> Vec<Described<'_>> {
        let one = |variable: &Variable| {
            let symbol = variable.symbol;
            let meanings = match variable.kind {
                Type::Real => Vec::new(),
                Type::Boolean => vec!["false", "true"],
                Type::Enumeration(of) => of.items.iter().map(|(item, _)| *item).collect(),
            };
            (
                variable.name(),
                role(variable.role),
                symbol.unit.name,
                (symbol.display.name, symbol.display.factor),
                symbol.print,
                variable.description(),
                symbol.source,
                meanings,
            )
        };
        self.variables.iter().map(one).collect()
    }

    /// Its text with other values.
    ///
    /// # Errors
    /// A key that is none, or a value that cannot stand there.
    fn replaced(&self, changes: Vec<(String, Change)>) -> PyResult<String> {
        edit::replaced(&self.scene, &changes).map_err(ModelError::new_err)
    }

    /// Names of what changes over the working range, and a row of it for each position of the scene's table.
    ///
    /// # Errors
    /// A position that does not exist.
    fn rows<'py>(&self, py: Python<'py>) -> PyResult<(Vec<String>, Vec<Column<'py>>)> {
        let varying = self.model().varying();
        let (model, indices) = (Mutex::new(Some(self.model())), varying.clone());
        let done = work::shared(py, 1, move |stop| {
            let model = model.lock().unwrap_or_else(PoisonError::into_inner).take();
            let rows = model.into_iter().flat_map(|model| model.rows(&indices));
            let going = rows.take_while(|_| !stop.load(std::sync::atomic::Ordering::Relaxed));
            going.collect::<Result<Vec<Vec<f64>>, Fault>>()
        })?;
        let rows = done
            .into_iter()
            .next()
            .unwrap_or_else(|| Ok(Vec::new()))
            .map_err(refused)?;
        let column = |at: usize| PyArray1::from_iter(py, rows.iter().map(|row| row[at]));
        let names = varying.iter().map(|&index| self.variables[index].name());
        Ok((names.collect(), (0..varying.len()).map(column).collect()))
    }

    /// Outputs at so many inputs, each given once or once for each of them; then what failed, with its place.
    ///
    /// # Errors
    /// A name that is none.
    #[pyo3(signature = (names, columns, count, outputs, threads, every))]
    #[expect(clippy::too_many_arguments, reason = "as Python calls it")]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        names: Vec<String>,
        columns: Vec<PyReadonlyArray1<'py, f64>>,
        count: usize,
        outputs: Vec<String>,
        threads: usize,
        every: bool,
    ) -> PyResult<(Vec<Column<'py>>, Faults)> {
        let width = outputs.len();
        let asked = self.asked(&names, &columns, count, self.outputs(&outputs)?)?;
        let threads = asked.threads(threads);
        let rows = if threads == 0 {
            let mut model = self.model();
            let (rows, model) = work::here(py, move || {
                let rows = asked.here(&mut model, every);
                (rows, model)
            })?;
            self.keep(model);
            rows
        } else {
            asked::values(py, asked, self.for_threads(threads), every)?
        };
        let column = |at: usize| {
            if threads == 0 {
                return Ok(PyArray1::from_vec(py, rows.column(at, count)));
            }
            py.check_signals()?;
            let column = py.detach(|| rows.column(at, count));
            Ok(PyArray1::from_vec(py, column))
        };
        Ok(((0..width).map(column).collect::<PyResult<_>>()?, rows.faults))
    }

    /// Derivatives of some results by some inputs at so many inputs: an array of count × of × wrt; then what failed.
    ///
    /// # Errors
    /// A name that is none.
    #[expect(clippy::too_many_arguments, reason = "as Python calls it")]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        names: Vec<String>,
        columns: Vec<PyReadonlyArray1<'py, f64>>,
        count: usize,
        of: Vec<String>,
        wrt: Vec<String>,
        threads: usize,
    ) -> PyResult<(Bound<'py, PyArray3<f64>>, Faults)> {
        let asked = self.asked(&names, &columns, count, self.outputs(&of)?)?;
        let by = wrt.iter().map(|name| self.quantity(name).map_err(ModelError::new_err));
        let by = by.collect::<PyResult<Vec<Quantity>>>()?;
        let shape = [count, of.len(), by.len()];
        let threads = asked.threads(threads).max(1);
        let rows = asked::derivatives(py, asked, by, self.for_threads(threads))?;
        let table = py.detach(|| rows.whole(count));
        Ok((PyArray1::from_vec(py, table).reshape(shape)?, rows.faults))
    }

    /// A run through some times, with values to begin with and inputs of which each has a value for every time: the outputs
    /// at these times, the event indicators that fell below zero on the way with their times (s), and why it ended before the
    /// last of the times, if it did.
    ///
    /// # Errors
    /// A name that is none, a value that cannot be, a motion that cannot begin.
    fn simulate<'py>(
        &self,
        py: Python<'py>,
        start: Vec<(String, f64)>,
        inputs: Vec<String>,
        columns: Vec<PyReadonlyArray1<'py, f64>>,
        times: PyReadonlyArray1<'py, f64>,
        outputs: Vec<String>,
    ) -> PyResult<(Vec<Column<'py>>, Met, Option<String>)> {
        let start = start.iter().map(|(name, value)| Ok((self.input(name)?, *value)));
        let given = inputs.iter().zip(&columns);
        let given = given.map(|(name, column)| Ok((self.input(name)?, column.as_array().to_vec())));
        let run = motion::Run {
            start: start.collect::<PyResult<_>>()?,
            inputs: given.collect::<PyResult<_>>()?,
            times: times.as_array().to_vec(),
            outputs: self.outputs(&outputs)?,
        };
        let done = motion::run(py, run, self.model())?;
        let width = outputs.len();
        let column = |at: usize| PyArray1::from_iter(py, done.table.iter().skip(at).step_by(width).copied());
        let model = self.model();
        let name = |event: &Event| (event.time, model.variables()[event.indicator].name());
        let events = done.events.iter().map(name).collect();
        Ok(((0..width).map(column).collect(), events, done.ended))
    }

    /// What its book would say.
    ///
    /// # Errors
    /// Ctrl+C.
    fn told(&self, py: Python<'_>) -> PyResult<Told> {
        if let Some(told) = self.told.get() {
            return Ok(Told::clone(told));
        }
        let scene = Arc::clone(&self.scene);
        let mut found = work::shared(py, 1, move |_| Told::new(&scene))?;
        let told = found.pop().expect("one thread");
        // Another thread may have been faster, with the same.
        Ok(Told::clone(self.told.get_or_init(|| Arc::new(told))))
    }
}
