//! Every quantity of a drive's screw, pinion or sector.

use crate::kernel::symbol::{Range, symbols};

symbols! {
    // Given.
    D_2: "d_2" "d_2" M / MM [positive], "Pitch diameter of the drive's screw.", "[Ports001, 5.3]";
    P_H: "p_h" "p_h" M / MM [positive], "Lead of the drive's screw: travel of its nut in one turn.", "[Ports001, 5.3]";
    MU_D: "mu_d" "mu_d" ONE / ONE [not_negative], "Friction between screw and nut.", "[Ports001, 5.3]";
    BETA_D: "beta_d" "beta_d" RAD / DEG [within(Range::new(0.0, 1.0))], "Angle of the thread's flank from square to the screw's axis: 15 deg trapezoidal, 0 square.", "[Ports001, 5.3]";
    R_Z: "r_z" "r_z" M / MM [positive], "Pitch radius of the pinion that pushes the rack or turns the sector.", "[Ports001, 5.3]";
    ETA_D: "eta_d" "eta_d" ONE / ONE [within(Range::new(0.0, 1.0).above())], "Efficiency of the pinion and what it drives.", "[Ports001, 5.3]";

    R_S: "r_s" "r_s" M / M [positive], "Pitch radius of the toothed sector, about the foot of the driving link.", "[Ports001, 5.3]";
    DELTA_S: "delta_s" "delta_s" RAD / DEG, "Direction from the foot of the driving link to the pinion in the sector.", "[Ports001, 5.3]";

    V_D: "v_d" "v_d" M_PER_S / MM_PER_S, "Speed of the drive, lengthening positive.", "derived";

    // Screw.
    LAMBDA_D: "lambda_d" "lambda_d" RAD / DEG, "Lead angle of the screw.", "[Ports001, 5.3]";
    RHO_D: "rho_d" "rho'_d" RAD / DEG, "Angle of friction of the thread.", "[Ports001, 5.3]";
    LOCK_D: "lock_d" "Delta rho_d" RAD / DEG, "Angle of friction less lead angle: where positive the screw locks itself.", "[Ports001, 5.3]";

    // Shaft.
    N_D: "n_d" "n_d" PER_S / PER_MIN, "Speed of the screw or pinion, positive where the drive lengthens.", "[Ports001, 5.3]";
    T_D: "T_d" "T_d" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Torque of the screw or pinion without friction, positive where it lengthens the drive.", "[Ports001, 5.3]";
    T_D_OUT: "T_d.out" "T_(d, arrow.r)" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Torque of the screw or pinion while the drive lengthens, positive in that sense.", "[Ports001, 5.3]";
    T_D_IN: "T_d.in" "T_(d, arrow.l)" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Torque of the screw or pinion while the drive shortens, positive where it lengthens the drive.", "[Ports001, 5.3]";

    // The whole range of motion.
    T_D_OUT_MAX: "T_d_out_max" "T_(d arrow.r,max)" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Greatest torque of the screw or pinion in the working range, by amount, while the drive lengthens.", "derived";
    T_D_IN_MAX: "T_d_in_max" "T_(d arrow.l,max)" N_M / KN_M [infinite("where the drive points at the foot of its bar")], "Greatest torque of the screw or pinion in the working range, by amount, while the drive shortens.", "derived";
}
