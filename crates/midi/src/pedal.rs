//! The pedals of a piano, and how far each is pressed.

use crate::message::{Controller, Message};

/// A pedal of a grand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[must_use]
pub enum Pedal {
    /// The right pedal: lifts all dampers.
    Sustain,
    /// The middle pedal: keeps those dampers up that are up when it is pressed.
    Sostenuto,
    /// The left pedal: the hammers strike fewer strings, or softer.
    UnaCorda,
}

impl Pedal {
    /// Every pedal, the right one first.
    pub const ALL: [Self; 3] = [Self::Sustain, Self::Sostenuto, Self::UnaCorda];

    /// Returns the controller that says where this pedal is.
    pub const fn controller(self) -> Controller {
        match self {
            Self::Sustain => Controller::Sustain,
            Self::Sostenuto => Controller::Sostenuto,
            Self::UnaCorda => Controller::UnaCorda,
        }
    }

    /// Returns the pedal that the controller with this MIDI number moves, if there is one.
    pub fn of_number(number: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|pedal| pedal.controller().number() == number)
    }
}

/// A pedal comes to another depth.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PedalMove {
    /// Which of the three pedals.
    pub pedal: Pedal,
    /// When it is there (s).
    pub at: f64,
    /// How deep, from 0 (up) to 1 (down).
    pub depth: f64,
}

/// Where the three pedals are, as values of their controllers.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct PedalValues([u8; Pedal::ALL.len()]);

impl PedalValues {
    /// Sets where `pedal` is, 0 to 127; returns whether it was elsewhere.
    pub(crate) fn set(&mut self, pedal: Pedal, value: u8) -> bool {
        std::mem::replace(&mut self.0[pedal as usize], value) != value
    }

    /// Returns the messages that lift the pedals that are down.
    pub(crate) fn lifted(self) -> impl Iterator<Item = Message> {
        let down = Pedal::ALL.into_iter().zip(self.0).filter(|(_, value)| 0 < *value);
        down.map(|(pedal, _)| Message::ControlChange { controller: pedal.controller(), value: 0 })
    }

    /// Returns where each pedal is, 0 to 127.
    pub(crate) fn all(&self) -> impl Iterator<Item = (Pedal, u8)> {
        Pedal::ALL.into_iter().zip(self.0)
    }
}
