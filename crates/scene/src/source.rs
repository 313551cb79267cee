//! The text of a scene or an instrument: embedded, or a file.

use std::path::{Path, PathBuf};

use super::embedded::EmbeddedFiles;
use documents::toml::{self, FindingList, SourcePlace, TextPlace, TomlNode, TomlSource};
use documents::{Diagnostic, Diagnostics, escaped, shown};

/// Longest file that is read (bytes); the largest scene of ours has two thousand.
const LONGEST: u64 = 1 << 18;

/// A text, and where it came from.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct SourceText {
    /// Its name in diagnostics.
    pub(super) file: String,
    /// Its name in lists: the file's, without the ending.
    pub(super) name: String,
    /// The folder to which relative paths in it are relative.
    pub(super) folder: PathBuf,
    pub(super) text: String,
}

/// A value of a scene that the command line replaces.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Override {
    pub name: String,
    pub value: String,
    /// Its form on the command line, as `--link can:can0`.
    pub typed: String,
}

impl From<(String, String)> for Override {
    fn from((name, value): (String, String)) -> Self {
        let typed = format!("--set {name}={value}");
        Self { name, value, typed }
    }
}

/// Returns the place of the override with this index; the file is the first source.
pub(super) const fn typed_place(index: usize) -> SourcePlace {
    SourcePlace { source: index + 1, offset: 0 }
}

impl SourceText {
    /// Returns the tree of the text, as far as it is TOML, and the mistakes in it and in `overrides`.
    pub(super) fn parsed(&self, overrides: &[Override]) -> (FindingList, Option<TomlNode>) {
        let mut report = FindingList::in_folder(self.folder.clone());
        let source = TomlSource { name: self.file.clone(), text: self.text.clone() };
        let source = report.source(source);
        for Override { typed, value, .. } in overrides {
            report.typed(typed, value);
        }
        let root = toml::parse(&mut report, source, TextPlace::Quote);
        (report, root)
    }

    /// Returns an embedded file of `shelf` called `name`.
    pub(super) fn embedded(shelf: &EmbeddedFiles, name: &str) -> Option<Self> {
        let text = shelf.find(name)?;
        Some(Self {
            file: format!("configs/{}s/{name}.toml", shelf.what),
            name: name.to_owned(),
            folder: PathBuf::new(),
            text: text.to_owned(),
        })
    }

    /// Returns the file at `path`.
    ///
    /// # Errors
    ///
    /// If it cannot be read, is no text, or is much too long.
    pub(super) fn read(path: &Path) -> Result<Self, Diagnostics> {
        let bytes =
            read_bytes(path).map_err(|(message, help)| refuse(path, None, message, help))?;
        Self::from_bytes(path, bytes)
    }

    /// Returns the file at `path`, whose contents are `bytes`.
    ///
    /// # Errors
    ///
    /// If they are no text.
    pub(super) fn from_bytes(path: &Path, bytes: Vec<u8>) -> Result<Self, Diagnostics> {
        let text = String::from_utf8(bytes).map_err(|error| not_text(path, &error))?;
        let name = escaped(&path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy());
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        Ok(Self { file: path.to_string_lossy().into_owned(), name, folder, text })
    }

    /// Returns the embedded file of that name, or the file at that path below `folder`.
    ///
    /// # Errors
    ///
    /// What is wrong and what to do, where there is no such thing; or that the file cannot be read.
    pub(super) fn find(
        shelf: &EmbeddedFiles,
        wanted: &str,
        folder: &Path,
    ) -> Result<Self, SourceError> {
        if let Some(source) = Self::embedded(shelf, wanted) {
            return Ok(source);
        }
        let path = folder.join(wanted);
        if path.is_file() {
            return Self::read(&path).map_err(SourceError::Unreadable);
        }
        Err(SourceError::Unknown(if is_path(wanted) {
            no_file(&path)
        } else {
            (
                format!("there is no {} {}", shelf.what, documents::quoted(wanted)),
                format!(
                    "{}, or a path to a file of yours",
                    documents::choice(wanted, shelf.names())
                ),
            )
        }))
    }
}

/// The reason why there is no [`SourceText`].
#[derive(Debug)]
pub(super) enum SourceError {
    /// There is no such thing: what is wrong, and what to do.
    Unknown((String, String)),
    /// It is there and cannot be read.
    Unreadable(Diagnostics),
}

/// Returns whether `text` is meant as a path rather than as a name.
fn is_path(text: &str) -> bool {
    mechanism::is_path(text)
}

/// Returns the message and the help for a file that is not there.
pub(super) fn no_file(path: &Path) -> (String, String) {
    let base = match std::env::current_dir() {
        Ok(folder) if path.is_relative() => format!(" in {}", shown(&folder)),
        Ok(_) | Err(_) => String::new(),
    };
    let path = documents::quoted(&path.to_string_lossy());
    (format!("there is no file {path}{base}"), "correct the path".to_owned())
}

fn read_bytes(path: &Path) -> Result<Vec<u8>, (String, String)> {
    let failed = |error: std::io::Error| {
        if error.kind() == std::io::ErrorKind::NotFound {
            no_file(path)
        } else {
            (format!("the file cannot be read, {error}"), "make it readable".to_owned())
        }
    };
    let bytes = documents::read_input(path, LONGEST).map_err(failed)?;
    if bytes.len() as u64 > LONGEST {
        let message = format!("the file is longer than {} KiB", LONGEST / 1024);
        return Err((message, "this is no scene or instrument, choose another".to_owned()));
    }
    Ok(bytes)
}

fn not_text(path: &Path, error: &std::string::FromUtf8Error) -> Diagnostics {
    let good = error.as_bytes().get(..error.utf8_error().valid_up_to()).unwrap_or_default();
    let line = good.split(|byte| *byte == b'\n').count();
    let last = good.rsplit(|byte| *byte == b'\n').next().unwrap_or_default();
    let column = String::from_utf8_lossy(last).chars().count() + 1;
    let message = "this byte is not UTF-8".to_owned();
    refuse(path, Some((line, column)), message, "save the file as UTF-8 text".to_owned())
}

/// Returns the diagnostics of a file of which nothing else is known.
pub(super) fn refuse(
    path: &Path,
    position: Option<(usize, usize)>,
    message: String,
    help: String,
) -> Diagnostics {
    Diagnostics::new(vec![Diagnostic {
        file: path.to_string_lossy().into_owned(),
        line: position.map(|(line, _)| line),
        column: position.map(|(_, column)| column),
        message,
        help,
    }])
}
