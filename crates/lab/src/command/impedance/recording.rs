//! Reads a key's positions and forces from a recording.

use std::{collections::BTreeSet, path::Path};

use crate::impedance::{ForceHold, RecordedStroke};
use documents::shown;
use keyboard::KeyIndex;
use telemetry::recording::{Recording, Row, rows};
use telemetry::{Topic, Update};

/// Maximum ticks from a recording: a hundred minutes at 1 kHz.
const MOST_TICKS: usize = 6_000_000;

/// Reads the stroke of `key`, with forces that act `delay` (s) after their sample.
pub(super) fn read_stroke(
    path: &Path,
    key: KeyIndex,
    delay: f64,
) -> Result<RecordedStroke, String> {
    let recording = Recording::open(path).map_err(|error| error.to_string())?;
    let catalogue = recording.catalogue().map_err(|error| error.to_string())?;
    let hz = catalogue.map(|it| it.tick_hz).filter(|hz| *hz > 0);
    let file = shown(path);
    let hz = hz.ok_or_else(|| format!("{file} does not say at which rate it was recorded"))?;
    let held = ForceHold { period: 1.0 / f64::from(hz), delay };
    let name = format!("{key} of {file}");
    let mut stroke = RecordedStroke { name, held, position: Vec::new(), force: Vec::new() };
    let mut last = None;
    for message in recording.read(0, u64::MAX, &BTreeSet::from([Topic::Block(key.number())])) {
        let message = message.map_err(|error| format!("{error}; `letoff recover` may help"))?;
        let (_, Update::Block(block)) = message else { continue };
        for row in rows(&block, |_revision| 0) {
            enter(&mut stroke, &mut last, &row)?;
        }
    }
    if stroke.position.is_empty() {
        return Err(format!("{file} has nothing of {key}; choose another --key"));
    }
    Ok(stroke)
}

fn enter(stroke: &mut RecordedStroke, last: &mut Option<u64>, row: &Row<'_>) -> Result<(), String> {
    if !(row.position.is_finite() && row.sent.is_finite()) {
        return Ok(());
    }
    let ticks = last.map_or(1, |last| row.tick.saturating_sub(last));
    let ticks = usize::try_from(ticks).unwrap_or(usize::MAX);
    if ticks > MOST_TICKS.saturating_sub(stroke.position.len()) {
        return Err(format!("{} has more than {MOST_TICKS} ticks; record less", stroke.name));
    }
    for (column, value) in [(&mut stroke.position, row.position), (&mut stroke.force, row.sent)] {
        let before = column.last().copied().unwrap_or(value);
        column.resize(column.len() + ticks.saturating_sub(1), before);
        column.extend((ticks > 0).then_some(value));
    }
    *last = Some(row.tick.max(last.unwrap_or(0)));
    Ok(())
}
