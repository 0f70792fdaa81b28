//! Every quantity of a drive: where it takes hold, its line and force, its screw, pinion, sector, crank or rope.

use crate::kernel::symbol::{Range, symbols};

symbols! {
    // Given.
    E_X: "E_x" "x_E" M / M, "Anchor of the drive on the frame, forward of O1.", "input";
    E_Y: "E_y" "y_E" M / M, "Anchor of the drive on the frame, above O1.", "input";
    S_D: "s_d" "s_d" M / M [positive], "Anchor of the drive on the driving link, from its foot.", "input";
    CHI_D: "chi_d" "chi_d" RAD / DEG, "Anchor of the drive on the driving link, counter-clockwise from the bar.", "input";
    D_C: "D_c" "D_c" M / MM [positive], "Bore of the luffing cylinder.", "input";
    D_R: "d_r" "d_r" M / MM [not_negative], "Rod diameter of the luffing cylinder.", "input";

    D_2: "d_2" "d_2" M / MM [positive], "Pitch diameter of the drive's screw.", "[Ports001, 5.3]";
    P_H: "p_h" "p_h" M / MM [positive], "Lead of the drive's screw: travel of its nut in one turn.", "[Ports001, 5.3]";
    MU_D: "mu_d" "mu_d" ONE / ONE [not_negative], "Friction between screw and nut.", "[Ports001, 5.3]";
    BETA_D: "beta_d" "beta_d" RAD / DEG [within(Range::new(0.0, 1.0))], "Angle of the thread's flank from square to the screw's axis: 15 deg trapezoidal, 0 square.", "[Ports001, 5.3]";
    R_Z: "r_z" "r_z" M / MM [positive], "Pitch radius of the pinion that pushes the rack or turns the sector.", "[Ports001, 5.3]";
    ETA_D: "eta_d" "eta_d" ONE / ONE [within(Range::new(0.0, 1.0).above())], "Efficiency of the pinion and what it drives, of a crank, or of the luffing tackle with its drum.", "[Ports001, 5.3]";

    M_R: "m_r" "m_r" ONE / ONE [positive], "Falls of the luffing tackle.", "[Ports001, 5.1]";
    R_TR: "r_tr" "r_(t r)" M / MM [positive], "Radius of the drum of the luffing rope, to the rope's middle.", "[Ports001, 5.1]";

    R_S: "r_s" "r_s" M / M [positive], "Pitch radius of the toothed sector, about the foot of the driving link.", "[Ports001, 5.3]";
    DELTA_S: "delta_s" "delta_s" RAD / DEG, "Direction from the foot of the driving link to the pinion in the sector.", "[Ports001, 5.3]";

    R_CR: "r_cr" "r_(c r)" M / M [positive], "Radius of the crank, about its centre on the frame.", "[Ports001, 5.3]";
    L_CR: "l_cr" "l_(c r)" M / M [positive], "Length of the rod from the crank to the driving link.", "[Ports001, 5.3]";

    // Closure of crank and rod.
    D_CR: "d_cr" "d_(c r)" M / M, "Distance of the crank's centre from the foot of the driving link.", "[Ports001, 5.3]";
    DELTA_CR: "delta_cr" "delta_(c r)" RAD / DEG, "Direction from the foot of the driving link to the crank's centre.", "[Ports001, 5.3]";
    PHI_CRS: "phi_crs" "phi_(c r s)" RAD / DEG, "Dead point: crank and rod stretched in one line.", "derived";
    PHI_CRS2: "phi_crs2" "phi'_(c r s)" RAD / DEG, "Other dead point: crank and rod stretched in one line.", "derived";
    PHI_CRF: "phi_crf" "phi_(c r f)" RAD / DEG, "Dead point: crank and rod folded in one line.", "derived";
    PHI_CRF2: "phi_crf2" "phi'_(c r f)" RAD / DEG, "Other dead point: crank and rod folded in one line.", "derived";
    PHI_D: "phi_d" "phi_d" RAD / DEG, "Direction from the foot of the driving link to the anchor of the drive on it.", "[Ports001, 5.3]";
    R_DX: "r_d.x" "x_(r d)" M / M, "Anchor of the drive on the driving link, forward of its foot.", "derived";
    R_DY: "r_d.y" "y_(r d)" M / M, "Anchor of the drive on the driving link, above its foot.", "derived";
    A_CRX: "a_cr.x" "a_(c r x)" M / M, "From the crank's centre to the anchor on the driving link, forward component.", "derived";
    A_CRY: "a_cr.y" "a_(c r y)" M / M, "From the crank's centre to the anchor on the driving link, upward component.", "derived";
    A_CR: "a_cr" "a_(c r)" M / M, "Distance of the anchor on the driving link from the crank's centre.", "derived";
    SIGMA_CRS: "sigma_crs" "sigma_(c r s)" M2 / M2, "Margin to the dead points with crank and rod stretched.", "derived";
    SIGMA_CRF: "sigma_crf" "sigma_(c r f)" M2 / M2, "Margin to the dead points with crank and rod folded.", "derived";
    K_CR: "K_cr" "K_(c r)" M2 / M2, "Four times the area of the triangle of crank, rod and the line between their ends; its sign is the branch of assembly.", "derived";
    R_CRX: "r_cr.x" "r_(c r x)" M / M, "Crank, forward component.", "derived";
    R_CRY: "r_cr.y" "r_(c r y)" M / M, "Crank, upward component.", "derived";
    L_CRX: "l_cr.x" "l_(c r x)" M / M, "Rod from the driving link to the crank, forward component.", "derived";
    L_CRY: "l_cr.y" "l_(c r y)" M / M, "Rod from the driving link to the crank, upward component.", "derived";

    // Crank.
    THETA_CR: "theta_cr" "theta_(c r)" RAD / DEG, "Angle of the crank above the horizontal.", "[Ports001, 5.3]";
    H_CR: "h_cr" "h_(c r)" M / M, "Lever arm of the rod about the crank's centre; positive where a push needs a counter-clockwise torque. Zero at its dead points.", "[Ports001, 5.3]";
    ALPHA_CR: "alpha_cr" "alpha_(c r)" RAD / DEG, "Angle from the crank to the circle on which the anchor of the driving link moves.", "[Ports001, 5.3]";
    BETA_CR: "beta_cr" "beta_(c r)" RAD / DEG, "Angle from the circle on which the anchor of the driving link moves to the rod.", "[Ports001, 5.3]";
    F_CR: "F_cr" "F_(c r)" N / KN, "Force of the rod by the form for a slider: the force across the link's arm over the cosine of the rod's angle.", "[Ports001, 5.3]";
    T_CR: "T_cr" "T_(c r)" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Torque of the crank without friction by the form for a slider, the anchor's circle as its line.", "[Ports001, 5.3]";

    // Line.
    L_DX: "L_d.x" "L_(d x)" M / M, "Drive from frame to driving link, forward component.", "derived";
    L_DY: "L_d.y" "L_(d y)" M / M, "Drive from frame to driving link, upward component.", "derived";
    L_D: "L_d" "L_d" M / M [not_negative], "Length of the drive between its anchors.", "derived";
    H_D: "h_d" "h_d" M / M, "Lever arm of the drive; positive where a push turns the driving link counter-clockwise.", "derived";
    V_D: "v_d" "v_d" M_PER_S / MM_PER_S, "Speed of the drive, lengthening positive.", "derived";
    A_D: "A_d" "A_d" M2 / M2, "Working area of the cylinder: bore when it lengthens, annulus when it shortens.", "derived";
    Q_D: "q_d" "q_d" M3_PER_S / L_PER_MIN, "Oil flow to the cylinder; negative where it shortens.", "derived";
    F_D: "F_d" "F_d" N / KN [infinite("where the drive points at the foot of its bar")], "Force of the drive, push positive.", "equilibrium";

    // Screw.
    LAMBDA_D: "lambda_d" "lambda_d" RAD / DEG, "Lead angle of the screw.", "[Ports001, 5.3]";
    RHO_D: "rho_d" "rho'_d" RAD / DEG, "Angle of friction of the thread.", "[Ports001, 5.3]";
    LOCK_D: "lock_d" "Delta rho_d" RAD / DEG, "Angle of friction less lead angle: where positive the screw locks itself.", "[Ports001, 5.3]";

    // Shaft.
    N_D: "n_d" "n_d" PER_S / PER_MIN [infinite("at a dead point of the crank")], "Speed of the screw, pinion or drum, positive where the drive lengthens; of a crank counter-clockwise.", "[Ports001, 5.3]";
    T_D: "T_d" "T_d" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Torque of the screw, pinion or drum without friction, positive where it lengthens the drive; of a crank counter-clockwise.", "[Ports001, 5.3]";
    T_D_OUT: "T_d.out" "T_(d, arrow.r)" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Torque of the screw, pinion or drum while the drive lengthens, or of a crank while its rod goes towards the driving link; signs as without friction.", "[Ports001, 5.3]";
    T_D_IN: "T_d.in" "T_(d, arrow.l)" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Torque of the screw, pinion or drum while the drive shortens, or of a crank while its rod goes away from the driving link; signs as without friction.", "[Ports001, 5.3]";

    // Rope.
    S_L: "S_l" "S_l" N / KN [infinite("where the drive points at the foot of its bar")], "Pull of the luffing rope, without friction; a rope cannot give a negative one.", "[Ports001, 5.1]";
    S_L_OUT: "S_l.out" "S_(l, arrow.r)" N / KN [infinite("where the drive points at the foot of its bar")], "Pull of the luffing rope at its drum while the tackle lengthens.", "[Ports001, 5.1]";
    S_L_IN: "S_l.in" "S_(l, arrow.l)" N / KN [infinite("where the drive points at the foot of its bar")], "Pull of the luffing rope at its drum while the tackle shortens.", "[Ports001, 5.1]";

    // Rope in motion.
    S_LM: "S_lm" "S_(l m)" N / KN [infinite("where the drive points at the foot of its bar")], "Pull of the luffing rope in motion, without friction: the drive's force over the falls, with what the inertia of the motor's shaft takes.", "[Ports001, 5.1]";
    S_LM_OUT: "S_lm.out" "S_(l m, arrow.r)" N / KN [infinite("where the drive points at the foot of its bar")], "Pull of the luffing rope at its drum in motion, while the tackle lengthens.", "[Ports001, 5.1]";
    S_LM_IN: "S_lm.in" "S_(l m, arrow.l)" N / KN [infinite("where the drive points at the foot of its bar")], "Pull of the luffing rope at its drum in motion, while the tackle shortens.", "[Ports001, 5.1]";
    Z_PULL: "z.pull" "z_p" N / KN [infinite("where the drive points at the foot of its bar")], "Falls below zero where the luffing rope would have to push: there this motion ends.", "event";

    // The whole range of motion.
    F_D_MAX: "F_d_max" "F_(d,max)" N / KN [infinite("where the drive points at the foot of its bar")], "Greatest force of the drive in the working range, by amount; push positive.", "equilibrium";
    T_D_OUT_MAX: "T_d_out_max" "T_(d arrow.r,max)" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Greatest torque of the screw, pinion, drum or crank in the working range, by amount, while the drive lengthens.", "derived";
    T_D_IN_MAX: "T_d_in_max" "T_(d arrow.l,max)" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Greatest torque of the screw, pinion, drum or crank in the working range, by amount, while the drive shortens.", "derived";
    S_L_MIN: "S_l_min" "S_(l,min)" N / KN [infinite("where the drive points at the foot of its bar")], "Least pull of the luffing rope in the working range, without friction.", "derived";
    S_L_MAX: "S_l_max" "S_(l,max)" N / KN [infinite("where the drive points at the foot of its bar")], "Greatest pull of the luffing rope at its drum in the working range, while the tackle shortens.", "derived";
}
