//! What is asked, and who answers.

use std::sync::Arc;

use hyper::body::{Bytes, Incoming};
use hyper::header::{CACHE_CONTROL, HeaderValue};
use hyper::http::request::Parts;
use hyper::{Method, Request, StatusCode};
use serde::Deserialize;
use serde_json::json;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use crate::books::{Books, Wanted};
use crate::guard::{Guard, Refusal, Reply, body, protect, reply};
use crate::latest::Latest;
use crate::making;
use crate::pages::Pages;
use crate::service::{Making, Service};
use crate::task::Task;

/// What the page is made of, and what kind each is.
const ASSETS: [(&str, &str, &[u8]); 3] = [
    (
        "/page.js",
        "text/javascript; charset=utf-8",
        include_bytes!("../page/dist/page.js"),
    ),
    (
        "/page.css",
        "text/css; charset=utf-8",
        include_bytes!("../page/dist/page.css"),
    ),
    ("/icon.svg", "image/svg+xml", include_bytes!("../../fmu/icon/icon.svg")),
];
const PAGE: &[u8] = include_bytes!("../page/index.html");
const JSON: &str = "application/json";
const SVG: &str = "image/svg+xml";

/// Child processes at the same time.
const CHILDREN: usize = 2;

/// What the page asks: each question needs some of it.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Asked {
    text: String,
    language: String,
    /// A place in the text, in code units of UTF-16.
    at: usize,
    /// Which page asks, and its how many-eth edit this is.
    page: u64,
    edit: u64,
    /// Whether runs in time can wait.
    at_rest: bool,
    /// The id of a scene.
    scene: String,
    /// Of its text, when it was read.
    hash: String,
    /// What is to be made.
    what: String,
    level: String,
    /// The number of one that was begun.
    task: u64,
}

pub struct App<S> {
    service: Arc<S>,
    guard: Guard,
    latest: Latest,
    books: Books,
    pages: Pages,
    task: Task,
    threads: Arc<Semaphore>,
    children: Arc<Semaphore>,
}

async fn place(free: &Arc<Semaphore>) -> OwnedSemaphorePermit {
    Arc::clone(free).acquire_owned().await.expect("never closed")
}

impl<S: Service> App<S> {
    pub fn new(service: S, guard: Guard) -> App<S> {
        App {
            service: Arc::new(service),
            guard,
            latest: Latest::default(),
            books: Books::default(),
            pages: Pages::default(),
            task: Task::default(),
            threads: Arc::new(Semaphore::new(
                std::thread::available_parallelism().map_or(1, usize::from),
            )),
            children: Arc::new(Semaphore::new(CHILDREN)),
        }
    }

    pub async fn respond(self: Arc<Self>, request: Request<Incoming>) -> Reply {
        let (head, incoming) = request.into_parts();
        let mut reply = match head.method {
            Method::GET => self.read(&head),
            Method::POST => self.ask(&head, incoming).await,
            _ => Err(Refusal::new(StatusCode::METHOD_NOT_ALLOWED, "GET or POST")),
        }
        .unwrap_or_else(Refusal::reply);
        protect(reply.headers_mut());
        let rule = HeaderValue::from_static("no-store");
        reply.headers_mut().entry(CACHE_CONTROL).or_insert(rule);
        reply
    }

    fn read(&self, head: &Parts) -> Result<Reply, Refusal> {
        let path = head.uri.path();
        let asset = ASSETS.iter().find(|(name, ..)| *name == path);
        self.guard.check(head, asset.is_some())?;
        if let Some((_, kind, bytes)) = asset {
            return Ok(reply(kind, Bytes::from_static(bytes)));
        }
        if path == "/" {
            return Ok(reply("text/html; charset=utf-8", Bytes::from_static(PAGE)));
        }
        let hash = path.strip_prefix("/book/").and_then(|name| name.strip_suffix(".svg"));
        let Some(page) = hash.and_then(|hash| self.pages.find(hash)) else {
            return Err(Refusal::new(StatusCode::NOT_FOUND, "there is nothing here"));
        };
        let mut page = reply(SVG, page);
        let rule = HeaderValue::from_static("private, max-age=31536000, immutable");
        page.headers_mut().insert(CACHE_CONTROL, rule);
        Ok(page)
    }

    async fn ask(&self, head: &Parts, incoming: Incoming) -> Result<Reply, Refusal> {
        self.guard.check(head, false)?;
        let asked = serde_json::from_slice(&body(incoming).await?);
        let asked: Asked = asked.map_err(|error| Refusal::new(StatusCode::BAD_REQUEST, error.to_string()))?;
        let refused = |words: String| Refusal::new(StatusCode::CONFLICT, words);
        let json = match head.uri.path() {
            "/api/start" => self.computed(move |service| service.start()).await?,
            "/api/answer" => self.answer(asked).await?,
            "/api/runs" => {
                let runs = move |service: &S| service.runs(&asked.text, &asked.language);
                self.computed(runs).await?
            }
            "/api/complete" => {
                let complete = move |service: &S| service.complete(&asked.text, asked.at, &asked.language);
                self.computed(complete).await?
            }
            "/api/hover" => {
                let hover = move |service: &S| service.hover(&asked.text, asked.at, &asked.language);
                self.computed(hover).await?
            }
            "/api/gallery" => self.computed(move |service| service.gallery(&asked.language)).await?,
            "/api/open" => {
                let opened = self.computed(move |service| service.open(&asked.scene)).await?;
                written(&opened.map_err(refused)?)
            }
            "/api/save" => {
                let save = move |service: &S| service.save(&asked.scene, &asked.text, &asked.hash);
                written(&self.computed(save).await?.map_err(refused)?)
            }
            "/api/book" => {
                let Asked {
                    text, language, level, ..
                } = asked;
                let wanted = Wanted { text, language, level };
                let made = self.books.make(self.service.books(), wanted).await?;
                written(&json!({ "sheets": self.pages.keep(made.pages), "places": made.places }))
            }
            "/api/make" => {
                let _place = place(&self.children).await;
                let made = making::file(&*self.service, &asked.what, &asked.text, &asked.language).await?;
                return Ok(reply("application/octet-stream", made));
            }
            "/api/begin" => {
                let Asked {
                    what, text, language, ..
                } = asked;
                let prepared = self.computed(move |service| making::prepared(service, &what, &text, &language));
                let (Making { command, .. }, place) = prepared.await??;
                written(&json!({ "task": self.task.begin(command, place) }))
            }
            "/api/look" => {
                let gone = || Refusal::new(StatusCode::NOT_FOUND, "another one was begun");
                let stand = self.task.look(asked.task).ok_or_else(gone)?;
                let drawn = stand.ended.as_ref().and_then(|ended| ended.picture.clone());
                let picture = drawn.and_then(|svg| self.pages.keep(vec![svg]).pop());
                written(&json!({ "percent": stand.percent, "ended": stand.ended, "picture": picture }))
            }
            "/api/stop" => {
                self.task.stop(asked.task);
                written(&json!({}))
            }
            _ => return Err(Refusal::new(StatusCode::NOT_FOUND, "nothing is asked so")),
        };
        Ok(reply(JSON, json))
    }

    /// What a text gives, unless a newer one of the same page is there.
    async fn answer(&self, asked: Asked) -> Result<String, Refusal> {
        let Asked { page, edit, .. } = asked;
        self.latest.note(page, edit);
        let place = place(&self.threads).await;
        if self.latest.overtaken(page, edit) {
            return Err(Refusal::new(StatusCode::CONFLICT, "overtaken"));
        }
        self.thread(place, move |service| {
            service.answer(&asked.text, &asked.language, asked.at_rest)
        })
        .await
    }

    /// What takes a moment is computed beside what waits, on no more threads than there are cores.
    async fn computed<T: Send + 'static>(&self, compute: impl FnOnce(&S) -> T + Send + 'static) -> Result<T, Refusal> {
        let place = place(&self.threads).await;
        self.thread(place, compute).await
    }

    /// A thread keeps its place to its end, whoever still waits for it.
    async fn thread<T: Send + 'static>(
        &self,
        place: OwnedSemaphorePermit,
        compute: impl FnOnce(&S) -> T + Send + 'static,
    ) -> Result<T, Refusal> {
        let service = Arc::clone(&self.service);
        let thread = tokio::task::spawn_blocking(move || {
            let _place = place;
            compute(&service)
        });
        let words = "a mistake of the program itself, not of the scene: please report it with the scene";
        thread
            .await
            .map_err(|_| Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, words))
    }
}

fn written(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("plain data")
}
