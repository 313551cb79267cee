//! A recording as tables.

mod columns;
mod table;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use self::columns::{EVENTS, fault, flags, header, mode, seconds};
use self::table::CsvTable;
use super::error::{ExportError, ReadError};
use super::reader::Recording;
use super::rows::{Row, rows};
use crate::{Catalogue, Event, KEYS, KeyBlock, Model, Topic, Update, Voice};

/// Selection of a recording for tables.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Selection {
    pub keys: BTreeSet<u8>,
    /// Messages from this time on (ns since 1970).
    pub from: u64,
    /// Messages before this time (ns since 1970).
    pub to: u64,
}

impl Default for Selection {
    fn default() -> Self {
        Self { keys: (0..=u8::MAX).take(KEYS).collect(), from: 0, to: u64::MAX }
    }
}

/// Result of an export.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Exported {
    pub files: Vec<PathBuf>,
    pub rows: u64,
    pub events: u64,
    /// Damage that prevented reading, a sentence each.
    pub wrong: Vec<String>,
}

/// Writes `key-<n>.csv` for each key that has rows, and `events.csv`, into `folder`.
///
/// A row is a tick in which anything changed; `t` counts from tick 0. A key whose model changes
/// continues in `key-<n>-2.csv`, because its columns differ.
///
/// # Errors
/// A table exists already or cannot be written, or the recording has no catalogue.
pub fn export_csv(
    recording: &Recording,
    folder: &Path,
    selection: &Selection,
) -> Result<Exported, ExportError> {
    let mut tables = CsvTables::new(recording, folder, selection)?;
    let blocks = selection.keys.iter().map(|key| Topic::Block(*key));
    let topics = blocks.chain([Topic::Events, Topic::Voices]).collect();
    for message in recording.read(selection.from, selection.to, &topics) {
        match message {
            Ok((_, Update::Block(block))) => tables.block(&block)?,
            Ok((_, Update::Event(event))) => tables.event(&event)?,
            Ok((_, Update::Voice(voice))) => tables.note(&voice),
            Ok(_) => {}
            Err(error) => tables.say(&error),
        }
    }
    tables.finish()
}

struct KeyTable {
    table: CsvTable,
    header: Vec<String>,
    number: u32,
}

struct CsvTables {
    folder: PathBuf,
    catalogue: Catalogue,
    /// Models by their names and versions.
    models: BTreeMap<(String, u32), Rc<Model>>,
    revisions: BTreeMap<(u32, u32), Rc<Model>>,
    current: BTreeMap<u32, Rc<Model>>,
    keys: BTreeMap<u32, KeyTable>,
    events: CsvTable,
    done: Exported,
}

impl CsvTables {
    fn new(
        recording: &Recording,
        folder: &Path,
        selection: &Selection,
    ) -> Result<Self, ExportError> {
        let catalogue = recording.catalogue()?.filter(|catalogue| catalogue.tick_hz > 0);
        let nothing = || ExportError::NoCatalogue(recording.path().to_owned());
        let catalogue = catalogue.ok_or_else(nothing)?;
        let mut tables = Self {
            folder: folder.to_owned(),
            models: models(&catalogue),
            catalogue,
            revisions: BTreeMap::new(),
            current: BTreeMap::new(),
            keys: BTreeMap::new(),
            events: CsvTable::create(folder.join("events.csv"), &EVENTS.map(str::to_owned))?,
            done: Exported::default(),
        };
        tables.note_revisions(recording);
        match recording.voices_at(selection.from.max(start(recording))) {
            Ok(voices) => voices.iter().for_each(|(_, voice)| tables.note(voice)),
            Err(error) => tables.say(&error),
        }
        Ok(tables)
    }

    /// Collects the model of each voice: a voice may come after its first rows.
    fn note_revisions(&mut self, recording: &Recording) {
        let topics = BTreeSet::from([Topic::Catalogue, Topic::Voices]);
        for message in recording.read(0, u64::MAX, &topics) {
            match message {
                Ok((_, Update::Catalogue(catalogue))) => self.models.extend(models(&catalogue)),
                Ok((_, Update::Voice(voice))) => {
                    let model = self.model_of(&voice);
                    self.revisions.insert((voice.key, voice.revision), model);
                }
                // Damage is reported when its rows are read.
                Ok(_) | Err(_) => {}
            }
        }
    }

    fn say(&mut self, error: &ReadError) {
        let text = error.to_string();
        if !self.done.wrong.contains(&text) {
            self.done.wrong.push(text);
        }
    }

    fn note(&mut self, voice: &Voice) {
        let model = self.model_of(voice);
        self.current.insert(voice.key, model);
    }

    fn block(&mut self, block: &KeyBlock) -> Result<(), ExportError> {
        let widths: BTreeMap<u32, usize> = block
            .revision
            .iter()
            .map(|revision| (*revision, self.model(block.key, *revision).signals.len()))
            .collect();
        let width = |revision: u32| widths.get(&revision).copied().unwrap_or(0);
        for row in rows(block, width) {
            self.row(block.key, &row)?;
        }
        Ok(())
    }

    fn row(&mut self, key: u32, row: &Row<'_>) -> Result<(), ExportError> {
        let model = self.model(key, row.revision);
        let mut fields = vec![
            seconds(&self.catalogue, row.tick, 0.0).to_string(),
            row.tick.to_string(),
            row.position.to_string(),
            row.force.to_string(),
            row.sent.to_string(),
            mode(&model, u32::from(row.mode)),
            flags(row.flags),
            fault(row.fault),
        ];
        fields.extend(row.signals.iter().map(ToString::to_string));
        self.key_table(key, &model)?.table.row(&fields)?;
        self.done.rows += 1;
        Ok(())
    }

    fn key_table(&mut self, key: u32, model: &Model) -> Result<&mut KeyTable, ExportError> {
        let header = header(model);
        let number = match self.keys.get(&key) {
            Some(table) if table.header == header => None,
            Some(table) => Some(table.number + 1),
            None => Some(1),
        };
        if let Some(number) = number {
            let name = match number {
                1 => format!("key-{key}.csv"),
                _ => format!("key-{key}-{number}.csv"),
            };
            let table = CsvTable::create(self.folder.join(name), &header)?;
            let old = self.keys.insert(key, KeyTable { table, header, number });
            self.close(old.map(|old| old.table))?;
        }
        let nothing = || ExportError::Exists(self.folder.clone());
        self.keys.get_mut(&key).ok_or_else(nothing)
    }

    fn event(&mut self, event: &Event) -> Result<(), ExportError> {
        let model = self.current.get(&event.key).map_or_else(Rc::default, Rc::clone);
        let is_switch = event.kind() == crate::event::Kind::Switch;
        let named = |of: u32| if is_switch { mode(&model, of) } else { String::new() };
        // Seventeen digits distinguish any two numbers, also for other readers.
        let fields = [
            format!("{:.16e}", seconds(&self.catalogue, event.tick, event.theta)),
            event.tick.to_string(),
            format!("{:.16e}", event.theta),
            if event.key == 255 { String::new() } else { event.key.to_string() },
            event.kind().as_str_name().to_lowercase(),
            named(event.from),
            named(event.to),
            event.guard.clone(),
            event.speed.to_string(),
            event.text.clone(),
        ];
        self.done.events += 1;
        self.events.row(&fields)
    }

    fn finish(mut self) -> Result<Exported, ExportError> {
        for (_, key) in std::mem::take(&mut self.keys) {
            self.close(Some(key.table))?;
        }
        self.done.files.push(self.events.finish()?);
        self.done.files.sort();
        Ok(self.done)
    }

    fn close(&mut self, table: Option<CsvTable>) -> Result<(), ExportError> {
        if let Some(table) = table {
            self.done.files.push(table.finish()?);
        }
        Ok(())
    }

    fn model(&self, key: u32, revision: u32) -> Rc<Model> {
        self.revisions.get(&(key, revision)).map_or_else(Rc::default, Rc::clone)
    }

    /// Returns the model of `voice`; one without signals if no catalogue has it.
    fn model_of(&self, voice: &Voice) -> Rc<Model> {
        let name = || voice.model.clone();
        let nameless = || Rc::new(Model { name: name(), ..Model::default() });
        self.models.get(&(name(), voice.version)).map_or_else(nameless, Rc::clone)
    }
}

fn start(recording: &Recording) -> u64 {
    recording.span().map_or(0, |(first, _)| first)
}

fn models(catalogue: &Catalogue) -> BTreeMap<(String, u32), Rc<Model>> {
    let models = catalogue.models.iter();
    models.map(|model| ((model.name.clone(), model.version), Rc::new(model.clone()))).collect()
}
