//! Quantities of spreader and load as two bodies in motion.

pub use crate::kernel::gravity::G;
use crate::kernel::symbol::symbols;
pub use crate::parts::hanging::{L_R, PHI_R, S_R, X_Q, Y_Q};
pub use crate::sway::pendulum::{D_L_R, D_PHI_R, F_PHI, OMEGA_R, X_L};

symbols! {
    // States.
    PSI_S: "psi_s" "psi_\"s\"" RAD / DEG, "Angle of the slings from the vertical; positive where the load is ahead to the sea side.", "equations of motion";
    W_PHI: "w_phi" "w_phi" RAD_PER_S / DEG_PER_S, "Angular velocity of the sway less what hoisting gives it: it does not jump with the hoist's speed.", "equations of motion";
    W_PSI: "w_psi" "w_psi" RAD_PER_S / DEG_PER_S, "Angular velocity of the slings less what hoisting gives it: it does not jump with the hoist's speed.", "equations of motion";
    D_PSI_S: "der(psi_s)" "dot(psi)_\"s\"" RAD_PER_S / DEG_PER_S, "Rate of the slings' angle.", "state";
    D_W_PHI: "der(w_phi)" "dot(w)_phi" RAD_PER_S2 / RAD_PER_S2, "Rate of what hoisting leaves of the sway's angular velocity.", "Lagrange";
    D_W_PSI: "der(w_psi)" "dot(w)_psi" RAD_PER_S2 / RAD_PER_S2, "Rate of what hoisting leaves of the slings' angular velocity.", "Lagrange";

    // The four-bar.
    BETA_S: "beta_s" "beta_\"s\"" RAD / DEG, "Turn of the spreader by its ropes; positive as the sway.", "derived";
    BETA_S1: "beta_s1" "beta'_\"s\"" ONE / ONE, "Turn of the spreader over the sway.", "derived";
    BETA_S2: "beta_s2" "beta''_\"s\"" ONE / ONE, "Change of that over the sway.", "derived";
    R_M: "r_m" "r_\"m\"" M / M [positive], "Distance from the trolley's middle to the spreader's.", "derived";
    R_M1: "r_m1" "r'_\"m\"" M / M, "Change of that distance over the sway.", "derived";
    R_M2: "r_m2" "r''_\"m\"" M / M, "Change of that again.", "derived";
    G_1X: "g_1x" "g_(1 x)" M / M, "Travel of the spreader's centre of gravity over the sway, along the beam.", "derived";
    G_1Y: "g_1y" "g_(1 y)" M / M, "Travel of the spreader's centre of gravity over the sway, upward.", "derived";
    G_SX: "g_sx" "g_(\"s\" x)" M / M, "Travel of the slings' joint over the sway, along the beam.", "derived";
    G_SY: "g_sy" "g_(\"s\" y)" M / M, "Travel of the slings' joint over the sway, upward.", "derived";
    K_1X: "k_1x" "g'_(1 x)" M / M, "Change of the spreader's travel over the sway, along the beam.", "derived";
    K_1Y: "k_1y" "g'_(1 y)" M / M, "Change of the spreader's travel over the sway, upward.", "derived";
    K_SX: "k_sx" "g'_(\"s\" x)" M / M, "Change of the joint's travel over the sway, along the beam.", "derived";
    K_SY: "k_sy" "g'_(\"s\" y)" M / M, "Change of the joint's travel over the sway, upward.", "derived";
    P_HX: "p_hx" "p_x" ONE / ONE, "Travel of both bodies over the length of the ropes, along the beam.", "derived";
    P_HY: "p_hy" "p_y" ONE / ONE, "Travel of both bodies over the length of the ropes, upward.", "derived";
    P_H1X: "p_h1x" "p'_x" ONE / ONE, "Change of that over the sway, along the beam.", "derived";
    P_H1Y: "p_h1y" "p'_y" ONE / ONE, "Change of that over the sway, upward.", "derived";

    // Angular velocities.
    TAU_J: "tau_j" "tau_\"j\"" M / M, "Travel of the slings' joint over the sway, across the slings.", "derived";
    SIGMA_J: "sigma_j" "sigma_\"j\"" M / M, "Travel of the slings' joint over the sway, along the slings.", "derived";
    D_J: "d_j" "D_\"j\"" M2 / M2, "Inertia of the sway with slings that are free to turn, over the load's mass.", "Lagrange";
    ETA_1: "eta_1" "eta_1" PER_M / PER_M, "Part of the sway's angular velocity that the hoist gives it by a jump of its speed, over that.", "Lagrange";
    ETA_2: "eta_2" "eta_2" PER_M / PER_M, "Part of the slings' angular velocity that the hoist gives it by a jump of its speed, over that.", "Lagrange";
    OMEGA_PSI: "omega_psi" "omega_psi" RAD_PER_S / DEG_PER_S, "Angular velocity of the slings.", "equations of motion";

    // Rates.
    D_G_1X: "d_g_1x" "dot(g)_(1 x)" M_PER_S / M_PER_S, "Rate of the spreader's travel over the sway, along the beam.", "derived";
    D_G_1Y: "d_g_1y" "dot(g)_(1 y)" M_PER_S / M_PER_S, "Rate of the spreader's travel over the sway, upward.", "derived";
    D_G_SX: "d_g_sx" "dot(g)_(\"s\" x)" M_PER_S / M_PER_S, "Rate of the joint's travel over the sway, along the beam.", "derived";
    D_G_SY: "d_g_sy" "dot(g)_(\"s\" y)" M_PER_S / M_PER_S, "Rate of the joint's travel over the sway, upward.", "derived";
    U_1X: "u_1x" "u_(1 x)" M_PER_S / M_PER_S, "Speed that a jump of the hoist's would give the spreader, along the beam.", "Lagrange";
    U_1Y: "u_1y" "u_(1 y)" M_PER_S / M_PER_S, "Speed that a jump of the hoist's would give the spreader, upward.", "Lagrange";
    U_2X: "u_2x" "u_(2 x)" M_PER_S / M_PER_S, "Speed that a jump of the hoist's would give the load, along the beam.", "Lagrange";
    U_2Y: "u_2y" "u_(2 y)" M_PER_S / M_PER_S, "Speed that a jump of the hoist's would give the load, upward.", "Lagrange";
    Z_U: "z_u" "z_\"u\"" M_PER_S2 / M_PER_S2, "What the slings' turning makes of the load's speed by the hoist's jump, across the slings.", "Lagrange";
    A_T2: "a_t2" "a_\"q\"" M_PER_S2 / M_PER_S2, "What accelerates the load across its slings.", "Lagrange";

    A_N2: "a_n2" "a_\"n\"" M_PER_S2 / M_PER_S2, "What accelerates the load along its slings, toward the joint negative.", "Lagrange";
    Y_W: "y_w" "y_w" J_PER_KG / J_PER_KG, "What the sway asks for of the spreader, over its mass, without what hoisting gives.", "Lagrange";
    Y_U: "y_u" "y_\"u\"" J_PER_KG / J_PER_KG, "What hoisting gives the sway through the load, over the mass of the load.", "Lagrange";

    // Accelerations and pulls.
    B_1X: "b_1x" "b_(1 x)" M_PER_S2 / M_PER_S2, "Acceleration of the spreader that its pulls must give at steady angular velocities, along the beam.", "Newton and Euler";
    B_1Y: "b_1y" "b_(1 y)" M_PER_S2 / M_PER_S2, "Acceleration of the spreader, and against its weight, that its pulls must give at steady angular velocities, upward.", "Newton and Euler";
    B_SX: "b_sx" "b_(\"s\" x)" M_PER_S2 / M_PER_S2, "The same at the slings' joint, along the beam.", "Newton and Euler";
    B_SY: "b_sy" "b_(\"s\" y)" M_PER_S2 / M_PER_S2, "The same at the slings' joint, upward.", "Newton and Euler";
    Y_B: "y_b" "y_b" J_PER_KG / J_PER_KG, "What the sway asks for of the spreader at steady angular velocities, over its mass.", "Lagrange";
    B_N: "b_n" "b_\"n\"" M_PER_S2 / M_PER_S2, "Acceleration of the load along its slings that their pull must give at steady angular velocities.", "Newton and Euler";
    ALPHA_PHI: "alpha_phi" "alpha_phi" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the sway while the hoist keeps its speed.", "Lagrange";
    ALPHA_PSI: "alpha_psi" "alpha_psi" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the slings while the hoist keeps its speed.", "Lagrange";
    A_1X: "a_1x" "a_(1 x)" M_PER_S2 / M_PER_S2, "Acceleration of the spreader, along the beam.", "Newton and Euler";
    A_1Y: "a_1y" "a_(1 y)" M_PER_S2 / M_PER_S2, "Acceleration of the spreader, and against its weight, upward.", "Newton and Euler";
    N_S: "N_s" "N_\"s\"" N / KN, "Pull of the slings, all together.", "Newton and Euler";
    Y_M: "y_m" "y_\"m\"" J_PER_KG / J_PER_KG, "Moment about the middle of the spreader's joints that accelerates it, over its mass.", "Newton and Euler";
    M_P: "M_p" "M_\"p\"" N_M / KN_M, "Moment of the ropes about the middle of the spreader's joints.", "Newton and Euler";
    S_D: "S_d" "S_Delta" N / KN, "Pull of the sea side's ropes less that of the land side's, along the line of their middles.", "Newton and Euler";
    S_S1: "S_s1" "S_(\"s\" 1)" N / KN, "Pull of a rope on the sea side in motion.", "Newton and Euler";
    S_S2: "S_s2" "S_(\"s\" 2)" N / KN, "Pull of a rope on the land side in motion.", "Newton and Euler";
    Z_SLINGS: "z.slings" "z_1" N / KN, "Falls below zero where the slings would have to push: there this motion ends.", "event";
    Z_SEA: "z.sea" "z_2" N / KN, "Falls below zero where the sea side's ropes would have to push: there this motion ends.", "event";
    Z_LAND: "z.land" "z_3" N / KN, "Falls below zero where the land side's ropes would have to push: there this motion ends.", "event";
}
