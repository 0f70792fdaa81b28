//! Errors in a scene, with their place in its text.

use std::ops::Range;

/// One thing wrong in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong: the quantity, its value, what is allowed.
    pub message: String,
    /// What stands at the marked place.
    pub label: String,
    /// What to do.
    pub help: Option<String>,
    /// Bytes of the scene's text.
    pub span: Range<usize>,
}

impl Diagnostic {
    #[must_use]
    #[cold]
    pub fn new(span: Range<usize>, message: impl Into<String>, label: impl Into<String>) -> Diagnostic {
        Diagnostic {
            message: message.into(),
            label: label.into(),
            help: None,
            span,
        }
    }

    #[must_use]
    #[cold]
    pub fn help(mut self, text: impl Into<String>) -> Diagnostic {
        self.help = Some(text.into());
        self
    }
}

impl std::fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)?;
        self.help.iter().try_for_each(|help| write!(f, "; {help}"))
    }
}
