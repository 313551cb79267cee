//! Names of quantities, modes and guards, shared by all models of the process.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// Returns the process's one copy of `name`, kept until the program ends.
pub(super) fn name(name: &str) -> &'static str {
    static NAMES: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    let mut names = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = names.get(name) {
        return known;
    }
    let kept: &'static str = Box::leak(name.into());
    names.insert(kept);
    kept
}
