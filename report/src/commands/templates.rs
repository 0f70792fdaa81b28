//! `lemnis templates`: what books are made with.

use std::path::PathBuf;

use clap::Subcommand;
use lemnis::template::originals;

use crate::failure::Failure;
use crate::output::{Output, write};

#[derive(Subcommand)]
pub enum Templates {
    /// Write the built-in templates and words into a folder; keep what you change and use it with --templates
    Export {
        /// Folder to write to; none of the files may exist
        dir: PathBuf,
    },
}

impl Templates {
    /// Writes out everything that `--templates` can override.
    pub fn run(&self) -> Result<(), Failure> {
        let Templates::Export { dir } = self;
        for (name, _) in originals() {
            let path = dir.join(name);
            if path.exists() {
                return Err(Failure::File(format!(
                    "{} exists already and stays as it is; name another folder",
                    path.display()
                )));
            }
        }
        for (name, text) in originals() {
            let path = dir.join(name);
            let name = path.file_name().expect("a file").to_string_lossy().into_owned();
            let bytes = text.as_bytes().to_vec();
            write(path.parent().unwrap_or(dir), &[Output { name, bytes }])?;
        }
        Ok(())
    }
}
