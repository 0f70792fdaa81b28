//! Groups and stages of a luffing mechanism that may move by itself, as they stand in every one.

/// Groups of the coordinate, its rate, the states of the motion and its inputs.
macro_rules! coordinate {
    (($phi:ident, $omega:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Coordinate $phi: One<C>,
            Rate $omega: One<C>,
            State states: Option<$crate::luffing::moving::given::CraneStates<C>>,
            Input inputs: Option<$crate::luffing::moving::given::Inputs<C>>,
        } $($to)* }
    };
}
pub(crate) use coordinate;

/// Groups of its constants, its hoist, with the falls of its tackle where they are named, what is around its load, and what slews with it.
macro_rules! plant {
    (($($falls:ident)?) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter constants: Option<$crate::luffing::moving::given::Constants<C>>,
            Parameter ramp: Option<$crate::luffing::moving::hoisting::HoistRamp<C>>,
            Parameter motor: Option<$crate::luffing::moving::hoisting::HoistMotor<C>>,
            $(Parameter $falls: Option<$crate::luffing::moving::hoisting::HoistFalls<C>>,)?
            Parameter give: Option<$crate::luffing::moving::hoisting::RopeGive<C>>,
            Parameter around: Option<$crate::parts::air::AirAround<C>>,
            Parameter ground: Option<$crate::parts::ground::GroundBelow<C>>,
            Parameter slewed: Option<$crate::luffing::moving::given::SlewedParts<C>>,
        } $($to)* }
    };
}
pub(crate) use plant;

/// Groups of the oil of a cylinder that moves it.
macro_rules! by_oil {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter oil: Option<$crate::luffing::moving::given::CylinderOil<C>>,
            Parameter oil_parts: Option<$crate::parts::hydraulics::parts::OilParts<C>>,
        } $($to)* }
    };
}
pub(crate) use by_oil;

/// The stage of that cylinder.
macro_rules! oiled {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            oiled: $crate::parts::hydraulics::cylinder::Cylinder<C> =
                $crate::luffing::moving::built::cylinder(oil[!], cylinder[!], oil_parts) => _;
        } $($to)* }
    };
}
pub(crate) use oiled;

/// Stages of what its oil does.
macro_rules! oil_flows {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            cavitates: $crate::luffing::moving::stages::CraneOil =
                $crate::luffing::moving::stages::CraneOil::new(at, moves, oil[!]);
            oil_flows: $crate::luffing::moving::stages::OilFlows<C> =
                $crate::luffing::moving::stages::OilFlows::new(built, told, at, oil_parts[!]);
        } $($to)* }
    };
}
pub(crate) use oil_flows;

/// Groups of its controllers and of what happened before.
macro_rules! remembered {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter control: Option<$crate::luffing::moving::control::ByAxis<$crate::parts::control::SpeedControl<C>>>,
            Input commanded: Option<$crate::luffing::moving::control::ByAxis<One<C>>>,
            Latch latched: Option<$crate::luffing::moving::control::ByAxis<$crate::parts::control::Latched<C>>>,
            Memory wound: Option<One<C>>,
            Memory past: Option<$crate::luffing::moving::hydraulic::Modes>,
            State regulating: Option<$crate::luffing::moving::control::ByAxis<$crate::parts::control::continuous::Regulating<C>>>,
            Memory regime: Option<$crate::luffing::moving::control::ByAxis<$crate::parts::control::continuous::Regime<C>>>,
        } $($to)* }
    };
}
pub(crate) use remembered;

/// Stages of a single boom's equations of motion, whose bodies and hoist are found: the boom's kind and its bodies are named.
macro_rules! single_boom {
    (($kind:ident, $bodies:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            parts[constants]: Vec<$crate::luffing::moving::single::SingleParts<$kind, C>> =
                $crate::luffing::moving::single::parts(
                    $bodies, load[!], balance, hoist, around, ground, slewed, constants[!], fitted
                ) => _;
            boom[constants]: Vec<
                $crate::luffing::moving::reduced::Renewed<$crate::luffing::moving::single::Heavy<$kind, C>>
            > = $crate::luffing::moving::single::heavy(parts) => _;
        } $($to)* }
    };
}
pub(crate) use single_boom;

/// The stage of a motor that turns with a mechanism, by the way of its drive.
macro_rules! geared {
    (($way:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            geared[constants]: Vec<
                $crate::luffing::moving::reduced::Renewed<$crate::luffing::moving::geared::Geared<C>>
            > = $crate::luffing::moving::geared::geared($way[?], driver) => _;
        } $($to)* }
    };
}
pub(crate) use geared;

/// The stage of what wind and slope meet in motion, by the places that load cases have: how they are found is named.
macro_rules! exposed {
    (($of:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            exposed[constants]: Vec<$crate::luffing::moving::reduced::Renewed<$crate::luffing::moving::exposed::Exposed<resisting::$of, C>>> =
                $crate::luffing::moving::exposed::exposed(places[?], weighty[?], bodies, chosen, load, air, fitted) => _;
        } $($to)* }
    };
}
pub(crate) use exposed;

/// Stages of what its controllers hold and of the equations under what is commanded.
macro_rules! told {
    (($phi:ident, $omega:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            sampled: $crate::luffing::moving::control::SampledDrives<C> =
                $crate::luffing::moving::control::sampled(control[!], commanded[!], latched[!], $phi, $omega, states[!]);
            commands: $crate::luffing::moving::given::Inputs<C> =
                $crate::luffing::moving::control::acting::acting(inputs[!], latched) => _;
            told[constants]: Vec<$crate::luffing::moving::level::Level<C>> =
                $crate::luffing::moving::stages::told(built, commands) => _;
        } $($to)* }
    };
}
pub(crate) use told;

/// Stages of a single boom's rates, behind `at`; its coordinate and kind are named.
macro_rules! boom_rates {
    (($phi:ident, $kind:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            moves: $crate::luffing::moving::stages::CraneMoves<C> =
                $crate::luffing::moving::stages::moves(built, told, at, $phi) => _;
            turning: $crate::luffing::moving::single::BoomRates<$kind, C> =
                $crate::luffing::moving::single::BoomRates::new(moves);
            rates: $crate::luffing::moving::stages::CraneRates<C> =
                $crate::luffing::moving::stages::CraneRates::new(moves, fitted);
        } $($to)* }
    };
}
pub(crate) use boom_rates;

/// The stage of controllers that are not sampled, behind the crane's rates.
macro_rules! regulated {
    (($phi:ident, $omega:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            regulated: $crate::luffing::moving::control::continuous::RegulatedDrives<C> =
                $crate::luffing::moving::control::continuous::regulated(
                    control[!], commanded[!], regulating[!], regime[!], $phi, $omega, states[!], moves, fitted
                );
        } $($to)* }
    };
}
pub(crate) use regulated;

/// Stages of the moments that resist and of the rope's pull.
macro_rules! pulled {
    (($phi:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            resisting: C = $crate::luffing::moving::stages::resisting(built, told, at, $phi) => M_R;
            pull: C = $crate::luffing::moving::stages::pull(built, told, at, $phi) => S_R;
            drum: C = $crate::luffing::moving::stages::drum(built, told, at, $phi) => M_R_H;
        } $($to)* }
    };
}
pub(crate) use pulled;

/// Stages of what air and ground do to the load, wind and slope to the bodies, of what blows have taken, of what acts on slewing,
/// and of the load as seen from the head then.
macro_rules! surrounded {
    (($phi:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            drag: $crate::parts::plane::Point<C> =
                $crate::luffing::moving::stages::drag(built, told, at, $phi, around[!]) => [F_AIR, P_AIR];
            standing: $crate::parts::plane::Point<C> =
                $crate::luffing::moving::stages::standing(built, told, at, $phi, ground[!]) => [N_G, H_G];
            acted: $crate::luffing::moving::stages::BarActed<C> = $crate::luffing::moving::stages::acted(built, told, at, $phi);
            blown: C = $crate::luffing::moving::stages::blown(at) => W_BLOW;
            on_slewing: $crate::luffing::moving::stages::OnSlewing<C> =
                $crate::luffing::moving::stages::OnSlewing::new(built, told, at, $phi, slewed[!], around, states[!]);
            seen: $crate::luffing::moving::stages::LoadSeen<C> =
                $crate::luffing::moving::stages::LoadSeen::new(at, fitted);
        } $($to)* }
    };
}
pub(crate) use surrounded;
