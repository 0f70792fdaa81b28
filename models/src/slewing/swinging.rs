//! The load of a crane that slews by itself, where it swings on its rope: [`crate::parts::hanging`] from a head at a reach.

use nalgebra::Vector3;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::parts::air::Stream;
use crate::parts::ground::Surroundings;
use crate::parts::hanging::{Accelerations, HangingLoad, HeadJoints, cancelling, dot};
use crate::parts::hoist::RopeAction;
use crate::parts::joint::{Bar, LOOSE, above_zero};
use crate::parts::slope::{SlopingGround, gravity};
use crate::parts::turntable::Turning;
use crate::slewing::motion::{Led, Past, SlewingDrive, Stops, drive, driving, joint};
use crate::slewing::symbols as s;
use crate::slewing::turning::{Hung, SlewedLoad};

quantities! {
    /// The load, from the head in the frame that slews.
    SwingingLoad { x_q: X_Q, y_q: Y_Q, z_q: Z_Q, v_qx: V_QX, v_qy: V_QY, v_qz: V_QZ }
}

quantities! {
    /// The rope from head to load.
    RopeLength { l_r: L_R }
}

quantities! {
    /// Whether the rope hangs slack (1) or is taut (0).
    Slackness { slack: SLACK }
}

impl<C: Calc> SwingingLoad<C> {
    pub(super) fn load(&self) -> HangingLoad<C> {
        HangingLoad::of(&[self.x_q, self.y_q, self.z_q, self.v_qx, self.v_qy, self.v_qz])
    }
}

impl From<HangingLoad<f64>> for SwingingLoad<f64> {
    fn from(HangingLoad { place, rate }: HangingLoad<f64>) -> SwingingLoad<f64> {
        let [x_q, y_q, z_q] = place.into();
        let [v_qx, v_qy, v_qz] = rate.into();
        SwingingLoad {
            x_q,
            y_q,
            z_q,
            v_qx,
            v_qy,
            v_qz,
        }
    }
}

/// How the head moves when the crane slews: to the left by its reach for one radian, in m.
pub(super) fn head<C: Calc>(reach: C) -> [Vector3<C>; 1] {
    [Vector3::new(C::constant(0.0), C::constant(0.0), reach)]
}

/// M_γu = −G_u r_u sin γ sin ψ, in N·m: the load's part comes to the head through its rope. [Ports001, 6.4]
pub fn leaning<C: Calc>(slope: &SlopingGround<C>, _: &SwingingLoad<C>, psi: &C) -> C {
    (slope.across(slope.g_u * slope.r_u, *psi)).def(&s::M_GAMMA_U)
}

/// How slewing and its load accelerate, and what the rope does meanwhile.
#[derive(Clone, Copy, Debug)]
pub struct Swinging<C> {
    pub load: HangingLoad<C>,
    pub found: Accelerations<C, 1>,
    needs: C,
    rubbing: C,
}
results! { Swinging as w => {
    S_R: w.found.rope;
    PHI_R: w.load.angles()[0];
    CHI_R: w.load.angles()[1];
} }

impl<C: Calc> Swinging<C> {
    /// By the multiplier of the rope. [Lagrange, first kind]
    #[expect(clippy::too_many_arguments, reason = "all that moves it")]
    pub fn new(
        turning: &Turning<C>,
        driven: &SlewingDrive<C>,
        past: &Past<C>,
        slackness: &Slackness<C>,
        stops: &Stops,
        slope: &Option<SlopingGround<C>>,
        outer: &Option<C>,
        stream: Option<&Stream<C>>,
        swung: &SwingingLoad<C>,
        hung: &Hung<C>,
        carried: &SlewedLoad<C>,
        psi: &C,
        omega: &C,
    ) -> Swinging<C> {
        let (zero, bar, load, head) = (C::constant(0.0), past.bar(), swung.load(), head(hung.r));
        let rubbing = joint(turning, stops)
            .resistance(bar, *omega, &drive(driven))
            .def(&s::M_R_SL);
        let free = bar != Bar::Held;
        let alone = if free {
            ((driving(driven, outer) + rubbing) / turning.j_sl).def(&s::ALPHA_0SL)
        } else {
            zero
        };
        let joints = HeadJoints {
            rates: [*omega],
            alone: [alone],
            ease: [if free { C::constant(1.0) / turning.j_sl } else { zero }],
            head,
            bend: None,
            lead: None,
            names: [&s::D_OMEGA_SL],
        };
        let taut = slackness.slack.value() == 0.0;
        let line = if taut {
            RopeAction::Taut {
                rate: zero,
                gain: None,
                drum: None,
            }
        } else {
            RopeAction::Slack
        };
        let masses = [carried.mass, cancelling(carried.mass)];
        let around = Surroundings::Free {
            gravity: gravity(slope.as_ref(), hung.g, *psi),
            air: stream,
        };
        let found = joints.hung(load, masses, line, around);
        Swinging {
            load,
            needs: -driving(driven, outer) - found.rope * found.arms[0],
            rubbing,
            found,
        }
    }
}

/// What it makes of slewing.
pub fn led<C: Calc>(swinging: &Swinging<C>) -> Led<C> {
    Led {
        needs: swinging.needs,
        rubbing: swinging.rubbing,
        acceleration: swinging.found.joints[0],
    }
}

/// Rates of the load's states.
#[derive(Clone, Copy, Debug)]
pub struct SwingingRates<C>([Vector3<C>; 2]);
results! { SwingingRates as r => {
    D_X_Q: r.0[0].x;
    D_Y_Q: r.0[0].y;
    D_Z_Q: r.0[0].z;
    D_V_QX: r.0[1].x;
    D_V_QY: r.0[1].y;
    D_V_QZ: r.0[1].z;
} }

impl<C: Calc> SwingingRates<C> {
    pub fn new(swinging: &Swinging<C>) -> SwingingRates<C> {
        SwingingRates([swinging.found.rate, swinging.found.load])
    }
}

/// Falls below zero where the rope becomes slack or taut.
pub fn slackening<C: Calc>(swinging: &Swinging<C>, rope: &RopeLength<C>, slackness: &Slackness<C>) -> C {
    let place = swinging.load.place;
    above_zero(match slackness.slack.value() {
        0.0 => swinging.found.slackening,
        _ => rope.l_r * C::constant(LOOSE) - dot(place, place).sqrt(),
    })
}
