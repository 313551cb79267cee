//! Opens the output that a scene asks for.

use std::path::Path;

use midi::{Message, MidiPort, MidiSendError, Output, Smf, Unavailable};

use crate::midi_thread::AnyOutput;
use crate::report::MidiReport;
use crate::session::SessionError;
use scene::{Midi, MidiOutput};

/// An output that drops every message.
#[derive(Clone, Copy, Debug)]
struct Nowhere;

impl Output for Nowhere {
    fn send(&mut self, _at: f64, _message: Message) -> Result<(), MidiSendError> {
        Ok(())
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        Ok(())
    }
}

/// Returns an output that sends nothing anywhere.
pub(crate) fn nowhere() -> AnyOutput {
    Box::new(Nowhere)
}

/// Opens the output, and returns it with its part of the report.
///
/// A machine without MIDI is no error: the run goes on, and the report says what to do.
pub(super) fn open(midi: &Midi) -> Result<(AnyOutput, MidiReport), SessionError> {
    if let MidiOutput::File(path) = &midi.output {
        refuse_without_folder(path)?;
    }
    let (output, name): (Result<AnyOutput, Unavailable>, String) = match &midi.output {
        MidiOutput::None => (Ok(Box::new(Nowhere)), "none".into()),
        MidiOutput::Virtual => (boxed(MidiPort::create()), "virtual port \"letoff\"".into()),
        MidiOutput::Port(name) => (boxed(MidiPort::connect(name)), format!("port \"{name}\"")),
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

/// Refuses a file in a folder that is not there, before the run: the file is written at its end.
fn refuse_without_folder(path: &Path) -> Result<(), SessionError> {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            Err(SessionError::NoFolder {
                path: path.display().to_string(),
                folder: folder.display().to_string(),
            })
        }
        Some(_) | None => Ok(()),
    }
}

fn boxed(port: Result<MidiPort, Unavailable>) -> Result<AnyOutput, Unavailable> {
    Ok(Box::new(port?))
}
