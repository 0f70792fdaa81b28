//! The joint by which a crane slews: what all that slews has of it, whatever else moves.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::quantities;
use crate::kernel::number::short;
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, symbols};
use crate::parts::motion::degrees;
use crate::parts::turntable as s;

symbols! {
    J_SL: "J_sl" "J_\"sl\"" KG_M2 / T_M2 [not_negative], "Inertia about the slewing axis of all that slews but the bodies of a luffing mechanism beside it and the load.", "input";
    C_SL: "c_sl" "c_\"sl\"" N_M_S / KN_M_S [not_negative], "Viscous friction of slewing: moment over angular velocity.", "input";
    M_F_SL: "M_Fsl" "M_\"F sl\"" N_M / KN_M [not_negative], "Dry friction of slewing: the moment that it holds, and that it sets against motion.", "input";
    PSI_MIN: "psi_min" "psi_\"min\"" RAD / DEG, "Slewing angle of the right end stop.", "input";
    PSI_MAX: "psi_max" "psi_\"max\"" RAD / DEG, "Slewing angle of the left end stop.", "input";
    M_SL: "M_sl" "M_\"sl\"" N_M / KN_M, "Moment of the slewing drive; positive turns the crane counter-clockwise, seen from above.", "input";
    M_B_SL: "M_Bsl" "M_\"B sl\"" N_M / KN_M [not_negative], "Moment of the slewing brake, added to its dry friction.", "input";
    PSI_SL: "psi_sl" "psi_\"sl\"" RAD / DEG, "Slewing angle; positive counter-clockwise, seen from above.", "equations of motion";
    OMEGA_SL: "omega_sl" "omega_\"sl\"" RAD_PER_S / DEG_PER_S, "Angular velocity of slewing.", "equations of motion";
    M_R_SL: "M_Rsl" "M_\"R sl\"" N_M / KN_M, "Moment of friction, brake and end stop on slewing; positive counter-clockwise, seen from above.", "equations of motion";
    CHI_R: "chi_R" "chi_R" RAD / DEG, "Angle of the rope from the mechanism's plane; positive swings the load to the left.", "equations of motion";
    D_PSI_SL: "der(psi_sl)" "dot(psi)_\"sl\"" RAD_PER_S / DEG_PER_S, "Rate of the slewing angle.", "state";
    D_OMEGA_SL: "der(omega_sl)" "dot(omega)_\"sl\"" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of slewing.", "equations of motion";
    Z_SL_REST: "z.sl_rest" "z_9" ONE / ONE, "Falls below zero where slewing comes to rest, or breaks loose to the right.", "event";
    Z_SL_LOOSE: "z.sl_loose" "z_10" ONE / ONE, "Falls below zero where slewing breaks loose to the left.", "event";
    Z_SL_LOW: "z.sl_low" "z_11" ONE / ONE, "Falls below zero where slewing meets its right end stop.", "event";
    Z_SL_HIGH: "z.sl_high" "z_12" ONE / ONE, "Falls below zero where slewing meets its left end stop.", "event";
}

quantities! {
    /// What slews besides other bodies, and its friction.
    Turning { j_sl: J_SL, c_sl: C_SL, m_f_sl: M_F_SL }
}

/// The joint as a scene describes it, at the start; SI.
#[derive(Clone, Copy, Debug)]
pub struct SlewingJoint {
    pub turning: Turning<f64>,
    /// Angle (rad) and angular velocity (rad/s).
    pub start: [f64; 2],
    /// End stops, in rad; infinite where there are none.
    pub stops: [f64; 2],
}

/// What carries all that slews gives to its motion: inertia (kg·m²) and dry friction (N·m); reach (m) and load (N), each with whether
/// it is an input; slope (rad) with the weight (N) of what slews and its lever (m); wind area (m²) with the distance of its centre (m), where wind blows; of the coupling inertia of the drive's side (kg·m²)
/// and limit (N·m); length of the rope (m), where the drive gives one.
#[derive(Clone, Copy, Debug)]
pub struct Borne {
    pub inertia: f64,
    pub friction: f64,
    pub reach: (f64, bool),
    pub load: (f64, bool),
    pub slope: Option<[f64; 3]>,
    pub wind: Option<[f64; 2]>,
    pub side: f64,
    pub limit: f64,
    pub rope: Option<f64>,
}

/// What is taken for granted where the wind blows on what slews.
pub const WIND_ON_SLEWED: &str = "slewing_wind";

/// Refuses a table that says nothing of the inertia of what slews.
#[must_use]
pub fn without_inertia(table: &Values) -> Option<Diagnostic> {
    let id = J_SL.id;
    (!table.stands(id)).then(|| {
        let help = format!("add {id} = \"9000000 kg.m2\", or what it is");
        table.refuse(id, format!("`{id}` is missing in [slewing]"), "needed here", help)
    })
}

/// Most centrifugal acceleration of the head that a speed may give or a slewing drive lead to, over that of gravity.
pub const MOST_SPIN: f64 = 10.0;

impl SlewingJoint {
    /// Reads a checked table `[slewing]`; mistakes go to the list.
    pub fn read(table: &Values, found: &mut Vec<Diagnostic>) -> Option<SlewingJoint> {
        let n = |symbol: &Symbol| table.number(symbol.id);
        let stops = [
            n(&PSI_MIN).unwrap_or(f64::NEG_INFINITY),
            n(&PSI_MAX).unwrap_or(f64::INFINITY),
        ];
        let start = n(&PSI_SL).unwrap_or(0.0);
        if stops[0] >= stops[1] {
            let [low, high] = stops.map(degrees);
            found.push(table.refuse(
                PSI_MAX.id,
                format!("the slewing stops are at {low} and {high}"),
                "not above psi_min",
                "psi_max must be greater than psi_min",
            ));
            return None;
        }
        let beyond = match start {
            _ if start < stops[0] => Some((&PSI_MIN, stops[0])),
            _ if start > stops[1] => Some((&PSI_MAX, stops[1])),
            _ => None,
        };
        if let Some((stop, at)) = beyond {
            let [start, at] = [start, at].map(degrees);
            found.push(table.refuse(
                stop.id,
                format!("slewing starts at {start}, beyond its stop {} = {at}", stop.id),
                "not between the stops",
                "let psi_sl, the angle at the start, lie between psi_min and psi_max",
            ));
            return None;
        }
        Some(SlewingJoint {
            turning: Turning {
                j_sl: n(&J_SL)?,
                c_sl: n(&C_SL).unwrap_or(0.0),
                m_f_sl: n(&M_F_SL).unwrap_or(0.0),
            },
            start: [start, n(&OMEGA_SL).unwrap_or(0.0)],
            stops,
        })
    }

    /// Refuses a moment (N·m) that no crane would outlast: the speed is that at which friction holds it, or to which it
    /// brings all that slews, with a mass (kg) at a reach (m), while it lasts (s), under gravity (m/s²).
    pub fn outlasts(
        &self,
        table: &Values,
        moment: f64,
        [reach, mass]: [f64; 2],
        lasts: f64,
        g: f64,
        found: &mut Vec<Diagnostic>,
    ) {
        let (turning, moment) = (self.turning, moment.abs());
        let held = moment / turning.c_sl;
        let omega = held.min(moment * lasts / (turning.j_sl + mass * reach * reach));
        let spin = omega * omega * reach / g;
        if spin > MOST_SPIN {
            let what = format!(
                "M_sl = {} brings the crane to {}, and its head to {} times the acceleration of gravity",
                M_SL.written(moment),
                OMEGA_SL.written(omega),
                short(spin)
            );
            let help = format!("give a smaller M_sl or more friction c_sl: at most {MOST_SPIN} times it is modelled");
            found.push(table.refuse(M_SL.id, what, "too much", help));
        }
    }
}

/// Refuses the first of some angular velocities (rad/s), each with its table and key, at which nothing would stay on its crane
/// at a distance from the axis (m, with its place in words) under gravity (m/s²).
#[must_use]
pub fn too_fast(speeds: &[(&Values, &str, f64)], (widest, place): (f64, &str), g: f64) -> Option<Diagnostic> {
    let most = (MOST_SPIN * g / widest).sqrt();
    let (table, key, speed) = speeds.iter().find(|(.., speed)| speed.abs() > most)?;
    let what = format!(
        "{key} = {} is {} times the acceleration of gravity {place}",
        OMEGA_SL.written(*speed),
        short(speed * speed * widest / g)
    );
    let help = format!(
        "at most {MOST_SPIN} times it is modelled: give up to {}",
        OMEGA_SL.written(most)
    );
    Some(table.refuse(key, what, "too fast", help))
}
