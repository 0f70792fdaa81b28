//! Slewing in motion behind the couplings of the drive: what the support and its drive give to it.
//!
//! All motors with their brakes are one side of one coupling, at the slewing axis by the ratio alone: J_d has their energy,
//! M_lim ψ the work of all couplings. Dry friction of slewing is that of the support; what the gear loses is viscous friction, which the
//! scene gives; a wind of the scene's own blows on the areas of the support. [Ports001, 6.5.4]

use std::sync::Arc;

use crate::component::beside::MovedBeside;
use crate::component::description::{Described, Description};
use crate::component::outline::{Greatest, Most};
use crate::component::peaks::Peaks;
use crate::component::running::Running;
use crate::component::stages::{Found, absent};
use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::air::AIR_OR_WIND;
use crate::parts::turntable::{self as joint, Borne};
use crate::parts::{hanging, slip};
use crate::supports::drive::brake::Coupled;
use crate::supports::drive::gear::TurningDrive;
use crate::supports::drive::given::{Moves, TurningChoice};
use crate::supports::drive::symbols as s;
use crate::supports::upper::symbols as upper;

/// Beside the support: what neither that nor its drive gives.
pub const SLEWING: Key = Key::part("slewing", OWN, "Slewing in motion behind the couplings of the drive.");

/// How that is solved.
pub const DYNAMICS: &str = "dynamics";

const OWN: &[Key] = keys! { joint:
    C_SL >= 0 [optional], M_SL [over_time, optional], M_B_SL >= 0 [over_time, optional], PSI_SL [optional],
    OMEGA_SL [optional], PSI_MIN [optional], PSI_MAX [optional], CHI_R [optional];
    Key::choice(
        "fidelity",
        &["rigid", "swing"],
        "\"rigid\": slewing moves under the moments of its drive and brake; \"swing\": its load swings on a rope besides.",
    ),
    Key::quantity(&s::L_R, Sign::Positive).optional(),
    Key::quantity(&hanging::PHI_R, Sign::Any).optional(),
    AIR_OR_WIND
};

/// What is followed over a cycle of commands.
pub const FOLLOWED: &[&Symbol] = &[&joint::M_SL, &slip::OMEGA_D, &slip::M_CD, &slip::W_SLIP];

/// Two of these in one figure.
pub const TOGETHER: &[[&Symbol; 2]] = &[[&joint::OMEGA_SL, &slip::OMEGA_D]];

/// What is given for motion alone, and in no formula.
pub const USES: [(&str, &[&Symbol]); 3] = [
    ("stops", listed!(joint: PSI_MIN, PSI_MAX)),
    ("start", listed!(joint: PSI_SL, OMEGA_SL)),
    ("hook", &[&s::L_R, &hanging::PHI_R, &joint::CHI_R]),
];

/// J_d = z J_M i², in kg·m². [Ports001, 6.5.4]
pub fn side<C: Calc>(drive: &TurningDrive<C>, _: &Moves) -> C {
    (drive.z * drive.j * drive.i.square()).def(&s::J_D)
}

/// z i T_lim, in N·m. [Ports001, 6.5.4]
pub fn slips<C: Calc>(drive: &TurningDrive<C>, _: &Moves, coupled: &Coupled<C>) -> C {
    (drive.z * drive.i * coupled.slips).def(&s::M_LC)
}

/// M_f of the load case of heating, in N·m. [Ports001, 6.5.1]
///
/// # Errors
/// A case of heating that there is not.
pub fn dry<C: Calc>(choice: &TurningChoice, _: &Moves, rubbing: &[C]) -> Found<C> {
    let friction = rubbing.get(choice.heating).ok_or_else(absent)?;
    Ok(friction.tabled(&s::M_FS0).def(&s::M_FS0))
}

/// The coupling's limit in motion.
pub const SLIPS: Greatest = Greatest::new(&s::M_LIM, Most::Greatest, &s::M_LC);

/// Dry friction in motion.
pub const RUBS: Greatest = Greatest::new(&joint::M_F_SL, Most::Greatest, &s::M_FS0);

/// Whether a support's scene moves what slews; refuses another level, and a drive without a coupling.
pub fn moves(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Moves> {
    let Some(own) = v.table(SLEWING.name) else {
        if let Some(table) = v.table(DYNAMICS) {
            let what = "`dynamics` of what stands still";
            found.push(Diagnostic::new(table.span.clone(), what, "not used").help("add [slewing], or remove it"));
        }
        return None;
    };
    if own.text("fidelity").is_none() {
        let what = "[slewing] beside [supports] without fidelity = \"rigid\" or \"swing\"";
        let help = "set one of them, or remove [slewing]: [supports] alone stands still";
        found.push(own.refuse("fidelity", what, "not here", help));
    }
    if !v.table("slewing_drive").is_some_and(|drive| drive.has("coupling")) {
        let what = "[slewing] beside [supports] without [supports.slewing_drive.coupling]";
        let help = "add it, with drive and brake: J_d and M_lim of the motion follow from them; or give [slewing] a scene of its own";
        found.push(Diagnostic::new(own.span.clone(), what, "a coupling is needed").help(help));
    }
    if own.has(s::L_R.id) && v.table("slewing_drive").is_some_and(|drive| drive.has(s::L_R.id)) {
        let what = "`l_R` in [slewing] and in [supports.slewing_drive]";
        found.push(own.refuse(
            s::L_R.id,
            what,
            "given twice",
            "remove one of them: the load hangs on one rope",
        ));
    }
    Some(Moves)
}

/// Sum of the wind areas, and the distance of their centre from the slewing axis (m² and m), where there are any.
fn areas(of: &mut dyn FnMut(&'static Symbol) -> Option<f64>) -> Option<[f64; 2]> {
    let (sum, moment) = (of(&upper::A_SUM)?, of(&s::S_R)?);
    Some([sum, if sum > 0.0 { moment / sum } else { 0.0 }])
}

/// Reads slewing in motion: its table, others of the scene, what the support gives, gravity (m/s²).
pub type ReadBeside =
    fn(&Values, &[(&'static str, &Values)], &Borne, f64, &mut Vec<Diagnostic>) -> Option<Arc<dyn MovedBeside>>;

/// Slewing in motion, by what a support and its drive come to: inertia, reach and load at the start, slope, wind areas where there
/// is air, the greatest friction of the load case of heating over the whole range, and of the coupling the greatest moment of all
/// load cases. Mistakes go to `found`.
pub fn moved<T: Described>(
    this: &Description<T>,
    read: ReadBeside,
    v: &Values,
    found: &mut Vec<Diagnostic>,
    gravity: Option<One<f64>>,
) -> Option<Arc<dyn MovedBeside>> {
    let own = v.table(SLEWING.name).filter(|_| found.is_empty())?;
    let mut model = this.standing();
    let mut peaks = Peaks::over(&model, T::aside(this));
    peaks.look(&model, [SLIPS.of, RUBS.of].into_iter());
    let mut most = |of: &Greatest| {
        let peak = peaks.most(&model, of)?;
        Some(peaks.summary(&model, of.symbol, peak).value)
    };
    let (limit, friction) = (most(&SLIPS)?, most(&RUBS)?);
    if limit <= friction {
        let what = format!(
            "the coupling slips at M_lim = {}, and the support rubs with M_Fsl = {}",
            s::M_LIM.written(limit),
            joint::M_F_SL.written(friction)
        );
        let help = "give the brake in [supports.slewing_drive] more torque T_b, or its coupling a greater k_lim";
        found.push(Diagnostic::new(own.span.clone(), what, "nothing moves so").help(help));
        return None;
    }
    let mut of = |symbol: &'static Symbol| {
        let index = model
            .variables()
            .iter()
            .position(|variable| variable.symbol == symbol)?;
        model.get(index).ok()
    };
    let reach = of(&upper::R)?;
    if reach < 0.0 {
        let what = format!("{} = {} beside [slewing]", upper::R.id, upper::R.written(reach));
        let help = "give zero or more: a load behind the axis is one in front of it, with r_u and r_w turned round";
        found.push(v.refuse(upper::R.id, what, "behind the slewing axis", help));
        return None;
    }
    let (weight, ahead) = (of(&upper::G_0)?, of(&upper::M_U)?);
    let arm = if weight > 0.0 { ahead / weight } else { 0.0 };
    let borne = Borne {
        inertia: of(&s::J_0)?,
        friction,
        reach: (reach, v.is_input(upper::R.id)),
        load: (of(&upper::Q)?, v.is_input(upper::Q.id)),
        slope: v.of(&upper::GAMMA).map(|steep| [steep, weight, arm]),
        side: of(&s::J_D)?,
        limit,
        wind: own.has(AIR_OR_WIND.name).then(|| areas(&mut of)).flatten(),
        rope: (v.table("slewing_drive")).and_then(|drive| drive.of(&s::L_R)),
    };
    let tables = ["motion", DYNAMICS].map(|name| (name, v.table(name)));
    let tables = tables.into_iter().filter_map(|(name, table)| Some((name, table?)));
    read(own, &tables.collect::<Vec<_>>(), &borne, *gravity?, found)
}
