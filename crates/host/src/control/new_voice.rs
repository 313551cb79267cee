use scene::{KeyVoice, Voicing};

#[derive(Clone, Debug)]
pub(super) struct NewVoice {
    pub(super) voice: KeyVoice,
    pub(super) handover: VoiceHandover,
}

/// Relation of a voice to the one before.
#[derive(Clone, Debug)]
pub(super) enum VoiceHandover {
    /// New values of the playing voice.
    Values,
    /// A start from rest, with this voicing and its name.
    Anew(Voicing, String),
    /// Other settings of `[render]`, continuing from the old state.
    Settings,
    /// Another version of the model's description, continuing from the old state.
    Version(Voicing),
}

impl NewVoice {
    pub(super) fn anew(voicing: &Voicing, key: u8, name: &str) -> Self {
        let voice = KeyVoice::new(voicing, key);
        Self { voice, handover: VoiceHandover::Anew(voicing.clone(), name.to_owned()) }
    }
}
