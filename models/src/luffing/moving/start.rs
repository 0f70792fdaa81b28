//! Where a crane in motion begins: at rest, held by its drive or its oil, the load hanging.

use std::marker::PhantomData;

use nalgebra::Vector3;

use crate::component::moving::sampled::with_samples;
use crate::component::moving::{Carrier, MovingComponent};
use crate::component::part::Runner;
use crate::component::standing::Standing;
use crate::kernel::group::One;
use crate::kernel::variable::Fault;
use crate::luffing::moving::blown::directions;
use crate::luffing::moving::carried::{CarriedCrane, at, known, put, regulators};
use crate::luffing::moving::control::AXES;
use crate::luffing::moving::control::continuous::Laws;
use crate::luffing::moving::control::reading::Controllers;
use crate::luffing::moving::crane::DRUM;
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::given::{CraneStates, Fitted, MOST_STATES, STATES, Slack, SlewedParts, order};
use crate::luffing::moving::hoisting::HoistKind;
use crate::luffing::moving::hydraulic::{FIXED, Modes};

use crate::luffing::moving::level::{CraneAt, Level, first};
use crate::luffing::moving::luffs::{Luffs, MotionSources};
use crate::luffing::moving::motion::{self, MotionState};
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::space::{self, SlewingState};
use crate::luffing::moving::symbols as m;
use crate::parts::hanging::to_load;
use crate::parts::hoist::Drum;
use crate::parts::motion::Motion;
use crate::parts::solver::Count;

/// Least pressure of the chambers at the start, in Pa.
const LEAST_PRESSURE: f64 = 20e5;

/// Where the states of slewing and load begin.
fn own(oil: bool) -> usize {
    if oil { FIXED } else { 2 }
}

impl CraneAt {
    /// The hoist runs at a rate of paying out (m/s), and a load on a rope that gives way moves as fast along it: of a crane
    /// with oil, that slews, whose rope gives way.
    pub(super) fn wind(&mut self, rate: f64, [oil, slews, gives]: [bool; 3]) {
        let (first, own) = (own(oil), if slews { space::STATES } else { motion::STATES });
        self.y[first + own - 3] = rate;
        self.past.drum = Drum::at(rate);
        let gives = gives && !self.past.grounded;
        if gives && slews {
            let place = Vector3::new(self.y[first + 2], self.y[first + 3], self.y[first + 4]);
            let along = to_load(place).1 * rate;
            self.y[first + 5..first + 8].copy_from_slice(along.as_slice());
        } else if gives {
            self.y[first + 4] = rate;
        }
    }

    /// How far below the head the load is, in m.
    fn hangs(&self, [oil, slews]: [bool; 2]) -> f64 {
        let first = own(oil);
        let along = if slews { 1.0 } else { directions(self.y[first]).0.y };
        -self.y[first + 3] * along
    }

    /// The load stands on ground that is below the head by a height (m), in the rope's direction.
    pub(super) fn stand(&mut self, below: f64, fittings: [bool; 2]) {
        let [oil, slews] = fittings;
        let (first, nearer) = (own(oil), below / self.hangs(fittings));
        let place = if slews { 2..5 } else { 3..4 };
        for y in &mut self.y[first..][place] {
            *y *= nearer;
        }
        self.past.grounded = true;
    }

    /// The rope is as long as its stretch (m) asks for where the load is.
    pub(super) fn pull(&mut self, stretch: f64, [oil, slews]: [bool; 2]) {
        let first = own(oil);
        let y = &self.y[first..];
        let (length, distance) = if slews {
            (8, Vector3::new(y[2], y[3], y[4]).norm())
        } else {
            (2, y[3])
        };
        self.y[first + length] = distance - stretch;
        self.past.taut = true;
    }

    /// The rope of its drive is taut.
    pub(super) fn wind_up(&mut self, fitted: &Fitted) {
        self.past.unwound = None;
        if fitted.hauled {
            // Behind angle and rate, the last two.
            let drum = order(fitted).len();
            self.y[drum..drum + DRUM].fill(0.0);
        }
    }

    /// The load hangs by the stretch (m) of a rope that carries it at rest.
    fn stretch(&mut self, stretch: f64, [oil, slews]: [bool; 2]) {
        let (first, y) = (own(oil), &mut self.y);
        if slews {
            // As much of its weight as lies along the rope.
            let length = y[first + 8];
            let along = -y[first + 3] / length;
            for y in &mut y[first + 2..first + 5] {
                *y *= 1.0 + stretch * along / length;
            }
        } else {
            y[first + 3] += stretch * directions(y[first]).1.x;
        }
    }
}

/// The crane at rest at an angle (rad), the load hanging as the scene says.
fn resting(moving: &Moving, theta: f64) -> [f64; MOST_STATES] {
    let (length, swing) = moving.rope.map_or([0.0; 2], |rope| [rope.length, rope.swing]).into();
    let mut y = [0.0; MOST_STATES];
    let mut own = |part: &[f64]| match moving.oil {
        Some(_) => {
            y[..2].copy_from_slice(&part[..2]);
            y[FIXED..][..part.len() - 2].copy_from_slice(&part[2..]);
        }
        None => y[..part.len()].copy_from_slice(part),
    };
    match moving.slewing {
        None => {
            let mut start = MotionState::resting(theta, length);
            start.y[2] = swing;
            own(&start.y);
        }
        Some(turn) => {
            let mut start = SlewingState::resting(theta, length);
            start.put_load([swing, turn.side]);
            start.y[2..4].copy_from_slice(&turn.joint.start);
            own(&start.y);
        }
    }
    y
}

/// Of a cylinder with its valve closed, the oil carrying the crane, which else stands and hangs as without oil.
fn held_by_oil(level: &Level, at: &mut CraneAt) -> Option<()> {
    let oil = match level {
        Level::Free(_) | Level::Slewing(_) | Level::Hauled(_) | Level::HauledSlewing(_) => return Some(()),
        Level::Fixed(system) => system.carrying(first(&at.y), LEAST_PRESSURE)?,
        Level::Hanging(system) => system.carrying(&at.y, LEAST_PRESSURE)?,
    };
    at.y[2..6].copy_from_slice(&oil);
    Some(())
}

/// How high the head is above ground (m) where the motion begins at an angle (rad).
fn above(level: &Level, theta: f64, ground: f64) -> Result<f64, Fault> {
    let head = f64::reduced(level.dynamics(), theta).map_or(ground, |r| r.head[0].y);
    if head > ground {
        return Ok(head - ground);
    }
    Err(Fault::outside(format!(
        "the ground at {} = {} is not below the head, which is at {} where the motion begins: give less",
        m::Y_G.id,
        m::Y_G.written(ground),
        m::Y_G.written(head)
    ))
    .about(&m::Y_G))
}

/// Continuous controllers of a crane at rest but for its speeds of luffing, slewing and hoist; `None` where it has none.
fn laws(moving: &Moving, speeds: [f64; AXES.len()]) -> Option<Laws> {
    let continuous = moving.controllers.filter(|all| !all.are_sampled())?;
    Some(Laws::steady(&continuous.control, speeds))
}

/// What the scene gives of its motion, at rest.
fn sources(moving: &Moving) -> MotionSources {
    let Moving {
        rope,
        oil,
        oil_parts,
        slewing,
        area,
        ..
    } = *moving;
    let speeds = [0.0, slewing.map_or(0.0, |turn| turn.joint.start[1]), 0.0];
    let sampled = moving.controllers.filter(Controllers::are_sampled);
    let laws = laws(moving, speeds);
    let kind = rope.map_or(HoistKind::AtOnce, |rope| rope.hoist);
    MotionSources {
        states: Some(CraneStates([0.0; STATES.len()])),
        inputs: Some(moving.inputs),
        constants: Some(moving.constants),
        ramp: match kind {
            HoistKind::Ramp(ramp) => Some(ramp),
            _ => None,
        },
        motor: match kind {
            HoistKind::Motor(motor, _) => Some(motor),
            _ => None,
        },
        hoist_falls: match kind {
            HoistKind::Motor(_, falls) => falls,
            _ => None,
        },
        give: rope.and_then(|rope| rope.give),
        around: rope.and_then(|rope| rope.air),
        ground: rope.and_then(|rope| rope.ground),
        slewed: slewing.map(|turn| SlewedParts {
            turning: turn.joint.turning,
            area,
            slope: turn.slope,
        }),
        oil,
        oil_parts,
        control: moving.controllers.map(|it| it.control),
        commanded: moving.controllers.map(|it| it.commanded),
        latched: sampled.map(|it| it.at_start(speeds)),
        regulating: laws.map(|laws| laws.states),
        regime: laws.map(|laws| laws.past),
        wound: moving.winds_at_once().then_some(One(&m::V_H, 0.0)),
        past: Some(Modes::AT_REST),
        slack: Some(Slack(None)),
        fitted: Fitted {
            rope: rope.map(|rope| rope.length),
            slewing: slewing.map(|turn| turn.joint.stops),
            oil: oil.is_some(),
            braked: moving.braked,
            hauled: moving.is_hauled(),
            meets: moving.meets,
        },
    }
}

/// The mechanism in motion, at rest at an angle of the driven bar, in rad.
///
/// # Errors
/// The cylinder cannot hold the crane there. A scene that was read has a mechanism.
pub fn starting<T: Luffs>(
    given: &T::Given<f64>,
    motion: Motion,
    moving: &Moving,
    theta: f64,
) -> Result<MovingComponent, Fault> {
    let Moving { rope, oil, slewing, .. } = *moving;
    let given = T::with(given, [theta, 0.0], sources(moving));
    let weight = T::luffing(&given).load.map_or(0.0, |load| load.1);
    let part = Runner::<T, f64>::new(given);
    MovingComponent::new(Standing::new(Box::new(part), motion, None)?, |model| {
        let mut now = at::<T>(model);
        now.y = resting(moving, theta);
        let (level, _) = T::in_motion(known::<T>(model)).map_err(|fault| *fault)?;
        held_by_oil(level, &mut now).ok_or_else(|| {
            let what = "the cylinder has no lever arm at the start of the working range: it cannot hold the crane";
            Fault::outside(what)
        })?;
        let (oil, slews) = (oil.is_some(), slewing.is_some());
        if let Some(give) = rope.and_then(|rope| rope.give) {
            now.stretch(weight / give.c_r, [oil, slews]);
        }
        if let Some(ground) = rope.and_then(|rope| rope.ground) {
            let below = above(level, theta, ground.y_g)?;
            if now.hangs([oil, slews]) >= below {
                now.stand(below, [oil, slews]);
            }
        }
        if let Some(rope) = rope {
            let rate = if moving.winds_at_once() {
                moving.inputs.hoist.speed
            } else {
                0.0
            };
            now.wind(rate, [oil, slews, rope.give.is_some()]);
        }
        let (level, _) = T::in_motion(known::<T>(model)).map_err(|fault| *fault)?;
        let mut own = CarriedCrane::<T> {
            ahead: level.ahead(&now.y),
            count: Count::default(),
            braked: moving.braked,
            begun: regulators::<T>(model).map(|all| all.laws),
            of: PhantomData,
        };
        put::<T>(model, &now);
        own.hold(model)?;
        own.update(model)?;
        Ok(with_samples(own, model))
    })
}
