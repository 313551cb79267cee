use mechanism::Library;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use instruments::{LoadedModel, ModelEntry, Preset};
use keyboard::KeyRange;
use serde::Serialize;

use super::based::Based;
use super::embedded::INSTRUMENTS;
use super::fidelity::{Fidelity, read_levels};
use super::figures;
use super::kind::describes_model;
use super::needs::Needs;
use super::quantity::Quantity;
use super::read::TableReader;
use super::source::{SourceError, SourceText, refuse};
use super::voicing::{InstrumentFile, Voicing};
use documents::toml::FindingList;
use documents::{Diagnostics, quoted};

/// Number of a General MIDI program, counted from one as in its tables.
const PROGRAM: Quantity = Quantity { unit: "", range: (1.0, 128.0) };

/// Instrument with checked values: a model and a preset over the compass.
#[derive(Clone, Debug)]
pub struct Instrument {
    pub name: String,
    /// Description in a few words.
    pub title: String,
    /// Description of a sentence or two; may be empty.
    pub doc: String,
    /// Settings with which it is stable.
    pub needs: Needs,
    /// Targets of `letoff lab piano`: figures by name, lowest and highest value.
    pub figures: Vec<(String, (f64, f64))>,
    /// Number among the programs of General MIDI, 1 ..= 128.
    pub program: Option<u32>,
    /// Instruments, by name or path, that render the action with less work; the most faithful
    /// first.
    pub levels: Vec<(Fidelity, String)>,
    pub voicing: Voicing,
    pub based: Option<Based>,
}

impl Instrument {
    /// Loads the embedded instrument of that name, or the file at that path.
    ///
    /// # Errors
    /// All mistakes in it.
    pub fn load(library: &Library, name_or_path: &str) -> Result<Self, Diagnostics> {
        let source = SourceText::find(&INSTRUMENTS, name_or_path, Path::new(""));
        let source = source.map_err(|missing| match missing {
            SourceError::Unknown((message, help)) => {
                refuse(Path::new(name_or_path), None, message, help)
            }
            SourceError::Unreadable(diagnostics) => diagnostics,
        })?;
        Self::check(library, &source)
    }

    /// Returns the embedded instruments of `model` in the order of lists, without reading others.
    pub fn of_model(model: &ModelEntry) -> Vec<Arc<Self>> {
        static READ: Mutex<Vec<Arc<Instrument>>> = Mutex::new(Vec::new());
        let line = format!("model = \"{}\"", model.name);
        let says = |name: &&str| INSTRUMENTS.find(name).is_some_and(|text| text.contains(&line));
        let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
        let mut known = |name: &str| {
            if let Some(known) = read.iter().find(|it| it.name == name) {
                return Some(Arc::clone(known));
            }
            let loaded = Arc::new(Self::load(&Library::default(), name).ok()?);
            read.push(Arc::clone(&loaded));
            Some(loaded)
        };
        let all = INSTRUMENTS.names().filter(says).filter_map(&mut known);
        all.filter(|it| it.voicing.model.is(model)).collect()
    }

    /// Returns the name of the embedded instrument with a General MIDI program, 1 ..= 128.
    pub fn of_program(program: u8) -> Option<&'static str> {
        let line = format!("program = {program}");
        let says = |name: &&str| {
            INSTRUMENTS.find(name).is_some_and(|text| text.lines().any(|it| it == line))
        };
        INSTRUMENTS.names().find(says)
    }

    pub const fn model(&self) -> &Arc<LoadedModel> {
        &self.voicing.model
    }

    /// Returns one value per parameter of the model for `key`, 0 (A0) ..= 87 (C8).
    pub fn values(&self, key: u8) -> Vec<f64> {
        self.voicing.values(key)
    }

    pub(super) fn check(library: &Library, source: &SourceText) -> Result<Self, Diagnostics> {
        Self::check_as(library, source, BaseUse::Allowed)
    }

    /// Like `check`, for an instrument that others are based on, which has no base itself.
    pub(super) fn check_base(library: &Library, source: &SourceText) -> Result<Self, Diagnostics> {
        Self::check_as(library, source, BaseUse::Refused)
    }

    fn check_as(
        library: &Library,
        source: &SourceText,
        base_use: BaseUse,
    ) -> Result<Self, Diagnostics> {
        if describes_model(source) {
            let message = "this is the description of a model, not an instrument".to_owned();
            let help = "name it in an instrument: model = \"…\"".to_owned();
            return Err(refuse(Path::new(&source.file), None, message, help));
        }
        let (mut report, root) = source.parsed(&[]);
        let read = root.and_then(|root| {
            let mut reader = TableReader::new(&mut report, &source.name, &root)?;
            let subject = (source.name.as_str(), library);
            let instrument = Self::read(&mut report, &mut reader, subject, base_use);
            reader.finish(&mut report);
            instrument
        });
        let mut instrument = report.verdict(read)?;
        let (name, path) = (source.name.clone(), source.file.clone());
        let file = (!source.is_embedded).then(|| Arc::new(InstrumentFile { name, path }));
        instrument.voicing.file = file;
        Ok(instrument)
    }

    fn read(
        report: &mut FindingList,
        reader: &mut TableReader<'_>,
        (name, library): (&str, &Library),
        base_use: BaseUse,
    ) -> Option<Self> {
        let title = reader.text(report, "title").map_or_else(|| name.to_owned(), |(t, _)| t);
        let doc = reader.text(report, "doc").map_or_else(String::new, |(doc, _)| doc);
        if let Some((base, place)) = reader.text(report, "base") {
            if base_use == BaseUse::Refused {
                let message = "the base of an instrument has a base itself";
                report.say(place, message, format!("name {} instead", quoted(&base)));
                return None;
            }
            let edited = Self::read_edited(report, reader, (&base, place), library)?;
            return Some(Self { name: name.to_owned(), title, doc, ..edited });
        }
        if reader.take("model").is_none() {
            report.miss(reader.place, "the instrument has no model", "add model = \"…\"");
        }
        let needs = Needs::read(report, reader);
        let figures = figures::read(report, reader);
        let program = reader.whole(report, "program", PROGRAM);
        let levels = read_levels(report, reader);
        let voicing = Voicing::read(report, reader, library);
        let Some(mut voicing) = voicing else {
            reader.take("parameters");
            return None;
        };
        voicing.read_parameters(report, reader);
        voicing.refuse_unmet(report, reader.place, KeyRange::ALL);
        let based = None;
        Some(Self {
            name: name.to_owned(),
            title,
            doc,
            needs,
            figures,
            program,
            levels,
            voicing,
            based,
        })
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum BaseUse {
    Allowed,
    Refused,
}

/// Returns the embedded instrument with `model` and `preset`, or else the first one with that
/// model: knowledge of its stability applies to the model, too.
pub(super) fn known_as(model: &ModelEntry, preset: Option<&Preset>) -> Option<Arc<Instrument>> {
    let all = Instrument::of_model(model);
    let same = |it: &&Arc<Instrument>| {
        preset.is_some_and(|preset| it.voicing.preset().name == preset.name)
    };
    all.iter().find(same).or_else(|| all.first()).map(Arc::clone)
}

/// Head of an embedded instrument's file, read without its model.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct InstrumentHead {
    pub name: String,
    pub title: String,
    #[serde(skip)]
    pub doc: String,
    pub model: String,
    pub preset: String,
    /// Settings with which it is stable.
    pub needs: Option<String>,
}

impl InstrumentHead {
    fn read(name: &str) -> Option<Self> {
        let source = SourceText::embedded(&INSTRUMENTS, name)?;
        let (mut report, root) = source.parsed(&[]);
        let root = root?;
        let mut reader = TableReader::new(&mut report, name, &root)?;
        let needs = Needs::read(&mut report, &mut reader).summary();
        let mut text = |key| reader.text(&mut report, key).map(|(text, _)| text);
        Some(Self {
            name: name.to_owned(),
            title: text("title")?,
            doc: text("doc")?,
            model: text("model")?,
            preset: text("preset")?,
            needs,
        })
    }
}

/// Returns the heads of all embedded instruments, in the order of lists; no model is derived.
pub fn instruments() -> Vec<InstrumentHead> {
    INSTRUMENTS.names().filter_map(InstrumentHead::read).collect()
}
