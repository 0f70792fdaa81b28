//! Groups and stages of a led hoist rope, as they stand in every mechanism that may have one.

/// Groups of the rope and its sheaves.
macro_rules! led {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter rope: Option<$crate::luffing::led::reeved::LedFalls<C>>,
            Parameter sheaves: Vec<$crate::luffing::led::stretch::Sheave<C>>,
            Fixed leading: $crate::luffing::led::reeved::Leading,
        } $($to)* }
    };
}
pub(crate) use led;

/// Stages of where it runs and how the load rises by it, behind `reeved` and `leads`, the bars that lead it, and `beginning`,
/// these at the start of the working range; the luffing rate is named.
macro_rules! leading {
    (($omega:ident) $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            begun: $crate::luffing::led::path::LedStart<C> = $crate::luffing::led::path::LedStart::new(reeved, beginning);
            stretched[sheaves]: Vec<$crate::luffing::led::stretch::LedStretch<C>> =
                $crate::luffing::led::reeved::Reeved::stretches(reeved, leads);
            led: $crate::luffing::led::path::LedRope<C> =
                $crate::luffing::led::path::LedRope::new(reeved, begun, leads, stretched);
            rising: C = $crate::luffing::led::path::LedRope::v_q(led, $omega) => V_Q;
        } $($to)* }
    };
}
pub(crate) use leading;

/// The stage of what it does to these bars.
macro_rules! hauled {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            pulled: $crate::luffing::led::pull::LedPull<C> =
                $crate::luffing::led::pull::LedPull::new(reeved, load[!], leads, stretched);
        } $($to)* }
    };
}
pub(crate) use hauled;
