//! Entries of the catalogue, in few words.

use models::{GuardEntry, ModeEntry};

/// A mode with `n` coordinates and `m` constraints among them.
pub(crate) const fn mode(
    name: &'static str,
    (n, m): (u8, u8),
    guards: &'static [GuardEntry],
) -> ModeEntry {
    ModeEntry { name, n, m, p: n - m, guards }
}

/// A guard that leads to one of the modes `to`.
pub(crate) const fn guard(
    name: &'static str,
    unit: &'static str,
    to: &'static [&'static str],
) -> GuardEntry {
    GuardEntry { name, unit, to }
}
