//! Righting levers at heels, beside their wall-sided form, and areas under them.

use crate::afloat::hull::Floating;
use crate::afloat::loaded::Loaded;
use crate::afloat::rest::{Lie, rest};
use crate::afloat::symbols as s;
use crate::afloat::upright::Upright;
use crate::afloat::weights::Weighed;
use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;

quantities! {
    /// A heel at which the righting lever is told.
    ToldHeel { phi_h: PHI_H }
}

/// What floats, as it weighs, and one or two angles.
pub type At<C> = (Floating<C>, Weighed<C>, [C; 2]);

/// The same over another scalar.
#[inline(never)]
pub fn over<C: Calc, D: Calc>((on, all, angles): &At<C>, f: &mut dyn FnMut(C) -> D) -> At<D> {
    (on.map(f), all.map(f), angles.map(f))
}

fn slope<C: Calc>(heel: C) -> C {
    let (sin, cos) = heel.sin_cos();
    sin / cos
}

/// What floats at heels that are held, the trim free: each looked for from the one before.
pub struct Heeled<'a, C> {
    on: &'a Floating<C>,
    all: &'a Weighed<C>,
    near: Option<[f64; 3]>,
}

impl<'a, C: Calc> Heeled<'a, C> {
    /// Looked for first from where it lies nearby: draft (m) and slopes.
    pub fn new(on: &'a Floating<C>, all: &'a Weighed<C>, near: Option<[f64; 3]>) -> Heeled<'a, C> {
        Heeled { on, all, near }
    }

    /// Draft (m) and slopes at a heel (rad).
    ///
    /// # Errors
    /// It does not come to rest.
    #[inline(never)]
    pub fn lies(&mut self, heel: C) -> Result<[C; 3], Fault> {
        let held = Some(slope(heel));
        let near = self.near.and_then(|near| rest(self.on, self.all, held, Some(near)));
        let found = near.or_else(|| rest(self.on, self.all, held, None)).ok_or_else(|| {
            Fault::outside(format!(
                "at a heel of {} with W = {} the hull finds no trim; keep to smaller heels",
                s::PHI.written(heel.value()),
                s::W.written(self.all.weight.value()),
            ))
        })?;
        self.near = Some(found.map(|x| x.value()));
        Ok(found)
    }

    /// Rise of the centre of gravity over that of buoyancy (m) at a heel (rad), and the righting lever (m).
    ///
    /// # Errors
    /// It does not come to rest.
    #[inline(never)]
    pub fn raised(&mut self, heel: C) -> Result<[C; 2], Fault> {
        let at = self.lies(heel)?;
        Ok(Lie::new(self.on, self.all, at).energy(at))
    }
}

/// Lever (m) and area (m·rad) at a heel.
struct Righting;

impl Finding<2> for Righting {
    type From<C: Calc> = At<C>;
    const NAMES: [&'static Symbol; 2] = *listed!(s: GZ, E);

    fn map<C: Calc, D: Calc>(from: &At<C>, f: &mut dyn FnMut(C) -> D) -> At<D> {
        over(from, f)
    }

    fn find<C: Calc>((on, all, [heel, upright]): &At<C>) -> Result<[C; 2], Fault> {
        let mut heeled = Heeled::new(on, all, None);
        let [high, lever] = heeled.raised(*heel)?;
        let [low, _] = heeled.raised(*upright)?;
        Ok([lever, high - low])
    }
}

/// Righting lever (m) and area under it (m·rad), and both by the wall-sided form.
#[derive(Clone, Copy, Debug)]
pub struct RightingLever<C> {
    own: [C; 2],
    walls: [C; 2],
}
results! { each RightingLever as l => { GZ: l.own[0]; E: l.own[1]; GZ_W: l.walls[0]; E_W: l.walls[1]; } }

/// GZ_w = (GM + BM tan² φ/2) sin φ, e_w = GM (1 − cos φ) + (BM/2)(1/cos φ + cos φ − 2). [Ports001, 7.3]
///
/// # Errors
/// It does not come to rest.
pub fn levers<C: Scalar>(
    on: &Floating<C>,
    loaded: &Loaded<C>,
    upright: &Upright<C>,
    heels: &[ToldHeel<C>],
    room: &mut Vec<RightingLever<C>>,
) -> Result<(), Fault> {
    room.clear();
    let (one, two, zero) = (C::constant(1.0), C::constant(2.0), C::constant(0.0));
    let all = Weighed {
        across: zero,
        ..loaded.all
    };
    for (at, heel) in heels.iter().enumerate() {
        let lever = C::body(at, || {
            let own = found::<Righting, C, 2>(&(on.clone(), all, [heel.phi_h, zero]))?;
            let (sin, cos) = heel.phi_h.sin_cos();
            let ([height, _], half) = (upright.height, upright.radius[0] / two);
            let lever = (height + half * (sin / cos).square()) * sin;
            let area = height * (one - cos) + half * (one / cos + cos - two);
            Ok::<_, Fault>(RightingLever {
                own,
                walls: [lever.def(&s::GZ_W), area.def(&s::E_W)],
            })
        })?;
        room.push(lever);
    }
    Ok(())
}
