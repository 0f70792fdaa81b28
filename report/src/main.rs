//! `lemnis`: from one scene file to an FMU and a calculation book.

mod commands;
mod decision;
mod failure;
mod measuring;
mod net;
mod output;
mod progress;
mod scene_file;
mod study_file;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use lemnis_models::scene;

use crate::commands::book::Books;
use crate::commands::build::Build;
use crate::commands::check::Check;
use crate::commands::fmu::Pack;
use crate::commands::new::New;
use crate::commands::pages;
use crate::commands::serve::Serve;
use crate::commands::sweep::Sweep;
use crate::commands::synth::Synth;
use crate::commands::templates::Templates;
use crate::commands::trade::Trade;
use crate::failure::Failure;
use crate::output::say;

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
  5  a template is wrong, or the FMU's library is missing
  6  the program itself is wrong; its line asks for a report, and no file is left half written";

#[derive(Subcommand)]
enum Command {
    /// Make everything: both FMUs and the book
    Build(Build),
    /// Make the FMUs: NAME.fmu (FMI 3.0) and NAME.fmi2.fmu (FMI 2.0)
    Fmu(Pack),
    /// Make calculation books: NAME.pdf of every scene
    Book(Books),
    /// Find the lever counterweight, or the quantities, that a scene asks for: NAME_synth.toml
    Synth(Synth),
    /// Compute the designs that a scene's [study] asks for, and what they say together
    Sweep(Sweep),
    /// Measure what accuracy costs: every level, solver and step of a scene; name the cheapest that keeps to `accuracy`
    Trade(Trade),
    /// Work with the templates of books
    Templates {
        #[command(subcommand)]
        command: Templates,
    },
    /// Show scenes in a browser: edit, see at once what moves, what is kept, what comes out
    Serve(Serve),
    /// Make books for the live page
    #[command(hide = true)]
    Pages,
    /// Check a scene, say what would be built, print all results
    Check(Check),
    /// Write a commented scene to start from
    New(New),
    /// Print the JSON Schema of scenes, for editors
    Schema,
}

fn main() -> ExitCode {
    let command = Cli::parse().command;
    match net::under(std::env::args(), || run(command)) {
        Ok(Ok(())) => ExitCode::SUCCESS,
        Ok(Err(failure)) => {
            eprintln!("{failure}");
            ExitCode::from(failure.code())
        }
        Err(line) => {
            eprintln!("{line}");
            ExitCode::from(net::CODE)
        }
    }
}

fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Build(build) => build.run(),
        Command::Fmu(pack) => pack.run(),
        Command::Book(books) => books.run(),
        Command::Synth(synth) => synth.run(),
        Command::Sweep(sweep) => sweep.run(),
        Command::Trade(trade) => trade.run(),
        Command::Templates { command } => command.run(),
        Command::Pages => pages::run(),
        Command::Serve(serve) => serve.run(),
        Command::Check(check) => check.run(),
        Command::New(new) => new.run(),
        Command::Schema => say(format_args!("{:#}", scene::json_schema())),
    }
}
