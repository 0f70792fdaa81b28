//! A sheet: everything a book or a table says about one scene, as plain data
//! in SI. It is made from the same functions that the FMU runs; words, units
//! of print and layout are added later, elsewhere.

pub use crate::component::account::{Energy, Integral, Power};
pub use crate::component::checked::{Check, Summary};
pub use crate::component::diagram::{Chart, Curve, Table};
pub use crate::component::drawing::{Drawing, Gauge, Shape};
pub use crate::component::over_time::{Cycle, CycleFigure, CycleRow, Seen, Stand};

use crate::kernel::origin::Origin;
use crate::kernel::record::Trace;
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;

/// All that is known about a scene.
#[derive(Default)]
pub struct Sheet {
    /// Inputs in the order of the scene's chapters.
    pub inputs: Vec<Input>,
    /// What the scene gives in lists of points, by the chapters of inputs.
    pub lists: Vec<(&'static str, Table)>,
    /// Chapters of inputs that only levels in motion use, which this sheet does not calculate.
    pub uncalculated: Vec<&'static str>,
    /// What given quantities that are in no formula are for: see [`Outline`](crate::component::outline::Outline).
    pub uses: Vec<(&'static str, Vec<&'static Symbol>)>,
    /// Formulas that do not depend on the position.
    pub constants: Vec<Section>,
    /// The mechanism in each of its ways of working; empty where it has one.
    pub views: Vec<View>,
    /// What each of these ways asks for at most: its id, how much, and where.
    pub demands: Vec<(&'static str, Summary)>,
    /// The greatest of these, as a result of its own, and in which way.
    pub most_demanded: Option<(&'static str, Summary)>,
    /// From each of these ways to each other one.
    pub changes: Option<Changes>,
    /// Formulas by which parts are chosen; empty where none are.
    pub sizing: Vec<Section>,
    /// Positions at which the formulas are written out.
    pub positions: Vec<Worked>,
    /// Results over the working range, one row for each position of the scene's step.
    pub range: Table,
    /// Curves over the working range, on a grid fine enough to draw.
    pub curves: Vec<Curve>,
    /// Results over two quantities.
    pub charts: Vec<Chart>,
    pub drawing: Drawing,
    /// What is asked of the results.
    pub requirements: Vec<Check>,
    /// Results of which the scene could ask something and does not.
    pub unjudged: Vec<&'static Symbol>,
    /// The calculation against itself: independent ways to one result.
    pub identities: Vec<Check>,
    pub warnings: Vec<Warning>,
    /// Published values beside the computed ones; empty where the scene gives none.
    pub published: Vec<Comparison>,
    /// Where they are printed.
    pub published_source: Option<Text>,
    /// Results of the whole range: level error, work.
    pub summary: Vec<Summary>,
    /// Results with the position where each is greatest (or least) in the whole range.
    pub governing: Vec<Summary>,
    pub sensitivity: Sensitivity,
    /// What the running model gives, in its order: the principal results.
    pub outputs: Vec<&'static Symbol>,
    /// Ids of remarks on the publications, worded in the templates.
    pub remarks: Vec<&'static str>,
    /// Least and greatest values, with their places, of what other parts are designed for.
    pub forces: Vec<[Summary; 2]>,
    /// Ids of what the book does not calculate.
    pub uncovered: Vec<&'static str>,
    /// What the machine is in parts that have words of their own.
    pub parts: Vec<&'static str>,
    pub balance: Option<BalanceSheet>,
    pub cases: Option<CasesSheet>,
    /// The mechanism in motion; `None` where it stands as commanded.
    pub motion: Option<InMotion>,
    /// The run through what the scene tells over time.
    pub cycle: Option<Cycle>,
    /// Whether there are runs in time that were not asked for.
    pub awaits_runs: bool,
    /// See [`Scene::assumptions`](crate::scene::Scene::assumptions).
    pub assumptions: Vec<&'static str>,
}

impl Sheet {
    /// All formulas.
    pub fn sections(&self) -> impl Iterator<Item = &Section> {
        let positions = self.positions.iter().flat_map(|position| &position.sections);
        let motion = self.motion.iter().flat_map(|motion| &motion.sections);
        let cases = self
            .cases
            .iter()
            .flat_map(|cases| cases.worked.iter().flat_map(|one| &one.sections));
        let own = self.constants.iter().chain(&self.sizing);
        own.chain(positions).chain(motion).chain(cases)
    }

    /// Tells of the quantities that are given, that formulas give, and of those over the range.
    pub fn values(&self, tell: &mut dyn FnMut(&'static Symbol, f64)) {
        self.inputs.iter().for_each(|input| tell(input.symbol, input.value));
        let steps = self.sections().flat_map(|section| &section.trace.steps);
        steps.for_each(|step| tell(step.symbol, step.value));
        for row in &self.range.rows {
            self.range
                .columns
                .iter()
                .zip(row)
                .for_each(|(symbol, value)| tell(symbol, *value));
        }
        let states = self.motion.iter().flat_map(|motion| &motion.state);
        states.for_each(|(symbol, value)| tell(symbol, *value));
    }

    /// What the whole range comes to.
    pub fn results(&self) -> impl Iterator<Item = &Summary> {
        let most = self.most_demanded.iter().map(|(_, most)| most);
        self.governing.iter().chain(most).chain(&self.summary)
    }

    /// Requirements and identities.
    pub fn checks(&self) -> impl Iterator<Item = &Check> {
        self.requirements.iter().chain(&self.identities)
    }
}

/// What must be known before any result is believed.
pub struct Warning {
    /// Id of the words.
    pub id: &'static str,
    /// Id of the manoeuvre in which it was so, if it was in one.
    pub manoeuvre: Option<&'static str>,
    /// A quantity, and when or where it was so first.
    pub summary: Summary,
    /// How many times it was so.
    pub count: usize,
}

/// The mechanism in motion: manoeuvres, what they ask of its parts, and its equations at one instant of them.
pub struct InMotion {
    /// Time from the start of a manoeuvre.
    pub time: &'static Symbol,
    /// What moves the mechanism.
    pub coordinate: &'static Symbol,
    /// The time in which drives come up to their speed, in s, where they have one.
    pub ramp: Option<(&'static Symbol, f64)>,
    /// Ids of the sentences that say how the commands of manoeuvres are chosen.
    pub rules: Vec<&'static str>,
    /// At which instant the formulas are worked out: ids of what makes it one and of the manoeuvre, and when it is, in s.
    pub instant: (&'static str, &'static str, f64),
    /// Which of several bodies the formulas speak of, numbered from 1.
    pub of: Option<usize>,
    /// States and commands at that instant.
    pub state: Vec<(&'static Symbol, f64)>,
    /// What its equations have besides, and nobody gives.
    pub constants: Vec<(&'static Symbol, f64)>,
    pub sections: Vec<Section>,
    pub manoeuvres: Vec<Manoeuvre>,
    pub envelope: Vec<Envelope>,
    /// What amounts of the energy are sums of over the time of a manoeuvre.
    pub integrals: Vec<Integral>,
}

/// A named sequence of commands, and a run of the model under it.
pub struct Manoeuvre {
    /// Of its name, and of the sentence that says how its commands are chosen.
    pub id: &'static str,
    /// Of the coordinate.
    pub start: f64,
    /// Inputs with their values, each from its time (s) until the next one's.
    pub commands: Vec<(&'static Symbol, Vec<[f64; 2]>)>,
    /// Duration of the run, and the time between its samples, in s.
    pub run: [f64; 2],
    pub curves: Vec<Curve>,
    pub seen: Seen,
    /// What happened: when (s), and its id.
    pub events: Vec<(f64, &'static str)>,
    /// What a stop came to: found in the run, and in closed form.
    pub stop: Vec<(&'static Symbol, [f64; 2])>,
    /// How many more events there were.
    pub more_events: usize,
    pub energy: Energy,
}

/// Between what values a result lies.
pub struct Envelope {
    pub symbol: &'static Symbol,
    /// At rest over the working range, where it is known.
    pub still: Option<[Summary; 2]>,
    /// In each of the manoeuvres.
    pub moving: Vec<[Stand; 2]>,
}

/// The balance of the boom system over the working range.
pub struct BalanceSheet {
    /// As in a scene: `tail`, `lever` and so on; worded in the templates.
    pub kind: &'static str,
    /// Its parts, by which words speak of it alone: `rod` or `rope`, `pivot`, `pulley` or `rail`, and
    /// `angle` where one of transmission matters.
    pub parts: &'static [&'static str],
    pub drawing: Drawing,
    pub criteria: Vec<Measure>,
    /// Where the published criteria are printed.
    pub published_source: Option<Text>,
    pub equilibria: Vec<RestingPlace>,
    pub curves: Vec<Curve>,
    pub range: Table,
    /// A published table, computed again; empty where the balance is not its.
    pub table: Vec<PublishedRow>,
}

/// What is asked of the machine in cases that the scene names.
#[derive(Default)]
pub struct CasesSheet {
    /// Group of the words that speak of them.
    pub words: &'static str,
    pub names: Vec<Text>,
    /// What is given of each case.
    pub given: Table,
    /// What a standard gives and no text confirms: symbol, number of the case from 1, value, standard.
    pub unconfirmed: Vec<(&'static Symbol, Option<u16>, f64, &'static str)>,
    /// The formulas, each where most is asked.
    pub worked: Vec<WorkedCase>,
    /// Greatest by amount of each result, with its place: of one that is the same in all cases once.
    pub greatest: Vec<Vec<Summary>>,
    /// The same of moments in a publication's form and of the exact ones.
    pub beside: Vec<Vec<Summary>>,
    /// Over the working range, for each case: id of the caption, number of the case from 0, and the results.
    pub ranges: Vec<(&'static str, usize, Table)>,
    pub curves: Vec<Curve>,
    /// What each case must keep.
    pub judged: Vec<JudgedCase>,
}

impl CasesSheet {
    /// What uses most of its limit.
    #[must_use]
    pub fn governs(&self) -> Option<&JudgedCase> {
        let finite = self.judged.iter().filter(|one| one.check.utilisation().is_finite());
        finite.max_by(|one, other| one.check.utilisation().total_cmp(&other.check.utilisation()))
    }
}

/// What a case, from 0, must keep, and the criterion that asks for it, as far as the scene names one.
pub struct JudgedCase {
    pub case: usize,
    pub check: Check,
    pub criterion: Option<Text>,
}

/// Formulas of the case, from 0, and at the place of the coordinate where most is asked.
pub struct WorkedCase {
    pub id: &'static str,
    pub case: usize,
    pub coordinate: &'static Symbol,
    pub at: f64,
    pub sections: Vec<Section>,
    /// What sums of the formulas are made of there: id of the title, names of the rows, and the terms.
    pub terms: Vec<(&'static str, Vec<&'static str>, Table)>,
    /// What the formulas take from there, with the values.
    pub taken: Vec<(&'static Symbol, f64)>,
}

/// A row of a published table, in the publication's own units.
pub struct PublishedRow {
    /// Cells as printed from which the others follow.
    pub given: Vec<&'static str>,
    pub moments: Vec<PublishedCell>,
}

/// A published number beside the one that its own row gives.
pub struct PublishedCell {
    pub printed: &'static str,
    pub computed: f64,
    pub misprint: bool,
}

/// A result that tells how good a balance is.
pub struct Measure {
    pub summary: Summary,
    /// As published, in SI.
    pub published: Option<f64>,
}

/// A position at which weights and balance leave no moment.
pub struct RestingPlace {
    pub coordinate: &'static Symbol,
    pub at: f64,
    pub reach: (&'static Symbol, f64),
    /// The boom comes back when it is moved a little.
    pub stable: bool,
}

/// A given quantity.
pub struct Input {
    pub symbol: &'static Symbol,
    pub value: f64,
    /// Number from 1 where there are several of the quantity.
    pub number: Option<u16>,
    /// Chapter of inputs: `geometry`, `load`, `weights`, `drive`, `motion`, `limits`, ...
    pub chapter: &'static str,
    /// Where the scene gives it.
    pub given: Option<Origin>,
    /// The body that it is on, where the scene says so.
    pub on: Option<String>,
    /// Whether the scene leaves it at what is usual.
    pub usual: bool,
}

/// Formulas under one heading.
#[derive(Default)]
pub struct Section {
    /// Id of the heading, worded in the templates.
    pub id: &'static str,
    pub trace: Trace,
    /// What the formulas speak of, to scale.
    pub drawing: Option<Drawing>,
    /// What they read a value from.
    pub curve: Option<Curve>,
    /// What they give for each of several bodies.
    pub table: Option<Table>,
}

/// A way in which the mechanism works.
pub struct View {
    /// Id of the caption, worded in the templates.
    pub id: &'static str,
    /// What is commanded, if it is a quantity.
    pub command: Option<(&'static Symbol, f64)>,
    /// Whether it can be done.
    pub reachable: bool,
    /// Where it cannot, the nearest way and command with which it can.
    pub nearest: Option<(&'static str, Vec<(&'static Symbol, f64)>)>,
    pub drawing: Drawing,
    pub table: Table,
}

/// Changes between the ways in which the mechanism works.
pub struct Changes {
    /// What the columns of durations and of flows are.
    pub columns: [&'static Symbol; 2],
    pub rows: Vec<Changeover>,
    /// Curves over the time of one change, and the ids of the ways between which it runs.
    pub drawn: Option<([&'static str; 2], Vec<Curve>)>,
}

/// From one way of working to another, and back where no row of its own says otherwise.
pub struct Changeover {
    pub between: [&'static str; 2],
    /// Duration (s), whether the machine must stand, and the number of the group that takes longest; `None` where the
    /// change is not possible.
    pub plan: Option<(f64, bool, usize)>,
    /// Greatest oil flow, in m³/s.
    pub flow: Option<f64>,
}

/// A position of the mechanism with its formulas.
pub struct Worked {
    /// `governing`, `from`, `middle`, `to`, `chosen`, or the id of a governing
    /// result; worded in the templates.
    pub id: &'static str,
    pub coordinate: &'static Symbol,
    pub value: f64,
    /// The second coordinate, where there is one.
    pub aside: Option<(&'static Symbol, f64)>,
    /// Which of several bodies the formulas speak of, numbered from 1.
    pub of: Option<usize>,
    /// What the formulas take from elsewhere, with the values.
    pub taken: Vec<(&'static Symbol, f64)>,
    pub sections: Vec<Section>,
}

/// How results change with the given quantities; empty where they do not do so smoothly.
#[derive(Default)]
pub struct Sensitivity {
    /// Each with its value.
    pub results: Vec<(&'static Symbol, f64)>,
    pub rows: Vec<Slope>,
}

/// Derivatives of the results by one given quantity, in SI.
pub struct Slope {
    pub symbol: &'static Symbol,
    /// Which one of several, from 1.
    pub number: Option<u16>,
    pub value: f64,
    /// In the order of the results.
    pub by: Vec<f64>,
}

/// A published value beside the computed one.
pub struct Comparison {
    pub coordinate: f64,
    pub symbol: &'static Symbol,
    /// As printed, in the display unit, with its own number of digits.
    pub printed: String,
    /// Computed, in SI.
    pub value: f64,
}
