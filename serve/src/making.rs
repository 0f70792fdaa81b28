//! Files and books are made by child processes, the same commands that people type: so they have the same bytes, and one that
//! nobody waits for any more is ended.

use std::io;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

use hyper::StatusCode;
use tokio::process::Command;

use crate::guard::Refusal;
use crate::{Made, Making, Service};

/// How long a command may take.
const LONGEST: Duration = Duration::from_secs(300);

fn failed(error: &io::Error) -> Refusal {
    Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, format!("cannot make it: {error}"))
}

/// A file of a text, or what is printed of it.
pub async fn file(service: &impl Service, what: &str, text: &str, language: &str) -> Result<Vec<u8>, Refusal> {
    run(service, what, text, [language, ""], |printed, file, _| match file {
        Some(path) => std::fs::read(path),
        None => Ok(printed),
    })
    .await
}

/// The pages of a text's book, in their order.
pub async fn pages(service: &impl Service, text: &str, language: &str, level: &str) -> Result<Vec<Vec<u8>>, Refusal> {
    run(service, "pages", text, [language, level], |_, _, folder| {
        let entries = std::fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
        let mut paths = entries.collect::<io::Result<Vec<_>>>()?;
        paths.sort();
        paths.iter().map(std::fs::read).collect()
    })
    .await
}

/// Runs a command on a text; `taken` gives what is wanted of what it prints, of its file and of its folder.
async fn run<T>(
    service: &impl Service,
    what: &str,
    text: &str,
    [language, level]: [&str; 2],
    taken: impl FnOnce(Vec<u8>, Option<&Path>, &Path) -> io::Result<T>,
) -> Result<T, Refusal> {
    let place = tempfile::tempdir().map_err(|error| failed(&error))?;
    let [scene, folder] = ["scene.toml", "made"].map(|name| place.path().join(name));
    let prepared = std::fs::write(&scene, text).and_then(|()| std::fs::create_dir(&folder));
    prepared.map_err(|error| failed(&error))?;
    let refused = |words: String| Refusal::new(StatusCode::UNPROCESSABLE_ENTITY, words);
    let made = Made {
        what,
        text,
        language,
        level,
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
    taken(done.stdout, file.as_deref(), &folder).map_err(|error| failed(&error))
}
