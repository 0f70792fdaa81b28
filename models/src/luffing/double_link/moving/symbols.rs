//! Quantities of the double link in motion, with those of any luffing mechanism.

use crate::kernel::symbol::{Symbol, symbols};
use crate::luffing::double_link::symbols as g;
pub use crate::luffing::moving::symbols::*;
use crate::luffing::moving::symbols::{OfCentre, OfSums};

symbols! {
    // Given.
    J_1: "J_1" "J_1" KG_M2 / T_M2 [not_negative], "Inertia of the boom about its centre of gravity.", "input";
    J_2: "J_2" "J_2" KG_M2 / T_M2 [not_negative], "Inertia of the jib about its centre of gravity.", "input";
    J_3: "J_3" "J_3" KG_M2 / T_M2 [not_negative], "Inertia of the rocker about its centre of gravity.", "input";
    MASS_1: "mass_1" "m_1" KG / T, "Mass of the boom: weight over g.", "derived";
    MASS_2: "mass_2" "m_2" KG / T, "Mass of the jib, with the load where it hangs on no rope: weight over g.", "derived";
    MASS_3: "mass_3" "m_3" KG / T, "Mass of the rocker: weight over g.", "derived";
    J_2Q: "J_2Q" "J_(2 Q)" KG_M2 / T_M2, "Inertia of the jib with the load about their common centre of gravity.", "derived";
    DX_1: "dx_1" "x'_1" M / M, "Forward travel of the boom's centre of gravity for one radian of the driving link.", "dual numbers";
    DY_1: "dy_1" "y'_1" M / M, "Rise of the boom's centre of gravity for one radian of the driving link.", "dual numbers";
    DDX_1: "ddx_1" "x''_1" M / M, "Change of the forward travel of the boom's centre of gravity for one radian of the driving link.", "dual numbers";
    DDY_1: "ddy_1" "y''_1" M / M, "Change of the rise of the boom's centre of gravity for one radian of the driving link.", "dual numbers";
    DX_2: "dx_2" "x'_2" M / M, "Forward travel of the jib's centre of gravity for one radian of the driving link.", "dual numbers";
    DY_2: "dy_2" "y'_2" M / M, "Rise of the jib's centre of gravity for one radian of the driving link.", "dual numbers";
    DDX_2: "ddx_2" "x''_2" M / M, "Change of the forward travel of the jib's centre of gravity for one radian of the driving link.", "dual numbers";
    DDY_2: "ddy_2" "y''_2" M / M, "Change of the rise of the jib's centre of gravity for one radian of the driving link.", "dual numbers";
    DX_3: "dx_3" "x'_3" M / M, "Forward travel of the rocker's centre of gravity for one radian of the driving link.", "dual numbers";
    DY_3: "dy_3" "y'_3" M / M, "Rise of the rocker's centre of gravity for one radian of the driving link.", "dual numbers";
    DDX_3: "ddx_3" "x''_3" M / M, "Change of the forward travel of the rocker's centre of gravity for one radian of the driving link.", "dual numbers";
    DDY_3: "ddy_3" "y''_3" M / M, "Change of the rise of the rocker's centre of gravity for one radian of the driving link.", "dual numbers";
    I_R1: "I_r1" "I_1" KG_M2 / T_M2, "Inertia of the boom, reduced to the driving link.", "Lagrange";
    DI_R1: "dI_r1" "I'_1" KG_M2 / T_M2, "Change of the boom's reduced inertia for one radian of the driving link.", "Lagrange";
    I_R2: "I_r2" "I_2" KG_M2 / T_M2, "Inertia of the jib, reduced to the driving link.", "Lagrange";
    DI_R2: "dI_r2" "I'_2" KG_M2 / T_M2, "Change of the jib's reduced inertia for one radian of the driving link.", "Lagrange";
    I_R3: "I_r3" "I_3" KG_M2 / T_M2, "Inertia of the rocker, reduced to the driving link.", "Lagrange";
    DI_R3: "dI_r3" "I'_3" KG_M2 / T_M2, "Change of the rocker's reduced inertia for one radian of the driving link.", "Lagrange";
    F_1X: "F_1.x" "F_(1 x)" N / KN, "Inertia of the boom, forward.", "Newton and Euler";
    F_1Y: "F_1.y" "F_(1 y)" N / KN, "Weight and inertia of the boom, upward.", "Newton and Euler";
    F_2X: "F_2.x" "F_(2 x)" N / KN, "Inertia of the jib, forward. With the load where it hangs on no rope.", "Newton and Euler";
    F_2Y: "F_2.y" "F_(2 y)" N / KN, "Weight and inertia of the jib, upward. With the load where it hangs on no rope.", "Newton and Euler";
    F_3X: "F_3.x" "F_(3 x)" N / KN, "Inertia of the rocker, forward.", "Newton and Euler";
    F_3Y: "F_3.y" "F_(3 y)" N / KN, "Weight and inertia of the rocker, upward.", "Newton and Euler";
    M_I1: "M_i1" "M_(i 1)" N_M / KN_M, "Moment of the boom's weight and inertia, and of the balance, about O1; clockwise positive.", "Newton and Euler";
    M_I3: "M_i3" "M_(i 3)" N_M / KN_M, "Moment of the rocker's weight and inertia about O3; clockwise positive.", "Newton and Euler";
    M_IB: "M_iB" "M_(i B)" N_M / KN_M, "Moment of the rope and of the jib's weight and inertia about B; clockwise positive.", "Newton and Euler";
    M_IC: "M_iC" "M_(i C)" N_M / KN_M, "Moment of the rope and of the jib's weight and inertia about C; counter-clockwise positive.", "Newton and Euler";
    R_2QX: "R_2Q.x" "x_(2 Q)" M / M, "Centre of gravity of the jib with the load, from B, forward.", "derived";
    R_2QY: "R_2Q.y" "y_(2 Q)" M / M, "Centre of gravity of the jib with the load, from B, upward.", "derived";
    DI_1: "di_1" "i'_1" ONE / ONE, "Change of the boom's ratio of angular velocities for one radian of the driving link.", "dual numbers";
    J_XY1: "J_xy1" "J_(x y 1)" KG_M2 / T_M2, "Product of inertia of the boom about its centre of gravity, forward and upward.", "derived";
    X_S1: "x_s1" "x_(s 1)" M / M, "Centre of gravity of the boom, forward of the slewing axis.", "derived";
    DI_2: "di_2" "i'_2" ONE / ONE, "Change of the jib's ratio of angular velocities for one radian of the driving link.", "dual numbers";
    J_XI2: "J_xi2" "J_(xi 2)" KG_M2 / T_M2, "Mass of the jib, with a load that is fixed to it, times squares of distances from its centre of gravity, along the rear arm BC.", "derived";
    J_XIETA2: "J_xieta2" "J_(xi eta 2)" KG_M2 / T_M2, "The same with the product of the distances along the rear arm BC and to its left.", "derived";
    J_ETA2: "J_eta2" "J_(eta 2)" KG_M2 / T_M2, "The same with squares of distances to the left of the rear arm BC.", "derived";
    J_XY2: "J_xy2" "J_(x y 2)" KG_M2 / T_M2, "Product of inertia of the jib about its centre of gravity, forward and upward.", "derived";
    X_S2: "x_s2" "x_(s 2)" M / M, "Centre of gravity of the jib, forward of the slewing axis.", "derived";
    DI_3: "di_3" "i'_3" ONE / ONE, "Change of the rocker's ratio of angular velocities for one radian of the driving link.", "dual numbers";
    J_XY3: "J_xy3" "J_(x y 3)" KG_M2 / T_M2, "Product of inertia of the rocker about its centre of gravity, forward and upward.", "derived";
    X_S3: "x_s3" "x_(s 3)" M / M, "Centre of gravity of the rocker, forward of the slewing axis.", "derived";
    D_THETA_1: "der(theta_1)" "dot(theta)_1" RAD_PER_S / DEG_PER_S, "Rate of the boom's angle.", "state";
    D_OMEGA_1: "der(omega_1)" "dot(omega)_1" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the boom.", "equations of motion";
    D_THETA_3: "der(theta_3)" "dot(theta)_3" RAD_PER_S / DEG_PER_S, "Rate of the rocker's angle.", "state";
    D_OMEGA_3: "der(omega_3)" "dot(omega)_3" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the rocker.", "equations of motion";
}

/// What the equations of motion have for each body.
pub(crate) struct OfBody {
    pub sums: OfSums,
    pub centre: OfCentre,
    /// Centre of gravity from the bar's first joint.
    pub place: [&'static Symbol; 2],
    /// Turning, and how that changes.
    pub ratio: &'static Symbol,
    pub ratio_change: &'static Symbol,
    /// Of a crane that slews: product of inertia, and centre of gravity from the axis.
    pub deviation: &'static Symbol,
    pub reach: &'static Symbol,
}

/// Boom, jib and rocker.
pub(crate) static OF_BODY: [OfBody; 3] = [
    OfBody {
        sums: OfSums {
            mass: &MASS_1,
            inertia: &I_R1,
            slope: &DI_R1,
        },
        centre: [[&DX_1, &DY_1], [&DDX_1, &DDY_1]],
        place: [&g::R_1X, &g::R_1Y],
        ratio: &g::I_1,
        ratio_change: &DI_1,
        deviation: &J_XY1,
        reach: &X_S1,
    },
    OfBody {
        sums: OfSums {
            mass: &MASS_2,
            inertia: &I_R2,
            slope: &DI_R2,
        },
        centre: [[&DX_2, &DY_2], [&DDX_2, &DDY_2]],
        place: [&g::R_2X, &g::R_2Y],
        ratio: &g::I_2,
        ratio_change: &DI_2,
        deviation: &J_XY2,
        reach: &X_S2,
    },
    OfBody {
        sums: OfSums {
            mass: &MASS_3,
            inertia: &I_R3,
            slope: &DI_R3,
        },
        centre: [[&DX_3, &DY_3], [&DDX_3, &DDY_3]],
        place: [&g::R_3X, &g::R_3Y],
        ratio: &g::I_3,
        ratio_change: &DI_3,
        deviation: &J_XY3,
        reach: &X_S3,
    },
];
