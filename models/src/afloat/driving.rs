//! Luffing by command, and what slewing and luffing drives of a crane on a hull in motion must give. [virtual work]

use nalgebra::Vector3;

use crate::afloat::carrying::CraneAfloat;
use crate::afloat::crane::LuffingMotion;
use crate::afloat::swaying::Swaying;
use crate::afloat::symbols as s;
use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::parts::hanging::dot;

quantities! {
    /// How fast luffing follows its command.
    LuffingServo { t_1: T_1 }
}

quantities! {
    /// What luffing is commanded.
    LuffingCommand { omega_c1: OMEGA_C1 }
}

/// dω_1/dt = (ω_c1 − ω_1)/T_1, in rad/s².
pub fn luffing<C: Calc>(servo: &LuffingServo<C>, command: &LuffingCommand<C>, luffing: &LuffingMotion<C>) -> C {
    ((command.omega_c1 - luffing.omega_1) / servo.t_1).def(&s::D_OMEGA_1)
}

/// What slewing and luffing drives give.
struct Driving;

impl Finding<2> for Driving {
    type From<C: Calc> = (CraneAfloat<C>, [C; 5], [C; 3]);
    const NAMES: [&'static Symbol; 2] = *listed!(s: M_SL, M_1);

    fn map<C: Calc, D: Calc>((crane, rates, pull): &Self::From<C>, f: &mut dyn FnMut(C) -> D) -> Self::From<D> {
        (crane.map(f), rates.map(&mut *f), pull.map(&mut *f))
    }

    fn find<C: Calc>((crane, rates, [x, y, z]): &Self::From<C>) -> Result<[C; 2], Fault> {
        let head = crane.moved(&crane.head);
        let pull = Vector3::new(*x, *y, *z);
        let mut moments = [3, 4].map(|i: usize| -dot(head.travel[i], pull));
        for mass in &crane.masses {
            let moved = crane.moved(mass);
            let speeding = |sum: Vector3<C>, (travel, rate): (&Vector3<C>, &C)| sum + *travel * *rate;
            let mut own = moved.travel.iter().zip(rates).fold(moved.bend, speeding);
            own.z += crane.gravity;
            for (moment, travel) in moments.iter_mut().zip(&moved.travel[3..]) {
                *moment += mass.mass * dot(*travel, own);
            }
        }
        Ok(moments)
    }
}

/// Moments of the slewing and the luffing drive, in N·m.
#[derive(Clone, Copy, Debug)]
pub struct DriveMoments<C>([C; 2]);
results! { DriveMoments as d => { M_SL: d.0[0]; M_1: d.0[1]; } }

impl<C: Scalar> DriveMoments<C> {
    /// M_k = Σ m ∂r/∂q_k · (r̈ + g e_z) − S_R n · ∂s/∂q_k, with all accelerations as they are (m/s², rad/s²) and the rope's pull (N).
    ///
    /// # Errors
    /// As [`found`]; there is none.
    pub fn new(crane: &CraneAfloat<C>, swaying: &Swaying<C>, luffs: &C) -> Result<DriveMoments<C>, Fault> {
        let ([heaving, rolling, pitching], along) = (swaying.hull, swaying.along);
        let rates = [heaving, rolling, pitching, swaying.slewing, *luffs];
        let pull = [along.x, along.y, along.z].map(|part| part * swaying.rope);
        found::<Driving, C, 2>(&(crane.clone(), rates, pull)).map(DriveMoments)
    }
}
