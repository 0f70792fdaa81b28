//! The default scene as an importer finds it: a resources folder, a token, value references.

use lemnis_models::model::Model;
use lemnis_models::scene::{self, Scene};
use std::ffi::CString;
use std::path::Path;
use tempfile::TempDir;

pub struct Unpacked {
    pub model: Model,
    pub token: CString,
    pub folder: TempDir,
}

impl Unpacked {
    pub fn new() -> Unpacked {
        let scene = Scene::parse(scene::DEFAULT).unwrap_or_else(|_| panic!("the default scene is valid"));
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("resources")).unwrap();
        std::fs::write(folder.path().join("resources/scene.toml"), scene.text()).unwrap();
        Unpacked {
            model: Model::new(&scene).unwrap(),
            token: CString::new(lemnis_fmu::instance::token(&scene)).unwrap(),
            folder,
        }
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    /// The resources folder as FMI 3 passes it.
    pub fn resources(&self) -> CString {
        CString::new(format!("{}/resources/", self.path().display())).unwrap()
    }

    /// Position of a variable in the model; its value reference is one more.
    pub fn index(&self, id: &str) -> usize {
        self.model
            .variables()
            .iter()
            .position(|variable| variable.symbol.id == id)
            .unwrap()
    }

    pub fn reference(&self, id: &str) -> u32 {
        self.index(id) as u32 + 1
    }
}
