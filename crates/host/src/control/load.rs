//! Descriptions that are read while the host plays: their newest versions take over.
//!
//! All of it is off the tick: a description is read, checked, derived and compiled on the calling
//! thread, and its voices are built there. A mistake changes nothing. Descriptions load one at a
//! time, and none for a client that has disconnected.

use std::{collections::BTreeSet, path::Path};

use std::sync::Arc;

use documents::escaped;
use instruments::{FileContents, LoadedModel};
use keyboard::KeyRange;
use mechanism::rendered;
use scene::{Render, Scene};
use telemetry::{Log, Update, log};

use super::description_states::{DescriptionStates, known_path};
use super::{FingerOwner, RequestHandler, current_voices::CurrentVoices, run_status::nanos_now};
use crate::observe::{self, TelemetryMessage};

#[derive(Debug)]
enum LoadError {
    Mistakes(String),
    Refused(String),
}

impl RequestHandler {
    /// Reads the description at `file` and plays its newest version: on `keys`, or else on those
    /// that play another version of it.
    ///
    /// # Errors
    /// All mistakes with lines and carets, or the reason why it cannot be put in now.
    pub(super) fn load(
        &self,
        file: &str,
        keys: Option<&str>,
        (who, by): (&str, FingerOwner),
    ) -> Result<String, String> {
        let range = keys.map(KeyRange::parse).transpose().map_err(|it| it.to_string())?;
        range.map(|range| self.playing().keys_in(range)).transpose()?;
        let path = known_path(file);
        let load = |is_cancelled: &_| self.scene.library.try_load(Path::new(&path), is_cancelled);
        let (contents, read) = self.run.background.load(by, load)?;
        let read = read.map_err(|mistakes| LoadError::Mistakes(rendered(&mistakes)));
        let played = read.and_then(|model| self.play(&model, (range, &path, &contents), who));
        match played {
            Ok(text) => Ok(text),
            Err(LoadError::Refused(why)) => Err(why),
            Err(LoadError::Mistakes(mistakes)) => {
                self.note_mistakes(&path, contents, &mistakes);
                Err(mistakes)
            }
        }
    }

    fn play(
        &self,
        model: &Arc<LoadedModel>,
        (range, path, contents): (Option<KeyRange>, &str, &FileContents),
        who: &str,
    ) -> Result<String, LoadError> {
        let mut playing = self.playing();
        let voices = playing.loaded(model, range).map_err(LoadError::Mistakes)?;
        let n = voices.len();
        let mut states = self.states().clone();
        states.note_read(path, contents.clone(), "");
        if 0 < n {
            states.note_playing(model, nanos_now());
        }
        // The present models are sent as well, since a recording may begin in between.
        let models = observe::distinct(playing.models().iter().chain([model]));
        let catalogue = self.catalogue(playing.render, &models, &states);
        self.put_in(&mut playing, voices, Some(catalogue), who).map_err(LoadError::Refused)?;
        *self.states() = states;
        let version = model.version();
        let keys = if n == 0 { "the same keys".to_owned() } else { format!("{n} keys") };
        let text = format!("{keys} play version {version} of {} ({})", model.name, escaped(path));
        self.tell(&text, who);
        Ok(text)
    }

    fn note_mistakes(&self, path: &str, contents: FileContents, mistakes: &str) {
        let playing = self.playing();
        if !playing.models().iter().any(|model| model.file() == Some(path)) {
            return;
        }
        let mut states = self.states();
        states.note_read(path, contents, mistakes);
        self.run.tell(self.catalogue(playing.render, &playing.models(), &states));
        let text =
            format!("{} is wrong, and the version before it plays on:\n{mistakes}", escaped(path));
        let entry = Log { level: log::Level::Error.into(), text };
        self.run.tell(TelemetryMessage::Update(Box::new(Update::Log(entry))));
    }

    pub(super) fn send_catalogue(&self) {
        let playing = self.playing();
        self.run.tell(self.catalogue(playing.render, &playing.models(), &self.states()));
    }

    pub(super) fn begin_to_watch(&self) {
        self.states().is_watched = true;
        self.send_catalogue();
    }

    pub(super) fn described_files(&self) -> Vec<(String, FileContents)> {
        let models = self.playing().models();
        let states = self.states();
        let mut seen = BTreeSet::new();
        let newest = models.iter().rev().filter_map(|model| Some((model.file()?, model)));
        let newest = newest.filter(|(file, _model)| seen.insert(*file));
        let files =
            newest.filter_map(|(file, model)| Some((file.to_owned(), states.contents(model)?)));
        files.collect()
    }

    /// Returns the catalogue with a model that joins those of `playing`, unless clients know it.
    pub(super) fn catalogue_with(
        &self,
        playing: &CurrentVoices,
        model: &Arc<LoadedModel>,
    ) -> Option<TelemetryMessage> {
        let played = playing.models();
        let with = observe::distinct(played.iter().chain([model]));
        (played.len() < with.len()).then(|| self.catalogue(playing.render, &with, &self.states()))
    }

    pub(super) fn catalogue(
        &self,
        render: Render,
        models: &[Arc<LoadedModel>],
        states: &DescriptionStates,
    ) -> TelemetryMessage {
        let mut catalogue = observe::catalogue(&Scene { render, ..self.scene.clone() }, models);
        states.complete(&mut catalogue.descriptions);
        catalogue.instruments.extend(self.own_entries());
        TelemetryMessage::Catalogue(Box::new(catalogue))
    }
}
