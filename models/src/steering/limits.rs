//! How far each group turns.

use std::f64::consts::PI;

use crate::kernel::calc::Calc;
use crate::kernel::number::short;
use crate::steering::refusal::Refusal;

/// Angles that differ by less are one where an end of a range is concerned, in
/// rad: what rounding makes of a command exactly at the end.
pub const SAME: f64 = 1e-12;

/// How far a group turns, in rad; counter-clockwise positive.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    pub min: f64,
    pub max: f64,
    /// Ranges inside, open at their ends, through which the group must not turn.
    pub forbidden: Vec<[f64; 2]>,
}

impl Limits {
    /// All that lies between two angles.
    #[must_use]
    pub fn between([min, max]: [f64; 2]) -> Limits {
        Limits {
            min,
            max,
            forbidden: Vec::new(),
        }
    }

    /// A range that contains straight ahead, less than a turn in all.
    pub fn new(min: f64, max: f64, forbidden: Vec<[f64; 2]>) -> Result<Limits, Refusal> {
        if min >= -PI && max <= PI && min <= 0.0 && max >= 0.0 {
            return Limits::between([min, max]).forbid(forbidden);
        }
        Err(Refusal::new(
            "theta",
            format!(
                "range of a group {} to {} deg",
                short(min.to_degrees()),
                short(max.to_degrees())
            ),
            "it must contain 0 deg and lie within -180 to 180 deg",
        ))
    }

    /// The same range with these ranges in it forbidden.
    pub fn forbid(mut self, forbidden: Vec<[f64; 2]>) -> Result<Limits, Refusal> {
        let degrees = |x: f64| short(x.to_degrees());
        let sound =
            |[from, to]: &&[f64; 2]| from < to && *from >= self.min && *to <= self.max && !(*from < 0.0 && *to > 0.0);
        if let Some([from, to]) = forbidden.iter().find(|range| !sound(range)) {
            return Err(Refusal::new(
                "forbidden",
                format!("forbidden range {} to {} deg", degrees(*from), degrees(*to)),
                format!(
                    "its second end must be the greater one, both must lie within {} to {} deg, and 0 deg must stay allowed",
                    degrees(self.min),
                    degrees(self.max)
                ),
            ));
        }
        self.forbidden = forbidden;
        Ok(self)
    }

    /// Smallest angle, in rad, that is left at a heading to an end of the range or to a forbidden one; negative
    /// beyond it. The ends are those of the range, over the same scalar.
    pub fn margin<C: Calc>(&self, [min, max]: [C; 2], theta: C) -> C {
        let beside = |[from, to]: &[f64; 2]| (C::constant(*from) - theta).greater(theta - C::constant(*to));
        let inner = self.forbidden.iter().map(beside);
        inner.fold((theta - min).smaller(max - theta), C::smaller)
    }

    /// Whether the group may stand at this angle.
    #[must_use]
    pub fn allows(&self, theta: f64) -> bool {
        let inside = theta >= self.min - SAME && theta <= self.max + SAME;
        inside
            && !self
                .forbidden
                .iter()
                .any(|[from, to]| theta > from + SAME && theta < to - SAME)
    }

    /// Whether the group may turn from one angle to the other.
    #[must_use]
    pub fn allows_turn(&self, from: f64, to: f64) -> bool {
        let (low, high) = (from.min(to), from.max(to));
        let crossed = |[a, b]: &[f64; 2]| high > a + SAME && low < b - SAME;
        self.allows(from) && self.allows(to) && !self.forbidden.iter().any(crossed)
    }

    /// The angles that have the axle line of `theta` and are allowed, nearest to straight ahead first.
    pub fn equivalents(&self, theta: f64) -> impl Iterator<Item = f64> {
        let principal = theta - PI * (theta / PI).round();
        let other = principal - PI.copysign(principal);
        [principal, other].into_iter().filter(|&angle| self.allows(angle))
    }
}
