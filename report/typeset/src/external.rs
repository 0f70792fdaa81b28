//! An installed `typst` command in place of the embedded one.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::fonts;
use crate::typesetter::{Error, Files, Format, Typeset, Typesetter};

/// The oldest version that knows everything that books are made of.
const OLDEST: [u32; 2] = [0, 15];

/// A `typst` command.
#[derive(Debug)]
pub struct External {
    path: PathBuf,
}

impl External {
    /// # Errors
    /// A command that cannot be run, that is not Typst, or that is too old.
    pub fn new(path: &Path) -> Result<External, Error> {
        let name = path.display();
        let done = Command::new(path).arg("--version").output().map_err(|error| {
            Error::new(format!(
                "cannot run {name}: {error}; install Typst or leave --typst away, Lemnis has its own"
            ))
        })?;
        let text = String::from_utf8_lossy(&done.stdout).into_owned();
        let version = version(&text)
            .filter(|_| done.status.success())
            .ok_or_else(|| Error::new(format!("{name} is not Typst: to --version it says \"{}\"", text.trim())))?;
        if version < OLDEST {
            return Err(Error::new(format!(
                "{name} is Typst {}.{}, books need {}.{} or later; update it or leave --typst away, Lemnis has its own",
                version[0], version[1], OLDEST[0], OLDEST[1]
            )));
        }
        Ok(External { path: path.to_owned() })
    }
}

/// Major and minor version of `typst 0.15.1 (hash)`.
fn version(text: &str) -> Option<[u32; 2]> {
    let mut numbers = text.strip_prefix("typst ")?.split(['.', ' ', '-', '\n']);
    Some([numbers.next()?.parse().ok()?, numbers.next()?.parse().ok()?])
}

impl Typesetter for External {
    fn typeset(&self, main: &str, files: &Files, format: Format, standard: Option<&str>) -> Result<Typeset, Error> {
        let unusable = |error: std::io::Error| Error::new(format!("a folder for Typst to work in: {error}"));
        let folder = tempfile::tempdir().map_err(unusable)?;
        let put = |name: &str, bytes: &[u8]| {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap_or(folder.path()))?;
            std::fs::write(path, bytes)
        };
        put("main.typ", main.as_bytes()).map_err(unusable)?;
        for (name, bytes) in files {
            put(name, bytes).map_err(unusable)?;
        }
        for (i, font) in fonts::CHINESE.iter().enumerate() {
            put(&format!("fonts/{i}.otf"), font).map_err(unusable)?;
        }
        let many = matches!(format, Format::Svg | Format::Png);
        let name = |page: &str| folder.path().join(format!("book{page}.{}", format.name()));
        let mut command = Command::new(&self.path);
        // The same fonts and the same time as the embedded Typst: its own, and none.
        command.args(["compile", "--ignore-system-fonts", "--diagnostic-format", "short"]);
        command.args(["--format", format.name(), "--features", "html"]);
        command.arg("--root").arg(folder.path());
        command.arg("--font-path").arg(folder.path().join("fonts"));
        if format == Format::Pdf {
            let standards = ["ua-1"].into_iter().chain(standard).collect::<Vec<_>>();
            command.args(["--pdf-standard", &standards.join(",")]);
        }
        command
            .arg(folder.path().join("main.typ"))
            .arg(name(if many { "-{p}" } else { "" }));
        let done = command
            .output()
            .map_err(|error| Error::new(format!("cannot run {}: {error}", self.path.display())))?;
        if !done.status.success() {
            let text = String::from_utf8_lossy(&done.stderr);
            return Err(Error::new(format!("{}: {}", self.path.display(), text.trim())));
        }
        if !many {
            return Ok(Typeset {
                files: vec![std::fs::read(name("")).map_err(unusable)?],
                places: BTreeMap::new(),
                warnings: Vec::new(),
            });
        }
        // Typst fills the numbers of pages up with zeros to one width.
        let mut paths: Vec<PathBuf> = std::fs::read_dir(folder.path())
            .map_err(unusable)?
            .filter_map(|entry| Some(entry.ok()?.path()))
            .filter(|path| path.extension().is_some_and(|suffix| suffix == format.name()))
            .collect();
        paths.sort_by_key(|path| (path.as_os_str().len(), path.clone()));
        let files: Result<Vec<_>, _> = paths.iter().map(std::fs::read).collect();
        Ok(Typeset {
            files: files.map_err(unusable)?,
            places: BTreeMap::new(),
            warnings: Vec::new(),
        })
    }
}

#[cfg(unix)]
#[cfg(test)]
mod tests {
    use std::os::unix::fs::PermissionsExt;
    use std::sync::{Mutex, PoisonError};

    use super::*;

    /// A script that is open for writing while another test starts a process cannot be run: one test at a time.
    static ALONE: Mutex<()> = Mutex::new(());

    /// A command that answers as `typst` would.
    fn script(folder: &Path, text: &str) -> PathBuf {
        let path = folder.join("typst");
        std::fs::write(&path, format!("#!/bin/sh\n{text}\n")).expect("writable");
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).expect("ours");
        path
    }

    #[test]
    fn absent_foreign_and_old_commands_are_refused() {
        let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        let folder = tempfile::tempdir().expect("a folder");
        let message = |path: &Path| External::new(path).expect_err("refused").message;
        assert!(message(&folder.path().join("nothing")).contains("cannot run"));
        assert!(message(&script(folder.path(), "echo make 4.3")).contains("is not Typst"));
        let old = message(&script(folder.path(), "echo 'typst 0.13.1 (8ace67d9)'"));
        assert!(old.contains("is Typst 0.13, books need 0.15 or later"), "{old}");
        assert!(External::new(&script(folder.path(), "echo 'typst 0.15.0'")).is_ok());
        assert!(External::new(&script(folder.path(), "echo 'typst 1.0.0-rc1'")).is_ok());
    }

    /// The command gets the source, and its pages come back in their order.
    #[test]
    fn pages_and_complaints_of_the_command_come_back() {
        let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        let folder = tempfile::tempdir().expect("a folder");
        let pages = "[ $1 = --version ] && echo 'typst 0.15.1' && exit\n\
                     for last; do :; done\nd=$(dirname $last)\n\
                     for n in 1 2 10; do echo page $n of $(cat $d/main.typ) > $d/book-$n.svg; done";
        let typst = External::new(&script(folder.path(), pages)).expect("new enough");
        let made = typst.typeset("text", &[], Format::Svg, None).expect("pages").files;
        assert_eq!(made, [1, 2, 10].map(|n| format!("page {n} of text\n").into_bytes()));
        let fails = "[ $1 = --version ] && echo 'typst 0.15.1' && exit\necho 'main.typ:1:1: error: no' >&2; exit 1";
        let typst = External::new(&script(folder.path(), fails)).expect("new enough");
        let error = typst
            .typeset("text", &[], Format::Pdf, Some("a-3b"))
            .expect_err("fails");
        assert!(error.message.ends_with("main.typ:1:1: error: no"), "{error}");
    }
}
