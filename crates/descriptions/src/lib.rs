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
//! Models are leaked on purpose: see [`models::registry`].
//!
//! # What is not here
//! The language of descriptions, mechanics, and code: crates `kane` and `native`.

mod entry;
mod load;
mod reader;
mod register;

pub use load::{MissingModel, find_model, is_path, load_model};
pub use reader::{DescriptionReader, ReadModel, install};
pub use register::{NotRegistered, register_model};
