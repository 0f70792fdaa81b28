//! Where the steered groups stand, how far each can turn, and what is refused.

use crate::calc::Calc;
use crate::number::short;
use crate::plane::Point;
use crate::steering::symbols as s;
use crate::symbol::Symbol;

/// Smallest and greatest number of steered groups.
pub const GROUPS: [usize; 2] = [4, 64];

/// Groups nearer than this coincide, in m.
pub const NEAREST: f64 = 1e-3;

/// Angles that differ by less are one where an end of a range is concerned, in
/// rad: what rounding makes of a command exactly at the end.
pub const SAME: f64 = 1e-12;

/// A value that is not accepted, in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// The quantity to blame, as in the symbol table, with the group's number from 1: `theta[3]`.
    pub key: String,
    /// What is wrong, with the value.
    pub what: String,
    /// What is allowed, and what to do.
    pub help: String,
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}; {}", self.what, self.help)
    }
}

impl Refusal {
    #[cold]
    pub(crate) fn new(key: impl Into<String>, what: impl Into<String>, help: impl Into<String>) -> Refusal {
        Refusal {
            key: key.into(),
            what: what.into(),
            help: help.into(),
        }
    }
}

/// The value itself where it lies within `low` to `high` (SI); `open` excludes the lower end.
pub fn within<C: Calc>(symbol: &'static Symbol, value: C, low: f64, high: f64, open: bool) -> Result<C, Refusal> {
    let x = value.value();
    let above = if open { x > low } else { x >= low };
    if above && x <= high && x.is_finite() {
        return Ok(value);
    }
    let least = if open { "above" } else { "at least" };
    let most = if high.is_finite() {
        format!(" and at most {}", symbol.written(high))
    } else {
        String::new()
    };
    Err(Refusal::new(
        symbol.id,
        format!("{} = {}", symbol.id, symbol.written(x)),
        format!("it must be {least} {}{most}", symbol.written(low)),
    ))
}

/// A machine with its steered groups; lengths in m.
#[derive(Clone, Debug)]
pub struct Machine<C> {
    pub groups: Vec<Point<C>>,
    /// Corners of the machine's outline, in order around it, for the path they
    /// sweep and for turning about one of them; may be empty.
    pub corners: Vec<Point<C>>,
    /// Group whose angle commands front-axle, all-wheel and crab steering.
    pub base: usize,
    /// Group whose angle commands rear-axle steering.
    pub rear_base: usize,
    /// Foremost and rearmost axle line's x.
    pub front: C,
    pub rear: C,
    /// Outermost groups' y.
    pub left: C,
    pub right: C,
    /// Midway between the outermost groups.
    pub middle: Point<C>,
}

impl<C: Calc> Machine<C> {
    /// Any layout of 4 to 64 groups no two of which coincide.
    pub fn new(
        groups: Vec<Point<C>>,
        corners: Vec<Point<C>>,
        base: usize,
        rear_base: usize,
    ) -> Result<Machine<C>, Refusal> {
        let [least, most] = GROUPS;
        if !(least..=most).contains(&groups.len()) {
            return Err(Refusal::new(
                "groups",
                format!("{} steered groups", groups.len()),
                format!("there must be {least} to {most}"),
            ));
        }
        for (name, points) in [("group", &groups), ("corner", &corners)] {
            for (i, p) in points.iter().enumerate() {
                for (axis, x) in [("x", p.x.value()), ("y", p.y.value())] {
                    if x.is_nan() || x.abs() > 1e4 {
                        return Err(Refusal::new(
                            format!("{name}[{}].{axis}", i + 1),
                            format!("{name}[{}].{axis} = {}", i + 1, s::X_I.written(x)),
                            "it must lie between -10000 m and 10000 m",
                        ));
                    }
                }
            }
        }
        for (i, a) in groups.iter().enumerate() {
            for (j, b) in groups[..i].iter().enumerate() {
                let apart = crate::plane::length(Point::new(a.x.value() - b.x.value(), a.y.value() - b.y.value()));
                if apart < NEAREST {
                    return Err(Refusal::new(
                        format!("group[{}]", i + 1),
                        format!(
                            "groups {} and {} coincide at ({}, {}) m: they are {} m apart",
                            j + 1,
                            i + 1,
                            short(a.x.value()),
                            short(a.y.value()),
                            short(apart)
                        ),
                        format!("groups must be at least {NEAREST} m apart"),
                    ));
                }
            }
        }
        for (name, index) in [("base", base), ("rear_base", rear_base)] {
            if index >= groups.len() {
                return Err(Refusal::new(
                    name,
                    format!("{name} = group {}", index + 1),
                    format!("the groups are numbered 1 to {}", groups.len()),
                ));
            }
        }
        let greatest = |pick: fn(&Point<C>) -> C, sign: f64| {
            groups.iter().map(pick).fold(pick(&groups[0]), |best, x| {
                if sign * x.value() > sign * best.value() {
                    x
                } else {
                    best
                }
            })
        };
        let (front, rear) = (
            greatest(|p| p.x, 1.0).def(&s::X_F),
            greatest(|p| p.x, -1.0).def(&s::X_R),
        );
        let (left, right) = (
            greatest(|p| p.y, 1.0).def(&s::Y_L),
            greatest(|p| p.y, -1.0).def(&s::Y_R),
        );
        let two = C::constant(2.0);
        let middle = Point::new(((front + rear) / two).def(&s::X_M), ((left + right) / two).def(&s::Y_M));
        Ok(Machine {
            groups,
            corners,
            base,
            rear_base,
            front,
            rear,
            left,
            right,
            middle,
        })
    }
}

impl<C: Calc> Machine<C> {
    /// The same machine over another scalar.
    #[must_use]
    pub fn map<D: Calc>(&self, f: impl Fn(C) -> D) -> Machine<D> {
        let point = |p: &Point<C>| Point::new(f(p.x), f(p.y));
        Machine {
            groups: self.groups.iter().map(point).collect(),
            corners: self.corners.iter().map(point).collect(),
            base: self.base,
            rear_base: self.rear_base,
            front: f(self.front),
            rear: f(self.rear),
            left: f(self.left),
            right: f(self.right),
            middle: point(&self.middle),
        }
    }
}

/// How far a group turns, in rad; counter-clockwise positive.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    pub min: f64,
    pub max: f64,
    /// Ranges inside, open at their ends, through which the group must not turn.
    pub forbidden: Vec<[f64; 2]>,
}

impl Limits {
    /// A range that contains straight ahead, less than a turn in all.
    pub fn new(min: f64, max: f64, forbidden: Vec<[f64; 2]>) -> Result<Limits, Refusal> {
        let half = std::f64::consts::PI;
        if min >= -half && max <= half && min <= 0.0 && max >= 0.0 {
            let whole = Limits {
                min,
                max,
                forbidden: Vec::new(),
            };
            return whole.forbid(forbidden);
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
        let (smaller, greater) = (
            |a: C, b: C| if b.value() < a.value() { b } else { a },
            |a: C, b: C| if b.value() > a.value() { b } else { a },
        );
        let outer = smaller(theta - min, max - theta);
        let inner = self
            .forbidden
            .iter()
            .map(|[from, to]| greater(C::constant(*from) - theta, theta - C::constant(*to)));
        inner.fold(outer, smaller)
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
        let half = std::f64::consts::PI;
        let principal = theta - half * (theta / half).round();
        let other = principal - half.copysign(principal);
        [principal, other].into_iter().filter(|&angle| self.allows(angle))
    }
}
