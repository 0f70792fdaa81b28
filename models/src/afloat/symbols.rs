//! Every quantity of a hull with a crane on it.

pub use crate::kernel::gravity::G;
use crate::kernel::symbol::symbols;
pub use crate::luffing::aboard::{OMEGA_1, R, THETA_1};
pub use crate::parts::hanging::{KAPPA_R, L_R, S_R};

symbols! {
    // Given.
    PSI_SL: "psi_sl" "psi_\"sl\"" RAD / DEG, "Slewing angle of the boom from the bow; positive counter-clockwise, seen from above.", "input";
    OMEGA_SL: "omega_sl" "omega_\"sl\"" RAD_PER_S / DEG_PER_S, "Angular velocity of slewing.", "input";
    FROM: "from" "psi_a" RAD / DEG, "Slewing angle at the start of the working range.", "input";
    TO: "to" "psi_e" RAD / DEG, "Slewing angle at the end of the working range.", "input";
    RHO_W: "rho_w" "rho_\"w\"" KG_PER_M3 / KG_PER_M3 [positive], "Density of the water.", "input";
    L: "L" "L" M / M [positive], "Length of the hull.", "input";
    B: "B" "B" M / M [positive], "Breadth of the hull.", "input";
    D: "D" "D" M / M [positive], "Depth of the hull, from keel to deck.", "input";
    X_H: "x_h" "x_h" M / M, "Place of a section, forward of the origin.", "input";
    Y_H: "y_h" "y_h" M / M [not_negative], "Half breadth of the hull at a point of a section.", "input";
    Z_H: "z_h" "z_h" M / M, "Height of a point of a section above the keel.", "input";
    G_M: "G_m" "G_(m i)" N / KN [not_negative], "Weight of a mass on the hull, or of the hull.", "input";
    X_M: "x_m" "x_(m i)" M / M, "Centre of gravity of a mass, forward of the origin.", "input";
    Y_M: "y_m" "y_(m i)" M / M, "Centre of gravity of a mass, to the left of the centre line.", "input";
    Z_M: "z_m" "z_(m i)" M / M, "Centre of gravity of a mass, above the keel.", "input";
    RHO_T: "rho_t" "rho_(t i)" KG_PER_M3 / KG_PER_M3 [not_negative], "Density of the liquid in a tank.", "input";
    L_T: "l_t" "l_(t i)" M / M [positive], "Length of a tank.", "input";
    B_T: "b_t" "b_(t i)" M / M [positive], "Breadth of a tank.", "input";
    D_T: "d_t" "d_(t i)" M / M [positive], "Depth of a tank.", "input";
    H_T: "h_t" "h_(t i)" M / M [positive], "Height of the liquid in a tank, the hull upright.", "input";
    X_T: "x_t" "x_(t i)" M / M, "Middle of a tank, forward of the origin.", "input";
    Y_T: "y_t" "y_(t i)" M / M, "Middle of a tank, to the left of the centre line.", "input";
    Z_T: "z_t" "z_(t i)" M / M, "Bottom of a tank, above the keel.", "input";
    X_S: "x_s" "x_s" M / M, "Slewing axis, forward of the origin.", "input";
    Y_S: "y_s" "y_s" M / M, "Slewing axis, to the left of the centre line.", "input";
    H_S: "h_s" "h_s" M / M, "Height of the load's point of suspension above the keel.", "input";
    H_1: "h_1" "h_1" M / M, "Height of the luffing mechanism's foot above the keel.", "input";
    G_U: "G_u" "G_(u i)" N / KN [not_negative], "Weight of a mass that slews with the crane.", "input";
    X_U: "x_u" "x_(u i)" M / M, "Centre of gravity of a mass that slews, from the slewing axis toward the load.", "input";
    Y_U: "y_u" "y_(u i)" M / M, "Centre of gravity of a mass that slews, to the left of the boom's plane.", "input";
    Z_U: "z_u" "z_(u i)" M / M, "Centre of gravity of a mass that slews, above the keel.", "input";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load with hook block or grab.", "input";
    P_W: "p_w" "p_\"w\"" PA / PA [not_negative], "Pressure of the wind.", "input";
    CHI_W: "chi_w" "chi_\"w\"" RAD / DEG, "Direction to which the wind blows, from the bow; positive counter-clockwise, seen from above.", "input";
    Z_L: "z_l" "z_l" M / M, "Height above the keel at which the water holds the hull against the wind.", "input";
    A_W: "A_w" "A_(\"w\" i)" M2 / M2 [not_negative], "Wind area with its shape coefficient.", "input";
    Z_W: "z_w" "z_(\"w\" i)" M / M, "Centre of a wind area, above the keel.", "input";
    F_P: "F_p" "F_p" N / KN [not_negative], "Pull of a rope that tows the hull.", "input";
    CHI_P: "chi_p" "chi_p" RAD / DEG, "Direction to which it pulls, from the bow; positive counter-clockwise, seen from above.", "input";
    Z_P: "z_p" "z_p" M / M, "Height above the keel at which it pulls.", "input";
    Z_LP: "z_lp" "z_(l p)" M / M, "Height above the keel at which the water holds the hull against it.", "input";
    MU_F: "mu_f" "mu_(f i)" ONE / ONE [above_to(0.0, 1.0), unconfirmed], "Permeability of a flooded compartment: the share of it that water fills.", "input";
    L_F: "l_f" "l_(f i)" M / M [positive], "Length of a flooded compartment.", "input";
    B_F: "b_f" "b_(f i)" M / M [positive], "Breadth of a flooded compartment.", "input";
    D_F: "d_f" "d_(f i)" M / M [positive], "Depth of a flooded compartment, to the deck above it.", "input";
    X_F: "x_f" "x_(f i)" M / M, "Middle of a flooded compartment, forward of the origin.", "input";
    Y_F: "y_f" "y_(f i)" M / M, "Middle of a flooded compartment, to the left of the centre line.", "input";
    Z_F: "z_f" "z_(f i)" M / M, "Bottom of a flooded compartment, above the keel.", "input";
    P_G: "p_g" "p_g" PA / PA [not_negative], "Pressure of a sudden wind, besides the one that blows.", "input";
    PHI_A: "phi_a" "phi_a" RAD / DEG [from_to(0.0, 1.4), unconfirmed], "Roll against the sudden wind from which the hull comes.", "input";
    PHI_H: "phi_h" "phi_(h i)" RAD / DEG [above_to(0.0, 1.4)], "Heel at which the righting lever is told.", "input";
    X_O: "x_o" "x_(o i)" M / M, "Opening through which water comes in, forward of the origin.", "input";
    Y_O: "y_o" "y_(o i)" M / M, "Opening through which water comes in, to the left of the centre line.", "input";
    Z_O: "z_o" "z_(o i)" M / M, "Opening through which water comes in, above the keel.", "input";
    PHI_F: "phi_f" "phi_f" RAD / DEG [above_to(0.0, 1.4)], "Heel up to which areas of levers count: of flooding, or another limit of the criterion.", "input";
    K_A: "k_A" "k_A" ONE / ONE [positive, unconfirmed], "Times that the area that stops the roll after a loss of load must be the one that drives it.", "input";
    C_A: "c_A" "c_A" M_RAD / M_DEG [not_negative, unconfirmed], "Area by which the one that stops the roll after a loss of load must be greater than the one that drives it.", "[46 CFR 173, 173.025]";

    // Of a further load case.
    Q_K: "Q_k" "Q_(k i)" N / KN [not_negative], "Weight of the load with hook block or grab in a load case.", "input";
    R_K: "R_k" "R_(k i)" M / M, "Reach in a load case.", "input";
    THETA_1K: "theta_1k" "theta_(1 k i)" RAD / DEG, "Luffing angle in a load case.", "input";
    PSI_K: "psi_k" "psi_(k i)" RAD / DEG, "Slewing angle of a load case; without it the case holds all over the working range.", "input";
    P_WK: "p_wk" "p_(\"w\" k i)" PA / PA [not_negative], "Pressure of the wind in a load case.", "input";
    CHI_WK: "chi_wk" "chi_(\"w\" k i)" RAD / DEG, "Direction to which the wind blows in a load case, from the bow.", "input";
    P_GK: "p_gk" "p_(g k i)" PA / PA [not_negative], "Pressure of the sudden wind in a load case, besides the one that blows.", "input";
    F_PK: "F_pk" "F_(p k i)" N / KN [not_negative], "Pull of the tow rope in a load case.", "input";

    // Weights.
    W_0: "W_0" "W_0" N / KN, "Weight without load.", "derived";
    M_L0: "M_L0" "M_(L 0)" N_M / KN_M, "Moment of the weights without load, and of the wind, about the axis across the hull; positive lowers the bow.", "equilibrium";
    M_T0: "M_T0" "M_(T 0)" N_M / KN_M, "Moment of the weights without load, and of the wind, about the centre line; positive lowers the left side.", "equilibrium";
    M_V0: "M_V0" "M_(V 0)" N_M / KN_M, "Moment of the weights without load about the keel.", "equilibrium";
    M_W: "M_w" "M_\"w\"" N_M / KN_M, "Moment of the wind on the upright hull.", "equilibrium";
    M_P: "M_p" "M_p" N_M / KN_M, "Moment of the pull on the upright hull.", "equilibrium";
    X_Q: "x_Q" "x_Q" M / M, "Point of suspension, forward of the origin.", "derived";
    Y_Q: "y_Q" "y_Q" M / M, "Point of suspension, to the left of the centre line.", "derived";
    W: "W" "W" N / KN, "Weight with the load: displacement.", "derived";
    M_L: "M_L" "M_L" N_M / KN_M, "Moment of all weights, and of the wind, about the axis across the hull; positive lowers the bow.", "equilibrium";
    M_T: "M_T" "M_T" N_M / KN_M, "Moment of all weights, and of the wind, about the centre line; positive lowers the left side.", "equilibrium";
    Z_G: "z_G" "z_G" M / M, "Centre of gravity above the keel (KG), the load at its point of suspension.", "[IS Code 2008, B 2.9]";

    // What slews, with its luffing mechanism.
    W_C: "W_c" "W_c" N / KN, "Weight of all that slews, without load.", "derived";
    M_XI: "M_xi" "M_xi" N_M / KN_M, "Moment of what slews, without load, about the slewing axis, toward the load.", "equilibrium";
    M_ETA: "M_eta" "M_eta" N_M / KN_M, "Moment of what slews about the slewing axis, to the left of the boom's plane.", "equilibrium";
    M_LC: "M_Lc" "M_(L c)" N_M / KN_M, "Moment of what slews, without load, about the axis across the hull.", "equilibrium";
    M_TC: "M_Tc" "M_(T c)" N_M / KN_M, "Moment of what slews, without load, about the centre line.", "equilibrium";
    M_VC: "M_Vc" "M_(V c)" N_M / KN_M, "Moment of what slews, without load, about the keel.", "equilibrium";
    M_XS: "M_xs" "M_(x s)" N_M / KN_M, "Moment of what slews with the load about the slewing axis, along the hull.", "equilibrium";
    M_YS: "M_ys" "M_(y s)" N_M / KN_M, "Moment of what slews with the load about the slewing axis, across the hull.", "equilibrium";
    T_XI: "t_xi" "t_xi" ONE / ONE, "Slope of the water in the boom's plane, toward the load.", "derived";
    DM_R: "dM_r" "M'_r" N_M / KN_M, "Change of the moment about the slewing axis for one radian of luffing, with the load.", "virtual work";
    DM_H: "dM_h" "M'_h" N_M / KN_M, "Change of the moment by heights for one radian of luffing, with the load.", "virtual work";
    M_SL0: "M_sl0" "M_(\"sl\" 0)" N_M / KN_M, "Moment that holds slewing at rest on the hull as it lies; positive counter-clockwise, seen from above.", "virtual work";
    M_10: "M_10" "M_(1 0)" N_M / KN_M, "Moment that holds the luffing mechanism's driving link at rest on the hull as it lies; positive raises it.", "virtual work";

    // Upright.
    NABLA: "nabla" "nabla" M3 / M3, "Displaced volume.", "equilibrium";
    T_0: "T_0" "T_0" M / M, "Draft of the upright hull.", "derived";
    X_B: "x_B" "x_B" M / M, "Centre of buoyancy of the upright hull, forward of the origin.", "derived";
    Z_B: "z_B" "z_B" M / M, "Centre of buoyancy of the upright hull, above the keel (KB).", "derived";
    Y_B: "y_B" "y_B" M / M, "Centre of buoyancy of the upright hull with flooded compartments, to the left of the centre line.", "derived";
    A_WP: "A_WP" "A_\"WP\"" M2 / M2, "Waterplane area of the upright hull.", "derived";
    I_T: "I_T" "I_T" M4 / M4, "Second moment of the waterplane about its axis along the hull.", "derived";
    I_L: "I_L" "I_L" M4 / M4, "Second moment of the waterplane about its axis across the hull.", "derived";
    BM: "BM" "\"BM\"" M / M, "Metacentric radius.", "[Ports001, 7.3]";
    BM_L: "BM_L" "\"BM\"_L" M / M, "Metacentric radius of trim.", "[Ports001, 7.3]";
    GG: "GG" "\"GG\"" M / M, "Loss of metacentric height by free surfaces.", "[Ports001, 7.3]";
    GG_L: "GG_L" "\"GG\"_L" M / M, "Loss of metacentric height of trim by free surfaces.", "[Ports001, 7.3]";
    GM: "GM" "\"GM\"" M / M, "Metacentric height, free surfaces counted.", "[Ports001, 7.3]";
    GM_L: "GM_L" "\"GM\"_L" M / M, "Metacentric height of trim, free surfaces counted.", "[Ports001, 7.3]";
    PHI_D: "phi_d" "phi_d" RAD / DEG, "Heel at which the deck edge comes to the water, from the upright hull.", "derived";
    PHI_B: "phi_b" "phi_b" RAD / DEG, "Heel up to which the water stands on the upright part of the sides; beyond it the wall-sided form does not hold.", "derived";
    T_PHI_M: "t_phi_M" "t_(phi M)" ONE / ONE, "Slope of heel by the metacentric heights.", "[Ports001, 7.3]";
    T_THETA_M: "t_theta_M" "t_(theta M)" ONE / ONE, "Slope of trim by the metacentric heights.", "[Ports001, 7.3]";
    PHI_M: "phi_M" "phi_M" RAD / DEG, "Heel by the metacentric height; positive lowers the left side.", "[Ports001, 7.3]";
    THETA_M: "theta_M" "theta_M" RAD / DEG, "Trim by the metacentric height; positive lowers the bow.", "[Ports001, 7.3]";
    PHI_R: "phi_r" "phi_r" RAD / DEG [not_negative], "Inclination by the metacentric heights, heel and trim combined.", "[Ports001, 7.3]";

    // Equilibrium.
    T_PHI: "t_phi" "t_phi" ONE / ONE, "Slope of the water across the hull.", "equilibrium";
    T_THETA: "t_theta" "t_theta" ONE / ONE, "Slope of the water along the hull.", "equilibrium";
    PHI: "phi" "phi" RAD / DEG, "Heel; positive lowers the left side.", "equilibrium";
    THETA: "theta" "theta" RAD / DEG, "Trim; positive lowers the bow.", "equilibrium";
    T: "T" "T" M / M, "Draft at the origin, along the hull's own vertical.", "equilibrium";
    BETA: "beta" "beta" RAD / DEG [not_negative], "Inclination: angle of the deck from the horizontal.", "derived";
    X_C: "x_c" "x_c" M / M, "Corner of the deck at the bow, forward of the origin.", "derived";
    X_A: "x_a" "x_a" M / M, "Corner of the deck at the stern, forward of the origin.", "derived";
    Y_C: "y_c" "y_c" M / M, "Corner of the deck at the bow, from the centre line.", "derived";
    Y_A: "y_a" "y_a" M / M, "Corner of the deck at the stern, from the centre line.", "derived";
    Z_C: "z_c" "z_c" M / M, "Corner of the deck at the bow, above the keel.", "derived";
    Z_A: "z_a" "z_a" M / M, "Corner of the deck at the stern, above the keel.", "derived";
    F_1: "f_1" "f_1" M / M, "Freeboard of the corner at the bow on the right.", "derived";
    F_2: "f_2" "f_2" M / M, "Freeboard of the corner at the bow on the left.", "derived";
    F_3: "f_3" "f_3" M / M, "Freeboard of the corner at the stern on the left.", "derived";
    F_4: "f_4" "f_4" M / M, "Freeboard of the corner at the stern on the right.", "derived";
    X_D: "x_d" "x_d" M / M, "Point of the deck's edge with the least freeboard, forward of the origin.", "derived";
    Y_D: "y_d" "y_d" M / M, "Point of the deck's edge with the least freeboard, to the left of the centre line.", "derived";
    Z_D: "z_d" "z_d" M / M, "Point of the deck's edge with the least freeboard, above the keel.", "derived";
    F_LOW: "f_low" "f_\"low\"" M / M, "Least freeboard of all points of the deck edge.", "derived";

    // Levers.
    GZ: "GZ" "\"GZ\"_i" M / M, "Righting lever at a heel, trim free, without the moments that heel.", "derived";
    E: "e" "e_i" M_RAD / M_DEG, "Area under the righting lever up to a heel: rise of the centre of gravity over that of buoyancy.", "virtual work";
    GZ_W: "GZ_w" "\"GZ\"_(\"w\" i)" M / M, "Righting lever by the wall-sided form.", "[Ports001, 7.3]";
    E_W: "e_w" "e_(\"w\" i)" M_RAD / M_DEG, "Area under the righting lever by the wall-sided form.", "[Ports001, 7.3]";
    A_RES: "A_res" "A_\"res\"" M_RAD / M_DEG, "Area between righting and heeling levers from the heel under load up to the one that counts.", "[46 CFR 173, 173.020]";

    // Openings.
    F_O: "f_o" "f_(o i)" M / M, "Height of an opening over the water.", "derived";
    PHI_O: "phi_o" "phi_(o i)" RAD / DEG [infinite("where it does not come to the water up to 80°")], "Heel at which an opening comes to the water under the load, to the side to which the hull heels, by amount.", "derived";
    PHI_O0: "phi_o0" "phi_(o 0 i)" RAD / DEG [infinite("where it does not come to the water up to 80°")], "Heel at which an opening comes to the water without the load, to the side to which the hull rolls when that is lost, by amount.", "derived";

    // Loss of load.
    PHI_Q0: "phi_Q0" "phi_(Q 0)" RAD / DEG, "Heel after the load is lost.", "equilibrium";
    A_I: "A_I" "A_\"I\"" M_RAD / M_DEG, "Area that drives the roll when the load is lost.", "[46 CFR 173, 173.025]";
    A_II: "A_II" "A_\"II\"" M_RAD / M_DEG, "Area that stops that roll, up to the heel that counts.", "[46 CFR 173, 173.025]";
    PHI_2: "phi_2" "phi_2" RAD / DEG, "Heel to which the hull rolls when the load is lost.", "virtual work";
    D_A: "d_A" "Delta A" M_RAD / M_DEG, "Area by which the one that stops the roll is greater than the criterion asks.", "[46 CFR 173, 173.025]";

    // Further load cases.
    PHI_K: "phi_k" "phi_(k i)" RAD / DEG, "Heel in a load case; positive lowers the left side.", "equilibrium";
    THETA_K: "theta_k" "theta_(k i)" RAD / DEG, "Trim in a load case; positive lowers the bow.", "equilibrium";
    F_K: "f_k" "f_(k i)" M / M, "Least freeboard of all points of the deck edge in a load case.", "derived";
    F_OK: "f_ok" "f_(o k i)" M / M [infinite("where none is open")], "Least height over the water of the openings that are open in a load case.", "derived";
    PHI_OK: "phi_ok" "phi_(o k i)" RAD / DEG [infinite("where none comes to the water up to 80°")], "Least heel at which an opening comes to the water in a load case.", "derived";
    A_K: "A_k" "A_(k i)" M_RAD / M_DEG, "Residual area in a load case.", "[46 CFR 173, 173.020]";
    PHI_2K: "phi_2k" "phi_(2 k i)" RAD / DEG, "Heel to which the hull rolls when the load is lost in a load case.", "virtual work";
    PHI_DK: "phi_dk" "phi_(\"dyn\" k i)" RAD / DEG, "Heel to which the hull rolls when the sudden wind strikes in a load case.", "virtual work";
    K_CK: "K_ck" "K_(c k i)" ONE / ONE [infinite("without a sudden wind")], "Moment that capsizes over that of the sudden wind in a load case.", "[Ports001, 7.3]";
    GM_K: "GM_k" "\"GM\"_(k i)" M / M, "Metacentric height in a load case, free surfaces counted.", "[Ports001, 7.3]";
    RHO_K: "rho_k" "rho_(k i)" ONE / ONE [infinite("where no load is lost")], "Area that stops the roll after a loss of load over the one that the criterion asks for.", "[46 CFR 173, 173.025]";
    U_K: "u_k" "u_(k i)" ONE / ONE, "Greatest utilisation of the criteria of a load case.", "derived";

    // Sudden wind.
    M_G: "M_g" "M_g" N_M / KN_M, "Moment of the sudden wind on the upright hull, to the side to which it heels.", "equilibrium";
    PHI_S: "phi_s" "phi_s" RAD / DEG, "Heel at rest under load and sudden wind.", "equilibrium";
    PHI_DYN: "phi_dyn" "phi_\"dyn\"" RAD / DEG, "Heel to which the hull rolls when the sudden wind strikes.", "virtual work";
    M_C: "M_c" "M_c" N_M / KN_M, "Least moment, the same at every heel, that capsizes the hull when it strikes: tangent of the dynamic lever, up to the heel that counts.", "[Ports001, 7.3]";
    K_C: "K_c" "K_c" ONE / ONE [infinite("without a sudden wind")], "Moment that capsizes over that of the sudden wind.", "[Ports001, 7.3]";

    // Given of the motion.
    OMEGA_CSL: "omega_csl" "omega_(c \"sl\")" RAD_PER_S / DEG_PER_S, "Commanded angular velocity of slewing.", "input";
    T_SL: "T_sl" "T_\"sl\"" S / S [positive], "Time constant with which slewing follows its command.", "input";
    OMEGA_C1: "omega_c1" "omega_(c 1)" RAD_PER_S / DEG_PER_S, "Commanded angular velocity of luffing.", "input";
    T_1: "T_1" "T_1" S / S [positive], "Time constant with which luffing follows its command.", "input";
    M_A: "m_a" "m_a" KG / T [not_negative], "Mass of water that goes up and down with the hull.", "input";
    J_X: "J_x" "J_x" KG_M2 / T_M2 [positive], "Inertia of all but the load about an axis along the hull through their centre of gravity, with the water that rolls too.", "input";
    J_Y: "J_y" "J_y" KG_M2 / T_M2 [positive], "Inertia of all but the load about an axis across the hull through their centre of gravity, with the water that pitches too.", "input";
    D_Z: "d_z" "d_z" N_S_PER_M / KN_S_PER_M [not_negative], "Damping of heaving.", "input";
    D_X: "d_x" "d_x" N_M_S / KN_M_S [not_negative], "Damping of rolling.", "input";
    D_Y: "d_y" "d_y" N_M_S / KN_M_S [not_negative], "Damping of pitching.", "input";
    STEP: "step" "h" S / MS [positive], "Longest step of the solver.", "input";

    // States.
    H_G: "h_G" "h_G" M / M, "Centre of gravity of all but the load, above the water.", "equations of motion";
    PHI_X: "phi_x" "phi_x" RAD / DEG, "Heel in motion; positive lowers the left side.", "equations of motion";
    THETA_Y: "theta_y" "theta_y" RAD / DEG, "Pitch: angle of the hull's long axis below the horizontal; positive lowers the bow.", "equations of motion";
    V_G: "v_G" "v_G" M_PER_S / M_PER_S, "Speed of heaving, upward.", "equations of motion";
    OMEGA_X: "omega_x" "omega_x" RAD_PER_S / DEG_PER_S, "Angular velocity of rolling.", "equations of motion";
    OMEGA_Y: "omega_y" "omega_y" RAD_PER_S / DEG_PER_S, "Angular velocity of pitching.", "equations of motion";
    R_X: "r_x" "r_x" M / M, "Load, horizontally forward of the head.", "equations of motion";
    R_Y: "r_y" "r_y" M / M, "Load, horizontally to the left of the head.", "equations of motion";
    R_Z: "r_z" "r_z" M / M, "Load, above the head.", "equations of motion";
    W_X: "w_x" "w_x" M_PER_S / M_PER_S, "Speed of the load forward, from the head.", "equations of motion";
    W_Y: "w_y" "w_y" M_PER_S / M_PER_S, "Speed of the load to the left, from the head.", "equations of motion";
    W_Z: "w_z" "w_z" M_PER_S / M_PER_S, "Speed of the load upward, from the head.", "equations of motion";

    // How the hull lies while it moves.
    X_G: "x_G" "x_G" M / M, "Centre of gravity of all but the load, forward of the origin.", "derived";
    Y_G: "y_G" "y_G" M / M, "Centre of gravity of all but the load, to the left of the centre line.", "derived";
    Z_G0: "z_G0" "z_(G 0)" M / M, "Centre of gravity of all but the load, above the keel.", "derived";
    T_X: "t_x" "t_x" ONE / ONE, "Slope of the water along the hull in motion.", "derived";
    T_Y: "t_y" "t_y" ONE / ONE, "Slope of the water across the hull in motion.", "derived";
    T_M: "T_m" "T_m" M / M, "Draft at the origin in motion, along the hull's own vertical.", "derived";
    NABLA_M: "nabla_m" "nabla_m" M3 / M3, "Displaced volume in motion.", "derived";
    K_X: "K_x" "K_x" N_M / KN_M, "Moment of the displaced water less that of liquids that have moved, about the axis across the hull.", "equilibrium";
    K_Y: "K_y" "K_y" N_M / KN_M, "Moment of the displaced water less that of liquids that have moved, about the centre line.", "equilibrium";
    K_Z: "K_z" "K_z" N_M / KN_M, "Moment of the displaced water less that of liquids that have moved, about the keel.", "equilibrium";
    F_M: "f_m" "f_m" M / M, "Least freeboard of all points of the deck edge in motion; negative under water.", "derived";

    // What moves it.
    F_Z: "F_z" "F_z" N / KN, "Force of water and weights that lifts the hull, without the rope's.", "virtual work";
    P_X: "P_x" "P_x" N_M / KN_M, "Moment of water less weights for a point of support at the centre of gravity, along the hull.", "virtual work";
    P_Y: "P_y" "P_y" N_M / KN_M, "Moment of water less weights for a point of support at the centre of gravity, across the hull.", "virtual work";
    P_Z: "P_z" "P_z" N_M / KN_M, "Moment of water less weights for a point of support at the centre of gravity, up the hull.", "virtual work";
    M_X: "M_x" "M_x" N_M / KN_M, "Moment that rolls the hull, without the rope's; positive lowers the left side.", "virtual work";
    M_Y: "M_y" "M_y" N_M / KN_M, "Moment that pitches the hull, without the rope's; positive lowers the bow.", "virtual work";
    S_X: "s_x" "s_x" M / M, "Head, horizontally forward of the hull's centre of gravity.", "derived";
    S_Y: "s_y" "s_y" M / M, "Head, horizontally to the left of the hull's centre of gravity.", "derived";
    S_Z: "s_z" "s_z" M / M, "Head, above the hull's centre of gravity.", "derived";
    S_V: "s_v" "s_v" M / M, "Head from the hull's centre of gravity, square to the long axis in a vertical plane.", "derived";
    XI: "xi" "xi" M / M, "Reach along the hull.", "derived";
    ETA: "eta" "eta" M / M, "Reach across the hull.", "derived";
    N_X: "n_x" "n_x" ONE / ONE, "Direction of the rope from the head, forward.", "derived";
    N_Y: "n_y" "n_y" ONE / ONE, "Direction of the rope from the head, to the left.", "derived";
    N_Z: "n_z" "n_z" ONE / ONE, "Direction of the rope from the head, upward.", "derived";
    S_Q: "s_Q" "s_Q" M / M, "Distance of the load from the head: the rope's length.", "derived";
    W_E: "w_e" "w_e" M_PER_S / M_PER_S, "Speed along the rope: rounding alone.", "derived";
    A_PHI: "a_phi" "a_phi" M / M, "Travel of the head along the rope for one radian of heel.", "virtual work";
    A_THETA: "a_theta" "a_theta" M / M, "Travel of the head along the rope for one radian of pitch.", "virtual work";
    C_X: "c_x" "c_x" M_PER_S2 / M_PER_S2, "Acceleration of the head forward, were heave, heel and pitch to keep their speeds.", "derived";
    C_Y: "c_y" "c_y" M_PER_S2 / M_PER_S2, "Acceleration of the head to the left, were heave, heel and pitch to keep their speeds.", "derived";
    C_Z: "c_z" "c_z" M_PER_S2 / M_PER_S2, "Acceleration of the head upward, were heave, heel and pitch to keep their speeds.", "derived";
    M_Q: "m_Q" "m_Q" KG / T [not_negative], "Mass of the load: weight over g.", "derived";
    M_0: "m_0" "m_0" KG / T, "Mass that heaves, with the water that goes with it.", "derived";
    A_N: "a_N" "a_N" M_PER_S2 / M_PER_S2, "Acceleration along the rope that its force must take from the load.", "Lagrange";
    A_R: "a_R" "a_R" M_PER_S2 / M_PER_S2, "Force of the rope over the mass of the load.", "Lagrange";
    B_Z: "b_z" "b_z" M_PER_S2 / M_PER_S2, "Acceleration of heaving without the rope.", "Lagrange";
    B_PHI: "b_phi" "b_phi" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of rolling without the rope.", "Lagrange";
    B_THETA: "b_theta" "b_theta" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of pitching without the rope.", "Lagrange";
    KAPPA_Z: "kappa_z" "kappa_z" ONE / ONE, "Acceleration of heaving by the rope, of its force over the mass of the load.", "Lagrange";
    KAPPA_PHI: "kappa_phi" "kappa_phi" PER_M / PER_M, "Angular acceleration of rolling by the rope, of its force over the mass of the load.", "Lagrange";
    KAPPA_THETA: "kappa_theta" "kappa_theta" PER_M / PER_M, "Angular acceleration of pitching by the rope, of its force over the mass of the load.", "Lagrange";
    M_SL: "M_sl" "M_\"sl\"" N_M / KN_M, "Moment of the slewing drive; positive counter-clockwise, seen from above.", "Lagrange";
    M_1: "M_1" "M_1" N_M / KN_M, "Moment of the luffing drive on the driving link; positive raises it.", "Lagrange";
    CHI_X: "chi_x" "chi_x" RAD / DEG, "Angle of the rope from the vertical along the hull; positive swings the load forward.", "derived";
    CHI_Y: "chi_y" "chi_y" RAD / DEG, "Angle of the rope from that plane; positive swings the load to the left.", "derived";

    // Rates of the states.
    D_PSI_SL: "der(psi_sl)" "dot(psi)_\"sl\"" RAD_PER_S / RAD_PER_S, "Rate of the slewing angle.", "state";
    D_OMEGA_SL: "der(omega_sl)" "dot(omega)_\"sl\"" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of slewing.", "derived";
    D_THETA_1: "der(theta_1)" "dot(theta)_1" RAD_PER_S / RAD_PER_S, "Rate of the luffing angle.", "state";
    D_OMEGA_1: "der(omega_1)" "dot(omega)_1" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of luffing.", "derived";
    D_H_G: "der(h_G)" "dot(h)_G" M_PER_S / M_PER_S, "Rate of the height of the centre of gravity.", "state";
    D_PHI_X: "der(phi_x)" "dot(phi)_x" RAD_PER_S / RAD_PER_S, "Rate of the heel.", "state";
    D_THETA_Y: "der(theta_y)" "dot(theta)_y" RAD_PER_S / RAD_PER_S, "Rate of the pitch.", "state";
    D_V_G: "der(v_G)" "dot(v)_G" M_PER_S2 / M_PER_S2, "Acceleration of heaving.", "Lagrange";
    D_OMEGA_X: "der(omega_x)" "dot(omega)_x" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of rolling.", "Lagrange";
    D_OMEGA_Y: "der(omega_y)" "dot(omega)_y" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of pitching.", "Lagrange";
    D_R_X: "der(r_x)" "dot(r)_x" M_PER_S / M_PER_S, "Rate of the load's place forward of the head.", "state";
    D_R_Y: "der(r_y)" "dot(r)_y" M_PER_S / M_PER_S, "Rate of the load's place to the left of the head.", "state";
    D_R_Z: "der(r_z)" "dot(r)_z" M_PER_S / M_PER_S, "Rate of the load's place above the head.", "state";
    D_W_X: "der(w_x)" "dot(w)_x" M_PER_S2 / M_PER_S2, "Acceleration of the load forward, from the head.", "Lagrange";
    D_W_Y: "der(w_y)" "dot(w)_y" M_PER_S2 / M_PER_S2, "Acceleration of the load to the left, from the head.", "Lagrange";
    D_W_Z: "der(w_z)" "dot(w)_z" M_PER_S2 / M_PER_S2, "Acceleration of the load upward, from the head.", "Lagrange";

    // The whole range.
    PHI_MAX: "phi_max" "phi_max" RAD / DEG, "Greatest heel in the working range, by amount.", "derived";
    THETA_MAX: "theta_max" "theta_max" RAD / DEG, "Greatest trim in the working range, by amount.", "derived";
    BETA_MAX: "beta_max" "beta_max" RAD / DEG, "Greatest inclination in the working range.", "derived";
    F_MIN: "f_min" "f_min" M / M, "Least freeboard in the working range.", "derived";
    F_O_MIN: "f_o_min" "f_(o,min)" M / M, "Least height of the openings over the water in the working range.", "derived";
    PHI_O_MIN: "phi_o_min" "phi_(o,min)" RAD / DEG [infinite("where none comes to the water up to 80°")], "Least heel at which an opening comes to the water under the load in the working range.", "derived";
    PHI_2_MAX: "phi_2_max" "phi_(2,max)" RAD / DEG, "Greatest heel after a loss of load in the working range, by amount.", "derived";
    A_RES_MIN: "A_res_min" "A_(\"res\",min)" M_RAD / M_DEG, "Least residual area in the working range.", "derived";
    D_A_MIN: "d_A_min" "Delta A_min" M_RAD / M_DEG, "Least excess of the area that stops the roll after a loss of load in the working range.", "derived";
    PHI_DYN_MAX: "phi_dyn_max" "phi_(\"dyn\",max)" RAD / DEG, "Greatest heel of a roll in a sudden wind in the working range, by amount.", "derived";
    K_C_MIN: "K_c_min" "K_(c,min)" ONE / ONE [infinite("without a sudden wind")], "Least safety against capsizing in a sudden wind in the working range.", "derived";
    GM_MIN: "GM_min" "\"GM\"_(0,min)" M / M, "Least metacentric height in the working range, free surfaces counted.", "derived";
    U_MAX: "u_max" "u_max" ONE / ONE, "Greatest utilisation of the criteria in all further load cases.", "derived";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}
