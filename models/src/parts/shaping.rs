//! What a command that is shaped against a swing leaves of it, where the load hangs on another length of rope.

use std::f64::consts::{PI, TAU};

use crate::kernel::calc::Calc;
use crate::kernel::symbol::symbols;

symbols! {
    T_SH: "T_sh" "T_\"sh\"" S / S [positive], "Period of a swing against which the command is shaped: its pulses come half of it one after the other.", "input";
    T_SHI: "T_shi" "T_(\"sh\" i)" S / S [positive], "Period of one of the swings against which the command is shaped: its pulses come half of it one after the other.", "input";
    T_R: "T_R" "T_R" S / S [not_negative], "Period of small swings on the rope under a head that moves as commanded.", "derived";
    RHO_RUN: "rho_run" "rho_\"run\"" ONE / ONE [not_negative], "The same in runs of the model: greatest angle of the rope from the vertical in the period after the command's end, over that without shaping.", "equations of motion";
    RHO_SH: "rho_sh" "rho_\"sh\"" ONE / ONE [not_negative], "What the shaped command leaves of the swing: part of that which the command leaves unshaped.", "[Singer1990, 76–82]";
}

/// T = 2π √(l/g) of a rope (m) under gravity (m/s²), and what pulses half of a period T_sh (s) apart leave: ρ = |cos(π/2 T_sh/T)|
/// of two equal ones, its square of three; of several periods, one at least, the product.
pub fn left<C: Calc>(t_sh: &[C], pulses: u64, length: C, gravity: C) -> [C; 2] {
    let period = (C::constant(TAU) * (length / gravity).sqrt()).def(&T_R);
    let of = |t_sh: &C| {
        let (_, cos) = (C::constant(PI) * *t_sh / (C::constant(2.0) * period)).sin_cos();
        if pulses == 2 { cos.abs() } else { cos.square() }
    };
    let parts = t_sh.iter().map(of).reduce(|all, part| all * part);
    [period, parts.map_or(C::constant(1.0), |left| left.def(&RHO_SH))]
}
