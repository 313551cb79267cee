//! Where descriptions find what they start from.

use std::path::Path;

use descriptions::{DescriptionFiles, description};
use kane::description::Bases;

/// Models of the program by their names, and files beside the description that names them.
#[derive(Debug)]
pub(super) struct FileBases<'a>(pub(super) &'a DescriptionFiles);

impl Bases for FileBases<'_> {
    fn load(&self, base: &str, from: &str) -> Result<(String, Vec<u8>), String> {
        if let Some(text) = description(base) {
            return Ok((base.to_owned(), text.as_bytes().to_vec()));
        }
        let path = Path::new(from).parent().unwrap_or_else(|| Path::new("")).join(base);
        let bytes = self.0.read(&path)?;
        Ok((path.to_string_lossy().into_owned(), bytes))
    }
}
