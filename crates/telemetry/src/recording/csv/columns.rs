//! Contents of the columns of a table.

use crate::{Catalogue, Model};

pub(super) const EVENTS: [&str; 10] =
    ["t [s]", "tick", "theta", "key", "kind", "from", "to", "guard", "speed [m/s]", "text"];

const COLUMNS: [&str; 8] =
    ["t [s]", "tick", "position [m]", "force [N]", "sent [N]", "mode", "flags", "fault"];

const FLAGS: [&str; 8] = ["asleep", "late", "fresh", "gap before", "waited", "32", "64", "128"];

const FAULTS: [&str; 8] =
    ["", "not finite", "bad sample", "capped", "diverged", "panicked", "makes energy", "muted"];

pub(super) fn header(model: &Model) -> Vec<String> {
    let signals = model.signals.iter().map(|signal| match signal.unit.as_str() {
        "" => signal.name.clone(),
        unit => format!("{} [{unit}]", signal.name),
    });
    COLUMNS.map(str::to_owned).into_iter().chain(signals).collect()
}

/// Returns the time since tick 0 (s).
pub(super) fn seconds(catalogue: &Catalogue, tick: u64, theta: f64) -> f64 {
    (tick as f64 + theta) / f64::from(catalogue.tick_hz)
}

pub(super) fn mode(model: &Model, mode: u32) -> String {
    let name = usize::try_from(mode).ok().and_then(|mode| model.modes.get(mode));
    name.map_or_else(|| mode.to_string(), Clone::clone)
}

pub(super) fn flags(bits: u8) -> String {
    let set = FLAGS.iter().enumerate().filter(|(bit, _)| bits >> bit & 1 == 1);
    set.map(|(_, name)| *name).collect::<Vec<_>>().join("+")
}

pub(super) fn fault(fault: u8) -> String {
    let name = FAULTS.get(usize::from(fault));
    name.map_or_else(|| fault.to_string(), |name| (*name).to_owned())
}
