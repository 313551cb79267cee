//! From a path to an entry of the catalogue, each version once.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use diagnostics::{Diagnostic, Diagnostics, choice, quoted};
use models::catalogue::{self, ModelEntry};

use crate::files::{DescriptionFiles, FileContents, absolute, text_of};
use crate::reader::reader;
use crate::register::register_model;
use crate::shipped::{SHIPPED, description};

/// A version of a description, with what stood in its files.
#[derive(Clone, Debug)]
pub struct DescriptionVersion {
    /// Its number among those that this process has read, from 1.
    pub number: u32,
    pub entry: &'static ModelEntry,
    /// What stood in its files, the description first, then its bases.
    pub contents: Arc<FileContents>,
}

/// A version, and the file that it was read from by whichever path.
struct KnownVersion {
    place: PathBuf,
    version: DescriptionVersion,
}

/// The versions that were read, the oldest first.
static KNOWN: Mutex<Vec<KnownVersion>> = Mutex::new(Vec::new());

/// Why there is no model.
#[derive(Debug)]
pub enum MissingModel {
    /// There is no such thing: what is wrong, and what to do.
    Unknown {
        /// What is wrong with it.
        message: String,
        /// What to do about it.
        help: String,
    },
    /// The description is there, and all this is wrong with it.
    Wrong(Diagnostics),
}

impl MissingModel {
    /// Returns what is wrong and what to do, each mistake of a description with its line and a
    /// caret.
    pub fn rendered(&self) -> String {
        match self {
            Self::Unknown { message, help } => format!("{message}; {help}"),
            Self::Wrong(mistakes) => rendered(mistakes),
        }
    }
}

/// Returns the mistakes, each with the line that it is about and a caret under the place.
pub fn rendered(mistakes: &Diagnostics) -> String {
    let text_of = |file: &str| {
        let of_program = description(file).map(str::to_owned);
        of_program.or_else(|| text_of(file))
    };
    diagnostics::rendered(mistakes, &text_of).trim_end().to_owned()
}

/// Whether `wanted` is meant as the path of a description rather than as a name.
pub fn is_path(wanted: &str) -> bool {
    wanted.contains(['/', '\\']) || Path::new(wanted).extension().is_some()
}

/// Returns the model of the program that is called `wanted`, or the one that the file at that path
/// below `folder` describes.
///
/// A name is always that of a model of the program, whatever was read from files before; one that
/// comes as a description is derived when it is asked for the first time.
///
/// # Errors
/// There is none, or all that is wrong with its description.
pub fn find_model(wanted: &str, folder: &Path) -> Result<&'static ModelEntry, MissingModel> {
    if let Some(entry) = catalogue::built_in(wanted) {
        return Ok(entry);
    }
    if is_path(wanted) {
        return load_model(&folder.join(wanted)).map_err(MissingModel::Wrong);
    }
    shipped(wanted).unwrap_or_else(|| Err(unknown_model(wanted)))
}

/// Names of all models of the program: those that it contains as Rust, then those that come as
/// descriptions.
pub fn model_names() -> impl Iterator<Item = &'static str> + Clone {
    let shipped = SHIPPED.iter().map(|(name, _text)| *name);
    catalogue::built_ins().map(|entry| entry.name).chain(shipped)
}

/// The model that comes with the program as a description called `name`, if there is one.
fn shipped(name: &str) -> Option<Result<&'static ModelEntry, MissingModel>> {
    static LOADED: Mutex<Vec<&'static ModelEntry>> = Mutex::new(Vec::new());
    let (name, text) = *SHIPPED.iter().find(|(known, _text)| *known == name)?;
    // Held while a model is derived: two that ask for it get the same one.
    let mut loaded = LOADED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = loaded.iter().find(|entry| entry.name == name) {
        return Some(Ok(known));
    }
    let entry =
        derive((Path::new(name), text), &DescriptionFiles::default(), None, &Arc::default());
    Some(entry.inspect(|entry| loaded.push(entry)).map_err(MissingModel::Wrong))
}

/// Returns that there is no model called `wanted`, and which there are.
pub fn unknown_model(wanted: &str) -> MissingModel {
    MissingModel::Unknown {
        message: format!("there is no model {}", quoted(wanted)),
        help: format!("{}, or a path to a description of yours", choice(wanted, model_names())),
    }
}

/// Returns the model that the file at `path` describes, and puts it into the catalogue.
///
/// A file that says what it said in any earlier version is that version; one that says something
/// else is a new one.
///
/// # Errors
/// All that is wrong with the description.
pub fn load_model(path: &Path) -> Result<&'static ModelEntry, Diagnostics> {
    try_load(path, &Arc::default()).1
}

/// Like [`load_model`], but returns the files that were read, too, right or wrong, and ends early,
/// with a mistake, once `is_cancelled` is set.
pub fn try_load(
    path: &Path,
    is_cancelled: &Arc<AtomicBool>,
) -> (FileContents, Result<&'static ModelEntry, Diagnostics>) {
    let files = DescriptionFiles::default();
    let place = path.canonicalize().unwrap_or_else(|_unknown| absolute(path));
    let is_same = |it: &&KnownVersion| it.place == place && it.version.contents.is_current();
    if let Some(same) = known().iter().find(is_same) {
        return (FileContents::clone(&same.version.contents), Ok(same.version.entry));
    }
    // Nobody who asks for a version waits until another one is derived.
    let entry = read(path, &files, is_cancelled);
    let contents = files.into_contents();
    let entry = match entry {
        Ok(entry) => entry,
        Err(mistakes) => return (contents, Err(mistakes)),
    };
    let mut known = known();
    let number = u32::try_from(known.len() + 1).unwrap_or(u32::MAX);
    let version = DescriptionVersion { number, entry, contents: Arc::new(contents.clone()) };
    known.push(KnownVersion { place, version });
    (contents, Ok(entry))
}

/// Returns the version of a description that `entry` is; none of a model of the program.
pub fn version_of(entry: &ModelEntry) -> Option<DescriptionVersion> {
    known().iter().find(|it| it.version.entry.is(entry)).map(|it| it.version.clone())
}

fn known() -> MutexGuard<'static, Vec<KnownVersion>> {
    KNOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Reads, derives and registers the description at `path`.
fn read(
    path: &Path,
    files: &DescriptionFiles,
    is_cancelled: &Arc<AtomicBool>,
) -> Result<&'static ModelEntry, Diagnostics> {
    let refuse = |(message, help): (String, &str)| refusal(path, message, help);
    let bytes = files.read_or_help(path).map_err(refuse)?;
    let text = std::str::from_utf8(&bytes).map_err(|error| {
        let message = format!("byte {} is not UTF-8", error.valid_up_to());
        refuse((message, "save the file as UTF-8 text"))
    })?;
    derive((path, text), files, Some(&absolute(path)), is_cancelled)
}

/// Derives and registers the description `text` at `path`, which is a `file` or part of the program.
fn derive(
    (path, text): (&Path, &str),
    files: &DescriptionFiles,
    file: Option<&Path>,
    is_cancelled: &Arc<AtomicBool>,
) -> Result<&'static ModelEntry, Diagnostics> {
    let Some(reader) = reader() else {
        let message = "this program cannot read descriptions of models".to_owned();
        return Err(refusal(path, message, "name a model that it contains as Rust"));
    };
    let model = reader.read((path, text), files, is_cancelled)?;
    register_model(model.table, model.functions, file)
        .map_err(|large| refusal(path, large.to_string(), "describe a smaller model"))
}

/// The diagnostics of a file of which nothing else is known.
fn refusal(path: &Path, message: String, help: &str) -> Diagnostics {
    Diagnostics::new(vec![Diagnostic {
        file: path.to_string_lossy().into_owned(),
        line: None,
        column: None,
        message,
        help: help.to_owned(),
    }])
}
