//! Why the program ends early, and with which exit code.

use lemnis_models::kernel::variable::Fault;

/// A failure in words for the user.
#[derive(Debug)]
pub enum Failure {
    /// The scene is wrong.
    Scene(String),
    /// A file cannot be read or written.
    File(String),
    /// A limit that the scene sets is not kept.
    Limit(String),
    /// A template is wrong, or the FMU's library is missing.
    Program(String),
    /// Another process that did part of the work ended with this code, where it has one, and these words.
    Process(Option<u8>, String),
}

impl Failure {
    /// A model that cannot be built is the scene's mistake.
    pub fn of_scene(fault: Fault) -> Failure {
        Failure::Scene(fault.message)
    }

    /// Exit code; 2 is clap's, for a wrong command line.
    pub fn code(&self) -> u8 {
        match self {
            Failure::Scene(_) => 1,
            Failure::File(_) => 3,
            Failure::Limit(_) => 4,
            Failure::Program(_) => 5,
            Failure::Process(code, _) => code.unwrap_or(5),
        }
    }
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Failure::Scene(text) | Failure::Process(Some(_), text) => f.write_str(text),
            Failure::Process(None, text) => {
                write!(f, "error: a process that made books was ended from outside; {text}")
            }
            Failure::File(text) | Failure::Limit(text) | Failure::Program(text) => write!(f, "error: {text}"),
        }
    }
}
