//! The time of a cycle, and what starts of the trolley leave of the load's sway on its four ropes.

use crate::bridge::suspension::Suspended;
use crate::bridge::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::sway::starts::Start;

quantities! {
    /// A start and the way: speed (m/s), acceleration (m/s²), way (m), time of a cycle besides it (s).
    TravelProfile { v_c: V_C, a_c: A_C, s_c: S_C, t_e: T_E }
}

/// Times of the way and of a cycle, in s.
#[derive(Clone, Copy, Debug)]
pub struct CycleTime<C>([C; 2]);
results! { CycleTime as c => { T_TR: c.0[0]; T_CYC: c.0[1]; } }

impl<C: Calc> CycleTime<C> {
    /// t_tr = s/v + v/a; 2 √(s/a) of a way too short for the speed; t_cyc = 2 t_tr + t_e.
    pub fn new(profile: &TravelProfile<C>) -> CycleTime<C> {
        let TravelProfile { v_c, a_c, s_c, t_e } = *profile;
        let long = s_c.value() * a_c.value() >= v_c.value() * v_c.value();
        let way = match long {
            true => s_c / v_c + v_c / a_c,
            false => (s_c / a_c).sqrt().scaled(2.0).over(v_c),
        };
        let way = way.def(&s::T_TR);
        CycleTime([way, (way.scaled(2.0) + t_e).def(&s::T_CYC)])
    }
}

/// The starts: acceleration (m/s²), duration (s), greatest sway and what is left of it for the simple pendulum's period
/// (rad).
#[derive(Clone, Copy, Debug)]
pub struct Profiles<C>([[C; 4]; 4]);
results! { Profiles as p => {
    A_P1: p.0[0][0];
    T_P1: p.0[0][1];
    PHI_P1: p.0[0][2];
    RHO_P1: p.0[0][3];
    A_P2: p.0[1][0];
    T_P2: p.0[1][1];
    PHI_P2: p.0[1][2];
    RHO_P2: p.0[1][3];
    A_P3: p.0[2][0];
    T_P3: p.0[2][1];
    PHI_P3: p.0[2][2];
    RHO_P3: p.0[2][3];
    A_P4: p.0[3][0];
    T_P4: p.0[3][1];
    PHI_P4: p.0[3][2];
    RHO_P4: p.0[3][3];
} }

impl<C: Calc> Profiles<C> {
    /// Greatest and left sway, each times what hangs back steadily: ν_x a/g. [linear oscillator]
    pub fn new(profile: &TravelProfile<C>, gravity: &One<C>, hanging: &Suspended<C>) -> Profiles<C> {
        let names = [
            [&s::A_P1, &s::T_P1, &s::PHI_P1, &s::RHO_P1],
            [&s::A_P2, &s::T_P2, &s::PHI_P2, &s::RHO_P2],
            [&s::A_P3, &s::T_P3, &s::PHI_P3, &s::RHO_P3],
            [&s::A_P4, &s::T_P4, &s::PHI_P4, &s::RHO_P4],
        ];
        let told = [profile.v_c, profile.a_c];
        Profiles(std::array::from_fn(|i| {
            let (start, [a, t, phi, rho]) = (Start::ALL[i], names[i]);
            let [rate, lasts] = start.timed(told, hanging.period);
            let [rate, lasts] = [rate.def(a), lasts.def(t)];
            let steady = |rate: C| hanging.felt * rate / **gravity;
            let [slow, _] = start.timed(told, hanging.simple_period);
            let left = start.left(told, hanging.frequency, hanging.simple_period);
            [
                rate,
                lasts,
                (steady(rate) * start.greatest(told, hanging.frequency, hanging.period)).def(phi),
                (steady(slow) * left).def(rho),
            ]
        }))
    }
}
