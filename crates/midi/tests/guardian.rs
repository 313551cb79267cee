//! A host that falls silent or dies, and the messages of its guardian.

#![expect(clippy::unwrap_used, reason = "a test that cannot be set up fails")]

use std::collections::BTreeSet;

use midi::guardian::SILENT_AFTER;
mod common;

use midi::{Controller, Message, Note, NoteGuardian, Pedal, Velocity};

use common::MessageRecorder;
use proptest::prelude::*;

/// Receiver by the letter of the MIDI specification, which shares no line with `HeldNotes`.
#[derive(Default, PartialEq, Debug)]
struct Receiver {
    sounding: BTreeSet<u8>,
    /// Controllers with a value above 0.
    controllers: BTreeSet<u8>,
    pressure: u8,
    /// Note-offs of notes that did not sound.
    unasked: usize,
}

impl Receiver {
    fn of(messages: &[(f64, Message)]) -> Self {
        let mut it = Self::default();
        for (_, message) in messages {
            it.hear(&message.encode());
        }
        it
    }

    fn hear(&mut self, bytes: &[u8]) {
        match *bytes {
            [0x90, note, _] => _ = self.sounding.insert(note),
            [0x80, note, _] => self.unasked += usize::from(!self.sounding.remove(&note)),
            [0xB0, 120 | 123, _] => self.sounding.clear(),
            [0xB0, number, 0] => _ = self.controllers.remove(&number),
            [0xB0, number, _] => _ = self.controllers.insert(number),
            [0xD0, value] => self.pressure = value,
            _ => {}
        }
    }

    fn is_silent(&self) -> bool {
        self.sounding.is_empty() && self.controllers.is_empty() && self.pressure == 0
    }
}

fn guardian() -> NoteGuardian<MessageRecorder> {
    let mut guardian = NoteGuardian::new(MessageRecorder::default());
    guardian.begin(0.0).unwrap();
    guardian
}

fn heard(guardian: &NoteGuardian<MessageRecorder>) -> Receiver {
    Receiver::of(guardian.output().messages())
}

fn on(number: u8) -> Message {
    Message::NoteOn { note: Note::from_number(number).unwrap(), velocity: Velocity::UNKNOWN }
}

fn off(number: u8) -> Message {
    Message::NoteOff { note: Note::from_number(number).unwrap(), velocity: Velocity::UNKNOWN }
}

fn pedal(pedal: Pedal, value: u8) -> Message {
    Message::ControlChange { controller: pedal.controller(), value }
}

#[test]
fn a_host_that_gives_signs_is_not_interrupted_however_long_it_holds_a_note() {
    let mut guardian = guardian();
    guardian.play(0.0, on(60)).unwrap();
    for beat in 1..1000 {
        let now = f64::from(beat) * 0.4;
        guardian.poll(now).unwrap();
        guardian.hear(now).unwrap();
    }
    assert_eq!(guardian.output().messages().len(), 1);
}

#[test]
fn a_host_that_falls_silent_has_its_notes_ended_once_and_its_pedals_again_when_it_goes_on() {
    let mut guardian = guardian();
    guardian.play(1.0, on(60)).unwrap();
    guardian.play(1.0, pedal(Pedal::Sustain, 127)).unwrap();
    guardian.poll(1.0 + 0.9 * SILENT_AFTER).unwrap();
    assert!(!heard(&guardian).is_silent());
    guardian.poll(1.0 + 1.1 * SILENT_AFTER).unwrap();
    assert!(heard(&guardian).is_silent(), "{:?}", heard(&guardian));
    let ended = guardian.output().messages().len();
    guardian.poll(9.0).unwrap();
    assert_eq!(guardian.output().messages().len(), ended);
    assert_eq!(guardian.n_interruptions(), 1);
    // The pedal is down again, and the note-off changes nothing.
    guardian.play(9.1, off(60)).unwrap();
    guardian.play(9.2, on(64)).unwrap();
    let receiver = heard(&guardian);
    assert_eq!(receiver.sounding, BTreeSet::from([64]));
    assert_eq!((receiver.controllers, receiver.unasked), (BTreeSet::from([64]), 0));
    guardian.play(9.3, pedal(Pedal::Sustain, 0)).unwrap();
    guardian.play(9.4, off(64)).unwrap();
    assert!(heard(&guardian).is_silent());
}

#[test]
fn the_next_host_begins_in_silence() {
    let mut guardian = guardian();
    guardian.play(0.1, on(60)).unwrap();
    guardian.play(0.1, pedal(Pedal::UnaCorda, 127)).unwrap();
    guardian.begin(0.2).unwrap();
    assert!(heard(&guardian).is_silent());
    guardian.hear(0.3).unwrap();
    assert!(heard(&guardian).is_silent(), "pedals of another host are not pressed again");
}

#[test]
fn a_host_that_ends_in_silence_is_not_ended_once_more() {
    let mut guardian = guardian();
    guardian.play(0.1, on(60)).unwrap();
    guardian.play(0.2, off(60)).unwrap();
    guardian.leave(0.3).unwrap();
    assert_eq!(guardian.output().messages().len(), 2);
}

/// Events of a guardian.
#[derive(Clone, Copy, Debug)]
enum Happening {
    Message(Message),
    Beat,
    /// Time passes before a poll.
    Poll,
    Begin,
}

fn happenings() -> impl Strategy<Value = (f64, Happening)> {
    let kind = prop_oneof![6 => 0_u8..5, 1 => 5_u8..8];
    (0.0..0.4_f64, kind, 0_u8..6, 0_u8..=127).prop_map(|(after, kind, key, value)| {
        let note = Note::from_key(key).unwrap();
        let velocity = Velocity::nearest(f64::from(value));
        let controllers = [
            Controller::Sustain,
            Controller::Sostenuto,
            Controller::UnaCorda,
            Controller::AllNotesOff,
        ];
        let happening = match kind {
            0 | 1 => Happening::Message(Message::NoteOn { note, velocity }),
            2 => Happening::Message(Message::NoteOff { note, velocity }),
            3 => Happening::Message(Message::ChannelPressure { value }),
            4 => {
                let controller = controllers[usize::from(key) % controllers.len()];
                Happening::Message(Message::ControlChange { controller, value })
            }
            5 => Happening::Beat,
            6 => Happening::Poll,
            _ => Happening::Begin,
        };
        (after, happening)
    })
}

proptest! {
    #[test]
    fn whatever_happened_nothing_sounds_when_the_host_is_gone_or_says_nothing(
        happenings in proptest::collection::vec(happenings(), 0..60),
        is_gone in any::<bool>(),
    ) {
        let mut guardian = guardian();
        let mut now = 0.0;
        for (after, happening) in happenings {
            now += after;
            match happening {
                Happening::Message(message) => guardian.play(now, message).unwrap(),
                Happening::Beat => guardian.hear(now).unwrap(),
                Happening::Poll => guardian.poll(now).unwrap(),
                Happening::Begin => guardian.begin(now).unwrap(),
            }
        }
        if is_gone {
            guardian.leave(now).unwrap();
        } else {
            guardian.poll(now + 1.0).unwrap();
        }
        let receiver = heard(&guardian);
        prop_assert!(receiver.is_silent(), "{receiver:?}");
        prop_assert_eq!(receiver.unasked, 0);
    }
}
