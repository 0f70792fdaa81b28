//! Errors in a scene, with their place in its text.

use std::ops::Range;

/// A change of a scene's text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// Bytes of the scene's text.
    pub replaced: Range<usize>,
    /// What takes their place.
    pub text: String,
    /// Where in `text` one goes on writing, in bytes.
    pub caret: usize,
}

impl Edit {
    /// After which one goes on behind the new text.
    #[must_use]
    pub fn new(replaced: Range<usize>, text: impl Into<String>) -> Edit {
        let text = text.into();
        let caret = text.len();
        Edit { replaced, text, caret }
    }
}

/// One thing wrong in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong: the quantity, its value, what is allowed.
    pub message: String,
    /// What stands at the marked place.
    pub label: String,
    /// What to do.
    pub help: Option<String>,
    /// What the help says, done; boxed, as most of what is wrong has none.
    pub fix: Option<Box<Edit>>,
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
            fix: None,
            span,
        }
    }

    #[must_use]
    #[cold]
    pub fn help(mut self, text: impl Into<String>) -> Diagnostic {
        self.help = Some(text.into());
        self
    }

    #[must_use]
    #[cold]
    pub fn fix(mut self, edit: impl Into<Option<Edit>>) -> Diagnostic {
        self.fix = edit.into().map(Box::new);
        self
    }
}

impl std::fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)?;
        self.help.iter().try_for_each(|help| write!(f, "; {help}"))
    }
}
