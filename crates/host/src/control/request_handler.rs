//! Checks requests, builds their answers, and sends changes by the [`RunHandle`].

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::{collections::BTreeMap, net::SocketAddr, path::Path};

use engine::realtime::pool::{BoxedVoice, VoiceChange};
use engine::voice::VoiceBuilder;
use haptics::HandCommand;
use scene::{Instrument, KeyVoice, Scene, is_description, written};
use scheduler::values::ModelValues;
use telemetry::stream::{Backend, ParameterSetting, Who};
use telemetry::{Event, Reply, Request, Update, event, key_name, request::Change};

use super::current_voices::{CurrentVoices, is_absent, single};
use super::description_states::DescriptionStates;
use super::folders::{Overwriting, is_embedded};
use super::new_voice::{NewVoice, VoiceHandover};
use super::{Answer, Answers, FingerOwner, Folders, RunHandle};
use crate::observe::{self, Origin, TelemetryMessage};
use figures::stability::instabilities;
use keyboard::KeyRange;

const ALL_KEYS: &str = "A0..C8";

/// Answers requests to the host that runs a scene.
///
/// Requests come from this user's control socket ([`Answers`]) and from clients of the stream
/// ([`Backend`]), which may name files in certain folders only.
#[derive(Debug)]
pub struct RequestHandler {
    pub(super) scene: Scene,
    pub(super) run: Arc<RunHandle>,
    pub(super) folders: Folders,
    /// Voices after the last change, on which the next change builds.
    playing: Mutex<CurrentVoices>,
    /// Descriptions that were read while they play; locked after the voices.
    states: Mutex<DescriptionStates>,
    own_instruments: Mutex<BTreeMap<String, Arc<Instrument>>>,
    stream: Option<StreamAddress>,
}

/// Address of a host's stream.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct StreamAddress {
    /// URL, with the fingerprint of a self-made certificate after `#`.
    pub url: String,
    /// Secret of an owner, if clients need one.
    pub token: Option<String>,
}

impl RequestHandler {
    /// Answers for a host without a stream that runs `scene`; its clients name files in `folders`.
    pub fn new(scene: Scene, run: Arc<RunHandle>, folders: Folders) -> Self {
        let playing = Mutex::new(CurrentVoices::new(&scene));
        let own_instruments = Mutex::default();
        Self {
            scene,
            run,
            folders,
            playing,
            states: Mutex::default(),
            own_instruments,
            stream: None,
        }
    }

    pub fn with_stream(
        scene: Scene,
        run: Arc<RunHandle>,
        folders: Folders,
        stream: Option<StreamAddress>,
    ) -> Self {
        Self { stream, ..Self::new(scene, run, folders) }
    }

    /// Handles the request of `who`. It is checked and built as a whole before any of it is sent.
    ///
    /// # Errors
    /// A sentence why nothing was changed.
    pub fn answer(&self, request: &Request, who: &str) -> Answer {
        self.answer_to(request, who, None)
    }

    fn answer_to(&self, request: &Request, who: &str, by: FingerOwner) -> Answer {
        let done = match request {
            Request::Set { changes } => self.set(changes, who)?,
            Request::Render { settings } => self.change_settings(settings, who)?,
            Request::UseInstrument { instrument, keys } => {
                self.switch(instrument, keys.as_deref(), (who, by))?
            }
            Request::FollowBase { instrument, keys } => {
                self.follow_base(instrument, keys.as_deref(), (who, by))?
            }
            Request::SaveInstrument { name, base, differences, overwrite } => {
                let overwriting =
                    if *overwrite { Overwriting::Allowed } else { Overwriting::Refused };
                self.save_instrument((name, base), (differences, overwriting), (who, by))?
            }
            Request::Load { description, keys } => {
                self.load(description, keys.as_deref(), (who, by))?
            }
            Request::Stop {} => return self.stop(who),
            Request::Press { key, newtons } => {
                self.press(*key, HandCommand::Weight(*newtons), by)?;
                let decimals = if *newtons < 10.0 { 2 } else { 1 };
                format!("{} is pressed with {newtons:.decimals$} N", key_name((*key).into()))
            }
            Request::Grip { key, depth } => {
                self.press(*key, depth.map_or(HandCommand::AWAY, HandCommand::Grip), by)?;
                let key = key_name((*key).into());
                match depth {
                    Some(depth) => format!("{key} is held at {depth:.3} times its dip"),
                    None => format!("{key} is let go"),
                }
            }
            Request::Margin { key } => self.margin(*key)?,
            Request::Figures { key } => return self.figures(*key),
            Request::Identify { line, board } => self.run.identify(*line, *board)?,
            Request::Scene {} => return Ok(Reply::Scene { toml: self.written() }),
            Request::Where {} => return self.whereabouts(),
            Request::Status {} => {
                return Ok(Reply::Status { status: Box::new(self.run.status.examine()) });
            }
            Request::Record { file } => self.run.record(file.as_deref(), self.folders.limits)?,
        };
        Ok(Reply::Done { text: done })
    }

    /// Returns the present scene. Keys without a board have their initial voices.
    fn written(&self) -> String {
        let playing = self.playing();
        let mut scene = self.scene_of(&playing);
        for ((key, voice), voicing) in (0..).zip(&mut scene.keys).zip(&playing.voicings) {
            let first = || Some(KeyVoice::new(voicing.as_ref()?, key));
            *voice = voice.take().or_else(first);
        }
        written(&scene)
    }

    pub(super) fn scene_of(&self, playing: &CurrentVoices) -> Scene {
        Scene { render: playing.render, keys: playing.keys.clone(), ..self.scene.clone() }
    }

    fn whereabouts(&self) -> Answer {
        let StreamAddress { url, token } = self
            .stream
            .clone()
            .ok_or("this host streams nothing: start it with --listen 127.0.0.1:8765")?;
        Ok(Reply::Where { address: url, token })
    }

    /// Ends the run, and waits until every board received the stop.
    fn stop(&self, who: &str) -> Answer {
        self.run.emergency.ask();
        self.run.background.cancel_all();
        self.run.log(format!("stop asked for by {who}"));
        self.run.emergency.ask_and_wait()
    }

    fn press(&self, key: u8, hand: HandCommand, by: FingerOwner) -> Result<(), String> {
        let range = single(key)?;
        if is_absent(&self.scene, key.into()) {
            return Err(format!("no board carries {range}"));
        }
        self.run.press(key, hand, by)
    }

    fn set(&self, changes: &[Change], who: &str) -> Result<String, String> {
        let mut playing = self.playing();
        let voices = playing.changed(changes)?;
        let n = voices.len();
        let description = playing.described(changes);
        let only = voices.keys().next().copied().filter(|_| n == 1);
        self.put_in(&mut playing, voices, None, who)?;
        if let Some((text, count)) = description {
            let key = only.map_or(observe::NO_KEY, u32::from);
            self.run.tell(changed(Event { key, to: count, text, ..Event::default() }, who));
        }
        Ok(format!("{} values on {n} keys", changes.len()))
    }

    fn switch(
        &self,
        name: &str,
        keys: Option<&str>,
        (who, by): (&str, FingerOwner),
    ) -> Result<String, String> {
        if is_description(Path::new(name)) {
            return self.load(name, keys.or(Some(ALL_KEYS)), (who, by));
        }
        let instrument = self.load_instrument(name, by)?;
        self.play_instrument(&instrument, (name, keys), who)
    }

    fn follow_base(
        &self,
        name: &str,
        keys: Option<&str>,
        (who, by): (&str, FingerOwner),
    ) -> Result<String, String> {
        let instrument = self.load_instrument(name, by)?.on_present_base();
        let instrument = instrument.map_err(|it| format!("{name} cannot follow its base: {it}"))?;
        self.play_instrument(&instrument, (name, keys), who)
    }

    fn play_instrument(
        &self,
        instrument: &Instrument,
        (name_or_path, keys): (&str, Option<&str>),
        who: &str,
    ) -> Result<String, String> {
        let range = keys.map_or(Ok(KeyRange::ALL), KeyRange::parse).map_err(|it| it.to_string())?;
        let keys = self.playing().keys_in(range)?;
        self.refuse_unfit(instrument, &keys)?;
        let mut playing = self.playing();
        let is_own = !is_embedded(name_or_path);
        if is_own {
            let own = Arc::new(instrument.clone());
            self.own_instruments().insert(instrument.name.clone(), own);
        }
        let voice = |key| NewVoice::anew(&instrument.voicing, key, &instrument.name);
        let voices: BTreeMap<_, _> = keys.into_iter().map(|key| (key, voice(key))).collect();
        let n = voices.len();
        let listed = || self.catalogue(playing.render, &playing.models(), &self.states());
        let catalogue = self.catalogue_with(&playing, instrument.model());
        let catalogue = catalogue.or_else(|| is_own.then(listed));
        self.put_in(&mut playing, voices, catalogue, who)?;
        let text = format!("{n} keys are now {}", instrument.name);
        self.tell(&text, who);
        Ok(text)
    }

    /// Checks the needs of `instrument` and tries it on some of `keys`, off the tick.
    pub(super) fn refuse_unfit(&self, instrument: &Instrument, keys: &[u8]) -> Result<(), String> {
        let mut scene = self.scene_of(&self.playing());
        let needs = &instrument.needs;
        if let Some(unmet) = needs.unmet(&instrument.name, scene.tick_hz, &scene.render) {
            return Err(unmet.to_string());
        }
        scene.keys.fill(None);
        for key in keys {
            scene.keys[usize::from(*key)] = Some(KeyVoice::new(&instrument.voicing, *key));
        }
        let unstable = instabilities(&scene).map_err(|it| it.to_string())?;
        unstable.into_iter().next().map_or(Ok(()), Err)
    }

    pub(super) fn put_in(
        &self,
        playing: &mut CurrentVoices,
        voices: BTreeMap<u8, NewVoice>,
        catalogue: Option<TelemetryMessage>,
        who: &str,
    ) -> Result<(), String> {
        let scene = self.scene_of(playing);
        let builder = VoiceBuilder::new(&scene).map_err(|error| error.to_string())?;
        let mut changes = Vec::new();
        let mut messages: Vec<_> = catalogue.into_iter().collect();
        for (key, new) in &voices {
            let index = usize::from(*key);
            let revision = self.run.new_revision();
            changes.push((index, self.change(&builder, new, revision)?));
            // Changed values still belong to that instrument.
            let (instrument, kept) = match &new.handover {
                VoiceHandover::Anew(_voicing, name) => (Some(name), false),
                VoiceHandover::Values | VoiceHandover::Version(_) | VoiceHandover::Settings => {
                    (playing.instruments[index].as_ref(), true)
                }
            };
            let instrument = instrument.map(String::as_str);
            let origin = Origin { revision, instrument, writer: who, kept };
            messages.push(observe::voice(*key, &new.voice, origin));
        }
        self.run.send(changes, messages)?;
        playing.put_in(voices);
        Ok(())
    }

    fn change(
        &self,
        builder: &VoiceBuilder<'_>,
        new: &NewVoice,
        revision: u32,
    ) -> Result<VoiceChange, String> {
        let built = || {
            let built = builder.numbered(&new.voice, self.run.new_cell(), revision);
            built.map(|voice| voice as BoxedVoice).map_err(|error| error.to_string())
        };
        match &new.handover {
            VoiceHandover::Values => retuning(&new.voice, revision),
            VoiceHandover::Anew(..) => built().map(VoiceChange::Replace),
            VoiceHandover::Version(_) | VoiceHandover::Settings => {
                built().map(VoiceChange::Succeed)
            }
        }
    }

    pub(super) fn tell(&self, text: &str, who: &str) {
        let text = text.to_owned();
        self.run.tell(changed(Event { key: observe::NO_KEY, text, ..Event::default() }, who));
    }

    pub(super) fn playing(&self) -> MutexGuard<'_, CurrentVoices> {
        self.playing.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn own_instruments(&self) -> MutexGuard<'_, BTreeMap<String, Arc<Instrument>>> {
        self.own_instruments.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn states(&self) -> MutexGuard<'_, DescriptionStates> {
        self.states.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns `request` with the paths of the files that a client of the stream may name.
    fn confined(&self, request: Request) -> Result<Request, String> {
        Ok(match request {
            Request::UseInstrument { instrument, keys } => {
                Request::UseInstrument { instrument: self.folders.instrument(&instrument)?, keys }
            }
            Request::FollowBase { instrument, keys } => {
                Request::FollowBase { instrument: self.folders.instrument(&instrument)?, keys }
            }
            Request::Load { description, keys } => {
                let plays = self.playing().plays(&description);
                let file =
                    if plays { description } else { self.folders.description(&description)? };
                Request::Load { description: file, keys }
            }
            Request::Record { file: Some(file) } => {
                Request::Record { file: Some(self.folders.recording(&file)?) }
            }
            Request::Record { file: None }
            | Request::Set { .. }
            | Request::SaveInstrument { .. }
            | Request::Render { .. }
            | Request::Stop {}
            | Request::Press { .. }
            | Request::Grip { .. }
            | Request::Margin { .. }
            | Request::Figures { .. }
            | Request::Identify { .. }
            | Request::Scene {}
            | Request::Where {}
            | Request::Status {} => request,
        })
    }
}

/// Returns the message that `who` made a change; the telemetry thread sets its tick.
fn changed(event: Event, who: &str) -> TelemetryMessage {
    let (kind, text) = (event::Kind::Change.into(), format!("{who}: {}", event.text));
    TelemetryMessage::Update(Box::new(Update::Event(Event { kind, text, ..event })))
}

fn retuning(voice: &KeyVoice, revision: u32) -> Result<VoiceChange, String> {
    let values = ModelValues::new(voice.model.id(), revision, &voice.values);
    let many = || format!("{} has too many parameters to be changed", voice.model.name);
    values.map(VoiceChange::Retune).ok_or_else(many)
}

impl Answers for RequestHandler {
    fn reply_to(&self, request: &Request, connection: u64) -> Answer {
        let who = if matches!(request, Request::Stop {}) { "`letoff stop`" } else { "letoff" };
        self.answer_to(request, who, Some(connection))
    }

    fn left(&self, connection: u64) {
        self.run.leave(connection);
    }
}

impl Backend for RequestHandler {
    fn parameters(&self, names: Option<&[String]>) -> Vec<ParameterSetting> {
        let playing = self.playing();
        let Some(names) = names else { return playing.settings() };
        names.iter().filter_map(|name| playing.setting(name)).collect()
    }

    fn ask(&self, request: Request, who: &Who) -> Answer {
        let request = self.confined(request)?;
        self.answer_to(&request, &who.to_string(), Some(who.number))
    }

    fn metrics(&self) -> Option<String> {
        Some(telemetry::metrics::metrics(&self.run.status.read(), env!("CARGO_PKG_VERSION")))
    }

    fn connected(&self, who: &Who) {
        self.run.status.client_came();
        self.run.log(format!("{who} has come"));
    }

    fn disconnected(&self, who: &Who) {
        self.run.leave(who.number);
        self.run.status.client_left();
        self.run.log(format!("{who} has gone"));
    }

    fn refused(&self, address: SocketAddr, why: &str) {
        self.run.log(format!("a client at {} was turned away: {why}", address.ip()));
    }
}
