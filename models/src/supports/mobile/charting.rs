//! The load chart, over all slewing angles of the working range.

use std::f64::consts::{PI, TAU};

use crate::component::stages::{Found, Stages};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::motion::Motion;
use crate::supports::mobile::chart::{Cell, LoadChart};
use crate::supports::mobile::rating::FORBIDDEN;
use crate::supports::mobile::stages::{Given, MobileCrane};
use crate::supports::mobile::symbols as s;

/// Between which slewing angles what a support bears is looked at, in rad, and how the least is closed in.
const LOOK: f64 = PI / 36.0;
const CLOSER: u32 = 24;

/// The chart of lengths and reaches (m) over a sector of slewing angles.
///
/// # Errors
/// What no reach or length mends.
pub fn chart(given: &Given<f64>, lengths: &[f64], reaches: &[f64], sector: &Motion) -> Found<LoadChart> {
    let mut given = given.clone();
    (given.angle, given.chart) = (None, None);
    let mut cells = Vec::new();
    for &length in lengths {
        given.length.1 = length;
        for &reach in reaches {
            given.reach = Some(One(&s::R, reach));
            cells.extend(cell(&given, length, reach, sector)?);
        }
    }
    Ok(LoadChart(cells))
}

/// A cell of the chart; `None` where the boom does not reach it.
fn cell(given: &Given<f64>, length: f64, reach: f64, sector: &Motion) -> Found<Option<Cell>> {
    let mut known = MobileCrane::new::<f64>(given.clone());
    let Ok(pose) = known.pose() else { return Ok(None) };
    let mut found = Cell {
        length,
        reach,
        angle: pose.phi,
        height: pose.height,
        load: f64::INFINITY,
        net: f64::INFINITY,
        heading: sector.from,
        governs: 0,
    };
    // About a side the load that tips is least, and what is left behind it too, where the boom stands square to it, or at
    // an end of the sector.
    let mut places = vec![sector.from, sector.to];
    for side in &known.sides()?.0 {
        let square = f64::direction(side.out.x, side.out.y);
        for at in [square, square + PI] {
            let turns = ((sector.from - at) / TAU).ceil();
            places.extend(Some(at + turns * TAU).filter(|at| *at <= sector.to));
        }
    }
    let mut at = |psi: f64| {
        known.psi().1 = psi;
        let rated = known.rated()?;
        if rated.load < found.load || rated.governs == FORBIDDEN && found.governs != FORBIDDEN {
            (found.load, found.net) = (rated.load, rated.net);
            (found.heading, found.governs) = (psi, rated.governs);
        }
        Found::Ok(rated.load)
    };
    places.into_iter().try_for_each(|psi| at(psi).map(drop))?;
    if !given.caps.is_empty() {
        let steps = ((sector.to - sector.from) / LOOK).ceil();
        let step = (sector.to - sector.from) / steps;
        let mut least = (f64::INFINITY, sector.from);
        for i in 0..=steps as u32 {
            let psi = (sector.from + f64::from(i) * step).min(sector.to);
            let load = at(psi)?;
            if load < least.0 {
                least = (load, psi);
            }
        }
        let (mut low, mut high) = ((least.1 - step).max(sector.from), (least.1 + step).min(sector.to));
        for _ in 0..CLOSER {
            let third = (high - low) / 3.0;
            if at(low + third)? < at(high - third)? {
                high -= third;
            } else {
                low += third;
            }
        }
    }
    Ok(Some(found))
}
