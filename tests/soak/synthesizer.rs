//! The destination of MIDI: like an instrument, it keeps sounding when its port vanishes.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use midi::{MidiSystem, Unavailable};

use crate::watch::Digest;

#[derive(Clone, Debug)]
pub(crate) struct Sounds {
    since: [Option<u64>; 128],
    /// Longest sounding of a note (ticks).
    pub(crate) longest: u64,
    pub(crate) notes: u64,
    pub(crate) lost: u64,
    pub(crate) digest: Digest,
}

impl Default for Sounds {
    fn default() -> Self {
        let (since, digest) = ([None; 128], Digest::default());
        Self { since, longest: 0, notes: 0, lost: 0, digest }
    }
}

impl Sounds {
    pub(crate) fn sounding(&self) -> usize {
        self.since.iter().flatten().count()
    }

    /// Receives a message at `now` (ticks, or another unit of the caller's).
    pub(crate) fn take(&mut self, bytes: &[u8], now: u64) {
        for byte in bytes {
            self.digest.add(u64::from(*byte));
        }
        let &[status, note, velocity] = bytes else { return };
        let Some(since) = self.since.get_mut(usize::from(note)) else { return };
        match status & 0xf0 {
            0x90 if 0 < velocity => {
                self.notes += 1;
                since.get_or_insert(now);
            }
            0x80 | 0x90 => {
                let began = since.take().unwrap_or(now);
                self.longest = self.longest.max(now.saturating_sub(began));
            }
            _ => {}
        }
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Synthesizer(Arc<Mutex<Sounds>>);

impl Synthesizer {
    pub(crate) fn new() -> Self {
        Self(Arc::default())
    }

    pub(crate) fn sounds(&self) -> MutexGuard<'_, Sounds> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn port(&self, away: Vec<Range<u64>>, now: Arc<AtomicU64>) -> SynthesizerPort {
        SynthesizerPort { synthesizer: self.clone(), away, now, connected: None }
    }
}

#[derive(Debug)]
pub(crate) struct SynthesizerPort {
    synthesizer: Synthesizer,
    away: Vec<Range<u64>>,
    now: Arc<AtomicU64>,
    connected: Option<u64>,
}

impl SynthesizerPort {
    fn now(&self) -> u64 {
        self.now.load(Ordering::Acquire)
    }
}

impl MidiSystem for SynthesizerPort {
    fn connect(&mut self) -> Result<(), Unavailable> {
        self.connected = self.is_there().then(|| self.now());
        self.connected.map(|_now| ()).ok_or(Unavailable::NotStarted)
    }

    fn send(&mut self, bytes: &[u8]) -> bool {
        let now = self.now();
        // A connection does not outlive its port.
        let was_away = |since: u64| self.away.iter().any(|it| it.start <= now && since < it.end);
        if self.connected.is_some_and(was_away) {
            self.connected = None;
            self.synthesizer.sounds().lost += 1;
        }
        if self.connected.is_some() {
            self.synthesizer.sounds().take(bytes, now);
        }
        self.connected.is_some()
    }

    fn destination(&self) -> Option<String> {
        None
    }

    fn is_there(&mut self) -> bool {
        let now = self.now();
        !self.away.iter().any(|it| it.contains(&now))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use midi::{Message, Note, Output as _, ReconnectingPort, Velocity};

    #[test]
    fn a_note_that_was_held_when_the_port_vanished_ends_when_it_is_back() {
        let (synthesizer, now) = (Synthesizer::new(), Arc::new(AtomicU64::new(0)));
        let port = synthesizer.port(std::iter::once(10..20).collect(), Arc::clone(&now));
        let mut port = ReconnectingPort::connect(port, "it".to_owned()).expect("it is there");
        let note = |number| Note::from_number(number).expect("a note");
        let on = |number| Message::NoteOn { note: note(number), velocity: Velocity::UNKNOWN };
        let off = |number| Message::NoteOff { note: note(number), velocity: Velocity::UNKNOWN };
        port.send(0.0, on(60)).expect("sent");
        now.store(12, Ordering::Release);
        assert!(port.send(0.012, off(60)).is_err());
        let sounds = synthesizer.sounds().clone();
        assert_eq!((sounds.sounding(), sounds.lost), (1, 1));
        now.store(1200, Ordering::Release);
        port.send(1.2, on(62)).expect("sent");
        port.send(1.3, off(62)).expect("sent");
        let sounds = synthesizer.sounds().clone();
        assert_eq!((sounds.sounding(), sounds.longest), (0, 1200));
    }
}
