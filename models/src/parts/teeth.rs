//! Stresses of teeth that touch at the pitch point.

use std::f64::consts::{FRAC_PI_4, TAU};

use crate::kernel::calc::Calc;
use crate::kernel::symbol::{Range, symbols};

symbols! {
    K_F: "K_F" "K_F" ONE / ONE [positive], "Load factor of the teeth: what the greatest force of one tooth is over that of the drive.", "[Ports001, 5.8]";
    Y_F: "Y_F" "Y_F" ONE / ONE [positive], "Form factor of the weaker teeth.", "[Ports001, 5.8]";
    M_T: "m_t" "m_t" M / MM [positive], "Module of the teeth.", "input";
    ALPHA_T: "alpha_t" "alpha_t" RAD / DEG [within(Range::new(0.0, FRAC_PI_4).above())], "Pressure angle of the teeth.", "input";
    E_T: "E_t" "E_t" PA / MPA [positive], "Young's modulus of the teeth.", "[Ports001, 5.8]";
    NU_T: "nu_t" "nu_t" ONE / ONE [within(Range::new(0.0, 0.5))], "Poisson's ratio of the teeth.", "[Ports001, 5.8]";
    RHO_C: "rho_c" "rho_c" M / MM, "Radius of curvature of the teeth against each other at the pitch point.", "[Ports001, 5.8]";
}

/// One tooth carries the force (N) with a load factor: K F Y / (b m), in Pa, by its form factor, width and module (m). (Lewis)
pub fn bending<C: Calc>(factor: C, force: C, form: C, [width, module]: [C; 2]) -> C {
    factor * force * form / (width * module)
}

/// Of two cylinders, of which the force across the flank is F / cos α: √(K F E / (2π (1 − ν²) b ρ cos α)), in Pa, by the force
/// (N) above zero, Young's modulus (Pa) and Poisson's ratio, width and radius of curvature (m). (Hertz)
pub fn contact<C: Calc>(factor: C, force: C, [e, nu]: [C; 2], [width, radius]: [C; 2], alpha: C) -> C {
    let stiff = e / (C::constant(TAU) * (C::constant(1.0) - nu.square()));
    let line = width * radius * alpha.sin_cos().1;
    (factor * force * stiff / line).sqrt()
}
