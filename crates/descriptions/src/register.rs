//! From a table and functions to a registered model.

use std::path::Path;

use equations::table::{Functions, ModelTable};
use models::catalogue::ModelEntry;
use models::entry_of_table::{entry, leak};
use models::registry::{self, DoesNotLoad, LoadedModel, Registration};
use models::{LoadedFunctions, registry::MAX_CODED_CONTACTS};

/// Why a model has no place in the catalogue.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NotRegistered(DoesNotLoad);

impl std::fmt::Display for NotRegistered {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (states, constants) = registry::LARGEST;
        match self.0 {
            DoesNotLoad::States(found) => {
                write!(f, "the model has {found} states, more than {states}")
            }
            DoesNotLoad::Constants(found) => write!(
                f,
                "the model has {found} parameters and numbers that follow from them, more than \
                 {constants}"
            ),
            DoesNotLoad::Modes(found) => write!(f, "the model has {found} modes, too many"),
            DoesNotLoad::Contacts(found) => {
                write!(f, "the model has {found} contacts, more than {MAX_CODED_CONTACTS}")
            }
            DoesNotLoad::Guards => f.write_str("the model has too many contacts and guards"),
        }
    }
}

impl std::error::Error for NotRegistered {}

/// Puts the model of `table` and `functions` into the catalogue: from then on it is the one that
/// its name finds. `file` is where it was read from.
///
/// # Errors
/// A model that is larger than any that can be loaded.
#[expect(clippy::large_stack_frames, reason = "once for a description, off the tick")]
pub fn register_model(
    table: &'static ModelTable,
    functions: &'static dyn Functions,
    file: Option<&Path>,
) -> Result<&'static ModelEntry, NotRegistered> {
    let entry = entry(table, functions, file);
    let model = LoadedModel::new(table, LoadedFunctions::new(functions, entry));
    registry::register(leak(Registration::new(model.map_err(NotRegistered)?)));
    Ok(entry)
}
