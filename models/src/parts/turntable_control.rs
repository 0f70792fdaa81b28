//! Slewing that follows a commanded speed: a controller of [`crate::parts::control`] gives the moment of its drive.

use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::quantities;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::symbols;
use crate::parts::control::{Latch, SampleNames, SpeedControl};
use crate::parts::turntable::{M_SL, Turning};
use crate::parts::turntable_control as s;

symbols! {
    K_P_SL: "K_psl" "K_\"p sl\"" N_M_S / KN_M_S [positive], "Proportional gain of the slewing controller: moment over the error of the speed.", "input";
    K_I_SL: "K_isl" "K_\"i sl\"" N_M / KN_M [positive], "Integral gain of the slewing controller: moment over the integral of that error.", "input";
    T_C_SL: "T_csl" "T_\"c sl\"" S / MS [from_to(1e-4, 10.0)], "Cycle of the slewing controller: time from one sample to the next.", "input";
    A_SL: "a_sl" "a_\"sl\"" RAD_PER_S2 / RAD_PER_S2 [positive], "Greatest acceleration of the controller's set point.", "input";
    M_MAX_SL: "M_maxsl" "M_\"max sl\"" N_M / KN_M [positive], "Greatest moment of the slewing drive under its controller, by amount.", "input";
    OMEGA_C_SL: "omega_csl" "omega_\"c sl\"" RAD_PER_S / DEG_PER_S, "Commanded angular velocity of slewing.", "input";
    OMEGA_S_SL: "omega_ssl" "omega_\"s sl\"" RAD_PER_S / DEG_PER_S, "Set point of the slewing controller since its last sample.", "derived";
    M_I_SL: "M_isl" "M_\"i sl\"" N_M / KN_M, "Integral part of the moment since the last sample.", "derived";
    M_H_SL: "M_hsl" "M_\"h sl\"" N_M / KN_M, "Moment that the controller holds since its last sample.", "derived";
    OMEGA_N_SL: "omega_nsl" "omega_\"n sl\"" RAD_PER_S / DEG_PER_S, "Set point from this sample to the next.", "derived";
    E_N_SL: "e_nsl" "e_\"n sl\"" RAD_PER_S / DEG_PER_S, "Error of the angular velocity of slewing at a sample.", "derived";
    M_A_SL: "M_asl" "M_\"a sl\"" N_M / KN_M, "Moment that the controller asks for, before its limit.", "derived";
    M_IN_SL: "M_insl" "M_\"i,n sl\"" N_M / KN_M, "Integral part of the moment after this sample, unless the limit holds it.", "derived";
    M_N_SL: "M_nsl" "M_\"n sl\"" N_M / KN_M, "Moment of the drive from this sample to the next.", "derived";
    OMEGA_0_SL: "omega_0sl" "omega_\"0 sl\"" RAD_PER_S / RAD_PER_S, "Natural frequency of all that slews under its controller, undamped.", "derived";
    ZETA_SL: "zeta_sl" "zeta_\"sl\"" ONE / ONE, "Damping ratio of all that slews under its controller.", "derived";
}

quantities! {
    /// What the controller is set to.
    SlewingControl { k_p: K_P_SL, k_i: K_I_SL, t_c: T_C_SL, a: A_SL, m_max: M_MAX_SL }
}

quantities! {
    /// What it is told.
    CommandedSpeed { omega: OMEGA_C_SL }
}

quantities! {
    /// What it holds from one sample to the next.
    Latched { set: OMEGA_S_SL, integral: M_I_SL, moment: M_H_SL }
}

const NAMES: SampleNames = SampleNames {
    set: &OMEGA_N_SL,
    error: &E_N_SL,
    asked: &M_A_SL,
    integral: &M_IN_SL,
    moment: &M_N_SL,
};

/// The table of a scene whose slewing has a controller.
pub const CONTROL: Key = Key::part(
    "control",
    CONTROL_KEYS,
    "Controller of the slewing speed, and its command.",
);

static CONTROL_KEYS: &[Key] = keys! { s:
    K_P_SL > 0, K_I_SL > 0, T_C_SL > 0, A_SL > 0, M_MAX_SL > 0, OMEGA_C_SL [over_time, usually(0.0)]
};

impl<C: Calc> SlewingControl<C> {
    fn control(&self) -> SpeedControl<C> {
        SpeedControl {
            gains: [self.k_p, self.k_i],
            cycle: self.t_c,
            ramp: self.a,
            limit: self.m_max,
        }
    }

    /// One sample at an angular velocity, in rad/s.
    pub fn sample(&self, commanded: &CommandedSpeed<C>, held: &Latched<C>, omega: &C) -> Latched<C> {
        let Latched { set, integral, moment } = *held;
        let held = Latch { set, integral, moment };
        let Latch { set, integral, moment } = self.control().sample(held, commanded.omega, *omega, &NAMES);
        Latched { set, integral, moment }
    }

    /// Natural frequency (rad/s) and damping ratio with an inertia (kg·m²).
    pub fn vibration(&self, turning: &Turning<C>, inertia: C) -> [C; 2] {
        let names = [&OMEGA_0_SL, &ZETA_SL];
        self.control().vibration(inertia, turning.c_sl, names)
    }
}

impl Latched<f64> {
    /// With a set point (rad/s) and no moment yet.
    #[must_use]
    pub fn steady(set: f64) -> Latched<f64> {
        Latched {
            set,
            integral: 0.0,
            moment: 0.0,
        }
    }
}

impl SlewingControl<f64> {
    /// As a table of a scene has it, for an inertia (kg·m²); refuses one that no inertia would follow, and a moment beside it.
    pub fn read_for(
        slewing: &Values,
        inertia: f64,
        found: &mut Vec<Diagnostic>,
    ) -> Option<(SlewingControl<f64>, CommandedSpeed<f64>)> {
        let table = slewing.table(CONTROL.name)?;
        if slewing.has(M_SL.id) {
            let what = "a moment M_sl beside the controller that gives it";
            let help =
                "remove M_sl, and command a speed: omega_csl = \"6 deg/s\" in [slewing.control]; or remove that table";
            found.push(slewing.refuse(M_SL.id, what, "not used", help));
        }
        let own = SlewingControl::read(table)?;
        if !own.control().is_stable(inertia) {
            let what = format!(
                "samples every {} under which a speed swings up",
                T_C_SL.written(own.t_c)
            );
            let help = format!(
                "give a shorter cycle, or other gains: stable is K_i T_c < K_p with 2 K_p T_c < 4 J + K_i T_c^2, J = {}",
                crate::parts::turntable::J_SL.written(inertia)
            );
            found.push(table.refuse(T_C_SL.id, what, "unstable", help));
        }
        let omega = table.number(OMEGA_C_SL.id).unwrap_or(0.0);
        Some((own, CommandedSpeed { omega }))
    }
}
