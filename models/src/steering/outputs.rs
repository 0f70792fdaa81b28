//! The results, each computed when it is asked for, over any scalar: `f64` in
//! a running model, dual numbers for its derivatives.

use nalgebra::Scalar;

use crate::calc::Calc;
use crate::model::{Fault, Quantity};
use crate::plane::{self, Point};
use crate::steering::cylinder::{Cylinder, Linkage, Pose};
use crate::steering::load::{Resistance, Tyre, resistance};
use crate::steering::machine::{Limits, Machine, Refusal};
use crate::steering::mode::{Centre, Command, Mode};
use crate::steering::ring::{Bearing, friction};
use crate::steering::sizing::{Piston, flow, force};
use crate::steering::slip::Accuracy;
use crate::steering::swept::Swept;
use crate::steering::symbols as s;
use crate::steering::transition::Pace;
use crate::steering::wheels::{Travel, Wheel, place, rate, roll};

/// A result; those of groups with the group's number from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    Theta(usize),
    V(usize),
    OmegaI(usize),
    R(usize),
    Od(usize),
    Tr(usize),
    Trx(usize),
    Tg(usize),
    Fg(usize),
    Fgx(usize),
    Vc(usize),
    Delta(usize),
    Qg(usize),
    QSum,
    Omega,
    VMx,
    VMy,
    Ox,
    Oy,
    AtInfinity,
    RO,
    RIn,
    ROut,
    Width,
    Margin,
    Reachable,
}

/// What commands the modes whose turning centre moves on a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    Angle,
    Radius,
    Centre,
}

/// What a simulator may change at any time.
#[derive(Clone, Debug)]
pub struct Inputs<C> {
    pub mode: Mode,
    pub by: By,
    /// Corner of the outline, from 0.
    pub corner: usize,
    /// Commanded angle, in rad, and its rate, in rad/s.
    pub theta_b: C,
    pub omega_s: C,
    /// Travel speed, in m/s.
    pub v_t: C,
    /// Commanded radius, in m.
    pub r_t: C,
    /// Commanded turning centre, in m.
    pub centre: Point<C>,
    /// Vertical load of each group, in N; none where no forces are modelled.
    pub loads: Vec<C>,
}

impl<C: Calc> Inputs<C> {
    /// The command of a mode.
    #[inline]
    pub fn command(&self) -> Command<C> {
        match (self.mode, self.by) {
            (Mode::Straight | Mode::Crosswise | Mode::Pivot, _) => Command::None,
            (Mode::Corner, _) => Command::Corner(self.corner),
            (Mode::Free, _) => Command::Centre(self.centre),
            (Mode::Crab, _) | (_, By::Angle) => Command::Angle(self.theta_b),
            (_, By::Radius) => Command::Radius(self.r_t),
            (_, By::Centre) => Command::Centre(self.centre),
        }
    }

    /// The same over another scalar.
    pub fn map<D: Scalar>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> Inputs<D> {
        Inputs {
            mode: self.mode,
            by: self.by,
            corner: self.corner,
            theta_b: f((&s::THETA_B, None), self.theta_b),
            omega_s: f((&s::OMEGA_S, None), self.omega_s),
            v_t: f((&s::V_T, None), self.v_t),
            r_t: f((&s::R_T, None), self.r_t),
            centre: Point::new(f((&s::O_CX, None), self.centre.x), f((&s::O_CY, None), self.centre.y)),
            loads: (1..).zip(&self.loads).map(|(i, g)| f((&s::G, Some(i)), *g)).collect(),
        }
    }
}

/// A steered group.
#[derive(Clone, Debug)]
pub struct Group<C> {
    /// Its axis, in m.
    pub at: Point<C>,
    /// Whether its cylinder shortens where the others lengthen.
    pub mirrored: bool,
    /// How far it turns, in rad; `None` as far as its cylinder turns it.
    pub range: Option<[f64; 2]>,
    /// Ranges through which it must not turn, in rad.
    pub forbidden: Vec<[f64; 2]>,
}

/// A machine as given; groups of quantities that are absent are not modelled.
#[derive(Clone, Debug)]
pub struct Parameters<C> {
    pub groups: Vec<Group<C>>,
    /// Front, rear, left and right of the machine, in m; `None` as far as the groups reach.
    pub outline: Option<[f64; 4]>,
    pub tyre: Option<Tyre<C>>,
    pub bearing: Option<Bearing<C>>,
    pub cylinder: Option<Cylinder<C>>,
    pub piston: Option<Piston<C>>,
    pub accuracy: Option<Accuracy<C>>,
    pub pace: Option<Pace<C>>,
}

impl<C: Calc> Parameters<C> {
    /// The same quantities over another scalar, in the order of the variables.
    pub fn map<D: Scalar>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> Parameters<D> {
        let mut at: Vec<D> = Vec::new();
        for (symbol, axis) in [(&s::X_I, 0), (&s::Y_I, 1)] {
            at.extend(
                (1..)
                    .zip(&self.groups)
                    .map(|(i, group)| f((symbol, Some(i)), group.at[axis])),
            );
        }
        let mut y = at.split_off(self.groups.len()).into_iter();
        let groups = self.groups.iter().zip(at).zip(&mut y).map(|((group, x), y)| Group {
            at: Point::new(x, y),
            mirrored: group.mirrored,
            range: group.range,
            forbidden: group.forbidden.clone(),
        });
        let groups = groups.collect();
        let mut alone = |symbol, x| f((symbol, None), x);
        Parameters {
            groups,
            outline: self.outline,
            tyre: self.tyre.map(|tyre| tyre.map(&mut alone)),
            bearing: self.bearing.map(|bearing| bearing.map(&mut alone)),
            cylinder: self.cylinder.map(|cylinder| cylinder.map(&mut alone)),
            piston: self.piston.map(|piston| piston.map(&mut alone)),
            accuracy: self.accuracy.map(|accuracy| accuracy.map(&mut alone)),
            pace: self.pace.map(|pace| pace.map(&mut alone)),
        }
    }

    /// The machine of these quantities.
    ///
    /// # Errors
    /// Quantities with which there is none.
    pub fn build(&self) -> Result<Built<C>, Refusal> {
        let at = self.groups.iter().map(|group| group.at).collect();
        let mut machine = Machine::new(at, Vec::new(), 0, 0)?;
        machine.rear_base = rear_base(&self.groups);
        let sides = self.outline.map(|sides| sides.map(C::constant));
        let [front, rear, left, right] = sides.unwrap_or([machine.front, machine.rear, machine.left, machine.right]);
        let corners = [(front, left), (rear, left), (rear, right), (front, right)];
        machine.corners = corners.map(|(x, y)| Point::new(x, y)).to_vec();
        if let Some(tyre) = &self.tyre {
            tyre.check()?;
        }
        if let Some(accuracy) = &self.accuracy {
            accuracy.check()?;
        }
        if let Some(pace) = &self.pace {
            pace.check()?;
        }
        let (mut limits, mut ends) = (Vec::new(), Vec::new());
        let mut linkages = Vec::new();
        if let Some(bearing) = &self.bearing {
            bearing.check()?;
        }
        if let Some(cylinder) = &self.cylinder {
            cylinder.check()?;
            linkages = self
                .groups
                .iter()
                .map(|group| cylinder.linkage(group.mirrored))
                .collect();
        }
        let plain = self.cylinder.map(|cylinder| cylinder.map(&mut |_, x| x.value()));
        for (number, group) in (1..).zip(&self.groups) {
            let whole = match (group.range, &plain) {
                (Some([min, max]), _) => Limits::new(min, max, Vec::new())?,
                (None, Some(cylinder)) => cylinder.range(group.mirrored),
                (None, None) => Limits::new(-std::f64::consts::PI, std::f64::consts::PI, Vec::new())?,
            };
            ends.push(match (group.range, &self.cylinder) {
                (None, Some(cylinder)) => cylinder.ends(group.mirrored),
                _ => [whole.min, whole.max].map(C::constant),
            });
            limits.push(whole.forbid(group.forbidden.clone()).map_err(|found| Refusal {
                key: format!("forbidden[{number}]"),
                what: format!("group {number}: {}", found.what),
                ..found
            })?);
        }
        Ok(Built {
            machine,
            limits,
            ends,
            linkages,
        })
    }
}

/// The group whose angle commands rear-axle steering: the rearmost one that is nearest in line with the first.
fn rear_base<C: Calc>(groups: &[Group<C>]) -> usize {
    let x = |i: usize| groups[i].at.x.value();
    let aside = |i: usize| (groups[i].at.y - groups[0].at.y).value().abs();
    let order = |a: &usize, b: &usize| x(*a).total_cmp(&x(*b)).then(aside(*a).total_cmp(&aside(*b)));
    (0..groups.len()).min_by(order).unwrap_or(0)
}

/// A machine with its ranges and cylinders; no linkages where no cylinder is modelled.
#[derive(Clone, Debug)]
pub struct Built<C> {
    pub machine: Machine<C>,
    pub limits: Vec<Limits>,
    /// The ends of each range again, in rad, with the derivatives of what they follow from.
    pub ends: Vec<[C; 2]>,
    pub linkages: Vec<Linkage<C>>,
}

/// How the groups stand and what they do at the current inputs.
#[derive(Clone, Copy, Debug)]
struct Stance<C> {
    centre: Centre<C>,
    /// How the centre moves with the commanded angle, once it was asked for.
    slope: Option<Centre<C>>,
    travel: Travel<C>,
    reachable: bool,
}

/// The machine with its inputs, and what has been computed of it so far.
#[derive(Clone, Debug)]
pub struct Evaluation<C> {
    parameters: Parameters<C>,
    inputs: Inputs<C>,
    built: Option<Built<C>>,
    stance: Option<Stance<C>>,
    /// Of the stance, where there is one.
    wheels: Vec<Wheel<C>>,
    poses: Vec<Pose<C>>,
    /// Angle that a group keeps while it stands on the turning centre: straight ahead.
    hold: Vec<C>,
}

impl<C: Calc> Evaluation<C> {
    #[must_use]
    pub fn new(parameters: Parameters<C>, inputs: Inputs<C>) -> Evaluation<C> {
        let (n, zero) = (parameters.groups.len(), C::constant(0.0));
        let turn = Point::new(zero, zero);
        Evaluation {
            parameters,
            inputs,
            built: None,
            stance: None,
            wheels: vec![
                Wheel {
                    theta: zero,
                    turn,
                    v: zero
                };
                n
            ],
            poses: vec![Pose { l: zero, od: zero }; n],
            hold: vec![zero; n],
        }
    }

    #[must_use]
    pub fn parameters(&self) -> &Parameters<C> {
        &self.parameters
    }

    #[must_use]
    pub fn inputs(&self) -> &Inputs<C> {
        &self.inputs
    }

    /// Changes parameters: everything has to be computed anew.
    pub fn set_parameters(&mut self, parameters: Parameters<C>) {
        self.parameters = parameters;
        self.built = None;
        self.stance = None;
    }

    /// Changes inputs on which the stance of the groups depends.
    #[inline]
    pub fn command(&mut self, change: impl FnOnce(&mut Inputs<C>)) {
        change(&mut self.inputs);
        self.stance = None;
    }

    /// Sets the steering speed, in rad/s: the stance stays.
    #[inline]
    pub fn set_omega_s(&mut self, omega_s: C) {
        self.inputs.omega_s = omega_s;
    }

    /// Sets the load of a group, in N: the stance stays.
    #[inline]
    pub fn set_load(&mut self, group: usize, g: C) {
        self.inputs.loads[group] = g;
    }

    /// Puts the groups where the current inputs want them.
    ///
    /// # Errors
    /// Parameters without a machine, or a command that its mode does not take.
    #[inline]
    pub fn update(&mut self) -> Result<(), Fault> {
        match self.stance {
            Some(_) => Ok(()),
            None => self.stand().map_err(|refusal| Fault::outside(refusal.to_string())),
        }
    }

    fn stand(&mut self) -> Result<(), Refusal> {
        let built = match &mut self.built {
            Some(built) => built,
            slot => slot.insert(self.parameters.build()?),
        };
        let (machine, inputs) = (&built.machine, &self.inputs);
        let centre = inputs.mode.centre(machine, inputs.command())?;
        let travel = roll(
            &machine.groups,
            machine.middle,
            &centre,
            inputs.v_t,
            &self.hold,
            &mut self.wheels,
        );
        let reachable = place(&built.limits, &mut self.wheels).is_ok();
        for ((pose, linkage), wheel) in self.poses.iter_mut().zip(&built.linkages).zip(&self.wheels) {
            *pose = linkage.at(wheel.turn);
        }
        self.stance = Some(Stance {
            centre,
            slope: None,
            travel,
            reachable,
        });
        Ok(())
    }

    /// A result in SI; a truth value is 0 or 1.
    ///
    /// # Errors
    /// As [`Evaluation::update`].
    #[inline]
    pub fn output(&mut self, output: Output) -> Result<C, Fault> {
        use Output as O;
        // These do not depend on how the groups stand.
        match output {
            O::Tr(i) => return Ok(self.resistance(i)?.standing),
            O::Trx(i) => return Ok(self.resistance(i)?.travelling),
            O::Tg(i) => return Ok(self.resistance(i)?.standing + self.friction(i)),
            _ => self.update()?,
        }
        match output {
            O::Theta(i) => Ok(self.wheels[i].theta),
            O::V(i) => Ok(self.wheels[i].v),
            O::R(i) => Ok(self.poses[i].l),
            O::Od(i) => Ok(self.poses[i].od),
            O::Fg(i) => Ok(force(self.resistance(i)?.standing + self.friction(i), self.poses[i].od)),
            O::Fgx(i) => Ok(force(
                self.resistance(i)?.travelling + self.friction(i),
                self.poses[i].od,
            )),
            O::OmegaI(i) => self.rate(i),
            O::Vc(i) => self.cylinder_speed(i),
            O::Delta(i) => {
                let accuracy = self.parameters.accuracy.as_ref().ok_or_else(absent)?;
                Ok(accuracy.angle_error(self.poses[i].od))
            }
            O::Qg(i) => self.flow(i),
            O::QSum => {
                let mut sum = C::constant(0.0);
                for i in 0..self.wheels.len() {
                    sum += self.flow(i)?.abs();
                }
                Ok(sum)
            }
            _ => self.of_machine(output),
        }
    }

    /// The machine, and the turning centre of the current inputs.
    ///
    /// # Errors
    /// As [`Evaluation::update`].
    pub fn stance(&mut self) -> Result<(&Built<C>, &Centre<C>), Fault> {
        self.update()?;
        match (&self.built, &self.stance) {
            (Some(built), Some(stance)) => Ok((built, &stance.centre)),
            _ => Err(absent()),
        }
    }

    /// A result of the machine as a whole.
    fn of_machine(&self, output: Output) -> Result<C, Fault> {
        use Output as O;
        let (Some(stance), Some(built)) = (&self.stance, &self.built) else {
            return Err(absent());
        };
        let swept = || Swept::new(&built.machine.corners, &stance.centre).ok_or_else(absent);
        Ok(match output {
            O::Omega => stance.travel.omega.unwrap_or(C::constant(0.0)),
            O::VMx => stance.travel.middle.x,
            O::VMy => stance.travel.middle.y,
            O::Ox => centre(built, stance).x,
            O::Oy => centre(built, stance).y,
            O::AtInfinity => C::constant(f64::from(stance.centre.point().is_none())),
            O::RO => match stance.centre.point() {
                Some(at) => plane::length(at - built.machine.middle),
                None => C::constant(f64::INFINITY),
            },
            O::RIn => swept()?.inner,
            O::ROut => swept()?.outer,
            O::Width => swept()?.width,
            O::Margin => {
                let ranges = built.limits.iter().zip(&built.ends);
                let left =
                    (self.wheels.iter().zip(ranges)).map(|(wheel, (limits, ends))| limits.margin(*ends, wheel.theta));
                let least = |a: C, b: C| if b.value() < a.value() { b } else { a };
                left.reduce(least).ok_or_else(absent)?
            }
            O::Reachable => C::constant(f64::from(stance.reachable)),
            _ => return Err(absent()),
        })
    }

    /// Rate of a group's angle, in rad/s; zero where no angle commands.
    fn rate(&mut self, i: usize) -> Result<C, Fault> {
        let (Some(stance), Some(built)) = (&mut self.stance, &self.built) else {
            return Err(absent());
        };
        let Command::Angle(theta) = self.inputs.command() else {
            return Ok(C::constant(0.0));
        };
        let slope = match stance.slope {
            Some(slope) => slope,
            None => self.inputs.mode.slope(&built.machine, theta).ok_or_else(absent)?,
        };
        stance.slope = Some(slope);
        Ok(rate(&stance.centre, &slope, built.machine.groups[i]) * self.inputs.omega_s)
    }

    fn cylinder_speed(&mut self, i: usize) -> Result<C, Fault> {
        Ok(self.rate(i)? * self.poses[i].od)
    }

    fn flow(&mut self, i: usize) -> Result<C, Fault> {
        let speed = self.cylinder_speed(i)?;
        self.parameters
            .piston
            .map(|piston| flow(&piston, speed))
            .ok_or_else(absent)
    }

    #[inline]
    fn resistance(&self, i: usize) -> Result<Resistance<C>, Fault> {
        let tyre = self.parameters.tyre.as_ref().ok_or_else(absent)?;
        Ok(resistance(tyre, self.inputs.loads[i]))
    }

    /// Friction moment of a group's slewing ring, in N·m; none where no ring is modelled.
    #[inline]
    fn friction(&self, i: usize) -> C {
        match &self.parameters.bearing {
            Some(bearing) => friction(bearing, self.inputs.loads[i]),
            None => C::constant(0.0),
        }
    }
}

/// The turning centre. At infinity it lies to the left of the way, on the line across the machine.
fn centre<C: Calc>(built: &Built<C>, stance: &Stance<C>) -> Point<C> {
    if let Some(at) = stance.centre.point() {
        return at;
    }
    let along = stance.centre.rolling(built.machine.middle);
    let far = |x: C| match x.value() {
        0.0 => C::constant(0.0),
        x => C::constant(f64::INFINITY.copysign(x)),
    };
    Point::new(far(-along.y), far(along.x))
}

/// For results that a scene does not model: its list of variables has none of them.
fn absent() -> Fault {
    Fault::new("this scene does not model the result")
}
