//! A sudden wind: heel at rest and heel to which the hull rolls, and the least moment that capsizes it.

use num_dual::Dual64;

use crate::afloat::hull::Floating;
use crate::afloat::levers::{At, Heeled, over};
use crate::afloat::loaded::Loaded;
use crate::afloat::loss::{beyond, swung};
use crate::afloat::openings::AreaEnds;
use crate::afloat::posture::Posture;
use crate::afloat::symbols as s;
use crate::afloat::weights::{HullWind, Weighed, WindageArea};
use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::component::stages::results;
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::quantities;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::parts::bracket::bracketed;

quantities! {
    /// A sudden wind, and the roll against it from which the hull comes.
    GustGiven { p_g: P_G, phi_a: PHI_A }
}

/// Heel at rest and heel to which it rolls, in rad.
struct Struck;

impl Finding<2> for Struck {
    type From<C: Calc> = At<C>;
    const NAMES: [&'static Symbol; 2] = *listed!(s: PHI_S, PHI_DYN);

    fn map<C: Calc, D: Calc>(from: &At<C>, f: &mut dyn FnMut(C) -> D) -> At<D> {
        over(from, f)
    }

    fn find<C: Calc>(from: &At<C>) -> Result<[C; 2], Fault> {
        let [rest, _, _, rolls] = swung(from, ["in the gust", "when the gust strikes"])?;
        Ok([rest, rolls])
    }
}

/// The least moment that capsizes, in N·m.
struct Capsizing;

/// Of the heel (rad): the moment of the tangent errs by less than the square of this, by its steepness.
const NEAR: f64 = 1e-8;

impl Finding<1> for Capsizing {
    type From<C: Calc> = At<C>;
    const NAMES: [&'static Symbol; 1] = *listed!(s: M_C);

    fn map<C: Calc, D: Calc>(from: &At<C>, f: &mut dyn FnMut(C) -> D) -> At<D> {
        over(from, f)
    }

    fn find<C: Calc>((on, all, [from, end]): &At<C>) -> Result<[C; 1], Fault> {
        if from.value().abs() >= end.value().abs() {
            return Err(beyond("before the gust", *from, *end));
        }
        let mut heeled = Heeled::new(on, all, None);
        let low = heeled.raised(*from)?[0];
        let plain = |x: C| Dual64::from_re(x.value());
        let (hull, weighed) = (on.map(&mut { plain }), all.map(&mut { plain }));
        let mut tried = Heeled::new(&hull, &weighed, None);
        // Below zero beyond the heel where the line from the start touches the curve.
        let mut over = |heel: f64| {
            let [rise, lever] = tried.raised(Dual64::new(heel, 1.0))?;
            let travel = heel - from.value();
            Ok::<_, Fault>([low.value() + lever.re * travel - rise.re, lever.eps * travel])
        };
        let mut touch = *end;
        if over(end.value())?[0] < 0.0 {
            let ends = [from.value(), end.value()];
            touch = C::constant(bracketed(ends, f64::midpoint(ends[0], ends[1]), NEAR, over)?);
        }
        let lever = (heeled.raised(touch)?[0] - low) / (touch - *from);
        Ok([all.weight * lever.abs()])
    }
}

/// Moment of a gust (N·m), heels at rest and of the roll (rad), the moment that capsizes (N·m) and how many times it is greater.
#[derive(Clone, Copy, Debug)]
pub struct Gust<C> {
    moment: C,
    heels: [C; 2],
    capsizes: C,
    safety: C,
}
results! { Gust as g => { M_G: g.moment; PHI_S: g.heels[0]; PHI_DYN: g.heels[1]; M_C: g.capsizes; K_C: g.safety; } }

impl<C: Scalar> Gust<C> {
    /// M_g = p_g Σ A (z_w − z_l) cos φ, to the side to which the hull heels, from a roll to the other side;
    /// M_c = W max (e(φ) − e(φ_1))/(φ − φ_1), the tangent of the dynamic lever, up to φ_f; K_c = M_c/M_g. [Ports001, 7.3]
    ///
    /// # Errors
    /// A roll beyond φ_f.
    pub fn new(
        on: &Floating<C>,
        loaded: &Loaded<C>,
        posture: &Posture<C>,
        ends: &AreaEnds<C>,
        gust: &GustGiven<C>,
        wind: &HullWind<C>,
        areas: &[WindageArea<C>],
    ) -> Result<Gust<C>, Fault> {
        let moment = gust.p_g * sum(areas.iter().map(|area| area.a_w * (area.z_w - wind.z_l)));
        let moment = moment.def(&s::M_G);
        let heel = posture.heel();
        let left = heel.value() >= 0.0;
        let [from, end, across] = if left {
            [heel - gust.phi_a, ends.0[0], loaded.all.across + moment]
        } else {
            [heel + gust.phi_a, -ends.0[0], loaded.all.across - moment]
        };
        let struck = Weighed { across, ..loaded.all };
        let heels = found::<Struck, C, 2>(&(on.clone(), struck, [from, ends.0[0]]))?;
        let [capsizes] = found::<Capsizing, C, 1>(&(on.clone(), loaded.all, [from, end]))?;
        let safety = if moment.value() > 0.0 {
            (capsizes / moment).def(&s::K_C)
        } else {
            C::known(&s::K_C, f64::INFINITY).over(moment).over(capsizes)
        };
        Ok(Gust {
            moment,
            heels,
            capsizes,
            safety,
        })
    }
}
