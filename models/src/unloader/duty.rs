//! What a cycle as a whole asks of the motors, and how heavy it is.

use crate::component::stages::results;
use crate::kernel::calc::{Among, Calc, sum};
use crate::kernel::group::One;
use crate::kernel::variable::Fault;
use crate::unloader::cycle::{GrabPhase, LASTS, PhaseForces};
use crate::unloader::symbols as s;
use crate::unloader::trolley::GrabTrolley;

/// The cycle: time (s), rate (kg/s), greatest weight (N), load spectrum, root mean squares of the motors' powers (W), and the
/// part of the time for which they turn.
#[derive(Clone, Copy, Debug)]
pub struct GrabDuty<C> {
    time: C,
    rate: C,
    most: C,
    spectrum: C,
    powers: [C; 3],
    turning: [C; 3],
}
results! { GrabDuty as d => {
    T_CYC: d.time;
    Q_CYC: d.rate;
    W_MAX: d.most;
    K_P: d.spectrum;
    P_H_RMS: d.powers[0];
    P_C_RMS: d.powers[1];
    P_T_RMS: d.powers[2];
    ED_H: d.turning[0];
    ED_C: d.turning[1];
    ED_T: d.turning[2];
} }

impl<C: Calc> GrabDuty<C> {
    /// K_p = Σ (t/t_cyc)(W/W_max)³, P_rms = √(Σ P² t/t_cyc), ED = Σ t_turns/t_cyc. [Ports001, 5.9.1]
    ///
    /// # Errors
    /// A phase with a slack rope.
    pub fn new(
        unit: &GrabTrolley<C>,
        gravity: &One<C>,
        phases: &[GrabPhase<C>],
        found: &[PhaseForces<C>],
    ) -> Result<GrabDuty<C>, Fault> {
        if let Some(slack) = (1..).zip(found).find_map(|(number, phase)| phase.slack(number)) {
            return Err(Fault::outside(slack));
        }
        let time = sum(phases.iter().map(|phase| phase.t)).def(&s::T_CYC);
        let weights = found.iter().map(|phase| phase.weight);
        let most = weights.reduce(C::greater).unwrap_or(unit.g_g);
        let most = found
            .first()
            .map_or(most, |first| most.among(Among::Greatest, first.weight));
        let most = most.def(&s::W_MAX);
        let all = || phases.iter().zip(found);
        let spectrum = sum(all().map(|(phase, at)| phase.t / time * (at.weight / most).power([3, 1])));
        let names = [&s::P_H_RMS, &s::P_C_RMS, &s::P_T_RMS];
        let powers = std::array::from_fn(|i| {
            let square = sum(all().map(|(phase, at)| at.powers[i].square() * phase.t)) / time;
            let root = if square.value() > 0.0 {
                square.sqrt()
            } else {
                square.over(square)
            };
            root.def(names[i])
        });
        Ok(GrabDuty {
            time,
            rate: (unit.q_n / **gravity / time).def(&s::Q_CYC),
            most,
            spectrum: spectrum.def(&s::K_P),
            powers,
            turning: std::array::from_fn(|i| {
                let names = [&s::ED_H, &s::ED_C, &s::ED_T];
                (sum(found.iter().map(|phase| phase.lasts[i].tabled(LASTS[i]))) / time).def(names[i])
            }),
        })
    }
}
