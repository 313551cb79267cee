//! Moments of a recording that are worth finding again.

use std::collections::BTreeSet;
use std::fmt;

use super::reader::{Messages, Recording};
use crate::event::Kind;
use crate::source::Mark;
use crate::{Event, Topic, Update, key_name};

/// Shortest time between two marked strikes, or two late ticks (ns).
const THINNED: u64 = 1_000_000_000;

/// Returns moments worth finding again: faults and recoveries, boards, late ticks and strikes,
/// these two at most once a second. Reads every chunk that has events; skips unreadable ones.
pub fn marks(recording: &Recording) -> Marks<'_> {
    let events = recording.read(0, u64::MAX, &BTreeSet::from([Topic::Events]));
    Marks { events, strike: None, miss: None }
}

/// Iterator of [`marks`].
pub struct Marks<'a> {
    events: Messages<'a>,
    /// Time of the last mark (ns since 1970).
    strike: Option<u64>,
    miss: Option<u64>,
}

impl Marks<'_> {
    fn mark(&mut self, at: u64, event: &Event) -> Option<Mark> {
        let is_far = |last: &mut Option<u64>| {
            let is_far = last.is_none_or(|last| last.abs_diff(at) >= THINNED);
            if is_far {
                *last = Some(at);
            }
            is_far
        };
        let (text, is_fault) = match event.kind() {
            Kind::Strike if is_far(&mut self.strike) => {
                (format!("{} struck", key_name(event.key)), false)
            }
            Kind::Miss if is_far(&mut self.miss) => (with_text("late", event), true),
            Kind::Fault => (with_text(&format!("{}: fault", key_name(event.key)), event), true),
            Kind::Recovery => (format!("{} recovered", key_name(event.key)), false),
            Kind::Board => (with_text("board", event), false),
            Kind::Overload => (with_text("load", event), false),
            Kind::Starved if is_far(&mut self.miss) => (with_text("load", event), true),
            Kind::Disarm => ("all forces fade".to_owned(), false),
            Kind::Strike
            | Kind::Miss
            | Kind::Starved
            | Kind::Unknown
            | Kind::Switch
            | Kind::DamperLift
            | Kind::Pressure
            | Kind::DamperFall
            | Kind::Skip
            | Kind::Change
            | Kind::Pedal
            | Kind::Arm => return None,
        };
        Some(Mark { at, text, is_fault })
    }
}

impl Iterator for Marks<'_> {
    type Item = Mark;

    fn next(&mut self) -> Option<Mark> {
        loop {
            let Ok((at, Update::Event(event))) = self.events.next()? else { continue };
            if let Some(mark) = self.mark(at, &event) {
                return Some(mark);
            }
        }
    }
}

impl fmt::Debug for Marks<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Marks").field("events", &self.events).finish_non_exhaustive()
    }
}

fn with_text(what: &str, event: &Event) -> String {
    if event.text.is_empty() { what.to_owned() } else { format!("{what}: {}", event.text) }
}
