//! The boom with its parts: a telescopic one by its sections, a lattice one by what each metre adds.

use crate::component::stages::results;
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;
use crate::supports::mobile::symbols as s;

quantities! {
    /// Foot, head and angles of the boom.
    BoomShape { x_f: X_F, h_f: H_F, d_a: D_A, l_0: L_0, phi_min: PHI_MIN, phi_max: PHI_MAX }
}

quantities! {
    /// A part of the boom.
    BoomPart { g_p: G_P, q_p: Q_P, s_p: S_P, kappa_p: KAPPA_P }
}

/// The boom's angle and length, its head.
#[derive(Clone, Copy, Debug)]
pub struct HeadPose<C> {
    pub phi: C,
    pub cos: C,
    pub sin: C,
    /// How much longer than at its shortest, in m.
    extension: C,
    pub reach: C,
    pub height: C,
}
results! { HeadPose as p => { PHI: p.phi; E_L: p.extension; R: p.reach; H_A: p.height; } }

impl<C: Calc> HeadPose<C> {
    /// R = x_F + l cos φ + d_A sin φ, by its angle or by its reach. [Ports001, 7.1.4]
    ///
    /// # Errors
    /// A reach that it has not, an angle beyond its ends, a length below its shortest.
    pub fn new(
        shape: &BoomShape<C>,
        length: &C,
        angle: &Option<One<C>>,
        reach: &Option<One<C>>,
    ) -> Result<HeadPose<C>, Fault> {
        let l = *length;
        let extension = l - shape.l_0;
        if extension.value() < -1e-9 * shape.l_0.value() {
            let [l, l_0] = [l, shape.l_0].map(|length| s::L.written(length.value()));
            return Err(Fault::outside(format!(
                "l = {l} where the boom is l_0 = {l_0} long at its shortest"
            )));
        }
        let phi = match (angle, reach) {
            (Some(angle), _) => **angle,
            (None, Some(reach)) => HeadPose::at(shape, l, **reach)?,
            (None, None) => return Err(Fault::new("neither phi nor R is given")),
        };
        let ends = [shape.phi_min, shape.phi_max].map(Calc::value);
        if phi.value() < ends[0] - 1e-9 || phi.value() > ends[1] + 1e-9 {
            let [phi, low, high] = [phi.value(), ends[0], ends[1]].map(|angle| s::PHI.written(angle));
            return Err(Fault::outside(format!(
                "the boom at phi = {phi}, where it goes from {low} to {high}"
            )));
        }
        let (sin, cos) = phi.sin_cos();
        Ok(HeadPose {
            phi,
            cos,
            sin,
            extension: extension.def(&s::E_L),
            reach: match reach {
                Some(reach) => **reach,
                None => (shape.x_f + l * cos + shape.d_a * sin).def(&s::R),
            },
            height: (shape.h_f + l * sin - shape.d_a * cos).def(&s::H_A),
        })
    }

    /// Angle of the boom at a reach (m), in rad.
    fn at(shape: &BoomShape<C>, l: C, reach: C) -> Result<C, Fault> {
        let (far, long) = (reach - shape.x_f, (l.square() + shape.d_a.square()).sqrt());
        if far.value().abs() > long.value() {
            let (reach, most) = (s::R.written(reach.value()), s::R.written((long + shape.x_f).value()));
            return Err(Fault::outside(format!(
                "R = {reach}: a boom with l = {} reaches {most} at most; give less reach or a longer boom",
                s::L.written(l.value())
            )));
        }
        let lean = if shape.d_a.value() == 0.0 {
            C::constant(0.0)
        } else {
            C::direction(l, shape.d_a)
        };
        Ok((lean + (far / long).acos()).def(&s::PHI))
    }
}

/// What the boom weighs.
#[derive(Clone, Copy, Debug)]
pub struct BoomWeight<C> {
    pub weight: C,
    /// About its foot were it horizontal, in N·m.
    pub moment: C,
    pub at_head: C,
}
results! { BoomWeight as b => { V_B: b.weight; M_B: b.moment; F_B: b.at_head; } }

impl<C: Calc> BoomWeight<C> {
    /// Σ (G + q e), Σ (G + q e)(s + κ e); at the head over its length. [ISO 4305]
    pub fn new(parts: &[BoomPart<C>], length: &C, pose: &HeadPose<C>) -> BoomWeight<C> {
        let e = pose.extension;
        let weight = |part: &BoomPart<C>| part.g_p + part.q_p * e;
        let moment = sum(parts.iter().map(|part| weight(part) * (part.s_p + part.kappa_p * e))).def(&s::M_B);
        BoomWeight {
            weight: sum(parts.iter().map(weight)).def(&s::V_B),
            moment,
            at_head: (moment / *length).def(&s::F_B),
        }
    }
}
