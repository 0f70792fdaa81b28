//! Equivalent loads of the ring, and its static safety by the maker's load curve. [Rothe Erde]

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::parts::load_curve::LoadCurve;
use crate::supports::ring::symbols as s;
use crate::supports::upper::load::SupportLoad;

/// What a point of the load curve is called.
const POINT: [&Symbol; 2] = [&s::F_CURVE, &s::M_CURVE];

quantities! {
    /// How forces and moment make equivalent ones, and by what these are raised.
    Equivalent { k_v: K_V, k_r: K_R, k_m: K_M, f_st: F_ST }
}

/// Equivalent and reference loads of a case (N, N·m), static safety, and use of the load curve.
#[derive(Clone, Copy, Debug)]
pub struct StaticLoad<C> {
    equivalent: [C; 2],
    reference: [C; 2],
    safety: C,
    used: C,
}
results! { each StaticLoad as l => {
    F_E: l.equivalent[0];
    M_E: l.equivalent[1];
    F_REF: l.reference[0];
    M_REF: l.reference[1];
    S_0: l.safety;
    U_ST: l.used;
} }

/// F_e = k_v V + k_r H, M_e = k_m M; F_st = f_st F_e, M_st = f_st M_e; S_0 to the load curve, u_st = f_st / S_0.
///
/// # Errors
/// A load curve without points.
pub fn static_loads<C: Calc>(
    curve: &LoadCurve,
    by: &Equivalent<C>,
    loads: &[SupportLoad<C>],
    room: &mut Vec<StaticLoad<C>>,
) -> Result<(), Fault> {
    room.clear();
    for (at, load) in loads.iter().enumerate() {
        let one = || {
            let force = (by.k_v * load.vertical + by.k_r * load.horizontal).def(&s::F_E);
            let moment = (by.k_m * load.moment).def(&s::M_E);
            let reference = [(by.f_st * force).def(&s::F_REF), (by.f_st * moment).def(&s::M_REF)];
            let safety = curve.growth(force, moment, POINT)?.def(&s::S_0);
            Some(StaticLoad {
                equivalent: [force, moment],
                reference,
                safety,
                used: (by.f_st / safety).def(&s::U_ST),
            })
        };
        let found = C::body(at, one);
        room.push(found.ok_or_else(|| Fault::new("a load curve without points"))?);
    }
    Ok(())
}
