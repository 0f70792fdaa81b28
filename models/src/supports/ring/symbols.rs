//! Quantities of a slewing ring besides those of what slews on it.

use crate::kernel::symbol::{Range, symbols};
pub use crate::supports::drive::symbols::{J_D, M_FS, M_FS0, M_LC, RHO_C};
pub use crate::supports::upper::symbols::{
    AGREEMENT, FROM, H, H_1, H_ALL, H_TOP, M, M_ALL, M_TOP, OMEGA, PSI, Q, R, THETA_1, TO, V, V_TOP,
};

symbols! {
    // Given.
    D: "D" "D" M / M [positive], "Diameter of the raceway.", "input";
    Z: "z" "z" ONE / ONE [within(Range::new(3.0, 1000.0))], "Number of rolling elements in the row that bears the weight.", "input";
    ALPHA: "alpha" "alpha" RAD / DEG [from_to(0.1, 1.6)], "Contact angle: of the force on a rolling element from the plane of the ring.", "input";
    E: "E" "E" PA / MPA [positive], "Modulus of elasticity of rolling elements and raceways.", "input";
    NU: "nu" "nu" ONE / ONE [from_to(0.0, 0.5)], "Poisson's ratio of rolling elements and raceways.", "input";
    RHO: "rho" "rho" M / MM [positive], "Equivalent radius of curvature of rolling element and raceway.", "input";
    B_R: "b_r" "b_\"r\"" M / MM [positive], "Length on which a roller bears.", "input";
    HB: "HB" "\"HB\"" ONE / ONE [positive], "Brinell hardness of the raceway.", "input";
    K_HB: "k_HB" "k_\"HB\"" PA / MPA [positive, unconfirmed], "Contact stress that may act for each unit of hardness.", "input";
    K_V: "k_v" "k_\"v\"" ONE / ONE [positive, unconfirmed], "Factor of the vertical force in the equivalent force.", "input";
    K_R: "k_r" "k_\"r\"" ONE / ONE [not_negative, unconfirmed], "Factor of the horizontal force in the equivalent force.", "input";
    K_M: "k_m" "k_\"m\"" ONE / ONE [positive, unconfirmed], "Factor of the moment in the equivalent moment.", "input";
    F_ST: "f_st" "f_\"st\"" ONE / ONE [positive, unconfirmed], "Factor of the equivalent loads with which the ring is looked up in its load curve.", "input";
    F_CURVE: "F_curve" "F_(\"c\" i)" N / KN [not_negative], "Force at a point of the load curve.", "input";
    M_CURVE: "M_curve" "M_(\"c\" i)" N_M / KN_M [not_negative], "Moment that may act with this force.", "input";
    MU_N: "mu_n" "mu_\"n\"" ONE / ONE [not_negative, unconfirmed], "Friction coefficient of the textbook's form, for the forces on all rolling elements.", "input";
    MU_M: "mu_m" "mu_\"m\"" ONE / ONE [not_negative, unconfirmed], "Friction coefficient of the maker's form, for no other form.", "input";
    N_B: "n_b" "n_\"b\"" ONE / ONE [within(Range::new(3.0, 1000.0))], "Number of bolts of the ring that is checked, on one circle.", "input";
    D_B: "D_b" "D_\"b\"" M / M [positive], "Diameter of the bolts' circle.", "input";
    F_P: "F_p" "F_\"p\"" N / KN [positive], "Preload of a bolt, least of what its tightening leaves.", "input";
    F_Y: "F_y" "F_\"y\"" N / KN [positive], "Force at which a bolt yields.", "input";
    PHI_B: "phi_b" "phi_\"b\"" ONE / ONE [from_to(0.0, 1.0), unconfirmed], "Part of a pull on the joint that a bolt feels on top of its preload.", "input";
    MU_B: "mu_b" "mu_\"b\"" ONE / ONE [from_to(0.0, 1.0), unconfirmed], "Friction coefficient of the bolted joint.", "input";
    C_D: "C_d" "C_\"d\"" N / KN [positive], "Dynamic capacity of the raceway: axial force that it bears for a million revolutions.", "input";
    K_H: "k_h" "k_\"h\"" ONE / ONE [not_negative, unconfirmed], "Factor of the horizontal force in the equivalent force of the life.", "input";

    // Rolling elements.
    V_M: "V_M" "V_(M i)" N / KN, "Vertical force and the couple on the diameter that stands for the moment.", "derived";
    KAPPA: "kappa" "kappa_i" ONE / ONE, "Part of the couple in that: 1/3 where the far side of a ring that yields linearly bears nothing, 1/2 where all hangs on the nearest element.", "derived";
    LAMBDA_0: "lambda_0" "lambda_(0 i)" ONE / ONE, "Fall of the approach as a search has found it.", "derived";
    KAPPA_0: "kappa_0" "kappa_(0 i)" ONE / ONE, "Part of the couple that the forces have there.", "derived";
    D_KAPPA: "d_kappa" "kappa'_(0 i)" ONE / ONE, "How it grows there with the fall.", "derived";
    LAMBDA_A: "lambda_a" "lambda_i" ONE / ONE, "Fall of the approach over the ring: an element yields by 1 − λ (1 − c), c being the cosine of its angle from the direction of the moment.", "equilibrium";
    C_J: "c_j" "c_j" ONE / ONE, "Cosine of the angle of rolling element j from the direction of the moment; the first one lies there.", "derived";
    J_S: "J_s" "J_(\"s\" i)" ONE / ONE, "Mean of the forces on the rolling elements with 1 + c, over the greatest force.", "equilibrium";
    J_N: "J_n" "J_(\"n\" i)" ONE / ONE, "Mean of the forces on the rolling elements by amount, over the greatest force.", "equilibrium";
    P_MAX: "P_max" "P_(max i)" N / KN, "Greatest force on a rolling element, square to the ring.", "[Ports001, 6.3.1.1]";
    Q_FAR: "q_far" "q_(\"f\" i)" ONE / ONE, "Approach of ring and rolling element on the far side, over the greatest; negative where they would part.", "derived";
    P_MIN: "P_min" "P_(min i)" N / KN, "Force on the rolling element on the far side, square to the ring; negative where the hold-down row bears it, zero where nothing does.", "[Ports001, 6.3.1.1]";
    S_N: "S_N" "N_(Sigma i)" N / KN, "Sum of the forces on all rolling elements, by amount, in their direction of contact.", "[Ports001, 6.3.1.3]";
    N_MAX: "N_max" "N_(max i)" N / KN, "Greatest force on a rolling element in its direction of contact.", "[Ports001, 6.3.1.1]";
    P_ALL: "P_all" "P_\"all\"" N / KN, "Greatest force on a rolling element of all load cases, square to the ring.", "derived";
    LIFTS: "lifts" "\"lifts\"" ONE / ONE [boolean], "Whether the far side would be lifted in one of the cases: a hold-down row bears there, or nothing.", "derived";
    Z_LIFT: "z.lift" "z_1" ONE / ONE, "Falls below zero where the far side of the ring would be lifted in one of the cases.", "event";

    // A moment alone.
    C_P: "c_P" "c_P" ONE / ONE, "Greatest force on a rolling element under a moment alone, with their number and the diameter over the moment: 4 where they yield linearly.", "equilibrium";
    C_SIGMA: "c_Sigma" "c_Sigma" ONE / ONE, "Sum of the forces on all rolling elements by amount under a moment alone, with the diameter over the moment: 8/π where they yield linearly.", "equilibrium";
    ZETA_1: "zeta_1" "zeta_1" ONE / ONE, "Mean of the forces with their cosine under a moment alone, over the greatest force.", "equilibrium";
    ZETA_2: "zeta_2" "zeta_2" ONE / ONE, "Mean of the forces by amount under a moment alone, over the greatest force.", "equilibrium";

    // Contact, capacity, friction.
    E_STAR: "E_star" "E^*" PA / MPA, "Modulus of the contact of two bodies alike.", "[Ports001, 6.3.1.2]";
    SIGMA_ALL: "sigma_all" "sigma_\"all\"" PA / MPA, "Contact stress that the hardness allows.", "[Ports001, 6.3.1.2]";
    SIGMA_H: "sigma_H" "sigma_(H i)" PA / MPA, "Greatest contact stress of a rolling element.", "[Ports001, 6.3.1.2]";
    U_H: "u_H" "u_(H i)" ONE / ONE, "Contact stress over what the hardness allows.", "derived";
    F_E: "F_e" "F_(e i)" N / KN, "Equivalent vertical force.", "[Rothe Erde]";
    M_E: "M_e" "M_(e i)" N_M / KN_M, "Equivalent moment.", "[Rothe Erde]";
    F_REF: "F_ref" "F_(\"st\" i)" N / KN, "Reference force with which the ring is looked up in its load curve.", "[Rothe Erde]";
    M_REF: "M_ref" "M_(\"st\" i)" N_M / KN_M, "Reference moment with which the ring is looked up in its load curve.", "[Rothe Erde]";
    S_0: "S_0" "S_(0 i)" ONE / ONE, "Static safety: how many times the equivalent loads may grow until they meet the load curve.", "derived";
    U_ST: "u_st" "u_(\"st\" i)" ONE / ONE, "Reference loads over those on the load curve in their direction.", "derived";
    M_FN: "M_fn" "M_(\"fn\" i)" N_M / KN_M, "Friction moment by the forces on all rolling elements, with the textbook's coefficient.", "[Ports001, 6.3.1.3]";
    M_FM: "M_fm" "M_(\"fm\" i)" N_M / KN_M, "Friction moment by the maker's form, with its coefficient.", "[Rothe Erde]";

    // Bolts and life.
    F_B: "F_b" "F_(\"b\" i)" N / KN, "Pull on the joint at the bolt that lies farthest from the side that the moment loads; negative where it is pressed.", "equilibrium";
    F_BM: "F_bm" "F_(\"bm\" i)" N / KN, "Greatest force of a bolt, with its preload.", "equilibrium";
    S_B: "S_b" "S_(\"b\" i)" ONE / ONE, "Safety of the bolts against yielding.", "derived";
    F_K: "F_k" "F_(\"k\" i)" N / KN, "Clamping force that is left of a bolt's preload where the joint is pulled most; negative where it opens.", "equilibrium";
    S_H: "S_h" "S_(\"h\" i)" ONE / ONE [infinite("where no horizontal force acts")], "Safety of the bolted joint against slip.", "Coulomb";
    P_E: "P_e" "P_(\"e\" i)" N / KN, "Equivalent force of the life.", "equilibrium";
    L_10: "L_10" "L_(10 i)" ONE / ONE, "Life of the raceway that nine rings of ten reach, in millions of revolutions.", "Lundberg and Palmgren";

    // The whole range.
    P_TOP: "P_top" "P_max" N / KN, "Greatest force on a rolling element in the working range, square to the ring.", "derived";
    P_LOW: "P_low" "P_min" N / KN, "Least force on a rolling element in the working range; negative where the hold-down row bears it.", "derived";
    Q_LOW: "q_low" "q_min" ONE / ONE, "Least approach on the far side in the working range, over the greatest; negative where ring and rolling element would part.", "derived";
    U_H_MAX: "u_H_max" "u_(H,max)" ONE / ONE, "Greatest contact stress in the working range over what the hardness allows.", "derived";
    U_ST_MAX: "u_st_max" "u_(\"st\",max)" ONE / ONE, "Greatest use of the load curve in the working range.", "derived";
    S_0_MIN: "S_0_min" "S_(0,min)" ONE / ONE, "Least static safety in the working range.", "derived";
    M_FN_MAX: "M_fn_max" "M_(\"fn\",max)" N_M / KN_M, "Greatest friction moment in the working range, with the textbook's coefficient.", "derived";
    M_FM_MAX: "M_fm_max" "M_(\"fm\",max)" N_M / KN_M, "Greatest friction moment in the working range, by the maker's form.", "derived";
    F_B_MAX: "F_b_max" "F_\"b,max\"" N / KN, "Greatest pull on the joint at a bolt in the working range.", "derived";
    S_B_MIN: "S_b_min" "S_\"b,min\"" ONE / ONE, "Least safety of the bolts against yielding in the working range.", "derived";
    F_K_MIN: "F_k_min" "F_\"k,min\"" N / KN, "Least clamping force of a bolt in the working range; negative where the joint opens.", "derived";
    S_H_MIN: "S_h_min" "S_\"h,min\"" ONE / ONE [infinite("where no horizontal force acts")], "Least safety of the bolted joint against slip in the working range.", "derived";
    L_10_MIN: "L_10_min" "L_(10,min)" ONE / ONE, "Least life of the raceway in the working range, in millions of revolutions: as long as if it always turned there.", "derived";
}
