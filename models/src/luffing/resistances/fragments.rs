//! Groups and stages of load cases, as they stand in every luffing mechanism.

/// Groups of the cases, of what stands in the wind and rubs, and of what drives and brakes.
macro_rules! cases {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter cases: Vec<$crate::luffing::resistances::given::Case<C>>,
            Parameter bodies: Vec<$crate::luffing::resistances::given::CaseBody<C>>,
            Parameter rubbing: Vec<$crate::luffing::resistances::given::CasePin<C>>,
            Parameter air: Option<One<C>>,
            Parameter driver: Option<$crate::luffing::resistances::given::CaseMotor<C>>,
            Parameter starting: Option<$crate::parts::starts::way::StartWay<C>>,
            Parameter brake: Option<$crate::luffing::resistances::given::CaseBrake<C>>,
            Parameter second: Option<$crate::luffing::resistances::given::SecondBrake<C>>,
            Parameter holds: Vec<$crate::luffing::resistances::given::CaseHold<C>>,
        } $($to)* }
    };
}
pub(crate) use cases;

/// Groups of the pins' sizes and of what a scene has chosen of all this.
macro_rules! chosen {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter sizes: Option<Vec<$crate::luffing::strength::given::PinSize<C>>>,
            Fixed chosen: Option<$crate::luffing::resistances::given::CasesChoice>,
        } $($to)* }
    };
}
pub(crate) use chosen;

/// Stages of what the drive must overcome in each case, behind the mechanism's `places`; the coordinate, what makes the
/// drive's force of a moment, and of what the forces in its pins follow besides are named.
macro_rules! resisted {
    (($phi:ident, $drive:ident, $($of:ident $([$how:tt])?),+) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            weighty: $crate::luffing::resistances::placed::Weighty<C> = resisting::weighty(places, bodies, chosen[!]) => _;
            moved: $crate::luffing::resistances::placed::MovedBars<C> =
                resisting::moved(places, weighty, residual[?], $phi) => _;
            sums: $crate::luffing::resistances::sums::Sums<C> =
                $crate::luffing::resistances::sums::Sums::new(moved, bodies, cases, chosen[!]);
            resisted[each cases]: Vec<$crate::luffing::resistances::moments::Resisted<C>> =
                $crate::luffing::resistances::moments::Resisted::new(sums, load[!], air[!], cases[each]);
            loads[each cases]: Vec<$crate::luffing::resistances::loads::Loads<C>> =
                $crate::luffing::resistances::loads::Loads::new(moved, bodies, chosen[!], load[!], cases[each], resisted[each]) => _;
            pinned[each cases]: Vec<$crate::luffing::resistances::friction::Pins<C>> =
                resisting::pins($($of $([$how])?),+, moved, loads[each], resisted[each]) => _;
            rubbed[each cases]: Vec<$crate::luffing::resistances::friction::Rubbed<C>> =
                $crate::luffing::resistances::friction::Rubbed::new(resisted[each], pinned[each], rubbing, chosen[!]);
            force[each cases]: Vec<C> = resisting::force($drive, rubbed[each]) => F_R;
            motored[each cases]: Vec<$crate::luffing::resistances::motor::Motored<C>> =
                $crate::luffing::resistances::motor::Motored::new(
                    driver[!], sums, cases[each], resisted[each], rubbed[each], force[each]
                );
            heating: $crate::luffing::resistances::motor::Heating<C> =
                $crate::luffing::resistances::motor::Heating::new(driver[!], sums, resisted, motored, chosen[!]);
            holding[each holds]: Vec<$crate::luffing::resistances::brakes::Holding<C>> =
                $crate::luffing::resistances::brakes::Holding::new(driver[!], brake[!], second, sums, holds[each], resisted[each]);
            stopped[each holds]: Vec<$crate::luffing::resistances::brakes::Stopped<C>> =
                $crate::luffing::resistances::brakes::Stopped::new(driver[!], brake[!], second, sums, cases[each], motored[each]);
            started[each cases]: Vec<$crate::parts::starts::way::Started<C>> =
                $crate::luffing::resistances::starts::started(driver[!], starting[!], sums, cases[each], motored[each]);
        } $($to)* }
    };
}
pub(crate) use resisted;

/// The stage of the pins' stresses in each case.
macro_rules! sheared {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            sheared[each cases]: Vec<$crate::luffing::strength::pins::Sheared<C>> =
                $crate::luffing::strength::pins::Sheared::new(sizes[!], chosen[!], pinned[each]);
        } $($to)* }
    };
}
pub(crate) use sheared;
