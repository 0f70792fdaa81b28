//! What the book tells of a motor's start, of the shafts between it and its pinion, and of what it moves.

use crate::component::description::Described;
use crate::component::places::{all_told, stand};
use crate::component::sheet::Sheet;
use crate::component::standing::Standing;
use crate::component::starting::start_curve;
use crate::component::telling::{explained, sample};
use crate::kernel::symbol::listed;
use crate::parts::starts::RatedPoint;
use crate::supports::drive::outline::{SHAFT_COLUMNS, SHAFTS};
use crate::supports::drive::scene::TurningScene;
use crate::supports::drive::symbols as s;

/// All of these.
pub fn told<T: Described>(turning: &TurningScene, model: &mut Standing, sheet: &mut Sheet) {
    shafts::<T>(model, sheet);
    starts(turning, model, sheet);
    if let Some(slewing) = &turning.slewing {
        sheet.positions.push(slewing.told("turning_moving"));
        sheet.outputs.extend(slewing.outputs());
    }
}

/// The motor's curve in a start, where most resists steady slewing.
fn starts(turning: &TurningScene, model: &mut Standing, sheet: &mut Sheet) {
    let most = sheet.governing.iter().find(|found| found.symbol == &s::M_ST_TOP);
    let Some(((motor, (_, at)), aside)) = most.and_then(|found| Some(((turning.drive?.motor, found.at?), found.aside)))
    else {
        return;
    };
    stand(model, aside);
    let rated = RatedPoint::new(motor.p_n, motor.n_n);
    sheet
        .curves
        .extend(start_curve(turning.start.as_ref(), &rated, model, at));
}

/// Formulas of the pinion's shaft at the first position of the book, and a table of all shafts; nothing where the gear has no
/// stages.
fn shafts<T: Described>(model: &mut Standing, sheet: &mut Sheet) {
    let Some(position) = sheet.positions.first_mut() else {
        return;
    };
    stand(model, position.aside);
    let Some(mut table) = all_told(model, position.value, SHAFT_COLUMNS) else {
        return;
    };
    let own = sample(
        model,
        listed!(s: N_G0, T_G0, P_G0, T_GP0),
        std::iter::once(position.value),
    );
    let of_motor = [1.0; 2].into_iter().chain(own.concat()).collect();
    table.rows.insert(0, of_motor);
    table.columns.insert(0, &s::SHAFT);
    (0..)
        .zip(&mut table.rows)
        .for_each(|(number, row)| row.insert(0, f64::from(number)));
    let last = table.rows.len() - 1;
    let mut told = explained::<T>(model, (position.value, Some(last)), &[], SHAFTS);
    if let Some(section) = told.first_mut() {
        section.table = Some(table);
    }
    position.sections.extend(told);
}
