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
use crate::steering::machine::{Axis, Machine};
use crate::steering::nearest::Nearest;
use crate::steering::plan::{Crew, Plan};
use crate::steering::progress::Moment;
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
        headings: &[f64],
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
        let plan = if change.since() == f64::INFINITY {
            Plan::new(&crew, Some(to), headings, to, headings)
        } else {
            Plan::new(&crew, change.motion(), change.angles(), to, headings)
        };
        Planned { plan: plan.ok() }
    }

    /// Duration, in s; infinite where there is no way.
    fn time(&self) -> f64 {
        self.plan.as_ref().map_or(f64::INFINITY, |plan| plan.time)
    }
}

/// What is left of its duration, in s.
pub fn left(planned: &Planned, change: &Change, clock: &f64) -> f64 {
    match change.since() {
        f64::INFINITY => 0.0,
        since => (since + planned.time() - clock).max(0.0),
    }
}

/// Whether the groups may still be on their way.
#[derive(Clone, Copy, Debug)]
pub struct UnderWay(bool);

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
            (centre, centre.fastest(machine))
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

/// Set points of all groups' headings, in rad.
pub fn headings(
    machine: &Machine<f64>,
    linkages: &[Linkage<f64>],
    headings: &[f64],
    way: &Way,
    planned: Option<&Planned>,
    change: &Change,
    points: &mut Vec<f64>,
) {
    let point = |i: usize| match (way.course, planned.and_then(|planned| planned.plan.as_ref())) {
        (Some(Course::Moment(moment)), Some(plan)) => plan.angle(&moment, i, machine, &linkages[i]),
        (Some(Course::Stopped), _) => change.angles()[i],
        _ => headings[i],
    };
    points.clear();
    points.extend((0..headings.len()).map(point));
}

/// Rolling speed of a group at the set points, in m/s: the fastest group has the travel speed.
#[must_use]
pub fn speed(axis: &Axis<f64>, point: &f64, way: &Way, v_t: &f64) -> f64 {
    let Some((centre, fastest)) = &way.rolling else {
        return 0.0;
    };
    let (sin, cos) = Calc::sin_cos(*point);
    let along = plane::dot(centre.rolling(axis.point()), Point::new(cos, sin));
    let v_t = if way.against { -v_t } else { *v_t };
    v_t * along / fastest
}
