//! From one stance of the groups to another: path, time, and whether the machine
//! can travel meanwhile.
//!
//! While the turning centre goes along one line through infinity or past the
//! machine, all axle lines meet in it and the machine may travel. Where that would
//! turn a group out of its range, through a forbidden range, or about a group
//! whose angle then jumps, the machine must stand and every cylinder runs straight
//! to its new length, all arriving together.

use crate::calc::Calc;
use crate::plane::{self, Point};
use crate::schema::short;
use crate::steering::cylinder::Linkage;
use crate::steering::machine::{Limits, Machine, Refusal, within};
use crate::steering::mode::Centre;
use crate::steering::sizing::{Piston, flow};
use crate::steering::symbols as s;

/// Pieces of a path, between which the time is spread evenly.
const PIECES: usize = 256;

/// A group that turns further within one piece, in rad, turns too fast to travel.
const JUMP: f64 = 0.2;

/// Two angles of a stance are one below this, in rad.
const SAME_STANCE: f64 = 1e-9;

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
pub struct Transition<'a> {
    crew: Crew<'a>,
    /// Whether the machine must stand.
    pub standing: bool,
    /// Duration, in s.
    pub time: f64,
    /// Angles of the groups at the end of each piece, from the start, in rad.
    angles: Vec<Vec<f64>>,
    times: Vec<f64>,
    /// Directions of the motion at start and end: velocity of the middle, angular velocity times size.
    motion: [[f64; 3]; 2],
}

impl<'a> Crew<'a> {
    /// From the stance with this turning centre and these angles (rad) to another
    /// centre. Travelling is preferred to standing where both are possible.
    pub fn transition(&self, from: &Centre<f64>, angles: &[f64], to: &Centre<f64>) -> Result<Transition<'a>, Refusal> {
        within(&s::V, self.speed, 0.0, 10.0, true).map_err(|found| Refusal {
            key: "v_cylinder".into(),
            what: format!("speed limit of the cylinders: {}", found.what),
            ..found
        })?;
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
        let (a, b) = (self.motion(from), self.motion(to));
        let paths = [b, b.map(|x| -x)].map(|b| self.travelling(a, b, angles));
        let fastest = paths.into_iter().flatten().min_by(|a, b| a.time.total_cmp(&b.time));
        match fastest {
            Some(found) => Ok(found),
            None => self.standing(a, b, angles, to),
        }
    }

    /// The motion of the machine about a centre as a unit vector: velocity of the
    /// middle, angular velocity times the machine's size.
    fn motion(&self, centre: &Centre<f64>) -> [f64; 3] {
        let middle = centre.rolling(self.machine.middle);
        let turn = centre.turning().unwrap_or(0.0) * self.size();
        let norm = (middle.x * middle.x + middle.y * middle.y + turn * turn).sqrt();
        [middle.x / norm, middle.y / norm, turn / norm]
    }

    fn size(&self) -> f64 {
        let arms = self
            .machine
            .groups
            .iter()
            .map(|p| plane::length(p - self.machine.middle));
        arms.fold(0.0, f64::max)
    }

    /// The centre a fraction of the way from one motion to another, on the great circle through both.
    fn between(&self, [a, b]: [[f64; 3]; 2], part: f64) -> Option<Centre<f64>> {
        let dot: f64 = (0..3).map(|i| a[i] * b[i]).sum();
        let apart: f64 = (0..3).map(|i| (b[i] - dot * a[i]).powi(2)).sum::<f64>().sqrt();
        if apart < SAME_STANCE && dot < 0.0 {
            return None;
        }
        let whole = f64::direction(dot, apart);
        let mix = if apart < SAME_STANCE {
            [1.0 - part, part]
        } else {
            [Calc::sin((1.0 - part) * whole) / apart, Calc::sin(part * whole) / apart]
        };
        let motion: [f64; 3] = std::array::from_fn(|i| mix[0] * a[i] + mix[1] * b[i]);
        Some(Centre::Beyond {
            from: self.machine.middle,
            d: Point::new(-motion[1], motion[0]),
            w: motion[2] / self.size(),
        })
    }

    /// The angle of group `i` about a centre that is nearest to `near`.
    fn follow(&self, i: usize, centre: &Centre<f64>, near: f64) -> f64 {
        let along = centre.rolling(self.machine.groups[i]);
        if along.x == 0.0 && along.y == 0.0 {
            return near;
        }
        let half = std::f64::consts::PI;
        let theta = f64::direction(along.x, along.y);
        theta + half * ((near - theta) / half).round()
    }

    /// Greatest change of length of a cylinder over its speed, in s.
    fn duration(&self, from: &[f64], to: &[f64]) -> f64 {
        let each = self.linkages.iter().zip(from.iter().zip(to));
        each.map(|(linkage, (a, b))| (linkage.at_angle(*b).l - linkage.at_angle(*a).l).abs() / self.speed)
            .fold(0.0, f64::max)
    }

    fn travelling(&self, a: [f64; 3], b: [f64; 3], start: &[f64]) -> Option<Transition<'a>> {
        let mut angles = vec![start.to_vec()];
        let mut times = vec![0.0];
        for piece in 0..=PIECES {
            let centre = self.between([a, b], piece as f64 / PIECES as f64)?;
            let last = angles.last().expect("never empty");
            let next: Vec<f64> = (0..start.len()).map(|i| self.follow(i, &centre, last[i])).collect();
            for (i, (from, to)) in last.iter().zip(&next).enumerate() {
                let limit = if piece == 0 { SAME_STANCE } else { JUMP };
                if (to - from).abs() > limit || !self.limits[i].allows_turn(*from, *to) {
                    return None;
                }
            }
            if piece == 0 {
                continue;
            }
            times.push(times.last().expect("never empty") + self.duration(last, &next));
            angles.push(next);
        }
        Some(Transition {
            crew: *self,
            standing: false,
            time: *times.last().expect("never empty"),
            angles,
            times,
            motion: [a, b],
        })
    }

    fn standing(&self, a: [f64; 3], b: [f64; 3], start: &[f64], to: &Centre<f64>) -> Result<Transition<'a>, Refusal> {
        let mut target = Vec::with_capacity(start.len());
        for (i, (&from, limits)) in start.iter().zip(self.limits).enumerate() {
            let theta = self.follow(i, to, from);
            let nearest = limits
                .equivalents(theta)
                .filter(|&angle| limits.allows_turn(from, angle))
                .min_by(|a, b| (a - from).abs().total_cmp(&(b - from).abs()));
            target.push(nearest.ok_or_else(|| {
                let degrees = |x: f64| short(x.to_degrees());
                Refusal::new(
                    format!("theta[{}]", i + 1),
                    format!(
                        "group {} cannot turn from {} to {} deg",
                        i + 1,
                        degrees(from),
                        degrees(theta)
                    ),
                    format!(
                        "its range is {} to {} deg, and it must not pass a forbidden range: choose another way or mode",
                        degrees(limits.min),
                        degrees(limits.max)
                    ),
                )
            })?);
        }
        let time = self.duration(start, &target);
        let lengths = |i: usize, angle: f64| self.linkages[i].at_angle(angle).l;
        let mut angles = vec![start.to_vec()];
        for piece in 1..=PIECES {
            let part = piece as f64 / PIECES as f64;
            let at = |i: usize| {
                let (from, to) = (lengths(i, start[i]), lengths(i, target[i]));
                let l = from + part * (to - from);
                if piece == PIECES {
                    target[i]
                } else {
                    self.linkages[i].angle(l).unwrap_or(target[i])
                }
            };
            angles.push((0..start.len()).map(at).collect());
        }
        Ok(Transition {
            crew: *self,
            standing: true,
            time,
            angles,
            times: (0..=PIECES).map(|piece| time * piece as f64 / PIECES as f64).collect(),
            motion: [a, b],
        })
    }
}

impl Transition<'_> {
    /// Angles at the end, in rad.
    #[must_use]
    pub fn target(&self) -> &[f64] {
        self.angles.last().expect("never empty")
    }

    /// Angles at a time (s) after the start, in rad; before it those of the start,
    /// after the end those of the end. While travelling their axle lines meet
    /// exactly in the centre returned; standing there is none.
    ///
    /// # Panics
    /// Where the slice is not of one angle for each group.
    pub fn angles(&self, time: f64, angles: &mut [f64]) -> Option<Centre<f64>> {
        assert!(angles.len() == self.angles[0].len(), "one for each group");
        let piece = self.times.partition_point(|&at| at < time).clamp(1, PIECES);
        let (from, to) = (self.times[piece - 1], self.times[piece]);
        let part = if to > from {
            ((time - from) / (to - from)).clamp(0.0, 1.0)
        } else {
            1.0
        };
        let at = |i: usize| self.angles[piece - 1][i] + part * (self.angles[piece][i] - self.angles[piece - 1][i]);
        let centre = (!self.standing)
            .then(|| {
                self.crew
                    .between(self.motion, ((piece - 1) as f64 + part) / PIECES as f64)
            })
            .flatten();
        for (i, slot) in angles.iter_mut().enumerate() {
            *slot = centre.map_or(at(i), |centre| self.crew.follow(i, &centre, at(i)));
        }
        centre
    }

    /// Greatest oil flow of all cylinders together, in m³/s.
    #[must_use]
    pub fn greatest_flow(&self, piston: &Piston<f64>) -> f64 {
        let pieces = self.angles.windows(2).zip(self.times.windows(2));
        pieces
            .filter(|(_, times)| times[1] > times[0])
            .map(|(angles, times)| {
                let each = self.crew.linkages.iter().zip(angles[0].iter().zip(&angles[1]));
                each.map(|(linkage, (a, b))| {
                    let speed = (linkage.at_angle(*b).l - linkage.at_angle(*a).l) / (times[1] - times[0]);
                    flow(piston, speed).abs()
                })
                .sum()
            })
            .fold(0.0, f64::max)
    }
}
