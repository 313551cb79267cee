//! From a path to an entry of the catalogue, each version once.

use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use diagnostics::{Diagnostic, Diagnostics, choice, quoted};
use models::catalogue::{self, ModelEntry};

use crate::reader::reader;
use crate::register::register_model;

/// Longest file that is read (bytes).
const LONGEST: u64 = 1 << 18;

/// A version of a description, with what stood in its files.
struct KnownVersion {
    path: PathBuf,
    files: Vec<(PathBuf, Vec<u8>)>,
    entry: &'static ModelEntry,
}

impl KnownVersion {
    /// Whether its files say what they said when it was read.
    fn is_current(&self) -> bool {
        let is_same =
            |(path, bytes): &(PathBuf, Vec<u8>)| read_bytes(path).is_ok_and(|now| now == *bytes);
        self.files.iter().all(is_same)
    }
}

/// The versions that were read, the newest of each path.
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

/// Whether `wanted` is meant as the path of a description rather than as a name.
pub fn is_path(wanted: &str) -> bool {
    wanted.contains(['/', '\\']) || Path::new(wanted).extension().is_some()
}

/// Returns the model of the program that is called `wanted`, or the one that the file at that path
/// below `folder` describes.
///
/// A name is always that of a model of the program, whatever was read from files before.
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
    let names = catalogue::ENTRIES.iter().map(|entry| entry.name);
    Err(MissingModel::Unknown {
        message: format!("there is no model {}", quoted(wanted)),
        help: format!("{}, or a path to a description of yours", choice(wanted, names)),
    })
}

/// Returns the model that the file at `path` describes, and puts it into the catalogue.
///
/// A file that has not changed since it was read is the same model; one that has is a new version.
///
/// # Errors
/// All that is wrong with the description.
pub fn load_model(path: &Path) -> Result<&'static ModelEntry, Diagnostics> {
    let refuse = |(message, help): (String, &str)| refusal(path, message, help);
    let bytes = read_bytes(path).map_err(refuse)?;
    let place = path.canonicalize().unwrap_or_else(|_unknown| path.to_owned());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let same = known.iter().find(|version| version.path == place && version.is_current());
    if let Some(version) = same {
        return Ok(version.entry);
    }
    let Some(reader) = reader() else {
        let message = "this program cannot read descriptions of models".to_owned();
        return Err(refuse((message, "name a model of the program")));
    };
    let text = std::str::from_utf8(&bytes).map_err(|error| {
        let message = format!("byte {} is not UTF-8", error.valid_up_to());
        refuse((message, "save the file as UTF-8 text"))
    })?;
    let model = reader.read(path, text)?;
    let entry = register_model(model.table, model.functions, Some(&place))
        .map_err(|large| refuse((large.to_string(), "describe a smaller model")))?;
    let contents = |path: PathBuf| read_bytes(&path).ok().map(|bytes| (path, bytes));
    let mut files: Vec<_> = model.files.into_iter().filter_map(contents).collect();
    files.push((place.clone(), bytes));
    known.retain(|version| version.path != place);
    known.push(KnownVersion { path: place, files, entry });
    Ok(entry)
}

/// The diagnostics of a file of which nothing else is known.
fn refusal(path: &Path, message: String, help: &str) -> Diagnostics {
    Diagnostics::new(vec![Diagnostic {
        file: path.display().to_string(),
        line: None,
        column: None,
        message,
        help: help.to_owned(),
    }])
}

fn read_bytes(path: &Path) -> Result<Vec<u8>, (String, &'static str)> {
    let failed = |error: std::io::Error| {
        if error.kind() == std::io::ErrorKind::NotFound {
            ("there is no such file".to_owned(), "correct the path")
        } else {
            (format!("the file cannot be read, {error}"), "make it readable")
        }
    };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(failed)?;
    file.take(LONGEST + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > LONGEST {
        let message = format!("the file is longer than {} KiB", LONGEST / 1024);
        return Err((message, "this is no description, choose another"));
    }
    Ok(bytes)
}
