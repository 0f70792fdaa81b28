//! What a scene may say: masses for weights, limits against slips of units, texts that can be printed, and
//! the line of every mistake.

use lemnis_models::kernel::diagnostic::Diagnostic;
use lemnis_models::kernel::text::Text;
use lemnis_models::scene::{DEFAULT, Scene};

fn changed(changes: &[(&str, &str)]) -> String {
    changes.iter().fold(DEFAULT.to_owned(), |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replacen(old, new, 1)
    })
}

fn value(scene: &Scene, name: &str) -> f64 {
    let mut model = scene.model().expect("a mechanism");
    let index = model.variables().iter().position(|variable| variable.name() == name);
    model.get(index.expect("known")).expect("a value")
}

fn mistakes(text: &str) -> Vec<Diagnostic> {
    Scene::parse(text).map_or_else(|found| found, |_| Vec::new())
}

/// Lines of mistakes, counted from 1.
fn lines(text: &str) -> Vec<usize> {
    let line = |mistake: Diagnostic| 1 + text[..mistake.span.start].matches('\n').count();
    mistakes(text).into_iter().map(line).collect()
}

#[test]
fn a_mass_weighs_by_the_scenes_gravity() {
    let masses = [
        (r#"Q = "160 kN""#, r#"Q = "16 t""#),
        (
            r#"G_1   = "196.2 kN""#,
            r#"G_1 = { value = "20000 kg", source = "scales" }"#,
        ),
    ];
    let scene = Scene::parse(&changed(&masses)).expect("masses are weights");
    assert_eq!(value(&scene, "Q"), 16_000.0 * 9.81);
    assert_eq!(value(&scene, "G_1"), 20_000.0 * 9.81);
    let given = scene.given.of("luffing.weights.G_1").expect("given");
    assert_eq!(
        (given.mass, given.source.as_ref().map(Text::english)),
        (Some(20_000.0), Some("scales"))
    );
    assert_eq!(scene.given.of("luffing.weights.G_2").expect("given").mass, None);
    let on_the_moon = changed(&[masses[0], ("[project]", "g = \"1.62 m/s2\"\n[project]")]);
    assert_eq!(
        value(&Scene::parse(&on_the_moon).expect("there too"), "Q"),
        16_000.0 * 1.62
    );
}

/// The mass that moves is the one that was given.
#[test]
fn gravity_of_the_top_and_of_the_dynamics_are_one() {
    let dynamics = "[luffing.dynamics]\nJ_1 = \"621000 kg.m2\"\nJ_2 = \"21000 kg.m2\"\nJ_3 = \"72000 kg.m2\"\n";
    let moving = |top: &str, own: &str| {
        changed(&[
            (r#"Q = "160 kN""#, "Q = \"16 t\"\nfidelity = \"rigid\""),
            ("[project]", &format!("{top}\n[project]")),
            ("[luffing.limits]", &format!("{dynamics}{own}\n[luffing.limits]")),
        ])
    };
    let g = "g = \"10 m/s2\"";
    for text in [moving(g, ""), moving("", g), moving(g, g)] {
        let scene = Scene::parse(&text).expect("one gravity");
        assert_eq!((value(&scene, "g"), value(&scene, "Q")), (10.0, 160e3));
    }
    let text = moving(g, "g = \"9.81 m/s2\"");
    let [mistake] = &mistakes(&text)[..] else {
        panic!("one mistake")
    };
    let top = 1 + text[..text.find(g).expect("there")].matches('\n').count();
    assert!(
        mistake.message.contains(&format!("g = 10 m/s2 in line {top}")),
        "{mistake}"
    );
    assert!(text[mistake.span.clone()].contains("9.81"), "{mistake}");
}

/// Wider than any machine, and narrow enough for kilometres in the place of metres.
#[test]
fn a_slip_of_the_unit_is_told() {
    for (old, new) in [
        (r#"X_1 = "19.3 m""#, r#"X_1 = "19300 km""#),
        (r#"X_5 = "6.4 m""#, r#"X_5 = "-6400 km""#),
        (r#"X_2 = "6.5 m""#, r#"X_2 = "0.0065 mm""#),
        (r#"Q = "160 kN""#, r#"Q = "160e9 kN""#),
        (r#"Q = "160 kN""#, r#"Q = "1e12 t""#),
        (r#"speed = "1 deg/s""#, r#"speed = "1e9 deg/s""#),
        (r#"to    = "120 deg""#, r#"to    = "1e7 deg""#),
        (r#"D_c   = "320 mm""#, r#"D_c   = "320e6 m""#),
    ] {
        let text = changed(&[(old, new)]);
        let found = mistakes(&text);
        let mistake = found.iter().find(|mistake| mistake.message.contains("it must be from"));
        let mistake = mistake.unwrap_or_else(|| panic!("{new}: {found:?}"));
        assert!(new.contains(text[mistake.span.clone()].trim_matches('"')), "{mistake}");
    }
}

/// 1e-7 km and 0.1 mm are one length, whatever the product of a number and its unit is rounded to.
#[test]
fn a_limit_in_another_unit_is_that_limit() {
    assert_ne!(1e-7 * 1e3, 1e-4);
    let refused = |length: &str| {
        let text = changed(&[(r#"X_1 = "19.3 m""#, &format!("X_1 = \"{length}\""))]);
        mistakes(&text)
            .iter()
            .any(|mistake| mistake.message.contains("it must be from"))
    };
    assert!(!refused("0.1 mm") && !refused("1e-7 km") && refused("0.9999999e-7 km"));
}

/// How far a result may be off can be as little as one likes.
#[test]
fn an_accuracy_may_be_small() {
    let text = changed(&[("[project]", "accuracy = { \"A.x\" = \"1e-15 mm\" }\n[project]")]);
    assert!(Scene::parse(&text).is_ok());
}

#[test]
fn published_rows_that_cannot_be_are_told_by_their_lines() {
    let table = DEFAULT.find("theta_1  theta_3").expect("the table");
    let end = table + DEFAULT[table..].find("\"\"\"").expect("its end");
    let with = |rows: &str| format!("{}{rows}{}", &DEFAULT[..table], &DEFAULT[end..]);
    let first = 1 + DEFAULT[..table].matches('\n').count();
    assert_eq!(
        lines(&with("theta_1 R\n60 29.98\n20 1\n\n  400 2  \n70 27.3\n")),
        [first + 2, first + 4]
    );
    assert_eq!(lines(&with("theta_1 R\r\n60 29.98\r\n20 1\r\n")), [first + 2]);
    assert_eq!(lines(&with("theta_1 R\n60 29.98\n70\n80 x\n")), [first + 2, first + 3]);
    assert_eq!(lines(&with("theta_1 S\n60 29.98\n")), [first]);
    assert_eq!(lines(&with("R theta_1\n29.98 60\n")), [first]);
    // Where escapes hide the lines, the whole text is marked.
    assert_eq!(lines(&with("theta_1 R\\n20 1")), [first - 1]);
    let text = with("theta_1 R\n20 1\n60 29.98\n");
    let [mistake] = &mistakes(&text)[..] else {
        panic!("one row")
    };
    assert_eq!(&text[mistake.span.clone()], "20 1");
}

/// A table interpolates within the working range, a publication may go beyond.
#[test]
fn published_rows_beyond_the_working_range_are_compared_at_every_level() {
    let text = changed(&[
        ("[luffing.motion]", "fidelity = \"table\"\n[luffing.motion]"),
        (r#"from  = "60 deg""#, r#"from  = "70 deg""#),
    ]);
    let scene = Scene::parse(&text).expect("closes at 60 deg too");
    assert_eq!(scene.sheet().published.len(), 61 * 6);
}

#[test]
fn texts_can_be_printed() {
    let title = r#"title.en = "Lemniscate level-luffing crane 16 t × 30 m""#;
    for wrong in [
        "",
        "   ",
        r"a\u0000b",
        r"a\u0007b",
        r"a\nb",
        r"a\r\nb",
        r"a\u2029b",
        r"a\uFEFFb",
        &"W".repeat(501),
    ] {
        let text = changed(&[(title, &format!("title.en = \"{wrong}\""))]);
        assert_eq!(mistakes(&text).len(), 1, "{wrong}");
    }
    let crane = r#"crane.en = "Lemniscate crane, 16 t at 30 m""#;
    for (entry, right) in [
        (r#"date = "2026-02-30""#, false),
        (r#"date = "2026-13-01""#, false),
        (r#"date = "2023-02-29""#, false),
        (r#"date = "2024-02-29""#, true),
        (r#"date = "30 February""#, true),
        (r#"revisions = [{ mark = "a", date = "2026-00-01" }]"#, false),
        (r#"client = "a\u0001""#, false),
        (r#"client = "two\nlines""#, true),
    ] {
        assert_eq!(mistakes(&changed(&[(crane, entry)])).is_empty(), right, "{entry}");
    }
}

#[test]
fn a_text_stands_for_the_languages_that_it_has_none_for() {
    let crane = r#"crane.en = "Lemniscate crane, 16 t at 30 m""#;
    let with = |client: &str| changed(&[(crane, &format!("client = {client}"))]);
    for (client, [en, zh, bg]) in [
        (r#""Port""#, ["Port", "Port", "Port"]),
        (
            r#"{ zh = "港", en = "Port", bg = "Пристанище" }"#,
            ["Port", "港", "Пристанище"],
        ),
        (r#"{ bg = "Пристанище", en = "Port" }"#, ["Port", "Port", "Пристанище"]),
        (r#"{ zh = "港" }"#, ["港", "港", "港"]),
    ] {
        let scene = Scene::parse(&with(client)).expect("texts");
        let (_, text) = scene.project().iter().find(|(key, _)| *key == "client").expect("given");
        assert_eq!([text.of("en"), text.of("zh"), text.of("bg")], [en, zh, bg], "{client}");
    }
    for (client, message) in [
        (r#"{ fr = "Port" }"#, "`project.client.fr` is in no language of books"),
        (r#"{ en = "Port", zh = 7 }"#, "`project.client.zh` is not a text"),
        (
            r#"{ en = "a\u0001" }"#,
            "`project.client.en` has a character that cannot be printed, U+0001",
        ),
        ("{}", "`project.client` is in no language"),
        (
            r#"["Port"]"#,
            "`project.client` is not a text, or a table of it in several languages",
        ),
    ] {
        let text = with(client);
        let found: Vec<String> = mistakes(&text).into_iter().map(|mistake| mistake.message).collect();
        assert_eq!(found, [message]);
        let line = 1 + text[..text.find("client").expect("there")].matches('\n').count();
        assert_eq!(lines(&text), [line]);
    }
}
