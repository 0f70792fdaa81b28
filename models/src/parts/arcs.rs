//! The crank angles in which a four-bar closes, and its change points.

use std::f64::consts::{PI, TAU};

use crate::kernel::calc::Calc;
use crate::parts::dead_points::Limit;
use crate::parts::four_bar::FourBar;

/// How near to a change point a linkage counts as having it: its margin there over four times crank and frame.
/// Within the root of it, in rad, it would turn from one way of moving to another.
const NEAR: f64 = 1e-9;

/// An interval of crank angles in which the linkage can be assembled, in rad;
/// the whole turn where it has no end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    pub from: f64,
    pub to: f64,
}

impl Arc {
    /// Whether it covers an interval, but for whole turns.
    #[must_use]
    pub fn covers(&self, from: f64, to: f64) -> bool {
        let turns = ((from - self.from) / TAU).floor() * TAU;
        from - turns >= self.from && to - turns <= self.to
    }
}

impl<C: Calc> FourBar<C> {
    /// The arcs of crank angles in which the linkage closes, each within one
    /// turn, ends included. With both kinds of dead point there are two.
    #[must_use]
    pub fn arcs(&self) -> Vec<Arc> {
        let ends = |ends: &[(C, f64); 2]| (ends[0].0.value(), ends[1].0.value());
        match (&self.stretched, &self.folded) {
            (Limit::Between(outer), Limit::Outside(inner)) => {
                let ((from, to), (low, high)) = (ends(outer), ends(inner));
                vec![Arc { from, to: low }, Arc { from: high, to }]
            }
            (Limit::Between(limit), _) | (_, Limit::Between(limit)) => {
                let (from, to) = ends(limit);
                vec![Arc { from, to }]
            }
            _ => vec![Arc {
                from: self.middle - PI,
                to: self.middle + PI,
            }],
        }
    }

    /// Crank angles (rad), at most one turn apart, at which all bars lie in one line, within 1e-9 of it: change points.
    pub fn change_points(&self) -> impl Iterator<Item = f64> + use<C> {
        let near = |limit: &Limit<C>, beyond: f64| match limit {
            Limit::Free(margin) if margin.value() < NEAR * 4.0 * (self.crank * self.frame_length).value() => {
                let frame = self.frame_direction.map(C::value);
                Some(f64::direction(frame.x, frame.y) + beyond)
            }
            _ => None,
        };
        [near(&self.folded, 0.0), near(&self.stretched, PI)]
            .into_iter()
            .flatten()
    }

    /// Whether the linkage keeps its branch through its change points: they are exact, and two in a turn.
    #[must_use]
    pub fn keeps_branch(&self) -> bool {
        self.changes
    }

    /// Whether the crank can turn without end.
    #[must_use]
    pub fn turns_fully(&self) -> bool {
        matches!((&self.stretched, &self.folded), (Limit::Free(_), Limit::Free(_)))
    }
}
