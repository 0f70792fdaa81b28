//! Groups and stages of a drive, as they stand in every mechanism that one drives.

/// Groups of what drives, and on what.
macro_rules! driven {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter mount: Option<$crate::drive::mount::DriveMount<C>>,
            Parameter rod: Option<$crate::drive::crank::CrankRod<C>>,
            Parameter cylinder: Option<$crate::drive::mount::Bore<C>>,
            Parameter gear: Option<$crate::drive::gear::Gear<C>>,
        } $($to)* }
    };
}
pub(crate) use driven;

/// Stages of its shaft, behind its push, its stroke's speed and its crank.
macro_rules! shaft {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            gearing: $crate::drive::shaft::Gearing<C> = $crate::drive::shaft::Gearing::new(gear[!]);
            shaft: $crate::drive::shaft::Shaft<C> = $crate::drive::line::shaft(gearing, push, stroke, cranked[?]);
            by_slider: C = $crate::drive::line::by_slider(cranked, rod[!], mount[!], push) => T_CR;
        } $($to)* }
    };
}
pub(crate) use shaft;

/// Whether a rope that drives it pulls, of a component whose coordinate is named.
macro_rules! taut_rope {
    ($pulls:ident by $angle:ident) => {
        fn $pulls(known: &mut Known<f64>) -> $crate::component::stages::Found<()> {
            if !known.given.gear.is_some_and(|gear| gear.is_rope()) {
                return Ok(());
            }
            let angle = known.given.$angle;
            let slack = known.given.fitted.hauled;
            known.hauling()?.holds(&angle, slack)
        }
    };
}
pub(crate) use taut_rope;
