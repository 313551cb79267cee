//! Moments of a recording that are worth finding again.

use std::collections::{BTreeSet, VecDeque};
use std::fmt;

use documents::shortened;

use super::reader::{Messages, Recording};
use crate::{Event, Topic, Update, event::Kind, key_name, source::Mark};

/// Time within which late ticks are one mark (ns): each of them may be late.
const LATE: u64 = 1_000_000_000;

/// Most marks of strikes, of changes, and of all others: some 5 MB each. Each kind has its own
/// bound, so that a key that fails all the time displaces no strike.
const MAX_MARKS: u64 = 50_000;

/// Longest text of a change (characters); other texts are shorter.
const MAX_TEXT: usize = 240;

/// Returns moments worth finding again, in order: strikes, changes of values and settings, faults
/// and recoveries, boards, loads and late ticks (one mark per second).
///
/// The last mark counts the moments beyond 50,000 of a kind, if any. Skips unreadable chunks.
pub fn marks(recording: &Recording) -> Marks<'_> {
    let events = recording.read(0, u64::MAX, &BTreeSet::from([Topic::Events]));
    Marks { events, queue: VecDeque::new(), late: None, counts: [0; 3], end: 0 }
}

/// Iterator of [`marks`].
pub struct Marks<'a> {
    events: Messages<'a>,
    queue: VecDeque<Mark>,
    /// Index of the mark of late ticks in the queue that further ones join, and their number.
    late: Option<(usize, u64)>,
    /// Numbers of strikes, changes and other moments.
    counts: [u64; 3],
    /// Time of the last event (ns since 1970).
    end: u64,
}

impl Marks<'_> {
    fn enter(&mut self, at: u64, event: &Event) {
        self.end = self.end.max(at);
        let (text, is_fault) = match event.kind() {
            Kind::Strike => (format!("{} struck", key_name(event.key)), false),
            Kind::Change => (changed(event), false),
            Kind::Fault => (with_text(&format!("{}: fault", key_name(event.key)), event), true),
            Kind::Recovery => (format!("{} recovered", key_name(event.key)), false),
            Kind::Board => (with_text("board", event), false),
            Kind::Overload => (with_text("load", event), false),
            Kind::Miss | Kind::Starved if self.joins(at) => return,
            Kind::Miss => (with_text("late", event), true),
            Kind::Starved => (with_text("load", event), true),
            Kind::Disarm => ("all forces fade".to_owned(), false),
            Kind::Unknown
            | Kind::Switch
            | Kind::DamperLift
            | Kind::Pressure
            | Kind::DamperFall
            | Kind::Skip
            | Kind::Pedal
            | Kind::Arm => return,
        };
        let kinds = [Kind::Strike, Kind::Change];
        let kind = kinds.iter().position(|it| *it == event.kind()).unwrap_or(kinds.len());
        self.counts[kind] += 1;
        if self.counts[kind] <= MAX_MARKS {
            if matches!(event.kind(), Kind::Miss | Kind::Starved) {
                self.late = Some((self.queue.len(), 1));
            }
            self.queue.push_back(Mark { at, text, is_fault });
        }
    }

    fn joins(&mut self, at: u64) -> bool {
        self.close(at);
        self.late.as_mut().map(|(_, count)| *count += 1).is_some()
    }

    fn close(&mut self, at: u64) {
        let Some((index, count)) = self.late else { return };
        let Some(mark) = self.queue.get_mut(index) else { return };
        if LATE <= at.saturating_sub(mark.at) {
            self.late = None;
            if 1 < count {
                mark.text = format!("{} × {count}", mark.text);
            }
        }
    }

    /// Returns the mark that counts the moments beyond the bound, once.
    fn left_out(&mut self) -> Option<Mark> {
        let counts = std::mem::take(&mut self.counts).map(|it| it.saturating_sub(MAX_MARKS));
        let named = counts.into_iter().zip(["strikes", "changes", "other moments"]);
        let named: Vec<_> =
            named.filter(|it| 0 < it.0).map(|(count, kind)| format!("{count} {kind}")).collect();
        let text = format!("not listed: {}; a list holds {MAX_MARKS} of each", named.join(", "));
        (!named.is_empty()).then_some(Mark { at: self.end, text, is_fault: true })
    }
}

impl Iterator for Marks<'_> {
    type Item = Mark;

    fn next(&mut self) -> Option<Mark> {
        loop {
            if self.late.is_none_or(|(index, _)| 0 < index)
                && let Some(mark) = self.queue.pop_front()
            {
                self.late = self.late.map(|(index, count)| (index - 1, count));
                return Some(mark);
            }
            match self.events.next() {
                Some(Ok((at, Update::Event(event)))) => {
                    self.close(at);
                    self.enter(at, &event);
                }
                Some(Ok(_) | Err(_)) => {}
                None if self.late.is_some() => self.close(u64::MAX),
                None => return self.left_out(),
            }
        }
    }
}

impl fmt::Debug for Marks<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Marks").field("events", &self.events).finish_non_exhaustive()
    }
}

fn changed(event: &Event) -> String {
    let text = event.text.chars().take(MAX_TEXT).collect();
    if event.text.is_empty() { "changed".to_owned() } else { text }
}

fn with_text(what: &str, event: &Event) -> String {
    if event.text.is_empty() {
        what.to_owned()
    } else {
        format!("{what}: {}", shortened(&event.text))
    }
}
