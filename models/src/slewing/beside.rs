//! Slewing of what a support carries, which gives what is not told of its motion.

use std::sync::Arc;

use crate::component::beside::MovedBeside;
use crate::component::description::Description;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::parts::turntable::{Borne, M_F_SL};
use crate::slewing::scene::{KEYS, SlewingScene};
use crate::slewing::symbols as s;

/// Of a checked table with other tables of the scene under the acceleration of gravity (m/s²); mistakes go to `found`.
pub fn beside(
    own: &Values,
    tables: &[(&'static str, &Values)],
    borne: &Borne,
    gravity: f64,
    found: &mut Vec<Diagnostic>,
) -> Option<Arc<dyn MovedBeside>> {
    let mut given = vec![
        (&s::J_SL, borne.inertia, false),
        (&M_F_SL, borne.friction, false),
        (&s::R, borne.reach.0, borne.reach.1),
        (&s::Q, borne.load.0, borne.load.1),
        (&s::J_D, borne.side, false),
        (&s::M_LIM, borne.limit, false),
    ];
    if let Some([steep, weight, arm]) = borne.slope {
        given.extend([
            (&s::GAMMA_S, steep, false),
            (&s::G_U, weight, false),
            (&s::R_U, arm, false),
        ]);
    }
    if let Some([area, arm]) = borne.wind {
        given.extend([(&s::A_WS, area, false), (&s::R_WS, arm, false)]);
    }
    let swings = matches!(own.text("fidelity"), Some("swing" | "auto"));
    given.extend(borne.rope.filter(|_| swings).map(|length| (&s::L_R, length, false)));
    let all = own.completed(KEYS, tables, &given);
    Some(Arc::new(Description::<SlewingScene>::read(&all, gravity, found)?))
}
