use std::sync::mpsc;

use midi::{Message, MidiSendError, Output};
use telemetry::{Midi, Update};

use crate::midi_thread::AnyOutput;
use crate::observe::TelemetryMessage;

pub(crate) struct MonitoredOutput {
    pub(crate) output: AnyOutput,
    pub(crate) sender: mpsc::Sender<TelemetryMessage>,
}

impl Output for MonitoredOutput {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        let sent = self.output.send(at, message);
        let text = match &sent {
            Ok(()) => text_of(message),
            Err(error) => format!("{}, lost: {error}", text_of(message)),
        };
        let midi = Midi { at, bytes: message.encode().to_vec(), text };
        // A telemetry thread that has ended needs no more messages.
        let _gone = self.sender.send(TelemetryMessage::Update(Box::new(Update::Midi(midi))));
        sent
    }

    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        self.output.poll(now)
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        self.output.finish()
    }
}

fn text_of(message: Message) -> String {
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
        Message::KeyPressure { note, value } => {
            format!("pressure of note {} is {value}", note.number())
        }
        Message::ChannelPressure { value } => format!("pressure of the channel is {value}"),
    }
}
