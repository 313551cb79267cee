//! Opens the output that a scene asks for.

use midi::{Message, Output, Port, SendError, Smf, Unavailable};

use crate::config::{Midi, MidiOutput};
use crate::desk::AnyOutput;
use crate::report::MidiReport;
use crate::session::SessionError;

/// Sends nothing anywhere.
#[derive(Clone, Copy, Debug)]
struct Nowhere;

impl Output for Nowhere {
    fn send(&mut self, _at: f64, _message: Message) -> Result<(), SendError> {
        Ok(())
    }

    fn finish(&mut self) -> Result<(), SendError> {
        Ok(())
    }
}

/// The output, and what a report says of it.
///
/// A machine without MIDI is no error: the run goes on, and the report says what to do.
pub(super) fn open(midi: &Midi) -> Result<(AnyOutput, MidiReport), SessionError> {
    let (output, name): (Result<AnyOutput, Unavailable>, String) = match &midi.output {
        MidiOutput::None => (Ok(Box::new(Nowhere)), "none".into()),
        MidiOutput::Virtual => (boxed(Port::create()), "virtual port \"letoff\"".into()),
        MidiOutput::Port(name) => (boxed(Port::connect(name)), format!("port \"{name}\"")),
        MidiOutput::File(path) => (Ok(Box::new(Smf::new(path))), path.display().to_string()),
    };
    let report = |trouble| MidiReport { output: name, trouble, ..MidiReport::default() };
    match output {
        Ok(output) => Ok((output, report(None))),
        Err(
            missing @ (Unavailable::NoSequencer
            | Unavailable::NotAllowed
            | Unavailable::NotStarted
            | Unavailable::NoVirtualPorts),
        ) => Ok((Box::new(Nowhere), report(Some(missing.to_string())))),
        Err(refused @ (Unavailable::NoSuchPort { .. } | Unavailable::Refused { .. })) => {
            Err(refused.into())
        }
    }
}

fn boxed(port: Result<Port, Unavailable>) -> Result<AnyOutput, Unavailable> {
    Ok(Box::new(port?))
}
