//! `lemnis book`: of one scene or of many, once or whenever something changes.

use std::ffi::OsString;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use lemnis::book::Edition;
use lemnis::language::Language;
use lemnis::results::{self, Results};
use lemnis::template::Templates;
use lemnis_models::book::LEVELS;
use lemnis_models::component::sheet::Sheet;
use lemnis_models::kernel::text::LANGUAGES;
use lemnis_models::scene::Scene;
use lemnis_typeset::{Embedded, External, Typesetter};
use notify::{Event, RecursiveMode, Watcher};

use crate::decision::decided;
use crate::failure::Failure;
use crate::output::{self, Complete, Output, say};
use crate::progress::busy;
use crate::scene_file;

/// How books are made.
#[derive(Args)]
pub struct Making {
    /// Language of the book [default: the scene's, otherwise en]
    #[arg(long, value_parser = PossibleValuesParser::new(LANGUAGES))]
    language: Option<String>,
    /// Detail of the book [default: the scene's, otherwise standard]
    #[arg(long, value_parser = PossibleValuesParser::new(LEVELS))]
    level: Option<String>,
    /// Folder whose templates, words and pictures override the built-in ones; `lemnis templates` writes those out
    #[arg(long, value_name = "DIR")]
    templates: Option<PathBuf>,
    /// An installed `typst` command, 0.15 or later, to typeset with instead of the built-in one
    #[arg(long, value_name = "PATH")]
    typst: Option<PathBuf>,
}

#[derive(Args)]
pub struct Books {
    /// Scene files, - for the standard input [default: the embedded scene]
    scenes: Vec<PathBuf>,
    /// Folder for the results
    #[arg(short, long, default_value = "out")]
    output: PathBuf,
    #[command(flatten)]
    making: Making,
    /// What to write: a PDF, pictures of the pages, the Typst source, or HTML for a preview. HTML has no pages, so
    /// neither header, footer nor page numbers, and the sources of formulas do not stand in a margin
    #[arg(long, value_enum, default_value_t = Format::Pdf)]
    format: Format,
    /// Make the book once more from the scene inside a book; with the options it was made with, to the same bytes
    #[arg(long, value_name = "BOOK.pdf", conflicts_with = "scenes")]
    from: Option<PathBuf>,
    /// How many processes share the books of several scenes [default: one for each core]
    #[arg(short, long, value_name = "N")]
    jobs: Option<NonZeroUsize>,
    /// Stay, and make the books again whenever a scene or a template changes
    #[arg(long, requires = "scenes")]
    watch: bool,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    Pdf,
    Svg,
    Png,
    Typ,
    Html,
}

impl Making {
    fn templates(&self) -> Result<Templates, Failure> {
        match &self.templates {
            None => Ok(Templates::embedded()),
            Some(folder) => Templates::with_folder(folder).map_err(Failure::File),
        }
    }

    fn typesetter(&self) -> Result<Box<dyn Typesetter>, Failure> {
        match &self.typst {
            None => Ok(Box::new(Embedded)),
            Some(path) => match External::new(path) {
                Ok(typst) => Ok(Box::new(typst)),
                Err(error) => Err(Failure::Program(error.to_string())),
            },
        }
    }

    /// These options for another process.
    fn arguments(&self) -> Vec<OsString> {
        let options: [(&str, Option<OsString>); 4] = [
            ("--language", self.language.as_ref().map(Into::into)),
            ("--level", self.level.as_ref().map(Into::into)),
            ("--templates", self.templates.as_ref().map(Into::into)),
            ("--typst", self.typst.as_ref().map(Into::into)),
        ];
        let given = options
            .into_iter()
            .filter_map(|(name, value)| Some([name.into(), value?]));
        given.flatten().collect()
    }

    fn edition<'a>(
        &'a self,
        scene: &'a Scene,
        templates: &'a Templates,
        typesetter: &'a dyn Typesetter,
    ) -> Edition<'a> {
        let code = self.language.as_deref().unwrap_or(scene.book.language);
        Edition {
            language: Language::find(code).expect("the command line and the scene were checked"),
            level: self.level.as_deref().unwrap_or(scene.book.level),
            templates,
            typesetter,
        }
    }

    /// The results of one scene, and its PDF.
    pub fn pdf(&self, scene: &Scene) -> Result<(Results, Output), Failure> {
        let (templates, typesetter) = (self.templates()?, self.typesetter()?);
        let edition = self.edition(scene, &templates, &*typesetter);
        edition.meanwhile(|| {
            let results = Results::new(scene).map_err(Failure::of_scene)?;
            let made = busy(format!("typesetting {}", scene.name()), || {
                book(&edition, scene, &results.sheet, Format::Pdf)
            });
            Ok((results, made?.remove(0)))
        })
    }
}

/// A book in one format: one file, or one for each page, or the source with what it reads.
fn book(edition: &Edition<'_>, scene: &Scene, sheet: &Sheet, format: Format) -> Result<Vec<Output>, Failure> {
    let name = scene.name();
    let wrong = |error: lemnis::template::Error| Failure::Program(error.to_string());
    let format = match format {
        Format::Pdf => lemnis_typeset::Format::Pdf,
        Format::Svg => lemnis_typeset::Format::Svg,
        Format::Png => lemnis_typeset::Format::Png,
        Format::Html => lemnis_typeset::Format::Html,
        Format::Typ => {
            let pdf = lemnis_typeset::Format::Pdf;
            let source = edition.source(scene, sheet, pdf).map_err(wrong)?;
            let main = (format!("{name}.typ"), source.main.into_bytes());
            let outputs = std::iter::once(main).chain(source.files);
            return Ok(outputs.map(|(name, bytes)| Output { name, bytes }).collect());
        }
    };
    let made = edition.typeset(scene, sheet, format).map_err(wrong)?;
    for warning in made.warnings {
        eprintln!("warning: {warning}");
    }
    let (count, suffix) = (made.files.len(), format.name());
    let digits = count.to_string().len();
    let file = |(page, bytes)| Output {
        name: match format {
            lemnis_typeset::Format::Svg | lemnis_typeset::Format::Png => format!("{name}-{page:0digits$}.{suffix}"),
            _ => format!("{name}.{suffix}"),
        },
        bytes,
    };
    Ok((1..).zip(made.files).map(file).collect())
}

impl Books {
    pub fn run(&self) -> Result<(), Failure> {
        if self.watch {
            return self.watch();
        }
        // What is wrong with any of them is told before the first book is made.
        let scenes = self.scenes()?;
        let cores = || std::thread::available_parallelism().map_or(1, usize::from);
        let cores = self.jobs.map_or_else(cores, usize::from);
        // Another process cannot read the standard input again.
        let most = if self.reads_input() { 1 } else { cores };
        let made = busy("typesetting".to_owned(), || match most.min(self.scenes.len()) {
            0 | 1 => self.make(&scenes),
            processes => self.share(processes, cores / processes),
        });
        output::place(made?)
    }

    fn reads_input(&self) -> bool {
        self.scenes.iter().any(|path| path == Path::new(scene_file::INPUT))
    }

    fn scenes(&self) -> Result<Vec<Scene>, Failure> {
        let read = |path: Option<&Path>| Ok((scene_file::read(path)?, scene_file::name(path)));
        let scenes: Vec<(Scene, String)> = match (&self.from, self.scenes.as_slice()) {
            (Some(book), _) => vec![scene_file::from_book(book)?],
            (None, []) => vec![read(None)?],
            (None, paths) => paths
                .iter()
                .map(|path| read(Some(path)))
                .collect::<Result<_, Failure>>()?,
        };
        let scenes: Vec<Scene> = scenes
            .into_iter()
            .map(|(scene, name)| decided(scene, &name)?.announced())
            .collect::<Result<_, _>>()?;
        for (i, scene) in scenes.iter().enumerate() {
            if let Some(other) = scenes[..i].iter().position(|other| other.name() == scene.name()) {
                return Err(Failure::Scene(format!(
                    "{} and {} have the same name, {}: their books would have the same file; change `name` in one",
                    self.scenes[other].display(),
                    self.scenes[i].display(),
                    scene.name()
                )));
            }
        }
        Ok(scenes)
    }

    /// All books, or the first failure; none has taken its place yet.
    fn make(&self, scenes: &[Scene]) -> Result<Vec<Complete>, Failure> {
        let (templates, typesetter) = (self.making.templates()?, self.making.typesetter()?);
        let make = |scene: &Scene| {
            let edition = self.making.edition(scene, &templates, &*typesetter);
            edition.meanwhile(|| {
                let sheet = results::sheet(scene).map_err(Failure::of_scene)?;
                output::complete(&self.output, &book(&edition, scene, &sheet, self.format)?)
            })
        };
        scenes.iter().map(make).collect()
    }

    /// All books, by as many processes as there are cores: Typst's cache and the memory of threads are shared, and two
    /// threads take half as long again as two processes.
    fn share(&self, processes: usize, threads: usize) -> Result<Vec<Complete>, Failure> {
        self.making.templates()?;
        self.making.typesetter()?;
        let folder = output::workshop(&self.output)?;
        let failed = |error: std::io::Error| Failure::Program(format!("cannot start another process: {error}"));
        let program = std::env::current_exe().map_err(failed)?;
        let format = self.format.to_possible_value().expect("none is hidden");
        let start = |paths: &[PathBuf]| {
            Command::new(&program)
                .args(["book", "--jobs", "1", "--format", format.get_name(), "--output"])
                .arg(folder.path())
                .args(self.making.arguments())
                .arg("--")
                .args(paths)
                .env("RAYON_NUM_THREADS", threads.to_string())
                .stdin(Stdio::null())
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
        };
        let parts = self.scenes.chunks(self.scenes.len().div_ceil(processes));
        let children: Vec<_> = parts.map(start).collect();
        let ended: Vec<_> = children.into_iter().map(|child| child?.wait_with_output()).collect();
        for done in ended {
            let done = done.map_err(failed)?;
            let told = String::from_utf8_lossy(&done.stderr);
            match done.status.code() {
                Some(0) => eprint!("{told}"),
                code => {
                    return Err(Failure::Process(
                        code.and_then(|code| code.try_into().ok()),
                        told.trim_end().into(),
                    ));
                }
            }
        }
        Ok(vec![output::gather(folder, &self.output)?])
    }

    /// Makes the books now and after every change, until the program is ended.
    fn watch(&self) -> Result<(), Failure> {
        if self.reads_input() {
            return Err(Failure::File(
                "the standard input cannot be watched: name files".to_owned(),
            ));
        }
        let (sender, changes) = channel();
        let unwatchable = |error: notify::Error| Failure::File(format!("cannot watch for changes: {error}"));
        let mut watcher = notify::recommended_watcher(sender).map_err(unwatchable)?;
        // Editors replace files: what is watched is the folder.
        for scene in &self.scenes {
            let folder = scene.parent().filter(|folder| !folder.as_os_str().is_empty());
            let folder = folder.unwrap_or(Path::new("."));
            watcher
                .watch(folder, RecursiveMode::NonRecursive)
                .map_err(unwatchable)?;
        }
        if let Some(folder) = &self.making.templates {
            watcher.watch(folder, RecursiveMode::Recursive).map_err(unwatchable)?;
        }
        loop {
            let started = Instant::now();
            match self
                .scenes()
                .and_then(|scenes| self.make(&scenes))
                .and_then(output::place)
            {
                Ok(()) => say(format_args!(
                    "  in {} ms; waiting for changes",
                    started.elapsed().as_millis()
                ))?,
                Err(failure) => eprintln!("{failure}\n  waiting for changes"),
            }
            if !self.changed(&changes) {
                return Ok(());
            }
        }
    }

    /// Waits for a change of a scene or a template; false where none can come any more.
    fn changed(&self, changes: &Receiver<notify::Result<Event>>) -> bool {
        let same = |a: &Path, b: &Path| a == b || std::path::absolute(a).ok() == std::path::absolute(b).ok();
        let templates = self
            .making
            .templates
            .as_ref()
            .and_then(|path| std::path::absolute(path).ok());
        let concerns = |path: &PathBuf| {
            let of_templates = |folder: &PathBuf| std::path::absolute(path).is_ok_and(|path| path.starts_with(folder));
            self.scenes.iter().any(|scene| same(scene, path)) || templates.as_ref().is_some_and(of_templates)
        };
        loop {
            match changes.recv() {
                Ok(Ok(event)) if !event.kind.is_access() && event.paths.iter().any(concerns) => break,
                Ok(_) => {}
                Err(_) => return false,
            }
        }
        // One saving is several events.
        while changes.recv_timeout(Duration::from_millis(5)).is_ok() {}
        true
    }
}
