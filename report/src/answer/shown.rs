//! Results as a person reads them, in the words, the symbols and the numbers of the book of a language, and what the
//! mechanism looks like at every position.

use std::panic::resume_unwind;

use lemnis_models::component::sheet::{self, Sheet};
use lemnis_models::kernel::origin::Written;
use lemnis_models::kernel::shared::each;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::variable::{Fault, PART_OF_RANGE, Role, Variable};
use lemnis_models::scene::Scene;
use serde::Serialize;

use crate::answer::drawn::Drawn;
use crate::answer::point::to_nine_digits;
use crate::book::parts;
use crate::book::verdict::{utilisation, verdict};
use crate::language::{Language, Words, symbols};
use crate::print::number::Numbers;
use crate::print::precision;
use crate::print::script::Script;
use crate::results::Results;

#[derive(Serialize)]
pub struct Shown {
    pub language: &'static str,
    pub name: String,
    pub title: String,
    pub level: &'static str,
    /// Whether the level is left to what is measured, and this is the deepest.
    pub open: bool,
    /// All that the scene and the calculation ask of results: whether they are kept, in a word.
    pub verdict: Script,
    pub requirements: Vec<Requirement>,
    pub identities: Vec<Requirement>,
    /// What must be known before any result is believed.
    pub warnings: Vec<Script>,
    pub governing: Vec<Line>,
    pub summary: Vec<Line>,
    /// What varies over the working range, the coordinate first.
    pub columns: Vec<Column>,
    /// As the book draws them.
    pub curves: Vec<Curve>,
    pub published: Vec<Published>,
    /// All that the scene says, by its keys.
    pub given: Vec<Said>,
    pub drawing: Drawn,
    /// Whether the book has runs in time.
    pub runs: bool,
    /// Whether these were not asked for.
    pub awaits_runs: bool,
}

/// Something that is asked of a result.
#[derive(Serialize)]
pub struct Requirement {
    pub sentence: Script,
    /// By which the result is known in FMUs.
    pub of: &'static str,
    /// The label of its formula in the book.
    pub label: &'static str,
    pub symbol: Script,
    pub value: Script,
    /// With its sign of relation.
    pub limit: Script,
    pub passed: bool,
    pub verdict: Script,
    /// In percent; none of a limit of zero, and none of what never comes.
    pub utilisation: Option<String>,
    pub at: Option<Script>,
}

/// A result of the whole range.
#[derive(Serialize)]
pub struct Line {
    pub name: &'static str,
    /// The result whose extreme it is.
    pub of: Option<&'static str>,
    /// The label of its formula in the book.
    pub label: &'static str,
    pub text: Script,
    pub symbol: Script,
    pub value: Script,
    pub at: Option<Script>,
}

#[derive(Serialize)]
pub struct Axis {
    pub symbol: Script,
    /// As printed; empty of a plain number.
    pub unit: &'static str,
    /// What it is, and which way is positive.
    pub text: Script,
}

#[derive(Serialize)]
pub struct Column {
    /// As in FMUs.
    pub name: String,
    #[serde(flatten)]
    pub axis: Axis,
    pub source: &'static str,
    pub output: bool,
    /// One for each position, in the unit that is shown; to nine digits, as curves need them.
    pub values: Vec<f64>,
    /// The same as the book's tables have them.
    pub texts: Vec<String>,
}

#[derive(Serialize)]
pub struct Curve {
    pub caption: Script,
    pub x: Axis,
    pub y: Axis,
    /// In the units that are shown, to nine digits.
    pub pieces: Vec<Vec<[f64; 2]>>,
    /// Numbers of the pieces, where each is that of another body.
    pub numbers: Vec<usize>,
}

/// A value of the scene as it is written there.
#[derive(Serialize)]
pub struct Said {
    pub key: String,
    pub text: String,
    /// Counted from 1.
    pub line: usize,
}

/// A published value at a position, in the units that are shown.
#[derive(Serialize)]
pub struct Published {
    pub name: &'static str,
    pub at: f64,
    pub value: f64,
}

impl From<&Written> for Said {
    fn from(written: &Written) -> Said {
        Said {
            key: written.key.clone(),
            text: written.text.clone(),
            line: written.line,
        }
    }
}

/// The words for a scene, and how its numbers are written.
pub(super) struct Teller<'a> {
    words: &'static Words,
    parts: Vec<&'static str>,
    /// The group of the words for its symbols.
    symbols: &'static str,
    numbers: &'a Numbers,
}

impl<'a> Teller<'a> {
    pub(super) fn new(scene: &Scene, sheet: &Sheet, language: &'static Language, numbers: &'a Numbers) -> Teller<'a> {
        Teller {
            words: language.dictionary(),
            parts: parts(sheet),
            symbols: symbols(scene.mechanism.id()),
            numbers,
        }
    }

    pub(super) fn word(&self, group: &str, id: &str) -> Script {
        self.sentence(group, id, &[])
    }

    /// The id itself where there is no word for it: a reader may know it.
    fn sentence(&self, group: &str, id: &str, named: &[(&str, Script)]) -> Script {
        Script::of_markup(self.words.of_parts(&self.parts, group, id).unwrap_or(id), named)
    }

    fn meaning(&self, symbol: &Symbol) -> Script {
        if symbol == &PART_OF_RANGE {
            return self.word("page", "part_of_range");
        }
        // What moves beside the mechanism has words of its own.
        let own = self.words.of_parts(&self.parts, self.symbols, symbol.id).ok();
        match own.or_else(|| self.words.meaning(symbol)) {
            Some(words) => Script::of_markup(words, &[]),
            None => Script::from(symbol.text),
        }
    }

    pub(super) fn axis(&self, symbol: &'static Symbol, number: Option<u16>) -> Axis {
        let print = number.map(|number| symbol.numbered(number));
        Axis {
            symbol: Script::of_math(print.as_deref().unwrap_or(symbol.print)),
            unit: symbol.display.print,
            text: self.meaning(symbol),
        }
    }

    fn result(&self, symbol: &Symbol, value: f64) -> Script {
        Script::of_math(&self.numbers.result(symbol, value))
    }

    fn at(&self, [at, aside]: [Option<(&'static Symbol, f64)>; 2]) -> Option<Script> {
        self.numbers.place(at, aside).map(|place| Script::of_math(&place))
    }

    fn line(&self, result: &sheet::Summary) -> Line {
        Line {
            name: result.symbol.id,
            of: result.of.map(|of| of.id),
            label: result.of.unwrap_or(result.symbol).print,
            text: self.meaning(result.symbol),
            symbol: Script::of_math(result.symbol.print),
            value: self.result(result.symbol, result.value),
            at: self.at([result.at, result.aside]),
        }
    }

    fn requirement(&self, check: &sheet::Check) -> Requirement {
        let (symbol, numbers) = (check.symbol, self.numbers);
        let relation = if check.at_most { "<=" } else { ">=" };
        Requirement {
            sentence: self.word("check", check.id),
            of: check.of.id,
            label: check.of.print,
            symbol: Script::of_math(symbol.print),
            value: Script::of_math(&numbers.judged(symbol, check.value, check.limit)),
            limit: Script::of_math(&format!("{relation} {}", numbers.limit(symbol, check.limit))),
            passed: check.passed(),
            verdict: self.word("verdict", verdict(check)),
            utilisation: utilisation(check).map(|part| numbers.language.text(&part)),
            at: self.at([check.at, check.aside]),
        }
    }

    fn warning(&self, warning: &sheet::Warning) -> Script {
        let summary = &warning.summary;
        let quantity = Script::of_math(&self.numbers.named(summary.symbol, summary.value));
        let manoeuvre = warning.manoeuvre.map(|id| self.word("manoeuvre", id));
        let named = [
            ("quantity", quantity),
            ("manoeuvre", manoeuvre.unwrap_or_default()),
            ("count", Script::from(warning.count.to_string().as_str())),
            ("at", self.at([summary.at, summary.aside]).unwrap_or_default()),
        ];
        if summary.at.is_some() {
            return self.sentence("warning", warning.id, &named);
        }
        let mut event = self.word("event", warning.id);
        event.append(&" ".into());
        event.append(&self.sentence("warning", "event", &named));
        event
    }

    fn verdict(&self, sheet: &Sheet) -> Script {
        let of = |count: usize| Script::from(count.to_string().as_str());
        let kept = sheet.requirements.iter().filter(|check| check.passed()).count();
        let count = sheet.requirements.len();
        let id = match kept {
            _ if count == 0 => "no_requirements",
            kept if kept == count => "met",
            _ => "not_met",
        };
        self.sentence("text", id, &[("kept", of(kept)), ("count", of(count))])
    }

    fn curve(&self, curve: &sheet::Curve) -> Curve {
        let shown = |[x, y]: [f64; 2]| [curve.x.shown(x), curve.y.shown(y)].map(to_nine_digits);
        Curve {
            caption: self.word("curve", curve.id),
            x: self.axis(curve.x, None),
            y: self.axis(curve.y, None),
            pieces: curve
                .pieces
                .iter()
                .map(|piece| piece.iter().copied().map(shown).collect())
                .collect(),
            numbers: curve.numbers.clone(),
        }
    }

    fn column(&self, variable: &Variable, values: &[f64]) -> Column {
        let symbol = variable.symbol;
        Column {
            name: variable.name(),
            axis: self.axis(symbol, variable.number),
            source: symbol.source,
            output: variable.role == Role::Output,
            values: values
                .iter()
                .map(|value| to_nine_digits(symbol.shown(*value)))
                .collect(),
            texts: self.numbers.column(symbol, values.iter().copied()),
        }
    }
}

impl Shown {
    /// # Errors
    /// The scene's model cannot be built.
    pub fn new(results: &Results, language: &'static Language) -> Result<Shown, Fault> {
        let Results {
            scene,
            sheet,
            columns,
            rows,
        } = results;
        let numbers = &precision::of_results(language, scene.book.digits, sheet);
        let teller = Teller::new(scene, sheet, language, numbers);
        let column = |(i, variable): (usize, &Variable)| -> Column {
            let values: Vec<f64> = rows.iter().map(|row| row[i]).collect();
            teller.column(variable, &values)
        };
        let coordinate = scene.model()?.variables()[0].symbol;
        // What takes longest, beside each other.
        let (columns, drawing) = std::thread::scope(|scope| {
            let drawing = scope.spawn(|| Drawn::new(scene, rows.iter().map(|row| row[0])));
            let columns = each(columns.iter().enumerate(), column);
            (columns, drawing.join().unwrap_or_else(|panic| resume_unwind(panic)))
        });
        let published = |known: &sheet::Comparison| Published {
            name: known.symbol.id,
            at: coordinate.shown(known.coordinate),
            value: known.printed.parse().unwrap_or(f64::NAN),
        };
        Ok(Shown {
            language: language.code,
            name: scene.name().to_owned(),
            title: scene.titles().of(language.code).to_owned(),
            level: scene.level(),
            open: scene.is_auto(),
            verdict: teller.verdict(sheet),
            requirements: sheet
                .requirements
                .iter()
                .map(|check| teller.requirement(check))
                .collect(),
            identities: sheet.identities.iter().map(|check| teller.requirement(check)).collect(),
            warnings: sheet.warnings.iter().map(|warning| teller.warning(warning)).collect(),
            governing: sheet.governing.iter().map(|result| teller.line(result)).collect(),
            summary: sheet.summary.iter().map(|result| teller.line(result)).collect(),
            columns,
            curves: sheet.curves.iter().map(|curve| teller.curve(curve)).collect(),
            published: sheet.published.iter().map(published).collect(),
            given: scene.given.written().iter().map(Said::from).collect(),
            drawing,
            runs: sheet.motion.is_some() || sheet.cycle.is_some() || sheet.awaits_runs,
            awaits_runs: sheet.awaits_runs,
        })
    }
}
