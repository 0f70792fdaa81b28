//! The steering as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::steering::accuracy::{Accuracy, Alone, Error, GreatestSlip, Slipping, slips};
use crate::steering::centre::{Centre, TurningPole};
use crate::steering::change::Change;
use crate::steering::commanding::CentreShift;
use crate::steering::cylinder::{Linkage, Mounting, Pose};
use crate::steering::flow::{CylinderFlow, CylinderSpeed, Piston, Total};
use crate::steering::frame::{Ends, Mount, limits};
use crate::steering::limits::Limits;
use crate::steering::load::{Drag, Force, GroupLoad, Travelling, Tyre};
use crate::steering::machine::{Axis, Footprint, Machine};
use crate::steering::margin::Margin;
use crate::steering::mode::{By, Command, Corner, Mode, Wanted};
use crate::steering::nearest::{Followed, Heading, Nearest};
use crate::steering::refusal::Refusal;
use crate::steering::ring::Bearing;
use crate::steering::set_points::{Left, Planned, SetPoint, SetSpeed, UnderWay, Way, set_points};
use crate::steering::swept::Swept;
use crate::steering::symbols as s;
use crate::steering::transition::Pace;
use crate::steering::travel::{Rate, Travel, Turn};
use crate::steering::wheels::{Rolling, Scale, Speed, Wheel};

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
        Fixed mounts: Vec<Mount>,
        Fixed outline: Footprint,
        Time clock: One<C>,
        Memory change: Change,
    } find {
        machine: Machine<C> = Machine::new(axes, outline);
        limits[axes]: Vec<Limits> = limits(mounts, cylinder), plain;
        ends[each axes]: Vec<Ends<C>> = Ends::new(mounts[each], cylinder, limits[each]);
        linkages[each axes]: Vec<Linkage<C>> = linkage(cylinder[!], mounts[each]);
        command: Command<C> = Command::new(wanted, mode, by, corner, theta_b, r_t);
        centre: Centre<C> = centre(mode, machine, command);
        pole: TurningPole<C> = TurningPole::new(machine, centre);
        swept: Swept<C> = Swept::new(machine, centre);
        rollings[each axes]: Vec<Rolling<C>> = Rolling::new(centre, axes[each]);
        wheels[each axes]: Vec<Wheel<C>> = Wheel::new(rollings[each], limits[each]);
        margin: Margin<C> = Margin::new(wheels, limits, ends);
        scale: Scale<C> = Scale::new(centre, rollings, v_t);
        speeds[each axes]: Vec<Speed<C>> = Speed::new(rollings[each], wheels[each], scale);
        turn: Turn<C> = Turn::new(centre, scale);
        travel: Travel<C> = Travel::new(machine, centre, scale);
        slope: CentreShift<C> = CentreShift::new(mode, machine, command);
        rates[each axes]: Vec<Rate<C>> = Rate::new(axes[each], rollings[each], slope, omega_s);
        poses[each axes]: Vec<Pose<C>> = pose(linkages[each], wheels[each]);
        drags[each loads]: Vec<Drag<C>> = Drag::new(tyre[!], bearing, loads[each]);
        forces[each loads]: Vec<Force<C>> = Force::new(drags[each], poses[each]);
        travelling[each loads]: Vec<Travelling<C>> = Travelling::new(drags[each], poses[each]);
        strokes[each axes]: Vec<CylinderSpeed<C>> = CylinderSpeed::new(rates[each], poses[each]);
        flows[each axes]: Vec<CylinderFlow<C>> = CylinderFlow::new(piston[!], strokes[each]);
        total: Total<C> = Total::new(flows);
        errors[each axes]: Vec<Error<C>> = Error::new(accuracy[!], poses[each]);
        alone[each axes]: Vec<Alone<C>> = Alone::new(speeds[each], errors[each], v_t);
        slips[axes]: Vec<Slipping<C>> = slips(machine, centre, errors), searched;
        greatest: GreatestSlip<C> = GreatestSlip::new(slips), searched;
        nearest: Nearest = Nearest::new(machine, limits, mode, command, centre, margin), searched;
        followed: Followed<C> = Followed::new(nearest, theta_b, r_t, wanted), searched;
        headings[each axes]: Vec<Heading<C>> = Heading::new(nearest, axes[each], limits[each]), searched;
        planned: Planned = Planned::new(machine, limits, linkages, pace[!], nearest, headings, change), searched;
        left: Left<C> = Left::new(planned, change, clock), searched;
        under_way: UnderWay = UnderWay::new(limits, linkages, pace[!], nearest, change, clock), searched;
        way: Way = Way::new(machine, nearest, under_way, planned[under_way], change, clock), searched;
        points[axes]: Vec<SetPoint<C>> = set_points(machine, linkages, headings, way, planned[way], change), searched;
        set_speeds[each axes]: Vec<SetSpeed<C>> = SetSpeed::new(axes[each], points[each], way, v_t), searched;
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
    const INDICATORS: &'static [&'static Symbol] = &[&s::MARGIN];

    const PORTS: &'static [Port] = ports! { s:
        machine "Motion of the machine's middle.": v_x V_MX, v_y V_MY, w OMEGA;
        group "A steered group, and the cylinder that turns it.":
            phi THETA, phi_set THETA_S, w OMEGA_I, v_roll V, v_roll_set V_S, f_z G, s L_C, v V_C, f F_G, q Q_G;
    };

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.wheels().map(|_| ())
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
            known.given.change.from(way.motion, points.iter().map(|point| point.0));
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
