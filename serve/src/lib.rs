//! The live page of scenes, without anything of a scene: who serves says what a text gives
//! ([`service::Service`]).
//!
//! ```text
//! service.rs  what must be known of scenes
//! server.rs   connections
//! guard.rs    who may ask: Host, Origin, token, size and time of a body
//! app.rs      what is asked, and who answers
//! latest.rs   of many edits the last one counts
//! making.rs   files, made by child processes
//! books.rs    books, made by one that is kept
//! pages.rs    their pages by hash
//! task.rs     work that takes minutes, watched and stopped
//! page/       the page itself; page/dist/ is what esbuild bundles of it
//! ```
//!
//! It listens on the loopback interface alone, where pages of other sites reach it too: through the user's browser, by a name
//! that leads to 127.0.0.1. So every request must name this host, come from this page and know the token of this run.

mod app;
pub mod books;
mod guard;
mod latest;
mod making;
mod pages;
pub mod server;
pub mod service;
mod task;
