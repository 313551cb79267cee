use std::path::PathBuf;

use documents::shown;

/// Reason why nothing can be heard.
#[derive(Debug, thiserror::Error)]
pub enum SoundError {
    #[error(
        "there is no SoundFont in {places}: install one with sudo apt install fluid-soundfont-gm, \
         or name one with --font FILE.sf2"
    )]
    NoFont { places: String },
    #[error("the SoundFont {} cannot be read: {reason}; name another with --font", shown(.path))]
    Font { path: PathBuf, reason: String },
    #[error("there is no sound device here: give --wav FILE.wav as well")]
    NoDevice,
    #[error("the sound device cannot be opened: {0}; close other programs that use it")]
    Device(String),
    #[error("sound of {0} frames a second is not possible: 16000 to 192000 are")]
    Rate(u32),
}
