//! Files are made by child processes, the same commands that people type: so they have the same bytes, and one that nobody
//! waits for any more is ended.

use std::io;
use std::process::Stdio;
use std::time::Duration;

use hyper::StatusCode;
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

/// A file of a text, or what is printed of it.
pub async fn file(service: &impl Service, what: &str, text: &str, language: &str) -> Result<Vec<u8>, Refusal> {
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
    let Making { command, file, whole } = service.making(&made).map_err(refused)?;
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
        return Err(refused(words.trim_end().replace(&*scene.to_string_lossy(), "scene")));
    }
    file.map_or(Ok(done.stdout), |path| {
        std::fs::read(path).map_err(|error| failed(&error))
    })
}
