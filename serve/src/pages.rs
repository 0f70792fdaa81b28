//! Pages of books by their hash: one that has not changed is not sent again.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};

use hyper::body::Bytes;
use serde::Serialize;

use crate::service::hash;

/// Books whose pages are kept: a page may be asked for after the next book is there.
const BOOKS: usize = 3;

/// Where a page of a book is, and its size in its own units, so that nothing jumps while it comes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sheet {
    pub hash: String,
    pub width: f64,
    pub height: f64,
}

/// The pages of the last books.
#[derive(Default)]
pub struct Pages(Mutex<VecDeque<Vec<(Sheet, Bytes)>>>);

impl Pages {
    /// Keeps a book's pages, SVG each.
    pub fn keep(&self, pages: Vec<String>) -> Vec<Sheet> {
        let page = |svg: String| {
            let [width, height] = size(&svg).unwrap_or([1.0, 1.0]);
            let hash = hash(svg.as_bytes());
            (Sheet { hash, width, height }, Bytes::from(svg))
        };
        let book: Vec<(Sheet, Bytes)> = pages.into_iter().map(page).collect();
        let sheets = book.iter().map(|(sheet, _)| sheet.clone()).collect();
        let mut books = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        books.push_back(book);
        if books.len() > BOOKS {
            books.pop_front();
        }
        sheets
    }

    pub fn find(&self, hash: &str) -> Option<Bytes> {
        let books = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut pages = books.iter().flatten();
        pages
            .find(|(sheet, _)| sheet.hash == hash)
            .map(|(_, bytes)| bytes.clone())
    }
}

/// Width and height of an SVG's view box.
fn size(svg: &str) -> Option<[f64; 2]> {
    let (_, after) = svg.split_once("viewBox=\"")?;
    let mut numbers = after.split_once('"')?.0.split_ascii_whitespace().skip(2);
    let mut next = || numbers.next()?.parse().ok();
    Some([next()?, next()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn svg(text: &str) -> String {
        format!("<svg viewBox=\"0 0 595.28 841.89\">{text}</svg>")
    }

    #[test]
    fn pages_of_the_last_books_are_found_by_their_hash() {
        let pages = Pages::default();
        let first = pages.keep(vec![svg("a"), svg("b")]);
        let second = pages.keep(vec![svg("a"), svg("c")]);
        assert_eq!(first[0], second[0], "unchanged");
        assert_ne!(first[1].hash, second[1].hash);
        assert_eq!((first[0].width, first[0].height), (595.28, 841.89));
        assert_eq!(pages.find(&first[1].hash).as_deref(), Some(svg("b").as_bytes()));
        pages.keep(Vec::new());
        pages.keep(Vec::new());
        assert_eq!(pages.find(&first[1].hash), None, "forgotten");
        assert_eq!(pages.find(&second[0].hash).as_deref(), Some(svg("a").as_bytes()));
        assert_eq!(pages.find("../Cargo.toml"), None);
    }
}
