//! Work that takes minutes: a child process that is watched and stopped from the page, one at a time.

use std::io;
use std::process::Stdio;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use serde::Serialize;
use tokio::io::{AsyncBufReadExt, AsyncReadExt, BufReader};
use tokio::process::{ChildStderr, Command};

use crate::making::Workplace;

/// How long it goes on when no page looks at it.
const UNSEEN: Duration = Duration::from_secs(300);
/// How often is looked whether it has ended.
const GLANCE: Duration = Duration::from_millis(100);
/// How long one that was stopped may take to tell what it has found.
const LAST_WORDS: Duration = Duration::from_secs(20);

/// What has come of it.
#[derive(Clone, Debug, Serialize)]
pub struct Ended {
    /// What it has printed, or what was wrong.
    pub printed: String,
    pub failed: bool,
    /// A scene that it has written.
    pub scene: Option<String>,
    /// A picture that it has drawn, as SVG.
    #[serde(skip)]
    pub picture: Option<String>,
}

/// How it stands.
#[derive(Debug)]
pub struct Stand {
    pub percent: u8,
    pub ended: Option<Ended>,
}

struct Running {
    number: u64,
    percent: AtomicU8,
    ended: OnceLock<Ended>,
    seen: Mutex<Instant>,
    stop: AtomicBool,
}

/// The one that was begun last.
#[derive(Default)]
pub struct Task(Mutex<Option<Arc<Running>>>);

impl Task {
    fn running(&self, number: u64) -> Option<Arc<Running>> {
        let task = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        task.clone().filter(|running| running.number == number)
    }

    /// Begins a command; what ran before is stopped. The number of the task.
    pub fn begin(&self, command: std::process::Command, place: Workplace) -> u64 {
        let mut task = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(before) = task.take() {
            before.stop.store(true, Ordering::Relaxed);
        }
        let number = getrandom::u32().unwrap_or_default().into();
        let running = Arc::new(Running {
            number,
            percent: AtomicU8::new(0),
            ended: OnceLock::new(),
            seen: Mutex::new(Instant::now()),
            stop: AtomicBool::new(false),
        });
        *task = Some(Arc::clone(&running));
        tokio::spawn(async move {
            let ended = followed(command, &place, &running).await;
            let ended = ended.unwrap_or_else(|error| Ended {
                printed: error.to_string(),
                failed: true,
                scene: None,
                picture: None,
            });
            let _ = running.ended.set(ended);
        });
        number
    }

    /// How a task stands; `None` of one that another has taken the place of.
    pub fn look(&self, number: u64) -> Option<Stand> {
        let running = self.running(number)?;
        *running.seen.lock().unwrap_or_else(PoisonError::into_inner) = Instant::now();
        Some(Stand {
            percent: running.percent.load(Ordering::Relaxed),
            ended: running.ended.get().cloned(),
        })
    }

    /// Asks it for what it has so far.
    pub fn stop(&self, number: u64) {
        if let Some(running) = self.running(number) {
            running.stop.store(true, Ordering::Relaxed);
        }
    }
}

impl Running {
    /// Whether it is to stop: it was asked to, or nobody looks any more.
    fn is_unwanted(&self) -> bool {
        let seen = *self.seen.lock().unwrap_or_else(PoisonError::into_inner);
        self.stop.load(Ordering::Relaxed) || seen.elapsed() > UNSEEN
    }
}

/// What a command says beside its percentages, which are kept.
async fn progress(said: ChildStderr, running: Arc<Running>) -> io::Result<String> {
    let mut lines = BufReader::new(said).lines();
    let mut words = String::new();
    while let Some(line) = lines.next_line().await? {
        match line.strip_suffix(" %").and_then(|percent| percent.parse().ok()) {
            Some(percent) => drop(running.percent.fetch_max(percent, Ordering::Relaxed)),
            None => words.extend([&line, "\n"]),
        }
    }
    Ok(words)
}

async fn followed(command: std::process::Command, place: &Workplace, running: &Arc<Running>) -> io::Result<Ended> {
    let mut command = Command::from(command);
    command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.kill_on_drop(true).spawn()?;
    let pipes = child.stdout.take().zip(child.stderr.take());
    let (mut output, said) = pipes.ok_or_else(|| io::Error::other("no pipes"))?;
    let printed = tokio::spawn(async move {
        let mut printed = String::new();
        output.read_to_string(&mut printed).await.map(|_| printed)
    });
    let words = tokio::spawn(progress(said, Arc::clone(running)));
    let mut input = child.stdin.take();
    let mut stopped: Option<Instant> = None;
    let status = loop {
        if let Ok(status) = tokio::time::timeout(GLANCE, child.wait()).await {
            break status?;
        }
        if running.is_unwanted() {
            drop(input.take());
            if stopped.get_or_insert_with(Instant::now).elapsed() > LAST_WORDS {
                child.start_kill()?;
            }
        }
    };
    let (printed, words) = (printed.await??, words.await??);
    let written = |ending: &str| -> Option<String> {
        let files = std::fs::read_dir(&place.folder).ok()?.filter_map(Result::ok);
        let mut paths = files.map(|file| file.path());
        let found = paths.find(|path| path.extension().is_some_and(|own| own == ending));
        std::fs::read_to_string(found?).ok()
    };
    Ok(Ended {
        printed: place.said(if status.success() { &printed } else { &words }),
        failed: !status.success(),
        scene: written("toml"),
        picture: written("svg"),
    })
}
