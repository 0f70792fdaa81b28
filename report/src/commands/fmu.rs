//! `lemnis fmu`: a scene as FMUs of both versions.

use std::path::{Path, PathBuf};

use clap::Args;
use lemnis_fmu::description::Standard;
use lemnis_fmu::package::{self, Library};
use lemnis_models::scene::Scene;

use crate::decision::to_build;
use crate::failure::Failure;
use crate::output::{Output, write};

#[derive(Args)]
pub struct Make {
    /// Scene file, - for the standard input [default: the embedded scene]
    pub scene: Option<PathBuf>,
    /// Folder for the results
    #[arg(short, long, default_value = "out")]
    pub output: PathBuf,
}

#[derive(Args)]
pub struct Pack {
    #[command(flatten)]
    pub make: Make,
    /// Folder with the FMU's libraries of several platforms, made by fmu/platforms.py [default: this platform's alone]
    #[arg(long, value_name = "FOLDER")]
    pub platforms: Option<PathBuf>,
}

impl Pack {
    pub fn run(&self) -> Result<(), Failure> {
        let scene = to_build(self.make.scene.as_deref())?.announced()?;
        let documentation = documentation(&scene, None)?;
        write(
            &self.make.output,
            &fmus(&scene, self.platforms.as_deref(), &documentation)?,
        )
    }
}

/// What lies in an FMU's `documentation/`: its first page and, if there is one, the book.
pub fn documentation(scene: &Scene, book: Option<&Output>) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let page = lemnis::documentation::page(scene, book.map(|book| book.name.as_str()));
    let page = page.map_err(|error| Failure::Program(error.to_string()))?;
    let mut files = vec![("index.html".to_owned(), page.into_bytes())];
    files.extend(book.map(|book| (book.name.clone(), book.bytes.clone())));
    Ok(files)
}

/// Both FMUs, each packed in a thread of its own.
pub fn fmus(
    scene: &Scene,
    platforms: Option<&Path>,
    documentation: &[(String, Vec<u8>)],
) -> Result<Vec<Output>, Failure> {
    let libraries = match platforms {
        None => vec![Library::of_this_platform().map_err(|fault| Failure::Program(fault.message))?],
        Some(folder) => Library::of_platforms(folder).map_err(|fault| Failure::File(fault.message))?,
    };
    let make = |standard, suffix: &str| {
        let bytes = package::fmu(scene, standard, &libraries, documentation);
        let bytes = bytes.map_err(|fault| Failure::Program(fault.message))?;
        Ok(Output {
            name: format!("{}{suffix}", scene.name()),
            bytes,
        })
    };
    std::thread::scope(|scope| {
        let fmi2 = scope.spawn(|| make(Standard::Fmi2, ".fmi2.fmu"));
        let fmi3 = make(Standard::Fmi3, ".fmu")?;
        Ok(vec![fmi3, fmi2.join().expect("packing does not panic")?])
    })
}
