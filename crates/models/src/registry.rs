//! Models that are read from files while the program runs.
//!
//! A list that only grows, for the whole process: whoever reads a description leaks a
//! [`Registration`] on purpose and appends it here. Voices that play a version of a model keep it
//! when a newer one is registered under its name; a look-up by name finds the newest. A version
//! takes what its table and its machine code take, some 10 to 500 KiB, and a description that is
//! saved a hundred times while somebody works on it takes a hundred of them: tens of megabytes at
//! most, until the program ends.

use std::sync::OnceLock;

use crate::entry::ModelEntry;

pub use crate::equation_model::MAX_CODED_CONTACTS;
pub use crate::loaded_model::{DoesNotLoad, LARGEST, LoadedModel, SmallModel};

/// A version of a model in the list of those that were read from files.
#[derive(Debug)]
pub struct Registration {
    model: LoadedModel,
    /// The one that was registered next.
    next: OnceLock<&'static Self>,
}

impl Registration {
    /// A version that is not in the list yet.
    #[expect(clippy::large_stack_frames, reason = "once for a description, off the tick")]
    pub const fn new(model: LoadedModel) -> Self {
        Self { model, next: OnceLock::new() }
    }
}

/// The oldest registration.
static FIRST: OnceLock<&'static Registration> = OnceLock::new();

/// Appends a version of a model, from which on it is the one that its name finds.
///
/// One that is in the list already stays where it is.
pub fn register(registration: &'static Registration) {
    let mut place = &FIRST;
    // Each turn is one registration further, or ends.
    while place.set(registration).is_err() {
        let Some(taken) = place.get() else { return };
        if core::ptr::eq(*taken, registration) {
            return;
        }
        place = &taken.next;
    }
}

/// Every registration, the oldest first.
fn all() -> impl Iterator<Item = &'static Registration> {
    core::iter::successors(FIRST.get().copied(), |it| it.next.get().copied())
}

/// The newest version of each model, in the order in which their first versions were registered.
pub(crate) fn newest() -> impl Iterator<Item = &'static ModelEntry> {
    let entry = |index: usize| all().nth(index).map(|it| it.model.entry());
    let is_first =
        move |index: usize, name: &str| all().take(index).all(|it| it.model.entry().name != name);
    let names = (0..).map_while(entry).enumerate();
    names.filter(move |(index, it)| is_first(*index, it.name)).filter_map(|(_, it)| find(it.name))
}

/// The newest version of the model called `name`.
pub(crate) fn find(name: &str) -> Option<&'static ModelEntry> {
    all().map(|it| it.model.entry()).filter(|it| it.name == name).last()
}

/// The model of `entry`, if it is in the list.
pub(crate) fn model(entry: &ModelEntry) -> Option<&'static LoadedModel> {
    Some(&all().find(|it| it.model.entry().is(entry))?.model)
}
