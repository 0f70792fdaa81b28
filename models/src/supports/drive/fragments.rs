//! Groups and stages of a slewing drive, as they stand in every kind of support.

/// Groups of the drive, its load cases, its brake, what limits its torque, and its pinion; of what the scene leaves open.
macro_rules! turned_by {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter gravity: Option<One<C>>,
            Parameter drive: Option<$crate::supports::drive::given::GivenDrive<C>>,
            Parameter rope: Option<One<C>>,
            Parameter starting: Option<$crate::parts::starts::way::StartWay<C>>,
            Parameter works: Vec<$crate::supports::drive::given::TurningCase<C>>,
            Parameter places: Vec<$crate::supports::drive::given::TurnedArea<C>>,
            Parameter holds: Vec<$crate::parts::motor::CaseHold<C>>,
            Parameter brake: Option<$crate::parts::motor::CaseBrake<C>>,
            Parameter limit: Option<One<C>>,
            Parameter pinion: Option<$crate::supports::drive::given::RingPinion<C>>,
            Parameter stages: Vec<$crate::supports::drive::given::GearStage<C>>,
            Parameter mesh: Option<One<C>>,
            Fixed moved: Option<$crate::supports::drive::given::Moves>,
            Fixed turns: $crate::supports::drive::given::TurningChoice,
            Fixed open: $crate::supports::plan::LeftOpen,
        } $($to)* }
    };
}
pub(crate) use turned_by;

/// Stages of the drive's gear, of what turns and of the load's outswing.
macro_rules! swung {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            geared: $crate::supports::drive::gear::TurningDrive<C> =
                $crate::supports::drive::gear::TurningDrive::new(drive[!], stages, pinion, mesh);
            works_turned: $crate::supports::drive::inertia::TurnedWorks<C> =
                $crate::supports::drive::inertia::TurnedWorks::new(geared, gravity[!], bodies, areas, places, spun[?]);
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
            dry: C = $crate::supports::drive::moving::dry(turns, moved[!], rubbing) => M_FS0;
            turned[each works]: Vec<$crate::supports::drive::resistance::TurningMoments<C>> =
                $crate::supports::drive::resistance::TurningMoments::new(
                    psi, out, gravity[!], slope, upper, works_turned, cases[each], loads[each], works[each], swung[each],
                    rubbing[each]
                );
            motors[each works]: Vec<$crate::supports::drive::motor::TurningMotor<C>> =
                $crate::supports::drive::motor::TurningMotor::new(geared, works[each], turned[each], swung[each]);
            started[each works]: Vec<$crate::parts::starts::way::Started<C>> =
                $crate::supports::drive::starts::started(geared, starting[!], swung[each], motors[each]);
            pushed[each works]: Vec<$crate::supports::drive::starts::HardestPush<C>> =
                $crate::supports::drive::starts::HardestPush::new(geared, starting, motors[each]);
            heat: $crate::supports::drive::motor::TurningHeat<C> =
                $crate::supports::drive::motor::TurningHeat::new(geared, turns, swung, motors);
            holding[each holds]: Vec<$crate::supports::drive::brake::TurningHold<C>> =
                $crate::supports::drive::brake::TurningHold::new(geared, brake[!], holds[each], turned[each]);
            stopping[each works]: Vec<$crate::supports::drive::brake::TurningStop<C>> =
                $crate::supports::drive::brake::TurningStop::new(geared, brake[!], turned[each], swung[each], motors[each]);
            coupled[each works]: Vec<$crate::supports::drive::brake::Coupled<C>> =
                $crate::supports::drive::brake::Coupled::new(
                    geared, brake[!], limit[!], motors[each], pushed[each], stopping[each]
                );
            side: C = $crate::supports::drive::moving::side(geared, moved[!]) => J_D;
            slips[each works]: Vec<C> = $crate::supports::drive::moving::slips(geared, moved[!], coupled[each]) => M_LC;
            meshed: C = $crate::supports::drive::pinion::meshed(pinion[!], turns) => RHO_C;
            pinions[each works]: Vec<$crate::supports::drive::pinion::PinionForce<C>> =
                $crate::supports::drive::pinion::PinionForce::new(
                    geared, pinion[!], meshed, turned[each], motors[each], pushed[each]
                );
            carrying: $crate::supports::drive::shafts::DrivingShaft<C> =
                $crate::supports::drive::shafts::DrivingShaft::new(geared, turns, motors, pushed);
            shafts[stages]: Vec<$crate::supports::drive::shafts::GearShaft<C>> =
                $crate::supports::drive::shafts::shafts(stages, carrying);
        } $($to)* }
    };
}
pub(crate) use turned;

/// Which results there are of what slews, by what is given.
macro_rules! has_what_slews {
    () => {
        fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
            let standing = [
                given.slope.is_some(),
                !given.areas.is_empty(),
                given.luffer.is_some(),
            ];
            let turning = [
                given.drive.is_some(),
                given.rope.is_some(),
                given.starting.is_some(),
                !given.stages.is_empty(),
            ];
            $crate::supports::upper::keys::has(symbol, standing)
                && $crate::supports::drive::has(symbol, standing, turning)
                && $crate::parts::starts::way::has(given.starting.as_ref(), symbol)
        }
    };
}
pub(crate) use has_what_slews;
