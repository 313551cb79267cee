//! The output ports of the system's MIDI.

use midir::{MidiOutput, MidiOutputPort};

use super::Unavailable;

/// The name of this client towards other programs, and that of its virtual ports.
pub(crate) const CLIENT: &str = "letoff";

pub(super) fn open() -> Result<MidiOutput, Unavailable> {
    look_for_sequencer()?;
    MidiOutput::new(CLIENT).map_err(|_init| Unavailable::NotStarted)
}

/// ALSA says on stderr only why it does not start, so its device is looked at first.
#[cfg(target_os = "linux")]
pub(crate) fn look_for_sequencer() -> Result<(), Unavailable> {
    use std::io::ErrorKind;

    let opened = std::fs::OpenOptions::new().read(true).write(true).open("/dev/snd/seq");
    match opened.map_err(|error| error.kind()) {
        Ok(_) => Ok(()),
        Err(ErrorKind::PermissionDenied) => Err(Unavailable::NotAllowed),
        Err(ErrorKind::NotFound) => Err(Unavailable::NoSequencer),
        Err(_) => Err(Unavailable::NotStarted),
    }
}

#[cfg(not(target_os = "linux"))]
pub(crate) fn look_for_sequencer() -> Result<(), Unavailable> {
    Ok(())
}

/// All ports with their names; a port that vanishes meanwhile is left out.
pub(super) fn named(system: &MidiOutput) -> Vec<(String, MidiOutputPort)> {
    let ports = system.ports().into_iter();
    ports.filter_map(|port| Some((system.port_name(&port).ok()?, port))).collect()
}
