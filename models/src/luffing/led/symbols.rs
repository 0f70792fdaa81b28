//! Every quantity of a hoist rope that is led over sheaves.

use crate::kernel::symbol::symbols;

symbols! {
    H_Q: "h_Q" "h_Q" M / M [not_negative], "Height of the head A above the load at the start of the working range.", "input";
    X_R: "x_r" "x_(r i)" M / M, "Sheave of the hoist rope, along its bar from the bar's first joint; forward of O1 on the frame.", "[Ports001, 5.9.2.4]";
    Y_R: "y_r" "y_(r i)" M / M, "Sheave of the hoist rope, square to its bar, counter-clockwise positive; above O1 on the frame.", "[Ports001, 5.9.2.4]";

    // Position.
    S_RX: "S_r.x" "x_(S i)" M / M, "Sheave of the hoist rope, forward of O1.", "derived";
    S_RY: "S_r.y" "y_(S i)" M / M, "Sheave of the hoist rope, above O1.", "derived";
    L_RS: "l_rs" "l_(r i)" M / M [not_negative], "Hoist rope between a sheave and what it comes from: the sheave before, or the head A.", "derived";
    E_RX: "e_r.x" "e_(x i)" ONE / ONE, "Direction of the rope before a sheave, from where it comes, forward.", "derived";
    E_RY: "e_r.y" "e_(y i)" ONE / ONE, "Direction of the rope before a sheave, from where it comes, upward.", "derived";
    L_LED: "L_led" "L_r" M / M [not_negative], "Hoist rope from the head A over all sheaves to the last one, on the frame.", "[Ports001, 5.9.2.4]";
    L_LEDA: "L_led_a" "L_(r a)" M / M [not_negative], "Hoist rope from the head A over all sheaves to the frame, at the start of the working range.", "[Ports001, 5.9.2.4]";
    C_Q: "c_Q" "c_Q" M / M, "Height of the load less that of the head, without the rope between head and frame.", "[Ports001, 5.9.2.4]";
    Y_Q: "Y_Q" "y_Q" M / M, "Height of the load above O1 with the hoist drum at rest.", "[Ports001, 5.9.2.4]";

    // Velocity.
    DL_RS: "dl_rs" "l'_(r i)" M / M, "Change of the rope before a sheave for one radian of the luffing angle.", "derived";
    DL_LED: "dL_led" "L'_r" M / M, "Change of the led rope for one radian of the luffing angle.", "[Ports001, 5.9.2.4]";
    DDL_LED: "ddL_led" "L''_r" M / M, "Change of that for one radian of luffing: of each stretch what its ends move square to it, by its length, and what their travel changes along it.", "derived";
    V_Q: "V_Q" "V_Q" M_PER_S / M_PER_S, "Vertical velocity of the load with the hoist drum at rest, upward positive.", "derived";

    // Forces.
    S_H: "S_h" "S_h" N / KN, "Pull of the hoist rope, without losses.", "[Ports001, 5.9.2.4]";
    F_R1X: "F_r1.x" "F_(r 1 x)" N / KN, "Force of the hoist rope on the boom, forward.", "equilibrium";
    F_R1Y: "F_r1.y" "F_(r 1 y)" N / KN, "Force of the hoist rope on the boom, upward.", "equilibrium";
    F_R2X: "F_r2.x" "F_(r 2 x)" N / KN, "Force of the hoist rope on jib or trunk, forward.", "equilibrium";
    F_R2Y: "F_r2.y" "F_(r 2 y)" N / KN, "Force of the hoist rope on jib or trunk, upward.", "equilibrium";
    F_R3X: "F_r3.x" "F_(r 3 x)" N / KN, "Force of the hoist rope on the rocker, forward.", "equilibrium";
    F_R3Y: "F_r3.y" "F_(r 3 y)" N / KN, "Force of the hoist rope on the rocker, upward.", "equilibrium";
    M_R1: "M_r1" "M_(r 1)" N_M / KN_M, "Moment of the hoist rope on the boom about O1, counter-clockwise.", "equilibrium";
    M_R2: "M_r2" "M_(r 2)" N_M / KN_M, "Moment of the hoist rope on jib or trunk about B, counter-clockwise.", "equilibrium";
    M_R3: "M_r3" "M_(r 3)" N_M / KN_M, "Moment of the hoist rope on the rocker about O3, counter-clockwise.", "equilibrium";

    // The whole range of motion.
    DELTA_YQ: "Delta_Y_Q" "Delta y_Q" M / M [not_negative], "Level error of the load: its greatest less its smallest height over the working range, the hoist drum at rest.", "[Ports001, 5.9.2.4]";
    EPSILON_YQ: "epsilon_Y_Q" "epsilon_(Y Q)" ONE / PERCENT [not_negative], "Level error of the load over the reach covered.", "[Ports001, 5.9.2.4]";
}
