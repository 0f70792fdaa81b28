//! What weighs on the portal besides the load, and the wind.

use crate::component::stages::{absent, results};
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::quantities;
use crate::kernel::variable::Fault;
use crate::luffing::luffed::Luffed;
use crate::parts::plane::{self, Point};
use crate::supports::portal::symbols as s;

quantities! {
    /// A body of the portal.
    PortalBody { g_p: G_P, x_p: X_P, y_p: Y_P }
}

quantities! {
    /// A body of the upper works.
    SlewingBody { g_u: G_U, r_u: R_U }
}

quantities! {
    /// Pressure and direction of the wind.
    Blowing { p_w: P_W, chi_w: CHI_W }
}

quantities! {
    /// An area on which the wind acts.
    WindArea { a_w: A_W, h_w: H_W }
}

quantities! {
    /// A hopper on the portal: empty (N), its place (m), what lies in it, and what does when it is full (N).
    PortalHopper { g: G_H0, x: X_H, y: Y_H, q: Q_H, full: Q_HF }
}

/// The hopper with its contents: weight (N) and place (m), how full it is.
#[derive(Clone, Copy, Debug)]
pub struct HopperWeight<C> {
    weight: C,
    place: Point<C>,
    fill: C,
}
results! { HopperWeight as h => { V_H: h.weight; U_H: h.fill; } }

impl<C: Calc> HopperWeight<C> {
    /// V_h = G_h0 + Q_h, u_h = Q_h/Q_hf. [Ports001, 7.2.5]
    pub fn new(hopper: &PortalHopper<C>) -> HopperWeight<C> {
        HopperWeight {
            weight: (hopper.g + hopper.q).def(&s::V_H),
            place: Point::new(hopper.x, hopper.y),
            fill: (hopper.q / hopper.full).def(&s::U_H),
        }
    }
}

/// The crane without load: its weight (N), moments (N·m) of the portal's weight, of the wind, and of both.
#[derive(Clone, Copy, Debug)]
pub struct StillMoment<C> {
    pub weight: C,
    pub portal: Point<C>,
    wind: Option<(C, Point<C>)>,
    pub moment: Point<C>,
}
results! { StillMoment as m => {
    V_0: m.weight;
    M_PX: m.portal.x;
    M_PY: m.portal.y;
    M_W: m.wind.ok_or_else(absent)?.0;
    M_WX: m.wind.ok_or_else(absent)?.1.x;
    M_WY: m.wind.ok_or_else(absent)?.1.y;
    M_0X: m.moment.x;
    M_0Y: m.moment.y;
} }

impl<C: Calc> StillMoment<C> {
    /// V_0 = Σ G_p + Σ G_u, with a luffing mechanism its W_1 and with a hopper its V_h besides; M_px = Σ G_p y_p + V_h y_h,
    /// M_py = Σ G_p x_p + V_h x_h, M_w = p_w Σ A_w h_w, M_0x = M_px + M_w sin χ_w.
    ///
    /// # Errors
    /// Nothing weighs anything.
    pub fn new(
        portal: &[PortalBody<C>],
        upper: &[SlewingBody<C>],
        wind: &Option<Blowing<C>>,
        areas: &[WindArea<C>],
        luffed: Option<&Luffed<C>>,
        hopper: Option<&HopperWeight<C>>,
    ) -> Result<StillMoment<C>, Fault> {
        let own = sum(portal.iter().map(|body| body.g_p));
        let weight = match upper {
            [] => own,
            _ => own + sum(upper.iter().map(|body| body.g_u)),
        };
        let weight = luffed.map_or(weight, |luffed| weight + luffed.weight);
        let weight = hopper.map_or(weight, |hopper| weight + hopper.weight).def(&s::V_0);
        if weight.value() <= 0.0 {
            let what = "V_0 = 0: a crane without weight stands on nothing; give the weights of portal and upper works";
            return Err(Fault::outside(what));
        }
        let moment = Point::new(
            sum(portal.iter().map(|body| body.g_p * body.y_p)),
            sum(portal.iter().map(|body| body.g_p * body.x_p)),
        );
        let moment = hopper.map_or(moment, |hopper| {
            let [x, y] = [hopper.place.x, hopper.place.y];
            moment + Point::new(hopper.weight * y, hopper.weight * x)
        });
        let moment = plane::def(moment, [&s::M_PX, &s::M_PY]);
        let wind = wind.as_ref().map(|wind| {
            let whole = (wind.p_w * sum(areas.iter().map(|area| area.a_w * area.h_w))).def(&s::M_W);
            let (sin, cos) = wind.chi_w.sin_cos();
            (
                whole,
                plane::def(Point::new(whole * sin, whole * cos), [&s::M_WX, &s::M_WY]),
            )
        });
        Ok(StillMoment {
            weight,
            portal: moment,
            wind,
            moment: wind.map_or(moment, |(_, wind)| plane::def(moment + wind, [&s::M_0X, &s::M_0Y])),
        })
    }

    /// Moments of the wind, in N·m; none without one.
    pub fn wind(&self) -> Point<C> {
        self.wind
            .map_or(Point::new(C::constant(0.0), C::constant(0.0)), |(_, wind)| wind)
    }
}

/// M_u = Σ G_u r_u, with a luffing mechanism its M_r1 besides, in N·m.
pub fn upper_moment<C: Calc>(upper: &[SlewingBody<C>], luffed: Option<&Luffed<C>>) -> C {
    let own = sum(upper.iter().map(|body| body.g_u * body.r_u));
    luffed.map_or(own, |luffed| own + luffed.forward).def(&s::M_U)
}
