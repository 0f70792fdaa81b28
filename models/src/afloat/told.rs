//! Tables and curves that the book has of a floating crane.

use crate::afloat::hull::Offsets;
use crate::afloat::levers::Heeled;
use crate::afloat::stages::{FloatingCrane, Given};
use crate::afloat::symbols as s;
use crate::afloat::weights::Weighed;
use crate::component::sheet::Table;
use crate::component::stages::Stages;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::{Symbol, listed};

/// Columns of the tables of openings, and of righting levers.
pub const OPENED: &[&Symbol] = listed!(s: X_O, Y_O, Z_O, F_O, PHI_O, PHI_O0);
pub const TOLD: &[&Symbol] = listed!(s: PHI_H, GZ, GZ_W, E, E_W);

/// Levers over the heel (rad) at a slewing angle: the righting one, its wall-sided form, and that of the moments that heel.
pub fn levers(given: &Given<f64>, at: f64, heels: impl Iterator<Item = f64>) -> Option<[Vec<[f64; 2]>; 3]> {
    let mut known = FloatingCrane::new(given.clone());
    known.psi().1 = at;
    let (upright, all) = (*known.upright().ok()?, known.loaded().ok()?.all);
    let floating = known.floating().ok()?;
    let centred = Weighed { across: 0.0, ..all };
    let mut heeled = Heeled::new(floating, &centred, None);
    let mut curves = [const { Vec::new() }; 3];
    for heel in heels {
        let (sin, cos) = Calc::sin_cos(heel);
        let [_, lever] = heeled.raised(heel).ok()?;
        let walls = (upright.height[0] + upright.radius[0] / 2.0 * (sin / cos).square()) * sin;
        let asked = (all.across / all.weight).abs() * cos;
        curves
            .iter_mut()
            .zip([lever, walls, asked])
            .for_each(|(curve, y)| curve.push([heel, y]));
    }
    Some(curves)
}

/// Points of all sections on one side, from keel to deck.
pub fn points(of: &Offsets) -> Table {
    let sections = of.mesh.points.chunks(2 * of.half);
    Table {
        columns: listed!(s: X_H, Y_H, Z_H).to_vec(),
        rows: (sections.flat_map(|section| &section[..of.half]))
            .map(|point| point.to_vec())
            .collect(),
    }
}
