//! Every quantity of the strength of what drives a luffing mechanism.

use crate::kernel::symbol::symbols;
pub use crate::parts::teeth::{ALPHA_T, E_T, K_F, M_T, NU_T, RHO_C, Y_F};

symbols! {
    // Given: of buckling.
    E_K: "E_k" "E_k" PA / MPA [positive], "Young's modulus of the drive's bar.", "[Ports001, 5.8]";
    SIGMA_Y: "sigma_y" "sigma_y" PA / MPA [positive], "Yield point of the drive's bar.", "[Ports001, 5.8]";
    S_K: "S_k" "S_k" ONE / ONE [positive], "Safety that is asked for against buckling.", "[Ports001, 5.8]";
    MU_K: "mu_k" "mu_k" ONE / ONE [positive], "End factor: buckling length over free length, 1 where both ends are hinged.", "[Ports001, 5.8]";
    L_0: "l_0" "l_0" M / M [not_negative], "Part of the drive's length that is not free: guided, or stiff.", "input";
    A_K: "A_k" "A_k" M2 / M2 [positive], "Cross-section of the rack, or of the crank's rod.", "input";
    I_MIN: "i_min" "i_\"min\"" M / MM [positive], "Smallest radius of gyration of this cross-section.", "input";

    // Given: of teeth, screw and nut, rope, pins.
    B_F: "b_f" "b_f" M / MM [positive], "Width of the teeth.", "input";
    D_3: "d_3" "d_3" M / MM [positive], "Core diameter of the drive's screw.", "input";
    H_1: "H_1" "H_1" M / MM [positive], "Depth to which the threads of screw and nut overlap.", "input";
    P_1: "P_1" "P_1" M / MM [positive], "Pitch of the drive's screw: from one turn of a thread to the next thread.", "input";
    L_N: "l_n" "l_n" M / MM [positive], "Length of the nut.", "input";
    F_MIN: "F_min" "F_\"min\"" N / KN [positive], "Minimum breaking force of the luffing rope.", "input";
    Z_P: "Z_p" "Z_p" ONE / ONE [positive], "Safety factor that is asked of the luffing rope, by its class.", "[Ports001, 5.8]";
    D_W: "d_w" "d_w" M / MM [positive], "Diameter of the luffing rope.", "input";
    D_TR: "D_tr" "D_\"tr\"" M / MM [positive], "Diameter of the luffing drum, to the rope's centre.", "input";
    D_SH: "D_sh" "D_\"sh\"" M / MM [positive], "Diameter of the smallest sheave of the tackle, to the rope's centre.", "input";
    D_P: "d_p" "d_(p k)" M / MM [positive], "Diameter of a pin.", "input";
    B_P: "b_p" "b_(p k)" M / MM [positive], "Width over which a pin is pressed.", "input";

    // At a position.
    L_K: "l_k" "l_k" M / M, "Buckling length of the drive's bar.", "Euler";
    LAMBDA_K: "lambda_k" "lambda_k" ONE / ONE, "Slenderness of the drive's bar: its buckling length over its radius of gyration.", "Euler";
    LAMBDA_G: "lambda_g" "lambda_g" ONE / ONE, "Slenderness from which the bar buckles before it yields anywhere; there the critical stress is half the yield point.", "Euler and Johnson";
    SIGMA_CR: "sigma_cr" "sigma_\"cr\"" PA / MPA, "Critical stress of the drive's bar.", "Euler and Johnson";
    N_CR: "N_cr" "N_\"cr\"" N / KN, "Push at which the drive's bar buckles.", "Euler and Johnson";
    A_3: "A_3" "A_3" M2 / M2, "Cross-section of the screw's core.", "[Ports001, 5.8]";
    A_N: "A_n" "A_n" M2 / M2, "Flanks on which the nut carries, seen along the screw.", "[Ports001, 5.8]";
    H_TR: "h_tr" "h_\"tr\"" ONE / ONE, "Diameter of the drum over that of the luffing rope.", "[Ports001, 5.8]";
    H_SH: "h_sh" "h_\"sh\"" ONE / ONE, "Diameter of the smallest sheave over that of the luffing rope.", "[Ports001, 5.8]";

    // In each case.
    U_K: "u_k" "u_(k i)" ONE / ONE [infinite("where the drive points at the foot of its bar")], "Push of the drive times the safety against buckling, over the push at which its bar buckles.", "[Ports001, 5.8]";
    SIGMA_F: "sigma_F" "sigma_(F i)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Bending stress at the root of the teeth.", "[Ports001, 5.8]";
    SIGMA_H: "sigma_H" "sigma_(H i)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Contact pressure of the teeth at the pitch point.", "[Ports001, 5.8]";
    P_N: "p_n" "p_(n i)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Pressure on the flanks of the nut.", "[Ports001, 5.8]";
    T_N: "T_n" "T_(n i)" N_M / N_M [infinite("where the drive points at the foot of its bar")], "Greatest torque in the screw, by amount: against the force, with friction.", "[Ports001, 5.8]";
    SIGMA_D: "sigma_d" "sigma_(d i)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Stress of the screw's core by the force, by amount.", "[Ports001, 5.8]";
    TAU_D: "tau_d" "tau_(d i)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Greatest stress of the screw's core by torsion.", "[Ports001, 5.8]";
    SIGMA_V: "sigma_v" "sigma_(v i)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Equivalent stress of the screw's core.", "[Ports001, 5.8]";
    P_C: "p_C" "p_(C i)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Oil pressure that the force of the cylinder asks for: on the bore where it pushes, else on the annulus.", "[Ports001, 5.8]";
    S_W: "S_w" "S_(w i)" N / KN [infinite("where the drive points at the foot of its bar")], "Pull of the luffing rope at its drum, with the tackle's losses; where negative the boom falls back on a slack rope.", "[Ports001, 5.8]";
    U_W: "u_w" "u_(w i)" ONE / ONE [infinite("where the drive points at the foot of its bar")], "Pull of the luffing rope times its safety factor, over its minimum breaking force.", "[Ports001, 5.8]";
    P_B: "p_b" "p_(b i)" PA / MPA, "Greatest pressure of all pins whose sizes are given.", "[Ports001, 5.8]";
    TAU_P: "tau_p" "tau_(p i)" PA / MPA, "Greatest mean shear stress of these pins, each sheared twice.", "[Ports001, 5.8]";

    // Over the working range and all cases.
    LAMBDA_K_MAX: "lambda_k_max" "lambda_(k,max)" ONE / ONE, "Greatest slenderness of the drive's bar in the working range.", "Euler";
    U_K_MAX: "u_k_max" "u_(k,max)" ONE / ONE [infinite("where the drive points at the foot of its bar")], "Greatest use of the drive's bar against buckling in all cases, its safety included.", "[Ports001, 5.8]";
    SIGMA_F_MAX: "sigma_F_max" "sigma_(F,max)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Greatest bending stress at the root of the teeth in all cases.", "[Ports001, 5.8]";
    SIGMA_H_MAX: "sigma_H_max" "sigma_(H,max)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Greatest contact pressure of the teeth in all cases.", "[Ports001, 5.8]";
    P_N_MAX: "p_n_max" "p_(n,max)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Greatest pressure on the flanks of the nut in all cases.", "[Ports001, 5.8]";
    SIGMA_V_MAX: "sigma_v_max" "sigma_(v,max)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Greatest equivalent stress of the screw's core in all cases.", "[Ports001, 5.8]";
    P_C_MAX: "p_C_max" "p_(C,max)" PA / MPA [infinite("where the drive points at the foot of its bar")], "Greatest oil pressure that the force of the cylinder asks for in all cases.", "[Ports001, 5.8]";
    U_W_MAX: "u_w_max" "u_(w,max)" ONE / ONE [infinite("where the drive points at the foot of its bar")], "Greatest use of the luffing rope in all cases, its safety factor included.", "[Ports001, 5.8]";
    S_W_MIN: "S_w_min" "S_(w,\"min\")" N / KN [infinite("where the drive points at the foot of its bar")], "Smallest pull of the luffing rope in all cases; where negative the boom falls back on a slack rope.", "[Ports001, 5.8]";
    P_B_MAX: "p_b_max" "p_(b,max)" PA / MPA, "Greatest pressure of the pins in all cases.", "[Ports001, 5.8]";
    TAU_P_MAX: "tau_p_max" "tau_(p,max)" PA / MPA, "Greatest shear stress of the pins in all cases.", "[Ports001, 5.8]";

    // Of each pin at a position, in tables.
    P_BK: "p_bk" "p_(b k)" PA / MPA, "Pressure of a pin: its force over diameter and width.", "[Ports001, 5.8]";
    TAU_PK: "tau_pk" "tau_(p k)" PA / MPA, "Mean shear stress of a pin in two sections.", "[Ports001, 5.8]";
}
