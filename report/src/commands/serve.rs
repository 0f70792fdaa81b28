//! `lemnis serve`: the live page of scenes, on this machine alone.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;
use clap::builder::PossibleValuesParser;
use lemnis::answer::Answer;
use lemnis::answer::editing::{complete, hover};
use lemnis::answer::gallery::{self, Ready};
use lemnis::answer::runs::runs;
use lemnis::language::{LANGUAGES, Language};
use lemnis_models::kernel::text;
use lemnis_models::scene::{LONGEST, Scene};
use lemnis_serve::server::Server;
use lemnis_serve::service::{Made, Making, Opened, Service, hash};
use serde::Serialize;
use serde_json::json;

use crate::failure::Failure;
use crate::output::{Output, say, write};
use crate::progress::WATCHED;
use crate::scene_file::INPUT;

#[derive(Args)]
pub struct Serve {
    /// Scene files to open; the ready scenes are there without [default: the embedded scene]
    scenes: Vec<PathBuf>,
    /// Port of the loopback interface [default: any that is free]
    #[arg(long, default_value_t = 0, hide_default_value = true)]
    port: u16,
    /// Only print the address: do not open a browser
    #[arg(long)]
    no_open: bool,
    /// Never write to the scene files
    #[arg(long)]
    read_only: bool,
    /// Language of the page [default: that of the first scene's book, otherwise en]
    #[arg(long, value_parser = PossibleValuesParser::new(text::LANGUAGES))]
    language: Option<String>,
}

impl Serve {
    pub fn run(self) -> Result<(), Failure> {
        let program = std::env::current_exe();
        let program = program.map_err(|error| Failure::Program(format!("cannot find this program: {error}")))?;
        let mut desk = Desk {
            files: self.scenes,
            read_only: self.read_only,
            language: LANGUAGES[0].code,
            program,
        };
        // What cannot be read at all is told before a browser opens.
        let texts = desk.files.iter().map(|file| read(file).map_err(Failure::File));
        let texts = texts.collect::<Result<Vec<_>, _>>()?;
        let first = texts.first().and_then(|text| Scene::parse(text).ok());
        let language = self
            .language
            .as_deref()
            .or(first.as_ref().map(|scene| scene.book.language));
        desk.language = language.map_or(desk.language, |code| found(code).code);
        let server = Server::bind(self.port).map_err(|error| {
            let port = self.port;
            Failure::File(format!(
                "cannot listen at port {port} of this machine: {error}; choose another one with --port"
            ))
        })?;
        let address = server.address();
        say(format_args!(
            "{address}\n  open it in a browser of this machine; Ctrl+C ends it"
        ))?;
        if !self.no_open
            && let Err(error) = open::that_detached(&address)
        {
            eprintln!("  no browser opens by itself: {error}");
        }
        server
            .run(desk)
            .map_err(|error| Failure::Program(format!("the page is not served: {error}")))
    }
}

/// A language by its code; the first where the page names none.
fn found(code: &str) -> &'static Language {
    Language::find(code).unwrap_or(&LANGUAGES[0])
}

fn read(file: &Path) -> Result<String, String> {
    let name = file.display();
    if file == Path::new(INPUT) {
        return Err("the standard input cannot be saved to: name a file".to_owned());
    }
    let bytes = std::fs::read(file).map_err(|error| format!("cannot read the scene {name}: {error}"))?;
    if bytes.len() > LONGEST {
        return Err(format!(
            "{name} is longer than {LONGEST} bytes, the most that a scene may have"
        ));
    }
    String::from_utf8(bytes).map_err(|_| format!("{name} is not text in UTF-8; save it as UTF-8"))
}

fn written(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("plain data")
}

/// What the page works on: the files that were named, by their numbers, and the ready scenes, by their names.
struct Desk {
    files: Vec<PathBuf>,
    read_only: bool,
    language: &'static str,
    program: PathBuf,
}

impl Desk {
    fn file(&self, scene: &str) -> Option<&Path> {
        let number: usize = scene.parse().ok()?;
        self.files.get(number).map(PathBuf::as_path)
    }
}

impl Service for Desk {
    fn start(&self) -> String {
        let name = |file: &PathBuf| {
            file.file_name()
                .unwrap_or(OsStr::new(""))
                .to_string_lossy()
                .into_owned()
        };
        let files: Vec<String> = self.files.iter().map(name).collect();
        let languages: Vec<_> = LANGUAGES
            .iter()
            .map(|language| json!({ "code": language.code, "words": language.page() }))
            .collect();
        written(&json!({
            "language": self.language,
            "languages": languages,
            "files": files,
            "first": if files.is_empty() { gallery::FIRST } else { "0" },
        }))
    }

    fn answer(&self, text: &str, language: &str, at_rest: bool) -> String {
        written(&Answer::in_language(text, found(language), at_rest))
    }

    fn runs(&self, text: &str, language: &str) -> String {
        written(&runs(text, found(language)))
    }

    fn complete(&self, text: &str, at: usize, language: &str) -> String {
        written(&complete(text, at, found(language)))
    }

    fn hover(&self, text: &str, at: usize, language: &str) -> String {
        written(&hover(text, at, found(language)))
    }

    fn gallery(&self, language: &str) -> String {
        let ready: Vec<Ready> = gallery::ready(found(language)).collect();
        written(&ready)
    }

    fn open(&self, scene: &str) -> Result<Opened, String> {
        if let Some(file) = self.file(scene) {
            let text = read(file)?;
            return Ok(Opened {
                hash: hash(text.as_bytes()),
                text,
                called: file.display().to_string(),
                writable: !self.read_only,
            });
        }
        let text = gallery::text(scene).ok_or("there is no such scene")?;
        Ok(Opened {
            hash: hash(text.as_bytes()),
            text: text.to_owned(),
            called: scene.to_owned(),
            writable: false,
        })
    }

    fn save(&self, scene: &str, text: &str, before: &str) -> Result<String, String> {
        let file = self.file(scene).filter(|_| !self.read_only);
        let file = file.ok_or("this scene is not saved: it was opened for reading")?;
        let name = file.display();
        if hash(read(file)?.as_bytes()) != before {
            return Err(format!(
                "{name} was changed by another program since it was read; it stays as it is"
            ));
        }
        // A link stays one: what it leads to is replaced.
        let target = std::fs::canonicalize(file).map_err(|error| format!("cannot write {name}: {error}"))?;
        let parts = target.parent().zip(target.file_name());
        let (folder, own) = parts.ok_or_else(|| format!("{name} is no file"))?;
        let output = Output {
            name: own.to_string_lossy().into_owned(),
            bytes: text.into(),
        };
        write(folder, &[output]).map_err(|failure| failure.to_string())?;
        Ok(hash(text.as_bytes()))
    }

    fn making(&self, made: &Made<'_>) -> Result<Making, String> {
        let scene =
            Scene::parse(made.text).map_err(|found| found.first().map_or_else(String::new, ToString::to_string))?;
        let mut command = Command::new(&self.program);
        let language = found(made.language).code;
        let file = |suffix: &str| Some(made.folder.join(format!("{}{suffix}", scene.name())));
        let (file, whole): (_, &[i32]) = match made.what {
            "fmu" | "fmi2.fmu" | "pdf" => {
                command
                    .args(["build", "--language", language, "--output"])
                    .arg(made.folder);
                (file(&format!(".{}", made.what)), &[])
            }
            "csv" | "json" => {
                command.args(["check", &format!("--{}", made.what)]);
                // Limits that are not kept are told by the table too.
                (None, &[4])
            }
            "synth" | "trade" => {
                command.args([made.what, "--output"]).arg(made.folder);
                command.env(WATCHED, "1");
                (None, &[])
            }
            other => return Err(format!("nothing is made that is called {other}")),
        };
        command.arg(made.scene);
        Ok(Making { command, file, whole })
    }
    fn books(&self) -> Command {
        let mut command = Command::new(&self.program);
        command.arg("pages");
        command
    }
}
