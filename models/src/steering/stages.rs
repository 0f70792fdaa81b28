//! The steering as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::plane::Point;
use crate::steering::accuracy::Accuracy;
use crate::steering::centre::{Centre, TurningPole};
use crate::steering::change::Change;
use crate::steering::cylinder::{Linkage, Mounting, Pose};
use crate::steering::flow::Piston;
use crate::steering::followed::Followed;
use crate::steering::frame::{Ends, Mount, limits};
use crate::steering::hydraulic::{Sampled, WorkingGroup};
use crate::steering::limits::Limits;
use crate::steering::load::{Drag, GroupLoad, Tyre};
use crate::steering::machine::{Axis, Footprint, Machine};
use crate::steering::margin::Margin;
use crate::steering::mode::{By, Command, Corner, Mode, Wanted};
use crate::steering::moving::motion::{Commanded, GroupState, LowestOil, Push, TurnedGroup};
use crate::steering::moving::scene::MovingGroups;
use crate::steering::moving::{motion, symbols as s};
use crate::steering::nearest::Nearest;
use crate::steering::refusal::Refusal;
use crate::steering::ring::Bearing;
use crate::steering::set_points::{Planned, UnderWay, Way};
use crate::steering::swept::Swept;
use crate::steering::transition::Pace;
use crate::steering::wheels::{Rolling, Wheel};
use crate::steering::{accuracy, flow, followed, load, set_points, slope, travel, wheels};

stages! {
    /// Steering of a machine on many steered wheel groups.
    SteeredGroups over C from {
        Coordinate theta_b: One<C>,
        Rate omega_s: One<C>,
        Input v_t: One<C>,
        Input mode: Mode,
        Input by: By,
        Input corner: Corner,
        Input r_t: One<C>,
        Input wanted: Wanted<C>,
        Input loads: Vec<GroupLoad<C>>,
        Parameter axes: Vec<Axis<C>>,
        Parameter tyre: Option<Tyre<C>>,
        Parameter bearing: Option<Bearing<C>>,
        Parameter cylinder: Option<Mounting<C>>,
        Parameter piston: Option<Piston<C>>,
        Parameter accuracy: Option<Accuracy<C>>,
        Parameter pace: Option<Pace<C>>,
        Parameter moving: Option<MovingGroups<C>>,
        State moved: Vec<GroupState<C>>,
        Fixed mounts: Vec<Mount>,
        Fixed outline: Footprint,
        Time clock: One<C>,
        Memory change: Change,
        Memory held: Vec<Sampled<C>>,
    } find {
        machine: Machine<C> = Machine::new(axes, outline) => _;
        limits[axes]: Vec<Limits> = limits(mounts, cylinder) => _, plain;
        ends[each axes]: Vec<Ends<C>> = Ends::new(mounts[each], cylinder, limits[each]) => _;
        linkages[each axes]: Vec<Linkage<C>> = linkage(cylinder[!], mounts[each]) => _;
        command: Command<C> = Command::new(wanted, mode, by, corner, theta_b, r_t) => _;
        centre: Centre<C> = centre(mode, machine, command) => _;
        pole: TurningPole<C> = TurningPole::new(machine, centre);
        swept: Swept<C> = Swept::new(machine, centre);
        rollings[each axes]: Vec<Rolling<C>> = Rolling::new(centre, axes[each]) => _;
        wheels[each axes]: Vec<Wheel<C>> = Wheel::new(rollings[each], limits[each]);
        margin: Margin<C> = Margin::new(wheels, limits, ends);
        scale: C = wheels::scale(centre, rollings, v_t) => _;
        speeds[each axes]: Vec<C> = wheels::speed(rollings[each], wheels[each], scale) => V;
        turn: C = travel::turn(centre, scale) => OMEGA;
        travel: Point<C> = travel::middle(machine, centre, scale) => [V_MX, V_MY];
        slope: Option<Centre<C>> = slope::slope(mode, machine, command) => _;
        rates[each axes]: Vec<C> = travel::steering(axes[each], rollings[each], slope, omega_s) => THETA_DOT;
        poses[each axes]: Vec<Pose<C>> = pose(linkages[each], wheels[each]);
        drags[each loads]: Vec<Drag<C>> = Drag::new(tyre[!], bearing, loads[each]);
        forces[each loads]: Vec<C> = load::standing(drags[each], poses[each]) => F_G;
        travelling[each loads]: Vec<C> = load::travelling(drags[each], poses[each]) => F_GX;
        strokes[each axes]: Vec<C> = flow::speed(rates[each], poses[each]) => V_C;
        flows[each axes]: Vec<C> = flow::flow(piston[!], strokes[each]) => Q_G;
        total: C = flow::total(flows) => Q_SUM;
        errors[each axes]: Vec<C> = Accuracy::angle_error(accuracy[!], poses[each]) => DELTA;
        alone[each axes]: Vec<C> = accuracy::alone(speeds[each], errors[each], v_t) => _;
        slips[axes]: Vec<C> = accuracy::slips(machine, centre, errors) => SLIP, searched;
        greatest: C = accuracy::greatest(slips) => SLIP_MAX, searched;
        nearest: Nearest = Nearest::new(machine, limits, mode, command, centre, margin) => _, searched;
        followed: Followed<C> = Followed::new(nearest, theta_b, r_t, wanted), searched;
        headings[each axes]: Vec<C> = followed::heading(nearest, axes[each], limits[each]) => THETA_N, searched;
        planned: Planned = Planned::new(machine, limits, linkages, pace[!], nearest, headings, change), searched;
        left: C = set_points::left(planned, change, clock) => T_LEFT, searched;
        under_way: UnderWay = UnderWay::new(limits, linkages, pace[!], nearest, change, clock) => _, searched;
        way: Way = Way::new(machine, nearest, under_way, planned[under_way], change, clock) => _, searched;
        points[axes]: Vec<C> =
            set_points::headings(machine, linkages, headings, way, planned[way], change) => THETA_S, searched;
        set_speeds[each axes]: Vec<C> = set_points::speed(axes[each], points[each], way, v_t) => V_S, searched;
        wants[axes]: Vec<C> = motion::wanted(ends, headings, points[?]) => THETA_W, settled;
        lacks[each axes]: Vec<C> = motion::lack(wants[each], moved[each]) => E, decided;
        commands[each axes]: Vec<Commanded<C>> = Commanded::new(held[each]);
        working[axes]: Vec<WorkingGroup<C>> =
            motion::working(moving[!], linkages, ends, cylinder[!], piston[!], drags[?], v_t, held) => _;
        headed[each axes]: Vec<C> = motion::rate(moved[each]) => D_THETA;
        turned[each axes]: Vec<TurnedGroup<C>> = TurnedGroup::new(working[each], moved[each], piston[!]), decided;
        rolled[each axes]: Vec<C> = motion::rolled(wheels[each], speeds[each], moved[each]) => V, decided;
        pushes[each loads]: Vec<Push<C>> = Push::new(drags[each], turned[each]), decided;
        lowest: LowestOil<C> = LowestOil::new(turned);
        demand: C = motion::demand(turned) => Q_P, decided;
    }
}

impl Given<f64> {
    /// What the inputs ask of their mode.
    #[must_use]
    pub fn command(&self) -> Command<f64> {
        Command::new(
            &self.wanted,
            &self.mode,
            &self.by,
            &self.corner,
            &self.theta_b,
            &self.r_t,
        )
    }
}

impl Component for SteeredGroups {
    const STATES: [&'static [&'static Symbol]; 2] = [
        &[],
        listed!(s: D_THETA, D_OMEGA_G, D_P_1, D_P_2, D_P_A, D_P_B, D_X_V, D_V_V),
    ];

    const INDICATORS: &'static [&'static Symbol] = listed!(
        s: Z_OPEN_1, Z_OPEN_2, Z_RELIEF_1, Z_RELIEF_2, Z_MIN, Z_MAX, MARGIN, Z_VACUUM
    );

    const PORTS: &'static [Port] = ports! { s:
        machine "Motion of the machine's middle.": v_x V_MX, v_y V_MY, w OMEGA;
        group "A steered group, and the cylinder that turns it.":
            phi THETA, phi_set THETA_S, w THETA_DOT, v_roll V, v_roll_set V_S, f_z G, s R, v V_C, f F_G, q Q_G,
            w OMEGA_G;
    };

    /// In motion the rate of a group's angle is a state, and the pump's flow takes the place of what cylinders take.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        match given.moving {
            None => symbol != &s::THETA_W,
            Some(_) => ![&s::THETA_DOT, &s::Q_SUM].contains(&symbol),
        }
    }

    fn first(given: &Given<f64>) -> &'static [&'static Symbol] {
        const MOVING: &[&Symbol] = listed!(
            s: THETA_W, E, U_V, F_C, M_R, Q_V, D_THETA, D_OMEGA_G, D_P_1, D_P_2, D_P_A, D_P_B, D_X_V, D_V_V, Z_OPEN_1,
            Z_OPEN_2, Z_RELIEF_1, Z_RELIEF_2, Z_MIN, Z_MAX, MARGIN, Z_VACUUM, CAVITATES, Q_P
        );
        given.moving.map_or(&[], |_| MOVING)
    }

    fn is_input(_: &Given<f64>, symbol: &'static Symbol) -> bool {
        symbol == &s::P_P
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.wheels()?;
        if known.given.moving.is_some() {
            known.working()?;
        }
        Ok(())
    }

    /// The set points of this moment are where a change of mode starts.
    fn leave(known: &mut Known<f64>) {
        let time = *known.given.clock;
        if known.given.pace.is_none() || !known.given.change.starts(time) {
            return;
        }
        // A command that its mode does not take has no set points: the last start is kept.
        if known.points().is_ok()
            && let (Some(way), Some(points)) = (&known.way, &known.points)
        {
            known.given.change.from(way.motion, points.iter().copied());
        }
        known.change().start(time);
    }

    fn start(known: &mut Known<f64>) {
        known.change().run();
    }
}

fn centre<C: Calc>(mode: &Mode, machine: &Machine<C>, command: &Command<C>) -> Result<Centre<C>, Refusal> {
    mode.centre(machine, *command)
}

fn linkage<C: Calc>(cylinder: &Mounting<C>, mount: &Mount) -> Linkage<C> {
    cylinder.linkage(mount.mirrored)
}

fn pose<C: Calc>(linkage: &Linkage<C>, wheel: &Wheel<C>) -> Pose<C> {
    linkage.at(wheel.turn)
}
