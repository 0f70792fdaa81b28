//! The live page of scenes, without anything of a scene: who serves says what a text gives ([`Service`]).
//!
//! ```text
//! guard.rs    who may ask: Host, Origin, token, size and time of a body
//! app.rs      what is asked, and who answers
//! latest.rs   of many edits the last one counts
//! making.rs   files, made by child processes
//! books.rs    books, made by one that is kept
//! pages.rs    their pages by hash
//! page/       the page itself; page/dist/ is what esbuild bundles of it
//! ```
//!
//! It listens on the loopback interface alone, where pages of other sites reach it too: through the user's browser, by a name
//! that leads to 127.0.0.1. So every request must name this host, come from this page and know the token of this run.

mod app;
mod books;
mod guard;
mod latest;
mod making;
mod pages;

use std::convert::Infallible;
use std::io;
use std::net::Ipv4Addr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::time::Duration;

use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use serde::Serialize;
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

use crate::app::App;
pub use crate::books::{Book, Wanted};
use crate::guard::{Guard, PATIENCE};

/// What is known of scenes; every answer is JSON.
pub trait Service: Send + Sync + 'static {
    /// What the page needs before all else: words, languages, scenes.
    fn start(&self) -> String;
    /// What a text gives.
    fn answer(&self, text: &str, language: &str) -> String;
    /// What may be written at a code unit of UTF-16.
    fn complete(&self, text: &str, at: usize, language: &str) -> String;
    /// What stands at a code unit of UTF-16.
    fn hover(&self, text: &str, at: usize, language: &str) -> String;
    /// The ready scenes.
    fn gallery(&self, language: &str) -> String;
    /// A scene by its id.
    ///
    /// # Errors
    /// There is none, or it cannot be read; in words for the user.
    fn open(&self, scene: &str) -> Result<Opened, String>;
    /// Puts a text in the place of one of which this was the hash; the new hash.
    ///
    /// # Errors
    /// It may not be written, or is not what it was; in words for the user.
    fn save(&self, scene: &str, text: &str, hash: &str) -> Result<String, String>;
    /// The command that makes a file of a text.
    ///
    /// # Errors
    /// The text is no scene, or nothing is called so.
    fn making(&self, made: &Made<'_>) -> Result<Making, String>;
    /// The command that answers each [`Wanted`] with a [`Book`], a line each.
    fn books(&self) -> Command;
}

/// A scene that was opened.
#[derive(Debug, Serialize)]
pub struct Opened {
    pub text: String,
    /// Of the text as it is on disk.
    pub hash: String,
    /// What it is called: a file, or the name of a ready scene.
    pub called: String,
    /// Whether it may be saved.
    pub writable: bool,
}

/// What is to be made.
#[derive(Debug)]
pub struct Made<'a> {
    pub what: &'a str,
    pub text: &'a str,
    pub language: &'a str,
    /// The file that has the text.
    pub scene: &'a Path,
    /// Where the command may write.
    pub folder: &'a Path,
}

/// A command and what comes of it.
#[derive(Debug)]
pub struct Making {
    pub command: Command,
    /// The file that it writes; otherwise what it prints.
    pub file: Option<PathBuf>,
    /// Exit codes besides 0 with which it is whole.
    pub whole: &'static [i32],
}

/// By which a text on disk is known.
#[must_use]
pub fn hash(bytes: &[u8]) -> String {
    use sha2::Digest;
    hex(&sha2::Sha256::digest(bytes))
}

fn hex(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let both = |byte: &u8| [byte >> 4, byte & 15].map(|digit| char::from(DIGITS[usize::from(digit)]));
    bytes.iter().flat_map(both).collect()
}

/// Connections at the same time; more wait.
const CONNECTIONS: usize = 64;
/// Headers of a request, in bytes.
const HEAD: usize = 16 << 10;
/// Of threads that answer, as the main thread has it.
const STACK: usize = 8 << 20;

/// A port of the loopback interface, with the token of this run.
pub struct Server {
    listener: std::net::TcpListener,
    guard: Guard,
}

impl Server {
    /// At a port; at 0, any that is free.
    ///
    /// # Errors
    /// The port is taken, or the system gives no random numbers.
    pub fn bind(port: u16) -> io::Result<Server> {
        let listener = std::net::TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        listener.set_nonblocking(true)?;
        let mut token = [0; 16];
        getrandom::fill(&mut token).map_err(|error| io::Error::other(error.to_string()))?;
        let guard = Guard::new(listener.local_addr()?.port(), hex(&token));
        Ok(Server { listener, guard })
    }

    /// Where the page is.
    #[must_use]
    pub fn address(&self) -> String {
        self.guard.address()
    }

    /// Answers until Ctrl+C.
    ///
    /// # Errors
    /// The system gives no threads or no signals.
    pub fn run(self, service: impl Service) -> io::Result<()> {
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .thread_stack_size(STACK)
            .build()?;
        let ended = runtime.block_on(async {
            let listener = TcpListener::from_std(self.listener)?;
            tokio::spawn(accept(listener, Arc::new(App::new(service, self.guard))));
            tokio::signal::ctrl_c().await
        });
        // What is being computed is not waited for; child processes end with what waits for them.
        runtime.shutdown_background();
        ended
    }
}

async fn accept<S: Service>(listener: TcpListener, app: Arc<App<S>>) {
    let free = Arc::new(Semaphore::new(CONNECTIONS));
    loop {
        let place = Arc::clone(&free).acquire_owned().await.expect("never closed");
        let Ok((stream, _)) = listener.accept().await else {
            // Too many files are open, for example.
            tokio::time::sleep(Duration::from_millis(50)).await;
            continue;
        };
        let app = Arc::clone(&app);
        tokio::spawn(async move {
            let answered = service_fn(|request| {
                let app = Arc::clone(&app);
                async move { Ok::<_, Infallible>(app.respond(request).await) }
            });
            // A connection that ends early is the browser's business.
            let _ = http1::Builder::new()
                .timer(TokioTimer::new())
                .header_read_timeout(PATIENCE)
                .max_buf_size(HEAD)
                .serve_connection(TokioIo::new(stream), answered)
                .await;
            drop(place);
        });
    }
}
