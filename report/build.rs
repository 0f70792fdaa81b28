//! Lists the files of words, so that a new component's are found where they lie.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn inside(folder: &Path) -> Vec<PathBuf> {
    println!("cargo::rerun-if-changed={}", folder.display());
    let entries = fs::read_dir(folder).expect("a folder of words");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    paths.sort();
    paths
}

fn main() {
    // Build scripts run in the folder of their package.
    let root = Path::new("../templates/words");
    let mut list = String::from("&[");
    for language in inside(root) {
        for file in inside(&language) {
            let name = file
                .strip_prefix(root)
                .expect("inside")
                .to_string_lossy()
                .replace('\\', "/");
            let text = format!("include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/../templates/words/{name}\"))");
            let _ = writeln!(list, "(\"words/{name}\", {text}),");
        }
    }
    list.push(']');
    let folder = env::var_os("OUT_DIR").expect("set by cargo");
    fs::write(Path::new(&folder).join("words.rs"), list).expect("writable");
}
