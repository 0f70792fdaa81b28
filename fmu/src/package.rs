//! The .fmu file: description, shared libraries, scene and documentation in one
//! zip, the same bytes for the same content.

use crate::description::{Standard, model_description, terminals_and_icons};
use crate::instance::SCENE_FILE;
use crate::refuse;
use lemnis_models::kernel::variable::Fault;
use lemnis_models::scene::Scene;
use std::collections::BTreeMap;
use std::env::consts::{ARCH, DLL_PREFIX, DLL_SUFFIX, OS};
use std::fs;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

const ICON_PNG: &[u8] = include_bytes!("../icon/icon.png");
const ICON_SVG: &[u8] = include_bytes!("../icon/icon.svg");

/// The standard's first page of licences, and the two that it names.
const LICENSES: [(&str, &[u8]); 3] = [
    (
        "license",
        b"SPDX-License-Identifier: MIT OR Apache-2.0\n\n\
          The shared library of this FMU may be used under either licence:\n\
          LICENSE-MIT.txt or LICENSE-APACHE.txt.\n",
    ),
    ("LICENSE-MIT", include_bytes!("../../LICENSE-MIT")),
    ("LICENSE-APACHE", include_bytes!("../../LICENSE-APACHE")),
];

/// The first half of a platform's name in FMI 3.
const ARCHITECTURES: [&str; 8] = [
    "aarch32", "aarch64", "ppc32", "ppc64", "riscv32", "riscv64", "x86", "x86_64",
];
/// The second half, with what a shared library's name begins and ends with there.
const SYSTEMS: [(&str, [&str; 2]); 3] = [
    ("darwin", ["lib", ".dylib"]),
    ("linux", ["lib", ".so"]),
    ("windows", ["", ".dll"]),
];

/// The shared library of one platform.
#[derive(Clone, Debug)]
pub struct Library {
    /// Platform as FMI 3 has it: `x86_64-linux`.
    pub platform: String,
    /// `.so`, `.dll` or `.dylib`.
    pub suffix: String,
    pub bytes: Vec<u8>,
}

impl Library {
    /// The library of this machine's platform, from where [`find_library`] finds it.
    ///
    /// # Errors
    /// There is none, or it cannot be read.
    pub fn of_this_platform() -> Result<Library, Fault> {
        let path = find_library()?;
        let system = if OS == "macos" { "darwin" } else { OS };
        Ok(Library {
            platform: format!("{ARCH}-{system}"),
            suffix: DLL_SUFFIX.to_owned(),
            bytes: fs::read(&path).map_err(|error| unreadable(&path, &error))?,
        })
    }

    /// The libraries of all platforms in a folder, as `fmu/platforms.py` lays it out: one folder for
    /// each platform under its FMI 3 name, `x86_64-linux/liblemnis_fmu.so`, in ascending order.
    ///
    /// # Errors
    /// The folder cannot be read or is empty, or something in it is not a platform with its library.
    pub fn of_platforms(folder: &Path) -> Result<Vec<Library>, Fault> {
        let entries = fs::read_dir(folder).and_then(Iterator::collect::<std::io::Result<Vec<_>>>);
        let mut entries = entries.map_err(|error| unreadable(folder, &error))?;
        entries.sort_by_key(fs::DirEntry::file_name);
        if entries.is_empty() {
            return refuse(format!(
                "{} is empty: put one folder for each platform there, for example x86_64-linux with liblemnis_fmu.so",
                folder.display()
            ));
        }
        let library = |entry: fs::DirEntry| {
            let platform = entry.file_name().to_string_lossy().into_owned();
            let [prefix, suffix] = platform
                .split_once('-')
                .filter(|(architecture, _)| ARCHITECTURES.contains(architecture))
                .and_then(|(_, system)| Some(SYSTEMS.iter().find(|known| known.0 == system)?.1))
                .ok_or_else(|| {
                    Fault::new(format!(
                        "{} is not a platform of FMI 3: use one of the architectures {} and one of the systems {}, \
                         for example x86_64-linux",
                        entry.path().display(),
                        ARCHITECTURES.join(", "),
                        SYSTEMS.map(|known| known.0).join(", ")
                    ))
                })?;
            let path = entry.path().join(format!("{prefix}lemnis_fmu{suffix}"));
            Ok(Library {
                platform,
                suffix: suffix.to_owned(),
                bytes: fs::read(&path).map_err(|error| unreadable(&path, &error))?,
            })
        };
        entries.into_iter().map(library).collect()
    }

    /// The folder in `binaries/`. FMI 2 names three platforms, the others go by their FMI 3 names.
    fn folder(&self, standard: Standard) -> &str {
        match (standard, self.platform.as_str()) {
            (Standard::Fmi2, "x86_64-linux") => "linux64",
            (Standard::Fmi2, "x86_64-windows") => "win64",
            (Standard::Fmi2, "x86_64-darwin") => "darwin64",
            (_, platform) => platform,
        }
    }
}

/// The bytes of an FMU. `documentation` holds paths below `documentation/`, with forward slashes.
///
/// # Errors
/// The scene's model cannot be built, or a file is too large for a zip.
pub fn fmu(
    scene: &Scene,
    standard: Standard,
    libraries: &[Library],
    documentation: &[(String, Vec<u8>)],
) -> Result<Vec<u8>, Fault> {
    let description = model_description(scene, standard)?;
    let terminals = terminals_and_icons(scene)?;
    let mut files = BTreeMap::from([
        ("modelDescription.xml".to_owned(), description.as_slice()),
        (format!("resources/{SCENE_FILE}"), scene.text().as_bytes()),
    ]);
    files.extend(LICENSES.map(|(name, text)| (format!("documentation/licenses/{name}.txt"), text)));
    files.extend(
        [
            ("terminalsAndIcons.xml", terminals.as_slice()),
            ("icon.png", ICON_PNG),
            ("icon.svg", ICON_SVG),
        ]
        .map(|(name, bytes)| (format!("terminalsAndIcons/{name}"), bytes)),
    );
    if standard == Standard::Fmi2 {
        files.insert("model.png".to_owned(), ICON_PNG);
    }
    for library in libraries {
        let path = format!(
            "binaries/{}/{}{}",
            library.folder(standard),
            scene.name(),
            library.suffix
        );
        files.insert(path, &library.bytes);
    }
    files.extend(
        documentation
            .iter()
            .map(|(path, bytes)| (format!("documentation/{path}"), bytes.as_slice())),
    );

    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    // The fastest level takes a quarter of the default's time, and a quarter more room.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .compression_level(Some(1))
        .last_modified_time(DateTime::default())
        .unix_permissions(0o644);
    let written = files.into_iter().try_for_each(|(path, bytes)| {
        zip.start_file(path, options)?;
        Ok(zip.write_all(bytes)?)
    });
    written
        .and_then(|()| zip.finish())
        .map(Cursor::into_inner)
        .map_err(|error: zip::result::ZipError| Fault::new(format!("cannot write the FMU: {error}")))
}

fn unreadable(path: &Path, error: &std::io::Error) -> Fault {
    Fault::new(format!("cannot read {}: {error}", path.display()))
}

/// The shared library of this crate, beside the running program or where Cargo puts it.
///
/// # Errors
/// It is in none of these places.
pub fn find_library() -> Result<PathBuf, Fault> {
    let name = format!("{DLL_PREFIX}lemnis_fmu{DLL_SUFFIX}");
    let program = std::env::current_exe().map_err(|error| Fault::new(format!("cannot find this program: {error}")))?;
    let folder = program.parent().unwrap_or(&program);
    // Cargo keeps the copy in deps/ up to date whatever is built, that beside the program only at times.
    let places = ["deps", "", "../deps"].map(|place| folder.join(place).join(&name));
    match places.iter().find(|place| place.is_file()) {
        Some(place) => Ok(place.clone()),
        None => refuse(format!(
            "the FMU's library is not in {}: put it beside the program, or build it with `cargo build -p lemnis-fmu`",
            places.map(|place| place.display().to_string()).join(", ")
        )),
    }
}
