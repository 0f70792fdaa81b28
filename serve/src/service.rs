//! What must be known of scenes; and how texts are told apart.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Serialize;

/// What is known of scenes; every answer is JSON.
pub trait Service: Send + Sync + 'static {
    /// What the page needs before all else: words, languages, scenes.
    fn start(&self) -> String;
    /// What a text gives; without runs in time, which take the longest, where it is asked of it at rest.
    fn answer(&self, text: &str, language: &str, at_rest: bool) -> String;
    /// How a text moves in time, frame by frame.
    fn runs(&self, text: &str, language: &str) -> String;
    /// What may be written at a code unit of UTF-16.
    fn complete(&self, text: &str, at: usize, language: &str) -> String;
    /// What stands at a code unit of UTF-16.
    fn hover(&self, text: &str, at: usize, language: &str) -> String;
    /// The ready scenes.
    fn gallery(&self, language: &str) -> String;
    /// A scene by its id.
    ///
    /// # Errors
    /// There is none, or it cannot be read; in words for the user.
    fn open(&self, scene: &str) -> Result<Opened, String>;
    /// Puts a text in the place of one of which this was the hash; the new hash.
    ///
    /// # Errors
    /// It may not be written, or is not what it was; in words for the user.
    fn save(&self, scene: &str, text: &str, hash: &str) -> Result<String, String>;
    /// The command that makes a file of a text.
    ///
    /// # Errors
    /// The text is no scene, or nothing is called so.
    fn making(&self, made: &Made<'_>) -> Result<Making, String>;
    /// The command that answers each [`Wanted`](crate::books::Wanted) with a [`Book`](crate::books::Book), a line each.
    fn books(&self) -> Command;
}

/// A scene that was opened.
#[derive(Debug, Serialize)]
pub struct Opened {
    pub text: String,
    /// Of the text as it is on disk.
    pub hash: String,
    /// What it is called: a file, or the name of a ready scene.
    pub called: String,
    /// Whether it may be saved.
    pub writable: bool,
}

/// What is to be made.
#[derive(Debug)]
pub struct Made<'a> {
    pub what: &'a str,
    pub text: &'a str,
    pub language: &'a str,
    /// The file that has the text.
    pub scene: &'a Path,
    /// Where the command may write.
    pub folder: &'a Path,
}

/// A command and what comes of it.
#[derive(Debug)]
pub struct Making {
    pub command: Command,
    /// The file that it writes; otherwise what it prints.
    pub file: Option<PathBuf>,
    /// Exit codes besides 0 with which it is whole.
    pub whole: &'static [i32],
}

/// By which a text on disk is known.
#[must_use]
pub fn hash(bytes: &[u8]) -> String {
    use sha2::Digest;
    hex(&sha2::Sha256::digest(bytes))
}

/// Bytes as digits.
#[must_use]
pub fn hex(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let both = |byte: &u8| [byte >> 4, byte & 15].map(|digit| char::from(DIGITS[usize::from(digit)]));
    bytes.iter().flat_map(both).collect()
}
