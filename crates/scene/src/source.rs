use std::path::{Path, PathBuf};

use super::embedded::EmbeddedFiles;
use documents::toml::{self, FindingList, SourcePlace, TextPlace, TomlNode, TomlSource};
use documents::{Diagnostic, Diagnostics, escaped, shown};

/// Longest accepted file (bytes); the largest shipped scene has two thousand.
const LONGEST: u64 = 1 << 18;

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct SourceText {
    pub(super) file: String,
    /// Name in lists: the file's, without its extension.
    pub(super) name: String,
    pub(super) folder: PathBuf,
    pub(super) text: String,
    pub(super) is_embedded: bool,
}

/// Value of a scene replaced by the command line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Override {
    pub name: String,
    pub value: String,
    /// Form on the command line, as `--link can:can0`.
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
    /// Returns the tree of the text, as far as it is TOML, with mistakes in it and in `overrides`.
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

    pub(super) fn embedded(shelf: &EmbeddedFiles, name: &str) -> Option<Self> {
        let text = shelf.find(name)?;
        Some(Self {
            file: format!("configs/{}s/{name}.toml", shelf.what),
            name: name.to_owned(),
            folder: PathBuf::new(),
            text: text.to_owned(),
            is_embedded: true,
        })
    }

    /// Reads the file at `path`; rejects one that is unreadable, not text or too long.
    pub(super) fn read(path: &Path) -> Result<Self, Diagnostics> {
        let bytes =
            read_bytes(path).map_err(|(message, help)| refuse(path, None, message, help))?;
        Self::from_bytes(path, bytes)
    }

    /// Returns the file at `path` with the contents `bytes`; rejects bytes that are not text.
    pub(super) fn from_bytes(path: &Path, bytes: Vec<u8>) -> Result<Self, Diagnostics> {
        let text = String::from_utf8(bytes).map_err(|error| not_text(path, &error))?;
        let name = escaped(&path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy());
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let file = path.to_string_lossy().into_owned();
        Ok(Self { file, name, folder, text, is_embedded: false })
    }

    /// Returns the embedded file of that name, or the file at that path below `folder`.
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

#[derive(Debug)]
pub(super) enum SourceError {
    /// Unknown name or path: message and remedy.
    Unknown((String, String)),
    Unreadable(Diagnostics),
}

fn is_path(text: &str) -> bool {
    mechanism::is_path(text)
}

/// Returns the message and the help for a missing file.
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
