//! Files are made by child processes, the same commands that people type: so they have the same bytes, and one that nobody
//! waits for any more is ended.

use std::io;
use std::path::PathBuf;
use std::process::Stdio;
use std::time::Duration;

use hyper::StatusCode;
use tempfile::TempDir;
use tokio::process::Command;

use crate::guard::Refusal;
use crate::service::{Made, Making, Service};

/// How long a command may take.
pub const LONGEST: Duration = Duration::from_secs(300);

pub fn failed(error: &io::Error) -> Refusal {
    Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, format!("cannot make it: {error}"))
}

pub fn refused(words: String) -> Refusal {
    Refusal::new(StatusCode::UNPROCESSABLE_ENTITY, words)
}

/// A folder of its own for a command: with the scene, and with a place for what it writes.
pub struct Workplace {
    _place: TempDir,
    scene: PathBuf,
    pub folder: PathBuf,
}

impl Workplace {
    /// What a command says, without the names of this place; lines about what it has written there are left out.
    pub fn said(&self, words: &str) -> String {
        let (scene, folder) = (self.scene.to_string_lossy(), self.folder.to_string_lossy());
        let lines = words.lines().filter(|line| !line.contains(&*folder));
        let lines: Vec<String> = lines.map(|line| line.replace(&*scene, "scene")).collect();
        lines.join("\n").trim_end().to_owned()
    }
}

/// The command that makes something of a text, and where.
pub fn prepared(
    service: &impl Service,
    what: &str,
    text: &str,
    language: &str,
) -> Result<(Making, Workplace), Refusal> {
    let place = tempfile::tempdir().map_err(|error| failed(&error))?;
    let [scene, folder] = ["scene.toml", "made"].map(|name| place.path().join(name));
    let prepared = std::fs::write(&scene, text).and_then(|()| std::fs::create_dir(&folder));
    prepared.map_err(|error| failed(&error))?;
    let made = Made {
        what,
        text,
        language,
        scene: &scene,
        folder: &folder,
    };
    let making = service.making(&made).map_err(refused)?;
    let place = Workplace {
        _place: place,
        scene,
        folder,
    };
    Ok((making, place))
}

/// A file of a text, or what is printed of it.
pub async fn file(service: &impl Service, what: &str, text: &str, language: &str) -> Result<Vec<u8>, Refusal> {
    let (Making { command, file, whole }, place) = prepared(service, what, text, language)?;
    let mut command = Command::from(command);
    command.stdin(Stdio::null()).kill_on_drop(true);
    let Ok(done) = tokio::time::timeout(LONGEST, command.output()).await else {
        return Err(refused(format!("ended after {} s", LONGEST.as_secs())));
    };
    let done = done.map_err(|error| failed(&error))?;
    if !done
        .status
        .code()
        .is_some_and(|code| code == 0 || whole.contains(&code))
    {
        let words = String::from_utf8_lossy(&done.stderr);
        return Err(refused(place.said(&words)));
    }
    file.map_or(Ok(done.stdout), |path| {
        std::fs::read(path).map_err(|error| failed(&error))
    })
}
