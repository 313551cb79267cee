//! Pedals of a piano, and their depths.

use crate::message::{Controller, Message};

/// A pedal of a grand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[must_use]
pub enum Pedal {
    /// Right pedal: lifts all dampers.
    Sustain,
    /// Middle pedal: keeps those dampers up that are up when it is pressed.
    Sostenuto,
    /// Left pedal: the hammers strike fewer strings, or softer.
    UnaCorda,
}

impl Pedal {
    /// Every pedal, the right one first.
    pub const ALL: [Self; 3] = [Self::Sustain, Self::Sostenuto, Self::UnaCorda];

    pub const fn controller(self) -> Controller {
        match self {
            Self::Sustain => Controller::Sustain,
            Self::Sostenuto => Controller::Sostenuto,
            Self::UnaCorda => Controller::UnaCorda,
        }
    }

    /// Returns the pedal that the controller with this MIDI number moves, if any.
    pub fn of_number(number: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|pedal| pedal.controller().number() == number)
    }
}

/// Arrival of a pedal at a depth from 0 (up) to 1 (down), at a time (s).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PedalMove {
    pub pedal: Pedal,
    pub at: f64,
    pub depth: f64,
}

/// Depths of the three pedals, as values of their controllers.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct PedalValues([u8; Pedal::ALL.len()]);

impl PedalValues {
    /// Sets `pedal` to `value`, 0 to 127; returns `true` if it had another.
    pub(crate) fn set(&mut self, pedal: Pedal, value: u8) -> bool {
        std::mem::replace(&mut self.0[pedal as usize], value) != value
    }

    /// Returns the messages that lift the pressed pedals.
    pub(crate) fn lifted(self) -> impl Iterator<Item = Message> {
        let down = Pedal::ALL.into_iter().zip(self.0).filter(|(_, value)| 0 < *value);
        down.map(|(pedal, _)| Message::ControlChange { controller: pedal.controller(), value: 0 })
    }

    /// Returns the value of each pedal, 0 to 127.
    pub(crate) fn all(&self) -> impl Iterator<Item = (Pedal, u8)> {
        Pedal::ALL.into_iter().zip(self.0)
    }
}
