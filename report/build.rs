//! Lists the files of words and the ready scenes, so that a new one is found where it lies.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn inside(folder: &Path) -> Vec<PathBuf> {
    println!("cargo::rerun-if-changed={}", folder.display());
    let entries = fs::read_dir(folder).expect("a folder of words or scenes");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    paths.sort();
    paths
}

/// Pairs of a name and a file's text, as Rust writes them.
fn list(target: &str, files: impl Iterator<Item = (String, PathBuf)>) {
    let mut list = String::from("&[");
    for (name, file) in files {
        let file = file.to_string_lossy().replace('\\', "/");
        let text = format!("include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/{file}\"))");
        let _ = writeln!(list, "(\"{name}\", {text}),");
    }
    list.push(']');
    let folder = env::var_os("OUT_DIR").expect("set by cargo");
    fs::write(Path::new(&folder).join(target), list).expect("writable");
}

fn main() {
    // Build scripts run in the folder of their package.
    let root = Path::new("../templates");
    let words = inside(&root.join("words"))
        .into_iter()
        .flat_map(|language| inside(&language));
    let named = |file: PathBuf| {
        let name = file.strip_prefix(root).expect("inside").to_string_lossy();
        (name.replace('\\', "/"), file)
    };
    list("words.rs", words.map(named));
    let scenes = inside(Path::new("../models/scenes"));
    let named = |file: PathBuf| (file.file_stem().expect("a file").to_string_lossy().into_owned(), file);
    list("scenes.rs", scenes.into_iter().map(named));
}
