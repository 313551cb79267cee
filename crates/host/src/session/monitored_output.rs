//! An output that also tells whoever observes what went through it.

use std::sync::mpsc;

use midi::{Message, MidiSendError, Output};
use telemetry::{Midi, Update};

use crate::midi_thread::AnyOutput;
use crate::observe::TelemetryMessage;

/// An output, overheard.
pub(crate) struct MonitoredOutput {
    pub(crate) output: AnyOutput,
    pub(crate) told: mpsc::Sender<TelemetryMessage>,
}

impl Output for MonitoredOutput {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        let sent = self.output.send(at, message);
        let text = match &sent {
            Ok(()) => words(message),
            Err(error) => format!("{}, lost: {error}", words(message)),
        };
        let midi = Midi { at, bytes: message.encode().into(), text };
        // Who does not listen any more need not know.
        let _gone = self.told.send(TelemetryMessage::Update(Box::new(Update::Midi(midi))));
        sent
    }

    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        self.output.poll(now)
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        self.output.finish()
    }
}

/// A message as musicians read it.
fn words(message: Message) -> String {
    match message {
        Message::NoteOn { note, velocity } => {
            format!("note-on {} velocity {}", note.number(), velocity.get())
        }
        Message::NoteOff { note, velocity } => {
            format!("note-off {} velocity {}", note.number(), velocity.get())
        }
        Message::ControlChange { controller, value } => {
            format!("controller {} is {value}", controller.number())
        }
    }
}
