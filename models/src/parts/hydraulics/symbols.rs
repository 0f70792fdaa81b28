//! What a cylinder's equations name in the book, for any mechanism.

use crate::kernel::symbol::symbols;

symbols! {
    A_A: "A_A" "A_A" M2 / M2, "Area of the bore.", "derived";
    A_B: "A_B" "A_B" M2 / M2, "Area of the annulus.", "derived";
    DP_LAM: "dp_lam" "Delta p_\"lam\"" PA / MPA, "Pressure difference below which the flow through an edge turns laminar.", "assumption";
    Y_V: "y_v" "y_v" ONE / ONE, "Part of the valve's edges that is open, with the sign of the spool.", "derived";
    Q_1: "Q_1" "Q_1" M3_PER_S / L_PER_MIN, "Flow from the valve into the port on the side of the bore.", "continuity of flow";
    Q_2: "Q_2" "Q_2" M3_PER_S / L_PER_MIN, "Flow from the valve into the port on the side of the annulus.", "continuity of flow";
    Q_0: "Q_0" "Q_0" M3_PER_S / L_PER_MIN, "Flow from the pump: into the port with which the valve connects it.", "continuity of flow";
    Q_LA: "Q_lA" "Q_A" M3_PER_S / L_PER_MIN, "Flow through the line into the chamber of the bore.", "continuity of flow";
    Q_LB: "Q_lB" "Q_B" M3_PER_S / L_PER_MIN, "Flow through the line into the chamber of the annulus.", "continuity of flow";
    Q_R1: "Q_r1" "Q_(r 1)" M3_PER_S / L_PER_MIN, "Flow through the relief valve on the side of the bore.", "continuity of flow";
    Q_R2: "Q_r2" "Q_(r 2)" M3_PER_S / L_PER_MIN, "Flow through the relief valve on the side of the annulus.", "continuity of flow";
    Q_LEAK: "Q_leak" "Q_L" M3_PER_S / L_PER_MIN, "Leakage from bore to annulus.", "continuity of flow";
    V_A: "V_A" "V_A" M3 / L, "Oil in the chamber of the bore.", "derived";
    V_B: "V_B" "V_B" M3 / L, "Oil in the chamber of the annulus.", "derived";
    CAVITATES: "cavitates" "\"cavitates\"" ONE / ONE [boolean], "True while the oil somewhere is below -0.1 MPa, absolute vacuum: it would cavitate, which this model does not have, so that forces and pressures are not those of a machine.", "assumption";
    Z_VACUUM: "z.vacuum" "z_v" PA / MPA, "Changes its sign where the least pressure of the oil passes -0.1 MPa, absolute vacuum.", "event";
}
