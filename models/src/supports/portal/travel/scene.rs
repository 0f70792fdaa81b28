//! What a scene says of the travel of a portal.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::supports::plan::each;
use crate::supports::portal::symbols as s;
use crate::supports::portal::travel::given::{CornerDrive, PortalMotors, PortalStorm, PortalTravel, PortalWheels};

/// Beside corners and bodies.
pub const TRAVEL: Key = Key::part("travel", KEYS, "Travel on the rails: wheels, motors, brakes.");

const KEYS: &[Key] = keys! { s:
    V_T > 0, A_T > 0, GAMMA_T >= 0 [usually(0.0)], D_T > 0, D_J >= 0, F_R >= 0 [usually(0.0006)], MU_J >= 0 [usually(0.015)],
    BETA_T > 0 [usually(1.5)], MU_A > 0 [usually(0.14)], F_BR > 0, K_W > 0 [usually(1.1)], Z_M > 0, I_T > 0, ETA_T > 0, P_N > 0,
    LAMBDA_M > 0, J_M > 0;
    Key::part("storm", STORM, "What holds the crane against the wind out of service.")
};
const STORM: &[Key] = keys! { s: P_S > 0, Z_C > 0, F_C > 0 };

/// The travel of a portal as the scene describes it; nothing where it has none.
#[derive(Clone, Debug, Default)]
pub struct TravelScene {
    pub gravity: Option<One<f64>>,
    pub wheels: Option<PortalWheels<f64>>,
    pub travel: Option<PortalTravel<f64>>,
    pub motors: Option<PortalMotors<f64>>,
    /// Of each corner.
    pub driven: Vec<CornerDrive<f64>>,
    pub storm: Option<PortalStorm<f64>>,
}

impl TravelScene {
    /// Of a portal under gravity (m/s²); mistakes go to `found`.
    pub fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<TravelScene> {
        let Some(table) = v.table("travel") else {
            for corner in v.tables("corners").iter().filter(|corner| corner.has(s::N_DR.id)) {
                let help = "add [supports.travel], or remove it";
                found.push(corner.refuse(s::N_DR.id, "driven wheels of a crane without travel", "not used", help));
            }
            return Some(TravelScene::default());
        };
        let storm = table.table("storm");
        if let Some(storm) = storm.filter(|_| !v.has("wind")) {
            let help = "add [supports.wind] with the areas on which the wind acts";
            found.push(storm.refuse(
                s::P_S.id,
                "wind out of service on no wind areas",
                "areas are needed",
                help,
            ));
        }
        found.extend(table.broken(&s::Z_M));
        found.extend(storm.and_then(|storm| storm.broken(&s::Z_C)));
        for corner in v.tables("corners").iter().filter(|corner| !corner.has(s::N_DR.id)) {
            let (label, help) = (
                "[supports.travel] needs n_dr",
                "add n_dr = \"0\", or how many there are",
            );
            found.push(corner.refuse(s::N_DR.id, "`n_dr` is missing here", label, help));
        }
        let driven = each(v, "corners", CornerDrive::read)?;
        suits(v, &driven, found);
        Some(TravelScene {
            gravity: Some(One(&s::G, gravity)),
            wheels: Some(PortalWheels::read(table)?),
            travel: Some(PortalTravel::read(table)?),
            motors: Some(PortalMotors::read(table)?),
            driven,
            storm: storm.and_then(PortalStorm::read),
        })
    }
}

/// Refuses parts of driven wheels, more of them than wheels, and a drive that drives none.
fn suits(v: &Values, driven: &[CornerDrive<f64>], found: &mut Vec<Diagnostic>) {
    for (corner, drive) in v.tables("corners").iter().zip(driven) {
        found.extend(corner.broken(&s::N_DR));
        if let Some(wheels) = corner.of(&s::N_W).filter(|wheels| drive.n_dr > *wheels) {
            let what = format!("{} driven wheels of {wheels}", drive.n_dr);
            let help = "drive at most as many as n_w, or give more wheels";
            found.push(corner.refuse(s::N_DR.id, what, "more than there are", help));
        }
    }
    if driven.iter().all(|corner| corner.n_dr == 0.0) {
        let help = "give those [[supports.corners]] an n_dr above 0 that have driven wheels";
        found.push(v.refuse(
            "travel",
            "travel without a driven wheel",
            "nothing drives the crane",
            help,
        ));
    }
}
