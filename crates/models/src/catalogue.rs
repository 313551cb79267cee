//! From a name to a model, be it part of the program or read from a file.

pub use crate::entry::ModelEntry;
pub use crate::loaded_model::Visitor;

use crate::{built_in as program, registry};

/// Does something with the model of `entry`; none if it is a copy of an entry.
pub fn visit<V: Visitor>(entry: &ModelEntry, visitor: V) -> Option<V::Output> {
    let model = program::model(entry).or_else(|| registry::model(entry))?;
    Some(model.visit(visitor))
}

/// Every model: those of the program, then the newest version of each that was read from a file,
/// in the order in which they were read first.
pub fn entries() -> impl Iterator<Item = &'static ModelEntry> {
    built_ins().chain(registry::newest())
}

/// Every model that is part of the program.
pub fn built_ins() -> impl Iterator<Item = &'static ModelEntry> + Clone {
    program::entries()
}

/// The model called `name` that is part of the program, if there is one.
pub fn built_in(name: &str) -> Option<&'static ModelEntry> {
    built_ins().find(|entry| entry.name == name)
}

/// The newest version of the model called `name`: that of the file that was read last, else the
/// one that is part of the program, if there is one.
pub fn find(name: &str) -> Option<&'static ModelEntry> {
    registry::find(name).or_else(|| built_in(name))
}
