//! Quantities of any luffing mechanism in motion.

use std::f64::consts::FRAC_PI_6;

pub use crate::kernel::gravity::G;
use crate::kernel::symbol::{Range, Symbol, symbols};
pub use crate::luffing::resistances::symbols::{DDS_S, DS_S, DX_H, DY_H, V_CA, W_GX, W_GY};
pub use crate::parts::air::{
    A_AIR_X, A_AIR_Y, A_AIR_Z, CHI_AIR, DELTA_AIR, F_AIR, KAPPA_AIR, P_AIR, RHO_AIR, U_AIR, U_AIR_X, U_AIR_Y, U_AIR_Z,
    V_AIR, W_AIR,
};
pub use crate::parts::ground::{H_G, N_G, Y_G, Z_GROUND};
pub use crate::parts::hanging::{
    A_N, A_R, ALPHA_0, ALPHA_0SL, B_X, B_Y, B_Z, D_V_QX, D_V_QY, D_V_QZ, D_X_Q, D_Y_Q, D_Z_Q, H_1R, H_2R, KAPPA_R, L_R,
    MASS_E, N_X, N_Y, N_Z, PHI_R, R_QX, S_Q, S_R, U_X, U_Y, V_E, V_QX, V_QY, V_QZ, W_X, W_Y, W_Z, X_Q, Y_Q, Z_Q,
    Z_ROPE,
};
pub use crate::parts::hydraulics::symbols::{DP_LH, I_LH, K_AC, P_AC, P_LH, P_PMAX, P_TANK, Q_PMAX, X_T, Y_B1, Y_B2};
pub use crate::parts::side_wind::{A_WS, M_WS, P_WS, R_WS};
pub use crate::parts::slope::{G_S, G_U, GAMMA_S, M_GAMMA, R_U};
pub use crate::parts::turntable::{
    C_SL, CHI_R, D_OMEGA_SL, D_PSI_SL, J_SL, M_B_SL, M_F_SL, M_R_SL, M_SL, OMEGA_SL, PSI_MAX, PSI_MIN, PSI_SL,
    Z_SL_HIGH, Z_SL_LOOSE, Z_SL_LOW, Z_SL_REST,
};

symbols! {
    // Given.
    C_V: "c_v" "c_v" N_M_S / KN_M_S [not_negative], "Viscous friction at the driving link: moment over angular velocity.", "input";
    M_F: "M_F" "M_F" N_M / KN_M [not_negative], "Dry friction at the driving link: the moment that it holds, and that it sets against motion.", "input";
    STEP: "step" "h" S / MS [positive], "Longest step of the solver. An explicit one is refused where the motion changes by more than itself within it.", "input";

    L_MIN: "l_min" "l_min" M / M [positive], "Length of the cylinder retracted, between its anchors.", "input";
    L_MAX: "l_max" "l_max" M / M [positive], "Length of the cylinder extended, between its anchors.", "input";
    V_0: "V_0" "V_0" M3 / L [positive], "Oil left in a chamber at the piston's end.", "input";
    V_1: "V_1" "V_1" M3 / L [positive], "Oil in each port of the valve.", "input";
    Q_N: "Q_N" "Q_N" M3_PER_S / L_PER_MIN [positive], "Rated flow of the valve, fully open.", "input";
    DP_N: "dp_N" "Delta p_N" PA / MPA [positive], "Pressure difference over one edge of the valve at the rated flow.", "input";
    DP_L: "dp_L" "Delta p_L" PA / MPA [positive], "Pressure difference over each line from valve to cylinder at the rated flow.", "input";
    BETA_E: "beta_E" "beta_E" PA / MPA [positive], "Bulk modulus of the oil with its walls.", "input";
    P_R: "p_R" "p_R" PA / MPA [positive], "Opening pressure of the relief valves.", "input";
    K_R: "k_R" "k_R" M3_PER_SPA / L_PER_MINMPA [not_negative], "Flow of a relief valve over the excess of pressure.", "input";
    K_L: "k_L" "k_L" M3_PER_SPA / L_PER_MINMPA [not_negative], "Leakage past the piston over the difference of pressure.", "input";
    OMEGA_V: "omega_v" "omega_v" RAD_PER_S / RAD_PER_S [positive], "Natural frequency of the valve's spool.", "input";
    ZETA_V: "zeta_v" "zeta_v" ONE / ONE [not_negative], "Damping ratio of the valve's spool.", "input";
    TOL: "tol" "epsilon" ONE / ONE [tolerance], "Relative tolerance of the implicit solver.", "input";

    // Commands.
    U_V: "u_v" "u_v" ONE / ONE, "Command of the valve from -1 to 1; positive lengthens the cylinder.", "input";
    P_P: "p_P" "p_P" PA / MPA [not_negative], "Pressure of the pump above the tank's.", "input";
    M_A: "M_A" "M_A" N_M / KN_M, "Moment of the drive on the driving link; positive turns it counter-clockwise.", "input";
    M_S: "M_S" "M_S" N_M / KN_M [not_negative], "Moment of the brake, added to the dry friction.", "input";
    U_BR: "u_br" "u_\"br\"" ONE / ONE [within(Range::new(0.0, 1.0))], "Command of the brakes on the motor's shaft: from one half on they are called, and each acts after its delay; below, all are lifted at once.", "input";
    P_WM: "p_wm" "p_\"wm\"" PA / PA, "Pressure of the wind on the areas of the bodies in motion; positive from the rear.", "[Ports001, 5.5.4]";
    V_WM: "v_wm" "v_\"wm\"" M_PER_S / M_PER_S [from_to(-70.0, 70.0)], "Wind speed at the bodies in motion, whose pressure adds to the given one; positive from the rear.", "[Ports001, 5.5.4]";
    SIGMA_M: "sigma_m" "sigma_\"m\"" RAD / DEG [within(Range::new(-FRAC_PI_6, FRAC_PI_6))], "Slope of the ground in motion; positive where the front is lower.", "input";
    N_SM: "n_sm" "n_\"sm\"" PER_S / PER_MIN [from_to(-0.5, 0.5)], "Speed at which the crane is slewed in motion, whatever that takes.", "input";
    T_S: "t_s" "t_s" S / S [positive], "Time in which drives come up to their speed, and stop, in the manoeuvres of the book.", "input";
    V_H: "v_h" "v_h" M_PER_S / M_PER_S, "Speed of the hoist rope at the head as commanded; positive lowers the load.", "input";
    A_H: "a_h" "a_h" M_PER_S2 / M_PER_S2 [positive], "Acceleration with which the hoist comes up to its command; without it a change of the command is a blow.", "input";

    // A hoist with its rope, given.
    C_R: "c_R" "c_R" N_PER_M / KN_PER_M [positive], "Stiffness of the rope from head to load: force over stretch.", "input";
    D_R: "d_R" "d_R" N_S_PER_M / KN_S_PER_M [not_negative], "Damping of the rope from head to load: force over the rate of its stretch.", "input";
    J_H: "J_h" "J_h" KG_M2 / KG_M2 [positive], "Inertia of the hoist's drum, and of all that turns with it, at the drum.", "input";
    R_H: "r_h" "r_h" M / MM [positive], "Radius of the hoist's drum, at the middle of its rope.", "input";
    M_H: "m_h" "m_h" ONE / ONE [positive], "Falls of the hoist tackle: how many times faster the rope runs at the drum than from the head.", "input";
    M_F_H: "M_Fh" "M_\"F h\"" N_M / KN_M [not_negative], "Dry friction of the hoist's drum: the moment that it holds, and that it sets against motion.", "input";
    M_M_H: "M_Mh" "M_(M h)" N_M / KN_M, "Moment of the hoist's motor on its drum; positive lifts the load.", "input";
    M_B_H: "M_Bh" "M_\"B h\"" N_M / KN_M [not_negative], "Moment of the hoist's brake on its drum, added to its dry friction.", "input";

    // States.
    OMEGA_R: "omega_R" "omega_R" RAD_PER_S / DEG_PER_S, "Angular velocity of the rope.", "equations of motion";
    V_Q: "v_Q" "v_Q" M_PER_S / M_PER_S, "Speed of the load away from the head.", "equations of motion";
    V_R: "v_R" "v_R" M_PER_S / M_PER_S, "Speed at which the hoist pays out the rope; positive lowers the load.", "equations of motion";

    DELTA_L: "delta_l" "delta_l" M / MM [not_negative], "Slack of the luffing tackle: how much longer its rope would let it be between its anchors; zero where it is taut.", "equations of motion";
    V_TL: "v_tl" "v_\"tl\"" M_PER_S / M_PER_S, "Speed at which the drum of the slack luffing tackle lets it grow longer; zero where it is taut.", "equations of motion";

    P_1: "p_1" "p_1" PA / MPA, "Pressure in the valve's port on the side of the bore.", "equations of motion";
    P_2: "p_2" "p_2" PA / MPA, "Pressure in the valve's port on the side of the annulus.", "equations of motion";
    P_A: "p_A" "p_A" PA / MPA, "Pressure in the chamber of the bore.", "equations of motion";
    P_B: "p_B" "p_B" PA / MPA, "Pressure in the chamber of the annulus.", "equations of motion";
    X_V: "x_v" "x_v" ONE / ONE, "Spool of the valve, from -1 to 1 of its stroke.", "equations of motion";
    V_V: "v_v" "v_v" PER_S / PER_S, "Speed of the valve's spool, over its stroke.", "equations of motion";

    // Results.
    F_C: "F_c" "F_c" N / KN, "Force of the cylinder by its pressures; push positive.", "equations of motion";
    M_R: "M_R" "M_R" N_M / KN_M, "Moment of friction, brake and end stop on the driving link; positive turns it counter-clockwise.", "equations of motion";
    M_R_H: "M_Rh" "M_\"R h\"" N_M / KN_M, "Moment of brake and friction on the hoist's drum; positive reels in.", "equations of motion";
    P_ML: "P_Ml" "P_\"M l\"" W / KW, "Power of the luffing motor: on the driving link while the tackle is taut, on its drum while that is slack.", "virtual work";
    P_BL: "P_bl" "P_\"b l\"" W / KW, "Power that the brakes of luffing take on the drum of the slack tackle; zero where it is taut.", "virtual work";
    MASS_TL: "mass_tl" "m_\"tl\"" KG / T, "Mass of the motor's shaft and its drum, as the luffing tackle feels it between its anchors.", "Lagrange";
    DELTA_R: "delta_R" "delta_R" M / MM, "Stretch of the rope.", "derived";
    D_DELTA_R: "ddelta_R" "dot(delta)_R" M_PER_S / M_PER_S, "Rate of the rope's stretch.", "derived";
    S_RD: "S_Rd" "S_(R d)" N / KN, "Force of the rope's damping: what the rope's force has beside that of its stiffness; where the rope has let go with a stretch left in it, the force of its stiffness with the opposite sign.", "derived";
    MASS_H: "mass_h" "m_\"h red\"" KG / T, "Mass of the hoist's drum and of all that turns with it, as the rope at the head feels it.", "derived";

    // The equations of motion, from derivatives of the positions by the driving angle.
    MASS_5: "mass_5" "m_5" KG / T, "Mass of the counterweight: weight over g.", "derived";
    DX_5: "dx_5" "x'_5" M / M, "Forward travel of the counterweight's centre of gravity for one radian of the driving link.", "dual numbers";
    DY_5: "dy_5" "y'_5" M / M, "Rise of the counterweight's centre of gravity for one radian of the driving link.", "dual numbers";
    DDX_5: "ddx_5" "x''_5" M / M, "Change of the forward travel of the counterweight's centre of gravity for one radian of the driving link.", "dual numbers";
    DDY_5: "ddy_5" "y''_5" M / M, "Change of the rise of the counterweight's centre of gravity for one radian of the driving link.", "dual numbers";
    I_R5: "I_r5" "I_5" KG_M2 / T_M2, "Inertia of the counterweight, reduced to the driving link.", "Lagrange";
    DI_R5: "dI_r5" "I'_5" KG_M2 / T_M2, "Change of the counterweight's reduced inertia for one radian of the driving link.", "Lagrange";
    DY_Q: "dY_Q" "y'_Q" M / M, "Rise of the load for one radian of luffing, the hoist drum at rest.", "[Ports001, 5.2.3]";
    DDY_Q: "ddY_Q" "y''_Q" M / M, "Change of the load's rise for one radian of luffing.", "derived";
    DL_R: "dl_R" "l'_R" M / M, "Rope that one radian of luffing adds between head and load, the hoist drum at rest.", "[Ports001, 5.2.3.1]";
    DDL_R: "ddl_R" "l''_R" M / M, "Change of that for one radian of luffing.", "derived";
    I_RQ: "I_rQ" "I_Q" KG_M2 / T_M2, "Inertia of the load, reduced to the luffing angle.", "Lagrange";
    DI_RQ: "dI_rQ" "I'_Q" KG_M2 / T_M2, "Change of the load's reduced inertia for one radian of luffing.", "Lagrange";
    I_R: "I_r" "I" KG_M2 / T_M2, "Inertia of all bars and the counterweight, reduced to the driving link.", "Lagrange";
    DI_R: "dI_r" "I'" KG_M2 / T_M2, "Change of the reduced inertia for one radian of the driving link.", "Lagrange";
    M_W: "M_W" "M_W" N_M / KN_M, "Moment of the weights of bars and counterweight about the foot of the driving link; positive lowers it.", "virtual work";
    P_WI: "p_wi" "p_\"w\"" PA / PA, "Pressure of the wind on the bodies, by pressure and speed; positive from the rear.", "[Ports001, 5.5.4]";
    M_WIND: "M_wind" "M_\"w\"" N_M / KN_M, "Moment of the wind on the bodies for one radian of the driving link; positive turns it counter-clockwise.", "virtual work";
    M_SLOPE: "M_slope" "M_sigma" N_M / KN_M, "Moment of weights by the slope for one radian of the driving link, with that of a load that hangs on no rope; positive turns it counter-clockwise.", "virtual work";
    OMEGA_SM: "Omega_sm" "Omega_\"sm\"" RAD_PER_S / DEG_PER_S, "Angular velocity at which the crane is slewed.", "derived";
    M_OMEGA: "M_Omega" "M_Omega" N_M / KN_M, "Moment of the bodies' centrifugal forces for one radian of the driving link, with that of a load that hangs on no rope; positive turns it counter-clockwise.", "virtual work";
    M_WO: "M_Wo" "M_\"Wo\"" N_M / KN_M, "Moment of the weights less those of wind and slope; positive lowers the driving link.", "virtual work";
    M_WC: "M_Wc" "M_\"Wc\"" N_M / KN_M, "Moment of the weights, less those of wind and slope where there are any, less that of the centrifugal forces; positive lowers the driving link.", "virtual work";
    W_SX: "W_sx" "W_(s x)" N_M / KN_M, "Weights of all bodies times their distance forward of the slewing axis.", "derived";
    M_GAMMA_L: "M_gammal" "M_(gamma \"l\")" N_M / KN_M, "Moment of weights by the slope under a crane that slews, for one radian of the driving link, with that of a load that hangs on no rope; positive turns it counter-clockwise.", "virtual work";
    A_GAMMA_X: "a_gamma.x" "a_(gamma x)" M_PER_S2 / M_PER_S2, "Gravity forward in the frame that slews, on a slope.", "derived";
    G_GAMMA: "g_gamma" "g_gamma" M_PER_S2 / M_PER_S2, "Gravity upright to the slope under a crane that slews.", "derived";
    A_SLOPE_X: "a_slope.x" "a_(sigma x)" M_PER_S2 / M_PER_S2, "Acceleration by the slope, forward.", "derived";
    A_SLOPE_Y: "a_slope.y" "a_(sigma y)" M_PER_S2 / M_PER_S2, "Acceleration by the slope, upwards: what gravity lacks.", "derived";
    G_SLOPE: "g_slope" "g_sigma" M_PER_S2 / M_PER_S2, "What is left of gravity upright to the ground on a slope.", "derived";
    A_OUT: "a_out" "a_o" M_PER_S2 / M_PER_S2, "Acceleration that air and slope give the load across the rope, to where that swings.", "derived";
    V_CY1: "V_cy1" "V_(c y 1)" M3 / M3, "Areas of the first body times drag coefficients times the heights of their centres.", "derived";
    V_CY2: "V_cy2" "V_(c y 2)" M3 / M3, "Areas of the second body times drag coefficients times the heights of their centres.", "derived";
    V_CY3: "V_cy3" "V_(c y 3)" M3 / M3, "Areas of the third body times drag coefficients times the heights of their centres.", "derived";
    M_W1: "M_w1" "M_(w 1)" N_M / KN_M, "Moment of the wind on the first body about its first joint, beyond that of the same force in its centre of gravity; clockwise positive.", "equilibrium";
    M_W2: "M_w2" "M_(w 2)" N_M / KN_M, "Moment of the wind on the second body about its first joint, beyond that of the same force in its centre of gravity; clockwise positive.", "equilibrium";
    M_W3: "M_w3" "M_(w 3)" N_M / KN_M, "Moment of the wind on the third body about its first joint, beyond that of the same force in its centre of gravity; clockwise positive.", "equilibrium";
    DPSI_M: "dpsi_M" "psi'_M" ONE / ONE, "Turn of the motor's shaft for one radian of the driving link.", "derived";
    DDPSI_M: "ddpsi_M" "psi''_M" ONE / ONE, "Change of that for one radian of the driving link.", "derived";
    I_M: "I_M" "I_M" KG_M2 / T_M2, "Inertia of the motor's shaft, reduced to the driving link.", "Lagrange";
    DI_M: "dI_M" "I'_M" KG_M2 / T_M2, "Change of the motor's reduced inertia for one radian of the driving link.", "Lagrange";
    I_ALL: "I_all" "I_Sigma" KG_M2 / T_M2, "Inertia of all bars, the counterweight and the motor's shaft, reduced to the driving link.", "Lagrange";
    DI_ALL: "dI_all" "I'_Sigma" KG_M2 / T_M2, "Change of that for one radian of the driving link.", "Lagrange";
    M_BM: "M_bM" "M_(b M)" N_M / KN_M, "Moment of the brakes on the motor's shaft, at the driving link.", "virtual work";
    M_IM: "M_iM" "M_(i M)" N_M / KN_M, "Moment of the motor's inertia on the driving link.", "Lagrange";
    M_NET: "M_net" "M" N_M / KN_M, "Moment that accelerates the driving link, the load on its rope left aside.", "Lagrange";
    MASS_Q: "mass_Q" "m_Q" KG / T, "Mass of the load: weight over g.", "derived";
    DDA_X: "ddA.x" "x''_A" M / M, "Change of the forward travel of A for one radian of the driving link.", "dual numbers";
    DDA_Y: "ddA.y" "Y''_A" M / M, "Change of the rise of A for one radian of the driving link.", "dual numbers";
    A_AX: "a_A.x" "a_(A x)" M_PER_S2 / M_PER_S2, "Acceleration of A, forward.", "derived";
    A_AY: "a_A.y" "a_(A y)" M_PER_S2 / M_PER_S2, "Acceleration of A, upwards.", "derived";
    A_AR: "a_AR" "a_(A R)" M_PER_S2 / M_PER_S2, "Acceleration of A along the rope, towards the load, less that of gravity.", "derived";
    A_QX: "a_Q.x" "a_(Q x)" M_PER_S2 / M_PER_S2, "Acceleration of the load from the head but for what its rope gives it, forward.", "derived";
    A_QY: "a_Q.y" "a_(Q y)" M_PER_S2 / M_PER_S2, "Acceleration of the load from the head but for what its rope gives it, upwards.", "derived";
    A_QPHI: "a_Q.phi" "a_(Q phi)" M_PER_S2 / M_PER_S2, "Acceleration of the load from the head across its rope.", "derived";
    A_LR: "a_lR" "a_(l R)" M_PER_S2 / M_PER_S2, "Acceleration with which luffing adds rope.", "derived";
    D_PHI: "d_phi" "d_phi" M / M, "Travel of A across the rope for one radian of the driving link.", "derived";
    D_N: "d_n" "d_n" M / M, "Travel of A along the rope, away from the load, for one radian of the driving link.", "derived";
    Q_A: "q_A" "q_A" M2 / M2, "Half the change of the square of A's travel for one radian of the driving link.", "derived";
    D_L: "d_l" "d_l" M / M, "Travel of A along the rope, away from the load, less the rope that luffing adds, for one radian of the driving link.", "derived";
    Q_L: "q_l" "q_l" M2 / M2, "Half the change of the square of A's travel, with what the rope that luffing adds has of it.", "derived";
    A_L: "a_l" "a_l" M_PER_S2 / M_PER_S2, "Acceleration of the load towards the head that both angles leave as they are.", "derived";
    A_C: "a_c" "a_c" M_PER_S2 / M_PER_S2, "Acceleration of the load across the rope, as this swings while it is paid out.", "derived";
    DH_R: "dh_R" "h'_R" M / M, "Rise of the load, with the rope that luffing adds, for one radian of the driving link.", "derived";
    DD_PHI: "dd_phi" "d'_phi" M / M, "Change of A's travel, across the rope, for one radian of the driving link.", "derived";
    M_11: "m_11" "m_11" KG_M2 / T_M2, "Inertia of the load at the driving link.", "Lagrange";
    M_12: "m_12" "m_12" KG_M2 / T_M2, "Inertia that couples driving link and rope.", "Lagrange";
    M_21: "m_21" "m_21" KG_M2 / T_M2, "Inertia that couples the rope of an empty hook and driving link.", "Lagrange";
    M_22: "m_22" "m_22" KG_M2 / T_M2, "Inertia of the load about the head.", "Lagrange";
    W_1: "w_1" "w_1" J_PER_KG / J_PER_KG, "Work of a kilogram of the load, against its weight and inertia, for one radian of the driving link.", "Lagrange";
    TAU_1: "tau_1" "tau_1" N_M / KN_M, "Moment of the load's weight and inertia on the driving link.", "Lagrange";
    TAU_2: "tau_2" "tau_2" N_M / KN_M, "Moment of the load's weight and inertia on the rope.", "Lagrange";
    TAU_M: "tau_M" "tau_M" N_M / KN_M, "Moment that accelerates the driving link, with that of the load on its rope.", "Lagrange";

    OMEGA_C: "omega_c" "omega_c" RAD_PER_S / RAD_PER_S, "Angular velocity below which dry friction is in proportion to it.", "assumption";
    OMEGA_S: "omega_s" "omega_s" RAD_PER_S / RAD_PER_S, "Natural frequency of the mechanism alone against an end stop.", "assumption";
    K_S: "k_s" "k_s" N_M / KN_M, "Stiffness of the end stops, in a moment for one radian.", "derived";
    D_S: "d_s" "d_s" N_M_S / KN_M_S, "Damping of the end stops.", "derived";

    // The same of a crane that slews.
    J_XIU: "J_xiu" "J_(xi \"u\")" KG_M2 / T_M2, "Mass of the body that has the load fixed to it, with that, times squares of distances from its centre of gravity, along its bar.", "derived";
    J_XIETAU: "J_xietau" "J_(xi eta \"u\")" KG_M2 / T_M2, "The same with the product of the distances along the bar and to its left.", "derived";
    J_ETAU: "J_etau" "J_(eta \"u\")" KG_M2 / T_M2, "The same with squares of distances to the left of the bar.", "derived";
    I_UB: "I_ub" "I_(\"u\" b)" KG_M2 / T_M2, "Inertia of the boom about an upright axis through its centre of gravity.", "derived";
    DI_UB: "dI_ub" "I'_(\"u\" b)" KG_M2 / T_M2, "Change of that for one radian of the driving link.", "derived";
    I_UL: "I_ul" "I_(\"u\" l)" KG_M2 / T_M2, "Inertia of link or trunk about an upright axis through its centre of gravity.", "derived";
    DI_UL: "dI_ul" "I'_(\"u\" l)" KG_M2 / T_M2, "Change of that for one radian of the driving link.", "derived";
    I_SL: "I_sl" "I_\"sl\"" KG_M2 / T_M2, "Inertia of the whole crane about the slewing axis, without a load that hangs on its rope.", "dual numbers";
    DI_SL: "dI_sl" "I'_\"sl\"" KG_M2 / T_M2, "Change of the inertia about the slewing axis for one radian of the driving link.", "dual numbers";
    M_NET_SL: "M_netsl" "M_\"N sl\"" N_M / KN_M, "Moment that accelerates slewing, the load on its rope left aside.", "Lagrange";

    // Forces of the motion: equilibrium of each body under its weight, its inertia and the rope.
    F_AX: "F_A.x" "F_(A x)" N / KN, "Force of the rope on the head, forward.", "Newton and Euler";
    F_AY: "F_A.y" "F_(A y)" N / KN, "Force of the rope on the head, upward.", "Newton and Euler";
    M_RC: "M_Rc" "M_(R c)" N_M / KN_M, "Moment of dry friction in the pins on the driving link; a bar at rest is held by brake and dry friction in proportion to what they can hold.", "equations of motion";
    M_RV: "M_Rv" "M_(R v)" N_M / KN_M, "Moment of viscous friction on the driving link.", "equations of motion";
    M_RS: "M_Rs" "M_(R s)" N_M / KN_M, "Moment of the end stop on the driving link.", "equations of motion";
    M_T: "M_T" "M_T" N_M / KN_M, "Moment on the driving link that equilibrium of the moving bodies asks for: of drive, friction and end stop together.", "Newton and Euler";
    F_IBX: "F_ib.x" "F_(i b x)" N / KN, "Inertia of the boom, forward; with the load where a boom has it that hangs on no rope.", "Newton and Euler";
    F_IBY: "F_ib.y" "F_(i b y)" N / KN, "Weight and inertia of the boom, upward; with the load where a boom has it that hangs on no rope.", "Newton and Euler";
    F_5X: "F_5.x" "F_(5 x)" N / KN, "Inertia of the counterweight, forward.", "Newton and Euler";
    F_5Y: "F_5.y" "F_(5 y)" N / KN, "Weight and inertia of the counterweight, upward.", "Newton and Euler";
    M_I5: "M_i5" "M_(i 5)" N_M / KN_M, "Moment of the balance in motion about the boom foot; positive raises the boom.", "Newton and Euler";
    X_S5: "x_s5" "x_(s 5)" M / M, "Counterweight, forward of the slewing axis.", "derived";
    N_5X: "n_5.x" "n_(5 x)" ONE / ONE, "Force in the balance's rod or rope for one newton forward on the counterweight.", "equilibrium";
    N_5Y: "n_5.y" "n_(5 y)" ONE / ONE, "Force in the balance's rod or rope for one newton upward on the counterweight.", "equilibrium";
    E_1X: "e_1.x" "e_(1 x)" ONE / ONE, "Direction in which the balance's rod or rope pulls the boom, forward.", "derived";
    E_1Y: "e_1.y" "e_(1 y)" ONE / ONE, "Direction in which the balance's rod or rope pulls the boom, upward.", "derived";

    // A run.
    T_BS: "t_bs" "t_b" S / S, "Time from the call of the brakes on the motor's shaft to rest, in the emergency stop.", "equations of motion";
    DELTA_BS: "delta_bs" "delta_b" RAD / DEG, "Turn of the driving link in that time.", "equations of motion";
    T: "t" "t" S / S, "Time from the start of the run.", "derived";
    P_MAX: "p_max" "p_\"max\"" PA / MPA, "Greatest pressure in ports and chambers during the run.", "equations of motion";
    P_MIN: "p_min" "p_\"min\"" PA / MPA, "Least pressure in ports and chambers during the run.", "equations of motion";
    PHI_MAX: "phi_max" "phi_\"max\"" RAD / DEG, "Greatest angle of the rope from the vertical during the run.", "equations of motion";
    DELTA_E: "Delta_E" "Delta E" J / KJ, "Change of the kinetic and potential energy of all bodies.", "derived";
    E_OIL: "E_oil" "Delta E_\"oil\"" J / KJ, "Change of the energy in the compressed oil.", "derived";
    W_A: "W_A" "W_A" J / KJ, "Work of the drive.", "derived";
    W_SL: "W_sl" "W_\"sl\"" J / KJ, "Work of the slewing drive.", "derived";
    W_H: "W_h" "W_h" J / KJ, "Work of the hoist on the rope.", "derived";
    W_P: "W_P" "W_P" J / KJ, "Work of the pump.", "derived";
    W_WIND: "W_wind" "W_\"w\"" J / KJ, "Work of the wind on the bodies and on all that slews.", "derived";
    W_OMEGA: "W_Omega" "W_Omega" J / KJ, "Work of the centrifugal forces.", "derived";
    W_R: "W_R" "W_R" J / KJ, "Energy that friction, brakes, end stops and a rope's damping have taken.", "derived";
    W_T: "W_T" "W_T" J / KJ, "Energy that edges, lines, relief valves and leakage have taken.", "derived";
    W_BLOW: "W_blow" "W_\"blow\"" J / KJ, "Energy that blows at end stops and of the rope have taken, the hoist's share in them included: what it gives by a blow counts negative.", "equations of motion";
    W_E: "W_e" "W_e" J / KJ, "What is left over: error of the sums over the samples.", "derived";

    // Rates of the states.
    D_PHI_R: "der(phi_R)" "dot(phi)_R" RAD_PER_S / DEG_PER_S, "Rate of the rope's angle.", "state";
    D_OMEGA_R: "der(omega_R)" "dot(omega)_R" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the rope.", "equations of motion";
    D_L_R: "der(l_R)" "dot(l)_R" M_PER_S / M_PER_S, "Rate of the rope's length.", "state";
    D_S_Q: "der(s_Q)" "dot(s)_Q" M_PER_S / M_PER_S, "Rate of the load's distance from the head.", "state";
    D_V_Q: "der(v_Q)" "dot(v)_Q" M_PER_S2 / M_PER_S2, "Acceleration of the load away from the head.", "equations of motion";
    D_V_R: "der(v_R)" "dot(v)_R" M_PER_S2 / M_PER_S2, "Acceleration with which the hoist pays out the rope.", "equations of motion";
    D_DELTA_L: "der(delta_l)" "dot(delta)_l" M_PER_S / M_PER_S, "Rate of the tackle's slack.", "derived";
    D_V_TL: "der(v_tl)" "dot(v)_\"tl\"" M_PER_S2 / M_PER_S2, "Acceleration with which the drum of the slack tackle lets it grow longer.", "equations of motion";
    D_P_1: "der(p_1)" "dot(p)_1" PA_PER_S / MPA_PER_S, "Rate of the pressure in the port of the bore.", "equations of motion";
    D_P_2: "der(p_2)" "dot(p)_2" PA_PER_S / MPA_PER_S, "Rate of the pressure in the port of the annulus.", "equations of motion";
    D_P_A: "der(p_A)" "dot(p)_A" PA_PER_S / MPA_PER_S, "Rate of the pressure in the chamber of the bore.", "equations of motion";
    D_P_B: "der(p_B)" "dot(p)_B" PA_PER_S / MPA_PER_S, "Rate of the pressure in the chamber of the annulus.", "equations of motion";
    D_X_V: "der(x_v)" "dot(x)_v" PER_S / PER_S, "Rate of the valve's spool.", "state";
    D_V_V: "der(v_v)" "dot(v)_v" PER_S2 / PER_S2, "Acceleration of the valve's spool.", "equations of motion";

    // Event indicators: an event is where one falls below zero.
    Z_REST: "z.rest" "z_1" ONE / ONE, "Falls below zero where the driving link comes to rest, or breaks loose backwards.", "event";
    Z_LOOSE: "z.loose" "z_2" ONE / ONE, "Falls below zero where the driving link breaks loose forwards.", "event";
    Z_LOW: "z.low" "z_3" ONE / ONE, "Falls below zero where the driving link meets its lower end stop.", "event";
    Z_HIGH: "z.high" "z_4" ONE / ONE, "Falls below zero where the driving link meets its upper end stop.", "event";
    Z_SPOOL: "z.spool" "z_6" ONE / ONE, "Changes its sign where the valve's spool passes its middle.", "event";
    Z_RELIEF_1: "z.relief_1" "z_7" ONE / ONE, "Falls below zero where the relief valve on the side of the bore opens.", "event";
    Z_RELIEF_2: "z.relief_2" "z_8" ONE / ONE, "Falls below zero where the relief valve on the side of the annulus opens.", "event";
    Z_HOIST: "z.hoist" "z_13" ONE / ONE, "Falls below zero where the hoist has come up to its command.", "event";
    Z_DRUM_REST: "z.drum_rest" "z_14" ONE / ONE, "Falls below zero where the hoist's drum comes to rest, or breaks loose paying out.", "event";
    Z_DRUM_LOOSE: "z.drum_loose" "z_15" ONE / ONE, "Falls below zero where the hoist's drum breaks loose reeling in.", "event";
    Z_TACKLE: "z.tackle" "z_33" ONE / ONE, "Falls below zero where the luffing tackle becomes slack or taut.", "event";
    Z_TACKLE_REST: "z.tackle_rest" "z_34" ONE / ONE, "Falls below zero where the drum of the slack tackle comes to rest, or breaks loose reeling in.", "event";
    Z_TACKLE_LOOSE: "z.tackle_loose" "z_35" ONE / ONE, "Falls below zero where the drum of the slack tackle breaks loose paying out.", "event";
}

/// What the wind's moments have of each bar.
pub(crate) static OF_AREAS: [&Symbol; 3] = [&V_CY1, &V_CY2, &V_CY3];
pub(crate) static OF_WIND: [&Symbol; 3] = [&M_W1, &M_W2, &M_W3];

/// Travel forward and up by the driving angle, first and second derivative.
pub(crate) type OfCentre = [[&'static Symbol; 2]; 2];

/// What the equations of motion sum for each body.
pub(crate) struct OfSums {
    pub mass: &'static Symbol,
    pub inertia: &'static Symbol,
    pub slope: &'static Symbol,
}

pub(crate) static OF_COUNTERWEIGHT: OfCentre = [[&DX_5, &DY_5], [&DDX_5, &DDY_5]];
