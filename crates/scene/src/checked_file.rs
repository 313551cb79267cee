//! The check of a file of any kind.

use std::path::Path;

use documents::Diagnostics;
use mechanism::Library;

use super::instrument::Instrument;
use super::kind::{FileKind, describes_model, kind_of};
use super::scene::Scene;
use super::source::SourceText;

/// Checks the scene, the instrument or the description of a model at `path`, whichever it is by
/// what stands in it.
///
/// # Errors
///
/// All that is wrong with it, or that it is neither.
pub fn check_file(library: &Library, path: &Path) -> Result<FileKind, Diagnostics> {
    let source = SourceText::read(path)?;
    if describes_model(&source) {
        return library.load(path).map(|_model| FileKind::Model);
    }
    check(library, &source)
}

/// Checks a text as [`check_file`] does.
pub(super) fn check(library: &Library, source: &SourceText) -> Result<FileKind, Diagnostics> {
    let kind = kind_of(source)?;
    match kind {
        FileKind::Scene => Scene::check(library, source, &[]).map(|_scene| kind),
        FileKind::Instrument => Instrument::check(library, source).map(|_instrument| kind),
        // What only a text is has no place from which it could be loaded.
        FileKind::Model => Ok(kind),
    }
}
