//! What moves in the terminal while something takes longer than a second.

use std::time::Duration;

use indicatif::ProgressBar;

/// How often a spinner turns.
pub const TICK: Duration = Duration::from_millis(100);

/// Turns a spinner while something runs that may take longer than a second; silent where nobody watches.
pub fn busy<T>(message: String, work: impl FnOnce() -> T) -> T {
    let spinner = ProgressBar::new_spinner().with_message(message);
    spinner.enable_steady_tick(TICK);
    let done = work();
    spinner.finish_and_clear();
    done
}
