//! What a cylinder's equations name in the book, for any mechanism.

use crate::kernel::symbol::symbols;
use crate::parts::hydraulics::oil::VACUUM;

symbols! {
    // Of parts that a scene may leave out, given.
    P_AC: "p_ac" "p_\"ac\"" PA / MPA [from_to(0.0, -VACUUM)], "Cracking pressure of the anti-cavitation valves: they open where a chamber is as far below the tank.", "input";
    K_AC: "k_ac" "k_\"ac\"" M3_PER_SPA / L_PER_MINMPA [positive], "Flow of an anti-cavitation valve over how far a chamber is below its cracking pressure.", "input";
    P_LH: "p_lh" "p_\"lh\"" PA / MPA [positive], "Setting of the load-holding valves: pressure of the chamber at which they open without a pilot.", "input";
    I_LH: "i_lh" "i_\"lh\"" ONE / ONE [not_negative], "Pilot ratio of the load-holding valves: how many times as much as the chamber's pressure that of the other port opens them.", "input";
    DP_LH: "dp_lh" "Delta p_\"lh\"" PA / MPA [positive], "Pressure above their setting at which the load-holding valves are fully open.", "input";
    X_T: "x_T" "x_T" ONE / ONE [from_to(0.0, 1.0)], "Underlap of the valve's edges to the tank: part of the stroke, from the middle and to either side, in which both ports are open to it, so that the load-holding valves shut.", "input";
    Y_B1: "y_b1" "y_(\"b\" 1)" ONE / ONE [from_to(0.0, 1.0)], "Part of the line on the side of the bore that is torn open between port and load-holding valve.", "input";
    Y_B2: "y_b2" "y_(\"b\" 2)" ONE / ONE [from_to(0.0, 1.0)], "Part of the line on the side of the annulus that is torn open between port and load-holding valve.", "input";
    P_TANK: "p_tank" "p_\"tank\"" PA / MPA [from_to(0.0, 1e6)], "Pressure of the oil in the tank; without it the tank is open to the atmosphere.", "input";
    Q_PMAX: "Q_Pmax" "Q_(P,max)" M3_PER_S / L_PER_MIN [positive], "Greatest flow of the pump.", "input";
    P_PMAX: "P_Pmax" "P_(P,max)" W / KW [positive], "Greatest power that the pump gives the oil.", "input";

    Q_ACA: "Q_acA" "Q_(\"ac\" A)" M3_PER_S / L_PER_MIN [not_negative], "Flow from the tank through the anti-cavitation valve into the chamber of the bore.", "continuity of flow";
    Q_ACB: "Q_acB" "Q_(\"ac\" B)" M3_PER_S / L_PER_MIN [not_negative], "Flow from the tank through the anti-cavitation valve into the chamber of the annulus.", "continuity of flow";
    Y_LHA: "y_lhA" "y_(\"lh\" A)" ONE / ONE [from_to(0.0, 1.0)], "Part of the load-holding valve of the bore that is open.", "equilibrium";
    Y_LHB: "y_lhB" "y_(\"lh\" B)" ONE / ONE [from_to(0.0, 1.0)], "Part of the load-holding valve of the annulus that is open.", "equilibrium";
    Q_T1: "Q_t1" "Q_(T 1)" M3_PER_S / L_PER_MIN, "Flow from the port on the side of the bore to the tank in the valve's middle.", "continuity of flow";
    Q_T2: "Q_t2" "Q_(T 2)" M3_PER_S / L_PER_MIN, "Flow from the port on the side of the annulus to the tank in the valve's middle.", "continuity of flow";
    Q_B1: "Q_b1" "Q_(\"b\" 1)" M3_PER_S / L_PER_MIN, "Flow out of the torn line on the side of the bore.", "continuity of flow";
    Q_B2: "Q_b2" "Q_(\"b\" 2)" M3_PER_S / L_PER_MIN, "Flow out of the torn line on the side of the annulus.", "continuity of flow";
    DP_E0: "dp_E0" "Delta p_(E,0)" PA / MPA, "Pressure difference over the pump's edge at its greatest power as a search has found it.", "derived";
    P_E0: "P_E0" "P_(E,0)" W / KW, "Power of the pump at the pressure difference that a search has found.", "derived";
    Q_E0: "Q_E0" "Q_(E,0)" M3_PER_S / L_PER_MIN, "Slope of the pump's power over the pressure difference, at the one that a search has found.", "derived";
    DP_T: "dp_t" "Delta p_t" PA / MPA, "Pressure difference over the pump's edge at its greatest flow, were this turbulent.", "derived";
    DP_E: "dp_E" "Delta p_E" PA / MPA, "Pressure difference over the pump's edge at its limit of flow or power.", "derived";
    P_S: "p_s" "p_s" PA / MPA, "Pressure of the pump as its limits leave it.", "continuity of flow";
    Z_SUCTION_A: "z.suction_A" "z_(\"ac\" A)" PA / MPA, "Falls below zero where the anti-cavitation valve of the bore opens.", "event";
    Z_SUCTION_B: "z.suction_B" "z_(\"ac\" B)" PA / MPA, "Falls below zero where the anti-cavitation valve of the annulus opens.", "event";
    Z_HOLD_A: "z.hold_A" "z_(\"lh\" A)" PA / MPA, "Falls below zero where the load-holding valve of the bore opens.", "event";
    Z_HOLD_B: "z.hold_B" "z_(\"lh\" B)" PA / MPA, "Falls below zero where the load-holding valve of the annulus opens.", "event";
    Z_OPEN_A: "z.open_A" "z_(\"lo\" A)" PA / MPA, "Falls below zero where the load-holding valve of the bore is fully open.", "event";
    Z_OPEN_B: "z.open_B" "z_(\"lo\" B)" PA / MPA, "Falls below zero where the load-holding valve of the annulus is fully open.", "event";
    Z_UNDERLAP: "z.underlap" "z_T" ONE / ONE, "Falls below zero where the valve's spool shuts both ports off from the tank.", "event";
    Z_FLOW: "z.flow" "z_Q" M3_PER_S / L_PER_MIN, "Falls below zero where the pump's flow is at its limit.", "event";
    Z_POWER: "z.power" "z_P" W / KW, "Falls below zero where the pump's power is at its limit.", "event";

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
