//! Set points of the groups' angles in a running model: what is commanded, and after a change of mode the way there
//! within the speed limit of the cylinders. A command that is out of reach is replaced by the nearest one.
//!
//! A change starts when mode, kind of command or corner change, from the set points of that moment. Its way is always
//! that from there to the current command: a command that moves meanwhile moves the way with it.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::change::Change;
use crate::steering::cylinder::Linkage;
use crate::steering::limits::Limits;
use crate::steering::machine::{Axis, GROUPS, Machine};
use crate::steering::nearest::{Heading, Nearest};
use crate::steering::plan::{Crew, Moment, Plan};
use crate::steering::symbols as s;
use crate::steering::transition::{Pace, Twist, longest};

/// The last change of mode, to the current command.
#[derive(Clone, Copy, Debug)]
pub struct Planned {
    /// `None` where there is no way.
    plan: Option<Plan>,
}
results! { plain Planned as p => {
    T_X: C::constant(p.time());
    STAND: C::constant(f64::from(p.plan.as_ref().is_none_or(|plan| plan.standing)));
} }

impl Planned {
    /// Without a change there is no way to go.
    pub fn new(
        machine: &Machine<f64>,
        limits: &[Limits],
        linkages: &[Linkage<f64>],
        pace: &Pace<f64>,
        nearest: &Nearest,
        headings: &[Heading<f64>],
        change: &Change,
    ) -> Planned {
        let Some(centre) = nearest.centre else {
            return Planned { plan: None };
        };
        let crew = Crew {
            machine,
            limits,
            linkages,
            speed: pace.speed,
        };
        let to = machine.motion(&centre);
        let mut target = [0.0; GROUPS[1]];
        headings
            .iter()
            .zip(&mut target)
            .for_each(|(heading, slot)| *slot = heading.0);
        let target = &target[..headings.len()];
        let plan = if change.since() == f64::INFINITY {
            Plan::new(&crew, Some(to), target, to, target)
        } else {
            Plan::new(&crew, change.motion(), change.angles(), to, target)
        };
        Planned { plan: plan.ok() }
    }

    /// Duration, in s; infinite where there is no way.
    fn time(&self) -> f64 {
        self.plan.as_ref().map_or(f64::INFINITY, |plan| plan.time)
    }
}

/// What is left of its duration, in s.
#[derive(Clone, Copy, Debug)]
pub struct Left<C>(C);
results! { Left as t => { T_LEFT: t.0; } }

impl Left<f64> {
    pub fn new(planned: &Planned, change: &Change, clock: &f64) -> Left<f64> {
        Left(match change.since() {
            f64::INFINITY => 0.0,
            since => (since + planned.time() - clock).max(0.0),
        })
    }
}

/// Whether the groups may still be on their way.
#[derive(Clone, Copy, Debug)]
pub struct UnderWay(bool);
results! { plain UnderWay; }

impl UnderWay {
    pub fn new(
        limits: &[Limits],
        linkages: &[Linkage<f64>],
        pace: &Pace<f64>,
        nearest: &Nearest,
        change: &Change,
        clock: &f64,
    ) -> UnderWay {
        // There is always a way within a range, and after the longest time it has been gone.
        let direct = limits.iter().all(|limits| limits.forbidden.is_empty());
        let gone = || direct && nearest.centre.is_some() && clock - change.since() >= longest(linkages, pace.speed);
        UnderWay(change.since() != f64::INFINITY && !gone())
    }

    #[must_use]
    pub fn holds(&self) -> bool {
        self.0
    }
}

/// Where the set points are on their way.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// `None` where they have arrived.
    course: Option<Course>,
    /// The machine's motion, where the axle lines meet.
    pub motion: Option<Twist>,
    /// Its turning centre and the greatest speed of a group for one radian per second; none while it must stand.
    rolling: Option<(Centre<f64>, f64)>,
    /// Whether the motion is against that of the command.
    against: bool,
}
results! { plain Way; }

#[derive(Clone, Copy, Debug)]
enum Course {
    Moment(Moment),
    /// Where the change started: there is no way.
    Stopped,
}

impl Way {
    pub fn new(
        machine: &Machine<f64>,
        nearest: &Nearest,
        _: &UnderWay,
        planned: Option<&Planned>,
        change: &Change,
        clock: &f64,
    ) -> Way {
        let to = nearest.centre.map(|centre| machine.motion(&centre));
        let (course, motion, travels, against) = match planned.map(|planned| &planned.plan) {
            None => (None, to, true, false),
            Some(None) => (Some(Course::Stopped), change.motion(), false, false),
            Some(Some(plan)) => match plan.at(machine, clock - change.since()) {
                end @ Moment::End => (Some(Course::Moment(end)), to, true, false),
                moment => {
                    let motion = plan.motion(&moment);
                    (Some(Course::Moment(moment)), motion, !plan.standing, plan.reversed(to))
                }
            },
        };
        let rolling = |motion: Twist| {
            let centre = machine.about(motion);
            let speeds = machine.groups.iter().map(|p| plane::length(centre.rolling(*p)));
            (centre, speeds.fold(0.0, f64::max))
        };
        Way {
            course,
            motion,
            rolling: motion.filter(|_| travels).map(rolling),
            against,
        }
    }

    #[must_use]
    pub fn holds(&self) -> bool {
        matches!(self.course, Some(Course::Moment(_)))
    }
}

/// Set point of a group's heading, in rad.
#[derive(Clone, Copy, Debug)]
pub struct SetPoint<C>(pub C);
results! { each SetPoint as p => { THETA_S: p.0; } }

/// Of all groups.
pub fn set_points(
    machine: &Machine<f64>,
    linkages: &[Linkage<f64>],
    headings: &[Heading<f64>],
    way: &Way,
    planned: Option<&Planned>,
    change: &Change,
    points: &mut Vec<SetPoint<f64>>,
) {
    let point = |i: usize| match (way.course, planned.and_then(|planned| planned.plan.as_ref())) {
        (Some(Course::Moment(moment)), Some(plan)) => plan.angle(&moment, i, machine, &linkages[i]),
        (Some(Course::Stopped), _) => change.angles()[i],
        _ => headings[i].0,
    };
    points.clear();
    points.extend((0..headings.len()).map(|i| SetPoint(point(i))));
}

/// Rolling speed of a group at the set points, in m/s: the fastest group has the travel speed.
#[derive(Clone, Copy, Debug)]
pub struct SetSpeed<C>(C);
results! { each SetSpeed as v => { V_S: v.0; } }

impl SetSpeed<f64> {
    pub fn new(axis: &Axis<f64>, point: &SetPoint<f64>, way: &Way, v_t: &f64) -> SetSpeed<f64> {
        let Some((centre, fastest)) = &way.rolling else {
            return SetSpeed(0.0);
        };
        let (sin, cos) = Calc::sin_cos(point.0);
        let along = plane::dot(centre.rolling(axis.point()), Point::new(cos, sin));
        let v_t = if way.against { -v_t } else { *v_t };
        SetSpeed(v_t * along / fastest)
    }
}
