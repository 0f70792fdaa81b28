//! `lemnis new`: a scene to start from.

use std::path::{Path, PathBuf};

use clap::Args;
use lemnis_models::scene::DEFAULT;

use crate::failure::Failure;
use crate::output::{Output, say, write};

#[derive(Args)]
pub struct New {
    /// File to write; it must not exist
    #[arg(default_value = "scene.toml")]
    file: PathBuf,
}

impl New {
    pub fn run(&self) -> Result<(), Failure> {
        let file = &self.file;
        if file.exists() {
            return Err(Failure::File(format!(
                "{} exists already and stays as it is; name another file",
                file.display()
            )));
        }
        let Some(name) = file.file_name() else {
            return Err(Failure::File(format!(
                "{} cannot be the name of a scene file",
                file.display()
            )));
        };
        let folder = file
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty())
            .unwrap_or(Path::new("."));
        write(
            folder,
            &[Output {
                name: name.to_string_lossy().into_owned(),
                bytes: DEFAULT.into(),
            }],
        )?;
        say(format_args!("  build it with `lemnis build {}`", file.display()))
    }
}
