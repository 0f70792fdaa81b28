//! What a command that is shaped against a swing leaves of it, where the load hangs on another length of rope: in closed form,
//! and in runs of the model.

use std::panic::resume_unwind;

use nalgebra::Vector2;

use crate::component::description::{Described, Description};
use crate::component::moving::MovingComponent;
use crate::component::running::Running;
use crate::component::sheet::{Curve, Input, Section, Sheet, Table};
use crate::kernel::calc::Calc;
use crate::kernel::course::Shaped;
use crate::kernel::gravity::G;
use crate::kernel::record::{Rec, record};
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::hanging::{L_R, PHI_R, PLACE};
use crate::parts::shaping::{T_SH, T_SHI, left};

/// Of a shaped command and a rope.
mod s {
    pub use crate::parts::hanging::L_R;
    pub use crate::parts::shaping::{RHO_RUN, RHO_SH, T_R};
}

/// Lengths of the rope, over that of the scene.
const LENGTHS: [f64; 7] = [0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3];
/// Of the curve, and instants in a period after the command.
const FINE: u32 = 120;
const INSTANTS: u32 = 60;
/// Part of its length that a rope may be longer or shorter after the command, of one that is not reeled.
const KEPT: f64 = 1e-2;

/// How the first of the shaped commands is.
fn shaping<T: Described>(told: &Description<T>) -> Option<&Shaped> {
    told.courses.iter().find_map(|(_, course)| course.shaped.as_ref())
}

/// Id of what the book says of it.
fn id(shaping: &Shaped) -> &'static str {
    match (shaping.periods.len(), shaping.pulses) {
        (1, 2) => "shaping",
        (1, _) => "shaping_robust",
        (_, 2) => "shaping_twice",
        _ => "shaping_twice_robust",
    }
}

/// Tells it, where the load swings and a command is shaped.
pub(super) fn tell<T: Described>(told: &Description<T>, sheet: &mut Sheet) {
    let Some((rope, shaping)) = T::hangs_on(told).zip(shaping(told)) else {
        return;
    };
    let [length, gravity] = rope;
    // One of several has its number.
    let several = shaping.periods.len() > 1;
    let number = |place: usize| several.then_some(place as u16 + 1);
    let symbol = if several { &T_SHI } else { &T_SH };
    let periods = || shaping.periods.iter().copied().enumerate();
    let (trace, _) = record(|| {
        let [rope, gravity] = [Rec::given(&L_R, length), Rec::given(&G, gravity)];
        let of = |(place, period): (usize, f64)| {
            let given = Rec::given(symbol, period);
            number(place).map_or(given, |number| given.numbered(number))
        };
        left(&periods().map(of).collect::<Vec<_>>(), shaping.pulses, rope, gravity)
    });
    sheet.inputs.extend(periods().map(|(place, value)| Input {
        symbol,
        value,
        number: number(place),
        chapter: "shaping",
        given: None,
        on: None,
        usual: true,
    }));
    sheet.constants.push(Section {
        id: id(shaping),
        trace,
        curve: Some(curve(shaping, [length, gravity])),
        table: Some(table(told, shaping, rope)),
        ..Section::default()
    });
}

/// A row for each length around that of the rope (m) under gravity (m/s²); runs that do not come to their end have none, nor
/// those in which the rope is reeled before it.
fn table<T: Described>(told: &Description<T>, shaping: &Shaped, [rope, gravity]: [f64; 2]) -> Table {
    let row = |part: f64| {
        let length = part * rope;
        let [period, left] = left(&shaping.periods, shaping.pulses, length, gravity);
        let [shaped, plain] = [swing(told, length, period, true)?, swing(told, length, period, false)?];
        (plain > 0.0).then(|| vec![length, period, left, shaped / plain])
    };
    let rows = std::thread::scope(|scope| {
        let threads: Vec<_> = LENGTHS.into_iter().map(|part| scope.spawn(move || row(part))).collect();
        let ended = threads.into_iter().map(|thread| thread.join());
        ended
            .filter_map(|row| row.unwrap_or_else(|panic| resume_unwind(panic)))
            .collect()
    });
    Table {
        columns: listed!(s: L_R, T_R, RHO_SH, RHO_RUN).to_vec(),
        rows,
    }
}

/// Greatest angle of the rope from the vertical (rad) in the period (s) after the command, shaped or not, has ended, on a
/// rope of a length (m) that is then still as long.
fn swing<T: Described>(told: &Description<T>, length: f64, period: f64, shaped: bool) -> Option<f64> {
    let mut other = told.clone();
    if !shaped {
        let courses = other.courses.iter_mut();
        courses.for_each(|(_, course)| *course = course.plain());
    }
    other.own.hang(length);
    let plain = other.courses.iter().zip(&told.courses);
    let mut ends = plain.filter_map(|((_, other), (_, own))| own.shaped.as_ref().map(|_| other.end()));
    let end = ends.next()?;
    let mut model = other.moving()?.ok()?;
    model.start().ok()?;
    model.advance(0.0, end).ok()?;
    let mut most = 0.0_f64;
    let at = |i: u32| end + period * f64::from(i) / f64::from(INSTANTS);
    for i in 0..INSTANTS {
        model.advance(at(i), at(i + 1)).ok()?;
        most = most.max(angle(&mut model)?);
    }
    let reeled = place(&model, &L_R).map(|rope| model.get(rope));
    let now = reeled.transpose().ok()?.unwrap_or(length);
    ((now - length).abs() <= KEPT * length).then_some(most)
}

fn place(model: &MovingComponent, symbol: &Symbol) -> Option<usize> {
    model.variables().iter().position(|known| known.symbol == symbol)
}

/// Angle of the rope from the vertical, in rad, in space or in the plane.
fn angle(model: &mut MovingComponent) -> Option<f64> {
    let [x, y, z] = PLACE.map(|symbol| place(model, symbol));
    let Some(((x, y), z)) = x.zip(y).zip(z) else {
        let swing = place(model, &PHI_R)?;
        return Some(model.get(swing).ok()?.abs());
    };
    let [x, y, z] = [x, y, z].map(|index| model.get(index));
    let aside = Vector2::new(x.ok()?, z.ok()?).norm();
    Some(Calc::direction(-y.ok()?, aside))
}

/// From half the length of the rope (m) to half as much again, under gravity (m/s²).
fn curve(shaping: &Shaped, [rope, gravity]: [f64; 2]) -> Curve {
    let point = |i: u32| {
        let length = rope * (0.5 + f64::from(i) / f64::from(FINE));
        let [_, left] = left(&shaping.periods, shaping.pulses, length, gravity);
        [length, left]
    };
    Curve {
        id: id(shaping),
        x: &L_R,
        y: &s::RHO_SH,
        pieces: vec![(0..=FINE).map(point).collect()],
        numbers: Vec::new(),
    }
}
