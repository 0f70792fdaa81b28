//! The gear between a motor and the slewing axis: stages, then pinion and toothed ring.

use crate::component::stages::{Found, absent, results};
use crate::kernel::calc::{Among, Calc};
use crate::kernel::group::One;
use crate::supports::drive::given::{GearStage, GivenDrive, RingPinion};
use crate::supports::drive::symbols as s;

/// Own inertias of what is turned (kg·m²); drives with their motors: number, ratio and efficiency to the slewing axis; rated
/// power (W) and speed (1/s), greatest power and mean starting torque over the rated ones, inertia of the shaft (kg·m²).
#[derive(Clone, Copy, Debug)]
pub struct TurningDrive<C> {
    pub j_e: C,
    pub z: C,
    pub i: C,
    pub eta: C,
    pub p_n: C,
    pub n_n: C,
    pub lambda: C,
    pub k_a: C,
    pub j: C,
}
results! { TurningDrive as d => { I_SL: d.i; ETA_SL: d.eta; } }

impl<C: Calc> TurningDrive<C> {
    /// i_sl = i_1 i_2 ⋯ r_g/r_z and η_sl = η_1 η_2 ⋯ η_r, or as they are given. [Ports001, 6.5.4]
    ///
    /// # Errors
    /// Stages without pinion and ring.
    pub fn new(
        given: &GivenDrive<C>,
        stages: &[GearStage<C>],
        pinion: &Option<RingPinion<C>>,
        mesh: &Option<One<C>>,
    ) -> Found<TurningDrive<C>> {
        let [i, eta] = match (given.whole, pinion.zip(*mesh)) {
            (Some(whole), _) => [whole.i, whole.eta],
            (None, None) => return Err(absent()),
            (None, Some((pinion, mesh))) => {
                let [i, eta] = through(stages);
                [
                    (i * pinion.r_g / pinion.r_z).def(&s::I_SL),
                    (eta * *mesh).def(&s::ETA_SL),
                ]
            }
        };
        let (turned, motor) = (given.turned, given.motor);
        Ok(TurningDrive {
            j_e: turned.j_e,
            z: turned.z,
            i,
            eta,
            p_n: motor.p_n,
            n_n: motor.n_n,
            lambda: motor.lambda,
            k_a: motor.k_a,
            j: motor.j,
        })
    }
}

/// Products of the ratios and of the efficiencies of the first stages.
pub fn through<C: Calc>(stages: &[GearStage<C>]) -> [C; 2] {
    let mut all = [C::constant(1.0); 2];
    for (number, stage) in (1..).zip(stages) {
        for (all, own) in all.iter_mut().zip([stage.i, stage.eta]) {
            *all *= own.among(Among::Of(number), own);
        }
    }
    all
}
