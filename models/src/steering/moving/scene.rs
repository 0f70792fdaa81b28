//! What a scene says about the groups in motion.

use std::f64::consts::TAU;

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::quantities;
use crate::kernel::keys::keys;
use crate::kernel::number::short;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::parts::hydraulics::cylinder::Cylinder;
use crate::parts::hydraulics::valve::supersonic;
use crate::steering::cylinder::Mounting;
use crate::steering::flow::Piston;
use crate::steering::moving::symbols as s;
use crate::steering::refusal::Refusal;

/// How deep the steering is modelled.
pub const FIDELITIES: &[&str] = &["kinematic", "hydraulic", "auto"];

/// The tables of the groups in motion, each with what it says.
pub const TABLES: [(&str, &[Key], &str); 3] = [
    ("dynamics", KEYS, "What moves, with fidelity \"hydraulic\"."),
    (
        "oil",
        OIL_KEYS,
        "Oil and valve of each cylinder, with fidelity \"hydraulic\".",
    ),
    ("plc", PLC_KEYS, "Control loop of the PLC, with fidelity \"hydraulic\"."),
];

/// Keys of `[steering.dynamics]`.
const KEYS: &[Key] = keys! { s: J > 0, STEP > 0 [optional] };

/// Keys of `[steering.oil]`.
const OIL_KEYS: &[Key] = keys! { s:
    V_0 > 0, V_1 > 0, Q_N > 0, DP_N > 0, X_0 >= 0 [optional], DP_L > 0, BETA_E > 0, P_R > 0, K_R >= 0, K_L >= 0,
    OMEGA_V > 0, ZETA_V >= 0, P_P >= 0, TOL [tolerance, optional]
};

/// Keys of `[steering.plc]`.
const PLC_KEYS: &[Key] = keys! { s: T_C > 0, K_P >= 0, K_I >= 0 [optional], U_V_MAX > 0 [optional] };

/// Most radians that a group may swing against its oil in a cycle of the PLC: machines have a few.
const MOST_SWINGS: f64 = 100.0;

quantities! {
    /// The groups in motion as the scene describes them: what moves, oil and valve of each cylinder, the control loop.
    MovingGroups {
        j: J, step: STEP, v_0: V_0, v_1: V_1, q_n: Q_N, dp_n: DP_N, x_0: X_0, dp_l: DP_L, beta_e: BETA_E, p_r: P_R,
        k_r: K_R, k_l: K_L, omega_v: OMEGA_V, zeta_v: ZETA_V, p_p: P_P, tol: TOL, t_c: T_C, k_p: K_P, k_i: K_I,
        u_max: U_V_MAX
    }
}

impl MovingGroups<f64> {
    /// Whether a group with this cylinder swings a reasonable number of times against its oil between two samples, and is
    /// moved by no more than sound.
    ///
    /// # Errors
    /// An inertia so small that every swing would have to be followed for nothing, a valve so large.
    pub fn reasonable(&self, mounting: &Mounting<f64>, piston: &Piston<f64>) -> Result<(), Refusal> {
        if let Some([what, help]) = supersonic(&s::Q_N, self.q_n, piston.d_g) {
            return Err(Refusal::new(s::Q_N.id, what, help));
        }
        let (j, t_c) = (self.j, self.t_c);
        let volume = |area: f64| area * mounting.l_x / 2.0 + self.v_0;
        let areas = Cylinder::areas(piston.d_g, piston.d);
        let stiffness: f64 = (areas.into_iter())
            .map(|area| self.beta_e * (area * mounting.r).powi(2) / volume(area))
            .sum();
        let least = stiffness * (t_c / MOST_SWINGS).powi(2);
        if j >= least {
            return Ok(());
        }
        let swings = (stiffness / j).sqrt() * t_c / TAU;
        Err(Refusal::new(
            s::J.id,
            format!(
                "with J = {} a group swings {} times against its oil in one cycle of the PLC",
                s::J.written(j),
                short(swings.round())
            ),
            format!(
                "give the inertia of the whole group about its axis, at least {}",
                s::J.written(least)
            ),
        ))
    }

    /// The checked table `[steering]`; `None` where groups turn as commanded, and where there are
    /// mistakes, which go to `found`.
    pub fn new(v: &Values, found: &mut Vec<Diagnostic>) -> Option<MovingGroups<f64>> {
        let names = TABLES.map(|(name, ..)| name);
        let fidelity = v.text("fidelity").unwrap_or(FIDELITIES[0]);
        if fidelity == "auto" && !names.iter().any(|name| v.has(name)) {
            return None;
        }
        if !matches!(fidelity, "hydraulic" | "auto") {
            // A fidelity that cannot be read is not one that is missing.
            let unused = names.into_iter().filter(|name| found.is_empty() && v.has(name));
            for name in unused.collect::<Vec<_>>() {
                found.push(v.refuse(
                    name,
                    format!("[steering.{name}] of groups that stand as commanded"),
                    "not used",
                    "set fidelity = \"hydraulic\" in [steering], or remove this table",
                ));
            }
            return None;
        }
        // The encoders are those of the angle errors.
        for name in names.into_iter().chain(["cylinder", "accuracy"]) {
            if !v.has(name) {
                found.push(v.refuse(
                    "fidelity",
                    format!("fidelity = \"{fidelity}\" without [steering.{name}]"),
                    format!("needs [steering.{name}]"),
                    format!("add [steering.{name}]; `lemnis schema` lists its keys"),
                ));
            }
        }
        let tables = names.map(|name| v.table(name));
        if tables.iter().any(Option::is_none) {
            return None;
        }
        let given = |symbol: &Symbol| {
            let default = match symbol {
                symbol if *symbol == s::STEP => Some(0.01),
                symbol if *symbol == s::TOL => Some(1e-5),
                symbol if *symbol == s::U_V_MAX => Some(1.0),
                symbol if *symbol == s::X_0 || *symbol == s::K_I => Some(0.0),
                _ => None,
            };
            let mut tables = tables.iter().flatten();
            tables.find_map(|table| table.number(symbol.id)).or(default)
        };
        MovingGroups::of(given)
    }
}
