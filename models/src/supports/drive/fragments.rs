//! Groups and stages of a slewing drive, as they stand in every kind of support.

/// Groups of the drive, its load cases, its brake, what limits its torque, and its pinion; of what the scene leaves open.
macro_rules! turned_by {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter gravity: Option<One<C>>,
            Parameter drive: Option<$crate::supports::drive::given::TurningDrive<C>>,
            Parameter rope: Option<One<C>>,
            Parameter slip: Option<$crate::parts::starts::SlipStart<C>>,
            Parameter inverter: Option<$crate::parts::starts::InverterStart<C>>,
            Parameter works: Vec<$crate::supports::drive::given::TurningCase<C>>,
            Parameter places: Vec<$crate::supports::drive::given::TurnedArea<C>>,
            Parameter holds: Vec<$crate::parts::motor::CaseHold<C>>,
            Parameter brake: Option<$crate::parts::motor::CaseBrake<C>>,
            Parameter limit: Option<One<C>>,
            Parameter pinion: Option<$crate::supports::drive::given::RingPinion<C>>,
            Fixed turns: $crate::supports::drive::given::TurningChoice,
            Fixed open: $crate::supports::plan::LeftOpen,
        } $($to)* }
    };
}
pub(crate) use turned_by;

/// Stages of what turns and of the load's outswing.
macro_rules! swung {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            works_turned: $crate::supports::drive::inertia::TurnedWorks<C> =
                $crate::supports::drive::inertia::TurnedWorks::new(drive[!], gravity[!], bodies, areas, places, spun[?]);
            swung[each works]: Vec<$crate::supports::drive::inertia::Outswing<C>> =
                $crate::supports::drive::inertia::Outswing::new(out, gravity[!], rope, works[each]);
        } $($to)* }
    };
}
pub(crate) use swung;

/// Stages of what resists turning, motor, brake, coupling and pinion, behind the friction of the support, `rubbing`.
macro_rules! turned {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            turned[each works]: Vec<$crate::supports::drive::resistance::TurningMoments<C>> =
                $crate::supports::drive::resistance::TurningMoments::new(
                    psi, out, gravity[!], slope, upper, works_turned, cases[each], loads[each], works[each], swung[each],
                    rubbing[each]
                );
            motors[each works]: Vec<$crate::supports::drive::motor::TurningMotor<C>> =
                $crate::supports::drive::motor::TurningMotor::new(drive[!], works[each], turned[each], swung[each]);
            slipped[each works]: Vec<$crate::parts::starts::slip::Slipped<C>> =
                $crate::supports::drive::starts::slipped(drive[!], slip[!], swung[each], motors[each]);
            ramped[each works]: Vec<$crate::parts::starts::inverter::Ramped<C>> =
                $crate::supports::drive::starts::ramped(drive[!], inverter[!], swung[each], motors[each]);
            pushed[each works]: Vec<$crate::supports::drive::starts::HardestPush<C>> =
                $crate::supports::drive::starts::HardestPush::new(drive[!], slip, inverter, motors[each]);
            heat: $crate::supports::drive::motor::TurningHeat<C> =
                $crate::supports::drive::motor::TurningHeat::new(drive[!], turns, swung, motors);
            holding[each holds]: Vec<$crate::supports::drive::brake::TurningHold<C>> =
                $crate::supports::drive::brake::TurningHold::new(drive[!], brake[!], holds[each], turned[each]);
            stopping[each works]: Vec<$crate::supports::drive::brake::TurningStop<C>> =
                $crate::supports::drive::brake::TurningStop::new(drive[!], brake[!], turned[each], swung[each], motors[each]);
            coupled[each works]: Vec<$crate::supports::drive::brake::Coupled<C>> =
                $crate::supports::drive::brake::Coupled::new(
                    drive[!], brake[!], limit[!], motors[each], pushed[each], stopping[each]
                );
            meshed: C = $crate::supports::drive::pinion::meshed(pinion[!], turns) => RHO_C;
            pinions[each works]: Vec<$crate::supports::drive::pinion::PinionForce<C>> =
                $crate::supports::drive::pinion::PinionForce::new(
                    drive[!], pinion[!], meshed, turned[each], motors[each], pushed[each]
                );
        } $($to)* }
    };
}
pub(crate) use turned;
