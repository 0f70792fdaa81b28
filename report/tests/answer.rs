//! What a scene's text gives, for all who ask.

use std::collections::BTreeSet;
use std::path::PathBuf;

use lemnis::answer::editing::{complete, hover};
use lemnis::answer::{Answer, Mistake};
use lemnis::language::LANGUAGES;
use lemnis_models::scene::{DEFAULT, Scene};
use serde_json::Value;

fn scenes() -> Vec<(PathBuf, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes");
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("scenes")
        .map(|entry| entry.expect("readable").path())
        .collect();
    paths.sort();
    assert!(paths.len() > 20);
    paths
        .into_iter()
        .map(|path| (path.clone(), std::fs::read_to_string(path).expect("a scene")))
        .collect()
}

fn shown(text: &str, language: usize) -> Value {
    let answer = Answer::in_language(text, &LANGUAGES[language], false);
    assert!(answer.diagnostics.is_empty(), "{:?}", answer.diagnostics);
    serde_json::to_value(answer).expect("plain data")["shown"].clone()
}

/// The text of pieces with styles.
fn plain(script: &Value) -> String {
    let pieces = script.as_array().expect("pieces");
    pieces.iter().map(|piece| piece[0].as_str().expect("a text")).collect()
}

#[test]
fn every_scene_answers_in_every_language() {
    for (path, text) in scenes() {
        let [english, chinese, bulgarian] = [0, 1, 2].map(|language| shown(&text, language));
        whole(&english);
        // The same numbers, whatever the language.
        for other in [&chinese, &bulgarian] {
            assert_eq!(
                listed(&english, "columns", "values"),
                listed(other, "columns", "values")
            );
            assert_eq!(english["drawing"], other["drawing"]);
        }
        let untranslated = untranslated(&english, &[&chinese, &bulgarian]);
        assert!(untranslated.is_empty(), "{}: {untranslated:?}", path.display());
    }
}

fn listed(shown: &Value, part: &str, key: &str) -> Vec<Value> {
    let list = shown[part].as_array().expect("a list");
    list.iter().map(|one| one[key].clone()).collect()
}

/// A value of every column, and a drawing, for each position.
fn whole(shown: &Value) {
    let count = |list: &Value| list.as_array().expect("a list").len();
    let columns = shown["columns"].as_array().expect("columns");
    let rows = count(&columns[0]["values"]);
    assert!(rows > 1 && columns.len() > 5);
    for column in columns {
        assert_eq!([count(&column["values"]), count(&column["texts"])], [rows, rows]);
        assert!(!plain(&column["symbol"]).is_empty() && !plain(&column["text"]).is_empty());
    }
    assert_eq!(count(&shown["drawing"]["positions"]), rows);
}

/// What a reader sees of quantities, of what is asked of them and of curves, and is the same as in English.
fn untranslated(english: &Value, others: &[&Value]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (part, key) in [
        ("columns", "text"),
        ("requirements", "sentence"),
        ("governing", "text"),
        ("curves", "caption"),
    ] {
        let own = listed(english, part, key);
        for (i, text) in own.iter().map(plain).enumerate() {
            assert!(!text.contains(['_', '$', '#']), "{text}");
            if others.iter().any(|other| plain(&listed(other, part, key)[i]) == text) {
                found.insert(text);
            }
        }
    }
    found
}

#[test]
fn numbers_stand_as_the_book_of_the_language_has_them() {
    let governing = |language: usize| {
        let shown = shown(DEFAULT, language);
        let lines = shown["governing"].as_array().expect("results").clone();
        let line = lines
            .iter()
            .find(|line| line["name"] == "M_Q_max")
            .expect("a result")
            .clone();
        (plain(&line["value"]), plain(&line["at"]))
    };
    let (english, bulgarian) = (governing(0), governing(2));
    assert!(english.0.contains('.') && !english.0.contains(','), "{english:?}");
    assert_eq!(english.0.replace('.', ","), bulgarian.0);
    assert_eq!(english.1.replace('.', ","), bulgarian.1);
}

/// Where the head is drawn is where its coordinates are.
#[test]
fn the_drawing_is_that_of_the_results() {
    let shown = shown(DEFAULT, 0);
    let column = |name: &str| {
        let columns = shown["columns"].as_array().expect("columns");
        let column = columns.iter().find(|column| column["name"] == name).expect("a column");
        column["values"].as_array().expect("values").clone()
    };
    let (x, y) = (column("A.x"), column("A.y"));
    let drawing = &shown["drawing"];
    for (i, marks) in drawing["positions"].as_array().expect("drawings").iter().enumerate() {
        let marks = marks.as_array().expect("marks").iter();
        let marks = marks.map(|mark| mark.as_u64().map_or(mark, |still| &drawing["still"][still as usize]));
        let head = marks
            .into_iter()
            .find(|mark| mark["kind"] == "label" && plain(&mark["text"]) == "A")
            .expect("the head");
        for (axis, column) in [&x, &y].into_iter().enumerate() {
            let (drawn, found) = (head["at"][axis].as_f64().expect("m"), column[i].as_f64().expect("m"));
            assert!((drawn - found).abs() < 1e-4, "{drawn} {found}");
        }
    }
}

fn wrong(text: &str) -> Vec<Mistake> {
    let answer = Answer::new(text);
    assert!(answer.told.is_none() && answer.shown.is_none());
    answer.diagnostics
}

#[test]
fn mistakes_have_their_places_in_every_way_of_counting() {
    let text =
        DEFAULT
            .replace("title.en = \"", "title.en = \"起重机 ° ")
            .replacen("X_2 = \"6.5 m\"", "X_22 = \"6.5 m\"", 1);
    let found = wrong(&text);
    let mistake = found
        .iter()
        .find(|mistake| mistake.fix.is_some() && mistake.message.contains("X_22"))
        .expect("told");
    let [from, to] = mistake.place.bytes;
    assert_eq!(&text[from..to], "X_22");
    let units: Vec<u16> = text.encode_utf16().collect();
    let [from, to] = mistake.place.utf16;
    assert_eq!(String::from_utf16_lossy(&units[from..to]), "X_22");
    assert_ne!(mistake.place.utf16, mistake.place.bytes);
    let line = text.lines().nth(mistake.place.line - 1).expect("a line");
    assert!(line.starts_with("X_22") && mistake.place.column == 1);
    let fix = mistake.fix.as_ref().expect("a fix");
    assert_eq!((fix.text.as_str(), fix.place), ("X_2", mistake.place));
    assert!(wrong("").len() > 1 && wrong("[").len() == 1);
}

#[test]
fn an_editor_is_answered_in_the_words_of_the_language() {
    let text = "title = \"起重机 °\"\n[luffing]\nX_";
    let end = text.encode_utf16().count();
    for (language, unit, part) in [(0, "m", "boom"), (1, "m", "臂架"), (2, "m", "стрела")] {
        let offers = complete(text, end, &LANGUAGES[language]);
        let offer = offers.iter().find(|offer| offer.label == "X_1").expect("a key");
        assert_eq!(offer.change.place.utf16, [end - 2, end]);
        assert_eq!(
            (offer.about.unit, offer.change.text.as_str()),
            (Some(unit), "X_1 = \" m\"")
        );
        assert!(offer.about.text.to_lowercase().contains(part), "{}", offer.about.text);
        let hint = hover(&format!("{text}1 = \"19.3 m\""), end, &LANGUAGES[language]).expect("a key");
        assert_eq!(
            (hint.path.as_str(), hint.place.utf16),
            ("luffing.X_1", [end - 2, end + 1])
        );
        assert_eq!(hint.about.text, offer.about.text);
        assert!(hint.about.range.is_some() && hint.about.source.is_some_and(|source| !source.is_empty()));
    }
    assert_eq!(complete("[luffing]\nbranch = ", 19, &LANGUAGES[0]).len(), 2);
}

/// What programs read of `lemnis check --json` is what the scene's model gives.
#[test]
fn told_are_the_values_of_the_model() {
    let answer = Answer::new(DEFAULT);
    let told = answer.told.expect("results");
    let mut model = Scene::parse(DEFAULT).expect("a scene").model().expect("a model");
    let index = model
        .variables()
        .iter()
        .position(|variable| variable.name() == "M_Q")
        .expect("a variable");
    for (i, at) in model.positions().into_iter().enumerate() {
        model.set(0, at).expect("in the range");
        assert_eq!(
            told.variables["M_Q"].values[i].to_bits(),
            (model.get(index).expect("a value") + 0.0).to_bits()
        );
    }
    assert!(told.checks.iter().any(|check| !check.asked));
}
