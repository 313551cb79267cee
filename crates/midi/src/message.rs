//! Messages as bytes: two for channel pressure, else three; the status is always sent.
//!
//! ```text
//! 8n kk vv   note-off, release velocity vv (1 ..= 127)
//! 9n kk vv   note-on, velocity vv (1 ..= 127)
//! Bn cc vv   controller cc is vv (0 ..= 127)
//! An kk vv   pressure vv (0 ..= 127) on the key of note kk
//! Dn vv      pressure vv (0 ..= 127) of the channel
//! ```
//! `n` is the channel: 0 when sent, any when received.

use crate::note::{Note, Velocity};

/// Largest length of a message (bytes).
pub const LEN: usize = 3;

const NOTE_OFF: u8 = 0x80;
const NOTE_ON: u8 = 0x90;
const CONTROL_CHANGE: u8 = 0xB0;
const KEY_PRESSURE: u8 = 0xA0;
const CHANNEL_PRESSURE: u8 = 0xD0;

/// Message to a synthesizer.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[must_use]
pub enum Message {
    NoteOn {
        note: Note,
        /// Speed of the strike.
        velocity: Velocity,
    },
    NoteOff {
        note: Note,
        /// Speed of the release.
        velocity: Velocity,
    },
    ControlChange {
        controller: Controller,
        /// Value, 0 ..= 127.
        value: u8,
    },
    /// New force on the held key of a sounding note.
    KeyPressure { note: Note, value: u8 },
    /// New force on held keys.
    ChannelPressure { value: u8 },
}

/// Bytes of a message, at most [`LEN`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EncodedMessage {
    bytes: [u8; LEN],
    length: usize,
}

impl core::ops::Deref for EncodedMessage {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        self.bytes.split_at(self.length).0
    }
}

/// Controllers that are sent.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[must_use]
pub enum Controller {
    /// CC64, the sustain pedal: 0 is up, 127 is down.
    Sustain,
    /// CC66, the sostenuto pedal, with the same values.
    Sostenuto,
    /// CC67, the una corda pedal, with the same values.
    UnaCorda,
    /// CC120, silence at once.
    AllSoundOff,
    AllNotesOff,
}

impl Controller {
    const ALL: [Self; 5] =
        [Self::Sustain, Self::Sostenuto, Self::UnaCorda, Self::AllSoundOff, Self::AllNotesOff];

    pub const fn number(self) -> u8 {
        match self {
            Self::Sustain => 64,
            Self::Sostenuto => 66,
            Self::UnaCorda => 67,
            Self::AllSoundOff => 120,
            Self::AllNotesOff => 123,
        }
    }
}

/// Reason why bytes are not a supported message.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum MidiDecodeError {
    #[error("a message has 3 bytes, or 2 of a channel's pressure, not {got}")]
    Length { got: usize },
    #[error("status {0:#04x} is not a note, a pressure or a controller")]
    Status(u8),
    #[error("data byte {0:#04x} is above 127")]
    Data(u8),
    #[error("note {0} is not one of 21 to 108")]
    NoSuchNote(u8),
    #[error("controller {0} is not 64, 66, 67, 120 or 123")]
    NoSuchController(u8),
}

impl Message {
    /// Encodes this message on the first channel.
    pub const fn encode(self) -> EncodedMessage {
        let bytes = match self {
            Self::NoteOn { note, velocity } => [NOTE_ON, note.number(), velocity.get()],
            Self::NoteOff { note, velocity } => [NOTE_OFF, note.number(), velocity.get()],
            Self::ControlChange { controller, value } => {
                [CONTROL_CHANGE, controller.number(), value & 0x7F]
            }
            Self::KeyPressure { note, value } => [KEY_PRESSURE, note.number(), value & 0x7F],
            Self::ChannelPressure { value } => [CHANNEL_PRESSURE, value & 0x7F, 0],
        };
        let length = if let Self::ChannelPressure { .. } = self { LEN - 1 } else { LEN };
        EncodedMessage { bytes, length }
    }

    /// Decodes a message of any channel; never panics on any bytes.
    ///
    /// A note-on with velocity 0 is a note-off of unknown velocity, as MIDI prescribes.
    ///
    /// # Errors
    /// The bytes are not exactly one supported message.
    pub fn decode(bytes: &[u8]) -> Result<Self, MidiDecodeError> {
        let (status, first, second) = match *bytes {
            [status, value] if status & 0xF0 == CHANNEL_PRESSURE => (status, value, 0),
            [status, first, second] => (status, first, second),
            _ => return Err(MidiDecodeError::Length { got: bytes.len() }),
        };
        if let Some(high) = [first, second].into_iter().find(|byte| *byte > 0x7F) {
            return Err(MidiDecodeError::Data(high));
        }
        match status & 0xF0 {
            NOTE_ON => Ok(note_on(decode_note(first)?, second)),
            NOTE_OFF => Ok(Self::NoteOff {
                note: decode_note(first)?,
                velocity: Velocity::nearest(f64::from(second)),
            }),
            CONTROL_CHANGE => {
                Ok(Self::ControlChange { controller: decode_controller(first)?, value: second })
            }
            KEY_PRESSURE => Ok(Self::KeyPressure { note: decode_note(first)?, value: second }),
            CHANNEL_PRESSURE if bytes.len() < LEN => Ok(Self::ChannelPressure { value: first }),
            _ => Err(MidiDecodeError::Status(status)),
        }
    }
}

fn note_on(note: Note, velocity: u8) -> Message {
    Velocity::new(velocity)
        .map_or(Message::NoteOff { note, velocity: Velocity::UNKNOWN }, |velocity| {
            Message::NoteOn { note, velocity }
        })
}

fn decode_note(number: u8) -> Result<Note, MidiDecodeError> {
    Note::from_number(number).ok_or(MidiDecodeError::NoSuchNote(number))
}

fn decode_controller(number: u8) -> Result<Controller, MidiDecodeError> {
    let found = Controller::ALL.into_iter().find(|controller| controller.number() == number);
    found.ok_or(MidiDecodeError::NoSuchController(number))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn messages() -> impl Strategy<Value = Message> {
        (0_u8..6, 0_u8..88, 1_u8..=127, 0_usize..5).prop_map(|(kind, key, value, which)| {
            let note = Note::from_key(key).unwrap();
            let velocity = Velocity::new(value).unwrap();
            match kind {
                0 => Message::NoteOn { note, velocity },
                1 => Message::NoteOff { note, velocity },
                2 => Message::KeyPressure { note, value },
                3 => Message::ChannelPressure { value },
                _ => Message::ControlChange { controller: Controller::ALL[which], value },
            }
        })
    }

    #[test]
    fn a_note_off_is_a_real_one() {
        let note = Note::from_number(60).unwrap();
        let message = Message::NoteOff { note, velocity: Velocity::UNKNOWN };
        assert_eq!(*message.encode(), [0x80, 60, 64]);
        assert_eq!(*Message::ChannelPressure { value: 5 }.encode(), [0xD0, 5]);
    }

    #[test]
    fn a_foreign_note_on_of_velocity_zero_is_a_note_off() {
        let note = Note::from_number(60).unwrap();
        let off = Message::NoteOff { note, velocity: Velocity::UNKNOWN };
        assert_eq!(Message::decode(&[0x95, 60, 0]), Ok(off));
    }

    #[test]
    fn foreign_bytes_are_refused_with_the_reason() {
        let refused = |bytes: &[u8]| Message::decode(bytes).unwrap_err();
        assert_eq!(refused(&[0x90, 60]), MidiDecodeError::Length { got: 2 });
        assert_eq!(refused(&[0xF8, 0, 0]), MidiDecodeError::Status(0xF8));
        assert_eq!(refused(&[0x90, 60, 0xFF]), MidiDecodeError::Data(0xFF));
        assert_eq!(refused(&[0x90, 109, 1]), MidiDecodeError::NoSuchNote(109));
        assert_eq!(refused(&[0xB0, 1, 1]), MidiDecodeError::NoSuchController(1));
    }

    proptest! {
        #[test]
        fn a_message_survives_its_bytes(message in messages()) {
            prop_assert_eq!(Message::decode(&message.encode()), Ok(message));
        }

        #[test]
        fn no_bytes_make_it_panic(bytes in proptest::collection::vec(any::<u8>(), 0..6)) {
            if let Ok(message) = Message::decode(&bytes) {
                prop_assert_eq!(Message::decode(&message.encode()), Ok(message));
            }
        }
    }
}
