//! Notes from note-ons and note-offs, one at a time on each key.

use std::collections::{BTreeMap, VecDeque};

use midi::{Note, Pedal, PedalMove, Velocity};
use midly::{MidiMessage, TrackEventKind};

use super::{Score, ScoreNote};

/// Channel 10, counted from 0: percussion by convention.
const PERCUSSION: u8 = 9;

/// The notes so far.
#[derive(Debug, Default)]
pub(super) struct NoteCollector {
    /// All notes; an open note has an infinite end.
    heard: Vec<ScoreNote>,
    /// Open notes by channel and key, the oldest first.
    open: BTreeMap<(u8, u8), VecDeque<usize>>,
    pedals: Vec<PedalMove>,
    skipped: u32,
    /// Time of the latest event (s).
    now: f64,
}

impl NoteCollector {
    /// Adds an event at time `at` (s).
    pub(super) fn hear(&mut self, at: f64, event: TrackEventKind<'_>) {
        self.now = at;
        if let TrackEventKind::Midi { channel, message } = event {
            self.hear_message(at, channel.as_int(), message);
        }
    }

    fn hear_message(&mut self, at: f64, channel: u8, message: MidiMessage) {
        #[expect(
            clippy::wildcard_enum_match_arm,
            reason = "a foreign protocol, we hear notes and pedals only"
        )]
        match message {
            MidiMessage::NoteOn { key, vel } if vel > 0 => {
                self.begin(at, channel, key.as_int(), vel.as_int());
            }
            MidiMessage::NoteOn { key, .. } => self.end(at, channel, key.as_int(), None),
            MidiMessage::NoteOff { key, vel } => {
                // 64 means that the keyboard does not measure it.
                let told = Velocity::new(vel.as_int()).filter(|it| *it != Velocity::UNKNOWN);
                self.end(at, channel, key.as_int(), told);
            }
            MidiMessage::Controller { controller, value } => {
                let depth = f64::from(value.as_int()) / 127.0;
                let pedal = Pedal::of_number(controller.as_int());
                self.pedals.extend(pedal.map(|pedal| PedalMove { pedal, at, depth }));
            }
            _ => {}
        }
    }

    fn begin(&mut self, onset: f64, channel: u8, number: u8, velocity: u8) {
        match Note::from_number(number) {
            Some(note) if channel != PERCUSSION => {
                let key = note.key();
                self.open.entry((channel, key)).or_default().push_back(self.heard.len());
                self.heard.push(ScoreNote {
                    key,
                    onset,
                    end: f64::INFINITY,
                    velocity,
                    release: None,
                });
            }
            _ => self.skipped = self.skipped.saturating_add(1),
        }
    }

    fn end(&mut self, at: f64, channel: u8, number: u8, release: Option<Velocity>) {
        let Some(note) = Note::from_number(number) else { return };
        let oldest = self.open.get_mut(&(channel, note.key())).and_then(VecDeque::pop_front);
        if let Some(note) = oldest.and_then(|index| self.heard.get_mut(index)) {
            (note.end, note.release) = (at, release);
        }
    }

    /// Returns the score: open notes end now, and each key holds one note at a time.
    pub(super) fn into_score(mut self) -> Score {
        for note in &mut self.heard {
            note.end = note.end.min(self.now).max(note.onset);
        }
        let (mut notes, overlaps) = part(self.heard);
        notes.sort_by(|a, b| a.onset.total_cmp(&b.onset).then(a.key.cmp(&b.key)));
        Score { notes, pedals: self.pedals, skipped: self.skipped, overlaps }
    }
}

/// Ends every note where the next on its key begins, and counts the affected notes. Of notes that
/// begin together on one key, the loudest stays and lasts as long as the longest.
fn part(mut notes: Vec<ScoreNote>) -> (Vec<ScoreNote>, u32) {
    notes.sort_by(|a, b| a.key.cmp(&b.key).then(a.onset.total_cmp(&b.onset)));
    let mut parted: Vec<ScoreNote> = Vec::with_capacity(notes.len());
    let mut overlaps = 0_u32;
    for note in notes {
        match parted.last_mut().filter(|last| last.key == note.key) {
            Some(last) if last.onset >= note.onset => {
                overlaps += 1;
                last.velocity = last.velocity.max(note.velocity);
                last.end = last.end.max(note.end);
                continue;
            }
            Some(last) if last.end > note.onset => {
                overlaps += 1;
                last.end = note.onset;
            }
            _ => {}
        }
        parted.push(note);
    }
    (parted, overlaps)
}
