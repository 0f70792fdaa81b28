//! The results, each computed when it is asked for, over any scalar: `f64` in
//! a running model, dual numbers for its derivatives, the recorder for what
//! depends on what.

use crate::balance::{Action, Turn};
use crate::calc::Calc;
use crate::lemniscate::balancing::{Balanced, Balancing, Criteria, analysis, residual};
use crate::lemniscate::drive::{Drive, oil_flow};
use crate::lemniscate::geometry::{Driven, Geometry, Parameters};
use crate::lemniscate::governing::coordinate;
use crate::lemniscate::position::Position;
use crate::lemniscate::range::Range;
use crate::lemniscate::scene::Motion;
use crate::lemniscate::statics::{Centres, PinForces, drive_moment, load_moment, weight_moment};
use crate::lemniscate::symbols as s;
use crate::lemniscate::velocity::{Pole, Velocity};
use crate::model::Fault;
use crate::motion::degrees;
use crate::number::exact;

/// A result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    FollowerAngle,
    Alpha,
    Alpha1,
    R,
    AX,
    AY,
    BX,
    BY,
    CX,
    CY,
    L,
    Y,
    Mu,
    I2,
    IFollower,
    VAX,
    VAY,
    Beta,
    O1P,
    PX,
    PY,
    PAtInfinity,
    LD,
    HD,
    VD,
    QD,
    MQ,
    MQP,
    MG,
    MD,
    FBX,
    FBY,
    FCX,
    FCY,
    FO1X,
    FO1Y,
    FO3X,
    FO3Y,
    N3,
    FD,
    M0,
    MUr,
    DM,
    DM5,
    MSum,
    Psi,
    I5,
    Gamma,
    N1,
    Y5,
    FKX,
    FKY,
    FMX,
    FMY,
    MD0,
    FD0,
    DMMax,
    DM5Max,
    EAbs,
    EPlus,
    GammaMin,
    NMax,
    Travel,
    DeltaY,
    EpsilonY,
    RMax,
    RMin,
    MuMin,
}

/// What a simulator may change at any time.
#[derive(Clone, Copy, Debug)]
pub struct Inputs<C> {
    /// Angle of the driven bar, in rad.
    pub theta: C,
    /// Its angular velocity, in rad/s.
    pub omega: C,
    /// Weight of the load, in N.
    pub q: C,
}

/// The mechanism with its inputs, and what has been computed of it so far.
#[derive(Clone, Copy, Debug)]
pub struct Evaluation<C> {
    parameters: Parameters<C>,
    motion: Motion,
    inputs: Inputs<C>,
    geometry: Option<Geometry<C>>,
    range: Option<Range>,
    place: Option<Place<C>>,
    balancing: Option<Option<Balancing<C>>>,
    criteria: Option<Criteria<C>>,
    forces: Option<Forces<C>>,
    /// As old as the forces; `None` without a balance.
    balanced: Option<Balanced<C>>,
}

/// Kinematics at the current inputs.
#[derive(Clone, Copy, Debug)]
struct Place<C> {
    p: Position<C>,
    v: Velocity<C>,
}

/// Forces at the current inputs.
#[derive(Clone, Copy, Debug)]
struct Forces<C> {
    /// `None` where bars lie in one line, and where they do so somewhere in the working range.
    pins: Option<PinForces<C>>,
    m_g: C,
    m_d: C,
    f_d: C,
}

impl<C: Calc> Evaluation<C> {
    #[must_use]
    pub fn new(parameters: Parameters<C>, motion: Motion, inputs: Inputs<C>) -> Evaluation<C> {
        Evaluation {
            parameters,
            motion,
            inputs,
            geometry: None,
            range: None,
            place: None,
            balancing: None,
            criteria: None,
            forces: None,
            balanced: None,
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

    /// Whether the linkage passes change points on its branch, as far as it was assembled.
    #[must_use]
    pub fn keeps_branch(&self) -> bool {
        self.geometry.as_ref().is_some_and(|g| g.linkage.keeps_branch())
    }

    /// Changes parameters: everything has to be computed anew.
    pub fn set_parameters(&mut self, parameters: Parameters<C>) {
        *self = Evaluation::new(parameters, self.motion, self.inputs);
    }

    /// Sets the angle of the driven bar, in rad.
    #[inline]
    pub fn set_theta(&mut self, theta: C) {
        self.inputs.theta = theta;
        self.place = None;
        self.forces = None;
    }

    /// Sets the angular velocity of the driven bar, in rad/s: positions and forces stay.
    #[inline]
    pub fn set_omega(&mut self, omega: C) {
        self.inputs.omega = omega;
    }

    /// Sets the weight of the load, in N.
    #[inline]
    pub fn set_q(&mut self, q: C) {
        self.inputs.q = q;
        self.forces = None;
    }

    /// Assembles the mechanism at the current inputs.
    ///
    /// # Errors
    /// Parameters with which there is no mechanism, or an angle at which it does not close.
    #[inline]
    pub fn update(&mut self) -> Result<(), Fault> {
        self.place().map(|_| ())
    }

    /// A result in SI; a truth value is 0 or 1.
    ///
    /// # Errors
    /// As [`Evaluation::update`], and for results of the range where the linkage
    /// does not close over all of it.
    pub fn output(&mut self, output: Output) -> Result<C, Fault> {
        use Output as O;
        Ok(match output {
            O::FollowerAngle => self.place()?.p.follower_angle(),
            O::Alpha => self.place()?.p.alpha(),
            O::Alpha1 => {
                let p = &self.place()?.p;
                p.alpha_1(p.alpha())
            }
            O::R => self.place()?.p.r,
            O::AX => self.place()?.p.a.x,
            O::AY => self.place()?.p.a.y,
            O::BX => self.place()?.p.b.x,
            O::BY => self.place()?.p.b.y,
            O::CX => self.place()?.p.c.x,
            O::CY => self.place()?.p.c.y,
            O::L => self.place()?.p.l(),
            O::Y => self.place()?.p.y(),
            O::Mu => self.place()?.p.mu(),
            O::I2 => self.place()?.v.i_2,
            O::IFollower => self.place()?.v.i_follower,
            O::VAX => self.velocity()?.0,
            O::VAY => self.velocity()?.1,
            O::Beta => self.place()?.v.beta(),
            O::O1P | O::PX | O::PY | O::PAtInfinity => self.pole(output)?,
            O::LD => self.drive()?.l_d,
            O::HD => self.drive()?.h_d,
            O::VD => self.drive()?.speed(self.inputs.omega),
            O::QD => {
                let speed = self.drive()?.speed(self.inputs.omega);
                match &self.parameters.cylinder {
                    Some(cylinder) => oil_flow(cylinder, speed),
                    None => return Err(absent()),
                }
            }
            O::MQ => {
                let q = self.inputs.q;
                load_moment(&self.place()?.v, q)
            }
            O::MQP => {
                let (place, q) = (*self.place()?, self.inputs.q);
                let g = self.geometry()?;
                Pole::new(g, &place.p, place.v.i_2).moment(g, &place.p, &place.v, q)
            }
            O::MG => self.forces()?.m_g,
            O::MD => self.forces()?.m_d,
            O::FBX => self.pins()?.b.x,
            O::FBY => self.pins()?.b.y,
            O::FCX => self.pins()?.c.x,
            O::FCY => self.pins()?.c.y,
            O::FO1X => self.pins()?.o1.x,
            O::FO1Y => self.pins()?.o1.y,
            O::FO3X => self.pins()?.o3.x,
            O::FO3Y => self.pins()?.o3.y,
            O::N3 => self.pins()?.n_3,
            O::FD => self.forces()?.f_d,
            O::M0 => self.balanced()?.residual.boom.m_0,
            O::MUr => self.action()?.m_b,
            O::DM => self.balanced()?.residual.dm,
            O::DM5 => self.balanced()?.residual.dm_5.ok_or_else(unbalanced)?,
            O::MSum => self.balanced()?.m_sum,
            O::Psi => self.turn()?.psi,
            O::I5 => self.turn()?.i_5,
            O::Gamma => self.turn()?.gamma,
            O::N1 => self.action()?.n_1.ok_or_else(unbalanced)?,
            O::Y5 => self.action()?.y_5.ok_or_else(unbalanced)?,
            O::FKX => self.action()?.on_boom.x,
            O::FKY => self.action()?.on_boom.y,
            O::FMX => self.action()?.on_pivot.ok_or_else(unbalanced)?.x,
            O::FMY => self.action()?.on_pivot.ok_or_else(unbalanced)?.y,
            O::MD0 => self.balanced()?.without.0,
            O::FD0 => self.balanced()?.without.1.ok_or_else(absent)?,
            O::DMMax => self.criteria()?.dm_max,
            O::DM5Max => self.criteria()?.dm_5_max.ok_or_else(unbalanced)?,
            O::EAbs => self.criteria()?.e_abs,
            O::EPlus => self.criteria()?.e_plus,
            O::GammaMin => self.criteria()?.gamma_min.ok_or_else(unbalanced)?,
            O::NMax => self.criteria()?.n_max.ok_or_else(unbalanced)?,
            O::Travel => self.criteria()?.travel.ok_or_else(unbalanced)?,
            O::DeltaY | O::EpsilonY | O::RMax | O::RMin | O::MuMin => self.of_range(output)?,
        })
    }

    fn balanced(&mut self) -> Result<&Balanced<C>, Fault> {
        self.forces()?;
        self.balanced.as_ref().ok_or_else(unbalanced)
    }

    fn action(&mut self) -> Result<&Action<C>, Fault> {
        Ok(&self.balanced()?.residual.action)
    }

    fn turn(&mut self) -> Result<&Turn<C>, Fault> {
        self.action()?.lever.as_ref().ok_or_else(unbalanced)
    }

    fn balancing(&mut self) -> Result<Option<Balancing<C>>, Fault> {
        if self.balancing.is_none() {
            self.balancing = Some(Balancing::new(&self.parameters, &self.motion)?);
        }
        Ok(self.balancing.expect("just made"))
    }

    fn criteria(&mut self) -> Result<&Criteria<C>, Fault> {
        if self.criteria.is_none() {
            let parameters = self.parameters.values();
            let balancing = self.balancing()?.ok_or_else(unbalanced)?;
            let weights = self.parameters.weights.ok_or_else(unbalanced)?;
            let motion = self.motion;
            let g = self.geometry()?;
            let found = analysis(&parameters, &motion)?.ok_or_else(unbalanced)?;
            let criteria = Criteria::new(&found, &motion, &|theta| residual(&balancing, g, &weights, theta))?;
            self.criteria = Some(criteria);
        }
        Ok(self.criteria.as_ref().expect("just made"))
    }

    fn velocity(&mut self) -> Result<(C, C), Fault> {
        let omega = self.inputs.omega;
        let v = self.place()?.v.v_a(omega);
        Ok((v.x, v.y))
    }

    /// Where the instantaneous centre lies. At infinity it is on the line of the boom.
    fn pole(&mut self, output: Output) -> Result<C, Fault> {
        let Place { p, v } = *self.place()?;
        let pole = Pole::new(self.geometry()?, &p, v.i_2).finite();
        let far = |direction: C| match direction.value() {
            0.0 => C::constant(0.0),
            value => C::constant(f64::INFINITY.copysign(value)),
        };
        Ok(match (output, pole) {
            (Output::O1P, Some((o1p, _))) => o1p,
            (Output::O1P, None) => C::constant(f64::INFINITY),
            (Output::PX, Some((_, at))) => at.x,
            (Output::PX, None) => far(p.x_1.x),
            (Output::PY, Some((_, at))) => at.y,
            (Output::PY, None) => far(p.x_1.y),
            (_, pole) => C::constant(f64::from(pole.is_none())),
        })
    }

    /// A result of the whole working range: found with `f64`, and then computed
    /// at the place where it occurs, so that its derivative is exact too (at an
    /// extreme, the place's own change has no effect).
    fn of_range(&mut self, output: Output) -> Result<C, Fault> {
        let (range, motion) = (*self.range()?, self.motion);
        let g = self.geometry()?;
        let at = |at: f64| Position::new(g, C::constant(at)).ok_or_else(|| not_over_the_range(g, &motion));
        let reach = |x: f64| at(x).map(|p| p.r);
        let level = || Ok(at(range.y_max.at)?.a.y - at(range.y_min.at)?.a.y);
        match output {
            Output::DeltaY => level(),
            Output::EpsilonY => Ok(level()? / (reach(range.r_max.at)? - reach(range.r_min.at)?)),
            Output::RMax => reach(range.r_max.at),
            Output::RMin => reach(range.r_min.at),
            _ => at(range.mu_min.at).map(|p| p.mu()),
        }
    }

    fn geometry(&mut self) -> Result<&Geometry<C>, Fault> {
        if self.geometry.is_none() {
            self.geometry = Some(Geometry::new(&self.parameters).map_err(|misfit| {
                let words = self.parameters.values().describe(misfit);
                Fault::outside(format!("{}: {}", words.what, words.help))
            })?);
        }
        Ok(self.geometry.as_ref().expect("just made"))
    }

    fn range(&mut self) -> Result<&Range, Fault> {
        if self.range.is_none() {
            let motion = self.motion;
            let parameters = self.parameters.values();
            self.geometry()?;
            let found = Range::new(&parameters, &motion);
            self.range = Some(match found {
                Some(range) => range,
                None => return Err(not_over_the_range(self.geometry()?, &motion)),
            });
        }
        Ok(self.range.as_ref().expect("just made"))
    }

    #[inline]
    fn place(&mut self) -> Result<&Place<C>, Fault> {
        if self.place.is_none() {
            self.assemble()?;
        }
        Ok(self.place.as_ref().expect("just made"))
    }

    fn assemble(&mut self) -> Result<(), Fault> {
        let theta = self.inputs.theta;
        let g = self.geometry()?;
        let Some(p) = Position::new(g, theta) else {
            return Err(unreachable_angle(g, theta.value()));
        };
        let v = Velocity::new(&p);
        self.place = Some(Place { p, v });
        Ok(())
    }

    fn drive(&mut self) -> Result<Drive<C>, Fault> {
        let p = self.place()?.p;
        drive(&self.parameters, &p).ok_or_else(absent)
    }

    #[inline]
    fn forces(&mut self) -> Result<&Forces<C>, Fault> {
        if self.forces.is_none() {
            self.load()?;
        }
        Ok(self.forces.as_ref().expect("just made"))
    }

    fn pins(&mut self) -> Result<&PinForces<C>, Fault> {
        let theta = self.inputs.theta.value();
        let driven = self.parameters.driven;
        let pins = self.forces()?.pins.as_ref();
        pins.ok_or_else(|| in_one_line(driven, theta))
    }

    fn load(&mut self) -> Result<(), Fault> {
        self.place()?;
        if self.parameters.balance.is_some() {
            self.balancing()?;
        }
        let motion = self.motion;
        let passes = self.geometry()?.change_point(&motion).is_some();
        let parameters = &self.parameters;
        let Place { p, v } = self.place.as_ref().expect("just made");
        let (q, theta, lengths) = (self.inputs.q, self.inputs.theta, parameters.lengths);
        let weights = parameters.weights.as_ref();
        let centres = weights.map(|w| Centres::new(p, [lengths.x_1, lengths.x_2, lengths.x_3], w));
        let both = weights.zip(centres.as_ref());
        let m_g = both.map_or(C::constant(0.0), |(w, r)| weight_moment(w, r, p, v));
        let drive = drive(parameters, p);
        self.balanced = match (&self.balancing, &self.geometry, both) {
            (Some(Some(balancing)), Some(geometry), Some(both)) => {
                let residual = balancing.at(geometry, both, (p, v), theta, m_g)?;
                let balanced = Balanced::new(residual, v, p.driven, load_moment(v, q), m_g);
                Some(drive.as_ref().map_or(balanced, |drive| balanced.driven_by(drive)))
            }
            _ => None,
        };
        let action = self.balanced.as_ref().map(|balanced| &balanced.residual.action);
        let mut f_d = C::constant(0.0);
        if passes || p.is_in_line() {
            let turn = match p.driven {
                Driven::Boom => C::constant(1.0),
                Driven::Rocker => v.i_follower,
            };
            let left = action.map_or(m_g, |action| m_g - action.m_b * turn);
            let m_d = drive_moment(load_moment(v, q), left);
            if let Some(drive) = drive {
                f_d = drive.force(m_d, &s::F_D);
            }
            let pins = None;
            self.forces = Some(Forces { pins, m_g, m_d, f_d });
            return Ok(());
        }
        let pins = PinForces::new(p, lengths.x_3, q, both, action, |m_d| {
            let reaction = drive?.reaction(m_d);
            f_d = reaction.f_d;
            reaction.force
        });
        self.forces = Some(Forces {
            m_g,
            m_d: pins.m_d,
            f_d,
            pins: Some(pins),
        });
        Ok(())
    }
}

impl Evaluation<f64> {
    /// The same over another scalar. Where only inputs change with the scalar,
    /// constants of the geometry need not be found again.
    pub fn over<C: Calc>(&self, parameters: Parameters<C>, inputs: Inputs<C>, same_geometry: bool) -> Evaluation<C> {
        let geometry = self.geometry.filter(|_| same_geometry);
        Evaluation {
            geometry: geometry.map(|g| g.map(C::constant)),
            range: self.range,
            ..Evaluation::new(parameters, self.motion, inputs)
        }
    }
}

fn drive<C: Calc>(parameters: &Parameters<C>, p: &Position<C>) -> Option<Drive<C>> {
    let l = &parameters.lengths;
    let bar = match parameters.driven {
        Driven::Boom => l.x_1,
        Driven::Rocker => l.x_3,
    };
    let anchors = parameters.anchors.as_ref()?;
    Some(Drive::new(p, bar, l.o3(), anchors))
}

fn unbalanced() -> Fault {
    Fault::new("the balance of this scene has no such result")
}

fn absent() -> Fault {
    Fault::new("this scene has no drive")
}

/// The angles at which the linkage closes, in words.
fn closes<C: Calc>(g: &Geometry<C>) -> String {
    let arcs = g.linkage.arcs();
    let words: Vec<String> = arcs
        .iter()
        .map(|arc| format!("{} to {}", degrees(arc.from), degrees(arc.to)))
        .collect();
    words.join(" and for ")
}

fn in_one_line(driven: Driven, theta: f64) -> Fault {
    Fault::outside(format!(
        "{} = {}: bars lie in one line there, and no finite forces in the pins carry load and weights",
        coordinate(driven).id,
        degrees(theta)
    ))
}

fn unreachable_angle<C: Calc>(g: &Geometry<C>, theta: f64) -> Fault {
    let symbol = coordinate(g.driven);
    let turn = std::f64::consts::TAU;
    // The nearest end, rounded to a side where the linkage closes.
    const DIGITS: f64 = 1e6;
    let mut nearest = (f64::INFINITY, theta);
    for arc in g.linkage.arcs() {
        for end in [arc.from, arc.to] {
            let inward = if end == arc.from { f64::ceil } else { f64::floor };
            let away = (theta - end) - turn * ((theta - end) / turn).round();
            if away.abs() < nearest.0 {
                let degrees = (theta - away).to_degrees();
                nearest = (away.abs(), inward(degrees * DIGITS) / DIGITS);
            }
        }
    }
    Fault::outside(format!(
        "{} = {}: the linkage does not close there; it closes for {}; the nearest angle is {}",
        symbol.id,
        degrees(theta),
        closes(g),
        format_args!("{} deg", exact(nearest.1))
    ))
}

fn not_over_the_range<C: Calc>(g: &Geometry<C>, motion: &Motion) -> Fault {
    Fault::outside(format!(
        "the linkage does not close over the whole working range, {} to {}, with these lengths; it closes for {}",
        degrees(motion.from),
        degrees(motion.to),
        closes(g)
    ))
}
