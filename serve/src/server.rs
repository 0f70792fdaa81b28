//! A port of this machine, and its connections.

use std::convert::Infallible;
use std::io;
use std::net::Ipv4Addr;
use std::sync::Arc;
use std::time::Duration;

use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

use crate::app::App;
use crate::guard::{Guard, PATIENCE};
use crate::service::{Service, hex};

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
