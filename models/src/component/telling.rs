//! A sheet from an outline: the run of the component on the recorder, and its results over the working range.

use std::panic::resume_unwind;

use crate::component::aside::Peak;
use crate::component::cycle::cycle;
use crate::component::dependencies::recorded;
use crate::component::description::{Described, Description};
use crate::component::extreme::Extreme;
pub use crate::component::extreme::{between, fine};
use crate::component::judged::{Judged, judged};
use crate::component::outline::{Explained, Greatest, Line, Most, Outline, Published, SectionOutline};
use crate::component::part::{Face, Part};
use crate::component::peaks::Peaks;
use crate::component::places::{Position, body, indices, positions, stand, worst};
pub use crate::component::places::{numbered, sample, values};
use crate::component::running::Running;
use crate::component::sensitivity::sensitivity;
use crate::component::shaped;
use crate::component::sheet::{Check, Comparison, Curve, Input, Section, Sensitivity, Sheet, Summary, Table, Worked};
use crate::component::stages::{Found, Source, Stage, Use};
use crate::component::standing::Standing;
use crate::kernel::calc::Calc;
use crate::kernel::origin::Origins;
use crate::kernel::record::{Rec, only, record, steps};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Fault, Quantity, Role, Type};
use crate::parts::motion::Place;

/// Whether the scene has a variable.
#[must_use]
pub fn exists(model: &Standing, symbol: &'static Symbol) -> bool {
    model.variables().iter().any(|variable| variable.symbol == symbol)
}

/// Runs formulas on the recorder, up to what each section explains: one run, in the order of the sections. Those of
/// `before` are known and not told. Of several bodies one is told of, numbered from 1.
fn run<T: Described>(
    model: &Standing,
    (at, of): (f64, Option<usize>),
    before: &[SectionOutline],
    sections: &[SectionOutline],
) -> Vec<Section> {
    let part = model.part();
    let groups = part.groups();
    let (trace, cuts) = record(|| {
        only(of.map(|number| number - 1));
        let mut of = |source: Source, (symbol, _): Quantity, value| match groups[usize::from(source.group)].1 {
            Use::Coordinate => Rec::given(symbol, at),
            // What weighs nothing leaves no trace in the formulas.
            _ if value == 0.0 && symbol.unit.dimension.kg != 0 => Rec::constant(0.0),
            _ => Rec::given(symbol, value),
        };
        let mut face = recorded::<T::Component>(part, &mut of);
        let explain = |face: &mut dyn Face<Rec>, what: &Explained| match what {
            Explained::Stage(id) => stage(part, id, face),
            Explained::Rows(symbols) => {
                symbols.iter().for_each(|symbol| drop(row(part, symbol, face)));
                Ok(())
            }
        };
        // What a scene does not model, or where it does not exist, has no formulas.
        let mut all = |list: &[Explained]| list.iter().for_each(|what| drop(explain(&mut *face, what)));
        before.iter().for_each(|(_, list)| all(list));
        let cut = |(id, list): &SectionOutline| {
            let from = steps();
            all(list);
            (*id, from..steps())
        };
        sections.iter().map(cut).collect::<Vec<_>>()
    });
    let told = cuts.into_iter().filter(|(_, range)| !range.is_empty());
    told.map(|(id, range)| Section {
        id,
        trace: trace.part(range),
        ..Section::default()
    })
    .collect()
}

fn stage(part: &dyn Part, id: &str, face: &mut dyn Face<Rec>) -> Found<()> {
    let exists = |place: u8| part.exists(place);
    let named = |(place, stage): &(u8, &Stage)| stage.id == id && exists(*place);
    match (0..).zip(part.stages()).find(named) {
        Some((place, _)) => face.make(place),
        None => Ok(()),
    }
}

fn row(part: &dyn Part, symbol: &'static Symbol, face: &mut dyn Face<Rec>) -> Found<()> {
    let mut value = Rec::constant(0.0);
    match part.results().into_iter().find(|(_, (known, _))| *known == symbol) {
        Some((slot, _)) => face.result(&slot, &mut value),
        None => Ok(()),
    }
}

/// All that a book says of a mechanism, with the positions that the scene asks for; without its runs in time, which take
/// most of the time of all, where these are not asked for.
///
/// # Panics
/// Where a run does.
#[must_use]
pub fn sheet<T: Described>(told: &Description<T>, origins: &Origins, asked: &[Place], runs: bool) -> Sheet {
    let mut model = told.standing();
    let (mut sheet, moved, cycle) = std::thread::scope(|scope| {
        let moved = runs.then(|| scope.spawn(|| T::in_motion(told)));
        let identities = scope.spawn(|| T::identities(told, &mut told.standing()));
        let cycle = runs.then(|| cycle(told)).flatten();
        let mut sheet = at_rest(told, &mut model, origins, asked);
        sheet.identities = identities.join().unwrap_or_else(|panic| resume_unwind(panic));
        let moved = moved.and_then(|moved| moved.join().unwrap_or_else(|panic| resume_unwind(panic)));
        (sheet, moved, cycle)
    });
    let moves = told.own.chapters().contains(&"motion");
    sheet.awaits_runs = !runs && (moves || !told.courses.is_empty());
    match moved {
        Some(moved) => moved.tell(&mut sheet),
        None if moves => sheet.uncalculated = in_motion_only(told),
        None => {}
    }
    if let Some(cycle) = &cycle {
        let commanded = cycle.commands.iter().map(|(symbol, _)| *symbol);
        sheet.uses.push(("cycle", commanded.collect()));
        shaped::tell(told, &mut sheet);
    }
    sheet.cycle = cycle;
    sheet.drop_nothing();
    let Sheet {
        requirements,
        governing,
        inputs,
        ..
    } = &mut sheet;
    banded(requirements, &mut model, T::OUTLINE, governing, inputs);
    sheet
}

/// All but what moves.
fn at_rest<T: Described>(told: &Description<T>, model: &mut Standing, origins: &Origins, asked: &[Place]) -> Sheet {
    let outline = T::OUTLINE;
    let mut peaks = Peaks::over(model, T::aside(told));
    let Judged {
        governing,
        summary,
        requirements,
        unjudged,
    } = judged(told, model, &mut peaks, &|_| true);
    let forces = forces(model, &mut peaks, outline);
    let positions = positions(outline, model.motion(), asked, &governing);
    let there = worst(outline, model.motion(), &governing);
    stand(model, there.aside);
    if there.aside.is_some() {
        peaks = Peaks::new(model);
    }
    let of = body(model, outline, &governing);
    let worked = positions.into_iter().map(|place| {
        stand(model, place.aside);
        worked::<T>(model, place, of)
    });
    let worked = worked.collect();
    stand(model, there.aside);
    let mut sheet = Sheet {
        assumptions: T::assumptions(told),
        inputs: told.inputs(origins),
        uses: uses(outline),
        constants: constants::<T>(model, of),
        positions: worked,
        range: table(model, outline.table),
        curves: lines(told, model, &mut peaks, outline.curves),
        drawing: T::drawing(told, T::drawn_at(told)),
        requirements,
        unjudged,
        published: published(told.published(), model),
        published_source: told.published().map(|published| published.source.clone()),
        summary,
        sensitivity: sensitivity(model, outline, outline.sensitivity, &governing, &|_| true),
        governing,
        outputs: outputs(model),
        remarks: told.remarks(),
        forces,
        uncovered: T::uncovered(told),
        parts: T::parts(told),
        ..Sheet::default()
    };
    T::more(told, model, &mut sheet);
    sheet
}

/// What given quantities are for besides formulas.
fn uses(outline: &Outline) -> Vec<(&'static str, Vec<&'static Symbol>)> {
    let told = outline.uses.iter().map(|(id, symbols)| (*id, symbols.to_vec()));
    let limits = outline.limits.iter().map(|limit| limit.symbol).collect();
    told.chain([("limit", limits)]).collect()
}

/// Least and greatest values over the working range of what other parts are designed for.
fn forces(model: &Standing, peaks: &mut Peaks, outline: &'static Outline) -> Vec<[Summary; 2]> {
    peaks.look(model, outline.forces.iter().copied());
    let of = |&symbol: &&'static Symbol| {
        let known = outline.extremes.iter().find(|extreme| extreme.of == symbol);
        let pole = known.and_then(|extreme| extreme.pole);
        let mut end = |end: Most| {
            let own = Greatest::new(symbol, end, symbol);
            let found = peaks.most(model, &Greatest { pole, ..own })?;
            let value = match end {
                // It is so to both sides.
                Most::Least if found.extreme.value == f64::INFINITY => f64::NEG_INFINITY,
                _ => found.extreme.value,
            };
            let extreme = Extreme { value, ..found.extreme };
            Some(peaks.summary(model, symbol, Peak { extreme, ..found }))
        };
        Some([end(Most::Least)?, end(Most::Greatest)?])
    };
    outline.forces.iter().filter_map(of).collect()
}

/// Chapters of inputs whose tables are of no use to the level that stands still: without the chapter on motion nothing is
/// calculated with them.
fn in_motion_only<T: Described>(told: &Description<T>) -> Vec<&'static str> {
    let standing = told.own.levels().first().copied().unwrap_or_default();
    let unused = told.own.unused(standing);
    let whole = |table: &str| unused.iter().any(|(name, keys)| *name == table && keys.is_empty());
    let chapters = T::OUTLINE.inputs.iter().filter(|(_, table)| whole(table));
    chapters.map(|(chapter, _)| *chapter).collect()
}

/// Published values beside the computed ones.
fn published(published: Option<&Published>, model: &mut Standing) -> Vec<Comparison> {
    let rows = published.map_or(Vec::new(), |published| compared(published, model));
    rows.into_iter()
        .flat_map(|row| row.expect("checked when the scene was read"))
        .collect()
}

/// Each row's values beside the computed ones; what the scene does not model is left out.
pub fn compared(published: &Published, model: &mut Standing) -> Vec<Result<Vec<Comparison>, Fault>> {
    let place = |symbol: &&'static Symbol| model.variables().iter().position(|variable| variable.symbol == *symbol);
    let places: Vec<Option<usize>> = published.columns.iter().map(place).collect();
    let mut row = |row: &Vec<String>| {
        let at = row[0].parse::<f64>().unwrap_or(f64::NAN) * published.columns[0].display.factor;
        model.set(0, at)?;
        let cells = published.columns.iter().zip(&places).zip(row).skip(1);
        let known = cells.filter_map(|((symbol, index), printed)| Some((symbol, (*index)?, printed)));
        known
            .map(|(symbol, index, printed)| {
                Ok(Comparison {
                    coordinate: at,
                    symbol,
                    printed: printed.clone(),
                    value: model.get(index)?,
                })
            })
            .collect()
    };
    published.rows.iter().map(&mut row).collect()
}

/// Formulas that do not depend on the position.
#[must_use]
pub fn constants<T: Described>(model: &Standing, of: Option<usize>) -> Vec<Section> {
    run::<T>(model, (model.motion().from, of), &[], T::OUTLINE.constants)
}

/// The formulas at a position, at whose second coordinate the model stands.
pub(super) fn worked<T: Described>(model: &Standing, place: Position, of: Option<usize>) -> Worked {
    let Outline {
        constants, sections, ..
    } = T::OUTLINE;
    Worked {
        id: place.id,
        coordinate: model.variables()[0].symbol,
        value: place.at,
        aside: place.aside,
        of,
        taken: Vec::new(),
        sections: run::<T>(model, (place.at, of), constants, sections),
    }
}

/// Formulas at a position, of a case or body numbered from 1, besides those that the book tells of the mechanism there.
#[must_use]
pub fn explained<T: Described>(
    model: &Standing,
    at: (f64, Option<usize>),
    before: &[SectionOutline],
    sections: &[SectionOutline],
) -> Vec<Section> {
    let Outline {
        constants,
        sections: own,
        ..
    } = T::OUTLINE;
    run::<T>(model, at, &[*constants, *own, before].concat(), sections)
}

/// Results over the working range, a row for each step of the scene.
pub fn table(model: &mut Standing, columns: &[&'static Symbol]) -> Table {
    let coordinate = model.variables()[0].symbol;
    let columns: Vec<&'static Symbol> = std::iter::once(coordinate)
        .chain(
            columns
                .iter()
                .copied()
                .filter(|symbol| *symbol != coordinate && exists(model, symbol)),
        )
        .collect();
    let places = model.positions();
    let rows = sample(model, &columns, places.into_iter());
    Table { columns, rows }
}

/// Curves over the working range; none of a result that the scene does not have.
pub fn lines<T: Described>(
    told: &Description<T>,
    model: &mut Standing,
    peaks: &mut Peaks,
    lines: &[Line],
) -> Vec<Curve> {
    let coordinate = model.variables()[0].symbol;
    let known = lines.iter().map(|&(id, x, y)| (id, x.unwrap_or(coordinate), y));
    let known = known.filter(|&(_, x, y)| y != coordinate && exists(model, x) && exists(model, y));
    let known: Vec<_> = known.collect();
    peaks.look(model, known.iter().map(|(.., y)| *y));
    let mut asked = Vec::new();
    for (_, x, y) in &known {
        let x = indices(model, x)[0];
        asked.extend((indices(model, y).into_iter()).map(|index| ([x, index], peaks.drawn(model, index))));
    }
    let mut found = together(model, &asked).into_iter();
    let mut list = Vec::new();
    for (id, x, y) in known {
        let (mut pieces, mut numbers) = (Vec::new(), Vec::new());
        for (index, points) in indices(model, y).into_iter().zip(&mut found) {
            // Where it is infinite it is broken.
            let finite = points.split(|point: &[f64; 2]| !point.iter().all(|x| x.is_finite()));
            for points in finite.filter(|points| !points.is_empty()) {
                let found = told.pieces(id, points.to_vec());
                let number = model.variables()[index].number.map(usize::from);
                numbers.extend(found.iter().filter_map(|_| number));
                pieces.extend(found);
            }
        }
        if !pieces.is_empty() {
            list.push(Curve {
                id,
                x,
                y,
                pieces,
                numbers,
            });
        }
    }
    list
}

/// Pairs of variables, each at places of its own: what they follow from is found once for each place.
fn together(model: &mut Standing, asked: &[([usize; 2], Vec<f64>)]) -> Vec<Vec<[f64; 2]>> {
    let mut places: Vec<(f64, usize)> = (0..)
        .zip(asked)
        .flat_map(|(which, (_, places))| places.iter().map(move |&at| (at, which)))
        .collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut found: Vec<Vec<[f64; 2]>> = asked
        .iter()
        .map(|(_, places)| Vec::with_capacity(places.len()))
        .collect();
    for those in places.chunk_by(|a, b| a.0.to_bits() == b.0.to_bits()) {
        model.set(0, those[0].0).expect("a place is finite");
        for &(_, which) in those {
            let value = |index| model.get(index).expect("the range was checked");
            found[which].push(asked[which].0.map(value));
        }
    }
    found
}

/// How far the values of requirements are known: quantities that a publication has printed are known to half of their
/// last digit, and each moves a result by its derivative; all of them to the same side.
fn banded(
    requirements: &mut [Check],
    model: &mut Standing,
    outline: &'static Outline,
    governing: &[Summary],
    inputs: &[Input],
) {
    let symbols: Vec<&'static Symbol> = requirements.iter().map(|check| check.symbol).collect();
    let known = |symbol: &Symbol| {
        let input = inputs.iter().find(|input| input.symbol == symbol)?;
        input.given.as_ref()?.rounding
    };
    let Sensitivity { results, rows } =
        sensitivity(model, outline, &symbols, governing, &|symbol| known(symbol).is_some());
    for (i, (symbol, _)) in results.iter().enumerate() {
        let off = rows.iter().filter_map(|row| Some(row.by[i].abs() * known(row.symbol)?));
        let band: f64 = off.sum();
        let of = requirements.iter_mut().filter(|check| check.symbol == *symbol);
        of.for_each(|check| check.band = (band > 0.0).then_some(band));
    }
}

/// What the running model gives, in its order.
#[must_use]
pub fn outputs(model: &Standing) -> Vec<&'static Symbol> {
    let variables = model.variables().iter();
    let told = variables.filter(|variable| variable.role == Role::Output && variable.kind == Type::Real);
    told.map(|variable| variable.symbol).collect()
}
