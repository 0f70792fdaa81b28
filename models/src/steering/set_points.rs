//! Set points of the groups' angles in a running model: what is commanded, and after a change of mode the way there
//! within the speed limit of the cylinders. A command that is out of reach is replaced by the nearest one.
//!
//! A change starts when mode, kind of command or corner change, from the set points of that moment. Its way is always
//! that from there to the current command: a command that moves meanwhile moves the way with it.

use crate::calc::Calc;
use crate::model::Fault;
use crate::plane::{self, Point};
use crate::steering::outputs::Evaluation;
use crate::steering::searched::Search;
use crate::steering::transition::{Crew, Motion, Plan};

/// Where the last change of mode started.
#[derive(Clone, Debug)]
pub struct Change {
    /// Whether the model runs: before that, modes are start values.
    pub running: bool,
    /// In s; infinite while there was no change.
    since: f64,
    /// The motion, where the axle lines met.
    motion: Option<Motion>,
    /// Angles of the groups, in rad.
    angles: Vec<f64>,
}

impl Change {
    #[must_use]
    pub fn new(groups: usize) -> Change {
        Change {
            running: false,
            since: f64::INFINITY,
            motion: None,
            angles: vec![0.0; groups],
        }
    }

    /// As numbers: running, since, motion with its flag, angles.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let [x, y, z] = self.motion.unwrap_or_default();
        let motion = [f64::from(self.motion.is_some()), x, y, z];
        let head = [f64::from(self.running), self.since];
        head.into_iter().chain(motion).chain(self.angles.iter().copied())
    }

    /// How many numbers there are.
    #[must_use]
    pub fn count(&self) -> usize {
        6 + self.angles.len()
    }

    /// Takes back what [`Change::numbers`] gave.
    pub fn read(&mut self, numbers: &[f64]) {
        let (head, angles) = numbers.split_at(6);
        (self.running, self.since) = (head[0] != 0.0, head[1]);
        self.motion = (head[2] != 0.0).then_some([head[3], head[4], head[5]]);
        self.angles.copy_from_slice(angles);
    }
}

/// A result of a change of mode; set points with the group's number from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfChange {
    SetPoint(usize),
    Speed(usize),
    Duration,
    Left,
    Stand,
}

/// The set points of the current inputs, computed when they are asked for.
#[derive(Clone, Debug)]
pub struct SetPoints {
    plan: Plan,
    /// Whether the plan is that of the current inputs, and whether there is a way.
    planned: Option<bool>,
    motion: Option<Motion>,
    points: Vec<f64>,
    /// Whether the machine may travel, and whether the motion is against that of the command.
    travels: bool,
    against: bool,
    /// Whether the points are those of the current inputs and time.
    placed: bool,
}

impl SetPoints {
    #[must_use]
    pub fn new(groups: usize) -> SetPoints {
        SetPoints {
            plan: Plan::new(groups),
            planned: None,
            motion: None,
            points: vec![0.0; groups],
            travels: false,
            against: false,
            placed: false,
        }
    }

    /// The inputs have changed.
    #[inline]
    pub fn forget(&mut self) {
        (self.planned, self.placed) = (None, false);
    }

    /// The time has changed.
    #[inline]
    pub fn pass(&mut self) {
        self.placed = false;
    }

    /// A result in SI at a time in s; a truth value is 0 or 1.
    ///
    /// # Errors
    /// As [`Evaluation::update`].
    pub fn get(
        &mut self,
        (evaluation, search, change): (&mut Evaluation<f64>, &mut Search, &Change),
        time: f64,
        what: OfChange,
    ) -> Result<f64, Fault> {
        if let OfChange::SetPoint(i) | OfChange::Speed(i) = what {
            self.place((&mut *evaluation, search, change), time)?;
            return match what {
                OfChange::Speed(i) => self.speed(evaluation, i),
                _ => Ok(self.points[i]),
            };
        }
        let possible = self.plan((evaluation, search, change))?;
        let duration = if possible { self.plan.time } else { f64::INFINITY };
        Ok(match what {
            OfChange::Stand => f64::from(!possible || self.plan.standing),
            OfChange::Left if change.since == f64::INFINITY => 0.0,
            OfChange::Left => (change.since + duration - time).max(0.0),
            _ => duration,
        })
    }

    /// Mode, kind of command or corner are about to change at a time in s: the set points of this moment are where the
    /// change starts.
    pub fn leave(&mut self, (evaluation, search): (&mut Evaluation<f64>, &mut Search), change: &mut Change, time: f64) {
        if !change.running || change.since == time {
            return;
        }
        // A command that its mode does not take has no set points: the last start is kept.
        if self.place((evaluation, search, change), time).is_ok() {
            change.angles.copy_from_slice(&self.points);
            change.motion = self.motion;
        }
        change.since = time;
        self.forget();
    }

    /// Plans the change to the current command; whether there is a way. Without a change there is none to go.
    fn plan(
        &mut self,
        (evaluation, search, change): (&mut Evaluation<f64>, &mut Search, &Change),
    ) -> Result<bool, Fault> {
        if let Some(possible) = self.planned {
            return Ok(possible);
        }
        let (nearest, target) = search.nearest(evaluation)?;
        let crew = crew(evaluation)?;
        let possible = match nearest.centre {
            None => false,
            Some(centre) => {
                let to = crew.motion(&centre);
                let (from, start) = if change.since == f64::INFINITY {
                    (Some(to), target)
                } else {
                    (change.motion, change.angles.as_slice())
                };
                self.plan.make(&crew, from, start, to, target).is_ok()
            }
        };
        Ok(*self.planned.insert(possible))
    }

    fn place(
        &mut self,
        (evaluation, search, change): (&mut Evaluation<f64>, &mut Search, &Change),
        time: f64,
    ) -> Result<(), Fault> {
        if self.placed {
            return Ok(());
        }
        let (nearest, target) = search.nearest(evaluation)?;
        let crew = crew(evaluation)?;
        let to = nearest.centre.map(|centre| crew.motion(&centre));
        let direct = crew.limits.iter().all(|limits| limits.forbidden.is_empty());
        let before = change.since == f64::INFINITY;
        if before || (to.is_some() && direct && time - change.since >= crew.longest()) {
            // There is always a way within a range, and it has been gone.
            self.points.copy_from_slice(target);
            (self.motion, self.travels, self.against) = (to, to.is_some(), false);
        } else if self.plan((&mut *evaluation, search, change))? {
            let crew = self::crew(evaluation)?;
            let motion = self.plan.angles(&crew, time - change.since, &mut self.points);
            let arrived = time - change.since >= self.plan.time;
            self.motion = if arrived { to } else { motion };
            self.travels = arrived || !self.plan.standing;
            self.against = !arrived && self.plan.reversed(to);
        } else {
            self.points.copy_from_slice(&change.angles);
            (self.motion, self.travels, self.against) = (change.motion, false, false);
        }
        self.placed = true;
        Ok(())
    }
}

impl SetPoints {
    /// Rolling speed of a group at the set points, in m/s: the fastest group has the travel speed.
    fn speed(&self, evaluation: &mut Evaluation<f64>, i: usize) -> Result<f64, Fault> {
        let Some(motion) = self.motion.filter(|_| self.travels) else {
            return Ok(0.0);
        };
        let v_t = evaluation.inputs().v_t;
        let crew = crew(evaluation)?;
        let centre = crew.centre(motion);
        let groups = &crew.machine.groups;
        let fastest = groups
            .iter()
            .map(|p| plane::length(centre.rolling(*p)))
            .fold(0.0, f64::max);
        let (sin, cos) = Calc::sin_cos(self.points[i]);
        let along = plane::dot(centre.rolling(groups[i]), Point::new(cos, sin));
        Ok(if self.against { -v_t } else { v_t } * along / fastest)
    }
}

/// The groups with their speed limit.
fn crew(evaluation: &mut Evaluation<f64>) -> Result<Crew<'_>, Fault> {
    let pace = evaluation.parameters().pace;
    let (built, _) = evaluation.stance()?;
    let speed = pace.map(|pace| pace.speed);
    Ok(Crew {
        machine: &built.machine,
        limits: &built.limits,
        linkages: &built.linkages,
        speed: speed.ok_or_else(|| Fault::new("this scene does not model changes of mode"))?,
    })
}
