//! Models from descriptions: from a name or a path to a model that runs.
//!
//! ```text
//! path ─ Library ─▶ kane: equations ─▶ native: machine code ─▶ Arc<LoadedModel>
//! ```
//!
//! A [`Library`] is passed to whatever names a model, a scene or a command. It reads a file again
//! only if its contents, or those of its bases, changed; versions live as long as they are used.
//! Where no machine code can be made, the same instructions are interpreted, to the same bits, some
//! twenty times slower ([`interpreted`] names the reason).
//!
//! # What is not here
//! The language of descriptions, mechanics, and code: crates `kane` and `native`.

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
    Library, MissingModel, derive, interpreted, is_path, model_names, rendered, unknown_model,
};
pub use shipped::description;
pub use unmet::unmet;
