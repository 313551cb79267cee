//! Loads models by name or path, each version once.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError, Weak};

use crate::kane::description::{Bases, Description};
use crate::kane::{DerivedModel, derive_unless_cancelled};
use crate::native::NativeError;
use documents::{Diagnostic, Diagnostics, choice, quoted};
use instruments::{FileContents, LoadedModel, ModelSource, SharedFunctions};

use crate::files::{DescriptionFiles, KeptFiles, Unread, absolute, read_from_disk};
use crate::shipped::{SHIPPED, description};
use crate::too_large;

/// Reason for a missing model.
#[derive(Debug)]
pub enum MissingModel {
    Unknown { message: String, help: String },
    Wrong(Diagnostics),
}

impl MissingModel {
    /// Returns the message and the remedy, or each mistake of a description with line and caret.
    pub fn rendered(&self) -> String {
        match self {
            Self::Unknown { message, help } => format!("{message}; {help}"),
            Self::Wrong(mistakes) => rendered(mistakes),
        }
    }
}

/// Returns the mistakes, each with its line and a caret under the place.
pub fn rendered(mistakes: &Diagnostics) -> String {
    let text_of = |file: &str| {
        let of_program = description(file).map(str::to_owned);
        of_program.or_else(|| String::from_utf8(read_from_disk(Path::new(file)).ok()?).ok())
    };
    documents::rendered(mistakes, &text_of).trim_end().to_owned()
}

/// Returns `true` if `wanted` is meant as the path of a description, not as a name.
pub fn is_path(wanted: &str) -> bool {
    wanted.contains(['/', '\\']) || Path::new(wanted).extension().is_some()
}

pub fn model_names() -> impl Iterator<Item = &'static str> + Clone {
    SHIPPED.iter().map(|(name, _text)| *name)
}

/// Returns an error for the unknown name `wanted` that lists all models.
pub fn unknown_model(wanted: &str) -> MissingModel {
    MissingModel::Unknown {
        message: format!("there is no model {}", quoted(wanted)),
        help: format!("{}, or a path to a description of yours", choice(wanted, model_names())),
    }
}

/// Loader of descriptions that keeps the models in use. Clones share their versions. A version of a
/// description lives as long as its model is in use; the shipped models are kept.
#[derive(Clone, Debug, Default)]
pub struct Library(Arc<LibraryState>);

#[derive(Debug, Default)]
struct LibraryState {
    kept: KeptFiles,
    known: Mutex<Vec<KnownVersion>>,
    versions: AtomicU32,
}

#[derive(Debug)]
struct KnownVersion {
    place: PathBuf,
    model: Weak<LoadedModel>,
}

impl Library {
    /// Returns the shipped model called `wanted`, or that of the description at the path `wanted`
    /// below `folder`.
    ///
    /// # Errors
    /// The model is unknown or its description has mistakes.
    pub fn find(&self, wanted: &str, folder: &Path) -> Result<Arc<LoadedModel>, MissingModel> {
        if is_path(wanted) {
            return self.load(&folder.join(wanted)).map_err(MissingModel::Wrong);
        }
        shipped(wanted).unwrap_or_else(|| Err(unknown_model(wanted)))
    }

    /// Returns the model of the description at `path`.
    ///
    /// A file with the contents of a version in use returns that version.
    ///
    /// # Errors
    /// All mistakes in the description.
    pub fn load(&self, path: &Path) -> Result<Arc<LoadedModel>, Diagnostics> {
        self.try_load(path, &Arc::default()).1
    }

    /// Like [`load`](Self::load), with the files read; ends early once `is_cancelled` is set.
    pub fn try_load(
        &self,
        path: &Path,
        is_cancelled: &Arc<AtomicBool>,
    ) -> (FileContents, Result<Arc<LoadedModel>, Diagnostics>) {
        let place = path.canonicalize().unwrap_or_else(|_unknown| absolute(path));
        if let Some((contents, model)) = self.current(&place) {
            return (contents, Ok(model));
        }
        // The lock is not held here, so that a request does not wait for another derivation.
        let files = DescriptionFiles::new(&self.0.kept);
        let model = self.read(path, &files, is_cancelled);
        if let Ok(model) = &model {
            self.known().push(KnownVersion { place, model: Arc::downgrade(model) });
        }
        (files.contents(), model)
    }

    /// Returns the version in use with unchanged contents of the files at `place`.
    fn current(&self, place: &Path) -> Option<(FileContents, Arc<LoadedModel>)> {
        let mut known = self.known();
        known.retain(|version| version.model.strong_count() > 0);
        let read = |path: &Path| self.0.kept.read(path).ok();
        known.iter().filter(|version| version.place == place).find_map(|version| {
            let model = version.model.upgrade()?;
            let contents = model.source.as_ref()?.contents.clone();
            (contents.read_again(&read) == contents).then_some((contents, model))
        })
    }

    /// Replaces the contents of `path` by `text`, as in a replay with recorded descriptions.
    pub fn keep_file(&self, path: &Path, text: &str) {
        self.0.kept.keep(path, text);
    }

    fn known(&self) -> MutexGuard<'_, Vec<KnownVersion>> {
        self.0.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn read(
        &self,
        path: &Path,
        files: &DescriptionFiles<'_>,
        is_cancelled: &Arc<AtomicBool>,
    ) -> Result<Arc<LoadedModel>, Diagnostics> {
        let text = text_of(path, files)?;
        let name = path.to_string_lossy().into_owned();
        let derived = derive_unless_cancelled(&name, &text, files, is_cancelled)?;
        let source = ModelSource {
            file: absolute(path).to_string_lossy().into_owned(),
            version: self.0.versions.fetch_add(1, Ordering::Relaxed) + 1,
            contents: files.contents(),
        };
        compiled(path, derived, Some(source), is_cancelled)
    }
}

/// Derives the model of the description called `wanted`, or of the file at that path.
///
/// # Errors
/// The model is unknown or its description has mistakes.
pub fn derive(wanted: &str) -> Result<DerivedModel, MissingModel> {
    with_text(wanted, crate::kane::derive_model)
}

/// Like [`derive()`], but reads and checks the description only; derives no equations.
///
/// # Errors
/// Those of [`derive()`] that reading finds.
pub fn describe(wanted: &str) -> Result<Description, MissingModel> {
    with_text(wanted, crate::kane::description::read)
}

fn with_text<T>(
    wanted: &str,
    read: impl FnOnce(&str, &str, &dyn Bases) -> Result<T, Diagnostics>,
) -> Result<T, MissingModel> {
    let kept = KeptFiles::default();
    let files = DescriptionFiles::new(&kept);
    let text = match description(wanted) {
        Some(text) => text.to_owned(),
        None if is_path(wanted) => {
            text_of(Path::new(wanted), &files).map_err(MissingModel::Wrong)?
        }
        None => return Err(unknown_model(wanted)),
    };
    read(wanted, &text, &files).map_err(MissingModel::Wrong)
}

fn shipped(name: &str) -> Option<Result<Arc<LoadedModel>, MissingModel>> {
    // A pure function of its index, computed once: concurrent requests get one model.
    static MODELS: [OnceLock<Arc<LoadedModel>>; SHIPPED.len()] =
        [const { OnceLock::new() }; SHIPPED.len()];
    static DERIVING: Mutex<()> = Mutex::new(());
    let index = SHIPPED.iter().position(|(known, _text)| *known == name)?;
    let model = &MODELS[index];
    let _deriving = DERIVING.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(model) = model.get() {
        return Some(Ok(Arc::clone(model)));
    }
    let read = derive(name).and_then(|derived| {
        compiled(Path::new(name), derived, None, &AtomicBool::new(false))
            .map_err(MissingModel::Wrong)
    });
    Some(read.map(|read| Arc::clone(model.get_or_init(|| read))))
}

fn text_of(path: &Path, files: &DescriptionFiles<'_>) -> Result<String, Diagnostics> {
    let refuse = |(message, help): Unread| refusal(path, message, help);
    let bytes = files.read(path).map_err(refuse)?;
    String::from_utf8(bytes).map_err(|error| {
        let message = format!("byte {} is not UTF-8", error.utf8_error().valid_up_to());
        refuse((message, "save the file as UTF-8 text"))
    })
}

static INTERPRETED: OnceLock<String> = OnceLock::new();

/// Returns the reason for which models of this process are interpreted, if any.
pub fn interpreted() -> Option<&'static str> {
    INTERPRETED.get().map(String::as_str)
}

#[expect(clippy::large_stack_frames, reason = "once for a description, off the tick")]
fn compiled(
    path: &Path,
    derived: DerivedModel,
    source: Option<ModelSource>,
    is_cancelled: &AtomicBool,
) -> Result<Arc<LoadedModel>, Diagnostics> {
    let program = derived.program;
    let functions: SharedFunctions =
        match crate::native::compile_unless_cancelled(program.tapes(), is_cancelled) {
            Ok(functions) => Arc::new(functions),
            Err(error @ (NativeError::TooMany { .. } | NativeError::Cancelled)) => {
                let message = format!("the model cannot be compiled, {error}");
                return Err(refusal(path, message, "describe a smaller model"));
            }
            Err(unable) => {
                INTERPRETED.get_or_init(|| unable.to_string());
                Arc::new(program.functions)
            }
        };
    let model = LoadedModel::new(program.table, functions, source)
        .map_err(|large| refusal(path, too_large::message(large), "describe a smaller model"))?;
    Ok(Arc::new(model))
}

fn refusal(path: &Path, message: String, help: &str) -> Diagnostics {
    Diagnostics::new(vec![Diagnostic {
        file: path.to_string_lossy().into_owned(),
        line: None,
        column: None,
        message,
        help: help.to_owned(),
    }])
}
