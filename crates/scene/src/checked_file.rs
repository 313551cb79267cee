use std::path::Path;

use documents::Diagnostics;
use mechanism::Library;
use pianist::ChosenParts;

use super::instrument::Instrument;
use super::kind::{FileKind, describes_model, kind_of};
use super::scene::{PerformanceSource, Scene, is_midi_file};
use super::source::{SourceText, refuse};

/// Checks the scene, instrument, description of a model or MIDI file at `path`, by its contents.
///
/// # Errors
/// All mistakes in it, or that it is none of these.
pub fn check_file(library: &Library, path: &Path) -> Result<FileKind, Diagnostics> {
    if is_midi_file(path) {
        let read = PerformanceSource::Path(path.to_owned()).score(&ChosenParts::default());
        let refused = |why| refuse(path, None, why, "give another MIDI file".to_owned());
        return read.map(|_score| FileKind::Piece).map_err(refused);
    }
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
        FileKind::Model | FileKind::Piece => Ok(kind),
    }
}
