//! The groups in motion as stages: their equations under present inputs, and what follows from their states.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{Group, quantities};
use crate::parts::hydraulics::cylinder::Cylinder;
use crate::parts::hydraulics::oil::VACUUM;
use crate::parts::hydraulics::valve::Valve;
use crate::steering::cylinder::{Linkage, Mounting, Pose};
use crate::steering::flow::{Piston, flow};
use crate::steering::frame::Ends;
use crate::steering::hydraulic::{INDICATORS, STATES, Sampled, WorkingGroup};
use crate::steering::load::{Drag, Resistance, force};
use crate::steering::moving::scene::MovingGroups;
use crate::steering::moving::symbols as s;
use crate::steering::wheels::Wheel;

/// Natural frequency, in rad/s, of a group alone against its end stop, which is damped critically.
const STOP: f64 = 100.0;

quantities! {
    /// Angle, rate, pressures of ports and chambers, spool and its speed.
    GroupState { theta: THETA, omega: OMEGA_G, p_1: P_1, p_2: P_2, p_a: P_A, p_b: P_B, x_v: X_V, v_v: V_V }
}

/// What a group resists, in N·m: the slewing ring's friction stays while travelling.
fn resistance<C: Calc>(drag: &Drag<C>) -> Resistance<C> {
    Resistance {
        standing: drag.moment,
        travelling: (drag.moment - drag.tyres.standing + drag.tyres.travelling).def(&s::T_GX),
    }
}

/// The equations of all groups under present inputs.
#[expect(clippy::too_many_arguments, reason = "all that acts on a group")]
pub fn working<C: Calc>(
    moving: &MovingGroups<C>,
    linkages: &[Linkage<C>],
    ends: &[Ends<C>],
    mounting: &Mounting<C>,
    piston: &Piston<C>,
    drags: Option<&Vec<Drag<C>>>,
    v_t: &C,
    held: &[Sampled<C>],
    groups: &mut Vec<WorkingGroup<C>>,
) {
    let cylinder = Cylinder {
        areas: Cylinder::areas(piston.d_g, piston.d),
        lengths: [
            mounting.l_x + mounting.l_a,
            C::constant(2.0) * mounting.l_x + mounting.l_a,
        ],
        dead_volume: moving.v_0,
        port_volume: moving.v_1,
        line: Valve::rated(moving.q_n, moving.dp_l),
        leakage: moving.k_l,
        bulk_modulus: moving.beta_e,
        relief: [moving.p_r, moving.k_r],
        valve: Valve {
            conductance: Valve::rated(moving.q_n, moving.dp_n),
            overlap: moving.x_0,
            frequency: moving.omega_v,
            damping: moving.zeta_v,
        },
        parts: None,
        torn: [C::constant(0.0); 2],
    };
    let against = |i: usize| match drags.map(|drags| resistance(&drags[i])) {
        None => C::constant(0.0),
        Some(drag) if v_t.value() == 0.0 => drag.standing,
        Some(drag) => drag.travelling,
    };
    groups.clear();
    groups.extend((0..held.len()).map(|i| WorkingGroup {
        linkage: linkages[i],
        cylinder,
        inertia: moving.j,
        resistance: against(i),
        stops: ends[i].0,
        buffer: [STOP * STOP, 2.0 * STOP].map(|factor| moving.j * C::constant(factor)),
        supply: moving.p_p,
        command: held[i].command,
    }));
}

/// A group where it is.
#[derive(Clone, Copy, Debug)]
pub struct TurnedGroup<C> {
    group: WorkingGroup<C>,
    piston: Piston<C>,
    y: [C; STATES],
    rates: [C; STATES],
}
results! { each TurnedGroup as t => {
    D_OMEGA_G: t.rates[1];
    D_P_1: t.rates[2];
    D_P_2: t.rates[3];
    D_P_A: t.rates[4];
    D_P_B: t.rates[5];
    D_X_V: t.rates[6];
    D_V_V: t.rates[7];
    Z_OPEN_1: t.indicators()[0];
    Z_OPEN_2: t.indicators()[1];
    Z_RELIEF_1: t.indicators()[2];
    Z_RELIEF_2: t.indicators()[3];
    Z_MIN: t.indicators()[4];
    Z_MAX: t.indicators()[5];
    F_C: t.group.cylinder.force(&WorkingGroup::oil(&t.y));
    M_R: t.group.reaction(t.y[0], t.y[1]);
    Q_V: t.group.demand(&t.y);
    R: t.pose().l;
    OD: t.pose().od;
    V_C: t.pose().od * t.y[1];
    Q_G: flow(&t.piston, &(t.pose().od * t.y[1]));
} }

impl<C: Calc> TurnedGroup<C> {
    pub fn new(group: &WorkingGroup<C>, state: &GroupState<C>, piston: &Piston<C>) -> TurnedGroup<C> {
        let y = std::array::from_fn(|k| Group::take(state, k));
        TurnedGroup {
            group: *group,
            piston: *piston,
            y,
            rates: group.equations(&y),
        }
    }

    fn pose(&self) -> Pose<C> {
        self.group.pose(self.y[0])
    }

    fn indicators(&self) -> [C; INDICATORS] {
        self.group.indicators(&self.y)
    }
}

/// Force of a group's cylinder against its resistance where it is, in N.
#[derive(Clone, Copy, Debug)]
pub struct Push<C>([C; 2]);
results! { each Push as p => { F_G: p.0[0]; F_GX: p.0[1]; } }

impl<C: Calc> Push<C> {
    pub fn new(drag: &Drag<C>, turned: &TurnedGroup<C>) -> Push<C> {
        let (drag, arm) = (resistance(drag), turned.pose().od);
        Push([force(drag.standing, arm), force(drag.travelling, arm)])
    }
}

/// The oil with the least pressure of all.
#[derive(Clone, Copy, Debug)]
pub struct LowestOil<C> {
    /// How far that is above vacuum, in Pa.
    margin: C,
    cavitates: bool,
}
results! { LowestOil as o => { Z_VACUUM: o.margin; CAVITATES: C::constant(f64::from(o.cavitates)); } }

impl<C: Calc> LowestOil<C> {
    pub fn new(turned: &[TurnedGroup<C>]) -> LowestOil<C> {
        let each = turned
            .iter()
            .map(|group| (group, WorkingGroup::oil(&group.y).least().1));
        let lower = |a: (_, C), b: (_, C)| {
            if b.1.value() < a.1.value() {
                (b.0, b.1.over(a.1))
            } else {
                (a.0, a.1.over(b.1))
            }
        };
        let (lowest, least) = each.reduce(lower).expect("at least four groups");
        let oil = WorkingGroup::oil(&lowest.y.map(Calc::value));
        LowestOil {
            margin: least - C::constant(VACUUM),
            cavitates: oil.cavitates(|| [2, 3, 4, 5].map(|k| lowest.rates[k].value())),
        }
    }
}

/// Flow of the pump to all valves, in m³/s.
pub fn demand<C: Calc>(turned: &[TurnedGroup<C>]) -> C {
    let each = turned.iter().map(|group| group.group.demand(&group.y));
    each.fold(C::constant(0.0), |sum, flow| sum + flow)
}

/// The ground passes under the wheels of a group as commanded; they roll along where they point.
pub fn rolled<C: Calc>(wheel: &Wheel<C>, speed: &C, state: &GroupState<C>) -> C {
    *speed * (wheel.theta - state.theta).sin_cos().1
}

pub fn rate<C: Calc>(state: &GroupState<C>) -> C {
    state.omega
}

/// Angles that the PLC is to reach, in rad: the set points on their way through a change of mode, or those of the
/// nearest command, within the groups' ranges.
pub fn wanted(ends: &[Ends<f64>], headings: &[f64], points: Option<&Vec<f64>>, wants: &mut Vec<f64>) {
    let points = points.map_or(headings, Vec::as_slice);
    wants.clear();
    wants.extend(
        points
            .iter()
            .zip(ends)
            .map(|(point, ends)| point.clamp(ends.0[0], ends.0[1])),
    );
}

pub fn lack<C: Calc>(wanted: &C, state: &GroupState<C>) -> C {
    *wanted - state.theta
}

/// What the PLC holds of a group.
#[derive(Clone, Copy, Debug)]
pub struct Commanded<C>(C);
results! { each Commanded as c => { U_V: c.0; } }

impl<C: Calc> Commanded<C> {
    pub fn new(held: &Sampled<C>) -> Commanded<C> {
        Commanded(held.command)
    }
}
