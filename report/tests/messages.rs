//! Every wrong scene of `tests/messages/` is explained in the transcript beside it.
//! `TRYCMD=overwrite` writes them anew; read them aloud before committing.

use std::path::Path;

use trycmd::TestCases;

#[test]
fn wrong_scenes_are_explained() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/messages");
    let described = std::fs::read_to_string(folder.join("scenes.trycmd")).expect("the transcript");
    for entry in std::fs::read_dir(folder.join("scenes.in")).expect("there") {
        let name = entry.expect("readable").file_name().into_string().expect("ASCII");
        assert!(
            ["check", "sweep", "synth"]
                .iter()
                .any(|command| described.contains(&format!("$ lemnis {command} {name}\n"))),
            "{name} has no message in scenes.trycmd"
        );
    }
    TestCases::new().case(folder.join("*.trycmd")).run();
}
