//! The run of a model through what its scene tells over time: the default experiment of the FMU, as a book shows it.

use crate::component::description::{Described, Description};
use crate::component::moving::MovingComponent;
use crate::component::running::Running;
use crate::component::series::{self, Series};
use crate::component::sheet::{Curve, Cycle, CycleFigure, CycleRow};
use crate::kernel::symbol::Symbol;
use crate::kernel::unit;
use crate::kernel::variable::{Role, TIME};

/// Samples of the run.
const SAMPLES: u32 = 2000;

/// What is looked at, besides the commands: the coordinate with its rate, all states that are angles, lengths or masses, what
/// other parts are designed for, and what a mechanism wants followed.
fn seen<T: Described>(model: &MovingComponent) -> Vec<usize> {
    let rate = model.standing().index_of(model.standing().rate());
    let all = model.variables().iter().enumerate();
    let shown = all.filter(|(index, variable)| match variable.role {
        Role::State if T::FOLLOWED.contains(&variable.symbol) => true,
        Role::State => Some(*index) == rate || [&unit::RAD, &unit::M, &unit::KG].contains(&variable.symbol.unit),
        Role::Output => [T::OUTLINE.forces, T::FOLLOWED].concat().contains(&variable.symbol),
        _ => false,
    });
    shown.map(|(index, _)| index).collect()
}

/// The cycle of a scene that tells commands over time; `None` of any other.
pub(crate) fn cycle<T: Described>(told: &Description<T>) -> Option<Cycle> {
    let mut model = told.moving()?.ok()?;
    let commands = model.told();
    if commands.is_empty() {
        return None;
    }
    let commanded: Vec<usize> = commands.into_iter().map(|(index, _)| index).collect();
    let symbol = |model: &MovingComponent, index: usize| model.variables()[index].symbol;
    let number = |model: &MovingComponent, index: usize| model.variables()[index].number;
    let followed = seen::<T>(&model).into_iter().filter(|index| !commanded.contains(index));
    let seen: Vec<usize> = commanded.iter().copied().chain(followed).collect();
    let end = model.stop_time();
    let sample = end / f64::from(SAMPLES);
    let frames = series::seen(&model);
    let mut series = Series::new(sample, seen.iter().chain(&frames).copied());
    model.start().ok()?;
    series.look(&mut model).ok()?;
    let time = |i: u32| end * f64::from(i) / f64::from(SAMPLES);
    let mut ended = None;
    for i in 0..SAMPLES {
        if model
            .advance(time(i), time(i + 1))
            .and_then(|()| series.look(&mut model))
            .is_err()
        {
            ended = Some(time(i));
            break;
        }
    }
    let partner = |symbol: &'static Symbol, at: usize| -> Option<usize> {
        let pair = T::TOGETHER.iter().find(|pair| pair[at] == symbol)?;
        seen.iter()
            .copied()
            .find(|&index| model.variables()[index].symbol == pair[1 - at])
    };
    let figure = |&index: &usize| -> Option<CycleFigure> {
        let y = symbol(&model, index);
        // It stands in the figure of another one.
        if partner(y, 1).is_some() {
            return None;
        }
        let both: Vec<usize> = std::iter::once(index).chain(partner(y, 0)).collect();
        let pieces: Option<Vec<_>> = both.iter().map(|&index| series.piece(index, both.len())).collect();
        Some(CycleFigure {
            curve: Curve {
                id: y.id,
                x: &TIME,
                y,
                pieces: pieces?,
                numbers: if both.len() > 1 { vec![1, 2] } else { Vec::new() },
            },
            of: both.iter().map(|&index| model.variables()[index].quantity()).collect(),
        })
    };
    let row = |&index: &usize| CycleRow {
        symbol: symbol(&model, index),
        number: number(&model, index),
        ends: series.stands(index),
        last: series.last(index),
    };
    let course = |symbol: &'static Symbol| told.courses.iter().find(|(known, _)| *known == symbol);
    Some(Cycle {
        commands: commanded
            .iter()
            .filter_map(|&index| course(symbol(&model, index)).cloned())
            .collect(),
        end,
        ended,
        figures: seen.iter().filter_map(figure).collect(),
        seen: series.frames(&model, &frames),
        rows: seen.iter().map(row).collect(),
    })
}
