//! Of many edits the last one counts: what a newer one has overtaken is not computed.

use std::sync::{Mutex, PoisonError};

/// Pages whose edits are known; those that asked longest ago are forgotten.
const PAGES: usize = 32;

/// The last edit of each page, by numbers that the page gives; the page that asked last comes last.
#[derive(Default)]
pub struct Latest(Mutex<Vec<(u64, u64)>>);

impl Latest {
    pub fn note(&self, page: u64, edit: u64) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let last = known.iter().position(|(known, _)| *known == page);
        let before = last.map_or(0, |place| known.remove(place).1);
        known.push((page, edit.max(before)));
        if known.len() > PAGES {
            known.remove(0);
        }
    }

    pub fn overtaken(&self, page: u64, edit: u64) -> bool {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.iter().any(|(known, last)| *known == page && *last > edit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edit_is_overtaken_by_newer_ones_of_its_page_alone() {
        let latest = Latest::default();
        latest.note(1, 5);
        latest.note(2, 9);
        latest.note(1, 4);
        assert!(
            latest.overtaken(1, 4) && !latest.overtaken(1, 5) && !latest.overtaken(2, 9) && !latest.overtaken(3, 1)
        );
    }

    #[test]
    fn pages_are_forgotten() {
        let latest = Latest::default();
        latest.note(0, 7);
        (1..=PAGES as u64).for_each(|page| latest.note(page, 7));
        assert!(!latest.overtaken(0, 1) && latest.overtaken(1, 1));
        assert_eq!(latest.0.lock().expect("whole").len(), PAGES);
    }
}
