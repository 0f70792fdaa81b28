//! A maker's load curve of a slewing ring: the moment that it bears beside a force.

use crate::kernel::calc::Calc;
use crate::kernel::group::group;
use crate::kernel::symbol::Symbol;
use crate::parts::polyline::{named, straight};

/// A load curve: points (force N, moment N·m) with rising force.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoadCurve(pub Vec<[f64; 2]>);
group!(LoadCurve);

/// From the axes to a point and back, so that its number stands there.
#[must_use]
pub fn corner([f, m]: [f64; 2]) -> Vec<[f64; 2]> {
    vec![[0.0, m], [f, m], [f, 0.0], [f, m]]
}

impl LoadCurve {
    /// The moment that may act with a force, in N·m, on the straight line between two points, which have numbers after
    /// `before` others; `None` beyond the curve.
    #[must_use]
    pub fn limit<C: Calc>(&self, f: C, before: u16, names: [&'static Symbol; 2]) -> Option<C> {
        straight(&self.0, f, before, names)
    }

    /// How many times a force (N, above zero) and a moment (N·m, not negative) may both grow until they meet a curve that
    /// begins without a force: (F_1 M_2 − F_2 M_1) / (F (M_2 − M_1) − M (F_2 − F_1)) on the line that they meet first.
    #[must_use]
    pub fn growth<C: Calc>(&self, f: C, m: C, names: [&'static Symbol; 2]) -> Option<C> {
        let side = |[f_i, m_i]: [f64; 2]| f_i * m.value() - m_i * f.value();
        let met = (1..).zip(self.0.windows(2)).filter_map(|(number, pair)| {
            let [from, to] = [side(pair[0]), side(pair[1])];
            (from <= 0.0 && to >= 0.0 && to > from).then(|| {
                let [[f_1, m_1], [f_2, m_2]] = [0, 1].map(|i| named::<C>(names, number + i, pair[usize::from(i)]));
                (f_1 * m_2 - f_2 * m_1) / (f * (m_2 - m_1) - m * (f_2 - f_1))
            })
        });
        let first = met.reduce(|one: C, other| if other.value() < one.value() { other } else { one });
        // Beyond the last point the force alone is the limit.
        first.or_else(|| {
            let number = self.0.len() as u16;
            let [f_1, _] = named::<C>(names, number, *self.0.last()?);
            Some((f_1 / f).over(m))
        })
    }
}
