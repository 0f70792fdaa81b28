//! How far a change of stance is at a time, and the groups' angles then. No allocation.

use crate::steering::cylinder::Linkage;
use crate::steering::machine::Machine;
use crate::steering::plan::{PIECES, Plan};
use crate::steering::transition::{GreatCircle, Twist};

/// Where a change is.
#[derive(Clone, Copy, Debug)]
pub enum Moment {
    Start,
    /// What part of the time has gone.
    Standing(f64),
    /// With the present motion.
    Travelling(GreatCircle, Twist),
    End,
}

impl Plan {
    /// Where it is at a time (s) after the start: before it at the start, after the end at the end.
    #[must_use]
    pub fn at(&self, machine: &Machine<f64>, time: f64) -> Moment {
        if time >= self.time {
            return Moment::End;
        }
        if time <= 0.0 {
            return Moment::Start;
        }
        let arc = if self.standing {
            None
        } else {
            GreatCircle::new(machine, self.ends)
        };
        let Some(arc) = arc else {
            return Moment::Standing(time / self.time);
        };
        let piece = self.times.partition_point(|&at| at <= time).clamp(1, PIECES);
        let (from, to) = (self.times[piece - 1], self.times[piece]);
        let part = if to > from { (time - from) / (to - from) } else { 1.0 };
        Moment::Travelling(arc, arc.at((((piece - 1) as f64) + part) / PIECES as f64))
    }

    /// The motion then; none while the machine stands.
    #[must_use]
    pub fn motion(&self, moment: &Moment) -> Option<Twist> {
        let motion = match moment {
            Moment::Start | Moment::Standing(_) => self.ends[0],
            Moment::Travelling(_, motion) => *motion,
            Moment::End => self.ends[1],
        };
        (!self.standing).then_some(motion)
    }

    /// Angle of a group then, in rad. While the machine travels all axle lines meet exactly in the centre of the motion.
    #[must_use]
    pub fn angle(&self, moment: &Moment, group: usize, machine: &Machine<f64>, linkage: &Linkage<f64>) -> f64 {
        let (start, target) = (self.start[group], self.target[group]);
        match moment {
            Moment::Start => start,
            Moment::Standing(part) => {
                let [from, to] = [start, target].map(|angle| linkage.at_angle(angle).l);
                linkage.angle(from + part * (to - from)).unwrap_or(target)
            }
            Moment::Travelling(arc, motion) => arc.on(machine.groups[group], linkage, &arc.centre(*motion), start).0,
            Moment::End => target,
        }
    }
}
