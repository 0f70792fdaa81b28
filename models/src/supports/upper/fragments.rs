//! Groups of what slews on a support, as they stand in every kind of it.

/// Groups of the slewing angle, its rate, the load and its reach.
macro_rules! slews {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Coordinate psi: One<C>,
            Rate omega: One<C>,
            Parameter reach: Option<One<C>>,
            Parameter load: One<C>,
        } $($to)* }
    };
}
pub(crate) use slews;

/// Groups of what weighs, what stands in the wind, the slope and the load cases.
macro_rules! carried {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter bodies: Vec<$crate::supports::upper::weights::UpperWeight<C>>,
            Parameter areas: Vec<$crate::supports::upper::weights::UpperArea<C>>,
            Parameter slope: Option<$crate::supports::upper::weights::UpperSlope<C>>,
            Parameter hook: Option<One<C>>,
            Parameter cases: Vec<$crate::supports::upper::load::SupportCase<C>>,
        } $($to)* }
    };
}
pub(crate) use carried;

/// Groups of the luffing mechanism that gives reach and weights, with the height of its foot.
macro_rules! luffs {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter foot: Option<One<C>>,
            Input held: Option<One<C>>,
            Fixed luffer: Option<$crate::luffing::luffed::Luffer>,
        } $($to)* }
    };
}
pub(crate) use luffs;

/// Stages of the reach and of what slews.
macro_rules! reached {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            luffed: $crate::luffing::luffed::Luffed<C> = $crate::luffing::luffed::Luffed::held(luffer[!], held);
            spun: $crate::luffing::luffed::LuffedInertia<C> = $crate::luffing::luffed::LuffedInertia::new(luffed);
            out: C = $crate::luffing::luffed::reach(reach, luffed[?]) => _;
            upper: $crate::supports::upper::weights::UpperWorks<C> =
                $crate::supports::upper::weights::UpperWorks::new(bodies, slope, hook, areas, foot, luffed[?]);
        } $($to)* }
    };
}
pub(crate) use reached;
