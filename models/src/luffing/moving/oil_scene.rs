//! The oil of a luffing cylinder as scenes describe it.

use crate::drive::symbols::D_C;
use crate::kernel::course::Between;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::given::CylinderOil;
use crate::luffing::moving::symbols as s;
use crate::parts::air::AIR;
use crate::parts::control::reading::TABLE;
use crate::parts::hydraulics::valve::supersonic;

/// Where scenes give the oil of a luffing cylinder.
pub const HYDRAULICS: Key = Key::part(
    "hydraulics",
    OIL_KEYS,
    "Oil, valve and lines of the luffing cylinder in motion.",
);

/// Keys of `[luffing.hydraulics]`.
const OIL_KEYS: &[Key] = keys! { s:
    L_MIN > 0, L_MAX > 0, V_0 > 0, V_1 > 0, Q_N > 0, DP_N > 0, DP_L > 0, BETA_E > 0, P_R > 0, K_R >= 0, K_L >= 0,
    OMEGA_V > 0, ZETA_V >= 0, TOL [tolerance, optional], P_P >= 0 [in_steps], U_V [in_steps, optional],
    P_AC >= 0 [optional], K_AC > 0 [optional], P_LH > 0 [optional], I_LH >= 0 [optional], DP_LH > 0 [optional], X_T >= 0 [optional],
    Y_B1 >= 0 [in_steps, optional], Y_B2 >= 0 [in_steps, optional], Q_PMAX > 0 [optional], P_PMAX > 0 [optional],
    P_TANK >= 0 [optional]
};

/// The oil where the level has one.
pub(super) fn oil_drive(v: &Values, fidelity: &str, found: &mut Vec<Diagnostic>) -> Option<Option<CylinderOil<f64>>> {
    if fidelity == "hydraulic" {
        found.extend(motor_beside(v));
    }
    match (fidelity, v.table("hydraulics")) {
        ("hydraulic" | "auto", Some(table)) => Some(Some(oil(v, table, found)?)),
        ("hydraulic", None) => {
            found.push(v.refuse(
                "fidelity",
                "fidelity = \"hydraulic\" without oil",
                "needs [luffing.hydraulics]",
                "add [luffing.hydraulics]; `lemnis schema` lists its keys",
            ));
            None
        }
        (_, Some(_)) => {
            found.push(v.refuse(
                "hydraulics",
                "oil of a mechanism without a hydraulic level",
                "not used",
                "set fidelity = \"hydraulic\", or remove this table",
            ));
            None
        }
        _ => Some(None),
    }
}

/// A motor or a brake beside the cylinder that moves the driven bar, or its controller.
fn motor_beside(v: &Values) -> Option<Diagnostic> {
    if v.has(TABLE) {
        let what = "a controller of luffing beside a cylinder";
        return Some(v.refuse(
            TABLE,
            what,
            "not used",
            "remove it; at this level u_v and p_P command the cylinder",
        ));
    }
    let dynamics = v.table("dynamics")?;
    let motor = [&s::M_A, &s::M_S].into_iter().find(|symbol| dynamics.has(symbol.id))?;
    let what = format!("{} beside a cylinder: two drives on one bar", motor.id);
    let help = "remove it; at this level u_v and p_P command the cylinder";
    Some(dynamics.refuse(motor.id, what, "not used", help))
}

/// The cylinder's oil; its bore and rod are those of the drive.
fn oil(v: &Values, table: &Values, found: &mut Vec<Diagnostic>) -> Option<CylinderOil<f64>> {
    let n = |symbol: &Symbol| table.number(symbol.id);
    let cylinder = v.table("drive").filter(|drive| drive.text("kind") == Some("cylinder"));
    if cylinder.is_none() {
        found.push(
            Diagnostic::new(table.span.clone(), "oil without a cylinder", "needs [luffing.drive]")
                .help("add [luffing.drive] with kind = \"cylinder\", D_c and d_r"),
        );
        return None;
    }
    let (l_min, l_max) = (n(&s::L_MIN)?, n(&s::L_MAX)?);
    if l_min >= l_max {
        found.push(table.refuse(
            s::L_MAX.id,
            format!(
                "the cylinder is {} extended and {} retracted",
                s::L_MAX.written(l_max),
                s::L_MIN.written(l_min)
            ),
            "not above l_min",
            "l_max must be greater than l_min",
        ));
        return None;
    }
    let bore = cylinder.and_then(|drive| drive.of(&D_C));
    if let Some([what, help]) = bore.and_then(|bore| supersonic(&s::Q_N, n(&s::Q_N)?, bore)) {
        found.push(table.refuse(s::Q_N.id, what, "too much for it", help));
        return None;
    }
    Some(CylinderOil {
        l_min,
        l_max,
        v_0: n(&s::V_0)?,
        v_1: n(&s::V_1)?,
        q_n: n(&s::Q_N)?,
        dp_n: n(&s::DP_N)?,
        dp_l: n(&s::DP_L)?,
        beta_e: n(&s::BETA_E)?,
        p_r: n(&s::P_R)?,
        k_r: n(&s::K_R)?,
        k_l: n(&s::K_L)?,
        omega_v: n(&s::OMEGA_V)?,
        zeta_v: n(&s::ZETA_V)?,
        tol: n(&s::TOL).unwrap_or(1e-5),
    })
}

/// A command, or a wind, that goes straight from one value to the next beside oil, whose solver runs ahead of the time.
pub(super) fn straight_beside_oil(v: &Values) -> Option<Diagnostic> {
    let tables = ["slewing", "hoisting", AIR.name]
        .into_iter()
        .filter_map(|name| v.table(name));
    let straight = |table: &Values| {
        let mut told = table.courses().into_iter();
        let (symbol, _) = told.find(|(_, course)| course.between == Between::Linear)?;
        let what = format!("{} goes straight from one time to the next beside oil", symbol.id);
        let help = "set between = \"steps\": beside oil commands and wind hold between two times";
        Some(table.refuse(symbol.id, what, "not with oil", help))
    };
    tables.into_iter().find_map(straight)
}
