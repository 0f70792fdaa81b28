//! A search that is watched: its progress, and Ctrl-C.

use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::{ProgressBar, ProgressStyle};
use lemnis_synthesis::optimum::Watch;

/// Set by Ctrl-C.
static STOP: AtomicBool = AtomicBool::new(false);

/// Runs a search of some `steps` with a progress bar; Ctrl-C keeps the best so far, and a second one ends the program.
pub fn watched<T>(steps: usize, search: impl FnOnce(usize, Watch<'_>) -> T) -> T {
    let handler = ctrlc::set_handler(|| {
        if STOP.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    if let Err(error) = handler {
        eprintln!("warning: Ctrl-C will end the search without a result: {error}");
    }
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let style = ProgressStyle::with_template("searching {wide_bar} {percent} %, Ctrl-C keeps the best so far");
    let bar = ProgressBar::new(steps as u64).with_style(style.expect("a template"));
    let found = search(
        threads,
        Watch {
            stop: &STOP,
            run: &|| bar.inc(1),
        },
    );
    bar.finish_and_clear();
    found
}
