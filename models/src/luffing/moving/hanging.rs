//! Equations of motion of a crane that luffs and slews, with its load on a rope that swings in all directions: what
//! [`HeadJoints`] needs of the mechanism.
//!
//! The mechanism enters by what [`Reduced`] holds, all of it by differentiation:
//! T = ½ I(theta) omega² + ½ J(theta) omega_psi², with their slopes, height and
//! place of the head. A thin mechanism that slews moves across its own plane, so
//! that both angular velocities do not couple but through the slopes.

use nalgebra::Vector3;

use crate::kernel::calc::Calc;
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::reduced::Reduced;
use crate::luffing::moving::symbols as s;
use crate::parts::air::Stream;
use crate::parts::ground::Surroundings;
use crate::parts::hanging::{Accelerations, HangingLoad, HeadJoints};
use crate::parts::hoist::RopeAction;

impl<P: Calc> Dynamics<P> {
    /// How the head moves with each joint, in the frame that slews, in m.
    pub(crate) fn head<C: Coordinate<P>>(&self, r: &Reduced<C>) -> [Vector3<C>; 2] {
        let zero = C::constant(0.0);
        let [a, d, _] = r.head;
        let axis = self.turntable().map_or(zero, |table| C::of(table.axis));
        [Vector3::new(d.x, d.y, zero), Vector3::new(zero, zero, a.x - axis)]
    }

    /// The air as the load meets it at a slewing angle (rad), where there is any.
    pub(crate) fn stream<C: Coordinate<P>>(&self, psi: C) -> Option<Stream<C>> {
        let air = self.air()?;
        Some(Stream::new(air.over(), self.blows().map(C::of), psi))
    }

    /// What acts on the load besides its rope, at a slewing angle (rad): the ground on which it stands, or gravity and air.
    pub(crate) fn surroundings<'a, C: Coordinate<P>>(
        &self,
        grounded: bool,
        air: Option<&'a Stream<C>>,
        psi: C,
    ) -> Surroundings<'a, C> {
        match grounded {
            true => Surroundings::Ground,
            false => Surroundings::Free {
                gravity: self.gravity_at(psi),
                air,
            },
        }
    }

    /// Motion under moments on both joints (N·m) at rates of the joints (rad/s), of those that are free; the load only
    /// where there is one on a rope, which acts on it as a line, and what else acts on it.
    #[expect(clippy::too_many_arguments, reason = "all that moves it")]
    pub fn slewed<C: Coordinate<P>>(
        &self,
        r: &Reduced<C>,
        [omega, turning]: [C; 2],
        load: HangingLoad<C>,
        moments: [C; 2],
        line: RopeAction<C>,
        free: [bool; 2],
        around: Surroundings<'_, C>,
    ) -> Accelerations<C, 2> {
        let (zero, half) = (C::constant(0.0), C::constant(0.5));
        let [inertia, slope] = r.turn;
        let forces = [
            (moments[0] - r.moment - half * r.slope * omega.square() + half * slope * turning.square()).def(&s::M_NET),
            (moments[1] - slope * omega * turning).def(&s::M_NET_SL),
        ];
        let ease = |i: usize, inertia: C| {
            if free[i] { C::constant(1.0) / inertia } else { zero }
        };
        let ease = [ease(0, r.inertia), ease(1, inertia)];
        let alone = [
            (forces[0] * ease[0]).def(&s::ALPHA_0),
            (forces[1] * ease[1]).def(&s::ALPHA_0SL),
        ];
        let Some(pendulum) = self.pendulum() else {
            return Accelerations {
                joints: alone,
                load: Vector3::new(zero, zero, zero),
                rate: load.rate,
                rope: zero,
                arms: [zero; 2],
                slackening: zero,
            };
        };
        let [_, _, dd] = r.head;
        let joints = HeadJoints {
            rates: [omega, turning],
            alone,
            ease,
            head: self.head(r),
            bend: Some(Vector3::new(dd.x, dd.y, zero)),
            lead: r.lead.map(|[lead, _]| lead),
            names: [self.names().acceleration, &s::D_OMEGA_SL],
        };
        let masses = [C::of(pendulum.mass), C::of(pendulum.cancelling())];
        joints.hung(load, masses, line, around)
    }
}
