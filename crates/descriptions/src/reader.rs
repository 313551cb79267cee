//! Who makes a table and functions of a description.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, OnceLock};

use diagnostics::Diagnostics;
use equations::table::{Functions, ModelTable};

use crate::files::DescriptionFiles;

/// What was read from a description, kept until the program ends.
#[derive(Clone, Copy)]
pub struct ReadModel {
    /// All of the model but its arithmetic.
    pub table: &'static ModelTable,
    /// Its arithmetic, by number.
    pub functions: &'static dyn Functions,
}

impl std::fmt::Debug for ReadModel {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ReadModel").field("table", &self.table.name).finish_non_exhaustive()
    }
}

/// Makes a table and functions of a description.
pub trait DescriptionReader: Send + Sync {
    /// Reads the description `source`, its path and its text; what it is based on is read
    /// through `files`, so that it is known which files it is made of. It ends early, with a
    /// mistake, once `is_cancelled` is set.
    ///
    /// # Errors
    /// All that is wrong with it.
    fn read(
        &self,
        source: (&Path, &str),
        files: &DescriptionFiles,
        is_cancelled: &Arc<AtomicBool>,
    ) -> Result<ReadModel, Diagnostics>;
}

static READER: OnceLock<&'static dyn DescriptionReader> = OnceLock::new();

/// Makes `reader` the one that reads all descriptions of this process; one that is installed stays.
pub fn install(reader: &'static dyn DescriptionReader) {
    let _kept = READER.set(reader);
}

/// The reader of this process, if there is one.
pub(crate) fn reader() -> Option<&'static dyn DescriptionReader> {
    READER.get().copied()
}
