//! A column as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::component::whole::Whole;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::parts::motor::{CaseBrake, CaseHold};
use crate::supports::column::bearings::{ColumnForces, WorstBearings};
use crate::supports::column::counterweight::{Evened, EvenedAt};
use crate::supports::column::friction::{ColumnFriction, ColumnTurning, pivot_radius, rubbing};
use crate::supports::column::pressure::{BearingPressure, Bearings};
use crate::supports::column::symbols as s;
use crate::supports::drive;
use crate::supports::drive::brake::{Coupled, TurningHold, TurningStop};
use crate::supports::drive::given::{RingPinion, TurnedArea, TurningCase, TurningChoice, TurningDrive};
use crate::supports::drive::inertia::{Outswing, TurnedWorks};
use crate::supports::drive::motor::{TurningHeat, TurningMotor};
use crate::supports::drive::pinion::{PinionForce, meshed};
use crate::supports::drive::resistance::TurningMoments;
use crate::supports::plan::LeftOpen;
use crate::supports::upper;
use crate::supports::upper::load::{SupportCase, SupportLoad, WorstLoad};
use crate::supports::upper::weights::{UpperArea, UpperSlope, UpperWeight, UpperWorks};

stages! {
    /// A column under a crane.
    SlewingColumn over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter reach: One<C>,
        Parameter load: One<C>,
        Parameter height: One<C>,
        Parameter bodies: Vec<UpperWeight<C>>,
        Parameter areas: Vec<UpperArea<C>>,
        Parameter slope: Option<UpperSlope<C>>,
        Parameter cases: Vec<SupportCase<C>>,
        Parameter bearings: Option<Bearings<C>>,
        Parameter friction: Option<ColumnFriction<C>>,
        Parameter balancing: Option<EvenedAt<C>>,
        Parameter gravity: Option<One<C>>,
        Parameter drive: Option<TurningDrive<C>>,
        Parameter rope: Option<One<C>>,
        Parameter works: Vec<TurningCase<C>>,
        Parameter places: Vec<TurnedArea<C>>,
        Parameter holds: Vec<CaseHold<C>>,
        Parameter brake: Option<CaseBrake<C>>,
        Parameter limit: Option<One<C>>,
        Parameter pinion: Option<RingPinion<C>>,
        Fixed turns: TurningChoice,
        Fixed open: LeftOpen,
    } find {
        upper: UpperWorks<C> = UpperWorks::new(bodies, slope, areas);
        loads[each cases]: Vec<SupportLoad<C>> = SupportLoad::new(psi, reach, load, slope, upper, cases[each]);
        worst: WorstLoad<C> = WorstLoad::new(loads);
        forces[each cases]: Vec<ColumnForces<C>> = ColumnForces::new(height, loads[each]);
        most: WorstBearings<C> = WorstBearings::new(forces);
        pivot: C = pivot_radius(bearings[!], friction[!]) => R_P;
        turning[each cases]: Vec<ColumnTurning<C>> =
            ColumnTurning::new(bearings[!], friction[!], pivot, loads[each], forces[each]);
        pressures[each cases]: Vec<BearingPressure<C>> =
            BearingPressure::new(bearings[!], loads[each], forces[each]);
        evened: Evened<C> = Evened::new(balancing[!], upper, load, reach);
        works_turned: TurnedWorks<C> = TurnedWorks::new(drive[!], gravity[!], bodies, areas, places);
        swung[each works]: Vec<Outswing<C>> = Outswing::new(reach, gravity[!], rope, works[each]);
        rubbing[each works]: Vec<C> = rubbing(drive[!], turning[each]) => M_FS;
        turned[each works]: Vec<TurningMoments<C>> = TurningMoments::new(
            psi, reach, gravity[!], slope, upper, works_turned, cases[each], loads[each], works[each], swung[each],
            rubbing[each]);
        motors[each works]: Vec<TurningMotor<C>> = TurningMotor::new(drive[!], works[each], turned[each], swung[each]);
        heat: TurningHeat<C> = TurningHeat::new(drive[!], turns, swung, motors);
        holding[each holds]: Vec<TurningHold<C>> = TurningHold::new(drive[!], brake[!], holds[each], turned[each]);
        stopping[each works]: Vec<TurningStop<C>> =
            TurningStop::new(drive[!], brake[!], turned[each], swung[each], motors[each]);
        coupled[each works]: Vec<Coupled<C>> =
            Coupled::new(drive[!], brake[!], limit[!], motors[each], stopping[each]);
        meshed: C = meshed(pinion[!], turns) => RHO_C;
        pinions[each works]: Vec<PinionForce<C>> =
            PinionForce::new(drive[!], pinion[!], meshed, turned[each], motors[each]);
    }
}

impl Component for SlewingColumn {
    const WHOLE: &'static [Whole] = &drive::outline::WHOLE;

    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI, w OMEGA;
        head "Boom head, where the load hangs.": r R, f Q;
        bearing "The upper bearing in a load case.": fr H_U;
        foot "Foot bearing and pivot in a load case.": fz V, fr H_F;
    };

    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let standing = [given.slope.is_some(), !given.areas.is_empty()];
        let turning = [given.drive.is_some(), given.rope.is_some()];
        upper::keys::has(symbol, standing) && drive::has(symbol, standing, turning)
    }

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.upper().map(|_| ())
    }
}
