//! Figures and faults of one key as it plays now, measured off the tick.

use std::sync::atomic::Ordering;

use figures::action::{Figure, PianoSubject, regulation};
use keyboard::KeyIndex;
use scene::Instrument;
use telemetry::request::KeyFigure;

use super::{Answer, Reply, RequestHandler};

impl RequestHandler {
    /// Measures `key` with its present values against its instrument. The error is a sentence.
    pub(super) fn figures(&self, key: u8) -> Answer {
        let index = KeyIndex::new(key).ok_or("there is no such key, give 0 to 87")?;
        let (voice, voicing, name) = {
            let playing = self.playing();
            let voice = playing.voice(key)?.clone();
            let (voicing, name) = (&playing.voicings[index.index()], &playing.instruments);
            (voice, voicing.clone(), name[index.index()].clone())
        };
        let name = voice.file.as_ref().map(|file| file.path.clone()).or(name);
        let instrument = name.and_then(|it| Instrument::load(&self.scene.library, &it).ok());
        let expected = instrument.map(|it| it.figures).unwrap_or_default();
        let now = PianoSubject {
            name: voice.model.name,
            model: &voice.model,
            values: &|_key| voice.values.clone(),
            expected: &expected,
        };
        let voicing = voicing.ok_or("the instrument of this key is not known")?;
        let usual =
            PianoSubject { model: &voicing.model, values: &|key| voicing.values(key), ..now };
        let is_over = || self.run.background.is_over().load(Ordering::Acquire);
        let found = regulation(&now, &usual, index, &is_over)
            .ok_or("the key was not measured: the run ended")?;
        let figures = found.figures.iter().filter_map(figure).collect();
        Ok(Reply::Figures { key, figures, warnings: found.warnings })
    }
}

fn figure(it: &Figure) -> Option<KeyFigure> {
    let limit = |it: Option<f64>| it.filter(|it| it.is_finite());
    Some(KeyFigure {
        name: it.name.to_owned(),
        title: it.title.to_owned(),
        value: it.value.filter(|it| it.is_finite())?,
        low: limit(it.low),
        high: limit(it.high),
    })
}
