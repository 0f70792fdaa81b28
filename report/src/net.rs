//! A net under the program: what panics is the program's mistake, told in one line that asks for a report.

use std::any::Any;
use std::panic::{self, AssertUnwindSafe};
use std::sync::OnceLock;

/// Exit code of a mistake of the program itself.
pub const CODE: u8 = 6;

/// The first panic of all threads: others follow from it.
static FIRST: OnceLock<String> = OnceLock::new();

/// Runs a command, whose words name the scene; where it panics, the line to be printed.
pub fn under<T>(words: impl IntoIterator<Item = String>, run: impl FnOnce() -> T) -> Result<T, String> {
    panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(ToString::to_string).unwrap_or_default();
        // The first one is kept.
        let _ = FIRST.set(format!("{place}: {}", said(panic.payload())));
    }));
    panic::catch_unwind(AssertUnwindSafe(run)).map_err(|_| {
        let words: Vec<String> = words.into_iter().collect();
        let what = FIRST.get().map_or("", String::as_str);
        let line = format!(
            "error: a mistake of the program itself, not of the scene; no file is left half written: please report this line, with \
             the scene, of {}: {what}",
            words.join(" ")
        );
        line.split_whitespace().collect::<Vec<_>>().join(" ")
    })
}

fn said(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On whatever thread, the first panic is told, in one line and with the scene.
    #[test]
    fn a_panic_is_one_line_that_names_the_scene() {
        let words = ["lemnis", "build", "crane.toml"].map(str::to_owned);
        assert_eq!(under(words.clone(), || 7), Ok(7));
        let line = under(words, || {
            let other = std::thread::spawn(|| panic!("no pose\nat 20 deg"));
            other.join().expect("the other one's fault");
        });
        let line = line.expect_err("panicked");
        assert!(
            line.contains("please report") && line.contains("lemnis build crane.toml"),
            "{line}"
        );
        assert!(
            line.contains("net.rs:") && line.ends_with("no pose at 20 deg"),
            "{line}"
        );
        assert_eq!(line.lines().count(), 1);
    }
}
