//! A voice that is to play on a key, and how it takes its place.

use scene::{KeyVoice, Voicing};

/// A voice that plays on a key from now on.
#[derive(Clone, Debug)]
pub(super) struct NewVoice {
    pub(super) voice: KeyVoice,
    pub(super) handover: VoiceHandover,
}

/// How a voice takes the place of the one before.
#[derive(Clone, Debug)]
pub(super) enum VoiceHandover {
    /// The voice that plays gets other values.
    Values,
    /// It begins at rest, as the voicing of what is called so says.
    Anew(Voicing, String),
    /// Other settings of `[render]` compute it, and it goes on where the old one is.
    Settings,
    /// It is of another version of the model's description, and goes on where the old one is.
    Version(Voicing),
}

impl NewVoice {
    /// Returns the voice of `key` that begins at rest, as the voicing of `name` says.
    pub(super) fn anew(voicing: &Voicing, key: u8, name: &str) -> Self {
        let voice = KeyVoice::new(voicing, key);
        Self { voice, handover: VoiceHandover::Anew(voicing.clone(), name.to_owned()) }
    }
}
