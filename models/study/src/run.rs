//! Many rows on several threads, in their order.

use std::ops::Range;

use lemnis_models::kernel::shared::{Watch, shared};

use crate::rows::{Plan, Row};

/// Rows of a job: some tens of milliseconds.
const BLOCK: usize = 64;
/// Jobs of a thread between which rows are handed on: so many blocks are held.
const JOBS: usize = 8;

/// How often [`run`] calls [`Watch::run`] for some rows.
#[must_use]
pub fn jobs(rows: &Range<usize>) -> usize {
    rows.len().div_ceil(BLOCK)
}

/// Hands on some rows in their order, and ends before the first that is missing where it is broken off.
///
/// # Errors
/// What `take` refuses.
pub fn run<E>(
    plan: &Plan<'_>,
    rows: Range<usize>,
    threads: usize,
    watch: Watch<'_>,
    mut take: impl FnMut(Row) -> Result<(), E>,
) -> Result<(), E> {
    let mut next = rows.start;
    let wave = threads.max(1) * JOBS * BLOCK;
    while next < rows.end && watch.goes_on() {
        let wave = next..(next + wave).min(rows.end);
        let found = shared(jobs(&wave), threads, watch, |job| {
            let start = wave.start + job * BLOCK;
            let block = start..(start + BLOCK).min(wave.end);
            block
                .take_while(|_| watch.goes_on())
                .map(|design| plan.row(design))
                .collect::<Vec<Row>>()
        });
        for row in found.into_iter().flatten() {
            if row.design != next {
                return Ok(());
            }
            take(row)?;
            next += 1;
        }
    }
    Ok(())
}
