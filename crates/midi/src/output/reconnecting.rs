//! A connection that restores itself, note-offs first.

use keyboard::{KEYS, KeyIndex};

use std::io;
use std::path::Path;

use super::{MidiSendError, Output, Unavailable};
use crate::ledger::NoteLedger;
use crate::message::Message;
use crate::note::{Note, Velocity};
use crate::pedal::{Pedal, PedalValues};

/// Least time between two attempts to connect, and between two checks of the port (s).
const INTERVAL: f64 = 1.0;

/// Connection that can be lost: the system's MIDI, or a test's.
pub trait MidiSystem {
    /// Connects again, and drops the earlier connection.
    fn connect(&mut self) -> Result<(), Unavailable>;

    /// Sends one message; returns `false` if it was not accepted.
    fn send(&mut self, bytes: &[u8]) -> bool;

    /// Returns `true` if the destination exists: some systems accept messages to a missing port.
    fn is_there(&mut self) -> bool;

    /// Returns the destination's full name, as known to other processes; `None` for our own port.
    fn destination(&self) -> Option<String>;
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum PortState {
    Up,
    Down,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Sound {
    Silent,
    /// Its note-off was accepted, but the destination was not checked since.
    Ended,
    Sounding,
}

/// Sends through a [`MidiSystem`] and connects it again when it is lost, note-offs first.
#[derive(Debug)]
pub struct ReconnectingPort<B> {
    backend: B,
    name: String,
    link: PortState,
    /// Time of the latest attempt to connect or check (s); `None` before.
    looked: Option<f64>,
    sounds: [Sound; KEYS],
    pedals: PedalValues,
    /// Notes that the destination may sound, for the next process that opens the port.
    ledger: Option<NoteLedger>,
    /// Messages that end the notes of a dead process, repeated before the first message: programs
    /// connect to a port of our own after it opens.
    owed: Vec<Message>,
}

/// Name of a port of our own in ledgers.
const OWN: &str = "virtual";

impl<B: MidiSystem> ReconnectingPort<B> {
    /// Connects `backend`, which people call `name`, for the first time.
    pub fn connect(mut backend: B, name: String) -> Result<Self, Unavailable> {
        backend.connect()?;
        let sounds = [Sound::Silent; KEYS];
        Ok(Self {
            backend,
            name,
            link: PortState::Up,
            looked: None,
            sounds,
            pedals: PedalValues::default(),
            ledger: None,
            owed: Vec::new(),
        })
    }

    /// Keeps a ledger of what the destination may sound in `folder`. Ends what dead processes have
    /// left there, but not what a running one holds.
    pub fn keep_ledger(&mut self, folder: &Path) -> io::Result<()> {
        let destination = self.backend.destination();
        let (ledger, mut left) = NoteLedger::open(folder, destination.as_deref().unwrap_or(OWN))?;
        self.ledger = Some(ledger);
        if left.is_silent() {
            return Ok(());
        }
        let ends = left.release();
        for message in &ends {
            if let Message::NoteOff { note, .. } = message {
                self.hear(*note, Sound::Sounding);
            }
        }
        // A destination that is away gets them when it is back.
        let _is_sent = ends.iter().all(|message| self.deliver(*message));
        if destination.is_none() {
            self.owed = ends;
        }
        Ok(())
    }

    fn is_due(&self, now: f64) -> bool {
        self.looked.is_none_or(|looked| now - looked >= INTERVAL)
    }

    fn reconnect(&mut self, now: f64) -> bool {
        if !self.is_due(now) {
            return false;
        }
        self.looked = Some(now);
        if self.backend.connect().is_err() {
            return false;
        }
        self.link = PortState::Up;
        if let (Some(ledger), Some(name)) = (&mut self.ledger, self.backend.destination()) {
            let _unwritten = ledger.rename(&name);
        }
        self.restore()
    }

    /// Confirms the sent note-offs: the destination was there all the time.
    fn confirm(&mut self) {
        for sound in self.sounds.iter_mut().filter(|sound| **sound == Sound::Ended) {
            *sound = Sound::Silent;
        }
    }

    /// Silences what the destination may still sound, and sets its pedals.
    fn restore(&mut self) -> bool {
        for note in KeyIndex::all().filter_map(|key| Note::from_key(key.number())) {
            let off = Message::NoteOff { note, velocity: Velocity::UNKNOWN };
            let sound = self.sounds[usize::from(note.key())];
            if sound != Sound::Silent && !self.deliver(off) {
                return false;
            }
        }
        let pedals = self.pedals;
        pedals.all().all(|(pedal, value)| {
            self.deliver(Message::ControlChange { controller: pedal.controller(), value })
        })
    }

    fn deliver(&mut self, message: Message) -> bool {
        // Music continues if the disk is full.
        let _unwritten = self.ledger.as_mut().map(|ledger| ledger.begin(message));
        let accepted = self.backend.send(&message.encode());
        if accepted {
            self.remember(message);
            let _unwritten = self.ledger.as_mut().map(|ledger| ledger.end(message));
        } else {
            self.link = PortState::Down;
        }
        accepted
    }

    fn remember(&mut self, message: Message) {
        match message {
            Message::NoteOn { note, .. } => self.hear(note, Sound::Sounding),
            Message::NoteOff { note, .. } => self.hear(note, Sound::Ended),
            Message::ControlChange { .. }
            | Message::KeyPressure { .. }
            | Message::ChannelPressure { .. } => {}
        }
    }

    fn hear(&mut self, note: Note, sound: Sound) {
        self.sounds[usize::from(note.key())] = sound;
    }

    fn follow_pedals(&mut self, message: Message) {
        if let Message::ControlChange { controller, value } = message
            && let Some(pedal) = Pedal::of_number(controller.number())
        {
            self.pedals.set(pedal, value);
        }
    }

    fn away(&self) -> MidiSendError {
        MidiSendError::Away { port: self.name.clone() }
    }
}

impl<B: MidiSystem> Output for ReconnectingPort<B> {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        for ends in std::mem::take(&mut self.owed) {
            self.deliver(ends);
        }
        self.follow_pedals(message);
        if self.link == PortState::Up && self.deliver(message) {
            return Ok(());
        }
        if self.reconnect(at) && self.deliver(message) {
            return Ok(());
        }
        Err(self.away())
    }

    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        if self.link == PortState::Up && self.is_due(now) {
            self.looked = Some(now);
            if self.backend.is_there() {
                self.confirm();
            } else {
                self.link = PortState::Down;
                // Try an absent port at once: only its number may have changed.
                self.looked = None;
            }
        }
        if self.link == PortState::Up || self.reconnect(now) { Ok(()) } else { Err(self.away()) }
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::Controller;

    const UP: [[u8; 3]; 3] = [[0xB0, 64, 0], [0xB0, 66, 0], [0xB0, 67, 0]];

    /// Destination that the test unplugs and plugs in.
    #[derive(Default)]
    struct Plug {
        unplugged: bool,
        /// `true` if a connection from before the last unplugging still swallows messages.
        connected: bool,
        attempts: u32,
        received: Vec<[u8; 3]>,
    }

    impl MidiSystem for Plug {
        fn connect(&mut self) -> Result<(), Unavailable> {
            self.attempts += 1;
            self.connected = !self.unplugged;
            if self.connected { Ok(()) } else { Err(Unavailable::NotStarted) }
        }

        fn send(&mut self, bytes: &[u8]) -> bool {
            if self.connected {
                self.received.push(bytes.try_into().unwrap());
            }
            self.connected
        }

        fn is_there(&mut self) -> bool {
            !self.unplugged
        }

        fn destination(&self) -> Option<String> {
            Some("plug".to_owned())
        }
    }

    fn port() -> ReconnectingPort<Plug> {
        ReconnectingPort::connect(Plug::default(), "plug".to_owned()).unwrap()
    }

    fn unplug(port: &mut ReconnectingPort<Plug>) {
        port.backend.unplugged = true;
        port.backend.connected = false;
    }

    fn on(number: u8) -> Message {
        Message::NoteOn { note: Note::from_number(number).unwrap(), velocity: Velocity::UNKNOWN }
    }

    fn off(number: u8) -> Message {
        Message::NoteOff { note: Note::from_number(number).unwrap(), velocity: Velocity::UNKNOWN }
    }

    #[test]
    fn when_the_port_is_back_note_offs_come_first() {
        let mut port = port();
        port.send(0.0, on(60)).unwrap();
        unplug(&mut port);
        assert!(port.send(1.0, off(60)).is_err());
        port.backend.unplugged = false;
        port.send(2.5, on(64)).unwrap();
        let [sustain, sostenuto, una_corda] = UP;
        let expected = [[0x80, 60, 64], sustain, sostenuto, una_corda, [0x90, 64, 64]];
        assert_eq!(port.backend.received[1..], expected);
    }

    #[test]
    fn a_lost_port_is_tried_at_most_once_a_second() {
        let mut port = port();
        unplug(&mut port);
        for step in 0..300 {
            assert!(port.send(f64::from(step) * 0.01, on(60)).is_err());
        }
        assert_eq!(port.backend.attempts, 1 + 3);
    }

    #[test]
    fn a_port_that_vanishes_without_a_word_is_noticed_and_connected_again() {
        let mut port = port();
        port.send(0.0, on(60)).unwrap();
        port.poll(0.1).unwrap();
        port.backend.unplugged = true;
        assert!(port.poll(0.5).is_ok(), "not looked at again yet");
        assert!(port.poll(1.2).is_err());
        port.backend.unplugged = false;
        assert!(port.poll(1.5).is_err(), "not tried again yet");
        port.poll(2.3).unwrap();
        assert_eq!(port.backend.received[1..2], [[0x80, 60, 64]]);
        assert_eq!(port.backend.received[2..], UP);
    }

    #[test]
    fn a_note_that_ended_after_the_port_had_vanished_is_ended_again() {
        let mut port = port();
        port.send(0.0, on(60)).unwrap();
        port.send(0.1, on(64)).unwrap();
        port.send(0.2, off(60)).unwrap();
        port.poll(0.3).unwrap();
        // The connection accepts messages a while longer, and they are lost.
        port.backend.unplugged = true;
        port.send(0.5, off(64)).unwrap();
        assert!(port.poll(1.4).is_err());
        port.backend.unplugged = false;
        port.poll(2.5).unwrap();
        assert_eq!(port.backend.received[4..5], [[0x80, 64, 64]]);
        assert_eq!(port.backend.received[5..], UP);
    }

    #[test]
    fn a_pedal_that_was_lifted_meanwhile_is_up() {
        let mut port = port();
        let at = |controller, value| Message::ControlChange { controller, value };
        port.send(0.0, at(Controller::Sustain, 127)).unwrap();
        port.send(0.1, at(Controller::UnaCorda, 90)).unwrap();
        unplug(&mut port);
        assert!(port.send(1.0, at(Controller::Sustain, 0)).is_err());
        port.backend.unplugged = false;
        port.poll(2.0).unwrap();
        // The pressed pedal is pressed again.
        let expected = [[0xB0, 64, 0], [0xB0, 66, 0], [0xB0, 67, 90]];
        assert_eq!(port.backend.received[2..], expected);
    }
}
