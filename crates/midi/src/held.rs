//! State of a receiver, as far as it follows from the sent messages.

use keyboard::{KEYS, KeyIndex};

use crate::message::{Controller, Message};
use crate::note::{Note, Velocity};
use crate::pedal::{Pedal, PedalValues};

/// Sounding notes, pressed pedals, and the pressure of the channel.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HeldNotes {
    sounding: [bool; KEYS],
    pedals: PedalValues,
    /// Pressure of the channel, 0 to 127.
    pressure: u8,
}

impl Default for HeldNotes {
    fn default() -> Self {
        Self { sounding: [false; KEYS], pedals: PedalValues::default(), pressure: 0 }
    }
}

impl HeldNotes {
    /// Follows `message`; `true` if it changes anything, unlike a note-off of a silent note.
    pub fn follow(&mut self, message: Message) -> bool {
        match message {
            Message::NoteOn { note, .. } => self.sounding[usize::from(note.key())] = true,
            Message::NoteOff { note, .. } => {
                return std::mem::take(&mut self.sounding[usize::from(note.key())]);
            }
            Message::ChannelPressure { value } => self.pressure = value,
            Message::KeyPressure { .. } => {}
            Message::ControlChange {
                controller: Controller::AllNotesOff | Controller::AllSoundOff,
                ..
            } => self.sounding = [false; KEYS],
            Message::ControlChange { controller, value } => {
                if let Some(pedal) = Pedal::of_number(controller.number()) {
                    self.pedals.set(pedal, value);
                }
            }
        }
        true
    }

    /// Returns `true` if nothing sounds and all pedals are up.
    pub fn is_silent(&self) -> bool {
        *self == Self::default()
    }

    /// Returns the messages that end what is held, and forgets it: note-offs, pressure, pedals up.
    pub fn release(&mut self) -> Vec<Message> {
        let Self { sounding, pressure, pedals } = std::mem::take(self);
        let keys = KeyIndex::all().map(KeyIndex::number);
        let notes = keys.filter(|key| sounding[usize::from(*key)]).filter_map(Note::from_key);
        let offs = notes.map(|note| Message::NoteOff { note, velocity: Velocity::UNKNOWN });
        let pressure = (0 < pressure).then_some(Message::ChannelPressure { value: 0 });
        let pedals = pedals.lifted();
        offs.chain(pressure).chain(pedals).collect()
    }

    pub(crate) fn add(&mut self, other: &Self) {
        let both = self.to_bytes().into_iter().zip(other.to_bytes());
        *self = Self::of(both.map(|(own, other)| own.max(other)));
    }

    pub(crate) fn remove(&mut self, other: &Self) {
        let both = self.to_bytes().into_iter().zip(other.to_bytes());
        *self = Self::of(both.map(|(own, other)| if 0 < other { 0 } else { own }));
    }

    /// Returns a byte for each note, each pedal and the pressure.
    pub(crate) fn to_bytes(&self) -> [u8; Self::LEN] {
        let notes = self.sounding.iter().map(|sounds| u8::from(*sounds));
        let mut all = notes.chain(self.pedals.all().map(|(_, value)| value)).chain([self.pressure]);
        std::array::from_fn(|_index| all.next().unwrap_or_default())
    }

    /// Decodes [`Self::to_bytes`]; returns `None` if bytes are missing.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let bytes: [u8; Self::LEN] = bytes.get(..Self::LEN)?.try_into().ok()?;
        Some(Self::of(bytes.into_iter()))
    }

    pub(crate) const LEN: usize = KEYS + Pedal::ALL.len() + 1;

    fn of(mut bytes: impl Iterator<Item = u8>) -> Self {
        let mut next = || bytes.next().unwrap_or_default();
        let sounding = std::array::from_fn(|_key| next() != 0);
        let mut pedals = PedalValues::default();
        for pedal in Pedal::ALL {
            pedals.set(pedal, next().min(127));
        }
        Self { sounding, pedals, pressure: next().min(127) }
    }

    /// Returns the messages that set the pedals of a silent receiver to this state.
    pub fn pedals(&self) -> Vec<Message> {
        let pressed = self.pedals.all().filter(|(_, value)| 0 < *value);
        let message = |(pedal, value): (Pedal, u8)| Message::ControlChange {
            controller: pedal.controller(),
            value,
        };
        pressed.map(message).collect()
    }
}
