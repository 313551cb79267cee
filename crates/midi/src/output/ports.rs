//! Output ports of the system's MIDI.

use midir::{MidiOutput, MidiOutputPort};

/// Name of this client for other programs, and of its virtual ports.
pub(crate) const CLIENT: &str = "letoff";

/// Reason why there is no connection to a MIDI port.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum Unavailable {
    #[error(
        "there is no MIDI on this machine, /dev/snd/seq does not exist: load it with \
         `sudo modprobe snd-seq`, or pass /dev/snd into the container"
    )]
    NoSequencer,
    #[error(
        "MIDI may not be used, /dev/snd/seq cannot be opened: join the group audio with \
         `sudo usermod -aG audio $USER` and log in again"
    )]
    NotAllowed,
    #[error("the system's MIDI does not start: see what the system logged, and try again")]
    NotStarted,
    #[error("no MIDI port is called \"{wanted}\": {}", known(.existing))]
    NoSuchPort {
        /// Fragment of a name to match.
        wanted: String,
        existing: Vec<String>,
    },
    #[error("MIDI port \"{port}\" cannot be connected, {reason}: close what else uses it")]
    Refused {
        port: String,
        /// Message of the system.
        reason: String,
    },
    #[error("no MIDI can be written to {path}: {reason}")]
    NoDevice {
        path: String,
        /// The mistake and the remedy.
        reason: String,
    },
    #[error(
        "this system cannot make a MIDI port of our own: install a loopback port \
         and connect to it by its name"
    )]
    NoVirtualPorts,
}

fn known(existing: &[String]) -> String {
    if existing.is_empty() {
        "there is none, start the synthesizer first".to_owned()
    } else {
        format!("choose one of \"{}\"", existing.join("\", \""))
    }
}

pub(super) fn open() -> Result<MidiOutput, Unavailable> {
    look_for_sequencer()?;
    MidiOutput::new(CLIENT).map_err(|_init| Unavailable::NotStarted)
}

/// Checks ALSA's device first, because ALSA reports only on stderr why it does not start.
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

/// Returns all ports with their names; a port that vanishes meanwhile is left out.
pub(super) fn named(system: &MidiOutput) -> Vec<(String, MidiOutputPort)> {
    let ports = system.ports().into_iter();
    ports.filter_map(|port| Some((system.port_name(&port).ok()?, port))).collect()
}
