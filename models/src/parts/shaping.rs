//! What a command that is shaped against a swing leaves of it, where the load hangs on another length of rope.

use std::f64::consts::{PI, TAU};

use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::symbol::symbols;
use crate::parts::shaping as s;

symbols! {
    T_SH: "T_sh" "T_\"sh\"" S / S [positive], "Period of a swing against which the command is shaped: its second half comes half of it later.", "input";
    T_R: "T_R" "T_R" S / S [not_negative], "Period of small swings on the rope under a head that moves as commanded.", "derived";
    RHO_RUN: "rho_run" "rho_\"run\"" ONE / ONE [not_negative], "The same in runs of the model: greatest angle of the rope from the vertical in the period after the command's end, over that without shaping.", "equations of motion";
    RHO_SH: "rho_sh" "rho_\"sh\"" ONE / ONE [not_negative], "What the shaped command leaves of the swing: part of that which the command leaves unshaped.", "[Singer1990, 76–82]";
}

quantities! {
    /// How the command is shaped.
    Shaping { t_sh: T_SH }
}

impl<C: Calc> Shaping<C> {
    /// T = 2π √(l/g) of a rope (m) under gravity (m/s²), and ρ = |cos(π/2 T_sh/T)|: two equal pulses half of T_sh apart.
    pub fn left(&self, length: C, gravity: C) -> [C; 2] {
        let period = (C::constant(TAU) * (length / gravity).sqrt()).def(&T_R);
        let (_, left) = (C::constant(PI) * self.t_sh / (C::constant(2.0) * period)).sin_cos();
        [period, left.abs().def(&RHO_SH)]
    }
}
