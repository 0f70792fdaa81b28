//! Tables of a grab unloader's book: numbered results, speeds of the drums by mode.

use std::f64::consts::PI;

use crate::component::sheet::{Section, Table};
use crate::component::standing::Standing;
use crate::component::telling::numbered;
use crate::kernel::symbol::{Symbol, listed};
use crate::unloader::cycle::GrabPhase;
use crate::unloader::ropes::wound;
use crate::unloader::stages::Given;
use crate::unloader::symbols as s;

/// Drums at most.
pub(super) const DRUMS: usize = 4;

/// Sum of terms that cancel, over the greatest of them.
pub(super) fn apart_of(terms: &[f64]) -> f64 {
    let size = terms.iter().map(|term| term.abs()).fold(f64::MIN_POSITIVE, f64::max);
    terms.iter().sum::<f64>().abs() / size
}

/// Numbered results at a value of the coordinate: a row for each number.
pub(super) fn each(model: &mut Standing, columns: &[&'static Symbol], at: f64) -> Table {
    let found: Vec<Vec<f64>> = columns.iter().map(|symbol| numbered(model, symbol, at)).collect();
    let row = |i: usize| {
        std::iter::once((i + 1) as f64)
            .chain(found.iter().map(|values| values[i]))
            .collect()
    };
    Table {
        rows: (0..found[0].len()).map(row).collect(),
        columns: std::iter::once(&s::NUMBER).chain(columns.iter().copied()).collect(),
    }
}

/// Speeds of the drums with hoisting, closing, travelling alone, two at once, and all: each with its greatest speed in the cycle.
pub(super) fn modes(given: &Given<f64>) -> Section {
    let greatest = |of: fn(&GrabPhase<f64>) -> f64| given.phases.iter().map(of).fold(0.0, f64::max);
    let most = [
        greatest(|phase| phase.v_h),
        greatest(|phase| phase.v_c),
        greatest(|phase| phase.v_t),
    ];
    let row = |which: u32| {
        let speeds: [f64; 3] = std::array::from_fn(|i| if which >> i & 1 == 1 { most[i] } else { 0.0 });
        let turns = (0..)
            .zip(&given.drums)
            .map(|(at, drum)| wound(given.reeving.scheme, speeds, at) / (PI * drum.d_d));
        speeds.into_iter().chain(turns).collect()
    };
    let turns: [&Symbol; DRUMS] = [&s::N_1, &s::N_2, &s::N_3, &s::N_4];
    Section {
        id: "unloader_modes",
        table: Some(Table {
            columns: listed!(s: V_H, V_C, V_T)
                .iter()
                .chain(&turns[..given.drums.len()])
                .copied()
                .collect(),
            rows: [1, 2, 4, 3, 5, 6, 7].map(row).to_vec(),
        }),
        ..Section::default()
    }
}
