//! Stroke, bore, pump and buckling of the steering cylinders. [Zhang2016, 5.1-6]

use std::f64::consts::PI;

use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::number::short;
use crate::steering::cylinder::Mounting;
use crate::steering::limits::Limits;
use crate::steering::refusal::Refusal;
use crate::steering::symbols as s;

/// Bores of ISO 3320, in m. The standard itself has not been seen: eleven of the 24, from 50 to 320 mm, stand in a
/// maker's list of cylinders to ISO 6020-2, the others are not verified. Check it before use.
pub const BORES: [f64; 24] = [
    0.025, 0.032, 0.04, 0.05, 0.063, 0.08, 0.09, 0.1, 0.11, 0.125, 0.14, 0.16, 0.18, 0.2, 0.22, 0.25, 0.28, 0.32, 0.36,
    0.4, 0.45, 0.5, 0.56, 0.63,
];

/// An example of a list of strokes, in m, of no standard and of no maker, to be replaced by the maker's own.
pub const EXAMPLE_STROKES: [f64; 17] = [
    0.1, 0.125, 0.16, 0.2, 0.25, 0.32, 0.4, 0.5, 0.63, 0.7, 0.8, 0.9, 1.0, 1.25, 1.6, 2.0, 2.5,
];

quantities! {
    /// Oil supply: working pressure (Pa), speed (1/s) and volumetric efficiency of
    /// the pump, relief valve's pressure over the working pressure; Young's modulus
    /// (Pa) and safety factor of the rod against buckling.
    Hydraulics { p: P, n: N, eta: ETA_V, k_r: K_R, e: E, nu: NU }
}

/// Bore, in m, that pulls with `f_g` (N) at the pressure `p` (Pa) around a rod of
/// diameter `d` (m): D_g = √(4 f_g/(π p) + d²). [Zhang2016, 5.3]
pub fn bore<C: Calc>(f_g: C, p: C, d: C) -> C {
    let square = C::constant(4.0) * f_g / (C::constant(PI) * p) + d.square();
    square.sqrt().def(&s::D_G_MIN)
}

/// The first of a rising series that is not below `least`, in m.
pub fn next(series: &[f64], least: f64) -> Result<f64, Refusal> {
    series.iter().copied().find(|x| *x >= least).ok_or_else(|| {
        Refusal::new(
            "D_g",
            format!("D_g = {} mm or more", short(least * 1e3)),
            format!(
                "the series ends at {} mm: take a longer arm, a higher pressure or two cylinders",
                short(series.last().copied().unwrap_or(0.0) * 1e3)
            ),
        )
    })
}

/// Displacement of the pump, in m³ per turn, for a flow (m³/s) at `n` turns per second with volumetric efficiency `eta`.
pub fn pump<C: Calc>(flow: C, n: C, eta: C) -> C {
    (flow / (n * eta)).def(&s::V_P)
}

/// Power of a flow (m³/s) at the working pressure (Pa), in W: P_h = p q.
pub fn power<C: Calc>(flow: C, p: C) -> C {
    (p * flow).def(&s::P_H)
}

/// Pressure at which the relief valve opens, in Pa: the working pressure times a factor above 1.
pub fn relief<C: Calc>(p: C, k_r: C) -> C {
    (p * k_r).def(&s::P_R)
}

quantities! {
    /// A rod against buckling: Young's modulus (Pa), diameter and buckling length (m), safety factor.
    Rod { e: E, d: D, l_k: L_K, nu: NU }
}

/// The push, in N, that the rod bears with its safety against buckling: π³ E d⁴/(64 ν l_k²). (Euler)
pub fn buckling<C: Calc>(rod: &Rod<C>) -> C {
    let pi = C::constant(PI);
    let stiffness = pi * pi.square() * rod.e * rod.d.square().square();
    (stiffness / (C::constant(64.0) * rod.nu * rod.l_k.square())).def(&s::F_K)
}

/// Slenderness λ = 4 l_k/d of a round rod, and the critical stress π² E/λ² (Pa), up to which the steel must be elastic for
/// [`buckling`] to hold. (Euler)
pub fn slenderness<C: Calc>(rod: &Rod<C>) -> [C; 2] {
    let slenderness = (C::constant(4.0) * rod.l_k / rod.d).def(&s::LAMBDA);
    let stress = C::constant(PI).square() * rod.e / slenderness.square();
    [slenderness, stress.def(&s::SIGMA_E)]
}

/// The shortest of the `strokes` (m, rising) with which a cylinder covers its group's range. [Zhang2016, 5.1]
pub fn choose_stroke(
    cylinder: &Mounting<f64>,
    mirrored: bool,
    limits: &Limits,
    strokes: &[f64],
) -> Result<f64, Refusal> {
    let fits = |&l_x: &f64| {
        let cylinder = Mounting { l_x, ..*cylinder };
        let covered = cylinder.linkage(mirrored).over(limits);
        covered.is_ok_and(|e| {
            cylinder
                .stroke_margins(e.longest, e.shortest)
                .iter()
                .all(|margin| *margin >= 0.0)
        })
    };
    strokes.iter().copied().find(|l_x| fits(l_x)).ok_or_else(|| {
        Refusal::new(
            "l_x",
            format!(
                "no stroke up to {} m turns the group from {} to {} deg",
                short(strokes.last().copied().unwrap_or(0.0)),
                short(limits.min.to_degrees()),
                short(limits.max.to_degrees())
            ),
            format!(
                "with R_c = {} m: a shorter arm needs less stroke and more force",
                short(cylinder.r)
            ),
        )
    })
}
