//! A chapter of motion with what it adds to the rest of a book.

use crate::component::sheet::{Check, InMotion, Sheet, Warning};
use crate::kernel::symbol::Symbol;

/// The chapter of what moves, what is judged in it and what is warned of.
pub struct Moved {
    pub chapter: InMotion,
    pub requirements: Vec<Check>,
    pub unjudged: Vec<&'static Symbol>,
    pub identities: Vec<Check>,
    pub warnings: Vec<Warning>,
}

impl Moved {
    /// Puts all into a sheet, whose forces at rest stand beside those in motion.
    pub(crate) fn tell(self, sheet: &mut Sheet) {
        let mut chapter = self.chapter;
        for row in chapter.envelope.iter_mut().filter(|row| row.still.is_none()) {
            row.still = sheet.forces.iter().find(|ends| ends[0].symbol == row.symbol).copied();
        }
        sheet.requirements.extend(self.requirements);
        sheet.unjudged.extend(self.unjudged);
        sheet.identities.extend(self.identities);
        sheet.warnings.extend(self.warnings);
        sheet.motion = Some(chapter);
    }
}
