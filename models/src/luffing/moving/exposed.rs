//! Wind on the areas of a mechanism's bodies and the slope of the ground, in motion: what they come to at its coordinate, by
//! the places that load cases have. The wind blows in the mechanism's plane, whatever way the bodies move; the slope leans
//! gravity in it. [virtual work; Ports001, 5.5.4]

use std::sync::Arc;

use num_dual::Dual64;

use crate::component::scalar::Scalar;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::moving::given::Fitted;
use crate::luffing::moving::reduced::Renewed;
use crate::luffing::moving::symbols as s;
use crate::luffing::moving::weather::{Exposes, Outside, Weather};
use crate::luffing::resistances::given::{CaseBody, CasesChoice};
use crate::luffing::resistances::moments::{leaning, pressure};
use crate::luffing::resistances::placed::{BARS, Placed, Placing, Weighty, places};
use crate::luffing::resistances::symbols as r;
use crate::parts::plane::{Point, turned};

/// Of a body: its areas times drag coefficients (m²), and the same times their centres in the frame of its bar (m³).
#[derive(Clone, Copy, Debug)]
struct Sail<C> {
    area: C,
    moment: Point<C>,
}

/// A mechanism's bodies with their areas, and its load where that hangs on no rope.
pub struct Exposed<K: Placing, C: Calc> {
    of: K::Of<C>,
    weighty: Weighty<C>,
    sails: [Sail<C>; BARS + 1],
    load: Option<C>,
    /// Pressure of the wind over the square of its speed, in kg/m³.
    air: C,
}

impl<K: Placing, C: Calc> Clone for Exposed<K, C> {
    fn clone(&self) -> Exposed<K, C> {
        Exposed {
            of: self.of.clone(),
            ..*self
        }
    }
}

impl<K: Placing, C: Calc> Exposed<K, C> {
    fn new(
        (of, weighty): (&K::Of<C>, &Weighty<C>),
        (bodies, choice): (&[CaseBody<C>], &CasesChoice),
        load: Option<C>,
        air: &Option<One<C>>,
    ) -> Exposed<K, C> {
        let zero = C::constant(0.0);
        let mut sails = [Sail {
            area: zero,
            moment: Point::new(zero, zero),
        }; BARS + 1];
        for (it, &on) in bodies.iter().zip(&choice.bodies) {
            let area = it.area * it.drag;
            sails[on].area += area;
            sails[on].moment += it.middle() * area;
        }
        Exposed {
            of: of.clone(),
            weighty: *weighty,
            sails,
            load,
            air: air.map_or(zero, |air| air.1),
        }
    }

    fn pressure<D: Calc>(&self, over: impl Fn(C) -> D, weather: &Weather<D>) -> D {
        pressure(over(self.air), weather.wind, &s::P_WI)
    }

    /// Areas times drag coefficients times where their centres are, or travel, of one body: forward and up, in m³.
    fn sail<D: Calc>(&self, over: impl Fn(C) -> D, body: usize, placed: &Placed<D>) -> Point<D> {
        let Sail { area, moment } = self.sails[body];
        match placed.bars.get(body) {
            Some([joint, along]) => *joint * over(area) + turned(*along, over(moment.x), over(moment.y)),
            None => placed.counterweight * over(area),
        }
    }

    /// Weights of all bodies times where their centres are, or travel, in N·m.
    fn weighed<D: Calc>(&self, over: impl Fn(C) -> D, placed: &Placed<D>) -> Point<D> {
        let of = &self.weighty;
        let counterweight = placed.counterweight * over(of.counterweight * of.gravity);
        let bars = of.bodies.iter().zip(&placed.bars);
        bars.fold(counterweight, |sum, (body, [joint, along])| {
            let [x, y] = [body.centre.x, body.centre.y].map(&over);
            sum + (*joint + turned(*along, x, y)) * over(body.mass * of.gravity)
        })
    }

    /// With places and travels for one radian of the coordinate.
    fn met<D: Calc>(
        &self,
        over: impl Fn(C) -> D + Copy,
        [place, travel]: [&Placed<D>; 2],
        weather: &Weather<D>,
    ) -> Outside<D> {
        let swept = (0..=BARS).fold(D::constant(0.0), |sum, body| sum + self.sail(over, body, travel).x);
        let loaded = |weighed: Point<D>, head: Point<D>| match self.load.map(over) {
            Some(load) => weighed + head * load,
            None => weighed,
        };
        let weighed = self.weighed(over, travel);
        let weighed = Point::new(weighed.x.tabled(&r::W_GX), weighed.y.tabled(&r::W_GY));
        let head = Point::new(travel.head.x.tabled(&r::DX_H), travel.head.y.tabled(&r::DY_H));
        Outside {
            wind: (self.pressure(over, weather) * swept.tabled(&r::V_CA)).def(&s::M_WIND),
            slope: leaning(loaded(weighed, head), weather.slope).def(&s::M_SLOPE),
            energy: -leaning(loaded(self.weighed(over, place), place.head), weather.slope),
        }
    }
}

impl<K: Placing, C: Scalar> Exposes<C> for Exposed<K, C> {
    fn outside(&self, at: C, weather: &Weather<C>) -> Option<Outside<C>> {
        let [place, travel, _] = places::<K, C>(&self.of, at)?;
        Some(self.met(|x| x, [&place, &travel], weather))
    }

    fn with_slope(&self, at: Dual64, weather: &Weather<C>) -> Option<Outside<Dual64>> {
        let of = K::map(&self.of, |x: C| x.value());
        let [place, travel, bend] = places::<K, f64>(&of, at.re)?;
        let with = |one: &Placed<f64>, change: &Placed<f64>| one.with(change, |x, dx| Dual64::new(x, dx * at.eps));
        let over = |x: C| Dual64::constant(x.value());
        let placed = [&with(&place, &travel), &with(&travel, &bend)];
        Some(self.met(over, placed, &weather.with(weather, |x, _| over(x))))
    }

    fn pushes(&self, at: C, weather: &Weather<C>) -> Option<[[C; 2]; BARS + 1]> {
        let [place, ..] = places::<K, C>(&self.of, at)?;
        let pressure = self.pressure(|x| x, weather);
        Some(std::array::from_fn(|body| {
            let height = self.sail(|x| x, body, &place).y;
            let height = s::OF_AREAS.get(body).map_or(height, |name| height.tabled(name));
            [pressure * self.sails[body].area, pressure * height]
        }))
    }
}

/// The mechanism as wind and slope meet it, where they do, into the room for it.
#[expect(clippy::too_many_arguments, reason = "what is met, one by one")]
pub fn exposed<K: Placing, C: Calc>(
    places: Option<&K::Of<C>>,
    weighty: Option<&Weighty<C>>,
    bodies: &[CaseBody<C>],
    choice: &Option<CasesChoice>,
    load: &Option<One<C>>,
    air: &Option<One<C>>,
    fitted: &Fitted,
    room: &mut Vec<Renewed<Exposed<K, C>>>,
) {
    let found = places.zip(weighty).zip(choice.as_ref());
    match found.filter(|_| fitted.meets.any()) {
        Some((of, choice)) => {
            let load = load.filter(|_| fitted.rope.is_none()).map(|load| load.1);
            Renewed::renew(room, Exposed::new(of, (bodies, choice), load, air));
        }
        None => room.clear(),
    }
}

/// As the equations of motion share it, where there is one.
pub fn shared<K: Placing, C: Scalar>(exposed: &[Renewed<Exposed<K, C>>]) -> Option<Arc<dyn Exposes<C>>> {
    let now = exposed.first()?.now().clone();
    Some(now)
}
