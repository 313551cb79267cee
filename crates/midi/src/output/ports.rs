//! The output ports of the system's MIDI, and why there may be none.

use midir::{MidiOutput, MidiOutputPort};

/// The name of this client towards other programs, and that of its virtual ports.
pub(crate) const CLIENT: &str = "letoff";

/// Why there is no connection to a MIDI port.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum Unavailable {
    /// The kernel's sequencer is not loaded.
    #[error(
        "there is no MIDI on this machine, /dev/snd/seq does not exist: load it with \
         `sudo modprobe snd-seq`, or pass /dev/snd into the container"
    )]
    NoSequencer,
    /// The kernel's sequencer may not be opened.
    #[error(
        "MIDI may not be used, /dev/snd/seq cannot be opened: join the group audio with \
         `sudo usermod -aG audio $USER` and log in again"
    )]
    NotAllowed,
    /// The system's MIDI does not start for another reason.
    #[error("the system's MIDI does not start: see what the system logged, and try again")]
    NotStarted,
    /// No port has the wanted name.
    #[error("no MIDI port is called \"{wanted}\": {}", known(.existing))]
    NoSuchPort {
        /// Part of a name that was looked for.
        wanted: String,
        /// The ports that exist.
        existing: Vec<String>,
    },
    /// The port is there and does not let itself be connected.
    #[error("MIDI port \"{port}\" cannot be connected, {reason}: close what else uses it")]
    Refused {
        /// Name of the port.
        port: String,
        /// What the system said.
        reason: String,
    },
    /// The device or FIFO cannot be written to.
    #[error("no MIDI can be written to {path}: {reason}")]
    NoDevice {
        /// Where it should be.
        path: String,
        /// The mistake and the remedy.
        reason: String,
    },
    /// This system has no virtual ports.
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
