//! Every quantity of the hopper of a crane.

pub use crate::kernel::gravity::G;
use crate::kernel::symbol::symbols;

symbols! {
    // Given.
    M_H: "m_h" "m_h" KG / T [not_negative], "Contents of the hopper.", "continuity of flow";
    Q_IN: "q_in" "q_\"in\"" KG_PER_S / T_PER_H [not_negative], "Flow from the grab into the hopper.", "input";
    FROM: "from" "m_a" KG / T, "Contents at the start of the working range.", "input";
    TO: "to" "m_e" KG / T, "Contents at the end of the working range.", "input";
    M_MAX: "m_max" "m_max" KG / T [positive], "Capacity of the hopper.", "input";
    RHO_B: "rho_b" "rho_b" KG_PER_M3 / KG_PER_M3 [positive], "Bulk density.", "input";
    M_G: "m_g" "m_g" KG / T [positive], "Load of the grab.", "input";
    T_C: "t_c" "t_c" S / S [positive], "Time of a cycle of the grab.", "input";
    T_D: "t_d" "t_d" S / S [not_negative], "Time in which the grab empties itself.", "input";
    T_P: "t_p" "t_p" S / S [not_negative], "Pause of the crane that the contents must bridge.", "input";
    Q_F: "q_f" "q_f" KG_PER_S / T_PER_H [positive], "Flow of the feeder at full speed.", "input";
    Y_F: "y_f" "y_f" ONE / PERCENT [from_to(0.0, 1.0)], "Speed that the feeder is told, over its full speed.", "input";
    STEP: "step" "h" S / S [positive], "Longest step of the solver.", "input";

    // Steady balance.
    Q_G: "q_g" "q_g" KG_PER_S / T_PER_H [not_negative], "Flow of the grab in the mean of its cycles.", "continuity of flow";
    K_Q: "k_q" "k_q" ONE / ONE [not_negative], "Mean flow of the grab over the flow of the feeder; below one the feeder is not fed for ever.", "continuity of flow";
    T_C_MAX: "t_c_max" "t_(c,max)" S / S [not_negative], "Longest cycle of the grab that feeds the feeder.", "continuity of flow";
    M_BR: "m_br" "m_\"br\"" KG / T [not_negative], "Least contents that bridge the pause of the crane.", "continuity of flow";
    D_M: "d_m" "Delta m" KG / T, "Rise of the contents while the grab empties itself; negative where the feeder takes more meanwhile.", "continuity of flow";
    M_NEED: "m_need" "m_\"need\"" KG / T [not_negative], "Capacity that bridges the pause and then takes a load of the grab.", "continuity of flow";
    M_RES: "m_res" "m_\"res\"" KG / T, "Reserve: capacity of the hopper less that which is needed.", "derived";
    V_MAX: "V_max" "V_max" M3 / M3 [not_negative], "Volume of the hopper.", "derived";

    // At any contents.
    G_H: "G_h" "G_h" N / KN, "Weight of the contents.", "derived";
    PHI_H: "phi_h" "phi_h" ONE / PERCENT, "Degree of filling.", "derived";
    V_H: "V_h" "V_h" M3 / M3, "Volume of the contents.", "derived";
    N_G: "n_g" "n_g" ONE / ONE, "Loads of the grab for which there is room, the feeder at rest.", "derived";
    T_RUN: "t_run" "t_\"run\"" S / S, "Time in which the feeder alone empties the hopper.", "continuity of flow";
    T_FULL: "t_full" "t_\"full\"" S / S [infinite("where the grab brings no more than the feeder takes")], "Time until the hopper is full, grab and feeder at their means.", "continuity of flow";
    T_LOW: "t_low" "t_\"low\"" S / S [infinite("where the grab brings as much as the feeder takes, or more")], "Time until the hopper is empty, grab and feeder at their means.", "continuity of flow";

    // In motion.
    M_IN: "m_in" "m_\"in\"" KG / T [not_negative], "Mass that the grab has brought.", "continuity of flow";
    M_OUT: "m_out" "m_\"out\"" KG / T, "Mass that the feeder has taken.", "continuity of flow";
    M_S: "m_s" "m_\"s\"" KG / T [not_negative], "Mass that has been spilled over the full hopper's brim.", "continuity of flow";
    MODE: "mode" "w" ONE / ONE, "Whether the hopper is full (1), empty (-1), or neither (0).", "state";
    Q_C: "q_c" "q_c" KG_PER_S / T_PER_H [not_negative], "Flow that the feeder would take.", "derived";
    Q_OUT: "q_out" "q_\"out\"" KG_PER_S / T_PER_H [not_negative], "Flow that the feeder takes: of an empty hopper what comes in at most.", "continuity of flow";
    Q_S: "q_s" "q_\"s\"" KG_PER_S / T_PER_H [not_negative], "Flow over the full hopper's brim.", "continuity of flow";
    FULL: "full" "\"full\"" ONE / ONE [boolean], "Whether the hopper is full.", "derived";
    EMPTY: "empty" "\"empty\"" ONE / ONE [boolean], "Whether the hopper is empty.", "derived";
    D_M_H: "der(m_h)" "dot(m)_h" KG_PER_S / T_PER_H, "Rate of the contents.", "[Ports001, 7.2.5]";
    D_M_IN: "der(m_in)" "dot(m)_\"in\"" KG_PER_S / T_PER_H, "Rate of the mass that the grab has brought.", "state";
    D_M_OUT: "der(m_out)" "dot(m)_\"out\"" KG_PER_S / T_PER_H, "Rate of the mass that the feeder has taken.", "state";
    D_M_S: "der(m_s)" "dot(m)_\"s\"" KG_PER_S / T_PER_H, "Rate of the mass that has been spilled.", "state";
    Z_FULL: "z.full" "z_1" ONE / ONE, "Falls below zero where the hopper gets full, or is so no more.", "event";
    Z_EMPTY: "z.empty" "z_2" ONE / ONE, "Falls below zero where the hopper gets empty, or is so no more.", "event";

    // The whole range.
    G_H_MAX: "G_h_max" "G_(h,max)" N / KN, "Greatest weight of the contents in the working range.", "derived";
    T_RUN_MAX: "t_run_max" "t_(\"run\",max)" S / S, "Longest time in the working range in which the feeder alone empties the hopper.", "derived";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}
