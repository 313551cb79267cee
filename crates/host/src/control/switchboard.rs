//! From a request to voices on their way into the lanes.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use telemetry::request::Change;
use telemetry::{Event, Reply, Request, Update, event};

use super::tuning::CurrentVoices;
use super::{Connection, RunHandle};
use crate::observe::{self, Origin, TelemetryMessage};
use realtime::pool::{BoxedVoice, Way};
use scene::{Instrument, KeyVoice, Scene, keys_named, written};
use voice::VoiceBuilder;

/// Builds voices for a running scene and hands them to its lanes.
#[derive(Debug)]
pub struct VoiceSwitcher {
    scene: Scene,
    patchbay: Arc<RunHandle>,
    /// One change at a time, each on top of those before.
    playing: Mutex<CurrentVoices>,
    /// Where the host streams, and what it must be told.
    stream: Mutex<Option<(String, Option<String>)>>,
}

impl VoiceSwitcher {
    /// For the host that runs `scene` and opens `patchbay` while it does.
    pub fn new(scene: Scene, patchbay: Arc<RunHandle>) -> Self {
        let playing = Mutex::new(CurrentVoices::new(scene.keys.clone()));
        Self { scene, patchbay, playing, stream: Mutex::default() }
    }

    /// Says from now on that the host streams at `address`, to whoever knows `token`.
    pub fn streams_at(&self, address: String, token: Option<String>) {
        *self.stream.lock().unwrap_or_else(PoisonError::into_inner) = Some((address, token));
    }

    /// Does what `who` asks for. It is checked and built as a whole before a voice is sent.
    ///
    /// # Errors
    /// Why nothing was changed, in a sentence.
    pub fn answer(&self, request: &Request, who: &str) -> Result<Reply, String> {
        let done = match request {
            Request::Set { changes } => self.set(changes, who)?,
            Request::UseInstrument { instrument, keys } => {
                self.switch(instrument, keys.as_deref(), who)?
            }
            Request::Stop {} => return self.stop(who),
            Request::Press { key, newtons } => self.press(*key, *newtons, None)?,
            Request::Identify { line, board } => self.patchbay.identify(*line, *board)?,
            Request::Scene {} => return Ok(Reply::Scene { toml: self.written() }),
            Request::Where {} => return self.whereabouts(),
            Request::Record { file } => self.patchbay.record(file.as_deref())?,
        };
        Ok(Reply::Done { text: done })
    }

    /// The value of a parameter of each voice, in the order of keys.
    pub fn values(&self) -> Vec<Change> {
        let playing = self.playing.lock().unwrap_or_else(PoisonError::into_inner);
        let voices = (0..).zip(&playing.keys).filter_map(|(key, it)| Some((key, it.as_ref()?)));
        let of = |(key, it): (u8, &KeyVoice)| -> Vec<Change> {
            let values = it.model.parameters.iter().zip(&it.values);
            let change = |(parameter, value): (&models::Parameter, &f64)| Change {
                key,
                parameter: parameter.name.to_owned(),
                value: *value,
            };
            values.map(change).collect()
        };
        voices.flat_map(of).collect()
    }

    /// The scene as it sounds now.
    fn written(&self) -> String {
        let playing = self.playing.lock().unwrap_or_else(PoisonError::into_inner);
        written(&Scene { keys: playing.keys.clone(), ..self.scene.clone() })
    }

    fn whereabouts(&self) -> Result<Reply, String> {
        let stream = self.stream.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let (address, token) =
            stream.ok_or("this host streams nothing: start it with --listen 127.0.0.1:8765")?;
        Ok(Reply::Where { address, token })
    }

    /// Presses a simulated key for `by`.
    ///
    /// # Errors
    /// Why it is not pressed, in a sentence.
    pub(super) fn press(&self, key: u8, newtons: f64, by: Connection) -> Result<String, String> {
        self.patchbay.press(key, newtons, by)?;
        Ok(format!("key {key} is pressed with {newtons} N"))
    }

    /// What it puts voices, fingers and stops into.
    pub(super) fn patchbay(&self) -> &RunHandle {
        &self.patchbay
    }

    /// Ends the run, and waits until every board was told.
    fn stop(&self, who: &str) -> Result<Reply, String> {
        self.patchbay.emergency.ask();
        self.patchbay.log(format!("stop asked for by {who}"));
        self.patchbay.emergency.ask_and_wait()
    }

    fn set(&self, changes: &[Change], who: &str) -> Result<String, String> {
        let mut playing = self.playing.lock().unwrap_or_else(PoisonError::into_inner);
        let voices = playing.changed(changes)?;
        let n = voices.len();
        self.put_in(&mut playing, voices, None, (Way::Retune, who))?;
        Ok(format!("{} values on {n} keys", changes.len()))
    }

    fn switch(&self, name: &str, keys: Option<&str>, who: &str) -> Result<String, String> {
        let instrument = Instrument::load(name).map_err(|it| it.to_string())?;
        let Scene { tick_hz, render, .. } = &self.scene;
        if let Some(unmet) = instrument.needs.unmet(&instrument.name, *tick_hz, render) {
            return Err(format!("{}; {}", unmet.lacks, unmet.help));
        }
        let range = keys_named(keys.unwrap_or("A0..C8"))?;
        let mut playing = self.playing.lock().unwrap_or_else(PoisonError::into_inner);
        let sounding = range.filter(|key| playing.keys[usize::from(*key)].is_some());
        let voice = |key| KeyVoice { model: instrument.model(), values: instrument.values(key) };
        let voices: BTreeMap<_, _> = sounding.map(|key| (key, voice(key))).collect();
        let n = voices.len();
        self.put_in(&mut playing, voices, Some(&instrument.name), (Way::Replace, who))?;
        let text = format!("{n} keys are now {}", instrument.name);
        self.tell(&text, who);
        Ok(text)
    }

    /// Builds `voices`, tells of them, and sends them to their keys.
    fn put_in(
        &self,
        playing: &mut CurrentVoices,
        voices: BTreeMap<u8, KeyVoice>,
        instrument: Option<&str>,
        (way, who): (Way, &str),
    ) -> Result<(), String> {
        let builder = VoiceBuilder::new(&self.scene).map_err(|error| error.to_string())?;
        let mut built: Vec<(usize, BoxedVoice)> = Vec::new();
        let mut told = Vec::new();
        for (key, voice) in &voices {
            let (revision, cell) = (self.patchbay.new_revision(), self.patchbay.new_cell());
            let made = builder.numbered(voice, cell, revision);
            built.push((usize::from(*key), made.map_err(|it| it.to_string())?));
            // Values that are changed are still that instrument's.
            let before = playing.instruments[usize::from(*key)].as_deref();
            let instrument = instrument.or(before);
            let origin = Origin { revision, instrument, writer: who, kept: way == Way::Retune };
            told.push(observe::voice(*key, voice, origin));
        }
        self.patchbay.send(built, way, told)?;
        for (key, voice) in voices {
            let key = usize::from(key);
            playing.keys[key] = Some(voice);
            if let Some(name) = instrument {
                playing.instruments[key] = Some(name.to_owned());
            }
        }
        Ok(())
    }

    /// Tells those who watch that `who` did something.
    fn tell(&self, text: &str, who: &str) {
        let event = Event {
            kind: event::Kind::Change.into(),
            key: observe::NO_KEY,
            text: format!("{who}: {text}"),
            ..Event::default()
        };
        self.patchbay.tell(TelemetryMessage::Update(Box::new(Update::Event(event))));
    }
}
