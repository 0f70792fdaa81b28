//! Work that is watched: its progress, and Ctrl-C.

use std::sync::atomic::{AtomicBool, Ordering};

use lemnis_models::kernel::shared::Watch;

use crate::progress::Steps;

/// What a search says of itself: what it does, and what is kept of it.
pub const SEARCHING: [&str; 2] = ["searching", "the best so far"];

/// Set by Ctrl-C.
static STOP: AtomicBool = AtomicBool::new(false);

/// Does something of some `steps` with a progress bar that says what; Ctrl-C keeps what is done, and a second one ends the
/// program.
pub fn watched<T>([does, kept]: [&str; 2], steps: usize, work: impl FnOnce(usize, Watch<'_>) -> T) -> T {
    let handler = ctrlc::set_handler(|| {
        if STOP.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    if let Err(error) = handler {
        eprintln!("warning: Ctrl-C will end the program without a result: {error}");
    }
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let bar = Steps::new(
        &format!("{does} {{wide_bar}} {{percent}} %, Ctrl-C keeps {kept}"),
        steps,
    );
    bar.ended_early(|| STOP.store(true, Ordering::Relaxed));
    let found = work(
        threads,
        Watch {
            stop: &STOP,
            run: &|| bar.step(),
        },
    );
    bar.finish();
    found
}
