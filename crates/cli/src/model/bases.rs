//! Where descriptions find what they start from.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use kane::description::Bases;
use models::descriptions::description;

/// Models of the program by their names, and files beside the description that names them.
#[derive(Debug, Default)]
pub(super) struct FileBases {
    /// The files that were read.
    files: RefCell<Vec<PathBuf>>,
}

impl FileBases {
    /// Returns the files that were read.
    pub(super) fn into_files(self) -> Vec<PathBuf> {
        self.files.into_inner()
    }
}

impl Bases for FileBases {
    fn load(&self, base: &str, from: &str) -> Result<(String, Vec<u8>), String> {
        if let Some(text) = description(base) {
            return Ok((base.to_owned(), text.as_bytes().to_vec()));
        }
        let path = Path::new(from).parent().unwrap_or_else(|| Path::new("")).join(base);
        let bytes = std::fs::read(&path).map_err(|error| error.to_string())?;
        let name = path.display().to_string();
        self.files.borrow_mut().push(path);
        Ok((name, bytes))
    }
}
