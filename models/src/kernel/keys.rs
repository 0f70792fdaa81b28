//! Tables of quantities in a scene, as data.

use crate::kernel::schema::Key;

/// Where one quantity comes from.
pub(super) const NOTE: Key = Key::text(
    "source",
    "Where the quantity comes from: a drawing, a publication, an assumption.",
);

/// The keys of a table: quantities by the names of their symbols, with what each may be, then other keys and where all
/// of them come from: `keys! { s: E_X, S_K > 0, H_Q >= 0, C_V >= 0 [optional], ETA_L > 0 [usually(1.0)]; OTHER }`. Marks
/// are methods of [`Key`](crate::kernel::schema::Key).
macro_rules! keys {
    ($table:ident: $($name:ident $(> $above:tt)? $(>= $least:tt)? $([$($mark:ident $(($value:expr))?),*])?),*
     $(; $($other:expr),+)?) => {
        &[
            $($crate::kernel::schema::Key::quantity(
                &$table::$name,
                $crate::kernel::keys::keys!(@sign $(> $above)? $(>= $least)?),
            )$($(.$mark($($value)?))*)?,)*
            $($($other,)+)?
            $crate::kernel::schema::SOURCE,
        ]
    };
    (@sign) => { $crate::kernel::sign::Sign::Any };
    (@sign > 0) => { $crate::kernel::sign::Sign::Positive };
    (@sign >= 0) => { $crate::kernel::sign::Sign::NotNegative };
}
pub(crate) use keys;
