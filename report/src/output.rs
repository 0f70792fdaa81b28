//! Writing files whole or not at all, and to the terminal.

use std::ffi::OsString;
use std::fmt::Display;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempDir, TempPath};

use crate::failure::Failure;

/// A file to be.
#[derive(Debug)]
pub struct Output {
    pub name: String,
    pub bytes: Vec<u8>,
}

/// Files that are complete under temporary names, each with its place. Dropped, they are gone, and so is a folder that
/// they are in.
pub struct Complete {
    files: Vec<(TempPath, PathBuf)>,
    _folder: Option<TempDir>,
}

fn cannot(what: &Path, error: &dyn Display) -> Failure {
    Failure::File(format!(
        "cannot write {}: {error}; nothing was changed, choose another folder with --output",
        what.display()
    ))
}

/// Writes files into a folder, made where it is missing, under temporary names.
pub fn complete(folder: &Path, outputs: &[Output]) -> Result<Complete, Failure> {
    std::fs::create_dir_all(folder).map_err(|error| cannot(folder, &error))?;
    let one = |output: &Output| {
        let path = folder.join(&output.name);
        let written = NamedTempFile::new_in(folder).and_then(|mut file| {
            file.write_all(&output.bytes)?;
            file.as_file().sync_all()?;
            open_to_all(&file)?;
            Ok(file.into_temp_path())
        });
        Ok((written.map_err(|error| cannot(&path, &error))?, path))
    };
    let files = outputs.iter().map(one).collect::<Result<_, _>>()?;
    Ok(Complete { files, _folder: None })
}

/// Lets complete files take their places. All are complete before the first
/// does, so that a failure leaves what was there.
pub fn place(files: impl IntoIterator<Item = Complete>) -> Result<(), Failure> {
    for complete in files {
        for (file, path) in complete.files {
            file.persist(&path)
                .map_err(|error| Failure::File(format!("cannot replace {}: {}", path.display(), error.error)))?;
            say(format_args!("  wrote {}", path.display()))?;
        }
    }
    Ok(())
}

/// A folder of its own within the one for results, where another process writes; dropped, it is gone.
pub fn workshop(folder: &Path) -> Result<TempDir, Failure> {
    let made = std::fs::create_dir_all(folder).and_then(|()| TempDir::new_in(folder));
    made.map_err(|error| cannot(folder, &error))
}

/// Everything that others wrote into a folder of their own.
pub fn gather(from: TempDir, folder: &Path) -> Result<Complete, Failure> {
    let unreadable = |error| cannot(from.path(), &error);
    let mut names = Vec::new();
    for entry in std::fs::read_dir(from.path()).map_err(unreadable)? {
        names.push(entry.map_err(unreadable)?.file_name());
    }
    names.sort_unstable();
    let one = |name: OsString| {
        let written = TempPath::try_from_path(from.path().join(&name)).map_err(unreadable)?;
        Ok((written, folder.join(name)))
    };
    let files = names.into_iter().map(one).collect::<Result<_, _>>()?;
    Ok(Complete {
        files,
        _folder: Some(from),
    })
}

/// Writes all files into a folder, or changes nothing.
pub fn write(folder: &Path, outputs: &[Output]) -> Result<(), Failure> {
    place([complete(folder, outputs)?])
}

/// A line for the terminal, or for whoever reads there. One that has read enough, as `head` does, is no failure.
pub fn say(line: impl Display) -> Result<(), Failure> {
    match writeln!(std::io::stdout(), "{line}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::File(format!("cannot write to the standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Temporary files are readable by their owner alone; results are ordinary files.
#[cfg(unix)]
fn open_to_all(file: &NamedTempFile) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.as_file().set_permissions(std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn open_to_all(_: &NamedTempFile) -> std::io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn output(name: &str, text: &str) -> Output {
        Output {
            name: name.to_owned(),
            bytes: text.as_bytes().to_vec(),
        }
    }

    /// The second file cannot take its place, because a folder is there: the
    /// folder stays, and no temporary file is left behind.
    #[test]
    fn a_failure_leaves_no_debris() {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::create_dir_all(folder.path().join("b/full")).expect("a folder in the way");
        let failure = write(folder.path(), &[output("a", "new"), output("b", "new")]).expect_err("b is a folder");
        assert_eq!(failure.code(), 3);
        let left: Vec<_> = std::fs::read_dir(folder.path())
            .expect("readable")
            .map(|e| e.expect("entry").file_name())
            .collect();
        assert!(left.len() <= 2 && folder.path().join("b/full").is_dir(), "{left:?}");
    }

    #[test]
    fn an_old_file_is_replaced_whole() {
        let folder = tempfile::tempdir().expect("a folder");
        write(folder.path(), &[output("a", "old and long")]).expect("writes");
        write(folder.path(), &[output("a", "new")]).expect("writes");
        assert_eq!(std::fs::read_to_string(folder.path().join("a")).expect("there"), "new");
    }
}
