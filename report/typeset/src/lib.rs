//! Typst in memory: source and files in, PDF, SVG, PNG or HTML out. No disk,
//! no packages, no date: the same input gives the same bytes everywhere. Only
//! for characters that the embedded fonts lack are the system's fonts asked.
//! [`External`] does the same with an installed `typst`.

mod attachment;
mod embedded;
mod external;
mod fonts;
mod ink;
mod settled;
mod typesetter;

pub use crate::attachment::attached;
pub use crate::embedded::Embedded;
pub use crate::external::External;
pub use crate::ink::{Ink, Mark, ink};
pub use crate::typesetter::{Error, Files, Format, Typeset, Typesetter};
