//! The air around what slews by itself: around a load that swings, [`crate::parts::air`] from a head at a reach, and the wind on
//! the structure.

use nalgebra::Vector3;

use crate::component::stages::{Found, absent, results};
use crate::kernel::calc::Calc;
use crate::parts::air::{AirAround, AirDrag, Stream, WindAround};
use crate::parts::hanging::turned;
use crate::parts::side_wind::SlewedArea;
use crate::slewing::swinging::Swinging;
use crate::slewing::symbols as s;
use crate::slewing::turning::{Hung, SlewedLoad};

/// The wind on the structure: its pressure, in Pa and with the sign of its speed, and its moment about the slewing axis, in N·m.
#[derive(Clone, Copy, Debug)]
pub struct WindOnSlewed<C> {
    pressure: C,
    pub(super) moment: C,
}
results! { WindOnSlewed as w => { P_WS: w.pressure; M_WS: w.moment; } }

impl<C: Calc> WindOnSlewed<C> {
    /// As [`SlewedArea::pushed`].
    pub fn new(
        area: &SlewedArea<C>,
        blowing: &WindAround<C>,
        around: &Option<AirAround<C>>,
        psi: &C,
    ) -> Found<WindOnSlewed<C>> {
        let pushed = area
            .in_air(around.as_ref())
            .pushed([blowing.v_air, blowing.chi_air], *psi);
        let [pressure, moment] = pushed.ok_or_else(absent)?;
        Ok(WindOnSlewed { pressure, moment })
    }
}

/// What slope and wind give together to what slews, in N·m; `None` where there is neither.
pub fn outer<C: Calc>(tilt: Option<&C>, wind: Option<&WindOnSlewed<C>>) -> Option<C> {
    match (tilt, wind) {
        (Some(tilt), Some(wind)) => Some(*tilt + wind.moment),
        (tilt, wind) => tilt.copied().or(wind.map(|wind| wind.moment)),
    }
}

/// The air as the load meets it, in the frame that slews.
pub fn stream<C: Calc>(around: &AirAround<C>, blowing: &WindAround<C>, hung: &Hung<C>, psi: &C) -> Stream<C> {
    Stream::new(AirDrag::new(around, hung.g), [blowing.v_air, blowing.chi_air], *psi)
}

/// What the air does to the load: its force, in N, and the power that it takes, in W.
#[derive(Clone, Copy, Debug)]
pub struct FeltAir<C>([C; 2]);
results! { FeltAir as a => { F_AIR: a.0[0]; P_AIR: a.0[1]; } }

impl<C: Calc> FeltAir<C> {
    /// F = m (δ + κ u) u and P = m (δ + κ u) u·v, at the load's velocity v against the ground and u against the air.
    pub fn new(
        stream: &Stream<C>,
        swinging: &Swinging<C>,
        hung: &Hung<C>,
        carried: &SlewedLoad<C>,
        omega: &C,
    ) -> FeltAir<C> {
        let zero = C::constant(0.0);
        let from_axis = swinging.load.place + Vector3::new(hung.r, zero, zero);
        let velocity = swinging.found.rate + turned(from_axis).map(|part| part * *omega);
        FeltAir(stream.felt(velocity).map(|over| carried.mass * over))
    }
}
