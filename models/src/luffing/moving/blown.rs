//! A load that swings in the plane of the mechanism as the air meets it, and what a slope gives it.

use crate::kernel::calc::Calc;
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::pendulum::{Phase, Reel};
use crate::luffing::moving::reduced::Reduced;
use crate::luffing::moving::symbols as s;
use crate::parts::air::AirDrag;
use crate::parts::plane::{self, Point, dot};

/// From the head to the load, and where it swings to, at an angle of the rope.
pub(crate) fn directions<C: Calc>(swing: C) -> (Point<C>, Point<C>) {
    let (sin, cos) = swing.sin_cos();
    (Point::new(sin, -cos), Point::new(cos, sin))
}

impl<P: Calc> Dynamics<P> {
    /// Velocity of the load against the ground and against the air, in m/s, with its drag, where there is air.
    pub(crate) fn in_wind<C: Coordinate<P>>(
        &self,
        r: &Reduced<C>,
        m: &Phase<C>,
        reel: &Reel<C>,
    ) -> Option<([[C; 2]; 2], AirDrag<C>)> {
        let air = self.air()?;
        let (out, along) = directions(m.swing);
        let velocity = r.head[1] * m.omega + along * (reel.length * m.swing_rate) + out * reel.rate;
        let against = plane::def(
            velocity - Point::new(C::of(self.blows()[0]), C::constant(0.0)),
            [&s::U_AIR_X, &s::U_AIR_Y],
        );
        Some(([velocity, against].map(Into::into), air.over()))
    }

    /// Acceleration that air and slope give the load, in m/s², where there are any.
    pub(crate) fn outer_acceleration<C: Coordinate<P>>(
        &self,
        r: &Reduced<C>,
        m: &Phase<C>,
        reel: &Reel<C>,
    ) -> Option<Point<C>> {
        let air = self
            .in_wind(r, m, reel)
            .map(|([_, against], drag)| Point::from(drag.on(against)));
        let lean = self.weather().map(|outdoors| outdoors.lean.map(C::of));
        match (air, lean) {
            (Some(air), Some(lean)) => Some(air + lean),
            (air, lean) => air.or(lean),
        }
    }

    /// The same along the load's travel for one radian of the driving link (m²/s²), and across the rope (m/s²).
    pub(crate) fn outer_along<C: Coordinate<P>>(&self, r: &Reduced<C>, m: &Phase<C>, reel: &Reel<C>) -> Option<[C; 2]> {
        let outer = self.outer_acceleration(r, m, reel)?;
        let (out, along) = directions(m.swing);
        let mut given = dot(outer, r.head[1]);
        if let Some([lead, _]) = r.lead {
            given += lead * dot(outer, out);
        }
        Some([given, dot(outer, along)])
    }
}

impl Dynamics {
    /// Potential energy over the mass of a load at a place (m), in J/kg.
    pub(crate) fn potential(&self, place: Point<f64>) -> f64 {
        let level = self.gravity() * place.y;
        self.weather()
            .map_or(level, |outdoors| level - outdoors.lean.dot(&place))
    }
}
