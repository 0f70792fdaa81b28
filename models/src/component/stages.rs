//! What a component is made of: groups of given quantities, stages that follow from them, rows of results.
//!
//! ```text
//! stages! {
//!     Lift over C from {
//!         Coordinate height: One<C>,
//!         Rate speed: One<C>,
//!         Parameter ropes: Ropes<C>,
//!     } find {
//!         pull: Pull<C> = Pull::new(ropes, height);
//!         power: C = power(pull, speed) => P;
//!     }
//! }
//! results! { Pull as p => { S_R: p.s_r; } }
//! ```
//!
//! An argument is a group or an earlier stage, and *is* the dependency: what follows from what is known at compile
//! time. For `power` the macro makes a field `Option<C>`, a bit, the mask of the groups `ropes | height | speed`,
//! and a function that makes `pull` first where it is not known. Changing `speed` clears the bit of `power` alone.

use crate::component::scalar::Scalar;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Fault, Quantity};

/// What was found. A fault is boxed: what every stage and every result hands on is one word and not four.
pub type Found<T> = Result<T, Box<Fault>>;

/// A given number: its group, which is a bit of every mask, and its place there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    pub group: u8,
    pub place: u16,
}

/// A result: its stage, its row there, and which of several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot {
    pub stage: u8,
    pub row: u8,
    /// From 0.
    pub of: u16,
    /// Groups from which its stage follows.
    pub sources: u64,
}

/// What a group of given quantities is to whoever runs the component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Use {
    /// What the scene has chosen: no variable.
    Fixed,
    Parameter,
    Input,
    /// The weight of the load, in which forces are affine.
    Load,
    /// The input over which tables and the default experiment run: one of a component.
    Coordinate,
    /// Its rate.
    Rate,
    /// States of a motion, besides a coordinate and a rate that are states.
    State,
    /// The time: no variable of the component.
    Time,
    /// What happened before, where results follow from it: saved with the state, no variable.
    Memory,
    /// The same, of which a sample decides alone.
    Latch,
}

impl Use {
    /// Whether it may change while a model runs.
    #[must_use]
    pub fn varies(self) -> bool {
        !matches!(self, Use::Fixed | Use::Parameter)
    }
}

/// Results of a stage by their row. `results!` implements it.
pub trait Rows<C: Calc> {
    const ROWS: &'static [&'static Symbol];
    /// # Errors
    /// Where there is no such result at this place.
    fn row(&self, row: u8, of: u16) -> Found<C>;
}

/// A step of the computation, and a section of the book.
#[derive(Debug)]
pub struct Stage {
    pub id: &'static str,
    /// Groups of sources from which it follows, directly or not.
    pub sources: u64,
    pub rows: &'static [&'static Symbol],
    /// Found by a search: no derivative.
    pub searched: bool,
    /// Values decide in it, which leaves no trace in a formula.
    pub decided: bool,
}

/// What a component knows, over any scalar. `stages!` implements it.
pub trait Stages: Sized + 'static {
    type Given<C: Calc>: Clone + Send + Sync + 'static;
    type Known<C: Scalar>: Send + 'static;
    const GROUPS: &'static [(&'static str, Use)];
    const STAGES: &'static [Stage];
    fn new<C: Scalar>(given: Self::Given<C>) -> Self::Known<C>;
    fn given<C: Scalar>(known: &Self::Known<C>) -> &Self::Given<C>;
    /// All sources over another scalar, in their order; nothing is known of it yet.
    fn map<C: Calc, D: Calc>(given: &Self::Given<C>, f: &mut dyn FnMut(Source, Quantity, C) -> D) -> Self::Given<D>;
    /// Looks at all sources, in their order.
    fn each<C: Calc>(given: &Self::Given<C>, f: &mut dyn FnMut(Source, Quantity, C));
    fn take<C: Scalar>(known: &Self::Known<C>, source: Source) -> C;
    /// Changes a source and forgets what follows from its group.
    fn put<C: Scalar>(known: &mut Self::Known<C>, source: Source, value: C);
    /// Through `into`, not by value: a [`Found`] of two words goes through the stack and stalls.
    ///
    /// # Errors
    /// Those of the stages.
    fn result<C: Scalar>(known: &mut Self::Known<C>, slot: &Slot, into: &mut C) -> Found<()>;
    /// A stage, by its place among [`STAGES`](Stages::STAGES).
    ///
    /// # Errors
    /// Its own, and those of the stages that it follows from.
    fn make<C: Scalar>(known: &mut Self::Known<C>, stage: u8) -> Found<()>;
    /// Becomes what another one is, put where the last one lay.
    fn follow<C: Scalar>(known: &mut Self::Known<C>, other: &Self::Known<C>);
    /// Takes over from plain numbers what need not be computed again; `moved` groups change with the direction.
    fn lift<D: Scalar>(value: &Self::Known<f64>, dual: &mut Self::Known<D>, moved: u64);
    /// How many of a stage there are in this scene: none, one, or as many as what it is numbered by.
    fn count(known: &Self::Known<f64>, stage: u8) -> Option<Option<u16>>;
}

/// What the function of a stage may return: the stage, or a fault.
pub trait Made<T> {
    /// # Errors
    /// The fault, if it is one.
    fn made(self) -> Found<T>;
}

impl<T> Made<T> for T {
    #[inline(always)]
    fn made(self) -> Found<T> {
        Ok(self)
    }
}

impl<T, F> Made<T> for Result<T, F>
where
    Box<Fault>: From<F>,
{
    #[inline(always)]
    fn made(self) -> Found<T> {
        self.map_err(Box::from)
    }
}

/// What is found at a stage: `results! { Position as p => { R: p.r; ALPHA: p.alpha(); } }`. A row is an expression,
/// computed when it is asked for, and may fail with `?`. `plain Places` where it has no scalars, `each Wheel` where the
/// stage is numbered and has one for each.
macro_rules! results {
    (each plain $kind:ident $($rows:tt)*) => { $crate::component::stages::results!(@rows [Vec<$kind>] [each] $($rows)*); };
    (each $kind:ident $($rows:tt)*) => { $crate::component::stages::results!(@rows [Vec<$kind<C>>] [each] $($rows)*); };
    (plain $kind:ident $($rows:tt)*) => { $crate::component::stages::results!(@rows [$kind] [one] $($rows)*); };
    (@rows [$kind:ty] [$count:ident] as $it:pat => { $($symbol:ident: $row:expr;)* }) => {
        impl<C: $crate::kernel::calc::Calc> $crate::component::stages::Rows<C> for $kind {
            const ROWS: &'static [&'static $crate::kernel::symbol::Symbol] = &[$(&s::$symbol),*];
            #[inline(always)]
            #[allow(non_camel_case_types, unused_variables, clippy::upper_case_acronyms, reason = "named after symbols")]
            fn row(&self, row: u8, of: u16) -> $crate::component::stages::Found<C> {
                enum Row { $($symbol,)* }
                let $it = $crate::component::stages::results!(@of $count self of);
                // A chain of comparisons, which the compiler makes a jump table.
                $(if row == Row::$symbol as u8 { return Ok($row); })*
                unreachable!("no such row")
            }
        }
    };
    (@of one $all:ident $of:ident) => { $all };
    (@of each $all:ident $of:ident) => { &$all[usize::from($of)] };
    ($kind:ident $($rows:tt)*) => { $crate::component::stages::results!(@rows [$kind<C>] [one] $($rows)*); };
}
pub(crate) use results;

/// Declares the groups and the stages of a component, once per module: makes `Given<C>`, `Known<C>` and the stages'
/// accessors `known.pull()?`.
///
/// A stage exists where what it follows from exists: `group[!]` is an optional group that it needs, handed on without
/// its `Option`; `stage[?]` one that it takes as an `Option` of a reference, `None` where that does not exist;
/// `stage[when]` likewise one that is made only where the argument `when` before it `holds()`.
///
/// After what finds it: `=> SYMBOL` where the stage is that one number, `=> [X, Y]` where it is a vector, `=> _` where it has no results; else `results!`
/// has its rows.
///
/// After a stage: `, lifted` where derivatives take it over from plain numbers (it has a `map`), `, plain` where it has
/// no scalars at all, `, searched` where it is found with plain numbers only, `, settled` where a list of them is and
/// other stages go on with it: derivatives take it over where it does not change; `, decided` where states decide which
/// formula holds, so that its results follow from all parameters and from what the rates follow from.
///
/// `stage[each group]: Vec<Kind>` is numbered like the group: its function finds one of them, `argument[each]` being the
/// one of the same number. `stage[group]: Vec<Kind>` likewise, with a function that fills all. Both are put where the
/// last ones lay, so that nothing is allocated.
macro_rules! stages {
    (@found [] $c:ident $known:ident $stage:ident $($f:ident)::+ ($($arg:ident $([$how:tt])?),*)) => {
        $known.$stage = Some($crate::component::stages::Made::made($($f)::+(
            $($crate::component::stages::stages!(@see [$($how)?] $known $arg)),*
        ))?);
    };
    (@found [each $of:ident] $c:ident $known:ident $stage:ident $($f:ident)::+ ($($arg:ident $([$how:tt])?),*)) => {
        let mut room = $known.$stage.take().unwrap_or_default();
        let count = usize::from(Group::count(&$known.given.$of));
        $(let $arg = $crate::component::stages::stages!(@all [$($how)?] $known $arg count);)*
        let one = |at: usize| $($f)::+($($crate::component::stages::stages!(@one [$($how)?] $arg at)),*);
        room.clear();
        room.extend((0..count).map(|at| <$c as Calc>::body(at, || one(at))));
        $known.$stage = Some(room);
    };
    (@found [$of:ident] $c:ident $known:ident $stage:ident $($f:ident)::+ ($($arg:ident $([$how:tt])?),*)) => {
        let mut room = $known.$stage.take().unwrap_or_default();
        let done = $($f)::+($($crate::component::stages::stages!(@see [$($how)?] $known $arg),)* &mut room);
        $known.$stage = Some(room);
        $crate::component::stages::Made::<()>::made(done)?;
    };
    // An argument of a function that is called once for each number.
    (@all [each] $known:ident $arg:ident $count:ident) => { &See::$arg($known)[..$count] };
    (@all [$($how:tt)?] $known:ident $arg:ident $count:ident) => {
        $crate::component::stages::stages!(@see [$($how)?] $known $arg)
    };
    (@one [each] $arg:ident $at:ident) => { &$arg[$at] };
    (@one [$($how:tt)?] $arg:ident $at:ident) => { $arg };
    // A search runs on plain numbers alone.
    (@on [searched] $known:ident) => {
        match (&mut *$known as &mut dyn std::any::Any).downcast_mut::<Known<f64>>() {
            Some(plain) => plain,
            None => return Err(Box::new($crate::component::stages::searched())),
        }
    };
    (@on [settled] $known:ident) => { $crate::component::stages::stages!(@on [searched] $known) };
    (@on [$($mark:ident)?] $known:ident) => { &mut *$known };
    (@make [] $known:ident $arg:ident) => { Make::$arg($known)? };
    (@make [!] $known:ident $arg:ident) => { () };
    (@make [each] $known:ident $arg:ident) => { Make::$arg($known)? };
    (@make [?] $known:ident $arg:ident) => { if $known.exists(Bit::$arg) { Make::$arg($known)? } };
    (@make [$when:ident] $known:ident $arg:ident) => { if See::$when($known).holds() { Make::$arg($known)? } };
    (@see [] $known:ident $arg:ident) => { See::$arg($known) };
    (@see [!] $known:ident $arg:ident) => { See::$arg($known).as_ref().expect("it is needed") };
    (@see [?] $known:ident $arg:ident) => { $known.exists(Bit::$arg).then(|| See::$arg($known)) };
    (@see [$when:ident] $known:ident $arg:ident) => { See::$when($known).holds().then(|| See::$arg($known)) };
    (@need [] $need:ident $arg:ident) => { $need[Bit::$arg as usize] };
    (@need [!] $need:ident $arg:ident) => { 1 << Bit::$arg as u64 };
    (@need [each] $need:ident $arg:ident) => {
        if (Bit::$arg as usize) < GROUPS { 1 << Bit::$arg as u64 } else { $need[Bit::$arg as usize] }
    };
    (@need [?] $need:ident $arg:ident) => { 0 };
    (@need [$when:ident] $need:ident $arg:ident) => { $need[Bit::$arg as usize] };
    // What does not change with the direction comes from the plain numbers: constants as they are, places as found.
    (@lift [lifted] $value:ident $dual:ident $stage:ident $fixed:expr) => {
        $fixed && { $dual.$stage = $value.$stage.as_ref().map(|known| known.map(Calc::constant)); true }
    };
    (@lift [plain] $value:ident $dual:ident $stage:ident $fixed:expr) => {
        { $dual.$stage.clone_from(&$value.$stage); true }
    };
    (@lift [settled] $value:ident $dual:ident $stage:ident $fixed:expr) => {
        $fixed && {
            let room = $dual.$stage.get_or_insert_default();
            room.clear();
            room.extend($value.$stage.iter().flatten().map(|known| Other::constant(*known)));
            true
        }
    };
    (@lift [$($mark:ident)?] $value:ident $dual:ident $stage:ident $fixed:expr) => { false };
    (@room [] $c:ident $given:ident) => { None };
    (@room [each $of:ident] $c:ident $given:ident) => { $crate::component::stages::stages!(@room [$of] $c $given) };
    (@room [$of:ident] $c:ident $given:ident) => {
        Some(Vec::with_capacity(usize::from(Group::<$c>::count(&$given.$of))))
    };
    (@rows [] $c:ident $kind:ty) => { <$kind as Rows<$c>>::ROWS };
    (@rows [_] $c:ident $kind:ty) => { &[] };
    (@rows [$symbol:ident] $c:ident $kind:ty) => { &[&s::$symbol] };
    (@rows [[$x:ident, $y:ident]] $c:ident $kind:ty) => { &[&s::$x, &s::$y] };
    (@row [] [$($of:ident)*] $found:expr, $slot:ident) => { Rows::row($found, $slot.row, $slot.of)? };
    (@row [_] [$($of:ident)*] $found:expr, $slot:ident) => { Err($crate::component::stages::absent())? };
    (@row [[$x:ident, $y:ident]] [] $found:expr, $slot:ident) => { $found[usize::from($slot.row)] };
    (@row [$symbol:ident] [] $found:expr, $slot:ident) => { *$found };
    (@row [$symbol:ident] [$($of:ident)+] $found:expr, $slot:ident) => { $found[usize::from($slot.of)] };
    (@searched [searched]) => { true };
    (@searched [settled]) => { true };
    (@searched [$($mark:ident)?]) => { false };
    (@decided [settled]) => { true };
    (@decided [decided]) => { true };
    (@decided [$($mark:ident)?]) => { false };
    (@count [] $given:ident) => { None };
    (@count [each $of:ident] $given:ident) => { Some($crate::kernel::group::Group::<f64>::count(&$given.$of)) };
    (@count [$of:ident] $given:ident) => { Some($crate::kernel::group::Group::<f64>::count(&$given.$of)) };
    ($(#[$doc:meta])* $name:ident over $c:ident from { $($use:ident $source:ident: $group:ty),* $(,)? } find {
        $($(#[$about:meta])* $stage:ident $([$($of:ident)+])?: $kind:ty =
          $($f:ident)::+ ($($arg:ident $([$how:tt])?),* $(,)?) $(=> $row:tt)? $(, $mark:ident)?;)*
    }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name;

        /// Sources by their groups.
        #[derive(Clone, Debug)]
        pub struct Given<$c: $crate::kernel::calc::Calc> { $(pub $source: $group),* }

        /// What has been found so far.
        pub struct Known<$c: $crate::kernel::calc::Calc> {
            given: Given<$c>,
            /// Groups that the scene has.
            there: u64,
            known: u128,
            $($stage: Option<$kind>),*
        }

        #[allow(non_camel_case_types, dead_code, clippy::unused_unit, reason = "made for every group and stage")]
        const _: () = {
            use $crate::component::scalar::Scalar;
            use $crate::kernel::calc::Calc;
            use $crate::component::stages::{Found, Rows, Slot, Source, Stage, Stages, Use};
            use $crate::kernel::group::Group;
            use $crate::kernel::variable::Quantity;

            /// Groups, then stages, by their numbers; and stages by theirs, which are their bits.
            #[derive(Clone, Copy)]
            enum Bit { $($source,)* $($stage,)* End }
            enum At { $($stage,)* End }
            const GROUPS: usize = [$(Bit::$source as usize),*].len();
            const BITS: usize = Bit::End as usize;
            const _: () = assert!(GROUPS <= 64 && BITS - GROUPS <= 128, "more groups or stages than bits");
            /// Of each group and stage: the groups that it follows from.
            const UP: [u64; BITS] = {
                let mut up = [0; BITS];
                $(up[Bit::$source as usize] = 1 << Bit::$source as u32;)*
                $(
                    $(assert!((Bit::$arg as u64) < Bit::$stage as u64, "a stage before what it follows from");)*
                    up[Bit::$stage as usize] = 0 $(| up[Bit::$arg as usize])*;
                )*
                up
            };
            /// Of each stage: the groups without which it does not exist.
            const NEED: [u64; BITS] = {
                let mut need = [0; BITS];
                $(need[Bit::$stage as usize] = 0 $(| $crate::component::stages::stages!(@need [$($how)?] need $arg))*;)*
                need
            };
            /// Of each group: all stages but those that follow from it.
            const KEEP: [u128; GROUPS] = {
                let mut keep = [!0; GROUPS];
                let mut group = 0;
                while group < GROUPS {
                    let mut stage = GROUPS;
                    while stage < BITS {
                        if UP[stage] >> group & 1 == 1 { keep[group] &= !(1 << (stage - GROUPS)); }
                        stage += 1;
                    }
                    group += 1;
                }
                keep
            };
            impl<$c: Scalar> Known<$c> {
                #[inline(always)]
                fn exists(&self, bit: Bit) -> bool { NEED[bit as usize] & !self.there == 0 }
            }
            /// Makes whatever an argument names: a group is always there.
            struct Make;
            impl Make {
                $(#[inline(always)] fn $source<$c: Scalar>(_: &mut Known<$c>) -> Found<()> { Ok(()) })*
                $(#[inline] fn $stage<$c: Scalar>(known: &mut Known<$c>) -> Found<()> {
                    if known.known >> At::$stage as u32 & 1 == 0 {
                        let known = $crate::component::stages::stages!(@on [$($mark)?] known);
                        $($crate::component::stages::stages!(@make [$($how)?] known $arg);)*
                        $crate::component::stages::stages!(@found [$($($of)+)?] $c known $stage $($f)::+ ($($arg $([$how])?),*));
                        known.known |= 1 << At::$stage as u32;
                    }
                    Ok(())
                })*
            }
            struct See;
            impl See {
                $(#[inline(always)] fn $source<$c: Scalar>(known: &Known<$c>) -> &$group { &known.given.$source })*
                $(#[inline(always)] fn $stage<$c: Scalar>(known: &Known<$c>) -> &$kind { known.$stage.as_ref().expect("just made") })*
            }
            impl<$c: Scalar> Known<$c> {
                $(/// A group to be changed: what follows from it is forgotten.
                pub fn $source(&mut self) -> &mut $group {
                    self.known &= KEEP[Bit::$source as usize];
                    &mut self.given.$source
                })*
                $($(#[$about])* pub fn $stage(&mut self) -> Found<&$kind> { Make::$stage(self)?; Ok(See::$stage(self)) })*
            }
            impl Stages for $name {
                type Given<C: Calc> = Given<C>;
                type Known<C: Scalar> = Known<C>;
                const GROUPS: &'static [(&'static str, Use)] = &[$((stringify!($source), Use::$use)),*];
                const STAGES: &'static [Stage] = {
                    type $c = f64;
                    &[$(Stage {
                        id: stringify!($stage),
                        sources: UP[Bit::$stage as usize],
                        rows: $crate::component::stages::stages!(@rows [$($row)?] $c $kind),
                        searched: $crate::component::stages::stages!(@searched [$($mark)?]),
                        decided: $crate::component::stages::stages!(@decided [$($mark)?]),
                    }),*]
                };
                fn new<$c: Scalar>(given: Given<$c>) -> Known<$c> {
                    let there = 0 $(| u64::from(Group::<$c>::there(&given.$source)) << Bit::$source as u64)*;
                    Known {
                        $($stage: $crate::component::stages::stages!(@room [$($($of)+)?] $c given),)*
                        given,
                        there,
                        known: 0,
                    }
                }
                fn given<$c: Scalar>(known: &Known<$c>) -> &Given<$c> { &known.given }
                fn map<$c: Calc, Other: Calc>(given: &Given<$c>, f: &mut dyn FnMut(Source, Quantity, $c) -> Other) -> Given<Other> {
                    Given { $($source: {
                        let mut place = 0;
                        Group::map(&given.$source, &mut |quantity, value| {
                            let source = Source { group: Bit::$source as u8, place };
                            place += 1;
                            f(source, quantity, value)
                        })
                    }),* }
                }
                fn each<$c: Calc>(given: &Given<$c>, f: &mut dyn FnMut(Source, Quantity, $c)) {
                    $({
                        let mut place = 0;
                        Group::each(&given.$source, &mut |quantity, value| {
                            f(Source { group: Bit::$source as u8, place }, quantity, value);
                            place += 1;
                        });
                    })*
                }
                #[inline]
                fn take<$c: Scalar>(known: &Known<$c>, source: Source) -> $c {
                    $(if source.group == Bit::$source as u8 { return Group::<$c>::take(&known.given.$source, source.place.into()); })*
                    unreachable!("no such group")
                }
                #[inline]
                fn put<$c: Scalar>(known: &mut Known<$c>, source: Source, value: $c) {
                    known.known &= KEEP[usize::from(source.group)];
                    $(if source.group == Bit::$source as u8 { return Group::put(&mut known.given.$source, source.place.into(), value); })*
                }
                #[inline]
                fn result<$c: Scalar>(known: &mut Known<$c>, slot: &Slot, into: &mut $c) -> Found<()> {
                    $(if slot.stage == At::$stage as u8 {
                        // Out of the way of what is known.
                        if known.known >> At::$stage as u32 & 1 == 0 { Self::make(known, slot.stage)?; }
                        *into = $crate::component::stages::stages!(@row [$($row)?] [$($($of)+)?] See::$stage(known), slot);
                        return Ok(());
                    })*
                    unreachable!("no such stage")
                }
                #[inline(never)]
                fn make<$c: Scalar>(known: &mut Known<$c>, stage: u8) -> Found<()> {
                    $(if stage == At::$stage as u8 { return Make::$stage(known); })*
                    unreachable!("no such stage")
                }
                fn follow<$c: Scalar>(known: &mut Known<$c>, other: &Known<$c>) {
                    (known.there, known.known) = (other.there, other.known);
                    $(known.given.$source.clone_from(&other.given.$source);)*
                    $(if other.known >> At::$stage as u32 & 1 == 1 { known.$stage.clone_from(&other.$stage); })*
                }
                #[allow(unused_variables, reason = "a component may have nothing to lift")]
                fn lift<Other: Scalar>(value: &Known<f64>, dual: &mut Known<Other>, moved: u64) {
                    let _ = moved;
                    $({
                        let bit = 1 << At::$stage as u32;
                        if value.known & bit != 0
                            && $crate::component::stages::stages!(@lift [$($mark)?] value dual $stage (UP[Bit::$stage as usize] & moved == 0)) {
                            dual.known |= bit;
                        }
                    })*
                }
                fn count(known: &Known<f64>, stage: u8) -> Option<Option<u16>> {
                    let given = &known.given;
                    $(if stage == At::$stage as u8 {
                        return known.exists(Bit::$stage).then(|| $crate::component::stages::stages!(@count [$($($of)+)?] given));
                    })*
                    let _ = given;
                    None
                }
            }
        };
    };
}
pub(crate) use stages;

/// For a result that this scene does not model.
#[cold]
#[must_use]
pub fn absent() -> Box<Fault> {
    Box::new(Fault::new("this scene does not model the result"))
}

/// For a derivative of what a search has found.
#[cold]
#[must_use]
pub fn searched() -> Fault {
    Fault::new("found by a search: no derivative")
}
