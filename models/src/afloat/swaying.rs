//! The load on its rope under the head of a crane that slews on a hull in motion: the rope's length is a constraint, its force
//! the multiplier that keeps it. [Lagrange, first kind]
//!
//! Places and speeds of the load are seen from the head, in directions that do not turn: along the hull's heading, to the left,
//! up.

use nalgebra::Vector3;

use crate::afloat::carrying::CraneAfloat;
use crate::afloat::crane::LuffingMotion;
use crate::afloat::head::HeadPlace;
use crate::afloat::riding::{BuoyedMass, HullMotion, RidingHull, WaterForces};
use crate::afloat::symbols as s;
use crate::afloat::weights::DeadLoad;
use crate::afloat::yielding::{DrivenHull, yielding};
use crate::component::scalar::Scalar;
use crate::component::stages::{absent, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::parts::hanging::{dot, squared};

quantities! {
    /// The load from the head, and its speed from there.
    RopedLoad { r_x: R_X, r_y: R_Y, r_z: R_Z, w_x: W_X, w_y: W_Y, w_z: W_Z }
}

quantities! {
    /// How fast slewing follows its command.
    SlewingServo { t_sl: T_SL }
}

quantities! {
    /// What slewing is commanded.
    SlewingCommand { omega_c: OMEGA_CSL }
}

/// How hull and load accelerate (m/s², rad/s²), the rope's force (N), and where the load is from the head.
#[derive(Clone, Copy, Debug)]
pub struct Swaying<C> {
    pub slewing: C,
    pub hull: [C; 3],
    speed: Vector3<C>,
    load: Vector3<C>,
    pub rope: C,
    pub along: Vector3<C>,
    place: Vector3<C>,
}
results! { Swaying as w => {
    S_R: w.rope;
    CHI_X: C::direction(-w.place.x, -w.place.z) - C::constant(std::f64::consts::FRAC_PI_2);
    CHI_Y: C::direction((w.place.x.square() + w.place.z.square()).sqrt(), w.place.y);
} }

/// Where the rope points, how long it is (m), and how fast the load goes across it (m/s).
fn rope<C: Calc>(load: &RopedLoad<C>) -> (Vector3<C>, C, Vector3<C>) {
    let place = Vector3::new(load.r_x, load.r_y, load.r_z);
    let length = squared(place).sqrt().def(&s::S_Q);
    let along = Vector3::new(
        (place.x / length).def(&s::N_X),
        (place.y / length).def(&s::N_Y),
        (place.z / length).def(&s::N_Z),
    );
    let speed = Vector3::new(load.w_x, load.w_y, load.w_z);
    let excess = dot(along, speed).def(&s::W_E);
    (along, length, speed - along * excess)
}

impl<C: Scalar> Swaying<C> {
    /// With arms a_i = n · ∂s/∂q_i and S_R = m_Q a_R: a_R (1 + Σ a_i κ_i) = w²/s_Q − g n_z − n · c − Σ a_i b_i, and each
    /// coordinate accelerates with b_i + κ_i a_R, the load from the head with −g e_z − a_R n − c − Σ ∂s/∂q_i q̈_i; without a crane
    /// that weighs b_i = F_i/m_i and κ_i = m_Q a_i/m_i.
    ///
    /// # Errors
    /// A rope that would push.
    #[expect(clippy::too_many_arguments, reason = "all that moves it")]
    pub fn new(
        motion: &HullMotion<C>,
        buoyed: &BuoyedMass<C>,
        roped: &RopedLoad<C>,
        servo: &SlewingServo<C>,
        command: &SlewingCommand<C>,
        riding: &RidingHull<C>,
        head: &HeadPlace<C>,
        forces: &WaterForces<C>,
        dead: &DeadLoad<C>,
        load: &One<C>,
        gravity: &One<C>,
        omega: &One<C>,
        luffing: Option<&C>,
        crane: Option<&CraneAfloat<C>>,
    ) -> Result<Swaying<C>, Fault> {
        let (along, length, speed) = rope(roped);
        let slewing = ((command.omega_c - **omega) / servo.t_sl).def(&s::D_OMEGA_SL);
        let [rolled, pitched, _] = head.turned(riding);
        let arms = [
            along.z,
            dot(along, rolled).def(&s::A_PHI),
            dot(along, pitched).def(&s::A_THETA),
        ];
        let heaving = (dead.all.weight / **gravity + buoyed.m_a).def(&s::M_0);
        let mass = (**load / **gravity).def(&s::M_Q);
        let on = DrivenHull {
            forces: forces.all,
            masses: [heaving, buoyed.j_x, buoyed.j_y],
            drives: [slewing, luffing.copied().unwrap_or(C::constant(0.0))],
            arms,
            load: mass,
        };
        let (carried, free, pulled) = match crane {
            Some(crane) => yielding(crane, on)?,
            None => {
                let rates = [motion.omega_x, motion.omega_y, **omega];
                (head.carried(riding, rates, slewing), on.alone(), on.pulled())
            }
        };
        let mut need = squared(speed) / length - **gravity * along.z - dot(along, carried);
        let mut give = C::constant(1.0);
        for i in 0..3 {
            need -= arms[i] * free[i];
            give += arms[i] * pulled[i];
        }
        let pull = (need.def(&s::A_N) / give.def(&s::KAPPA_R)).def(&s::A_R);
        // What is left of a lost load pushes nothing.
        if pull.value() < 0.0 && mass.value() > 0.0 {
            return Err(Fault::outside(format!(
                "S_R = {}: the rope would push the load, it goes slack, which this level has not; slew less hard, or give a longer \
                 rope",
                s::S_R.written((mass * pull).value())
            )));
        }
        let force = (mass * pull).def(&s::S_R);
        let names: &[&'static Symbol; 3] = listed!(s: D_V_G, D_OMEGA_X, D_OMEGA_Y);
        let hull = [0, 1, 2].map(|i| (free[i] + pulled[i] * pull).def(names[i]));
        let own = -(along * pull) - carried - rolled * hull[1] - pitched * hull[2];
        let fall = Vector3::new(
            own.x.def(&s::D_W_X),
            own.y.def(&s::D_W_Y),
            (own.z - **gravity - hull[0]).def(&s::D_W_Z),
        );
        Ok(Swaying {
            slewing,
            hull,
            speed,
            load: fall,
            rope: force,
            along,
            place: Vector3::new(roped.r_x, roped.r_y, roped.r_z),
        })
    }
}

/// Rates of the states.
#[derive(Clone, Copy, Debug)]
pub struct SwayingRates<C> {
    slewing: [C; 2],
    hull: [C; 6],
    load: [Vector3<C>; 2],
    luffing: Option<[C; 2]>,
}
results! { SwayingRates as r => {
    D_PSI_SL: r.slewing[0];
    D_OMEGA_SL: r.slewing[1];
    D_H_G: r.hull[0];
    D_PHI_X: r.hull[1];
    D_THETA_Y: r.hull[2];
    D_V_G: r.hull[3];
    D_OMEGA_X: r.hull[4];
    D_OMEGA_Y: r.hull[5];
    D_R_X: r.load[0].x;
    D_R_Y: r.load[0].y;
    D_R_Z: r.load[0].z;
    D_W_X: r.load[1].x;
    D_W_Y: r.load[1].y;
    D_W_Z: r.load[1].z;
    D_THETA_1: r.luffing.ok_or_else(absent)?[0];
    D_OMEGA_1: r.luffing.ok_or_else(absent)?[1];
} }

impl<C: Calc> SwayingRates<C> {
    pub fn new(
        omega: &One<C>,
        motion: &HullMotion<C>,
        swaying: &Swaying<C>,
        luffing: &Option<LuffingMotion<C>>,
        luffs: Option<&C>,
    ) -> SwayingRates<C> {
        let [heaving, rolling, pitching] = swaying.hull;
        SwayingRates {
            slewing: [**omega, swaying.slewing],
            hull: [motion.v_g, motion.omega_x, motion.omega_y, heaving, rolling, pitching],
            load: [swaying.speed, swaying.load],
            luffing: luffing.zip(luffs).map(|(luffing, luffs)| [luffing.omega_1, *luffs]),
        }
    }
}
