//! `lemnis`: from one scene file to an FMU and a calculation book.

mod books;
mod decision;
mod failure;
mod output;
mod scene_file;
mod synth;
mod trade;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use clap::{Args, Parser, Subcommand};
use indicatif::ProgressBar;
use lemnis::results::Results;
use lemnis_fmu::description::Standard;
use lemnis_fmu::package::{self, Library};
use lemnis_models::scene::{self, DEFAULT, Scene};

use crate::books::{Books, Making};
use crate::decision::{Decision, decided};
use crate::failure::Failure;
use crate::output::{Output, say, write};
use crate::synth::Synth;
use crate::trade::Trade;

/// Typesetting makes millions of small pieces: with the system's allocator it takes a tenth more time.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Crane mechanisms from one scene file: an FMU for simulators and a calculation book.
///
/// A scene is a TOML file that describes a crane. Without one, the embedded
/// default scene is used: the lemniscate crane of Li and Jiang. Start your own
/// with `lemnis new`.
#[derive(Parser)]
#[command(version, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  the scene is wrong; the message shows the line and what to do
  2  the command line is wrong
  3  a file cannot be read or written; no file is left half written
  4  `check`: a limit of the scene is not kept
  5  a template is wrong, or the FMU's library is missing";

#[derive(Subcommand)]
enum Command {
    /// Make everything: both FMUs and the book
    Build {
        #[command(flatten)]
        pack: Pack,
        #[command(flatten)]
        making: Making,
    },
    /// Make the FMUs: NAME.fmu (FMI 3.0) and NAME.fmi2.fmu (FMI 2.0)
    Fmu(Pack),
    /// Make calculation books: NAME.pdf of every scene
    Book(Books),
    /// Find the lever counterweight that a scene asks for: NAME_synth.toml
    Synth(Synth),
    /// Measure what accuracy costs: every level, solver and step of a scene; name the cheapest that keeps to `accuracy`
    Trade(Trade),
    /// Work with the templates of books
    Templates {
        #[command(subcommand)]
        command: TemplatesCommand,
    },
    /// Check a scene, say what would be built, print all results
    Check {
        /// Scene file, - for the standard input [default: the embedded scene]
        scene: Option<PathBuf>,
        /// Print the results as JSON, in SI units
        #[arg(long, conflicts_with = "csv")]
        json: bool,
        /// Print the results as CSV, in the units of the trade
        #[arg(long)]
        csv: bool,
    },
    /// Write a commented scene to start from
    New {
        /// File to write; it must not exist
        #[arg(default_value = "scene.toml")]
        file: PathBuf,
    },
    /// Print the JSON Schema of scenes, for editors
    Schema,
}

#[derive(Subcommand)]
enum TemplatesCommand {
    /// Write the built-in templates and words into a folder; keep what you change and use it with --templates
    Export {
        /// Folder to write to; none of the files may exist
        dir: PathBuf,
    },
}

#[derive(Args)]
struct Make {
    /// Scene file, - for the standard input [default: the embedded scene]
    scene: Option<PathBuf>,
    /// Folder for the results
    #[arg(short, long, default_value = "out")]
    output: PathBuf,
}

#[derive(Args)]
struct Pack {
    #[command(flatten)]
    make: Make,
    /// Folder with the FMU's libraries of several platforms, made by fmu/platforms.py [default: this platform's alone]
    #[arg(long, value_name = "FOLDER")]
    platforms: Option<PathBuf>,
}

fn main() -> ExitCode {
    match run(Cli::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{failure}");
            ExitCode::from(failure.code())
        }
    }
}

fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Build {
            pack: Pack { make, platforms },
            making,
        } => {
            let scene = to_build(make.scene.as_deref())?.announced()?;
            let results = Results::new(&scene).map_err(Failure::of_scene)?;
            let pdf = making.pdf(&scene, &results)?;
            let documentation = documentation(&scene, Some(&pdf))?;
            let mut outputs = fmus(&scene, platforms.as_deref(), &documentation)?;
            outputs.push(pdf);
            say(format_args!("{}\n{}", scene.title(), results.summary()))?;
            write(&make.output, &outputs)
        }
        Command::Fmu(Pack { make, platforms }) => {
            let scene = to_build(make.scene.as_deref())?.announced()?;
            let documentation = documentation(&scene, None)?;
            write(&make.output, &fmus(&scene, platforms.as_deref(), &documentation)?)
        }
        Command::Book(books) => books.run(),
        Command::Synth(synth) => synth.run(),
        Command::Trade(trade) => trade.run(),
        Command::Templates { command } => match command {
            TemplatesCommand::Export { dir } => books::export(&dir),
        },
        Command::Check { scene, json, csv } => check(scene.as_deref(), json, csv),
        Command::New { file } => new(&file),
        Command::Schema => say(format_args!("{:#}", scene::json_schema())),
    }
}

/// How often a spinner turns.
const TICK: Duration = Duration::from_millis(100);

/// Turns a spinner while something runs that may take longer than a second; silent where nobody watches.
fn busy<T>(message: String, work: impl FnOnce() -> T) -> T {
    let spinner = ProgressBar::new_spinner().with_message(message);
    spinner.enable_steady_tick(TICK);
    let done = work();
    spinner.finish_and_clear();
    done
}

/// The scene of a file, without a path the embedded one, with all decided that it leaves open.
fn to_build(path: Option<&Path>) -> Result<Decision, Failure> {
    decided(scene_file::read(path)?, &scene_file::name(path))
}

/// What lies in an FMU's `documentation/`: its first page and, if there is one, the book.
fn documentation(scene: &Scene, book: Option<&Output>) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let page = lemnis::documentation::page(scene, book.map(|book| book.name.as_str()));
    let page = page.map_err(|error| Failure::Program(error.to_string()))?;
    let mut files = vec![("index.html".to_owned(), page.into_bytes())];
    files.extend(book.map(|book| (book.name.clone(), book.bytes.clone())));
    Ok(files)
}

/// Both FMUs, each packed in a thread of its own.
fn fmus(scene: &Scene, platforms: Option<&Path>, documentation: &[(String, Vec<u8>)]) -> Result<Vec<Output>, Failure> {
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

fn check(path: Option<&Path>, json: bool, csv: bool) -> Result<(), Failure> {
    let decision = to_build(path)?;
    let scene = &decision.scene;
    let results = Results::new(scene).map_err(Failure::of_scene)?;
    if json {
        say(results.json())?;
    } else if csv {
        say(results.csv().trim_end())?;
    } else {
        say(results.table())?;
        let (name, level) = (scene.name(), scene.level());
        decision.notes.iter().try_for_each(say)?;
        say(format_args!(
            "would build {name}.fmu, {name}.fmi2.fmu and {name}.pdf at level \"{level}\""
        ))?;
    }
    match results.broken_limits().as_slice() {
        [] => Ok(()),
        broken => Err(Failure::Limit(format!("limits not kept: {}", broken.join("; ")))),
    }
}

fn new(file: &Path) -> Result<(), Failure> {
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
