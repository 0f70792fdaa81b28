//! Quantities of a coupling that slips between the slewing drive and all that slews, as every mechanism has them that knows it.

use crate::kernel::symbol::symbols;

symbols! {
    J_D: "J_d" "J_\"d\"" KG_M2 / T_M2 [positive], "Inertia of the drive's side of the coupling, motors and brakes, reduced to the slewing axis.", "[Ports001, 6.5.4]";
    M_LIM: "M_lim" "M_\"lim\"" N_M / KN_M [positive], "Moment at the slewing axis at which the coupling slips.", "[Ports001, 6.5.4]";
    OMEGA_D: "omega_d" "omega_\"d\"" RAD_PER_S / DEG_PER_S, "Angular velocity of the drive's side of the coupling, reduced to the slewing axis; that of slewing while the coupling sticks.", "equations of motion";
    PSI_SLIP: "psi_slip" "psi_\"slip\"" RAD / DEG, "Angle through which the coupling has slipped, to and fro together.", "equations of motion";
    W_SLIP: "W_slip" "W_\"slip\"" J / KJ, "Heat of the coupling: energy that its slipping has taken.", "equations of motion";
    P_SLIP: "P_slip" "P_\"slip\"" W / KW, "Power that the slipping of the coupling takes.", "equations of motion";
    M_CD: "M_cd" "M_\"c\"" N_M / KN_M, "Moment that the coupling passes on to what slews; while it sticks, what it must: at rest the least by which both sides stay.", "[Ports001, 6.5.4]";
    M_RD: "M_Rd" "M_\"R d\"" N_M / KN_M, "Moment of the brake on the drive's side while the coupling slips; while it sticks, the brake is a part of what resists slewing.", "[Ports001, 6.5.4]";
    E_D: "E_d" "E_\"d\"" J / KJ [not_negative], "Kinetic energy of the drive's side.", "Newton and Euler";
    D_OMEGA_D: "der(omega_d)" "dot(omega)_\"d\"" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the drive's side.", "equations of motion";
    D_PSI_SLIP: "der(psi_slip)" "dot(psi)_\"slip\"" RAD_PER_S / DEG_PER_S, "Angular velocity with which the coupling slips, by amount.", "equations of motion";
    SLIP: "slip" "s" ONE / ONE, "Whether the coupling sticks (0), or which way its drive's side runs from what slews (1, -1).", "state";
    WAY_D: "way_d" "w_\"d\"" ONE / ONE, "Whether the drive's side rests (0) while the coupling slips, or which way it turns (1, -1).", "state";
    Z_D_REST: "z.d_rest" "z_20" ONE / ONE, "Falls below zero where the drive's side comes to rest while the coupling slips, or breaks loose to the right.", "event";
    Z_D_LOOSE: "z.d_loose" "z_21" ONE / ONE, "Falls below zero where the drive's side breaks loose to the left while the coupling slips.", "event";
    Z_C_REST: "z.c_rest" "z_22" ONE / ONE, "Falls below zero where the coupling sticks again, or begins to slip backward.", "event";
    Z_C_LOOSE: "z.c_loose" "z_23" ONE / ONE, "Falls below zero where the coupling begins to slip forward.", "event";
}
