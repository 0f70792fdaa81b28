//! Independent ways to the forces on the rolling elements and the bolts.

use std::f64::consts::TAU;

use crate::component::sheet::Check;
use crate::component::standing::Standing;
use crate::component::telling::{fine, numbered};
use crate::kernel::calc::Calc;
use crate::supports::ring::law::RollingElements;
use crate::supports::ring::symbols as s;

/// The forces on all rolling elements against V and M; where they yield linearly and all bear, the greatest against
/// V/z + 4M/(z D).
pub fn agreements(model: &mut Standing, rolling: &RollingElements, diameter: f64) -> Vec<Check> {
    let count = rolling.cosines.len() as f64;
    let (mut balance, mut closed) = ([0.0_f64; 2], None);
    for at in fine(model.motion()).collect::<Vec<_>>() {
        let [v, m, p, lambda] = [&s::V, &s::M, &s::P_MAX, &s::LAMBDA_A].map(|symbol| numbered(model, symbol, at));
        for case in 0..v.len() {
            let (mut force, mut moment) = (0.0, 0.0);
            for cosine in &rolling.cosines {
                let approach = 1.0 - lambda[case] * (1.0 - cosine);
                if rolling.held_down || approach > 0.0 {
                    let own = p[case] * rolling.force(approach);
                    (force, moment) = (force + own, moment + own * cosine * diameter / 2.0);
                }
            }
            let whole = v[case] + 2.0 * m[case] / diameter;
            let apart = [
                (force - v[case]).abs() / whole,
                (moment - m[case]).abs() / (whole * diameter / 2.0),
            ];
            balance = [balance[0].max(apart[0]), balance[1].max(apart[1])];
            if rolling.is_linear() && (rolling.held_down || lambda[case] <= 1.0 / (1.0 - rolling.far())) {
                let wanted = (v[case] + 4.0 * m[case] / diameter) / count;
                closed = Some(closed.unwrap_or(0.0_f64).max((p[case] - wanted).abs() / wanted));
            }
        }
    }
    let mut checks = vec![
        Check::at_most("ring_sum", &s::AGREEMENT, balance[0], 1e-12),
        Check::at_most("ring_turn", &s::AGREEMENT, balance[1], 1e-12),
    ];
    checks.extend(closed.map(|apart| Check::at_most("ring_linear", &s::AGREEMENT, apart, 1e-12)));
    checks
}

/// The pulls on all bolts, which fall linearly across their circle (m) from the greatest through the mean, against V and M.
pub fn bolt_pulls(model: &mut Standing, [count, diameter]: [f64; 2]) -> Check {
    let mut apart = 0.0_f64;
    for at in fine(model.motion()).collect::<Vec<_>>() {
        let [v, m, pull] = [&s::V, &s::M, &s::F_B].map(|symbol| numbered(model, symbol, at));
        for case in 0..v.len() {
            let (mean, mut force, mut moment) = (-v[case] / count, 0.0, 0.0);
            for bolt in 0..count as usize {
                let cosine = Calc::sin_cos(TAU * bolt as f64 / count).1;
                let own = mean + (pull[case] - mean) * cosine;
                (force, moment) = (force + own, moment + own * cosine * diameter / 2.0);
            }
            let whole = v[case] + 2.0 * m[case] / diameter;
            apart = apart.max((force + v[case]).abs() / whole);
            apart = apart.max((moment - m[case]).abs() / (whole * diameter / 2.0));
        }
    }
    Check::at_most("ring_pulls", &s::AGREEMENT, apart, 1e-12)
}
