//! Models from descriptions: from a name or a path to a model that runs.
//!
//! ```text
//! path ─ Library ─▶ kane: equations ─▶ native: machine code ─▶ Arc<LoadedModel>
//! ```
//!
//! Callers pass a [`Library`] wherever a model is named. It reads a file again only if its
//! contents, or those of its bases, changed; versions live as long as they are used.
//! Where no machine code can be made, the instructions are interpreted, to equal bits, some twenty
//! times slower ([`interpreted`] names the reason).

pub mod expressions;
mod files;
pub mod formulas;
pub mod kane;
mod library;
pub mod native;
mod shipped;
mod too_large;
mod unmet;

pub use files::contents_now;
pub use library::{
    Library, MissingModel, derive, describe, interpreted, is_path, model_names, rendered,
    unknown_model,
};
pub use shipped::description;
pub use unmet::unmet;
