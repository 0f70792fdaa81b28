//! What weighs on the supports besides the load, on a slope and in the wind.

use crate::component::stages::results;
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;
use crate::parts::plane::{self, Point};
use crate::supports::mobile::boom::{BoomShape, BoomWeight, HeadPose};
use crate::supports::mobile::symbols as s;

quantities! {
    /// A body of the carrier.
    CarrierBody { g_c: G_C, x_c: X_C, y_c: Y_C, h_c: H_C }
}

quantities! {
    /// A body of the upper works.
    UpperBody { g_u: G_U, r_u: R_U, h_u: H_U }
}

quantities! {
    /// The ground that is not level.
    Inclined { gamma_s: GAMMA_S }
}

quantities! {
    /// Wind on the load, which weighs by g.
    WindOnLoad { v_w: V_W, c_p: C_P, a_q: A_Q, g: G }
}

/// The crane without load: weight (N), and moments (N·m) of the carrier in the plane, of all that slews in the boom's
/// direction, of all by their heights.
#[derive(Clone, Copy, Debug)]
pub struct DeadWeight<C> {
    pub weight: C,
    pub carrier: Point<C>,
    pub slewing: C,
    pub height: C,
}
results! { DeadWeight as d => {
    V_0: d.weight;
    M_CX: d.carrier.x;
    M_CY: d.carrier.y;
    M_U: d.slewing;
    Z_0: d.height;
} }

impl<C: Calc> DeadWeight<C> {
    /// Sums of weights and of their moments.
    ///
    /// # Errors
    /// Nothing weighs anything.
    pub fn new(
        carrier: &[CarrierBody<C>],
        upper: &[UpperBody<C>],
        shape: &BoomShape<C>,
        pose: &HeadPose<C>,
        boom: &BoomWeight<C>,
    ) -> Result<DeadWeight<C>, Fault> {
        let below = sum(carrier.iter().map(|body| body.g_c)).def(&s::V_C);
        let moment = Point::new(
            sum(carrier.iter().map(|body| body.g_c * body.x_c)),
            sum(carrier.iter().map(|body| body.g_c * body.y_c)),
        );
        let moment = plane::def(moment, [&s::M_CX, &s::M_CY]);
        let ahead = boom.weight * shape.x_f + boom.moment * pose.cos;
        let slewing = (sum(upper.iter().map(|body| body.g_u * body.r_u)) + ahead).def(&s::M_U);
        let weight = (below + sum(upper.iter().map(|body| body.g_u)) + boom.weight).def(&s::V_0);
        if weight.value() <= 0.0 {
            return Err(Fault::outside(
                "V_0 = 0: a crane without weight tips under any load; give the weights of carrier, upper works and boom",
            ));
        }
        let high = boom.weight * shape.h_f + boom.moment * pose.sin;
        let lower = sum(carrier.iter().map(|body| body.g_c * body.h_c));
        Ok(DeadWeight {
            weight,
            carrier: moment,
            slewing,
            height: (lower + sum(upper.iter().map(|body| body.g_u * body.h_u)) + high).def(&s::Z_0),
        })
    }
}

/// Where weights act on level ground as they do with slope and wind.
#[derive(Clone, Copy, Debug)]
pub struct Leaning<C> {
    /// Moment in the boom's direction of all that slews without load, in N·m: with the slope, and against it.
    pub moment: C,
    pub against: C,
    /// Reach of the load, in m.
    pub reach: C,
    /// Cosine of the slope: what of a weight presses on the ground.
    pub upright: C,
}
results! { Leaning as l => { M_E: l.moment; M_R: l.against; R_E: l.reach; } }

impl<C: Calc> Leaning<C> {
    /// M_e = M_u + Z_0 tan γ, R_E = R + H (tan γ + w_Q / cos γ), with w_Q = c_p v² a_Q / g.
    pub fn new(
        slope: &Option<Inclined<C>>,
        wind: &Option<WindOnLoad<C>>,
        pose: &HeadPose<C>,
        dead: &DeadWeight<C>,
    ) -> Leaning<C> {
        let blown = wind.as_ref().map(|wind| {
            let pressure = (wind.c_p * wind.v_w.square()).def(&s::P_W);
            (pressure * wind.a_q / wind.g).def(&s::W_Q)
        });
        let (steep, upright) = slope.as_ref().map_or((None, C::constant(1.0)), |slope| {
            let (sin, cos) = slope.gamma_s.sin_cos();
            (Some(sin / cos), cos)
        });
        let aside = [steep, blown.map(|wind| wind / upright)]
            .into_iter()
            .flatten()
            .reduce(|a, b| a + b);
        Leaning {
            moment: steep.map_or(dead.slewing, |steep| (dead.slewing + dead.height * steep).def(&s::M_E)),
            against: steep.map_or(dead.slewing, |steep| (dead.slewing - dead.height * steep).def(&s::M_R)),
            reach: aside.map_or(pose.reach, |aside| (pose.reach + pose.height * aside).def(&s::R_E)),
            upright,
        }
    }
}

quantities! {
    /// Hook block or grab, and the impact of its load.
    Hook { g_h: G_H, phi_q: PHI_Q }
}

/// The load as it acts, in N.
#[derive(Clone, Copy, Debug)]
pub struct Payload<C> {
    /// With hook block or grab, at rest.
    pub hung: C,
    /// With its impact.
    pub counted: C,
}
results! { Payload as p => { Q_G: p.counted; } }

impl<C: Calc> Payload<C> {
    /// Q_g = φ_Q (Q + G_h).
    pub fn new(load: &One<C>, hook: &Hook<C>) -> Payload<C> {
        let hung = **load + hook.g_h;
        Payload {
            hung,
            counted: (hook.phi_q * hung).def(&s::Q_G),
        }
    }
}
