use telemetry::Voice;

use super::{TelemetryMessage, probe};
use scene::{Instrument, KeyVoice};

/// The origin of a voice.
#[derive(Clone, Copy, Debug)]
pub struct Origin<'a> {
    pub revision: u32,
    /// The instrument of its values; found by its values if it is not known.
    pub instrument: Option<&'a str>,
    pub writer: &'a str,
    /// `true` if the state of the one before is kept.
    pub kept: bool,
}

/// Returns the message about `voice` on `key`, which is sent before it is put in.
pub fn voice(key: u8, voice: &KeyVoice, origin: Origin<'_>) -> TelemetryMessage {
    let probe = probe(&voice.model, &voice.values);
    let instrument = origin.instrument.map(str::to_owned);
    let message = Voice {
        key: key.into(),
        revision: origin.revision,
        model: voice.model.name.to_owned(),
        instrument: instrument.or_else(|| instrument_of(key, voice)).unwrap_or_default(),
        values: voice.values.clone(),
        writer: origin.writer.to_owned(),
        drawing: Some(probe.drawing()),
        kept: origin.kept,
        version: voice.model.version(),
    };
    TelemetryMessage::Voice(Box::new(message), Some(probe))
}

/// Returns the name of the file or embedded instrument with the values of `voice` on `key`.
pub fn instrument_of(key: u8, voice: &KeyVoice) -> Option<String> {
    if let Some(file) = &voice.file {
        return Some(file.name.clone());
    }
    let bits = |values: &[f64]| values.iter().map(|it| it.to_bits()).collect::<Vec<_>>();
    let wanted = bits(&voice.values);
    let of_its_model = Instrument::of_model(&voice.model).into_iter();
    of_its_model.filter(|it| bits(&it.values(key)) == wanted).map(|it| it.name.clone()).next()
}
