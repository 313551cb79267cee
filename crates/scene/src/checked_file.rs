use std::path::Path;

use documents::Diagnostics;
use mechanism::Library;

use super::instrument::Instrument;
use super::kind::{FileKind, describes_model, kind_of};
use super::scene::Scene;
use super::source::SourceText;

/// Checks the scene, instrument or description of a model at `path`, with the kind found by its
/// contents.
///
/// # Errors
/// All mistakes in it, or that it is none of these.
pub fn check_file(library: &Library, path: &Path) -> Result<FileKind, Diagnostics> {
    let source = SourceText::read(path)?;
    if describes_model(&source) {
        return library.load(path).map(|_model| FileKind::Model);
    }
    check(library, &source)
}

/// Like [`check_file`], but with the text of the file.
pub(super) fn check(library: &Library, source: &SourceText) -> Result<FileKind, Diagnostics> {
    let kind = kind_of(source)?;
    match kind {
        FileKind::Scene => Scene::check(library, source, &[]).map(|_scene| kind),
        FileKind::Instrument => Instrument::check(library, source).map(|_instrument| kind),
        // A text without a file has no path from which it could be loaded.
        FileKind::Model => Ok(kind),
    }
}
