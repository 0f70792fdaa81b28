//! Independent ways to the forces on the bearings.

use crate::component::sheet::Check;
use crate::component::standing::Standing;
use crate::component::telling::{fine, numbered};
use crate::supports::column::symbols as s;

/// Forces and moments about the foot bearing, along and across the boom, where the upper one alone has an arm: their rest
/// over M + H h_uf.
pub fn about_the_foot(model: &mut Standing, height: f64) -> Vec<Check> {
    let mut apart = 0.0_f64;
    for at in fine(model.motion()).collect::<Vec<_>>() {
        let [m, h] = [&s::M, &s::H].map(|symbol| numbered(model, symbol, at));
        for [moment, force, upper] in [[&s::M_L, &s::H_L, &s::H_UL], [&s::M_T, &s::H_T, &s::H_UT]] {
            let [moment, force, upper] = [moment, force, upper].map(|symbol| numbered(model, symbol, at));
            for case in 0..m.len() {
                let size = m[case] + h[case] * height;
                if size > 0.0 {
                    let rest = moment[case] + (force[case] - upper[case]) * height;
                    apart = apart.max(rest.abs() / size);
                }
            }
        }
    }
    vec![Check::at_most("column_rest", &s::AGREEMENT, apart, 1e-12)]
}
