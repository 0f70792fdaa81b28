//! A led hoist rope to scale.

use crate::component::draw::Draw;
use crate::luffing::led::reeved::{MOST, Reeved};
use crate::luffing::led::stretch::{LedBars, LedStretch};

const NAMES: [&str; MOST] = ["S_1", "S_2", "S_3", "S_4", "S_5", "S_6"];

/// From the head over its sheaves, these with their names unless it is faint.
pub fn rope(draw: &mut Draw, reeved: &Reeved<f64>, bars: &LedBars<f64>, faint: bool) {
    let mut stretched = Vec::new();
    if reeved.stretches(bars, &mut stretched).is_err() {
        return;
    }
    let places = stretched.iter().map(LedStretch::place);
    let points: Vec<_> = [bars.head].into_iter().chain(places).collect();
    draw.bar(&points, faint);
    for ((place, name), fixed) in points[1..].iter().zip(NAMES).zip(reeved.fixed()) {
        draw.joint(*place, name, fixed, faint);
    }
}
