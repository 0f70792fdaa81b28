//! Areas that are left between levers, and what a loss of load does.

use crate::afloat::hull::Floating;
use crate::afloat::levers::{At, Heeled, over};
use crate::afloat::loaded::Loaded;
use crate::afloat::openings::AreaEnds;
use crate::afloat::posture::Posture;
use crate::afloat::rest::{Lie, rest};
use crate::afloat::symbols as s;

use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::parts::bracket::bracketed;

quantities! {
    /// What a loss of load is judged by.
    LossRule { k_a: K_A, c_a: C_A }
}

/// The area that is left (m·rad) from the heel at rest.
struct Left;

impl Finding<1> for Left {
    type From<C: Calc> = At<C>;
    const NAMES: [&'static Symbol; 1] = *listed!(s: A_RES);

    fn map<C: Calc, D: Calc>(from: &At<C>, f: &mut dyn FnMut(C) -> D) -> At<D> {
        over(from, f)
    }

    fn find<C: Calc>((on, all, [heel, end]): &At<C>) -> Result<[C; 1], Fault> {
        let end = if heel.value() < 0.0 { -*end } else { *end };
        if heel.value().abs() >= end.value().abs() {
            return Err(beyond("under the load", *heel, end));
        }
        let mut heeled = Heeled::new(on, all, None);
        Ok([heeled.raised(end)?[0] - heeled.raised(*heel)?[0]])
    }
}

/// The refusal of a heel beyond the last that counts.
pub fn beyond<C: Calc>(when: &str, heel: C, end: C) -> Fault {
    Fault::outside(format!(
        "{when} the hull heels to {} or more, and areas count up to {}, phi_f or where an opening comes to the water; give less load or reach, other ballast, a greater \
         phi_f, or higher openings",
        s::PHI.written(heel.value()),
        s::PHI_F.written(end.value().abs()),
    ))
}

/// A_res = e(φ_f) − e(φ), in m·rad, all moments counted as levers times cos φ. [46 CFR 173, 173.020]
///
/// # Errors
/// A heel beyond φ_f.
pub fn residual<C: Scalar>(
    on: &Floating<C>,
    loaded: &Loaded<C>,
    posture: &Posture<C>,
    ends: &AreaEnds<C>,
) -> Result<C, Fault> {
    let [area] = found::<Left, C, 1>(&(on.clone(), loaded.all, [posture.heel(), ends.0[0]]))?;
    Ok(area)
}

/// Heel at rest (rad), both areas (m·rad) and the heel to which it rolls (rad).
struct Lost;

/// Nearer than this (rad) to the rest the roll is that of small angles.
const SMALL: f64 = 1e-5;
/// Of the heel (rad): one more step leaves the square of this over its distance from the rest.
const NEAR: f64 = 1e-11;

impl Finding<4> for Lost {
    type From<C: Calc> = At<C>;
    const NAMES: [&'static Symbol; 4] = *listed!(s: PHI_Q0, A_I, A_II, PHI_2);

    fn map<C: Calc, D: Calc>(from: &At<C>, f: &mut dyn FnMut(C) -> D) -> At<D> {
        over(from, f)
    }

    fn find<C: Calc>(from: &At<C>) -> Result<[C; 4], Fault> {
        swung(from, ["without its load", "when its load is lost"])
    }
}

/// From rest at a heel that is none: the heel of rest (rad), the areas (m·rad) that drive it there and stop it beyond, and the
/// heel to which it rolls (rad).
///
/// # Errors
/// None of rest, or a roll beyond the last heel.
#[inline(never)]
pub fn swung<C: Calc>((on, all, [from, end]): &At<C>, when: [&str; 2]) -> Result<[C; 4], Fault> {
    let Some(at) = rest(on, all, None, None) else {
        let what = format!(
            "M_T = {} at W = {}: {} the hull has no equilibrium; give less load, reach or wind, or other ballast",
            s::M_T.written(all.across.value()),
            s::W.written(all.weight.value()),
            when[0],
        );
        return Err(Fault::outside(what));
    };
    let rest = C::direction(C::constant(1.0), at[2]);
    let [low, _] = Lie::new(on, all, at).energy(at);
    let end = if from.value() < rest.value() { *end } else { -*end };
    if (end.value() - rest.value()) * end.value() <= 0.0 {
        return Err(beyond(when[0], rest, end));
    }
    let mut heeled = Heeled::new(on, all, Some(at.map(|x| x.value())));
    let high = heeled.raised(*from)?[0];
    let (drives, stops) = (high - low, heeled.raised(end)?[0] - low);
    let rolls = if (from.value() - rest.value()).abs() < SMALL {
        rest + rest - *from
    } else {
        let plain = (on.map(&mut |x| x.value()), all.map(&mut |x| x.value()));
        let (near, far) = (rest.value(), end.value());
        let mirrored = (2.0 * near - from.value()).max(near.min(far)).min(near.max(far));
        if stops.value() < drives.value() {
            return Err(beyond(when[1], end, end));
        }
        let mut tried = Heeled::new(&plain.0, &plain.1, Some(at.map(|x| x.value())));
        let heel = C::constant(bracketed([near, far], mirrored, NEAR, |heel| {
            let [rise, lever] = tried.raised(heel)?;
            Ok::<_, Fault>([high.value() - rise, -lever])
        })?);
        let [rise, lever] = heeled.raised(heel)?;
        heel + (high - rise) / lever
    };
    Ok([rest, drives, stops, rolls])
}

/// After a loss of load: heel at rest and that to which it rolls (rad), areas and what is left of them (m·rad).
#[derive(Clone, Copy, Debug)]
pub struct LoadLost<C> {
    found: [C; 4],
    left: C,
}
results! { LoadLost as l => { PHI_Q0: l.found[0]; A_I: l.found[1]; A_II: l.found[2]; PHI_2: l.found[3]; D_A: l.left; } }

impl<C: Scalar> LoadLost<C> {
    /// The hull without its load rolls from the heel under it to where the areas are alike; ΔA = A_II − k_A A_I − c_A.
    /// [46 CFR 173, 173.025]
    ///
    /// # Errors
    /// It rolls beyond φ_f.
    pub fn new(
        on: &Floating<C>,
        loaded: &Loaded<C>,
        posture: &Posture<C>,
        ends: &AreaEnds<C>,
        rule: &LossRule<C>,
    ) -> Result<LoadLost<C>, Fault> {
        let found = found::<Lost, C, 4>(&(on.clone(), loaded.bare, [posture.heel(), ends.0[1]]))?;
        let [_, drives, stops, _] = found;
        Ok(LoadLost {
            found,
            left: (stops - rule.k_a * drives - rule.c_a).def(&s::D_A),
        })
    }
}
