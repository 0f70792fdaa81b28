//! Groups of given quantities: what changes together, over any scalar.

use crate::kernel::allowed::{OutOfRange, check};
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Quantity;

/// Quantities that change together, over any scalar. `quantities!` implements it; an `Option` of a
/// group may be absent, a `Vec` of groups is numbered, an enumeration is a group of one number.
pub trait Group<C: Calc>: Clone + 'static {
    type Over<D: Calc>: Group<D>;
    /// Numbers in it; of a `Vec`, in each.
    const SIZE: usize;
    fn map<D: Calc>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> Self::Over<D>;
    /// Looks at each number, in the order of their places.
    fn each(&self, f: &mut dyn FnMut(Quantity, C)) {
        self.map(&mut |quantity, value| {
            f(quantity, value);
            value
        });
    }
    fn take(&self, place: usize) -> C;
    fn put(&mut self, place: usize, value: C);
    /// Whether the scene has it.
    fn there(&self) -> bool {
        true
    }
    /// How many of a numbered group there are.
    fn count(&self) -> u16 {
        1
    }
}

impl<C: Calc, G: Group<C>> Group<C> for Option<G> {
    type Over<D: Calc> = Option<G::Over<D>>;
    const SIZE: usize = G::SIZE;
    fn map<D: Calc>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> Self::Over<D> {
        self.as_ref().map(|group| group.map(f))
    }
    fn each(&self, f: &mut dyn FnMut(Quantity, C)) {
        self.iter().for_each(|group| group.each(f));
    }
    #[inline]
    fn take(&self, place: usize) -> C {
        self.as_ref().expect("listed").take(place)
    }
    #[inline]
    fn put(&mut self, place: usize, value: C) {
        self.as_mut().expect("listed").put(place, value);
    }
    #[inline]
    fn there(&self) -> bool {
        self.is_some()
    }
    fn count(&self) -> u16 {
        self.as_ref().map_or(0, Group::count)
    }
}

impl<C: Calc, G: Group<C>> Group<C> for Vec<G> {
    type Over<D: Calc> = Vec<G::Over<D>>;
    const SIZE: usize = G::SIZE;
    fn map<D: Calc>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> Self::Over<D> {
        let each = (1..).zip(self);
        each.map(|(i, group)| group.map(&mut |(symbol, _), value| f((symbol, Some(i)), value)))
            .collect()
    }
    fn each(&self, f: &mut dyn FnMut(Quantity, C)) {
        for (i, group) in (1..).zip(self) {
            group.each(&mut |(symbol, _), value| f((symbol, Some(i)), value));
        }
    }
    #[inline]
    fn take(&self, place: usize) -> C {
        self[place / G::SIZE].take(place % G::SIZE)
    }
    #[inline]
    fn put(&mut self, place: usize, value: C) {
        self[place / G::SIZE].put(place % G::SIZE, value);
    }
    fn there(&self) -> bool {
        !self.is_empty()
    }
    fn count(&self) -> u16 {
        self.len() as u16
    }
}

/// Refuses the first of given quantities that its symbol does not allow.
///
/// # Errors
/// As [`check`].
pub fn sound<C: Calc>(group: &impl Group<C>) -> Result<(), OutOfRange> {
    let mut sound = Ok(());
    group.each(&mut |(symbol, _), value: C| {
        if sound.is_ok() {
            sound = check(symbol, value.value(), symbol.range.ends());
        }
    });
    sound
}

/// One quantity, whose symbol the scene may choose.
#[derive(Clone, Copy, Debug)]
pub struct One<C>(pub &'static Symbol, pub C);

impl<C> std::ops::Deref for One<C> {
    type Target = C;
    #[inline]
    fn deref(&self) -> &C {
        &self.1
    }
}

impl<C: Calc> Group<C> for One<C> {
    type Over<D: Calc> = One<D>;
    const SIZE: usize = 1;
    fn map<D: Calc>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> One<D> {
        One(self.0, f((self.0, None), self.1))
    }
    #[inline]
    fn take(&self, _: usize) -> C {
        self.1
    }
    #[inline]
    fn put(&mut self, _: usize, value: C) {
        self.1 = value;
    }
}

/// Declares a group of given quantities: a struct over any scalar that knows
/// the symbol of each field.
macro_rules! quantities {
    ($(#[$doc:meta])* $name:ident { $($field:ident: $symbol:ident),* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<C> {
            $(pub $field: C),*
        }

        impl<C: Copy> $name<C> {
            /// The symbols of the fields, in their order.
            pub const SYMBOLS: &'static [&'static $crate::kernel::symbol::Symbol] = &[$(&s::$symbol),*];

            /// Each quantity by its symbol; `None` where one is not given.
            pub fn of(given: impl Fn(&'static $crate::kernel::symbol::Symbol) -> Option<C>) -> Option<$name<C>> {
                Some($name { $($field: given(&s::$symbol)?),* })
            }

            /// The same quantities over another scalar.
            pub fn map<D>(&self, f: &mut dyn FnMut(&'static $crate::kernel::symbol::Symbol, C) -> D) -> $name<D> {
                $name { $($field: f(&s::$symbol, self.$field)),* }
            }
        }

        impl $name<f64> {
            /// Those of a scene; `None` where one is not given.
            pub fn read(v: &$crate::kernel::schema::Values) -> Option<$name<f64>> {
                $name::of(|symbol| v.of(symbol))
            }
        }

        impl<C: $crate::kernel::calc::Calc> $crate::kernel::group::Group<C> for $name<C> {
            type Over<D: $crate::kernel::calc::Calc> = $name<D>;
            const SIZE: usize = [$(stringify!($field)),*].len();
            fn map<D: $crate::kernel::calc::Calc>(&self, f: &mut dyn FnMut($crate::kernel::variable::Quantity, C) -> D) -> $name<D> {
                $name { $($field: f((&s::$symbol, None), self.$field)),* }
            }
            fn each(&self, f: &mut dyn FnMut($crate::kernel::variable::Quantity, C)) {
                let symbols = $name::<C>::SYMBOLS.iter().enumerate();
                symbols.for_each(|(place, &symbol)| f((symbol, None), $crate::kernel::group::Group::take(self, place)));
            }
            #[inline]
            #[allow(unused_assignments, reason = "the last count is not asked for")]
            fn take(&self, place: usize) -> C {
                let mut at = 0; // Known to the compiler at every comparison.
                $(if place == at { return self.$field; } at += 1;)*
                unreachable!("no such place")
            }
            #[inline]
            #[allow(unused_assignments, reason = "the last count is not asked for")]
            fn put(&mut self, place: usize, value: C) {
                let mut at = 0;
                $(if place == at { self.$field = value; return; } at += 1;)*
            }
        }
    };
}
pub(crate) use quantities;

/// Implements [`Group`] for one of several groups, and the same over another scalar: `either!(Gear { Screw, Pinion })`,
/// each of which holds the group of its name.
macro_rules! either {
    ($name:ident { $($kind:ident),* }) => {
        impl<C: Copy> $name<C> {
            /// The same over another scalar.
            pub fn map<D>(&self, f: &mut dyn FnMut(&'static $crate::kernel::symbol::Symbol, C) -> D) -> $name<D> {
                match self { $($name::$kind(it) => $name::$kind(it.map(f))),* }
            }
        }

        impl<C: $crate::kernel::calc::Calc> $crate::kernel::group::Group<C> for $name<C> {
            type Over<D: $crate::kernel::calc::Calc> = $name<D>;
            /// Of the kind with the most.
            const SIZE: usize = {
                let sizes = [$($kind::<f64>::SYMBOLS.len()),*];
                let (mut most, mut at) = (0, 0);
                while at < sizes.len() {
                    if sizes[at] > most { most = sizes[at]; }
                    at += 1;
                }
                most
            };
            fn map<D: $crate::kernel::calc::Calc>(&self, f: &mut dyn FnMut($crate::kernel::variable::Quantity, C) -> D) -> $name<D> {
                self.map(&mut |symbol, value| f((symbol, None), value))
            }
            fn take(&self, place: usize) -> C {
                match self { $($name::$kind(it) => it.take(place)),* }
            }
            fn put(&mut self, place: usize, value: C) {
                match self { $($name::$kind(it) => it.put(place, value)),* }
            }
        }
    };
}
pub(crate) use either;

/// Implements [`Group`] by its own `map` for what has some quantities or others: `by_map!(Form: 9)`, of which as many at most.
macro_rules! by_map {
    ($name:ident: $most:expr) => {
        impl<C: $crate::kernel::calc::Calc> $crate::kernel::group::Group<C> for $name<C> {
            type Over<D: $crate::kernel::calc::Calc> = $name<D>;
            const SIZE: usize = $most;
            fn map<D: $crate::kernel::calc::Calc>(
                &self,
                f: &mut dyn FnMut($crate::kernel::variable::Quantity, C) -> D,
            ) -> $name<D> {
                self.map(&mut |symbol, value| f((symbol, None), value))
            }
            fn take(&self, place: usize) -> C {
                let (mut at, mut found) = (0.., None);
                self.map(&mut |_, value| {
                    if at.next() == Some(place) {
                        found = Some(value);
                    }
                });
                found.expect("one of its places")
            }
            fn put(&mut self, place: usize, value: C) {
                let mut at = 0..;
                *self = self.map(&mut |_, old| if at.next() == Some(place) { value } else { old });
            }
        }
    };
}
pub(crate) use by_map;

/// Implements [`Group`] for what is no struct of scalars: a choice of the scene (`group!(Choice)`), or one of several,
/// a number from 1 whatever the scalar (`group!(Mode as s::MODE: from number, to number)`).
macro_rules! group {
    ($name:ty) => {
        impl<C: $crate::kernel::calc::Calc> $crate::kernel::group::Group<C> for $name {
            type Over<D: $crate::kernel::calc::Calc> = $name;
            const SIZE: usize = 0;
            fn map<D: $crate::kernel::calc::Calc>(
                &self,
                _: &mut dyn FnMut($crate::kernel::variable::Quantity, C) -> D,
            ) -> $name {
                self.clone()
            }
            fn take(&self, _: usize) -> C {
                unreachable!("a choice is no number")
            }
            fn put(&mut self, _: usize, _: C) {
                unreachable!("a choice is no number")
            }
        }
    };
    ($name:ty as $symbol:path: $from:expr, $to:expr) => {
        impl<C: $crate::kernel::calc::Calc> $crate::kernel::group::Group<C> for $name {
            type Over<D: $crate::kernel::calc::Calc> = $name;
            const SIZE: usize = 1;
            fn map<D: $crate::kernel::calc::Calc>(
                &self,
                f: &mut dyn FnMut($crate::kernel::variable::Quantity, C) -> D,
            ) -> $name {
                let (from, to): (fn(f64) -> $name, fn($name) -> f64) = ($from, $to);
                from(f((&$symbol, None), C::constant(to(*self))).value())
            }
            fn take(&self, _: usize) -> C {
                let to: fn($name) -> f64 = $to;
                C::constant(to(*self))
            }
            fn put(&mut self, _: usize, value: C) {
                *self = std::convert::identity::<fn(f64) -> $name>($from)(value.value());
            }
        }
    };
}
pub(crate) use group;
