//! From one stance of the groups to another: path, time, and whether the machine
//! can travel meanwhile. No allocation but that of [`Plan::new`].
//!
//! While the turning centre goes along one line through infinity or past the
//! machine, all axle lines meet in it and the machine may travel. Where that would
//! turn a group out of its range, through a forbidden range, or about a group
//! whose angle then jumps, the machine must stand and every cylinder runs straight
//! to its new length, all arriving together.

use crate::calc::Calc;
use crate::number::short;
use crate::plane::{self, Point};
use crate::steering::cylinder::Linkage;
use crate::steering::machine::{GROUPS, Limits, Machine, Refusal, within};
use crate::steering::mode::Centre;
use crate::steering::reach::stand;
use crate::steering::sizing::{Piston, flow};
use crate::steering::symbols as s;
use crate::symbol::quantities;

/// Pieces of a path, within which the motion changes evenly with time.
const PIECES: usize = 256;

/// A group that turns further within one piece, in rad, turns too fast to travel.
const JUMP: f64 = 0.06;

/// What a speed may be greater between the ends of a piece than at both, where no group turns further than [`JUMP`].
const BETWEEN: f64 = 1.001;

/// Two angles of a stance are one below this, in rad.
const SAME_STANCE: f64 = 1e-9;

quantities! {
    /// Speed limit of the cylinders, in m/s.
    Pace { speed: V_CX }
}

impl<C: Calc> Pace<C> {
    pub fn check(&self) -> Result<(), Refusal> {
        within(&s::V_CX, self.speed, 0.0, 10.0, true).map(drop)
    }
}

/// The motion of a machine about its turning centre as a unit vector: velocity of
/// the middle, angular velocity times the machine's size.
pub type Motion = [f64; 3];

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
#[derive(Clone, Debug)]
pub struct Plan {
    /// Whether the machine must stand.
    pub standing: bool,
    /// Duration, in s.
    pub time: f64,
    /// The group, from 0, whose cylinder is at its speed limit for the longest part of it.
    pub governing: usize,
    /// Directions of the motion at start and end.
    ends: [Motion; 2],
    /// Ends of the pieces, in s.
    times: [f64; PIECES + 1],
    /// Angles of the groups, in rad.
    start: Vec<f64>,
    target: Vec<f64>,
}

/// The way from one direction of the motion to another, on the great circle through both.
#[derive(Clone, Copy)]
struct Arc {
    from: Motion,
    /// At a right angle to it.
    towards: Motion,
    /// In rad.
    whole: f64,
    /// Of the machine.
    middle: Point<f64>,
    size: f64,
}

impl Arc {
    /// `None` between opposite directions: there is no shortest way.
    fn new(machine: &Machine<f64>, [a, b]: [Motion; 2]) -> Option<Arc> {
        let dot: f64 = (0..3).map(|i| a[i] * b[i]).sum();
        let across: Motion = std::array::from_fn(|i| b[i] - dot * a[i]);
        let apart = across.iter().map(|x| x * x).sum::<f64>().sqrt();
        if apart < SAME_STANCE && dot < 0.0 {
            return None;
        }
        let whole = if apart < SAME_STANCE {
            0.0
        } else {
            f64::direction(dot, apart)
        };
        Some(Arc {
            from: a,
            towards: across.map(|x| if whole == 0.0 { 0.0 } else { x / apart }),
            whole,
            middle: machine.middle,
            size: size(machine),
        })
    }

    fn centre(&self, motion: Motion) -> Centre<f64> {
        centre(self.middle, self.size, motion)
    }

    fn at(&self, part: f64) -> Motion {
        let (sin, cos) = Calc::sin_cos(part * self.whole);
        std::array::from_fn(|i| cos * self.from[i] + sin * self.towards[i])
    }
}

impl<'a> Crew<'a> {
    /// From the stance with this turning centre and these angles (rad) to another
    /// centre. Travelling is preferred to standing where both are possible.
    ///
    /// # Errors
    /// A speed or a number of angles, ranges or cylinders that cannot be, or a group that cannot turn so.
    pub fn transition(&self, from: &Centre<f64>, angles: &[f64], to: &Centre<f64>) -> Result<Plan, Refusal> {
        Pace { speed: self.speed }.check()?;
        let n = self.machine.groups.len();
        for (what, count) in [
            ("angles", angles.len()),
            ("ranges", self.limits.len()),
            ("cylinders", self.linkages.len()),
        ] {
            if count != n {
                return Err(Refusal::new(
                    what,
                    format!("{count} {what} for {n} groups"),
                    "give one for each group",
                ));
            }
        }
        let mut target = vec![0.0; n];
        stand(self.machine, self.limits, to, &mut target);
        let mut plan = Plan::new(n);
        plan.make(self, Some(self.motion(from)), angles, self.motion(to), &target)
            .map_err(|i| {
                let (degrees, range) = (|x: f64| short(x.to_degrees()), &self.limits[i]);
                Refusal::new(
                    format!("theta[{}]", i + 1),
                    format!(
                        "group {} cannot turn from {} to {} deg",
                        i + 1,
                        degrees(angles[i]),
                        degrees(target[i])
                    ),
                    format!(
                        "its range is {} to {} deg, and it must not pass a forbidden range: choose another way or mode",
                        degrees(range.min),
                        degrees(range.max)
                    ),
                )
            })?;
        Ok(plan)
    }

    /// The motion about a centre.
    #[must_use]
    pub fn motion(&self, centre: &Centre<f64>) -> Motion {
        let middle = centre.rolling(self.machine.middle);
        let turn = centre.turning().unwrap_or(0.0) * size(self.machine);
        let norm = (middle.x * middle.x + middle.y * middle.y + turn * turn).sqrt();
        [middle.x / norm, middle.y / norm, turn / norm]
    }

    /// After this, in s, every cylinder has had the time to go through all its
    /// lengths after all others: no change that is possible takes longer.
    #[must_use]
    pub fn longest(&self) -> f64 {
        let stroke = |linkage: &Linkage<f64>| 2.0 * plane::length(linkage.c) / self.speed;
        2.0 * self.linkages.iter().map(stroke).sum::<f64>()
    }

    /// The turning centre of a motion.
    #[must_use]
    pub fn centre(&self, motion: Motion) -> Centre<f64> {
        centre(self.machine.middle, size(self.machine), motion)
    }

    /// Angle of group `i` about a centre on the way of an arc from `start`, and how far its cylinder's length changes
    /// with one radian of the arc, in m.
    fn on(&self, i: usize, arc: &Arc, centre: &Centre<f64>, start: f64) -> (f64, f64) {
        let p = self.machine.groups[i];
        let (first, across) = (arc.centre(arc.from).rolling(p), arc.centre(arc.towards).rolling(p));
        let along = centre.rolling(p);
        let square = plane::dot(along, along);
        if square == 0.0 {
            return (start, 0.0);
        }
        // On less than half a great circle the heading turns one way, and by less than half a turn.
        let turn = if first == Point::zeros() {
            0.0
        } else {
            wrapped(f64::direction(plane::dot(first, along), plane::cross(first, along)))
        };
        let half = std::f64::consts::PI;
        let heading = f64::direction(along.x, along.y);
        let theta = heading + half * ((start + turn - heading) / half).round();
        let od = self.linkages[i].at_angle(theta).od;
        (theta, (od * plane::cross(first, across) / square).abs())
    }
}

/// Greatest distance of a group from the machine's middle, in m.
fn size(machine: &Machine<f64>) -> f64 {
    let arms = machine.groups.iter().map(|p| plane::length(p - machine.middle));
    arms.fold(0.0, f64::max)
}

fn centre(middle: Point<f64>, size: f64, motion: Motion) -> Centre<f64> {
    Centre::Beyond {
        from: middle,
        d: Point::new(-motion[1], motion[0]),
        w: motion[2] / size,
    }
}

/// An angle in (−π, π].
fn wrapped(angle: f64) -> f64 {
    let half = std::f64::consts::PI;
    if angle > half { angle - 2.0 * half } else { angle }
}

impl Plan {
    /// Room for a change of this many groups.
    #[must_use]
    pub fn new(groups: usize) -> Plan {
        Plan {
            standing: false,
            time: 0.0,
            governing: 0,
            ends: [[0.0; 3]; 2],
            times: [0.0; PIECES + 1],
            start: vec![0.0; groups],
            target: vec![0.0; groups],
        }
    }

    /// From a motion, if the groups have one, and angles (rad) to others. It ends
    /// exactly on the target's angles, or half a turn over where only that leads
    /// around a forbidden range.
    ///
    /// # Errors
    /// The first group that cannot turn so, from 0.
    ///
    /// # Panics
    /// Where there is not one angle for each group.
    pub fn make(
        &mut self,
        crew: &Crew<'_>,
        from: Option<Motion>,
        start: &[f64],
        to: Motion,
        target: &[f64],
    ) -> Result<(), usize> {
        self.start.copy_from_slice(start);
        let mut ways = [None, None];
        if let Some(from) = from {
            let senses = [to, to.map(|x| -x)];
            ways = senses.map(|to| self.travelling(crew, [from, to], target));
        }
        let fastest = |a: &Way, b: &Way| (!a.direct, a.time).partial_cmp(&(!b.direct, b.time));
        let best = ways
            .into_iter()
            .flatten()
            .min_by(|a, b| fastest(a, b).unwrap_or(std::cmp::Ordering::Equal));
        let stands = self.standing(crew, target);
        match best {
            Some(way) if way.direct || stands != Ok(true) => {
                // Made once more: the other sense or standing has been here since.
                self.travelling(crew, way.ends, target);
                (self.standing, self.time, self.governing) = (false, way.time, way.governing);
                self.ends = way.ends;
                if way.direct {
                    self.target.copy_from_slice(target);
                }
                Ok(())
            }
            _ => stands.map(drop),
        }
    }

    /// Tries to travel; leaves times and angles of the end.
    fn travelling(&mut self, crew: &Crew<'_>, ends: [Motion; 2], target: &[f64]) -> Option<Way> {
        let arc = Arc::new(crew.machine, ends)?;
        let n = self.start.len();
        let mut governed = [0.0; GROUPS[1]];
        let mut last = [(0.0, 0.0); GROUPS[1]];
        for piece in 0..=PIECES {
            let centre = arc.centre(arc.at(piece as f64 / PIECES as f64));
            let (mut slowest, mut governing) = (0.0, 0);
            for (i, last) in last[..n].iter_mut().enumerate() {
                let (theta, rate) = crew.on(i, &arc, &centre, self.start[i]);
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
            if piece == 0 {
                self.times[0] = 0.0;
            } else {
                self.times[piece] = self.times[piece - 1] + slowest;
                governed[governing] += slowest;
            }
        }
        let direct = (0..n).all(|i| (last[i].0 - target[i]).abs() <= SAME_STANCE);
        self.target
            .iter_mut()
            .zip(last)
            .for_each(|(slot, (theta, _))| *slot = theta);
        let longest = |best: usize, i: usize| if governed[i] > governed[best] { i } else { best };
        Some(Way {
            ends,
            direct,
            time: self.times[PIECES],
            governing: (0..n).fold(0, longest),
        })
    }

    /// Every cylinder straight to its new length; whether on the target's own angles.
    fn standing(&mut self, crew: &Crew<'_>, target: &[f64]) -> Result<bool, usize> {
        (self.standing, self.time, self.governing) = (true, 0.0, 0);
        let mut direct = true;
        for (i, limits) in crew.limits.iter().enumerate() {
            let from = self.start[i];
            self.target[i] = if limits.allows_turn(from, target[i]) {
                target[i]
            } else {
                direct = false;
                let others = limits.equivalents(target[i]);
                others
                    .into_iter()
                    .find(|&angle| limits.allows_turn(from, angle))
                    .ok_or(i)?
            };
            let length = |angle: f64| crew.linkages[i].at_angle(angle).l;
            let time = (length(self.target[i]) - length(from)).abs() / crew.speed;
            if time > self.time {
                (self.time, self.governing) = (time, i);
            }
        }
        Ok(direct)
    }

    /// Whether it ends with the motion against that of its target: what was forward becomes backward.
    #[must_use]
    pub fn reversed(&self, target: Option<Motion>) -> bool {
        let along = |to: Motion| (0..3).map(|i| to[i] * self.ends[1][i]).sum::<f64>();
        !self.standing && target.is_some_and(|to| along(to) < 0.0)
    }

    /// Angles at the end, in rad.
    #[must_use]
    pub fn target(&self) -> &[f64] {
        &self.target
    }

    /// Angles at a time (s) after the start, in rad; before it those of the start,
    /// after the end those of the end. While travelling their axle lines meet
    /// exactly in the centre of the motion returned; standing there is none until the end.
    ///
    /// # Panics
    /// Where the slice is not of one angle for each group.
    pub fn angles(&self, crew: &Crew<'_>, time: f64, angles: &mut [f64]) -> Option<Motion> {
        if time >= self.time {
            angles.copy_from_slice(&self.target);
            return (!self.standing).then_some(self.ends[1]);
        }
        if time <= 0.0 {
            angles.copy_from_slice(&self.start);
            return (!self.standing).then_some(self.ends[0]);
        }
        if self.standing {
            let part = time / self.time;
            for (i, slot) in angles.iter_mut().enumerate() {
                let length = |angle: f64| crew.linkages[i].at_angle(angle).l;
                let (from, to) = (length(self.start[i]), length(self.target[i]));
                *slot = crew.linkages[i]
                    .angle(from + part * (to - from))
                    .unwrap_or(self.target[i]);
            }
            return None;
        }
        let arc = Arc::new(crew.machine, self.ends)?;
        let piece = self.times.partition_point(|&at| at <= time).clamp(1, PIECES);
        let (from, to) = (self.times[piece - 1], self.times[piece]);
        let part = if to > from { (time - from) / (to - from) } else { 1.0 };
        let motion = arc.at((((piece - 1) as f64) + part) / PIECES as f64);
        let centre = arc.centre(motion);
        for (i, slot) in angles.iter_mut().enumerate() {
            *slot = crew.on(i, &arc, &centre, self.start[i]).0;
        }
        Some(motion)
    }

    /// Greatest oil flow of all cylinders together, in m³/s.
    #[must_use]
    pub fn greatest_flow(&self, crew: &Crew<'_>, piston: &Piston<f64>) -> f64 {
        let (mut before, mut after) = (self.start.clone(), self.start.clone());
        let mut greatest = 0.0;
        for step in 1..=PIECES {
            let ends = [step - 1, step].map(|end| match self.standing {
                true => self.time * end as f64 / PIECES as f64,
                false => self.times[end],
            });
            self.angles(crew, ends[1], &mut after);
            let length = |i: usize, angle: f64| crew.linkages[i].at_angle(angle).l;
            let speed = |i: usize| (length(i, after[i]) - length(i, before[i])) / (ends[1] - ends[0]);
            if ends[1] > ends[0] {
                greatest = (0..after.len())
                    .map(|i| flow(piston, speed(i)).abs())
                    .sum::<f64>()
                    .max(greatest);
            }
            std::mem::swap(&mut before, &mut after);
        }
        greatest
    }
}

/// A way on which the machine may travel.
#[derive(Clone, Copy)]
struct Way {
    ends: [Motion; 2],
    /// Whether it ends on the target's own angles.
    direct: bool,
    time: f64,
    governing: usize,
}
