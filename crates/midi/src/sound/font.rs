//! A SoundFont: the instruments of a sampler.

use std::fs::File;
use std::io::BufReader;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rustysynth::SoundFont;

use super::SoundError;

/// Places of distributions, the best font first.
const PLACES: [&str; 6] = [
    "/usr/share/sounds/sf2/FluidR3_GM.sf2",
    "/usr/share/soundfonts/FluidR3_GM.sf2",
    "/usr/share/sounds/sf2/default-GM.sf2",
    "/usr/share/soundfonts/default.sf2",
    "/usr/share/sounds/sf2/TimGM6mb.sf2",
    "/usr/local/share/soundfonts/default.sf2",
];

/// A SoundFont in memory.
#[derive(Clone, Debug)]
pub struct Font {
    path: PathBuf,
    pub(super) font: Arc<SoundFont>,
}

impl Font {
    /// Reads the font at `path`, or the first that a distribution has installed.
    pub fn find(path: Option<&Path>) -> Result<Self, SoundError> {
        let installed = || PLACES.iter().map(Path::new).find(|it| it.is_file());
        let path = path.or_else(installed);
        let path = path.ok_or_else(|| SoundError::NoFont { places: PLACES.join(", ") })?;
        let failed = |reason: String| SoundError::Font { path: path.into(), reason };
        let mut file = BufReader::new(File::open(path).map_err(|it| failed(it.to_string()))?);
        // The reader panics on some damaged files.
        let read = catch_unwind(AssertUnwindSafe(|| SoundFont::new(&mut file)));
        let font = read.map_err(|_panic| failed("it is damaged".into()))?;
        let font = Arc::new(font.map_err(|error| failed(error.to_string()))?);
        Ok(Self { path: path.into(), font })
    }

    /// Returns the name of the file.
    pub fn name(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }
}
