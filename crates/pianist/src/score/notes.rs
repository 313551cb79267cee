//! Notes and pedals from the messages of channels, one note at a time on each key.

use std::collections::{BTreeMap, VecDeque};

use midi::{Note, Pedal, PedalMove, Velocity};

use super::passed_over::{PassedOver, PassedOverCounts};
use super::{ChosenParts, ScoreNote};

/// Channel 10, counted from 0: percussion by convention.
const PERCUSSION: u8 = 9;

#[derive(Debug, Default)]
pub(super) struct NoteCollector {
    pub(super) parts: ChosenParts,
    /// All notes; an open note has an infinite end.
    received: Vec<ScoreNote>,
    /// Open notes by channel and key, the oldest first.
    open: BTreeMap<(u8, u8), VecDeque<usize>>,
    /// Pedal moves with their channels.
    pedals: Vec<(u8, PedalMove)>,
    /// Channels with notes that are played, and that are left out: bit 0 for channel 1.
    played: u16,
    left_out: u16,
    pub(super) passed_over: PassedOverCounts,
    /// Time of the latest event (s).
    pub(super) now: f64,
}

impl NoteCollector {
    /// Adds a message of `track` at the latest time; returns `true` for a note.
    pub(super) fn add(&mut self, track: u16, status: u8, [first, second]: [u8; 2]) -> bool {
        let (kind, channel) = (status & 0xF0, status & 0x0F);
        let is_note = kind == 0x90 && 0 < second;
        if !self.parts.contain(track, channel + 1) {
            if is_note {
                self.leave_out(channel, PassedOver::NotChosen);
            }
            return is_note;
        }
        match kind {
            0x90 if is_note => self.begin(channel, first, second),
            0x90 => self.end(channel, first, None),
            0x80 => {
                // 64 means that the keyboard does not measure it.
                let release = Velocity::new(second).filter(|it| *it != Velocity::UNKNOWN);
                self.end(channel, first, release);
            }
            0xB0 => self.control(channel, first, second),
            0xC0 => self.passed_over.add(PassedOver::ProgramChanges, 1),
            0xE0 => self.passed_over.add(PassedOver::PitchBends, 1),
            _ => self.passed_over.add(PassedOver::Pressures, 1),
        }
        is_note
    }

    fn control(&mut self, channel: u8, controller: u8, value: u8) {
        match controller {
            7 | 11 => self.passed_over.add(PassedOver::VolumeChanges, 1),
            // All sound off, all notes off, and the changes of mode that end all notes.
            120 | 123..=127 => self.end_all(channel),
            // A reset of all controllers lifts the pedals.
            121 => Pedal::ALL.into_iter().for_each(|pedal| self.move_pedal(channel, pedal, 0)),
            _ => match Pedal::of_number(controller) {
                Some(pedal) => self.move_pedal(channel, pedal, value),
                None => self.passed_over.add(PassedOver::Controllers, 1),
            },
        }
    }

    fn move_pedal(&mut self, channel: u8, pedal: Pedal, value: u8) {
        let depth = f64::from(value) / 127.0;
        self.pedals.push((channel, PedalMove { pedal, at: self.now, depth }));
    }

    fn begin(&mut self, channel: u8, number: u8, velocity: u8) {
        if channel == PERCUSSION && self.parts.channels.is_empty() {
            return self.leave_out(channel, PassedOver::Percussion);
        }
        let Some(note) = Note::from_number(number) else {
            return self.leave_out(channel, PassedOver::OffKeyboard);
        };
        let key = note.key();
        self.played |= 1 << channel;
        self.open.entry((channel, key)).or_default().push_back(self.received.len());
        let (onset, end, release) = (self.now, f64::INFINITY, None);
        self.received.push(ScoreNote { key, onset, end, velocity, release });
    }

    fn leave_out(&mut self, channel: u8, why: PassedOver) {
        self.passed_over.add(why, 1);
        self.left_out |= 1 << channel;
    }

    fn end(&mut self, channel: u8, number: u8, release: Option<Velocity>) {
        let Some(note) = Note::from_number(number) else { return };
        let oldest = self.open.get_mut(&(channel, note.key())).and_then(VecDeque::pop_front);
        if let Some(note) = oldest.and_then(|index| self.received.get_mut(index)) {
            (note.end, note.release) = (self.now, release);
        }
    }

    fn end_all(&mut self, channel: u8) {
        let open = self.open.range_mut((channel, 0)..=(channel, u8::MAX));
        for index in open.flat_map(|(_, notes)| notes.drain(..)) {
            if let Some(note) = self.received.get_mut(index) {
                note.end = self.now;
            }
        }
    }

    /// Returns notes and pedals: open notes end now, and each key holds one note at a time.
    pub(super) fn finish(mut self) -> (Vec<ScoreNote>, Vec<PedalMove>, PassedOverCounts) {
        for note in &mut self.received {
            note.end = note.end.min(self.now).max(note.onset);
        }
        let pedals = self.merged_pedals();
        let (mut notes, overlaps) = part(self.received);
        self.passed_over.add(PassedOver::Overlapping, overlaps);
        notes.sort_by(|a, b| a.onset.total_cmp(&b.onset).then(a.key.cmp(&b.key)));
        (notes, pedals, self.passed_over)
    }

    /// Returns the moves of one piano's pedals: each is as deep as the deepest of its channels.
    /// Channels with only notes that are left out, such as percussion, move no pedal.
    fn merged_pedals(&mut self) -> Vec<PedalMove> {
        let silent = self.left_out & !self.played;
        let drums = if self.parts.channels.is_empty() { 1 << PERCUSSION } else { 0 };
        let mut depths = [[0.0_f64; 16]; Pedal::ALL.len()];
        let mut merged = Vec::with_capacity(self.pedals.len());
        for (channel, moved) in &self.pedals {
            if (silent | drums) >> channel & 1 == 1 {
                self.passed_over.add(PassedOver::PedalMoves, 1);
                continue;
            }
            let depths = &mut depths[moved.pedal as usize];
            depths[usize::from(*channel)] = moved.depth;
            let depth = depths.iter().copied().fold(0.0, f64::max);
            merged.push(PedalMove { depth, ..*moved });
        }
        merged
    }
}

/// Ends every note where the next on its key begins, and counts the affected notes. Of notes that
/// begin together on one key, the loudest stays and lasts as long as the longest.
fn part(mut notes: Vec<ScoreNote>) -> (Vec<ScoreNote>, usize) {
    notes.sort_by(|a, b| a.key.cmp(&b.key).then(a.onset.total_cmp(&b.onset)));
    let mut parted: Vec<ScoreNote> = Vec::with_capacity(notes.len());
    let mut overlaps = 0;
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
