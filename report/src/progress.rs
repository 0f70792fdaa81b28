//! What moves in the terminal while something takes longer than a second; or, where another program watches, what it is
//! told.

use std::io::Read;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// How often a spinner turns.
const TICK: Duration = Duration::from_millis(100);

/// Set by a program that watches: it reads a percentage a line on the standard error, and closes the standard input to
/// have what is done so far.
pub const WATCHED: &str = "LEMNIS_WATCHED";

/// Turns a spinner while something runs that may take longer than a second; silent where nobody watches.
pub fn busy<T>(message: String, work: impl FnOnce() -> T) -> T {
    let spinner = ProgressBar::new_spinner().with_message(message);
    spinner.enable_steady_tick(TICK);
    let done = work();
    spinner.finish_and_clear();
    done
}

/// Work of so many steps.
pub struct Steps {
    bar: ProgressBar,
    all: u64,
    done: AtomicU64,
    watched: bool,
}

impl Steps {
    /// With a bar in this style.
    pub fn new(style: &str, steps: usize) -> Steps {
        let style = ProgressStyle::with_template(style).expect("a template");
        let bar = ProgressBar::new(steps as u64).with_style(style);
        bar.enable_steady_tick(TICK);
        Steps {
            bar,
            all: steps as u64,
            done: AtomicU64::new(0),
            watched: std::env::var_os(WATCHED).is_some(),
        }
    }

    /// One more is done.
    pub fn step(&self) {
        self.bar.inc(1);
        let before = self.done.fetch_add(1, Ordering::Relaxed);
        let [before, now] = [before, before + 1].map(|done| 100 * done / self.all.max(1));
        if self.watched && before != now {
            eprintln!("{now} %");
        }
    }

    /// Calls when the program that watches wants no more.
    pub fn ended_early(&self, end: impl FnOnce() + Send + 'static) {
        if self.watched {
            std::thread::spawn(|| {
                let _ = std::io::stdin().read_to_end(&mut Vec::new());
                end();
            });
        }
    }

    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}
