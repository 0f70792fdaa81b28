//! A mechanism that moves, with what hangs on it and what it stands on; over which scalars it does.

use std::cell::Cell;
use std::f64::consts::TAU;
use std::sync::Arc;

use num_dual::Dual64;

use crate::kernel::calc::{Calc, Over};
use crate::kernel::record::Rec;
use crate::luffing::moving::bodies::{Asked, Pendulum, Turntable};
use crate::luffing::moving::geared::Geared;
use crate::luffing::moving::reduced::{CoordinateNames, Reduced, Reduces};
use crate::luffing::moving::symbols as s;
use crate::luffing::moving::weather::{Exposes, Outdoors, Weather};
use crate::parts::air::AirDrag;
use crate::parts::side_wind::SlewedArea;
use crate::parts::slope::SlopingGround;
use crate::parts::solver::Gradient;

/// What the mechanism was at the angle (rad) that was asked for last: rates, events, powers and forces of one instant
/// all ask.
#[derive(Clone, Default)]
struct Latest(Cell<Option<(f64, Reduced<f64>)>>);

impl Latest {
    #[inline]
    fn at(&self, theta: f64, find: impl FnOnce() -> Option<Reduced<f64>>) -> Option<Reduced<f64>> {
        match self.0.get() {
            Some((at, found)) if at.to_bits() == theta.to_bits() => Some(found),
            _ => {
                let found = find()?;
                self.0.set(Some((theta, found)));
                Some(found)
            }
        }
    }
}

/// A mechanism that moves, with what hangs on it and what it stands on.
#[derive(Clone)]
pub struct Dynamics<P = f64> {
    mechanism: Arc<dyn Reduces<P>>,
    asked: Asked<P>,
    /// The motor that turns with it.
    geared: Option<Arc<Geared<P>>>,
    pendulum: Option<Pendulum<P>>,
    /// In m/s².
    gravity: P,
    /// What the air does to any load over its mass.
    air: Option<AirDrag<P>>,
    /// Of what slews, with the density of its air.
    area: Option<SlewedArea<P>>,
    /// Under a crane that slews.
    slope: Option<SlopingGround<P>>,
    /// Speed (m/s) and direction (rad) of the wind.
    blows: [P; 2],
    /// Height of the ground, in m.
    ground: Option<P>,
    /// Wind on the mechanism's bodies, and the slope.
    outdoors: Option<Outdoors<P>>,
    /// Speed at which it is slewed, in 1/s and in rad/s, where it is so whatever that takes.
    slewed: Option<[P; 2]>,
    latest: Latest,
}

/// A scalar that the equations of motion run on, with parameters known as `P`: a number, one with its
/// derivatives by all states, or one with its derivative in one direction of states and parameters.
pub trait Coordinate<P = f64>: Over<P> {
    /// `None` where the linkage does not close.
    fn reduced(d: &Dynamics<P>, theta: Self) -> Option<Reduced<Self>>;
}

impl Coordinate for f64 {
    fn reduced(d: &Dynamics, theta: f64) -> Option<Reduced<f64>> {
        d.latest.at(theta, || match d.is_calm() {
            true => d.indoors(theta),
            false => d.reduced(theta),
        })
    }
}

impl Coordinate<Dual64> for Dual64 {
    fn reduced(d: &Dynamics<Dual64>, theta: Dual64) -> Option<Reduced<Dual64>> {
        d.reduced(theta)
    }
}

impl Coordinate<Rec> for Rec {
    fn reduced(d: &Dynamics<Rec>, theta: Rec) -> Option<Reduced<Rec>> {
        d.reduced(theta)
    }
}

/// The mechanism depends on the driven angle alone, so that one more derivative by it serves all states.
impl<const N: usize> Coordinate for Gradient<N> {
    fn reduced(d: &Dynamics, theta: Gradient<N>) -> Option<Reduced<Gradient<N>>> {
        let at = Dual64::new(theta.re, 1.0);
        let mut r = d.mechanism.with_slope(at, &d.asked)?;
        if let Some(geared) = &d.geared {
            r = r.with(geared.with_slope(at)?);
        }
        if !d.is_calm() {
            let met = d.outdoors.as_ref();
            let met = met.map(|outdoors| outdoors.to.with_slope(at, &outdoors.weather));
            let omega = d.slewed.map(|[_, omega]| Dual64::from_re(omega));
            r = r.outside(met.map_or(Some(None), |met| met.map(Some))?, omega);
        }
        let of = |x: Dual64| theta.chain(x);
        Some(Reduced {
            inertia: of(r.inertia),
            slope: of(r.slope),
            moment: of(r.moment),
            energy: of(r.energy),
            head: [r.head[0].map(of), r.head[1].map(of), r.head[2].map(of)],
            drive: [of(r.drive[0]), of(r.drive[1])],
            turn: r.turn.map(of),
            lead: r.lead.map(|lead| lead.map(of)),
            weighed: r.weighed.map(|weighed| weighed.map(of)),
            shaft: r.shaft.map(|shaft| shaft.map(of)),
            outside: r.outside.map(|outside| outside.map(of)),
        })
    }
}

impl Dynamics {
    /// With wind, slope and slewing speed of a time (s) later, where they change at some rates.
    pub(super) fn put_later(&mut self, rates: &Weather, time: f64) {
        let weather = self
            .outdoors
            .as_ref()
            .map_or(Weather::calm(), |outdoors| outdoors.weather);
        let slewing = self.slewed.map_or(weather.slewing, |[n, _]| n);
        self.put_weather(Weather { slewing, ..weather }.later(rates, time));
    }
}

impl<P: Calc> Dynamics<P> {
    /// What it is at a coordinate (rad).
    fn reduced(&self, at: P) -> Option<Reduced<P>> {
        let r = self.indoors(at)?;
        if self.outdoors.is_none() && self.slewed.is_none() {
            return Some(r);
        }
        let met = self
            .outdoors
            .as_ref()
            .map(|outdoors| outdoors.to.outside(at, &outdoors.weather));
        let met = met.map_or(Some(None), |met| met.map(Some))?;
        Some(r.outside(met, self.slewed.map(|[_, omega]| omega)))
    }

    /// Whether neither wind nor slope acts on its bodies now, and nothing slews them.
    fn is_calm(&self) -> bool {
        self.outdoors.as_ref().is_none_or(|outdoors| outdoors.weather.is_calm())
            && self.slewed.is_none_or(|[n, _]| n.value() == 0.0)
    }

    /// The same without all that.
    fn indoors(&self, at: P) -> Option<Reduced<P>> {
        let r = self.mechanism.reduced(at, &self.asked)?;
        match &self.geared {
            None => Some(r),
            Some(geared) => Some(r.with(geared.turned(at)?)),
        }
    }

    /// Under gravity, in m/s².
    #[must_use]
    pub fn new(mechanism: Arc<dyn Reduces<P>>, pendulum: Option<Pendulum<P>>, gravity: P) -> Dynamics<P> {
        Dynamics {
            mechanism,
            asked: Asked {
                turntable: None,
                leans: false,
                drive: false,
            },
            geared: None,
            pendulum,
            gravity,
            air: None,
            area: None,
            slope: None,
            blows: [P::constant(0.0); 2],
            ground: None,
            outdoors: None,
            slewed: None,
            latest: Latest::default(),
        }
    }

    /// With air that resists the load, and blows with a speed (m/s) in a direction (rad).
    #[must_use]
    pub fn in_air(mut self, air: AirDrag<P>, blows: [P; 2]) -> Dynamics<P> {
        (self.air, self.blows) = (Some(air), blows);
        self
    }

    /// With wind on what slews.
    #[must_use]
    pub fn from_the_side(mut self, area: SlewedArea<P>) -> Dynamics<P> {
        self.area = Some(area);
        self
    }

    /// On a slope, where it slews.
    #[must_use]
    pub fn on_slope(mut self, slope: SlopingGround<P>) -> Dynamics<P> {
        (self.slope, self.asked.leans) = (Some(slope), true);
        self.latest = Latest::default();
        self
    }

    /// Under a crane that slews, where it is not level.
    pub(crate) fn slope(&self) -> Option<&SlopingGround<P>> {
        self.slope.as_ref()
    }

    /// With ground below the load, at a height in m.
    #[must_use]
    pub fn above_ground(mut self, height: P) -> Dynamics<P> {
        self.ground = Some(height);
        self
    }

    /// Height of the ground below the load, in m, where there is any.
    #[must_use]
    pub fn ground(&self) -> Option<P> {
        self.ground
    }

    /// With the wind that blows: speed (m/s) and direction (rad), where there is air.
    pub(crate) fn put_wind(&mut self, blows: [P; 2]) {
        if self.is_aired() {
            self.blows = blows;
        }
    }

    /// In wind and on a slope, calm and level until they are told.
    #[must_use]
    pub fn outdoors(mut self, to: Arc<dyn Exposes<P>>) -> Dynamics<P> {
        self.outdoors = Some(Outdoors::new(to, Weather::calm(), self.gravity));
        self.latest = Latest::default();
        self
    }

    /// With the wind at the load, as in [`put_wind`](Dynamics::put_wind), and what the bodies meet.
    pub(crate) fn put_around(&mut self, wind: [P; 2], weather: Weather<P>) {
        self.put_wind(wind);
        self.put_weather(weather);
    }

    /// Slewed at a speed that is given, still until it is told, about an axis (m).
    #[must_use]
    pub fn slewed_about(self, axis: P) -> Dynamics<P> {
        let inertia = P::constant(0.0);
        Dynamics {
            slewed: Some([inertia; 2]),
            ..self.with_slewing(Turntable { axis, inertia })
        }
    }

    /// With wind, slope and slewing speed as they are, where it meets them.
    pub(crate) fn put_weather(&mut self, weather: Weather<P>) {
        if let Some(outdoors) = self.outdoors.take() {
            self.outdoors = Some(Outdoors::new(outdoors.to, weather, self.gravity));
            self.latest = Latest::default();
        }
        if let Some(slewed) = &mut self.slewed {
            let omega = P::constant(TAU) * weather.slewing;
            *slewed = [weather.slewing, omega.def(&s::OMEGA_SM)];
            self.latest = Latest::default();
        }
    }

    /// Wind and slope, where it meets them.
    #[must_use]
    pub fn weather(&self) -> Option<&Outdoors<P>> {
        self.outdoors.as_ref()
    }

    /// Whether it meets wind or slope, or is slewed at a given speed.
    pub(crate) fn is_outdoors(&self) -> bool {
        self.outdoors.is_some() || self.slewed.is_some()
    }

    /// Whether there is air around the load, or wind on what slews.
    pub(crate) fn is_aired(&self) -> bool {
        self.air.is_some() || self.area.is_some()
    }

    /// Around the load, where there is any.
    #[must_use]
    pub fn air(&self) -> Option<&AirDrag<P>> {
        self.air.as_ref()
    }

    /// Speed (m/s) and direction (rad) of the wind, where there is air.
    pub(crate) fn blows(&self) -> [P; 2] {
        self.blows
    }

    /// Moment of the wind on what slews, in N·m, at a slewing angle (rad), where it meets any.
    pub(crate) fn pushed_aside<C: Coordinate<P>>(&self, psi: C) -> Option<C> {
        let area = self.area?.map(&mut |_, of| C::of(of));
        area.pushed(self.blows.map(C::of), psi).map(|[_, moment]| moment)
    }

    /// With a cylinder for its drive, whose line the equations of motion ask for.
    #[must_use]
    pub fn by_cylinder(mut self) -> Dynamics<P> {
        self.asked.drive = true;
        self.latest = Latest::default();
        self
    }

    /// Whether a cylinder is its drive.
    #[must_use]
    pub fn is_by_cylinder(&self) -> bool {
        self.asked.drive
    }

    /// With a motor that turns with it.
    #[must_use]
    pub fn by_motor(mut self, geared: Arc<Geared<P>>) -> Dynamics<P> {
        self.geared = Some(geared);
        self.latest = Latest::default();
        self
    }

    /// On a turntable.
    #[must_use]
    pub fn with_slewing(mut self, turntable: Turntable<P>) -> Dynamics<P> {
        self.asked.turntable = Some(turntable);
        self.latest = Latest::default();
        self
    }

    /// Where slewing is a motion of its own.
    #[must_use]
    pub fn turntable(&self) -> Option<Turntable<P>> {
        self.turns().filter(|_| self.slewed.is_none())
    }

    /// About what it turns, where slewing is a motion of its own or given.
    pub(crate) fn turns(&self) -> Option<Turntable<P>> {
        self.asked.turntable
    }

    /// Angular velocity at which it is slewed (rad/s), where that is given.
    pub(crate) fn slewed_at(&self) -> Option<P> {
        self.slewed.map(|[_, omega]| omega)
    }

    #[must_use]
    pub fn pendulum(&self) -> Option<&Pendulum<P>> {
        self.pendulum.as_ref()
    }

    /// In m/s².
    #[must_use]
    pub fn gravity(&self) -> P {
        self.gravity
    }

    /// Whether a rope drives it, which pulls and never pushes.
    pub(crate) fn is_pulled(&self) -> bool {
        self.mechanism.is_pulled()
    }

    /// Whether a motor turns with it.
    pub(crate) fn is_geared(&self) -> bool {
        self.geared.is_some()
    }

    /// What its coordinate is called by.
    pub(crate) fn names(&self) -> CoordinateNames {
        self.mechanism.names()
    }
}
