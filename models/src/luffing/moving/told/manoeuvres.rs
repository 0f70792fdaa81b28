//! The manoeuvres of a crane in motion: which there are, and what its inputs are told in each.
//!
//! A drive follows a speed over time. At every sample its moment is the one that gives the acceleration to that speed by
//! the next sample: by the model's own equations, which are linear in it, so that weights, friction and the swinging load
//! are met whatever there is of them; it gives no more than the scene's. A valve opens in proportion to the cylinder's
//! speed, with what corrects its length. What is told is kept: commands over time, which any run of the model may follow.

use std::marker::PhantomData;

use nalgebra::Vector3;

use crate::component::description::Description;
use crate::component::moving::MovingComponent;
use crate::component::running::Running;
use crate::component::standing::Standing;
use crate::drive::symbols as d;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Fault, Role};
use crate::luffing::moving::given::CylinderOil;
use crate::luffing::moving::hoisting::HoistKind;
use crate::luffing::moving::luffs::Luffs;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::told::motor::{JointMotor, braking, place};
use crate::luffing::moving::told::shown::{Drawn, Shown, ShownBar};
use crate::luffing::moving::told::travel::Travel;
use crate::parts::hanging::HangingLoad;
use crate::parts::hydraulics::cylinder::Cylinder;
use crate::parts::joint::JointDrive;

/// Part of the working range that luffing keeps away from each of its end stops.
const MARGIN: f64 = 0.02;

/// Correction of the cylinder's length by the valve, in 1/s.
const CORRECTION: f64 = 1.0;

/// Part of the rope's length that a hoist with a motor, to which a scene gives no speed, would lift in the ramp's time.
const LIFTED: f64 = 0.25;

/// A manoeuvre before it is run.
pub(super) struct Planned {
    pub id: &'static str,
    /// Of the driven bar at the start, in rad.
    pub start: f64,
    /// In s.
    pub duration: f64,
    luffing: Travel,
    /// When the drive of luffing lets go and its brake falls on, or the valve shuts; in s.
    emergency: f64,
    slews: bool,
    hoists: bool,
}

/// Ids of the sentences that say how commands are chosen.
pub(super) fn rules(moving: &Moving) -> Vec<&'static str> {
    let oil = moving.oil.is_some();
    let motors = !oil || moving.slewing.is_some() || moving.has_motor();
    let rules = [
        (true, "manoeuvres"),
        (oil, "valve"),
        (motors, "drive"),
        (motors, "brake"),
        (moving.braked, "shaft_brakes"),
        (moving.has_motor(), "lift_motor"),
    ];
    rules.into_iter().filter(|(said, _)| *said).map(|(_, id)| id).collect()
}

/// Those that the crane's parts allow.
pub(super) fn planned<T: Shown>(luffing: &Description<T>, moving: &Moving) -> Vec<Planned> {
    let (range, ramp) = (&luffing.motion, moving.ramp);
    let margin = MARGIN * (range.to - range.from);
    let [low, high] = [range.from + margin, range.to - margin];
    let mut standing = luffing.standing();
    let index = standing
        .variables()
        .iter()
        .position(|variable| variable.symbol == T::REACH);
    let mut reach = |at: f64| standing.set(0, at).and_then(|()| standing.get(index.unwrap_or(0)));
    let [near, far] = match (reach(low), reach(high)) {
        (Ok(one), Ok(other)) if one > other => [high, low],
        _ => [low, high],
    };
    let way = |from: f64, to: f64| Travel::new([from, to], range.speed, ramp);
    let still = |at: f64| way(at, at);
    let of = |id, luffing: Travel, duration: f64| Planned {
        id,
        start: luffing.from,
        duration,
        luffing,
        emergency: f64::INFINITY,
        slews: false,
        hoists: false,
    };
    let swings = ramp;
    let [inward, outward] = [way(far, near), way(near, far)];
    let mut all = vec![
        of("luff_in", inward, inward.duration() + swings),
        of("luff_out", outward, outward.duration() + swings),
    ];
    if moving.slewing.is_some() && moving.strongest.drives[1].moment != 0.0 {
        all.push(Planned {
            slews: true,
            ..of("slew_and_stop", still(far), 3.0 * ramp + 2.0 * swings)
        });
    }
    if let Some([_, time]) = lifting(moving) {
        // As long as it takes to come up to the speed it takes to stop.
        all.push(Planned {
            hoists: true,
            ..of("hoist_and_stop", still(far), 2.0 * time + swings)
        });
    }
    if moving.oil.is_some() || moving.braked || braking(moving.strongest.drives[0]) > 0.0 {
        let luffing = way(f64::midpoint(low, high), far);
        let emergency = (2.0 * ramp).min(0.5 * luffing.duration());
        all.push(Planned {
            emergency,
            ..of("emergency_stop", luffing, emergency + 2.0 * swings)
        });
    }
    all
}

/// How a hoist lifts: at a speed (m/s), from the command to the one that stops it (s).
fn lifting(moving: &Moving) -> Option<[f64; 2]> {
    let (rope, speed) = (moving.rope?, moving.strongest.hoist.speed.abs());
    match rope.hoist {
        HoistKind::Motor(..) => Some([LIFTED * rope.length / moving.ramp, 2.0 * moving.ramp]),
        _ if speed == 0.0 => None,
        HoistKind::Ramp(ramp) => Some([speed, speed / ramp.a_h + moving.ramp]),
        HoistKind::AtOnce => Some([speed, moving.ramp]),
    }
}

/// The scene's crane at rest, its load hanging straight down, nothing commanded.
pub(super) fn at_rest(moving: &Moving) -> Moving {
    let mut rest = *moving;
    rest.controllers = None;
    rest.inputs.drives = [JointDrive::NONE; 2];
    (rest.inputs.hoist.speed, rest.inputs.hoist.drive, rest.inputs.valve) = (0.0, JointDrive::NONE, 0.0);
    rest.inputs.braking = 0.0;
    if let Some(rope) = &mut rest.rope {
        // Straight down is aslant where the ground is.
        rope.swing = rest.inputs.weather.slope;
    }
    if let Some(slewing) = &mut rest.slewing {
        (slewing.joint.start[1], slewing.side) = (0.0, 0.0);
        if let (Some(rope), Some(slope)) = (&mut rest.rope, slewing.slope) {
            let plumb = HangingLoad {
                place: slope.gravity(1.0, slewing.joint.start[0]),
                rate: Vector3::zeros(),
            };
            [rope.swing, slewing.side] = plumb.angles();
        }
    }
    rest
}

/// What tells a model's inputs what to do, sample after sample.
pub(super) struct Pilot<'a, T> {
    planned: &'a Planned,
    ramp: f64,
    luffing: Drive<T>,
    /// Input of the brakes on the motor's shaft, where there are any.
    shaft: Option<usize>,
    slewing: Option<JointMotor>,
    /// Rate of slewing that was reached, in rad/s.
    reached: f64,
    hoist: Option<Lift>,
    /// Each input with when (s) it was told what.
    pub told: Vec<(usize, Vec<[f64; 2]>)>,
}

enum Drive<T> {
    Motor(JointMotor),
    Valve(Box<LengthValve<T>>),
}

/// What the hoist is told.
#[derive(Clone, Copy)]
enum Lift {
    /// The input, and what it is told (m/s) for how long (s): it comes up to that by itself.
    Told(usize, [f64; 2]),
    /// Led to a speed (m/s), from which it is led back at a time (s).
    Motor(JointMotor, [f64; 2]),
}

impl Lift {
    fn new(moving: &Moving, model: &MovingComponent, lifts: bool) -> Option<Lift> {
        let lifting = lifting(moving).filter(|_| lifts);
        match moving.rope?.hoist {
            HoistKind::Motor(..) => {
                let drum = [
                    &m::M_M_H,
                    &m::M_B_H,
                    &m::V_R,
                    &m::D_V_R,
                    &m::Z_DRUM_REST,
                    &m::Z_DRUM_LOOSE,
                ];
                let motor = JointMotor::new(model, drum, moving.strongest.hoist.drive, -1.0)?;
                Some(Lift::Motor(motor, lifting.unwrap_or_default()))
            }
            HoistKind::Ramp(_) | HoistKind::AtOnce => Some(Lift::Told(place(model, &m::V_H)?, lifting?)),
        }
    }
}

/// The valve of a luffing cylinder.
struct LengthValve<T> {
    input: usize,
    length: usize,
    /// The crane where it should be, and its cylinder's length and speed there.
    shadow: Standing,
    planned: [usize; 2],
    /// Speed of the cylinder with the valve fully open, in m/s.
    open: f64,
    of: PhantomData<T>,
}

impl<T: Shown> LengthValve<T> {
    fn new(
        luffing: &Description<T>,
        moving: &Moving,
        oil: &CylinderOil<f64>,
        model: &MovingComponent,
    ) -> Option<LengthValve<T>> {
        let bore = T::bore(luffing)?;
        let [area, _] = Cylinder::areas(bore.d_c, bore.d_r);
        let shadow = luffing.standing();
        Some(LengthValve {
            input: place(model, &m::U_V)?,
            length: place(model, &d::L_D)?,
            planned: [place(&shadow, &d::L_D)?, place(&shadow, &d::V_D)?],
            shadow,
            open: oil.q_n / area * (0.5 * moving.strongest.supply / oil.dp_n).sqrt(),
            of: PhantomData,
        })
    }

    fn command(&mut self, model: &mut MovingComponent, [angle, rate]: [f64; 2]) -> Result<f64, Fault> {
        self.shadow.set(0, angle)?;
        self.shadow.set(1, rate)?;
        let [length, speed] = [self.shadow.get(self.planned[0])?, self.shadow.get(self.planned[1])?];
        let opening = (speed + CORRECTION * (length - model.get(self.length)?)) / self.open;
        Ok(opening.clamp(-1.0, 1.0))
    }
}

impl<'a, T: Shown> Pilot<'a, T> {
    pub(super) fn new(
        planned: &'a Planned,
        luffing: &Description<T>,
        moving: &Moving,
        model: &MovingComponent,
    ) -> Option<Pilot<'a, T>> {
        let [drive, turning] = moving.strongest.drives;
        let ShownBar {
            speed, acceleration, ..
        } = bar::<T>(model);
        let motor = [&m::M_A, &m::M_S, speed.1, acceleration, &m::Z_REST, &m::Z_LOOSE];
        let slewing = [
            &m::M_SL,
            &m::M_B_SL,
            &m::OMEGA_SL,
            &m::D_OMEGA_SL,
            &m::Z_SL_REST,
            &m::Z_SL_LOOSE,
        ];
        Some(Pilot {
            planned,
            ramp: moving.ramp,
            luffing: match &moving.oil {
                Some(oil) => Drive::Valve(Box::new(LengthValve::new(luffing, moving, oil, model)?)),
                None => {
                    let motor = JointMotor::new(model, motor, drive, 1.0)?;
                    let least = if T::Component::PULLED { 0.0 } else { motor.least };
                    Drive::Motor(JointMotor { least, ..motor })
                }
            },
            shaft: place(model, &m::U_BR).filter(|_| moving.braked),
            slewing: JointMotor::new(model, slewing, turning, 1.0),
            reached: 0.0,
            hoist: Lift::new(moving, model, planned.hoists),
            told: Vec::new(),
        })
    }

    /// Whether brakes on the motor's shaft are called at a time (s).
    pub(super) fn calls(&self, time: f64) -> bool {
        self.shaft.is_some() && time >= self.planned.emergency
    }

    /// In s.
    pub(super) fn duration(&self) -> f64 {
        self.planned.duration
    }

    /// What the inputs are from a time on, until another one; both in s.
    pub(super) fn tell(&mut self, model: &mut MovingComponent, [from, to]: [f64; 2]) -> Result<(), Fault> {
        let stopped = from >= self.planned.emergency;
        let target = self.planned.luffing;
        match &mut self.luffing {
            Drive::Motor(motor) => {
                let told = match stopped {
                    true if self.shaft.is_some() => [0.0; 2],
                    true => [0.0, motor.braking],
                    false => motor.follow(model, [from, to].map(|time| target.at(time)[1]), to - from)?,
                };
                let inputs = motor.inputs;
                self.set_both(model, inputs, from, told)?;
                if let Some(shaft) = self.shaft {
                    self.set(model, shaft, from, if stopped { 1.0 } else { 0.0 })?;
                }
            }
            Drive::Valve(valve) => {
                let opening = match stopped {
                    true => 0.0,
                    false => valve.command(model, target.at(f64::midpoint(from, to)))?,
                };
                let input = valve.input;
                self.set(model, input, from, opening)?;
            }
        }
        if let Some(motor) = self.slewing {
            let told = if self.planned.slews && from < self.ramp {
                self.reached = model.get(motor.rate)?;
                [motor.way * motor.most, 0.0]
            } else {
                let left = |time: f64| {
                    if self.planned.slews {
                        (3.0 - time / self.ramp).clamp(0.0, 1.0)
                    } else {
                        0.0
                    }
                };
                motor.follow(model, [from, to].map(|time| self.reached * left(time)), to - from)?
            };
            self.set_both(model, motor.inputs, from, told)?;
        }
        // A positive rate lowers.
        let ramp = self.ramp;
        let led =
            |[speed, time]: [f64; 2], at: f64| -speed * (at / ramp).min((time + ramp - at) / ramp).clamp(0.0, 1.0);
        match self.hoist {
            None => {}
            Some(Lift::Told(input, [speed, time])) => {
                self.set(model, input, from, if from < time { -speed } else { 0.0 })?;
                // A speed that jumps gives its blow before powers are looked at.
                model.event()?;
            }
            Some(Lift::Motor(motor, lifting)) => {
                let told = motor.follow(model, [from, to].map(|time| led(lifting, time)), to - from)?;
                self.set_both(model, motor.inputs, from, told)?;
            }
        }
        Ok(())
    }

    fn set_both(
        &mut self,
        model: &mut MovingComponent,
        inputs: [usize; 2],
        from: f64,
        values: [f64; 2],
    ) -> Result<(), Fault> {
        let [drive, brake] = inputs;
        self.set(model, drive, from, values[0])?;
        self.set(model, brake, from, values[1])
    }

    fn set(&mut self, model: &mut MovingComponent, input: usize, from: f64, value: f64) -> Result<(), Fault> {
        let place = self
            .told
            .iter()
            .position(|(known, _)| *known == input)
            .unwrap_or_else(|| {
                self.told.push((input, Vec::new()));
                self.told.len() - 1
            });
        let told = &mut self.told[place].1;
        match told.last_mut() {
            Some([time, last]) if *time == from => *last = value,
            Some([_, last]) if *last == value => {}
            _ => told.push([from, value]),
        }
        model.set(input, value)
    }
}

/// The bar that the model drives: its angle is the first of the variables.
fn bar<T: Shown>(model: &MovingComponent) -> &'static ShownBar {
    let angle = model.variables()[0].symbol;
    let bar = T::BARS.iter().find(|bar| bar.angle.1 == angle);
    bar.expect("one of those that scenes may drive")
}

/// What is drawn of a manoeuvre: ids of curves, and where their quantities stand among the variables. What the scene does
/// not have is left out.
pub(super) fn drawn<T: Shown>(planned: &Planned, model: &MovingComponent) -> Vec<(&'static str, usize)> {
    let ShownBar { angle, speed, .. } = bar::<T>(model);
    let rope = ("motion_rope", &m::S_R);
    let wanted: [Drawn; 4] = if planned.slews {
        [
            ("motion_slewing", &m::PSI_SL),
            ("motion_slewing_speed", &m::OMEGA_SL),
            ("motion_slewing_moment", &m::M_SL),
            ("motion_side", &m::CHI_R),
        ]
    } else if planned.hoists {
        [("motion_length", &m::L_R), ("motion_hoist", &m::V_R), rope, T::BODY]
    } else {
        let last = if place(model, &m::S_R).is_some() { rope } else { T::BODY };
        let drive = if place(model, &m::P_A).is_some() {
            ("motion_bore", &m::P_A)
        } else {
            T::DRIVE
        };
        [*angle, *speed, drive, last]
    };
    let there = |(id, symbol): Drawn| Some((id, place(model, symbol)?));
    wanted.into_iter().filter_map(there).collect()
}

/// Where the forces that other parts are designed for, and what the rope does, stand among the variables.
pub(super) fn designed(forces: &[&'static Symbol], model: &MovingComponent) -> Vec<(&'static Symbol, usize)> {
    let own = [
        &d::S_LM,
        &m::S_R,
        &m::PHI_R,
        &m::CHI_R,
        &m::P_A,
        &m::P_B,
        &m::M_R_SL,
        &m::M_R_H,
    ];
    let there = |symbol: &'static Symbol| {
        let variables = model.variables().iter();
        let known = |role: Role| matches!(role, Role::Output | Role::State | Role::Calculated);
        let mut places = variables
            .enumerate()
            .filter(|(_, v)| v.symbol == symbol && known(v.role));
        places.next().map(|(index, _)| (symbol, index))
    };
    forces.iter().copied().chain(own).filter_map(there).collect()
}
