//! Forces of guide, link and frame, by equilibrium of the boom and of the link: they do not know the moment of the drive, but
//! the frame carries its force.

use crate::balance::residual::Residual;
use crate::component::stages::{Found, results};
use crate::drive::line::Reaction;
use crate::kernel::calc::Calc;
use crate::kernel::variable::Fault;
use crate::luffing::ellipsograph::position::{Bars, GuidedPosition};
use crate::luffing::ellipsograph::statics::GuidedWeights;
use crate::luffing::ellipsograph::symbols as s;
use crate::parts::motion::degrees;
use crate::parts::plane::{self, Point};

/// In N.
#[derive(Clone, Copy, Debug)]
pub struct GuidedPins<C> {
    /// Of the guide on the foot, forward.
    guide: C,
    /// Of the link on the boom.
    link: Point<C>,
    /// Along the link, tension positive.
    axial: C,
    /// Of the frame on the link.
    frame: Point<C>,
}
results! { GuidedPins as f => {
    F_BX: f.guide;
    F_CX: f.link.x;
    F_CY: f.link.y;
    N_L: f.axial;
    F_O1X: f.frame.x;
    F_O1Y: f.frame.y;
} }

/// # Errors
/// A boom that lies level, at an angle (rad): no force of the guide holds its head there.
pub fn held<C: Calc>(position: &GuidedPosition<C>, phi: C) -> Found<()> {
    if position.along.y.value().abs() > 4.0 * f64::EPSILON {
        return Ok(());
    }
    Err(Box::new(Fault::outside(format!(
        "phi = {}: the boom lies level with its foot in O1, no force of the guide holds its head; \
         keep the angle away from there",
        degrees(phi.value())
    ))))
}

impl<C: Calc> GuidedPins<C> {
    /// The boom about C: F_Bx c sin φ = Q (x_A − x_C) + G_b (x_S − x_C).
    ///
    /// # Errors
    /// A boom that lies level: no force of the guide holds its head there.
    pub fn new(
        bars: &Bars<C>,
        q: &C,
        weights: &Option<GuidedWeights<C>>,
        phi: &C,
        position: &GuidedPosition<C>,
        residual: Option<&Residual<C>>,
        drive: Option<&Reaction<C>>,
    ) -> Found<GuidedPins<C>> {
        held(position, *phi)?;
        let (m_c, on_pin, below) = match weights {
            None => (*q * (position.a.x - position.c.x), *q, C::constant(0.0)),
            Some(w) => {
                let x_s = (w.r_b * (*phi + w.chi_b).sin_cos().1).def(&s::S_BX);
                let m_c = *q * (position.a.x - position.c.x) + w.g_b * (x_s - position.c.x);
                (m_c, *q + w.g_b, w.g_l)
            }
        };
        let guide = (m_c.def(&s::M_C) / (bars.c * position.along.y)).def(&s::F_BX);
        let link = plane::def(Point::new(-guide, on_pin), [&s::F_CX, &s::F_CY]);
        let frame = Point::new(link.x, link.y + below);
        let frame = residual.map_or(frame, |left| frame - left.action.on_boom);
        let push = drive.and_then(|drive| drive.force);
        let frame = push.map_or(frame, |push| frame - push);
        Ok(GuidedPins {
            guide,
            link,
            axial: (-plane::dot(link, position.c) / bars.c).def(&s::N_L),
            frame: plane::def(frame, [&s::F_O1X, &s::F_O1Y]),
        })
    }
}
