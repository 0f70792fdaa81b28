//! How the groups are carried on: what the PLC decides at a sample, and what the solver is to keep.

use crate::component::moving::MovingComponent;
use crate::component::moving::bodies::{BodiesInMotion, SampledBodies, Schedule};
use crate::component::stages::{Found, Stages};
use crate::kernel::calc::Calc;
use crate::kernel::number::short;
use crate::kernel::variable::Fault;
use crate::parts::hydraulics::oil;
use crate::parts::solver::rodas::Tolerance;
use crate::parts::solver::{Halt, MOST_IMPLICIT};
use crate::steering::hydraulic::{Control, STATES, Sampled, WorkingGroup};
use crate::steering::moving::motion::GroupState;
use crate::steering::moving::scene::MovingGroups;
use crate::steering::scene::Steering;
use crate::steering::stages::{Given, Known, SteeredGroups};
use crate::steering::symbols as s;

/// Pressure of the chamber on the bore's side at the start, in Pa.
const RESTING_PRESSURE: f64 = 20e5;

/// Finest tolerance to which states are told from zero: 1e-8 rad, a pascal, a ten-millionth of the spool's stroke. Groups stand
/// still, spools turn round and chambers are empty again and again; told from zero as finely there as where they work,
/// they would take most of the solver's steps.
const FINEST: f64 = 1e-5;

fn moving(given: &Given<f64>) -> MovingGroups<f64> {
    given.moving.expect("in motion")
}

/// The control loop, with an encoder of a resolution (rad).
pub(super) fn control<P: Calc>(moving: &MovingGroups<P>, resolution: P) -> Control<P> {
    Control {
        period: moving.t_c,
        resolution,
        gains: [moving.k_p, moving.k_i],
        limit: moving.u_max,
    }
}

/// The steering in motion, at the start of its range; `None` where the scene has none.
pub fn in_motion(this: &Steering) -> Option<Result<MovingComponent, Fault>> {
    let mut turning = this.clone();
    let (own, groups) = (&mut turning.own, this.given.axes.len());
    own.given.moving = Some(own.moving?);
    own.given.moved = vec![GroupState::of(|_| Some(0.0))?; groups];
    own.given.held = vec![Sampled::of(|_| Some(0.0))?; groups];
    Some(MovingComponent::new(turning.standing(), |model| {
        Ok(Box::new(SampledBodies::<SteeredGroups, STATES>::new(model)?))
    }))
}

impl BodiesInMotion<STATES> for SteeredGroups {
    type Body = WorkingGroup;

    fn bodies(known: &mut Known<f64>) -> Found<&[WorkingGroup]> {
        known.working().map(Vec::as_slice)
    }

    fn schedule(given: &Given<f64>) -> Schedule<STATES> {
        let MovingGroups { step, tol, t_c, .. } = moving(given);
        // Angle and rate, pressures, spool and its speed.
        let absolute = [1e-3, 1e-3, 1e5, 1e5, 1e5, 1e5, 1e-2, 1.0];
        Schedule {
            period: t_c,
            longest: step,
            tolerance: Tolerance {
                relative: tol,
                absolute: absolute.map(|x| tol.max(FINEST) * x),
            },
        }
    }

    /// Bounded numbers, and oil in both chambers.
    fn is_possible(group: &WorkingGroup, y: &[f64; STATES]) -> bool {
        let volumes = group.cylinder.volumes(group.pose(y[0]).l);
        WorkingGroup::oil(y).is_possible(group.cylinder.bulk_modulus)
            && y[0].abs() < 1e3
            && volumes.iter().all(|v| *v > 0.0)
            && y.iter().all(|x| x.is_finite())
    }

    fn resting(known: &mut Known<f64>, body: usize) -> Found<[f64; STATES]> {
        let wanted = known.wants()?[body];
        Ok(known.working()?[body].resting(wanted, RESTING_PRESSURE))
    }

    /// The PLC reads all encoders and sets all valves.
    fn sample(known: &mut Known<f64>) -> Found<()> {
        let given = SteeredGroups::given(known);
        let resolution = given.accuracy.expect("checked when the scene was read").step;
        let control = control(&moving(given), resolution);
        for i in 0..SteeredGroups::given(known).held.len() {
            let wanted = known.wants()?[i];
            let Given {
                moved, mounts, held, ..
            } = SteeredGroups::given(known);
            let held = control.sample(&held[i], wanted, moved[i].theta, mounts[i].mirrored);
            known.held()[i] = held;
        }
        Ok(())
    }

    fn refusal(given: &Given<f64>, halt: Halt, body: usize, size: f64) -> Fault {
        let at = given.moved[body].theta;
        let angle = format!("theta[{}] = {}", body + 1, s::THETA.written(at));
        let size = short(size);
        Fault::outside(match halt {
            Halt::Outside => format!(
                "the motion from {angle} ends within {size} s beyond its cylinder or beyond all reasonable numbers: \
                 keep J above what the oil moves, and V_0 above what an end stop gives way"
            ),
            // Its solver is implicit, for which no step is too fast.
            Halt::TooSmall | Halt::TooMany | Halt::TooFast => format!(
                "the step of {size} s from {angle} needs more than the {MOST_IMPLICIT} inner steps that are allowed, \
                 at T_c = {} s: take smaller communication steps, a longer cycle or a coarser tolerance",
                short(moving(given).t_c)
            ),
        })
    }

    fn warning(least: f64) -> Option<&'static str> {
        oil::warning(least)
    }
}
