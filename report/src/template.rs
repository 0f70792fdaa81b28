//! Templates: words and layout of the book. Text is escaped so that Typst
//! prints it and never runs it; what is Typst already is marked `safe`.

use std::sync::OnceLock;

use minijinja::syntax::SyntaxConfig;
use minijinja::value::{Serde, Value};
use minijinja::{Environment, ErrorKind, UndefinedBehavior, context};

use crate::book::{Book, Error};
use crate::language::{LANGUAGES, Language, Words};
use crate::speech;

/// Every template by its name.
const TEMPLATES: [(&str, &str); 9] = [
    ("book.typ", include_str!("../../templates/book.typ")),
    ("style.typ", include_str!("../../templates/style.typ")),
    ("picture.typ", include_str!("../../templates/picture.typ")),
    ("results.typ", include_str!("../../templates/results.typ")),
    ("inputs.typ", include_str!("../../templates/inputs.typ")),
    ("section.typ", include_str!("../../templates/section.typ")),
    ("source.typ", include_str!("../../templates/source.typ")),
    ("range.typ", include_str!("../../templates/range.typ")),
    ("published.typ", include_str!("../../templates/published.typ")),
];

static READY: [OnceLock<Result<Ready, String>>; LANGUAGES.len()] = [const { OnceLock::new() }; LANGUAGES.len()];

/// The templates with the words of one language.
struct Ready {
    environment: Environment<'static>,
    words: Words,
}

/// The book's Typst source.
pub(crate) fn render(book: &Book, language: &Language) -> Result<String, Error> {
    let place = LANGUAGES.iter().position(|known| known.code == language.code);
    let ready = READY[place.expect("a language of the table")].get_or_init(|| {
        let words = Words::new(language)?;
        let environment = environment(&TEMPLATES, words.clone())?;
        Ok(Ready { environment, words })
    });
    let Ready { environment, words } = ready.as_ref().map_err(|error| Error(error.clone()))?;
    let template = environment
        .get_template(TEMPLATES[0].0)
        .map_err(|error| Error(describe(&error)))?;
    let source = template
        .render(context! { book => Serde(book) })
        .map_err(|error| Error(describe(&error)))?;
    speech::accessible(&source, words).map_err(Error)
}

fn environment(templates: &[(&'static str, &'static str)], words: Words) -> Result<Environment<'static>, String> {
    let syntax = SyntaxConfig::builder()
        .block_delimiters("<%", "%>")
        .comment_delimiters("<#", "#>")
        .line_statement_prefix("//%")
        .build()
        .expect("delimiters that differ");
    let mut environment = Environment::new();
    environment.set_syntax(syntax);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    // Lets an error name the variable.
    environment.set_debug(true);
    environment.set_formatter(|out, state, value| {
        if value.is_undefined() {
            return Err(ErrorKind::UndefinedError.into());
        }
        match value.as_str().filter(|_| !value.is_safe()) {
            Some(text) => out.write_str(&escape(text)).map_err(Into::into),
            None => minijinja::escape_formatter(out, state, value),
        }
    });
    environment.add_filter("string", |text: &str| Value::from_safe_string(speech::string(text)));
    let undefined = |detail| minijinja::Error::new(ErrorKind::UndefinedError, detail);
    let dictionary = words.clone();
    environment.add_function("word", move |group: &str, id: &str| {
        let word = dictionary.get(group, id).map_err(undefined)?;
        Ok(Value::from_safe_string(word.to_owned()))
    });
    // "[Li2022, eq. 5]" with the language's own "eq.".
    environment.add_filter("citation", move |source: &str| {
        ["eq.", "Fig.", "Table"]
            .iter()
            .try_fold(source.to_owned(), |source, &place| {
                let word = words.get("citation", place).map_err(undefined)?;
                Ok::<_, minijinja::Error>(source.replace(place, word))
            })
    });
    for (name, source) in templates {
        environment
            .add_template(name, source)
            .map_err(|error| describe(&error))?;
    }
    Ok(environment)
}

/// Template, line, and what is wrong with which variable.
fn describe(error: &minijinja::Error) -> String {
    let place = match (error.name(), error.line()) {
        (Some(name), Some(line)) => format!("templates/{name}:{line}: "),
        _ => String::new(),
    };
    let detail = error.detail().map_or_else(|| error.kind().to_string(), str::to_owned);
    format!("{place}{detail}")
}

/// Text that Typst prints as it is, in markup and between quotes: everything
/// that could be syntax becomes `\u{hex}`.
pub(crate) fn escape(text: &str) -> String {
    let plain =
        |c: char| c == ' ' || c.is_ascii_alphanumeric() || !(c.is_ascii() || c.is_control() || c.is_whitespace());
    text.chars()
        .map(|c| {
            if plain(c) {
                c.to_string()
            } else {
                format!("\\u{{{:x}}}", u32::from(c))
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hostile_text_is_only_text() {
        let hostile = "#read(\"/etc/passwd\") $x$ *b* @ref /* // \\ ] } \" ~ <l>\n= h\u{2028}`";
        let escaped = escape(hostile);
        let syntax = |c: char| c.is_ascii_punctuation() && !matches!(c, '\\' | '{' | '}');
        assert!(!escaped.contains(syntax) && !escaped.contains('\n'), "{escaped}");
        for source in [
            format!("= {escaped}"),
            format!("#\"{escaped}\""),
            format!("#let t = [{escaped}]\n#t"),
        ] {
            let source = format!("#set document(title: \"T\")\n{source}");
            assert!(lemnis_typeset::pdf(&source, &[]).unwrap().warnings.is_empty());
        }
    }

    #[test]
    fn an_error_names_template_line_and_variable() {
        let cases = [
            ("one\n{{ book.gone }}", "templates/book.typ:2: `book.gone` is undefined"),
            (
                "{{ word(\"section\", \"gone\") }}",
                "templates/book.typ:1: no words for section.gone",
            ),
            ("\n<% for %>", "templates/book.typ:2: "),
        ];
        for (source, message) in cases {
            let rendered = environment(&[("book.typ", source)], Words::of("[section]\n")).and_then(|environment| {
                let template = environment.get_template("book.typ").map_err(|error| describe(&error))?;
                template
                    .render(context! { book => context! {} })
                    .map_err(|error| describe(&error))
            });
            let error = rendered.unwrap_err();
            assert!(error.starts_with(message), "{error}");
        }
    }
}
