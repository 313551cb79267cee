//! Models from files: from a path to an entry of the catalogue.
//!
//! ```text
//! path ─ load_model ─▶ DescriptionReader ─▶ table and functions ─ register_model ─▶ ModelEntry
//! ```
//!
//! Whoever names a model, a scene or a command, asks [`find_model`] with a name or a path. How a
//! description becomes a table and functions is not known here: the command that is started
//! [`install`]s a [`DescriptionReader`], so that nothing that reads scenes waits for a code
//! generator when it is compiled.
//!
//! [`try_load`] says which files a description was made of, so that it can be read again when one of
//! them changes, and [`version_of`] what stood in them, so that a recording can contain it. What a
//! recording contains is read again after [`keep_file`], without the disk.
//!
//! Models are leaked on purpose: see [`models::registry`].
//!
//! # What is not here
//! The language of descriptions, mechanics, and code: crates `kane` and `native`.

mod files;
mod load;
mod reader;
mod register;
mod shipped;
mod unmet;

pub use files::{DescriptionFiles, FileContents, keep_file};
pub use load::{
    DescriptionVersion, MissingModel, find_model, is_path, load_model, model_names, rendered,
    try_load, unknown_model, version_of,
};
pub use reader::{DescriptionReader, ReadModel, install};
pub use register::{NotRegistered, register_model};
pub use shipped::description;
pub use unmet::unmet;
