//! Where in TOML's grammar a place of a text is, whatever follows: of a text that is being written.

use std::borrow::Cow;
use std::ops::Range;

use toml_parser::parser::{Event, EventKind, parse_document};
use toml_parser::{Source, Span};

/// What a place is part of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Context {
    /// `[...]`, or `[[...]]` of a list of tables.
    Header { list: bool },
    /// The key of a value.
    #[default]
    Key,
    /// What follows `=`; `list` where a list is open.
    Value { list: bool },
    /// A comment, or what is complete.
    Nothing,
}

/// A place and what leads there.
#[derive(Debug)]
pub struct Site {
    pub context: Context,
    /// Names of tables and keys from the top to here, with what is written so far of a name.
    pub path: Vec<String>,
    /// Bytes of what is written so far: the path of a header, a key's last name, a value.
    pub word: Range<usize>,
    /// Bytes of the last name of the path.
    pub name: Range<usize>,
}

type Names = Vec<(String, Span)>;

/// A table or a list that is open, with the key that it is the value of.
enum Open {
    Table(Names),
    List,
}

/// The grammar's state while its events pass.
#[derive(Default)]
struct Reader {
    context: Context,
    header: Names,
    open: Vec<Open>,
    key: Names,
    /// Of the last event that is neither an error nor a space.
    last: Option<(EventKind, Span)>,
}

impl Reader {
    fn take(&mut self, source: Source<'_>, event: &Event) {
        let (kind, span) = (event.kind(), event.span());
        // What is missing at the end is put there as nothing.
        let made_up = span.is_empty() && source.input()[span.end()..].trim().is_empty();
        if kind == EventKind::Error || made_up {
            return;
        }
        if kind != EventKind::Whitespace {
            self.last = Some((kind, span));
        }
        match kind {
            EventKind::StdTableOpen | EventKind::ArrayTableOpen => {
                let list = kind == EventKind::ArrayTableOpen;
                let last = self.last;
                *self = Reader {
                    context: Context::Header { list },
                    last,
                    ..Reader::default()
                };
            }
            EventKind::StdTableClose | EventKind::ArrayTableClose => self.context = Context::Nothing,
            EventKind::SimpleKey => {
                let mut name = Cow::default();
                if let Some(raw) = source.get(event) {
                    raw.decode_key(&mut name, &mut ());
                }
                let names = match self.context {
                    Context::Header { .. } => &mut self.header,
                    _ => &mut self.key,
                };
                names.push((name.into_owned(), span));
            }
            EventKind::KeyValSep => self.context = Context::Value { list: false },
            EventKind::InlineTableOpen => {
                self.open.push(Open::Table(std::mem::take(&mut self.key)));
                self.context = Context::Key;
            }
            EventKind::ArrayOpen => {
                self.open.push(Open::List);
                self.context = Context::Value { list: true };
            }
            EventKind::InlineTableClose | EventKind::ArrayClose => {
                if let Some(Open::Table(key)) = self.open.pop() {
                    self.key = key;
                }
                self.context = Context::Nothing;
            }
            EventKind::ValueSep => match self.open.last() {
                Some(Open::List) => self.context = Context::Value { list: true },
                _ => self.next(),
            },
            EventKind::Newline if self.open.is_empty() => self.next(),
            _ => {}
        }
    }

    /// Another key begins.
    fn next(&mut self) {
        self.key.clear();
        self.context = Context::Key;
    }
}

impl Site {
    /// Of the end of a text, its last byte included.
    #[must_use]
    pub fn at(text: &str) -> Site {
        let source = Source::new(text);
        let tokens = source.lex().into_vec();
        let mut reader = Reader::default();
        parse_document(&tokens, &mut |event: Event| reader.take(source, &event), &mut ());
        let Reader {
            context,
            header,
            open,
            key,
            last,
        } = reader;
        let end = text.len();
        // What goes on where the text ends.
        let touches = last.filter(|(_, span)| span.end() == end);
        let begun = |kind: EventKind| match touches {
            Some((known, span)) if known == kind => span.start()..end,
            _ => end..end,
        };
        let last = last.map(|(kind, _)| kind);
        let (context, word) = match (context, last) {
            (_, Some(EventKind::Comment)) if touches.is_some() => (Context::Nothing, end..end),
            (Context::Header { .. }, _) => (context, header.first().map_or(end, |(_, span)| span.start())..end),
            // Behind a name that is over comes `=`, and behind a value the next line.
            (Context::Key, Some(EventKind::SimpleKey)) | (Context::Value { .. }, Some(EventKind::Scalar))
                if touches.is_none() =>
            {
                (Context::Nothing, end..end)
            }
            (Context::Key, _) => (context, begun(EventKind::SimpleKey)),
            (Context::Value { .. }, _) => (context, begun(EventKind::Scalar)),
            (Context::Nothing, _) => (context, end..end),
        };
        let inner = open.into_iter().flat_map(|open| match open {
            Open::Table(key) => key,
            Open::List => Names::new(),
        });
        let names: Names = header.into_iter().chain(inner).chain(key).collect();
        let name = names.last().map_or(end..end, |(_, span)| span.start()..span.end());
        Site {
            context,
            path: names.into_iter().map(|(name, _)| name).collect(),
            word,
            name,
        }
    }

    /// The table that the last name of the path is in.
    #[must_use]
    pub fn within(&self) -> &[String] {
        match self.word.is_empty() {
            true => &self.path,
            false => &self.path[..self.path.len() - 1],
        }
    }
}
