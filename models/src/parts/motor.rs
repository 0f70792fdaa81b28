//! What any motor with a brake on its shaft has, in cases that a scene names.

use crate::kernel::group::quantities;
use crate::kernel::symbol::symbols;
use crate::parts::motor as s;

symbols! {
    P_N: "P_N" "P_N" W / KW [positive], "Rated power of the motor, at its duty.", "[Ports001, 5.6]";
    N_N: "n_N" "n_N" PER_S / PER_MIN [positive], "Rated speed of the motor.", "[Ports001, 5.6]";
    LAMBDA_M: "lambda_M" "lambda_M" ONE / ONE [positive], "Greatest power that the motor may give for a short time, over its rated power.", "[Ports001, 5.6]";
    K_A: "k_a" "k_a" ONE / ONE [positive], "Mean torque of the motor while it starts, over its rated torque.", "[Ports001, 5.6]";
    J_M: "J_M" "J_M" KG_M2 / KG_M2 [positive], "Inertia of the motor's shaft with coupling and brake drums.", "[Ports001, 5.6]";
    T_B: "T_b" "T_(b 1)" N_M / N_M [positive], "Torque of the brake on the motor's shaft.", "[Ports001, 5.7]";
    TAU_B: "tau_b" "tau_(b 1)" S / S [not_negative], "Time after which the brake acts.", "[Ports001, 5.7]";
    K_B: "K_b" "K_(b i)" ONE / ONE [positive], "Safety with which the brakes must hold what acts in a case.", "[Ports001, 5.7]";
    N_S: "n_s" "n_(s i)" PER_S / PER_MIN, "Speed of steady slewing in a case.", "[Ports001, 5.5.6]";
    N_MOT: "n_mot" "n_(M i)" PER_S / PER_MIN, "Speed of the motor in a case; its sign is that of the drive's speed.", "[Ports001, 5.6]";
    P_M: "P_M" "P_(M i)" W / KW, "Power at the motor's shaft; positive where the motor drives.", "[Ports001, 5.6]";
    U_M: "u_M" "u_(M i)" ONE / ONE, "Power at the motor's shaft over the greatest that the motor may give.", "[Ports001, 5.6]";
    T_0: "T_0" "T_(0 i)" N_M / N_M, "Torque at the motor's shaft against steady motion, without inertia; negative where the load drives.", "[Ports001, 5.6]";
    J_START: "J_start" "J_(t i)" KG_M2 / KG_M2, "Inertia of all that a start accelerates, at the motor's shaft.", "[Ports001, 5.6]";
    T_START: "t_start" "t_(a i)" S / S [infinite("where the motor cannot start")], "Time of a start from this position.", "[Ports001, 5.6]";
    A_START: "a_start" "a_(a i)" M_PER_S2 / M_PER_S2, "Mean horizontal acceleration of the head in a start.", "[Ports001, 5.6]";
    J_K: "J_K" "J_(K i)" KG_M2 / KG_M2, "Inertia of all that the brakes stop, at the motor's shaft.", "[Ports001, 5.7]";
    PSI_B: "psi_b" "psi_(b i)" RAD / RAD, "Turn of the motor's shaft until the last brake begins to act that stops it.", "[Ports001, 5.7]";
    OMEGA_B: "omega_b" "omega_(b i)" RAD_PER_S / RAD_PER_S, "Speed of the motor's shaft when the last brake begins to act that stops it.", "[Ports001, 5.7]";
    T_STOP: "t_stop" "t_(s i)" S / S [infinite("where the brakes do not stop the drive")], "Time of a stop from this position, all brakes called at once.", "[Ports001, 5.7]";
    A_STOP: "a_stop" "a_(s i)" M_PER_S2 / M_PER_S2, "Greatest horizontal deceleration of the head in it.", "[Ports001, 5.7]";
    P_M_MAX: "P_M_max" "P_(M,max)" W / KW, "Greatest power at the motor's shaft in all cases.", "[Ports001, 5.6]";
    U_M_MAX: "u_M_max" "u_(M,max)" ONE / ONE, "Greatest power over the greatest that the motor may give.", "[Ports001, 5.6]";
    T_START_MAX: "t_start_max" "t_(a,max)" S / S [infinite("where the motor cannot start")], "Longest start in all cases.", "[Ports001, 5.6]";
    A_START_MAX: "a_start_max" "a_(a,max)" M_PER_S2 / M_PER_S2, "Greatest mean acceleration of the head in a start.", "[Ports001, 5.6]";
    T_STOP_MAX: "t_stop_max" "t_(s,max)" S / S [infinite("where the brakes do not stop the drive")], "Longest stop in all cases.", "[Ports001, 5.7]";
    A_STOP_MAX: "a_stop_max" "a_(s,max)" M_PER_S2 / M_PER_S2, "Greatest deceleration of the head in a stop.", "[Ports001, 5.7]";
}

quantities! {
    /// A brake on the motor's shaft: its torque (N·m) and after how long it acts (s).
    CaseBrake { torque: T_B, delay: TAU_B }
}

quantities! {
    /// How often the brakes must hold what acts in a case.
    CaseHold { k_b: K_B }
}
