//! Completion, hover and fixes in a scene's text that is being written.

use lemnis_models::kernel::editing::{Completion, complete, hover};
use lemnis_models::scene::{DEFAULT, KEYS, Scene};

/// What may be written at the bar.
fn at(marked: &str) -> (String, Vec<Completion>) {
    let offset = marked.find('|').expect("a bar");
    let text = marked.replacen('|', "", 1);
    let found = complete(KEYS, &text, offset);
    (text, found)
}

fn labels(marked: &str) -> Vec<String> {
    at(marked).1.into_iter().map(|completion| completion.label).collect()
}

/// The text after a completion was taken, with a bar where one goes on.
fn taken(marked: &str, label: &str) -> String {
    let (mut text, found) = at(marked);
    let one = found.into_iter().find(|completion| completion.label == label);
    let edit = one.expect("offered").edit;
    let mut new = edit.text;
    new.insert(edit.caret, '|');
    text.replace_range(edit.replaced, &new);
    text
}

#[test]
fn keys_are_offered_where_they_are_missing_and_needed_ones_first() {
    let found = labels("[luffing]\nX_1 = \"19.3 m\"\n|\n[luffing.motion]\nfrom = \"1 deg\"");
    assert!(
        found.contains(&"X_2".to_owned()) && found.contains(&"fidelity".to_owned()),
        "{found:?}"
    );
    assert!(
        !found.contains(&"X_1".to_owned()) && !found.contains(&"motion".to_owned()),
        "{found:?}"
    );
    let place = |name: &str| found.iter().position(|known| known == name).expect("offered");
    assert!(place("X_2") < place("fidelity"));
    // Keys of the kind, even where it stands below.
    let found = labels("[luffing]\n|\nkind = \"rope\"");
    assert!(
        found.contains(&"l".to_owned()) && !found.contains(&"X_2".to_owned()),
        "{found:?}"
    );
    // Those of the top end where the first table begins.
    assert!(labels("na|").contains(&"name".to_owned()));
    assert!(labels("title.|").contains(&"bg".to_owned()));
    assert!(labels("[luffing]\nQ = { |").contains(&"source".to_owned()));
}

#[test]
fn a_key_is_written_with_its_unit_and_the_caret_before_it() {
    assert_eq!(
        taken("[luffing]\nX_|\nbranch = \"left\"", "X_2"),
        "[luffing]\nX_2 = \"| m\"\nbranch = \"left\""
    );
    assert_eq!(taken("na|", "name"), "name = \"|\"");
    // A whole name that is written is replaced by itself.
    assert_eq!(taken("[luffing]\nX_2|", "X_2"), "[luffing]\nX_2 = \"| m\"");
}

#[test]
fn values_are_choices_or_units() {
    let scene = "title = \"起重机 °\"\n[luffing]\n";
    assert_eq!(
        taken(&format!("{scene}branch = |"), "left"),
        format!("{scene}branch = \"left\"|")
    );
    assert_eq!(
        taken(&format!("{scene}branch = \"l|\nX_1 = \"1 m\""), "left"),
        format!("{scene}branch = \"left\"|\nX_1 = \"1 m\"")
    );
    assert_eq!(
        taken(&format!("{scene}Q = \"160 |\""), "160 t"),
        format!("{scene}Q = \"160 t\"|")
    );
    assert_eq!(labels(&format!("{scene}beta_0 = \"14.5|\""))[0], "14.5 deg");
    assert_eq!(
        taken(&format!("{scene}X_1 = |"), "mm"),
        format!("{scene}X_1 = \"| mm\"")
    );
    assert_eq!(
        taken("[book]\nchapters = [|]", "task"),
        "[book]\nchapters = [\"task\"|]"
    );
    assert!(
        labels("[luffing]\nX_1 = \"1 m\" |").is_empty()
            && labels("# X_|").is_empty()
            && labels("nobody = |").is_empty()
    );
}

#[test]
fn headers_are_offered_with_the_tables_of_what_is_there() {
    let scene = "[luffing]\nkind = \"rope\"\n[luffing.motion]\n";
    assert_eq!(
        taken(&format!("{scene}[lu|]"), "luffing.tackle"),
        format!("{scene}[luffing.tackle|]")
    );
    let found = labels(&format!("{scene}[|"));
    assert!(
        !found.contains(&"luffing.motion".to_owned()) && found.contains(&"slewing".to_owned()),
        "{found:?}"
    );
    assert!(!found.contains(&"slewing.motion".to_owned()), "{found:?}");
    assert_eq!(labels("[steering]\n[[steering.|"), ["steering.groups"]);
    // A part beside its mechanism has the keys that it has within.
    let alone = labels("[slewing]\n|");
    let beside = labels("[luffing]\n[slewing]\n|");
    assert!(
        alone.contains(&"Q".to_owned()) && !beside.contains(&"Q".to_owned()),
        "{alone:?} {beside:?}"
    );
}

#[test]
fn what_stands_at_a_place_is_known_wherever_in_its_line() {
    let text = DEFAULT;
    let line = text.find("\nX_1 ").expect("a key") + 1;
    let value = line + text[line..].find("19.3").expect("its value") + 1;
    for offset in [line, line + 1, line + 3, value] {
        let hover = hover(KEYS, text, offset).expect("a key");
        assert_eq!((hover.path.as_str(), &text[hover.span.clone()]), ("luffing.X_1", "X_1"));
        assert_eq!(hover.key.number().expect("a quantity").0.id, "X_1");
    }
    let header = text.find("[luffing.motion]").expect("a table");
    assert_eq!(hover(KEYS, text, header + 10).expect("a table").path, "luffing.motion");
    assert!(hover(KEYS, text, 0).is_none() && hover(KEYS, "nobody = 1", 3).is_none());
    assert!(hover(KEYS, "é", 1).is_none(), "not between two characters");
}

/// Whatever is cut off a scene: nothing panics, and what is offered lies before the place and within the text.
#[test]
fn any_part_of_a_scene_can_be_written_on() {
    let whole = include_str!("../scenes/portal_crane.toml");
    for (offset, _) in whole.char_indices().step_by(7) {
        for text in [&whole[..offset], whole] {
            for completion in complete(KEYS, text, offset) {
                let edit = completion.edit;
                assert!(
                    edit.replaced.start <= offset && text.get(edit.replaced).is_some() && edit.caret <= edit.text.len()
                );
            }
            if let Some(hover) = hover(KEYS, text, offset) {
                assert!(
                    text.get(hover.span)
                        .is_some_and(|name| hover.path.ends_with(name.trim_matches('"')))
                );
            }
        }
    }
}

/// The default scene after a change, with the fix of its last mistake taken.
fn fixed(from: &str, to: &str) -> String {
    assert!(DEFAULT.contains(from), "{from}");
    let mut text = DEFAULT.replacen(from, to, 1);
    let found = Scene::parse(&text).expect_err("a mistake");
    let edit = found.last().and_then(|last| last.fix.clone()).expect("a fix");
    text.replace_range(edit.replaced, &edit.text);
    text
}

#[test]
fn a_mistake_is_mended_by_its_fix() {
    for wrong in ["X_11 = \"19.3 m\"", "X_1 = \"19,3 m\"", "X_1 = 19.3", "X_1 = \"19.3\""] {
        let text = fixed("X_1 = \"19.3 m\"  ", wrong);
        assert!(Scene::parse(&text).is_ok(), "{text}");
    }
    let text = fixed("\nX_2 = \"6.5 m\"", "\n");
    assert!(text.contains("[luffing]\nX_2 = \" m\"\n"), "{text}");
    let text = fixed("\nname ", "\n# ");
    assert!(text.contains("\nname = \"\"\n"), "{text}");
}
