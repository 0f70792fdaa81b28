//! Books, by one child process that is kept: the next one lays out only what has changed.

use std::collections::BTreeMap;
use std::io;
use std::process::Stdio;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use tokio::io::{AsyncBufReadExt, AsyncWriteExt, BufReader};
use tokio::process::{Child, ChildStdin, ChildStdout, Command};
use tokio::sync::Mutex;

use crate::guard::Refusal;
use crate::making::{LONGEST, failed, refused};

/// A book that is wanted: a line of JSON for the child process.
#[derive(Debug, Deserialize, Serialize)]
pub struct Wanted {
    pub text: String,
    pub language: String,
    /// Its detail; empty for what the scene asks.
    pub level: String,
}

/// Its pages as SVG, and on which of them, counted from 1, each symbol is given or has its formula.
#[derive(Debug, Deserialize, Serialize)]
pub struct Printed {
    pub pages: Vec<String>,
    pub places: BTreeMap<String, usize>,
}

/// That, or what is wrong in words: the child's line for it.
pub type Book = Result<Printed, String>;

/// Books that one process makes, so that it cannot grow for ever.
const BOOKS: usize = 200;

struct Press {
    /// Ends with this.
    _child: Child,
    wanted: ChildStdin,
    made: BufReader<ChildStdout>,
    books: usize,
}

impl Press {
    fn start(command: std::process::Command) -> io::Result<Press> {
        let mut command = Command::from(command);
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null());
        let mut child = command.kill_on_drop(true).spawn()?;
        let pipes = child.stdin.take().zip(child.stdout.take());
        let (wanted, made) = pipes.ok_or_else(|| io::Error::other("no pipes"))?;
        Ok(Press {
            _child: child,
            wanted,
            made: BufReader::new(made),
            books: 0,
        })
    }

    async fn make(&mut self, wanted: &Wanted) -> io::Result<Book> {
        self.books += 1;
        let mut line = serde_json::to_string(wanted)?;
        line.push('\n');
        self.wanted.write_all(line.as_bytes()).await?;
        self.wanted.flush().await?;
        line.clear();
        match self.made.read_line(&mut line).await? {
            0 => Err(io::ErrorKind::UnexpectedEof.into()),
            _ => Ok(serde_json::from_str(&line)?),
        }
    }
}

/// The process, where one is running.
#[derive(Clone, Default)]
pub struct Books(Arc<Mutex<Option<Press>>>);

impl Books {
    /// One at a time. What is begun is ended, whoever waits for it; who gives up waiting for his turn has none.
    pub async fn make(&self, command: std::process::Command, wanted: Wanted) -> Result<Printed, Refusal> {
        let mut press = Arc::clone(&self.0).lock_owned().await;
        let made = tokio::spawn(async move {
            let mut running = match press.take() {
                Some(running) if running.books < BOOKS => running,
                _ => Press::start(command)?,
            };
            let made = tokio::time::timeout(LONGEST, running.make(&wanted)).await??;
            // One that failed or took too long is not kept.
            *press = Some(running);
            Ok::<Book, io::Error>(made)
        });
        let made = made.await.unwrap_or_else(|error| Err(error.into()));
        made.map_err(|error| failed(&error))?.map_err(refused)
    }
}
