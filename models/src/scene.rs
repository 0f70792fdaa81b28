//! A scene: the text file that describes a crane.

use std::sync::Arc;

use toml::de::DeTable;

use crate::balance::task::Search;
use crate::book::{BOOK, Book};
use crate::component::mechanism::Mechanism;
use crate::component::model::Model;
use crate::component::sheet::{Drawing, InMotion, Input, Sheet};
use crate::kernel::check;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::json;
use crate::kernel::measure;
use crate::kernel::origin::Origins;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::sign::Sign;
use crate::kernel::text::Text;
use crate::kernel::variable::{Fault, Role, Type, Variable};
use crate::reading::{gather, gravity, is_identifier, mechanism};
use crate::registry;
use crate::request::{Request, SYNTHESIS};
use crate::study::{STUDY, Study};

/// The lemniscate crane. [Li2022, Table 1]
pub const DEFAULT: &str = include_str!("../scenes/lemniscate.toml");

/// A longer scene is refused: the longest known has 10 kB.
pub const LONGEST: usize = 1 << 20;

/// The chapter of inputs with the loads.
const LOAD: &str = "load";

/// Keys of a scene.
pub static KEYS: &[Key] = &[
    Key::new(
        "name",
        Kind::Name,
        "Name of the model and of its files: letters, digits and _.",
    ),
    Key::new("title", Kind::Line, "Title of the book, one line."),
    Key::named(
        gravity::G.id,
        &gravity::G,
        Sign::Positive,
        "Acceleration of gravity, by which masses weigh what they do; without it 9.81 m/s2.",
    )
    .optional(),
    Key::part("project", PROJECT, "Title block of the book."),
    Key::part("book", BOOK, "What the book says, and in how much detail."),
    Key::new(
        "accuracy",
        Kind::Named,
        "How far each result may be off: `lemnis trade` names the cheapest level and solver that keep to it.",
    )
    .optional(),
    Key::part(
        "synthesis",
        SYNTHESIS,
        "A search for quantities of the scene, by `lemnis synth`.",
    ),
    Key::part(
        "study",
        STUDY,
        "What comes of many values of its quantities, by `lemnis sweep`.",
    ),
    registry::LUFFING,
    registry::STEERING,
    registry::SUPPORTS,
    registry::HOPPER,
    registry::GRAB_UNLOADER,
    registry::TROLLEY,
    registry::HULL,
    registry::PARTS[0],
    registry::PARTS[1],
    registry::PARTS[2],
    registry::PARTS[3],
    registry::PARTS[4],
];

static PROJECT: &[Key] = &[
    Key::text("document", "Number of the document."),
    Key::text("crane", "The crane."),
    Key::text("client", "For whom the book is made."),
    Key::text("author", "Who made the calculation."),
    Key::text("checker", "Who checked it."),
    Key::text("approver", "Who approved it."),
    Key::new("date", Kind::Date, "Date of the book; for PDF/A as YYYY-MM-DD.").optional(),
    Key::text("revision", "Revision of the book."),
    Key::new(
        "revisions",
        Kind::Tables(REVISION, 100),
        "What was changed in each revision, the oldest first.",
    )
    .optional(),
];

static REVISION: &[Key] = &[
    Key::text("mark", "Letter or number of the revision."),
    Key::new("date", Kind::Date, "Its date.").optional(),
    Key::text("author", "Who made it."),
    Key::text("text", "What was changed."),
];

/// A checked scene.
#[derive(Clone, Debug)]
pub struct Scene {
    text: Arc<str>,
    name: String,
    title: Text,
    project: Vec<(&'static str, Text)>,
    revisions: Vec<Vec<Text>>,
    pub book: Book,
    /// Where its quantities stand.
    pub given: Origins,
    /// Acceleration of gravity, in m/s².
    pub gravity: f64,
    /// How far results may be off, in SI.
    pub accuracy: Vec<(Variable, f64)>,
    /// A search for its own quantities.
    pub request: Option<Request>,
    /// Many values of its own quantities.
    pub study: Option<Study>,
    /// The table that describes its mechanism.
    pub table: &'static str,
    pub mechanism: Box<dyn Mechanism>,
}

impl Scene {
    /// Reads a scene; the error lists every mistake found.
    ///
    /// # Errors
    /// One diagnostic for each mistake, in the order of the text.
    pub fn parse(text: &str) -> Result<Scene, Vec<Diagnostic>> {
        let (scene, values) = Scene::read(text)?;
        scene.with_request(&values)?.with_study(&values)
    }

    /// As [`parse`](Scene::parse), of the design alone: what the scene asks of a search and of a study is left out.
    ///
    /// # Errors
    /// As there.
    pub fn design(text: &str) -> Result<Scene, Vec<Diagnostic>> {
        Scene::read(text).map(|(scene, _)| scene)
    }

    fn read(text: &str) -> Result<(Scene, Arc<Values>), Vec<Diagnostic>> {
        if text.len() > LONGEST {
            let message = format!("the scene has {} bytes, at most {LONGEST} are read", text.len());
            return Err(vec![
                Diagnostic::new(0..0, message, "here").help("is this the right file?"),
            ]);
        }
        let table = DeTable::parse(text).map_err(|error| {
            let span = error.span().unwrap_or(0..0);
            vec![Diagnostic::new(span, format!("not TOML: {}", error.message()), "here")]
        })?;
        let mut found = Vec::new();
        let mut values = check::check(
            text,
            table.get_ref(),
            0..text.find('\n').unwrap_or(text.len()),
            "",
            KEYS,
            &mut found,
        );
        let name = values.text("name").unwrap_or_default().to_owned();
        if values.text("name").is_some() && !is_identifier(&name) {
            found.push(values.refuse(
                "name",
                format!("the name \"{name}\" cannot name a model"),
                "not an identifier",
                "up to 60 letters, digits and _, beginning with a letter",
            ));
        }
        gather(&mut values, &mut found);
        let gravity = gravity(text, &values, &mut found);
        values.weigh(gravity);
        let mechanism = mechanism(table.get_ref(), &values, gravity, &mut found);
        let book = mechanism
            .as_ref()
            .map(|(_, mechanism)| Book::new(&values, &**mechanism, &mut found));
        match mechanism.zip(book) {
            Some(((table, mechanism), book)) if found.is_empty() => {
                let (shared, values): (Arc<str>, _) = (text.into(), Arc::new(values));
                let project = values.table("project");
                let scene = Scene {
                    text: shared.clone(),
                    name,
                    title: values.words("title").cloned().unwrap_or_default(),
                    project: PROJECT
                        .iter()
                        .filter_map(|key| Some((key.name, project?.words(key.name)?.clone())))
                        .collect(),
                    revisions: project.map_or_else(Vec::new, revisions),
                    book,
                    given: Origins::new(shared, values.clone()),
                    gravity,
                    accuracy: Vec::new(),
                    request: None,
                    study: None,
                    table,
                    mechanism,
                };
                Ok((scene.with_accuracy(&values)?, values))
            }
            _ => {
                found.sort_by_key(|diagnostic| diagnostic.span.start);
                Err(found)
            }
        }
    }

    /// Reads how far results may be off.
    fn with_accuracy(mut self, values: &Values) -> Result<Scene, Vec<Diagnostic>> {
        let named = values.named("accuracy");
        if named.is_empty() {
            if self.is_auto() {
                let place = values.table(self.table).map_or(0..0, |table| table.place("fidelity"));
                let example = self.example_of_accuracy();
                let help = format!("add {example} at the top of the scene, or name a fidelity");
                let message = "fidelity = \"auto\" without an accuracy to keep to";
                return Err(vec![Diagnostic::new(place, message, "needs `accuracy`").help(help)]);
            }
            return Ok(self);
        }
        let model = self.model().map_err(|fault| {
            let refused = Diagnostic::new(values.place("accuracy"), fault.message, "no results to be accurate");
            vec![refused.help("mend what the message names, or set another fidelity")]
        })?;
        let result = |v: &&Variable| matches!(v.role, Role::Output | Role::State) && v.kind == Type::Real;
        let mut found = Vec::new();
        for (name, text, place) in named {
            let Some(variable) = model.variables().iter().filter(result).find(|v| v.name() == *name) else {
                let known = model.variables().iter().filter(result).map(Variable::name);
                let known: Vec<String> = known.collect();
                let message = format!("`accuracy.{name}` is no result of this scene");
                let help = format!("results here: {}", known.join(", "));
                found.push(Diagnostic::new(place.clone(), message, "not known").help(help));
                continue;
            };
            match measure::quantity(text, variable.symbol, Sign::AtMost) {
                Ok(allowed) => self.accuracy.push((*variable, allowed)),
                Err((message, label, help)) => {
                    let message = format!("`accuracy.{name}`: {message}");
                    found.push(Diagnostic::new(place.clone(), message, label).help(help));
                }
            }
        }
        if found.is_empty() { Ok(self) } else { Err(found) }
    }

    /// Reads what is searched for.
    fn with_request(mut self, values: &Values) -> Result<Scene, Vec<Diagnostic>> {
        let Some(table) = values.table("synthesis") else {
            return Ok(self);
        };
        let mut found = Vec::new();
        if let Some(search) = self.search() {
            let message = "the scene asks for two searches";
            let help = "remove one of the tables: `lemnis synth` finds one result";
            found.push(Diagnostic::new(search.task.span.clone(), message, "besides [synthesis]").help(help));
        }
        self.request = Request::read(table, &*self.mechanism, &self.given, self.gravity, &mut found);
        found.sort_by_key(|diagnostic| diagnostic.span.start);
        if found.is_empty() { Ok(self) } else { Err(found) }
    }

    /// Reads which values are studied.
    fn with_study(mut self, values: &Values) -> Result<Scene, Vec<Diagnostic>> {
        if let Some(table) = values.table("study") {
            let mut found = Vec::new();
            self.study = Study::read(table, &*self.mechanism, &self.given, self.gravity, &mut found);
            found.sort_by_key(|diagnostic| diagnostic.span.start);
            if !found.is_empty() {
                return Err(found);
            }
        }
        Ok(self)
    }

    /// The running model.
    ///
    /// # Errors
    /// Never for a scene that was read by [`Scene::parse`], which checks that the mechanism exists.
    pub fn model(&self) -> Result<Model, Fault> {
        self.mechanism.model()
    }

    /// Ids of the sentences that say at which level a scene is modelled, and what its model takes for granted.
    #[must_use]
    pub fn assumptions(&self) -> Vec<&'static str> {
        registry::assumptions(&*self.mechanism)
    }

    /// The synthesis that it asks for.
    #[must_use]
    pub fn search(&self) -> Option<Search<'_>> {
        registry::search(&*self.mechanism)
    }

    /// All that its book says.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        self.told(true)
    }

    /// The same without runs in time.
    #[must_use]
    pub fn sheet_at_rest(&self) -> Sheet {
        self.told(false)
    }

    fn told(&self, runs: bool) -> Sheet {
        let mut sheet = registry::sheet(&*self.mechanism, &self.given, &self.book.positions, runs);
        let loads = sheet.inputs.iter().rposition(|input| input.chapter == LOAD);
        let by_it = |variable: &Variable| variable.symbol == &gravity::G;
        let moves = sheet.motion.as_ref().is_some_and(weighs)
            || self.model().is_ok_and(|model| model.variables().iter().any(by_it));
        if let Some((last, gravity)) = loads.zip(self.weighs(moves)) {
            sheet.inputs.insert(last + 1, gravity);
        }
        sheet
    }

    /// What it looks like with its coordinate at a value of the working range, in SI.
    #[must_use]
    pub fn drawing(&self, at: f64) -> Drawing {
        registry::drawing(&*self.mechanism, at)
    }

    /// The acceleration of gravity, where the top of a scene gives it, or where masses weigh by it, or weights have masses
    /// as they `move`, and no other table gives it.
    fn weighs(&self, moves: bool) -> Option<Input> {
        let id = gravity::G.id;
        let given = self.given.of(id);
        let elsewhere = self.given.of(&format!("{}.dynamics.{id}", self.table)).is_some();
        let shown = given.is_some() || (moves || self.given.has_masses()) && !elsewhere;
        shown.then(|| Input {
            symbol: &gravity::G,
            value: self.gravity,
            number: None,
            chapter: LOAD,
            usual: given.is_none(),
            given: given.cloned(),
            on: None,
        })
    }

    /// A line that asks for some accuracy of a result of this scene.
    #[must_use]
    pub fn example_of_accuracy(&self) -> String {
        let model = self.model();
        let variables = model.as_ref().map_or(&[][..], |model| model.variables());
        let terminals = model.as_ref().map_or_else(|_| Vec::new(), |model| model.terminals());
        let named = |name: &String| variables.iter().find(|variable| variable.name() == *name);
        let told = terminals.iter().flat_map(|terminal| &terminal.members);
        let result = |variable: &&Variable| variable.role == Role::Output && variable.kind == Type::Real;
        // What another model is told first; a millimetre is a usual accuracy of lengths.
        let example = told.filter_map(|(name, _)| named(name)).find(result);
        let example = example.or_else(|| variables.iter().find(result));
        let (name, unit) = example.map_or_else(
            || ("...".to_owned(), "..."),
            |variable| match variable.symbol.display.name {
                "m" => (variable.name(), "mm"),
                unit => (variable.name(), unit),
            },
        );
        format!("accuracy = {{ \"{name}\" = \"1 {unit}\" }}")
    }

    /// The level at which the scene is modelled; of one that leaves it open, the deepest.
    #[must_use]
    pub fn level(&self) -> &'static str {
        self.mechanism.level()
    }

    /// Levels at which the scene's tables allow this mechanism, from cheap to deep.
    #[must_use]
    pub fn levels(&self) -> Vec<&'static str> {
        self.mechanism.levels()
    }

    /// Whether the scene leaves its level to `lemnis trade`.
    #[must_use]
    pub fn is_auto(&self) -> bool {
        self.mechanism.is_auto()
    }

    /// The scene with its mechanism at one of its [`levels`](Scene::levels); its text stays.
    #[must_use]
    pub fn at(&self, level: &str) -> Scene {
        let mut scene = self.clone();
        scene.mechanism.set_level(level);
        scene
    }

    /// The file as it was read, to the byte.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// A C identifier.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// In English, where the scene gives it in several languages.
    #[must_use]
    pub fn title(&self) -> &str {
        self.title.english()
    }

    /// In every language that the scene gives it in.
    #[must_use]
    pub fn titles(&self) -> &Text {
        &self.title
    }

    /// Marks, dates, authors and texts of the revisions, the oldest first;
    /// empty texts where the scene gives none.
    #[must_use]
    pub fn revisions(&self) -> &[Vec<Text>] {
        &self.revisions
    }

    /// Title block: what is given of document, crane, client, author, checker, approver, date, revision.
    #[must_use]
    pub fn project(&self) -> &[(&'static str, Text)] {
        &self.project
    }
}

fn revisions(project: &Values) -> Vec<Vec<Text>> {
    let cell = |table: &Values, key: &Key| table.words(key.name).cloned().unwrap_or_default();
    let row = |table: &Values| REVISION.iter().map(|key| cell(table, key)).collect();
    project.tables("revisions").iter().map(row).collect()
}

/// The JSON Schema of scenes, for editors.
#[must_use]
pub fn json_schema() -> serde_json::Value {
    let mut schema = json::json_schema(KEYS);
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema".into();
    schema["title"] = "Lemnis scene".into();
    schema
}

/// Whether the formulas have the acceleration of gravity.
fn weighs(motion: &InMotion) -> bool {
    let mut names = Vec::new();
    for section in &motion.sections {
        let trace = &section.trace;
        trace
            .steps
            .iter()
            .for_each(|step| trace.names(step.formula, &mut names));
    }
    names.iter().any(|symbol| symbol.id == gravity::G.id)
}
