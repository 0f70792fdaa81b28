//! Places at which a book works its formulas out, and results there.

use crate::component::outline::{Explained, Greatest, Outline};
use crate::component::probe::slot;
use crate::component::running::Running;
use crate::component::sheet::{Summary, Table};
use crate::component::standing::Standing;
use crate::kernel::symbol::Symbol;
use crate::parts::motion::{Motion, Place};

/// Where the variables of a symbol stand: one, or as many as it is numbered to.
pub(super) fn indices(model: &Standing, symbol: &'static Symbol) -> Vec<usize> {
    let variables = model.variables();
    (0..variables.len())
        .filter(|&index| variables[index].symbol == symbol)
        .collect()
}

/// Variables at values of the coordinate; of a numbered one the first.
///
/// # Panics
/// For variables that the scene does not have, and outside the checked range.
pub fn sample(model: &mut Standing, symbols: &[&'static Symbol], places: impl Iterator<Item = f64>) -> Vec<Vec<f64>> {
    let first = |symbol: &&'static Symbol| *indices(model, symbol).first().expect("a variable of this scene");
    let indices: Vec<usize> = symbols.iter().map(first).collect();
    values(model, &indices, places)
}

/// All variables of a symbol at a value of the coordinate.
///
/// # Panics
/// As [`sample`].
pub fn numbered(model: &mut Standing, symbol: &'static Symbol, at: f64) -> Vec<f64> {
    let indices = indices(model, symbol);
    values(model, &indices, std::iter::once(at)).remove(0)
}

/// All of what there are several of at a slewing angle (rad); `None` where there is none.
pub fn all_told(model: &mut Standing, at: f64, columns: &'static [&'static Symbol]) -> Option<Table> {
    let found: Vec<Vec<f64>> = columns.iter().map(|symbol| numbered(model, symbol, at)).collect();
    let row = |i: usize| found.iter().map(|column| column[i]).collect();
    let rows: Vec<_> = (0..found[0].len()).map(row).collect();
    (!rows.is_empty()).then(|| Table {
        columns: columns.to_vec(),
        rows,
    })
}

/// Variables at values of the coordinate, by their places.
///
/// # Panics
/// As [`sample`].
pub fn values(model: &mut Standing, indices: &[usize], places: impl Iterator<Item = f64>) -> Vec<Vec<f64>> {
    let row = |at: f64| {
        model.set(0, at).expect("a place is finite");
        indices
            .iter()
            .map(|&index| model.get(index).expect("the range was checked"))
            .collect()
    };
    places.map(row).collect()
}

/// Of which of several bodies, numbered from 1, the formulas speak: of the one that governs at the worst position, else
/// of the first; where that result is not numbered, of the first one that is and that sections tell. `None` where there are
/// not several.
pub(super) fn body(model: &mut Standing, outline: &'static Outline, governing: &[Summary]) -> Option<usize> {
    let (_, symbol) = outline.worst[0];
    let own = outline.extremes.iter().find(|extreme| extreme.symbol == symbol)?;
    let is_numbered = (model.variables().iter()).any(|variable| variable.symbol == own.of && variable.number.is_some());
    let told = |of: &'static Symbol| {
        let stage = slot(model, of).map(|slot| model.part().stages()[usize::from(slot.stage)].id);
        let tells = |what: &Explained| matches!(what, Explained::Stage(id) if Some(*id) == stage);
        outline.sections.iter().any(|(_, list)| list.iter().any(tells))
    };
    let several = |extreme: &&Greatest| indices(model, extreme.of).len() > 1 && (is_numbered || told(extreme.of));
    let others = Some(own).filter(several).or(outline.extremes.iter().find(several));
    let extreme = others.or(Some(own).filter(|_| is_numbered))?;
    let found = governing.iter().find(|found| found.symbol == symbol);
    let Some((_, at)) = found.and_then(|found| found.at) else {
        return Some(1);
    };
    let all = numbered(model, extreme.of, at);
    let most = |best: usize, i: usize| {
        if extreme.most.is_before(all[best], all[i]) {
            i
        } else {
            best
        }
    };
    Some(1 + (0..all.len()).fold(0, most))
}

/// Where the formulas are worked out: the name of the position, the coordinate, and the second one where that matters.
#[derive(Clone, Copy)]
pub(super) struct Position {
    pub id: &'static str,
    pub at: f64,
    pub aside: Option<(&'static Symbol, f64)>,
}

impl Position {
    fn of(id: &'static str, found: &Summary) -> Option<Position> {
        let aside = found.aside;
        found.at.map(|(_, at)| Position { id, at, aside })
    }
}

/// Puts the second coordinate to a value that the model allows.
///
/// # Panics
/// Where it is beyond its range.
pub fn stand(model: &mut Standing, aside: Option<(&'static Symbol, f64)>) {
    let Some((symbol, at)) = aside else { return };
    let index = model.variables().iter().position(|variable| variable.symbol == symbol);
    model.set(index.expect("it is an input"), at).expect("within its range");
}

/// The worst position, where the scene asks for none; the middle where nothing is worst.
pub(super) fn worst(outline: &Outline, motion: &Motion, governing: &[Summary]) -> Position {
    let known = |symbol: &Symbol| governing.iter().find(|g| g.symbol == symbol && g.value != 0.0);
    let mut worst = (outline.worst.iter()).filter_map(|(name, symbol)| Position::of(name, known(symbol)?));
    worst.next().unwrap_or(Position {
        id: "middle",
        at: f64::midpoint(motion.from, motion.to),
        aside: None,
    })
}

/// Positions at which the formulas are worked out: what the scene asks for, otherwise the worst.
pub(super) fn positions(outline: &Outline, motion: &Motion, asked: &[Place], governing: &[Summary]) -> Vec<Position> {
    let worst = worst(outline, motion, governing);
    let at = |id, at| Position { id, at, ..worst };
    let middle = at("middle", f64::midpoint(motion.from, motion.to));
    let greatest = |id: &'static str| Position::of(id, governing.iter().find(|g| g.symbol.id == id)?);
    let position = |place: &Place| match *place {
        Place::At(chosen) => at("chosen", chosen),
        Place::Named("governing") => worst,
        Place::Named("middle") => middle,
        Place::Named("from") => at("from", motion.from),
        Place::Named("to") => at("to", motion.to),
        Place::Named(id) => greatest(id).unwrap_or(middle),
    };
    match asked {
        [] => vec![worst],
        places => places.iter().map(position).collect(),
    }
}
