//! What a shaped command leaves of the swing on other lengths of the rope: in closed form, and in runs of the model.

use nalgebra::Vector2;

use crate::component::moving::MovingComponent;
use crate::component::running::Running;
use crate::component::sheet::{Curve, Table};
use crate::kernel::calc::Calc;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::hanging::PLACE;
use crate::parts::shaping::Shaping;
use crate::slewing::symbols as s;

/// Lengths of the rope, over that of the scene.
const LENGTHS: [f64; 7] = [0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3];
/// Of the curve, and instants in a period after the command.
const FINE: u32 = 120;
const INSTANTS: u32 = 60;

/// A row for each length, around that of the rope (m), under gravity (m/s²), with the model on a length, shaped or not; runs
/// that do not come to their end have no row.
pub fn table(
    shaping: &Shaping<f64>,
    [rope, gravity]: [f64; 2],
    model: &dyn Fn(f64, bool) -> Option<MovingComponent>,
) -> Table {
    let row = |part: f64| {
        let length = part * rope;
        let [period, left] = shaping.left(length, gravity);
        let [shaped, plain] = [
            swing(model(length, true)?, period)?,
            swing(model(length, false)?, period)?,
        ];
        (plain > 0.0).then(|| vec![length, period, left, shaped / plain])
    };
    Table {
        columns: listed!(s: L_R, T_R, RHO_SH, RHO_RUN).to_vec(),
        rows: LENGTHS.into_iter().filter_map(row).collect(),
    }
}

/// Greatest angle of the rope from the vertical (rad) in the period (s) after the commands have ended.
fn swing(mut model: MovingComponent, period: f64) -> Option<f64> {
    let place = |symbol: &Symbol| model.variables().iter().position(|known| known.symbol == symbol);
    let [x, y, z] = PLACE.map(place);
    let place = [x?, y?, z?];
    let end = model.stop_time();
    model.start().ok()?;
    model.advance(0.0, end).ok()?;
    let mut most = 0.0_f64;
    let at = |i: u32| end + period * f64::from(i) / f64::from(INSTANTS);
    for i in 0..INSTANTS {
        model.advance(at(i), at(i + 1)).ok()?;
        let [x, y, z] = place.map(|index| model.get(index));
        let aside = Vector2::new(x.ok()?, z.ok()?).norm();
        most = most.max(Calc::direction(-y.ok()?, aside));
    }
    Some(most)
}

/// From half the length of the rope (m) to half as much again, under gravity (m/s²).
pub fn curve(shaping: &Shaping<f64>, [rope, gravity]: [f64; 2]) -> Curve {
    let point = |i: u32| {
        let length = rope * (0.5 + f64::from(i) / f64::from(FINE));
        let [_, left] = shaping.left(length, gravity);
        [length, left]
    };
    Curve {
        id: "slewing_shaping",
        x: &s::L_R,
        y: &s::RHO_SH,
        pieces: vec![(0..=FINE).map(point).collect()],
        numbers: Vec::new(),
    }
}
