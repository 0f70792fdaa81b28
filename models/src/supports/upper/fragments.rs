//! Groups of what slews on a support, as they stand in every kind of it.

/// Groups of the slewing angle, its rate, the load and its reach.
macro_rules! slews {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Coordinate psi: One<C>,
            Rate omega: One<C>,
            Parameter reach: One<C>,
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
            Parameter cases: Vec<$crate::supports::upper::load::SupportCase<C>>,
        } $($to)* }
    };
}
pub(crate) use carried;
