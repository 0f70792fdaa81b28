//! The plan of a change of stance. No allocation.

use std::cmp::Ordering;

use crate::steering::centre::Centre;
use crate::steering::cylinder::Linkage;
use crate::steering::limits::Limits;
use crate::steering::machine::{GROUPS, Machine};
use crate::steering::stand::stand;
use crate::steering::transition::{GreatCircle, SAME_STANCE, Twist};

/// Pieces of a path, within which the motion changes evenly with time.
pub(super) const PIECES: usize = 256;

/// A group that turns further within one piece, in rad, turns too fast to travel.
const JUMP: f64 = 0.06;

/// What a speed may be greater between the ends of a piece than at both, where no group turns further than [`JUMP`].
const BETWEEN: f64 = 1.001;

/// Angles of as many groups as there are, in rad.
type Angles = [f64; GROUPS[1]];

/// The groups with their ranges and cylinders.
#[derive(Clone, Copy, Debug)]
pub struct Crew<'a> {
    pub machine: &'a Machine<f64>,
    pub limits: &'a [Limits],
    pub linkages: &'a [Linkage<f64>],
    /// Greatest speed of a cylinder, in m/s.
    pub speed: f64,
}

/// A change of stance.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// Whether the machine must stand.
    pub standing: bool,
    /// Duration, in s.
    pub time: f64,
    /// The group, from 0, whose cylinder is at its speed limit for the longest part of it.
    pub governing: usize,
    /// Whether it ends on the target's own angles, and not half a turn over.
    direct: bool,
    /// Directions of the motion at start and end, where the machine travels.
    pub(super) ends: [Twist; 2],
    /// Ends of the pieces, in s.
    pub(super) times: [f64; PIECES + 1],
    pub(super) start: Angles,
    pub(super) target: Angles,
}

impl<'a> Crew<'a> {
    /// From the stance with this turning centre and these angles (rad) to another centre.
    ///
    /// # Errors
    /// As [`Plan::new`].
    pub fn transition(&self, from: &Centre<f64>, angles: &[f64], to: &Centre<f64>) -> Result<Plan, usize> {
        let target = stand(self.machine, self.limits, to);
        let [from, to] = [from, to].map(|centre| self.machine.motion(centre));
        Plan::new(self, Some(from), angles, to, &target)
    }
}

impl Plan {
    /// From a motion, if the groups have one, and angles (rad) to others. Travelling is preferred to standing where both
    /// are possible. It ends exactly on the target's angles, or half a turn over where only that leads around a forbidden
    /// range.
    ///
    /// # Errors
    /// The first group that cannot turn so, from 0.
    ///
    /// # Panics
    /// Where there is not one angle for each group.
    pub fn new(crew: &Crew<'_>, from: Option<Twist>, start: &[f64], to: Twist, target: &[f64]) -> Result<Plan, usize> {
        let mut resting = Plan {
            standing: true,
            time: 0.0,
            governing: 0,
            direct: true,
            ends: [[0.0; 3]; 2],
            times: [0.0; PIECES + 1],
            start: [0.0; GROUPS[1]],
            target: [0.0; GROUPS[1]],
        };
        let n = crew.machine.groups.len();
        resting.start[..n].copy_from_slice(start);
        resting.target[..n].copy_from_slice(target);
        let senses = [to, to.map(|x| -x)].into_iter();
        let ways = from
            .into_iter()
            .flat_map(|from| senses.clone().map(move |to| [from, to]));
        let faster = |a: &Plan, b: &Plan| (!a.direct, a.time).partial_cmp(&(!b.direct, b.time));
        let best = ways
            .filter_map(|ends| resting.travelling(crew, ends))
            .min_by(|a, b| faster(a, b).unwrap_or(Ordering::Equal));
        let stands = resting.standing(crew);
        match best {
            Some(way) if way.direct || !stands.as_ref().is_ok_and(|stands| stands.direct) => Ok(way),
            _ => stands,
        }
    }

    /// A way on which the machine may travel from the first motion to the second.
    fn travelling(&self, crew: &Crew<'_>, ends: [Twist; 2]) -> Option<Plan> {
        let arc = GreatCircle::new(crew.machine, ends)?;
        let mut plan = Plan {
            standing: false,
            ends,
            ..*self
        };
        let n = crew.machine.groups.len();
        let mut governed = [0.0; GROUPS[1]];
        let mut last = [(0.0, 0.0); GROUPS[1]];
        for piece in 0..=PIECES {
            let centre = arc.centre(arc.at(piece as f64 / PIECES as f64));
            let (mut slowest, mut governing) = (0.0, 0);
            for (i, last) in last[..n].iter_mut().enumerate() {
                let (theta, rate) = arc.on(crew.machine.groups[i], &crew.linkages[i], &centre, self.start[i]);
                // The first piece is the start itself.
                let ((before, rate_before), most) = match piece {
                    0 => ((self.start[i], 0.0), SAME_STANCE),
                    _ => (*last, JUMP),
                };
                if (theta - before).abs() > most || !crew.limits[i].allows_turn(before, theta) {
                    return None;
                }
                let time = BETWEEN * f64::max(rate, rate_before) * arc.whole / PIECES as f64 / crew.speed;
                if time > slowest {
                    (slowest, governing) = (time, i);
                }
                *last = (theta, rate);
            }
            if piece > 0 {
                plan.times[piece] = plan.times[piece - 1] + slowest;
                governed[governing] += slowest;
            }
        }
        let longest = |best: usize, i: usize| if governed[i] > governed[best] { i } else { best };
        (plan.time, plan.governing) = (plan.times[PIECES], (0..n).fold(0, longest));
        plan.direct = (0..n).all(|i| (last[i].0 - self.target[i]).abs() <= SAME_STANCE);
        if !plan.direct {
            plan.target = last.map(|(theta, _)| theta);
        }
        Some(plan)
    }

    /// Every cylinder straight to its new length.
    fn standing(&self, crew: &Crew<'_>) -> Result<Plan, usize> {
        let mut plan = *self;
        for (i, limits) in crew.limits.iter().enumerate() {
            let (from, to) = (self.start[i], self.target[i]);
            if !limits.allows_turn(from, to) {
                let mut others = limits.equivalents(to);
                plan.target[i] = others.find(|&angle| limits.allows_turn(from, angle)).ok_or(i)?;
                plan.direct = false;
            }
            let length = |angle: f64| crew.linkages[i].at_angle(angle).l;
            let time = (length(plan.target[i]) - length(from)).abs() / crew.speed;
            if time > plan.time {
                (plan.time, plan.governing) = (time, i);
            }
        }
        Ok(plan)
    }

    /// Whether it ends with the motion against that of its target: what was forward becomes backward.
    #[must_use]
    pub fn reversed(&self, target: Option<Twist>) -> bool {
        let along = |to: Twist| (0..3).map(|i| to[i] * self.ends[1][i]).sum::<f64>();
        !self.standing && target.is_some_and(|to| along(to) < 0.0)
    }

    /// Ends of the pieces within which it changes evenly, in s.
    #[must_use]
    pub fn pieces(&self) -> [f64; PIECES + 1] {
        match self.standing {
            true => std::array::from_fn(|piece| self.time * piece as f64 / PIECES as f64),
            false => self.times,
        }
    }
}
