//! A mechanism as a scene describes it: what all of them have is made here, once, from what each says of itself.

use std::collections::BTreeSet;
use std::fmt;
use std::ops::{Deref, DerefMut};

use crate::component::aside::Aside;
use crate::component::dependencies::{dependencies, recorded};
use crate::component::extreme::fine;
use crate::component::governing::extremes;
use crate::component::mechanism::{Entry, Mechanism, Solver};
use crate::component::model::Model;
use crate::component::moved::Moved;
use crate::component::moving::MovingComponent;
use crate::component::outline::{Outline, Published};
use crate::component::part::{Component, Runner};
use crate::component::running::Running;
use crate::component::sheet::{Check, Drawing, Input, Sheet, Summary};
use crate::component::stages::{Stages, Use};
use crate::component::standing::Standing;
use crate::component::table::{TOL, TOLERANCE};
use crate::kernel::course::Course;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::origin::Origins;
use crate::kernel::schema::{Key, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::kernel::unit::RAD;
use crate::kernel::variable::{Fault, Name};
use crate::parts::motion::{Motion, Place};

/// The symbols of a mechanism, and the group of words for them.
#[derive(Debug)]
pub struct Vocabulary {
    pub words: &'static str,
    /// Tables of symbols of its own.
    pub own: &'static [&'static [&'static Symbol]],
    /// Those that it shares with others, with their words.
    pub shared: &'static [&'static [&'static Symbol]],
}

impl Vocabulary {
    /// Whether these words say what a symbol is: one of its own, or a shared one whose id none of its own has.
    #[must_use]
    pub fn has(&self, symbol: &Symbol) -> bool {
        let has = |tables: &[&[&'static Symbol]]| tables.iter().any(|table| table.contains(&symbol));
        let mut own = self.own.iter().copied().flatten();
        has(self.own) || has(self.shared) && own.all(|own| own.id != symbol.id)
    }
}

/// What a scene says of a component besides its working range, and what its book tells besides its [`Outline`].
pub trait Described: Clone + fmt::Debug + Send + Sync + Sized + 'static {
    type Component: Component;

    /// By which words and symbols know it.
    const ID: &'static str;

    /// The scene's table that describes it.
    const TABLE: &'static str;

    const OUTLINE: &'static Outline;

    /// Outputs that are followed over a cycle of commands, besides what other parts are designed for.
    const FOLLOWED: &'static [&'static Symbol] = &[];

    /// Two of those that are followed, which are drawn in one figure.
    const TOGETHER: &'static [[&'static Symbol; 2]] = &[];

    const VOCABULARY: &'static Vocabulary;

    /// Reads a checked table under the acceleration of gravity (m/s²), with its working range; mistakes go to the list.
    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(Self, Motion)>;

    /// The sources of its equations, at the start of the working range.
    fn given(this: &Description<Self>) -> <Self::Component as Stages>::Given<f64>;

    /// What else cannot be of one that has been read without a mistake: here, that some result does not exist all over
    /// the working range. What follows from its results is put there.
    fn check(this: &mut Description<Self>, v: &Values, found: &mut Vec<Diagnostic>) {
        possible(this, v, found);
    }

    /// Levels that the scene's tables allow, from cheap to deep.
    fn levels(&self) -> Vec<&'static str> {
        vec!["table", "static"]
    }

    /// Leaves out what a level does not have.
    fn set_level(&mut self, _level: &str) {}

    /// Sets its longest inner step, as in [`Mechanism::step_by`].
    fn step_by(&mut self, _step: f64) {}

    /// What a level has no use for, as in [`Mechanism::unused`].
    fn unused(&self, _level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        Vec::new()
    }

    /// The running model, where it moves by itself.
    fn moving(_this: &Description<Self>) -> Option<Result<MovingComponent, Fault>> {
        None
    }

    /// What each variable's expression contains while it moves under its inputs.
    fn follows(model: &MovingComponent) -> Vec<BTreeSet<Name>> {
        dependencies(model.standing(), recorded::<Self::Component>)
    }

    /// How its motion is solved.
    fn solver(&self) -> Option<Solver> {
        None
    }

    /// Those chapters of the book that it has, of `balance`, `cases`, `motion`, `synthesis`, `views`, `sizing` and `charts`.
    fn chapters(&self) -> Vec<&'static str> {
        Vec::new()
    }

    /// Results of the range that searches of its own have found, with their places.
    fn searched(_this: &Description<Self>, _model: &Standing) -> Vec<Summary> {
        Vec::new()
    }

    /// A second coordinate, an input over whose range results are judged too.
    fn aside(_this: &Description<Self>) -> Option<Aside> {
        None
    }

    /// Independent ways to one result, that must agree.
    fn identities(_this: &Description<Self>, _model: &mut Standing) -> Vec<Check> {
        Vec::new()
    }

    /// Results of the whole range that are no variables.
    fn totals(_this: &Description<Self>) -> Vec<Summary> {
        Vec::new()
    }

    fn published(&self) -> Option<&Published> {
        None
    }

    /// Pieces of a curve, where it is not drawn as a whole.
    fn pieces(&self, _id: &'static str, points: Vec<[f64; 2]>) -> Vec<Vec<[f64; 2]>> {
        vec![points]
    }

    /// Puts what is given into the order of the book, where that is not the scene's.
    fn arrange(&self, _inputs: &mut Vec<Input>) {}

    /// Ids of its level and of what its model takes for granted, worded in the templates.
    fn assumptions(this: &Description<Self>) -> Vec<&'static str>;

    /// Ids of what its book does not calculate, worded in the templates.
    fn uncovered(this: &Description<Self>) -> Vec<&'static str>;

    /// What it is in parts that have words of their own.
    fn parts(_this: &Description<Self>) -> Vec<&'static str> {
        Vec::new()
    }

    /// With its coordinate at a value of the working range.
    fn drawing(this: &Description<Self>, at: f64) -> Drawing;

    /// Where a book draws it.
    fn drawn_at(this: &Description<Self>) -> f64 {
        f64::midpoint(this.motion.from, this.motion.to)
    }

    /// Ids of remarks, worded in the templates.
    fn remarks(&self) -> Vec<&'static str> {
        Vec::new()
    }

    /// What is told of it in motion, found beside all else: runs take the longest time of a book.
    fn in_motion(_this: &Description<Self>) -> Option<Moved> {
        None
    }

    /// Length of the rope on which its load swings at the start (m), and gravity (m/s²).
    fn hangs_on(_this: &Description<Self>) -> Option<[f64; 2]> {
        None
    }

    /// Hangs its load on a rope of another length (m).
    fn hang(&mut self, _length: f64) {}

    /// Chapters of its own.
    fn more(_this: &Description<Self>, _model: &mut Standing, _sheet: &mut Sheet) {}
}

/// A mechanism as a scene describes it; SI.
#[derive(Clone, Debug)]
pub struct Description<T> {
    /// What the scene says of this kind of mechanism alone.
    pub own: T,
    /// Working range of the coordinate.
    pub motion: Motion,
    /// Tolerance of the level `table`, as part of each result's range.
    pub table: Option<f64>,
    /// Whether the level is left to the accuracy that the scene asks for.
    pub auto: bool,
    /// What the book checks.
    limits: Vec<(&'static Symbol, f64)>,
    /// What the scene tells over time.
    pub courses: Vec<(&'static Symbol, Course)>,
}

impl<T> Deref for Description<T> {
    type Target = T;
    fn deref(&self) -> &T {
        &self.own
    }
}

impl<T> DerefMut for Description<T> {
    fn deref_mut(&mut self) -> &mut T {
        &mut self.own
    }
}

/// Refuses a mechanism of which some result does not exist all over its working range.
pub fn possible<T: Described>(this: &Description<T>, v: &Values, found: &mut Vec<Diagnostic>) {
    let fault = this.at_level(None).and_then(|mut model| {
        let results = 0..model.variables().len();
        for at in fine(&this.motion) {
            model.set(0, at)?;
            results.clone().try_for_each(|index| model.get(index).map(drop))?;
        }
        Ok(())
    });
    if let Err(fault) = fault {
        let label = "not possible all over the working range";
        let help = "move what it names, or keep the working range away from there";
        found.push(v.refuse("motion", fault.message, label, help));
    }
}

/// Keys of the table of the level `table`.
pub static TABLE: &[Key] = &[Key::quantity(&TOL, Sign::Tolerance)];

/// Tolerance of the level `table`; `None` at other levels. Mistakes go to `found`.
fn interpolation(v: &Values, found: &mut Vec<Diagnostic>) -> Option<f64> {
    let given = v.table("table");
    if v.text("fidelity") != Some("table") {
        if let Some(table) = given.filter(|_| v.text("fidelity") != Some("auto")) {
            found.push(
                Diagnostic::new(table.span.clone(), "an interpolation at another level", "not used")
                    .help("set fidelity = \"table\", or remove this table"),
            );
        }
        return None;
    }
    Some(given.and_then(|table| table.number(TOL.id)).unwrap_or(TOLERANCE))
}

impl<T: Described> Description<T> {
    /// As scenes describe it.
    #[must_use]
    pub const fn entry(kind: &'static str, keys: &'static [Key]) -> Entry {
        Entry {
            table: T::TABLE,
            kind,
            keys,
            read: |v, gravity, found| Some(Box::new(Description::<T>::read(v, gravity, found)?)),
        }
    }

    /// Of a checked table under the acceleration of gravity (m/s²); mistakes go to `found`.
    pub fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<Description<T>> {
        let before = found.len();
        let read = T::read(v, gravity, found);
        let table = interpolation(v, found);
        let (own, motion) = read?;
        let mut described = Description {
            own,
            motion,
            table,
            auto: v.text("fidelity") == Some("auto"),
            limits: v.table("limits").map_or(Vec::new(), Values::own),
            courses: v.courses(),
        };
        if found.len() == before
            && let Err(fault) = described.at_level(None)
        {
            let help = "move what it names, or keep the working range away from there";
            found.push(v.refuse("motion", fault.message, "not possible at its start", help));
        }
        // What could not be read is missing in it: its results are not judged before that is mended.
        if found.is_empty() {
            T::check(&mut described, v, found);
        }
        if found.is_empty()
            && let Some(moving) = described.moving()
        {
            if let Err(fault) = moving {
                let named = fault.about.and_then(|symbol| Some((v.holder(symbol)?, symbol.id)));
                let help = match named {
                    Some(_) => "change it, or begin elsewhere",
                    None => "begin elsewhere, or move what it names",
                };
                let (table, key) = named.unwrap_or((v, "motion"));
                found.push(table.refuse(key, fault.message, "the motion cannot begin so", help));
            } else if let Some(table) = v.table("motion").filter(|_| described.motion.by_part) {
                let what = "an input for what moves by itself";
                let help = "remove it: all inputs of a mechanism in motion may be zero";
                found.push(table.refuse("input", what, "not used", help));
            }
        }
        (found.len() == before).then_some(described)
    }

    /// The running model, where it moves by itself, under what the scene tells over time.
    #[must_use]
    pub fn moving(&self) -> Option<Result<MovingComponent, Fault>> {
        Some(T::moving(self)?.and_then(|model| model.commanded(&self.courses)))
    }

    fn at_level(&self, table: Option<f64>) -> Result<Standing, Fault> {
        let part = Runner::<T::Component, f64>::new(T::given(self));
        Standing::new(Box::new(part), self.motion, table)
    }

    /// In closed form, at the start of its working range.
    ///
    /// # Panics
    /// Never for a scene that was read.
    #[must_use]
    pub fn standing(&self) -> Standing {
        self.at_level(None).expect("checked when the scene was read")
    }

    /// What the scene allows of a result, in SI.
    #[must_use]
    pub fn limit(&self, symbol: &'static Symbol) -> Option<f64> {
        let limit = self.limits.iter().find(|(known, _)| *known == symbol);
        limit.map(|(_, limit)| *limit)
    }

    /// What is given of it, in the order of the book.
    #[must_use]
    pub fn inputs(&self, origins: &Origins) -> Vec<Input> {
        let mut inputs = Vec::new();
        let chapters = T::OUTLINE.inputs;
        let rate = T::Component::GROUPS.iter().position(|(_, used)| *used == Use::Rate);
        let mut speed = None;
        T::Component::each(&T::given(self), &mut |source, (symbol, _), _| {
            speed = speed.or((rate == Some(usize::from(source.group))).then_some(symbol));
        });
        for &(chapter, name) in chapters {
            let path = match name {
                "" => T::TABLE.to_owned(),
                _ => format!("{}.{name}", T::TABLE),
            };
            for (number, known) in origins.within(&path) {
                let key = known.key.rsplit('.').next().unwrap_or_default();
                // What has a chapter of its own is told there; steps are those of tables.
                if name.is_empty() && chapters.iter().any(|(_, name)| *name == key)
                    || name.ends_with("motion") && key == "step"
                {
                    continue;
                }
                inputs.push(Input {
                    symbol: speed
                        .filter(|_| name == "motion" && key == "speed")
                        .unwrap_or(known.symbol),
                    number,
                    value: known.value,
                    chapter,
                    usual: known.given.is_none(),
                    on: known
                        .given
                        .as_ref()
                        .and_then(|given| origins.beside(given, "on"))
                        .map(str::to_owned),
                    given: known.given.clone(),
                });
            }
        }
        self.own.arrange(&mut inputs);
        inputs
    }
}

impl<T: Described> Mechanism for Description<T> {
    fn id(&self) -> &'static str {
        T::ID
    }

    fn model(&self) -> Result<Model, Fault> {
        match self.moving() {
            Some(moving) => moving.map(|model| Model::Moving(Box::new(model))),
            None => {
                let model = self.at_level(self.table);
                model.map(|model| Model::Standing(model.with_part_of_range()))
            }
        }
    }

    fn standing(&self) -> Standing {
        Description::standing(self)
    }

    fn outline(&self) -> &'static Outline {
        T::OUTLINE
    }

    fn published(&self) -> Option<&Published> {
        self.own.published()
    }

    fn motion(&self) -> &Motion {
        &self.motion
    }

    fn levels(&self) -> Vec<&'static str> {
        self.own.levels()
    }

    fn level(&self) -> &'static str {
        match self.levels().last() {
            Some(&"static") if self.table.is_some() => "table",
            last => last.copied().unwrap_or_default(),
        }
    }

    fn is_auto(&self) -> bool {
        self.auto
    }

    fn set_level(&mut self, level: &str) {
        self.auto = false;
        self.table = (level == "table").then_some(TOLERANCE);
        self.own.set_level(level);
    }

    fn interpolate(&mut self, tolerance: f64) {
        self.table = Some(tolerance);
    }

    fn step_by(&mut self, step: f64) {
        self.own.step_by(step);
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        self.own.unused(level)
    }

    fn solver(&self) -> Option<Solver> {
        self.own.solver()
    }

    fn place(&self, text: &str) -> Result<Place, (String, String)> {
        let mut named = vec!["governing", "from", "middle", "to"];
        let model = self.standing();
        named.extend(extremes(&model, T::OUTLINE).map(|(extreme, _)| extreme.symbol.id));
        named.extend(T::searched(self, &model).into_iter().map(|found| found.symbol.id));
        let coordinate = model.variables()[0].symbol;
        let what = match coordinate.unit == &RAD {
            true => "an angle of the working range",
            false => "a value of the working range",
        };
        self.motion.place(text, coordinate, what, &named)
    }

    fn has_chapter(&self, chapter: &str) -> bool {
        match chapter {
            "balance" | "cases" | "motion" | "synthesis" | "views" | "sizing" | "charts" => {
                self.own.chapters().contains(&chapter)
            }
            "cycle" => !self.courses.is_empty() && self.own.solver().is_some(),
            "published" => self.own.published().is_some(),
            "remarks" => !self.own.remarks().is_empty(),
            "sensitivity" => !T::OUTLINE.sensitivity.is_empty(),
            _ => true,
        }
    }

    fn duplicate(&self) -> Box<dyn Mechanism> {
        Box::new(self.clone())
    }
}
