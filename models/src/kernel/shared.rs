//! Jobs that threads share, watched by whoever waits for them.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// What jobs tell, and what can break them off.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Set it to have what is done so far.
    pub stop: &'a AtomicBool,
    /// Called after every job.
    pub run: &'a (dyn Fn() + Sync),
}

impl Watch<'_> {
    /// Whether nobody has broken it off.
    #[must_use]
    pub fn goes_on(&self) -> bool {
        !self.stop.load(Ordering::Relaxed)
    }
}

/// Results of `count` jobs in their order, whichever thread did them, the caller's among them. The
/// first job is always done; later ones are left out after a stop.
///
/// # Panics
/// Where a job does.
pub fn shared<T: Send>(count: usize, threads: usize, watch: Watch<'_>, job: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(Vec::new());
    let work = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count || (index > 0 && !watch.goes_on()) {
                return;
            }
            let result = job(index);
            (watch.run)();
            results.lock().expect("no job panics").push((index, result));
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads.min(count) {
            scope.spawn(work);
        }
        work();
    });
    let mut results = results.into_inner().expect("no job panics");
    results.sort_by_key(|&(index, _)| index);
    results.into_iter().map(|(_, result)| result).collect()
}

/// What comes of each of a list, in its order: on all cores, to the end.
///
/// # Panics
/// Where a job does.
pub fn each<T: Send, R: Send>(list: impl IntoIterator<Item = T>, job: impl Fn(T) -> R + Sync) -> Vec<R> {
    let list: Vec<Mutex<Option<T>>> = list.into_iter().map(|one| Mutex::new(Some(one))).collect();
    let watch = Watch {
        stop: &AtomicBool::new(false),
        run: &|| (),
    };
    let threads = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    shared(list.len(), threads, watch, |index| {
        let one = list[index].lock().unwrap_or_else(PoisonError::into_inner).take();
        job(one.expect("each is done once"))
    })
}
