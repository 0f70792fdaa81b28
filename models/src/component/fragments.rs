//! What several components have in common: groups and stages that stand once and come in where `..name(arguments)` stands.
//!
//! ```text
//! macro_rules! blown {
//!     (($height:ident) $($to:tt)*) => {
//!         composed! { @with { blown: Blown<C> = Blown::new(around[!], $height); } $($to)* }
//!     };
//! }
//! composed! {
//!     Lift over C from { Coordinate height: One<C>, ..air(), } find { pull: Pull<C> = Pull::new(height); ..blown(height); }
//! }
//! ```
//!
//! A fragment is a macro: of its arguments it makes groups or stages, whose names are the component's as if it had written
//! them, and hands them on to where they come in. Its types and functions are told by whole paths.

/// `stages!` of a component, with the groups and stages of fragments among its own.
macro_rules! composed {
    // Groups up to a fragment, the fragment's, the rest.
    (@from $head:tt [$($done:tt)*] {
        $($use:ident $source:ident: $group:ty,)* ..$fragment:ident($($argument:tt)*), $($rest:tt)*
    } $find:tt) => {
        $fragment! { ($($argument)*) @from $head [$($done)* $($use $source: $group,)*] { $($rest)* } $find }
    };
    (@from $head:tt [$($done:tt)*] { $($use:ident $source:ident: $group:ty,)* } { $($find:tt)* }) => {
        $crate::component::fragments::composed! { @find $head [$($done)* $($use $source: $group,)*] [] { $($find)* } }
    };
    // Stages in the same way.
    (@find $head:tt $from:tt [$($done:tt)*] {
        $($(#[$about:meta])* $stage:ident $([$($of:ident)+])?: $kind:ty =
          $($f:ident)::+ ($($arg:ident $([$how:tt])?),* $(,)?) $(=> $row:tt)? $(, $mark:ident)?;)*
        ..$fragment:ident($($argument:tt)*); $($rest:tt)*
    }) => {
        $fragment! { ($($argument)*) @find $head $from [$($done)*
            $($(#[$about])* $stage $([$($of)+])?: $kind = $($f)::+ ($($arg $([$how])?),*) $(=> $row)? $(, $mark)?;)*
        ] { $($rest)* } }
    };
    (@find [$($head:tt)*] [$($from:tt)*] [$($done:tt)*] { $($rest:tt)* }) => {
        $crate::component::stages::stages! { $($head)* from { $($from)* } find { $($done)* $($rest)* } }
    };
    // What a fragment has comes behind what there is.
    (@with { $($new:tt)* } @from $head:tt [$($done:tt)*] $rest:tt $find:tt) => {
        $crate::component::fragments::composed! { @from $head [$($done)* $($new)*] $rest $find }
    };
    (@with { $($new:tt)* } @find $head:tt $from:tt [$($done:tt)*] $rest:tt) => {
        $crate::component::fragments::composed! { @find $head $from [$($done)* $($new)*] $rest }
    };
    ($(#[$doc:meta])* $name:ident over $c:ident from { $($from:tt)* } find { $($find:tt)* }) => {
        $crate::component::fragments::composed! { @from [$(#[$doc])* $name over $c] [] { $($from)* } { $($find)* } }
    };
}
pub(crate) use composed;
