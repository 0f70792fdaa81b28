//! The mechanism as a running model: inputs and parameters in, outputs out,
//! only what is asked for computed.

use crate::lemniscate::drive::{Drive, oil_flow};
use crate::lemniscate::geometry::{Driven, Geometry, Misfit, Parameters};
use crate::lemniscate::position::Position;
use crate::lemniscate::range::Range;
use crate::lemniscate::scene::{KEYS, Luffing};
use crate::lemniscate::statics::{Centres, PinForces, load_moment, weight_moment};
use crate::lemniscate::symbols as s;
use crate::lemniscate::velocity::{Pole, Velocity};
use crate::model::{Fault, Role, Variable};
use crate::scene::Scene;
use crate::schema::{self, Key, Kind, Sign};
use crate::symbol::Symbol;

/// A scene's mechanism with its inputs, stepped by the FMU and by tables.
#[derive(Clone, Debug)]
pub struct Model {
    luffing: Luffing,
    variables: Vec<Variable>,
    slots: Vec<Slot>,
    /// Which numbers may be set, in the order of the variables.
    signs: Vec<Sign>,
    inputs: Inputs,
    geometry: Option<Geometry<f64>>,
    range: Option<Range>,
    place: Option<Place>,
    forces: Option<Forces>,
}

/// What a simulator may change while it runs.
#[derive(Clone, Copy, Debug)]
struct Inputs {
    /// Angle of the driven bar, in rad; `None` until it is set: then the model
    /// runs through its working range by itself.
    theta: Option<f64>,
    omega: f64,
    q: f64,
    time: f64,
}

/// Kinematics at the current inputs.
#[derive(Clone, Copy, Debug)]
struct Place {
    p: Position<f64>,
    v: Velocity<f64>,
    omega: f64,
}

/// Forces at the current inputs.
#[derive(Clone, Copy, Debug)]
struct Forces {
    q: f64,
    pins: PinForces<f64>,
    m_g: f64,
    f_d: f64,
}

#[derive(Clone, Copy, Debug)]
enum Slot {
    Theta,
    Omega,
    Load,
    Parameter,
    Place(fn(&Place) -> f64),
    Pole(fn(&Pole<f64>, &Place) -> f64),
    Drive(fn(&Drive<f64>, &Parameters<f64>, f64) -> f64),
    Forces(fn(&Place, &Forces) -> f64),
    PoleMoment,
    Range(fn(&Range) -> f64),
}

impl Model {
    /// # Errors
    /// Never for a scene that was read by [`Scene::parse`], which checks that
    /// the mechanism exists over its range.
    pub fn new(scene: &Scene) -> Result<Model, Fault> {
        let luffing = scene.luffing.clone();
        let inputs = Inputs {
            theta: None,
            omega: luffing.motion.speed,
            q: luffing.q.unwrap_or(0.0),
            time: 0.0,
        };
        let (variables, slots) = variables(&luffing);
        let signs = variables
            .iter()
            .map(|variable| allowed(KEYS, variable.symbol).unwrap_or(Sign::Any))
            .collect();
        let mut model = Model {
            luffing,
            variables,
            slots,
            signs,
            inputs,
            geometry: None,
            range: None,
            place: None,
            forces: None,
        };
        model.update()?;
        Ok(model)
    }

    /// What exists in this scene; an index into it names a variable.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// Duration of one run through the working range, in s.
    #[must_use]
    pub fn stop_time(&self) -> f64 {
        let motion = &self.luffing.motion;
        nanosecond((motion.to - motion.from) / motion.speed)
    }

    /// Time for one step of the scene's tables, in s.
    #[must_use]
    pub fn step_size(&self) -> f64 {
        nanosecond(self.luffing.motion.step / self.luffing.motion.speed)
    }

    /// Value of a variable in SI; truth values are 0 and 1.
    ///
    /// # Errors
    /// Where the value depends on a configuration that does not exist.
    #[inline]
    pub fn get(&mut self, index: usize) -> Result<f64, Fault> {
        let Some(&slot) = self.slots.get(index) else {
            return Err(Fault(format!(
                "there is no variable {index}; this model has {}",
                self.slots.len()
            )));
        };
        match slot {
            Slot::Theta => Ok(self.theta()),
            Slot::Omega => Ok(self.inputs.omega),
            Slot::Load => Ok(self.inputs.q),
            Slot::Parameter => Ok(self.parameter(self.variables[index].symbol)),
            Slot::Place(read) => self.place().map(read),
            Slot::Pole(read) => {
                let place = *self.place()?;
                Ok(read(&Pole::new(self.geometry()?, &place.p), &place))
            }
            Slot::Drive(read) => {
                let place = *self.place()?;
                let drive = self.drive(&place).expect("a drive's variables exist only with a drive");
                Ok(read(&drive, &self.luffing.parameters, place.omega))
            }
            Slot::Forces(read) => {
                let (place, forces) = self.forces()?;
                Ok(read(place, forces))
            }
            Slot::PoleMoment => {
                let place = *self.place()?;
                let q = self.inputs.q;
                let g = self.geometry()?;
                Ok(Pole::new(g, &place.p).moment(g, &place.p, &place.v, q))
            }
            Slot::Range(read) => self.range().map(read),
        }
    }

    /// Sets an input or a parameter, in SI.
    ///
    /// # Errors
    /// A value that is not finite or outside what the symbol allows, an output,
    /// an unknown index. A refused value changes nothing.
    pub fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        let Some(&Variable { symbol, .. }) = self.variables.get(index) else {
            return Err(Fault(format!(
                "there is no variable {index}; this model has {}",
                self.slots.len()
            )));
        };
        let sign = self.signs[index];
        if !sign.allows(value) {
            let (value, unit) = (symbol.shown(value), symbol.display.name);
            return Err(Fault(format!(
                "{} = {value} {unit} is not allowed: it must be {}",
                symbol.id,
                sign.words()
            )));
        }
        match self.slots[index] {
            Slot::Theta => self.inputs.theta = Some(value),
            Slot::Omega => self.inputs.omega = value,
            Slot::Load => {
                self.inputs.q = value;
                self.forces = None;
                return Ok(());
            }
            Slot::Parameter => {
                let change = |known: &'static Symbol, old| if known == symbol { value } else { old };
                self.luffing.parameters = self.luffing.parameters.map(change);
                self.geometry = None;
                self.range = None;
            }
            _ => return Err(Fault(format!("{} is a result and cannot be set", symbol.id))),
        }
        self.place = None;
        self.forces = None;
        Ok(())
    }

    /// Moves to a time in s. While the angle of the driven bar has not been
    /// set, it follows from the time: through the working range at the input's
    /// angular velocity, then at rest.
    #[inline]
    pub fn set_time(&mut self, time: f64) {
        if self.inputs.theta.is_none() && time != self.inputs.time {
            self.place = None;
            self.forces = None;
        }
        self.inputs.time = time;
    }

    /// Assembles the mechanism at the current inputs.
    ///
    /// # Errors
    /// A configuration that does not exist, with the angle and the allowed range.
    #[inline]
    pub fn update(&mut self) -> Result<(), Fault> {
        self.place().map(|_| ())
    }

    /// All inputs and parameters, in the order of the variables, preceded by
    /// the time and by whether the angle was set: enough for [`restore`](Model::restore).
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        let given = if self.inputs.theta.is_some() { 1.0 } else { 0.0 };
        let values = self
            .slots
            .iter()
            .zip(&self.variables)
            .filter_map(|(slot, variable)| match slot {
                Slot::Theta => Some(self.theta()),
                Slot::Omega => Some(self.inputs.omega),
                Slot::Load => Some(self.inputs.q),
                Slot::Parameter => Some(self.parameter(variable.symbol)),
                _ => None,
            });
        [self.inputs.time, given].into_iter().chain(values)
    }

    /// Takes back what [`values`](Model::values) gave.
    ///
    /// # Errors
    /// Values that this model would refuse; then nothing is changed.
    pub fn restore(&mut self, values: &[f64]) -> Result<(), Fault> {
        let settable = |slot: &Slot| matches!(slot, Slot::Theta | Slot::Omega | Slot::Load | Slot::Parameter);
        let indices: Vec<usize> = (0..self.slots.len())
            .filter(|&index| settable(&self.slots[index]))
            .collect();
        let [time, given, values @ ..] = values else {
            return Err(Fault("a saved state is empty".to_owned()));
        };
        if values.len() != indices.len() || !time.is_finite() {
            return Err(Fault("a saved state does not belong to this model".to_owned()));
        }
        let mut model = self.clone();
        for (&index, &value) in indices.iter().zip(values) {
            model.set(index, value)?;
        }
        if *given == 0.0 {
            model.inputs.theta = None;
        }
        model.inputs.time = *time;
        *self = model;
        Ok(())
    }

    fn theta(&self) -> f64 {
        let motion = &self.luffing.motion;
        let sweep = || (motion.from + self.inputs.omega * self.inputs.time).clamp(motion.from, motion.to);
        self.inputs.theta.unwrap_or_else(sweep)
    }

    fn parameter(&self, symbol: &'static Symbol) -> f64 {
        let mut found = f64::NAN;
        self.luffing.parameters.map(|known, value| {
            if known == symbol {
                found = value;
            }
        });
        found
    }

    fn geometry(&mut self) -> Result<&Geometry<f64>, Fault> {
        if self.geometry.is_none() {
            let geometry = Geometry::new(&self.luffing.parameters).map_err(|misfit| {
                Fault(match misfit {
                    Misfit::Jib => "the jib's triangle does not close with these lengths".to_owned(),
                    Misfit::Linkage => "the linkage closes at no angle of the driven bar with these lengths".to_owned(),
                })
            })?;
            self.geometry = Some(geometry);
        }
        Ok(self.geometry.as_ref().expect("just made"))
    }

    fn range(&mut self) -> Result<&Range, Fault> {
        if self.range.is_none() {
            let motion = self.luffing.motion;
            let range = Range::new(self.geometry()?, &motion);
            self.range = Some(range.ok_or_else(|| {
                Fault("the linkage does not close over the whole working range with these lengths".to_owned())
            })?);
        }
        Ok(self.range.as_ref().expect("just made"))
    }

    #[inline]
    fn place(&mut self) -> Result<&Place, Fault> {
        if self.place.is_none() {
            let (theta, omega) = (self.theta(), self.inputs.omega);
            let g = self.geometry()?;
            let Some(p) = Position::new(g, theta) else {
                return Err(unreachable_angle(g, theta));
            };
            let v = Velocity::new(&p);
            self.place = Some(Place { p, v, omega });
        }
        Ok(self.place.as_ref().expect("just made"))
    }

    fn drive(&self, place: &Place) -> Option<Drive<f64>> {
        let parameters = &self.luffing.parameters;
        let l = &parameters.lengths;
        let bar = match parameters.driven {
            Driven::Boom => l.x_1,
            Driven::Rocker => l.x_3,
        };
        parameters
            .anchors
            .as_ref()
            .map(|anchors| Drive::new(&place.p, bar, l.o3(), anchors))
    }

    fn forces(&mut self) -> Result<(&Place, &Forces), Fault> {
        if self.forces.is_none() {
            let place = *self.place()?;
            let parameters = &self.luffing.parameters;
            let (q, lengths) = (self.inputs.q, parameters.lengths);
            let weights = parameters.weights.as_ref();
            let centres = weights.map(|w| Centres::new(&place.p, [lengths.x_1, lengths.x_2, lengths.x_3], w));
            let both = weights.zip(centres.as_ref());
            let m_g = both.map_or(0.0, |(w, r)| weight_moment(w, r, &place.p, &place.v));
            let drive = self.drive(&place);
            let mut f_d = 0.0;
            let pins = PinForces::new(&place.p, lengths.x_3, q, both, |m_d| {
                let reaction = drive.and_then(|drive| drive.reaction(m_d));
                // A drive that points at the foot would need an infinite force.
                f_d = reaction.map_or_else(|| if m_d == 0.0 { 0.0 } else { f64::INFINITY.copysign(m_d) }, |r| r.f_d);
                reaction
            });
            self.forces = Some(Forces { q, pins, m_g, f_d });
        }
        self.place()?;
        Ok((
            self.place.as_ref().expect("just made"),
            self.forces.as_ref().expect("just made"),
        ))
    }
}

/// A time without the rounding of angles: 60 s, not 59.999999999999993 s.
fn nanosecond(time: f64) -> f64 {
    let rounded = (time * 1e9).round() / 1e9;
    if rounded > 0.0 { rounded } else { time }
}

fn unreachable_angle(g: &Geometry<f64>, theta: f64) -> Fault {
    let symbol = match g.driven {
        Driven::Boom => &s::THETA_1,
        Driven::Rocker => &s::THETA_3,
    };
    let turn = std::f64::consts::TAU;
    let degrees = |angle: f64| format!("{} deg", schema::short(angle.to_degrees()));
    let (mut allowed, mut nearest) = (Vec::new(), (f64::INFINITY, theta));
    for arc in g.linkage.arcs() {
        allowed.push(format!("{} to {}", degrees(arc.from), degrees(arc.to)));
        for end in [arc.from, arc.to] {
            let away = (theta - end) - turn * ((theta - end) / turn).round();
            if away.abs() < nearest.0 {
                nearest = (away.abs(), theta - away);
            }
        }
    }
    Fault(format!(
        "{} = {}: the linkage does not close there; it closes for {}; the nearest angle is {}",
        symbol.id,
        degrees(theta),
        allowed.join(" and for "),
        degrees(nearest.1)
    ))
}

/// Which numbers the scene's keys allow for a quantity.
fn allowed(keys: &'static [Key], symbol: &'static Symbol) -> Option<Sign> {
    keys.iter().find_map(|key| match key.kind {
        Kind::Quantity(known, sign) if known == symbol && key.name == symbol.id => Some(sign),
        Kind::Table(keys) => allowed(keys, symbol),
        _ => None,
    })
}

/// A point's coordinate at infinity, with its sign and never NaN.
fn far(direction: f64) -> f64 {
    if direction == 0.0 {
        0.0
    } else {
        f64::INFINITY.copysign(direction)
    }
}

/// Variables of a scene: only what it models.
fn variables(luffing: &Luffing) -> (Vec<Variable>, Vec<Slot>) {
    let mut list: Vec<(&'static Symbol, Role, Slot)> = Vec::new();
    let boom = luffing.parameters.driven == Driven::Boom;
    let (theta, omega) = if boom {
        (&s::THETA_1, &s::OMEGA_1)
    } else {
        (&s::THETA_3, &s::OMEGA_3)
    };
    list.push((theta, Role::Input, Slot::Theta));
    list.push((omega, Role::Input, Slot::Omega));
    if luffing.q.is_some() {
        list.push((&s::Q, Role::Input, Slot::Load));
    }
    luffing
        .parameters
        .map(|symbol, _| list.push((symbol, Role::Parameter, Slot::Parameter)));

    let mut output = |symbol, slot| list.push((symbol, Role::Output, slot));
    let (follower, ratio) = if boom {
        (&s::THETA_3, &s::I_3)
    } else {
        (&s::THETA_1, &s::I_1)
    };
    output(follower, Slot::Place(|x| x.p.follower_angle()));
    output(&s::ALPHA, Slot::Place(|x| x.p.alpha()));
    output(&s::ALPHA_1, Slot::Place(|x| x.p.alpha_1(x.p.alpha())));
    output(&s::R, Slot::Place(|x| x.p.r));
    output(&s::A_X, Slot::Place(|x| x.p.a.x));
    output(&s::A_Y, Slot::Place(|x| x.p.a.y));
    output(&s::B_X, Slot::Place(|x| x.p.b.x));
    output(&s::B_Y, Slot::Place(|x| x.p.b.y));
    output(&s::C_X, Slot::Place(|x| x.p.c.x));
    output(&s::C_Y, Slot::Place(|x| x.p.c.y));
    output(&s::L, Slot::Place(|x| x.p.l()));
    output(&s::Y, Slot::Place(|x| x.p.y()));
    output(&s::MU, Slot::Place(|x| x.p.mu()));
    output(&s::I_2, Slot::Place(|x| x.v.i_2));
    output(ratio, Slot::Place(|x| x.v.i_follower));
    output(&s::V_AX, Slot::Place(|x| x.v.v_a(x.omega).x));
    output(&s::V_AY, Slot::Place(|x| x.v.v_a(x.omega).y));
    output(&s::BETA, Slot::Place(|x| x.v.beta()));
    output(
        &s::O1P,
        Slot::Pole(|pole, _| pole.finite().map_or(f64::INFINITY, |(o1p, _)| o1p)),
    );
    output(
        &s::P_X,
        Slot::Pole(|pole, x| pole.finite().map_or_else(|| far(x.p.x_1.x), |(_, at)| at.x)),
    );
    output(
        &s::P_Y,
        Slot::Pole(|pole, x| pole.finite().map_or_else(|| far(x.p.x_1.y), |(_, at)| at.y)),
    );
    output(&s::P_FAR, Slot::Pole(|pole, _| f64::from(pole.finite().is_none())));
    if luffing.parameters.anchors.is_some() {
        output(&s::L_D, Slot::Drive(|d, _, _| d.l_d));
        output(&s::H_D, Slot::Drive(|d, _, _| d.h_d));
        output(&s::V_D, Slot::Drive(|d, _, omega| d.speed(omega)));
        if luffing.parameters.cylinder.is_some() {
            output(
                &s::Q_D,
                Slot::Drive(|d, p, omega| p.cylinder.map_or(0.0, |c| oil_flow(&c, d.speed(omega)))),
            );
        }
    }
    if luffing.q.is_some() {
        output(&s::M_Q, Slot::Forces(|x, f| load_moment(&x.v, f.q)));
        output(&s::M_Q_P, Slot::PoleMoment);
        if luffing.parameters.weights.is_some() {
            output(&s::M_G, Slot::Forces(|_, f| f.m_g));
        }
        output(&s::M_D, Slot::Forces(|_, f| f.pins.m_d));
        output(&s::F_BX, Slot::Forces(|_, f| f.pins.b.x));
        output(&s::F_BY, Slot::Forces(|_, f| f.pins.b.y));
        output(&s::F_CX, Slot::Forces(|_, f| f.pins.c.x));
        output(&s::F_CY, Slot::Forces(|_, f| f.pins.c.y));
        output(&s::F_O1X, Slot::Forces(|_, f| f.pins.o1.x));
        output(&s::F_O1Y, Slot::Forces(|_, f| f.pins.o1.y));
        output(&s::F_O3X, Slot::Forces(|_, f| f.pins.o3.x));
        output(&s::F_O3Y, Slot::Forces(|_, f| f.pins.o3.y));
        output(&s::N_3, Slot::Forces(|_, f| f.pins.n_3));
        if luffing.parameters.anchors.is_some() {
            output(&s::F_D, Slot::Forces(|_, f| f.f_d));
        }
    }
    list.push((&s::DELTA_Y, Role::Calculated, Slot::Range(Range::delta_y)));
    list.push((&s::EPSILON_Y, Role::Calculated, Slot::Range(Range::epsilon_y)));
    list.push((&s::R_MAX, Role::Calculated, Slot::Range(|r| r.r_max.value)));
    list.push((&s::R_MIN, Role::Calculated, Slot::Range(|r| r.r_min.value)));
    list.push((&s::MU_MIN, Role::Calculated, Slot::Range(|r| r.mu_min.value)));

    let boolean = |symbol: &'static Symbol| symbol == &s::P_FAR;
    list.into_iter()
        .map(|(symbol, role, slot)| {
            (
                Variable {
                    symbol,
                    role,
                    boolean: boolean(symbol),
                },
                slot,
            )
        })
        .unzip()
}
